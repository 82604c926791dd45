"""`flexel run` builds, simulates and saves a user's model, and says in one line what is wrong with a file."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

import flexel as fx
from flexel.apps.cli import main as cli

PENDULUM = """\
import flexel as fx

model = fx.Model(gravity=(0, 0, -9.81))
model.point("O", (0, 0, 0), fixed=True)
model.point("A", (1, 0, 0))
model.hinge("pivot", model.frame("R0", fixed=True), model.frame("R"), axis=(0, 1, 0))
model.beam("rod", "O", "R", "A", mass_per_length=2.0)
simulate = {"duration": 0.5, "samples": 11, "rtol": 1e-11}
"""


def written(folder: Path, text: str, name: str = "pendulum.py") -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli.main, ["run", *map(str, arguments)])


def test_a_model_is_built_simulated_and_saved(tmp_path: Path) -> None:
    result = run(written(tmp_path, PENDULUM), "--out", tmp_path / "results")
    assert result.exit_code == 0, result.output
    assert "1 degree of freedom (pivot.angle)" in result.stdout and "reached the end" in result.stdout
    motion = fx.load(tmp_path / "results" / "pendulum.npz")
    assert len(motion) == 11 and motion.t[-1] == 0.5
    assert np.ptp(motion.energy["total"]) < 1e-8


def test_the_command_line_comes_before_the_file(tmp_path: Path) -> None:
    file = written(tmp_path, PENDULUM)
    options = (
        "--time",
        0.2,
        "--samples",
        5,
        "--method",
        "generalized-alpha",
        "--format",
        "csv",
        "--format",
        "mat",
    )
    result = run(file, *options, "--out", tmp_path)
    assert result.exit_code == 0, result.output
    assert sorted(path.name for path in tmp_path.iterdir()) == ["pendulum.csv", "pendulum.mat", "pendulum.py"]
    assert fx.load(tmp_path / "pendulum.csv").t[-1] == pytest.approx(0.2, abs=1e-12)


def test_results_are_kept_under_out_by_default(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(written(tmp_path, PENDULUM).name).exit_code == 0
    assert (tmp_path / "out" / "pendulum" / "pendulum.npz").is_file()


def test_the_modes_about_the_end_are_printed(tmp_path: Path) -> None:
    still = PENDULUM + "model.initial('pivot.angle', 1.5707963267948966)\n"
    result = run(written(tmp_path, still), "--linearize", "--out", tmp_path)
    assert result.exit_code == 0, result.output
    line = next(line for line in result.stdout.splitlines()[::-1] if line.strip().startswith("pivot.angle"))
    assert float(line.split()[1]) == pytest.approx(np.sqrt(1.5 * 9.81), rel=1e-5)


def test_a_history_is_drawn(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="drawing needs matplotlib: pip install 'flexel[plot]'")
    result = run(written(tmp_path, PENDULUM), "--plot", "pivot.angle", "--plot", "A.z", "--out", tmp_path)
    assert result.exit_code == 0, result.output
    assert (tmp_path / "pendulum.png").stat().st_size > 5_000


def test_a_simulation_that_fails_keeps_its_motion(tmp_path: Path) -> None:
    driven = (
        PENDULUM.replace("(1, 0, 0)", "(0.6, 0, 0.8)") + "model.prescribe('A.x', lambda t: 0.6 - 4 * t)\n"
    )
    result = run(written(tmp_path, driven), "--time", 1, "--out", tmp_path)
    assert result.exit_code == 1
    assert "pendulum.py, line" in result.stderr or "pendulum.py:" in result.stderr
    end = fx.load(tmp_path / "pendulum.npz").t[-1]
    assert 0.39 < end < 0.4 + 1e-9
    assert f"the motion up to t = {end:g} s is kept" in result.stdout


def test_a_file_with_main_does_everything_itself(tmp_path: Path) -> None:
    own = "def main(out):\n    (out / 'answer.txt').write_text('42')\n    print('done')\n"
    result = run(written(tmp_path, own), "--out", tmp_path / "new")
    assert (result.exit_code, result.stdout) == (0, "done\n")
    assert (tmp_path / "new" / "answer.txt").read_text() == "42"
    assert run(written(tmp_path, own), "--time", 1, "--out", tmp_path / "new").exit_code == 2


def test_a_motion_that_main_returns_is_saved(tmp_path: Path) -> None:
    own = PENDULUM + "def main(out):\n    return model.build().simulate(0.1, samples=3)\n"
    result = run(written(tmp_path, own), "--out", tmp_path)
    assert result.exit_code == 0, result.output
    assert len(fx.load(tmp_path / "pendulum.npz")) == 3


def test_a_file_may_import_its_neighbour_and_guard_its_program(tmp_path: Path) -> None:
    written(tmp_path, "LENGTH = 0.25\n", "rodlength.py")
    text = PENDULUM.replace("(1, 0, 0)", "(LENGTH, 0, 0)").replace(
        "import", "from rodlength import LENGTH\nimport", 1
    )
    guarded = text + "if __name__ == '__main__':\n    raise RuntimeError\n"
    result = run(written(tmp_path, guarded), "--out", tmp_path)
    assert result.exit_code == 0, result.output
    assert fx.load(tmp_path / "pendulum.npz")["A.x"][0] == 0.25


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x = 1\n", "neither a fx.Model nor a function main"),
        ("x = '\0'\n", "pendulum.py: source code string cannot contain null bytes"),
        (
            "import flexel as fx\na = fx.Model()\nb = fx.Model()\n",
            "several models, a, b; name one of them model",
        ),
        (PENDULUM.replace("(1, 0, 0)", "(1, 0)"), "pendulum.py, line 7: "),
        (PENDULUM.replace("2.0)", "2.0"), "pendulum.py, line 7: '(' was never closed"),
        (PENDULUM + "1 / 0\n", "pendulum.py, line 9: ZeroDivisionError: division by zero"),
        (PENDULUM + "simulate = 3\n", "simulate is 3; make it a dict"),
        (
            PENDULUM + "simulate = {'duraton': 2.0}\n",
            "simulate: unknown option 'duraton'; did you mean duration?",
        ),
        (PENDULUM + "simulate = {'duration': -1.0}\n", "duration -1 s is not positive"),
        (PENDULUM + "simulate = {'length': 1.0, 'duration': 1.0}\n", "simulate: unknown option 'length'"),
        (PENDULUM + "model.spring('pivot.angel', 1.0)\n", "'pivot.angel'"),
        (PENDULUM + "def main(out):\n    raise OSError('full')\n", "line 10: OSError: full"),
    ],
)
def test_a_wrong_file_ends_in_one_line(tmp_path: Path, text: str, message: str) -> None:
    result = run(written(tmp_path, text), "--out", tmp_path)
    assert result.exit_code == 1
    assert message in result.stderr and "Traceback" not in result.output
    assert len(result.stderr.strip().splitlines()) == 1


def test_wrong_arguments_are_answered(tmp_path: Path) -> None:
    untimed = written(tmp_path, PENDULUM.replace('"duration": 0.5, ', ""))
    for arguments, message in (
        ((tmp_path / "missing.py",), "does not exist"),
        ((written(tmp_path, "", "model.txt"),), "give MODEL.py"),
        ((untimed, "--out", tmp_path), "give --time SECONDS"),
        ((untimed, "--method", "Euler"), "'Euler' is not one of 'auto', 'DOP853'"),
        ((untimed, "--time", "long"), "'long' is not a valid float"),
        ((untimed, "--time", 0.1, "--plot", "pivot.angel", "--out", tmp_path), "pivot.angle"),
    ):
        result = run(*arguments)
        assert result.exit_code != 0 and message in result.stderr, result.output


@pytest.mark.parametrize(
    "option",
    [("--format", "csv"), ("--time", 1), ("--plot", "o2.angle"), ("--linearize",)],
    ids=lambda option: option[0],
)
def test_options_of_models_are_refused_for_spacar_files(
    option: tuple[object, ...], tmp_path: Path, checkout: Path
) -> None:
    result = run(checkout / "tests" / "data" / "slider_crank.dat", "--out", tmp_path / "results", *option)
    assert result.exit_code == 2
    assert (
        "only the options --mode, --dialect, --warping, --compare, --log, --format mat and --out apply"
        in result.stderr
    )
    assert not (tmp_path / "results").exists()


def test_ctrl_c_keeps_the_motion_so_far(tmp_path: Path) -> None:
    long = PENDULUM + "simulate = {'duration': 1000.0, 'samples': 100001}\nprint('started', flush=True)\n"
    answer = interrupted(written(tmp_path, long), tmp_path)
    assert answer.stdout.startswith("started\nSystem(")
    assert "interrupted at t = " in answer.stdout and "Traceback" not in answer.stderr
    assert 1 < len(fx.load(tmp_path / "pendulum.npz")) < 100001


def test_ctrl_c_in_a_spacar_file_says_so_and_keeps_the_motion(tmp_path: Path, checkout: Path) -> None:
    text = (checkout / "tests" / "data" / "slider_crank.dat").read_text()
    file = written(tmp_path, text.replace("TIMESTEP 100 5.0", "TIMESTEP 20000 20.0"), "crank.dat")
    answer = interrupted(file, tmp_path)
    assert "interrupted at t = " in answer.stdout and "Traceback" not in answer.stderr
    motion = fx.load(tmp_path / "crank_motion.npz")
    assert isinstance(motion, fx.Motion) and 0 < motion.t[-1] < 20


# the interrupt comes when the motion has begun, however slow the machine
INTERRUPTING = """
import os, signal, sys
from flexel.apps.cli.main import main
from flexel.integration.dense_run import DenseRun

store = DenseRun._store

def interrupted(self, *arguments):
    if len(self.result.states) > 5:
        os.kill(os.getpid(), signal.SIGINT)
    return store(self, *arguments)

DenseRun._store = interrupted
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have left it ignored
main(["run", sys.argv[1], "--out", sys.argv[2]])
"""


def interrupted(file: Path, folder: Path) -> subprocess.CompletedProcess[str]:
    """What the command prints that gets Ctrl-C after some states of a motion."""
    command = [sys.executable, "-c", INTERRUPTING, str(file), str(folder)]
    answer = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert answer.returncode == 130, answer.stderr
    return answer
