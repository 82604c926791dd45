"""Beams: an element between nodes with its reference triads, and the laws of its elastic modes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, replace
from typing import Any

import numpy as np

from flexel.base.arguments import array, flag, names, number, unknown, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.generated.table import ELEMENTS, LAWS
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.model.profiles import Section
from flexel.parts.beam_laws import STIFFNESSES, beam_laws, element_stiffnesses
from flexel.parts.beam_shapes import offset, planar_offset, planar_triads, triads
from flexel.parts.materials import MATERIALS, Material, Profile, profile_of
from flexel.parts.warping import is_wanted, nodes_of, section_inertia, twisted_stiffnesses

MODES = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")
STIFFNESS_OF = dict(zip(MODES, ("EA", "GJ", "EIy", "EIy", "EIz", "EIz"), strict=True))
ROTATIONS = ("classic", "logarithmic")


@part
class Beam(Part[None]):
    """Add a straight beam between two points; without a second frame, the rigid three-node beam.

    Raises
    ------
    ModelError
        Coincident points, a stiffness that is not positive, a beam that is neither rigid nor flexible, logarithmic
        rotations of a beam that is rigid, is first-order or has warping.

    Examples
    --------
    >>> m.beam("leaf", P, RP, Q, RQ, direction=(0, 1, 0), section=fx.Rectangle(0.3e-3, 20e-3), material="steel")
    ... # doctest: +SKIP
    """

    name: str = entry(
        "Name of the element.  Its deformations are ``name.elongation``, ``name.torsion`` and ``name.bend1`` to "
        "``name.bend4``; in a plane ``name.elongation``, ``name.bend1`` and ``name.bend2``; of a three-node beam "
        "those of `body_point`."
    )
    p: Node | str = entry("Point at its first end.")
    frame_p: Node | str = entry("Orientation at its first end.")
    q: Node | str = entry("Point at its second end.")
    frame_q: Node | str | None = entry("Orientation at its second end.", default=None)
    _: KW_ONLY
    rigid: bool = entry(
        "Make all modes rigid.  Otherwise the modes whose stiffness is given are flexible, the others rigid.",
        default=False,
    )
    direction: Sequence[float] | Array | None = array_quantity(
        "-", "Global direction of the section's y axis as drawn.", default=None
    )
    EA: float | None = quantity("N", "positive", "Axial stiffness.", default=None)
    GJ: float | None = quantity("N m²", "positive", "Torsional stiffness.", default=None)
    EIy: float | None = quantity(
        "N m²", "positive", "Bending stiffness about the section's y axis.", default=None
    )
    EIz: float | None = quantity(
        "N m²",
        "positive",
        "Bending stiffness about the section's z axis; planar beams use EA and EIz.",
        default=None,
    )
    GAy: float | None = quantity(
        "N",
        "positive",
        "Shear stiffness k G A [] for deflection in y; without it there is no shear deformation.",
        default=None,
    )
    GAz: float | None = quantity(
        "N", "positive", "Shear stiffness k G A [] for deflection in z.", default=None
    )
    EIw: float | None = quantity(
        "N m⁴",
        "positive",
        "Warping stiffness [], with ``warping=``; twist then shortens the beam if EA, EIy and EIz are also given.",
        default=None,
    )
    section: Section | None = entry(
        "Cross-section, with a material: they determine all stiffnesses, including shear, the mass and the rotary "
        "inertia, and replace the numbers; `State.stress` computes the stresses in it.",
        default=None,
    )
    material: Material | str | None = entry(
        'Material of the section, or the name of one, such as "steel".', default=None, named=MATERIALS.get
    )
    flexible: Sequence[str] | None = entry(
        "With a section: the flexible modes out of elongation, torsion, bend1 ... bend4; all by default; warping is "
        "flexible if torsion is.",
        default=None,
    )
    initial_strain: float = quantity("-", "any", "Elongation per length of the unstressed beam.", default=0.0)
    initial_curvature: Any = array_quantity(
        "1/m",
        "Uniform twist and curvatures [] about the section's y and z axes of the unstressed beam (3,); one curvature "
        "for a planar beam.  It is drawn straight and takes this shape when unloaded.",
        default=None,
        form="float or sequence of float, optional",
    )
    damping: float = quantity(
        "s", "not negative", "Kelvin–Voigt damping: ratio of damping to stiffness.", default=0.0
    )
    mass_per_length: float = quantity("kg/m", "not negative", "Mass per length.", default=0.0)
    inertia_per_length: Any = array_quantity(
        "kg m",
        "Rotary inertia per length [] about the section's x, y, z axes (3,); one number for a planar beam.",
        default=None,
        form="float or sequence of float, optional",
    )
    warping_inertia_per_length: float = quantity(
        "kg m³", "not negative", "Density times the warping constant [], with ``warping=``.", default=0.0
    )
    second_order: bool = entry(
        "Include second-order terms in the deformations (Meijaard 1996); without them more elements are needed.",
        default=True,
    )
    warping: bool | Sequence[Node | str] = entry(
        "Warping of the sections (non-uniform torsion, see `warping`): the warping nodes at p and q, or True for new "
        "free ones, ``<name>_warping_p`` and ``<name>_warping_q``.",
        default=False,
    )
    twist_shortens: bool = entry(
        "With ``warping=``: twist shortens the beam, so that tension makes it stiffer in torsion; False as in SPACAR's "
        "BEAMW.",
        default=True,
    )
    rotations: str = entry(
        '"classic": bending deformations are sines of angles, as in SPACAR.  "logarithmic": torsion and bending '
        "are linear in the rotation vector between the ends (Simo 1985, Crisfield 1990), which may be anything below "
        "half a turn; with shear stiffness, only this option converges to Reissner's rod in strong bending.",
        default="classic",
    )

    def lower(self, to: Lowering) -> None:
        """Add the element and its elastic laws."""
        ends = [(self.p, "point"), (self.frame_p, "frame"), (self.q, "point")]
        ends += [] if self.frame_q is None else [(self.frame_q, "frame")]
        planar, nodes = to.find_nodes(self.owner, *ends)
        profile = _profile(self)
        given = _stiffnesses(self, profile, planar)
        _check_kind(self, given, planar)
        variant = _variant(self, given, planar)
        mass = _mass(self, profile, planar)
        if self.frame_q is None:
            shape = planar_offset(nodes) if planar else offset(nodes, self.direction, self.owner)
            to.element(self.name, "planar_beam3" if planar else "beam3", nodes, shape | mass)
            to.instances[self.name] = replace(to.instances[self.name], profile=profile)
            return
        shape = planar_triads(nodes, self.owner) if planar else triads(nodes, self.direction, self.owner)
        stiffnesses = element_stiffnesses(given)
        if variant == "_warping":
            mass |= section_inertia(self.owner, profile, given, self.warping_inertia_per_length)
            stiffnesses |= twisted_stiffnesses(profile, given, self.twist_shortens)
            nodes += nodes_of(to, self.owner, self.name, self.warping)
        spec = ELEMENTS[("planar_beam" if planar else "beam") + variant]
        own = [parameter.name for parameter in spec.parameters]
        stiffnesses = {key: stiffnesses[key] for key in own if key in stiffnesses}
        to.element(self.name, spec, nodes, shape | mass | stiffnesses)
        elastic = {key: given.get(key) == value for key, value in stiffnesses.items()}
        to.instances[self.name] = replace(to.instances[self.name], profile=profile, elastic=elastic)
        _add_elastic_laws(to, self, given, float(shape["l0"][0]), planar)


def _profile(beam: Beam) -> Profile | None:
    """Return section and material of a beam; numbers that follow from them must not be given as well."""
    if beam.section is None and beam.material is None and beam.flexible is None:
        return None
    if beam.section is None:
        what = "material" if beam.material is not None else "flexible"
        raise ModelError(
            f"{beam.owner}: {what} is given without a section; give section=Rectangle(…) or the like"
        )
    stated = list(_stated(beam))
    stated += ["mass_per_length"] if beam.mass_per_length else []
    stated += [] if beam.inertia_per_length is None else ["inertia_per_length"]
    stated += ["warping_inertia_per_length"] if beam.warping_inertia_per_length else []
    if stated:
        raise ModelError(
            f"{beam.owner}: section and material already give {', '.join(stated)}; drop these or the section"
        )
    return profile_of(beam.section, beam.material, beam.owner)


def _stated(beam: Beam) -> dict[str, float]:
    """Return the stiffnesses given as numbers."""
    values = {key: getattr(beam, key) for key in STIFFNESSES}
    return {key: value for key, value in values.items() if value is not None}


def _stiffnesses(beam: Beam, profile: Profile | None, planar: bool) -> dict[str, float]:
    """Return the stiffnesses of the flexible modes; none of a rigid beam."""
    if profile is None:
        return _stated(beam)
    if flag(beam.rigid, beam.owner, "rigid") or beam.frame_q is None:
        return {}
    return _section_stiffness(beam.owner, profile, beam.flexible, planar)


def _section_stiffness(
    owner: str, profile: Profile, flexible: Sequence[str] | None, planar: bool
) -> dict[str, float]:
    """Return the stiffnesses of the flexible modes; bending in a plane takes both of its modes."""
    known = ("elongation", "bend1", "bend2") if planar else MODES
    chosen = known if flexible is None else names(flexible, f"{owner}: flexible")
    wrong = [mode for mode in chosen if mode not in known]
    if wrong or not chosen:
        raise ModelError(f"{owner}: flexible {list(chosen)}; name modes of this beam: {', '.join(known)}")
    keys = {"elongation": "EA", "bend1": "EIz", "bend2": "EIz"} if planar else STIFFNESS_OF
    for a, b in (("bend1", "bend2"), ("bend3", "bend4")):
        if (a in chosen) != (b in chosen):
            raise ModelError(
                f"{owner}: flexible has only one of {a} and {b}, which bend in one plane; name both"
            )
    wanted = {keys[mode] for mode in chosen}
    wanted |= {"GAy"} if "EIz" in wanted else set()
    wanted |= {"GAz"} if "EIy" in wanted else set()
    return {key: value for key, value in profile.stiffness().items() if key in wanted}


def _check_kind(beam: Beam, given: Mapping[str, float], planar: bool) -> None:
    """Raise a ModelError for options that contradict one another."""
    owner, rigid = beam.owner, flag(beam.rigid, beam.owner, "rigid")
    for shear, bending in (("GAy", "EIz"), ("GAz", "EIy")):
        if shear in given and bending not in given and not rigid:
            raise ModelError(
                f"{owner}: the shear stiffness {shear} has no effect without {bending}; give {bending} or drop it"
            )
    if rigid and given:
        raise ModelError(f"{owner}: rigid=True and a stiffness contradict one another; drop one")
    if beam.frame_q is not None and not (rigid or given):
        raise ModelError(f"{owner}: neither rigid nor flexible; give rigid=True or EA, GJ, EIy, EIz")
    if given and beam.frame_q is None:
        raise ModelError(
            f"{owner}: with one frame it is the rigid three-node beam; give a second frame to make it flexible"
        )
    if not given and beam.damping:
        raise ModelError(f"{owner}: damping has no effect on a rigid beam; drop it, or give a stiffness")
    unfit = sorted(given.keys() - {"EA", "EIz", "GAy"})
    unfit += ["direction"] if beam.direction is not None else []
    if planar and unfit:
        raise ModelError(
            f"{owner}: a planar beam takes EA, EIz and GAy, not {', '.join(unfit)}; drop the others"
        )


def _variant(beam: Beam, given: Mapping[str, float], planar: bool) -> str:
    """Return the ending of the element's type: with warping, with logarithmic rotations, of first order, or none."""
    second = flag(beam.second_order, beam.owner, "second_order")
    rho_iw = beam.warping_inertia_per_length
    warps = is_wanted(
        beam.owner,
        beam.warping,
        {
            "EIw": beam.EIw,
            "warping_inertia_per_length": rho_iw,
            "twist_shortens=False": not flag(beam.twist_shortens, beam.owner, "twist_shortens"),
        },
        {"a planar beam": planar, "a rigid beam": not given, "a first-order beam": not second},
    )
    logarithmic = _is_logarithmic(
        beam.owner,
        beam.rotations,
        {"a rigid beam": not given, "a first-order beam": not second, "a beam with warping": warps},
    )
    if warps:
        return "_warping"
    return "_logarithmic" if logarithmic else "" if second else "_first_order"


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


