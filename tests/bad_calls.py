"""Every public function of flexel with junk in place of each argument: what there is to be tried, and the verdict."""

import inspect
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from junk import ENTRIES, JUNK, NOT_FINITE, admitted, inside
from valid_flexures import FLEXURES
from valid_joints import JOINTS
from valid_models import MODELS
from valid_results import RESULTS
from valid_systems import SYSTEMS
from valid_values import VALUES

import flexel as fx

VALID = VALUES | MODELS | JOINTS | SYSTEMS | RESULTS | FLEXURES
OWN_WARNINGS = (
    fx.AssemblyWarning, fx.AuditWarning, fx.CoordinateWarning, fx.DampingWarning, fx.IncompleteWarning, fx.ModelWarning,
    fx.RangeWarning,
    fx.StiffWarning, fx.UnstableWarning, fx.UnsteadyWarning,
)  # fmt: skip
# Classes whose objects flexel makes: their constructors are not for users.
MADE_BY_FLEXEL = {
    "BeamStress", "BucklingMode", "CheckReport", "Compliance", "ConstraintReport", "ElementPage", "ElementValues",
    "Ensemble", "Finding",
    "Flexure", "FlexureElement", "FlexureNode", "FlexureStep",
    "Linearization", "Linearizations", "Mode", "Motion", "PeriodicBranch", "PeriodicSolution", "Points",
    "Reduced", "RigidBody", "RootLoci", "Rope", "SampledLoop", "SmallMotion", "Spacar", "SpacarRecords", "State",
    "Stepper", "StressPoint", "Summary", "System", "TimeVarying", "Vibration",
}  # fmt: skip
# Methods that the parts of flexel call with checked values, and those of tuple.
INTERNAL = {
    "Contact.law", "Curve.parameters", "Linearization.variation", "Motion.count", "Motion.index", "Points.columns",
    "Points.difference",
    "Ramp.next_knot", "Ramp.on_knot", "System.kinematics_of", "System.kinematics_with", "System.use", "System.warm",
    "Table.next_knot", "Table.of", "Table.on_knot", "TimeVarying.count", "TimeVarying.index", "TimeVarying.linearized",
    "Waves.parameters",
}  # fmt: skip
# Junk that is no junk: what it stands for is in the docstring, or nothing is changed.
DOCUMENTED = {
    "System.simulate(max_step=None)", "System.simulate(max_step=infinity)", "System.use_coordinates(dynamic=None)",
    "System.with_parameters(values=None)",
}  # fmt: skip
# What Python itself says of an option that does not exist; it names the option.
NO_OPTION = "got an unexpected keyword argument"


@dataclass(frozen=True)
class Case:
    """Junk of a kind in place of an argument, or of its first entry."""

    call: str
    parameter: str
    kind: str
    entry: bool = False

    def __str__(self) -> str:
        return f"{self.call}({self.parameter}={'[' * self.entry}{self.kind}{'…]' * self.entry})"


def public_calls() -> Iterator[tuple[str, inspect.Signature]]:
    """Everything that is called with arguments: functions, classes and methods of `flexel.__all__`."""
    for name in fx.__all__:
        value = getattr(fx, name)
        if inspect.isclass(value) and issubclass(value, BaseException):
            continue
        if name not in MADE_BY_FLEXEL:
            yield name, inspect.signature(value)
        if not inspect.isclass(value):
            continue
        for method, called in inspect.getmembers(value, callable):
            label = f"{name}.{method}"
            if method[0] == "_" or label in INTERNAL:
                continue
            signature = inspect.signature(called)
            if inspect.isfunction(called):  # the first argument is `self`, or the system of an analysis
                signature = signature.replace(parameters=list(signature.parameters.values())[1:])
            if signature.parameters:
                yield label, signature


def cases() -> list[Case]:
    """All there are."""
    found = []
    for name, signature in public_calls():
        arguments = VALID[name]().arguments
        for parameter in signature.parameters:
            found += [Case(name, parameter, kind) for kind in JUNK]
            given = arguments.get(parameter)
            found += [
                Case(name, parameter, kind, True) for kind in ENTRIES if inside(given, kind) is not None
            ]
    return found


def called(case: Case) -> tuple[Any, str]:
    """The result of the call with junk, and the annotation of the parameter."""
    base = VALID[case.call]()
    arguments = dict(base.arguments)
    given = inside(arguments[case.parameter], case.kind) if case.entry else JUNK[case.kind]()
    signature = inspect.signature(base.function)
    parameter = signature.parameters[case.parameter]
    several = parameter.kind is parameter.VAR_POSITIONAL
    arguments[case.parameter] = (given,) if several and not case.entry else given
    if parameter.kind is parameter.VAR_KEYWORD and not isinstance(given, dict):
        arguments[case.parameter] = {"junk": given}
    result = base.function(*positional(signature, arguments), **named(signature, arguments))
    base.after(result)
    return result, str(parameter.annotation)


def positional(signature: inspect.Signature, arguments: dict[str, Any]) -> list[Any]:
    """What stands before and at ``*names``."""
    names = list(signature.parameters.values())
    star = next((i for i, parameter in enumerate(names) if parameter.kind is parameter.VAR_POSITIONAL), None)
    only = [parameter.name for parameter in names if parameter.kind is parameter.POSITIONAL_ONLY]
    before = [parameter.name for parameter in names[:star]] if star is not None else only
    found = [arguments.pop(name) for name in before if name in arguments]
    return found + list(arguments.pop(names[star].name, ())) if star is not None else found


def named(signature: inspect.Signature, arguments: dict[str, Any]) -> dict[str, Any]:
    """The rest, with the entries of ``**options`` as arguments."""
    found = dict(arguments)
    for name, parameter in signature.parameters.items():
        if parameter.kind is parameter.VAR_KEYWORD:
            found |= {str(key): value for key, value in found.pop(name, {}).items()}
    return found


def verdict(case: Case) -> str:
    """What is wrong with what a case does; empty if nothing is."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            _, annotation = called(case)
        except fx.FlexelError as error:
            if any(raw in str(error) for raw in ("np.float64(", "np.int64(", "np.bool")):
                return f"shows a NumPy object: {error!s}"[:300]
            return "" if len(str(error)) > 20 else f"says only {error!s}"
        except Exception as error:
            if isinstance(error, TypeError) and NO_OPTION in str(error):
                return ""
            return f"{type(error).__name__}: {error}"[:300]
    foreign = [warning for warning in caught if not issubclass(warning.category, OWN_WARNINGS)]
    if foreign:
        return f"warning {foreign[0].category.__name__}: {foreign[0].message}"[:300]
    definite = case.entry and case.kind in NOT_FINITE
    taken = definite or (not case.entry and not admitted(annotation, case.kind))
    return "accepted" if taken and str(case) not in DOCUMENTED else ""


def prepare() -> None:
    """Files that calls read, in the folder of the process; and what is made only once."""
    from swept import numbers, plain
    from valid_results import swing

    swing().save("saved.npz")
    fx.sweep(plain, {"a": [1, 2]}, numbers, executor="serial", folder="sweep", progress=False)
    for make in (RESULTS | SYSTEMS).values():
        make()
