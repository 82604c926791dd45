"""A SPACAR input file that was read: its model, its names for quantities, its inputs and outputs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from flexel.apps.spacar.terminals import Terminal
from flexel.apps.spacar.weights import Weight
from flexel.base.arguments import flag, index, text
from flexel.base.copies import Portable
from flexel.base.errors import ConstraintError, ModelError
from flexel.model.part import Part
from flexel.model.state import State
from flexel.parts.loads import LoadPart
from flexel.parts.model import Model
from flexel.results.system_facade import System

DEFAULT_STEPS = 100  # of a file without TIMESTEP or ITERSTEP


def _check_complete(model: Model, system: System) -> None:
    """Raise if the file names degrees of freedom, but too few: SPACAR does not complete them."""
    for named, chosen, kind in (
        (model.lowering.dynamic, system.dynamic, "dynamic"),
        (model.lowering.kinematic, system.kinematic, "kinematic"),
    ):
        missing = [name for name in chosen if named and name not in named]
        if named and missing:
            raise ConstraintError(
                f"under-constrained: {len(chosen)} {kind} coordinate(s) are needed and {len(named)} named; a motion of "
                f"{', '.join(repr(name) for name in missing)} is left"
            )


@dataclass(frozen=True)
class SpacarFile(Portable):
    """A parsed SPACAR input file.

    Attributes
    ----------
    path : Path
    dialect : str
        "delft" or "twente".
    model : Model
        The model of the file; positions are called p1, p2 ..., orientations o1, o2 ..., elements by keyword and
        number: hinge1, plbeam2.
    start, duration : float
        Start and duration of the motion [s]; no duration if the file has no TIMESTEP.
    steps : int
        Number of its stored steps.
    increments : int
        Number of its load steps.
    max_step : float or None
        HMAX [s].
    coordinates : mapping of (node, i) to name
        SPACAR's coordinates x of all nodes.
    deformations : mapping of (element, i) to (name, factor)
        SPACAR's deformations and slips; factor is SPACAR's divided by flexel's (signs differ, see the tables).
    inputs, outputs : tuple of Terminal
        Inputs and outputs of the linear model, in the order of their numbers.
    linearized : bool
        Whether the file requests linearized equations: by LINE, or by inputs and outputs.
    notes : tuple of str
        Lines without effect, and assumptions where the descriptions of the language are not explicit.
    routines : mapping of USERINP and USERSIG to str
        Names of the user's routines, which are not run.
    warped : mapping of (element, i) to mapping
        Stresses of beams with warping that are sums of flexel's, with their factors, by name.
    scales : mapping of str to float
        SPACAR's values over flexel's of degrees of freedom that are coordinates, but named as modes of elements.
    """

    path: Path
    dialect: str
    model: Model = field(repr=False)
    start: float
    duration: float | None
    steps: int
    increments: int
    max_step: float | None
    coordinates: Mapping[tuple[int, int], str] = field(repr=False)
    deformations: Mapping[tuple[int, int], tuple[str, float]] = field(repr=False)
    inputs: tuple[Terminal, ...]
    outputs: tuple[Terminal, ...]
    notes: tuple[str, ...]
    linearized: bool
    still: tuple[Part[Any], ...] = field(repr=False)
    load_steps: tuple[Part[Any], ...] = field(repr=False)
    routines: Mapping[str, str] = field(repr=False)
    rigid_weights: Mapping[tuple[int, int], Weight] = field(repr=False)
    warped: Mapping[tuple[int, int], Mapping[str, float]] = field(repr=False)
    scales: Mapping[str, float] = field(repr=False)

    @cached_property
    def system(self) -> System:
        """The built system.

        Raises
        ------
        ConstraintError
            Degrees of freedom without a coordinate in the file, or redundant conditions.
        """
        return self._built(self.model, self.start)

    def _built(self, model: Model, start: float) -> System:
        try:
            found = model.build(start)
            _check_complete(model, found)
            return found
        except ConstraintError as error:
            raise ConstraintError(
                f"{self.path.name}: {error} (in the file: a degree of freedom is named by DYNE or DYNX, "
                "a kinematic one by ENHC or KINE, a prescribed motion is INPUTE or INPUTX, RLSE releases and FIX holds)"
            ) from error
        except ModelError as error:
            raise ModelError(f"{self.path.name}: {error}") from error

    def deformation(self, state: State, element: int, i: int) -> float:
        """Return deformation i of an element in SPACAR's sign; of a slip, its rate.

        Raises
        ------
        ModelError
            The element or deformation does not exist.
        """
        name, factor = self._mode(element, i)
        self._check_state(state)
        if name in self.slips:
            return factor * state.rate(name)
        return factor * state[name]

    def stress(self, state: State, element: int, i: int) -> float:
        """Return the generalized stress conjugate to `deformation`, in SPACAR's sign.

        In the Twente dialect, the stress of a rigid beam excludes the moments by which its own weight bends
        it, as in SPACAR; they are in equilibrium and move nothing.
        """
        name, factor = self._mode(element, i)
        self._check_state(state)
        terms = self.warped.get((element, i), {name: 1.0 / factor})
        stress = sum(share * state.force(term) for term, share in terms.items())
        weight = self.rigid_weights.get((element, i))
        return stress if weight is None else stress - weight.stress(state)

    def _check_state(self, state: object) -> None:
        if not isinstance(state, State):
            raise ModelError(
                f"{self.path.name}: {type(state).__name__} is not a state; give one of this file's system"
            )

    def _mode(self, element: int, i: int) -> tuple[str, float]:
        element, i = index(element, self.path.name, "element"), index(i, self.path.name, "deformation")
        if (element, i) not in self.deformations:
            raise ModelError(
                f"{self.path.name}: deformation {i} of element {element} does not exist; elements are "
                f"{', '.join(map(str, sorted({e for e, _ in self.deformations})))}"
            )
        return self.deformations[element, i]

    @cached_property
    def slips(self) -> frozenset[str]:
        """Names of all slips, which have rates but no values."""
        return frozenset(slip for instance in self.model.instances.values() for slip in instance.slips)

    def factor(self, name: str) -> float:
        """Return the ratio of a quantity in SPACAR to the same in flexel; 1 for coordinates."""
        return self._factors.get(text(name, self.path.name, "name"), 1.0)

    @cached_property
    def _factors(self) -> dict[str, float]:
        named = set(self.coordinates.values())
        return {name: f for name, f in self.deformations.values() if name not in named} | dict(self.scales)

    def variant(self, *, load_steps: bool = False, loads: bool = True) -> System:
        """Return the system moved by the increments DELXF, DELINPX and DELINPE (times t), or without its loads."""
        load_steps, loads = flag(load_steps, "variant", "load_steps"), flag(loads, "variant", "loads")
        parts = self.model.parts + (self.still + self.load_steps if load_steps else ())
        model = Model.of(self.model.gravity, parts if loads else map(_unloaded, parts))
        return self._built(model, 0.0 if load_steps else self.start)


def _unloaded(part: Part[Any]) -> Part[Any]:
    """Return a load without its value, which still measures the rates of its frame; other parts as they are."""
    if not isinstance(part, LoadPart):
        return part
    several = isinstance(part.value, (tuple, list))
    return replace(part, value=(0.0,) * len(part.value) if several else 0.0)