def _mass(beam: Beam, profile: Profile | None, planar: bool) -> dict[str, Array]:
    """Return mass and rotary inertia per length, from the section or as given."""
    size, per_length, inertia = 1 if planar else 3, beam.mass_per_length, beam.inertia_per_length
    if profile is not None:
        per_length, inertia = profile.mass()
        inertia = inertia[2] if planar else inertia
    J = np.zeros(size) if inertia is None else np.atleast_1d(array(inertia, beam.owner, "inertia_per_length"))
    if J.shape != (size,):
        raise ModelError(f"{beam.owner}: inertia_per_length has {J.size} numbers; give {size}")
    if np.any(J < 0):
        raise ModelError(
            f"{beam.owner}: inertia_per_length {J.tolist()} has a negative entry; give zero or more"
        )
    return {"rhoA": np.array([per_length]), "rhoJ": J}


def _add_elastic_laws(
    to: Lowering, beam: Beam, given: Mapping[str, float], length: float, planar: bool
) -> None:
    """Add the laws of the flexible modes, with the values of the element's parameters by their names."""
    laws = beam_laws(given, planar)
    flexible = [mode for law in laws for mode in law.modes]
    relaxed = _relaxed_shape(beam, flexible, planar)
    values = {**given, **relaxed, "l0": length, "damping": beam.damping}
    for law in laws:
        called = law.called
        parameters = {own: values[public] for own, public in called.items()}
        on = [f"{beam.name}.{mode}" for mode in law.modes]
        to.law(beam.owner, LAWS[law.law], on, parameters, label=beam.name, called=called)


def _relaxed_shape(beam: Beam, flexible: Sequence[str], planar: bool) -> dict[str, float]:
    """Return strain, twist and curvatures of the unstressed beam by the names of its parameters."""
    curvature, owner = beam.initial_curvature, beam.owner
    given = {"initial_strain": beam.initial_strain}
    acting: dict[str, tuple[str, ...]] = {"initial_strain": ("elongation",)}
    if planar:
        given["initial_curvature"] = (
            0.0 if curvature is None else number(curvature, owner, "initial_curvature")
        )
        acting["initial_curvature"] = ("bend1", "bend2")
    else:
        k = np.zeros(3) if curvature is None else vector(curvature, owner, "initial_curvature", 3)
        for i, modes in enumerate((("torsion",), ("bend1", "bend2"), ("bend3", "bend4"))):
            given[f"initial_curvature[{i}]"], acting[f"initial_curvature[{i}]"] = float(k[i]), modes
    stiff = [mode for key, value in given.items() if value for mode in acting[key] if mode not in flexible]
    if stiff:
        raise ModelError(
            f"{owner}: initial strain or curvature in {', '.join(stiff)}, which is rigid; make it flexible"
        )
    return given
