"""Wheels and tyres: a body rolls on a road.

A `wheel` is rigid and touches the road at its contact node; a `tyre` is compliant, has no contact node, and
needs laws on its deflection, camber and velocities.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import KW_ONLY
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.base.arguments import not_negative, number, positive, unknown, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, described, entry, in_unit, quantity
from flexel.base.quaternions import matrix, unit
from flexel.generated.table import LAWS
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.laws import AttachedLaw, LawPart

if TYPE_CHECKING:
    from flexel.derive.compiled import CompiledLaw

UP = (0.0, 0.0, 1.0)


@described
class Waves:
    """A road of cosine waves, flat before and after them; z is up.

    z = height + amplitude (1 - cos(2π s / wavelength)) / 2 while s = heading·(x, y) - start lies between 0 and
    count wavelengths.  One wave is a bump, many form a sine, a negative amplitude makes hollows.

    Parameters
    ----------
    amplitude, wavelength : float
        Height from trough to crest, and length of one wave [m].
    start : float
        Where the first wave begins [m].
    count : int
        Whole number of waves: a fraction would end in a step.
    heading : sequence of float (2,)
        Horizontal direction along which the road rises and falls.
    height : float
        Height of the flat road [m].
    """

    amplitude: float = in_unit("m")
    wavelength: float = in_unit("m")
    start: float = in_unit("m", default=0.0)
    count: float = 1.0
    heading: tuple[float, float] = in_unit("-", default=(1.0, 0.0))
    height: float = in_unit("m", default=0.0)

    def parameters(self, owner: str) -> dict[str, Array]:
        """Return the parameters of the road, checked; a ModelError names the owner."""
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
        return {name: np.array([value]) for name, value in numbers.items()} | {"heading": heading}

    def level(self, x: float, y: float) -> float:
        """Return the height of the road at a point."""
        x, y = number(x, "waves", "x"), number(y, "waves", "y")
        c, s = unit(self.heading, "waves", "heading", 2)
        part = (c * x + s * y - self.start) / self.wavelength
        waves = (1 - np.cos(2 * np.pi * part)) / 2 if 0 < part < self.count else 0.0
        return float(self.height + self.amplitude * waves)


@part
class Wheel(Part[None]):
    """Roll a rigid wheel without slip on the plane normal·x = height.

    Raises
    ------
    ModelError
        If the axle is normal to the road: a flat wheel has no lowest point.

    Notes
    -----
    The slips ``longitudinal`` and ``lateral`` are zero (pure rolling); ``m.release("rear.lateral")`` frees one.
    """

    name: str = entry("Name of the element with the slips.")
    hub: Node | str = entry("Centre of the wheel.")
    frame: Node | str = entry("Orientation of the wheel.")
    contact: Node | str = entry("The point at which it touches the road.")
    _: KW_ONLY
    radius: float = quantity("m", "positive", "Radius, from the axle to the outermost circle.")
    axle: Vector = array_quantity("-", "Direction of the axle in global axes as drawn.")
    normal: Vector = array_quantity("-", "Normal of the road, pointing up.", default=UP)
    height: float = quantity(
        "m", "any", "Height of the road, along its normal.", default=0.0, called="road height"
    )
    crown: float = quantity(
        "m",
        "not negative",
        "Radius of the tyre's cross section [], which makes a toroidal wheel; zero makes a knife edge.",
        default=0.0,
    )

    def lower(self, to: Lowering) -> None:
        """Add the element between hub, frame and contact point."""
        nodes = _found(to, self.owner, (self.hub, "point"), (self.frame, "frame"), (self.contact, "point"))
        hub, frame, contact = (node.x0 for node in nodes)
        if np.linalg.norm(contact - hub) < 1e-12:
            raise ModelError(
                f"{self.owner}: contact point and hub coincide at {tuple(hub.tolist())}; put the contact on the road"
            )
        values = _rim(self.owner, frame, self.radius, self.axle, self.normal)
        values |= _plane(self.owner, self.normal, self.height)
        if self.crown:
            values |= _crown(self.owner, self.crown, self.radius)
        to.element(self.name, "toroidal_wheel" if self.crown else "wheel", nodes, values)


@part
class Tyre(Part[None]):
    """Put a compliant tyre on a wheel; all its quantities are free until laws act on them.

    Raises
    ------
    ModelError
        If the law's arguments or parameters do not match; if the axle is normal to the road, the hub is not above it,
        or a plane and waves are both given.

    Notes
    -----
    Deformations: ``deflection`` (in the plane of the wheel), ``drop`` (of the height of its centre), ``camber``,
    and on waves ``grade``.  Slips: ``forward`` and ``sideways`` of the centre, ``rolling`` about the axle,
    ``longitudinal`` and ``lateral`` of the contact point, ``spin`` about the normal.
    """

    name: str = entry("Name of the element with the deformations and slips.")
    hub: Node | str = entry("Centre of the wheel.")
    frame: Node | str = entry("Orientation of the wheel.")
    _: KW_ONLY
    radius: float = quantity("m", "positive", "Radius of the unloaded tyre.")
    axle: Vector = array_quantity(
        "-", "Direction of the axle in global axes as drawn, to the wheel's left with the road's normal up."
    )
    normal: Vector = array_quantity("-", "Normal of the plane road normal·x = height.", default=UP)
    height: float = quantity("m", "any", "Height of the plane road.", default=0.0, called="road height")
    crown: float = quantity(
        "m", "not negative", "Radius of the tyre's cross section; zero makes a thin disc.", default=0.0
    )
    road: Waves | None = entry("A road with waves instead of the plane.", default=None)
    law: str | CompiledLaw | None = entry(
        'A law of tyres, such as ``"linear_tyre"``, whose arguments are quantities of the tyre by name; add more '
        "laws with `attach` and `law`.",
        default=None,
    )
    initial: Mapping[str, float] | None = array_quantity(
        "", "Initial values of the law's internal states; zero by default.", default=None
    )
    parameters: Mapping[str, Any] | None = entry(
        "Value of each of the law's parameters.", default=None, spread=True
    )

    def lower(self, to: Lowering) -> None:
        """Add the element, and the law."""
        owner = self.owner
        nodes = _found(to, owner, (self.hub, "point"), (self.frame, "frame"))
        if self.road is not None:
            _check_road(self, self.road)
        values = _rim(owner, nodes[1].x0, self.radius, self.axle, self.normal)
        values |= _crown(owner, self.crown, self.radius)
        values |= (
            _plane(owner, self.normal, self.height) if self.road is None else self.road.parameters(owner)
        )
        _check_above(owner, nodes[0].x0, values, self.road)
        to.element(self.name, "tyre" if self.road is None else "tyre_on_road", nodes, values)
        _add_law(to, self)


def _check_road(tyre: Tyre, road: object) -> None:
    """Check that a road has waves, and that there is no plane besides."""
    if not isinstance(road, Waves):
        raise ModelError(f"{tyre.owner}: road {road!r} is not known; give fx.Waves(amplitude, wavelength)")
    if np.any(vector(tyre.normal, tyre.owner, "road normal", 3) != UP) or tyre.height:
        raise ModelError(
            f"{tyre.owner}: a plane and waves are both given; drop the plane: waves define the height, with z up"
        )


def _add_law(to: Lowering, tyre: Tyre) -> None:
    """Let a law act on the quantities of a tyre that have the names of its arguments."""
    owner, law, parameters = tyre.owner, tyre.law, tyre.parameters or {}
    if law is None:
        if given := [*(["initial"] if tyre.initial is not None else []), *parameters]:
            raise ModelError(f"{owner}: {', '.join(given)} given without a law; name one, law='linear_tyre'")
        return
    spec = LAWS.get(law) if isinstance(law, str) else getattr(law, "spec", None)
    if spec is None:
        raise ModelError(f"{owner}: {unknown(str(law), LAWS, 'law')}")
    own = to.instances[tyre.name]
    there = [name.rpartition(".")[2] for name in (*own.deformations, *own.slips)]
    for wrong in [argument for argument in spec.arguments if argument.name not in there]:
        raise ModelError(
            f"{owner}: law '{spec.name}' acts on {wrong}; a tyre has {', '.join(there)}: use m.attach or m.law"
        )
    on = {argument.name: f"{tyre.name}.{argument.name}" for argument in spec.arguments}
    if isinstance(law, str):
        AttachedLaw(law, on, initial=tyre.initial, parameters=parameters).lower(to)
    else:
        LawPart(on, law, initial=tyre.initial, parameters=parameters).lower(to)


@part
class AxleSlip(Part[None]):
    """Let two wheels on a plane road roll without mean sideways slip; the slip ``lateral`` is zero."""

    name: str = entry("Name of the element with the slip.")
    left: tuple[Node | str, Node | str] = entry("Centre and orientation of the left wheel: (hub, frame).")
    right: tuple[Node | str, Node | str] = entry("Centre and orientation of the right wheel: (hub, frame).")
    _: KW_ONLY
    axle: Vector = array_quantity("-", "Direction of both axles in global axes as drawn.")
    normal: Vector = array_quantity("-", "Normal of the plane road normal·x = height.", default=UP)
    height: float = quantity("m", "any", "Height of the plane road.", default=0.0, called="road height")

    def lower(self, to: Lowering) -> None:
        """Add the element between both wheels."""
        ends: list[tuple[Node | str, str]] = []
        for side, given in (("left", self.left), ("right", self.right)):
            if not isinstance(given, (tuple, list)) or len(given) != 2:
                raise ModelError(
                    f"{self.owner}: {side} {given!r} is not a hub and its frame; give (hub, frame)"
                )
            ends += zip(given, ("point", "frame"), strict=True)
        nodes = _found(to, self.owner, *ends)
        values = _plane(self.owner, self.normal, self.height)
        for end, frame in (("p", nodes[1]), ("q", nodes[3])):
            values[f"axle_{end}"] = _rim(self.owner, frame.x0, 1.0, self.axle, self.normal)["axle"]
        to.element(self.name, "axle_slip", nodes, values)


def _found(to: Lowering, owner: str, *nodes: tuple[Node | str, str]) -> list[Node]:
    """Find nodes of a model in space, each of the kind that is needed."""
    return [to.find_of_kind(node, (kind,), owner) for node, kind in nodes]


def _rim(owner: str, frame: Array, radius: float, axle: Vector, normal: Vector) -> dict[str, Array]:
    """Return radius, and axle in body axes, of a wheel that does not lie flat on the road."""
    a = unit(axle, owner, "axle")
    if np.linalg.norm(np.cross(a, unit(normal, owner, "road normal"))) < 1e-6:
        raise ModelError(
            f"{owner}: its axle {tuple(a.tolist())} is normal to the road, so it has no lowest point; tilt it"
        )
    return {"radius": np.array([radius]), "axle": matrix(frame).T @ a}


def _check_above(owner: str, hub: Array, values: Mapping[str, Array], road: Waves | None) -> None:
    """Raise a ModelError for a hub below the road as drawn, where the tyre would be pressed downwards."""
    above = values["normal"] @ hub - values["height"][0] if road is None else hub[2] - road.level(*hub[:2])
    if above <= 0:
        raise ModelError(
            f"{owner}: its hub lies {-above:g} m below the road as drawn; put it above, or turn the road's normal"
        )


def _crown(owner: str, crown: float, radius: float) -> dict[str, Array]:
    """Return the radius of the cross section of a wheel, less than the wheel's radius."""
    if crown >= radius:
        raise ModelError(
            f"{owner}: crown {crown:g} m reaches the axle; give less than the radius {radius:g} m"
        )
    return {"crown": np.array([crown])}


def _plane(owner: str, normal: Vector, height: float) -> dict[str, Array]:
    """Return normal and height of a plane road."""
    return {"normal": unit(normal, owner, "road normal"), "height": np.array([height])}
