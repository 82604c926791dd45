"""Published numbers of the bicycle: parameters, linear equations, eigenvalues, and one nonlinear motion.

Symbols are those of the 2007 paper: rear wheel R, rear frame with rider B, front frame H, front wheel F; SI units;
axes x forward, y right, z down; w wheelbase, c trail, lam tilt of the steering axis.
Imports the standard library only.
"""

from __future__ import annotations

from math import hypot, pi

PAPER = "Meijaard, Papadopoulos, Ruina, Schwab (2007) Proc. R. Soc. A 463:1955-1982"
TALK = "Schwab, talk on SPACAR"
EXACT = "from the matrices of Meijaard et al. (2007) with 22 digits"
MEASURED_SOURCE = "BicycleParameters 1.5.2, closed-form matrices"
MANOEUVRE = "IFToMM benchmark M1, by Kane's equations at 1e-12"


def _table(text: str) -> dict[str, dict[str, float | None]]:
    """Rows by name, numbers by the names in the first line; ``-`` is None; ``_`` in a name is a space."""
    head, *rows = (line.split() for line in text.strip().splitlines())
    return {
        row[0].replace("_", " "): {
            key: None if number == "-" else float(number)
            for key, number in zip(head[1:], row[1:], strict=True)
        }
        for row in rows
    }


# The benchmark bicycle, exactly as in the paper's table of parameters.
BENCHMARK: dict[str, float] = {
    **{"w": 1.02, "c": 0.08, "lam": pi / 10, "g": 9.81},
    **{"rR": 0.3, "mR": 2, "IRxx": 0.0603, "IRyy": 0.12},
    **{"xB": 0.3, "zB": -0.9, "mB": 85, "IBxx": 9.2, "IBxz": 2.4, "IByy": 11, "IBzz": 2.8},
    **{"xH": 0.9, "zH": -0.7, "mH": 4, "IHxx": 0.05892, "IHxz": -0.00756, "IHyy": 0.06, "IHzz": 0.00708},
    **{"rF": 0.35, "mF": 3, "IFxx": 0.1405, "IFyy": 0.28},
}

# M q'' + v C1 q' + (g K0 + v² K2) q = 0 with q = (lean, steer); the digits as printed.
M = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]]
C1 = [[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]]
K0 = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]]
K2 = [[0, 76.59734589573222], [0, 2.65431523794604]]
WEAVE_SPEED = 4.29238253634111
CAPSIZE_SPEED = 6.02426201538837

# Eigenvalues [1/s] at v = 0, 1, ..., 10 m/s: sorted by real, then imaginary part; 15 digits.
_EIGENVALUES = """
-5.53094371765393 -3.13164324790656 3.13164324790656 5.53094371765393
-7.11008014637441 -3.13423125066578 3.52696170990069-0.80774027519931j 3.52696170990069+0.80774027519931j
-8.67387984831737 -3.07158645641514 2.68234517512745-1.68066296590676j 2.68234517512745+1.68066296590676j
-10.3510146724592 -2.63366137253665 1.70675605663974-2.31582447384324j 1.70675605663974+2.31582447384324j
-12.1586142657644 -1.42944427361326 0.413253315211241-3.07910818603205j 0.413253315211241+3.07910818603205j
-14.0783896927982 -0.775341882195842-4.46486771378822j -0.775341882195842+4.46486771378822j -0.322866429004087
-16.0853712309803 -1.52644486584142-5.87673060598708j -1.52644486584142+5.87673060598708j -0.00406690076970336
-18.157884661252 -2.13875644258363-7.19525913329804j -2.13875644258363+7.19525913329804j 0.102681705747664
-20.2794089439457 -2.69348683581095-8.46037971396934j -2.69348683581095+8.46037971396934j 0.14327879765713
-22.4378855904086 -3.21675402252491-9.69377351531782j -3.21675402252491+9.69377351531782j 0.157901840309173
-24.624596350174 -3.72016840437288-10.9068113947629j -3.72016840437288+10.9068113947629j 0.161053386531716
"""
EIGENVALUES = [[complex(z) for z in row.split()] for row in _EIGENVALUES.strip().splitlines()]

