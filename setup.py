"""What pyproject.toml cannot say: the sub-packages, the C extension, one wheel for all Pythons >= 3.11.

The environment's FLEXEL_CFLAGS come after all other flags of the compiler, and so win over them (CFLAGS come first).
"""

import os
import shlex
from concurrent.futures import ThreadPoolExecutor

from setuptools import Extension, find_packages, setup
from setuptools.command.build_ext import build_ext

ROOTS = {"flexel": "runtime"} | {
    f"flexel.{name}": name for name in ("derive", "generated", "examples", "benchmarks")
}
FOUND = [f"{root}.{name}" for root, folder in ROOTS.items() for name in find_packages(folder)]
ABI3 = {"bdist_wheel": {"py_limited_api": "cp311"}}


class SideBySide(build_ext):
    """Compile the C files on all processors; setuptools alone takes one after another."""

    def build_extension(self, ext: Extension) -> None:
        """Compile and link, with a compiler that takes many sources at once."""
        ext.extra_compile_args += shlex.split(os.environ.get("FLEXEL_CFLAGS", ""))
        one = self.compiler.compile

        def many(sources: list[str], **options: object) -> list[str]:
            with ThreadPoolExecutor(os.cpu_count()) as pool:
                return sum(pool.map(lambda source: one([source], **options), sources), [])

        self.compiler.compile = many
        super().build_extension(ext)


setup(
    packages=[*ROOTS, *FOUND],
    cffi_modules=["generated/build.py:ffibuilder"],
    cmdclass={"build_ext": SideBySide},
    options=ABI3,
)
