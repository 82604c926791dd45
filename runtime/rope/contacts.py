"""Contact of cables with surfaces: the law of a contact, and the method of `Model` for cables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import names, not_negative, positive, text, unknown, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.declarations import Declarations
from flexel.declare.laws import Laws
from flexel.generated.table import LAWS
from flexel.rope.cable_lines import CableLine, CableLines, contact_radius
from flexel.rope.impact import dissipation
from flexel.structure.surfaces import Surface

RELEASE = 1e3  # rate [1/s] at which the bristles of an open contact relax


@dataclass(frozen=True)
class Contact:
    """How a cable, or a point or sphere of a body, touches: normal force and friction, and the points of a cable.

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
        Coulomb's friction is regularized: 71 % of it at this speed [m/s].
    bristle_stiffness : float, optional
        Alternative: bristles that stick, deflected by friction/bristle_stiffness when they slide [1/m].
    bristle_damping : float
        [s/m]
    points : int
        Per element of a cable.
    places : str
        Of these points: "gauss", weighted by Gauss, or "equidistant".
    per : str, optional
        "length": forces per length times the points' weights, so that they do not depend on the mesh; or "point". By
        default "length" for cables, and "point" for `Model.contact`, which refuses "length".
    """

    stiffness: float
    exponent: float = 1.5
    dissipation: float = 0.0
    friction: float = 0.0
    slip_speed: float = 1e-2
    bristle_stiffness: float | None = None
    bristle_damping: float = 0.0
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
        cls, stiffness: float, restitution: float, speed: float, *, law: str = "hunt-crossley", **others: Any
    ) -> Contact:
        """Make a contact whose dissipation follows from a coefficient of restitution.

        Parameters
        ----------
        stiffness : float
            As for the class.
        restitution : float
            Speed of departure over speed of approach, 0 to 1; reliable from about 0.8.
        speed : float
            Speed of approach at which this holds [m/s].
        law : "hunt-crossley" or "lankarani-nikravesh"
            Source of the dissipation factor: 3 (1 - e)/(2 v) or 3 (1 - e²)/(4 v).
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
        """Places on (0, 1) and weights of sum 1 of the points of an element."""
        if self.places == "gauss":
            xi, weight = np.polynomial.legendre.leggauss(self.points)
            return (1 + xi) / 2, weight / 2
        return (np.arange(self.points) + 0.5) / self.points, np.full(self.points, 1 / self.points)

    def depth(self, load: float, length: float) -> float:
        """Penetration [m] at which elements of a given length [m] carry a line load [N/m]."""
        load, length = not_negative(load, "contact", "load"), not_negative(length, "contact", "length")
        share = load * length / self.points if self.per == "point" else load
        return float((share / self.stiffness) ** (1 / self.exponent))

    def law(self, slips: int, weight: float) -> tuple[str, dict[str, Array]]:
        """Name and parameters of the law of a point that represents a length of rope [m]; 1 for a point of a body."""
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
    """One point of a cable over one surface: its element, place (undeformed arc length [m]) and weight [m]."""

    element: str
    surface: Surface
    cable: str
    xi: float
    s: float
    weight: float


class Contacts(CableLines):
    """Contact of cables with surfaces."""

    @whole_or_nothing
    def rope_contact(
        self,
        cables: CableLine,
        surface: Surface | str,
        contact: Contact,
        *,
        radius: float | None = None,
        only: Sequence[str] | None = None,
    ) -> list[ContactPoint]:
        """Let cables touch a surface: elements ``cable@surface#i``, with a gap, slips along the surface, and their law.

        Parameters
        ----------
        cables : CableLine
            The result of `Model.cable_line` or `Model.rope`.
        surface : Surface or str
            A sheave, drum or plane.
        contact : Contact
        radius : float, optional
            Radius of the rope [m]; half the diameter of its section by default.
        only : sequence of str, optional
            Names of elements of the cable that may touch; all by default.

        Returns
        -------
        list of ContactPoint

        Raises
        ------
        ModelError
            An unknown surface or element, planar and spatial ones mixed, a rope wider than its groove.
        """
        if not isinstance(cables, CableLine):
            raise ModelError(
                f"rope_contact: {cables!r} is not a rope; give the result of m.rope(…) or m.cable_line(…)"
            )
        found = find_surface(self, surface, f"contact of '{cables.name}'")
        owner = f"contact of '{cables.name}' with '{found.name}'"
        check_contact(contact, owner)
        a = contact_radius(cables.radius, radius, owner)
        check_fits("rope", a, found, owner)
        lead = 2 * np.pi * abs(found.pitch)
        if 0 < lead < 2 * a:
            raise ModelError(
                f"{owner}: a lead of {lead:g} m is smaller than the diameter of the rope, {2 * a:g} m, so that its "
                "turns would overlap; give a larger lead, usually 1.1 to 1.2 times the diameter"
            )
        members = cables.elements if only is None else names(only, f"{owner}: only")
        for name in members:
            if name not in cables.elements:
                raise ModelError(f"{owner}: {unknown(str(name), cables.elements, 'element')}")
        made: list[ContactPoint] = []
        xi, weight = contact.rule()
        for name in members:
            i = cables.elements.index(name)
            s0, l0 = float(cables.s[i]), float(cables.s[i + 1] - cables.s[i])
            nodes = [*self.instances[name].nodes, found.point, found.frame]
            for j in range(contact.points):
                element = f"{name}@{found.name}#{j + 1}"
                own = {"l0": np.array([l0]), "xi": xi[j : j + 1], "rope_radius": np.array([a])}
                self._place(element, found.element("cable"), nodes, found.parameters | own)
                made.append(ContactPoint(element, found, name, float(xi[j]), s0 + xi[j] * l0, weight[j] * l0))
        for point in made:
            attach_contact(self, point.element, found.gaps, contact, point.weight)
        return made


def attach_contact(
    model: Laws, element: str, gaps: tuple[tuple[str, tuple[str, ...]], ...], contact: Contact, weight: float
) -> None:
    """Add the law of every gap of an element of contact; `weight` is the length of rope [m] that it represents."""
    for gap, slips in gaps:
        law, values = contact.law(len(slips), weight)
        spec, label = LAWS[law], f"{element} {gap}"
        on = [f"{element}.{z}" for z in ((gap, *slips) if spec.slips else (gap,))]
        model._add_law(f"contact '{label}'", spec, on, values, label=label)


def check_fits(what: str, radius: float, surface: Surface, owner: str) -> None:
    """Raise a ModelError for a rope or sphere that is wider than a round groove."""
    groove = float(surface.parameters.get("groove_radius", [np.inf])[0])
    if radius >= groove:
        raise ModelError(
            f"{owner}: the {what} of radius {radius:g} m does not fit into the groove of radius {groove:g} m; use "
            "a larger fx.RoundGroove, for a rope usually 1.06 to 1.1 times its radius"
        )


def find_surface(model: Declarations, surface: Any, owner: str) -> Surface:
    """The surface of that name, or a ModelError with the nearest ones."""
    name = surface if isinstance(surface, str) else str(getattr(surface, "name", surface))
    if name not in model.surfaces:
        raise ModelError(f"{owner}: {unknown(name, model.surfaces, 'sheave or plane')}")
    return model.surfaces[name]


def check_contact(contact: Any, owner: str) -> None:
    """Raise a ModelError for anything but a Contact, such as its stiffness alone."""
    if not isinstance(contact, Contact):
        raise ModelError(f"{owner}: contact {contact!r} is not a Contact; give fx.Contact(stiffness, …)")
