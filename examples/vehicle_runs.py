"""Analyses of the road vehicle: equilibrium, linearization, steering, bumps, and the energy balance.

What is read off the motions is in `flexel.examples.vehicle_signals`.
"""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import vehicle_data as data
from flexel.examples.differences import state_matrix
from flexel.examples.vehicle import BODY, SUSPENSION, vehicle
from flexel.integration.step_method import natural_scales_of_y
from flexel.mechanics.modes import sort_eigenvalues
from flexel.results.linearization import Linearization
from flexel.system import CoreSystem

SPEEDS = (10, 20, 30)  # of the steering manoeuvres [m/s]
BUMP_SPEEDS = (5, 10)
LOCI = tuple(float(v) for v in np.linspace(5, 40, 36))
RTOL, BUMP_RTOL = 1e-5, 1e-6  # a tyre that leaves the road and lands needs more than a manoeuvre
HEAVE = ("chassis.z", "pitch.angle", "roll.angle", *SUSPENSION)


def rounded_ramp() -> tuple[Callable[[float], float], Callable[[float], float], Callable[[float], float]]:
    """Return the rack of the ramp-to-step manoeuvre, (u, u', u''), its two corners rounded."""
    return partial(_rack, 0), partial(_rack, 1), partial(_rack, 2)


def _rack(order: int, t: float) -> float:
    """Return the derivative of that order of the rack's displacement."""
    return float(data.RAMP_RATE * (_corner(t)[order] - _corner(t - data.RAMP_SECONDS)[order]))


def _corner(t: float) -> tuple[float, float, float]:
    """Return the integral of a smooth step of height one and of the duration of a rounding, with its derivatives."""
    T = data.ROUNDED
    fraction = min(max(t / T, 0.0), 1.0)
    return (
        T * (fraction**3 - fraction**4 / 2) + max(t - T, 0.0),
        3 * fraction**2 - 2 * fraction**3,
        6 * fraction * (1 - fraction) / T,
    )


# -- states ---------------------------------------------------------------------------------------


def unknowns(system: fx.System) -> tuple[str, ...]:
    """Return the degrees of freedom that a steady straight motion determines."""
    return tuple(name for name in HEAVE if name in system.dynamic)


def rates(system: fx.System, speed: float) -> dict[str, float]:
    """Return the rates of the degrees of freedom in straight running."""
    return {name: speed if name == "chassis.x" else 0.0 for name in system.dynamic}


def at_rest(system: fx.System) -> fx.State:
    """Find the static equilibrium: heave, pitch, roll and suspension."""
    return system.steady(unknown=unknowns(system))


def straight(speed: float, tyres: str = "calspan") -> tuple[fx.System, fx.State]:
    """Find the straight running at a steady speed [m/s], with the thrust that toe and camber ask for."""
    driven = vehicle(speed, tyres=tyres, driven=True)
    towed = at_rest(driven)
    system = vehicle(speed, tyres=tyres, thrust=towed.force("chassis.x"))
    found = system.state_at({name: towed[name] for name in HEAVE}, rates(system, speed))
    return system, system.steady(found, unknown=unknowns(system))


def start(system: fx.System, speed: float, deflection: str = "deflection") -> fx.State:
    """Return static equilibrium with a forward speed [m/s]: where the benchmark's manoeuvres begin."""
    rest = at_rest(vehicle(deflection=deflection))
    return system.state_at({name: rest[name] for name in HEAVE}, rates(system, speed))


# -- linear equations -----------------------------------------------------------------------------


def moving(lin: Linearization) -> Array:
    """Return the eigenvalues without the four smallest: place and heading on the road, and the speed."""
    w = np.asarray(lin.eigenvalues())
    return np.asarray(sort_eigenvalues(w[np.argsort(np.abs(w))[4:]]))


def mode_name(mode: fx.Mode) -> str:
    """Name the moving parts of a mode: wheels hopping in one of four patterns, or a degree of freedom of the body."""
    share = sum(mode.participation.get(name, 0.0) for name in SUSPENSION)
    if share > 0.5:
        arms = np.array([mode.shape[name] for name in SUSPENSION])
        patterns = {
            "hop bounce": (1, 1, 1, 1),
            "hop pitch": (1, 1, -1, -1),
            "hop roll": (1, -1, 1, -1),
            "hop warp": (1, -1, -1, 1),
        }
        return max(patterns, key=lambda pattern: abs(np.dot(patterns[pattern], arms)))
    names = dict(zip(BODY, ("surge", "sway", "bounce", "yaw", "pitch", "roll"), strict=True))
    return names[
        max((name for name in BODY if name in mode.participation), key=lambda name: mode.participation[name])
    ]


def linear(speed: float, tyres: str = "calspan") -> tuple[fx.System, Linearization]:
    """Linearize the vehicle running straight at a speed."""
    system, state = straight(speed, tyres)
    return system, system.linearize(state)


# -- manoeuvres -----------------------------------------------------------------------------------


def ride(system: fx.System, begin: fx.State, seconds: float, rtol: float = RTOL, **grid: Any) -> fx.Motion:
    """Simulate with the same tolerance for metres and radians; `grid` are the samples or times to store."""
    return system.simulate(
        seconds,
        start=begin,
        method="DOP853",
        rechoose=False,
        rtol=rtol,
        atol=rtol / 100 / natural_scales_of_y(system.kinematics),
        **grid,
    )


