"""Warping of beams: which beams have it, its nodes, and what their elements need for Vlasov's torsion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol, runtime_checkable

import numpy as np

from flexel.base.arguments import LARGEST
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.profiles import Section
from flexel.parts.materials import Profile
from flexel.parts.nodes import Warping

# Distance of the shear centre from the centroid over the radius of gyration, still taken as zero.
OFF_CENTRE = 1e-6


@runtime_checkable
class WarpingSection(Section, Protocol):
    """Interface of a section of a beam with warping."""

    @property
    def Iw(self) -> float:  # noqa: N802 (the letters of mechanics)
        """Warping constant [m⁶] about the shear centre."""

    @property
    def shear_centre(self) -> tuple[float, float]:
        """Position (y, z) of the shear centre, from the centroid [m]."""


def is_wanted(owner: str, warping: Any, stated: Mapping[str, Any], obstacles: Mapping[str, bool]) -> bool:
    """Whether the beam warps; refuses what contradicts this.

    Parameters
    ----------
    stated : mapping of str to number
        Numbers that only a beam with warping takes; None or zero: not given.
    obstacles : mapping of str to bool
        Kinds of beams that cannot warp, and whether this beam is one of them.
    """
    if warping is False:
        if unused := [key for key, value in stated.items() if value]:
            raise ModelError(
                f"{owner}: {', '.join(unused)} has no effect without warping; give warping=True or two nodes, or "
                "drop it"
            )
        return False
    if found := [what for what, is_so in obstacles.items() if is_so]:
        raise ModelError(
            f"{owner}: {found[0]} has no warping; drop warping=, or make it a flexible beam in space"
        )
    return True


def nodes_of(to: Lowering, owner: str, name: str, warping: Any) -> list[Node]:
    """Return the two warping nodes of a beam: as given, or new free ones."""
    if warping is True:
        ends = [f"{name}_warping_{end}" for end in "pq"]
        return [Warping(end).lower(to) for end in ends]
    pair = isinstance(warping, Sequence) and not isinstance(warping, str) and len(warping) == 2
    if not pair:
        raise ModelError(
            f"{owner}: warping {warping!r:.60} is neither True nor two nodes; give warping=(wp, wq) made by "
            "m.warping(…)"
        )
    found = [to.find_of_kind(node, ("warping",), owner) for node in warping]
    if found[0].name == found[1].name:
        raise ModelError(f"{owner}: both ends have the warping node '{found[0].name}'; give two nodes")
    return found


def section_inertia(
    owner: str, profile: Profile | None, given: dict[str, float], rho_iw: float
) -> dict[str, Array]:
    """Return the warping inertia of the section; a section's EIw is added to the given stiffnesses."""
    if profile is not None:
        iw = _warping_constant(owner, profile.section)
        given["EIw"], rho_iw = profile.material.E * iw, profile.material.rho * iw
    if missing := [key for key in ("GJ", "EIw") if not given.get(key)]:
        raise ModelError(f"{owner}: warping needs {' and '.join(missing)}; give {_remedy(profile, missing)}")
    return {"rhoIw": np.array([rho_iw])}


def twisted_stiffnesses(
    profile: Profile | None, given: Mapping[str, float], shortens: bool
) -> dict[str, float]:
    """Return EA, EIy and EIz of the element, by which a twist shortens it; without one of them it does not.

    A section gives all of them, also where modes are rigid.  An infinite EA stands for a beam that no twist shortens.
    """
    known = given if profile is None else profile.stiffness()
    if shortens and {"EA", "EIy", "EIz"} <= known.keys():
        return {key: known[key] for key in ("EA", "EIy", "EIz")}
    return {"EA": LARGEST}


def _remedy(profile: Profile | None, missing: Sequence[str]) -> str:
    if profile is None:
        return "them, or a section" if len(missing) > 1 else "it, or a section"
    if "EIw" in missing:
        return f"another section ({type(profile.section).__name__} does not warp) or drop warping="
    return "torsion among the flexible modes"


def _warping_constant(owner: str, section: Section) -> float:
    """Return Iw of a section that bends and twists about the same axis."""
    kind = type(section).__name__
    if not isinstance(section, WarpingSection):
        raise ModelError(
            f"{owner}: the section {kind} has no Iw and shear_centre; add these properties to it, or give EIw and "
            "the other stiffnesses as numbers"
        )
    y, z = section.shear_centre
    if np.hypot(y, z) > OFF_CENTRE * np.sqrt((section.Iy + section.Iz) / section.A):
        raise ModelError(
            f"{owner}: the shear centre of {kind} is at ({y:g}, {z:g}) m from its centroid, which couples torsion and "
            "bending; warping needs a section with both in one place, such as IBeam or Rectangle"
        )
    return float(section.Iw)
