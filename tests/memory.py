"""The memory of this process."""

import gc
import os
from pathlib import Path


def resident() -> float:
    """Memory that is in use [MB]; Linux only."""
    gc.collect()
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20
