/* slope_clamp: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * triad ex, ey, ez: columns of R(lambda o t);  across_y = ey.d,  across_z = ez.d
 *
 * Source: textbook mechanics
 *
 * x (7): r_l0, r_l1, r_l2, r_l3, d_x, d_y, d_z
 * e (2): across_y [1], across_z [1]
 * s (0): none
 * p (4):
 *   t (4) [1]: unit quaternion from the body frame to a triad whose first axis is the held direction */
#include "kernels.h"

/* position: 133 operations.
 * in:  x (7), p (4)
 * out: e (2), De (2,7), V (0,7) */
FLEXEL_CLONES
static void slope_clamp_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict e = out[0] + b * (2 * 8);
        real *restrict De = out[1] + b * (14 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[0 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_l1 = x[1 * 8 + j];
            const real t_1 = p[1 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_l3 = x[3 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real u_0 = r_l0 * t_0 - r_l1 * t_1 - r_l2 * t_2 - r_l3 * t_3;
            const real t0 = u_0 * u_0;
            const real u_2 = r_l0 * t_2 + r_l2 * t_0 + r_l3 * t_1 - r_l1 * t_3;
            const real t1 = u_2 * u_2;
            const real u_1 = r_l0 * t_1 + r_l1 * t_0 + r_l2 * t_3 - r_l3 * t_2;
            const real t2 = u_1 * u_1;
            const real u_3 = r_l0 * t_3 + r_l1 * t_2 + r_l3 * t_0 - r_l2 * t_1;
            const real t3 = u_3 * u_3;
            const real t4 = t0 + t1 - t2 - t3;
            De[5 * 8 + j] = t4; /* De(0,5) */
            const real d_y = x[5 * 8 + j];
            const real t5 = u_1 * u_2 - u_0 * u_3;
            const real d_x = x[4 * 8 + j];
            const real t6 = u_0 * u_1;
            const real t7 = u_2 * u_3;
            const real t8 = t6 + t7;
            const real d_z = x[6 * 8 + j];
            e[0 * 8 + j] = d_y * t4 + 2.0 * (d_x * t5 + d_z * t8);
            const real t9 = t0 + t3 - t2 - t1;
            De[13 * 8 + j] = t9; /* De(1,6) */
            const real t10 = u_0 * u_2 + u_1 * u_3;
            const real t11 = t7 - t6;
            e[1 * 8 + j] = d_z * t9 + 2.0 * (d_x * t10 + d_y * t11);
            const real t12 = 2.0 * d_z * u_2 - (2.0 * d_x * u_0 + 2.0 * d_y * u_3);
            const real t13 = t_3 * t12;
            const real t14 = 2.0 * d_x * u_2 - 2.0 * d_y * u_1 + 2.0 * d_z * u_0;
            const real t15 = 2.0 * d_z * u_1 - (2.0 * d_x * u_3 - 2.0 * d_y * u_0);
            const real t16 = t_1 * t14 + t_0 * t15;
            const real t17 = 2.0 * d_x * u_1 + 2.0 * d_y * u_2 + 2.0 * d_z * u_3;
            const real t18 = t_2 * t17;
            De[0 * 8 + j] = t16 + t18 + t13; /* De(0,0) */
            const real t19 = t_2 * t12;
            const real t20 = t_0 * t14 - t_1 * t15;
            const real t21 = t_3 * t17;
            De[1 * 8 + j] = t20 - t21 + t19; /* De(0,1) */
            const real t22 = t_0 * t17;
            const real t23 = t_2 * t15 - t_3 * t14;
            const real t24 = t_1 * t12;
            De[2 * 8 + j] = t22 - t23 - t24; /* De(0,2) */
            const real t25 = t_0 * t12;
            const real t26 = t_1 * t17;
            const real t27 = t_2 * t14 + t_3 * t15;
            De[3 * 8 + j] = t26 - t27 + t25; /* De(0,3) */
            De[4 * 8 + j] = 2.0 * t5; /* De(0,4) */
            De[6 * 8 + j] = 2.0 * t8; /* De(0,6) */
            De[7 * 8 + j] = t20 - t19 + t21; /* De(1,0) */
            De[8 * 8 + j] = t13 - t16 + t18; /* De(1,1) */
            De[9 * 8 + j] = -(t27 + t25 + t26); /* De(1,2) */
            De[10 * 8 + j] = t23 - t24 + t22; /* De(1,3) */
            De[11 * 8 + j] = 2.0 * t10; /* De(1,4) */
            De[12 * 8 + j] = 2.0 * t11; /* De(1,5) */
        }
    }
}

/* acceleration: 144 operations.
 * in:  x (7), v (7), p (4)
 * out: g (2), gs (0) */
FLEXEL_CLONES
static void slope_clamp_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict g = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl0 = v[0 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_vl1 = v[1 * 8 + j];
            const real t_1 = p[1 * 8 + j];
            const real r_vl2 = v[2 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real t0 = r_vl0 * t_0 - r_vl1 * t_1 - r_vl2 * t_2 - r_vl3 * t_3;
            const real t1 = 2.0 * t0 * t0;
            const real t2 = r_vl0 * t_2 + r_vl2 * t_0 + r_vl3 * t_1 - r_vl1 * t_3;
            const real t3 = 2.0 * t2 * t2;
            const real t4 = r_vl0 * t_1 + r_vl1 * t_0 + r_vl2 * t_3 - r_vl3 * t_2;
            const real t5 = 2.0 * t4 * t4;
            const real t6 = r_vl0 * t_3 + r_vl1 * t_2 + r_vl3 * t_0 - r_vl2 * t_1;
            const real t7 = 2.0 * t6 * t6;
            const real d_y = x[5 * 8 + j];
            const real r_l0 = x[0 * 8 + j];
            const real r_l1 = x[1 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real r_l3 = x[3 * 8 + j];
            const real u_0 = r_l0 * t_0 - r_l1 * t_1 - r_l2 * t_2 - r_l3 * t_3;
            const real t8 = 2.0 * u_0 * t0;
            const real u_2 = r_l0 * t_2 + r_l2 * t_0 + r_l3 * t_1 - r_l1 * t_3;
            const real t9 = 2.0 * u_2 * t2;
            const real u_1 = r_l0 * t_1 + r_l1 * t_0 + r_l2 * t_3 - r_l3 * t_2;
            const real t10 = 2.0 * u_1 * t4;
            const real u_3 = r_l0 * t_3 + r_l1 * t_2 + r_l3 * t_0 - r_l2 * t_1;
            const real t11 = 2.0 * u_3 * t6;
            const real d_vy = v[5 * 8 + j];
            const real t12 = 2.0 * t0 * t4;
            const real t13 = 2.0 * t2 * t6;
            const real d_z = x[6 * 8 + j];
            const real t14 = u_1 * t0 + u_0 * t4;
            const real t15 = u_3 * t2 + u_2 * t6;
            const real d_vz = v[6 * 8 + j];
            const real d_x = x[4 * 8 + j];
            const real d_vx = v[4 * 8 + j];
            const real t16 = d_x * (t4 * t2 - t0 * t6) + d_vx * (u_2 * t4 + u_1 * t2 - u_3 * t0 - u_0 * t6);
            const real t17 = d_z * (t12 + t13) + 2.0 * (d_vz * (t14 + t15) + t16) + d_vy * (t8 + t9 - t10 - t11);
            g[0 * 8 + j] = d_y * (t1 + t3 - t5 - t7) + 2.0 * t17;
            const real t18 = d_x * (t0 * t2 + t4 * t6) + d_vx * (u_3 * t4 + u_1 * t6 + u_2 * t0 + u_0 * t2);
            const real t19 = d_y * (t13 - t12) + 2.0 * (d_vy * (t15 - t14) + t18) + d_vz * (t8 + t11 - t10 - t9);
            g[1 * 8 + j] = d_z * (t1 + t7 - t5 - t3) + 2.0 * t19;
        }
    }
}

/* rates: 189 operations.
 * in:  x (7), v (7), p (4)
 * out: Phi_x (2,7) */
FLEXEL_CLONES
static void slope_clamp_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (14 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl3 = v[3 * 8 + j];
            const real t_1 = p[1 * 8 + j];
            const real r_vl0 = v[0 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_vl2 = v[2 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_vl1 = v[1 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real t0 = r_vl0 * t_2 + r_vl2 * t_0 + r_vl3 * t_1 - r_vl1 * t_3;
            const real d_z = x[6 * 8 + j];
            const real r_l3 = x[3 * 8 + j];
            const real r_l0 = x[0 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real r_l1 = x[1 * 8 + j];
            const real u_2 = r_l0 * t_2 + r_l2 * t_0 + r_l3 * t_1 - r_l1 * t_3;
            const real d_vz = v[6 * 8 + j];
            const real u_0 = r_l0 * t_0 - r_l1 * t_1 - r_l2 * t_2 - r_l3 * t_3;
            const real d_vx = v[4 * 8 + j];
            const real u_3 = r_l0 * t_3 + r_l1 * t_2 + r_l3 * t_0 - r_l2 * t_1;
            const real d_vy = v[5 * 8 + j];
            const real t1 = r_vl0 * t_0 - r_vl1 * t_1 - r_vl2 * t_2 - r_vl3 * t_3;
            const real d_x = x[4 * 8 + j];
            const real t2 = d_z * t0 + d_vz * u_2 - d_vx * u_0 - d_vy * u_3 - d_x * t1;
            const real t3 = r_vl0 * t_3 + r_vl1 * t_2 + r_vl3 * t_0 - r_vl2 * t_1;
            const real d_y = x[5 * 8 + j];
            const real t4 = t2 - d_y * t3;
            const real t5 = 2.0 * t_3 * t4;
            const real u_1 = r_l0 * t_1 + r_l1 * t_0 + r_l2 * t_3 - r_l3 * t_2;
            const real t6 = d_vz * u_0 + d_vx * u_2 + d_z * t1 + d_x * t0 - d_vy * u_1;
            const real t7 = r_vl0 * t_1 + r_vl1 * t_0 + r_vl2 * t_3 - r_vl3 * t_2;
            const real t8 = t6 - d_y * t7;
            const real t9 = d_vz * u_1 + d_vy * u_0 + d_y * t1 + d_z * t7 - d_vx * u_3;
            const real t10 = t9 - d_x * t3;
            const real t11 = 2.0 * (t_1 * t8 + t_0 * t10);
            const real t12 = d_vy * u_2 + d_vx * u_1 + d_vz * u_3 + d_x * t7 + d_z * t3;
            const real t13 = d_y * t0 + t12;
            const real t14 = 2.0 * t_2 * t13;
            Phi_x[0 * 8 + j] = t11 + t14 + t5; /* Phi_x(0,0) */
            const real t15 = 2.0 * (t_0 * t8 - t_1 * t10);
            const real t16 = 2.0 * t_2 * t4;
            const real t17 = 2.0 * t_3 * t13;
            Phi_x[1 * 8 + j] = t15 + t16 - t17; /* Phi_x(0,1) */
            const real t18 = 2.0 * t_0 * t13;
            const real t19 = 2.0 * (t_2 * t10 - t_3 * t8);
            const real t20 = 2.0 * t_1 * t4;
            Phi_x[2 * 8 + j] = t18 - t19 - t20; /* Phi_x(0,2) */
            const real t21 = 2.0 * t_0 * t4;
            const real t22 = 2.0 * t_1 * t13;
            const real t23 = 2.0 * (t_2 * t8 + t_3 * t10);
            Phi_x[3 * 8 + j] = t21 + t22 - t23; /* Phi_x(0,3) */
            Phi_x[4 * 8 + j] = 2.0 * (u_2 * t7 + u_1 * t0 - u_3 * t1 - u_0 * t3); /* Phi_x(0,4) */
            const real t24 = 2.0 * u_0 * t1;
            const real t25 = 2.0 * u_2 * t0;
            const real t26 = 2.0 * u_1 * t7;
            const real t27 = 2.0 * u_3 * t3;
            Phi_x[5 * 8 + j] = t24 + t25 - t26 - t27; /* Phi_x(0,5) */
            const real t28 = u_1 * t1 + u_0 * t7;
            const real t29 = u_3 * t0 + u_2 * t3;
            Phi_x[6 * 8 + j] = 2.0 * (t28 + t29); /* Phi_x(0,6) */
            Phi_x[7 * 8 + j] = t15 + t17 - t16; /* Phi_x(1,0) */
            Phi_x[8 * 8 + j] = t5 + t14 - t11; /* Phi_x(1,1) */
            Phi_x[9 * 8 + j] = -(t23 + t22 + t21); /* Phi_x(1,2) */
            Phi_x[10 * 8 + j] = t19 + t18 - t20; /* Phi_x(1,3) */
            Phi_x[11 * 8 + j] = 2.0 * (u_3 * t7 + u_1 * t3 + u_2 * t1 + u_0 * t0); /* Phi_x(1,4) */
            Phi_x[12 * 8 + j] = 2.0 * (t29 - t28); /* Phi_x(1,5) */
            Phi_x[13 * 8 + j] = t24 + t27 - t26 - t25; /* Phi_x(1,6) */
        }
    }
}

/* kinematics: 414 operations.
 * in:  x (7), v (7), a (7), p (4)
 * out: Psi_x (2,7), Psi_v (2,7) */
FLEXEL_CLONES
static void slope_clamp_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        const real *restrict a = in[2] + b * (7 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (14 * 8);
        real *restrict Psi_v = out[1] + b * (14 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t_1 = p[1 * 8 + j];
            const real r_al3 = a[3 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_al0 = a[0 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_al2 = a[2 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real r_al1 = a[1 * 8 + j];
            const real t0 = t_2 * r_al0 + t_0 * r_al2 + t_1 * r_al3 - t_3 * r_al1;
            const real d_z = x[6 * 8 + j];
            const real r_l3 = x[3 * 8 + j];
            const real r_l0 = x[0 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real r_l1 = x[1 * 8 + j];
            const real u_2 = r_l0 * t_2 + r_l2 * t_0 + r_l3 * t_1 - r_l1 * t_3;
            const real d_az = a[6 * 8 + j];
            const real u_0 = r_l0 * t_0 - r_l1 * t_1 - r_l2 * t_2 - r_l3 * t_3;
            const real d_ax = a[4 * 8 + j];
            const real u_3 = r_l0 * t_3 + r_l1 * t_2 + r_l3 * t_0 - r_l2 * t_1;
            const real d_ay = a[5 * 8 + j];
            const real t1 = t_0 * r_al0 - t_1 * r_al1 - t_2 * r_al2 - t_3 * r_al3;
            const real d_x = x[4 * 8 + j];
            const real t2 = d_z * t0 + u_2 * d_az - u_0 * d_ax - u_3 * d_ay - d_x * t1;
            const real t3 = t_3 * r_al0 + t_2 * r_al1 + t_0 * r_al3 - t_1 * r_al2;
            const real d_y = x[5 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real r_vl0 = v[0 * 8 + j];
            const real r_vl2 = v[2 * 8 + j];
            const real r_vl1 = v[1 * 8 + j];
            const real t4 = r_vl0 * t_2 + r_vl2 * t_0 + r_vl3 * t_1 - r_vl1 * t_3;
            const real d_vz = v[6 * 8 + j];
            const real t5 = r_vl0 * t_0 - r_vl1 * t_1 - r_vl2 * t_2 - r_vl3 * t_3;
            const real d_vx = v[4 * 8 + j];
            const real t6 = r_vl0 * t_3 + r_vl1 * t_2 + r_vl3 * t_0 - r_vl2 * t_1;
            const real d_vy = v[5 * 8 + j];
            const real t7 = 2.0 * (t2 - d_y * t3) + 4.0 * (d_vz * t4 - d_vx * t5 - d_vy * t6);
            const real t8 = t_3 * t7;
            const real u_1 = r_l0 * t_1 + r_l1 * t_0 + r_l2 * t_3 - r_l3 * t_2;
            const real t9 = u_0 * d_az + u_2 * d_ax + d_z * t1 + d_x * t0 - u_1 * d_ay;
            const real t10 = t_1 * r_al0 + t_0 * r_al1 + t_3 * r_al2 - t_2 * r_al3;
            const real t11 = r_vl0 * t_1 + r_vl1 * t_0 + r_vl2 * t_3 - r_vl3 * t_2;
            const real t12 = 2.0 * (t9 - d_y * t10) + 4.0 * (d_vz * t5 + d_vx * t4 - d_vy * t11);
            const real t13 = u_1 * d_az + u_0 * d_ay + d_y * t1 + d_z * t10 - u_3 * d_ax;
            const real t14 = 2.0 * (t13 - d_x * t3) + 4.0 * (d_vz * t11 + d_vy * t5 - d_vx * t6);
            const real t15 = t_1 * t12 + t_0 * t14;
            const real t16 = u_2 * d_ay + u_1 * d_ax + u_3 * d_az + d_x * t10 + d_z * t3;
            const real t17 = 2.0 * (d_y * t0 + t16) + 4.0 * (d_vz * t6 + d_vx * t11 + d_vy * t4);
            const real t18 = t_2 * t17;
            Psi_x[0 * 8 + j] = t15 + t18 + t8; /* Psi_x(0,0) */
            const real t19 = t_0 * t12 - t_1 * t14;
            const real t20 = t_2 * t7;
            const real t21 = t_3 * t17;
            Psi_x[1 * 8 + j] = t19 + t20 - t21; /* Psi_x(0,1) */
            const real t22 = t_0 * t17;
            const real t23 = t_2 * t14 - t_3 * t12;
            const real t24 = t_1 * t7;
            Psi_x[2 * 8 + j] = t22 - t23 - t24; /* Psi_x(0,2) */
            const real t25 = t_0 * t7;
            const real t26 = t_1 * t17;
            const real t27 = t_2 * t12 + t_3 * t14;
            Psi_x[3 * 8 + j] = t25 + t26 - t27; /* Psi_x(0,3) */
            const real t28 = u_2 * t10 + 2.0 * (t11 * t4 - t5 * t6) + u_1 * t0 - u_3 * t1;
            Psi_x[4 * 8 + j] = 2.0 * (t28 - u_0 * t3); /* Psi_x(0,4) */
            const real t29 = 2.0 * u_0 * t1;
            const real t30 = 2.0 * t4 * t4;
            const real t31 = 2.0 * t5 * t5;
            const real t32 = 2.0 * u_2 * t0;
            const real t33 = 2.0 * t11 * t11;
            const real t34 = 2.0 * t6 * t6;
            const real t35 = 2.0 * u_1 * t10;
            const real t36 = 2.0 * u_3 * t3;
            Psi_x[5 * 8 + j] = t31 + t32 + t30 + t29 - t33 - t34 - t35 - t36; /* Psi_x(0,5) */
            const real t37 = u_3 * t0 + u_2 * t3;
            const real t38 = 2.0 * t5 * t11;
            const real t39 = 2.0 * t4 * t6;
            const real t40 = u_1 * t1 + u_0 * t10;
            Psi_x[6 * 8 + j] = 2.0 * (t38 + t39 + t40 + t37); /* Psi_x(0,6) */
            Psi_x[7 * 8 + j] = t19 + t21 - t20; /* Psi_x(1,0) */
            Psi_x[8 * 8 + j] = t8 + t18 - t15; /* Psi_x(1,1) */
            Psi_x[9 * 8 + j] = -(t27 + t26 + t25); /* Psi_x(1,2) */
            Psi_x[10 * 8 + j] = t23 + t22 - t24; /* Psi_x(1,3) */
            const real t41 = u_1 * t3 + 2.0 * (t5 * t4 + t11 * t6) + u_3 * t10 + u_2 * t1;
            Psi_x[11 * 8 + j] = 2.0 * (u_0 * t0 + t41); /* Psi_x(1,4) */
            Psi_x[12 * 8 + j] = 2.0 * (t39 + t37 - t38 - t40); /* Psi_x(1,5) */
            Psi_x[13 * 8 + j] = t31 + t36 + t34 + t29 - t33 - t30 - t35 - t32; /* Psi_x(1,6) */
            const real t42 = d_z * t4 + d_vz * u_2 - d_vx * u_0 - d_vy * u_3 - d_x * t5;
            const real t43 = t42 - d_y * t6;
            const real t44 = 2.0 * t_3 * t43;
            const real t45 = d_vz * u_0 + d_vx * u_2 + d_z * t5 + d_x * t4 - d_vy * u_1;
            const real t46 = t45 - d_y * t11;
            const real t47 = d_vz * u_1 + d_vy * u_0 + d_y * t5 + d_z * t11 - d_vx * u_3;
            const real t48 = t47 - d_x * t6;
            const real t49 = 2.0 * (t_1 * t46 + t_0 * t48);
            const real t50 = d_vy * u_2 + d_vx * u_1 + d_vz * u_3 + d_x * t11 + d_z * t6;
            const real t51 = d_y * t4 + t50;
            const real t52 = 2.0 * t_2 * t51;
            Psi_v[0 * 8 + j] = 2.0 * (t49 + t52 + t44); /* Psi_v(0,0) */
            const real t53 = 2.0 * (t_0 * t46 - t_1 * t48);
            const real t54 = 2.0 * t_2 * t43;
            const real t55 = 2.0 * t_3 * t51;
            Psi_v[1 * 8 + j] = 2.0 * (t53 + t54 - t55); /* Psi_v(0,1) */
            const real t56 = 2.0 * t_0 * t51;
            const real t57 = 2.0 * (t_2 * t48 - t_3 * t46);
            const real t58 = 2.0 * t_1 * t43;
            Psi_v[2 * 8 + j] = 2.0 * (t56 - t57 - t58); /* Psi_v(0,2) */
            const real t59 = 2.0 * t_0 * t43;
            const real t60 = 2.0 * t_1 * t51;
            const real t61 = 2.0 * (t_2 * t46 + t_3 * t48);
            Psi_v[3 * 8 + j] = 2.0 * (t59 + t60 - t61); /* Psi_v(0,3) */
            Psi_v[4 * 8 + j] = 4.0 * (u_2 * t11 + u_1 * t4 - u_3 * t5 - u_0 * t6); /* Psi_v(0,4) */
            const real t62 = 2.0 * u_0 * t5;
            const real t63 = 2.0 * u_2 * t4;
            const real t64 = 2.0 * u_1 * t11;
            const real t65 = 2.0 * u_3 * t6;
            Psi_v[5 * 8 + j] = 2.0 * (t62 + t63 - t64 - t65); /* Psi_v(0,5) */
            const real t66 = u_1 * t5 + u_0 * t11;
            const real t67 = u_3 * t4 + u_2 * t6;
            Psi_v[6 * 8 + j] = 4.0 * (t66 + t67); /* Psi_v(0,6) */
            Psi_v[7 * 8 + j] = 2.0 * (t53 + t55 - t54); /* Psi_v(1,0) */
            Psi_v[8 * 8 + j] = 2.0 * (t44 + t52 - t49); /* Psi_v(1,1) */
            Psi_v[9 * 8 + j] = -(2.0 * (t61 + t60 + t59)); /* Psi_v(1,2) */
            Psi_v[10 * 8 + j] = 2.0 * (t57 + t56 - t58); /* Psi_v(1,3) */
            Psi_v[11 * 8 + j] = 4.0 * (u_3 * t11 + u_1 * t6 + u_2 * t5 + u_0 * t4); /* Psi_v(1,4) */
            Psi_v[12 * 8 + j] = 4.0 * (t67 - t66); /* Psi_v(1,5) */
            Psi_v[13 * 8 + j] = 2.0 * (t62 + t65 - t64 - t63); /* Psi_v(1,6) */
        }
    }
}

/* stiffness: 263 operations.
 * in:  x (7), sigma (2), tau (0), p (4)
 * out: K (7,7), 40 of 49 entries */
FLEXEL_CLONES
static void slope_clamp_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict sigma = in[1] + b * (2 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict K = out[0] + b * (40 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real d_z = x[6 * 8 + j];
            const real sigma_across_z = sigma[1 * 8 + j];
            const real t0 = d_z * sigma_across_z;
            const real d_y = x[5 * 8 + j];
            const real sigma_across_y = sigma[0 * 8 + j];
            const real t1 = d_y * sigma_across_y;
            const real t2 = t0 - t1;
            const real t_3 = p[3 * 8 + j];
            const real t3 = 2.0 * t_3 * t2;
            const real d_x = x[4 * 8 + j];
            const real t4 = d_x * sigma_across_z;
            const real t_1 = p[1 * 8 + j];
            const real t5 = 2.0 * t_1 * t4;
            const real t6 = 2.0 * d_y * sigma_across_z;
            const real t7 = 2.0 * d_z * sigma_across_y;
            const real t8 = t6 + t7;
            const real t_2 = p[2 * 8 + j];
            const real t9 = t_2 * t8;
            const real t10 = d_x * sigma_across_y;
            const real t_0 = p[0 * 8 + j];
            const real t11 = 2.0 * t_0 * t10;
            const real t12 = t_3 * t8;
            const real t13 = 2.0 * t_0 * t4;
            const real t14 = 2.0 * t_1 * t10;
            const real t15 = t13 + t14;
            const real t16 = 2.0 * t_2 * t2;
            const real t17 = 2.0 * t_2 * t4;
            const real t18 = t0 + t1;
            const real t19 = 2.0 * t_0 * t18;
            const real t20 = t7 - t6;
            const real t21 = t_1 * t20;
            const real t22 = 2.0 * t_3 * t10;
            const real t23 = 2.0 * t_3 * t4;
            const real t24 = t_0 * t20;
            const real t25 = 2.0 * t_2 * t10;
            const real t26 = 2.0 * t_1 * t18;
            const real t27 = t_0 * (t19 + t21 + t17 - t22) + t_1 * (t24 + t25 + t23 - t26);
            K[0 * 8 + j] = t_2 * (t12 + t15 - t16) + t27 + t_3 * (t5 + t9 + t3 - t11); /* K(0,0) */
            const real t28 = t16 + t15 - t12;
            const real t29 = t11 + t3 + t9 - t5;
            const real t30 = t24 - t26 - t23 - t25;
            const real t31 = t17 - t21 - t19 - t22;
            K[1 * 8 + j] = K[7 * 8 + j] = t_0 * t30 + t_1 * t31 + t_2 * t29 + t_3 * t28; /* K(0,1) K(1,0) */
            const real t32 = t_0 * t8;
            const real t33 = 2.0 * t_1 * t2;
            const real t34 = t23 + t25 + t32 - t33;
            const real t35 = 2.0 * t_0 * t2;
            const real t36 = t_1 * t8;
            const real t37 = t22 - t17 - t35 - t36;
            const real t38 = t_3 * t20;
            const real t39 = 2.0 * t_2 * t18;
            const real t40 = t38 + t13 + t14 - t39;
            const real t41 = t_2 * t20;
            const real t42 = 2.0 * t_3 * t18;
            const real t43 = t11 - t41 - t42 - t5;
            K[2 * 8 + j] = K[14 * 8 + j] = t_0 * t40 + t_1 * t43 + t_2 * t37 + t_3 * t34; /* K(0,2) K(2,0) */
            const real t44 = t22 + t36 + t35 - t17;
            const real t45 = t32 - t23 - t25 - t33;
            const real t46 = t5 - t42 - t41 - t11;
            const real t47 = t39 + t14 + t13 - t38;
            K[3 * 8 + j] = K[21 * 8 + j] = t_0 * t46 + t_1 * t47 + t_2 * t45 + t_3 * t44; /* K(0,3) K(3,0) */
            const real r_l2 = x[2 * 8 + j];
            const real r_l0 = x[0 * 8 + j];
            const real r_l1 = x[1 * 8 + j];
            const real r_l3 = x[3 * 8 + j];
            const real u_1 = r_l0 * t_1 + r_l1 * t_0 + r_l2 * t_3 - r_l3 * t_2;
            const real u_0 = r_l0 * t_0 - r_l1 * t_1 - r_l2 * t_2 - r_l3 * t_3;
            const real t48 = 2.0 * u_1 * sigma_across_z - 2.0 * u_0 * sigma_across_y;
            const real t49 = t_3 * t48;
            const real t50 = 2.0 * u_0 * sigma_across_z + 2.0 * u_1 * sigma_across_y;
            const real t51 = t_2 * t50;
            const real u_2 = r_l0 * t_2 + r_l2 * t_0 + r_l3 * t_1 - r_l1 * t_3;
            const real u_3 = r_l0 * t_3 + r_l1 * t_2 + r_l3 * t_0 - r_l2 * t_1;
            const real t52 = 2.0 * u_2 * sigma_across_z - 2.0 * u_3 * sigma_across_y;
            const real t53 = t_0 * t52;
            const real t54 = 2.0 * u_3 * sigma_across_z + 2.0 * u_2 * sigma_across_y;
            const real t55 = t_1 * t54;
            K[4 * 8 + j] = K[28 * 8 + j] = t53 + t55 + t51 + t49; /* K(0,4) K(4,0) */
            const real t56 = t_3 * t52;
            const real t57 = t_2 * t54;
            const real t58 = t56 + t57;
            const real t59 = t_0 * t48;
            const real t60 = t_1 * t50;
            K[5 * 8 + j] = K[32 * 8 + j] = t58 - t59 - t60; /* K(0,5) K(5,0) */
            const real t61 = t_3 * t54;
            const real t62 = t_0 * t50;
            const real t63 = t61 + t62;
            const real t64 = t_1 * t48;
            const real t65 = t_2 * t52;
            K[6 * 8 + j] = K[36 * 8 + j] = t63 - t64 - t65; /* K(0,6) K(6,0) */
            K[8 * 8 + j] = t_0 * t31 + t_2 * t28 - t_1 * t30 - t_3 * t29; /* K(1,1) */
            K[9 * 8 + j] = K[15 * 8 + j] = t_0 * t43 + t_2 * t34 - t_1 * t40 - t_3 * t37; /* K(1,2) K(2,1) */
            K[10 * 8 + j] = K[22 * 8 + j] = t_0 * t47 + t_2 * t44 - t_1 * t46 - t_3 * t45; /* K(1,3) K(3,1) */
            const real t66 = t_0 * t54 + t_2 * t48;
            const real t67 = t_1 * t52;
            const real t68 = t_3 * t50;
            K[11 * 8 + j] = K[29 * 8 + j] = t66 - t67 - t68; /* K(1,4) K(4,1) */
            K[12 * 8 + j] = K[33 * 8 + j] = t65 + t64 - t62 - t61; /* K(1,5) K(5,1) */
            K[13 * 8 + j] = K[37 * 8 + j] = t58 - t60 - t59; /* K(1,6) K(6,1) */
            K[16 * 8 + j] = t_3 * t43 + t_0 * t37 - t_2 * t40 - t_1 * t34; /* K(2,2) */
            K[17 * 8 + j] = K[23 * 8 + j] = t_3 * t47 + t_0 * t45 - t_2 * t46 - t_1 * t44; /* K(2,3) K(3,2) */
            K[18 * 8 + j] = K[30 * 8 + j] = t63 - t65 - t64; /* K(2,4) K(4,2) */
            K[19 * 8 + j] = K[27 * 8 + j] = K[34 * 8 + j] = K[39 * 8 + j] = t66 - t68 - t67;
                /* K(2,5) K(3,6) K(5,2) K(6,3) */
            const real t69 = t51 + t49;
            K[20 * 8 + j] = K[38 * 8 + j] = -(t53 + t69 + t55); /* K(2,6) K(6,2) */
            K[24 * 8 + j] = t_1 * t45 + t_0 * t44 - t_3 * t46 - t_2 * t47; /* K(3,3) */
            K[25 * 8 + j] = K[31 * 8 + j] = t60 + t59 - t56 - t57; /* K(3,4) K(4,3) */
            K[26 * 8 + j] = K[35 * 8 + j] = t55 + t69 + t53; /* K(3,5) K(5,3) */
        }
    }
}

const flexel_element flexel_slope_clamp = {
    .name = "slope_clamp",
    .digest = "08bac3743f07f08a",
    .n = 7,
    .m = 2,
    .k = 0,
    .np = 4,
    .position = slope_clamp_position,
    .acceleration = slope_clamp_acceleration,
    .rates = slope_clamp_rates,
    .kinematics = slope_clamp_kinematics,
    .stiffness = slope_clamp_stiffness,
};
