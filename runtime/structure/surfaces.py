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
        The element type that finds the gap of a rope's point.
    point, frame : str
        Nodes of the body: the surface's centre, or a point of the plane, and the orientation.
    parameters : dict of str to ndarray
        Of the element, those of the surface.
    radius : float
        At which the rope's surface touches [m]; 0 for a plane.
    centre, axle : ndarray
        As drawn; the axle is the normal for a plane, and (0, 0, 1) in planar models.
    gaps : tuple of (str, tuple of str)
        Deformations that close, each with the slips along the surface there.
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
