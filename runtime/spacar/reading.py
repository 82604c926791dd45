"""A SPACAR input file as a model with its analysis parameters: `read_spacar`."""

from __future__ import annotations

from pathlib import Path

from flexel.base.arguments import path_of
from flexel.base.errors import ModelError
from flexel.spacar.lexer import Line, read_lines
from flexel.spacar.linear import LinearModels
from flexel.spacar.semantics import understand
from flexel.spacar.sheet import Sheet, quantity
from flexel.spacar.statements import build_model

STEPS = 100  # of a file without TIMESTEP or ITERSTEP


class Spacar(LinearModels):
    """A SPACAR input file that was read, with its analyses; its attributes are those of `SpacarFile`."""


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
    The file is data: nothing in it is executed.  Source of the language: manual SPACAR95 (Schwab and Meijaard 2000).

    Examples
    --------
    >>> file = fx.read_spacar("slider_crank.dat")  # doctest: +SKIP
    >>> motion = file.system.simulate(file.duration)  # doctest: +SKIP
    >>> file.deformation(motion[-1], 2, 2)  # doctest: +SKIP
    """
    path = path_of(path, "read_spacar")
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
            f"{line.words[place]} is not a number of steps; the {dialect} dialect writes {order} (give dialect= if the "
            "file is of the other one)"
        )
    return int(value)
