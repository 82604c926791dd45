"""Beams with logarithmic rotations: uniform strains without error, the energy of a rod with shear."""

import random
from typing import Any

import mpmath
import pytest
from element_numbers import (
    Vector,
    X,
    column,
    cross,
    equal,
    named,
    numbers,
    plus,
    rotation,
    sheared,
    unit,
)
from mpmath import mpf
from test_beam_definitions import rod

STILL = [1, 0, 0, 0]
PHI_Y, PHI_Z = mpf("0.4"), mpf("0.7")


def helix(turn: Vector) -> tuple[Vector, Vector]:
    """End of an unstretched rod of length 1 with the uniform curvature `turn`: position and quaternion."""
    angle = mpmath.sqrt(sum(c**2 for c in turn))
    axis = [c / angle for c in turn]
    along = [axis[0] * c for c in axis]
    place = plus(along, plus(X, along, -1), mpmath.sin(angle) / angle)
    return plus(place, cross(axis, X), (1 - mpmath.cos(angle)) / angle), rotation(axis, angle)


@pytest.mark.parametrize(("degrees", "error"), [(30, "1e-9"), (90, "1e-6"), (170, "1e-4")])
@pytest.mark.parametrize("sign", [1, -1])
def test_uniformly_bent_and_twisted_beam_has_the_strains_of_the_helix(
    degrees: int, error: str, sign: int, rng: random.Random
) -> None:
    """Torsion and bending are the angles themselves, for both signs of a quaternion; the length is a short series."""
    turn = [mpmath.radians(degrees) * c for c in unit(column(rng, 3))]
    place, turned = helix(turn)
    d = numbers(named("beam_logarithmic"), l0=1, tp=STILL, tq=STILL, **sheared(1, PHI_Y, PHI_Z))
    found = d.D([0, 0, 0, *STILL, *place, *(sign * c for c in turned)])
    tx, ty, tz = turn
    assert equal(found, [0, tx, ty / 2, ty / 2, tz / 2, tz / 2], mpf(error))


@pytest.mark.parametrize("degrees", [1, 45, 90, 179])
def test_torsion_is_the_angle_of_twist(degrees: int) -> None:
    angle = mpmath.radians(degrees)
    d = numbers(named("beam_logarithmic"), l0=2, tp=STILL, tq=STILL)
    e = d.D([0, 0, 0, *STILL, 2, 0, 0, *rotation(X, angle)])
    assert equal(e, [0, 2 * angle, 0, 0, 0, 0], mpf("1e-17"))


@pytest.mark.parametrize("degrees", [45, 180, -90])
def test_planar_beam_bent_to_an_arc_is_not_stretched(degrees: int) -> None:
    """But for the first term that its series for the length of the arc leaves out."""
    angle = mpmath.radians(degrees)
    place = [mpmath.sin(angle) / angle, (1 - mpmath.cos(angle)) / angle]
    d = numbers(named("planar_beam_logarithmic"), l0=1, **sheared(1, PHI_Z))
    assert equal(d.D([0, 0, 0, *place, angle]), [0, angle / 2, angle / 2], angle**8 / 92e6)


@pytest.mark.parametrize("shears_too", [True, False])
def test_energy_of_a_stretched_sheared_bent_and_twisted_beam_is_that_of_the_rod(
    shears_too: bool, rng: random.Random
) -> None:
    """A rod with linear bending moments, constant forces and torque is in equilibrium to first order.

    Its energy is then that of the beam to third order in the deformation.  The classic beam is so without shear only.
    """
    small, EA, GJ, EIy, EIz = mpf("1e-3"), mpf(7), mpf(2), mpf(3), mpf(5)
    phi_y, phi_z = (PHI_Y, PHI_Z) if shears_too else (mpf(0), mpf(0))
    stretch, torsion, y0, y1, z0, z1 = column(rng, 6)
    shears = (
        -phi_y * z1 / 6,
        phi_z * y1 / 6,
    )  # moment balance: M_z' = -V_y, M_y' = V_z, V = 12 E I/(phi l0^2) shear

    def curvature(s: Any) -> Vector:
        return [small * c for c in (torsion, y0 + y1 * (2 * s - 1), z0 + z1 * (2 * s - 1))]

    exact = EA * stretch**2 + GJ * torsion**2
    for EI, phi, shear, even, odd in ((EIz, phi_y, shears[0], z0, z1), (EIy, phi_z, shears[1], y0, y1)):
        exact += EI * (even**2 + odd**2 / 3) + (12 * EI / phi * shear**2 if shears_too else 0)
    end, turned = rod(curvature, stretch=[small * c for c in (stretch, *shears)])
    d = numbers(named("beam_logarithmic"), l0=1, tp=STILL, tq=STILL, **sheared(1, phi_y, phi_z))
    e1, e2, *bends = d.D([0, 0, 0, *STILL, *end, *turned])
    energy = EA * e1**2 + GJ * e2**2
    for EI, phi, a, b in ((EIy, phi_z, *bends[:2]), (EIz, phi_y, *bends[2:])):
        energy += EI / (1 + phi) * ((4 + phi) * (a**2 + b**2) - 2 * (2 - phi) * a * b)
    error = abs(energy - small**2 * exact)
    assert error < 100 * small**4
    assert error < small**3 / 10
