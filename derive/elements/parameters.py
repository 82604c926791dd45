"""Parameters that several elements share, each with its unit and meaning written once."""

from flexel.derive.declare import Parameter

L0 = Parameter("l0", 1, "m", "undeformed length")
RHOA = Parameter("rhoA", 1, "kg/m", "mass per length")
RHOJ = Parameter(
    "rhoJ",
    3,
    "kg m",
    "mass moments of inertia per length about the axes of the section's triad",
    ("x", "y", "z"),
)
RHOIW = Parameter("rhoIw", 1, "kg m^3", "warping inertia per length, density times the warping constant")
POLAR = Parameter("polar", 1, "m^2", "square of the polar radius of gyration of the section, (Iy + Iz)/A")
MASS = Parameter("mass", 1, "kg", "mass")
GRAVITY = Parameter("gravity", 3, "m/s^2", "acceleration of gravity", ("x", "y", "z"))
PLANAR_GRAVITY = Parameter("gravity", 2, "m/s^2", "acceleration of gravity", ("x", "y"))
TP = Parameter("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there")
TQ = Parameter("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there")
D0 = Parameter(
    "d0", 3, "m", "components of xq - xp on the triad at p when the deformations are zero", ("x", "y", "z")
)
PHI_Z = Parameter("phi_z", 1, "1", "shear number of the deflection in z, 12 E Iy/(k G A l0^2)")
PHI_Y = Parameter("phi_y", 1, "1", "shear number of the deflection in y, 12 E Iz/(k G A l0^2)")
