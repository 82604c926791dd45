"""The table of elements and laws.

Written by `flexel derive`; do not edit.
"""

from flexel.derive.spec import (
    ArgumentSpec,
    BeginSpec,
    DeformationSpec,
    ElementSpec,
    InternalSpec,
    KernelSpec,
    LawSpec,
    LimitSpec,
    NodeSpec,
    OutputSpec,
    ParameterSpec,
    SlipSpec,
    TermSpec,
)

ELEMENTS: dict[str, ElementSpec] = {
    # element point_mass
    "point_mass": ElementSpec(
        name="point_mass",
        digest="c6e6cd112ed8b5ef",
        doc="T = mass v.v/2\nU = -mass gravity.x\nplace: x",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
        ),
        parameters=(
            ParameterSpec("mass", 1, "kg", "mass", sign=("not negative",)),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(),
        slips=(),
        kernels={
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (3, 3), (0, 4, 8)),
                    OutputSpec("h", (3,), ()),
                    OutputSpec("f", (3,), (0, 1, 2)),
                    OutputSpec("U", (1,), (0,)),
                ),
                10,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (3, 3), ()),
                    OutputSpec("R_v", (3, 3), ()),
                ),
                0,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m", draws="mass"),
                ),
                0,
            ),
        },
        family="body",
    ),
    # element body
    "body": ElementSpec(
        name="body",
        digest="5408c8c5f0201fbb",
        doc="vc = xdot + d(R(lambda) c)/dt, velocity of the mass centre\nw = 2 (conj(lambda) o lambdadot), angular velocity in body axes\nT = mass vc.vc/2 + w.J w/2\nU = -mass gravity.(x + R(lambda) c)\ncentre: x + R(lambda) c\norigin: x, axes: columns of R(lambda) in rows: the frame that carries what a picture shows",
        source="Schwab and Meijaard 2006, DETC2006-99307",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("mass", 1, "kg", "mass", sign=("not negative",)),
            ParameterSpec("c", 3, "m", "offset of the mass centre from p in body axes"),
            ParameterSpec("J", 6, "kg m^2", "inertia tensor about the mass centre in body axes (tensor components)"),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(),
        slips=(),
        kernels={
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (7, 7), (0, 3, 4, 5, 6, 8, 10, 11, 12, 13, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48)),
                    OutputSpec("h", (7,), tuple(range(7))),
                    OutputSpec("f", (7,), tuple(range(7))),
                    OutputSpec("U", (1,), (0,)),
                ),
                702,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (7, 7), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41, 45, 46, 47, 48)),
                    OutputSpec("R_v", (7, 7), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 21, 22, 24, 25, 26, 27, 28, 29, 31, 32, 33, 34, 35, 36, 38, 39, 40, 41, 42, 43, 45, 46, 47, 48)),
                ),
                1337,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("centre", (3,), (0, 1, 2), unit="m", draws="mass"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                52,
            ),
        },
        family="body",
        picture="body",
    ),
    # element rotary_inertia
    "rotary_inertia": ElementSpec(
        name="rotary_inertia",
        digest="6ef75d325a937985",
        doc="w = 2 (conj(lambda) o lambdadot), angular velocity in body axes\nT = w.J w/2",
        source="Schwab and Meijaard 2006, DETC2006-99307",
        nodes=(
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("J", 6, "kg m^2", "inertia tensor in body axes (tensor components)"),
        ),
        deformations=(),
        slips=(),
        kernels={
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (4, 4), tuple(range(16))),
                    OutputSpec("h", (4,), (0, 1, 2, 3)),
                    OutputSpec("f", (4,), ()),
                    OutputSpec("U", (1,), ()),
                ),
                281,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (4, 4), tuple(range(16))),
                    OutputSpec("R_v", (4, 4), tuple(range(16))),
                ),
                536,
            ),
        },
        family="body",
    ),
    # element warping_inertia
    "warping_inertia": ElementSpec(
        name="warping_inertia",
        digest="38325bf076bf00d3",
        doc="w: twist per length\nT = J wdot^2/2",
        source="Vlasov 1961, Thin-walled elastic beams",
        nodes=(
            NodeSpec("w", "warping"),
        ),
        parameters=(
            ParameterSpec("J", 1, "kg m^4", "moment of inertia of warping: density times warping constant times length"),
        ),
        deformations=(),
        slips=(),
        kernels={
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (1, 1), (0,)),
                    OutputSpec("h", (1,), ()),
                    OutputSpec("f", (1,), ()),
                    OutputSpec("U", (1,), ()),
                ),
                0,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (1, 1), ()),
                    OutputSpec("R_v", (1, 1), ()),
                ),
                0,
            ),
        },
    ),
    # element norm
    "norm": ElementSpec(
        name="norm",
        digest="7a229f46635c78bf",
        doc="norm = lambda.lambda - 1",
        source="Schwab and Meijaard 2006, DETC2006-99307",
        nodes=(
            NodeSpec("r", "frame"),
        ),
        parameters=(),
        deformations=(
            DeformationSpec("norm", "1", False, kind="norm"),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 4), (0, 1, 2, 3)),
                    OutputSpec("V", (0, 4), ()),
                ),
                12,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                8,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 4), (0, 1, 2, 3)),
                ),
                4,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 4), (0, 1, 2, 3)),
                    OutputSpec("Psi_v", (1, 4), (0, 1, 2, 3)),
                ),
                8,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (4, 4), (0, 5, 10, 15)),
                ),
                1,
            ),
        },
        family="norm",
    ),
    # element truss
    "truss": ElementSpec(
        name="truss",
        digest="1e9195dd3cf86bd4",
        doc="elongation = |xq - xp| - l0\nT = rhoA l0/6 (vp.vp + vp.vq + vq.vq), uniform bar\nU = -rhoA l0 gravity.(xp + xq)/2",
        source="van der Werff and Jonker 1984, NATO ASI F9, p. 381",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("q", "point"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 6), tuple(range(6))),
                    OutputSpec("V", (0, 6), ()),
                ),
                17,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                28,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 6), tuple(range(6))),
                ),
                33,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 6), tuple(range(6))),
                    OutputSpec("Psi_v", (1, 6), tuple(range(6))),
                ),
                85,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), tuple(range(36))),
                ),
                30,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (6, 6), (0, 3, 7, 10, 14, 17, 18, 21, 25, 28, 32, 35)),
                    OutputSpec("h", (6,), ()),
                    OutputSpec("f", (6,), tuple(range(6))),
                    OutputSpec("U", (1,), (0,)),
                ),
                20,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (6, 6), ()),
                    OutputSpec("R_v", (6, 6), ()),
                ),
                0,
            ),
        },
        family="truss",
        picture="bar",
        span="bar_span",
    ),
    # element hinge
    "hinge": ElementSpec(
        name="hinge",
        digest="4d8322c15bd8f0fd",
        doc="triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq\nc = conj(u_p) o u_q\nangle = 2 atan2(c1, c0), period 2 pi\nbend1 = ez_p.ex_q,  bend2 = -ey_p.ex_q\naxes: ex_p, ey_p, ez_p in rows",
        source="van der Werff and Jonker 1984; SPACAR95 manual (Schwab and Meijaard 2000), HINGE",
        nodes=(
            NodeSpec("p", "frame"),
            NodeSpec("q", "frame"),
        ),
        parameters=(
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
        ),
        deformations=(
            DeformationSpec("angle", "rad", True, period=(TermSpec(6.283185307179586),)),
            DeformationSpec("bend1", "1", False),
            DeformationSpec("bend2", "1", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (3,), (0, 1, 2)),
                    OutputSpec("De", (3, 8), tuple(range(24))),
                    OutputSpec("V", (0, 8), ()),
                ),
                412,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (3,), (0, 1, 2)),
                    OutputSpec("gs", (0,), ()),
                ),
                371,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 8), tuple(range(24))),
                ),
                654,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 8), tuple(range(24))),
                    OutputSpec("Psi_v", (3, 8), tuple(range(24))),
                ),
                1443,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (8, 8), tuple(range(64))),
                ),
                1035,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                59,
            ),
        },
        family="hinge",
        picture="hinge",
    ),
    # element bearing
    "bearing": ElementSpec(
        name="bearing",
        digest="5383bbccd03488ff",
        doc="triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq\nc = conj(u_p) o u_q\nangle = 2 atan2(c1, c0), period 2 pi\nbend1 = ez_p.ex_q,  bend2 = -ey_p.ex_q\nd = xq - xp\n(axial, radial1, radial2) = R(u_p)' d - d0\naxes: the directions in rows;  displacement: the deformations that are lengths",
        source="SPACAR95 manual (Schwab and Meijaard 2000), BEARING",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
        ),
        parameters=(
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
            ParameterSpec("d0", 3, "m", "components of xq - xp on the triad at p when the deformations are zero"),
        ),
        deformations=(
            DeformationSpec("angle", "rad", True, period=(TermSpec(6.283185307179586),)),
            DeformationSpec("bend1", "1", False),
            DeformationSpec("bend2", "1", False),
            DeformationSpec("axial", "m", False),
            DeformationSpec("radial1", "m", False),
            DeformationSpec("radial2", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (6,), tuple(range(6))),
                    OutputSpec("De", (6, 14), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79)),
                    OutputSpec("V", (0, 14), ()),
                ),
                536,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (6,), tuple(range(6))),
                    OutputSpec("gs", (0,), ()),
                ),
                430,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (6, 14), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79)),
                ),
                788,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (6, 14), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79)),
                    OutputSpec("Psi_v", (6, 14), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79)),
                ),
                1814,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), (3, 4, 5, 6, 17, 18, 19, 20, 31, 32, 33, 34, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 101, 102, 103, 104, 115, 116, 117, 118, 129, 130, 131, 132, 143, 144, 145, 146, 150, 151, 152, 153, 157, 158, 159, 160, 164, 165, 166, 167, 171, 172, 173, 174, 178, 179, 180, 181, 185, 186, 187, 188, 192, 193, 194, 195)),
                ),
                1150,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                    OutputSpec("displacement", (3,), (0, 1, 2), unit="m"),
                ),
                83,
            ),
        },
        family="bearing",
        picture="bearing",
    ),
    # element beam3
    "beam3": ElementSpec(
        name="beam3",
        digest="3f244ff3836b191b",
        doc="triad ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp; d = xq - xp\n(along, across1, across2) = R(u_p)' d - d0\nw_p = angular velocity of the triad, in its own axes\nT = rhoA l0/6 (vp.vp + vp.vq + vq.vq) + l0/2 sum rhoJ_i w_i^2, uniform bar\nU = -rhoA l0 gravity.(xp + xq)/2\naxes: the directions in rows;  displacement: the deformations that are lengths",
        source="Meijaard, Papadopoulos, Ruina and Schwab 2007, supplement, PINBODY; UT SPACAR, RBEAM",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
        ),
        parameters=(
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("d0", 3, "m", "components of xq - xp on the triad at p when the deformations are zero"),
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 3, "kg m", "mass moments of inertia per length about the axes of the section's triad"),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("along", "m", False),
            DeformationSpec("across1", "m", False),
            DeformationSpec("across2", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (3,), (0, 1, 2)),
                    OutputSpec("De", (3, 10), tuple(range(30))),
                    OutputSpec("V", (0, 10), ()),
                ),
                172,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (3,), (0, 1, 2)),
                    OutputSpec("gs", (0,), ()),
                ),
                183,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 10), tuple(range(30))),
                ),
                225,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 10), tuple(range(30))),
                    OutputSpec("Psi_v", (3, 10), tuple(range(30))),
                ),
                494,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), (3, 4, 5, 6, 13, 14, 15, 16, 23, 24, 25, 26, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 73, 74, 75, 76, 83, 84, 85, 86, 93, 94, 95, 96)),
                ),
                328,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (10, 10), (0, 7, 11, 18, 22, 29, 33, 34, 35, 36, 43, 44, 45, 46, 53, 54, 55, 56, 63, 64, 65, 66, 70, 77, 81, 88, 92, 99)),
                    OutputSpec("h", (10,), (3, 4, 5, 6)),
                    OutputSpec("f", (10,), (0, 1, 2, 7, 8, 9)),
                    OutputSpec("U", (1,), (0,)),
                ),
                410,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (10, 10), (33, 34, 35, 36, 43, 44, 45, 46, 53, 54, 55, 56, 63, 64, 65, 66)),
                    OutputSpec("R_v", (10, 10), (33, 34, 35, 36, 43, 44, 45, 46, 53, 54, 55, 56, 63, 64, 65, 66)),
                ),
                845,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                    OutputSpec("displacement", (3,), (0, 1, 2), unit="m"),
                ),
                83,
            ),
        },
        family="link",
        picture="bar",
        span="bar_span",
        arm=True,
    ),
    # element beam
    "beam": ElementSpec(
        name="beam",
        digest="b7d8742567cf4a9d",
        doc="triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq\nd = xq - xp, l = |d|, el = d/l\nb1 = l - l0                 b2 = l0 (ez_p.ey_q - ey_p.ez_q)/2\nb3 = -l0 ez_p.el            b4 = l0 ez_q.el\nb5 = l0 ey_p.el             b6 = -l0 ey_q.el\nelongation = b1 + (2 b3^2 + b3 b4 + 2 b4^2 + 2 b5^2 + b5 b6 + 2 b6^2)/(30 l0)\ntorsion = b2 + (b4 b5 - b3 b6)/l0\nbend1, bend2 = b3 + k, b4 - k with k = b2 (b5 + b6)/(6 l0)\nbend3, bend4 = b5 - h, b6 + h with h = b2 (b3 + b4)/(6 l0)\nphi_y = 12 EIz/(GAy l0^2), phi_z = 12 EIy/(GAz l0^2): shear numbers of the deflections in y and z\nT: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with\n   the shear-corrected (phi_y, phi_z) cubic shapes, torsion linear; w_p, w_q angular velocities in the triads\nU = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)\nf = De'sigma: force_p, moment_p = -(R(u_p)'f_xp, L(u_p) (f_lambda_p o tp)/2), force_q, moment_q the same at q, without\n   the minus\naxis: places on the cubic axis; across: ey_p, ey_q\nshear_angle = |(phi_z/(1 + phi_z) (bend1 - bend2), phi_y/(1 + phi_y) (bend3 - bend4))|/(2 l0)\nranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; twist = angle with the sine\n   (ez_p.ey_q - ey_p.ez_q)/2 and the cosine (ey_p.ey_q + ez_p.ez_q)/2, 1 - sin(2 twist)/(2 twist);\n   shear_angle, sin(shear_angle)^2",
        source="Meijaard 1996, Nonlinear Dyn. 9; Jonker and Meijaard 2013, Int. J. Non-Linear Mech. 53; Przemieniecki 1968 (mass with rotary inertia)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 3, "kg m", "mass moments of inertia per length about the axes of the section's triad"),
            ParameterSpec("EIy", 1, "N m^2", "bending stiffness about y, of the deflection in z", sign=("not negative",)),
            ParameterSpec("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign=("not negative",)),
            ParameterSpec("GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign=("positive",)),
            ParameterSpec("GAz", 1, "N", "shear stiffness k G A of the deflection in z; very large without shear", sign=("positive",)),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
            DeformationSpec("torsion", "m", False),
            DeformationSpec("bend1", "m", False),
            DeformationSpec("bend2", "m", False),
            DeformationSpec("bend3", "m", False),
            DeformationSpec("bend4", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (6,), tuple(range(6))),
                    OutputSpec("De", (6, 14), tuple(range(84))),
                    OutputSpec("V", (0, 14), ()),
                ),
                870,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (6,), tuple(range(6))),
                    OutputSpec("gs", (0,), ()),
                ),
                659,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (6, 14), tuple(range(84))),
                ),
                1891,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (6, 14), tuple(range(84))),
                    OutputSpec("Psi_v", (6, 14), tuple(range(84))),
                ),
                4947,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), tuple(range(196))),
                ),
                2735,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (14, 14), tuple(range(196))),
                    OutputSpec("h", (14,), tuple(range(14))),
                    OutputSpec("f", (14,), tuple(range(14))),
                    OutputSpec("U", (1,), (0,)),
                ),
                2465,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (14, 14), tuple(range(196))),
                    OutputSpec("R_v", (14, 14), tuple(range(196))),
                ),
                10175,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force_p", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_p", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("force_q", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_q", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("shear_angle", (1,), (0,), unit="rad"),
                    OutputSpec("bend_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is bent by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("twist_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is twisted by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("shear_range", (2,), (0, 1), unit="°", limit=5.73, beyond="is sheared by {value:.1f}°{where}: its moments are about {digits} % too small, whatever the number of elements; use rotations='logarithmic'"),
                    OutputSpec("axis", (17, 3), tuple(range(51)), unit="m", draws="beam"),
                    OutputSpec("across", (2, 3), tuple(range(6)), unit="1"),
                ),
                1075,
            ),
        },
        family="beam",
        picture="beam",
        span="beam_span",
        arm=True,
    ),
    # element beam_first_order
    "beam_first_order": ElementSpec(
        name="beam_first_order",
        digest="876d9460f3fd1287",
        doc="triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq\nd = xq - xp, l = |d|, el = d/l\nb1 = l - l0                 b2 = l0 (ez_p.ey_q - ey_p.ez_q)/2\nb3 = -l0 ez_p.el            b4 = l0 ez_q.el\nb5 = l0 ey_p.el             b6 = -l0 ey_q.el\nelongation, torsion, bend1, bend2, bend3, bend4 = b1, b2, b3, b4, b5, b6\nphi_y = 12 EIz/(GAy l0^2), phi_z = 12 EIy/(GAz l0^2): shear numbers of the deflections in y and z\nT: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with\n   the shear-corrected (phi_y, phi_z) cubic shapes, torsion linear; w_p, w_q angular velocities in the triads\nU = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)\nf = De'sigma: force_p, moment_p = -(R(u_p)'f_xp, L(u_p) (f_lambda_p o tp)/2), force_q, moment_q the same at q, without\n   the minus\naxis: places on the cubic axis; across: ey_p, ey_q\nshear_angle = |(phi_z/(1 + phi_z) (bend1 - bend2), phi_y/(1 + phi_y) (bend3 - bend4))|/(2 l0)\nranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; twist = angle with the sine\n   (ez_p.ey_q - ey_p.ez_q)/2 and the cosine (ey_p.ey_q + ez_p.ez_q)/2, 1 - sin(2 twist)/(2 twist);\n   shear_angle, sin(shear_angle)^2",
        source="Meijaard 1996, Nonlinear Dyn. 9; Jonker and Meijaard 2013, Int. J. Non-Linear Mech. 53; Przemieniecki 1968 (mass with rotary inertia)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 3, "kg m", "mass moments of inertia per length about the axes of the section's triad"),
            ParameterSpec("EIy", 1, "N m^2", "bending stiffness about y, of the deflection in z", sign=("not negative",)),
            ParameterSpec("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign=("not negative",)),
            ParameterSpec("GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign=("positive",)),
            ParameterSpec("GAz", 1, "N", "shear stiffness k G A of the deflection in z; very large without shear", sign=("positive",)),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
            DeformationSpec("torsion", "m", False),
            DeformationSpec("bend1", "m", False),
            DeformationSpec("bend2", "m", False),
            DeformationSpec("bend3", "m", False),
            DeformationSpec("bend4", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (6,), tuple(range(6))),
                    OutputSpec("De", (6, 14), (0, 1, 2, 7, 8, 9, 17, 18, 19, 20, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 42, 43, 44, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 77, 78, 79, 80, 81, 82, 83)),
                    OutputSpec("V", (0, 14), ()),
                ),
                551,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (6,), tuple(range(6))),
                    OutputSpec("gs", (0,), ()),
                ),
                493,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (6, 14), (0, 1, 2, 7, 8, 9, 17, 18, 19, 20, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 42, 43, 44, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 77, 78, 79, 80, 81, 82, 83)),
                ),
                903,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (6, 14), (0, 1, 2, 7, 8, 9, 17, 18, 19, 20, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 42, 43, 44, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 77, 78, 79, 80, 81, 82, 83)),
                    OutputSpec("Psi_v", (6, 14), (0, 1, 2, 7, 8, 9, 17, 18, 19, 20, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 42, 43, 44, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 70, 71, 72, 77, 78, 79, 80, 81, 82, 83)),
                ),
                2333,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), tuple(range(196))),
                ),
                1313,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (14, 14), tuple(range(196))),
                    OutputSpec("h", (14,), tuple(range(14))),
                    OutputSpec("f", (14,), tuple(range(14))),
                    OutputSpec("U", (1,), (0,)),
                ),
                2465,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (14, 14), tuple(range(196))),
                    OutputSpec("R_v", (14, 14), tuple(range(196))),
                ),
                10175,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force_p", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_p", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("force_q", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_q", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("shear_angle", (1,), (0,), unit="rad"),
                    OutputSpec("bend_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is bent by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("twist_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is twisted by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("shear_range", (2,), (0, 1), unit="°", limit=5.73, beyond="is sheared by {value:.1f}°{where}: its moments are about {digits} % too small, whatever the number of elements; use rotations='logarithmic'"),
                    OutputSpec("axis", (17, 3), tuple(range(51)), unit="m", draws="beam"),
                    OutputSpec("across", (2, 3), tuple(range(6)), unit="1"),
                ),
                984,
            ),
        },
        family="beam",
        picture="beam",
        span="beam_span",
        arm=True,
    ),
    # element beam_warping
    "beam_warping": ElementSpec(
        name="beam_warping",
        digest="283cd0a0c21c87b1",
        doc="triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq\nd = xq - xp, l = |d|, el = d/l\nb1 = l - l0                 b2 = l0 (ez_p.ey_q - ey_p.ez_q)/2\nb3 = -l0 ez_p.el            b4 = l0 ez_q.el\nb5 = l0 ey_p.el             b6 = -l0 ey_q.el\nphi_y = 12 EIz/(GAy l0^2), phi_z = 12 EIy/(GAz l0^2): shear numbers of the deflections in y and z\npolar = (EIy + EIz)/EA: square of the polar radius of gyration of the section\nb7 = l0^2 wp - b2           b8 = l0^2 wq - b2           (wp, wq: twist per length at the ends)\nelongation = b1 + (2 b3^2 + b3 b4 + 2 b4^2 + 2 b5^2 + b5 b6 + 2 b6^2)/(30 l0)\n             + polar/(2 l0^3) (b2^2 + (2 b7^2 - b7 b8 + 2 b8^2)/15)\ntorsion = b2 + (b4 b5 - b3 b6)/l0\nbend1 = b3 + k + (3 b5 b7 - (b5 + b6) b8)/(30 l0)    with k = b2 (b5 + b6)/(6 l0)\nbend2 = b4 - k + ((b5 + b6) b7 - 3 b6 b8)/(30 l0)\nbend3 = b5 - h - (3 b3 b7 - (b3 + b4) b8)/(30 l0)    with h = b2 (b3 + b4)/(6 l0)\nbend4 = b6 + h - ((b3 + b4) b7 - 3 b4 b8)/(30 l0)\nwarp1 = l0^2 wp - torsion   warp2 = l0^2 wq - torsion: zero in uniform torsion\nthe angle of twist is cubic with the ends' twist per length; the strain energy of torsion, from the beam's laws, is\n    GJ/(2 l0^3) (torsion^2 + (2 warp1^2 - warp1 warp2 + 2 warp2^2)/15)\n    + 2 E Iw/l0^5 (warp1^2 + warp1 warp2 + warp2^2)\nT: as the beam, its twist cubic with the rates of wp, wq, plus rhoIw/2 times the integral of the square of the\n   rate of twist per length\nU = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)\nf = De'sigma: force_p, moment_p = -(R(u_p)'f_xp, L(u_p) (f_lambda_p o tp)/2), force_q, moment_q the same at q, without\n   the minus\naxis: places on the cubic axis; across: ey_p, ey_q\nbimoment_p = -f_wp, bimoment_q = f_wq\nshear_angle = |(phi_z/(1 + phi_z) (bend1 - bend2), phi_y/(1 + phi_y) (bend3 - bend4))|/(2 l0)\nranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; twist = angle with the sine\n   (ez_p.ey_q - ey_p.ez_q)/2 and the cosine (ey_p.ey_q + ez_p.ez_q)/2, 1 - sin(2 twist)/(2 twist);\n   shear_angle, sin(shear_angle)^2",
        source="Vlasov 1961, Thin-walled elastic beams; Wagner 1929 (twist and axial force); Jonker 2021 (warping coordinates)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
            NodeSpec("wp", "warping"),
            NodeSpec("wq", "warping"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 3, "kg m", "mass moments of inertia per length about the axes of the section's triad"),
            ParameterSpec("rhoIw", 1, "kg m^3", "warping inertia per length, density times the warping constant"),
            ParameterSpec("EA", 1, "N", "axial stiffness", sign=("positive",)),
            ParameterSpec("EIy", 1, "N m^2", "bending stiffness about y, of the deflection in z", sign=("not negative",)),
            ParameterSpec("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign=("not negative",)),
            ParameterSpec("GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign=("positive",)),
            ParameterSpec("GAz", 1, "N", "shear stiffness k G A of the deflection in z; very large without shear", sign=("positive",)),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
            DeformationSpec("torsion", "m", False),
            DeformationSpec("bend1", "m", False),
            DeformationSpec("bend2", "m", False),
            DeformationSpec("bend3", "m", False),
            DeformationSpec("bend4", "m", False),
            DeformationSpec("warp1", "m", False),
            DeformationSpec("warp2", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (8,), tuple(range(8))),
                    OutputSpec("De", (8, 16), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 127)),
                    OutputSpec("V", (0, 16), ()),
                ),
                1052,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (8,), tuple(range(8))),
                    OutputSpec("gs", (0,), ()),
                ),
                773,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (8, 16), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125)),
                ),
                2157,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (8, 16), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125)),
                    OutputSpec("Psi_v", (8, 16), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125)),
                ),
                5867,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (16, 16), tuple(range(256))),
                ),
                3188,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (16, 16), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 144, 145, 146, 147, 148, 149, 150, 151, 152, 153, 154, 155, 156, 157, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169, 170, 171, 172, 173, 174, 175, 176, 177, 178, 179, 180, 181, 182, 183, 184, 185, 186, 187, 188, 189, 190, 191, 192, 193, 194, 195, 196, 197, 198, 199, 200, 201, 202, 203, 204, 205, 206, 207, 208, 209, 210, 211, 212, 213, 214, 215, 216, 217, 218, 219, 220, 221, 222, 223, 227, 228, 229, 230, 234, 235, 236, 237, 238, 239, 243, 244, 245, 246, 250, 251, 252, 253, 254, 255)),
                    OutputSpec("h", (16,), tuple(range(16))),
                    OutputSpec("f", (16,), tuple(range(14))),
                    OutputSpec("U", (1,), (0,)),
                ),
                2642,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (16, 16), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 144, 145, 146, 147, 148, 149, 150, 151, 152, 153, 154, 155, 156, 157, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169, 170, 171, 172, 173, 176, 177, 178, 179, 180, 181, 182, 183, 184, 185, 186, 187, 188, 189, 192, 193, 194, 195, 196, 197, 198, 199, 200, 201, 202, 203, 204, 205, 208, 209, 210, 211, 212, 213, 214, 215, 216, 217, 218, 219, 220, 221, 227, 228, 229, 230, 234, 235, 236, 237, 243, 244, 245, 246, 250, 251, 252, 253)),
                    OutputSpec("R_v", (16, 16), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 144, 145, 146, 147, 148, 149, 150, 151, 152, 153, 154, 155, 156, 157, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169, 170, 171, 172, 173, 174, 175, 176, 177, 178, 179, 180, 181, 182, 183, 184, 185, 186, 187, 188, 189, 190, 191, 192, 193, 194, 195, 196, 197, 198, 199, 200, 201, 202, 203, 204, 205, 206, 207, 208, 209, 210, 211, 212, 213, 214, 215, 216, 217, 218, 219, 220, 221, 222, 223)),
                ),
                10640,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force_p", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_p", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("bimoment_p", (1,), (0,), unit="N m^2"),
                    OutputSpec("force_q", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_q", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("bimoment_q", (1,), (0,), unit="N m^2"),
                    OutputSpec("shear_angle", (1,), (0,), unit="rad"),
                    OutputSpec("bend_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is bent by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("twist_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is twisted by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("shear_range", (2,), (0, 1), unit="°", limit=5.73, beyond="is sheared by {value:.1f}°{where}: its moments are about {digits} % too small, whatever the number of elements; use rotations='logarithmic'"),
                    OutputSpec("axis", (17, 3), tuple(range(51)), unit="m", draws="beam"),
                    OutputSpec("across", (2, 3), tuple(range(6)), unit="1"),
                ),
                1168,
            ),
        },
        family="beam",
        picture="beam",
        span="beam_span",
        arm=True,
    ),
    # element beam_logarithmic
    "beam_logarithmic": ElementSpec(
        name="beam_logarithmic",
        digest="689da5880db845bf",
        doc="triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq\nturn: rotation vector of R(u_p)'R(u_q), below half a turn; R_m = R(u_p) exp(turn/2), the triad halfway\nphi_y = 12 EIz/(GAy l0^2), phi_z = 12 EIy/(GAz l0^2): shear numbers of the deflections in y and z\ns = 1/24 - turn.turn/1920 + (turn.turn)^2/322560\nstraight = R_m'(xq - xp) - l0 s turn x (turn x (1, 0, 0)): the chord without what uniform strains do to it\nbow_z = straight_y/(phi_y l0 + |straight|),  bow_y = -straight_z/(phi_z l0 + |straight|):\n    mean angles of the sections about z and y from the triad halfway; the shear angles are phi_y bow_z, -phi_z bow_y\nbent = turn + turn x (0, bow_y, bow_z)\nelongation = straight_x + l0 ((3/5 + phi_z) bow_y^2 + (3/5 + phi_y) bow_z^2) - l0\ntorsion = l0 bent_x\nbend1, bend2 = l0 (bent_y/2 + (1 + phi_z) bow_y), l0 (bent_y/2 - (1 + phi_z) bow_y)\nbend3, bend4 = l0 (bent_z/2 + (1 + phi_y) bow_z), l0 (bent_z/2 - (1 + phi_y) bow_z)\nT: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with\n   the shear-corrected (phi_y, phi_z) cubic shapes, torsion linear; w_p, w_q angular velocities in the triads\nU = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)\nf = De'sigma: force_p, moment_p = -(R(u_p)'f_xp, L(u_p) (f_lambda_p o tp)/2), force_q, moment_q the same at q, without\n   the minus\naxis: places on the cubic axis; across: ey_p, ey_q",
        source="Simo 1985, Comput. Methods Appl. Mech. Eng. 49 (strains of a rod); Crisfield 1990 (triad halfway)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 3, "kg m", "mass moments of inertia per length about the axes of the section's triad"),
            ParameterSpec("EIy", 1, "N m^2", "bending stiffness about y, of the deflection in z", sign=("not negative",)),
            ParameterSpec("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign=("not negative",)),
            ParameterSpec("GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign=("positive",)),
            ParameterSpec("GAz", 1, "N", "shear stiffness k G A of the deflection in z; very large without shear", sign=("positive",)),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
            DeformationSpec("torsion", "m", False),
            DeformationSpec("bend1", "m", False),
            DeformationSpec("bend2", "m", False),
            DeformationSpec("bend3", "m", False),
            DeformationSpec("bend4", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (6,), tuple(range(6))),
                    OutputSpec("De", (6, 14), tuple(range(84))),
                    OutputSpec("V", (0, 14), ()),
                ),
                2255,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (6,), tuple(range(6))),
                    OutputSpec("gs", (0,), ()),
                ),
                1237,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (6, 14), tuple(range(84))),
                ),
                5595,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (6, 14), tuple(range(84))),
                    OutputSpec("Psi_v", (6, 14), tuple(range(84))),
                ),
                17638,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), tuple(range(196))),
                ),
                6124,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (14, 14), tuple(range(196))),
                    OutputSpec("h", (14,), tuple(range(14))),
                    OutputSpec("f", (14,), tuple(range(14))),
                    OutputSpec("U", (1,), (0,)),
                ),
                2451,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (14, 14), tuple(range(196))),
                    OutputSpec("R_v", (14, 14), tuple(range(196))),
                ),
                10161,
            ),
            "outputs": KernelSpec(
                ("x", "e", "sigma", "tau", "p"),
                (
                    OutputSpec("force_p", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_p", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("force_q", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("moment_q", (3,), (0, 1, 2), unit="N m"),
                    OutputSpec("turn_range", (2,), (0, 1), unit="°", limit=150.0, beyond="has ends that are turned by {value:.0f}° relative to one another{where}; this may be {error:.0f}° the other way, since only angles below 180° are known within one element: use two elements in place of each"),
                    OutputSpec("axis", (17, 3), tuple(range(51)), unit="m", draws="beam"),
                    OutputSpec("across", (2, 3), tuple(range(6)), unit="1"),
                ),
                1258,
            ),
        },
        family="beam",
        picture="beam",
        span="beam_span",
        arm=True,
    ),
    # element wheel
    "wheel": ElementSpec(
        name="wheel",
        digest="605f1285860eecf4",
        doc="w hub, c contact point, d = xc - xw, a = R(lambda) axle, n = normal, ra = d x a\nradius = (d.d - R^2)/(2 R),  plane = a.d,  surface = n.xc - height,  lowest = n.ra\nomega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x d, the material point in contact\nlongitudinal = ra.vc/|ra|,  lateral = (n x ra).vc/|n x ra|,  spin = omega.n\nforce: of the road on hub and contact point\norigin: xw, axes: columns of R(lambda) in rows: the frame that carries what a picture shows",
        source="Meijaard, Papadopoulos, Ruina and Schwab 2007, Proc. R. Soc. A 463:1955, supplement, WHEEL",
        nodes=(
            NodeSpec("w", "point"),
            NodeSpec("r", "frame"),
            NodeSpec("c", "point"),
        ),
        parameters=(
            ParameterSpec("radius", 1, "m", "radius of the rim"),
            ParameterSpec("axle", 3, "1", "unit vector along the axle in body axes"),
            ParameterSpec("normal", 3, "1", "unit normal of the road"),
            ParameterSpec("height", 1, "m", "distance of the road from the origin along its normal"),
        ),
        deformations=(
            DeformationSpec("radius", "m", False),
            DeformationSpec("plane", "m", False),
            DeformationSpec("surface", "m", False, kind="touch"),
            DeformationSpec("lowest", "m", False),
        ),
        slips=(
            SlipSpec("longitudinal", "m/s", False),
            SlipSpec("lateral", "m/s", False),
            SlipSpec("spin", "rad/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (4,), (0, 1, 2, 3)),
                    OutputSpec("De", (4, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39)),
                    OutputSpec("V", (3, 10), (0, 1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15, 16, 23, 24, 25, 26)),
                ),
                319,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (4,), (0, 1, 3)),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                385,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (7, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 63, 64, 65, 66)),
                ),
                619,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (7, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 63, 64, 65, 66)),
                    OutputSpec("Psi_v", (7, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59)),
                ),
                1565,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 73, 74, 75, 76, 77, 81, 83, 84, 85, 86, 88, 92, 93, 94, 95, 96, 99)),
                ),
                807,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                136,
            ),
        },
        family="wheel",
        picture="wheel",
    ),
    # element surface
    "surface": ElementSpec(
        name="surface",
        digest="82396fec8a27a987",
        doc="height = quadratic.(x^2, y^2, z^2, x y, x z, y z) + linear.(x, y, z) + constant",
        source="SPACAR95 manual (Schwab and Meijaard 2000), SURFACE",
        nodes=(
            NodeSpec("p", "point"),
        ),
        parameters=(
            ParameterSpec("quadratic", 6, "1/m", "coefficients of x^2, y^2, z^2, x y, x z, y z"),
            ParameterSpec("linear", 3, "1", "coefficients of x, y, z"),
            ParameterSpec("constant", 1, "m", "constant term"),
        ),
        deformations=(
            DeformationSpec("height", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 3), (0, 1, 2)),
                    OutputSpec("V", (0, 3), ()),
                ),
                33,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                15,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 3), (0, 1, 2)),
                ),
                18,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 3), (0, 1, 2)),
                    OutputSpec("Psi_v", (1, 3), (0, 1, 2)),
                ),
                39,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (3, 3), tuple(range(9))),
                ),
                9,
            ),
        },
        family="surface",
    ),
    # element toroidal_wheel
    "toroidal_wheel": ElementSpec(
        name="toroidal_wheel",
        digest="d76eaa28e8e36001",
        doc="w hub, c contact point, d = xc + crown n - xw from the hub to the centre of the tube above the contact,\na = R(lambda) axle, n = normal, ra = d x a, rim = R - crown\nradius = (d.d - rim^2)/(2 rim),  plane = a.d,  surface = n.xc - height,  lowest = n.ra\nomega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x (xc - xw), the material point in contact\nlongitudinal = ra.vc/|ra|,  lateral = (n x ra).vc/|n x ra|,  spin = omega.n\nforce: of the road on hub and contact point\norigin: xw, axes: columns of R(lambda) in rows: the frame that carries what a picture shows",
        source="Schwab and Meijaard 1999, ASME DETC99/VIB-8223 (wheel element); the crown lifts the contact off the rim's circle",
        nodes=(
            NodeSpec("w", "point"),
            NodeSpec("r", "frame"),
            NodeSpec("c", "point"),
        ),
        parameters=(
            ParameterSpec("radius", 1, "m", "radius of the rim"),
            ParameterSpec("crown", 1, "m", "radius of the cross section of the tyre, a circle"),
            ParameterSpec("axle", 3, "1", "unit vector along the axle in body axes"),
            ParameterSpec("normal", 3, "1", "unit normal of the road"),
            ParameterSpec("height", 1, "m", "distance of the road from the origin along its normal"),
        ),
        deformations=(
            DeformationSpec("radius", "m", False),
            DeformationSpec("plane", "m", False),
            DeformationSpec("surface", "m", False, kind="touch"),
            DeformationSpec("lowest", "m", False),
        ),
        slips=(
            SlipSpec("longitudinal", "m/s", False),
            SlipSpec("lateral", "m/s", False),
            SlipSpec("spin", "rad/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (4,), (0, 1, 2, 3)),
                    OutputSpec("De", (4, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39)),
                    OutputSpec("V", (3, 10), (0, 1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15, 16, 23, 24, 25, 26)),
                ),
                326,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (4,), (0, 1, 3)),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                392,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (7, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 63, 64, 65, 66)),
                ),
                626,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (7, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 63, 64, 65, 66)),
                    OutputSpec("Psi_v", (7, 10), (0, 1, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59)),
                ),
                1572,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 73, 74, 75, 76, 77, 81, 83, 84, 85, 86, 88, 92, 93, 94, 95, 96, 99)),
                ),
                814,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                143,
            ),
        },
        family="wheel",
        picture="wheel",
    ),
    # element tyre
    "tyre": ElementSpec(
        name="tyre",
        digest="505b315469f7be5b",
        doc="w wheel centre, a = R(lambda) axle, n = normal of the road below w, h = distance of w from the tangent plane\nan = |a x n|,  ex = a x n/an forward,  ey = n x ex sideways\nlength = (h - crown)/an in the plane of the wheel\nr = -length (n - (a.n) a)/an - crown n, from the centre to the contact point\ndeflection = R - crown - (h - crown)/an;  drop = R - h;  camber = atan2(a.n, an)\nomega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x r, the material point in contact\nforward = ex.xdot_w,  sideways = ey.xdot_w,  rolling = omega.a,\nlongitudinal = ex.vc,  lateral = ey.vc,  spin = omega.n\norigin: w, axes: columns of R(lambda) in rows: the frame that carries what a picture shows",
        source="Frik, Leister, Schwartz 1993, Vehicle System Dynamics 22 suppl. (frames and slip angle of the wheel)",
        nodes=(
            NodeSpec("w", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("radius", 1, "m", "radius of the unloaded tyre"),
            ParameterSpec("crown", 1, "m", "radius of the cross section of the tyre, a circle"),
            ParameterSpec("axle", 3, "1", "unit vector along the axle in body axes"),
            ParameterSpec("normal", 3, "1", "unit normal of the road"),
            ParameterSpec("height", 1, "m", "distance of the road from the origin along its normal"),
        ),
        deformations=(
            DeformationSpec("deflection", "m", True),
            DeformationSpec("drop", "m", True),
            DeformationSpec("camber", "rad", True),
        ),
        slips=(
            SlipSpec("forward", "m/s", True),
            SlipSpec("sideways", "m/s", True),
            SlipSpec("rolling", "rad/s", True),
            SlipSpec("longitudinal", "m/s", True),
            SlipSpec("lateral", "m/s", True),
            SlipSpec("spin", "rad/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (3,), (0, 1, 2)),
                    OutputSpec("De", (3, 7), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 17, 18, 19, 20)),
                    OutputSpec("V", (6, 7), (0, 1, 2, 7, 8, 9, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 38, 39, 40, 41)),
                ),
                337,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (3,), (0, 2)),
                    OutputSpec("gs", (6,), tuple(range(6))),
                ),
                452,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (9, 7), (0, 1, 2, 3, 4, 5, 6, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 59, 60, 61, 62)),
                ),
                1091,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (9, 7), (0, 1, 2, 3, 4, 5, 6, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 59, 60, 61, 62)),
                    OutputSpec("Psi_v", (9, 7), (0, 1, 2, 3, 4, 5, 6, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55)),
                ),
                2798,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (7, 7), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48)),
                ),
                1226,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                31,
            ),
        },
        family="tyre",
        picture="tyre",
    ),
    # element tyre_on_road
    "tyre_on_road": ElementSpec(
        name="tyre_on_road",
        digest="964aa91b3a82b306",
        doc="road: z = height + amplitude (1 - cos(2 pi s/wavelength))/2 with s = heading.(x, y) - start between 0 and\nwaves wavelength, z = height elsewhere (C1 at the ends, smooth between);  z up\nthe springs count the vertical distance, so that their force is normal to the road\nw wheel centre, a = R(lambda) axle, n = normal of the road below w, h = distance of w from the tangent plane\nan = |a x n|,  ex = a x n/an forward,  ey = n x ex sideways\nlength = (h - crown)/an in the plane of the wheel\nr = -length (n - (a.n) a)/an - crown n, from the centre to the contact point\ndeflection = R - crown - ((w_z - z) - crown)/an;  drop = R - (w_z - z);  camber = atan2(a.n, an)\nomega = 2 (lambdadot o conj(lambda)),  vc = xdot_w + omega x r, the material point in contact\nforward = ex.xdot_w,  sideways = ey.xdot_w,  rolling = omega.a,\nlongitudinal = ex.vc,  lateral = ey.vc,  spin = omega.n\ngrade = slope of the road along ex, rise for horizontal length times |horizontal part of ex|\norigin: w, axes: columns of R(lambda) in rows: the frame that carries what a picture shows",
        source="Frik, Leister, Schwartz 1993, Vehicle System Dynamics 22 suppl. (frames and slip angle of the wheel)",
        nodes=(
            NodeSpec("w", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("radius", 1, "m", "radius of the unloaded tyre"),
            ParameterSpec("crown", 1, "m", "radius of the cross section of the tyre, a circle"),
            ParameterSpec("axle", 3, "1", "unit vector along the axle in body axes"),
            ParameterSpec("height", 1, "m", "distance of the road from the origin along its normal"),
            ParameterSpec("amplitude", 1, "m", "height of the waves of the road, trough to crest"),
            ParameterSpec("wavelength", 1, "m", "length of one wave"),
            ParameterSpec("start", 1, "m", "where the first wave begins, along the heading of the waves"),
            ParameterSpec("waves", 1, "1", "how many waves there are; flat before and behind"),
            ParameterSpec("heading", 2, "1", "horizontal unit vector along which the road rises"),
        ),
        deformations=(
            DeformationSpec("deflection", "m", True),
            DeformationSpec("drop", "m", True),
            DeformationSpec("camber", "rad", True),
            DeformationSpec("grade", "1", True),
        ),
        slips=(
            SlipSpec("forward", "m/s", True),
            SlipSpec("sideways", "m/s", True),
            SlipSpec("rolling", "rad/s", True),
            SlipSpec("longitudinal", "m/s", True),
            SlipSpec("lateral", "m/s", True),
            SlipSpec("spin", "rad/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (4,), (0, 1, 2, 3)),
                    OutputSpec("De", (4, 7), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 14, 15, 17, 18, 19, 20, 21, 22, 24, 25, 26, 27)),
                    OutputSpec("V", (6, 7), (0, 1, 2, 7, 8, 9, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 38, 39, 40, 41)),
                ),
                533,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (4,), (0, 1, 2, 3)),
                    OutputSpec("gs", (6,), tuple(range(6))),
                ),
                696,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (10, 7), (0, 1, 2, 3, 4, 5, 6, 7, 8, 14, 15, 17, 18, 19, 20, 21, 22, 24, 25, 26, 27, 28, 29, 31, 32, 33, 34, 35, 36, 38, 39, 40, 41, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 66, 67, 68, 69)),
                ),
                1727,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (10, 7), (0, 1, 2, 3, 4, 5, 6, 7, 8, 14, 15, 17, 18, 19, 20, 21, 22, 24, 25, 26, 27, 28, 29, 31, 32, 33, 34, 35, 36, 38, 39, 40, 41, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 66, 67, 68, 69)),
                    OutputSpec("Psi_v", (10, 7), (0, 1, 2, 3, 4, 5, 6, 7, 8, 14, 15, 17, 18, 19, 20, 21, 22, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 66, 67, 68, 69)),
                ),
                5527,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (7, 7), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48)),
                ),
                1857,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                31,
            ),
        },
        family="tyre",
        picture="tyre",
    ),
    # element axle_slip
    "axle_slip": ElementSpec(
        name="axle_slip",
        digest="ae57ec23269adb6c",
        doc="lateral = mean of ey.vc of the two wheels, each as in the element tyre; zero: an axle that rolls without\nslipping sideways in the mean",
        source="Schwab, talk on SPACAR (zero lateral slip of the road vehicle)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
        ),
        parameters=(
            ParameterSpec("axle_p", 3, "1", "unit vector along the axle of p in its body axes"),
            ParameterSpec("axle_q", 3, "1", "unit vector along the axle of q in its body axes"),
            ParameterSpec("normal", 3, "1", "unit normal of the road"),
            ParameterSpec("height", 1, "m", "distance of the road from the origin along its normal"),
        ),
        deformations=(),
        slips=(
            SlipSpec("lateral", "m/s", False),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 14), ()),
                    OutputSpec("V", (1, 14), tuple(range(14))),
                ),
                252,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (1,), (0,)),
                ),
                603,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 14), tuple(range(14))),
                ),
                624,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 14), tuple(range(14))),
                    OutputSpec("Psi_v", (1, 14), tuple(range(14))),
                ),
                1624,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), (3, 4, 5, 6, 17, 18, 19, 20, 31, 32, 33, 34, 42, 43, 44, 45, 46, 47, 48, 56, 57, 58, 59, 60, 61, 62, 70, 71, 72, 73, 74, 75, 76, 84, 85, 86, 87, 88, 89, 90, 108, 109, 110, 111, 122, 123, 124, 125, 136, 137, 138, 139, 147, 148, 149, 150, 151, 152, 153, 161, 162, 163, 164, 165, 166, 167, 175, 176, 177, 178, 179, 180, 181, 189, 190, 191, 192, 193, 194, 195)),
                ),
                1228,
            ),
        },
        family="tyre",
    ),
    # element rotation
    "rotation": ElementSpec(
        name="rotation",
        digest="8bfd64251a679de0",
        doc="(wx, wy, wz) = 2 (lambdadot o conj(lambda)), angular velocity in global axes",
        source="Schwab and Meijaard 2006, DETC2006-99307",
        nodes=(
            NodeSpec("r", "frame"),
        ),
        parameters=(),
        deformations=(),
        slips=(
            SlipSpec("wx", "rad/s", True),
            SlipSpec("wy", "rad/s", True),
            SlipSpec("wz", "rad/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 4), ()),
                    OutputSpec("V", (3, 4), tuple(range(12))),
                ),
                7,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                18,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 4), tuple(range(12))),
                ),
                8,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 4), tuple(range(12))),
                    OutputSpec("Psi_v", (3, 4), ()),
                ),
                8,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (4, 4), (1, 2, 3, 4, 6, 7, 8, 9, 11, 12, 13, 14)),
                ),
                6,
            ),
        },
        family="sensor",
    ),
    # element body_rotation
    "body_rotation": ElementSpec(
        name="body_rotation",
        digest="7b449a58d5624bcd",
        doc="u = lambda o t\n(wx, wy, wz) = 2 (conj(u) o udot), angular velocity in the axes of R(u)",
        source="Schwab and Meijaard 2006, DETC2006-99307",
        nodes=(
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the triad"),
        ),
        deformations=(),
        slips=(
            SlipSpec("wx", "rad/s", True),
            SlipSpec("wy", "rad/s", True),
            SlipSpec("wz", "rad/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 4), ()),
                    OutputSpec("V", (3, 4), tuple(range(12))),
                ),
                92,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                58,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 4), tuple(range(12))),
                ),
                94,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 4), tuple(range(12))),
                    OutputSpec("Psi_v", (3, 4), tuple(range(12))),
                ),
                173,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (4, 4), tuple(range(16))),
                ),
                86,
            ),
        },
        family="sensor",
    ),
    # element body_velocity
    "body_velocity": ElementSpec(
        name="body_velocity",
        digest="16d8f605347afe64",
        doc="(vx, vy, vz) = R(lambda)' xdot_p, velocity of the point in the axes of the frame",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(),
        deformations=(),
        slips=(
            SlipSpec("vx", "m/s", True),
            SlipSpec("vy", "m/s", True),
            SlipSpec("vz", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 7), ()),
                    OutputSpec("V", (3, 7), (0, 1, 2, 7, 8, 9, 14, 15, 16)),
                ),
                31,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                59,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 7), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20)),
                ),
                27,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 7), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20)),
                    OutputSpec("Psi_v", (3, 7), tuple(range(21))),
                ),
                125,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (7, 7), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20)),
                ),
                27,
            ),
        },
        family="sensor",
    ),
    # element bar_span
    "bar_span": ElementSpec(
        name="bar_span",
        digest="b2403969448b569b",
        doc="(x, y, z) = l0 (vp + vq)/2, rate of the integral of position over a straight bar",
        source="textbook mechanics (consistent nodal forces)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("q", "point"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
        ),
        deformations=(),
        slips=(
            SlipSpec("x", "m^2/s", True),
            SlipSpec("y", "m^2/s", True),
            SlipSpec("z", "m^2/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 6), ()),
                    OutputSpec("V", (3, 6), (0, 3, 7, 10, 14, 17)),
                ),
                1,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (3,), ()),
                ),
                0,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 6), ()),
                ),
                0,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 6), ()),
                    OutputSpec("Psi_v", (3, 6), ()),
                ),
                0,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), ()),
                ),
                0,
            ),
        },
        family="span",
    ),
    # element beam_span
    "beam_span": ElementSpec(
        name="beam_span",
        digest="c733ae483e0ba226",
        doc="(x, y, z) = l0 ((vp + vq)/2 + l0 (exdot_p - exdot_q)/12), rate of the integral of position over the\nbeam's cubic Hermite interpolation; ex: first columns of R(lambda_p o tp), R(lambda_q o tq)",
        source="textbook mechanics (consistent nodal forces)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
        ),
        deformations=(),
        slips=(
            SlipSpec("x", "m^2/s", True),
            SlipSpec("y", "m^2/s", True),
            SlipSpec("z", "m^2/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 14), ()),
                    OutputSpec("V", (3, 14), (0, 3, 4, 5, 6, 7, 10, 11, 12, 13, 15, 17, 18, 19, 20, 22, 24, 25, 26, 27, 30, 31, 32, 33, 34, 37, 38, 39, 40, 41)),
                ),
                169,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                96,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 14), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41)),
                ),
                172,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 14), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41)),
                    OutputSpec("Psi_v", (3, 14), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20, 24, 25, 26, 27, 31, 32, 33, 34, 38, 39, 40, 41)),
                ),
                324,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), (45, 46, 47, 48, 59, 60, 61, 62, 73, 74, 75, 76, 87, 88, 89, 90, 150, 151, 152, 153, 164, 165, 166, 167, 178, 179, 180, 181, 192, 193, 194, 195)),
                ),
                326,
            ),
        },
        family="span",
    ),
    # element skate
    "skate": ElementSpec(
        name="skate",
        digest="824aba72e9635077",
        doc="b = R(lambda) blade, n = normal, ey = (n x b)/|n x b|, ex = ey x n\nsurface = n.x - height,  forward = ex.v,  lateral = ey.v\nahead: b\norigin: x, axes: columns of R(lambda) in rows: the frame that carries what a picture shows",
        source="Chaplygin 1911, sleigh; Neimark and Fufaev 1972, Dynamics of Nonholonomic Systems",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("blade", 3, "1", "unit vector along the blade in body axes"),
            ParameterSpec("normal", 3, "1", "unit normal of the road"),
            ParameterSpec("height", 1, "m", "distance of the road from the origin along its normal"),
        ),
        deformations=(
            DeformationSpec("surface", "m", False),
        ),
        slips=(
            SlipSpec("forward", "m/s", True),
            SlipSpec("lateral", "m/s", False),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 7), (0, 1, 2)),
                    OutputSpec("V", (2, 7), (0, 1, 2, 7, 8, 9)),
                ),
                77,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), ()),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                163,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 7), (10, 11, 12, 13, 17, 18, 19, 20)),
                ),
                200,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 7), (10, 11, 12, 13, 17, 18, 19, 20)),
                    OutputSpec("Psi_v", (3, 7), (7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20)),
                ),
                666,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (7, 7), (3, 4, 5, 6, 10, 11, 12, 13, 17, 18, 19, 20)),
                ),
                254,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("ahead", (3,), (0, 1, 2), unit="1"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                49,
            ),
        },
        picture="blade",
    ),
    # element roller_cam
    "roller_cam": ElementSpec(
        name="roller_cam",
        digest="9c29ee562da22bca",
        doc="(a, b) = components of xq - xp on ex, ey, columns of R(lambda_p o tp), r = sqrt(a^2 + b^2), theta = atan2(b, a)\nu = 48 theta/(2 pi), between i and i + 1; t = u - i\noutline = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five\ngap = r - outline\nprofile: places outline (cos theta, sin theta) at the knots;  mark: from the centre to its start\norigin: xp, axes: ex, ey, columns of R(lambda_p o tp) in rows: the frame that carries what a picture shows",
        source="pitch curve of a radial cam; de Boor 1978, A Practical Guide to Splines",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
        ),
        parameters=(
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("control", 48, "m", "control values of the periodic spline of degree five, its knots at equal steps of the angle"),
        ),
        deformations=(
            DeformationSpec("gap", "m", False, kind="gap"),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 10), tuple(range(10))),
                    OutputSpec("V", (0, 10), ()),
                ),
                678,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                800,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 10), tuple(range(10))),
                ),
                901,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 10), tuple(range(10))),
                    OutputSpec("Psi_v", (1, 10), tuple(range(10))),
                ),
                1561,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), tuple(range(100))),
                ),
                1155,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("profile", (49, 3), (0, 3, 4, 6, 7, 9, 10, 12, 13, 15, 16, 18, 19, 21, 22, 24, 25, 27, 28, 30, 31, 33, 34, 37, 39, 40, 42, 43, 45, 46, 48, 49, 51, 52, 54, 55, 57, 58, 60, 61, 63, 64, 66, 67, 69, 70, 72, 75, 76, 78, 79, 81, 82, 84, 85, 87, 88, 90, 91, 93, 94, 96, 97, 99, 100, 102, 103, 105, 106, 109, 111, 112, 114, 115, 117, 118, 120, 121, 123, 124, 126, 127, 129, 130, 132, 133, 135, 136, 138, 139, 141, 142, 144), unit="m", draws="rim", carrier=("origin", "axes")),
                    OutputSpec("mark", (2, 3), (3,), unit="m", draws="valve", carrier=("origin", "axes")),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                640,
            ),
        },
    ),
    # element flat_cam
    "flat_cam": ElementSpec(
        name="flat_cam",
        digest="a75ed7031e8d83a9",
        doc="n: normal of the face, first column of R(lambda_q o tq);  (a, b) = components of n on ex, ey, columns of R(lambda_p o tp)\npsi = atan2(b, a), u = 48 psi/(2 pi), between i and i + 1; t = u - i\nh = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five\ngap = n.(xq - xp) - h sqrt(a^2 + b^2)\nprofile: places h (cos psi, sin psi) + h' (-sin psi, cos psi) at the knots;  mark: from the centre to its start\nface: line across n, to both sides 1.2 times as far as the contact travels\norigin_p: xp, axes_p: ex, ey, columns of R(lambda_p o tp) in rows: the frame that carries profile and mark\norigin_q: xq, axes_q: n and the directions across it in rows: the frame that carries the face",
        source="support function of a convex cam; de Boor 1978, A Practical Guide to Splines",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("rp", "frame"),
            NodeSpec("q", "point"),
            NodeSpec("rq", "frame"),
        ),
        parameters=(
            ParameterSpec("tp", 4, "1", "unit quaternion from the body frame of node p to the element's triad there"),
            ParameterSpec("tq", 4, "1", "unit quaternion from the body frame of node q to the element's triad there"),
            ParameterSpec("control", 48, "m", "control values of the periodic spline of degree five, its knots at equal steps of the angle"),
        ),
        deformations=(
            DeformationSpec("gap", "m", False, kind="gap"),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 14), tuple(range(14))),
                    OutputSpec("V", (0, 14), ()),
                ),
                798,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                1067,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 14), tuple(range(14))),
                ),
                1315,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 14), tuple(range(14))),
                    OutputSpec("Psi_v", (1, 14), tuple(range(14))),
                ),
                2538,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), (10, 11, 12, 13, 24, 25, 26, 27, 38, 39, 40, 41, 45, 46, 47, 48, 52, 53, 54, 55, 59, 60, 61, 62, 66, 67, 68, 69, 73, 74, 75, 76, 80, 81, 82, 83, 87, 88, 89, 90, 94, 95, 96, 97, 108, 109, 110, 111, 122, 123, 124, 125, 136, 137, 138, 139, 140, 141, 142, 143, 144, 145, 146, 147, 148, 149, 150, 151, 152, 153, 154, 155, 156, 157, 158, 159, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169, 170, 171, 172, 173, 174, 175, 176, 177, 178, 179, 180, 181, 182, 183, 184, 185, 186, 187, 188, 189, 190, 191, 192, 193, 194, 195)),
                ),
                1967,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("profile", (49, 3), (0, 1, 3, 4, 6, 7, 9, 10, 12, 13, 15, 16, 18, 19, 21, 22, 24, 25, 27, 28, 30, 31, 33, 34, 36, 37, 39, 40, 42, 43, 45, 46, 48, 49, 51, 52, 54, 55, 57, 58, 60, 61, 63, 64, 66, 67, 69, 70, 72, 73, 75, 76, 78, 79, 81, 82, 84, 85, 87, 88, 90, 91, 93, 94, 96, 97, 99, 100, 102, 103, 105, 106, 108, 109, 111, 112, 114, 115, 117, 118, 120, 121, 123, 124, 126, 127, 129, 130, 132, 133, 135, 136, 138, 139, 141, 142, 144, 145), unit="m", draws="rim", carrier=("origin_p", "axes_p")),
                    OutputSpec("mark", (2, 3), (3, 4), unit="m", draws="valve", carrier=("origin_p", "axes_p")),
                    OutputSpec("face", (2, 3), (1, 4), unit="m", draws="rim", carrier=("origin_q", "axes_q")),
                    OutputSpec("origin_p", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes_p", (3, 3), tuple(range(9)), unit="1"),
                    OutputSpec("origin_q", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes_q", (3, 3), tuple(range(9)), unit="1"),
                ),
                1245,
            ),
        },
    ),
    # element planar_point_mass
    "planar_point_mass": ElementSpec(
        name="planar_point_mass",
        digest="bde70fc4ce29a2a0",
        doc="T = mass v.v/2\nU = -mass gravity.x\nplace: x",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "planar_point"),
        ),
        parameters=(
            ParameterSpec("mass", 1, "kg", "mass", sign=("not negative",)),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(),
        slips=(),
        kernels={
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (2, 2), (0, 3)),
                    OutputSpec("h", (2,), ()),
                    OutputSpec("f", (2,), (0, 1)),
                    OutputSpec("U", (1,), (0,)),
                ),
                7,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (2, 2), ()),
                    OutputSpec("R_v", (2, 2), ()),
                ),
                0,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (2,), (0, 1), unit="m", draws="mass"),
                ),
                0,
            ),
        },
        family="body",
    ),
    # element planar_body
    "planar_body": ElementSpec(
        name="planar_body",
        digest="4ae58659751f332a",
        doc="b = R(angle) c,  vc = xdot + angledot (-b_y, b_x), velocity of the mass centre\nT = mass vc.vc/2 + J angledot^2/2\nU = -mass gravity.(x + b)\ncentre: x + b\norigin: x, axes: columns of R(angle) in rows: the frame that carries what a picture shows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("mass", 1, "kg", "mass", sign=("not negative",)),
            ParameterSpec("c", 2, "m", "offset of the mass centre from p in body axes"),
            ParameterSpec("J", 1, "kg m^2", "moment of inertia about the mass centre"),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(),
        slips=(),
        kernels={
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (3, 3), (0, 2, 4, 5, 6, 7, 8)),
                    OutputSpec("h", (3,), (0, 1, 2)),
                    OutputSpec("f", (3,), (0, 1, 2)),
                    OutputSpec("U", (1,), (0,)),
                ),
                72,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (3, 3), (2, 5, 8)),
                    OutputSpec("R_v", (3, 3), (2, 5, 6, 7, 8)),
                ),
                90,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("centre", (2,), (0, 1), unit="m", draws="mass"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                11,
            ),
        },
        family="body",
        picture="body",
    ),
    # element planar_rotary_inertia
    "planar_rotary_inertia": ElementSpec(
        name="planar_rotary_inertia",
        digest="06363f1ff712d34e",
        doc="T = J angledot^2/2",
        source="textbook mechanics",
        nodes=(
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("J", 1, "kg m^2", "moment of inertia"),
        ),
        deformations=(),
        slips=(),
        kernels={
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (1, 1), (0,)),
                    OutputSpec("h", (1,), ()),
                    OutputSpec("f", (1,), ()),
                    OutputSpec("U", (1,), ()),
                ),
                0,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (1, 1), ()),
                    OutputSpec("R_v", (1, 1), ()),
                ),
                0,
            ),
        },
        family="body",
    ),
    # element planar_truss
    "planar_truss": ElementSpec(
        name="planar_truss",
        digest="fc0670bb60ae7523",
        doc="elongation = |xq - xp| - l0\nT = rhoA l0/6 (vp.vp + vp.vq + vq.vq), uniform bar\nU = -rhoA l0 gravity.(xp + xq)/2",
        source="van der Werff and Jonker 1984, NATO ASI F9, p. 381",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("q", "planar_point"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 4), (0, 1, 2, 3)),
                    OutputSpec("V", (0, 4), ()),
                ),
                12,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                20,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 4), (0, 1, 2, 3)),
                ),
                23,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 4), (0, 1, 2, 3)),
                    OutputSpec("Psi_v", (1, 4), (0, 1, 2, 3)),
                ),
                61,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (4, 4), tuple(range(16))),
                ),
                19,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (4, 4), (0, 2, 5, 7, 8, 10, 13, 15)),
                    OutputSpec("h", (4,), ()),
                    OutputSpec("f", (4,), (0, 1, 2, 3)),
                    OutputSpec("U", (1,), (0,)),
                ),
                15,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (4, 4), ()),
                    OutputSpec("R_v", (4, 4), ()),
                ),
                0,
            ),
        },
        family="truss",
        picture="bar",
        span="planar_bar_span",
    ),
    # element planar_hinge
    "planar_hinge": ElementSpec(
        name="planar_hinge",
        digest="cefa0eb05f82b7f7",
        doc="angle = angle_q - angle_p - offset0 (counts turns)",
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLHINGE",
        nodes=(
            NodeSpec("p", "planar_angle"),
            NodeSpec("q", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("offset0", 1, "rad", "difference of the angles when the deformation is zero"),
        ),
        deformations=(
            DeformationSpec("angle", "rad", True),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 2), (0, 1)),
                    OutputSpec("V", (0, 2), ()),
                ),
                2,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), ()),
                    OutputSpec("gs", (0,), ()),
                ),
                0,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 2), ()),
                ),
                0,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 2), ()),
                    OutputSpec("Psi_v", (1, 2), ()),
                ),
                0,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (2, 2), ()),
                ),
                0,
            ),
        },
        family="hinge",
        picture="hinge",
    ),
    # element planar_beam
    "planar_beam": ElementSpec(
        name="planar_beam",
        digest="7b74389e30f35162",
        doc="ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)\nd = xq - xp, l = |d|, el = d/l;  b1 = l - l0,  b5 = l0 ey_p.el,  b6 = -l0 ey_q.el\nelongation = b1 + (2 b5^2 + b5 b6 + 2 b6^2)/(30 l0),  bend1 = b5,  bend2 = b6\nphi_y = 12 EIz/(GAy l0^2): shear number\nT: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with\n   the shear-corrected (phi_y) cubic shapes\nU = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)\nf = De'sigma: force_p, moment_p = -(ex_p.f_xp, ey_p.f_xp), -f_angle_p; force_q, moment_q the same at q, without minus\naxis: places on the cubic axis; across: ey_p, ey_q\nshear_angle = |phi_y/(1 + phi_y) (bend1 - bend2)|/(2 l0)\nranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; shear_angle, sin(shear_angle)^2",
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLBEAM, PLBEAMNL; signs of the spatial beam's b5, b6; Meijaard 1996, Nonlinear Dyn. 9",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("alphaq0", 1, "rad", "initial direction of the element minus the angle of node q"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 1, "kg m", "mass moment of inertia of the section per length"),
            ParameterSpec("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign=("not negative",)),
            ParameterSpec("GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign=("positive",)),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
            DeformationSpec("bend1", "m", False),
            DeformationSpec("bend2", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (3,), (0, 1, 2)),
                    OutputSpec("De", (3, 6), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                    OutputSpec("V", (0, 6), ()),
                ),
                107,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (3,), (0, 1, 2)),
                    OutputSpec("gs", (0,), ()),
                ),
                127,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 6), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                ),
                214,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 6), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                    OutputSpec("Psi_v", (3, 6), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                ),
                643,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), tuple(range(36))),
                ),
                190,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (6, 6), tuple(range(36))),
                    OutputSpec("h", (6,), tuple(range(6))),
                    OutputSpec("f", (6,), tuple(range(6))),
                    OutputSpec("U", (1,), (0,)),
                ),
                321,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (6, 6), tuple(range(36))),
                    OutputSpec("R_v", (6, 6), tuple(range(36))),
                ),
                751,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force_p", (2,), (0, 1), unit="N"),
                    OutputSpec("moment_p", (1,), (0,), unit="N m"),
                    OutputSpec("force_q", (2,), (0, 1), unit="N"),
                    OutputSpec("moment_q", (1,), (0,), unit="N m"),
                    OutputSpec("shear_angle", (1,), (0,), unit="rad"),
                    OutputSpec("bend_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is bent by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("shear_range", (2,), (0, 1), unit="°", limit=5.73, beyond="is sheared by {value:.1f}°{where}: its moments are about {digits} % too small, whatever the number of elements; use rotations='logarithmic'"),
                    OutputSpec("axis", (17, 2), tuple(range(34)), unit="m", draws="beam"),
                    OutputSpec("across", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                348,
            ),
        },
        family="beam",
        picture="beam",
        span="planar_beam_span",
        arm=True,
    ),
    # element planar_beam_first_order
    "planar_beam_first_order": ElementSpec(
        name="planar_beam_first_order",
        digest="c910143fcaf9ef0d",
        doc="ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)\nd = xq - xp, l = |d|, el = d/l;  b1 = l - l0,  b5 = l0 ey_p.el,  b6 = -l0 ey_q.el\nelongation = b1,  bend1 = b5,  bend2 = b6\nphi_y = 12 EIz/(GAy l0^2): shear number\nT: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with\n   the shear-corrected (phi_y) cubic shapes\nU = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)\nf = De'sigma: force_p, moment_p = -(ex_p.f_xp, ey_p.f_xp), -f_angle_p; force_q, moment_q the same at q, without minus\naxis: places on the cubic axis; across: ey_p, ey_q\nshear_angle = |phi_y/(1 + phi_y) (bend1 - bend2)|/(2 l0)\nranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; shear_angle, sin(shear_angle)^2",
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLBEAM, PLBEAMNL; signs of the spatial beam's b5, b6; Meijaard 1996, Nonlinear Dyn. 9",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("alphaq0", 1, "rad", "initial direction of the element minus the angle of node q"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 1, "kg m", "mass moment of inertia of the section per length"),
            ParameterSpec("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign=("not negative",)),
            ParameterSpec("GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign=("positive",)),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
            DeformationSpec("bend1", "m", False),
            DeformationSpec("bend2", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (3,), (0, 1, 2)),
                    OutputSpec("De", (3, 6), (0, 1, 3, 4, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                    OutputSpec("V", (0, 6), ()),
                ),
                65,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (3,), (0, 1, 2)),
                    OutputSpec("gs", (0,), ()),
                ),
                84,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 6), (0, 1, 3, 4, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                ),
                130,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 6), (0, 1, 3, 4, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                    OutputSpec("Psi_v", (3, 6), (0, 1, 3, 4, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17)),
                ),
                448,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 33, 34, 35)),
                ),
                84,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (6, 6), tuple(range(36))),
                    OutputSpec("h", (6,), tuple(range(6))),
                    OutputSpec("f", (6,), tuple(range(6))),
                    OutputSpec("U", (1,), (0,)),
                ),
                321,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (6, 6), tuple(range(36))),
                    OutputSpec("R_v", (6, 6), tuple(range(36))),
                ),
                751,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force_p", (2,), (0, 1), unit="N"),
                    OutputSpec("moment_p", (1,), (0,), unit="N m"),
                    OutputSpec("force_q", (2,), (0, 1), unit="N"),
                    OutputSpec("moment_q", (1,), (0,), unit="N m"),
                    OutputSpec("shear_angle", (1,), (0,), unit="rad"),
                    OutputSpec("bend_range", (2,), (0, 1), unit="°", limit=15.0, beyond="is bent by {value:.0f}°{where}: its moments are about {digits} % too small; use {count} elements in place of each, or rotations='logarithmic'"),
                    OutputSpec("shear_range", (2,), (0, 1), unit="°", limit=5.73, beyond="is sheared by {value:.1f}°{where}: its moments are about {digits} % too small, whatever the number of elements; use rotations='logarithmic'"),
                    OutputSpec("axis", (17, 2), tuple(range(34)), unit="m", draws="beam"),
                    OutputSpec("across", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                334,
            ),
        },
        family="beam",
        picture="beam",
        span="planar_beam_span",
        arm=True,
    ),
    # element planar_beam_logarithmic
    "planar_beam_logarithmic": ElementSpec(
        name="planar_beam_logarithmic",
        digest="049e53572cf8de73",
        doc="ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)\nphi_y = 12 EIz/(GAy l0^2): shear number\nturn = angle_q + alphaq0 - angle_p - alpha0;  along, across: components of xq - xp on the direction halfway\nstraight = (along + l0 turn^2 (1/24 - turn^2/1920 + turn^4/322560), across): the chord without what uniform bending\n      takes from it\nbow = across/(phi_y l0 + |straight|): mean angle of the sections from the direction halfway; the shear angle is\n      phi_y bow\nelongation = straight_x + l0 (3/5 + phi_y) bow^2 - l0\nbend1, bend2 = l0 (turn/2 + (1 + phi_y) bow), l0 (turn/2 - (1 + phi_y) bow)\nT: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with\n   the shear-corrected (phi_y) cubic shapes\nU = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)\nf = De'sigma: force_p, moment_p = -(ex_p.f_xp, ey_p.f_xp), -f_angle_p; force_q, moment_q the same at q, without minus\naxis: places on the cubic axis; across: ey_p, ey_q",
        source="Reissner 1972, ZAMP 23 (strains of a rod); corotational directions as Crisfield 1990",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("alphaq0", 1, "rad", "initial direction of the element minus the angle of node q"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 1, "kg m", "mass moment of inertia of the section per length"),
            ParameterSpec("EIz", 1, "N m^2", "bending stiffness about z, of the deflection in y", sign=("not negative",)),
            ParameterSpec("GAy", 1, "N", "shear stiffness k G A of the deflection in y; very large without shear", sign=("positive",)),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False),
            DeformationSpec("bend1", "m", False),
            DeformationSpec("bend2", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (3,), (0, 1, 2)),
                    OutputSpec("De", (3, 6), tuple(range(18))),
                    OutputSpec("V", (0, 6), ()),
                ),
                110,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (3,), (0, 1, 2)),
                    OutputSpec("gs", (0,), ()),
                ),
                163,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 6), tuple(range(18))),
                ),
                241,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 6), tuple(range(18))),
                    OutputSpec("Psi_v", (3, 6), tuple(range(18))),
                ),
                739,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), tuple(range(36))),
                ),
                226,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (6, 6), tuple(range(36))),
                    OutputSpec("h", (6,), tuple(range(6))),
                    OutputSpec("f", (6,), tuple(range(6))),
                    OutputSpec("U", (1,), (0,)),
                ),
                321,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (6, 6), tuple(range(36))),
                    OutputSpec("R_v", (6, 6), tuple(range(36))),
                ),
                752,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("force_p", (2,), (0, 1), unit="N"),
                    OutputSpec("moment_p", (1,), (0,), unit="N m"),
                    OutputSpec("force_q", (2,), (0, 1), unit="N"),
                    OutputSpec("moment_q", (1,), (0,), unit="N m"),
                    OutputSpec("axis", (17, 2), tuple(range(34)), unit="m", draws="beam"),
                    OutputSpec("across", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                347,
            ),
        },
        family="beam",
        picture="beam",
        span="planar_beam_span",
        arm=True,
    ),
    # element planar_beam3
    "planar_beam3": ElementSpec(
        name="planar_beam3",
        digest="c4683b4228b4747e",
        doc="ex, ey: directions of the element (angle_p + alpha0); d = xq - xp\nalong = ex.d - d0_x,  across = ey.d - d0_y\nT = rhoA l0/6 (vp.vp + vp.vq + vq.vq) + l0/2 rhoJ angledot^2, uniform bar\nU = -rhoA l0 gravity.(xp + xq)/2\naxes: the directions in rows;  displacement: the deformations that are lengths",
        source="planar counterpart of beam3",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("d0", 2, "m", "components of xq - xp on ex, ey when the deformations are zero"),
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("rhoJ", 1, "kg m", "mass moment of inertia of the section per length"),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("along", "m", False),
            DeformationSpec("across", "m", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (2,), (0, 1)),
                    OutputSpec("De", (2, 5), tuple(range(10))),
                    OutputSpec("V", (0, 5), ()),
                ),
                17,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (2,), (0, 1)),
                    OutputSpec("gs", (0,), ()),
                ),
                27,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 5), tuple(range(10))),
                ),
                26,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 5), tuple(range(10))),
                    OutputSpec("Psi_v", (2, 5), tuple(range(10))),
                ),
                64,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (5, 5), (2, 7, 10, 11, 12, 13, 14, 17, 22)),
                ),
                23,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (5, 5), (0, 3, 6, 9, 12, 15, 18, 21, 24)),
                    OutputSpec("h", (5,), ()),
                    OutputSpec("f", (5,), (0, 1, 3, 4)),
                    OutputSpec("U", (1,), (0,)),
                ),
                16,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (5, 5), ()),
                    OutputSpec("R_v", (5, 5), ()),
                ),
                0,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                    OutputSpec("displacement", (2,), (0, 1), unit="m"),
                ),
                14,
            ),
        },
        family="link",
        picture="bar",
        span="planar_bar_span",
        arm=True,
    ),
    # element planar_bearing
    "planar_bearing": ElementSpec(
        name="planar_bearing",
        digest="698413354c2bda26",
        doc="ex, ey: directions of the element (angle_p + alpha0); d = xq - xp\nalong = ex.d - d0_x,  across = ey.d - d0_y,  angle = angle_q - angle_p - offset0 (counts turns)\naxes: the directions in rows;  displacement: the deformations that are lengths",
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLBEAR",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("d0", 2, "m", "components of xq - xp on ex, ey when the deformations are zero"),
            ParameterSpec("offset0", 1, "rad", "difference of the angles when the deformation is zero"),
        ),
        deformations=(
            DeformationSpec("along", "m", False),
            DeformationSpec("across", "m", False),
            DeformationSpec("angle", "rad", True),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (3,), (0, 1, 2)),
                    OutputSpec("De", (3, 6), (0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 14, 17)),
                    OutputSpec("V", (0, 6), ()),
                ),
                19,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (3,), (0, 1)),
                    OutputSpec("gs", (0,), ()),
                ),
                27,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 6), (0, 1, 2, 3, 4, 6, 7, 8, 9, 10)),
                ),
                26,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 6), (0, 1, 2, 3, 4, 6, 7, 8, 9, 10)),
                    OutputSpec("Psi_v", (3, 6), (0, 1, 2, 3, 4, 6, 7, 8, 9, 10)),
                ),
                64,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), (2, 8, 12, 13, 14, 15, 16, 20, 26)),
                ),
                23,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                    OutputSpec("displacement", (2,), (0, 1), unit="m"),
                ),
                14,
            ),
        },
        family="bearing",
    ),
    # element planar_belt
    "planar_belt": ElementSpec(
        name="planar_belt",
        digest="a35518cb77059eed",
        doc="d = xq - xp, psi its angle counted from psi0 (less than half a turn away)\nfree_length = sqrt(d.d - (radius_p - radius_q)^2), of the common tangent on the left of d\ntheta = psi - atan2(radius_p - radius_q, free_length), turn of the points of contact\nelongation = free_length + radius_p (angle_p - theta) - radius_q (angle_q - theta) - zero,\nperiod 2 pi (radius_p - radius_q): a turn of the line of centres, whose angle is a principal value\nrun: from xp + radius_p left to xq + radius_q left, left the normal of the common tangent\norigin_p, axes_p, origin_q, axes_q: frames of both wheels at xp and xq, the axes in rows",
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLBELT; terms in theta from the geometry: without them the tension would not act along the belt",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("radius_p", 1, "m", "radius of the pulley at p, positive if the belt leaves it on the left"),
            ParameterSpec("radius_q", 1, "m", "radius of the pulley at q, positive if the belt runs on it on the left"),
            ParameterSpec("psi0", 1, "rad", "direction of the line of centres from which its turn is counted"),
            ParameterSpec("zero", 1, "m", "length without strain, angles and turn taken as zero"),
        ),
        deformations=(
            DeformationSpec("elongation", "m", False, period=(TermSpec(6.283185307179586, powers=(("radius_p", 0, 1),)), TermSpec(-6.283185307179586, powers=(("radius_q", 0, 1),)))),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 6), tuple(range(6))),
                    OutputSpec("V", (0, 6), ()),
                ),
                53,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                69,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 6), (0, 1, 3, 4)),
                ),
                78,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 6), (0, 1, 3, 4)),
                    OutputSpec("Psi_v", (1, 6), (0, 1, 3, 4)),
                ),
                186,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), (0, 1, 3, 4, 6, 7, 9, 10, 18, 19, 21, 22, 24, 25, 27, 28)),
                ),
                77,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("run", (2, 2), (0, 1, 2, 3), unit="m", draws="bar"),
                    OutputSpec("origin_p", (2,), (0, 1), unit="m"),
                    OutputSpec("axes_p", (2, 2), (0, 1, 2, 3), unit="1"),
                    OutputSpec("origin_q", (2,), (0, 1), unit="m"),
                    OutputSpec("axes_q", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                32,
            ),
        },
        family="belt",
        picture="belt",
    ),
    # element planar_gear
    "planar_gear": ElementSpec(
        name="planar_gear",
        digest="9fe4207fe265122d",
        doc="d = xq - xp, psi its angle counted from offset0, period 2 pi\nmesh = (radius_p angle_p + radius_q angle_q)/(radius_p + radius_q) - psi, an angle, so that any number\nof turns of the line of centres can be counted; (radius_p + radius_q) mesh is the displacement of the teeth\norigin_p, axes_p, origin_q, axes_q: frames of both wheels at xp and xq, the axes in rows",
        source="rolling of the pitch circles, radius_p (angle_p - psi) + radius_q (angle_q - psi) = const; UT SPACAR, GEAR",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("radius_p", 1, "m", "pitch radius of the gear at p, negative for an internal gear"),
            ParameterSpec("radius_q", 1, "m", "pitch radius of the gear at q, negative for an internal gear"),
            ParameterSpec("offset0", 1, "rad", "difference of the angles when the deformation is zero"),
        ),
        deformations=(
            DeformationSpec("mesh", "rad", False, period=(TermSpec(6.283185307179586),)),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 6), tuple(range(6))),
                    OutputSpec("V", (0, 6), ()),
                ),
                34,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                38,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 6), (0, 1, 3, 4)),
                ),
                43,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 6), (0, 1, 3, 4)),
                    OutputSpec("Psi_v", (1, 6), (0, 1, 3, 4)),
                ),
                93,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), (0, 1, 3, 4, 6, 7, 9, 10, 18, 19, 21, 22, 24, 25, 27, 28)),
                ),
                53,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("origin_p", (2,), (0, 1), unit="m"),
                    OutputSpec("axes_p", (2, 2), (0, 1, 2, 3), unit="1"),
                    OutputSpec("origin_q", (2,), (0, 1), unit="m"),
                    OutputSpec("axes_q", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                6,
            ),
        },
        family="gear",
        picture="gears",
    ),
    # element planar_wheel
    "planar_wheel": ElementSpec(
        name="planar_wheel",
        digest="81738025e405e9ab",
        doc="ex, ey: direction of travel (angle_r + alpha0) and its normal; angle_s is the turn about the axle\nlongitudinal = ex.v - radius angledot_s,  lateral = ey.v\naxes: of the wheel in space, in rows: a spoke, which turns from ex down, its normal, and the axle ey\norigin: x",
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLWHEEL",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("r", "planar_angle"),
            NodeSpec("s", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("radius", 1, "m", "radius of the wheel"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
        ),
        deformations=(),
        slips=(
            SlipSpec("longitudinal", "m/s", False),
            SlipSpec("lateral", "m/s", False),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 4), ()),
                    OutputSpec("V", (2, 4), (0, 1, 3, 4, 5)),
                ),
                5,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                12,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 4), (2, 6)),
                ),
                10,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 4), (2, 6)),
                    OutputSpec("Psi_v", (2, 4), (0, 1, 2, 4, 5, 6)),
                ),
                29,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (4, 4), (2, 6)),
                ),
                10,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(8)), unit="1"),
                ),
                14,
            ),
        },
        family="wheel",
        picture="disc",
    ),
    # element planar_skate
    "planar_skate": ElementSpec(
        name="planar_skate",
        digest="3a6b635849de7b0a",
        doc="ex, ey: direction of the blade (angle + alpha0) and its normal;  forward = ex.v,  lateral = ey.v\nahead: ex\norigin: x, axes: ex, ey in rows: the frame that carries what a picture shows",
        source="Chaplygin 1911, sleigh; Neimark and Fufaev 1972, Dynamics of Nonholonomic Systems",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
        ),
        deformations=(),
        slips=(
            SlipSpec("forward", "m/s", True),
            SlipSpec("lateral", "m/s", False),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 3), ()),
                    OutputSpec("V", (2, 3), (0, 1, 3, 4)),
                ),
                4,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                12,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 3), (2, 5)),
                ),
                10,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 3), (2, 5)),
                    OutputSpec("Psi_v", (2, 3), tuple(range(6))),
                ),
                29,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (3, 3), (2, 5)),
                ),
                10,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("ahead", (2,), (0, 1), unit="1"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                4,
            ),
        },
        picture="blade",
    ),
    # element planar_roller_cam
    "planar_roller_cam": ElementSpec(
        name="planar_roller_cam",
        digest="1eae1ec63a549f72",
        doc="(a, b) = components of xq - xp on ex, ey (angle_p + alpha0), r = sqrt(a^2 + b^2), theta = atan2(b, a)\nu = 48 theta/(2 pi), between i and i + 1; t = u - i\noutline = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five\ngap = r - outline\nprofile: places outline (cos theta, sin theta) at the knots;  mark: from the centre to its start\norigin: xp, axes: ex, ey (angle_p + alpha0) in rows: the frame that carries what a picture shows",
        source="pitch curve of a radial cam; de Boor 1978, A Practical Guide to Splines",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("control", 48, "m", "control values of the periodic spline of degree five, its knots at equal steps of the angle"),
        ),
        deformations=(
            DeformationSpec("gap", "m", False, kind="gap"),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 5), tuple(range(5))),
                    OutputSpec("V", (0, 5), ()),
                ),
                553,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                641,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 5), tuple(range(5))),
                ),
                669,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 5), tuple(range(5))),
                    OutputSpec("Psi_v", (1, 5), tuple(range(5))),
                ),
                1053,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (5, 5), tuple(range(25))),
                ),
                650,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("profile", (49, 2), (0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96), unit="m", draws="rim", carrier=("origin", "axes")),
                    OutputSpec("mark", (2, 2), (2,), unit="m", draws="valve", carrier=("origin", "axes")),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                585,
            ),
        },
    ),
    # element planar_flat_cam
    "planar_flat_cam": ElementSpec(
        name="planar_flat_cam",
        digest="6268d8a8673441b2",
        doc="n: normal of the face, direction angle_q + alphaq0;  (a, b) = components of n on ex, ey (angle_p + alpha0)\npsi = atan2(b, a), u = 48 psi/(2 pi), between i and i + 1; t = u - i\nh = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five\ngap = n.(xq - xp) - h\nprofile: places h (cos psi, sin psi) + h' (-sin psi, cos psi) at the knots;  mark: from the centre to its start\nface: line across n, to both sides 1.2 times as far as the contact travels\norigin_p: xp, axes_p: ex, ey (angle_p + alpha0) in rows: the frame that carries profile and mark\norigin_q: xq, axes_q: n and the directions across it in rows: the frame that carries the face",
        source="support function of a convex cam; de Boor 1978, A Practical Guide to Splines",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("alphaq0", 1, "rad", "initial direction of the element minus the angle of node q"),
            ParameterSpec("control", 48, "m", "control values of the periodic spline of degree five, its knots at equal steps of the angle"),
        ),
        deformations=(
            DeformationSpec("gap", "m", False, kind="gap"),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 6), tuple(range(6))),
                    OutputSpec("V", (0, 6), ()),
                ),
                518,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                653,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 6), tuple(range(6))),
                ),
                594,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 6), tuple(range(6))),
                    OutputSpec("Psi_v", (1, 6), tuple(range(6))),
                ),
                1015,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), (5, 11, 14, 17, 23, 29, 30, 31, 32, 33, 34, 35)),
                ),
                608,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("profile", (49, 2), tuple(range(98)), unit="m", draws="rim", carrier=("origin_p", "axes_p")),
                    OutputSpec("mark", (2, 2), (2, 3), unit="m", draws="valve", carrier=("origin_p", "axes_p")),
                    OutputSpec("face", (2, 2), (1, 3), unit="m", draws="rim", carrier=("origin_q", "axes_q")),
                    OutputSpec("origin_p", (2,), (0, 1), unit="m"),
                    OutputSpec("axes_p", (2, 2), (0, 1, 2, 3), unit="1"),
                    OutputSpec("origin_q", (2,), (0, 1), unit="m"),
                    OutputSpec("axes_q", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                1135,
            ),
        },
    ),
    # element planar_body_velocity
    "planar_body_velocity": ElementSpec(
        name="planar_body_velocity",
        digest="36cfeccaceffa584",
        doc="(vx, vy) = R(angle)' xdot_p, velocity of the point in the axes of the angle node",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(),
        deformations=(),
        slips=(
            SlipSpec("vx", "m/s", True),
            SlipSpec("vy", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 3), ()),
                    OutputSpec("V", (2, 3), (0, 1, 3, 4)),
                ),
                3,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                11,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 3), (2, 5)),
                ),
                9,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 3), (2, 5)),
                    OutputSpec("Psi_v", (2, 3), tuple(range(6))),
                ),
                28,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (3, 3), (2, 5)),
                ),
                9,
            ),
        },
        family="sensor",
    ),
    # element planar_bar_span
    "planar_bar_span": ElementSpec(
        name="planar_bar_span",
        digest="6d544293988bba62",
        doc="(x, y, z) = l0 (vp + vq)/2, rate of the integral of position over a straight bar",
        source="textbook mechanics (consistent nodal forces)",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("q", "planar_point"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
        ),
        deformations=(),
        slips=(
            SlipSpec("x", "m^2/s", True),
            SlipSpec("y", "m^2/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 4), ()),
                    OutputSpec("V", (2, 4), (0, 2, 5, 7)),
                ),
                1,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (2,), ()),
                ),
                0,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 4), ()),
                ),
                0,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 4), ()),
                    OutputSpec("Psi_v", (2, 4), ()),
                ),
                0,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (4, 4), ()),
                ),
                0,
            ),
        },
        family="span",
    ),
    # element planar_beam_span
    "planar_beam_span": ElementSpec(
        name="planar_beam_span",
        digest="4ba5773cef72f8f5",
        doc="(x, y) = l0 ((vp + vq)/2 + l0 (exdot_p - exdot_q)/12), rate of the integral of position over the\nbeam's cubic Hermite interpolation; ex: directions of the element at p and q",
        source="textbook mechanics (consistent nodal forces)",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("rp", "planar_angle"),
            NodeSpec("q", "planar_point"),
            NodeSpec("rq", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("alphaq0", 1, "rad", "initial direction of the element minus the angle of node q"),
        ),
        deformations=(),
        slips=(
            SlipSpec("x", "m^2/s", True),
            SlipSpec("y", "m^2/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 6), ()),
                    OutputSpec("V", (2, 6), (0, 2, 3, 5, 7, 8, 10, 11)),
                ),
                18,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                19,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 6), (2, 5, 8, 11)),
                ),
                21,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 6), (2, 5, 8, 11)),
                    OutputSpec("Psi_v", (2, 6), (2, 5, 8, 11)),
                ),
                44,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), (14, 35)),
                ),
                18,
            ),
        },
        family="span",
    ),
    # element cable
    "cable": ElementSpec(
        name="cable",
        digest="67c14ad02ffef3ec",
        doc="r(s): cubic Hermite curve with slopes dp, dq = dr/ds by the undeformed arc length s at the ends\nstrain1 = L/l0 - 1, the mean of |r'| - 1 by 3 Gauss points;  strain2 = (|dq| - |dp|)/2;\nstrain3 = (|dq| + |dp|)/2 - L/l0:  |r'| - 1 = strain1 + strain2 P1 + strain3 P2, Legendre's polynomials\ncurvature = (r' x r'')/|r'|^2, the turn by undeformed arc length, at 3 Gauss points\nwork: EA l0 (1, 1/3, 1/5) times the strains, EI times curvature and Gauss weight (of sum l0)\nT = rhoA/2 int rdot.rdot ds (constant mass matrix),  U = -rhoA gravity.int r ds\narc_length, tension, strain, curvature at 3 Gauss points:\ntension = (sigma1 + 3 sigma2 P1 + 5 sigma3 P2)/l0,  strain = strain1 + strain2 P1 + strain3 P2,\ncurvature = its magnitude\nline: places on the curve",
        source="Gerstmayr and Irschik 2008, J. Sound Vib. 318:461 (strain and curvature); Gerstmayr and Shabana 2006, Nonlinear Dyn. 45:109 (cubic cable)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("dp", "slope"),
            NodeSpec("q", "point"),
            NodeSpec("dq", "slope"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("gravity", 3, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("strain1", "1", True),
            DeformationSpec("strain2", "1", True),
            DeformationSpec("strain3", "1", True),
            DeformationSpec("curvature1x", "1/m", True),
            DeformationSpec("curvature1y", "1/m", True),
            DeformationSpec("curvature1z", "1/m", True),
            DeformationSpec("curvature2x", "1/m", True),
            DeformationSpec("curvature2y", "1/m", True),
            DeformationSpec("curvature2z", "1/m", True),
            DeformationSpec("curvature3x", "1/m", True),
            DeformationSpec("curvature3y", "1/m", True),
            DeformationSpec("curvature3z", "1/m", True),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (12,), tuple(range(12))),
                    OutputSpec("De", (12, 12), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 15, 16, 17, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143)),
                    OutputSpec("V", (0, 12), ()),
                ),
                547,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (12,), tuple(range(12))),
                    OutputSpec("gs", (0,), ()),
                ),
                495,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (12, 12), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 15, 16, 17, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143)),
                ),
                952,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (12, 12), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 15, 16, 17, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143)),
                    OutputSpec("Psi_v", (12, 12), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 15, 16, 17, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143)),
                ),
                2182,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (12, 12), tuple(range(144))),
                ),
                1316,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (12, 12), (0, 3, 6, 9, 13, 16, 19, 22, 26, 29, 32, 35, 36, 39, 42, 45, 49, 52, 55, 58, 62, 65, 68, 71, 72, 75, 78, 81, 85, 88, 91, 94, 98, 101, 104, 107, 108, 111, 114, 117, 121, 124, 127, 130, 134, 137, 140, 143)),
                    OutputSpec("h", (12,), ()),
                    OutputSpec("f", (12,), tuple(range(12))),
                    OutputSpec("U", (1,), (0,)),
                ),
                53,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (12, 12), ()),
                    OutputSpec("R_v", (12, 12), ()),
                ),
                0,
            ),
            "outputs": KernelSpec(
                ("x", "e", "sigma", "tau", "p"),
                (
                    OutputSpec("arc_length", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("tension", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("strain", (3,), (0, 1, 2), unit="1"),
                    OutputSpec("curvature", (3,), (0, 1, 2), unit="1/m"),
                    OutputSpec("line", (9, 3), tuple(range(27)), unit="m", draws="rope"),
                ),
                201,
            ),
        },
        family="cable",
        picture="rope",
        span="cable_span",
    ),
    # element slope_clamp
    "slope_clamp": ElementSpec(
        name="slope_clamp",
        digest="08bac3743f07f08a",
        doc="triad ex, ey, ez: columns of R(lambda o t);  across_y = ey.d,  across_z = ez.d",
        source="textbook mechanics",
        nodes=(
            NodeSpec("r", "frame"),
            NodeSpec("d", "slope"),
        ),
        parameters=(
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to a triad whose first axis is the held direction"),
        ),
        deformations=(
            DeformationSpec("across_y", "1", False),
            DeformationSpec("across_z", "1", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (2,), (0, 1)),
                    OutputSpec("De", (2, 7), tuple(range(14))),
                    OutputSpec("V", (0, 7), ()),
                ),
                133,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (2,), (0, 1)),
                    OutputSpec("gs", (0,), ()),
                ),
                144,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 7), tuple(range(14))),
                ),
                189,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 7), tuple(range(14))),
                    OutputSpec("Psi_v", (2, 7), tuple(range(14))),
                ),
                414,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (7, 7), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 35, 36, 37, 38, 42, 43, 44, 45)),
                ),
                263,
            ),
        },
        family="clamp",
    ),
    # element cable_span
    "cable_span": ElementSpec(
        name="cable_span",
        digest="2056656ec90a6f36",
        doc="l0 ((vp + vq)/2 + l0 (dpdot - dqdot)/12), rate of the integral of position over a cable's cubic curve",
        source="textbook mechanics (consistent nodal forces)",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("dp", "slope"),
            NodeSpec("q", "point"),
            NodeSpec("dq", "slope"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
        ),
        deformations=(),
        slips=(
            SlipSpec("x", "m^2/s", True),
            SlipSpec("y", "m^2/s", True),
            SlipSpec("z", "m^2/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 12), ()),
                    OutputSpec("V", (3, 12), (0, 3, 6, 9, 13, 16, 19, 22, 26, 29, 32, 35)),
                ),
                4,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (3,), ()),
                ),
                0,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 12), ()),
                ),
                0,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 12), ()),
                    OutputSpec("Psi_v", (3, 12), ()),
                ),
                0,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (12, 12), ()),
                ),
                0,
            ),
        },
        family="span",
    ),
    # element cable_cylinder
    "cable_cylinder": ElementSpec(
        name="cable_cylinder",
        digest="c74ee8537b4d4854",
        doc="x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\nh = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\ndistance = |(yy, yz)| from the axle ex, (ny, nz) = (yy, yz)/distance\ngap = distance - radius - rope_radius,  tangential = ny ydot_z - nz ydot_y,  axial = ydot_x\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("dp", "slope"),
            NodeSpec("q", "point"),
            NodeSpec("dq", "slope"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("xi", 1, "1", "place along the element, from 0 at p to 1 at q"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("rope_radius", 1, "m", "outer radius of the rope"),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("axial", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 19), tuple(range(19))),
                    OutputSpec("V", (2, 19), tuple(range(38))),
                ),
                473,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                531,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 19), tuple(range(57))),
                ),
                991,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 19), tuple(range(57))),
                    OutputSpec("Psi_v", (3, 19), tuple(range(57))),
                ),
                2428,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (19, 19), tuple(range(361))),
                ),
                4869,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                189,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element cable_plane
    "cable_plane": ElementSpec(
        name="cable_plane",
        digest="1f0ccdccb8fb46ca",
        doc="x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\nh = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\ngap = yz - rope_radius, the plane is z = 0;  x = ydot_x,  y = ydot_y\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("dp", "slope"),
            NodeSpec("q", "point"),
            NodeSpec("dq", "slope"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("xi", 1, "1", "place along the element, from 0 at p to 1 at q"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("rope_radius", 1, "m", "outer radius of the rope"),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("x", "m/s", True),
            SlipSpec("y", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 19), tuple(range(19))),
                    OutputSpec("V", (2, 19), tuple(range(38))),
                ),
                407,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                423,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 19), tuple(range(57))),
                ),
                777,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 19), tuple(range(57))),
                    OutputSpec("Psi_v", (3, 19), tuple(range(57))),
                ),
                1767,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (19, 19), (15, 16, 17, 18, 34, 35, 36, 37, 53, 54, 55, 56, 60, 61, 62, 66, 67, 68, 72, 73, 74, 75, 79, 80, 81, 85, 86, 87, 91, 92, 93, 94, 98, 99, 100, 104, 105, 106, 110, 111, 112, 113, 129, 130, 131, 132, 148, 149, 150, 151, 167, 168, 169, 170, 174, 175, 176, 180, 181, 182, 186, 187, 188, 189, 193, 194, 195, 199, 200, 201, 205, 206, 207, 208, 212, 213, 214, 218, 219, 220, 224, 225, 226, 227, 243, 244, 245, 246, 262, 263, 264, 265, 281, 282, 283, 284, 285, 286, 287, 288, 289, 290, 291, 292, 293, 294, 295, 296, 297, 298, 299, 300, 301, 302, 303, 304, 305, 306, 307, 308, 309, 310, 311, 312, 313, 314, 315, 316, 317, 318, 319, 320, 321, 322, 323, 324, 325, 326, 327, 328, 329, 330, 331, 332, 333, 334, 335, 336, 337, 338, 339, 340, 341, 342, 343, 344, 345, 346, 347, 348, 349, 350, 351, 352, 353, 354, 355, 356, 357, 358, 359, 360)),
                ),
                2285,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                158,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element cable_v_groove
    "cable_v_groove": ElementSpec(
        name="cable_v_groove",
        digest="b4c30acd7e6311e4",
        doc="x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\nh = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\ndistance = |(yy, yz)| from the axle ex, h = distance - radius - rope_radius; two flanks of half the angle beta\ngap1 = h sin beta - yx cos beta,  gap2 = h sin beta + yx cos beta: both closed at h = 0 in the middle\ntangential as for a cylinder,  across1, across2 = hdot cos beta +- ydot_x sin beta, up the flanks\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("dp", "slope"),
            NodeSpec("q", "point"),
            NodeSpec("dq", "slope"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("xi", 1, "1", "place along the element, from 0 at p to 1 at q"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("flank", 2, "1", "sine and cosine of half the opening angle of the flanks"),
            ParameterSpec("rope_radius", 1, "m", "outer radius of the rope"),
        ),
        deformations=(
            DeformationSpec("gap1", "m", True, kind="gap"),
            DeformationSpec("gap2", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("across1", "m/s", True),
            SlipSpec("across2", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (2,), (0, 1)),
                    OutputSpec("De", (2, 19), tuple(range(38))),
                    OutputSpec("V", (3, 19), tuple(range(57))),
                ),
                699,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (2,), (0, 1)),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                575,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (5, 19), tuple(range(95))),
                ),
                1504,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (5, 19), tuple(range(95))),
                    OutputSpec("Psi_v", (5, 19), tuple(range(95))),
                ),
                3769,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (19, 19), tuple(range(361))),
                ),
                4898,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                202,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element cable_round_groove
    "cable_round_groove": ElementSpec(
        name="cable_round_groove",
        digest="de26e22e721ffe8c",
        doc="x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\nh = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\nw = (radius + groove_radius - distance from the axle ex, yx), from the centre of the round bottom to the rope\ngap = groove_radius - rope_radius - n.w, n = w/|w| on the bottom, (sin beta, +-cos beta) on the flanks that\ncontinue it;  tangential as for a cylinder,  across = n_0 ydot_x + n_1 distancedot, along the groove's profile\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("dp", "slope"),
            NodeSpec("q", "point"),
            NodeSpec("dq", "slope"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("xi", 1, "1", "place along the element, from 0 at p to 1 at q"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("groove_radius", 1, "m", "radius of the groove's round bottom"),
            ParameterSpec("flank", 2, "1", "sine and cosine of half the opening angle of the flanks"),
            ParameterSpec("rope_radius", 1, "m", "outer radius of the rope"),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap", kinked=True),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("across", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 19), tuple(range(19))),
                    OutputSpec("V", (2, 19), tuple(range(38))),
                ),
                551,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                646,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 19), tuple(range(57))),
                ),
                1222,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 19), tuple(range(57))),
                    OutputSpec("Psi_v", (3, 19), tuple(range(57))),
                ),
                3089,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (19, 19), tuple(range(361))),
                ),
                6392,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                234,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element cable_helical_groove
    "cable_helical_groove": ElementSpec(
        name="cable_helical_groove",
        digest="b5881522e741f62f",
        doc="x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\nh = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\na round groove along the helix yx = lead phi/(2 pi), phi the angle of (yy, yz) about the axle ex from ey to ez\nside = (yx - lead phi/(2 pi)) cos gamma from the nearest turn, tan gamma = lead/(2 pi (radius + rope_radius))\ngap of the round groove with side for yx: its profile is perpendicular to the groove\ntangential along the groove;  across along its profile, perpendicular to the groove\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("dp", "slope"),
            NodeSpec("q", "point"),
            NodeSpec("dq", "slope"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("xi", 1, "1", "place along the element, from 0 at p to 1 at q"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("lead", 1, "m", "axial distance of two turns of the groove, positive for a right-handed helix"),
            ParameterSpec("groove_radius", 1, "m", "radius of the groove's round bottom"),
            ParameterSpec("flank", 2, "1", "sine and cosine of half the opening angle of the flanks"),
            ParameterSpec("rope_radius", 1, "m", "outer radius of the rope"),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap", kinked=True),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("across", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 19), tuple(range(19))),
                    OutputSpec("V", (2, 19), tuple(range(38))),
                ),
                627,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                780,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 19), tuple(range(57))),
                ),
                1453,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 19), tuple(range(57))),
                    OutputSpec("Psi_v", (3, 19), tuple(range(57))),
                ),
                3709,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (19, 19), tuple(range(361))),
                ),
                6552,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                305,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element point_cylinder
    "point_cylinder": ElementSpec(
        name="point_cylinder",
        digest="287ac15381f8c13a",
        doc="x: place of p\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\ndistance = |(yy, yz)| from the axle ex, (ny, nz) = (yy, yz)/distance\ngap = distance - radius - sphere_radius,  tangential = ny ydot_z - nz ydot_y,  axial = ydot_x\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("axial", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 10), tuple(range(10))),
                    OutputSpec("V", (2, 10), tuple(range(20))),
                ),
                305,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                337,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 10), tuple(range(30))),
                ),
                652,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 10), tuple(range(30))),
                    OutputSpec("Psi_v", (3, 10), tuple(range(30))),
                ),
                1606,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), tuple(range(100))),
                ),
                1442,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                132,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element point_plane
    "point_plane": ElementSpec(
        name="point_plane",
        digest="5257bf366979c7d1",
        doc="x: place of p\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\ngap = yz - sphere_radius, the plane is z = 0;  x = ydot_x,  y = ydot_y\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("x", "m/s", True),
            SlipSpec("y", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 10), tuple(range(10))),
                    OutputSpec("V", (2, 10), tuple(range(20))),
                ),
                231,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                255,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 10), tuple(range(30))),
                ),
                454,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 10), tuple(range(30))),
                    OutputSpec("Psi_v", (3, 10), tuple(range(30))),
                ),
                1046,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), (6, 7, 8, 9, 16, 17, 18, 19, 26, 27, 28, 29, 36, 37, 38, 39, 46, 47, 48, 49, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99)),
                ),
                765,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                101,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element point_v_groove
    "point_v_groove": ElementSpec(
        name="point_v_groove",
        digest="431dc9d9b2de202d",
        doc="x: place of p\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\ndistance = |(yy, yz)| from the axle ex, h = distance - radius - sphere_radius; two flanks of half the angle beta\ngap1 = h sin beta - yx cos beta,  gap2 = h sin beta + yx cos beta: both closed at h = 0 in the middle\ntangential as for a cylinder,  across1, across2 = hdot cos beta +- ydot_x sin beta, up the flanks\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("flank", 2, "1", "sine and cosine of half the opening angle of the flanks"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap1", "m", True, kind="gap"),
            DeformationSpec("gap2", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("across1", "m/s", True),
            SlipSpec("across2", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (2,), (0, 1)),
                    OutputSpec("De", (2, 10), tuple(range(20))),
                    OutputSpec("V", (3, 10), tuple(range(30))),
                ),
                421,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (2,), (0, 1)),
                    OutputSpec("gs", (3,), (0, 1, 2)),
                ),
                371,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (5, 10), tuple(range(50))),
                ),
                876,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (5, 10), tuple(range(50))),
                    OutputSpec("Psi_v", (5, 10), tuple(range(50))),
                ),
                2688,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), tuple(range(100))),
                ),
                1504,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                145,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element point_round_groove
    "point_round_groove": ElementSpec(
        name="point_round_groove",
        digest="33814b1b74a33668",
        doc="x: place of p\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\nw = (radius + groove_radius - distance from the axle ex, yx), from the centre of the round bottom to the point\ngap = groove_radius - sphere_radius - n.w, n = w/|w| on the bottom, (sin beta, +-cos beta) on the flanks that\ncontinue it;  tangential as for a cylinder,  across = n_0 ydot_x + n_1 distancedot, along the groove's profile\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("groove_radius", 1, "m", "radius of the groove's round bottom"),
            ParameterSpec("flank", 2, "1", "sine and cosine of half the opening angle of the flanks"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap", kinked=True),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("across", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 10), tuple(range(10))),
                    OutputSpec("V", (2, 10), tuple(range(20))),
                ),
                390,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                439,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 10), tuple(range(30))),
                ),
                871,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 10), tuple(range(30))),
                    OutputSpec("Psi_v", (3, 10), tuple(range(30))),
                ),
                2196,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (10, 10), tuple(range(100))),
                ),
                1829,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                ),
                177,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element sphere_cylinder
    "sphere_cylinder": ElementSpec(
        name="sphere_cylinder",
        digest="e2ddbb4f1987c0a5",
        doc="x = xp + R(lambda_b) centre\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\nturn = angular velocity of the sphere relative to the surface, on the triad; every slip along a direction d is\nless by sphere_radius turn.(n x d), n the normal to the sphere: that of the sphere's material point in contact\n(in a V groove it has two, with tangential1 and tangential2)\ndistance = |(yy, yz)| from the axle ex, (ny, nz) = (yy, yz)/distance\ngap = distance - radius - sphere_radius,  tangential = ny ydot_z - nz ydot_y,  axial = ydot_x\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows\naxes_ball: axes of the body of what touches, in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("b", "frame"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("centre", 3, "m", "centre of the sphere from p in the axes of its body"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("axial", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 14), tuple(range(14))),
                    OutputSpec("V", (2, 14), tuple(range(28))),
                ),
                577,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                703,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 14), tuple(range(42))),
                ),
                1305,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 14), tuple(range(42))),
                    OutputSpec("Psi_v", (3, 14), tuple(range(42))),
                ),
                3243,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), tuple(range(196))),
                ),
                3341,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                    OutputSpec("axes_ball", (3, 3), tuple(range(9)), unit="1"),
                ),
                184,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element sphere_plane
    "sphere_plane": ElementSpec(
        name="sphere_plane",
        digest="b312b10cf6db6c9d",
        doc="x = xp + R(lambda_b) centre\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\nturn = angular velocity of the sphere relative to the surface, on the triad; every slip along a direction d is\nless by sphere_radius turn.(n x d), n the normal to the sphere: that of the sphere's material point in contact\n(in a V groove it has two, with tangential1 and tangential2)\ngap = yz - sphere_radius, the plane is z = 0;  x = ydot_x,  y = ydot_y\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows\naxes_ball: axes of the body of what touches, in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("b", "frame"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("centre", 3, "m", "centre of the sphere from p in the axes of its body"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("x", "m/s", True),
            SlipSpec("y", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 14), tuple(range(14))),
                    OutputSpec("V", (2, 14), tuple(range(28))),
                ),
                493,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                557,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 14), tuple(range(42))),
                ),
                995,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 14), tuple(range(42))),
                    OutputSpec("Psi_v", (3, 14), tuple(range(42))),
                ),
                2389,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), (10, 11, 12, 13, 24, 25, 26, 27, 38, 39, 40, 41, 45, 46, 47, 48, 52, 53, 54, 55, 59, 60, 61, 62, 66, 67, 68, 69, 73, 74, 75, 76, 80, 81, 82, 83, 87, 88, 89, 90, 94, 95, 96, 97, 108, 109, 110, 111, 122, 123, 124, 125, 136, 137, 138, 139, 140, 141, 142, 143, 144, 145, 146, 147, 148, 149, 150, 151, 152, 153, 154, 155, 156, 157, 158, 159, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169, 170, 171, 172, 173, 174, 175, 176, 177, 178, 179, 180, 181, 182, 183, 184, 185, 186, 187, 188, 189, 190, 191, 192, 193, 194, 195)),
                ),
                1718,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                    OutputSpec("axes_ball", (3, 3), tuple(range(9)), unit="1"),
                ),
                153,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element sphere_v_groove
    "sphere_v_groove": ElementSpec(
        name="sphere_v_groove",
        digest="3811a7fed89eefb0",
        doc="x = xp + R(lambda_b) centre\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\nturn = angular velocity of the sphere relative to the surface, on the triad; every slip along a direction d is\nless by sphere_radius turn.(n x d), n the normal to the sphere: that of the sphere's material point in contact\n(in a V groove it has two, with tangential1 and tangential2)\ndistance = |(yy, yz)| from the axle ex, h = distance - radius - sphere_radius; two flanks of half the angle beta\ngap1 = h sin beta - yx cos beta,  gap2 = h sin beta + yx cos beta: both closed at h = 0 in the middle\ntangential as for a cylinder,  across1, across2 = hdot cos beta +- ydot_x sin beta, up the flanks\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows\naxes_ball: axes of the body of what touches, in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("b", "frame"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("centre", 3, "m", "centre of the sphere from p in the axes of its body"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("flank", 2, "1", "sine and cosine of half the opening angle of the flanks"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap1", "m", True, kind="gap"),
            DeformationSpec("gap2", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential1", "m/s", True),
            SlipSpec("across1", "m/s", True),
            SlipSpec("tangential2", "m/s", True),
            SlipSpec("across2", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (2,), (0, 1)),
                    OutputSpec("De", (2, 14), tuple(range(28))),
                    OutputSpec("V", (4, 14), tuple(range(56))),
                ),
                996,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (2,), (0, 1)),
                    OutputSpec("gs", (4,), (0, 1, 2, 3)),
                ),
                761,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (6, 14), tuple(range(84))),
                ),
                2067,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (6, 14), tuple(range(84))),
                    OutputSpec("Psi_v", (6, 14), tuple(range(84))),
                ),
                6570,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), tuple(range(196))),
                ),
                3179,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                    OutputSpec("axes_ball", (3, 3), tuple(range(9)), unit="1"),
                ),
                198,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element sphere_round_groove
    "sphere_round_groove": ElementSpec(
        name="sphere_round_groove",
        digest="7438a4313c27c6f1",
        doc="x = xp + R(lambda_b) centre\ntriad ex, ey, ez: columns of R(lambda o t)\ny = components of x - xc on the triad - offset, ydot = their rates as long as lambda.lambda = 1\nturn = angular velocity of the sphere relative to the surface, on the triad; every slip along a direction d is\nless by sphere_radius turn.(n x d), n the normal to the sphere: that of the sphere's material point in contact\n(in a V groove it has two, with tangential1 and tangential2)\nw = (radius + groove_radius - distance from the axle ex, yx), from the centre of the round bottom to the sphere\ngap = groove_radius - sphere_radius - n.w, n = w/|w| on the bottom, (sin beta, +-cos beta) on the flanks that\ncontinue it;  tangential as for a cylinder,  across = n_0 ydot_x + n_1 distancedot, along the groove's profile\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows\naxes_ball: axes of the body of what touches, in rows",
        source="textbook mechanics",
        nodes=(
            NodeSpec("p", "point"),
            NodeSpec("b", "frame"),
            NodeSpec("c", "point"),
            NodeSpec("r", "frame"),
        ),
        parameters=(
            ParameterSpec("centre", 3, "m", "centre of the sphere from p in the axes of its body"),
            ParameterSpec("t", 4, "1", "unit quaternion from the body frame to the surface's triad ex, ey, ez"),
            ParameterSpec("offset", 3, "m", "origin of the surface from the node c, on its triad"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("groove_radius", 1, "m", "radius of the groove's round bottom"),
            ParameterSpec("flank", 2, "1", "sine and cosine of half the opening angle of the flanks"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap", kinked=True),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
            SlipSpec("across", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 14), tuple(range(14))),
                    OutputSpec("V", (2, 14), tuple(range(28))),
                ),
                693,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (2,), (0, 1)),
                ),
                844,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (3, 14), tuple(range(42))),
                ),
                1606,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (3, 14), tuple(range(42))),
                    OutputSpec("Psi_v", (3, 14), tuple(range(42))),
                ),
                4118,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (14, 14), tuple(range(196))),
                ),
                4195,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("force", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("origin", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("axes", (3, 3), tuple(range(9)), unit="1"),
                    OutputSpec("axes_ball", (3, 3), tuple(range(9)), unit="1"),
                ),
                229,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element planar_cable
    "planar_cable": ElementSpec(
        name="planar_cable",
        digest="d1e9c0d74293400c",
        doc="r(s): cubic Hermite curve with slopes dp, dq = dr/ds by the undeformed arc length s at the ends\nstrain1 = L/l0 - 1, the mean of |r'| - 1 by 3 Gauss points;  strain2 = (|dq| - |dp|)/2;\nstrain3 = (|dq| + |dp|)/2 - L/l0:  |r'| - 1 = strain1 + strain2 P1 + strain3 P2, Legendre's polynomials\ncurvature = (r' x r'')/|r'|^2, the turn by undeformed arc length, at 3 Gauss points\nwork: EA l0 (1, 1/3, 1/5) times the strains, EI times curvature and Gauss weight (of sum l0)\nT = rhoA/2 int rdot.rdot ds (constant mass matrix),  U = -rhoA gravity.int r ds\narc_length, tension, strain, curvature at 3 Gauss points:\ntension = (sigma1 + 3 sigma2 P1 + 5 sigma3 P2)/l0,  strain = strain1 + strain2 P1 + strain3 P2,\ncurvature = its magnitude\nline: places on the curve",
        source="Gerstmayr and Irschik 2008, J. Sound Vib. 318:461 (strain and curvature); Gerstmayr and Shabana 2006, Nonlinear Dyn. 45:109 (cubic cable)",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("dp", "planar_slope"),
            NodeSpec("q", "planar_point"),
            NodeSpec("dq", "planar_slope"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("rhoA", 1, "kg/m", "mass per length", sign=("not negative",)),
            ParameterSpec("gravity", 2, "m/s^2", "acceleration of gravity"),
        ),
        deformations=(
            DeformationSpec("strain1", "1", True),
            DeformationSpec("strain2", "1", True),
            DeformationSpec("strain3", "1", True),
            DeformationSpec("curvature1", "1/m", True),
            DeformationSpec("curvature2", "1/m", True),
            DeformationSpec("curvature3", "1/m", True),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (6,), tuple(range(6))),
                    OutputSpec("De", (6, 8), (0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47)),
                    OutputSpec("V", (0, 8), ()),
                ),
                252,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (6,), tuple(range(6))),
                    OutputSpec("gs", (0,), ()),
                ),
                289,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (6, 8), (0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47)),
                ),
                455,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (6, 8), (0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47)),
                    OutputSpec("Psi_v", (6, 8), (0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47)),
                ),
                1030,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (8, 8), tuple(range(64))),
                ),
                650,
            ),
            "inertia": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("M", (8, 8), (0, 2, 4, 6, 9, 11, 13, 15, 16, 18, 20, 22, 25, 27, 29, 31, 32, 34, 36, 38, 41, 43, 45, 47, 48, 50, 52, 54, 57, 59, 61, 63)),
                    OutputSpec("h", (8,), ()),
                    OutputSpec("f", (8,), tuple(range(8))),
                    OutputSpec("U", (1,), (0,)),
                ),
                40,
            ),
            "tangent": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("R_x", (8, 8), ()),
                    OutputSpec("R_v", (8, 8), ()),
                ),
                0,
            ),
            "outputs": KernelSpec(
                ("x", "e", "sigma", "tau", "p"),
                (
                    OutputSpec("arc_length", (3,), (0, 1, 2), unit="m"),
                    OutputSpec("tension", (3,), (0, 1, 2), unit="N"),
                    OutputSpec("strain", (3,), (0, 1, 2), unit="1"),
                    OutputSpec("curvature", (3,), (0, 1, 2), unit="1/m"),
                    OutputSpec("line", (9, 2), tuple(range(18)), unit="m", draws="rope"),
                ),
                132,
            ),
        },
        family="cable",
        picture="rope",
        span="planar_cable_span",
    ),
    # element planar_slope_clamp
    "planar_slope_clamp": ElementSpec(
        name="planar_slope_clamp",
        digest="1f88e7ec809e9cf8",
        doc="ex, ey: directions at angle + alpha0;  across = ey.d",
        source="planar counterpart of slope_clamp",
        nodes=(
            NodeSpec("r", "planar_angle"),
            NodeSpec("d", "planar_slope"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
        ),
        deformations=(
            DeformationSpec("across", "1", False),
        ),
        slips=(),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 3), (0, 1, 2)),
                    OutputSpec("V", (0, 3), ()),
                ),
                11,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (0,), ()),
                ),
                15,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (1, 3), (0, 1, 2)),
                ),
                14,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (1, 3), (0, 1, 2)),
                    OutputSpec("Psi_v", (1, 3), (0, 1, 2)),
                ),
                40,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (3, 3), (0, 1, 2, 3, 6)),
                ),
                12,
            ),
        },
        family="clamp",
    ),
    # element planar_cable_span
    "planar_cable_span": ElementSpec(
        name="planar_cable_span",
        digest="0d6a34fcdefb0998",
        doc="l0 ((vp + vq)/2 + l0 (dpdot - dqdot)/12), rate of the integral of position over a cable's cubic curve",
        source="textbook mechanics (consistent nodal forces)",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("dp", "planar_slope"),
            NodeSpec("q", "planar_point"),
            NodeSpec("dq", "planar_slope"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
        ),
        deformations=(),
        slips=(
            SlipSpec("x", "m^2/s", True),
            SlipSpec("y", "m^2/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (0,), ()),
                    OutputSpec("De", (0, 8), ()),
                    OutputSpec("V", (2, 8), (0, 2, 4, 6, 9, 11, 13, 15)),
                ),
                4,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (0,), ()),
                    OutputSpec("gs", (2,), ()),
                ),
                0,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 8), ()),
                ),
                0,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 8), ()),
                    OutputSpec("Psi_v", (2, 8), ()),
                ),
                0,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (8, 8), ()),
                ),
                0,
            ),
        },
        family="span",
    ),
    # element planar_cable_circle
    "planar_cable_circle": ElementSpec(
        name="planar_cable_circle",
        digest="f046569926e26fd6",
        doc="x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\nh = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\nex, ey: directions at angle + alpha0\nw = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\na = x - xc - offset_x ex - offset_y ey\ngap = |a| - radius - rope_radius,  tangential = (ax wy - ay wx)/|a|, counterclockwise\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="planar counterpart of contact in space",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("dp", "planar_slope"),
            NodeSpec("q", "planar_point"),
            NodeSpec("dq", "planar_slope"),
            NodeSpec("c", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("xi", 1, "1", "place along the element, from 0 at p to 1 at q"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("offset", 2, "m", "origin of the circle or line from c, on ex and ey"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("rope_radius", 1, "m", "outer radius of the rope"),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 11), tuple(range(11))),
                    OutputSpec("V", (1, 11), tuple(range(11))),
                ),
                115,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (1,), (0,)),
                ),
                186,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 11), tuple(range(22))),
                ),
                258,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 11), tuple(range(22))),
                    OutputSpec("Psi_v", (2, 11), tuple(range(22))),
                ),
                635,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (11, 11), tuple(range(121))),
                ),
                812,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (2,), (0, 1), unit="m"),
                    OutputSpec("force", (2,), (0, 1), unit="N"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                80,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element planar_cable_line
    "planar_cable_line": ElementSpec(
        name="planar_cable_line",
        digest="26dd4499ad052791",
        doc="x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,\nh = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes\nex, ey: directions at angle + alpha0\nw = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\ngap = ey.(x - xc) - offset_y - rope_radius,  tangential = ex.w\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="planar counterpart of contact in space",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("dp", "planar_slope"),
            NodeSpec("q", "planar_point"),
            NodeSpec("dq", "planar_slope"),
            NodeSpec("c", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("xi", 1, "1", "place along the element, from 0 at p to 1 at q"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("offset", 2, "m", "origin of the circle or line from c, on ex and ey"),
            ParameterSpec("rope_radius", 1, "m", "outer radius of the rope"),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 11), tuple(range(11))),
                    OutputSpec("V", (1, 11), tuple(range(11))),
                ),
                93,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (1,), (0,)),
                ),
                146,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 11), tuple(range(22))),
                ),
                185,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 11), tuple(range(22))),
                    OutputSpec("Psi_v", (2, 11), tuple(range(22))),
                ),
                424,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (11, 11), (10, 21, 24, 25, 28, 29, 32, 35, 36, 39, 40, 43, 54, 65, 68, 69, 72, 73, 76, 79, 80, 83, 84, 87, 98, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119, 120)),
                ),
                258,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (2,), (0, 1), unit="m"),
                    OutputSpec("force", (2,), (0, 1), unit="N"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                61,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element planar_point_circle
    "planar_point_circle": ElementSpec(
        name="planar_point_circle",
        digest="c54e052906f0b4d4",
        doc="x: place of p\nex, ey: directions at angle + alpha0\nw = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\na = x - xc - offset_x ex - offset_y ey\ngap = |a| - radius - sphere_radius,  tangential = (ax wy - ay wx)/|a|, counterclockwise\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="planar counterpart of contact in space",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("c", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("offset", 2, "m", "origin of the circle or line from c, on ex and ey"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 5), tuple(range(5))),
                    OutputSpec("V", (1, 5), tuple(range(5))),
                ),
                37,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (1,), (0,)),
                ),
                73,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 5), tuple(range(10))),
                ),
                97,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 5), tuple(range(10))),
                    OutputSpec("Psi_v", (2, 5), tuple(range(10))),
                ),
                261,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (5, 5), tuple(range(25))),
                ),
                118,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (2,), (0, 1), unit="m"),
                    OutputSpec("force", (2,), (0, 1), unit="N"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                33,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element planar_point_line
    "planar_point_line": ElementSpec(
        name="planar_point_line",
        digest="13e92c3358685f5a",
        doc="x: place of p\nex, ey: directions at angle + alpha0\nw = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\ngap = ey.(x - xc) - offset_y - sphere_radius,  tangential = ex.w\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows",
        source="planar counterpart of contact in space",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("c", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("offset", 2, "m", "origin of the circle or line from c, on ex and ey"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 5), tuple(range(5))),
                    OutputSpec("V", (1, 5), tuple(range(5))),
                ),
                17,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (1,), (0,)),
                ),
                32,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 5), tuple(range(10))),
                ),
                23,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 5), tuple(range(10))),
                    OutputSpec("Psi_v", (2, 5), tuple(range(10))),
                ),
                68,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (5, 5), (4, 9, 14, 19, 20, 21, 22, 23, 24)),
                ),
                17,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (2,), (0, 1), unit="m"),
                    OutputSpec("force", (2,), (0, 1), unit="N"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                20,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element planar_disc_circle
    "planar_disc_circle": ElementSpec(
        name="planar_disc_circle",
        digest="0ba88eba3b1818c7",
        doc="x = xp + R(angle_b) centre\nex, ey: directions at angle + alpha0\nw = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\nturn = angular velocity of the disc relative to the surface\na = x - xc - offset_x ex - offset_y ey\ngap = |a| - radius - sphere_radius,  tangential = (ax wy - ay wx)/|a| - sphere_radius turn, counterclockwise\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows\naxes_ball: axes of the body of what touches, in rows",
        source="planar counterpart of contact in space",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("b", "planar_angle"),
            NodeSpec("c", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("centre", 2, "m", "centre of the disc from p in the axes of its body"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("offset", 2, "m", "origin of the circle or line from c, on ex and ey"),
            ParameterSpec("radius", 1, "m", "radius at which the rope's or sphere's surface touches, about the axle ex"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 6), tuple(range(6))),
                    OutputSpec("V", (1, 6), tuple(range(6))),
                ),
                50,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (1,), (0,)),
                ),
                113,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 6), tuple(range(12))),
                ),
                153,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 6), tuple(range(12))),
                    OutputSpec("Psi_v", (2, 6), tuple(range(12))),
                ),
                404,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), tuple(range(36))),
                ),
                189,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (2,), (0, 1), unit="m"),
                    OutputSpec("force", (2,), (0, 1), unit="N"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                    OutputSpec("axes_ball", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                44,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # element planar_disc_line
    "planar_disc_line": ElementSpec(
        name="planar_disc_line",
        digest="dcef7379ea005818",
        doc="x = xp + R(angle_b) centre\nex, ey: directions at angle + alpha0\nw = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body\nturn = angular velocity of the disc relative to the surface\ngap = ey.(x - xc) - offset_y - sphere_radius,  tangential = ex.w + sphere_radius turn\nplace: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows\naxes_ball: axes of the body of what touches, in rows",
        source="planar counterpart of contact in space",
        nodes=(
            NodeSpec("p", "planar_point"),
            NodeSpec("b", "planar_angle"),
            NodeSpec("c", "planar_point"),
            NodeSpec("r", "planar_angle"),
        ),
        parameters=(
            ParameterSpec("centre", 2, "m", "centre of the disc from p in the axes of its body"),
            ParameterSpec("alpha0", 1, "rad", "initial direction of the element minus the angle of node p"),
            ParameterSpec("offset", 2, "m", "origin of the circle or line from c, on ex and ey"),
            ParameterSpec("sphere_radius", 1, "m", "radius of the sphere; 0: a point", sign=("not negative",)),
        ),
        deformations=(
            DeformationSpec("gap", "m", True, kind="gap"),
        ),
        slips=(
            SlipSpec("tangential", "m/s", True),
        ),
        kernels={
            "position": KernelSpec(
                ("x", "p"),
                (
                    OutputSpec("e", (1,), (0,)),
                    OutputSpec("De", (1, 6), tuple(range(6))),
                    OutputSpec("V", (1, 6), tuple(range(6))),
                ),
                35,
            ),
            "acceleration": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("g", (1,), (0,)),
                    OutputSpec("gs", (1,), (0,)),
                ),
                73,
            ),
            "rates": KernelSpec(
                ("x", "v", "p"),
                (
                    OutputSpec("Phi_x", (2, 6), tuple(range(12))),
                ),
                65,
            ),
            "kinematics": KernelSpec(
                ("x", "v", "a", "p"),
                (
                    OutputSpec("Psi_x", (2, 6), tuple(range(12))),
                    OutputSpec("Psi_v", (2, 6), tuple(range(12))),
                ),
                183,
            ),
            "stiffness": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("K", (6, 6), (5, 11, 14, 17, 23, 29, 30, 31, 32, 33, 34, 35)),
                ),
                41,
            ),
            "outputs": KernelSpec(
                ("x", "sigma", "tau", "p"),
                (
                    OutputSpec("place", (2,), (0, 1), unit="m"),
                    OutputSpec("force", (2,), (0, 1), unit="N"),
                    OutputSpec("origin", (2,), (0, 1), unit="m"),
                    OutputSpec("axes", (2, 2), (0, 1, 2, 3), unit="1"),
                    OutputSpec("axes_ball", (2, 2), (0, 1, 2, 3), unit="1"),
                ),
                31,
            ),
        },
        family="contact",
        picture="contact",
    ),
    # end
}

