"""Beams as drawn: lengths, reference triads and offsets from the positions of their nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import span
from flexel.base.arrays import Array
from flexel.base.quaternions import in_frame, matrix, triad
from flexel.model.node import Node


def triads(nodes: Sequence[Node], direction: Any, owner: str) -> dict[str, Array]:
    """Return length and reference triads of a straight spatial beam (p, frame p, q, frame q)."""
    xp, rp, xq, rq = (n.x0 for n in nodes)
    e_x, l0 = span(xp, xq, owner)
    t = triad(e_x, direction, owner)
    return {"l0": np.array([l0]), "tp": in_frame(rp, t), "tq": in_frame(rq, t)}


def offset(nodes: Sequence[Node], direction: Any, owner: str) -> dict[str, Array]:
    """Return the offset of q in the triad of the frame; zero for coincident points, which are then merely connected."""
    xp, rp, xq = (n.x0 for n in nodes)
    l0 = float(np.linalg.norm(xq - xp))
    t = triad((xq - xp) / l0, direction, owner) if l0 > 0 else rp
    return {"tp": in_frame(rp, t), "d0": matrix(t).T @ (xq - xp), "l0": np.array([l0])}


def planar_triads(nodes: Sequence[Node], owner: str) -> dict[str, Array]:
    """Return length and reference directions of a straight planar beam."""
    xp, phi_p, xq, phi_q = (n.x0 for n in nodes)
    e, l0 = span(xp, xq, owner)
    alpha = np.arctan2(e[1], e[0])
    return {"l0": np.array([l0]), "alpha0": alpha - phi_p, "alphaq0": alpha - phi_q}


def planar_offset(nodes: Sequence[Node]) -> dict[str, Array]:
    """Return the offset of q in the frame's axes, for the planar rigid link."""
    xp, phi, xq = (n.x0 for n in nodes)
    d = xq - xp
    l0 = float(np.linalg.norm(d))
    alpha = np.arctan2(d[1], d[0]) if l0 > 0 else phi
    return {"alpha0": np.atleast_1d(alpha - phi), "d0": np.array([l0, 0.0]), "l0": np.array([l0])}
