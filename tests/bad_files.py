"""Damaged files of every format that flexel reads: what there is to be tried, and the verdict.

A file is cut off, bytes are changed, zeroed, doubled or taken away; in text, words are replaced by others; and the
record of a result is changed before it is written, so that no digest betrays it.
"""

import random
import re
import shutil
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import travellers
from bad_calls import OWN_WARNINGS
from swept import numbers, plain
from valid_flexures import found as leaf
from valid_results import forced, swing

import flexel as fx
from flexel.results.saved.record import Record
from flexel.results.saved.record_files import FORMATS, read, write

DATA = Path(__file__).parent / "data"
RESULTS = ("motion", "linearization", "periodic", "flexure")
SAVED = [f"{kind}{suffix}" for kind in RESULTS for suffix in FORMATS]
SPACAR = [path.name for path in sorted(DATA.glob("*.dat"))]
FOLDER = ["sweep.json", "status.npy", "points/0.npy", "values/0.npy"]  # of the folder of a sweep
WORDS = (
    "nan",
    "-1",
    "1e999",
    "1e-999",
    "0",
    "99999999999999999999",
    "junk",
    '"',
    "{",
    "[]",
    "null",
    "",
    "é\0",
)
CHANGES = (
    "no array",
    "short array",
    "long array",
    "other names",
    "no header",
    "header of text",
    "other kind",
    "nan",
)


@dataclass(frozen=True)
class Damage:
    """A file, how it is damaged, and the seed of the place."""

    file: str
    how: str
    seed: int

    def __str__(self) -> str:
        return f"{self.file}, {self.how} {self.seed}"


def _cut(data: bytes, r: random.Random) -> bytes:
    return data[: r.randrange(len(data))]


def _changed(data: bytes, r: random.Random) -> bytes:
    found = bytearray(data)
    for _ in range(r.choice((1, 1, 8))):
        found[r.randrange(len(found))] ^= 1 << r.randrange(8)
    return bytes(found)


def _zeroed(data: bytes, r: random.Random) -> bytes:
    i = r.randrange(len(data))
    return data[:i] + bytes(len(data[i : i + 64])) + data[i + 64 :]


def _doubled(data: bytes, r: random.Random) -> bytes:
    i = r.randrange(len(data))
    return data[:i] + data[i : i + 200] + data[i:]


def _without(data: bytes, r: random.Random) -> bytes:
    i = r.randrange(len(data))
    return data[:i] + data[i + 40 :]


def _word(data: bytes, r: random.Random) -> bytes:
    """Another word in place of one of a text."""
    words = list(re.finditer(rb"[^\s,:\[\]{}]+", data))
    word = r.choice(words)
    return data[: word.start()] + r.choice(WORDS).encode() + data[word.end() :]


def _line(data: bytes, r: random.Random) -> bytes:
    """A line taken away, or moved to the start."""
    lines = data.splitlines(keepends=True)
    line = lines.pop(r.randrange(len(lines)))
    return b"".join(lines if r.random() < 0.5 else [line, *lines])


BYTES: dict[str, Callable[[bytes, random.Random], bytes]] = {
    "cut off": _cut,
    "changed": _changed,
    "zeroed": _zeroed,
    "doubled": _doubled,
    "without": _without,
}
TEXT = {"word": _word, "line": _line}


def _record(found: Record, how: str, r: random.Random) -> Record:
    """A record that fits its digest and says something else."""
    variables, labels, header = dict(found.variables), dict(found.labels), dict(found.header)
    name = r.choice(sorted(variables))
    variable = variables[name]
    if how == "no array":
        del variables[name]
    elif how in ("short array", "long array"):
        values = (
            variable.values[:-1]
            if how == "short array"
            else np.concatenate([variable.values, variable.values])
        )
        variables[name] = replace(variable, values=np.asarray(values))
    elif how == "nan":
        variables[name] = replace(variable, values=np.full(variable.values.shape, np.nan))
    elif how == "other names" and labels:
        dim = r.choice(sorted(labels))
        labels[dim] = tuple(f"other {name}" for name in labels[dim])
    elif how == "no header" and header:
        del header[r.choice(sorted(header))]
    elif how == "header of text" and header:
        header[r.choice(sorted(header))] = "junk"
    kind = r.choice(["junk", *RESULTS]) if how == "other kind" else found.kind
    return Record(kind, variables, labels, found.units, header)


def cases(count: int) -> list[Damage]:
    """That many of each kind of damage to each file."""
    found: list[Damage] = []
    for file in [*SAVED, *SPACAR, *FOLDER]:
        text = Path(file).suffix in (".csv", ".dat", ".json")
        kinds = [*BYTES, *(TEXT if text else ())]
        found += [Damage(file, how, i) for how in kinds for i in range(count)]
        if file in SAVED:
            fitting = [
                how
                for how in CHANGES
                if not (how.endswith(" array") and file.endswith((".mat", ".csv", ".nc")))
            ]
            found += [Damage(file, how, i) for how in fitting for i in range(min(count, 8))]
    return found


def prepare() -> None:
    """The whole files, in the folder of the process."""
    results = dict(zip(RESULTS, (swing(), forced(), travellers.periodic(), leaf()), strict=True))
    for file in SAVED:
        results[Path(file).stem].save(file)
    for file in SPACAR:
        shutil.copy(DATA / file, file)
    fx.sweep(plain, {"a": [1, 2]}, numbers, executor="serial", folder="sweep", progress=False)


def damaged(damage: Damage) -> Path:
    """The damaged file, in a folder of its own."""
    r = random.Random(f"{damage.file} {damage.how} {damage.seed}")
    shutil.rmtree("damaged", ignore_errors=True)
    path = Path("damaged") / damage.file
    path.parent.mkdir(parents=True)
    if damage.file in FOLDER:
        shutil.copytree("sweep", "damaged", dirs_exist_ok=True)
        path.write_bytes((BYTES | TEXT)[damage.how](path.read_bytes(), r))
    elif damage.how in CHANGES:
        write(_record(read(damage.file), damage.how, r), path)
    else:
        path.write_bytes((BYTES | TEXT)[damage.how](Path(damage.file).read_bytes(), r))
    return path


def _other_numbers(damage: Damage, found: Any) -> bool:
    """Whether bytes were changed and a result is read all the same, with other numbers."""
    if damage.file not in SAVED or damage.how in CHANGES:
        return False
    mine, theirs = read(Path("damaged") / damage.file), read(damage.file)
    if mine.variables.keys() != theirs.variables.keys():
        return True
    return not all(
        np.array_equal(mine.variables[name].values, theirs.variables[name].values, equal_nan=True)
        for name in mine.variables
    )


def verdict(damage: Damage) -> str:
    """What is wrong with what reading a damaged file does; empty if nothing is."""
    path = damaged(damage)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            if damage.file in FOLDER:
                fx.open_sweep("damaged").load()
            elif path.suffix == ".dat":
                _ = fx.read_spacar(path).system
            elif _other_numbers(damage, fx.load(path)):
                return "read with other numbers"
        except fx.FlexelError as error:
            return "" if len(str(error)) > 20 else f"says only {error!s}"
        except Exception as error:
            return f"{type(error).__name__}: {error}"[:300]
    foreign = [warning for warning in caught if not issubclass(warning.category, OWN_WARNINGS)]
    return f"warning {foreign[0].category.__name__}: {foreign[0].message}"[:300] if foreign else ""
