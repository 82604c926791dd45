"""Outputs: what an element reports besides its deformations, such as section forces, and what a picture draws of it."""

from dataclasses import dataclass

from sympy import Expr, ImmutableDenseMatrix, Matrix, sympify

from flexel.derive.declare.words import LINES, check_word
from flexel.derive.definition_errors import ElementError


@dataclass(frozen=True)
class Output:
    """Quantity of an element: a function of coordinates, parameters, deformations, stresses and forces on its nodes.

    Parameters
    ----------
    name : str
        A name in C.
    unit : str
        SI unit of all components, "1" if they have none.
    values : Expr or Matrix
        One expression, a column of components, or a matrix with a row for each point or direction.  They may contain
        ``deformation.value``, ``deformation.stress``, ``slip.stress`` and the forces ``node.f``.
    draws : str, optional
        What a picture draws of it, one of `flexel.derive.declare.words.LINES`: the line through the points in
        its rows, or a mark at its only point.  Not drawn by default.
    carrier : tuple of str, optional
        Names of the outputs that are origin and axes (a row each) of a moving frame.  The points are then
        given in the axes of this frame, which carries them: a line that does not deform.  By default they are
        in global axes.
    """

    name: str
    unit: str
    values: Expr | Matrix
    draws: str = ""
    carrier: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        owner = f"output '{self.name}'"
        if not self.unit:
            raise ElementError(f"{owner} has no unit; give an SI unit, or '1'")
        check_word(owner, "draws", self.draws, LINES)
        if self.draws and self.unit != "m":
            raise ElementError(f"{owner} is drawn, but is in {self.unit}; points are in m")
        if self.carrier and not self.draws:
            raise ElementError(
                f"{owner} has a carrier, but is not drawn; say what it draws, or omit the carrier"
            )
        values = self.values
        if hasattr(values, "shape"):
            object.__setattr__(self, "values", ImmutableDenseMatrix(values))

    @property
    def exprs(self) -> tuple[Expr, ...]:
        """All components, row by row."""
        return tuple(self.values) if hasattr(self.values, "shape") else (sympify(self.values),)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the array: a column has one dimension, and so has a single number."""
        rows, columns = self.values.shape if hasattr(self.values, "shape") else (1, 1)
        return (rows,) if columns == 1 else (rows, columns)


@dataclass(frozen=True)
class ValidRange(Output):
    """Range in which an element is valid: a measure that every analysis compares with its limit.

    Beyond the limit a `RangeWarning` names the element with the largest measure.

    Parameters
    ----------
    name, unit : str
    values : Matrix
        The measure, such as an angle between the ends [°], and what else the warning tells, such as an error.
    limit : float
        Largest measure in the range.
    beyond : str
        What the warning says of an element, after its name, with fields in braces: ``{value}``, ``{error}`` (the two
        values), ``{digits}`` (the error in two digits), ``{where}`` (the instant, and how many others are beyond the
        limit) and ``{count}`` (the ratio of the measure to the limit, rounded up: a sufficient number of elements if
        the measure is shared among them).
    """

    limit: float = 0.0
    beyond: str = ""

    def __post_init__(self) -> None:
        super().__post_init__()
        owner = f"range '{self.name}'"
        if self.shape != (2,):
            raise ElementError(f"{owner} has values of shape {self.shape}; give two, a measure and an error")
        if not (isinstance(self.limit, (int, float)) and self.limit > 0):
            raise ElementError(
                f"{owner}: limit {self.limit!r} is not positive; give the largest measure that is valid"
            )
        try:
            self.beyond.format(value=1.0, error=1.0, digits="1", where="", count=1)
        except (KeyError, IndexError, ValueError) as error:
            raise ElementError(
                f"{owner}: beyond {self.beyond!r} has other fields than value, error, digits, where and count: {error}"
            ) from None
        if "{where}" not in self.beyond:
            raise ElementError(f"{owner}: beyond {self.beyond!r} does not say where; put {{where}} in it")
