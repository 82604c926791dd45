"""The user's cache of compiled files: a private folder of files with checksums.

Loaded files run in the process, so no other user may write them; a checksum after the content shows that they
are whole.
"""

import atexit
import os
import shutil
import stat
import tempfile
import warnings
from functools import cache
from pathlib import Path

from flexel.derive.checksum_trailer import content_in, trailer_of
from flexel.derive.checksum_trailer import is_whole as unbroken


class CacheError(RuntimeError):
    """The cache cannot be trusted."""


def cache_directory() -> Path:
    """Return the directory of compiled elements and laws (it may not exist yet)."""
    base = os.environ.get("XDG_CACHE_HOME", "")
    return (Path(base) if os.path.isabs(base) else Path.home() / ".cache") / "flexel"


def writable_directory() -> Path:
    """Return the cache, or a folder for this process, with a warning, where the cache cannot be written.

    Raises
    ------
    CacheError
        If others can write to it.
    """
    folder = cache_directory()
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as error:
        return _temporary(folder, error.strerror or str(error))
    check_private(folder)
    if not os.access(folder, os.W_OK | os.X_OK):
        return _temporary(folder, "it is read-only")
    return folder


def folder_in_cache(name: str) -> Path:
    """Return a folder in the cache; where that cannot be trusted or written, one for this process, with a warning."""
    try:
        folder = writable_directory() / name
    except CacheError as error:
        folder = _temporary(cache_directory(), str(error)) / name
    folder.mkdir(mode=0o700, exist_ok=True)
    return folder


def check_private(folder: Path) -> None:
    """Raise a CacheError if anybody else can write to the folder."""
    if not folder.exists():
        return
    found = folder.stat()
    if found.st_uid not in (os.geteuid(), 0):
        raise CacheError(
            f"the cache {folder} belongs to another user, whose files would run here; remove it, or set "
            "XDG_CACHE_HOME to a folder of your own"
        )
    if found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        raise CacheError(
            f"others can write to the cache {folder}, and their files would run here: chmod 700 {folder}, or set "
            "XDG_CACHE_HOME to a folder of your own"
        )


@cache
def _temporary(folder: Path, reason: str) -> Path:
    """Create a folder that is removed when this process ends."""
    warnings.warn(
        f"the cache {folder} cannot be used ({reason}): what is compiled is lost with this process; set XDG_CACHE_HOME "
        "to a writable folder",
        RuntimeWarning,
        stacklevel=2,
    )
    found = Path(tempfile.mkdtemp(prefix="flexel-"))  # mode 0700
    atexit.register(shutil.rmtree, found, ignore_errors=True)
    return found


def append_checksum(file: Path) -> None:
    """Append the checksum trailer to a file."""
    content = file.read_bytes()
    with file.open("ab") as stream:
        stream.write(trailer_of(content))


def is_whole(file: Path) -> bool:
    """Whether a file exists with a valid checksum."""
    return content_of(file) is not None


def content_of(file: Path) -> bytes | None:
    """Return the content of a file without its checksum; None if there is no file, or its checksum is wrong."""
    try:
        data = file.read_bytes()
    except OSError:
        return None
    return content_in(data) if unbroken(data) else None
