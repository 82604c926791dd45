"""Saved files appear whole or not at all, and damage is found: no crash, full disk or flipped bit goes unnoticed."""

import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from rides import SUFFIXES, same

import flexel as fx
from flexel.base.files import replacing
from flexel.results.saved import files

WRITER = """
import sys, time
import flexel as fx
from mechanisms import pendulum
motion = pendulum().simulate(0.5, samples=200)
print("ready", flush=True)
while True:
    motion.save(sys.argv[1])
"""
LIMITED = """
import resource, signal, sys
import flexel as fx
from mechanisms import pendulum
motion = pendulum().simulate(0.5, samples=200)
motion.save("small.npz")
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
try:
    motion.save(sys.argv[1])
except fx.FlexelError as error:
    print(error)
"""


def run(program: str, *arguments: str, **options: object) -> subprocess.Popen[str]:
    paths = os.pathsep.join(sys.path)
    environment = os.environ | {"PYTHONPATH": paths}
    command = [sys.executable, "-c", program, *arguments]
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment, **options)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_kill_at_any_moment_leaves_a_whole_file(motion: fx.Motion, tmp_path: Path, suffix: str) -> None:
    path = motion.save(tmp_path / f"run{suffix}")
    rng = np.random.default_rng(5)
    for _ in range(4):
        with run(WRITER, str(path)) as process:
            assert process.stdout is not None and process.stdout.readline() == "ready\n"
            time.sleep(rng.uniform(0.02, 0.3))
            process.send_signal(signal.SIGKILL)
        assert len(fx.load(path)) in (len(motion), 200)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_full_disk_leaves_the_old_file(motion: fx.Motion, tmp_path: Path, suffix: str) -> None:
    path = motion.save(tmp_path / f"run{suffix}")
    before = path.read_bytes()
    with run(LIMITED, str(path), cwd=tmp_path) as process:
        said = process.communicate()[0]
    assert (
        process.returncode == 0 and f"save '{path}'" in said and "what was there before is unchanged" in said
    )
    assert path.read_bytes() == before
    assert sorted(z.name for z in tmp_path.iterdir()) == sorted([path.name, "small.npz"])


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_damage_is_found(motion: fx.Motion, tmp_path: Path, suffix: str) -> None:
    """Bytes are changed, added and cut off; what is still read is what was saved."""
    path = motion.save(tmp_path / f"run{suffix}")
    whole, rng, refused = path.read_bytes(), np.random.default_rng(7), 0
    for i in range(60):
        data = bytearray(whole)
        place = int(rng.integers(len(data)))
        if i % 3 == 0:
            data[place] ^= 1 << int(rng.integers(8))
        elif i % 3 == 1:
            data[place : place + 8] = rng.bytes(8)
        else:
            del data[place:]
        path.write_bytes(bytes(data))
        try:
            read = fx.load(path)
        except fx.FlexelError as error:
            refused += 1
            assert str(path) in str(error)
        else:
            assert np.array_equal(read.t, motion.t) and all(
                same(a, b) for a, b in zip(read, motion, strict=True)
            )
    assert refused >= 30  # the rest of the damage is in what is not read


def test_a_failing_writer_leaves_nothing_behind(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("old")
    path.chmod(0o640)
    with pytest.raises(ZeroDivisionError), replacing(path) as part:
        part.write_text("new")
        raise ZeroDivisionError
    assert path.read_text() == "old" and list(tmp_path.iterdir()) == [path]
    link = tmp_path / "link.txt"
    link.symlink_to(path)
    with replacing(link) as part:
        part.write_text("new")
    assert link.is_symlink() and path.read_text() == "new" and path.stat().st_mode & 0o777 == 0o640
    with replacing("/dev/null") as part:
        part.write_text("gone")
    with pytest.raises(fx.FlexelError, match="No such file or directory.*path of a folder"):
        with replacing(tmp_path / "missing" / "a.txt"):
            pass


def test_of_two_writers_the_last_one_wins(motion: fx.Motion, tmp_path: Path) -> None:
    path = tmp_path / "run.npz"
    with run(WRITER, str(path)) as one, run(WRITER, str(path)) as two:
        for process in (one, two):
            assert process.stdout is not None and process.stdout.readline() == "ready\n"
        for _ in range(20):
            if path.exists():
                assert len(fx.load(path)) == 200
            time.sleep(0.01)
        one.kill(), two.kill()
    assert set(files.FORMATS) == set(SUFFIXES)
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] != 2000
