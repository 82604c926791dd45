"""A user's own element moves, and is linearized, as the same mechanics written down by hand."""

import re
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.derive import Deformation, Element, Law, Let, Parameter, Point, Slip, symbol
from flexel.derive.declare.rotation import dot, norm

PAGE = Path(__file__).resolve().parents[2] / "docs" / "writing-an-element.md"
BLOCKS = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)

BASE, LIFT, J, MASS, G, K, PRELOAD, DRAWN = 0.03, 0.01, 0.002, 0.4, 9.81, 900.0, 30.0, 0.035


@pytest.fixture(scope="module", autouse=True)
def cache(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """An empty cache: everything is derived, compiled and verified here."""
    folder = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(folder))
        yield folder / "flexel"


@pytest.fixture(scope="module")
def page() -> dict[str, Any]:
    """The names that the page's program leaves behind."""
    names: dict[str, Any] = {}
    for block in BLOCKS:
        exec(block, names)
    return names


def tappet(phi: Any) -> tuple[Any, Any, Any, Any]:
    """Height of the tappet above the cam's axis and its derivatives by the angle of the cam."""
    a = LIFT / 2
    return BASE + a * (1 + np.sin(phi)), a * np.cos(phi), -a * np.sin(phi), -a * np.cos(phi)


def weight(y: Any) -> Any:
    """Force on the tappet, downwards."""
    return MASS * G + PRELOAD + K * (y - DRAWN)


def acceleration(phi: Any, rate: Any) -> Any:
    """Lagrange's equation of the cam: (J + m y'^2) phi'' + m y' y'' phi'^2 + weight y' = 0."""
    y, y1, y2, _ = tappet(phi)
    return -(MASS * y1 * y2 * rate**2 + weight(y) * y1) / (J + MASS * y1**2)


def test_the_tutorial_defines_an_element_in_less_than_twenty_lines() -> None:
    assert len([line for line in BLOCKS[0].splitlines() if line.strip()]) < 20


def test_the_cam_of_the_tutorial_turns_as_lagrange_says(page: dict[str, Any]) -> None:
    motion = page["motion"]
    start = (motion["shaft.angle"][0], 20.0)
    exact = solve_ivp(
        lambda t, y: (y[1], acceleration(*y)),
        (0, 0.5),
        start,
        t_eval=motion.t,
        method="DOP853",
        rtol=1e-12,
        atol=1e-13,
    )
    phi, rate = exact.y
    y, y1, y2, _ = tappet(phi)
    assert_allclose(motion["shaft.angle"], phi, atol=2e-8)
    assert_allclose(motion["tip.y"], y, atol=1e-10)
    lift = MASS * (y1 * acceleration(phi, rate) + y2 * rate**2)
    assert_allclose(-motion.force("contact.gap"), weight(y) + lift, atol=1e-5)
    assert np.ptp(motion.energy["total"]) < 1e-8


@pytest.mark.parametrize("place", [0, 60, 137, 200])
def test_the_cam_is_linearized_analytically_about_its_motion(page: dict[str, Any], place: int) -> None:
    state = page["motion"][place]
    lin = page["s"].linearize(state)
    phi, rate = state["shaft.angle"], state.rate("shaft.angle")
    y, y1, y2, y3 = tappet(phi)
    turning = 2 * MASS * y1 * y2 * acceleration(phi, rate) + MASS * (y2**2 + y1 * y3) * rate**2
    assert_allclose(lin.M, [[J + MASS * y1**2]], rtol=1e-12)
    assert_allclose(lin.C, [[2 * MASS * y1 * y2 * rate]], rtol=1e-10, atol=1e-14)
    assert_allclose(lin.K, [[turning + K * y1**2 + weight(y) * y2]], rtol=1e-10, atol=1e-12)


def test_the_cam_swings_about_its_lowest_point(page: dict[str, Any]) -> None:
    omega = np.sqrt(weight(BASE) * LIFT / 2 / J)
    assert_allclose(np.abs(page["lin"].eigenvalues().imag), [omega, omega], rtol=1e-9)


