"""Results of a flexure mechanism at its load steps: positions, reactions, compliance, frequencies, buckling, stress."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack, overload

import numpy as np

from flexel.base.arguments import flag, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.outside import Dataset, Figure
from flexel.base.shown import prints
from flexel.linear.mode_tracking import tracked
from flexel.results.flexure_step import FlexureStep
from flexel.results.motion import Motion, with_options_of
from flexel.results.saved.archive import integration_of, record_of
from flexel.results.saved.record import Record, Variable, require
from flexel.results.saved.record_files import write
from flexel.statics.compliance import RIGID_TOLERANCE

if TYPE_CHECKING:
    from flexel.apps.view.options import MotionOptions
    from flexel.apps.view.page import Page


class Flexure:
    """The result of `flexel.flexure`: a flexure mechanism at its load steps.

    Arrays have the step first and count nodes and elements from 0; ``steps[i]`` gives one step, and in it
    ``node(3)`` and ``element(2)`` count from 1, like the tables.

    Attributes
    ----------
    motion : Motion
        The states of equilibrium; its time is the load parameter, from 0 to 1.
    variables : mapping of str to Variable
        All results as labelled arrays; see `to_xarray`.
    released : tuple of str
        Deformations that were released because the mechanism was over-constrained.
    redundant : list of dict
        The states of self-stress that show this: shares of the deformations, the largest scaled to 1.
    notes : tuple of str
        Notes on the analysis, such as multipliers that could not be found.
    """

    def __init__(
        self,
        motion: Motion,
        variables: Mapping[str, Variable],
        labels: Mapping[str, tuple[str, ...]],
        released: Sequence[str],
        redundant: Sequence[Mapping[str, float]],
        notes: Sequence[str],
    ) -> None:
        self.motion, self.variables, self.labels = motion, variables, labels
        self.released, self.notes = tuple(released), tuple(notes)
        self.redundant = [dict(shares) for shares in redundant]
        self.steps = tuple(FlexureStep(motion[i], i, motion, variables) for i in range(len(motion)))

    def _of(self, name: str) -> Array:
        return np.asarray(self.variables[name].values)

    @property
    def message(self) -> str:
        """Where and why the load steps stopped early; empty if they are complete."""
        return self.motion.message

    @property
    def load(self) -> Array:
        """Share of the loads (steps,), from 0 to 1."""
        return self.motion.t

    @property
    def positions(self) -> Array:
        """Positions of the nodes (steps, n, 3) [m]."""
        return self._of("position")

    @property
    def displacements(self) -> Array:
        """Displacements of the nodes (steps, n, 3) from their drawn positions [m]."""
        return self.positions - self._of("drawn")

    @property
    def quaternions(self) -> Array:
        """Rotations of the nodes (steps, n, 4) as Euler parameters."""
        return self._of("quaternion")

    @property
    def euler_angles(self) -> Array:
        """Rotations of the nodes (steps, n, 3) as turns about z, the new y and the new x axis [rad]."""
        return self._of("euler_angles")

    @property
    def forces(self) -> Array:
        """Forces of the supports and drives on the nodes (steps, n, 3) [N]; zero for free nodes."""
        return self._of("reaction_force")

    @property
    def moments(self) -> Array:
        """Moments of the supports and drives on the nodes (steps, n, 3) about global axes [N m]."""
        return self._of("reaction_moment")

    @property
    def frequencies(self) -> Array:
        """Natural frequencies (steps, modes) [Hz], lowest first; negative if unstable."""
        return self._of("frequency")

    @property
    def buckling(self) -> Array:
        """Multipliers (steps, modes) of the acting forces and moments at which buckling occurs, smallest first."""
        return self._of("buckling")

    @property
    def tracked_frequencies(self) -> dict[str, Array]:
        """Natural frequencies (steps,) [Hz] of each mode, tracked over the steps by its shape.

        Names are short: a number, and the direction and node that move most.  NaN where a mode is not among the lowest.
        """
        return self._lines("tracked_frequency", "frequency", "mode_shape")

    @property
    def tracked_buckling(self) -> dict[str, Array]:
        """Buckling multipliers (steps,) of each mode, tracked over the steps like `tracked_frequencies`."""
        return self._lines("tracked_buckling", "buckling", "buckling_shape")

    def _lines(self, name: str, values: str, shapes: str) -> dict[str, Array]:
        """Return stored lines, or those of the stored modes, which are all that a file of an earlier version has."""
        if name in self.variables:
            names, found = self.labels[self.variables[name].dims[1]], self._of(name)
        else:
            given = self._of(values)
            names, found = tracked(self.load, self._of("drawn"), given, self._of(shapes), given.shape[1])
        return dict(zip(names, found.T, strict=True))

    @property
    def stress(self) -> Array:
        """Largest equivalent stress of each element (steps, m) [Pa]; NaN for rigid elements."""
        return self._of("stress")

    def compliance(self, node: int, body_axes: bool = False) -> Array:
        """Return the compliance of a node at all steps (steps, 6, 6), in global axes or axes that turn with the node.

        Parameters
        ----------
        node : int
            Row of the table of nodes, from 1.
        body_axes : bool
        """
        local = flag(body_axes, "flexure: compliance", "body_axes")
        found = [step.node(node).compliance for step in self.steps]
        if any(compliance is None for compliance in found):
            raise ModelError(
                f"flexure: the compliance of node {node} was not computed; name it in options: compliance"
            )
        return np.array(
            [
                compliance.in_body if local else compliance.matrix
                for compliance in found
                if compliance is not None
            ]
        )

    def stiffness(self, node: int, body_axes: bool = False) -> Array:
        """Return the stiffness of a node at all steps (steps, 6): in x, y, z [N/m] and about x, y, z [N m/rad].

        In each direction with all others free: 1 / C_ii of its compliance; infinite where it cannot move (up
        to rounding).

        Parameters
        ----------
        node : int
            Row of the table of nodes, from 1.
        body_axes : bool
            Whether the directions turn with the node.
        """
        C = np.diagonal(self.compliance(node, body_axes), axis1=1, axis2=2)
        rigid = np.abs(C) <= RIGID_TOLERANCE * np.max(np.abs(C), axis=0)
        return np.divide(1.0, C, out=np.full_like(C, np.inf), where=~rigid)

    def __len__(self) -> int:
        """Number of steps, including the initial one."""
        return len(self.steps)

    @prints
    def __repr__(self) -> str:
        lines = [
            f"flexure mechanism: {self.positions.shape[1]} nodes, {self.stress.shape[1]} elements, "
            f"{len(self)} step(s)"
        ]
        if self.released:
            lines.append("over-constrained; released " + ", ".join(f"'{name}'" for name in self.released))
        lines += [line for line in (*self.notes, self.message) if line]
        lines.append(" load   frequencies [Hz]                buckling   largest stress [MPa]")
        return "\n".join([*lines, *(str(step) for step in self.steps)])

    # -- pictures --------------------------------------------------------------------------------

    def plot(self, *nodes: int, path: str | Path | None = None) -> Figure:
        """Plot displacements, frequencies, largest stress and buckling multipliers over the load (needs matplotlib).

        Modes are those of `tracked_frequencies` and `tracked_buckling` that are among the lowest three at any step.

        Parameters
        ----------
        *nodes : int
            Nodes whose displacements are shown; the one that moves farthest by default.
        path : path, optional
            Where to write the figure.
        """
        from flexel.apps.view.flexure_graphs import plot_flexure

        return plot_flexure(self, nodes, path)

    def plot_stiffness(
        self, node: int, along: str = "", *, body_axes: bool = False, path: str | Path | None = None
    ) -> Figure:
        """Plot the stiffness of a node in every direction over its travel (needs matplotlib).

        Parameters
        ----------
        node : int
            Row of the table of nodes, from 1.
        along : str
            Direction of the travel: x, y or z; by default the one in which the node moves farthest.
        body_axes : bool
            Whether the directions turn with the node.
        path : path, optional
            Where to write the figure.
        """
        from flexel.apps.view.flexure_graphs import plot_stiffness

        return plot_stiffness(self, node, along, body_axes, path)

    def plot_shapes(self, *steps: int, path: str | Path | None = None, **options: Any) -> Figure:
        """Draw the mechanism at some steps over its drawn shape; by default the last step. Options as in `Motion`."""
        chosen = [float(self.load[whole(i, "plot_shapes", "step", 0, len(self) - 1)]) for i in steps]
        own = {"label": "{:.3g} of the loads", "title": "Deflected shapes"}
        return self.motion.plot_shapes(*chosen, path=path, **own | options)

    @overload
    def view(self, path: str | Path, **options: Unpack[MotionOptions]) -> Path: ...

    @overload
    def view(self, path: None = None, **options: Unpack[MotionOptions]) -> Page: ...

    @with_options_of(Motion.view)
    def view(self, path: str | Path | None = None, **options: Any) -> Path | Page:
        """Make an HTML page that shows the steps in any browser, offline."""
        return self.motion.view(path, **options)

    # -- tables and files ------------------------------------------------------------------------

    def record(self) -> Record:
        """Return labelled arrays: all results, and the states."""
        own = record_of(self.motion)
        header = {
            **own.header,
            "released": list(self.released),
            "redundant": self.redundant,
            "notes": list(self.notes),
            "flexure": list(self.variables),
            "labels": {key: list(names) for key, names in self.labels.items()},
        }
        variables = {**own.variables, **self.variables}
        return Record("flexure", variables, {**own.labels, **self.labels}, own.units, header)

    def to_xarray(self) -> Dataset:
        """Return all results as an xarray.Dataset, labelled by step, node, element, direction and mode."""
        require("xarray", "xarray")
        time = {"time": Variable(("time",), self.load, "", "share of the loads")}
        return Record("flexure", {**time, **self.variables}, self.labels, {}, {}).to_xarray()

    def save(self, path: str | Path) -> Path:
        """Write the results and the states as .nc, .npz, .mat or .csv; `flexel.load` reads them back."""
        return write(self.record(), path)


def flexure_of(record: Record) -> Flexure:
    """Return the results in a record."""
    header = record.header
    variables = {name: record.variables[name] for name in header["flexure"]}
    labels = {str(key): tuple(map(str, names)) for key, names in header["labels"].items()}
    return Flexure(
        Motion(None, integration_of(record)),
        variables,
        labels,
        header["released"],
        header["redundant"],
        header["notes"],
    )
