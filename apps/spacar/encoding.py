"""Decodes the lines of a file, in any of the usual encodings."""

from __future__ import annotations

import codecs
from pathlib import Path

from flexel.base.errors import ModelError

CONTROL_CHARACTERS = frozenset(range(32)) - frozenset(b"\t\n\v\f\r\x1a")  # DOS ends a file with 1a
MAX_CONTROL_SHARE = 0.05  # share of control characters above which a file is not text


def file_lines(path: Path) -> list[str]:
    """Return the lines of a text file.

    The input language uses only ASCII, but comments and names are in UTF-8 (with or without a mark at
    its beginning), in UTF-16 with a mark, or, in older files, in Latin-1.  DOS ends a file with 1a.

    Raises
    ------
    ModelError
        A file that is not text.
    """
    data = path.read_bytes()
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)) and len(data) % 2 == 0:
        data = data.decode("utf-16", errors="replace").encode()
    controls = sum(byte in CONTROL_CHARACTERS for byte in data)
    if 0 in data or controls > MAX_CONTROL_SHARE * len(data):
        raise ModelError(
            f"{path.name}: is not text (it has {controls} control characters); give a SPACAR input file, written as "
            "ASCII, UTF-8 or Latin-1"
        )
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    text = text.partition("\x1a")[0]
    # not splitlines: an ellipsis of Windows, 85, would end a comment
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
