"""The model as the user declares it: nodes, elements, roles, loads, initial values; `build` makes a System.

Everything has a name, and every name works everywhere.  Quantities are called ``node.coordinate``,
``element.deformation`` and ``element.slip``.  SI units, radians, right-handed frames.
"""

from __future__ import annotations

from collections import Counter
from html import escape

from flexel.base.errors import FlexelError
from flexel.base.shown import Table, counted
from flexel.build import build
from flexel.declare.cams import Cams
from flexel.declare.controllers import Controllers
from flexel.declare.couplings import Couplings
from flexel.declare.gearing import Gearing
from flexel.declare.loads import Loading
from flexel.declare.looks import Looks
from flexel.declare.skates import Skates
from flexel.declare.user import Elements
from flexel.declare.wheels import Wheels
from flexel.mechanics.check import check
from flexel.mechanics.constraints import ConstraintReport, report_of_model
from flexel.mechanics.findings import CheckReport
from flexel.pictures.thumbnail import thumbnail
from flexel.rope.chains import Chains
from flexel.rope.point_contacts import PointContacts
from flexel.rope.ropes import Ropes
from flexel.system import System


class Model(
    Gearing,
    Cams,
    Skates,
    Ropes,
    PointContacts,
    Chains,
    Wheels,
    Couplings,
    Controllers,
    Loading,
    Elements,
    Looks,
):
    """A mechanism to be declared.

    Parameters
    ----------
    gravity : sequence of float (3,) or (2,)
        Acceleration of gravity [m/s²]; planar elements use the first two components.

    Examples
    --------
    A pendulum: a rod on a hinge.

    >>> import flexel as fx
    >>> m = fx.Model(gravity=(0, 0, -9.81))
    >>> O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (1, 0, 0))
    >>> R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
    >>> m.hinge("pivot", R0, R1, axis=(0, 1, 0))
    >>> m.beam("rod", O, R1, A, mass_per_length=2.0)
    >>> system = m.build()
    >>> system.dynamic
    ('pivot.angle',)
    """

    def __repr__(self) -> str:
        nodes, elements = self._counts()
        parts = [counted(n, kind) for kind, n in nodes.items()]
        parts += [f"{kind} × {n}" for kind, n in elements.items()]
        return f"Model({', '.join(parts) or 'empty'})"

    def _repr_html_(self) -> str:
        """Counts, and a picture of the initial state; or the reason why there is none."""
        nodes, elements = self._counts()
        rows = [(kind, str(n)) for kind, n in (*nodes.items(), *elements.items())]
        rows += [(what, str(len(z))) for what, z in (("law", self.laws), ("load", self.loads)) if z]
        try:
            shown = thumbnail(self.build().initial) if rows else ""
        except FlexelError as error:
            shown = f"<p>{escape(str(error))}</p>"
        return Table("" if rows else repr(self), ("model", "count"), rows).html + shown

    def _counts(self) -> tuple[Counter[str], Counter[str]]:
        """Numbers of nodes and of elements by kind."""
        nodes = Counter("point" if z.kind.endswith("point") else "frame" for z in self.nodes.values())
        return nodes, Counter(z.spec.family or z.spec.name for z in self.instances.values())

    def build(self, t: float = 0.0) -> System:
        """Count, check and assemble: the System at time t [s], in a consistent initial state.

        Raises
        ------
        ModelError
            Contradicting roles.
        ConstraintError
            Over- or under-constrained, named by deformations or coordinates.
        PositionError
            Initial values that contradict the constraints.

        Warns
        -----
        AssemblyWarning
            If the drawing contradicts rigid conditions, by more than a millionth of the size of the model: which, and
            how far coordinates are moved to meet them.
        ModelWarning
            If a part is probably a mistake (a node without an element, a number that suggests another unit): the
            findings of `check` that cost nothing.
        """
        return build(self, t)

    def check(self) -> CheckReport:
        """Report everything that is wrong or suspicious in one table: ``print(m.check())``.

        Degrees of freedom with their names; redundant constraints and the smallest set to release; unresisted motions;
        missing masses; degenerate elements and unused nodes; drawings that contradict rigid conditions; numbers that
        look like another unit (steel with E = 210); the condition of the chosen coordinates.

        Examples
        --------
        >>> print(m.check())  # doctest: +SKIP
        warning  units    beam 'leaf': Young's modulus E = 210 Pa looks like another unit; steel has 210e9 Pa
        note     freedom  1 degree(s) of freedom: 'pivot.angle'
        1 warning(s), 1 note(s)
        """
        return check(self, lambda: build(self, 0.0))

    def constraint_report(self) -> ConstraintReport:
        """Over-constraint and under-constraint of the mechanism as drawn, counted and named.

        Unlike `build` it does not reject such a mechanism, and it needs no consistent initial values.

        Raises
        ------
        ModelError
            Contradicting roles.

        Examples
        --------
        >>> print(m.constraint_report())  # doctest: +SKIP
        1 degree(s) of freedom left by the rigid conditions
        over-constrained: 'a.bend1' 1.00, 'b.bend1' -1.00
        release 'a.bend1'
        in place of 'a.bend1' equally well: 'b.bend1'
        """
        return report_of_model(self)
