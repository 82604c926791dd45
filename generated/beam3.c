/* beam3: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * triad ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp; d = xq - xp
 * (along, across1, across2) = R(u_p)' d - d0
 * w_p = angular velocity of the triad, in its own axes
 * T = rhoA l0/6 (vp.vp + vp.vq + vq.vq) + l0/2 sum rhoJ_i w_i^2, uniform bar
 * U = -rhoA l0 gravity.(xp + xq)/2
 * axes: the directions in rows;  displacement: the deformations that are lengths
 *
 * Source: Meijaard, Papadopoulos, Ruina and Schwab 2007, supplement, PINBODY; UT SPACAR, RBEAM
 *
 * x (10): p_x, p_y, p_z, rp_l0, rp_l1, rp_l2, rp_l3, q_x, q_y, q_z
 * e (3): along [m], across1 [m], across2 [m]
 * s (0): none
 * p (15):
 *   tp (4) [1]: unit quaternion from the body frame of node p to the element's triad there
 *   d0 (3) [m]: components of xq - xp on the triad at p when the deformations are zero
 *   l0 (1) [m]: undeformed length
 *   rhoA (1) [kg/m]: mass per length
 *   rhoJ (3) [kg m]: mass moments of inertia per length about the axes of the section's triad
 *   gravity (3) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* position: 172 operations.
 * in:  x (10), p (15)
 * out: e (3), De (3,10), V (0,10) */
FLEXEL_CLONES
static void beam3_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict p = in[1] + b * (15 * 8);
        real *restrict e = out[0] + b * (3 * 8);
        real *restrict De = out[1] + b * (30 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real t0 = u_p_0 * u_p_0;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t1 = u_p_1 * u_p_1;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t2 = u_p_2 * u_p_2;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t3 = u_p_3 * u_p_3;
            const real ex_p_x = t0 + t1 - t2 - t3;
            De[7 * 8 + j] = ex_p_x; /* De(0,7) */
            const real d0_x = p[4 * 8 + j];
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t4 = u_p_0 * u_p_3;
            const real t5 = u_p_1 * u_p_2;
            const real t6 = t4 + t5;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real t7 = u_p_1 * u_p_3;
            const real t8 = u_p_0 * u_p_2;
            const real t9 = t7 - t8;
            e[0 * 8 + j] = d_x * ex_p_x - d0_x + 2.0 * (d_y * t6 + d_z * t9);
            const real ey_p_y = t0 + t2 - t1 - t3;
            De[18 * 8 + j] = ey_p_y; /* De(1,8) */
            const real d0_y = p[5 * 8 + j];
            const real t10 = t5 - t4;
            const real t11 = u_p_0 * u_p_1;
            const real t12 = u_p_2 * u_p_3;
            const real t13 = t11 + t12;
            e[1 * 8 + j] = d_y * ey_p_y - d0_y + 2.0 * (d_x * t10 + d_z * t13);
            const real ez_p_z = t0 + t3 - t1 - t2;
            De[29 * 8 + j] = ez_p_z; /* De(2,9) */
            const real d0_z = p[6 * 8 + j];
            const real t14 = t8 + t7;
            const real t15 = t12 - t11;
            e[2 * 8 + j] = d_z * ez_p_z - d0_z + 2.0 * (d_x * t14 + d_y * t15);
            De[0 * 8 + j] = -ex_p_x; /* De(0,0) */
            const real ex_p_y = 2.0 * t6;
            De[8 * 8 + j] = ex_p_y; /* De(0,8) */
            De[1 * 8 + j] = -ex_p_y; /* De(0,1) */
            const real ex_p_z = 2.0 * t9;
            De[9 * 8 + j] = ex_p_z; /* De(0,9) */
            De[2 * 8 + j] = -ex_p_z; /* De(0,2) */
            const real t16 = 2.0 * u_p_1 * d_z - (2.0 * u_p_3 * d_x - 2.0 * u_p_0 * d_y);
            const real t17 = tp_3 * t16;
            const real t18 = 2.0 * u_p_3 * d_y + 2.0 * u_p_0 * d_x - 2.0 * u_p_2 * d_z;
            const real t19 = tp_0 * t18;
            const real t20 = 2.0 * u_p_2 * d_y + 2.0 * u_p_1 * d_x + 2.0 * u_p_3 * d_z;
            const real t21 = tp_1 * t20;
            const real t22 = 2.0 * u_p_2 * d_x - 2.0 * u_p_1 * d_y + 2.0 * u_p_0 * d_z;
            const real t23 = tp_2 * t22;
            De[3 * 8 + j] = t19 + t21 - t23 + t17; /* De(0,3) */
            const real t24 = tp_2 * t16;
            const real t25 = tp_3 * t22;
            const real t26 = tp_0 * t20;
            const real t27 = tp_1 * t18;
            De[4 * 8 + j] = t26 - t27 + t25 + t24; /* De(0,4) */
            const real t28 = tp_3 * t20;
            const real t29 = tp_2 * t18;
            const real t30 = tp_0 * t22;
            const real t31 = tp_1 * t16;
            De[5 * 8 + j] = t28 - t29 - t30 - t31; /* De(0,5) */
            const real t32 = tp_0 * t16;
            const real t33 = tp_1 * t22;
            const real t34 = tp_3 * t18;
            const real t35 = tp_2 * t20;
            De[6 * 8 + j] = t32 - (t34 + t35 + t33); /* De(0,6) */
            const real ey_p_x = 2.0 * t10;
            De[17 * 8 + j] = ey_p_x; /* De(1,7) */
            De[10 * 8 + j] = -ey_p_x; /* De(1,0) */
            De[11 * 8 + j] = -ey_p_y; /* De(1,1) */
            const real ey_p_z = 2.0 * t13;
            De[19 * 8 + j] = ey_p_z; /* De(1,9) */
            De[12 * 8 + j] = -ey_p_z; /* De(1,2) */
            const real t36 = t33 + t32;
            De[13 * 8 + j] = t36 + t35 - t34; /* De(1,3) */
            const real t37 = t30 - t31;
            De[14 * 8 + j] = t37 - t28 - t29; /* De(1,4) */
            const real t38 = t24 - t25;
            De[15 * 8 + j] = t26 - t38 + t27; /* De(1,5) */
            const real t39 = t23 + t17;
            De[16 * 8 + j] = t21 - t39 - t19; /* De(1,6) */
            const real ez_p_x = 2.0 * t14;
            De[27 * 8 + j] = ez_p_x; /* De(2,7) */
            De[20 * 8 + j] = -ez_p_x; /* De(2,0) */
            const real ez_p_y = 2.0 * t15;
            De[28 * 8 + j] = ez_p_y; /* De(2,8) */
            De[21 * 8 + j] = -ez_p_y; /* De(2,1) */
            De[22 * 8 + j] = -ez_p_z; /* De(2,2) */
            De[23 * 8 + j] = t29 + t37 + t28; /* De(2,3) */
            De[24 * 8 + j] = t35 - (t34 + t36); /* De(2,4) */
            De[25 * 8 + j] = t19 - t39 - t21; /* De(2,5) */
            De[26 * 8 + j] = t27 + t38 + t26; /* De(2,6) */
        }
    }
}

/* acceleration: 183 operations.
 * in:  x (10), v (10), p (15)
 * out: g (3), gs (0) */
FLEXEL_CLONES
static void beam3_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict v = in[1] + b * (10 * 8);
        const real *restrict p = in[2] + b * (15 * 8);
        real *restrict g = out[0] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t0 = q_vx - p_vx;
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t1 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t2 = 2.0 * u_p_0 * t1;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t3 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t4 = 2.0 * u_p_1 * t3;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t5 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t6 = 2.0 * u_p_2 * t5;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t7 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t8 = 2.0 * u_p_3 * t7;
            const real t9 = t0 * (t2 + t4 - t6 - t8);
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t10 = 2.0 * t1 * t1;
            const real t11 = 2.0 * t3 * t3;
            const real t12 = 2.0 * t5 * t5;
            const real t13 = 2.0 * t7 * t7;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t14 = q_vy - p_vy;
            const real t15 = u_p_0 * t7 + u_p_3 * t1;
            const real t16 = u_p_1 * t5 + u_p_2 * t3;
            const real t17 = t14 * (t15 + t16);
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t18 = 2.0 * t1 * t7;
            const real t19 = 2.0 * t3 * t5;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t20 = q_vz - p_vz;
            const real t21 = u_p_1 * t7 + u_p_3 * t3;
            const real t22 = u_p_0 * t5 + u_p_2 * t1;
            const real t23 = t20 * (t21 - t22);
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real t24 = 2.0 * t3 * t7;
            const real t25 = 2.0 * t1 * t5;
            const real t26 = t17 + d_y * (t18 + t19) + t17 + (t23 + d_z * (t24 - t25) + t23);
            g[0 * 8 + j] = t9 + d_x * (t10 + t11 - t12 - t13) + t9 + 2.0 * t26;
            const real t27 = t14 * (t2 + t6 - t4 - t8);
            const real t28 = t0 * (t16 - t15);
            const real t29 = u_p_0 * t3 + u_p_1 * t1;
            const real t30 = u_p_2 * t7 + u_p_3 * t5;
            const real t31 = t20 * (t29 + t30);
            const real t32 = 2.0 * t3 * t1;
            const real t33 = 2.0 * t7 * t5;
            const real t34 = t28 + d_x * (t19 - t18) + t28 + (t31 + d_z * (t32 + t33) + t31);
            g[1 * 8 + j] = t27 + d_y * (t10 + t12 - t11 - t13) + t27 + 2.0 * t34;
            const real t35 = t20 * (t2 + t8 - t4 - t6);
            const real t36 = t0 * (t22 + t21);
            const real t37 = t14 * (t30 - t29);
            const real t38 = t36 + d_x * (t25 + t24) + t36 + (t37 + d_y * (t33 - t32) + t37);
            g[2 * 8 + j] = t35 + d_z * (t10 + t13 - t11 - t12) + t35 + 2.0 * t38;
        }
    }
}

