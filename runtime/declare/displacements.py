"""Coordinates as deformations: how far a point or an angle is from where it was drawn, for springs to the ground."""

from __future__ import annotations

import numpy as np

from flexel.base.errors import ModelError
from flexel.declare.declarations import Declarations
from flexel.generated.table import ELEMENTS
from flexel.structure.instances import Instance
from flexel.structure.nodes import COMPONENTS, Node


def displacement(model: Declarations, name: str, owner: str) -> str:
    """The deformation equal to a coordinate minus its drawn value; other names are returned unchanged.

    It belongs to a massless element from a fixed node, ``<node>.drawn``, created when first needed.
    """
    node, _, component = name.partition(".")
    if node not in model.nodes or component not in COMPONENTS[model.nodes[node].kind]:
        return name
    found = model.nodes[node]
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
    if element not in model.instances:
        _add_displacement(model, element, found)
    spec = model.instances[element].spec
    return f"{element}.{spec.deformations[COMPONENTS[found.kind].index(component)].name}"


def _add_displacement(model: Declarations, element: str, node: Node) -> None:
    """The element whose deformations, all free, are the displacements of a point or an angle in global axes."""
    drawn = Node(f"{node.name}.drawn", node.kind, node.x0, np.ones(node.x0.size, dtype=bool))
    axes_kind, axes = ("frame", np.eye(4)[0]) if node.kind == "point" else ("planar_angle", np.zeros(1))
    still = Node(f"{node.name}.axes", axes_kind, axes, np.ones(axes.size, dtype=bool))
    kind = {"point": "beam3", "planar_point": "planar_beam3", "planar_angle": "planar_hinge"}[node.kind]
    ends = (drawn, node) if node.kind == "planar_angle" else (drawn, still, node)
    model.nodes |= {z.name: z for z in ends if z is not node}
    spec = ELEMENTS[kind]
    values = {z.name: np.eye(z.size)[0] if z.name == "tp" else np.zeros(z.size) for z in spec.parameters}
    model.instances[element] = Instance(element, spec, tuple(z.name for z in ends), values)
    model._roles |= {z: "free" for z in model.instances[element].deformations if z not in model._roles}
