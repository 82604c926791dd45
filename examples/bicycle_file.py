"""The bicycle of an input file that A. L. Schwab published in 2003, read and linearized over the speed.

Its page gives three speeds that are not in the file itself: the page belongs to another version.
"""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from scipy.optimize import brentq

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import whipple
from flexel.examples.bicycle_data import PAPER
from flexel.examples.reasons import ROUNDING
from flexel.examples.stable_speeds import by_formulas, stable_speeds
from flexel.results.reproduction import Quantity

LEAN_STEER = ("hinge14.angle", "hinge6.angle")
RADIUS, GRAVITY = 0.35, 10.0  # of the rear wheel [m]; with which the file's weights are computed [m/s²]
SPIN = "ed 11 1 30"  # the line of the file that gives the spin of the rear wheel [rad/s]
RIDER, COMMENT = (
    "mass 6 6 0 -4 10 0 6",
    "mass 6 10 0 0 10 0 2",
)  # inertia of the rider, and the one in the comment
PAGE = (0.9, 4.1, 5.7)  # speeds that the page of the file gives [m/s]
ROOT = "https://github.com/mechmotum/mechmotum.github.io, content/spring-2003.rst"

# The file's numbers as the 25 parameters of the 2007 paper. The rear frame carries 16 kg at (0.5, -0.6) and the rider's
# 80 kg at (0.3, -1.2), with moments of inertia of (2, 8, 2) and (6, 10, 6; xz -4) kg m2; the front frame 1 kg, a point.
_MASSES, _PLACES = np.array([16.0, 80.0]), np.array([[0.5, -0.6], [0.3, -1.2]])
_CENTRE = _MASSES @ _PLACES / _MASSES.sum()
_X, _Z = (_PLACES - _CENTRE).T
PARAMETERS: dict[str, float] = {
    "w": 1.2, "c": 0.06, "lam": float(np.arctan2(0.36, 0.9)), "g": GRAVITY,
    "rR": RADIUS, "mR": 2.0, "IRxx": 0.12, "IRyy": 0.24,
    "xB": float(_CENTRE[0]), "zB": float(_CENTRE[1]), "mB": 96.0,
    "IBxx": 2 + 6 + float(_MASSES @ _Z**2), "IBxz": -4 - float(_MASSES @ (_X * _Z)),
    "IByy": 8 + 10 + float(_MASSES @ (_X**2 + _Z**2)), "IBzz": 2 + 6 + float(_MASSES @ _X**2),
    "xH": 1.0, "zH": -0.7, "mH": 1.0, "IHxx": 0.0, "IHxz": 0.0, "IHyy": 0.0, "IHzz": 0.0,
    "rF": 0.35, "mF": 2.0, "IFxx": 0.12, "IFyy": 0.24,
}  # fmt: skip


def read(speed: float, rider: str = RIDER) -> fx.System:
    """Read the file for a forward speed [m/s], with the rider's line of inertia."""
    text = (resources.files("flexel.examples") / "data" / "bike3.dat").read_text(encoding="utf-8")
    lines = [line.partition("%")[0].strip() for line in text.splitlines()]
    given = {SPIN: f"ed 11 1 {speed / RADIUS!r}", RIDER: rider}
    with TemporaryDirectory() as folder:
        path = Path(folder) / "bike3.dat"
        path.write_text("\n".join(given.get(line, line) for line in lines) + "\n", encoding="utf-8")
        return fx.read_spacar(path).system


def matrices(rider: str = RIDER) -> dict[str, Array]:
    """M, C1, K0 and K2 as of the paper of 2007, from linearizations of the file's model at 1 and 2 m/s."""
    one, two = (read(v, rider).linearize().reduced(LEAN_STEER) for v in (1.0, 2.0))
    K2 = (two.K - one.K) / 3
    return {"M": one.M, "C1": one.C, "K0": (one.K - K2) / GRAVITY, "K2": K2}


def speeds(found: dict[str, Array]) -> list[float]:
    """Return the speeds [m/s] at which weave begins, weave becomes stable, and capsize becomes unstable."""
    equations = by_formulas(found, GRAVITY)
    weave, capsize = stable_speeds(equations)

    def discriminant(v: float) -> float:
        """Of the characteristic polynomial of degree four: positive where no root, or every one, is complex."""
        return float(_discriminant(np.asarray(np.poly(equations(v).state_matrix), dtype=float)))

    grid = np.linspace(0.0, weave, 81)
    values = [discriminant(v) for v in grid]
    first = next(i for i in range(grid.size - 1) if values[i] > 0 >= values[i + 1])
    begin = float(brentq(discriminant, grid[first], grid[first + 1], xtol=1e-13, rtol=8.9e-16))
    return [begin, weave, np.nan if capsize is None else capsize]


def _discriminant(p: Array) -> float:
    """Return the discriminant of a x^4 + b x^3 + c x^2 + d x + e."""
    a, b, c, d, e = p
    first, second = (
        c**2 - 3 * b * d + 12 * a * e,
        2 * c**3 - 9 * b * c * d + 27 * (b**2 * e + a * d**2) - 72 * a * c * e,
    )
    return float((4 * first**3 - second**2) / 27)


def of_the_file() -> list[Quantity]:
    """Compare the file's linear equations with the formulas of 2007, and report its speeds beside those of its page."""
    found, formulas = matrices(), whipple.matrices(PARAMETERS)
    units = {"M": "kg m2", "C1": "kg m", "K0": "kg m", "K2": "kg"}
    by_formula = f"formulas of {PAPER}, appendix A, with the file's numbers"
    rows = [
        Quantity(f"bike3_{name}", found[name], formulas[name], 2e-12, units[name], by_formula, kind="closed form",
                 tolerance_kind="absolute", reason=ROUNDING)
        for name in units
    ]  # fmt: skip
    own = f"weave begins, weave is stable, capsize; {by_formula}; the page of the file, {ROOT}, is of another version"
    rows += [
        Quantity("bike3_speeds", speeds(found), speeds(formulas), 1e-10, "m/s", own, {"page": list(PAGE)},
                 kind="closed form", reason=ROUNDING),
        Quantity("bike3_speeds_comment", speeds(matrices(COMMENT)), unit="m/s",
                 source="with the inertia of the rider that the file has as a comment"),
    ]  # fmt: skip
    return rows