/* rates: 225 operations.
 * in:  x (10), v (10), p (15)
 * out: Phi_x (3,10) */
FLEXEL_CLONES
static void beam3_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict v = in[1] + b * (10 * 8);
        const real *restrict p = in[2] + b * (15 * 8);
        real *restrict Phi_x = out[0] + b * (30 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t0 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t1 = 2.0 * u_p_0 * t0;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t2 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t3 = 2.0 * u_p_1 * t2;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t4 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t5 = 2.0 * u_p_2 * t4;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t6 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t7 = 2.0 * u_p_3 * t6;
            const real t8 = t1 + t3 - t5 - t7;
            Phi_x[7 * 8 + j] = t8; /* Phi_x(0,7) */
            Phi_x[0 * 8 + j] = -t8; /* Phi_x(0,0) */
            const real t9 = u_p_0 * t6 + u_p_3 * t0;
            const real t10 = u_p_1 * t4 + u_p_2 * t2;
            const real t11 = 2.0 * (t9 + t10);
            Phi_x[8 * 8 + j] = t11; /* Phi_x(0,8) */
            Phi_x[1 * 8 + j] = -t11; /* Phi_x(0,1) */
            const real t12 = u_p_1 * t6 + u_p_3 * t2;
            const real t13 = u_p_0 * t4 + u_p_2 * t0;
            const real t14 = 2.0 * (t12 - t13);
            Phi_x[9 * 8 + j] = t14; /* Phi_x(0,9) */
            Phi_x[2 * 8 + j] = -t14; /* Phi_x(0,2) */
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t15 = q_vz - p_vz;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t16 = q_vy - p_vy;
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t17 = q_vx - p_vx;
            const real t18 = u_p_1 * t15 + u_p_0 * t16 + d_y * t0 + d_z * t2 - u_p_3 * t17;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t19 = t18 - d_x * t6;
            const real t20 = 2.0 * tp_3 * t19;
            const real t21 = d_y * t2 + u_p_1 * t16 - u_p_2 * t17 - u_p_0 * t15 - d_x * t4;
            const real t22 = t21 - d_z * t0;
            const real t23 = 2.0 * tp_2 * t22;
            const real t24 = u_p_3 * t16 + u_p_0 * t17 + d_x * t0 + d_y * t6 - u_p_2 * t15;
            const real t25 = t24 - d_z * t4;
            const real t26 = 2.0 * tp_0 * t25;
            const real t27 = u_p_2 * t16 + u_p_1 * t17 + u_p_3 * t15 + d_x * t2 + d_z * t6;
            const real t28 = d_y * t4 + t27;
            const real t29 = 2.0 * tp_1 * t28;
            Phi_x[3 * 8 + j] = t26 + t29 + t23 + t20; /* Phi_x(0,3) */
            const real t30 = 2.0 * tp_2 * t19;
            const real t31 = 2.0 * tp_0 * t28;
            const real t32 = 2.0 * tp_1 * t25;
            const real t33 = 2.0 * tp_3 * t22;
            Phi_x[4 * 8 + j] = t30 + t31 - t32 - t33; /* Phi_x(0,4) */
            const real t34 = 2.0 * tp_0 * t22;
            const real t35 = 2.0 * tp_3 * t28;
            const real t36 = 2.0 * tp_2 * t25;
            const real t37 = 2.0 * tp_1 * t19;
            Phi_x[5 * 8 + j] = t34 + t35 - t36 - t37; /* Phi_x(0,5) */
            const real t38 = 2.0 * tp_1 * t22;
            const real t39 = 2.0 * tp_0 * t19;
            const real t40 = 2.0 * tp_3 * t25;
            const real t41 = 2.0 * tp_2 * t28;
            Phi_x[6 * 8 + j] = t38 + t39 - t40 - t41; /* Phi_x(0,6) */
            const real t42 = 2.0 * (t10 - t9);
            Phi_x[17 * 8 + j] = t42; /* Phi_x(1,7) */
            Phi_x[10 * 8 + j] = -t42; /* Phi_x(1,0) */
            const real t43 = t1 + t5 - t3 - t7;
            Phi_x[18 * 8 + j] = t43; /* Phi_x(1,8) */
            Phi_x[11 * 8 + j] = -t43; /* Phi_x(1,1) */
            const real t44 = u_p_0 * t2 + u_p_1 * t0;
            const real t45 = u_p_2 * t6 + u_p_3 * t4;
            const real t46 = 2.0 * (t44 + t45);
            Phi_x[19 * 8 + j] = t46; /* Phi_x(1,9) */
            Phi_x[12 * 8 + j] = -t46; /* Phi_x(1,2) */
            const real t47 = t38 - t39;
            Phi_x[13 * 8 + j] = t41 - t47 - t40; /* Phi_x(1,3) */
            const real t48 = t34 + t37;
            const real t49 = t36 + t35;
            Phi_x[14 * 8 + j] = -(t48 + t49); /* Phi_x(1,4) */
            const real t50 = t32 + t31;
            const real t51 = t33 + t30;
            Phi_x[15 * 8 + j] = t50 - t51; /* Phi_x(1,5) */
            const real t52 = t23 - t20;
            Phi_x[16 * 8 + j] = t52 + t29 - t26; /* Phi_x(1,6) */
            const real t53 = 2.0 * (t13 + t12);
            Phi_x[27 * 8 + j] = t53; /* Phi_x(2,7) */
            Phi_x[20 * 8 + j] = -t53; /* Phi_x(2,0) */
            const real t54 = 2.0 * (t45 - t44);
            Phi_x[28 * 8 + j] = t54; /* Phi_x(2,8) */
            Phi_x[21 * 8 + j] = -t54; /* Phi_x(2,1) */
            const real t55 = t1 + t7 - t3 - t5;
            Phi_x[29 * 8 + j] = t55; /* Phi_x(2,9) */
            Phi_x[22 * 8 + j] = -t55; /* Phi_x(2,2) */
            Phi_x[23 * 8 + j] = t49 - t48; /* Phi_x(2,3) */
            Phi_x[24 * 8 + j] = t47 + t41 - t40; /* Phi_x(2,4) */
            Phi_x[25 * 8 + j] = t26 + t52 - t29; /* Phi_x(2,5) */
            Phi_x[26 * 8 + j] = t51 + t50; /* Phi_x(2,6) */
        }
    }
}

/* kinematics: 494 operations.
 * in:  x (10), v (10), a (10), p (15)
 * out: Psi_x (3,10), Psi_v (3,10) */
