"""Encodes the numbers of a page in one block: quantized, as differences from predicted values, and compressed.

Numbers over frames are smooth, and vertices along a line are, so that their second differences are small: most take
one byte instead of four.
"""

from __future__ import annotations

import base64
import zlib
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from flexel.apps.view.page.packing import unpacked
from flexel.base.arrays import Array

# Of positions, relative to the size of the model; of quaternions; of values and forces, relative to the largest.
STEP = 2.0**-20
MAX_STEPS = 2.0**26  # so that second differences over frames and over vertices, with a sign, fit into 32 bits
COMPRESSION = 6  # of zlib


def coded(scene: Mapping[str, Any]) -> dict[str, Any]:
    """Return a scene in which each text of numbers is replaced by where they are in one block, ``"numbers"``.

    That is a dict: ``at``, the first byte; ``rows`` and ``width``, their number and the numbers in each. Without
    ``steps``, the numbers are Float32. With ``steps``, one for all columns, or for each in turn, they are whole numbers
    of steps: their second differences over the rows, and with ``along`` over every third column before that. These
    are counted 0, −1, 1, −2, … as 0, 1, 2, 3, …, one column after another, and stored in so many ``bytes``: first the
    lowest byte of all, then the next.
    """
    block, shapes = _Block(), [dict(shape) for shape in scene["shapes"]]
    position, peaks = STEP * float(scene["size"]), _peaks(shapes)
    for shape in shapes:
        width, rigid = 3 * sum(shape["counts"]), shape["rigid"]
        moving = {
            "data": (7 if rigid else width, [position] * 3 + [STEP] * 4 * rigid, not rigid),
            "across": (6, [STEP], False),
            "force": (3, [STEP * peaks.get("force", 0.0)], False),
        }
        shape |= {name: block.add(shape[name], *how) for name, how in moving.items() if name in shape}
        still = {"local": width, "surface": 3, "modes": 7 if rigid else width}
        shape |= {name: block.add(shape[name], size) for name, size in still.items() if name in shape}
        shape["values"] = {
            name: _value(block, value, STEP * peaks.get(name, 0.0)) for name, value in shape["values"].items()
        }
    rows = [row | {"values": block.add(row["values"], 1)} for row in scene["plots"]["rows"]]
    camera = scene["camera"] | {"path": block.add(scene["camera"]["path"], 3, [position])}
    found = dict(scene) | {"shapes": shapes, "plots": scene["plots"] | {"rows": rows}, "camera": camera}
    return found | {"numbers": block.text}


def _value(block: _Block, value: Mapping[str, Any], step: float) -> dict[str, Any]:
    """Return a value for colouring with the places of its numbers: over the frames, or in the modes."""
    found = {"count": value["count"]}
    if "data" in value:
        found["data"] = block.add(value["data"], value["count"], [step])
    if "modal" in value:
        found["modal"] = block.add(value["modal"], value["count"])
    return found


def _peaks(shapes: Sequence[Mapping[str, Any]]) -> dict[str, float]:
    """Return the largest of the values of each name, and of the forces."""
    found: dict[str, float] = {}
    for shape in shapes:
        named = {name: value["data"] for name, value in shape["values"].items() if "data" in value}
        for name, text in (named | {"force": shape.get("force", "")}).items():
            found[name] = max(found.get(name, 0.0), float(np.max(np.abs(unpacked(text)), initial=0.0)))
    return found


class _Block:
    """The bytes of all numbers, each text once."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._size = 0
        self._known: dict[tuple[Any, ...], dict[str, Any]] = {}

    def add(
        self, packed: str, width: int, steps: Sequence[float] = (), along: bool = False
    ) -> dict[str, Any]:
        """Store numbers, rows of `width` each, and return where they are; those of one row exactly."""
        key = packed, width, tuple(steps), along
        if key not in self._known:
            self._known[key] = self._stored(
                unpacked(packed).reshape(-1, width).astype(float), np.array(steps), along
            )
        return self._known[key]

    def _stored(self, rows: Array, steps: Array, along: bool) -> dict[str, Any]:
        found: dict[str, Any] = {"at": self._size, "rows": len(rows), "width": rows.shape[1]}
        if len(rows) > 1 and steps.size and np.all(steps > 0):
            every = np.resize(np.maximum(steps, np.max(np.abs(rows), initial=0.0) / MAX_STEPS), rows.shape[1])
            planes = _planes(_differences(rows / every, along))
            found |= {"steps": every[: steps.size].tolist(), "along": along, "bytes": len(planes)}
            self._parts.append(planes.tobytes())
        else:
            self._parts.append(rows.astype("<f4").tobytes())
        self._size += len(self._parts[-1])
        return found

    @property
    def text(self) -> str:
        """All bytes, compressed, in base64."""
        return base64.b64encode(zlib.compress(b"".join(self._parts), COMPRESSION)).decode()


def _differences(rows: Array, along: bool) -> Array:
    """Return second differences (columns, rows) over the rows, and over every third column if wanted."""
    found = np.rint(rows).astype(np.int64).T
    if along:
        vertices = found.reshape(-1, 3, found.shape[1])
        found = np.diff(vertices, n=2, axis=0, prepend=np.zeros((2, *vertices.shape[1:]), int)).reshape(
            found.shape
        )
    return np.diff(found, n=2, axis=1, prepend=np.zeros((len(found), 2), int))


def _planes(numbers: Array) -> Array:
    """Return the bytes of whole numbers, the lowest of all first: as many (bytes, ...) as the largest needs."""
    counted = np.where(numbers < 0, -2 * numbers - 1, 2 * numbers).astype("<u4")
    planes = np.moveaxis(counted[..., None].view(np.uint8), -1, 0)
    needed = max((int(np.max(counted, initial=1)).bit_length() + 7) // 8, 1)
    return np.ascontiguousarray(planes[:needed])
