"""Ropes that swing: the falling flexible pendulum of the literature, and the energy of a rope over 10 000 steps."""

from __future__ import annotations

from functools import cache

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import rope_data as data
from flexel.examples import rope_models as models
from flexel.examples.convergence import order
from flexel.examples.rope_table import over_meshes
from flexel.results.reproduction import Quantity

SOFT = 0.7e6  # E of the literature [N/m²]
SOFT_MESHES = (16, 32, 64)
RUBBER_TIP = (-1.16101, -0.31330)  # of another program [m]
SOFT_SOURCE = "E = 0.7e6 (Berzeri and Shabana 2000), against half the elements"


@cache
def pendulum(E: float, n: int, step: float = 1e-3) -> fx.Motion:
    """Simulate the pendulum of n elements that falls from the horizontal for 1 s, sampled every 0.05 s."""
    system = models.falling(n, E, **data.PENDULUM)
    return system.simulate(
        1.0, method="generalized-alpha", samples=21, step=step, spectral_radius=0.9, progress=False
    )


def tip(E: float, n: int, step: float = 1e-3) -> Array:
    """Return the history (21, 2) [m] of the pendulum's tip."""
    motion = pendulum(E, n, step)
    return np.stack([motion[f"rod_p{n}.x"], motion[f"rod_p{n}.y"]], axis=1)


def pendulum_error(n: int, E: float = 0.7e9) -> float:
    """Return the largest distance of the tip from the reference, over the pendulum's length."""
    away = tip(E, n, 8e-3 / n) - data.TIPS[E]
    return float(np.hypot(*away.T).max() / data.PENDULUM["L"])


def soft_change(n: int) -> float:
    """Return the largest change of the tip from n/2 to n elements, over the length, with the literature's modulus."""
    away = tip(SOFT, n) - tip(SOFT, n // 2)
    return float(np.hypot(*away.T).max() / data.PENDULUM["L"])


def rubber_tip(n: int = 56) -> Array:
    """Return the tip (2,) [m] after 1 s, of a rod in space with the modulus of the literature, in steps of 1 ms."""
    system = models.falling(n, SOFT, size=3, **data.PENDULUM)
    motion = system.simulate(
        1.0, method="generalized-alpha", samples=2, step=1e-3, spectral_radius=0.9, progress=False
    )
    return np.asarray(motion[-1].position(f"rod_p{n}")[:2])


def swing_error(count: int, h: float = 5e-4) -> float:
    """Return the largest error of the energy over the largest kinetic energy, of a rope that falls and swings."""
    motion = models.swinging(2).simulate(
        count * h, method="generalized-alpha", samples=101, step=h, spectral_radius=1.0, progress=False
    )
    balance = motion.energy_balance()
    return float(np.abs(balance["error"]).max() / balance["kinetic"].max())


def rows() -> list[Quantity]:
    """Compare falling flexible pendulum and energy."""
    changes = [soft_change(n) for n in SOFT_MESHES[1:]]
    more = {
        "elements": SOFT_MESHES[-1],
        "order": order(changes),
        "meshes": list(SOFT_MESHES),
        "changes": changes,
    }
    return [
        over_meshes("pendulum_error", pendulum_error, (4, 8), 2.3e-4, "E = 0.7e9, assumed modes, themselves to 2e-4",
                    kind="own"),
        Quantity("pendulum_soft_change", changes[-1], 0.0, 0.012, "L", SOFT_SOURCE, more, kind="own"),
        Quantity("rubber_pendulum_tip", rubber_tip(), RUBBER_TIP, 5e-5, "m",
                 "Exudyn's ANCF cable, 56 elements, 1 ms, spectral radius 0.9; E = 0.7e6, at 1 s", {"elements": 56},
                 kind="other program", tolerance_kind="absolute"),
        Quantity("swing_energy_error", swing_error(10_000), 0.0, 5e-6, "", "0; no damping, 10 000 steps, radius 1",
                 {"elements": 2, "step": 5e-4}, kind="closed form"),
    ]  # fmt: skip