LAWS: dict[str, LawSpec] = {
    # law linear_1
    "linear_1": LawSpec(
        name="linear_1",
        digest="c9cb37880850cb4e",
        doc="sigma = preload + S e + D ed\nenergy = preload.e + e.S e/2",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("preload", 1, "N or N m", "stress at zero deformation"),
            ParameterSpec("S", 1, "N/m or N m", "stiffness, upper triangle, row by row", sign=("semidefinite",)),
            ParameterSpec("D", 1, "N s/m or N m s", "damping, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                10,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0, 1)),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("e_0"),
        ),
    ),
    # law linear_2
    "linear_2": LawSpec(
        name="linear_2",
        digest="c9cb37880850cb4e",
        doc="sigma = preload + S e + D ed\nenergy = preload.e + e.S e/2",
        deformations=2,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("preload", 2, "N or N m", "stress at zero deformation"),
            ParameterSpec("S", 3, "N/m or N m", "stiffness, upper triangle, row by row", sign=("semidefinite",)),
            ParameterSpec("D", 3, "N s/m or N m s", "damping, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (2,), (0, 1)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                39,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 4), tuple(range(8))),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("e_0"),
            ArgumentSpec("e_1"),
        ),
    ),
    # law linear_3
    "linear_3": LawSpec(
        name="linear_3",
        digest="c9cb37880850cb4e",
        doc="sigma = preload + S e + D ed\nenergy = preload.e + e.S e/2",
        deformations=3,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("preload", 3, "N or N m", "stress at zero deformation"),
            ParameterSpec("S", 6, "N/m or N m", "stiffness, upper triangle, row by row", sign=("semidefinite",)),
            ParameterSpec("D", 6, "N s/m or N m s", "damping, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (3,), (0, 1, 2)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                77,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (3, 6), tuple(range(18))),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("e_0"),
            ArgumentSpec("e_1"),
            ArgumentSpec("e_2"),
        ),
    ),
    # law linear_4
    "linear_4": LawSpec(
        name="linear_4",
        digest="c9cb37880850cb4e",
        doc="sigma = preload + S e + D ed\nenergy = preload.e + e.S e/2",
        deformations=4,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("preload", 4, "N or N m", "stress at zero deformation"),
            ParameterSpec("S", 10, "N/m or N m", "stiffness, upper triangle, row by row", sign=("semidefinite",)),
            ParameterSpec("D", 10, "N s/m or N m s", "damping, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (4,), (0, 1, 2, 3)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                127,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (4, 8), tuple(range(32))),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("e_0"),
            ArgumentSpec("e_1"),
            ArgumentSpec("e_2"),
            ArgumentSpec("e_3"),
        ),
    ),
    # law linear_5
    "linear_5": LawSpec(
        name="linear_5",
        digest="c9cb37880850cb4e",
        doc="sigma = preload + S e + D ed\nenergy = preload.e + e.S e/2",
        deformations=5,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("preload", 5, "N or N m", "stress at zero deformation"),
            ParameterSpec("S", 15, "N/m or N m", "stiffness, upper triangle, row by row", sign=("semidefinite",)),
            ParameterSpec("D", 15, "N s/m or N m s", "damping, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (5,), tuple(range(5))),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                189,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (5, 10), tuple(range(50))),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("e_0"),
            ArgumentSpec("e_1"),
            ArgumentSpec("e_2"),
            ArgumentSpec("e_3"),
            ArgumentSpec("e_4"),
        ),
    ),
    # law linear_6
    "linear_6": LawSpec(
        name="linear_6",
        digest="c9cb37880850cb4e",
        doc="sigma = preload + S e + D ed\nenergy = preload.e + e.S e/2",
        deformations=6,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("preload", 6, "N or N m", "stress at zero deformation"),
            ParameterSpec("S", 21, "N/m or N m", "stiffness, upper triangle, row by row", sign=("semidefinite",)),
            ParameterSpec("D", 21, "N s/m or N m s", "damping, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (6,), tuple(range(6))),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                263,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (6, 12), tuple(range(72))),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("e_0"),
            ArgumentSpec("e_1"),
            ArgumentSpec("e_2"),
            ArgumentSpec("e_3"),
            ArgumentSpec("e_4"),
            ArgumentSpec("e_5"),
        ),
    ),
    # law viscous_1
    "viscous_1": LawSpec(
        name="viscous_1",
        digest="c9cb37880850cb4e",
        doc="tau = C s",
        deformations=0,
        slips=1,
        states=(),
        parameters=(
            ParameterSpec("C", 1, "N s/m or N m s", "viscosity, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (0,), ()),
                    OutputSpec("tau", (1,), (0,)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                2,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 1), (0,)),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("s_0"),
        ),
    ),
    # law viscous_2
    "viscous_2": LawSpec(
        name="viscous_2",
        digest="c9cb37880850cb4e",
        doc="tau = C s",
        deformations=0,
        slips=2,
        states=(),
        parameters=(
            ParameterSpec("C", 3, "N s/m or N m s", "viscosity, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (0,), ()),
                    OutputSpec("tau", (2,), (0, 1)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                9,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 2), (0, 1, 2, 3)),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("s_0"),
            ArgumentSpec("s_1"),
        ),
    ),
    # law viscous_3
    "viscous_3": LawSpec(
        name="viscous_3",
        digest="c9cb37880850cb4e",
        doc="tau = C s",
        deformations=0,
        slips=3,
        states=(),
        parameters=(
            ParameterSpec("C", 6, "N s/m or N m s", "viscosity, upper triangle, row by row", sign=("semidefinite",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (0,), ()),
                    OutputSpec("tau", (3,), (0, 1, 2)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                20,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (3, 3), tuple(range(9))),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("s_0"),
            ArgumentSpec("s_1"),
            ArgumentSpec("s_2"),
        ),
    ),
    # law beam_extension
    "beam_extension": LawSpec(
        name="beam_extension",
        digest="c9cb37880850cb4e",
        doc="sigma = EA/l0 (e - initial_strain l0 + damping ed),  e: the beam's elongation\nenergy = EA/l0 e (e/2 - initial_strain l0)",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("EA", 1, "N", "axial stiffness", sign=("positive",)),
            ParameterSpec("initial_strain", 1, "1", "elongation per length of the unstressed beam"),
            ParameterSpec("damping", 1, "s", "ratio of damping to stiffness", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                15,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0, 1)),
                ),
                3,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
        ),
    ),
    # law beam_torsion
    "beam_torsion": LawSpec(
        name="beam_torsion",
        digest="c9cb37880850cb4e",
        doc="sigma = GJ/l0^3 (e - initial_twist l0^2 + damping ed),  e: l0 times the angle of twist\nenergy = GJ/l0^3 e (e/2 - initial_twist l0^2)",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("GJ", 1, "N m^2", "torsional stiffness", sign=("positive",)),
            ParameterSpec("initial_twist", 1, "1/m", "twist of the unstressed beam"),
            ParameterSpec("damping", 1, "s", "ratio of damping to stiffness", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                18,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0, 1)),
                ),
                5,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
        ),
    ),
    # law beam_bending
    "beam_bending": LawSpec(
        name="beam_bending",
        digest="c9cb37880850cb4e",
        doc="e_0, e_1: the beam's two deformations of bending in one plane, at p and at q\nP = 0,  k = EI/((1 + P) l0^3),  r = initial_curvature l0^2/2,  d_i = e_i - r + damping ed_i\nsigma = k ((4 + P) d_0 + (P - 2) d_1, (P - 2) d_0 + (4 + P) d_1)\nenergy: the same form of e_i - r, less its value at e_i = 0",
        deformations=2,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("EI", 1, "N m^2", "bending stiffness", sign=("positive",)),
            ParameterSpec("initial_curvature", 1, "1/m", "curvature of the unstressed beam"),
            ParameterSpec("damping", 1, "s", "ratio of damping to stiffness", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (2,), (0, 1)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                46,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 4), tuple(range(8))),
                ),
                11,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("e_1", unit="m"),
        ),
    ),
    # law beam_shear_bending
    "beam_shear_bending": LawSpec(
        name="beam_shear_bending",
        digest="c9cb37880850cb4e",
        doc="e_0, e_1: the beam's two deformations of bending in one plane, at p and at q\nP = 12 EI/(GA l0^2),  k = EI/((1 + P) l0^3),  r = initial_curvature l0^2/2,  d_i = e_i - r + damping ed_i\nsigma = k ((4 + P) d_0 + (P - 2) d_1, (P - 2) d_0 + (4 + P) d_1)\nenergy: the same form of e_i - r, less its value at e_i = 0",
        deformations=2,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("EI", 1, "N m^2", "bending stiffness", sign=("positive",)),
            ParameterSpec("GA", 1, "N", "shear stiffness k G A", sign=("positive",)),
            ParameterSpec("initial_curvature", 1, "1/m", "curvature of the unstressed beam"),
            ParameterSpec("damping", 1, "s", "ratio of damping to stiffness", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (2,), (0, 1)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                60,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 4), tuple(range(8))),
                ),
                17,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("e_1", unit="m"),
        ),
    ),
    # law beam_bimoment
    "beam_bimoment": LawSpec(
        name="beam_bimoment",
        digest="c9cb37880850cb4e",
        doc="e_0, e_1: the beam's two deformations of warping, at p and at q;  d_i = e_i + damping ed_i\nsigma_i = GJ/(30 l0^3) (4 d_i - d_j) + 2 EIw/l0^5 (2 d_i + d_j),  j: the other one\nenergy: the same form of e_i, halved",
        deformations=2,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("GJ", 1, "N m^2", "torsional stiffness", sign=("positive",)),
            ParameterSpec("EIw", 1, "N m^4", "warping stiffness", sign=("positive",)),
            ParameterSpec("damping", 1, "s", "ratio of damping to stiffness", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (2,), (0, 1)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                51,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 4), tuple(range(8))),
                ),
                15,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("e_1", unit="m"),
        ),
    ),
    # law planar_cable_stiffness
    "planar_cable_stiffness": LawSpec(
        name="planar_cable_stiffness",
        digest="c9cb37880850cb4e",
        doc="sigma = EA l0 (1, 1/3, 1/5) (e + damping ed) of the strains,\nsigma = EI l0 (5, 8, 5)/18 (e + bending_damping ed) of the curvatures at the three points\nenergy = sum of EA l0 (1, 1/3, 1/5) e^2/2 and EI l0 (5, 8, 5)/18 e^2/2",
        deformations=6,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("EA", 1, "N", "axial stiffness", sign=("positive",)),
            ParameterSpec("EI", 1, "N m^2", "bending stiffness", sign=("not negative",)),
            ParameterSpec("damping", 1, "s", "ratio of damping to stiffness of stretching", sign=("not negative",)),
            ParameterSpec("bending_damping", 1, "s", "ratio of damping to stiffness of bending", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (6,), tuple(range(6))),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                76,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (6, 12), (0, 6, 13, 19, 26, 32, 39, 45, 52, 58, 65, 71)),
                ),
                12,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="1"),
            ArgumentSpec("e_1", unit="1"),
            ArgumentSpec("e_2", unit="1"),
            ArgumentSpec("e_3", unit="1/m"),
            ArgumentSpec("e_4", unit="1/m"),
            ArgumentSpec("e_5", unit="1/m"),
        ),
    ),
    # law cable_stiffness
    "cable_stiffness": LawSpec(
        name="cable_stiffness",
        digest="c9cb37880850cb4e",
        doc="sigma = EA l0 (1, 1/3, 1/5) (e + damping ed) of the strains,\nsigma = EI l0 (5, 8, 5)/18 (e + bending_damping ed) of the curvatures at the three points\nenergy = sum of EA l0 (1, 1/3, 1/5) e^2/2 and EI l0 (5, 8, 5)/18 e^2/2",
        deformations=12,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("l0", 1, "m", "undeformed length"),
            ParameterSpec("EA", 1, "N", "axial stiffness", sign=("positive",)),
            ParameterSpec("EI", 1, "N m^2", "bending stiffness", sign=("not negative",)),
            ParameterSpec("damping", 1, "s", "ratio of damping to stiffness of stretching", sign=("not negative",)),
            ParameterSpec("bending_damping", 1, "s", "ratio of damping to stiffness of bending", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (12,), tuple(range(12))),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                136,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (12, 24), (0, 12, 25, 37, 50, 62, 75, 87, 100, 112, 125, 137, 150, 162, 175, 187, 200, 212, 225, 237, 250, 262, 275, 287)),
                ),
                12,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="1"),
            ArgumentSpec("e_1", unit="1"),
            ArgumentSpec("e_2", unit="1"),
            ArgumentSpec("e_3", unit="1/m"),
            ArgumentSpec("e_4", unit="1/m"),
            ArgumentSpec("e_5", unit="1/m"),
            ArgumentSpec("e_6", unit="1/m"),
            ArgumentSpec("e_7", unit="1/m"),
            ArgumentSpec("e_8", unit="1/m"),
            ArgumentSpec("e_9", unit="1/m"),
            ArgumentSpec("e_10", unit="1/m"),
            ArgumentSpec("e_11", unit="1/m"),
        ),
    ),
    # law spring_curve
    "spring_curve": LawSpec(
        name="spring_curve",
        digest="c9cb37880850cb4e",
        doc="y = x - origin, sum of c_i y^i in the piece in which x lies (x < next break), end pieces beyond\nsigma = that sum with x = e;  energy = its integral",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("breaks", 15, "m or m/s", "where the next piece begins; rising, unused ones very large"),
            ParameterSpec("origins", 16, "m or m/s", "from where the powers of each piece are counted"),
            ParameterSpec("coefficients", 80, "N, N/m, ...", "of each piece, rising powers"),
            ParameterSpec("stored", 16, "J", "energy at the origin of each piece"),
            ParameterSpec("kinks", 15, "m or m/s", "breaks at which the slope jumps, where steps end; unused ones very large"),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                152,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0,)),
                ),
                101,
            ),
        },
        begins=(
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 0, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 1, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 2, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 3, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 4, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 5, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 6, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 7, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 8, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 9, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 10, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 11, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 12, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 13, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("kinks", 14, 1),)),)),
        ),
        arguments=(
            ArgumentSpec("e"),
        ),
    ),
    # law damper_curve
    "damper_curve": LawSpec(
        name="damper_curve",
        digest="c9cb37880850cb4e",
        doc="y = x - origin, sum of c_i y^i in the piece in which x lies (x < next break), end pieces beyond\nsigma = that sum with x = the rate of e",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("breaks", 15, "m or m/s", "where the next piece begins; rising, unused ones very large"),
            ParameterSpec("origins", 16, "m or m/s", "from where the powers of each piece are counted"),
            ParameterSpec("coefficients", 80, "N, N/m, ...", "of each piece, rising powers"),
            ParameterSpec("kinks", 15, "m or m/s", "breaks at which the slope jumps, where steps end; unused ones very large"),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                115,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (1,)),
                ),
                101,
            ),
        },
        begins=(
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 0, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 1, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 2, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 3, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 4, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 5, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 6, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 7, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 8, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 9, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 10, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 11, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 12, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 13, 1),)),)),
            BeginSpec((), (TermSpec(1.0),), (TermSpec(-1.0, powers=(("kinks", 14, 1),)),)),
        ),
        arguments=(
            ArgumentSpec("e"),
        ),
    ),
    # law stop
    "stop": LawSpec(
        name="stop",
        digest="c9cb37880850cb4e",
        doc="depth = max(0, e - gap);  sigma = stiffness depth max(0, 1 + damping edot), never pulling",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("gap", 1, "m or rad", "deformation at which it is touched"),
            ParameterSpec("stiffness", 1, "N/m or N m/rad", "stiffness once touched", sign=("not negative",)),
            ParameterSpec("damping", 1, "s/m or s/rad", "loss relative to the elastic force, for unit rate", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                14,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0, 1)),
                ),
                14,
            ),
        },
        begins=(
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("gap", 0, 1),)),)),
        ),
        arguments=(
            ArgumentSpec("e"),
        ),
    ),
    # law vertical_tyre
    "vertical_tyre": LawSpec(
        name="vertical_tyre",
        digest="c9cb37880850cb4e",
        doc="sigma = Fz\nFz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m", "vertical stiffness", sign=("not negative",)),
            ParameterSpec("damping", 1, "N s/m", "vertical damping while the tyre is pressed", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                13,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0, 1)),
                ),
                9,
            ),
        },
        begins=(
            BeginSpec((TermSpec(1.0),), (), ()),
            BeginSpec((TermSpec(1.0, powers=(("stiffness", 0, 1),)),), (TermSpec(1.0, powers=(("damping", 0, 1),)),), ()),
        ),
        arguments=(
            ArgumentSpec("deflection", unit="m"),
        ),
    ),
    # law linear_tyre
    "linear_tyre": LawSpec(
        name="linear_tyre",
        digest="c9cb37880850cb4e",
        doc="Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0\nslip angle alpha = atan(sideways/max(|forward|, standstill)), of the wheel's centre\ntau(lateral) = -fade Fy, tau(spin) = -fade Mz;  fade = 3 u^2 - 2 u^3, u = min(1, |forward|/standstill)\nFy = -cornering alpha - camber_stiffness camber while pressed, whatever the load;  Mz = -trail Fy",
        deformations=2,
        slips=4,
        states=(),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m", "vertical stiffness", sign=("not negative",)),
            ParameterSpec("damping", 1, "N s/m", "vertical damping while the tyre is pressed", sign=("not negative",)),
            ParameterSpec("cornering", 1, "N/rad", "cornering stiffness", sign=("not negative",)),
            ParameterSpec("camber_stiffness", 1, "N/rad", "camber stiffness"),
            ParameterSpec("trail", 1, "m", "pneumatic trail"),
            ParameterSpec("standstill", 1, "m/s", "forward speed below which side forces fade out", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (2,), (0,)),
                    OutputSpec("tau", (4,), (2, 3)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                37,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (6, 8), (0, 2, 33, 36, 37, 41, 44, 45)),
                ),
                65,
            ),
        },
        begins=(
            BeginSpec((TermSpec(1.0),), (), ()),
            BeginSpec((TermSpec(1.0, powers=(("stiffness", 0, 1),)),), (TermSpec(1.0, powers=(("damping", 0, 1),)),), ()),
        ),
        arguments=(
            ArgumentSpec("deflection", unit="m"),
            ArgumentSpec("camber", unit="rad"),
            ArgumentSpec("forward", unit="m/s"),
            ArgumentSpec("sideways", unit="m/s"),
            ArgumentSpec("lateral", unit="m/s"),
            ArgumentSpec("spin", unit="rad/s"),
        ),
    ),
    # law calspan_tyre
    "calspan_tyre": LawSpec(
        name="calspan_tyre",
        digest="c9cb37880850cb4e",
        doc="Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0\nslip angle alpha = atan(sideways/max(|forward|, standstill)), of the wheel's centre\ntau(lateral) = -fade Fy, tau(spin) = -fade Mz;  fade = 3 u^2 - 2 u^3, u = min(1, |forward|/standstill)\nF = min(Fz, A2): beyond the load A2 the data end, friction and stiffnesses keep their values there\nmu = SN (B1 F + B3 + B4 F^2),  C_alpha = A0 + A1 F (1 - F/A2),  C_gamma = A3 F (1 - F/A4)\nslip = -(C_alpha alpha + C_gamma camber)/(mu Fz), at most 3\nFy = mu Fz (slip - slip |slip|/3 + slip^3/27),  Mz = (AF1 Fz + AF2 |Fy|) Fy,  Fx = 0",
        deformations=2,
        slips=4,
        states=(),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m", "vertical stiffness", sign=("not negative",)),
            ParameterSpec("damping", 1, "N s/m", "vertical damping while the tyre is pressed", sign=("not negative",)),
            ParameterSpec("A", 5, "N/rad, 1/rad, N, 1/rad, N", "A0 ... A4: cornering and camber stiffness over the load", sign=("any", "any", "positive", "any", "not zero")),
            ParameterSpec("B", 3, "1/N, 1, 1/N^2", "B1, B3, B4: friction over the load", sign=("any", "positive", "any")),
            ParameterSpec("SN", 1, "1", "skid number of the road relative to that of the test", sign=("positive",)),
            ParameterSpec("AF", 2, "m/N", "AF1, AF2: aligning moment"),
            ParameterSpec("standstill", 1, "m/s", "forward speed below which side forces fade out", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (2,), (0,)),
                    OutputSpec("tau", (4,), (2, 3)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                75,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (6, 8), (0, 2, 32, 33, 34, 36, 37, 40, 41, 42, 44, 45)),
                ),
                179,
            ),
        },
        limit=LimitSpec("A", 2, "friction and stiffnesses keep their values beyond"),
        begins=(
            BeginSpec((TermSpec(1.0),), (), ()),
            BeginSpec((TermSpec(1.0, powers=(("stiffness", 0, 1),)),), (TermSpec(1.0, powers=(("damping", 0, 1),)),), ()),
            BeginSpec((TermSpec(1.0, powers=(("stiffness", 0, 1),)),), (TermSpec(1.0, powers=(("damping", 0, 1),)),), (TermSpec(-1.0, powers=(("A", 2, 1),)),)),
        ),
        arguments=(
            ArgumentSpec("deflection", unit="m"),
            ArgumentSpec("camber", unit="rad"),
            ArgumentSpec("forward", unit="m/s"),
            ArgumentSpec("sideways", unit="m/s"),
            ArgumentSpec("lateral", unit="m/s"),
            ArgumentSpec("spin", unit="rad/s"),
        ),
    ),
    # law magic_formula
    "magic_formula": LawSpec(
        name="magic_formula",
        digest="c9cb37880850cb4e",
        doc="Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0\nlx kappadot = Re rolling - forward - |forward| kappa\nly (tan alpha)dot = lateral - |forward| tan alpha,  lateral of the contact point\nmu = mu0 + mu1 min(1, Fz/Fz0 - 1),  Kx = kx Fz,  Ky = c1 Fz0 sin(2 atan(Fz/(c2 Fz0))),  Kg = kg Fz\nx = Kx kappa/(mu Fz),  y = (Ky tan alpha + Kg camber)/(mu Fz),  slip = |(x, y)|,  b = slip/C\n(Fx, Fy) = mu Fz sin(C atan(b - E (b - atan b))) (x, -y)/slip, combined slip by similarity\nMz = -t0 Fz/Fz0 cos(atan(B tan alpha)) Fy;  tau(longitudinal, lateral, spin) = -(Fx, Fy, Mz)",
        deformations=2,
        slips=5,
        states=(
            InternalSpec("kappa", "1"),
            InternalSpec("tan_alpha", "1"),
        ),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m", "vertical stiffness", sign=("not negative",)),
            ParameterSpec("damping", 1, "N s/m", "vertical damping while the tyre is pressed", sign=("not negative",)),
            ParameterSpec("load0", 1, "N", "nominal load Fz0", sign=("positive",)),
            ParameterSpec("rolling_radius", 1, "m", "effective radius of free rolling", sign=("positive",)),
            ParameterSpec("friction", 2, "1", "mu at the nominal load, and its change for one more nominal load", sign=("positive", "any")),
            ParameterSpec("slip_stiffness", 1, "1", "longitudinal stiffness Kx relative to the load", sign=("not negative",)),
            ParameterSpec("cornering", 2, "1", "largest cornering stiffness over load0, and the load of it over load0", sign=("not negative", "positive")),
            ParameterSpec("camber_stiffness", 1, "1/rad", "camber stiffness relative to the load"),
            ParameterSpec("shape", 2, "1", "C and E of the sine of the Magic Formula", sign=("positive", "any")),
            ParameterSpec("trail", 2, "m, 1", "pneumatic trail at the nominal load, and how it falls with the slip (B)"),
            ParameterSpec("relaxation", 2, "m", "relaxation lengths, longitudinal and lateral", sign=("positive", "positive")),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (2,), (0,)),
                    OutputSpec("tau", (5,), (2, 3, 4)),
                    OutputSpec("zd", (2,), (0, 1)),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                86,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (9, 11), (0, 2, 44, 45, 46, 53, 54, 55, 56, 57, 64, 65, 66, 67, 68, 75, 76, 81, 82, 86, 92, 95, 98)),
                ),
                205,
            ),
        },
        begins=(
            BeginSpec((TermSpec(1.0),), (), ()),
            BeginSpec((TermSpec(1.0, powers=(("stiffness", 0, 1),)),), (TermSpec(1.0, powers=(("damping", 0, 1),)),), ()),
            BeginSpec((TermSpec(1.0, powers=(("stiffness", 0, 1),)),), (TermSpec(1.0, powers=(("damping", 0, 1),)),), (TermSpec(-2.0, powers=(("load0", 0, 1),)),)),
        ),
        arguments=(
            ArgumentSpec("deflection", unit="m"),
            ArgumentSpec("camber", unit="rad"),
            ArgumentSpec("forward", unit="m/s"),
            ArgumentSpec("rolling", unit="rad/s"),
            ArgumentSpec("longitudinal", unit="m/s"),
            ArgumentSpec("lateral", unit="m/s"),
            ArgumentSpec("spin", unit="rad/s"),
        ),
    ),
    # law hertz
    "hertz": LawSpec(
        name="hertz",
        digest="c9cb37880850cb4e",
        doc="d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N\nenergy = stiffness d^(exponent + 1)/(exponent + 1)",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m^exponent", "normal force per penetration^exponent", sign=("not negative",)),
            ParameterSpec("exponent", 1, "1", "exponent of the penetration, 3/2 for Hertz, at least 1", sign=("at least one",)),
            ParameterSpec("dissipation", 1, "s/m", "relative growth of the normal force per speed of approach", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                30,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0, 1)),
                ),
                22,
            ),
        },
        arguments=(
            ArgumentSpec("e_0"),
        ),
    ),
    # law hertz_coulomb_1
    "hertz_coulomb_1": LawSpec(
        name="hertz_coulomb_1",
        digest="c9cb37880850cb4e",
        doc="d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N\nenergy = stiffness d^(exponent + 1)/(exponent + 1)\ntau = friction N s/sqrt(s.s + slip_speed^2)",
        deformations=1,
        slips=1,
        states=(),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m^exponent", "normal force per penetration^exponent", sign=("not negative",)),
            ParameterSpec("exponent", 1, "1", "exponent of the penetration, 3/2 for Hertz, at least 1", sign=("at least one",)),
            ParameterSpec("dissipation", 1, "s/m", "relative growth of the normal force per speed of approach", sign=("not negative",)),
            ParameterSpec("friction", 1, "1", "coefficient of friction", sign=("not negative",)),
            ParameterSpec("slip_speed", 1, "m/s", "speed of sliding at which 71 % of the friction acts", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (1,), (0,)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                40,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 3), (0, 1, 3, 4, 5)),
                ),
                43,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("s_0", unit="m/s"),
        ),
    ),
    # law hertz_coulomb_2
    "hertz_coulomb_2": LawSpec(
        name="hertz_coulomb_2",
        digest="c9cb37880850cb4e",
        doc="d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N\nenergy = stiffness d^(exponent + 1)/(exponent + 1)\ntau = friction N s/sqrt(s.s + slip_speed^2)",
        deformations=1,
        slips=2,
        states=(),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m^exponent", "normal force per penetration^exponent", sign=("not negative",)),
            ParameterSpec("exponent", 1, "1", "exponent of the penetration, 3/2 for Hertz, at least 1", sign=("at least one",)),
            ParameterSpec("dissipation", 1, "s/m", "relative growth of the normal force per speed of approach", sign=("not negative",)),
            ParameterSpec("friction", 1, "1", "coefficient of friction", sign=("not negative",)),
            ParameterSpec("slip_speed", 1, "m/s", "speed of sliding at which 71 % of the friction acts", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (2,), (0, 1)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                45,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (3, 4), (0, 1, 4, 5, 6, 7, 8, 9, 10, 11)),
                ),
                58,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("s_0", unit="m/s"),
            ArgumentSpec("s_1", unit="m/s"),
        ),
    ),
    # law hertz_bristle_1
    "hertz_bristle_1": LawSpec(
        name="hertz_bristle_1",
        digest="c9cb37880850cb4e",
        doc="d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N\nenergy = stiffness d^(exponent + 1)/(exponent + 1) + stiffness d^exponent bristle_stiffness z.z/2\ndz/dt = s - bristle_stiffness |s| z/friction in contact, -release z when open\ntau = N (bristle_stiffness z + bristle_damping dz/dt)",
        deformations=1,
        slips=1,
        states=(
            InternalSpec("z_0", "m", lasting=True),
        ),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m^exponent", "normal force per penetration^exponent", sign=("not negative",)),
            ParameterSpec("exponent", 1, "1", "exponent of the penetration, 3/2 for Hertz, at least 1", sign=("at least one",)),
            ParameterSpec("dissipation", 1, "s/m", "relative growth of the normal force per speed of approach", sign=("not negative",)),
            ParameterSpec("friction", 1, "1", "coefficient of friction", sign=("positive",)),
            ParameterSpec("bristle_stiffness", 1, "1/m", "friction per normal force and deflection of the bristles", sign=("not negative",)),
            ParameterSpec("bristle_damping", 1, "s/m", "friction per normal force and rate of deflection", sign=("not negative",)),
            ParameterSpec("release", 1, "1/s", "rate at which bristles straighten while the gap is open", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (1,), (0,)),
                    OutputSpec("zd", (1,), (0,)),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                60,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (3, 4), (0, 1, 4, 5, 6, 7, 10, 11)),
                ),
                61,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("s_0", unit="m/s"),
        ),
    ),
    # law hertz_bristle_2
    "hertz_bristle_2": LawSpec(
        name="hertz_bristle_2",
        digest="c9cb37880850cb4e",
        doc="d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N\nenergy = stiffness d^(exponent + 1)/(exponent + 1) + stiffness d^exponent bristle_stiffness z.z/2\ndz/dt = s - bristle_stiffness |s| z/friction in contact, -release z when open\ntau = N (bristle_stiffness z + bristle_damping dz/dt)",
        deformations=1,
        slips=2,
        states=(
            InternalSpec("z_0", "m", lasting=True),
            InternalSpec("z_1", "m", lasting=True),
        ),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m^exponent", "normal force per penetration^exponent", sign=("not negative",)),
            ParameterSpec("exponent", 1, "1", "exponent of the penetration, 3/2 for Hertz, at least 1", sign=("at least one",)),
            ParameterSpec("dissipation", 1, "s/m", "relative growth of the normal force per speed of approach", sign=("not negative",)),
            ParameterSpec("friction", 1, "1", "coefficient of friction", sign=("positive",)),
            ParameterSpec("bristle_stiffness", 1, "1/m", "friction per normal force and deflection of the bristles", sign=("not negative",)),
            ParameterSpec("bristle_damping", 1, "s/m", "friction per normal force and rate of deflection", sign=("not negative",)),
            ParameterSpec("release", 1, "1/s", "rate at which bristles straighten while the gap is open", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (2,), (0, 1)),
                    OutputSpec("zd", (2,), (0, 1)),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                77,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (5, 6), (0, 1, 6, 7, 8, 9, 10, 12, 13, 14, 15, 17, 20, 21, 22, 26, 27, 29)),
                ),
                94,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("s_0", unit="m/s"),
            ArgumentSpec("s_1", unit="m/s"),
        ),
    ),
    # law journal
    "journal": LawSpec(
        name="journal",
        digest="c9cb37880850cb4e",
        doc="N_i = stiffness e_i + damping ed_i in two directions (i = 0, 1), N = |(N_0, N_1)|\ntorque = friction_radius N w/sqrt(w^2 + slip_speed^2) on the angle e_2, w = ed_2",
        deformations=3,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("stiffness", 1, "N/m", "radial stiffness", sign=("not negative",)),
            ParameterSpec("damping", 1, "N s/m", "radial damping", sign=("not negative",)),
            ParameterSpec("friction_radius", 1, "m", "coefficient of friction times the radius of the journal", sign=("not negative",)),
            ParameterSpec("slip_speed", 1, "rad/s", "speed of turning at which 71 % of the friction acts", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (3,), (0, 1, 2)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                36,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (3, 6), (0, 3, 7, 10, 12, 13, 15, 16, 17)),
                ),
                39,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("e_1", unit="m"),
            ArgumentSpec("e_2", unit="rad"),
        ),
    ),
    # law friction
    "friction": LawSpec(
        name="friction",
        digest="c9cb37880850cb4e",
        doc="sigma = limit w/sqrt(w^2 + speed^2), w = edot",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("limit", 1, "N or N m", "friction of fast motion", sign=("not negative",)),
            ParameterSpec("speed", 1, "m/s or rad/s", "speed at which 71 % of the friction acts", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                8,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (1,)),
                ),
                10,
            ),
        },
        arguments=(
            ArgumentSpec("e"),
        ),
    ),
    # law slip_friction
    "slip_friction": LawSpec(
        name="slip_friction",
        digest="c9cb37880850cb4e",
        doc="tau = limit w/sqrt(w^2 + speed^2), w the slip",
        deformations=0,
        slips=1,
        states=(),
        parameters=(
            ParameterSpec("limit", 1, "N or N m", "friction of fast motion", sign=("not negative",)),
            ParameterSpec("speed", 1, "m/s or rad/s", "speed at which 71 % of the friction acts", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (0,), ()),
                    OutputSpec("tau", (1,), (0,)),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                8,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 1), (0,)),
                ),
                10,
            ),
        },
        arguments=(
            ArgumentSpec("s"),
        ),
    ),
    # law limits
    "limits": LawSpec(
        name="limits",
        digest="c9cb37880850cb4e",
        doc="above = max(0, e - high), below = max(0, low - e)\nsigma = stiffness (above max(0, 1 + damping edot) - below max(0, 1 - damping edot))",
        deformations=1,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("low", 1, "m or rad", "deformation at which the lower stop is touched"),
            ParameterSpec("high", 1, "m or rad", "deformation at which the upper stop is touched"),
            ParameterSpec("stiffness", 1, "N/m or N m/rad", "stiffness once touched", sign=("not negative",)),
            ParameterSpec("damping", 1, "s/m or s/rad", "loss relative to the elastic force, for unit rate", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                28,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 2), (0, 1)),
                ),
                26,
            ),
        },
        begins=(
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("low", 0, 1),)),)),
            BeginSpec((TermSpec(1.0),), (), (TermSpec(-1.0, powers=(("high", 0, 1),)),)),
        ),
        arguments=(
            ArgumentSpec("e"),
        ),
    ),
    # law loose_journal
    "loose_journal": LawSpec(
        name="loose_journal",
        digest="c9cb37880850cb4e",
        doc="r = |(e_0, e_1)|, depth = max(0, r - gap), N = stiffness depth max(0, 1 + damping dr/dt)\nsigma_i = N e_i/r (i = 0, 1);  torque = friction_radius N w/sqrt(w^2 + slip_speed^2) on e_2, w = ed_2",
        deformations=3,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("gap", 1, "m", "radial play as drawn", sign=("positive",)),
            ParameterSpec("stiffness", 1, "N/m or N m/rad", "stiffness once touched", sign=("not negative",)),
            ParameterSpec("damping", 1, "s/m or s/rad", "loss relative to the elastic force, for unit rate", sign=("not negative",)),
            ParameterSpec("friction_radius", 1, "m", "coefficient of friction times the radius of the journal", sign=("not negative",)),
            ParameterSpec("slip_speed", 1, "rad/s", "speed of turning at which 71 % of the friction acts", sign=("positive",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (3,), (0, 1, 2)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                45,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (3, 6), (0, 1, 3, 4, 6, 7, 9, 10, 12, 13, 15, 16, 17)),
                ),
                87,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("e_1", unit="m"),
            ArgumentSpec("e_2", unit="rad"),
        ),
    ),
    # law loose_ball
    "loose_ball": LawSpec(
        name="loose_ball",
        digest="c9cb37880850cb4e",
        doc="r = |(e_0, e_1, e_2)|, depth = max(0, r - gap), N = stiffness depth max(0, 1 + damping dr/dt)\nsigma_i = N e_i/r",
        deformations=3,
        slips=0,
        states=(),
        parameters=(
            ParameterSpec("gap", 1, "m", "radial play as drawn", sign=("positive",)),
            ParameterSpec("stiffness", 1, "N/m or N m/rad", "stiffness once touched", sign=("not negative",)),
            ParameterSpec("damping", 1, "s/m or s/rad", "loss relative to the elastic force, for unit rate", sign=("not negative",)),
        ),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (3,), (0, 1, 2)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (0,), ()),
                    OutputSpec("U", (1,), (0,)),
                    OutputSpec("P", (1,), (0,)),
                ),
                43,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (3, 6), tuple(range(18))),
                ),
                100,
            ),
        },
        arguments=(
            ArgumentSpec("e_0", unit="m"),
            ArgumentSpec("e_1", unit="m"),
            ArgumentSpec("e_2", unit="m"),
        ),
    ),
    # law held
    "held": LawSpec(
        name="held",
        digest="c9cb37880850cb4e",
        doc="sigma = -u, du/dt = 0",
        deformations=1,
        slips=0,
        states=(
            InternalSpec("u", "N or N m"),
        ),
        parameters=(),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (1,), (0,)),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (1,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                3,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 3), (2,)),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("e"),
        ),
    ),
    # law slip_held
    "slip_held": LawSpec(
        name="slip_held",
        digest="c9cb37880850cb4e",
        doc="tau = -u, du/dt = 0",
        deformations=0,
        slips=1,
        states=(
            InternalSpec("u", "N or N m"),
        ),
        parameters=(),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (0,), ()),
                    OutputSpec("tau", (1,), (0,)),
                    OutputSpec("zd", (1,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), (0,)),
                ),
                3,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (2, 2), (1,)),
                ),
                0,
            ),
        },
        arguments=(
            ArgumentSpec("s"),
        ),
    ),
    # law memory
    "memory": LawSpec(
        name="memory",
        digest="c9cb37880850cb4e",
        doc="dz/dt = 0, without a force",
        deformations=0,
        slips=0,
        states=(
            InternalSpec("z", "1"),
        ),
        parameters=(),
        kernels={
            "law": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("sigma", (0,), ()),
                    OutputSpec("tau", (0,), ()),
                    OutputSpec("zd", (1,), ()),
                    OutputSpec("U", (1,), ()),
                    OutputSpec("P", (1,), ()),
                ),
                0,
            ),
            "tangent": KernelSpec(
                ("e", "ed", "s", "z", "t", "p"),
                (
                    OutputSpec("J", (1, 1), ()),
                ),
                0,
            ),
        },
    ),
    # end
}
