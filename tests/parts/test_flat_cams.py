"""Cams under a flat face, against the closed form of an eccentric disc: its support function is R + e cos ψ."""

import numpy as np
import pytest
from differences import numerical_matrices, worst

import flexel as fx

R, E = 0.05, 0.02  # radius of the disc and how far its centre is off [m]
OFF = 0.013  # of the point by which the face is given, along the face


def disc(angle: float) -> float:
    """Distance of the tangent with this normal from the axis."""
    return float(R + E * np.cos(angle))


def tappet(planar: bool, outline: object = disc) -> fx.Model:
    """A cam, and above it a flat follower that slides along y."""
    third = () if planar else (0.0,)
    m = fx.Model()
    m.rigid_body("cam", (0, 0, *third), mass=1.0, inertia=0.01 if planar else (0.01, 0.01, 0.01))
    m.rigid_body("follower", (0, 0.2, *third), mass=0.5, inertia=0.01 if planar else (0.01, 0.01, 0.01))
    m.revolute("shaft", "ground", "cam", at=(0, 0, *third), axis=None if planar else (0, 0, 1))
    m.prismatic("guide", "ground", "follower", axis=(0, 1, *third))
    m.cam(
        "lobe",
        "cam",
        "follower",
        (OFF, R, *third),
        outline,  # type: ignore[arg-type]
        axis=None if planar else (0, 0, 1),
        start=(1, 0, *third),
        face=(0, 1, *third),
    )
    return m


@pytest.mark.parametrize("planar", [True, False])
def test_a_flat_follower_on_an_eccentric_disc_moves_harmonically(planar: bool) -> None:
    m, lift = tappet(planar), "guide.along" if planar else "guide.axial"
    assert m.build().counts["degrees_of_freedom"] == 1
    m.prescribe("shaft.angle", lambda t: -2.0 * t)  # the normal's angle in the cam is π/2 + 2 t
    motion = m.build().simulate(np.pi, samples=25)  # at the knots of the spline
    expected = E * np.cos(np.pi / 2 + 2.0 * motion.t)
    assert motion[lift] == pytest.approx(expected, abs=1e-12)
    assert motion.rate(lift) == pytest.approx(-2.0 * E * np.sin(np.pi / 2 + 2.0 * motion.t), abs=1e-8)
    # the stress of the gap is the pull on the follower
    assert motion.force("lobe.gap") == pytest.approx(-0.5 * motion.acceleration(lift), abs=1e-12)


def test_the_point_by_which_the_face_is_given_does_not_matter_and_its_tilt_does() -> None:
    """A face that turns about a pin lies on the disc: its normal at ψ is R + e cos ψ from the axis."""
    m = fx.Model()
    m.rigid_body("cam", (0, 0), mass=1.0, inertia=0.01)
    m.rigid_body("lever", (0.2, R), mass=1.0, inertia=0.01)
    m.revolute("shaft", "ground", "cam", at=(0, 0))
    m.revolute("pin", "ground", "lever", at=(0.2, R))
    m.cam("lobe", "cam", "lever", (0.0, R), disc, start=(1, 0), face=(0, 1))
    m.prescribe("shaft.angle", lambda t: -t)
    state = m.build().simulate(1.3)[-1]
    tilt = np.pi / 2 + state["pin.angle"]
    n = np.array([np.cos(tilt), np.sin(tilt)])
    assert n @ (0.2, R) == pytest.approx(disc(tilt - state["shaft.angle"]), abs=1e-9)
    assert abs(state["pin.angle"]) > 0.05


def test_it_is_linearized_as_it_moves() -> None:
    for planar in (True, False):
        m = tappet(planar)
        m.initial("shaft.angle", 0.3, 2.0)
        m.spring("guide.along" if planar else "guide.axial", 40.0, 0.2, preload=1.0)
        s = m.build()
        lin = s.linearize()
        for own, numerical in zip((lin.M, lin.C, lin.K), numerical_matrices(s, s.initial), strict=True):
            assert worst(own, numerical) < 1e-6


def test_released_it_pushes_by_contact_and_lets_go() -> None:
    m = tappet(True)
    m.fix("cam_frame")
    m.attach("hertz", ["lobe.gap"], stiffness=1e5, exponent=1.0, dissipation=0.0)
    m.load("guide.along", -20.0)
    m.initial("guide.along", -1e-4)
    assert m.build().equilibrium()["guide.along"] == pytest.approx(-20.0 / 1e5, rel=1e-9)
    m.initial("guide.along", 0.01)
    assert m.build().initial.acceleration("guide.along") == pytest.approx(-40.0, rel=1e-12)


def test_an_outline_that_is_not_convex_is_refused_with_what_to_add() -> None:
    """The radius of curvature of 0.05 + 0.01 cos 3ψ is 0.05 - 0.08 cos 3ψ, at least -0.03; 0.031 more is enough."""

    def wavy(angle: float) -> float:
        return 0.05 + 0.01 * float(np.cos(3 * angle))

    with pytest.raises(
        fx.ModelError, match=r"cam 'lobe': .*radius of curvature -0\.0(2|3)\d* m at the angle 0"
    ):
        tappet(True, wavy)
    tappet(True, lambda angle: wavy(angle) + 0.031)


def test_a_face_across_the_axis_is_refused() -> None:
    m = tappet(False)
    with pytest.raises(fx.ModelError, match="cam 'other': its face lies across the axis"):
        m.cam("other", "cam", "follower", (0, R, 0), disc, axis=(0, 0, 1), face=(0, 0, 1), start=(1, 0, 0))


def test_the_picture_shows_the_disc_and_the_face() -> None:
    state = tappet(True).build().initial
    from flexel.apps.view.drawing import shapes

    shown = [shape for shape in shapes(state) if shape.name == "lobe"]
    rim = next(shape for shape in shown if len(shape.lines[0]) > 2).lines[0]
    centre = np.array([E, 0.0, 0.0])
    assert np.linalg.norm(rim - centre, axis=1) == pytest.approx(R, abs=1e-6)
