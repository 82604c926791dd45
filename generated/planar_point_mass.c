/* planar_point_mass: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * T = mass v.v/2
 * U = -mass gravity.x
 * place: x
 *
 * Source: textbook mechanics
 *
 * x (2): p_x, p_y
 * e (0): none
 * s (0): none
 * p (3):
 *   mass (1) [kg]: mass
 *   gravity (2) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* inertia: 7 operations.
 * in:  x (2), v (2), p (3)
 * out: M (2,2), 2 of 4 entries, h (2), 0 of 2 entries, f (2), U (1) */
FLEXEL_CLONES
static void planar_point_mass_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (2 * 8);
        const real *restrict p = in[2] + b * (3 * 8);
        real *restrict M = out[0] + b * (2 * 8);
        real *restrict f = out[2] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real mass = p[0 * 8 + j];
            M[0 * 8 + j] = M[1 * 8 + j] = mass; /* M(0,0) M(1,1) */
            const real gravity_x = p[1 * 8 + j];
            f[0 * 8 + j] = mass * gravity_x;
            const real gravity_y = p[2 * 8 + j];
            f[1 * 8 + j] = mass * gravity_y;
            const real p_x = x[0 * 8 + j];
            const real p_y = x[1 * 8 + j];
            U[0 * 8 + j] = -(mass * (p_x * gravity_x + p_y * gravity_y));
        }
    }
}

/* tangent: 0 operations.
 * in:  x (2), v (2), a (2), p (3)
 * out: R_x (2,2), 0 of 4 entries, R_v (2,2), 0 of 4 entries */
FLEXEL_CLONES
static void planar_point_mass_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* outputs: 0 operations.
 * in:  x (2), sigma (0), tau (0), p (3)
 * out: place (2) */
FLEXEL_CLONES
static void planar_point_mass_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (2 * 8);
        real *restrict place = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            place[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            place[1 * 8 + j] = p_y;
        }
    }
}

const flexel_element flexel_planar_point_mass = {
    .name = "planar_point_mass",
    .digest = "bde70fc4ce29a2a0",
    .n = 2,
    .m = 0,
    .k = 0,
    .np = 3,
    .inertia = planar_point_mass_inertia,
    .tangent = planar_point_mass_tangent,
    .outputs = planar_point_mass_outputs,
};
