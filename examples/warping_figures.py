"""Figure of restrained torsion: the stiffness of a clamped leaf against its length, and the twist of an I-beam."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from flexel.apps.view.figures import COLOURS, figure, save
from flexel.examples import warping as example
from flexel.examples import warping_exact as exact
from flexel.examples.warping_exact import BEAM, SPAN


def pictures(out: Path) -> list[Path]:
    """Write the figure to a folder; return its path."""
    out.mkdir(parents=True, exist_ok=True)
    path = out / "warping_torsion.png"
    with figure(1, 2, size=(9.0, 4.2)) as (drawn, (left, right)):
        kl = np.geomspace(0.7, 60.0, 200)
        left.loglog(kl, [exact.restrained(length) for length in kl], color=COLOURS[0], label="closed form")
        marks = np.geomspace(1.0, 50.0, 9)
        for n, marker in ((1, "o"), (4, "x")):
            found = [example.leaf_stiffness(float(length), n) for length in marks]
            label = f"{n} element{'s' * (n > 1)}"
            left.loglog(marks, found, marker, color=COLOURS[n % 2 + 1], label=label)
        left.set(
            xlabel="k l [-]", ylabel="torsional stiffness over GJ/l [-]", title="Leaf, clamped at both ends"
        )
        left.legend()
        x, angles, _ = example.cantilever_torsion(8)
        fine = np.linspace(0.0, SPAN, 200)
        closed = exact.cantilever_twist(fine, 1.0, SPAN, BEAM)
        uniform = fine / exact.stiffnesses(BEAM)[0]
        right.plot(fine, 1e3 * uniform, "--", color=COLOURS[2], label="uniform torsion")
        right.plot(fine, 1e3 * closed, color=COLOURS[0], label="closed form")
        right.plot(x, 1e3 * angles, "o", color=COLOURS[1], label="8 elements")
        right.set(xlabel="x [m]", ylabel="twist [mrad]", title="I beam, end torque of 1 N m")
        right.legend()
        drawn.suptitle("Torsion with restrained warping")
        save(drawn, path)
    return [path]
