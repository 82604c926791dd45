"""Results print on terminals without signs such as × and …, whatever the names in the model."""

import inspect
import os
import subprocess
import sys
from pathlib import Path

import flexel as fx
from flexel.base.shown import printable

PROGRAM = """
import warnings

import flexel as fx

m = fx.Model(gravity=(0, -9.81))
m.point("Stütze", (0, 0), fixed=True)
m.point_mass("Kugel°", m.point("Größe", (1, 0)), 1.0)
m.truss("Стержень", "Stütze", "Größe", stiffness=100.0)
s = m.build()
motion = s.simulate(0.1, samples=5, progress=False)
warnings.simplefilter("ignore")
state = s.equilibrium()
lin = s.linearize(state)
many = s.simulate_many(0.1, parameters={"Kugel°.mass": [1.0, 2.0]}, progress=False)
loci = s.root_loci(state, parameters={"Kugel°.mass": [1.0, 2.0]})
for shown in (m, s, motion, motion.message, motion.energy, state, lin, lin.modes(), s.vibrations(state), s.summary(),
              m.check(), s.parameters, s.along(motion), many, loci, s.structure.nodes[0], m.instances["Стержень"]):
    print(shown, repr(shown))
"""


def test_no_result_raises_where_standard_output_is_ascii(tmp_path: Path) -> None:
    (tmp_path / "names.py").write_text(PROGRAM, encoding="utf-8")
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    said = subprocess.run(
        [sys.executable, tmp_path / "names.py"], env=environment, capture_output=True, text=True, check=False
    )
    assert said.returncode == 0, said.stderr[-2000:]
    assert "St?tze" in said.stdout and "0 ... 0.1 s" in said.stdout


def test_where_they_can_be_printed_signs_stay() -> None:
    assert printable("2 × λ … Größe") == "2 × λ … Größe"


def test_every_public_class_prints_so() -> None:
    """Those that write their own text; what dataclasses write is wrapped by themselves, and errors go to stderr."""
    classes = {name: found for name in fx.__all__ if inspect.isclass(found := getattr(fx, name))}
    texts = {
        f"{name}.{method}": text
        for name, found in classes.items()
        for method in ("__repr__", "__str__")
        if (text := vars(found).get(method)) and not issubclass(found, BaseException)
    }
    assert {"Model.__repr__", "State.__repr__"} <= set(texts)
    assert [name for name, text in texts.items() if not hasattr(text, "__wrapped__")] == []
