"""The states that a motion stores are those at the times that the user asks for."""

from pathlib import Path

import mechanisms
import numpy as np
import pytest
from campaign.accuracy import histories

import flexel as fx
from flexel.results.analyses import checkpoints

METHODS = {
    "DOP853": {"rtol": 1e-11, "atol": 1e-12},
    "Radau": {"rtol": 1e-11, "atol": 1e-12},
    "generalized-alpha": {},
}


def falling() -> fx.System:
    """A mass that falls and is resisted: y(t) is known, and energy is lost."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point_mass("mass", "A", 2.0)
    m.spring("A.y", damping=1.0)
    return m.build()


def height(t: float) -> float:
    """Of the mass, in closed form: its speed tends to m g / c with the time constant m / c."""
    return -9.81 * 2 * (t - 2 * (1 - np.exp(-t / 2)))


@pytest.mark.parametrize("method", METHODS)
def test_a_motion_holds_the_states_at_the_given_times_and_no_others(method: str) -> None:
    motion = falling().simulate(1, times=[0.5, 1], method=method, **METHODS[method])
    assert motion.t.tolist() == [0.5, 1.0]
    exact = [height(0.5), height(1.0)]
    assert motion["A.y"] == pytest.approx(exact, rel=1e-4 if method == "generalized-alpha" else 1e-9)
    assert len(falling().simulate(1, times=[0, 0.5, 1], method=method)) == 3
    assert len(falling().simulate(1, times=[1], method=method)) == 1


def test_an_ensemble_holds_the_given_times_too() -> None:
    found = falling().simulate_many(
        1, initial={"A.displacement.along": np.zeros(9)}, outputs=["A.y"], times=[0.5, 1]
    )
    assert found.t.tolist() == [0.5, 1.0]
    assert found["A.y"] == pytest.approx(np.tile([height(0.5), height(1.0)], (9, 1)), rel=1e-6)


def test_the_energy_balance_counts_from_the_start_of_the_motion(tmp_path: Path) -> None:
    """Its error, dissipation and work do not depend on whether the start is stored; nor those of a saved motion."""
    options = {"method": "generalized-alpha", "rtol": 1e-3}
    whole = falling().simulate(1, times=[0, 0.5, 1], **options)
    part = falling().simulate(1, times=[0.5, 1], **options)
    saved = fx.load(part.save(tmp_path / "part.npz"))
    for name, values in whole.energy_balance().items():
        assert part.energy_balance()[name] == pytest.approx(values[1:], abs=1e-14), name
        assert saved.energy_balance()[name] == pytest.approx(values[1:], abs=1e-14), name
    assert abs(part.energy_balance()["error"][0]) > 1e-12


def test_a_checkpoint_holds_them_and_continues_with_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(checkpoints, "CHECKPOINT_INTERVAL_S", 0.0)
    path, calls = tmp_path / "motion.npz", []

    def stops(state: fx.State) -> float:
        calls.append(state.t)
        if len(calls) == 4:
            raise KeyboardInterrupt
        return 1.0

    event = fx.Event("never", stops)
    with pytest.raises(fx.Interrupted) as caught:
        falling().simulate(1, times=[0.5, 1], events=[event], checkpoint=path, max_step=0.05)
    cut = caught.value.motion
    assert "interrupted" in cut.message and len(cut) == 1 and cut.t[0] < 0.5
    motion = falling().simulate(1, times=[0.5, 1], events=[event], checkpoint=path, max_step=0.05)
    assert motion.t.tolist() == fx.load(path).t.tolist() == [0.5, 1.0]
    again = falling().simulate(1, times=[0.5, 1], events=[event], checkpoint=path, max_step=0.05)
    assert again.t.tolist() == [0.5, 1.0]
    assert motion["A.y"] == pytest.approx([height(0.5), height(1.0)], rel=1e-6)


def test_a_motion_that_ends_early_keeps_its_last_state() -> None:
    low = fx.Event("low", lambda state: state["A.y"] + 0.1, terminal=True)
    motion = falling().simulate(1, times=[0.5, 1], events=[low])
    assert len(motion) == 1 and motion["A.y"][0] == pytest.approx(-0.1, abs=1e-9)


def test_states_within_steps_are_as_exact_as_those_at_their_ends() -> None:
    """A rolling disc, relative to the range of each quantity: 1.2e-8 by the interpolation of order 7 alone."""
    system = mechanisms.disc(1.1, (2.0, 0.4, -5.0)).build()
    found, reference = (
        histories(system.simulate(1.0, method="DOP853", rtol=rtol, max_step=longest))
        for rtol, longest in ((1e-9, 1.0), (1e-12, 1 / 120))
    )
    error = np.max(np.abs(found.values - reference.values), axis=0)
    assert np.all(error[reference.moving] < 5e-9 * reference.ranges[reference.moving])
