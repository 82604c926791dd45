"""Results of a flexure mechanism at its load steps: positions, reactions, compliance, frequencies, buckling, stress."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arguments import flag, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.outside import Dataset, Figure
from flexel.results.flexure_step import FlexureStep
from flexel.results.motion import Motion
from flexel.results.saved.archive import motion_of, record_of
from flexel.results.saved.files import write
from flexel.results.saved.record import Record, Variable, require


class Flexure:
    """The result of `flexel.flexure`: a flexure mechanism at its load steps.

    Arrays have the step first and count nodes and elements from 0; ``steps[i]`` gives one step, and in it
    ``node(3)`` and ``element(2)`` count as the tables do, from 1.

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
        self.redundant = [dict(z) for z in redundant]
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
        """Places of the nodes (steps, n, 3) [m]."""
        return self._of("position")

    @property
    def displacements(self) -> Array:
        """Displacements of the nodes (steps, n, 3) from where they were drawn [m]."""
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
        """Forces of the supports and drives on the nodes (steps, n, 3) [N]; zero where a node is free."""
        return self._of("reaction_force")

    @property
    def moments(self) -> Array:
        """Moments of the supports and drives on the nodes (steps, n, 3) about global axes [N m]."""
        return self._of("reaction_moment")

    @property
    def frequencies(self) -> Array:
        """Natural frequencies (steps, modes) [Hz], lowest first; negative where unstable."""
        return self._of("frequency")

    @property
    def buckling(self) -> Array:
        """Multipliers (steps, modes) of the acting forces and moments at which it buckles, smallest first."""
        return self._of("buckling")

    @property
    def stress(self) -> Array:
        """Largest equivalent stress of each element (steps, m) [Pa]; NaN where it is rigid."""
        return self._of("stress")

    def compliance(self, node: int, body_axes: bool = False) -> Array:
        """Compliance of a node at all steps (steps, 6, 6), in global axes or in those that turn with the node.

        Parameters
        ----------
        node : int
            Row of the table of nodes, from 1.
        body_axes : bool
        """
        local = flag(body_axes, "flexure: compliance", "body_axes")
        found = [step.node(node).compliance for step in self.steps]
        if any(z is None for z in found):
            raise ModelError(
                f"flexure: the compliance of node {node} was not computed; name it in options: compliance"
            )
        return np.array([z.in_body if local else z.matrix for z in found if z is not None])

    def __len__(self) -> int:
        """Number of steps, the initial one included."""
        return len(self.steps)

    def __repr__(self) -> str:
        lines = [
            f"flexure mechanism: {self.positions.shape[1]} nodes, {self.stress.shape[1]} elements, "
            f"{len(self)} step(s)"
        ]
        if self.released:
            lines.append("over-constrained; released " + ", ".join(f"'{z}'" for z in self.released))
        lines += [z for z in (*self.notes, self.message) if z]
        lines.append(" load   frequencies [Hz]                buckling   largest stress [MPa]")
        return "\n".join([*lines, *(str(step) for step in self.steps)])

    # -- pictures --------------------------------------------------------------------------------

    def plot(self, *nodes: int, path: str | Path | None = None) -> Figure:
        """Displacements, frequencies, largest stress and buckling multipliers over the load (needs matplotlib).

        Modes are followed by their shapes and named after the node and direction that move most; a line ends where its
        mode is no longer among those that were computed.

        Parameters
        ----------
        *nodes : int
            Nodes whose displacements are shown; the one that moves farthest by default.
        path : path, optional
            Where to write the figure.
        """
        from flexel.pictures.flexure_graphs import plot_flexure

        return plot_flexure(self, nodes, path)

    def plot_shapes(self, *steps: int, path: str | Path | None = None, **options: Any) -> Figure:
        """The mechanism at some steps over its drawn shape; the last one by default. Options as of `Motion`."""
        chosen = [float(self.load[whole(i, "plot_shapes", "step", 0, len(self) - 1)]) for i in steps]
        own = {"label": "{:.3g} of the loads", "title": "Deflected shapes"}
        return self.motion.plot_shapes(*chosen, path=path, **own | options)

    def view(self, path: str | Path, **options: Any) -> Path:
        """An HTML page that shows the steps in any browser; options as of `Motion.view`."""
        return self.motion.view(path, **options)

    # -- tables and files ------------------------------------------------------------------------

    def record(self) -> Record:
        """Labelled arrays: all results, and the states."""
        own = record_of(self.motion)
        header = {
            **own.header,
            "released": list(self.released),
            "redundant": self.redundant,
            "notes": list(self.notes),
            "flexure": list(self.variables),
            "labels": {key: list(z) for key, z in self.labels.items()},
        }
        variables = {**own.variables, **self.variables}
        return Record("flexure", variables, {**own.labels, **self.labels}, own.units, header)

    def to_xarray(self) -> Dataset:
        """All results as an xarray.Dataset, labelled by step, node, element, direction and mode."""
        require("xarray", "xarray")
        time = {"time": Variable(("time",), self.load, "", "share of the loads")}
        return Record("flexure", {**time, **self.variables}, self.labels, {}, {}).to_xarray()

    def save(self, path: str | Path) -> Path:
        """Write the results and the states as .nc, .npz, .mat or .csv; `flexel.load` reads them back."""
        return write(self.record(), path)


def flexure_of(record: Record) -> Flexure:
    """The results in a record."""
    header = record.header
    variables = {name: record.variables[name] for name in header["flexure"]}
    labels = {str(key): tuple(map(str, z)) for key, z in header["labels"].items()}
    return Flexure(
        motion_of(record), variables, labels, header["released"], header["redundant"], header["notes"]
    )
