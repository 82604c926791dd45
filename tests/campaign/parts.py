"""From the parts of a case to its twins: what each part means, in the independent description.

A part adds twins and measures.  A measure is a deformation as a function of coordinates; it is a constraint where it
is rigid, has a spring or a damper where one acts on it, and may be prescribed.
"""

from collections.abc import Callable
from dataclasses import MISSING, dataclass, field, fields
from typing import Any

import numpy as np

from campaign.case import Case, Node, drawn_nodes
from campaign.known_lines import KnownLine
from campaign.twin import Twin
from flexel.base.arrays import Array
from flexel.model.part import Part, kind_of
from flexel.parts.cables import Slope
from flexel.parts.nodes import Angle, Frame, Point
from flexel.parts.roles import Fix, Independent, Initial, Kinematic
from flexel.parts.written import arguments_of


@dataclass
class Measure:
    """A deformation e(x) (...) of the coordinates x (n, ...) of some nodes; rigid: held at zero."""

    name: str
    nodes: tuple[str, ...]
    value: Callable[[Array], Array]
    rigid: bool


@dataclass
class Drawing:
    """What the parts have made so far.

    Attributes
    ----------
    case : Case
    nodes : dict of str to Node
        As they are drawn.
    twins : list of Twin
    measures : dict of str to Measure
        By the name of the deformation.
    slips : dict of str to Measure
        By the name of the slip; value(x) gives its row (n, ...).
    lines : dict of str to KnownLine
        Ropes by name.
    """

    case: Case
    nodes: dict[str, Node]
    twins: list[Twin] = field(default_factory=list)
    measures: dict[str, Measure] = field(default_factory=dict)
    slips: dict[str, Measure] = field(default_factory=dict)
    lines: dict[str, KnownLine] = field(default_factory=dict)

    @property
    def gravity(self) -> Array:
        """Acceleration of gravity."""
        return np.array(self.case.gravity)

    def x(self, *names: str) -> Array:
        """Coordinates of nodes as drawn, one after the other."""
        return np.concatenate([self.nodes[name].drawn for name in names])

    def measure(
        self, name: str, nodes: tuple[str, ...], value: Callable[[Array], Array], rigid: bool
    ) -> None:
        """Add a deformation."""
        self.measures[name] = Measure(name, nodes, value, rigid)

    def slip(self, name: str, nodes: tuple[str, ...], value: Callable[[Array], Array], rigid: bool) -> None:
        """Add a slip by its row."""
        self.slips[name] = Measure(name, nodes, value, rigid)

    def measured(self, name: str) -> Measure:
        """A deformation, or a coordinate as the amount by which it differs from its drawn value."""
        if name not in self.measures:
            node = self.nodes[name.rpartition(".")[0]]
            i = node.names.index(name)
            self.measure(name, (node.name,), lambda x: x[i] - node.drawn[i], False)
        return self.measures[name]

    def free(self, *names: str) -> None:
        """Make deformations and slips free."""
        for name in names:
            (self.slips[name] if name in self.slips else self.measured(name)).rigid = False


Handler = Callable[[Drawing, Any], None]
HANDLERS: dict[type[Part[Any]], Handler] = {}
OPTIONS: dict[type[Part[Any]], set[str]] = {}


def handler(*kinds: type[Part[Any]], options: str = "") -> Callable[[Handler], Handler]:
    """Register what parts of these kinds mean; those with other options than named are an error."""

    def register(function: Handler) -> Handler:
        HANDLERS.update(dict.fromkeys(kinds, function))
        OPTIONS.update(dict.fromkeys(kinds, set(options.split())))
        return function

    return register


def options_of(part: Part[Any]) -> dict[str, Any]:
    """The fields of a part that differ from their defaults, without those that have none, and without empty ones."""
    optional = {item.name for item in fields(part) if item.default is not MISSING}
    return {name: value for name, value in arguments_of(part).items() if name in optional and value != {}}


@handler(
    Point,
    Frame,
    Angle,
    Slope,
    Fix,
    Independent,
    Kinematic,
    Initial,
    options="fixed value orientation stretch",
)
def _nothing(drawing: Drawing, part: Part[Any]) -> None:
    """Nodes are read by `drawn_nodes`; the choice of coordinates changes nothing in the oracle."""


class Rigid(Twin):
    """A rigid deformation."""

    def __init__(self, measure: Measure) -> None:
        self.nodes, self._value = measure.nodes, measure.value

    def rigid(self, x: Array, t: Array) -> Array:
        return np.array([self._value(x)])


class Rolling(Twin):
    """A slip that is zero."""

    def __init__(self, measure: Measure) -> None:
        self.nodes, self._value = measure.nodes, measure.value

    def slips(self, x: Array) -> Array:
        return np.array([self._value(x)])


def twins_of(case: Case) -> list[Twin]:
    """The twins of a case.

    Raises
    ------
    KeyError
        If no meaning of a part, or of one of its options, is registered.
    """
    drawing = Drawing(case, drawn_nodes(case))
    for part in case.parts:
        if unknown := options_of(part).keys() - OPTIONS[type(part)]:
            raise KeyError(f"the twin of a {kind_of(type(part))} has no {', '.join(sorted(unknown))}")
        HANDLERS[type(part)](drawing, part)
    rigid = [Rigid(measure) for measure in drawing.measures.values() if measure.rigid]
    rolling = [Rolling(slip) for slip in drawing.slips.values() if slip.rigid]
    return [*drawing.twins, *rigid, *rolling]
