"""Nodes and the roles of quantities: what is fixed, rigid, prescribed, independent, and initial values."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import array, number, vector
from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.base.time_functions import as_function
from flexel.base.time_tables import Table
from flexel.declare.declarations import Declarations
from flexel.structure.nodes import COMPONENTS, Node


class Nodes(Declarations):
    """Nodes and the roles of quantities."""

    def point(self, name: str, position: Vector, fixed: bool = False) -> Node:
        """A position node at (x, y, z) [m], or (x, y) in a planar model.

        Raises
        ------
        ModelError
            Duplicate name, coordinates that are not two or three finite numbers.
        """
        owner = f"point '{name}'"
        x0 = array(position, owner, "position")
        planar = x0.shape == (2,)
        x0 = vector(x0, owner, "position", 2 if planar else 3)
        return self._new_node(name, "planar_point" if planar else "point", x0, fixed)

    def frame(self, name: str, orientation: Vector = (1.0, 0.0, 0.0, 0.0), fixed: bool = False) -> Node:
        """An orientation node with Euler parameters (λ0, λ1, λ2, λ3) of norm one.

        See Also
        --------
        flexel.base.quaternions.turn : Euler parameters of a turn about an axis.
        """
        owner = f"frame '{name}'"
        x0 = vector(orientation, owner, "orientation", 4)
        norm = float(np.linalg.norm(x0))
        if abs(norm - 1) > 1e-6:
            raise ModelError(f"{owner}: Euler parameters {x0.tolist()} have norm {norm:g}; divide them by it")
        return self._new_node(name, "frame", x0 / norm, fixed)

    def angle(self, name: str, value: float = 0.0, fixed: bool = False) -> Node:
        """An orientation node of a planar model, an angle [rad]."""
        return self._new_node(
            name, "planar_angle", np.array([number(value, f"angle '{name}'", "value")]), fixed
        )

    def warping(self, name: str, fixed: bool = False) -> Node:
        """Warping of a section, for `beam`: its coordinate ``name.twist`` is the beam's twist per length [rad/m].

        Beams of the same section along one line share the node between them, where the warping is continuous.  Fixed
        where a support keeps the section plane (a clamp), and free otherwise.

        Raises
        ------
        ModelError
            Duplicate name.
        """
        return self._new_node(name, "warping", np.zeros(1), fixed)

    def fix(self, *names: Node | str) -> None:
        """Fix nodes or single coordinates at their drawn values; all of them or, if one is refused, none."""
        held: dict[str, Node] = {}
        for given in names:
            node, _, component = given.partition(".") if isinstance(given, str) else (given, "", "")
            if isinstance(node, str) and node in self.instances:
                if component:
                    self._quantity_kind(f"{node}.{component}", "fix")
                raise ModelError(
                    f"fix: '{node}' is an element; hold its deformations with m.rigid('{node}.{component or '…'}')"
                )
            found = self._find_node(node, "fix")
            components = COMPONENTS[found.kind]
            if component and component not in components:
                raise ModelError(
                    f"fix: node '{found.name}' has no coordinate '{component}'; it has {', '.join(components)}"
                )
            target = held.get(found.name, found)
            fixed = target.fixed | np.array([not component or c == component for c in components])
            held[found.name] = replace(target, fixed=fixed)
        self.nodes.update(held)

    def release(self, *names: str) -> None:
        """Make deformations or slips free: no constraint, stress from laws and loads only."""
        self._set_role("release", names, "free")

    def rigid(self, *names: str) -> None:
        """Hold deformations (or slips) at zero."""
        self._set_role("rigid", names, "rigid")

    def _set_role(self, owner: str, names: tuple[str, ...], role: str) -> None:
        """Give deformations or slips a role; all of them or, if one is refused, none."""
        for name in names:
            if self._quantity_kind(name, owner) == "coordinate":
                raise ModelError(
                    f"{owner}: '{name}' is a coordinate; rigid and free are roles of deformations and slips, use fix"
                )
        self._roles.update(dict.fromkeys(names, role))

    def prescribe(self, name: str, motion: Any) -> None:
        """Give a coordinate or deformation a motion u(t); replaces any given earlier.

        Parameters
        ----------
        motion : number, callable, triple of callables, or Ramp, Harmonic, Polynomial, Table
            A callable is called with a second-order jet: operators and NumPy functions give u, u' and u''.  A Table
            is of kind "cubic".
        """
        if self._quantity_kind(name, "prescribe") == "slip":
            raise ModelError(
                f"prescribe: '{name}' is a slip; only coordinates and deformations are prescribed"
            )
        if isinstance(motion, Table) and motion.kind == "step":
            raise ModelError(
                f"prescribe '{name}': a table of steps jumps, which takes an infinite force; use a linear or cubic "
                "table, or fx.Ramp"
            )
        self._motions[name] = as_function(motion, f"prescribe '{name}'")

    def independent(self, *names: str) -> None:
        """Name dynamic degrees of freedom q_d; the program chooses those that are missing, or all by default.

        Named ones are used as long as they determine the position.
        """
        self._dynamic = [*(self._dynamic or []), *self._named_dofs("independent", names)]

    def kinematic(self, *names: str) -> None:
        """Name kinematic coordinates q_k of a non-holonomic system; the program chooses those that are missing."""
        self._kinematic = [*(self._kinematic or []), *self._named_dofs("kinematic", names)]

    def _named_dofs(self, owner: str, names: tuple[str, ...]) -> tuple[str, ...]:
        """Names of coordinates and deformations."""
        for name in names:
            if self._quantity_kind(name, owner) == "slip":
                raise ModelError(
                    f"{owner}: '{name}' is a slip and not a degree of freedom; name movable coordinates or deformations"
                )
        return names

    def initial(self, name: str, value: float | None = None, rate: float | None = None) -> None:
        """Initial value and rate of a coordinate or deformation (a slip: rate only).

        Rates that are not determined by the given ones are set to zero for the degrees of freedom.  Where this choice
        matters, name these with `independent` or give enough rates.
        """
        owner = f"initial '{name}'"
        kind = self._quantity_kind(name, "initial")
        if value is None and rate is None:
            raise ModelError(f"{owner}: neither a value nor a rate; give one of them")
        if value is not None and kind == "slip":
            raise ModelError(f"{owner}: a slip has only a rate; give rate= alone")
        if value is not None:
            self._values[name] = number(value, owner, "value")
        if rate is not None:
            self._rates[name] = number(rate, owner, "rate")
