"""The implicit integrator: order, constraints, damping of high frequencies, energy, steps, failure."""

import numpy as np
import pytest

import flexel as fx
from flexel.examples.bicycle import bicycle, rolling
from flexel.integration.scheme import Scheme
from flexel.integration.steps import GeneralizedAlpha

LONG = pytest.mark.filterwarnings(
    "ignore:simulate. generalized-alpha:flexel.DampingWarning"
)  # long steps, on purpose


def pendulum() -> fx.System:
    """A bar of 1 m and 2 kg on a hinge, released from the horizontal."""
    m = fx.Model(gravity=(0, 0, -9.81))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (1, 0, 0))
    R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("pivot", R0, R1, axis=(0, 1, 0))
    m.beam("rod", O, R1, A, mass_per_length=2.0)
    return m.build()


def four_bar() -> fx.System:
    """A planar four-bar with heavy links, started with a turning crank."""
    m = fx.Model(gravity=(0, -9.81))
    A, D = m.point("A", (0, 0), fixed=True), m.point("D", (2, 0), fixed=True)
    B, C = m.point("B", (0, 1)), m.point("C", (2, 1.5))
    for name, p, q in (("crank", A, B), ("coupler", B, C), ("rocker", C, D)):
        m.beam(name, p, m.angle(f"{name} angle"), q, mass_per_length=1.0)
    m.independent("crank angle.angle")
    m.initial("crank angle.angle", rate=3.0)
    return m.build()


def oscillator(stiffness: float, start: float) -> fx.System:
    """A unit mass on a spring along x, drawn at its rest length 1."""
    m = fx.Model()
    O, P = m.point("O", (0, 0), fixed=True), m.point("P", (1, 0))
    m.fix("P.y")
    m.truss("spring", O, P, stiffness=stiffness)
    m.point_mass("mass", P, 1.0)
    m.initial("P.x", value=1.0 + start)
    return m.build()


def fixed_steps(system: fx.System, duration: float, h: float, radius: float = 0.8) -> fx.Motion:
    """Integrate with constant steps and keep every one."""
    samples = round(duration / h) + 1
    return system.simulate(
        duration, method="generalized-alpha", samples=samples, step=h, spectral_radius=radius, progress=False
    )


@LONG
@pytest.mark.parametrize("radius", [0.0, 0.5, 0.9])
def test_coordinates_rates_and_multipliers_converge_with_the_second_order(radius: float) -> None:
    system = pendulum()
    exact = system.simulate(0.8, rtol=1e-12, atol=1e-13, progress=False)[-1]
    errors = []
    for h in (0.02, 0.01, 0.005):
        end = fixed_steps(system, 0.8, h, radius)[-1]
        errors.append(
            [
                abs(end["A.z"] - exact["A.z"]),
                abs(end.rate("A.z") - exact.rate("A.z")),
                abs(end.force("O.z") - exact.force("O.z")),
            ]
        )
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    np.testing.assert_allclose(orders[-1, :2], 2.0, atol=0.2)
    assert orders[-1, 2] > 1.5


@pytest.mark.parametrize("make", [pendulum, four_bar])
def test_it_agrees_with_the_explicit_integrator_and_keeps_the_constraints(make: object) -> None:
    system: fx.System = make()  # type: ignore[operator]
    explicit = system.simulate(1.0, samples=11, progress=False)
    implicit = system.simulate(1.0, method="generalized-alpha", samples=11, rtol=1e-8, progress=False)
    for a, b in zip(explicit, implicit, strict=True):
        np.testing.assert_allclose(b.x, a.x, atol=3e-5)
    assert np.max(implicit.drift) < 1e-10


def test_rolling_wheels_keep_their_conditions_on_the_rates() -> None:
    system = bicycle()
    start = rolling(system, 4.0, 0.05)
    explicit = system.simulate(1.0, start=start, samples=6, progress=False)
    implicit = system.simulate(
        1.0, method="generalized-alpha", start=start, samples=6, rtol=1e-8, progress=False
    )
    for name in ("lean.angle", "steer.angle", "rear contact.x", "yaw.angle"):
        np.testing.assert_allclose(implicit[name], explicit[name], atol=1e-4)
    slips = [state.rates[system.roles.zero] for state in implicit]
    assert np.max(np.abs(slips)) < 1e-8


@LONG
@pytest.mark.parametrize("radius", [0.0, 0.6, 0.75, 0.9])
def test_high_frequencies_die_out_with_the_given_spectral_radius(radius: float) -> None:
    h = 1.0
    system = oscillator(1e4, 1e-5)  # ω h = 100
    motion = fixed_steps(system, 40 * h, h, radius)
    envelope = np.abs(motion["P.x"] - 1) + np.abs([state.rate("P.x") * h for state in motion]) * 1e-2
    late, early = np.max(envelope[30:33]), np.max(envelope[20:23])
    if radius == 0.0:
        assert late < 1e-10
    else:
        # double root: the envelope falls with n radius^n
        assert (late / early) ** 0.1 == pytest.approx(radius, rel=0.08)


@LONG
def test_low_frequencies_keep_their_energy() -> None:
    system = oscillator(1.0, 0.5)
    motion = fixed_steps(system, 20 * np.pi, 2 * np.pi / 100, 0.9)
    E = np.array([0.5 * state.rate("P.x") ** 2 + 0.5 * (state["P.x"] - 1) ** 2 for state in motion])
    assert np.all(np.abs(E / 0.125 - 1) < 2e-3)
    damped = fixed_steps(system, 20 * np.pi, 2 * np.pi / 100, 0.0)[-1]
    assert 0.5 * damped.rate("P.x") ** 2 + 0.5 * (damped["P.x"] - 1) ** 2 < E[-1]


