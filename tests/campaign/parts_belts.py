"""Belts between pulleys of the plane: the straight part and what is wound on either pulley."""

import numpy as np

from campaign.algebra import dot, turned
from campaign.case import Case
from campaign.changes import Change, changer, having
from campaign.parts import Drawing, handler
from campaign.parts_forces import Spring
from flexel.base.arrays import Array
from flexel.parts.couplings import PlanarBelt


@handler(PlanarBelt, options="stiffness damping")
def _belt(drawing: Drawing, part: PlanarBelt) -> None:
    name, *nodes = map(str, (part.name, part.p, part.angle_p, part.q, part.angle_q))
    a, b = part.radius_p, part.radius_q
    drawn = drawing.x(*nodes)
    d0 = drawn[3:5] - drawn[:2]
    heading = float(np.arctan2(d0[1], d0[0]))

    def length(x: Array) -> Array:
        """Of the belt between two of its points that were the ends of the straight part as drawn."""
        d = turned(-heading, x[3:5] - x[:2])
        straight = np.sqrt(dot(d, d) - (a - b) ** 2)
        lean = np.arctan(d[1] / d[0]) - np.arctan((a - b) / straight)  # turn of the belt itself
        return straight + a * (x[2] - drawn[2] - lean) - b * (x[5] - drawn[5] - lean)

    start = float(length(drawn))
    k = part.stiffness
    drawing.measure(f"{name}.elongation", tuple(nodes), lambda x: length(x) - start, k is None)
    if k is not None:
        drawing.twins.append(Spring(drawing.measures[f"{name}.elongation"], k, part.damping, 0.0, 0.0))


@changer(PlanarBelt)
def _changed(change: Change, part: PlanarBelt, case: Case) -> PlanarBelt:
    radii = {key: change.sign * change.size("L", getattr(part, key)) for key in ("radius_p", "radius_q")}
    stiffness, damping = (change.size(u, getattr(part, key) or 0.0) for key, u in UNITS.items())
    return having(part, **radii, stiffness=stiffness, damping=damping)


UNITS = {"stiffness": "M T-2", "damping": "M T-1"}
