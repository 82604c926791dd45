"""All families of models: strategies of hypothesis that draw a `Case`."""

from hypothesis.strategies import SearchStrategy

import campaign.changes_flexible
import campaign.changes_of_parts
import campaign.parts_beams
import campaign.parts_belts
import campaign.parts_bodies
import campaign.parts_forces
import campaign.parts_joints
import campaign.parts_ropes
import campaign.parts_tyres
import campaign.parts_wheels
import campaign.pool  # noqa: F401 (each registers what its parts mean)
from campaign.case import Case
from campaign.grammar_beams import BEAMS
from campaign.grammar_belts import BELTS
from campaign.grammar_chains import CHAINS
from campaign.grammar_loops import LOOPS
from campaign.grammar_ropes import ROPES
from campaign.grammar_tyres import TYRES
from campaign.grammar_wheels import WHEELS

FAMILIES: dict[str, SearchStrategy[Case]] = {
    **CHAINS,
    **LOOPS,
    **WHEELS,
    **BEAMS,
    **BELTS,
    **ROPES,
    **TYRES,
}
