/* body_velocity: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * (vx, vy, vz) = R(lambda)' xdot_p, velocity of the point in the axes of the frame
 *
 * Source: textbook mechanics
 *
 * x (7): p_x, p_y, p_z, r_l0, r_l1, r_l2, r_l3
 * e (0): none
 * s (3): vx [m/s], vy [m/s], vz [m/s]
 * p (0): none */
#include "kernels.h"

/* position: 31 operations.
 * in:  x (7), p (0)
 * out: e (0), De (0,7), V (3,7), 9 of 21 entries */
FLEXEL_CLONES
static void body_velocity_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        real *restrict V = out[2] + b * (9 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[3 * 8 + j];
            const real t0 = r_l0 * r_l0;
            const real r_l1 = x[4 * 8 + j];
            const real t1 = r_l1 * r_l1;
            const real r_l2 = x[5 * 8 + j];
            const real t2 = r_l2 * r_l2;
            const real r_l3 = x[6 * 8 + j];
            const real t3 = r_l3 * r_l3;
            V[0 * 8 + j] = t0 + t1 - t2 - t3; /* V(0,0) */
            const real t4 = r_l0 * r_l3;
            const real t5 = r_l1 * r_l2;
            V[1 * 8 + j] = 2.0 * (t4 + t5); /* V(0,1) */
            const real t6 = r_l1 * r_l3;
            const real t7 = r_l0 * r_l2;
            V[2 * 8 + j] = 2.0 * (t6 - t7); /* V(0,2) */
            V[3 * 8 + j] = 2.0 * (t5 - t4); /* V(1,0) */
            V[4 * 8 + j] = t0 + t2 - t1 - t3; /* V(1,1) */
            const real t8 = r_l0 * r_l1;
            const real t9 = r_l2 * r_l3;
            V[5 * 8 + j] = 2.0 * (t8 + t9); /* V(1,2) */
            V[6 * 8 + j] = 2.0 * (t7 + t6); /* V(2,0) */
            V[7 * 8 + j] = 2.0 * (t9 - t8); /* V(2,1) */
            V[8 * 8 + j] = t0 + t3 - t1 - t2; /* V(2,2) */
        }
    }
}

/* acceleration: 59 operations.
 * in:  x (7), v (7), p (0)
 * out: g (0), gs (3) */
FLEXEL_CLONES
static void body_velocity_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        real *restrict gs = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[3 * 8 + j];
            const real r_vl0 = v[3 * 8 + j];
            const real t0 = 2.0 * r_l0 * r_vl0;
            const real r_l1 = x[4 * 8 + j];
            const real r_vl1 = v[4 * 8 + j];
            const real t1 = 2.0 * r_l1 * r_vl1;
            const real r_l2 = x[5 * 8 + j];
            const real r_vl2 = v[5 * 8 + j];
            const real t2 = 2.0 * r_l2 * r_vl2;
            const real r_l3 = x[6 * 8 + j];
            const real r_vl3 = v[6 * 8 + j];
            const real t3 = 2.0 * r_l3 * r_vl3;
            const real p_vx = v[0 * 8 + j];
            const real t4 = r_l3 * r_vl0 + r_l0 * r_vl3;
            const real t5 = r_l2 * r_vl1 + r_l1 * r_vl2;
            const real p_vy = v[1 * 8 + j];
            const real t6 = r_l3 * r_vl1 + r_l1 * r_vl3;
            const real t7 = r_l2 * r_vl0 + r_l0 * r_vl2;
            const real p_vz = v[2 * 8 + j];
            gs[0 * 8 + j] = p_vx * (t0 + t1 - t2 - t3) + 2.0 * (p_vy * (t4 + t5) + p_vz * (t6 - t7));
            const real t8 = r_l1 * r_vl0 + r_l0 * r_vl1;
            const real t9 = r_l3 * r_vl2 + r_l2 * r_vl3;
            gs[1 * 8 + j] = p_vy * (t0 + t2 - t1 - t3) + 2.0 * (p_vx * (t5 - t4) + p_vz * (t8 + t9));
            gs[2 * 8 + j] = p_vz * (t0 + t3 - t1 - t2) + 2.0 * (p_vx * (t7 + t6) + p_vy * (t9 - t8));
        }
    }
}

/* rates: 27 operations.
 * in:  x (7), v (7), p (0)
 * out: Phi_x (3,7), 12 of 21 entries */
