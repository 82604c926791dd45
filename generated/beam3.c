/* beam3: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * triad ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp; d = xq - xp
 * (along, across1, across2) = R(u_p)' d - d0
 * w_p = angular velocity of the triad, in its own axes
 * T = rhoA l0/6 (vp.vp + vp.vq + vq.vq) + l0/2 sum rhoJ_i w_i^2, uniform bar
 * U = -rhoA l0 gravity.(xp + xq)/2
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
            De[7 * 8 + j] = ex_p_x;
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
            De[18 * 8 + j] = ey_p_y;
            const real d0_y = p[5 * 8 + j];
            const real t10 = t5 - t4;
            const real t11 = u_p_0 * u_p_1;
            const real t12 = u_p_2 * u_p_3;
            const real t13 = t11 + t12;
            e[1 * 8 + j] = d_y * ey_p_y - d0_y + 2.0 * (d_x * t10 + d_z * t13);
            const real ez_p_z = t0 + t3 - t1 - t2;
            De[29 * 8 + j] = ez_p_z;
            const real d0_z = p[6 * 8 + j];
            const real t14 = t8 + t7;
            const real t15 = t12 - t11;
            e[2 * 8 + j] = d_z * ez_p_z - d0_z + 2.0 * (d_x * t14 + d_y * t15);
            De[0 * 8 + j] = -ex_p_x;
            const real ex_p_y = 2.0 * t6;
            De[8 * 8 + j] = ex_p_y;
            De[1 * 8 + j] = -ex_p_y;
            const real ex_p_z = 2.0 * t9;
            De[9 * 8 + j] = ex_p_z;
            De[2 * 8 + j] = -ex_p_z;
            const real t16 = 2.0 * u_p_1 * d_z - (2.0 * u_p_3 * d_x - 2.0 * u_p_0 * d_y);
            const real t17 = tp_3 * t16;
            const real t18 = 2.0 * u_p_3 * d_y + 2.0 * u_p_0 * d_x - 2.0 * u_p_2 * d_z;
            const real t19 = tp_0 * t18;
            const real t20 = 2.0 * u_p_2 * d_y + 2.0 * u_p_1 * d_x + 2.0 * u_p_3 * d_z;
            const real t21 = tp_1 * t20;
            const real t22 = 2.0 * u_p_2 * d_x - 2.0 * u_p_1 * d_y + 2.0 * u_p_0 * d_z;
            const real t23 = tp_2 * t22;
            De[3 * 8 + j] = t19 + t21 - t23 + t17;
            const real t24 = tp_2 * t16;
            const real t25 = tp_3 * t22;
            const real t26 = tp_0 * t20;
            const real t27 = tp_1 * t18;
            De[4 * 8 + j] = t26 - t27 + t25 + t24;
            const real t28 = tp_3 * t20;
            const real t29 = tp_2 * t18;
            const real t30 = tp_0 * t22;
            const real t31 = tp_1 * t16;
            De[5 * 8 + j] = t28 - t29 - t30 - t31;
            const real t32 = tp_0 * t16;
            const real t33 = tp_1 * t22;
            const real t34 = tp_3 * t18;
            const real t35 = tp_2 * t20;
            De[6 * 8 + j] = t32 - (t34 + t35 + t33);
            const real ey_p_x = 2.0 * t10;
            De[17 * 8 + j] = ey_p_x;
            De[10 * 8 + j] = -ey_p_x;
            De[11 * 8 + j] = -ey_p_y;
            const real ey_p_z = 2.0 * t13;
            De[19 * 8 + j] = ey_p_z;
            De[12 * 8 + j] = -ey_p_z;
            const real t36 = t33 + t32;
            De[13 * 8 + j] = t36 + t35 - t34;
            const real t37 = t30 - t31;
            De[14 * 8 + j] = t37 - t28 - t29;
            const real t38 = t24 - t25;
            De[15 * 8 + j] = t26 - t38 + t27;
            const real t39 = t23 + t17;
            De[16 * 8 + j] = t21 - t39 - t19;
            const real ez_p_x = 2.0 * t14;
            De[27 * 8 + j] = ez_p_x;
            De[20 * 8 + j] = -ez_p_x;
            const real ez_p_y = 2.0 * t15;
            De[28 * 8 + j] = ez_p_y;
            De[21 * 8 + j] = -ez_p_y;
            De[22 * 8 + j] = -ez_p_z;
            De[23 * 8 + j] = t29 + t37 + t28;
            De[24 * 8 + j] = t35 - (t34 + t36);
            De[25 * 8 + j] = t19 - t39 - t21;
            De[26 * 8 + j] = t27 + t38 + t26;
        }
    }
}

/* velocity: 164 operations.
 * in:  x (10), v (10), p (15)
 * out: ed (3), s (0) */
