"""Elements and laws of a model: a row of the table with its nodes or quantities and its parameters."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from flexel.base.arguments import LARGEST, array
from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.base.errors import CompilerError, ModelError
from flexel.base.shown import listed, prints
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.generated.table import ELEMENTS, LAWS


class Code(Protocol):
    """The compiled code of a user's element or law."""

    @property
    def address(self) -> int:
        """Address of its kernels; code from another process is loaded, or compiled, at first use."""


TABLES: dict[type, Mapping[str, Any]] = {ElementSpec: ELEMENTS, LawSpec: LAWS}


class _Row(Portable):
    """Common base of elements and laws: a specification, and kernels built in or compiled by the user.

    In a pickle a built-in specification is a name, and kernels of the user are their C code.
    """

    name: str
    spec: Any
    code: Code | None

    @property
    def kernels(self) -> int | None:
        """Address of a user's kernels; None if they are built in."""
        try:
            return None if self.code is None else self.code.address
        except RuntimeError as error:
            raise CompilerError(f"{self.spec.name} '{self.name}': {error}") from error

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields, with the name and digest of a built-in specification in its place."""
        state, spec = super().__getstate__(), self.spec
        built_in = TABLES[type(spec)].get(spec.name) is spec
        return state | {"spec": (type(spec), spec.name, spec.digest)} if built_in else state

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Set the fields; raise a ModelError if a built-in specification differs here."""
        if isinstance(state["spec"], tuple):
            kind, name, digest = state["spec"]
            spec = TABLES[kind].get(name)
            if spec is None or spec.digest != digest:
                raise ModelError(
                    f"{name} '{state['name']}': the pickle is from another version of flexel; build the model again, "
                    "or transfer results between versions with save and fx.load"
                )
            state = state | {"spec": spec}
        self.__dict__.update(state)


@dataclass(frozen=True)
class Instance(_Row):
    """One element of the model: a row of the element table between nodes, with its parameters."""

    name: str
    spec: ElementSpec
    nodes: tuple[str, ...]
    parameters: Mapping[str, Array]
    code: Code | None = None  # of a user-defined element; None: built in
    profile: object = None  # section and material of a beam, if given
    mass_damping: float = 0.0  # force per momentum [1/s], the mass-proportional part of Rayleigh damping
    terms: Mapping[str, float] | None = None  # coefficients of a relation, by quantity
    look: object = None  # its appearance in pictures, if given
    # parameters that belong to its elastic laws, by name: whether one of these has it, so that both change together
    elastic: Mapping[str, bool] | None = None

    @property
    def p(self) -> Array:
        """Parameters flattened in the order that the kernels expect."""
        return flatten(self.parameters, self.spec.parameters, f"{self.spec.name} '{self.name}'")

    @prints
    def __repr__(self) -> str:
        return f"Instance({self.name}: {self.spec.name} on {', '.join(self.nodes)}; {_values(self)})"

    @property
    def deformations(self) -> tuple[str, ...]:
        """Full names of the generalized deformations, ``element.deformation``."""
        return tuple(f"{self.name}.{d.name}" for d in self.spec.deformations)

    @property
    def slips(self) -> tuple[str, ...]:
        """Full names of the generalized slips, ``element.slip``."""
        return tuple(f"{self.name}.{s.name}" for s in self.spec.slips)


def arm_name(node: str) -> str:
    """Name the link by which a joint attaches a point of its own, a node, to a body."""
    return f"{node}_link"


@dataclass(frozen=True)
class LawInstance(_Row):
    """A law attached to named deformations and slips, with the initial values of its internal states."""

    name: str
    spec: LawSpec
    deformations: tuple[str, ...]
    slips: tuple[str, ...]
    parameters: Mapping[str, Array]
    code: Code | None = None
    z0: tuple[float, ...] = ()
    # of an elastic law of the element `name`: what its parameters are called among those of the element
    called: Mapping[str, str] | None = None
    knots: tuple[float, ...] = ()  # times [s] at which it is not smooth

    @property
    def p(self) -> Array:
        """Parameters flattened in the order that the kernels expect."""
        return flatten(self.parameters, self.spec.parameters, f"law '{self.name}'")

    @prints
    def __repr__(self) -> str:
        acts = listed([*self.deformations, *self.slips])
        return f"LawInstance({self.name}: {self.spec.name} on {acts}; {_values(self)})"

    @property
    def states(self) -> tuple[str, ...]:
        """Full names of the internal states, ``law.state``."""
        return tuple(f"{self.name}.{state.name}" for state in self.spec.states)


def _values(row: Instance | LawInstance) -> str:
    """Return the parameters of an element or a law with their units; arrays by their size."""
    shown = []
    for spec in row.spec.parameters:
        value = np.asarray(row.parameters[spec.name])
        unit = "" if spec.unit in ("1", "-") else f" {spec.unit}"
        shown.append(
            f"{spec.name} = {value.ravel()[0]:.6g}{unit}"
            if value.size == 1
            else f"{spec.name} ({value.size}){unit}"
        )
    return listed(shown) or "no parameters"


def flatten(values: Mapping[str, Array], specs: Iterable[object], owner: str) -> Array:
    """Join parameter values in the order of their specifications, and check their sizes."""
    parts: list[Array] = []
    for spec in specs:
        name, size = spec.name, spec.size  # type: ignore[attr-defined]
        value = values[name]
        if not isinstance(value, np.ndarray) or value.dtype != float:
            value = array(value, owner, f"parameter {name}")
        value = value.ravel()
        if value.size != size:
            raise ModelError(f"{owner}: parameter {name} has {value.size} numbers; it needs {size}")
        parts.append(value)
    found = np.concatenate(parts) if parts else np.zeros(0)
    if not (np.abs(found) <= LARGEST).all():  # once for all; now by name
        for name, value in values.items():
            array(value, owner, f"parameter {name}")
    return found


def law_labels(laws: Sequence[LawInstance]) -> list[str]:
    """Names of all laws as parameters have them: a second law of the same name is ``name#2``.

    The elastic laws of an element have its name.
    """
    count: Counter[str] = Counter(dict.fromkeys((law.name for law in laws if law.called is not None), 1))
    found = []
    for law in laws:
        if law.called is None:
            count[law.name] += 1
        known = law.called is not None or count[law.name] == 1
        found.append(law.name if known else f"{law.name}#{count[law.name]}")
    return found
