"""Surfaces that ropes touch, as declared: geometry on a point and a frame of a body."""

from __future__ import annotations

from dataclasses import dataclass

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
