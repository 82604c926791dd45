"""Every motion is audited: its energy balance, events, contacts, prescribed rates, and the energies of its laws."""

import re
import warnings
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import sympy
from click.testing import CliRunner
from longer import longer
from mechanisms import heavy_top
from scipy.integrate import simpson

import flexel as fx
from flexel.apps.cli.check import check
from flexel.derive import Law, Parameter, symbol
from flexel.derive.user_definitions import compile_law
from flexel.integration.account import Account
from flexel.integration.dop853 import Dop853
from flexel.integration.imbalance import Imbalance

METHODS = ("DOP853", "Radau")  # in minimal coordinates
E, ED = symbol("e"), symbol("ed")


pytestmark = pytest.mark.usefixtures("cache")


def pendulum() -> fx.System:
    """A pendulum of 1 m that starts at 0.5 rad from the vertical."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("P", (np.sin(0.5), -np.cos(0.5)))
    m.truss("rod", "O", "P")
    m.point_mass("bob", "P", 1.0)
    return m.build()


def balance(motion: fx.Motion) -> tuple[float, float]:
    """Error of the energy balance, and the energy that moved, of the verdict [J]."""
    found = re.match(r"energy balance within (\S+) of (\S+) J", motion.verdict)
    assert found, motion.verdict
    return float(found[1]), float(found[2])


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_the_drift_of_a_conservative_system_is_told(method: str, rtol: float) -> None:
    """It is the drift of the energies of its states at the ends of all steps, in one digit."""
    system = pendulum()
    motion = system.simulate(10.0, method=method, rtol=rtol, atol=rtol / 100, samples=2)
    ends = np.unique([segment.t1 for segment in motion._segments])
    total = np.array([motion.at(t).energy.total for t in ends])
    drift = np.abs(total - motion[0].energy.total).max()
    found, moved = balance(motion)
    digit = 10.0 ** np.floor(np.log10(drift))
    assert abs(found - drift) < 0.51 * digit + 1e-14  # one digit is printed; rounding of the energies
    fall = 9.81 * (1 - np.cos(0.5))  # what drifts may move too
    assert moved == pytest.approx(fall, abs=0.02 * fall + drift)
    assert motion.warnings == () and motion.verdict in motion.message and motion.verdict in repr(motion)


def busy() -> fx.System:
    """A driven mass, which pulls another one by a spring and a damper, with a load on that one."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("P", (0.6, 0.8))
    m.point("Q", (1, 0))
    m.truss("rod", "O", "P")
    m.truss("strut", "P", "Q")
    m.point_mass("first", "P", 1.0)
    m.point_mass("second", "Q", 1.0)
    m.prescribe("P.x", lambda t: 0.6 + 0.2 * np.sin(3 * t))
    m.load("Q.y", lambda t: 2 * np.cos(2 * t))
    m.spring("strut.elongation", 1000, 2)
    return m.build()


@pytest.mark.parametrize("method", METHODS)
def test_drives_loads_and_dampers_are_in_the_balance(method: str) -> None:
    """The energy that moves is what they supply and take out, from the stored states by Simpson's rule."""
    motion = busy().simulate(4.0, method=method, rtol=1e-9, samples=4001)
    found, moved = balance(motion)
    assert found < 1e-8 * moved
    lost = np.array([state.dissipated for state in motion])
    driven = motion.force("P.x") * motion.rate("P.x")
    load = 2 * np.cos(2 * motion.t) * motion.rate("Q.y")
    change = simpson(driven + load - lost, x=motion.t)
    energy = motion.energy
    assert change == pytest.approx(energy["total"][-1] - energy["total"][0], abs=1e-6)
    signs = [simpson(np.abs(values), x=motion.t) for values in (lost, driven + load)]
    assert moved == pytest.approx(sum(signs), rel=0.05)


