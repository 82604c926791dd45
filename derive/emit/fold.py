"""Long lines of C folded: statements before an operator, comments between words."""

import re

WIDTH = 118
_BREAK = re.compile(r" (?=(?:[-+*/?:<>]|[<>!=]=|&&|\|\||=|/\*) )|(?<=,) ")


def folded(text: str) -> str:
    """Fold the text so that no line is longer than `WIDTH`, as far as possible."""
    return "\n".join(part for line in text.split("\n") for part in _folded(line))


def _folded(line: str) -> list[str]:
    if len(line) <= WIDTH or line.startswith("#"):
        return [line]
    indent = line[: len(line) - len(line.lstrip())]
    if line.startswith(("/*", " *")):
        head = re.match(r"(/\*| \*) *", line)
        assert head is not None
        return _filled(line.split(" "), " " + "*".ljust(len(head[0]) + 1))
    return _filled(_BREAK.split(line), indent + "    ")


def _filled(parts: list[str], indent: str) -> list[str]:
    """Join parts by blanks into lines, each as long as may be."""
    lines = [parts[0]]
    for part in parts[1:]:
        if len(lines[-1]) + 1 + len(part) <= WIDTH:
            lines[-1] += f" {part}"
        else:
            lines.append(indent + part)
    return lines
