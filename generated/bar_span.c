/* bar_span: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * (x, y, z) = l0 (vp + vq)/2, rate of the integral of position over a straight bar
 *
 * Source: textbook mechanics (consistent nodal forces)
 *
 * x (6): p_x, p_y, p_z, q_x, q_y, q_z
 * e (0): none
 * s (3): x [m^2/s], y [m^2/s], z [m^2/s]
 * p (1):
 *   l0 (1) [m]: undeformed length */
#include "kernels.h"

/* position: 1 operations.
 * in:  x (6), p (1)
 * out: e (0), De (0,6), V (3,6), 6 of 18 entries */
FLEXEL_CLONES
static void bar_span_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[1] + b * (1 * 8);
        real *restrict V = out[2] + b * (6 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            V[0 * 8 + j] = V[1 * 8 + j] = V[2 * 8 + j] = V[3 * 8 + j] = V[4 * 8 + j] = V[5 * 8 + j] = 0.5 * l0;
                /* V(0,0) V(0,3) V(1,1) V(1,4) V(2,2) V(2,5) */
        }
    }
}

/* acceleration: 0 operations.
 * in:  x (6), v (6), p (1)
 * out: g (0), gs (3), 0 of 3 entries */
FLEXEL_CLONES
static void bar_span_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* rates: 0 operations.
 * in:  x (6), v (6), p (1)
 * out: Phi_x (3,6), 0 of 18 entries */
FLEXEL_CLONES
static void bar_span_rates(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* kinematics: 0 operations.
 * in:  x (6), v (6), a (6), p (1)
 * out: Psi_x (3,6), 0 of 18 entries, Psi_v (3,6), 0 of 18 entries */
FLEXEL_CLONES
static void bar_span_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* stiffness: 0 operations.
 * in:  x (6), sigma (0), tau (3), p (1)
 * out: K (6,6), 0 of 36 entries */
FLEXEL_CLONES
static void bar_span_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_bar_span = {
    .name = "bar_span",
    .digest = "b2403969448b569b",
    .n = 6,
    .m = 0,
    .k = 3,
    .np = 1,
    .position = bar_span_position,
    .acceleration = bar_span_acceleration,
    .rates = bar_span_rates,
    .kinematics = bar_span_kinematics,
    .stiffness = bar_span_stiffness,
};
