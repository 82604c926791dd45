"""Cables and their contact with bodies: statements about the definitions, before anything is differentiated."""

import random
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest
from element_numbers import (
    TINY,
    Vector,
    column,
    cross,
    equal,
    named,
    numbers,
    plus,
    product,
    rates_of_deformations,
    rotated,
    rotation,
    unit,
)
from mpmath import cos, mpf, sin, sqrt

SURFACES = ["cable_cylinder", "cable_plane", "cable_v_groove", "cable_round_groove", "cable_helical_groove"]
STILL = [1, 0, 0, 0]


def helix(s: Any, radius: Any, pitch: Any) -> tuple[Vector, Vector]:
    """Place and direction at the arc length s of a helix about z of constant curvature radius/(radius² + pitch²)."""
    c = sqrt(radius**2 + pitch**2)
    at = [radius * cos(s / c), radius * sin(s / c), pitch * s / c]
    return at, [-radius / c * sin(s / c), radius / c * cos(s / c), pitch / c]


def cable_along(curve: Callable[[Any], tuple[Vector, Vector]], l0: Any) -> Vector:
    (p, dp), (q, dq) = curve(mpf(0)), curve(mpf(l0))
    return [*p, *dp, *q, *dq]


@pytest.mark.parametrize("stretch", [1, mpf("1.01")])
def test_straight_cable_has_the_relative_elongation_and_no_curvature(
    stretch: Any, rng: random.Random
) -> None:
    direction, start, l0 = unit(column(rng, 3)), column(rng, 3), mpf("0.7")
    slope = [stretch * c for c in direction]
    x = [*start, *slope, *plus(start, slope, l0), *slope]
    e = numbers(named("cable"), l0=l0).D(x)
    assert equal(e, [stretch - 1] + [0] * 11)


def test_strain_and_curvature_of_a_helix_converge_with_third_and_second_order() -> None:
    """Errors of a cubic through the exact ends and slopes: of third order in r', of second order in r''."""
    radius, pitch, errors = mpf(1), mpf("0.3"), []
    for l0 in (mpf("0.2"), mpf("0.1")):
        e = numbers(named("cable"), l0=l0).D(cable_along(lambda s: helix(s, radius, pitch), l0))
        lengths = [sqrt(sum(c**2 for c in e[i : i + 3])) for i in (3, 6, 9)]
        exact = radius / (radius**2 + pitch**2)
        errors.append((max(abs(strain) for strain in e[:3]), max(abs(length - exact) for length in lengths)))
    strain, curvature = (errors[0][i] / errors[1][i] for i in (0, 1))
    assert strain > 2**3 * mpf("0.9")
    assert curvature > 2**2 * mpf("0.9")
    assert errors[1][0] < 1e-4
    assert errors[1][1] < 1e-3


def test_curvature_vector_of_a_planar_arc_is_normal_to_the_plane_and_signed() -> None:
    for sign in (1, -1):
        e = numbers(named("planar_cable"), l0=mpf("0.01")).D(
            [
                0,
                0,
                1,
                0,
                sin(mpf("0.01")),
                sign * (1 - cos(mpf("0.01"))),
                cos(mpf("0.01")),
                sign * sin(mpf("0.01")),
            ]
        )
        assert equal(e[3:], [sign] * 3, 1e-5)


def test_kinetic_energy_of_a_turning_cable_is_that_of_a_rod(rng: random.Random) -> None:
    l0, omega = mpf("0.8"), [0, 0, mpf(3)]
    d = numbers(named("cable"), l0=l0, rhoA=mpf(2))
    x = [0, 0, 0, 1, 0, 0, l0, 0, 0, 1, 0, 0]
    v = [c for i in range(0, 12, 3) for c in cross(omega, x[i : i + 3])]
    assert equal([d.T(x, v)], [mpf(2) * l0**3 / 3 * 9 / 2])


def test_clamp_measures_the_direction_across_and_not_the_stretch(rng: random.Random) -> None:
    lam, t = unit(column(rng, 4)), unit(column(rng, 4))
    axes = product(lam, t)
    slope = rotated(axes, [mpf("1.02"), mpf("0.1"), mpf("-0.2")])
    assert equal(numbers(named("slope_clamp"), t=t).D([*lam, *slope]), [mpf("0.1"), mpf("-0.2")])


# --- contact -----------------------------------------------------------------------------------------------


def surface(name: str, rng: random.Random, **given: Any) -> tuple[Any, dict[str, Any], Vector]:
    """Return a contact, its parameters and the place and orientation of its body."""
    beta = mpf("0.4")
    values = {"l0": mpf("0.5"), "xi": mpf("0.3"), "t": unit(column(rng, 4)), "offset": column(rng, 3)}
    values |= {
        "radius": mpf("0.4"),
        "rope_radius": mpf("0.01"),
        "groove_radius": mpf("0.011"),
        "lead": mpf("0.03"),
    }
    values |= {"flank": [sin(beta), cos(beta)]} | given
    known = {p.name for p in named(name).parameters}
    values = {key: value for key, value in values.items() if key in known}
    return numbers(named(name), **values), values, [*column(rng, 3), *unit(column(rng, 4))]


