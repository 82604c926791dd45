"""The table of beams with warping sections: every quantity with its closed form."""

from __future__ import annotations

import numpy as np

from flexel.examples import warping as example
from flexel.examples import warping_exact as exact
from flexel.examples.convergence import order
from flexel.examples.reasons import ROUNDING
from flexel.examples.warping_exact import BEAM, LEAF, SPAN, Section
from flexel.results.reproduction import Quantity

VLASOV = "Vlasov 1961, Thin-walled elastic beams"
LEAVES = {1.0: 5e-8, 2.0: 7e-7, 5.0: 1e-5, 10.0: 7e-5, 20.0: 4e-4, 50.0: 4e-3}  # k l: tolerance, 16 elements
ONE = {1.0: 3e-4, 2.0: 3e-3, 5.0: 5e-2}  # k l: tolerance, one element
TIP_RATIOS = {1.0: 1e-5, 6.0: 1.2e-5, 40.0: 3e-5}  # GJ L²/(E Iw): tolerance
LEAF_LENGTH = 0.1


def rows() -> list[Quantity]:
    """Return all rows."""
    return [*leaf(), *torsion(), *lateral(), *column(), *vibration(), *limits()]


def leaf() -> list[Quantity]:
    """Compare restrained torsion of a leaf, clamped at both ends, with uniform torsion."""
    source = f"{VLASOV}; 1/(1 - tanh(k l/2)/(k l/2))"
    found = [
        Quantity(f"leaf_{kl:g}", example.leaf_stiffness(kl, 16), exact.restrained(kl), tolerance, "GJ/l", source,
                 {"elements": 16}, kind="closed form")
        for kl, tolerance in LEAVES.items()
    ] + [
        Quantity(f"leaf_one_element_{kl:g}", example.leaf_stiffness(kl, 1), exact.restrained(kl), tolerance, "GJ/l",
                 source, {"elements": 1}, kind="closed form")
        for kl, tolerance in ONE.items()
    ]  # fmt: skip
    errors = [abs(example.leaf_stiffness(5.0, n) / exact.restrained(5.0) - 1) for n in (8, 16)]
    stretched = example.leaf_stiffness(5.0, 16, tension=1.0)
    return [
        *found,
        Quantity("leaf_order", order(errors), 4.0, 0.1, "", "cubic interpolation", kind="closed form",
                 tolerance_kind="absolute"),
        Quantity("leaf_in_tension", stretched, exact.stretched(5.0, 1.0), 3e-5, "GJ/l",
                 "Wagner 1929: GJ + N Ip/A in place of GJ; N Ip/A = GJ, k l = 5", {"elements": 16},
                 kind="closed form"),
    ]  # fmt: skip


def torsion() -> list[Quantity]:
    """Compare uneven torsion of an I beam."""
    x, angles, bimoment = example.cantilever_torsion(16)
    k, GJ = exact.decay(BEAM), exact.stiffnesses(BEAM)[0]
    closed = exact.cantilever_twist(x, 1.0, SPAN, BEAM)
    middle = (SPAN / 2 - np.tanh(k * SPAN / 2) / k) / (2 * GJ)
    more = {"elements": 16, "k l": k * SPAN}
    return [
        Quantity("cantilever_twist", angles / closed[-1], closed / closed[-1], 3e-6, "", VLASOV, more,
                 kind="closed form", tolerance_kind="absolute"),
        Quantity("cantilever_bimoment", bimoment, np.tanh(k * SPAN) / k, 1e-5, "N m²", f"{VLASOV}; T tanh(k l)/k", more,
                 kind="closed form"),
        Quantity("torque_in_the_middle", example.mid_twist(16), middle, 8e-6, "rad", VLASOV, more, kind="closed form"),
    ]  # fmt: skip


def lateral() -> list[Quantity]:
    """Compare lateral buckling under uniform moment, with warping and without, and under a tip load."""
    source = "Timoshenko and Gere 1961, pi/l sqrt(EIy (GJ + pi² E Iw/l²))"
    cases: dict[str, tuple[Section, float, bool, float]] = {
        "lateral_i_beam": (BEAM, SPAN, True, 4e-6),
        "lateral_i_beam_without_warping": (BEAM, SPAN, False, 4e-3),
        "lateral_leaf": (LEAF, LEAF_LENGTH, True, 3e-6),
        "lateral_leaf_without_warping": (LEAF, LEAF_LENGTH, False, 4e-3),
    }
    found = [
        Quantity(name, example.buckling_moment(section, length, 16, warping),
                 exact.lateral_moment(section, length, warping), tolerance, "N m", source, {"elements": 16},
                 kind="closed form")
        for name, (section, length, warping, tolerance) in cases.items()
    ]  # fmt: skip
    return found + [
        Quantity(f"tip_load_{ratio:g}", example.tip_load(ratio, 16), exact.tip_load_factor(ratio), tolerance, "",
                 "Vlasov's equation integrated, GJ l²/(E Iw) in the name", {"elements": 16}, kind="own")
        for ratio, tolerance in TIP_RATIOS.items()
    ]  # fmt: skip


def column() -> list[Quantity]:
    """Compare torsional buckling of the I beam as a column."""
    source = "Timoshenko and Gere 1961, A/Ip (GJ + pi² E Iw/l²)"
    cases = (("free_to_warp", False, 1, 2e-6), ("held_plane", True, 2, 6e-5))
    return [
        Quantity(f"column_{name}", example.buckling_load(SPAN, 16, held), exact.torsional_load(SPAN, restraint),
                 tolerance, "N", source, {"elements": 16}, kind="closed form")
        for name, held, restraint, tolerance in cases
    ]  # fmt: skip


def vibration() -> list[Quantity]:
    """Compare torsional frequencies of the I beam."""
    return [
        Quantity("fork_frequencies", example.frequencies(16, 3), exact.fork_frequencies(3), 2e-4, "rad/s",
                 "Vlasov 1961, beam between forks, warping inertia included", {"elements": 16}, kind="closed form"),
        Quantity("cantilever_frequency", example.cantilever_mode(16), exact.cantilever_frequency(), 4e-6, "rad/s",
                 "frequency equation of a cantilever, warping inertia included", {"elements": 16},
                 kind="closed form"),
    ]  # fmt: skip


def limits() -> list[Quantity]:
    """Compare the beam with warping free with the plain one."""
    return [
        Quantity("plain_beam_compliance_error", example.plain_difference(3), 0.0, 1e-12, "", "the plain beam",
                 kind="own", reason=ROUNDING),
    ]  # fmt: skip
