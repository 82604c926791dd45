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
    "structure",
    "declare",
    "rope",
    "engine",
    "mechanics",
    "integration",
    "statics",
    "linear",
    "results",
    "pictures",
    "analyses",
    "system",
    "build",
    "model",
    "spacar",
    "flexures",
    "sweeps",
    "report",
    "commands",
    "__main__",
)
# Methods of results that import from higher layers when they are called: plot, view, save, to_control, stress.
EXCEPTIONS = {
    ("flexel.mechanics.drawn", "flexel.pictures.bode"),  # bode
    ("flexel.mechanics.drawn", "flexel.pictures.deflected"),  # plot_mode
    ("flexel.mechanics.drawn", "flexel.pictures.graphs"),  # plot
    ("flexel.mechanics.drawn", "flexel.pictures.options"),  # plot_mode
    ("flexel.mechanics.drawn", "flexel.pictures.view"),  # view
    ("flexel.mechanics.drawn", "flexel.results.response"),  # frequency_response, bode
    ("flexel.mechanics.linearization", "flexel.linear.sensors"),  # state_space
    ("flexel.mechanics.linearization", "flexel.results.control"),  # to_control, to_scipy, save_state_space
    ("flexel.mechanics.linearization", "flexel.results.saved.archive_linear"),  # save, to_xarray, to_pandas
    ("flexel.mechanics.sampled", "flexel.linear.sampled"),  # sampled
    ("flexel.results.branch", "flexel.pictures.graphs"),  # plot
    ("flexel.results.drawn", "flexel.pictures.animation"),  # animate
    ("flexel.results.drawn", "flexel.pictures.deflected"),  # plot_shapes
    ("flexel.results.drawn", "flexel.pictures.graphs"),  # spectrum_plot, plot_phase
    ("flexel.results.drawn", "flexel.pictures.histories"),  # plot
    ("flexel.results.drawn", "flexel.pictures.options"),  # plot_shapes, animate, page
    ("flexel.results.drawn", "flexel.pictures.view"),  # view
    ("flexel.results.flexure", "flexel.pictures.flexure_graphs"),  # plot
    ("flexel.results.flexure_step", "flexel.pictures.deflected"),  # plot_mode
    ("flexel.results.flexure_step", "flexel.pictures.options"),  # plot_mode
    ("flexel.results.flexure_step", "flexel.pictures.view"),  # view_modes
    ("flexel.results.linearizations", "flexel.pictures.figures"),  # plot
    ("flexel.results.linearizations", "flexel.pictures.loci"),  # plot
    ("flexel.results.linearizations", "flexel.pictures.options"),  # plot
    ("flexel.results.motion", "flexel.results.saved.archive"),  # save
    ("flexel.results.motion", "flexel.results.saved.tables"),  # to_xarray, to_pandas
    ("flexel.results.periodic", "flexel.pictures.graphs"),  # spectrum_plot
    ("flexel.structure.state", "flexel.declare.sections"),  # section_forces: the class that it returns
    ("flexel.structure.state", "flexel.mechanics.constraints"),  # constraint_report
    ("flexel.structure.state", "flexel.mechanics.stress"),  # section_forces, stress, largest_stress
}
LONGEST = 600  # lines of a file
KINDS = {".py", ".c", ".h", ".js", ".jinja"}
BY_HAND = (
    "derive",
    "runtime",
    "examples",
    "tests",
    "benchmarks",
    "docs",
)  # generated/ is printed by `flexel derive`
FOREIGN = {"three.module.min.js"}
WRITTEN = {"_build", "_generated"}  # folders of docs/ that `make docs` writes
MOST = 8  # modules in the root


def module_of(path: Path) -> str:
    """The dotted name of a file of the runtime."""
    parts = ("flexel", *path.relative_to(RUNTIME).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def graph() -> dict[str, set[str]]:
    """Every module of the runtime with those that it imports, for type checkers and inside functions too."""
    files = {module_of(path): path for path in RUNTIME.rglob("*.py")}
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
    return LAYERS.index(module.split(".")[1])


def arrows() -> Iterator[tuple[str, str]]:
    """All imports between modules of layers."""
    for module, imported in graph().items():
        if module != "flexel":
            yield from ((module, other) for other in imported if other != "flexel")


def test_every_import_goes_to_the_same_layer_or_a_lower_one() -> None:
    wrong = {(a, b) for a, b in arrows() if layer(b) > layer(a)} - EXCEPTIONS
    assert sorted(wrong) == []


def test_every_exception_is_needed_and_lazy() -> None:
    assert sorted(EXCEPTIONS - set(arrows())) == []
    for module in {a for a, _ in EXCEPTIONS}:
        path = RUNTIME.joinpath(*module.split(".")[1:]).with_suffix(".py")
        at_once = {
            node.module
            for node in ast.parse(path.read_text(encoding="utf-8")).body
            if isinstance(node, ast.ImportFrom)
        }
        assert not at_once & {b for a, b in EXCEPTIONS if a == module}


def test_no_module_imports_itself_by_way_of_others() -> None:
    below: dict[str, set[str]] = {module: set() for module in graph() if module != "flexel"}
    for a, b in arrows():
        if (a, b) not in EXCEPTIONS:
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
