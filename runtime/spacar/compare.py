"""Results of a run beside SPACAR's own, from its .sbd, .sbm and .ltv files: the largest differences, and where."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from flexel.base.arguments import path_of
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.results.saved.loading import SPACAR
from flexel.results.saved.spacar_entries import read_entries
from flexel.results.saved.spacar_motion import NORM
from flexel.spacar.modes import Analysis
from flexel.spacar.reading import Spacar
from flexel.spacar.vectors import OF_NODES, Place, vectors

# our tables, SPACAR's tags, and what they are called
TABLES = {
    "x": ("X", "coordinates"),
    "xd": ("XD", "rates of coordinates"),
    "xdd": ("XDD", "accelerations"),
    "fxtot": ("FXT", "reactions"),
    "e": ("E", "deformations"),
    "ed": ("ED", "rates of deformations"),
    "edd": ("EDD", "second rates of deformations"),
    "sig": ("SIG", "stresses"),
}
MATRICES = ("M0", "C0", "D0", "K0", "N0", "G0", "A", "B", "C", "D")
Pair = tuple[int, int]  # numbers of a state here and of a record there that belong together
NEAR = 1e-9  # distance of two times over the length of the motion, still taken as the same


@dataclass(frozen=True)
class Theirs:
    """Results of SPACAR.

    Attributes
    ----------
    time : ndarray (nt,)
    tables : mapping of str to ndarray (nt, columns)
        Of an .sbd file, by our names.
    places : mapping of "x" and "e" to mapping
        Columns (from 0) of coordinates of nodes, and of modes of elements.
    matrices : mapping of str to ndarray (nt, rows, columns)
        Of the other files.
    """

    path: Path
    time: Array
    tables: Mapping[str, Array]
    places: Mapping[str, Mapping[Place, int]]
    matrices: Mapping[str, Array]


def results_of_spacar(path: str | Path) -> Theirs:
    """Results of SPACAR in a file.

    Raises
    ------
    ModelError
        A suffix other than .sbd, .sbm, .ltv; a missing or damaged file.
    """
    path = path_of(path, "compare")
    if path.suffix.lower() not in SPACAR:
        raise ModelError(
            f"compare '{path}': suffix '{path.suffix}' is unknown; give one of {', '.join(SPACAR)}"
        )
    entries = read_entries(path)
    SPACAR[path.suffix.lower()](entries, path)  # which says what is wrong with a file
    time = entries.records["T"][:, 0, 0]
    if path.suffix.lower() != ".sbd":
        known = {tag: z for tag, z in entries.records.items() if tag in MATRICES}
        return Theirs(path, time, {}, {}, known)
    tables = {name: entries.records[tag][:, :, 0] for name, (tag, _) in TABLES.items()}
    norms = {e for e, kind in enumerate(np.ravel(entries.constant["IT"]), 1) if kind == NORM}
    places = {
        "x": _places(entries.constant["LNP"]),
        "e": {z: i for z, i in _places(entries.constant["LE"]).items() if z[0] not in norms},
    }
    return Theirs(path, time, tables, places, {})


def _places(table: Array) -> dict[Place, int]:
    """Columns, from 0, of a table of places from 1."""
    return {(n, i): int(z) - 1 for n, row in enumerate(table, 1) for i, z in enumerate(row, 1) if z > 0}


def comparison(file: Spacar, found: Analysis, theirs: Theirs) -> list[str]:
    """Lines about the differences of an analysis from SPACAR's results, and about what has no counterpart."""
    head = f"beside {theirs.path.name}, {len(theirs.time)} records"
    if not found.states:
        return [head, "  this analysis has no states to compare; choose another --mode"]
    ours = np.array([z.t for z in found.states])
    steps = (
        found.system is not None or ours.size == theirs.time.size == 1
    )  # load steps have no times in SPACAR
    pairs = (_by_number if steps else _by_time)(ours, theirs.time)
    unpaired = [*_unpaired(pairs, ours, theirs.time)]
    if not pairs:
        return [head, *(f"  {z}" for z in unpaired)]
    rows = [*_vector_rows(file, found, theirs, pairs), *_matrix_rows(found, theirs, pairs)]
    title = f"  {'':<30}{'difference':>12}{'of':>12}{'ratio':>12}  where"
    return [head, title, *(f"  {z}" for z in (*rows, *unpaired, *_without(file, found, theirs)))]


def _by_number(ours: Array, theirs: Array) -> list[Pair]:
    return [(i, i) for i in range(min(len(ours), len(theirs)))]


def _by_time(ours: Array, theirs: Array) -> list[Pair]:
    nearest = [int(np.argmin(np.abs(theirs - t))) for t in ours]
    close = NEAR * max(float(np.ptp(theirs)), float(np.ptp(ours)))
    return [(i, k) for i, k in enumerate(nearest) if abs(theirs[k] - ours[i]) <= close]


