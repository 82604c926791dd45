"""A few steps from the start of a motion, to see what the motion would take."""

from __future__ import annotations

import numpy as np

from flexel.base.errors import FlexelError
from flexel.integration.driver import Run
from flexel.structure.callbacks import Callback

STEPS = 60  # of a trial at least
LAST = 1 / 3  # of its steps, that are taken as typical


def evaluations(run: Run, more: float, budget: float = 0.0) -> float:
    """Evaluations of the equations of motion that a motion takes if it goes on as it begins.

    Infinite where laws call code of the user, which may keep something from call to call, and where the trial fails.

    Parameters
    ----------
    run : Run
        A motion that has not begun; it is of no use afterwards.
    more : float
        Evaluations that cost as much as the linear algebra of a step.
    budget : float
        Evaluations that the trial may take in any case.
    """
    if any(isinstance(law.code, Callback) for law in run.present.structure.laws):
        return np.inf
    end = float(run.times[-1])
    times, counts = [run.t], [0]
    try:
        run.begin()
        while run.t < end and (len(times) <= STEPS or counts[-1] < budget):
            run.forward()
            times.append(run.t)
            counts.append(run.statistics["evaluations"])
    except FlexelError:
        return np.inf
    last = int(np.ceil(LAST * (len(times) - 1)))
    steps = last + last * (end - run.t) / (times[-1] - times[-1 - last])
    return float(steps * ((counts[-1] - counts[-1 - last]) / last + more))
