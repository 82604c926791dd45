"""Checks the tables of a flexure mechanism: every error names the table, its row, and the remedy."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.apps.flexures.properties import ElementProperties, FlexureOptions, NodeProperties, properties_of
from flexel.base.arguments import array, flag, index, names, vector, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError

MIN_NODE_DISTANCE = 1e-9  # smallest distance between nodes, relative to the size of the mechanism


@dataclass(frozen=True)
class FlexureTables:
    """A flexure mechanism in tables.

    Attributes
    ----------
    places : ndarray (n, 3)
        Positions of the nodes [m].
    ends : list of (int, int)
        Nodes of each element, counted from 1.
    nodes : dict of int to NodeProperties
        Properties of the nodes that have any.
    groups : list of ElementProperties
    group_of : dict of int to int
        The group that each element is in, counted from 0; others are rigid and have no mass.
    options : FlexureOptions
    """

    places: Array
    ends: list[tuple[int, int]]
    nodes: dict[int, NodeProperties]
    groups: list[ElementProperties]
    group_of: dict[int, int]
    options: FlexureOptions

    def group(self, element: int) -> ElementProperties | None:
        """Return the properties of an element, if it is in a group."""
        return self.groups[self.group_of[element]] if element in self.group_of else None


def node_owner(node: int) -> str:
    """Name the properties of a node in messages."""
    return f"flexure: node_properties of node {node}"


def group_owner(row: int) -> str:
    """Name a row of the properties of elements, counted from 0, in messages."""
    return f"flexure: element_properties row {row + 1}"


def read_tables(
    nodes: Any, elements: Any, node_properties: Any, element_properties: Any, options: Any
) -> FlexureTables:
    """Check the tables; see `flexel.apps.flexures.flexure.flexure`.

    Parameters
    ----------
    nodes, elements, node_properties, element_properties, options
        As given by the user.
    """
    places = _places(nodes)
    ends = list(_ends(elements, places))
    groups = [
        properties_of(ElementProperties, row, group_owner(i))
        for i, row in enumerate(_rows(element_properties, "element_properties"))
    ]
    given = dict(_node_properties(node_properties, len(places)))
    return FlexureTables(
        places, ends, given, groups, _group_of(groups, len(ends)), _options(options, len(places))
    )


def _places(nodes: Any) -> Array:
    rows = [
        vector(row, f"flexure: nodes row {i}", "place", 3)
        for i, row in enumerate(_rows(nodes, "nodes"), start=1)
    ]
    if len(rows) < 2:
        raise ModelError(f"flexure: nodes has {len(rows)} rows; give at least two, [[x, y, z], …]")
    return np.array(rows)


def _ends(elements: Any, places: Array) -> Iterator[tuple[int, int]]:
    rows = _rows(elements, "elements")
    size, seen = float(np.ptp(places, axis=0).max()), set()
    for i, row in enumerate(rows, start=1):
        owner = f"flexure: elements row {i}"
        pair = array(row, owner, "nodes")
        if pair.shape != (2,):
            raise ModelError(f"{owner}: {pair.tolist()} are not two nodes; give their numbers, [1, 2]")
        p, q = (_node_number(number, owner, len(places)) for number in pair.tolist())
        if float(np.linalg.norm(places[p - 1] - places[q - 1])) <= MIN_NODE_DISTANCE * size:
            raise ModelError(
                f"{owner}: its nodes {p} and {q} are at the same position; move one, or use one node"
            )
        seen |= {p, q}
        yield p, q
    if not rows:
        raise ModelError("flexure: elements has no rows; give at least one, [[1, 2], …]")
    idle = sorted(set(range(1, len(places) + 1)) - seen)
    if idle:
        raise ModelError(
            f"flexure: nodes row {idle[0]}: no element uses this node; connect it, or drop the row"
        )


def _node_number(value: Any, owner: str, count: int) -> int:
    """Return the number of a node, from 1 on; whole numbers in a table of floats are accepted."""
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    number = index(value, owner, "node")
    if not 1 <= number <= count:
        raise ModelError(f"{owner}: there is no node {number}; they are numbered from 1 to {count}")
    return number


def _rows(given: Any, table: str) -> list[Any]:
    if isinstance(given, Mapping) and table == "element_properties":
        raise ModelError(
            f"flexure: {table} is one mapping; give a list of groups, [{{'elements': [1, 2], …}}]"
        )
    if isinstance(given, np.ndarray) and given.ndim:
        return list(given)
    if not isinstance(given, (list, tuple)):
        raise ModelError(f"flexure: {table} {given!r:.60} is not a table; give a list of rows")
    return list(given)


def _node_properties(given: Any, count: int) -> Iterator[tuple[int, NodeProperties]]:
    """Convert a mapping by node number, or a list with an entry for each node (None for none), to a mapping."""
    if given is None:
        return
    if not isinstance(given, Mapping):
        rows = _rows(given, "node_properties")
        if len(rows) > count:
            raise ModelError(
                f"flexure: node_properties has {len(rows)} entries for {count} nodes; give one for each, or a mapping "
                "{number: {…}}"
            )
        given = {i: row for i, row in enumerate(rows, start=1) if row is not None}
    for key, value in given.items():
        node = _node_number(key, "flexure: node_properties", count)
        yield node, properties_of(NodeProperties, value, node_owner(node))


def _group_of(groups: Sequence[ElementProperties], count: int) -> dict[int, int]:
    found: dict[int, int] = {}
    for i, group in enumerate(groups):
        owner = group_owner(i)
        listed = array(group.elements, owner, "elements")
        if listed.ndim > 1 or not listed.size:
            raise ModelError(
                f"{owner}: elements {group.elements!r:.60}; give a list of rows of the table, [1, 2]"
            )
        for value in np.atleast_1d(listed).tolist():
            if not float(value).is_integer() or not 1 <= value <= count:
                raise ModelError(
                    f"{owner}: there is no element {value:g}; they are numbered from 1 to {count}"
                )
            element = int(value)
            if element in found:
                raise ModelError(
                    f"{owner}: element {element} is already in row {found[element] + 1}; name it in one row only"
                )
            found[element] = i
    return found


def _options(given: Any, count: int) -> FlexureOptions:
    owner = "flexure: options"
    options = properties_of(FlexureOptions, {} if given is None else given, owner)
    whole(options.steps, owner, "steps")
    flag(options.both_ways, owner, "both_ways")
    vector(options.gravity, owner, "gravity", 3)
    if not isinstance(options.release, (bool, np.bool_)):
        names(options.release, f"{owner}: release")
    for name in ("frequencies", "buckling"):
        whole(getattr(options, name), owner, name, least=0)
    if not isinstance(options.compliance, (bool, np.bool_)):
        for node in _rows(options.compliance, "options: compliance"):
            _node_number(node, f"{owner}: compliance", count)
    return options
