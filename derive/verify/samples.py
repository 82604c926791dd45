"""Random configurations: anywhere, with large rotations, and near zero deformation.

Values follow from the kind of a node and the size and unit of a parameter, so
that a user's own element is sampled like the built-in ones, unless ranges are given; the seed is the element's
name.
"""

import zlib
from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from flexel.derive.declare import TIME, Element, Law, Parameter
from flexel.derive.verify.kernel_calls import Compiled

Array = NDArray[np.float64]
Ranges = Mapping[str, tuple[float, float]]
NOTHING: Ranges = MappingProxyType({})
NEAR = 1e-2  # size of the disturbance of a configuration with zero deformation


def _generator(name: str) -> np.random.Generator:
    return np.random.default_rng(zlib.crc32(name.encode()))


def _unit_vectors(rng: np.random.Generator, count: int, size: int) -> Array:
    values = rng.normal(size=(count, size))
    return np.asarray(values / np.linalg.norm(values, axis=1, keepdims=True))


def _parameter(rng: np.random.Generator, count: int, parameter: Parameter) -> Array:
    """Draw unit vectors and unit quaternions where there is no unit; positive scalars; any other vectors."""
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


def _inside(rng: np.random.Generator, element: Element, compiled: Compiled, x: Array, p: Array) -> Array:
    """Draw coordinates again where the element has no deformation, such as pulleys inside one another."""
    for _ in range(100):
        outside = ~np.isfinite(compiled("position", {"x": x, "p": p})["e"]).all(axis=1)
        if not outside.any():
            break
        x[outside] = _coordinates(rng, len(x), element)[outside]
    return x


def _relaxed(compiled: Compiled, x: Array, p: Array) -> Array:
    """Return coordinates with (nearly) zero deformations, by least-norm Newton steps of bounded length.

    Not-a-number where the steps lead out of the domain of the deformations.
    """
    x = x.copy()
    for _ in range(60):
        position = compiled("position", {"x": x, "p": p})
        e, De = position["e"], position["De"]
        wild = ~(np.isfinite(e).all(axis=1) & np.isfinite(De.reshape(len(De), -1)).all(axis=1))
        x[wild], e[wild], De[wild] = np.nan, 0.0, 0.0
        step = np.einsum("bij,bj->bi", np.linalg.pinv(De, rcond=1e-6), e)
        length = np.linalg.norm(step, axis=1, keepdims=True)
        x = x - step * np.minimum(1.0, 0.5 / np.maximum(length, 1e-300))
    return x


def _limits(
    symbols: Sequence[sp.Symbol], parameters: Sequence[Parameter], ranges: Ranges
) -> tuple[Array, Array]:
    """Return the lowest and highest values (rows,) of the symbols, not-a-number where the ranges say nothing."""
    by_symbol = {s.name: ranges[p.name] for p in parameters if p.name in ranges for s in p.symbols}
    by_symbol |= {s.name: ranges[s.name] for s in symbols if s.name in ranges}
    limits = np.array([by_symbol.get(s.name, (np.nan, np.nan)) for s in symbols]).reshape(-1, 2)
    return limits[:, 0], limits[:, 1]


def _within(rng: np.random.Generator, values: Array, low: Array, high: Array) -> Array:
    """Replace values (count, rows) by random ones between limits where there are limits."""
    return np.where(np.isnan(low), values, low + (high - low) * rng.uniform(size=values.shape))


def check_ranges(declared: Element | Law, ranges: Ranges) -> None:
    """Raise ValueError for a range of something unknown, or one that is not two increasing numbers.

    The two numbers of a parameter may be equal.
    """
    symbols = declared.arguments
    known = list(dict.fromkeys([*(p.name for p in declared.parameters), *(s.name for s in symbols)]))
    for name, limits in ranges.items():
        if name not in known:
            raise ValueError(f"'{declared.name}': a range of unknown '{name}'; there are {', '.join(known)}")
        try:
            low, high = (float(limit) for limit in limits)
        except (TypeError, ValueError):
            low = high = np.nan
        fixed = low == high and name not in [s.name for s in symbols if s not in declared.parameter_symbols]
        if not (-np.inf < low < high < np.inf or (fixed and np.isfinite(low))):
            raise ValueError(f"'{declared.name}': the range {limits} of '{name}' is not (lowest, highest)")


def element_samples(
    element: Element, compiled: Compiled, count: int, ranges: Ranges = NOTHING, redraw: bool = True
) -> dict[str, Array]:
    """Draw inputs of all kernels of an element, each (count, rows), every second near zero deformation.

    `ranges` limits coordinates and parameters by name, in place of those that follow from their kinds.  Coordinates
    at which the element has no real deformation are drawn again, unless `redraw` says not.
    """
    rng = _generator(element.name)
    p = _parameters(rng, count, element.parameters)
    x = _coordinates(rng, count, element)
    low, high = _limits(element.x, element.parameters, ranges)
    if ranges:
        p = _within(rng, p, *_limits(element.parameter_symbols, element.parameters, ranges))
        x = _within(rng, x, low, high)
    n, m, k = x.shape[1], len(element.deformations), len(element.slips)
    if m and compiled.has("position"):
        x = _inside(rng, element, compiled, x, p) if redraw else x
        near = slice(1, None, 2)
        relaxed = _relaxed(compiled, x[near], p[near]) + NEAR * rng.normal(size=x[near].shape)
        inside = np.isfinite(relaxed) & ~(relaxed < low) & ~(relaxed > high)  # no limit is not-a-number
        relaxed = np.where(inside, relaxed, x[near])
        e = compiled("position", {"x": relaxed, "p": p[near]})["e"]
        usable = np.asarray(np.isfinite(e).all(axis=1))
        x[near] = np.where(usable[:, None], relaxed, x[near])
    v, a = rng.normal(size=(2, count, n))
    return {
        "x": x,
        "v": v,
        "a": a,
        "p": p,
        "sigma": rng.normal(size=(count, m)),
        "tau": rng.normal(size=(count, k)),
        "e": rng.normal(size=(count, m)),
    }


def law_samples(law: Law, count: int, ranges: Ranges = NOTHING) -> dict[str, Array]:
    """Draw inputs of the kernels of a law, each (count, rows); `ranges` as in `element_samples`."""
    rng = _generator(law.name)
    m, k = len(law.e), len(law.s)
    samples = {
        "e": rng.normal(size=(count, m)),
        "ed": rng.normal(size=(count, m)),
        "s": rng.normal(size=(count, k)),
        "p": _parameters(rng, count, law.parameters),
    }
    samples |= {"z": rng.normal(size=(count, len(law.z))), "t": rng.normal(size=(count, 1))}
    if ranges:
        columns = {"e": law.e, "ed": law.ed, "s": law.s, "z": law.z, "t": (TIME,), "p": law.parameter_symbols}
        for name, symbols in columns.items():
            samples[name] = _within(rng, samples[name], *_limits(symbols, law.parameters, ranges))
    return samples


def lanes(data: Mapping[str, Array], chosen: slice) -> dict[str, Array]:
    """Return some elements of a batch."""
    return {name: values[chosen] for name, values in data.items()}
