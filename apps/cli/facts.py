"""Collects facts about this installation for `flexel info`: versions, compiler, cache directory, compiled kernels."""

import platform
import re
import shutil
import subprocess
from importlib import import_module
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path

import flexel


def facts() -> list[tuple[str, str]]:
    """Return (name, fact) pairs, in the order in which they are printed."""
    return [
        ("flexel", f"{_version('flexel')} in {Path(flexel.__file__).parent}"),
        ("python", f"{platform.python_version()} ({platform.machine()}, {platform.system()})"),
        *((name, _version(name)) for name in _packages()),
        ("compiler", _compiler()),
        ("cache", _cache()),
        ("kernels", _kernels()),
    ]


def _packages() -> list[str]:
    """Return the names of the packages that flexel needs or can use, except development tools."""
    lines = [
        line for line in requires("flexel") or () if not re.search(r"extra == .(test|lint|docs|all)\b", line)
    ]
    names = dict.fromkeys(re.split(r"[^\w-]", line, maxsplit=1)[0].lower() for line in lines)
    return [name for name in names if name != "flexel"]  # which its extras name


def _version(name: str) -> str:
    """Return the version of an installed package, or that it is not installed."""
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


def _compiler() -> str:
    """Return the C compiler for user-defined elements."""
    compiler = shutil.which("cc")
    if compiler is None:
        return "no cc: user-defined elements cannot be compiled"
    answer = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=False)
    return f"{compiler}: {answer.stdout.partition(chr(10))[0] or 'unknown version'}"


def _cache() -> str:
    """Return the directory in which compiled user-defined elements are kept."""
    from flexel.derive.cache import cache_directory

    return str(cache_directory())


def _kernels() -> str:
    """Return how many elements and laws are compiled, or why they do not load."""
    try:
        import_module("flexel.generated._kernels")
        table = import_module("flexel.generated.table")
    except ImportError as error:
        return f"not loaded: {error}"
    return f"{len(table.ELEMENTS)} elements, {len(table.LAWS)} laws"
