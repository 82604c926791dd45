"""The beam with warping: its energy is that of a rod with Vlasov's torsion, to third order; its limits."""

import random
from typing import Any

from element_numbers import Vector, column, dot, equal, named, numbers, plus, product, sheared, straight, unit
from mpmath import mpf
from test_beam_definitions import rod

STILL = [1, 0, 0, 0]


def deformed(rng: random.Random, size: Any) -> tuple[dict[str, Any], Vector]:
    values, places = straight(rng)
    x = plus([c for name in ("p", "rp", "q", "rq", "wp", "wq") for c in places[name]], column(rng, 16), size)
    return values, [*x[:3], *unit(x[3:7]), *x[7:10], *unit(x[10:14]), *x[14:]]


def energy_of(e: Vector, GJ: Any, EIy: Any, EIz: Any, EIw: Any) -> Any:
    """Energy of a beam of length one and EA = 1, and the deformations' stiffness as the page of warping has it."""
    e1, e2, e3, e4, e5, e6, e7, e8 = e
    energy = e1**2 + GJ * (e2**2 + (2 * e7**2 - e7 * e8 + 2 * e8**2) / 15)
    energy += 4 * (EIy * (e3**2 - e3 * e4 + e4**2) + EIz * (e5**2 - e5 * e6 + e6**2))
    return (energy + 4 * EIw * (e7**2 + e7 * e8 + e8**2)) / 2


def test_energy_of_an_unevenly_twisted_and_bent_beam_is_that_of_the_rod(rng: random.Random) -> None:
    """Twist quadratic along the rod, curvatures linear: the energies agree to third order, for any stiffness."""
    small, GJ, EIy, EIz, EIw = mpf("1e-3"), mpf(2), mpf(3), mpf(5), mpf("0.7")
    t0, t1, t2, y0, y1, z0, z1 = column(rng, 7)

    def twist(s: Any) -> Any:
        return t0 + t1 * (2 * s - 1) + t2 * (2 * s - 1) ** 2

    def curvature(s: Any) -> Vector:
        return [small * component for component in (twist(s), y0 + y1 * (2 * s - 1), z0 + z1 * (2 * s - 1))]

    exact = GJ * (t0**2 + t1**2 / 3 + t2**2 / 5 + 2 * t0 * t2 / 3) + EIw * 4 * (t1**2 + 4 * t2**2 / 3)
    exact = (exact + EIy * (y0**2 + y1**2 / 3) + EIz * (z0**2 + z1**2 / 3)) / 2
    end, turned = rod(curvature)
    d = numbers(named("beam_warping"), l0=1, tp=STILL, tq=STILL)
    x = [0, 0, 0, *STILL, *end, *turned, small * twist(0), small * twist(1)]
    e = d.D(x)
    assert abs(energy_of(e, GJ, EIy, EIz, EIw) / small**2 - exact) < 10 * small**2
    assert abs(e[0]) < 10 * small**3


def test_twist_shortens_the_beam_by_the_mean_stretch_of_its_fibres(rng: random.Random) -> None:
    """Wagner: the elongation of a straight twisted beam is the integral of Ip/A times half the twist's square."""
    polar, small = mpf("0.3"), mpf("1e-8")
    t0, t1, t2 = (small * number for number in column(rng, 3))
    _, turned = rod(lambda s: [t0 + t1 * (2 * s - 1) + t2 * (2 * s - 1) ** 2, 0, 0])
    d = numbers(named("beam_warping"), l0=1, tp=STILL, tq=STILL, EIy=polar, EA=mpf(1))
    e = d.D([0, 0, 0, *STILL, 1, 0, 0, *turned, t0 - t1 + t2, t0 + t1 + t2])
    squares = t0**2 + t1**2 / 3 + t2**2 / 5 + 2 * t0 * t2 / 3
    assert abs(e[0] - polar / 2 * squares) < 1e-6 * polar * squares


def test_uniform_twist_gives_the_deformations_and_the_energy_of_the_plain_beam(rng: random.Random) -> None:
    """Both warping coordinates at the mean twist: warp1 = warp2 = 0, the first six deformations are the beam's."""
    values, x = deformed(rng, mpf("0.3"))
    l0 = values["l0"]
    plain, warping = numbers(named("beam"), **values), numbers(named("beam_warping"), **values)
    e = plain.D(x[:14])
    first = numbers(named("beam_first_order"), **values).D(x[:14])
    assert equal(warping.D([*x[:14], first[1] / l0**2, first[1] / l0**2])[:6], e)
    assert equal(warping.D([*x[:14], e[1] / l0**2, e[1] / l0**2])[6:], [0, 0])


def test_beam_read_from_the_other_end_is_the_same_beam(rng: random.Random) -> None:
    values, x = deformed(rng, mpf("0.2"))
    values |= {
        "rhoA": 1,
        "rhoJ": [mpf("0.1"), mpf("0.2"), mpf("0.3")],
        "rhoIw": mpf("0.6"),
        "EA": mpf("0.2"),
    }
    values |= {**sheared(values["l0"], mpf("0.4")), "gravity": column(rng, 3)}
    half = [0, 0, 0, 1]
    turned = values | {"tp": product(values["tq"], half), "tq": product(values["tp"], half)}
    v = column(rng, 16)
    there, back = (numbers(named("beam_warping"), **given) for given in (values, turned))

    def exchange(x: Vector) -> Vector:
        return [*x[7:14], *x[:7], x[15], x[14]]

    e1, e2, e3, e4, e5, e6, e7, e8 = there.D(x)
    assert equal(back.D(exchange(x)), [e1, e2, e4, e3, -e6, -e5, e8, e7])
    assert equal([back.T(exchange(x), exchange(v))], [there.T(x, v)])
    assert equal([back.U(exchange(x))], [there.U(x)])


def test_kinetic_energy_of_a_straight_twisting_beam_is_that_of_its_sections(rng: random.Random) -> None:
    """Angular velocity a cubic c(s): T is the integral of rhoJ c^2/2 + rhoIw c'^2/2."""
    rho_j, rho_iw = mpf("0.3"), mpf("0.4")
    c = column(rng, 4)
    d = numbers(named("beam_warping"), l0=1, tp=STILL, tq=STILL, rhoJ=[rho_j, 0, 0], rhoIw=rho_iw)
    slope = [c[1], 2 * c[2], 3 * c[3]]
    ends = c[0], sum(c)
    v = [0, 0, 0, 0, ends[0] / 2, 0, 0, 0, 0, 0, 0, ends[1] / 2, 0, 0, slope[0], sum(slope)]
    x = [0, 0, 0, *STILL, 1, 0, 0, *STILL, 0, 0]

    def mean_square(p: Vector) -> Any:
        return sum(a * dot(p, [mpf(1) / (i + j + 1) for j in range(len(p))]) for i, a in enumerate(p))

    assert abs(d.T(x, v) - (rho_j * mean_square(c) + rho_iw * mean_square(slope)) / 2) < mpf(10) ** -30
