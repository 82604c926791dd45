"""A SPACAR input file as a model with its analysis parameters: `read_spacar`.

Imports numpy, the model and the rooms of this package that understand the language.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from flexel.errors import ConstraintError, ModelError
from flexel.model import Model
from flexel.spacar import linear
from flexel.spacar.lexer import Line, read_lines
from flexel.spacar.semantics import understand
from flexel.spacar.sheet import Sheet, quantity
from flexel.spacar.statements import Call, build_model
from flexel.spacar.terminals import Terminal
from flexel.state import State
from flexel.system import System

STEPS = 100  # of a file without TIMESTEP or ITERSTEP


@dataclass(frozen=True)
class Spacar:
    """A SPACAR input file, understood.

    Attributes
    ----------
    path : Path
    dialect : str
        "delft" or "twente".
    model : Model
        The model of the file; positions are called p1, p2 ..., orientations o1, o2 ..., elements by keyword and
        number: hinge1, plbeam2.
    start, duration : float
        Of the motion [s]; no duration if the file has no TIMESTEP.
    steps : int
        Number of its stored steps, and of load steps.
    max_step : float or None
        HMAX [s].
    coordinates : mapping of (node, i) to name
        SPACAR's coordinates x of all nodes.
    deformations : mapping of (element, i) to (name, factor)
        SPACAR's deformations and slips; factor is theirs divided by ours (signs differ, see the tables).
    inputs, outputs : tuple of Terminal
        Of the linear model, in the order of their numbers.
    linearized : bool
        Whether the file asks for linearized equations: by LINE, or by inputs and outputs.
    notes : tuple of str
        What was read without effect, and what was assumed where the descriptions of the language leave it open.
    """

    path: Path
    dialect: str
    model: Model = field(repr=False)
    start: float
    duration: float | None
    steps: int
    max_step: float | None
    coordinates: Mapping[tuple[int, int], str] = field(repr=False)
    deformations: Mapping[tuple[int, int], tuple[str, float]] = field(repr=False)
    inputs: tuple[Terminal, ...]
    outputs: tuple[Terminal, ...]
    notes: tuple[str, ...]
    linearized: bool
    gravity: tuple[float, ...] = field(repr=False)
    calls: tuple[Call, ...] = field(repr=False)
    still: tuple[Call, ...] = field(repr=False)
    load_steps: tuple[Call, ...] = field(repr=False)

    @cached_property
    def system(self) -> System:
        """The built system.

        Raises
        ------
        ConstraintError
            Freedoms that the file does not give a coordinate, or conditions that repeat one another.
        """
        return self._built(self.model, self.start)

    def _built(self, model: Model, start: float) -> System:
        try:
            return model.build(start)
        except ConstraintError as error:
            raise ConstraintError(
                f"{self.path.name}: {error} (in the file: a freedom is named by DYNE or DYNX, a kinematic one by ENHC "
                "or KINE, a given motion is INPUTE or INPUTX, RLSE releases and FIX holds)"
            ) from error
        except ModelError as error:
            raise ModelError(f"{self.path.name}: {error}") from error

    def deformation(self, state: State, element: int, i: int) -> float:
        """Deformation i of an element in SPACAR's sign; of a slip, its rate.

        Raises
        ------
        ModelError
            No such element or deformation.
        """
        name, factor = self._mode(element, i)
        if name in self.slips:
            return factor * state.rate(name)
        return factor * state[name]

    def stress(self, state: State, element: int, i: int) -> float:
        """Generalized stress dual to `deformation`, in SPACAR's sign."""
        name, factor = self._mode(element, i)
        return state.force(name) / factor

    def _mode(self, element: int, i: int) -> tuple[str, float]:
        if (element, i) not in self.deformations:
            raise ModelError(
                f"{self.path.name}: there is no deformation {i} of an element {element}; elements are "
                f"{', '.join(map(str, sorted({e for e, _ in self.deformations})))}"
            )
        return self.deformations[element, i]

    @cached_property
    def slips(self) -> frozenset[str]:
        """Names of all slips, which have rates and no values."""
        return frozenset(z for instance in self.model.instances.values() for z in instance.slips)

    def factor(self, name: str) -> float:
        """How much larger a quantity is in SPACAR than here; 1 for coordinates."""
        return self._factors.get(name, 1.0)

    @cached_property
    def _factors(self) -> dict[str, float]:
        return dict(self.deformations.values())

    def variant(self, *, load_steps: bool = False, loads: bool = True) -> System:
        """The system moved by the increments DELXF, DELINPX and DELINPE (times t) alone, or without its loads."""
        steps = (*self.still, *self.load_steps) if load_steps else ()
        model = build_model(self.gravity, [*self.calls, *steps])
        if not loads:
            model.loads.clear()
        return self._built(model, 0.0 if load_steps else self.start)

    matrices = linear.matrices
    state_space = linear.state_space
    frequencies = linear.frequencies
    buckling = linear.buckling
    static_steps = linear.static_steps


