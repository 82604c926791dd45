"""The linear equations of the bicycle by the formulas of the 2007 benchmark (appendix A), from the 25 parameters."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from flexel.base.arrays import Array


def matrices(p: Mapping[str, float]) -> dict[str, Array]:
    """Return M, C1, K0, K2 (2, 2) of M q'' + v C1 q' + (g K0 + v² K2) q = 0, q = (lean, steer)."""
    s, c = np.sin(p["lam"]), np.cos(p["lam"])
    m, x, z, T = _whole(p)
    m_A, A, x_A, z_A = _front(p)
    u = (x_A - p["w"] - p["c"]) * c - z_A * s  # of the front assembly from the steering axis
    I_ll = m_A * u**2 + A["xx"] * s**2 + 2 * A["xz"] * s * c + A["zz"] * c**2
    I_lx = -m_A * u * z_A + A["xx"] * s + A["xz"] * c
    I_lz = m_A * u * x_A + A["xz"] * s + A["zz"] * c
    mu = p["c"] / p["w"] * c
    S_F = p["IFyy"] / p["rF"]
    S_T = p["IRyy"] / p["rR"] + S_F
    S_A = m_A * u + mu * m * x
    M = [[T["xx"], I_lx + mu * T["xz"]], [I_lx + mu * T["xz"], I_ll + 2 * mu * I_lz + mu**2 * T["zz"]]]
    K0 = [[m * z, -S_A], [-S_A, -S_A * s]]
    K2 = [[0.0, (S_T - m * z) / p["w"] * c], [0.0, (S_A + S_F * s) / p["w"] * c]]
    C1 = [
        [0.0, mu * S_T + S_F * c + T["xz"] / p["w"] * c - mu * m * z],
        [-(mu * S_T + S_F * c), I_lz / p["w"] * c + mu * (S_A + T["zz"] / p["w"] * c)],
    ]
    return {name: np.array(value) for name, value in (("M", M), ("C1", C1), ("K0", K0), ("K2", K2))}


def _whole(p: Mapping[str, float]) -> tuple[float, float, float, dict[str, float]]:
    """Return mass, mass centre and moments of inertia at the rear contact of the whole bicycle."""
    m = p["mR"] + p["mB"] + p["mH"] + p["mF"]
    x = (p["xB"] * p["mB"] + p["xH"] * p["mH"] + p["w"] * p["mF"]) / m
    z = (-p["rR"] * p["mR"] + p["zB"] * p["mB"] + p["zH"] * p["mH"] - p["rF"] * p["mF"]) / m
    wheels = p["IRxx"] + p["IFxx"]
    xx = p["IBxx"] + p["IHxx"] + wheels + p["mR"] * p["rR"] ** 2 + p["mF"] * p["rF"] ** 2
    xx += p["mB"] * p["zB"] ** 2 + p["mH"] * p["zH"] ** 2
    xz = p["IBxz"] + p["IHxz"] - p["mB"] * p["xB"] * p["zB"] - p["mH"] * p["xH"] * p["zH"]
    xz += p["mF"] * p["w"] * p["rF"]
    zz = (
        p["IBzz"]
        + p["IHzz"]
        + wheels
        + p["mB"] * p["xB"] ** 2
        + p["mH"] * p["xH"] ** 2
        + p["mF"] * p["w"] ** 2
    )
    return m, x, z, {"xx": xx, "xz": xz, "zz": zz}


def _front(p: Mapping[str, float]) -> tuple[float, dict[str, float], float, float]:
    """Return mass, moments of inertia at the mass centre, and mass centre of the front assembly."""
    m = p["mH"] + p["mF"]
    x = (p["xH"] * p["mH"] + p["w"] * p["mF"]) / m
    z = (p["zH"] * p["mH"] - p["rF"] * p["mF"]) / m
    inertia = {
        "xx": p["IHxx"] + p["IFxx"] + p["mH"] * (p["zH"] - z) ** 2 + p["mF"] * (p["rF"] + z) ** 2,
        "xz": p["IHxz"] - p["mH"] * (p["xH"] - x) * (p["zH"] - z) + p["mF"] * (p["w"] - x) * (p["rF"] + z),
        "zz": p["IHzz"] + p["IFxx"] + p["mH"] * (p["xH"] - x) ** 2 + p["mF"] * (p["w"] - x) ** 2,
    }
    return m, inertia, x, z
