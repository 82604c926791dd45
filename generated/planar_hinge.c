/* planar_hinge: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * angle = angle_q - angle_p - offset0 (counts turns)
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), PLHINGE
 *
 * x (2): p_angle, q_angle
 * e (1): angle [rad]
 * s (0): none
 * p (1):
 *   offset0 (1) [rad]: difference of the angles when the deformation is zero */
#include "kernels.h"

/* position: 2 operations.
 * in:  x (2), p (1)
 * out: e (1), De (1,2), V (0,2) */
FLEXEL_CLONES
static void planar_hinge_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (2 * 8);
        const real *restrict p = in[1] + b * (1 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_angle = x[1 * 8 + j];
            const real offset0 = p[0 * 8 + j];
            const real p_angle = x[0 * 8 + j];
            e[0 * 8 + j] = q_angle - offset0 - p_angle;
            De[0 * 8 + j] = -1.0; /* De(0,0) */
            De[1 * 8 + j] = 1.0; /* De(0,1) */
        }
    }
}

/* acceleration: 0 operations.
 * in:  x (2), v (2), p (1)
 * out: g (1), 0 of 1 entries, gs (0) */
FLEXEL_CLONES
static void planar_hinge_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* rates: 0 operations.
 * in:  x (2), v (2), p (1)
 * out: Phi_x (1,2), 0 of 2 entries */
FLEXEL_CLONES
static void planar_hinge_rates(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* kinematics: 0 operations.
 * in:  x (2), v (2), a (2), p (1)
 * out: Psi_x (1,2), 0 of 2 entries, Psi_v (1,2), 0 of 2 entries */
FLEXEL_CLONES
static void planar_hinge_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* stiffness: 0 operations.
 * in:  x (2), sigma (1), tau (0), p (1)
 * out: K (2,2), 0 of 4 entries */
FLEXEL_CLONES
static void planar_hinge_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_planar_hinge = {
    .name = "planar_hinge",
    .digest = "cefa0eb05f82b7f7",
    .n = 2,
    .m = 1,
    .k = 0,
    .np = 1,
    .position = planar_hinge_position,
    .acceleration = planar_hinge_acceleration,
    .rates = planar_hinge_rates,
    .kinematics = planar_hinge_kinematics,
    .stiffness = planar_hinge_stiffness,
};
