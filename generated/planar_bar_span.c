/* planar_bar_span: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * (x, y, z) = l0 (vp + vq)/2, rate of the integral of position over a straight bar
 *
 * Source: textbook mechanics (consistent nodal forces)
 *
 * x (4): p_x, p_y, q_x, q_y
 * e (0): none
 * s (2): x [m^2/s], y [m^2/s]
 * p (1):
 *   l0 (1) [m]: undeformed length */
#include "kernels.h"

/* position: 1 operations.
 * in:  x (4), p (1)
 * out: e (0), De (0,4), V (2,4), 4 of 8 entries */
FLEXEL_CLONES
static void planar_bar_span_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[1] + b * (1 * 8);
        real *restrict V = out[2] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            V[0 * 8 + j] = V[1 * 8 + j] = V[2 * 8 + j] = V[3 * 8 + j] = 0.5 * l0; /* V(0,0) V(0,2) V(1,1) V(1,3) */
        }
    }
}

/* acceleration: 0 operations.
 * in:  x (4), v (4), p (1)
 * out: g (0), gs (2), 0 of 2 entries */
FLEXEL_CLONES
static void planar_bar_span_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* rates: 0 operations.
 * in:  x (4), v (4), p (1)
 * out: Phi_x (2,4), 0 of 8 entries */
FLEXEL_CLONES
static void planar_bar_span_rates(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* kinematics: 0 operations.
 * in:  x (4), v (4), a (4), p (1)
 * out: Psi_x (2,4), 0 of 8 entries, Psi_v (2,4), 0 of 8 entries */
FLEXEL_CLONES
static void planar_bar_span_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* stiffness: 0 operations.
 * in:  x (4), sigma (0), tau (2), p (1)
 * out: K (4,4), 0 of 16 entries */
FLEXEL_CLONES
static void planar_bar_span_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_planar_bar_span = {
    .name = "planar_bar_span",
    .digest = "6d544293988bba62",
    .n = 4,
    .m = 0,
    .k = 2,
    .np = 1,
    .position = planar_bar_span_position,
    .acceleration = planar_bar_span_acceleration,
    .rates = planar_bar_span_rates,
    .kinematics = planar_bar_span_kinematics,
    .stiffness = planar_bar_span_stiffness,
};
