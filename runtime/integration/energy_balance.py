"""The energy balance of an implicit integration: stored, dissipated and supplied energy, and the discrepancy."""

from __future__ import annotations

import math

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.energies import Energies
from flexel.integration.balance import Saddle

ROUNDING = 1e-9  # over the stored energies: less that is missing is rounding, and what iterations leave


class EnergyBalance:
    """Work and losses of a motion, by the trapezoidal rule over its steps.

    It reads the workspace of the balance of forces; a contact is a law whose first deformation is a gap.

    Attributes
    ----------
    kept : dict of str to list of float
        At the stored times: "contact" (stored in contacts), "dissipated" and "work" (since the start) [J].
    missing : float
        Energy [J] that the method has taken out since the start, at the last step; negative: that it has added.
    unsure : float
        How much of it [J] may be an error of the trapezoidal rule, whose errors in the steps have independent signs.
    size : float
        Of the largest stored energies [J].
    steps : int
        That were added.
    """

    def __init__(self, saddle: Saddle) -> None:
        self._saddle = saddle
        self._found = Energies(saddle.work)
        self._values = self._found.struct
        self._own = self._potential = self._largest = self._stored = (
            0.0  # kinetic and strain; of body forces and loads
        )
        self._losses = self._drives = self._dissipated = self._work = (
            0.0  # powers at the last step, and their sums
        )
        self._next = (0.0, 0.0, 0.0, 0.0)
        self._kinetic = self._through = self.size = 0.0
        self._force = 0.0  # size of the balancing forces at the last step [N]
        self._slope = 0.0  # of the power in the step before; none in the first
        self.missing = self.unsure = 0.0
        self.steps = 0
        self.terms: dict[str, list[float]] = {"contact": [], "dissipated": [], "work": []}

    def begin(self) -> None:
        """Start at the balance that the workspace holds."""
        self.look()
        self._enter()
        self.keep()

    def follow(self, other: EnergyBalance) -> None:
        """Continue from the last step of another balance, and store to its lists."""
        self._own, self._potential, self._stored = other._own, other._potential, other._stored
        self._losses, self._drives = other._losses, other._drives
        self._dissipated, self._work, self.terms = other._dissipated, other._work, other.terms

    def look(self) -> None:
        """Compute energies and powers at the balance in the workspace: the end of a trial step."""
        self._found.evaluate()
        c, saddle = self._values, self._saddle
        potential, drives = c.potential, 0.0
        if saddle.roles.motions:
            driven = slice(saddle.roles.rigid.size, saddle.roles.holonomic.size)
            drives -= float(saddle.balancing.mu[driven] @ saddle.motion[1])
        if saddle.system.loads.any:
            t, w = saddle.inside(float(saddle.work.struct.t)), saddle.work
            potential += saddle.system.loads.potential(t, saddle.system.kinematics.values(w.e, w.x))
            drives += saddle.system.loads.power(t, np.concatenate([w.w, w.v]))
        self._next = c.kinetic + c.strain, potential, c.lost, drives

    def add(self, h: float) -> None:
        """Add the step of length h that was examined."""
        _, _, losses, drives = self._next
        lost, work = h / 2 * (self._losses + losses), h / 2 * (self._drives + drives)
        self._dissipated += lost
        self._work += work
        self._through += abs(lost) + abs(work)
        change = drives - self._drives - losses + self._losses
        self.unsure = math.hypot(self.unsure, h / 2 * min(abs(change), abs(change - self._slope * h)))
        self._slope = change / h
        before = self._own + self._potential
        self._enter()
        self.steps += 1
        self.missing += before + work - lost - self._own - self._potential

    def renew(self) -> None:
        """Continue from the balance that the workspace holds, where forces have jumped."""
        self.look()
        self._enter()

    def strike(self) -> None:
        """Continue after prescribed rates have jumped; what drives them has done the work of the impulse."""
        before = self._own
        self.renew()
        self._work += self._own - before

    @property
    def moved(self) -> float:
        """The largest kinetic energy, or what was dissipated and supplied if that is more [J]."""
        return max(self._kinetic, self._through)

    @property
    def share(self) -> float:
        """The missing energy over what has moved.

        Zero where it may be due to rounding or to the trapezoidal rule. Energy that seems to be added may be losses
        that the rule overestimates, as those of a contact's first step, at most by all of them.
        """
        moved = self.moved
        doubt = ROUNDING * self.size + (2 * self.unsure if self.missing > 0 else self._through)
        return self.missing / moved if abs(self.missing) > doubt and moved else 0.0

    def keep(self) -> None:
        """Store the current values."""
        for name, value in zip(self.terms, (self._stored, self._dissipated, self._work), strict=True):
            self.terms[name].append(value)

    def new_penetration(self) -> float:
        """Return the deepest penetration of contacts that closed in the examined step; 0 if none did.

        It is also 0, not an impact, if contacts closed before are deeper, as where a rope runs onto its sheave.
        """
        begun = float(self._values.begun)
        return begun if begun > self._values.deepest else 0.0

    def spurious(self, h: float) -> bool:
        """Whether most of the energy at the end of a step is spurious: neither stored before nor supplied.

        Newton's method has then found a solution of a long step that does not continue its beginning: a
        rope that has jumped off its sheave.  Energy below the work of the forces at the start over a thousandth of the
        model's size is ignored; those at the end may be part of the spurious solution.
        """
        own, potential, losses, drives = self._next
        lost, work = h / 2 * (self._losses + losses), h / 2 * (self._drives + drives)
        made = own + potential - self._own - self._potential - work + min(lost, 0.0)
        little = 1e-3 * self._force * self._saddle.length
        return bool(made > 0.5 * own + 0.01 * self._largest + little)

    def _enter(self) -> None:
        self._own, self._potential, self._losses, self._drives = self._next
        self._largest = max(self._largest, self._own)
        self._kinetic = max(self._kinetic, float(self._values.kinetic))
        self.size = max(self.size, abs(self._own) + abs(self._potential))
        self._stored = float(self._values.contact)
        self._force = float(self._saddle.balancing.struct.scale)
        self._found.note()


def energy_balance(energy: dict[str, Array], terms: dict[str, list[float]]) -> dict[str, Array]:
    """Return the energies over time and their discrepancy; see `Motion.energy_balance`."""
    contact, dissipated, work = (np.array(terms[name]) for name in ("contact", "dissipated", "work"))
    surplus = energy["total"] + dissipated - work
    start = terms.get("initial", surplus)[0]  # of a motion whose start is not among the stored states
    return {
        "kinetic": energy["kinetic"],
        "potential": energy["potential"],
        "strain": energy["strain"] - contact,
        "contact": contact,
        "dissipated": dissipated,
        "work": work,
        "error": surplus - start,
    }
