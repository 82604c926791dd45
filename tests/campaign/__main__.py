"""The campaign outside pytest: ``python -m campaign --models 5000 --seed 1 --json out.json`` in the folder tests."""

import argparse
import os
import secrets
import sys
from collections.abc import Sequence
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices

from campaign.families import FAMILIES  # noqa: E402
from campaign.run import run, table, written  # noqa: E402


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; the exit status is 1 where a model has failed."""
    parser = argparse.ArgumentParser(
        prog="python -m campaign", description="Random models, checked for properties."
    )
    parser.add_argument("--models", type=int, default=5000, help="how many (5000)")
    parser.add_argument("--seed", type=int, help="a random one by default; it is printed")
    parser.add_argument("--json", type=Path, help="file for the findings")
    parser.add_argument(
        "--family", action="append", choices=sorted(FAMILIES), help="only this family; repeat"
    )
    parser.add_argument(
        "--all", action="store_true", help="keep all failures as they are drawn, without shrinking"
    )
    given = parser.parse_args(arguments)
    seed = secrets.randbelow(10**6) if given.seed is None else given.seed
    families = {z: FAMILIES[z] for z in given.family or FAMILIES}
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


if __name__ == "__main__":
    sys.exit(main())
