"""Surfaces that ropes and points touch, as declared: geometry on a point and a frame of a body."""

from __future__ import annotations

from dataclasses import dataclass

from flexel.base.arrays import Array


@dataclass(frozen=True)
class Surface:
    """A surface fixed in a body.

    Attributes
    ----------
    name : str
    kind : str
        cylinder, plane, v_groove or round_groove; circle or line in planar models.
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

    @property
    def planar(self) -> bool:
        """Whether it lies in a planar model."""
        return self.centre.size == 2

    def element(self, touching: str) -> str:
        """The element type of what touches it: a cable, a point, a sphere or a disc."""
        return f"{'planar_' if self.planar else ''}{touching}_{self.kind}"
