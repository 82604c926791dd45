"""The C written by hand compiles without any warning."""

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FILES = sorted((ROOT / "runtime" / "engine").glob("*.c"))
STRICT = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fopenmp-simd", "-fsyntax-only"]


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_the_engine_compiles_without_warnings(compiler: str) -> None:
    if not shutil.which(compiler):
        pytest.skip(f"{compiler} is not installed")
    found = subprocess.run(
        [compiler, *STRICT, f"-I{ROOT / 'generated'}", *map(str, FILES)], capture_output=True, text=True
    )
    assert FILES and found.returncode == 0, found.stderr
