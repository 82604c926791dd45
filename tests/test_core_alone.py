"""The core runs alone: a part defined here is built, moved and linearized without parts, results and apps."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ABOVE = ("parts", "results", "apps", "examples")
PROGRAM = '''
import importlib, sys

sys.meta_path = [finder for finder in sys.meta_path if "editable" not in getattr(finder, "__module__", "")]

import numpy as np

from flexel.compile import build
from flexel.integration.simulation import begun, ended
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part, quantity
from flexel.system import CoreSystem


@part
class Pendulum(Part[None]):
    """A rigid bar that hangs from a fixed point."""

    name: str
    length: float = quantity("m", "positive", "Length of the bar.")
    mass: float = quantity("kg", "positive", "Mass of the bar.")

    def lower(self, to):
        pivot = to.node(f"{self.name} pivot", "planar_point", np.zeros(2), True)
        tip = to.node(f"{self.name} tip", "planar_point", np.array([0.0, -self.length]), False)
        to.element(
            self.name, "planar_truss", [pivot, tip], {"l0": self.length, "rhoA": self.mass / self.length}
        )


model = Lowering((0.0, -9.81))
model.add(Pendulum("bob", 1.5, 2.0))
system = build(model, 0.0, CoreSystem)

rate = np.sqrt(9.81 * 1.5 / 2 / (1.5**2 / 3))  # of small oscillations
eigenvalues = system.linearize(system.initial).eigenvalues()
assert np.abs(np.sort(eigenvalues.imag) - [-rate, rate]).max() < 1e-12 * rate

times = np.linspace(0.0, 2.0, 21)
motion = begun(system, 2.0, start=system.state_at(rates={"bob tip.x": 0.3}), times=times)
found = ended(system, motion, times)
energies = [state.energy.total for state in found.states]
assert len(found.states) == 21 and np.ptp(energies) < 1e-8, np.ptp(energies)

for name in ABOVE:
    try:
        importlib.import_module(f"flexel.{name}")
    except ModuleNotFoundError:
        continue
    raise AssertionError(f"flexel.{name} is there")
print("runs")
'''


def test_a_part_is_built_moved_and_linearized_by_the_core_alone(tmp_path: Path) -> None:
    package = tmp_path / "flexel"
    package.mkdir()
    for path in (ROOT / "runtime").iterdir():
        (package / path.name).symlink_to(path)
    for name in ("derive", "generated"):
        (package / name).symlink_to(ROOT / name)
    program = PROGRAM.replace("ABOVE", repr(ABOVE))
    run = subprocess.run(
        [sys.executable, "-c", program],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env={"PYTHONPATH": str(tmp_path)},
    )
    assert run.stdout == "runs\n", run.stderr
