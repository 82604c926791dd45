"""Print the table of all benchmarks: `python benchmarks/run.py [kernels|bicycle|chains|ropes|start]…`.

Run it on a quiet machine, with OPENBLAS_NUM_THREADS=1.
"""

import importlib
import sys

from timing import Row, yardstick

FILES = ("start", "kernels", "bicycle", "chains", "ropes")


def shown(seconds: float | None) -> str:
    """A time with a unit that suits its size."""
    if seconds is None:
        return "–"
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def line(row: Row, unit: float) -> str:
    """One line of the table; the mark says whether the figure to reach is reached (+), or the aim (++)."""
    mark = ""
    if row.reach is not None and row.aim is not None:
        mark = "++" if row.seconds <= row.aim else "+" if row.seconds <= row.reach else "-"
    figures = f"{shown(row.seconds):>10} {shown(row.reach):>9} {shown(row.aim):>9} {mark:>3}"
    return f"{row.name:<50}{figures} {row.seconds / unit:>11.4g}"


def main(names: list[str]) -> int:
    """Measure and print; returns the exit status."""
    unknown = set(names) - set(FILES)
    if unknown:
        print(f"unknown: {', '.join(sorted(unknown))}; choose among {', '.join(FILES)}", file=sys.stderr)
        return 2
    unit = yardstick()
    print(
        f"yardstick: numpy.linalg.solve of a 40 x 40 system, {shown(unit)}; the last column is in yardsticks"
    )
    print(f"{'':<50}{'measured':>10} {'reach':>9} {'aim':>9} {'':>3} {'ratio':>11}")
    for name in names or FILES:
        for row in importlib.import_module(name).measure():
            print(line(row, unit), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
