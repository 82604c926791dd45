"""Tests whose meshes are coarse on purpose: in them beams are bent or twisted by more than 15° within one element."""

import pytest

# the same elements are compared with another program, with a closed form of theirs, or in their order of convergence
COARSE_MESH = pytest.mark.filterwarnings(
    "ignore:.*(in place of each|logarithmic):flexel.base.errors.RangeWarning"
)
