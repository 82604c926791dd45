"""Copies of a model, what of the user travels with it, and what cannot."""

import copy
import functools
import io
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mechanisms import slider
from otherprocess import other_process
from own_elements import own_bar
from travellers import HARDENING, push, pushed

import flexel as fx


def sent(value: Any) -> Any:
    """The object after a journey in a pickle."""
    return pickle.loads(pickle.dumps(value))


# -- copies -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("copied", [sent, copy.deepcopy], ids=lambda copied: copied.__name__)
def test_a_copy_of_a_model_is_independent(copied: Callable[[Any], Any]) -> None:
    """Whatever is declared in one is not seen in the other."""
    m = pushed()
    before = repr(m.build())
    other = copied(m)
    other.point("Q", (2, 0))
    other.fix("P")
    other.instances["mass"].parameters["mass"][:] = 7.0
    other.load("D.x", 2.0)
    other.initial("D.x", 0.5)
    other.prescribe("D.x", 1.0)
    assert repr(m.build()) == before
    assert set(other.nodes) - set(m.nodes) == {"Q"}
    assert m.instances["mass"].parameters["mass"] == [1.0]
    m.point("R", (3, 0))
    assert "R" not in other.nodes


def test_nodes_of_a_model_are_nodes_of_its_deep_copy() -> None:
    m = fx.Model()
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (1, 0, 0))
    other = copy.deepcopy(m)
    other.truss("bar", O, A)
    assert "bar" not in m.instances
    again, (P, Q) = sent((m, (O, A)))
    again.truss("bar", P, Q)
    with pytest.raises(fx.ModelError, match="the node 'A' belongs to another model"):
        again.point_mass("mass", A, 1.0)


def test_built_in_elements_travel_by_name() -> None:
    instance = slider().instances["strut"]
    assert sent(instance).spec is copy.deepcopy(instance).spec is instance.spec
    assert len(pickle.dumps(instance)) < 1000


def test_a_pickle_of_another_version_is_refused() -> None:
    m = slider()
    text = pickle.dumps(m).replace(m.instances["strut"].spec.digest.encode(), b"0123456789abcdef")
    with pytest.raises(
        fx.ModelError, match="truss 'strut': the pickle is from another version of flexel; build"
    ):
        pickle.loads(text)


# -- elements and laws of the user ------------------------------------------------------------------

EIGENVALUES = """
import numpy as np
system = given[0].build()
print(np.linalg.eigvals(system.linearize().state_matrix).tobytes().hex())
assert not {"sympy", "flexel.derive.user_definitions"} & set(sys.modules)
"""
REFUSED = """
import flexel as fx
print(given[1], given[2][-1]["A.z"], len(given[2].system.structure.names))
for evaluate in (given[0].build, lambda: given[1].linearize(given[2][-1]), lambda: given[2][-1].J):
    try:
        evaluate()
    except fx.CompilerError as error:
        print(error)
"""


def own_pendulum() -> fx.Model:
    """A pendulum of an element and a law of the user's own."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0, 0, -1))
    m.fix("A.y")
    m.element("bar", fx.compile_element(own_bar()), "O", "A", l0=1.0, mass=2.0)
    m.law("bar.elongation", fx.compile_law(HARDENING), k=100.0)
    return m


def test_own_elements_and_laws_are_compiled_once_elsewhere_without_their_definition(tmp_path: Path) -> None:
    """The C code travels: no SymPy, no derivation, and the next process finds it in its cache."""
    m = own_pendulum()
    here, cache = np.linalg.eigvals(m.build().linearize().state_matrix).tobytes().hex(), tmp_path / "cache"
    assert other_process(tmp_path, EIGENVALUES, m, XDG_CACHE_HOME=str(cache)) == here
    files = sorted(cache.rglob("*.so"))
    assert [file.name.partition("-")[0] for file in files] == ["own_bar", "own_hardening"]
    times = [file.stat().st_mtime_ns for file in files]
    assert other_process(tmp_path, EIGENVALUES, m, XDG_CACHE_HOME=str(cache)) == here
    assert [file.stat().st_mtime_ns for file in sorted(cache.rglob("*.so"))] == times


def test_without_cache_and_compiler_the_element_is_named(tmp_path: Path) -> None:
    """Models, systems and motions can be read; what needs the kernels says whose they are."""
    m = own_pendulum()
    system = m.build()
    motion = system.simulate(0.1, samples=3)
    given = {"XDG_CACHE_HOME": str(tmp_path / "empty"), "CC": "no-such-compiler"}
    first, *lines = other_process(tmp_path, REFUSED, m, system, motion, **given).splitlines()
    assert first == f"{system} {motion[-1]['A.z']} {len(system.structure.names)}"
    assert len(lines) == 3
    assert all(line.startswith("own_bar 'bar': no C compiler 'no-such-compiler'") for line in lines)


def test_copies_use_the_kernels_that_are_loaded() -> None:
    m = own_pendulum()
    for other in (sent(m), copy.deepcopy(m)):
        assert other.instances["bar"].kernels == m.instances["bar"].kernels
        assert other.instances["bar"].spec == m.instances["bar"].spec
        assert np.array_equal(other.build().linearize().state_matrix, m.build().linearize().state_matrix)
    compiled = fx.compile_law(HARDENING)
    assert sent(compiled).address == copy.deepcopy(compiled).address == compiled.address
    assert sent(compiled).spec == compiled.spec
    assert len(pickle.dumps(compiled)) < 10_000


# -- functions of the user --------------------------------------------------------------------------


class Rig:
    """A machine whose force is a method of the object that holds the model."""

    def __init__(self) -> None:
        self.model = slider()
        self.model.load("A.x", self.force)

    def force(self, t: Any) -> Any:
        """A force."""
        return 2.0 * t


class Locked:
    """A function of time that cannot be pickled."""

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate."""
        return t, 1.0, 0.0

    def __reduce__(self) -> Any:
        raise OSError("it holds an open file")


