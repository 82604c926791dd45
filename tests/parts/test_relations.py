"""Linear relations among deformations and coordinates: screws, gears, racks and differentials against closed forms."""

import numpy as np
import pytest
from differences import numerical_matrices, worst

import flexel as fx

PITCH = 0.05  # of the screw [m per rad]


def screw(steepness: float = PITCH, **options: float) -> fx.Model:
    """A nut that turns about and slides along a vertical axis, heavy, on a screw."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("P", (0, 0, 0.3))
    m.frame("ground", fixed=True)
    m.frame("nut")
    m.bearing("guide", "O", "ground", "P", "nut", axis=(0, 0, 1))
    m.body("mass", "P", "nut", mass=2.0, inertia=(0.1, 0.1, 0.02))
    freed = m.relation("screw", {"guide.axial": 1.0, "guide.angle": -steepness})
    assert freed == ("guide.axial",)
    for name, rate in options.items():
        m.initial(f"guide.{name}", rate=rate)
    return m


def test_a_screw_turns_many_times_without_slipping() -> None:
    s = screw().build()
    assert s.counts["degrees_of_freedom"] == 1
    motion = s.simulate(4.0, samples=41)
    turned = motion["guide.angle"]
    acceleration = -2.0 * 9.81 * PITCH / (0.02 + 2.0 * PITCH**2)
    assert abs(turned[-1]) > 40 * np.pi
    assert turned == pytest.approx(acceleration * motion.t**2 / 2, rel=1e-9, abs=1e-9)
    assert motion["P.z"] == pytest.approx(0.3 + PITCH * turned, rel=1e-11)
    # the thread carries what the weight does not accelerate
    assert motion.force("screw.relation") == pytest.approx(-2.0 * (9.81 + PITCH * acceleration), rel=1e-9)


def test_the_implicit_method_counts_the_turns_of_a_screw_too() -> None:
    motion = screw(angle=30.0).build().simulate(2.0, method="generalized-alpha", rtol=1e-8)
    acceleration = -2.0 * 9.81 * PITCH / (0.02 + 2.0 * PITCH**2)
    assert motion["guide.angle"][-1] == pytest.approx(30 * 2.0 + acceleration * 2.0, abs=1e-3)
    assert motion["guide.axial"] == pytest.approx(PITCH * motion["guide.angle"], abs=1e-10)


def test_a_screw_is_assembled_at_a_slide_that_takes_several_turns() -> None:
    m = screw()
    m.initial("guide.axial", 1.0)
    state = m.build().initial
    assert state["guide.angle"] == pytest.approx(1.0 / PITCH, rel=1e-12)


def differential() -> fx.Model:
    """Two wheels with inertia, and a case whose turn is the mean of theirs, driven by a moment."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    for name, inertia in (("left", 2.0), ("right", 3.0), ("case", 0.5)):
        m.angle(name)
        m.hinge(f"turn {name}", m.angle(f"ground {name}", fixed=True), name)
        m.body(f"mass {name}", "O", name, mass=1.0, inertia=inertia)
    m.relation("gears", {"turn case.angle": 2.0, "turn left.angle": -1.0, "right.angle": -1.0})
    m.load("turn case.angle", 7.0)
    return m


def test_a_differential_splits_its_moment_evenly() -> None:
    """Half of what is left of the moment accelerates each wheel; a coordinate serves as a term like a deformation."""
    s = differential().build()
    assert s.counts["degrees_of_freedom"] == 2
    state = s.initial
    # M = 0.5 c'' + 2 σ;  2 l'' = σ;  3 r'' = σ;  2 c'' = l'' + r''
    share = 7.0 / (2 + 0.5 * (1 / 2 + 1 / 3) / 2)
    assert state.acceleration("turn left.angle") == pytest.approx(share / 2, rel=1e-13)
    assert state.acceleration("right.angle") == pytest.approx(share / 3, rel=1e-13)
    assert abs(state.force("gears.relation")) == pytest.approx(share, rel=1e-13)


