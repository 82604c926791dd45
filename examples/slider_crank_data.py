"""Published and reference numbers of the flexible slider-crank; SI units.

Data: Song and Haug (1980), as in the manual SPACAR95.  Deflections are of the rod's midpoint from the line through
its ends, left of crank pin to slider positive, over the rod's length.  Imports the standard library only.
"""

from __future__ import annotations

TALK = "Schwab, talk on SPACAR (2004), slides 23-30; data of Song and Haug (1980)"
EXACT = "(pi/l)^2 sqrt(EI/(rho A)), pinned rod, no shear, no rotary inertia"
TWO = "two cubic elements, consistent mass; 832 in the talk"
MODES = (
    "inextensible rod, 3 bending modes, simulated until periodic; the 5th mode, left out there, adds 0.03 %"
)
NOMINAL = "about the nominal motion, the two-element model of periodic_2pct_2el"
PAIRS = "[cosine, sine] of harmonics 0...6, t = 0 at the stretched dead centre"
TIMED = "200 speeds, linearized, 2 elements, 12 harmonics, building included; budget 2 s"
SPACE = "the same model in space, largest difference over the period"
TRANSIENT = "inextensible Euler-Bernoulli rod, bending modes converged, 0...0.1 s"

DATA = {
    "r": 0.15,  # crank [m]
    "l": 0.3,  # rod [m]
    "EI": 12.723450247038663,  # of the round rod, 6 mm [N m²]
    "EA": 5654866.776461627,  # [N]
    "rhoA": 0.22251900765376503,  # [kg/m]
    "slider": 0.033377851148064755,  # half the rod [kg]
}
SPEED = 150.0  # rad/s
OMEGA0_EXACT = 829.2321403788676
OMEGA0_TWO_ELEMENTS = 832.505036713729
TRANSIENT_MAX = {0.01: 0.015236234242091348, 0.02: 0.015087567451783416}
TWO_ELEMENTS = {0.01: 0.013001, 0.02: 0.013016}  # largest |deflection| of the period, two elements
TWO_ELEMENTS_EXTREMES = {0.01: (0.012924, -0.013001), 0.02: (0.012873, -0.013016)}
TWO_ELEMENTS_SOURCE = (
    "two axially rigid beams without second-order terms, damping 2 zeta/832.5, five printed digits"
)

# Speed [rad/s], largest |deflection| over one period at 1 % and at 2 % damping, nonlinear.
SWEEP = (
    (50.0, 0.0013598948541952414, 0.0013598929270176128),
    (75.0, 0.003057744307087506, 0.0030572868788006752),
    (100.0, 0.0054183613043602575, 0.005423830089650608),
    (125.0, 0.00848662603054469, 0.008505030889969574),
    (150.0, 0.012658627273215291, 0.01268163441749592),
    (160.0, 0.014340586294960456, 0.01435308825809761),
    (166.0, 0.0157131593316584, 0.01560289076458037),
    (170.0, 0.01667756836407755, 0.01663636220457417),
    (180.0, 0.019104591925960274, 0.01913405963990245),
    (190.0, 0.0226515279401224, 0.02263287384342144),
    (200.0, 0.03143467578070723, 0.030105807761576793),
    (205.0, 0.051529909963480135, 0.0375443611880033),
    (208.0, 0.03873767066358086, 0.0345161908950566),
    (212.0, 0.027550969696909285, 0.027884439274112882),
    (220.0, 0.023177104210710116, 0.023915992426048756),
    (240.0, 0.02951772763666523, 0.029635903615246022),
    (260.0, 0.04818206830690267, 0.047173135321242),
    (270.0, 0.07645149950510707, 0.07225477127687943),
    (276.0, 0.061805053924141214, 0.060603937257470604),
    (282.0, 0.05111679996039831, 0.0515103660164317),
    (290.0, 0.04465996770860716, 0.04546491712613886),
    (300.0, 0.04229541835887504, 0.042968808020180445),
)
# Amplitudes of harmonics 0...6 at 150 rad/s and 2 % damping, nonlinear.
HARMONICS = (
    7.267830322749608e-06,
    0.008074066041768626,
    0.0050220931765925575,
    0.0016328814923539925,
    0.0005377950564277443,
    0.00017071566079548622,
    0.0003701828515994079,
)
