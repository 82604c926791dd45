"""Writes the pages of the viewer that the documentation plays: motions of programs on its pages, and of systems."""

import os
import re
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from flexel import Box, Cylinder, View
from flexel.apps.view.page import view_modes
from flexel.examples import (
    cardan,
    contact,
    cylinder,
    flexures,
    hoist,
    hoist_model,
    slider_crank,
    vehicle_runs,
)
from flexel.examples.bicycle import bicycle, kick
from flexel.examples.vehicle_figures import bodywork

PROGRAM = re.compile(r"```python\n(.*?)```", re.DOTALL)
FRAMES = 151


def write(folder: Path, out: Path) -> None:
    """Write the pages into a folder, each by the name that an ``iframe`` of the documentation gives it.

    Parameters
    ----------
    folder : Path
        Of the documentation.
    out : Path
        Where the pages are written.
    """
    out.mkdir(parents=True, exist_ok=True)
    _of_page(folder / "index.md", out / "pendulum.html", lambda names: Path("pendulum.html"), 1)
    _of_page(
        folder / "cranes.md",
        out / "winch.html",
        lambda names: names["motion"].view("winch.html", title="A winch", frames=FRAMES, progress=False),
    )
    _of_page(
        folder / "flexure-design.md",
        out / "guide.html",
        lambda names: names["travel"].view(
            "guide.html", title="A parallel guide over its travel", progress=False
        ),
        3,
    )
    for name, (motion, options) in _systems().items():
        motion.view(out / f"{name}.html", frames=FRAMES, progress=False, **options)
    guide = flexures.guide().build()
    at_rest = guide.equilibrium()
    title = "Modes of the parallel guide at rest"
    view_modes(at_rest, out / "guide-modes.html", guide.vibrations(at_rest, count=6), title=title)


def _systems() -> dict[str, tuple[Any, dict[str, Any]]]:
    """The motions of systems, and how they are shown."""
    system = bicycle()
    return {
        "bicycle": (
            system.simulate(5, start=kick(system, 4.5, 0.05)[0], progress=False),
            {"title": "The bicycle at 4.5 m/s after a kick"},
        ),
        "slider-crank": (
            slider_crank.transient(0.01),
            {"title": "The slider-crank at 150 rad/s, damping 1 %"},
        ),
        "vehicle": (
            vehicle_runs.sine_steer(20.0),
            {"title": "The vehicle at 20 m/s, sine steering", "view": View(sketches=bodywork())},
        ),
        "drum": (contact.on_drum(5.0), {"title": "A ball on a turning drum"}),
        "cardan": (
            cardan.driven(cardan.B30).simulate(2 * np.pi, progress=False),
            {"title": "A Cardan joint with its shafts at 30°", "view": _forks(cardan.B30)},
        ),
        "cylinder": (
            cylinder.driven().simulate(3.0, progress=False),
            {"title": "A crane on a hydraulic cylinder"},
        ),
        "hoist": (
            hoist.lift(hoist_model.hoist(), 2.0, rate=60),
            {"title": "The hoist: a sudden load, and the start of the lift"},
        ),
    }


def _forks(bend: float) -> View:
    """Shafts with forks, and the cross between them, for the frames of a Cardan joint, which have no shape."""
    x, y, z = np.eye(3)
    out = np.array([np.cos(bend), np.sin(bend), 0.0])
    solids: list[Cylinder | Box] = [Cylinder("centre", "cross", -0.24 * a, 0.24 * a, 0.03) for a in (y, z)]
    for name, along, pin in (("driving", -x, y), ("driven", out, z)):
        axes = np.array([along, pin, np.cross(along, pin)])
        solids.append(Cylinder("centre", name, 0.3 * along, 1.1 * along, 0.06))
        solids.append(Box("centre", name, 0.3 * along, (0.06, 0.46, 0.12), axes))
        solids += [
            Box("centre", name, 0.14 * along + side * 0.2 * pin, (0.34, 0.06, 0.12), axes) for side in (-1, 1)
        ]
    return View(sketches=solids)


def _of_page(
    page: Path, out: Path, written: Callable[[dict[str, Any]], Path], most: int | None = None
) -> None:
    """Run the programs of a page, at most so many, and keep the file that is then written."""
    names: dict[str, Any] = {"print": lambda *_: None}
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as place:
        os.chdir(place)
        try:
            for program in PROGRAM.findall(page.read_text(encoding="utf-8"))[:most]:
                exec(program, names)
            out.write_bytes((Path(place) / written(names)).read_bytes())
        finally:
            os.chdir(before)