def elastic(large: bool = False, moving: bool = True) -> fx.Model:
    """Two pendulums in space that a relation with a spring and a damper couples, three turns to one.

    With many bodies that hang on nothing else beside them, matrices are sparse.
    """
    m = fx.Model(gravity=(0, 0, -9.81))
    ground = m.frame("ground", fixed=True)
    for name, y in (("a", 0.0), ("b", 1.0)):
        o, p = m.point(f"{name}0", (0, y, 0), fixed=True), m.point(f"{name}1", (1, y, -0.2))
        r = m.frame(name)
        m.hinge(f"pivot {name}", ground, r, axis=(0.1, 1, 0.2))
        m.beam(f"rod {name}", o, r, p, mass_per_length=1.0, inertia_per_length=(0.1, 0.2, 0.2))
    m.relation("coupling", {"pivot a.angle": 3.0, "pivot b.angle": -1.0})
    m.spring("coupling.relation", 12.0, damping=0.4)
    for i in range(60 if large else 0):
        m.point(f"free {i}", (i, 2, 0))
        m.frame(f"frame {i}")
        m.body(f"body {i}", f"free {i}", f"frame {i}", mass=1.0, inertia=(1.0, 2.0, 3.0))
    if moving:
        m.initial("pivot a.angle", 0.3, rate=1.0)
        m.initial("pivot b.angle", -0.5, rate=2.0)
    return m


def test_the_linearization_of_an_elastic_relation_is_that_of_the_equations() -> None:
    s = elastic().build()
    state = s.simulate(0.7)[-1]
    lin = s.linearize(state)
    for own, numerical in zip((lin.M, lin.C, lin.K), numerical_matrices(s, state), strict=True):
        assert worst(own, numerical) < 1e-8


def test_energy_goes_only_into_the_damper_of_a_relation() -> None:
    motion = elastic().build().simulate(1.0, method="generalized-alpha", step=2e-3, spectral_radius=0.9)
    balance = motion.energy_balance()
    assert balance["dissipated"][-1] > 0.1
    assert np.max(np.abs(balance["error"])) < 2e-3 * np.ptp(balance["kinetic"])


def test_sparse_and_dense_evaluation_agree_on_relations() -> None:
    small, large = elastic().build().initial, elastic(large=True).build()
    assert large.evaluation.large
    for name in ("pivot a.angle", "pivot b.angle"):
        assert large.initial.acceleration(name) == pytest.approx(small.acceleration(name), rel=1e-11)
    assert large.initial.force("coupling.relation") == pytest.approx(
        small.force("coupling.relation"), rel=1e-12
    )


def test_a_prescribed_relation_drives_and_a_statically_loaded_one_holds() -> None:
    m = differential()
    m.prescribe("gears.relation", lambda t: 0.5 * t**2)
    s = m.build()
    motion = s.simulate(1.0, samples=5)
    r = 2 * motion["turn case.angle"] - motion["turn left.angle"] - motion["right.angle"]
    assert r == pytest.approx(0.5 * motion.t**2, abs=1e-10)
    m = elastic(moving=False)
    m.prescribe("pivot a.angle", 0.4)
    rest = m.build().equilibrium()
    assert rest.rate("coupling.relation") == 0
    assert rest.force("coupling.relation") == pytest.approx(
        12.0 * (3 * rest["pivot a.angle"] - rest["pivot b.angle"]), rel=1e-10
    )


def test_relations_of_relations_are_resolved() -> None:
    m = differential()
    m.release("gears.relation")
    m.relation("second", {"gears.relation": 2.0, "turn left.angle": 1.0})
    s = m.build()
    state = s.state_at(rates={"turn left.angle": 1.0, "right.angle": 4.0})
    assert state.rate("second.relation") == pytest.approx(0.0, abs=1e-14)
    assert 2 * (2 * state.rate("case.angle") - 1 - 4) + 1 == pytest.approx(0.0, abs=1e-13)


def test_a_motion_with_a_relation_is_saved_and_continued(tmp_path) -> None:  # noqa: ANN001
    s = screw(angle=20.0).build()
    motion = s.simulate(1.0, samples=11)
    loaded = fx.load(motion.save(tmp_path / "screw.npz"))
    assert loaded["screw.relation"] == pytest.approx(0.0, abs=1e-12)
    on = s.simulate(1.0, start=s.restore(loaded), samples=3)
    assert on["guide.axial"][-1] == pytest.approx(PITCH * on["guide.angle"][-1], rel=1e-11)


@pytest.mark.parametrize(
    ("terms", "message"),
    [
        ({}, "not coefficients by name"),
        (["guide.angle"], "not coefficients by name"),
        ({"guide.angl": 1.0}, "did you mean guide.angle"),
        ({"guide.angle": 0.0}, "coefficient of 'guide.angle' is zero"),
        ({"guide.angle": "2"}, "coefficient of 'guide.angle' '2' is not numeric"),
        ({"O.x": 1.0, "guide.angle": 1.0}, "'O.x' is fixed"),
    ],
)
def test_what_is_not_a_relation_is_refused(terms: object, message: str) -> None:
    m = screw()
    with pytest.raises(fx.ModelError, match=message):
        m.relation("more", terms)  # type: ignore[arg-type]
    assert "more" not in m.instances
