"""The energy ledger of an implicit integration: what is stored, lost and put in, and what does not add up.

Imports numpy and the balance.
"""

from __future__ import annotations

import numpy as np

from flexel.alpha import Point
from flexel.balance import Balance, Saddle
from flexel.structure import Array


class Ledger:
    """Work and losses of a motion, by the trapezoidal rule over its steps.

    Attributes
    ----------
    kept : dict of str to list of float
        At the stored times: "contact" (stored in contacts), "dissipated" and "work" (since the start) [J].
    """

    def __init__(self, saddle: Saddle) -> None:
        self._saddle = saddle
        structure = saddle.structure
        contact = {
            structure.index[z]
            for i in structure.instances
            if "contact" in i.spec.name
            for z in i.deformations
        }
        laws = saddle.local.laws
        self._contact = np.zeros(laws.count, dtype=bool)
        self._gap = np.zeros(laws.count, dtype=np.intp)
        for numbers, quantities in laws.instances():
            self._contact[numbers] = [q in contact for q in quantities]
            self._gap[numbers] = quantities
        self._touching = np.zeros(0, dtype=bool)
        self._power = np.zeros(2)
        self._sums = np.zeros(2)
        self._stored = 0.0
        self.kept: dict[str, list[float]] = {"contact": [], "dissipated": [], "work": []}

    def begin(self, p: Point) -> None:
        """Start at a point."""
        saddle = self._saddle
        saddle.z, saddle.step = p.z, None
        self._enter(saddle.balance(p.t, p.x, p.v, p.a, p.mu, p.e))
        self.keep()

    def add(self, b: Balance, h: float) -> None:
        """Add a step of length h that ends in a balance."""
        before = self._power
        self._enter(b)
        self._sums = self._sums + h / 2 * (before + self._power)

    def keep(self) -> None:
        """Store the present figures."""
        for name, value in zip(self.kept, (self._stored, *self._sums), strict=True):
            self.kept[name].append(float(value))

    def new_penetration(self, b: Balance) -> float:
        """Deepest penetration of the contacts that have begun in the step that ends in a balance; 0 if none has."""
        if not self._contact.any():
            return 0.0
        begun = self._contact & (b.laws.stored > 0) & ~self._touching
        return float(np.abs(b.e[self._gap[begun]]).max(initial=0.0))

    def _enter(self, b: Balance) -> None:
        self._power = np.array([self._losses(b), self._drives(b)])
        self._touching = b.laws.stored > 0
        self._stored = float(b.laws.stored[self._contact].sum())

    def _losses(self, b: Balance) -> float:
        """Power lost in laws and by mass-proportional damping [W]."""
        lost = float(b.laws.dissipated.sum())
        local = self._saddle.local
        return lost + float(b.v @ local.damping(b.inertia.M, b.v)) if local.damped else lost

    def _drives(self, b: Balance) -> float:
        """Power of prescribed motions and of loads without a potential [W]."""
        saddle = self._saddle
        roles, power = saddle.roles, 0.0
        if roles.motions:
            power -= float(b.multiplier[roles.prescribed] @ roles.motion(b.t)[1])
        loads = saddle.system.loads
        return power + loads.power(b.t, np.concatenate([b.w, b.v])) if loads.any else power


def energy_balance(energy: dict[str, Array], kept: dict[str, list[float]]) -> dict[str, Array]:
    """Energies over time and what does not add up; see `Motion.energy_balance`."""
    contact, dissipated, work = (np.array(kept[z]) for z in ("contact", "dissipated", "work"))
    surplus = energy["total"] + dissipated - work
    return {
        "kinetic": energy["kinetic"],
        "potential": energy["potential"],
        "strain": energy["strain"] - contact,
        "contact": contact,
        "dissipated": dissipated,
        "work": work,
        "error": surplus - surplus[0],
    }
