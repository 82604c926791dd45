"""The text of every file in ``generated/``, and writing and checking that folder.

The same elements give the same bytes on every machine and for every hash seed. Nothing here
imports ``flexel.generated``, so that it works when the compiled kernels are missing.
"""

import json
import os
import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_all_start_methods, get_context
from pathlib import Path

from flexel.derive.declare import Element, Law
from flexel.derive.definition_errors import ElementError
from flexel.derive.elements import ELEMENTS
from flexel.derive.emit.entries import table_entry
from flexel.derive.emit.source import digest_of, element_source, laws_source, render
from flexel.derive.emit.specification import element_spec, law_spec
from flexel.derive.laws import LAWS
from flexel.derive.program.kernel_outputs import Derived, derive_element, derive_law
from flexel.derive.shared_object import FLAGS

PACKAGE = ("__init__.py", "build.py")  # what makes `flexel.generated` of the files
BASELINE = Path(__file__).with_name("operations.json")
MIN_FORKED = 8  # files from which processes are worth their start
_forked: Sequence[Element | Sequence[Law]] = ()  # what forked processes derive
_ENTRY = re.compile(r"^    # (element|law) (\w+)\n(.*?)\n(?=    # )", re.MULTILINE | re.DOTALL)

Counts = dict[str, dict[str, int]]


@dataclass(frozen=True)
class Emitted:
    """Files of ``generated/`` (name to text) and the operation counts of what was derived for them."""

    files: dict[str, str]
    operations: Counts


@dataclass(frozen=True)
class _File:
    """One C file: its text, entries of the table, and operation counts by name of the element or law."""

    text: str
    entries: dict[str, str]
    operations: Counts


def _silent(name: str) -> None:
    """Show no progress."""


def _entries_in(folder: Path | None) -> dict[str, dict[str, str]]:
    """Return the entries of an existing table by name, of elements and of laws."""
    found: dict[str, dict[str, str]] = {"element": {}, "law": {}}
    path = folder / "table.py" if folder else None
    if path is not None and path.exists():
        for kind, name, entry in _ENTRY.findall(path.read_text(encoding="utf-8")):
            found[kind][name] = entry
    return found


def _counts(derived: Derived) -> dict[str, int]:
    return {name: kernel.operations for name, kernel in derived.kernels.items()}


def emit(
    elements: Sequence[Element] = ELEMENTS,
    laws: Sequence[Law] = LAWS,
    only: Collection[str] = (),
    folder: Path | None = None,
    progress: Callable[[str], None] = _silent,
) -> Emitted:
    """Derive elements and laws and print them.

    Parameters
    ----------
    elements, laws : sequence
        All elements and laws.
    only : collection of str
        Names of elements and laws to derive; all by default. The entries of the others are taken from the table in
        `folder`; those that are not there are derived as well. All laws are in one file and are derived together.
    folder : Path, optional
    progress : callable
        Called with each name when it has been derived; with "laws" for all of them.
    """
    kept = _entries_in(folder if only else None)
    names = [law.name for law in laws]
    jobs: dict[str, Element | Sequence[Law]] = {
        element.name: element
        for element in elements
        if element.name not in kept["element"] or element.name in only
    }
    if list(kept["law"]) != names or not set(only).isdisjoint(names):
        jobs["laws"] = laws
    files: dict[str, str] = {}
    counts: Counts = {}
    made: dict[str, str] = {}
    for name, file in zip(jobs, _derived(list(jobs.values())), strict=True):
        progress(name)
        files[f"{name}.c"] = file.text
        made.update(file.entries)
        counts.update(file.operations)
    entries = {element.name: made.get(element.name) or kept["element"][element.name] for element in elements}
    law_entries = {name: made.get(name) or kept["law"][name] for name in names}
    return Emitted({**files, **_common(entries, law_entries)}, counts)


def _derived(jobs: Sequence[Element | Sequence[Law]]) -> Iterator[_File]:
    """Derive elements and sets of laws, several at a time in forked processes, which need no copies of definitions."""
    if len(jobs) < MIN_FORKED or "fork" not in get_all_start_methods():
        yield from map(_file, jobs)
        return
    global _forked
    _forked = jobs
    with ProcessPoolExecutor(os.cpu_count(), get_context("fork")) as pool:
        yield from pool.map(_forked_file, range(len(jobs)))


def _forked_file(i: int) -> _File:
    return _file(_forked[i])


