"""Rigid bodies as declared: a point, an orientation and further points, under one name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from flexel.base.shown import prints
from flexel.model.handle import Handle
from flexel.model.node import Node


@dataclass(frozen=True)
class RigidBody(Handle):
    """A rigid body made by `Model.rigid_body`.

    Attributes
    ----------
    name : str
    point, frame : Node
        Its mass centre and its orientation.
    points : mapping of str to Node
        Further points, by name.
    """

    name: str
    point: Node
    frame: Node
    points: Mapping[str, Node]

    @prints
    def __repr__(self) -> str:
        points = f", points {', '.join(self.points)}" if self.points else ""
        return f"RigidBody('{self.name}': {self.point.name}, {self.frame.name}{points})"

    @property
    def planar(self) -> bool:
        """Whether it moves in the plane."""
        return self.point.kind == "planar_point"

    @property
    def still(self) -> bool:
        """Whether all its coordinates are fixed."""
        return bool(self.point.fixed.all() and self.frame.fixed.all())