def on_surface(values: dict[str, Any], body: Vector, y: Vector) -> Vector:
    """Global place of a point given on the surface's triad, from the surface's origin."""
    return plus(body[:3], rotated(product(body[3:], values["t"]), plus(y, values["offset"])))


def rope_through(point: Vector, values: dict[str, Any], rng: random.Random) -> Vector:
    """A cable whose point of contact at xi lies at `point`; the rest of it is arbitrary."""
    xi, l0 = values["xi"], values["l0"]
    dp, q, dq = column(rng, 3), column(rng, 3), column(rng, 3)
    D = sum((b - a) ** 2 for a, b in zip(dp, dq, strict=True))
    h = 1 + D / 48 + 13 * D**2 / 5760
    n = [(1 - xi) ** 2 * (1 + 2 * xi), l0 * xi * (1 - xi) ** 2, xi**2 * (3 - 2 * xi), -l0 * xi**2 * (1 - xi)]
    rest = plus(plus([h * n[1] * c for c in dp], q, n[2]), dq, h * n[3])
    return [*[(a - b) / n[0] for a, b in zip(point, rest, strict=True)], *dp, *q, *dq]


def gaps(name: str, y: Vector, seed: random.Random, **given: Any) -> Vector:
    d, values, body = surface(name, seed, **given)
    return d.D([*rope_through(on_surface(values, body, y), values, seed), *body])


def test_gap_to_a_cylinder_is_the_distance_from_the_axle_less_both_radii(rng: random.Random) -> None:
    assert equal(gaps("cable_cylinder", [7, mpf("0.3"), mpf("-0.4")], rng), [mpf("0.09")])


def test_gap_to_a_plane_is_the_height_less_the_radius(rng: random.Random) -> None:
    assert equal(gaps("cable_plane", [3, -5, mpf("0.02")], rng), [mpf("0.01")])


@pytest.mark.parametrize("name", ["cable_v_groove", "cable_round_groove"])
def test_rope_rests_in_the_middle_of_its_groove(name: str, rng: random.Random) -> None:
    for angle in (mpf(0), mpf(1), mpf(4)):
        e = gaps(name, [0, mpf("0.41") * cos(angle), mpf("0.41") * sin(angle)], rng)
        assert equal(e, [0] * len(e))


def test_v_groove_guides_towards_the_middle(rng: random.Random) -> None:
    """Sideways by a: one flank opens, the other closes by a cos beta."""
    a = mpf("0.001")
    assert equal(
        gaps("cable_v_groove", [a, 0, mpf("0.41")], rng), [-a * cos(mpf("0.4")), a * cos(mpf("0.4"))]
    )


def test_round_groove_is_round_at_the_bottom_and_open_at_the_top(rng: random.Random) -> None:
    centre, play = mpf("0.411"), mpf("0.001")
    for angle in (0, mpf("0.5"), mpf(-1)):  # within 90° - beta of the bottom
        y = [mpf("0.02") * sin(angle), 0, centre - mpf("0.02") * cos(angle)]
        assert equal(gaps("cable_round_groove", y, rng), [play - mpf("0.02")])
    assert gaps("cable_round_groove", [0, 0, 10], rng)[0] > 1
    flank = [mpf("0.02") * sin(mpf(2)), 0, centre - mpf("0.02") * cos(mpf(2))]
    assert equal(
        gaps("cable_round_groove", flank, rng),
        [play - mpf("0.02") * cos(2 - (mpf(mpmath.pi) / 2 - mpf("0.4")))],
    )


def test_round_groove_is_smooth_where_the_flank_begins(rng: random.Random) -> None:
    end = mpmath.pi / 2 - mpf("0.4")
    state = rng.getstate()

    def slope(side: int) -> Any:
        values = []
        for step in (mpf("1e-12"), mpf("2e-12")):
            rng.setstate(state)
            angle = end + side * step
            y = [mpf("0.02") * sin(angle), 0, mpf("0.411") - mpf("0.02") * cos(angle)]
            values.append(gaps("cable_round_groove", y, rng)[0])
        return side * (values[1] - values[0]) / mpf("1e-12")

    assert abs(slope(1) - slope(-1)) < 1e-9


@pytest.mark.parametrize("lead", [mpf("0.03"), mpf("-0.05")])
def test_rope_rests_in_every_turn_of_a_helical_groove(lead: Any, rng: random.Random) -> None:
    for angle in (mpf(0), mpf(3), mpf(4), mpf(30), mpf(-7)):
        y = [lead * angle / (2 * mpmath.pi), mpf("0.41") * cos(angle), mpf("0.41") * sin(angle)]
        assert equal(gaps("cable_helical_groove", y, rng, lead=lead), [0])


