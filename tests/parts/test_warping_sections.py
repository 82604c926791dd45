"""Warping constants and shear centres of sections: closed forms, limits and a finite-difference solution."""

import numpy as np
import pytest

import flexel as fx
from flexel.model.profiles import SectionForces


def test_a_thin_rectangle_has_the_textbook_warping_constant_and_a_square_nearly_none() -> None:
    thin = fx.Rectangle(1.0, 1e-3)
    assert thin.Iw == pytest.approx(1e-9 / 144, rel=1e-5)
    assert thin.largest_warping() == pytest.approx(1e-3 / 4, rel=2e-3)
    assert fx.Rectangle(1.0, 1.0).Iw == pytest.approx(1.34e-4, rel=5e-3)  # tabulated, a^6
    assert fx.Rectangle(1.0, 0.3).Iw == fx.Rectangle(0.3, 1.0).Iw


@pytest.mark.parametrize("width", [1.0, 0.4])
def test_the_warping_of_a_rectangle_solves_its_boundary_value_problem(width: float) -> None:
    """Laplace's equation by cell-centred differences with the flux of Saint-Venant's problem on the edges."""
    section = fx.Rectangle(1.0, width)

    def solved(n: int) -> tuple[float, float]:
        from scipy.sparse import diags_array as diags
        from scipy.sparse import eye, kron
        from scipy.sparse.linalg import spsolve

        hy, hz = 1.0 / n, width / n
        y, z = (np.arange(n) + 0.5) * hy - 0.5, (np.arange(n) + 0.5) * hz - width / 2
        one = np.ones(n)
        second = diags([one[1:], -np.r_[1.0, 2 * one[2:], 1.0], one[1:]], offsets=[-1, 0, 1])
        A = kron(second / hy**2, eye(n)) + kron(eye(n), second / hz**2)
        edge = np.zeros(n)
        edge[[0, -1]] = -1.0, 1.0
        right = -(np.outer(edge / hy, z) - np.outer(y, edge / hz))
        w = spsolve((A - 1e-9 * eye(n * n)).tocsc(), right.ravel())
        return float(np.sum(w**2) * hy * hz), float(np.max(np.abs(w)))

    coarse, fine = solved(40), solved(80)
    assert section.Iw == pytest.approx(fine[0] + (fine[0] - coarse[0]) / 3, rel=2e-3)
    assert section.largest_warping() == pytest.approx(2 * fine[1] - coarse[1], rel=1e-2)


def test_a_thin_walled_i_is_a_limit_of_open_profiles() -> None:
    """Two flanges that bend in opposite directions: EIw = EI of a flange times h²/2."""
    i = fx.IBeam(0.2, 0.1, flange=0.01, web=0.007)
    assert i.Iw == pytest.approx(0.01 * 0.1**3 / 12 * 0.19**2 / 2)
    flange = i.stresses(SectionForces(B=1.0))[0].normal
    assert flange == pytest.approx((1 / 0.19) / (0.01 * 0.1**2 / 6))


def test_a_rectangular_hollow_section_is_as_in_closed_form() -> None:
    b, h, tf, tw = 0.05, 0.1, 0.004, 0.002
    box = fx.ClosedProfile([(0, 0), (h, 0), (h, b), (0, b)], [tw, tf, tw, tf])
    corner = b * h / 4 * (b / tf - h / tw) / (b / tf + h / tw)
    assert [box.A, box.J, box.Iw] == pytest.approx(
        [2 * (b * tf + h * tw), 2 * (b * h) ** 2 / (b / tf + h / tw), corner**2 / 3 * 2 * (b * tf + h * tw)]
    )
    assert box.Iz == pytest.approx(2 * tw * h**3 / 12 + 2 * b * tf * (h / 2) ** 2)
    assert box.Iy == pytest.approx(2 * tf * b**3 / 12 + 2 * h * tw * (b / 2) ** 2)
    assert box.shear_centre == pytest.approx((0.0, 0.0), abs=1e-12)
    assert box.stresses(SectionForces(B=1.0))[0].normal == pytest.approx(abs(corner) / box.Iw)


def test_a_round_tube_of_many_walls_does_not_warp() -> None:
    a = np.arange(60) * 2 * np.pi / 60
    tube = fx.ClosedProfile(0.05 * np.column_stack([np.cos(a), np.sin(a)]), 0.001)
    assert tube.Iw == 0.0
    assert pytest.approx(2 * np.pi * 0.05**3 * 0.001, rel=1e-2) == tube.J


