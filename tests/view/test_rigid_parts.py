"""What bodies carry in a picture moves with their nodes: rims, spokes, boxes, profiles of cams, blades, balls."""

import moving
import numpy as np
import pytest
from forty import MECHANISMS
from numpy.typing import NDArray

import flexel as fx
from flexel.apps.view.deflected import displaced
from flexel.apps.view.drawing import shapes
from flexel.base.quaternions import matrix

Pose = tuple[NDArray[np.float64], NDArray[np.float64]]


def on_two_bodies(planar: bool) -> fx.Model:
    """Two cams, the second under a flat face, and a skate, on bodies that are free."""
    third = () if planar else (0.0,)
    m = fx.Model()
    for name, x in (("cam", 0.0), ("follower", 0.2), ("sled", 0.5)):
        m.rigid_body(name, (x, 0.1, *third), mass=1.0, inertia=0.01 if planar else (0.01, 0.02, 0.015))
    more = {"centre": (0, 0.1, *third), "axis": None if planar else (0, 0, 1), "start": (1, 0.5, *third)}

    def outline(angle: float) -> float:
        return 0.1 + 0.01 * float(np.cos(angle) + 0.1 * np.sin(2 * angle))

    m.cam("roller", "cam", "follower", (0.2, 0.1, *third), outline, **more)
    m.cam("flat", "cam", "follower", (0.1, 0.1, *third), outline, face=(1, 0.1, *third), **more)
    m.release("roller.gap", "flat.gap")
    m.skate("blade", "sled", at=(0.5, 0.02, *third), direction=(1, 0.3, *third))
    return m


def poses(state: fx.State, nodes: tuple[str, ...]) -> list[Pose]:
    """Position and axes of each point of an element with the frame or angle behind it."""
    found = []
    for point, frame in zip(nodes, nodes[1:], strict=False):
        if state.structure.node(frame).kind in ("frame", "planar_angle"):
            q, x = state.position(frame), state.position(point)
            if q.size == 1:
                q, x = np.array([np.cos(q[0] / 2), 0, 0, np.sin(q[0] / 2)]), np.append(x, 0.0)
            if x.size == 3:
                found.append((x, matrix(q)))
    return found


@pytest.mark.parametrize(
    ("name", "styles"),
    [
        ("planar cams", {"rim", "valve", "box"}),
        ("cams", {"rim", "valve", "box"}),
        ("touching", {"rim", "valve", "spoke", "box"}),
        ("kicked bicycle", {"rim", "spoke", "valve", "axle", "box"}),
        ("leaning motorcycle", {"tyre", "spoke", "valve", "axle", "box"}),
        ("planetary gear", {"rim", "valve", "spoke"}),
        ("elastic belt", {"rim", "valve", "box"}),
    ],
)
def test_what_a_body_carries_moves_with_its_nodes(name: str, styles: set[str]) -> None:
    """At displaced positions each line is where the position and rotation of two nodes of its element take it."""
    if name in MECHANISMS:
        _, before = MECHANISMS[name].make()
    else:
        before = (
            (moving.touching() if name == "touching" else on_two_bodies("planar" in name)).build().initial
        )
    after = displaced(before, 0.3 * np.random.default_rng(1).standard_normal(before.x.size))
    elements = {instance.name: instance.nodes for instance in before.structure.instances}
    seen = set()
    for old, new in zip(shapes(before), shapes(after), strict=True):
        if old.style not in ("rim", "spoke", "valve", "axle", "tyre", "box") or old.name not in elements:
            continue
        nodes = elements[old.name]
        lines = np.vstack(old.lines)
        moved = [
            x1 + (lines - x0) @ R0 @ R1.T
            for (x0, R0), (x1, R1) in zip(poses(before, nodes), poses(after, nodes), strict=True)
        ]
        assert min(np.max(np.abs(line - np.vstack(new.lines))) for line in moved) < 1e-12, old.name
        assert max(np.max(np.abs(line - lines)) for line in moved) > 1e-3
        seen.add(old.style)
    assert seen == styles
