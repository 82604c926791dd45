"""Points and spheres in contact with surfaces: statements about the definitions, before anything is differentiated."""

import random
from typing import Any

import mpmath
import pytest
from element_numbers import (
    Vector,
    column,
    cross,
    dot,
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
from mpmath import cos, mpf, sin

SURFACES = ["cylinder", "plane", "v_groove", "round_groove"]
BETA, A, RADIUS = mpf("0.4"), mpf("0.05"), mpf("0.4")
PLACES = {  # of the centre on the surface's triad: on the round bottom of the groove, and on a flank of it
    "cylinder": [[7, mpf("0.3"), mpf("-0.4")]],
    "plane": [[3, -5, mpf("0.04")]],
    "v_groove": [[mpf("0.02"), mpf("0.3"), mpf("0.35")]],
    "round_groove": [[mpf("0.005"), mpf("0.25"), mpf("0.385")], [mpf("0.05"), mpf("0.1"), mpf("0.46")]],
}
CASES = [(name, y) for name in SURFACES for y in PLACES[name]]


def contact(kind: str, name: str, rng: random.Random) -> tuple[Any, dict[str, Any]]:
    """Return a contact and its parameters."""
    values = {"centre": column(rng, 3), "t": unit(column(rng, 4)), "offset": column(rng, 3)}
    values |= {"radius": RADIUS, "sphere_radius": A, "groove_radius": mpf("0.06")}
    values["flank"] = [sin(BETA), cos(BETA)]
    known = {p.name for p in named(f"{kind}_{name}").parameters}
    values = {key: value for key, value in values.items() if key in known}
    return numbers(named(f"{kind}_{name}"), **values), values


def placed(kind: str, values: dict[str, Any], y: Vector, rng: random.Random) -> tuple[Vector, Vector]:
    """Coordinates of a contact whose centre lies at y on the surface's triad, and that centre."""
    body = [*column(rng, 3), *unit(column(rng, 4))]
    centre = plus(body[:3], rotated(product(body[3:], values["t"]), plus(y, values["offset"])))
    if kind == "point":
        return [*centre, *body], centre
    turned = unit(column(rng, 4))
    p = plus(centre, rotated(turned, values["centre"]), -1)
    return [*p, *turned, *body], centre


def moving(x: Vector, spins: list[Vector], velocities: list[Vector]) -> Vector:
    """Rates of coordinates of bodies with angular velocities and velocities of their points."""
    v: Vector = []
    for i, (omega, velocity) in enumerate(zip(spins, velocities, strict=True)):
        lam = x[7 * i + 3 : 7 * i + 7]
        v += [*velocity, *[c / 2 for c in product([0, *omega], lam)]]
    return v


@pytest.mark.parametrize(("name", "y"), CASES)
def test_a_sphere_slides_with_its_material_point_at_the_contact(
    name: str, y: Vector, rng: random.Random
) -> None:
    """Slips are the components, along the surface, of the difference of both bodies' velocities at centre - a n."""
    d, values = contact("sphere", name, rng)
    x, centre = placed("sphere", values, y, rng)
    spins, velocities = [column(rng, 3), column(rng, 3)], [column(rng, 3), column(rng, 3)]
    v = moving(x, spins, velocities)
    unit_motions = [[int(i == j) for i in range(14)] for j in range(3)]
    normals = list(zip(*(rates_of_deformations(d, x, motion) for motion in unit_motions), strict=True))
    directions = list(zip(*(d.s(x, motion) for motion in unit_motions), strict=True))
    assert len(directions) == 2 * len(normals)
    for i, n in enumerate(normals):
        touched = plus(centre, n, -A)
        fields = [
            plus(u, cross(w, plus(touched, x[7 * k : 7 * k + 3], -1)))
            for k, (w, u) in enumerate(zip(spins, velocities, strict=True))
        ]
        sliding = plus(fields[0], fields[1], -1)
        assert equal([rates_of_deformations(d, x, v)[i]], [dot(n, sliding)], mpf(10) ** -25)
        for j in (2 * i, 2 * i + 1):
            t = directions[j]
            assert equal(
                [dot(t, t), dot(t, n), dot(directions[2 * i], directions[2 * i + 1])], [1, 0, 0], 1e-25
            )
            assert equal([d.s(x, v)[j]], [dot(t, sliding)], 1e-25)


@pytest.mark.parametrize(("name", "y"), CASES)
def test_a_point_and_a_sphere_have_the_same_gap(name: str, y: Vector, rng: random.Random) -> None:
    sphere, values = contact("sphere", name, rng)
    x, centre = placed("sphere", values, y, rng)
    known = {p.name for p in named(f"point_{name}").parameters}
    point = numbers(named(f"point_{name}"), **{key: value for key, value in values.items() if key in known})
    assert equal(point.D([*centre, *x[7:]]), sphere.D(x))


@pytest.mark.parametrize(("name", "y"), CASES)
def test_a_sphere_that_turns_with_the_surface_slides_as_a_point(
    name: str, y: Vector, rng: random.Random
) -> None:
    """Without rotation relative to the surface, the velocity is the same all over the sphere."""
    d, values = contact("sphere", name, rng)
    x, centre = placed("sphere", values, y, rng)
    omega, velocities = column(rng, 3), [column(rng, 3), column(rng, 3)]
    v = moving(x, [omega, omega], velocities)
    known = {p.name for p in named(f"point_{name}").parameters}
    point = numbers(named(f"point_{name}"), **{key: value for key, value in values.items() if key in known})
    moved = plus(velocities[0], cross(omega, plus(centre, x[:3], -1)))
    slips, s = point.s([*centre, *x[7:]], [*moved, *v[7:]]), d.s(x, v)
    assert equal([s[0], s[1]], [slips[0], slips[1]])
    assert equal(s[2:], [slips[0], slips[2]] if name == "v_groove" else [])


def test_gap_of_a_sphere_is_the_distance_less_both_radii(rng: random.Random) -> None:
    for name, y, e in (
        ("cylinder", [7, mpf("0.3"), mpf("-0.4")], [mpf("0.05")]),
        ("plane", [3, -5, mpf("0.02")], [mpf("-0.03")]),
        ("round_groove", [mpf("0.003"), 0, mpf("0.456")], [mpf("0.06") - A - mpf("0.005")]),
        ("v_groove", [0, 0, mpf("0.45")], [0, 0]),
    ):
        d, values = contact("sphere", name, rng)
        assert equal(d.D(placed("sphere", values, y, rng)[0]), e)


def test_a_ball_between_flanks_rolls_at_the_height_of_its_contacts(rng: random.Random) -> None:
    """It rolls around a resting sheave where its contacts lie a sin beta below its centre: v = a sin(beta) omega."""
    d, values = contact("sphere", "v_groove", rng)
    values |= {"t": [1, 0, 0, 0], "offset": [0, 0, 0], "centre": [0, 0, 0]}
    d = numbers(named("sphere_v_groove"), **values)
    x = [0, 0, RADIUS + A, *unit(column(rng, 4)), 0, 0, 0, *rotation([1, 0, 0], mpmath.mpf(0))]
    rolling = moving(x, [[mpf(1), 0, 0], [0, 0, 0]], [[0, -A * sin(BETA), 0], [0, 0, 0]])
    assert equal(d.s(x, rolling), [0] * 4)
