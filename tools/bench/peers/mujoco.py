"""Times open chains in MuJoCo: joint coordinates and its composite-body algorithm.

Closed chains have no row: MuJoCo's constraints are soft, so the same model cannot be built.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from bench import chains
from bench.timing import Work

LARGEST = {"scaling_chain": 500}  # with 1000 rods rounding errors reach 2e-5


def chain(n: int) -> Any:
    """Build the open chain of `chains.chain`, without contacts and other constraints."""
    import mujoco

    spec = mujoco.MjSpec()
    spec.option.gravity = (0, 0, -chains.GRAVITY)
    off = mujoco.mjtDisableBit
    spec.option.disableflags = int(off.mjDSBL_CONTACT) | int(off.mjDSBL_CONSTRAINT)
    body, inertia = spec.worldbody, {"mass": chains.MASS, "inertia": chains.INERTIA, "explicitinertial": True}
    for i in range(n):
        place, centre = (0.0 if i == 0 else chains.LENGTH, 0, 0), (chains.LENGTH / 2, 0, 0)
        body = body.add_body(pos=place, ipos=centre, **inertia)
        body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=(0, 1, 0))
    return spec.compile()


def right_hand_side(n: int) -> Work:
    """Time accelerations of the joints at the states of `chains.right_hand_side`, without its sensors."""
    import mujoco

    model = chain(n)
    data, state = mujoco.MjData(model), chains.moving(n)
    states = [(state.angles + step, state.rates + step) for step in (0.0, 1e-6)]

    def run() -> list[Any]:
        rates = []
        for q, v in states:
            data.qpos[:], data.qvel[:] = q, v
            mujoco.mj_forwardSkip(model, data, mujoco.mjtStage.mjSTAGE_NONE, 1)
            rates.append(data.qacc.copy())
        return rates

    return Work(run, lambda rates: state.error(rates[0]), count=2)


ROWS: dict[str, Callable[..., Work]] = {
    "chain_40": partial(right_hand_side, 40),
    "chain_100": partial(right_hand_side, 100),
    "scaling_chain": right_hand_side,
}
