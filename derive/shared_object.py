"""Shared objects of users' elements and laws: compiled once, cached in the user's cache directory by content.

Plain Python: what has been derived once is loaded, or compiled for another machine, without SymPy.  The shared object
is independent of Python; it exports ``flexel_user``, which is a ``flexel_element`` or a ``flexel_law`` of
``kernels.h``.
"""

import ctypes
import hashlib
import logging
import os
import shlex
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from flexel.derive.cache import append_checksum, cache_directory, check_private, is_whole, writable_directory
from flexel.derive.processor import native_flags, processor

log = logging.getLogger("flexel.compile")
# -O2 gives the same speed as -O3 (the loops are marked for vectorization) in three quarters of the time.
# Never -ffast-math: on the link line it changes denormals for the whole process.
# The largest kernels get the allocator of registers that needs no table of conflicts: a fifth less time to compile, and
# kernels as fast.
FLAGS = (
    "-O2",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-fopenmp-simd",
    "-ffp-contract=off",
    "--param=ira-max-conflict-table-size=1",
)
GENERATED = Path(__file__).resolve().parents[1] / "generated"
SYMBOL = "user"


class CompilerMissingError(RuntimeError):
    """There is no C compiler."""


class CompilationError(RuntimeError):
    """The C compiler reported an error in the derived code."""


@dataclass(frozen=True)
class SharedObject:
    """The derived C code of an element or a law, and its kernels.

    It is pickled as its source: the other side loads it from its own cache, or compiles it there once.
    """

    name: str
    source: str = field(repr=False)

    @cached_property
    def path(self) -> Path:
        """The compiled source, made if it is not in the cache."""
        return _compiled(self.name, self.source)

    @cached_property
    def address(self) -> int:
        """Address of ``flexel_user``; a loaded library stays loaded.

        Raises
        ------
        CompilerMissingError
            No C compiler.
        CompilationError
            The compiler failed, or its output cannot be loaded.
        CacheError
            Others can write to the cache.
        """
        try:
            return ctypes.addressof(ctypes.c_char.in_dll(ctypes.CDLL(str(self.path)), f"flexel_{SYMBOL}"))
        except (OSError, ValueError) as error:
            raise CompilationError(
                f"'{self.name}': the compiled file cannot be loaded ({error}); set CC to a C compiler "
                "for this machine"
            ) from error

    def __getstate__(self) -> dict[str, str]:
        """Return the source alone: path and address are those of this process."""
        return {"name": self.name, "source": self.source}

    def __deepcopy__(self, _: object) -> "SharedObject":
        """Return the same object, which never changes."""
        return self


def _compiler() -> list[str]:
    command = shlex.split(os.environ.get("CC", "")) or ["cc"]
    if shutil.which(command[0]) is None:
        raise CompilerMissingError(
            f"no C compiler '{command[0]}': user-defined elements and laws are compiled when they are first used; "
            "install one (`apt install gcc`), or set CC. The elements and laws that come with flexel need none"
        )
    return command


def _flags() -> list[str]:
    return ["-std=c11", *FLAGS, *native_flags(), "-shared", "-fPIC"]


def _compiled(name: str, source: str) -> Path:
    """Return the path of the compiled source, which is created if it is not in the cache, or not whole."""
    header = (GENERATED / "kernels.h").read_text(encoding="utf-8")
    compiler = os.environ.get("CC", "cc")
    content = "\0".join([source, header, compiler, *_flags(), processor()])
    file = f"{name}-{hashlib.sha256(content.encode()).hexdigest()[:20]}.so"
    check_private(cache_directory())
    path = cache_directory() / file
    if is_whole(path):
        log.info("'%s' is in the cache: %s", name, path)
        return path
    path = writable_directory() / file
    if not is_whole(path):
        begin = time.perf_counter()
        with tempfile.TemporaryDirectory(dir=path.parent) as folder:
            made = _compile(name, source, Path(folder))
            append_checksum(made)
            made.replace(path)  # atomic: another process may be doing the same
        log.info("'%s' compiled in %.2f s: %s", name, time.perf_counter() - begin, path)
    return path


def _compile(name: str, source: str, folder: Path) -> Path:
    file, made = folder / f"{name}.c", folder / f"{name}.so"
    file.write_text(source, encoding="utf-8")
    command = [*_compiler(), *_flags(), f"-I{GENERATED}", str(file), "-o", str(made), "-lm"]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode:
        raise CompilationError(f"'{name}' does not compile: {shlex.join(command)}\n{answer.stderr}")
    if not made.is_file() or not made.stat().st_size:
        raise CompilationError(
            f"'{name}': the compiler reported success, but made no file: {shlex.join(command)}\n{answer.stderr}set CC "
            "to a C compiler that works"
        )
    return made
