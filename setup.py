"""What pyproject.toml cannot say: the sub-packages, the C extension, one wheel for all Pythons >= 3.11.

The environment's FLEXEL_CFLAGS come after all other flags of the compiler, and so win over them (CFLAGS come first).
With FLEXEL_PORTABLE=1 the extension runs on every processor of its kind and chooses a vector width when it is loaded;
without, it is compiled for this processor, in half the time and with the same digits.
"""

import logging
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import ModuleType

from setuptools import Extension, find_packages, setup
from setuptools.command.build_ext import build_ext
from setuptools.errors import CompileError

ROOTS = {"flexel": "runtime"} | {
    f"flexel.{name}": name for name in ("derive", "generated", "parts", "results", "apps", "examples")
}
FOUND = [f"{root}.{name}" for root, folder in ROOTS.items() for name in find_packages(folder)]
ABI3 = {"bdist_wheel": {"py_limited_api": "cp311"}}
# They find out whether this processor can run the others.
FOR_EVERY_PROCESSOR = ("flexel.generated._kernels.c", "processor.c")

for package in ("flexel", "flexel.derive"):  # as they will be installed, without running their __init__.py
    sys.modules[package] = ModuleType(package)
    sys.modules[package].__path__ = [str(Path(__file__).parent / ROOTS[package])]
from flexel.derive.object_files import compile_object, remove_oldest  # noqa: E402
from flexel.derive.processor import native_flags  # noqa: E402

NATIVE = () if os.environ.get("FLEXEL_PORTABLE", "0") not in ("", "0") else native_flags()


class KeptObjects(build_ext):
    """Compile the C files on all processors, and only what was not compiled before, in any environment."""

    def finalize_options(self) -> None:
        """Never judge by dates, which know nothing of flags and compilers: the cache of objects knows them."""
        super().finalize_options()
        self.force = True

    def build_extension(self, ext: Extension) -> None:
        """Compile and link, with a compiler that takes many sources at once."""
        ext.extra_compile_args += ["-g0", *shlex.split(os.environ.get("FLEXEL_CFLAGS", ""))]
        missing = set(FOR_EVERY_PROCESSOR) - {Path(source).name for source in ext.sources}
        if missing:
            raise CompileError(f"no source is named {', '.join(sorted(missing))}; see FOR_EVERY_PROCESSOR")
        one = self.compiler.compile

        def many(sources: list[str], **options: object) -> list[str]:
            with ThreadPoolExecutor(os.cpu_count()) as pool:
                return sum(pool.map(lambda source: one([source], **options), sources), [])

        self.compiler.compile = many
        self.compiler._compile = self._compile_one
        super().build_extension(ext)
        remove_oldest()

    def _compile_one(
        self, made: str, source: str, _: str, flags: list[str], last: list[str], __: list[str]
    ) -> None:
        own = () if Path(source).name in FOR_EVERY_PROCESSOR else NATIVE
        command = [*self.compiler.compiler_so, *(flag for flag in flags if flag != "-c"), *own, *last]
        try:
            if compile_object(command, Path(source), Path(made)):
                self.announce(f"compiled {source}", level=logging.INFO)
        except subprocess.CalledProcessError as error:
            raise CompileError(f"{source} does not compile: {error}") from error


setup(
    packages=[*ROOTS, *FOUND],
    cffi_modules=["generated/build.py:ffibuilder"],
    cmdclass={"build_ext": KeptObjects},
    options=ABI3,
)
