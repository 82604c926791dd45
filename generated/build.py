"""Builds the extension ``flexel.generated._kernels`` with cffi (API mode, one file for every Python 3).

Written by `flexel derive`; do not edit.
"""

import os

from cffi import FFI

FOLDER = os.path.dirname(__file__)
FLAGS = ["-O2", "-fno-math-errno", "-fno-trapping-math", "-fopenmp-simd", "-ffp-contract=off"]
ELEMENTS = (
    "point_mass",
    "body",
    "rotary_inertia",
    "norm",
    "truss",
    "hinge",
    "bearing",
    "beam3",
    "beam",
    "beam_first_order",
    "wheel",
    "surface",
    "toroidal_wheel",
    "tyre",
    "tyre_on_road",
    "axle_slip",
    "rotation",
    "body_rotation",
    "body_velocity",
    "bar_span",
    "beam_span",
    "planar_point_mass",
    "planar_body",
    "planar_rotary_inertia",
    "planar_truss",
    "planar_hinge",
    "planar_beam",
    "planar_beam_first_order",
    "planar_beam3",
    "planar_bearing",
    "planar_belt",
    "planar_gear",
    "planar_wheel",
    "planar_body_velocity",
    "planar_bar_span",
    "planar_beam_span",
    "cable",
    "slope_clamp",
    "cable_span",
    "cable_cylinder",
    "cable_plane",
    "cable_v_groove",
    "cable_round_groove",
    "planar_cable",
    "planar_slope_clamp",
    "planar_cable_span",
    "planar_cable_circle",
    "planar_cable_line",
)
LAWS = (
    "linear_1",
    "linear_2",
    "linear_3",
    "linear_4",
    "linear_5",
    "linear_6",
    "diagonal_7",
    "diagonal_13",
    "viscous_1",
    "viscous_2",
    "viscous_3",
    "spring_curve",
    "damper_curve",
    "stop",
    "vertical_tyre",
    "linear_tyre",
    "calspan_tyre",
    "magic_formula",
    "hertz",
    "hertz_coulomb_1",
    "hertz_coulomb_2",
    "hertz_bristle_1",
    "hertz_bristle_2",
    "journal",
)
SOURCES = [os.path.join(FOLDER, f"{name}.c") for name in (*ELEMENTS, "laws", "system", "blocks")]

DECLARATIONS = """
typedef void (*flexel_kernel)(size_t nblocks, const double *const *in, double *const *out);
typedef struct {
    const char *name, *digest;
    int n, m, k, np;
    flexel_kernel position, velocity, acceleration, inertia, rates, kinematics, stiffness, tangent;
} flexel_element;
typedef struct {
    const char *name, *digest;
    int m, k, nz, np;
    flexel_kernel law, tangent;
} flexel_law;
typedef struct {
    flexel_kernel kernel;
    size_t nblocks;
    const double *const *in;
    double *const *out;
} flexel_call;
void flexel_run(size_t n, const flexel_call *calls);
typedef struct {
    size_t nblocks;
    const size_t *start, *first, *column;
} flexel_form;
size_t flexel_factor_blocks(const flexel_form *form, double *diagonal, size_t *pivots);
void flexel_solve_blocks(const flexel_form *form, const double *diagonal, const size_t *pivots, const double *beside,
                         size_t n, double *x);
void flexel_solve_blocks_transposed(const flexel_form *form, const double *diagonal, const size_t *pivots,
                                    const double *beside, size_t n, double *x);
"""

ffibuilder = FFI()
ffibuilder.cdef(DECLARATIONS)
ffibuilder.cdef("".join(f"extern const flexel_element flexel_{name};\n" for name in ELEMENTS))
ffibuilder.cdef("".join(f"extern const flexel_law flexel_law_{name};\n" for name in LAWS))
ffibuilder.set_source(
    "flexel.generated._kernels",
    '#include "kernels.h"\n#include "blocks.h"',
    sources=SOURCES,
    depends=[os.path.join(FOLDER, name) for name in ("kernels.h", "blocks.h")],
    include_dirs=[FOLDER or "."],
    extra_compile_args=FLAGS,
    py_limited_api=True,
)

if __name__ == "__main__":
    ffibuilder.compile(verbose=True)
