"""`flexel derive`, `verify` and `show` of a user's page, and of built-in elements."""

import importlib.util
import re
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from own_pages import CAM, CAM_LINE, ROOT, RUBBER

from flexel.apps.cli import main as cli

STRICT = ("-std=c11", "-O0", "-fopenmp-simd", "-Wall", "-Wextra", "-Wpedantic", "-Werror")


@pytest.fixture(scope="module", autouse=True)
def cache(tmp_path_factory: pytest.TempPathFactory) -> object:
    """An empty cache: everything is derived and compiled here."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli.main, list(map(str, arguments)))


def written(folder: Path, text: str, name: str = "page.py") -> Path:
    path = folder / name
    path.write_text(text)
    return path


@pytest.fixture
def page(tmp_path: Path) -> Path:
    """The cam and the rubber."""
    return written(tmp_path, CAM + RUBBER)


def test_the_c_of_a_page_compiles_and_is_checked(page: Path, tmp_path: Path) -> None:
    out = tmp_path / "c"
    result = run("derive", page, "--out", out)
    assert result.exit_code == 0, result.output
    assert sorted(path.name for path in out.iterdir()) == [
        "cam.c",
        "catalogue.h",
        "kernels.h",
        "laws.c",
        "table.py",
    ]
    for name in ("cam.c", "laws.c"):
        subprocess.run(["cc", *STRICT, "-c", name, "-o", f"{name}.o"], cwd=out, check=True)
    spec = importlib.util.spec_from_file_location("table", out / "table.py")
    assert spec is not None and spec.loader is not None
    table = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(table)
    assert [*table.ELEMENTS, *table.LAWS] == ["cam", "rubber"]
    assert run("derive", page, "--out", out, "--check").exit_code == 0
    (out / "cam.c").write_text("")
    (out / "own.c").write_text("int mine;\n")
    checked = run("derive", page, "--out", out, "--check")
    assert checked.exit_code == 1 and "differs: " in checked.output and "own.c" not in checked.output
    again = run("derive", page, "--out", out)
    assert "1 files changed" in again.output and (out / "own.c").is_file()


def test_one_of_a_page_is_derived_alone(page: Path, tmp_path: Path) -> None:
    assert run("derive", page, "rubber", "--out", tmp_path / "c").exit_code == 0
    assert "laws.c" in [path.name for path in (tmp_path / "c").iterdir()]
    assert not (tmp_path / "c" / "cam.c").exists()


def test_verify_prints_the_errors_of_a_page(page: Path) -> None:
    result = run("verify", page)
    assert result.exit_code == 0, result.output
    lines = result.output.splitlines()
    assert lines[0].split() == ["element", "kernel", "output", "differences", "definition", "batch"]
    assert "15 outputs, all within tolerance" in lines[-1]
    assert {line.split("  ")[0] for line in lines[1:-1]} == {"cam", "law rubber"}
    assert "6 outputs" in run("verify", page, "rubber").output


def test_verify_takes_the_ranges_of_the_page(tmp_path: Path) -> None:
    """A root is real in a range only; each element takes the ranges of what it has."""
    bare = run("verify", written(tmp_path, ROOT))
    assert bare.exit_code == 1 and "element 'first_root': " in bare.output and "ranges=" in bare.output
    assert "page.py, line 6" in bare.output
    path = written(tmp_path, CAM + ROOT + 'ranges = {"p_x": (0.3, 1.0), "base": (0.1, 0.2)}\n')
    assert run("verify", path, "first_root", "cam").exit_code == 0
    wrong = run("verify", written(tmp_path, CAM + 'ranges = {"bse": (0.1, 0.2)}\n'))
    assert wrong.exit_code == 1 and "'bse'" in wrong.output and "base" in wrong.output


def test_an_element_with_joined_pieces_is_verified_as_when_it_is_compiled(tmp_path: Path) -> None:
    text = """
