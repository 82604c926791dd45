"""Closed loops: Cardan joint, four-bars in plane and space, slider-cranks, a hydraulic cylinder, redundancy."""

import json
from pathlib import Path

import numpy as np
import pytest
from differences import Knob
from mechanisms import rssr
from scipy.optimize import brentq

from flexel.base.errors import ConstraintError
from flexel.examples.published import published
from flexel.parts.model import Model

DATA = Path(__file__).parent.parent / "data"


HOOKE = published("hooke_joint")


def cardan(beta: float, J1: float = 0.3, J2: float = 0.5) -> Model:
    """Two shafts at an angle β and the cross between them, a closed loop of four hinges.

    At rest the driving pin lies in the plane of the shafts (convention A).
    """
    m = Model()
    O = m.point("O", (0, 0, 0), fixed=True)
    ground, one, cross, two = (
        m.frame(name, fixed=name == "ground") for name in ("ground", "one", "cross", "two")
    )
    out = np.array([np.cos(beta), np.sin(beta), 0.0])
    m.hinge("drive", ground, one, axis=(1, 0, 0))
    m.hinge("pin1", one, cross, axis=(0, 1, 0))
    m.hinge("pin2", cross, two, axis=(0, 0, 1))
    m.hinge("driven", ground, two, axis=out)
    m.body("rotor1", O, one, mass=1.0, inertia=(J1, J1, J1))
    m.body("rotor2", O, two, mass=1.0, inertia=(J2, J2, J2))
    return m


@pytest.mark.parametrize("row", HOOKE["table_beta30_convA"], ids=lambda row: f"{row['theta1_deg']} deg")
def test_cardan_joint_transmits_by_its_closed_form_ratio(row: dict) -> None:
    theta1 = np.deg2rad(row["theta1_deg"])
    m = cardan(np.pi / 6)
    m.prescribe("drive.angle", Knob(theta1, 2.0, 0.0))
    state = m.build().initial
    assert abs(np.rad2deg(state["driven.angle"]) - row["theta2_deg"]) < 1e-12 * 90
    assert abs(state.rate("driven.angle") / 2.0 - row["ratio"]) < 1e-12
    assert abs(state.acceleration("driven.angle") / 4.0 - row["theta2dd_over_w1sq"]) < 1e-12


def test_cardan_joint_keeps_its_ratio_over_many_turns() -> None:
    beta = 0.7
    m = cardan(beta)
    m.prescribe("drive.angle", lambda t: 30.0 * t)
    motion = m.build().simulate(2.0, samples=61)  # one radian a sample
    theta = 30.0 * motion.t
    turns = np.unwrap(np.arctan2(np.sin(theta), np.cos(theta) * np.cos(beta)))
    assert np.max(np.abs(motion["driven.angle"] - turns)) < 1e-11
    ratio = np.cos(beta) / (1 - np.sin(beta) ** 2 * np.cos(theta) ** 2)
    assert np.max(np.abs(motion.rate("driven.angle") / 30.0 - ratio)) < 1e-11


def test_cardan_driven_freely_follows_its_energy_integral() -> None:
    reference = HOOKE["free_run_reference"]
    beta = np.deg2rad(reference["beta_deg"])
    m = cardan(beta, reference["J1"], reference["J2"])
    m.independent("drive.angle")
    m.initial("drive.angle", rate=reference["w1_0"])
    rows = reference["rows"]
    motion = m.build().simulate(rows[-1]["t"], times=[row["t"] for row in rows], rtol=1e-12, atol=1e-13)
    for state, row in zip(motion, rows, strict=True):
        assert abs(state["drive.angle"] - row["theta1"]) < 1e-9
        assert abs(state.rate("drive.angle") - row["w1"]) < 2e-9
        ratio = np.cos(beta) / (1 - np.sin(beta) ** 2 * np.cos(state["drive.angle"]) ** 2)
        exact = np.sqrt(2 * motion.energy["total"][0] / (reference["J1"] + reference["J2"] * ratio**2))
        assert abs(state.rate("drive.angle") - exact) < 1e-10
    assert np.ptp(motion.energy["total"]) < 1e-11 * motion.energy["total"][0]


def test_cardan_transmits_power_torque_by_the_inverse_ratio() -> None:
    """Without inertia to speak of, T2 = T1 ω1 / ω2."""
    theta1, beta = 0.6, np.pi / 6
    m = cardan(beta)
    m.prescribe("drive.angle", theta1)
    m.load("driven.angle", 3.0)
    state = m.build().initial
    ratio = np.cos(beta) / (1 - np.sin(beta) ** 2 * np.cos(theta1) ** 2)
    assert abs(-state.force("drive.angle") + 3.0 * ratio) < 1e-12


LINKS = (2.0, 0.8, 2.4, 1.5)  # ground, crank, coupler, rocker


