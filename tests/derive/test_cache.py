"""The cache of compiled elements and laws: only whole files of one's own are loaded."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from flexel.derive import cache
from flexel.derive.cache import CacheError, is_whole
from flexel.derive.shared_object import CompilationError, SharedObject

SOURCE = "int flexel_user = 7;\n"
PROGRAM = """
import ctypes
from flexel.derive.shared_object import SharedObject
print(ctypes.c_int.from_address(SharedObject("seven", "int flexel_user = 7;\\n").address).value)
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    cache._temporary.cache_clear()
    return tmp_path / "flexel"


def made(source: str = SOURCE) -> Path:
    return SharedObject("seven", source).path


def test_the_folder_is_private_and_its_files_are_sealed(folder: Path) -> None:
    path = made()
    assert folder.stat().st_mode & 0o777 == 0o700 and is_whole(path)
    assert sorted(file.name for file in folder.iterdir()) == [path.name]


@pytest.mark.parametrize("damage", ["cut", "changed", "foreign", "empty", "gone"])
def test_damaged_and_foreign_files_are_built_again(damage: str) -> None:
    path = made()
    whole = path.read_bytes()
    if damage == "cut":
        path.write_bytes(whole[: len(whole) // 2])
    elif damage == "changed":
        path.write_bytes(whole[:2000] + bytes([whole[2000] ^ 1]) + whole[2001:])
    elif damage == "foreign":
        path.write_bytes(Path("/bin/true").read_bytes())
    elif damage == "empty":
        path.write_bytes(b"")
    else:
        path.unlink()
    assert not is_whole(path)
    found = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, check=True)
    assert found.stdout == "7\n" and is_whole(path)


def test_a_cache_that_others_can_write_is_refused(folder: Path) -> None:
    made()
    folder.chmod(0o770)
    with pytest.raises(CacheError, match=r"others can write to the cache .*chmod 700"):
        made()
    if os.geteuid() == 0:
        folder.chmod(0o700)
        os.chown(folder, 65534, -1)
        with pytest.raises(CacheError, match="belongs to another user"):
            made()


def test_a_folder_that_cannot_be_made_is_replaced_with_a_message(folder: Path) -> None:
    folder.write_text("a file where the folder should be")
    with pytest.warns(RuntimeWarning, match=r"cannot be used \(File exists\).*XDG_CACHE_HOME"):
        path = made()
    assert is_whole(path) and path.parent.stat().st_mode & 0o777 == 0o700
    assert made() == path  # warned once


@pytest.mark.parametrize(
    ("compiler", "message"),
    [
        ("#!/bin/sh\nexit 0\n", "reported success, but made no file"),
        (
            '#!/bin/sh\nfor word; do [ "$last" = -o ] && echo junk > "$word"; last=$word; done\n',
            "cannot be loaded",
        ),
        ("#!/bin/sh\necho no >&2\nexit 1\n", "does not compile: .*\nno"),
    ],
)
def test_a_compiler_that_fails_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, compiler: str, message: str
) -> None:
    script = tmp_path / "mycc"
    script.write_text(compiler)
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    with pytest.raises(CompilationError, match=f"(?s){message}") as caught:
        assert SharedObject("seven", SOURCE).address
    assert "'seven'" in str(caught.value)


def test_eight_processes_at_once(folder: Path) -> None:
    running = [
        subprocess.Popen([sys.executable, "-c", PROGRAM], stdout=subprocess.PIPE, text=True) for _ in range(8)
    ]
    assert [process.communicate()[0] for process in running] == ["7\n"] * 8
    assert len(list(folder.iterdir())) == 1
