"""The campaigns outside pytest: ``python -m campaign --models 5000 --seed 1 --json out.json`` in the folder tests.

With ``--defaults`` motions by default settings are held against references; see `campaign.drive`. Each verdict is
written to ``out.jsonl`` at once: the same command continues from there, and processes with other seeds may share it.
"""

import argparse
import secrets
import sys
from collections.abc import Sequence
from pathlib import Path

from campaign import defaults
from campaign.drive import Verdict
from campaign.families import FAMILIES
from campaign.grammar_rides import RIDES
from campaign.journal import Journal
from campaign.run import run, table, written


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; the exit status is 1 where a model has failed, or a motion is wrong and does not say so."""
    parser = argparse.ArgumentParser(
        prog="python -m campaign", description="Random models, checked for properties."
    )
    parser.add_argument("--models", type=int, default=5000, help="how many (5000)")
    parser.add_argument("--seed", type=int, help="a random one by default; it is printed")
    parser.add_argument("--json", type=Path, help="file for the findings")
    parser.add_argument("--family", action="append", choices=sorted(RIDES), help="only this family; repeat")
    parser.add_argument(
        "--all", action="store_true", help="keep all failures as they are drawn, without shrinking"
    )
    parser.add_argument(
        "--defaults", action="store_true", help="motions by default settings, against references"
    )
    given = parser.parse_args(arguments)
    seed = secrets.randbelow(10**6) if given.seed is None else given.seed
    if given.defaults:
        return _by_default_settings(given, seed)
    families = {name: FAMILIES[name] for name in given.family or FAMILIES}
    print(f"seed {seed}, {given.models} models of {len(families)} families", flush=True)

    def progress(done: int) -> None:
        if done % 20 == 0 or done == given.models:
            print(f"\r{done} of {given.models}", end="", file=sys.stderr, flush=True)

    found = run(given.models, seed, families, shrink=not given.all, report=progress)
    print(file=sys.stderr)
    print(table(found))
    if given.json is not None:
        given.json.write_text(written(found), encoding="utf-8")
    return int(bool(found["failures"]))


def _by_default_settings(given: argparse.Namespace, seed: int) -> int:
    """Run the campaign of default settings; each verdict is printed as it is found."""

    def line(name: str, verdict: Verdict) -> None:
        traits = ", ".join(verdict.ride.traits)
        print(
            f"{verdict.outcome:13s} {verdict.excess:8.2g} {verdict.seconds:5.1f} s  {name} ({traits}) "
            f"{verdict.method}: {verdict.why}",
            flush=True,
        )

    families = {name: RIDES[name] for name in given.family or RIDES}
    path = None if given.json is None else given.json.with_suffix(".jsonl")
    found = defaults.run(given.models, seed, families, report=line, journal=Journal(path))
    print(defaults.table(found))
    if given.json is not None:
        given.json.write_text(written(found), encoding="utf-8")
    return int(bool(found["silent"]))


if __name__ == "__main__":
    sys.exit(main())
