"""The bicycle balanced by steering, as an environment of Gymnasium and with a regulator.

Below 4.29 m/s the uncontrolled bicycle falls over.  `BicycleEnv` is the environment for learning algorithms: the
action is the steering torque, the observation lean, steer and their rates.  `regulator` computes a controller from the
linearization, and `ride` lets any policy ride.  Gymnasium is optional (pip install 'flexel[learn]').
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
from scipy.linalg import solve_continuous_are

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.bicycle import bicycle, rolling

SPEED = 2.5  # m/s
DT = 0.02  # s
TORQUE = 20.0  # steering torque of an action of one [N m]
FALLEN = 0.5  # lean [rad] at which an episode ends
SECONDS = 10.0  # length of an episode
OUTPUTS = ("lean.angle", "steer.angle", "lean.angle'", "steer.angle'")
Policy = Callable[[Array], Array]


class BicycleEnv(gymnasium.Env[Array, Array]):
    """Steer so that the bicycle stays upright.

    Action: steering torque over `TORQUE`, from -1 to 1.  Observation: `OUTPUTS` [rad, rad/s].  Reward: one for each
    step, less a tenth of the square of the action.  An episode begins with a random roll rate, and ends when the
    bicycle has fallen, or after `SECONDS`.
    """

    def __init__(self, speed: float = SPEED) -> None:
        limit = np.array([np.pi, np.pi, 100.0, 100.0])
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (1,), dtype=np.float64)
        self.observation_space = gymnasium.spaces.Box(-limit, limit, dtype=np.float64)
        self.speed = speed
        self.system = bicycle()
        self.stepper = self.system.stepper(DT, inputs=["steer.angle"], outputs=OUTPUTS)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Start upright, with a roll rate of up to 0.2 rad/s, or ``options={"roll_rate": …}``."""
        super().reset(seed=seed)
        rate = (options or {}).get("roll_rate", float(self.np_random.uniform(-0.2, 0.2)))
        return self.stepper.reset(rolling(self.system, self.speed, rate)), {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Hold a torque for one step."""
        share = float(np.clip(action, -1.0, 1.0)[0])
        observed = self.stepper.step([share * TORQUE])
        fallen = bool(abs(observed[0]) > FALLEN)
        ended = self.stepper.t >= SECONDS - DT / 2
        return observed, 1.0 - 0.1 * share**2, fallen, ended, {}


def regulator(system: fx.System, speed: float = SPEED) -> Policy:
    """Return the the linear-quadratic regulator of lean and steer at a speed, from the analytic linearization."""
    lin = system.linearize(rolling(system, speed, 0.0))
    own = [lin.states.index(name) for name in OUTPUTS]
    A, B, _, _ = lin.state_space(["steer.angle"], [])
    A, B = A[np.ix_(own, own)], B[own]
    gain = B.T @ solve_continuous_are(A, B, np.diag([100.0, 1.0, 1.0, 0.1]), np.eye(1))
    return lambda observed: -gain @ observed / TORQUE


def ride(env: BicycleEnv, policy: Policy, roll_rate: float = 0.2) -> Array:
    """Return the observations (nt, 4) of one episode with a policy."""
    observed, _ = env.reset(options={"roll_rate": roll_rate})
    rows, done = [observed], False
    while not done:
        observed, _, fallen, ended, _ = env.step(policy(observed))
        rows.append(observed)
        done = fallen or ended
    return np.array(rows)
