/* hinge: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq
 * c = conj(u_p) o u_q
 * angle = 2 atan2(c1, c0), period 2 pi
 * bend1 = ez_p.ex_q,  bend2 = -ey_p.ex_q
 * axes: ex_p, ey_p, ez_p in rows
 *
 * Source: van der Werff and Jonker 1984; SPACAR95 manual (Schwab and Meijaard 2000), HINGE
 *
 * x (8): p_l0, p_l1, p_l2, p_l3, q_l0, q_l1, q_l2, q_l3
 * e (3): angle [rad], bend1 [1], bend2 [1]
 * s (0): none
 * p (8):
 *   tp (4) [1]: unit quaternion from the body frame of node p to the element's triad there
 *   tq (4) [1]: unit quaternion from the body frame of node q to the element's triad there */
#include "kernels.h"

/* position: 412 operations.
 * in:  x (8), p (8)
 * out: e (3), De (3,8), V (0,8) */
FLEXEL_CLONES
static void hinge_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict p = in[1] + b * (8 * 8);
        real *restrict e = out[0] + b * (3 * 8);
        real *restrict De = out[1] + b * (24 * 8);
        real c1[8], c0[8], t0[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_l0 = x[0 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real p_l1 = x[1 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real p_l2 = x[2 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real p_l3 = x[3 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = p_l0 * tp_0 - p_l1 * tp_1 - p_l2 * tp_2 - p_l3 * tp_3;
            const real q_l2 = x[6 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real q_l0 = x[4 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real q_l1 = x[5 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real q_l3 = x[7 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real u_q_1 = q_l0 * tq_1 + q_l1 * tq_0 + q_l2 * tq_3 - q_l3 * tq_2;
            const real u_p_3 = p_l0 * tp_3 + p_l1 * tp_2 + p_l3 * tp_0 - p_l2 * tp_1;
            const real u_q_2 = q_l0 * tq_2 + q_l2 * tq_0 + q_l3 * tq_1 - q_l1 * tq_3;
            const real u_p_1 = p_l0 * tp_1 + p_l1 * tp_0 + p_l2 * tp_3 - p_l3 * tp_2;
            const real u_q_0 = q_l0 * tq_0 - q_l1 * tq_1 - q_l2 * tq_2 - q_l3 * tq_3;
            const real u_p_2 = p_l0 * tp_2 + p_l2 * tp_0 + p_l3 * tp_1 - p_l1 * tp_3;
            const real u_q_3 = q_l0 * tq_3 + q_l1 * tq_2 + q_l3 * tq_0 - q_l2 * tq_1;
            c1[j] = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_p_1 * u_q_0 - u_p_2 * u_q_3;
            c0[j] = u_p_0 * u_q_0 + u_p_1 * u_q_1 + u_p_2 * u_q_2 + u_p_3 * u_q_3;
            const real t1 = u_p_2 * u_p_3;
            const real t2 = u_p_0 * u_p_1;
            const real t3 = t1 - t2;
            const real t4 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real t5 = u_p_0 * u_p_2 + u_p_1 * u_p_3;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t6 = u_p_0 * u_p_0;
            const real t7 = u_p_3 * u_p_3;
            const real t8 = u_p_1 * u_p_1;
            const real t9 = u_p_2 * u_p_2;
            const real ez_p_z = t6 + t7 - t8 - t9;
            const real t10 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            e[1 * 8 + j] = 4.0 * t3 * t4 + 2.0 * (t5 * ex_q_x + ez_p_z * t10);
            const real t11 = t2 + t1;
            const real t12 = u_p_1 * u_p_2 - u_p_0 * u_p_3;
            const real ey_p_y = t6 + t9 - t8 - t7;
            e[2 * 8 + j] = -(4.0 * t11 * t10 + 2.0 * (t12 * ex_q_x + ey_p_y * t4));
            const real t13 = 1.0 / (c1[j] * c1[j] + c0[j] * c0[j]);
            const real t14 = c0[j] * t13;
            const real t15 = c1[j] * t13;
            const real t16 = 2.0 * u_q_2 * t14 - 2.0 * u_q_3 * t15;
            const real t17 = 2.0 * u_q_1 * t14 - 2.0 * u_q_0 * t15;
            const real t18 = 2.0 * u_q_0 * t14 + 2.0 * u_q_1 * t15;
            const real t19 = 2.0 * u_q_3 * t14 + 2.0 * u_q_2 * t15;
            De[0 * 8 + j] = tp_0 * t17 - tp_1 * t18 - tp_2 * t19 + tp_3 * t16; /* De(0,0) */
            De[1 * 8 + j] = tp_3 * t19 - (tp_0 * t18 + tp_1 * t17) + tp_2 * t16; /* De(0,1) */
            De[2 * 8 + j] = -(tp_3 * t18 + tp_2 * t17 + tp_0 * t19 + tp_1 * t16); /* De(0,2) */
            De[3 * 8 + j] = tp_2 * t18 - tp_3 * t17 - tp_1 * t19 + tp_0 * t16; /* De(0,3) */
            const real t20 = 2.0 * u_p_3 * t14 - 2.0 * u_p_2 * t15;
            const real t21 = 2.0 * u_p_0 * t14 - 2.0 * u_p_1 * t15;
            const real t22 = 2.0 * u_p_1 * t14 + 2.0 * u_p_0 * t15;
            const real t23 = 2.0 * u_p_2 * t14 + 2.0 * u_p_3 * t15;
            De[4 * 8 + j] = tq_1 * t21 - tq_0 * t22 + tq_2 * t20 - tq_3 * t23; /* De(0,4) */
            De[5 * 8 + j] = tq_0 * t21 + tq_1 * t22 - tq_3 * t20 - tq_2 * t23; /* De(0,5) */
            De[6 * 8 + j] = tq_3 * t21 + tq_2 * t22 + tq_0 * t20 + tq_1 * t23; /* De(0,6) */
            De[7 * 8 + j] = tq_3 * t22 - tq_2 * t21 + tq_1 * t20 - tq_0 * t23; /* De(0,7) */
            const real t24 = 4.0 * u_p_2 * t4 + 2.0 * u_p_1 * ex_q_x + 4.0 * u_p_3 * t10;
            const real t25 = tp_3 * t24;
            const real t26 = 2.0 * u_p_3 * ex_q_x - 4.0 * u_p_0 * t4 - 4.0 * u_p_1 * t10;
            const real t27 = 2.0 * u_p_2 * ex_q_x - 4.0 * u_p_1 * t4 + 4.0 * u_p_0 * t10;
            const real t28 = tp_1 * t26 + tp_0 * t27;
            const real t29 = 4.0 * u_p_3 * t4 + 2.0 * u_p_0 * ex_q_x - 4.0 * u_p_2 * t10;
            const real t30 = tp_2 * t29;
            De[8 * 8 + j] = t28 + t30 + t25; /* De(1,0) */
            const real t31 = tp_2 * t24;
            const real t32 = tp_0 * t26 - tp_1 * t27;
            const real t33 = tp_3 * t29;
            De[9 * 8 + j] = t32 - t33 + t31; /* De(1,1) */
            const real t34 = tp_0 * t29;
            const real t35 = tp_2 * t27 - tp_3 * t26;
            const real t36 = tp_1 * t24;
            De[10 * 8 + j] = t34 - t35 - t36; /* De(1,2) */
            const real t37 = tp_0 * t24;
            const real t38 = tp_1 * t29;
            const real t39 = tp_2 * t26 + tp_3 * t27;
            De[11 * 8 + j] = t38 - t39 + t37; /* De(1,3) */
            const real t40 = 4.0 * u_q_3 * t3 + 4.0 * u_q_0 * t5 - 2.0 * u_q_2 * ez_p_z;
            const real t41 = 4.0 * u_q_2 * t3 + 4.0 * u_q_1 * t5 + 2.0 * u_q_3 * ez_p_z;
            const real t42 = 4.0 * u_q_1 * t3 - 4.0 * u_q_2 * t5 - 2.0 * u_q_0 * ez_p_z;
            const real t43 = 4.0 * u_q_0 * t3 - 4.0 * u_q_3 * t5 + 2.0 * u_q_1 * ez_p_z;
            De[12 * 8 + j] = tq_0 * t40 + tq_1 * t41 + tq_2 * t42 + tq_3 * t43; /* De(1,4) */
            De[13 * 8 + j] = tq_0 * t41 - tq_1 * t40 - tq_3 * t42 + tq_2 * t43; /* De(1,5) */
            De[14 * 8 + j] = tq_3 * t41 - tq_2 * t40 + tq_0 * t42 - tq_1 * t43; /* De(1,6) */
            De[15 * 8 + j] = tq_1 * t42 - (tq_3 * t40 + tq_2 * t41) + tq_0 * t43; /* De(1,7) */
            De[16 * 8 + j] = t32 - t31 + t33; /* De(2,0) */
            De[17 * 8 + j] = t25 - t28 + t30; /* De(2,1) */
            De[18 * 8 + j] = -(t39 + t37 + t38); /* De(2,2) */
            De[19 * 8 + j] = t35 - t36 + t34; /* De(2,3) */
            const real t44 = 4.0 * u_q_2 * t11 - (2.0 * u_q_3 * ey_p_y + 4.0 * u_q_0 * t12);
            const real t45 = 2.0 * u_q_2 * ey_p_y + 4.0 * u_q_1 * t12 + 4.0 * u_q_3 * t11;
            const real t46 = 4.0 * u_q_2 * t12 - 2.0 * u_q_1 * ey_p_y + 4.0 * u_q_0 * t11;
            const real t47 = 4.0 * u_q_3 * t12 - 2.0 * u_q_0 * ey_p_y - 4.0 * u_q_1 * t11;
            De[20 * 8 + j] = tq_0 * t44 - tq_1 * t45 + tq_2 * t46 + tq_3 * t47; /* De(2,4) */
            De[21 * 8 + j] = tq_2 * t47 - (tq_1 * t44 + tq_0 * t45 + tq_3 * t46); /* De(2,5) */
            De[22 * 8 + j] = tq_0 * t46 - (tq_2 * t44 + tq_3 * t45) - tq_1 * t47; /* De(2,6) */
            De[23 * 8 + j] = tq_2 * t45 - tq_3 * t44 + tq_1 * t46 + tq_0 * t47; /* De(2,7) */
        }
        for (size_t j = 0; j < 8; j++) {
            t0[j] = real_atan2(c1[j], c0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            e[0 * 8 + j] = 2.0 * t0[j];
        }
    }
}

/* acceleration: 371 operations.
 * in:  x (8), v (8), p (8)
 * out: g (3), gs (0) */
FLEXEL_CLONES
static void hinge_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict g = out[0] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_l0 = x[0 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real p_l1 = x[1 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real p_l2 = x[2 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real p_l3 = x[3 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = p_l0 * tp_0 - p_l1 * tp_1 - p_l2 * tp_2 - p_l3 * tp_3;
            const real q_l2 = x[6 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real q_l0 = x[4 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real q_l1 = x[5 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real q_l3 = x[7 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real u_q_1 = q_l0 * tq_1 + q_l1 * tq_0 + q_l2 * tq_3 - q_l3 * tq_2;
            const real u_p_3 = p_l0 * tp_3 + p_l1 * tp_2 + p_l3 * tp_0 - p_l2 * tp_1;
            const real u_q_2 = q_l0 * tq_2 + q_l2 * tq_0 + q_l3 * tq_1 - q_l1 * tq_3;
            const real u_p_1 = p_l0 * tp_1 + p_l1 * tp_0 + p_l2 * tp_3 - p_l3 * tp_2;
            const real u_q_0 = q_l0 * tq_0 - q_l1 * tq_1 - q_l2 * tq_2 - q_l3 * tq_3;
            const real u_p_2 = p_l0 * tp_2 + p_l2 * tp_0 + p_l3 * tp_1 - p_l1 * tp_3;
            const real u_q_3 = q_l0 * tq_3 + q_l1 * tq_2 + q_l3 * tq_0 - q_l2 * tq_1;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_p_1 * u_q_0 - u_p_2 * u_q_3;
            const real c0 = u_p_0 * u_q_0 + u_p_1 * u_q_1 + u_p_3 * u_q_3 + u_p_2 * u_q_2;
            const real t0 = 1.0 / (c1 * c1 + c0 * c0);
            const real p_vl0 = v[0 * 8 + j];
            const real p_vl1 = v[1 * 8 + j];
            const real p_vl2 = v[2 * 8 + j];
            const real p_vl3 = v[3 * 8 + j];
            const real t1 = p_vl0 * tp_0 - p_vl1 * tp_1 - p_vl2 * tp_2 - p_vl3 * tp_3;
            const real q_vl2 = v[6 * 8 + j];
            const real q_vl0 = v[4 * 8 + j];
            const real q_vl1 = v[5 * 8 + j];
            const real q_vl3 = v[7 * 8 + j];
            const real t2 = q_vl0 * tq_1 + q_vl1 * tq_0 + q_vl2 * tq_3 - q_vl3 * tq_2;
            const real t3 = p_vl0 * tp_3 + p_vl1 * tp_2 + p_vl3 * tp_0 - p_vl2 * tp_1;
            const real t4 = q_vl0 * tq_2 + q_vl2 * tq_0 + q_vl3 * tq_1 - q_vl1 * tq_3;
            const real t5 = p_vl0 * tp_1 + p_vl1 * tp_0 + p_vl2 * tp_3 - p_vl3 * tp_2;
            const real t6 = q_vl0 * tq_0 - q_vl1 * tq_1 - q_vl2 * tq_2 - q_vl3 * tq_3;
            const real t7 = p_vl0 * tp_2 + p_vl2 * tp_0 + p_vl3 * tp_1 - p_vl1 * tp_3;
            const real t8 = q_vl0 * tq_3 + q_vl1 * tq_2 + q_vl3 * tq_0 - q_vl2 * tq_1;
            const real t9 = c0 * (t1 * t2 + t3 * t4 - t5 * t6 - t7 * t8) - c1 * (t1 * t6 + t5 * t2 + t3 * t8 + t7
                * t4);
            const real t10 = u_q_2 * t3 + u_p_3 * t4 + u_q_1 * t1 + u_p_0 * t2 - u_q_0 * t5;
            const real t11 = t10 - u_p_1 * t6 - u_q_3 * t7 - u_p_2 * t8;
            const real t12 = u_q_1 * t5 + u_p_1 * t2 + u_p_0 * t6 + u_q_0 * t1 + u_p_2 * t4;
            const real t13 = u_q_2 * t7 + t12 + u_q_3 * t3 + u_p_3 * t8;
            const real t14 = t0 * t0 * (c1 * t11 + c0 * t13);
            const real t15 = 2.0 * t0 * t9 + t11 * (t0 * t13 - 2.0 * c0 * t14) - t13 * (t0 * t11 - 2.0 * c1 * t14);
            g[0 * 8 + j] = 2.0 * t15;
            const real t16 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real t17 = 2.0 * t7 * t3;
            const real t18 = 2.0 * t1 * t5;
            const real t19 = u_p_2 * u_p_3;
            const real t20 = u_p_0 * u_p_1;
            const real t21 = t6 * t8 + t2 * t4;
            const real t22 = u_p_3 * t7 + u_p_2 * t3;
            const real t23 = u_p_1 * t1 + u_p_0 * t5;
            const real t24 = u_q_2 * t2 + u_q_1 * t4 + u_q_3 * t6 + u_q_0 * t8;
            const real t25 = t16 * (t17 - t18) + 2.0 * ((t19 - t20) * t21 + (t22 - t23) * t24);
            const real t26 = u_q_0 * t6 + u_q_1 * t2 - u_q_2 * t4 - u_q_3 * t8;
            const real t27 = (u_p_3 * t5 + u_p_1 * t3 + u_p_2 * t1 + u_p_0 * t7) * t26;
            const real t28 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            const real t29 = 2.0 * t1 * t1;
            const real t30 = 2.0 * t3 * t3;
            const real t31 = 2.0 * t5 * t5;
            const real t32 = 2.0 * t7 * t7;
            const real t33 = 2.0 * u_p_0 * t1;
            const real t34 = 2.0 * u_p_3 * t3;
            const real t35 = 2.0 * u_p_1 * t5;
            const real t36 = 2.0 * u_p_2 * t7;
            const real t37 = u_q_3 * t2 + u_q_1 * t8 - u_q_2 * t6 - u_q_0 * t4;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t38 = u_p_0 * u_p_0;
            const real t39 = u_p_3 * u_p_3;
            const real t40 = u_p_1 * u_p_1;
            const real t41 = u_p_2 * u_p_2;
            const real ez_p_z = t38 + t39 - t40 - t41;
            const real t42 = t2 * t8 - t6 * t4;
            const real t43 = t6 * t6 + t2 * t2 - t4 * t4 - t8 * t8;
            const real t44 = ez_p_z * t42 + (u_p_0 * u_p_2 + u_p_1 * u_p_3) * t43 + ex_q_x * (t1 * t7 + t5 * t3);
            const real t45 = t28 * (t29 + t30 - t31 - t32) + 2.0 * ((t33 + t34 - t35 - t36) * t37 + t44);
            g[1 * 8 + j] = 4.0 * t25 + 2.0 * (4.0 * t27 + t45);
            const real t46 = t28 * (t18 + t17) + 2.0 * ((t20 + t19) * t42 + (t23 + t22) * t37);
            const real t47 = (u_p_2 * t5 + u_p_1 * t7 - u_p_3 * t1 - u_p_0 * t3) * t26;
            const real ey_p_y = t38 + t41 - t40 - t39;
            const real t48 = ey_p_y * t21 + (u_p_1 * u_p_2 - u_p_0 * u_p_3) * t43 + ex_q_x * (t5 * t7 - t1 * t3);
            const real t49 = t16 * (t29 + t32 - t31 - t30) + 2.0 * ((t33 + t36 - t35 - t34) * t24 + t48);
            g[2 * 8 + j] = -(4.0 * t46 + 2.0 * (4.0 * t47 + t49));
        }
    }
}

/* rates: 654 operations.
 * in:  x (8), v (8), p (8)
 * out: Phi_x (3,8) */
FLEXEL_CLONES
static void hinge_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict Phi_x = out[0] + b * (24 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_l1 = x[1 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real p_l0 = x[0 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real p_l2 = x[2 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real p_l3 = x[3 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real u_p_1 = p_l0 * tp_1 + p_l2 * tp_3 + p_l1 * tp_0 - p_l3 * tp_2;
            const real q_l1 = x[5 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real q_l0 = x[4 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real q_l2 = x[6 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real q_l3 = x[7 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real u_q_1 = q_l0 * tq_1 + q_l2 * tq_3 + q_l1 * tq_0 - q_l3 * tq_2;
            const real u_p_0 = p_l0 * tp_0 - p_l1 * tp_1 - p_l2 * tp_2 - p_l3 * tp_3;
            const real u_q_0 = q_l0 * tq_0 - q_l1 * tq_1 - q_l2 * tq_2 - q_l3 * tq_3;
            const real u_p_3 = p_l0 * tp_3 + p_l3 * tp_0 + p_l1 * tp_2 - p_l2 * tp_1;
            const real u_q_3 = q_l0 * tq_3 + q_l3 * tq_0 + q_l1 * tq_2 - q_l2 * tq_1;
            const real u_p_2 = p_l0 * tp_2 + p_l3 * tp_1 + p_l2 * tp_0 - p_l1 * tp_3;
            const real u_q_2 = q_l0 * tq_2 + q_l3 * tq_1 + q_l2 * tq_0 - q_l1 * tq_3;
            const real c0 = u_p_3 * u_q_3 + u_p_2 * u_q_2 + u_p_0 * u_q_0 + u_p_1 * u_q_1;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_q_0 * u_p_1 - u_p_2 * u_q_3;
            const real t0 = 1.0 / (c1 * c1 + c0 * c0);
            const real t1 = c0 * t0;
            const real q_vl2 = v[6 * 8 + j];
            const real q_vl0 = v[4 * 8 + j];
            const real q_vl3 = v[7 * 8 + j];
            const real q_vl1 = v[5 * 8 + j];
            const real t2 = q_vl0 * tq_2 + q_vl3 * tq_1 + q_vl2 * tq_0 - q_vl1 * tq_3;
            const real t3 = c1 * t0;
            const real t4 = q_vl0 * tq_3 + q_vl3 * tq_0 + q_vl1 * tq_2 - q_vl2 * tq_1;
            const real p_vl1 = v[1 * 8 + j];
            const real p_vl0 = v[0 * 8 + j];
            const real p_vl3 = v[3 * 8 + j];
            const real p_vl2 = v[2 * 8 + j];
            const real t5 = p_vl0 * tp_3 + p_vl3 * tp_0 + p_vl1 * tp_2 - p_vl2 * tp_1;
            const real t6 = p_vl0 * tp_0 - p_vl1 * tp_1 - p_vl2 * tp_2 - p_vl3 * tp_3;
            const real t7 = q_vl0 * tq_1 + q_vl2 * tq_3 + q_vl1 * tq_0 - q_vl3 * tq_2;
            const real t8 = p_vl0 * tp_1 + p_vl2 * tp_3 + p_vl1 * tp_0 - p_vl3 * tp_2;
            const real t9 = t6 * u_q_1 + u_p_0 * t7 + u_q_2 * t5 + u_p_3 * t2 - u_q_0 * t8;
            const real t10 = q_vl0 * tq_0 - q_vl1 * tq_1 - q_vl2 * tq_2 - q_vl3 * tq_3;
            const real t11 = p_vl0 * tp_2 + p_vl3 * tp_1 + p_vl2 * tp_0 - p_vl1 * tp_3;
            const real t12 = t9 - t10 * u_p_1 - u_q_3 * t11 - u_p_2 * t4;
            const real t13 = t0 * t0;
            const real t14 = u_q_3 * t5 + u_p_3 * t4 + u_q_2 * t11 + u_p_2 * t2 + u_q_0 * t6;
            const real t15 = u_p_0 * t10 + t14 + u_q_1 * t8 + u_p_1 * t7;
            const real t16 = c0 * t12 - c1 * t15;
            const real t17 = t0 * t12 - 2.0 * c0 * t16 * t13;
            const real t18 = t0 * t15 + 2.0 * c1 * t16 * t13;
            const real t19 = 2.0 * (t1 * t2 - t3 * t4) + 2.0 * u_q_3 * t17 - 2.0 * u_q_2 * t18;
            const real t20 = 2.0 * u_q_2 * t17 + 2.0 * u_q_3 * t18 - 2.0 * (t3 * t2 + t1 * t4);
            const real t21 = 2.0 * (t1 * t7 - t10 * t3) + 2.0 * u_q_0 * t17 - 2.0 * u_q_1 * t18;
            const real t22 = 2.0 * u_q_1 * t17 + 2.0 * u_q_0 * t18 - 2.0 * (t3 * t7 + t10 * t1);
            Phi_x[0 * 8 + j] = tp_0 * t21 + tp_1 * t22 + tp_2 * t20 + tp_3 * t19; /* Phi_x(0,0) */
            Phi_x[1 * 8 + j] = tp_0 * t22 + tp_2 * t19 - tp_1 * t21 - tp_3 * t20; /* Phi_x(0,1) */
            Phi_x[2 * 8 + j] = tp_3 * t22 + tp_0 * t20 - tp_2 * t21 - tp_1 * t19; /* Phi_x(0,2) */
            Phi_x[3 * 8 + j] = tp_1 * t20 + tp_0 * t19 - tp_3 * t21 - tp_2 * t22; /* Phi_x(0,3) */
            const real t23 = 2.0 * u_p_3 * t17 + 2.0 * u_p_2 * t18 - 2.0 * (t3 * t5 + t1 * t11);
            const real t24 = 2.0 * (t1 * t5 - t3 * t11) + 2.0 * u_p_2 * t17 - 2.0 * u_p_3 * t18;
            const real t25 = 2.0 * u_p_0 * t17 + 2.0 * u_p_1 * t18 - 2.0 * (t6 * t3 + t1 * t8);
            const real t26 = 2.0 * (t6 * t1 - t3 * t8) + 2.0 * u_p_1 * t17 - 2.0 * u_p_0 * t18;
            Phi_x[4 * 8 + j] = tq_0 * t25 + tq_1 * t26 + tq_2 * t24 + tq_3 * t23; /* Phi_x(0,4) */
            Phi_x[5 * 8 + j] = tq_0 * t26 + tq_2 * t23 - tq_1 * t25 - tq_3 * t24; /* Phi_x(0,5) */
            Phi_x[6 * 8 + j] = tq_3 * t26 + tq_0 * t24 - tq_2 * t25 - tq_1 * t23; /* Phi_x(0,6) */
            Phi_x[7 * 8 + j] = tq_1 * t24 + tq_0 * t23 - tq_3 * t25 - tq_2 * t26; /* Phi_x(0,7) */
            const real t27 = t10 * u_q_3 + u_q_0 * t4 + u_q_2 * t7 + u_q_1 * t2;
            const real t28 = u_q_3 * t7 + u_q_1 * t4 - t10 * u_q_2 - u_q_0 * t2;
            const real t29 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            const real t30 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t31 = u_q_0 * t10 + u_q_1 * t7 - u_q_2 * t2 - u_q_3 * t4;
            const real t32 = 4.0 * (t29 * t5 + t30 * t11 + u_p_3 * t28 + u_p_2 * t27) + 2.0 * (ex_q_x * t8 + 2.0
                * u_p_1 * t31);
            const real t33 = tp_3 * t32;
            const real t34 = 4.0 * (t30 * t5 + u_p_3 * t27 - u_p_2 * t28 - t29 * t11) + 2.0 * (t6 * ex_q_x + 2.0
                * u_p_0 * t31);
            const real t35 = tp_2 * t34;
            const real t36 = 4.0 * (t30 * t8 + u_p_1 * t27 - u_p_0 * t28 - t6 * t29) - 2.0 * (2.0 * u_p_2 * t31
                + ex_q_x * t11);
            const real t37 = 2.0 * (ex_q_x * t5 + 2.0 * u_p_3 * t31) - 4.0 * (u_p_0 * t27 + u_p_1 * t28 + t6 * t30
                + t29 * t8);
            const real t38 = tp_0 * t36 - tp_1 * t37;
            Phi_x[8 * 8 + j] = t33 + t35 - t38; /* Phi_x(1,0) */
            const real t39 = tp_0 * t37 + tp_1 * t36;
            const real t40 = tp_2 * t32;
            const real t41 = tp_3 * t34;
            Phi_x[9 * 8 + j] = t39 + t40 - t41; /* Phi_x(1,1) */
            const real t42 = tp_3 * t37 + tp_2 * t36;
            const real t43 = tp_0 * t34;
            const real t44 = tp_1 * t32;
            Phi_x[10 * 8 + j] = t42 + t43 - t44; /* Phi_x(1,2) */
            const real t45 = tp_1 * t34;
            const real t46 = tp_3 * t36 - tp_2 * t37;
            const real t47 = tp_0 * t32;
            Phi_x[11 * 8 + j] = t46 + t47 + t45; /* Phi_x(1,3) */
            const real t48 = u_p_2 * u_p_3;
            const real t49 = u_p_0 * u_p_1;
            const real t50 = t48 - t49;
            const real t51 = u_p_3 * t11 + u_p_2 * t5;
            const real t52 = t6 * u_p_1 + u_p_0 * t8;
            const real t53 = t51 - t52;
            const real t54 = t6 * u_p_2 + u_p_0 * t11 + u_p_3 * t8 + u_p_1 * t5;
            const real t55 = u_p_0 * u_p_2 + u_p_1 * u_p_3;
            const real t56 = u_p_0 * u_p_0;
            const real t57 = u_p_3 * u_p_3;
            const real t58 = u_p_1 * u_p_1;
            const real t59 = u_p_2 * u_p_2;
            const real ez_p_z = t56 + t57 - t58 - t59;
            const real t60 = 2.0 * u_p_0 * t6;
            const real t61 = 2.0 * u_p_3 * t5;
            const real t62 = 2.0 * u_p_1 * t8;
            const real t63 = 2.0 * u_p_2 * t11;
            const real t64 = t60 + t61 - t62 - t63;
            const real t65 = 4.0 * (t10 * t50 + u_q_0 * t53 - u_q_3 * t54 - t55 * t4) + 2.0 * (ez_p_z * t7 + u_q_1
                * t64);
            const real t66 = 4.0 * (t50 * t7 + u_q_1 * t53 - u_q_2 * t54 - t55 * t2) - 2.0 * (u_q_0 * t64 + t10
                * ez_p_z);
            const real t67 = 4.0 * (t50 * t4 + t10 * t55 + u_q_3 * t53 + u_q_0 * t54) - 2.0 * (u_q_2 * t64 + ez_p_z
                * t2);
            const real t68 = 4.0 * (t50 * t2 + t55 * t7 + u_q_2 * t53 + u_q_1 * t54) + 2.0 * (ez_p_z * t4 + u_q_3
                * t64);
            Phi_x[12 * 8 + j] = tq_0 * t67 + tq_1 * t68 + tq_2 * t66 + tq_3 * t65; /* Phi_x(1,4) */
            Phi_x[13 * 8 + j] = tq_0 * t68 + tq_2 * t65 - tq_1 * t67 - tq_3 * t66; /* Phi_x(1,5) */
            Phi_x[14 * 8 + j] = tq_3 * t68 + tq_0 * t66 - tq_2 * t67 - tq_1 * t65; /* Phi_x(1,6) */
            Phi_x[15 * 8 + j] = tq_1 * t66 + tq_0 * t65 - tq_3 * t67 - tq_2 * t68; /* Phi_x(1,7) */
            Phi_x[16 * 8 + j] = t39 + t41 - t40; /* Phi_x(2,0) */
            Phi_x[17 * 8 + j] = t38 + t33 + t35; /* Phi_x(2,1) */
            Phi_x[18 * 8 + j] = t46 - t47 - t45; /* Phi_x(2,2) */
            Phi_x[19 * 8 + j] = t43 - t42 - t44; /* Phi_x(2,3) */
            const real t69 = u_p_1 * u_p_2 - u_p_0 * u_p_3;
            const real t70 = u_p_2 * t8 + u_p_1 * t11 - t6 * u_p_3 - u_p_0 * t5;
            const real t71 = t52 + t51;
            const real t72 = t49 + t48;
            const real t73 = t60 + t63 - t62 - t61;
            const real ey_p_y = t56 + t59 - t58 - t57;
            const real t74 = 4.0 * (t69 * t4 + u_q_3 * t70 - u_q_1 * t71 - t72 * t7) - 2.0 * (u_q_0 * t73 + t10
                * ey_p_y);
            const real t75 = 4.0 * (t72 * t2 + u_q_2 * t71 - u_q_0 * t70 - t10 * t69) - 2.0 * (u_q_3 * t73 + ey_p_y
                * t4);
            const real t76 = 4.0 * (t10 * t72 + t69 * t2 + u_q_0 * t71 + u_q_2 * t70) - 2.0 * (u_q_1 * t73 + ey_p_y
                * t7);
            const real t77 = 4.0 * (t72 * t4 + t69 * t7 + u_q_3 * t71 + u_q_1 * t70) + 2.0 * (ey_p_y * t2 + u_q_2
                * t73);
            Phi_x[20 * 8 + j] = tq_0 * t75 + tq_2 * t76 + tq_3 * t74 - tq_1 * t77; /* Phi_x(2,4) */
            Phi_x[21 * 8 + j] = tq_2 * t74 - tq_1 * t75 - tq_0 * t77 - tq_3 * t76; /* Phi_x(2,5) */
            Phi_x[22 * 8 + j] = tq_0 * t76 - tq_2 * t75 - tq_3 * t77 - tq_1 * t74; /* Phi_x(2,6) */
            Phi_x[23 * 8 + j] = tq_2 * t77 + tq_1 * t76 + tq_0 * t74 - tq_3 * t75; /* Phi_x(2,7) */
        }
    }
}

/* kinematics: 1443 operations.
 * in:  x (8), v (8), a (8), p (8)
 * out: Psi_x (3,8), Psi_v (3,8) */
FLEXEL_CLONES
static void hinge_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict a = in[2] + b * (8 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict Psi_x = out[0] + b * (24 * 8);
        real *restrict Psi_v = out[1] + b * (24 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_vl2 = v[6 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real q_vl0 = v[4 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real q_vl3 = v[7 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real q_vl1 = v[5 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real t0 = q_vl0 * tq_2 + q_vl3 * tq_1 + q_vl2 * tq_0 - q_vl1 * tq_3;
            const real p_l0 = x[0 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real p_l1 = x[1 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real p_l2 = x[2 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real p_l3 = x[3 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = p_l0 * tp_0 - p_l1 * tp_1 - p_l2 * tp_2 - p_l3 * tp_3;
            const real q_l1 = x[5 * 8 + j];
            const real q_l0 = x[4 * 8 + j];
            const real q_l2 = x[6 * 8 + j];
            const real q_l3 = x[7 * 8 + j];
            const real u_q_1 = q_l0 * tq_1 + q_l2 * tq_3 + q_l1 * tq_0 - q_l3 * tq_2;
            const real u_p_3 = p_l0 * tp_3 + p_l3 * tp_0 + p_l1 * tp_2 - p_l2 * tp_1;
            const real u_q_2 = q_l0 * tq_2 + q_l3 * tq_1 + q_l2 * tq_0 - q_l1 * tq_3;
            const real u_q_0 = q_l0 * tq_0 - q_l1 * tq_1 - q_l2 * tq_2 - q_l3 * tq_3;
            const real u_p_1 = p_l0 * tp_1 + p_l2 * tp_3 + p_l1 * tp_0 - p_l3 * tp_2;
            const real u_p_2 = p_l0 * tp_2 + p_l3 * tp_1 + p_l2 * tp_0 - p_l1 * tp_3;
            const real u_q_3 = q_l0 * tq_3 + q_l3 * tq_0 + q_l1 * tq_2 - q_l2 * tq_1;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_q_0 * u_p_1 - u_p_2 * u_q_3;
            const real c0 = u_p_3 * u_q_3 + u_p_2 * u_q_2 + u_p_0 * u_q_0 + u_p_1 * u_q_1;
            const real t1 = 1.0 / (c1 * c1 + c0 * c0);
            const real p_vl1 = v[1 * 8 + j];
            const real p_vl0 = v[0 * 8 + j];
            const real p_vl3 = v[3 * 8 + j];
            const real p_vl2 = v[2 * 8 + j];
            const real t2 = p_vl0 * tp_3 + p_vl3 * tp_0 + p_vl1 * tp_2 - p_vl2 * tp_1;
            const real t3 = p_vl0 * tp_0 - p_vl1 * tp_1 - p_vl2 * tp_2 - p_vl3 * tp_3;
            const real t4 = q_vl0 * tq_1 + q_vl2 * tq_3 + q_vl1 * tq_0 - q_vl3 * tq_2;
            const real t5 = p_vl0 * tp_1 + p_vl2 * tp_3 + p_vl1 * tp_0 - p_vl3 * tp_2;
            const real t6 = t3 * u_q_1 + u_p_0 * t4 + u_q_2 * t2 + u_p_3 * t0 - u_q_0 * t5;
            const real t7 = q_vl0 * tq_0 - q_vl1 * tq_1 - q_vl2 * tq_2 - q_vl3 * tq_3;
            const real t8 = p_vl0 * tp_2 + p_vl3 * tp_1 + p_vl2 * tp_0 - p_vl1 * tp_3;
            const real t9 = q_vl0 * tq_3 + q_vl3 * tq_0 + q_vl1 * tq_2 - q_vl2 * tq_1;
            const real t10 = t6 - t7 * u_p_1 - u_q_3 * t8 - u_p_2 * t9;
            const real t11 = t1 * t10;
            const real t12 = 2.0 * t11;
            const real t13 = u_q_3 * t2 + u_p_3 * t9 + u_q_2 * t8 + u_p_2 * t0 + u_q_0 * t3;
            const real t14 = u_p_0 * t7 + t13 + u_q_1 * t5 + u_p_1 * t4;
            const real t15 = c1 * t10 + c0 * t14;
            const real t16 = t1 * t1;
            const real t17 = t15 * t16;
            const real t18 = c0 * t10 - c1 * t14;
            const real t19 = c0 * t16;
            const real t20 = 4.0 * t18 * t19;
            const real t21 = t12 - 2.0 * (t11 - 2.0 * c1 * t17) - t20;
            const real q_al2 = a[6 * 8 + j];
            const real q_al0 = a[4 * 8 + j];
            const real q_al3 = a[7 * 8 + j];
            const real q_al1 = a[5 * 8 + j];
            const real t22 = tq_2 * q_al0 + tq_1 * q_al3 + tq_0 * q_al2 - tq_3 * q_al1;
            const real p_al1 = a[1 * 8 + j];
            const real p_al0 = a[0 * 8 + j];
            const real p_al3 = a[3 * 8 + j];
            const real p_al2 = a[2 * 8 + j];
            const real t23 = tp_3 * p_al0 + tp_0 * p_al3 + tp_2 * p_al1 - tp_1 * p_al2;
            const real t24 = tp_0 * p_al0 - tp_1 * p_al1 - tp_2 * p_al2 - tp_3 * p_al3;
            const real t25 = tq_1 * q_al0 + tq_3 * q_al2 + tq_0 * q_al1 - tq_2 * q_al3;
            const real t26 = u_q_1 * t24 + u_p_0 * t25 + u_q_2 * t23 + u_p_3 * t22 + 2.0 * (t3 * t4 + t2 * t0 - t7
                * t5 - t8 * t9);
            const real t27 = tp_1 * p_al0 + tp_3 * p_al2 + tp_0 * p_al1 - tp_2 * p_al3;
            const real t28 = tq_0 * q_al0 - tq_1 * q_al1 - tq_2 * q_al2 - tq_3 * q_al3;
            const real t29 = tp_2 * p_al0 + tp_1 * p_al3 + tp_0 * p_al2 - tp_3 * p_al1;
            const real t30 = tq_3 * q_al0 + tq_0 * q_al3 + tq_2 * q_al1 - tq_1 * q_al2;
            const real t31 = t26 - u_q_0 * t27 - u_p_1 * t28 - u_q_3 * t29 - u_p_2 * t30;
            const real t32 = u_q_3 * t23 + u_p_3 * t30 + u_q_2 * t29 + u_p_2 * t22 + u_q_0 * t24;
            const real t33 = u_p_0 * t28 + t32 + u_q_1 * t27 + u_p_1 * t25 + 2.0 * (t2 * t9 + t8 * t0 + t3 * t7 + t5
                * t4);
            const real t34 = c0 * t31 - c1 * t33;
            const real t35 = t1 * t15;
            const real t36 = t1 * t31 - 2.0 * (t10 * t17 + t19 * t34) - t18 * (2.0 * t14 * t16 - 8.0 * t35 * t19);
            const real t37 = c0 * t1;
            const real t38 = c1 * t1;
            const real t39 = c1 * t16;
            const real t40 = 2.0 * (t14 * t17 - t39 * t34) - t1 * t33 - t18 * (2.0 * t10 * t16 - 8.0 * t35 * t39);
            const real t41 = 2.0 * (u_q_2 * t36 - (t37 * t30 + t38 * t22) - u_q_3 * t40);
            const real t42 = t1 * t14;
            const real t43 = 2.0 * t42;
            const real t44 = 4.0 * t18 * t39;
            const real t45 = 2.0 * (t42 - 2.0 * c0 * t17) - t43 - t44;
            const real t46 = t0 * t21 + t41 - t9 * t45;
            const real t47 = 2.0 * (t37 * t22 - t38 * t30 + u_q_2 * t40 + u_q_3 * t36);
            const real t48 = t9 * t21 + t47 + t0 * t45;
            const real t49 = 2.0 * (u_q_1 * t36 - (t37 * t28 + t38 * t25) - u_q_0 * t40);
            const real t50 = t4 * t21 + t49 - t7 * t45;
            const real t51 = 2.0 * (t37 * t25 - t38 * t28 + u_q_1 * t40 + u_q_0 * t36);
            const real t52 = t7 * t21 + t51 + t4 * t45;
            Psi_x[0 * 8 + j] = tp_1 * t50 + tp_0 * t52 + tp_3 * t48 + tp_2 * t46; /* Psi_x(0,0) */
            Psi_x[1 * 8 + j] = tp_0 * t50 + tp_2 * t48 - tp_1 * t52 - tp_3 * t46; /* Psi_x(0,1) */
            Psi_x[2 * 8 + j] = tp_3 * t50 + tp_0 * t46 - tp_2 * t52 - tp_1 * t48; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = tp_1 * t46 + tp_0 * t48 - tp_3 * t52 - tp_2 * t50; /* Psi_x(0,3) */
            const real t53 = 2.0 * (t37 * t23 - t38 * t29 + u_p_3 * t40 + u_p_2 * t36);
            const real t54 = t8 * t21 + t53 + t2 * t45;
            const real t55 = 2.0 * (u_p_3 * t36 - (t37 * t29 + t38 * t23) - u_p_2 * t40);
            const real t56 = t2 * t21 + t55 - t8 * t45;
            const real t57 = 2.0 * (t37 * t24 - t38 * t27 + u_p_0 * t40 + u_p_1 * t36);
            const real t58 = t5 * t21 + t57 + t3 * t45;
            const real t59 = 2.0 * (u_p_0 * t36 - (t37 * t27 + t38 * t24) - u_p_1 * t40);
            const real t60 = t3 * t21 + t59 - t5 * t45;
            Psi_x[4 * 8 + j] = tq_1 * t58 + tq_0 * t60 + tq_3 * t56 + tq_2 * t54; /* Psi_x(0,4) */
            Psi_x[5 * 8 + j] = tq_0 * t58 + tq_2 * t56 - tq_1 * t60 - tq_3 * t54; /* Psi_x(0,5) */
            Psi_x[6 * 8 + j] = tq_3 * t58 + tq_0 * t54 - tq_2 * t60 - tq_1 * t56; /* Psi_x(0,6) */
            Psi_x[7 * 8 + j] = tq_1 * t54 + tq_0 * t56 - tq_3 * t60 - tq_2 * t58; /* Psi_x(0,7) */
            const real t61 = u_q_3 * t25 + u_q_1 * t30 + 2.0 * (t4 * t9 - t7 * t0) - u_q_2 * t28;
            const real t62 = t61 - u_q_0 * t22;
            const real t63 = 4.0 * u_p_3 * t62;
            const real t64 = u_q_3 * t28 + u_q_0 * t30 + u_q_2 * t25 + u_q_1 * t22 + 2.0 * (t7 * t9 + t4 * t0);
            const real t65 = 4.0 * u_p_2 * t64;
            const real t66 = u_q_0 * t7 + u_q_1 * t4 - u_q_2 * t0 - u_q_3 * t9;
            const real t67 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real t68 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            const real t69 = u_q_3 * t4 + u_q_1 * t9 - t7 * u_q_2 - u_q_0 * t0;
            const real t70 = t7 * u_q_3 + u_q_0 * t9 + u_q_2 * t4 + u_q_1 * t0;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t71 = t7 * t7 + t4 * t4 + u_q_0 * t28 + u_q_1 * t25 - t0 * t0 - t9 * t9;
            const real t72 = t71 - u_q_2 * t22 - u_q_3 * t30;
            const real t73 = 8.0 * (t2 * t69 + t8 * t70) + 2.0 * (ex_q_x * t27 + 2.0 * u_p_1 * t72);
            const real t74 = 4.0 * (t67 * t29 + t68 * t23 + 2.0 * t5 * t66) + t73;
            const real t75 = t65 + t74 + t63;
            const real t76 = t67 * t23 + 2.0 * t3 * t66 + u_p_3 * t64 - t68 * t29 - u_p_2 * t62;
            const real t77 = 8.0 * (t2 * t70 - t8 * t69) + 4.0 * t76 + 2.0 * (ex_q_x * t24 + 2.0 * u_p_0 * t72);
            const real t78 = tp_2 * t77;
            const real t79 = 2.0 * t2 * t66 - t67 * t24 - t68 * t27 - u_p_0 * t64 - u_p_1 * t62;
            const real t80 = 4.0 * t79 + 2.0 * (ex_q_x * t23 + 2.0 * u_p_3 * t72) - 8.0 * (t3 * t70 + t5 * t69);
            const real t81 = tp_1 * t80;
            const real t82 = 8.0 * (t3 * t69 - t5 * t70) + 2.0 * (ex_q_x * t29 + 2.0 * u_p_2 * t72);
            const real t83 = 4.0 * (t68 * t24 + 2.0 * t8 * t66 - t67 * t27) + t82;
            const real t84 = 4.0 * u_p_0 * t62;
            const real t85 = 4.0 * u_p_1 * t64;
            const real t86 = t83 + t84 - t85;
            Psi_x[8 * 8 + j] = t81 + tp_0 * t86 + t78 + tp_3 * t75; /* Psi_x(1,0) */
            const real t87 = tp_0 * t80;
            const real t88 = tp_3 * t77;
            Psi_x[9 * 8 + j] = t87 + tp_2 * t75 - tp_1 * t86 - t88; /* Psi_x(1,1) */
            const real t89 = tp_0 * t77;
            const real t90 = tp_3 * t80;
            Psi_x[10 * 8 + j] = t89 + t90 - tp_2 * t86 - tp_1 * t75; /* Psi_x(1,2) */
            const real t91 = tp_1 * t77;
            const real t92 = tp_2 * t80;
            Psi_x[11 * 8 + j] = t91 + tp_0 * t75 - tp_3 * t86 - t92; /* Psi_x(1,3) */
            const real t93 = u_p_3 * t8 + u_p_2 * t2;
            const real t94 = t3 * u_p_1 + u_p_0 * t5;
            const real t95 = t93 - t94;
            const real t96 = t3 * u_p_2 + u_p_0 * t8 + u_p_3 * t5 + u_p_1 * t2;
            const real t97 = u_p_2 * u_p_3;
            const real t98 = u_p_0 * u_p_1;
            const real t99 = t97 - t98;
            const real t100 = 2.0 * t8 * t2;
            const real t101 = u_p_3 * t29 + u_p_2 * t23;
            const real t102 = 2.0 * t3 * t5;
            const real t103 = u_p_1 * t24 + u_p_0 * t27;
            const real t104 = t100 + t101 - t102 - t103;
            const real t105 = u_p_0 * u_p_2 + u_p_1 * u_p_3;
            const real t106 = 2.0 * u_p_0 * t3;
            const real t107 = 2.0 * u_p_3 * t2;
            const real t108 = 2.0 * u_p_1 * t5;
            const real t109 = 2.0 * u_p_2 * t8;
            const real t110 = t106 + t107 - t108 - t109;
            const real t111 = 4.0 * (t99 * t25 + u_q_1 * t104 - t105 * t22 - t7 * t110);
            const real t112 = u_p_2 * t24 + u_p_0 * t29 + u_p_3 * t27 + u_p_1 * t23 + 2.0 * (t3 * t8 + t5 * t2);
            const real t113 = u_p_0 * u_p_0;
            const real t114 = u_p_3 * u_p_3;
            const real t115 = u_p_1 * u_p_1;
            const real t116 = u_p_2 * u_p_2;
            const real ez_p_z = t113 + t114 - t115 - t116;
            const real t117 = 2.0 * u_p_0 * t24;
            const real t118 = 2.0 * t2 * t2;
            const real t119 = 2.0 * t3 * t3;
            const real t120 = 2.0 * u_p_3 * t23;
            const real t121 = 2.0 * t5 * t5;
            const real t122 = 2.0 * t8 * t8;
            const real t123 = 2.0 * u_p_1 * t27;
            const real t124 = 2.0 * u_p_2 * t29;
            const real t125 = t119 + t120 + t118 + t117 - t121 - t122 - t123 - t124;
            const real t126 = 8.0 * (t4 * t95 - t0 * t96) + t111 - 2.0 * (2.0 * u_q_2 * t112 + ez_p_z * t28 + u_q_0
                * t125);
            const real t127 = 4.0 * (t99 * t28 + t4 * t110 + u_q_0 * t104 - t105 * t30);
            const real t128 = 8.0 * (t7 * t95 - t9 * t96) + 2.0 * (ez_p_z * t25 + u_q_1 * t125 - 2.0 * u_q_3 * t112);
            const real t129 = t127 + t128;
            const real t130 = 4.0 * (t99 * t22 + t9 * t110 + t105 * t25 + u_q_2 * t104);
            const real t131 = 8.0 * (t0 * t95 + t4 * t96) + 2.0 * (ez_p_z * t30 + 2.0 * u_q_1 * t112 + u_q_3 * t125);
            const real t132 = t130 + t131;
            const real t133 = 4.0 * (t99 * t30 + t105 * t28 + u_q_3 * t104 - t0 * t110);
            const real t134 = 8.0 * (t9 * t95 + t7 * t96) + 2.0 * (2.0 * u_q_0 * t112 - ez_p_z * t22 - u_q_2 * t125);
            const real t135 = t133 + t134;
            Psi_x[12 * 8 + j] = tq_1 * t132 + tq_0 * t135 + tq_3 * t129 + tq_2 * t126; /* Psi_x(1,4) */
            Psi_x[13 * 8 + j] = tq_0 * t132 + tq_2 * t129 - tq_1 * t135 - tq_3 * t126; /* Psi_x(1,5) */
            Psi_x[14 * 8 + j] = tq_3 * t132 + tq_0 * t126 - tq_2 * t135 - tq_1 * t129; /* Psi_x(1,6) */
            Psi_x[15 * 8 + j] = tq_1 * t126 + tq_0 * t129 - tq_3 * t135 - tq_2 * t132; /* Psi_x(1,7) */
            const real t136 = t85 - t83 - t84;
            const real t137 = t74 + t63 + t65;
            Psi_x[16 * 8 + j] = t87 + tp_1 * t136 + t88 - tp_2 * t137; /* Psi_x(2,0) */
            Psi_x[17 * 8 + j] = t78 + tp_3 * t137 + tp_0 * t136 - t81; /* Psi_x(2,1) */
            Psi_x[18 * 8 + j] = tp_3 * t136 - t92 - tp_0 * t137 - t91; /* Psi_x(2,2) */
            Psi_x[19 * 8 + j] = t89 - t90 - tp_2 * t136 - tp_1 * t137; /* Psi_x(2,3) */
            const real t138 = t94 + t93;
            const real t139 = u_p_2 * t5 + u_p_1 * t8 - t3 * u_p_3 - u_p_0 * t2;
            const real t140 = t98 + t97;
            const real t141 = t102 + t101 + t100 + t103;
            const real t142 = u_p_1 * u_p_2 - u_p_0 * u_p_3;
            const real t143 = t106 + t109 - t108 - t107;
            const real t144 = 4.0 * (t140 * t22 + u_q_2 * t141 - t142 * t28 - t9 * t143);
            const real t145 = t119 + t124 + t122 + t117 - t121 - t118 - t123 - t120;
            const real ey_p_y = t113 + t116 - t115 - t114;
            const real t146 = u_p_2 * t27 + u_p_1 * t29 + 2.0 * (t5 * t8 - t3 * t2) - u_p_3 * t24;
            const real t147 = t146 - u_p_0 * t23;
            const real t148 = 8.0 * (t0 * t138 - t7 * t139) + t144 - 2.0 * (ey_p_y * t30 + 2.0 * u_q_0 * t147 + u_q_3
                * t145);
            const real t149 = 4.0 * (t140 * t28 + t142 * t22 + u_q_0 * t141 - t4 * t143);
            const real t150 = 8.0 * (t7 * t138 + t0 * t139) + 2.0 * (2.0 * u_q_2 * t147 - ey_p_y * t25 - u_q_1
                * t145);
            const real t151 = t149 + t150;
            const real t152 = 4.0 * (t142 * t30 - t7 * t143 - t140 * t25 - u_q_1 * t141);
            const real t153 = 8.0 * (t9 * t139 - t4 * t138) + 2.0 * (2.0 * u_q_3 * t147 - ey_p_y * t28 - u_q_0
                * t145);
            const real t154 = t152 + t153;
            const real t155 = 4.0 * (t140 * t30 + t0 * t143 + t142 * t25 + u_q_3 * t141);
            const real t156 = 8.0 * (t9 * t138 + t4 * t139) + 2.0 * (ey_p_y * t22 + 2.0 * u_q_1 * t147 + u_q_2
                * t145);
            const real t157 = t155 + t156;
            Psi_x[20 * 8 + j] = tq_2 * t151 + tq_3 * t154 + tq_0 * t148 - tq_1 * t157; /* Psi_x(2,4) */
            Psi_x[21 * 8 + j] = tq_2 * t154 - tq_1 * t148 - tq_0 * t157 - tq_3 * t151; /* Psi_x(2,5) */
            Psi_x[22 * 8 + j] = tq_0 * t151 - tq_2 * t148 - tq_3 * t157 - tq_1 * t154; /* Psi_x(2,6) */
            Psi_x[23 * 8 + j] = tq_1 * t151 + tq_0 * t154 + tq_2 * t157 - tq_3 * t148; /* Psi_x(2,7) */
            const real t158 = t12 - t20;
            const real t159 = t43 + t44;
            const real t160 = u_q_2 * t158 + u_q_3 * t159 - 2.0 * (t38 * t0 + t37 * t9);
            const real t161 = 2.0 * (t37 * t0 - t38 * t9) + u_q_3 * t158 - u_q_2 * t159;
            const real t162 = 2.0 * (t37 * t4 - t7 * t38) + u_q_0 * t158 - u_q_1 * t159;
            const real t163 = u_q_1 * t158 + u_q_0 * t159 - 2.0 * (t38 * t4 + t7 * t37);
            Psi_v[0 * 8 + j] = 2.0 * (tp_0 * t162 + tp_1 * t163 + tp_3 * t161 + tp_2 * t160); /* Psi_v(0,0) */
            Psi_v[1 * 8 + j] = 2.0 * (tp_0 * t163 + tp_2 * t161 - tp_1 * t162 - tp_3 * t160); /* Psi_v(0,1) */
            Psi_v[2 * 8 + j] = 2.0 * (tp_3 * t163 + tp_0 * t160 - tp_2 * t162 - tp_1 * t161); /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = 2.0 * (tp_1 * t160 + tp_0 * t161 - tp_3 * t162 - tp_2 * t163); /* Psi_v(0,3) */
            const real t164 = 2.0 * (t37 * t2 - t38 * t8) + u_p_2 * t158 - u_p_3 * t159;
            const real t165 = u_p_3 * t158 + u_p_2 * t159 - 2.0 * (t38 * t2 + t37 * t8);
            const real t166 = u_p_0 * t158 + u_p_1 * t159 - 2.0 * (t3 * t38 + t37 * t5);
            const real t167 = 2.0 * (t3 * t37 - t38 * t5) + u_p_1 * t158 - u_p_0 * t159;
            Psi_v[4 * 8 + j] = 2.0 * (tq_0 * t166 + tq_1 * t167 + tq_3 * t165 + tq_2 * t164); /* Psi_v(0,4) */
            Psi_v[5 * 8 + j] = 2.0 * (tq_0 * t167 + tq_2 * t165 - tq_1 * t166 - tq_3 * t164); /* Psi_v(0,5) */
            Psi_v[6 * 8 + j] = 2.0 * (tq_3 * t167 + tq_0 * t164 - tq_2 * t166 - tq_1 * t165); /* Psi_v(0,6) */
            Psi_v[7 * 8 + j] = 2.0 * (tq_1 * t164 + tq_0 * t165 - tq_3 * t166 - tq_2 * t167); /* Psi_v(0,7) */
            const real t168 = 4.0 * (t67 * t2 + u_p_3 * t70 - u_p_2 * t69 - t68 * t8) + 2.0 * (t3 * ex_q_x + 2.0
                * u_p_0 * t66);
            const real t169 = tp_2 * t168;
            const real t170 = 2.0 * (ex_q_x * t5 + 2.0 * u_p_1 * t66) + 4.0 * (t68 * t2 + t67 * t8 + u_p_2 * t70
                + u_p_3 * t69);
            const real t171 = tp_3 * t170;
            const real t172 = 4.0 * (t67 * t5 + u_p_1 * t70 - u_p_0 * t69 - t3 * t68) - 2.0 * (2.0 * u_p_2 * t66
                + ex_q_x * t8);
            const real t173 = 2.0 * (ex_q_x * t2 + 2.0 * u_p_3 * t66) - 4.0 * (u_p_0 * t70 + u_p_1 * t69 + t3 * t67
                + t68 * t5);
            const real t174 = tp_0 * t172 - tp_1 * t173;
            Psi_v[8 * 8 + j] = 2.0 * (t169 + t171 - t174); /* Psi_v(1,0) */
            const real t175 = tp_0 * t173 + tp_1 * t172;
            const real t176 = tp_2 * t170;
            const real t177 = tp_3 * t168;
            Psi_v[9 * 8 + j] = 2.0 * (t175 + t176 - t177); /* Psi_v(1,1) */
            const real t178 = tp_3 * t173 + tp_2 * t172;
            const real t179 = tp_0 * t168;
            const real t180 = tp_1 * t170;
            Psi_v[10 * 8 + j] = 2.0 * (t178 + t179 - t180); /* Psi_v(1,2) */
            const real t181 = tp_1 * t168;
            const real t182 = tp_3 * t172 - tp_2 * t173;
            const real t183 = tp_0 * t170;
            Psi_v[11 * 8 + j] = 2.0 * (t182 + t183 + t181); /* Psi_v(1,3) */
            const real t184 = 4.0 * (t99 * t4 + u_q_1 * t95 - u_q_2 * t96 - t105 * t0) - 2.0 * (u_q_0 * t110 + t7
                * ez_p_z);
            const real t185 = 4.0 * (t7 * t99 + u_q_0 * t95 - u_q_3 * t96 - t105 * t9) + 2.0 * (ez_p_z * t4 + u_q_1
                * t110);
            const real t186 = 4.0 * (t99 * t9 + t7 * t105 + u_q_3 * t95 + u_q_0 * t96) - 2.0 * (u_q_2 * t110 + ez_p_z
                * t0);
            const real t187 = 4.0 * (t99 * t0 + t105 * t4 + u_q_2 * t95 + u_q_1 * t96) + 2.0 * (ez_p_z * t9 + u_q_3
                * t110);
            Psi_v[12 * 8 + j] = 2.0 * (tq_0 * t186 + tq_1 * t187 + tq_3 * t185 + tq_2 * t184); /* Psi_v(1,4) */
            Psi_v[13 * 8 + j] = 2.0 * (tq_0 * t187 + tq_2 * t185 - tq_1 * t186 - tq_3 * t184); /* Psi_v(1,5) */
            Psi_v[14 * 8 + j] = 2.0 * (tq_3 * t187 + tq_0 * t184 - tq_2 * t186 - tq_1 * t185); /* Psi_v(1,6) */
            Psi_v[15 * 8 + j] = 2.0 * (tq_1 * t184 + tq_0 * t185 - tq_3 * t186 - tq_2 * t187); /* Psi_v(1,7) */
            Psi_v[16 * 8 + j] = 2.0 * (t175 + t177 - t176); /* Psi_v(2,0) */
            Psi_v[17 * 8 + j] = 2.0 * (t174 + t171 + t169); /* Psi_v(2,1) */
            Psi_v[18 * 8 + j] = 2.0 * (t182 - t183 - t181); /* Psi_v(2,2) */
            Psi_v[19 * 8 + j] = 2.0 * (t179 - t178 - t180); /* Psi_v(2,3) */
            const real t188 = 4.0 * (t140 * t0 + u_q_2 * t138 - u_q_0 * t139 - t7 * t142);
            const real t189 = t188 - 2.0 * (u_q_3 * t143 + ey_p_y * t9);
            const real t190 = 4.0 * (t7 * t140 + t142 * t0 + u_q_0 * t138 + u_q_2 * t139);
            const real t191 = t190 - 2.0 * (u_q_1 * t143 + ey_p_y * t4);
            const real t192 = 4.0 * (t142 * t9 + u_q_3 * t139 - u_q_1 * t138 - t140 * t4);
            const real t193 = t192 - 2.0 * (u_q_0 * t143 + t7 * ey_p_y);
            const real t194 = 4.0 * (t140 * t9 + t142 * t4 + u_q_3 * t138 + u_q_1 * t139);
            const real t195 = t194 + 2.0 * (ey_p_y * t0 + u_q_2 * t143);
            Psi_v[20 * 8 + j] = 2.0 * (tq_2 * t191 + tq_3 * t193 + tq_0 * t189 - tq_1 * t195); /* Psi_v(2,4) */
            Psi_v[21 * 8 + j] = 2.0 * (tq_2 * t193 - tq_1 * t189 - tq_0 * t195 - tq_3 * t191); /* Psi_v(2,5) */
            Psi_v[22 * 8 + j] = 2.0 * (tq_0 * t191 - tq_2 * t189 - tq_3 * t195 - tq_1 * t193); /* Psi_v(2,6) */
            Psi_v[23 * 8 + j] = 2.0 * (tq_1 * t191 + tq_0 * t193 + tq_2 * t195 - tq_3 * t189); /* Psi_v(2,7) */
        }
    }
}

/* stiffness: 1035 operations.
 * in:  x (8), sigma (3), tau (0), p (8)
 * out: K (8,8) */
FLEXEL_CLONES
static void hinge_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict K = out[0] + b * (64 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_l0 = x[4 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real q_l1 = x[5 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real q_l2 = x[6 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real q_l3 = x[7 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real u_q_0 = q_l0 * tq_0 - q_l1 * tq_1 - q_l2 * tq_2 - q_l3 * tq_3;
            const real u_q_1 = q_l0 * tq_1 + q_l2 * tq_3 + q_l1 * tq_0 - q_l3 * tq_2;
            const real u_q_2 = q_l0 * tq_2 + q_l3 * tq_1 + q_l2 * tq_0 - q_l1 * tq_3;
            const real u_q_3 = q_l0 * tq_3 + q_l3 * tq_0 + q_l1 * tq_2 - q_l2 * tq_1;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real sigma_bend2 = sigma[2 * 8 + j];
            const real t0 = 2.0 * sigma_bend2 * ex_q_x;
            const real p_l0 = x[0 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real p_l1 = x[1 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real p_l2 = x[2 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real p_l3 = x[3 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = p_l0 * tp_0 - p_l1 * tp_1 - p_l2 * tp_2 - p_l3 * tp_3;
            const real u_p_3 = p_l0 * tp_3 + p_l3 * tp_0 + p_l1 * tp_2 - p_l2 * tp_1;
            const real u_p_1 = p_l0 * tp_1 + p_l2 * tp_3 + p_l1 * tp_0 - p_l3 * tp_2;
            const real u_p_2 = p_l0 * tp_2 + p_l3 * tp_1 + p_l2 * tp_0 - p_l1 * tp_3;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_q_0 * u_p_1 - u_p_2 * u_q_3;
            const real c0 = u_p_3 * u_q_3 + u_p_2 * u_q_2 + u_p_0 * u_q_0 + u_p_1 * u_q_1;
            const real t1 = 1.0 / (c1 * c1 + c0 * c0);
            const real sigma_angle = sigma[0 * 8 + j];
            const real t2 = sigma_angle * t1;
            const real t3 = t1 * t1;
            const real t4 = c0 * t3;
            const real t5 = sigma_angle * c0;
            const real t6 = t2 - 2.0 * t4 * t5;
            const real t7 = c1 * t3;
            const real t8 = t7 * t5;
            const real t9 = u_q_0 * t6 - 2.0 * u_q_1 * t8;
            const real t10 = sigma_angle * c1;
            const real t11 = t2 - 2.0 * t7 * t10;
            const real t12 = t4 * t10;
            const real t13 = u_q_1 * t11 - 2.0 * u_q_0 * t12;
            const real t14 = t0 + 2.0 * (u_q_2 * t9 - u_q_3 * t13);
            const real t15 = tp_3 * t14;
            const real sigma_bend1 = sigma[1 * 8 + j];
            const real t16 = 2.0 * sigma_bend1 * ex_q_x;
            const real t17 = t16 - 2.0 * (u_q_3 * t9 + u_q_2 * t13);
            const real t18 = tp_2 * t17;
            const real t19 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real t20 = 2.0 * sigma_bend2 * t19;
            const real t21 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            const real t22 = 2.0 * sigma_bend1 * t21;
            const real t23 = 2.0 * (t20 - t22);
            const real t24 = 2.0 * (u_q_1 * t9 - u_q_0 * t13) - t23;
            const real t25 = 4.0 * sigma_bend2 * t21;
            const real t26 = 4.0 * sigma_bend1 * t19;
            const real t27 = t25 + t26 + 2.0 * (u_q_0 * t9 + u_q_1 * t13);
            const real t28 = tp_1 * t27;
            const real t29 = u_q_1 * t6 + 2.0 * u_q_0 * t8;
            const real t30 = 2.0 * u_q_1 * t12 + u_q_0 * t11;
            const real t31 = t16 + 2.0 * (u_q_2 * t29 + u_q_3 * t30);
            const real t32 = tp_1 * t31;
            const real t33 = tp_0 * t14;
            const real t34 = u_q_2 * t6 + 2.0 * u_q_3 * t8;
            const real t35 = 2.0 * u_q_2 * t12 + u_q_3 * t11;
            const real t36 = t26 + 2.0 * (u_q_2 * t34 + u_q_3 * t35) - t25;
            const real t37 = tp_2 * t36;
            const real t38 = 2.0 * (t20 + t22);
            const real t39 = u_q_3 * t6 - 2.0 * u_q_2 * t8;
            const real t40 = u_q_2 * t11 - 2.0 * u_q_3 * t12;
            const real t41 = t38 + 2.0 * (u_q_2 * t39 - u_q_3 * t40);
            const real t42 = 2.0 * (u_q_2 * t30 - u_q_3 * t29) - t0;
            const real t43 = tp_1 * t42;
            const real t44 = tp_0 * t17;
            const real t45 = tp_3 * t36;
            const real t46 = 2.0 * (u_q_2 * t35 - u_q_3 * t34) - t38;
            const real t47 = tp_3 * (t37 + tp_3 * t41 + t33 + t32) + tp_2 * (t45 + tp_2 * t46 + t44 + t43);
            const real t48 = tp_3 * t31;
            const real t49 = tp_2 * t42;
            const real t50 = t23 + 2.0 * (u_q_1 * t30 - u_q_0 * t29);
            const real t51 = tp_0 * t27;
            K[0 * 8 + j] = t47 + tp_1 * (t49 + tp_1 * t50 + t48 - t51) + tp_0 * (t18 + tp_0 * t24 + t15 - t28);
                /* K(0,0) */
            const real t52 = tp_2 * t14;
            const real t53 = tp_3 * t17;
            const real t54 = t52 - tp_1 * t24 - t51 - t53;
            const real t55 = tp_0 * t31;
            const real t56 = tp_1 * t14;
            const real t57 = t55 + tp_2 * t41 - t56 - t45;
            const real t58 = tp_0 * t42;
            const real t59 = tp_1 * t17;
            const real t60 = t58 + t37 - t59 - tp_3 * t46;
            const real t61 = tp_2 * t31;
            const real t62 = tp_3 * t42;
            const real t63 = t61 + t28 + tp_0 * t50 - t62;
            K[1 * 8 + j] = K[8 * 8 + j] = tp_3 * t57 + tp_2 * t60 + tp_1 * t63 + tp_0 * t54; /* K(0,1) K(1,0) */
            const real t64 = tp_3 * t27;
            const real t65 = t44 - tp_2 * t24 - t64 - t56;
            const real t66 = tp_0 * t36;
            const real t67 = t48 + t66 - t52 - tp_1 * t41;
            const real t68 = tp_1 * t36;
            const real t69 = t62 + tp_0 * t46 - t18 - t68;
            const real t70 = tp_2 * t27;
            const real t71 = t58 + t70 + tp_3 * t50 - t32;
            K[2 * 8 + j] = K[16 * 8 + j] = tp_3 * t67 + tp_2 * t69 + tp_1 * t71 + tp_0 * t65; /* K(0,2) K(2,0) */
            const real t72 = t33 + t70 + t59 - tp_3 * t24;
            const real t73 = t68 + tp_0 * t41 - t15 - t61;
            const real t74 = t66 + tp_1 * t46 - t53 - t49;
            const real t75 = t55 + t64 + t43 - tp_2 * t50;
            K[3 * 8 + j] = K[24 * 8 + j] = tp_3 * t73 + tp_2 * t74 + tp_1 * t75 + tp_0 * t72; /* K(0,3) K(3,0) */
            const real t76 = sigma_bend2 * u_p_3 + sigma_bend1 * u_p_2;
            const real t77 = u_q_0 * t76;
            const real t78 = u_p_0 * sigma_bend2 + sigma_bend1 * u_p_1;
            const real t79 = u_q_3 * t78;
            const real t80 = 4.0 * t79;
            const real t81 = 2.0 * t1 * t10;
            const real t82 = u_p_0 * sigma_bend1 - sigma_bend2 * u_p_1;
            const real t83 = u_q_2 * t82;
            const real t84 = 4.0 * t83;
            const real t85 = 2.0 * (2.0 * t77 - u_p_1 * t9 - u_p_0 * t13) - t80 - t81 - t84;
            const real t86 = u_q_3 * t82;
            const real t87 = 4.0 * t86;
            const real t88 = 2.0 * t1 * t5;
            const real t89 = u_q_1 * t76;
            const real t90 = u_q_2 * t78;
            const real t91 = 4.0 * t90;
            const real t92 = t88 + 2.0 * (2.0 * t89 + u_p_0 * t9 - u_p_1 * t13) + t87 - t91;
            const real t93 = u_q_2 * t76;
            const real t94 = u_q_0 * t82;
            const real t95 = u_q_1 * t78;
            const real t96 = 4.0 * (t94 + t95);
            const real t97 = 2.0 * (u_p_3 * t9 - 2.0 * t93 - u_p_2 * t13) - t96;
            const real t98 = u_q_1 * t82;
            const real t99 = u_q_0 * t78;
            const real t100 = 4.0 * (t98 - t99);
            const real t101 = u_q_3 * t76;
            const real t102 = t100 - 2.0 * (u_p_2 * t9 + u_p_3 * t13 + 2.0 * t101);
            const real t103 = tq_2 * t97 + tq_3 * t102 + tq_1 * t92 + tq_0 * t85;
            const real t104 = sigma_bend1 * u_p_3 - sigma_bend2 * u_p_2;
            const real t105 = u_q_0 * t104;
            const real t106 = t91 + 2.0 * (2.0 * t105 + u_p_0 * t30 - u_p_1 * t29) - t88;
            const real t107 = t106 - t87;
            const real t108 = u_q_1 * t104;
            const real t109 = 2.0 * (u_p_0 * t29 + u_p_1 * t30 + 2.0 * t108) - t84 - t81;
            const real t110 = t109 - t80;
            const real t111 = u_q_2 * t104;
            const real t112 = 2.0 * (u_p_3 * t29 + u_p_2 * t30 - 2.0 * t111) - t100;
            const real t113 = u_q_3 * t104;
            const real t114 = 2.0 * (u_p_3 * t30 - 2.0 * t113 - u_p_2 * t29) - t96;
            const real t115 = tq_2 * t112 + tq_3 * t114 + tq_1 * t110 + tq_0 * t107;
            const real t116 = 4.0 * (t93 + t113);
            const real t117 = 2.0 * (2.0 * t94 + u_p_0 * t35 - u_p_1 * t34) + t116;
            const real t118 = 4.0 * (t111 - t101);
            const real t119 = t118 + 2.0 * (u_p_0 * t34 + u_p_1 * t35 + 2.0 * t98);
            const real t120 = 4.0 * t105;
            const real t121 = t120 + 2.0 * (u_p_3 * t35 - 2.0 * t86 - u_p_2 * t34) - t88;
            const real t122 = 4.0 * t89;
            const real t123 = t121 - t122;
            const real t124 = 4.0 * (t77 + t108);
            const real t125 = 2.0 * (u_p_3 * t34 + u_p_2 * t35 - 2.0 * t83) + t124 - t81;
            const real t126 = tq_3 * t123 + tq_2 * t125 + tq_1 * t119 + tq_0 * t117;
            const real t127 = 2.0 * (2.0 * t99 - u_p_1 * t39 - u_p_0 * t40) - t118;
            const real t128 = 2.0 * (2.0 * t95 + u_p_0 * t39 - u_p_1 * t40) + t116;
            const real t129 = t88 + 2.0 * (u_p_3 * t39 - 2.0 * t90 - u_p_2 * t40) + t122;
            const real t130 = t129 - t120;
            const real t131 = t124 - 2.0 * (u_p_2 * t39 + u_p_3 * t40 + 2.0 * t79) - t81;
            const real t132 = tq_2 * t130 + tq_3 * t131 + tq_1 * t128 + tq_0 * t127;
            K[4 * 8 + j] = K[32 * 8 + j] = tp_2 * t126 + tp_3 * t132 + tp_1 * t115 + tp_0 * t103; /* K(0,4) K(4,0) */
            const real t133 = tq_0 * t92 + tq_2 * t102 - tq_1 * t85 - tq_3 * t97;
            const real t134 = tq_0 * t110 + tq_2 * t114 - tq_1 * t107 - tq_3 * t112;
            const real t135 = tq_2 * t123 + tq_0 * t119 - tq_1 * t117 - tq_3 * t125;
            const real t136 = tq_0 * t128 + tq_2 * t131 - tq_1 * t127 - tq_3 * t130;
            K[5 * 8 + j] = K[40 * 8 + j] = tp_2 * t135 + tp_3 * t136 + tp_1 * t134 + tp_0 * t133; /* K(0,5) K(5,0) */
            const real t137 = tq_3 * t92 + tq_0 * t97 - tq_2 * t85 - tq_1 * t102;
            const real t138 = tq_3 * t110 + tq_0 * t112 - tq_2 * t107 - tq_1 * t114;
            const real t139 = tq_3 * t119 + tq_0 * t125 - tq_2 * t117 - tq_1 * t123;
            const real t140 = tq_3 * t128 + tq_0 * t130 - tq_2 * t127 - tq_1 * t131;
            K[6 * 8 + j] = K[48 * 8 + j] = tp_2 * t139 + tp_3 * t140 + tp_1 * t138 + tp_0 * t137; /* K(0,6) K(6,0) */
            const real t141 = tq_1 * t97 + tq_0 * t102 - tq_3 * t85 - tq_2 * t92;
            const real t142 = tq_1 * t112 + tq_0 * t114 - tq_3 * t107 - tq_2 * t110;
            const real t143 = tq_0 * t123 + tq_1 * t125 - tq_3 * t117 - tq_2 * t119;
            const real t144 = tq_1 * t130 + tq_0 * t131 - tq_3 * t127 - tq_2 * t128;
            K[7 * 8 + j] = K[56 * 8 + j] = tp_2 * t143 + tp_3 * t144 + tp_1 * t142 + tp_0 * t141; /* K(0,7) K(7,0) */
            K[9 * 8 + j] = tp_2 * t57 + tp_0 * t63 - tp_1 * t54 - tp_3 * t60; /* K(1,1) */
            K[10 * 8 + j] = K[17 * 8 + j] = tp_2 * t67 + tp_0 * t71 - tp_1 * t65 - tp_3 * t69; /* K(1,2) K(2,1) */
            K[11 * 8 + j] = K[25 * 8 + j] = tp_2 * t73 + tp_0 * t75 - tp_1 * t72 - tp_3 * t74; /* K(1,3) K(3,1) */
            K[12 * 8 + j] = K[33 * 8 + j] = tp_0 * t115 + tp_2 * t132 - tp_1 * t103 - tp_3 * t126; /* K(1,4) K(4,1) */
            K[13 * 8 + j] = K[41 * 8 + j] = tp_0 * t134 + tp_2 * t136 - tp_1 * t133 - tp_3 * t135; /* K(1,5) K(5,1) */
            K[14 * 8 + j] = K[49 * 8 + j] = tp_0 * t138 + tp_2 * t140 - tp_1 * t137 - tp_3 * t139; /* K(1,6) K(6,1) */
            K[15 * 8 + j] = K[57 * 8 + j] = tp_0 * t142 + tp_2 * t144 - tp_1 * t141 - tp_3 * t143; /* K(1,7) K(7,1) */
            K[18 * 8 + j] = tp_0 * t69 + tp_3 * t71 - tp_2 * t65 - tp_1 * t67; /* K(2,2) */
            K[19 * 8 + j] = K[26 * 8 + j] = tp_0 * t74 + tp_3 * t75 - tp_2 * t72 - tp_1 * t73; /* K(2,3) K(3,2) */
            K[20 * 8 + j] = K[34 * 8 + j] = tp_3 * t115 + tp_0 * t126 - tp_2 * t103 - tp_1 * t132; /* K(2,4) K(4,2) */
            K[21 * 8 + j] = K[42 * 8 + j] = tp_3 * t134 + tp_0 * t135 - tp_2 * t133 - tp_1 * t136; /* K(2,5) K(5,2) */
            K[22 * 8 + j] = K[50 * 8 + j] = tp_3 * t138 + tp_0 * t139 - tp_2 * t137 - tp_1 * t140; /* K(2,6) K(6,2) */
            K[23 * 8 + j] = K[58 * 8 + j] = tp_3 * t142 + tp_0 * t143 - tp_2 * t141 - tp_1 * t144; /* K(2,7) K(7,2) */
            K[27 * 8 + j] = tp_1 * t74 + tp_0 * t73 - tp_3 * t72 - tp_2 * t75; /* K(3,3) */
            K[28 * 8 + j] = K[35 * 8 + j] = tp_1 * t126 + tp_0 * t132 - tp_3 * t103 - tp_2 * t115; /* K(3,4) K(4,3) */
            K[29 * 8 + j] = K[43 * 8 + j] = tp_1 * t135 + tp_0 * t136 - tp_3 * t133 - tp_2 * t134; /* K(3,5) K(5,3) */
            K[30 * 8 + j] = K[51 * 8 + j] = tp_1 * t139 + tp_0 * t140 - tp_3 * t137 - tp_2 * t138; /* K(3,6) K(6,3) */
            K[31 * 8 + j] = K[59 * 8 + j] = tp_1 * t143 + tp_0 * t144 - tp_3 * t141 - tp_2 * t142; /* K(3,7) K(7,3) */
            const real t145 = sigma_bend1 * (u_p_0 * u_p_2 + u_p_1 * u_p_3) - sigma_bend2 * (u_p_1 * u_p_2 - u_p_0
                * u_p_3);
            const real t146 = 4.0 * t145;
            const real t147 = 2.0 * u_p_0 * t12 + u_p_1 * t11;
            const real t148 = u_p_0 * t6 + 2.0 * u_p_1 * t8;
            const real t149 = t146 + 2.0 * (u_p_0 * t147 - u_p_1 * t148);
            const real t150 = u_p_0 * t148 + u_p_1 * t147;
            const real t151 = 2.0 * tq_1 * t150;
            const real t152 = u_p_0 * u_p_0;
            const real t153 = u_p_3 * u_p_3;
            const real t154 = u_p_1 * u_p_1;
            const real t155 = u_p_2 * u_p_2;
            const real ez_p_z = t152 + t153 - t154 - t155;
            const real t156 = u_p_0 * u_p_1;
            const real t157 = u_p_2 * u_p_3;
            const real t158 = 2.0 * sigma_bend1 * ez_p_z - 4.0 * sigma_bend2 * (t156 + t157);
            const real t159 = 2.0 * (u_p_3 * t148 + u_p_2 * t147) - t158;
            const real t160 = tq_2 * t159;
            const real ey_p_y = t152 + t155 - t154 - t153;
            const real t161 = 4.0 * sigma_bend1 * (t157 - t156) - 2.0 * sigma_bend2 * ey_p_y;
            const real t162 = t161 + 2.0 * (u_p_3 * t147 - u_p_2 * t148);
            const real t163 = tq_3 * t162;
            const real t164 = u_p_1 * t6 - 2.0 * u_p_0 * t8;
            const real t165 = u_p_0 * t11 - 2.0 * u_p_1 * t12;
            const real t166 = t146 + 2.0 * (u_p_0 * t164 - u_p_1 * t165);
            const real t167 = 2.0 * tq_0 * t150;
            const real t168 = t161 + 2.0 * (u_p_3 * t164 - u_p_2 * t165);
            const real t169 = tq_2 * t168;
            const real t170 = t158 - 2.0 * (u_p_2 * t164 + u_p_3 * t165);
            const real t171 = tq_3 * t170;
            const real t172 = tq_1 * t170;
            const real t173 = tq_0 * t162;
            const real t174 = u_p_3 * (2.0 * u_p_3 * t12 + u_p_2 * t11) - u_p_2 * (u_p_3 * t6 + 2.0 * u_p_2 * t8);
            const real t175 = 2.0 * t174 - t146;
            const real t176 = u_p_2 * t6 - 2.0 * u_p_3 * t8;
            const real t177 = u_p_3 * t11 - 2.0 * u_p_2 * t12;
            const real t178 = u_p_2 * t176 + u_p_3 * t177;
            const real t179 = 2.0 * tq_2 * t178;
            const real t180 = tq_1 * t168;
            const real t181 = tq_0 * t159;
            const real t182 = 2.0 * (u_p_3 * t176 - u_p_2 * t177) - t146;
            const real t183 = 2.0 * tq_3 * t178;
            const real t184 = tq_3 * (t173 + tq_3 * t175 + t172 - t179) + tq_2 * (t181 + tq_2 * t182 + t180 - t183);
            K[36 * 8 + j] = tq_1 * (t169 + t171 + t167 + tq_1 * t166) + t184 + tq_0 * (t160 + t163 + t151 + tq_0
                * t149); /* K(4,4) */
            const real t185 = tq_2 * t162;
            const real t186 = tq_3 * t159;
            const real t187 = t167 + t185 - tq_1 * t149 - t186;
            const real t188 = tq_2 * t170;
            const real t189 = tq_3 * t168;
            const real t190 = t188 + tq_0 * t166 - t151 - t189;
            const real t191 = tq_0 * t170;
            const real t192 = tq_1 * t162;
            const real t193 = t191 + tq_2 * t175 + t183 - t192;
            const real t194 = tq_0 * t168;
            const real t195 = tq_1 * t159;
            const real t196 = t194 - t195 - tq_3 * t182 - t179;
            K[37 * 8 + j] = K[44 * 8 + j] = tq_3 * t193 + tq_2 * t196 + tq_1 * t190 + tq_0 * t187; /* K(4,5) K(5,4) */
            const real t197 = 2.0 * tq_3 * t150;
            const real t198 = t197 + t181 - tq_2 * t149 - t192;
            const real t199 = 2.0 * tq_2 * t150;
            const real t200 = t194 + tq_3 * t166 - t199 - t172;
            const real t201 = 2.0 * tq_0 * t178;
            const real t202 = t171 - t185 - t201 - tq_1 * t175;
            const real t203 = 2.0 * tq_1 * t178;
            const real t204 = t189 + t203 + tq_0 * t182 - t160;
            K[38 * 8 + j] = K[52 * 8 + j] = tq_3 * t202 + tq_2 * t204 + tq_1 * t200 + tq_0 * t198; /* K(4,6) K(6,4) */
            const real t205 = t195 + t173 - tq_3 * t149 - t199;
            const real t206 = t180 + t191 - t197 - tq_2 * t166;
            const real t207 = tq_0 * t175 - t163 - t188 - t203;
            const real t208 = tq_1 * t182 - t186 - t169 - t201;
            K[39 * 8 + j] = K[60 * 8 + j] = tq_3 * t207 + tq_2 * t208 + tq_1 * t206 + tq_0 * t205; /* K(4,7) K(7,4) */
            K[45 * 8 + j] = tq_0 * t190 + tq_2 * t193 - tq_1 * t187 - tq_3 * t196; /* K(5,5) */
            K[46 * 8 + j] = K[53 * 8 + j] = tq_0 * t200 + tq_2 * t202 - tq_1 * t198 - tq_3 * t204; /* K(5,6) K(6,5) */
            K[47 * 8 + j] = K[61 * 8 + j] = tq_0 * t206 + tq_2 * t207 - tq_1 * t205 - tq_3 * t208; /* K(5,7) K(7,5) */
            K[54 * 8 + j] = tq_3 * t200 + tq_0 * t204 - tq_2 * t198 - tq_1 * t202; /* K(6,6) */
            K[55 * 8 + j] = K[62 * 8 + j] = tq_3 * t206 + tq_0 * t208 - tq_2 * t205 - tq_1 * t207; /* K(6,7) K(7,6) */
            K[63 * 8 + j] = tq_1 * t208 + tq_0 * t207 - tq_3 * t205 - tq_2 * t206; /* K(7,7) */
        }
    }
}

/* outputs: 59 operations.
 * in:  x (8), sigma (3), tau (0), p (8)
 * out: axes (3,3) */
FLEXEL_CLONES
static void hinge_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict axes = out[0] + b * (9 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_l0 = x[0 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real p_l1 = x[1 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real p_l2 = x[2 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real p_l3 = x[3 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = p_l0 * tp_0 - p_l1 * tp_1 - p_l2 * tp_2 - p_l3 * tp_3;
            const real t0 = u_p_0 * u_p_0;
            const real u_p_1 = p_l0 * tp_1 + p_l1 * tp_0 + p_l2 * tp_3 - p_l3 * tp_2;
            const real t1 = u_p_1 * u_p_1;
            const real u_p_2 = p_l0 * tp_2 + p_l2 * tp_0 + p_l3 * tp_1 - p_l1 * tp_3;
            const real t2 = u_p_2 * u_p_2;
            const real u_p_3 = p_l0 * tp_3 + p_l1 * tp_2 + p_l3 * tp_0 - p_l2 * tp_1;
            const real t3 = u_p_3 * u_p_3;
            const real ex_p_x = t0 + t1 - t2 - t3;
            axes[0 * 8 + j] = ex_p_x; /* axes(0,0) */
            const real t4 = u_p_0 * u_p_3;
            const real t5 = u_p_1 * u_p_2;
            const real ex_p_y = 2.0 * (t4 + t5);
            axes[1 * 8 + j] = ex_p_y; /* axes(0,1) */
            const real t6 = u_p_1 * u_p_3;
            const real t7 = u_p_0 * u_p_2;
            const real ex_p_z = 2.0 * (t6 - t7);
            axes[2 * 8 + j] = ex_p_z; /* axes(0,2) */
            const real ey_p_x = 2.0 * (t5 - t4);
            axes[3 * 8 + j] = ey_p_x; /* axes(1,0) */
            const real ey_p_y = t0 + t2 - t1 - t3;
            axes[4 * 8 + j] = ey_p_y; /* axes(1,1) */
            const real t8 = u_p_0 * u_p_1;
            const real t9 = u_p_2 * u_p_3;
            const real ey_p_z = 2.0 * (t8 + t9);
            axes[5 * 8 + j] = ey_p_z; /* axes(1,2) */
            const real ez_p_x = 2.0 * (t7 + t6);
            axes[6 * 8 + j] = ez_p_x; /* axes(2,0) */
            const real ez_p_y = 2.0 * (t9 - t8);
            axes[7 * 8 + j] = ez_p_y; /* axes(2,1) */
            const real ez_p_z = t0 + t3 - t1 - t2;
            axes[8 * 8 + j] = ez_p_z; /* axes(2,2) */
        }
    }
}

const flexel_element flexel_hinge = {
    .name = "hinge",
    .digest = "4d8322c15bd8f0fd",
    .n = 8,
    .m = 3,
    .k = 0,
    .np = 8,
    .position = hinge_position,
    .acceleration = hinge_acceleration,
    .rates = hinge_rates,
    .kinematics = hinge_kinematics,
    .stiffness = hinge_stiffness,
    .outputs = hinge_outputs,
};
