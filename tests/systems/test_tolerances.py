"""The tolerances of a flexure stage: a few points, and that the table can fail."""

import numpy as np
import pytest

import flexel as fx
from flexel.examples import tolerances as example

pytest.importorskip("xarray", reason="sweeps need pip install 'flexel[sweep]'")


def test_the_nominal_stage_is_the_guide_of_the_flexures() -> None:
    from flexel.examples.flexures import guide

    here = example.build(**example.NOMINAL).build().vibrations(count=1)[0].omega
    assert here == pytest.approx(
        guide(elements=example.ELEMENTS).build().vibrations(count=1)[0].omega, rel=1e-12
    )


def test_each_stage_has_the_frequency_of_the_closed_form() -> None:
    points = example.stages(8)
    found = fx.sweep(example.build, points, example.analyse, executor="serial").frequency
    assert found.dims == ("point", "mode") and found.attrs["units"] == "Hz"
    closed = [example.expected(points.point(i)) for i in range(8)]
    assert found.sel(mode=1).values == pytest.approx(closed, rel=1e-4)
    assert np.ptp(closed) > 0.02


def test_the_propagation_of_errors_is_that_of_the_closed_form() -> None:
    """By differences: half a deviation up and down in each parameter."""
    middle, parts = example.expected(example.NOMINAL), []
    for name, size in example.DEVIATIONS.items():
        up, down = (
            example.expected(example.NOMINAL | {name: example.NOMINAL[name] * (1 + sign * size / 2)})
            for sign in (1, -1)
        )
        parts.append((up - down) / middle)
    assert example.spread() == pytest.approx(float(np.linalg.norm(parts)), rel=0.01)


def test_a_row_of_other_frequencies_fails() -> None:
    closed = np.array([example.expected(example.stages(32).point(i)) for i in range(32)])
    found = np.column_stack([closed * (1 + 2e-4), 30 * closed, 31 * closed])
    verdicts = {row.name: row.ok for row in example.rows(found, closed)}
    assert not verdicts["lowest_p50"] and not verdicts["largest_difference"]
