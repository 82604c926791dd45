"""Names of time histories: quantities, with primes for their rates, and ``force:`` for stresses and reactions."""

from __future__ import annotations

from dataclasses import dataclass

from flexel.base.arguments import quantities
from flexel.base.errors import ModelError
from flexel.base.units import force_unit, rate_unit
from flexel.model.structure import Structure


@dataclass(frozen=True)
class History:
    """A time history: the value, rate, acceleration or force of a quantity.

    Attributes
    ----------
    base : str
        The quantity or internal state.
    order : int
        0 for its value, 1 for its rate, 2 for its acceleration; -1 for its stress or reaction.
    unit : str
    """

    base: str
    order: int
    unit: str


def history(structure: Structure, name: str) -> History:
    """Return the time history with a name.

    Raises
    ------
    ModelError
        An unknown name, more than two primes, a rate of a force, the value of a slip.
    """
    quantities([name], "history")
    base = name.removeprefix("force:").rstrip("'")
    order = len(name) - len(base)
    if base in structure.internal:
        if name not in (base, f"{base}'"):
            raise ModelError(
                f"'{name}': an internal state of a law has a value and a rate; leave the rest out"
            )
        unit = structure.internal_units[structure.internal[base]]
        return History(base, order, rate_unit(unit, 1) if order else unit)
    if base in structure.commands:
        if order or name != base:
            raise ModelError(f"'{name}': the output of a controller has only a value; leave the rest out")
        controller, place = structure.commands[base]
        i = structure.index[controller.outputs[place]]
        slip = structure.m <= i < structure.m + structure.k
        return History(base, 0, force_unit(structure.units[i], slip))
    i = structure.find(base)
    slip = structure.m <= i < structure.m + structure.k  # its unit is already that of a rate
    if name.startswith("force:"):
        if name.endswith("'"):
            raise ModelError(f"'{name}': forces have no rates here; leave the primes out")
        return History(base, -1, force_unit(structure.units[i], slip))
    if order > 2:
        raise ModelError(f"'{name}': only first and second rates exist; use at most two primes")
    if not order and slip:
        raise ModelError(f"'{name}' is a slip, which has no value; name its rate '{name}''")
    unit = structure.units[i]
    return History(base, order, rate_unit(unit, order - 1 if slip else order) if order else unit)