import sympy as sp
from flexel.derive import Deformation, Element, Parameter, PlanarPoint
p, l0 = PlanarPoint("p"), Parameter("l0", 1, "m", "length")
x = p.x[0]
stop = sp.Piecewise((x, x < l0.symbol), (x + (x - l0.symbol) ** 3, True))
STOP = Element("soft_stop", (p,), (l0,), (), (Deformation("d", "m", stop),), doc="a soft stop")
"""
    result = run("verify", written(tmp_path, text))
    assert result.exit_code == 0, result.output


def test_show_prints_all_of_a_page(page: Path) -> None:
    result = run("show", page)
    assert result.exit_code == 0, result.output
    for part in (
        f"page.py, line {CAM_LINE}", "gap = |p - c| - r(theta)", "c    planar point  c_x c_y",
        "base  [m]  radius of the base circle", "r = base + lift*(cos(theta) + 1)/2", "De (1×5)",
        "static void cam_position(", "static void rubber_law(", "z' = (e - z)/lag",
    ):  # fmt: skip
        assert part in result.output, part
    count = re.search(r"position +(\d+) ", result.output)
    assert count is not None and f"/* position: {count[1]} operations." in result.output
    stiffness = run("show", page, "cam", "--kernel", "stiffness").output
    assert stiffness.startswith("/* stiffness: ") and stiffness.endswith("\n}\n")
    assert run("show", page, "cam", "--kernel", "position").output in result.output
    none = run("show", page, "cam", "--kernel", "law")
    assert none.exit_code == 1 and "there are position, acceleration" in none.output


def test_show_prints_formulas_in_latex(page: Path) -> None:
    result = run("show", page, "--latex")
    assert r"e_{\mathrm{gap}} &= - r + \sqrt{d_{x}^{2} + d_{y}^{2}}" in result.output
    assert r"\dot{z} &= \frac{e - z}{\mathrm{lag}}" in result.output
    assert result.output.count(r"\begin{align*}") == result.output.count(r"\end{align*}") == 2
    truss = run("show", "truss", "--latex").output
    assert r"\dot{p}_{x} \dot{q}_{x}" in truss and "static" not in truss


def test_show_prints_built_in_elements_and_laws() -> None:
    result = run("show", "truss", "spring_curve")
    assert result.exit_code == 0, result.output
    assert re.search(r"^element 'truss': .*truss.py, line \d+$", result.output, re.MULTILINE)
    assert re.search(r"^law 'spring_curve': .*\.py, line \d+$", result.output, re.MULTILINE)
    assert run("show", "law_spring_curve").output in result.output
    assert "  breaks_0 … breaks_14  [m or m/s]" in re.sub(" {3,}", "  ", result.output)
    unknown = run("show", "bem")
    assert unknown.exit_code == 2 and "no element or law 'bem'" in unknown.output


BROKEN = {
    "an unknown symbol": (CAM.replace("sp.cos(theta)", 'sp.cos(sp.Symbol("x1"))'), CAM_LINE, ("element 'cam'", "x1")),
    "a syntax": (CAM + "def", CAM_LINE + 1, ("invalid syntax",)),
    "an error of Python": (CAM.replace('Parameter("lift", 1', 'Parameter("lift", 1 / 0'), 7, ("ZeroDivisionError",)),
    "a kink": (CAM.replace("sp.cos(theta)", "sp.Abs(sp.cos(theta))"), CAM_LINE, ("element 'cam'", "kink")),
    "the name of a built-in one": (CAM.replace('"cam", (axis', '"truss", (axis'), CAM_LINE, ("element 'truss'",)),
    "two of one name": (CAM + CAM.replace("CAM =", "OTHER ="), 2 * CAM_LINE, ("element 'cam'", f"line {CAM_LINE}")),
    "a compiled one": (
        f"{CAM}import flexel as fx\nCAM = fx.compile_element(CAM)\n",
        CAM_LINE,
        ("CAM is the compiled 'cam'", "another name"),
    ),
}  # fmt: skip


@pytest.mark.parametrize("what", BROKEN)
@pytest.mark.parametrize("command", ["derive", "verify", "show"])
def test_a_refused_page_is_named_with_its_line(command: str, what: str, tmp_path: Path) -> None:
    text, line, words = BROKEN[what]
    arguments = ["--out", tmp_path / "c"] if command == "derive" else []
    result = run(command, written(tmp_path, text), *arguments)
    assert result.exit_code == 1 and "Traceback" not in result.output
    assert f"page.py, line {line}: " in result.output, result.output
    assert all(word in result.output for word in words), result.output


def test_a_compiled_element_beside_its_definition_is_no_error(tmp_path: Path) -> None:
    text = f"{CAM}import flexel as fx\ncompiled = fx.compile_element(CAM)\n"
    assert run("show", written(tmp_path, text), "--latex").exit_code == 0


def test_what_a_page_imports_is_not_its_own(tmp_path: Path) -> None:
    written(tmp_path, CAM, "others.py")
    result = run("show", written(tmp_path, "from others import CAM\n"))
    assert result.exit_code == 1 and "declares no element or law" in result.output


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("derive", "{page}"), "--out FOLDER"),
        (("derive", "{page}", "--out", "{folder}", "--update-baseline"), "--update-baseline"),
        (("derive", "{page}", "truss", "--out", "{folder}"), "there are cam, rubber"),
        (("verify", "{page}", "truss"), "there are cam, rubber"),
        (("show", "{page}", "truss"), "there are cam, rubber"),
        (("show", "{page}", "--latex", "--kernel", "law"), "leave one out"),
        (("show", "{folder}/none.py"), "there is no such file"),
    ],
)
def test_wrong_arguments_say_what_to_do(
    arguments: tuple[str, ...], words: str, page: Path, tmp_path: Path
) -> None:
    result = run(*(argument.format(page=page, folder=tmp_path / "c") for argument in arguments))
    assert result.exit_code in (1, 2) and words in result.output, result.output


def test_without_a_compiler_a_page_is_derived_and_shown_but_not_verified(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    path = written(tmp_path, CAM.replace('"cam", (axis', '"other_cam", (axis'))
    assert run("derive", path, "--out", tmp_path / "c").exit_code == run("show", path).exit_code == 0
    result = run("verify", path)
    assert (
        result.exit_code == 1
        and f"page.py, line {CAM_LINE}: element 'other_cam': no C compiler" in result.output
    )
