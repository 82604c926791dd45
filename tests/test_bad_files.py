"""Bad input: a damaged file of any format that flexel reads raises flexel's own error, or gives what was saved.

One case, to look at it: ``bad_files.verdict(bad_files.Damage("motion.npz", "cut off", 3))`` in a folder of its own.
"""

from collections.abc import Sequence
from pathlib import Path

import pytest
from bad_files import Damage, cases
from bad_process import verdicts

pytest.importorskip("xarray", reason="files .nc and sweeps need pip install 'flexel[xarray]'")


def judge(chosen: Sequence[Damage], folder: Path) -> None:
    """None of the files hangs or crashes the reader, raises a foreign error, or gives other numbers."""
    wrong = verdicts(chosen, folder)
    listed = "\n".join(f"{damage}: {what}" for damage, what in wrong.items())
    print(f"{len(chosen)} damaged files, {len(wrong)} defects")
    assert not wrong, f"{len(wrong)} of {len(chosen)} damaged files:\n{listed}"


@pytest.mark.long
def test_a_sample_of_damaged_files_is_refused(tmp_path: Path) -> None:
    judge(cases(1)[::9], tmp_path)


@pytest.mark.campaign
@pytest.mark.slow
def test_no_damaged_file_slips_through(tmp_path: Path) -> None:
    judge(cases(20), tmp_path)
