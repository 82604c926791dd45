"""tools/lock.txt has a version of each package that pyproject.toml asks for, for every Python."""

import re
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name


@pytest.mark.parametrize("python", ["3.11", "3.12", "3.13", "3.14"])
def test_the_lock_has_all_that_is_required(checkout: Path, python: str) -> None:
    here = {"python_version": python, "python_full_version": f"{python}.0", "sys_platform": "linux"}
    here |= {"platform_system": "Linux", "platform_machine": "x86_64"}
    with open(checkout / "pyproject.toml", "rb") as file:
        content = tomllib.load(file)
    project = content["project"]
    wanted = [*content["build-system"]["requires"], *project["dependencies"]]
    wanted += [line for extra in project["optional-dependencies"].values() for line in extra]
    lines = (checkout / "tools" / "lock.txt").read_text(encoding="utf-8").splitlines()
    locked = [Requirement(line) for line in lines if re.match(r"\w", line)]
    versions = {canonicalize_name(r.name): r for r in locked if r.marker is None or r.marker.evaluate(here)}
    for requirement in map(Requirement, wanted):
        if requirement.name == "flexel" or not (
            requirement.marker is None or requirement.marker.evaluate(here)
        ):
            continue
        (pinned,) = versions[canonicalize_name(requirement.name)].specifier
        assert pinned.operator == "==" and requirement.specifier.contains(pinned.version), requirement