def _file(job: Element | Sequence[Law]) -> _File:
    """Derive an element, or all laws, and print the C file."""
    if isinstance(job, Element):
        derived = derive_element(job)
        source = element_source(job, derived)
        entry = table_entry(element_spec(job, derived, digest_of(source)))
        return _File(source, {job.name: entry}, {job.name: _counts(derived)})
    all_derived = [derive_law(law) for law in job]
    source = laws_source(job, all_derived)
    pairs = list(zip(job, all_derived, strict=True))
    entries = {law.name: table_entry(law_spec(law, d, digest_of(source))) for law, d in pairs}
    return _File(source, entries, {law.name: _counts(d) for law, d in pairs})


def emit_page(elements: Sequence[Element], laws: Sequence[Law]) -> Emitted:
    """Derive elements and laws of a user and print them: their C, the headers, and the table of their arrays.

    Raises
    ------
    ElementError
        An element with the name of the file of the laws.
    """
    for element in elements:
        if laws and element.name == "laws":
            raise ElementError("element 'laws': the laws are written to laws.c; choose another name")
    emitted = emit(elements, laws)
    files = {name: text for name, text in emitted.files.items() if name not in PACKAGE}
    return Emitted(files, emitted.operations)


def _common(elements: dict[str, str], laws: dict[str, str]) -> dict[str, str]:
    """Return the files that do not belong to one element."""
    flags = "[" + ", ".join(f'"{flag}"' for flag in FLAGS) + "]"
    return {
        "__init__.py": render("init.py.jinja"),
        "build.py": render("build.py.jinja", flags=flags),
        "catalogue.h": render("catalogue.h.jinja", elements=elements, laws=laws),
        "kernels.h": render("kernels.h.jinja"),
        "table.py": render("table.py.jinja", elements=elements, laws=laws),
    }


def stale(folder: Path) -> list[str]:
    """List files in the folder that a complete derivation would not write; compiled ones are ignored."""
    known = {f"{element.name}.c" for element in ELEMENTS} | {"laws.c", *_common({}, {})}
    return sorted(
        path.name
        for path in folder.glob("*")
        if path.suffix in (".c", ".h", ".py") and path.name not in known
    )


def write_files(folder: Path, files: Mapping[str, str]) -> list[str]:
    """Write the files that differ, and return their names."""
    folder.mkdir(parents=True, exist_ok=True)
    changed = differing(folder, files)
    for name in changed:
        (folder / name).write_text(files[name], encoding="utf-8")
    return changed


def write(folder: Path, emitted: Emitted | None = None) -> list[str]:
    """Write the files that differ, remove stale ones; returns the names of both."""
    changed = write_files(folder, (emitted or emit()).files)
    removed = stale(folder)
    for name in removed:
        (folder / name).unlink()
    return sorted(changed + removed)


def check(folder: Path, emitted: Emitted | None = None) -> list[str]:
    """List files that differ from the derivation, are missing or are stale."""
    return sorted(differing(folder, (emitted or emit()).files) + stale(folder))


def differing(folder: Path, files: Mapping[str, str]) -> list[str]:
    """Return the names of the files that a folder does not have, or has with another text."""

    def same(name: str) -> bool:
        path = folder / name
        return path.exists() and path.read_bytes() == files[name].encode()

    return [name for name in files if not same(name)]


# -- the baseline of operation counts


def baseline() -> Counts:
    """Return the committed operation counts."""
    counts: Counts = json.loads(BASELINE.read_text(encoding="utf-8")) if BASELINE.exists() else {}
    return counts


def risen(counts: Counts, reference: Counts) -> list[str]:
    """List kernels that take more operations than in the baseline, or are not in it: one line of text for each."""
    return [
        f"{name}.{kernel}: {count} operations, baseline {reference.get(name, {}).get(kernel, 'missing')}"
        for name, kernels in counts.items()
        for kernel, count in kernels.items()
        if count > reference.get(name, {}).get(kernel, -1)
    ]


def update_baseline(counts: Counts) -> None:
    """Rewrite the baseline; names that were not derived keep theirs."""
    names = [element.name for element in ELEMENTS] + [law.name for law in LAWS]
    merged = {**baseline(), **counts}
    text = json.dumps({name: merged[name] for name in names if name in merged}, indent=2)
    BASELINE.write_text(text + "\n", encoding="utf-8")
