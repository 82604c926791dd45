"""The narrowest place of a graph: fewest vertices that separate sources from targets (maximal flow)."""

from collections import deque
from collections.abc import Collection, Mapping

_SOURCE, _TARGET = -1, -2
_ANY = 1 << 30


def narrowest(
    arguments: Mapping[int, Collection[int]], sources: Collection[int], targets: Collection[int]
) -> list[int]:
    """Find vertices that every path from a source to a target passes; as few, and as near the targets, as possible.

    Parameters
    ----------
    arguments : mapping
        For each vertex those that have an edge to it.
    sources, targets : collection of int
        They may be among the vertices that are found.
    """
    # Each vertex is an edge of capacity 1 from 2 v to 2 v + 1; all other edges are wide.
    left: dict[int, dict[int, int]] = {_SOURCE: {}, _TARGET: {}}
    for vertex in arguments:
        left[2 * vertex], left[2 * vertex + 1] = {}, {}

    def connect(start: int, end: int, capacity: int) -> None:
        left[start][end] = capacity
        left[end].setdefault(start, 0)

    for vertex, before in arguments.items():
        connect(2 * vertex, 2 * vertex + 1, 1)
        for other in before:
            connect(2 * other + 1, 2 * vertex, _ANY)
    for vertex in sources:
        connect(_SOURCE, 2 * vertex, _ANY)
    for vertex in targets:
        connect(2 * vertex + 1, _TARGET, _ANY)
    while _augment(left):
        pass
    behind = _behind(left)
    return [vertex for vertex in arguments if 2 * vertex not in behind and 2 * vertex + 1 in behind]


def _augment(left: dict[int, dict[int, int]]) -> bool:
    """Send one unit along a shortest path, if there is one."""
    came = {_SOURCE: _SOURCE}
    queue = deque([_SOURCE])
    while queue and _TARGET not in came:
        here = queue.popleft()
        for there, capacity in left[here].items():
            if capacity > 0 and there not in came:
                came[there] = here
                queue.append(there)
    if _TARGET not in came:
        return False
    there = _TARGET
    while there != _SOURCE:
        here = came[there]
        left[here][there] -= 1
        left[there][here] += 1
        there = here
    return True


def _behind(left: dict[int, dict[int, int]]) -> set[int]:
    """Find all vertices from which the target can still be reached."""
    behind = {_TARGET}
    queue = deque([_TARGET])
    while queue:
        here = queue.popleft()
        for there in left[here]:
            if there not in behind and left[there][here] > 0:
                behind.add(there)
                queue.append(there)
    return behind
