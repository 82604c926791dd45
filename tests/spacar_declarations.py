"""The declarations of the model of a SPACAR file, without their lines."""

import flexel as fx
from flexel.parts.method import METHOD_OF
from flexel.parts.model_program import statement


def declared(found: fx.Spacar, method: str = "") -> list[str]:
    """The declarations of the model of a file as its program has them: all, or those by one method."""
    return [statement(part, "m", {}) for part in found.model.parts if method in ("", METHOD_OF[type(part)])]
