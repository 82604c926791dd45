"""Draw the pictures of the page on joints: ``python tools/joint_pictures.py`` writes them to ``docs/images``.

Joints have pictograms; gears, belts and cams are shown by the models of `flexel.examples.joints`, as drawn (pale) and
moved.
"""

from pathlib import Path

import numpy as np
from filling import DOCS
from joint_pictograms import PICTOGRAMS, directions
from matplotlib.figure import Figure
from solids import Scene

from flexel import View
from flexel.apps.view.figures import COLOURS, save
from flexel.apps.view.scene import canvas, draw
from flexel.examples.joints import JOINTS, sketches

OUT = DOCS / "images"
SIZE = (3.0, 2.4)
PALE = 0.25
REACH = (-0.45, 0.45)  # of an axis, from its point [m]
SCALE = 1.15  # of a pictogram [inches per metre]
LETTERS = "#808080"  # readable on white and on black


def picture(name: str) -> None:
    """Draw one joint, before and after."""
    shown = JOINTS[name]
    start = shown.make().build().initial
    moved = shown.make()
    for quantity, value in shown.moved.items():
        moved.initial(quantity, value)
    view = View(elevation=28, azimuth=-55, ground=False, sketches=sketches(name))
    with canvas(start, SIZE) as (drawn, axes):
        if shown.moved:
            draw(start, axes, view)
            window = [axes.get_xlim(), axes.get_ylim()]
            for artist in (*axes.collections, *axes.lines):
                artist.set_alpha(PALE)
        draw(moved.build().initial, axes, view)
        if shown.moved and axes.name != "3d":  # both states fit in the window
            for limits, (low, high) in zip((axes.set_xlim, axes.set_ylim), window, strict=True):
                limits(*_joined(limits(), (low, high)))
        for point, direction in shown.axes:
            ends = np.array(point) + np.outer(REACH, direction)
            axes.plot(*ends.T, "-.", color=COLOURS[1], lw=1.0)
        axes.set_axis_off()
        save(drawn, OUT / f"joint_{name}.png")


def pictogram(name: str) -> None:
    """Draw one joint as solids."""
    scene = Scene()
    PICTOGRAMS[name](scene)
    _written(scene, {}, OUT / f"joint_{name}.png")


def names_of_directions() -> None:
    """Draw the directions by which the deformations of a joint are named."""
    scene = Scene()
    names = directions(scene)
    _written(scene, names, OUT / "directions_across_joints.png")


def _written(scene: Scene, names: dict[str, tuple[float, float, float]], path: Path) -> None:
    """Write a scene without a background, names included, at the same scale as the others."""
    drawn = Figure()
    axes = drawn.add_axes((0.0, 0.0, 1.0, 1.0))
    scene.draw(axes)
    for name, place in names.items():
        axes.text(*scene.where(place), name, color=LETTERS, ha="center", va="bottom", fontsize=9)
    width, height = (SCALE * abs(float(np.diff(limits)[0])) for limits in (axes.get_xlim(), axes.get_ylim()))
    drawn.set_size_inches(width, height)
    drawn.savefig(path, dpi=130, transparent=True, bbox_inches="tight", pad_inches=0.05)


def _joined(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    return min(a[0], b[0]), max(a[1], b[1])


if __name__ == "__main__":
    names_of_directions()
    for name in PICTOGRAMS:
        pictogram(name)
    for name in JOINTS.keys() - PICTOGRAMS.keys():
        picture(name)
