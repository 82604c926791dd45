"""Count what keeps the program small and clear, and compare with ``tools/house.json``: these figures may only fall.

``python tools/house.py`` prints the table and fails where a figure has grown, with what is new. One that has fallen
is kept by ``--write``, so that it cannot grow back unseen. Where a figure has to grow, ``--write --because "reason"``
keeps it together with the reason. `tests/tools/test_house.py` runs it in `make test`.
"""

from __future__ import annotations

import argparse
import ast
import json
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass, field
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
KEPT = Path(__file__).parent / "house.json"
SHIPPED = (
    "runtime",
    "parts",
    "results",
    "apps",
)  # what is in the wheel, but for derive/, generated/ and examples/
SHOWN = 8  # of what is new, in a message
PLAY = (
    0.005  # share by which lines may exceed the kept number, or stay below it unkept: corrections take a few
)


@dataclass(frozen=True)
class Figure:
    """What is counted.

    Attributes
    ----------
    value : int
    parts : dict of str to int
        The same by file or name, where they are to be known; none for lines and files.
    """

    value: int
    parts: dict[str, int] = field(default_factory=dict)

    @classmethod
    def of(cls, parts: dict[str, int]) -> Figure:
        """The sum of parts."""
        return cls(sum(parts.values()), parts)


def _again(names: Iterable[str]) -> Figure:
    """How often names occur after their first time."""
    return Figure.of({name: count - 1 for name, count in sorted(Counter(names).items()) if count > 1})


@cache
def modules(folder: str) -> dict[str, ast.Module]:
    """The syntax trees of the files in a folder, by path."""
    files = sorted((ROOT / folder).rglob("*.py"))
    return {str(path.relative_to(ROOT)): ast.parse(path.read_text(encoding="utf-8")) for path in files}


def _shipped() -> dict[str, ast.Module]:
    return {path: tree for folder in SHIPPED for path, tree in modules(folder).items()}


def lines(*folders: str, kinds: tuple[str, ...] = (".py",)) -> Figure:
    """Lines of files of some kinds."""
    files = [file for folder in folders for file in (ROOT / folder).rglob("*") if file.suffix in kinds]
    return Figure(sum(len(file.read_text("utf-8").splitlines()) for file in files))


def constants(tree: ast.Module) -> Iterator[str]:
    """Names of numbers that a module gives in capitals: thresholds, counts, tolerances."""
    for node in tree.body:
        targets = (
            node.targets
            if isinstance(node, ast.Assign)
            else [node.target]
            if isinstance(node, ast.AnnAssign)
            else []
        )
        named = [name.id for target in targets for name in ast.walk(target) if isinstance(name, ast.Name)]
        values = getattr(node, "value", None)
        numeric = values is not None and any(
            isinstance(part, ast.Constant) and type(part.value) in (int, float) for part in ast.walk(values)
        )
        yield from (name for name in named if numeric and name.isupper())


def thresholds() -> Figure:
    """Named numbers of integration/."""
    return Figure.of({path: len([*constants(tree)]) for path, tree in modules("runtime/integration").items()})


def classes() -> Iterator[str]:
    """Names of the public classes of all modules."""
    for tree in _shipped().values():
        yield from (node.name for node in tree.body if isinstance(node, ast.ClassDef) and node.name[0] != "_")


def bases(name: str) -> Figure:
    """Classes of which one is made, but `object`."""
    import flexel

    return Figure.of({cls.__qualname__: 1 for cls in getattr(flexel, name).__mro__[:-1]})


def figures() -> dict[str, Figure]:
    """All that is counted, by what it is called in the table."""
    stems = [Path(path).stem for path in _shipped()]
    return {
        "lines of Python in runtime/": lines("runtime"),
        "lines of Python in runtime/, parts/, results/ and apps/": lines(*SHIPPED),
        "lines of C by hand": lines("runtime/engine", kinds=(".c", ".h")),
        "files of Python in runtime/, parts/, results/ and apps/": Figure(len(_shipped())),
        "named numbers of integration/": thresholds(),
        "names of numbers given again in another module": _again(
            name for tree in _shipped().values() for name in sorted(set(constants(tree)))
        ),
        "names of public classes given again": _again(classes()),
        "names of modules given again": _again(stem for stem in stems if not stem.startswith("__")),
        "classes of which Model is made": bases("Model"),
        "classes of which System is made": bases("System"),
    }


def grown(now: dict[str, int], kept: dict[str, int]) -> str:
    """What is new in a figure, the largest first."""
    more = {name: value - kept.get(name, 0) for name, value in now.items() if value > kept.get(name, 0)}
    largest = sorted(more, key=lambda name: -more[name])
    listed = ", ".join(f"{name} +{more[name]}" for name in largest[:SHOWN])
    return listed and f" ({listed}{', …' * (len(largest) > SHOWN)})"


def faults(found: dict[str, Figure], kept: dict[str, Figure]) -> tuple[list[str], list[str]]:
    """What is above the kept figures, and what is below."""
    above, below = [], []
    for name, now in found.items():
        before = kept.get(name, Figure(0))
        play = PLAY * before.value if name.startswith("lines") else 0
        if now.value > before.value + play:
            above.append(
                f"{name}: {now.value} for {before.value}{grown(now.parts, before.parts)}; make it smaller, or "
                'python tools/house.py --write --because "reason"'
            )
        elif now.value < before.value - play:
            below.append(f"{name}: only {now.value} for {before.value}: python tools/house.py --write")
    return above, below


def kept() -> dict[str, Figure]:
    """The kept figures."""
    return {name: Figure(**row) for name, row in json.loads(KEPT.read_text("utf-8"))["figures"].items()}


def main() -> int:
    """Print the table; the exit status is 1 where a figure has changed and is not kept."""
    parser = argparse.ArgumentParser(description="Figures that may only fall.")
    parser.add_argument("--write", action="store_true", help="keep the figures")
    parser.add_argument("--because", metavar="REASON", help="why some have to grow")
    given = parser.parse_args()
    found = figures()
    for name, figure in found.items():
        print(f"{figure.value:7d}  {name}")
    above, below = faults(found, kept())
    if not given.write or (above and not given.because):
        print(*above, *below, sep="\n", file=sys.stderr)
        return int(bool(above or below))
    grown_because = json.loads(KEPT.read_text("utf-8"))["grown because"] + [given.because] * bool(above)
    content = {"grown because": grown_because, "figures": {name: asdict(row) for name, row in found.items()}}
    KEPT.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