def test_a_u_section_is_the_closed_profile_whose_fourth_wall_vanishes() -> None:
    """The closing wall carries no shear flow when it is very thin; middle lines of 0.1 by 0.2."""
    closed = fx.ClosedProfile([(-0.1, 0), (-0.1, 0.1), (0.1, 0.1), (0.1, 0)], [0.01, 1e-12, 0.01, 0.008])
    u = fx.UBeam(0.21, 0.104, flange=0.01, web=0.008)
    assert u.Iw == pytest.approx(closed.Iw, rel=1e-8)
    web = closed.outline[0, 1]
    middle = u.web / 2 + u.outline[:, 1].min()
    assert u.shear_centre[1] - middle == pytest.approx(closed.shear_centre[1] - web, rel=1e-6)
    assert u.shear_centre[0] == 0.0


def test_u_and_l_sections_have_the_areas_and_moments_of_their_outlines() -> None:
    def integrals(corners: np.ndarray) -> tuple[float, ...]:
        (y, z), (y1, z1) = corners.T, np.roll(corners, -1, axis=0).T
        c = y * z1 - y1 * z
        sign = np.sign(c.sum())
        yy, zz = ((a * a + a * b + b * b) @ c * sign / 12 for a, b in ((y, y1), (z, z1)))
        yz = (2 * y * z + y * z1 + y1 * z + 2 * y1 * z1) @ c * sign / 24
        return abs(c.sum()) / 2, (y + y1) @ c, (z + z1) @ c, zz, yy, yz

    for section in (fx.UBeam(0.2, 0.1, 0.01, 0.008), fx.LBeam(0.15, 0.1, 0.01), fx.LBeam(0.05, 0.12, 0.01)):
        A, y, z, iy, iz, yz = integrals(section.outline)
        assert [section.A, section.Iy, section.Iz] == pytest.approx([A, iy, iz])
        assert [y, z] == pytest.approx([0, 0], abs=1e-12)
        assert abs(yz) < 1e-12 * iz


def test_an_angle_150_100_10_is_as_tabulated() -> None:
    """EN 10056: A 24.2 cm², Iu 637 cm⁴, Iv 112 cm⁴, tan 0.438, with fillets."""
    section = fx.LBeam(0.15, 0.1, 0.01)
    assert pytest.approx(24.2e-4, rel=0.01) == section.A
    assert [section.Iz, section.Iy] == pytest.approx([637e-8, 112e-8], rel=0.03)
    assert abs(np.tan(section.angle)) == pytest.approx(0.438, rel=0.02)
    assert sum(section.shear_factors(0.3)) == pytest.approx(5 / 6)
    assert section.shear_factors(0.3)[0] == pytest.approx(0.475, abs=1e-3)  # mostly the long leg
    assert section.stresses(SectionForces(N=2.42e5))[0].normal == pytest.approx(1e8, rel=0.01)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: fx.UBeam(0.1, 0.05, flange=0.05, web=0.01), "UBeam: flanges of 0.05"),
        (lambda: fx.UBeam(0.1, 0.05, flange=0.0, web=0.01), "UBeam: flange 0 is not positive"),
        (lambda: fx.LBeam(0.1, 0.05, 0.05), "LBeam: a thickness of 0.05 does not fit"),
        (lambda: fx.ClosedProfile([(0, 0), (1, 0)], 0.1), "give three or more pairs"),
        (lambda: fx.ClosedProfile([(0, 0), (1, 0), (1, 1)], [0.1, 0.1]), "one for each of the 3 walls"),
        (lambda: fx.ClosedProfile([(0, 0), (1, 0), (2, 0)], 0.1), "its walls enclose no area"),
        (lambda: fx.ClosedProfile([(0, 0), (1, 0), (1, 0), (0, 1)], 0.1), "enclose no area"),
        (lambda: fx.ClosedProfile([(0, 0), (1, 0), (1, 1)], -0.1), "not one positive number"),
    ],
)
def test_impossible_sections_are_named(make: object, message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        make()  # type: ignore[operator]


def test_a_turned_profile_is_refused_with_the_angle_that_helps() -> None:
    corners = np.array([(0.0, 0.0), (1.0, 1.0), (0.5, 2.0)])
    with pytest.raises(fx.ModelError, match="turn the corners about x by") as error:
        fx.ClosedProfile(corners, 0.1)
    angle = np.radians(float(str(error.value).split(" by ")[1].split()[0]))
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    with pytest.raises(fx.ModelError) as again:  # the angle is printed with six digits
        fx.ClosedProfile(corners @ turn.T, 0.1)
    assert abs(float(str(again.value).split(" by ")[1].split()[0])) < 1e-4
