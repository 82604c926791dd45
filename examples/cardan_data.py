"""Reference numbers of the universal joint, from `examples/data`; SI units, angles in radians where no degree is named.

The angle of the driving shaft is zero where its fork's pin axis lies in the plane of the two shafts.
"""

from __future__ import annotations

from flexel.examples.published import published

CLOSED = "tan(in) = cos(b) tan(out), worst of all angles"
MOMENTS = "the cross transmits a moment along its normal only"
FREE = "J1 w1^2 + J2 w2^2 = const, quadrature"
MATHIEU = "Mathieu's characteristic values a1, b1"

_TABLES = published("hooke_joint")

# Driving shaft, driven shaft [degrees], speed ratio, acceleration / speed^2; 30 degrees between the shafts.
TABLE_30: tuple[tuple[float, ...], ...] = tuple(
    tuple(float(row[key]) for key in ("theta1_deg", "theta2_deg", "ratio", "theta2dd_over_w1sq"))
    for row in _TABLES["table_beta30_convA"]
)

# Two free shafts at 30 degrees: inertias [kg m2], first speed [rad/s]; time [s], angle [rad], speed [rad/s].
_RUN = _TABLES["free_run_reference"]
J1, J2, FIRST_SPEED = (float(_RUN[key]) for key in ("J1", "J2", "w1_0"))
FREE_RUN: tuple[tuple[float, float, float], ...] = tuple(
    (row["t"], row["theta1"], row["w1"]) for row in _RUN["rows"]
)

# y'' + w0^2 (1 + eps cos 2 w t) y = 0 at eps = b^2/2, b = 30 degrees: edges of the first zone, over w0.
EPS: float = _TABLES["mathieu_check"]["eps"]
EDGES: tuple[float, float] = tuple(_TABLES["mathieu_check"]["edges_over_w0"])
