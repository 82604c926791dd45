"""A section of the page: its subject, its failures and its missing parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from flexel.base.shown import counted
from report.markup import Html, join, sentence, tag, text
from report.parts import command


@dataclass(frozen=True)
class PageSection:
    """A section of the page.

    Attributes
    ----------
    key : str
        Its anchor in the page.
    title : str
    says : str
        One or two sentences: the subject, and the meaning of a failure.
    found : str
        The result, in one line.
    body : sequence of str
        HTML, or text.
    failures : sequence of str
        Each failure, by name.
    missing : sequence of str
        The missing figures, with the command that makes them.
    """

    key: str
    title: str
    says: str
    found: str = ""
    body: Sequence[object] = ()
    failures: Sequence[str] = field(default=())
    missing: Sequence[str] = field(default=())

    def html(self) -> Html:
        """Write the section, its failures first."""
        wrong = [tag("p", counted(len(self.failures), "failure"), ":", class_="bad"), listed(self.failures)]
        return tag(
            "section",
            tag("h2", self.title),
            sentence(self.says),
            tag("p", self.found, class_="found") if self.found else "",
            join(wrong) if self.failures else "",
            join(sentence(name, "missing") for name in self.missing),
            join(text(piece) for piece in self.body),
            id=self.key,
        )


def listed(entries: Sequence[str]) -> Html:
    """Write a list of defects."""
    return tag("ul", *(tag("li", entry) for entry in entries), class_="bad")


def absent(part: str, what: str) -> str:
    """Write the sentence about a part without a file."""
    return f"{what}: not in this report; `{command(part)}` makes it."


def without(names: Sequence[str], known: Sequence[str], part: str, what: str) -> list[str]:
    """Write the sentence about known names without figures, if there are any."""
    lacking = [name for name in known if name not in names]
    return [absent(part, f"{what} {', '.join(lacking)}")] if lacking and names else []
