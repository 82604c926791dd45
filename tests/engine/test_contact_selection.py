"""Contacts that are far from their surfaces are left out of a step, without a difference."""

import numpy as np
import pytest

import flexel as fx
from flexel.engine import contact_selection
from flexel.examples.rope_models import atwood


def falling_rope() -> fx.System:
    """A slack rope of 24 cables between two points falls onto a floor 0.25 m below."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("C", (0, -0.25), fixed=True)
    m.angle("G", fixed=True)
    m.plane("floor", "C", "G", normal=(0, 1))
    s = np.linspace(0, 1, 25)
    line = np.column_stack([0.9 * s, 0.02 * np.sin(2 * np.pi * s)])
    rope = m.cable_line("rope", line, 24, EA=1e3, EI=1e-3, mass_per_length=0.1, damping=1e-3)
    m.rope_contact(rope, "floor", fx.Contact(1e5, dissipation=1.0), radius=5e-3)
    return m.build()


@pytest.mark.parametrize("name", ["sheave", "floor"])
def test_leaving_out_far_contacts_changes_nothing(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ropes that run over a sheave, and that strike a floor within a step from far above."""
    system = falling_rope() if name == "floor" else atwood(28, 3.0, 2.0, inertia=0.02, mass=1.0)[0]
    duration, step = (0.3, 4e-3) if name == "floor" else (0.06, 2e-3)
    chosen = system.simulate(duration, method="generalized-alpha", step=step, samples=31, progress=False)
    monkeypatch.setattr(contact_selection, "FEW", 10**9)
    whole = system.simulate(duration, method="generalized-alpha", step=step, samples=31, progress=False)
    assert chosen.energy_balance()["contact"].max() > 0
    for a, b in zip(chosen, whole, strict=True):
        assert a.x == pytest.approx(b.x, abs=1e-9)
        assert a.stresses == pytest.approx(b.stresses, rel=1e-6, abs=1e-6)
