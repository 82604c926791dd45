/* point_mass: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * T = mass v.v/2
 * U = -mass gravity.x
 * place: x
 *
 * Source: textbook mechanics
 *
 * x (3): p_x, p_y, p_z
 * e (0): none
 * s (0): none
 * p (4):
 *   mass (1) [kg]: mass
 *   gravity (3) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* inertia: 10 operations.
 * in:  x (3), v (3), p (4)
 * out: M (3,3), 3 of 9 entries, h (3), 0 of 3 entries, f (3), U (1) */
FLEXEL_CLONES
static void point_mass_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict M = out[0] + b * (3 * 8);
        real *restrict f = out[2] + b * (3 * 8);
        real *restrict U = out[3] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real mass = p[0 * 8 + j];
            M[0 * 8 + j] = M[1 * 8 + j] = M[2 * 8 + j] = mass; /* M(0,0) M(1,1) M(2,2) */
            const real gravity_x = p[1 * 8 + j];
            f[0 * 8 + j] = mass * gravity_x;
            const real gravity_y = p[2 * 8 + j];
            f[1 * 8 + j] = mass * gravity_y;
            const real gravity_z = p[3 * 8 + j];
            f[2 * 8 + j] = mass * gravity_z;
            const real p_z = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real t0 = mass * (p_x * gravity_x + p_y * gravity_y + p_z * gravity_z);
            U[0 * 8 + j] = -t0;
        }
    }
}

/* tangent: 0 operations.
 * in:  x (3), v (3), a (3), p (4)
 * out: R_x (3,3), 0 of 9 entries, R_v (3,3), 0 of 9 entries */
FLEXEL_CLONES
static void point_mass_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* outputs: 0 operations.
 * in:  x (3), sigma (0), tau (0), p (4)
 * out: place (3) */
FLEXEL_CLONES
static void point_mass_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        real *restrict place = out[0] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            place[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            place[1 * 8 + j] = p_y;
            const real p_z = x[2 * 8 + j];
            place[2 * 8 + j] = p_z;
        }
    }
}

const flexel_element flexel_point_mass = {
    .name = "point_mass",
    .digest = "c6e6cd112ed8b5ef",
    .n = 3,
    .m = 0,
    .k = 0,
    .np = 4,
    .inertia = point_mass_inertia,
    .tangent = point_mass_tangent,
    .outputs = point_mass_outputs,
};
