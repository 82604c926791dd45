"""Modes of elements as the SPACAR talk counts them (slides 8 and 12 to 15), from the ranks of the compiled kernels."""

import numpy as np
import pytest
from numpy.typing import NDArray

from flexel.base.quaternions import conjugate, matrix, product
from flexel.derive.spec import ElementSpec
from flexel.derive.verify.kernel_calls import Compiled, generated_elements

Array = NDArray[np.float64]
SAMPLES = 64
ZERO = 1e-9  # of a singular value, over the largest
SIZES = {"planar_point": 2, "point": 3, "planar_angle": 1, "frame": 4}  # coordinates of a node

# element, coordinates, norms of Euler parameters, deformations, slips that are zero by default, motions that are left
COUNTS = [
    ("planar_truss", 4, 0, 1, 0, 3),
    ("planar_hinge", 2, 0, 1, 0, 1),
    ("planar_beam", 6, 0, 3, 0, 3),
    ("planar_beam_first_order", 6, 0, 3, 0, 3),
    ("truss", 6, 0, 1, 0, 5),
    ("hinge", 8, 2, 3, 0, 3),
    ("beam", 14, 2, 6, 0, 6),
    ("beam_first_order", 14, 2, 6, 0, 6),
    ("wheel", 10, 1, 4, 2, 3),
]


class Kernels:
    """The kernels of an element, and those of the norms of its frames, at one set of parameters for each sample."""

    def __init__(self, name: str) -> None:
        table = generated_elements()
        spec, address = table[name]
        assert isinstance(spec, ElementSpec)
        self.spec, self._element, self._norm = spec, Compiled(spec, address), Compiled(*table["norm"])
        rng = np.random.default_rng(28)
        self._p = np.hstack([np.zeros((SAMPLES, 0)), *(_parameter(rng, p.size) for p in spec.parameters)])
        parts, first = [], 0
        self.frames: list[slice] = []
        self.points: list[slice] = []
        for node in spec.nodes:
            size = SIZES[node.kind]
            if node.kind in ("frame", "point"):
                (self.frames if node.kind == "frame" else self.points).append(slice(first, first + size))
            parts.append(rng.normal(size=(SAMPLES, size)))
            first += size
        self.x = self._norms_kept(np.hstack(parts))

    def __call__(self) -> tuple[Array, Array, Array, Array]:
        """Return e, De, V and the derivatives of the norms at the coordinates."""
        found = self._element("position", {"x": self.x, "p": self._p})
        norms = np.zeros((SAMPLES, len(self.frames), self.x.shape[1]))
        for i, places in enumerate(self.frames):
            of_frame = self._norm("position", {"x": self.x[:, places], "p": np.zeros((SAMPLES, 0))})
            norms[:, i, places] = of_frame["De"][:, 0]
        return found["e"], found["De"], found["V"], norms

    def undeform(self) -> None:
        """Move every second sample to a configuration without deformation.

        Those of beams and hinges have triads that agree: folded over, they are not deformed either, but singular.
        """
        self._align()
        for _ in range(100):
            e, De, _, _ = self()
            step = np.einsum("bij,bj->bi", np.linalg.pinv(De, rcond=1e-6), e)[::2]
            step *= np.minimum(1.0, 0.5 / np.maximum(np.linalg.norm(step, axis=1, keepdims=True), 1e-300))
            self.x[::2] -= step
            self.x = self._norms_kept(self.x)
        assert np.max(np.abs(self()[0][::2])) < 1e-12

    def _align(self) -> None:
        """Turn both triads of every second sample nearly into one, with the point q ahead of p."""
        parameters = self._parameters()
        if not {"tp", "tq"} <= parameters.keys():
            return
        rng = np.random.default_rng(29)
        for i in range(0, SAMPLES, 2):
            common = rng.normal(size=4)
            common /= np.linalg.norm(common)
            for places, t in zip(self.frames, ("tp", "tq"), strict=True):
                self.x[i, places] = product(common, conjugate(parameters[t][i])) + 0.03 * rng.normal(size=4)
            if self.points:
                p, q = self.points
                ahead = parameters["l0"][i] * matrix(common)[:, 0]
                self.x[i, q] = self.x[i, p] + ahead + 0.03 * rng.normal(size=3)
        self.x = self._norms_kept(self.x)

    def _parameters(self) -> dict[str, Array]:
        """Return the values (samples, size) of the parameters by name."""
        sizes = np.cumsum([p.size for p in self.spec.parameters])[:-1]
        return dict(
            zip((p.name for p in self.spec.parameters), np.split(self._p, sizes, axis=1), strict=True)
        )

    def _norms_kept(self, x: Array) -> Array:
        for places in self.frames:
            x[:, places] /= np.linalg.norm(x[:, places], axis=1, keepdims=True)
        return x


