"""A user's program is checked by mypy against the installed package: results have types, and none of them is Any."""

import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

PROGRAM = """
import flexel as fx

m = fx.Model(gravity=(0, -9.81))
O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
m.truss("rod", O, A, mass_per_length=1.0)
m.spring("A.y", 100.0)
s = m.build()
motion = s.simulate(1.0)
state = motion[-1]
rest = s.equilibrium()
lin = s.linearize(state)
many = s.simulate_many(1.0, parameters={"rod.rhoA": [1.0, 2.0]})
loci = s.root_loci(parameters={"rod.rhoA": [1.0, 2.0]})
stepper = s.stepper(0.01, inputs=["A.y"], outputs=["A.x"])


def build(length: float) -> fx.Model:
    return m


def analyse(system: fx.System) -> dict[str, float]:
    return {"frequency": float(system.linearize().eigenvalues()[0].imag)}


"""
ARRAY = "numpy.ndarray["  # what follows is spelled by each version of NumPy in its own way
REVEALED = {  # the type of each expression, or how it begins
    "O": "flexel.structure.nodes.Node",
    "s": "flexel.system.System",
    "s.dynamic": "tuple[str, ...]",
    "s.counts": "dict[str, int]",
    "s.summary()": "flexel.analyses.summary.Summary",
    'motion["A.x"]': ARRAY,
    "motion.t": ARRAY,
    "motion[0]": "flexel.structure.state.State",
    "motion[:2]": "list[flexel.structure.state.State]",
    'motion.rate("A.x")': ARRAY,
    'motion.force("rod.elongation")': ARRAY,
    'motion.energy["total"]': ARRAY,
    "motion.message": "str",
    "motion.statistics": "dict[str, int]",
    "motion.events": "list[tuple[str, flexel.structure.state.State]]",
    "motion.to_xarray()": "xarray.core.dataset.Dataset",
    'motion.plot("A.x")': "matplotlib.figure.Figure",
    'state.position("A")': ARRAY,
    'state["A.x"]': "float",
    "state.x": ARRAY,
    "lin": "flexel.mechanics.linearization.Linearization",
    "lin.M": ARRAY,
    "lin.state_matrix": ARRAY,
    'lin.state_space(["A.y"], ["A.x"])[0]': ARRAY,
    "lin.eigenvalues()": ARRAY,
    "lin.modes()": "flexel.base.shown.Listing[flexel.mechanics.modes.Mode]",
    "lin.modes()[0].omega": "float",
    "s.vibrations(rest, count=1)": "flexel.base.shown.Listing[flexel.statics.stability.Vibration]",
    "s.vibrations(rest, count=1)[0].hertz": "float",
    "s.static_path(t_end=1.0)": "flexel.results.motion.Motion",
    "many": "flexel.results.ensemble.Ensemble",
    'many["A.x"]': ARRAY,
    "many.t": ARRAY,
    "loci.stable": ARRAY,
    "stepper.step()": ARRAY,
    "m.check().errors": "tuple[flexel.mechanics.findings.Finding, ...]",
    "m.constraint_report().alternatives": "dict[str, list[str]]",
    'fx.sweep(build, {"length": [1.0]}, analyse)': "xarray.core.dataset.Dataset",
}


@pytest.fixture(scope="module")
def python(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the Python of an environment in which the package is installed as from a wheel, not editable."""
    folder = tmp_path_factory.mktemp("typed")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder / "venv"], check=True)
    packages = next((folder / "venv").glob("lib/python*/site-packages"))
    command = [sys.executable, "setup.py", "--quiet", "build_py", "--build-lib", str(packages)]
    tree = folder / "tree"
    shutil.copytree(
        checkout, tree, ignore=shutil.ignore_patterns("__pycache__", ".*", "build", "tests", "docs", "*.so")
    )
    subprocess.run(command, cwd=tree, check=True, capture_output=True)
    others = {sysconfig.get_path("purelib"), *(str(Path(z).parents[1]) for z in _found("numpy", "xarray"))}
    (packages / "others.pth").write_text("\n".join(others) + "\n")
    return folder / "venv" / "bin" / "python"


def _found(*modules: str) -> list[str]:
    return [str(sys.modules[z].__file__) for z in modules if pytest.importorskip(z)]


@pytest.mark.slow
def test_results_have_types_in_a_users_program(python: Path, tmp_path: Path) -> None:
    pytest.importorskip("mypy", reason="mypy is not installed: types are not checked")
    pytest.importorskip("matplotlib", reason="matplotlib is not installed: the type of figures is unknown")
    program = tmp_path / "program.py"
    program.write_text(PROGRAM + "".join(f"reveal_type({z})\n" for z in REVEALED))
    command = [sys.executable, "-m", "mypy", "--strict", "--python-executable", str(python)]
    answer = subprocess.run(
        [*command, "--cache-dir", str(tmp_path / "cache"), "--config-file", "", str(program)],
        capture_output=True,
        text=True,
        cwd=tmp_path,
    )
    found = [z.replace("builtins.", "") for z in re.findall(r'Revealed type is "(.*)"', answer.stdout)]
    for expression, given in zip(REVEALED, found, strict=True):
        assert given.startswith(REVEALED[expression]), (expression, given)
        assert "dtype[Any]" not in given, (expression, given)
    assert "Success: no issues found" in answer.stdout
    assert answer.returncode == 0