# Measured bicycles without rider: parameters, the speed above which the weave is stable, and the capsize speed.
_FRAMES = """
bicycle                  w     c      lam            xB    zB     mB   IBxx   IBxz    IByy   IBzz
Browser                  1.121 0.0686 0.399680398707 0.274 -0.538 9.9  0.5296 -0.1163 1.3164 0.7568
Browser_with_instruments 1.121 0.068  0.399680398707 0.217 -0.622 14.7 1.0451 -0.1123 2.403  1.8501
Crescendo                1.101 0.083  0.366519142919 0.312 -0.526 9.1  0.4997 -0.0148 1.1174 0.7393
Fisher                   1.07  0.072  0.329867228627 0.367 -0.499 4.5  0.2825 0.0559  0.4697 0.2677
Pista                    0.989 0.062  0.275762021815 0.383 -0.477 4.5  0.29   0.0502  0.4758 0.2494
Rigid_rider_bicycle      1.064 0.06   0.317489078499 0.335 -0.736 22.9 2.6375 0.6536  4.2768 1.9428
Silver                   1.01  0.19   0.366519143    0.32  -0.627 12.1 0.8155 0.0327  1.2    1.0825
Yellow                   1.089 0.0473 0.301941960595 0.422 -0.603 3.3  0.224  0.0182  0.3879 0.216
Yellow,_fork_reversed    0.985 0.18   0.338593874887 0.412 -0.618 3.3  0.2254 0.0179  0.3879 0.2147
"""
_FRONTS = """
bicycle                  xH    zH     mH  IHxx   IHxz    IHyy   IHzz
Browser                  0.867 -0.748 3.2 0.2534 -0.072  0.2458 0.0956
Browser_with_instruments 0.867 -0.747 3.2 0.2534 -0.072  0.2458 0.0956
Crescendo                0.907 -0.803 4.6 0.384  -0.0778 0.3631 0.1664
Fisher                   0.96  -0.719 2.5 0.1147 -0.0182 0.1    0.0226
Pista                    0.906 -0.733 2.3 0.098  -0.0044 0.0692 0.0396
Rigid_rider_bicycle      0.818 -0.986 5.4 0.3439 -0.0919 0.3399 0.1031
Silver                   0.907 -0.8   2.5 0.086  -0.0311 0.1    0.0169
Yellow                   0.948 -0.788 2.5 0.1452 -0.0194 0.12   0.0292
Yellow,_fork_reversed    0.919 -0.816 2.5 0.1475 -0.0172 0.1195 0.0294
"""
_WHEELS = """
bicycle                  rR    mR  IRxx   IRyy   rF    mF   IFxx   IFyy
Browser                  0.341 3.1 0.0904 0.1524 0.344 2.0  0.0884 0.1492
Browser_with_instruments 0.341 3.1 0.0904 0.1524 0.343 2.0  0.0884 0.1492
Crescendo                0.34  4.0 0.0966 0.1438 0.343 3.5  0.0954 0.1656
Fisher                   0.339 1.9 0.063  0.1008 0.33  1.5  0.0631 0.1062
Pista                    0.332 1.4 0.0552 0.0764 0.334 1.6  0.0553 0.1062
Rigid_rider_bicycle      0.333 4.9 0.0701 0.1293 0.336 1.6  0.0524 0.0984
Silver                   0.35  2.6 0.078  0.156  0.349 2.05 0.081  0.162
Yellow                   0.341 2.6 0.0877 0.1487 0.342 1.9  0.0852 0.1466
Yellow,_fork_reversed    0.341 2.6 0.0877 0.1487 0.342 1.9  0.0852 0.1466
"""
_SPEEDS = """
bicycle                  weave       capsize
Browser                  4.214729874 4.335837874
Browser_with_instruments 4.033419049 4.282374981
Crescendo                4.828600995 6.104112923
Fisher                   3.79806239  6.118969229
Pista                    3.669626073 5.505984847
Rigid_rider_bicycle      4.987137175 6.444039657
Silver                   3.988484049 7.871800842
Yellow                   3.485008415 4.716117671
Yellow,_fork_reversed    3.775263075 -
"""