def read_spacar(path: str | Path, dialect: str | None = None) -> Spacar:
    """Read a SPACAR input file (.dat) of the Delft or the Twente dialect.

    Parameters
    ----------
    path : str or Path
    dialect : "delft" or "twente", optional
        Recognized by the keywords if not given; the dialects differ in the order of TIMESTEP.

    Raises
    ------
    ModelError
        Anything that is unknown, not supported or contradictory: names file, line, keyword and remedy.

    Notes
    -----
    The file is data: nothing of it is executed.  Source of the language: manual SPACAR95 (Schwab and Meijaard 2000).

    Examples
    --------
    >>> file = fx.read_spacar("slider_crank.dat")  # doctest: +SKIP
    >>> motion = file.system.simulate(file.duration)  # doctest: +SKIP
    >>> file.deformation(motion[-1], 2, 2)  # doctest: +SKIP
    """
    path = Path(path)
    dialect, lines = read_lines(path, dialect)
    sheet = Sheet(lines)
    if not sheet.elements:
        raise ModelError(f"{path.name}: it has no elements; give a SPACAR input file")
    draft = understand(sheet, dialect)
    steps, duration = _time_steps(sheet, dialect)
    hmax = sheet.of("HMAX")
    time = sheet.of("TIME")
    modes = {
        (e.number, i): quantity(e, i)
        for e in sheet.elements.values()
        if e.line.keyword != "L2MIN1"
        for i in range(1, len(e.kind.modes) + 1)
    }
    coordinates = {
        (n.number, i): f"{n.name}.{c}"
        for _, n in sorted(sheet.nodes.items())
        for i, c in enumerate(n.components, 1)
    }
    return Spacar(
        path=path,
        dialect=dialect,
        model=build_model(draft.gravity, draft.calls),
        start=time[0].values[0] if time else 0.0,
        duration=duration,
        steps=steps,
        max_step=hmax[0].values[0] if hmax else None,
        coordinates=coordinates,
        deformations=modes,
        inputs=tuple(draft.inputs),
        outputs=tuple(draft.outputs),
        notes=tuple(draft.notes),
        linearized=bool(sheet.of("LINE") or draft.inputs or draft.outputs),
        gravity=draft.gravity,
        calls=tuple(draft.calls),
        still=tuple(draft.still),
        load_steps=tuple(draft.steps),
    )


def _time_steps(sheet: Sheet, dialect: str) -> tuple[int, float | None]:
    """Number of steps and duration; TIMESTEP has them in two orders."""
    steps, duration = STEPS, None
    for line in sheet.of("ITERSTEP"):
        steps = line.whole(0, "number of steps")
    for line in sheet.of("TIMESTEP"):
        steps = _count(line, 0 if dialect == "delft" else 1, dialect)
        duration = line.values[1 if dialect == "delft" else 0]
        if duration <= 0:
            raise line.error(f"the time {duration:g} is not positive; correct it")
    return steps, duration


def _count(line: Line, place: int, dialect: str) -> int:
    value = line.values[place]
    if value != round(value) or value < 1:
        order = "n T" if dialect == "delft" else "T n"
        raise line.error(
            f"{line.words[place]} is no number of steps; the {dialect} dialect writes {order} (give dialect= if this "
            "file is of the other one)"
        )
    return int(value)
