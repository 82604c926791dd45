"""Points, balls and discs in contact with surfaces, against closed forms; the models are those of the example."""

import numpy as np
import pytest

import flexel as fx
from flexel.examples import contact as example
from flexel.examples.contact import MASS, MU, STIFFNESS, A, G
from flexel.examples.rope_exact import hertz


@pytest.fixture(scope="module")
def results() -> example.ContactResults:
    return example.analyse()


def test_every_row_of_the_example_is_within_its_tolerance(results: example.ContactResults) -> None:
    """Hertz's and Hunt and Crossley's impact, from sliding to rolling, off a cylinder, between the flanks of a V."""
    rows = example.rows(results)
    assert len(rows) == 13
    assert [row.name for row in rows if not row.ok] == []


def test_the_force_of_an_impact_is_hertzian(results: example.ContactResults) -> None:
    approach = hertz(STIFFNESS, MASS, example.SPEED)[0]
    motion = results.elastic
    gap, force = motion["touch.gap"], -motion.force("touch.gap")
    assert force.max() == pytest.approx(STIFFNESS * approach**1.5, rel=1e-6)
    assert np.all(force[gap > 0] == 0)
    assert force == pytest.approx(STIFFNESS * np.maximum(-gap, 0) ** 1.5, abs=1e-9 * force.max())
    assert motion.rate("ball.z")[-1] == pytest.approx(example.SPEED, rel=1e-8)


def test_an_impact_with_dissipation_is_as_slow_as_its_restitution_says(
    results: example.ContactResults,
) -> None:
    assert results.damped.rate("ball.z")[-1] == pytest.approx(example.RESTITUTION * example.SPEED, rel=1e-8)


def test_a_foot_off_the_point_of_its_body_carries_its_share() -> None:
    """A bar on a hinge with a foot at the distance x: N = m g c/x at rest, drawn pressed so that it is stiff."""
    m = example.ground((0, 0, -G))
    m.plane("floor", "O", "ground", normal=(0, 0, 1))
    m.point("P", (0, 0, A), fixed=True)
    m.frame("R")
    m.hinge("pivot", "ground", "R", axis=(0, 1, 0))
    m.body("bar", "P", "R", mass=MASS, inertia=(0.1, 0.1, 0.1), offset=(0.5, 0, 0))
    m.contact("foot", "P", "floor", fx.Contact(STIFFNESS), frame="R", at=(0.8, 0.3, A - 1e-4), radius=A)
    rest = m.build().equilibrium()
    load = MASS * G * 0.5 / 0.8
    assert rest.force("foot.gap") == pytest.approx(-load, rel=1e-4)
    assert rest["foot.gap"] == pytest.approx(-example.depth(STIFFNESS, load), rel=1e-4)


@pytest.mark.parametrize("planar", [False, True])
def test_friction_slows_a_ball_that_slides_and_vanishes_when_it_rolls(
    results: example.ContactResults, planar: bool
) -> None:
    motion = results.disc if planar else results.ball
    slip = "touch.tangential" if planar else "touch.x"
    time = example.rolling(1 / 2 if planar else 2 / 5)[1]
    half = int(np.searchsorted(motion.t, time / 2))
    assert motion.force(slip)[half] == pytest.approx(MU * MASS * G, rel=1e-5)
    assert example.V0 - motion.rate("ball.x")[half] == pytest.approx(MU * G * motion.t[half], rel=1e-5)
    assert abs(motion.force(slip)[-1]) < 1e-6 * MASS * G
    assert abs(motion.rate(slip)[-1]) < 1e-8


def test_a_point_slides_straight_down_an_incline(results: example.ContactResults) -> None:
    motion = results.point
    speed = np.hypot(motion.rate("P.x"), motion.rate("P.z"))
    assert motion.rate("touch.x") == pytest.approx(speed, rel=1e-6)
    assert abs(motion.rate("touch.y")).max() < 1e-12


def test_bristles_hold_a_point_on_an_incline() -> None:
    """Below the angle of friction it comes to rest and stays; Coulomb's regularized friction would creep."""
    angle = 0.25
    contact = fx.Contact(
        STIFFNESS, dissipation=1.0, friction=0.5, bristle_stiffness=1e4, bristle_damping=20.0
    )
    motion = example.incline(contact, angle).build().simulate(1.0, samples=11, progress=False)
    assert abs(motion.rate("touch.x")[-1]) < 1e-6
    assert motion.force("touch.x")[-1] == pytest.approx(MASS * G * np.sin(angle), rel=1e-4)
    assert motion["P.x"][-1] - motion["P.x"][-2] == pytest.approx(0.0, abs=1e-7)


def test_a_ball_on_a_cylinder_rolls_until_it_hardly_touches(results: example.ContactResults) -> None:
    for motion in results.drums.values():
        early = example.pressed_rolling(example.cosines(motion)) > 0.2 * MASS * G
        assert abs(motion.rate("touch.tangential")[early]).max() < 1e-3


def test_a_ball_in_a_v_groove_rolls_on_both_flanks(results: example.ContactResults) -> None:
    """Each flank is pressed by the depth times sin(opening/2); at first it slides, and friction is full."""
    motion = results.idler
    assert motion.rate("idler.angle")[0] == 0
    for slip in ("tangential1", "tangential2", "across1", "across2"):
        assert abs(motion.rate(f"touch.{slip}")[-1]) < 1e-6
    normal = STIFFNESS * (example.PRESSED * np.sin(example.OPENING / 2)) ** 1.5
    for i in (1, 2):
        assert -motion.force(f"touch.gap{i}") == pytest.approx(np.full(motion.t.size, normal), rel=1e-6)
        friction = np.hypot(motion.force(f"touch.tangential{i}"), motion.force(f"touch.across{i}"))
        assert friction[0] == pytest.approx(0.3 * normal, rel=1e-3)
        assert friction[-1] < 1e-3 * normal


@pytest.mark.parametrize("normal", [(0, 0, 1), (0.3, 0.5, 0.8), (0, -1, 0), (1, 0, 0), (0.95, 0.1, -0.1)])
def test_the_slips_of_a_plane_are_along_the_x_axis_and_across(normal: tuple[float, float, float]) -> None:
    """Along the projection of x, or of y where the normal is nearly x; with the normal they are right-handed."""
    n = np.array(normal) / np.linalg.norm(normal)
    axis = np.array([1.0, 0, 0] if abs(n[0]) < 0.9 else [0, 1.0, 0])
    e_x = (axis - (axis @ n) * n) / np.linalg.norm(axis - (axis @ n) * n)
    velocity = np.array([0.3, -0.7, 0.4])
    m = example.ground((0, 0, 0))
    m.plane("plane", "O", "ground", normal=normal)
    m.point("P", n)
    m.point_mass("mass", "P", MASS)
    m.contact("touch", "P", "plane", fx.Contact(STIFFNESS, friction=0.1))
    for name, rate in zip("xyz", velocity, strict=True):
        m.initial(f"P.{name}", rate=rate)
    state = m.build().initial
    found = [state.rate(f"touch.{name}") for name in ("x", "y", "gap")]
    assert found == pytest.approx([velocity @ e_x, velocity @ np.cross(n, e_x), velocity @ n], abs=1e-14)
    assert state["touch.gap"] == pytest.approx(1.0)
