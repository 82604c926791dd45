"""Belts, gears, surfaces to move on, rolling wheels in the plane, rotary inertia: the methods of `Model` for them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import array, not_negative, number, positive, span, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import unit
from flexel.base.transactions import whole_or_nothing
from flexel.declare.springs import Springs
from flexel.structure.nodes import Node

PLANAR_ENDS = ("planar_point", "planar_angle", "planar_point", "planar_angle")


class Couplings(Springs):
    """Belts, gears and surfaces."""

    @whole_or_nothing
    def planar_belt(
        self,
        name: str,
        p: Node | str,
        angle_p: Node | str,
        q: Node | str,
        angle_q: Node | str,
        *,
        radius_p: float,
        radius_q: float,
        stiffness: float | None = None,
        damping: float = 0.0,
    ) -> None:
        """Add the straight part of a belt between two pulleys in the plane, unstretched as drawn.

        Parameters
        ----------
        p, angle_p, q, angle_q : node
            Centre and angle of each pulley.
        radius_p, radius_q : float
            Radii [m]; positive if the belt is on the left looking from p to q, negative if on the right; opposite
            signs for a crossed belt.
        stiffness : float, optional
            EA / length [N/m]; without it the belt does not stretch.
        damping : float
            [N s/m]

        Raises
        ------
        ModelError
            Pulleys that overlap.

        See Also
        --------
        belt : Pulleys on joints of one body, in the plane and in space.

        Notes
        -----
        The line of centres may turn by less than half a turn from its drawn direction.
        """
        owner = f"planar belt '{name}'"
        nodes = _ends(self, owner, (p, angle_p, q, angle_q))
        a, b = number(radius_p, owner, "radius_p"), number(radius_q, owner, "radius_q")
        e, distance = span(nodes[0].x0, nodes[2].x0, owner)
        if distance <= abs(a - b):
            raise ModelError(
                f"{owner}: the centres are {distance:g} m apart, so radii {a:g} and {b:g} have no common "
                "tangent; move them"
            )
        length = np.sqrt(distance**2 - (a - b) ** 2)
        turn = -np.arctan2(a - b, length)
        zero = length + a * (nodes[1].x0 - turn) - b * (nodes[3].x0 - turn)
        values = {
            "radius_p": np.array([a]),
            "radius_q": np.array([b]),
            "psi0": np.array([np.arctan2(e[1], e[0])]),
            "zero": zero,
        }
        self._place(name, "planar_belt", nodes, values)
        d = not_negative(damping, owner, "damping")
        if stiffness is not None:
            self.spring(f"{name}.elongation", positive(stiffness, owner, "stiffness"), d)
        elif d:
            raise ModelError(f"{owner}: damping has no effect without stiffness; give one, or drop it")

    def planar_gear(
        self,
        name: str,
        p: Node | str,
        angle_p: Node | str,
        q: Node | str,
        angle_q: Node | str,
        *,
        radius_p: float,
        radius_q: float,
    ) -> None:
        """Mesh two gears in the plane, in contact as drawn; their centres may move, as on a planet carrier.

        Parameters
        ----------
        p, angle_p, q, angle_q : node
            Centre and angle of each gear.
        radius_p, radius_q : float
            Pitch radii [m], or numbers of teeth; that of an internal gear is negative.

        Raises
        ------
        ModelError
            Radii that are zero or add up to zero.

        See Also
        --------
        gear : Gears on joints of one body, in the plane and in space: spur, bevel, worm.
        """
        owner = f"planar gear '{name}'"
        nodes = _ends(self, owner, (p, angle_p, q, angle_q))
        a, b = number(radius_p, owner, "radius_p"), number(radius_q, owner, "radius_q")
        if not a or not b or not a + b:
            raise ModelError(
                f"{owner}: pitch radii {a:g} and {b:g} do not mesh; give two whose sum is not zero"
            )
        e, _ = span(nodes[0].x0, nodes[2].x0, owner)
        together = (a * nodes[1].x0 + b * nodes[3].x0) / (a + b)
        offset = np.arctan2(e[1], e[0]) - together
        values = {"radius_p": np.array([a]), "radius_q": np.array([b]), "offset0": offset}
        self._place(name, "planar_gear", nodes, values)

    def quadric(
        self,
        name: str,
        point: Node | str,
        *,
        quadratic: Any = (0.0,) * 6,
        linear: Any = (0.0,) * 3,
        constant: float = 0.0,
    ) -> None:
        """Keep a point on the surface p(x, y, z) = 0, p of second degree: a plane, sphere, cylinder, cone, paraboloid …

        Parameters
        ----------
        point : node
            A point drawn off the surface moves onto it when the system is built; a point far off is named in a warning.
        quadratic : sequence of float (6,) or array (3, 3)
            Factors of x², y², z², xy, xz, yz [1/m], or a symmetric matrix A for x'A x.
        linear : sequence of float (3,)
            Factors of x, y, z.
        constant : float
            [m]

        Notes
        -----
        The deformation ``height`` is the value of the polynomial, which is zero on the surface; near it, the distance
        from the surface times the length of the gradient.

        Examples
        --------
        >>> m.quadric("bowl", "ball", quadratic=np.eye(3), constant=-0.25)  # a sphere of 0.5 m  # doctest: +SKIP
        """
        owner = f"quadric '{name}'"
        node = self._find_of_kind(point, ("point",), owner)
        A = array(quadratic, owner, "quadratic")
        if A.shape == (3, 3):
            S = (A + A.T) / 2
            A = np.array([S[0, 0], S[1, 1], S[2, 2], 2 * S[0, 1], 2 * S[0, 2], 2 * S[1, 2]])
        values = {
            "quadratic": vector(A, owner, "quadratic", 6),
            "linear": vector(linear, owner, "linear", 3),
            "constant": np.array([number(constant, owner, "constant")]),
        }
        if not np.any(values["quadratic"]) and not np.any(values["linear"]):
            raise ModelError(
                f"{owner}: all its factors are zero, which is not a surface; give quadratic or linear ones"
            )
        self._place(name, "surface", [node], values)

    def planar_wheel(
        self,
        name: str,
        point: Node | str,
        heading: Node | str,
        spin: Node | str,
        *,
        radius: float,
        direction: Sequence[float] | Array = (1.0, 0.0),
    ) -> None:
        """Roll an upright wheel on the plane itself; with `spin` fixed, a skate that is dragged along.

        Parameters
        ----------
        point : node
            Centre of the wheel.
        heading, spin : node
            Angles of the wheel about the normal of the plane and about its axle.
        radius : float
            [m]; a skate whose slip ``longitudinal`` is released may have any.
        direction : sequence of float (2,)
            Direction of travel as drawn.

        See Also
        --------
        skate : A knife edge without a spin.
        """
        owner = f"planar wheel '{name}'"
        given = (point, "planar_point"), (heading, "planar_angle"), (spin, "planar_angle")
        nodes = [self._find_of_kind(node, (kind,), owner) for node, kind in given]
        t = unit(direction, owner, "direction", 2)
        alpha0 = np.arctan2(t[1], t[0]) - nodes[1].x0
        self._place(
            name,
            "planar_wheel",
            nodes,
            {"radius": np.array([positive(radius, owner, "radius")]), "alpha0": alpha0},
        )

    def rotary_inertia(self, name: str, frame: Node | str, inertia: Any) -> None:
        """Give an orientation node a rotary inertia [kg m²] without mass.

        Parameters
        ----------
        inertia : array_like
            In body axes: (xx, yy, zz, xy, xz, yz) as tensor components or a symmetric (3, 3), which need not be the
            inertia of a real body; one number in a planar model.
        """
        owner = f"rotary inertia '{name}'"
        node = self._find_of_kind(frame, ("frame", "planar_angle"), owner)
        if node.kind == "planar_angle":
            self._place(
                name, "planar_rotary_inertia", [node], {"J": np.array([positive(inertia, owner, "inertia")])}
            )
            return
        J = array(inertia, owner, "inertia")
        if J.shape == (6,):
            xx, yy, zz, xy, xz, yz = J
            J = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        if J.shape != (3, 3) or np.max(np.abs(J - J.T)) > 1e-12 * np.max(np.abs(J)):
            raise ModelError(
                f"{owner}: {J.tolist()} is not a tensor; give (xx, yy, zz, xy, xz, yz) or a symmetric 3x3"
            )
        if np.linalg.eigvalsh(J)[0] < -1e-12 * np.max(np.abs(J)):
            raise ModelError(f"{owner}: a principal moment of {J.tolist()} is negative; check the signs")
        six = np.array([J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]])
        self._place(name, "rotary_inertia", [node], {"J": six})


def _ends(model: Springs, owner: str, given: Sequence[Node | str]) -> list[Node]:
    return [model._find_of_kind(node, (kind,), owner) for node, kind in zip(given, PLANAR_ENDS, strict=True)]