def _unpaired(pairs: Sequence[Pair], ours: Array, theirs: Array) -> Iterator[str]:
    """What has no counterpart at the other side."""
    here = sorted({*range(len(ours))} - {i for i, _ in pairs})
    there = sorted({*range(len(theirs))} - {k for _, k in pairs})
    if here:
        yield f"{len(here)} states here have no record: the first is {here[0]}, t = {ours[here[0]]:g}"
    if there:
        yield f"{len(there)} records have no state here: the first is {there[0]}, t = {theirs[there[0]]:g}"


def _vector_rows(file: Spacar, found: Analysis, theirs: Theirs, pairs: Sequence[Pair]) -> Iterator[str]:
    """Differences of coordinates and of deformations."""
    if not theirs.tables:
        return
    own = vectors(file, [found.states[i] for i, _ in pairs], found.system, TABLES)
    records = [k for _, k in pairs]
    for name, (_, title) in TABLES.items():
        letter = "x" if name in OF_NODES else "e"
        common = [z for z in own.places(name) if z in theirs.places[letter]]
        if not common:
            continue
        columns = [own.places(name).index(z) for z in common]
        ours = own.tables[name][:, columns]
        other = theirs.tables[name][records][:, [theirs.places[letter][z] for z in common]]
        if name == "fxtot":
            x = own.tables["x"][:, columns]
            ours, other = (_without_norms(z, x, common) for z in (ours, other))
        where = [f"{'node' if letter == 'x' else 'element'} {n}, {i}" for n, i in common]
        yield _row(title, ours, other, where, records)


def _without_norms(forces: Array, x: Array, places: Sequence[Place]) -> Array:
    """Forces without those along Euler parameters, which do no work: SPACAR has the stress of a norm in them."""
    found = forces.copy()
    for n in {n for n, i in places if i == 4}:
        columns = [places.index((n, i)) for i in (1, 2, 3, 4)]
        q = x[:, columns]
        along = np.sum(forces[:, columns] * q, axis=1) / np.sum(q * q, axis=1)
        found[:, columns] -= along[:, None] * q
    return found


def _matrix_rows(found: Analysis, theirs: Theirs, pairs: Sequence[Pair]) -> Iterator[str]:
    """Differences of matrices; those of one state alone are compared there."""
    for name, other in theirs.matrices.items():
        if name not in found.results:
            continue
        ours = np.real(found.results[name])
        ours = ours if ours.ndim == 3 else ours[None]
        if ours.shape[1:] != other.shape[1:]:
            shapes = " by ".join(map(str, ours.shape[1:])), " by ".join(map(str, other.shape[1:]))
            yield f"{name}: {shapes[0]} here, {shapes[1]} there, not compared"
            continue
        both = [(i, k) for i, k in pairs if i < len(ours)]
        if not ours[0].size or not both:
            continue
        mine, records = ours[[i for i, _ in both]], [k for _, k in both]
        where = [
            f"row {i}, column {k}" for i in range(1, ours.shape[1] + 1) for k in range(1, ours.shape[2] + 1)
        ]
        yield _row(name, mine.reshape(len(both), -1), other[records].reshape(len(both), -1), where, records)


def _row(title: str, ours: Array, theirs: Array, where: Sequence[str], records: Sequence[int]) -> str:
    """The largest difference, the largest entry, their ratio, and where the difference is."""
    difference = np.abs(ours - theirs)
    record, column = divmod(int(np.argmax(difference)), difference.shape[1])
    largest, entry = float(difference[record, column]), float(np.max(np.abs(theirs)))
    entry = entry or float(np.max(np.abs(ours)))
    ratio = largest / entry if entry else 0.0
    place = f"{where[column]}, record {records[record]}" if largest else ""
    return f"{title:<30}{largest:>12.3e}{entry:>12.3e}{ratio:>12.1e}  {place}".rstrip()


def _without(file: Spacar, found: Analysis, theirs: Theirs) -> Iterator[str]:
    """What only one of the two has."""
    for letter, what, own in (("x", "nodes", file.coordinates), ("e", "elements", file.deformations)):
        if theirs.tables:
            yield from _missing(what, own.keys() - theirs.places[letter].keys(), "there")
            yield from _missing(what, theirs.places[letter].keys() - own.keys(), "here")
    if absent := [name for name in theirs.matrices if name not in found.results]:
        yield f"not compared, as this analysis does not give them: {', '.join(absent)}; choose another --mode"


def _missing(what: str, places: Iterable[Place], where: str) -> Iterator[str]:
    if names := ", ".join(f"{n}: {i}" for n, i in sorted(places)):
        yield f"{what} that are not {where} (number: coordinate or mode): {names}"
