"""Dry friction, stops and play of joints: laws on deformations and slips."""

from __future__ import annotations

from dataclasses import KW_ONLY

import numpy as np

from flexel.base.arguments import quantities
from flexel.base.errors import ModelError
from flexel.base.meaning import entry, quantity
from flexel.generated.table import LAWS
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.parts.displacements import displacement

# Deformations of a bearing in which a pin has play, and its angle: planar or not.
PLAY = {False: ("radial1", "radial2", "angle"), True: ("along", "across", "angle")}


@part
class Friction(Part[None]):
    """Resist a motion by dry friction: limit w/√(w² + speed²), with w the rate of a deformation, or a slip."""

    on: str = entry(
        "A deformation or a slip, which becomes free; or a coordinate, for friction against the ground."
    )
    limit: float = quantity("N or N m", "not negative", "Force or moment of friction in fast motion.")
    speed: float = quantity(
        "m/s or rad/s",
        "positive",
        "Speed at which 71 % of it acts.  Below it the friction is viscous: a joint under load creeps instead of "
        "sticking.  A small value makes the equations stiff.",
    )

    @property
    def owner(self) -> str:
        """Its name in messages: by the quantity on which it acts."""
        return f"friction on '{self.on}'"

    def lower(self, to: Lowering) -> None:
        """Add the law."""
        (on,) = quantities([self.on], self.owner)
        slips = {slip for instance in to.instances.values() for slip in instance.slips}
        spec = LAWS["slip_friction" if on in slips else "friction"]
        values = {"limit": self.limit, "speed": self.speed}
        to.law(self.owner, spec, [displacement(to, on, self.owner)], values)


@part
class Limits(Part[None]):
    """Stop a deformation on both sides, with free play between: elastic beyond low and high, never pulling.

    See Also
    --------
    stop : On one side.
    clearance : Radial play of a pin.
    """

    on: str = entry("A deformation, which becomes free; or a coordinate, counted from its drawn value.")
    low: float = quantity("m or rad", "any", "Deformation at which the lower stop is touched.")
    high: float = quantity("m or rad", "any", "Deformation at which the upper stop is touched.")
    stiffness: float = quantity("N/m or N m/rad", "positive", "Stiffness of the stops.")
    damping: float = quantity(
        "s/m or s/rad",
        "not negative",
        "Dissipative force relative to the elastic force, at unit rate.",
        default=0.0,
    )

    @property
    def owner(self) -> str:
        """Its name in messages: by the quantity on which it acts."""
        return f"limits on '{self.on}'"

    def lower(self, to: Lowering) -> None:
        """Add the law."""
        (on,) = quantities([self.on], self.owner)
        if self.low >= self.high:
            raise ModelError(f"{self.owner}: low {self.low:g} is not below high {self.high:g}; swap them")
        values = {
            "low": self.low,
            "high": self.high,
            "stiffness": self.stiffness,
            "damping": self.damping,
        }
        to.law(self.owner, LAWS["limits"], [displacement(to, on, self.owner)], values)


@part
class Clearance(Part[None]):
    """Give a revolute joint radial play between pin and bush, or a ball joint play in its socket.

    Raises
    ------
    ModelError
        A joint without a pin or a ball, such as a weld or a slide; friction on a ball.
    """

    joint: str = entry(
        "A revolute joint or bearing: its radial displacements become free, and its angle carries the friction.  Or "
        "a spherical or universal joint: the three displacements of its ball become free."
    )
    gap: float = quantity(
        "m", "positive", "Radius of the bush minus that of the pin; the pin is drawn in the centre."
    )
    stiffness: float = quantity("N/m", "positive", "Stiffness of the contact, force per penetration.")
    _: KW_ONLY
    damping: float = quantity(
        "s/m", "not negative", "Dissipative force relative to the elastic force, at unit rate.", default=0.0
    )
    friction_radius: float = quantity(
        "m",
        "not negative",
        "Coefficient of friction times the radius of the pin []: the moment is this times the force of the contact.  A "
        "ball has none, since its rotations are not measured.",
        default=0.0,
    )
    slip_speed: float = quantity(
        "rad/s", "positive", "Angular velocity at which 71 % of the friction acts.", default=0.01
    )

    @property
    def owner(self) -> str:
        """Its name in messages: by its joint."""
        return f"clearance of '{self.joint}'"

    @property
    def label(self) -> str:
        """By its joint; the damping of the joint is separate."""
        return f"clearance {self.joint}"

    def lower(self, to: Lowering) -> None:
        """Add the law."""
        known = isinstance(self.joint, str) and self.joint in to.instances
        spec = to.instances[self.joint].spec if known else None
        link = spec is not None and spec.family == "link" and not spec.planar
        ball = link and not np.any(to.instances[self.joint].parameters["d0"])
        if spec is None or not (spec.family == "bearing" or ball):
            raise ModelError(
                f"{self.owner}: it is not a joint with a pin or a ball; name one of m.revolute or m.spherical"
            )
        if to.roles.get(f"{self.joint}.angle") == "rigid":
            raise ModelError(
                f"{self.owner}: it does not turn ('{self.joint}.angle' is rigid), so it has no pin; use m.revolute "
                "instead of a weld; for the play of a slide use m.limits on the displacements"
            )
        values = {"gap": self.gap, "stiffness": self.stiffness, "damping": self.damping}
        if ball:
            if self.friction_radius:
                raise ModelError(
                    f"{self.owner}: a ball has no angle for the friction; leave friction_radius out"
                )
            on = [f"{self.joint}.{deformation.name}" for deformation in spec.deformations]
            to.law(self.owner, LAWS["loose_ball"], on, values)
            return
        values |= {"friction_radius": self.friction_radius, "slip_speed": self.slip_speed}
        on = [f"{self.joint}.{name}" for name in PLAY[spec.planar]]
        to.law(self.owner, LAWS["loose_journal"], on, values)
