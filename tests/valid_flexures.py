"""Valid calls for flexure mechanisms from tables; properties are judged by the analysis."""

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from valid_call import Valid, calling

import flexel as fx

NODES = [[0, 0, 0], [0.1, 0, 0]]
LEAF = {
    "elements": [1],
    "section": "rectangle",
    "dimensions": (20e-3, 0.5e-3),
    "material": "steel",
    "orientation": (0, 1, 0),
    "beams": 1,
    "flexible": [1, 2, 3, 4, 5, 6],
}
PUSHED = {"force": (0, 0, 0.1), "mass": 0.1, "inertia": (1e-4, 1e-4, 1e-4)}
OPTIONS = {"steps": 1, "frequencies": 2, "buckling": 1, "compliance": [2], "gravity": (0, 0, -9.81)}
BODIES = {"p": "A", "frame_p": "RA", "q": "B", "frame_q": "RB"}


def tables(**changes: Any) -> dict[str, Any]:
    """A leaf spring that carries a body at its end."""
    given = {
        "nodes": NODES,
        "elements": [[1, 2]],
        "node_properties": {1: {"fixed": True}, 2: PUSHED},
        "element_properties": [LEAF],
        "options": OPTIONS,
    }
    return given | changes


@cache
def found() -> fx.Flexure:
    """Its analysis."""
    return fx.flexure(**tables())


def tip(values: Any) -> object:
    """The analysis with other properties of the end."""
    return fx.flexure(**tables(node_properties={1: {"fixed": True}, 2: values}))


def node_properties() -> Valid:
    """All that can be said of a node that moves."""
    values = PUSHED | {
        "fixed": ["x"],
        "moment": (0.01, 0, 0),
        "force_initial": (0, 0, 0.1),
        "moment_initial": (0, 0, 0.01),
        "displacement": {"y": 1e-4},
        "displacement_initial": (None, 1e-4, None),
        "rotation": {"y": 1e-3},
        "rotation_initial": {"y": 1e-3},
    }
    return Valid(fx.NodeProperties, values, tip)


def strip() -> Valid:
    """A leaf spring between two nodes, and its building."""
    m = fx.Model()
    for name, x in (("A", 0.0), ("B", 0.1)):
        m.point(name, (x, 0, 0), fixed=name == "A")
        m.frame(f"R{name}", fixed=name == "A")
    more = {"name": "z", "elements": 2, "start": (0, 0, 0), "end": (0.09, 0, 0), "direction": (0, 1, 0)}
    more |= {"section": fx.Rectangle(0.5e-3, 20e-3), "material": "steel", "flexible": ["torsion"]}
    more |= {"damping": 1e-4, "second_order": True, "warping": True}
    return Valid(m.leaf_spring, BODIES | more, lambda result: m.build() and None)


FLEXURES: dict[str, Callable[[], Valid]] = {
    "ElementProperties": lambda: Valid(
        fx.ElementProperties,
        {key: v for key, v in LEAF.items() if key != "material"}
        | {"E": 2e11, "nu": 0.3, "density": 7800.0, "strength": 1e9, "warping": True}
        | {"colour": (0.1, 0.2, 0.3), "opacity": 0.5, "hidden": False},
        lambda values: fx.flexure(**tables(element_properties=[values])) and None,
    ),
    "Flexure.compliance": lambda: calling(found().compliance, node=2, body_axes=True),
    "Flexure.plot": lambda: calling(found().plot, nodes=(2,), path=Path("flexure.png")),
    "Flexure.stiffness": lambda: calling(found().stiffness, node=2, body_axes=True),
    "Flexure.plot_stiffness": lambda: calling(
        found().plot_stiffness, node=2, along="x", body_axes=True, path=Path("stiffness.png")
    ),
    "Flexure.plot_shapes": lambda: calling(found().plot_shapes, steps=(0, 1), path=Path("flexure.png")),
    "Flexure.save": lambda: calling(found().save, path=Path("flexure.npz")),
    "Flexure.view": lambda: calling(found().view, path=Path("flexure.html")),
    "FlexureOptions": lambda: Valid(
        fx.FlexureOptions, OPTIONS, lambda options: fx.flexure(**tables(options=options)) and None
    ),
    "FlexureStep.element": lambda: calling(found().steps[0].element, element=1),
    "FlexureStep.linearize": lambda: calling(found().steps[0].linearize, damping=0.01),
    "FlexureStep.mode": lambda: calling(found().steps[0].mode, number=1),
    "FlexureStep.node": lambda: calling(found().steps[0].node, node=2),
    "FlexureStep.plot_mode": lambda: calling(found().steps[0].plot_mode, number=1, path=Path("flexure.png")),
    "FlexureStep.view_modes": lambda: calling(found().steps[0].view_modes, path=Path("flexure.html")),
    "Model.leaf_spring": strip,
    "NodeProperties": node_properties,
    "flexure": lambda: calling(fx.flexure, **tables()),
    "flexure_model": lambda: Valid(fx.flexure_model, tables(), lambda m: m.build() and None),
}
