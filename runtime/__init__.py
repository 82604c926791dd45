"""flexel, a compiler for mechanisms: its public names, imported on first use.

Imports are lazy (PEP 562), so that ``import flexel`` is quick and
``python -m flexel.derive`` starts even when the compiled kernels are missing or broken.
"""

import logging
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flexel.analyses.stepper import Stepper
    from flexel.analyses.summary import Summary
    from flexel.base.errors import (
        AssemblyWarning,
        CompilerError,
        ConstraintError,
        CoordinateWarning,
        DampingWarning,
        DynamicsError,
        IncompleteWarning,
        LinearizationError,
        ModelError,
        ModelWarning,
        PositionError,
        RangeWarning,
        StiffWarning,
        UnstableWarning,
        UnsteadyWarning,
    )
    from flexel.base.quaternions import turn
    from flexel.base.time_functions import Harmonic, Polynomial, Ramp
    from flexel.base.time_tables import Table
    from flexel.declare.closed_profile import ClosedProfile
    from flexel.declare.curves import Curve
    from flexel.declare.materials import Material
    from flexel.declare.round_sections import Circle, Tube
    from flexel.declare.sections import IBeam, Rectangle, SectionForces, StressPoint
    from flexel.declare.thin_sections import LBeam, UBeam
    from flexel.declare.user import compile_element, compile_law
    from flexel.declare.wheels import Waves
    from flexel.derive.errors import ElementError, FlexelError
    from flexel.flexures.declaring import flexure_model
    from flexel.flexures.flexure import flexure
    from flexel.flexures.properties import ElementProperties, FlexureOptions, NodeProperties
    from flexel.integration.events import Event
    from flexel.linear.sampled import SampledLoop
    from flexel.mechanics.constraints import ConstraintReport
    from flexel.mechanics.findings import CheckReport, Finding
    from flexel.mechanics.linearization import Linearization
    from flexel.mechanics.modes import Mode, Reduced
    from flexel.mechanics.stress import BeamStress
    from flexel.model import Model
    from flexel.pictures.scene import View
    from flexel.pictures.solids import Box, Cylinder, Mesh, Sketch
    from flexel.results.branch import PeriodicBranch
    from flexel.results.ensemble import Ensemble
    from flexel.results.flexure import Flexure
    from flexel.results.flexure_step import FlexureElement, FlexureNode, FlexureStep
    from flexel.results.interrupted import Interrupted
    from flexel.results.linearizations import Linearizations, RootLoci
    from flexel.results.motion import Motion
    from flexel.results.periodic import PeriodicSolution
    from flexel.results.saved.loading import load
    from flexel.results.saved.spacar_records import SpacarRecords
    from flexel.rope.contacts import Contact
    from flexel.rope.rope import Rope
    from flexel.rope.surfaces import HelicalGroove, RoundGroove, VGroove
    from flexel.rope.wire_rope import WireRope
    from flexel.spacar.reading import Spacar, read_spacar
    from flexel.statics.compliance import Compliance
    from flexel.statics.stability import BucklingMode, Vibration
    from flexel.structure.rigid_bodies import RigidBody
    from flexel.structure.state import State
    from flexel.sweeps.dataset import open_sweep
    from flexel.sweeps.points import Points, grid, listed
    from flexel.sweeps.sampling import sample
    from flexel.sweeps.sweep import sweep
    from flexel.system import System

__version__ = "0.1.0"

__all__ = [
    "AssemblyWarning",
    "BeamStress",
    "Box",
    "BucklingMode",
    "CheckReport",
    "Circle",
    "ClosedProfile",
    "CompilerError",
    "Compliance",
    "ConstraintError",
    "CoordinateWarning",
    "ConstraintReport",
    "Contact",
    "Curve",
    "Cylinder",
    "DampingWarning",
    "DynamicsError",
    "ElementError",
    "ElementProperties",
    "Ensemble",
    "Event",
    "Finding",
    "FlexelError",
    "Flexure",
    "FlexureElement",
    "FlexureNode",
    "FlexureOptions",
    "FlexureStep",
    "Harmonic",
    "HelicalGroove",
    "IBeam",
    "IncompleteWarning",
    "Interrupted",
    "LBeam",
    "Linearization",
    "LinearizationError",
    "Linearizations",
    "Material",
    "Mesh",
    "Mode",
    "Model",
    "ModelError",
    "ModelWarning",
    "Motion",
    "NodeProperties",
    "PeriodicBranch",
    "PeriodicSolution",
    "Points",
    "Polynomial",
    "PositionError",
    "Ramp",
    "RangeWarning",
    "Rectangle",
    "Reduced",
    "RigidBody",
    "RootLoci",
    "Rope",
    "RoundGroove",
    "SampledLoop",
    "SectionForces",
    "Sketch",
    "Spacar",
    "SpacarRecords",
    "State",
    "Stepper",
    "StiffWarning",
    "StressPoint",
    "Summary",
    "System",
    "Table",
    "Tube",
    "UBeam",
    "UnstableWarning",
    "UnsteadyWarning",
    "VGroove",
    "Vibration",
    "View",
    "Waves",
    "WireRope",
    "compile_element",
    "compile_law",
    "flexure",
    "flexure_model",
    "grid",
    "listed",
    "load",
    "open_sweep",
    "read_spacar",
    "sample",
    "sweep",
    "turn",
]