FLEXEL_CLONES
static void beam3_velocity(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict v = in[1] + b * (10 * 8);
        const real *restrict p = in[2] + b * (15 * 8);
        real *restrict ed = out[0] + b * (3 * 8);
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
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t4 = q_vx - p_vx;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t5 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t6 = 2.0 * u_p_0 * t5;
            const real t7 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t8 = 2.0 * u_p_1 * t7;
            const real t9 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t10 = 2.0 * u_p_2 * t9;
            const real t11 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t12 = 2.0 * u_p_3 * t11;
            const real t13 = u_p_0 * u_p_3;
            const real t14 = u_p_1 * u_p_2;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t15 = q_vy - p_vy;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t16 = u_p_0 * t11 + u_p_3 * t5;
            const real t17 = u_p_1 * t9 + u_p_2 * t7;
            const real t18 = u_p_1 * u_p_3;
            const real t19 = u_p_0 * u_p_2;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t20 = q_vz - p_vz;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real t21 = u_p_1 * t11 + u_p_3 * t7;
            const real t22 = u_p_0 * t9 + u_p_2 * t5;
            const real t23 = (t13 + t14) * t15 + d_y * (t16 + t17) + ((t18 - t19) * t20 + d_z * (t21 - t22));
            ed[0 * 8 + j] = ex_p_x * t4 + d_x * (t6 + t8 - t10 - t12) + 2.0 * t23;
            const real ey_p_y = t0 + t2 - t1 - t3;
            const real t24 = u_p_0 * u_p_1;
            const real t25 = u_p_2 * u_p_3;
            const real t26 = u_p_0 * t7 + u_p_1 * t5;
            const real t27 = u_p_2 * t11 + u_p_3 * t9;
            const real t28 = (t14 - t13) * t4 + d_x * (t17 - t16) + ((t24 + t25) * t20 + d_z * (t26 + t27));
            ed[1 * 8 + j] = ey_p_y * t15 + d_y * (t6 + t10 - t8 - t12) + 2.0 * t28;
            const real ez_p_z = t0 + t3 - t1 - t2;
            const real t29 = (t19 + t18) * t4 + d_x * (t22 + t21) + ((t25 - t24) * t15 + d_y * (t27 - t26));
            ed[2 * 8 + j] = ez_p_z * t20 + d_z * (t6 + t12 - t8 - t10) + 2.0 * t29;
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

/* kinematics: 556 operations.
 * in:  x (10), v (10), a (10), p (15)
 * out: Phi_x (3,10), Psi_x (3,10), Psi_v (3,10) */
FLEXEL_CLONES
static void beam3_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (10 * 8);
        const real *restrict v = in[1] + b * (10 * 8);
        const real *restrict a = in[2] + b * (10 * 8);
        const real *restrict p = in[3] + b * (15 * 8);
        real *restrict Phi_x = out[0] + b * (30 * 8);
        real *restrict Psi_x = out[1] + b * (30 * 8);
        real *restrict Psi_v = out[2] + b * (30 * 8);
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
            Phi_x[7 * 8 + j] = t8;
            Phi_x[0 * 8 + j] = -t8;
            const real t9 = u_p_0 * t6 + u_p_3 * t0;
            const real t10 = u_p_1 * t4 + u_p_2 * t2;
            const real t11 = t9 + t10;
            const real t12 = 2.0 * t11;
            Phi_x[8 * 8 + j] = t12;
            Phi_x[1 * 8 + j] = -t12;
            const real t13 = u_p_1 * t6 + u_p_3 * t2;
            const real t14 = u_p_0 * t4 + u_p_2 * t0;
            const real t15 = t13 - t14;
            const real t16 = 2.0 * t15;
            Phi_x[9 * 8 + j] = t16;
            Phi_x[2 * 8 + j] = -t16;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t17 = q_vz - p_vz;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t18 = q_vy - p_vy;
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t19 = q_vx - p_vx;
            const real t20 = 2.0 * u_p_0 * t18 - 2.0 * u_p_3 * t19 + 2.0 * u_p_1 * t17;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t21 = t20 - 2.0 * d_x * t6 + 2.0 * d_y * t0 + 2.0 * d_z * t2;
            const real t22 = tp_3 * t21;
            const real t23 = 2.0 * u_p_1 * t18 - 2.0 * u_p_2 * t19 - 2.0 * u_p_0 * t17;
            const real t24 = t23 - 2.0 * d_x * t4 + 2.0 * d_y * t2 - 2.0 * d_z * t0;
            const real t25 = tp_2 * t24;
            const real t26 = 2.0 * u_p_3 * t18 + 2.0 * u_p_0 * t19 - 2.0 * u_p_2 * t17;
            const real t27 = 2.0 * d_x * t0 + t26 + 2.0 * d_y * t6 - 2.0 * d_z * t4;
            const real t28 = tp_0 * t27;
            const real t29 = 2.0 * u_p_2 * t18 + 2.0 * u_p_1 * t19 + 2.0 * u_p_3 * t17;
            const real t30 = 2.0 * d_x * t2 + t29 + 2.0 * d_y * t4 + 2.0 * d_z * t6;
            const real t31 = tp_1 * t30;
            const real t32 = t28 + t31 + t25 + t22;
            Phi_x[3 * 8 + j] = t32;
            const real t33 = tp_2 * t21;
            const real t34 = tp_0 * t30;
            const real t35 = tp_1 * t27;
            const real t36 = tp_3 * t24;
            const real t37 = t34 - t35 - t36 + t33;
            Phi_x[4 * 8 + j] = t37;
            const real t38 = tp_0 * t24;
            const real t39 = tp_3 * t30;
            const real t40 = tp_2 * t27;
            const real t41 = tp_1 * t21;
            const real t42 = t39 - t40 + t38 - t41;
            Phi_x[5 * 8 + j] = t42;
            const real t43 = tp_0 * t21;
            const real t44 = tp_1 * t24;
            const real t45 = tp_3 * t27;
            const real t46 = tp_2 * t30;
            const real t47 = t44 - (t45 + t46) + t43;
            Phi_x[6 * 8 + j] = t47;
            const real t48 = t10 - t9;
            const real t49 = 2.0 * t48;
            Phi_x[17 * 8 + j] = t49;
            Phi_x[10 * 8 + j] = -t49;
            const real t50 = t1 + t5 - t3 - t7;
            Phi_x[18 * 8 + j] = t50;
            Phi_x[11 * 8 + j] = -t50;
            const real t51 = u_p_0 * t2 + u_p_1 * t0;
            const real t52 = u_p_2 * t6 + u_p_3 * t4;
            const real t53 = t51 + t52;
            const real t54 = 2.0 * t53;
            Phi_x[19 * 8 + j] = t54;
            Phi_x[12 * 8 + j] = -t54;
            const real t55 = t44 - t43;
            const real t56 = t46 - t55 - t45;
            Phi_x[13 * 8 + j] = t56;
            const real t57 = t38 + t41;
            const real t58 = t57 + t39 + t40;
            Phi_x[14 * 8 + j] = -t58;
            const real t59 = t36 + t33;
            const real t60 = t34 - t59 + t35;
            Phi_x[15 * 8 + j] = t60;
            const real t61 = t25 - t22;
            const real t62 = t61 + t31 - t28;
            Phi_x[16 * 8 + j] = t62;
            const real t63 = t14 + t13;
            const real t64 = 2.0 * t63;
            Phi_x[27 * 8 + j] = t64;
            Phi_x[20 * 8 + j] = -t64;
            const real t65 = t52 - t51;
            const real t66 = 2.0 * t65;
            Phi_x[28 * 8 + j] = t66;
            Phi_x[21 * 8 + j] = -t66;
            const real t67 = t1 + t7 - t3 - t5;
            Phi_x[29 * 8 + j] = t67;
            Phi_x[22 * 8 + j] = -t67;
            const real t68 = t40 - t57 + t39;
            Phi_x[23 * 8 + j] = t68;
            const real t69 = t55 - t45 + t46;
            Phi_x[24 * 8 + j] = t69;
            const real t70 = t28 + t61 - t31;
            Phi_x[25 * 8 + j] = t70;
            const real t71 = t35 + t59 + t34;
            Phi_x[26 * 8 + j] = t71;
            const real t72 = 2.0 * t0 * t0;
            const real t73 = 2.0 * t2 * t2;
            const real t74 = 2.0 * t4 * t4;
            const real t75 = 2.0 * t6 * t6;
            const real rp_al0 = a[3 * 8 + j];
            const real rp_al1 = a[4 * 8 + j];
            const real rp_al2 = a[5 * 8 + j];
            const real rp_al3 = a[6 * 8 + j];
            const real t76 = tp_0 * rp_al0 - tp_1 * rp_al1 - tp_2 * rp_al2 - tp_3 * rp_al3;
            const real t77 = 2.0 * u_p_0 * t76;
            const real t78 = tp_1 * rp_al0 + tp_0 * rp_al1 + tp_3 * rp_al2 - tp_2 * rp_al3;
            const real t79 = 2.0 * u_p_1 * t78;
            const real t80 = tp_2 * rp_al0 + tp_0 * rp_al2 + tp_1 * rp_al3 - tp_3 * rp_al1;
            const real t81 = 2.0 * u_p_2 * t80;
            const real t82 = tp_3 * rp_al0 + tp_2 * rp_al1 + tp_0 * rp_al3 - tp_1 * rp_al2;
            const real t83 = 2.0 * u_p_3 * t82;
            const real t84 = t72 + t73 - t74 - t75 + (t77 + t79 - t81 - t83);
            Psi_x[7 * 8 + j] = t84;
            Psi_x[0 * 8 + j] = -t84;
            const real t85 = 2.0 * t0 * t6;
            const real t86 = 2.0 * t2 * t4;
            const real t87 = u_p_3 * t76 + u_p_0 * t82;
            const real t88 = u_p_2 * t78 + u_p_1 * t80;
            const real t89 = 2.0 * (t85 + t86) + 2.0 * (t87 + t88);
            Psi_x[8 * 8 + j] = t89;
            Psi_x[1 * 8 + j] = -t89;
            const real t90 = 2.0 * t2 * t6;
            const real t91 = 2.0 * t0 * t4;
            const real t92 = u_p_3 * t78 + u_p_1 * t82;
            const real t93 = u_p_2 * t76 + u_p_0 * t80;
            const real t94 = 2.0 * (t90 - t91) + 2.0 * (t92 - t93);
            Psi_x[9 * 8 + j] = t94;
            Psi_x[2 * 8 + j] = -t94;
            const real q_az = a[9 * 8 + j];
            const real p_az = a[2 * 8 + j];
            const real t95 = q_az - p_az;
            const real q_ay = a[8 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t96 = q_ay - p_ay;
            const real q_ax = a[7 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t97 = q_ax - p_ax;
            const real t98 = 2.0 * u_p_0 * t96 - 2.0 * u_p_3 * t97 + 2.0 * u_p_1 * t95;
            const real t99 = t98 - 4.0 * t6 * t19 + 4.0 * t0 * t18 + 4.0 * t2 * t17 - 2.0 * d_x * t82;
            const real t100 = 2.0 * d_y * t76 + t99 + 2.0 * d_z * t78;
            const real t101 = tp_3 * t100;
            const real t102 = 2.0 * u_p_1 * t96 - 2.0 * u_p_2 * t97 - 2.0 * u_p_0 * t95;
            const real t103 = t102 - 4.0 * t4 * t19 + 4.0 * t2 * t18 - 4.0 * t0 * t17 - 2.0 * d_x * t80;
            const real t104 = 2.0 * d_y * t78 + t103 - 2.0 * d_z * t76;
            const real t105 = tp_2 * t104;
            const real t106 = 2.0 * u_p_3 * t96 + 2.0 * u_p_0 * t97 - 2.0 * u_p_2 * t95;
            const real t107 = 4.0 * t0 * t19 + t106 + 4.0 * t6 * t18 - 4.0 * t4 * t17 + 2.0 * d_x * t76;
            const real t108 = 2.0 * d_y * t82 + t107 - 2.0 * d_z * t80;
            const real t109 = tp_0 * t108;
            const real t110 = 2.0 * u_p_2 * t96 + 2.0 * u_p_1 * t97 + 2.0 * u_p_3 * t95;
            const real t111 = 4.0 * t2 * t19 + t110 + 4.0 * t4 * t18 + 4.0 * t6 * t17 + 2.0 * d_x * t78;
            const real t112 = 2.0 * d_y * t80 + t111 + 2.0 * d_z * t82;
            const real t113 = tp_1 * t112;
            Psi_x[3 * 8 + j] = t109 + t113 + t105 + t101;
            const real t114 = tp_2 * t100;
            const real t115 = tp_0 * t112;
            const real t116 = tp_1 * t108;
            const real t117 = tp_3 * t104;
            Psi_x[4 * 8 + j] = t115 - t116 - t117 + t114;
            const real t118 = tp_0 * t104;
            const real t119 = tp_3 * t112;
            const real t120 = tp_2 * t108;
            const real t121 = tp_1 * t100;
            Psi_x[5 * 8 + j] = t119 - t120 + t118 - t121;
            const real t122 = tp_0 * t100;
            const real t123 = tp_1 * t104;
            const real t124 = tp_3 * t108;
            const real t125 = tp_2 * t112;
            Psi_x[6 * 8 + j] = t123 - (t124 + t125) + t122;
            const real t126 = 2.0 * (t86 - t85) + 2.0 * (t88 - t87);
            Psi_x[17 * 8 + j] = t126;
            Psi_x[10 * 8 + j] = -t126;
            const real t127 = t72 + t74 - t73 - t75 + (t77 + t81 - t79 - t83);
            Psi_x[18 * 8 + j] = t127;
            Psi_x[11 * 8 + j] = -t127;
            const real t128 = 2.0 * t2 * t0;
            const real t129 = 2.0 * t6 * t4;
            const real t130 = u_p_1 * t76 + u_p_0 * t78;
            const real t131 = u_p_3 * t80 + u_p_2 * t82;
            const real t132 = 2.0 * (t128 + t129) + 2.0 * (t130 + t131);
            Psi_x[19 * 8 + j] = t132;
            Psi_x[12 * 8 + j] = -t132;
            const real t133 = t123 - t122;
            Psi_x[13 * 8 + j] = t125 - t133 - t124;
            const real t134 = t118 + t121;
            Psi_x[14 * 8 + j] = -(t134 + t119 + t120);
            const real t135 = t117 + t114;
            Psi_x[15 * 8 + j] = t115 - t135 + t116;
            const real t136 = t105 - t101;
            Psi_x[16 * 8 + j] = t136 + t113 - t109;
            const real t137 = 2.0 * (t91 + t90) + 2.0 * (t93 + t92);
            Psi_x[27 * 8 + j] = t137;
            Psi_x[20 * 8 + j] = -t137;
            const real t138 = 2.0 * (t129 - t128) + 2.0 * (t131 - t130);
            Psi_x[28 * 8 + j] = t138;
            Psi_x[21 * 8 + j] = -t138;
            const real t139 = t72 + t75 - t73 - t74 + (t77 + t83 - t79 - t81);
            Psi_x[29 * 8 + j] = t139;
            Psi_x[22 * 8 + j] = -t139;
            Psi_x[23 * 8 + j] = t120 - t134 + t119;
            Psi_x[24 * 8 + j] = t133 - t124 + t125;
            Psi_x[25 * 8 + j] = t109 + t136 - t113;
            Psi_x[26 * 8 + j] = t116 + t135 + t115;
            const real t140 = 2.0 * t8;
            Psi_v[7 * 8 + j] = t140;
            Psi_v[0 * 8 + j] = -t140;
            const real t141 = 4.0 * t11;
            Psi_v[8 * 8 + j] = t141;
            Psi_v[1 * 8 + j] = -t141;
            const real t142 = 4.0 * t15;
            Psi_v[9 * 8 + j] = t142;
            Psi_v[2 * 8 + j] = -t142;
            Psi_v[3 * 8 + j] = 2.0 * t32;
            Psi_v[4 * 8 + j] = 2.0 * t37;
            Psi_v[5 * 8 + j] = 2.0 * t42;
            Psi_v[6 * 8 + j] = 2.0 * t47;
            const real t143 = 4.0 * t48;
            Psi_v[17 * 8 + j] = t143;
            Psi_v[10 * 8 + j] = -t143;
            const real t144 = 2.0 * t50;
            Psi_v[18 * 8 + j] = t144;
            Psi_v[11 * 8 + j] = -t144;
            const real t145 = 4.0 * t53;
            Psi_v[19 * 8 + j] = t145;
            Psi_v[12 * 8 + j] = -t145;
            Psi_v[13 * 8 + j] = 2.0 * t56;
            Psi_v[14 * 8 + j] = -(2.0 * t58);
            Psi_v[15 * 8 + j] = 2.0 * t60;
            Psi_v[16 * 8 + j] = 2.0 * t62;
            const real t146 = 4.0 * t63;
            Psi_v[27 * 8 + j] = t146;
            Psi_v[20 * 8 + j] = -t146;
            const real t147 = 4.0 * t65;
            Psi_v[28 * 8 + j] = t147;
            Psi_v[21 * 8 + j] = -t147;
            const real t148 = 2.0 * t67;
            Psi_v[29 * 8 + j] = t148;
            Psi_v[22 * 8 + j] = -t148;
            Psi_v[23 * 8 + j] = 2.0 * t68;
            Psi_v[24 * 8 + j] = 2.0 * t69;
            Psi_v[25 * 8 + j] = 2.0 * t70;
            Psi_v[26 * 8 + j] = 2.0 * t71;
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
            K[19 * 8 + j] = K[52 * 8 + j] = t8;
            K[0 * 8 + j] = K[12 * 8 + j] = -t8;
            const real t9 = tp_0 * t4;
            const real t10 = tp_1 * t2;
            const real t11 = tp_3 * t0;
            const real t12 = tp_2 * t6;
            const real t13 = t9 - t10 - t11 - t12;
            K[29 * 8 + j] = K[53 * 8 + j] = t13;
            K[1 * 8 + j] = K[22 * 8 + j] = -t13;
            const real t14 = tp_1 * t6;
            const real t15 = tp_3 * t4;
            const real t16 = tp_0 * t0;
            const real t17 = tp_2 * t2;
            const real t18 = t15 + t16 + t14 - t17;
            K[39 * 8 + j] = K[54 * 8 + j] = t18;
            K[2 * 8 + j] = K[32 * 8 + j] = -t18;
            const real t19 = tp_1 * t0;
            const real t20 = tp_3 * t2;
            const real t21 = tp_2 * t4;
            const real t22 = tp_0 * t6;
            const real t23 = t19 - t20 - t21 - t22;
            K[49 * 8 + j] = K[55 * 8 + j] = t23;
            K[3 * 8 + j] = K[42 * 8 + j] = -t23;
            const real t24 = t21 + t22 + t20 - t19;
            K[20 * 8 + j] = K[56 * 8 + j] = t24;
            K[4 * 8 + j] = K[13 * 8 + j] = -t24;
            const real t25 = t17 - t14 - t16 - t15;
            K[30 * 8 + j] = K[57 * 8 + j] = t25;
            K[5 * 8 + j] = K[23 * 8 + j] = -t25;
            const real t26 = t9 - t12 - t11 - t10;
            K[40 * 8 + j] = K[58 * 8 + j] = t26;
            K[6 * 8 + j] = K[33 * 8 + j] = -t26;
            const real t27 = t5 + t1 + t3 - t7;
            K[50 * 8 + j] = K[59 * 8 + j] = t27;
            K[7 * 8 + j] = K[43 * 8 + j] = -t27;
            const real t28 = t16 + t14 + t15 - t17;
            K[21 * 8 + j] = K[60 * 8 + j] = t28;
            K[8 * 8 + j] = K[14 * 8 + j] = -t28;
            const real t29 = t20 + t22 + t21 - t19;
            K[31 * 8 + j] = K[61 * 8 + j] = t29;
            K[9 * 8 + j] = K[24 * 8 + j] = -t29;
            const real t30 = t7 - t1 - t3 - t5;
            K[41 * 8 + j] = K[62 * 8 + j] = t30;
            K[10 * 8 + j] = K[34 * 8 + j] = -t30;
            const real t31 = t9 - t11 - t12 - t10;
            K[51 * 8 + j] = K[63 * 8 + j] = t31;
            K[11 * 8 + j] = K[44 * 8 + j] = -t31;
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
            const real t65 = tp_0 * (2.0 * tp_0 * t58 + t60 + t56 + t55) + tp_1 * (t63 + 2.0 * tp_1 * t64 + t62 + t61);
            K[15 * 8 + j] = tp_2 * (t51 + t53 + t49 - 2.0 * tp_2 * t54) + t65 + tp_3 * (t44 + t48 + t40 + 2.0 * tp_3 * t36);
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
            K[16 * 8 + j] = K[25 * 8 + j] = tp_0 * t74 + tp_1 * t77 + tp_2 * t71 + tp_3 * t68;
            const real t78 = tp_0 * t39;
            const real t79 = t61 + t78 - t72 - 2.0 * tp_1 * t36;
            const real t80 = tp_1 * t39;
            const real t81 = t76 - t56 - 2.0 * tp_0 * t54 - t80;
            const real t82 = tp_3 * t59;
            const real t83 = t82 + t51 - 2.0 * tp_2 * t58 - t67;
            const real t84 = tp_2 * t59;
            const real t85 = 2.0 * tp_3 * t64 + t69 - t84 - t48;
            K[17 * 8 + j] = K[35 * 8 + j] = tp_0 * t83 + tp_1 * t85 + tp_2 * t81 + tp_3 * t79;
            const real t86 = t80 + 2.0 * tp_0 * t36 - t55 - t75;
            const real t87 = t78 - t73 - t62 - 2.0 * tp_1 * t54;
            const real t88 = t70 + t44 - 2.0 * tp_3 * t58 - t84;
            const real t89 = t53 + t66 - t82 - 2.0 * tp_2 * t64;
            K[18 * 8 + j] = K[45 * 8 + j] = tp_0 * t88 + tp_1 * t89 + tp_2 * t87 + tp_3 * t86;
            K[26 * 8 + j] = tp_0 * t77 + tp_2 * t68 - tp_1 * t74 - tp_3 * t71;
            K[27 * 8 + j] = K[36 * 8 + j] = tp_0 * t85 + tp_2 * t79 - tp_1 * t83 - tp_3 * t81;
            K[28 * 8 + j] = K[46 * 8 + j] = tp_0 * t89 + tp_2 * t86 - tp_1 * t88 - tp_3 * t87;
            K[37 * 8 + j] = tp_3 * t85 + tp_0 * t81 - tp_2 * t83 - tp_1 * t79;
            K[38 * 8 + j] = K[47 * 8 + j] = tp_3 * t89 + tp_0 * t87 - tp_2 * t88 - tp_1 * t86;
            K[48 * 8 + j] = tp_1 * t87 + tp_0 * t86 - tp_3 * t88 - tp_2 * t89;
        }
    }
}

