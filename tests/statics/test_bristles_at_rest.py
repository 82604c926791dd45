"""Friction by bristles in statics: it holds as springs do, up to the friction, and slides beyond."""

import numpy as np
import pytest

import flexel as fx

MASS, PRESSED, GRIP, BRISTLES = 0.1, 10.0, 0.5, 1e5  # [kg], [N], coefficient of friction, [1/m]
WEIGHT = MASS * 9.81


def jaws(**friction: float) -> fx.System:
    """A ball between two jaws, one of which is pressed against it."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.rigid_body("ball", (0, 0, 0), mass=MASS, inertia=(1e-5,) * 3)
    m.frame("wall", fixed=True)
    for name, side in (("left", -1), ("right", 1)):
        m.point(name, (side * 0.0198, 0, 0), fixed=side < 0)
        m.plane(f"{name} jaw", name, "wall", normal=(-side, 0, 0))
        law = fx.Contact(1e6, **friction)
        m.contact(f"{name} touch", "ball", f"{name} jaw", law, frame="ball_frame", radius=0.02)
    m.fix("right.y", "right.z")
    m.load("right.x", -PRESSED)
    m.point_mass("jaw", "right", 0.2)
    return m.build()


def held() -> fx.System:
    return jaws(friction=GRIP, bristle_stiffness=BRISTLES, bristle_damping=10.0)


def test_bristles_hold_a_ball_between_jaws() -> None:
    """Each jaw carries half of the weight; the deflection is that force by the stiffness, and the ball stays."""
    system = held()
    rest = system.equilibrium()
    deflection = WEIGHT / 2 / (PRESSED * BRISTLES)
    assert np.sort(np.abs(rest.z))[2:] == pytest.approx(deflection, rel=1e-9)
    assert np.all(np.abs(rest.a) < 1e-9)
    # an implicit step of dz = (1 - bristles z/friction) dx
    assert rest["ball.z"] == pytest.approx(-deflection / (1 - BRISTLES * deflection / GRIP), rel=1e-9)


def test_the_stiffness_of_bristles_is_in_the_compliance() -> None:
    """It turns freely about the line between the jaws, and is held otherwise."""
    system = held()
    found = system.compliance("ball", "ball_frame", system.equilibrium(), hold=["ball_frame.lambda1"])
    assert found.matrix[2, 2] == pytest.approx(1 / (2 * PRESSED * BRISTLES), rel=1e-6)


def test_a_ball_that_is_too_heavy_for_its_friction_is_not_held() -> None:
    """Half of the weight, 0.49 N, is more than the friction, 0.4 N."""
    with pytest.raises(fx.FlexelError):
        jaws(friction=0.04, bristle_stiffness=BRISTLES).equilibrium()


def test_friction_that_depends_on_the_sliding_velocity_is_named() -> None:
    with pytest.raises(
        fx.DynamicsError, match=r"motion of 'ball\.z'.*friction of 'left touch' .*zero at rest"
    ):
        jaws(friction=GRIP, slip_speed=1e-3).equilibrium()


def pulled(period: float) -> fx.System:
    """A sledge on a floor, which a spring pulls to and fro."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("ground", (0, 0), fixed=True)
    m.angle("level", fixed=True)
    m.plane("floor", "ground", "level", normal=(0, 1))
    m.point("sledge", (0, 0))
    m.point_mass("mass", "sledge", MASS)
    law = fx.Contact(1e6, friction=GRIP, bristle_stiffness=1e3)
    m.contact("touch", "sledge", "floor", law)
    m.point("hand", (0.1, 0))
    m.fix("hand.y")
    m.prescribe("hand.x", fx.Table([0, period, 2 * period], [0.1, 0.12, 0.1], kind="linear"))
    m.truss("spring", "sledge", "hand", stiffness=100.0)
    return m.build()


def test_a_path_of_equilibria_has_the_hysteresis_of_friction() -> None:
    """The spring pulls with the friction at the end of the way there, and pushes with it at the end of the way back."""
    system = pulled(1.0)
    there = system.static_path(start=system.equilibrium(), t_end=1.0)
    back = system.static_path(start=there[-1], t_end=2.0)
    friction = GRIP * WEIGHT
    assert there[-1].force("spring.elongation") == pytest.approx(friction, rel=1e-3)
    assert back[-1].force("spring.elongation") == pytest.approx(-friction, rel=1e-3)
    assert there[-1]["sledge.x"] > 0.014 and abs(back[-1]["sledge.x"] - 0.005) < 1e-3
