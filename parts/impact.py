"""Dissipation of contact laws from a coefficient of restitution; `Contact.restitution` uses it.

The laws ``hertz…`` multiply the elastic force by 1 + c × speed of approach, as Hunt and Crossley do.  An impact that
begins with the speed v then ends with the speed e v if c v (1 + e) = ln((1 + c v) / (1 - c e v)), whatever the mass and
the elastic force are.  The factors of the literature are approximations for restitutions near one: 0.5 becomes 0.66
with that of Hunt and Crossley, 0.73 with that of Lankarani and Nikravesh.
"""

from __future__ import annotations

import math

from scipy.optimize import brentq

from flexel.base.arguments import number, positive, unknown
from flexel.base.errors import ModelError

SMALLEST_RESTITUTION = 1e-3  # the dissipation is then a thousand over the speed
# Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369
LAWS = ("exact", "hunt-crossley", "lankarani-nikravesh")


def dissipation(restitution: float, speed: float, law: str) -> float:
    """Return the dissipation factor c [s/m] for the restitution e at the speed of approach v [m/s].

    By default the one with which the impact has this restitution; else 3 (1 - e)/(2 v) after Hunt and Crossley, or
    3 (1 - e²)/(4 v) after Lankarani and Nikravesh.
    """
    owner = "contact"
    if not isinstance(law, str) or law not in LAWS:
        raise ModelError(f"{owner}: {unknown(str(law), LAWS, 'law of restitution')}")
    e, v = number(restitution, owner, "restitution"), positive(speed, owner, "speed of approach")
    if not 0 <= e <= 1:
        raise ModelError(f"{owner}: restitution {e:g} is not between 0 and 1; correct it")
    if law == "exact":
        return _product(e, owner) / v
    return 1.5 * (1 - e) / v if law == "hunt-crossley" else 0.75 * (1 - e**2) / v


def _product(e: float, owner: str) -> float:
    """Return c v for a restitution."""
    if e < SMALLEST_RESTITUTION:
        raise ModelError(
            f"{owner}: restitution {e:g} takes a dissipation without bound; give a small number instead, such as 0.05"
        )

    def excess(d: float) -> float:
        return d * (1 + e) - math.log1p(d) + math.log1p(-e * d)

    # it is d² (1 - e²)/2 at first, and falls without bound up to 1/e, but only close to it where e is small
    most = (1 - 1e-15) / e
    if e == 1 or excess(most) >= 0:
        return most * (e < 1)
    return float(brentq(excess, (1 - e) / 2, most, xtol=1e-16 * (1 - e)))
