"""Fill the numbers that pages quote from the tables of `flexel reproduce`, and check that they are current.

``python tools/quoted.py`` fills README.md and the pages of ``docs/`` from ``docs/quoted/NAME.json``; with ``--run
NAME…`` (or ``all``) it runs these systems first and rewrites their files. ``--check`` changes nothing and fails where a
page differs from the files, or, with ``--run``, the files or a page from what the program gives now: `make docs` does.

A number with a mark behind it is filled; it keeps its style (decimals, exponent):

    3829.50<!--= nominal_tyre_front-->    the row of that name in the table that the page names last before it,
                                          as ``<!--quoted: vehicle-->``; or CASE/ROW
    7.5e-4<!--= wave_*:error-->           another key of the row; of several rows or entries, the largest size
    −7.08<!--= drop[0] ×1e3-->            an entry, a factor
    1e-12<!--≤ angle_max_error-->         a bound, written by hand, that must hold: for rounding and seconds
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from fnmatch import fnmatchcase
from importlib import import_module
from multiprocessing import get_context
from typing import Any

import numpy as np
from filling import DOCS, differing, entries, fill, pages

from flexel.apps.cli.reproduce import CASES
from flexel.results.reproduction import Report

KEPT = DOCS / "quoted"
COMPUTED = DOCS / "_generated" / "quoted.json"
DIGITS = 15  # that are kept of each number
SPACE = "\u00a0"  # between thousands, from five digits on
NUMBER = rf"−?\d+(?:{SPACE}\d{{3}})*(?:\.\d+)?(?:e-?\d+)?"
MARK = re.compile(rf"(?P<number>{NUMBER})<!--(?P<sign>[=≤]) (?P<path>.+?)-->|<!--quoted: (?P<case>\S+)-->")
PATH = re.compile(
    r"(?:(?P<case>[\w-]+)/)?(?P<row>[^:\[×]+?)(?::(?P<key>[^\[×]+?))?(?P<index>\[[\d,-]+\])?(?: ×(?P<factor>\S+))?"
)
SAME = ("name", "kind", "tolerance", "tolerance_kind", "reason", "unit")  # of a row, on every machine
Tables = Mapping[str, Sequence[Mapping[str, Any]]]  # the rows of each system


# -- numbers in a page ----------------------------------------------------------------------------


def look_up(path: str, case: str, tables: Tables) -> float:
    """Return the number named by a mark: the largest size of several, with the sign of a single one."""
    found = PATH.fullmatch(path)
    if found is None:
        raise ValueError(f"{path!r} does not read [CASE/]ROW[:KEY][[INDEX]][ ×FACTOR]")
    rows = [row for row in tables.get(found["case"] or case, ()) if fnmatchcase(row["name"], found["row"])]
    key = found["key"] or "computed"
    if not rows or any(key not in row for row in rows):
        raise ValueError(f"{path!r}: {found['case'] or case!r} has no such row with the key {key!r}")
    values = [np.asarray(row[key], dtype=float) for row in rows]
    if found["index"]:
        values = [value[tuple(json.loads(found["index"]))] for value in values]
    numbers = np.concatenate([np.ravel(value) for value in values])
    if not np.all(np.isfinite(numbers)):
        raise ValueError(f"{path!r}: a row of {found['case'] or case!r} has no number {key!r}")
    one = numbers[0] if numbers.size == 1 else np.abs(numbers).max()
    return float(one) * float(found["factor"] or 1)


def written(value: float, like: str) -> str:
    """Write a number in the style of another: with its decimals, and with an exponent if that has one."""
    mantissa, *exponent = like.split("e")
    decimals = len(mantissa.partition(".")[2])
    if exponent:
        digits, power = f"{abs(value):.{decimals}e}".split("e")
        text = f"{digits}e{int(power)}"
    else:
        text = f"{abs(value):,.{decimals}f}" if abs(value) >= 1e4 else f"{abs(value):.{decimals}f}"
    return ("−" if value < 0 else "") + text.replace(",", SPACE)


def read(text: str) -> tuple[float, float]:
    """Read a written number, and one unit of its last digit."""
    mantissa, _, exponent = text.replace("−", "-").replace(SPACE, "").partition("e")
    power = 10.0 ** int(exponent or 0)
    return float(mantissa) * power, 10.0 ** -len(mantissa.partition(".")[2]) * power


def marks(text: str) -> Iterator[tuple[re.Match[str], str]]:
    """Yield the marks of a page, each with the system to which it refers."""
    case = ""
    for found in MARK.finditer(text):
        if found["case"]:
            case = found["case"]
        else:
            yield found, case


def filled(text: str, tables: Tables) -> str:
    """Return the page with its numbers from the tables."""
    parts, last = [], 0
    for found, case in marks(text):
        value = look_up(found["path"], case, tables)
        start, end = found.span("number")
        number = found["number"] if found["sign"] == "≤" else written(value, found["number"])
        parts += [text[last:start], number]
        last = end
    return "".join(parts) + text[last:]


def wrong(text: str, tables: Tables) -> list[str]:
    """Report numbers that the tables contradict: more than one unit of the last digit off, or above a bound."""
    problems = []
    for found, case in marks(text):
        value, (quoted, unit) = look_up(found["path"], case, tables), read(found["number"])
        holds = value <= quoted if found["sign"] == "≤" else abs(value - quoted) <= unit * (1 + 1e-9)
        if not holds:
            problems.append(f"{found['number']} ({found['sign']} {found['path']}) is {value:.6g}")
    return problems


# -- tables ---------------------------------------------------------------------------------------


def rounded(value: Any) -> Any:
    """Round every number to `DIGITS`."""
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}")
    if isinstance(value, list | tuple):
        return [rounded(item) for item in value]
    return {k: rounded(item) for k, item in value.items()} if isinstance(value, dict) else value


def run(case: str) -> list[dict[str, Any]]:
    """Compute the rows of a system now."""
    print(f"{case} ...", file=sys.stderr, flush=True)
    report: Report = import_module(CASES[case]).reproduce(None)
    rows: list[dict[str, Any]] = rounded([quantity.to_dict() for quantity in report.quantities])
    return rows


def kept() -> dict[str, list[dict[str, Any]]]:
    """Return the stored rows of all systems."""
    return {
        path.stem: json.loads(path.read_text(encoding="utf-8"))["quantities"]
        for path in sorted(KEPT.glob("*.json"))
    }


def keep(case: str, rows: Sequence[Mapping[str, Any]]) -> None:
    """Write the rows of a system, a line each."""
    KEPT.mkdir(exist_ok=True)
    (KEPT / f"{case}.json").write_text(
        f'{{"case": "{case}", "quantities": [\n{entries(rows)}\n]}}\n', encoding="utf-8"
    )


def fresh(cases: Sequence[str]) -> dict[str, list[dict[str, Any]]]:
    """Compute the rows of systems now, two at a time; those of an unchanged program come from a file."""
    tables = computed()
    missing = [case for case in cases if case not in tables]
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        tables |= dict(zip(missing, pool.map(run, missing), strict=True))
    COMPUTED.parent.mkdir(exist_ok=True)
    COMPUTED.write_text(json.dumps({"digest": sources(), "tables": tables}), encoding="utf-8")
    return {case: tables[case] for case in cases}


def computed() -> dict[str, list[dict[str, Any]]]:
    """Return the tables that this very program has given before: those of the last `fresh`."""
    known = json.loads(COMPUTED.read_text(encoding="utf-8")) if COMPUTED.is_file() else {}
    tables: dict[str, list[dict[str, Any]]] = known["tables"] if known.get("digest") == sources() else {}
    return tables


def sources() -> str:
    """Return the digest of the program: its Python and C, and the data of the examples."""
    found = hashlib.sha256()
    for folder in (
        DOCS.parent / name for name in ("runtime", "parts", "results", "apps", "examples", "generated")
    ):
        for file in sorted(path for path in folder.rglob("*") if path.suffix in (".py", ".c", ".h", ".json")):
            found.update(file.read_bytes())
    return found.hexdigest()


def differences(tables: Tables, files: Tables) -> list[str]:
    """Report failed rows, and systems whose stored rows have other names, kinds or tolerances than the program's."""
    problems = [
        f"{case}: {row['name']} is not reproduced"
        for case in tables
        for row in tables[case]
        if row["ok"] is False
    ]
    for case, rows in tables.items():
        given, other = ([[row.get(k) for k in SAME] for row in t] for t in (rows, files.get(case, ())))
        if given != other:
            problems.append(f"{case}: the rows in docs/quoted/{case}.json are not those of the program")
    return problems


