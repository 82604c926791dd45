"""flexel, a compiler for mechanisms: its public names, imported on first use.

Imports are lazy (PEP 562), so that ``import flexel`` is quick and
``python -m flexel.derive`` starts even when the compiled kernels are missing or broken.
"""

import logging
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flexel.apps.flexures.declaring import flexure_model
    from flexel.apps.flexures.flexure import flexure
    from flexel.apps.flexures.properties import ElementProperties, FlexureOptions, NodeProperties
    from flexel.apps.spacar.reading import Spacar, read_spacar
    from flexel.apps.sweeps.dataset import open_sweep
    from flexel.apps.sweeps.parameter_sweep import sweep
    from flexel.apps.sweeps.points import Points, grid, listed
    from flexel.apps.sweeps.sampled_points import sample
    from flexel.apps.view.scene import View
    from flexel.apps.view.solids import Box, Cylinder, Mesh, Sketch
    from flexel.base.errors import (
        AssemblyWarning,
        AuditWarning,
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
    from flexel.derive.definition_errors import ElementError, FlexelError
    from flexel.integration.events import Event
    from flexel.linear.sampled import SampledLoop
    from flexel.mechanics.findings import CheckReport, Finding
    from flexel.mechanics.modes import Mode, Reduced
    from flexel.model.constraints import ConstraintReport
    from flexel.model.profiles import SectionForces, StressPoint
    from flexel.model.rigid_body import RigidBody
    from flexel.model.state import State
    from flexel.model.stress import BeamStress
    from flexel.parts.closed_profile import ClosedProfile
    from flexel.parts.curves import Curve
    from flexel.parts.element_page import ElementPage, ElementValues, page
    from flexel.parts.elements import compile_element, compile_law
    from flexel.parts.materials import Material
    from flexel.parts.model import Model
    from flexel.parts.opening import load
    from flexel.parts.rope import Rope
    from flexel.parts.rope_contacts import Contact
    from flexel.parts.rope_surfaces import HelicalGroove, RoundGroove, VGroove
    from flexel.parts.round_sections import Circle, Tube
    from flexel.parts.sections import IBeam, Rectangle
    from flexel.parts.thin_sections import LBeam, UBeam
    from flexel.parts.wheels import Waves
    from flexel.parts.wire_rope import WireRope
    from flexel.results.analyses.stepper import Stepper
    from flexel.results.analyses.summary import Summary
    from flexel.results.ensemble import Ensemble
    from flexel.results.flexure_result import Flexure
    from flexel.results.flexure_step import FlexureElement, FlexureNode, FlexureStep
    from flexel.results.interrupted import Interrupted
    from flexel.results.linearization import Linearization
    from flexel.results.linearizations import Linearizations, RootLoci
    from flexel.results.motion import Motion
    from flexel.results.periodic_branch import PeriodicBranch
    from flexel.results.periodic_motion import PeriodicSolution
    from flexel.results.saved.spacar_records import SpacarRecords
    from flexel.results.small_motion import SmallMotion
    from flexel.results.system_facade import System
    from flexel.results.time_varying import TimeVarying
    from flexel.statics.compliance import Compliance
    from flexel.statics.stability import BucklingMode, Vibration

__version__ = "0.1.0"

__all__ = [
    "AssemblyWarning",
    "AuditWarning",
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
    "ElementPage",
    "ElementProperties",
    "ElementValues",
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
    "SmallMotion",
    "Spacar",
    "SpacarRecords",
    "State",
    "Stepper",
    "StiffWarning",
    "StressPoint",
    "Summary",
    "System",
    "Table",
    "TimeVarying",
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
    "page",
    "read_spacar",
    "sample",
    "sweep",
    "turn",
]

_HOMES = {
    "AssemblyWarning": "flexel.base.errors",
    "AuditWarning": "flexel.base.errors",
    "BeamStress": "flexel.model.stress",
    "Box": "flexel.apps.view.solids",
    "BucklingMode": "flexel.statics.stability",
    "CheckReport": "flexel.mechanics.findings",
    "Circle": "flexel.parts.round_sections",
    "ClosedProfile": "flexel.parts.closed_profile",
    "CompilerError": "flexel.base.errors",
    "Compliance": "flexel.statics.compliance",
    "ConstraintError": "flexel.base.errors",
    "CoordinateWarning": "flexel.base.errors",
    "ConstraintReport": "flexel.model.constraints",
    "Contact": "flexel.parts.rope_contacts",
    "Curve": "flexel.parts.curves",
    "Cylinder": "flexel.apps.view.solids",
    "DampingWarning": "flexel.base.errors",
    "DynamicsError": "flexel.base.errors",
    "ElementError": "flexel.derive.definition_errors",
    "ElementPage": "flexel.parts.element_page",
    "ElementProperties": "flexel.apps.flexures.properties",
    "ElementValues": "flexel.parts.element_page",
    "Ensemble": "flexel.results.ensemble",
    "Event": "flexel.integration.events",
    "Finding": "flexel.mechanics.findings",
    "FlexelError": "flexel.derive.definition_errors",
    "Flexure": "flexel.results.flexure_result",
    "FlexureElement": "flexel.results.flexure_step",
    "FlexureNode": "flexel.results.flexure_step",
    "FlexureOptions": "flexel.apps.flexures.properties",
    "FlexureStep": "flexel.results.flexure_step",
    "Harmonic": "flexel.base.time_functions",
    "HelicalGroove": "flexel.parts.rope_surfaces",
    "IBeam": "flexel.parts.sections",
    "IncompleteWarning": "flexel.base.errors",
    "Interrupted": "flexel.results.interrupted",
    "LBeam": "flexel.parts.thin_sections",
    "Linearization": "flexel.results.linearization",
    "LinearizationError": "flexel.base.errors",
    "Linearizations": "flexel.results.linearizations",
    "Material": "flexel.parts.materials",
    "Mesh": "flexel.apps.view.solids",
    "Mode": "flexel.mechanics.modes",
    "Model": "flexel.parts.model",
    "ModelError": "flexel.base.errors",
    "ModelWarning": "flexel.base.errors",
    "Motion": "flexel.results.motion",
    "NodeProperties": "flexel.apps.flexures.properties",
    "PeriodicBranch": "flexel.results.periodic_branch",
    "PeriodicSolution": "flexel.results.periodic_motion",
    "Points": "flexel.apps.sweeps.points",
    "Polynomial": "flexel.base.time_functions",
    "PositionError": "flexel.base.errors",
    "Ramp": "flexel.base.time_functions",
    "RangeWarning": "flexel.base.errors",
    "Rectangle": "flexel.parts.sections",
    "Reduced": "flexel.mechanics.modes",
    "RigidBody": "flexel.model.rigid_body",
    "RootLoci": "flexel.results.linearizations",
    "Rope": "flexel.parts.rope",
    "RoundGroove": "flexel.parts.rope_surfaces",
    "SampledLoop": "flexel.linear.sampled",
    "SectionForces": "flexel.model.profiles",
    "Sketch": "flexel.apps.view.solids",
    "SmallMotion": "flexel.results.small_motion",
    "Spacar": "flexel.apps.spacar.reading",
    "SpacarRecords": "flexel.results.saved.spacar_records",
    "State": "flexel.model.state",
    "Stepper": "flexel.results.analyses.stepper",
    "Summary": "flexel.results.analyses.summary",
    "StiffWarning": "flexel.base.errors",
    "StressPoint": "flexel.model.profiles",
    "System": "flexel.results.system_facade",
    "Table": "flexel.base.time_tables",
    "TimeVarying": "flexel.results.time_varying",
    "UBeam": "flexel.parts.thin_sections",
    "Tube": "flexel.parts.round_sections",
    "UnstableWarning": "flexel.base.errors",
    "UnsteadyWarning": "flexel.base.errors",
    "VGroove": "flexel.parts.rope_surfaces",
    "Vibration": "flexel.statics.stability",
    "View": "flexel.apps.view.scene",
    "Waves": "flexel.parts.wheels",
    "WireRope": "flexel.parts.wire_rope",
    "compile_element": "flexel.parts.elements",
    "compile_law": "flexel.parts.elements",
    "flexure": "flexel.apps.flexures.flexure",
    "flexure_model": "flexel.apps.flexures.declaring",
    "grid": "flexel.apps.sweeps.points",
    "listed": "flexel.apps.sweeps.points",
    "load": "flexel.parts.opening",
    "open_sweep": "flexel.apps.sweeps.dataset",
    "page": "flexel.parts.element_page",
    "read_spacar": "flexel.apps.spacar.reading",
    "sample": "flexel.apps.sweeps.sampled_points",
    "sweep": "flexel.apps.sweeps.parameter_sweep",
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
