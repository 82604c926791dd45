"""Times root loci of the bicycle from the published linear equations, as BicycleParameters evaluates them.

The program contains these equations in closed form: it derives nothing from a model, and has no nonlinear motion.
"""

from __future__ import annotations

from collections.abc import Callable

from bench import bicycle
from bench.timing import Work
from flexel.examples import bicycle_data as data


def loci() -> Work:
    """Time M, C1, K0, K2 and the eigenvalues at the speeds of `bicycle.loci`, in one call."""
    from bicycleparameters.models import Meijaard2007Model
    from bicycleparameters.parameter_sets import Meijaard2007ParameterSet

    model = Meijaard2007Model(Meijaard2007ParameterSet({**data.BENCHMARK, "v": 1.0}, includes_rider=True))
    return Work(lambda: model.calc_eigen(v=bicycle.SPEEDS)[0], bicycle.worst)


ROWS: dict[str, Callable[..., Work]] = {"bicycle_loci": loci}
