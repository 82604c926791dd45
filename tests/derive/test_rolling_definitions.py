"""Pulleys, gears, wheels and surfaces: what rolls does not slip."""

import random

import pytest
from element_numbers import (
    Vector,
    X,
    Y,
    Z,
    column,
    cross,
    dot,
    equal,
    many,
    named,
    numbers,
    plus,
    product,
    rotated,
    rotation,
    unit,
)
from mpmath import cos, mpf, sin

from flexel.derive.verify.definition import Definition


def belt_force(radii: Vector, x: Vector) -> Vector:
    """Forces and moments on the nodes that do the work of a unit tension, by differences."""
    d, h = numbers(named("planar_belt"), radius_p=radii[0], radius_q=radii[1]), mpf(10) ** -16
    steps = [[h if i == j else mpf(0) for i in range(6)] for j in range(6)]
    return [(d.D(plus(x, u))[0] - d.D(plus(x, u, -1))[0]) / (2 * h) for u in steps]


@pytest.mark.parametrize("radii", [(0.3, 0.3), (0.5, 0.2), (0.2, -0.4), (-0.3, -0.1)])
def test_tension_of_a_belt_acts_along_the_common_tangent(radii: tuple[float, float]) -> None:
    a, b = map(mpf, radii)
    x = [mpf(0), mpf(0), mpf("0.3"), mpf("1.2"), mpf("0.5"), mpf("-0.2")]
    px, py, moment_p, qx, qy, moment_q = belt_force([a, b], x)
    small = mpf(10) ** -25
    assert equal([px + qx, py + qy, qx * qx + qy * qy], [0, 0, 1], small)  # a unit force and its reaction
    assert equal([moment_p, moment_q], [a, -b], small)
    # the line of the force passes both centres at the distances of the radii, on the left where they are positive
    total = moment_p + moment_q + x[3] * qy - x[4] * qx
    assert abs(total) < small


def test_gears_roll_without_slip_on_centres_that_move(rng: random.Random) -> None:
    a, b, arm, turn = (mpf(rng.uniform(0.2, 0.6)) for _ in range(4))
    d = numbers(named("planar_gear"), radius_p=a, radius_q=b)
    start = [mpf(0), mpf(0), mpf(0), a + b, mpf(0), mpf(0)]
    assert equal(d.D(start), [0])
    # planetary gear: the arm turns about the fixed sun, the planet by (1 + a/b) as much
    x = [mpf(0), mpf(0), mpf(0), (a + b) * cos(arm), (a + b) * sin(arm), arm * (1 + a / b)]
    assert equal(d.D(x), [0])
    # fixed centres: opposite turns in the ratio of the radii
    assert equal(d.D([0, 0, turn, a + b, 0, -turn * a / b]), [0])


def test_planar_wheel_rolls_where_it_heads(rng: random.Random) -> None:
    radius, heading, alpha0, spin = (mpf(rng.uniform(0.2, 0.6)) for _ in range(4))
    d = numbers(named("planar_wheel"), radius=radius, alpha0=alpha0)
    ahead = [cos(heading + alpha0), sin(heading + alpha0)]
    x = [mpf(0), mpf(0), heading, mpf(0)]
    assert equal(d.s(x, [radius * spin * ahead[0], radius * spin * ahead[1], mpf(1), spin]), [0, 0])
    assert equal(d.s(x, [-ahead[1], ahead[0], 0, 0]), [0, 1])


def test_surface_is_its_polynomial() -> None:
    d = numbers(named("surface"), quadratic=[1, 2, 3, 4, 5, 6], linear=[7, 8, 9], constant=10)
    assert equal(d.D([mpf(1), mpf(2), mpf(3)]), [1 + 8 + 27 + 8 + 15 + 36 + 7 + 16 + 27 + 10])


def leaning_wheel(rng: random.Random) -> tuple[Definition, Vector, Vector]:
    """Return a wheel on a tilted road, leaning, in contact, and r from the hub to the contact point."""
    road = unit(column(rng, 4))
    radius, height, lean, heading, pitch = (mpf(rng.uniform(0.3, 0.6)) for _ in range(5))
    body = product(rotation(Z, heading), product(rotation(X, lean), rotation(Y, pitch)))
    contact = rotated(road, [mpf("0.3"), mpf("-0.7"), height])
    r = rotated(product(road, product(rotation(Z, heading), rotation(X, lean))), [0, 0, -radius])
    normal = rotated(road, Z)
    d = numbers(named("wheel"), radius=radius, axle=Y, normal=normal, height=height)
    return d, [*plus(contact, r, -1), *product(road, body), *contact], r


def test_wheel_in_contact_is_undeformed(rng: random.Random) -> None:
    d, x, _ = leaning_wheel(rng)
    assert equal(d.D(x), [0, 0, 0, 0])


def test_rolling_wheel_does_not_slip_but_spins(rng: random.Random) -> None:
    d, x, r = leaning_wheel(rng)
    omega, normal = column(rng, 3), many(d.p[4:7])
    hub = cross(r, omega)
    rates = [c / 2 for c in product([0, *omega], x[3:7])]
    assert equal(d.s(x, [*hub, *rates, *column(rng, 3)]), [0, 0, dot(omega, normal)])


def test_slips_of_a_sliding_wheel_are_its_velocity_in_the_road(rng: random.Random) -> None:
    """An upright wheel with axle y, above the road z = 0: r x a points to +x and n x (r x a) to +y."""
    d = numbers(named("wheel"), radius=1, axle=Y, normal=Z, height=0)
    x = [0, 0, 1, 1, 0, 0, 0, 0, 0, 0]
    v = [mpf("0.3"), mpf("-0.2"), 0, 0, 0, 0, 0, 0, 0, 0]
    assert equal(d.s(x, v), [mpf("0.3"), mpf("-0.2"), 0])


def test_angular_velocities_in_body_and_global_axes_are_one_vector(rng: random.Random) -> None:
    t, lam, omega = unit(column(rng, 4)), unit(column(rng, 4)), column(rng, 3)
    rates = [c / 2 for c in product([0, *omega], lam)]
    assert equal(numbers(named("rotation")).s(lam, rates), omega)
    local = numbers(named("body_rotation"), t=t).s(lam, rates)
    assert equal(rotated(product(lam, t), local), omega)