def test_helical_groove_has_the_profile_of_a_round_one_and_repeats_beyond_the_ridges(
    rng: random.Random,
) -> None:
    """Sideways by z, the distance from the groove is z cos gamma; beyond a ridge, that from the other turn."""
    lead, angle = mpf("0.03"), mpf(2)
    slant = 1 / sqrt(1 + (lead / (2 * mpmath.pi * mpf("0.41"))) ** 2)
    for z, nearest in (("0.004", "0.004"), ("-0.002", "0.002"), ("0.0149", "0.0149"), ("0.0151", "0.0149")):
        off = [lead * angle / (2 * mpmath.pi) + mpf(z), mpf("0.415") * cos(angle), mpf("0.415") * sin(angle)]
        round_one = gaps("cable_round_groove", [slant * mpf(nearest), mpf("0.415"), 0], rng)
        assert equal(gaps("cable_helical_groove", off, rng), round_one, mpf(10) ** -25)


def test_gap_of_a_helical_groove_grows_across_it_alone_and_as_fast_as_the_distance(
    rng: random.Random,
) -> None:
    """So the contact force is normal to the groove, and its size is that of the law."""
    state, step, pitch, r, angle = rng.getstate(), mpf("1e-15"), mpf("0.03") / (2 * mpmath.pi), mpf("0.41"), 1
    slope = []
    for i in range(3):
        ends = []
        for sign in (1, -1):
            rng.setstate(state)
            y = [pitch * angle + mpf("0.003"), r * cos(angle), r * sin(angle)]
            y[i] += sign * step
            ends.append(gaps("cable_helical_groove", y, rng)[0])
        slope.append((ends[0] - ends[1]) / (2 * step))
    along = [pitch, -r * sin(angle), r * cos(angle)]
    assert equal([sum(component**2 for component in slope)], [1], mpf(10) ** -20)
    assert equal([sum(a * b for a, b in zip(slope, along, strict=True))], [0], mpf(10) ** -20)


@pytest.mark.parametrize("name", SURFACES)
def test_rope_that_moves_with_the_body_does_not_slide(name: str, rng: random.Random) -> None:
    d, values, body = surface(name, rng)
    x = [*rope_through(on_surface(values, body, [mpf("0.002"), mpf("0.1"), mpf("0.4")]), values, rng), *body]
    omega, velocity = column(rng, 3), column(rng, 3)
    v: Vector = []
    for i, free in ((0, 1), (3, 0), (6, 1), (9, 0), (12, 1)):
        v += plus(cross(omega, x[i : i + 3]), velocity, free)
    v += [c / 2 for c in product([0, *omega], body[3:])]
    assert equal(d.s(x, v), [0] * d.k)
    assert equal(rates_of_deformations(d, x, v), [0] * d.m, mpf(10) ** -25)


@pytest.mark.parametrize("name", SURFACES)
def test_gaps_and_slips_together_are_the_relative_velocity(name: str, rng: random.Random) -> None:
    """Motion of the rope alone: normal (rate of the gap) and sliding velocities have the length of the velocity.

    In a helical groove where its lead angle is taken: at the centre of the rope.
    """
    for depth in (mpf("0.41"), mpf("0.9"))[: 1 if name == "cable_helical_groove" else 2]:
        d, values, body = surface(name, rng)
        x = [*rope_through(on_surface(values, body, [mpf("0.05"), mpf(0), depth]), values, rng), *body]
        v = [*column(rng, 3), *[0] * 16]
        weight = (1 - values["xi"]) ** 2 * (1 + 2 * values["xi"])
        speed = weight**2 * sum(c**2 for c in v[:3])
        rates, slips = rates_of_deformations(d, x, v), d.s(x, v)
        for gap, across in zip(rates, slips[1:] if len(rates) == 2 else slips[-1:], strict=True):
            around = slips[0]
            assert abs(gap**2 + around**2 + across**2 - speed) < 1e-20


def test_friction_of_a_wound_rope_turns_the_drum_as_its_tension_does(rng: random.Random) -> None:
    """The slip around the axle sees the angular velocity of the body with the arm radius + rope_radius."""
    d, values, body = surface("cable_cylinder", rng, offset=[0, 0, 0])
    x = [*rope_through(on_surface(values, body, [0, 0, mpf("0.41")]), values, rng), *body]
    axle = rotated(product(body[3:], values["t"]), [1, 0, 0])
    v = [0] * 15 + [c / 2 for c in product([0, *axle], body[3:])]
    assert equal(d.s(x, v), [-mpf("0.41"), 0])


def test_gauss_points_are_those_of_numpy() -> None:
    from flexel.derive.declare.shape import gauss_points

    for count in (3, 4):
        places, _ = np.polynomial.legendre.leggauss(count)
        assert np.allclose(
            [float(point) for point in gauss_points(count)], (1 + places) / 2, rtol=0, atol=1e-15
        )


def test_quaternion_of_the_surface_turns_its_axle(rng: random.Random) -> None:
    """A cylinder whose triad is turned by 90° about z has its axle along the body's y."""
    quarter = rotation([0, 0, 1], mpmath.pi / 2)
    d = numbers(named("cable_cylinder"), l0=1, xi=0, t=quarter, radius=1)
    x = [mpf("0.6"), 5, mpf("0.8"), *[0] * 12, *STILL]
    assert equal(d.D(x), [0], TINY)