def small(amplitude: float) -> fx.System:
    """A unit mass on a spring, displaced by an amplitude [m]."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 1.0)
    m.spring("A.x", 900.0)
    m.initial("A.x", amplitude)
    return m.build()


def test_a_motion_that_is_worse_than_its_tolerance_says_so_and_what_to_give() -> None:
    """A vibration close to an absolute tolerance that is given loses energy; the default follows the motion."""
    system = small(1e-9)
    with pytest.warns(
        fx.AuditWarning, match=r"energy balance of DOP853 fails by .* J, most at t = .* smaller rtol and atol"
    ):
        motion = system.simulate(5.0, method="DOP853", atol=1e-11)
    assert len(motion.warnings) == 1 and motion.warnings[0] in motion.message
    exact = 1e-9 * np.cos(30 * motion.t)
    assert np.abs(motion["A.x"] - exact).max() > 1e-12  # it is in fact worse than rtol promises
    with pytest.warns(fx.AuditWarning, match="small beside the model"):
        (only,) = system.simulate(5.0, method="DOP853").warnings
    assert "rates cannot be known" in only


def test_rates_that_are_rounding_errors_do_not_move() -> None:
    """A mass without weight on a spring whose rest length is rounded: its energy is 1e-32 J."""
    motion = small(1e-16).simulate(1.0, method="DOP853")
    assert motion.warnings == () and "nothing has moved" in motion.verdict


def damped(loops: int) -> fx.System:
    """Parallelograms in series whose first crank has a damper and a load."""
    m = fx.Model(gravity=(0, -9.81))
    for i in range(loops + 1):
        m.point(f"O{i}", (i, 0), fixed=True)
        m.point(f"A{i}", (i, 1))
        m.beam(f"crank{i}", f"O{i}", m.angle(f"R{i}"), f"A{i}", mass_per_length=1.0)
    for i in range(loops):
        m.beam(f"coupler{i}", f"A{i}", m.angle(f"S{i}"), f"A{i + 1}", mass_per_length=1.0)
    m.spring("R0.angle", 2.0, 1.5)
    m.load("A0.x", lambda t: 3 * np.cos(2 * t))
    return m.build()


@pytest.mark.parametrize(("method", "rtol", "bound"), [("DOP853", 1e-9, 1e-8), ("Radau", 1e-8, 1e-7)])
@pytest.mark.parametrize("loops", longer([2, 3], 3))
def test_motions_across_change_points_are_balanced(
    loops: int, method: str, rtol: float, bound: float
) -> None:
    """What moves is what damper and load exchange, by Simpson's rule; a part of it is on the paths across."""
    system = damped(loops)
    start = system.state_at(rates={"A0.x": 5.0})
    motion = system.simulate(4.0, start=start, method=method, rtol=rtol, samples=4001)
    assert motion.statistics["carried"] >= 2 and motion.warnings == ()
    found, moved = balance(motion)
    assert found < bound * moved
    lost = 1.5 * motion.rate("R0.angle") ** 2
    load = 3 * np.cos(2 * motion.t) * motion.rate("A0.x")
    change = simpson(load - lost, x=motion.t)
    energy = motion.energy["total"]
    assert change == pytest.approx(energy[-1] - energy[0], abs=1e-5)
    assert simpson(lost, x=motion.t) > 0.1 * moved
    kinetic = motion.energy["kinetic"].max()
    exchanged = simpson(np.abs(load), x=motion.t) + simpson(lost, x=motion.t)
    assert moved == pytest.approx(max(kinetic, exchanged), rel=0.1)


def test_a_terminal_event_on_a_path_across_a_change_point_ends_its_balance() -> None:
    system = damped(2)
    start = system.state_at(rates={"A0.x": 5.0})
    event = fx.Event("low", lambda s: s["A0.y"] + 0.02, terminal=True)
    motion = system.simulate(4.0, start=start, method="DOP853", events=[event])
    assert motion.statistics["carried"] == 1
    found, moved = balance(motion)
    assert found < 1e-8 * moved


@pytest.mark.filterwarnings("ignore:.*energy balance of DOP853 fails by")
def test_energy_that_rounding_changes_between_steps_is_missing_too() -> None:
    """Of a stretched four-bar, which moves by 1e-4 rad about its flat position: its degree of freedom changes a hundred
    times, and steps that are found again from a more exact position."""
    m = fx.Model(gravity=(0, 0))
    places = ((0, 0), (1, 1e-4), (2.25, -5e-5), (3.25, 0))
    for name, place in zip("OABC", places, strict=True):
        m.point(name, place, fixed=name in "OC")
    for first, second in ("OA", "AB", "BC"):
        m.truss(first + second, first, second)
    m.point_mass("a", "A", 1.0)
    m.point_mass("b", "B", 2.0)
    system = m.build()
    start = system.state_at(rates=dict.fromkeys(system.dynamic, 3.0))
    motion = system.simulate(0.005, start=start, samples=2, method="DOP853", rtol=1e-10, atol=1e-12)
    missing = abs(motion[-1].energy.total - motion[0].energy.total)
    found, _ = balance(motion)
    assert motion.statistics["rechoices"] > 50
    assert missing > 1e-9
    assert found > missing / 2


