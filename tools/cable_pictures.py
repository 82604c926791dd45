"""Draw the two pictures of cables on the page of the theory: ``python tools/cable_pictures.py``.

They are figures 1 and 2 of the paper on ropes, with the shape functions of its equation (6), and the points of
`fx.Contact`.
"""

from typing import Any

import numpy as np
from filling import DOCS

import flexel as fx
from flexel.apps.view.figures import COLOURS, figure, save
from flexel.base.arrays import Array

OUT = DOCS / "images"
P, SLOPE_P, Q, SLOPE_Q = map(np.array, ((0.0, 0.0), (0.8, 0.6), (1.0, 0.0), (0.7, -0.7)))
RADIUS, ROPE_RADIUS = 0.7, 0.05  # of the sheave and of the rope [m]


def curve(xi: Array) -> Array:
    """Return places (n, 2) on an element of length 1: r = S x with the shape functions of equation (6)."""
    shapes = (1 - 3 * xi**2 + 2 * xi**3, xi - 2 * xi**2 + xi**3, 3 * xi**2 - 2 * xi**3, xi**3 - xi**2)
    return np.asarray(np.stack(shapes, axis=1) @ np.array([P, SLOPE_P, Q, SLOPE_Q]))


def element() -> None:
    """Draw the nodes with their slopes, and a point of the centre line."""
    with figure(1, 1, (6.0, 2.8)) as (drawn, axes):
        axes.plot(*curve(np.linspace(0, 1, 101)).T, color=COLOURS[0], linewidth=3)
        for place, slope, name in ((P, SLOPE_P, "p"), (Q, SLOPE_Q, "q")):
            _arrow(axes, place, 0.3 * slope, COLOURS[1], rf"$\partial r/\partial s$ at {name}")
            axes.plot(*place, "o", color=COLOURS[0], markersize=8)
            axes.annotate(f"node {name}", place, (-6, -16), textcoords="offset points", ha="right")
        middle = curve(np.array([0.45]))[0]
        axes.plot(*middle, "o", color="black", markersize=4)
        axes.annotate(r"$r(\xi)$", middle, (0, -16), textcoords="offset points", ha="center")
        _bare(axes)
        save(drawn, OUT / "cable_element.png")


def contact() -> None:
    """Draw five points of contact of an element on a sheave, with the normal and tangential force at one."""
    xi, _ = fx.Contact(1e9).rule()
    line, points = curve(np.linspace(0, 1, 101)), curve(xi)
    top = line[np.argmax(line[:, 1])]
    centre = top - (0.0, RADIUS + ROPE_RADIUS)
    angle = np.linspace(0.15 * np.pi, 0.85 * np.pi, 101)
    with figure(1, 1, (6.0, 3.6)) as (drawn, axes):
        axes.plot(*line.T, color=COLOURS[0], linewidth=3)
        axes.plot(
            *(centre[:, None] + RADIUS * np.array([np.cos(angle), np.sin(angle)])),
            color="#55606a",
            linewidth=2,
        )
        axes.plot(*points.T, "o", color="black", markersize=5)
        off = points[3] - centre
        normal = off / np.linalg.norm(off)
        tangent = np.array([normal[1], -normal[0]])
        _arrow(axes, points[3], 0.25 * normal, COLOURS[1], r"$f_n\, n$")
        _arrow(axes, points[3], 0.2 * tangent, COLOURS[2], r"$f_t\, t$")
        axes.plot(*np.stack([centre, points[3]]).T, "--", color="#55606a", linewidth=0.8)
        axes.plot(*centre, "+", color="#55606a")
        axes.annotate("centre of the body", centre, (8, 0), textcoords="offset points")
        _bare(axes)
        save(drawn, OUT / "cable_contact.png")


def _arrow(axes: Any, start: Array, vector: Array, colour: str, label: str) -> None:
    """Draw a vector with its name at its end."""
    axes.plot(*(start + vector), alpha=0)  # so that it is within the picture
    axes.annotate(
        "", start + vector, start, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.5}
    )
    axes.annotate(label, start + vector, (4, 4), textcoords="offset points", color=colour)


def _bare(axes: Any) -> None:
    axes.set_aspect("equal")
    axes.margins(0.15)
    axes.set_axis_off()


if __name__ == "__main__":
    element()
    contact()
