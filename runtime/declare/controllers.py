"""Controllers: sampled or continuous, with limits, delays and a state of their own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import (
    LARGEST,
    names,
    new_name,
    not_negative,
    numbers,
    unknown,
)
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.anti_windup import anti_windup_of
from flexel.declare.control_systems import rule_of
from flexel.declare.controller_laws import add_continuous, add_sampled, known_names
from flexel.declare.laws import Laws
from flexel.structure.controllers import Controller, parts

MOST_SLOTS = 1000  # largest number of delayed outputs


class Controllers(Laws):
    """Controllers."""

    @whole_or_nothing
    def controller(
        self,
        function: Any,
        *,
        inputs: Sequence[str],
        outputs: Sequence[str],
        name: str = "controller",
        period: float | None = None,
        delay: float = 0.0,
        limits: Any = None,
        anti_windup: Any = None,
        state: Any = None,
        reference: Mapping[str, float] | None = None,
    ) -> None:
        """Attach a controller: forces that depend on measured quantities.

        With a period the controller is sampled: it measures at t = 0, period, 2 period, …, just before each instant,
        and holds its outputs until the next one.  Without a period it is continuous.

        Parameters
        ----------
        function : callable, array_like, or linear system
            A function ``u = function(t, y)`` of the time and the inputs y (ny,), which returns the outputs u (nu,), a
            number if there is one.  With `state` it is ``u, x = function(t, y, x)``: it returns the new state too, or
            the rate of the state if it is continuous.  It must not store anything between calls.

            Or gains (nu, ny), or a state-space system or transfer function of python-control or scipy.signal: negative
            feedback, as by `control.feedback` and `control.lqr`, of reference - y.  A discrete system has its period.
        inputs : sequence of str (ny,)
            Coordinates and deformations, and rates of these and of slips by a prime; a sampled one also accelerations
            (two primes), ``force:…``, and internal states.
        outputs : sequence of str (nu,)
            Coordinates, deformations or slips on which it acts; positive where it does positive work as they grow, as
            loads do.  They become free, and so do the deformations that a continuous controller measures.
        name : str
            Results have its outputs as ``name.u``, or ``name.u0``, ``name.u1``, …, and its state as ``name.x0``, …
        period : float, optional
            [s]; none for a continuous one.
        delay : float
            Of a sampled controller: from an instant to the change of its outputs [s]; it may be longer than the period.
            Before the first change the outputs are zero.
        limits : (low, high), optional
            Of the outputs, each a number or one for each output; None or infinite for none.
        anti_windup : float, array_like (nx, nu), or "clamp", optional
            Keeps integrators from winding up while an output v is beyond its limits and u is the limited one:

            - A time constant T of a linear system [s]: its integral parts track the limited outputs.  It gives the
              gains L = V (C V)⁺ / T, or times the period if sampled, with the eigenvectors V of the integrators.
            - Gains L of any controller: x' = f + L (u - v), or for the next state x = f + L (u - v) if sampled.
            - "clamp" for sampled ones: the integral part of an output stops where it would grow further beyond the
              limit.  Of a function the whole own state stops.
        state : array_like (nx,), optional
            Initial own state of a function or a system.
        reference : mapping of str to float
            Wanted values of inputs of gains or a linear system; zero where none is given.

        Raises
        ------
        ModelError
            Unknown names, with the nearest ones; sizes that differ; a delay without a period.
        CompilerError
            Gains or a linear system without a period are compiled, and there is no C compiler.

        See Also
        --------
        System.stepper : A loop of your own around a system.

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
        owner = f"controller '{new_name(name, 'controller')}'"
        if any(z.name == name for z in self.controllers) or name in self.nodes or name in self.instances:
            raise ModelError(f"{owner}: this name is taken; choose another with name='…'")
        given = _listed(owner, "inputs", inputs), _listed(owner, "outputs", outputs)
        measured, driven = given
        _check_inputs(self, owner, measured)
        wanted = _wanted(owner, measured, reference)
        sizes = len(measured), len(driven)
        rule, step, start = rule_of(owner, function, sizes, state, wanted, period)
        lag = not_negative(delay, owner, "delay")
        if lag and step is None:
            raise ModelError(
                f"{owner}: a continuous controller has no delay; give a period, or a system with a Padé approximation"
            )
        low, high = _limits(owner, limits, len(driven))
        c = Controller(name, measured, driven, rule, low, high, step, lag)
        c = replace(c, windup=anti_windup_of(c, anti_windup))
        if c.slots > MOST_SLOTS:
            raise ModelError(
                f"{owner}: {c.slots} outputs would be delayed at once (delay {lag:g} s, period {step:g} s); "
                f"{MOST_SLOTS} are possible"
            )
        add = add_continuous if step is None else add_sampled
        add(self, c, start.tolist())
        self.controllers.append(c)


def _listed(owner: str, what: str, given: Any) -> tuple[str, ...]:
    """Names, each once and at least one."""
    found = names(given, f"{owner}: {what}")
    if not found or len(set(found)) < len(found):
        raise ModelError(f"{owner}: {what} {list(found)}; name one or more, each once")
    return found


def _check_inputs(model: Controllers, owner: str, inputs: Sequence[str]) -> None:
    """Refuse names that do not exist; whether they can be measured is checked when the model is built."""
    known = [*known_names(model), *(z for law in model.laws for z in law.states)]
    for name in inputs:
        base = parts(name)[0]
        if base not in known:
            raise ModelError(f"{owner}: input: {unknown(base, known)}")


def _wanted(owner: str, inputs: Sequence[str], reference: Any) -> Array | None:
    """The reference of each input; None if none is given."""
    if reference is None:
        return None
    given = numbers(reference, owner, "reference")
    for other in given.keys() - set(inputs):
        raise ModelError(f"{owner}: the reference '{other}' is not measured; it measures {', '.join(inputs)}")
    return np.array([given.get(z, 0.0) for z in inputs])


def _limits(owner: str, limits: Any, nu: int) -> tuple[Array, Array]:
    """Lower and upper limits (nu,) of the outputs."""
    if limits is None:
        return np.full(nu, -np.inf), np.full(nu, np.inf)
    if not isinstance(limits, tuple | list | np.ndarray) or len(limits) != 2:
        raise ModelError(f"{owner}: limits {limits!r:.60}; give two, (low, high)")
    low, high = (_limit(owner, z, nu, sign) for z, sign in zip(limits, (-np.inf, np.inf), strict=True))
    if np.any(low >= high):
        raise ModelError(f"{owner}: limits {limits!r:.60}; the lower one must be less than the upper one")
    return low, high


def _limit(owner: str, given: Any, nu: int, none: float) -> Array:
    """One limit for each output."""
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
