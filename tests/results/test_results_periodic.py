"""Periodic solutions and pictures of results: names, units, known amplitudes, files."""

from pathlib import Path

import numpy as np
import pytest
from mechanisms import oscillator

import flexel as fx
from flexel.apps.view.deflected import coordinates_of, mode_size, plot_shape
from flexel.results.periodic_motion import PeriodicSolution


@pytest.fixture(scope="module")
def solution() -> PeriodicSolution:
    return oscillator(0.6, cubic=0.2).periodic(period=2 * np.pi / 0.6, harmonics=7)


@pytest.mark.parametrize("suffix", [".npz", ".nc", ".mat", ".csv"])
def test_a_periodic_solution_comes_back_from_a_file(
    solution: PeriodicSolution, tmp_path: Path, suffix: str
) -> None:
    read = fx.load(solution.save(tmp_path / f"orbit{suffix}"))
    assert isinstance(read, PeriodicSolution)
    assert read.dofs == ("P.x",)
    assert read.unit("P.x'") == "m/s"
    assert np.array_equal(read["P.x"], solution["P.x"])
    assert np.array_equal(read.harmonics("P.x"), solution.harmonics("P.x"))
    assert np.array_equal(read.multipliers(), solution.multipliers())
    with pytest.raises(fx.ModelError, match="unknown degree of freedom 'P.y'"):
        read.harmonics("P.y")


def test_its_harmonics_sum_up_to_its_time_history(solution: PeriodicSolution) -> None:
    a = solution.harmonics("P.x")
    order = np.arange(a.size)
    total = np.real(np.exp(1j * solution.omega * np.outer(solution.t, order)) @ a)
    assert total == pytest.approx(solution["P.x"], abs=1e-10)
    assert "[m]" in solution.spectrum_plot().axes[0].get_ylabel()
    assert solution.to_pandas("P.x'").shape == (solution.t.size, 1)
    assert solution.to_xarray()["fourier"].sel(order="0", part="real").item() == pytest.approx(a[0].real)


def test_a_spectrum_shows_the_amplitude_of_a_free_vibration(tmp_path: Path) -> None:
    """ω = 1 rad/s, released 0.3 m from rest at 10 m; eight periods."""
    system = oscillator(1.0, zeta=0.0, push=0.0)
    start = system.state_at({"P.x": 10.3})
    motion = system.simulate(16 * np.pi, start=start, times=np.arange(256) * np.pi / 16, rtol=1e-10)
    f, amplitude = motion.spectrum("P.x", "boxcar")
    assert amplitude[[0, 8]] == pytest.approx([10.0, 0.3], abs=1e-7)
    assert f[8] == pytest.approx(1 / (2 * np.pi))
    assert np.max(np.delete(amplitude, [0, 8])) < 1e-7
    assert motion.plot_phase("P.x", path=tmp_path / "phase.png").axes[0].get_ylabel() == "P.x' [m/s]"
    uneven = system.simulate(3.0, start=start, times=[0.5, 1.0, 1.1, 3.0])
    with pytest.raises(fx.ModelError, match="are not equidistant"):
        uneven.spectrum_plot("P.x")


def test_a_mode_shape_is_drawn_a_tenth_of_the_model_large(tmp_path: Path) -> None:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.angle("wall", fixed=True)
    m.point("A", (2, 0))
    m.angle("tip")
    m.beam("leaf", "O", "wall", "A", "tip", EIz=1.0, mass_per_length=1.0)
    system = m.build()
    lin, first = system.linearize(), system.vibrations(count=1)[0]
    X = coordinates_of(system.structure, first.shape)
    i = system.structure.coordinate_of["A.y"]
    assert abs(X[i]) * mode_size(system.at_rest, X) == pytest.approx(0.2, rel=1e-3)
    drawn = plot_shape(system.at_rest, first.shape, tmp_path / "mode.png")
    assert np.abs(drawn.axes[0].lines[2].get_ydata()).max() == pytest.approx(0.2, rel=1e-3)
    assert lin.plot_mode(0, tmp_path / "mode2.png", phases=(0.0, 1.0)).axes[0].get_legend() is not None
    assert lin.plot(tmp_path / "poles.png").axes[0].get_xlabel() == "real part [1/s]"
