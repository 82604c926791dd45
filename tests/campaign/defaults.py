"""The campaign of default settings: so many rides, drawn by seed and none left out, and the table of outcomes."""

import sys
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from hypothesis import strategies as st

from campaign.draws import each
from campaign.drive import AGREE, OUTCOMES, SILENT, Verdict, driven
from campaign.grammar_rides import RIDES
from campaign.journal import Journal, Row
from campaign.ride import Ride
from campaign.run import shares

PART = 100  # rides of one seed


def drawn(strategy: st.SearchStrategy[Ride], count: int, seed: str) -> list[Ride]:
    """So many rides of one family; the first that hypothesis draws is always the simplest, and is not counted."""
    found: list[Ride] = []
    each(strategy, count + 1, seed, found.append)
    return found[1:]


def named(count: int, seed: int, families: Mapping[str, st.SearchStrategy[Ride]] = RIDES) -> dict[str, Ride]:
    """Rides of one seed by name, ``seed/family/number``."""
    found: dict[str, Ride] = {}
    for (family, strategy), share in zip(families.items(), shares(count, len(families)), strict=True):
        if share:
            some = drawn(strategy, share, f"{seed} {family}")
            found |= {f"{seed}/{family}/{i}": ride for i, ride in enumerate(some)}
    return found


def run(
    count: int,
    seed: int,
    families: Mapping[str, st.SearchStrategy[Ride]] = RIDES,
    report: Callable[[str, Verdict], None] | None = None,
    journal: Journal | None = None,
) -> dict[str, Any]:
    """Draw rides, `PART` of each seed from the given one on, and judge those that the journal does not have.

    An interrupt ends the run; what was found until then is returned.
    """
    journal = Journal() if journal is None else journal
    rows: list[Row] = []
    try:
        for part, first in enumerate(range(0, count, PART)):
            for name, ride in named(min(PART, count - first), seed + part, families).items():
                row = journal.row(name, ride)
                if row is None:
                    verdict = driven(ride)
                    row = journal.keep(name, verdict)
                    if report is not None:
                        report(name, verdict)
                rows.append(row)
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
    return summary(rows, seed)


def summary(rows: Sequence[Row], seed: int) -> dict[str, Any]:
    """What docs/verification.md shows, from the rows of a journal."""
    by_family: dict[str, Counter[str]] = {}
    by_trait: dict[str, Counter[str]] = {}
    for row in rows:
        by_family.setdefault(row["family"], Counter())[row["outcome"]] += 1
        for trait in row["traits"] or ("none",):
            by_trait.setdefault(trait, Counter())[row["outcome"]] += 1
    counted = {
        kind: [{"name": name, **{o: found[o] for o in OUTCOMES}} for name, found in sorted(some.items())]
        for kind, some in (("families", by_family), ("traits", by_trait))
    }
    return {
        "campaign": "defaults",
        "seed": seed,
        "part": PART,
        "models": len(rows),
        "seconds": round(sum(row["seconds"] for row in rows), 1),
        "outcomes": {o: sum(row["outcome"] == o for row in rows) for o in OUTCOMES},
        **counted,
        "methods": dict(Counter(row["method"] or "none" for row in rows)),
        "silent": [
            {key: row[key] for key in ("name", "why", "method", "program")}
            for row in rows
            if row["outcome"] == SILENT
        ],
        "others": [
            {key: row[key] for key in ("name", "outcome", "why", "method")}
            for row in rows
            if row["outcome"] not in (SILENT, AGREE)
        ],
    }


def table(report: Mapping[str, Any]) -> str:
    """The report as text: outcomes by family and by trait, silent errors with their programs."""
    lines = [f"{report['models']} motions in {report['seconds']:g} s, seed {report['seed']}"]
    for kind in ("families", "traits"):
        lines.append(f"{kind:30s} " + " ".join(f"{o:>12s}" for o in OUTCOMES))
        lines += [f"{row['name']:30s} " + " ".join(f"{row[o]:12d}" for o in OUTCOMES) for row in report[kind]]
    lines.append(f"{'all':30s} " + " ".join(f"{report['outcomes'][o]:12d}" for o in OUTCOMES))
    lines += [
        f"{entry['outcome']} {entry['name']} ({entry['method']}): {entry['why']}"
        for entry in report["others"]
    ]
    for entry in report["silent"]:
        lines += [f"SILENT {entry['name']} ({entry['method']}): {entry['why']}", entry["program"]]
    return "\n".join(lines)
