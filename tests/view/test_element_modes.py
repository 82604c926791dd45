"""Elements are moved along one deformation or slip at a time, and pictures show them; their modes are counted."""

from pathlib import Path

import numpy as np
import pytest

import flexel as fx
from flexel.apps.view.element_modes import Counts, element_counts, element_modes, plot_element
from flexel.base.quaternions import matrix
from flexel.examples.elements import ELEMENTS
from flexel.model.structure import Structure

COUNTS = {
    "planar_truss": Counts(4, 1, 0, 0, 3),
    "planar_beam": Counts(6, 3, 0, 0, 3),
    "truss": Counts(6, 1, 0, 0, 5),
    "hinge": Counts(8, 3, 2, 0, 3),
    "beam": Counts(14, 6, 2, 0, 6),
    "wheel": Counts(10, 4, 1, 2, 3),
}


def drawn(name: str) -> fx.State:
    return ELEMENTS[name].make().build().initial


def norms(s: Structure) -> list[int]:
    return [i for i, kind in enumerate(s.kinds) if kind == "norm"]


def test_every_element_shown_is_counted() -> None:
    assert list(COUNTS) == list(ELEMENTS)


@pytest.mark.parametrize("name", ELEMENTS)
def test_modes_are_counted_in_a_model_too(name: str) -> None:
    """The counts are those of tests/derive/test_modes_of_elements.py, here with other rows and columns beside them."""
    found = element_counts(drawn(name), name)
    assert found == COUNTS[name]
    assert found.deformations + found.norms + found.slips == found.coordinates - found.left


@pytest.mark.parametrize("name", ELEMENTS)
def test_one_deformation_grows_and_the_others_keep_their_values(name: str) -> None:
    state = drawn(name)
    s, modes = state.structure, element_modes(state, name, 0.3)
    assert [mode.name for mode in modes if not mode.slip] == [
        d.name for d in s.element(name).spec.deformations
    ]
    for mode in (mode for mode in modes if not mode.slip):
        e, _ = state.evaluation.position(mode.state.x)
        grown = np.zeros(s.m)
        grown[s.index[f"{name}.{mode.name}"]] = mode.amount
        held = [*(s.index[d] for d in s.element(name).deformations), *norms(s)]
        np.testing.assert_allclose((e - state.e)[held], grown[held], atol=1e-12)
        assert abs(mode.amount) > 0.1


def test_one_slip_moves_the_wheel_and_deforms_nothing() -> None:
    """Longitudinal: the wheel slides ahead; lateral: it slides sideways; spin: it turns about the normal."""
    state = drawn("wheel")
    modes = {mode.name: mode for mode in element_modes(state, "wheel", 0.2) if mode.slip}
    assert list(modes) == ["longitudinal", "lateral", "spin"]
    for mode in modes.values():
        e, _ = state.evaluation.position(mode.state.x)
        np.testing.assert_allclose(e, 0, atol=1e-12)
    ahead, sideways, spun = (modes[name] for name in modes)
    for mode, direction in ((ahead, [1, 0, 0]), (sideways, [0, 1, 0])):
        for node in ("w", "c"):
            moved = np.abs(mode.state.position(node) - state.position(node))
            np.testing.assert_allclose(moved, mode.amount * np.array(direction), atol=3e-3)
        np.testing.assert_allclose(matrix(mode.state.position("r")), np.eye(3), atol=1e-2)
    R = matrix(spun.state.position("r"))
    assert np.arccos(R[0, 0]) == pytest.approx(spun.amount, rel=1e-4)
    np.testing.assert_allclose(R[2], [0, 0, 1], atol=1e-12)


def test_bending_modes_of_a_beam_turn_one_end_each() -> None:
    """Displacements count more than rotations: the ends stay nearly where they are, as in textbooks."""
    state = drawn("planar_beam")
    modes = {mode.name: mode.state for mode in element_modes(state, "planar_beam", 0.3)}
    p, q = (modes["bend1"].position(f"r{end}")[0] for end in "pq")
    assert abs(p) > 0.2 and abs(q) < 0.05
    p, q = (modes["bend2"].position(f"r{end}")[0] for end in "pq")
    assert abs(q) > 0.2 and abs(p) < 0.05
    stretched = modes["elongation"]
    np.testing.assert_allclose(stretched.position("p"), -(stretched.position("q") - [1, 0]), atol=1e-12)
    assert stretched.position("q")[0] - stretched.position("p")[0] == pytest.approx(1.3)


@pytest.mark.parametrize("name", ["planar_beam", "wheel"])
def test_the_picture_has_a_panel_for_each_mode(name: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="pictures need matplotlib: pip install 'flexel[plot]'")
    state = drawn(name)
    figure = plot_element(state, name, tmp_path / "element.png")
    spec = state.structure.element(name).spec
    titles = [axes.get_title() for axes in figure.axes if axes.get_title()]
    assert titles[0] == "as drawn" and len(titles) == 1 + len(spec.deformations) + len(spec.slips)
    for title, mode in zip(titles[1:], (*spec.deformations, *spec.slips), strict=True):
        assert mode.name in title
    assert (tmp_path / "element.png").stat().st_size > 10_000


def test_an_unknown_element_is_named() -> None:
    with pytest.raises(fx.ModelError, match="rod"):
        element_modes(drawn("truss"), "rod")
