"""Frequency responses against closed forms and python-control, and what their diagrams show."""

import numpy as np
import pytest

import flexel as fx

pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")

M, K = 2.0, 800.0  # kg, N/m: 20 rad/s


def mass(damping: float, prescribed: bool = False) -> fx.Linearization:
    """A mass between a spring to the ground, or to a shaken support S, and its axis x."""
    m = fx.Model()
    m.point("S", (0, 0), fixed=not prescribed)
    m.point("P", (1, 0))
    m.fix("P.y", *(["S.y"] if prescribed else []))
    m.point_mass("mass", "P", M)
    m.truss("spring", "S", "P")
    m.spring("spring.elongation", K, damping)
    if prescribed:
        m.prescribe("S.x", lambda t: 0 * t)
    return m.build().linearize()


def test_one_degree_of_freedom_has_its_closed_form() -> None:
    f = np.linspace(0.1, 10, 57)
    s = 2j * np.pi * f
    found = mass(8.0).frequency_response("P.x", ["P.x", "P.x'", "P.x''", "force:spring.elongation"], f)
    exact = 1 / (M * s**2 + 8.0 * s + K)
    for i, factor in enumerate((1, s, s**2, 8.0 * s + K)):
        assert found.values[:, i, 0] == pytest.approx(factor * exact, rel=1e-10)
    assert found.units == (("m/N",), ("(m/s)/N",), ("(m/s²)/N",), ("1",))
    assert np.array_equal(found.frequencies, f) and found.inputs == ("P.x",)
    assert found.decibels[:, 0, 0] == pytest.approx(20 * np.log10(np.abs(exact)))
    assert found.phase[:, 0, 0] == pytest.approx(np.angle(exact))


def test_displacements_of_a_support_are_transmitted() -> None:
    f = np.linspace(0.1, 10, 57)
    s = 2j * np.pi * f
    found = mass(0.0, prescribed=True).frequency_response("displacement:S.x", "P.x", f)
    assert found.values[:, 0, 0] == pytest.approx(K / (M * s**2 + K), rel=1e-10)
    assert found.units == (("1",),)
    by_acceleration = mass(0.0, prescribed=True).frequency_response("S.x", "P.x", f)
    assert by_acceleration.units == (("m/(m/s²)",),) and by_acceleration.inputs == ("S.x''",)
    assert by_acceleration.values[:, 0, 0] == pytest.approx(K / (M * s**2 + K) / s**2, rel=1e-9)


def test_python_control_gives_the_same() -> None:
    pytest.importorskip("control", reason="pip install 'flexel[control]'")
    lin, names = mass(3.0), ["P.x", "P.x'"]
    found = lin.frequency_response("P.x", names)
    other = lin.to_control(["P.x"], names)(2j * np.pi * found.frequencies, squeeze=False)
    assert found.values == pytest.approx(np.moveaxis(other, 2, 0), rel=1e-9)


@pytest.mark.parametrize("zeta", [0.2, 1e-2, 1e-4])
def test_no_peak_is_cut_off(zeta: float) -> None:
    """The largest drawn magnitude is that of the resonance, 1/(2 ζ √(1 - ζ²)) of the static one."""
    found = mass(2 * zeta * np.sqrt(K * M)).frequency_response("P.x", "P.x")
    assert found.magnitude.max() * K == pytest.approx(1 / (2 * zeta * np.sqrt(1 - zeta**2)), rel=2e-3)
    coarse = mass(2 * zeta * np.sqrt(K * M)).bode("P.x", "P.x", [0.5, 1.0, 20.0])
    drawn = coarse.axes[0].lines[0].get_ydata()
    assert drawn.max() * K == pytest.approx(1 / (2 * zeta * np.sqrt(1 - zeta**2)), rel=2e-3)
    assert coarse.axes[0].lines[0].get_xdata()[[0, -1]] == pytest.approx([0.5, 20.0])


def test_a_dip_between_two_peaks_is_not_cut_off_either() -> None:
    """An absorber of 20 rad/s on a mass: where it is tuned, the mass stands still."""
    m = fx.Model()
    for name in "PQ":
        m.point(name, (0, 0))
        m.fix(f"{name}.y")
    m.point_mass("mass", "P", 10.0)
    m.point_mass("absorber", "Q", M)
    m.spring("P.x", 4000.0, 1.0)
    m.relation("between", {"Q.x": 1.0, "P.x": -1.0})
    m.spring("between.relation", K)
    found = m.build().linearize().frequency_response("P.x", "P.x")
    lowest = np.argmin(found.magnitude[:, 0, 0])
    inner = found.frequencies < 8
    assert found.frequencies[inner][np.argmin(found.magnitude[inner, 0, 0])] == pytest.approx(
        10 / np.pi, rel=1e-4
    )
    assert found.magnitude[inner].min() < 1e-4 / 4000 and lowest >= 0


def test_the_diagram_has_units_a_legend_for_several_pairs_and_a_title() -> None:
    drawn = mass(8.0).bode("P.x", ["P.x", "P.x'"])
    one, rate, phase = drawn.axes
    assert one.get_ylabel() == "magnitude [m/N]" and rate.get_ylabel() == "magnitude [(m/s)/N]"
    assert (phase.get_xlabel(), phase.get_ylabel()) == ("frequency [Hz]", "phase [°]")
    assert [text.get_text() for text in rate.get_legend().get_texts()] == ["P.x' / P.x"]
    assert one.get_title() == "Frequency response: P.x, P.x' by P.x"
    assert [panel.get_yscale() for panel in drawn.axes] == ["log", "log", "linear"]
    assert phase.lines[0].get_ydata()[[0, -1]] == pytest.approx([0, -180], abs=5)
    single, _ = mass(8.0).bode("P.x", "P.x", decibels=True, title="A mass").axes
    assert single.get_ylabel() == "magnitude [dB re 1 m/N]" and single.get_legend() is None
    assert single.get_title() == "A mass"


def test_what_has_no_response_is_refused() -> None:
    with pytest.raises(fx.ModelError, match="not negative, in Hz"):
        mass(1.0).frequency_response("P.x", "P.x", [-1.0])
    with pytest.raises(fx.LinearizationError, match="name an input and an output"):
        mass(1.0).bode([], "P.x")
    free = fx.Model()
    free.point("P", (0, 0))
    free.fix("P.y")
    free.point_mass("mass", "P", 1.0)
    with pytest.raises(fx.LinearizationError, match="the response is infinite"):
        free.build().linearize().frequency_response("P.x", "P.x", [0.0, 1.0])