def own_bar(**changes: Any) -> Element:
    """The bar of the table, written once more."""
    p, q = Point("p"), Point("q")
    l0, mass = Parameter("l0", 1, "m", "length"), Parameter("mass", 1, "kg", "mass")
    gravity = Parameter("gravity", 3, "m/s^2", "gravity")
    let = Let()
    l = let.scalar("l", norm(let.vector("d", q.x - p.x)))
    fields = {
        "name": "own_bar",
        "nodes": (p, q),
        "parameters": (l0, mass, gravity),
        "let": let.entries,
        "deformations": (Deformation("elongation", "m", l - l0.symbol),),
        "kinetic_energy": mass.symbol * (dot(p.v, p.v) + dot(p.v, q.v) + dot(q.v, q.v)) / 6,
        "potential": -mass.symbol * dot(gravity.vector, p.x + q.x) / 2,
        "doc": "elongation = |q - p| - l0",
    }
    return Element(**(fields | changes))


def swing(own: bool) -> tuple[fx.System, fx.Motion]:
    """A beam on a ball joint that carries a bar with an elastic elongation: a spatial double pendulum."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.6, 0, 0))
    m.point("B", (0.6, 0.5, 0))
    m.frame("R")
    m.beam("arm", "O", "R", "A", rigid=True, mass_per_length=2.0)
    m.body("tip", "A", "R", mass=1.0, inertia=(0.01, 0.02, 0.03))
    if own:
        m.element("bar", fx.compile_element(own_bar()), "A", "B", l0=0.5, mass=0.8)
    else:
        m.truss("bar", "A", "B", mass_per_length=1.6)
    m.spring("bar.elongation", 400.0, damping=0.5)
    s = m.build()
    return s, s.simulate(0.4, rtol=1e-11, atol=1e-12)


def test_an_own_bar_beside_a_beam_is_the_bar_of_the_table() -> None:
    (s, motion), (t, reference) = swing(True), swing(False)
    assert_allclose(motion.x, reference.x, atol=1e-12)
    got, want = s.linearize(motion[-1]), t.linearize(reference[-1])
    for letter in ("M", "C", "K"):
        A, B = getattr(got, letter), getattr(want, letter)
        assert_allclose(A, B, atol=1e-10 * np.abs(B).max())


def test_an_element_is_verified_once(cache: Path) -> None:
    first = fx.compile_element(own_bar(name="once"))
    note = first.path.with_suffix(".verified")
    assert "all within tolerance" in note.read_text()
    stamp = note.stat().st_mtime_ns
    begin = time.perf_counter()
    assert fx.compile_element(own_bar(name="once")).address == first.address
    assert time.perf_counter() - begin < 3
    assert note.stat().st_mtime_ns == stamp


def test_a_law_with_pieces_is_verified() -> None:
    e, ed, c = symbol("e"), symbol("ed"), Parameter("c", 1, "N/m^3", "stiffness")
    pull = sp.Piecewise((c.symbol * e**3, e > 0), (0, True)) + sp.sin(ed)
    stored = sp.Piecewise((c.symbol * e**4 / 4, e > 0), (0, True))
    law = Law("only_pulls", "sigma = c e^3", (c,), (e,), (ed,), (), (pull,), (), stored)
    compiled = fx.compile_law(law)
    assert compiled.spec.parameters[0].unit == "N/m^3"
    assert "J" in compiled.path.with_suffix(".verified").read_text()


def test_an_energy_that_is_not_that_of_the_stress_is_refused() -> None:
    e, ed, k = symbol("e"), symbol("ed"), Parameter("k", 1, "N/m", "stiffness").symbol
    let = Let()
    pull = let.scalar("pull", k * e)

    def law(name: str, stress: Any, energy: Any) -> Law:
        stiffness = Parameter("k", 1, "N/m", "stiffness")
        return Law(name, "spring", (stiffness,), (e,), (ed,), (), (stress,), (), energy, let=let.entries)

    with pytest.raises(fx.ElementError, match=r"law 'twice': the derivative of the energy .*correct one"):
        fx.compile_law(law("twice", pull + 3 * ed, 5 * k * e**2))
    fx.compile_law(law("pushed", pull + 3 * ed + 7, pull * e / 2))  # an actuator beside the spring
    fx.compile_law(law("stores_nothing", pull, sp.S.Zero))


P, Q = Point("p"), Point("q")
L0 = Parameter("l0", 1, "m", "length")


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        (
            P.x[0] - sp.Symbol("k"),
            "'wrong': deformation 'd' contains k: not a coordinate.*declare a Parameter",
        ),
        (P.x[0] - sp.Symbol("l0"), "contains l0: .*parameter.symbol"),  # not real: another symbol
        (P.x - Q.x, "deformation 'd' is not a scalar expression but .*Matrix.*declare each component"),
        (2 * L0.symbol, "deformation 'd' depends on no coordinate"),
        (sp.Abs(P.x[0]), "'wrong': deformation 'd' contains Abs.*kink.*Piecewise"),
        (
            sp.Piecewise((0, P.x[0] < 0), (P.x[0], True)),
            "'wrong': deformation 'd': the pieces .* do not join smoothly",
        ),
        (sp.Piecewise((0, P.x[0] < L0.symbol), (1, True)), "do not join smoothly where l0 - p_x = 0"),
        (sp.floor(P.x[0]), "floor cannot be differentiated.*use powers"),
        (sp.Function("profile")(P.x[0]), "'d' contains profile.*cannot be differentiated"),
        (P.x[0] / sp.S.Zero, "not real and finite"),
    ],
)
def test_a_wrong_deformation_is_named(expression: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        fx.compile_element(Element("wrong", (P, Q), (L0,), (), (Deformation("d", "m", expression),), doc="d"))


def test_an_element_of_nothing_is_refused() -> None:
    with pytest.raises(
        ValueError, match="element 'wrong': it has no deformation, slip or energy; declare one"
    ):
        Element("wrong", (P, Q), (L0,), doc="d")


def test_pieces_that_join_smoothly_are_an_element() -> None:
    x, l0 = P.x[0], L0.symbol
    stop = sp.Piecewise((x, x < l0), (x + (x - l0) ** 3, True))
    compiled = fx.compile_element(
        Element("stop", (P,), (L0,), (), (Deformation("d", "m", stop),), doc="a soft stop")
    )
    assert compiled.spec.kernels["position"].operations > 0


def test_meanings_and_units_are_asked_for() -> None:
    with pytest.raises(ValueError, match="parameter 'k' has no doc; say"):
        Parameter("k", 1, "m", " ")
    with pytest.raises(ValueError, match="parameter 'k' has no unit"):
        Parameter("k", 1, "", "stiffness")
    with pytest.raises(ValueError, match="element 'own_bar': the element has no doc"):
        own_bar(doc="")
    with pytest.raises(ValueError, match="element 'own_bar': 'slide' has no unit"):
        own_bar(slips=(Slip("slide", "", P.v[0]),))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"sigma": symbol("e")}, "law 'own': sigma holds e; give a tuple"),
        ({"parameters": ("k",)}, "law 'own': parameters holds 'k'; give a tuple of Parameter"),
        ({"states": (symbol("z"),)}, "law 'own': states holds z; give a tuple of Internal"),
    ],
)
def test_parts_of_a_law_that_are_no_lists_are_named(change: dict[str, Any], message: str) -> None:
    e, ed = symbol("e"), symbol("ed")
    parts = {"parameters": (), "e": (e,), "ed": (ed,), "s": (), "sigma": (e,), "tau": (), **change}
    with pytest.raises(ValueError, match=message):
        Law("own", "a law", **parts)


def test_parts_of_an_element_and_ranges_that_are_no_lists_are_named() -> None:
    with pytest.raises(ValueError, match="'own_bar': deformations holds Deformation.*give a tuple of Deform"):
        own_bar(deformations=Deformation("d", "m", P.x[0]))
    for ranges, message in (
        ([1, 2], r"ranges \[1, 2\] have no names"),
        ({"p_x": 3}, "range 3 of 'p_x' is not"),
    ):
        with pytest.raises(fx.ElementError, match=f"'own_bar'.*{message}"):
            fx.compile_element(own_bar(), ranges=ranges)  # type: ignore[arg-type]


def test_a_definition_that_is_not_real_everywhere_needs_a_range() -> None:
    wrong = own_bar(name="rooted", deformations=(Deformation("d", "m", sp.sqrt(P.x[0])),))
    with pytest.raises(fx.ElementError, match="'rooted': .*not finite.*ranges="):
        fx.compile_element(wrong)
    with pytest.raises(fx.ElementError, match="'rooted': a range of 'x'; there are l0,.* p_x"):
        fx.compile_element(wrong, ranges={"x": (1, 2)})
    with pytest.raises(fx.ElementError, match=r"range \(2, 1\) of 'p_x' is not \(lowest, highest\)"):
        fx.compile_element(wrong, ranges={"p_x": (2, 1)})
    assert fx.compile_element(wrong, ranges={"p_x": (0.2, 1)}).spec.name == "rooted"


def test_kernels_that_lose_digits_are_refused() -> None:
    x = P.x[0]
    lost = own_bar(name="lossy", deformations=(Deformation("d", "m", (10**7 + x) ** 2 - (10**7 - x) ** 2),))
    with pytest.raises(
        fx.ElementError, match="(?s)'lossy': the compiled kernels differ.*NOT OK.*fewer digits"
    ):
        fx.compile_element(lost)
    with pytest.raises(fx.ElementError, match="differ"):  # and it is not remembered as good
        fx.compile_element(lost)


def test_a_missing_compiler_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(fx.CompilerError, match="element 'uncompiled': no C compiler.*apt install gcc"):
        fx.compile_element(own_bar(name="uncompiled"))


def test_the_name_of_a_built_in_element_is_taken() -> None:
    with pytest.raises(fx.ElementError, match="'truss': flexel has an element of this name"):
        fx.compile_element(own_bar(name="truss"))


@pytest.mark.parametrize(
    ("nodes", "parameters", "message"),
    [
        (("A",), {"l0": 1.0, "mass": 1.0}, "own_bar 'bar'.*p .point., q .point."),
        (("A", "R"), {"l0": 1.0, "mass": 1.0}, "node 'R' is a frame; it needs a point"),
        (("A", "B"), {"l0": 1.0}, "parameter.s. mass missing or unknown"),
        (("A", "B"), {"l0": 1.0, "mass": 1.0, "k": 1.0}, "parameter.s. k missing or unknown"),
        (("A", "B"), {"l0": (1.0, 2.0), "mass": 1.0}, "parameter l0 has 2 numbers; it needs 1"),
        (("A", "B"), {"l0": "long", "mass": 1.0}, "parameter l0 .* is not numeric"),
    ],
)
def test_wrong_use_of_an_own_element_is_named(nodes: Any, parameters: Any, message: str) -> None:
    m = fx.Model()
    m.point("A", (0, 0, 0))
    m.point("B", (1, 0, 0))
    m.frame("R")
    bar = fx.compile_element(own_bar())
    with pytest.raises(fx.ModelError, match=message):
        m.element("bar", bar, *nodes, **parameters)


def test_what_is_not_compiled_cannot_be_used() -> None:
    m = fx.Model()
    m.point("A", (0, 0, 0))
    with pytest.raises(fx.ModelError, match="not a compiled element; give what fx.compile_element"):
        m.element("bar", own_bar(), "A", "A")  # type: ignore[arg-type]
    law = fx.compile_law(
        Law("own_damper", "c ed", (), (e := symbol("e"),), (symbol("ed"),), (), (2 * e,), ())
    )
    with pytest.raises(fx.ModelError, match="element 'bar': .* is not a compiled element; give"):
        m.element("bar", law, "A", "A")  # type: ignore[arg-type]
    with pytest.raises(fx.ElementError, match="'truss' is not a flexel.derive.Element"):
        fx.compile_element("truss")  # type: ignore[arg-type]
