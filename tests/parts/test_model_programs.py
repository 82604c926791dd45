"""Programs and files of models build the same model, equal bit by bit; what cannot be written is refused by name."""

import json
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from declared_models import FORTY, KINDS, OTHERS, hardening
from equal_values import assert_same, assert_same_model
from optional_numbers import OPTIONAL

import flexel as fx
from flexel.model.part import Part
from flexel.parts.method import METHOD_OF, Method
from flexel.parts.model import Model

SAMPLE = [
    "kicked bicycle",
    "vehicle",
    "leaning motorcycle",
    "sampled carriage",
    "relaxing tyre",
    "bouncing ball",
]
ALL = KINDS | OTHERS | OPTIONAL | {name: FORTY[name] for name in SAMPLE}
pytestmark = pytest.mark.filterwarnings("ignore::flexel.ModelWarning")


def executed(program: str) -> fx.Model:
    """The model of a program."""
    names: dict[str, Any] = {}
    exec(program, names)
    found: fx.Model = names["m"]
    return found


def pointed() -> fx.Model:
    """A mass at a point on a line."""
    m = fx.Model()
    m.point("A", (1, 0, 0))
    m.fix("A.y", "A.z")
    m.point_mass("mass", "A", 2.0)
    return m


@pytest.mark.parametrize("name", ALL)
def test_a_program_and_a_file_build_the_same_model(name: str, tmp_path: Path) -> None:
    check_written(ALL[name](), tmp_path)


def check_written(m: fx.Model, tmp_path: Path) -> None:
    """The program and the file of a model build an equal one, and its program is the same."""
    program = m.program()
    assert_same_model(m, executed(program))
    loaded = fx.load(m.save(tmp_path / "model.json"))
    assert isinstance(loaded, fx.Model)
    assert_same_model(m, loaded)
    assert loaded.program() == program


def test_every_declaration_is_among_the_kinds() -> None:
    """Each kind of part of flexel has one method of `Model`, and occurs above."""
    declaring = {name for name, value in vars(Model).items() if isinstance(value, Method)}
    declaring |= {"fix", "release", "rigid", "independent", "kinematic", "element", "attach", "law", "tyre"}
    assert set(METHOD_OF.values()) == declaring == set(KINDS)
    others = {name for name in vars(Model) if name[0] != "_"} - declaring
    assert others == {
        "add", "of", "parts", "program", "save", "gravity", "nodes", "instances", "surfaces", "laws", "loads",
        "controllers", "build", "check", "constraint_report",
    }  # fmt: skip
    for kind, method in METHOD_OF.items():
        assert issubclass(kind, Part)
        assert any(type(part) is kind for part in KINDS[method]().parts), method


def valued(value: Any) -> fx.Model:
    """A spring with a value, or a load."""
    m = pointed()
    m.spring("A.x", value)
    return m


def located(position: Any) -> fx.Model:
    m = fx.Model()
    m.point("A", position)
    return m


def named(name: str) -> fx.Model:
    m = fx.Model()
    m.point(name, (0, 0))
    return m


def loaded_with(value: Any) -> fx.Model:
    m = pointed()
    m.load("A.x", value)
    return m


