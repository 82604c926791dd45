"""Over-constraint of flexure mechanisms: released, with the stiffness that the section gives, or refused."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.errors import ConstraintError
from flexel.declare.beams import MODES, beam_stiffness, shear_numbers
from flexel.declare.materials import Profile
from flexel.mechanics.diagnose import quoted
from flexel.model import Model


def freed(model: Model, release: bool | Sequence[str]) -> tuple[list[str], list[dict[str, float]]]:
    """What was released because it over-constrained the mechanism, and the states of self-stress; or a refusal."""
    elastic = {z for law in model.laws for z in law.deformations}
    named = [] if isinstance(release, (bool, np.bool_)) else list(release)
    report = model.constraint_report()
    if named:
        _release(model, named, elastic)
        redundant, report = report.redundant, model.constraint_report()
    else:
        redundant = report.redundant
    if report.motions:
        moving = [z for z in report.motions[0] if z.startswith("node ")] or list(report.motions[0])
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
    """Release deformations; those of leaf springs get the stiffness that their section gives, as in SPACAR.

    Parameters
    ----------
    elastic : set of str
        Deformations of leaf springs that are flexible already.
    """
    model.release(*names)
    for beam in dict.fromkeys(z.split(".")[0] for z in elastic):
        instance = model.instances[beam]
        if not isinstance(instance.profile, Profile):
            continue
        l0, given = float(instance.parameters["l0"][0]), instance.profile.stiffness()
        modes, S = beam_stiffness(l0, MODES, given, *shear_numbers(l0, given))
        stiff = [z for z in modes if f"{beam}.{z}" in names and f"{beam}.{z}" not in elastic]
        if stiff:
            places = [modes.index(z) for z in stiff]
            model.spring([f"{beam}.{z}" for z in stiff], S[np.ix_(places, places)])
