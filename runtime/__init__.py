"""flexel, a compiler for mechanisms: the names a user needs, found when they are first used.

Nothing is imported here until it is asked for (PEP 562), so that ``import flexel`` is quick and
``python -m flexel.derive`` starts even when the compiled kernels are missing or broken.
This room may import the standard library only; type checkers see the real imports below.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flexel.compliance import Compliance, body_compliance
    from flexel.constraints import constraint_report
    from flexel.curves import Curve
    from flexel.errors import (
        CompilerError,
        ConstraintError,
        DynamicsError,
        ElementError,
        FlexelError,
        IncompleteWarning,
        LinearizationError,
        ModelError,
        PositionError,
        RangeWarning,
    )
    from flexel.functions import Harmonic, Polynomial, Ramp, Table
    from flexel.integrate import Event
    from flexel.linearize import Linearization
    from flexel.materials import Material
    from flexel.model import Model
    from flexel.orientation import turn
    from flexel.result import Motion
    from flexel.rope.contacts import Contact
    from flexel.rope.impact import hunt_crossley, lankarani_nikravesh
    from flexel.rope.ropes import Rope
    from flexel.rope.surfaces import RoundGroove, VGroove
    from flexel.rope.wire_rope import WireRope
    from flexel.saved.restore import load
    from flexel.sections import Circle, IBeam, Rectangle, Tube
    from flexel.spacar.reading import Spacar, read_spacar
    from flexel.state import State
    from flexel.stress import beam_stress, largest_stress, section_forces
    from flexel.system import System
    from flexel.user import compile_element, compile_law
    from flexel.wheels import Waves

__version__ = "0.1.0"

__all__ = [
    "Circle",
    "CompilerError",
    "Compliance",
    "ConstraintError",
    "Contact",
    "Curve",
    "DynamicsError",
    "ElementError",
    "Event",
    "FlexelError",
    "Harmonic",
    "IBeam",
    "IncompleteWarning",
    "Linearization",
    "LinearizationError",
    "Material",
    "Model",
    "ModelError",
    "Motion",
    "Polynomial",
    "PositionError",
    "Ramp",
    "RangeWarning",
    "Rectangle",
    "Rope",
    "RoundGroove",
    "Spacar",
    "State",
    "System",
    "Table",
    "Tube",
    "VGroove",
    "Waves",
    "WireRope",
    "beam_stress",
    "body_compliance",
    "compile_element",
    "compile_law",
    "constraint_report",
    "hunt_crossley",
    "lankarani_nikravesh",
    "largest_stress",
    "load",
    "read_spacar",
    "section_forces",
    "turn",
]

_HOMES = {
    "Circle": "flexel.sections",
    "CompilerError": "flexel.errors",
    "Compliance": "flexel.compliance",
    "ConstraintError": "flexel.errors",
    "Contact": "flexel.rope.contacts",
    "Curve": "flexel.curves",
    "DynamicsError": "flexel.errors",
    "ElementError": "flexel.errors",
    "Event": "flexel.integrate",
    "FlexelError": "flexel.errors",
    "Harmonic": "flexel.functions",
    "IBeam": "flexel.sections",
    "IncompleteWarning": "flexel.errors",
    "Linearization": "flexel.linearize",
    "LinearizationError": "flexel.errors",
    "Material": "flexel.materials",
    "Model": "flexel.model",
    "ModelError": "flexel.errors",
    "Motion": "flexel.result",
    "Polynomial": "flexel.functions",
    "PositionError": "flexel.errors",
    "Ramp": "flexel.functions",
    "RangeWarning": "flexel.errors",
    "Rectangle": "flexel.sections",
    "Rope": "flexel.rope.ropes",
    "RoundGroove": "flexel.rope.surfaces",
    "Spacar": "flexel.spacar.reading",
    "State": "flexel.state",
    "System": "flexel.system",
    "Table": "flexel.functions",
    "Tube": "flexel.sections",
    "VGroove": "flexel.rope.surfaces",
    "Waves": "flexel.wheels",
    "WireRope": "flexel.rope.wire_rope",
    "beam_stress": "flexel.stress",
    "body_compliance": "flexel.compliance",
    "compile_element": "flexel.user",
    "compile_law": "flexel.user",
    "constraint_report": "flexel.constraints",
    "hunt_crossley": "flexel.rope.impact",
    "lankarani_nikravesh": "flexel.rope.impact",
    "largest_stress": "flexel.stress",
    "load": "flexel.saved.restore",
    "read_spacar": "flexel.spacar.reading",
    "section_forces": "flexel.stress",
    "turn": "flexel.orientation",
}


def __getattr__(name: str) -> object:
    """Import the module in which a public name lives, and keep the name for the next time."""
    if name not in _HOMES:
        raise AttributeError(f"module 'flexel' has no attribute {name!r}; its names are {', '.join(__all__)}")
    value: object = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, whether or not they have been imported yet."""
    return sorted({*globals(), *__all__})
