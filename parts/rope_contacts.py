"""Contact of cables with surfaces, and the law of a contact."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import names, not_negative, positive, text, unknown, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import described, entry, in_unit, quantity
from flexel.generated.table import LAWS
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.model.surfaces import Surface
from flexel.parts.cable_lines import CableLine, contact_radius, find_line
from flexel.parts.impact import dissipation

RELEASE = 1e3  # rate [1/s] at which the bristles of an open contact relax


@described
class Contact:
    """Contact of a cable, or of a point or sphere of a body: normal force and friction, and the points of a cable.

    Parameters
    ----------
    stiffness : float
        Normal force per penetration^exponent: per length of rope [N/m^(exponent + 1)], or per point if per="point" and
        for the one point of `Model.contact` [N/m^exponent].
    exponent : float
        3/2 for Hertz's point contact.
    dissipation : float
        Relative increase of the normal force per speed of approach [s/m]; `restitution` computes it from an impact.
    friction : float
        Coefficient of friction.
    slip_speed : float
        Coulomb friction is regularized: 71 % of it acts at this speed [m/s].
    bristle_stiffness : float, optional
        Alternative: bristles that stick, deflected by friction/bristle_stiffness when they slide [1/m].
    bristle_damping : float
        [s/m]
    points : int
        Per element of a cable.
    places : str
        Positions of these points: "gauss", with Gauss weights, or "equidistant".
    per : str, optional
        "length": forces per length times the weights of the points, independent of the mesh; or "point". By
        default "length" for cables, and "point" for `Model.contact`, which refuses "length".
    """

    stiffness: float = in_unit("N/m^(exponent + 1)")
    exponent: float = in_unit("-", default=1.5)
    dissipation: float = in_unit("s/m", default=0.0)
    friction: float = in_unit("-", default=0.0)
    slip_speed: float = in_unit("m/s", default=1e-2)
    bristle_stiffness: float | None = in_unit("1/m", default=None)
    bristle_damping: float = in_unit("s/m", default=0.0)
    points: int = 5
    places: str = "gauss"
    per: str | None = None

    def __post_init__(self) -> None:
        positive(self.stiffness, "contact", "stiffness")
        if not_negative(self.exponent, "contact", "exponent") < 1:
            raise ModelError(
                f"contact: exponent {self.exponent:g} is below 1; the stiffness would be infinite at first contact"
            )
        for name in ("dissipation", "friction", "bristle_damping"):
            not_negative(getattr(self, name), "contact", name)
        positive(self.slip_speed, "contact", "slip_speed")
        if self.bristle_stiffness is not None:
            positive(self.bristle_stiffness, "contact", "bristle_stiffness")
            positive(self.friction, "contact with bristles", "friction")
        whole(self.points, "contact", "number of points", 1, 50)
        text(self.places, "contact", "places")
        if self.per is not None:
            text(self.per, "contact", "per")
        if self.places not in ("gauss", "equidistant") or self.per not in (None, "length", "point"):
            raise ModelError(
                f"contact: places {self.places!r}, per {self.per!r}; choose 'gauss' or 'equidistant', "
                "'length' or 'point'"
            )

    @classmethod
    def restitution(
        cls, stiffness: float, restitution: float, speed: float, *, law: str = "exact", **others: Any
    ) -> Contact:
        """Make a contact whose dissipation follows from a coefficient of restitution.

        Parameters
        ----------
        stiffness : float
            As for the class.
        restitution : float
            Speed of departure over speed of approach, 0.001 to 1; from 0 with the approximations below.
        speed : float
            Speed of approach at which this holds [m/s].
        law : "exact", "hunt-crossley" or "lankarani-nikravesh"
            Dissipation factor c: the one with which an impact at that speed v has the restitution e,
            c v (1 + e) = ln((1 + c v)/(1 - c e v)), or an approximation of the literature for e near 1:
            3 (1 - e)/(2 v) or 3 (1 - e²)/(4 v).
        **others
            Exponent, friction and the rest, as for the class.

        Examples
        --------
        >>> import flexel as fx
        >>> fx.Contact.restitution(1e8, 0.9, 0.5, law="lankarani-nikravesh").dissipation
        0.285
        """
        return cls(stiffness, dissipation=dissipation(restitution, speed, law), **others)

    def rule(self) -> tuple[Array, Array]:
        """Return positions on (0, 1) and weights of sum 1 of the points of an element."""
        if self.places == "gauss":
            xi, weight = np.polynomial.legendre.leggauss(self.points)
            return (1 + xi) / 2, weight / 2
        return (np.arange(self.points) + 0.5) / self.points, np.full(self.points, 1 / self.points)

    def depth(self, load: float, length: float) -> float:
        """Return the penetration [m] at which elements of a given length [m] carry a line load [N/m]."""
        load, length = not_negative(load, "contact", "load"), not_negative(length, "contact", "length")
        share = load * length / self.points if self.per == "point" else load
        return float((share / self.stiffness) ** (1 / self.exponent))

    def law(self, slips: int, weight: float) -> tuple[str, dict[str, Array]]:
        """Return the name and parameters of the law of a point for a length of rope [m]; 1 for a point of a body."""
        share = 1.0 if self.per == "point" else weight
        values: dict[str, float] = {
            "stiffness": self.stiffness * share,
            "exponent": self.exponent,
            "dissipation": self.dissipation,
        }
        name = "hertz"
        if self.friction and self.bristle_stiffness is None:
            name = f"hertz_coulomb_{slips}"
            values |= {"friction": self.friction, "slip_speed": self.slip_speed}
        elif self.friction and self.bristle_stiffness is not None:
            name = f"hertz_bristle_{slips}"
            values |= {
                "friction": self.friction,
                "bristle_stiffness": self.bristle_stiffness,
                "bristle_damping": self.bristle_damping,
                "release": RELEASE,
            }
        return name, {key: np.array([value]) for key, value in values.items()}


@dataclass(frozen=True)
class ContactPoint:
    """One point of a cable over one surface: its element, position (undeformed arc length [m]) and weight [m]."""

    element: str
    surface: Surface
    cable: str
    xi: float
    s: float
    weight: float


@part
class RopeContact(Part[list[ContactPoint]]):
    """Let cables touch a surface: elements ``cable@surface#i``, with a gap, slips along the surface, and their law.

    Raises
    ------
    ModelError
        An unknown surface or element, planar and spatial ones mixed, a rope wider than its groove.
    """

    cables: CableLine | str = entry("The result of `Model.cable_line` or `Model.rope`, or its name.")
    surface: Surface | str = entry("A sheave, drum or plane.")
    contact: Contact = entry("Normal force, friction and points.")
    _: KW_ONLY
    radius: float | None = quantity(
        "m", "not negative", "Radius of the rope; half the diameter of its section by default.", default=None
    )
    only: Sequence[str] | None = entry(
        "Names of elements of the cable that may touch; all by default.", default=None
    )

    @property
    def owner(self) -> str:
        """Its name in messages: the rope and the surface."""
        return f"contact of '{name_of(self.cables)}' with '{name_of(self.surface)}'"

    @property
    def label(self) -> str:
        """By the rope and the surface, as its elements."""
        return f"{name_of(self.cables)}@{name_of(self.surface)}"

    def lower(self, to: Lowering) -> list[ContactPoint]:
        """Add the elements of contact, then their laws."""
        line = find_line(to, self.cables, "rope_contact")
        surface = find_surface(to, self.surface, f"contact of '{line.name}'")
        check_contact(self.contact, self.owner)
        radius = contact_radius(line.radius, self.radius, self.owner)
        check_fits("rope", radius, surface, self.owner)
        _check_lead(radius, surface, self.owner)
        members = line.elements if self.only is None else names(self.only, f"{self.owner}: only")
        for name in members:
            if name not in line.elements:
                raise ModelError(f"{self.owner}: {unknown(str(name), line.elements, 'element')}")
        made = [
            point
            for name in members
            for point in _touching(to, line, line.elements.index(name), surface, radius, self.contact)
        ]
        for point in made:
            attach_contact(to, point.element, surface.gaps, self.contact, point.weight)
        return made


def _touching(
    to: Lowering, line: CableLine, i: int, surface: Surface, radius: float, contact: Contact
) -> list[ContactPoint]:
    """Add the elements of contact of the cable of number i of a line."""
    name, s0, l0 = line.elements[i], float(line.s[i]), float(line.s[i + 1] - line.s[i])
    nodes = [*to.instances[name].nodes, surface.point, surface.frame]
    made = []
    for j, (xi, weight) in enumerate(zip(*contact.rule(), strict=True)):
        element = f"{name}@{surface.name}#{j + 1}"
        own = {"l0": np.array([l0]), "xi": np.array([xi]), "rope_radius": np.array([radius])}
        to.element(element, surface.element("cable"), nodes, surface.parameters | own)
        made.append(ContactPoint(element, surface, name, float(xi), s0 + xi * l0, weight * l0))
    return made


def _check_lead(radius: float, surface: Surface, owner: str) -> None:
    """Raise a ModelError for a helical groove whose turns are narrower than the rope."""
    lead = 2 * np.pi * abs(surface.pitch)
    if 0 < lead < 2 * radius:
        raise ModelError(
            f"{owner}: a lead of {lead:g} m is smaller than the diameter of the rope, {2 * radius:g} m, so that its "
            "turns would overlap; give a larger lead, usually 1.1 to 1.2 times the diameter"
        )


def attach_contact(
    to: Lowering, element: str, gaps: tuple[tuple[str, tuple[str, ...]], ...], contact: Contact, weight: float
) -> None:
    """Add the law of every gap of an element of contact; `weight` is the length of rope [m] that it represents."""
    for gap, slips in gaps:
        law, values = contact.law(len(slips), weight)
        spec, label = LAWS[law], f"{element} {gap}"
        on = [f"{element}.{own}" for own in ((gap, *slips) if spec.slips else (gap,))]
        to.law(f"contact '{label}'", spec, on, values, label=label)


def check_fits(what: str, radius: float, surface: Surface, owner: str) -> None:
    """Raise a ModelError for a rope or sphere that is wider than a round groove."""
    groove = float(surface.parameters.get("groove_radius", [np.inf])[0])
    if radius >= groove:
        raise ModelError(
            f"{owner}: the {what} of radius {radius:g} m does not fit into the groove of radius {groove:g} m; use "
            "a larger fx.RoundGroove, for a rope usually 1.06 to 1.1 times its radius"
        )


def find_surface(to: Lowering, surface: Any, owner: str) -> Surface:
    """Find the surface with that name, or raise a ModelError with the nearest ones."""
    name = name_of(surface)
    if name not in to.surfaces:
        raise ModelError(f"{owner}: {unknown(name, to.surfaces, 'sheave or plane')}")
    return to.surfaces[name]


def name_of(given: Any) -> str:
    """Return the name of a surface or rope that may be given by its name."""
    return given if isinstance(given, str) else str(getattr(given, "name", given))


def check_contact(contact: Any, owner: str) -> None:
    """Raise a ModelError for anything but a Contact, such as its stiffness alone."""
    if not isinstance(contact, Contact):
        raise ModelError(f"{owner}: contact {contact!r} is not a Contact; give fx.Contact(stiffness, …)")
