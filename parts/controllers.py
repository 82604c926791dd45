"""Controllers: sampled or continuous, with limits, delays and an internal state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, replace
from typing import Any

import numpy as np

from flexel.base.arguments import LARGEST, names, new_name, numbers, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.controller import Controller, parts
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.parts.anti_windup import anti_windup_of
from flexel.parts.control_systems import rule_of
from flexel.parts.controller_laws import add_continuous, add_sampled, known_names

MOST_SLOTS = 1000  # largest number of delayed outputs


@part
class ControllerPart(Part[None]):
    """Attach a controller: forces that depend on measured quantities.

    With a period the controller is sampled: it measures at t = 0, period, 2 period, …, just before each instant,
    and holds its outputs until the next one.  Without a period it is continuous.

    A function ``u = function(t, y)`` of the time and the inputs y (ny,) returns the outputs u (nu,), or a number if
    there is only one.  With `state`, ``u, x = function(t, y, x)`` also returns the new state, or its rate if the
    controller is continuous.  The function must not store anything between calls.

    Gains (nu, ny), or a state-space system or transfer function of python-control or scipy.signal, act on
    reference - y: negative feedback, as in `control.feedback` and `control.lqr`.  A discrete system sets the period.

    `anti_windup` keeps integrators from winding up while an output v is beyond its limits and u is the limited one:

    - A time constant T of a linear system [s]: its integral parts track the limited outputs.  It gives the
      gains L = V (C V)⁺ / T, or times the period if sampled, with the eigenvectors V of the integrators.
    - Gains L of any controller: x' = f + L (u - v), or for the next state x = f + L (u - v) if sampled.
    - "clamp" for sampled controllers: the integral part of an output stops when it would drive the output further
      beyond the limit.  For a function, its whole state stops.

    Raises
    ------
    ModelError
        Unknown names, with the nearest ones; sizes that differ; a delay without a period.
    CompilerError
        Gains or a linear system without a period are compiled, and there is no C compiler.

    See Also
    --------
    System.stepper : A user's loop around a system.

    Examples
    --------
    A sampled and saturated regulator, its gains from `control.lqr`:

    >>> m.controller(
    ...     K, inputs=lin.states, outputs=["motor.angle"], period=0.01, limits=(-5, 5)
    ... )  # doctest: +SKIP

    Integral action:

    >>> def pi(t, y, x):
    ...     error = 0.5 - y
    ...     return 20 * error + 4 * x, x + 0.01 * error
    >>> m.controller(
    ...     pi, inputs=["motor.angle"], outputs=["motor.angle"], period=0.01, state=[0]
    ... )  # doctest: +SKIP
    """

    function: Any = array_quantity(
        "",
        "A function of time and inputs, gains, or a linear system.",
        form="callable, array_like or linear system",
    )
    _: KW_ONLY
    inputs: Sequence[str] = entry(
        "Coordinates and deformations, and, with a prime, the rates of these and of slips; for a sampled controller "
        "also accelerations (two primes), ``force:…``, and internal states."
    )
    outputs: Sequence[str] = entry(
        "Coordinates, deformations or slips on which it acts; positive where it does positive work as they "
        "increase, as for loads.  They become free, and so do the deformations that a continuous controller measures."
    )
    name: str = entry(
        "Results contain its outputs as ``name.u``, or ``name.u0``, ``name.u1``, …, and its state as ``name.x0``, …",
        default="controller",
    )
    period: float | None = quantity(
        "s", "positive", "Period of a sampled controller; None for a continuous one.", default=None
    )
    delay: float = quantity(
        "s",
        "not negative",
        "Time from an instant of a sampled controller to the change of its outputs; may be longer than the period.  "
        "Before the first change the outputs are zero.",
        default=0.0,
    )
    limits: Any = array_quantity(
        "",
        "Limits of the outputs, each a number or one for each output; None or infinite for none.",
        default=None,
        form="(low, high), optional",
    )
    anti_windup: Any = array_quantity(
        "",
        'A time constant, gains (nx, nu), or "clamp".',
        default=None,
        form='float, array_like or "clamp", optional',
    )
    state: Any = array_quantity(
        "", "Initial state (nx,) of a function or a system.", default=None, form="array_like, optional"
    )
    reference: Mapping[str, float] | None = array_quantity(
        "", "Desired values of the inputs, for gains or a linear system; zero where not given.", default=None
    )

    def lower(self, to: Lowering) -> None:
        """Add the laws of the controller, and what it does at its instants."""
        owner, name = self.owner, new_name(self.name, "controller")
        if any(other.name == name for other in to.controllers) or name in to.nodes or name in to.instances:
            raise ModelError(f"{owner}: this name is taken; choose another with name='…'")
        measured, driven = _listed(owner, "inputs", self.inputs), _listed(owner, "outputs", self.outputs)
        _check_inputs(to, owner, measured)
        wanted = _wanted(owner, measured, self.reference)
        sizes = len(measured), len(driven)
        rule, period, start = rule_of(owner, self.function, sizes, self.state, wanted, self.period)
        if self.delay and period is None:
            raise ModelError(
                f"{owner}: a continuous controller has no delay; give a period, or a system with a Padé approximation"
            )
        low, high = _limits(owner, self.limits, len(driven))
        found = Controller(name, measured, driven, rule, low, high, period, self.delay)
        found = replace(found, windup=anti_windup_of(found, self.anti_windup))
        if found.slots > MOST_SLOTS:
            raise ModelError(
                f"{owner}: {found.slots} outputs would be delayed at once (delay {self.delay:g} s, period "
                f"{period:g} s); at most {MOST_SLOTS} are possible"
            )
        add = add_continuous if period is None else add_sampled
        add(to, found, start.tolist())
        to.controllers.append(found)


def _listed(owner: str, what: str, given: Any) -> tuple[str, ...]:
    """Return names, each once and at least one."""
    found = names(given, f"{owner}: {what}")
    if not found or len(set(found)) < len(found):
        raise ModelError(f"{owner}: {what} {list(found)}; name one or more, each once")
    return found


def _check_inputs(to: Lowering, owner: str, inputs: Sequence[str]) -> None:
    """Refuse names that do not exist; whether they can be measured is checked when the model is built."""
    known = [*known_names(to), *(state for law in to.laws for state in law.states)]
    for name in inputs:
        base = parts(name)[0]
        if base not in known:
            raise ModelError(f"{owner}: input: {unknown(base, known)}")


def _wanted(owner: str, inputs: Sequence[str], reference: Any) -> Array | None:
    """Return the reference of each input; None if none is given."""
    if reference is None:
        return None
    given = numbers(reference, owner, "reference")
    for other in given.keys() - set(inputs):
        raise ModelError(
            f"{owner}: the reference '{other}' is not an input; the inputs are {', '.join(inputs)}"
        )
    return np.array([given.get(name, 0.0) for name in inputs])


def _limits(owner: str, limits: Any, nu: int) -> tuple[Array, Array]:
    """Lower and upper limits (nu,) of the outputs."""
    if limits is None:
        return np.full(nu, -np.inf), np.full(nu, np.inf)
    if not isinstance(limits, tuple | list | np.ndarray) or len(limits) != 2:
        raise ModelError(f"{owner}: limits {limits!r:.60}; give a pair (low, high)")
    low, high = (_limit(owner, side, nu, none) for side, none in zip(limits, (-np.inf, np.inf), strict=True))
    if np.any(low >= high):
        raise ModelError(f"{owner}: limits {limits!r:.60}; the lower one must be less than the upper one")
    return low, high


def _limit(owner: str, given: Any, nu: int, none: float) -> Array:
    """Return one limit for each output."""
    try:
        found = np.full(nu, none) if given is None else np.asarray(given)
        found = np.array(np.broadcast_to(found, (nu,)), dtype=float)
        good = np.asarray(given if given is not None else 0.0).dtype.kind in "iuf"
    except (TypeError, ValueError, OverflowError):
        good = False
    if not good or np.isnan(found).any() or np.any(np.isfinite(found) & (np.abs(found) > LARGEST)):
        raise ModelError(
            f"{owner}: limits contain {given!r:.60}; give a number, or one for each of {nu} outputs"
        )
    return found
