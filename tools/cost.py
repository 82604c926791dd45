"""Count what small works cost, and compare with ``tools/cost.json``: a figure that grows is seen, on any machine.

``python tools/cost.py`` prints the table and fails where a figure is more than 5 % above the kept one, with the
functions that grew, or as much below it: then ``--write`` keeps the new figures. A work costs the calls of Python
functions of flexel, the calls from them to other libraries, and the evaluations of a motion; nothing is timed.
`tests/tools/test_cost.py` runs it in `make test`.
"""

from __future__ import annotations

import argparse
import importlib
import json
import platform
import sys
import tempfile
import warnings
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from types import FrameType
from typing import Any

KEPT = Path(__file__).parent / "cost.json"
GROWTH = 1.05  # factor above which a figure fails
LISTED = 25  # functions kept with each work, those called most often
SHOWN = 5  # functions that a message names


@dataclass
class Cost:
    """What a work costs.

    Attributes
    ----------
    own : int
        Calls of Python functions of flexel.
    others : int
        Calls from these to functions of other libraries and of Python itself.
    evaluations : int
        Evaluations of the equations of motion, for motions.
    functions : dict of str to int
        The functions called most often.
    """

    own: int = 0
    others: int = 0
    evaluations: int = 0
    functions: dict[str, int] = field(default_factory=dict)

    def figures(self) -> dict[str, int]:
        """Return the compared figures."""
        return {"own": self.own, "others": self.others, "evaluations": self.evaluations}


def _name(frame: FrameType) -> str:
    """Return module and function of a frame; empty outside of flexel."""
    module = str(frame.f_globals.get("__name__", ""))
    return f"{module}.{frame.f_code.co_qualname}" if module.partition(".")[0] == "flexel" else ""


def counted(work: Callable[[], Any]) -> Cost:
    """Run a work once to warm up and once to count."""
    work()
    own: Counter[str] = Counter()
    others: Counter[str] = Counter()

    def profile(frame: FrameType, event: str, called: Any) -> None:
        if event == "call":
            name = _name(frame)
            if name:
                own[name] += 1
            elif frame.f_back is not None and (caller := _name(frame.f_back)):
                others[f"{caller} → {frame.f_code.co_name}"] += 1
        elif event == "c_call" and (caller := _name(frame)):
            others[f"{caller} → {getattr(called, '__name__', called)}"] += 1

    sys.setprofile(profile)
    try:
        found = work()
    finally:
        sys.setprofile(None)
    runs = getattr(found, "statistics", [])
    evaluations = sum(run["evaluations"] for run in (runs if isinstance(runs, list) else [runs]))
    most = dict((own + others).most_common(LISTED))
    return Cost(own.total(), others.total(), int(evaluations), most)