VALUES: dict[str, Callable[[], fx.Model]] = {
    "an array": lambda: located(np.array([0.1, 0.2, 1 / 3])),
    "integers": lambda: located((1, 2, 3)),
    "an array of integers": lambda: located(np.array([1, 2, 3])),
    "a list": lambda: located([1.0, 2, 3]),
    "NumPy's numbers": lambda: located([np.float64(0.1), np.int64(2), np.float32(0.1)]),
    "a NumPy number": lambda: valued(np.float64(1 / 3)),
    "a NumPy number of single precision": lambda: valued(np.float32(0.1)),
    "negative zero": lambda: located((-0.0, 0.0, -0.0)),
    "negative zero in place of a default": lambda: fx.Model((-0.0, 0.0, 0.0)),
    "gravity in the plane": lambda: fx.Model((0.0, 0.0)),
    "tiny": lambda: located((1e-300, 5e-324, -1e-300)),
    "all digits": lambda: located((1 / 3, np.pi, np.nextafter(1.0, 2.0))),
    "quotes": lambda: named('a "quoted" \\ {n}'),
    "other letters": lambda: named("Féder µ 弹簧"),
    "a curve": lambda: valued(fx.Curve([[0, 3e4], [-700.0, 4e4]], breaks=[0.07])),
    "a curve through a table": lambda: valued(fx.Curve.through([-1, 0, 1], [-5, 0, 6])),
    "a function of a module": lambda: valued(hardening),
    "a ramp": lambda: loaded_with(fx.Ramp(0, 1, 0, 5)),
    "a harmonic": lambda: loaded_with(fx.Harmonic(1.0, 3.0)),
    "a polynomial": lambda: loaded_with(fx.Polynomial((1.0, np.float64(2.0)))),
    "a table": lambda: loaded_with(fx.Table([0.0, 0.1, 0.1, 0.5], np.array([0, 1, 2, 3]), "linear")),
    "a function of NumPy": lambda: loaded_with(np.sin),
    "gains": lambda: controlled(np.array([[1 / 3]], dtype=np.float32)),
}  # fmt: skip


@pytest.mark.parametrize("name", VALUES)
def test_values_of_all_kinds_are_written_with_every_bit(name: str, tmp_path: Path) -> None:
    check_written(VALUES[name](), tmp_path)


# -- linear systems of controllers ------------------------------------------------------------------


THIRD = np.nextafter(1 / 3, 1)
MATRICES = ([[-THIRD, 1e-300], [-0.0, -1.0]], [[1.0], [5e-324]], [[1.0, 1 / 3]], [[0]])
NO_STATE = (np.zeros((0, 0)), np.zeros((0, 1)), np.zeros((1, 0)), [[3]])


def controlled(system: Any, **options: Any) -> fx.Model:
    """A mass with a controller made in place."""
    m = pointed()
    m.controller(system, inputs=["A.x"], outputs=["A.x"], **options)
    return m


