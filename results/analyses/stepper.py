"""A system advanced by an external loop: hardware, a game, a learning algorithm, a controller."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np

from flexel.base.arguments import names, number, positive, vector
from flexel.base.arrays import Array
from flexel.base.blas import in_one_thread
from flexel.base.errors import FlexelError, ModelError
from flexel.base.shown import listed, prints
from flexel.base.time_functions import Held
from flexel.integration import methods
from flexel.integration.choose import CHEAPER, linear_algebra
from flexel.integration.dop853 import Dop853
from flexel.integration.driver import Run
from flexel.integration.methods import AUTO
from flexel.integration.minimal import MinimalRun
from flexel.integration.radau import Radau
from flexel.integration.step_method import StepMethod
from flexel.integration.steps import GeneralizedAlpha
from flexel.integration.stiffness import ALPHA, EXPLICIT, RADAU, few, suitable
from flexel.integration.watch import LOOK
from flexel.model.applied_loads import Load
from flexel.model.quantities import history
from flexel.model.state import State
from flexel.model.structure import Structure
from flexel.results.analyses.restoring import restored
from flexel.system import CoreSystem

METHODS = (AUTO, EXPLICIT, RADAU, ALPHA)
RTOL = 1e-6
log = logging.getLogger("flexel.simulate")


@dataclass(frozen=True)
class Saved:
    """The saved state of a stepper: its state, the values of its inputs, and how it goes on.

    Attributes
    ----------
    state : State
    inputs : tuple of float
    step : float or None
        Step of the integrator [s].
    method : str
    look : int or None
        Steps of the integrator up to the next comparison of methods; None if the method stays.
    """

    state: State
    inputs: tuple[float, ...]
    step: float | None
    method: str
    look: int | None


class Stepper:
    """A system advanced in constant steps, with inputs held within each step; made by `System.stepper`.

    ``stepper[name] = value`` sets an input, and ``stepper[name]`` reads any value or rate; `step` takes all
    inputs and returns all outputs at once.

    Attributes
    ----------
    dt : float
        Length of a step [s].
    inputs, outputs : tuple of str
        Names.

    Examples
    --------
    >>> stepper = system.stepper(0.01, inputs=["steer.angle"], outputs=["lean.angle"])  # doctest: +SKIP
    >>> while stepper.t < 5:
    ...     (lean,) = stepper.step([-40 * lean])  # doctest: +SKIP
    """

    def __init__(
        self,
        system: CoreSystem,
        dt: float,
        inputs: Sequence[str],
        outputs: Sequence[str],
        start: State | None,
        method: str,
        options: methods.Options,
    ) -> None:
        self.dt = positive(dt, "stepper", "dt")
        if not isinstance(method, str) or method not in METHODS:
            raise ModelError(f"stepper: method {method!r} is unknown; choose one of {', '.join(METHODS)}")
        self.inputs, self.outputs = names(inputs, "stepper: inputs"), names(outputs, "stepper: outputs")
        methods.check(method, options)
        self._asked, self._options = method, options
        self._held = [Held() for _ in self.inputs]
        self._plain = system
        self._system = _driven(system, self.inputs, self._held)
        self._places = _places(system.structure, self.outputs)
        self._read: dict[str, Any] = {}
        self._first = methods.start_of(system, method, start, options)
        self.reset()

    def _chosen(self) -> tuple[str, int | None]:
        """Return the method for the start, and the steps up to the first comparison with another one."""
        system = self._system
        if self._asked != AUTO:
            return self._asked, None
        if suitable(system, self._first).method == ALPHA:
            return ALPHA, None
        return EXPLICIT, None if system.roles.actuated or not few(system) else LOOK

    @in_one_thread
    def reset(self, start: State | None = None) -> Array:
        """Restart with all inputs zero; returns the outputs.

        Parameters
        ----------
        start : State, optional
            The state in which the stepper was made by default.
        """
        if start is not None:
            self._first = methods.start_of(self._system, self._asked, start, self._options)
        return self.restore(Saved(self._first, (0.0,) * len(self._held), None, *self._chosen()))

    def save(self) -> Saved:
        """Return the current state for `restore`; it can be pickled."""
        inputs = tuple(held.value for held in self._held)
        look = None if self._look is None else max(1, self._look - self._run.taken)
        return Saved(self.state, inputs, self._run.step, self.method, look)

    def restore(self, saved: Saved) -> Array:
        """Return to a saved state; returns the outputs there.

        Raises
        ------
        ModelError
            If `saved` is not from a stepper with the same inputs.
        """
        if not isinstance(saved, Saved) or len(saved.inputs) != len(self._held):
            raise ModelError(
                "stepper: restore takes what save() of this stepper, or of an equal one, returned"
            )
        for held, value in zip(self._held, saved.inputs, strict=True):
            held.value = value
        start = restored(self._system, saved.state)
        self._begin, self._count = start.t, 0
        options = self._options.with_first(saved.step)
        times = np.array([start.t, start.t + self.dt])
        run = methods.run_of(self._system, saved.method, start, times, self.dt, options)
        if not isinstance(run, MinimalRun | GeneralizedAlpha):
            raise ModelError(
                "stepper: every motion of the system is prescribed; nothing is left to be driven by inputs"
            )
        self._run, self._look = run, saved.look
        run.begin()
        self._changed = False
        return self._outputs()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle its arguments and its current state."""
        made = (self._plain, self.dt, self.inputs, self.outputs, None, self._asked, self._options)
        return _again, (made, self._first, self.save())

    @prints
    def __repr__(self) -> str:
        parts = f"in: {listed(self.inputs)}; out: {listed(self.outputs)}; {self.method}"
        return f"Stepper(t = {self.t:g} s, dt = {self.dt:g} s; {parts})"

    @property
    def method(self) -> str:
        """The method at present."""
        return self._run.name

    @property
    def t(self) -> float:
        """Time [s]."""
        return self._run.t

    @property
    def state(self) -> State:
        """The complete state, with accelerations and forces; computed on demand."""
        return self._run.result.states[-1]

    @in_one_thread
    def step(self, values: Sequence[float] | Array | None = None) -> Array:
        """Advance by dt.

        Parameters
        ----------
        values : array_like (inputs,), optional
            Inputs during this step and after it; the last ones by default.

        Returns
        -------
        ndarray (outputs,)
            The outputs at the end.

        Raises
        ------
        ModelError
            Inputs of a wrong number, or that are not finite.
        PositionError, DynamicsError
            If the motion cannot be continued; `t` and `state` belong to the last step.
        """
        if values is not None:
            self._set(values)
        run = self._run
        if self._changed:
            run.renew()
            self._changed = False
        until = self._begin + (self._count + 1) * self.dt
        run.go_on(until)
        if self._look is not None and run.taken >= self._look and isinstance(run, MinimalRun):
            self._compare(run, until)
        _advance(run, until)
        self._count += 1
        return self._outputs()

    def _compare(self, run: MinimalRun, until: float) -> None:
        """Go on with the other method if the next step costs less by that."""
        tolerances = methods.tolerances_of(self._system, self._options)
        other = Dop853 if run.name == RADAU else Radau

        def cost(kind: type[StepMethod]) -> float:
            trial = run.onwards(kind, tolerances)
            try:
                trial.once()
                _advance(trial, until)
            except FlexelError as error:
                log.debug("t = %.9g s: no step by %s: %s", run.t, kind.name, error)
                return np.inf
            more = linear_algebra(self._system) if kind is Radau else 0.0
            return trial.statistics["evaluations"] + trial.taken * more

        if CHEAPER * cost(other) < cost(type(run.method)):
            run.use(other, tolerances)
        self._look = 2 * run.taken

    def _set(self, values: Any) -> None:
        """Set all inputs; lists of floats, the usual argument in fast loops, need no conversion."""
        given = values.tolist() if type(values) is np.ndarray else values
        size = len(self._held)
        plain = type(given) is list and len(given) == size
        if not plain or not all(type(value) is float and isfinite(value) for value in given):
            given = vector(values, "stepper", "inputs", size).tolist()
        for held, value in zip(self._held, given, strict=True):
            held.value = value
        self._changed = True

    def __setitem__(self, name: str, value: float) -> None:
        if name not in self.inputs:
            raise ModelError(
                f"stepper: '{name}' is not one of its inputs ({', '.join(self.inputs) or 'none'}); name it in "
                "system.stepper(inputs=[…])"
            )
        self._held[self.inputs.index(name)].value = number(value, "stepper", f"input '{name}'")
        self._changed = True

    def __getitem__(self, name: str) -> float:
        if name not in self._read:
            self._read[name] = _places(self._system.structure, (name,))
        return float(self._values()[self._read[name][0]])

    def _outputs(self) -> Array:
        return np.asarray(self._values()[self._places])

    def _values(self) -> Array:
        """Return values and rates of deformations and coordinates, and internal states (2 (m + n) + nz,)."""
        at, z = self._run.instant
        return np.concatenate([at.e, at.x, at.ed, at.v, z])


