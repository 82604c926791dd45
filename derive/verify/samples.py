"""Random configurations: anywhere, with large rotations, and near zero deformation.

This room may import numpy. Values follow from the kind of a node and the size and unit of a parameter, so
that a user's own element is sampled like the built-in ones; the seed is the element's name.
"""

import zlib
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from flexel.derive.element import Element, Law, Parameter
from flexel.derive.verify.compiled import Compiled

Array = NDArray[np.float64]
NEAR = 1e-2  # size of the disturbance of a configuration with zero deformation


def _generator(name: str) -> np.random.Generator:
    return np.random.default_rng(zlib.crc32(name.encode()))


def _unit_vectors(rng: np.random.Generator, count: int, size: int) -> Array:
    values = rng.normal(size=(count, size))
    return np.asarray(values / np.linalg.norm(values, axis=1, keepdims=True))


def _parameter(rng: np.random.Generator, count: int, parameter: Parameter) -> Array:
    """Unit vectors and unit quaternions where there is no unit; positive scalars; any other vectors."""
    if parameter.size in (3, 4) and parameter.unit == "1":
        return _unit_vectors(rng, count, parameter.size)
    if parameter.size == 1:
        return rng.uniform(0.5, 1.5, size=(count, 1))
    return rng.normal(size=(count, parameter.size))


def _parameters(rng: np.random.Generator, count: int, parameters: tuple[Parameter, ...]) -> Array:
    return np.hstack([np.zeros((count, 0)), *(_parameter(rng, count, p) for p in parameters)])


def _coordinates(rng: np.random.Generator, count: int, element: Element) -> Array:
    parts = []
    for node in element.nodes:
        if node.kind == "frame":  # of nearly unit length: the kernels are defined off the unit sphere, too
            parts.append(_unit_vectors(rng, count, 4) * rng.uniform(0.95, 1.05, size=(count, 1)))
        elif node.kind == "planar_angle":
            parts.append(rng.uniform(-np.pi, np.pi, size=(count, 1)))
        else:
            parts.append(rng.uniform(-1.0, 1.0, size=(count, node.size)))
    return np.hstack(parts)


def _relaxed(compiled: Compiled, x: Array, p: Array) -> Array:
    """Coordinates with (nearly) zero deformations, by least-norm Newton steps of bounded length."""
    for _ in range(60):
        position = compiled("position", {"x": x, "p": p})
        step = np.einsum("bij,bj->bi", np.linalg.pinv(position["De"], rcond=1e-6), position["e"])
        length = np.linalg.norm(step, axis=1, keepdims=True)
        x = x - step * np.minimum(1.0, 0.5 / np.maximum(length, 1e-300))
    return x


def element_samples(element: Element, compiled: Compiled, count: int) -> dict[str, Array]:
    """Inputs of all kernels of an element, each (count, rows), every second near zero deformation."""
    rng = _generator(element.name)
    p = _parameters(rng, count, element.parameters)
    x = _coordinates(rng, count, element)
    n, m, k = x.shape[1], len(element.deformations), len(element.slips)
    if m and compiled.has("position"):
        near = slice(1, None, 2)
        relaxed = _relaxed(compiled, x[near], p[near]) + NEAR * rng.normal(size=x[near].shape)
        x[near] = np.where(np.isfinite(relaxed), relaxed, x[near])
    v, a = rng.normal(size=(2, count, n))
    return {
        "x": x,
        "v": v,
        "a": a,
        "p": p,
        "sigma": rng.normal(size=(count, m)),
        "tau": rng.normal(size=(count, k)),
    }


def law_samples(law: Law, count: int) -> dict[str, Array]:
    """Inputs of the kernels of a law, each (count, rows)."""
    rng = _generator(law.name)
    m, k = len(law.e), len(law.s)
    arrays = {
        "e": rng.normal(size=(count, m)),
        "ed": rng.normal(size=(count, m)),
        "s": rng.normal(size=(count, k)),
        "p": _parameters(rng, count, law.parameters),
    }
    return arrays | {"z": rng.normal(size=(count, len(law.z))), "t": rng.normal(size=(count, 1))}


def lanes(data: Mapping[str, Array], chosen: slice) -> dict[str, Array]:
    """Some elements of a batch."""
    return {name: values[chosen] for name, values in data.items()}
