"""Draw the pictures of the page on joints: ``python tools/joint_pictures.py`` writes ``docs/images/joint_*.png``.

Each shows the model of `flexel.examples.joints` as drawn, pale, and moved.
"""

import numpy as np
from filling import DOCS

from flexel import View
from flexel.apps.view.figures import COLOURS, save
from flexel.apps.view.scene import canvas, draw
from flexel.examples.joints import JOINTS, sketches

OUT = DOCS / "images"
SIZE = (3.0, 2.4)
PALE = 0.25
REACH = (-0.45, 0.45)  # of an axis, from its point [m]


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


def _joined(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    return min(a[0], b[0]), max(a[1], b[1])


if __name__ == "__main__":
    for name in JOINTS:
        picture(name)