def sprung(factor: float) -> fx.System:
    """A mass on a spring whose law states `factor` times the energy that it stores."""
    k = Parameter("k", 1, "N/m", "stiffness")
    law = compile_law(
        Law(
            "elastic",
            "a spring",
            (k,),
            (E,),
            (ED,),
            (),
            (k.symbol * E,),
            (),
            factor * k.symbol * E**2 / 2,
            "own",
        )
    )
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.fix("A.y")
    m.truss("bar", "O", "A")
    m.point_mass("mass", "A", 1.0)
    m.law(["bar.elongation"], law, name="strange", k=100.0)
    m.initial("A.x", 1.1)
    return m.build()


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_a_law_with_a_wrong_energy_is_named(method: str) -> None:
    assert sprung(1).simulate(2.0, method=method).warnings == ()
    with pytest.warns(
        fx.AuditWarning, match="energy of law 'strange' on 'bar.elongation' is not that of its"
    ):
        motion = sprung(2).simulate(2.0, method=method)
    assert np.ptp(motion.energy["total"]) > 0.1  # it is 0.5 J in truth


def flying(speed: float) -> fx.System:
    """A mass that flies along x with a speed [m/s], and one on a soft spring that makes steps short or long."""
    m = fx.Model()
    m.point("A", (0, 0))
    m.point_mass("mass", "A", 1.0)
    m.fix("A.y")
    m.initial("A.x", rate=speed)
    return m.build()


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_an_event_that_jumps_and_is_passed_is_named(method: str) -> None:
    """A gate of 15 mm between the samples in steps of 0.1 m; its function is 1 within and -1 outside."""

    def gate(begin: float) -> fx.Event:
        return fx.Event("gate", lambda s: 1.0 if begin < s["A.x"] < begin + 0.015 else -1.0)

    system = flying(1.0)
    with pytest.warns(fx.AuditWarning, match=r"event 'gate' was missed: its function is 1 at t = 0\.5[34]"):
        motion = system.simulate(1.0, max_step=0.1, method=method, samples=3, events=[gate(0.53)])
    assert motion.events == [] and "; 0 events" in motion.verdict
    fine = system.simulate(1.0, max_step=0.015, method=method, samples=3, events=[gate(0.53)])
    assert fine.warnings == () and len(fine.events) == 2
    if method != "DOP853":  # a step ends at each stored state
        return
    with pytest.warns(fx.AuditWarning, match="event 'gate' was missed"):  # a stored state is within it
        system.simulate(1.0, max_step=0.1, method=method, times=[0.0, 0.54, 1.0], events=[gate(0.53)])


def test_events_that_are_reported_contradict_nothing() -> None:
    """Distances, one direction alone, and two crossings within a step."""
    events = [
        fx.Event("down", lambda s: s["P.x"], direction=-1),
        fx.Event("both", lambda s: s["P.x"]),
        fx.Event("gate", lambda s: abs(s["P.x"]) - 5e-3),
    ]
    motion = pendulum().simulate(8.0, method="DOP853", rtol=1e-7, events=events)
    assert len(motion.events) > 20 and motion.warnings == ()


def thrown() -> fx.System:
    """A ball that flies at 10 m/s towards a plate of 10 mm."""
    m = fx.Model()
    m.point("axle", (0, 0), fixed=True)
    m.angle("R", fixed=True)
    m.sheave("plate", "axle", "R", radius=0.005)
    m.point("ball", (1e-4, 1.0))
    m.fix("ball.x")
    m.point_mass("mass", "ball", 1.0)
    m.initial("ball.y", rate=-10.0)
    m.contact("touch", "ball", "plate", fx.Contact(1e9, per="point"), radius=0.005)
    return m.build()


