"""Three parts, one contract: which part imports what, and when.  Each test lists every violation."""

import ast
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest

import flexel

ROOT = Path(__file__).resolve().parent.parent
PARTS = ("derive", "generated", "runtime", "parts", "results", "apps", "examples")
BENCH = "tools/bench"  # not installed; starts as quickly, and without its peers

# The package of derive that may import the generated kernels.
SEES_GENERATED = ("derive/verify",)
# The one module of derive that everything may import: plain Python.
SPEC = "flexel.derive.spec."
# Modules of `derive` without SymPy.
PLAIN = (
    SPEC,
    "flexel.derive.definition_errors.",
    "flexel.derive.processor.",
    "flexel.derive.checksum_trailer.",
    "flexel.derive.compiled.",
    "flexel.derive.users_file.",
)
# The modules of the runtime that may call derive, inside functions only: commands, user-defined elements.
CALLS_DERIVE = (
    "apps/cli/derive.py",
    "apps/cli/show.py",
    "apps/cli/verify.py",
    "apps/cli/facts.py",
    "parts/controller_laws.py",
    "parts/formulas.py",
    "parts/elements.py",
)
# What makes an import slow, or is an extra that may be absent: inside functions only.
PEERS = {"bicycleparameters", "exudyn", "mujoco", "pinocchio", "sksundae", "symbrim"}  # of the bench
LAZY = {"sympy", "jinja2", "matplotlib", "xarray", "h5netcdf", "pandas", "control"}
LAZY |= {"joblib", "cloudpickle", "dask", "distributed"} | PEERS
# Programs as users write them: nothing imports them.
PROGRAMS = "examples/gallery/"
# Pages as users write them: their SymPy is at the top, and what compiles them imports them inside functions.
PAGES = ("examples/hoist_paper_element.py",)
# The peer that derives by SymPy, and prints what it derived as C.
DERIVES = (f"{BENCH}/peers/symbrim.py", f"{BENCH}/peers/printed.py")


@dataclass(frozen=True)
class Import:
    """An imported module, by which file, and whether with the file or only when a function runs."""

    file: str
    module: str
    lazy: bool

    def __str__(self) -> str:
        return f"{self.file}: {self.module}"

    @property
    def head(self) -> str:
        """The top-level package that is imported."""
        return self.module.partition(".")[0]

    @property
    def part(self) -> str | None:
        """The part of flexel that is imported; None for any other package."""
        if self.head != "flexel":
            return None
        first = self.module.partition(".")[2].partition(".")[0]
        return first if first in PARTS else "runtime"


def imports(*parts: str) -> tuple[Import, ...]:
    """All imports of the parts, those for type checkers apart."""
    return tuple(entry for part in parts for entry in _imports(part))


@cache
def _imports(part: str) -> tuple[Import, ...]:
    return tuple(
        entry
        for path in sorted((ROOT / part).rglob("*.py"))
        for entry in _walk(path.relative_to(ROOT).as_posix(), ast.parse(path.read_text()), lazy=False)
    )


def _walk(file: str, node: ast.AST, lazy: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            yield from (Import(file, alias.name, lazy) for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            dots = "." * child.level  # a relative import is refused below
            yield from (Import(file, f"{dots}{child.module}.{alias.name}", lazy) for alias in child.names)
        elif isinstance(child, ast.Call) and ast.unparse(child.func).endswith("import_module"):
            yield from (Import(file, a.value, lazy) for a in child.args[:1] if isinstance(a, ast.Constant))
        elif not (isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test)):
            yield from _walk(file, child, lazy or isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef))


def test_no_import_is_relative() -> None:
    assert [str(statement) for statement in imports(*PARTS) if statement.module.startswith(".")] == []


def test_derive_imports_no_other_part_and_starts_without_compiled_kernels() -> None:
    """Deriving needs neither the runtime nor (except in one package) what was generated."""
    found = imports("derive")
    other = [
        str(statement)
        for statement in found
        if statement.part not in (None, "derive")
        and not (statement.part == "generated" and statement.file.startswith(SEES_GENERATED))
    ]
    assert other == []
    assert [
        str(statement) for statement in found if "_kernels" in statement.module and not statement.lazy
    ] == []


def test_generated_imports_only_itself() -> None:
    """The builder imports nothing of flexel; the table imports its specification."""
    found = imports("generated")
    assert [
        str(statement)
        for statement in found
        if statement.part not in (None, "generated") and not statement.module.startswith(SPEC)
    ] == []
    assert [
        str(statement)
        for statement in found
        if statement.file.endswith("/build.py") and statement.part is not None
    ] == []


