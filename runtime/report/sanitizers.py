"""The section about memory, undefined behaviour and races: what ran with the C compiled to look for them."""

from __future__ import annotations

from collections.abc import Sequence

from flexel.base.shown import counted
from flexel.report.markup import table, tag, time
from flexel.report.parts import Sanitized, Step
from flexel.report.section import Section, absent

SAYS = (
    "Commands that ran with the C compiled to watch every access to memory, operations without a meaning in C, and "
    "threads. A failure is a command that stops, or anything that a sanitizer writes."
)


def section(found: Sanitized | None) -> Section:
    """The section about what `make sanitize` wrote, or that there is nothing."""
    said = "sanitizers", "Sanitizers", SAYS
    if found is None:
        return Section(*said, missing=[absent("sanitize", "The runs with sanitizers")])
    failures = [f"{z.command}: {'not run' if z.ok is None else 'failed'}" for z in found.steps if not z.ok]
    failures += [f"a sanitizer: {_first(z)}" for z in found.found]
    if not found.steps:
        failures.append("nothing ran")
    summary = (
        f"{', '.join(found.sanitizers)}: {counted(len(found.steps), 'command')}, "
        f"{counted(len(found.found), 'finding')}; {time(sum(z.seconds for z in found.steps))}."
    )
    written = [tag("pre", z) for z in found.found]
    return Section(
        *said, summary, [*written, table(("command", "time", ""), map(_line, found.steps))], failures
    )


def _first(report: str) -> str:
    """The line of a report that names what was found."""
    lines = [z.strip() for z in report.splitlines() if z.strip(" =")]
    return next(
        (z for z in lines if "ERROR" in z or "error" in z or "WARNING" in z), lines[0] if lines else "empty"
    )


def _line(step: Step) -> tuple[str, Sequence[object]]:
    verdict = "ok" if step.ok else "NOT RUN" if step.ok is None else "FAILED"
    return "" if step.ok else "bad", (tag("code", step.command), time(step.seconds), verdict)
