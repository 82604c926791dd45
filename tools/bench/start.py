"""Times the start: flexel, NumPy, SciPy and the kernels imported in a fresh interpreter."""

import resource
import subprocess
import sys

from bench.timing import Work


def importing() -> Work:
    """Time the import of `flexel.Model`, without the start of the interpreter."""
    return Work(lambda: fresh("import flexel; flexel.Model"), idle=lambda: fresh("pass"), clock=children)


def fresh(statement: str) -> None:
    """Run a statement in a new interpreter."""
    subprocess.run([sys.executable, "-c", statement], check=True)


def children() -> float:
    """Return the CPU time [s] of the child processes that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
