"""Automatic choice of degrees of freedom, and the change of degrees of freedom during a motion."""

import numpy as np
import pytest
from branch_families import case
from differences import pendulum
from mechanisms import heavy_top, slider_crank

from flexel.base.errors import ConstraintError, FlexelError
from flexel.mechanics.diagnose import choose_dofs
from flexel.parts.model import Model


def test_slider_as_coordinate_passes_the_dead_centres() -> None:
    """The program changes to another degree of freedom near each dead centre; the motion is that of the crank's
    angle.
    """
    s = slider_crank("B.x").build()
    assert s.dynamic == ("B.x",)
    motion = s.simulate(1.5, samples=31, rtol=1e-11, atol=1e-12)
    good = slider_crank("crank hinge.angle").build().simulate(1.5, samples=31, rtol=1e-11, atol=1e-12)
    assert motion.statistics["rechoices"] > 0
    assert good.statistics["rechoices"] == 0
    assert abs(good["crank hinge.angle"][-1]) > 4 * np.pi
    assert np.max(np.abs(motion["crank hinge.angle"] - good["crank hinge.angle"])) < 1e-8
    assert np.max(np.abs(motion["B.x"] - good["B.x"])) < 1e-9
    for run in (motion, good):
        E = run.energy["total"]
        assert np.ptp(E) < 1e-9 * run.energy["kinetic"].max()
        assert np.max(run.drift) < 1e-12


def test_without_re_choice_the_slider_sticks_at_its_dead_centre_with_an_error() -> None:
    s = slider_crank("B.x").build()
    with pytest.raises(FlexelError, match=r"'B\.x' cannot describe the motion beyond t = 0\.09"):
        s.simulate(3.0, rechoose=False, method="DOP853", rtol=1e-4, atol=1e-6)


def test_a_system_keeps_its_dofs_after_a_motion_that_changed_them() -> None:
    s = slider_crank("B.x").build()
    first = s.simulate(1.0, samples=5)
    assert s.dynamic == ("B.x",)
    again = s.simulate(1.0, samples=5)
    assert np.max(np.abs(first.x - again.x)) == 0
    # and a motion continues from where another stopped
    later = s.simulate(1.0, start=first[-1], samples=5)
    whole = s.simulate(2.0, samples=5)
    assert np.max(np.abs(later[-1].x - whole[-1].x)) < 1e-7


def test_stored_states_do_not_depend_on_how_densely_they_are_stored() -> None:
    """A top at 150 rad/s turns several times between samples; branches and turns are determined from the steps."""
    dense, sparse = (heavy_top().simulate(0.3, samples=n) for n in (61, 3))
    assert np.max(np.abs(dense.x[[0, 30, 60]] - sparse.x)) == 0
    assert np.ptp(sparse.energy["total"]) < 1e-6 * sparse.energy["total"][0]
    for t in (0.017, 0.123, 0.299):
        assert abs(sparse.at(t).energy.total / sparse[0].energy.total - 1) < 1e-6
        assert np.max(np.abs(sparse.at(t).x - dense.at(t).x)) == 0


def test_program_chooses_joint_angles_before_coordinates() -> None:
    assert pendulum(mass_per_length=1.0).build().dynamic == ("pivot.angle",)
    m = pendulum(mass_per_length=1.0)
    B, R2 = m.point("B", (1.5, 0.5, 0)), m.frame("R2")
    m.hinge("elbow", "R1", R2, axis=(0, 0, 1))
    m.beam("arm", "A", R2, B, mass_per_length=1.0)
    assert set(m.build().dynamic) == {"pivot.angle", "elbow.angle"}


def test_free_body_gets_six_dofs() -> None:
    m = Model()
    P, R = m.point("P", (1, 2, 3)), m.frame("R", (0.5, 0.5, 0.5, 0.5))
    m.body("body", P, R, mass=1.0, inertia=(1, 1, 1))
    s = m.build()
    assert len(s.dynamic) == 6
    assert {"P.x", "P.y", "P.z"} < set(s.dynamic)


def test_dofs_named_twice_over_are_refused_by_name() -> None:
    m = slider_crank("B.x")
    m.independent("crank hinge.angle")
    with pytest.raises(ConstraintError, match=r"B\.x.*crank hinge\.angle|crank hinge\.angle.*B\.x"):
        m.build()


def test_named_dofs_are_completed() -> None:
    m = pendulum(mass_per_length=1.0)
    B, R2 = m.point("B", (2, 0, 0)), m.frame("R2")
    m.hinge("elbow", "R1", R2, axis=(0, 1, 0))
    m.beam("arm", "A", R2, B, mass_per_length=1.0)
    m.independent("B.z")
    assert m.build().dynamic == ("B.z", "elbow.angle")


