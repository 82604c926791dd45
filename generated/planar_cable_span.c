/* planar_cable_span: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * l0 ((vp + vq)/2 + l0 (dpdot - dqdot)/12), rate of the integral of position over a cable's cubic curve
 *
 * Source: textbook mechanics (consistent nodal forces)
 *
 * x (8): p_x, p_y, dp_x, dp_y, q_x, q_y, dq_x, dq_y
 * e (0): none
 * s (2): x [m^2/s], y [m^2/s]
 * p (1):
 *   l0 (1) [m]: undeformed length */
#include "kernels.h"

/* position: 4 operations.
 * in:  x (8), p (1)
 * out: e (0), De (0,8), V (2,8), 8 of 16 entries */
FLEXEL_CLONES
static void planar_cable_span_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[1] + b * (1 * 8);
        real *restrict V = out[2] + b * (8 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            V[0 * 8 + j] = V[2 * 8 + j] = V[4 * 8 + j] = V[6 * 8 + j] = 0.5 * l0; /* V(0,0) V(0,4) V(1,1) V(1,5) */
            const real t0 = 0.08333333333333333 * (l0 * l0);
            V[1 * 8 + j] = V[5 * 8 + j] = t0; /* V(0,2) V(1,3) */
            V[3 * 8 + j] = V[7 * 8 + j] = -t0; /* V(0,6) V(1,7) */
        }
    }
}

/* acceleration: 0 operations.
 * in:  x (8), v (8), p (1)
 * out: g (0), gs (2), 0 of 2 entries */
FLEXEL_CLONES
static void planar_cable_span_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* rates: 0 operations.
 * in:  x (8), v (8), p (1)
 * out: Phi_x (2,8), 0 of 16 entries */
FLEXEL_CLONES
static void planar_cable_span_rates(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* kinematics: 0 operations.
 * in:  x (8), v (8), a (8), p (1)
 * out: Psi_x (2,8), 0 of 16 entries, Psi_v (2,8), 0 of 16 entries */
FLEXEL_CLONES
static void planar_cable_span_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* stiffness: 0 operations.
 * in:  x (8), sigma (0), tau (2), p (1)
 * out: K (8,8), 0 of 64 entries */
FLEXEL_CLONES
static void planar_cable_span_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_planar_cable_span = {
    .name = "planar_cable_span",
    .digest = "0d6a34fcdefb0998",
    .n = 8,
    .m = 0,
    .k = 2,
    .np = 1,
    .position = planar_cable_span_position,
    .acceleration = planar_cable_span_acceleration,
    .rates = planar_cable_span_rates,
    .kinematics = planar_cable_span_kinematics,
    .stiffness = planar_cable_span_stiffness,
};
