"""A valid call of a public function, from which the campaign of bad input makes invalid ones."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Valid:
    """A call that works.

    ``arguments`` are given by the names of the signature: those of ``*names`` as a tuple, those of ``**options`` as
    a mapping.  ``after`` does with the result what its user does next: a declaration may be judged by `Model.build`.
    """

    function: Callable[..., Any]
    arguments: Mapping[str, Any]
    after: Callable[[Any], Any] = lambda result: None


def calling(function: Callable[..., Any], **arguments: Any) -> Valid:
    """A valid call without a sequel."""
    return Valid(function, arguments)