def _advance(run: Run, until: float) -> None:
    """Take steps up to a time [s]."""
    while run.t < until:
        run.forward()


def _again(made: tuple[Any, ...], first: State, saved: Saved) -> Stepper:
    """Rebuild a stepper from a pickle: its arguments, its start, and its saved state."""
    stepper = Stepper(*made)
    stepper._first = restored(stepper._system, first)
    stepper.restore(saved)
    return stepper


def _driven(system: CoreSystem, inputs: Sequence[str], held: Sequence[Held]) -> CoreSystem:
    """Return the system with one more load for each input, whose value the stepper sets."""
    for name in inputs:
        system.structure.find(name, "stepper: input")
    loads = system.loads.with_others(Load(name, value) for name, value in zip(inputs, held, strict=True))
    found = copy(system)
    found._prepare(system.evaluation, loads, system.roles)
    return found


def _places(structure: Structure, outputs: Sequence[str]) -> Any:
    """Return the indices of the outputs in `Stepper._values`."""
    m, n, slips = structure.m, structure.n, structure.k
    found = []
    for name in outputs:
        quantity = history(structure, name)
        if quantity.base in structure.internal and not quantity.order:
            found.append(2 * (m + n) + structure.internal[quantity.base])
            continue
        i = structure.find(quantity.base) if quantity.base in structure.index else -1
        if quantity.order not in (0, 1) or i < 0 or m <= i < m + slips:
            raise ModelError(
                f"stepper: output '{name}' is not a value or a rate of a deformation or a coordinate; read "
                "accelerations, forces and slips from stepper.state"
            )
        found.append((i if i < m else i - slips) + quantity.order * (m + n))
    return np.array(found, dtype=np.intp)


