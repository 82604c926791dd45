"""Beams: second order, symmetry, energy of a rod, rotary inertia."""

import random
from collections.abc import Callable, Sequence
from typing import Any

import pytest
import sympy as sp
from element_numbers import (
    Vector,
    X,
    beams,
    column,
    cross,
    equal,
    named,
    numbers,
    planar_beams,
    plus,
    product,
    rotated,
    sheared,
    straight,
    unit,
)
from mpmath import mpf

from flexel.derive.declare.shape import rotary_gram


def test_second_order_terms_are_of_second_order(rng: random.Random) -> None:
    values, places = straight(rng)
    small = mpf(10) ** -8
    x = [c for name in ("p", "rp", "q", "rq") for c in places[name]]
    x = plus(x, column(rng, 14), small)
    first, second = (numbers(named(name), **values).D(x) for name in ("beam_first_order", "beam"))
    assert max(abs(e) for e in first) > small / 10
    assert equal(first, second, 10 * small**2)
    assert not equal(first, second, small**2 / 1000)


def bent(rng: random.Random, size: Any) -> tuple[dict[str, Any], Vector]:
    values, places = straight(rng)
    x = [c for name in ("p", "rp", "q", "rq") for c in places[name]]
    x = plus(x, column(rng, 14), size)
    return values, [*x[:3], *unit(x[3:7]), *x[7:10], *unit(x[10:])]


@beams
def test_beam_read_from_the_other_end_is_the_same_beam(name: str, rng: random.Random) -> None:
    """Exchange p and q and turn both triads half a turn about e_z: bending modes exchange, the rest stays."""
    values, x = bent(rng, mpf("0.2"))
    values |= {
        "rhoA": 1,
        "rhoJ": [mpf("0.1"), mpf("0.2"), mpf("0.3")],
        **sheared(values["l0"], mpf("0.4")),
        "gravity": column(rng, 3),
    }
    half = [0, 0, 0, 1]
    turned = values | {"tp": product(values["tq"], half), "tq": product(values["tp"], half)}
    v, exchange = column(rng, 14), lambda x: [*x[7:], *x[:7]]
    there, back = numbers(named(name), **values), numbers(named(name), **turned)
    e1, e2, e3, e4, e5, e6 = there.D(x)
    assert equal(back.D(exchange(x)), [e1, e2, e4, e3, -e6, -e5])
    assert equal([back.T(exchange(x), exchange(v))], [there.T(x, v)])
    assert equal([back.U(exchange(x))], [there.U(x)])


def test_elongation_of_a_bent_beam_is_the_change_of_its_arc_length(rng: random.Random) -> None:
    """End slopes a, b from the chord: the cubic between them is longer than the chord by l (2a²-ab+2b²)/30."""
    a, b = mpf(10) ** -6, mpf(-2) * mpf(10) ** -6
    length = 1 - (2 * a**2 - a * b + 2 * b**2) / 30
    d = numbers(named("planar_beam"), l0=1)
    assert abs(d.D([0, 0, a, length, 0, b])[0]) < mpf(10) ** -22
    assert equal(d.D([0, 0, a, length, 0, b])[1:], [-a, b], mpf(10) ** -17)


def rod(
    curvature: Callable[[Any], Vector], steps: int = 40, stretch: Sequence[Any] = (0, 0, 0)
) -> tuple[Vector, Vector]:
    """Return the end of a rod of length 1 from the origin along x: position and quaternion (RK4).

    `curvature` gives twist and curvatures at a place from 0 to 1; `stretch` are uniform stretch and shears.
    """
    along = plus(X, stretch)

    def slope(s: Any, y: Vector) -> Vector:
        turning = [c / 2 for c in product(y[3:], [0, *curvature(s)])]
        return [*rotated(y[3:], along), *turning]

    y, h = [mpf(c) for c in (0, 0, 0, 1, 0, 0, 0)], mpf(1) / steps
    for i in range(steps):
        k1 = slope(i * h, y)
        k2 = slope((i + mpf("0.5")) * h, plus(y, k1, h / 2))
        k3 = slope((i + mpf("0.5")) * h, plus(y, k2, h / 2))
        k4 = slope((i + 1) * h, plus(y, k3, h))
        y = [c + h / 6 * (a + 2 * b + 2 * d + e) for c, a, b, d, e in zip(y, k1, k2, k3, k4, strict=True)]
    return y[:3], unit(y[3:])


