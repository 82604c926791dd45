"""The implicit integrator on ropes: order, energy, factorization, internal states, counts, failure, large models."""

import tracemalloc

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.engine import elimination
from flexel.integration.alpha import AlphaStepper


def rope(n: int, length: float = 2.0, damping: float = 0.0, EA: float = 2e4) -> fx.Model:
    """A rope of n cables along x, held at one end, released from the horizontal."""
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(n + 1):
        m.point(f"P{i}", (length * i / n, 0, 0), fixed=i == 0)
        m.slope(f"S{i}", (1, 0, 0))
    for i in range(n):
        ends = (f"P{i}", f"S{i}", f"P{i + 1}", f"S{i + 1}")
        m.cable(f"c{i}", *ends, EA=EA, EI=2.0, mass_per_length=0.5, damping=damping, bending_damping=damping)
    return m


def fixed(system: fx.System, duration: float, h: float, **options: object) -> fx.Motion:
    """Integrate with constant steps, the ends alone kept."""
    return system.simulate(duration, method="generalized-alpha", step=h, samples=2, progress=False, **options)  # type: ignore[arg-type]


def test_a_rope_converges_with_the_second_order() -> None:
    system = rope(3, damping=1e-3).build()
    ends = [fixed(system, 0.2, h)[-1].x for h in (4e-3, 2e-3, 1e-3, 5e-4)]
    change = [float(np.abs(b - a).max()) for a, b in zip(ends[:-1], ends[1:], strict=True)]
    assert np.log2(change[1] / change[2]) == pytest.approx(2.0, abs=0.15)


def test_without_damping_the_energy_stays_bounded_over_ten_thousand_steps() -> None:
    system = rope(2, EA=500.0).build()
    motion = system.simulate(
        10.0, method="generalized-alpha", step=1e-3, spectral_radius=1.0, samples=201, progress=False
    )
    balance = motion.energy_balance()
    assert motion.statistics["steps"] == 10_000
    turned_over = np.max(balance["kinetic"])
    assert np.max(np.abs(balance["error"])) < 2e-3 * turned_over
    late, early = (np.max(np.abs(balance["error"][part])) for part in (slice(101, None), slice(0, 101)))
    assert late < 2 * early  # it does not grow


@pytest.mark.parametrize("newton", ["full", "modified"])
def test_energy_put_in_stored_and_lost_adds_up_with_the_second_order(newton: str) -> None:
    m = rope(2, damping=0.01, EA=500.0)
    m.prescribe("P2.x", lambda t: 2.0 + 0.05 * np.sin(6 * t))
    m.load("P1.y", lambda t: 2 * np.cos(5 * t))
    system = m.build()
    errors = []
    for h in (4e-3, 2e-3, 1e-3):
        balance = fixed(system, 1.0, h, newton=newton).energy_balance()
        errors.append(abs(balance["error"][-1]))
    assert balance["dissipated"][-1] > 0.01
    assert abs(balance["work"][-1]) > 0.1
    assert errors[-1] < 1e-3 * abs(balance["work"][-1])
    assert np.log2(errors[0] / errors[2]) / 2 == pytest.approx(2.0, abs=0.4)


@pytest.mark.parametrize("newton", ["full", "modified"])
def test_the_factors_of_large_models_give_the_same_step(newton: str, monkeypatch: pytest.MonkeyPatch) -> None:
    system = rope(24).build()
    ends = []
    for border in (elimination.BORDER, 0):
        monkeypatch.setattr(elimination, "BORDER", border)
        stepper = AlphaStepper(system, 0.8, newton)
        stepper.begin(system.initial)
        assert stepper.step(2e-3)
        stepper.accept(2e-3)
        ends.append(stepper.current().x)
    np.testing.assert_allclose(ends[1], ends[0], rtol=0, atol=1e-12)


