"""Surfaces that ropes and points touch, as declared: geometry on a point and a frame of a body."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.model.handle import Handle


@dataclass(frozen=True)
class Surface(Handle):
    """A surface fixed in a body.

    Attributes
    ----------
    name : str
    kind : str
        cylinder, plane, v_groove, round_groove or helical_groove; circle or line in planar models.
    point, frame : str
        Nodes of the body: the surface's centre, or a point of the plane, and the orientation.
    parameters : dict of str to ndarray
        The surface's parameters, passed to the element.
    radius : float
        Radius at which the surface of a rope or sphere touches [m]; 0 for a plane.
    centre, axle : ndarray
        As drawn; the axle is the normal for a plane, and (0, 0, 1) in planar models.
    gaps : tuple of (str, tuple of str)
        Gap deformations of a rope, each with the slips along the surface there.
    across : ndarray, optional
        Of a helical groove: where it crosses the plane through the centre, seen from the axle, as drawn.
    """

    name: str
    kind: str
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
        """Return the length of a rope's centre line on it per angle about the axle [m/rad]."""
        return float(np.hypot(self.radius + rope_radius, self.pitch))

    @property
    def planar(self) -> bool:
        """Whether it lies in a planar model."""
        return self.centre.size == 2

    def element(self, touching: str) -> str:
        """Return the element type of what touches it: a cable, a point, a sphere or a disc."""
        return f"{'planar_' if self.planar else ''}{touching}_{self.kind}"
