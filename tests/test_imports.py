"""Three floors, one contract: which room imports what, and when."""

import ast
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

import flexel

ROOT = Path(__file__).resolve().parent.parent
FLOORS = ("derive", "generated", "runtime", "examples")
FILES = [path for floor in FLOORS for path in sorted((ROOT / floor).rglob("*.py"))]

# The package of derive that may import the compiled kernels, inside functions only.
SEES_GENERATED = ("derive/verify",)
# The one module of derive that everything may import: plain Python.
SPEC = "flexel.derive.spec."
# The rooms of the runtime that may call derive, inside functions only: commands, a user's own elements.
CALLS_DERIVE = (
    "runtime/commands/derive.py",
    "runtime/commands/verify.py",
    "runtime/commands/facts.py",
    "runtime/declare/feedback.py",
    "runtime/declare/formulas.py",
    "runtime/declare/user.py",
)
# What makes an import slow, or is an extra that may be absent: inside functions only.
LAZY = {"sympy", "jinja2", "matplotlib", "xarray", "h5netcdf", "pandas", "control", "sksundae", "joblib"}


@dataclass(frozen=True)
class Import:
    """One imported module, and whether it is imported with the file or only when a function runs."""

    module: str
    lazy: bool


def imports(path: Path) -> Iterator[Import]:
    """Yield every import of a file, those for type checkers apart."""
    yield from _walk(ast.parse(path.read_text()), lazy=False)


def _walk(node: ast.AST, lazy: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            yield from (Import(alias.name, lazy) for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            assert child.level == 0, f"relative import in line {child.lineno}"
            yield from (Import(f"{child.module}.{alias.name}", lazy) for alias in child.names)
        elif isinstance(child, ast.Call) and ast.unparse(child.func).endswith("import_module"):
            yield from (Import(a.value, lazy) for a in child.args[:1] if isinstance(a, ast.Constant))
        elif not (isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test)):
            yield from _walk(child, lazy or isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef))


def room(path: Path) -> str:
    """Return the path inside the checkout."""
    return path.relative_to(ROOT).as_posix()


def floor(module: str) -> str | None:
    """Return the floor that a module of flexel belongs to, None for anything else."""
    head, _, rest = module.partition(".")
    if head != "flexel":
        return None
    first = rest.partition(".")[0]
    return first if first in FLOORS else "runtime"


def on_floor(name: str) -> list[Path]:
    """Return the files of one floor."""
    return [path for path in FILES if room(path).startswith(name + "/")]


@pytest.mark.parametrize("path", on_floor("derive"), ids=room)
def test_derive_sees_no_other_floor(path: Path) -> None:
    """Deriving needs neither the runtime nor (but for two rooms) what was generated."""
    allowed = {None, "derive"} | ({"generated"} if room(path).startswith(SEES_GENERATED) else set())
    assert [entry.module for entry in imports(path) if floor(entry.module) not in allowed] == []


@pytest.mark.parametrize("path", on_floor("derive"), ids=room)
def test_derive_starts_without_compiled_kernels(path: Path) -> None:
    """No room of derive imports the extension itself while it is being imported."""
    assert [e.module for e in imports(path) if "_kernels" in e.module and not e.lazy] == []


@pytest.mark.parametrize("path", on_floor("generated"), ids=room)
def test_generated_sees_only_itself(path: Path) -> None:
    """The builder imports nothing of flexel; the table imports its specification."""
    found = [entry.module for entry in imports(path) if floor(entry.module) is not None]
    assert [z for z in found if path.name == "build.py" or not z.startswith(SPEC)] == []


@pytest.mark.parametrize("path", on_floor("runtime") + on_floor("examples"), ids=room)
def test_runtime_derives_only_lazily_and_only_in_named_rooms(path: Path) -> None:
    """A model runs without SymPy; commands and a user's own element call it when they need it."""
    symbolic = [
        e
        for e in imports(path)
        if (floor(e.module) == "derive" and not e.module.startswith(SPEC))
        or e.module.startswith(("sympy", "jinja2"))
    ]
    if room(path) in CALLS_DERIVE:
        symbolic = [entry for entry in symbolic if not entry.lazy]
    assert [entry.module for entry in symbolic] == []


@pytest.mark.parametrize("path", on_floor("runtime") + on_floor("examples"), ids=room)
def test_slow_and_optional_packages_are_imported_when_used(path: Path) -> None:
    """Matplotlib and the other extras are imported inside functions."""
    assert [e.module for e in imports(path) if not e.lazy and e.module.partition(".")[0] in LAZY] == []


@pytest.mark.parametrize("path", on_floor("runtime"), ids=room)
def test_runtime_does_not_know_the_examples(path: Path) -> None:
    """The published systems use flexel, not the other way round (the command line finds them by name)."""
    assert [entry.module for entry in imports(path) if floor(entry.module) == "examples"] == []


def test_the_specification_brings_no_sympy() -> None:
    """The runtime reads the table of elements without what derived it."""
    code = "import sys, flexel.generated.table; assert not {'sympy', 'jinja2', 'numpy'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_import_flexel_is_light() -> None:
    """`import flexel` loads no numerical or symbolic package and takes less than 0.3 s."""
    code = (
        "import sys, time; start = time.perf_counter(); import flexel; seconds = time.perf_counter() - start;"
        "heavy = {'sympy', 'jinja2', 'numpy', 'scipy', 'matplotlib', 'cffi', 'click'} & set(sys.modules);"
        "assert not heavy, heavy; print(seconds)"
    )
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True) for _ in range(3)]
    assert [run.stderr for run in runs if run.returncode] == []
    assert min(float(run.stdout) for run in runs) < 0.3


@pytest.mark.parametrize("name", flexel.__all__)
def test_every_public_name_is_there(name: str) -> None:
    """Each name of the table is found in its module, and `dir` shows it."""
    assert getattr(flexel, name).__module__ == flexel._HOMES[name]
    assert name in dir(flexel)


def test_type_checkers_see_the_same_names() -> None:
    """The imports for type checkers, the table and `__all__` agree."""
    tree = ast.parse((ROOT / "runtime" / "__init__.py").read_text())
    block = next(n for n in tree.body if isinstance(n, ast.If) and "TYPE_CHECKING" in ast.unparse(n.test))
    typed = {a.name: n.module for n in block.body if isinstance(n, ast.ImportFrom) for a in n.names}
    assert typed == flexel._HOMES
    assert sorted(typed) == sorted(flexel.__all__)


def test_unknown_public_name_lists_the_known_ones() -> None:
    """A misspelt name is answered with the names that exist."""
    with pytest.raises(AttributeError, match="Moddel.*Model"):
        flexel.Moddel  # noqa: B018