def _measured(name: str) -> dict[str, float]:
    """Parameters of a measured bicycle, by the symbols of the benchmark.

    Some measured inertias are impossible by some per cent: with the principal moments I1 < I3 in the plane of
    symmetry, Iyy must lie from I3 - I1 to I3 + I1.  It is moved there; the linear equations do not contain it.
    """
    rows = (_table(part)[name] for part in (_FRAMES, _FRONTS, _WHEELS))
    p = {"g": 9.81} | {key: value for row in rows for key, value in row.items() if value is not None}
    for body in ("B", "H"):
        xx, yy, zz, xz = (p[f"I{body}{axes}"] for axes in ("xx", "yy", "zz", "xz"))
        p[f"I{body}yy"] = min(max(yy, hypot(xx - zz, 2 * xz)), xx + zz)
    return p


MEASURED = {name: _measured(name) for name in _table(_SPEEDS)}
MEASURED_SPEEDS = _table(_SPEEDS)

# The talk's own bicycle (Cornell, 1987): no parameters are public, only its stable range [m/s].
TALK_RANGE = (4.1, 5.7)

# Manoeuvre M1: rolling upright at 4 m/s with a roll rate of 0.05 rad/s about the ground line.
M1_SPEED = 4.0
ROLL_RATE = 0.05
M1_STEER_5S = 0.044960974038
M1_FORWARD_SPEED_5S = 3.993759015106
M1_ENERGY = 1575.1729024773813
# Rounded to 11 decimals; computed to about 1e-10.
_M1 = """
t lean.angle steer.angle yaw.angle lean.angle' steer.angle' rear_hub.x rear_hub.y
0.00  0.00000000000  0.00000000000  0.00000000000  0.05000000000  0.00000000000  0.00000000000 0.00000000000
0.25  0.01065924192  0.00993784275  0.00452825599  0.03089768039  0.05027751386  1.00002036002 0.00456787020
0.50  0.01374827152  0.01915086153  0.01942793349 -0.00820498636  0.01759740839  2.00010891470 0.01679825805
0.75  0.00650551958  0.01709838289  0.03721006401 -0.04774116332 -0.03478238055  2.99995085259 0.04318734062
1.00 -0.00812418394  0.00272210869  0.04618309586 -0.06361971609 -0.07565992859  3.99924091018 0.08167739891
1.25 -0.02203701749 -0.01736671201  0.03788046870 -0.04102585102 -0.07677636951  4.99854255642 0.12110862434
1.50 -0.02586817163 -0.03143615776  0.01310351445  0.01398376568 -0.02824654140  5.99866021137 0.14649461244
1.75 -0.01467238277 -0.02899300366 -0.01644847430  0.07315180165  0.04943190979  6.99915619304 0.14786972268
2.00  0.00795219661 -0.00787183204 -0.03332175650  0.09968811787  0.11330513856  7.99900525855 0.12801668882
2.25  0.03034204765  0.02285314024 -0.02418430117  0.06932213593  0.12026273812  8.99871628142 0.10355810957
2.50  0.03827145912  0.04579777457  0.01094905121 -0.01185526749  0.05144709822  9.99948873183 0.09760628968
2.75  0.02355006776  0.04453244049  0.05536809931 -0.10288527968 -0.06460107531 11.00011297296 0.12665788210
3.00 -0.00933568369  0.01487937711  0.08283630007 -0.14849542255 -0.16418451579 11.99830282985 0.18834495824
3.25 -0.04359642910 -0.03079130939  0.07238809681 -0.11033441633 -0.18328656485 12.99566229163 0.25922865966
3.50 -0.05774147490 -0.06691019943  0.02205554765  0.00688203395 -0.08704118926 13.99617686836 0.30498882799
3.75 -0.03847507844 -0.06793307068 -0.04465625283  0.14346689674  0.08362587710 14.99850681316 0.29925254219
4.00  0.00870542182 -0.02691284522 -0.08885904848  0.21756163974  0.23327279235 15.99727605067 0.24318760662
"""
_HEAD, *_ROWS = (line.split() for line in _M1.strip().splitlines())
M1_COLUMNS = [name.replace("_", " ") for name in _HEAD]
M1 = [[float(z) for z in row] for row in _ROWS]
