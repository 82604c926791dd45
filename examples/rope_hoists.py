"""Ropes that lift: a drum that winds up a load, a tackle with friction; a rope that slides off an edge."""

from __future__ import annotations

from functools import cache

import numpy as np

from flexel.base.arrays import Array
from flexel.examples import rope_exact as exact
from flexel.examples import rope_models as models
from flexel.examples.rope_table import over_meshes
from flexel.parts.cable_results import cable_tension
from flexel.results.reproduction import Quantity

MESHES = (20, 40)  # elements of the metre of rope next to the drum
SPEED = 2.5  # of the drum in the end [rad/s]
LIFT = 0.2 * SPEED * 1.5  # of the hoist in 3 s [m]
ARM = 0.005  # coefficient of friction times radius of the journals of the tackle [m]
TACKLE = (48, 96)  # elements of the tackle's rope
ADVANTAGE = "eta (1 - eta^n)/(1 - eta), eta = 1 and 0.905"
TAKEN = "one degree of freedom; the drum takes up "


# -- winding hoist --------------------------------------------------------------------------------


@cache
def wound_up(n: int) -> tuple[Array, Array, Array]:
    """Simulate the hoist: times, depth of the load [m] and tension at the load over its weight, 3 s, every 0.05 s."""
    system, _ = models.winding_hoist(n, SPEED)
    motion = system.simulate(3.0, method="generalized-alpha", samples=61, step=0.05 / n, progress=False)
    pulls = [cable_tension(state, f"rope{n + 3}")[1][-1] for state in motion]
    return motion.t, -motion["load.y"], np.array(pulls) / (1000.0 * models.G)


def reduced(times: Array, stretched: bool) -> tuple[Array, Array]:
    """Return depth and tension over the weight of the hoist with one degree of freedom."""
    speed = models.run_up(SPEED, 1.0, 2.0)[1]
    x, pull = exact.reduced_hoist(times, 1000.0, 1e7, 10.0, 0.2, 0.04 / np.sqrt(1e3), speed, stretched)
    return x, pull / (1000.0 * models.G)


@cache
def hoist_errors(n: int, stretched: bool) -> tuple[float, float]:
    """Return the largest error of the depth over the lift, and of the tension over the weight."""
    t, x, pull = wound_up(n)
    depth, tension = reduced(t, stretched)
    return float(abs(x - depth).max() / LIFT), float(abs(pull - tension).max())


def hoist() -> list[Quantity]:
    """Compare the winding hoist with models of one degree of freedom.

    The order of convergence is that for the model that winds up the stretched rope.  The other one winds up an
    undeformed length, and differs by the strain of the rope, a thousandth.
    """
    depth, tension = hoist_errors(MESHES[-1], False)
    more = {"elements": MESHES[-1], "step": 0.05 / MESHES[-1]}
    free, taut = f"{TAKEN}undeformed rope", f"{TAKEN}the rope as it is stretched"
    return [
        Quantity("winding_hoist_error", depth, 0.0, 3e-3, "", f"depth over the lift, {free}", more, kind="own"),
        Quantity("winding_hoist_tension_error", tension, 0.0, 0.06, "mg", free, more, kind="own"),
        over_meshes("winding_hoist_stretched_error", lambda n: hoist_errors(n, True)[0], MESHES, 7e-4, taut,
                    kind="own"),
        over_meshes("winding_hoist_stretched_tension_error", lambda n: hoist_errors(n, True)[1], MESHES, 0.05, taut,
                    kind="own"),
    ]  # fmt: skip


# -- block and tackle -----------------------------------------------------------------------------


@cache
def lifted(arm: float, n: int) -> tuple[float, float]:
    """Return speed ratio and mechanical advantage of the tackle, when its end is pulled evenly."""
    system, rope = models.tackle(n, arm)
    motion = system.simulate(
        1.0, method="generalized-alpha", samples=101, step=2e-3, spectral_radius=0.5, progress=False
    )
    steady = [state for state in motion if state.t > 0.5]
    weight = (10.0 + 0.1) * models.G  # load and movable sheave
    pull = float(rope.tension(steady)[1][:, -1].mean())
    return 0.2 / float(motion["block.y'"][motion.t > 0.5].mean()), weight / pull


def efficiency(arm: float) -> float:
    """Return the efficiency of a sheave that the rope turns by half: (R - arm)/(R + arm), from journal moments."""
    return (models.WHEEL - arm) / (models.WHEEL + arm)


def tackle() -> list[Quantity]:
    """Return speed ratio, mechanical advantage and efficiency, without and with friction in the journals."""
    n = TACKLE[-1]
    eta = efficiency(ARM)
    given = eta * (1 + eta)  # the rope's end comes off the fixed sheave: eta (1 - eta^falls)/(1 - eta)
    ideal, real = lifted(0.0, n), lifted(ARM, n)
    more = {"elements": n, "falls": 2, "sheave_efficiency": eta}
    return [
        over_meshes("tackle_speed_ratio_error", lambda n: abs(lifted(0.0, n)[0] / 2 - 1), TACKLE, 3.3e-5, "2 falls"),
        over_meshes("tackle_advantage_error", lambda n: abs(lifted(0.0, n)[1] / 2 - 1), TACKLE, 1.3e-4, "2 falls"),
        Quantity("tackle_speed_ratio", [ideal[0], real[0]], (2.0, 2.0), 5e-5, "", "without and with friction", more,
                 kind="closed form"),
        Quantity("tackle_advantage", [ideal[1], real[1]], (2.0, given), 1.6e-3, "", ADVANTAGE, more,
                 kind="closed form"),
        Quantity("tackle_efficiency", real[1] / real[0], given / 2, 1.5e-3, "", "advantage over speed ratio", more,
                 kind="closed form"),
    ]  # fmt: skip


# -- rope over an edge ----------------------------------------------------------------------------


def sliding_error(n: int) -> float:
    """Return the largest error of the fall over the fall at the end."""
    ahead, length = 0.1, 1.4
    system, _ = models.sliding(n, length, ahead)
    motion = system.simulate(
        0.6, method="generalized-alpha", samples=31, step=2e-3, spectral_radius=0.5, progress=False
    )
    given = exact.sliding_fall(motion.t, ahead, length)
    return float(abs(motion["B.y"][0] - motion["B.y"] - given).max() / given[-1])


def edge() -> list[Quantity]:
    """Compare the rope that slides off."""
    return [over_meshes("sliding_rope_error", sliding_error, (28, 56), 1e-3, "x0 cosh(sqrt(2 g/L) t)")]


def rows() -> list[Quantity]:
    """Compare hoist, tackle, sliding rope."""
    return [*hoist(), *tackle(), *edge()]
