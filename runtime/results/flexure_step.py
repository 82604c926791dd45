"""One load step of a flexure mechanism: its nodes, its elements, its modes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arguments import whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.outside import Figure
from flexel.base.quaternions import axis_angle, euler_angles, matrix
from flexel.mechanics.linearization import Linearization
from flexel.mechanics.modal_damping import with_modal_damping
from flexel.mechanics.stress import BeamStress
from flexel.results.motion import Motion
from flexel.results.saved.record import Variable
from flexel.statics.compliance import DIRECTIONS, Compliance
from flexel.statics.stability import Vibration, vibrations
from flexel.structure.state import State

SHOWN = 3  # largest number of frequencies in a line of the table


def node_name(node: int) -> str:
    """The point of a node of the table, counted from 1."""
    return f"node {node}"


def frame_name(node: int) -> str:
    """The frame of a node of the table."""
    return f"frame {node}"


def element_name(element: int) -> str:
    """An element of the table, counted from 1."""
    return f"element {element}"


@dataclass(frozen=True)
class FlexureNode:
    """A node at one step.

    Attributes
    ----------
    position, displacement : ndarray (3,)
        Its place, and how far it is from where it was drawn, in global axes [m].
    quaternion : ndarray (4,)
        Its rotation as Euler parameters.
    force, moment : ndarray (3,)
        What a support or a prescribed motion exerts on it, in global axes [N], [N m]; zero where it is free.
    compliance : Compliance or None
        Its displacements and rotations by small forces and moments on it: ``.matrix`` in global axes, ``.in_body``
        in axes that turn with the node.  None if it was not requested.
    """

    position: Array
    displacement: Array
    quaternion: Array
    force: Array
    moment: Array
    compliance: Compliance | None

    @property
    def euler_angles(self) -> Array:
        """Turns (3,) about z, the new y and the new x axis [rad]."""
        return euler_angles(self.quaternion)

    @property
    def axis_angle(self) -> tuple[Array, float]:
        """Axis (3,) and angle [rad] of its rotation."""
        return axis_angle(self.quaternion)


@dataclass(frozen=True)
class FlexureElement:
    """The largest stress in an element at one step.

    Attributes
    ----------
    stress : BeamStress or None
        The largest equivalent stress, with its beam, end, place in the section and strength; None where it is rigid.
    at : float
        Where it is: distance from the first node along the undeformed element [m].
    """

    stress: BeamStress | None
    at: float

    @property
    def mises(self) -> float:
        """Equivalent stress of von Mises [Pa]; NaN where the element is rigid."""
        return np.nan if self.stress is None else self.stress.mises

    @property
    def safety(self) -> float | None:
        """Strength over equivalent stress; None without a strength."""
        return None if self.stress is None else self.stress.safety


class FlexureStep:
    """A flexure mechanism at one load step.

    Attributes
    ----------
    state : State
        Everything else by name: ``state["node 3.x"]``, ``state.section_forces("element 1 beam 2")``.
    number : int
    """

    def __init__(self, state: State, number: int, motion: Motion, variables: Mapping[str, Variable]) -> None:
        self.state, self.number = state, number
        self._motion, self._variables = motion, variables

    def _of(self, name: str) -> Array:
        return np.asarray(self._variables[name].values[self.number])

    @property
    def load(self) -> float:
        """Share of the loads, from 0 to 1."""
        return self.state.t

    @property
    def frequencies(self) -> Array:
        """Natural frequencies [Hz], lowest first; negative where unstable."""
        return _finite(self._of("frequency"))

    @property
    def buckling(self) -> Array:
        """Multipliers of the acting forces and moments at which it buckles, smallest magnitude first."""
        return _finite(self._of("buckling"))

    @property
    def largest_stress(self) -> float:
        """The largest equivalent stress in all flexible elements [Pa]; NaN if there is none."""
        found = _finite(self._of("stress"))
        return float(found.max()) if found.size else np.nan

    def node(self, node: int) -> FlexureNode:
        """A node by its row in the table, from 1."""
        i = whole(node, "flexure", "node", most=len(self._of("position"))) - 1
        q, C = self._of("quaternion")[i], self._of("compliance")[i]
        place = self._of("position")[i]
        return FlexureNode(
            position=place,
            displacement=place - self._variables["drawn"].values[i],
            quaternion=q,
            force=self._of("reaction_force")[i],
            moment=self._of("reaction_moment")[i],
            compliance=None
            if np.isnan(C).any()
            else Compliance(DIRECTIONS, C, np.asarray(np.kron(np.eye(2), matrix(q)), dtype=float)),
        )

    def element(self, element: int) -> FlexureElement:
        """An element by its row in the table, from 1."""
        i = whole(element, "flexure", "element", most=len(self._of("stress"))) - 1
        if np.isnan(self._of("stress")[i]):
            return FlexureElement(None, np.nan)
        found = max((self.state.stress(z) for z in beams_of(self.state, i + 1)), key=lambda z: z.mises)
        return FlexureElement(found, float(self._of("stress_at")[i]))

    def mode(self, number: int) -> Array:
        """A mode of vibration, the lowest being 1: displacements and rotations (n, 6) of the nodes."""
        return np.asarray(self._of("mode_shape")[self._known(number) - 1])

    def _known(self, number: int) -> int:
        count = len(self.frequencies)
        if not count:
            raise ModelError(
                "flexure: no modes were computed; give options frequencies, and a mass or density"
            )
        return whole(number, "flexure", "mode", most=count)

    def vibrations(self) -> list[Vibration]:
        """The modes of vibration with the displacements of all coordinates, by name."""
        return vibrations(self._motion.system, self.state, max(len(self.frequencies), 1))

    def linearize(self, damping: float = 0.0) -> Linearization:
        """Linearized equations about this step, every mode with the same damping ratio.

        State-space models with inputs and outputs by name follow from it:
        ``step.linearize(0.01).state_space(["node 3.y"], ["node 3.y"])``.
        """
        return with_modal_damping(self._motion.system.linearize(self.state), damping)

    def plot_mode(self, number: int, path: str | Path | None = None, **options: Any) -> Figure:
        """A mode of vibration over the shape at this step; options of `flexel.pictures.deflected.plot_shape`."""
        from flexel.pictures.deflected import plot_shape
        from flexel.pictures.options import checked

        mode = self.vibrations()[self._known(number) - 1]
        title = f"Mode {number} at {mode.hertz:.4g} Hz"
        given = {"title": title} | checked("plot_mode", plot_shape, options)
        return plot_shape(self.state, mode.shape, path, **given)

    def view_modes(self, path: str | Path, **options: Any) -> Path:
        """An HTML page with the modes of vibration at this step; options of `flexel.pictures.view.mode_data`."""
        from flexel.pictures.view import view_modes

        return view_modes(self.state, path, self.vibrations(), **options)

    def __repr__(self) -> str:
        lowest = f", lowest frequency {self.frequencies[0]:.5g} Hz" if len(self.frequencies) else ""
        return f"FlexureStep({self.load:g} of the loads{lowest})"

    def __str__(self) -> str:
        shown = "  ".join(f"{z:.5g}" for z in self.frequencies[:SHOWN])
        load = f"{self.buckling[0]:.4g}" if self.buckling.size else "-"
        stress = "-" if np.isnan(self.largest_stress) else f"{self.largest_stress / 1e6:.4g}"
        return f"{self.load:5.3f}   {shown or '-':<30}  {load:<9}  {stress}"


def beams_of(state: State, element: int) -> list[str]:
    """The beams of an element of the table, from its first node to its second."""
    name = element_name(element)
    return [z.name for z in state.structure.instances if z.name == name or z.name.startswith(f"{name} beam ")]


def _finite(values: Array) -> Array:
    """The entries that are numbers; shorter rows are filled with NaN."""
    return np.asarray(values[~np.isnan(values)])
