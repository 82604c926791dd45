"""Reference numbers of the universal joint; SI units, angles in radians where no degree is named.

The angle of the driving shaft is zero where its fork's pin axis lies in the plane of the two shafts.
Imports the standard library only.
"""

from __future__ import annotations

CLOSED = "tan(in) = cos(b) tan(out), closed form, worst of all angles"
MOMENTS = "closed form: the cross transmits a moment along its normal only"
FREE = "J1 w1^2 + J2 w2^2 = const, quadrature"
MATHIEU = "Mathieu's characteristic values a1, b1"

# Driving shaft, driven shaft [degrees], speed ratio, acceleration / speed^2; 30 degrees between the shafts.
TABLE_30 = (
    (0.0, 0.0, 1.1547005383792517, 0.0),
    (15.0, 17.192123734020974, 1.1294802613871204, -0.18413513842785853),
    (30.0, 33.69006752597978, 1.0658774200423862, -0.28402366863905315),
    (45.0, 49.10660535086909, 0.9897433186107871, -0.2827838053173677),
    (60.0, 63.43494882292201, 0.9237604307034013, -0.2133333333333333),
    (75.0, 76.93568657049171, 0.8807755981746853, -0.1119721273403126),
    (90.0, 90.0, 0.8660254037844387, 0.0),
)

# Two free shafts at 30 degrees: inertias [kg m2], first speed [rad/s]; time [s], angle [rad], speed [rad/s].
J1, J2, FIRST_SPEED = 0.3, 0.5, 10.0
FREE_RUN = (
    (0.25, 2.7766531851603102, 10.287069153374947),
    (0.5, 5.5344616286614965, 10.990947437691771),
    (1.0, 10.977671186169916, 11.966500199062201),
    (1.5, 16.4238980694878, 10.925936798417887),
    (2.0, 21.96122537709894, 10.00205748560935),
)

# y'' + w0^2 (1 + eps cos 2 w t) y = 0 at eps = b^2/2, b = 30 degrees: edges of the first zone, over w0.
EPS = 0.13707783890401884
EDGES = (0.9654516369666961, 1.033965078424665)
