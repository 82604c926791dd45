"""Object files kept by content: what a compiler made of a text is found again by the text, the flags and the compiler.

`setup.py` compiles with it, in every environment and copy of the checkout. The text is the source after the
preprocessor, so that a changed header counts where it is included, and a changed comment does not.
"""

import contextlib
import hashlib
import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from flexel.derive.cache import append_checksum, content_of, folder_in_cache
from flexel.derive.processor import processor

MAX_CACHE_BYTES = 256 * 2**20  # twenty builds or more
SCRATCH_AGE_S = 86400.0  # what an interrupted build has left behind
LINE_MARKER = re.compile(rb'# \d+ "')
# These flags read or write files that the key does not cover.
SIDE_FILES = ("-fprofile", "--coverage", "-ftest-coverage", "-fplugin", "-specs", "-save-temps", "@")


def compile_object(command: Sequence[str], source: Path, made: Path) -> bool:
    """Compile a source to an object file, or copy what the cache holds.

    Parameters
    ----------
    command : sequence of str
        The compiler with all flags but ``-c``, ``-o`` and the source.
    source, made : Path
        The C file, the object file.

    Returns
    -------
    bool
        Whether the compiler was called.

    Raises
    ------
    CalledProcessError
        The compiler failed; it has said why on standard error.
    """
    if any(flag.startswith(SIDE_FILES) for flag in command):
        subprocess.run([*command, "-c", str(source), "-o", str(made)], check=True)
        return True
    folder = folder_in_cache("objects")
    # what the preprocessor takes shows in the text
    flags = [flag for flag in command if not (flag.startswith(("-D", "-U", "-I")) and len(flag) > 2)]
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        text, fresh = Path(scratch) / f"{source.stem}.i", Path(scratch) / f"{source.stem}.o"
        subprocess.run([*command, "-E", str(source), "-o", str(text)], check=True)
        kept = folder / f"{source.stem}-{_key(flags, text.read_bytes())}.o"
        content = content_of(kept)
        compiled = content is None
        if content is None:
            # the text that was hashed, not the source, which may have changed since
            subprocess.run([*flags, "-x", "cpp-output", "-c", str(text), "-o", str(fresh)], check=True)
            content = fresh.read_bytes()
            append_checksum(fresh)
            fresh.replace(kept)  # atomic: another process may be doing the same
        with contextlib.suppress(FileNotFoundError):  # another process may have removed it
            os.utime(kept)  # the date of the last use
    made.write_bytes(content)
    return compiled


def remove_oldest(limit: int = MAX_CACHE_BYTES) -> None:
    """Remove the objects that were not used for longest, until the others take at most ``limit`` bytes."""
    found = [(path, path.stat()) for path in _present(folder_in_cache("objects"))]
    files = sorted(
        ((path, facts) for path, facts in found if path.is_file()), key=lambda entry: -entry[1].st_mtime_ns
    )
    taken = 0
    for path, facts in files:
        taken += facts.st_size
        if taken > limit:
            path.unlink(missing_ok=True)
    for path, facts in found:
        if path.is_dir() and time.time() - facts.st_mtime > SCRATCH_AGE_S:
            shutil.rmtree(path, ignore_errors=True)


def _present(folder: Path) -> list[Path]:
    return [path for path in folder.iterdir() if path.exists()]


def _key(flags: Sequence[str], text: bytes) -> str:
    lines = text.splitlines()
    if _keeps_places(flags):
        facts = [os.getcwd()]
    else:
        facts, lines = [], [line for line in lines if line.strip() and not LINE_MARKER.match(line)]
    facts += [*flags, _compiler(flags), processor()]
    return hashlib.sha256(b"\0".join([*(fact.encode() for fact in facts), *lines])).hexdigest()[:32]


def _keeps_places(flags: Sequence[str]) -> bool:
    """Whether the object names the lines of its sources."""
    debugging = [flag for flag in flags if flag.startswith("-g")]
    return debugging[-1:] not in ([], ["-g0"]) or any(flag.startswith("-fsanitize") for flag in flags)


def _compiler(flags: Sequence[str]) -> str:
    """Identify this compiler and its version."""
    first = next((i for i, word in enumerate(flags) if word.startswith("-")), len(flags))
    return _identity(tuple(flags[:first]))


@cache
def _identity(words: tuple[str, ...]) -> str:
    file = os.path.realpath(shutil.which(words[-1]) or words[-1])
    facts = os.stat(file)
    said = subprocess.run([*words, "--version"], capture_output=True, text=True, check=True)
    return f"{file} {facts.st_size} {facts.st_mtime_ns}\n{said.stdout}"
