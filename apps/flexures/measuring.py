"""Measures all results of a flexure mechanism at its equilibria, as labelled arrays."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence

import numpy as np

from flexel.apps.flexures.input_tables import FlexureTables
from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import DynamicsError, IncompleteWarning
from flexel.base.quaternions import axis_angle, euler_angles, rotation_rows
from flexel.linear.mode_tracking import tracked
from flexel.model.state import State
from flexel.parts.materials import Profile
from flexel.parts.model import Model
from flexel.results.flexure_step import beams_of, frame_name, node_name
from flexel.results.saved.record import Variable
from flexel.results.system_facade import System
from flexel.statics.compliance import DIRECTIONS
from flexel.statics.stability import BucklingMode

PARAMETERS = ("lambda0", "lambda1", "lambda2", "lambda3")
TURNS = ("about z", "about new y", "about new x")


MAX_LOAD_MULTIPLIER = 1e9  # multiplier above which no flexible part carries the load
TRACKED_BEYOND = 6  # modes computed beyond those wanted: tracked ones go on where modes change places


class Measuring:
    """Results of the states of a system that was declared from tables.

    Attributes
    ----------
    notes : list of str
        Results that could not be found, and why.
    tracked : dict of str to tuple of str
        Short names of the tracked modes, by the dimension of their arrays.
    """

    def __init__(self, tables: FlexureTables, model: Model, system: System) -> None:
        self.tables, self.model, self.system = tables, model, system
        self.notes: list[str] = []
        self.tracked: dict[str, tuple[str, ...]] = {}
        self.nodes = range(1, len(tables.places) + 1)

    def labels(self, variables: Mapping[str, Variable]) -> dict[str, tuple[str, ...]]:
        """Return the names along the dimensions of the arrays."""
        counts = {"mode": "frequency", "buckling_mode": "buckling"}
        numbers = {key: range(1, variables[name].values.shape[1] + 1) for key, name in counts.items()}
        return (
            {key: tuple(map(str, labels)) for key, labels in numbers.items()}
            | self.tracked
            | {
                "node": tuple(map(str, self.nodes)),
                "element": tuple(str(i + 1) for i in range(len(self.tables.ends))),
                "component": ("x", "y", "z"),
                "parameter": PARAMETERS,
                "turn": TURNS,
                "direction": DIRECTIONS,
                "load_direction": tuple(
                    f"force {name}" if i < 3 else f"moment {name[-1]}" for i, name in enumerate(DIRECTIONS)
                ),
            }
        )

    def variables(self, states: Sequence[State]) -> dict[str, Variable]:
        """Compute all results of the states."""
        place, per_element = ("time", "node", "component"), ("time", "element")
        x = np.array([[state.position(node_name(i)) for i in self.nodes] for state in states])
        q = np.array([[state.position(frame_name(i)) for i in self.nodes] for state in states])
        turns = [[axis_angle(quaternion) for quaternion in row] for row in q]
        axes, angles = (np.array([[turn[i] for turn in row] for row in turns]) for i in (0, 1))
        stress = np.array([self._stress(state) for state in states])
        forces, moments = (
            np.array([read(state) for state in states]) for read in (self._forces, self._moments)
        )
        found = {
            "drawn": Variable(("node", "component"), self.tables.places, "m", "positions as drawn"),
            "position": Variable(place, x, "m"),
            "quaternion": Variable(("time", "node", "parameter"), q, "", "rotation as Euler parameters"),
            "euler_angles": Variable(
                ("time", "node", "turn"), np.apply_along_axis(euler_angles, 2, q), "rad"
            ),
            "axis": Variable(place, axes, "", "axis of rotation"),
            "angle": Variable(place[:2], angles, "rad", "angle of rotation"),
            "reaction_force": Variable(place, forces, "N", "of supports and drives on the nodes"),
            "reaction_moment": Variable(place, moments, "N m", "of supports and drives on the nodes"),
            "stress": Variable(per_element, stress[:, 0], "Pa", "largest equivalent stress"),
            "stress_at": Variable(per_element, stress[:, 1], "m", "its distance from the first node"),
        }
        return found | self._compliances(states) | self._vibrations(states) | self._buckling(states)

    def _forces(self, state: State) -> Array:
        return np.array([state.reactions[state.structure.places(node_name(i))] for i in self.nodes])

    def _moments(self, state: State) -> Array:
        """Convert reactions f on Euler parameters to the moment M that does the same work."""
        found = []
        for i in self.nodes:
            places = state.structure.places(frame_name(i))
            found.append(rotation_rows(state.x[places]) @ state.reactions[places] / 4)
        return np.array(found)

    def _stress(self, state: State) -> Array:
        """Return the largest equivalent stress (m,) of each element, and its distance (m,) from the first node."""
        elastic = {name.split(".")[0] for law in state.structure.laws for name in law.deformations}
        instances = {instance.name: instance for instance in state.structure.instances}
        found = np.full((2, len(self.tables.ends)), np.nan)
        for i, (p, q) in enumerate(self.tables.ends):
            beams = [
                name
                for name in beams_of(state, i + 1)
                if name in elastic and isinstance(instances[name].profile, Profile)
            ]
            if beams:
                stresses = [state.stress(name) for name in beams]
                k = max(range(len(beams)), key=lambda j: stresses[j].mises)
                length = float(np.linalg.norm(self.tables.places[q - 1] - self.tables.places[p - 1]))
                found[:, i] = stresses[k].mises, (k + (stresses[k].end == "q")) * length / len(beams)
        return found

    def _compliances(self, states: Sequence[State]) -> dict[str, Variable]:
        """Compute compliances in global axes and in axes that turn with the nodes; NaN for nodes not requested."""
        wanted = self.tables.options.compliance
        if isinstance(wanted, (bool, np.bool_)):
            chosen = list(self.nodes) if wanted else []
        else:
            chosen = [int(step) for step in wanted]
        in_space = np.full((len(states), len(self.nodes), 6, 6), np.nan)
        in_body = in_space.copy()
        for k, state in enumerate(states):
            for i in chosen:
                C = self.system.compliance(node_name(i), frame_name(i), state)
                in_space[k, i - 1], in_body[k, i - 1] = C.matrix, C.in_body
        dims = ("time", "node", "direction", "load_direction")
        unit = "m/N, rad/N; m/(N m), rad/(N m)"
        return {
            "compliance": Variable(dims, in_space, unit, "in global axes"),
            "compliance_body": Variable(dims, in_body, unit, "in axes that turn with the node"),
        }

    def _vibrations(self, states: Sequence[State]) -> dict[str, Variable]:
        count = self.tables.options.frequencies
        most = count + TRACKED_BEYOND
        found = [self.system.vibrations(state, count=most) if count else [] for state in states]
        rows = _filled([[mode.hertz for mode in modes] for modes in found])
        shapes = _filled_shapes(
            [[self._moved(s, mode.shape) for mode in modes] for s, modes in zip(states, found, strict=True)],
            len(self.nodes),
        )
        if count and not rows.size:
            self.notes.append(
                "no frequencies: nothing has mass; give a mass or an inertia, or a material or density"
            )
        return {
            "frequency": Variable(("time", "mode"), rows[:, :count], "Hz", "negative where unstable"),
            "mode_shape": Variable(("time", "mode", "node", "direction"), shapes[:, :count]),
            "tracked_frequency": self._tracked("tracked_mode", states, rows, shapes, count, "Hz"),
        }

    def _tracked(
        self, dimension: str, states: Sequence[State], rows: Array, shapes: Array, count: int, unit: str
    ) -> Variable:
        """Return the values of the modes, each followed over the steps by its shape."""
        load = [state.t for state in states]
        names, values = tracked(load, self.tables.places, rows, shapes, count)
        self.tracked[dimension] = names
        return Variable(("time", dimension), values, unit, "of each mode, tracked by its shape")

    def _buckling(self, states: Sequence[State]) -> dict[str, Variable]:
        """Compute multipliers of the acting forces and moments: 1 + the multiplier of an equal further increment."""
        count = self.tables.options.buckling
        rows: list[list[float]] = []
        shapes: list[list[Array]] = []
        failed: list[str] = []
        loaded = False
        for state in states:
            acting: dict[str, float] = {}
            for load in self.model.loads:
                acting[load.name] = acting.get(load.name, 0.0) + load.function.rates(state.t)[0]
            modes: list[BucklingMode] = []
            if any(acting.values()) and count:
                loaded = True
                try:
                    modes += self.system.buckling(state, increment=acting, count=count + TRACKED_BEYOND)
                except DynamicsError as error:
                    failed.append(f"load {state.t:g}: {error}")
            modes = [mode for mode in modes if abs(mode.multiplier) < MAX_LOAD_MULTIPLIER]
            modes.sort(key=lambda mode: abs(1 + mode.multiplier))
            rows.append([1 + mode.multiplier for mode in modes])
            shapes.append([self._moved(state, mode.shape) for mode in modes])
        self.notes += failed
        if failed:
            warnings.warn(
                f"flexure: no buckling loads at {len(failed)} of {len(states)} steps, {failed[0]}",
                IncompleteWarning,
                stacklevel=outside(),
            )
        values, moved = _filled(rows), _filled_shapes(shapes, len(self.nodes))
        if count and not values.size and not failed:
            why = "no flexible part carries the loads" if loaded else "no force or moment acts"
            self.notes.append(f"no buckling multipliers: {why}")
        dims = ("time", "buckling_mode", "node", "direction")
        of = "multiplier of the acting forces and moments"
        return {
            "buckling": Variable(dims[:2], values[:, :count], "", of),
            "buckling_shape": Variable(dims, moved[:, :count]),
            "tracked_buckling": self._tracked("tracked_buckling_mode", states, values, moved, count, ""),
        }

    def _moved(self, state: State, shape: dict[str, float]) -> Array:
        """Return the displacements and rotations (n, 6) of the nodes in a shape of coordinates."""
        found = np.zeros((len(self.nodes), 6))
        coordinates = {node.name: node.coordinates for node in state.structure.nodes}
        for i in self.nodes:
            point, frame = node_name(i), frame_name(i)
            found[i - 1, :3] = [shape.get(name, 0.0) for name in coordinates[point]]
            change = np.array([shape.get(name, 0.0) for name in coordinates[frame]])
            found[i - 1, 3:] = rotation_rows(state.position(frame)) @ change
        return found


def _filled(rows: Sequence[Sequence[float]]) -> Array:
    """Combine rows of different lengths in one array, padded with NaN."""
    found = np.full((len(rows), max(map(len, rows))), np.nan)
    for i, row in enumerate(rows):
        found[i, : len(row)] = row
    return found


def _filled_shapes(rows: Sequence[Sequence[Array]], nodes: int) -> Array:
    """Combine shapes (n, 6) in rows of different lengths in one array (rows, shapes, n, 6), padded with NaN."""
    found = np.full((len(rows), max(map(len, rows)), nodes, 6), np.nan)
    for i, row in enumerate(rows):
        for k, shape in enumerate(row):
            found[i, k] = shape
    return found
