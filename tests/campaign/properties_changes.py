"""Properties of the same mechanism elsewhere, in other units, and in space instead of the plane."""

from dataclasses import replace

import numpy as np

import flexel as fx
from campaign.algebra import about
from campaign.case import Case
from campaign.changes import Change, changed
from campaign.space import in_space
from campaign.trial import Trial, off
from flexel.base.arrays import Array

TURNED = (about(np.array([1.0, 2.0, -0.5]), 0.8), about(np.array([0.0, 0.0, 1.0]), 2.0))


def _turn(case: Case) -> Change:
    turn = TURNED[len(case.gravity) == 2]
    return Change(turn=tuple(turn.tolist()), shift=(0.7, -1.2, 0.4))


def _units(case: Case) -> Change:
    """Turned as well."""
    return replace(_turn(case), length=1e3, mass=1e-3, time=50.0)


def _other(trial: Trial, change: Change) -> Trial:
    return trial.keep(change, lambda: Trial(changed(trial.case, change)))


def _mapped(trial: Trial, other: Trial, change: Change) -> fx.State:
    """The state of the changed system that corresponds to the start."""
    start, s = trial.start, other.system
    rest = s.unaccelerated
    x, v = rest.x.copy(), rest.v.copy()
    names = s.structure.names[s.structure.m + s.structure.k :]
    index = {name: i for i, name in enumerate(names)}
    for node in trial.nodes.values():
        rows = [index[name] for name in node.names]
        x[rows] = change.values(node, start.position(node.name))
        v[rows] = change.rates(node, start.velocity(node.name))
    return s.state(start.t * change.time, x, v, z=_internal(trial, other, change))


def _internal(trial: Trial, other: Trial, change: Change) -> Array:
    factors: dict[str, float] = {}
    for twin in trial.oracle.twins:
        factors |= dict(zip(twin.states, twin.scaled(change.length, change.mirror), strict=True))
    return np.array([trial.start[name] * factors[name] for name in other.system.structure.internal])


def _compared(trial: Trial, change: Change) -> float:
    """Accelerations of the changed model against changed ones."""
    other = _other(trial, change)
    state = _mapped(trial, other, change)
    a, b = [], []
    for node in trial.nodes.values():
        own = np.array([trial.start.acceleration(name) for name in node.names])
        a.append(change.rates(node, own, 2))
        b.append(np.array([state.acceleration(name) for name in node.names]))
    unit = change.time**2
    lengths = [change.length if node.kind == "point" else 1.0 for node in trial.nodes.values()]
    a, b = ([acceleration * unit / l for acceleration, l in zip(c, lengths, strict=True)] for c in (a, b))
    reference = np.concatenate(a)
    return off(np.concatenate(b), reference, max(1.0, float(np.max(np.abs(reference), initial=0.0))))


def turned(trial: Trial) -> float:
    """Turned and shifted."""
    return _compared(trial, _turn(trial.case))


def mirrored(trial: Trial) -> float:
    """Mirrored."""
    return _compared(trial, Change(mirror=True))


def units(trial: Trial) -> float:
    """Turned, and in millimetres, tonnes and other seconds."""
    return _compared(trial, _units(trial.case))


def motion_elsewhere(trial: Trial) -> float:
    """The end of the motion of the model turned and in other units."""
    change = _units(trial.case)
    end = trial.motion[-1]
    other = _other(trial, change)
    final = other.moved(other.system, _mapped(trial, other, change), other.case.duration)[-1]
    errors = [0.0]
    for node in trial.nodes.values():
        error = final.position(node.name) - change.values(node, end.position(node.name))
        errors.append(float(np.max(np.abs(error))) / (change.length if node.kind == "point" else 1.0))
    return max(errors)


def planar_is_spatial(trial: Trial) -> float:
    """A planar model written in space: accelerations of its points."""
    case = in_space(trial.case)
    other = Trial(case)
    if not other.drawn.redundant:  # then there is nothing to be released
        other = Trial(replace(case, known=case.known - {"redundant"}))
    rest = other.system.unaccelerated
    x, v = rest.x.copy(), rest.v.copy()
    s = other.system.structure
    index = {name: i for i, name in enumerate(s.names[s.m + s.k :])}
    start = trial.start
    for node in trial.nodes.values():
        value, rate = start.position(node.name), start.velocity(node.name)
        rows = [index[name] for name in other.nodes[node.name].names]
        if node.kind != "angle":
            x[rows], v[rows] = [*value, 0.0], [*rate, 0.0]
        else:
            c, d = np.cos(value[0] / 2), np.sin(value[0] / 2)
            x[rows], v[rows] = [c, 0, 0, d], rate[0] / 2 * np.array([-d, 0, 0, c])
    state = other.system.state(start.t, x, v, z=start.z)
    a, b = [np.zeros(1)], [np.zeros(1)]
    for node in trial.nodes.values():
        if node.kind == "point":
            a.append(np.array([*(start.acceleration(name) for name in node.names), 0.0]))
            b.append(np.array([state.acceleration(name) for name in other.nodes[node.name].names]))
    return off(np.concatenate(b), np.concatenate(a), 1.0)
