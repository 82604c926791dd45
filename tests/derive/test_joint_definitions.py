"""Skates and cams: statements about the definitions, before anything is differentiated."""

import random

from element_numbers import (
    X,
    Y,
    Z,
    column,
    cross,
    dot,
    equal,
    named,
    numbers,
    plus,
    product,
    rotated,
    rotation,
    unit,
)
from mpmath import cos, mpf, pi, sin

PIECES = 48
SMALL = mpf(10) ** -20


def test_a_skate_slips_across_its_blade_alone(rng: random.Random) -> None:
    """On a tilted plane, leaning and pitching: the slips are the parts of the velocity in the plane."""
    ice, body = unit(column(rng, 4)), column(rng, 3)
    n = rotated(ice, Z)
    heading = product(
        ice, product(rotation(Z, mpf("0.6")), product(rotation(Y, mpf("0.2")), rotation(X, mpf("0.4"))))
    )
    d = numbers(named("skate"), blade=X, normal=n, height=dot(n, body))
    b = rotated(heading, X)
    ahead = unit(plus(b, [dot(b, n) * component for component in n], -1))
    across = cross(n, ahead)
    x = [*body, *heading]
    assert equal(d.D(x), [0])
    for velocity, slips in ((ahead, [1, 0]), (across, [0, 1]), (n, [0, 0])):
        assert equal(d.s(x, [*velocity, *column(rng, 4)]), slips)


def test_a_planar_skate_is_the_spatial_one_upright(rng: random.Random) -> None:
    turn, alpha0 = (mpf(rng.uniform(-2, 2)) for _ in range(2))
    flat = numbers(named("planar_skate"), alpha0=alpha0)
    tall = numbers(named("skate"), blade=[cos(alpha0), sin(alpha0), mpf(0)], normal=Z, height=0)
    v = column(rng, 3)
    planar = flat.s([mpf(0), mpf(0), turn], [v[0], v[1], mpf(1)])
    assert equal(planar, tall.s([mpf(0)] * 3 + rotation(Z, turn), [*v, *column(rng, 4)]))


def test_a_cam_with_equal_control_values_is_round(rng: random.Random) -> None:
    for name in ("roller_cam", "planar_roller_cam"):
        d = numbers(named(name), control=[mpf("0.3")] * PIECES, tp=[1, 0, 0, 0])
        for _ in range(20):
            a = mpf(rng.uniform(-3.14, 3.14))
            place = [mpf("0.7") * cos(a), mpf("0.7") * sin(a)]
            x = [0, 0, 0, 1, 0, 0, 0, *place, mpf("0.2")] if name == "roller_cam" else [0, 0, 0, *place]
            assert equal(d.D([mpf(number) for number in x]), [mpf("0.4")])


def test_the_outline_of_a_cam_is_smooth_at_all_its_knots(rng: random.Random) -> None:
    """Fourth differences do not jump across a knot, nor the outline across the cut of the angle."""
    d = numbers(named("planar_roller_cam"), control=[mpf(rng.uniform(0.2, 0.4)) for _ in range(PIECES)])
    h = mpf(10) ** -4

    def outline(a: mpf) -> mpf:
        return 1 - d.D([mpf(0), mpf(0), mpf(0), cos(a), sin(a)])[0]

    def fourth(a: mpf) -> mpf:
        values = [outline(a + (k - 2) * h) for k in range(5)]
        return sum(c * v for c, v in zip((1, -4, 6, -4, 1), values, strict=True)) / h**4

    size = max(abs(fourth(2 * pi / PIECES * (i + mpf("0.5")))) for i in range(PIECES))
    for i in range(PIECES):
        knot = 2 * pi / PIECES * i
        assert (
            abs(fourth(knot + 4 * h) - fourth(knot - 4 * h)) < mpf("0.05") * size
        )  # a jump would be as large as size
    assert abs(outline(pi - SMALL) - outline(-pi + SMALL)) < mpf(10) ** -18


def test_the_plane_of_a_cam_may_lie_anywhere(rng: random.Random) -> None:
    """In space it is the planar cam in the plane of its triad, whatever the distance from that plane."""
    control = [mpf(rng.uniform(0.2, 0.4)) for _ in range(PIECES)]
    triad, frame = unit(column(rng, 4)), unit(column(rng, 4))
    tall = numbers(named("roller_cam"), control=control, tp=triad)
    flat = numbers(named("planar_roller_cam"), control=control)
    p, (a, b, c) = column(rng, 3), column(rng, 3)
    q = plus(p, rotated(product(frame, triad), [a, b, c]))
    assert equal(tall.D([*p, *frame, *q]), flat.D([mpf(0), mpf(0), mpf(0), a, b]))


def test_a_round_cam_under_a_face_is_at_its_radius_in_every_direction(rng: random.Random) -> None:
    """The face cuts the plane of the cam in a line; a gap between line and cam is measured across the face."""
    d = numbers(named("flat_cam"), control=[mpf("0.3")] * PIECES, tp=[1, 0, 0, 0], tq=[1, 0, 0, 0])
    for _ in range(20):
        turn, lean = mpf(rng.uniform(-3.14, 3.14)), mpf(rng.uniform(-1, 1))
        frame = product(rotation(Z, turn), rotation(Y, -lean))
        n, flat = rotated(frame, X), [cos(turn), sin(turn), mpf(0)]
        on_line = plus(
            [mpf("0.7") * component for component in flat], [-sin(turn), cos(turn), mpf(0)], mpf("0.2")
        )
        up = plus(Z, n, -n[2])
        q = plus(on_line, up, mpf("0.4"))  # another point of the face
        assert equal(
            d.D([mpf(0)] * 3 + [mpf(1), mpf(0), mpf(0), mpf(0)] + q + frame), [mpf("0.4") * cos(lean)]
        )
