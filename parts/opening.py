"""Opens any flexel file: results and models."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from flexel.base.arguments import path_of
from flexel.base.errors import FlexelError
from flexel.parts.model import Model
from flexel.parts.model_file import read_parts
from flexel.results.saved.loading import load_result

if TYPE_CHECKING:
    from flexel.results.flexure_result import Flexure
    from flexel.results.linearization import Linearization
    from flexel.results.motion import Motion
    from flexel.results.periodic_motion import PeriodicSolution
    from flexel.results.saved.spacar_records import SpacarRecords


def load(path: str | Path) -> Model | Motion | Linearization | PeriodicSolution | Flexure | SpacarRecords:
    """Load a result or a model from a file written by its `save`, or a result of SPACAR: .sbd, .sbm, .ltv.

    Results are .nc, .npz, .mat or .csv, models .json.  Nothing in a result is executed.  A model that names functions
    imports their modules, as the program that saved it did: load it only if you trust its source.

    A result has the same names and units as when it was saved, without a model; `System.restore` attaches its states to
    a model again.  In SPACAR's `.sbd` positions are p1, p2 ..., orientations o1, o2 ..., nodes of warping w1, w2 ...,
    and beams in space beam1, beam2 ..., as in `fx.read_spacar`; the deformations of other elements are element7.e1 ...,
    in SPACAR's signs.

    Returns
    -------
    Model, Motion, Linearization, PeriodicSolution, Flexure or SpacarRecords
        The saved object; from SPACAR, .sbd gives a motion, .sbm and .ltv records of matrices.

    Raises
    ------
    ModelError
        A file that is missing, damaged, or from another program.
    FlexelError
        If a package that the format needs is missing.

    Examples
    --------
    >>> motion = fx.load("bicycle.nc")  # doctest: +SKIP
    >>> more = system.simulate(5.0, start=system.restore(motion))  # doctest: +SKIP
    >>> m = fx.load("bicycle.json")  # doctest: +SKIP
    """
    path = path_of(path, "load")
    if path.suffix.lower() == ".json":
        gravity, parts = read_parts(path)
        try:
            return Model.of(gravity, parts)
        except FlexelError as error:
            raise type(error)(f"load '{path}': {error}") from error
    return load_result(path)
