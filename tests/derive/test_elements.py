"""Elements: statements of physics about every definition, before anything is differentiated."""

import random

import mpmath
from element_numbers import (
    Vector,
    as_seen,
    cross,
    equal,
    every,
    is_planar,
    named,
    numbers,
    plus,
    random_coordinates,
    random_parameters,
    rates_of_deformations,
    rotated,
    symmetry,
    with_deformations,
    with_mass,
    with_slips,
)
from mpmath import mpf

from flexel.derive.declare import (
    Element,
)
from flexel.generated.table import ELEMENTS


@with_deformations
def test_deformations_do_not_notice_a_superposed_rigid_motion(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x = numbers(element, **values), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    before = as_seen(element, d.D(x), lambda vector: rotated(motion.q, vector))
    after = d.D(motion.moved(element, x))
    turns = [mpmath.nint((a - b) / (2 * mpmath.pi)) for a, b in zip(after, before, strict=True)]
    assert all(turn == 0 or mode.period for turn, mode in zip(turns, element.deformations, strict=True))
    assert equal([a - 2 * mpmath.pi * turn for a, turn in zip(after, turns, strict=True)], before)


@with_deformations
def test_rigid_motion_has_no_rates_of_deformation(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x = numbers(element, **values), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    rates = rates_of_deformations(d, x, motion.rigid_rates(element, x))
    still = [0] * d.m if element.name != "cable" else [0] * 3 + d.D(x)[3:]
    assert equal(rates, as_seen(element, still, lambda vector: cross(motion.omega, vector)), mpf(10) ** -25)


IN_GLOBAL_AXES = {"rotation", "bar_span", "beam_span", "planar_bar_span", "planar_beam_span"}
IN_GLOBAL_AXES |= {"cable_span", "planar_cable_span"}


@with_slips
def test_slips_turn_with_the_body_or_stay(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x, v = numbers(element, **values), random_coordinates(element, rng), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    after = d.s(motion.moved(element, x), motion.moved(element, v, rates=True))
    before = d.s(x, v)
    arrow = named(
        "planar_point_mass" if is_planar(element) else "point_mass"
    )  # its rates turn as a vector does
    turned = motion.moved(arrow, before, rates=True) if element.name in IN_GLOBAL_AXES else before
    assert equal(after, turned)


@with_mass
def test_kinetic_energy_does_not_depend_on_place_and_direction(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    d, x, v = numbers(element, **values), random_coordinates(element, rng), random_coordinates(element, rng)
    motion = symmetry(element, values, rng)
    after = d.T(motion.moved(element, x), motion.moved(element, v, rates=True))
    assert equal([after], [d.T(x, v)])


@with_mass
def test_weight_is_mass_times_gravity(element: Element, rng: random.Random) -> None:
    """The nodal forces -dU/dx are M a for the accelerations a of a uniform translation."""
    values = random_parameters(element, rng)
    d, x, v = numbers(element, **values), random_coordinates(element, rng), random_coordinates(element, rng)
    a: Vector = []
    for node in element.nodes:
        a += values["gravity"] if node.kind in ("point", "planar_point") else [mpf(0)] * node.size
    h = mpf(10) ** -16
    power = (d.U(plus(x, v, h)) - d.U(plus(x, v, -h))) / (2 * h)
    assert equal([-power], [(d.T(x, plus(v, a)) - d.T(x, plus(v, a, -1))) / 2], mpf(10) ** -25)


@with_mass
def test_kinetic_energy_is_quadratic_and_not_negative(element: Element, rng: random.Random) -> None:
    values = random_parameters(element, rng)
    if "J" in values and element.name in ("body", "rotary_inertia"):
        values["J"] = [1, 2, 2.5, 0.1, 0.2, -0.1]
    values = {k: [abs(c) for c in v] if k == "rhoJ" and isinstance(v, list) else v for k, v in values.items()}
    d, x = numbers(element, **values), random_coordinates(element, rng)
    u, v = random_coordinates(element, rng), random_coordinates(element, rng)
    parallelogram = d.T(x, plus(u, v)) + d.T(x, plus(u, v, -1))
    assert equal([parallelogram], [2 * d.T(x, u) + 2 * d.T(x, v)])
    assert d.T(x, u) > 0


@every(list(ELEMENTS))
def test_every_element_says_what_it_is_and_where_it_comes_from(element: Element) -> None:
    assert element.doc
    assert element.source
    assert all(parameter.doc for parameter in element.parameters)


def test_names_in_the_tables_are_unique() -> None:
    from flexel.derive.elements import ELEMENTS
    from flexel.derive.laws import LAWS

    names = [element.name for element in ELEMENTS] + [f"law_{law.name}" for law in LAWS]
    assert len(names) == len(set(names))
