"""A user-defined element moves, and is linearized, like the same mechanics written out manually."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose
from own_elements import L0, P, own_bar
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.derive import Deformation, Element, Law, Parameter, symbol

PAGE = Path(__file__).resolve().parents[2] / "docs" / "writing-an-element.md"


BLOCKS = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


BASE, LIFT, J, MASS, G, K, PRELOAD, DRAWN = 0.03, 0.01, 0.002, 0.4, 9.81, 900.0, 30.0, 0.035


pytestmark = pytest.mark.usefixtures("cache")


@pytest.fixture(scope="module")
def page() -> dict[str, Any]:
    """The names that the element, its page and the model leave behind."""
    names: dict[str, Any] = {}
    for block in BLOCKS[:3]:
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
    (note,) = first.path.parent.glob(f"{first.path.stem}.*.verified")
    assert "all within tolerance" in note.read_text()
    stamp = note.stat().st_mtime_ns
    assert fx.compile_element(own_bar(name="once")).address == first.address
    assert note.stat().st_mtime_ns == stamp


def test_a_law_with_pieces_is_verified() -> None:
    e, ed, c = symbol("e"), symbol("ed"), Parameter("c", 1, "N/m^3", "stiffness")
    pull = sp.Piecewise((c.symbol * e**3, e > 0), (0, True)) + sp.sin(ed)
    stored = sp.Piecewise((c.symbol * e**4 / 4, e > 0), (0, True))
    law = Law("only_pulls", "sigma = c e^3", (c,), (e,), (ed,), (), (pull,), (), stored)
    compiled = fx.compile_law(law)
    assert compiled.spec.parameters[0].unit == "N/m^3"
    (note,) = compiled.path.parent.glob(f"{compiled.path.stem}.*.verified")
    assert "J" in note.read_text()


def test_pieces_that_join_smoothly_are_an_element() -> None:
    x, l0 = P.x[0], L0.symbol
    stop = sp.Piecewise((x, x < l0), (x + (x - l0) ** 3, True))
    compiled = fx.compile_element(
        Element("stop", (P,), (L0,), (), (Deformation("d", "m", stop),), doc="a soft stop")
    )
    assert compiled.spec.kernels["position"].operations > 0


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
    with pytest.raises(fx.ModelError, match="not a compiled element; give the result of fx.compile_element"):
        m.element("bar", own_bar(), "A", "A")  # type: ignore[arg-type]
    law = fx.compile_law(
        Law("own_damper", "c ed", (), (e := symbol("e"),), (symbol("ed"),), (), (2 * e,), ())
    )
    with pytest.raises(fx.ModelError, match="element 'bar': .* is not a compiled element; give"):
        m.element("bar", law, "A", "A")  # type: ignore[arg-type]
    with pytest.raises(fx.ElementError, match="'truss' is not a flexel.derive.Element"):
        fx.compile_element("truss")  # type: ignore[arg-type]
