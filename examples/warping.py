"""Torsion of beams with warping sections, compared with Vlasov's closed forms: leaf springs, I-beams, columns.

The models are rows of beams along x that share their warping nodes.  `reproduce` compares restrained torsion,
uneven torsion with its bimoment, lateral and torsional buckling, frequencies, the twist of a leaf in tension,
and the limit without restraint, in which it is a plain beam.  Closed forms, table and picture are in
`warping_exact`, `warping_table` and `warping_figures`.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.warping_exact import BEAM, LEAF, SPAN, STEEL, Section, decay, stiffnesses
from flexel.parts.materials import Profile
from flexel.results.reproduction import Report

SLENDER: dict[str, Any] = {
    "EA": 1e7,
    "GJ": 1.0,
    "EIy": 1.0,
    "EIz": 1e7,
}  # buckles sideways before it bends down


# -- models ---------------------------------------------------------------------------------------


def numbers(section: Section, warping: bool) -> dict[str, Any]:
    """Return stiffness and mass of a section of steel, without shear flexibility, as in the closed forms."""
    profile = Profile(section, STEEL)
    found: dict[str, Any] = {name: k for name, k in profile.stiffness().items() if not name.startswith("GA")}
    found["mass_per_length"], found["inertia_per_length"] = profile.mass()
    if warping:
        found |= {"EIw": STEEL.E * section.Iw, "warping_inertia_per_length": STEEL.rho * section.Iw}
    return found


def row(section: Section, length: float, n: int, held: Sequence[int] = (), warping: bool = True) -> fx.Model:
    """Build a row of n beams along x, P0 to Pn with frames R0 to Rn; warping held at the nodes named."""
    m = fx.Model()
    for i in range(n + 1):
        m.point(f"P{i}", (length * i / n, 0, 0))
        m.frame(f"R{i}")
        if warping:
            m.warping(f"W{i}", fixed=i in held)
    for i in range(n):
        ends = (f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}")
        warp = (f"W{i}", f"W{i + 1}") if warping else False
        m.beam(f"b{i}", *ends, direction=(0, 1, 0), warping=warp, **numbers(section, warping))
    return m


def clamped(
    section: Section, length: float, n: int, held: Sequence[int] = (), warping: bool = True
) -> fx.Model:
    """Build the row with its first end clamped."""
    m = row(section, length, n, held, warping)
    m.fix("P0", "R0")
    return m


def between_forks(
    section: Section, length: float, n: int, held: Sequence[int] = (), warping: bool = True
) -> fx.Model:
    """Build the row between forks, which hold the twist of the ends and let them bend; an end slides along x.

    The angles of the hinges ``bend 0`` and ``bend n`` turn the ends about z, the axis of the height.
    """
    m = row(section, length, n, held, warping)
    ground = m.frame("ground", fixed=True)
    m.fix("P0", f"P{n}.y", f"P{n}.z")
    for i in (0, n):
        m.hinge(f"fork {i}", ground, m.frame(f"F{i}"), axis=(0, 1, 0))
        m.hinge(f"bend {i}", f"F{i}", f"R{i}", axis=(0, 0, 1))
    return m


def twist(state: fx.State, frame: str) -> float:
    """Return the rotation about x of a frame that turns about x alone [rad]."""
    a = state.position(frame)
    return float(2 * np.arctan2(a[1], a[0]))


def leaf_stiffness(kl: float, n: int, tension: float = 0.0) -> float:
    """Return the torsional stiffness of the clamped leaf over that of uniform torsion, with N Ip/A = tension GJ."""
    length, GJ = kl / decay(LEAF), stiffnesses(LEAF)[0]
    m = clamped(LEAF, length, n, held=(0, n))
    m.load(f"P{n}.x", tension * GJ * LEAF.A / (LEAF.Iy + LEAF.Iz))
    system = m.build()
    compliance = system.compliance(f"P{n}", f"R{n}", system.equilibrium())
    return float(length / GJ / compliance.matrix[3, 3])


def cantilever_torsion(n: int) -> tuple[Array, Array, float]:
    """Return points and angles (n + 1,) of the I beam under an end torque of 1 N m, and the bimoment at the clamp."""
    m = clamped(BEAM, SPAN, n, held=(0,))
    m.load(f"R{n}", [1.0, 0.0, 0.0])
    state = m.build().equilibrium()
    angles = np.array([twist(state, f"R{i}") for i in range(n + 1)])
    return np.linspace(0.0, SPAN, n + 1), angles, state.section_forces("b0")[0].B


def mid_twist(n: int) -> float:
    """Return the twist in the middle of the I beam between forks under a torque of 1 N m there."""
    m = between_forks(BEAM, SPAN, n)
    m.load(f"R{n // 2}", [1.0, 0.0, 0.0])
    return twist(m.build().equilibrium(), f"R{n // 2}")


def buckling_moment(section: Section, length: float, n: int, warping: bool = True) -> float:
    """Find the uniform moment that buckles the beam sideways, about the axis of its large stiffness."""
    m = between_forks(section, length, n, warping=warping)
    system = m.build()
    modes = system.buckling(increment={"bend 0.angle": -1.0, f"bend {n}.angle": 1.0}, count=1)
    return abs(modes[0].multiplier)


def buckling_load(length: float, n: int, held: bool) -> float:
    """Find the axial load that twists the I beam, as a column whose axis is kept straight."""
    m = between_forks(BEAM, length, n, held=(0, n) if held else ())
    m.fix(*(f"P{i}.{component}" for i in range(1, n) for component in "yz"))
    return m.build().buckling(increment={f"P{n}.x": -1.0}, count=1)[0].multiplier


def tip_load(ratio: float, n: int) -> float:
    """Find the tip load over sqrt(EIy GJ)/L² that buckles a cantilever sideways, at GJ L²/(E Iw) = ratio."""
    m = fx.Model()
    for i in range(n + 1):
        m.point(f"P{i}", (i / n, 0, 0), fixed=i == 0)
        m.frame(f"R{i}", fixed=i == 0)
        m.warping(f"W{i}", fixed=i == 0)
    for i in range(n):
        ends, warps = (f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"), (f"W{i}", f"W{i + 1}")
        m.beam(f"b{i}", *ends, direction=(0, 1, 0), warping=warps, EIw=1 / ratio, **SLENDER)
    return abs(m.build().buckling(increment={f"P{n}.y": -1.0}, count=1)[0].multiplier)


def frequencies(n: int, count: int) -> Array:
    """Compute the torsional frequencies [rad/s] of the I beam between forks."""
    m = between_forks(BEAM, SPAN, n)
    m.fix(*(f"P{i}" for i in range(1, n)), f"P{n}.x")
    return np.array([mode.omega for mode in m.build().vibrations(count=count)])


def cantilever_mode(n: int) -> float:
    """Compute the lowest torsional frequency [rad/s] of the I beam as a cantilever whose axis is held."""
    m = clamped(BEAM, SPAN, n, held=(0,))
    m.fix(*(f"P{i}" for i in range(1, n + 1)))
    return float(m.build().vibrations(count=1)[0].omega)


def plain_difference(n: int) -> float:
    """Return the largest relative difference of the end's compliance from that of plain beams, with warping free."""
    found = [
        clamped(BEAM, SPAN, n, warping=warping).build().compliance(f"P{n}", f"R{n}").matrix
        for warping in (True, False)
    ]
    size = np.sqrt(np.outer(np.diag(found[1]), np.diag(found[1])))
    return float(np.max(np.abs(found[0] - found[1]) / size))


def reproduce(out: Path | None = None) -> Report:
    """Compute all quantities with their references; write a figure to `out`, if given."""
    from flexel.examples.warping_table import rows

    files: list[Path] = []
    if out is not None:
        from flexel.examples.warping_figures import pictures

        files = pictures(out)
    return Report("warping", rows(), files)
