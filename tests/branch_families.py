"""The families of the campaign "no step onto another branch", and how many of each are simulated."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from branch_case import Case
from branch_planar import PLANAR
from branch_spatial import SPATIAL
from branch_turning import TURNING

FAMILIES = PLANAR | SPATIAL | TURNING
COUNTS = {
    "double": 120,
    "triple": 60,
    "four-bar": 60,
    "change-point": 30,
    "parallelogram": 10,
    "slider-crank": 30,
    "spatial": 40,
    "ball": 20,
    "rssr": 20,
    "wheel": 10,
    "cardan": 10,
    "driven": 6,
    "rotor": 6,
    "screw": 6,
}


@lru_cache(maxsize=500)
def case(family: str, number: int) -> Case:
    """The case of a family by its number; the same in every process."""
    name = f"{family} {number}"
    return FAMILIES[family](name, np.random.default_rng(list(name.encode())))


def cases(family: str, every: int = 1) -> Sequence[Case]:
    """All cases of a family, or one of so many."""
    return [case(family, number) for number in range(0, COUNTS[family], every)]
