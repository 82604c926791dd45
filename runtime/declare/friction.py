"""Dry friction, stops and play of joints: the methods of `Model` that put these laws on deformations and slips."""

from __future__ import annotations

import numpy as np

from flexel.base.arguments import not_negative, number, positive, quantities
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.displacements import displacement
from flexel.declare.springs import Springs
from flexel.generated.table import LAWS

PLAY = {
    False: ("radial1", "radial2", "angle"),
    True: ("along", "across", "angle"),
}  # of a bearing: planar or not


class Friction(Springs):
    """Friction, stops and play."""

    @whole_or_nothing
    def friction(self, on: str, limit: float, speed: float) -> None:
        """Resist a motion by dry friction: limit w/√(w² + speed²), with w the rate of a deformation, or a slip.

        Parameters
        ----------
        on : str
            A deformation or a slip, which becomes free; or a coordinate, for friction against the ground.
        limit : float
            Force [N] or moment [N m] of fast motion.
        speed : float
            Speed at which 71 % of it acts [m/s or rad/s].  Below it the friction is viscous: a joint under load creeps
            instead of sticking.  A small value makes the equations stiff.
        """
        owner = f"friction on '{on}'"
        (on,) = quantities([on], owner)
        values = {"limit": not_negative(limit, owner, "limit"), "speed": positive(speed, owner, "speed")}
        slips = {z for instance in self.instances.values() for z in instance.slips}
        law = LAWS["slip_friction" if on in slips else "friction"]
        self._add_law(owner, law, [displacement(self, on, owner)], values)

    @whole_or_nothing
    def limits(self, on: str, low: float, high: float, stiffness: float, damping: float = 0.0) -> None:
        """Stop a deformation on both sides, with free play between: elastic beyond low and high, never pulling.

        Parameters
        ----------
        on : str
            A deformation, which becomes free; or a coordinate, counted from its drawn value.
        low, high : float
            Deformations at which the stops are touched [m or rad].
        stiffness : float
            [N/m or N m/rad]
        damping : float
            Loss relative to the elastic force, for unit rate [s/m or s/rad].

        See Also
        --------
        stop : On one side.
        clearance : Radial play of a pin.
        """
        owner = f"limits on '{on}'"
        (on,) = quantities([on], owner)
        values = {"low": number(low, owner, "low"), "high": number(high, owner, "high")}
        if values["low"] >= values["high"]:
            raise ModelError(f"{owner}: low {low:g} is not below high {high:g}; swap them")
        values["stiffness"] = positive(stiffness, owner, "stiffness")
        values["damping"] = not_negative(damping, owner, "damping")
        self._add_law(owner, LAWS["limits"], [displacement(self, on, owner)], values)

    @whole_or_nothing
    def clearance(
        self,
        joint: str,
        gap: float,
        stiffness: float,
        *,
        damping: float = 0.0,
        friction_radius: float = 0.0,
        slip_speed: float = 0.01,
    ) -> None:
        """Give a revolute joint radial play between pin and bush, or a ball joint play in its socket.

        Parameters
        ----------
        joint : str
            A revolute joint or bearing: its radial displacements become free, and its angle carries the friction.  Or
            a spherical or universal joint: the three displacements of its ball become free.
        gap : float
            Radius of the bush less that of the pin [m]; the pin is drawn in the centre.
        stiffness : float
            Of the contact, force per penetration [N/m].
        damping : float
            Loss relative to the elastic force, for unit rate [s/m].
        friction_radius : float
            Coefficient of friction times the radius of the pin [m]: the moment is this times the force of the contact.
            A ball has none, since its turns have no angles.
        slip_speed : float
            Speed of turning at which 71 % of the friction acts [rad/s].

        Raises
        ------
        ModelError
            A joint without a pin or a ball, such as a weld or a slide; friction on a ball.
        """
        owner = f"clearance of '{joint}'"
        spec = self.instances[joint].spec if isinstance(joint, str) and joint in self.instances else None
        link = spec is not None and spec.family == "link" and not spec.planar
        ball = link and not np.any(self.instances[joint].parameters["d0"])
        if spec is None or not (spec.family == "bearing" or ball):
            raise ModelError(
                f"{owner}: it is not a joint with a pin or a ball; name one of m.revolute or m.spherical"
            )
        if self._roles.get(f"{joint}.angle") == "rigid":
            raise ModelError(
                f"{owner}: it does not turn ('{joint}.angle' is rigid), so it has no pin; use m.revolute instead of a "
                "weld; for the play of a slide put m.limits on the displacements"
            )
        values = {
            "gap": positive(gap, owner, "gap"),
            "stiffness": positive(stiffness, owner, "stiffness"),
            "damping": not_negative(damping, owner, "damping"),
            "friction_radius": not_negative(friction_radius, owner, "friction_radius"),
            "slip_speed": positive(slip_speed, owner, "slip_speed"),
        }
        if ball:
            if friction_radius:
                raise ModelError(f"{owner}: a ball has no angle for the friction; leave friction_radius out")
            del values["friction_radius"], values["slip_speed"]
            self._add_law(owner, LAWS["loose_ball"], [f"{joint}.{z.name}" for z in spec.deformations], values)
            return
        self._add_law(owner, LAWS["loose_journal"], [f"{joint}.{z}" for z in PLAY[spec.planar]], values)