def test_a_modified_iteration_keeps_its_factors_and_finds_the_same_motion() -> None:
    system = rope(6).build()
    full, modified = (fixed(system, 0.2, 1e-3, newton=newton) for newton in ("full", "modified"))
    np.testing.assert_allclose(modified[-1].x, full[-1].x, atol=1e-7)
    assert full.statistics["factorizations"] == full.statistics["iterations"] >= 200
    assert modified.statistics["factorizations"] < 0.3 * full.statistics["factorizations"]
    assert (
        modified.statistics["evaluations"] == modified.statistics["steps"] + modified.statistics["iterations"]
    )


def test_a_body_on_a_rope_agrees_with_the_explicit_integrator() -> None:
    m = rope(2, EA=300.0)
    m.frame("R")
    m.body("load", "P2", "R", mass=3.0, inertia=(0.1, 0.1, 0.1))
    m.initial("P2.y", rate=0.5)
    system = m.build()
    explicit = system.simulate(0.3, samples=4, rtol=1e-9, atol=1e-11, progress=False)
    errors = []
    for h in (1e-3, 5e-4, 2.5e-4):
        implicit = system.simulate(0.3, method="generalized-alpha", samples=4, step=h, progress=False)
        errors.append(np.max(np.abs(implicit.x - explicit.x)))
        assert np.max(implicit.drift) < 1e-10
    assert errors[-1] < 1e-3
    assert np.log2(errors[0] / errors[-1]) / 2 > 1.7  # more, while the fastest modes die out


@pytest.mark.parametrize("start", [0.0, 0.004])
def test_bristles_follow_the_explicit_integrator(start: float) -> None:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.slope("dO", (1, 0), fixed=True)
    m.point("A", (1, 0))
    m.slope("dA", (1, 0), fixed=True)
    m.fix("A.y")
    m.cable("rope", "O", "dO", "A", "dA", EA=40.0, EI=0.0, mass_per_length=0.0)
    m.point_mass("mass", "A", 1.0)
    m.point("C", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    values = {"l0": 1.0, "xi": 1.0, "alpha0": 0.0, "offset": [0.0, 0.01], "rope_radius": 0.0}
    ends = [m.nodes[name] for name in ("O", "dO", "A", "dA", "C", "ground")]
    m.element("contact", "planar_cable_line", *ends, **values)
    m.attach(
        "hertz_bristle_1", ["contact.gap", "contact.tangential"], name="friction", stiffness=1000.0, exponent=1.0,
        dissipation=0.0, friction=0.3, bristle_stiffness=100.0, bristle_damping=0.5, release=10.0,
    )  # fmt: skip
    m.initial("A.x", value=1.1 + start)
    system = m.build()
    exact = system.simulate(1.0, samples=6, method="Radau", rtol=1e-10, atol=1e-12, progress=False)
    bristle = "friction.z_0"
    errors = []
    for h in (4e-3, 1e-3):
        motion = system.simulate(1.0, method="generalized-alpha", step=h, samples=6, progress=False)
        errors.append(max(np.max(np.abs(motion[name] - exact[name])) for name in (bristle, "A.x")))
    assert np.max(np.abs(exact[bristle])) > 1e-3
    assert errors[1] < 1e-4
    assert np.log2(errors[0] / errors[1]) / 2 > 1.5
    balance = motion.energy_balance()
    assert balance["contact"][0] == pytest.approx(1000 * 0.01**2 / 2)
    assert np.max(np.abs(balance["error"])) < 1e-2 * balance["dissipated"][-1]


def test_a_motion_that_stopped_can_be_started_again() -> None:
    m = fx.Model()
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    m.truss("rod", O, A)
    m.point_mass("mass", A, 1.0)
    m.prescribe("A.y", lambda t: t)  # out of reach of the rod after 1 s
    system = m.build()
    with pytest.raises(fx.DynamicsError, match="restart from there") as caught:
        system.simulate(2.0, method="generalized-alpha", step=0.01, samples=401, progress=False)
    motion = caught.value.motion
    assert motion.t[-1] == pytest.approx(1.0)
    again = system.simulate(
        0.1, method="generalized-alpha", start=motion[-60], samples=3, step=1e-3, progress=False
    )
    assert again.message == f"reached the end ({again.verdict})"
    assert len(motion.energy_balance()["error"]) == len(motion)


def test_two_halves_of_a_motion_are_the_whole() -> None:
    system = rope(4, EA=500.0).build()
    whole = fixed(system, 0.4, 1e-3)[-1]
    half = fixed(system, 0.2, 1e-3)[-1]
    rest = fixed(system, 0.2, 1e-3, start=half)[-1]
    assert rest.t == pytest.approx(whole.t)
    np.testing.assert_allclose(rest.x, whole.x, atol=2e-5)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"newton": "half"}, "newton 'half' is unknown"),
        ({"method": "euler"}, "method 'euler' is unknown"),
        ({"step": -1.0}, "step -1 is too small"),
        ({"rtol": 0.0}, "rtol 0 is too small"),
    ],
)
def test_wrong_options_are_refused_by_name(options: dict[str, object], message: str) -> None:
    with pytest.raises(fx.ModelError, match=message):
        rope(1).build().simulate(0.1, **({"method": "generalized-alpha"} | options), progress=False)  # type: ignore[arg-type]


