"""Linearized equations with sampled controllers: the closed loop, as eigenvalues of the open one have no meaning."""

from __future__ import annotations

from typing import TYPE_CHECKING

from flexel.mechanics.steadiness import check_steady
from flexel.structure.controllers import refuse_sampled
from flexel.structure.state import State

if TYPE_CHECKING:
    from flexel.linear.sampled import SampledLoop

INSTEAD = (
    "between its instants the loop is open; linearize().sampled() has the eigenvalues of the closed loop"
)


class SampledLinearization:
    """Methods of a linearization with sampled controllers."""

    state: State

    @property
    def acceleration(self) -> float:
        """Size of the accelerations at the state."""
        raise NotImplementedError

    def sampled(self) -> SampledLoop:
        """The closed loop of the sampled controllers over one period.

        Controllers may have different periods: the loop then covers their least common multiple, and begins at a time
        at which all of them measure.

        Raises
        ------
        LinearizationError
            If no controller is sampled, if periods have no common multiple that is short enough, or if a controller is
            not smooth or at its limit there.

        Warns
        -----
        UnsteadyWarning
            If the state is not a fixed point of the loop: it accelerates, or a controller would change its outputs.

        Examples
        --------
        >>> system.linearize().sampled().eigenvalues()  # doctest: +SKIP
        """
        from flexel.linear.sampled import sampled_loop

        return sampled_loop(self)  # type: ignore[arg-type]

    def _check(self, owner: str) -> None:
        """Refuse eigenvalues if a controller is sampled; warn where the state accelerates."""
        refuse_sampled(self.state.structure.controllers, owner, INSTEAD)
        check_steady(owner, self.acceleration, 4)