@in_one_thread
def stepper(
    system: CoreSystem,
    dt: float,
    *,
    inputs: Sequence[str] = (),
    outputs: Sequence[str] = (),
    start: State | None = None,
    method: str = AUTO,
    rtol: float = RTOL,
    atol: float | None = None,
) -> Stepper:
    """Step the system at a constant interval, for user-written loops: hardware, games, learning, controllers.

    Parameters
    ----------
    dt : float
        Length of a step [s]; the integrator divides it as its tolerances require.
    inputs : sequence of str
        Coordinates, deformations or slips on which external forces act, held within each step, in addition to
        the loads of the model.
    outputs : sequence of str
        Coordinates, deformations, internal states, and rates (``"lean.angle'"``).
    start : State, optional
        The initial state by default.
    method : str
        auto: DOP853 or Radau, whichever takes fewer evaluations for one of the steps taken so far, compared again each
        time the number of steps of the integrator has doubled; generalized-alpha if a degree of freedom has no inertia,
        or there are very many.  DOP853, Radau and generalized-alpha stay.
    rtol, atol : float
        Tolerances; see `simulate`.

    Returns
    -------
    Stepper

    Raises
    ------
    ModelError
        An unknown name, method or option; a step that is not positive.
    """
    options = methods.Options(rtol=number(rtol, "stepper", "rtol"), atol=atol)
    return Stepper(system, dt, inputs, outputs, start, method, options)
