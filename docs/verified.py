"""Fill the tables of docs/verification.md with what the property campaign found.

``python docs/verified.py FILE`` takes the findings that ``python -m campaign --json FILE`` wrote and keeps them in
``docs/verification.json``. Without FILE the tables are filled from there; ``--check`` changes nothing and fails where
a table differs. A table is between two marks, and is written anew:

    <!--campaign: run-->          a line: models, seed
    <!--campaign: properties-->   largest and median error of each property
    <!--campaign: families-->     models of each family
    <!--campaign: skipped-->      where a property had nothing to say
    <!--end-->
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import filling

from flexel.report.markup import size

DOCS = Path(__file__).resolve().parent
KEPT, PAGE = DOCS / "verification.json", DOCS / "verification.md"
BLOCK = filling.marked("campaign")
Findings = Mapping[str, Any]


def run(found: Findings) -> Iterator[str]:
    """How many models, of which seed, and how many failed."""
    failed = len(found["failures"])
    yield f"{found['models']} models with the seed {found['seed']}; {failed or 'none'} failed."


def properties(found: Findings) -> Iterator[str]:
    """The errors of each property."""
    yield "| property | models | largest error | median | tolerance |"
    yield "|---|---|---|---|---|"
    for z in found["properties"]:
        errors = " | ".join(size(z[key]) for key in ("largest", "median", "tolerance"))
        yield f"| {z['name']} | {z['models']} | {errors} |"


def families(found: Findings) -> Iterator[str]:
    """How many models of each family."""
    yield "| family | models |"
    yield "|---|---|"
    for name, count in found["families"].items():
        yield f"| {name} | {count} |"


def skipped(found: Findings) -> Iterator[str]:
    """Why properties had nothing to say, with the properties that one reason concerns in one row."""
    counts: Counter[str] = Counter()
    concerned: dict[str, list[str]] = {}
    for z in found["skipped"]:
        name, _, reason = z["reason"].partition(": ")
        counts[reason] = max(counts[reason], z["models"])
        concerned.setdefault(reason, []).append(name)
    yield "| reason | properties | models |"
    yield "|---|---|---|"
    for reason, count in counts.most_common():
        yield f"| {reason} | {', '.join(concerned[reason])} | {count} |"


TABLES: dict[str, Callable[[Findings], Iterator[str]]] = {
    "run": run,
    "properties": properties,
    "families": families,
    "skipped": skipped,
}


def filled(text: str, found: Findings) -> str:
    """The page with its tables written anew."""
    return filling.filled(text, BLOCK, lambda mark: TABLES[mark[3]](found))


def main(arguments: Sequence[str] | None = None) -> int:
    """Fill or check the page; the exit status is 1 where it differs."""
    parser = argparse.ArgumentParser(
        description="Tables of the page on verification from the property campaign."
    )
    parser.add_argument("file", nargs="?", type=Path, help="JSON of python -m campaign")
    parser.add_argument("--check", action="store_true", help="change nothing; fail where a table differs")
    given = parser.parse_args(arguments)
    content = (given.file or KEPT).read_text(encoding="utf-8")
    if given.file is not None and not given.check:
        KEPT.write_text(content, encoding="utf-8")
    findings = json.loads(content)
    return filling.fill([PAGE], lambda text: filled(text, findings), check=given.check)


if __name__ == "__main__":
    sys.exit(main())
