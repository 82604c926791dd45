"""Prints the oldest versions that pyproject.toml admits, one requirement a line, for pip.

`python .ci/oldest.py test` adds those of an extra. What these versions bring with them is as new as pip finds it,
except what would not work with them.
"""

import re
import sys
import tomllib
from collections.abc import Iterator

BESIDE = ["pyparsing<3.3"]  # newer ones warn of what Matplotlib 3.10.0 calls, and a warning fails a test


def oldest(project: dict[str, dict[str, list[str]]], requirements: list[str]) -> Iterator[str]:
    """Yield the lower bound of each requirement as the only version, including the extras of the project itself."""
    for requirement in requirements:
        own = re.fullmatch(r"flexel\[(.*)\]", requirement)
        if own:
            for extra in own[1].split(","):
                yield from oldest(project, project["optional-dependencies"][extra])
        elif requirement.count(">=") != 1:
            sys.exit(f"pyproject.toml: '{requirement}' has no lower bound; write it as name>=version")
        else:
            yield requirement.replace(">=", "==")


def main(extras: list[str]) -> None:
    """Print the requirements of the project, of these extras, and of its build."""
    with open("pyproject.toml", "rb") as file:
        content = tomllib.load(file)
    project = content["project"]
    wanted = [*project["dependencies"], *content["build-system"]["requires"]]
    for extra in extras:
        wanted += project["optional-dependencies"][extra]
    print(*dict.fromkeys([*oldest(project, wanted), *BESIDE]), sep="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
