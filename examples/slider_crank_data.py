"""Published and reference numbers of the flexible slider-crank; SI units.

Data: Song and Haug (1980), as in the manual SPACAR95.  Deflections are of the rod's midpoint from the line through
its ends, left of crank pin to slider positive, over the rod's length.
"""

from __future__ import annotations

from flexel.examples.published import published

TALK = "Schwab, talk on SPACAR (2004), slides 23-30; data of Song and Haug (1980)"
EXACT = "(pi/l)^2 sqrt(EI/(rho A)), pinned rod, no shear, no rotary inertia"
TWO = "two cubic elements, consistent mass; 832 in the talk"
MODES = (
    "inextensible rod, 3 bending modes, simulated until periodic; the 5th mode, left out there, adds 0.03 %"
)
TALK_RESONANCES = 5.0, 4.0, 3.0  # first natural frequency over the speed, slides 29 and 30
RESONANCES = (
    "omega0 over the speeds of the last three maxima; slides 29, 30: resonance at 1/5, 1/4, 1/3 of omega0"
)
RESONANCES_FULL = "the same, full equations; the softening resonance at omega0/3 leans towards lower speeds"
BOTH = "[linearized, full], from the straight rod, 0...0.1 s at 150 rad/s"
GAP = "largest difference of both, over the rod's length"
IN_TIME = "the same equations in the time domain, periodic start from the transition over a period"
MAXIMA = "rows of speed [rad/s], largest deflection; linearized, 50 to 330 rad/s"
MAXIMA_FULL = "rows of speed [rad/s], largest deflection; full equations, 50 to 330 rad/s"
FOLDS = "the full motions turn back near omega0/3, by arc length; none if empty"
FIVE_TURNS = (
    "deflections after 1 to 5 turns, simulated from a full periodic motion near the maximum at omega0/5"
)
PAIRS = "[cosine, sine] of harmonics 0...6, t = 0 at the stretched dead centre"
TIMED = "200 speeds, linearized, 2 elements, 12 harmonics, building included; budget 2 s"
SPACE = "the same model in space, largest difference over the period"
EXCITED = (
    "rows of harmonic n; at 1/n of the first frequency, as static deflection/l of the first mode: direct excitation, "
    "by varying stiffness, together; together/(2 zeta) at 1 % damping, and the amplitude in the linearized sweep"
)
ONE = "a multiplier is 1 where the branch turns back"
TURNS = (
    "deflections after 1 to 5 turns, simulated from the motions at 257 rad/s on both stable branches; the larger one "
    "neglects 2e-4"
)
FINE = (
    "the first of fold_speeds_1pct, found with steps half as long; each within 1e-3 of a step along the curve"
)
PEAKS = "rows of speed [rad/s], modulus of the largest multiplier, where it has a maximum; unstable above 1"
TRANSIENT = "inextensible Euler-Bernoulli rod, bending modes converged, 0...0.1 s"

_TABLES = published("slider_crank_flexible")

# Crank and rod [m], EI [N m²], EA [N] and mass per length [kg/m] of the round rod of 6 mm, half its mass [kg].
DATA: dict[str, float] = {name: _TABLES["data"][name] for name in ("r", "l", "EI", "EA", "rhoA")}
DATA["slider"] = _TABLES["data"]["slider_mass"]
SPEED = 150.0  # rad/s
OMEGA0_EXACT: float = _TABLES["omega0_exact_pinned"]
OMEGA0_TWO_ELEMENTS: float = _TABLES["omega0_two_element_consistent_mass"]
TRANSIENT_MAX: dict[float, float] = {
    ratio: _TABLES["transient"][str(ratio)]["max_abs"] for ratio in (0.01, 0.02)
}
TWO_ELEMENTS = {0.01: 0.013001, 0.02: 0.013016}  # largest |deflection| of the period, two elements
TWO_ELEMENTS_EXTREMES = {0.01: (0.012924, -0.013001), 0.02: (0.012873, -0.013016)}
TWO_ELEMENTS_SOURCE = (
    "two axially rigid beams without second-order terms, damping 2 zeta/832.5, five printed digits"
)

_SWEEPS = _TABLES["periodic_sweep_nonlinear"]
# Speed [rad/s], largest |deflection| over one period at 1 % and at 2 % damping, nonlinear.
SWEEP: tuple[tuple[float, float, float], ...] = tuple(
    (float(one["Omega"]), one["max_abs"], two["max_abs"])
    for one, two in zip(_SWEEPS["0.01"], _SWEEPS["0.02"], strict=True)
)
# Amplitudes of harmonics 0...6 at 150 rad/s and 2 % damping, nonlinear.
HARMONICS: tuple[float, ...] = tuple(
    next(row for row in _SWEEPS["0.02"] if row["Omega"] == SPEED)["harmonics_0_7"][:7]
)
