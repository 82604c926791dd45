"""Tables of the input language: keywords, how they are written, and the elements with their modes.

Sources: manual SPACAR95 (Schwab and Meijaard 2000); Meijaard, Papadopoulos, Ruina and Schwab (2007), Proc. R. Soc. A
463:1955, electronic supplement; UT SPACAR.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

DIALECTS = ("delft", "twente")
WARPING = ("spacar", "vlasov")  # what a beam with warping is: SPACAR's element, or flexel's own


@dataclass(frozen=True)
class Usage:
    """Syntax of a keyword: the form, the least and largest count of numbers, or of words of any text.

    `meaning` is the keyword by which the rest of the program knows it, if that is another one.
    """

    form: str
    least: int
    most: int
    text: bool = False
    meaning: str = ""


@dataclass(frozen=True)
class ElementMode:
    """A deformation of a SPACAR element: flexel's name, and the ratio of SPACAR's value to flexel's.

    `scale` names a length of the element that is also part of the factor: "radius" of a wheel's rim (slips are not
    normalized), "radii", the sum of those of two gears.  `node` is the index of a node of flexel's element whose only
    coordinate, times the square of the length, is SPACAR's value.
    """

    name: str
    factor: float = 1.0
    scale: str = ""
    node: int | None = None


@dataclass(frozen=True)
class ElementType:
    """An element of the input language.

    Attributes
    ----------
    nodes : tuple of str
        Kinds of its nodes.
    numbers : tuple of str
        Numbers after the nodes; an optional direction has its names in brackets.
    modes : tuple of ElementMode
        Its deformations in SPACAR's order.
    slips : tuple of int
        Which of the modes are slips.
    stiffness : tuple of str
        The entries of ESTIFF and EDAMPP.
    assumed : str
        How an ambiguity of the published descriptions is resolved; reported to the user where it matters.
    order : tuple of int
        Indices (from 0) of the nodes of flexel's element among SPACAR's; empty if they are the same.
    """

    nodes: tuple[str, ...]
    modes: tuple[ElementMode, ...]
    numbers: tuple[str, ...] = ()
    optional: int = 0
    slips: tuple[int, ...] = ()
    stiffness: tuple[str, ...] = ()
    assumed: str = ""
    order: tuple[int, ...] = ()


P, F, XY, B, W = "point", "frame", "planar_point", "planar_angle", "warping"
AXIS = ("x", "y", "z")
BENDS = tuple(ElementMode(name) for name in ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4"))
PLANAR_BENDS = (
    ElementMode("elongation"),
    ElementMode("bend1", -1.0),
    ElementMode("bend2", -1.0),
)  # the spatial beam's sign is opposite
HINGE = (ElementMode("angle"), ElementMode("bend2", -1.0), ElementMode("bend1"))
BODY_POINT = (ElementMode("along"), ElementMode("across1"), ElementMode("across2"))
_BEAM = ("EA", "GJ", "EIy", "EIz")

ELEMENTS: dict[str, ElementType] = {
    "BEAM": ElementType((P, F, P, F), BENDS, AXIS, 3, stiffness=(*_BEAM, "EIy/GAk", "EIz/GAk")),
    "BEAMNL": ElementType((P, F, P, F), BENDS, AXIS, 3, stiffness=_BEAM),
    "BEAMW": ElementType(
        (P, F, W, P, F, W),
        (*BENDS, ElementMode("warp1", node=4), ElementMode("warp2", node=5)),
        AXIS,
        3,
        stiffness=(*_BEAM, "EIy/GAk", "EIz/GAk", "EIw"),
        assumed="a node of warping is the twist per length [rad/m], modes 7 and 8 are l0² times it",
        order=(0, 1, 3, 4, 2, 5),
    ),
    "RBEAM": ElementType((P, F, P), BODY_POINT, AXIS, 3),
    "TRUSS": ElementType((P, P), (ElementMode("elongation"),), stiffness=("EA",)),
    "HINGE": ElementType((F, F), HINGE, AXIS, 3, stiffness=("S1", "S2", "S3")),
    "BEARING": ElementType(
        (P, F, P, F),
        (ElementMode("axial"), ElementMode("radial1"), ElementMode("radial2"), *HINGE),
        AXIS,
        3,
        stiffness=("S1", "S2", "S3", "S4", "S5", "S6"),
        assumed="modes 1 to 3 are read as the displacements along and across the axis, 4 to 6 as those of a HINGE",
    ),
    "SURFACE": ElementType(
        (P,),
        (ElementMode("height"),),
        tuple(f"c{i}" for i in range(1, 11)),
        assumed="c1 ... c10 are read as the factors of x², y², z², xy, yz, xz, x, y, z and 1",
    ),
    "L2MIN1": ElementType((F,), (ElementMode("norm"),)),
    "WHEEL": ElementType(
        (P, F, P),
        (
            ElementMode("radius"),
            ElementMode("plane"),
            ElementMode("surface"),
            ElementMode("longitudinal", scale="radius"),
            ElementMode("lateral", scale="radius"),
        ),
        AXIS,
        slips=(4, 5),
    ),
    "PINBODY": ElementType((P, F, P), BODY_POINT),
    "PLBEAM": ElementType((XY, B, XY, B), PLANAR_BENDS, stiffness=("EA", "EI")),
    "PLBEAMNL": ElementType((XY, B, XY, B), PLANAR_BENDS, stiffness=("EA", "EI")),
    "PLHINGE": ElementType((B, B), (ElementMode("angle"),), stiffness=("St",)),
    "PLTRUSS": ElementType((XY, XY), (ElementMode("elongation"),), stiffness=("EA",)),
    "PLBELT": ElementType((XY, B, XY, B), (ElementMode("elongation"),), ("r1", "r2"), stiffness=("EA",)),
    "PLBEAR": ElementType(
        (XY, B, XY, B),
        (ElementMode("along"), ElementMode("across"), ElementMode("angle")),
        stiffness=("Sx", "Sy", "St"),
    ),
    "PLPINBOD": ElementType((XY, B, XY), (ElementMode("along"), ElementMode("across"))),
    "PLWHEEL": ElementType(
        (XY, B, B),
        (ElementMode("longitudinal"), ElementMode("lateral")),
        ("r", "x", "y"),
        slips=(1, 2),
        assumed="o1 is read as the heading and o2 as the turn about the axle; modes 1 and 2 are the slips along and "
        "across the direction (x, y)",
    ),
    "GEAR": ElementType(
        (XY, B, XY, B),
        (ElementMode("mesh", scale="radii"),),
        ("r1", "r2"),
        stiffness=("S",),
        assumed="it is read as the planar pair `GEAR e p1 o1 p2 o2 r1 r2` of pitch radii r1, r2, internal gears "
        "negative",
    ),
}

_FORMS: dict[str, tuple[str, int, int]] = {
    # nodes
    "X": ("n x ...", 2, 5),
    "XY": ("n x y", 3, 3),
    "BETA": ("n beta", 2, 2),
    "XYZ": ("n x y z", 4, 4),
    "LAMBDA": ("n lambda0 lambda1 lambda2 lambda3", 5, 5),
    # roles
    **dict.fromkeys(("FIX", "INPUTX", "DYNX", "KINX"), ("n [i ...]", 1, 5)),
    **dict.fromkeys(("RLSE", "INPUTE", "DYNE", "KINE", "LINE"), ("e [i ...]", 1, 9)),
    "ENHC": ("e1 i1 e2 i2", 4, 4),
    # initial values
    "XD": ("n i v", 3, 3),
    "XDD": ("n i a", 3, 3),
    "E": ("e i value", 3, 3),
    "ED": ("e i rate", 3, 3),
    "EDD": ("e i acceleration", 3, 3),
    "STARTDE": ("e i value rate", 3, 4),
    "TIME": ("t", 1, 1),
    "DIR": ("e x y z", 4, 4),
    "LENGTH0": ("e l0", 2, 2),
    # dynamics
    "MASS": ("n m | n Izz | n Ixx Ixy Ixz Iyy Iyz Izz", 2, 7),
    "EMASS": ("e rhoA [Jxx Jyy Jzz Jyz, or J of a PLBEAM] [Jw of a BEAMW]", 1, 16),
    "ESTIFF": ("e ...", 1, 16),
    "EDAMPP": ("e ...", 1, 16),
    "ESIG": ("e sigma1 ...", 2, 9),
    "FORCE": ("n ...", 2, 5),
    "DELXF": ("n ...", 2, 5),
    "TORQUEL": ("n T ...", 2, 4),
    "GRAVITY": ("gx gy gz", 2, 3),
    "DELINPX": ("n i change", 3, 3),
    "DELINPE": ("e i change", 3, 3),
    # inputs and outputs of the linear model
    "INPUTF": ("k n i", 3, 3),
    "INPUTS": ("k e i", 3, 3),
    "OUTX": ("k n i", 3, 3),
    "OUTXP": ("k n i", 3, 3),
    "OUTE": ("k e i", 3, 3),
    "OUTEP": ("k e i", 3, 3),
    # settings
    "TIMESTEP": ("n T (Delft) or T n (Twente)", 2, 2),
    "HMAX": ("h", 1, 1),
    "ITERSTEP": ("iterations steps [tolerance ...]", 2, 6),
    "MAXITERAT": ("n", 1, 1),
    "EPSKIN": ("eps", 1, 1),
    "EPSINT": ("eps", 1, 1),
    "EPSIND": ("eps", 1, 1),
    "ERROR": ("abs rel", 1, 2),
    "FORCEMODE": ("0|1|2", 1, 1),
    "ANIMATE": ("", 0, 9),
    "MATASC": ("", 0, 9),
    "OUTLEVEL": ("...", 0, 9),
}

KEYWORDS: dict[str, Usage] = {key: Usage(*form) for key, form in _FORMS.items()}
KEYWORDS["JOBID"] = Usage("text", 0, 99, text=True)
ROUTINES = ("USERINP", "USERSIG")  # written by the user, in MATLAB
KEYWORDS |= {key: Usage("name", 1, 9, text=True) for key in ROUTINES}
PICTURE = ("VISUALIZATION", "VISUALIZ")  # the rest is not part of the model, see `flexel.apps.spacar.picture`
KEYWORDS["VISUALIZATION"] = Usage("", 0, 99, text=True)
# of these, the first block names components; in later ones (Twente) they give values
VALUES = {
    "INPUTX": Usage("n i x0 [v0 a0] after END HALT; components of inputs come before it", 3, 5),
    "INPUTE": Usage("e i e0 [v0 a0] after END HALT; modes of inputs come before it", 3, 5),
}
VALUES = {key: replace(usage, meaning=f"{key} VALUES") for key, usage in VALUES.items()}
for _key, _type in ELEMENTS.items():
    _ends = [f"n{_i}" for _i in range(1, len(_type.nodes) + 1)]
    _most = 1 + len(_ends) + len(_type.numbers)
    KEYWORDS[_key] = Usage(" ".join(("e", *_ends, *_type.numbers)), _most - _type.optional, _most)
_BY_FIRST_LETTERS = {
    "MAXITERAT",
    "FORCEMODE",
    "VISUALIZATION",
}  # longer than the eight significant characters

SYNONYMS = {"XM": "MASS", "EM": "EMASS", "XF": "FORCE", "EDAMP": "EDAMPP", "PLPINBODY": "PLPINBOD"}
SYNONYMS |= {key[:8]: key for key in _BY_FIRST_LETTERS}

# keywords that identify the dialect of a file
DELFT_ONLY = frozenset(
    "MASS EMASS FORCE EDAMPP ENHC LINE EPSKIN EPSINT EPSIND HMAX TORQUEL LENGTH0 EOF".split()
)
TWENTE_ONLY = frozenset(
    "XM EM XF EDAMP ESIG KINX KINE RBEAM BEAMW GRAVITY DELXF DELINPX DELINPE STARTDE ITERSTEP OUTLEVEL INPUTF INPUTS "
    "OUTX OUTXP OUTE OUTEP USERINP USERSIG VISUALIZATION VISUALIZ".split()
)
ENDS_OF_TWENTE = frozenset({"END HALT", "END END", "HALT"})  # Delft's END occurs alone

UNSUPPORTED = {
    "TUBE": "use a BEAM, or a TRUSS whose elongation is an input for a telescope",
    "PLTUBE": "use a PLBEAM, or a PLTRUSS whose elongation is an input for a telescope",
    "SCREW": "relate rotation and travel in Python: flexel convert, then m.relation(...)",
    "LGEOMY": "give the geometry by the coordinates of the nodes",
    "RESTART": "in Python, motion[-1] is a state to start from: system.simulate(T, start=motion[-1])",
}

# settings without effect here, and the reason
WITHOUT_EFFECT = {
    "MAXITERAT": "iterations stop at rounding, or with an error",
    "EPSKIN": "positions are iterated to rounding",
    "EPSINT": "motions are integrated with tolerances 1e-9 or smaller",
    "EPSIND": "motions are integrated with tolerances 1e-9 or smaller",
    "ERROR": "motions are integrated with tolerances 1e-9 or smaller",
    "FORCEMODE": "all stresses and reactions are always computed",
    "ANIMATE": "pictures are made on demand, motion.animate(...)",
    "MATASC": "matrices are written with --out",
    "OUTLEVEL": "everything is kept; print what you need",
    "JOBID": "results are named after the file",
}
