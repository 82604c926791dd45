"""The memory of structures in C, with all that they point to, as one file: a program without Python goes on from it.

Memory that several structures share is in the file once, so that the program shares it too.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from flexel.engine.structs import Struct
from flexel.engine.tables import Tables
from flexel.generated._kernels import ffi, lib

SYMBOL = 56  # bytes of the name of a table of kernels
OWNED = "first"  # field of a flexel_matrix from which on all belongs to C


def _address(value: Any) -> int:
    return int(ffi.cast("uintptr_t", value))


def _kernels() -> dict[int, tuple[str, int]]:
    """Table and offset in it of each kernel, by its address."""
    found: dict[int, tuple[str, int]] = {}
    for name in dir(lib):
        table = getattr(lib, name)
        if isinstance(table, ffi.CData) and ffi.typeof(table).cname in ("flexel_element", "flexel_law"):
            for field, about in ffi.typeof(table).fields:
                if about.type.kind == "function":
                    found[_address(getattr(table, field))] = name, about.offset
    return found


def _memory(kept: Any) -> Iterable[tuple[int, int]]:
    """Start and size of the memory of what a structure keeps alive."""
    if isinstance(kept, np.ndarray):
        while isinstance(kept.base, np.ndarray):
            kept = kept.base
        yield kept.ctypes.data, kept.nbytes
    elif isinstance(kept, ffi.CData):
        yield _address(kept), ffi.sizeof(kept)
    else:
        for part in kept:
            yield from _memory(part)


class Image:
    """Memory of structures, and the pointers in it.

    Parameters
    ----------
    tables : Tables
        Their lists belong to all structures.
    structs : sequence of Struct
    """

    def __init__(self, tables: Tables, structs: Sequence[Struct]) -> None:
        shared = [array for pair in tables._shared.values() for array in pair[1:]] + [tables.samples]
        regions = dict(_memory(shared))
        for struct in structs:
            own = struct.struct
            regions |= dict(_memory(struct._keep))
            regions[_address(own)] = ffi.sizeof(ffi.typeof(own).item)
        self.starts = sorted(regions)
        self.sizes = [regions[start] for start in self.starts]
        self.content = [
            bytearray(ffi.buffer(ffi.cast("char *", start), regions[start])) for start in self.starts
        ]
        self.pointers: dict[tuple[int, int], tuple[int, int]] = {}
        self.functions: dict[tuple[int, int], tuple[str, int]] = {}
        self._kernels = _kernels()
        self._seen: set[tuple[int, str]] = set()
        for struct in structs:
            self._structure(ffi.typeof(struct.struct).item, _address(struct.struct))

    def place(self, address: int) -> tuple[int, int]:
        """Number of the region of an address, and the offset in it; the end of a region belongs to it."""
        number = bisect_right(self.starts, address) - 1
        offset = address - self.starts[number]
        assert number >= 0 and offset <= self.sizes[number], "a pointer to what nothing keeps alive"
        return number, offset

    def write(self, file: Path, roots: Sequence[Sequence[Struct]], *numbers: int) -> None:
        """Write the file: regions, pointers, kernels, the structures of each thread, other numbers."""
        counts = [len(self.starts), len(self.pointers), len(self.functions), len(roots)]
        with file.open("wb") as out:
            out.write(np.array([*counts, *numbers, *self.sizes], dtype=np.uint64).tobytes())
            places = [(*place, *to) for place, to in self.pointers.items()]
            out.write(np.array(places, dtype=np.uint64).tobytes())
            for (number, offset), (name, field) in self.functions.items():
                out.write(np.array([number, offset, field], dtype=np.uint64).tobytes())
                out.write(name.encode().ljust(SYMBOL, b"\0"))
            own = [[self.place(_address(struct.struct))[0] for struct in root] for root in roots]
            out.write(np.array(own, dtype=np.uint64).tobytes())
            out.writelines(self.content)

    # -- pointers --------------------------------------------------------------------------------

    def _structure(self, ctype: Any, address: int) -> None:
        if (address, ctype.cname) in self._seen:
            return
        self._seen.add((address, ctype.cname))
        for name, field in ctype.fields:
            if ctype.cname == "flexel_matrix" and name == OWNED:
                self._clear(address + field.offset, ffi.sizeof(ctype) - field.offset)
                return
            self._value(field.type, address + field.offset)

    def _value(self, ctype: Any, address: int) -> None:
        if ctype.kind == "struct":
            self._structure(ctype, address)
        elif ctype.kind in ("pointer", "function"):
            target = int(ffi.cast("uintptr_t *", address)[0])
            if not target:
                return
            if ctype.kind == "function":
                self.functions[self.place(address)] = self._kernels[target]
                return
            self.pointers[self.place(address)] = self.place(target)
            if ctype.item.kind in ("struct", "pointer"):
                self._several(ctype.item, target)

    def _several(self, ctype: Any, address: int) -> None:
        """Structures, or pointers, up to the end of their region."""
        number, offset = self.place(address)
        for place in range(offset, self.sizes[number], ffi.sizeof(ctype)):
            self._value(ctype, self.starts[number] + place)

    def _clear(self, address: int, size: int) -> None:
        number, offset = self.place(address)
        self.content[number][offset : offset + size] = bytes(size)
