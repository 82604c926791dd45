"""The methods of `System.simulate`: the options of each, the default method, and a run of each."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np

from flexel.base.arguments import step_limit, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.integration.alpha import AlphaStepper
from flexel.integration.alpha_attempts import Control
from flexel.integration.dop853 import Dop853
from flexel.integration.driver import Run
from flexel.integration.events import Event
from flexel.integration.followed import Followed
from flexel.integration.minimal import MinimalRun
from flexel.integration.radau import Radau
from flexel.integration.step_method import MINOR, StepMethod, Tolerances
from flexel.integration.steps import GeneralizedAlpha
from flexel.integration.stiffness import ALPHA, EXPLICIT, RADAU
from flexel.mechanics.amplification import amplification, lost
from flexel.mechanics.inertia import InertiaError
from flexel.model.snapshot import Snapshot
from flexel.model.state import State, own_state
from flexel.model.structure import Structure
from flexel.system import CoreSystem

AUTO = "auto"
KINDS: dict[str, type[StepMethod]] = {EXPLICIT: Dop853, RADAU: Radau}  # in minimal coordinates
RTOL, ATOL, IMPLICIT_RTOL = 1e-9, 1e-11, 1e-6
LEAST_ATOL = 1e-100  # a smaller value would overflow
RADIUS, NEWTON = 0.8, "full"


def _of(*methods: str) -> Any:
    """An option of these methods."""
    return field(default=None, metadata={"methods": methods})


@dataclass(frozen=True)
class Options:
    """The options of the methods, each with those that have it, and what the user gave; None if not given."""

    rtol: Any = _of(AUTO, EXPLICIT, RADAU, ALPHA)
    atol: Any = _of(AUTO, EXPLICIT, RADAU, ALPHA)
    first_step: Any = _of(AUTO, EXPLICIT, RADAU, ALPHA)
    max_step: Any = _of(AUTO, EXPLICIT, RADAU, ALPHA)
    step: Any = _of(ALPHA)
    spectral_radius: Any = _of(ALPHA)
    newton: Any = _of(ALPHA)
    events: tuple[Event, ...] | None = _of(AUTO, EXPLICIT, RADAU, ALPHA)
    rechoose: bool | None = _of(AUTO, EXPLICIT, RADAU)
    minor: float | None = _of()  # of Radau, see `Tolerances`; only "auto" sets it

    def number(self, name: str, default: float, least: float = 0.0) -> float:
        """Return a positive option, or raise a ModelError."""
        given = getattr(self, name)
        return default if given is None else step_limit(given, "simulate", name, least)

    def with_first(self, step: float | None) -> Options:
        """Copy with another first step, to continue from a state; constant steps stay as they are."""
        return self if self.step is not None else replace(self, first_step=step)

    @property
    def first(self) -> float | None:
        """The first step [s]."""
        return None if self.first_step is None else self.number("first_step", 0.0)


OPTIONS = {
    method: {entry.name for entry in fields(Options) if method in entry.metadata["methods"]}
    for method in (AUTO, EXPLICIT, RADAU, ALPHA)
}
WITH_STEPS = ("rtol", "atol", "first_step", "max_step")  # options that a constant step replaces


def check(method: Any, options: Options) -> None:
    """Reject an unknown method, and options that it does not have.

    Raises
    ------
    ModelError
        Names the option, the method, and those that have it.
    """
    if not isinstance(method, str) or method not in OPTIONS:
        raise ModelError(f"simulate: method {method!r} is unknown; choose one of {', '.join(OPTIONS)}")
    given = [name for name, value in vars(options).items() if value is not None]
    for name in given:
        if name not in OPTIONS[method]:
            having = [other for other in OPTIONS if name in OPTIONS[other]]
            raise ModelError(
                f"simulate: {name} is not an option of method '{method}'; choose a method that has it: "
                f"{', '.join(having)}"
            )
    beside = [name for name in given if name in WITH_STEPS]
    if options.step is not None and beside:
        raise ModelError(
            f"simulate: step is constant, so {', '.join(beside)} would have no effect; give one or the other"
        )


def start_of(system: CoreSystem, method: str, start: Any, options: Options) -> State:
    """Return the state that a motion starts from; generalized-alpha needs no accelerations."""
    if start is not None:
        return own_state(system.structure, start, "simulate")
    try:
        return system.initial
    except InertiaError:
        if method in (EXPLICIT, RADAU):
            raise
        return system.unaccelerated


def run_of(
    system: CoreSystem, method: str, start: State, times: Array, duration: float, options: Options
) -> Run:
    """Create a run of a method.

    Parameters
    ----------
    system : CoreSystem
    method : str
        Any but auto.
    start : State
    times : ndarray
        At which states are kept.
    duration : float
        [s]
    options : Options
        Checked ones.
    """
    if method == ALPHA:
        return _alpha(system, start, times, duration, options)
    events, tolerances = options.events or (), tolerances_of(system, options)
    if system.roles.nq == 0 and not has_rates(system.structure):
        return Followed(system, start, times, events)
    rechoose = options.rechoose is not False
    return MinimalRun(
        system, _in_own_roles(system, start), times, tolerances, events, rechoose, KINDS[method]
    )


def tolerances_of(system: CoreSystem, options: Options) -> Tolerances:
    """Return the tolerances of a method in minimal coordinates."""
    return Tolerances(
        rtol_of(options),
        _atol(system, options),
        options.first,
        options.number("max_step", np.inf),
        options.atol is None,
        MINOR if options.minor is None else options.minor,
    )


def rtol_of(options: Options) -> float:
    """Return the relative tolerance of a method in minimal coordinates."""
    return options.number("rtol", RTOL, 1e-13)


def has_rates(structure: Structure) -> bool:
    """Whether internal states change with time; those of sampled controllers only jump."""
    outputs = (output for law in structure.laws for output in law.spec.kernels["law"].outputs)
    return any(output.name == "zd" and output.nonzeros for output in outputs)


def _atol(system: CoreSystem, options: Options) -> float | Array:
    """Return the absolute tolerance in natural scales, one for all variables or one for each."""
    if not isinstance(options.atol, Iterable):
        return options.number("atol", ATOL, LEAST_ATOL)
    size = system.roles.nq + system.roles.nd + system.structure.nz
    given = vector(options.atol, "simulate", "atol", size)
    if options.rechoose is not False:
        raise ModelError(
            "simulate: atol of each variable, but the variables may change during the motion; give rechoose=False too"
        )
    if np.any(given <= 0):
        raise ModelError(f"simulate: atol {given.min():g} is too small; give more than 0")
    return given


def _in_own_roles(system: CoreSystem, start: State) -> State:
    """Return the start in the system's degrees of freedom, or in its own if these are much better."""
    if start.roles is system.roles:
        return start
    here = Snapshot.of(start)
    theirs = amplification(system.kinematics_of(start.roles), here)
    if amplification(system.kinematics, here) <= lost(system.roles) * max(theirs, 1.0):
        return system.state(start.t, start.x, start.v, start.e, start.z)
    return start  # the chosen ones are singular at this state


def _alpha(system: CoreSystem, start: State, times: Array, duration: float, options: Options) -> Run:
    """Create a run of the generalized-alpha method."""
    if options.step is not None:
        step = options.number("step", 0.0)
        control = Control(np.inf, step, step)
    else:
        tolerance, longest = options.number("rtol", IMPLICIT_RTOL), options.number("max_step", np.inf)
        absolute = 0.0 if options.atol is None else options.number("atol", 0.0)
        control = Control(tolerance, options.first or duration / 1000, longest, absolute)
    radius = RADIUS if options.spectral_radius is None else options.spectral_radius
    stepper = AlphaStepper(system, radius, options.newton or NEWTON, control.tolerance)
    return GeneralizedAlpha(system, start, times, stepper, control, options.events or ())
