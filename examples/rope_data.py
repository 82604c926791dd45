"""Data of the falling flexible pendulum: the rod of the literature, and the history of its tip by assumed modes."""

from __future__ import annotations

import numpy as np

from flexel.examples.published import published

_TABLES = published("flexible_pendulum")

# Berzeri and Shabana, Journal of Sound and Vibration 235 (2000) 539: length, area, second moment, density; SI units
PENDULUM: dict[str, float] = {name: _TABLES["data"][name] for name in ("L", "A", "I", "rho")}

# places of the tip [m] every 0.05 s up to 1 s, by Young's modulus [N/m²]; a rod of assumed modes, converged to 2e-4 of
# the length for 0.7e9 and 1e-3 for 0.7e8; these moduli are so large that measures of strain do not matter
TIPS = {
    float(case["E"]): np.array([row["tip"] for row in case["reference"] if row["t"] <= 1.0]).round(6)
    for case in _TABLES["cases"][1:]
}
