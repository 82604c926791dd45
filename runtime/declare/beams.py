"""Beams: the method of `Model` that adds one between nodes, its reference triads and its stiffness."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arguments import array, flag, names, not_negative, number, positive, unknown, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.beam_shapes import offset, planar_offset, planar_triads, triads
from flexel.declare.materials import Material, Profile, profile_of
from flexel.declare.sections import Section
from flexel.declare.springs import Springs
from flexel.declare.warping import MODES as WARPING
from flexel.declare.warping import is_wanted, nodes_of, parameters, stiffness
from flexel.generated.table import ELEMENTS
from flexel.structure.nodes import Node

MODES = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")
STIFFNESS_OF = dict(zip(MODES, ("EA", "GJ", "EIy", "EIy", "EIz", "EIz"), strict=True))
ROTATIONS = ("classic", "logarithmic")
PLANAR = (0, 4, 5)  # the modes of a planar beam among those of the spatial one; its plane has the normal z


class Beams(Springs):
    """Beams."""

    @whole_or_nothing
    def beam(
        self,
        name: str,
        p: Node | str,
        frame_p: Node | str,
        q: Node | str,
        frame_q: Node | str | None = None,
        *,
        rigid: bool = False,
        direction: Sequence[float] | Array | None = None,
        EA: float | None = None,
        GJ: float | None = None,
        EIy: float | None = None,
        EIz: float | None = None,
        GAy: float | None = None,
        GAz: float | None = None,
        EIw: float | None = None,
        section: Section | None = None,
        material: Material | str | None = None,
        flexible: Sequence[str] | None = None,
        initial_strain: float = 0.0,
        initial_curvature: Any = None,
        damping: float = 0.0,
        mass_per_length: float = 0.0,
        inertia_per_length: Any = None,
        warping_inertia_per_length: float = 0.0,
        second_order: bool = True,
        warping: bool | Sequence[Node | str] = False,
        rotations: str = "classic",
    ) -> None:
        """Add a straight beam between two points; without a second frame, the rigid three-node beam.

        Parameters
        ----------
        rigid : bool
            All modes rigid.  Otherwise the modes whose stiffness is given are flexible, the others rigid.
        direction : sequence of float (3,)
            Global direction of the section's y axis as drawn.
        EA, GJ, EIy, EIz : float
            Axial [N], torsional and bending stiffness [N m²] about the section's axes; planar beams use EA and EIz.
        GAy, GAz : float
            Shear stiffness k G A [N] for deflection in y and z; none means no shear deformation.
        EIw : float
            Warping stiffness [N m⁴], with ``warping=``; a twist then shortens the beam if EA, EIy, EIz are given too.
        section, material : Section and Material (or its name, such as "steel")
            Give all stiffnesses, shear included, the mass and the rotary inertia, instead of the numbers; the
            stresses of the section are found by `State.stress`.
        flexible : sequence of str, optional
            With a section: the modes that deform, of elongation, torsion, bend1 ... bend4; all by default; warping
            deforms with torsion.
        initial_strain : float
            Elongation per length of the unstressed beam.
        initial_curvature : sequence of float (3,), or float for a planar beam
            Uniform twist and curvatures about the section's y and z axes [1/m] of the unstressed beam; it is
            drawn straight and takes this shape when unloaded.
        damping : float
            Kelvin–Voigt damping: ratio of damping to stiffness [s].
        mass_per_length : float
            [kg/m]
        inertia_per_length : sequence of float (3,), or float for a planar beam
            Rotary inertia per length [kg m] about the section's x, y, z axes.
        warping_inertia_per_length : float
            Density times the warping constant [kg m³], with ``warping=``.
        second_order : bool
            Second-order terms in the deformations (Meijaard 1996); without them more elements are needed.
        warping : True or two nodes
            Sections warp (non-uniform torsion, see `warping`): the warping nodes at p and q, or True for free ones of
            its own, ``<name>_warping_p`` and ``<name>_warping_q``.
        rotations : str
            "classic": a bending deformation is the sine of an angle, as in SPACAR.  "logarithmic": torsion and bending
            are linear in the rotation vector between the ends (Simo 1985, Crisfield 1990), which may be any below half
            a turn; with shear stiffness only this converges to Reissner's rod in strong bending.

        Raises
        ------
        ModelError
            Points that coincide, a stiffness that is not positive, a beam neither rigid nor flexible, logarithmic
            rotations of a beam that is rigid, of first order or warps.

        Examples
        --------
        >>> m.beam("leaf", P, RP, Q, RQ, direction=(0, 1, 0), section=fx.Rectangle(0.3e-3, 20e-3), material="steel")
        ... # doctest: +SKIP
        """
        owner = f"beam '{name}'"
        ends = [(p, "point"), (frame_p, "frame"), (q, "point")]
        planar, nodes = self._find_nodes(owner, *ends, *([] if frame_q is None else [(frame_q, "frame")]))
        numbers = {"EA": EA, "GJ": GJ, "EIy": EIy, "EIz": EIz, "GAy": GAy, "GAz": GAz, "EIw": EIw}
        given = {key: positive(z, owner, key) for key, z in numbers.items() if z is not None}
        rho_iw = not_negative(warping_inertia_per_length, owner, "warping_inertia_per_length")
        profile = None
        if section is not None or material is not None or flexible is not None:
            stated = [*given, *(["mass_per_length"] if mass_per_length else [])]
            stated += [] if inertia_per_length is None else ["inertia_per_length"]
            stated += ["warping_inertia_per_length"] if rho_iw else []
            profile = _profile(owner, section, material, stated)
            mass_per_length, inertia_per_length = profile.mass()
            if planar:
                inertia_per_length = inertia_per_length[2]
            if not flag(rigid, owner, "rigid") and frame_q is not None:
                given = _section_stiffness(owner, profile, flexible, planar)
        _check_kind(owner, flag(rigid, owner, "rigid"), given, frame_q is not None)
        if not given and damping:
            raise ModelError(f"{owner}: damping has no effect on a rigid beam; drop it, or give a stiffness")
        unfit = sorted(given.keys() - {"EA", "EIz", "GAy"}) + (["direction"] if direction is not None else [])
        if planar and unfit:
            raise ModelError(
                f"{owner}: a planar beam takes EA, EIz and GAy, not {', '.join(unfit)}; drop the others"
            )
        second = flag(second_order, owner, "second_order")
        warps = is_wanted(
            owner,
            warping,
            {"EIw": EIw, "warping_inertia_per_length": rho_iw},
            {"a planar beam": planar, "a rigid beam": not given, "a first-order beam": not second},
        )
        logarithmic = _is_logarithmic(
            owner,
            rotations,
            {"a rigid beam": not given, "a first-order beam": not second, "a beam with warping": warps},
        )
        mass = _mass(owner, planar, mass_per_length, inertia_per_length)
        if frame_q is None:
            shape = planar_offset(nodes) if planar else offset(nodes, direction, owner)
            self._place(name, "planar_beam3" if planar else "beam3", nodes, shape | mass)
            self.instances[name] = replace(self.instances[name], profile=profile)
            return
        shape = planar_triads(nodes, owner) if planar else triads(nodes, direction, owner)
        l0 = float(shape["l0"][0])
        phi_y, phi_z = shear_numbers(l0, given)
        shear = {"phi_z": phi_y} if planar else {"phi_y": phi_y, "phi_z": phi_z}
        suffix = "_logarithmic" if logarithmic else "" if second else "_first_order"
        if warps:
            mass |= parameters(owner, profile, given, rho_iw)
            nodes += nodes_of(self, owner, name, warping)
            suffix = "_warping"
        element = ("planar_beam" if planar else "beam") + suffix
        self._place(name, element, nodes, shape | mass | {key: np.array([z]) for key, z in shear.items()})
        self.instances[name] = replace(self.instances[name], profile=profile)
        modes = [d.name for d in ELEMENTS[element].deformations if d.name not in WARPING]
        free, S = beam_stiffness(l0, modes, given, phi_y, phi_z)
        e0 = _initial_deformations(owner, planar, l0, free, initial_strain, initial_curvature)
        if given:
            D = not_negative(damping, owner, "damping") * S
            self._add_linear(owner, [f"{name}.{z}" for z in free], S, D, -S @ e0, name)
        if warps:
            S = stiffness(l0, given["GJ"], given["EIw"])
            self._add_linear(
                owner, [f"{name}.{z}" for z in WARPING], S, damping * S, np.zeros(2), f"{name} warping"
            )


def _is_logarithmic(owner: str, rotations: Any, obstacles: Mapping[str, bool]) -> bool:
    """Whether torsion and bending are linear in the rotation between the ends; refuses what contradicts this."""
    if not isinstance(rotations, str) or rotations not in ROTATIONS:
        raise ModelError(f"{owner}: {unknown(str(rotations), ROTATIONS, 'rotations=')}")
    found = [what for what, is_so in obstacles.items() if is_so]
    if rotations == "logarithmic" and found:
        raise ModelError(
            f"{owner}: {found[0]} has no logarithmic rotations; drop rotations=, or make it a flexible beam with "
            "second-order terms and without warping"
        )
    return rotations == "logarithmic"


def _profile(owner: str, section: Any, material: Any, stated: Sequence[str]) -> Profile:
    """Section and material of a beam; numbers that they imply must not be given as well."""
    if section is None:
        what = "material" if material is not None else "flexible"
        raise ModelError(f"{owner}: {what} is given without a section; give section=Rectangle(…) or the like")
    if stated:
        raise ModelError(
            f"{owner}: section and material give {', '.join(stated)} already; drop these, or drop the section"
        )
    return profile_of(section, material, owner)


def _section_stiffness(
    owner: str, profile: Profile, flexible: Sequence[str] | None, planar: bool
) -> dict[str, float]:
    """Stiffnesses of the flexible modes; bending in a plane takes both of its modes."""
    known = ("elongation", "bend1", "bend2") if planar else MODES
    chosen = known if flexible is None else names(flexible, f"{owner}: flexible")
    wrong = [z for z in chosen if z not in known]
    if wrong or not chosen:
        raise ModelError(f"{owner}: flexible {list(chosen)}; name modes of this beam: {', '.join(known)}")
    keys = {"elongation": "EA", "bend1": "EIz", "bend2": "EIz"} if planar else STIFFNESS_OF
    for a, b in (("bend1", "bend2"), ("bend3", "bend4")):
        if (a in chosen) != (b in chosen):
            raise ModelError(
                f"{owner}: flexible has only one of {a} and {b}; both bend in one plane, name both"
            )
    wanted = {keys[z] for z in chosen}
    wanted |= {"GAy"} if "EIz" in wanted else set()
    wanted |= {"GAz"} if "EIy" in wanted else set()
    return {key: z for key, z in profile.stiffness().items() if key in wanted}


def _initial_deformations(
    owner: str, planar: bool, l0: float, free: Sequence[str], strain: Any, curvature: Any
) -> Array:
    """Deformations of the unstressed beam, for its flexible modes."""
    eps = number(strain, owner, "initial_strain")
    if curvature is None:
        k = np.zeros(3)
    elif planar:
        k = np.array([0.0, 0.0, number(curvature, owner, "initial_curvature")])
    else:
        k = vector(curvature, owner, "initial_curvature", 3)
    bends = k * l0**2 / 2
    if planar:
        e0 = {"elongation": eps * l0, "bend1": bends[2], "bend2": bends[2]}
    else:
        values = (eps * l0, k[0] * l0**2, bends[1], bends[1], bends[2], bends[2])
        e0 = dict(zip(MODES, values, strict=True))
    stiff = [z for z, value in e0.items() if value and z not in free]
    if stiff:
        raise ModelError(
            f"{owner}: initial strain or curvature in {', '.join(stiff)}, which is rigid; make it flexible"
        )
    return np.array([e0[z] for z in free])


def _check_kind(owner: str, rigid: bool, given: Mapping[str, float], two_frames: bool) -> None:
    flexible = bool(given)
    for shear, bending in (("GAy", "EIz"), ("GAz", "EIy")):
        if shear in given and bending not in given and not rigid:
            raise ModelError(
                f"{owner}: the shear stiffness {shear} has no effect without {bending}; give {bending} or drop it"
            )
    if rigid and flexible:
        raise ModelError(f"{owner}: rigid=True and a stiffness contradict one another; drop one")
    if two_frames and not (rigid or flexible):
        raise ModelError(f"{owner}: neither rigid nor flexible; give rigid=True or EA, GJ, EIy, EIz")
    if flexible and not two_frames:
        raise ModelError(
            f"{owner}: with one frame it is the rigid three-node beam; give a second frame to make it flexible"
        )


def _mass(owner: str, planar: bool, per_length: float, inertia: Any) -> dict[str, Array]:
    size = 1 if planar else 3
    J = np.zeros(size) if inertia is None else np.atleast_1d(array(inertia, owner, "inertia_per_length"))
    if J.shape != (size,):
        raise ModelError(f"{owner}: inertia_per_length has {J.size} numbers; give {size}")
    if np.any(J < 0):
        raise ModelError(f"{owner}: inertia_per_length {J.tolist()} has a negative entry; give zero or more")
    return {"rhoA": np.array([not_negative(per_length, owner, "mass_per_length")]), "rhoJ": J}


def shear_numbers(l0: float, given: Mapping[str, float]) -> tuple[float, float]:
    """Shear numbers (Φ_y, Φ_z) = 12 E I / (k G A l0²) of deflection in y and in z; 0 without shear stiffness."""
    phi_y = 12 * given.get("EIz", 0.0) / (given["GAy"] * l0**2) if "GAy" in given else 0.0
    phi_z = 12 * given.get("EIy", 0.0) / (given["GAz"] * l0**2) if "GAz" in given else 0.0
    return phi_y, phi_z


def bending_block(EI: float, phi: float, l0: float) -> Array:
    """Stiffness (2, 2) of the two bending modes of one plane."""
    return np.array([[4 + phi, -2 + phi], [-2 + phi, 4 + phi]]) * EI / ((1 + phi) * l0**3)


def beam_stiffness(
    l0: float, modes: Sequence[str], given: Mapping[str, float], phi_y: float, phi_z: float
) -> tuple[list[str], Array]:
    """Flexible modes, in the order of `modes`, and their stiffness matrix.

    Parameters
    ----------
    modes : sequence of str
        The element's deformations: six, or the three of a planar beam.
    given : mapping
        EA, GJ, EIy, EIz; modes without a stiffness are rigid.
    """
    K = np.zeros((6, 6))
    if "EA" in given:
        K[0, 0] = given["EA"] / l0
    if "GJ" in given:
        K[1, 1] = given["GJ"] / l0**3
    if "EIy" in given:
        K[2:4, 2:4] = bending_block(given["EIy"], phi_z, l0)
    if "EIz" in given:
        K[4:6, 4:6] = bending_block(given["EIz"], phi_y, l0)
    places = PLANAR if len(modes) == len(PLANAR) else range(6)
    keep = [i for i in places if K[i, i] > 0]
    names = dict(zip(places, modes, strict=True))
    return [names[i] for i in keep], K[np.ix_(keep, keep)]
