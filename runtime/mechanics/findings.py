"""Findings of a model check, with their severity, as a table."""

from __future__ import annotations

from dataclasses import dataclass

from flexel.base.shown import prints

SEVERITIES = ("error", "warning", "note")


@dataclass(frozen=True)
class Finding:
    """One result of a check.

    Attributes
    ----------
    severity : str
        "error" (`Model.build` refuses it), "warning" (it is built, but is probably a mistake), or "note".
    subject : str
        Subject of the finding: "constraints", "masses", "units", …
    message : str
        Names the cause, and how to correct it.
    """

    severity: str
    subject: str
    message: str


@dataclass(frozen=True)
class CheckReport:
    """All findings of a model check; printed as a table.

    Attributes
    ----------
    findings : tuple of Finding
        Errors first, then warnings, then notes.
    dynamic, kinematic : tuple of str
        Names of the degrees of freedom; empty if the model cannot be built.
    """

    findings: tuple[Finding, ...]
    dynamic: tuple[str, ...]
    kinematic: tuple[str, ...]

    @property
    def errors(self) -> tuple[Finding, ...]:
        """Findings for which `Model.build` refuses the model."""
        return self._of("error")

    @property
    def warnings(self) -> tuple[Finding, ...]:
        """Findings that `Model.build` accepts, but that are probably mistakes."""
        return self._of("warning")

    @property
    def ok(self) -> bool:
        """Whether there is neither an error nor a warning."""
        return not (self.errors or self.warnings)

    def _of(self, severity: str) -> tuple[Finding, ...]:
        return tuple(finding for finding in self.findings if finding.severity == severity)

    @prints
    def __repr__(self) -> str:
        width = max((len(finding.subject) for finding in self.findings), default=0)
        lines = [
            f"{finding.severity:<7}  {finding.subject:<{width}}  {finding.message}"
            for finding in self.findings
        ]
        counts = (f"{len(found)} {kind}(s)" for kind in SEVERITIES if (found := self._of(kind)))
        return "\n".join([*lines, ", ".join(counts) or "nothing to report"])