def four_bar_points() -> tuple[np.ndarray, np.ndarray]:
    """Upper joints of the drawn four-bar, crank at 60 degrees."""
    a, b, c, d = LINKS
    B = b * np.array([np.cos(np.pi / 3), np.sin(np.pi / 3)])
    r = np.array([a, 0.0]) - B
    l = np.hypot(*r)
    along = (c * c - d * d + l * l) / (2 * l)
    return B, B + along * r / l + np.sqrt(c * c - along**2) * np.array([-r[1], r[0]]) / l


def planar_four_bar() -> Model:
    B, C = four_bar_points()
    m = Model(gravity=(0, -9.81))
    A0, D0 = m.point("A", (0, 0), fixed=True), m.point("D", (LINKS[0], 0), fixed=True)
    b, c = m.point("B", B), m.point("C", C)
    ground, crank, rocker = m.angle("ground", fixed=True), m.angle("crank"), m.angle("rocker")
    coupler = m.angle("coupler")
    m.hinge("input", ground, crank)
    m.hinge("output", ground, rocker)
    m.beam("crank bar", A0, crank, b, mass_per_length=1.0)
    m.beam("coupler bar", b, coupler, c, mass_per_length=2.0)
    m.beam("rocker bar", D0, rocker, c, mass_per_length=1.5)
    m.independent("input.angle")
    m.initial("input.angle", 0.0, rate=3.0)
    return m


def spatial_four_bar(release: tuple[str, ...] = ()) -> Model:
    """The same of hinges in space: 3 x 3 turns and 6 coordinates, 8 + 9 conditions, three of them repeated."""
    B, C = (np.append(point, 0.0) for point in four_bar_points())
    m = Model(gravity=(0, -9.81, 0))
    A0, D0 = m.point("A", (0, 0, 0), fixed=True), m.point("D", (LINKS[0], 0, 0), fixed=True)
    b, c = m.point("B", B), m.point("C", C)
    ground, crank, coupler, rocker = (
        m.frame(name, fixed=name == "g") for name in ("g", "crank", "coupler", "rocker")
    )
    axis = (0, 0, 1)
    m.hinge("input", ground, crank, axis=axis)
    m.hinge("joint B", crank, coupler, axis=axis)
    m.hinge("joint C", coupler, rocker, axis=axis)
    m.hinge("output", ground, rocker, axis=axis)
    m.beam("crank bar", A0, crank, b, mass_per_length=1.0)
    m.beam("coupler bar", b, coupler, c, mass_per_length=2.0)
    m.beam("rocker bar", D0, rocker, c, mass_per_length=1.5)
    m.release(*release)
    m.independent("input.angle")
    m.initial("input.angle", 0.0, rate=3.0)
    return m


def freudenstein(crank: float) -> float:
    """Angle of the rocker for an angle of the crank, on the drawn branch."""
    a, b, c, d = LINKS
    B = b * np.array([np.cos(crank), np.sin(crank)])
    r = np.array([a, 0.0]) - B
    l = np.hypot(*r)
    along = (c * c - d * d + l * l) / (2 * l)
    C = B + along * r / l + np.sqrt(c * c - along**2) * np.array([-r[1], r[0]]) / l
    return float(np.arctan2(C[1], C[0] - a))


def test_planar_four_bar_closes_and_keeps_its_energy_over_full_turns() -> None:
    motion = planar_four_bar().build().simulate(4.0, samples=161, rtol=1e-11, atol=1e-12)
    drawn = freudenstein(np.pi / 3)
    turned = np.array([freudenstein(np.pi / 3 + angle) for angle in motion["input.angle"]]) - drawn
    assert np.max(np.abs(motion["output.angle"] - turned)) < 1e-11
    assert np.ptp(motion["input.angle"]) > 2 * np.pi
    E = motion.energy["total"]
    assert np.ptp(E) < 1e-9 * np.max(motion.energy["kinetic"])


def test_four_bar_of_spatial_hinges_is_over_constrained_and_named() -> None:
    with pytest.raises(ConstraintError, match="over-constrained: 3 ") as caught:
        spatial_four_bar().build()
    text = str(caught.value)
    assert "'joint B.bend1'" in text or "'joint C.bend1'" in text or "'output.bend1'" in text
    assert "m.release(" in text
    assert "norm" not in text


def test_one_redundant_condition_is_named_and_its_release_mends_the_model() -> None:
    two = ("joint C.bend1", "joint C.bend2")
    with pytest.raises(ConstraintError, match="over-constrained: 1 ") as caught:
        spatial_four_bar(two).build()
    remedy = str(caught.value).split("m.release('")[1].split("'")[0]
    spatial = spatial_four_bar((*two, remedy)).build()
    planar = planar_four_bar().build()
    assert (
        abs(spatial.initial.acceleration("input.angle") - planar.initial.acceleration("input.angle")) < 1e-11
    )
    a, b = (s.simulate(1.0, samples=11, rtol=1e-11, atol=1e-12) for s in (spatial, planar))
    assert np.max(np.abs(a["output.angle"] - b["output.angle"])) < 1e-10
    assert np.max(np.abs(a.position("C")[:, 2])) < 1e-13


