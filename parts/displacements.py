"""Coordinates as deformations: the displacement of a point or angle from its drawn value, for springs to the ground."""

from __future__ import annotations

import numpy as np

from flexel.base.errors import ModelError
from flexel.generated.table import ELEMENTS
from flexel.model.instances import Instance
from flexel.model.lowering import Lowering
from flexel.model.node import COMPONENTS, Node


def displacement(to: Lowering, name: str, owner: str) -> str:
    """Return the deformation equal to a coordinate minus its drawn value; other names are returned unchanged.

    It belongs to a massless element from a fixed node, ``<node>.drawn``, created when first needed.
    """
    node, _, component = name.partition(".")
    if node not in to.nodes or component not in COMPONENTS[to.nodes[node].kind]:
        return name
    found = to.nodes[node]
    if found.kind == "frame":
        raise ModelError(
            f"{owner}: Euler parameters such as '{name}' cannot carry springs; measure an angle with a fully released "
            "m.hinge(…) and use its angle"
        )
    if found.kind == "warping":
        raise ModelError(
            f"{owner}: '{name}' cannot carry springs; make it a deformation by m.relation('spring', {{'{name}': 1.0}})"
            " and put the spring on 'spring.relation'"
        )
    if found.fixed[COMPONENTS[found.kind].index(component)]:
        raise ModelError(f"{owner}: '{name}' is fixed and cannot move; remove the spring or the fixing")
    element = f"{node}.displacement"
    if element not in to.instances:
        _add_displacement(to, element, found)
    spec = to.instances[element].spec
    return f"{element}.{spec.deformations[COMPONENTS[found.kind].index(component)].name}"


def _add_displacement(to: Lowering, element: str, node: Node) -> None:
    """Add the element whose deformations, all free, are the displacements of a point or an angle in global axes."""
    drawn = Node(f"{node.name}.drawn", node.kind, node.x0, np.ones(node.x0.size, dtype=bool))
    axes_kind, axes = ("frame", np.eye(4)[0]) if node.kind == "point" else ("planar_angle", np.zeros(1))
    still = Node(f"{node.name}.axes", axes_kind, axes, np.ones(axes.size, dtype=bool))
    kind = {"point": "beam3", "planar_point": "planar_beam3", "planar_angle": "planar_hinge"}[node.kind]
    ends = (drawn, node) if node.kind == "planar_angle" else (drawn, still, node)
    to.nodes |= {end.name: end for end in ends if end is not node}
    spec = ELEMENTS[kind]
    values = {
        parameter.name: np.eye(parameter.size)[0] if parameter.name == "tp" else np.zeros(parameter.size)
        for parameter in spec.parameters
    }
    instance = Instance(element, spec, tuple(end.name for end in ends), values)
    to.instances[element] = instance
    to.roles |= {name: "free" for name in instance.deformations if name not in to.roles}
