"""Constants of an element or a law."""

from dataclasses import dataclass
from functools import cached_property

from sympy import Matrix, Symbol

from flexel.derive.declare.checks import check_text
from flexel.derive.declare.symbols import symbol
from flexel.derive.declare.words import MATRIX_SIGNS, SIGNS, check_word
from flexel.derive.definition_errors import ElementError
from flexel.derive.spec import triangle


@dataclass(frozen=True)
class Parameter:
    """Constant of an element or a law.

    Parameters
    ----------
    name : str
    size : int
        Number of components.
    unit : str
        SI unit, "1" if it has none.
    doc : str
        Its meaning, in a few words.
    components : tuple of str, optional
        Suffixes of the names of the components, 0, 1, ... by default.
    sign : str or tuple of str, optional
        The permitted sign, one word for all components or one for each: any, positive, not negative, not zero, at
        least one; or semidefinite for the upper triangle of a matrix without negative eigenvalues.
    """

    name: str
    size: int
    unit: str
    doc: str
    components: tuple[str, ...] = ()
    sign: str | tuple[str, ...] = "any"

    def __post_init__(self) -> None:
        if self.size < 1 or (self.components and len(self.components) != self.size):
            raise ElementError(f"parameter '{self.name}': size {self.size} does not fit {self.components}")
        if not self.unit:
            raise ElementError(f"parameter '{self.name}' has no unit; give an SI unit, or '1'")
        check_text("a declaration", f"parameter '{self.name}'", self.doc)
        self._check_sign(f"parameter '{self.name}'")

    def _check_sign(self, owner: str) -> None:
        if isinstance(self.sign, str):
            check_word(owner, "sign", self.sign, (*SIGNS, *MATRIX_SIGNS))
        elif len(self.sign) != self.size:
            raise ElementError(
                f"{owner}: {len(self.sign)} signs of {self.size} components; give one for each, or one word"
            )
        else:
            for word in self.sign:
                check_word(owner, "sign", word, SIGNS)
        if self.sign == "semidefinite" and triangle(self.size) is None:
            raise ElementError(
                f"{owner}: {self.size} components are not the upper triangle of a matrix; give 1, 3, 6, ..."
            )

    @cached_property
    def symbols(self) -> tuple[Symbol, ...]:
        """The symbol of a scalar, or one for each component."""
        if self.size == 1:
            return (symbol(self.name),)
        suffixes = self.components or tuple(str(i) for i in range(self.size))
        return tuple(symbol(f"{self.name}_{c}") for c in suffixes)

    @property
    def symbol(self) -> Symbol:
        """The symbol of a scalar parameter."""
        if self.size != 1:
            raise ElementError(f"parameter '{self.name}' has {self.size} components; use .vector")
        return self.symbols[0]

    @property
    def vector(self) -> Matrix:
        """The components as a column (size, 1)."""
        return Matrix(self.symbols)
