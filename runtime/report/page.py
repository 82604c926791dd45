"""The whole page: what failed and what is missing at the top, the sections, and how to make it again."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from importlib import resources
from pathlib import Path
from string import Template

from flexel.base.files import replacing
from flexel.base.shown import counted
from flexel.report import campaign, convergence, kernels, sanitizers, speed, systems
from flexel.report.markup import Html, join, sentence, table, tag, time
from flexel.report.parts import NAMES, Made, Parts, command
from flexel.report.plots import Plots, limits
from flexel.report.section import Section, listed

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
    "From a checkout, `make report` makes all of it and writes out/report.html. Without a checkout, "
    "`flexel report --run verify reproduce bench` makes what needs none. `flexel report` alone writes the page from "
    "the files that there are in out/report."
)
SAID = {"good": "No failure", "part": "No failure in what was run; parts are missing", "": "Nothing was run"}


def sections(parts: Parts, kernel_names: Sequence[str], system_names: Sequence[str]) -> list[Section]:
    """The sections of the page.

    Parameters
    ----------
    parts : Parts
        What was found.
    kernel_names, system_names : sequence of str
        What there is to be found: elements and laws, and systems.
    """
    plots = Plots()
    found = systems.section(parts.reproduce, system_names)
    return [
        kernels.section(parts.verify, kernel_names),
        _with_limits(found, parts, plots),
        convergence.section(parts.reproduce, plots),
        campaign.section(parts.campaign),
        sanitizers.section(parts.sanitize),
        speed.section(parts.bench, plots),
    ]


def _with_limits(found: Section, parts: Parts, plots: Plots) -> Section:
    """The section about systems with a plot of all errors over their tolerances."""
    rows: dict[str, list[tuple[float, float]]] = {}
    for row in (row for case in parts.reproduce for row in case.quantities):
        if row.error is not None:
            rows.setdefault(row.kind, []).append((row.tolerance, row.error))
    if not rows:
        return found
    kinds = {kind: rows[kind] for kind in sorted(rows, key=lambda z: -len(rows[z]))}
    caption = f"Error over tolerance of every row with a reference; errors below 1e-17 are drawn there. {_share(rows)}"
    drawn: Html = tag("p", plots.remedy, class_="missing")
    if plots.possible:
        drawn = tag("figure", plots.draw(limits, kinds), tag("figcaption", caption), class_="wide")
    return Section(
        found.key, found.title, found.says, found.found, [drawn, *found.body], found.failures, found.missing
    )


def _share(rows: Mapping[str, Sequence[tuple[float, float]]]) -> str:
    """The largest error of each kind as a share of its tolerance."""
    largest = {kind: max((b / a for a, b in z if a > 0), default=None) for kind, z in rows.items()}
    said = ", ".join(f"{kind} {value:.2f}" for kind, value in largest.items() if value is not None)
    return f"Largest error as a share of the tolerance: {said}." if said else ""


def page(
    found: Sequence[Section], version: str, written: str, made: Mapping[str, Made], notes: str = ""
) -> str:
    """The page as HTML, which refers to nothing outside of itself.

    Parameters
    ----------
    found : sequence of Section
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
        tag("nav", *(tag("a", z.title, href=f"#{z.key}") for z in found)),
        _made(made),
        *(z.html() for z in found),
        tag("section", tag("h2", "To make this page again"), sentence(AGAIN), _commands(), id="again"),
    ]
    style = resources.files("flexel.report").joinpath("page.css").read_text(encoding="utf-8")
    return PAGE.substitute(title=html.escape(f"flexel {version}: report"), style=style, body=join(body, "\n"))


def write(path: Path, text: str) -> None:
    """Write the page in place of an older one."""
    with replacing(path, "report") as part:
        part.write_text(text, encoding="utf-8")


def _verdict(found: Sequence[Section]) -> Html:
    """What failed, what is missing, and otherwise what was found, in a few lines."""
    failures = [f"{z.title}: {one}" for z in found for one in z.failures]
    missing = [one for z in found for one in z.missing]
    counts = ", ".join(f"{z.title.lower()} {len(z.failures)}" for z in found if z.failures)
    lines: list[object] = []
    if failures:
        lines += [
            tag("p", tag("strong", counted(len(failures), "failure")), f": {counts}", class_="bad"),
            listed(failures),
        ]
    else:
        some = any(z.found for z in found)
        kind = "" if not some else "part" if missing else "good"
        lines.append(tag("p", tag("strong", SAID[kind]), class_=kind))
    lines += [sentence(z, "missing") for z in missing]
    lines.append(tag("dl", *(tag("div", tag("dt", z.title), tag("dd", z.found)) for z in found if z.found)))
    return tag("section", *lines, id="verdict", class_="verdict")


def _made(made: Mapping[str, Made]) -> Html:
    """When, from which source and on which machine the parts were made."""
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
    """The command of each part."""
    return table(("part", "command"), [("", (z, tag("code", command(z)))) for z in NAMES])
