"""Draw the functions of time with their rates, for the page of concepts: ``python tools/time_function_pictures.py``."""

import numpy as np
from filling import DOCS

import flexel as fx
from flexel.apps.view.figures import COLOURS, figure, save

SHOWN: dict[str, fx.Ramp | fx.Table] = {
    "fx.Ramp(1, 3, 0, 1)": fx.Ramp(1, 3, 0, 1),
    "fx.Table(…), cubic by default": fx.Table([0, 1, 2, 3, 4], [0, 0, 0.5, 1, 1]),
    'fx.Table(…, kind="linear")': fx.Table([0, 1, 3, 4], [0, 0, 1, 1], kind="linear"),
}
ORDERS = ("u", "u\u2032", "u\u2033")


def main() -> None:
    """Draw a column for each function, a row for each rate."""
    t = np.linspace(0, 4, 801)
    with figure(3, len(SHOWN), (9.0, 5.2), sharex=True, sharey="row") as (drawn, axes):
        for row, order in zip(axes, ORDERS, strict=True):
            row[0].set_ylabel(order)
        for column, (name, function) in zip(axes.T, SHOWN.items(), strict=True):
            values = np.array([function.rates(float(time)) for time in t])
            for panel, history in zip(column, values.T, strict=True):
                panel.plot(t, history, color=COLOURS[0])
            column[0].set_title(name)
            column[-1].set_xlabel("t [s]")
        save(drawn, DOCS / "images" / "time_functions.png")


if __name__ == "__main__":
    main()
