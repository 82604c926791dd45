"""The complete state of a mechanism at one instant, from positions to stresses, by name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.shown import PrintedTable, listed, prints
from flexel.base.units import rate_unit
from flexel.model.constraints import ConstraintReport, constraint_report
from flexel.model.handle import Handle, name_of
from flexel.model.instances import Instance
from flexel.model.profiles import SectionForces
from flexel.model.quantities import history
from flexel.model.role_lists import Roles
from flexel.model.stress import BeamStress, beam_stress, largest_stress, section_forces
from flexel.model.structure import Structure

ARRAYS = ("x", "v", "a", "e", "rates", "stresses", "given", "reactions", "z", "zd", "Phi_v")


@dataclass(frozen=True)
class Energy:
    """Energies [J]: kinetic, potential (of body forces and constant loads on positions) and strain."""

    kinetic: float
    potential: float
    strain: float

    @property
    def total(self) -> float:
        """Sum of the three."""
        return self.kinetic + self.potential + self.strain


class Geometry(Protocol):
    """Source of a state's names and, on demand, its J: the evaluation of a model, or a file."""

    @property
    def structure(self) -> Structure:
        """Names and index maps of the model."""

    def position(self, x: Array) -> tuple[Array, Array]:
        """Return the deformations as principal values (m,), and J (m + k + n, n)."""

    def outputs(self, elements: Sequence[Instance], x: Array, e: Array, stresses: Array) -> dict[str, Array]:
        """Return the outputs of elements of one type at coordinates (states, n), deformations and stresses, by name."""


