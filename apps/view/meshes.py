"""Reads triangle surfaces from `.stl` and `.obj` files, and finds their sharp edges."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from flexel.base.arguments import path_of
from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError

HEADER_BYTES = 84  # bytes before the triangles in a binary .stl
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
MAX_EDGES_SHOWN = 400  # most edges that are drawn
SHARP_COSINE = np.cos(np.radians(30.0))  # edges between faces that turn by more are drawn


def read_mesh(path: str | Path) -> tuple[Array, Index]:
    """Read vertices (k, 3), in units of the file, and triangles (t, 3) of a surface.

    Parameters
    ----------
    path : path
        ``.stl``, binary or text, or ``.obj``; polygons with more corners are split into triangles.

    Raises
    ------
    ModelError
        Another suffix, a file that cannot be read, or one without triangles.
    """
    path = path_of(path, "mesh")
    readers = {".stl": _stl, ".obj": _obj}
    if path.suffix.lower() not in readers:
        raise ModelError(f"mesh '{path}': only .stl and .obj files are read; convert it to one of these")
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ModelError(f"mesh '{path}': {error.strerror}; give a file that can be read") from error
    try:
        vertices, triangles = readers[path.suffix.lower()](data)
    except (ValueError, IndexError) as error:
        raise ModelError(f"mesh '{path}': it is damaged ({error}); export it again") from error
    if not len(triangles):
        raise ModelError(f"mesh '{path}': it has no triangles; export a surface")
    if not np.all(np.isfinite(vertices)):
        raise ModelError(f"mesh '{path}': it has vertices that are not finite; export it again")
    return vertices, triangles


def _stl(data: bytes) -> tuple[Array, Index]:
    """Read triangles of a binary file, recognized by its length, or of a text file."""
    count = int.from_bytes(data[HEADER_BYTES - 4 : HEADER_BYTES], "little")
    if len(data) >= HEADER_BYTES and len(data) == HEADER_BYTES + count * RECORD.itemsize:
        corners = np.frombuffer(data, RECORD, count, HEADER_BYTES)["corners"].reshape(-1, 3)
    else:
        words = [line.split() for line in data.decode("ascii", "replace").splitlines()]
        corners = np.array([line[1:4] for line in words if line[:1] == ["vertex"]], dtype=float).reshape(
            -1, 3
        )
    if len(corners) % 3:
        raise ValueError(f"{len(corners)} corners")
    vertices, where = np.unique(corners.astype(float), axis=0, return_inverse=True)
    return vertices, where.reshape(-1, 3).astype(np.intp)


def _obj(data: bytes) -> tuple[Array, Index]:
    """Read vertices and faces; textures, normals and groups are ignored."""
    places: list[list[float]] = []
    found: list[tuple[int, int, int]] = []
    for line in data.decode("utf-8", "replace").splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            places.append([float(word) for word in rest[:3]])
        elif word == "f":
            corners = [int(word.partition("/")[0]) for word in rest]
            corners = [corner - 1 if corner > 0 else len(places) + corner for corner in corners]
            found += [(corners[0], b, c) for b, c in zip(corners[1:], corners[2:], strict=False)]
    triangles = np.array(found, dtype=np.intp).reshape(-1, 3)
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(places):
        raise ValueError("a face refers to a vertex that does not exist")
    return np.array(places, dtype=float).reshape(-1, 3), triangles


def sharp_edges(vertices: Array, triangles: Index) -> tuple[Array, ...]:
    """Return edges (2, 3) where a surface ends or turns by more than 30 degrees; else those of its bounding box."""
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    faces: dict[tuple[int, int], list[int]] = {}
    for face, corners in enumerate(triangles.tolist()):
        for i in range(3):
            ends = sorted((corners[i], corners[i - 1]))
            faces.setdefault((ends[0], ends[1]), []).append(face)
    sharp = [
        ends
        for ends, sides in faces.items()
        if len(sides) != 2 or normals[sides[0]] @ normals[sides[1]] < SHARP_COSINE
    ]
    if 0 < len(sharp) <= MAX_EDGES_SHOWN:
        return tuple(vertices[list(ends)] for ends in sharp)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    corners = np.array([np.where([x, y, z], high, low) for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    return tuple(corners[[i, i ^ k]] for i in range(8) for k in (1, 2, 4) if not i & k)
