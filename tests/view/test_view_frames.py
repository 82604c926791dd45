"""All frames of a motion are painted in one go, as each alone, and coded in a page to fractions of a pixel."""

import json
from collections.abc import Callable
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import Browser
from moving import flexible_arm, loop, touching
from numpy.typing import NDArray
from rides import ride
from test_solids import held

import flexel as fx
from flexel.apps.view.drawing import shapes
from flexel.apps.view.page import scene_data, write_page
from flexel.apps.view.page.coding import STEP, coded
from flexel.apps.view.page.packing import packed, unpacked


def swing(make: Callable[[], fx.Model]) -> fx.Motion:
    return make().build().simulate(0.3, samples=7, progress=False)


def hoisted() -> fx.Motion:
    """A load on a rope that runs over a sheave from a drum, in the plane."""
    m = fx.Model(gravity=(0, -9.81))
    m.angle("ground", fixed=True)
    for name, place in (("drum", (0, 0)), ("sheave", (1.0, 1.2))):
        m.point(f"{name} centre", place, fixed=True)
        m.angle(f"{name} turn")
        m.hinge(f"{name} axle", "ground", f"{name} turn")
        m.body(f"{name} body", f"{name} centre", f"{name} turn", mass=30.0, inertia=0.5)
        m.sheave(name, f"{name} centre", f"{name} turn", radius=0.2)
    m.point("load", (1.208, 0.4))
    m.point_mass("load mass", "load", 500.0)
    contact = fx.Contact(1e10, friction=0.3, slip_speed=1e-3, dissipation=10.0)
    rope = {
        "contact": contact,
        "turns": 0.5,
        "tension": 4905.0,
        "section": fx.WireRope(16e-3),
        "damping": 1e-3,
    }
    m.rope("rope", [("drum", -1), "sheave", "load"], 20, material="wire rope", **rope)  # type: ignore[arg-type]
    m.prescribe("drum axle.angle", fx.Ramp(0.0, 0.1, 0.0, 0.1))
    s = m.build()
    start = s.equilibrium()
    return s.simulate(0.1, start=start, method="generalized-alpha", rtol=1e-3, samples=7, progress=False)


MOTIONS: dict[str, Callable[[], fx.Motion]] = {
    "wheels, bodies, a force of the road": lambda: ride(0.5, 7, progress=False),
    "beams": lambda: swing(flexible_arm),
    "hinges in a loop": lambda: swing(loop),
    "contacts": lambda: swing(touching),
    "springs, dampers, guides, a spiral": lambda: held().simulate(0.3, samples=7, progress=False),
    "cables, sheaves": hoisted,
}


def arrays(shape: Any) -> list[NDArray[np.float64]]:
    """All arrays that have the states along their first axis."""
    pose, marks = shape.pose or (), [row for row in (shape.across, shape.force) if row is not None]
    return [*shape.lines, *pose, *marks, *shape.values.values()]


@pytest.mark.parametrize("kind", MOTIONS)
def test_frames_are_painted_in_one_go_as_each_alone(kind: str) -> None:
    states = list(MOTIONS[kind]())
    together = shapes(states)
    for i, state in enumerate(states):
        for alone, all_states in zip(shapes(state), together, strict=True):
            assert (alone.style, alone.name, list(alone.values)) == (
                all_states.style,
                all_states.name,
                list(all_states.values),
            )
            for one, rows in zip(arrays(alone), arrays(all_states), strict=True):
                scale = max(1.0, float(np.max(np.abs(one), initial=0.0)))
                assert rows.shape == (len(states), *one.shape)
                assert np.allclose(rows[i], one, rtol=0, atol=1e-12 * scale)


def read_in(browser: Browser, places: list[dict[str, Any]]) -> list[list[float]]:
    """What the page's own script reads of its block."""
    script = (resources.files("flexel.apps.view.page") / "decode.js").read_text(encoding="utf-8")
    script = script[: script.index("/** Numbers over the frames")]  # what comes before needs nothing else
    asked = f"const places = {json.dumps(places)}; return places.map((place) => Array.from(floats(place)));"
    return list(browser.value(f"(async () => {{ {script} {asked} }})()"))


@pytest.mark.parametrize("kind", ["cables, sheaves", "wheels, bodies, a force of the road"])
def test_a_page_shows_positions_to_a_millionth_of_the_model(
    kind: str, tmp_path: Path, fresh: Browser
) -> None:
    """Half a step of 2^-20 of the model's size, of a unit quaternion, and of the largest value."""
    scene = scene_data(MOTIONS[kind](), frames=7)
    fresh.open(write_page(scene, tmp_path / "page.html"), "#t=0")
    found = coded(scene)
    moving = [i for i, shape in enumerate(found["shapes"]) if shape["data"]["rows"] > 1]
    read = read_in(fresh, [found["shapes"][i]["data"] for i in moving])
    assert len(moving) > 5
    for i, numbers in zip(moving, read, strict=True):
        given, steps = unpacked(scene["shapes"][i]["data"]), found["shapes"][i]["data"]["steps"]
        assert len(numbers) == len(given) and max(steps[:3]) <= 1.001 * STEP * scene["size"]
        error = np.abs(np.array(numbers) - given).reshape(-1, len(steps))
        assert np.all(error <= 0.51 * np.array(steps) + 1e-6 * np.abs(given).reshape(error.shape))
    peaks: dict[str, float] = {}
    for name, value in (item for shape in scene["shapes"] for item in shape["values"].items()):
        peaks[name] = max(peaks.get(name, 0.0), float(np.max(np.abs(unpacked(value["data"])))))
    for i, shape in enumerate(found["shapes"]):
        for name, value in shape["values"].items():
            (numbers,) = read_in(fresh, [value["data"]])
            error = np.abs(np.array(numbers) - unpacked(scene["shapes"][i]["values"][name]["data"]))
            assert np.max(error) <= STEP * peaks[name]
    plots = [row["values"] for row in found["plots"]["rows"]]
    for numbers, row in zip(read_in(fresh, plots), scene["plots"]["rows"], strict=True):
        assert np.array_equal(np.array(numbers, dtype="<f4"), unpacked(row["values"]))  # as they are


def test_numbers_far_apart_are_coded_to_rounding_of_float32(tmp_path: Path, fresh: Browser) -> None:
    """A part that goes 10⁵ times the size of the model: steps grow with it, so that differences fit into 32 bits."""
    scene = scene_data(ride(0.2, 3, progress=False), frames=3)
    rng = np.random.default_rng(3)
    far = rng.uniform(-1, 1, (50, 6)) * 1e5 * scene["size"]
    scene["shapes"] = [dict(scene["shapes"][0], rigid=False, counts=[2], data=packed(far), values={})]
    for name in ("local", "across", "outline", "force"):
        scene["shapes"][0].pop(name, None)
    scene["times"] = np.linspace(0, 1, 50).tolist()
    fresh.open(write_page(scene, tmp_path / "far.html"), "#t=0")
    (read,) = read_in(fresh, [coded(scene)["shapes"][0]["data"]])
    assert np.allclose(read, far.ravel(), rtol=6e-8, atol=2.0**-26 * np.max(np.abs(far)))
