"""Checks that results have types in a user's program, and none of them is Any; `make types` runs it.

`python .ci/users_types.py TREE` lets mypy read a program against the package in TREE, laid out as a wheel installs it
and on the path of an environment, as user's are: mypy takes its types from there only if it says that it has some.
"""

import re
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

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
    "O": "flexel.model.node.Node",
    "s": "flexel.results.system_facade.System",
    "s.dynamic": "tuple[str, ...]",
    "s.counts": "dict[str, int]",
    "s.summary()": "flexel.results.analyses.summary.Summary",
    'motion["A.x"]': ARRAY,
    "motion.t": ARRAY,
    "motion[0]": "flexel.model.state.State",
    "motion[:2]": "list[flexel.model.state.State]",
    'motion.rate("A.x")': ARRAY,
    'motion.force("rod.elongation")': ARRAY,
    'motion.energy["total"]': ARRAY,
    "motion.message": "str",
    "motion.statistics": "dict[str, int]",
    "motion.events": "list[tuple[str, flexel.model.state.State]]",
    "motion.to_xarray()": "xarray.core.dataset.Dataset",
    'motion.plot("A.x")': "matplotlib.figure.Figure",
    'state.position("A")': ARRAY,
    'state["A.x"]': "float",
    "state.x": ARRAY,
    "lin": "flexel.results.linearization.Linearization",
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


def revealed(tree: Path, folder: Path) -> str:
    """Return what mypy reports on the program, in an environment with the packages of this one."""
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder / "venv"], check=True)
    packages = next((folder / "venv").glob("lib/python*/site-packages"))
    (packages / "others.pth").write_text(f"{tree.resolve()}\n{sysconfig.get_path('purelib')}\n")
    program = folder / "program.py"
    program.write_text(PROGRAM + "".join(f"reveal_type({expression})\n" for expression in REVEALED))
    command = [
        sys.executable,
        "-m",
        "mypy",
        "--strict",
        "--python-executable",
        folder / "venv" / "bin" / "python",
    ]
    answer = subprocess.run(
        [*command, "--cache-dir", folder / "cache", "--config-file", "", program],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
    )
    if answer.returncode or "Success: no issues found" not in answer.stdout:
        sys.exit(answer.stdout + answer.stderr)
    return answer.stdout


def main(tree: str) -> None:
    """Compare all types; stop with a status of 1 at those that differ."""
    with tempfile.TemporaryDirectory() as folder:
        said = revealed(Path(tree), Path(folder))
    found = [name.replace("builtins.", "") for name in re.findall(r'Revealed type is "(.*)"', said)]
    wrong = [
        f"{expression} is {given}, and should be {wanted}…"
        for (expression, wanted), given in zip(REVEALED.items(), found, strict=True)
        if not given.startswith(wanted) or "dtype[Any]" in given
    ]
    if wrong:
        sys.exit("\n".join(wrong))
    print(f"{len(found)} types of a user's program are as they should be")


if __name__ == "__main__":
    main(*sys.argv[1:])
