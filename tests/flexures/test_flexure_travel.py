"""Loads that act both ways, the stiffness over the travel, and reasons for columns that are empty."""

from pathlib import Path

import flexure_tables as tables
import numpy as np
import pytest

import flexel as fx

BOTH = {"steps": 2, "both_ways": True, "frequencies": 2, "buckling": 2}
ONE = BOTH | {"both_ways": False}


def test_loads_act_both_ways_around_the_initial_ones() -> None:
    loads = {"force_initial": (0, -5.0, 0), "force": (8.0, 0, 0)}
    both = fx.flexure(*tables.guide(tables.IDEAL, **loads), BOTH)
    forward = fx.flexure(*tables.guide(tables.IDEAL, **loads), ONE)
    reverse = fx.flexure(*tables.guide(tables.IDEAL, **loads | {"force": (-8.0, 0, 0)}), ONE)
    assert both.load.tolist() == [-1.0, -0.5, 0.0, 0.5, 1.0]
    for name in ("displacements", "quaternions", "frequencies", "buckling", "stress"):
        found, ahead, back = (getattr(result, name) for result in (both, forward, reverse))
        np.testing.assert_allclose(found[2:], ahead, rtol=1e-7, atol=1e-12)
        np.testing.assert_allclose(found[2::-1], back, rtol=1e-7, atol=1e-12)


def test_prescribed_turns_act_both_ways() -> None:
    found = fx.flexure(*tables.hinge(tables.IDEAL, rotation={"z": 0.2}), BOTH)
    assert found.euler_angles[:, 4, 0] == pytest.approx([-0.2, -0.1, 0.0, 0.1, 0.2], abs=1e-12)
    assert found.moments[:, 4, 2] == pytest.approx(-found.moments[::-1, 4, 2], rel=1e-6, abs=1e-9)


def test_a_turn_of_half_a_turn_backwards_is_refused() -> None:
    turn = {"rotation_initial": {"z": -1.0}, "rotation": {"z": 2.5}}
    with pytest.raises(fx.ModelError, match=r"rotation of -3\.5 rad; give less than half a turn"):
        fx.flexure(*tables.hinge(tables.IDEAL, **turn), BOTH)
    with pytest.raises(fx.ModelError, match="both_ways"):
        fx.flexure(*tables.hinge(tables.IDEAL), {"both_ways": "yes"})


def test_stiffness_over_the_travel_is_that_of_every_step(tmp_path: Path) -> None:
    found = fx.flexure(*tables.guide(force=(5.0, 0, 0)), ONE)
    for body_axes in (False, True):
        stiffness = found.stiffness(5, body_axes)
        for step, row in zip(found.steps, stiffness, strict=True):
            compliance = step.node(5).compliance
            assert compliance is not None
            assert row == pytest.approx(list(compliance.stiffness(body_axes).values()), rel=1e-13)
    pytest.importorskip("matplotlib", reason="pictures need pip install 'flexel[plot]'")
    figure = found.plot_stiffness(5, path=tmp_path / "stiffness.png")
    above, below = figure.axes
    assert [line.get_label() for line in above.lines] == ["x", "y", "z"]
    assert [line.get_label() for line in below.lines] == ["turn x", "turn y", "turn z"]
    assert below.get_xlabel() == "displacement of node 5 in x [mm]" and above.get_yscale() == "log"
    np.testing.assert_allclose(above.lines[1].get_ydata(), found.stiffness(5)[:, 1])
    assert found.plot_stiffness(5, "y").axes[-1].get_xlabel().endswith("in y [mm]")
    with pytest.raises(fx.ModelError, match="plot_stiffness.*'up'.*x, y, z"):
        found.plot_stiffness(5, "up")


def test_what_cannot_move_is_rigid() -> None:
    """At the drawn position, which the path passes within rounding, nothing gives way across the leaves."""
    found = fx.flexure(*tables.guide(tables.IDEAL, displacement={"x": 0.01}), BOTH)
    stiffness = found.stiffness(5)
    assert np.isinf(stiffness[2]).all() and np.isinf(stiffness[:, 0]).all()
    assert np.isfinite(stiffness[[0, 1, 3, 4], 1:]).all()


def test_a_mode_is_followed_through_the_list(tmp_path: Path) -> None:
    """The support becomes soft with the travel: its frequency falls past two others that stay."""
    found = fx.flexure(*tables.guide(tables.IDEAL, force=(8.0, 0, 0)), {"steps": 8, "frequencies": 3})
    lines = found.tracked_frequencies
    assert [name.partition(": ")[0] for name in lines] == [str(k) for k in range(1, 1 + len(lines))]
    lowest = np.sort(np.array(list(lines.values())), axis=0)[:3].T
    np.testing.assert_allclose(lowest, found.frequencies)
    falling = [values for values in lines.values() if values[0] > 400 and values[-1] < 150]
    assert falling and all(np.isfinite(line).all() and (np.diff(line) < 0).all() for line in falling)
    found.save(tmp_path / "guide.nc")
    again = fx.load(tmp_path / "guide.nc")
    assert list(again.tracked_buckling) == list(found.tracked_buckling)
    for name, values in lines.items():
        np.testing.assert_array_equal(again.tracked_frequencies[name], values)
    earlier = {name: given for name, given in found.variables.items() if not name.startswith("tracked")}
    file = fx.Flexure(found.motion, earlier, found.labels, (), (), ())
    lowest = np.sort(np.array(list(file.tracked_frequencies.values())), axis=0)[:3].T
    np.testing.assert_allclose(lowest, found.frequencies)


def test_an_empty_column_says_why() -> None:
    turned = fx.flexure(*tables.hinge(tables.IDEAL, rotation={"z": 0.1}), ONE)
    assert turned.notes == ("no buckling multipliers: no force or moment acts",)
    assert turned.notes[0] in str(turned)
    nodes, elements, properties, groups = tables.guide(tables.IDEAL, force=(1.0, 0, 0))
    properties[5] = {"force": (1.0, 0, 0)}
    group = {key: value for key, value in groups[0].items() if key != "material"} | {"E": 2e11, "G": 8e10}
    light = fx.flexure(nodes, elements, properties, [group], ONE)
    assert any(note.startswith("no frequencies: nothing has mass") for note in light.notes)
    assert light.frequencies.size == 0 and light.tracked_frequencies == {}
