"""The table of laws: constitutive functions without geometry.

A law is attached by the runtime to any list of deformations and slips, so it has its own small numbers m of
deformations, k of slips and nz of internal states.
"""

from flexel.derive.declare import Law
from flexel.derive.laws.beam_elasticity import BEAM
from flexel.derive.laws.cable_laws import CABLE
from flexel.derive.laws.contact_laws import CONTACT
from flexel.derive.laws.held import HELD
from flexel.derive.laws.joint import JOINT
from flexel.derive.laws.journal import JOURNAL
from flexel.derive.laws.linear_laws import LINEAR
from flexel.derive.laws.suspension import CURVES
from flexel.derive.laws.tyre_laws import TYRES

LAWS: tuple[Law, ...] = (*LINEAR, *BEAM, *CABLE, *CURVES, *TYRES, *CONTACT, *JOURNAL, *JOINT, *HELD)
