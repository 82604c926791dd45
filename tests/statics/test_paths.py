"""Load paths of shallow arches: many folds, and other equilibria close by."""

import numpy as np
import pytest
from coarse import COARSE_MESH

import flexel as fx
from flexel.mechanics.arclength import Arcs
from flexel.statics import load_path

ELEMENTS = 16
SPAN, EI = 1.0, 1.0


def arch(rise: float, slenderness: float, moment: float) -> fx.System:
    """A hinged arch in the shape of half a sine; a small moment at its crown keeps curves from crossing."""
    m = fx.Model(gravity=(0.0, 0.0))
    for i, x in enumerate(np.linspace(0, SPAN, ELEMENTS + 1)):
        m.point(f"p{i}", (x, rise * np.sin(np.pi * x / SPAN)), fixed=i in (0, ELEMENTS))
        m.angle(f"a{i}")
    for i in range(ELEMENTS):
        m.beam(f"b{i}", f"p{i}", f"a{i}", f"p{i + 1}", f"a{i + 1}", EA=EI * slenderness**2, EIz=EI)
    middle = ELEMENTS // 2
    m.load(f"p{middle}.y", lambda t: -t)
    m.load(f"a{middle}.angle", lambda t: -moment * t)
    return m.build()


def limits(path: fx.Motion) -> np.ndarray:
    """Loads at the folds, in order."""
    t = path.t
    turns = np.diff(t)[:-1] * np.diff(t)[1:] < 0
    return t[1:-1][turns]


