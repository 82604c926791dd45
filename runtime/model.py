"""The model as the user declares it: nodes, elements, roles, loads, initial values; `build` makes a System.

Everything has a name, and every name works everywhere.  Quantities are called ``node.coordinate``,
``element.deformation`` and ``element.slip``.  SI units, radians, right-handed frames.
Imports numpy and the rooms that turn a declaration into index maps; the mathematics lives elsewhere.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel import beams, bodies, joints
from flexel.build import build
from flexel.checks import not_negative
from flexel.errors import ModelError
from flexel.functions import TimeFunction, as_function
from flexel.generated.table import ELEMENTS, LAWS
from flexel.laws import formula_law
from flexel.loads import Load
from flexel.orientation import vector
from flexel.structure import COMPONENTS, Array, Instance, LawInstance, Node, unknown
from flexel.system import System

Vector = Sequence[float] | Array
PLANAR = {"point": "planar_point", "frame": "planar_angle"}


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
        g = np.asarray(gravity, dtype=float)
        self.gravity = vector(g, "Model", "gravity", 2 if g.shape == (2,) else 3)
        self.nodes: dict[str, Node] = {}
        self.instances: dict[str, Instance] = {}
        self.laws: list[LawInstance] = []
        self.loads: list[Load] = []
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
        size = len(np.atleast_1d(np.asarray(position)))
        x0 = vector(position, f"point '{name}'", "position", 2 if size == 2 else 3)
        return self._node(name, "planar_point" if size == 2 else "point", x0, fixed)

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
            raise ModelError(f"{owner}: Euler parameters {tuple(x0)} have norm {norm:g}; divide them by it")
        return self._node(name, "frame", x0 / norm, fixed)

    def angle(self, name: str, value: float = 0.0, fixed: bool = False) -> Node:
        """An orientation node of a planar model, an angle [rad]."""
        return self._node(name, "planar_angle", vector([value], f"angle '{name}'", "value", 1), fixed)

    def _node(self, name: str, kind: str, x0: Array, fixed: bool) -> Node:
        self._new_name(name, kind)
        node = Node(name, kind, x0, np.full(x0.size, bool(fixed)))
        self.nodes[name] = node
        return node

    def _new_name(self, name: str, kind: str) -> None:
        if not isinstance(name, str) or not re.fullmatch(r"[^\s.':][^.':]*", name):
            raise ModelError(
                f"{kind} {name!r}: a name is text without dots, colons or quotes; choose another"
            )
        if name in self.nodes or name in self.instances:
            raise ModelError(f"{kind} '{name}': this name is taken; choose another")

    def of_kind(self, node: Node | str, kinds: tuple[str, ...], owner: str) -> Node:
        """The named node, if it is of one of the kinds; a ModelError that names the owner otherwise."""
        name = node.name if isinstance(node, Node) else node
        if name not in self.nodes:
            raise ModelError(f"{owner}: {unknown(name, self.nodes, 'node')}")
        found = self.nodes[name]
        if found.kind not in kinds:
            raise ModelError(f"{owner}: node '{name}' is a {found.kind}; it needs a {' or '.join(kinds)}")
        return found

    def resolve(self, owner: str, *nodes: tuple[Node | str, str]) -> tuple[bool, list[Node]]:
        """Nodes of the asked kinds, all spatial or all planar, and whether they are planar."""
        first = nodes[0][0]
        name = first.name if isinstance(first, Node) else first
        planar = name in self.nodes and self.nodes[name].kind.startswith("planar")
        return planar, [self.of_kind(n, (PLANAR[k] if planar else k,), owner) for n, k in nodes]

    # -- elements --------------------------------------------------------------------------------

    def add(
        self, name: str, element: str, nodes: Sequence[Node | str], parameters: Mapping[str, Any]
    ) -> None:
        """An element of the table by its type, with its parameters as the kernels take them.

        The methods below are more comfortable; this one serves types that have no method.
        """
        self._new_name(name, element)
        if element not in ELEMENTS:
            raise ModelError(f"'{name}': {unknown(element, ELEMENTS, 'element type')}")
        spec = ELEMENTS[element]
        kinds = [(n, (s.kind,)) for n, s in zip(nodes, spec.nodes, strict=True)]
        members = [self.of_kind(n, k, f"{element} '{name}'") for n, k in kinds]
        values = {z.name: np.zeros(z.size) for z in spec.parameters} | dict(parameters)
        if "gravity" in values:
            values["gravity"] = self.gravity[: values["gravity"].size]
        instance = Instance(name, spec, tuple(n.name for n in members), values)
        _ = instance.p  # checks sizes and finiteness now, where the caller can see it
        self.instances[name] = instance

    point_mass = bodies.point_mass
    body = bodies.body
    truss = joints.truss
    hinge = joints.hinge
    bearing = joints.bearing
    fixed_point = joints.fixed_point
    wheel = joints.wheel
    beam = beams.beam

    # -- laws ------------------------------------------------------------------------------------

    def linear_law(self, names: Sequence[str], S: Any, D: Any = None, preload: Any = None) -> None:
        """Linear elastic law with damping, σ = preload + S e + D ė, on up to six deformations, which become free."""
        m = len(names)
        upper = np.triu_indices(m)
        S = np.asarray(S, dtype=float).reshape(m, m)
        D = np.zeros((m, m)) if D is None else np.asarray(D, dtype=float).reshape(m, m)
        s0 = np.zeros(m) if preload is None else np.asarray(preload, dtype=float)
        spec = LAWS[f"linear_{m}"]
        values = {"preload": s0, "S": S[upper], "D": D[upper]}
        self._law(LawInstance(" ".join(names), spec, tuple(names), (), values))

    def spring(self, name: str, stiffness: float, damping: float = 0.0, preload: float = 0.0) -> None:
        """A linear spring and damper on one deformation: σ = preload + stiffness e + damping ė."""
        owner = f"spring on '{name}'"
        not_negative(stiffness, owner, "stiffness")
        not_negative(damping, owner, "damping")
        self.linear_law([name], [[stiffness]], [[damping]], [preload])

    def viscous(self, name: str, damping: float) -> None:
        """Viscous resistance on one slip, τ = damping s; the slip becomes free."""
        values = {"C": np.array([not_negative(damping, f"damper on '{name}'", "damping")])}
        self._law(LawInstance(name, LAWS["viscous_1"], (), (name,), values))

    def law(self, name: str, stress: Callable[..., Any], energy: Callable[..., Any] | None = None) -> None:
        """A nonlinear spring given by a formula: σ = stress(e, ė) on one deformation.

        Parameters
        ----------
        stress : callable(e, ed)
            Called once with SymPy symbols; returns an expression.  Its tangent is derived and compiled.
        energy : callable(e), optional
            Stored energy [J]; the integral of the elastic part by default, where SymPy finds it.

        Raises
        ------
        FlexelError
            If no C compiler is found (only user-defined laws and elements need one), or the formula is not smooth.

        Examples
        --------
        >>> m.law("strut.elongation", lambda e, ed: 2e4 * e + 3e6 * e**3 + 40 * ed)  # doctest: +SKIP
        """
        compiled = formula_law(name, stress, energy)
        self._law(LawInstance(name, compiled.spec, (name,), (), {}, compiled.address))

    def _law(self, instance: LawInstance) -> None:
        self.laws.append(instance)

    # -- roles -----------------------------------------------------------------------------------

    def fix(self, *names: Node | str) -> None:
        """Hold nodes or single coordinates at their drawn values."""
        for given in names:
            name = given.name if isinstance(given, Node) else given
            node, _, component = name.partition(".")
            if node not in self.nodes:
                raise ModelError(f"fix: {unknown(node, self.nodes, 'node')}")
            target = self.nodes[node]
            components = COMPONENTS[target.kind]
            if component and component not in components:
                raise ModelError(
                    f"fix: node '{node}' has no coordinate '{component}'; it has {', '.join(components)}"
                )
            held = target.fixed | np.array([not component or c == component for c in components])
            self.nodes[node] = replace(target, fixed=held)

    def release(self, *names: str) -> None:
        """Make deformations or slips free: no constraint, stress from laws and loads only."""
        self.roles.update(dict.fromkeys(names, "free"))

    def rigid(self, *names: str) -> None:
        """Hold deformations (or slips) at zero."""
        self.roles.update(dict.fromkeys(names, "rigid"))

    def prescribe(self, name: str, motion: Any) -> None:
        """Give a coordinate or deformation a motion u(t).

        Parameters
        ----------
        motion : number, callable, triple of callables, or Ramp, Harmonic, Polynomial, Table
            A callable is called with a second-order jet: operators and NumPy functions give u, u' and u''.
        """
        self.motions[name] = as_function(motion, f"prescribe '{name}'")

    def independent(self, *names: str) -> None:
        """Name the dynamic freedoms q_d; without any, the program chooses."""
        self.dynamic = [*(self.dynamic or []), *names]

    def kinematic(self, *names: str) -> None:
        """Name the kinematic freedoms q_k of a non-holonomic system; without any, the program chooses."""
        self.kinematic_names = [*(self.kinematic_names or []), *names]

    def initial(self, name: str, value: float | None = None, rate: float | None = None) -> None:
        """Initial value and rate of a coordinate or deformation (a slip: rate only)."""
        owner = f"initial '{name}'"
        if value is not None:
            self.values[name] = float(vector([value], owner, "value", 1)[0])
        if rate is not None:
            self.rates[name] = float(vector([rate], owner, "rate", 1)[0])

    # -- loads -----------------------------------------------------------------------------------

    def load(self, target: Node | str, value: Any, *, follower: bool = False) -> None:
        """A force, moment or generalized force, constant or a function of time.

        Parameters
        ----------
        target : node or name
            A point takes a force vector [N]; a frame a moment vector [N m] about global axes (with
            ``follower=True`` about body axes); a coordinate, deformation or slip a generalized force, positive when
            it does positive work as the quantity grows.
        value : number or function of time, or a sequence of them for a node
        """
        name = target.name if isinstance(target, Node) else target
        owner = f"load on '{name}'"
        if name not in self.nodes:
            self.loads.append(Load(name, as_function(value, owner)))
            return
        node = self.nodes[name]
        if follower and node.kind != "frame":
            raise ModelError(f"{owner}: follower loads act on frames; '{name}' is a {node.kind}")
        if node.kind == "frame":
            names = [f"{self._sensor(node, follower)}.{w}" for w in ("wx", "wy", "wz")]
        else:
            names = list(node.coordinates)
        values = [value] if len(names) == 1 and not isinstance(value, (list, tuple)) else list(value)
        if len(values) != len(names):
            raise ModelError(f"{owner}: {len(values)} components given; it takes {len(names)}")
        for quantity, component in zip(names, values, strict=True):
            if callable(component) or isinstance(component, TimeFunction) or component != 0:
                self.loads.append(Load(quantity, as_function(component, owner)))

    def _sensor(self, frame: Node, body_axes: bool) -> str:
        """The element that measures (and so can load) a frame's angular velocity; made when first needed."""
        name = f"{frame.name}.{'body_omega' if body_axes else 'omega'}"
        if name not in self.instances:
            spec = ELEMENTS["body_rotation" if body_axes else "rotation"]
            values = {z.name: np.array([1.0, 0.0, 0.0, 0.0]) for z in spec.parameters}
            self.instances[name] = Instance(name, spec, (frame.name,), values)
        return name

    def angular_velocity(self, frame: Node | str, body_axes: bool = False) -> str:
        """Measure a frame's angular velocity; its components are the slips ``<returned name>.wx``, ``wy``, ``wz``."""
        node = self.of_kind(frame, ("frame",), "angular_velocity")
        return self._sensor(node, body_axes)

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
