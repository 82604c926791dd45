"""Results that do not exist are reported with those that do."""

from typing import Any

import pytest
from mistakes import pendulum

from flexel.apps.spacar.reading import read_spacar
from flexel.base.errors import ModelError, UnsteadyWarning


def test_results_that_do_not_exist_are_reported_with_those_that_do(tmp_path: Any) -> None:
    system = pendulum().build()
    motion, lin = system.simulate(0.1, times=[0.0]), system.linearize()
    with pytest.raises(ModelError, match=r"motion\[0.05\]: .* motion.at\(0.05\)"):
        motion[0.05]
    with (
        pytest.warns(UnsteadyWarning, match="modes: the state accelerates"),
        pytest.raises(ModelError, match="mode 7: there are 2 modes, numbered from 0"),
    ):
        lin.plot_mode(7)
    with pytest.raises(ModelError, match="periodic: period 0 is not positive"):
        system.periodic(period=0.0, harmonics=3)
    with pytest.raises(ModelError, match="periodic: harmonics 0; give a whole number, 1 or more"):
        system.periodic(period=1.0, harmonics=0)
    with pytest.raises(ModelError, match="read_spacar '.*none.dat': the file does not exist"):
        read_spacar(tmp_path / "none.dat")
    pytest.importorskip("matplotlib", reason="drawing needs matplotlib: pip install 'flexel[plot]'")
    assert motion.plot("A.z").axes[0].lines[0].get_xdata().size == 1  # of a single state, without a warning
