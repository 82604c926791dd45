"""What careless callers give instead of an argument, by name, and what an annotation admits of it."""

import datetime
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

import flexel as fx

# Whole values.  Functions, so that each case gets a fresh one.
JUNK: dict[str, Callable[[], Any]] = {
    "None": lambda: None,
    "true": lambda: True,
    "zero": lambda: 0,
    "five": lambda: 5,
    "minus one": lambda: -1,
    "half": lambda: 0.5,
    "huge whole number": lambda: 10**400,
    "nan": lambda: np.nan,
    "infinity": lambda: np.inf,
    "minus infinity": lambda: -np.inf,
    "1e308": lambda: 1e308,
    "-1e308": lambda: -1e308,
    "1e-308": lambda: 1e-308,
    "complex": lambda: 1j,
    "text": lambda: "junk",
    "no text": lambda: "",
    "zero byte": lambda: "a\0b",
    "lone surrogate": lambda: "a\ud800",
    "long text": lambda: "x" * 5000,
    "bytes": lambda: b"junk",
    "object": object,
    "function": lambda: print,
    "class": lambda: int,
    "date": lambda: datetime.date(2000, 1, 1),
    "material": lambda: fx.Material(1.0),
    "empty list": list,
    "list of one": lambda: [1],
    "list of None": lambda: [None],
    "list of text": lambda: ["junk"],
    "list of lists": lambda: [["junk"], [[1]]],
    "ragged": lambda: [[1.0], [2.0, 3.0]],
    "set": lambda: {1, "junk"},
    "empty mapping": dict,
    "mapping": lambda: {"junk": 1.0},
    "mapping of junk": lambda: {"junk": None, 1: object()},
    "flags": lambda: np.array([True, False]),
    "empty array": lambda: np.zeros(0),
    "three numbers": lambda: np.ones(3),
    "three nan": lambda: np.full(3, np.nan),
    "thousand numbers": lambda: np.ones(1000),
    "square": lambda: np.ones((3, 3)),
    "texts": lambda: np.array(["a", "b"]),
    "objects": lambda: np.array([object(), None]),
}

# In place of the first entry of a sequence, an array or a mapping.
ENTRIES = (
    "None",
    "nan",
    "infinity",
    "1e308",
    "huge whole number",
    "complex",
    "text",
    "bytes",
    "object",
    "list of one",
)

NOT_FINITE = {"nan", "infinity", "minus infinity"}
TEXTS = {"text", "no text", "zero byte", "lone surrogate", "long text"}
WHOLE = {"zero", "five", "minus one", "huge whole number"}
REALS = WHOLE | {"half", "1e308", "-1e308", "1e-308", "true"}
MAPPINGS = {"empty mapping", "mapping", "mapping of junk"}
LISTS = {"empty list", "list of text", "texts", "empty array", "empty mapping"}


def inside(valid: Any, kind: str) -> Any:
    """The valid collection with junk in place of its first entry; None if it has no entries."""
    value = JUNK[kind]()
    if isinstance(valid, Mapping) and valid:
        return {**valid, next(iter(valid)): value}
    if isinstance(valid, np.ndarray) and valid.size:
        valid = valid.tolist()
    if isinstance(valid, (list, tuple)) and valid:
        return type(valid)([value, *valid[1:]]) if type(valid) in (list, tuple) else None
    return None


def admitted(annotation: str, kind: str) -> bool:
    """Whether a call may take the junk without a word: an annotation that says nothing definite admits all."""
    parts = {part.strip() for part in annotation.split("|")}
    if kind == "None" and "None" in parts:
        return True
    parts -= {"None"}
    known: dict[str, set[str]] = {
        "float": REALS,
        "int": WHOLE,
        "bool": {"true"},
        "str": TEXTS,
        "Mapping[str, float]": MAPPINGS,
        "Mapping[str, Any]": MAPPINGS,
        "Sequence[str]": LISTS,
    }
    if not parts <= known.keys():
        return True
    return any(kind in known[part] for part in parts)
