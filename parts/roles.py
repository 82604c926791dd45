"""Roles of quantities: fixed, rigid, free, prescribed, independent, and initial values."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import names, number
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry
from flexel.base.time_functions import as_function
from flexel.base.time_tables import Table
from flexel.model.lowering import Lowering
from flexel.model.node import COMPONENTS, Node
from flexel.model.part import Part, part


@part
class Fix(Part[None]):
    """Fix nodes or single coordinates at their drawn values; all of them or, if one is refused, none."""

    names: tuple[Node | str, ...] = entry("Nodes, or coordinates.", spread=True, form="node or str")

    def lower(self, to: Lowering) -> None:
        """Mark the coordinates as fixed."""
        held: dict[str, Node] = {}
        for given in self.names:
            name, _, component = given.partition(".") if isinstance(given, str) else (given, "", "")
            if isinstance(name, str) and name in to.instances:
                _refuse_element(to, name, component)
            found = to.find_node(name, "fix")
            components = COMPONENTS[found.kind]
            if component and component not in components:
                raise ModelError(
                    f"fix: node '{found.name}' has no coordinate '{component}'; it has {', '.join(components)}"
                )
            target = held.get(found.name, found)
            fixed = target.fixed | np.array([not component or own == component for own in components])
            held[found.name] = replace(target, fixed=fixed)
        to.nodes.update(held)


def _refuse_element(to: Lowering, name: str, component: str) -> None:
    """Raise a ModelError for an element in place of a node."""
    if component:
        to.quantity_kind(f"{name}.{component}", "fix")
    raise ModelError(
        f"fix: '{name}' is an element; hold its deformations with m.rigid('{name}.{component or '…'}')"
    )


@part
class Release(Part[None]):
    """Make deformations or slips free: no constraint, stress from laws and loads only."""

    names: tuple[str, ...] = entry("Deformations or slips.", spread=True)

    def lower(self, to: Lowering) -> None:
        """Note the role."""
        _set_role(to, "release", self.names, "free")


@part
class Rigid(Part[None]):
    """Hold deformations (or slips) at zero."""

    names: tuple[str, ...] = entry("Deformations or slips.", spread=True)

    def lower(self, to: Lowering) -> None:
        """Note the role."""
        _set_role(to, "rigid", self.names, "rigid")


def _set_role(to: Lowering, owner: str, names: tuple[str, ...], role: str) -> None:
    """Give deformations or slips a role; all of them or, if one is refused, none."""
    for name in names:
        if to.quantity_kind(name, owner) == "coordinate":
            raise ModelError(
                f"{owner}: '{name}' is a coordinate, but rigid and free are roles of deformations and slips; use fix"
            )
    to.roles.update(dict.fromkeys(names, role))


@part
class Prescribe(Part[None]):
    """Give a coordinate or deformation a motion u(t), which replaces any earlier one."""

    name: str = entry("The coordinate or deformation.")
    motion: Any = array_quantity(
        "",
        "A callable is called with a second-order jet: operators and NumPy functions give u, u' and u''.  A Table is "
        'of kind "cubic".',
        form="float, callable, triple of callables, Ramp, Harmonic, Polynomial or Table",
    )
    actuators: tuple[str, ...] = entry(
        "Quantities in which the driving forces act, as many as there are quantities with actuators; itself by "
        "default.",
        default=(),
        form="sequence of str",
    )

    @property
    def label(self) -> str:
        """By its quantity, which other parts may act on."""
        return f"prescribe {self.name}"

    def lower(self, to: Lowering) -> None:
        """Note the motion."""
        if to.quantity_kind(self.name, "prescribe") == "slip":
            raise ModelError(
                f"prescribe: '{self.name}' is a slip; only coordinates and deformations are prescribed"
            )
        if isinstance(self.motion, Table) and self.motion.kind == "step":
            raise ModelError(
                f"prescribe '{self.name}': a table of steps jumps, which requires an infinite force; use a linear or "
                "cubic table, or fx.Ramp"
            )
        to.motions[self.name] = as_function(self.motion, f"prescribe '{self.name}'")
        to.actuators[self.name] = self._actuators(to)

    def _actuators(self, to: Lowering) -> tuple[str, ...]:
        """Return the names of the actuators, checked."""
        found = names(self.actuators, f"prescribe '{self.name}': actuators")
        for name in found:
            to.quantity_kind(name, f"prescribe '{self.name}': actuator")
        return found


@part
class Independent(Part[None]):
    """Name dynamic degrees of freedom q_d; the program chooses those that are missing, or all by default.

    Named ones are used as long as they determine the position.
    """

    names: tuple[str, ...] = entry("Coordinates or deformations.", spread=True)

    def lower(self, to: Lowering) -> None:
        """Note the names."""
        _check_dofs(to, "independent", self.names)
        to.dynamic = [*(to.dynamic or []), *self.names]


@part
class Kinematic(Part[None]):
    """Name kinematic coordinates q_k of a non-holonomic system; the program chooses those that are missing."""

    names: tuple[str, ...] = entry("Coordinates or deformations.", spread=True)

    def lower(self, to: Lowering) -> None:
        """Note the names."""
        _check_dofs(to, "kinematic", self.names)
        to.kinematic = [*(to.kinematic or []), *self.names]


def _check_dofs(to: Lowering, owner: str, names: tuple[str, ...]) -> None:
    """Check that names belong to coordinates and deformations."""
    for name in names:
        if to.quantity_kind(name, owner) == "slip":
            raise ModelError(
                f"{owner}: '{name}' is a slip, not a degree of freedom; name movable coordinates or deformations"
            )


@part
class Initial(Part[None]):
    """Set the initial value and rate of a coordinate or deformation (a slip: rate only).

    Where the given rates and the prescribed motions leave a choice, springs and elastic parts keep their lengths: a
    machine whose drive runs at the start runs as a whole.  ``start=system.at_rest`` starts it from rest instead, with
    the impulse of its drive.
    """

    name: str = entry("The coordinate, deformation or slip.")
    value: float | None = array_quantity("", "Initial value, in the unit of the quantity.", default=None)
    rate: float | None = array_quantity(
        "", "Initial rate, in the unit of the quantity per second.", default=None
    )

    @property
    def label(self) -> str:
        """By its quantity, which other parts may act on."""
        return f"initial {self.name}"

    def lower(self, to: Lowering) -> None:
        """Note the values."""
        kind = to.quantity_kind(self.name, "initial")
        if self.value is None and self.rate is None:
            raise ModelError(f"{self.owner}: neither a value nor a rate; give one of them")
        if self.value is not None and kind == "slip":
            raise ModelError(f"{self.owner}: a slip has only a rate; give rate= alone")
        if self.value is not None:
            to.values[self.name] = number(self.value, self.owner, "value")
        if self.rate is not None:
            to.rates[self.name] = number(self.rate, self.owner, "rate")
