"""Stresses of flexible elements, tyres and contacts: those of flexel against the laws written again."""

from collections import defaultdict

import numpy as np

from campaign.changes import Inapplicable
from campaign.elastic import Stressed
from campaign.trial import Trial, off


def stresses(trial: Trial) -> float:
    """Stresses of deformations and slips that laws determine; those of several laws on one quantity are added."""
    oracle, start = trial.oracle, trial.start
    x, v, z = trial.x(start), trial.v(start), trial.z(start)
    expected: dict[str, float] = defaultdict(float)
    for twin in oracle.twins:
        if isinstance(twin, Stressed):
            rows = oracle.rows(twin)
            own = np.array([z[name] for name in twin.states])
            for name, value in twin.stresses(x[rows], v[rows], own, start.t).items():
                expected[name] += value
    if not expected:
        raise Inapplicable("no stress follows from a law of a flexible element")
    return off(np.array([start.force(name) for name in expected]), np.array([*expected.values()]), 1.0)
