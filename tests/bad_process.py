"""Bad calls in processes of their own, each watched: a call that takes too long or ends its process is a defect."""

import json
import os
import select
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import astuple
from pathlib import Path
from typing import Any

LIMIT = 60.0  # longest call [s]; what hangs never ends, and a busy machine takes its time
START = 60.0  # longest start of a process [s]


def verdicts(cases: Sequence[Any], folder: Path) -> dict[str, str]:
    """What is wrong with each case of which something is, by its text."""
    kind = type(cases[0])
    file = folder / "cases.jsonl"
    file.write_text("".join(f"{json.dumps(astuple(case))}\n" for case in cases))
    found: dict[str, str] = {}
    first = 0
    while first < len(cases):
        for i, wrong in _watched([kind.__module__, kind.__name__, str(file), str(first)], folder):
            first = i + 1
            if wrong:
                found[str(cases[i])] = wrong
    return found


def _watched(arguments: list[str], folder: Path) -> Iterator[tuple[int, str]]:
    """Verdicts of one process until it ends; the last one may be that it hung or crashed."""
    environment = os.environ | {"PYTHONPATH": str(Path(__file__).parent), "MPLBACKEND": "Agg"}
    worker = str(Path(__file__).with_name("bad_worker.py"))
    command = [sys.executable, "-X", "faulthandler", worker, *arguments]
    with (folder / "errors.txt").open("ab") as errors:
        process = subprocess.Popen(
            command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=errors
        )
    running = -1
    try:
        for line in _lines(process):
            word, number, *rest = line.split(" ", 2)
            if word == "end":
                yield int(number), json.loads(rest[0])
            running = int(number) if word == "begin" else -1
        if running >= 0:
            yield running, _end(process)
        elif process.wait():
            raise AssertionError((folder / "errors.txt").read_text()[-2000:])
    finally:
        process.kill()
        process.wait()
        assert process.stdout is not None
        process.stdout.close()


def _end(process: subprocess.Popen[bytes]) -> str:
    """Why a process says nothing more."""
    try:
        return f"the process ended with {process.wait(timeout=1)}"
    except subprocess.TimeoutExpired:
        return f"no answer in {LIMIT:g} s"


def _lines(process: subprocess.Popen[bytes]) -> Iterator[str]:
    """Lines that the process writes, until it ends or is silent for too long."""
    assert process.stdout is not None
    rest, wait = b"", START
    while select.select([process.stdout], [], [], wait)[0]:
        read = os.read(process.stdout.fileno(), 65536)
        if not read:
            return
        *whole, rest = (rest + read).split(b"\n")
        wait = LIMIT
        yield from (line.decode() for line in whole)
