"""The model as the user declares it: a list of parts; `build` makes a System.

Everything has a name, and every name works everywhere.  Quantities are called ``node.coordinate``,
``element.deformation`` and ``element.slip``.  SI units, radians, right-handed frames.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, TypeVar

from flexel.apps.view.thumbnail import thumbnail
from flexel.base.arguments import unknown
from flexel.base.arrays import Array, Vector
from flexel.base.blas import in_one_thread
from flexel.base.errors import FlexelError, ModelError
from flexel.base.shown import PrintedTable, counted, prints
from flexel.compile import build
from flexel.mechanics.findings import CheckReport
from flexel.model.applied_loads import Load
from flexel.model.constraints import ConstraintReport
from flexel.model.controller import Controller
from flexel.model.instances import Instance, LawInstance
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.origin import Origin, labels_of
from flexel.model.part import Part, by_name
from flexel.model.surfaces import Surface
from flexel.parts.beams import Beam
from flexel.parts.bodies import Body, PointMass
from flexel.parts.body_joints import (
    Cylindrical,
    PlanarJoint,
    Prismatic,
    Revolute,
    Screw,
    Spherical,
    Universal,
    Weld,
)
from flexel.parts.cable_lines import CableLinePart
from flexel.parts.cables import Anchor, Cable, Clamp, Slope
from flexel.parts.cams import Cam
from flexel.parts.chains import ChainPart
from flexel.parts.controllers import ControllerPart
from flexel.parts.couplings import PlanarBelt, PlanarGear, PlanarWheel, Quadric, RotaryInertia
from flexel.parts.elements import ElementPart
from flexel.parts.friction import Clearance, Friction, Limits
from flexel.parts.gearing import Belt, CardanChain, Gear, RackAndPinion
from flexel.parts.joints import Bearing, BodyPoint, Hinge, Truss
from flexel.parts.laws import AttachedLaw, LawPart
from flexel.parts.leaf_springs import LeafSpring
from flexel.parts.loads import AngularVelocity, DistributedLoad, LoadPart
from flexel.parts.looks import LookPart
from flexel.parts.method import Method, declares
from flexel.parts.model_file import write_model
from flexel.parts.model_program import program
from flexel.parts.nodes import Angle, Frame, Point, Warping
from flexel.parts.other_words import no_call
from flexel.parts.point_contacts import PointContact
from flexel.parts.relations import Relation
from flexel.parts.rigid_bodies import RigidBodyPart
from flexel.parts.roles import Fix, Independent, Initial, Kinematic, Prescribe, Release, Rigid
from flexel.parts.rope_contacts import RopeContact
from flexel.parts.rope_surfaces import Plane, Sheave
from flexel.parts.ropes import RopePart
from flexel.parts.skates import Skate
from flexel.parts.springs import MassDamping, Spring, Stop
from flexel.parts.wheels import AxleSlip, Tyre, Waves, Wheel
from flexel.results.analyses.model_check import check, report_of_model
from flexel.results.system_facade import System

if TYPE_CHECKING:
    from flexel.derive.compiled import CompiledElement, CompiledLaw

Made = TypeVar("Made")


class Model:
    """A mechanism, declared as a list of parts.

    Parameters
    ----------
    gravity : sequence of float (3,) or (2,)
        Acceleration of gravity [m/s²]; planar elements use the first two components.

    Attributes
    ----------
    parts : tuple of Part
        The parts as declared, in order, with names in place of nodes, bodies, surfaces and ropes.
    lowering : Lowering
        The nodes, elements, laws, loads and roles that follow from the parts.

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

    def __init__(self, gravity: Vector = (0.0, 0.0, 0.0)) -> None:
        self.lowering = Lowering(gravity)
        self._parts: list[Part[Any]] = []
        self._first_laws: list[int] = []  # of each part, how many laws there were before it

    if not TYPE_CHECKING:  # type checkers know that there are no other names

        def __getattr__(self, name: str) -> Any:
            """Say what the model calls it."""
            raise AttributeError(no_call(name, dir(type(self))))

    def add(self, part: Part[Made]) -> Made:
        """Add a part, built in or user-defined; if it is refused, the model is unchanged.

        Returns
        -------
        The object that the part creates: a node, a rigid body, a rope, or None.

        Raises
        ------
        ModelError
            As the method of that name, such as `beam`.
        """
        if not isinstance(part, Part):
            raise ModelError(f"add: {part!r:.60} is not a part; give one, such as fx.parts.Beam(…)")
        first = len(self.lowering.laws)
        made = self.lowering.add(part)
        self._parts.append(by_name(part))
        self._first_laws.append(first)
        return made

    @classmethod
    def of(cls, gravity: Vector, parts: Iterable[Part[Any]]) -> Self:
        """Make a model of given parts, such as all but one of another model.

        Examples
        --------
        >>> lighter = fx.Model.of(m.gravity, [part for part in m.parts if part is not m["rider"]])  # doctest: +SKIP
        """
        if not isinstance(parts, Iterable):
            raise ModelError(
                f"Model.of: {parts!r:.60} is not a list of parts; give the parts of a model, m.parts"
            )
        found = cls(gravity)
        for part in parts:
            found.add(part)
        return found

    point = Method(Point)
    frame = Method(Frame)
    angle = Method(Angle)
    slope = Method(Slope)
    warping = Method(Warping)

    rigid_body = Method(RigidBodyPart)
    body = Method(Body)
    point_mass = Method(PointMass)
    rotary_inertia = Method(RotaryInertia)

    beam = Method(Beam)
    leaf_spring = Method(LeafSpring)
    truss = Method(Truss)
    body_point = Method(BodyPoint)

    hinge = Method(Hinge)
    bearing = Method(Bearing)
    revolute = Method(Revolute)
    prismatic = Method(Prismatic)
    cylindrical = Method(Cylindrical)
    screw = Method(Screw)
    planar_joint = Method(PlanarJoint)
    spherical = Method(Spherical)
    universal = Method(Universal)
    weld = Method(Weld)
    cardan_chain = Method(CardanChain)

    gear = Method(Gear)
    planar_gear = Method(PlanarGear)
    rack_and_pinion = Method(RackAndPinion)
    belt = Method(Belt)
    planar_belt = Method(PlanarBelt)
    cam = Method(Cam)
    relation = Method(Relation)
    quadric = Method(Quadric)

    wheel = Method(Wheel)
    planar_wheel = Method(PlanarWheel)
    axle_slip = Method(AxleSlip)
    skate = Method(Skate)

    spring = Method(Spring)
    stop = Method(Stop)
    limits = Method(Limits)
    clearance = Method(Clearance)
    friction = Method(Friction)
    mass_damping = Method(MassDamping)
    controller = Method(ControllerPart)

    load = Method(LoadPart)
    distributed_load = Method(DistributedLoad)
    angular_velocity = Method(AngularVelocity)

    cable = Method(Cable)
    cable_line = Method(CableLinePart)
    clamp = Method(Clamp)
    anchor = Method(Anchor)
    chain = Method(ChainPart)
    rope = Method(RopePart)
    sheave = Method(Sheave)
    plane = Method(Plane)
    rope_contact = Method(RopeContact)
    contact = Method(PointContact)

    prescribe = Method(Prescribe)
    initial = Method(Initial)
    look = Method(LookPart)

    # Calls that take any number of names, nodes or parameters.

    @declares(Fix)
    def fix(self, *names: Node | str) -> None:
        """Fix nodes or single coordinates at their drawn values."""
        self.add(Fix(names))

    @declares(Release)
    def release(self, *names: str) -> None:
        """Make deformations or slips free."""
        self.add(Release(names))

    @declares(Rigid)
    def rigid(self, *names: str) -> None:
        """Hold deformations (or slips) at zero."""
        self.add(Rigid(names))

    @declares(Independent)
    def independent(self, *names: str) -> None:
        """Name dynamic degrees of freedom."""
        self.add(Independent(names))

    @declares(Kinematic)
    def kinematic(self, *names: str) -> None:
        """Name kinematic coordinates of a non-holonomic system."""
        self.add(Kinematic(names))

    @declares(ElementPart)
    def element(
        self, name: str, kind: str | CompiledElement, /, *nodes: Node | str, **parameters: Any
    ) -> None:
        """Add an element by its type."""
        self.add(ElementPart(name, kind, nodes, parameters))

    @declares(AttachedLaw)
    def attach(
        self,
        law: str,
        on: Sequence[str] | Mapping[str, str],
        *,
        name: str | None = None,
        initial: Mapping[str, float] | None = None,
        **parameters: Any,
    ) -> None:
        """Attach a built-in law of several deformations and slips together."""
        self.add(AttachedLaw(law, on, name=name, initial=initial, parameters=parameters))

    @declares(LawPart)
    def law(
        self,
        on: str | Sequence[str] | Mapping[str, str],
        law: CompiledLaw | Callable[..., Any],
        *,
        energy: Callable[..., Any] | None = None,
        ranges: Mapping[str, tuple[float, float]] | None = None,
        name: str | None = None,
        initial: Mapping[str, float] | None = None,
        **parameters: Any,
    ) -> None:
        """Attach a user-defined law."""
        self.add(
            LawPart(on, law, energy=energy, ranges=ranges, name=name, initial=initial, parameters=parameters)
        )

    @declares(Tyre)
    def tyre(
        self,
        name: str,
        hub: Node | str,
        frame: Node | str,
        *,
        radius: float,
        axle: Vector,
        normal: Vector = (0.0, 0.0, 1.0),
        height: float = 0.0,
        crown: float = 0.0,
        road: Waves | None = None,
        law: str | CompiledLaw | None = None,
        initial: Mapping[str, float] | None = None,
        **parameters: Any,
    ) -> None:
        """Put a compliant tyre on a wheel."""
        self.add(
            Tyre(
                name,
                hub,
                frame,
                radius=radius,
                axle=axle,
                normal=normal,
                height=height,
                crown=crown,
                road=road,
                law=law,
                initial=initial,
                parameters=parameters,
            )
        )

    # Contents of the model, and what is made of it.

    @property
    def parts(self) -> tuple[Part[Any], ...]:
        """The parts as declared, in order."""
        return tuple(self._parts)

    def __getitem__(self, name: str) -> Part[Any]:
        """Return the part with this name as declared: ``m["leaf"]``; a ModelError suggests similar names."""
        named = {label: part for part in self._parts if isinstance(label := getattr(part, "name", None), str)}
        if name not in named:
            raise ModelError(f"model: {unknown(str(name), named, 'part')}")
        return named[name]

    def program(self) -> str:
        """Write the Python program that builds the same model, bit for bit: ``print(m.program())``.

        Functions, compiled elements and laws appear under the names by which they are imported.

        Raises
        ------
        ModelError
            A lambda, a closure, or an object that no module holds, named by its part.
        """
        return program(self.gravity, self._parts)

    def save(self, path: str | Path) -> Path:
        """Save the parts of the model as JSON; `flexel.load` returns the same model.

        Raises
        ------
        ModelError
            As `program`; a suffix other than .json.
        FlexelError
            If the file cannot be written.
        """
        return write_model(self.gravity, self.parts, path)

    @property
    def gravity(self) -> Array:
        """Acceleration of gravity [m/s²]."""
        return self.lowering.gravity

    @property
    def nodes(self) -> Mapping[str, Node]:
        """All nodes by name."""
        return self.lowering.nodes

    @property
    def instances(self) -> Mapping[str, Instance]:
        """All elements by name."""
        return self.lowering.instances

    @property
    def surfaces(self) -> Mapping[str, Surface]:
        """Surfaces for ropes and points by name."""
        return self.lowering.surfaces

    @property
    def laws(self) -> Sequence[LawInstance]:
        """All laws, in the order of their declaration."""
        return self.lowering.laws

    @property
    def loads(self) -> Sequence[Load]:
        """All loads, in the order of their declaration."""
        return self.lowering.loads

    @property
    def controllers(self) -> Sequence[Controller]:
        """All controllers, in the order of their declaration."""
        return self.lowering.controllers

    @prints
    def __repr__(self) -> str:
        nodes, elements = self._counts()
        parts = [counted(n, kind) for kind, n in nodes.items()]
        parts += [f"{kind} × {n}" for kind, n in elements.items()]
        return f"Model({', '.join(parts) or 'empty'})"

    def _repr_html_(self) -> str:
        """Return counts, and a picture of the initial state; or the reason why there is none."""
        nodes, elements = self._counts()
        rows = [(kind, str(n)) for kind, n in (*nodes.items(), *elements.items())]
        rows += [(kind, str(len(some))) for kind, some in (("law", self.laws), ("load", self.loads)) if some]
        try:
            shown = thumbnail(self.build().initial) if rows else ""
        except FlexelError as error:
            shown = f"<p>{escape(str(error))}</p>"
        return PrintedTable("" if rows else repr(self), ("model", "count"), rows).html + shown

    def _counts(self) -> tuple[Counter[str], Counter[str]]:
        """Return the numbers of nodes and of elements by kind."""
        nodes = Counter("point" if node.kind.endswith("point") else "frame" for node in self.nodes.values())
        return nodes, Counter(
            instance.spec.family or instance.spec.name for instance in self.instances.values()
        )

    @in_one_thread
    def build(self, t: float = 0.0) -> System:
        """Check and assemble the model; return the System at time t [s], in a consistent initial state.

        Raises
        ------
        ModelError
            Contradictory roles.
        ConstraintError
            An over- or under-constrained model; names the deformations or coordinates.
        PositionError
            Initial values that contradict the constraints.

        Warns
        -----
        AssemblyWarning
            If the drawing violates rigid conditions by more than a millionth of the size of the model: names them, and
            how far coordinates are moved to satisfy them.
        ModelWarning
            If a part is probably a mistake (a node without an element, a value that suggests a different unit): the
            findings of `check` that need no further computation.
        """
        system = build(self.lowering, t, System)
        labels = labels_of(self.parts, self._first_laws, self.lowering.laws)
        system.origin = Origin(self.gravity, self.parts, tuple(labels), float(t))
        return system

    def check(self) -> CheckReport:
        """Report everything that is wrong or suspicious in one table: ``print(m.check())``.

        Degrees of freedom with their names; redundant constraints and the smallest set to release; unresisted motions;
        missing masses; degenerate elements and unused nodes; drawings that violate rigid conditions; values that
        suggest a different unit (steel with E = 210); the condition of the chosen coordinates.

        Examples
        --------
        >>> print(m.check())  # doctest: +SKIP
        warning  units    beam 'leaf': Young's modulus E = 210 Pa looks like another unit; steel has 210e9 Pa
        note     freedom  1 degree(s) of freedom: 'pivot.angle'
        1 warning(s), 1 note(s)
        """
        return check(self.lowering, lambda: build(self.lowering, 0.0, System))

    def constraint_report(self) -> ConstraintReport:
        """Report over-constraint and under-constraint of the mechanism as drawn, counted and named.

        Unlike `build` it does not reject such a mechanism, and it needs no consistent initial values.

        Raises
        ------
        ModelError
            Contradictory roles.

        Examples
        --------
        >>> print(m.constraint_report())  # doctest: +SKIP
        1 degree(s) of freedom left by the rigid conditions
        over-constrained: 'a.bend1' 1.00, 'b.bend1' -1.00
        release 'a.bend1'
        alternatives to 'a.bend1': 'b.bend1'
        """
        return report_of_model(self.lowering)