SYSTEMS: dict[str, Callable[[Any, Any], fx.Model]] = {
    "SciPy, continuous": lambda signal, _: controlled(signal.StateSpace(*MATRICES)),
    "SciPy, discrete": lambda signal, _: controlled(signal.StateSpace(*MATRICES, dt=0.1)),
    "SciPy, of an unknown step": lambda signal, _: controlled(signal.StateSpace(*MATRICES, dt=True), period=0.2),
    "SciPy, without states": lambda signal, _: controlled(signal.StateSpace(*NO_STATE)),
    "SciPy, transfer function": lambda signal, _: controlled(signal.TransferFunction([1, 1 / 3], [1, 2, THIRD])),
    "SciPy, complex poles": lambda signal, _: controlled(
        signal.ZerosPolesGain([-1.0], [-THIRD + 1j, -THIRD - 1j], 2.5)
    ),
    "python-control, continuous": lambda _, control: controlled(control.ss(*MATRICES)),
    "python-control, discrete": lambda _, control: controlled(control.ss(*MATRICES, 0.1)),
    "python-control, of an unknown step": lambda _, control: controlled(control.ss(*MATRICES, True), period=0.2),
    "python-control, of any time": lambda _, control: controlled(control.ss(*MATRICES, dt=None), period=0.2),
    "python-control, with names": lambda _, control: controlled(
        control.ss(*MATRICES, name="lead", inputs=["angle"], outputs=["torque"], states=["slow", "fast"])
    ),
    "python-control, without states": lambda _, control: controlled(control.ss(*NO_STATE)),
    "python-control, transfer function": lambda _, control: controlled(
        control.tf([1, 1 / 3], [1, 2, THIRD], 0.1, inputs=["angle"])
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SYSTEMS)
def test_linear_systems_made_in_place_are_written_with_every_bit(name: str, tmp_path: Path) -> None:
    from scipy import signal

    control = pytest.importorskip("control") if name.startswith("python-control") else None
    m = SYSTEMS[name](signal, control)
    check_written(m, tmp_path)
    built = executed(m.program()).build()
    assert_same(built.initial.values, m.build().initial.values)


def test_a_linear_system_is_loaded_where_its_module_was_not_imported(tmp_path: Path) -> None:
    from scipy import signal

    path = controlled(signal.StateSpace(*MATRICES)).save(tmp_path / "model.json")
    text = f"""
import sys
import flexel as fx
assert "scipy.signal" not in sys.modules
A = fx.load({str(path)!r}).parts[-1].function.A
print(A.tobytes().hex())
"""
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == np.array(MATRICES[0]).tobytes().hex()


def test_a_class_of_ones_own_is_no_linear_system_that_can_be_written(tmp_path: Path) -> None:
    """It may hold more than its matrices."""
    from scipy.signal import StateSpace

    class Tuned(type(StateSpace(*MATRICES))):  # type: ignore[misc]
        """A system of the user."""

    m = controlled(Tuned(*MATRICES))
    refused = "(?s)^controller 'controller': function .* cannot be imported by name"
    with pytest.raises(fx.ModelError, match=refused):
        m.program()
    with pytest.raises(fx.ModelError, match=refused):
        m.save(tmp_path / "model.json")


@dataclass(frozen=True)
class Doubled:
    """A function of time with a number of its own."""

    size: float

    def __call__(self, t: Any) -> Any:
        return 2 * self.size * t


@dataclass(frozen=True)
class Counted:
    """The same with more than its arguments."""

    size: float
    count: int = field(default=0, init=False)

    def __call__(self, t: Any) -> Any:
        return self.size * t


@dataclass
class Changing:
    """The same, but its number may change."""

    size: float

    def __call__(self, t: Any) -> Any:
        return self.size * t


def test_frozen_dataclasses_of_ones_own_are_written_with_their_arguments(tmp_path: Path) -> None:
    m = loaded_with(Doubled(0.1))
    assert f"{__name__}.Doubled(0.1)" in m.program() and f"import {__name__}\n" in m.program()
    again = fx.load(m.save(tmp_path / "model.json"))
    assert isinstance(again, fx.Model)
    for model in (executed(m.program()), again):
        assert getattr(model.parts[-1], "value") == Doubled(0.1)  # noqa: B009 (of one kind of part)
        assert model.program() == m.program()


@pytest.mark.parametrize("kind", [Counted, Changing], ids=lambda kind: str(kind.__name__))
def test_other_objects_may_hold_more_than_their_arguments_and_are_refused(kind: Any) -> None:
    with pytest.raises(fx.ModelError, match=f"value <?.*{kind.__name__}.* cannot be imported by name"):
        loaded_with(kind(0.1)).program()


def test_a_file_names_no_other_class_as_an_object(tmp_path: Path) -> None:
    path = loaded_with(Doubled(0.1)).save(tmp_path / "model.json")
    path.write_text(path.read_text().replace(f"{__name__}.Doubled", "subprocess.Popen"))
    with pytest.raises(fx.ModelError, match="'subprocess.Popen' is not a flexel object"):
        fx.load(path)


def local() -> Any:
    """A function within a function."""

    def inner(e: Any) -> Any:
        return 3 * e

    return inner


class Sloped:
    """A function of time that no variable of a module holds."""

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value and rates."""
        return t, 1.0, 0.0


def prescribed() -> fx.Model:
    m = fx.Model()
    m.point("A", (1, 0))
    m.prescribe("A.x", Sloped())
    return m


REFUSED = {
    "lambda": (lambda: valued(lambda e: 3 * e), "spring on 'A.x': stiffness .*<lambda>"),
    "local function": (lambda: valued(local()), "spring on 'A.x': stiffness local.<locals>.inner"),
    "load": (lambda: loaded_with(lambda t: 3 * t), "load on 'A.x': value .*<lambda>"),
    "object": (prescribed, "prescribe 'A.x': motion <.*Sloped object"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_has_no_import_name_is_refused_and_an_old_file_remains(name: str, tmp_path: Path) -> None:
    make, message = REFUSED[name]
    m = make()
    expected = f"^{message}.* cannot be imported by name, .*; define it in a module, outside of functions"
    with pytest.raises(fx.ModelError, match=expected):
        m.program()
    path = tmp_path / "model.json"
    with pytest.raises(fx.ModelError, match=expected):
        m.save(path)
    assert not list(tmp_path.iterdir())
    path.write_text("old", encoding="utf-8")
    with pytest.raises(fx.ModelError, match=expected):
        m.save(path)
    assert [(file.name, file.read_text(encoding="utf-8")) for file in tmp_path.iterdir()] == [
        ("model.json", "old")
    ]


def test_a_function_of_the_main_program_is_refused(tmp_path: Path) -> None:
    """Another process would not find it."""
    text = """
import flexel as fx
def force(e):
    return 3 * e
m = fx.Model()
m.point("A", (1, 0))
m.spring("A.x", force)
for write in (m.program, lambda: m.save("model.json")):
    try:
        write()
    except fx.ModelError as error:
        print(error)
"""
    done = subprocess.run(
        [sys.executable, "-c", text], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    lines = done.stdout.splitlines()
    assert len(lines) == 2
    assert all(
        line.startswith("spring on 'A.x': stiffness force cannot be imported by name") for line in lines
    )


# -- files ------------------------------------------------------------------------------------------


def content() -> dict[str, Any]:
    """What the file of a small model holds."""
    return {
        "format": "flexel model",
        "version": 1,
        "gravity": [0.0, 0.0, 0.0],
        "parts": [{"part": "point", "name": "A", "position": {"tuple": [1, 0, 0]}}],
    }


def part_with(**changes: Any) -> dict[str, Any]:
    """The file with another first part."""
    found = content()
    found["parts"][0] |= changes
    return found


DAMAGED: dict[str, tuple[Any, str]] = {
    "newer": (content() | {"version": 2}, "its version is 2, but this flexel reads 1; update flexel"),
    "another program's": (content() | {"format": "step"}, "this is not a flexel model"),
    "a list": ([1, 2], "this is not a flexel model"),
    "a number": (5, "this is not a flexel model"),
    "without parts": ({"format": "flexel model", "version": 1, "gravity": [0, 0, 0]}, "it is malformed"),
    "parts that are a number": (content() | {"parts": 5}, "it is malformed"),
    "a part that is a list": (content() | {"parts": [["point"]]}, "it is malformed"),
    "gravity that is a word": (content() | {"gravity": "down"}, "gravity"),
    "gravity that is a number": (content() | {"gravity": 9.81}, "it is malformed"),
    "an unknown part": (part_with(part="pont"), "part 1: unknown part 'pont'.*point"),
    "an unknown field": (part_with(colour="red"), r"part 1 \(point\): .*'colour'"),
    "a missing field": (content() | {"parts": [{"part": "point", "name": "A"}]}, r"part 1 \(point\): .*position"),
    "an unknown object": (part_with(position={"object": "Sphere", "arguments": {}}), "'Sphere' is not a flexel object"),
    "an object that is a function": (
        part_with(position={"object": "load", "arguments": {}}),
        "'load' is not a flexel object",
    ),
    "an object with another argument": (
        part_with(position={"object": "Circle", "arguments": {"width": 1.0}}), "part 1.*width"
    ),
    "an object with a wrong number": (
        part_with(position={"object": "Circle", "arguments": {"diameter": -1.0}}), "diameter"
    ),
    "a system of an unknown kind": (
        part_with(position={"object": "scipy.signal.lti", "arguments": {}}), "'scipy.signal.lti' is not a flexel object"
    ),
    "a system without matrices": (
        part_with(position={"object": "scipy.signal.StateSpace", "arguments": {}}), "it is malformed"
    ),
    "a system with another argument": (
        part_with(position={"object": "scipy.signal.StateSpace", "arguments": dict.fromkeys("ABCDE", 1.0)}),
        "part 1",
    ),
    "zeros of no shape": (part_with(position={"zeros": "x"}), "it is malformed"),
    "a complex number of text": (part_with(position={"complex": ["x", 1]}), "it is malformed|part 1"),
    "an unknown module": (part_with(position={"import": ["nowhere_at_all", "f"]}), "module 'nowhere_at_all' of 'f'"),
    "an unknown function": (part_with(position={"import": ["math", "sinus"]}), "module 'math' has no 'sinus'"),
    "an import of a number": (part_with(position={"import": 5}), "it is malformed"),
    "an empty import": (part_with(position={"import": []}), "it is malformed"),
    "an object without a kind": (part_with(position={"junk": 1}), "it is malformed"),
    "an import of no part": (part_with(part=["math", "sin"]), "sin is not a known part"),
    "a value that the part refuses": (part_with(position=[0, "x", 0]), "point 'A'"),
    "ragged numbers": (part_with(position={"array": [[1, 2], [3]]}), "part 1|point 'A'|malformed"),
}  # fmt: skip


@pytest.mark.parametrize("name", DAMAGED)
def test_a_wrong_file_is_refused_by_name(name: str, tmp_path: Path) -> None:
    given, message = DAMAGED[name]
    path = tmp_path / "model.json"
    path.write_text(json.dumps(given), encoding="utf-8")
    with pytest.raises(fx.ModelError, match=message) as raised:
        fx.load(path)
    assert "model.json" in str(raised.value)


def test_the_intact_file_is_loaded(tmp_path: Path) -> None:
    """What the wrong ones are changes of."""
    path = tmp_path / "model.json"
    path.write_text(json.dumps(content()), encoding="utf-8")
    m = fx.load(path)
    assert isinstance(m, fx.Model)
    assert_same(m.nodes["A"].x0, np.array([1.0, 0.0, 0.0]))


def test_every_truncated_file_is_refused(tmp_path: Path) -> None:
    whole = pointed().save(tmp_path / "whole.json").read_bytes()
    path = tmp_path / "model.json"
    for size in range(len(whole.rstrip()) - 1):
        path.write_bytes(whole[:size])
        with pytest.raises(fx.ModelError, match="cannot be read"):
            fx.load(path)


def test_files_that_are_none_are_refused(tmp_path: Path) -> None:
    with pytest.raises(fx.ModelError, match="cannot be read"):
        fx.load(tmp_path / "none.json")
    (tmp_path / "bytes.json").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(fx.ModelError, match="cannot be read"):
        fx.load(tmp_path / "bytes.json")
    with pytest.raises(fx.ModelError, match="ends in .json"):
        pointed().save(tmp_path / "model.txt")
    with pytest.raises(fx.FlexelError, match="save"):
        pointed().save(tmp_path / "no folder" / "model.json")


def test_nothing_in_a_file_is_executed(tmp_path: Path) -> None:
    """Text is text; a name that could be called is not called, and nothing that is not named is imported."""
    mark = tmp_path / "mark"
    code = f"__import__('pathlib').Path({str(mark)!r}).write_text('x')"
    path = tmp_path / "model.json"
    for position in (
        code,
        {"import": ["os", "getcwd"]},
        {"import": ["os", code]},
        {"object": code, "arguments": {}},
    ):
        path.write_text(json.dumps(part_with(position=position)), encoding="utf-8")
        with pytest.raises(fx.ModelError):
            fx.load(path)
    path.write_text(
        json.dumps(part_with(part=["subprocess", "Popen"], args=["touch", str(mark)])), encoding="utf-8"
    )
    with pytest.raises(fx.ModelError, match="Popen is not a known part"):
        fx.load(path)
    assert not mark.exists()
