"""The table of the flexure mechanisms: quantities with their closed forms, and others that are only reported."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.examples import flexures_exact as exact
from flexel.examples.flexures import (
    BENDING,
    CASES,
    DIRECTIONS,
    ELEMENTS,
    GUIDE,
    HALF_ANGLE,
    IDEAL,
    PIVOT,
    SPACING,
    STEEL,
    Design,
    FlexureResults,
    Maker,
    critical,
    expected_stiffness,
    guided_directions,
)
from flexel.examples.reasons import ROUNDING
from flexel.results.reproduction import Quantity


def ends(d: Design) -> list[tuple[Array, Array]]:
    """Return the axes of the leaf springs, and their ends relative to the reference point."""
    if d is GUIDE:
        return [(np.eye(3), np.array([d.length / 2, y, 0.0])) for y in (-SPACING / 2, SPACING / 2)]
    found = []
    for angle in (HALF_ANGLE, -HALF_ANGLE):
        c, s = np.cos(angle), np.sin(angle)
        axes = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
        found.append((axes, axes[:, 0] * d.length / 2))
    return found


def rows(results: FlexureResults) -> list[Quantity]:
    """Return the whole table."""
    found = [*guide_rows(results), *bent_rows(results), *pivot_rows(results)]
    for make, d in CASES:
        found += [*stiffness_rows(results, d), *payload_rows(results, d), *constraint_rows(make, d)]
    return [*found, *range_rows(results, GUIDE), *range_rows(results, PIVOT)]


def stiffness_rows(results: FlexureResults, d: Design) -> list[Quantity]:
    """Compare the stiffness at rest in the six directions."""
    station = (results.guide if d is GUIDE else results.pivot)[0]
    K = exact.body_stiffness(d.profile, d.length, ends(d))
    expected = 1 / np.diag(np.linalg.inv(K))
    rows = []
    for i, direction in enumerate(DIRECTIONS):
        unit = "N/m" if i < 3 else "N m/rad"
        tolerance, reason = 1e-12, ""
        if d is PIVOT and direction == "turn z":  # a small difference of large stiffnesses
            tolerance, reason = 2e-9, ROUNDING
        elif (
            d is GUIDE and direction == "y"
        ):  # 60 000 times softer than x: twelve other thicknesses give up to 4e-12
            tolerance, reason = 1e-11, ROUNDING
        rows.append(
            Quantity(f"{d.case}_stiffness_{direction.replace(' ', '_')}", station.free.stiffness()[direction],
                     float(expected[i]), tolerance, unit, exact.BEAM, {"elements": ELEMENTS}, kind="closed form",
                     reason=reason)
        )  # fmt: skip
    return rows


def payload_rows(results: FlexureResults, d: Design) -> list[Quantity]:
    """Compare drive stiffness under payload, and the payload that buckles; closed forms know bending only."""
    loads, found = results.payload[d.case]
    source = exact.COLUMN if d is GUIDE else exact.PIVOT
    expected = [expected_stiffness(d, float(p)) for p in loads]
    station = (results.guide if d is GUIDE else results.pivot)[0]
    push, pull = critical(d)
    unit, more = "N/m" if d is GUIDE else "N m/rad", {"payloads": loads.tolist(), "elements": ELEMENTS}
    stiffness, buckling = (5e-4, 2e-4) if d is GUIDE else (1e-3, 5e-4)
    rows = [
        Quantity(f"{d.case}_stiffness_under_payload", found, expected, stiffness, unit, source, more,
                 kind="closed form"),
        Quantity(f"{d.case}_buckling_payload", station.buckling[0], push, buckling, "N", f"{source}; at rest, -x",
                 kind="closed form"),
    ]  # fmt: skip
    if np.isfinite(pull):
        rows.append(Quantity(f"{d.case}_buckling_pull", station.buckling[1], pull, 1.2e-5, "N",
                             f"{source}; at rest, +x", kind="closed form"))  # fmt: skip
    return rows


def guide_rows(results: FlexureResults) -> list[Quantity]:
    """Compare parasitic motion, large deflection, softening, frequency and stress of the guide."""
    d, near, rest, last = GUIDE, results.small["guide"], results.guide[0], results.guide[-1]
    L, u = d.length, near.travel
    softening = near.held.matrix[0, 0] - rest.held.matrix[0, 0]
    w, drop = exact.cantilever_elastica(last.drive / 2 * (L / 2) ** 2 / d.EI)
    rhoA = d.profile.mass()[0]
    omega = exact.guided_frequency(d.EI, L, rhoA, d.mass / 2)
    softer = 1 / 1400 + d.EI / (
        2 * d.profile.stiffness()["EA"] * SPACING**2
    )  # the shuttle turns a little, too
    peak = 3 * STEEL.E * d.section.height * u / L**2
    small_deflection = "3 u²/(5 L), cubic shape; at u = L/1000"
    known: tuple[tuple[str, float, float, float, str, str], ...] = (
        ("guide_shortening", -near.shift[0] * L / u**2, 0.6, 1e-4, "", small_deflection),
        ("guide_elastica_travel", last.travel / L, w, 8e-4, "", exact.ELASTICA),
        ("guide_elastica_shortening", -last.shift[0] / L, drop, 1.5e-3, "", exact.ELASTICA),
        ("guide_softening_x", softening * d.EI / (L * u**2), softer, 3e-3, "", f"{exact.AWTAR}: 1/700"),
        ("guide_frequency", rest.frequencies[0], omega, 6e-5, "rad/s", exact.FREQUENCY),
        ("guide_stress", near.stress.point.normal, peak, 1.2e-4, "Pa", "3 E t u/L²"),
    )
    return [Quantity(*row, kind="closed form") for row in known]


def bent_rows(results: FlexureResults) -> list[Quantity]:
    """Compare support stiffness of the guide at an eighth of its range, where it has fallen by a quarter or more."""
    station = results.guide[len(results.guide) // 8]
    expected = exact.bent_guide(GUIDE.profile, GUIDE.length, SPACING, station.travel)
    found, more = station.held.stiffness(), {"travel": station.travel, "elements": ELEMENTS}
    return [
        Quantity(f"guide_bent_stiffness_{direction.replace(' ', '_')}", found[direction], expected[direction],
                 1.2e-3 if direction == "x" else 8e-3, "N/m" if direction in "xyz" else "N m/rad", exact.BENT, more,
                 kind="closed form")
        for direction in expected
    ]  # fmt: skip


def pivot_rows(results: FlexureResults) -> list[Quantity]:
    """Compare shift of the axis, frequency and stress of the pivot."""
    d, near, rest = PIVOT, results.small["pivot"], results.pivot[0]
    L, angle = d.length, near.travel
    inertia = d.inertia + 2 * d.profile.mass()[0] * L**3 / 20  # the leaf springs bend to circles
    omega = np.sqrt(2 * d.EI / L / inertia)
    shift = near.shift[0] / (L * angle**2)
    peak = STEEL.E * d.section.height * angle / (2 * L)
    known: tuple[tuple[str, float, float, float, str, str], ...] = (
        ("pivot_axis_shift", shift, 1 / (12 * np.cos(HALF_ANGLE)), 6e-5, "", "L a²/(12 cos 45°)"),
        ("pivot_frequency", rest.frequencies[0], omega, 1e-6, "rad/s", "Rayleigh, circular arcs"),
        ("pivot_stress", near.stress.point.normal, peak, 5e-4, "Pa", "E t a/(2 L)"),
    )
    return [Quantity(*row, kind="closed form") for row in known]


def constraint_rows(make: Maker, d: Design) -> list[Quantity]:
    """Compare the over-constraint of ideal leaf springs, torsion free and thought rigid, and after release."""
    rows = []
    for name, flexible, redundant in (("", IDEAL, 1), ("_torsion_rigid", BENDING, 3)):
        m = make(flexible=flexible, elements=1)
        found = m.constraint_report()
        named = {"redundant": [sorted(names) for names in found.redundant], "release": found.release}
        of = "elongation, bend1, bend2" + (", torsion" if name else "")
        source = f"count, {of} of both leaf springs rigid; release {', '.join(found.release)}"
        rows.append(
            Quantity(
                f"{d.case}_overconstraint{name}",
                len(found.redundant),
                redundant,
                0,
                "",
                source,
                named,
                kind="closed form",
            )
        )
        m.release(*found.release)
        dofs = m.build().counts["degrees_of_freedom"] if not m.constraint_report().redundant else -1
        rows.append(
            Quantity(
                f"{d.case}_degrees_of_freedom_after_release{name}",
                dofs,
                1,
                0,
                "",
                "the motion it is made for",
                kind="closed form",
            )
        )
    return rows


def range_rows(results: FlexureResults, d: Design) -> list[Quantity]:
    """Return quantities without a closed form, along the range; at its end compared with half the elements."""
    stations = results.guide if d is GUIDE else results.pivot
    coarse, half = results.coarse[d.case].held.stiffness(), f"with_{ELEMENTS // 2}_elements"
    unit = "m" if d is GUIDE else "rad"
    rest, last, case = stations[0].held.stiffness(), stations[-1].held.stiffness(), d.case
    buckling = [station.buckling[0] for station in stations]
    frequencies = np.array([station.frequencies for station in stations])
    free, in_body = (
        np.array([getattr(station.free, kind) for station in stations]) for kind in ("matrix", "in_body")
    )
    found = [
        Quantity(f"{case}_end_travel", stations[-1].travel, unit=unit, source="at the largest drive"),
        Quantity(
            f"{case}_end_stress",
            stations[-1].stress.mises,
            unit="Pa",
            source="von Mises, at the largest drive",
        ),
        Quantity(
            f"{case}_end_buckling_payload", buckling[-1], unit="N", source="in -x, at the largest drive"
        ),
    ]
    for direction in guided_directions(d):
        name, ratio = f"{case}_end_stiffness_{direction.replace(' ', '_')}", last[direction] / rest[direction]
        source = (
            f"over that at rest, drive held; {coarse[direction] / rest[direction]:.4g} with half the elements"
        )
        found.append(
            Quantity(
                name,
                ratio,
                source=source,
                more={"elements": ELEMENTS, half: coarse[direction] / rest[direction]},
            )
        )
    found += [
        Quantity(
            f"{case}_range_travel",
            [station.travel for station in stations],
            unit=unit,
            source="along the range",
        ),
        Quantity(f"{case}_range_frequencies", frequencies, unit="rad/s", source="along the range"),
        Quantity(
            f"{case}_range_stress",
            [station.stress.mises for station in stations],
            unit="Pa",
            source="von Mises, along the range",
        ),
        Quantity(f"{case}_range_buckling", buckling, unit="N", source="payload in -x"),
        Quantity(f"{case}_range_compliance", free, source="global axes"),
        Quantity(f"{case}_range_compliance_body", in_body, source="body axes"),
    ]
    for direction in guided_directions(d):
        values = [s.held.stiffness()[direction] for s in stations]
        units = "N/m" if direction in "xyz" else "N m/rad"
        name = f"{case}_range_stiffness_{direction.replace(' ', '_')}"
        found.append(Quantity(name, values, unit=units, source="drive held"))
    return found
