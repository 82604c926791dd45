"""Draw the elements and their modes: ``python tools/element_pictures.py`` writes ``docs/images/element_*.png``."""

from filling import DOCS

from flexel import View
from flexel.apps.view.element_modes import plot_element
from flexel.examples.elements import ELEMENTS

OUT = DOCS / "images"


def picture(name: str) -> None:
    """Draw one element and its modes."""
    shown = ELEMENTS[name]
    view = View(elevation=24, azimuth=-62, ground=False, sketches=shown.sketches)
    state = shown.make().build().initial
    plot_element(state, name, OUT / f"element_{name}.png", amount=shown.amount, view=view)


if __name__ == "__main__":
    for name in ELEMENTS:
        picture(name)
