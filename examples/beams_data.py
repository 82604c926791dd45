"""Reference numbers of the published beam problems, read from `examples/data`, where their origin is stated.

Each is a closed form, or was computed twice independently.  SI units unless a comment says otherwise.
"""

from __future__ import annotations

from math import pi
from typing import Any

from flexel.examples.published import published

Table = tuple[tuple[float, ...], ...]

ELASTICA = "elastica, elliptic integrals as by Mattiasson (1981) IJNME 17:145-153"
ROLL_UP = "pure bending, exact: one full circle, the tip back at the clamp"
BEND = (
    "geometrically exact rod, GA as in Simo and Vu-Quoc (1986); Bathe and Bolourchi (1979) IJNME 14:961-986"
)
PRINCETON = (
    "geometrically exact rod; problem of Dowell and Traybar (1975) as in Bauchau et al. (2016) MBSD 37:29-48"
)
LATERAL = "Timoshenko and Gere: P = 4.0126 sqrt(EIy GJ)/L², 2 x first zero of J_{-1/4}"
PREBENDING = "geometrically exact rod, bent before it buckles as by Hodges and Peters (1975)"
EULER = "Euler, closed form"
FRAME = "geometrically exact rod; Argyris et al. (1979) 1.088, Simo and Vu-Quoc (1986) 1.09"
COLUMN = "post-buckled elastica, elliptic integrals as in Timoshenko and Gere, table 2-4"
ROTATING = "series, to 13 digits, as by Wright, Smith, Thresher and Wang (1982) J. Appl. Mech. 49:197-202"
WHIRL = "rotating Rayleigh shaft: (1 + q) w² - 2 q W w - wn² = 0, q = (I/A)(n pi/L)²"
TIMOSHENKO = "Timoshenko beam, frequency equation"
TIP_MASS = "Euler-Bernoulli beam with tip mass, frequency equation"
SPINUP = "Ritz solution, converged; problem of Simo and Vu-Quoc (1987) J. Sound Vib. 119:487-508"
KANE = "Ritz solution, converged; problem of Kane, Ryan and Banerjee (1987) J. Guidance 10:139-151"

_ELASTICA = published("elastica_cantilever")
_BENT = published("beam_large_deflection")
_BUCKLING = published("buckling")
_FREQUENCIES = published("beam_frequencies")
_SPINUP = published("spinup_beam")["cases"]


def _table(rows: list[dict[str, Any]], *keys: str) -> Table:
    """Return columns of rows by name, as numbers; a key may name a list of numbers."""
    return tuple(
        tuple(
            float(number)
            for key in keys
            for number in (row[key] if isinstance(row[key], list) else [row[key]])
        )
        for row in rows
    )


# P L²/EI, deflection w/L, shortening u/L of the cantilever under a transverse tip force.
TIP_FORCE = tuple(
    row
    for row in _table(_ELASTICA["vertical_tip_load"], "PL2_EI", "w_over_L", "u_over_L")
    if row[0] in (1.0, 2.0, 5.0, 10.0)
)

TIP_FORCE_TOLERANCES = {  # of the mesh of 32 elements, the limit, the order
    1.0: (3e-4, 2e-9, 1e-3),
    2.0: (7e-4, 5e-9, 1.6e-3),
    5.0: (1.2e-3, 1e-7, 0.01),
    10.0: (1.5e-3, 5e-7, 0.02),
}

# P/Pcr, x/L and y/L of the tip of the cantilever column bent by an end load.
POST_BUCKLED = _table(_ELASTICA["column_postbuckling"], "P_over_Pcr", "x_over_L", "y_over_L")

# Load [lbf], tip [in] of the 45 degree bend (J = 1/6, no shear correction).
_SIMO = [
    result
    for result in _BENT["bathe_bolourchi_45deg"]["results"]
    if result["case"].startswith("J=1/6, ks=1 ")
]
BEND_TIPS = _table(_SIMO, "P", "tip")