def chain(bodies: int) -> Model:
    """Bars hung on one another, with the angles of the joints as degrees of freedom."""
    m = Model(gravity=(0, -9.81))
    m.point("P0", (0, 0), fixed=True)
    m.angle("A0", fixed=True)
    for i in range(1, bodies + 1):
        m.point(f"P{i}", (0.1 * i, 0))
        m.angle(f"A{i}")
        m.hinge(f"joint{i}", f"A{i - 1}", f"A{i}")
        m.beam(f"bar{i}", f"P{i - 1}", f"A{i}", f"P{i}", rigid=True, mass_per_length=1.0)
        m.spring(f"joint{i}.angle", stiffness=50.0)
    m.independent(*(f"joint{i}.angle" for i in range(1, bodies + 1)))
    return m


@pytest.mark.parametrize("bodies", [10, 24, 60])
def test_named_dofs_of_a_chain_are_kept_by_every_analysis(bodies: int) -> None:
    """The angles of a long chain move its end by n² of their size, which is no singularity (replaced from 24 on)."""
    s = chain(bodies).build()
    rest = s.equilibrium()
    names = tuple(f"joint{i}.angle" for i in range(1, bodies + 1))
    assert s.dynamic == names
    assert tuple(s.structure.names[i] for i in rest.roles.dynamic) == names
    assert s.linearize(rest).dynamic == names
    assert all(row.severity != "warning" for row in chain(bodies).check().findings)


@pytest.mark.parametrize(("method", "tolerance"), [("DOP853", 1e-9), ("Radau", 1e-6)])
def test_every_integrator_passes_the_dead_centres(method: str, tolerance: float) -> None:
    s = slider_crank("B.x").build()
    motion = s.simulate(0.6, samples=7, method=method, rtol=tolerance, atol=tolerance * 1e-2)
    good = slider_crank("crank hinge.angle").build().simulate(0.6, samples=7, rtol=1e-11, atol=1e-12)
    assert motion.statistics["rechoices"] > 0
    assert np.max(np.abs(motion["crank hinge.angle"] - good["crank hinge.angle"])) < 1e-4


def flywheel(prescribed: bool) -> Model:
    """A heavy flywheel drives a light slider: the integrator feels little, the position problem everything."""
    m = Model()
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (0, 0.3)), m.point("B", (0.4, 0))
    m.fix("B.y")
    ground, crank, rod = m.angle("ground", fixed=True), m.angle("crank"), m.angle("rod")
    m.hinge("crank hinge", ground, crank)
    m.hinge("big end", crank, rod)
    m.beam("crank bar", O, crank, A)
    m.beam("rod bar", A, rod, B)
    m.body("wheel", O, crank, mass=1.0, inertia=10.0)
    m.point_mass("slider", B, 1e-5)
    if prescribed:
        m.prescribe("crank hinge.angle", lambda t: 50 * t)
    else:
        m.independent("crank hinge.angle")
        m.initial("crank hinge.angle", rate=50.0)
    return m


@pytest.mark.parametrize("prescribed", [False, True], ids=["free", "prescribed"])
@pytest.mark.parametrize("rtol", [1e-2, 1e-8])
def test_long_steps_do_not_lead_to_another_branch(prescribed: bool, rtol: float) -> None:
    """Sixteen turns in few steps and fewer samples: the slider stays on the side where it was drawn."""
    motion = flywheel(prescribed).build().simulate(2.0, samples=8, rtol=rtol, atol=1e-6)
    crank = np.pi / 2 + motion["crank hinge.angle"]
    assert (
        np.max(np.abs(motion["B.x"] - 0.3 * np.cos(crank) - np.sqrt(0.25 - 0.09 * np.sin(crank) ** 2)))
        < 1e-12
    )
    lean = -np.arcsin(0.6 * np.sin(crank)) - crank  # of the rod against the crank
    assert np.max(np.abs(motion["big end.angle"] - (lean - lean[0]))) < 1e-11


def test_fast_free_rotor_is_followed_through_its_turns() -> None:
    m = Model()
    O = m.point("O", (0, 0, 0), fixed=True)
    a, b = m.frame("a", fixed=True), m.frame("b")
    m.hinge("axle", a, b, axis=(0, 0, 1))
    m.body("rotor", O, b, mass=1.0, inertia=(1, 1, 1))
    m.initial("axle.angle", rate=200.0)
    motion = m.build().simulate(0.5, samples=4)
    assert np.max(np.abs(motion["axle.angle"] - 200.0 * motion.t)) < 1e-11
    assert abs(motion.at(0.123)["axle.angle"] - 24.6) < 1e-11


def test_a_choice_close_to_a_singular_position_is_complete_or_refused() -> None:
    """By rounding, too many degrees of freedom seemed to be needed, and the engine read beyond its tables."""
    found = case("parallelogram", 1)
    system = found.built(found.good)
    drawn = system.initial.x
    s, kinematics = system.structure, system.kinematics
    angle = np.arctan2(*drawn[[s.names.index(f"P0.{axis}") - s.m - s.k for axis in "yx"]])
    chosen = refused = 0
    for distance in 10.0 ** np.linspace(-14, -4, 300):
        try:
            state = system.state_at({"R0.angle": -angle + distance})
            roles = choose_dofs(kinematics, kinematics.evaluation.position(state.x)[1], None, None)
        except ConstraintError:
            refused += 1
            continue
        chosen += 1
        assert roles.position_rows.size == s.nf
    assert chosen
    assert refused
