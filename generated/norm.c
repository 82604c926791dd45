/* norm: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * norm = lambda.lambda - 1
 *
 * Source: Schwab and Meijaard 2006, DETC2006-99307
 *
 * x (4): r_l0, r_l1, r_l2, r_l3
 * e (1): norm [1]
 * s (0): none
 * p (0): none */
#include "kernels.h"

/* position: 12 operations.
 * in:  x (4), p (0)
 * out: e (1), De (1,4), V (0,4) */
FLEXEL_CLONES
static void norm_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l3 = x[3 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real r_l0 = x[0 * 8 + j];
            const real r_l1 = x[1 * 8 + j];
            e[0 * 8 + j] = r_l0 * r_l0 + r_l1 * r_l1 + r_l2 * r_l2 + r_l3 * r_l3 - 1.0;
            De[0 * 8 + j] = 2.0 * r_l0; /* De(0,0) */
            De[1 * 8 + j] = 2.0 * r_l1; /* De(0,1) */
            De[2 * 8 + j] = 2.0 * r_l2; /* De(0,2) */
            De[3 * 8 + j] = 2.0 * r_l3; /* De(0,3) */
        }
    }
}

/* acceleration: 8 operations.
 * in:  x (4), v (4), p (0)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void norm_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        real *restrict g = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl1 = v[1 * 8 + j];
            const real r_vl0 = v[0 * 8 + j];
            const real r_vl2 = v[2 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real t0 = r_vl2 * r_vl2 + r_vl3 * r_vl3 + r_vl0 * r_vl0 + r_vl1 * r_vl1;
            g[0 * 8 + j] = 2.0 * t0;
        }
    }
}

/* rates: 4 operations.
 * in:  x (4), v (4), p (0)
 * out: Phi_x (1,4) */
FLEXEL_CLONES
static void norm_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl0 = v[0 * 8 + j];
            Phi_x[0 * 8 + j] = 2.0 * r_vl0; /* Phi_x(0,0) */
            const real r_vl1 = v[1 * 8 + j];
            Phi_x[1 * 8 + j] = 2.0 * r_vl1; /* Phi_x(0,1) */
            const real r_vl2 = v[2 * 8 + j];
            Phi_x[2 * 8 + j] = 2.0 * r_vl2; /* Phi_x(0,2) */
            const real r_vl3 = v[3 * 8 + j];
            Phi_x[3 * 8 + j] = 2.0 * r_vl3; /* Phi_x(0,3) */
        }
    }
}

/* kinematics: 8 operations.
 * in:  x (4), v (4), a (4), p (0)
 * out: Psi_x (1,4), Psi_v (1,4) */
FLEXEL_CLONES
static void norm_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        const real *restrict a = in[2] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (4 * 8);
        real *restrict Psi_v = out[1] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_al0 = a[0 * 8 + j];
            Psi_x[0 * 8 + j] = 2.0 * r_al0; /* Psi_x(0,0) */
            const real r_al1 = a[1 * 8 + j];
            Psi_x[1 * 8 + j] = 2.0 * r_al1; /* Psi_x(0,1) */
            const real r_al2 = a[2 * 8 + j];
            Psi_x[2 * 8 + j] = 2.0 * r_al2; /* Psi_x(0,2) */
            const real r_al3 = a[3 * 8 + j];
            Psi_x[3 * 8 + j] = 2.0 * r_al3; /* Psi_x(0,3) */
            const real r_vl0 = v[0 * 8 + j];
            Psi_v[0 * 8 + j] = 4.0 * r_vl0; /* Psi_v(0,0) */
            const real r_vl1 = v[1 * 8 + j];
            Psi_v[1 * 8 + j] = 4.0 * r_vl1; /* Psi_v(0,1) */
            const real r_vl2 = v[2 * 8 + j];
            Psi_v[2 * 8 + j] = 4.0 * r_vl2; /* Psi_v(0,2) */
            const real r_vl3 = v[3 * 8 + j];
            Psi_v[3 * 8 + j] = 4.0 * r_vl3; /* Psi_v(0,3) */
        }
    }
}

/* stiffness: 1 operations.
 * in:  x (4), sigma (1), tau (0), p (0)
 * out: K (4,4), 4 of 16 entries */
FLEXEL_CLONES
static void norm_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict sigma = in[1] + b * (1 * 8);
        real *restrict K = out[0] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_norm = sigma[0 * 8 + j];
            K[0 * 8 + j] = K[1 * 8 + j] = K[2 * 8 + j] = K[3 * 8 + j] = 2.0 * sigma_norm;
                /* K(0,0) K(1,1) K(2,2) K(3,3) */
        }
    }
}

const flexel_element flexel_norm = {
    .name = "norm",
    .digest = "7a229f46635c78bf",
    .n = 4,
    .m = 1,
    .k = 0,
    .np = 0,
    .position = norm_position,
    .acceleration = norm_acceleration,
    .rates = norm_rates,
    .kinematics = norm_kinematics,
    .stiffness = norm_stiffness,
};
