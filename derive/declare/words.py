"""The vocabularies by which a declaration states the purpose of an element, checked at once."""

from collections.abc import Iterable

from flexel.derive.errors import ElementError

# What analyses treat alike. "" is an element of none of these, the default for user-defined ones; one that names a
# family has the nodes and parameters of the built-in elements in it.
FAMILIES = (
    "",
    *("body", "norm", "truss", "link", "beam", "cable", "hinge", "bearing", "clamp"),
    *("wheel", "surface", "tyre", "belt", "gear", "contact", "sensor", "span"),
)
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
        "cam",
        "contact",
        "disc",
        "flat cam",
        "gears",
        "hinge",
        "mass",
        "rope",
        "tyre",
        "wheel",
    ),
)
# What a deformation is, apart from a measure: the gap of a contact (open where positive), the norm of a frame's Euler
# parameters (which always holds), or the length l0 times the sine of an angle: of the twist between the ends, or of an
# end with the chord, where those of the same bending plane count together; or l0 times a component of the rotation
# vector between the ends, which jumps after half a turn, where those of the same axis are added.
KINDS = ("", "gap", "norm", "twist", "bend_y", "bend_z", "turn_x", "turn_y", "turn_z")
# What the numbers of a parameter must be; "semidefinite": together the upper triangle of a matrix, row by row, that has
# no negative eigenvalue.
SIGNS = ("any", "positive", "not negative", "not zero", "at least one")
MATRIX_SIGNS = ("semidefinite",)


def check_word(owner: str, what: str, word: object, known: Iterable[str]) -> None:
    """Raise ElementError for a word that is not in a vocabulary."""
    words = list(known)
    if word not in words:
        shown = ", ".join(f"'{z}'" for z in words)
        raise ElementError(f"{owner}: {what} '{word}' is unknown; choose one of {shown}")
