"""One model through all properties."""

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache

import flexel as fx
from campaign.case import Case
from campaign.changes import Inapplicable
from campaign.properties import PROPERTIES, Property
from campaign.trial import Trial


@dataclass
class Verdict:
    """What became of a model.

    Attributes
    ----------
    case : Case
    errors : dict of str to float
        By property.
    skipped : dict of str to str
        Properties that have nothing to say, and why.
    refused : str
        Flexel's message, if it refuses the model; allowed where the configuration is singular.
    failures : list of (str, float, str)
        Property, error, message.
    """

    case: Case
    errors: dict[str, float] = field(default_factory=dict)
    skipped: dict[str, str] = field(default_factory=dict)
    refused: str = ""
    failures: list[tuple[str, float, str]] = field(default_factory=list)

    def __str__(self) -> str:
        lines = [f"{name}: error {error:.3g} {text}" for name, error, text in self.failures]
        return "\n".join([*lines, "", self.case.program()])


FAR_BENT = ".*(in place of each|logarithmic)"  # random beams may be bent far
# Of random motions, which the twins follow beyond these too.
LIMITS = (
    ".* pulls on the road",
    ".*rope .* has (left|run)",
    ".* nearly singular at",
    ".*this motion is small beside the model",
)


def judged(case: Case, properties: Sequence[Property] = PROPERTIES) -> Verdict:
    """Hold a model against all properties."""
    verdict, trial = Verdict(case), Trial(case)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", FAR_BENT, fx.RangeWarning)
        for limit in LIMITS:
            warnings.filterwarnings("ignore", limit, fx.AuditWarning)
        try:
            assert trial.start is not None
        except (fx.FlexelError, Warning) as error:
            if isinstance(error, fx.PositionError) and case.offsets and trial.beyond_reach:
                verdict.refused = str(error)
                verdict.skipped["build"] = "refused by flexel, and beyond where the model turns back"
            else:
                _refuse(verdict, trial, "build", error)
            return verdict
        for check in properties:
            _hold(verdict, trial, check)
    return verdict


def _hold(verdict: Verdict, trial: Trial, check: Property) -> None:
    try:
        error = float(check.error(trial))
    except Inapplicable as reason:
        verdict.skipped[check.name] = str(reason)
        return
    except (fx.FlexelError, Warning) as refusal:
        _refuse(verdict, trial, check.name, refusal)
        return
    verdict.errors[check.name] = error
    if not error <= check.tolerance:
        verdict.failures.append((check.name, error, f"> {check.tolerance:g}"))


def _refuse(verdict: Verdict, trial: Trial, name: str, error: Exception) -> None:
    message = " ".join(str(error).split())
    if trial.singular:
        verdict.refused = message
        verdict.skipped[name] = "refused by flexel, and singular by the oracle"
    else:
        verdict.failures.append((name, float("nan"), f"{type(error).__name__}: {message}"))


@cache
def tolerances() -> dict[str, float]:
    """By property."""
    return {check.name: check.tolerance for check in PROPERTIES}
