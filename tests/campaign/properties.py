"""All properties, with what is tolerated."""

from collections.abc import Callable
from dataclasses import dataclass

from campaign import properties_changes as changes
from campaign import properties_coordinates as coordinates
from campaign import properties_equations as equations
from campaign import properties_motion as motion
from campaign import properties_stresses as flexible
from campaign.trial import Trial


@dataclass(frozen=True)
class Property:
    """A property of every model.

    Attributes
    ----------
    name : str
    error : callable(Trial) -> float
        What is measured; raises Inapplicable where it has nothing to say.
    tolerance : float
    """

    name: str
    error: Callable[[Trial], float]
    tolerance: float


PROPERTIES = (
    Property("constraints are satisfied", equations.constraints, 1e-10),
    Property("degrees of freedom", equations.degrees_of_freedom, 0.0),
    Property("redundant constraints", equations.redundancy, 0.0),
    Property("accelerations", equations.accelerations, 1e-9),
    Property("reactions of the ground", equations.reactions, 1e-9),
    Property("stresses", flexible.stresses, 1e-9),
    Property("energy", equations.energy, 1e-9),
    Property("linearization", equations.linearization, 1e-6),
    Property("accelerations in other coordinates", coordinates.other_coordinates, 1e-9),
    Property("motion in other coordinates", coordinates.motion_in_others, 1e-7),
    Property("eigenvalues in other coordinates", coordinates.eigenvalues, 1e-6),
    Property("turned and shifted", changes.turned, 1e-9),
    Property("mirrored", changes.mirrored, 1e-9),
    Property("other units", changes.units, 1e-9),
    Property("motion turned and in other units", changes.motion_elsewhere, 1e-8),
    Property("planar is spatial", changes.planar_is_spatial, 1e-9),
    Property("energy is kept", motion.energy_kept, 1e-8),
    Property("momentum is kept", motion.momentum, 1e-8),
    Property("time reversed", motion.time_reversal, 1e-8),
    Property("explicit is implicit", motion.implicit, 1e-6),
    Property("continued from a file", motion.continued, 1e-8),
    Property("a loose part is named", motion.loose_part, 0.0),
)
