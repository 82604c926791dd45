"""The layers of the runtime: a module imports from its own layer or from lower ones, nothing goes in circles.

And no file that is written by hand has more than 600 lines.
"""

import ast
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RUNTIME = ROOT / "runtime"

# From the bottom up.  Modules in the root are separate layers; `flexel` itself only names what is public.
LAYERS = (
    "base",
    "model",
    "engine",
    "mechanics",
    "system",
    "integration",
    "statics",
    "linear",
    "compile",
    "parts",
    "apps.view",
    "results",
    "façade",  # of the parts
    "apps.spacar",
    "apps.flexures",
    "apps.sweeps",
    "apps.cli",
    "__main__",
)
CORE = LAYERS[: LAYERS.index("compile") + 1]  # everything in runtime/ but these two
ABOVE_CORE = {"flexel", "flexel.__main__"}  # the table of lazy names, and what starts the command line
FACADE = ("flexel.parts.model", "flexel.parts.opening")
FOLDERS = {"flexel": "runtime", "flexel.parts": "parts", "flexel.results": "results", "flexel.apps": "apps"}
LONGEST = 600  # lines of a file
KINDS = {".py", ".c", ".h", ".js", ".jinja"}
BY_HAND = (
    "derive",
    "runtime",
    "parts",
    "results",
    "apps",
    "examples",
    "tests",
    "docs",
    "tools",
)  # generated/ is printed by `flexel derive`
FOREIGN = {"three.module.min.js"}
WRITTEN = {"_build", "_generated"}  # folders of docs/ that `make docs` writes
MOST = 8  # modules in the root


def module_of(path: Path) -> str:
    """The dotted name of a file of the runtime."""
    package, *names = path.relative_to(ROOT).with_suffix("").parts
    parts = (next(name for name, folder in FOLDERS.items() if folder == package), *names)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def file_of(module: str) -> Path:
    """The file of a module, which is not a package."""
    package = max((name for name in FOLDERS if module.startswith(f"{name}.")), key=len)
    rest = module.removeprefix(f"{package}.").split(".")
    return ROOT.joinpath(FOLDERS[package], *rest).with_suffix(".py")


@cache
def graph() -> dict[str, set[str]]:
    """Every module of the runtime with those that it imports, for type checkers and inside functions too."""
    files = {module_of(path): path for folder in FOLDERS.values() for path in (ROOT / folder).rglob("*.py")}
    return {name: set(_imported(path, files)) - {name} for name, path in files.items()}


def _imported(path: Path, known: dict[str, Path]) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in known)
        elif isinstance(node, ast.ImportFrom) and node.module in known:
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                yield inner if inner in known else node.module


def layer(module: str) -> int:
    """The number of the layer that a module is in, from the bottom up."""
    if module in FACADE:
        return LAYERS.index("façade")
    first, *rest = module.split(".")[1:]
    return LAYERS.index(f"{first}.{rest[0]}" if first == "apps" else first)


def arrows() -> Iterator[tuple[str, str]]:
    """All imports between modules of layers."""
    for module, imported in graph().items():
        if module != "flexel":
            yield from ((module, other) for other in imported if other != "flexel")


def test_every_import_goes_to_the_same_layer_or_a_lower_one() -> None:
    wrong = {(a, b) for a, b in arrows() if layer(b) > layer(a)}
    assert sorted(wrong) == []


def test_the_runtime_is_the_core() -> None:
    """A module of runtime/ is in a layer of the core, and imports nothing that is not."""
    runtime = {module_of(path) for path in RUNTIME.rglob("*.py")} - ABOVE_CORE
    others = {module for module in runtime if LAYERS[layer(module)] not in CORE}
    reached = {b for module in runtime for b in graph()[module]} - {"flexel"}
    assert others == set() and {b for b in reached if LAYERS[layer(b)] not in CORE} == set()


def test_no_module_imports_itself_by_way_of_others() -> None:
    below: dict[str, set[str]] = {module: set() for module in graph() if module != "flexel"}
    for a, b in arrows():
        below[a].add(b)
    try:
        list(TopologicalSorter(below).static_order())
    except CycleError as error:
        raise AssertionError(" <- ".join(error.args[1])) from None


def test_the_root_is_small() -> None:
    assert len(list(RUNTIME.glob("*.py"))) <= MOST


def test_no_file_written_by_hand_is_longer_than_600_lines() -> None:
    lengths = {
        path.relative_to(ROOT).as_posix(): len(path.read_text(encoding="utf-8").splitlines())
        for folder in BY_HAND
        for path in (ROOT / folder).rglob("*")
        if path.suffix in KINDS and path.name not in FOREIGN and WRITTEN.isdisjoint(path.parts)
    }
    assert len(lengths) > 400
    assert {name: n for name, n in lengths.items() if n > LONGEST} == {}