def _parameter(rng: np.random.Generator, size: int) -> Array:
    """Draw positive numbers, and unit vectors and unit quaternions."""
    if size == 1:
        return rng.uniform(0.5, 1.5, size=(SAMPLES, 1))
    values = rng.normal(size=(SAMPLES, size))
    return np.asarray(values / np.linalg.norm(values, axis=1, keepdims=True))


def ranks(rows: Array) -> set[int]:
    """Ranks of matrices (samples, rows, n) at all samples, with a gap between what counts and what does not."""
    values = np.linalg.svd(rows, compute_uv=False)
    values /= values[:, :1]
    assert not np.any((values > ZERO) & (values < 1e3 * ZERO))
    return {int(rank) for rank in (values > ZERO).sum(axis=1)}


@pytest.mark.parametrize(("name", "n", "norms", "deformations", "slips", "left"), COUNTS)
def test_the_modes_of_an_element_are_as_many_as_the_talk_counts(
    name: str, n: int, norms: int, deformations: int, slips: int, left: int
) -> None:
    element = Kernels(name)
    element.undeform()
    spec, x, (_, De, V, N) = element.spec, element.x, element()
    held = [i for i, slip in enumerate(spec.slips) if not slip.free]
    assert (x.shape[1], N.shape[1], De.shape[1], len(held)) == (n, norms, deformations, slips)
    assert ranks(De) == {deformations}
    assert ranks(np.concatenate([De, N], axis=1)) == {deformations + norms}
    assert ranks(np.concatenate([De, N, V[:, held]], axis=1)) == {deformations + norms + slips} == {n - left}


@pytest.mark.parametrize("name", ["planar_beam", "truss", "hinge", "beam"])
def test_the_motions_that_are_left_are_rigid(name: str) -> None:
    """Rigid motions change no deformation and no norm, and there are no other motions with this property."""
    element = Kernels(name)
    spec, x, (_, De, _, N) = element.spec, element.x, element()
    n, plane = x.shape[1], spec.planar
    rigid = np.array([rigid_motions(spec, row, plane) for row in x])
    rows = np.concatenate([De, N], axis=1)
    size = np.linalg.norm(rows, axis=(1, 2)) * np.linalg.norm(rigid, axis=(1, 2))
    assert np.max(np.linalg.norm(rows @ rigid, axis=(1, 2)) / size) < 1e-13
    assert ranks(rigid.transpose(0, 2, 1)) == {n - rows.shape[1]}


def rigid_motions(spec: ElementSpec, x: Array, plane: bool) -> Array:
    """Rates (n, motions) of the coordinates in translations and rotations of the whole element."""
    axes, none = np.eye(3), np.zeros(3)
    motions = [(axis, none) for axis in (axes[:2] if plane else axes)]
    motions += [(none, axis) for axis in (axes[2:] if plane else axes)]
    return np.array([np.concatenate(_rates(spec, x, *motion)) for motion in motions]).T


def _rates(spec: ElementSpec, x: Array, velocity: Array, omega: Array) -> list[Array]:
    """Rates of the coordinates of each node."""
    found, first = [], 0
    for node in spec.nodes:
        size = SIZES[node.kind]
        place = x[first : first + size]
        first += size
        if node.kind == "planar_angle":
            found.append(omega[2:])
        elif node.kind == "frame":
            s, r = place[0], place[1:]
            found.append(np.array([-omega @ r, *(s * omega + np.cross(omega, r))]) / 2)
        else:
            arm = np.append(place, 0.0)[:3]
            found.append((velocity + np.cross(omega, arm))[:size])
    return found