def test_a_contact_that_long_steps_pass_is_named() -> None:
    with pytest.warns(
        fx.AuditWarning,
        match=r"contact 'touch\.gap' was passed within one step at t = 0\.1 s, by .* m: .* shorter steps",
    ):
        motion = thrown().simulate(0.2, method="generalized-alpha", step=8e-3, samples=2)
    assert motion["ball.y"][-1] == pytest.approx(-1.0)  # it has flown through
    assert "1 contact passed" in motion.verdict
    depth = float(re.search(r", by (\S+) m", motion.warnings[0])[1])  # type: ignore[index]
    assert depth == pytest.approx(0.0099, rel=0.02)
    seen = thrown().simulate(0.2, method="generalized-alpha")
    assert seen.warnings == () and "no contact passed" in seen.verdict and seen["ball.y"][-1] > 0


Function = tuple[object, object, object]


def follower(triple: object) -> fx.System:
    """A mass whose place is prescribed."""
    m = fx.Model()
    m.point("P", (0, 0))
    m.fix("P.y")
    m.point("Q", (5, 0))
    m.fix("Q.y")
    m.truss("spring", "P", "Q", stiffness=1.0)
    m.point_mass("mass", "Q", 1.0)
    m.prescribe("P.x", triple)  # type: ignore[arg-type]
    return m.build()


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_rates_that_are_a_little_wrong_are_named(method: str) -> None:
    """Two per cent, which no difference finds beyond doubt, but the place at the end."""
    wrong = (lambda t: t**2, lambda t: 1.96 * t, lambda t: 1.96)
    with pytest.warns(
        fx.AuditWarning,
        match=r"'P\.x': from t = 0 s to 2 s its prescribed value u changes by 4, .* u' is 3\.92",
    ):
        follower(wrong).simulate(2.0, method=method, samples=5)
    right = (lambda t: t**2, lambda t: 2 * t, lambda t: 2.0)
    assert follower(right).simulate(2.0, method=method, samples=5).warnings == ()


@pytest.mark.parametrize("corner", [1e-2, 1e-3])
def test_short_rounded_corners_are_no_wrong_rates(corner: float) -> None:
    """A ramp that begins and ends within this time [s] of a motion of 2 s: its second rate is a short pulse."""

    def ramp(order: int, t: float) -> float:
        part = min(max((t - 0.3) / corner, 0.0), 1.0)
        rounded = (
            corner * (part**3 - part**4 / 2) + max(t - 0.3 - corner, 0.0),
            3 * part**2 - 2 * part**3,
            6 * part * (1 - part) / corner,
        )
        return rounded[order]

    right = tuple(partial(ramp, order) for order in range(3))
    assert follower(right).simulate(2.0, samples=5).warnings == ()
    wrong = (right[0], lambda t: 1.01 * right[1](t), lambda t: 1.01 * right[2](t))
    with pytest.warns(fx.AuditWarning, match=r"its prescribed value u changes by .* integral of the rate u'"):
        follower(wrong).simulate(2.0, samples=5)


def test_a_rate_that_jumps_without_its_impulse_is_named() -> None:
    """In a triple nothing tells that the rate jumps; one function of t does."""

    def kinked(t: float) -> float:
        return np.minimum(t, 1.0)

    triple = (kinked, lambda t: float(t < 1), lambda t: 0.0)
    with pytest.warns(
        fx.AuditWarning, match=r"its prescribed rate u' changes by -1, but the integral .* is 0"
    ):
        follower(triple).simulate(2.0, samples=5, method="generalized-alpha")
    assert follower(kinked).simulate(2.0, samples=5).warnings == ()


def test_beams_bent_too_far_are_kept_with_the_motion() -> None:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.angle("A", fixed=True)
    m.point("P", (1, 0))
    m.angle("B")
    m.beam("leaf", "O", "A", "P", "B", EIz=1.0, EA=1e3, mass_per_length=0.1)
    m.load("P.y", 2.0)
    with pytest.warns(fx.RangeWarning, match="'leaf' is bent by") as said:
        motion = m.build().simulate(2.0, samples=21)
    assert [f"simulate: {warning}" for warning in motion.warnings] == [
        str(warning.message) for warning in said
    ]
    share = re.search(r"elements at (\S+) % of their ranges at most", motion.verdict)
    chord = np.unwrap(np.arctan2(motion["P.y"], motion["P.x"]))
    turned = np.degrees(np.abs(chord) + np.abs(motion["B.angle"] - chord))
    assert share and float(share[1]) == pytest.approx(turned.max() / 15 * 100, rel=5e-3)  # three digits