@COARSE_MESH
@pytest.mark.parametrize(
    ("rise", "slenderness", "load"), [(0.05, 1000.0, 360.0), (0.1, 300.0, 660.0), (0.05, 300.0, 360.0)]
)
def test_a_path_passes_every_fold_in_long_steps_as_in_short_ones(
    rise: float, slenderness: float, load: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Reference: the same equations in steps ten times shorter (own)."""
    s = arch(rise, slenderness, 0.01)
    path = s.static_path(t_end=load)
    assert path.message == ""
    monkeypatch.setattr(load_path, "ARCS", Arcs(first=0.05, largest=0.05, smallest=1e-7, steps=6000))
    fine = s.static_path(t_end=load)
    assert limits(path).size == limits(fine).size
    np.testing.assert_allclose(limits(path), limits(fine), rtol=0, atol=0.02 * np.abs(limits(fine)).max())
    assert path["p8.y"][-1] == pytest.approx(fine["p8.y"][-1], rel=1e-9)


@COARSE_MESH
@pytest.mark.long
def test_a_symmetric_arch_stays_symmetric_where_curves_cross() -> None:
    with pytest.warns(fx.UnstableWarning, match="other paths of equilibria branch off"):
        path = arch(0.1, 300.0, 0.0).static_path(t_end=660.0)
    with pytest.warns(fx.UnstableWarning, match="other paths of equilibria branch off"):
        skew = arch(0.1, 300.0, 1e-9).static_path(t_end=660.0)
    assert path.message == "" and path.verdict.endswith("equilibria are unstable")
    np.testing.assert_allclose(path["p4.y"], path["p12.y"], atol=1e-9)
    assert skew["p8.y"][-1] == pytest.approx(path["p8.y"][-1], rel=1e-6)  # with the same end, by another way


def cosine_beam(imperfection: float) -> tuple[fx.Model, float, float]:
    """A clamped cosine beam of 32 elements, ten times as high [m] as thick, and E I h/L³ [N]."""
    L, width, thick, high, E, n = 0.1, 5e-3, 0.5e-3, 5e-3, 2e9, 32
    inertia = width * thick**3 / 12
    m = fx.Model()
    for i in range(n + 1):
        u = i / n
        y = high / 2 * (1 + np.cos(2 * np.pi * (u - 0.5))) + imperfection * (1 - np.cos(4 * np.pi * u))
        m.point(f"P{i}", (L * u, y))
        m.angle(f"R{i}")
    for i in range(n):
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, EA=E * width * thick, EIz=E * inertia, mass_per_length=3e-3)
    m.fix("P0", "R0", f"P{n}", f"R{n}")
    return m, high, E * inertia * high / L**3


def curved_beam(imperfection: float) -> tuple[fx.System, float]:
    """The cosine beam, its middle pushed down and kept level; and E I h/L³ [N]."""
    m, high, unit = cosine_beam(imperfection)
    m.fix("R16", "P16.x")
    m.prescribe("P16.y", lambda t: high - 1.98 * high * t)
    return m.build(), unit


@pytest.mark.parametrize("end", [0.1, 0.2, 0.3, 0.5, 1.0])
def test_a_path_keeps_to_its_branch_wherever_it_ends(end: float) -> None:
    """Qiu, Lang and Slocum 2004: the largest force is about 740 E I h/L³; it was 721, 946, 722, 947 and 3882."""
    system, unit = curved_beam(1e-6)
    path = system.static_path(t_end=end)
    assert -path.force("P16.y").min() / unit == pytest.approx(721.5, abs=0.5)
    assert path.verdict == path.message == ""


def test_a_perfect_beam_is_said_to_become_unstable() -> None:
    system, _ = curved_beam(0.0)
    with pytest.warns(
        fx.UnstableWarning, match=r"at t = 0\.07[78]\d* s other paths of equilibria branch off.*imperfection"
    ):
        path = system.static_path(t_end=0.1)
    assert "equilibria are unstable" in path.verdict


@pytest.mark.parametrize("jointed", [False, True])
def test_unstable_motions_are_counted_as_the_eigenvalues_have_them(jointed: bool) -> None:
    """Without conditions the pivots of a sparse elimination count, with them those of a dense factorization."""
    m, _, unit = cosine_beam(1e-5)
    pushed = "P16.y"
    if jointed:
        m.truss("strut", "P16", m.point("top", (0.05, 0.105)))
        m.fix("top.x")
        pushed = "top.y"
    m.load(pushed, lambda t: -1000.0 * unit * t)
    system = m.build()
    found = load_path.static_path(system, 1.0, system.equilibrium())
    omega = np.array([[vibration.omega for vibration in system.vibrations(state)] for state in found.states])
    decided = np.abs(omega).min(axis=1) > 1e-3 * np.abs(omega).max(axis=1)  # others count as neutral
    assert np.count_nonzero(decided) > 0.9 * len(decided)
    np.testing.assert_array_equal(np.array(found.unstable)[decided], np.sum(omega < 0, axis=1)[decided])
    assert max(n or 0 for n in found.unstable) == 2


def weighted_leaf() -> fx.System:
    """A leaf spring with a weight of 0.1 N at its tip, and a force that lifts it."""
    m = fx.Model(gravity=(0, -10.0))
    ends = m.point("A", (0, 0), fixed=True), m.angle("R", fixed=True), m.point("B", (1, 0)), m.angle("S")
    m.beam("leaf", *ends, EA=1e6, EIz=1.0)
    m.point_mass("tip", "B", 0.01)
    m.load("B.y", lambda t: 0.05 * t)
    return m.build()


def test_a_path_begins_in_equilibrium() -> None:
    """The weight was taken on gradually, as the force grew: all states but the last were wrong, without a word."""
    s = weighted_leaf()
    path = s.static_path(t_end=1.0)
    assert np.allclose(3 * path["B.y"], -0.1 + 0.05 * path.t, rtol=0, atol=1e-3 * 0.1)
    with pytest.raises(
        fx.PositionError, match=r"start is not in equilibrium: 0\.1 N on 'B\.y' is not balanced"
    ):
        s.static_path(s.at_rest, t_end=1.0)


def test_a_path_that_leads_out_of_a_table_keeps_what_was_found() -> None:
    """Beyond its limit load an arch of two bars has to be pulled back up, for which the table has no forces."""
    m = fx.Model(gravity=(0, 0))
    m.point("L", (-1, 0), fixed=True)
    m.point("R", (1, 0), fixed=True)
    m.point("T", (0, 0.1))
    m.fix("T.x")
    m.truss("a", "L", "T", stiffness=1000.0)
    m.truss("b", "R", "T", stiffness=1000.0)
    m.load("T.y", fx.Table([0, 1], [0, -1.0], kind="linear"))
    with pytest.warns(
        fx.IncompleteWarning, match=r"path stopped at .* load on 'T.y': Table: .*extend the table"
    ):
        path = m.build().static_path(t_end=1.0)
    length = np.hypot(1, path["T.y"])
    np.testing.assert_allclose(
        path.t, 2000 * (np.hypot(1, 0.1) / length - 1) * path["T.y"], rtol=0, atol=1e-9
    )
    assert np.max(path.t) == pytest.approx(0.3826, abs=1e-3)
    assert path["T.y"][-1] == pytest.approx(0.0, abs=1e-6)  # where the bars are straight, no force acts


def test_a_pendulum_that_turns_freely_swings_out_on_a_path() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.1, 0.02, -0.3))
    m.frame("R")
    m.body_point("arm", "O", "R", "A")
    m.body("b", "A", "R", mass=0.5, inertia=(0.02, 0.02, 0.004))
    m.load("A.x", fx.Table([0, 1], [0, 3.0], kind="linear"))
    path, length = m.build().static_path(t_end=1.0), np.linalg.norm((0.1, 0.02, 0.3))
    assert path.t[-1] == 1.0 and not path.message
    np.testing.assert_allclose(path["A.x"] / path["A.z"], -3 * path.t / (0.5 * 9.81), rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.hypot(path["A.x"], path["A.z"]), length, rtol=1e-12)


def test_what_carries_loads_on_a_path_may_roll_freely() -> None:
    """Nothing resists a motion of the wagon along its rails, and no force acts there."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point("B", (0.5, 0))
    m.point("P", (0.2, 1.0))
    m.fix("A.y", "B.y")
    m.truss("frame", "A", "B")
    m.truss("a", "A", "P", stiffness=1000.0)
    m.truss("b", "B", "P", stiffness=1000.0)
    m.point_mass("load", "P", 1.0)
    m.load("P.y", fx.Table([0, 1], [0, -30.0], kind="linear"))
    s = m.build()
    path = s.static_path(t_end=1.0)
    assert path.t[-1] == 1.0 and not path.message
    for state in path:
        weight = 9.81 + 30 * state.t
        assert state.force("A.y") + state.force("B.y") == pytest.approx(weight, rel=1e-9)
    end = s.equilibrium(t=1.0)
    for name in ("a.elongation", "b.elongation"):
        assert path[-1][name] == pytest.approx(end[name], rel=1e-12)


def pulled(pull: fx.Table) -> fx.System:
    """A wagon of 50 kg on its rails with 100 kg on a rope of four parts, pulled along the rails."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("W", (0, 0, 3))
    m.fix("W.y", "W.z")
    for i, upper in enumerate(("W", "P0", "P1", "P2")):
        m.point(f"P{i}", (0, 0, 2.5 - 0.5 * i))
        m.truss(f"part{i}", upper, f"P{i}", stiffness=1e5)
    m.point_mass("hook", "P3", 100.0)
    m.point_mass("wagon", "W", 50.0)
    m.load("P3", (pull, 0, lambda t: -100 * t))
    return m.build()


def test_a_load_along_a_free_motion_is_named_and_can_be_held() -> None:
    s = pulled(fx.Table([0, 1], [0, 50.0], kind="linear"))
    with pytest.raises(
        fx.DynamicsError, match=r"nothing resists a motion of '[WP]\d?\.x'; support it, give hold="
    ):
        s.static_path(t_end=1.0)
    path = s.static_path(t_end=1.0, hold=["W.x"])
    assert path.t[-1] == 1.0 and not path.message
    for state in path:
        assert state.drive("W.x") == pytest.approx(-50.0 * state.t, abs=1e-9)
        assert state["W.x"] == pytest.approx(0.0, abs=1e-12)
    assert path[-1]["P3.x"] / (3 - path[-1]["P3.z"]) == pytest.approx(50 / 1081, rel=1e-9)
    late = pulled(fx.Table([0, 0.5, 1], [0, 0, 50.0], kind="linear"))
    with pytest.warns(
        fx.IncompleteWarning, match=r"path stopped at .* nothing resists a motion of '[WP].*x'"
    ):
        path = late.static_path(t_end=1.0)
    assert 0 < path.t[-1] <= 0.5


def test_a_path_begins_along_a_motion_that_something_resists_later() -> None:
    """A string without tension carries nothing across until it is pulled aside; closed form."""
    m = fx.Model(gravity=(0, 0))
    m.point("A", (0, 0), fixed=True)
    m.point("B", (1, 0), fixed=True)
    m.point("P", (0.5, 0))
    m.truss("a", "A", "P", stiffness=2000.0)
    m.truss("b", "P", "B", stiffness=2000.0)
    m.load("P.y", fx.Table([0, 1], [0, -5.0], kind="linear"))
    path = m.build().static_path(t_end=1.0)
    y, length = path["P.y"], np.hypot(0.5, path["P.y"])
    assert path.t[-1] == 1.0 and y[-1] < -0.08
    np.testing.assert_allclose(5 * path.t, -4000 * (length - 0.5) * y / length, rtol=0, atol=1e-9)


def test_a_skate_turns_until_the_force_is_across_it() -> None:
    """Nothing resists its turning where no force acts; forces act along another motion than the one that is free."""
    m = fx.Model(gravity=(0.0, -9.81))
    m.point("P", (0.1, 0.2))
    m.angle("R")
    m.body("b", "P", "R", mass=0.5, inertia=0.05)
    m.angle("spin")
    m.rotary_inertia("rim", "spin", 0.05)
    m.planar_wheel("w", "P", "R", "spin", radius=0.1)
    m.load("P", (fx.Table([0, 1], [0, 2.0], kind="linear"), 0))
    s = m.build()
    path = s.static_path(t_end=1.0)
    assert path.t[-1] == 1.0 and not path.message
    np.testing.assert_allclose(np.tan(path["R.angle"]), 2 * path.t / (0.5 * 9.81), rtol=0, atol=1e-10)
    assert s.equilibrium(t=1.0)["R.angle"] == pytest.approx(np.arctan2(2, 0.5 * 9.81), rel=1e-10)


def test_a_load_on_a_linkage_without_stiffness_begins_no_path() -> None:
    """It would turn at once until it is along the load; from there on there is a path."""
    m = fx.Model(gravity=(0.0, 0.0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    m.point("P", (0.2, 0, 0))
    m.frame("R")
    m.hinge("pivot", "G", "R", (0, 0, 1))
    m.body_point("arm", "O", "R", "P")
    m.body("b", "P", "R", mass=0.5, inertia=(0.02, 0.02, 0.004))
    m.load("P", (0, fx.Table([0, 1], [0, 5.0], kind="linear"), 0))
    s = m.build()
    with pytest.raises(
        fx.DynamicsError, match=r"no path at t = 0 s: the load acts where nothing resists a motion of"
    ):
        s.static_path(t_end=1.0)
    path = s.static_path(s.equilibrium(t=0.01), t_end=1.0)
    assert path.t[-1] == 1.0 and path["P.y"] == pytest.approx(0.2, rel=1e-9)
