"""Nodes of an element, by kind."""

from dataclasses import dataclass

from sympy import Matrix

from flexel.derive.declare.symbols import symbol


@dataclass(frozen=True)
class Node:
    """Node of an element: a name and the names of its coordinates (use `Point`, `Frame`, ... to make one)."""

    name: str
    kind: str
    components: tuple[str, ...]

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.components)

    @property
    def x(self) -> Matrix:
        """Coordinates, column (size, 1), named ``p_x`` and so on."""
        return Matrix([symbol(f"{self.name}_{c}") for c in self.components])

    @property
    def v(self) -> Matrix:
        """Rates of the coordinates, column (size, 1), named ``p_vx`` and so on."""
        return Matrix([symbol(f"{self.name}_v{c}") for c in self.components])

    @property
    def f(self) -> Matrix:
        """Generalized forces De' sigma + V' tau at the node, column (size, 1), for outputs: ``p_fx`` and so on.

        The element exerts their opposites on the node.
        """
        return Matrix([symbol(f"{self.name}_f{c}") for c in self.components])


def Point(name: str) -> Node:  # noqa: N802 (a kind of node)
    """Declare a position in space: x, y, z [m]."""
    return Node(name, "point", ("x", "y", "z"))


def Frame(name: str) -> Node:  # noqa: N802
    """Declare an orientation in space: Euler parameters l0, l1, l2, l3 [1]."""
    return Node(name, "frame", ("l0", "l1", "l2", "l3"))


def PlanarPoint(name: str) -> Node:  # noqa: N802
    """Declare a position in the plane: x, y [m]."""
    return Node(name, "planar_point", ("x", "y"))


def PlanarAngle(name: str) -> Node:  # noqa: N802
    """Declare an orientation in the plane: one angle [rad]."""
    return Node(name, "planar_angle", ("angle",))


def Slope(name: str) -> Node:  # noqa: N802
    """Declare a slope, dr/ds of a cable by undeformed arc length: x, y, z [1]; a unit vector if unstretched."""
    return Node(name, "slope", ("x", "y", "z"))


def PlanarSlope(name: str) -> Node:  # noqa: N802
    """Declare a slope in the plane, dr/ds of a cable by undeformed arc length: x, y [1]."""
    return Node(name, "planar_slope", ("x", "y"))


def Warping(name: str) -> Node:  # noqa: N802
    """Declare the warping of a section: the twist of the beam per length there [rad/m]."""
    return Node(name, "warping", ("twist",))
