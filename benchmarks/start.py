"""How long it takes to get going: flexel, NumPy, SciPy and the kernels imported in a fresh interpreter."""

import resource
import subprocess
import sys

from flexel.benchmarks.timing import Work


def importing() -> Work:
    """The import of `flexel.Model`, without the start of the interpreter."""
    return Work(lambda: fresh("import flexel; flexel.Model"), idle=lambda: fresh("pass"), clock=children)


def fresh(statement: str) -> None:
    """Run a statement in an interpreter of its own."""
    subprocess.run([sys.executable, "-c", statement], check=True)


def children() -> float:
    """CPU time [s] of the processes that have been started and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
