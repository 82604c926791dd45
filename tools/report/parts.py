"""The parts of the report: the contents of the JSON files of the commands, and their paths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from report.json_data import read_json


@dataclass(frozen=True)
class KernelOutput:
    """One output of one kernel, with its worst relative errors; null does not apply, or is not a number."""

    element: str
    kernel: str
    output: str
    differences: float | None
    reference: float | None
    lanes: bool
    note: str
    ok: bool


@dataclass(frozen=True)
class Kernels:
    """The output of `flexel verify --json`."""

    ok: bool
    tolerances: dict[str, float]
    seconds: float
    rows: list[KernelOutput]


@dataclass(frozen=True)
class QuantityRow:
    """A quantity of a system, of complex numbers as pairs or not; the last four say how it converges."""

    name: str
    computed: Any
    reference: Any
    kind: str
    error: float | None
    tolerance: float
    tolerance_kind: str
    reason: str
    unit: str
    source: str
    ok: bool | None
    complex: bool = False
    errors: Any = None
    meshes: Any = None
    order: Any = None
    steps: Any = None


@dataclass(frozen=True)
class Case:
    """A system of `flexel reproduce --json`; without seconds if they are not kept."""

    case: str
    quantities: list[QuantityRow]
    seconds: float | None = None


@dataclass(frozen=True)
class Measured:
    """Times of a program in the unit of the row: the shortest of the largest size, and of each size."""

    value: float | None
    error: float | None
    values: list[float | None] = field(default_factory=list)
    exponent: float | None = None


@dataclass(frozen=True, kw_only=True)
class Timed(Measured):
    """A row of `flexel bench --json`: flexel's times with those of its peers (null: not installed)."""

    name: str
    unit: str
    target: float | None
    goal: float | None
    accuracy: str = ""
    within: float | None = None
    sizes: list[int] = field(default_factory=list)
    peers: dict[str, Measured | None] = field(default_factory=dict)


@dataclass(frozen=True)
class Property:
    """A property of models: the largest and the median error of all models to which it applies."""

    name: str
    models: int
    largest: float | None
    median: float | None
    tolerance: float


@dataclass(frozen=True)
class Skipped:
    """Models without a comparison, and the reason."""

    reason: str
    models: int


@dataclass(frozen=True)
class Counterexample:
    """A program that builds a model which violates a property, or with which flexel raises an error: the message."""

    program: str
    property: str
    error: float | None
    message: str = ""


@dataclass(frozen=True)
class Campaign:
    """The output of ``python -m campaign --json``."""

    campaign: str
    seed: int
    models: int
    seconds: float
    families: dict[str, int]
    properties: list[Property]
    skipped: list[Skipped]
    failures: list[Counterexample]


@dataclass(frozen=True)
class Step:
    """A command under sanitizers; null: not run, because one before it failed."""

    command: str
    ok: bool | None
    seconds: float


@dataclass(frozen=True)
class Sanitized:
    """The output of `make sanitize`: the commands, and the messages of the sanitizers."""

    sanitizers: list[str]
    steps: list[Step]
    found: list[str]


@dataclass(frozen=True)
class Made:
    """When, from which source and on which machine a file was written."""

    date: str
    commit: str
    seconds: float | None
    facts: dict[str, str]


@dataclass(frozen=True)
class Parts:
    """All contents of the page; None or empty if there is no file."""

    verify: Kernels | None = None
    reproduce: Sequence[Case] = ()
    bench: Sequence[Timed] = ()
    campaign: Campaign | None = None
    sanitize: Sanitized | None = None
    made: Mapping[str, Made] = field(default_factory=dict)


NAMES = ("verify", "reproduce", "bench", "campaign", "sanitize")
FACTS = "facts.json"


def files_in(folder: Path) -> dict[str, list[Path]]:
    """Find the files of each part in a folder: one, or several of systems that were run one by one."""
    found = {name: [folder / f"{name}.json"] for name in (*NAMES, "facts")}
    found["reproduce"] = sorted(folder.glob("reproduce*.json"))
    return {name: [file for file in files if file.exists()] for name, files in found.items()}


def command(part: str) -> str:
    """Return the command that makes a part."""
    return f"make report PARTS={part}"


def read_parts(files: Mapping[str, Sequence[Path]]) -> Parts:
    """Read the files of each part.

    Raises
    ------
    FlexelError
        A file is damaged; the message names it, the place, and the command that writes it again.
    """

    def read(kind: Any, part: str) -> list[Any]:
        return [read_json(kind, file, command(part)) for file in files.get(part, ())]

    def one(kind: Any, part: str) -> Any:
        found = read(kind, part)
        return found[0] if found else None

    cases: dict[str, Case] = {}
    for found in read(list[Case] | Case, "reproduce"):
        cases |= {case.case: case for case in (found if isinstance(found, list) else [found])}
    return Parts(
        one(Kernels, "verify"),
        list(cases.values()),
        one(list[Timed], "bench") or (),
        one(Campaign, "campaign"),
        one(Sanitized, "sanitize"),
        one(dict[str, Made], "facts") or {},
    )