FLEXEL_CLONES
static void beam3_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict v = in[1] + b * (10 * 8);
        const real *restrict a = in[2] + b * (10 * 8);
        const real *restrict p = in[3] + b * (15 * 8);
        real *restrict Psi_x = out[0] + b * (30 * 8);
        real *restrict Psi_v = out[1] + b * (30 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real rp_al0 = a[3 * 8 + j];
            const real rp_al1 = a[4 * 8 + j];
            const real rp_al2 = a[5 * 8 + j];
            const real rp_al3 = a[6 * 8 + j];
            const real t0 = tp_0 * rp_al0 - tp_1 * rp_al1 - tp_2 * rp_al2 - tp_3 * rp_al3;
            const real t1 = 2.0 * u_p_0 * t0;
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t2 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t3 = 2.0 * t2 * t2;
            const real t4 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t5 = 2.0 * t4 * t4;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t6 = tp_1 * rp_al0 + tp_0 * rp_al1 + tp_3 * rp_al2 - tp_2 * rp_al3;
            const real t7 = 2.0 * u_p_1 * t6;
            const real t8 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t9 = 2.0 * t8 * t8;
            const real t10 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t11 = 2.0 * t10 * t10;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t12 = tp_2 * rp_al0 + tp_0 * rp_al2 + tp_1 * rp_al3 - tp_3 * rp_al1;
            const real t13 = 2.0 * u_p_2 * t12;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t14 = tp_3 * rp_al0 + tp_2 * rp_al1 + tp_0 * rp_al3 - tp_1 * rp_al2;
            const real t15 = 2.0 * u_p_3 * t14;
            const real t16 = t5 + t7 + t3 + t1 - t9 - t11 - t13 - t15;
            Psi_x[7 * 8 + j] = t16; /* Psi_x(0,7) */
            Psi_x[0 * 8 + j] = -t16; /* Psi_x(0,0) */
            const real t17 = u_p_2 * t6 + u_p_1 * t12;
            const real t18 = 2.0 * t4 * t10;
            const real t19 = 2.0 * t2 * t8;
            const real t20 = u_p_3 * t0 + u_p_0 * t14;
            const real t21 = 2.0 * (t18 + t19 + t20 + t17);
            Psi_x[8 * 8 + j] = t21; /* Psi_x(0,8) */
            Psi_x[1 * 8 + j] = -t21; /* Psi_x(0,1) */
            const real t22 = 2.0 * t2 * t10;
            const real t23 = u_p_3 * t6 + u_p_1 * t14;
            const real t24 = 2.0 * t4 * t8;
            const real t25 = u_p_2 * t0 + u_p_0 * t12;
            const real t26 = 2.0 * (t22 + t23 - t24 - t25);
            Psi_x[9 * 8 + j] = t26; /* Psi_x(0,9) */
            Psi_x[2 * 8 + j] = -t26; /* Psi_x(0,2) */
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_az = a[9 * 8 + j];
            const real p_az = a[2 * 8 + j];
            const real t27 = q_az - p_az;
            const real q_ay = a[8 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t28 = q_ay - p_ay;
            const real q_ax = a[7 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t29 = q_ax - p_ax;
            const real t30 = u_p_1 * t27 + u_p_0 * t28 + d_y * t0 + d_z * t6 - u_p_3 * t29;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t31 = q_vy - p_vy;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t32 = q_vz - p_vz;
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t33 = q_vx - p_vx;
            const real t34 = 2.0 * (t30 - d_x * t14) + 4.0 * (t4 * t31 + t2 * t32 - t10 * t33);
            const real t35 = tp_3 * t34;
            const real t36 = d_y * t6 + u_p_1 * t28 - u_p_2 * t29 - u_p_0 * t27 - d_x * t12;
            const real t37 = 2.0 * (t36 - d_z * t0) + 4.0 * (t2 * t31 - t8 * t33 - t4 * t32);
            const real t38 = tp_2 * t37;
            const real t39 = u_p_3 * t28 + u_p_0 * t29 + d_x * t0 + d_y * t14 - u_p_2 * t27;
            const real t40 = 2.0 * (t39 - d_z * t12) + 4.0 * (t4 * t33 + t10 * t31 - t8 * t32);
            const real t41 = tp_0 * t40;
            const real t42 = u_p_2 * t28 + u_p_1 * t29 + u_p_3 * t27 + d_x * t6 + d_z * t14;
            const real t43 = 2.0 * (d_y * t12 + t42) + 4.0 * (t2 * t33 + t10 * t32 + t8 * t31);
            const real t44 = tp_1 * t43;
            Psi_x[3 * 8 + j] = t41 + t44 + t38 + t35; /* Psi_x(0,3) */
            const real t45 = tp_2 * t34;
            const real t46 = tp_0 * t43;
            const real t47 = tp_1 * t40;
            const real t48 = tp_3 * t37;
            Psi_x[4 * 8 + j] = t45 + t46 - t47 - t48; /* Psi_x(0,4) */
            const real t49 = tp_0 * t37;
            const real t50 = tp_3 * t43;
            const real t51 = tp_2 * t40;
            const real t52 = tp_1 * t34;
            Psi_x[5 * 8 + j] = t49 + t50 - t51 - t52; /* Psi_x(0,5) */
            const real t53 = tp_1 * t37;
            const real t54 = tp_0 * t34;
            const real t55 = tp_3 * t40;
            const real t56 = tp_2 * t43;
            Psi_x[6 * 8 + j] = t53 + t54 - t55 - t56; /* Psi_x(0,6) */
            const real t57 = 2.0 * (t19 + t17 - t18 - t20);
            Psi_x[17 * 8 + j] = t57; /* Psi_x(1,7) */
            Psi_x[10 * 8 + j] = -t57; /* Psi_x(1,0) */
            const real t58 = t5 + t13 + t9 + t1 - t3 - t11 - t7 - t15;
            Psi_x[18 * 8 + j] = t58; /* Psi_x(1,8) */
            Psi_x[11 * 8 + j] = -t58; /* Psi_x(1,1) */
            const real t59 = u_p_3 * t12 + u_p_2 * t14;
            const real t60 = 2.0 * t2 * t4;
            const real t61 = 2.0 * t10 * t8;
            const real t62 = u_p_1 * t0 + u_p_0 * t6;
            const real t63 = 2.0 * (t60 + t61 + t62 + t59);
            Psi_x[19 * 8 + j] = t63; /* Psi_x(1,9) */
            Psi_x[12 * 8 + j] = -t63; /* Psi_x(1,2) */
            const real t64 = t53 - t54;
            Psi_x[13 * 8 + j] = t56 - t64 - t55; /* Psi_x(1,3) */
            const real t65 = t49 + t52;
            const real t66 = t51 + t50;
            Psi_x[14 * 8 + j] = -(t65 + t66); /* Psi_x(1,4) */
            const real t67 = t47 + t46;
            const real t68 = t48 + t45;
            Psi_x[15 * 8 + j] = t67 - t68; /* Psi_x(1,5) */
            const real t69 = t38 - t35;
            Psi_x[16 * 8 + j] = t69 + t44 - t41; /* Psi_x(1,6) */
            const real t70 = 2.0 * (t24 + t22 + t25 + t23);
            Psi_x[27 * 8 + j] = t70; /* Psi_x(2,7) */
            Psi_x[20 * 8 + j] = -t70; /* Psi_x(2,0) */
            const real t71 = 2.0 * (t61 + t59 - t60 - t62);
            Psi_x[28 * 8 + j] = t71; /* Psi_x(2,8) */
            Psi_x[21 * 8 + j] = -t71; /* Psi_x(2,1) */
            const real t72 = t5 + t15 + t11 + t1 - t3 - t9 - t7 - t13;
            Psi_x[29 * 8 + j] = t72; /* Psi_x(2,9) */
            Psi_x[22 * 8 + j] = -t72; /* Psi_x(2,2) */
            Psi_x[23 * 8 + j] = t66 - t65; /* Psi_x(2,3) */
            Psi_x[24 * 8 + j] = t64 + t56 - t55; /* Psi_x(2,4) */
            Psi_x[25 * 8 + j] = t41 + t69 - t44; /* Psi_x(2,5) */
            Psi_x[26 * 8 + j] = t68 + t67; /* Psi_x(2,6) */
            const real t73 = 2.0 * u_p_0 * t4;
            const real t74 = 2.0 * u_p_1 * t2;
            const real t75 = 2.0 * u_p_2 * t8;
            const real t76 = 2.0 * u_p_3 * t10;
            const real t77 = 2.0 * (t73 + t74 - t75 - t76);
            Psi_v[7 * 8 + j] = t77; /* Psi_v(0,7) */
            Psi_v[0 * 8 + j] = -t77; /* Psi_v(0,0) */
            const real t78 = u_p_0 * t10 + u_p_3 * t4;
            const real t79 = u_p_1 * t8 + u_p_2 * t2;
            const real t80 = 4.0 * (t78 + t79);
            Psi_v[8 * 8 + j] = t80; /* Psi_v(0,8) */
            Psi_v[1 * 8 + j] = -t80; /* Psi_v(0,1) */
            const real t81 = u_p_1 * t10 + u_p_3 * t2;
            const real t82 = u_p_0 * t8 + u_p_2 * t4;
            const real t83 = 4.0 * (t81 - t82);
            Psi_v[9 * 8 + j] = t83; /* Psi_v(0,9) */
            Psi_v[2 * 8 + j] = -t83; /* Psi_v(0,2) */
            const real t84 = u_p_1 * t32 + u_p_0 * t31 + d_y * t4 + d_z * t2 - u_p_3 * t33;
            const real t85 = t84 - d_x * t10;
            const real t86 = 2.0 * tp_3 * t85;
            const real t87 = d_y * t2 + u_p_1 * t31 - u_p_2 * t33 - u_p_0 * t32 - d_x * t8;
            const real t88 = t87 - d_z * t4;
            const real t89 = 2.0 * tp_2 * t88;
            const real t90 = u_p_3 * t31 + u_p_0 * t33 + d_x * t4 + d_y * t10 - u_p_2 * t32;
            const real t91 = t90 - d_z * t8;
            const real t92 = 2.0 * tp_0 * t91;
            const real t93 = u_p_2 * t31 + u_p_1 * t33 + u_p_3 * t32 + d_x * t2 + d_z * t10;
            const real t94 = d_y * t8 + t93;
            const real t95 = 2.0 * tp_1 * t94;
            Psi_v[3 * 8 + j] = 2.0 * (t92 + t95 + t89 + t86); /* Psi_v(0,3) */
            const real t96 = 2.0 * tp_2 * t85;
            const real t97 = 2.0 * tp_0 * t94;
            const real t98 = 2.0 * tp_1 * t91;
            const real t99 = 2.0 * tp_3 * t88;
            Psi_v[4 * 8 + j] = 2.0 * (t96 + t97 - t98 - t99); /* Psi_v(0,4) */
            const real t100 = 2.0 * tp_0 * t88;
            const real t101 = 2.0 * tp_3 * t94;
            const real t102 = 2.0 * tp_2 * t91;
            const real t103 = 2.0 * tp_1 * t85;
            Psi_v[5 * 8 + j] = 2.0 * (t100 + t101 - t102 - t103); /* Psi_v(0,5) */
            const real t104 = 2.0 * tp_1 * t88;
            const real t105 = 2.0 * tp_0 * t85;
            const real t106 = 2.0 * tp_3 * t91;
            const real t107 = 2.0 * tp_2 * t94;
            Psi_v[6 * 8 + j] = 2.0 * (t104 + t105 - t106 - t107); /* Psi_v(0,6) */
            const real t108 = 4.0 * (t79 - t78);
            Psi_v[17 * 8 + j] = t108; /* Psi_v(1,7) */
            Psi_v[10 * 8 + j] = -t108; /* Psi_v(1,0) */
            const real t109 = 2.0 * (t73 + t75 - t74 - t76);
            Psi_v[18 * 8 + j] = t109; /* Psi_v(1,8) */
            Psi_v[11 * 8 + j] = -t109; /* Psi_v(1,1) */
            const real t110 = u_p_0 * t2 + u_p_1 * t4;
            const real t111 = u_p_2 * t10 + u_p_3 * t8;
            const real t112 = 4.0 * (t110 + t111);
            Psi_v[19 * 8 + j] = t112; /* Psi_v(1,9) */
            Psi_v[12 * 8 + j] = -t112; /* Psi_v(1,2) */
            const real t113 = t104 - t105;
            Psi_v[13 * 8 + j] = 2.0 * (t107 - t113 - t106); /* Psi_v(1,3) */
            const real t114 = t100 + t103;
            const real t115 = t102 + t101;
            Psi_v[14 * 8 + j] = -(2.0 * (t114 + t115)); /* Psi_v(1,4) */
            const real t116 = t98 + t97;
            const real t117 = t99 + t96;
            Psi_v[15 * 8 + j] = 2.0 * (t116 - t117); /* Psi_v(1,5) */
            const real t118 = t89 - t86;
            Psi_v[16 * 8 + j] = 2.0 * (t118 + t95 - t92); /* Psi_v(1,6) */
            const real t119 = 4.0 * (t82 + t81);
            Psi_v[27 * 8 + j] = t119; /* Psi_v(2,7) */
            Psi_v[20 * 8 + j] = -t119; /* Psi_v(2,0) */
            const real t120 = 4.0 * (t111 - t110);
            Psi_v[28 * 8 + j] = t120; /* Psi_v(2,8) */
            Psi_v[21 * 8 + j] = -t120; /* Psi_v(2,1) */
            const real t121 = 2.0 * (t73 + t76 - t74 - t75);
            Psi_v[29 * 8 + j] = t121; /* Psi_v(2,9) */
            Psi_v[22 * 8 + j] = -t121; /* Psi_v(2,2) */
            Psi_v[23 * 8 + j] = 2.0 * (t115 - t114); /* Psi_v(2,3) */
            Psi_v[24 * 8 + j] = 2.0 * (t113 + t107 - t106); /* Psi_v(2,4) */
            Psi_v[25 * 8 + j] = 2.0 * (t92 + t118 - t95); /* Psi_v(2,5) */
            Psi_v[26 * 8 + j] = 2.0 * (t117 + t116); /* Psi_v(2,6) */
        }
    }
}

