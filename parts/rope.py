"""A rope around sheaves: its path, and its tension, strain, curvature and contact forces in states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.instances import Instance
from flexel.model.state import State
from flexel.parts.cable_lines import CableLine
from flexel.parts.cable_results import cable_outputs, find_cable
from flexel.parts.rope_contacts import ContactPoint
from flexel.parts.rope_path import RopePath


@dataclass(frozen=True, repr=False)
class Rope(CableLine):
    """A rope made by `Model.rope`: the line of cables, its path and its contacts.

    A closed rope has as many points and slopes as elements; its arc length starts and ends at the first.

    Attributes
    ----------
    radius : float
        Radius of the rope [m].
    path : RopePath
        Initial path, in the plane of the sheaves, which it leaves on helical grooves.
    tension0 : float
        Tension in the initial configuration [N].
    contacts : dict of str to list of ContactPoint
        Contact points for each sheave or drum.
    """

    radius: float
    path: RopePath
    tension0: float
    contacts: dict[str, list[ContactPoint]]

    def tension(self, states: State | Sequence[State]) -> tuple[Array, Array]:
        """Return undeformed arc length s (ns,) [m] and tension (ns,) or (nt, ns) [N], at three points of each element.

        Parameters
        ----------
        states : State or sequence of State
            States of one system, such as a motion.
        """
        return self._along(states, "tension")

    def strain(self, states: State | Sequence[State]) -> tuple[Array, Array]:
        """Return undeformed arc length s (ns,) [m] and axial strain (ns,) or (nt, ns) along the rope."""
        return self._along(states, "strain")

    def curvature(self, states: State | Sequence[State]) -> tuple[Array, Array]:
        """Return undeformed arc length s (ns,) [m] and curvature (ns,) or (nt, ns) [1/m] along the rope.

        A wire of diameter d and modulus E that slides on its neighbours has a bending stress of E d/2 times this.
        """
        return self._along(states, "curvature")

    def _along(self, states: State | Sequence[State], output: str) -> tuple[Array, Array]:
        """Return the arc length of the points of all elements, and what is reported there."""
        listed, cables = self._checked(states)
        outputs = cable_outputs(listed, cables)
        found = outputs[output].reshape(len(listed), -1)
        s = (self.s[:-1, None] + outputs["arc_length"][0]).ravel()
        return s, found[0] if isinstance(states, State) else found

    def contact_force(self, states: State | Sequence[State], surface: str) -> tuple[Array, Array]:
        """Return undeformed arc length s (np,) [m] and normal force (np,) or (nt, np) [N] of points over one surface.

        The forces on both flanks of a V groove are added: friction is limited by their sum, and the load that they
        carry is sin(opening/2) times the sum.
        """
        points = self._points(surface)
        s = np.array([p.s for p in points])
        N = np.array([[_normal_force(state, p) for p in points] for state in self._checked(states)[0]])
        return s, N[0] if isinstance(states, State) else N

    def resultant(self, states: State | Sequence[State], surface: str) -> Array:
        """Return the sum of the normal forces (see `contact_force`) on one surface: a float array () or (nt,) [N]."""
        return np.asarray(self.contact_force(states, surface)[1].sum(axis=-1))

    def wrap_angle(self, states: State | Sequence[State], surface: str) -> Array:
        """Return the angle () or (nt,) [rad] over which the rope touches.

        This is the undeformed length from the first to the last point in contact, divided by the length of the centre
        line per angle.
        """
        points = self._points(surface)
        s, N = self.contact_force(states, surface)
        found = points[0].surface
        if not found.radius:
            return np.zeros(N.shape[:-1])
        share = float(np.mean([p.weight for p in points]))
        touched = np.array([self._touched(s[row > 0], share) for row in np.atleast_2d(N)])
        return np.asarray(touched.reshape(N.shape[:-1]) / found.per_radian(self.radius))

    def _touched(self, s: Array, share: float) -> float:
        """Return the length [m] from the first to the last of some points; of a closed rope all but the longest gap."""
        if not s.size:
            return 0.0
        if len(self.points) > len(self.elements):
            return float(s[-1] - s[0]) + share
        gaps = np.diff(np.append(s, s[0] + self.s[-1]))
        return float(self.s[-1] - gaps.max()) + share

    def slip(self, states: State | Sequence[State], surface: str) -> tuple[Array, Array]:
        """Return undeformed arc length (np,) [m] and sliding velocity (np,) or (nt, np) [m/s]; zero off the surface."""
        points = self._points(surface)
        s, N = self.contact_force(states, surface)
        name = points[0].surface.gaps[0][1][0]
        listed = self._checked(states)[0]
        rates = np.array([[state.rate(f"{p.element}.{name}") for p in points] for state in listed])
        return s, np.where(N > 0, rates[0] if isinstance(states, State) else rates, 0.0)

    def _checked(self, states: State | Sequence[State]) -> tuple[Sequence[State], list[Instance]]:
        """Return the states, which must belong to one system with this rope, and its cables there."""
        listed = [states] if isinstance(states, State) else states
        known = (
            isinstance(listed, Sequence) and len(listed) and all(isinstance(state, State) for state in listed)
        )
        if not known:
            raise ModelError(f"rope '{self.name}': {states!r:.60} is not a state; give a state, or a motion")
        first = listed[0].structure
        cables = [find_cable(listed[0], name) for name in self.elements]
        lengths = [float(cable.parameters["l0"][0]) for cable in cables]
        same = all(state.structure is first or state.structure.names == first.names for state in listed)
        if not same or not np.allclose(lengths, np.diff(self.s), rtol=1e-9):
            raise ModelError(
                f"rope '{self.name}': the states belong to different models, or to another model than this "
                "rope; use the rope of the states' model"
            )
        return listed, cables

    def _points(self, surface: str) -> list[ContactPoint]:
        if not isinstance(surface, str) or surface not in self.contacts:
            raise ModelError(
                f"rope '{self.name}': no contact with '{surface}'; it has {', '.join(self.contacts)}"
            )
        return self.contacts[surface]


def _normal_force(state: State, p: ContactPoint) -> float:
    """Sum the forces of a point's gaps: of both flanks of a V groove."""
    return -sum(state.force(f"{p.element}.{gap}") for gap, _ in p.surface.gaps)
