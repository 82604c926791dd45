"""Elements in configurations without deformation, and bodies in motion."""

import random
from typing import Any

import mpmath
import pytest
from element_numbers import (
    Vector,
    X,
    Y,
    Z,
    beams,
    column,
    conjugate,
    cross,
    dot,
    equal,
    named,
    numbers,
    plus,
    product,
    rotated,
    rotation,
    straight,
    symmetry,
    unit,
)
from mpmath import mpf

from flexel.derive.declare import (
    Element,
)


@pytest.mark.parametrize(
    "name", ["truss", "bearing", "beam3", "beam", "beam_first_order", "beam_warping", "beam_logarithmic"]
)
def test_straight_element_anywhere_in_space_is_undeformed(name: str, rng: random.Random) -> None:
    element = named(name)
    values, places = straight(rng)
    d = numbers(element, **values)
    x = [c for node in element.nodes for c in places[node.name]]
    assert equal(d.D(symmetry(element, values, rng).moved(element, x)), [0] * d.m)


@pytest.mark.parametrize(
    "name",
    ["planar_truss", "planar_beam", "planar_beam_first_order", "planar_beam_logarithmic", "planar_beam3"],
)
def test_straight_element_anywhere_in_the_plane_is_undeformed(name: str, rng: random.Random) -> None:
    element = named(name)
    values, x = planar_straight(element, rng)
    d = numbers(element, **values)
    assert equal(d.D(symmetry(element, values, rng).moved(element, x)), [0] * d.m)


def planar_straight(element: Element, rng: random.Random) -> tuple[dict[str, Any], Vector]:
    l0, alpha0, alphaq0 = (mpf(rng.uniform(0.5, 1.5)) for _ in range(3))
    values = {"l0": l0, "alpha0": alpha0, "alphaq0": alphaq0, "d0": [l0, 0]}
    places = {"p": [0, 0], "rp": [-alpha0], "q": [l0, 0], "rq": [-alphaq0]}
    return values, [c for node in element.nodes for c in places[node.name]]


def test_hinge_angle_is_the_prescribed_rotation(rng: random.Random) -> None:
    tp, tq, lp = (unit(column(rng, 4)) for _ in range(3))
    d = numbers(named("hinge"), tp=tp, tq=tq)
    for degrees in range(-175, 180, 25):
        angle = mpmath.radians(degrees)
        lq = product(product(product(lp, tp), rotation(X, angle)), conjugate(tq))
        assert equal(d.D([*lp, *lq]), [angle, 0, 0])


def test_hinge_bendings_are_small_rotations_about_y_and_z(rng: random.Random) -> None:
    """The axis of q in the triad of p is (1, -bend2, bend1): turned by bend1 about -y and by -bend2 about z."""
    t = [1, 0, 0, 0]
    d = numbers(named("hinge"), tp=t, tq=t)
    small = mpf(10) ** -12
    assert equal(d.D([*t, *rotation(Y, small)]), [0, -small, 0], small**2)
    assert equal(d.D([*t, *rotation(Z, small)]), [0, 0, -small], small**2)


def test_body_is_a_cloud_of_point_masses(rng: random.Random) -> None:
    masses = [mpf(rng.uniform(0.5, 1)) for _ in range(5)]
    arms = [column(rng, 3) for _ in masses]
    mass = sum(masses)
    centre = [sum(m * a[i] for m, a in zip(masses, arms, strict=True)) / mass for i in range(3)]
    about = [plus(arm, centre, -1) for arm in arms]

    def moment(i: int, j: int) -> Any:
        pairs = zip(masses, about, strict=True)
        return sum(m * ((i == j) * dot(a, a) - a[i] * a[j]) for m, a in pairs)

    tensor = [moment(0, 0), moment(1, 1), moment(2, 2), moment(0, 1), moment(0, 2), moment(1, 2)]
    gravity = column(rng, 3)
    d = numbers(named("body"), mass=mass, c=centre, J=tensor, gravity=gravity)
    x, lam, velocity, omega = column(rng, 3), unit(column(rng, 4)), column(rng, 3), column(rng, 3)
    global_arms = [rotated(lam, arm) for arm in arms]
    speeds = [plus(velocity, cross(omega, arm)) for arm in global_arms]
    T = sum(m * dot(v, v) / 2 for m, v in zip(masses, speeds, strict=True))
    U = -sum(m * dot(gravity, plus(x, arm)) for m, arm in zip(masses, global_arms, strict=True))
    rates = [c / 2 for c in product([0, *omega], lam)]
    assert equal([d.T([*x, *lam], [*velocity, *rates]), d.U([*x, *lam])], [T, U])


@beams
def test_kinetic_energy_of_a_rigidly_moving_beam_is_that_of_a_rod(name: str, rng: random.Random) -> None:
    values, places = straight(rng)
    rhoJ = [abs(c) for c in column(rng, 3)]
    values |= {"rhoA": mpf("1.3"), "rhoJ": rhoJ, "phi_y": mpf("0.4"), "phi_z": mpf("0.7")}
    element, l0 = named(name), values["l0"]
    x = [c for node in element.nodes for c in places[node.name]]
    motion = symmetry(element, values, rng)
    v = motion.rigid_rates(element, x)
    centre, w, mass = (
        plus(motion.velocity, cross(motion.omega, [l0 / 2, 0, 0])),
        motion.omega,
        l0 * mpf("1.3"),
    )
    inertia = [l0 * rhoJ[0], l0 * rhoJ[1] + mass * l0**2 / 12, l0 * rhoJ[2] + mass * l0**2 / 12]
    T = mass * dot(centre, centre) / 2 + sum(j * c**2 for j, c in zip(inertia, w, strict=True)) / 2
    assert equal([numbers(element, **values).T(x, v)], [T])
    weight = numbers(element, **(values | {"gravity": Z})).U(x)
    assert equal([weight], [0])


def test_rigid_beam_moves_like_the_flexible_one_when_rigid(rng: random.Random) -> None:
    values, places = straight(rng)
    values |= {"rhoA": mpf("1.3"), "rhoJ": [mpf("0.1"), mpf("0.2"), mpf("0.3")], "gravity": column(rng, 3)}
    motion = symmetry(named("beam"), values, rng)
    energies = []
    for name in ("beam", "beam3"):
        element = named(name)
        x = motion.moved(element, [c for node in element.nodes for c in places[node.name]])
        d = numbers(element, **{k: v for k, v in values.items() if k in {p.name for p in element.parameters}})
        energies.append([d.T(x, motion.rigid_rates(element, x)), d.U(x)])
    assert equal(*energies)
