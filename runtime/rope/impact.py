"""Dissipation factors of contact laws from a coefficient of restitution.

The laws ``hertz…`` multiply the elastic force by 1 + dissipation × speed of approach; these functions give the
factor for an impact at a known speed.  They hold for restitutions near one; below 0.8 the impact leaves with more
speed than was asked for (0.85 for 0.8 and 0.67 for 0.2 with Lankarani and Nikravesh).
"""

from __future__ import annotations

from flexel.base.arguments import number, positive
from flexel.base.errors import ModelError


def hunt_crossley(restitution: float, speed: float) -> float:
    """Dissipation factor 3 (1 - e)/(2 v) [s/m] for the restitution e at the speed of approach v [m/s].

    Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440.
    """
    e, v = _checked("Hunt and Crossley", restitution, speed)
    return 1.5 * (1 - e) / v


def lankarani_nikravesh(restitution: float, speed: float) -> float:
    """Dissipation factor 3 (1 - e²)/(4 v) [s/m] for the restitution e at the speed of approach v [m/s].

    Source: Lankarani and Nikravesh 1990, J. Mech. Des. 112:369.
    """
    e, v = _checked("Lankarani and Nikravesh", restitution, speed)
    return 0.75 * (1 - e**2) / v


def _checked(owner: str, restitution: float, speed: float) -> tuple[float, float]:
    e, v = number(restitution, owner, "restitution"), positive(speed, owner, "speed of approach")
    if not 0 <= e <= 1:
        raise ModelError(f"{owner}: restitution {e:g} is not between 0 and 1; correct it")
    return e, v
