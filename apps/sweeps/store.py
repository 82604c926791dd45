"""The folder of a sweep: results are written to it as they arrive, and a later sweep continues it.

=================  ==============================================================================
``sweep.json``     the points, and the form of the results once it is known
``points/N.npy``   the values of parameter number N
``status.npy``     of each point: 0 not computed, 1 computed, 2 failed
``values/N.npy``   result number N of all points; NaN where there is none
``failed.jsonl``   messages of the points that failed
``lock``           held by the process that is writing
=================  ==============================================================================

A point counts as computed when its status says so; the status is written after the values have reached the disk:
a process that is killed, or loses its power, loses at most the last second.
"""

from __future__ import annotations

import fcntl
import json
import os
import time
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from flexel.apps.sweeps.columns import ColumnFile
from flexel.apps.sweeps.forms import Form, Forms, misfit
from flexel.apps.sweeps.points import Points
from flexel.apps.sweeps.work import Outcome
from flexel.base.errors import ModelError
from flexel.base.files import replacing, written

VERSION = 1
OPEN, DONE, FAILED = 0, 1, 2
STATUS_INTERVAL_S = 1.0  # time between two updates of the status [s]


class Store:
    """A folder open for writing; use it in ``with``.

    Attributes
    ----------
    status : ndarray of uint8
        Status of each point, including results that are not yet on disk.
    forms : Forms or None
        Of the results; None before the first one.
    """

    def __init__(self, folder: Path, points: Points) -> None:
        self.folder, self.points = folder, points
        self.forms: Forms | None = None
        self._files: dict[str, ColumnFile] = {}
        self._written = time.monotonic()
        self._lock = self._locked()
        try:
            with self._writing():
                self._begin()
        except BaseException:
            self._lock.close()
            raise

    def __enter__(self) -> Store:
        return self

    def __exit__(self, *_: object) -> None:
        with self._writing(), ExitStack() as opened:  # all are closed, even after a failure
            opened.callback(self._lock.close)
            opened.callback(self._messages.close)
            for file in self._files.values():
                opened.callback(file.close)
            self.write()

    def _writing(self) -> AbstractContextManager[None]:
        """Report errors of the disk in a block that writes to the folder."""
        kept = "; its contents are kept: with a folder, the same call continues from there"
        return written(f"sweep: cannot write to {self.folder}", kept)

    def _locked(self) -> IO[str]:
        """Take the lock, which the system releases however this process ends."""
        with self._writing():
            self.folder.mkdir(parents=True, exist_ok=True)
        strangers = (
            [path.name for path in self.folder.iterdir()] if not (self.folder / "sweep.json").exists() else []
        )
        if set(strangers) - {"lock", "points", "values", "status.npy", "failed.jsonl", "sweep.json.new"}:
            raise ModelError(f"sweep: the folder {self.folder} holds other files; give an empty or a new one")
        lock = open(self.folder / "lock", "w", encoding="utf-8")
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            lock.close()
            raise ModelError(
                f"sweep: another process is writing to {self.folder}; wait, or give another folder"
            ) from None
        return lock

    def _begin(self) -> None:
        """Continue the sweep in the folder, or describe the points in it."""
        kept = described(self.folder)
        if kept is None:
            (self.folder / "points").mkdir(exist_ok=True)
            for i, column in enumerate(self.points.values.values()):
                np.save(self.folder / "points" / f"{i}.npy", column)
            self.status: NDArray[np.uint8] = np.zeros(len(self.points), np.uint8)
            np.save(self.folder / "status.npy", self.status)
            (self.folder / "failed.jsonl").write_text("", encoding="utf-8")
            self._describe()
        else:
            difference = self.points.difference(kept["points"])
            if difference is not None:
                raise ModelError(
                    f"sweep: the folder {self.folder} holds another sweep: {difference}; "
                    "give another folder, or delete it"
                )
            self.status = np.load(self.folder / "status.npy")
            self.forms = forms_of(kept)
            for i, (name, _) in enumerate(self.forms or ()):
                self._files[name] = ColumnFile.opened(self._place(i))
            _mend(self.folder / "failed.jsonl")
        self._messages = open(self.folder / "failed.jsonl", "a", encoding="utf-8")

    def _describe(self) -> None:
        """Write ``sweep.json`` as a whole."""
        results = None if self.forms is None else [[name, form.as_json()] for name, form in self.forms]
        text = json.dumps({"version": VERSION, "points": self.points.described(), "results": results})
        with replacing(self.folder / "sweep.json", "sweep") as part:
            part.write_text(text, encoding="utf-8")

    def _place(self, number: int) -> Path:
        return self.folder / "values" / f"{number}.npy"

    @property
    def row_bytes(self) -> int:
        """The size of the results of one point."""
        return sum(file.row_bytes for file in self._files.values())

    def missing(self, retry_failed: bool) -> Iterator[tuple[int, int]]:
        """Return the first and last (excluded) number of each run of points to be computed."""
        wanted = (self.status == OPEN) | ((self.status == FAILED) & retry_failed)
        edges = np.flatnonzero(np.diff(wanted.astype(np.int8), prepend=0, append=0))
        yield from ((int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True))

    def keep(self, outcome: Outcome) -> None:
        """Write the results of a chunk of points; results of a different form become messages."""
        with self._writing():
            self._keep(outcome)

    def _keep(self, outcome: Outcome) -> None:
        failed = dict(outcome.failed)
        if self.forms is None and outcome.blocks:
            self._settle(outcome.blocks[0].forms)
        fitting = []
        for block in outcome.blocks:
            problem = misfit(block.forms, self.forms or ())
            if problem is None:
                fitting.append(block)
            else:
                failed |= dict.fromkeys(block.rows, problem)
        for name, file in self._files.items():
            file.write(outcome.begin, outcome.count, [(block.rows, block.values[name]) for block in fitting])
        for row, message in sorted(failed.items()):
            self._messages.write(json.dumps([outcome.begin + row, message], ensure_ascii=False) + "\n")
        done = np.full(outcome.count, DONE, np.uint8)
        done[list(failed)] = FAILED
        self.status[outcome.begin : outcome.begin + outcome.count] = done
        if time.monotonic() - self._written > STATUS_INTERVAL_S:
            self.write()

    def _settle(self, forms: Forms) -> None:
        """Create the files of results once their form is known."""
        (self.folder / "values").mkdir(exist_ok=True)
        for i, (name, form) in enumerate(forms):
            self._files[name] = ColumnFile.made(self._place(i), len(self.points), form.shape)
        self.forms = forms
        self._describe()

    def write(self) -> None:
        """Write everything to disk: values and messages first, then the status."""
        with self._writing():
            for file in self._files.values():
                file.sync()
            self._messages.flush()
            os.fsync(self._messages.fileno())
        with replacing(self.folder / "status.npy", "sweep") as part:
            np.save(part, self.status)
        self._written = time.monotonic()