def works() -> dict[str, Callable[[], Any]]:
    """Return small works by name, each with its models built."""
    import numpy as np

    import flexel as fx
    from flexel.examples import bicycle

    ride = bicycle.bicycle()
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("P0", (0, 0, 0), fixed=True)
    m.frame("R0", fixed=True)
    for i in range(1, 9):
        m.point(f"P{i}", (0.05 * i, 0, 0))
        m.frame(f"R{i}")
        m.beam(
            f"leaf{i}", f"P{i - 1}", f"R{i - 1}", f"P{i}", f"R{i}",
            direction=(0, 1, 0), section=fx.Rectangle(1e-3, 20e-3), material="steel",
        )  # fmt: skip
    beam = m.build()
    rest = beam.equilibrium()
    p = fx.Model(gravity=(0, -9.81))
    line = p.chain("chain", [(0, 0), (1, 0)], 3, mass_per_length=1.0)
    p.fix(line.points[0])
    links = p.build()
    masses = {"frame and rider.mass": np.linspace(80.0, 90.0, 5)}
    speeds = np.linspace(4.0, 5.0, 5)
    moved = links.simulate(0.5, samples=51)
    y = np.concatenate([links.initial.q, links.initial.qd])
    end = line.points[-1]
    events = [
        fx.Event("far", lambda state: state[f"{end.name}.x"] - 5.0),
        fx.Event("low", lambda state: state[f"{end.name}.y"] + 0.5),
    ]

    def rolling(speed: float) -> fx.State:
        return ride.state_at(rates={"rear spin.angle": -speed / 0.3})

    def saved() -> None:
        with tempfile.TemporaryDirectory() as folder:
            fx.load(moved.save(Path(folder) / "motion.npz"))

    def viewed() -> None:
        with tempfile.TemporaryDirectory() as folder:
            moved.view(Path(folder) / "motion.html")

    return {
        "build bicycle": lambda: bicycle.model().build(),
        "build 8 beams": m.build,
        "state_at with rates": lambda: rolling(4.6),
        "rhs": lambda: [links.rhs(0.0, y) for _ in range(10)],
        "linearize": lambda: ride.linearize(ride.initial),
        "eigenvalues": lambda: ride.linearize(ride.initial).eigenvalues(),
        "root loci": lambda: [ride.linearize(rolling(speed)).modes() for speed in speeds],
        "linearize_many": lambda: ride.linearize_many(parameters=masses, threads=1, progress=False),
        "DOP853": lambda: links.simulate(0.5, method="DOP853", samples=11),
        "events": lambda: links.simulate(0.5, method="DOP853", samples=11, events=events),
        "Radau": lambda: links.simulate(0.5, method="Radau", rtol=1e-6, samples=11),
        "generalized-alpha": lambda: links.simulate(0.5, method="generalized-alpha", samples=11),
        "simulate_many": lambda: ride.simulate_many(
            0.1, parameters=masses, threads=1, progress=False, samples=3
        ),
        "equilibrium": lambda: beam.equilibrium(),
        "vibrations": lambda: beam.vibrations(rest),
        "save and load": saved,
        "view": viewed,
    }


def locked() -> str:
    """Return the reason why counts cannot be compared here; empty with the Python and the versions they belong to."""
    kept = json.loads(KEPT.read_text(encoding="utf-8"))["versions"]
    here = versions()
    other = [f"{name} {here[name]} for {version}" for name, version in kept.items() if here[name] != version]
    return f"tools/cost.json belongs to other versions: {', '.join(other)}" if other else ""


def versions() -> dict[str, str]:
    """Return the versions on which counts depend."""
    found = {"python": ".".join(platform.python_version_tuple()[:2])}
    return found | {
        name: importlib.import_module(name).__version__ for name in ("numpy", "scipy", "matplotlib")
    }


def changed(name: str, now: Cost, kept: Cost) -> list[str]:
    """Return a line for each figure of a work that is too large, with the functions that grew most, or out of date."""
    lines = []
    before = kept.figures()
    for figure, value in now.figures().items():
        if GROWTH * value < before[figure]:
            lines.append(f"{name}: {figure} only {value} for {before[figure]}: python tools/cost.py --write")
        if value > GROWTH * before[figure]:
            more = {f: n - kept.functions.get(f, 0) for f, n in now.functions.items()}
            most = sorted((f for f in more if more[f] > 0), key=lambda f: -more[f])[:SHOWN]
            listed = ", ".join(f"{f} (+{more[f]})" for f in most) or "many functions a little"
            lines.append(f"{name}: {figure} {before[figure]} → {value}; {listed}")
    return lines


def measured() -> dict[str, Cost]:
    """Count all works."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return {name: counted(work) for name, work in works().items()}


def kept() -> dict[str, Cost]:
    """Return the kept figures."""
    found = json.loads(KEPT.read_text(encoding="utf-8"))["works"]
    return {name: Cost(**figures) for name, figures in found.items()}


def main() -> int:
    """Print the table, and compare it or keep it."""
    parser = argparse.ArgumentParser(description="Count what small works cost.")
    parser.add_argument("--write", action="store_true", help="keep the figures")
    write = parser.parse_args().write
    found = measured()
    for name, cost in found.items():
        print(f"{name:24}{cost.own:9d} own{cost.others:9d} other calls{cost.evaluations:7d} evaluations")
    if write:
        content = {"versions": versions(), "works": {name: asdict(cost) for name, cost in found.items()}}
        KEPT.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        return 0
    if reason := locked():
        print(reason, file=sys.stderr)
        return 1
    before = kept()
    lines = [line for name, cost in found.items() for line in changed(name, cost, before.get(name, Cost()))]
    print(*lines, sep="\n", file=sys.stderr)
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main())
