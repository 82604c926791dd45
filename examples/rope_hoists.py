"""Ropes that lift: a drum that winds up a load, a block and tackle with friction in its journals, a rope that slides off.

Imports numpy and flexel.
"""

from __future__ import annotations

from functools import cache

import numpy as np

import flexel as fx
from flexel.cables import cable_tension
from flexel.examples import rope_exact as exact
from flexel.examples import rope_models as models
from flexel.examples.rope_hanging import over_meshes
from flexel.report import Quantity
from flexel.ropes import Rope
from flexel.structure import Array

WOUND = 20  # elements of the metre of rope next to the drum
SPEED = 2.5  # of the drum in the end [rad/s]
LIFT = 0.2 * SPEED * 1.5  # of the hoist in 3 s [m]
ARM = 0.005  # coefficient of friction times radius of the journals of the tackle [m]


@cache
def wound_up() -> tuple[Array, Array, Array]:
    """Times, depth of the load [m] and tension at the load over its weight, 3 s, every 0.05 s."""
    system, _ = models.winding_hoist(WOUND, SPEED)
    motion = system.simulate_stiff(3.0, samples=61, step=2.5e-3, radius=0.95, progress=False)
    pulls = [cable_tension(state, f"rope{WOUND + 9}")[1][-1] for state in motion]
    return motion.t, -motion["load.y"], np.array(pulls) / (1000.0 * models.G)


def reduced(times: Array, stretched: bool) -> tuple[Array, Array]:
    """Depth and tension over the weight of the hoist with one freedom."""
    speed = models.run_up(SPEED, 1.0, 2.0)[1]
    x, pull = exact.reduced_hoist(times, 1000.0, 1e7, 10.0, 0.2, 0.04 / np.sqrt(1e3), speed, stretched)
    return x, pull / (1000.0 * models.G)


def hoist() -> list[Quantity]:
    """The winding hoist beside the model with one freedom."""
    t, x, pull = wound_up()
    more = {"elements": WOUND + 9, "step": 2.5e-3}
    rows = []
    for name, stretched, source in (
        ("winding_hoist", False, "one freedom; the drum takes up undeformed rope"),
        ("winding_hoist_stretched", True, "one freedom; the drum takes up the rope as it is stretched"),
    ):
        depth, tension = reduced(t, stretched)
        error = float(abs(x - depth).max() / LIFT)
        rows += [
            Quantity(f"{name}_error", error, 0.0, 2e-3, "", f"depth over the lift, {source}", more),
            Quantity(
                f"{name}_tension_error", float(abs(pull - tension).max()), 0.0, 0.05, "mg", source, more
            ),
        ]
    return rows


@cache
def lifted(arm: float, n: int = 42) -> tuple[fx.Motion, Rope]:
    """The tackle in motion; its end is pulled evenly from 0.2 s on."""
    system, rope = models.tackle(n, arm)
    return system.simulate_stiff(0.5, samples=26, tolerance=1e-3, progress=False), rope


def efficiency(arm: float) -> float:
    """Of one sheave that the rope turns around by half: (R - arm)/(R + arm), from the moments about its journal."""
    return (models.WHEEL - arm) / (models.WHEEL + arm)


def tackle() -> list[Quantity]:
    """Speed ratio and mechanical advantage, without and with friction in the journals."""
    advantages = []
    weight = (10.0 + 0.1) * models.G  # load and movable sheave
    for arm in (0.0, ARM):
        motion, rope = lifted(arm)
        steady = [state for state in motion if state.t > 0.25]
        advantages.append(weight / float(rope.tension(steady)[1][:, -1].mean()))
    motion, _ = lifted(0.0)
    ratio = 0.2 / float(motion["block.y'"][motion.t > 0.25].mean())
    exact_advantages = [efficiency(z) * (1 + efficiency(z)) for z in (0.0, ARM)]
    more = {"elements": 42, "falls": 2}
    found = advantages[1] / advantages[0]
    return [
        Quantity("tackle_speed_ratio", ratio, 2.0, 5e-3, "", "falls", more),
        Quantity("tackle_advantage", advantages, exact_advantages, 1e-2, "", "eta (1 - eta^n)/(1 - eta), eta = 1, 0.905", more),
        Quantity("tackle_efficiency", found, exact_advantages[1] / 2, 5e-3, "", "the same over n", more),
    ]  # fmt: skip


def sliding_error(n: int) -> float:
    """Largest error of the fall over the fall at the end."""
    ahead, length = 0.1, 1.4
    system, _ = models.sliding(n, length, ahead)
    motion = system.simulate_stiff(0.6, samples=31, tolerance=1e-4, progress=False)
    given = exact.sliding_fall(motion.t, ahead, length)
    return float(abs(motion["B.y"][0] - motion["B.y"] - given).max() / given[-1])


def rows() -> list[Quantity]:
    """Hoist, tackle, sliding rope."""
    return [
        *hoist(),
        *tackle(),
        over_meshes("sliding_rope_error", sliding_error, (28, 56), 5e-3, "x0 cosh(sqrt(2 g/L) t)"),
    ]
