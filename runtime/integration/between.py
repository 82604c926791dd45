"""States between the ends of constant steps of the generalized-alpha method, each by a separate, shorter step."""

from __future__ import annotations

from flexel.integration.alpha import AlphaStepper
from flexel.integration.energy_balance import EnergyBalance
from flexel.model.state import State


class Between:
    """Computes states within steps of a motion, which continues as if they had not been requested.

    Parameters
    ----------
    stepper : AlphaStepper
        That of the motion.
    balance : EnergyBalance
        That of the motion, to whose lists it stores.
    start : State
        Any state of the motion.
    scheme : float, str
        Spectral radius and kind of Newton's method.
    """

    def __init__(
        self, stepper: AlphaStepper, balance: EnergyBalance, start: State, scheme: tuple[float, str]
    ) -> None:
        self._of, self._kept = stepper, balance
        self._stepper = AlphaStepper(stepper.system, start, *scheme)
        self._stepper.inside = stepper.inside
        self._balance = EnergyBalance(self._stepper)

    def state(self, t: float, shortest: float) -> State | None:
        """Compute the state at a time [s] within the step that begins at the current point; None if it is not found.

        Parameters
        ----------
        t, shortest : float
            The time, and the shortest step to it [s].
        """
        stepper, balance = self._stepper, self._balance
        stepper.follow(self._of)
        balance.follow(self._kept)
        while stepper.t < t:
            rest = h = t - stepper.t
            while not stepper.step(h):
                h /= 2
                if h < shortest:
                    return None
            balance.look()
            balance.add(h)
            stepper.accept(t if h == rest else stepper.t + h)
        balance.keep()
        return stepper.state(stepper.current())
