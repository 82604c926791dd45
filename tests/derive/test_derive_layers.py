"""The order of the layers of ``derive``: a module imports from its own layer or from lower ones, and in no circle.

Imports for type checkers and those inside functions count.
"""

import ast
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

DERIVE = Path(__file__).resolve().parents[2] / "derive"
LAYERS = (
    ("checksum_trailer", "definition_errors", "processor", "spec"),
    ("cache", "users_file"),
    ("object_files", "shared_object"),
    ("compiled",),
    ("declare",),
    ("elements", "laws", "definition_key", "users_page", "formulas_text"),
    ("program", "energy", "general", "begins", "clipped"),
    ("emit",),
    ("check",),
    ("verify",),
    ("derived_code", "user_definitions", "acceptance", "accept"),
    ("__main__", "verify_command", "show_command"),
)
# importer and imported, against the order
EXCEPTIONS: set[tuple[str, str]] = {
    (
        "derive",
        "derive.declare",
    ),  # the package resolves the names of its declarations on demand
}
MODULES = {
    ".".join(("derive", *path.relative_to(DERIVE).with_suffix("").parts)).removesuffix(".__init__"): path
    for path in sorted(DERIVE.rglob("*.py"))
}
LEVEL = {name: level for level, names in enumerate(LAYERS) for name in names}


def level(module: str) -> int:
    """Return the number of a module's layer; the package itself lies below all."""
    return -1 if module == "derive" else LEVEL[module.split(".")[1]]


def imported(path: Path) -> set[str]:
    """Return the modules of derive that a file imports anywhere in it."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith("import_module"):
            names = [argument.value for argument in node.args[:1] if isinstance(argument, ast.Constant)]
        else:
            continue
        for name in names:
            own = name.removeprefix("flexel.")
            whole = own if own in MODULES else own.rpartition(".")[0]
            if name.startswith("flexel.") and whole in MODULES:
                found.add(whole)
    return found


ARROWS = {name: imported(path) for name, path in MODULES.items()}


@pytest.mark.parametrize("name", MODULES)
def test_a_module_imports_from_its_own_layer_or_lower_ones(name: str) -> None:
    against = {(name, other) for other in ARROWS[name] if level(other) > level(name)}
    assert against - EXCEPTIONS == set()


def test_imports_go_in_no_circle() -> None:
    graph = {
        name: {other for other in others if (name, other) not in EXCEPTIONS}
        for name, others in ARROWS.items()
    }
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as circle:
        pytest.fail(" <- ".join(circle.args[1]))


def test_every_exception_is_needed() -> None:
    assert {(name, other) for name, others in ARROWS.items() for other in others} >= EXCEPTIONS
