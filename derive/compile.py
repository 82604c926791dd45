"""User-defined elements and laws: derived, compiled once, cached in the user's cache directory by content.

The shared object is independent of Python; it exports ``flexel_user``, which is a ``flexel_element`` or a
``flexel_law`` of ``kernels.h``.
"""

import ctypes
import hashlib
import os
import platform
import shlex
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from flexel.derive.declare import Element, Law
from flexel.derive.emit.emit import FLAGS
from flexel.derive.emit.source import digest_of, element_source, laws_source
from flexel.derive.emit.specification import element_spec, law_spec
from flexel.derive.program.kernels import derive_element, derive_law
from flexel.derive.spec import ElementSpec, LawSpec

GENERATED = Path(__file__).resolve().parents[1] / "generated"
_SYMBOL = "user"


class CompilerMissingError(RuntimeError):
    """There is no C compiler."""


class CompilationError(RuntimeError):
    """The C compiler reported an error in the derived code."""


@dataclass(frozen=True)
class CompiledElement:
    """A compiled element: its spec, and the address of its ``flexel_element``."""

    spec: ElementSpec
    address: int
    path: Path


@dataclass(frozen=True)
class CompiledLaw:
    """A compiled law: its spec, and the address of its ``flexel_law``."""

    spec: LawSpec
    address: int
    path: Path


def compile_element(element: Element) -> CompiledElement:
    """Derive and compile an element; later calls use the cache.

    Raises
    ------
    CompilerMissingError
        No C compiler.
    CompilationError
        The compiler failed.
    """
    derived = derive_element(element)
    source = element_source(element, derived, _SYMBOL)
    path = _shared_object(element.name, source)
    return CompiledElement(element_spec(element, derived, digest_of(source)), _address(path), path)


def compile_law(law: Law) -> CompiledLaw:
    """Derive and compile a law; errors as in `compile_element`."""
    derived = derive_law(law)
    source = laws_source([law], [derived], _SYMBOL)
    path = _shared_object(law.name, source)
    return CompiledLaw(law_spec(law, derived, digest_of(source)), _address(path), path)


def cache_directory() -> Path:
    """Directory of compiled elements and laws (it may not exist yet)."""
    base = os.environ.get("XDG_CACHE_HOME", "")
    return (Path(base) if os.path.isabs(base) else Path.home() / ".cache") / "flexel"


def _compiler() -> list[str]:
    command = shlex.split(os.environ.get("CC", "")) or ["cc"]
    if shutil.which(command[0]) is None:
        raise CompilerMissingError(
            f"no C compiler '{command[0]}': user-defined elements and laws are compiled when they are first used; "
            "install one (`apt install gcc`), or set CC. The elements and laws that come with flexel need none"
        )
    return command


def _flags() -> list[str]:
    """Flags for this machine only: one vector width instead of a choice at run time."""
    own = ["-DFLEXEL_NO_CLONES", "-march=native", "-mprefer-vector-width=512"]
    if platform.machine() not in ("x86_64", "AMD64"):
        own = []
    return ["-std=c11", *FLAGS, *own, "-shared", "-fPIC"]


def _processor() -> str:
    """The machine properties on which ``-march=native`` depends."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor()
    return "\n".join(sorted({line for line in lines if line.startswith(("flags", "Features"))}))


def _shared_object(name: str, source: str) -> Path:
    """Path of the compiled source, created if it is not in the cache."""
    header = (GENERATED / "kernels.h").read_text(encoding="utf-8")
    compiler = os.environ.get("CC", "cc")
    content = "\0".join([source, header, compiler, *_flags(), platform.machine(), _processor()])
    path = cache_directory() / f"{name}-{hashlib.sha256(content.encode()).hexdigest()[:20]}.so"
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=path.parent) as folder:
            made = _compile(name, source, Path(folder))
            made.replace(path)  # atomic: another process may be doing the same
    return path


def _compile(name: str, source: str, folder: Path) -> Path:
    file, made = folder / f"{name}.c", folder / f"{name}.so"
    file.write_text(source, encoding="utf-8")
    command = [*_compiler(), *_flags(), f"-I{GENERATED}", str(file), "-o", str(made), "-lm"]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode:
        raise CompilationError(f"'{name}' does not compile: {shlex.join(command)}\n{answer.stderr}")
    return made


def _address(path: Path) -> int:
    """Address of ``flexel_user``; a loaded library stays loaded."""
    return ctypes.addressof(ctypes.c_char.in_dll(ctypes.CDLL(str(path)), f"flexel_{_SYMBOL}"))
