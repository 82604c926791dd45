"""The vocabularies by which a declaration states the purpose of an element, checked at once."""

from collections.abc import Iterable

from flexel.derive.definition_errors import ElementError

_ENDS = ("point frame point frame", "planar_point planar_angle planar_point planar_angle")
_CABLE = ("point slope point slope", "planar_point planar_slope planar_point planar_slope")
# What analyses treat alike, with the kinds of nodes that its elements may have. "" is an element of none of these, the
# default for user-defined ones.
FAMILIES: dict[str, tuple[str, ...]] = {
    "": (),
    "body": ("point", "frame", "point frame", "planar_point", "planar_angle", "planar_point planar_angle"),
    "norm": ("frame",),
    "truss": ("point point", "planar_point planar_point"),
    "link": ("point frame point", "planar_point planar_angle planar_point"),
    "beam": (*_ENDS, "point frame point frame warping warping"),
    "cable": _CABLE,
    "hinge": ("frame frame", "planar_angle planar_angle"),
    "bearing": _ENDS,
    "clamp": ("frame slope", "planar_angle planar_slope"),
    "wheel": ("point frame point", "planar_point planar_angle planar_angle"),
    "surface": ("point",),
    "tyre": ("point frame", "point frame point frame"),
    "belt": ("planar_point planar_angle planar_point planar_angle",),
    "gear": ("planar_point planar_angle planar_point planar_angle",),
    "contact": (
        "point slope point slope point frame",
        "planar_point planar_slope planar_point planar_slope planar_point planar_angle",
        "point point frame",
        "planar_point planar_point planar_angle",
        *_ENDS,
    ),
    "sensor": ("frame", "point frame", "planar_point planar_angle"),
    "span": ("point point", "planar_point planar_point", *_ENDS, *_CABLE),
}
# Families whose elements, where they are rigid, hold a body together: an over-constrained mechanism releases them last.
ARMS = ("link", "beam")
# What paints an element; "" is the line through its points.
PICTURES = (
    "",
    *(
        "bar",
        "beam",
        "bearing",
        "belt",
        "blade",
        "body",
        "contact",
        "disc",
        "gears",
        "hinge",
        "rope",
        "tyre",
        "wheel",
    ),
)
# What a picture draws of an output: nothing, a line in one of these styles, or a mark.
LINES = ("", "bar", "beam", "rope", "rim", "spoke", "valve", "axle", "mass")
# What a deformation is, apart from a measure: the gap of a contact (open where positive), the height of a contact that
# cannot be lost (held, although its force only pushes), or the norm of a frame's Euler parameters (which always holds).
KINDS = ("", "gap", "touch", "norm")
# What the numbers of a parameter must be; "semidefinite": together the upper triangle of a matrix, row by row, that has
# no negative eigenvalue.
SIGNS = ("any", "positive", "not negative", "not zero", "at least one")
MATRIX_SIGNS = ("semidefinite",)


def check_word(owner: str, what: str, word: object, known: Iterable[str]) -> None:
    """Raise ElementError for a word that is not in a vocabulary."""
    words = list(known)
    if word not in words:
        shown = ", ".join(f"'{word}'" for word in words)
        raise ElementError(f"{owner}: {what} '{word}' is unknown; choose one of {shown}")


def check_family(owner: str, family: str, kinds: Iterable[str]) -> None:
    """Raise ElementError for a family that is unknown, or whose elements have other nodes."""
    check_word(owner, "family", family, FAMILIES)
    own, given = FAMILIES[family], " ".join(kinds)
    if own and given not in own:
        shown = " or ".join(f"({', '.join(nodes.split())})" for nodes in own)
        raise ElementError(
            f"{owner}: the family '{family}' has the nodes {shown}, not ({', '.join(given.split())}); omit the "
            "family, or give its nodes"
        )
