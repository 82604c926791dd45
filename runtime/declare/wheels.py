"""Wheels and tyres: the methods of `Model` that let a body roll on a road.

A `wheel` is rigid and touches the road at its own contact node; a `tyre` is compliant, has no contact node, and
needs laws on its deflection, camber and velocities.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.base.arguments import not_negative, number, positive, unknown, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import matrix, unit
from flexel.base.transactions import whole_or_nothing
from flexel.declare.laws import Laws
from flexel.generated.table import LAWS
from flexel.structure.nodes import Node

if TYPE_CHECKING:
    from flexel.derive.compile import CompiledLaw

Vector = Sequence[float] | Array
UP = (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Waves:
    """A road of cosine waves, flat before and after them; z is up.

    z = height + amplitude (1 - cos(2π s / wavelength)) / 2 while s = heading·(x, y) - start lies between 0 and
    count wavelengths.  One wave is a bump, many form a sine, a negative amplitude makes hollows.

    Parameters
    ----------
    amplitude, wavelength : float
        From trough to crest, and of one wave [m].
    start : float
        Where the first wave begins [m].
    count : int
        Number of waves, whole: a fraction would end in a step.
    heading : sequence of float (2,)
        Horizontal direction along which the road rises and falls.
    height : float
        Height of the flat road [m].
    """

    amplitude: float
    wavelength: float
    start: float = 0.0
    count: float = 1.0
    heading: tuple[float, float] = (1.0, 0.0)
    height: float = 0.0

    def parameters(self, owner: str) -> dict[str, Array]:
        """Parameters of the road, checked; a ModelError names the owner."""
        numbers = {
            "height": number(self.height, owner, "road height"),
            "amplitude": number(self.amplitude, owner, "amplitude of the waves"),
            "wavelength": positive(self.wavelength, owner, "wavelength"),
            "start": number(self.start, owner, "start of the waves"),
            "waves": not_negative(self.count, owner, "count of waves"),
        }
        if numbers["waves"] % 1:
            raise ModelError(
                f"{owner}: count of waves {numbers['waves']:g} is not whole, so the road would end in a step; give a "
                "whole number"
            )
        heading = unit(self.heading, owner, "heading of the waves", 2)
        return {z: np.array([value]) for z, value in numbers.items()} | {"heading": heading}

    def level(self, x: float, y: float) -> float:
        """Height of the road at a place."""
        x, y = number(x, "waves", "x"), number(y, "waves", "y")
        c, s = unit(self.heading, "waves", "heading", 2)
        part = (c * x + s * y - self.start) / self.wavelength
        waves = (1 - np.cos(2 * np.pi * part)) / 2 if 0 < part < self.count else 0.0
        return float(self.height + self.amplitude * waves)


class Wheels(Laws):
    """Wheels and tyres."""

    def wheel(
        self,
        name: str,
        hub: Node | str,
        frame: Node | str,
        contact: Node | str,
        *,
        radius: float,
        axle: Vector,
        normal: Vector = UP,
        height: float = 0.0,
        crown: float = 0.0,
    ) -> None:
        """Roll a rigid wheel without slip on the plane normal·x = height.

        Parameters
        ----------
        hub, frame : node
            Centre and orientation of the wheel.
        contact : node
            The point where it touches the road.
        radius : float
            From the axle to the outermost circle [m].
        axle : sequence of float (3,)
            Direction of the axle in global axes as drawn.
        normal : sequence of float (3,)
            Normal of the road, pointing up.
        crown : float
            Radius of the tyre's cross section [m], a toroidal wheel; zero makes a knife edge.

        Raises
        ------
        ModelError
            If the axle is normal to the road: the wheel lies flat and has no lowest point.

        Notes
        -----
        The slips ``longitudinal`` and ``lateral`` are zero (pure rolling); ``m.release("rear.lateral")`` frees one.
        """
        owner = f"wheel '{name}'"
        nodes = [
            self._find_of_kind(n, (k,), owner)
            for n, k in ((hub, "point"), (frame, "frame"), (contact, "point"))
        ]
        xw, rw, xc = (n.x0 for n in nodes)
        if np.linalg.norm(xc - xw) < 1e-12:
            raise ModelError(
                f"{owner}: contact point and hub coincide at {tuple(xw.tolist())}; put the contact on the road"
            )
        values = _rim(owner, rw, radius, axle, normal) | _plane(owner, normal, height)
        rounded = _crown(owner, crown, radius)
        if rounded["crown"][0]:
            values |= rounded
        self._place(name, "toroidal_wheel" if "crown" in values else "wheel", nodes, values)

    @whole_or_nothing
    def tyre(
        self,
        name: str,
        hub: Node | str,
        frame: Node | str,
        *,
        radius: float,
        axle: Vector,
        normal: Vector = UP,
        height: float = 0.0,
        crown: float = 0.0,
        road: Waves | None = None,
        law: str | CompiledLaw | None = None,
        **parameters: Any,
    ) -> None:
        """Put a compliant tyre on a wheel; all its quantities are free until laws act on them.

        Parameters
        ----------
        hub, frame : nodes
            Centre and orientation of the wheel.
        radius : float
            Radius of the unloaded tyre [m].
        axle : sequence of float (3,)
            Direction of the axle in global axes as drawn; with the road's normal up, to the wheel's left.
        normal, height : sequence of float (3,), float
            The plane road normal·x = height.
        crown : float
            Radius of the tyre's cross section [m]; zero makes a thin disc.
        road : Waves, optional
            A road with waves instead of the plane.
        law : str or CompiledLaw, optional
            A law of tyres, such as ``"linear_tyre"``, whose arguments are quantities of the tyre by their names; more
            laws are added by `attach` and `law`.
        **parameters
            Value of each of the law's parameters.

        Raises
        ------
        ModelError
            If the law has other arguments, or its parameters are not those given; if the axle is normal to the road,
            the hub is not above it, or a plane and waves are both given.

        Notes
        -----
        Deformations: ``deflection`` (in the plane of the wheel), ``drop`` (of the height of its centre), ``camber``,
        and on waves ``grade``.  Slips: ``forward`` and ``sideways`` of the centre, ``rolling`` about the axle,
        ``longitudinal`` and ``lateral`` of the contact point, ``spin`` about the normal.
        """
        owner = f"tyre '{name}'"
        nodes = [self._find_of_kind(n, (k,), owner) for n, k in ((hub, "point"), (frame, "frame"))]
        if road is not None and not isinstance(road, Waves):
            raise ModelError(f"{owner}: road {road!r} is not known; give fx.Waves(amplitude, wavelength)")
        height = number(height, owner, "road height")
        if road is not None and (np.any(vector(normal, owner, "road normal", 3) != UP) or height):
            raise ModelError(
                f"{owner}: a plane and waves are both given; drop the plane: waves define their own height, z up"
            )
        values = _rim(owner, nodes[1].x0, radius, axle, normal)
        values |= _crown(owner, crown, radius)
        values |= _plane(owner, normal, height) if road is None else road.parameters(owner)
        _check_above(owner, nodes[0].x0, values, road)
        self._place(name, "tyre" if road is None else "tyre_on_road", nodes, values)
        self._tyre_law(name, owner, law, parameters)

    def _tyre_law(
        self, name: str, owner: str, law: str | CompiledLaw | None, parameters: Mapping[str, Any]
    ) -> None:
        """Let a law act on the quantities of a tyre that have the names of its arguments."""
        if law is None:
            if parameters:
                raise ModelError(
                    f"{owner}: {', '.join(parameters)} given without a law; name one, law='linear_tyre'"
                )
            return
        spec = LAWS.get(law) if isinstance(law, str) else getattr(law, "spec", None)
        if spec is None:
            raise ModelError(f"{owner}: {unknown(str(law), LAWS, 'law')}")
        own = self.instances[name]
        there = [quantity.rpartition(".")[2] for quantity in (*own.deformations, *own.slips)]
        for wrong in [argument for argument in spec.arguments if argument.name not in there]:
            raise ModelError(
                f"{owner}: law '{spec.name}' acts on {wrong}; a tyre has {', '.join(there)}: use m.attach or m.law"
            )
        on = {argument.name: f"{name}.{argument.name}" for argument in spec.arguments}
        if isinstance(law, str):
            self.attach(law, on, **parameters)
        else:
            self.law(on, law, **parameters)

    def axle_slip(
        self,
        name: str,
        left: tuple[Node | str, Node | str],
        right: tuple[Node | str, Node | str],
        *,
        axle: Vector,
        normal: Vector = UP,
        height: float = 0.0,
    ) -> None:
        """Let two wheels on a plane road roll without mean sideways slip; the slip ``lateral`` is zero.

        Parameters
        ----------
        left, right : (hub, frame)
            Centre and orientation of each wheel.
        axle : sequence of float (3,)
            Direction of both axles in global axes as drawn.
        """
        owner = f"axle slip '{name}'"
        for side, given in (("left", left), ("right", right)):
            if not isinstance(given, (tuple, list)) or len(given) != 2:
                raise ModelError(f"{owner}: {side} {given!r} is not a hub and its frame; give (hub, frame)")
        nodes = [
            self._find_of_kind(n, (kind,), owner)
            for wheel_ in (left, right)
            for n, kind in zip(wheel_, ("point", "frame"), strict=True)
        ]
        values = _plane(owner, normal, height)
        for end, frame in (("p", nodes[1]), ("q", nodes[3])):
            values[f"axle_{end}"] = _rim(owner, frame.x0, 1.0, axle, normal)["axle"]
        self._place(name, "axle_slip", nodes, values)


def _rim(owner: str, frame: Array, radius: float, axle: Vector, normal: Vector) -> dict[str, Array]:
    """Radius, and axle in body axes, of a wheel that does not lie flat on the road."""
    a = unit(axle, owner, "axle")
    if np.linalg.norm(np.cross(a, unit(normal, owner, "road normal"))) < 1e-6:
        raise ModelError(
            f"{owner}: its axle {tuple(a.tolist())} is normal to the road, so no point is lowest; tilt it"
        )
    return {"radius": np.array([positive(radius, owner, "radius")]), "axle": matrix(frame).T @ a}


def _check_above(owner: str, hub: Array, values: Mapping[str, Array], road: Waves | None) -> None:
    """Raise a ModelError for a hub below the road as drawn, where the tyre would be pressed downwards."""
    above = values["normal"] @ hub - values["height"][0] if road is None else hub[2] - road.level(*hub[:2])
    if above <= 0:
        raise ModelError(
            f"{owner}: its hub lies {-above:g} m below the road as drawn; put it above, or turn the road's normal"
        )


def _crown(owner: str, crown: float, radius: float) -> dict[str, Array]:
    rho = not_negative(crown, owner, "crown")
    if rho >= radius:
        raise ModelError(f"{owner}: crown {rho:g} m reaches the axle; give less than the radius {radius:g} m")
    return {"crown": np.array([rho])}


def _plane(owner: str, normal: Vector, height: float) -> dict[str, Array]:
    n = unit(normal, owner, "road normal")
    return {"normal": n, "height": np.array([number(height, owner, "road height")])}
