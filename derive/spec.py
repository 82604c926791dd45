"""What the runtime reads about elements and laws: the classes of the entries of ``generated/table.py``.

Plain Python: the one module of ``derive`` that the runtime imports, without SymPy.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isqrt, prod
from typing import Any

Parameters = Mapping[str, Any]  # arrays or sequences of numbers
FORMULA_NUMBERS = "formula_numbers"  # the parameter of a law that holds the numbers of a formula
_NEGLIGIBLE = 1e-9  # of a period, relative to the largest of its terms


def triangle(size: int) -> int | None:
    """Return the rows of a symmetric matrix whose upper triangle has this many entries; None if no matrix has."""
    rows = (isqrt(8 * size + 1) - 1) // 2
    return rows if rows * (rows + 1) == 2 * size else None


@dataclass(frozen=True)
class NodeSpec:
    """Node of an element: a "point", "frame", "slope", "warping", "planar_point", "planar_angle" or "planar_slope"."""

    name: str
    kind: str

    @property
    def planar(self) -> bool:
        """Whether it is a node in the plane."""
        return self.kind.startswith("planar_")


@dataclass(frozen=True)
class ParameterSpec:
    """Parameter of an element or a law, with its number of components.

    sign: what each component must be ("positive", "not negative", "not zero", "at least one", "any"), () for any; or
    ("semidefinite",) for the upper triangle of a matrix without negative eigenvalues.
    """

    name: str
    size: int
    unit: str
    doc: str
    sign: tuple[str, ...] = ()


@dataclass(frozen=True)
class TermSpec:
    """A number times powers of components of parameters, (name, component, exponent) each."""

    factor: float
    powers: tuple[tuple[str, int, int], ...] = ()

    def value(self, parameters: Parameters) -> float:
        """Return its value for values of the parameters."""
        return self.factor * prod(float(parameters[name][i]) ** n for name, i, n in self.powers)


@dataclass(frozen=True)
class DeformationSpec:
    """Deformation; free: free by default (else rigid), period: a sum, kind: a word of `flexel.derive.declare.words`.

    kinked: its derivatives jump at configurations that motions reach.
    """

    name: str
    unit: str
    free: bool
    period: tuple[TermSpec, ...] = ()
    kind: str = ""
    kinked: bool = False

    def repeats(self, parameters: Parameters) -> float:
        """Return the length after which it repeats, for values of the parameters; zero if it does not."""
        terms = [term.value(parameters) for term in self.period]
        length = abs(sum(terms))
        # equal radii, say: a difference due to rounding is not a period
        return length if length > _NEGLIGIBLE * max(map(abs, terms), default=0.0) else 0.0


@dataclass(frozen=True)
class SlipSpec:
    """Slip; free: free by default (else zero)."""

    name: str
    unit: str
    free: bool


@dataclass(frozen=True)
class OutputSpec:
    """Output array of a kernel: its full shape and the flat indices of the entries that are stored.

    unit, draws, carrier: of the kernel "outputs", the unit of all entries, what a picture draws of it, and the names of
    the outputs, origin and axes, of the frame in whose axes it is.
    limit, beyond: of a range in which the element is valid, the largest first entry, and what is said beyond it.
    """

    name: str
    shape: tuple[int, ...]
    nonzeros: tuple[int, ...]
    unit: str = ""
    draws: str = ""
    carrier: tuple[str, ...] = ()
    limit: float = 0.0
    beyond: str = ""


@dataclass(frozen=True)
class KernelSpec:
    """Kernel: the arrays it reads and writes, in order, and its number of operations for one element."""

    inputs: tuple[str, ...]
    outputs: tuple[OutputSpec, ...]
    operations: int


@dataclass(frozen=True)
class ElementSpec:
    """Element: what `flexel_element` in kernels.h does not say.

    The words family and picture are those of `flexel.derive.declare.words`; span is the name of the element that
    carries a load along the length.  arm: where it is rigid, it holds a body together.
    """

    name: str
    digest: str
    doc: str
    source: str
    nodes: tuple[NodeSpec, ...]
    parameters: tuple[ParameterSpec, ...]
    deformations: tuple[DeformationSpec, ...]
    slips: tuple[SlipSpec, ...]
    kernels: dict[str, KernelSpec]
    family: str = ""
    picture: str = ""
    span: str = ""
    arm: bool = False

    @property
    def outputs(self) -> tuple[OutputSpec, ...]:
        """What it reports besides its deformations."""
        return self.kernels["outputs"].outputs if "outputs" in self.kernels else ()

    @property
    def gaps(self) -> bool:
        """Whether it is a contact: some of its deformations are gaps."""
        return any(d.kind == "gap" for d in self.deformations)

    def reports(self, *names: str) -> bool:
        """Whether its outputs have all these names."""
        return {*names} <= {output.name for output in self.outputs}

    @property
    def planar(self) -> bool:
        """Whether it is an element in the plane."""
        return all(node.planar for node in self.nodes)


@dataclass(frozen=True)
class InternalSpec:
    """Internal state of a law; one that lasts changes with displacements only."""

    name: str
    unit: str
    lasting: bool = False


@dataclass(frozen=True)
class LimitSpec:
    """Where a law's data end: the parameter's component that is the largest stress, and what the law does beyond."""

    parameter: str
    component: int
    beyond: str


@dataclass(frozen=True)
class BeginSpec:
    """What is zero where a law begins to act: linear in its first deformation and the rate of that.

    value, rate, rest: their coefficients and what is added, sums of terms.
    """

    value: tuple[TermSpec, ...]
    rate: tuple[TermSpec, ...]
    rest: tuple[TermSpec, ...]


@dataclass(frozen=True)
class ArgumentSpec:
    """Deformation or slip on which a law acts: its name, and its unit where it has to be this one."""

    name: str
    unit: str = ""

    def __str__(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    def fits(self, unit: str) -> bool:
        """Whether a quantity of that unit can be meant; an angle may count as a number."""
        return not self.unit or self.unit.replace("rad", "1") == unit.replace("rad", "1")


@dataclass(frozen=True)
class LawSpec:
    """Law of so many deformations and slips, with its internal states; kernels are "law" and "tangent"."""

    name: str
    digest: str
    doc: str
    deformations: int
    slips: int
    states: tuple[InternalSpec, ...]
    parameters: tuple[ParameterSpec, ...]
    kernels: dict[str, KernelSpec]
    limit: LimitSpec | None = None
    begins: tuple[BeginSpec, ...] = ()
    arguments: tuple[ArgumentSpec, ...] = ()
    timed: bool = False  # its stresses or rates depend on time

    @property
    def stores(self) -> bool:
        """Whether it may store energy: it declares one, or its kernels are not known."""
        outputs = self.kernels["law"].outputs if self.kernels else ()
        return not outputs or any(output.name == "U" and output.nonzeros for output in outputs)
