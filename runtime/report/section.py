"""A section of the page: what it shows, what is wrong, and what is missing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from flexel.base.shown import counted
from flexel.report.markup import Html, join, sentence, tag, text
from flexel.report.parts import command


@dataclass(frozen=True)
class Section:
    """A section of the page.

    Attributes
    ----------
    key : str
        Its anchor in the page.
    title : str
    says : str
        One or two sentences: what it shows, and what would be a failure.
    found : str
        What was found, in one line.
    body : sequence of str
        HTML, or text.
    failures : sequence of str
        Each thing that is wrong, by name.
    missing : sequence of str
        What the page has no figures of, with the command that makes them.
    """

    key: str
    title: str
    says: str
    found: str = ""
    body: Sequence[object] = ()
    failures: Sequence[str] = field(default=())
    missing: Sequence[str] = field(default=())

    def html(self) -> Html:
        """The section, its failures first."""
        wrong = [tag("p", counted(len(self.failures), "failure"), ":", class_="bad"), listed(self.failures)]
        return tag(
            "section",
            tag("h2", self.title),
            sentence(self.says),
            tag("p", self.found, class_="found") if self.found else "",
            join(wrong) if self.failures else "",
            join(sentence(z, "missing") for z in self.missing),
            join(text(z) for z in self.body),
            id=self.key,
        )


def listed(entries: Sequence[str]) -> Html:
    """A list of defects."""
    return tag("ul", *(tag("li", z) for z in entries), class_="bad")


def absent(part: str, what: str) -> str:
    """The sentence about a part without a file."""
    return f"{what}: not in this report; `{command(part)}` makes it."


def without(names: Sequence[str], known: Sequence[str], part: str, what: str) -> list[str]:
    """The sentence about names that are known and of which there are no figures, if there are such."""
    lacking = [z for z in known if z not in names]
    return [absent(part, f"{what} {', '.join(lacking)}")] if lacking and names else []