def test_a_file_keeps_the_audit_and_a_command_prints_it(tmp_path: Path) -> None:
    """The exit status of `flexel check` is 1 where there are warnings."""
    good = pendulum().simulate(1.0)
    with pytest.warns(fx.AuditWarning):
        bad = sprung(2).simulate(2.0, method="DOP853")
    for name, motion, status in (("good.npz", good, 0), ("bad.csv", bad, 1)):
        assert fx.load(motion.save(tmp_path / name)).verdict == motion.verdict  # type: ignore[union-attr]
        answer = CliRunner().invoke(check, [str(tmp_path / name)])
        assert answer.exit_code == status
        assert answer.output.splitlines() == [
            motion.verdict,
            *(f"warning: {line}" for line in motion.warnings),
        ]
    lin = tmp_path / "lin.npz"
    system = pendulum()
    system.linearize(system.initial).save(lin)
    assert "contains a Linearization, not a motion" in CliRunner().invoke(check, [str(lin)]).output


def test_variants_in_lanes_are_balanced() -> None:
    """Its tolerance is no alarm for any of them, and the last one says how large the error is."""
    system = pendulum()
    values = {"bob.mass": np.linspace(0.5, 2.0, 9)}
    found = system.simulate_many(2.0, parameters=values, samples=5, rtol=1e-4, atol=1e-6, threads=1)
    assert not found.failed
    error, moved = balance(found.motion(0))
    assert 1e-9 < error < 1e-3 * moved


@pytest.mark.parametrize("mass", [10.0, 15.0])
def test_the_energies_of_a_variant_are_those_of_a_model_with_its_values(mass: float) -> None:
    """They had contained body forces from an earlier position; the motion of its variant never did."""
    system = heavy_top()
    parameters = {"body.mass": [mass, 20.0]}
    found = system.simulate_many(0.5, parameters=parameters, samples=5, method="DOP853", threads=1)
    total = found.motion(0).energy["total"]
    assert not found.failed
    assert np.ptp(total) < 1e-6 * total[0]


def test_a_wheel_that_falls_flat_is_named() -> None:
    """A hoop that is tipped over sideways: beyond, its hub would go through the road; upright it rolls on."""
    m = fx.Model(gravity=(0, 0, -9.81))
    hub, contact, frame = m.point("hub", (0, 0, 0.2)), m.point("contact", (0, 0, 0)), m.frame("rim")
    m.wheel("hoop", hub, frame, contact, radius=0.2, axle=(0, 1, 0))
    m.body("mass", hub, frame, mass=1.0, inertia=(0.02, 0.04, 0.02))
    rates = m.angular_velocity(frame)
    m.initial(f"{rates}.wx", rate=2.0)
    system = m.build()
    with pytest.warns(
        fx.AuditWarning, match=r"wheel 'hoop' has fallen flat: at t = 0\.[3-6]\d* s its hub is below"
    ):
        motion = system.simulate(0.7)
    assert motion["hub.z"].min() < -0.1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.simulate(0.2)


@pytest.mark.parametrize(
    "law",
    [
        lambda e: -1e5 * sympy.Max(0, -0.5 - e) ** 1.5,
        lambda e: -1e5 * sympy.Piecewise(((-0.5 - e) ** sympy.Rational(5, 2), e < -0.5), (0, True)),
        lambda e: -1e4 * sympy.Max(0, -0.5 - e) ** 2,
    ],
)
def test_the_energy_of_a_one_sided_power_is_known_on_the_other_side(law: Callable[[object], object]) -> None:
    """190 of 201 energies were not numbers, and the balance was zero; or a warning compared rounding with 0 W."""
    m = fx.Model(gravity=(0, -9.81))
    m.truss("t", m.point("O", (0, -10), fixed=True), m.point("A", (0, 0.5)))
    m.fix("A.x")
    m.point_mass("ball", "A", 1.0)
    m.spring("t.elongation", law)
    motion = m.build().simulate(3.0)
    total = motion.energy["total"]
    assert np.ptp(total) < 2e-6 and np.min(motion.energy["strain"]) > -1e-9
    assert motion.warnings == () and "within 0 of" not in motion.verdict


def test_energies_that_are_not_numbers_are_no_balance() -> None:
    balance = Imbalance(np.inf, 1.0, 1.0, 0.0)
    assert balance.fails and str(balance) == "energy balance within inf of 1 J"
    account = Account(Dop853.quadrature)
    account.struct.energy = np.nan
    account.accept(0.1)
    assert account.struct.farthest == np.inf
