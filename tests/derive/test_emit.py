"""The generated files: the same bytes everywhere, checked, and clean C."""

import os
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest
from click.testing import CliRunner

from flexel.derive import __main__ as command
from flexel.derive.__main__ import main
from flexel.derive.declare import Element
from flexel.derive.emit import emit as emitting
from flexel.derive.emit.emit import Emitted, baseline, check, emit, risen, stale, write

STRICT = ("-std=c11", "-O0", "-fopenmp-simd", "-Wall", "-Wextra", "-Wpedantic", "-Werror")
PRINT = """
import hashlib
from flexel.derive.elements import ELEMENTS
from flexel.derive.emit.emit import emit
files = emit(ELEMENTS[:7] + ELEMENTS[9:]).files
print(hashlib.sha256(repr(sorted(files.items())).encode()).hexdigest())
"""


@pytest.fixture(scope="module")
def three() -> tuple[Element, ...]:
    from flexel.derive.elements import ELEMENTS

    return tuple(element for element in ELEMENTS if element.name in ("truss", "hinge", "planar_beam"))


@pytest.fixture(scope="module")
def few(three: tuple[Element, ...]) -> Emitted:
    """Three elements and the laws."""
    return emit(three)


@pytest.mark.campaign
def test_every_hash_seed_gives_the_same_bytes() -> None:
    digests = set()
    for seed in ("1", "4711"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        done = subprocess.run([sys.executable, "-c", PRINT], env=environment, capture_output=True, check=True)
        digests.add(done.stdout)
    assert len(digests) == 1


def test_what_was_written_checks_and_an_edited_or_stale_file_is_found(few: Emitted, tmp_path: Path) -> None:
    write(tmp_path, few)
    assert check(tmp_path, few) == []
    (tmp_path / "truss.c").write_text(few.files["truss.c"] + " ")
    (tmp_path / "old.c").write_text("")
    assert check(tmp_path, few) == ["old.c", "truss.c"]
    assert write(tmp_path, few) == ["old.c", "truss.c"]
    assert stale(tmp_path) == [] and check(tmp_path, few) == []


def test_one_element_alone_keeps_the_entries_of_the_others(
    three: tuple[Element, ...], few: Emitted, tmp_path: Path
) -> None:
    write(tmp_path, few)
    one = emit(three, only=["truss"], folder=tmp_path)
    assert sorted(one.operations) == ["truss"]
    assert one.files["table.py"] == few.files["table.py"]
    assert one.files["truss.c"] == few.files["truss.c"]
    assert "hinge.c" not in one.files


def test_a_law_is_derived_with_the_others_in_its_file(three: tuple[Element, ...], tmp_path: Path) -> None:
    """Named, or where the table in the folder has other laws than are declared."""
    from flexel.derive.laws import LAWS

    truss, laws = three[:1], LAWS[:2]
    first, second = (law.name for law in laws)
    all_of_it = emit(truss, laws)
    write(tmp_path, all_of_it)
    one = emit(truss, laws, only=[first], folder=tmp_path)
    assert sorted(one.operations) == sorted([first, second])
    assert [one.files[file] for file in ("laws.c", "table.py")] == [
        all_of_it.files[file] for file in ("laws.c", "table.py")
    ]
    fewer = emit(truss, laws[1:], only=["truss"], folder=tmp_path)
    assert sorted(fewer.operations) == sorted(["truss", second])
    assert first not in fewer.files["table.py"]


def test_the_command_accepts_the_counts_of_a_law(
    three: tuple[Element, ...], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from flexel.derive.laws import LAWS

    some = partial(emit, three[:1], LAWS[:1])
    monkeypatch.setattr(command, "emit", some)
    monkeypatch.setattr(emitting, "BASELINE", tmp_path / "operations.json")
    folder, name = tmp_path / "generated", LAWS[0].name
    write(folder, some())
    derived = (folder / "laws.c").read_text(encoding="utf-8")
    (folder / "laws.c").write_text("old")
    done = CliRunner().invoke(main, ["--update-baseline", "--out", str(folder), name])
    assert done.exit_code == 0, done.output
    assert (folder / "laws.c").read_text(encoding="utf-8") == derived
    assert list(baseline()) == [name]


def test_the_baseline_has_all_elements_and_laws() -> None:
    from flexel.derive.elements import ELEMENTS
    from flexel.derive.laws import LAWS

    assert list(baseline()) == [definition.name for definition in (*ELEMENTS, *LAWS)]


def test_the_command_fails_where_files_differ(
    three: tuple[Element, ...], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(command, "emit", partial(emit, three))
    runner = CliRunner()
    assert runner.invoke(main, ["--out", str(tmp_path)]).exit_code == 0
    assert runner.invoke(main, ["--check", "--out", str(tmp_path), "truss"]).exit_code == 0
    (tmp_path / "truss.c").write_text("edited")
    done = runner.invoke(main, ["--check", "--out", str(tmp_path), "truss"])
    assert done.exit_code == 1
    assert "truss.c" in done.output and "run `flexel derive`" in done.output
    assert runner.invoke(main, ["--check", "screwdriver"]).exit_code != 0


def test_a_rise_above_the_baseline_is_reported() -> None:
    assert risen({"truss": {"position": 18}}, {"truss": {"position": 17}}) == [
        "truss.position: 18 operations, baseline 17"
    ]
    assert risen({"truss": {"position": 17}}, {"truss": {"position": 17}}) == []
    assert risen({"new": {"position": 1}}, {}) != []


def test_no_operation_count_is_above_the_committed_baseline(few: Emitted) -> None:
    assert risen(few.operations, baseline()) == []


def test_the_baseline_is_rewritten_in_the_order_of_the_elements(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(emitting, "BASELINE", tmp_path / "operations.json")
    emitting.update_baseline({"hinge": {"position": 2}, "truss": {"position": 1}})
    emitting.update_baseline({"hinge": {"position": 3}})
    assert list(emitting.baseline().items()) == [("truss", {"position": 1}), ("hinge", {"position": 3})]


@pytest.mark.long  # as `make strict` in make test-all for all files
@pytest.mark.parametrize("flags", [(), ("-Dreal=double complex",)], ids=["double", "complex"])
def test_the_c_is_clean(few: Emitted, tmp_path: Path, flags: tuple[str, ...]) -> None:
    write(tmp_path, few)
    for path in sorted(tmp_path.glob("*.c")):
        subprocess.run(["cc", *STRICT, *flags, "-c", str(path), "-o", str(tmp_path / "a.o")], check=True)


def test_names_of_the_author_survive_and_the_head_says_what_is_computed(few: Emitted) -> None:
    text = few.files["truss.c"]
    for part in ("const real l = ", "elongation = |xq - xp| - l0", "position: ", "operations", "[kg/m]"):
        assert part in text
