/* truss: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * elongation = |xq - xp| - l0
 * T = rhoA l0/6 (vp.vp + vp.vq + vq.vq), uniform bar
 * U = -rhoA l0 gravity.(xp + xq)/2
 *
 * Source: van der Werff and Jonker 1984, NATO ASI F9, p. 381
 *
 * x (6): p_x, p_y, p_z, q_x, q_y, q_z
 * e (1): elongation [m]
 * s (0): none
 * p (5):
 *   l0 (1) [m]: undeformed length
 *   rhoA (1) [kg/m]: mass per length
 *   gravity (3) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* position: 17 operations.
 * in:  x (6), p (5)
 * out: e (1), De (1,6), V (0,6) */
FLEXEL_CLONES
static void truss_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (5 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (6 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_z = x[5 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y + d_z * d_z);
            const real l0 = p[0 * 8 + j];
            e[0 * 8 + j] = l - l0;
            const real t0 = 1.0 / l;
            const real t1 = d_x * t0;
            De[3 * 8 + j] = t1; /* De(0,3) */
            De[0 * 8 + j] = -t1; /* De(0,0) */
            const real t2 = d_y * t0;
            De[4 * 8 + j] = t2; /* De(0,4) */
            De[1 * 8 + j] = -t2; /* De(0,1) */
            const real t3 = d_z * t0;
            De[5 * 8 + j] = t3; /* De(0,5) */
            De[2 * 8 + j] = -t3; /* De(0,2) */
        }
    }
}

/* acceleration: 28 operations.
 * in:  x (6), v (6), p (5)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void truss_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        real *restrict g = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_z = x[5 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y + d_z * d_z);
            const real t0 = 1.0 / l;
            const real q_vz = v[5 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t1 = q_vz - p_vz;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t2 = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t3 = q_vy - p_vy;
            const real t4 = d_x * t2 + d_y * t3 + d_z * t1;
            g[0 * 8 + j] = t0 * (t2 * t2 + t3 * t3 + t1 * t1 - t0 * t0 * t4 * t4);
        }
    }
}

/* rates: 33 operations.
 * in:  x (6), v (6), p (5)
 * out: Phi_x (1,6) */
FLEXEL_CLONES
static void truss_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        real *restrict Phi_x = out[0] + b * (6 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t0 = q_vx - p_vx;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_z = x[5 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real l = real_sqrt(d_x * d_x + d_z * d_z + d_y * d_y);
            const real t1 = 1.0 / l;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t2 = q_vy - p_vy;
            const real q_vz = v[5 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t3 = q_vz - p_vz;
            const real t4 = t1 * (d_x * t0 + d_z * t3 + d_y * t2) * t1 * t1;
            const real t5 = t0 * t1 - d_x * t4;
            Phi_x[3 * 8 + j] = t5; /* Phi_x(0,3) */
            Phi_x[0 * 8 + j] = -t5; /* Phi_x(0,0) */
            const real t6 = t2 * t1 - d_y * t4;
            Phi_x[4 * 8 + j] = t6; /* Phi_x(0,4) */
            Phi_x[1 * 8 + j] = -t6; /* Phi_x(0,1) */
            const real t7 = t3 * t1 - d_z * t4;
            Phi_x[5 * 8 + j] = t7; /* Phi_x(0,5) */
            Phi_x[2 * 8 + j] = -t7; /* Phi_x(0,2) */
        }
    }
}

/* kinematics: 85 operations.
 * in:  x (6), v (6), a (6), p (5)
 * out: Psi_x (1,6), Psi_v (1,6) */
FLEXEL_CLONES
static void truss_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        real *restrict Psi_x = out[0] + b * (6 * 8);
        real *restrict Psi_v = out[1] + b * (6 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_z = x[5 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y + d_z * d_z);
            const real t0 = 1.0 / l;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t1 = q_ax - p_ax;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t2 = q_vx - p_vx;
            const real q_vz = v[5 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t3 = q_vz - p_vz;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t4 = q_vy - p_vy;
            const real t5 = d_x * t2 + d_y * t4 + d_z * t3;
            const real t6 = t0 * t0;
            const real t7 = t0 * t6;
            const real t8 = t5 * t7;
            const real t9 = t0 * t5;
            const real t10 = t8 + t6 * t9;
            const real q_az = a[5 * 8 + j];
            const real p_az = a[2 * 8 + j];
            const real t11 = q_az - p_az;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t12 = q_ay - p_ay;
            const real t13 = t2 * t2 + t4 * t4 + t3 * t3 + (d_x * t1 + d_y * t12 + d_z * t11);
            const real t14 = 2.0 * t13 - t5 * (2.0 * t6 * t5 + 4.0 * t0 * t9);
            const real t15 = t0 * t1 - t2 * t10 - 0.5 * d_x * t14 * t7;
            Psi_x[3 * 8 + j] = t15; /* Psi_x(0,3) */
            Psi_x[0 * 8 + j] = -t15; /* Psi_x(0,0) */
            const real t16 = t0 * t12 - t4 * t10 - 0.5 * d_y * t14 * t7;
            Psi_x[4 * 8 + j] = t16; /* Psi_x(0,4) */
            Psi_x[1 * 8 + j] = -t16; /* Psi_x(0,1) */
            const real t17 = t0 * t11 - t3 * t10 - 0.5 * d_z * t14 * t7;
            Psi_x[5 * 8 + j] = t17; /* Psi_x(0,5) */
            Psi_x[2 * 8 + j] = -t17; /* Psi_x(0,2) */
            const real t18 = 2.0 * (t0 * t2 - d_x * t8);
            Psi_v[3 * 8 + j] = t18; /* Psi_v(0,3) */
            Psi_v[0 * 8 + j] = -t18; /* Psi_v(0,0) */
            const real t19 = 2.0 * (t0 * t4 - d_y * t8);
            Psi_v[4 * 8 + j] = t19; /* Psi_v(0,4) */
            Psi_v[1 * 8 + j] = -t19; /* Psi_v(0,1) */
            const real t20 = 2.0 * (t0 * t3 - d_z * t8);
            Psi_v[5 * 8 + j] = t20; /* Psi_v(0,5) */
            Psi_v[2 * 8 + j] = -t20; /* Psi_v(0,2) */
        }
    }
}

