"""The flexure mechanisms meet their closed forms, converge to them, and report what is over-constrained."""

from pathlib import Path

import numpy as np
import pytest
from system_rows import not_reproduced, rows_of

import flexel as fx
from flexel.examples import flexures as example
from flexel.examples import flexures_exact as exact


@pytest.fixture(scope="module")
def results() -> example.FlexureResults:
    return example.analyse()


@pytest.mark.long
def test_every_closed_form_is_met() -> None:
    rows = rows_of("flexures").values()
    assert not_reproduced("flexures") == {}
    assert sum(row["reference"] is not None for row in rows) >= 34
    assert {row["kind"] for row in rows} == {"closed form", "none"}


# -- the closed forms themselves, at their known limits -------------------------------------------


def test_guided_stiffness_without_axial_force_is_twelve_and_vanishes_at_the_euler_load() -> None:
    assert exact.guided_stiffness(2.0, 3.0, 1e-7) == pytest.approx(12 * 2.0 / 27, rel=1e-6)
    assert exact.guided_stiffness(1.0, 1.0, -(np.pi**2) * (1 - 1e-9)) == pytest.approx(0.0, abs=1e-6)


def test_pivot_stiffness_without_force_is_that_of_a_circular_arc_and_falls_by_a_sixth_of_the_tension() -> (
    None
):
    assert exact.pivot_stiffness(2.0, 3.0, 1e-9) == pytest.approx(2 / 3)
    slope = (exact.pivot_stiffness(1.0, 1.0, 1e-4) - exact.pivot_stiffness(1.0, 1.0, -1e-4)) / 2e-4
    assert slope == pytest.approx(-1 / 6, rel=1e-4)


def test_a_heavy_end_mass_and_a_light_one_bound_the_guided_frequency() -> None:
    assert exact.guided_frequency(1.0, 1.0, 1.0, 1e4) == pytest.approx(
        np.sqrt(12 / (1e4 + 13 / 35)), rel=1e-6
    )
    assert exact.guided_frequency(1.0, 1.0, 1.0, 0.0) == pytest.approx(2.365020372431352**2, rel=1e-9)


def test_elastica_is_the_tabulated_one() -> None:
    # Bisshop and Drucker 1945; the benchmark collection's elastica_cantilever.json, P L²/EI = 1
    w, drop = exact.cantilever_elastica(1.0)
    assert w == pytest.approx(0.30172077, abs=1e-7)
    assert drop == pytest.approx(0.05643324, abs=1e-7)


# -- physics over the range -----------------------------------------------------------------------


@pytest.mark.long
@pytest.mark.parametrize("case", ["guide", "pivot"])
def test_support_stiffness_falls_over_the_range_and_the_drive_keeps_its_own(
    results: example.FlexureResults, case: str
) -> None:
    stations = getattr(results, case)
    drive, guided = ("y", "x") if case == "guide" else ("turn z", "x")
    stiffness = [s.held.stiffness()[guided] for s in stations]
    assert np.all(np.diff(stiffness) < 0)
    assert stiffness[-1] < 0.05 * stiffness[0]
    assert stations[-1].free.stiffness()[drive] == pytest.approx(stations[0].free.stiffness()[drive], rel=0.1)


@pytest.mark.long
@pytest.mark.parametrize("case", ["guide", "pivot"])
def test_compliance_is_symmetric_and_positive_at_every_station(
    results: example.FlexureResults, case: str
) -> None:
    for s in getattr(results, case):
        scale = np.sqrt(np.diag(s.free.matrix))
        C = s.free.matrix / np.outer(scale, scale)
        np.testing.assert_allclose(C, C.T, atol=1e-8)
        assert np.linalg.eigvalsh(C)[0] > 0


@pytest.mark.long
def test_the_drive_compliance_is_the_slope_of_the_travel(results: example.FlexureResults) -> None:
    system = example.pivot().build()
    start = results.pivot[-1]
    near = [
        system.equilibrium(system.equilibrium(t=start.drive), t=start.drive + step) for step in (-1e-5, 1e-5)
    ]
    slope = (near[1]["turn.angle"] - near[0]["turn.angle"]) / 2e-5
    assert start.free.matrix[5, 5] == pytest.approx(slope, rel=1e-5)


@pytest.mark.long
def test_body_axes_turn_with_the_pivot(results: example.FlexureResults) -> None:
    last = results.pivot[-1]
    c, s = np.cos(last.travel), np.sin(last.travel)
    e_x = np.array([c, s, 0])
    assert last.free.in_body[0, 0] == pytest.approx(e_x @ last.free.matrix[:3, :3] @ e_x, rel=1e-9)


def test_stiffness_under_payload_converges_with_the_elements() -> None:
    payload = float(example.payloads(example.PIVOT)[0])
    expected = example.expected_stiffness(example.PIVOT, payload)

    def error(n: int) -> float:
        system = example.pivot(payload, elements=n).build()
        found = system.compliance("axis", "body frame", system.equilibrium(t=0.0))
        return abs(found.stiffness()["turn z"] / expected - 1)

    e = [error(n) for n in (2, 4, 8)]
    assert e[2] < 1e-4
    assert np.log2(e[1] / e[2]) > 1.8


def test_the_payload_beyond_the_closed_form_makes_the_drive_unstable() -> None:
    for make, d in example.CASES:
        push = example.critical(d)[0]
        assert example.drive_stiffness(make, d, -0.999 * push) > 0
        with pytest.warns(fx.UnstableWarning, match="unstable in 1 independent"):
            assert example.drive_stiffness(make, d, -1.001 * push) < 0


@pytest.mark.parametrize(("make", "d"), example.CASES, ids=["guide", "pivot"])
def test_over_constraint_is_refused_by_name_and_cured_by_the_named_releases(
    make: example.Maker, d: example.Design
) -> None:
    m = make(flexible=example.BENDING, elements=1)
    found = m.constraint_report()
    assert len(found.redundant) == 3
    assert any(name.endswith(".torsion") for named in found.redundant for name in named)
    with pytest.raises(fx.ConstraintError, match="over-constrained: 3 rigid"):
        m.build()
    m.release(*found.release)
    assert m.build().counts["degrees_of_freedom"] == 1


@pytest.mark.long
def test_figures_are_written(results: example.FlexureResults, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from flexel.examples.flexures_figures import pictures

    for file in pictures(results, tmp_path):
        assert file.stat().st_size > 20000


def test_a_bent_leaf_without_travel_is_a_cantilever() -> None:
    d = example.GUIDE
    C = np.linalg.inv(exact.end_stiffness(d.profile, d.length))
    places = np.ix_([2, 3, 4], [2, 3, 4])
    np.testing.assert_allclose(exact.bent_leaf(d.profile, d.length, 0.0), C[places], rtol=1e-10, atol=1e-16)


def test_support_stiffness_of_the_bent_guide_converges_to_that_of_curved_bars() -> None:
    d = example.GUIDE

    def errors(n: int) -> np.ndarray:
        system = example.guide(elements=n).build()
        state = system.equilibrium(t=1.25)
        found = system.compliance(d.point, d.frame, state, hold=[d.drive]).stiffness()
        expected = exact.bent_guide(d.profile, d.length, example.SPACING, state[d.drive])
        return np.array([found[key] / expected[key] - 1 for key in ("z", "turn x", "turn y")])

    e = [errors(n) for n in (4, 8, 16)]
    assert np.max(np.abs(e[-1])) < 6e-3
    assert np.all(np.log2(np.abs(e[0] / e[1])) > 1.7)
    assert np.all(np.log2(np.abs(e[1] / e[2])) > 1.7)
