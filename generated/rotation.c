/* rotation: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * (wx, wy, wz) = 2 (lambdadot o conj(lambda)), angular velocity in global axes
 *
 * Source: Schwab and Meijaard 2006, DETC2006-99307
 *
 * x (4): r_l0, r_l1, r_l2, r_l3
 * e (0): none
 * s (3): wx [rad/s], wy [rad/s], wz [rad/s]
 * p (0): none */
#include "kernels.h"

/* position: 7 operations.
 * in:  x (4), p (0)
 * out: e (0), De (0,4), V (3,4) */
FLEXEL_CLONES
static void rotation_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        real *restrict V = out[2] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l1 = x[1 * 8 + j];
            const real t0 = 2.0 * r_l1;
            V[10 * 8 + j] = t0; /* V(2,2) */
            V[0 * 8 + j] = V[7 * 8 + j] = -t0; /* V(0,0) V(1,3) */
            const real r_l0 = x[0 * 8 + j];
            V[1 * 8 + j] = V[6 * 8 + j] = V[11 * 8 + j] = 2.0 * r_l0; /* V(0,1) V(1,2) V(2,3) */
            const real r_l3 = x[3 * 8 + j];
            const real t1 = 2.0 * r_l3;
            V[5 * 8 + j] = t1; /* V(1,1) */
            V[2 * 8 + j] = V[8 * 8 + j] = -t1; /* V(0,2) V(2,0) */
            const real r_l2 = x[2 * 8 + j];
            const real t2 = 2.0 * r_l2;
            V[3 * 8 + j] = t2; /* V(0,3) */
            V[4 * 8 + j] = V[9 * 8 + j] = -t2; /* V(1,0) V(2,1) */
        }
    }
}

/* acceleration: 18 operations.
 * in:  x (4), v (4), p (0)
 * out: g (0), gs (3) */
FLEXEL_CLONES
static void rotation_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        real *restrict gs = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl0 = v[0 * 8 + j];
            const real r_vl1 = v[1 * 8 + j];
            const real t0 = r_vl0 * r_vl1;
            const real r_vl2 = v[2 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real t1 = r_vl2 * r_vl3;
            gs[0 * 8 + j] = 2.0 * (t0 + t1 - t0 - t1);
            const real t2 = r_vl0 * r_vl2;
            const real t3 = r_vl1 * r_vl3;
            gs[1 * 8 + j] = 2.0 * (t2 + t3 - t3 - t2);
            const real t4 = r_vl0 * r_vl3;
            const real t5 = r_vl1 * r_vl2;
            gs[2 * 8 + j] = 2.0 * (t4 + t5 - t5 - t4);
        }
    }
}

/* rates: 8 operations.
 * in:  x (4), v (4), p (0)
 * out: Phi_x (3,4) */
FLEXEL_CLONES
static void rotation_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl1 = v[1 * 8 + j];
            const real t0 = 2.0 * r_vl1;
            Phi_x[0 * 8 + j] = Phi_x[7 * 8 + j] = t0; /* Phi_x(0,0) Phi_x(1,3) */
            const real r_vl0 = v[0 * 8 + j];
            Phi_x[1 * 8 + j] = Phi_x[6 * 8 + j] = Phi_x[11 * 8 + j] = -(2.0 * r_vl0);
                /* Phi_x(0,1) Phi_x(1,2) Phi_x(2,3) */
            const real r_vl3 = v[3 * 8 + j];
            const real t1 = 2.0 * r_vl3;
            Phi_x[2 * 8 + j] = Phi_x[8 * 8 + j] = t1; /* Phi_x(0,2) Phi_x(2,0) */
            const real r_vl2 = v[2 * 8 + j];
            const real t2 = 2.0 * r_vl2;
            Phi_x[4 * 8 + j] = Phi_x[9 * 8 + j] = t2; /* Phi_x(1,0) Phi_x(2,1) */
            Phi_x[3 * 8 + j] = -t2; /* Phi_x(0,3) */
            Phi_x[5 * 8 + j] = -t1; /* Phi_x(1,1) */
            Phi_x[10 * 8 + j] = -t0; /* Phi_x(2,2) */
        }
    }
}

/* kinematics: 8 operations.
 * in:  x (4), v (4), a (4), p (0)
 * out: Psi_x (3,4), Psi_v (3,4), 0 of 12 entries */
FLEXEL_CLONES
static void rotation_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict a = in[2] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_al1 = a[1 * 8 + j];
            const real t0 = 2.0 * r_al1;
            Psi_x[0 * 8 + j] = Psi_x[7 * 8 + j] = t0; /* Psi_x(0,0) Psi_x(1,3) */
            const real r_al0 = a[0 * 8 + j];
            Psi_x[1 * 8 + j] = Psi_x[6 * 8 + j] = Psi_x[11 * 8 + j] = -(2.0 * r_al0);
                /* Psi_x(0,1) Psi_x(1,2) Psi_x(2,3) */
            const real r_al3 = a[3 * 8 + j];
            const real t1 = 2.0 * r_al3;
            Psi_x[2 * 8 + j] = Psi_x[8 * 8 + j] = t1; /* Psi_x(0,2) Psi_x(2,0) */
            const real r_al2 = a[2 * 8 + j];
            const real t2 = 2.0 * r_al2;
            Psi_x[4 * 8 + j] = Psi_x[9 * 8 + j] = t2; /* Psi_x(1,0) Psi_x(2,1) */
            Psi_x[3 * 8 + j] = -t2; /* Psi_x(0,3) */
            Psi_x[5 * 8 + j] = -t1; /* Psi_x(1,1) */
            Psi_x[10 * 8 + j] = -t0; /* Psi_x(2,2) */
        }
    }
}

/* stiffness: 6 operations.
 * in:  x (4), sigma (0), tau (3), p (0)
 * out: K (4,4), 12 of 16 entries */
FLEXEL_CLONES
static void rotation_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict tau = in[2] + b * (3 * 8);
        real *restrict K = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real tau_wx = tau[0 * 8 + j];
            const real t0 = 2.0 * tau_wx;
            K[3 * 8 + j] = K[11 * 8 + j] = t0; /* K(1,0) K(3,2) */
            K[0 * 8 + j] = K[8 * 8 + j] = -t0; /* K(0,1) K(2,3) */
            const real tau_wy = tau[1 * 8 + j];
            const real t1 = 2.0 * tau_wy;
            K[5 * 8 + j] = K[6 * 8 + j] = t1; /* K(1,3) K(2,0) */
            K[1 * 8 + j] = K[10 * 8 + j] = -t1; /* K(0,2) K(3,1) */
            const real tau_wz = tau[2 * 8 + j];
            const real t2 = 2.0 * tau_wz;
            K[7 * 8 + j] = K[9 * 8 + j] = t2; /* K(2,1) K(3,0) */
            K[2 * 8 + j] = K[4 * 8 + j] = -t2; /* K(0,3) K(1,2) */
        }
    }
}

const flexel_element flexel_rotation = {
    .name = "rotation",
    .digest = "8bfd64251a679de0",
    .n = 4,
    .m = 0,
    .k = 3,
    .np = 0,
    .position = rotation_position,
    .acceleration = rotation_acceleration,
    .rates = rotation_rates,
    .kinematics = rotation_kinematics,
    .stiffness = rotation_stiffness,
};
