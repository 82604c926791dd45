"""Verification passes what is right, and finds what is wrong: every kernel is broken once to see it found."""

import dataclasses
import json
import math
import re
from pathlib import Path

import pytest
import sympy as sp
from click.testing import CliRunner

import flexel.derive.user_definitions
from flexel.derive.declare import (
    Deformation,
    Element,
    Law,
    Let,
    Output,
    Parameter,
    PlanarAngle,
    PlanarPoint,
    Slip,
    symbol,
)
from flexel.derive.spec import ElementSpec
from flexel.derive.user_definitions import compile_element, compile_law
from flexel.derive.verify import KernelRow, Verification, definitions, verify, verify_generated
from flexel.derive.verify.kernel_calls import generated_elements
from flexel.derive.verify_command import main

SLOW = ("beam", "beam_first_order")
NAMES = list(generated_elements())  # those of the definitions, which take a second or two to import


def spring_pendulum(cubic: int = 10**9) -> Element:
    """Return an element that has everything: deformations, a slip, mass, weight, an intermediate, an angle, outputs."""
    p, r = PlanarPoint("p"), PlanarAngle("r")
    l0, mass = Parameter("l0", 1, "m", "length"), Parameter("mass", 1, "kg", "mass")
    let = Let()
    length = let.scalar("length", sp.sqrt(p.x.dot(p.x)))
    stretch = Deformation("stretch", "m", length - l0.symbol + sp.Rational(cubic, 3 * 10**9) * length**3)
    slip = Slip("sideways", "m/s", sp.cos(r.x[0]) * p.v[1] - sp.sin(r.x[0]) * p.v[0] * length)
    return Element(
        name="spring_pendulum",
        nodes=(p, r),
        parameters=(l0, mass),
        let=let.entries,
        deformations=(
            stretch,
            Deformation("turn", "rad", sp.atan2(p.x[1], p.x[0]) - r.x[0], period=2 * sp.pi),
        ),
        slips=(slip,),
        kinetic_energy=mass.symbol * (p.v.dot(p.v) + length**2 * r.v[0] ** 2) / 2,
        potential=mass.symbol * sp.Integer(10) * p.x[1] * length,
        doc="a test",
        source="this test",
        outputs=(
            Output("pull", "N", p.f),
            Output("line", "m", sp.Matrix.hstack(sp.zeros(2, 1), p.x, 2 * l0.symbol * p.x).T, draws="bar"),
            Output("lean", "N", stretch.stress * sp.cos(r.x[0]) + slip.stress * sp.Abs(stretch.value)),
        ),
    )


def hardening_spring() -> Law:
    e, ed, s, c = symbol("e"), symbol("ed"), symbol("s"), Parameter("c", 2, "N", "constants")
    return Law(
        name="hardening_spring",
        doc="a test",
        parameters=(c,),
        e=(e,),
        ed=(ed,),
        s=(s,),
        sigma=(c.symbols[0] * sp.sin(e) ** 3 + c.symbols[1] * ed * s,),
        tau=(sp.tanh(s) * e,),
        energy=e**2,
    )


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path


def failed(rows: list[KernelRow]) -> set[tuple[str, str]]:
    return {(row.kernel, row.output) for row in rows if not row.ok}


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow, pytest.mark.long] if name in SLOW else ())
        for name in NAMES
    ],
)
def test_generated_kernels_are_what_the_definitions_say(name: str) -> None:
    result = verify_generated([name])
    assert result.ok, result.table()


def test_every_definition_has_generated_kernels() -> None:
    assert sorted(NAMES) == sorted(definitions())


def test_a_users_element_is_verified_like_the_others(cache: Path) -> None:
    compiled = compile_element(spring_pendulum())
    rows = verify(compiled.spec, compiled.address, spring_pendulum())
    assert {row.kernel for row in rows} == set(compiled.spec.kernels)
    assert failed(rows) == set()


def test_a_users_law_is_verified_like_the_others(cache: Path) -> None:
    compiled = compile_law(hardening_spring())
    rows = verify(compiled.spec, compiled.address, hardening_spring())
    assert [row.output for row in rows] == ["sigma", "tau", "zd", "U", "P", "J"]
    assert failed(rows) == set()


def test_another_definition_is_not_what_was_compiled(cache: Path) -> None:
    compiled = compile_element(spring_pendulum())
    rows = verify(compiled.spec, compiled.address, spring_pendulum(10**9 + 1))
    expected = {("position", "e"), ("position", "De"), ("acceleration", "g")}
    expected |= (
        {("outputs", "pull")}
        | {("kinematics", name) for name in ("Psi_x", "Psi_v")}
        | {
            ("rates", "Phi_x"),
            ("stiffness", "K"),
        }
    )
    assert failed(rows) == expected


def patched(monkeypatch: pytest.MonkeyPatch, kernel: str, pattern: str, replacement: str) -> None:
    """Let the next element be compiled with one place in one of its kernels changed."""
    original = flexel.derive.user_definitions.element_code

    def code(element: Element) -> tuple[str, ElementSpec]:
        text, spec = original(element)
        start = text.index(f"_{kernel}(size_t")
        changed, count = re.subn(pattern, replacement, text[start:], count=1)
        assert count == 1, f"nothing like {pattern} in {kernel}"
        return text[:start] + changed, spec

    monkeypatch.setattr(flexel.derive.user_definitions, "element_code", code)