FLEXEL_CLONES
static void body_velocity_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        real *restrict Phi_x = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real r_l3 = x[6 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real r_l2 = x[5 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t0 = 2.0 * (r_l0 * p_vx + r_l3 * p_vy - r_l2 * p_vz);
            Phi_x[0 * 8 + j] = Phi_x[10 * 8 + j] = t0; /* Phi_x(0,3) Phi_x(2,5) */
            const real r_l1 = x[4 * 8 + j];
            Phi_x[1 * 8 + j] = Phi_x[6 * 8 + j] = Phi_x[11 * 8 + j] = 2.0 * (r_l1 * p_vx + r_l3 * p_vz + r_l2 * p_vy);
                /* Phi_x(0,4) Phi_x(1,5) Phi_x(2,6) */
            const real t1 = 2.0 * (r_l2 * p_vx + r_l0 * p_vz - r_l1 * p_vy);
            Phi_x[5 * 8 + j] = Phi_x[8 * 8 + j] = t1; /* Phi_x(1,4) Phi_x(2,3) */
            Phi_x[2 * 8 + j] = -t1; /* Phi_x(0,5) */
            const real t2 = 2.0 * (r_l0 * p_vy + r_l1 * p_vz - r_l3 * p_vx);
            Phi_x[3 * 8 + j] = Phi_x[4 * 8 + j] = t2; /* Phi_x(0,6) Phi_x(1,3) */
            Phi_x[7 * 8 + j] = -t0; /* Phi_x(1,6) */
            Phi_x[9 * 8 + j] = -t2; /* Phi_x(2,4) */
        }
    }
}

/* kinematics: 125 operations.
 * in:  x (7), v (7), a (7), p (0)
 * out: Psi_x (3,7), 12 of 21 entries, Psi_v (3,7) */
