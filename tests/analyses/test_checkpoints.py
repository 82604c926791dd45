"""Checkpoints of simulations: what is left of a killed one, and what goes on from it."""

import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from rides import SUFFIXES, ride, same

import flexel as fx
from flexel.integration.driver import Run
from flexel.results.analyses import checkpoints


class Killed(BaseException):
    """The end of a process, played in the same one."""


@pytest.fixture
def dies(monkeypatch: pytest.MonkeyPatch) -> Callable[[int], None]:
    """A process that ends after some steps, at once after it has written a checkpoint."""
    monkeypatch.setattr(checkpoints, "CHECKPOINT_INTERVAL_S", 0.0)
    write = checkpoints.Checkpoint.__call__

    def after(steps: int) -> None:
        left = [steps]

        def call(keeper: checkpoints.Checkpoint, run: Run) -> None:
            left[0] -= 1
            if left[0] == 0:
                write(keeper, run)
                raise Killed

        monkeypatch.setattr(checkpoints.Checkpoint, "__call__", call)

    return after


def pendulum() -> fx.System:
    """A damped pendulum of 1 m under gravity, with a driven pivot."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0.0, 0.0))
    m.fix("O.y")
    m.prescribe("O.x", fx.Harmonic(0.1, 3.0))
    m.point_mass("bob", m.point("P", (0.6, -0.8)), 2.0)
    m.truss("rod", "O", "P")
    m.spring("P.x", stiffness=2.0, damping=0.3)
    return m.build()


def killed_and_continued(
    dies: Callable[[int], None], path: Path, steps: int, simulate: Callable[[Path], fx.Motion]
) -> fx.Motion:
    """The motion of a simulation that is killed again and again."""
    for _ in range(200):
        dies(steps)
        try:
            return simulate(path)
        except Killed:
            assert len(fx.load(path)) > 1  # type: ignore[arg-type]
    raise AssertionError("it does not come to its end")


# Tolerance, steps between two deaths, and distance from the run without a break. Methods of many steps begin with short
# steps after each.
METHODS: dict[str, tuple[float, int, float]] = {
    "DOP853": (1e-9, 2, 5e-10),
    "Radau": (1e-8, 2, 2e-9),
    "generalized-alpha": (1e-6, 50, 1e-5),
}


@pytest.mark.parametrize("method", METHODS)
def test_a_killed_simulation_goes_on(tmp_path: Path, dies: Callable[[int], None], method: str) -> None:
    """Killed after every few steps, it ends where the run without a break does, with the same samples."""
    rtol, steps, tolerance = METHODS[method]

    def simulate(path: Path | None) -> fx.Motion:
        return pendulum().simulate(1.0, samples=7, method=method, checkpoint=path, rtol=rtol)

    whole = simulate(None)
    found = killed_and_continued(dies, tmp_path / "run.npz", steps, simulate)
    assert "continued from a checkpoint" in found.message
    assert np.array_equal(found.t, whole.t)
    assert np.max(np.abs(found.x - whole.x)) < tolerance
    assert found.statistics["steps"] >= whole.statistics["steps"]


def test_the_energy_balance_goes_on(tmp_path: Path, dies: Callable[[int], None]) -> None:
    """What was dissipated and supplied before a break is counted."""

    def simulate(path: Path | None) -> fx.Motion:
        return pendulum().simulate(1.0, samples=7, method="generalized-alpha", step=0.01, checkpoint=path)

    whole = simulate(None).energy_balance()
    found = killed_and_continued(dies, tmp_path / "run.npz", 13, simulate).energy_balance()
    for name in ("dissipated", "work"):
        assert np.max(np.abs(found[name] - whole[name])) < 2e-3 * np.max(np.abs(whole[name])), name
    assert np.max(np.abs(found["error"])) < 2e-3 * np.max(found["kinetic"])


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_rolling_wheels_and_events_go_on(tmp_path: Path, dies: Callable[[int], None], suffix: str) -> None:
    """Events before a break are kept; the complete motion is returned from its file to the last digit."""
    event = fx.Event("upright", lambda state: state["lean.angle"])

    def simulate(path: Path | None) -> fx.Motion:
        return ride(3.0, 6, events=[event], checkpoint=path)

    whole = simulate(None)
    path = tmp_path / f"run{suffix}"
    found = killed_and_continued(dies, path, 20, simulate)
    assert len(whole.events) > 1
    assert [state.t for _, state in found.events] == pytest.approx(
        [state.t for _, state in whole.events], abs=1e-8
    )
    assert np.max(np.abs(found.x - whole.x)) < 1e-8
    again = simulate(path)
    assert again.message == found.message
    assert all(same(a, b) for a, b in zip(again, found, strict=True))
    with pytest.raises(fx.ModelError, match="comes from a file"):
        found.at(0.0)


def test_an_interrupted_simulation_goes_on(tmp_path: Path, dies: Callable[[int], None]) -> None:
    """Ctrl-C hands over the motion so far, and writes it."""
    path, impatient = tmp_path / "run.npz", [True]

    def interrupt(state: fx.State) -> float:
        if impatient[0] and state.t > 0.4:
            raise KeyboardInterrupt
        return 1.0

    def simulate() -> fx.Motion:
        return pendulum().simulate(1.0, samples=3, events=[fx.Event("never", interrupt)], checkpoint=path)

    with pytest.raises(KeyboardInterrupt) as caught:
        simulate()
    first = caught.value.motion  # type: ignore[attr-defined]
    assert first.message.startswith("interrupted") and first.t[-1] < 1.0
    impatient[0] = False
    assert np.array_equal(simulate().t, [0.0, 0.5, 1.0])


def test_a_file_of_something_else_is_not_overwritten(tmp_path: Path) -> None:
    """Neither another result nor the checkpoint of another simulation."""
    path = tmp_path / "run.npz"
    motion = pendulum().simulate(0.1)
    motion.save(path)
    with pytest.raises(fx.ModelError, match="not a checkpoint"):
        pendulum().simulate(0.1, checkpoint=path)
    path.unlink()
    pendulum().simulate(0.1, checkpoint=path)
    saved = path.read_bytes()
    other = fx.Model()
    other.point_mass("bob", other.point("P", (0.0, 0.0)), 1.0)
    start = pendulum()
    differing = {
        "stored times": lambda: pendulum().simulate(0.2, checkpoint=path),
        "method and its options": lambda: pendulum().simulate(0.1, rtol=1e-6, checkpoint=path),
        "model": lambda: other.build().simulate(0.1, checkpoint=path),
        "start": lambda: start.simulate(
            0.1, start=start.state(0.0, motion[-1].x, motion[-1].v), checkpoint=path
        ),
    }
    for part, simulate in differing.items():
        with pytest.raises(fx.ModelError, match=f"to another simulation .*{part}.*delete it"):
            simulate()
    assert path.read_bytes() == saved
    path.write_bytes(saved[:100])
    with pytest.raises(fx.ModelError, match="damaged"):
        pendulum().simulate(0.1, checkpoint=path)


MODEL = """
import flexel as fx
from flexel.results.analyses import checkpoints

