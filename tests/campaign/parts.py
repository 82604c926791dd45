"""From the calls of a case to its twins: what each call means, in the independent description.

A call adds twins and measures.  A measure is a deformation as a function of coordinates; it is a constraint where it
is rigid, has a spring or a damper where one acts on it, and may be prescribed.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from campaign.calls import Call, Case, Node, drawn_nodes
from campaign.twin import Twin
from flexel.base.arrays import Array


@dataclass
class Measure:
    """A deformation e(x) (...) of the coordinates x (n, ...) of some nodes; rigid: held at zero."""

    name: str
    nodes: tuple[str, ...]
    value: Callable[[Array], Array]
    rigid: bool


@dataclass
class Drawing:
    """What the calls have made so far.

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
    """

    case: Case
    nodes: dict[str, Node]
    twins: list[Twin] = field(default_factory=list)
    measures: dict[str, Measure] = field(default_factory=dict)
    slips: dict[str, Measure] = field(default_factory=dict)

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


Handler = Callable[[Drawing, Call], None]
HANDLERS: dict[str, Handler] = {}
OPTIONS: dict[str, set[str]] = {}


def handler(*methods: str, options: str = "") -> Callable[[Handler], Handler]:
    """Register what the calls of these methods mean; those with other options than named are an error."""

    def register(function: Handler) -> Handler:
        HANDLERS.update(dict.fromkeys(methods, function))
        OPTIONS.update(dict.fromkeys(methods, set(options.split())))
        return function

    return register


@handler(
    "point",
    "frame",
    "angle",
    "fix",
    "independent",
    "kinematic",
    "initial",
    options="fixed position value orientation",
)
def _nothing(drawing: Drawing, call: Call) -> None:
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
        If no meaning of a call, or of one of its options, is registered.
    """
    drawing = Drawing(case, drawn_nodes(case))
    for call in case.calls:
        if unknown := set(call.options) - OPTIONS[call.method]:
            raise KeyError(f"the twin of m.{call.method} has no {', '.join(sorted(unknown))}")
        HANDLERS[call.method](drawing, call)
    rigid = [Rigid(z) for z in drawing.measures.values() if z.rigid]
    rolling = [Rolling(z) for z in drawing.slips.values() if z.rigid]
    return [*drawing.twins, *rigid, *rolling]
