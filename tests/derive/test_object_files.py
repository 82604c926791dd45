"""Object files are found again by what they were made of, and never where anything of it has changed."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from flexel.derive import cache, object_files
from flexel.derive.object_files import compile_object, remove_oldest

COMPILER = ["cc", "-O1"]
PROGRAM = """
import sys
from pathlib import Path
from flexel.derive.object_files import compile_object
print(compile_object(["cc", "-O1"], Path("unit.c"), Path(sys.argv[1])))
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A source with a header in the current folder, and an empty cache."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    cache._temporary.cache_clear()
    here = tmp_path / "sources"
    here.mkdir()
    monkeypatch.chdir(here)
    (here / "unit.h").write_text("#ifndef VALUE\n#define VALUE 7\n#endif\n")
    (here / "unit.c").write_text('#include "unit.h"\nint flexel_value(void) { return VALUE; }\n')
    return tmp_path / "cache" / "flexel" / "objects"


def compiled(*flags: str, compiler: list[str] = COMPILER) -> bool:
    return compile_object([*compiler, *flags], Path("unit.c"), Path("unit.o"))


def value() -> int:
    """What the object returns."""
    Path("main.c").write_text(
        '#include <stdio.h>\nint flexel_value(void);\nint main(void) { printf("%d", flexel_value()); }\n'
    )
    subprocess.run(["cc", "main.c", "unit.o", "-o", "main"], check=True)
    return int(subprocess.run(["./main"], capture_output=True, text=True, check=True).stdout)


def test_the_same_text_is_compiled_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert compiled() and value() == 7
    made = Path("unit.o").read_bytes()
    assert not compiled() and Path("unit.o").read_bytes() == made
    Path("unit.c").write_text("/* a comment */\n\n" + Path("unit.c").read_text())
    other = tmp_path / "another checkout"
    shutil.copytree(".", other)
    monkeypatch.chdir(other)
    assert not compiled(f"-I{other}") and Path("unit.o").read_bytes() == made


def test_a_changed_header_source_or_macro_is_compiled() -> None:
    assert compiled()
    facts = os.stat("unit.h")
    Path("unit.h").write_text("#define VALUE 8\n")
    os.utime("unit.h", ns=(facts.st_atime_ns, facts.st_mtime_ns))  # the date says nothing
    assert compiled() and value() == 8
    Path("unit.c").write_text("int flexel_value(void) { return VALUE; }\n")
    assert compiled("-DVALUE=9") and value() == 9
    assert compiled("-DVALUE=10") and value() == 10
    assert not compiled("-DVALUE=9") and value() == 9


def test_changed_flags_are_compiled() -> None:
    assert compiled()
    assert compiled("-O2") and compiled("-fwrapv") and not compiled("-O2")
    assert compiled("-g1")  # names the folder and the lines
    Path("unit.c").write_text("\n" + Path("unit.c").read_text())
    assert compiled("-g1")
    assert compiled("-g1", "-g0") and not compiled("-g1", "-g0")


def test_another_compiler_and_another_version_of_it_compile(tmp_path: Path) -> None:
    assert compiled()
    other = tmp_path / "mycc"
    other.write_text('#!/bin/sh\nexec cc "$@"\n')
    other.chmod(0o755)
    assert compiled(compiler=[str(other), "-O1"]) and not compiled(compiler=[str(other), "-O1"])
    other.write_text('#!/bin/sh\n# updated\nexec cc "$@"\n')
    object_files._identity.cache_clear()
    assert compiled(compiler=[str(other), "-O1"])


def test_another_processor_compiles(monkeypatch: pytest.MonkeyPatch) -> None:
    assert compiled()
    monkeypatch.setattr(object_files, "processor", lambda: "x86_64\nflags: sse2")
    assert compiled()


def test_flags_that_read_or_write_other_files_are_never_kept(folder: Path) -> None:
    assert compiled("--coverage") and compiled("--coverage") and Path("unit.gcno").exists()
    assert not folder.exists()


@pytest.mark.parametrize("damage", ["cut", "changed", "empty"])
def test_a_damaged_object_is_compiled_again(folder: Path, damage: str) -> None:
    assert compiled()
    (kept,) = folder.iterdir()
    whole = kept.read_bytes()
    kept.write_bytes({"cut": whole[: len(whole) // 2], "changed": b"\0" + whole[1:], "empty": b""}[damage])
    assert compiled() and kept.read_bytes() == whole and value() == 7


def test_a_build_that_is_interrupted_leaves_nothing_that_is_found(folder: Path, tmp_path: Path) -> None:
    slow = tmp_path / "mycc"
    slow.write_text(
        '#!/bin/sh\nlast=""\nfor word; do [ "$last" = -o ] && made="$word"; last="$word"; done\n'
        'case "$*" in *--version*|*-E*) exec cc "$@";; esac\n'
        f'printf half > "$made"; touch {tmp_path}/begun; sleep 60\n'
    )
    slow.chmod(0o755)
    program = PROGRAM.replace('"cc"', repr(str(slow)))
    running = subprocess.Popen([sys.executable, "-c", program, "unit.o"], start_new_session=True)
    deadline = time.monotonic() + 60
    while not (tmp_path / "begun").exists():
        assert time.monotonic() < deadline and running.poll() is None
        time.sleep(0.02)
    os.killpg(running.pid, 9)
    running.wait()
    assert not list(folder.glob("*.o")) and not Path("unit.o").exists()
    (left,) = folder.iterdir()
    assert compiled() and value() == 7
    remove_oldest()
    assert left.exists()  # it may belong to a build that runs
    os.utime(left, (time.time() - 2 * 86400,) * 2)
    remove_oldest()
    assert not left.exists() and len(list(folder.iterdir())) == 1


def test_a_compiler_that_fails_keeps_nothing(folder: Path) -> None:
    Path("unit.c").write_text("int flexel_value(void) { return }\n")
    with pytest.raises(subprocess.CalledProcessError):
        compiled()
    assert not list(folder.iterdir()) and not Path("unit.o").exists()


def test_builds_at_once_share_the_cache(folder: Path) -> None:
    names = [f"unit{i}.o" for i in range(6)]
    running = [
        subprocess.Popen([sys.executable, "-c", PROGRAM, name], stdout=subprocess.PIPE, text=True)
        for name in names
    ]
    said = [process.communicate()[0] for process in running]
    assert "True\n" in said and set(said) <= {"True\n", "False\n"}
    assert len({Path(name).read_bytes() for name in names}) == 1 and len(list(folder.iterdir())) == 1


def test_the_objects_used_last_are_kept(folder: Path) -> None:
    assert compiled("-DVALUE=1") and compiled("-DVALUE=2") and compiled("-DVALUE=3")
    for age, kept in enumerate(folder.iterdir()):
        os.utime(kept, (1e9 + age, 1e9 + age))
    assert not compiled("-DVALUE=1")  # used again, whatever its age
    used = max(folder.iterdir(), key=lambda path: path.stat().st_mtime)
    remove_oldest(limit=used.stat().st_size)
    assert list(folder.iterdir()) == [used] and not compiled("-DVALUE=1")
    assert compiled("-DVALUE=2")


def test_a_cache_that_others_can_write_is_not_used(folder: Path) -> None:
    folder.parent.mkdir(parents=True)
    folder.parent.chmod(0o777)
    with pytest.warns(RuntimeWarning, match="others can write to the cache"):
        assert compiled()
    assert value() == 7 and not folder.exists()
