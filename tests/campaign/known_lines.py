"""The cables of a rope, declared one by one, as a line that contacts refer to by name."""

from typing import Any

import numpy as np

from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.parts.cable_lines import CableLine


@part
class KnownLine(Part[CableLine]):
    """Make some cables a line."""

    name: str = entry("Of the line.")
    elements: tuple[str, ...] = entry("Its cables.")
    s: Any = array_quantity("m", "Undeformed arc length of its nodes.")
    radius: float = quantity("m", "positive", "Of the rope.")

    def lower(self, to: Lowering) -> CableLine:
        """Register the line."""
        line = CableLine(self.name, self.elements, (), (), np.array(self.s), self.radius)
        to.lines[self.name] = line
        return line
