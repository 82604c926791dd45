"""What is installed is what is in the checkout: every module, template and C file."""

import os
import runpy
import shutil
import subprocess
import sys
import tarfile
import tomllib
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

import flexel

FOLDERS = {
    "runtime": "flexel",
    "derive": "flexel/derive",
    "generated": "flexel/generated",
    "parts": "flexel/parts",
    "results": "flexel/results",
    "apps": "flexel/apps",
    "examples": "flexel/examples",
}
DATA = {".py", ".typed", ".jinja", ".json", ".c", ".h", ".js", ".css", ".html", ".txt"}


@pytest.fixture(scope="module")
def tree(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of what is packaged, so that building leaves nothing behind in the checkout."""
    copy = tmp_path_factory.mktemp("tree")
    for name in (
        "pyproject.toml",
        "setup.py",
        "MANIFEST.in",
        "README.md",
        "LICENSE",
        "CHANGELOG.md",
        "CITATION.cff",
        "CONTRIBUTING.md",
        "Makefile",
    ):
        shutil.copy(checkout / name, copy)
    for name in (*FOLDERS, "tests", "tools"):
        shutil.copytree(checkout / name, copy / name, ignore=shutil.ignore_patterns("__pycache__", "*.so"))
    shutil.copytree(checkout / ".ci", copy / ".ci")
    return copy


def sources(tree: Path) -> set[str]:
    """Return the files that belong in the package, relative to the tree."""
    files = (path for folder in FOLDERS for path in (tree / folder).rglob("*") if path.suffix in DATA)
    return {path.relative_to(tree).as_posix() for path in files}


def setup(tree: Path, *arguments: str) -> None:
    """Run setup.py in the tree."""
    command = [sys.executable, "setup.py", "--quiet", *arguments]
    environment = {**os.environ, "PYTHONWARNINGS": "ignore"}
    result = subprocess.run(command, cwd=tree, capture_output=True, text=True, env=environment)
    assert result.returncode == 0, result.stderr


def test_the_wheel_holds_every_file(tree: Path, tmp_path: Path) -> None:
    """The Python side of a wheel has every module, template, C file and data file of the five folders."""
    setup(tree, "build_py", "--build-lib", str(tmp_path))
    installed = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file()}
    wanted = set()
    for name in sources(tree):
        folder, _, rest = name.partition("/")
        wanted.add(f"{FOLDERS[folder]}/{rest}")
    assert wanted - installed == set()
    # laid out like this the extension is built from a wheel's files, too
    built = runpy.run_path(str(tmp_path / "flexel" / "generated" / "build.py"))
    assert Path(built["ENGINE"]) == tmp_path / "flexel" / "engine"
    assert {"kernels.h", "elimination.h", "evaluate.h"} <= {Path(header).name for header in built["HEADERS"]}


def test_the_sdist_holds_every_file(tree: Path, tmp_path: Path) -> None:
    """The source distribution can be built and tested: sources, tests, Makefile, .ci/run."""
    setup(tree, "sdist", "--dist-dir", str(tmp_path))
    with tarfile.open(next(tmp_path.glob("*.tar.gz"))) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    wanted = sources(tree) | {
        "setup.py",
        "Makefile",
        ".ci/run",
        "tests/conftest.py",
        "tools/write_report.py",
        "tools/lock.txt",
        "tools/report/page.css",
        "tools/bench/peers/exudyn.py",
        "LICENSE",
        "README.md",
        "CITATION.cff",
    }
    assert wanted - names == set()


def test_the_extension_fits_every_python() -> None:
    """The kernels are compiled against CPython's stable interface."""
    from flexel.generated import _kernels

    assert ".abi3.so" in EXTENSION_SUFFIXES
    assert Path(_kernels.__file__).name == "_kernels.abi3.so"


def test_one_version(checkout: Path) -> None:
    """pyproject.toml, the package, the change log and the citation state the same version."""
    project = tomllib.loads((checkout / "pyproject.toml").read_text())["project"]
    assert project["version"] == flexel.__version__
    assert f"\nversion: {flexel.__version__}\n" in (checkout / "CITATION.cff").read_text()
    assert f"## {flexel.__version__}" in (checkout / "CHANGELOG.md").read_text()


def test_a_missing_prerequisite_is_named(checkout: Path) -> None:
    """Without a Python, make prints the one line that installs it, and stops."""
    command = ["make", "--no-print-directory", "prerequisites", "PYTHON=/nowhere/python3"]
    result = subprocess.run(command, cwd=checkout, capture_output=True, text=True)
    assert result.returncode != 0
    assert "apt-get install python3-dev python3-venv" in result.stderr
