"""Local forces of the hoist's rope at one state, compared with statics: tension everywhere, pressure on the sheaves.

The tension of a free part is the mean over it; over a sheave it passes from one to the next in proportion to the arc.
The rope presses on a groove by T/R per length.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.hoist_model import SHEAVES, HoistModel

ENDS = 2  # elements of a wrap that are left out of the pressure at each end: see `edge_force`


@dataclass(frozen=True)
class Wrap:
    """The part of the rope that touches a sheave or the drum: from and to [m], undeformed."""

    name: str
    begin: float
    end: float


def wraps(model: HoistModel, state: fx.State) -> list[Wrap]:
    """Return the parts of the rope that touch, in its order."""
    found = []
    for name in ("drum", *SHEAVES):
        s, N = model.rope.contact_force(state, name)
        found.append(Wrap(name, float(s[N > 0][0]), float(s[N > 0][-1])))
    return found


def free_tensions(model: HoistModel, state: fx.State) -> tuple[Array, Array]:
    """Return ends (4, 2) [m] of the free parts from the drum to the anchor, and their mean tension (4,) [N]."""
    touching = wraps(model, state)
    ends = np.array(
        [(a.end, b.begin) for a, b in pairwise(touching)] + [(touching[-1].end, model.rope.s[-1])]
    )
    s, T = model.rope.tension(state)
    return ends, np.array([T[(s > begin) & (s < end)].mean() for begin, end in ends])


def statics(model: HoistModel, state: fx.State, s: Array) -> Array:
    """Return the tension [N] by statics at distances [m] from the drum."""
    ends, T = free_tensions(model, state)
    return np.interp(s, ends.ravel(), np.repeat(T, 2))


def tension_ratios(model: HoistModel, state: fx.State) -> Array:
    """Return the tension over that of statics at all points beyond the drum, on and off the sheaves."""
    s, T = model.rope.tension(state)
    beyond = s > wraps(model, state)[0].end
    return np.asarray(T[beyond] / statics(model, state, s[beyond]))


def cores(model: HoistModel, state: fx.State) -> list[Wrap]:
    """Return the wraps on the sheaves without two elements at each end."""
    off = ENDS * float(np.diff(model.rope.s).max())
    return [Wrap(wrap.name, wrap.begin + off, wrap.end - off) for wrap in wraps(model, state)[1:]]


def pressure_ratios(model: HoistModel, state: fx.State) -> Array:
    """Return normal force per length over T/R at points on sheaves, two elements and more from the ends of a wrap."""
    rope, found = model.rope, []
    for core in cores(model, state):
        s, N = rope.contact_force(state, core.name)
        line = N / np.array([p.weight for p in rope.contacts[core.name]])
        inner = (s > core.begin) & (s < core.end)
        found.append(line[inner] * model.data.pitch / statics(model, state, s[inner]))
    return np.concatenate(found)


def worst(ratios: Array) -> float:
    """Return the ratio that is furthest from one."""
    return float(ratios[np.argmax(abs(ratios - 1))])


def wire_stress(model: HoistModel, state: fx.State) -> float:
    """Return the largest bending stress [N/m²] of wires on sheaves, two elements and more from the ends of a wrap."""
    s, kappa = model.rope.curvature(state)
    inner = [(s > core.begin) & (s < core.end) for core in cores(model, state)]
    return model.data.wire_stress(float(kappa[np.any(inner, axis=0)].max()))


def boundary_layer(model: HoistModel) -> tuple[float, float]:
    """Return the length [m] in which a rope takes up the curvature of a sheave, and the edge force [N] that it makes.

    A beam of bending stiffness EI under the tension T straightens over sqrt(EI/T); the moment EI/R that ends at the
    edge of the contact is balanced by a concentrated force sqrt(EI T)/R.
    """
    T, data = model.data.weight / 4, model.data
    return float(np.sqrt(data.EI / T)), float(np.sqrt(data.EI * T) / data.pitch)
