"""Parameters that several elements share, each with its unit and meaning written once."""

from flexel.derive.declare import Parameter

L0 = Parameter("l0", 1, "m", "undeformed length")
RHOA = Parameter("rhoA", 1, "kg/m", "mass per length", sign="not negative")
RHOJ = Parameter(
    "rhoJ",
    3,
    "kg m",
    "mass moments of inertia per length about the axes of the section's triad",
    ("x", "y", "z"),
)
RHOIW = Parameter("rhoIw", 1, "kg m^3", "warping inertia per length, density times the warping constant")
MASS = Parameter("mass", 1, "kg", "mass", sign="not negative")
GRAVITY = Parameter("gravity", 3, "m/s^2", "acceleration of gravity", ("x", "y", "z"))
PLANAR_GRAVITY = Parameter("gravity", 2, "m/s^2", "acceleration of gravity", ("x", "y"))
TP = Parameter("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there")
TQ = Parameter("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there")
D0 = Parameter(
    "d0", 3, "m", "components of xq - xp on the triad at p when the deformations are zero", ("x", "y", "z")
)
EA = Parameter("EA", 1, "N", "axial stiffness", sign="positive")
EIY = Parameter("EIy", 1, "N m^2", "bending stiffness about y, of the deflection in z", sign="not negative")
EIZ = Parameter("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign="not negative")
GAY = Parameter(
    "GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign="positive"
)
GAZ = Parameter(
    "GAz", 1, "N", "shear stiffness k G A of the deflection in z; very large without shear", sign="positive"
)
