"""The energy ledger of an implicit integration: stored, dissipated and supplied energy, and the discrepancy."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.integration.scheme import Point
from flexel.mechanics.balance import Balance, Saddle


class Ledger:
    """Work and losses of a motion, by the trapezoidal rule over its steps.

    A contact is a law whose first deformation is a gap.

    Attributes
    ----------
    kept : dict of str to list of float
        At the stored times: "contact" (stored in contacts), "dissipated" and "work" (since the start) [J].
    """

    def __init__(self, saddle: Saddle) -> None:
        self._saddle = saddle
        kinds = saddle.structure.kinds
        laws = saddle.local.laws
        self._contact = np.zeros(laws.count, dtype=bool)
        self._gap = np.zeros(laws.count, dtype=np.intp)
        for numbers, quantities in laws.instances():
            self._contact[numbers] = [kinds[q] == "gap" for q in quantities]
            self._gap[numbers] = quantities
        self._touching = np.zeros(0, dtype=bool)
        self._power = np.zeros(2)
        self._energy = np.zeros(2)
        self._largest = 0.0
        self._found: tuple[Balance, Array, Array] | None = None
        self._sums = np.zeros(2)
        self._stored = 0.0
        self.kept: dict[str, list[float]] = {"contact": [], "dissipated": [], "work": []}

    def begin(self, p: Point) -> None:
        """Start the ledger at a point."""
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
        """Store the current values."""
        for name, value in zip(self.kept, (self._stored, *self._sums), strict=True):
            self.kept[name].append(float(value))

    def new_penetration(self, b: Balance) -> float:
        """Deepest penetration of the contacts that closed in the step that ends in a balance; 0 if none did.

        It is also 0, not an impact, if contacts closed before are deeper, as where a rope runs onto its sheave.
        """
        if not self._contact.any():
            return 0.0
        closed = self._contact & (b.laws.stored > 0)
        depth = np.abs(b.e[self._gap])
        begun = float(depth[closed & ~self._touching].max(initial=0.0))
        return begun if begun > depth[closed & self._touching].max(initial=0.0) else 0.0

    def spurious(self, b: Balance, h: float) -> bool:
        """Whether most of the energy at the end of a step is spurious: neither stored before nor supplied.

        Newton's method has then found a solution of a long step that does not continue its beginning: a
        rope that has jumped off its sheave.  Energy below the work of the largest force over a thousandth of the
        model's size is ignored.
        """
        before = self._energy
        after, power = self._figures(b)
        lost, work = h / 2 * (self._power + power)
        made = after.sum() - before.sum() - work + min(lost, 0.0)
        little = 1e-3 * b.scale * self._saddle.length
        return bool(made > 0.5 * after[0] + 0.01 * self._largest + little)

    def _enter(self, b: Balance) -> None:
        self._energy, self._power = self._figures(b)
        self._largest = max(self._largest, float(self._energy[0]))
        self._touching = b.laws.stored > 0
        self._stored = float(b.laws.stored[self._contact].sum())

    def _figures(self, b: Balance) -> tuple[Array, Array]:
        """Energies, and powers of losses and drives, at a balance; cached for repeated calls."""
        if self._found is None or self._found[0] is not b:
            self._found = b, self._energies(b), np.array([self._losses(b), self._drives(b)])
        return self._found[1:]

    def _energies(self, b: Balance) -> Array:
        """Kinetic and strain energy together, and potential energy [J]."""
        energy = self._saddle.energy(b)
        return np.array([energy.kinetic + energy.strain, energy.potential])

    def _losses(self, b: Balance) -> float:
        """Power dissipated in laws and by mass-proportional damping [W]."""
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
    """Energies over time and their discrepancy; see `Motion.energy_balance`."""
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
