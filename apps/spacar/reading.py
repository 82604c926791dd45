"""Reads a SPACAR input file as a model with its analysis parameters: `read_spacar`."""

from __future__ import annotations

from pathlib import Path

from flexel.apps.spacar.declarations import checked_model
from flexel.apps.spacar.file import DEFAULT_STEPS
from flexel.apps.spacar.file_entries import quantity
from flexel.apps.spacar.keywords import KEYWORDS, ROUTINES, WARPING
from flexel.apps.spacar.lexer import Line, read_lines
from flexel.apps.spacar.linear_analyses import LinearModels
from flexel.apps.spacar.picture import Picture
from flexel.apps.spacar.problems import Notes, Problems
from flexel.apps.spacar.semantics import understand
from flexel.apps.spacar.sheet import Sheet
from flexel.apps.spacar.warping_beams import warped_stresses
from flexel.apps.spacar.weights import unloaded_stresses
from flexel.base.arguments import path_of
from flexel.base.errors import ModelError

FORM = KEYWORDS["ITERSTEP"].form
MAX_STEPS = 1_000_000  # of stored states


class Spacar(LinearModels):
    """A SPACAR input file that was read, with its analyses; its attributes are those of `SpacarFile`."""


def read_spacar(path: str | Path, dialect: str | None = None, *, warping: str = WARPING[0]) -> Spacar:
    """Read a SPACAR input file (.dat) of the Delft or the Twente dialect.

    Parameters
    ----------
    path : str or Path
    dialect : "delft" or "twente", optional
        Recognized by the keywords if not given; the dialects differ in the order of TIMESTEP.
    warping : "spacar" or "vlasov", optional
        How to read a BEAMW: as SPACAR's element, with Jw lumped at its nodes and no shortening by twist, or
        as flexel's own, with Jw distributed over the length and with the shortening.

    Raises
    ------
    ModelError
        All that is unknown, unsupported or contradictory, in one error that names file, line, keyword and remedy.

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
    if not isinstance(warping, str) or warping not in WARPING:
        raise ModelError(
            f"read_spacar: warping {warping!r} is unknown; give {' or '.join(map(repr, WARPING))}"
        )
    problems, notes = Problems(), Notes()
    dialect, lines, picture = read_lines(path, dialect, problems)
    if problems.cut:
        problems.report()
    sheet = Sheet(lines, dialect, problems, notes, vlasov=warping == "vlasov")
    draft = understand(sheet)
    draft.parts += Picture(picture, sheet).looks
    increments, steps, duration = _increments(sheet), *_time_steps(sheet)
    model = checked_model(draft.gravity, draft.parts, problems)
    if draft.steps:
        checked_model(draft.gravity, [*draft.parts, *draft.still, *draft.steps], problems)
    problems.report()
    if not sheet.elements:
        raise ModelError(f"{path.name}: it has no elements; give a SPACAR input file")
    hmax = sheet.of("HMAX")
    time = sheet.of("TIME")
    elements = [sheet.elements[n] for n in sorted(sheet.elements)]
    modes = {
        (e.number, i): quantity(e, i)
        for e in elements
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
        model=model,
        start=time[0].values[0] if time else 0.0,
        duration=duration,
        steps=steps,
        increments=increments,
        max_step=hmax[0].values[0] if hmax else None,
        coordinates=coordinates,
        deformations=modes,
        inputs=tuple(draft.inputs),
        outputs=tuple(draft.outputs),
        notes=tuple(notes),
        linearized=bool(sheet.of("LINE") or draft.inputs or draft.outputs),
        still=tuple(made.part for made in draft.still),
        load_steps=tuple(made.part for made in draft.steps),
        routines={line.keyword: " ".join(line.words) for line in sheet.of(*ROUTINES)},
        warped=dict(term for e in elements if e.line.keyword == "BEAMW" for term in warped_stresses(e)),
        scales=draft.scales,
        rigid_weights=unloaded_stresses(elements, draft.gravity) if dialect == "twente" else {},
    )


def _increments(sheet: Sheet) -> int:
    """Return the number of load steps, the second number of ITERSTEP."""
    found = sheet.problems.each(lambda line: _count(line, 1, f"write ITERSTEP {FORM}"), sheet.of("ITERSTEP"))
    return found[0] if found else DEFAULT_STEPS


def _time_steps(sheet: Sheet) -> tuple[int, float | None]:
    """Return the number of steps and the duration; TIMESTEP has them in two orders."""

    def read(line: Line) -> tuple[int, float]:
        delft = sheet.dialect == "delft"
        wanted = "n T" if delft else "T n"
        order = f"the {sheet.dialect} dialect writes {wanted} (give dialect= if the file is of the other one)"
        steps, duration = _count(line, 0 if delft else 1, order), line.values[1 if delft else 0]
        if duration <= 0:
            raise line.error(f"the time {duration:g} is not positive; correct it")
        return steps, duration

    found: list[tuple[int, float | None]] = [*sheet.problems.each(read, sheet.of("TIMESTEP"))]
    return found[0] if found else (DEFAULT_STEPS, None)


def _count(line: Line, place: int, remedy: str) -> int:
    """Return a number of steps."""
    value = line.values[place]
    if value != round(value) or value < 1:
        raise line.error(f"{line.words[place]} is not a number of steps; {remedy}")
    if value > MAX_STEPS:
        raise line.error(
            f"{line.words[place]} steps are more than the {MAX_STEPS} that can be kept; give fewer"
        )
    return int(value)