def nothing(_: float) -> float:
    """Zero."""
    return 0.0


def loaded(value: Any) -> fx.Model:
    """The slider under a load."""
    m = slider()
    m.load("A.x", value)
    return m


def prescribed(value: Any) -> fx.Model:
    """A mass with a given motion."""
    m = fx.Model()
    m.point("D", (0, 1))
    m.point_mass("mass", "D", 1.0)
    m.prescribe("D.x", value)
    return m


ADVICE = "; use a function defined in a module"
REFUSALS: dict[str, tuple[Callable[[], Any], str]] = {
    "load": (lambda: loaded(lambda t: t), "load on 'A.x': <function <lambda>"),
    "system": (lambda: loaded(lambda t: t).build(), "load on 'A.x': <function"),
    "motion": (lambda: loaded(lambda t: t).build().simulate(0.01, samples=2), "load on 'A.x': <function"),
    "triple": (lambda: loaded((nothing, nothing, lambda t: 0.0)), "load on 'A.x': <function <lambda>"),
    "partial": (
        lambda: loaded(functools.partial(lambda a, t: a * t, 2.0)),
        r"load on 'A.x': functools.partial",
    ),
    "prescribed motion": (
        lambda: prescribed(lambda t: 0.1 * t).build(),
        "prescribe 'D.x': <fun",
    ),
    "object": (lambda: prescribed(Locked()), r"prescribe 'D.x': .*it holds an open file"),
    "event": (lambda: fx.Event("top", lambda s: s["A.x"]), "event 'top': <function <lambda>"),
}


@pytest.mark.parametrize("name", REFUSALS)
def test_a_function_that_cannot_be_pickled_is_named_by_its_owner(name: str) -> None:
    make, message = REFUSALS[name]
    refused = make()
    with pytest.raises(fx.ModelError, match=message) as reported:
        pickle.dumps(refused)
    assert ADVICE in str(reported.value)
    assert ("fx.Harmonic" in str(reported.value)) == (name != "event")
    assert type(copy.deepcopy(refused)) is type(refused)  # in this process the function is shared


class ByValue(pickle.Pickler):
    """Writes a lambda as its text."""

    def reducer_override(self, obj: Any) -> Any:
        """What makes the object again."""
        return (eval, ("lambda t: 2 * t",)) if getattr(obj, "__name__", "") == "<lambda>" else NotImplemented


def test_a_pickler_that_writes_functions_themselves_is_left_to_do_so() -> None:
    """Such as that of joblib: it is known by the module that calls."""
    file = io.BytesIO()
    pickler, m = ByValue(file), loaded(lambda t: 2 * t)
    with pytest.raises(fx.ModelError, match=r"load on 'A.x'"):
        pickler.dump(m)
    file.seek(0)
    exec("pickler.dump(m)", {"__name__": "cloudpickle.cloudpickle", "pickler": ByValue(file), "m": m})
    assert pickle.loads(file.getvalue()).build().loads.at(1.5)[0].max() == 3.0


def test_functions_of_modules_travel_by_name() -> None:
    for value in (
        push,
        np.sin,
        functools.partial(np.multiply, 2.0),
        (nothing, nothing, nothing),
        Rig().force,
    ):
        m = loaded(value)
        assert sent(m).build().loads.at(0.3)[0].tolist() == m.build().loads.at(0.3)[0].tolist()


def test_a_method_of_the_object_that_holds_the_model_travels_with_it() -> None:
    rig = sent(Rig())
    assert rig.model.loads[0].function.function.__self__ is rig
    assert rig.model.build().loads.at(0.5)[0].max() == 1.0