def check(tables: Tables) -> list[str]:
    """Report all problems: pages compared with the stored files, and both with tables computed now."""
    files = kept()
    unfilled = differing(pages(), lambda text: filled(text, files))
    problems = differences(tables, files) + [f"{page.name}: not filled from docs/quoted" for page in unfilled]
    for page in pages():
        text = page.read_text(encoding="utf-8")
        problems += [f"{page.name}: {problem}" for problem in wrong(text, {**files, **tables})]
    return problems


def main(arguments: Sequence[str] | None = None) -> int:
    """Fill or check the pages; the exit status is 1 if something differs."""
    parser = argparse.ArgumentParser(description="Numbers of the pages, from the tables of flexel reproduce.")
    parser.add_argument("--check", action="store_true", help="change nothing; fail where a number differs")
    parser.add_argument("--run", nargs="+", default=(), metavar="NAME", choices=[*CASES, "all"])
    given = parser.parse_args(arguments)
    tables = fresh(list(CASES) if "all" in given.run else given.run) if given.run else {}
    if given.check:
        problems = check(tables)
        advice = "python tools/quoted.py --run NAME... writes them anew; bounds (≤) are written by hand"
        print("\n".join([*problems, advice] if problems else ["the pages quote the program's numbers"]))
        return int(bool(problems))
    for case, rows in tables.items():
        keep(case, rows)
    files = kept()
    fill(pages(), lambda text: filled(text, files), check=False)
    for problem in check({}):
        print(problem)
    return 0


if __name__ == "__main__":
    sys.exit(main())
