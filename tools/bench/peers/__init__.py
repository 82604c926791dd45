"""The same models in other programs, one module for each.

A program is imported when one of its rows is prepared, so that the table can be read without it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import metadata
from importlib.util import find_spec

from bench import beams
from bench.peers import bicycleparameters, exudyn, mujoco, pinocchio, symbrim
from bench.ratios import program
from bench.timing import Work


@dataclass(frozen=True)
class Peer:
    """Another program.

    Attributes
    ----------
    name : str
        Of the program and of the module that is imported; behind a comma how it is used, where that differs.
    distribution : str
        Name of its package for pip.
    rows : mapping
        Its work for each row, by name.
    largest : mapping
        Largest size of a row that scales, where there is one.
    """

    name: str
    distribution: str
    rows: Mapping[str, Callable[..., Work]]
    largest: Mapping[str, int] = field(default_factory=dict)

    @property
    def program(self) -> str:
        """Its name without the way it is used."""
        return program(self.name)

    @property
    def installed(self) -> bool:
        """Whether it can be imported."""
        return find_spec(self.program) is not None

    @property
    def version(self) -> str | None:
        """Version of the installed program; None: not installed."""
        return metadata.version(self.distribution) if self.installed else None

    def can(self, row: str, size: int | None) -> bool:
        """Whether a model of this size is not too large for it."""
        return size is None or size <= self.largest.get(row, size)


PEERS = (
    Peer("exudyn", "exudyn", exudyn.ROWS),
    Peer("exudyn, full Newton", "exudyn", exudyn.FULL_NEWTON),
    Peer(f"exudyn, {beams.LOAD_STEPS} load steps", "exudyn", exudyn.IN_LOAD_STEPS),
    Peer("pinocchio", "pin", pinocchio.ROWS, pinocchio.LARGEST),
    Peer("mujoco", "mujoco", mujoco.ROWS, mujoco.LARGEST),
    Peer("symbrim", "symbrim", symbrim.ROWS),
    Peer("symbrim, in C", "symbrim", symbrim.IN_C),
    Peer("bicycleparameters", "BicycleParameters", bicycleparameters.ROWS),
)


def beside(row: str) -> list[Peer]:
    """Return the programs that have a row of this name."""
    return [peer for peer in PEERS if row in peer.rows]