/* stiffness: 328 operations.
 * in:  x (10), sigma (3), tau (0), p (15)
 * out: K (10,10), 64 of 100 entries */
FLEXEL_CLONES
static void beam3_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (15 * 8);
        real *restrict K = out[0] + b * (64 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real sigma_across2 = sigma[2 * 8 + j];
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real sigma_across1 = sigma[1 * 8 + j];
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real sigma_along = sigma[0 * 8 + j];
            const real t0 = 2.0 * u_p_1 * sigma_across1 - 2.0 * u_p_2 * sigma_along + 2.0 * u_p_0 * sigma_across2;
            const real t1 = tp_2 * t0;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t2 = 2.0 * u_p_2 * sigma_across2 - (2.0 * u_p_3 * sigma_across1 - 2.0 * u_p_0 * sigma_along);
            const real t3 = tp_0 * t2;
            const real t4 = 2.0 * u_p_2 * sigma_across1 + 2.0 * u_p_1 * sigma_along + 2.0 * u_p_3 * sigma_across2;
            const real t5 = tp_1 * t4;
            const real t6 = 2.0 * u_p_0 * sigma_across1 + 2.0 * u_p_3 * sigma_along - 2.0 * u_p_1 * sigma_across2;
            const real t7 = tp_3 * t6;
            const real t8 = t3 + t5 + t1 - t7;
            K[19 * 8 + j] = K[52 * 8 + j] = t8; /* K(3,7) K(7,3) */
            K[0 * 8 + j] = K[12 * 8 + j] = -t8; /* K(0,3) K(3,0) */
            const real t9 = tp_0 * t4;
            const real t10 = tp_1 * t2;
            const real t11 = tp_3 * t0;
            const real t12 = tp_2 * t6;
            const real t13 = t9 - t10 - t11 - t12;
            K[29 * 8 + j] = K[53 * 8 + j] = t13; /* K(4,7) K(7,4) */
            K[1 * 8 + j] = K[22 * 8 + j] = -t13; /* K(0,4) K(4,0) */
            const real t14 = tp_1 * t6;
            const real t15 = tp_3 * t4;
            const real t16 = tp_0 * t0;
            const real t17 = tp_2 * t2;
            const real t18 = t15 + t16 + t14 - t17;
            K[39 * 8 + j] = K[54 * 8 + j] = t18; /* K(5,7) K(7,5) */
            K[2 * 8 + j] = K[32 * 8 + j] = -t18; /* K(0,5) K(5,0) */
            const real t19 = tp_1 * t0;
            const real t20 = tp_3 * t2;
            const real t21 = tp_2 * t4;
            const real t22 = tp_0 * t6;
            const real t23 = t19 - t20 - t21 - t22;
            K[49 * 8 + j] = K[55 * 8 + j] = t23; /* K(6,7) K(7,6) */
            K[3 * 8 + j] = K[42 * 8 + j] = -t23; /* K(0,6) K(6,0) */
            const real t24 = t21 + t22 + t20 - t19;
            K[20 * 8 + j] = K[56 * 8 + j] = t24; /* K(3,8) K(8,3) */
            K[4 * 8 + j] = K[13 * 8 + j] = -t24; /* K(1,3) K(3,1) */
            const real t25 = t17 - t14 - t16 - t15;
            K[30 * 8 + j] = K[57 * 8 + j] = t25; /* K(4,8) K(8,4) */
            K[5 * 8 + j] = K[23 * 8 + j] = -t25; /* K(1,4) K(4,1) */
            const real t26 = t9 - t12 - t11 - t10;
            K[40 * 8 + j] = K[58 * 8 + j] = t26; /* K(5,8) K(8,5) */
            K[6 * 8 + j] = K[33 * 8 + j] = -t26; /* K(1,5) K(5,1) */
            const real t27 = t5 + t1 + t3 - t7;
            K[50 * 8 + j] = K[59 * 8 + j] = t27; /* K(6,8) K(8,6) */
            K[7 * 8 + j] = K[43 * 8 + j] = -t27; /* K(1,6) K(6,1) */
            const real t28 = t16 + t14 + t15 - t17;
            K[21 * 8 + j] = K[60 * 8 + j] = t28; /* K(3,9) K(9,3) */
            K[8 * 8 + j] = K[14 * 8 + j] = -t28; /* K(2,3) K(3,2) */
            const real t29 = t20 + t22 + t21 - t19;
            K[31 * 8 + j] = K[61 * 8 + j] = t29; /* K(4,9) K(9,4) */
            K[9 * 8 + j] = K[24 * 8 + j] = -t29; /* K(2,4) K(4,2) */
            const real t30 = t7 - t1 - t3 - t5;
            K[41 * 8 + j] = K[62 * 8 + j] = t30; /* K(5,9) K(9,5) */
            K[10 * 8 + j] = K[34 * 8 + j] = -t30; /* K(2,5) K(5,2) */
            const real t31 = t9 - t11 - t12 - t10;
            K[51 * 8 + j] = K[63 * 8 + j] = t31; /* K(6,9) K(9,6) */
            K[11 * 8 + j] = K[44 * 8 + j] = -t31; /* K(2,6) K(6,2) */
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real t32 = d_z * sigma_across2;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t33 = d_y * sigma_across1;
            const real t34 = t32 - t33;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t35 = d_x * sigma_along;
            const real t36 = t34 - t35;
            const real t37 = 2.0 * d_y * sigma_across2;
            const real t38 = 2.0 * d_z * sigma_across1;
            const real t39 = t37 + t38;
            const real t40 = tp_2 * t39;
            const real t41 = 2.0 * d_y * sigma_along;
            const real t42 = 2.0 * d_x * sigma_across1;
            const real t43 = t41 - t42;
            const real t44 = tp_0 * t43;
            const real t45 = 2.0 * d_x * sigma_across2;
            const real t46 = 2.0 * d_z * sigma_along;
            const real t47 = t45 + t46;
            const real t48 = tp_1 * t47;
            const real t49 = tp_3 * t39;
            const real t50 = t45 - t46;
            const real t51 = tp_0 * t50;
            const real t52 = t42 + t41;
            const real t53 = tp_1 * t52;
            const real t54 = t35 + t34;
            const real t55 = tp_3 * t43;
            const real t56 = tp_2 * t50;
            const real t57 = t32 + t33;
            const real t58 = t35 + t57;
            const real t59 = t38 - t37;
            const real t60 = tp_1 * t59;
            const real t61 = tp_3 * t47;
            const real t62 = tp_2 * t52;
            const real t63 = tp_0 * t59;
            const real t64 = t35 - t57;
            const real t65 = tp_0 * (2.0 * tp_0 * t58 + t60 + t56 + t55) + tp_1 * (t63 + 2.0 * tp_1 * t64 + t62
                + t61);
            K[15 * 8 + j] = tp_2 * (t51 + t53 + t49 - 2.0 * tp_2 * t54) + t65 + tp_3 * (t44 + t48 + t40 + 2.0 * tp_3
                * t36); /* K(3,3) */
            const real t66 = tp_0 * t47;
            const real t67 = tp_1 * t43;
            const real t68 = t66 + 2.0 * tp_2 * t36 - t67 - t49;
            const real t69 = tp_0 * t52;
            const real t70 = tp_1 * t50;
            const real t71 = t69 + 2.0 * tp_3 * t54 + t40 - t70;
            const real t72 = tp_2 * t43;
            const real t73 = tp_3 * t50;
            const real t74 = t63 + t72 - 2.0 * tp_1 * t58 - t73;
            const real t75 = tp_2 * t47;
            const real t76 = tp_3 * t52;
            const real t77 = 2.0 * tp_0 * t64 + t75 - t60 - t76;
            K[16 * 8 + j] = K[25 * 8 + j] = tp_0 * t74 + tp_1 * t77 + tp_2 * t71 + tp_3 * t68; /* K(3,4) K(4,3) */
            const real t78 = tp_0 * t39;
            const real t79 = t61 + t78 - t72 - 2.0 * tp_1 * t36;
            const real t80 = tp_1 * t39;
            const real t81 = t76 - t56 - 2.0 * tp_0 * t54 - t80;
            const real t82 = tp_3 * t59;
            const real t83 = t82 + t51 - 2.0 * tp_2 * t58 - t67;
            const real t84 = tp_2 * t59;
            const real t85 = 2.0 * tp_3 * t64 + t69 - t84 - t48;
            K[17 * 8 + j] = K[35 * 8 + j] = tp_0 * t83 + tp_1 * t85 + tp_2 * t81 + tp_3 * t79; /* K(3,5) K(5,3) */
            const real t86 = t80 + 2.0 * tp_0 * t36 - t55 - t75;
            const real t87 = t78 - t73 - t62 - 2.0 * tp_1 * t54;
            const real t88 = t70 + t44 - 2.0 * tp_3 * t58 - t84;
            const real t89 = t53 + t66 - t82 - 2.0 * tp_2 * t64;
            K[18 * 8 + j] = K[45 * 8 + j] = tp_0 * t88 + tp_1 * t89 + tp_2 * t87 + tp_3 * t86; /* K(3,6) K(6,3) */
            K[26 * 8 + j] = tp_0 * t77 + tp_2 * t68 - tp_1 * t74 - tp_3 * t71; /* K(4,4) */
            K[27 * 8 + j] = K[36 * 8 + j] = tp_0 * t85 + tp_2 * t79 - tp_1 * t83 - tp_3 * t81; /* K(4,5) K(5,4) */
            K[28 * 8 + j] = K[46 * 8 + j] = tp_0 * t89 + tp_2 * t86 - tp_1 * t88 - tp_3 * t87; /* K(4,6) K(6,4) */
            K[37 * 8 + j] = tp_3 * t85 + tp_0 * t81 - tp_2 * t83 - tp_1 * t79; /* K(5,5) */
            K[38 * 8 + j] = K[47 * 8 + j] = tp_3 * t89 + tp_0 * t87 - tp_2 * t88 - tp_1 * t86; /* K(5,6) K(6,5) */
            K[48 * 8 + j] = tp_1 * t87 + tp_0 * t86 - tp_3 * t88 - tp_2 * t89; /* K(6,6) */
        }
    }
}

