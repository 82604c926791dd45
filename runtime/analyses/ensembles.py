"""Many variants of a system at once: motions, linearized equations, root loci."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Self

import numpy as np

from flexel.analyses.abreast import MotionRunner
from flexel.analyses.motions import Motions
from flexel.analyses.variant_motions import MotionOf
from flexel.analyses.variants import Again, Runner, Values, variant_of
from flexel.base.arguments import array, mapping, names, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.integration.driver import Run
from flexel.integration.outcome import stored_times
from flexel.mechanics.many import LinearizedMany
from flexel.results.ensemble import Ensemble
from flexel.results.linearizations import Linearizations, RootLoci
from flexel.results.quantities import history
from flexel.structure.controllers import refuse_sampled
from flexel.structure.parameters import Parameters
from flexel.structure.state import State, own_state

OPTIONS = (
    "method", "rtol", "atol", "step", "first_step", "max_step", "spectral_radius", "newton", "max_order", "rechoose"
)  # fmt: skip


class Ensembles(Motions):
    """Variants of a system with other values of parameters."""

    @property
    def parameters(self) -> Mapping[str, Array]:
        """Values of all parameters of elements and laws by name, such as ``rider.mass``; read only.

        Springs, dampers and beams have ``stiffness``, ``damping`` and ``preload`` of their deformations, after the name
        of the beam or of what the spring acts on: ``strut.elongation.stiffness``.
        """
        return Parameters(self.structure)

    def with_parameters(self, values: Mapping[str, Any]) -> Self:
        """A copy of the system with other values of some parameters; geometry cannot change.

        Raises
        ------
        ModelError
            An unknown name, with the nearest ones; a parameter on which positions depend.

        Examples
        --------
        >>> heavy = system.with_parameters({"rider.mass": 110.0})  # doctest: +SKIP
        """
        given = Values(self, values, {}, "with_parameters")
        if given.count != 1:
            raise ModelError(f"with_parameters: {given.count} values; give one for each parameter")
        return variant_of(self, given, 0)

    def simulate_many(
        self,
        duration: float,
        *,
        parameters: Mapping[str, Any] | None = None,
        initial: Mapping[str, Any] | None = None,
        start: State | None = None,
        outputs: Sequence[str] | None = None,
        times: Sequence[float] | Array | None = None,
        samples: int = 201,
        threads: int | None = None,
        progress: bool | None = None,
        **options: Any,
    ) -> Ensemble:
        """Motions of many variants side by side in threads, each with its own steps.

        The result of a variant depends neither on the others nor on the number of threads, to the last digit.

        Parameters
        ----------
        duration : float
            [s]
        parameters : mapping of name to array_like (variants,)
            Values of parameters, see `parameters`; (variants, size) for those of several numbers.  A single value holds
            for all variants.
        initial : mapping of name to array_like (variants,)
            Initial values of degrees of freedom and internal states; with a prime (``"lean.angle'"``) rates of any
            quantities.
        start : State, optional
            Gives what is not named; the initial state by default.
        outputs : sequence of str, optional
            What is kept, by the names of `Motion.series`; the degrees of freedom by default.
        times, samples
            When it is kept, as in `simulate`.
        threads : int, optional
            All processors by default.
        progress : bool, optional
            Progress bar on stderr; by default where stderr is a terminal.
        **options
            Method, tolerances and steps, as in `simulate`.

        Returns
        -------
        Ensemble
            Variants that failed are named in ``failed``.

        Raises
        ------
        ModelError
            An unknown name, with the nearest ones; numbers of values that differ; a parameter on which positions
            depend.
        FlexelError
            If all variants fail: the error of the first.

        Warns
        -----
        IncompleteWarning
            Some variants failed, or an interrupt (Ctrl-C) left them out: how many, and the first reason.
        """
        for wrong in (z for z in options if z not in OPTIONS):
            raise ModelError(f"simulate_many: {unknown(wrong, OPTIONS, 'option')}")
        values = Values(self, parameters, mapping(initial, "simulate_many", "initial"), "simulate_many")
        wanted = tuple(self.dynamic + self.kinematic if outputs is None else names(outputs, "simulate_many"))
        begin = own_state(self.structure, self.initial if start is None else start, "simulate_many")
        grid = stored_times(begin, duration, times, samples, "simulate_many")
        units = [history(self.structure, name).unit for name in wanted]

        motion = MotionOf(float(grid[-1] - begin.t), grid, start, values, options)

        def end(system: Motions, run: Run, why: str) -> tuple[Array, dict[str, int]]:
            found = system._ended(run, why, grid)
            rows = np.full((len(wanted), grid.size), np.nan)
            for row, name in zip(rows, wanted, strict=True):
                row[: len(found)] = found[name]
            return rows, found.statistics

        runner = MotionRunner(self, values, motion.begun, end)
        runner.run(threads, progress)
        runner.report("simulate_many")
        all_rows = np.full((len(wanted), values.count, grid.size), np.nan)
        statistics: list[dict[str, int]] = [{} for _ in range(values.count)]
        for i, (rows, counts) in runner.results.items():
            all_rows[:, i], statistics[i] = rows, counts
        series = {name: (z, unit) for name, z, unit in zip(wanted, all_rows, units, strict=True)}
        given = values.given | {name: np.array(z) for name, z in values.initial.items()}
        return Ensemble(grid, series, given, runner.failed, statistics, Again(self, values, motion))

    def linearize_many(
        self,
        state: State | Callable[[Any], State] | None = None,
        *,
        parameters: Mapping[str, Any] | None = None,
        rates: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: bool | None = None,
    ) -> Linearizations:
        """Linearized equations of many variants, and at many rates of each.

        Parameters
        ----------
        state : State or callable, optional
            The state about which is linearized, with the accelerations and forces of each variant; the initial one by
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
        values = Values(self, parameters, {}, "linearize_many")
        many = self._many(state, rates, "linearize_many")
        return self._linearized(values, many, "linearize_many", threads, progress)

    def root_loci(
        self,
        state: State | None = None,
        *,
        rates: Mapping[str, Any] | None = None,
        parameters: Mapping[str, Any] | None = None,
        of: Sequence[str] | None = None,
        threads: int | None = None,
        progress: bool | None = None,
    ) -> RootLoci:
        """Eigenvalues of steady motions over a rate, or over a parameter, as tracked branches.

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
            Dynamic degrees of freedom that are decoupled from the others, of which the loci are wanted; all by default.
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

        Examples
        --------
        >>> loci = bike.root_loci(rates={"rear hub.x": speeds}, of=["lean.angle", "steer.angle"])  # doctest: +SKIP
        >>> loci.plot("loci.png")  # doctest: +SKIP
        """
        if not mapping(rates, "root_loci", "rates") and not mapping(parameters, "root_loci", "parameters"):
            raise ModelError("root_loci: give rates or parameters over which the loci run")
        values = Values(self, parameters, {}, "root_loci")
        many = self._many(state, rates, "root_loci", steady=True)
        found = self._linearized(values, many, "root_loci", threads, progress)
        axis = found.rates if found.rates else found.parameters
        name = next(iter(axis))
        run = axis[name]
        if run.ndim != 1:
            raise ModelError(f"root_loci: '{name}' has several numbers; let the loci run over '{name}[0]'")
        full = f"{name}'" if found.rates else name
        unit = history(self.structure, full).unit if found.rates else values.units[name]
        return RootLoci(full, run, found if of is None else found.reduced(of), unit)

    def _many(
        self,
        state: State | Callable[[Any], State] | None,
        rates: Mapping[str, Any] | None,
        owner: str,
        steady: bool = False,
    ) -> LinearizedMany:
        refuse_sampled(self.structure.controllers, owner, "only linearize(…).sampled() closes its loop")
        first = (
            state
            if callable(state) and not isinstance(state, type)
            else own_state(self.structure, self.initial if state is None else state, owner)
        )
        given = mapping(rates, owner, "rates")
        columns = {name: np.atleast_1d(array(z, owner, f"rate '{name}'")) for name, z in given.items()}
        sizes = {name: z.shape for name, z in columns.items()}
        if any(len(z) != 1 for z in sizes.values()) or len(set(sizes.values())) > 1:
            raise ModelError(f"{owner}: rates have shapes {sizes}; give as many numbers for each")
        if callable(first) and columns:
            raise ModelError(f"{owner}: give rates, or a function for the state, which may set them itself")
        return LinearizedMany(self, first, columns, steady)

    def _linearized(
        self, values: Values, many: LinearizedMany, owner: str, threads: int | None, progress: bool | None
    ) -> Linearizations:
        runner: Runner[dict[str, Array]] = Runner(self, values, lambda system, _: many.blocks(system))
        runner.run(threads, progress)
        runner.report(owner)
        dynamic, kinematic, _ = many.role_names
        return Linearizations(
            **many.stacked(runner.results, values.count),
            dynamic=dynamic,
            kinematic=kinematic,
            internal=tuple(self.structure.internal),
            parameters=values.given,
            rates=many.rates,
            failed=runner.failed,
            again=Again(self, values, many.linearization),
        )