def described(folder: Path) -> dict[str, Any] | None:
    """Read ``sweep.json``; return None if there is none."""
    file = folder / "sweep.json"
    if not file.is_file():
        return None
    try:
        kept: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
        known = kept.get("version") == VERSION
    except (ValueError, AttributeError):  # not JSON, or not an object
        known = False
    if not known:
        raise ModelError(f"sweep: {file} cannot be read by this version of flexel; give another folder")
    return kept


def forms_of(kept: dict[str, Any]) -> Forms | None:
    """Return the forms of results in a description.

    Raises
    ------
    ModelError
        If the description is damaged.
    """
    try:
        if kept["results"] is None:
            return None
        return tuple((name, Form.from_json(form)) for name, form in kept["results"])
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise ModelError(
            f"sweep: sweep.json no longer describes its results ({error!r:.100}); the file is damaged: use a "
            "backup of it, or sweep again in another folder"
        ) from error


def messages_in(folder: Path) -> dict[int, str]:
    """Return messages by point; the last message of each counts."""
    messages: dict[int, str] = {}
    same: dict[str, str] = {}  # equal texts are stored once
    with open(folder / "failed.jsonl", encoding="utf-8") as stream:
        for line in stream:
            if line.endswith("\n"):  # otherwise it was cut off, and the point does not count as failed
                point, message = json.loads(line)
                messages[point] = same.setdefault(message, message)
    return messages


def _mend(file: Path) -> None:
    """Remove a line that was cut off when a process was killed."""
    data = file.read_bytes()
    whole = data.rfind(b"\n") + 1
    if whole < len(data):
        os.truncate(file, whole)
