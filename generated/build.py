"""Builds the extension ``flexel.generated._kernels`` with cffi (API mode, one file for every Python 3).

The kernels are beside this file, what calls them is in the runtime's folder ``engine``. What Python sees of them is
what their headers declare between ``cdef: begin`` and ``cdef: end``.

Written by `flexel derive`; do not edit.
"""

import os
import re

from cffi import FFI

FOLDER = os.path.dirname(__file__)
FLAGS = ["-O2", "-fno-math-errno", "-fno-trapping-math", "-fopenmp-simd", "-ffp-contract=off", "--param=ira-max-conflict-table-size=1"]
BETWEEN = re.compile(r"/\* cdef: begin \*/\n(.*?)/\* cdef: end \*/", re.DOTALL)


def engine() -> str:
    """The folder of what calls the kernels: in a checkout, or in an installed package."""
    places = [os.path.normpath(os.path.join(FOLDER, *parts)) for parts in (("..", "runtime", "engine"), ("..", "engine"))]
    return next(place for place in places if os.path.isdir(place))


def files(ending: str) -> list[str]:
    """The files of both folders with such a name, those of the kernels first."""
    found = ((folder, sorted(os.listdir(folder or "."))) for folder in (FOLDER, ENGINE))
    return [os.path.join(folder, name) for folder, names in found for name in names if name.endswith(ending)]


def declarations(header: str) -> str:
    """What a header declares, for numbers of double precision."""
    with open(header, encoding="utf-8") as text:
        return re.sub(r"\breal\b", "double", "".join(BETWEEN.findall(text.read())))


def depth(header: str) -> int:
    """How many headers a header includes below one another: those it builds on are declared before it."""
    with open(header, encoding="utf-8") as text:
        included = re.findall(r'#include "(.*?)"', text.read())
    return 1 + max((depth(PATHS[name]) for name in included if name in PATHS), default=0)


ENGINE = engine()
PATHS = {os.path.basename(header): header for header in files(".h")}
HEADERS = sorted(PATHS.values(), key=depth)

ffibuilder = FFI()
for header in HEADERS:
    ffibuilder.cdef(declarations(header))
ffibuilder.set_source(
    "flexel.generated._kernels",
    "\n".join(f'#include "{os.path.basename(header)}"' for header in HEADERS),
    sources=files(".c"),
    depends=HEADERS,
    include_dirs=[FOLDER or ".", ENGINE],
    extra_compile_args=FLAGS,
    py_limited_api=True,
)