/* inertia: 439 operations.
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
            M[0 * 8 + j] = M[2 * 8 + j] = M[4 * 8 + j] = M[23 * 8 + j] = M[25 * 8 + j] = M[27 * 8 + j] = 0.3333333333333333 * t0;
            M[1 * 8 + j] = M[3 * 8 + j] = M[5 * 8 + j] = M[22 * 8 + j] = M[24 * 8 + j] = M[26 * 8 + j] = 0.16666666666666666 * t0;
            const real rp_l3 = x[6 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l0 = x[3 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real rhoJ_z = p[11 * 8 + j];
            const real t1 = l0 * rhoJ_z;
            const real t2 = u_p_2 * t1;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t3 = u_p_3 * t1;
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real t4 = u_p_0 * t1;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t5 = u_p_1 * t1;
            const real t6 = 4.0 * tp_1 * u_p_2;
            const real t7 = 4.0 * tp_3 * u_p_0;
            const real t8 = 4.0 * tp_2 * u_p_1;
            const real t9 = t7 - t8;
            const real t10 = 4.0 * tp_0 * u_p_3;
            const real t11 = t9 - t10 + t6;
            const real t12 = 4.0 * tp_2 * u_p_0;
            const real t13 = 4.0 * tp_3 * u_p_1;
            const real t14 = t12 + t13;
            const real t15 = 4.0 * tp_0 * u_p_2;
            const real t16 = 4.0 * tp_1 * u_p_3;
            const real t17 = t14 - t15 - t16;
            const real rhoJ_y = p[10 * 8 + j];
            const real t18 = l0 * rhoJ_y;
            const real t19 = u_p_1 * t18;
            const real t20 = u_p_3 * t18;
            const real t21 = u_p_2 * t18;
            const real t22 = u_p_0 * t18;
            const real t23 = t17 * (tp_3 * t19 - (tp_1 * t20 + tp_0 * t21) + tp_2 * t22);
            const real t24 = (tp_1 * t2 - tp_0 * t3 + tp_3 * t4 - tp_2 * t5) * t11 + t23;
            const real rhoJ_x = p[9 * 8 + j];
            const real t25 = l0 * rhoJ_x;
            const real t26 = u_p_0 * t25;
            const real t27 = u_p_1 * t25;
            const real t28 = u_p_2 * t25;
            const real t29 = u_p_3 * t25;
            const real t30 = 4.0 * tp_1 * u_p_0;
            const real t31 = 4.0 * tp_2 * u_p_3;
            const real t32 = 4.0 * tp_3 * u_p_2;
            const real t33 = 4.0 * tp_0 * u_p_1;
            const real t34 = t31 - t32 - t33 + t30;
            const real t35 = (tp_1 * t26 - tp_0 * t27 - tp_3 * t28 + tp_2 * t29) * t34;
            M[6 * 8 + j] = t24 + t35;
            const real t36 = tp_0 * t2 + tp_1 * t3 + tp_2 * t4 + tp_3 * t5;
            const real t37 = tp_1 * t21 - tp_0 * t20 + tp_2 * t19 - tp_3 * t22;
            const real t38 = tp_0 * t26 + tp_1 * t27 - tp_2 * t28 - tp_3 * t29;
            M[7 * 8 + j] = M[10 * 8 + j] = t36 * t11 + t17 * t37 + t38 * t34;
            const real t39 = tp_3 * t2 + tp_2 * t3 - tp_1 * t4 - tp_0 * t5;
            const real t40 = tp_2 * t21 - tp_3 * t20 - tp_1 * t19 + tp_0 * t22;
            const real t41 = tp_3 * t26 + tp_2 * t27 + tp_1 * t28 + tp_0 * t29;
            M[8 * 8 + j] = M[14 * 8 + j] = t39 * t11 + t17 * t40 + t41 * t34;
            const real t42 = tp_3 * t3 - tp_2 * t2 + tp_0 * t4 - tp_1 * t5;
            const real t43 = tp_2 * t20 + tp_3 * t21 + tp_0 * t19 + tp_1 * t22;
            const real t44 = tp_3 * t27 - tp_2 * t26 - tp_0 * t28 + tp_1 * t29;
            M[9 * 8 + j] = M[18 * 8 + j] = t42 * t11 + t17 * t43 + t44 * t34;
            const real t45 = t14 + t16 + t15;
            const real t46 = t6 - t9 - t10;
            const real t47 = 4.0 * tp_0 * u_p_0;
            const real t48 = 4.0 * tp_1 * u_p_1;
            const real t49 = 4.0 * tp_2 * u_p_2;
            const real t50 = 4.0 * tp_3 * u_p_3;
            const real t51 = t48 - (t49 + t50) + t47;
            M[11 * 8 + j] = t36 * t45 + t46 * t37 + t38 * t51;
            M[12 * 8 + j] = M[15 * 8 + j] = t39 * t45 + t46 * t40 + t41 * t51;
            M[13 * 8 + j] = M[19 * 8 + j] = t42 * t45 + t46 * t43 + t44 * t51;
            const real t52 = t30 + t33;
            const real t53 = t31 - t52 + t32;
            const real t54 = t47 - t48;
            const real t55 = t49 + t54 - t50;
            const real t56 = t6 + t10 + t8 + t7;
            M[16 * 8 + j] = t39 * t53 + t55 * t40 + t41 * t56;
            M[17 * 8 + j] = M[20 * 8 + j] = t42 * t53 + t55 * t43 + t44 * t56;
            M[21 * 8 + j] = t42 * (t50 + t54 - t49) + (t32 + t52 + t31) * t43 + t44 * (t16 - t15 + t13 - t12);
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t57 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t58 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t59 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t60 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t61 = (u_p_0 * t58 + u_p_1 * t59 - u_p_2 * t57 - u_p_3 * t60) * t18;
            const real t62 = t57 * t61;
            const real t63 = t57 * t58;
            const real t64 = t60 * t59;
            const real t65 = t18 * (t63 + t64 - t63 - t64);
            const real t66 = (u_p_0 * t59 + u_p_2 * t60 - u_p_1 * t58 - u_p_3 * t57) * t1;
            const real t67 = t60 * t66;
            const real t68 = t57 * t59;
            const real t69 = t60 * t58;
            const real t70 = t1 * (t68 + t69 - t69 - t68);
            const real t71 = (u_p_0 * t60 + u_p_3 * t58 - u_p_1 * t57 - u_p_2 * t59) * t25;
            const real t72 = t59 * t71;
            const real t73 = t60 * t57;
            const real t74 = t59 * t58;
            const real t75 = t25 * (t73 + t74 - t73 - t74);
            const real t76 = 4.0 * (t62 + u_p_0 * t65) - 4.0 * (t67 + u_p_1 * t70) + 4.0 * (t72 + u_p_3 * t75);
            const real t77 = t76 - (4.0 * t67 - 4.0 * t62 - 4.0 * t72);
            const real t78 = t58 * t66;
            const real t79 = t59 * t61;
            const real t80 = t57 * t71;
            const real t81 = 4.0 * (t78 + u_p_2 * t70) - 4.0 * (t79 + u_p_3 * t65) + 4.0 * (t80 + u_p_0 * t75);
            const real t82 = t81 - (4.0 * t79 - 4.0 * t78 - 4.0 * t80);
            const real t83 = t57 * t66;
            const real t84 = t60 * t61;
            const real t85 = t58 * t71;
            const real t86 = 4.0 * (t83 + u_p_0 * t70) + 4.0 * (t84 + u_p_1 * t65) - 4.0 * (t85 + u_p_2 * t75);
            const real t87 = t86 - (4.0 * t85 - (4.0 * t83 + 4.0 * t84));
            const real t88 = t59 * t66;
            const real t89 = t58 * t61;
            const real t90 = t60 * t71;
            const real t91 = 4.0 * (t88 + u_p_3 * t70) + 4.0 * (t89 + u_p_2 * t65) + 4.0 * (t90 + u_p_1 * t75);
            const real t92 = 4.0 * t88 + 4.0 * t89 + 4.0 * t90 + t91;
            h[0 * 8 + j] = tp_1 * t82 + tp_3 * t87 + tp_2 * t77 - tp_0 * t92;
            h[1 * 8 + j] = tp_0 * t82 + tp_1 * t92 + tp_2 * t87 - tp_3 * t77;
            h[2 * 8 + j] = tp_3 * t82 + tp_2 * t92 + tp_0 * t77 - tp_1 * t87;
            h[3 * 8 + j] = tp_3 * t92 + tp_0 * t87 + tp_1 * t77 - tp_2 * t82;
            const real gravity_x = p[12 * 8 + j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * gravity_x * t0;
            const real gravity_y = p[13 * 8 + j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * gravity_y * t0;
            const real gravity_z = p[14 * 8 + j];
            f[2 * 8 + j] = f[5 * 8 + j] = 0.5 * gravity_z * t0;
            const real p_z = x[2 * 8 + j];
            const real q_z = x[9 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real q_x = x[7 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[8 * 8 + j];
            const real t93 = gravity_x * (p_x + q_x) + gravity_y * (p_y + q_y) + gravity_z * (p_z + q_z);
            U[0 * 8 + j] = -(0.5 * t0 * t93);
        }
    }
}

/* tangent: 881 operations.
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
            const real l0 = p[7 * 8 + j];
            const real rhoJ_x = p[9 * 8 + j];
            const real t0 = l0 * rhoJ_x;
            const real rp_vl2 = v[5 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real rp_vl0 = v[3 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real t1 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t2 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t3 = t1 * t2;
            const real rp_l0 = x[3 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real rp_al2 = a[5 * 8 + j];
            const real rp_al0 = a[3 * 8 + j];
            const real rp_al1 = a[4 * 8 + j];
            const real rp_al3 = a[6 * 8 + j];
            const real t4 = tp_1 * rp_al0 + tp_0 * rp_al1 + tp_3 * rp_al2 - tp_2 * rp_al3;
            const real t5 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t6 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t7 = t5 * t6;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t8 = tp_2 * rp_al0 + tp_0 * rp_al2 + tp_1 * rp_al3 - tp_3 * rp_al1;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t9 = tp_0 * rp_al0 - tp_1 * rp_al1 - tp_2 * rp_al2 - tp_3 * rp_al3;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t10 = tp_3 * rp_al0 + tp_2 * rp_al1 + tp_0 * rp_al3 - tp_1 * rp_al2;
            const real t11 = t3 + u_p_0 * t4 + (t7 + u_p_3 * t8) - (t3 + u_p_1 * t9) - (t7 + u_p_2 * t10);
            const real t12 = t0 * t11;
            const real rhoJ_y = p[10 * 8 + j];
            const real t13 = l0 * rhoJ_y;
            const real t14 = t2 * t6;
            const real t15 = t1 * t5;
            const real t16 = t14 + u_p_0 * t8 + (t15 + u_p_1 * t10) - (t14 + u_p_2 * t9);
            const real t17 = t13 * (t16 - (t15 + u_p_3 * t4));
            const real rhoJ_z = p[11 * 8 + j];
            const real t18 = l0 * rhoJ_z;
            const real t19 = t2 * t5;
            const real t20 = t1 * t6;
            const real t21 = t19 + u_p_0 * t10 + (t20 + u_p_2 * t4) - (t20 + u_p_1 * t8);
            const real t22 = t18 * (t21 - (t19 + u_p_3 * t9));
            const real t23 = 4.0 * tp_2 * t12 - 4.0 * tp_1 * t17 - 4.0 * tp_0 * t22;
            const real t24 = 4.0 * tp_1 * u_p_0;
            const real t25 = 4.0 * tp_0 * u_p_1;
            const real t26 = 4.0 * tp_3 * u_p_2;
            const real t27 = 4.0 * tp_2 * u_p_3;
            const real t28 = t0 * (t24 - t25 - t26 + t27);
            const real t29 = 4.0 * tp_2 * u_p_0;
            const real t30 = 4.0 * tp_3 * u_p_1;
            const real t31 = t29 + t30;
            const real t32 = 4.0 * tp_0 * u_p_2;
            const real t33 = 4.0 * tp_1 * u_p_3;
            const real t34 = t13 * (t31 - t32 - t33);
            const real t35 = 4.0 * tp_3 * u_p_0;
            const real t36 = 4.0 * tp_2 * u_p_1;
            const real t37 = t35 - t36;
            const real t38 = 4.0 * tp_1 * u_p_2;
            const real t39 = 4.0 * tp_0 * u_p_3;
            const real t40 = t18 * (t37 + t38 - t39);
            const real t41 = 8.0 * tp_1 * t6;
            const real t42 = 8.0 * tp_0 * t5;
            const real t43 = t41 - t42;
            const real t44 = 8.0 * tp_2 * t1;
            const real t45 = 8.0 * tp_3 * t2;
            const real t46 = t18 * (t43 - t44 + t45);
            const real t47 = 8.0 * tp_2 * t2;
            const real t48 = 8.0 * tp_0 * t6;
            const real t49 = 8.0 * tp_1 * t5;
            const real t50 = t48 + t49;
            const real t51 = 8.0 * tp_3 * t1;
            const real t52 = t13 * (t47 - t50 + t51);
            const real t53 = t23 + t8 * t28 - t4 * t34 - t9 * t40 - t2 * t46 - t1 * t52;
            const real t54 = 8.0 * tp_1 * t2;
            const real t55 = 8.0 * tp_0 * t1;
            const real t56 = 8.0 * tp_2 * t5;
            const real t57 = 8.0 * tp_3 * t6;
            const real t58 = t0 * (t54 - t55 + t56 - t57);
            const real t59 = t53 + t6 * t58;
            const real t60 = 4.0 * tp_1 * t22 - (4.0 * tp_3 * t12 + 4.0 * tp_0 * t17);
            const real t61 = t60 - t10 * t28 - t9 * t34 + t4 * t40 + t1 * t46 - t2 * t52;
            const real t62 = t61 - t5 * t58;
            const real t63 = 4.0 * tp_3 * t17 - 4.0 * tp_0 * t12 - 4.0 * tp_2 * t22;
            const real t64 = t63 - t9 * t28 + t10 * t34 - t8 * t40 - t6 * t46 + t5 * t52;
            const real t65 = t64 - t2 * t58;
            const real t66 = 4.0 * tp_1 * t12 + 4.0 * tp_2 * t17 + 4.0 * tp_3 * t22;
            const real t67 = t66 + t4 * t28 + t8 * t34 + t10 * t40 + t5 * t46 + t6 * t52;
            const real t68 = t67 + t1 * t58;
            R_x[0 * 8 + j] = tp_3 * t59 + tp_2 * t62 + tp_1 * t65 + tp_0 * t68;
            R_x[1 * 8 + j] = tp_2 * t59 - tp_3 * t62 + tp_0 * t65 - tp_1 * t68;
            R_x[2 * 8 + j] = tp_0 * t62 - tp_1 * t59 + tp_3 * t65 - tp_2 * t68;
            R_x[3 * 8 + j] = tp_0 * t59 + tp_1 * t62 - tp_2 * t65 - tp_3 * t68;
            const real t69 = 4.0 * tp_0 * u_p_0;
            const real t70 = 4.0 * tp_1 * u_p_1;
            const real t71 = 4.0 * tp_2 * u_p_2;
            const real t72 = 4.0 * tp_3 * u_p_3;
            const real t73 = t0 * (t69 + t70 - t71 - t72);
            const real t74 = t13 * (t38 - t37 - t39);
            const real t75 = t18 * (t31 + t32 + t33);
            const real t76 = t18 * (t50 + t51 + t47);
            const real t77 = t13 * (t43 - t45 + t44);
            const real t78 = t60 + t8 * t73 - t4 * t74 - t9 * t75 - t2 * t76 - t1 * t77;
            const real t79 = 8.0 * tp_1 * t1;
            const real t80 = 8.0 * tp_0 * t2;
            const real t81 = 8.0 * tp_3 * t5;
            const real t82 = 8.0 * tp_2 * t6;
            const real t83 = t0 * (t79 + t80 - t81 - t82);
            const real t84 = t78 + t6 * t83;
            const real t85 = t4 * t75 - (t23 + t10 * t73 + t9 * t74) + t1 * t76 - t2 * t77;
            const real t86 = t85 - t5 * t83;
            const real t87 = t66 - t9 * t73 + t10 * t74 - t8 * t75 - t6 * t76 + t5 * t77;
            const real t88 = t87 - t2 * t83;
            const real t89 = t4 * t73 - t63 + t8 * t74 + t10 * t75 + t5 * t76 + t6 * t77;
            const real t90 = t89 + t1 * t83;
            R_x[4 * 8 + j] = tp_3 * t84 + tp_2 * t86 + tp_1 * t88 + tp_0 * t90;
            R_x[5 * 8 + j] = tp_2 * t84 - tp_3 * t86 + tp_0 * t88 - tp_1 * t90;
            R_x[6 * 8 + j] = tp_0 * t86 - tp_1 * t84 + tp_3 * t88 - tp_2 * t90;
            R_x[7 * 8 + j] = tp_0 * t84 + tp_1 * t86 - tp_2 * t88 - tp_3 * t90;
            const real t91 = t0 * (t35 + t36 + t38 + t39);
            const real t92 = t69 - t70;
            const real t93 = t13 * (t71 + t92 - t72);
            const real t94 = t24 + t25;
            const real t95 = t18 * (t26 - t94 + t27);
            const real t96 = t56 + t57;
            const real t97 = t18 * (t96 - t55 - t54);
            const real t98 = t82 - t81;
            const real t99 = t13 * (t80 + t98 - t79);
            const real t100 = t8 * t91 - t63 - t4 * t93 - t9 * t95 - t2 * t97 - t1 * t99;
            const real t101 = t0 * (t44 + t45 + t42 + t41);
            const real t102 = t100 + t6 * t101;
            const real t103 = t66 - t10 * t91 - t9 * t93 + t4 * t95 + t1 * t97 - t2 * t99;
            const real t104 = t103 - t5 * t101;
            const real t105 = t23 - t9 * t91 + t10 * t93 - t8 * t95 - t6 * t97 + t5 * t99;
            const real t106 = t105 - t2 * t101;
            const real t107 = t4 * t91 - t60 + t8 * t93 + t10 * t95 + t5 * t97 + t6 * t99;
            const real t108 = t107 + t1 * t101;
            R_x[8 * 8 + j] = tp_3 * t102 + tp_2 * t104 + tp_1 * t106 + tp_0 * t108;
            R_x[9 * 8 + j] = tp_2 * t102 - tp_3 * t104 + tp_0 * t106 - tp_1 * t108;
            R_x[10 * 8 + j] = tp_0 * t104 - tp_1 * t102 + tp_3 * t106 - tp_2 * t108;
            R_x[11 * 8 + j] = tp_0 * t102 + tp_1 * t104 - tp_2 * t106 - tp_3 * t108;
            const real t109 = t0 * (t30 - t29 - t32 + t33);
            const real t110 = t13 * (t26 + t94 + t27);
            const real t111 = t18 * (t92 - t71 + t72);
            const real t112 = t18 * (t80 - (t79 + t98));
            const real t113 = t13 * (t54 + t96 + t55);
            const real t114 = t66 + t8 * t109 - t4 * t110 - t9 * t111 - t2 * t112 - t1 * t113;
            const real t115 = t0 * (t51 - t47 + t49 - t48);
            const real t116 = t114 + t6 * t115;
            const real t117 = t63 - t10 * t109 - t9 * t110 + t4 * t111 + t1 * t112 - t2 * t113;
            const real t118 = t117 - t5 * t115;
            const real t119 = t10 * t110 - (t60 + t9 * t109) - t8 * t111 - t6 * t112 + t5 * t113;
            const real t120 = t119 - t2 * t115;
            const real t121 = t4 * t109 - t23 + t8 * t110 + t10 * t111 + t5 * t112 + t6 * t113;
            const real t122 = t121 + t1 * t115;
            R_x[12 * 8 + j] = tp_3 * t116 + tp_2 * t118 + tp_1 * t120 + tp_0 * t122;
            R_x[13 * 8 + j] = tp_2 * t116 - tp_3 * t118 + tp_0 * t120 - tp_1 * t122;
            R_x[14 * 8 + j] = tp_0 * t118 - tp_1 * t116 + tp_3 * t120 - tp_2 * t122;
            R_x[15 * 8 + j] = tp_0 * t116 + tp_1 * t118 - tp_2 * t120 - tp_3 * t122;
            const real t123 = (u_p_0 * t5 + u_p_2 * t1 - u_p_1 * t6 - u_p_3 * t2) * t18;
            const real t124 = (u_p_0 * t1 + u_p_3 * t6 - u_p_1 * t2 - u_p_2 * t5) * t0;
            const real t125 = (u_p_0 * t6 + u_p_1 * t5 - u_p_2 * t2 - u_p_3 * t1) * t13;
            const real t126 = 8.0 * tp_1 * t123 - (8.0 * tp_3 * t124 + 8.0 * tp_0 * t125);
            const real t127 = t126 - u_p_1 * t46 + u_p_0 * t52 + u_p_3 * t58;
            const real t128 = 8.0 * tp_2 * t124 - 8.0 * tp_1 * t125 - 8.0 * tp_0 * t123;
            const real t129 = t128 + u_p_0 * t46 + u_p_1 * t52 - u_p_2 * t58;
            const real t130 = 8.0 * tp_1 * t124 + 8.0 * tp_2 * t125 + 8.0 * tp_3 * t123;
            const real t131 = t130 - u_p_3 * t46 - u_p_2 * t52 - u_p_1 * t58;
            const real t132 = 8.0 * tp_3 * t125 - 8.0 * tp_0 * t124 - 8.0 * tp_2 * t123;
            const real t133 = t132 + u_p_2 * t46 - u_p_3 * t52 + u_p_0 * t58;
            R_v[0 * 8 + j] = tp_2 * t127 + tp_3 * t129 + tp_0 * t131 + tp_1 * t133;
            R_v[1 * 8 + j] = tp_2 * t129 - tp_3 * t127 - tp_1 * t131 + tp_0 * t133;
            R_v[2 * 8 + j] = tp_0 * t127 - tp_1 * t129 - tp_2 * t131 + tp_3 * t133;
            R_v[3 * 8 + j] = tp_1 * t127 + tp_0 * t129 - tp_3 * t131 - tp_2 * t133;
            const real t134 = u_p_0 * t77 - (t128 + u_p_1 * t76) + u_p_3 * t83;
            const real t135 = t126 + u_p_0 * t76 + u_p_1 * t77 - u_p_2 * t83;
            const real t136 = t132 + u_p_3 * t76 + u_p_2 * t77 + u_p_1 * t83;
            const real t137 = t130 + u_p_2 * t76 - u_p_3 * t77 + u_p_0 * t83;
            R_v[4 * 8 + j] = tp_2 * t134 + tp_3 * t135 - tp_0 * t136 + tp_1 * t137;
            R_v[5 * 8 + j] = tp_2 * t135 - tp_3 * t134 + tp_1 * t136 + tp_0 * t137;
            R_v[6 * 8 + j] = tp_0 * t134 - tp_1 * t135 + tp_2 * t136 + tp_3 * t137;
            R_v[7 * 8 + j] = tp_1 * t134 + tp_0 * t135 + tp_3 * t136 - tp_2 * t137;
            const real t138 = t130 - u_p_1 * t97 + u_p_0 * t99 + u_p_3 * t101;
            const real t139 = u_p_0 * t97 - t132 + u_p_1 * t99 - u_p_2 * t101;
            const real t140 = t126 + u_p_3 * t97 + u_p_2 * t99 + u_p_1 * t101;
            const real t141 = t128 + u_p_2 * t97 - u_p_3 * t99 + u_p_0 * t101;
            R_v[8 * 8 + j] = tp_2 * t138 + tp_3 * t139 - tp_0 * t140 + tp_1 * t141;
            R_v[9 * 8 + j] = tp_2 * t139 - tp_3 * t138 + tp_1 * t140 + tp_0 * t141;
            R_v[10 * 8 + j] = tp_0 * t138 - tp_1 * t139 + tp_2 * t140 + tp_3 * t141;
            R_v[11 * 8 + j] = tp_1 * t138 + tp_0 * t139 + tp_3 * t140 - tp_2 * t141;
            const real t142 = t132 - u_p_1 * t112 + u_p_0 * t113 + u_p_3 * t115;
            const real t143 = t130 + u_p_0 * t112 + u_p_1 * t113 - u_p_2 * t115;
            const real t144 = t128 + u_p_3 * t112 + u_p_2 * t113 + u_p_1 * t115;
            const real t145 = u_p_2 * t112 - t126 - u_p_3 * t113 + u_p_0 * t115;
            R_v[12 * 8 + j] = tp_2 * t142 + tp_3 * t143 - tp_0 * t144 + tp_1 * t145;
            R_v[13 * 8 + j] = tp_2 * t143 - tp_3 * t142 + tp_1 * t144 + tp_0 * t145;
            R_v[14 * 8 + j] = tp_0 * t142 - tp_1 * t143 + tp_2 * t144 + tp_3 * t145;
            R_v[15 * 8 + j] = tp_1 * t142 + tp_0 * t143 + tp_3 * t144 - tp_2 * t145;
        }
    }
}

const flexel_element flexel_beam3 = {
    .name = "beam3",
    .n = 10,
    .m = 3,
    .k = 0,
    .np = 15,
    .position = beam3_position,
    .velocity = beam3_velocity,
    .acceleration = beam3_acceleration,
    .kinematics = beam3_kinematics,
    .stiffness = beam3_stiffness,
    .inertia = beam3_inertia,
    .tangent = beam3_tangent,
};
