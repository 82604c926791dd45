"""States between the ends of constant steps of the generalized-alpha method, with the terms of the energy balance."""

from __future__ import annotations

from flexel.integration.energy_balance import EnergyBalance
from flexel.integration.replay import Replay
from flexel.model.state import State


def between(replay: Replay, kept: EnergyBalance, t0: float, t: float) -> State:
    """Return the state at a time within the present step, and store the terms of its energy balance.

    Parameters
    ----------
    replay : Replay
    kept : EnergyBalance
        That of the motion, to whose lists it stores.
    t0, t : float
        Start of the step, and the time [s].
    """
    twin, found = replay.balance(replay.number, t)
    balance = EnergyBalance(twin)
    balance.follow(kept)
    balance.look()
    balance.add(t - t0)
    balance.keep()
    return twin.state(found)