/* inertia: 410 operations.
 * in:  x (10), v (10), p (15)
 * out: M (10,10), 28 of 100 entries, h (10), 4 of 10 entries, f (10), 6 of 10 entries, U (1) */
FLEXEL_CLONES
static void beam3_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict v = in[1] + b * (10 * 8);
        const real *restrict p = in[2] + b * (15 * 8);
        real *restrict M = out[0] + b * (28 * 8);
        real *restrict h = out[1] + b * (4 * 8);
        real *restrict f = out[2] + b * (6 * 8);
        real *restrict U = out[3] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[7 * 8 + j];
            const real rhoA = p[8 * 8 + j];
            const real t0 = l0 * rhoA;
            M[0 * 8 + j] = M[2 * 8 + j] = M[4 * 8 + j] = M[23 * 8 + j] = M[25 * 8 + j] = M[27 * 8 + j]
                = 0.3333333333333333 * t0; /* M(0,0) M(1,1) M(2,2) M(7,7) M(8,8) M(9,9) */
            M[1 * 8 + j] = M[3 * 8 + j] = M[5 * 8 + j] = M[22 * 8 + j] = M[24 * 8 + j] = M[26 * 8 + j]
                = 0.16666666666666666 * t0; /* M(0,7) M(1,8) M(2,9) M(7,0) M(8,1) M(9,2) */
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real rhoJ_z = p[11 * 8 + j];
            const real t1 = l0 * rhoJ_z;
            const real t2 = u_p_0 * t1;
            const real u_p_2 = rp_l0 * tp_2 + rp_l3 * tp_1 + rp_l2 * tp_0 - rp_l1 * tp_3;
            const real t3 = u_p_2 * t1;
            const real u_p_3 = rp_l0 * tp_3 + rp_l3 * tp_0 + rp_l1 * tp_2 - rp_l2 * tp_1;
            const real t4 = u_p_3 * t1;
            const real u_p_1 = rp_l0 * tp_1 + rp_l2 * tp_3 + rp_l1 * tp_0 - rp_l3 * tp_2;
            const real t5 = u_p_1 * t1;
            const real t6 = 4.0 * tp_3 * u_p_0;
            const real t7 = 4.0 * tp_2 * u_p_1;
            const real t8 = t6 - t7;
            const real t9 = 4.0 * tp_1 * u_p_2;
            const real t10 = 4.0 * tp_0 * u_p_3;
            const real t11 = t8 + t9 - t10;
            const real t12 = 4.0 * tp_2 * u_p_0;
            const real t13 = 4.0 * tp_3 * u_p_1;
            const real t14 = t12 + t13;
            const real t15 = 4.0 * tp_0 * u_p_2;
            const real t16 = 4.0 * tp_1 * u_p_3;
            const real t17 = t14 - t15 - t16;
            const real rhoJ_y = p[10 * 8 + j];
            const real t18 = l0 * rhoJ_y;
            const real t19 = u_p_0 * t18;
            const real t20 = u_p_1 * t18;
            const real t21 = u_p_3 * t18;
            const real t22 = u_p_2 * t18;
            const real t23 = t17 * (tp_2 * t19 + tp_3 * t20 - tp_1 * t21 - tp_0 * t22);
            const real rhoJ_x = p[9 * 8 + j];
            const real t24 = l0 * rhoJ_x;
            const real t25 = u_p_0 * t24;
            const real t26 = u_p_3 * t24;
            const real t27 = u_p_1 * t24;
            const real t28 = u_p_2 * t24;
            const real t29 = 4.0 * tp_1 * u_p_0;
            const real t30 = 4.0 * tp_2 * u_p_3;
            const real t31 = 4.0 * tp_3 * u_p_2;
            const real t32 = 4.0 * tp_0 * u_p_1;
            const real t33 = t29 + t30 - t31 - t32;
            const real t34 = (tp_1 * t25 + tp_2 * t26 - tp_0 * t27 - tp_3 * t28) * t33;
            M[6 * 8 + j] = t23 + t34 + (tp_3 * t2 + tp_1 * t3 - tp_0 * t4 - tp_2 * t5) * t11; /* M(3,3) */
            const real t35 = tp_0 * t3 + tp_1 * t4 + tp_2 * t2 + tp_3 * t5;
            const real t36 = tp_1 * t22 + tp_2 * t20 - tp_0 * t21 - tp_3 * t19;
            const real t37 = tp_0 * t25 + tp_1 * t27 - tp_2 * t28 - tp_3 * t26;
            M[7 * 8 + j] = M[10 * 8 + j] = t17 * t36 + t37 * t33 + t35 * t11; /* M(3,4) M(4,3) */
            const real t38 = tp_3 * t3 + tp_2 * t4 - tp_1 * t2 - tp_0 * t5;
            const real t39 = tp_0 * t19 + tp_2 * t22 - tp_3 * t21 - tp_1 * t20;
            const real t40 = tp_3 * t25 + tp_2 * t27 + tp_1 * t28 + tp_0 * t26;
            M[8 * 8 + j] = M[14 * 8 + j] = t17 * t39 + t40 * t33 + t38 * t11; /* M(3,5) M(5,3) */
            const real t41 = tp_0 * t2 + tp_3 * t4 - tp_2 * t3 - tp_1 * t5;
            const real t42 = tp_2 * t21 + tp_3 * t22 + tp_0 * t20 + tp_1 * t19;
            const real t43 = tp_3 * t27 + tp_1 * t26 - tp_2 * t25 - tp_0 * t28;
            M[9 * 8 + j] = M[18 * 8 + j] = t17 * t42 + t43 * t33 + t41 * t11; /* M(3,6) M(6,3) */
            const real t44 = t14 + t15 + t16;
            const real t45 = t9 - t8 - t10;
            const real t46 = 4.0 * tp_0 * u_p_0;
            const real t47 = 4.0 * tp_1 * u_p_1;
            const real t48 = 4.0 * tp_2 * u_p_2;
            const real t49 = 4.0 * tp_3 * u_p_3;
            const real t50 = t46 + t47 - t48 - t49;
            M[11 * 8 + j] = t45 * t36 + t37 * t50 + t35 * t44; /* M(4,4) */
            M[12 * 8 + j] = M[15 * 8 + j] = t38 * t44 + t45 * t39 + t40 * t50; /* M(4,5) M(5,4) */
            M[13 * 8 + j] = M[19 * 8 + j] = t45 * t42 + t43 * t50 + t41 * t44; /* M(4,6) M(6,4) */
            const real t51 = t31 + t30;
            const real t52 = t29 + t32;
            const real t53 = t51 - t52;
            const real t54 = t46 - t47;
            const real t55 = t48 + t54 - t49;
            const real t56 = t6 + t7 + t9 + t10;
            M[16 * 8 + j] = t55 * t39 + t40 * t56 + t38 * t53; /* M(5,5) */
            M[17 * 8 + j] = M[20 * 8 + j] = t55 * t42 + t43 * t56 + t41 * t53; /* M(5,6) M(6,5) */
            M[21 * 8 + j] = (t52 + t51) * t42 + t43 * (t13 + t16 - t15 - t12) + t41 * (t49 + t54 - t48); /* M(6,6) */
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t57 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t58 = rp_vl0 * tp_2 + rp_vl3 * tp_1 + rp_vl2 * tp_0 - rp_vl1 * tp_3;
            const real t59 = t57 * t58;
            const real t60 = rp_vl0 * tp_1 + rp_vl2 * tp_3 + rp_vl1 * tp_0 - rp_vl3 * tp_2;
            const real t61 = rp_vl0 * tp_3 + rp_vl3 * tp_0 + rp_vl1 * tp_2 - rp_vl2 * tp_1;
            const real t62 = t60 * t61;
            const real t63 = t18 * (t59 + t62 - t59 - t62);
            const real t64 = t57 * t60;
            const real t65 = t61 * t58;
            const real t66 = t24 * (t64 + t65 - t64 - t65);
            const real t67 = t18 * (u_p_0 * t58 + u_p_1 * t61 - t57 * u_p_2 - u_p_3 * t60);
            const real t68 = t24 * (u_p_0 * t60 + u_p_3 * t58 - t57 * u_p_1 - u_p_2 * t61);
            const real t69 = t1 * (u_p_0 * t61 + u_p_2 * t60 - u_p_1 * t58 - t57 * u_p_3);
            const real t70 = u_p_3 * t66 + 2.0 * (t57 * t67 + t61 * t68 - t60 * t69) + u_p_0 * t63;
            const real t71 = t57 * t61;
            const real t72 = t60 * t58;
            const real t73 = t1 * (t71 + t72 - t72 - t71);
            const real t74 = t70 - u_p_1 * t73;
            const real t75 = u_p_0 * t66 + 2.0 * (t58 * t69 + t57 * t68 - t61 * t67) + u_p_2 * t73;
            const real t76 = t75 - u_p_3 * t63;
            const real t77 = u_p_1 * t63 + 2.0 * (t57 * t69 + t60 * t67 - t58 * t68) + u_p_0 * t73;
            const real t78 = t77 - u_p_2 * t66;
            const real t79 = u_p_3 * t73 + 2.0 * (t61 * t69 + t60 * t68 + t58 * t67) + u_p_2 * t63;
            const real t80 = u_p_1 * t66 + t79;
            h[0 * 8 + j] = 4.0 * (tp_1 * t76 + tp_3 * t78 + tp_2 * t74 - tp_0 * t80);
            h[1 * 8 + j] = 4.0 * (tp_0 * t76 + tp_1 * t80 + tp_2 * t78 - tp_3 * t74);
            h[2 * 8 + j] = 4.0 * (tp_3 * t76 + tp_2 * t80 + tp_0 * t74 - tp_1 * t78);
            h[3 * 8 + j] = 4.0 * (tp_3 * t80 + tp_0 * t78 + tp_1 * t74 - tp_2 * t76);
            const real gravity_x = p[12 * 8 + j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * gravity_x * t0;
            const real gravity_y = p[13 * 8 + j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * gravity_y * t0;
            const real gravity_z = p[14 * 8 + j];
            f[2 * 8 + j] = f[5 * 8 + j] = 0.5 * gravity_z * t0;
            const real p_y = x[1 * 8 + j];
            const real q_y = x[8 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real q_x = x[7 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real q_z = x[9 * 8 + j];
            const real t81 = gravity_x * (p_x + q_x) + gravity_z * (p_z + q_z) + gravity_y * (p_y + q_y);
            U[0 * 8 + j] = -(0.5 * t0 * t81);
        }
    }
}

/* tangent: 845 operations.
 * in:  x (10), v (10), a (10), p (15)
 * out: R_x (10,10), 16 of 100 entries, R_v (10,10), 16 of 100 entries */
FLEXEL_CLONES
static void beam3_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict v = in[1] + b * (10 * 8);
        const real *restrict a = in[2] + b * (10 * 8);
        const real *restrict p = in[3] + b * (15 * 8);
        real *restrict R_x = out[0] + b * (16 * 8);
        real *restrict R_v = out[1] + b * (16 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real tp_3 = p[3 * 8 + j];
            const real rp_al2 = a[5 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_al0 = a[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_al1 = a[4 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_al3 = a[6 * 8 + j];
            const real t0 = tp_1 * rp_al0 + tp_0 * rp_al1 + tp_3 * rp_al2 - tp_2 * rp_al3;
            const real l0 = p[7 * 8 + j];
            const real rhoJ_z = p[11 * 8 + j];
            const real t1 = l0 * rhoJ_z;
            const real rp_l0 = x[3 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real t2 = 4.0 * tp_3 * u_p_0;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t3 = 4.0 * tp_2 * u_p_1;
            const real t4 = t2 - t3;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t5 = 4.0 * tp_1 * u_p_2;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t6 = 4.0 * tp_0 * u_p_3;
            const real t7 = t1 * (t4 + t5 - t6);
            const real t8 = tp_3 * rp_al0 + tp_2 * rp_al1 + tp_0 * rp_al3 - tp_1 * rp_al2;
            const real t9 = tp_2 * rp_al0 + tp_0 * rp_al2 + tp_1 * rp_al3 - tp_3 * rp_al1;
            const real t10 = tp_0 * rp_al0 - tp_1 * rp_al1 - tp_2 * rp_al2 - tp_3 * rp_al3;
            const real t11 = t1 * (u_p_0 * t8 + u_p_2 * t0 - u_p_1 * t9 - u_p_3 * t10);
            const real rhoJ_x = p[9 * 8 + j];
            const real t12 = l0 * rhoJ_x;
            const real t13 = t12 * (u_p_0 * t0 + u_p_3 * t9 - u_p_1 * t10 - u_p_2 * t8);
            const real rhoJ_y = p[10 * 8 + j];
            const real t14 = l0 * rhoJ_y;
            const real t15 = t14 * (u_p_0 * t9 + u_p_1 * t8 - u_p_2 * t10 - u_p_3 * t0);
            const real t16 = 4.0 * (tp_1 * t11 - tp_3 * t13 - tp_0 * t15);
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t17 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t18 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t19 = 8.0 * tp_1 * t18;
            const real t20 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t21 = 8.0 * tp_0 * t20;
            const real t22 = t19 - t21;
            const real t23 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t24 = 8.0 * tp_3 * t23;
            const real t25 = 8.0 * tp_2 * t17;
            const real t26 = t1 * (t22 + t24 - t25);
            const real t27 = 4.0 * tp_1 * u_p_0;
            const real t28 = 4.0 * tp_2 * u_p_3;
            const real t29 = 4.0 * tp_0 * u_p_1;
            const real t30 = 4.0 * tp_3 * u_p_2;
            const real t31 = t12 * (t27 + t28 - t29 - t30);
            const real t32 = 4.0 * tp_2 * u_p_0;
            const real t33 = 4.0 * tp_3 * u_p_1;
            const real t34 = t32 + t33;
            const real t35 = 4.0 * tp_0 * u_p_2;
            const real t36 = 4.0 * tp_1 * u_p_3;
            const real t37 = t14 * (t34 - t35 - t36);
            const real t38 = 8.0 * tp_2 * t23;
            const real t39 = 8.0 * tp_3 * t17;
            const real t40 = t38 + t39;
            const real t41 = 8.0 * tp_0 * t18;
            const real t42 = 8.0 * tp_1 * t20;
            const real t43 = t41 + t42;
            const real t44 = t14 * (t40 - t43);
            const real t45 = t16 + t17 * t26 + t0 * t7 - t8 * t31 - t10 * t37 - t23 * t44;
            const real t46 = 8.0 * tp_1 * t23;
            const real t47 = 8.0 * tp_2 * t20;
            const real t48 = 8.0 * tp_0 * t17;
            const real t49 = 8.0 * tp_3 * t18;
            const real t50 = t12 * (t46 + t47 - t48 - t49);
            const real t51 = t45 - t20 * t50;
            const real t52 = 4.0 * (tp_2 * t13 - tp_1 * t15 - tp_0 * t11);
            const real t53 = t52 + t18 * t50 + t9 * t31 - t0 * t37 - t10 * t7 - t23 * t26;
            const real t54 = t53 - t17 * t44;
            const real t55 = 4.0 * (tp_3 * t11 + tp_1 * t13 + tp_2 * t15);
            const real t56 = t17 * t50 + t18 * t44 + t20 * t26 + t8 * t7 + t9 * t37 + t55;
            const real t57 = t0 * t31 + t56;
            const real t58 = 4.0 * (tp_3 * t15 - tp_0 * t13 - tp_2 * t11);
            const real t59 = t58 + t20 * t44 + t8 * t37 - t10 * t31 - t9 * t7 - t18 * t26;
            const real t60 = t59 - t23 * t50;
            R_x[0 * 8 + j] = tp_0 * t57 + tp_1 * t60 + tp_3 * t54 + tp_2 * t51; /* R_x(3,3) */
            R_x[1 * 8 + j] = tp_2 * t54 + tp_0 * t60 - tp_3 * t51 - tp_1 * t57; /* R_x(3,4) */
            R_x[2 * 8 + j] = tp_0 * t51 + tp_3 * t60 - tp_1 * t54 - tp_2 * t57; /* R_x(3,5) */
            R_x[3 * 8 + j] = tp_0 * t54 + tp_1 * t51 - tp_2 * t60 - tp_3 * t57; /* R_x(3,6) */
            const real t61 = t1 * (t34 + t35 + t36);
            const real t62 = t1 * (t43 + t40);
            const real t63 = 4.0 * tp_0 * u_p_0;
            const real t64 = 4.0 * tp_1 * u_p_1;
            const real t65 = 4.0 * tp_2 * u_p_2;
            const real t66 = 4.0 * tp_3 * u_p_3;
            const real t67 = t12 * (t63 + t64 - t65 - t66);
            const real t68 = t14 * (t5 - t4 - t6);
            const real t69 = t14 * (t22 + t25 - t24);
            const real t70 = t0 * t61 + t17 * t62 - t52 - t8 * t67 - t10 * t68 - t23 * t69;
            const real t71 = 8.0 * tp_1 * t17;
            const real t72 = 8.0 * tp_0 * t23;
            const real t73 = 8.0 * tp_3 * t20;
            const real t74 = 8.0 * tp_2 * t18;
            const real t75 = t12 * (t71 + t72 - t73 - t74);
            const real t76 = t70 - t20 * t75;
            const real t77 = t18 * t75 + t16 + t9 * t67 - t0 * t68 - t10 * t61 - t23 * t62;
            const real t78 = t77 - t17 * t69;
            const real t79 = t17 * t75 + t18 * t69 + t20 * t62 + t8 * t61 + t0 * t67 + t9 * t68;
            const real t80 = t79 - t58;
            const real t81 = t55 + t20 * t69 + t8 * t68 - t10 * t67 - t9 * t61 - t18 * t62;
            const real t82 = t81 - t23 * t75;
            R_x[4 * 8 + j] = tp_0 * t80 + tp_1 * t82 + tp_3 * t78 + tp_2 * t76; /* R_x(4,3) */
            R_x[5 * 8 + j] = tp_2 * t78 + tp_0 * t82 - tp_3 * t76 - tp_1 * t80; /* R_x(4,4) */
            R_x[6 * 8 + j] = tp_0 * t76 + tp_3 * t82 - tp_1 * t78 - tp_2 * t80; /* R_x(4,5) */
            R_x[7 * 8 + j] = tp_0 * t78 + tp_1 * t76 - tp_2 * t82 - tp_3 * t80; /* R_x(4,6) */
            const real t83 = t30 + t28;
            const real t84 = t27 + t29;
            const real t85 = t1 * (t83 - t84);
            const real t86 = t47 + t49;
            const real t87 = t1 * (t86 - t48 - t46);
            const real t88 = t12 * (t2 + t3 + t5 + t6);
            const real t89 = t63 - t64;
            const real t90 = t14 * (t65 + t89 - t66);
            const real t91 = t74 - t73;
            const real t92 = t14 * (t72 + t91 - t71);
            const real t93 = t17 * t87 + t55 + t0 * t85 - t8 * t88 - t10 * t90 - t23 * t92;
            const real t94 = t12 * (t25 + t24 + t21 + t19);
            const real t95 = t93 - t20 * t94;
            const real t96 = t9 * t88 + t18 * t94 - t58 - t0 * t90 - t10 * t85 - t23 * t87;
            const real t97 = t96 - t17 * t92;
            const real t98 = t18 * t92 + t17 * t94 + t20 * t87 + t8 * t85 + t0 * t88 + t9 * t90;
            const real t99 = t98 - t16;
            const real t100 = t20 * t92 + t52 + t8 * t90 - t10 * t88 - t9 * t85 - t18 * t87;
            const real t101 = t100 - t23 * t94;
            R_x[8 * 8 + j] = tp_0 * t99 + tp_1 * t101 + tp_3 * t97 + tp_2 * t95; /* R_x(5,3) */
            R_x[9 * 8 + j] = tp_2 * t97 + tp_0 * t101 - tp_3 * t95 - tp_1 * t99; /* R_x(5,4) */
            R_x[10 * 8 + j] = tp_0 * t95 + tp_3 * t101 - tp_1 * t97 - tp_2 * t99; /* R_x(5,5) */
            R_x[11 * 8 + j] = tp_0 * t97 + tp_1 * t95 - tp_2 * t101 - tp_3 * t99; /* R_x(5,6) */
            const real t102 = t1 * (t66 + t89 - t65);
            const real t103 = t1 * (t72 - t71 - t91);
            const real t104 = t12 * (t33 + t36 - t32 - t35);
            const real t105 = t14 * (t84 + t83);
            const real t106 = t14 * (t46 + t86 + t48);
            const real t107 = t58 + t17 * t103 + t0 * t102 - t8 * t104 - t10 * t105 - t23 * t106;
            const real t108 = t12 * (t42 + t39 - t38 - t41);
            const real t109 = t107 - t20 * t108;
            const real t110 = t55 + t18 * t108 + t9 * t104 - t0 * t105 - t10 * t102 - t23 * t103;
            const real t111 = t110 - t17 * t106;
            const real t112 = t18 * t106 + t17 * t108 + t20 * t103 + t8 * t102 + t0 * t104;
            const real t113 = t9 * t105 + t112 - t52;
            const real t114 = t20 * t106 + t8 * t105 - t16 - t10 * t104 - t9 * t102 - t18 * t103;
            const real t115 = t114 - t23 * t108;
            R_x[12 * 8 + j] = tp_0 * t113 + tp_1 * t115 + tp_3 * t111 + tp_2 * t109; /* R_x(6,3) */
            R_x[13 * 8 + j] = tp_2 * t111 + tp_0 * t115 - tp_3 * t109 - tp_1 * t113; /* R_x(6,4) */
            R_x[14 * 8 + j] = tp_0 * t109 + tp_3 * t115 - tp_1 * t111 - tp_2 * t113; /* R_x(6,5) */
            R_x[15 * 8 + j] = tp_0 * t111 + tp_1 * t109 - tp_2 * t115 - tp_3 * t113; /* R_x(6,6) */
            const real t116 = (u_p_0 * t17 + u_p_3 * t18 - u_p_1 * t23 - u_p_2 * t20) * t12;
            const real t117 = (u_p_0 * t18 + u_p_1 * t20 - u_p_2 * t23 - u_p_3 * t17) * t14;
            const real t118 = (u_p_0 * t20 + u_p_2 * t17 - u_p_1 * t18 - u_p_3 * t23) * t1;
            const real t119 = 8.0 * (tp_2 * t116 - tp_1 * t117 - tp_0 * t118);
            const real t120 = t119 + u_p_1 * t44 + u_p_0 * t26 - u_p_2 * t50;
            const real t121 = 8.0 * (tp_1 * t118 - tp_3 * t116 - tp_0 * t117);
            const real t122 = t121 + u_p_3 * t50 + u_p_0 * t44 - u_p_1 * t26;
            const real t123 = 8.0 * (tp_3 * t117 - tp_0 * t116 - tp_2 * t118);
            const real t124 = t123 + u_p_0 * t50 + u_p_2 * t26 - u_p_3 * t44;
            const real t125 = 8.0 * (tp_3 * t118 + tp_1 * t116 + tp_2 * t117);
            const real t126 = t125 - u_p_3 * t26 - u_p_2 * t44 - u_p_1 * t50;
            R_v[0 * 8 + j] = tp_1 * t124 + tp_0 * t126 + tp_2 * t122 + tp_3 * t120; /* R_v(3,3) */
            R_v[1 * 8 + j] = tp_2 * t120 + tp_0 * t124 - tp_3 * t122 - tp_1 * t126; /* R_v(3,4) */
            R_v[2 * 8 + j] = tp_0 * t122 + tp_3 * t124 - tp_1 * t120 - tp_2 * t126; /* R_v(3,5) */
            R_v[3 * 8 + j] = tp_1 * t122 + tp_0 * t120 - tp_3 * t126 - tp_2 * t124; /* R_v(3,6) */
            const real t127 = t121 + u_p_1 * t69 + u_p_0 * t62 - u_p_2 * t75;
            const real t128 = u_p_0 * t75 + t125 + u_p_2 * t62 - u_p_3 * t69;
            const real t129 = u_p_3 * t75 + u_p_0 * t69 - t119 - u_p_1 * t62;
            const real t130 = u_p_1 * t75 + u_p_2 * t69 + t123 + u_p_3 * t62;
            R_v[4 * 8 + j] = tp_1 * t128 + tp_2 * t129 + tp_3 * t127 - tp_0 * t130; /* R_v(4,3) */
            R_v[5 * 8 + j] = tp_0 * t128 + tp_2 * t127 + tp_1 * t130 - tp_3 * t129; /* R_v(4,4) */
            R_v[6 * 8 + j] = tp_3 * t128 + tp_0 * t129 + tp_2 * t130 - tp_1 * t127; /* R_v(4,5) */
            R_v[7 * 8 + j] = tp_3 * t130 + tp_1 * t129 + tp_0 * t127 - tp_2 * t128; /* R_v(4,6) */
            const real t131 = u_p_0 * t87 + u_p_1 * t92 - t123 - u_p_2 * t94;
            const real t132 = u_p_0 * t94 + t119 + u_p_2 * t87 - u_p_3 * t92;
            const real t133 = u_p_3 * t94 + t125 + u_p_0 * t92 - u_p_1 * t87;
            const real t134 = u_p_2 * t92 + u_p_1 * t94 + t121 + u_p_3 * t87;
            R_v[8 * 8 + j] = tp_1 * t132 + tp_2 * t133 + tp_3 * t131 - tp_0 * t134; /* R_v(5,3) */
            R_v[9 * 8 + j] = tp_0 * t132 + tp_2 * t131 + tp_1 * t134 - tp_3 * t133; /* R_v(5,4) */
            R_v[10 * 8 + j] = tp_3 * t132 + tp_0 * t133 + tp_2 * t134 - tp_1 * t131; /* R_v(5,5) */
            R_v[11 * 8 + j] = tp_3 * t134 + tp_1 * t133 + tp_0 * t131 - tp_2 * t132; /* R_v(5,6) */
            const real t135 = u_p_1 * t106 + t125 + u_p_0 * t103 - u_p_2 * t108;
            const real t136 = u_p_2 * t103 + u_p_0 * t108 - t121 - u_p_3 * t106;
            const real t137 = t123 + u_p_3 * t108 + u_p_0 * t106 - u_p_1 * t103;
            const real t138 = u_p_2 * t106 + u_p_1 * t108 + t119 + u_p_3 * t103;
            R_v[12 * 8 + j] = tp_1 * t136 + tp_2 * t137 + tp_3 * t135 - tp_0 * t138; /* R_v(6,3) */
            R_v[13 * 8 + j] = tp_0 * t136 + tp_2 * t135 + tp_1 * t138 - tp_3 * t137; /* R_v(6,4) */
            R_v[14 * 8 + j] = tp_3 * t136 + tp_0 * t137 + tp_2 * t138 - tp_1 * t135; /* R_v(6,5) */
            R_v[15 * 8 + j] = tp_3 * t138 + tp_1 * t137 + tp_0 * t135 - tp_2 * t136; /* R_v(6,6) */
        }
    }
}

/* outputs: 83 operations.
 * in:  x (10), sigma (3), tau (0), p (15)
 * out: axes (3,3), displacement (3) */
FLEXEL_CLONES
static void beam3_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict p = in[3] + b * (15 * 8);
        real *restrict axes = out[0] + b * (9 * 8);
        real *restrict displacement = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real t0 = u_p_0 * u_p_0;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t1 = u_p_1 * u_p_1;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t2 = u_p_2 * u_p_2;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t3 = u_p_3 * u_p_3;
            const real ex_p_x = t0 + t1 - t2 - t3;
            axes[0 * 8 + j] = ex_p_x; /* axes(0,0) */
            const real t4 = u_p_0 * u_p_3;
            const real t5 = u_p_1 * u_p_2;
            const real t6 = t4 + t5;
            const real ex_p_y = 2.0 * t6;
            axes[1 * 8 + j] = ex_p_y; /* axes(0,1) */
            const real t7 = u_p_1 * u_p_3;
            const real t8 = u_p_0 * u_p_2;
            const real t9 = t7 - t8;
            const real ex_p_z = 2.0 * t9;
            axes[2 * 8 + j] = ex_p_z; /* axes(0,2) */
            const real t10 = t5 - t4;
            const real ey_p_x = 2.0 * t10;
            axes[3 * 8 + j] = ey_p_x; /* axes(1,0) */
            const real ey_p_y = t0 + t2 - t1 - t3;
            axes[4 * 8 + j] = ey_p_y; /* axes(1,1) */
            const real t11 = u_p_0 * u_p_1;
            const real t12 = u_p_2 * u_p_3;
            const real t13 = t11 + t12;
            const real ey_p_z = 2.0 * t13;
            axes[5 * 8 + j] = ey_p_z; /* axes(1,2) */
            const real t14 = t8 + t7;
            const real ez_p_x = 2.0 * t14;
            axes[6 * 8 + j] = ez_p_x; /* axes(2,0) */
            const real t15 = t12 - t11;
            const real ez_p_y = 2.0 * t15;
            axes[7 * 8 + j] = ez_p_y; /* axes(2,1) */
            const real ez_p_z = t0 + t3 - t1 - t2;
            axes[8 * 8 + j] = ez_p_z; /* axes(2,2) */
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real d0_x = p[4 * 8 + j];
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            displacement[0 * 8 + j] = d_x * ex_p_x - d0_x + 2.0 * (d_y * t6 + d_z * t9);
            const real d0_y = p[5 * 8 + j];
            displacement[1 * 8 + j] = d_y * ey_p_y - d0_y + 2.0 * (d_x * t10 + d_z * t13);
            const real d0_z = p[6 * 8 + j];
            displacement[2 * 8 + j] = d_z * ez_p_z - d0_z + 2.0 * (d_x * t14 + d_y * t15);
        }
    }
}

const flexel_element flexel_beam3 = {
    .name = "beam3",
    .digest = "3f244ff3836b191b",
    .n = 10,
    .m = 3,
    .k = 0,
    .np = 15,
    .position = beam3_position,
    .acceleration = beam3_acceleration,
    .rates = beam3_rates,
    .kinematics = beam3_kinematics,
    .stiffness = beam3_stiffness,
    .inertia = beam3_inertia,
    .tangent = beam3_tangent,
    .outputs = beam3_outputs,
};
