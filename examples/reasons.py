"""Reasons for tolerances that are larger than three times the error found: `Quantity.reason` in the tables."""

from __future__ import annotations

ROUNDING = "rounding, which differs between machines"
STEPS = "the steps follow an error estimate and differ between machines"
PRINTED = "half a unit of the reference's last digit"
SAMPLE = "the standard error of 256 points is 4 %, and another version of SciPy may draw others"
ITERATION = "where the iteration stops differs between machines"
