"""The model as the user declares it: nodes, elements, roles, loads, initial values; `build` makes a System.

Everything has a name, and every name works everywhere.  Quantities are called ``node.coordinate``,
``element.deformation`` and ``element.slip``.  SI units, radians, right-handed frames.
Imports numpy and the rooms that turn a declaration into index maps; the mathematics lives elsewhere.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel import beams, bodies, couplings, curves, feedback, joints, loads, springs, user, wheels
from flexel.build import build
from flexel.derive.spec import ElementSpec
from flexel.errors import ModelError
from flexel.functions import TimeFunction, as_function
from flexel.generated.table import ELEMENTS
from flexel.inputs import array, new_name, number, quantities, vector
from flexel.rope import cable_lines, cables, contacts, ropes, surfaces
from flexel.rope.surfaces import Surface
from flexel.structure import COMPONENTS, Array, Instance, LawInstance, Node, unknown
from flexel.system import System

Vector = Sequence[float] | Array
PLANAR = {"point": "planar_point", "frame": "planar_angle", "slope": "planar_slope"}


class Model:
    """A mechanism to be declared.

    Parameters
    ----------
    gravity : sequence of float (3,) or (2,)
        Acceleration of gravity [m/s²]; of three components the first two serve planar elements.

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
        g = array(gravity, "Model", "gravity")
        self.gravity = vector(g, "Model", "gravity", 2 if g.shape == (2,) else 3)
        self.nodes: dict[str, Node] = {}
        self.instances: dict[str, Instance] = {}
        self.laws: list[LawInstance] = []
        self.surfaces: dict[str, Surface] = {}
        self.loads: list[loads.Load] = []
        self.motions: dict[str, TimeFunction] = {}
        self.roles: dict[str, str] = {}  # "rigid" or "free", as the user said
        self.dynamic: list[str] | None = None
        self.kinematic_names: list[str] | None = None
        self.values: dict[str, float] = {}
        self.rates: dict[str, float] = {}

    # -- nodes -----------------------------------------------------------------------------------

    def point(self, name: str, position: Vector, fixed: bool = False) -> Node:
        """A position node at (x, y, z) [m], or (x, y) in a planar model.

        Raises
        ------
        ModelError
            Double name, coordinates that are not two or three finite numbers.
        """
        owner = f"point '{name}'"
        x0 = array(position, owner, "position")
        planar = x0.shape == (2,)
        x0 = vector(x0, owner, "position", 2 if planar else 3)
        return self._node(name, "planar_point" if planar else "point", x0, fixed)

    def frame(self, name: str, orientation: Vector = (1.0, 0.0, 0.0, 0.0), fixed: bool = False) -> Node:
        """An orientation node with Euler parameters (λ0, λ1, λ2, λ3) of norm one.

        See Also
        --------
        flexel.orientation.turn : Euler parameters of a turn about an axis.
        """
        owner = f"frame '{name}'"
        x0 = vector(orientation, owner, "orientation", 4)
        norm = float(np.linalg.norm(x0))
        if abs(norm - 1) > 1e-6:
            raise ModelError(f"{owner}: Euler parameters {x0.tolist()} have norm {norm:g}; divide them by it")
        return self._node(name, "frame", x0 / norm, fixed)

    def angle(self, name: str, value: float = 0.0, fixed: bool = False) -> Node:
        """An orientation node of a planar model, an angle [rad]."""
        return self._node(name, "planar_angle", np.array([number(value, f"angle '{name}'", "value")]), fixed)

    slope = cables.slope

    def _node(self, name: str, kind: str, x0: Array, fixed: bool) -> Node:
        self._new_name(name, kind)
        node = Node(name, kind, x0, np.full(x0.size, bool(fixed)))
        self.nodes[name] = node
        return node

    def _new_name(self, name: str, kind: str) -> None:
        new_name(name, kind)
        if name in self.nodes or name in self.instances:
            raise ModelError(f"{kind} '{name}': this name is taken; choose another")

    def node(self, node: Node | str, owner: str) -> Node:
        """The node of that name, or a node of this model; a ModelError that names the owner otherwise."""
        if not isinstance(node, (Node, str)):
            raise ModelError(f"{owner}: {node!r} is not a node; give its name, or what m.point(…) returned")
        name = node.name if isinstance(node, Node) else node
        if name not in self.nodes:
            raise ModelError(f"{owner}: {unknown(name, self.nodes, 'node')}")
        found = self.nodes[name]
        if isinstance(node, Node) and node.x0 is not found.x0:
            raise ModelError(
                f"{owner}: the node '{name}' belongs to another model; use the nodes of this one"
            )
        return found

    def of_kind(self, node: Node | str, kinds: tuple[str, ...], owner: str) -> Node:
        """The named node, if it is of one of the kinds; a ModelError that names the owner otherwise."""
        found = self.node(node, owner)
        if found.kind not in kinds:
            raise ModelError(
                f"{owner}: node '{found.name}' is a {found.kind}; it needs a {' or '.join(kinds)}"
            )
        return found

    def resolve(self, owner: str, *nodes: tuple[Node | str, str]) -> tuple[bool, list[Node]]:
        """Nodes of the asked kinds, all spatial or all planar, and whether they are planar."""
        planar = self.node(nodes[0][0], owner).kind.startswith("planar")
        return planar, [self.of_kind(n, (PLANAR[k] if planar else k,), owner) for n, k in nodes]

    # -- elements --------------------------------------------------------------------------------

    def add(
        self, name: str, element: str, nodes: Sequence[Node | str], parameters: Mapping[str, Any]
    ) -> None:
        """An element of the table by its type, with its parameters as the kernels take them.

        The methods below are more comfortable; this one serves types that have no method.
        """
        if element not in ELEMENTS:
            raise ModelError(f"'{name}': {unknown(str(element), ELEMENTS, 'element type')}")
        self.place(name, ELEMENTS[element], nodes, parameters)

    def place(
        self,
        name: str,
        spec: ElementSpec,
        nodes: Sequence[Node | str],
        parameters: Mapping[str, Any],
        kernels: object = None,
    ) -> None:
        """An element of this specification; `kernels` is the address of a user's own, none for a built-in one."""
        self._new_name(name, spec.name)
        owner = f"{spec.name} '{name}'"
        if isinstance(nodes, str) or len(nodes) != len(spec.nodes):
            ends = ", ".join(f"{z.name} ({z.kind})" for z in spec.nodes)
            raise ModelError(f"{owner}: its nodes are {nodes!r}; give a list of {len(spec.nodes)}: {ends}")
        members = [self.of_kind(n, (z.kind,), owner) for n, z in zip(nodes, spec.nodes, strict=True)]
        sizes = {z.name: z.size for z in spec.parameters}
        wrong = sorted((sizes.keys() ^ parameters.keys()) - {"gravity"})
        if wrong:
            raise ModelError(
                f"{owner}: parameter(s) {', '.join(wrong)} missing or unknown; it takes {', '.join(sizes)}"
            )
        values = dict(parameters)
        if "gravity" in sizes and (kernels is None or "gravity" not in parameters):
            values["gravity"] = self.gravity[: sizes["gravity"]]
        if kernels is not None:
            values = {z: array(values[z], owner, f"parameter {z}").reshape(-1) for z in sizes}
        instance = Instance(name, spec, tuple(n.name for n in members), values, kernels)
        _ = instance.p  # checks sizes and finiteness now, where the caller can see it
        self.instances[name] = instance

    point_mass = bodies.point_mass
    body = bodies.body
    truss = joints.truss
    hinge = joints.hinge
    bearing = joints.bearing
    fixed_point = joints.fixed_point
    wheel = wheels.wheel
    tyre = wheels.tyre
    axle_slip = wheels.axle_slip
    beam = beams.beam
    cable = cables.cable
    cable_line = cable_lines.cable_line
    clamp_slope = cables.clamp_slope
    anchor = cables.anchor
    sheave = surfaces.sheave
    plane = surfaces.plane
    contact = contacts.contact
    rope = ropes.rope
    element = user.element
    belt = couplings.belt
    gears = couplings.gears
    surface = couplings.surface
    planar_wheel = couplings.planar_wheel
    rotary_inertia = couplings.rotary_inertia

    linear_law = springs.linear_law
    spring = springs.spring
    viscous = springs.viscous
    mass_damping = springs.mass_damping
    law = springs.law
    feedback = feedback.feedback
    attach = springs.attach
    spring_curve = curves.spring_curve
    damper_curve = curves.damper_curve
    stop = curves.stop

    # -- roles -----------------------------------------------------------------------------------

    def fix(self, *names: Node | str) -> None:
        """Hold nodes or single coordinates at their drawn values."""
        for given in names:
            node, _, component = given.partition(".") if isinstance(given, str) else (given, "", "")
            if isinstance(node, str) and node in self.instances:
                raise ModelError(
                    f"fix: '{node}' is an element; hold its deformations with m.rigid('{node}.…')"
                )
            target = self.node(node, "fix")
            components = COMPONENTS[target.kind]
            if component and component not in components:
                raise ModelError(
                    f"fix: node '{target.name}' has no coordinate '{component}'; it has {', '.join(components)}"
                )
            held = target.fixed | np.array([not component or c == component for c in components])
            self.nodes[target.name] = replace(target, fixed=held)

    def release(self, *names: str) -> None:
        """Make deformations or slips free: no constraint, stress from laws and loads only."""
        self.roles.update(dict.fromkeys(quantities(names, "release"), "free"))

    def rigid(self, *names: str) -> None:
        """Hold deformations (or slips) at zero."""
        self.roles.update(dict.fromkeys(quantities(names, "rigid"), "rigid"))

    def prescribe(self, name: str, motion: Any) -> None:
        """Give a coordinate or deformation a motion u(t), in place of any that it had been given before.

        Parameters
        ----------
        motion : number, callable, triple of callables, or Ramp, Harmonic, Polynomial, Table
            A callable is called with a second-order jet: operators and NumPy functions give u, u' and u''.
        """
        quantities([name], "prescribe")
        self.motions[name] = as_function(motion, f"prescribe '{name}'")

    def independent(self, *names: str) -> None:
        """Name the dynamic freedoms q_d; without any, the program chooses."""
        self.dynamic = [*(self.dynamic or []), *quantities(names, "independent")]

    def kinematic(self, *names: str) -> None:
        """Name the kinematic freedoms q_k of a non-holonomic system; without any, the program chooses."""
        self.kinematic_names = [*(self.kinematic_names or []), *quantities(names, "kinematic")]

    def initial(self, name: str, value: float | None = None, rate: float | None = None) -> None:
        """Initial value and rate of a coordinate or deformation (a slip: rate only).

        Rates that nothing given determines are zero for the freedoms; name these with `independent`, or give
        enough rates, where it matters which they are.
        """
        owner = f"initial '{name}'"
        quantities([name], "initial")
        if value is None and rate is None:
            raise ModelError(f"{owner}: neither a value nor a rate; give one of them")
        if value is not None:
            self.values[name] = number(value, owner, "value")
        if rate is not None:
            self.rates[name] = number(rate, owner, "rate")

    load = loads.load
    distributed_load = loads.distributed_load
    angular_velocity = loads.angular_velocity

    # -- finish ----------------------------------------------------------------------------------

    def build(self, t: float = 0.0) -> System:
        """Count, check and assemble: the System at time t [s], in a consistent initial state.

        Raises
        ------
        ModelError
            Unknown names, contradicting roles.
        ConstraintError
            Over- or under-constrained, named by deformations or coordinates.
        PositionError
            Initial values that the constraints do not admit.
        """
        return build(self, t)
