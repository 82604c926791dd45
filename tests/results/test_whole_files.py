"""Saved files appear whole or not at all, and damage is found: no crash, full disk or flipped bit goes unnoticed."""

import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from rides import SUFFIXES, same

import flexel as fx
from flexel.base.files import replacing
from flexel.results.saved import record_files

PROCESSES = """
import os, resource, signal, sys
import flexel as fx
from mechanisms import pendulum

motion = pendulum().simulate(0.5, samples=200)
for suffix in sys.argv[1:]:
    motion.save(f"small{suffix}")  # imports what it needs

def writer(path):
    while True:
        motion.save(path)

def limited(path):
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
    try:
        motion.save(path)
    except fx.FlexelError as error:
        print(error, flush=True)

print("ready", flush=True)
for line in sys.stdin:
    what, given = line.rstrip("\\n").split(" ", 1)
    if what == "wait":
        print("ended", os.waitpid(int(given), 0)[1], flush=True)
        continue
    said, tell = os.pipe()
    child = os.fork()
    if not child:
        os.read(said, 1)  # its number is printed first
        globals()[what](given)
        os._exit(0)
    print(child, flush=True)
    os.write(tell, b".")
"""


class Processes:
    """Processes that save motions; each is a copy of one that has a motion and all imports."""

    def __init__(self, folder: Path) -> None:
        environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
        command = [sys.executable, "-c", PROCESSES, *SUFFIXES]
        pipe = subprocess.PIPE
        self._first = subprocess.Popen(
            command, stdin=pipe, stdout=pipe, text=True, cwd=folder, env=environment, bufsize=1
        )
        assert self._line() == "ready"

    def _line(self) -> str:
        assert self._first.stdout is not None
        return self._first.stdout.readline().rstrip()

    def _ask(self, what: str, given: object) -> str:
        assert self._first.stdin is not None
        self._first.stdin.write(f"{what} {given}\n")
        return self._line()

    def start(self, what: str, path: Path) -> int:
        """Start a process that saves to a file, again and again (`writer`) or beyond a limit (`limited`)."""
        return int(self._ask(what, path))

    def ended(self, process: int, *, said: int = 0) -> tuple[list[str], int]:
        """The lines that a process has printed, and its status when it has ended."""
        lines = [self._ask("wait", process)] + [self._line() for _ in range(said)]
        end = next(line for line in lines if line.startswith("ended "))
        return [line for line in lines if line != end], int(end.removeprefix("ended "))

    def kill(self, process: int) -> None:
        """Kill a process, and wait until it has ended."""
        os.kill(process, signal.SIGKILL)
        assert self.ended(process) == ([], signal.SIGKILL)

    def close(self) -> None:
        """End the first process."""
        with self._first as first:
            first.kill()


@pytest.fixture(scope="module")
def processes(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Processes]:
    found = Processes(tmp_path_factory.mktemp("processes"))
    yield found
    found.close()


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_kill_at_any_moment_leaves_a_whole_file(
    motion: fx.Motion, tmp_path: Path, suffix: str, processes: Processes
) -> None:
    path = motion.save(tmp_path / f"run{suffix}")
    rng = np.random.default_rng(5)
    for _ in range(4):
        process = processes.start("writer", path)
        time.sleep(rng.uniform(0.02, 0.3))
        processes.kill(process)
        assert len(fx.load(path)) in (len(motion), 200)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_full_disk_leaves_the_old_file(
    motion: fx.Motion, tmp_path: Path, suffix: str, processes: Processes
) -> None:
    path = motion.save(tmp_path / f"run{suffix}")
    before = path.read_bytes()
    (said,), status = processes.ended(processes.start("limited", path), said=1)
    assert status == 0 and f"save '{path}'" in said and "the earlier file is unchanged" in said
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


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


def test_of_two_writers_the_last_one_wins(tmp_path: Path, processes: Processes) -> None:
    path = tmp_path / "run.npz"
    pair = [processes.start("writer", path) for _ in range(2)]
    read, latest = 0, time.monotonic() + 60  # a loaded machine may take seconds to start them
    while read < 20 and time.monotonic() < latest:
        if path.exists():
            assert len(fx.load(path)) == 200
            read += 1
        time.sleep(0.01)
    for process in pair:
        processes.kill(process)
    assert read == 20
    assert set(record_files.FORMATS) == set(SUFFIXES)
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] != 2000
