"""The built system as users see it: its core and the table of its analyses."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from flexel.base.arrays import Array
from flexel.model.parameters import Parameters
from flexel.results.analyses import (
    along,
    ensembles,
    equilibria,
    linearizing,
    motions,
    periodic_motions,
    restoring,
    stepper,
)
from flexel.results.analyses.summary import Summary, summarized
from flexel.system import CoreSystem


class System(CoreSystem):
    """A mechanism ready for analysis; made by `Model.build`.

    Every analysis is a function of a system, in `flexel.results.analyses`; here they become its methods.

    Attributes
    ----------
    structure : Structure
        Names and index maps.
    roles : Roles
        The constraints and the current choice of degrees of freedom.
    """

    simulate = motions.simulate
    simulate_many = ensembles.simulate_many
    stepper = stepper.stepper
    restore = restoring.restore

    equilibrium = equilibria.equilibrium
    static_path = equilibria.static_path
    steady = equilibria.steady
    buckling = equilibria.buckling
    vibrations = equilibria.vibrations
    compliance = equilibria.compliance

    linearize = linearizing.linearize
    linearize_many = linearizing.linearize_many
    along = along.along
    root_loci = linearizing.root_loci

    periodic = periodic_motions.periodic
    periodic_branch = periodic_motions.periodic_branch

    with_parameters = ensembles.with_parameters

    @property
    def parameters(self) -> Mapping[str, Array]:
        """Values of all parameters by name, those of parts first; read only.

        Parts have those of their declaration: ``leaf.EIz``, ``leaf.section.height``, ``rider.mass``.  What follows
        from these in elements and laws has names too: springs and dampers have ``stiffness``, ``damping`` and
        ``preload`` after the name of what they act on, ``strut.elongation.stiffness``.
        """
        return self._parameters

    @cached_property
    def _parameters(self) -> Parameters:
        """They are found once: a large model has many names."""
        return Parameters(self.structure, self.origin)

    def summary(self) -> Summary:
        """Summarize degrees of freedom, constraints, eigenvalues at the start and a suitable integrator in a table."""
        return summarized(self)

    def _repr_html_(self) -> str:
        return self.summary()._repr_html_()