@pytest.mark.parametrize(("name", "order"), [("beam", 4), ("beam_first_order", 3)])
def test_energy_of_a_bent_and_twisted_beam_is_that_of_the_rod(
    name: str, order: int, rng: random.Random
) -> None:
    """With bending moments linear along the rod and a constant torque it is in equilibrium to first order.

    The energies then agree to third order in the deformation, for any stiffness; without the second-order
    terms of the deformations to second order only.
    """
    small, GJ, EIy, EIz = mpf("1e-3"), mpf(2), mpf(3), mpf(5)
    torsion, y0, y1, z0, z1 = column(rng, 5)

    def curvature(s: Any) -> Vector:
        return [small * torsion, small * (y0 + y1 * (2 * s - 1)), small * (z0 + z1 * (2 * s - 1))]

    exact = (GJ * torsion**2 + EIy * (y0**2 + y1**2 / 3) + EIz * (z0**2 + z1**2 / 3)) / 2
    end, turned = rod(curvature)
    still = [1, 0, 0, 0]
    d = numbers(named(name), l0=1, tp=still, tq=still)
    e1, e2, e3, e4, e5, e6 = d.D([0, 0, 0, *still, *end, *turned])
    energy = e1**2 + GJ * e2**2
    energy += EIy * 4 * (e3**2 - e3 * e4 + e4**2) + EIz * 4 * (e5**2 - e5 * e6 + e6**2)
    error = abs(energy / 2 / small**2 - exact)
    assert error < 10 * small ** (order - 2)
    assert (error < small / 100) == (abs(e1) < 10 * small**3) == (order == 4)


def test_rotary_inertia_is_przemienieckis_for_stiff_shear_and_linear_for_soft_shear() -> None:
    """Without shear: (36, 3 l, 4 l², -l²)/30 in terms of deflections; with soft shear: a rod's (2, 1)/6."""
    P, r = sp.Symbol("P"), sp.Rational
    gram = sp.Matrix(rotary_gram())
    stiff = sp.Matrix(
        [[r(6, 5), -r(1, 10), -r(1, 10)], [-r(1, 10), r(2, 15), -r(1, 30)], [-r(1, 10), -r(1, 30), r(2, 15)]]
    )
    assert gram.subs(P, 0) == stiff
    assert (gram / P**2).applyfunc(lambda g: sp.limit(g, P, sp.oo)) == sp.Matrix(
        [[0, 0, 0], [0, 2, 1], [0, 1, 2]]
    ) / 6


@planar_beams
def test_rotary_energy_of_a_stretched_planar_beam_that_spins_does_not_depend_on_the_stretch(
    name: str,
) -> None:
    """All sections turn with the rate w, whatever their distance: T = rhoJ l0 w²/2 (closed form)."""
    l0, rho_j, w = mpf("0.7"), mpf("0.3"), mpf("1.9")
    d = numbers(named(name), l0=l0, rhoJ=rho_j, **sheared(l0, mpf("0.4")))
    for stretch in (mpf("-0.2"), mpf(0), mpf("0.5")):
        length = l0 * (1 + stretch)
        T = d.T([0, 0, 0, length, 0, 0], [0, 0, w, 0, length * w, w])
        assert equal([T], [rho_j * l0 * w**2 / 2])


@pytest.mark.parametrize("name", ["beam", "beam_first_order", "beam_warping"])
def test_rotary_energy_of_a_stretched_beam_that_spins_does_not_depend_on_the_stretch(name: str) -> None:
    """Rates w about all axes of the section: T = l0 w·rhoJ w/2 (closed form)."""
    l0, rho_j, w = mpf("0.7"), [mpf("0.1"), mpf("0.2"), mpf("0.3")], [mpf("1.9"), mpf("0.8"), mpf("-1.1")]
    still = [1, 0, 0, 0]
    d = numbers(named(name), l0=l0, tp=still, tq=still, rhoJ=rho_j, **sheared(l0, mpf("0.4"), mpf("0.9")))
    turning = [0, *(c / 2 for c in w)]
    for stretch in (mpf("-0.2"), mpf(0), mpf("0.5")):
        end = [l0 * (1 + stretch), 0, 0]
        warping = [0, 0] if name == "beam_warping" else []
        T = d.T(
            [0, 0, 0, *still, *end, *still, *warping], [0, 0, 0, *turning, *cross(w, end), *turning, *warping]
        )
        assert equal([T], [l0 * sum(j * c**2 for j, c in zip(rho_j, w, strict=True)) / 2])
