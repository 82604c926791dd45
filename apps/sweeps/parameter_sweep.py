"""Builds and analyses a model at many points of its parameters."""

from __future__ import annotations

import inspect
import logging
import tempfile
import warnings
from collections.abc import Callable, Iterable, Mapping
from contextlib import ExitStack, closing
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.sweeps.dataset import dataset_of
from flexel.apps.sweeps.drive import Drive
from flexel.apps.sweeps.executors import Pool, pool_of
from flexel.apps.sweeps.points import Points, points_of
from flexel.apps.sweeps.store import DONE, FAILED, Store
from flexel.apps.sweeps.work import Job
from flexel.base.arguments import flag, path_of, unknown, whole
from flexel.base.callers import outside
from flexel.base.errors import IncompleteWarning, ModelError
from flexel.base.progress import progress_bar, seen
from flexel.base.stopping import StoppedError, stopping
from flexel.results.saved.record import require

if TYPE_CHECKING:
    import xarray

log = logging.getLogger("flexel.sweep")


def sweep(
    build: Callable[..., Any],
    points: Points | Mapping[str, Iterable[Any]] | Iterable[Mapping[str, Any]],
    analyse: Callable[[Any], Mapping[str, Any]],
    *,
    executor: Any = None,
    workers: int | None = None,
    folder: str | Path | None = None,
    chunk: int | None = None,
    retry_failed: bool = False,
    progress: bool | None = None,
) -> xarray.Dataset:
    """Build a model and analyse it at many points of its parameters, side by side.

    Results do not depend on the executor, on the number of workers or on the distribution of the points among them.

    Parameters
    ----------
    build : function
        ``build(**point)`` returns the `Model` at a point. Any other return value is passed on to `analyse`.
    points : mapping, Points or iterable of mappings
        A mapping gives the values of each parameter, and all combinations are computed; see also `grid`, `listed` and
        `sample`. An iterable gives the points one by one.
    analyse : function
        ``analyse(system)`` returns a dict of numbers and arrays, the same names and shapes at each point. The
        dimensions, labels and units of an xarray.DataArray are kept.
    executor : optional
        By default processes of joblib. "serial" computes in this process. Or an executor of `concurrent.futures`, a
        function that makes one (and a new one when its workers have died), or a Client of dask.distributed.
    workers : int, optional
        Number of points to compute at the same time; by default that of the executor.
    folder : path, optional
        Results go to this folder as they arrive. The same call continues an interrupted sweep. Without it
        they are kept in memory at the end.
    chunk : int, optional
        Number of points given to a worker at a time; by default as many as take 0.2 s.
    retry_failed : bool
        Recompute points that failed when the folder was written.
    progress : bool, optional
        Progress bar on stderr; by default where stderr is a terminal.

    Returns
    -------
    xarray.Dataset
        The results over the parameters, for points one by one over ``point``; NaN where a point failed.
        ``failed`` holds the message of each point that failed, and is empty at the others; the attribute
        ``message`` says how the sweep ended. After Ctrl-C the dataset holds the points computed so far.

    Raises
    ------
    ModelError
        For parameters that `build` does not take, bad points, another sweep in the folder; or if all points failed.

    Warns
    -----
    IncompleteWarning
        Some points failed: how many, and the first message.

    Examples
    --------
    >>> def build(length):
    ...     m = fx.Model(gravity=(0, 0, -9.81))
    ...     ...
    >>> def analyse(system):
    ...     return {"frequency": system.vibrations(count=1)[0].omega}
    >>> data = fx.sweep(build, {"length": [0.1, 0.2, 0.3]}, analyse)
    >>> data.frequency.sel(length=0.2)
    """
    require("xarray", "xarray")
    chosen = points_of(points)
    _check(build, chosen.names, analyse)
    if chunk is not None:
        whole(chunk, "sweep", "chunk")
    flag(retry_failed, "sweep", "retry_failed")
    with ExitStack() as stack:
        if folder is None:
            place = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        else:
            place = path_of(folder, "sweep")
        store = stack.enter_context(Store(place, chosen))
        show = seen(progress, "sweep")
        interrupted = False
        if any(True for _ in store.missing(retry_failed)):
            pool = pool_of(executor, workers)
            log.info("%d points, %d done before; %d workers", len(chosen), _count(store, DONE), pool.slots())
            job = Job.of(build, analyse, pickled=not pool.shares_memory)
            interrupted = _driven(job, chosen, store, pool, show, retry_failed, chunk)
        store.write()
        log.info("%d points done, %d failed", _count(store, DONE), _count(store, FAILED))
        data = dataset_of(place, chosen)
        return _reported(data if folder is not None else data.copy(deep=True), store, interrupted)


def _driven(
    job: Job, points: Points, store: Store, pool: Pool, show: bool, retry_failed: bool, chunk: int | None
) -> bool:
    """Compute the missing points; return whether Ctrl-C ended the sweep."""
    interrupted = True  # also by an error: chunks in progress are not waited for
    with closing(progress_bar(show, len(points), "point")) as bar:
        drive = Drive(job, points, store, pool, bar)
        try:
            with stopping():
                drive.run(retry_failed, chunk)
            interrupted = False
        except (StoppedError, KeyboardInterrupt):
            drive.salvage()
        finally:
            pool.close(at_once=interrupted)
    return interrupted


def _reported(data: xarray.Dataset, store: Store, interrupted: bool) -> xarray.Dataset:
    """Return the dataset with a message if it is incomplete; warn if points failed."""
    done, failed = (_count(store, code) for code in (DONE, FAILED))
    message = data.attrs["message"]
    if interrupted:
        data.attrs["message"] = f"interrupted: {message}"
    elif failed and not done:
        raise ModelError(f"sweep: {message}; fix the cause; with a folder, call with retry_failed=True")
    elif failed:
        warnings.warn(f"sweep: {message}", IncompleteWarning, stacklevel=outside())
    return data


def _count(store: Store, status: int) -> int:
    """Count the points with a status."""
    return int(np.count_nonzero(store.status == status))


def _check(build: Callable[..., Any], names: tuple[str, ...], analyse: Callable[[Any], Any]) -> None:
    """Check that build and analyse are functions, and that the points give the parameters of `build`, no others."""
    for what, given in (("build", build), ("analyse", analyse)):
        if not callable(given):
            raise ModelError(f"sweep: {what} is {given!r}; give a function")
    try:
        known = inspect.signature(build).parameters
    except ValueError as error:  # raised for some functions and classes written in C
        raise ModelError(
            f"sweep: the parameters of build {build!r} are unknown; give a Python function"
        ) from error
    takes = [
        name
        for name, parameter in known.items()
        if parameter.kind in (parameter.POSITIONAL_OR_KEYWORD, parameter.KEYWORD_ONLY)
    ]
    anything = any(parameter.kind is parameter.VAR_KEYWORD for parameter in known.values())
    for name in names:
        if name not in takes and not anything:
            raise ModelError(f"sweep: build has an {unknown(name, takes, 'parameter')}")
    missing = [name for name in takes if known[name].default is inspect.Parameter.empty and name not in names]
    if missing:
        raise ModelError(f"sweep: build needs '{missing[0]}', which the points do not give; add it to them")
