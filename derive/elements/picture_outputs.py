"""Outputs for pictures: frames and axes of elements, displacements along them, forces on what they touch."""

from sympy import Expr, Matrix, cos, sin, zeros

from flexel.derive.declare import Node, Output

FRAME = ("origin", "axes")  # names of the outputs of a frame
LINK_DOC = "\naxes: the directions in rows;  displacement: the deformations that are lengths"
WHEELS_DOC = "\norigin_p, axes_p, origin_q, axes_q: frames of both wheels at xp and xq, the axes in rows"
FRAME_DOC = "\norigin: {origin}, axes: {axes} in rows: the frame that carries what a picture shows"


def planar_axes(angle: Expr) -> tuple[Matrix, Matrix]:
    """Return the axes of a part of a planar element that is turned by an angle."""
    return Matrix([cos(angle), sin(angle)]), Matrix([-sin(angle), cos(angle)])


def axes(*directions: Matrix, of: str = "") -> Output:
    """Declare the directions of an element as drawn, a row each."""
    return Output(f"axes{of}", "1", Matrix.hstack(*directions).T)


def frame(origin: Matrix, *directions: Matrix, of: str = "") -> tuple[Output, Output]:
    """Declare a frame that moves with a part of the element: origin and axes, a row each; `of` ends their names."""
    return Output(f"origin{of}", "m", origin), axes(*directions, of=of)


def displacement(relative: Matrix) -> Output:
    """Declare the displacement along the axes, zero as drawn."""
    return Output("displacement", "m", relative)


def force(*points: Node) -> Output:
    """Declare the total force of the element on some of its points."""
    total = sum((point.f for point in points), zeros(points[0].size, 1))
    return Output("force", "N", -total)