# Princeton beam: y along the width; EIz is the stiffness in the plane of the width.
_PRINCETON = _BENT["princeton_beam"]
PRINCETON_LENGTH: float = _PRINCETON["data"]["L"]
PRINCETON_SECTION: dict[str, float] = {
    name: _PRINCETON["data"][key]
    for name, key in (
        ("EA", "EA"), ("GJ", "GJ"), ("EIy", "EI_weak"), ("EIz", "EI_strong"), ("GAy", "kGA"), ("GAz", "kGA")
    )
}  # fmt: skip
# Load [N], angle [degrees], u, edgewise, flatwise deflection [m], twist [rad].
PRINCETON_TIPS = _table(
    _PRINCETON["results"], "P", "theta_deg", "u", "edgewise_e2", "flatwise_e3", "twist_rad"
)

_LATERAL = _BUCKLING["lateral_buckling_cantilever"]
LATERAL_FACTOR = float(_LATERAL["constant_4_0126"])
LATERAL_SECTION: dict[str, float] = {  # length 1 m
    name: _LATERAL["data"][key] for name, key in (("GJ", "GJ"), ("EIy", "EI_weak"), ("EIz", "EI_strong"))
}
LATERAL_PREBENT: float = _LATERAL["P_with_prebending_inextensible"]  # inextensible, no shear [N]
# Elements, error without and with second-order terms in percent, by an independent program (EIy = GJ = 1, EIz = 1e4).
LATERAL_ERRORS = ((2, 22.1, 6.9), (4, 4.6, 1.55), (8, 1.13, 0.40))

# Critical load over EI/L² by the supports of the two ends.
EULER_FACTORS = {
    "clamped-free": pi**2 / 4,
    "pinned-pinned": pi**2,
    "clamped-clamped": 4 * pi**2,
    "clamped-pinned": 20.190728556426629,  # x² with tan x = x
}
EULER_TOLERANCES = {
    "clamped-free": 3e-7,
    "pinned-pinned": 5e-6,
    "clamped-clamped": 8e-5,
    "clamped-pinned": 2e-5,
}
# Extensible, shearable cantilever column (EI = L = 1): P (1 + P/GA - P/EA) = pi²/4.
_COLUMN = _BUCKLING["euler_column"]["check"]
SHEARABLE: dict[str, float] = {"EA": _COLUMN["EA"], "GA": _COLUMN["GA"]}
SHEARABLE_LOAD: float = _COLUMN["P_numeric"]

# Right-angle frame, loaded along +x and -x [N]; legs of 240 mm, section 30 x 0.6 mm, J = b t³/3.
_FRAME = _BUCKLING["right_angle_frame"]
FRAME_LOADS: tuple[float, float] = tuple(
    _FRAME["results"]["J=b t^3/3"][case][0] for case in ("plus_x", "minus_x")
)
FRAME_SECTION: dict[str, float] = {name: float(_FRAME["data"][name]) for name in ("leg", "b", "t", "E", "nu")}

# Hub radius/L, eta = W sqrt(rhoA L⁴/EI), three flap and three lag frequencies (times sqrt(rhoA L⁴/EI)).
ROTATING_BLADES = _table(
    _FREQUENCIES["rotating_cantilever"]["rows"], "hub_radius_over_L", "eta", "flap", "lag_inextensible"
)

# Tip mass over beam mass, beta L of the first mode.
TIP_MASSES = tuple((float(mass), float(w)) for mass, w in _FREQUENCIES["cantilever_tip_mass"].items())

# Square beams of length 1 m: E, nu, density.
SQUARE = {"E": 2.07e11, "nu": 0.3, "rho": 7850.0}
# Height [m], three frequencies of the cantilever, three of the pinned beam [rad/s].
SQUARE_BEAMS = _table(
    _FREQUENCIES["timoshenko_square_beam"]["cases"], "h", "cantilever_Timoshenko", "pinned_Timoshenko"
)

SPIN_SIMO: dict[str, float] = _SPINUP["Simo_VuQuoc"]["data"]
SPIN_KANE: dict[str, float] = _SPINUP["Kane"]["data"]
# Time [s], tip displacement along and across the beam [m] in the rotating frame.
SPIN_SIMO_TIPS = _table(_SPINUP["Simo_VuQuoc"]["reference"], "t", "u1", "u2")
SPIN_KANE_TIPS = _table(_SPINUP["Kane"]["reference"], "t", "u1", "u2")
# Stretch at steady spin [m]: L (tan m/m - 1), m = W L sqrt(rhoA/EA).
SPIN_STEADY: tuple[float, float] = tuple(
    _SPINUP[source]["steady_axial_exact"] for source in ("Simo_VuQuoc", "Kane")
)
