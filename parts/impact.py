"""Dissipation of contact laws from a coefficient of restitution; `Contact.restitution` uses it.

The laws ``hertz…`` multiply the elastic force by 1 + dissipation × speed of approach.  Both sources hold for
restitutions near one; below 0.8 the rebound is faster than requested (0.85 for 0.8 and 0.67 for 0.2 with
Lankarani and Nikravesh).
"""

from __future__ import annotations

from flexel.base.arguments import number, positive, unknown
from flexel.base.errors import ModelError

# Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369
LAWS = ("hunt-crossley", "lankarani-nikravesh")


def dissipation(restitution: float, speed: float, law: str) -> float:
    """Return the dissipation factor [s/m] for the restitution e at the speed of approach v [m/s].

    It is 3 (1 - e)/(2 v) after Hunt and Crossley, 3 (1 - e²)/(4 v) after Lankarani and Nikravesh.
    """
    owner = "contact"
    if not isinstance(law, str) or law not in LAWS:
        raise ModelError(f"{owner}: {unknown(str(law), LAWS, 'law of restitution')}")
    e, v = number(restitution, owner, "restitution"), positive(speed, owner, "speed of approach")
    if not 0 <= e <= 1:
        raise ModelError(f"{owner}: restitution {e:g} is not between 0 and 1; correct it")
    return 1.5 * (1 - e) / v if law == "hunt-crossley" else 0.75 * (1 - e**2) / v