OUTPUTS = [
    *(("position", name) for name in ("e", "De", "V")),
    *(("acceleration", name) for name in ("g", "gs")),
    *(("inertia", name) for name in ("M", "h", "f", "U")),
    ("rates", "Phi_x"),
    *(("kinematics", name) for name in ("Psi_x", "Psi_v")),
    ("stiffness", "K"),
    *(("tangent", name) for name in ("R_x", "R_v")),
    *(("outputs", name) for name in ("pull", "line", "lean")),
]


@pytest.mark.parametrize(("kernel", "output"), OUTPUTS)
def test_a_wrong_coefficient_in_any_kernel_is_found(
    kernel: str, output: str, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One entry of one output is off by a factor 1 + 1e-9; the definition shows which."""
    patched(monkeypatch, kernel, rf"(\b{output}\[[^;]* = )([^=;]*);", r"\1(1.0 + 1e-9) * (\2);")
    compiled = compile_element(spring_pendulum())
    rows = verify(compiled.spec, compiled.address, spring_pendulum())
    assert {(row.kernel, row.output) for row in rows if row.reference > 1e-12} == {(kernel, output)}


@pytest.mark.parametrize(
    ("kernel", "output"),
    [item for item in OUTPUTS if item[1] not in ("e", "V", "M", "U") and item[0] != "outputs"],
)
def test_differences_of_the_kernel_below_find_it_too(
    kernel: str, output: str, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    patched(monkeypatch, kernel, rf"(\b{output}\[[^;]* = )([^=;]*);", r"\1(1.0 + 1e-4) * (\2);")
    compiled = compile_element(spring_pendulum())
    rows = verify(compiled.spec, compiled.address, spring_pendulum())
    assert (kernel, output) in {(row.kernel, row.output) for row in rows if row.differences > 1e-7}


def test_a_kernel_that_looks_at_its_neighbours_is_found(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    patched(
        monkeypatch, "acceleration", r"= v\[0 \* 8 \+ j\]", "= v[0 * 8 + j] + 0.0 * v[0 * 8 + (j + 1) % 8]"
    )
    compiled = compile_element(spring_pendulum())
    rows = verify(compiled.spec, compiled.address, spring_pendulum())
    assert {row.kernel for row in rows if not row.lanes} == {"acceleration"}
    assert {kernel for kernel, _ in failed(rows)} >= {"acceleration"}


def test_entries_at_the_wrong_place_are_found(cache: Path) -> None:
    """The spec names the stored entries of De in the opposite order."""
    compiled = compile_element(spring_pendulum())
    kernel = compiled.spec.kernels["position"]
    outputs = tuple(
        dataclasses.replace(o, nonzeros=o.nonzeros[::-1]) if o.name == "De" else o for o in kernel.outputs
    )
    kernels = compiled.spec.kernels | {"position": dataclasses.replace(kernel, outputs=outputs)}
    spec = dataclasses.replace(compiled.spec, kernels=kernels)
    assert ("position", "De") in failed(verify(spec, compiled.address, spring_pendulum()))


def test_a_kernel_that_does_not_exist_is_missed(cache: Path) -> None:
    compiled = compile_element(spring_pendulum())
    fewer = {name: kernel for name, kernel in compiled.spec.kernels.items() if name != "stiffness"}
    spec = dataclasses.replace(compiled.spec, kernels=fewer)
    rows = verify(spec, compiled.address, spring_pendulum())
    assert [(row.kernel, row.note) for row in rows] == [("stiffness", "kernel is missing")]


def test_arrays_of_other_sizes_are_noticed_before_anything_is_called(cache: Path) -> None:
    compiled = compile_element(spring_pendulum())
    fewer = dataclasses.replace(spring_pendulum(), slips=(), outputs=())
    rows = verify(compiled.spec, compiled.address, fewer)
    assert [row.note for row in rows] == ["k = 1, not 0"]


def test_command_prints_a_table_and_writes_json(tmp_path: Path) -> None:
    file = tmp_path / "norm.json"
    answer = CliRunner().invoke(main, ["norm", "law_viscous_1", "--json", str(file)])
    assert answer.exit_code == 0, answer.output
    assert "all within tolerance" in answer.output
    data = json.loads(file.read_text())
    assert data["ok"]
    assert {row["element"] for row in data["rows"]} == {"norm", "law viscous_1"}
    assert all(row["ok"] for row in data["rows"])


def test_command_fails_for_a_wrong_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    row = KernelRow("norm", "position", "e", math.nan, 1e-9, True)
    monkeypatch.setattr(
        "flexel.derive.verify_command.verify_generated", lambda *_, **__: Verification((row,), 0.0)
    )
    answer = CliRunner().invoke(main, ["norm"])
    assert answer.exit_code == 1
    assert "NOT OK" in answer.output


def test_command_names_what_it_does_not_know() -> None:
    answer = CliRunner().invoke(main, ["bicycle"])
    assert answer.exit_code == 2
    assert "no element or law 'bicycle'" in answer.output
