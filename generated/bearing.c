/* bearing: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq
 * c = conj(u_p) o u_q
 * angle = 2 atan2(c1, c0), period 2 pi
 * bend1 = ez_p.ex_q,  bend2 = -ey_p.ex_q
 * d = xq - xp
 * (axial, radial1, radial2) = R(u_p)' d - d0
 * axes: the directions in rows;  displacement: the deformations that are lengths
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), BEARING
 *
 * x (14): p_x, p_y, p_z, rp_l0, rp_l1, rp_l2, rp_l3, q_x, q_y, q_z, rq_l0, rq_l1, rq_l2, rq_l3
 * e (6): angle [rad], bend1 [1], bend2 [1], axial [m], radial1 [m], radial2 [m]
 * s (0): none
 * p (11):
 *   tp (4) [1]: unit quaternion from the body frame of node p to the element's triad there
 *   tq (4) [1]: unit quaternion from the body frame of node q to the element's triad there
 *   d0 (3) [m]: components of xq - xp on the triad at p when the deformations are zero */
#include "kernels.h"

/* position: 536 operations.
 * in:  x (14), p (11)
 * out: e (6), De (6,14), 54 of 84 entries, V (0,14) */
FLEXEL_CLONES
static void bearing_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict p = in[1] + b * (11 * 8);
        real *restrict e = out[0] + b * (6 * 8);
        real *restrict De = out[1] + b * (54 * 8);
        real c1[8], c0[8], t0[8];
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
            const real rq_l2 = x[12 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real rq_l0 = x[10 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real rq_l1 = x[11 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real rq_l3 = x[13 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real u_q_1 = rq_l0 * tq_1 + rq_l1 * tq_0 + rq_l2 * tq_3 - rq_l3 * tq_2;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real u_q_2 = rq_l0 * tq_2 + rq_l2 * tq_0 + rq_l3 * tq_1 - rq_l1 * tq_3;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real u_q_0 = rq_l0 * tq_0 - rq_l1 * tq_1 - rq_l2 * tq_2 - rq_l3 * tq_3;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real u_q_3 = rq_l0 * tq_3 + rq_l1 * tq_2 + rq_l3 * tq_0 - rq_l2 * tq_1;
            c1[j] = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_p_1 * u_q_0 - u_p_2 * u_q_3;
            c0[j] = u_p_0 * u_q_0 + u_p_1 * u_q_1 + u_p_2 * u_q_2 + u_p_3 * u_q_3;
            const real t1 = u_p_2 * u_p_3;
            const real t2 = u_p_0 * u_p_1;
            const real t3 = t1 - t2;
            const real t4 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real t5 = u_p_0 * u_p_2;
            const real t6 = u_p_1 * u_p_3;
            const real t7 = t5 + t6;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t8 = u_p_0 * u_p_0;
            const real t9 = u_p_3 * u_p_3;
            const real t10 = u_p_1 * u_p_1;
            const real t11 = u_p_2 * u_p_2;
            const real ez_p_z = t8 + t9 - t10 - t11;
            De[53 * 8 + j] = ez_p_z; /* De(5,9) */
            const real t12 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            e[1 * 8 + j] = 4.0 * t3 * t4 + 2.0 * (t7 * ex_q_x + ez_p_z * t12);
            const real t13 = t2 + t1;
            const real t14 = u_p_1 * u_p_2;
            const real t15 = u_p_0 * u_p_3;
            const real t16 = t14 - t15;
            const real ey_p_y = t8 + t11 - t10 - t9;
            De[42 * 8 + j] = ey_p_y; /* De(4,8) */
            e[2 * 8 + j] = -(4.0 * t13 * t12 + 2.0 * (t16 * ex_q_x + ey_p_y * t4));
            const real ex_p_x = t8 + t10 - t11 - t9;
            De[31 * 8 + j] = ex_p_x; /* De(3,7) */
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real d0_x = p[8 * 8 + j];
            const real t17 = t15 + t14;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t18 = t6 - t5;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            e[3 * 8 + j] = ex_p_x * d_x - d0_x + 2.0 * (t17 * d_y + t18 * d_z);
            const real d0_y = p[9 * 8 + j];
            e[4 * 8 + j] = ey_p_y * d_y - d0_y + 2.0 * (t16 * d_x + t13 * d_z);
            const real d0_z = p[10 * 8 + j];
            e[5 * 8 + j] = ez_p_z * d_z - d0_z + 2.0 * (t7 * d_x + t3 * d_y);
            const real t19 = 1.0 / (c1[j] * c1[j] + c0[j] * c0[j]);
            const real t20 = c0[j] * t19;
            const real t21 = c1[j] * t19;
            const real t22 = 2.0 * u_q_2 * t20 - 2.0 * u_q_3 * t21;
            const real t23 = 2.0 * u_q_1 * t20 - 2.0 * u_q_0 * t21;
            const real t24 = 2.0 * u_q_0 * t20 + 2.0 * u_q_1 * t21;
            const real t25 = 2.0 * u_q_3 * t20 + 2.0 * u_q_2 * t21;
            De[0 * 8 + j] = tp_0 * t23 - tp_1 * t24 - tp_2 * t25 + tp_3 * t22; /* De(0,3) */
            De[1 * 8 + j] = tp_3 * t25 - (tp_0 * t24 + tp_1 * t23) + tp_2 * t22; /* De(0,4) */
            De[2 * 8 + j] = -(tp_3 * t24 + tp_2 * t23 + tp_0 * t25 + tp_1 * t22); /* De(0,5) */
            De[3 * 8 + j] = tp_2 * t24 - tp_3 * t23 - tp_1 * t25 + tp_0 * t22; /* De(0,6) */
            const real t26 = 2.0 * u_p_3 * t20 - 2.0 * u_p_2 * t21;
            const real t27 = 2.0 * u_p_0 * t20 - 2.0 * u_p_1 * t21;
            const real t28 = 2.0 * u_p_1 * t20 + 2.0 * u_p_0 * t21;
            const real t29 = 2.0 * u_p_2 * t20 + 2.0 * u_p_3 * t21;
            De[4 * 8 + j] = tq_1 * t27 - tq_0 * t28 + tq_2 * t26 - tq_3 * t29; /* De(0,10) */
            De[5 * 8 + j] = tq_0 * t27 + tq_1 * t28 - tq_3 * t26 - tq_2 * t29; /* De(0,11) */
            De[6 * 8 + j] = tq_3 * t27 + tq_2 * t28 + tq_0 * t26 + tq_1 * t29; /* De(0,12) */
            De[7 * 8 + j] = tq_3 * t28 - tq_2 * t27 + tq_1 * t26 - tq_0 * t29; /* De(0,13) */
            const real t30 = 4.0 * u_p_2 * t4 + 2.0 * u_p_1 * ex_q_x + 4.0 * u_p_3 * t12;
            const real t31 = tp_3 * t30;
            const real t32 = 2.0 * u_p_3 * ex_q_x - 4.0 * u_p_0 * t4 - 4.0 * u_p_1 * t12;
            const real t33 = 2.0 * u_p_2 * ex_q_x - 4.0 * u_p_1 * t4 + 4.0 * u_p_0 * t12;
            const real t34 = tp_1 * t32 + tp_0 * t33;
            const real t35 = 4.0 * u_p_3 * t4 + 2.0 * u_p_0 * ex_q_x - 4.0 * u_p_2 * t12;
            const real t36 = tp_2 * t35;
            De[8 * 8 + j] = t34 + t36 + t31; /* De(1,3) */
            const real t37 = tp_2 * t30;
            const real t38 = tp_0 * t32 - tp_1 * t33;
            const real t39 = tp_3 * t35;
            De[9 * 8 + j] = t38 - t39 + t37; /* De(1,4) */
            const real t40 = tp_0 * t35;
            const real t41 = tp_2 * t33 - tp_3 * t32;
            const real t42 = tp_1 * t30;
            De[10 * 8 + j] = t40 - t41 - t42; /* De(1,5) */
            const real t43 = tp_0 * t30;
            const real t44 = tp_1 * t35;
            const real t45 = tp_2 * t32 + tp_3 * t33;
            De[11 * 8 + j] = t44 - t45 + t43; /* De(1,6) */
            const real t46 = 4.0 * u_q_3 * t3 + 4.0 * u_q_0 * t7 - 2.0 * u_q_2 * ez_p_z;
            const real t47 = 4.0 * u_q_2 * t3 + 4.0 * u_q_1 * t7 + 2.0 * u_q_3 * ez_p_z;
            const real t48 = 4.0 * u_q_1 * t3 - 4.0 * u_q_2 * t7 - 2.0 * u_q_0 * ez_p_z;
            const real t49 = 4.0 * u_q_0 * t3 - 4.0 * u_q_3 * t7 + 2.0 * u_q_1 * ez_p_z;
            De[12 * 8 + j] = tq_0 * t46 + tq_1 * t47 + tq_2 * t48 + tq_3 * t49; /* De(1,10) */
            De[13 * 8 + j] = tq_0 * t47 - tq_1 * t46 - tq_3 * t48 + tq_2 * t49; /* De(1,11) */
            De[14 * 8 + j] = tq_3 * t47 - tq_2 * t46 + tq_0 * t48 - tq_1 * t49; /* De(1,12) */
            De[15 * 8 + j] = tq_1 * t48 - (tq_3 * t46 + tq_2 * t47) + tq_0 * t49; /* De(1,13) */
            De[16 * 8 + j] = t38 - t37 + t39; /* De(2,3) */
            De[17 * 8 + j] = t31 - t34 + t36; /* De(2,4) */
            De[18 * 8 + j] = -(t45 + t43 + t44); /* De(2,5) */
            De[19 * 8 + j] = t41 - t42 + t40; /* De(2,6) */
            const real t50 = 4.0 * u_q_2 * t13 - (2.0 * u_q_3 * ey_p_y + 4.0 * u_q_0 * t16);
            const real t51 = 2.0 * u_q_2 * ey_p_y + 4.0 * u_q_1 * t16 + 4.0 * u_q_3 * t13;
            const real t52 = 4.0 * u_q_2 * t16 - 2.0 * u_q_1 * ey_p_y + 4.0 * u_q_0 * t13;
            const real t53 = 4.0 * u_q_3 * t16 - 2.0 * u_q_0 * ey_p_y - 4.0 * u_q_1 * t13;
            De[20 * 8 + j] = tq_0 * t50 - tq_1 * t51 + tq_2 * t52 + tq_3 * t53; /* De(2,10) */
            De[21 * 8 + j] = tq_2 * t53 - (tq_1 * t50 + tq_0 * t51 + tq_3 * t52); /* De(2,11) */
            De[22 * 8 + j] = tq_0 * t52 - (tq_2 * t50 + tq_3 * t51) - tq_1 * t53; /* De(2,12) */
            De[23 * 8 + j] = tq_2 * t51 - tq_3 * t50 + tq_1 * t52 + tq_0 * t53; /* De(2,13) */
            De[24 * 8 + j] = -ex_p_x; /* De(3,0) */
            const real ex_p_y = 2.0 * t17;
            De[32 * 8 + j] = ex_p_y; /* De(3,8) */
            De[25 * 8 + j] = -ex_p_y; /* De(3,1) */
            const real ex_p_z = 2.0 * t18;
            De[33 * 8 + j] = ex_p_z; /* De(3,9) */
            De[26 * 8 + j] = -ex_p_z; /* De(3,2) */
            const real t54 = 2.0 * u_p_1 * d_z - (2.0 * u_p_3 * d_x - 2.0 * u_p_0 * d_y);
            const real t55 = tp_3 * t54;
            const real t56 = 2.0 * u_p_3 * d_y + 2.0 * u_p_0 * d_x - 2.0 * u_p_2 * d_z;
            const real t57 = tp_0 * t56;
            const real t58 = 2.0 * u_p_2 * d_y + 2.0 * u_p_1 * d_x + 2.0 * u_p_3 * d_z;
            const real t59 = tp_1 * t58;
            const real t60 = 2.0 * u_p_2 * d_x - 2.0 * u_p_1 * d_y + 2.0 * u_p_0 * d_z;
            const real t61 = tp_2 * t60;
            De[27 * 8 + j] = t57 + t59 - t61 + t55; /* De(3,3) */
            const real t62 = tp_2 * t54;
            const real t63 = tp_3 * t60;
            const real t64 = tp_0 * t58;
            const real t65 = tp_1 * t56;
            De[28 * 8 + j] = t64 - t65 + t63 + t62; /* De(3,4) */
            const real t66 = tp_3 * t58;
            const real t67 = tp_2 * t56;
            const real t68 = tp_0 * t60;
            const real t69 = tp_1 * t54;
            De[29 * 8 + j] = t66 - t67 - t68 - t69; /* De(3,5) */
            const real t70 = tp_0 * t54;
            const real t71 = tp_1 * t60;
            const real t72 = tp_3 * t56;
            const real t73 = tp_2 * t58;
            De[30 * 8 + j] = t70 - (t72 + t73 + t71); /* De(3,6) */
            const real ey_p_x = 2.0 * t16;
            De[41 * 8 + j] = ey_p_x; /* De(4,7) */
            De[34 * 8 + j] = -ey_p_x; /* De(4,0) */
            De[35 * 8 + j] = -ey_p_y; /* De(4,1) */
            const real ey_p_z = 2.0 * t13;
            De[43 * 8 + j] = ey_p_z; /* De(4,9) */
            De[36 * 8 + j] = -ey_p_z; /* De(4,2) */
            const real t74 = t71 + t70;
            De[37 * 8 + j] = t74 + t73 - t72; /* De(4,3) */
            const real t75 = t68 - t69;
            De[38 * 8 + j] = t75 - t66 - t67; /* De(4,4) */
            const real t76 = t62 - t63;
            De[39 * 8 + j] = t64 - t76 + t65; /* De(4,5) */
            const real t77 = t61 + t55;
            De[40 * 8 + j] = t59 - t77 - t57; /* De(4,6) */
            const real ez_p_x = 2.0 * t7;
            De[51 * 8 + j] = ez_p_x; /* De(5,7) */
            De[44 * 8 + j] = -ez_p_x; /* De(5,0) */
            const real ez_p_y = 2.0 * t3;
            De[52 * 8 + j] = ez_p_y; /* De(5,8) */
            De[45 * 8 + j] = -ez_p_y; /* De(5,1) */
            De[46 * 8 + j] = -ez_p_z; /* De(5,2) */
            De[47 * 8 + j] = t67 + t75 + t66; /* De(5,3) */
            De[48 * 8 + j] = t73 - (t72 + t74); /* De(5,4) */
            De[49 * 8 + j] = t57 - t77 - t59; /* De(5,5) */
            De[50 * 8 + j] = t65 + t76 + t64; /* De(5,6) */
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

/* acceleration: 430 operations.
 * in:  x (14), v (14), p (11)
 * out: g (6), gs (0) */
FLEXEL_CLONES
static void bearing_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict p = in[2] + b * (11 * 8);
        real *restrict g = out[0] + b * (6 * 8);
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
            const real rq_l2 = x[12 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real rq_l0 = x[10 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real rq_l1 = x[11 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real rq_l3 = x[13 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real u_q_1 = rq_l0 * tq_1 + rq_l1 * tq_0 + rq_l2 * tq_3 - rq_l3 * tq_2;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real u_q_2 = rq_l0 * tq_2 + rq_l2 * tq_0 + rq_l3 * tq_1 - rq_l1 * tq_3;
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real u_q_0 = rq_l0 * tq_0 - rq_l1 * tq_1 - rq_l2 * tq_2 - rq_l3 * tq_3;
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real u_q_3 = rq_l0 * tq_3 + rq_l1 * tq_2 + rq_l3 * tq_0 - rq_l2 * tq_1;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_p_1 * u_q_0 - u_p_2 * u_q_3;
            const real c0 = u_p_0 * u_q_0 + u_p_1 * u_q_1 + u_p_3 * u_q_3 + u_p_2 * u_q_2;
            const real t0 = 1.0 / (c1 * c1 + c0 * c0);
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t1 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real rq_vl2 = v[12 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real rq_vl1 = v[11 * 8 + j];
            const real rq_vl3 = v[13 * 8 + j];
            const real t2 = rq_vl0 * tq_1 + rq_vl1 * tq_0 + rq_vl2 * tq_3 - rq_vl3 * tq_2;
            const real t3 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t4 = rq_vl0 * tq_2 + rq_vl2 * tq_0 + rq_vl3 * tq_1 - rq_vl1 * tq_3;
            const real t5 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real t6 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t7 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t8 = rq_vl0 * tq_3 + rq_vl1 * tq_2 + rq_vl3 * tq_0 - rq_vl2 * tq_1;
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
            const real t19 = t17 - t18;
            const real t20 = u_p_2 * u_p_3;
            const real t21 = u_p_0 * u_p_1;
            const real t22 = t6 * t8 + t2 * t4;
            const real t23 = u_p_3 * t7 + u_p_2 * t3;
            const real t24 = u_p_1 * t1 + u_p_0 * t5;
            const real t25 = t23 - t24;
            const real t26 = u_q_2 * t2 + u_q_1 * t4 + u_q_3 * t6 + u_q_0 * t8;
            const real t27 = 4.0 * (t16 * t19 + 2.0 * ((t20 - t21) * t22 + t25 * t26));
            const real t28 = u_p_2 * t1 + u_p_0 * t7;
            const real t29 = u_p_3 * t5 + u_p_1 * t3;
            const real t30 = t28 + t29;
            const real t31 = u_q_0 * t6 + u_q_1 * t2 - u_q_2 * t4 - u_q_3 * t8;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t32 = 2.0 * t1 * t7;
            const real t33 = 2.0 * t5 * t3;
            const real t34 = t32 + t33;
            const real t35 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            const real t36 = 2.0 * t1 * t1;
            const real t37 = 2.0 * t3 * t3;
            const real t38 = 2.0 * t5 * t5;
            const real t39 = 2.0 * t7 * t7;
            const real t40 = t36 + t37 - t38 - t39;
            const real t41 = 2.0 * u_p_0 * t1;
            const real t42 = 2.0 * u_p_3 * t3;
            const real t43 = 2.0 * u_p_1 * t5;
            const real t44 = 2.0 * u_p_2 * t7;
            const real t45 = t41 + t42 - t43 - t44;
            const real t46 = u_q_3 * t2 + u_q_1 * t8 - u_q_2 * t6 - u_q_0 * t4;
            const real t47 = u_p_0 * u_p_0;
            const real t48 = u_p_3 * u_p_3;
            const real t49 = u_p_1 * u_p_1;
            const real t50 = u_p_2 * u_p_2;
            const real ez_p_z = t47 + t48 - t49 - t50;
            const real t51 = t2 * t8 - t6 * t4;
            const real t52 = t6 * t6 + t2 * t2 - t4 * t4 - t8 * t8;
            const real t53 = ez_p_z * t51 + (u_p_0 * u_p_2 + u_p_1 * u_p_3) * t52 + t45 * t46;
            const real t54 = 2.0 * (t35 * t40 + 2.0 * t53 + ex_q_x * t34 + 4.0 * t30 * t31);
            g[1 * 8 + j] = t27 + t54;
            const real t55 = t18 + t17;
            const real t56 = t24 + t23;
            const real t57 = 4.0 * (t35 * t55 + 2.0 * ((t21 + t20) * t51 + t56 * t46));
            const real t58 = u_p_2 * t5 + u_p_1 * t7;
            const real t59 = u_p_3 * t1 + u_p_0 * t3;
            const real t60 = t58 - t59;
            const real t61 = 2.0 * t5 * t7;
            const real t62 = 2.0 * t1 * t3;
            const real t63 = t61 - t62;
            const real t64 = t36 + t39 - t38 - t37;
            const real t65 = t41 + t44 - t43 - t42;
            const real ey_p_y = t47 + t50 - t49 - t48;
            const real t66 = ey_p_y * t22 + (u_p_1 * u_p_2 - u_p_0 * u_p_3) * t52 + t65 * t26;
            const real t67 = 2.0 * (t16 * t64 + 2.0 * t66 + ex_q_x * t63 + 4.0 * t60 * t31);
            g[2 * 8 + j] = -(t57 + t67);
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t68 = q_vx - p_vx;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t69 = q_vy - p_vy;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t70 = q_vz - p_vz;
            const real t71 = d_z * (t33 - t32) + 2.0 * ((t59 + t58) * t69 + (t29 - t28) * t70);
            const real t72 = 2.0 * (d_y * (t62 + t61) + t71 + (t41 + t43 - t44 - t42) * t68);
            g[3 * 8 + j] = d_x * (t36 + t38 - t39 - t37) + t72;
            const real t73 = d_z * t55 + 2.0 * (t60 * t68 + t56 * t70) + d_x * t63 + t65 * t69;
            g[4 * 8 + j] = d_y * t64 + 2.0 * t73;
            const real t74 = d_y * t19 + 2.0 * (t30 * t68 + t25 * t69) + d_x * t34 + t45 * t70;
            g[5 * 8 + j] = d_z * t40 + 2.0 * t74;
        }
    }
}

/* rates: 788 operations.
 * in:  x (14), v (14), p (11)
 * out: Phi_x (6,14), 54 of 84 entries */
FLEXEL_CLONES
static void bearing_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict p = in[2] + b * (11 * 8);
        real *restrict Phi_x = out[0] + b * (54 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_l1 = x[4 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l0 = x[3 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real u_p_1 = rp_l0 * tp_1 + rp_l2 * tp_3 + rp_l1 * tp_0 - rp_l3 * tp_2;
            const real rq_l1 = x[11 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real rq_l0 = x[10 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real rq_l2 = x[12 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real rq_l3 = x[13 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real u_q_1 = rq_l0 * tq_1 + rq_l2 * tq_3 + rq_l1 * tq_0 - rq_l3 * tq_2;
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real u_q_0 = rq_l0 * tq_0 - rq_l1 * tq_1 - rq_l2 * tq_2 - rq_l3 * tq_3;
            const real u_p_3 = rp_l0 * tp_3 + rp_l3 * tp_0 + rp_l1 * tp_2 - rp_l2 * tp_1;
            const real u_q_3 = rq_l0 * tq_3 + rq_l3 * tq_0 + rq_l1 * tq_2 - rq_l2 * tq_1;
            const real u_p_2 = rp_l0 * tp_2 + rp_l3 * tp_1 + rp_l2 * tp_0 - rp_l1 * tp_3;
            const real u_q_2 = rq_l0 * tq_2 + rq_l3 * tq_1 + rq_l2 * tq_0 - rq_l1 * tq_3;
            const real c0 = u_p_3 * u_q_3 + u_p_2 * u_q_2 + u_p_0 * u_q_0 + u_p_1 * u_q_1;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_q_0 * u_p_1 - u_p_2 * u_q_3;
            const real t0 = 1.0 / (c1 * c1 + c0 * c0);
            const real t1 = c0 * t0;
            const real rq_vl2 = v[12 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real rq_vl3 = v[13 * 8 + j];
            const real rq_vl1 = v[11 * 8 + j];
            const real t2 = rq_vl0 * tq_2 + rq_vl3 * tq_1 + rq_vl2 * tq_0 - rq_vl1 * tq_3;
            const real t3 = c1 * t0;
            const real t4 = rq_vl0 * tq_3 + rq_vl3 * tq_0 + rq_vl1 * tq_2 - rq_vl2 * tq_1;
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real t5 = rp_vl0 * tp_3 + rp_vl3 * tp_0 + rp_vl1 * tp_2 - rp_vl2 * tp_1;
            const real t6 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t7 = rq_vl0 * tq_1 + rq_vl2 * tq_3 + rq_vl1 * tq_0 - rq_vl3 * tq_2;
            const real t8 = rp_vl0 * tp_1 + rp_vl2 * tp_3 + rp_vl1 * tp_0 - rp_vl3 * tp_2;
            const real t9 = t6 * u_q_1 + u_p_0 * t7 + u_q_2 * t5 + u_p_3 * t2 - u_q_0 * t8;
            const real t10 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t11 = rp_vl0 * tp_2 + rp_vl3 * tp_1 + rp_vl2 * tp_0 - rp_vl1 * tp_3;
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
            Phi_x[0 * 8 + j] = tp_0 * t21 + tp_1 * t22 + tp_2 * t20 + tp_3 * t19; /* Phi_x(0,3) */
            Phi_x[1 * 8 + j] = tp_0 * t22 + tp_2 * t19 - tp_1 * t21 - tp_3 * t20; /* Phi_x(0,4) */
            Phi_x[2 * 8 + j] = tp_3 * t22 + tp_0 * t20 - tp_2 * t21 - tp_1 * t19; /* Phi_x(0,5) */
            Phi_x[3 * 8 + j] = tp_1 * t20 + tp_0 * t19 - tp_3 * t21 - tp_2 * t22; /* Phi_x(0,6) */
            const real t23 = 2.0 * u_p_3 * t17 + 2.0 * u_p_2 * t18 - 2.0 * (t3 * t5 + t1 * t11);
            const real t24 = 2.0 * (t1 * t5 - t3 * t11) + 2.0 * u_p_2 * t17 - 2.0 * u_p_3 * t18;
            const real t25 = 2.0 * u_p_0 * t17 + 2.0 * u_p_1 * t18 - 2.0 * (t6 * t3 + t1 * t8);
            const real t26 = 2.0 * (t6 * t1 - t3 * t8) + 2.0 * u_p_1 * t17 - 2.0 * u_p_0 * t18;
            Phi_x[4 * 8 + j] = tq_0 * t25 + tq_1 * t26 + tq_2 * t24 + tq_3 * t23; /* Phi_x(0,10) */
            Phi_x[5 * 8 + j] = tq_0 * t26 + tq_2 * t23 - tq_1 * t25 - tq_3 * t24; /* Phi_x(0,11) */
            Phi_x[6 * 8 + j] = tq_3 * t26 + tq_0 * t24 - tq_2 * t25 - tq_1 * t23; /* Phi_x(0,12) */
            Phi_x[7 * 8 + j] = tq_1 * t24 + tq_0 * t23 - tq_3 * t25 - tq_2 * t26; /* Phi_x(0,13) */
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
            Phi_x[8 * 8 + j] = t33 + t35 - t38; /* Phi_x(1,3) */
            const real t39 = tp_0 * t37 + tp_1 * t36;
            const real t40 = tp_2 * t32;
            const real t41 = tp_3 * t34;
            Phi_x[9 * 8 + j] = t39 + t40 - t41; /* Phi_x(1,4) */
            const real t42 = tp_3 * t37 + tp_2 * t36;
            const real t43 = tp_0 * t34;
            const real t44 = tp_1 * t32;
            Phi_x[10 * 8 + j] = t42 + t43 - t44; /* Phi_x(1,5) */
            const real t45 = tp_1 * t34;
            const real t46 = tp_3 * t36 - tp_2 * t37;
            const real t47 = tp_0 * t32;
            Phi_x[11 * 8 + j] = t46 + t47 + t45; /* Phi_x(1,6) */
            const real t48 = u_p_2 * u_p_3;
            const real t49 = u_p_0 * u_p_1;
            const real t50 = t48 - t49;
            const real t51 = u_p_3 * t11 + u_p_2 * t5;
            const real t52 = t6 * u_p_1 + u_p_0 * t8;
            const real t53 = t51 - t52;
            const real t54 = t6 * u_p_2 + u_p_0 * t11;
            const real t55 = u_p_3 * t8 + u_p_1 * t5;
            const real t56 = t54 + t55;
            const real t57 = u_p_0 * u_p_2 + u_p_1 * u_p_3;
            const real t58 = u_p_0 * u_p_0;
            const real t59 = u_p_3 * u_p_3;
            const real t60 = u_p_1 * u_p_1;
            const real t61 = u_p_2 * u_p_2;
            const real ez_p_z = t58 + t59 - t60 - t61;
            const real t62 = 2.0 * u_p_0 * t6;
            const real t63 = 2.0 * u_p_3 * t5;
            const real t64 = 2.0 * u_p_1 * t8;
            const real t65 = 2.0 * u_p_2 * t11;
            const real t66 = t62 + t63 - t64 - t65;
            Phi_x[53 * 8 + j] = t66; /* Phi_x(5,9) */
            const real t67 = 4.0 * (t10 * t50 + u_q_0 * t53 - u_q_3 * t56 - t57 * t4) + 2.0 * (ez_p_z * t7 + u_q_1
                * t66);
            const real t68 = 4.0 * (t50 * t7 + u_q_1 * t53 - u_q_2 * t56 - t57 * t2) - 2.0 * (u_q_0 * t66 + t10
                * ez_p_z);
            const real t69 = 4.0 * (t50 * t4 + t10 * t57 + u_q_3 * t53 + u_q_0 * t56) - 2.0 * (u_q_2 * t66 + ez_p_z
                * t2);
            const real t70 = 4.0 * (t50 * t2 + t57 * t7 + u_q_2 * t53 + u_q_1 * t56) + 2.0 * (ez_p_z * t4 + u_q_3
                * t66);
            Phi_x[12 * 8 + j] = tq_0 * t69 + tq_1 * t70 + tq_2 * t68 + tq_3 * t67; /* Phi_x(1,10) */
            Phi_x[13 * 8 + j] = tq_0 * t70 + tq_2 * t67 - tq_1 * t69 - tq_3 * t68; /* Phi_x(1,11) */
            Phi_x[14 * 8 + j] = tq_3 * t70 + tq_0 * t68 - tq_2 * t69 - tq_1 * t67; /* Phi_x(1,12) */
            Phi_x[15 * 8 + j] = tq_1 * t68 + tq_0 * t67 - tq_3 * t69 - tq_2 * t70; /* Phi_x(1,13) */
            Phi_x[16 * 8 + j] = t39 + t41 - t40; /* Phi_x(2,3) */
            Phi_x[17 * 8 + j] = t38 + t33 + t35; /* Phi_x(2,4) */
            Phi_x[18 * 8 + j] = t46 - t47 - t45; /* Phi_x(2,5) */
            Phi_x[19 * 8 + j] = t43 - t42 - t44; /* Phi_x(2,6) */
            const real t71 = u_p_1 * u_p_2 - u_p_0 * u_p_3;
            const real t72 = u_p_2 * t8 + u_p_1 * t11;
            const real t73 = t6 * u_p_3 + u_p_0 * t5;
            const real t74 = t72 - t73;
            const real t75 = t52 + t51;
            const real t76 = t49 + t48;
            const real t77 = t62 + t65 - t64 - t63;
            Phi_x[42 * 8 + j] = t77; /* Phi_x(4,8) */
            const real ey_p_y = t58 + t61 - t60 - t59;
            const real t78 = 4.0 * (t71 * t4 + u_q_3 * t74 - u_q_1 * t75 - t76 * t7) - 2.0 * (u_q_0 * t77 + t10
                * ey_p_y);
            const real t79 = 4.0 * (t76 * t2 + u_q_2 * t75 - u_q_0 * t74 - t10 * t71) - 2.0 * (u_q_3 * t77 + ey_p_y
                * t4);
            const real t80 = 4.0 * (t10 * t76 + t71 * t2 + u_q_0 * t75 + u_q_2 * t74) - 2.0 * (u_q_1 * t77 + ey_p_y
                * t7);
            const real t81 = 4.0 * (t76 * t4 + t71 * t7 + u_q_3 * t75 + u_q_1 * t74) + 2.0 * (ey_p_y * t2 + u_q_2
                * t77);
            Phi_x[20 * 8 + j] = tq_0 * t79 + tq_2 * t80 + tq_3 * t78 - tq_1 * t81; /* Phi_x(2,10) */
            Phi_x[21 * 8 + j] = tq_2 * t78 - tq_1 * t79 - tq_0 * t81 - tq_3 * t80; /* Phi_x(2,11) */
            Phi_x[22 * 8 + j] = tq_0 * t80 - tq_2 * t79 - tq_3 * t81 - tq_1 * t78; /* Phi_x(2,12) */
            Phi_x[23 * 8 + j] = tq_2 * t81 + tq_1 * t80 + tq_0 * t78 - tq_3 * t79; /* Phi_x(2,13) */
            const real t82 = t62 + t64 - t65 - t63;
            Phi_x[31 * 8 + j] = t82; /* Phi_x(3,7) */
            Phi_x[24 * 8 + j] = -t82; /* Phi_x(3,0) */
            const real t83 = 2.0 * (t73 + t72);
            Phi_x[32 * 8 + j] = t83; /* Phi_x(3,8) */
            Phi_x[25 * 8 + j] = -t83; /* Phi_x(3,1) */
            const real t84 = 2.0 * (t55 - t54);
            Phi_x[33 * 8 + j] = t84; /* Phi_x(3,9) */
            Phi_x[26 * 8 + j] = -t84; /* Phi_x(3,2) */
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t85 = q_vx - p_vx;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t86 = q_vy - p_vy;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t87 = q_vz - p_vz;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t88 = d_z * t5 + d_y * t11 + d_x * t8 + t87 * u_p_3 + t86 * u_p_2;
            const real t89 = t85 * u_p_1 + t88;
            const real t90 = 2.0 * tp_1 * t89;
            const real t91 = d_x * t6 + d_y * t5 + t86 * u_p_3 + u_p_0 * t85 - t87 * u_p_2;
            const real t92 = t91 - d_z * t11;
            const real t93 = 2.0 * tp_0 * t92;
            const real t94 = d_y * t8 + t86 * u_p_1 - t85 * u_p_2 - u_p_0 * t87 - d_x * t11;
            const real t95 = t94 - d_z * t6;
            const real t96 = 2.0 * tp_2 * t95;
            const real t97 = d_y * t6 + d_z * t8 + t87 * u_p_1 + u_p_0 * t86 - t85 * u_p_3;
            const real t98 = t97 - d_x * t5;
            const real t99 = 2.0 * tp_3 * t98;
            Phi_x[27 * 8 + j] = t96 + t99 + t93 + t90; /* Phi_x(3,3) */
            const real t100 = 2.0 * tp_2 * t98;
            const real t101 = 2.0 * tp_0 * t89;
            const real t102 = 2.0 * tp_1 * t92;
            const real t103 = 2.0 * tp_3 * t95;
            Phi_x[28 * 8 + j] = t100 + t101 - t102 - t103; /* Phi_x(3,4) */
            const real t104 = 2.0 * tp_0 * t95;
            const real t105 = 2.0 * tp_3 * t89;
            const real t106 = 2.0 * tp_2 * t92;
            const real t107 = 2.0 * tp_1 * t98;
            Phi_x[29 * 8 + j] = t104 + t105 - t106 - t107; /* Phi_x(3,5) */
            const real t108 = 2.0 * tp_1 * t95;
            const real t109 = 2.0 * tp_0 * t98;
            const real t110 = 2.0 * tp_3 * t92;
            const real t111 = 2.0 * tp_2 * t89;
            Phi_x[30 * 8 + j] = t108 + t109 - t110 - t111; /* Phi_x(3,6) */
            const real t112 = 2.0 * t74;
            Phi_x[41 * 8 + j] = t112; /* Phi_x(4,7) */
            Phi_x[34 * 8 + j] = -t112; /* Phi_x(4,0) */
            Phi_x[35 * 8 + j] = -t77; /* Phi_x(4,1) */
            const real t113 = 2.0 * t75;
            Phi_x[43 * 8 + j] = t113; /* Phi_x(4,9) */
            Phi_x[36 * 8 + j] = -t113; /* Phi_x(4,2) */
            const real t114 = t108 - t109;
            Phi_x[37 * 8 + j] = t111 - t114 - t110; /* Phi_x(4,3) */
            const real t115 = t104 + t107;
            Phi_x[38 * 8 + j] = -(t106 + t115 + t105); /* Phi_x(4,4) */
            const real t116 = t102 + t101;
            const real t117 = t103 + t100;
            Phi_x[39 * 8 + j] = t116 - t117; /* Phi_x(4,5) */
            const real t118 = t96 - t99;
            Phi_x[40 * 8 + j] = t118 + t90 - t93; /* Phi_x(4,6) */
            const real t119 = 2.0 * t56;
            Phi_x[51 * 8 + j] = t119; /* Phi_x(5,7) */
            Phi_x[44 * 8 + j] = -t119; /* Phi_x(5,0) */
            const real t120 = 2.0 * t53;
            Phi_x[52 * 8 + j] = t120; /* Phi_x(5,8) */
            Phi_x[45 * 8 + j] = -t120; /* Phi_x(5,1) */
            Phi_x[46 * 8 + j] = -t66; /* Phi_x(5,2) */
            Phi_x[47 * 8 + j] = t106 + t105 - t115; /* Phi_x(5,3) */
            Phi_x[48 * 8 + j] = t114 + t111 - t110; /* Phi_x(5,4) */
            Phi_x[49 * 8 + j] = t93 + t118 - t90; /* Phi_x(5,5) */
            Phi_x[50 * 8 + j] = t117 + t116; /* Phi_x(5,6) */
        }
    }
}

/* kinematics: 1814 operations.
 * in:  x (14), v (14), a (14), p (11)
 * out: Psi_x (6,14), 54 of 84 entries, Psi_v (6,14), 54 of 84 entries */
FLEXEL_CLONES
static void bearing_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict a = in[2] + b * (14 * 8);
        const real *restrict p = in[3] + b * (11 * 8);
        real *restrict Psi_x = out[0] + b * (54 * 8);
        real *restrict Psi_v = out[1] + b * (54 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_vl2 = v[12 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real rq_vl3 = v[13 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real rq_vl1 = v[11 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real t0 = rq_vl0 * tq_2 + rq_vl3 * tq_1 + rq_vl2 * tq_0 - rq_vl1 * tq_3;
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[0 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[1 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[2 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[3 * 8 + j];
            const real u_p_0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real rq_l1 = x[11 * 8 + j];
            const real rq_l0 = x[10 * 8 + j];
            const real rq_l2 = x[12 * 8 + j];
            const real rq_l3 = x[13 * 8 + j];
            const real u_q_1 = rq_l0 * tq_1 + rq_l2 * tq_3 + rq_l1 * tq_0 - rq_l3 * tq_2;
            const real u_p_3 = rp_l0 * tp_3 + rp_l3 * tp_0 + rp_l1 * tp_2 - rp_l2 * tp_1;
            const real u_q_2 = rq_l0 * tq_2 + rq_l3 * tq_1 + rq_l2 * tq_0 - rq_l1 * tq_3;
            const real u_q_0 = rq_l0 * tq_0 - rq_l1 * tq_1 - rq_l2 * tq_2 - rq_l3 * tq_3;
            const real u_p_1 = rp_l0 * tp_1 + rp_l2 * tp_3 + rp_l1 * tp_0 - rp_l3 * tp_2;
            const real u_p_2 = rp_l0 * tp_2 + rp_l3 * tp_1 + rp_l2 * tp_0 - rp_l1 * tp_3;
            const real u_q_3 = rq_l0 * tq_3 + rq_l3 * tq_0 + rq_l1 * tq_2 - rq_l2 * tq_1;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_q_0 * u_p_1 - u_p_2 * u_q_3;
            const real c0 = u_p_3 * u_q_3 + u_p_2 * u_q_2 + u_p_0 * u_q_0 + u_p_1 * u_q_1;
            const real t1 = 1.0 / (c1 * c1 + c0 * c0);
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real t2 = rp_vl0 * tp_3 + rp_vl3 * tp_0 + rp_vl1 * tp_2 - rp_vl2 * tp_1;
            const real t3 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t4 = rq_vl0 * tq_1 + rq_vl2 * tq_3 + rq_vl1 * tq_0 - rq_vl3 * tq_2;
            const real t5 = rp_vl0 * tp_1 + rp_vl2 * tp_3 + rp_vl1 * tp_0 - rp_vl3 * tp_2;
            const real t6 = t3 * u_q_1 + u_p_0 * t4 + u_q_2 * t2 + u_p_3 * t0 - u_q_0 * t5;
            const real t7 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t8 = rp_vl0 * tp_2 + rp_vl3 * tp_1 + rp_vl2 * tp_0 - rp_vl1 * tp_3;
            const real t9 = rq_vl0 * tq_3 + rq_vl3 * tq_0 + rq_vl1 * tq_2 - rq_vl2 * tq_1;
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
            const real rq_al2 = a[12 * 8 + j];
            const real rq_al0 = a[10 * 8 + j];
            const real rq_al3 = a[13 * 8 + j];
            const real rq_al1 = a[11 * 8 + j];
            const real t22 = tq_2 * rq_al0 + tq_1 * rq_al3 + tq_0 * rq_al2 - tq_3 * rq_al1;
            const real rp_al1 = a[4 * 8 + j];
            const real rp_al0 = a[3 * 8 + j];
            const real rp_al3 = a[6 * 8 + j];
            const real rp_al2 = a[5 * 8 + j];
            const real t23 = tp_3 * rp_al0 + tp_0 * rp_al3 + tp_2 * rp_al1 - tp_1 * rp_al2;
            const real t24 = tp_0 * rp_al0 - tp_1 * rp_al1 - tp_2 * rp_al2 - tp_3 * rp_al3;
            const real t25 = tq_1 * rq_al0 + tq_3 * rq_al2 + tq_0 * rq_al1 - tq_2 * rq_al3;
            const real t26 = u_q_1 * t24 + u_p_0 * t25 + u_q_2 * t23 + u_p_3 * t22 + 2.0 * (t3 * t4 + t2 * t0 - t7
                * t5 - t8 * t9);
            const real t27 = tp_1 * rp_al0 + tp_3 * rp_al2 + tp_0 * rp_al1 - tp_2 * rp_al3;
            const real t28 = tq_0 * rq_al0 - tq_1 * rq_al1 - tq_2 * rq_al2 - tq_3 * rq_al3;
            const real t29 = tp_2 * rp_al0 + tp_1 * rp_al3 + tp_0 * rp_al2 - tp_3 * rp_al1;
            const real t30 = tq_3 * rq_al0 + tq_0 * rq_al3 + tq_2 * rq_al1 - tq_1 * rq_al2;
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
            Psi_x[0 * 8 + j] = tp_1 * t50 + tp_0 * t52 + tp_3 * t48 + tp_2 * t46; /* Psi_x(0,3) */
            Psi_x[1 * 8 + j] = tp_0 * t50 + tp_2 * t48 - tp_1 * t52 - tp_3 * t46; /* Psi_x(0,4) */
            Psi_x[2 * 8 + j] = tp_3 * t50 + tp_0 * t46 - tp_2 * t52 - tp_1 * t48; /* Psi_x(0,5) */
            Psi_x[3 * 8 + j] = tp_1 * t46 + tp_0 * t48 - tp_3 * t52 - tp_2 * t50; /* Psi_x(0,6) */
            const real t53 = 2.0 * (t37 * t23 - t38 * t29 + u_p_3 * t40 + u_p_2 * t36);
            const real t54 = t8 * t21 + t53 + t2 * t45;
            const real t55 = 2.0 * (u_p_3 * t36 - (t37 * t29 + t38 * t23) - u_p_2 * t40);
            const real t56 = t2 * t21 + t55 - t8 * t45;
            const real t57 = 2.0 * (t37 * t24 - t38 * t27 + u_p_0 * t40 + u_p_1 * t36);
            const real t58 = t5 * t21 + t57 + t3 * t45;
            const real t59 = 2.0 * (u_p_0 * t36 - (t37 * t27 + t38 * t24) - u_p_1 * t40);
            const real t60 = t3 * t21 + t59 - t5 * t45;
            Psi_x[4 * 8 + j] = tq_1 * t58 + tq_0 * t60 + tq_3 * t56 + tq_2 * t54; /* Psi_x(0,10) */
            Psi_x[5 * 8 + j] = tq_0 * t58 + tq_2 * t56 - tq_1 * t60 - tq_3 * t54; /* Psi_x(0,11) */
            Psi_x[6 * 8 + j] = tq_3 * t58 + tq_0 * t54 - tq_2 * t60 - tq_1 * t56; /* Psi_x(0,12) */
            Psi_x[7 * 8 + j] = tq_1 * t54 + tq_0 * t56 - tq_3 * t60 - tq_2 * t58; /* Psi_x(0,13) */
            const real t61 = u_q_3 * t25 + u_q_1 * t30 + 2.0 * (t4 * t9 - t7 * t0) - u_q_2 * t28;
            const real t62 = t61 - u_q_0 * t22;
            const real t63 = 4.0 * u_p_3 * t62;
            const real t64 = u_q_0 * t7 + u_q_1 * t4 - u_q_2 * t0 - u_q_3 * t9;
            const real t65 = t7 * t7 + t4 * t4 + u_q_0 * t28 + u_q_1 * t25 - t0 * t0 - t9 * t9;
            const real t66 = t65 - u_q_2 * t22 - u_q_3 * t30;
            const real t67 = 8.0 * t5 * t64 + 4.0 * u_p_1 * t66;
            const real t68 = u_q_3 * t28 + u_q_0 * t30 + u_q_2 * t25 + u_q_1 * t22 + 2.0 * (t7 * t9 + t4 * t0);
            const real t69 = 4.0 * u_p_2 * t68;
            const real t70 = t7 * u_q_3 + u_q_0 * t9 + u_q_2 * t4 + u_q_1 * t0;
            const real t71 = u_q_3 * t4 + u_q_1 * t9 - t7 * u_q_2 - u_q_0 * t0;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t72 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real t73 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            const real t74 = 2.0 * ex_q_x * t27 + 4.0 * (t72 * t29 + t73 * t23) + 8.0 * (t8 * t70 + t2 * t71);
            const real t75 = t69 + t74 + t67 + t63;
            const real t76 = t72 * t23 + u_p_0 * t66 + u_p_3 * t68 - u_p_2 * t62 - t73 * t29;
            const real t77 = 4.0 * t76 + 8.0 * (t2 * t70 + t3 * t64 - t8 * t71) + 2.0 * ex_q_x * t24;
            const real t78 = tp_2 * t77;
            const real t79 = 8.0 * (t2 * t64 - t3 * t70 - t5 * t71) + 2.0 * (ex_q_x * t23 + 2.0 * u_p_3 * t66);
            const real t80 = 4.0 * (t72 * t24 + t73 * t27 + u_p_0 * t68 + u_p_1 * t62);
            const real t81 = t79 - t80;
            const real t82 = tp_1 * t81;
            const real t83 = 4.0 * u_p_0 * t62;
            const real t84 = 8.0 * t3 * t71;
            const real t85 = 2.0 * ex_q_x * t29;
            const real t86 = 4.0 * t73 * t24;
            const real t87 = 8.0 * t8 * t64 + 4.0 * u_p_2 * t66;
            const real t88 = 4.0 * u_p_1 * t68;
            const real t89 = 8.0 * t5 * t70;
            const real t90 = 4.0 * t72 * t27;
            const real t91 = t85 + t86 + t84 + t87 + t83 - t88 - t89 - t90;
            Psi_x[8 * 8 + j] = t82 + tp_0 * t91 + t78 + tp_3 * t75; /* Psi_x(1,3) */
            const real t92 = tp_0 * t81;
            const real t93 = tp_3 * t77;
            Psi_x[9 * 8 + j] = t92 + tp_2 * t75 - tp_1 * t91 - t93; /* Psi_x(1,4) */
            const real t94 = tp_3 * t81;
            const real t95 = tp_0 * t77;
            Psi_x[10 * 8 + j] = t94 + t95 - tp_2 * t91 - tp_1 * t75; /* Psi_x(1,5) */
            const real t96 = tp_1 * t77;
            const real t97 = tp_2 * t81;
            Psi_x[11 * 8 + j] = t96 + tp_0 * t75 - tp_3 * t91 - t97; /* Psi_x(1,6) */
            const real t98 = u_p_3 * t8 + u_p_2 * t2;
            const real t99 = t3 * u_p_1 + u_p_0 * t5;
            const real t100 = t98 - t99;
            const real t101 = t3 * u_p_2 + u_p_0 * t8;
            const real t102 = u_p_3 * t5 + u_p_1 * t2;
            const real t103 = t101 + t102;
            const real t104 = u_p_2 * u_p_3;
            const real t105 = u_p_0 * u_p_1;
            const real t106 = t104 - t105;
            const real t107 = 2.0 * t8 * t2;
            const real t108 = u_p_3 * t29 + u_p_2 * t23;
            const real t109 = 2.0 * t3 * t5;
            const real t110 = u_p_1 * t24 + u_p_0 * t27;
            const real t111 = t107 + t108 - t109 - t110;
            const real t112 = 2.0 * u_p_0 * t3;
            const real t113 = 2.0 * u_p_3 * t2;
            const real t114 = 2.0 * u_p_1 * t5;
            const real t115 = 2.0 * u_p_2 * t8;
            const real t116 = t112 + t113 - t114 - t115;
            const real t117 = u_p_0 * u_p_2 + u_p_1 * u_p_3;
            const real t118 = 4.0 * (t106 * t25 + u_q_1 * t111 - t7 * t116 - t117 * t22);
            const real t119 = 2.0 * u_p_0 * t24;
            const real t120 = 2.0 * t2 * t2;
            const real t121 = 2.0 * t3 * t3;
            const real t122 = 2.0 * u_p_3 * t23;
            const real t123 = 2.0 * t5 * t5;
            const real t124 = 2.0 * t8 * t8;
            const real t125 = 2.0 * u_p_1 * t27;
            const real t126 = 2.0 * u_p_2 * t29;
            const real t127 = t121 + t122 + t120 + t119 - t123 - t124 - t125 - t126;
            Psi_x[53 * 8 + j] = t127; /* Psi_x(5,9) */
            const real t128 = u_p_0 * u_p_0;
            const real t129 = u_p_3 * u_p_3;
            const real t130 = u_p_1 * u_p_1;
            const real t131 = u_p_2 * u_p_2;
            const real ez_p_z = t128 + t129 - t130 - t131;
            const real t132 = u_p_2 * t24 + u_p_0 * t29;
            const real t133 = 2.0 * t5 * t2;
            const real t134 = 2.0 * t3 * t8;
            const real t135 = u_p_3 * t27 + u_p_1 * t23;
            const real t136 = t134 + t135 + t133 + t132;
            const real t137 = 8.0 * (t4 * t100 - t0 * t103) + t118 - 2.0 * (ez_p_z * t28 + 2.0 * u_q_2 * t136 + u_q_0
                * t127);
            const real t138 = 4.0 * (t106 * t28 + t4 * t116 + u_q_0 * t111 - t117 * t30);
            const real t139 = 8.0 * (t7 * t100 - t9 * t103) + 2.0 * (ez_p_z * t25 + u_q_1 * t127 - 2.0 * u_q_3
                * t136);
            const real t140 = t138 + t139;
            const real t141 = 4.0 * (t106 * t22 + t117 * t25 + t9 * t116 + u_q_2 * t111);
            const real t142 = 8.0 * (t0 * t100 + t4 * t103) + 2.0 * (ez_p_z * t30 + 2.0 * u_q_1 * t136 + u_q_3
                * t127);
            const real t143 = t141 + t142;
            const real t144 = 4.0 * (t106 * t30 + t117 * t28 + u_q_3 * t111 - t0 * t116);
            const real t145 = 8.0 * (t9 * t100 + t7 * t103) + 2.0 * (2.0 * u_q_0 * t136 - ez_p_z * t22 - u_q_2
                * t127);
            const real t146 = t144 + t145;
            Psi_x[12 * 8 + j] = tq_1 * t143 + tq_0 * t146 + tq_3 * t140 + tq_2 * t137; /* Psi_x(1,10) */
            Psi_x[13 * 8 + j] = tq_0 * t143 + tq_2 * t140 - tq_1 * t146 - tq_3 * t137; /* Psi_x(1,11) */
            Psi_x[14 * 8 + j] = tq_3 * t143 + tq_0 * t137 - tq_2 * t146 - tq_1 * t140; /* Psi_x(1,12) */
            Psi_x[15 * 8 + j] = tq_1 * t137 + tq_0 * t140 - tq_3 * t146 - tq_2 * t143; /* Psi_x(1,13) */
            const real t147 = t90 + t89 + t88 - t87 - t83 - t84 - t85 - t86;
            const real t148 = t63 + t74 + t67 + t69;
            Psi_x[16 * 8 + j] = t92 + tp_1 * t147 + t93 - tp_2 * t148; /* Psi_x(2,3) */
            Psi_x[17 * 8 + j] = t78 + tp_3 * t148 + tp_0 * t147 - t82; /* Psi_x(2,4) */
            Psi_x[18 * 8 + j] = tp_3 * t147 - t97 - tp_0 * t148 - t96; /* Psi_x(2,5) */
            Psi_x[19 * 8 + j] = t95 - t94 - tp_2 * t147 - tp_1 * t148; /* Psi_x(2,6) */
            const real t149 = t99 + t98;
            const real t150 = u_p_2 * t5 + u_p_1 * t8;
            const real t151 = t3 * u_p_3 + u_p_0 * t2;
            const real t152 = t150 - t151;
            const real t153 = t105 + t104;
            const real t154 = t109 + t108 + t107 + t110;
            const real t155 = t112 + t115 - t114 - t113;
            const real t156 = u_p_1 * u_p_2 - u_p_0 * u_p_3;
            const real t157 = 4.0 * (t153 * t22 + u_q_2 * t154 - t9 * t155 - t156 * t28);
            const real t158 = t121 + t126 + t124 + t119 - t123 - t120 - t125 - t122;
            Psi_x[42 * 8 + j] = t158; /* Psi_x(4,8) */
            const real ey_p_y = t128 + t131 - t130 - t129;
            const real t159 = 2.0 * t5 * t8;
            const real t160 = u_p_2 * t27 + u_p_1 * t29;
            const real t161 = 2.0 * t3 * t2;
            const real t162 = u_p_3 * t24 + u_p_0 * t23;
            const real t163 = t159 + t160 - t161 - t162;
            const real t164 = 8.0 * (t0 * t149 - t7 * t152) + t157 - 2.0 * (ey_p_y * t30 + 2.0 * u_q_0 * t163 + u_q_3
                * t158);
            const real t165 = 4.0 * (t153 * t28 + t156 * t22 + u_q_0 * t154 - t4 * t155);
            const real t166 = 8.0 * (t7 * t149 + t0 * t152) + 2.0 * (2.0 * u_q_2 * t163 - ey_p_y * t25 - u_q_1
                * t158);
            const real t167 = t165 + t166;
            const real t168 = 4.0 * (t156 * t30 - t7 * t155 - t153 * t25 - u_q_1 * t154);
            const real t169 = 8.0 * (t9 * t152 - t4 * t149) + 2.0 * (2.0 * u_q_3 * t163 - ey_p_y * t28 - u_q_0
                * t158);
            const real t170 = t168 + t169;
            const real t171 = 4.0 * (t153 * t30 + t156 * t25 + t0 * t155 + u_q_3 * t154);
            const real t172 = 8.0 * (t9 * t149 + t4 * t152) + 2.0 * (ey_p_y * t22 + 2.0 * u_q_1 * t163 + u_q_2
                * t158);
            const real t173 = t171 + t172;
            Psi_x[20 * 8 + j] = tq_2 * t167 + tq_3 * t170 + tq_0 * t164 - tq_1 * t173; /* Psi_x(2,10) */
            Psi_x[21 * 8 + j] = tq_2 * t170 - tq_1 * t164 - tq_0 * t173 - tq_3 * t167; /* Psi_x(2,11) */
            Psi_x[22 * 8 + j] = tq_0 * t167 - tq_2 * t164 - tq_3 * t173 - tq_1 * t170; /* Psi_x(2,12) */
            Psi_x[23 * 8 + j] = tq_1 * t167 + tq_0 * t170 + tq_2 * t173 - tq_3 * t164; /* Psi_x(2,13) */
            const real t174 = t123 + t119 + t121 + t125 - t124 - t120 - t126 - t122;
            Psi_x[31 * 8 + j] = t174; /* Psi_x(3,7) */
            Psi_x[24 * 8 + j] = -t174; /* Psi_x(3,0) */
            const real t175 = 2.0 * (t161 + t160 + t159 + t162);
            Psi_x[32 * 8 + j] = t175; /* Psi_x(3,8) */
            Psi_x[25 * 8 + j] = -t175; /* Psi_x(3,1) */
            const real t176 = 2.0 * (t133 + t135 - t134 - t132);
            Psi_x[33 * 8 + j] = t176; /* Psi_x(3,9) */
            Psi_x[26 * 8 + j] = -t176; /* Psi_x(3,2) */
            const real q_ay = a[8 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t177 = q_ay - p_ay;
            const real t178 = 2.0 * u_p_1 * t177;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t179 = 2.0 * d_y * t27;
            const real q_vy = v[8 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t180 = q_vy - p_vy;
            const real t181 = 4.0 * t180 * t5;
            const real q_ax = a[7 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t182 = q_ax - p_ax;
            const real t183 = 2.0 * u_p_2 * t182;
            const real q_az = a[9 * 8 + j];
            const real p_az = a[2 * 8 + j];
            const real t184 = q_az - p_az;
            const real t185 = 2.0 * u_p_0 * t184;
            const real q_vx = v[7 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t186 = q_vx - p_vx;
            const real t187 = 4.0 * t186 * t8;
            const real q_vz = v[9 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real t188 = q_vz - p_vz;
            const real t189 = 4.0 * t3 * t188;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t190 = 2.0 * d_x * t29;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real t191 = 2.0 * d_z * t24;
            const real t192 = t179 + t181 + t178 - t183 - t185 - t187 - t189 - t190 - t191;
            const real t193 = 2.0 * (d_y * t24 + d_z * t27 + u_p_1 * t184 + u_p_0 * t177);
            const real t194 = t193 + 4.0 * (t3 * t180 + t188 * t5);
            const real t195 = 2.0 * u_p_3 * t182;
            const real t196 = 4.0 * t186 * t2;
            const real t197 = 2.0 * d_x * t23;
            const real t198 = t194 - t195 - t196 - t197;
            const real t199 = 2.0 * u_p_0 * t182;
            const real t200 = 2.0 * u_p_3 * t177;
            const real t201 = 4.0 * t3 * t186;
            const real t202 = 4.0 * t180 * t2;
            const real t203 = 2.0 * d_x * t24;
            const real t204 = 2.0 * d_y * t23;
            const real t205 = 2.0 * u_p_2 * t184;
            const real t206 = 4.0 * t188 * t8;
            const real t207 = 2.0 * d_z * t29;
            const real t208 = t203 + t204 + t202 + t201 + t200 + t199 - t205 - t206 - t207;
            const real t209 = 2.0 * (d_z * t23 + d_y * t29 + d_x * t27) + 4.0 * (t188 * t2 + t180 * t8);
            const real t210 = 2.0 * u_p_1 * t182;
            const real t211 = 2.0 * u_p_2 * t177;
            const real t212 = 4.0 * t186 * t5;
            const real t213 = 2.0 * u_p_3 * t184;
            const real t214 = t212 + t213 + t211 + t210 + t209;
            Psi_x[27 * 8 + j] = tp_0 * t208 + tp_1 * t214 + tp_3 * t198 + tp_2 * t192; /* Psi_x(3,3) */
            Psi_x[28 * 8 + j] = tp_0 * t214 + tp_2 * t198 - tp_1 * t208 - tp_3 * t192; /* Psi_x(3,4) */
            Psi_x[29 * 8 + j] = tp_0 * t192 + tp_3 * t214 - tp_2 * t208 - tp_1 * t198; /* Psi_x(3,5) */
            Psi_x[30 * 8 + j] = tp_1 * t192 + tp_0 * t198 - tp_3 * t208 - tp_2 * t214; /* Psi_x(3,6) */
            const real t215 = 2.0 * t163;
            Psi_x[41 * 8 + j] = t215; /* Psi_x(4,7) */
            Psi_x[34 * 8 + j] = -t215; /* Psi_x(4,0) */
            Psi_x[35 * 8 + j] = -t158; /* Psi_x(4,1) */
            const real t216 = 2.0 * t154;
            Psi_x[43 * 8 + j] = t216; /* Psi_x(4,9) */
            Psi_x[36 * 8 + j] = -t216; /* Psi_x(4,2) */
            const real t217 = t213 + t211 + t212 + t210 + t209;
            const real t218 = tp_2 * t217;
            const real t219 = t207 + t206 + t205 - t200 - t201 - t199 - t202 - t203 - t204;
            const real t220 = tp_3 * t219;
            const real t221 = t191 + t190 + t189 + t185 + t187 + t183 - t178 - t181 - t179;
            const real t222 = t194 - t196 - t195 - t197;
            const real t223 = tp_1 * t221 + tp_0 * t222;
            Psi_x[37 * 8 + j] = t220 + t223 + t218; /* Psi_x(4,3) */
            const real t224 = tp_2 * t219;
            const real t225 = tp_0 * t221 - tp_1 * t222;
            const real t226 = tp_3 * t217;
            Psi_x[38 * 8 + j] = t224 + t225 - t226; /* Psi_x(4,4) */
            const real t227 = tp_0 * t217;
            const real t228 = tp_2 * t222 - tp_3 * t221;
            const real t229 = tp_1 * t219;
            Psi_x[39 * 8 + j] = t227 - t228 - t229; /* Psi_x(4,5) */
            const real t230 = tp_0 * t219;
            const real t231 = tp_1 * t217;
            const real t232 = tp_2 * t221 + tp_3 * t222;
            Psi_x[40 * 8 + j] = t230 + t231 - t232; /* Psi_x(4,6) */
            const real t233 = 2.0 * t136;
            Psi_x[51 * 8 + j] = t233; /* Psi_x(5,7) */
            Psi_x[44 * 8 + j] = -t233; /* Psi_x(5,0) */
            const real t234 = 2.0 * t111;
            Psi_x[52 * 8 + j] = t234; /* Psi_x(5,8) */
            Psi_x[45 * 8 + j] = -t234; /* Psi_x(5,1) */
            Psi_x[46 * 8 + j] = -t127; /* Psi_x(5,2) */
            Psi_x[47 * 8 + j] = t225 + t226 - t224; /* Psi_x(5,3) */
            Psi_x[48 * 8 + j] = t220 + t218 - t223; /* Psi_x(5,4) */
            Psi_x[49 * 8 + j] = -(t230 + t232 + t231); /* Psi_x(5,5) */
            Psi_x[50 * 8 + j] = t228 + t227 - t229; /* Psi_x(5,6) */
            const real t235 = t12 - t20;
            const real t236 = t43 + t44;
            const real t237 = u_q_2 * t235 + u_q_3 * t236 - 2.0 * (t38 * t0 + t37 * t9);
            const real t238 = 2.0 * (t37 * t0 - t38 * t9) + u_q_3 * t235 - u_q_2 * t236;
            const real t239 = 2.0 * (t37 * t4 - t7 * t38) + u_q_0 * t235 - u_q_1 * t236;
            const real t240 = u_q_1 * t235 + u_q_0 * t236 - 2.0 * (t38 * t4 + t7 * t37);
            Psi_v[0 * 8 + j] = 2.0 * (tp_0 * t239 + tp_1 * t240 + tp_3 * t238 + tp_2 * t237); /* Psi_v(0,3) */
            Psi_v[1 * 8 + j] = 2.0 * (tp_0 * t240 + tp_2 * t238 - tp_1 * t239 - tp_3 * t237); /* Psi_v(0,4) */
            Psi_v[2 * 8 + j] = 2.0 * (tp_3 * t240 + tp_0 * t237 - tp_2 * t239 - tp_1 * t238); /* Psi_v(0,5) */
            Psi_v[3 * 8 + j] = 2.0 * (tp_1 * t237 + tp_0 * t238 - tp_3 * t239 - tp_2 * t240); /* Psi_v(0,6) */
            const real t241 = 2.0 * (t37 * t2 - t38 * t8) + u_p_2 * t235 - u_p_3 * t236;
            const real t242 = u_p_3 * t235 + u_p_2 * t236 - 2.0 * (t38 * t2 + t37 * t8);
            const real t243 = u_p_0 * t235 + u_p_1 * t236 - 2.0 * (t3 * t38 + t37 * t5);
            const real t244 = 2.0 * (t3 * t37 - t38 * t5) + u_p_1 * t235 - u_p_0 * t236;
            Psi_v[4 * 8 + j] = 2.0 * (tq_0 * t243 + tq_1 * t244 + tq_3 * t242 + tq_2 * t241); /* Psi_v(0,10) */
            Psi_v[5 * 8 + j] = 2.0 * (tq_0 * t244 + tq_2 * t242 - tq_1 * t243 - tq_3 * t241); /* Psi_v(0,11) */
            Psi_v[6 * 8 + j] = 2.0 * (tq_3 * t244 + tq_0 * t241 - tq_2 * t243 - tq_1 * t242); /* Psi_v(0,12) */
            Psi_v[7 * 8 + j] = 2.0 * (tq_1 * t241 + tq_0 * t242 - tq_3 * t243 - tq_2 * t244); /* Psi_v(0,13) */
            const real t245 = 4.0 * (t72 * t2 + u_p_3 * t70 - u_p_2 * t71 - t73 * t8) + 2.0 * (t3 * ex_q_x + 2.0
                * u_p_0 * t64);
            const real t246 = tp_2 * t245;
            const real t247 = 2.0 * (ex_q_x * t5 + 2.0 * u_p_1 * t64) + 4.0 * (t73 * t2 + t72 * t8 + u_p_2 * t70
                + u_p_3 * t71);
            const real t248 = tp_3 * t247;
            const real t249 = 4.0 * (t72 * t5 + u_p_1 * t70 - u_p_0 * t71 - t3 * t73) - 2.0 * (2.0 * u_p_2 * t64
                + ex_q_x * t8);
            const real t250 = 2.0 * (ex_q_x * t2 + 2.0 * u_p_3 * t64) - 4.0 * (u_p_0 * t70 + u_p_1 * t71 + t3 * t72
                + t73 * t5);
            const real t251 = tp_0 * t249 - tp_1 * t250;
            Psi_v[8 * 8 + j] = 2.0 * (t246 + t248 - t251); /* Psi_v(1,3) */
            const real t252 = tp_0 * t250 + tp_1 * t249;
            const real t253 = tp_2 * t247;
            const real t254 = tp_3 * t245;
            Psi_v[9 * 8 + j] = 2.0 * (t252 + t253 - t254); /* Psi_v(1,4) */
            const real t255 = tp_3 * t250 + tp_2 * t249;
            const real t256 = tp_0 * t245;
            const real t257 = tp_1 * t247;
            Psi_v[10 * 8 + j] = 2.0 * (t255 + t256 - t257); /* Psi_v(1,5) */
            const real t258 = tp_1 * t245;
            const real t259 = tp_3 * t249 - tp_2 * t250;
            const real t260 = tp_0 * t247;
            Psi_v[11 * 8 + j] = 2.0 * (t259 + t260 + t258); /* Psi_v(1,6) */
            const real t261 = 4.0 * (t106 * t4 + u_q_1 * t100 - u_q_2 * t103 - t117 * t0);
            const real t262 = t261 - 2.0 * (u_q_0 * t116 + t7 * ez_p_z);
            const real t263 = 4.0 * (t7 * t106 + u_q_0 * t100 - u_q_3 * t103 - t117 * t9);
            const real t264 = t263 + 2.0 * (ez_p_z * t4 + u_q_1 * t116);
            const real t265 = 4.0 * (t106 * t9 + t7 * t117 + u_q_3 * t100 + u_q_0 * t103);
            const real t266 = t265 - 2.0 * (u_q_2 * t116 + ez_p_z * t0);
            const real t267 = 4.0 * (t106 * t0 + t117 * t4 + u_q_2 * t100 + u_q_1 * t103);
            const real t268 = t267 + 2.0 * (ez_p_z * t9 + u_q_3 * t116);
            Psi_v[12 * 8 + j] = 2.0 * (tq_0 * t266 + tq_1 * t268 + tq_3 * t264 + tq_2 * t262); /* Psi_v(1,10) */
            Psi_v[13 * 8 + j] = 2.0 * (tq_0 * t268 + tq_2 * t264 - tq_1 * t266 - tq_3 * t262); /* Psi_v(1,11) */
            Psi_v[14 * 8 + j] = 2.0 * (tq_3 * t268 + tq_0 * t262 - tq_2 * t266 - tq_1 * t264); /* Psi_v(1,12) */
            Psi_v[15 * 8 + j] = 2.0 * (tq_1 * t262 + tq_0 * t264 - tq_3 * t266 - tq_2 * t268); /* Psi_v(1,13) */
            Psi_v[16 * 8 + j] = 2.0 * (t252 + t254 - t253); /* Psi_v(2,3) */
            Psi_v[17 * 8 + j] = 2.0 * (t251 + t248 + t246); /* Psi_v(2,4) */
            Psi_v[18 * 8 + j] = 2.0 * (t259 - t260 - t258); /* Psi_v(2,5) */
            Psi_v[19 * 8 + j] = 2.0 * (t256 - t255 - t257); /* Psi_v(2,6) */
            const real t269 = 4.0 * (t153 * t0 + u_q_2 * t149 - u_q_0 * t152 - t7 * t156);
            const real t270 = t269 - 2.0 * (u_q_3 * t155 + ey_p_y * t9);
            const real t271 = 4.0 * (t7 * t153 + t156 * t0 + u_q_0 * t149 + u_q_2 * t152);
            const real t272 = t271 - 2.0 * (u_q_1 * t155 + ey_p_y * t4);
            const real t273 = 4.0 * (t156 * t9 + u_q_3 * t152 - u_q_1 * t149 - t153 * t4);
            const real t274 = t273 - 2.0 * (u_q_0 * t155 + t7 * ey_p_y);
            const real t275 = 4.0 * (t153 * t9 + t156 * t4 + u_q_3 * t149 + u_q_1 * t152);
            const real t276 = t275 + 2.0 * (ey_p_y * t0 + u_q_2 * t155);
            Psi_v[20 * 8 + j] = 2.0 * (tq_2 * t272 + tq_3 * t274 + tq_0 * t270 - tq_1 * t276); /* Psi_v(2,10) */
            Psi_v[21 * 8 + j] = 2.0 * (tq_2 * t274 - tq_1 * t270 - tq_0 * t276 - tq_3 * t272); /* Psi_v(2,11) */
            Psi_v[22 * 8 + j] = 2.0 * (tq_0 * t272 - tq_2 * t270 - tq_3 * t276 - tq_1 * t274); /* Psi_v(2,12) */
            Psi_v[23 * 8 + j] = 2.0 * (tq_1 * t272 + tq_0 * t274 + tq_2 * t276 - tq_3 * t270); /* Psi_v(2,13) */
            const real t277 = 2.0 * (t112 + t114 - t115 - t113);
            Psi_v[31 * 8 + j] = t277; /* Psi_v(3,7) */
            Psi_v[24 * 8 + j] = -t277; /* Psi_v(3,0) */
            const real t278 = 4.0 * (t151 + t150);
            Psi_v[32 * 8 + j] = t278; /* Psi_v(3,8) */
            Psi_v[25 * 8 + j] = -t278; /* Psi_v(3,1) */
            const real t279 = 4.0 * (t102 - t101);
            Psi_v[33 * 8 + j] = t279; /* Psi_v(3,9) */
            Psi_v[26 * 8 + j] = -t279; /* Psi_v(3,2) */
            const real t280 = d_z * t2 + d_y * t8 + d_x * t5 + t188 * u_p_3 + t180 * u_p_2;
            const real t281 = t186 * u_p_1 + t280;
            const real t282 = 2.0 * tp_1 * t281;
            const real t283 = d_x * t3 + d_y * t2 + t180 * u_p_3 + u_p_0 * t186 - t188 * u_p_2;
            const real t284 = t283 - d_z * t8;
            const real t285 = 2.0 * tp_0 * t284;
            const real t286 = d_y * t5 + t180 * u_p_1 - t186 * u_p_2 - u_p_0 * t188 - d_x * t8;
            const real t287 = t286 - d_z * t3;
            const real t288 = 2.0 * tp_2 * t287;
            const real t289 = d_y * t3 + d_z * t5 + t188 * u_p_1 + u_p_0 * t180 - t186 * u_p_3;
            const real t290 = t289 - d_x * t2;
            const real t291 = 2.0 * tp_3 * t290;
            Psi_v[27 * 8 + j] = 2.0 * (t288 + t291 + t285 + t282); /* Psi_v(3,3) */
            const real t292 = 2.0 * tp_2 * t290;
            const real t293 = 2.0 * tp_0 * t281;
            const real t294 = 2.0 * tp_1 * t284;
            const real t295 = 2.0 * tp_3 * t287;
            Psi_v[28 * 8 + j] = 2.0 * (t292 + t293 - t294 - t295); /* Psi_v(3,4) */
            const real t296 = 2.0 * tp_0 * t287;
            const real t297 = 2.0 * tp_3 * t281;
            const real t298 = 2.0 * tp_2 * t284;
            const real t299 = 2.0 * tp_1 * t290;
            Psi_v[29 * 8 + j] = 2.0 * (t296 + t297 - t298 - t299); /* Psi_v(3,5) */
            const real t300 = 2.0 * tp_1 * t287;
            const real t301 = 2.0 * tp_0 * t290;
            const real t302 = 2.0 * tp_3 * t284;
            const real t303 = 2.0 * tp_2 * t281;
            Psi_v[30 * 8 + j] = 2.0 * (t300 + t301 - t302 - t303); /* Psi_v(3,6) */
            const real t304 = 4.0 * t152;
            Psi_v[41 * 8 + j] = t304; /* Psi_v(4,7) */
            Psi_v[34 * 8 + j] = -t304; /* Psi_v(4,0) */
            const real t305 = 2.0 * t155;
            Psi_v[42 * 8 + j] = t305; /* Psi_v(4,8) */
            Psi_v[35 * 8 + j] = -t305; /* Psi_v(4,1) */
            const real t306 = 4.0 * t149;
            Psi_v[43 * 8 + j] = t306; /* Psi_v(4,9) */
            Psi_v[36 * 8 + j] = -t306; /* Psi_v(4,2) */
            const real t307 = t300 - t301;
            Psi_v[37 * 8 + j] = 2.0 * (t303 - t307 - t302); /* Psi_v(4,3) */
            const real t308 = t296 + t299;
            const real t309 = t298 + t297;
            Psi_v[38 * 8 + j] = -(2.0 * (t308 + t309)); /* Psi_v(4,4) */
            const real t310 = t294 + t293;
            const real t311 = t295 + t292;
            Psi_v[39 * 8 + j] = 2.0 * (t310 - t311); /* Psi_v(4,5) */
            const real t312 = t288 - t291;
            Psi_v[40 * 8 + j] = 2.0 * (t312 + t282 - t285); /* Psi_v(4,6) */
            const real t313 = 4.0 * t103;
            Psi_v[51 * 8 + j] = t313; /* Psi_v(5,7) */
            Psi_v[44 * 8 + j] = -t313; /* Psi_v(5,0) */
            const real t314 = 4.0 * t100;
            Psi_v[52 * 8 + j] = t314; /* Psi_v(5,8) */
            Psi_v[45 * 8 + j] = -t314; /* Psi_v(5,1) */
            const real t315 = 2.0 * t116;
            Psi_v[53 * 8 + j] = t315; /* Psi_v(5,9) */
            Psi_v[46 * 8 + j] = -t315; /* Psi_v(5,2) */
            Psi_v[47 * 8 + j] = 2.0 * (t309 - t308); /* Psi_v(5,3) */
            Psi_v[48 * 8 + j] = 2.0 * (t307 + t303 - t302); /* Psi_v(5,4) */
            Psi_v[49 * 8 + j] = 2.0 * (t285 + t312 - t282); /* Psi_v(5,5) */
            Psi_v[50 * 8 + j] = 2.0 * (t311 + t310); /* Psi_v(5,6) */
        }
    }
}

/* stiffness: 1150 operations.
 * in:  x (14), sigma (6), tau (0), p (11)
 * out: K (14,14), 112 of 196 entries */
FLEXEL_CLONES
static void bearing_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict sigma = in[1] + b * (6 * 8);
        const real *restrict p = in[3] + b * (11 * 8);
        real *restrict K = out[0] + b * (112 * 8);
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
            const real sigma_radial2 = sigma[5 * 8 + j];
            const real u_p_1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real sigma_radial1 = sigma[4 * 8 + j];
            const real u_p_2 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real sigma_axial = sigma[3 * 8 + j];
            const real t0 = u_p_0 * sigma_radial2 + u_p_1 * sigma_radial1 - u_p_2 * sigma_axial;
            const real t1 = 2.0 * tp_2 * t0;
            const real u_p_3 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t2 = u_p_2 * sigma_radial2 + u_p_0 * sigma_axial - u_p_3 * sigma_radial1;
            const real t3 = 2.0 * tp_0 * t2;
            const real t4 = u_p_3 * sigma_radial2 + u_p_1 * sigma_axial + u_p_2 * sigma_radial1;
            const real t5 = 2.0 * tp_1 * t4;
            const real t6 = u_p_0 * sigma_radial1 + u_p_3 * sigma_axial - u_p_1 * sigma_radial2;
            const real t7 = 2.0 * tp_3 * t6;
            const real t8 = t3 + t5 + t1 - t7;
            K[19 * 8 + j] = K[68 * 8 + j] = t8; /* K(3,7) K(7,3) */
            K[0 * 8 + j] = K[12 * 8 + j] = -t8; /* K(0,3) K(3,0) */
            const real t9 = 2.0 * tp_0 * t4;
            const real t10 = 2.0 * tp_1 * t2;
            const real t11 = 2.0 * tp_3 * t0;
            const real t12 = 2.0 * tp_2 * t6;
            const real t13 = t9 - t10 - t11 - t12;
            K[33 * 8 + j] = K[69 * 8 + j] = t13; /* K(4,7) K(7,4) */
            K[1 * 8 + j] = K[26 * 8 + j] = -t13; /* K(0,4) K(4,0) */
            const real t14 = 2.0 * tp_1 * t6;
            const real t15 = 2.0 * tp_3 * t4;
            const real t16 = 2.0 * tp_0 * t0;
            const real t17 = 2.0 * tp_2 * t2;
            const real t18 = t15 + t16 + t14 - t17;
            K[47 * 8 + j] = K[70 * 8 + j] = t18; /* K(5,7) K(7,5) */
            K[2 * 8 + j] = K[40 * 8 + j] = -t18; /* K(0,5) K(5,0) */
            const real t19 = 2.0 * tp_1 * t0;
            const real t20 = 2.0 * tp_3 * t2;
            const real t21 = 2.0 * tp_2 * t4;
            const real t22 = 2.0 * tp_0 * t6;
            const real t23 = t19 - t20 - t21 - t22;
            K[61 * 8 + j] = K[71 * 8 + j] = t23; /* K(6,7) K(7,6) */
            K[3 * 8 + j] = K[54 * 8 + j] = -t23; /* K(0,6) K(6,0) */
            const real t24 = t20 + t22 + t21 - t19;
            K[20 * 8 + j] = K[35 * 8 + j] = K[72 * 8 + j] = K[77 * 8 + j] = t24; /* K(3,8) K(4,9) K(8,3) K(9,4) */
            K[4 * 8 + j] = K[9 * 8 + j] = K[13 * 8 + j] = K[28 * 8 + j] = -t24; /* K(1,3) K(2,4) K(3,1) K(4,2) */
            const real t25 = t17 - t14 - t16 - t15;
            K[34 * 8 + j] = K[73 * 8 + j] = t25; /* K(4,8) K(8,4) */
            K[5 * 8 + j] = K[27 * 8 + j] = -t25; /* K(1,4) K(4,1) */
            const real t26 = t9 - t12 - t11 - t10;
            K[48 * 8 + j] = K[74 * 8 + j] = t26; /* K(5,8) K(8,5) */
            K[6 * 8 + j] = K[41 * 8 + j] = -t26; /* K(1,5) K(5,1) */
            const real t27 = t3 + t1 + t5 - t7;
            K[62 * 8 + j] = K[75 * 8 + j] = t27; /* K(6,8) K(8,6) */
            K[7 * 8 + j] = K[55 * 8 + j] = -t27; /* K(1,6) K(6,1) */
            const real t28 = t15 + t14 + t16 - t17;
            K[21 * 8 + j] = K[76 * 8 + j] = t28; /* K(3,9) K(9,3) */
            K[8 * 8 + j] = K[14 * 8 + j] = -t28; /* K(2,3) K(3,2) */
            const real t29 = t7 - t1 - t3 - t5;
            K[49 * 8 + j] = K[78 * 8 + j] = t29; /* K(5,9) K(9,5) */
            K[10 * 8 + j] = K[42 * 8 + j] = -t29; /* K(2,5) K(5,2) */
            const real t30 = t9 - t11 - t12 - t10;
            K[63 * 8 + j] = K[79 * 8 + j] = t30; /* K(6,9) K(9,6) */
            K[11 * 8 + j] = K[56 * 8 + j] = -t30; /* K(2,6) K(6,2) */
            const real rq_l3 = x[13 * 8 + j];
            const real tq_1 = p[5 * 8 + j];
            const real rq_l0 = x[10 * 8 + j];
            const real tq_2 = p[6 * 8 + j];
            const real rq_l2 = x[12 * 8 + j];
            const real tq_0 = p[4 * 8 + j];
            const real rq_l1 = x[11 * 8 + j];
            const real tq_3 = p[7 * 8 + j];
            const real u_q_2 = rq_l0 * tq_2 + rq_l2 * tq_0 + rq_l3 * tq_1 - rq_l1 * tq_3;
            const real u_q_3 = rq_l0 * tq_3 + rq_l1 * tq_2 + rq_l3 * tq_0 - rq_l2 * tq_1;
            const real u_q_0 = rq_l0 * tq_0 - rq_l1 * tq_1 - rq_l2 * tq_2 - rq_l3 * tq_3;
            const real u_q_1 = rq_l0 * tq_1 + rq_l1 * tq_0 + rq_l2 * tq_3 - rq_l3 * tq_2;
            const real c0 = u_p_0 * u_q_0 + u_p_1 * u_q_1 + u_p_3 * u_q_3 + u_p_2 * u_q_2;
            const real c1 = u_p_0 * u_q_1 + u_p_3 * u_q_2 - u_p_1 * u_q_0 - u_p_2 * u_q_3;
            const real t31 = 1.0 / (c1 * c1 + c0 * c0);
            const real t32 = t31 * t31;
            const real sigma_angle = sigma[0 * 8 + j];
            const real t33 = u_q_2 * sigma_angle;
            const real t34 = u_q_3 * sigma_angle;
            const real t35 = t32 * (c1 * t33 + c0 * t34);
            const real t36 = 2.0 * t31 * t34;
            const real t37 = 4.0 * c0 * t35 - t36;
            const real q_x = x[7 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t38 = d_x * sigma_axial;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            const real t39 = u_q_1 * u_q_3 - u_q_0 * u_q_2;
            const real sigma_bend1 = sigma[1 * 8 + j];
            const real t40 = d_z * sigma_radial2 + 2.0 * t39 * sigma_bend1;
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t41 = u_q_0 * u_q_3 + u_q_1 * u_q_2;
            const real sigma_bend2 = sigma[2 * 8 + j];
            const real t42 = d_y * sigma_radial1 - 2.0 * t41 * sigma_bend2;
            const real t43 = t40 - t42;
            const real t44 = 2.0 * t31 * t33;
            const real t45 = 4.0 * c1 * t35 - t44;
            const real t46 = u_q_2 * t37 - 2.0 * (t38 + t43) - u_q_3 * t45;
            const real t47 = 2.0 * d_y * sigma_radial2 + 4.0 * t41 * sigma_bend1;
            const real t48 = 2.0 * d_z * sigma_radial1 - 4.0 * t39 * sigma_bend2;
            const real t49 = u_q_3 * t37 + u_q_2 * t45 + t48 + t47;
            const real t50 = tp_3 * t49;
            const real t51 = u_q_1 * sigma_angle;
            const real t52 = u_q_0 * sigma_angle;
            const real t53 = t32 * (c0 * t51 - c1 * t52);
            const real t54 = 2.0 * c1 * t53;
            const real t55 = 2.0 * t31 * t52;
            const real t56 = t55 + t54 + t54;
            const real ex_q_x = u_q_0 * u_q_0 + u_q_1 * u_q_1 - u_q_2 * u_q_2 - u_q_3 * u_q_3;
            const real t57 = 2.0 * (d_x * sigma_radial2 + ex_q_x * sigma_bend1);
            const real t58 = 2.0 * t31 * t51;
            const real t59 = 2.0 * c0 * t53;
            const real t60 = t58 - t59 - t59;
            const real t61 = 2.0 * d_z * sigma_axial;
            const real t62 = t57 + u_q_2 * t60 + u_q_3 * t56 - t61;
            const real t63 = tp_0 * t62;
            const real t64 = 2.0 * (d_x * sigma_radial1 - ex_q_x * sigma_bend2);
            const real t65 = 2.0 * d_y * sigma_axial;
            const real t66 = t32 * (c1 * t51 + c0 * t52);
            const real t67 = 4.0 * c0 * t66 - t55;
            const real t68 = 4.0 * c1 * t66 - t58;
            const real t69 = t65 + u_q_2 * t67 + t64 - u_q_3 * t68;
            const real t70 = tp_1 * t69;
            const real t71 = t32 * (c0 * t33 - c1 * t34);
            const real t72 = 2.0 * c0 * t71;
            const real t73 = t44 - t72 - t72;
            const real t74 = 2.0 * c1 * t71;
            const real t75 = t36 + t74 + t74;
            const real t76 = 2.0 * (t43 - t38) + u_q_3 * t73 - u_q_2 * t75;
            const real t77 = tp_2 * t49;
            const real t78 = t65 + u_q_3 * t60 - t64 - u_q_2 * t56;
            const real t79 = tp_0 * t78;
            const real t80 = u_q_3 * t67 + u_q_2 * t68 + t61 + t57;
            const real t81 = tp_1 * t80;
            const real t82 = tp_3 * t80;
            const real t83 = tp_2 * t69;
            const real t84 = t48 + u_q_1 * t60 + u_q_0 * t56 - t47;
            const real t85 = tp_0 * t84;
            const real t86 = t42 + t40;
            const real t87 = 2.0 * (t38 - t86) + u_q_1 * t67 - u_q_0 * t68;
            const real t88 = tp_3 * t78;
            const real t89 = tp_2 * t62;
            const real t90 = tp_1 * t84;
            const real t91 = 2.0 * (t38 + t86) + u_q_0 * t60 - u_q_1 * t56;
            const real t92 = tp_1 * (t85 + tp_1 * t87 + t83 + t82) + tp_0 * (t90 + tp_0 * t91 + t89 + t88);
            K[15 * 8 + j] = tp_3 * (t79 + t81 + t77 + tp_3 * t76) + t92 + tp_2 * (t63 + t70 + t50 + tp_2 * t46);
                /* K(3,3) */
            const real t93 = tp_0 * t69;
            const real t94 = tp_1 * t62;
            const real t95 = t93 + t77 - t94 - tp_3 * t46;
            const real t96 = tp_0 * t80;
            const real t97 = tp_1 * t78;
            const real t98 = t96 + tp_2 * t76 - t97 - t50;
            const real t99 = tp_2 * t80;
            const real t100 = tp_3 * t69;
            const real t101 = t99 + tp_0 * t87 - t90 - t100;
            const real t102 = tp_2 * t78;
            const real t103 = tp_3 * t62;
            const real t104 = t85 + t102 - tp_1 * t91 - t103;
            K[16 * 8 + j] = K[29 * 8 + j] = tp_1 * t101 + tp_0 * t104 + tp_3 * t98 + tp_2 * t95; /* K(3,4) K(4,3) */
            const real t105 = tp_1 * t49;
            const real t106 = t100 + tp_0 * t46 - t89 - t105;
            const real t107 = tp_0 * t49;
            const real t108 = t82 + t107 - t102 - tp_1 * t76;
            const real t109 = tp_2 * t84;
            const real t110 = t93 + tp_3 * t87 - t109 - t81;
            const real t111 = tp_3 * t84;
            const real t112 = t111 + t63 - tp_2 * t91 - t97;
            K[17 * 8 + j] = K[43 * 8 + j] = tp_1 * t110 + tp_0 * t112 + tp_3 * t108 + tp_2 * t106; /* K(3,5) K(5,3) */
            const real t113 = t107 + tp_1 * t46 - t103 - t83;
            const real t114 = t105 + tp_0 * t76 - t88 - t99;
            const real t115 = t70 + t96 - t111 - tp_2 * t87;
            const real t116 = t94 + t79 - tp_3 * t91 - t109;
            K[18 * 8 + j] = K[57 * 8 + j] = tp_1 * t115 + tp_0 * t116 + tp_3 * t114 + tp_2 * t113; /* K(3,6) K(6,3) */
            const real t117 = u_p_3 * sigma_bend2 + u_p_2 * sigma_bend1;
            const real t118 = 4.0 * u_q_0 * t117;
            const real t119 = u_p_3 * sigma_bend1 - u_p_2 * sigma_bend2;
            const real t120 = 4.0 * u_q_1 * t119;
            const real t121 = t118 + t120;
            const real t122 = u_p_0 * sigma_bend1 - u_p_1 * sigma_bend2;
            const real t123 = 4.0 * u_q_2 * t122;
            const real t124 = sigma_angle * t31;
            const real t125 = 2.0 * c1 * t124;
            const real t126 = u_p_2 * t37 + u_p_3 * t45 + t121 - t123 - t125;
            const real t127 = 4.0 * u_q_0 * t119;
            const real t128 = 4.0 * u_q_3 * t122;
            const real t129 = 2.0 * c0 * t124;
            const real t130 = 4.0 * u_q_1 * t117;
            const real t131 = t127 + u_p_3 * t37 - t128 - t129 - u_p_2 * t45 - t130;
            const real t132 = 4.0 * u_q_2 * t119;
            const real t133 = 4.0 * u_q_1 * t122;
            const real t134 = 4.0 * u_q_3 * t117;
            const real t135 = u_p_1 * t37 + u_p_0 * t45 + t133 + t132 - t134;
            const real t136 = 4.0 * u_q_3 * t119;
            const real t137 = 4.0 * u_q_0 * t122;
            const real t138 = 4.0 * u_q_2 * t117;
            const real t139 = t138 + u_p_0 * t37 + t137 + t136 - u_p_1 * t45;
            const real t140 = tq_1 * t135 + tq_0 * t139 + tq_3 * t131 + tq_2 * t126;
            const real t141 = u_p_0 * sigma_bend2 + u_p_1 * sigma_bend1;
            const real t142 = 4.0 * u_q_2 * t141;
            const real t143 = t129 + u_p_2 * t73 + t130 - t142 - u_p_3 * t75 - t127;
            const real t144 = 4.0 * u_q_3 * t141;
            const real t145 = t121 + u_p_3 * t73 + u_p_2 * t75 - t144 - t125;
            const real t146 = 4.0 * u_q_1 * t141;
            const real t147 = t136 + u_p_1 * t73 + t146 + t138 - u_p_0 * t75;
            const real t148 = 4.0 * u_q_0 * t141;
            const real t149 = u_p_0 * t73 + u_p_1 * t75 + t148 + t134 - t132;
            const real t150 = tq_1 * t147 + tq_0 * t149 + tq_3 * t145 + tq_2 * t143;
            const real t151 = t148 + u_p_2 * t67 + u_p_3 * t68 - t132 - t133;
            const real t152 = u_p_3 * t67 - t136 - u_p_2 * t68 - t146 - t137;
            const real t153 = t120 + u_p_1 * t67 + u_p_0 * t68 - t125 - t144 - t123;
            const real t154 = t142 + u_p_0 * t67 + t127 - t129 - u_p_1 * t68 - t128;
            const real t155 = tq_1 * t153 + tq_0 * t154 + tq_3 * t152 + tq_2 * t151;
            const real t156 = u_p_2 * t60 - t138 - u_p_3 * t56 - t137 - t146;
            const real t157 = t133 + u_p_3 * t60 + u_p_2 * t56 - t134 - t148;
            const real t158 = t129 + u_p_1 * t60 + t128 + t130 - u_p_0 * t56 - t142;
            const real t159 = t118 + u_p_0 * t60 + u_p_1 * t56 - t125 - t123 - t144;
            const real t160 = tq_1 * t158 + tq_0 * t159 + tq_3 * t157 + tq_2 * t156;
            K[22 * 8 + j] = K[80 * 8 + j] = tp_1 * t155 + tp_0 * t160 + tp_3 * t150 + tp_2 * t140;
                /* K(3,10) K(10,3) */
            const real t161 = tq_0 * t135 + tq_2 * t131 - tq_1 * t139 - tq_3 * t126;
            const real t162 = tq_0 * t147 + tq_2 * t145 - tq_1 * t149 - tq_3 * t143;
            const real t163 = tq_0 * t153 + tq_2 * t152 - tq_1 * t154 - tq_3 * t151;
            const real t164 = tq_0 * t158 + tq_2 * t157 - tq_1 * t159 - tq_3 * t156;
            K[23 * 8 + j] = K[88 * 8 + j] = tp_1 * t163 + tp_0 * t164 + tp_3 * t162 + tp_2 * t161;
                /* K(3,11) K(11,3) */
            const real t165 = tq_3 * t135 + tq_0 * t126 - tq_2 * t139 - tq_1 * t131;
            const real t166 = tq_3 * t147 + tq_0 * t143 - tq_2 * t149 - tq_1 * t145;
            const real t167 = tq_3 * t153 + tq_0 * t151 - tq_2 * t154 - tq_1 * t152;
            const real t168 = tq_3 * t158 + tq_0 * t156 - tq_2 * t159 - tq_1 * t157;
            K[24 * 8 + j] = K[96 * 8 + j] = tp_1 * t167 + tp_0 * t168 + tp_3 * t166 + tp_2 * t165;
                /* K(3,12) K(12,3) */
            const real t169 = tq_1 * t126 + tq_0 * t131 - tq_3 * t139 - tq_2 * t135;
            const real t170 = tq_1 * t143 + tq_0 * t145 - tq_3 * t149 - tq_2 * t147;
            const real t171 = tq_1 * t151 + tq_0 * t152 - tq_3 * t154 - tq_2 * t153;
            const real t172 = tq_1 * t156 + tq_0 * t157 - tq_3 * t159 - tq_2 * t158;
            K[25 * 8 + j] = K[104 * 8 + j] = tp_1 * t171 + tp_0 * t172 + tp_3 * t170 + tp_2 * t169;
                /* K(3,13) K(13,3) */
            K[30 * 8 + j] = tp_0 * t101 + tp_2 * t98 - tp_1 * t104 - tp_3 * t95; /* K(4,4) */
            K[31 * 8 + j] = K[44 * 8 + j] = tp_0 * t110 + tp_2 * t108 - tp_1 * t112 - tp_3 * t106; /* K(4,5) K(5,4) */
            K[32 * 8 + j] = K[58 * 8 + j] = tp_0 * t115 + tp_2 * t114 - tp_1 * t116 - tp_3 * t113; /* K(4,6) K(6,4) */
            K[36 * 8 + j] = K[81 * 8 + j] = tp_0 * t155 + tp_2 * t150 - tp_1 * t160 - tp_3 * t140;
                /* K(4,10) K(10,4) */
            K[37 * 8 + j] = K[89 * 8 + j] = tp_0 * t163 + tp_2 * t162 - tp_1 * t164 - tp_3 * t161;
                /* K(4,11) K(11,4) */
            K[38 * 8 + j] = K[97 * 8 + j] = tp_0 * t167 + tp_2 * t166 - tp_1 * t168 - tp_3 * t165;
                /* K(4,12) K(12,4) */
            K[39 * 8 + j] = K[105 * 8 + j] = tp_0 * t171 + tp_2 * t170 - tp_1 * t172 - tp_3 * t169;
                /* K(4,13) K(13,4) */
            K[45 * 8 + j] = tp_3 * t110 + tp_0 * t106 - tp_2 * t112 - tp_1 * t108; /* K(5,5) */
            K[46 * 8 + j] = K[59 * 8 + j] = tp_3 * t115 + tp_0 * t113 - tp_2 * t116 - tp_1 * t114; /* K(5,6) K(6,5) */
            K[50 * 8 + j] = K[82 * 8 + j] = tp_3 * t155 + tp_0 * t140 - tp_2 * t160 - tp_1 * t150;
                /* K(5,10) K(10,5) */
            K[51 * 8 + j] = K[90 * 8 + j] = tp_3 * t163 + tp_0 * t161 - tp_2 * t164 - tp_1 * t162;
                /* K(5,11) K(11,5) */
            K[52 * 8 + j] = K[98 * 8 + j] = tp_3 * t167 + tp_0 * t165 - tp_2 * t168 - tp_1 * t166;
                /* K(5,12) K(12,5) */
            K[53 * 8 + j] = K[106 * 8 + j] = tp_3 * t171 + tp_0 * t169 - tp_2 * t172 - tp_1 * t170;
                /* K(5,13) K(13,5) */
            K[60 * 8 + j] = tp_1 * t113 + tp_0 * t114 - tp_3 * t116 - tp_2 * t115; /* K(6,6) */
            K[64 * 8 + j] = K[83 * 8 + j] = tp_1 * t140 + tp_0 * t150 - tp_3 * t160 - tp_2 * t155;
                /* K(6,10) K(10,6) */
            K[65 * 8 + j] = K[91 * 8 + j] = tp_1 * t161 + tp_0 * t162 - tp_3 * t164 - tp_2 * t163;
                /* K(6,11) K(11,6) */
            K[66 * 8 + j] = K[99 * 8 + j] = tp_1 * t165 + tp_0 * t166 - tp_3 * t168 - tp_2 * t167;
                /* K(6,12) K(12,6) */
            K[67 * 8 + j] = K[107 * 8 + j] = tp_1 * t169 + tp_0 * t170 - tp_3 * t172 - tp_2 * t171;
                /* K(6,13) K(13,6) */
            const real t173 = u_p_3 * sigma_angle;
            const real t174 = 2.0 * t31 * t173;
            const real t175 = u_p_2 * sigma_angle;
            const real t176 = t32 * (c0 * t173 - c1 * t175);
            const real t177 = 2.0 * c0 * t176;
            const real t178 = t174 - t177 - t177;
            const real t179 = (u_p_0 * u_p_2 + u_p_1 * u_p_3) * sigma_bend1 - (u_p_1 * u_p_2 - u_p_0 * u_p_3)
                * sigma_bend2;
            const real t180 = 4.0 * t179;
            const real t181 = 2.0 * c1 * t176;
            const real t182 = 2.0 * t31 * t175;
            const real t183 = t182 + t181 + t181;
            const real t184 = u_p_2 * t178 - t180 - u_p_3 * t183;
            const real t185 = u_p_2 * t183 + u_p_3 * t178;
            const real t186 = tq_3 * t185;
            const real t187 = u_p_0 * sigma_angle;
            const real t188 = u_p_1 * sigma_angle;
            const real t189 = t32 * (c1 * t187 + c0 * t188);
            const real t190 = 2.0 * t31 * t187;
            const real t191 = 4.0 * c1 * t189 - t190;
            const real t192 = 2.0 * t31 * t188;
            const real t193 = 4.0 * c0 * t189 - t192;
            const real t194 = u_p_0 * u_p_0;
            const real t195 = u_p_3 * u_p_3;
            const real t196 = u_p_1 * u_p_1;
            const real t197 = u_p_2 * u_p_2;
            const real ez_p_z = t194 + t195 - t196 - t197;
            const real t198 = u_p_0 * u_p_1;
            const real t199 = u_p_2 * u_p_3;
            const real t200 = 2.0 * ez_p_z * sigma_bend1 - 4.0 * (t198 + t199) * sigma_bend2;
            const real t201 = u_p_3 * t191 + u_p_2 * t193 - t200;
            const real t202 = tq_0 * t201;
            const real ey_p_y = t194 + t197 - t196 - t195;
            const real t203 = 4.0 * (t199 - t198) * sigma_bend1 - 2.0 * ey_p_y * sigma_bend2;
            const real t204 = t32 * (c0 * t187 - c1 * t188);
            const real t205 = 2.0 * c0 * t204;
            const real t206 = t190 - t205 - t205;
            const real t207 = 2.0 * c1 * t204;
            const real t208 = t192 + t207 + t207;
            const real t209 = t203 + u_p_2 * t206 - u_p_3 * t208;
            const real t210 = tq_1 * t209;
            const real t211 = t32 * (c1 * t173 + c0 * t175);
            const real t212 = u_p_3 * (4.0 * c0 * t211 - t182) - t180 - u_p_2 * (4.0 * c1 * t211 - t174);
            const real t213 = tq_2 * t185;
            const real t214 = t203 + u_p_3 * t193 - u_p_2 * t191;
            const real t215 = tq_0 * t214;
            const real t216 = t200 + u_p_3 * t206 + u_p_2 * t208;
            const real t217 = tq_1 * t216;
            const real t218 = tq_3 * t216;
            const real t219 = tq_2 * t209;
            const real t220 = u_p_0 * t191 + u_p_1 * t193;
            const real t221 = tq_0 * t220;
            const real t222 = t180 + u_p_1 * t206 - u_p_0 * t208;
            const real t223 = tq_3 * t214;
            const real t224 = tq_2 * t201;
            const real t225 = tq_1 * t220;
            const real t226 = t180 + u_p_0 * t193 - u_p_1 * t191;
            const real t227 = tq_1 * (t221 + tq_1 * t222 + t219 + t218) + tq_0 * (t225 + tq_0 * t226 + t224 + t223);
            K[84 * 8 + j] = tq_3 * (t215 + t217 + t213 + tq_3 * t212) + t227 + tq_2 * (t202 + t210 + t186 + tq_2
                * t184); /* K(10,10) */
            const real t228 = tq_0 * t209;
            const real t229 = tq_1 * t201;
            const real t230 = t228 + t213 - t229 - tq_3 * t184;
            const real t231 = tq_0 * t216;
            const real t232 = tq_1 * t214;
            const real t233 = t231 + tq_2 * t212 - t232 - t186;
            const real t234 = tq_2 * t216;
            const real t235 = tq_3 * t209;
            const real t236 = t234 + tq_0 * t222 - t225 - t235;
            const real t237 = tq_2 * t214;
            const real t238 = tq_3 * t201;
            const real t239 = t221 + t237 - tq_1 * t226 - t238;
            K[85 * 8 + j] = K[92 * 8 + j] = tq_1 * t236 + tq_0 * t239 + tq_3 * t233 + tq_2 * t230;
                /* K(10,11) K(11,10) */
            const real t240 = tq_1 * t185;
            const real t241 = t235 + tq_0 * t184 - t224 - t240;
            const real t242 = tq_0 * t185;
            const real t243 = t218 + t242 - t237 - tq_1 * t212;
            const real t244 = tq_2 * t220;
            const real t245 = t228 + tq_3 * t222 - t244 - t217;
            const real t246 = tq_3 * t220;
            const real t247 = t246 + t202 - tq_2 * t226 - t232;
            K[86 * 8 + j] = K[100 * 8 + j] = tq_1 * t245 + tq_0 * t247 + tq_3 * t243 + tq_2 * t241;
                /* K(10,12) K(12,10) */
            const real t248 = t242 + tq_1 * t184 - t238 - t219;
            const real t249 = t240 + tq_0 * t212 - t223 - t234;
            const real t250 = t210 + t231 - t246 - tq_2 * t222;
            const real t251 = t229 + t215 - tq_3 * t226 - t244;
            K[87 * 8 + j] = K[108 * 8 + j] = tq_1 * t250 + tq_0 * t251 + tq_3 * t249 + tq_2 * t248;
                /* K(10,13) K(13,10) */
            K[93 * 8 + j] = tq_0 * t236 + tq_2 * t233 - tq_1 * t239 - tq_3 * t230; /* K(11,11) */
            K[94 * 8 + j] = K[101 * 8 + j] = tq_0 * t245 + tq_2 * t243 - tq_1 * t247 - tq_3 * t241;
                /* K(11,12) K(12,11) */
            K[95 * 8 + j] = K[109 * 8 + j] = tq_0 * t250 + tq_2 * t249 - tq_1 * t251 - tq_3 * t248;
                /* K(11,13) K(13,11) */
            K[102 * 8 + j] = tq_3 * t245 + tq_0 * t241 - tq_2 * t247 - tq_1 * t243; /* K(12,12) */
            K[103 * 8 + j] = K[110 * 8 + j] = tq_3 * t250 + tq_0 * t248 - tq_2 * t251 - tq_1 * t249;
                /* K(12,13) K(13,12) */
            K[111 * 8 + j] = tq_1 * t248 + tq_0 * t249 - tq_3 * t251 - tq_2 * t250; /* K(13,13) */
        }
    }
}

/* outputs: 83 operations.
 * in:  x (14), sigma (6), tau (0), p (11)
 * out: axes (3,3), displacement (3) */
FLEXEL_CLONES
static void bearing_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict p = in[3] + b * (11 * 8);
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
            const real d0_x = p[8 * 8 + j];
            const real q_y = x[8 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real q_z = x[9 * 8 + j];
            const real p_z = x[2 * 8 + j];
            const real d_z = q_z - p_z;
            displacement[0 * 8 + j] = ex_p_x * d_x - d0_x + 2.0 * (t6 * d_y + t9 * d_z);
            const real d0_y = p[9 * 8 + j];
            displacement[1 * 8 + j] = ey_p_y * d_y - d0_y + 2.0 * (t10 * d_x + t13 * d_z);
            const real d0_z = p[10 * 8 + j];
            displacement[2 * 8 + j] = ez_p_z * d_z - d0_z + 2.0 * (t14 * d_x + t15 * d_y);
        }
    }
}

const flexel_element flexel_bearing = {
    .name = "bearing",
    .digest = "5383bbccd03488ff",
    .n = 14,
    .m = 6,
    .k = 0,
    .np = 11,
    .position = bearing_position,
    .acceleration = bearing_acceleration,
    .rates = bearing_rates,
    .kinematics = bearing_kinematics,
    .stiffness = bearing_stiffness,
    .outputs = bearing_outputs,
};
