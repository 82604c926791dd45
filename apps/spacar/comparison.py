"""Compares results of a run with SPACAR's, from its .sbd, .sbm and .ltv files: the largest differences, and where."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from flexel.apps.spacar.analysis_modes import Analysis
from flexel.apps.spacar.reading import Spacar
from flexel.apps.spacar.vectors import OF_NODES, Place, vectors
from flexel.base.arguments import path_of
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.shown import prints
from flexel.results.saved.loading import SPACAR
from flexel.results.saved.spacar_entries import read_entries
from flexel.results.saved.spacar_motion import NORM

# Flexel's tables, SPACAR's tags, and their names.
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
Pair = tuple[int, int]  # numbers of corresponding states here and records there
# Difference of two times, relative to the length of the motion, up to which they count as equal.
TIME_TOLERANCE = 1e-9


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


@dataclass(frozen=True)
class Difference:
    """The largest difference of a table or matrix from SPACAR's.

    Attributes
    ----------
    title : str
    largest, entry : float
        The difference, and the largest entry in SPACAR's results (ours, if all of these are zero).
    place : str
        Where it is; empty if there is none.
    """

    title: str
    largest: float
    entry: float
    place: str

    @property
    def ratio(self) -> float:
        """The difference relative to the largest entry."""
        return self.largest / self.entry if self.entry else 0.0

    @prints
    def __str__(self) -> str:
        return f"{self.title:<30}{self.largest:>12.3e}{self.entry:>12.3e}{self.ratio:>12.1e}  {self.place}".rstrip()


@dataclass(frozen=True)
class Comparison:
    """The comparison of an analysis with a file of SPACAR's results.

    Attributes
    ----------
    records : int
        Number of states that have a record.
    differences : tuple of Difference
    remarks : tuple of str
        What is not compared, and why.
    """

    records: int
    differences: tuple[Difference, ...]
    remarks: tuple[str, ...]

    @property
    def worst(self) -> Difference | None:
        """The largest of the differences, by their ratios."""
        return max(self.differences, key=lambda row: row.ratio, default=None)


def results_of_spacar(path: str | Path) -> Theirs:
    """Read SPACAR's results in a file.

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
    SPACAR[path.suffix.lower()](entries, path)  # which raises for a damaged file
    time = entries.records["T"][:, 0, 0]
    if path.suffix.lower() != ".sbd":
        known = {tag: record for tag, record in entries.records.items() if tag in MATRICES}
        return Theirs(path, time, {}, {}, known)
    tables = {name: entries.records[tag][:, :, 0] for name, (tag, _) in TABLES.items()}
    norms = {e for e, kind in enumerate(np.ravel(entries.constant["IT"]), 1) if kind == NORM}
    places = {
        "x": _places(entries.constant["LNP"]),
        "e": {
            quantity: i for quantity, i in _places(entries.constant["LE"]).items() if quantity[0] not in norms
        },
    }
    return Theirs(path, time, tables, places, {})


def _places(table: Array) -> dict[Place, int]:
    """Return the columns, from 0, of a table of indices from 1."""
    return {
        (n, i): int(entry) - 1
        for n, row in enumerate(table, 1)
        for i, entry in enumerate(row, 1)
        if entry > 0
    }


def comparison_lines(file: Spacar, found: Analysis, theirs: Theirs) -> list[str]:
    """Report the differences of an analysis from SPACAR's results, and data without a counterpart."""
    both = comparison(file, found, theirs)
    head = f"compared with {theirs.path.name}, {len(theirs.time)} records"
    title = [f"  {'':<30}{'difference':>12}{'of':>12}{'ratio':>12}  where"] if both.records else []
    return [head, *title, *(f"  {line}" for line in (*both.differences, *both.remarks))]


def comparison(file: Spacar, found: Analysis, theirs: Theirs) -> Comparison:
    """Compare an analysis with SPACAR's results."""
    if not found.states:
        return Comparison(0, (), ("this analysis has no states to compare; choose another --mode",))
    ours = np.array([state.t for state in found.states])
    steps = (
        found.system is not None or ours.size == theirs.time.size == 1
    )  # load steps have no times in SPACAR
    pairs = (_by_number if steps else _by_time)(ours, theirs.time)
    unpaired = tuple(_unpaired(pairs, ours, theirs.time))
    if not pairs:
        return Comparison(0, (), unpaired)
    rows = [*_vector_rows(file, found, theirs, pairs), *_matrix_rows(found, theirs, pairs)]
    differences = tuple(row for row in rows if isinstance(row, Difference))
    others = tuple(row for row in rows if isinstance(row, str))
    return Comparison(len(pairs), differences, (*others, *unpaired, *_without(file, found, theirs)))


