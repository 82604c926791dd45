/* cable_span: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * l0 ((vp + vq)/2 + l0 (dpdot - dqdot)/12), rate of the integral of position over a cable's cubic curve
 *
 * Source: textbook mechanics (consistent nodal forces)
 *
 * x (12): p_x, p_y, p_z, dp_x, dp_y, dp_z, q_x, q_y, q_z, dq_x, dq_y, dq_z
 * e (0): none
 * s (3): x [m^2/s], y [m^2/s], z [m^2/s]
 * p (1):
 *   l0 (1) [m]: undeformed length */
#include "kernels.h"

/* position: 4 operations.
 * in:  x (12), p (1)
 * out: e (0), De (0,12), V (3,12), 12 of 36 entries */
FLEXEL_CLONES
static void cable_span_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[1] + b * (1 * 8);
        real *restrict V = out[2] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            V[0 * 8 + j] = V[2 * 8 + j] = V[4 * 8 + j] = V[6 * 8 + j] = V[8 * 8 + j] = V[10 * 8 + j] = 0.5 * l0;
                /* V(0,0) V(0,6) V(1,1) V(1,7) V(2,2) V(2,8) */
            const real t0 = 0.08333333333333333 * (l0 * l0);
            V[1 * 8 + j] = V[5 * 8 + j] = V[9 * 8 + j] = t0; /* V(0,3) V(1,4) V(2,5) */
            V[3 * 8 + j] = V[7 * 8 + j] = V[11 * 8 + j] = -t0; /* V(0,9) V(1,10) V(2,11) */
        }
    }
}

/* acceleration: 0 operations.
 * in:  x (12), v (12), p (1)
 * out: g (0), gs (3), 0 of 3 entries */
FLEXEL_CLONES
static void cable_span_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* rates: 0 operations.
 * in:  x (12), v (12), p (1)
 * out: Phi_x (3,12), 0 of 36 entries */
FLEXEL_CLONES
static void cable_span_rates(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* kinematics: 0 operations.
 * in:  x (12), v (12), a (12), p (1)
 * out: Psi_x (3,12), 0 of 36 entries, Psi_v (3,12), 0 of 36 entries */
FLEXEL_CLONES
static void cable_span_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* stiffness: 0 operations.
 * in:  x (12), sigma (0), tau (3), p (1)
 * out: K (12,12), 0 of 144 entries */
FLEXEL_CLONES
static void cable_span_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_cable_span = {
    .name = "cable_span",
    .digest = "2056656ec90a6f36",
    .n = 12,
    .m = 0,
    .k = 3,
    .np = 1,
    .position = cable_span_position,
    .acceleration = cable_span_acceleration,
    .rates = cable_span_rates,
    .kinematics = cable_span_kinematics,
    .stiffness = cable_span_stiffness,
};
