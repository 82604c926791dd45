"""Root loci as figures: one colour and name for each branch, units on the axes, stable ranges with refined ends."""

import numpy as np
import pytest

import flexel as fx
from flexel.apps.view.figures import COLOURS
from flexel.apps.view.plot import root_loci
from flexel.base.arrays import Array
from flexel.examples import bicycle_data as data

pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")

SPEEDS = np.linspace(0, 10, 61)
A, B = "a.displacement.along", "b.displacement.along"  # degrees of freedom of the two masses
PLACES = {"weave": (2.6, 2.6), "capsize": (8.2, 0.65), "castering": (2.2, -8.0)}


def bicycle(v: float) -> Array:
    """State matrix of lean and steer of the published benchmark."""
    M, C1, K0, K2 = (np.array(matrix) for matrix in (data.M, data.C1, data.K0, data.K2))
    lower = np.linalg.solve(M, np.hstack([v * C1, data.BENCHMARK["g"] * K0 + v**2 * K2]))
    return np.vstack([-lower, np.eye(2, 4)])


def two_masses() -> fx.System:
    """Two masses on springs of their own."""
    m = fx.Model()
    for name in "ab":
        m.point(name, (0, 0))
        m.fix(f"{name}.y")
        m.point_mass(f"mass {name}", name, 1.0)
        m.spring(f"{name}.x", 4.0, 0.02)
    return m.build()


def test_branches_are_named_and_marked_where_they_become_stable() -> None:
    drawn = root_loci(SPEEDS, [bicycle(v) for v in SPEEDS], label="speed [m/s]", names=PLACES)
    above, below = drawn.axes
    assert (above.get_ylabel(), below.get_ylabel()) == ("real part [1/s]", "|imaginary part| [rad/s]")
    assert below.get_xlabel() == "speed [m/s]" and above.get_title() == "Eigenvalues against speed"
    shown = [text.get_text() for text in above.texts]
    assert {"weave\n4.292", "capsize\n6.024"} < set(shown)
    colours = {text.get_text(): text.get_color() for text in above.texts if text.get_text() in PLACES}
    lines = [line for line in above.lines if len(line.get_xdata()) == SPEEDS.size]
    of_weave = [line for line in lines if line.get_color() == colours["weave"]]
    assert len(of_weave) == 2 and len(set(colours.values())) == 3
    assert np.array_equal(of_weave[0].get_ydata()[-30:], of_weave[1].get_ydata()[-30:])  # a pair
    dashed = [line for line in below.lines if len(line.get_xdata()) == SPEEDS.size]
    assert {line.get_linestyle() for line in lines} == {"-"} and {
        line.get_linestyle() for line in dashed
    } == {"--"}
    (shade,) = [patch for patch in above.patches if patch.get_width() > 0]
    assert (shade.get_x(), shade.get_width()) == pytest.approx(
        (data.WEAVE_SPEED, data.CAPSIZE_SPEED - data.WEAVE_SPEED), rel=1e-9
    )
    assert [text.get_text() for text in above.get_legend().get_texts()] == ["asymptotically stable"]


def test_crossing_modes_keep_their_colours_over_a_parameter() -> None:
    """Mass a becomes lighter, so that its frequency passes that of mass b; the model's names are in the legend."""
    loci = two_masses().root_loci(parameters={"mass a.mass": np.linspace(2.0, 0.4, 30)}, progress=False)
    assert loci.unit == "kg" and set(loci.branches().names) == {A, B}
    above, below = loci.plot().axes
    assert below.get_xlabel() == "mass a.mass [kg]"
    colours = {line.get_label(): line.get_color() for line in above.lines if line.get_label() in (A, B)}
    assert set(colours.values()) == set(COLOURS[:2])
    for name, omega in ((A, 2 / np.sqrt(loci.values)), (B, np.full(30, 2.0))):
        for line in below.lines:
            if line.get_color() == colours[name]:
                assert line.get_ydata() == pytest.approx(omega, rel=1e-3)


def test_units_of_what_the_loci_run_over() -> None:
    s = two_masses()
    assert s.root_loci(parameters={"a.x.stiffness": [1.0, 2.0]}, progress=False).unit == "N/m"
    m = fx.Model()
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("pivot", "ground", "turn")
    m.point("O", (0, 0), fixed=True)
    m.body("disc", "O", "turn", mass=1.0, inertia=1.0)
    m.spring("pivot.angle", 2.0)
    given = {"pivot.angle.stiffness": [1.0, 2.0]}
    assert m.build().root_loci(parameters=given, progress=False).unit.startswith("N m")


def test_the_complex_plane_has_marks_at_both_ends() -> None:
    drawn = root_loci(SPEEDS, [bicycle(v) for v in SPEEDS], label="speed [m/s]", plane=True, limits=(-8, 4))
    (axes,) = drawn.axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("real part [1/s]", "imaginary part [rad/s]")
    legend = [text.get_text() for text in axes.get_legend().get_texts()]
    assert legend[-2:] == ["speed 0 m/s", "speed 10 m/s"] and len(legend) == 5
    assert axes.get_xlim() == (-8, 4)


def test_names_may_be_given_for_all_and_wrong_ones_are_refused() -> None:
    found = two_masses().root_loci(parameters={"mass a.mass": np.linspace(2.0, 0.4, 30)}, progress=False)
    above, _ = found.plot(names=["one", "other"], marks={"here": 1.0}, title="Two masses").axes
    assert {"one", "other"} < {text.get_text() for text in above.get_legend().get_texts()}
    assert [text.get_text() for text in above.texts] == ["here\n1"] and above.get_title() == "Two masses"
    with pytest.raises(fx.ModelError, match="give one for each of"):
        found.plot(names=["one"])
    with pytest.raises(fx.ModelError, match="variant 1; give a number from 0 to 0"):
        found.branches(1)
