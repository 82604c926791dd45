"""Plots by name: time histories, root loci, the mechanism at rest and moving, and the objects drawn with it.

Every function returns the matplotlib figure (or axes, or path) and writes it to a file if a path is given.
"""

from __future__ import annotations

from flexel.apps.view.animation import animate
from flexel.apps.view.histories import plot_histories
from flexel.apps.view.loci import root_loci
from flexel.apps.view.scene import draw
from flexel.apps.view.solids import Box, Cylinder, Mesh, Sketch

__all__ = ["Box", "Cylinder", "Mesh", "Sketch", "animate", "draw", "plot_histories", "root_loci"]
