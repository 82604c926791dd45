"""Linearized equations of a system, of many variants of it, and root loci."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import array, mapping
from flexel.base.arrays import Array
from flexel.base.blas import in_one_thread
from flexel.base.errors import ModelError
from flexel.model.controller import refuse_sampled
from flexel.model.quantities import history
from flexel.model.state import State, own_state
from flexel.results.analyses.linearized_variants import LinearizedMany
from flexel.results.analyses.variant_runs import Recomputation, Runner, Values
from flexel.results.linearization import Linearization, as_linearization
from flexel.results.linearizations import Linearizations, RootLoci
from flexel.system import CoreSystem


@in_one_thread
def linearize(system: CoreSystem, state: State | None = None) -> Linearization:
    """Linearize analytically about a state (the initial one by default).

    Functions of continuous controllers are differentiated numerically, and must be smooth there and within limits.
    Sampled controllers hold their outputs; `Linearization.sampled` closes their loop.

    Warns
    -----
    RangeWarning
        If a beam is bent or twisted by more than 15° within one element.

    Examples
    --------
    >>> lin = system.linearize(motion[-1])  # doctest: +SKIP
    >>> lin.eigenvalues()  # doctest: +SKIP
    """
    return as_linearization(CoreSystem.linearize(system, state))


@in_one_thread
def linearize_many(
    system: CoreSystem,
    state: State | Callable[[Any], State] | None = None,
    *,
    parameters: Mapping[str, Any] | None = None,
    rates: Mapping[str, Any] | None = None,
    threads: int | None = None,
    progress: bool | None = None,
) -> Linearizations:
    """Linearize the equations of many variants, and at many rates of each.

    Parameters
    ----------
    state : State or callable, optional
        The state to linearize about, with the accelerations and forces of each variant; the initial one by
        default.  Or a function of the system of a variant that returns it: ``lambda s: s.equilibrium()``.
    parameters : mapping of name to array_like (variants,)
        As in `simulate_many`.
    rates : mapping of name to array_like (rates,)
        Rates of any quantities at the position of the state, all others as small as possible; every variant is
        linearized at all of them.
    threads, progress
        As in `simulate_many`.

    Raises
    ------
    ModelError, FlexelError
        As `simulate_many`.

    Warns
    -----
    IncompleteWarning
        As `simulate_many`.
    """
    values = Values(system, parameters, {}, "linearize_many")
    many = _many(system, state, values, rates, "linearize_many")
    return _linearized(system, values, many, "linearize_many", threads, progress)


@in_one_thread
def root_loci(
    system: CoreSystem,
    state: State | None = None,
    *,
    rates: Mapping[str, Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    of: Sequence[str] | None = None,
    threads: int | None = None,
    progress: bool | None = None,
) -> RootLoci:
    """Track the eigenvalues of steady motions over a rate, or over a parameter, as branches.

    Each state is confirmed to be steady; where it is not, the steady motion nearest to it is computed.

    Parameters
    ----------
    state : State, optional
        Gives the position; the initial state by default.
    rates : mapping of name to array_like (np,)
        The loci run over the first of them.
    parameters : mapping of name to array_like
        The loci run over the first of them if no rates are given; with rates there are loci for each variant.
    of : sequence of str, optional
        Dynamic degrees of freedom, decoupled from the others, whose loci are wanted; all by default.
    threads, progress
        As in `simulate_many`.

    Raises
    ------
    ModelError
        Neither rates nor parameters; and as `simulate_many`.
    LinearizationError
        If the degrees of freedom in `of` are not decoupled from the others.

    Warns
    -----
    IncompleteWarning
        As `simulate_many`.
    UnsteadyWarning
        If the fastest of the states is steady for an instant only, or its coefficients vary in time.

    Examples
    --------
    >>> loci = bike.root_loci(rates={"rear hub.x": speeds}, of=["lean.angle", "steer.angle"])  # doctest: +SKIP
    >>> loci.plot("loci.png")  # doctest: +SKIP
    """
    if not mapping(rates, "root_loci", "rates") and not mapping(parameters, "root_loci", "parameters"):
        raise ModelError("root_loci: give rates or parameters over which the loci run")
    values = Values(system, parameters, {}, "root_loci")
    many = _many(system, state, values, rates, "root_loci", steady=True)
    found = _linearized(system, values, many, "root_loci", threads, progress)
    axis = found.rates if found.rates else found.parameters
    name = next(iter(axis))
    run = axis[name]
    if run.ndim != 1:
        raise ModelError(f"root_loci: '{name}' has several components; let the loci run over '{name}[0]'")
    full = f"{name}'" if found.rates else name
    unit = history(system.structure, full).unit if found.rates else values.units[name]
    _check_lasting(found)
    alone = not found.rates and len(found.parameters) == 1
    again = MatrixAt(system, many, name, of) if alone else None
    return RootLoci(full, run, found if of is None else found.reduced(of), unit, again)


class MatrixAt:
    """The state matrix at other values of the parameter over which loci run.

    Parameters
    ----------
    system : CoreSystem
    many : LinearizedMany
    name : str
        Of the parameter.
    of : sequence of str, optional
        Degrees of freedom whose loci are wanted.
    """

    def __init__(self, system: CoreSystem, many: LinearizedMany, name: str, of: Sequence[str] | None) -> None:
        self._system, self._many, self._name, self._of = system, many, name, of

    def __call__(self, value: float) -> Array:
        """Return the state matrix (n, n) at a value of the parameter."""
        values = Values(self._system, {self._name: [value]}, {}, "root_loci")
        found = _linearized(self._system, values, self._many, "root_loci", 1, False)
        return np.asarray((found if self._of is None else found.reduced(self._of)).state_matrices[0])


def _check_lasting(found: Linearizations) -> None:
    """Warn of loci whose states do not last, or whose coefficients vary: at the fastest one of the first variant."""
    good = next((i for i in range(len(found)) if i not in found.failed), None)
    if good is None:
        return
    rates = np.array(list(found.rates.values()))
    fastest = int(np.argmax(np.abs(rates).max(axis=0))) if rates.size else 0
    found.linearization(good, fastest)._check("root_loci")


def _many(
    system: CoreSystem,
    state: State | Callable[[Any], State] | None,
    values: Values,
    rates: Mapping[str, Any] | None,
    owner: str,
    steady: bool = False,
) -> LinearizedMany:
    refuse_sampled(system.structure.controllers, owner, "only linearize(…).sampled() closes its loop")
    if values.anew is not None and state is None:
        state = _initial
    first = (
        state
        if callable(state) and not isinstance(state, type)
        else own_state(system.structure, system.initial if state is None else state, owner)
    )
    if values.anew is not None and isinstance(first, State):
        raise ModelError(
            f"{owner}: the variants differ in geometry, and the state has the positions of one; give a function of "
            "the system instead, such as lambda s: s.equilibrium()"
        )
    given = mapping(rates, owner, "rates")
    columns = {name: np.atleast_1d(array(column, owner, f"rate '{name}'")) for name, column in given.items()}
    sizes = {name: column.shape for name, column in columns.items()}
    if any(len(shape) != 1 for shape in sizes.values()) or len(set(sizes.values())) > 1:
        raise ModelError(f"{owner}: rates have shapes {sizes}; give equally many numbers for each")
    if callable(first) and columns:
        raise ModelError(f"{owner}: give rates, or a function for the state, which may set them itself")
    return LinearizedMany(system, first, columns, steady)


def _linearized(
    system: CoreSystem,
    values: Values,
    many: LinearizedMany,
    owner: str,
    threads: int | None,
    progress: bool | None,
) -> Linearizations:
    runner: Runner[dict[str, Array]] = Runner(system, values, lambda system, _: many.blocks(system))
    runner.run(threads, progress)
    runner.report(owner)
    dynamic, kinematic, _ = many.role_names
    return Linearizations(
        **many.stacked(runner.results, values.count),
        dynamic=dynamic,
        kinematic=kinematic,
        internal=tuple(system.structure.internal),
        parameters=values.given,
        rates=many.rates,
        failed=runner.failed,
        recompute=Recomputation(system, values, many.linearization),
    )


def _initial(system: CoreSystem) -> State:
    return system.initial
