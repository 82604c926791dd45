"""Describes the machine on which figures are measured, and limits the BLAS to one thread.

NumPy is not imported here: it reads the number of threads when it is imported.
"""

from __future__ import annotations

import os
import platform
import sys
from pathlib import Path

VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
CPU_FILE = Path("/proc/cpuinfo")


def one_thread() -> bool:
    """Limit the BLAS to one thread; return whether the limit was set in time.

    Thread CPU time does not count what other threads compute.
    """
    late = "numpy" in sys.modules and os.environ.get("OPENBLAS_NUM_THREADS") != "1"
    os.environ.update(dict.fromkeys(VARIABLES, "1"))
    return not late


def machine() -> str:
    """Describe processor, Python, NumPy, and the flags with which the kernels are compiled."""
    import numpy

    from flexel.generated.build import FLAGS

    return f"{processor()}; Python {platform.python_version()}, NumPy {numpy.__version__}; kernels {' '.join(FLAGS)}"


def processor() -> str:
    """Return model and number of the processors."""
    lines = CPU_FILE.read_text(encoding="utf-8").splitlines() if CPU_FILE.is_file() else []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return f"{models[0] if models else platform.machine()}, {os.cpu_count()} processors"
