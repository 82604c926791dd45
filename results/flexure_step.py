"""One load step of a flexure mechanism: its nodes, its elements, its modes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from flexel.base.arguments import whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.outside import Figure
from flexel.base.quaternions import axis_angle, euler_angles, matrix
from flexel.base.shown import prints
from flexel.mechanics.modal_damping import with_modal_damping
from flexel.model.state import State
from flexel.model.stress import BeamStress
from flexel.results.linearization import Linearization, as_linearization
from flexel.results.motion import Motion
from flexel.results.saved.record import Variable
from flexel.statics.compliance import DIRECTIONS, Compliance
from flexel.statics.stability import Vibration, vibrations

if TYPE_CHECKING:
    from flexel.apps.view.page import Page

MAX_FREQUENCIES_SHOWN = 3  # largest number of frequencies in a line of the table


def node_name(node: int) -> str:
    """Name the point of a node of the table, counted from 1."""
    return f"node {node}"


def frame_name(node: int) -> str:
    """Name the frame of a node of the table."""
    return f"frame {node}"


def element_name(element: int) -> str:
    """Name an element of the table, counted from 1."""
    return f"element {element}"


@dataclass(frozen=True)
class FlexureNode:
    """A node at one step.

    Attributes
    ----------
    position, displacement : ndarray (3,)
        Its position, and its displacement from the drawn position, in global axes [m].
    quaternion : ndarray (4,)
        Its rotation as Euler parameters.
    force, moment : ndarray (3,)
        Force and moment of a support or a prescribed motion on it, in global axes [N], [N m]; zero if it is free.
    compliance : Compliance or None
        Its displacements and rotations under small forces and moments on it: ``.matrix`` in global axes, ``.in_body``
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
        The largest equivalent stress, with its beam, end, position in the section and strength; None if it is rigid.
    at : float
        Where it is: distance from the first node along the undeformed element [m].
    """

    stress: BeamStress | None
    at: float

    @property
    def mises(self) -> float:
        """Equivalent stress of von Mises [Pa]; NaN if the element is rigid."""
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
        """Natural frequencies [Hz], lowest first; negative if unstable."""
        return _finite(self._of("frequency"))

    @property
    def buckling(self) -> Array:
        """Multipliers of the acting forces and moments at which the mechanism buckles, smallest magnitude first."""
        return _finite(self._of("buckling"))

    @property
    def largest_stress(self) -> float:
        """The largest equivalent stress in all flexible elements [Pa]; NaN if there is none."""
        found = _finite(self._of("stress"))
        return float(found.max()) if found.size else np.nan

    def node(self, node: int) -> FlexureNode:
        """Return a node by its row in the table, from 1."""
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
        """Return an element by its row in the table, from 1."""
        i = whole(element, "flexure", "element", most=len(self._of("stress"))) - 1
        if np.isnan(self._of("stress")[i]):
            return FlexureElement(None, np.nan)
        found = max(
            (self.state.stress(name) for name in beams_of(self.state, i + 1)), key=lambda stress: stress.mises
        )
        return FlexureElement(found, float(self._of("stress_at")[i]))

    def mode(self, number: int) -> Array:
        """Return a mode of vibration, the lowest being 1: displacements and rotations (n, 6) of the nodes."""
        return np.asarray(self._of("mode_shape")[self._known(number) - 1])

    def _known(self, number: int) -> int:
        count = len(self.frequencies)
        if not count:
            raise ModelError(
                "flexure: no modes were computed; set the option frequencies, and give a mass or density"
            )
        return whole(number, "flexure", "mode", most=count)

    def vibrations(self) -> list[Vibration]:
        """Return the modes of vibration with the displacements of all coordinates, by name."""
        return vibrations(self._motion.system, self.state, max(len(self.frequencies), 1))

    def linearize(self, damping: float = 0.0) -> Linearization:
        """Linearize the equations about this step, with the same damping ratio for every mode.

        State-space models with inputs and outputs by name follow from it:
        ``step.linearize(0.01).state_space(["node 3.y"], ["node 3.y"])``.
        """
        return as_linearization(with_modal_damping(self._motion.system.linearize(self.state), damping))

    def plot_mode(self, number: int, path: str | Path | None = None, **options: Any) -> Figure:
        """Draw a mode of vibration over the shape at this step; options of `flexel.apps.view.deflected.plot_shape`."""
        from flexel.apps.view.deflected import plot_shape
        from flexel.apps.view.options import checked

        mode = self.vibrations()[self._known(number) - 1]
        title = f"Mode {number} at {mode.hertz:.4g} Hz"
        given = {"title": title} | checked("plot_mode", plot_shape, options)
        return plot_shape(self.state, mode.shape, path, **given)

    @overload
    def view_modes(self, path: str | Path, **options: Any) -> Path: ...

    @overload
    def view_modes(self, path: None = None, **options: Any) -> Page: ...

    def view_modes(self, path: str | Path | None = None, **options: Any) -> Path | Page:
        """Make an HTML page with the modes of vibration at this step; options of `flexel.apps.view.page.mode_data`."""
        from flexel.apps.view.page import view_modes

        return view_modes(self.state, path, self.vibrations(), **options)

    @prints
    def __repr__(self) -> str:
        lowest = f", lowest frequency {self.frequencies[0]:.5g} Hz" if len(self.frequencies) else ""
        return f"FlexureStep({self.load:g} of the loads{lowest})"

    @prints
    def __str__(self) -> str:
        shown = "  ".join(f"{frequency:.5g}" for frequency in self.frequencies[:MAX_FREQUENCIES_SHOWN])
        load = f"{self.buckling[0]:.4g}" if self.buckling.size else "-"
        stress = "-" if np.isnan(self.largest_stress) else f"{self.largest_stress / 1e6:.4g}"
        return f"{self.load:5.3f}   {shown or '-':<30}  {load:<9}  {stress}"


def beams_of(state: State, element: int) -> list[str]:
    """Name the beams of an element of the table, from its first node to its second."""
    name = element_name(element)
    return [
        instance.name
        for instance in state.structure.instances
        if instance.name == name or instance.name.startswith(f"{name} beam ")
    ]


def _finite(values: Array) -> Array:
    """Return the entries that are numbers; shorter rows are padded with NaN."""
    return np.asarray(values[~np.isnan(values)])
