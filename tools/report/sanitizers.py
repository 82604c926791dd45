"""Writes the section about memory, undefined behaviour and races: runs of the C code compiled with sanitizers."""

from __future__ import annotations

from collections.abc import Sequence

from flexel.base.shown import counted
from report.markup import table, tag, time
from report.parts import Sanitized, Step
from report.section import PageSection, absent

SAYS = (
    "Commands that ran with the C compiled to watch every access to memory, operations without a meaning in C, and "
    "threads. A failure is a command that stops, or anything that a sanitizer writes."
)


def section(found: Sanitized | None) -> PageSection:
    """Write the section about the results of `make sanitize`, or state that there are none."""
    said = "sanitizers", "Sanitizers", SAYS
    if found is None:
        return PageSection(*said, missing=[absent("sanitize", "The runs with sanitizers")])
    failures = [
        f"{step.command}: {'not run' if step.ok is None else 'failed'}" for step in found.steps if not step.ok
    ]
    failures += [f"a sanitizer: {_first(message)}" for message in found.found]
    if not found.steps:
        failures.append("nothing ran")
    summary = (
        f"{', '.join(found.sanitizers)}: {counted(len(found.steps), 'command')}, "
        f"{counted(len(found.found), 'finding')}; {time(sum(step.seconds for step in found.steps))}."
    )
    written = [tag("pre", message) for message in found.found]
    return PageSection(
        *said, summary, [*written, table(("command", "time", ""), map(_line, found.steps))], failures
    )


def _first(report: str) -> str:
    """Return the line of a sanitizer report that names the finding."""
    lines = [line.strip() for line in report.splitlines() if line.strip(" =")]
    return next(
        (line for line in lines if "ERROR" in line or "error" in line or "WARNING" in line),
        lines[0] if lines else "empty",
    )


def _line(step: Step) -> tuple[str, Sequence[object]]:
    verdict = "ok" if step.ok else "NOT RUN" if step.ok is None else "FAILED"
    return "" if step.ok else "bad", (tag("code", step.command), time(step.seconds), verdict)
