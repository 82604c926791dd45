"""Makes a small picture of a mechanism as text of a page, for notebooks."""

from __future__ import annotations

import base64
import io

from flexel.apps.view.scene import canvas, draw
from flexel.model.state import State

SIZE = (4.0, 3.0)  # inches
DPI = 90


def thumbnail(state: State) -> str:
    """Return an HTML element with the picture of a state.

    Raises
    ------
    FlexelError
        If matplotlib is not installed.
    """
    with canvas(state, SIZE) as (drawn, axes):
        draw(state, axes)
        axes.set_axis_off()
        kept = io.BytesIO()
        drawn.savefig(kept, format="png", dpi=DPI)
    return f'<img alt="the model as drawn" src="data:image/png;base64,{base64.b64encode(kept.getvalue()).decode()}">'