def steer(
    speed: float,
    tyres: str = "calspan",
    seconds: float = 5.0,
    rtol: float = RTOL,
    deflection: str = "deflection",
) -> fx.Motion:
    """Simulate ramp-to-step steering to 2 mm of the rack."""
    system = vehicle(speed, tyres=tyres, rack=rounded_ramp(), deflection=deflection)
    return ride(system, start(system, speed, deflection), seconds, rtol, samples=126)


def sine_steer(millimetres: float, speed: float = 20.0, seconds: float = 3.0) -> fx.Motion:
    """Simulate sine steering at 1 Hz."""
    system = vehicle(speed, rack=fx.Harmonic(millimetres / 1000, 2 * np.pi))
    return ride(system, start(system, speed), seconds, samples=151)


def bump(
    speed: float,
    antiphase: bool = False,
    seconds: float = 2.5,
    times: Array | None = None,
    rtol: float = BUMP_RTOL,
    deflection: str = "deflection",
) -> fx.Motion:
    """Simulate the drive over the cosine bump, or with its mirror image, a hollow, under the right wheels."""
    roads = {
        corner: fx.Waves(data.BUMP_HEIGHT * (-1 if antiphase and "right" in corner else 1), *data.BUMP)
        for corner in data.CORNERS
    }
    system = vehicle(speed, roads=roads, deflection=deflection)
    grid = np.linspace(0, seconds, round(100 * seconds) + 1) if times is None else times
    begin = start(system, speed, deflection)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", fx.RangeWarning)  # the table names the tyres that leave their data
        return ride(system, begin, seconds, rtol, times=grid)


def energy_gap(run: Callable[[Array], fx.Motion], seconds: float, panels: int) -> float:
    """Return the energy that is unaccounted for at the end of a motion, relative to what was dissipated and driven.

    What the laws dissipate and what drives wheels and rack is integrated by Gauss's rule with five points in each of
    the panels.
    """
    points, w = np.polynomial.legendre.leggauss(5)
    width = seconds / panels
    nodes = (np.arange(panels)[:, None] + (points + 1) / 2) * width
    motion = run(np.concatenate([[0.0], nodes.ravel(), [seconds]]))
    inner = [state for state in motion if 0 < state.t < seconds]
    driven = [
        name for name in motion.system.structure.names if name.endswith((" spin.angle", " rack.across1"))
    ]
    power = np.array(
        [[state.dissipated, sum(-state.force(name) * state.rate(name) for name in driven)] for state in inner]
    )
    lost, given = np.tile(w, panels) * width / 2 @ power
    gained = motion[-1].energy.total - motion[0].energy.total
    return float(abs(gained + lost - given) / (abs(lost) + abs(given)))


# -- everything -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class VehicleResults:
    """All computed results, for the table and for the figures."""

    nominal: fx.State
    equilibrium: fx.State
    in_plane: fx.State  # equilibrium with the tyres' springs in the planes of the wheels
    linear: Linearization
    differentiated: Array
    no_side_force: Linearization
    straight: list[Linearization]  # at the speeds of `LOCI`
    steering: dict[tuple[int, str], fx.Motion]
    dropped: fx.State  # the end of the fastest, with the tyres' loads straight below the wheels' centres
    sines: dict[int, fx.Motion]
    bumps: dict[tuple[int, bool], fx.Motion]
    energy: float
    energy_lift_off: float
    seconds: dict[str, float] = field(default_factory=dict)

    @property
    def system(self) -> CoreSystem:
        """The vehicle at rest."""
        return self.steering[30, "calspan"].system


def analyse() -> VehicleResults:
    """Run all analyses."""
    still = vehicle(deflection="drop")
    system, lin = linear(20.0)
    began = time.process_time()
    system.linearize(lin.state)
    seconds = {"linearization": time.process_time() - began}
    steering = {}
    for v in SPEEDS:
        for tyres in ("calspan", "zero slip"):
            began = time.process_time()
            steering[v, tyres] = steer(float(v), tyres)
            seconds[f"ramp_{v}_{tyres.replace(' ', '_')}"] = time.process_time() - began
    return VehicleResults(
        nominal=still.at_rest,
        equilibrium=at_rest(still),
        in_plane=at_rest(vehicle()),
        linear=lin,
        differentiated=state_matrix(system, lin.state),
        no_side_force=linear(20.0, "vertical")[1],
        straight=[linear(v)[1] for v in LOCI],
        steering=steering,
        dropped=steer(30.0, deflection="drop")[-1],
        sines={mm: sine_steer(mm) for mm in data.SINE_STEER},
        bumps={(v, mirrored): bump(float(v), mirrored) for v in BUMP_SPEEDS for mirrored in (False, True)},
        energy=energy_gap(lambda times: bump(5.0, seconds=0.5, times=times, rtol=1e-8), 0.5, 30),
        energy_lift_off=energy_gap(lambda times: bump(10.0, seconds=0.75, times=times, rtol=1e-9), 0.75, 240),
        seconds=seconds,
    )
