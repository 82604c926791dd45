"""How long it takes to get going: the import, in a fresh interpreter each time."""

import subprocess
import sys

from timing import Row

PROGRAM = "import time; t = time.perf_counter(); {}; print(time.perf_counter() - t)"


def seconds(statement: str) -> float:
    """Shortest of five times that a statement takes in a fresh interpreter."""
    command = [sys.executable, "-c", PROGRAM.format(statement)]
    return min(
        float(subprocess.run(command, capture_output=True, text=True, check=True).stdout) for _ in range(5)
    )


def measure() -> list[Row]:
    """The figures of this file."""
    return [
        Row("import flexel", seconds("import flexel"), 0.3, 0.3),
        Row("import flexel and Model (numpy, scipy, kernels)", seconds("import flexel; flexel.Model")),
    ]
