"""The rolling disc: nonlinear motion, steady circles, the speed at which it stays upright."""

import json
from pathlib import Path

import numpy as np
import pytest
from mechanisms import disc

DATA = json.loads((Path(__file__).parent.parent / "data" / "rolling_disc.json").read_text())
P = DATA["data"]


@pytest.mark.parametrize("case", DATA["nonlinear_cases"], ids=lambda c: c["name"][0])
def test_disc_follows_the_reference(case: dict) -> None:
    psi, theta, phi, psid, thetad, omega3, x, y = case["y0"]
    rows = case["reference"]
    s = disc(theta, (psid, thetad, omega3)).build()
    motion = s.simulate(rows[-1]["t"], times=[row["t"] for row in rows], rtol=1e-12, atol=1e-12)
    hub0 = motion[0].position("hub")
    for state, row in zip(motion, rows, strict=True):
        lean = state["lean.angle"] + np.pi / 2
        computed = [state["yaw.angle"], lean, state["roll.angle"], state.rate("yaw.angle")]
        computed += [state.rate("lean.angle"), state.rate("roll.angle") + computed[3] * np.cos(lean)]
        reference = [row[key] for key in ("psi", "theta", "phi", "psid", "thetad", "omega3")]
        assert np.max(np.abs(np.array(computed) - reference)) < 1e-9
        moved = (state.position("hub") - hub0)[:2]
        assert np.max(np.abs(moved - [row["x"], row["y"]])) < 1e-9
    E = motion.energy["total"]
    assert np.ptp(E) < 1e-10 * E[0]
    assert np.max(motion.drift) < 1e-12


def test_disc_runs_upright_above_the_critical_speed() -> None:
    """v² = It m g r³ / (Ia (Ia + m r²)); the lean-and-yaw motion swings with the closed-form frequency."""
    It, Ia, mr2 = P["It"], P["Ia"], P["m"] * P["r"] ** 2
    critical = np.sqrt(It * P["m"] * P["g"] * P["r"] ** 3 / (Ia * (Ia + mr2)))
    assert abs(critical - np.sqrt(P["g"] * P["r"] / 3)) < 1e-14
    for v in (0.0, 0.5 * critical, 0.999 * critical, 1.001 * critical, 4 * critical):
        lin = disc(rates=(0.0, 0.0, v / P["r"])).build().linearize()
        square = (Ia * (Ia + mr2) * (v / P["r"]) ** 2 / It - P["m"] * P["g"] * P["r"]) / (It + mr2)
        root = np.sqrt(complex(-square))
        w = lin.eigenvalues()
        assert min(abs(w - root)) < 1e-11
        assert min(abs(w + root)) < 1e-11
        # lean'' with yaw' eliminated: det of the lean equation vanishes at the critical speed
        i = [lin.dynamic.index(name) for name in ("yaw.angle", "lean.angle", "roll.angle")]
        assert abs(lin.M[i[1], i[1]] - (It + mr2)) < 1e-13
        assert abs(lin.K[i[1], i[1]] + P["m"] * P["g"] * P["r"]) < 1e-12


def test_disc_spinning_on_the_spot_stays_upright_above_its_critical_rate() -> None:
    """About a vertical diameter at rest: ω² = ψ'² - m g r / (It + m r²)."""
    It, mr2 = P["It"], P["m"] * P["r"] ** 2
    for rate in (3.0, 9.0):
        w = disc(rates=(rate, 0.0, 0.0)).build().linearize().eigenvalues()
        square = rate**2 - P["m"] * P["g"] * P["r"] / (It + mr2)
        assert min(abs(w - np.sqrt(complex(-square)))) < 1e-11


def test_disc_on_a_steady_circle_is_found_and_linearized() -> None:
    example = DATA["steady_example"]
    theta = np.deg2rad(example["theta_deg"])
    m = disc(theta + 0.02, (example["psid"], 0.0, example["omega3"]))
    s = m.build()
    spin = example["omega3"] - example["psid"] * np.cos(theta)
    steady = s.steady(
        rates={"yaw.angle": example["psid"], "roll.angle": spin, "lean.angle": 0}, unknown=["lean.angle"]
    )
    assert abs(steady["lean.angle"] + np.pi / 2 - theta) < 1e-12
    for name in s.dynamic:
        assert abs(steady.acceleration(name)) < 1e-11
    centre_speed = np.linalg.norm(steady.velocity("hub"))
    assert abs(centre_speed / example["psid"] - example["centre_path_radius"]) < 1e-11
    frequency = max(complex(value).imag for value in example["eigenvalues"])
    assert min(abs(s.linearize(steady).eigenvalues() - 1j * frequency)) < 1e-9
    # wheel-road forces: weight, and centripetal force towards the centre of the circle
    assert abs(steady.force("wheel.surface")) - P["m"] * P["g"] < 1e-11
    motion = s.simulate(3.0, start=steady, samples=7, rtol=1e-12, atol=1e-12)
    assert np.max(np.abs(motion["lean.angle"] - steady["lean.angle"])) < 1e-10


def test_rolling_friction_does_no_work_but_changes_the_path() -> None:
    """The wheel's contact point never slips: its slips and their powers stay zero."""
    s = disc(1.2, (1.0, 0.2, 6.0)).build()
    motion = s.simulate(2.0, samples=41, rtol=1e-11, atol=1e-11)
    for slip in ("wheel.longitudinal", "wheel.lateral"):
        assert np.max(np.abs(motion.rate(slip))) < 1e-13
        assert np.max(np.abs(motion.force(slip))) > 0.1
    assert np.ptp(motion.energy["total"]) < 1e-10 * motion.energy["total"][0]