def test_runtime_and_examples_derive_only_when_called_and_only_in_named_modules() -> None:
    """A model runs without SymPy; commands and user-defined elements import it when they need it."""
    symbolic = [
        statement
        for statement in imports("runtime", "parts", "results", "apps", "examples", BENCH)
        if not statement.file.startswith((PROGRAMS, *PAGES))
        and (
            (statement.part == "derive" and not statement.module.startswith(PLAIN))
            or statement.module.startswith(("sympy", "jinja2"))
        )
    ]
    assert [
        str(statement)
        for statement in symbolic
        if not (statement.lazy and statement.file in (*CALLS_DERIVE, *DERIVES))
    ] == []


def test_slow_and_optional_packages_are_imported_when_used() -> None:
    found = imports("runtime", "parts", "results", "apps", "examples", BENCH)
    eager = [statement for statement in found if not statement.lazy and statement.head in LAZY]
    assert [str(statement) for statement in eager if not statement.file.startswith((PROGRAMS, *PAGES))] == []


def test_pages_of_users_are_imported_when_they_are_compiled() -> None:
    names = tuple(f"flexel.{page.removesuffix('.py').replace('/', '.')}" for page in PAGES)
    found = [statement for statement in imports(*PARTS) if statement.module.startswith(names)]
    assert found
    assert [str(statement) for statement in found if not statement.lazy] == []


def test_nothing_imports_the_programs_of_the_gallery() -> None:
    assert [
        str(statement)
        for statement in imports(*PARTS)
        if statement.module.startswith("flexel.examples.gallery.")
    ] == []


def test_the_runtime_imports_no_examples() -> None:
    """They use flexel, not the other way round (commands find them by name)."""
    assert [
        str(statement)
        for statement in imports("runtime", "parts", "results", "apps")
        if statement.part == "examples"
    ] == []


def test_nothing_that_is_installed_imports_what_only_developers_run() -> None:
    """But `flexel bench`, when it runs, from a checkout."""
    names = {path.stem for path in (ROOT / "tools").iterdir() if path.suffix == ".py" or path.is_dir()}
    assert {"report", "write_report", "filling", "bench"} <= names
    found = [statement for statement in imports(*PARTS) if statement.head in names]
    assert [str(statement) for statement in found] == ["apps/cli/bench.py: bench.command"]
    assert found[0].lazy


def test_the_specification_brings_no_sympy() -> None:
    """The runtime reads the table of elements without what derived it."""
    code = "import sys, flexel.generated.table; assert not {'sympy', 'jinja2', 'numpy'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_import_flexel_is_light() -> None:
    """`import flexel` loads no numerical or symbolic package (`flexel bench start` shows how long it takes)."""
    code = (
        "import sys; import flexel;"
        "heavy = {'sympy', 'jinja2', 'numpy', 'scipy', 'matplotlib', 'cffi', 'click'} & set(sys.modules);"
        "assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_the_table_of_commands_brings_no_numpy() -> None:
    """`flexel --help` is quick, and `flexel bench` limits the threads of NumPy before it is imported."""
    code = "import sys, flexel.apps.cli.main; assert not {'numpy', 'scipy', 'sympy', 'matplotlib'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_every_public_name_is_defined_in_its_module_and_listed() -> None:
    homes = flexel._HOMES
    found = {name: getattr(import_module(home), name, None) for name, home in homes.items()}
    assert {name for name, value in found.items() if getattr(flexel, name) is not value} == set()
    assert {n for n, value in found.items() if getattr(value, "__module__", None) != homes[n]} == set()
    assert set(flexel.__all__) - set(dir(flexel)) == set()


def test_type_checkers_see_the_same_names() -> None:
    """The imports for type checkers, the table and `__all__` agree."""
    tree = ast.parse((ROOT / "runtime" / "__init__.py").read_text())
    block = next(n for n in tree.body if isinstance(n, ast.If) and "TYPE_CHECKING" in ast.unparse(n.test))
    typed = {a.name: n.module for n in block.body if isinstance(n, ast.ImportFrom) for a in n.names}
    assert typed == flexel._HOMES
    assert sorted(typed) == sorted(flexel.__all__)


def test_an_unknown_public_name_is_answered_with_the_known_ones() -> None:
    with pytest.raises(AttributeError, match="Moddel.*Model"):
        flexel.Moddel  # noqa: B018
