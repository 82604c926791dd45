"""A run of the campaign: so many models, and the table of what was found."""

import json
import sys
import time
import traceback
from collections import Counter, defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from hypothesis import strategies as st

from campaign.case import Case
from campaign.draws import each
from campaign.families import FAMILIES
from campaign.verdict import Verdict, judged, tolerances

Report = Callable[[int], None]


class ModelFailedError(AssertionError):
    """A model has failed a property; the text is the property and the program that makes the model."""


@dataclass
class Findings:
    """What a run has found.

    Attributes
    ----------
    families : Counter
        Models of each family.
    errors : dict of str to list of float
        By property.
    skipped : Counter
        Reasons for which a property had nothing to say about a model, ``property: reason``.
    refused : Counter
        Reasons for which flexel refused a model that the oracle finds singular.
    failures : list of dict
        Program, property and error.
    """

    families: Counter[str] = field(default_factory=Counter)
    errors: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    skipped: Counter[str] = field(default_factory=Counter)
    failures: list[dict[str, Any]] = field(default_factory=list)

    def add(self, verdict: Verdict) -> None:
        """Count a model."""
        self.families[verdict.case.family] += 1
        for name, error in verdict.errors.items():
            self.errors[name].append(error)
        for name, reason in verdict.skipped.items():
            self.skipped[f"{name}: {reason}"] += 1
        for name, error, text in verdict.failures:
            program = verdict.case.program()
            shown = None if np.isnan(error) else error
            self.failures.append({"program": program, "property": name, "error": shown, "message": text})

    def as_json(self, seed: int, seconds: float) -> dict[str, Any]:
        """What `make report` and docs/verification.md show."""
        rows = [
            {
                "name": name,
                "models": len(self.errors[name]),
                "largest": float(np.max(self.errors[name])),
                "median": float(np.median(self.errors[name])),
                "tolerance": tolerance,
            }
            for name, tolerance in tolerances().items()
            if self.errors[name]
        ]
        return {
            "campaign": "property",
            "seed": seed,
            "models": sum(self.families.values()),
            "seconds": round(seconds, 1),
            "families": dict(sorted(self.families.items())),
            "properties": rows,
            "skipped": [{"reason": reason, "models": n} for reason, n in sorted(self.skipped.items())],
            "failures": self.failures,
        }


def models(families: Mapping[str, st.SearchStrategy[Case]]) -> st.SearchStrategy[Case]:
    """A model of any of the families, each as likely as another."""
    return st.sampled_from(sorted(families)).flatmap(families.__getitem__)


def shares(count: int, families: int) -> list[int]:
    """So many models in all, as evenly as possible over the families."""
    return [count // families + (i < count % families) for i in range(families)]


def run(
    count: int,
    seed: int,
    families: Mapping[str, st.SearchStrategy[Case]] = FAMILIES,
    *,
    shrink: bool = True,
    report: Report | None = None,
) -> dict[str, Any]:
    """Draw models and hold each against all properties.

    A family ends with its first failure, which hypothesis shrinks to the shortest program; without `shrink` all
    failures are kept as they are drawn.  It also ends where its models cannot be drawn, which counts as a failure.  An
    interrupt ends the run; what was found until then is returned.
    """
    found, begun = Findings(), time.monotonic()
    try:
        for (name, strategy), share in zip(families.items(), shares(count, len(families)), strict=True):
            if share:
                _family(found, strategy, share, f"{seed} {name}", shrink, report)
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
    return found.as_json(seed, time.monotonic() - begun)


def _family(
    found: Findings,
    strategy: st.SearchStrategy[Case],
    count: int,
    seed: str,
    shrink: bool,
    report: Report | None,
) -> None:
    """The models of one family; the last verdict that failed is that of the shortest program."""
    failed: list[Verdict] = []

    def one(case: Case) -> None:
        verdict = judged(case)
        if verdict.failures and shrink:
            failed.append(verdict)
            raise ModelFailedError(str(verdict))
        if failed:
            return  # an attempt to shrink
        found.add(verdict)
        if report is not None:
            report(sum(found.families.values()))

    try:
        each(strategy, count, seed, one, shrink)
    except ModelFailedError:
        found.add(failed[-1])
    except Exception:  # of the grammar, which builds parts of the model that it draws
        text = traceback.format_exc()
        found.failures.append({"program": "", "property": "drawn", "error": None, "message": text})


def table(report: Mapping[str, Any]) -> str:
    """The report as text: properties, what was skipped, failures."""
    lines = [f"{report['models']} models in {report['seconds']:g} s, seed {report['seed']}"]
    lines += [f"  {name}: {n}" for name, n in report["families"].items()]
    lines.append(f"{'property':36s} {'models':>7s} {'largest':>9s} {'median':>9s} {'tolerance':>9s}")
    for row in report["properties"]:
        numbers = f"{row['largest']:9.1e} {row['median']:9.1e} {row['tolerance']:9.1e}"
        lines.append(f"{row['name']:36s} {row['models']:7d} {numbers}")
    lines += [f"skipped {row['models']:6d}  {row['reason']}" for row in report["skipped"]]
    for failure in report["failures"]:
        lines += [
            f"FAILED {failure['property']}: {failure['error']} {failure['message']}",
            failure["program"],
        ]
    return "\n".join(lines)


def written(report: Mapping[str, Any]) -> str:
    """The report as JSON."""
    return json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
