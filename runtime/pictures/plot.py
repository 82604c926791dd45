"""Plots by name: time histories, root loci, the mechanism at rest and moving, and what is drawn with it.

Every function returns the matplotlib figure (or axes, or path) and writes it to a file if a path is given.
"""

from __future__ import annotations

from flexel.pictures.animation import animate
from flexel.pictures.histories import plot_histories
from flexel.pictures.loci import root_loci
from flexel.pictures.scene import draw
from flexel.pictures.solids import Box, Cylinder, Mesh, Sketch

__all__ = ["Box", "Cylinder", "Mesh", "Sketch", "animate", "draw", "plot_histories", "root_loci"]