/* stiffness: 30 operations.
 * in:  x (6), sigma (1), tau (0), p (5)
 * out: K (6,6) */
FLEXEL_CLONES
static void truss_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        real *restrict K = out[0] + b * (36 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t0 = d_x * d_x;
            const real q_z = x[5 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real l = real_sqrt(t0 + d_z * d_z + d_y * d_y);
            const real t1 = 1.0 / l;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t2 = sigma_elongation * t1;
            const real t3 = t1 * t2 * t1;
            const real t4 = t2 - t0 * t3;
            K[0 * 8 + j] = K[21 * 8 + j] = t4; /* K(0,0) K(3,3) */
            const real t5 = d_y * t3;
            const real t6 = d_x * t5;
            K[4 * 8 + j] = K[9 * 8 + j] = K[19 * 8 + j] = K[24 * 8 + j] = t6; /* K(0,4) K(1,3) K(3,1) K(4,0) */
            K[1 * 8 + j] = K[6 * 8 + j] = K[22 * 8 + j] = K[27 * 8 + j] = -t6; /* K(0,1) K(1,0) K(3,4) K(4,3) */
            const real t7 = d_z * t3;
            const real t8 = d_x * t7;
            K[5 * 8 + j] = K[15 * 8 + j] = K[20 * 8 + j] = K[30 * 8 + j] = t8; /* K(0,5) K(2,3) K(3,2) K(5,0) */
            K[2 * 8 + j] = K[12 * 8 + j] = K[23 * 8 + j] = K[33 * 8 + j] = -t8; /* K(0,2) K(2,0) K(3,5) K(5,3) */
            K[3 * 8 + j] = K[18 * 8 + j] = -t4; /* K(0,3) K(3,0) */
            const real t9 = t2 - d_y * t5;
            K[7 * 8 + j] = K[28 * 8 + j] = t9; /* K(1,1) K(4,4) */
            const real t10 = d_y * t7;
            K[11 * 8 + j] = K[16 * 8 + j] = K[26 * 8 + j] = K[31 * 8 + j] = t10; /* K(1,5) K(2,4) K(4,2) K(5,1) */
            K[8 * 8 + j] = K[13 * 8 + j] = K[29 * 8 + j] = K[34 * 8 + j] = -t10; /* K(1,2) K(2,1) K(4,5) K(5,4) */
            K[10 * 8 + j] = K[25 * 8 + j] = -t9; /* K(1,4) K(4,1) */
            const real t11 = t2 - d_z * t7;
            K[14 * 8 + j] = K[35 * 8 + j] = t11; /* K(2,2) K(5,5) */
            K[17 * 8 + j] = K[32 * 8 + j] = -t11; /* K(2,5) K(5,2) */
        }
    }
}

/* inertia: 20 operations.
 * in:  x (6), v (6), p (5)
 * out: M (6,6), 12 of 36 entries, h (6), 0 of 6 entries, f (6), U (1) */
FLEXEL_CLONES
static void truss_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[2] + b * (5 * 8);
        real *restrict M = out[0] + b * (12 * 8);
        real *restrict f = out[2] + b * (6 * 8);
        real *restrict U = out[3] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real rhoA = p[1 * 8 + j];
            const real t0 = l0 * rhoA;
            M[0 * 8 + j] = M[2 * 8 + j] = M[4 * 8 + j] = M[7 * 8 + j] = M[9 * 8 + j] = M[11 * 8 + j]
                = 0.3333333333333333 * t0; /* M(0,0) M(1,1) M(2,2) M(3,3) M(4,4) M(5,5) */
            M[1 * 8 + j] = M[3 * 8 + j] = M[5 * 8 + j] = M[6 * 8 + j] = M[8 * 8 + j] = M[10 * 8 + j]
                = 0.16666666666666666 * t0; /* M(0,3) M(1,4) M(2,5) M(3,0) M(4,1) M(5,2) */
            const real gravity_x = p[2 * 8 + j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * gravity_x * t0;
            const real gravity_y = p[3 * 8 + j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * gravity_y * t0;
            const real gravity_z = p[4 * 8 + j];
            f[2 * 8 + j] = f[5 * 8 + j] = 0.5 * gravity_z * t0;
            const real p_z = x[2 * 8 + j];
            const real q_z = x[5 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real q_x = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[4 * 8 + j];
            const real t1 = gravity_x * (p_x + q_x) + gravity_y * (p_y + q_y) + gravity_z * (p_z + q_z);
            U[0 * 8 + j] = -(0.5 * t0 * t1);
        }
    }
}

/* tangent: 0 operations.
 * in:  x (6), v (6), a (6), p (5)
 * out: R_x (6,6), 0 of 36 entries, R_v (6,6), 0 of 36 entries */
FLEXEL_CLONES
static void truss_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_truss = {
    .name = "truss",
    .digest = "1e9195dd3cf86bd4",
    .n = 6,
    .m = 1,
    .k = 0,
    .np = 5,
    .position = truss_position,
    .acceleration = truss_acceleration,
    .rates = truss_rates,
    .kinematics = truss_kinematics,
    .stiffness = truss_stiffness,
    .inertia = truss_inertia,
    .tangent = truss_tangent,
};
