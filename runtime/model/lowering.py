"""Lowering: from the parts of a model to its nodes, elements, laws, loads, roles and initial values, by name.

Everything has a name, and every name works everywhere.  Quantities are called ``node.coordinate``,
``element.deformation`` and ``element.slip``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Protocol, TypeVar

import numpy as np

from flexel.base.arguments import array, flag, new_name, quantities, text, unknown, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.time_functions import TimeFunction
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.generated.table import ELEMENTS, LAWS
from flexel.model.applied_loads import Load
from flexel.model.controller import Controller
from flexel.model.handle import Handle
from flexel.model.instances import Code, Instance, LawInstance
from flexel.model.law_arguments import (
    check_arguments,
    check_units,
    initial_states,
    label_of,
    parameters_of_law,
)
from flexel.model.node import COMPONENTS, Node, unknown_quantity
from flexel.model.rigid_body import RigidBody
from flexel.model.signs import check_signs
from flexel.model.structure import Structure
from flexel.model.surfaces import Surface

Made = TypeVar("Made", covariant=True)
PLANAR = {"point": "planar_point", "frame": "planar_angle", "slope": "planar_slope"}


class Lowerable(Protocol[Made]):
    """Interface of a part, as far as the tables know it."""

    def lower(self, to: Lowering) -> Made:
        """Add its entries to the tables."""
        ...


class Lowering:
    """The tables that parts fill, and what they need to find in them.

    Parameters
    ----------
    gravity : sequence of float (3,) or (2,)
        Acceleration of gravity [m/s²]; planar elements use the first two components.

    Attributes
    ----------
    nodes, instances, surfaces, rigid_bodies : dict
        By name: nodes, elements, surfaces for ropes, rigid bodies.
    lines : dict of str to Handle
        Lines of cables, ropes and chains, by name.
    laws, loads, controllers : list
        In the order of their declaration.
    motions : dict of str to TimeFunction
        Prescribed motions.
    actuators : dict of str to tuple of str
        Of prescribed quantities: those in which the forces act that move them.
    roles : dict of str to str
        Of deformations and slips, "rigid" or "free", where they were given one.
    dynamic, kinematic : list of str, optional
        Degrees of freedom that were named.
    values, rates : dict of str to float
        Initial values and rates.
    checks : dict of str to callable
        What is checked when the model is built, with its structure and the names of coordinates that are fixed,
        prescribed or loaded; by the names of the checks.
    """

    def __init__(self, gravity: Vector = (0.0, 0.0, 0.0)) -> None:
        g = array(gravity, "Model", "gravity")
        if g.shape not in ((2,), (3,)):
            raise ModelError(
                f"Model: gravity {gravity!r:.40} is not a vector; give (x, y) or (x, y, z), such as (0, -9.81)"
            )
        self.gravity = vector(g, "Model", "gravity", g.size)
        self.nodes: dict[str, Node] = {}
        self.instances: dict[str, Instance] = {}
        self.laws: list[LawInstance] = []
        self.surfaces: dict[str, Surface] = {}
        self.rigid_bodies: dict[str, RigidBody] = {}
        self.lines: dict[str, Handle] = {}
        self.loads: list[Load] = []
        self.controllers: list[Controller] = []
        self.motions: dict[str, TimeFunction] = {}
        self.actuators: dict[str, tuple[str, ...]] = {}
        self.roles: dict[str, str] = {}
        self.dynamic: list[str] | None = None
        self.kinematic: list[str] | None = None
        self.values: dict[str, float] = {}
        self.rates: dict[str, float] = {}
        self.checks: dict[str, Callable[[Structure, Iterable[str]], None]] = {}

    def add(self, part: Lowerable[Made]) -> Made:
        """Lower a part completely or, if it is refused, not at all, so that the corrected call finds its names free."""
        before = {key: len(kept) for key, kept in vars(self).items() if isinstance(kept, (dict, list))}
        try:
            return part.lower(self)
        except Exception:
            for key, count in before.items():
                _shorten(getattr(self, key), count)
            raise

    def node(self, name: str, kind: str, x0: Array, fixed: bool) -> Node:
        """Add a node.

        Raises
        ------
        ModelError
            A name that is taken or unsuitable, a `fixed` that is neither True nor False.
        """
        self.new_name(name, kind)
        node = Node(name, kind, x0, np.full(x0.size, flag(fixed, f"{kind} '{name}'", "fixed")))
        self.nodes[name] = node
        return node

    def new_name(self, name: str, kind: str) -> None:
        """Check the name of a new node or element."""
        new_name(name, kind)
        if name in self.nodes or name in self.instances:
            raise ModelError(f"{kind} '{name}': this name is taken; choose another")

    def find_node(self, node: Node | str, owner: str) -> Node:
        """Return the node of that name, or a node of this model; raise a ModelError that names the owner otherwise."""
        if not isinstance(node, (Node, str)):
            raise ModelError(f"{owner}: {node!r} is not a node; give its name, or the result of m.point(…)")
        name = node.name if isinstance(node, Node) else node
        if name not in self.nodes:
            raise ModelError(f"{owner}: {unknown(name, self.nodes, 'node')}")
        found = self.nodes[name]
        if isinstance(node, Node) and node.x0 is not found.x0:
            raise ModelError(
                f"{owner}: the node '{name}' belongs to another model; use the nodes of this one"
            )
        return found

    def find_of_kind(self, node: Node | str, kinds: tuple[str, ...], owner: str) -> Node:
        """Return the named node if its kind is accepted; raise a ModelError that names the owner otherwise."""
        found = self.find_node(node, owner)
        if found.kind not in kinds:
            raise ModelError(
                f"{owner}: node '{found.name}' is a {found.kind}; it needs a {' or '.join(kinds)}"
            )
        return found

    def find_nodes(self, owner: str, *nodes: tuple[Node | str, str]) -> tuple[bool, list[Node]]:
        """Return nodes of the required kinds, all spatial or all planar, and whether they are planar."""
        planar = self.find_node(nodes[0][0], owner).kind.startswith("planar")
        return planar, [self.find_of_kind(n, (PLANAR[k] if planar else k,), owner) for n, k in nodes]

    def quantity_kind(self, name: str, owner: str) -> str:
        """Return what a declared quantity is, "coordinate", "deformation" or "slip"; else raise with near names.

        Parameters
        ----------
        name : str
            Of a node or element that is declared already.
        owner : str
            The declaration that refers to it, for the message.
        """
        quantities([name], owner)
        part, _, component = name.rpartition(".")
        node, element = self.nodes.get(part), self.instances.get(part)
        if node is not None and component in COMPONENTS[node.kind]:
            return "coordinate"
        if node is not None and node.kind == "frame" and component == "norm":
            raise ModelError(
                f"{owner}: '{name}' is the norm of the Euler parameters of frame '{part}', which is always "
                "constrained; name another quantity"
            )
        if element is not None and name in element.deformations:
            return "deformation"
        if element is not None and name in element.slips:
            return "slip"
        raise ModelError(f"{owner}: {unknown_quantity(name, self.quantities(), self.nodes)}")

    def quantities(self) -> list[str]:
        """Return the names of all quantities declared so far: deformations, slips, coordinates."""
        elements, nodes = self.instances.values(), self.nodes.values()
        own = [name for element in elements for name in (*element.deformations, *element.slips)]
        return [*own, *(name for node in nodes for name in node.coordinates)]

    def unit_of(self, quantity: str) -> str:
        """Return the unit of a deformation or slip of an element."""
        element, _, own = quantity.rpartition(".")
        spec = self.instances[element].spec
        units = {deformation.name: deformation.unit for deformation in spec.deformations}
        return (units | {slip.name: slip.unit for slip in spec.slips})[own]

    def element(
        self,
        name: str,
        kind: str | ElementSpec,
        nodes: Sequence[Node | str],
        parameters: Mapping[str, Any],
        code: Code | None = None,
    ) -> None:
        """Add an element between nodes: every element with a page is added here.

        Parameters
        ----------
        name : str
        kind : str or ElementSpec
            Its type in the table of elements, or the specification of a compiled one.
        nodes : sequence of Node or str
        parameters : mapping of str to array_like
            All of them; the default for gravity is that of the model.
        code : Code, optional
            Compiled code of a user's element; none for a built-in one.
        """
        spec = kind if isinstance(kind, ElementSpec) else ELEMENTS[kind]
        self.new_name(name, spec.name)
        owner = f"{spec.name} '{name}'"
        if len(nodes) != len(spec.nodes):
            ends = ", ".join(f"{end.name} ({end.kind})" for end in spec.nodes)
            given = ", ".join(repr(getattr(node, "name", node)) for node in nodes)
            raise ModelError(f"{owner}: its nodes are {given}; give {len(spec.nodes)}: {ends}")
        members = [
            self.find_of_kind(node, (end.kind,), owner) for node, end in zip(nodes, spec.nodes, strict=True)
        ]
        sizes = {parameter.name: parameter.size for parameter in spec.parameters}
        values = {"gravity": self.gravity[: sizes["gravity"]]} if "gravity" in sizes else {}
        values |= parameters
        wrong = sorted(sizes.keys() ^ values.keys())
        if wrong:
            raise ModelError(
                f"{owner}: parameter(s) {', '.join(wrong)} missing or unknown; it takes {', '.join(sizes)}"
            )
        values = {key: array(values[key], owner, f"parameter {key}").reshape(-1) for key in sizes}
        check_signs(spec.parameters, values, owner)
        instance = Instance(name, spec, tuple(member.name for member in members), values, code)
        _ = instance.p  # check the sizes here, so that the traceback shows the caller
        self.instances[name] = instance

    def law(
        self,
        owner: str,
        spec: LawSpec,
        on: Sequence[str],
        parameters: Mapping[str, Any],
        *,
        code: Code | None = None,
        initial: Mapping[str, float] | None = None,
        label: str | None = None,
        called: Mapping[str, str] | None = None,
        knots: tuple[float, ...] = (),
    ) -> None:
        """Check a law and add it; every law is added here.

        Parameters
        ----------
        owner : str
            The declaration that adds it, for messages.
        spec : LawSpec
        on : sequence of str
            Deformations, then slips.
        parameters : mapping of str to array_like
        code : Code, optional
            Compiled code of a user's law; none for a built-in law.
        initial : mapping of str to float, optional
            Initial values of internal states; zero by default.
        label : str, optional
            Its name; by default the element on which it acts, or the names in `on`, joined.
        called : mapping of str to str, optional
            Of an elastic law of the element `label`: what its parameters are called among those of the element.
        knots : tuple of float, optional
            Times [s] at which it is not smooth.
        """
        m, on = spec.deformations, tuple(on)
        check_arguments(owner, spec, on, [self.quantity_kind(name, owner) for name in on])
        check_units(owner, spec, on, [self.unit_of(name) for name in on])
        values = parameters_of_law(owner, spec, parameters)
        z0 = initial_states(owner, spec, initial)
        label = label_of(on) if label is None else text(label, owner, "name")
        if spec.states and any(law.name == label and law.spec.states for law in self.laws):
            raise ModelError(
                f"{owner}: there is already a law '{label}' with internal states; give another name"
            )
        self.laws.append(LawInstance(label, spec, on[:m], on[m:], values, code, z0, called, knots))

    def linear_law(
        self, owner: str, on: Sequence[str], S: Array, D: Array, preload: Array, label: str
    ) -> None:
        """Add σ = preload + S e + D ė on one to six deformations; S and D are symmetric."""
        upper = np.triu_indices(len(on))
        values = {"preload": preload, "S": S[upper], "D": D[upper]}
        self.law(owner, LAWS[f"linear_{len(on)}"], on, values, label=label)


def _shorten(kept: dict[str, Any] | list[Any], count: int) -> None:
    """Remove the latest entries until `count` remain."""
    while len(kept) > count:
        if isinstance(kept, dict):
            kept.popitem()
        else:
            kept.pop()