FLEXEL_CLONES
static void body_velocity_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        const real *restrict a = in[2] + b * (7 * 8);
        real *restrict Psi_x = out[0] + b * (12 * 8);
        real *restrict Psi_v = out[1] + b * (21 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l3 = x[6 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real r_l0 = x[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real r_vl0 = v[3 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real r_vl3 = v[6 * 8 + j];
            const real r_l2 = x[5 * 8 + j];
            const real p_az = a[2 * 8 + j];
            const real t0 = p_vx * r_vl0 + p_vy * r_vl3 + r_l0 * p_ax + r_l3 * p_ay - r_l2 * p_az;
            const real p_vz = v[2 * 8 + j];
            const real r_vl2 = v[5 * 8 + j];
            const real t1 = 2.0 * (t0 - p_vz * r_vl2);
            Psi_x[0 * 8 + j] = Psi_x[10 * 8 + j] = t1; /* Psi_x(0,3) Psi_x(2,5) */
            const real r_l1 = x[4 * 8 + j];
            const real r_vl1 = v[4 * 8 + j];
            const real t2 = p_vy * r_vl2 + p_vz * r_vl3 + p_vx * r_vl1 + r_l3 * p_az + r_l1 * p_ax;
            Psi_x[1 * 8 + j] = Psi_x[6 * 8 + j] = Psi_x[11 * 8 + j] = 2.0 * (r_l2 * p_ay + t2);
                /* Psi_x(0,4) Psi_x(1,5) Psi_x(2,6) */
            const real t3 = p_vy * r_vl1 + r_l1 * p_ay - r_l2 * p_ax - r_l0 * p_az - p_vx * r_vl2;
            const real t4 = 2.0 * (t3 - p_vz * r_vl0);
            Psi_x[2 * 8 + j] = t4; /* Psi_x(0,5) */
            const real t5 = p_vy * r_vl0 + p_vz * r_vl1 + r_l1 * p_az + r_l0 * p_ay - r_l3 * p_ax;
            const real t6 = 2.0 * (t5 - p_vx * r_vl3);
            Psi_x[3 * 8 + j] = Psi_x[4 * 8 + j] = t6; /* Psi_x(0,6) Psi_x(1,3) */
            Psi_x[5 * 8 + j] = Psi_x[8 * 8 + j] = -t4; /* Psi_x(1,4) Psi_x(2,3) */
            Psi_x[7 * 8 + j] = -t1; /* Psi_x(1,6) */
            Psi_x[9 * 8 + j] = -t6; /* Psi_x(2,4) */
            const real t7 = 2.0 * r_l0 * r_vl0;
            const real t8 = 2.0 * r_l1 * r_vl1;
            const real t9 = 2.0 * r_l2 * r_vl2;
            const real t10 = 2.0 * r_l3 * r_vl3;
            Psi_v[0 * 8 + j] = t7 + t8 - t9 - t10; /* Psi_v(0,0) */
            const real t11 = r_l3 * r_vl0 + r_l0 * r_vl3;
            const real t12 = r_l2 * r_vl1 + r_l1 * r_vl2;
            Psi_v[1 * 8 + j] = 2.0 * (t11 + t12); /* Psi_v(0,1) */
            const real t13 = r_l3 * r_vl1 + r_l1 * r_vl3;
            const real t14 = r_l2 * r_vl0 + r_l0 * r_vl2;
            Psi_v[2 * 8 + j] = 2.0 * (t13 - t14); /* Psi_v(0,2) */
            const real t15 = 2.0 * (r_l0 * p_vx + r_l3 * p_vy - r_l2 * p_vz);
            Psi_v[3 * 8 + j] = Psi_v[19 * 8 + j] = t15; /* Psi_v(0,3) Psi_v(2,5) */
            Psi_v[4 * 8 + j] = Psi_v[12 * 8 + j] = Psi_v[20 * 8 + j] = 2.0 * (r_l1 * p_vx + r_l3 * p_vz + r_l2
                * p_vy); /* Psi_v(0,4) Psi_v(1,5) Psi_v(2,6) */
            const real t16 = 2.0 * (r_l2 * p_vx + r_l0 * p_vz - r_l1 * p_vy);
            Psi_v[11 * 8 + j] = Psi_v[17 * 8 + j] = t16; /* Psi_v(1,4) Psi_v(2,3) */
            Psi_v[5 * 8 + j] = -t16; /* Psi_v(0,5) */
            const real t17 = 2.0 * (r_l0 * p_vy + r_l1 * p_vz - r_l3 * p_vx);
            Psi_v[6 * 8 + j] = Psi_v[10 * 8 + j] = t17; /* Psi_v(0,6) Psi_v(1,3) */
            Psi_v[7 * 8 + j] = 2.0 * (t12 - t11); /* Psi_v(1,0) */
            Psi_v[8 * 8 + j] = t7 + t9 - t8 - t10; /* Psi_v(1,1) */
            const real t18 = r_l1 * r_vl0 + r_l0 * r_vl1;
            const real t19 = r_l3 * r_vl2 + r_l2 * r_vl3;
            Psi_v[9 * 8 + j] = 2.0 * (t18 + t19); /* Psi_v(1,2) */
            Psi_v[13 * 8 + j] = -t15; /* Psi_v(1,6) */
            Psi_v[14 * 8 + j] = 2.0 * (t14 + t13); /* Psi_v(2,0) */
            Psi_v[15 * 8 + j] = 2.0 * (t19 - t18); /* Psi_v(2,1) */
            Psi_v[16 * 8 + j] = t7 + t10 - t8 - t9; /* Psi_v(2,2) */
            Psi_v[18 * 8 + j] = -t17; /* Psi_v(2,4) */
        }
    }
}

/* stiffness: 27 operations.
 * in:  x (7), sigma (0), tau (3), p (0)
 * out: K (7,7), 12 of 49 entries */
FLEXEL_CLONES
static void body_velocity_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict tau = in[2] + b * (3 * 8);
        real *restrict K = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l2 = x[5 * 8 + j];
            const real tau_vz = tau[2 * 8 + j];
            const real r_l0 = x[3 * 8 + j];
            const real tau_vx = tau[0 * 8 + j];
            const real r_l3 = x[6 * 8 + j];
            const real tau_vy = tau[1 * 8 + j];
            const real t0 = 2.0 * (r_l2 * tau_vz + r_l0 * tau_vx - r_l3 * tau_vy);
            K[0 * 8 + j] = K[7 * 8 + j] = t0; /* K(0,3) K(1,6) */
            const real r_l1 = x[4 * 8 + j];
            K[1 * 8 + j] = K[6 * 8 + j] = K[11 * 8 + j] = 2.0 * (r_l3 * tau_vz + r_l2 * tau_vy + r_l1 * tau_vx);
                /* K(0,4) K(1,5) K(2,6) */
            const real t1 = 2.0 * (r_l0 * tau_vz + r_l1 * tau_vy - r_l2 * tau_vx);
            K[2 * 8 + j] = K[8 * 8 + j] = t1; /* K(0,5) K(2,3) */
            const real t2 = 2.0 * (r_l0 * tau_vy + r_l3 * tau_vx - r_l1 * tau_vz);
            K[4 * 8 + j] = K[9 * 8 + j] = t2; /* K(1,3) K(2,4) */
            K[3 * 8 + j] = -t2; /* K(0,6) */
            K[5 * 8 + j] = -t1; /* K(1,4) */
            K[10 * 8 + j] = -t0; /* K(2,5) */
        }
    }
}

const flexel_element flexel_body_velocity = {
    .name = "body_velocity",
    .digest = "16d8f605347afe64",
    .n = 7,
    .m = 0,
    .k = 3,
    .np = 0,
    .position = body_velocity_position,
    .acceleration = body_velocity_acceleration,
    .rates = body_velocity_rates,
    .kinematics = body_velocity_kinematics,
    .stiffness = body_velocity_stiffness,
};