_HOMES = {
    "AssemblyWarning": "flexel.base.errors",
    "BeamStress": "flexel.mechanics.stress",
    "Box": "flexel.pictures.solids",
    "BucklingMode": "flexel.statics.stability",
    "CheckReport": "flexel.mechanics.findings",
    "Circle": "flexel.declare.round_sections",
    "ClosedProfile": "flexel.declare.closed_profile",
    "CompilerError": "flexel.base.errors",
    "Compliance": "flexel.statics.compliance",
    "ConstraintError": "flexel.base.errors",
    "CoordinateWarning": "flexel.base.errors",
    "ConstraintReport": "flexel.mechanics.constraints",
    "Contact": "flexel.rope.contacts",
    "Curve": "flexel.declare.curves",
    "Cylinder": "flexel.pictures.solids",
    "DampingWarning": "flexel.base.errors",
    "DynamicsError": "flexel.base.errors",
    "ElementError": "flexel.derive.errors",
    "ElementProperties": "flexel.flexures.properties",
    "Ensemble": "flexel.results.ensemble",
    "Event": "flexel.integration.events",
    "Finding": "flexel.mechanics.findings",
    "FlexelError": "flexel.derive.errors",
    "Flexure": "flexel.results.flexure",
    "FlexureElement": "flexel.results.flexure_step",
    "FlexureNode": "flexel.results.flexure_step",
    "FlexureOptions": "flexel.flexures.properties",
    "FlexureStep": "flexel.results.flexure_step",
    "Harmonic": "flexel.base.time_functions",
    "HelicalGroove": "flexel.rope.surfaces",
    "IBeam": "flexel.declare.sections",
    "IncompleteWarning": "flexel.base.errors",
    "Interrupted": "flexel.results.interrupted",
    "LBeam": "flexel.declare.thin_sections",
    "Linearization": "flexel.mechanics.linearization",
    "LinearizationError": "flexel.base.errors",
    "Linearizations": "flexel.results.linearizations",
    "Material": "flexel.declare.materials",
    "Mesh": "flexel.pictures.solids",
    "Mode": "flexel.mechanics.modes",
    "Model": "flexel.model",
    "ModelError": "flexel.base.errors",
    "ModelWarning": "flexel.base.errors",
    "Motion": "flexel.results.motion",
    "NodeProperties": "flexel.flexures.properties",
    "PeriodicBranch": "flexel.results.branch",
    "PeriodicSolution": "flexel.results.periodic",
    "Points": "flexel.sweeps.points",
    "Polynomial": "flexel.base.time_functions",
    "PositionError": "flexel.base.errors",
    "Ramp": "flexel.base.time_functions",
    "RangeWarning": "flexel.base.errors",
    "Rectangle": "flexel.declare.sections",
    "Reduced": "flexel.mechanics.modes",
    "RigidBody": "flexel.structure.rigid_bodies",
    "RootLoci": "flexel.results.linearizations",
    "Rope": "flexel.rope.rope",
    "RoundGroove": "flexel.rope.surfaces",
    "SampledLoop": "flexel.linear.sampled",
    "SectionForces": "flexel.declare.sections",
    "Sketch": "flexel.pictures.solids",
    "Spacar": "flexel.spacar.reading",
    "SpacarRecords": "flexel.results.saved.spacar_records",
    "State": "flexel.structure.state",
    "Stepper": "flexel.analyses.stepper",
    "Summary": "flexel.analyses.summary",
    "StiffWarning": "flexel.base.errors",
    "StressPoint": "flexel.declare.sections",
    "System": "flexel.system",
    "Table": "flexel.base.time_tables",
    "UBeam": "flexel.declare.thin_sections",
    "Tube": "flexel.declare.round_sections",
    "UnstableWarning": "flexel.base.errors",
    "UnsteadyWarning": "flexel.base.errors",
    "VGroove": "flexel.rope.surfaces",
    "Vibration": "flexel.statics.stability",
    "View": "flexel.pictures.scene",
    "Waves": "flexel.declare.wheels",
    "WireRope": "flexel.rope.wire_rope",
    "compile_element": "flexel.declare.user",
    "compile_law": "flexel.declare.user",
    "flexure": "flexel.flexures.flexure",
    "flexure_model": "flexel.flexures.declaring",
    "grid": "flexel.sweeps.points",
    "listed": "flexel.sweeps.points",
    "load": "flexel.results.saved.loading",
    "open_sweep": "flexel.sweeps.dataset",
    "read_spacar": "flexel.spacar.reading",
    "sample": "flexel.sweeps.sampling",
    "sweep": "flexel.sweeps.sweep",
    "turn": "flexel.base.quaternions",
}

# records go where the program that imports it wants them
logging.getLogger("flexel").addHandler(logging.NullHandler())


def __getattr__(name: str) -> object:
    """Import the module in which a public name lives, and cache the name."""
    if name not in _HOMES:
        raise AttributeError(f"module 'flexel' has no attribute {name!r}; its names are {', '.join(__all__)}")
    value: object = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, whether or not they have been imported yet."""
    return sorted({*globals(), *__all__})
