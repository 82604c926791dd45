"""The published beam problems: rows within their tolerances, rates of convergence."""

from typing import Any

import numpy as np
import pytest
import quoted
from coarse import COARSE_MESH

from flexel.examples import beams_data as data
from flexel.examples import beams_dynamic as dynamic
from flexel.examples import beams_models as models
from flexel.examples import beams_static as static
from flexel.examples.convergence import elements_needed, order, romberg
from flexel.results.reproduction import Quantity

pytestmark = COARSE_MESH


def failures(rows: list[Quantity]) -> list[str]:
    return [f"{row.name}: {row.error}" for row in rows if not row.ok]


@pytest.fixture(scope="module")
def rows() -> list[Quantity]:
    """Those that need no search for meshes."""
    return [*static.large_deflections(), *static.buckling(), *dynamic.vibrations(), *dynamic.spin_up()]


@pytest.mark.long
def test_deflections_buckling_loads_frequencies_and_the_spin_up_are_reproduced(rows: list[Quantity]) -> None:
    assert failures(rows) == []


@pytest.mark.long
def test_the_tables_that_pages_quote_are_those_of_the_program(rows: list[Quantity]) -> None:
    """`make docs` computes all systems anew except the beams, whose search for meshes takes a minute."""
    found = {row.name: quoted.rounded(row.to_dict()) for row in rows}
    kept = quoted.kept()["beams"]
    assert set(found) <= {entry["name"] for entry in kept}
    tables = {"beams": [found.get(entry["name"], entry) for entry in kept]}
    assert quoted.differences(tables, quoted.kept()) == []
    page = quoted.DOCS / "beams.md"
    assert quoted.wrong(page.read_text(encoding="utf-8"), tables) == []


@pytest.mark.parametrize("second_order, largest", [(True, 4e-3), (False, 1e-2)])
def test_the_spin_up_beam_needs_the_second_order_terms(second_order: bool, largest: float) -> None:
    exact = dynamic.spin_case("simo")[1][:, 2]
    error = np.max(np.abs(dynamic.spin_tip("simo", 4, second_order, 1e-5)[:, 1] - exact)) / np.max(
        np.abs(exact)
    )
    assert (error < largest) == second_order


@pytest.mark.parametrize("load", [1.0, 10.0])
def test_the_elastica_converges_with_the_second_order(load: float) -> None:
    exact = next(np.array(tip) for P, *tip in data.TIP_FORCE if P == load)
    errors = [float(np.max(np.abs(static.elastica_tip(load, n) - exact))) for n in (8, 16, 32)]
    assert order(errors) == pytest.approx(2.0, abs=0.02)


@pytest.mark.long
def test_second_order_terms_save_elements_in_lateral_buckling() -> None:
    def error(second_order: bool) -> Any:
        return lambda n: abs(static.lateral_factor(n, second_order) / data.LATERAL_FACTOR - 1)

    assert elements_needed(error(True), (1e-2, 1e-3), 2) == [5, 16]
    assert elements_needed(error(False), (1e-2, 1e-3), 2) == [9, 27]


def test_a_spinning_blade_at_rest_in_its_frame_has_no_acceleration_there() -> None:
    system = models.blade(4, 3.0)
    state = system.steady()
    assert max(abs(state.acceleration(name)) for name in system.dynamic) < 1e-9
    assert state.rate("P4.y") == pytest.approx(3.0, rel=1e-12)


def test_the_limit_of_a_sequence_with_even_powers_is_found() -> None:
    values = [np.array([1.0 + 2.0 / n**2 - 3.0 / n**4]) for n in (2, 4, 8)]
    np.testing.assert_allclose(romberg(values), [1.0], atol=1e-14)


def test_too_many_elements_are_not_looked_for() -> None:
    assert elements_needed(lambda n: 1.0 / n, (0.1, 1e-6)) == [10, None]
