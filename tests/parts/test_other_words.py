"""A call that a model does not have is answered with what it is called here."""

import copy
import pickle
import re

import pytest

import flexel as fx
from flexel.parts.other_words import CALLS


@pytest.mark.parametrize(
    ("name", "remedy"),
    [
        ("damper", "a model has no 'damper'; a damper is m.spring(on, damping=…)"),
        ("force", "a model has no 'force'; a force is m.load(target, value)"),
        ("simulate", "analyses belong to the built system: s = m.build()"),
        ("Motor", "m.prescribe(name, motion)"),
        ("revolut", "did you mean revolute?"),
        ("xyzzy", "a model has no 'xyzzy'"),
    ],
)
def test_other_words_are_answered(name: str, remedy: str) -> None:
    with pytest.raises(AttributeError, match=re.escape(remedy)):
        getattr(fx.Model(), name)


def test_the_remedies_exist_and_the_words_do_not() -> None:
    for words, text in CALLS.items():
        assert not [word for word in words if hasattr(fx.Model, word)]
        for call in re.findall(r"\bm\.(\w+)", text):
            assert hasattr(fx.Model, call)
        for call in re.findall(r"\bs\.(\w+)", text):
            assert hasattr(fx.System, call)


def test_models_are_copied_and_pickled_as_before() -> None:
    m = fx.Model()
    m.point("A", (0, 0, 0))
    assert [model.nodes["A"].name for model in (copy.deepcopy(m), pickle.loads(pickle.dumps(m)))] == [
        "A",
        "A",
    ]
    assert not hasattr(m, "damper")
