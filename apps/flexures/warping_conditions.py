"""Warping conditions of elements: ends whose sections stay plane, and ends that warp together."""

from __future__ import annotations

import numpy as np

from flexel.apps.flexures.input_tables import FlexureTables
from flexel.apps.flexures.properties import NodeProperties
from flexel.model.node import Node
from flexel.parts.model import Model
from flexel.results.flexure_step import element_name

STRAIGHT_TOLERANCE = 1e-9  # sine of the largest angle between two aligned elements


def warping_ends(m: Model, element: int, tables: FlexureTables) -> tuple[Node, Node]:
    """Return the warping nodes at the ends of an element: held, or shared with an aligned element."""
    p, q = (
        _shared(m, node)
        if _continues(node, tables)
        else m.warping(f"{element_name(element)} warping {end}", fixed=True)
        for node, end in zip(tables.ends[element - 1], "pq", strict=True)
    )
    return p, q


def _shared(m: Model, node: int) -> Node:
    name = f"warping {node}"
    return m.nodes[name] if name in m.nodes else m.warping(name)


def _continues(node: int, tables: FlexureTables) -> bool:
    """Whether exactly two elements of one group meet at a node, in line, and nothing else holds its section."""
    found = [i for i, ends in enumerate(tables.ends, start=1) if node in ends]
    if len(found) != 2 or len({tables.group_of.get(i, -i) for i in found}) != 1:
        return False
    if _turns(tables.nodes.get(node, NodeProperties())):
        return False
    ways = []
    for i, place in zip(found, ("towards", "away"), strict=True):
        other = sum(tables.ends[i - 1]) - node
        way = tables.places[other - 1] - tables.places[node - 1]
        ways.append((way if place == "away" else -way) / np.linalg.norm(way))
    return bool(ways[0] @ ways[1] > 0 and np.linalg.norm(np.cross(*ways)) < STRAIGHT_TOLERANCE)


def _turns(given: NodeProperties) -> bool:
    """Whether the properties of a node hold or turn it, as a body on it does."""
    held = given.fixed if isinstance(given.fixed, (bool, np.bool_)) else "rotation" in given.fixed
    loads = (given.inertia, given.moment, given.moment_initial, given.rotation, given.rotation_initial)
    return bool(held) or any(load is not None for load in loads)
