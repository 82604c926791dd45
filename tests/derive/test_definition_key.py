"""The key of a definition: the same in every process, another one where anything differs."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp

from flexel.derive import derived_code
from flexel.derive.accept import accepted_law
from flexel.derive.declare import TIME, Deformation, Element, Law, Let, Output, Parameter, Point, symbol
from flexel.derive.definition_key import definition_key
from flexel.derive.derived_code import element_code, is_derived, law_code

PROGRAM = """
import sys
sys.path.insert(0, sys.argv[1])
from test_definition_key import bar
from flexel.derive.definition_key import definition_key
print(definition_key(bar()))
"""


def bar(power: object = 2, doc: str = "|d|^2 - t0") -> Element:
    p, q, t0 = Point("p"), Point("q"), Parameter("t0", 1, "m^2", "square at rest")
    let = Let()
    d = let.vector("d", q.x - p.x)
    square = sum(c**power for c in d) - t0.symbol
    outputs = (Output("ends", "m", sp.Matrix.hstack(p.x, q.x).T, draws="bar"),)
    return Element("bar", (p, q), (t0,), let.entries, (Deformation("square", "m^2", square),), doc=doc,
                   outputs=outputs)  # fmt: skip


def spring(factor: object = 1) -> Law:
    e, ed, c = symbol("e"), symbol("ed"), Parameter("c", 1, "N/m", "stiffness")
    energy = c.symbol * e**2 / 2 if factor == 1 else sp.S.Zero
    return Law("own_spring", "sigma = c e", (c,), (e,), (ed,), (), (c.symbol * e * factor,), (), energy)


def test_the_key_is_the_same_in_every_process() -> None:
    keys = {definition_key(bar())}
    for seed in ("1", "4711"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-c", PROGRAM, str(Path(__file__).parent)]
        keys.add(
            subprocess.run(
                command, env=environment, capture_output=True, check=True, text=True
            ).stdout.strip()
        )
    assert len(keys) == 1


def test_whatever_differs_gives_another_key() -> None:
    given = bar()
    (deformation,), (output,), (t0,) = given.deformations, given.outputs, given.parameters
    others = [
        bar(power=2.0),
        bar(power=3),
        bar(doc="another text"),
        replace(given, name="other"),
        replace(given, source="own"),
        replace(given, potential=symbol("p_x")),
        replace(given, parameters=(replace(t0, sign="positive"),)),
        replace(given, deformations=(replace(deformation, free=True),)),
        replace(given, deformations=(replace(deformation, kinked=True),)),
        replace(given, outputs=(replace(output, draws=""),)),
        replace(given, outputs=(replace(output, values=output.values * 2),)),
        replace(given, let=given.let[:-1] + ((given.let[-1][0], 2 * given.let[-1][1]),)),
    ]
    keys = [definition_key(element) for element in (given, *others)]
    assert len(set(keys)) == len(keys)
    assert definition_key(bar()) == keys[0]


def test_a_law_of_the_time_has_its_own_key_and_note(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The time is one of its symbols; what is read from the cache still says that the law depends on it."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    laws = [spring(), *(spring(factor) for factor in (TIME, 2 * TIME, sp.cos(TIME)))]
    assert len({definition_key(law) for law in laws}) == len(laws)
    assert definition_key(spring(sp.cos(TIME))) == definition_key(laws[-1])
    for ranges in ({"t": (0.0, 1.0)}, {"t": (0.0, 2.0)}):
        made, read = (accepted_law(laws[-1], ranges) for _ in "12")
        assert made.spec == read.spec and read.spec.timed
    assert not accepted_law(laws[0]).spec.timed
    folder = tmp_path / "flexel"
    assert [len(list(folder.glob(f"*.{kind}"))) for kind in ("derived", "so", "verified")] == [2, 2, 3]


def test_a_range_that_is_text_is_refused_beside_the_note_of_the_same_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    accepted_law(spring(), {"c": (1, 2)})
    with pytest.raises(ValueError, match="is not .lowest, highest."):
        accepted_law(spring(), {"c": "(1, 2)"})  # type: ignore[dict-item]


@pytest.mark.parametrize(("declared", "code"), [(bar(), element_code), (spring(), law_code)])
def test_a_definition_is_derived_once(
    declared: Element | Law, code: object, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second call reads what the first has kept; a file that is not whole is derived again."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert not is_derived(declared)
    first = code(declared)  # type: ignore[operator]
    assert is_derived(declared)
    calls: list[object] = []
    derive = derived_code._derived

    def counted(*arguments: object) -> object:
        calls.append(arguments)
        return derive(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(derived_code, "_derived", counted)
    assert code(declared) == first and calls == []  # type: ignore[operator]
    (kept,) = (tmp_path / "flexel").glob("*.derived")
    kept.write_bytes(kept.read_bytes()[:-3])
    assert not is_derived(declared)
    assert code(declared) == first and len(calls) == 1  # type: ignore[operator]


def test_a_known_element_is_used_without_what_derives_and_verifies_it(tmp_path: Path) -> None:
    """In the process after the first one, nothing is derived, printed or verified."""
    program = (
        "import sys; sys.path.insert(0, sys.argv[1]); from test_definition_key import bar;"
        "from flexel.derive.accept import accepted_element; accepted_element(bar());"
        "print('jinja2' in sys.modules, 'flexel.derive.program' in sys.modules, 'flexel.derive.verify' in sys.modules)"
    )
    environment = {**os.environ, "XDG_CACHE_HOME": str(tmp_path)}
    command = [sys.executable, "-c", program, str(Path(__file__).parent)]
    said = [
        subprocess.run(command, env=environment, capture_output=True, check=True, text=True).stdout
        for _ in "12"
    ]
    assert said == ["True True True\n", "False False False\n"]
