"""Units derived from that of a quantity: of its rates, and of the generalized force that does work on it."""

from __future__ import annotations

# Powers of metre and second, and whether it is an angle, for the units in the element table.
_POWERS = {"m": (1, 0, ""), "rad": (0, 0, "rad"), "1": (0, 0, ""), "-": (0, 0, ""),
           "m/s": (1, -1, ""), "rad/s": (0, -1, "rad"), "m^2/s": (2, -1, ""), "1/s": (0, -1, "")}  # fmt: skip
_FORCES = {"m": "N", "m/s": "N", "m^2/s": "N/m", "rad/m": "N m²"}
_POWER_SIGNS = {1: "", 2: "²", 3: "³"}


def rate_unit(unit: str, order: int) -> str:
    """Return the unit of the rate of that order; `unit` itself for order 0.

    Examples
    --------
    >>> rate_unit("m", 2), rate_unit("rad/s", 1), rate_unit("-", 1)
    ('m/s²', 'rad/s²', '1/s')
    """
    if order == 0:
        return unit
    if unit not in _POWERS:  # of a user-defined element
        return f"({unit})/s{_POWER_SIGNS[order]}"
    metres, seconds, angle = _POWERS[unit]
    top = f"m{_POWER_SIGNS[metres]}" if metres else angle or "1"
    return f"{top}/s{_POWER_SIGNS[order - seconds]}"


def force_unit(unit: str, slip: bool) -> str:
    """Return the unit of the stress conjugate to a deformation or slip, or of the force on a coordinate.

    Examples
    --------
    >>> force_unit("m", slip=False), force_unit("rad/s", slip=True), force_unit("1", slip=False)
    ('N', 'N m', 'N m')
    """
    if unit in _FORCES:
        return _FORCES[unit]
    if unit in _POWERS:
        return "N m"
    return f"W/({unit})" if slip else f"J/({unit})"
