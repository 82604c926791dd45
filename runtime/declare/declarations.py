"""The declarations of a model: its nodes, elements, laws, loads, roles and initial values, by name.

Everything has a name, and every name works everywhere.  Quantities are called ``node.coordinate``,
``element.deformation`` and ``element.slip``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import array, flag, new_name, quantities, unknown, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.time_functions import TimeFunction
from flexel.derive.spec import ElementSpec
from flexel.generated.table import ELEMENTS
from flexel.structure.controllers import Controller
from flexel.structure.instances import Code, Instance, LawInstance
from flexel.structure.loads import Load
from flexel.structure.nodes import COMPONENTS, Node, unknown_quantity
from flexel.structure.rigid_bodies import RigidBody
from flexel.structure.surfaces import Surface

PLANAR = {"point": "planar_point", "frame": "planar_angle", "slope": "planar_slope"}


class Declarations:
    """The data of a model and helpers for every family of methods: nodes by name, elements with their parameters.

    Parameters
    ----------
    gravity : sequence of float (3,) or (2,)
        Acceleration of gravity [m/s²]; planar elements use the first two components.

    Attributes
    ----------
    nodes, instances, surfaces : dict
        Declared so far, by name: nodes, elements, and surfaces for ropes.  Read-only.
    laws, loads, controllers : list
        As declared.  Read-only.
    """

    def __init__(self, gravity: Vector = (0.0, 0.0, 0.0)) -> None:
        g = array(gravity, "Model", "gravity")
        self.gravity = vector(g, "Model", "gravity", 2 if g.shape == (2,) else 3)
        self.nodes: dict[str, Node] = {}
        self.instances: dict[str, Instance] = {}
        self.laws: list[LawInstance] = []
        self.surfaces: dict[str, Surface] = {}
        self._rigid_bodies: dict[str, RigidBody] = {}
        self.loads: list[Load] = []
        self.controllers: list[Controller] = []
        self._motions: dict[str, TimeFunction] = {}
        self._roles: dict[str, str] = {}  # "rigid" or "free", as declared
        self._dynamic: list[str] | None = None
        self._kinematic: list[str] | None = None
        self._values: dict[str, float] = {}
        self._rates: dict[str, float] = {}

    def _new_node(self, name: str, kind: str, x0: Array, fixed: bool) -> Node:
        self._new_name(name, kind)
        node = Node(name, kind, x0, np.full(x0.size, flag(fixed, f"{kind} '{name}'", "fixed")))
        self.nodes[name] = node
        return node

    def _new_name(self, name: str, kind: str) -> None:
        new_name(name, kind)
        if name in self.nodes or name in self.instances:
            raise ModelError(f"{kind} '{name}': this name is taken; choose another")

    def _find_node(self, node: Node | str, owner: str) -> Node:
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

    def _find_of_kind(self, node: Node | str, kinds: tuple[str, ...], owner: str) -> Node:
        """The named node, if its kind is accepted; a ModelError that names the owner otherwise."""
        found = self._find_node(node, owner)
        if found.kind not in kinds:
            raise ModelError(
                f"{owner}: node '{found.name}' is a {found.kind}; it needs a {' or '.join(kinds)}"
            )
        return found

    def _find_nodes(self, owner: str, *nodes: tuple[Node | str, str]) -> tuple[bool, list[Node]]:
        """Nodes of the required kinds, all spatial or all planar, and whether they are planar."""
        planar = self._find_node(nodes[0][0], owner).kind.startswith("planar")
        return planar, [self._find_of_kind(n, (PLANAR[k] if planar else k,), owner) for n, k in nodes]

    def _quantity_kind(self, name: str, owner: str) -> str:
        """What a declared quantity is, "coordinate", "deformation" or "slip"; a ModelError with near names otherwise.

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
                f"{owner}: '{name}' is the norm of the Euler parameters of frame '{part}', always constrained; name "
                "another quantity"
            )
        if element is not None and name in element.deformations:
            return "deformation"
        if element is not None and name in element.slips:
            return "slip"
        raise ModelError(f"{owner}: {unknown_quantity(name, self._quantities(), self.nodes)}")

    def _quantities(self) -> list[str]:
        """Names of all quantities declared so far: deformations, slips, coordinates."""
        elements, nodes = self.instances.values(), self.nodes.values()
        own = [z for instance in elements for z in (*instance.deformations, *instance.slips)]
        return [*own, *(z for node in nodes for z in node.coordinates)]

    def _place(
        self,
        name: str,
        kind: str | ElementSpec,
        nodes: Sequence[Node | str],
        parameters: Mapping[str, Any],
        code: Code | None = None,
    ) -> None:
        """Put an element between nodes: every user-named element is made here.

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
        self._new_name(name, spec.name)
        owner = f"{spec.name} '{name}'"
        if len(nodes) != len(spec.nodes):
            ends = ", ".join(f"{z.name} ({z.kind})" for z in spec.nodes)
            given = ", ".join(repr(getattr(z, "name", z)) for z in nodes)
            raise ModelError(f"{owner}: its nodes are {given}; give {len(spec.nodes)}: {ends}")
        members = [self._find_of_kind(n, (z.kind,), owner) for n, z in zip(nodes, spec.nodes, strict=True)]
        sizes = {z.name: z.size for z in spec.parameters}
        values = {"gravity": self.gravity[: sizes["gravity"]]} if "gravity" in sizes else {}
        values |= parameters
        wrong = sorted(sizes.keys() ^ values.keys())
        if wrong:
            raise ModelError(
                f"{owner}: parameter(s) {', '.join(wrong)} missing or unknown; it takes {', '.join(sizes)}"
            )
        values = {z: array(values[z], owner, f"parameter {z}").reshape(-1) for z in sizes}
        instance = Instance(name, spec, tuple(n.name for n in members), values, code)
        _ = instance.p  # check the sizes here, so that the traceback shows the caller
        self.instances[name] = instance
