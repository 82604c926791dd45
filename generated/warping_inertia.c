/* warping_inertia: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * w: twist per length
 * T = J wdot^2/2
 *
 * Source: Vlasov 1961, Thin-walled elastic beams
 *
 * x (1): w_twist
 * e (0): none
 * s (0): none
 * p (1):
 *   J (1) [kg m^4]: moment of inertia of warping: density times warping constant times length */
#include "kernels.h"

/* inertia: 0 operations.
 * in:  x (1), v (1), p (1)
 * out: M (1,1), h (1), 0 of 1 entries, f (1), 0 of 1 entries, U (1), 0 of 1 entries */
FLEXEL_CLONES
static void warping_inertia_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[2] + b * (1 * 8);
        real *restrict M = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real J_ = p[0 * 8 + j];
            M[0 * 8 + j] = J_; /* M(0,0) */
        }
    }
}

/* tangent: 0 operations.
 * in:  x (1), v (1), a (1), p (1)
 * out: R_x (1,1), 0 of 1 entries, R_v (1,1), 0 of 1 entries */
FLEXEL_CLONES
static void warping_inertia_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_warping_inertia = {
    .name = "warping_inertia",
    .digest = "38325bf076bf00d3",
    .n = 1,
    .m = 0,
    .k = 0,
    .np = 1,
    .inertia = warping_inertia_inertia,
    .tangent = warping_inertia_tangent,
};
