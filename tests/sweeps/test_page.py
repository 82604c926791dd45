"""The program of the page on sweeps runs as it stands, and the examples of a study."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import flexel as fx

pytest.importorskip("xarray", reason="sweeps need pip install 'flexel[sweep]'")
pytest.importorskip("joblib", reason="sweeps need pip install 'flexel[sweep]'")
PAGE = Path(__file__).resolve().parents[2] / "docs" / "sweeps.md"


def test_the_program_of_the_page_runs() -> None:
    found = re.search(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    names: dict[str, Any] = {"__name__": "__main__"}
    exec(found[1], names)
    assert names["data"].angle.shape == (3, 2, 5)
    assert names["data"].omega.sel(length=0.5).values == pytest.approx(np.sqrt(1.5 * 9.81 / 0.5), rel=1e-4)


@pytest.mark.slow
@pytest.mark.long
def test_the_hoist_is_studied_at_each_point() -> None:
    """One of the points that the example hands to a cluster; less damping gives a larger factor."""
    from flexel.examples.hoist_cluster import analyse, build

    points = [{"damping_ratio": ratio, "modulus": 1e11} for ratio in (0.03, 0.15)]
    found = fx.sweep(build, points, analyse, executor="serial")
    assert found.factor.values == pytest.approx(found.closed_form.values, rel=0.05)
    assert found.factor[0] > found.factor[1] + 0.15
