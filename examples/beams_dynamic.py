"""The published beam problems in motion: frequencies, rotating blades, whirling shafts, the spin-up beam."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import beams_data as data
from flexel.examples import beams_models as models
from flexel.examples.convergence import converged, needed
from flexel.results.reproduction import Quantity

SPIN_ROWS = {"simo": (2e-4, 1.2e-5, 3e-3), "kane": (4e-4, 4e-5, 6e-3)}  # tolerances: across, along, stretch
SPIN_TOLERANCE = 1e-7  # of the implicit integrator, for the spin-up beam
SQUARE_TOLERANCES: dict[tuple[str, float], tuple[float, float, float | None]] = {
    ("cantilever", 0.02): (3e-5, 1.5e-6, None), ("cantilever", 0.1): (4e-4, 1e-6, 0.06),
    ("cantilever", 0.2): (1e-3, 1.5e-6, 0.015),
    ("pinned", 0.02): (6e-5, 2e-6, None), ("pinned", 0.1): (8e-4, 1e-6, 0.08),
    ("pinned", 0.2): (2e-3, 3e-6, 8e-4),
}  # fmt: skip
SHAFT_RADIUS = 0.05  # of gyration of the shaft's section, over its length
SHAFT_SPINS = (0.0, 5.0, 10.0, 20.0)  # in units of sqrt(EI/(rho A L⁴))


# -- frequencies ----------------------------------------------------------------------------------


def frequencies(system: fx.System, state: fx.State, count: int) -> Array:
    """Return the lowest frequencies (count,) of the linearized motion, from its eigenvalues."""
    w = np.sort(system.linearize(state).eigenvalues().imag)
    return np.asarray(w[w > 1e-9][:count])


@cache
def blade_frequencies(n: int, spin: float, hub: float, second_order: bool = True) -> Array:
    """Return the the six lowest frequencies of the rotating blade about its steady spin, rising."""
    system = models.blade(n, spin, hub, second_order)
    return frequencies(system, system.steady(), 6)


def blade_reference(hub: float, spin: float) -> Array:
    """Return the the three flap and three lag frequencies of a row of the table, rising."""
    row = next(blade for blade in data.ROTATING_BLADES if blade[0] == hub and blade[1] == spin)
    return np.sort(row[2:])


@cache
def whirl(n: int, spin: float) -> Array:
    """Return the whirl frequencies (4,) of the first two modes in the inertial frame; backward is negative.

    The linearization in the deformations of the elements is one in the turning frame: there a whirl of frequency w
    has w - W.  Below the critical speed, backward whirls have the higher frequencies there, w_b + W.
    """
    system = models.shaft(n, spin, SHAFT_RADIUS)
    turning = frequencies(system, system.steady(), 4)
    exact = whirl_reference(spin)
    # a frequency belongs to the forward or to the backward whirl of a mode: the one whose |w - W| has its place
    place = np.argsort(np.argsort(np.abs(exact - spin)))
    return np.asarray(np.sign(exact - spin) * turning[place] + spin)


def whirl_reference(spin: float) -> Array:
    """Return the closed form of `whirl`: mode 1 backward and forward, mode 2 backward and forward."""
    found = []
    for k in (1, 2):
        q, wn2 = (SHAFT_RADIUS * k * np.pi) ** 2, (k * np.pi) ** 4
        root = np.sqrt((q * spin) ** 2 + (1 + q) * wn2)
        found += [(q * spin - root) / (1 + q), (q * spin + root) / (1 + q)]
    return np.array(found)


def rest_frequencies(system: fx.System, count: int = 3) -> Array:
    """Return the lowest frequencies (count,) about the state of rest."""
    return np.array([mode.omega for mode in system.vibrations(count=count)])


def square_frequencies(height: float, supports: str, n: int) -> Array:
    """Return the lowest three frequencies of a square beam with shear and rotary inertia."""
    return rest_frequencies(models.square_beam(n, height, supports))


def vibrations() -> list[Quantity]:
    """Compare rotating blades, whirl, shear and rotary inertia, tip mass."""
    hubs, spins = (0.0, 1.0), tuple(row[1] for row in data.ROTATING_BLADES if row[0] == 0.0)
    keys = [(hub, spin) for hub in hubs for spin in spins]
    blades = np.array([blade_reference(*key) for key in keys])
    first = blades[:, :2]

    def all_blades(n: int) -> Array:
        return np.array([blade_frequencies(n, spin, hub) for hub, spin in keys])

    found = {n: all_blades(n) for n in (8, 16)}
    whirls = np.array([whirl_reference(spin) for spin in SHAFT_SPINS])
    rows = [
        Quantity("rotating_blade", found[16], blades, 1.5e-4, "sqrt(EI/rhoAL4)",
                 data.ROTATING + "; 3 flap and 3 lag modes, hub radius 0 and L", {"elements": 16, "eta": list(spins)},
                 kind="own"),
        Quantity("rotating_blade_first", found[8][:, :2], first, 1e-3, "sqrt(EI/rhoAL4)",
                 data.ROTATING + "; first flap and lag", {"elements": 8}, kind="own"),
        *converged("whirl", lambda n: np.array([whirl(n, spin) for spin in SHAFT_SPINS]), whirls, (8, 16, 32),
                   (3e-5, 2.5e-7, None), "sqrt(EI/rhoAL4)", data.WHIRL, "closed form"),
    ]  # fmt: skip
    for height, *exact in data.SQUARE_BEAMS:
        for supports, reference in (("cantilever", exact[:3]), ("pinned", exact[3:])):
            rows += converged(
                f"timoshenko_{supports}_{height:g}",
                partial(square_frequencies, height, supports),
                np.array(reference), (8, 16, 32), SQUARE_TOLERANCES[supports, height], "rad/s", data.TIMOSHENKO,
                "closed form",
            )  # fmt: skip
    masses = np.array(data.TIP_MASSES)
    roots = [np.sqrt(rest_frequencies(models.beam_with_tip_mass(8, mass), 1)[0]) for mass in masses[:, 0]]
    rows.append(Quantity("tip_mass", roots, masses[:, 1], 6e-7, "beta L", data.TIP_MASS, {"elements": 8},
                         kind="closed form"))  # fmt: skip
    exact_12 = blade_reference(0.0, 12.0)

    def blade_error(n: int, second_order: bool) -> float:
        return float(np.max(np.abs(blade_frequencies(n, 12.0, 0.0, second_order)[:2] / exact_12[:2] - 1)))

    rows.append(needed("rotating_blade", blade_error, "first flap and lag frequency at eta = 12"))
    return rows


# -- spin-up --------------------------------------------------------------------------------------


@cache
def spun_up(case: str, n: int, second_order: bool = True, tolerance: float = SPIN_TOLERANCE) -> fx.Motion:
    """Simulate the the motion of the spin-up beam, stored at the times of the reference."""
    p, table = spin_case(case)
    system = models.spin_up(n, p, second_order)
    return system.simulate(
        table[-1, 0], method="generalized-alpha", times=table[:, 0], rtol=tolerance, progress=False
    )


def spin_case(case: str) -> tuple[dict[str, float], Array]:
    """Return data and reference table (t, along, across) of "simo" or "kane"."""
    if case == "simo":
        return data.SPIN_SIMO, np.array(data.SPIN_SIMO_TIPS)
    return data.SPIN_KANE, np.array(data.SPIN_KANE_TIPS)


def spin_tip(case: str, n: int, second_order: bool = True, tolerance: float = SPIN_TOLERANCE) -> Array:
    """Return the displacement (nt, 2) of the tip in the turning frame."""
    motion = spun_up(case, n, second_order, tolerance)
    return models.tip_in_turning_frame(motion, n, spin_case(case)[0]["L"])


def spin_up() -> list[Quantity]:
    """Compare the spin-up beams of Simo and Vu-Quoc and of Kane, and the elements that the first one needs."""
    rows = []
    compared: Any = {"kind": "own", "tolerance_kind": "absolute"}
    for case, source, steady in zip(
        ("simo", "kane"), (data.SPINUP, data.KANE), data.SPIN_STEADY, strict=True
    ):
        table, tip, (across, along, stretch) = spin_case(case)[1], spin_tip(case, 8), SPIN_ROWS[case]
        more = {"elements": 8, "integration_tolerance": SPIN_TOLERANCE, **spun_up(case, 8).statistics}
        rows += [
            Quantity(f"spin_up_{case}_across", tip[:, 1], table[:, 2], across, "m", source, more, **compared),
            Quantity(f"spin_up_{case}_along", tip[:, 0], table[:, 1], along, "m", source, more, **compared),
            Quantity(f"spin_up_{case}_stretch", tip[-1, 0], steady, stretch, "m",
                     "stretch by the steady spin; what is left of the bending vibration is in it", more,
                     kind="closed form"),
        ]  # fmt: skip
    return [*rows, *spin_up_errors()]


def spin_up_errors() -> list[Quantity]:
    """Return the largest error across, over the peak, on coarse meshes with and without the second-order terms."""
    exact, rows = spin_case("simo")[1][:, 2], []
    for second_order, meshes in ((True, (2, 4)), (False, (4, 8))):
        errors = [
            float(
                np.max(np.abs(spin_tip("simo", n, second_order, 1e-6)[:, 1] - exact)) / np.max(np.abs(exact))
            )
            for n in meshes
        ]
        name = "spin_up_errors" + ("" if second_order else "_first_order")
        rows.append(
            Quantity(
                name, errors, source="over the peak; integrated at 1e-6", more={"elements": list(meshes)}
            )
        )
    return rows
