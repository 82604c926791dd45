"""Writes the whole page: failures and missing parts at the top, the sections, and how to make it again."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from pathlib import Path
from string import Template

from flexel.base.files import replacing
from flexel.base.shown import counted
from report import campaign, convergence_errors, kernel_errors, sanitizers, speed, systems
from report.markup import Html, join, sentence, table, tag, time
from report.parts import NAMES, Made, Parts, command
from report.plots import Plots, limits
from report.section import PageSection, listed

PAGE = Template("""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>$title</title>
<style>
$style
</style>
</head>
<body>
<main>
$body
</main>
</body>
</html>
""")
AGAIN = (
    "In a checkout, `make report` makes all of it and writes out/report.html; `make report PARTS=` writes the page "
    "from the files that there are in out/report."
)
SAID = {"good": "No failure", "part": "No failure in what was run; parts are missing", "": "Nothing was run"}


def sections(parts: Parts, kernel_names: Sequence[str], system_names: Sequence[str]) -> list[PageSection]:
    """Write the sections of the page.

    Parameters
    ----------
    parts : Parts
        The contents of the files.
    kernel_names, system_names : sequence of str
        The expected elements and laws, and systems.
    """
    plots = Plots()
    found = systems.section(parts.reproduce, system_names)
    return [
        kernel_errors.section(parts.verify, kernel_names),
        _with_limits(found, parts, plots),
        convergence_errors.section(parts.reproduce, plots),
        campaign.section(parts.campaign),
        sanitizers.section(parts.sanitize),
        speed.section(parts.bench, plots),
    ]


def _with_limits(found: PageSection, parts: Parts, plots: Plots) -> PageSection:
    """Write the section about systems with a plot of all errors relative to their tolerances."""
    rows: dict[str, list[tuple[float, float]]] = {}
    for row in (row for case in parts.reproduce for row in case.quantities):
        if row.error is not None:
            rows.setdefault(row.kind, []).append((row.tolerance, row.error))
    if not rows:
        return found
    kinds = {kind: rows[kind] for kind in sorted(rows, key=lambda kind: -len(rows[kind]))}
    caption = f"Error over tolerance of every row with a reference; errors below 1e-17 are drawn there. {_share(rows)}"
    drawn: Html = tag("p", plots.remedy, class_="missing")
    if plots.possible:
        drawn = tag("figure", plots.draw(limits, kinds), tag("figcaption", caption), class_="wide")
    return PageSection(
        found.key, found.title, found.says, found.found, [drawn, *found.body], found.failures, found.missing
    )


def _share(rows: Mapping[str, Sequence[tuple[float, float]]]) -> str:
    """Write the largest error of each kind as a share of its tolerance."""
    largest = {kind: max((b / a for a, b in pairs if a > 0), default=None) for kind, pairs in rows.items()}
    said = ", ".join(f"{kind} {value:.2f}" for kind, value in largest.items() if value is not None)
    return f"Largest error as a share of the tolerance: {said}." if said else ""


def page(
    found: Sequence[PageSection], version: str, written: str, made: Mapping[str, Made], notes: str = ""
) -> str:
    """Write the page as HTML, which refers to nothing outside itself.

    Parameters
    ----------
    found : sequence of PageSection
    version : str
        Of flexel, with the commit if there is one.
    written : str
        Date and time.
    made : mapping of str to Made
        When and where each part was made.
    notes : str, optional
        A sentence about the origin of the files.
    """
    body = [
        tag(
            "header",
            tag("h1", "flexel report"),
            sentence(f"flexel {version}, page written {written}. {notes}"),
        ),
        _verdict(found),
        tag("nav", *(tag("a", section.title, href=f"#{section.key}") for section in found)),
        _made(made),
        *(section.html() for section in found),
        tag("section", tag("h2", "To make this page again"), sentence(AGAIN), _commands(), id="again"),
    ]
    style = Path(__file__).with_name("page.css").read_text(encoding="utf-8")
    return PAGE.substitute(title=html.escape(f"flexel {version}: report"), style=style, body=join(body, "\n"))


def write(path: Path, text: str) -> None:
    """Write the page in place of an older one."""
    with replacing(path, "report") as part:
        part.write_text(text, encoding="utf-8")


def _verdict(found: Sequence[PageSection]) -> Html:
    """Summarize failures, missing parts, and otherwise the results, in a few lines."""
    failures = [f"{section.title}: {one}" for section in found for one in section.failures]
    missing = [one for section in found for one in section.missing]
    counts = ", ".join(
        f"{section.title.lower()} {len(section.failures)}" for section in found if section.failures
    )
    lines: list[object] = []
    if failures:
        lines += [
            tag("p", tag("strong", counted(len(failures), "failure")), f": {counts}", class_="bad"),
            listed(failures),
        ]
    else:
        some = any(section.found for section in found)
        kind = "" if not some else "part" if missing else "good"
        lines.append(tag("p", tag("strong", SAID[kind]), class_=kind))
    lines += [sentence(name, "missing") for name in missing]
    lines.append(
        tag(
            "dl",
            *(
                tag("div", tag("dt", section.title), tag("dd", section.found))
                for section in found
                if section.found
            ),
        )
    )
    return tag("section", *lines, id="verdict", class_="verdict")


def _made(made: Mapping[str, Made]) -> Html:
    """Write when, from which source and on which machine the parts were made."""
    if not made:
        return tag(
            "section", tag("p", "The files do not say when and on which machine they were made."), id="made"
        )
    rows = []
    for part, one in made.items():
        took = "–" if one.seconds is None else time(one.seconds)
        rows.append(("", (part, one.date, one.commit or "–", took)))
    groups: dict[tuple[tuple[str, str], ...], list[str]] = {}
    for part, one in made.items():
        groups.setdefault(tuple(one.facts.items()), []).append(part)
    facts = [tag("h3", ", ".join(parts)) for parts in groups.values()]
    lists = [tag("dl", *(tag("div", tag("dt", k), tag("dd", v)) for k, v in group)) for group in groups]
    shown = join(join(pair) for pair in zip(facts, lists, strict=True))
    return tag(
        "section", tag("h2", "Made on"), shown, table(("part", "date", "source", "took"), rows), id="made"
    )


def _commands() -> Html:
    """Write the command of each part."""
    return table(("part", "command"), [("", (name, tag("code", command(name)))) for name in NAMES])
