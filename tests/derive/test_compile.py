"""A user-defined element and law: derived, compiled once, called by address."""

import ctypes
import math
import os
from pathlib import Path

import pytest
import sympy as sp

from flexel.derive.cache import cache_directory
from flexel.derive.declare import Deformation, Element, Law, Let, Parameter, Point, symbol
from flexel.derive.shared_object import CompilerMissingError
from flexel.derive.user_definitions import compile_element, compile_law

_KERNEL = ctypes.CFUNCTYPE(
    None,
    ctypes.c_size_t,
    ctypes.POINTER(ctypes.POINTER(ctypes.c_double)),
    ctypes.POINTER(ctypes.POINTER(ctypes.c_double)),
)


class Struct(ctypes.Structure):
    """The head of ``flexel_law`` and its kernels."""

    _fields_ = [
        ("name", ctypes.c_char_p),
        ("digest", ctypes.c_char_p),
        ("m", ctypes.c_int),
        ("k", ctypes.c_int),
        ("nz", ctypes.c_int),
        ("np", ctypes.c_int),
        ("law", _KERNEL),
        ("tangent", _KERNEL),
    ]


@pytest.fixture(autouse=True)
def cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """An empty cache directory for each test."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "flexel"


def spring() -> Element:
    """A spring whose deformation is the square of a distance."""
    p, q, t0 = Point("p"), Point("q"), Parameter("t0", 1, "m^2", "square at rest")
    let = Let()
    d = let.vector("d", q.x - p.x)
    e = Deformation("square", "m^2", d.dot(d) - t0.symbol)
    return Element(
        name="spring", nodes=(p, q), parameters=(t0,), let=let.entries, deformations=(e,), doc="|d|^2 - t0"
    )


def hardening() -> Law:
    """A cubic spring that only pulls."""
    e, ed = symbol("e"), symbol("ed")
    c = Parameter("c", 1, "N/m^3", "stiffness")
    pull = sp.Piecewise((c.symbol * e**3, e > 0), (0, True)) + sp.sin(ed)
    return Law("hardening", "sigma = c e^3 + sin ed", (c,), (e,), (ed,), (), (pull,), ())


def call(kernel: "ctypes._FuncPointer", inputs: list[float | None], sizes: list[int]) -> list[list[float]]:
    """Call a kernel on one block whose inputs have one row each; returns the first column of each output."""
    pointer = ctypes.POINTER(ctypes.c_double)
    ins = [pointer() if x is None else ctypes.cast((ctypes.c_double * 8)(*[x] * 8), pointer) for x in inputs]
    outs = [(ctypes.c_double * (8 * max(size, 1)))() for size in sizes]
    pointers = [ctypes.cast(out, pointer) for out in outs]
    kernel(1, (pointer * len(ins))(*ins), (pointer * len(outs))(*pointers))
    return [list(out)[: 8 * size : 8] for out, size in zip(outs, sizes, strict=True)]


def test_an_element_is_compiled_once(cache: Path) -> None:
    first = compile_element(spring())
    files = list(cache.iterdir())
    stamp = first.path.stat().st_mtime_ns
    again = compile_element(spring())
    assert len(files) == 2 and first.path in files and files == list(cache.iterdir())
    assert first.path.stat().st_mtime_ns == stamp
    assert again.address == first.address != 0
    assert first.spec.kernels["position"].outputs[1].shape == (1, 6)
    assert first.spec.nodes[1].kind == "point"
    assert "inertia" not in first.spec.kernels


def test_a_compiled_law_computes_stress_and_tangent() -> None:
    compiled = compile_law(hardening())
    law = Struct.from_address(compiled.address)
    assert (law.name, law.m, law.k, law.np) == (b"hardening", 1, 0, 1)
    assert list(compiled.spec.kernels) == ["law", "tangent"]
    for e, expected in ((0.5, 3 * 0.125), (-0.5, 0.0)):
        sigma, _, _, _, P = call(law.law, [e, 0.3, None, None, 0.0, 3.0], [1, 0, 0, 0, 1])
        assert sigma == pytest.approx([expected + math.sin(0.3)], rel=1e-15)
        assert P == pytest.approx(
            [sigma[0] * 0.3], rel=1e-15
        )  # no stored energy was stated: all of it is lost
        (J,) = call(law.tangent, [e, 0.3, None, None, 0.0, 3.0], [2])
        assert J == pytest.approx([9 * 0.25 if e > 0 else 0.0, math.cos(0.3)], rel=1e-15)


def test_a_condition_is_written_out_wherever_it_is_used() -> None:
    """The power is a separate loop between two that both need the sign of e."""
    e, ed, n = symbol("e"), symbol("ed"), Parameter("n", 1, "1", "exponent")
    base = sp.Piecewise((-2 * e, 2 * e < 0), (1, True))
    pull = sp.Piecewise((base**n.symbol, 2 * e < 0), (0, True))
    compiled = compile_law(Law("power", "sigma = (-2 e)^n", (n,), (e,), (ed,), (), (pull,), ()))
    law = Struct.from_address(compiled.address)
    for value, expected in ((-0.5, 1.0), (-2.0, 8.0), (0.5, 0.0)):
        assert call(law.law, [value, 0.0, None, None, 0.0, 1.5], [1, 0, 0, 0, 1])[0] == pytest.approx(
            [expected]
        )
        slope = -3 * math.sqrt(-2 * value) if value < 0 else 0.0
        assert call(law.tangent, [value, 0.0, None, None, 0.0, 1.5], [2])[0][:1] == pytest.approx([slope])


def test_without_a_compiler_the_remedy_is_named(monkeypatch: pytest.MonkeyPatch, cache: Path) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(CompilerMissingError, match="apt install gcc"):
        compile_element(spring())
    assert [path.suffix for path in cache.iterdir()] == [".derived"]


def test_the_cache_is_where_the_user_keeps_caches(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    assert cache_directory() == tmp_path / "flexel"
    monkeypatch.delenv("XDG_CACHE_HOME")
    assert cache_directory() == Path(os.environ["HOME"]) / ".cache" / "flexel"
