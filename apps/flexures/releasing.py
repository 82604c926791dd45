"""Releases over-constraint of flexure mechanisms, with the stiffness given by the section, or refuses it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.errors import ConstraintError
from flexel.base.shown import quoted
from flexel.parts.beam_matrix import beam_matrix
from flexel.parts.beams import MODES
from flexel.parts.materials import Profile
from flexel.parts.model import Model


def freed(model: Model, release: bool | Sequence[str]) -> tuple[list[str], list[dict[str, float]]]:
    """Release the over-constraint; return the released deformations and the states of self-stress, or refuse."""
    elastic = {name for law in model.laws for name in law.deformations}
    named = [] if isinstance(release, (bool, np.bool_)) else list(release)
    report = model.constraint_report()
    if named:
        _release(model, named, elastic)
        redundant, report = report.redundant, model.constraint_report()
    else:
        redundant = report.redundant
    if report.motions:
        moving = [name for name in report.motions[0] if name.startswith("node ")] or list(report.motions[0])
        raise ConstraintError(
            f"flexure: nothing resists a motion of {quoted(moving[:6])}; make elements flexible, "
            "connect or fix nodes, or prescribe the motion"
        )
    if report.redundant and (named or not release):
        among = list(dict.fromkeys(name for share in report.redundant for name in share))
        raise ConstraintError(
            f"flexure: over-constrained {len(report.redundant)} times, among {quoted(among[:10])}; make such modes "
            f"flexible, or release {quoted(report.release)} with options: release"
        )
    _release(model, report.release, elastic)
    return [*named, *report.release], redundant


def _release(model: Model, names: Sequence[str], elastic: set[str]) -> None:
    """Release deformations; those of leaf springs get the stiffness given by their section, as in SPACAR.

    Parameters
    ----------
    elastic : set of str
        Deformations of leaf springs that are flexible already.
    """
    model.release(*names)
    for beam in dict.fromkeys(name.split(".")[0] for name in elastic):
        instance = model.instances[beam]
        if not isinstance(instance.profile, Profile):
            continue
        stiff = [mode for mode in MODES if f"{beam}.{mode}" in names and f"{beam}.{mode}" not in elastic]
        if stiff:
            l0 = float(instance.parameters["l0"][0])
            S = beam_matrix(l0, stiff, instance.profile.stiffness())
            model.spring([f"{beam}.{mode}" for mode in stiff], S)
