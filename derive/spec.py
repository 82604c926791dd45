"""What the runtime knows of elements and laws: the classes of the entries of ``generated/table.py``.

Plain Python: the one module of ``derive`` that the runtime imports, without SymPy.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class NodeSpec:
    """Node of an element; kind is "point", "frame", "slope" or "planar_point", "planar_angle", "planar_slope"."""

    name: str
    kind: str


@dataclass(frozen=True)
class ParameterSpec:
    """Parameter of an element or a law, with its number of components."""

    name: str
    size: int
    unit: str
    doc: str


@dataclass(frozen=True)
class DeformationSpec:
    """Deformation; angle: has period 2 pi, free: free by default (else rigid)."""

    name: str
    unit: str
    angle: bool
    free: bool


@dataclass(frozen=True)
class SlipSpec:
    """Slip; free: free by default (else zero)."""

    name: str
    unit: str
    free: bool


@dataclass(frozen=True)
class OutputSpec:
    """Output array of a kernel: its full shape and the flat indices of the entries that are stored."""

    name: str
    shape: tuple[int, ...]
    nonzeros: tuple[int, ...]


@dataclass(frozen=True)
class KernelSpec:
    """Kernel: the arrays it reads and writes, in order, and its number of operations for one element."""

    inputs: tuple[str, ...]
    outputs: tuple[OutputSpec, ...]
    operations: int


@dataclass(frozen=True)
class ElementSpec:
    """Element: what `flexel_element` in kernels.h does not say."""

    name: str
    digest: str
    doc: str
    source: str
    nodes: tuple[NodeSpec, ...]
    parameters: tuple[ParameterSpec, ...]
    deformations: tuple[DeformationSpec, ...]
    slips: tuple[SlipSpec, ...]
    kernels: dict[str, KernelSpec]


@dataclass(frozen=True)
class InternalSpec:
    """Internal state of a law."""

    name: str
    unit: str


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