def test_energy_is_balanced_for_implicit_motions_only() -> None:
    motion = rope(1, EA=100.0).build().simulate(0.01, method="DOP853", samples=2, progress=False)
    with pytest.raises(fx.ModelError, match="no energy balance"):
        motion.energy_balance()


@pytest.mark.long
def test_storage_of_a_large_model_grows_linearly_with_its_elements() -> None:
    peaks = []
    for n in (80, 320):
        tracemalloc.start()
        system = rope(n, length=0.1 * n).build()
        fixed(system, 2e-3, 1e-3)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 5.0 * peaks[0]


def test_the_start_of_a_large_model_is_that_of_a_small_one() -> None:
    small, large = rope(4).build(), rope(80, length=40.0).build()
    # a rope released from the horizontal falls freely, but near its support
    assert large.initial.a[large.structure.places("P60")][2] == pytest.approx(-9.81, rel=1e-9)
    assert large.roles.nd == large.structure.nf == 6 * 80 + 3
    assert small.roles.nd == small.structure.nf == 6 * 4 + 3


def test_a_large_model_with_bodies_keeps_its_conditions_and_names_what_repeats() -> None:
    m = rope(70, length=7.0)
    m.frame("R")
    m.body("load", "P70", "R", mass=20.0, inertia=(1.0, 1.0, 1.0))
    m.clamp("tie", "R", "S70")
    m.initial("P70.y", rate=1.0)
    system = m.build()
    assert system.structure.n > 400
    motion = fixed(system, 0.02, 1e-3)
    assert motion[0].rate("P70.y") == pytest.approx(1.0, abs=1e-12)
    assert np.max(motion.drift) < 1e-10
    assert system.roles.nd == system.structure.nf - 1 - 2
    m.clamp("tie again", "R", "S70")
    with pytest.raises(fx.ConstraintError, match="over-constrained: 1 rigid .* 'tie again"):
        m.build()


@pytest.mark.parametrize("with_body", [False, True])
def test_an_integrator_of_another_program_agrees(with_body: bool) -> None:
    """SciPy's Radau, on the degrees of freedom."""
    m = rope(2, EA=300.0, damping=0.02)
    if with_body:
        m.frame("R")
        m.body("load", "P2", "R", mass=3.0, inertia=(0.1, 0.1, 0.1))
    system = m.build()
    ours = system.simulate(0.3, method="generalized-alpha", step=2.5e-4, samples=4, progress=False)
    start = system.initial
    y = np.concatenate([start.q, start.qd])
    theirs = solve_ivp(system.rhs, (0, 0.3), y, method="Radau", t_eval=ours.t, rtol=1e-7, atol=1e-9).y
    for i, name in enumerate(system.dynamic):
        np.testing.assert_allclose(theirs[i], ours[name], atol=1e-3)
