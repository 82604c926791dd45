"""Fill the tables of docs/verification.md with the results of the campaigns.

``python tools/verified.py FILE`` takes the findings that ``python -m campaign --json FILE`` wrote, with ``--defaults``
or without, and keeps them in ``docs/verification_defaults.json`` or ``docs/verification.json``. Without FILE the tables
are filled from there; ``--check`` changes nothing and fails where a table differs. A table is between two marks, and is
written anew:

    <!--campaign: run-->          a line: models, seed
    <!--campaign: properties-->   largest and median error of each property
    <!--campaign: families-->     models of each family
    <!--campaign: skipped-->      reasons why a property was not tested
    <!--defaults: run-->          a line: motions, seeds, number of silent errors
    <!--defaults: outcomes-->     outcomes of the motions, by family
    <!--defaults: traits-->       the same by the extensions of the models
    <!--defaults: silent-->       the silent errors
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
from filling import DOCS
from report.markup import size

PAGE = DOCS / "verification.md"
KEPT = {"property": DOCS / "verification.json", "defaults": DOCS / "verification_defaults.json"}
MARKS = {"campaign": "property", "defaults": "defaults"}
BLOCK = filling.marked("|".join(MARKS))
Findings = Mapping[str, Any]


def run(found: Findings) -> Iterator[str]:
    """Write the number of models, the seed, and the number of failures."""
    failed = len(found["failures"])
    yield f"{found['models']} models with the seed {found['seed']}; {failed or 'none'} failed."


def properties(found: Findings) -> Iterator[str]:
    """Write the errors of each property."""
    yield "| property | models | largest error | median | tolerance |"
    yield "|---|---|---|---|---|"
    for row in found["properties"]:
        errors = " | ".join(size(row[key]) for key in ("largest", "median", "tolerance"))
        yield f"| {row['name']} | {row['models']} | {errors} |"


def families(found: Findings) -> Iterator[str]:
    """Write the number of models of each family."""
    yield "| family | models |"
    yield "|---|---|"
    for name, count in found["families"].items():
        yield f"| {name} | {count} |"


def skipped(found: Findings) -> Iterator[str]:
    """Write why properties were not tested, with the properties of one reason in one row."""
    counts: Counter[str] = Counter()
    concerned: dict[str, list[str]] = {}
    for row in found["skipped"]:
        name, _, reason = row["reason"].partition(": ")
        counts[reason] = max(counts[reason], row["models"])
        concerned.setdefault(reason, []).append(name)
    yield "| reason | properties | models |"
    yield "|---|---|---|"
    for reason, count in counts.most_common():
        yield f"| {reason} | {', '.join(concerned[reason])} | {count} |"


def motions(found: Findings) -> Iterator[str]:
    """State how many motions, of which seeds, and how many errors are silent."""
    wrong, models = len(found["silent"]), found["models"]
    last = found["seed"] + (models - 1) // found["part"]
    seeds = f"the seed {last}" if last == found["seed"] else f"the seeds {found['seed']} to {last}"
    verb = "has" if wrong == 1 else "have"
    yield f"{models} motions with {seeds}; {wrong or 'none'} of them {verb} a silent error."


def outcomes(found: Findings) -> Iterator[str]:
    """List what became of the motions of each family."""
    yield from _counted(found, "families", "family")
    yield f"| all | {' | '.join(map(str, found['outcomes'].values()))} |"


def traits(found: Findings) -> Iterator[str]:
    """List what became of the motions with each trait."""
    yield from _counted(found, "traits", "trait")


def _counted(found: Findings, rows: str, title: str) -> Iterator[str]:
    names = list(found["outcomes"])
    yield f"| {title} | {' | '.join(names)} |"
    yield "|---|" + "---|" * len(names)
    for row in found[rows]:
        yield f"| {row['name']} | {' | '.join(str(row[name]) for name in names)} |"


def silent(found: Findings) -> Iterator[str]:
    """List the silent errors, with their worst quantities."""
    if not found["silent"]:
        yield "None."
        return
    yield "| motion | method | worst quantity |"
    yield "|---|---|---|"
    for row in found["silent"]:
        yield f"| {row['name']} | {row['method']} | {row['why']} |"


TABLES: dict[str, dict[str, Callable[[Findings], Iterator[str]]]] = {
    "campaign": {"run": run, "properties": properties, "families": families, "skipped": skipped},
    "defaults": {"run": motions, "outcomes": outcomes, "traits": traits, "silent": silent},
}


def filled(text: str, found: Mapping[str, Findings]) -> str:
    """Return the page with its tables written anew from the findings of each campaign."""
    return filling.filled(text, BLOCK, lambda mark: TABLES[mark[2]][mark[3]](found[MARKS[mark[2]]]))


def main(arguments: Sequence[str] | None = None) -> int:
    """Fill or check the page; the exit status is 1 if it differs."""
    parser = argparse.ArgumentParser(description="Tables of the page on verification from the campaigns.")
    parser.add_argument("file", nargs="?", type=Path, help="JSON of python -m campaign")
    parser.add_argument("--check", action="store_true", help="change nothing; fail where a table differs")
    given = parser.parse_args(arguments)
    findings = {
        name: json.loads(path.read_text(encoding="utf-8")) for name, path in KEPT.items() if path.exists()
    }
    if given.file is not None:
        content = given.file.read_text(encoding="utf-8")
        new = json.loads(content)
        findings[new["campaign"]] = new
        if not given.check:
            KEPT[new["campaign"]].write_text(content, encoding="utf-8")
    return filling.fill([PAGE], lambda text: filled(text, findings), check=given.check)


if __name__ == "__main__":
    sys.exit(main())
