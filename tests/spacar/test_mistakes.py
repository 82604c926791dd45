"""Files with mistakes end in results or in flexel's messages, never in a foreign error.

One case, to look at it: ``bad_spacar.verdict(bad_spacar.Mistake("slider_crank.dat", 3))`` in a folder of its own.
"""

from collections.abc import Sequence
from pathlib import Path

import pytest
from bad_process import verdicts
from bad_spacar import Mistake, cases
from coarse import COARSE_MESH


def judge(chosen: Sequence[Mistake], folder: Path) -> None:
    wrong = verdicts(chosen, folder)
    listed = "\n".join(f"{mistake}: {what}" for mistake, what in wrong.items())
    print(f"{len(chosen)} files with mistakes, {len(wrong)} defects")
    assert not wrong, f"{len(wrong)} of {len(chosen)} files with mistakes:\n{listed}"


@pytest.mark.long
def test_a_sample_of_files_with_mistakes_ends_in_results_or_messages(tmp_path: Path) -> None:
    judge(cases(8), tmp_path)


@COARSE_MESH
@pytest.mark.campaign
@pytest.mark.slow
def test_2000_files_with_mistakes_end_in_results_or_messages(tmp_path: Path) -> None:
    judge(cases(400), tmp_path)