def _by_number(ours: Array, theirs: Array) -> list[Pair]:
    return [(i, i) for i in range(min(len(ours), len(theirs)))]


def _by_time(ours: Array, theirs: Array) -> list[Pair]:
    nearest = [int(np.argmin(np.abs(theirs - t))) for t in ours]
    close = TIME_TOLERANCE * max(float(np.ptp(theirs)), float(np.ptp(ours)))
    return [(i, k) for i, k in enumerate(nearest) if abs(theirs[k] - ours[i]) <= close]


def _unpaired(pairs: Sequence[Pair], ours: Array, theirs: Array) -> Iterator[str]:
    """Report states and records without a counterpart."""
    here = sorted({*range(len(ours))} - {i for i, _ in pairs})
    there = sorted({*range(len(theirs))} - {k for _, k in pairs})
    if here:
        yield f"{len(here)} states here have no record: the first is {here[0]}, t = {ours[here[0]]:g}"
    if there:
        yield f"{len(there)} records have no state here: the first is {there[0]}, t = {theirs[there[0]]:g}"


def _vector_rows(
    file: Spacar, found: Analysis, theirs: Theirs, pairs: Sequence[Pair]
) -> Iterator[Difference]:
    """Report differences of coordinates and of deformations."""
    if not theirs.tables:
        return
    own = vectors(file, [found.states[i] for i, _ in pairs], found.system, TABLES)
    records = [k for _, k in pairs]
    for name, (_, title) in TABLES.items():
        letter = "x" if name in OF_NODES else "e"
        common = [quantity for quantity in own.places(name) if quantity in theirs.places[letter]]
        if not common:
            continue
        columns = [own.places(name).index(quantity) for quantity in common]
        ours = own.tables[name][:, columns]
        other = theirs.tables[name][records][:, [theirs.places[letter][quantity] for quantity in common]]
        if name == "fxtot":
            x = own.tables["x"][:, columns]
            ours, other = (_without_norms(values, x, common) for values in (ours, other))
        where = [f"{'node' if letter == 'x' else 'element'} {n}, {i}" for n, i in common]
        yield _row(title, ours, other, where, records)


def _without_norms(forces: Array, x: Array, places: Sequence[Place]) -> Array:
    """Remove the forces along Euler parameters, which do no work: SPACAR includes the stress of a norm in them."""
    found = forces.copy()
    for n in {n for n, i in places if i == 4}:
        columns = [places.index((n, i)) for i in (1, 2, 3, 4)]
        q = x[:, columns]
        along = np.sum(forces[:, columns] * q, axis=1) / np.sum(q * q, axis=1)
        found[:, columns] -= along[:, None] * q
    return found


def _matrix_rows(found: Analysis, theirs: Theirs, pairs: Sequence[Pair]) -> Iterator[Difference | str]:
    """Report differences of matrices; those of one state alone are compared with that record."""
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


def _row(title: str, ours: Array, theirs: Array, where: Sequence[str], records: Sequence[int]) -> Difference:
    """Return the largest difference, the largest entry, and the position of the difference."""
    difference = np.abs(ours - theirs)
    record, column = divmod(int(np.argmax(difference)), difference.shape[1])
    largest, entry = float(difference[record, column]), float(np.max(np.abs(theirs)))
    entry = entry or float(np.max(np.abs(ours)))
    place = f"{where[column]}, record {records[record]}" if largest else ""
    return Difference(title, largest, entry, place)


def _without(file: Spacar, found: Analysis, theirs: Theirs) -> Iterator[str]:
    """Report quantities that only one of the two has."""
    for letter, what, own in (("x", "nodes", file.coordinates), ("e", "elements", file.deformations)):
        if theirs.tables:
            yield from _missing(what, own.keys() - theirs.places[letter].keys(), "there")
            yield from _missing(what, theirs.places[letter].keys() - own.keys(), "here")
    if absent := [name for name in theirs.matrices if name not in found.results]:
        yield f"not compared, as this analysis does not give them: {', '.join(absent)}; choose another --mode"


def _missing(what: str, places: Iterable[Place], where: str) -> Iterator[str]:
    if names := ", ".join(f"{n}: {i}" for n, i in sorted(places)):
        yield f"{what} that are not {where} (number: coordinate or mode): {names}"