@dataclass(frozen=True)
class State:
    """Positions, rates, accelerations and stresses at one time; its arrays are read-only.

    Attributes
    ----------
    t : float
        Time [s].
    x, v, a : ndarray (n,)
        Coordinates, rates and accelerations, free coordinates first.
    e : ndarray (m,)
        Generalized deformations; angles over any number of turns.
    rates : ndarray (m + k + n,)
        Rates of all quantities.
    stresses : ndarray (m + k,)
        Generalized stresses sigma and tau of laws, loads, and rigid, prescribed and rolling constraints.
    given : ndarray (m + k,)
        The part of them that laws and loads give.
    reactions : ndarray (n,)
        Generalized forces on fixed and prescribed coordinates.
    roles : Roles
        The choice of degrees of freedom with which the state was computed.
    energy : Energy
    drift : float
        Largest violation of the constraints, relative to their natural scales.
    z, zd : ndarray (nz,)
        Internal states of laws and their rates.
    dissipated : float
        Power that the laws dissipate [W]; negative where a law feeds energy into the motion.
    """

    t: float
    x: Array
    v: Array
    a: Array
    e: Array
    rates: Array = field(repr=False)
    stresses: Array
    given: Array = field(repr=False)
    reactions: Array
    roles: Roles = field(repr=False)
    evaluation: Geometry = field(repr=False)
    energy: Energy
    drift: float
    z: Array
    zd: Array
    dissipated: float
    Phi_v: Array = field(repr=False)  # accelerations of all quantities (m + k + n,)

    def __post_init__(self) -> None:
        """Make the arrays read-only: a motion that starts from a changed state would start elsewhere."""
        for name in ARRAYS:
            getattr(self, name).flags.writeable = False

    def __setstate__(self, fields: dict[str, Any]) -> None:
        """Set the fields from a pickle, whose arrays can be written to."""
        self.__dict__.update(fields)
        self.__post_init__()

    @property
    def structure(self) -> Structure:
        """Names and index maps of the model."""
        return self.evaluation.structure

    @prints
    def __repr__(self) -> str:
        names, values = self.structure.names, self.values
        q = [f"{names[i]} = {values[i]:.6g}" for i in self.roles.dofs]
        return f"State(t = {self.t:g} s{'; ' if q else ''}{listed(q)})"

    def _repr_html_(self) -> str:
        """Return the degrees of freedom with their rates; forces are left out."""
        s, rows = self.structure, []
        for i in self.roles.dofs:
            value, rate = (
                f"{self.values[i]:.6g} {s.units[i]}",
                f"{self.rates[i]:.6g} {rate_unit(s.units[i], 1)}",
            )
            rows.append((s.names[i], value, rate))
        return PrintedTable(f"State at t = {self.t:g} s", ("degree of freedom", "value", "rate"), rows).html

    @property
    def J(self) -> Array:  # noqa: N802
        """De, V and the identity, stacked (m + k + n, n), so that the rates are J v; computed on demand."""
        return self.evaluation.position(self.x)[1]

    @property
    def values(self) -> Array:
        """Values of all quantities (m + k + n,); slips, which have none, as NaN."""
        return np.concatenate([self.e, np.full(self.structure.k, np.nan), self.x])

    @property
    def q(self) -> Array:
        """Degrees of freedom (q_d, q_k)."""
        return self.values[self.roles.dofs]

    @property
    def qd(self) -> Array:
        """Rates of the dynamic degrees of freedom (nd,)."""
        return self.rates[self.roles.dynamic]

    def __getitem__(self, name: str) -> float:
        """Return a coordinate, a deformation, a law's internal state or a controller's output; slips have none.

        As in a motion, ``name'`` is a rate, ``name''`` an acceleration, and ``force:name`` a stress or reaction.
        """
        s = self.structure
        i = s.index[name] if isinstance(name, str) and name in s.index else -1
        if i < 0:
            return self._of_other(name)
        if i < s.m:
            return float(self.e[i])
        i -= s.m + s.k
        if i < 0:
            raise ModelError(f"slip '{name}' has no value, only a rate; use rate('{name}')")
        return float(self.x[i])

    def _of_other(self, name: Any) -> float:
        """Return what a name stands for that is not a quantity by itself."""
        s = self.structure
        if not isinstance(name, str):
            return float(s.find(name))  # which raises
        if name in s.internal:
            return float(self.z[s.internal[name]])
        if name in s.commands:
            controller, place = s.commands[name]
            return float(controller.outputs_at(self)[place])
        quantity = history(s, name)
        read = {-1: self.force, 1: self.rate, 2: self.acceleration}
        return read[quantity.order](quantity.base)

    def rate(self, name: str) -> float:
        """Return the rate of a coordinate, a deformation or a law's internal state, or a slip itself."""
        if isinstance(name, str) and name in self.structure.internal:
            return float(self.zd[self.structure.internal[name]])
        return float(self.rates[self.structure.find(name)])

    def acceleration(self, name: str) -> float:
        """Return the second rate of a coordinate or deformation, or the rate of a slip."""
        return float(self.Phi_v[self.structure.find(name)])

    def force(self, name: str) -> float:
        """Return the stress of a deformation or slip, or the reaction on a fixed or prescribed coordinate.

        A stress is that of all that acts there: laws, loads, and what holds or drives the deformation; see `drive`.
        """
        i = self.structure.find(name)
        first = self.structure.m + self.structure.k
        return float(self.stresses[i] if i < first else self.reactions[i - first])

    def drive(self, name: str) -> float:
        """Return the force or moment of what drives or holds a quantity, positive in the direction of its motion.

        It is that of the motor alone: springs, dampers, friction and loads in the same place are not in it.

        Parameters
        ----------
        name : str
            A coordinate or deformation that is prescribed, an actuator, or held (`System.equilibrium`).

        Raises
        ------
        ModelError
            If nothing drives it.
        """
        s, roles = self.structure, self.roles
        i, first = s.find(name, "drive"), s.m + s.k
        force = -float(self.stresses[i] - self.given[i]) if i < first else float(self.reactions[i - first])
        driven = {*roles.prescribed.tolist(), *roles.forces[roles.rigid.size :].tolist()}
        if i not in driven and (not force or i in roles.rigid or i in roles.zero or i >= first + s.nf):
            known = ", ".join(s.names[j] for j in sorted(driven)) or "none is"
            raise ModelError(f"drive: nothing drives '{name}'; prescribed quantities and actuators: {known}")
        return force

    def position(self, node: str | Handle) -> Array:
        """Return the coordinates of a node, given by its name or itself, as many as its kind has."""
        return np.asarray(self.x[self.structure.places(name_of(node))])

    def velocity(self, node: str | Handle) -> Array:
        """Return the rates of a node's coordinates."""
        return np.asarray(self.v[self.structure.places(name_of(node))])

    def outputs(self, element: str) -> dict[str, Array]:
        """Return what an element reports in addition to its deformations: arrays by name, shaped as in its definition.

        Raises
        ------
        ModelError
            If there is no element of that name.

        See Also
        --------
        flexel.derive.Output : The declaration of one.
        """
        instance = self.structure.element(element)
        found = self.evaluation.outputs([instance], self.x[None], self.e[None], self.stresses[None])
        return {name: values[0, 0] for name, values in found.items()}

    def section_forces(self, beam: str) -> tuple[SectionForces, SectionForces]:
        """Return forces [N] and moments [N m] in both end sections, p and q, of a beam, in the section's axes there.

        A beam with warping also has the bimoment [N m²].

        They follow from how the beam is deformed. What acts along it, w [N/m] of weight, load and inertia, goes to its
        two ends as equivalent forces, which are not among these: at an end that is held, the force is w l/2 and the
        moment w l²/12 too small, where l is the length of one element. Divide the beam: with n elements in its place
        these are n and n² times smaller.

        Raises
        ------
        ModelError
            If there is no beam of that name with two frames.
        """
        return section_forces(self, beam)

    def stress(self, beam: str) -> BeamStress:
        """Return the largest equivalent stress [Pa] in the end sections of a beam with a section and a material.

        It is that of `section_forces`: see there for what acts along the beam.

        Raises
        ------
        ModelError
            If there is no beam of that name with two frames, or it has no section.
        """
        return beam_stress(self, beam)

    def largest_stress(self) -> BeamStress:
        """Return the largest equivalent stress [Pa] in all beams that have a section and two frames.

        Raises
        ------
        ModelError
            If no beam has a section.
        """
        return largest_stress(self)

    def constraint_report(self) -> ConstraintReport:
        """Report over-constraint and under-constraint in this state; see `Model.constraint_report`."""
        return constraint_report(self.structure, self.roles, self.J)


def own_state(structure: Structure, state: object, owner: str) -> State:
    """Return the state if it is one of this model; raise a ModelError that names the owner otherwise."""
    if not isinstance(state, State):
        raise ModelError(
            f"{owner}: {type(state).__name__} is not a state; give one, such as system.initial or motion[-1]"
        )
    if state.structure is not structure:
        raise ModelError(
            f"{owner}: the state belongs to another model; give a state of this one (one from a file or "
            "another process: system.restore(state))"
        )
    return state