@pytest.mark.parametrize("universal", [False, True], ids=["two ball joints", "ball and universal joint"])
def test_spatial_four_bar_closes_its_loop(universal: bool) -> None:
    """|B(θ) - C(φ)| = L is solved independently for the rocker angle."""
    motion = rssr(universal).build().simulate(1.0, samples=21, rtol=1e-11, atol=1e-12)
    D, C0, axis = np.array([1.5, 0.3, 0.2]), np.array([1.4, 0.9, 0.9]), np.array([1, 0.2, -0.1])
    axis = axis / np.linalg.norm(axis)
    L = np.sqrt(1 + 0.81 + 0.81)

    def rocker(phi: float) -> np.ndarray:
        r = C0 - D
        return D + r * np.cos(phi) + np.cross(axis, r) * np.sin(phi) + axis * (axis @ r) * (1 - np.cos(phi))

    for state in motion:
        theta, phi = state["input.angle"], state["output.angle"]
        B = 0.4 * np.array([np.cos(theta), np.sin(theta), 0])
        gap = lambda angle, B=B: np.linalg.norm(rocker(angle) - B) - L  # noqa: E731
        assert abs(brentq(gap, phi - 0.05, phi + 0.05, xtol=1e-15) - phi) < 1e-12
    E = motion.energy["total"]
    assert np.ptp(E) < 1e-9 * np.ptp(motion.energy["kinetic"])


def test_the_slender_coupler_moves_alike_between_balls_and_with_a_universal_joint() -> None:
    """A rod without rotary inertia does not feel which way it may not turn about itself."""
    a, b = (
        rssr(universal).build().simulate(0.8, samples=5, rtol=1e-11, atol=1e-12)
        for universal in (False, True)
    )
    assert np.max(np.abs(a["output.angle"] - b["output.angle"])) < 1e-10


def test_spatial_slider_crank_follows_the_iftomm_reference() -> None:
    data = json.loads((DATA / "iftomm_slidercrank3d.json").read_text())
    p, rows = data["data"], data["reference"]
    m = Model(gravity=p["gravity"])
    start = np.array([0, p["yA"], p["zA"]])
    elbow = start + [0, 0, p["l_crank"]]
    slide = np.array([rows[0]["slider_x"], 0, 0])
    A0, B, S = m.point("A", start, fixed=True), m.point("B", elbow), m.point("S", slide)
    m.fix("S.y", "S.z")
    ground, crank, cross, rod = (
        m.frame(name, fixed=name == "ground") for name in ("ground", "crank", "cross", "rod")
    )
    m.hinge("crank hinge", ground, crank, axis=(1, 0, 0))
    m.hinge("slider fork", ground, cross, axis=(1, 0, 0))
    m.hinge("rod fork", cross, rod, axis=(0, 2, -1))
    m.beam("crank bar", A0, crank, B)
    m.beam("rod bar", B, rod, S)
    m.body("crank body", A0, crank, mass=p["m"][0], inertia=p["J_crank"], offset=(elbow - start) / 2)
    u = (slide - elbow) / p["l_rod"]
    axial, across = p["J_rod_axial_first"][:2]
    J = across * np.eye(3) + (axial - across) * np.outer(u, u)
    m.body("rod body", B, rod, mass=p["m"][1], inertia=J, offset=(slide - elbow) / 2)
    m.point_mass("slider", S, p["m"][2])
    m.independent("crank hinge.angle")
    m.initial("crank hinge.angle", rate=p["crank_omega0"])
    s = m.build()
    assert np.max(np.abs(omega(s, rod) - [1.92, -0.96, 0.48])) < 1e-12
    motion = s.simulate(rows[-1]["t"], times=[row["t"] for row in rows], rtol=1e-11, atol=1e-12)
    for state, row in zip(motion, rows, strict=True):
        assert abs(state["S.x"] - row["slider_x"]) < 1e-7
        assert abs(state.rate("S.x") - row["slider_v"]) < 1e-6
        assert abs(state["crank hinge.angle"] - row["crank_angle"]) < 1e-6
        assert np.max(np.abs((state.position("B") + state.position("S")) / 2 - row["rod_com"])) < 1e-7
    assert np.ptp(motion.energy["total"]) < 1e-9


def omega(s, rod):  # noqa: ANN001, ANN201
    """Angular velocity of a frame from its Euler parameters and their rates."""
    (a, *u), (da, *du) = s.initial.position(rod.name), s.initial.velocity(rod.name)
    u, du = np.array(u), np.array(du)
    return 2 * (a * du - da * u - np.cross(du, u))
