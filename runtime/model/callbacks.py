"""The kernels of a law that calls Python: a continuous controller given by a function.

The engine calls it like every other law, also from its threads.  What the function raises is kept, and the forces are
not a number; the caller of the engine then calls `raise_failure`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from threading import local
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.base.nested import WITHIN
from flexel.derive.spec import InternalSpec, KernelSpec, LawSpec, OutputSpec
from flexel.generated._kernels import ffi
from flexel.model.controller import Controller
from flexel.model.instances import LawInstance
from flexel.model.windup import BackCalculation

LANES = 8
KERNEL = "void(size_t, const double *const *, double *const *)"


def callbacks_of(laws: Iterable[LawInstance]) -> list[Callback]:
    """Return the kernels of laws that call Python."""
    return [law.code for law in laws if isinstance(law.code, Callback)]


def raise_failures(codes: Iterable[object]) -> None:
    """Raise what the function of a controller has raised, if it has: the cause of forces that are not numbers."""
    for code in codes:
        if isinstance(code, Callback):
            code.raise_failure()


@dataclass(frozen=True)
class Wires:
    """How a controller is connected to the deformations (m) and slips (k) of its law.

    Attributes
    ----------
    inputs : tuple of int
        Places of the inputs in (e, ė, s).
    offsets : ndarray (ny,)
        Added to them: coordinates where they are drawn, of displacements.
    outputs : tuple of int
        Places of the outputs in (e, s).
    """

    m: int
    k: int
    inputs: tuple[int, ...]
    offsets: Array
    outputs: tuple[int, ...]


@dataclass(frozen=True)
class Callback:
    """Kernels that evaluate a controller's function and differentiate it numerically.

    It is pickled as the controller and its wires.
    """

    controller: Controller
    wires: Wires
    _failed: local = field(default_factory=local, repr=False, compare=False)

    def __getstate__(self) -> dict[str, Any]:
        """Return the arguments."""
        return {"controller": self.controller, "wires": self.wires}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Build the same law in this process."""
        self.__dict__.update(state, _failed=local())

    def __deepcopy__(self, _: object) -> Callback:
        """Return the same object, which never changes."""
        return self

    @cached_property
    def spec(self) -> LawSpec:
        """The specification of the law; only entries that depend on the inputs are stored."""
        w, nx = self.wires, self.controller.rule.nx
        columns = 2 * w.m + w.k + nx
        used = [*dict.fromkeys(w.inputs), *range(2 * w.m + w.k, columns)]
        rows = [*w.outputs, *range(w.m + w.k, w.m + w.k + nx)]
        inputs = ("e", "ed", "s", "z", "t", "p")
        law = (
            OutputSpec("sigma", (w.m,), tuple(range(w.m))),
            OutputSpec("tau", (w.k,), tuple(range(w.k))),
            OutputSpec("zd", (nx,), tuple(range(nx))),
            OutputSpec("U", (1,), ()),
            OutputSpec("P", (1,), (0,)),
        )
        stored = tuple(sorted(i * columns + j for i in rows for j in used))
        tangent = (OutputSpec("J", (w.m + w.k + nx, columns), stored),)
        return LawSpec(
            name="controller",
            digest="",
            doc="a Python function",
            deformations=w.m,
            slips=w.k,
            states=tuple(InternalSpec(f"x{i}", "1") for i in range(nx)),
            parameters=(),
            kernels={"law": KernelSpec(inputs, law, 0), "tangent": KernelSpec(inputs, tangent, 0)},
        )

    @cached_property
    def _kernels(self) -> tuple[Any, ...]:
        """The C struct, and what it refers to."""
        law, tangent = (
            ffi.callback(KERNEL, self._guarded(function)) for function in (self._law, self._tangent)
        )
        struct, empty = ffi.new("flexel_law *"), ffi.new("char[]", b"")
        struct.name = struct.digest = empty
        struct.m, struct.k, struct.nz = self.wires.m, self.wires.k, self.controller.rule.nx
        struct.law, struct.tangent = law, tangent
        return struct, law, tangent, empty

    @property
    def address(self) -> int:
        """Address of the ``flexel_law``."""
        return int(ffi.cast("uintptr_t", self._kernels[0]))

    def raise_failure(self) -> None:
        """Raise what the function raised in this thread since the last time."""
        failed: BaseException | None = self._failed.__dict__.pop("error", None)
        if failed is not None:
            raise failed

    def forget_failure(self) -> None:
        """Discard an error of the function from a trial step; an interrupt is raised."""
        if isinstance(getattr(self._failed, "error", None), FlexelError):
            del self._failed.error
        self.raise_failure()

    def _guarded(self, kernel: Any) -> Any:
        """Wrap a kernel for C: an error is kept, and the outputs are then NaN."""
        law = kernel == self._law
        outputs = self.spec.kernels["law" if law else "tangent"].outputs
        sizes = [len(output.nonzeros) for output in outputs]

        def run(_: int, given: Any, out: Any) -> None:
            try:
                with WITHIN:
                    found = kernel(given)
            except BaseException as error:  # an interrupt too: nothing may leave a function that C has called
                self._failed.error = error
                found = [np.full(size, np.nan) for size in sizes]
            for i, values in enumerate(found):
                for j, value in enumerate(values):
                    out[i][LANES * j] = value

        return run

    def _given(self, given: Any) -> tuple[Array, Array, Array, float]:
        """Return (e, ė, s) in one array, the inputs, the own state and the time."""
        w, nx = self.wires, self.controller.rule.nx
        sizes = (w.m, w.m, w.k, nx)
        e, ed, s, z = ([given[i][LANES * j] for j in range(n)] for i, n in enumerate(sizes))
        every = np.array([*e, *ed, *s])
        return every, every[list(w.inputs)] + w.offsets, np.array(z), float(given[4][0])

    def _law(self, given: Any) -> list[Array]:
        """Return sigma, tau, zd, U and P."""
        w = self.wires
        every, y, x, t = self._given(given)
        u, xd = self.controller.advanced(t, y, x)
        stress = np.zeros(w.m + w.k)
        stress[list(w.outputs)] = -u
        power = stress @ every[w.m :]
        return [stress[: w.m], stress[w.m :], xd, np.zeros(0), np.array([power])]

    def _tangent(self, given: Any) -> list[Array]:
        """Return the stored entries of J."""
        w, c = self.wires, self.controller
        _, y, x, t = self._given(given)
        slopes = c.rule.slopes(t, y, x)
        u, nu, ny = c.rule(t, y, x)[0], len(c.outputs), y.size
        beyond = (u < c.low) | (u > c.high)
        if isinstance(c.windup, BackCalculation):
            slopes[nu:] -= c.windup.gains[:, beyond] @ slopes[:nu][beyond]
        slopes[:nu][beyond] = 0.0
        J = np.zeros((w.m + w.k + x.size, 2 * w.m + w.k + x.size))
        rows = [*w.outputs, *range(w.m + w.k, len(J))]
        slopes[:nu] *= -1
        for j, place in enumerate(w.inputs):
            J[rows, place] += slopes[:, j]
        J[rows, 2 * w.m + w.k :] = slopes[:, ny:]
        return [J.ravel()[list(self.spec.kernels["tangent"].outputs[0].nonzeros)]]
