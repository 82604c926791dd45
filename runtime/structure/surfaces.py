"""Surfaces that ropes touch, as declared: geometry on a point and a frame of a body."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array


@dataclass(frozen=True)
class Surface:
    """A surface fixed in a body.

    Attributes
    ----------
    name : str
    element : str
        The element type that computes the gap of a rope's point.
    point, frame : str
        Nodes of the body: the surface's centre, or a point of the plane, and the orientation.
    parameters : dict of str to ndarray
        The surface's parameters, passed to the element.
    radius : float
        Radius at which the rope's surface touches [m]; 0 for a plane.
    centre, axle : ndarray
        As drawn; the axle is the normal for a plane, and (0, 0, 1) in planar models.
    gaps : tuple of (str, tuple of str)
        Gap deformations, each with the slips along the surface there.
    across : ndarray, optional
        Of a helical groove: where it crosses the plane through the centre, seen from the axle, as drawn.
    """

    name: str
    element: str
    point: str
    frame: str
    parameters: dict[str, Array]
    radius: float
    centre: Array
    axle: Array
    gaps: tuple[tuple[str, tuple[str, ...]], ...]
    across: Array | None = None

    @property
    def pitch(self) -> float:
        """Axial advance of a helical groove per angle about the axle [m/rad]; 0 for other surfaces."""
        return float(self.parameters.get("lead", np.zeros(1))[0]) / (2 * np.pi)

    def per_radian(self, rope_radius: float) -> float:
        """Length of a rope's centre line on it per angle about the axle [m/rad]."""
        return float(np.hypot(self.radius + rope_radius, self.pitch))
