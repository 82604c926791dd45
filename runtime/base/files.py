"""Writes files completely or not at all: next to their destination, flushed to the disk, then renamed."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from flexel.base.errors import FlexelError


@contextmanager
def replacing(path: str | Path, owner: str = "save", *, trial: bool = False) -> Iterator[Path]:
    """Open a new file that replaces `path` at the end of the block; if the block fails, the old file is unchanged.

    If several writers run at once, the last complete file wins.  A pipe, or another special file, is written directly.

    Parameters
    ----------
    path : str or Path
    owner : str
        The operation, for messages.
    trial : bool
        Whether the new file is only written, and then removed: to learn whether it can be.

    Raises
    ------
    FlexelError
        If it cannot be written: a full disk, a folder that does not exist or is protected.
    """
    target = Path(path).resolve()  # a link remains a link
    with written(f"{owner} '{path}'", "; the earlier file is unchanged"):
        if target.exists() and not target.is_file():
            yield Path(os.devnull) if trial else target
            return
        number, name = tempfile.mkstemp(prefix=f".{target.stem}.", suffix=target.suffix, dir=target.parent)
        os.close(number)
        part = Path(name)
        try:
            yield part
            part.chmod(_mode(target))
            _flush(part)
            if not trial:
                part.replace(target)
                _flush(target.parent)
        finally:
            part.unlink(missing_ok=True)


@contextmanager
def written(owner: str, kept: str = "") -> Iterator[None]:
    """Turn operating-system errors in a block that writes files into flexel's errors.

    Parameters
    ----------
    owner : str
        The operation and its file, for messages.
    kept : str
        What has not been lost.

    Raises
    ------
    FlexelError
        For a full disk, a folder that does not exist or is protected.
    """
    try:
        yield
    except OSError as error:
        raise FlexelError(
            f"{owner}: {error.strerror or error}{kept}. Free space, or give the path of a folder that you may write to"
        ) from error


def _mode(target: Path) -> int:
    """Return the permissions of the file to be replaced, or those of a new one."""
    if target.exists():
        return target.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


def _flush(path: Path) -> None:
    """Wait until a file, or the entries of a folder, is on the disk."""
    number = os.open(path, os.O_RDONLY)
    try:
        os.fsync(number)
    finally:
        os.close(number)
