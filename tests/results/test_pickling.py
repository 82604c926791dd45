"""Models, systems and results in pickles and deep copies: the same digits, in this process and in a new one."""

import copy
import os
import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import travellers
from otherprocess import other_process
from rides import ride, same
from travellers import OBJECTS, content, fingerprint

import flexel as fx

MADE: dict[str, Any] = {}  # each object once


def made(name: str) -> Any:
    """The object of that name."""
    if name not in MADE:
        MADE[name] = OBJECTS[name]()
    return MADE[name]


def sent(value: Any) -> Any:
    """The object after a journey in a pickle."""
    return pickle.loads(pickle.dumps(value))


@pytest.mark.parametrize("copied", [sent, copy.deepcopy, copy.copy], ids=lambda copied: copied.__name__)
@pytest.mark.parametrize("name", OBJECTS)
def test_a_copy_has_the_same_content(name: str, copied: Any) -> None:
    assert content(copied(made(name))) == content(made(name))


def test_every_public_class_is_among_the_objects() -> None:
    """Sources of errors apart: what is public and not seen in any pickle is missing above."""
    seen: set[type] = set()

    class Watch(pickle.Pickler):
        def persistent_id(self, obj: Any) -> None:
            seen.add(type(obj))

    with open(os.devnull, "wb") as nowhere:
        for name in OBJECTS:
            Watch(nowhere).dump(made(name))
    public = {value for name in fx.__all__ if isinstance(value := getattr(fx, name), type)}
    assert {kind.__name__ for kind in public - seen if not issubclass(kind, BaseException)} == set()


def test_a_new_process_finds_the_same_content_and_computes_the_same_digits(tmp_path: Path) -> None:
    names = [name for name in OBJECTS if name != "error"]
    code = f"""
from travellers import figures, fingerprint
print(*map(fingerprint, given))
print(figures(given[{names.index("system")}]))
"""
    contents, figures = other_process(tmp_path, code, *(made(name) for name in names)).split("\n", 1)
    assert contents.split() == [fingerprint(made(name)) for name in names]
    assert figures == travellers.figures(sent(made("system")))


@pytest.mark.long
def test_an_ensemble_runs_in_another_process_and_its_motions_come_back() -> None:
    systems = []
    for value in (0.1, 0.2):
        m = travellers.own_law()
        m.initial("strut.elongation", value)
        systems.append(m.build())
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        motions = list(pool.map(travellers.run, systems))
    for system, motion in zip(systems, motions, strict=True):
        here = travellers.run(sent(system))
        assert all(same(a, b) for a, b in zip(motion, here, strict=True))
        with pytest.raises(fx.ModelError, match=r"another process: system.restore\(state\)"):
            system.linearize(motion[-1])
        assert same(system.restore(motion), here[-1])


@pytest.mark.parametrize("copied", [sent, copy.deepcopy], ids=lambda copied: copied.__name__)
def test_a_copied_system_computes_the_same_digits(copied: Any) -> None:
    system = copy.deepcopy(made("system"))
    assert travellers.figures(copied(system)) == travellers.figures(system)
    system.use_coordinates(system.dynamic[::-1])
    again = copied(system)
    assert again.dynamic == system.dynamic != made("system").dynamic
    assert travellers.figures(again) == travellers.figures(system)
    again.use_coordinates(made("system").dynamic)
    assert again.dynamic != system.dynamic


def test_a_motion_keeps_its_dense_output_its_system_and_one_structure() -> None:
    motion = made("motion")
    again = sent(motion)
    assert same(again.at(0.123), motion.at(0.123))
    assert again.system.structure is again.structure is again[5].structure is again.events[0][1].structure
    assert again[5].evaluation is again.system.evaluation
    assert again[0].roles is again[1].roles
    assert same(again.system.restore(again), motion.system.restore(motion))
    first = travellers.eigenvalues(again.system.linearize(again[-1]))
    assert first == travellers.eigenvalues(motion.system.linearize(motion[-1]))


def test_a_long_motion_is_as_large_as_its_numbers() -> None:
    """1000 states of the bicycle: arrays and a fifth more, the structure (10 kB) once; less before they are read."""
    motion = ride(0.2, 1000)
    unread = pickle.dumps(motion)
    states = list(motion)  # states are complete once they were read
    arrays = [value for value in vars(motion[0]).values() if isinstance(value, np.ndarray)]
    numbers = 1000 * sum(array.nbytes for array in arrays)
    size = len(pickle.dumps(motion))
    assert numbers < size < 1.2 * numbers
    assert len(pickle.dumps(motion.structure)) < 0.005 * size
    assert len(unread) < 0.4 * size
    assert all(same(a, b) for a, b in zip(pickle.loads(unread), states, strict=True))


def test_a_deep_copy_of_a_state_shares_what_never_changes() -> None:
    state = made("state")
    again = copy.deepcopy(state)
    assert same(again, state)
    assert again.x is not state.x
    assert (again.structure, again.roles) == (state.structure, state.roles)
    assert again.structure is state.structure


def test_a_copied_linearization_has_the_same_eigenvalues() -> None:
    lin = made("linearization")
    for again in (sent(lin), copy.deepcopy(lin)):
        assert travellers.eigenvalues(again) == travellers.eigenvalues(lin)
        assert again.units == lin.units


def test_results_from_files_are_copied_too(tmp_path: Path) -> None:
    for name in ("motion", "linearization", "periodic solution"):
        read = fx.load(made(name).save(tmp_path / f"{name}.npz"))
        again = sent(read)
        assert content(again) == content(read) == content(copy.deepcopy(read))
    motion = sent(fx.load(tmp_path / "motion.npz"))
    assert np.array_equal(motion[2].J, made("motion")[2].J)
    with pytest.raises(fx.ModelError, match="comes from a file and has no system"):
        motion.system  # noqa: B018


def test_an_error_brings_its_motion_along() -> None:
    error = made("error")
    again = sent(error)
    assert type(again) is type(error)
    assert str(again) == str(error)
    assert again.motion.t[-1] == error.motion.t[-1]
