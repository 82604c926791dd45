"""Time histories, spectra and phase planes: axes by unit, comparisons by kind of line, natural frequencies marked."""

import numpy as np
import pytest

import flexel as fx
from flexel.apps.view.figures import COLOURS, STYLE
from flexel.examples.bicycle import bicycle, kick

pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")


@pytest.fixture(scope="module")
def slow() -> fx.Motion:
    return kick(bicycle(), 4.5, 0.5, rtol=1e-6)


@pytest.fixture(scope="module")
def fast() -> fx.Motion:
    return kick(bicycle(), 6.0, 0.4, rtol=1e-6)


def oscillators() -> fx.System:
    """Two masses on springs: 2 rad/s along P.x, 6 rad/s along Q.x."""
    m = fx.Model()
    for name, stiffness in (("P", 4.0), ("Q", 36.0)):
        m.point(name, (0, 0))
        m.fix(f"{name}.y")
        m.point_mass(f"mass {name}", name, 1.0)
        m.spring(f"{name}.x", stiffness)
    return m.build()


def test_quantities_of_one_unit_share_axes_and_lists_have_their_own(slow: fx.Motion) -> None:
    by_unit = slow.plot("lean.angle", "lean.angle'", "steer.angle")
    assert [axes.get_ylabel() for axes in by_unit.axes] == ["angle [rad]", "lean.angle' [rad/s]"]
    assert [line.get_label() for line in by_unit.axes[0].lines] == ["lean.angle", "steer.angle"]
    assert by_unit.axes[0].get_legend() is not None and by_unit.axes[1].get_legend() is None
    assert by_unit.axes[-1].get_xlabel() == "time [s]" and by_unit.axes[0].get_xlabel() == ""
    assert by_unit.axes[0].get_title() == "lean.angle, steer.angle, lean.angle' over time"
    own = slow.plot(["lean.angle"], ["steer.angle"], "rear hub.x", title="Three")
    assert [axes.get_ylabel() for axes in own.axes] == [
        "lean.angle [rad]",
        "steer.angle [rad]",
        "rear hub.x [m]",
    ]
    assert own.axes[0].get_title() == "Three"
    assert len({axes.lines[0].get_color() for axes in own.axes}) == 3


def test_motions_are_compared_by_kinds_of_lines_over_all_of_their_time(
    slow: fx.Motion, fast: fx.Motion
) -> None:
    drawn = slow.plot("lean.angle", "steer.angle", "rear hub.x", against=fast, labels=["slow", "fast"])
    above, below = drawn.axes
    assert [text.get_text() for text in above.get_legend().get_texts()] == [
        "lean.angle, slow", "lean.angle, fast", "steer.angle, slow", "steer.angle, fast",
    ]  # fmt: skip
    lines = above.lines
    assert [line.get_linestyle() for line in lines] == ["-", "--", "-", "--"]
    assert lines[0].get_color() == lines[1].get_color() != lines[2].get_color()
    assert np.array_equal(lines[1].get_ydata(), fast["lean.angle"])
    assert np.array_equal(lines[1].get_xdata(), fast.t)
    assert [text.get_text() for text in below.get_legend().get_texts()] == ["slow", "fast"]
    assert below.lines[0].get_color() != below.lines[1].get_color()
    assert below.get_xlim() == (0, 0.5)
    without = slow.plot("lean.angle", against=[fast, slow]).axes[0]
    assert [text.get_text() for text in without.get_legend().get_texts()] == [
        "motion 1",
        "motion 2",
        "motion 3",
    ]


def test_what_cannot_be_drawn_together_is_refused(slow: fx.Motion, fast: fx.Motion) -> None:
    with pytest.raises(fx.ModelError, match="in one list; give names of one unit"):
        slow.plot(["lean.angle", "rear hub.x"])
    with pytest.raises(fx.ModelError, match="3 labels for 2 motions"):
        slow.plot("lean.angle", against=fast, labels=["a", "b", "c"])
    with pytest.raises(fx.ModelError, match="against 3; give a motion"):
        slow.plot("lean.angle", against=[3])
    with pytest.raises(fx.ModelError, match="give a list with a name for each motion"):
        slow.plot("lean.angle", against=fast, labels="ab")


def test_natural_frequencies_stand_at_the_peaks_of_the_spectrum() -> None:
    s = oscillators()
    start = s.state_at({"P.displacement.along": 0.3, "Q.displacement.along": 0.1})
    motion = s.simulate(40 * np.pi, start=start, samples=4097, rtol=1e-8)
    drawn = motion.spectrum_plot("P.x", "Q.x", "P.x'", lin=s.linearize(s.initial), limit=2.0)
    displacement, velocity = drawn.axes
    assert displacement.get_ylabel() == "amplitude, displacement [m]"
    assert velocity.get_ylabel() == "amplitude of P.x' [m/s]"
    assert velocity.get_xlabel() == "frequency [Hz]" and velocity.get_xlim() == (0, 2.0)
    assert displacement.get_title() == "Spectrum of P.x, Q.x, P.x'"
    marks = [line.get_xdata()[0] for line in displacement.lines if line.get_linestyle() == ":"]
    assert marks == pytest.approx([1 / np.pi, 3 / np.pi], rel=1e-9)
    assert [text.get_text() for text in displacement.get_legend().get_texts()] == [
        "P.x",
        "Q.x",
        "natural frequencies",
    ]
    for name, mark, size in (("P.x", marks[0], 0.3), ("Q.x", marks[1], 0.1)):
        f, amplitude = motion.spectrum(name)
        assert f[np.argmax(amplitude)] == pytest.approx(mark, abs=f[1])
        assert amplitude.max() == pytest.approx(size, rel=0.01)
    with pytest.raises(fx.ModelError, match="give a linearization"):
        motion.spectrum_plot("P.x", lin=3)  # type: ignore[arg-type]


def test_the_path_of_a_point_has_equal_scales(slow: fx.Motion) -> None:
    path = slow.plot_phase("rear hub.x", "rear hub.y").axes[0]
    assert (path.get_xlabel(), path.get_ylabel()) == ("rear hub.x [m]", "rear hub.y [m]")
    assert path.get_aspect() == 1 and path.get_title() == "rear hub.y against rear hub.x"
    assert slow.plot_phase("lean.angle").axes[0].get_aspect() == "auto"


def _light(colour: str) -> np.ndarray:
    """Linear RGB of a colour."""
    c = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def _lab(light: np.ndarray) -> np.ndarray:
    """CIE L*a*b* of linear RGB."""
    xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]) @ light
    f = np.cbrt(np.maximum(xyz / (0.9505, 1, 1.089), 1e-6))
    return np.array([116 * f[1], 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


# Machado, Oliveira and Fernandes (2009), complete lack of red or of green cones.
@pytest.mark.parametrize("blind", [
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
])  # fmt: skip
def test_colours_stay_apart_for_the_colour_blind(blind: list[list[float]]) -> None:
    seen = [_lab(np.clip(np.array(blind) @ _light(colour), 0, 1)) for colour in COLOURS]
    apart = [np.linalg.norm(a - b) for i, a in enumerate(seen) for b in seen[:i]]
    assert min(apart) > 15  # about seven just noticeable differences; the old colours had 6


def test_the_style_is_found_by_name_and_has_the_colours() -> None:
    """As a program selects it for figures of its own: ``plt.style.use("flexel.apps.view.style")``."""
    from matplotlib import rcParams, style

    with style.context(STYLE):
        assert rcParams["axes.prop_cycle"].by_key()["color"] == list(COLOURS)
        assert not rcParams["axes.spines.top"]
