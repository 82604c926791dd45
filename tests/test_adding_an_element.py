"""The page "Adding a built-in element" is followed, step by step, in a copy of the checkout."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

LEFT_OUT = shutil.ignore_patterns(
    ".*", "build", "dist", "out", "*.so", "*.egg-info", "__pycache__", "_build", "tests"
)


def blocks(page: Path, language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


def run(folder: Path, *command: str, **environment: str) -> str:
    answer = subprocess.run(
        [sys.executable, *command],
        cwd=folder,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stdout + answer.stderr
    return answer.stdout


@pytest.mark.campaign
def test_the_page_leads_to_an_element_that_is_derived_verified_and_used(
    tmp_path: Path, checkout: Path
) -> None:
    tree = tmp_path / "flexel"
    shutil.copytree(checkout, tree, ignore=LEFT_OUT)
    page, lines, declared, row, model = blocks(checkout / "docs" / "adding-an-element.md", "python")
    (tree / "derive" / "elements" / "pulley.py").write_text(page)
    imported, entry = lines.strip().split("\n\n")
    table = tree / "derive" / "elements" / "__init__.py"
    text = table.read_text().replace("\nELEMENTS:", f"\n{imported}\n\nELEMENTS:", 1)
    table.write_text(text.replace("    TRUSS,\n", f"    TRUSS,\n{entry}\n", 1))
    joints, methods = tree / "parts" / "joints.py", tree / "parts" / "model.py"
    joints.write_text(f"{joints.read_text()}\n\n{declared}")
    imported, entry = row.strip().split("\n\n")
    text, before = methods.read_text(), "    truss = Method(Truss)\n"
    assert text.count(before) == 1
    text = text.replace("\n\nif TYPE_CHECKING", f"\n{imported}\n\nif TYPE_CHECKING", 1)
    methods.write_text(text.replace(before, f"{before}{entry}\n"))

    run(tree, "setup.py", "--quiet", "build_py", "--build-lib", "plain")
    run(tree, "-m", "flexel.derive", "pulley", PYTHONPATH=str(tree / "plain"))
    written = tree / "plain" / "flexel" / "generated"
    assert (written / "pulley.c").is_file()
    for file in written.glob("*.*"):
        shutil.copy(file, tree / "generated")
    library = tree / "library"
    run(tree, "setup.py", "--quiet", "build", "--build-lib", str(library), CFLAGS="-O0")
    verified = run(tree, "-m", "flexel.derive.verify_command", "pulley", PYTHONPATH=str(library))
    assert "pulley" in verified
    (tree / "use.py").write_text(model)
    printed = run(tree, "use.py", PYTHONPATH=str(library))
    acceleration, tension = map(float, re.findall(r"-?\d+\.\d+", printed))
    assert acceleration == pytest.approx(9.81 / 5, rel=1e-12)
    assert abs(tension) == pytest.approx(2 * 3 * 2 * 9.81 / 5, rel=1e-12)
