"""What pyproject.toml cannot say: the sub-packages, the C extension, one wheel for all Pythons >= 3.11."""

from setuptools import find_packages, setup

ROOTS = {"flexel": "runtime"} | {f"flexel.{name}": name for name in ("derive", "generated", "examples")}
FOUND = [f"{root}.{name}" for root, folder in ROOTS.items() for name in find_packages(folder)]
ABI3 = {"bdist_wheel": {"py_limited_api": "cp311"}}

setup(packages=[*ROOTS, *FOUND], cffi_modules=["generated/build.py:ffibuilder"], options=ABI3)
