"""A motion to be simulated by default settings: a case, how long, how large, and what is watched."""

from dataclasses import dataclass, replace
from typing import Any

import flexel as fx
from campaign.case import Case, Node, drawn_nodes
from flexel.model.part import Part


@dataclass(frozen=True)
class Ride:
    """A case whose motion is simulated by default settings.

    Attributes
    ----------
    case : Case
        Its duration is that of the motion.
    traits : tuple of str
        What the case was extended by.
    amplitude : float
        Of the motion, relative to the size of the model.
    watched : str
        A coordinate of which an event is looked for where it passes the middle of its range; empty for none.
    away : float
        Distance from the origin, relative to the size of the model.
    length, mass : float
        Units: so many of them are a metre and a kilogram.
    """

    case: Case
    traits: tuple[str, ...] = ()
    amplitude: float = 1.0
    watched: str = ""
    away: float = 0.0
    length: float = 1.0
    mass: float = 1.0

    def built(self) -> fx.System:
        """The system; of a redundant family without its redundant conditions, as the report of constraints says."""
        m = self.case.model()
        if "redundant" in self.case.known:
            m.release(*m.constraint_report().release)
        return m.build()

    def program(self) -> str:
        """The shortest program that makes the motion."""
        made = self.case.program()
        if "redundant" in self.case.known:
            made = made.replace("s = m.build()", "m.release(*m.constraint_report().release)\ns = m.build()")
        lines = [made]
        event = ""
        if self.watched:
            lines.append(f"first = s.simulate({self.case.duration!r}, start=state)[{self.watched!r}]")
            lines.append("level = (min(first) + max(first)) / 2")
            event = f", events=[fx.Event('middle', lambda state: state[{self.watched!r}] - level)]"
        lines.append(f"motion = s.simulate({self.case.duration!r}, start=state{event})\n")
        return "\n".join(lines)

    def having(self, trait: str, *parts: Part[Any]) -> "Ride":
        """The ride with a further trait, by further parts."""
        return replace(self, case=self.case.having(*parts), traits=(*self.traits, trait))

    def mapped(self, trait: str, parts: list[Part[Any]]) -> "Ride":
        """The ride with a further trait, by other parts."""
        return replace(self, case=replace(self.case, parts=tuple(parts)), traits=(*self.traits, trait))

    @property
    def planar(self) -> bool:
        """In the plane."""
        return len(self.case.gravity) == 2

    @property
    def hook(self) -> tuple[str, tuple[float, ...]]:
        """The last point that nothing holds, with its place: something may be hung on it."""
        nodes = self._nodes("point")
        free = [node for node in nodes if not node.fixed.any()]
        moving = [node for node in nodes if not node.fixed.all()]
        node = (free or moving or nodes)[-1]
        return node.name, tuple(node.drawn.tolist())

    @property
    def driven(self) -> tuple[str, float]:
        """A coordinate that may move, of the hook if that moves, with its value as drawn: something may push it."""
        hook = self.hook[0]
        hooks = [node for node in self._nodes("point") if node.name == hook]
        for node in (*hooks, *reversed(self._nodes("angle"))):
            for name, fixed, value in zip(node.names, node.fixed, node.drawn, strict=True):
                if not fixed:
                    return name, float(value)
        raise ValueError(f"nothing moves in {self.case.family}")

    def _nodes(self, kind: str) -> list[Node]:
        """The nodes of one kind, without those of contacts."""
        nodes = drawn_nodes(self.case).values()
        return [node for node in nodes if node.kind == kind and "contact" not in node.name]