def leaf_spring(n: int = 4) -> fx.System:
    """A leaf spring 0.2 mm thick with a tip mass, pushed by a step load; its axial frequencies are 1e4 times higher."""
    E, t, b, L = 2.1e11, 2e-4, 0.02, 0.1
    m = fx.Model()
    m.point("P0", (0, 0), fixed=True)
    m.angle("R0", fixed=True)
    for i in range(1, n + 1):
        m.point(f"P{i}", (L * i / n, 0))
        m.angle(f"R{i}")
        m.beam(
            f"b{i}", f"P{i - 1}", f"R{i - 1}", f"P{i}", f"R{i}",
            EA=E * b * t, EIz=E * b * t**3 / 12, mass_per_length=7800 * b * t,
        )  # fmt: skip
    m.point_mass("load", f"P{n}", 0.05)
    m.load(f"P{n}.y", 0.05)
    return m.build()


def test_a_stiff_leaf_spring_takes_steps_of_the_slow_motion() -> None:
    system = leaf_spring()
    motion = system.simulate(1.0, method="generalized-alpha", rtol=1e-6, samples=51, progress=False)
    fast = max(mode.omega for mode in system.vibrations(count=12))
    slow = system.vibrations(count=1)[0].omega
    assert motion.statistics["steps"] < fast * 1.0 / 100  # an explicit method needs about fast * duration / 3
    static = system.equilibrium()["P4.y"]
    t = motion.t
    np.testing.assert_allclose(motion["P4.y"], static * (1 - np.cos(slow * t)), atol=0.05 * static)


def test_tighter_tolerances_give_smaller_errors_in_more_steps() -> None:
    system = pendulum()
    exact = system.simulate(1.0, rtol=1e-12, atol=1e-13, progress=False)[-1]["A.z"]
    runs = [
        system.simulate(1.0, method="generalized-alpha", rtol=rtol, samples=2, progress=False)
        for rtol in (1e-5, 1e-7, 1e-9)
    ]
    errors = [abs(run[-1]["A.z"] - exact) for run in runs]
    steps = [run.statistics["steps"] for run in runs]
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 1e-5
    assert steps[2] / steps[1] == pytest.approx(100 ** (1 / 3), rel=0.3)


def test_no_step_is_longer_than_asked() -> None:
    motion = pendulum().simulate(
        1.0, method="generalized-alpha", samples=3, rtol=1e9, max_step=0.01, progress=False
    )
    assert motion.statistics["steps"] >= 100


def test_prescribed_motions_are_followed_exactly() -> None:
    m = fx.Model()
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    r = m.angle("r")
    m.beam("arm", O, r, A, mass_per_length=3.0)
    m.prescribe("r.angle", lambda t: 2 * t + t * t)
    system = m.build()
    motion = system.simulate(1.0, method="generalized-alpha", samples=11, rtol=1e-6, progress=False)
    t = motion.t
    np.testing.assert_allclose(motion["r.angle"], 2 * t + t**2, atol=1e-12)
    end = motion[-1]
    # the driving moment is J φ'' = (3 / 3) 2
    assert end.force("r.angle") == pytest.approx(2.0, abs=0.05)
    assert end.rate("r.angle") == pytest.approx(4.0, abs=1e-3)


def test_an_interrupted_integration_keeps_what_was_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    system = pendulum()
    advance, calls = GeneralizedAlpha.advance, []

    def interrupted(self: GeneralizedAlpha, *arguments: object) -> object:
        calls.append(1)
        if len(calls) > 30:
            raise KeyboardInterrupt
        return advance(self, *arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(GeneralizedAlpha, "advance", interrupted)
    with pytest.raises(fx.Interrupted) as caught:
        system.simulate(1.0, method="generalized-alpha", samples=1001, max_step=1e-3, progress=False)
    motion = caught.value.motion
    assert "interrupted at t = 0.03" in motion.message
    assert len(motion) == 31


def test_a_motion_that_cannot_go_on_says_where_and_keeps_its_states() -> None:
    m = fx.Model()
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    m.truss("rod", O, A)
    m.point_mass("mass", A, 1.0)
    m.prescribe("A.y", lambda t: t)  # the rod of length 1 cannot reach further after 1 s
    system = m.build()
    with pytest.raises(fx.DynamicsError, match=r"cannot continue at t = (0\.99|1\b)") as caught:
        system.simulate(2.0, method="generalized-alpha", samples=201, progress=False)
    motion = caught.value.motion
    assert 0.98 < motion.t[-1] <= 1.0
    assert "cannot continue" in motion.message


@pytest.mark.parametrize("radius", [-0.1, 1.0, 2.0])
def test_a_spectral_radius_out_of_range_is_refused(radius: float) -> None:
    with pytest.raises(fx.ModelError, match="spectral_radius"):
        Scheme.with_radius(radius)


def test_a_law_on_slips_alone_brakes_an_implicit_motion() -> None:
    m = fx.Model()
    m.point("P", (0, 0))
    m.angle("heading")
    m.angle("spin", fixed=True)
    m.body("body", "P", "heading", mass=2.0, inertia=0.1)
    m.planar_wheel("skate", "P", "heading", "spin", radius=0.1)
    m.spring("skate.longitudinal", damping=3.0)
    m.initial("P.x", rate=1.0)
    end = m.build().simulate(1.0, method="generalized-alpha", rtol=1e-8, samples=2)[-1]
    assert end.rate("P.x") == pytest.approx(np.exp(-1.5), rel=1e-5)