checkpoints.CHECKPOINT_INTERVAL_S = 0.01
model = fx.Model(gravity=(0, -9.81))
model.point("O", (0.0, 0.0), fixed=True)
model.point_mass("bob", model.point("P", (0.6, -0.8)), 2.0)
model.truss("rod", "O", "P")
simulate = {"duration": 120.0, "samples": 41, "method": "DOP853", "max_step": 5e-3}
"""


@pytest.mark.slow
@pytest.mark.long
def test_a_killed_command_goes_on(tmp_path: Path) -> None:
    """`flexel run --checkpoint`, killed for good at some moment after its first checkpoint."""
    model = tmp_path / "swing.py"
    model.write_text(MODEL)
    command = [sys.executable, "-m", "flexel", "run", str(model), "--out", str(tmp_path), "--checkpoint"]
    path = tmp_path / "swing.checkpoint.npz"
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        while not path.exists() and process.poll() is None:
            time.sleep(0.01)
        time.sleep(0.1)
        os.kill(process.pid, signal.SIGKILL)
    found = fx.load(path)
    assert isinstance(found, fx.Motion) and 0.0 < found.t[-1] < 120.0
    ended = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    assert "continued from a checkpoint" in ended
    complete = fx.load(tmp_path / "swing.npz")
    assert isinstance(complete, fx.Motion) and np.array_equal(complete.t, np.linspace(0, 120, 41))


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_folder_that_does_not_exist_is_refused_before_the_first_step(
    suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Run, "forward", lambda _, most: pytest.fail("a step was taken"))
    path = tmp_path / "missing" / f"motion{suffix}"
    with pytest.raises(fx.FlexelError, match="simulate: checkpoint '.*missing.*No such file or directory"):
        pendulum().simulate(1.0, checkpoint=path)


def test_the_trial_of_a_checkpoint_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither a file of the start, nor one beside it."""

    def stop(_: Run, most: int) -> None:
        assert not list(tmp_path.iterdir())
        raise Killed

    monkeypatch.setattr(Run, "forward", stop)
    with pytest.raises(Killed):
        pendulum().simulate(1.0, checkpoint=tmp_path / "motion.npz")


def test_a_disk_that_becomes_full_hands_the_motion_over(tmp_path: Path) -> None:
    """The limit of the size of files lets the trial of one state through, and not the motion of many."""
    path = tmp_path / "motion.csv"
    before, kept = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    system = pendulum()
    whole = system.simulate(1.0)
    system.simulate(1e-3, samples=2).save(path)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4 * path.stat().st_size, before[1]))
    path.unlink()
    try:
        with pytest.raises(fx.FlexelError, match="simulate: checkpoint '.*File too large") as caught:
            system.simulate(1.0, checkpoint=path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, kept)
    assert caught.value.motion["P.x"] == pytest.approx(whole["P.x"], abs=1e-12)
    assert not list(tmp_path.iterdir())
