/* planar_flat_cam: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * n: normal of the face, direction angle_q + alphaq0;  (a, b) = components of n on ex, ey (angle_p + alpha0)
 * psi = atan2(b, a), u = 48 psi/(2 pi), between i and i + 1; t = u - i
 * h = sum over j = 0 ... 5 of control[(i + j - 2) mod 48] B_j(t), uniform B-splines of degree five
 * gap = n.(xq - xp) - h
 * profile: places h (cos psi, sin psi) + h' (-sin psi, cos psi) at the knots;  mark: from the centre to its start
 * face: line across n, to both sides 1.2 times as far as the contact travels
 * origin_p: xp, axes_p: ex, ey (angle_p + alpha0) in rows: the frame that carries profile and mark
 * origin_q: xq, axes_q: n and the directions across it in rows: the frame that carries the face
 *
 * Source: support function of a convex cam; de Boor 1978, A Practical Guide to Splines
 *
 * x (6): p_x, p_y, rp_angle, q_x, q_y, rq_angle
 * e (1): gap [m]
 * s (0): none
 * p (50):
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   alphaq0 (1) [rad]: initial direction of the element minus the angle of node q
 *   control (48) [m]: control values of the periodic spline of degree five, its knots at equal steps of the angle */
#include "kernels.h"

/* position: 518 operations.
 * in:  x (6), p (50)
 * out: e (1), De (1,6), V (0,6) */
FLEXEL_CLONES
static void planar_flat_cam_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (50 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (6 * 8);
        real t0[8], cos_q[8], d_x[8], sin_q[8], d_y[8], t1[8], t2[8], cos_p[8], sin_p[8], b_[8], a_[8], psi[8],
            t194[8], t195[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[1 * 8 + j];
            t0[j] = rq_angle + alphaq0;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t2[j] = rp_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_q[j] = real_cos(t0[j]);
            De[3 * 8 + j] = cos_q[j]; /* De(0,3) */
            sin_q[j] = real_sin(t0[j]);
            De[4 * 8 + j] = sin_q[j]; /* De(0,4) */
            cos_p[j] = real_cos(t2[j]);
            sin_p[j] = real_sin(t2[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            t1[j] = cos_q[j] * d_x[j] + sin_q[j] * d_y[j];
            b_[j] = cos_p[j] * sin_q[j] - sin_p[j] * cos_q[j];
            a_[j] = cos_p[j] * cos_q[j] + sin_p[j] * sin_q[j];
            De[0 * 8 + j] = -cos_q[j]; /* De(0,0) */
            De[1 * 8 + j] = -sin_q[j]; /* De(0,1) */
            t194[j] = cos_q[j] * d_y[j];
            t195[j] = sin_q[j] * d_x[j];
        }
        for (size_t j = 0; j < 8; j++) {
            psi[j] = real_atan2(b_[j], a_[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real u = 7.639437268410976 * psi[j];
            const real control_21 = p[23 * 8 + j];
            const real control_22 = p[24 * 8 + j];
            const real control_20 = p[22 * 8 + j];
            const real t3 = real_lt(u, 22.0) ? control_20 : (real_lt(u, 23.0) ? control_21 : control_22);
            const real control_19 = p[21 * 8 + j];
            const real control_18 = p[20 * 8 + j];
            const real t4 = real_lt(u, 20.0) ? control_18 : (real_lt(u, 21.0) ? control_19 : t3);
            const real control_17 = p[19 * 8 + j];
            const real control_16 = p[18 * 8 + j];
            const real t5 = real_lt(u, 18.0) ? control_16 : (real_lt(u, 19.0) ? control_17 : t4);
            const real control_15 = p[17 * 8 + j];
            const real control_14 = p[16 * 8 + j];
            const real t6 = real_lt(u, 16.0) ? control_14 : (real_lt(u, 17.0) ? control_15 : t5);
            const real control_13 = p[15 * 8 + j];
            const real control_12 = p[14 * 8 + j];
            const real t7 = real_lt(u, 14.0) ? control_12 : (real_lt(u, 15.0) ? control_13 : t6);
            const real control_11 = p[13 * 8 + j];
            const real control_10 = p[12 * 8 + j];
            const real t8 = real_lt(u, 12.0) ? control_10 : (real_lt(u, 13.0) ? control_11 : t7);
            const real control_9 = p[11 * 8 + j];
            const real control_8 = p[10 * 8 + j];
            const real t9 = real_lt(u, 10.0) ? control_8 : (real_lt(u, 11.0) ? control_9 : t8);
            const real control_7 = p[9 * 8 + j];
            const real control_6 = p[8 * 8 + j];
            const real t10 = real_lt(u, 8.0) ? control_6 : (real_lt(u, 9.0) ? control_7 : t9);
            const real control_5 = p[7 * 8 + j];
            const real control_4 = p[6 * 8 + j];
            const real t11 = real_lt(u, 6.0) ? control_4 : (real_lt(u, 7.0) ? control_5 : t10);
            const real control_3 = p[5 * 8 + j];
            const real control_2 = p[4 * 8 + j];
            const real t12 = real_lt(u, 4.0) ? control_2 : (real_lt(u, 5.0) ? control_3 : t11);
            const real control_1 = p[3 * 8 + j];
            const real control_0 = p[2 * 8 + j];
            const real t13 = real_lt(u, 2.0) ? control_0 : (real_lt(u, 3.0) ? control_1 : t12);
            const real control_47 = p[49 * 8 + j];
            const real control_46 = p[48 * 8 + j];
            const real t14 = real_lt(u, 0.0) ? control_46 : (real_lt(u, 1.0) ? control_47 : t13);
            const real control_45 = p[47 * 8 + j];
            const real control_44 = p[46 * 8 + j];
            const real t15 = real_lt(u, -2.0) ? control_44 : (real_lt(u, -1.0) ? control_45 : t14);
            const real control_43 = p[45 * 8 + j];
            const real control_42 = p[44 * 8 + j];
            const real t16 = real_lt(u, -4.0) ? control_42 : (real_lt(u, -3.0) ? control_43 : t15);
            const real control_41 = p[43 * 8 + j];
            const real control_40 = p[42 * 8 + j];
            const real t17 = real_lt(u, -6.0) ? control_40 : (real_lt(u, -5.0) ? control_41 : t16);
            const real control_39 = p[41 * 8 + j];
            const real control_38 = p[40 * 8 + j];
            const real t18 = real_lt(u, -8.0) ? control_38 : (real_lt(u, -7.0) ? control_39 : t17);
            const real control_37 = p[39 * 8 + j];
            const real control_36 = p[38 * 8 + j];
            const real t19 = real_lt(u, -10.0) ? control_36 : (real_lt(u, -9.0) ? control_37 : t18);
            const real control_35 = p[37 * 8 + j];
            const real control_34 = p[36 * 8 + j];
            const real t20 = real_lt(u, -12.0) ? control_34 : (real_lt(u, -11.0) ? control_35 : t19);
            const real control_33 = p[35 * 8 + j];
            const real control_32 = p[34 * 8 + j];
            const real t21 = real_lt(u, -14.0) ? control_32 : (real_lt(u, -13.0) ? control_33 : t20);
            const real control_31 = p[33 * 8 + j];
            const real control_30 = p[32 * 8 + j];
            const real t22 = real_lt(u, -16.0) ? control_30 : (real_lt(u, -15.0) ? control_31 : t21);
            const real control_29 = p[31 * 8 + j];
            const real control_28 = p[30 * 8 + j];
            const real t23 = real_lt(u, -18.0) ? control_28 : (real_lt(u, -17.0) ? control_29 : t22);
            const real control_27 = p[29 * 8 + j];
            const real control_26 = p[28 * 8 + j];
            const real t24 = real_lt(u, -20.0) ? control_26 : (real_lt(u, -19.0) ? control_27 : t23);
            const real control_25 = p[27 * 8 + j];
            const real control_24 = p[26 * 8 + j];
            const real t25 = real_lt(u, -22.0) ? control_24 : (real_lt(u, -21.0) ? control_25 : t24);
            const real control_23 = p[25 * 8 + j];
            const real c1 = real_lt(u, -23.0) ? control_23 : t25;
            const real t26 = real_lt(u, 22.0) ? 21.0 : (real_lt(u, 23.0) ? 22.0 : 23.0);
            const real t27 = real_lt(u, 20.0) ? 19.0 : (real_lt(u, 21.0) ? 20.0 : t26);
            const real t28 = real_lt(u, 18.0) ? 17.0 : (real_lt(u, 19.0) ? 18.0 : t27);
            const real t29 = real_lt(u, 16.0) ? 15.0 : (real_lt(u, 17.0) ? 16.0 : t28);
            const real t30 = real_lt(u, 14.0) ? 13.0 : (real_lt(u, 15.0) ? 14.0 : t29);
            const real t31 = real_lt(u, 12.0) ? 11.0 : (real_lt(u, 13.0) ? 12.0 : t30);
            const real t32 = real_lt(u, 9.0) ? 8.0 : (real_lt(u, 10.0) ? 9.0 : (real_lt(u, 11.0) ? 10.0 : t31));
            const real t33 = real_lt(u, 6.0) ? 5.0 : (real_lt(u, 7.0) ? 6.0 : (real_lt(u, 8.0) ? 7.0 : t32));
            const real t34 = real_lt(u, 3.0) ? 2.0 : (real_lt(u, 4.0) ? 3.0 : (real_lt(u, 5.0) ? 4.0 : t33));
            const real t35 = real_lt(u, 0.0) ? -1.0 : (real_lt(u, 1.0) ? 0.0 : (real_lt(u, 2.0) ? 1.0 : t34));
            const real t36 = real_lt(u, -2.0) ? -3.0 : (real_lt(u, -1.0) ? -2.0 : t35);
            const real t37 = real_lt(u, -4.0) ? -5.0 : (real_lt(u, -3.0) ? -4.0 : t36);
            const real t38 = real_lt(u, -6.0) ? -7.0 : (real_lt(u, -5.0) ? -6.0 : t37);
            const real t39 = real_lt(u, -8.0) ? -9.0 : (real_lt(u, -7.0) ? -8.0 : t38);
            const real t40 = real_lt(u, -10.0) ? -11.0 : (real_lt(u, -9.0) ? -10.0 : t39);
            const real t41 = real_lt(u, -12.0) ? -13.0 : (real_lt(u, -11.0) ? -12.0 : t40);
            const real t42 = real_lt(u, -14.0) ? -15.0 : (real_lt(u, -13.0) ? -14.0 : t41);
            const real t43 = real_lt(u, -16.0) ? -17.0 : (real_lt(u, -15.0) ? -16.0 : t42);
            const real t44 = real_lt(u, -18.0) ? -19.0 : (real_lt(u, -17.0) ? -18.0 : t43);
            const real t45 = real_lt(u, -20.0) ? -21.0 : (real_lt(u, -19.0) ? -20.0 : t44);
            const real t46 = real_lt(u, -22.0) ? -23.0 : (real_lt(u, -21.0) ? -22.0 : t45);
            const real t_ = u - (real_lt(u, -23.0) ? -24.0 : t46);
            const real t47 = 4.0 + t_;
            const real t48 = t47 * t47 * (t47 * t47);
            const real t49 = t47 * t48;
            const real t50 = t_ * t_ * (t_ * t_);
            const real t51 = t_ * t50;
            const real t52 = 2.0 + t_;
            const real t53 = t52 * t52 * (t52 * t52);
            const real t54 = t52 * t53;
            const real t55 = 1.0 + t_;
            const real t56 = t55 * t55 * (t55 * t55);
            const real t57 = t55 * t56;
            const real t58 = 0.008333333333333333 * t49 + 0.125 * (t51 + t54) - 0.16666666666666666 * t57;
            const real t59 = 3.0 + t_;
            const real t60 = t59 * t59 * (t59 * t59);
            const real t61 = t59 * t60;
            const real t62 = real_lt(u, 22.0) ? control_19 : (real_lt(u, 23.0) ? control_20 : control_21);
            const real t63 = real_lt(u, 20.0) ? control_17 : (real_lt(u, 21.0) ? control_18 : t62);
            const real t64 = real_lt(u, 18.0) ? control_15 : (real_lt(u, 19.0) ? control_16 : t63);
            const real t65 = real_lt(u, 16.0) ? control_13 : (real_lt(u, 17.0) ? control_14 : t64);
            const real t66 = real_lt(u, 14.0) ? control_11 : (real_lt(u, 15.0) ? control_12 : t65);
            const real t67 = real_lt(u, 12.0) ? control_9 : (real_lt(u, 13.0) ? control_10 : t66);
            const real t68 = real_lt(u, 10.0) ? control_7 : (real_lt(u, 11.0) ? control_8 : t67);
            const real t69 = real_lt(u, 8.0) ? control_5 : (real_lt(u, 9.0) ? control_6 : t68);
            const real t70 = real_lt(u, 6.0) ? control_3 : (real_lt(u, 7.0) ? control_4 : t69);
            const real t71 = real_lt(u, 4.0) ? control_1 : (real_lt(u, 5.0) ? control_2 : t70);
            const real t72 = real_lt(u, 2.0) ? control_47 : (real_lt(u, 3.0) ? control_0 : t71);
            const real t73 = real_lt(u, 0.0) ? control_45 : (real_lt(u, 1.0) ? control_46 : t72);
            const real t74 = real_lt(u, -2.0) ? control_43 : (real_lt(u, -1.0) ? control_44 : t73);
            const real t75 = real_lt(u, -4.0) ? control_41 : (real_lt(u, -3.0) ? control_42 : t74);
            const real t76 = real_lt(u, -6.0) ? control_39 : (real_lt(u, -5.0) ? control_40 : t75);
            const real t77 = real_lt(u, -8.0) ? control_37 : (real_lt(u, -7.0) ? control_38 : t76);
            const real t78 = real_lt(u, -10.0) ? control_35 : (real_lt(u, -9.0) ? control_36 : t77);
            const real t79 = real_lt(u, -12.0) ? control_33 : (real_lt(u, -11.0) ? control_34 : t78);
            const real t80 = real_lt(u, -14.0) ? control_31 : (real_lt(u, -13.0) ? control_32 : t79);
            const real t81 = real_lt(u, -16.0) ? control_29 : (real_lt(u, -15.0) ? control_30 : t80);
            const real t82 = real_lt(u, -18.0) ? control_27 : (real_lt(u, -17.0) ? control_28 : t81);
            const real t83 = real_lt(u, -20.0) ? control_25 : (real_lt(u, -19.0) ? control_26 : t82);
            const real t84 = real_lt(u, -22.0) ? control_23 : (real_lt(u, -21.0) ? control_24 : t83);
            const real c0 = real_lt(u, -23.0) ? control_22 : t84;
            const real t85 = 5.0 + t_;
            const real t86 = t85 * t85 * (t85 * t85);
            const real t87 = 0.008333333333333333 * (t85 * t86) + 0.125 * (t57 + t61) - 0.05 * (t51 + t49);
            const real t88 = real_lt(u, 22.0) ? control_21 : (real_lt(u, 23.0) ? control_22 : control_23);
            const real t89 = real_lt(u, 20.0) ? control_19 : (real_lt(u, 21.0) ? control_20 : t88);
            const real t90 = real_lt(u, 18.0) ? control_17 : (real_lt(u, 19.0) ? control_18 : t89);
            const real t91 = real_lt(u, 16.0) ? control_15 : (real_lt(u, 17.0) ? control_16 : t90);
            const real t92 = real_lt(u, 14.0) ? control_13 : (real_lt(u, 15.0) ? control_14 : t91);
            const real t93 = real_lt(u, 12.0) ? control_11 : (real_lt(u, 13.0) ? control_12 : t92);
            const real t94 = real_lt(u, 10.0) ? control_9 : (real_lt(u, 11.0) ? control_10 : t93);
            const real t95 = real_lt(u, 8.0) ? control_7 : (real_lt(u, 9.0) ? control_8 : t94);
            const real t96 = real_lt(u, 6.0) ? control_5 : (real_lt(u, 7.0) ? control_6 : t95);
            const real t97 = real_lt(u, 4.0) ? control_3 : (real_lt(u, 5.0) ? control_4 : t96);
            const real t98 = real_lt(u, 2.0) ? control_1 : (real_lt(u, 3.0) ? control_2 : t97);
            const real t99 = real_lt(u, 0.0) ? control_47 : (real_lt(u, 1.0) ? control_0 : t98);
            const real t100 = real_lt(u, -2.0) ? control_45 : (real_lt(u, -1.0) ? control_46 : t99);
            const real t101 = real_lt(u, -4.0) ? control_43 : (real_lt(u, -3.0) ? control_44 : t100);
            const real t102 = real_lt(u, -6.0) ? control_41 : (real_lt(u, -5.0) ? control_42 : t101);
            const real t103 = real_lt(u, -8.0) ? control_39 : (real_lt(u, -7.0) ? control_40 : t102);
            const real t104 = real_lt(u, -10.0) ? control_37 : (real_lt(u, -9.0) ? control_38 : t103);
            const real t105 = real_lt(u, -12.0) ? control_35 : (real_lt(u, -11.0) ? control_36 : t104);
            const real t106 = real_lt(u, -14.0) ? control_33 : (real_lt(u, -13.0) ? control_34 : t105);
            const real t107 = real_lt(u, -16.0) ? control_31 : (real_lt(u, -15.0) ? control_32 : t106);
            const real t108 = real_lt(u, -18.0) ? control_29 : (real_lt(u, -17.0) ? control_30 : t107);
            const real t109 = real_lt(u, -20.0) ? control_27 : (real_lt(u, -19.0) ? control_28 : t108);
            const real t110 = real_lt(u, -22.0) ? control_25 : (real_lt(u, -21.0) ? control_26 : t109);
            const real c2 = real_lt(u, -23.0) ? control_24 : t110;
            const real t111 = 0.125 * t57 + 0.008333333333333333 * t61 - 0.16666666666666666 * t51;
            const real t112 = real_lt(u, 22.0) ? control_22 : (real_lt(u, 23.0) ? control_23 : control_24);
            const real t113 = real_lt(u, 20.0) ? control_20 : (real_lt(u, 21.0) ? control_21 : t112);
            const real t114 = real_lt(u, 18.0) ? control_18 : (real_lt(u, 19.0) ? control_19 : t113);
            const real t115 = real_lt(u, 16.0) ? control_16 : (real_lt(u, 17.0) ? control_17 : t114);
            const real t116 = real_lt(u, 14.0) ? control_14 : (real_lt(u, 15.0) ? control_15 : t115);
            const real t117 = real_lt(u, 12.0) ? control_12 : (real_lt(u, 13.0) ? control_13 : t116);
            const real t118 = real_lt(u, 10.0) ? control_10 : (real_lt(u, 11.0) ? control_11 : t117);
            const real t119 = real_lt(u, 8.0) ? control_8 : (real_lt(u, 9.0) ? control_9 : t118);
            const real t120 = real_lt(u, 6.0) ? control_6 : (real_lt(u, 7.0) ? control_7 : t119);
            const real t121 = real_lt(u, 4.0) ? control_4 : (real_lt(u, 5.0) ? control_5 : t120);
            const real t122 = real_lt(u, 2.0) ? control_2 : (real_lt(u, 3.0) ? control_3 : t121);
            const real t123 = real_lt(u, 0.0) ? control_0 : (real_lt(u, 1.0) ? control_1 : t122);
            const real t124 = real_lt(u, -2.0) ? control_46 : (real_lt(u, -1.0) ? control_47 : t123);
            const real t125 = real_lt(u, -4.0) ? control_44 : (real_lt(u, -3.0) ? control_45 : t124);
            const real t126 = real_lt(u, -6.0) ? control_42 : (real_lt(u, -5.0) ? control_43 : t125);
            const real t127 = real_lt(u, -8.0) ? control_40 : (real_lt(u, -7.0) ? control_41 : t126);
            const real t128 = real_lt(u, -10.0) ? control_38 : (real_lt(u, -9.0) ? control_39 : t127);
            const real t129 = real_lt(u, -12.0) ? control_36 : (real_lt(u, -11.0) ? control_37 : t128);
            const real t130 = real_lt(u, -14.0) ? control_34 : (real_lt(u, -13.0) ? control_35 : t129);
            const real t131 = real_lt(u, -16.0) ? control_32 : (real_lt(u, -15.0) ? control_33 : t130);
            const real t132 = real_lt(u, -18.0) ? control_30 : (real_lt(u, -17.0) ? control_31 : t131);
            const real t133 = real_lt(u, -20.0) ? control_28 : (real_lt(u, -19.0) ? control_29 : t132);
            const real t134 = real_lt(u, -22.0) ? control_26 : (real_lt(u, -21.0) ? control_27 : t133);
            const real c3 = real_lt(u, -23.0) ? control_25 : t134;
            const real t135 = c3 * (0.125 * t51 + 0.008333333333333333 * t54 - 0.05 * t57);
            const real t136 = real_lt(u, 22.0) ? control_23 : (real_lt(u, 23.0) ? control_24 : control_25);
            const real t137 = real_lt(u, 20.0) ? control_21 : (real_lt(u, 21.0) ? control_22 : t136);
            const real t138 = real_lt(u, 18.0) ? control_19 : (real_lt(u, 19.0) ? control_20 : t137);
            const real t139 = real_lt(u, 16.0) ? control_17 : (real_lt(u, 17.0) ? control_18 : t138);
            const real t140 = real_lt(u, 14.0) ? control_15 : (real_lt(u, 15.0) ? control_16 : t139);
            const real t141 = real_lt(u, 12.0) ? control_13 : (real_lt(u, 13.0) ? control_14 : t140);
            const real t142 = real_lt(u, 10.0) ? control_11 : (real_lt(u, 11.0) ? control_12 : t141);
            const real t143 = real_lt(u, 8.0) ? control_9 : (real_lt(u, 9.0) ? control_10 : t142);
            const real t144 = real_lt(u, 6.0) ? control_7 : (real_lt(u, 7.0) ? control_8 : t143);
            const real t145 = real_lt(u, 4.0) ? control_5 : (real_lt(u, 5.0) ? control_6 : t144);
            const real t146 = real_lt(u, 2.0) ? control_3 : (real_lt(u, 3.0) ? control_4 : t145);
            const real t147 = real_lt(u, 0.0) ? control_1 : (real_lt(u, 1.0) ? control_2 : t146);
            const real t148 = real_lt(u, -2.0) ? control_47 : (real_lt(u, -1.0) ? control_0 : t147);
            const real t149 = real_lt(u, -4.0) ? control_45 : (real_lt(u, -3.0) ? control_46 : t148);
            const real t150 = real_lt(u, -6.0) ? control_43 : (real_lt(u, -5.0) ? control_44 : t149);
            const real t151 = real_lt(u, -8.0) ? control_41 : (real_lt(u, -7.0) ? control_42 : t150);
            const real t152 = real_lt(u, -10.0) ? control_39 : (real_lt(u, -9.0) ? control_40 : t151);
            const real t153 = real_lt(u, -12.0) ? control_37 : (real_lt(u, -11.0) ? control_38 : t152);
            const real t154 = real_lt(u, -14.0) ? control_35 : (real_lt(u, -13.0) ? control_36 : t153);
            const real t155 = real_lt(u, -16.0) ? control_33 : (real_lt(u, -15.0) ? control_34 : t154);
            const real t156 = real_lt(u, -18.0) ? control_31 : (real_lt(u, -17.0) ? control_32 : t155);
            const real t157 = real_lt(u, -20.0) ? control_29 : (real_lt(u, -19.0) ? control_30 : t156);
            const real t158 = real_lt(u, -22.0) ? control_27 : (real_lt(u, -21.0) ? control_28 : t157);
            const real c4 = real_lt(u, -23.0) ? control_26 : t158;
            const real t159 = real_lt(u, 22.0) ? control_24 : (real_lt(u, 23.0) ? control_25 : control_26);
            const real t160 = real_lt(u, 20.0) ? control_22 : (real_lt(u, 21.0) ? control_23 : t159);
            const real t161 = real_lt(u, 18.0) ? control_20 : (real_lt(u, 19.0) ? control_21 : t160);
            const real t162 = real_lt(u, 16.0) ? control_18 : (real_lt(u, 17.0) ? control_19 : t161);
            const real t163 = real_lt(u, 14.0) ? control_16 : (real_lt(u, 15.0) ? control_17 : t162);
            const real t164 = real_lt(u, 12.0) ? control_14 : (real_lt(u, 13.0) ? control_15 : t163);
            const real t165 = real_lt(u, 10.0) ? control_12 : (real_lt(u, 11.0) ? control_13 : t164);
            const real t166 = real_lt(u, 8.0) ? control_10 : (real_lt(u, 9.0) ? control_11 : t165);
            const real t167 = real_lt(u, 6.0) ? control_8 : (real_lt(u, 7.0) ? control_9 : t166);
            const real t168 = real_lt(u, 4.0) ? control_6 : (real_lt(u, 5.0) ? control_7 : t167);
            const real t169 = real_lt(u, 2.0) ? control_4 : (real_lt(u, 3.0) ? control_5 : t168);
            const real t170 = real_lt(u, 0.0) ? control_2 : (real_lt(u, 1.0) ? control_3 : t169);
            const real t171 = real_lt(u, -2.0) ? control_0 : (real_lt(u, -1.0) ? control_1 : t170);
            const real t172 = real_lt(u, -4.0) ? control_46 : (real_lt(u, -3.0) ? control_47 : t171);
            const real t173 = real_lt(u, -6.0) ? control_44 : (real_lt(u, -5.0) ? control_45 : t172);
            const real t174 = real_lt(u, -8.0) ? control_42 : (real_lt(u, -7.0) ? control_43 : t173);
            const real t175 = real_lt(u, -10.0) ? control_40 : (real_lt(u, -9.0) ? control_41 : t174);
            const real t176 = real_lt(u, -12.0) ? control_38 : (real_lt(u, -11.0) ? control_39 : t175);
            const real t177 = real_lt(u, -14.0) ? control_36 : (real_lt(u, -13.0) ? control_37 : t176);
            const real t178 = real_lt(u, -16.0) ? control_34 : (real_lt(u, -15.0) ? control_35 : t177);
            const real t179 = real_lt(u, -18.0) ? control_32 : (real_lt(u, -17.0) ? control_33 : t178);
            const real t180 = real_lt(u, -20.0) ? control_30 : (real_lt(u, -19.0) ? control_31 : t179);
            const real t181 = real_lt(u, -22.0) ? control_28 : (real_lt(u, -21.0) ? control_29 : t180);
            const real c5 = real_lt(u, -23.0) ? control_27 : t181;
            const real t182 = c4 * (0.008333333333333333 * t57 - 0.05 * t51) + 0.008333333333333333 * (c5 * t51);
            const real t183 = t135 + t182 + c2 * (t111 - 0.05 * t54) + c0 * (t87 - 0.16666666666666666 * t54);
            const real h_ = c1 * (t58 - 0.05 * t61) + t183;
            e[0 * 8 + j] = t1[j] - h_;
            const real t184 = 38.19718634205488 * t50;
            const real t185 = 6.366197723675813 * t53 + 0.05 * (t184 + 38.19718634205488 * t48);
            const real t186 = t185 - 0.3183098861837907 * t86 - 4.77464829275686 * (t56 + t60);
            const real t187 = 1.909859317102744 * t60 + 6.366197723675813 * t56 - 0.3183098861837907 * t48;
            const real t188 = 1.909859317102744 * t53 + 6.366197723675813 * t50 - 4.77464829275686 * t56;
            const real t189 = c4 * (1.909859317102744 * t50 - 0.3183098861837907 * t56);
            const real t190 = 1.909859317102744 * t56 - 4.77464829275686 * t50 - 0.3183098861837907 * t53;
            const real t191 = t189 + c3 * t190 + c2 * (t188 - 0.3183098861837907 * t60);
            const real t192 = c1 * (t187 - 0.125 * (t184 + 38.19718634205488 * t53)) + t191;
            const real t193 = c0 * t186 + t192 - 0.3183098861837907 * (c5 * t50);
            De[2 * 8 + j] = -t193; /* De(0,2) */
            De[5 * 8 + j] = t194[j] + t193 - t195[j]; /* De(0,5) */
        }
    }
}

/* acceleration: 653 operations.
 * in:  x (6), v (6), p (50)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void planar_flat_cam_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (50 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real t0[8], cos_q[8], t2[8], d_y[8], sin_q[8], t6[8], d_x[8], t9[8], t10[8], cos_p[8], sin_p[8], b_[8], a_[8],
            psi[8], t41[8], t75[8], t77[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[1 * 8 + j];
            t0[j] = rq_angle + alphaq0;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t2[j] = q_vy - p_vy;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t6[j] = q_vx - p_vx;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t10[j] = rp_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_q[j] = real_cos(t0[j]);
            sin_q[j] = real_sin(t0[j]);
            cos_p[j] = real_cos(t10[j]);
            sin_p[j] = real_sin(t10[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_vangle = v[5 * 8 + j];
            const real t1 = rq_vangle * cos_q[j];
            const real t3 = t1 * t2[j];
            const real t4 = rq_vangle * sin_q[j];
            const real t5 = rq_vangle * t4;
            const real t7 = t4 * t6[j];
            const real t8 = rq_vangle * t1;
            t9[j] = t3 - d_y[j] * t5 + t3 - (t7 + d_x[j] * t8 + t7);
            b_[j] = cos_p[j] * sin_q[j] - sin_p[j] * cos_q[j];
            a_[j] = cos_p[j] * cos_q[j] + sin_p[j] * sin_q[j];
            const real t34 = 1.0 / (b_[j] * b_[j] + a_[j] * a_[j]);
            const real t35 = a_[j] * t34;
            const real rp_vangle = v[2 * 8 + j];
            const real t36 = rp_vangle * sin_p[j];
            const real t37 = rp_vangle * cos_p[j];
            const real t38 = cos_p[j] * t1 - sin_q[j] * t36 - (cos_q[j] * t37 - sin_p[j] * t4);
            const real t39 = b_[j] * t34;
            const real t40 = sin_q[j] * t37 + sin_p[j] * t1 - (cos_q[j] * t36 + cos_p[j] * t4);
            t41[j] = t35 * t38 - t39 * t40;
            const real t66 = t34 * t34 * (2.0 * b_[j] * t38 + 2.0 * a_[j] * t40);
            const real t67 = t37 * t4;
            const real t68 = rp_vangle * t36;
            const real t69 = t36 * t1;
            const real t70 = rp_vangle * t37;
            const real t71 = t67 + cos_q[j] * t68 + (t67 + sin_p[j] * t8) - (t69 + sin_q[j] * t70 + (t69 + cos_p[j]
                * t5));
            const real t72 = t37 * t1;
            const real t73 = t36 * t4;
            const real t74 = t72 - sin_q[j] * t68 + (t72 - sin_p[j] * t5) - (cos_q[j] * t70 - t73 + (cos_p[j] * t8
                - t73));
            t75[j] = t38 * (t34 * t40 - a_[j] * t66) + t35 * t71 - (t40 * (t34 * t38 - b_[j] * t66) + t39 * t74);
            t77[j] = 7.639437268410976 * (t41[j] * t41[j]);
        }
        for (size_t j = 0; j < 8; j++) {
            psi[j] = real_atan2(b_[j], a_[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real u = 7.639437268410976 * psi[j];
            const real control_25 = p[27 * 8 + j];
            const real control_26 = p[28 * 8 + j];
            const real control_24 = p[26 * 8 + j];
            const real t11 = real_lt(u, 22.0) ? control_24 : (real_lt(u, 23.0) ? control_25 : control_26);
            const real control_23 = p[25 * 8 + j];
            const real control_22 = p[24 * 8 + j];
            const real t12 = real_lt(u, 20.0) ? control_22 : (real_lt(u, 21.0) ? control_23 : t11);
            const real control_21 = p[23 * 8 + j];
            const real control_20 = p[22 * 8 + j];
            const real t13 = real_lt(u, 18.0) ? control_20 : (real_lt(u, 19.0) ? control_21 : t12);
            const real control_19 = p[21 * 8 + j];
            const real control_18 = p[20 * 8 + j];
            const real t14 = real_lt(u, 16.0) ? control_18 : (real_lt(u, 17.0) ? control_19 : t13);
            const real control_17 = p[19 * 8 + j];
            const real control_16 = p[18 * 8 + j];
            const real t15 = real_lt(u, 14.0) ? control_16 : (real_lt(u, 15.0) ? control_17 : t14);
            const real control_15 = p[17 * 8 + j];
            const real control_14 = p[16 * 8 + j];
            const real t16 = real_lt(u, 12.0) ? control_14 : (real_lt(u, 13.0) ? control_15 : t15);
            const real control_13 = p[15 * 8 + j];
            const real control_12 = p[14 * 8 + j];
            const real t17 = real_lt(u, 10.0) ? control_12 : (real_lt(u, 11.0) ? control_13 : t16);
            const real control_11 = p[13 * 8 + j];
            const real control_10 = p[12 * 8 + j];
            const real t18 = real_lt(u, 8.0) ? control_10 : (real_lt(u, 9.0) ? control_11 : t17);
            const real control_9 = p[11 * 8 + j];
            const real control_8 = p[10 * 8 + j];
            const real t19 = real_lt(u, 6.0) ? control_8 : (real_lt(u, 7.0) ? control_9 : t18);
            const real control_7 = p[9 * 8 + j];
            const real control_6 = p[8 * 8 + j];
            const real t20 = real_lt(u, 4.0) ? control_6 : (real_lt(u, 5.0) ? control_7 : t19);
            const real control_5 = p[7 * 8 + j];
            const real control_4 = p[6 * 8 + j];
            const real t21 = real_lt(u, 2.0) ? control_4 : (real_lt(u, 3.0) ? control_5 : t20);
            const real control_3 = p[5 * 8 + j];
            const real control_2 = p[4 * 8 + j];
            const real t22 = real_lt(u, 0.0) ? control_2 : (real_lt(u, 1.0) ? control_3 : t21);
            const real control_1 = p[3 * 8 + j];
            const real control_0 = p[2 * 8 + j];
            const real t23 = real_lt(u, -2.0) ? control_0 : (real_lt(u, -1.0) ? control_1 : t22);
            const real control_47 = p[49 * 8 + j];
            const real control_46 = p[48 * 8 + j];
            const real t24 = real_lt(u, -4.0) ? control_46 : (real_lt(u, -3.0) ? control_47 : t23);
            const real control_45 = p[47 * 8 + j];
            const real control_44 = p[46 * 8 + j];
            const real t25 = real_lt(u, -6.0) ? control_44 : (real_lt(u, -5.0) ? control_45 : t24);
            const real control_43 = p[45 * 8 + j];
            const real control_42 = p[44 * 8 + j];
            const real t26 = real_lt(u, -8.0) ? control_42 : (real_lt(u, -7.0) ? control_43 : t25);
            const real control_41 = p[43 * 8 + j];
            const real control_40 = p[42 * 8 + j];
            const real t27 = real_lt(u, -10.0) ? control_40 : (real_lt(u, -9.0) ? control_41 : t26);
            const real control_39 = p[41 * 8 + j];
            const real control_38 = p[40 * 8 + j];
            const real t28 = real_lt(u, -12.0) ? control_38 : (real_lt(u, -11.0) ? control_39 : t27);
            const real control_37 = p[39 * 8 + j];
            const real control_36 = p[38 * 8 + j];
            const real t29 = real_lt(u, -14.0) ? control_36 : (real_lt(u, -13.0) ? control_37 : t28);
            const real control_35 = p[37 * 8 + j];
            const real control_34 = p[36 * 8 + j];
            const real t30 = real_lt(u, -16.0) ? control_34 : (real_lt(u, -15.0) ? control_35 : t29);
            const real control_33 = p[35 * 8 + j];
            const real control_32 = p[34 * 8 + j];
            const real t31 = real_lt(u, -18.0) ? control_32 : (real_lt(u, -17.0) ? control_33 : t30);
            const real control_31 = p[33 * 8 + j];
            const real control_30 = p[32 * 8 + j];
            const real t32 = real_lt(u, -20.0) ? control_30 : (real_lt(u, -19.0) ? control_31 : t31);
            const real control_29 = p[31 * 8 + j];
            const real control_28 = p[30 * 8 + j];
            const real t33 = real_lt(u, -22.0) ? control_28 : (real_lt(u, -21.0) ? control_29 : t32);
            const real control_27 = p[29 * 8 + j];
            const real c5 = real_lt(u, -23.0) ? control_27 : t33;
            const real t42 = real_lt(u, 22.0) ? 21.0 : (real_lt(u, 23.0) ? 22.0 : 23.0);
            const real t43 = real_lt(u, 20.0) ? 19.0 : (real_lt(u, 21.0) ? 20.0 : t42);
            const real t44 = real_lt(u, 18.0) ? 17.0 : (real_lt(u, 19.0) ? 18.0 : t43);
            const real t45 = real_lt(u, 16.0) ? 15.0 : (real_lt(u, 17.0) ? 16.0 : t44);
            const real t46 = real_lt(u, 14.0) ? 13.0 : (real_lt(u, 15.0) ? 14.0 : t45);
            const real t47 = real_lt(u, 12.0) ? 11.0 : (real_lt(u, 13.0) ? 12.0 : t46);
            const real t48 = real_lt(u, 9.0) ? 8.0 : (real_lt(u, 10.0) ? 9.0 : (real_lt(u, 11.0) ? 10.0 : t47));
            const real t49 = real_lt(u, 6.0) ? 5.0 : (real_lt(u, 7.0) ? 6.0 : (real_lt(u, 8.0) ? 7.0 : t48));
            const real t50 = real_lt(u, 3.0) ? 2.0 : (real_lt(u, 4.0) ? 3.0 : (real_lt(u, 5.0) ? 4.0 : t49));
            const real t51 = real_lt(u, 0.0) ? -1.0 : (real_lt(u, 1.0) ? 0.0 : (real_lt(u, 2.0) ? 1.0 : t50));
            const real t52 = real_lt(u, -2.0) ? -3.0 : (real_lt(u, -1.0) ? -2.0 : t51);
            const real t53 = real_lt(u, -4.0) ? -5.0 : (real_lt(u, -3.0) ? -4.0 : t52);
            const real t54 = real_lt(u, -6.0) ? -7.0 : (real_lt(u, -5.0) ? -6.0 : t53);
            const real t55 = real_lt(u, -8.0) ? -9.0 : (real_lt(u, -7.0) ? -8.0 : t54);
            const real t56 = real_lt(u, -10.0) ? -11.0 : (real_lt(u, -9.0) ? -10.0 : t55);
            const real t57 = real_lt(u, -12.0) ? -13.0 : (real_lt(u, -11.0) ? -12.0 : t56);
            const real t58 = real_lt(u, -14.0) ? -15.0 : (real_lt(u, -13.0) ? -14.0 : t57);
            const real t59 = real_lt(u, -16.0) ? -17.0 : (real_lt(u, -15.0) ? -16.0 : t58);
            const real t60 = real_lt(u, -18.0) ? -19.0 : (real_lt(u, -17.0) ? -18.0 : t59);
            const real t61 = real_lt(u, -20.0) ? -21.0 : (real_lt(u, -19.0) ? -20.0 : t60);
            const real t62 = real_lt(u, -22.0) ? -23.0 : (real_lt(u, -21.0) ? -22.0 : t61);
            const real t_ = u - (real_lt(u, -23.0) ? -24.0 : t62);
            const real t63 = t_ * t_;
            const real t64 = t_ * t41[j];
            const real t65 = t63 * t64 * t41[j];
            const real t76 = 7.639437268410976 * (30.557749073643905 * t65 + t63 * t63 * t75[j]);
            const real t78 = 15.278874536821952 * (t64 * t64) + t63 * (t77[j] + t_ * t75[j]);
            const real t79 = 30.557749073643905 * (7.639437268410976 * t65 + t_ * t78);
            const real t80 = t76 + t79;
            const real t81 = real_lt(u, 22.0) ? control_23 : (real_lt(u, 23.0) ? control_24 : control_25);
            const real t82 = real_lt(u, 20.0) ? control_21 : (real_lt(u, 21.0) ? control_22 : t81);
            const real t83 = real_lt(u, 18.0) ? control_19 : (real_lt(u, 19.0) ? control_20 : t82);
            const real t84 = real_lt(u, 16.0) ? control_17 : (real_lt(u, 17.0) ? control_18 : t83);
            const real t85 = real_lt(u, 14.0) ? control_15 : (real_lt(u, 15.0) ? control_16 : t84);
            const real t86 = real_lt(u, 12.0) ? control_13 : (real_lt(u, 13.0) ? control_14 : t85);
            const real t87 = real_lt(u, 10.0) ? control_11 : (real_lt(u, 11.0) ? control_12 : t86);
            const real t88 = real_lt(u, 8.0) ? control_9 : (real_lt(u, 9.0) ? control_10 : t87);
            const real t89 = real_lt(u, 6.0) ? control_7 : (real_lt(u, 7.0) ? control_8 : t88);
            const real t90 = real_lt(u, 4.0) ? control_5 : (real_lt(u, 5.0) ? control_6 : t89);
            const real t91 = real_lt(u, 2.0) ? control_3 : (real_lt(u, 3.0) ? control_4 : t90);
            const real t92 = real_lt(u, 0.0) ? control_1 : (real_lt(u, 1.0) ? control_2 : t91);
            const real t93 = real_lt(u, -2.0) ? control_47 : (real_lt(u, -1.0) ? control_0 : t92);
            const real t94 = real_lt(u, -4.0) ? control_45 : (real_lt(u, -3.0) ? control_46 : t93);
            const real t95 = real_lt(u, -6.0) ? control_43 : (real_lt(u, -5.0) ? control_44 : t94);
            const real t96 = real_lt(u, -8.0) ? control_41 : (real_lt(u, -7.0) ? control_42 : t95);
            const real t97 = real_lt(u, -10.0) ? control_39 : (real_lt(u, -9.0) ? control_40 : t96);
            const real t98 = real_lt(u, -12.0) ? control_37 : (real_lt(u, -11.0) ? control_38 : t97);
            const real t99 = real_lt(u, -14.0) ? control_35 : (real_lt(u, -13.0) ? control_36 : t98);
            const real t100 = real_lt(u, -16.0) ? control_33 : (real_lt(u, -15.0) ? control_34 : t99);
            const real t101 = real_lt(u, -18.0) ? control_31 : (real_lt(u, -17.0) ? control_32 : t100);
            const real t102 = real_lt(u, -20.0) ? control_29 : (real_lt(u, -19.0) ? control_30 : t101);
            const real t103 = real_lt(u, -22.0) ? control_27 : (real_lt(u, -21.0) ? control_28 : t102);
            const real c4 = real_lt(u, -23.0) ? control_26 : t103;
            const real t104 = 1.0 + t_;
            const real t105 = t104 * t104;
            const real t106 = t104 * t41[j];
            const real t107 = t105 * t106 * t41[j];
            const real t108 = 7.639437268410976 * (30.557749073643905 * t107 + t105 * t105 * t75[j]);
            const real t109 = 15.278874536821952 * (t106 * t106) + t105 * (t77[j] + t104 * t75[j]);
            const real t110 = 30.557749073643905 * (7.639437268410976 * t107 + t104 * t109);
            const real t111 = t108 + t110;
            const real t112 = real_lt(u, 22.0) ? control_22 : (real_lt(u, 23.0) ? control_23 : control_24);
            const real t113 = real_lt(u, 20.0) ? control_20 : (real_lt(u, 21.0) ? control_21 : t112);
            const real t114 = real_lt(u, 18.0) ? control_18 : (real_lt(u, 19.0) ? control_19 : t113);
            const real t115 = real_lt(u, 16.0) ? control_16 : (real_lt(u, 17.0) ? control_17 : t114);
            const real t116 = real_lt(u, 14.0) ? control_14 : (real_lt(u, 15.0) ? control_15 : t115);
            const real t117 = real_lt(u, 12.0) ? control_12 : (real_lt(u, 13.0) ? control_13 : t116);
            const real t118 = real_lt(u, 10.0) ? control_10 : (real_lt(u, 11.0) ? control_11 : t117);
            const real t119 = real_lt(u, 8.0) ? control_8 : (real_lt(u, 9.0) ? control_9 : t118);
            const real t120 = real_lt(u, 6.0) ? control_6 : (real_lt(u, 7.0) ? control_7 : t119);
            const real t121 = real_lt(u, 4.0) ? control_4 : (real_lt(u, 5.0) ? control_5 : t120);
            const real t122 = real_lt(u, 2.0) ? control_2 : (real_lt(u, 3.0) ? control_3 : t121);
            const real t123 = real_lt(u, 0.0) ? control_0 : (real_lt(u, 1.0) ? control_1 : t122);
            const real t124 = real_lt(u, -2.0) ? control_46 : (real_lt(u, -1.0) ? control_47 : t123);
            const real t125 = real_lt(u, -4.0) ? control_44 : (real_lt(u, -3.0) ? control_45 : t124);
            const real t126 = real_lt(u, -6.0) ? control_42 : (real_lt(u, -5.0) ? control_43 : t125);
            const real t127 = real_lt(u, -8.0) ? control_40 : (real_lt(u, -7.0) ? control_41 : t126);
            const real t128 = real_lt(u, -10.0) ? control_38 : (real_lt(u, -9.0) ? control_39 : t127);
            const real t129 = real_lt(u, -12.0) ? control_36 : (real_lt(u, -11.0) ? control_37 : t128);
            const real t130 = real_lt(u, -14.0) ? control_34 : (real_lt(u, -13.0) ? control_35 : t129);
            const real t131 = real_lt(u, -16.0) ? control_32 : (real_lt(u, -15.0) ? control_33 : t130);
            const real t132 = real_lt(u, -18.0) ? control_30 : (real_lt(u, -17.0) ? control_31 : t131);
            const real t133 = real_lt(u, -20.0) ? control_28 : (real_lt(u, -19.0) ? control_29 : t132);
            const real t134 = real_lt(u, -22.0) ? control_26 : (real_lt(u, -21.0) ? control_27 : t133);
            const real c3 = real_lt(u, -23.0) ? control_25 : t134;
            const real t135 = 2.0 + t_;
            const real t136 = t135 * t135;
            const real t137 = t135 * t41[j];
            const real t138 = t136 * t137 * t41[j];
            const real t139 = 7.639437268410976 * (30.557749073643905 * t138 + t136 * t136 * t75[j]);
            const real t140 = 15.278874536821952 * (t137 * t137) + t136 * (t77[j] + t135 * t75[j]);
            const real t141 = 30.557749073643905 * (7.639437268410976 * t138 + t135 * t140);
            const real t142 = t139 + t141;
            const real t143 = c3 * (0.125 * t80 + 0.008333333333333333 * t142 - 0.05 * t111);
            const real t144 = real_lt(u, 22.0) ? control_21 : (real_lt(u, 23.0) ? control_22 : control_23);
            const real t145 = real_lt(u, 20.0) ? control_19 : (real_lt(u, 21.0) ? control_20 : t144);
            const real t146 = real_lt(u, 18.0) ? control_17 : (real_lt(u, 19.0) ? control_18 : t145);
            const real t147 = real_lt(u, 16.0) ? control_15 : (real_lt(u, 17.0) ? control_16 : t146);
            const real t148 = real_lt(u, 14.0) ? control_13 : (real_lt(u, 15.0) ? control_14 : t147);
            const real t149 = real_lt(u, 12.0) ? control_11 : (real_lt(u, 13.0) ? control_12 : t148);
            const real t150 = real_lt(u, 10.0) ? control_9 : (real_lt(u, 11.0) ? control_10 : t149);
            const real t151 = real_lt(u, 8.0) ? control_7 : (real_lt(u, 9.0) ? control_8 : t150);
            const real t152 = real_lt(u, 6.0) ? control_5 : (real_lt(u, 7.0) ? control_6 : t151);
            const real t153 = real_lt(u, 4.0) ? control_3 : (real_lt(u, 5.0) ? control_4 : t152);
            const real t154 = real_lt(u, 2.0) ? control_1 : (real_lt(u, 3.0) ? control_2 : t153);
            const real t155 = real_lt(u, 0.0) ? control_47 : (real_lt(u, 1.0) ? control_0 : t154);
            const real t156 = real_lt(u, -2.0) ? control_45 : (real_lt(u, -1.0) ? control_46 : t155);
            const real t157 = real_lt(u, -4.0) ? control_43 : (real_lt(u, -3.0) ? control_44 : t156);
            const real t158 = real_lt(u, -6.0) ? control_41 : (real_lt(u, -5.0) ? control_42 : t157);
            const real t159 = real_lt(u, -8.0) ? control_39 : (real_lt(u, -7.0) ? control_40 : t158);
            const real t160 = real_lt(u, -10.0) ? control_37 : (real_lt(u, -9.0) ? control_38 : t159);
            const real t161 = real_lt(u, -12.0) ? control_35 : (real_lt(u, -11.0) ? control_36 : t160);
            const real t162 = real_lt(u, -14.0) ? control_33 : (real_lt(u, -13.0) ? control_34 : t161);
            const real t163 = real_lt(u, -16.0) ? control_31 : (real_lt(u, -15.0) ? control_32 : t162);
            const real t164 = real_lt(u, -18.0) ? control_29 : (real_lt(u, -17.0) ? control_30 : t163);
            const real t165 = real_lt(u, -20.0) ? control_27 : (real_lt(u, -19.0) ? control_28 : t164);
            const real t166 = real_lt(u, -22.0) ? control_25 : (real_lt(u, -21.0) ? control_26 : t165);
            const real c2 = real_lt(u, -23.0) ? control_24 : t166;
            const real t167 = 3.0 + t_;
            const real t168 = t167 * t167;
            const real t169 = t167 * t41[j];
            const real t170 = t168 * t169 * t41[j];
            const real t171 = 7.639437268410976 * (30.557749073643905 * t170 + t168 * t168 * t75[j]);
            const real t172 = 15.278874536821952 * (t169 * t169) + t168 * (t77[j] + t167 * t75[j]);
            const real t173 = 30.557749073643905 * (7.639437268410976 * t170 + t167 * t172);
            const real t174 = t171 + t173;
            const real t175 = 0.125 * t111 + 0.008333333333333333 * t174 - 0.16666666666666666 * t80;
            const real t176 = real_lt(u, 22.0) ? control_19 : (real_lt(u, 23.0) ? control_20 : control_21);
            const real t177 = real_lt(u, 20.0) ? control_17 : (real_lt(u, 21.0) ? control_18 : t176);
            const real t178 = real_lt(u, 18.0) ? control_15 : (real_lt(u, 19.0) ? control_16 : t177);
            const real t179 = real_lt(u, 16.0) ? control_13 : (real_lt(u, 17.0) ? control_14 : t178);
            const real t180 = real_lt(u, 14.0) ? control_11 : (real_lt(u, 15.0) ? control_12 : t179);
            const real t181 = real_lt(u, 12.0) ? control_9 : (real_lt(u, 13.0) ? control_10 : t180);
            const real t182 = real_lt(u, 10.0) ? control_7 : (real_lt(u, 11.0) ? control_8 : t181);
            const real t183 = real_lt(u, 8.0) ? control_5 : (real_lt(u, 9.0) ? control_6 : t182);
            const real t184 = real_lt(u, 6.0) ? control_3 : (real_lt(u, 7.0) ? control_4 : t183);
            const real t185 = real_lt(u, 4.0) ? control_1 : (real_lt(u, 5.0) ? control_2 : t184);
            const real t186 = real_lt(u, 2.0) ? control_47 : (real_lt(u, 3.0) ? control_0 : t185);
            const real t187 = real_lt(u, 0.0) ? control_45 : (real_lt(u, 1.0) ? control_46 : t186);
            const real t188 = real_lt(u, -2.0) ? control_43 : (real_lt(u, -1.0) ? control_44 : t187);
            const real t189 = real_lt(u, -4.0) ? control_41 : (real_lt(u, -3.0) ? control_42 : t188);
            const real t190 = real_lt(u, -6.0) ? control_39 : (real_lt(u, -5.0) ? control_40 : t189);
            const real t191 = real_lt(u, -8.0) ? control_37 : (real_lt(u, -7.0) ? control_38 : t190);
            const real t192 = real_lt(u, -10.0) ? control_35 : (real_lt(u, -9.0) ? control_36 : t191);
            const real t193 = real_lt(u, -12.0) ? control_33 : (real_lt(u, -11.0) ? control_34 : t192);
            const real t194 = real_lt(u, -14.0) ? control_31 : (real_lt(u, -13.0) ? control_32 : t193);
            const real t195 = real_lt(u, -16.0) ? control_29 : (real_lt(u, -15.0) ? control_30 : t194);
            const real t196 = real_lt(u, -18.0) ? control_27 : (real_lt(u, -17.0) ? control_28 : t195);
            const real t197 = real_lt(u, -20.0) ? control_25 : (real_lt(u, -19.0) ? control_26 : t196);
            const real t198 = real_lt(u, -22.0) ? control_23 : (real_lt(u, -21.0) ? control_24 : t197);
            const real c0 = real_lt(u, -23.0) ? control_22 : t198;
            const real t199 = 5.0 + t_;
            const real t200 = t199 * t199;
            const real t201 = t199 * t41[j];
            const real t202 = t200 * t201 * t41[j];
            const real t203 = 7.639437268410976 * (30.557749073643905 * t202 + t200 * t200 * t75[j]);
            const real t204 = 15.278874536821952 * (t201 * t201) + t200 * (t77[j] + t199 * t75[j]);
            const real t205 = 30.557749073643905 * (7.639437268410976 * t202 + t199 * t204);
            const real t206 = 0.008333333333333333 * (t203 + t205) + 0.125 * (t111 + t174);
            const real t207 = 4.0 + t_;
            const real t208 = t207 * t207;
            const real t209 = t207 * t41[j];
            const real t210 = t208 * t209 * t41[j];
            const real t211 = 7.639437268410976 * (30.557749073643905 * t210 + t208 * t208 * t75[j]);
            const real t212 = 15.278874536821952 * (t209 * t209) + t208 * (t77[j] + t207 * t75[j]);
            const real t213 = 30.557749073643905 * (7.639437268410976 * t210 + t207 * t212);
            const real t214 = t211 + t213;
            const real t215 = c0 * (t206 - 0.05 * (t80 + t214) - 0.16666666666666666 * t142);
            const real t216 = real_lt(u, 22.0) ? control_20 : (real_lt(u, 23.0) ? control_21 : control_22);
            const real t217 = real_lt(u, 20.0) ? control_18 : (real_lt(u, 21.0) ? control_19 : t216);
            const real t218 = real_lt(u, 18.0) ? control_16 : (real_lt(u, 19.0) ? control_17 : t217);
            const real t219 = real_lt(u, 16.0) ? control_14 : (real_lt(u, 17.0) ? control_15 : t218);
            const real t220 = real_lt(u, 14.0) ? control_12 : (real_lt(u, 15.0) ? control_13 : t219);
            const real t221 = real_lt(u, 12.0) ? control_10 : (real_lt(u, 13.0) ? control_11 : t220);
            const real t222 = real_lt(u, 10.0) ? control_8 : (real_lt(u, 11.0) ? control_9 : t221);
            const real t223 = real_lt(u, 8.0) ? control_6 : (real_lt(u, 9.0) ? control_7 : t222);
            const real t224 = real_lt(u, 6.0) ? control_4 : (real_lt(u, 7.0) ? control_5 : t223);
            const real t225 = real_lt(u, 4.0) ? control_2 : (real_lt(u, 5.0) ? control_3 : t224);
            const real t226 = real_lt(u, 2.0) ? control_0 : (real_lt(u, 3.0) ? control_1 : t225);
            const real t227 = real_lt(u, 0.0) ? control_46 : (real_lt(u, 1.0) ? control_47 : t226);
            const real t228 = real_lt(u, -2.0) ? control_44 : (real_lt(u, -1.0) ? control_45 : t227);
            const real t229 = real_lt(u, -4.0) ? control_42 : (real_lt(u, -3.0) ? control_43 : t228);
            const real t230 = real_lt(u, -6.0) ? control_40 : (real_lt(u, -5.0) ? control_41 : t229);
            const real t231 = real_lt(u, -8.0) ? control_38 : (real_lt(u, -7.0) ? control_39 : t230);
            const real t232 = real_lt(u, -10.0) ? control_36 : (real_lt(u, -9.0) ? control_37 : t231);
            const real t233 = real_lt(u, -12.0) ? control_34 : (real_lt(u, -11.0) ? control_35 : t232);
            const real t234 = real_lt(u, -14.0) ? control_32 : (real_lt(u, -13.0) ? control_33 : t233);
            const real t235 = real_lt(u, -16.0) ? control_30 : (real_lt(u, -15.0) ? control_31 : t234);
            const real t236 = real_lt(u, -18.0) ? control_28 : (real_lt(u, -17.0) ? control_29 : t235);
            const real t237 = real_lt(u, -20.0) ? control_26 : (real_lt(u, -19.0) ? control_27 : t236);
            const real t238 = real_lt(u, -22.0) ? control_24 : (real_lt(u, -21.0) ? control_25 : t237);
            const real c1 = real_lt(u, -23.0) ? control_23 : t238;
            const real t239 = 0.008333333333333333 * t214 + 0.125 * (t80 + t142) - 0.16666666666666666 * t111;
            const real t240 = t215 + c1 * (t239 - 0.05 * t174) + c2 * (t175 - 0.05 * t142);
            const real t241 = t143 + t240 + c4 * (0.008333333333333333 * t111 - 0.05 * t80);
            g[0 * 8 + j] = t9[j] - (0.008333333333333333 * (c5 * t80) + t241);
        }
    }
}

/* rates: 594 operations.
 * in:  x (6), v (6), p (50)
 * out: Phi_x (1,6) */
FLEXEL_CLONES
static void planar_flat_cam_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (50 * 8);
        real *restrict Phi_x = out[0] + b * (6 * 8);
        real t0[8], sin_q[8], cos_q[8], t3[8], cos_p[8], sin_p[8], b_[8], a_[8], psi[8], t52[8], t58[8], t60[8],
            t221[8], d_y[8], d_x[8], t222[8], t223[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[1 * 8 + j];
            t0[j] = rq_angle + alphaq0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t3[j] = rp_angle + alpha0;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t221[j] = q_vy - p_vy;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t222[j] = q_vx - p_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_q[j] = real_sin(t0[j]);
            cos_q[j] = real_cos(t0[j]);
            cos_p[j] = real_cos(t3[j]);
            sin_p[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_vangle = v[5 * 8 + j];
            const real t1 = rq_vangle * sin_q[j];
            Phi_x[0 * 8 + j] = t1; /* Phi_x(0,0) */
            const real t2 = rq_vangle * cos_q[j];
            Phi_x[4 * 8 + j] = t2; /* Phi_x(0,4) */
            Phi_x[1 * 8 + j] = -t2; /* Phi_x(0,1) */
            b_[j] = cos_p[j] * sin_q[j] - sin_p[j] * cos_q[j];
            a_[j] = cos_p[j] * cos_q[j] + sin_p[j] * sin_q[j];
            const real t49 = 1.0 / (b_[j] * b_[j] + a_[j] * a_[j]);
            const real t50 = a_[j] * t49;
            const real t51 = b_[j] * t49;
            t52[j] = a_[j] * t50 + b_[j] * t51;
            const real rp_vangle = v[2 * 8 + j];
            const real t54 = rp_vangle * sin_p[j];
            const real t55 = rp_vangle * cos_p[j];
            const real t56 = cos_p[j] * t2 - sin_q[j] * t54 - (cos_q[j] * t55 - sin_p[j] * t1);
            const real t57 = sin_q[j] * t55 + sin_p[j] * t2 - (cos_q[j] * t54 + cos_p[j] * t1);
            t58[j] = t50 * t56 - t51 * t57;
            t60[j] = t52[j] * t58[j];
            Phi_x[3 * 8 + j] = -t1; /* Phi_x(0,3) */
            t223[j] = cos_q[j] * t221[j] - d_y[j] * t1 - (d_x[j] * t2 + sin_q[j] * t222[j]);
        }
        for (size_t j = 0; j < 8; j++) {
            psi[j] = real_atan2(b_[j], a_[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real u = 7.639437268410976 * psi[j];
            const real control_24 = p[26 * 8 + j];
            const real control_25 = p[27 * 8 + j];
            const real control_23 = p[25 * 8 + j];
            const real t4 = real_lt(u, 22.0) ? control_23 : (real_lt(u, 23.0) ? control_24 : control_25);
            const real control_22 = p[24 * 8 + j];
            const real control_21 = p[23 * 8 + j];
            const real t5 = real_lt(u, 20.0) ? control_21 : (real_lt(u, 21.0) ? control_22 : t4);
            const real control_20 = p[22 * 8 + j];
            const real control_19 = p[21 * 8 + j];
            const real t6 = real_lt(u, 18.0) ? control_19 : (real_lt(u, 19.0) ? control_20 : t5);
            const real control_18 = p[20 * 8 + j];
            const real control_17 = p[19 * 8 + j];
            const real t7 = real_lt(u, 16.0) ? control_17 : (real_lt(u, 17.0) ? control_18 : t6);
            const real control_16 = p[18 * 8 + j];
            const real control_15 = p[17 * 8 + j];
            const real t8 = real_lt(u, 14.0) ? control_15 : (real_lt(u, 15.0) ? control_16 : t7);
            const real control_14 = p[16 * 8 + j];
            const real control_13 = p[15 * 8 + j];
            const real t9 = real_lt(u, 12.0) ? control_13 : (real_lt(u, 13.0) ? control_14 : t8);
            const real control_12 = p[14 * 8 + j];
            const real control_11 = p[13 * 8 + j];
            const real t10 = real_lt(u, 10.0) ? control_11 : (real_lt(u, 11.0) ? control_12 : t9);
            const real control_10 = p[12 * 8 + j];
            const real control_9 = p[11 * 8 + j];
            const real t11 = real_lt(u, 8.0) ? control_9 : (real_lt(u, 9.0) ? control_10 : t10);
            const real control_8 = p[10 * 8 + j];
            const real control_7 = p[9 * 8 + j];
            const real t12 = real_lt(u, 6.0) ? control_7 : (real_lt(u, 7.0) ? control_8 : t11);
            const real control_6 = p[8 * 8 + j];
            const real control_5 = p[7 * 8 + j];
            const real t13 = real_lt(u, 4.0) ? control_5 : (real_lt(u, 5.0) ? control_6 : t12);
            const real control_4 = p[6 * 8 + j];
            const real control_3 = p[5 * 8 + j];
            const real t14 = real_lt(u, 2.0) ? control_3 : (real_lt(u, 3.0) ? control_4 : t13);
            const real control_2 = p[4 * 8 + j];
            const real control_1 = p[3 * 8 + j];
            const real t15 = real_lt(u, 0.0) ? control_1 : (real_lt(u, 1.0) ? control_2 : t14);
            const real control_0 = p[2 * 8 + j];
            const real control_47 = p[49 * 8 + j];
            const real t16 = real_lt(u, -2.0) ? control_47 : (real_lt(u, -1.0) ? control_0 : t15);
            const real control_46 = p[48 * 8 + j];
            const real control_45 = p[47 * 8 + j];
            const real t17 = real_lt(u, -4.0) ? control_45 : (real_lt(u, -3.0) ? control_46 : t16);
            const real control_44 = p[46 * 8 + j];
            const real control_43 = p[45 * 8 + j];
            const real t18 = real_lt(u, -6.0) ? control_43 : (real_lt(u, -5.0) ? control_44 : t17);
            const real control_42 = p[44 * 8 + j];
            const real control_41 = p[43 * 8 + j];
            const real t19 = real_lt(u, -8.0) ? control_41 : (real_lt(u, -7.0) ? control_42 : t18);
            const real control_40 = p[42 * 8 + j];
            const real control_39 = p[41 * 8 + j];
            const real t20 = real_lt(u, -10.0) ? control_39 : (real_lt(u, -9.0) ? control_40 : t19);
            const real control_38 = p[40 * 8 + j];
            const real control_37 = p[39 * 8 + j];
            const real t21 = real_lt(u, -12.0) ? control_37 : (real_lt(u, -11.0) ? control_38 : t20);
            const real control_36 = p[38 * 8 + j];
            const real control_35 = p[37 * 8 + j];
            const real t22 = real_lt(u, -14.0) ? control_35 : (real_lt(u, -13.0) ? control_36 : t21);
            const real control_34 = p[36 * 8 + j];
            const real control_33 = p[35 * 8 + j];
            const real t23 = real_lt(u, -16.0) ? control_33 : (real_lt(u, -15.0) ? control_34 : t22);
            const real control_32 = p[34 * 8 + j];
            const real control_31 = p[33 * 8 + j];
            const real t24 = real_lt(u, -18.0) ? control_31 : (real_lt(u, -17.0) ? control_32 : t23);
            const real control_30 = p[32 * 8 + j];
            const real control_29 = p[31 * 8 + j];
            const real t25 = real_lt(u, -20.0) ? control_29 : (real_lt(u, -19.0) ? control_30 : t24);
            const real control_28 = p[30 * 8 + j];
            const real control_27 = p[29 * 8 + j];
            const real t26 = real_lt(u, -22.0) ? control_27 : (real_lt(u, -21.0) ? control_28 : t25);
            const real control_26 = p[28 * 8 + j];
            const real c4 = real_lt(u, -23.0) ? control_26 : t26;
            const real t27 = real_lt(u, 22.0) ? 21.0 : (real_lt(u, 23.0) ? 22.0 : 23.0);
            const real t28 = real_lt(u, 20.0) ? 19.0 : (real_lt(u, 21.0) ? 20.0 : t27);
            const real t29 = real_lt(u, 18.0) ? 17.0 : (real_lt(u, 19.0) ? 18.0 : t28);
            const real t30 = real_lt(u, 16.0) ? 15.0 : (real_lt(u, 17.0) ? 16.0 : t29);
            const real t31 = real_lt(u, 14.0) ? 13.0 : (real_lt(u, 15.0) ? 14.0 : t30);
            const real t32 = real_lt(u, 12.0) ? 11.0 : (real_lt(u, 13.0) ? 12.0 : t31);
            const real t33 = real_lt(u, 9.0) ? 8.0 : (real_lt(u, 10.0) ? 9.0 : (real_lt(u, 11.0) ? 10.0 : t32));
            const real t34 = real_lt(u, 6.0) ? 5.0 : (real_lt(u, 7.0) ? 6.0 : (real_lt(u, 8.0) ? 7.0 : t33));
            const real t35 = real_lt(u, 3.0) ? 2.0 : (real_lt(u, 4.0) ? 3.0 : (real_lt(u, 5.0) ? 4.0 : t34));
            const real t36 = real_lt(u, 0.0) ? -1.0 : (real_lt(u, 1.0) ? 0.0 : (real_lt(u, 2.0) ? 1.0 : t35));
            const real t37 = real_lt(u, -2.0) ? -3.0 : (real_lt(u, -1.0) ? -2.0 : t36);
            const real t38 = real_lt(u, -4.0) ? -5.0 : (real_lt(u, -3.0) ? -4.0 : t37);
            const real t39 = real_lt(u, -6.0) ? -7.0 : (real_lt(u, -5.0) ? -6.0 : t38);
            const real t40 = real_lt(u, -8.0) ? -9.0 : (real_lt(u, -7.0) ? -8.0 : t39);
            const real t41 = real_lt(u, -10.0) ? -11.0 : (real_lt(u, -9.0) ? -10.0 : t40);
            const real t42 = real_lt(u, -12.0) ? -13.0 : (real_lt(u, -11.0) ? -12.0 : t41);
            const real t43 = real_lt(u, -14.0) ? -15.0 : (real_lt(u, -13.0) ? -14.0 : t42);
            const real t44 = real_lt(u, -16.0) ? -17.0 : (real_lt(u, -15.0) ? -16.0 : t43);
            const real t45 = real_lt(u, -18.0) ? -19.0 : (real_lt(u, -17.0) ? -18.0 : t44);
            const real t46 = real_lt(u, -20.0) ? -21.0 : (real_lt(u, -19.0) ? -20.0 : t45);
            const real t47 = real_lt(u, -22.0) ? -23.0 : (real_lt(u, -21.0) ? -22.0 : t46);
            const real t_ = u - (real_lt(u, -23.0) ? -24.0 : t47);
            const real t48 = t_ * t_;
            const real t53 = t_ * t52[j];
            const real t59 = t_ * t58[j];
            const real t61 = 15.278874536821952 * (t53 * t59) + 7.639437268410976 * (t48 * t60[j]);
            const real t62 = 30.557749073643905 * (7.639437268410976 * (t48 * t59 * t52[j]) + t_ * t61);
            const real t63 = 233.44400711194623 * (t48 * t53 * t58[j]) + t62;
            const real t64 = 1.0 + t_;
            const real t65 = t64 * t64;
            const real t66 = t64 * t52[j];
            const real t67 = t64 * t58[j];
            const real t68 = 15.278874536821952 * (t66 * t67) + 7.639437268410976 * (t65 * t60[j]);
            const real t69 = 30.557749073643905 * (7.639437268410976 * (t65 * t67 * t52[j]) + t64 * t68);
            const real t70 = 233.44400711194623 * (t65 * t66 * t58[j]) + t69;
            const real t71 = real_lt(u, 22.0) ? control_22 : (real_lt(u, 23.0) ? control_23 : control_24);
            const real t72 = real_lt(u, 20.0) ? control_20 : (real_lt(u, 21.0) ? control_21 : t71);
            const real t73 = real_lt(u, 18.0) ? control_18 : (real_lt(u, 19.0) ? control_19 : t72);
            const real t74 = real_lt(u, 16.0) ? control_16 : (real_lt(u, 17.0) ? control_17 : t73);
            const real t75 = real_lt(u, 14.0) ? control_14 : (real_lt(u, 15.0) ? control_15 : t74);
            const real t76 = real_lt(u, 12.0) ? control_12 : (real_lt(u, 13.0) ? control_13 : t75);
            const real t77 = real_lt(u, 10.0) ? control_10 : (real_lt(u, 11.0) ? control_11 : t76);
            const real t78 = real_lt(u, 8.0) ? control_8 : (real_lt(u, 9.0) ? control_9 : t77);
            const real t79 = real_lt(u, 6.0) ? control_6 : (real_lt(u, 7.0) ? control_7 : t78);
            const real t80 = real_lt(u, 4.0) ? control_4 : (real_lt(u, 5.0) ? control_5 : t79);
            const real t81 = real_lt(u, 2.0) ? control_2 : (real_lt(u, 3.0) ? control_3 : t80);
            const real t82 = real_lt(u, 0.0) ? control_0 : (real_lt(u, 1.0) ? control_1 : t81);
            const real t83 = real_lt(u, -2.0) ? control_46 : (real_lt(u, -1.0) ? control_47 : t82);
            const real t84 = real_lt(u, -4.0) ? control_44 : (real_lt(u, -3.0) ? control_45 : t83);
            const real t85 = real_lt(u, -6.0) ? control_42 : (real_lt(u, -5.0) ? control_43 : t84);
            const real t86 = real_lt(u, -8.0) ? control_40 : (real_lt(u, -7.0) ? control_41 : t85);
            const real t87 = real_lt(u, -10.0) ? control_38 : (real_lt(u, -9.0) ? control_39 : t86);
            const real t88 = real_lt(u, -12.0) ? control_36 : (real_lt(u, -11.0) ? control_37 : t87);
            const real t89 = real_lt(u, -14.0) ? control_34 : (real_lt(u, -13.0) ? control_35 : t88);
            const real t90 = real_lt(u, -16.0) ? control_32 : (real_lt(u, -15.0) ? control_33 : t89);
            const real t91 = real_lt(u, -18.0) ? control_30 : (real_lt(u, -17.0) ? control_31 : t90);
            const real t92 = real_lt(u, -20.0) ? control_28 : (real_lt(u, -19.0) ? control_29 : t91);
            const real t93 = real_lt(u, -22.0) ? control_26 : (real_lt(u, -21.0) ? control_27 : t92);
            const real c3 = real_lt(u, -23.0) ? control_25 : t93;
            const real t94 = 2.0 + t_;
            const real t95 = t94 * t94;
            const real t96 = t94 * t52[j];
            const real t97 = t94 * t58[j];
            const real t98 = 15.278874536821952 * (t96 * t97) + 7.639437268410976 * (t95 * t60[j]);
            const real t99 = 30.557749073643905 * (7.639437268410976 * (t95 * t97 * t52[j]) + t94 * t98);
            const real t100 = 233.44400711194623 * (t95 * t96 * t58[j]) + t99;
            const real t101 = c3 * (0.05 * t70 - (0.125 * t63 + 0.008333333333333333 * t100));
            const real t102 = real_lt(u, 22.0) ? control_21 : (real_lt(u, 23.0) ? control_22 : control_23);
            const real t103 = real_lt(u, 20.0) ? control_19 : (real_lt(u, 21.0) ? control_20 : t102);
            const real t104 = real_lt(u, 18.0) ? control_17 : (real_lt(u, 19.0) ? control_18 : t103);
            const real t105 = real_lt(u, 16.0) ? control_15 : (real_lt(u, 17.0) ? control_16 : t104);
            const real t106 = real_lt(u, 14.0) ? control_13 : (real_lt(u, 15.0) ? control_14 : t105);
            const real t107 = real_lt(u, 12.0) ? control_11 : (real_lt(u, 13.0) ? control_12 : t106);
            const real t108 = real_lt(u, 10.0) ? control_9 : (real_lt(u, 11.0) ? control_10 : t107);
            const real t109 = real_lt(u, 8.0) ? control_7 : (real_lt(u, 9.0) ? control_8 : t108);
            const real t110 = real_lt(u, 6.0) ? control_5 : (real_lt(u, 7.0) ? control_6 : t109);
            const real t111 = real_lt(u, 4.0) ? control_3 : (real_lt(u, 5.0) ? control_4 : t110);
            const real t112 = real_lt(u, 2.0) ? control_1 : (real_lt(u, 3.0) ? control_2 : t111);
            const real t113 = real_lt(u, 0.0) ? control_47 : (real_lt(u, 1.0) ? control_0 : t112);
            const real t114 = real_lt(u, -2.0) ? control_45 : (real_lt(u, -1.0) ? control_46 : t113);
            const real t115 = real_lt(u, -4.0) ? control_43 : (real_lt(u, -3.0) ? control_44 : t114);
            const real t116 = real_lt(u, -6.0) ? control_41 : (real_lt(u, -5.0) ? control_42 : t115);
            const real t117 = real_lt(u, -8.0) ? control_39 : (real_lt(u, -7.0) ? control_40 : t116);
            const real t118 = real_lt(u, -10.0) ? control_37 : (real_lt(u, -9.0) ? control_38 : t117);
            const real t119 = real_lt(u, -12.0) ? control_35 : (real_lt(u, -11.0) ? control_36 : t118);
            const real t120 = real_lt(u, -14.0) ? control_33 : (real_lt(u, -13.0) ? control_34 : t119);
            const real t121 = real_lt(u, -16.0) ? control_31 : (real_lt(u, -15.0) ? control_32 : t120);
            const real t122 = real_lt(u, -18.0) ? control_29 : (real_lt(u, -17.0) ? control_30 : t121);
            const real t123 = real_lt(u, -20.0) ? control_27 : (real_lt(u, -19.0) ? control_28 : t122);
            const real t124 = real_lt(u, -22.0) ? control_25 : (real_lt(u, -21.0) ? control_26 : t123);
            const real c2 = real_lt(u, -23.0) ? control_24 : t124;
            const real t125 = 3.0 + t_;
            const real t126 = t125 * t125;
            const real t127 = t125 * t52[j];
            const real t128 = t125 * t58[j];
            const real t129 = 15.278874536821952 * (t127 * t128) + 7.639437268410976 * (t126 * t60[j]);
            const real t130 = 30.557749073643905 * (7.639437268410976 * (t126 * t128 * t52[j]) + t125 * t129);
            const real t131 = 233.44400711194623 * (t126 * t127 * t58[j]) + t130;
            const real t132 = 0.16666666666666666 * t63 - (0.125 * t70 + 0.008333333333333333 * t131);
            const real t133 = real_lt(u, 22.0) ? control_19 : (real_lt(u, 23.0) ? control_20 : control_21);
            const real t134 = real_lt(u, 20.0) ? control_17 : (real_lt(u, 21.0) ? control_18 : t133);
            const real t135 = real_lt(u, 18.0) ? control_15 : (real_lt(u, 19.0) ? control_16 : t134);
            const real t136 = real_lt(u, 16.0) ? control_13 : (real_lt(u, 17.0) ? control_14 : t135);
            const real t137 = real_lt(u, 14.0) ? control_11 : (real_lt(u, 15.0) ? control_12 : t136);
            const real t138 = real_lt(u, 12.0) ? control_9 : (real_lt(u, 13.0) ? control_10 : t137);
            const real t139 = real_lt(u, 10.0) ? control_7 : (real_lt(u, 11.0) ? control_8 : t138);
            const real t140 = real_lt(u, 8.0) ? control_5 : (real_lt(u, 9.0) ? control_6 : t139);
            const real t141 = real_lt(u, 6.0) ? control_3 : (real_lt(u, 7.0) ? control_4 : t140);
            const real t142 = real_lt(u, 4.0) ? control_1 : (real_lt(u, 5.0) ? control_2 : t141);
            const real t143 = real_lt(u, 2.0) ? control_47 : (real_lt(u, 3.0) ? control_0 : t142);
            const real t144 = real_lt(u, 0.0) ? control_45 : (real_lt(u, 1.0) ? control_46 : t143);
            const real t145 = real_lt(u, -2.0) ? control_43 : (real_lt(u, -1.0) ? control_44 : t144);
            const real t146 = real_lt(u, -4.0) ? control_41 : (real_lt(u, -3.0) ? control_42 : t145);
            const real t147 = real_lt(u, -6.0) ? control_39 : (real_lt(u, -5.0) ? control_40 : t146);
            const real t148 = real_lt(u, -8.0) ? control_37 : (real_lt(u, -7.0) ? control_38 : t147);
            const real t149 = real_lt(u, -10.0) ? control_35 : (real_lt(u, -9.0) ? control_36 : t148);
            const real t150 = real_lt(u, -12.0) ? control_33 : (real_lt(u, -11.0) ? control_34 : t149);
            const real t151 = real_lt(u, -14.0) ? control_31 : (real_lt(u, -13.0) ? control_32 : t150);
            const real t152 = real_lt(u, -16.0) ? control_29 : (real_lt(u, -15.0) ? control_30 : t151);
            const real t153 = real_lt(u, -18.0) ? control_27 : (real_lt(u, -17.0) ? control_28 : t152);
            const real t154 = real_lt(u, -20.0) ? control_25 : (real_lt(u, -19.0) ? control_26 : t153);
            const real t155 = real_lt(u, -22.0) ? control_23 : (real_lt(u, -21.0) ? control_24 : t154);
            const real c0 = real_lt(u, -23.0) ? control_22 : t155;
            const real t156 = 4.0 + t_;
            const real t157 = t156 * t156;
            const real t158 = t156 * t52[j];
            const real t159 = t156 * t58[j];
            const real t160 = 15.278874536821952 * (t158 * t159) + 7.639437268410976 * (t157 * t60[j]);
            const real t161 = 30.557749073643905 * (7.639437268410976 * (t157 * t159 * t52[j]) + t156 * t160);
            const real t162 = 233.44400711194623 * (t157 * t158 * t58[j]) + t161;
            const real t163 = 5.0 + t_;
            const real t164 = t163 * t163;
            const real t165 = t163 * t52[j];
            const real t166 = t163 * t58[j];
            const real t167 = 15.278874536821952 * (t165 * t166) + 7.639437268410976 * (t164 * t60[j]);
            const real t168 = 30.557749073643905 * (7.639437268410976 * (t164 * t166 * t52[j]) + t163 * t167);
            const real t169 = 0.008333333333333333 * (233.44400711194623 * (t164 * t165 * t58[j]) + t168);
            const real t170 = 0.05 * (t63 + t162) - (t169 + 0.125 * (t70 + t131)) + 0.16666666666666666 * t100;
            const real t171 = real_lt(u, 22.0) ? control_20 : (real_lt(u, 23.0) ? control_21 : control_22);
            const real t172 = real_lt(u, 20.0) ? control_18 : (real_lt(u, 21.0) ? control_19 : t171);
            const real t173 = real_lt(u, 18.0) ? control_16 : (real_lt(u, 19.0) ? control_17 : t172);
            const real t174 = real_lt(u, 16.0) ? control_14 : (real_lt(u, 17.0) ? control_15 : t173);
            const real t175 = real_lt(u, 14.0) ? control_12 : (real_lt(u, 15.0) ? control_13 : t174);
            const real t176 = real_lt(u, 12.0) ? control_10 : (real_lt(u, 13.0) ? control_11 : t175);
            const real t177 = real_lt(u, 10.0) ? control_8 : (real_lt(u, 11.0) ? control_9 : t176);
            const real t178 = real_lt(u, 8.0) ? control_6 : (real_lt(u, 9.0) ? control_7 : t177);
            const real t179 = real_lt(u, 6.0) ? control_4 : (real_lt(u, 7.0) ? control_5 : t178);
            const real t180 = real_lt(u, 4.0) ? control_2 : (real_lt(u, 5.0) ? control_3 : t179);
            const real t181 = real_lt(u, 2.0) ? control_0 : (real_lt(u, 3.0) ? control_1 : t180);
            const real t182 = real_lt(u, 0.0) ? control_46 : (real_lt(u, 1.0) ? control_47 : t181);
            const real t183 = real_lt(u, -2.0) ? control_44 : (real_lt(u, -1.0) ? control_45 : t182);
            const real t184 = real_lt(u, -4.0) ? control_42 : (real_lt(u, -3.0) ? control_43 : t183);
            const real t185 = real_lt(u, -6.0) ? control_40 : (real_lt(u, -5.0) ? control_41 : t184);
            const real t186 = real_lt(u, -8.0) ? control_38 : (real_lt(u, -7.0) ? control_39 : t185);
            const real t187 = real_lt(u, -10.0) ? control_36 : (real_lt(u, -9.0) ? control_37 : t186);
            const real t188 = real_lt(u, -12.0) ? control_34 : (real_lt(u, -11.0) ? control_35 : t187);
            const real t189 = real_lt(u, -14.0) ? control_32 : (real_lt(u, -13.0) ? control_33 : t188);
            const real t190 = real_lt(u, -16.0) ? control_30 : (real_lt(u, -15.0) ? control_31 : t189);
            const real t191 = real_lt(u, -18.0) ? control_28 : (real_lt(u, -17.0) ? control_29 : t190);
            const real t192 = real_lt(u, -20.0) ? control_26 : (real_lt(u, -19.0) ? control_27 : t191);
            const real t193 = real_lt(u, -22.0) ? control_24 : (real_lt(u, -21.0) ? control_25 : t192);
            const real c1 = real_lt(u, -23.0) ? control_23 : t193;
            const real t194 = 0.16666666666666666 * t70 - (0.008333333333333333 * t162 + 0.125 * (t63 + t100));
            const real t195 = c0 * t170 + c1 * (0.05 * t131 + t194) + c2 * (0.05 * t100 + t132);
            const real t196 = t101 + t195 + c4 * (0.05 * t63 - 0.008333333333333333 * t70);
            const real t197 = real_lt(u, 22.0) ? control_24 : (real_lt(u, 23.0) ? control_25 : control_26);
            const real t198 = real_lt(u, 20.0) ? control_22 : (real_lt(u, 21.0) ? control_23 : t197);
            const real t199 = real_lt(u, 18.0) ? control_20 : (real_lt(u, 19.0) ? control_21 : t198);
            const real t200 = real_lt(u, 16.0) ? control_18 : (real_lt(u, 17.0) ? control_19 : t199);
            const real t201 = real_lt(u, 14.0) ? control_16 : (real_lt(u, 15.0) ? control_17 : t200);
            const real t202 = real_lt(u, 12.0) ? control_14 : (real_lt(u, 13.0) ? control_15 : t201);
            const real t203 = real_lt(u, 10.0) ? control_12 : (real_lt(u, 11.0) ? control_13 : t202);
            const real t204 = real_lt(u, 8.0) ? control_10 : (real_lt(u, 9.0) ? control_11 : t203);
            const real t205 = real_lt(u, 6.0) ? control_8 : (real_lt(u, 7.0) ? control_9 : t204);
            const real t206 = real_lt(u, 4.0) ? control_6 : (real_lt(u, 5.0) ? control_7 : t205);
            const real t207 = real_lt(u, 2.0) ? control_4 : (real_lt(u, 3.0) ? control_5 : t206);
            const real t208 = real_lt(u, 0.0) ? control_2 : (real_lt(u, 1.0) ? control_3 : t207);
            const real t209 = real_lt(u, -2.0) ? control_0 : (real_lt(u, -1.0) ? control_1 : t208);
            const real t210 = real_lt(u, -4.0) ? control_46 : (real_lt(u, -3.0) ? control_47 : t209);
            const real t211 = real_lt(u, -6.0) ? control_44 : (real_lt(u, -5.0) ? control_45 : t210);
            const real t212 = real_lt(u, -8.0) ? control_42 : (real_lt(u, -7.0) ? control_43 : t211);
            const real t213 = real_lt(u, -10.0) ? control_40 : (real_lt(u, -9.0) ? control_41 : t212);
            const real t214 = real_lt(u, -12.0) ? control_38 : (real_lt(u, -11.0) ? control_39 : t213);
            const real t215 = real_lt(u, -14.0) ? control_36 : (real_lt(u, -13.0) ? control_37 : t214);
            const real t216 = real_lt(u, -16.0) ? control_34 : (real_lt(u, -15.0) ? control_35 : t215);
            const real t217 = real_lt(u, -18.0) ? control_32 : (real_lt(u, -17.0) ? control_33 : t216);
            const real t218 = real_lt(u, -20.0) ? control_30 : (real_lt(u, -19.0) ? control_31 : t217);
            const real t219 = real_lt(u, -22.0) ? control_28 : (real_lt(u, -21.0) ? control_29 : t218);
            const real c5 = real_lt(u, -23.0) ? control_27 : t219;
            const real t220 = t196 - 0.008333333333333333 * (c5 * t63);
            Phi_x[2 * 8 + j] = -t220; /* Phi_x(0,2) */
            Phi_x[5 * 8 + j] = t220 + t223[j]; /* Phi_x(0,5) */
        }
    }
}

/* kinematics: 1015 operations.
 * in:  x (6), v (6), a (6), p (50)
 * out: Psi_x (1,6), Psi_v (1,6) */
FLEXEL_CLONES
static void planar_flat_cam_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (50 * 8);
        real *restrict Psi_x = out[0] + b * (6 * 8);
        real *restrict Psi_v = out[1] + b * (6 * 8);
        real t0[8], cos_q[8], sin_q[8], t9[8], cos_p[8], sin_p[8], b_[8], a_[8], psi[8], t40[8], t63[8], t67[8],
            t77[8], t78[8], t81[8], t270[8], t273[8], d_x[8], t309[8], t310[8], t311[8], t312[8], t313[8], t314[8],
            d_y[8], t315[8], t316[8], t317[8], t339[8], t340[8], t341[8], t342[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[1 * 8 + j];
            t0[j] = rq_angle + alphaq0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t9[j] = rp_angle + alpha0;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t310[j] = q_ay - p_ay;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t312[j] = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t313[j] = q_vy - p_vy;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t316[j] = q_ax - p_ax;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_q[j] = real_cos(t0[j]);
            sin_q[j] = real_sin(t0[j]);
            cos_p[j] = real_cos(t9[j]);
            sin_p[j] = real_sin(t9[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_vangle = v[5 * 8 + j];
            const real t1 = rq_vangle * cos_q[j];
            const real t2 = rq_vangle * t1;
            const real rq_aangle = a[5 * 8 + j];
            const real t3 = sin_q[j] * rq_aangle;
            const real t4 = t2 + t3;
            Psi_x[0 * 8 + j] = t4; /* Psi_x(0,0) */
            const real t5 = rq_vangle * sin_q[j];
            const real t6 = rq_vangle * t5;
            const real t7 = cos_q[j] * rq_aangle;
            const real t8 = t6 - t7;
            Psi_x[1 * 8 + j] = t8; /* Psi_x(0,1) */
            b_[j] = cos_p[j] * sin_q[j] - sin_p[j] * cos_q[j];
            a_[j] = cos_p[j] * cos_q[j] + sin_p[j] * sin_q[j];
            const real t33 = 1.0 / (b_[j] * b_[j] + a_[j] * a_[j]);
            const real t34 = a_[j] * t33;
            const real rp_vangle = v[2 * 8 + j];
            const real t35 = rp_vangle * sin_p[j];
            const real t36 = rp_vangle * cos_p[j];
            const real t37 = cos_p[j] * t1 + sin_p[j] * t5 - sin_q[j] * t35 - cos_q[j] * t36;
            const real t38 = b_[j] * t33;
            const real t39 = sin_q[j] * t36 + sin_p[j] * t1 - cos_q[j] * t35 - cos_p[j] * t5;
            t40[j] = t34 * t37 - t38 * t39;
            t63[j] = a_[j] * t34 + b_[j] * t38;
            t67[j] = t63[j] * t40[j];
            const real t71 = t33 * t33 * (b_[j] * t37 + a_[j] * t39);
            const real t72 = rp_vangle * t35;
            const real t73 = sin_p[j] * t2 + 2.0 * (t36 * t5 - t35 * t1) + cos_q[j] * t72;
            const real t74 = rp_vangle * t36;
            const real t75 = t37 * (t33 * t39 - 2.0 * a_[j] * t71) + t34 * (t73 - sin_q[j] * t74 - cos_p[j] * t6);
            const real t76 = 2.0 * (t35 * t5 + t36 * t1) - sin_q[j] * t72 - sin_p[j] * t6;
            t77[j] = t75 - t39 * (t33 * t37 - 2.0 * b_[j] * t71) - t38 * (t76 - cos_q[j] * t74 - cos_p[j] * t2);
            t78[j] = 7.639437268410976 * (t40[j] * t40[j]);
            t81[j] = t63[j] * t77[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t266 = sin_p[j] * rp_aangle;
            const real t267 = cos_p[j] * rp_aangle;
            const real t268 = cos_p[j] * t7 + sin_p[j] * t3 - sin_q[j] * t266 - cos_q[j] * t267;
            const real t269 = sin_q[j] * t267 + sin_p[j] * t7 - cos_q[j] * t266 - cos_p[j] * t3;
            t270[j] = t34 * t268 - t38 * t269;
            t273[j] = t63[j] * t270[j];
            Psi_x[3 * 8 + j] = -t4; /* Psi_x(0,3) */
            Psi_x[4 * 8 + j] = -t8; /* Psi_x(0,4) */
            t309[j] = d_x[j] * t8;
            t311[j] = cos_q[j] * t310[j];
            t314[j] = 2.0 * (t1 * t312[j] + t5 * t313[j]);
            t315[j] = d_y[j] * t4;
            t317[j] = sin_q[j] * t316[j];
            const real t318 = 2.0 * t5;
            Psi_v[0 * 8 + j] = t318; /* Psi_v(0,0) */
            const real t319 = 2.0 * t1;
            Psi_v[4 * 8 + j] = t319; /* Psi_v(0,4) */
            Psi_v[1 * 8 + j] = -t319; /* Psi_v(0,1) */
            Psi_v[3 * 8 + j] = -t318; /* Psi_v(0,3) */
            t339[j] = cos_q[j] * t313[j];
            t340[j] = d_y[j] * t5;
            t341[j] = d_x[j] * t1;
            t342[j] = sin_q[j] * t312[j];
        }
        for (size_t j = 0; j < 8; j++) {
            psi[j] = real_atan2(b_[j], a_[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real u = 7.639437268410976 * psi[j];
            const real control_23 = p[25 * 8 + j];
            const real control_24 = p[26 * 8 + j];
            const real control_22 = p[24 * 8 + j];
            const real t10 = real_lt(u, 22.0) ? control_22 : (real_lt(u, 23.0) ? control_23 : control_24);
            const real control_21 = p[23 * 8 + j];
            const real control_20 = p[22 * 8 + j];
            const real t11 = real_lt(u, 20.0) ? control_20 : (real_lt(u, 21.0) ? control_21 : t10);
            const real control_19 = p[21 * 8 + j];
            const real control_18 = p[20 * 8 + j];
            const real t12 = real_lt(u, 18.0) ? control_18 : (real_lt(u, 19.0) ? control_19 : t11);
            const real control_17 = p[19 * 8 + j];
            const real control_16 = p[18 * 8 + j];
            const real t13 = real_lt(u, 16.0) ? control_16 : (real_lt(u, 17.0) ? control_17 : t12);
            const real control_15 = p[17 * 8 + j];
            const real control_14 = p[16 * 8 + j];
            const real t14 = real_lt(u, 14.0) ? control_14 : (real_lt(u, 15.0) ? control_15 : t13);
            const real control_13 = p[15 * 8 + j];
            const real control_12 = p[14 * 8 + j];
            const real t15 = real_lt(u, 12.0) ? control_12 : (real_lt(u, 13.0) ? control_13 : t14);
            const real control_11 = p[13 * 8 + j];
            const real control_10 = p[12 * 8 + j];
            const real t16 = real_lt(u, 10.0) ? control_10 : (real_lt(u, 11.0) ? control_11 : t15);
            const real control_9 = p[11 * 8 + j];
            const real control_8 = p[10 * 8 + j];
            const real t17 = real_lt(u, 8.0) ? control_8 : (real_lt(u, 9.0) ? control_9 : t16);
            const real control_7 = p[9 * 8 + j];
            const real control_6 = p[8 * 8 + j];
            const real t18 = real_lt(u, 6.0) ? control_6 : (real_lt(u, 7.0) ? control_7 : t17);
            const real control_5 = p[7 * 8 + j];
            const real control_4 = p[6 * 8 + j];
            const real t19 = real_lt(u, 4.0) ? control_4 : (real_lt(u, 5.0) ? control_5 : t18);
            const real control_3 = p[5 * 8 + j];
            const real control_2 = p[4 * 8 + j];
            const real t20 = real_lt(u, 2.0) ? control_2 : (real_lt(u, 3.0) ? control_3 : t19);
            const real control_1 = p[3 * 8 + j];
            const real control_0 = p[2 * 8 + j];
            const real t21 = real_lt(u, 0.0) ? control_0 : (real_lt(u, 1.0) ? control_1 : t20);
            const real control_47 = p[49 * 8 + j];
            const real control_46 = p[48 * 8 + j];
            const real t22 = real_lt(u, -2.0) ? control_46 : (real_lt(u, -1.0) ? control_47 : t21);
            const real control_45 = p[47 * 8 + j];
            const real control_44 = p[46 * 8 + j];
            const real t23 = real_lt(u, -4.0) ? control_44 : (real_lt(u, -3.0) ? control_45 : t22);
            const real control_43 = p[45 * 8 + j];
            const real control_42 = p[44 * 8 + j];
            const real t24 = real_lt(u, -6.0) ? control_42 : (real_lt(u, -5.0) ? control_43 : t23);
            const real control_41 = p[43 * 8 + j];
            const real control_40 = p[42 * 8 + j];
            const real t25 = real_lt(u, -8.0) ? control_40 : (real_lt(u, -7.0) ? control_41 : t24);
            const real control_39 = p[41 * 8 + j];
            const real control_38 = p[40 * 8 + j];
            const real t26 = real_lt(u, -10.0) ? control_38 : (real_lt(u, -9.0) ? control_39 : t25);
            const real control_37 = p[39 * 8 + j];
            const real control_36 = p[38 * 8 + j];
            const real t27 = real_lt(u, -12.0) ? control_36 : (real_lt(u, -11.0) ? control_37 : t26);
            const real control_35 = p[37 * 8 + j];
            const real control_34 = p[36 * 8 + j];
            const real t28 = real_lt(u, -14.0) ? control_34 : (real_lt(u, -13.0) ? control_35 : t27);
            const real control_33 = p[35 * 8 + j];
            const real control_32 = p[34 * 8 + j];
            const real t29 = real_lt(u, -16.0) ? control_32 : (real_lt(u, -15.0) ? control_33 : t28);
            const real control_31 = p[33 * 8 + j];
            const real control_30 = p[32 * 8 + j];
            const real t30 = real_lt(u, -18.0) ? control_30 : (real_lt(u, -17.0) ? control_31 : t29);
            const real control_29 = p[31 * 8 + j];
            const real control_28 = p[30 * 8 + j];
            const real t31 = real_lt(u, -20.0) ? control_28 : (real_lt(u, -19.0) ? control_29 : t30);
            const real control_27 = p[29 * 8 + j];
            const real control_26 = p[28 * 8 + j];
            const real t32 = real_lt(u, -22.0) ? control_26 : (real_lt(u, -21.0) ? control_27 : t31);
            const real control_25 = p[27 * 8 + j];
            const real c3 = real_lt(u, -23.0) ? control_25 : t32;
            const real t41 = real_lt(u, 22.0) ? 21.0 : (real_lt(u, 23.0) ? 22.0 : 23.0);
            const real t42 = real_lt(u, 20.0) ? 19.0 : (real_lt(u, 21.0) ? 20.0 : t41);
            const real t43 = real_lt(u, 18.0) ? 17.0 : (real_lt(u, 19.0) ? 18.0 : t42);
            const real t44 = real_lt(u, 16.0) ? 15.0 : (real_lt(u, 17.0) ? 16.0 : t43);
            const real t45 = real_lt(u, 14.0) ? 13.0 : (real_lt(u, 15.0) ? 14.0 : t44);
            const real t46 = real_lt(u, 12.0) ? 11.0 : (real_lt(u, 13.0) ? 12.0 : t45);
            const real t47 = real_lt(u, 9.0) ? 8.0 : (real_lt(u, 10.0) ? 9.0 : (real_lt(u, 11.0) ? 10.0 : t46));
            const real t48 = real_lt(u, 6.0) ? 5.0 : (real_lt(u, 7.0) ? 6.0 : (real_lt(u, 8.0) ? 7.0 : t47));
            const real t49 = real_lt(u, 3.0) ? 2.0 : (real_lt(u, 4.0) ? 3.0 : (real_lt(u, 5.0) ? 4.0 : t48));
            const real t50 = real_lt(u, 0.0) ? -1.0 : (real_lt(u, 1.0) ? 0.0 : (real_lt(u, 2.0) ? 1.0 : t49));
            const real t51 = real_lt(u, -2.0) ? -3.0 : (real_lt(u, -1.0) ? -2.0 : t50);
            const real t52 = real_lt(u, -4.0) ? -5.0 : (real_lt(u, -3.0) ? -4.0 : t51);
            const real t53 = real_lt(u, -6.0) ? -7.0 : (real_lt(u, -5.0) ? -6.0 : t52);
            const real t54 = real_lt(u, -8.0) ? -9.0 : (real_lt(u, -7.0) ? -8.0 : t53);
            const real t55 = real_lt(u, -10.0) ? -11.0 : (real_lt(u, -9.0) ? -10.0 : t54);
            const real t56 = real_lt(u, -12.0) ? -13.0 : (real_lt(u, -11.0) ? -12.0 : t55);
            const real t57 = real_lt(u, -14.0) ? -15.0 : (real_lt(u, -13.0) ? -14.0 : t56);
            const real t58 = real_lt(u, -16.0) ? -17.0 : (real_lt(u, -15.0) ? -16.0 : t57);
            const real t59 = real_lt(u, -18.0) ? -19.0 : (real_lt(u, -17.0) ? -18.0 : t58);
            const real t60 = real_lt(u, -20.0) ? -21.0 : (real_lt(u, -19.0) ? -20.0 : t59);
            const real t61 = real_lt(u, -22.0) ? -23.0 : (real_lt(u, -21.0) ? -22.0 : t60);
            const real t_ = u - (real_lt(u, -23.0) ? -24.0 : t61);
            const real t62 = 1.0 + t_;
            const real t64 = t62 * t63[j];
            const real t65 = t62 * t40[j];
            const real t66 = t62 * t62;
            const real t68 = 15.278874536821952 * (t64 * t65) + 7.639437268410976 * (t66 * t67[j]);
            const real t69 = t40[j] * t68;
            const real t70 = t66 * t64;
            const real t79 = t78[j] + t62 * t77[j];
            const real t80 = t69 + t63[j] * (15.278874536821952 * (t65 * t65) + t66 * t79);
            const real t82 = 233.44400711194623 * (t65 * t67[j]) + 7.639437268410976 * (t66 * t81[j]);
            const real t83 = 7.639437268410976 * t80 + t62 * (15.278874536821952 * (t64 * t79) + t82);
            const real t84 = 233.44400711194623 * (t69 + t70 * t77[j]) + 30.557749073643905 * t83;
            const real t85 = t_ * t63[j];
            const real t86 = t_ * t40[j];
            const real t87 = t_ * t_;
            const real t88 = 15.278874536821952 * (t85 * t86) + 7.639437268410976 * (t87 * t67[j]);
            const real t89 = t40[j] * t88;
            const real t90 = t87 * t85;
            const real t91 = t78[j] + t_ * t77[j];
            const real t92 = t89 + t63[j] * (15.278874536821952 * (t86 * t86) + t87 * t91);
            const real t93 = 233.44400711194623 * (t86 * t67[j]) + 7.639437268410976 * (t87 * t81[j]);
            const real t94 = 7.639437268410976 * t92 + t_ * (15.278874536821952 * (t85 * t91) + t93);
            const real t95 = 233.44400711194623 * (t89 + t90 * t77[j]) + 30.557749073643905 * t94;
            const real t96 = 2.0 + t_;
            const real t97 = t96 * t63[j];
            const real t98 = t96 * t40[j];
            const real t99 = t96 * t96;
            const real t100 = 15.278874536821952 * (t97 * t98) + 7.639437268410976 * (t99 * t67[j]);
            const real t101 = t40[j] * t100;
            const real t102 = t99 * t97;
            const real t103 = t78[j] + t96 * t77[j];
            const real t104 = t101 + t63[j] * (15.278874536821952 * (t98 * t98) + t99 * t103);
            const real t105 = 233.44400711194623 * (t98 * t67[j]) + 7.639437268410976 * (t99 * t81[j]);
            const real t106 = 7.639437268410976 * t104 + t96 * (15.278874536821952 * (t97 * t103) + t105);
            const real t107 = 233.44400711194623 * (t101 + t102 * t77[j]) + 30.557749073643905 * t106;
            const real t108 = c3 * (0.05 * t84 - 0.125 * t95 - 0.008333333333333333 * t107);
            const real t109 = real_lt(u, 22.0) ? control_23 : (real_lt(u, 23.0) ? control_24 : control_25);
            const real t110 = real_lt(u, 20.0) ? control_21 : (real_lt(u, 21.0) ? control_22 : t109);
            const real t111 = real_lt(u, 18.0) ? control_19 : (real_lt(u, 19.0) ? control_20 : t110);
            const real t112 = real_lt(u, 16.0) ? control_17 : (real_lt(u, 17.0) ? control_18 : t111);
            const real t113 = real_lt(u, 14.0) ? control_15 : (real_lt(u, 15.0) ? control_16 : t112);
            const real t114 = real_lt(u, 12.0) ? control_13 : (real_lt(u, 13.0) ? control_14 : t113);
            const real t115 = real_lt(u, 10.0) ? control_11 : (real_lt(u, 11.0) ? control_12 : t114);
            const real t116 = real_lt(u, 8.0) ? control_9 : (real_lt(u, 9.0) ? control_10 : t115);
            const real t117 = real_lt(u, 6.0) ? control_7 : (real_lt(u, 7.0) ? control_8 : t116);
            const real t118 = real_lt(u, 4.0) ? control_5 : (real_lt(u, 5.0) ? control_6 : t117);
            const real t119 = real_lt(u, 2.0) ? control_3 : (real_lt(u, 3.0) ? control_4 : t118);
            const real t120 = real_lt(u, 0.0) ? control_1 : (real_lt(u, 1.0) ? control_2 : t119);
            const real t121 = real_lt(u, -2.0) ? control_47 : (real_lt(u, -1.0) ? control_0 : t120);
            const real t122 = real_lt(u, -4.0) ? control_45 : (real_lt(u, -3.0) ? control_46 : t121);
            const real t123 = real_lt(u, -6.0) ? control_43 : (real_lt(u, -5.0) ? control_44 : t122);
            const real t124 = real_lt(u, -8.0) ? control_41 : (real_lt(u, -7.0) ? control_42 : t123);
            const real t125 = real_lt(u, -10.0) ? control_39 : (real_lt(u, -9.0) ? control_40 : t124);
            const real t126 = real_lt(u, -12.0) ? control_37 : (real_lt(u, -11.0) ? control_38 : t125);
            const real t127 = real_lt(u, -14.0) ? control_35 : (real_lt(u, -13.0) ? control_36 : t126);
            const real t128 = real_lt(u, -16.0) ? control_33 : (real_lt(u, -15.0) ? control_34 : t127);
            const real t129 = real_lt(u, -18.0) ? control_31 : (real_lt(u, -17.0) ? control_32 : t128);
            const real t130 = real_lt(u, -20.0) ? control_29 : (real_lt(u, -19.0) ? control_30 : t129);
            const real t131 = real_lt(u, -22.0) ? control_27 : (real_lt(u, -21.0) ? control_28 : t130);
            const real c4 = real_lt(u, -23.0) ? control_26 : t131;
            const real t132 = real_lt(u, 22.0) ? control_21 : (real_lt(u, 23.0) ? control_22 : control_23);
            const real t133 = real_lt(u, 20.0) ? control_19 : (real_lt(u, 21.0) ? control_20 : t132);
            const real t134 = real_lt(u, 18.0) ? control_17 : (real_lt(u, 19.0) ? control_18 : t133);
            const real t135 = real_lt(u, 16.0) ? control_15 : (real_lt(u, 17.0) ? control_16 : t134);
            const real t136 = real_lt(u, 14.0) ? control_13 : (real_lt(u, 15.0) ? control_14 : t135);
            const real t137 = real_lt(u, 12.0) ? control_11 : (real_lt(u, 13.0) ? control_12 : t136);
            const real t138 = real_lt(u, 10.0) ? control_9 : (real_lt(u, 11.0) ? control_10 : t137);
            const real t139 = real_lt(u, 8.0) ? control_7 : (real_lt(u, 9.0) ? control_8 : t138);
            const real t140 = real_lt(u, 6.0) ? control_5 : (real_lt(u, 7.0) ? control_6 : t139);
            const real t141 = real_lt(u, 4.0) ? control_3 : (real_lt(u, 5.0) ? control_4 : t140);
            const real t142 = real_lt(u, 2.0) ? control_1 : (real_lt(u, 3.0) ? control_2 : t141);
            const real t143 = real_lt(u, 0.0) ? control_47 : (real_lt(u, 1.0) ? control_0 : t142);
            const real t144 = real_lt(u, -2.0) ? control_45 : (real_lt(u, -1.0) ? control_46 : t143);
            const real t145 = real_lt(u, -4.0) ? control_43 : (real_lt(u, -3.0) ? control_44 : t144);
            const real t146 = real_lt(u, -6.0) ? control_41 : (real_lt(u, -5.0) ? control_42 : t145);
            const real t147 = real_lt(u, -8.0) ? control_39 : (real_lt(u, -7.0) ? control_40 : t146);
            const real t148 = real_lt(u, -10.0) ? control_37 : (real_lt(u, -9.0) ? control_38 : t147);
            const real t149 = real_lt(u, -12.0) ? control_35 : (real_lt(u, -11.0) ? control_36 : t148);
            const real t150 = real_lt(u, -14.0) ? control_33 : (real_lt(u, -13.0) ? control_34 : t149);
            const real t151 = real_lt(u, -16.0) ? control_31 : (real_lt(u, -15.0) ? control_32 : t150);
            const real t152 = real_lt(u, -18.0) ? control_29 : (real_lt(u, -17.0) ? control_30 : t151);
            const real t153 = real_lt(u, -20.0) ? control_27 : (real_lt(u, -19.0) ? control_28 : t152);
            const real t154 = real_lt(u, -22.0) ? control_25 : (real_lt(u, -21.0) ? control_26 : t153);
            const real c2 = real_lt(u, -23.0) ? control_24 : t154;
            const real t155 = 3.0 + t_;
            const real t156 = t155 * t63[j];
            const real t157 = t155 * t40[j];
            const real t158 = t155 * t155;
            const real t159 = 15.278874536821952 * (t156 * t157) + 7.639437268410976 * (t158 * t67[j]);
            const real t160 = t40[j] * t159;
            const real t161 = t158 * t156;
            const real t162 = t78[j] + t155 * t77[j];
            const real t163 = t63[j] * (15.278874536821952 * (t157 * t157) + t158 * t162);
            const real t164 = 233.44400711194623 * (t157 * t67[j]) + 7.639437268410976 * (t158 * t81[j]);
            const real t165 = 7.639437268410976 * (t160 + t163) + t155 * (15.278874536821952 * (t156 * t162) + t164);
            const real t166 = 233.44400711194623 * (t160 + t161 * t77[j]) + 30.557749073643905 * t165;
            const real t167 = 0.05 * t107 + 0.16666666666666666 * t95 - 0.125 * t84 - 0.008333333333333333 * t166;
            const real t168 = real_lt(u, 22.0) ? control_20 : (real_lt(u, 23.0) ? control_21 : control_22);
            const real t169 = real_lt(u, 20.0) ? control_18 : (real_lt(u, 21.0) ? control_19 : t168);
            const real t170 = real_lt(u, 18.0) ? control_16 : (real_lt(u, 19.0) ? control_17 : t169);
            const real t171 = real_lt(u, 16.0) ? control_14 : (real_lt(u, 17.0) ? control_15 : t170);
            const real t172 = real_lt(u, 14.0) ? control_12 : (real_lt(u, 15.0) ? control_13 : t171);
            const real t173 = real_lt(u, 12.0) ? control_10 : (real_lt(u, 13.0) ? control_11 : t172);
            const real t174 = real_lt(u, 10.0) ? control_8 : (real_lt(u, 11.0) ? control_9 : t173);
            const real t175 = real_lt(u, 8.0) ? control_6 : (real_lt(u, 9.0) ? control_7 : t174);
            const real t176 = real_lt(u, 6.0) ? control_4 : (real_lt(u, 7.0) ? control_5 : t175);
            const real t177 = real_lt(u, 4.0) ? control_2 : (real_lt(u, 5.0) ? control_3 : t176);
            const real t178 = real_lt(u, 2.0) ? control_0 : (real_lt(u, 3.0) ? control_1 : t177);
            const real t179 = real_lt(u, 0.0) ? control_46 : (real_lt(u, 1.0) ? control_47 : t178);
            const real t180 = real_lt(u, -2.0) ? control_44 : (real_lt(u, -1.0) ? control_45 : t179);
            const real t181 = real_lt(u, -4.0) ? control_42 : (real_lt(u, -3.0) ? control_43 : t180);
            const real t182 = real_lt(u, -6.0) ? control_40 : (real_lt(u, -5.0) ? control_41 : t181);
            const real t183 = real_lt(u, -8.0) ? control_38 : (real_lt(u, -7.0) ? control_39 : t182);
            const real t184 = real_lt(u, -10.0) ? control_36 : (real_lt(u, -9.0) ? control_37 : t183);
            const real t185 = real_lt(u, -12.0) ? control_34 : (real_lt(u, -11.0) ? control_35 : t184);
            const real t186 = real_lt(u, -14.0) ? control_32 : (real_lt(u, -13.0) ? control_33 : t185);
            const real t187 = real_lt(u, -16.0) ? control_30 : (real_lt(u, -15.0) ? control_31 : t186);
            const real t188 = real_lt(u, -18.0) ? control_28 : (real_lt(u, -17.0) ? control_29 : t187);
            const real t189 = real_lt(u, -20.0) ? control_26 : (real_lt(u, -19.0) ? control_27 : t188);
            const real t190 = real_lt(u, -22.0) ? control_24 : (real_lt(u, -21.0) ? control_25 : t189);
            const real c1 = real_lt(u, -23.0) ? control_23 : t190;
            const real t191 = 4.0 + t_;
            const real t192 = t191 * t63[j];
            const real t193 = t191 * t40[j];
            const real t194 = t191 * t191;
            const real t195 = 15.278874536821952 * (t192 * t193) + 7.639437268410976 * (t194 * t67[j]);
            const real t196 = t40[j] * t195;
            const real t197 = t194 * t192;
            const real t198 = t78[j] + t191 * t77[j];
            const real t199 = t63[j] * (15.278874536821952 * (t193 * t193) + t194 * t198);
            const real t200 = 233.44400711194623 * (t193 * t67[j]) + 7.639437268410976 * (t194 * t81[j]);
            const real t201 = 7.639437268410976 * (t196 + t199) + t191 * (15.278874536821952 * (t192 * t198) + t200);
            const real t202 = 233.44400711194623 * (t196 + t197 * t77[j]) + 30.557749073643905 * t201;
            const real t203 = 0.05 * t166 + 0.16666666666666666 * t84 - 0.008333333333333333 * t202;
            const real t204 = real_lt(u, 22.0) ? control_19 : (real_lt(u, 23.0) ? control_20 : control_21);
            const real t205 = real_lt(u, 20.0) ? control_17 : (real_lt(u, 21.0) ? control_18 : t204);
            const real t206 = real_lt(u, 18.0) ? control_15 : (real_lt(u, 19.0) ? control_16 : t205);
            const real t207 = real_lt(u, 16.0) ? control_13 : (real_lt(u, 17.0) ? control_14 : t206);
            const real t208 = real_lt(u, 14.0) ? control_11 : (real_lt(u, 15.0) ? control_12 : t207);
            const real t209 = real_lt(u, 12.0) ? control_9 : (real_lt(u, 13.0) ? control_10 : t208);
            const real t210 = real_lt(u, 10.0) ? control_7 : (real_lt(u, 11.0) ? control_8 : t209);
            const real t211 = real_lt(u, 8.0) ? control_5 : (real_lt(u, 9.0) ? control_6 : t210);
            const real t212 = real_lt(u, 6.0) ? control_3 : (real_lt(u, 7.0) ? control_4 : t211);
            const real t213 = real_lt(u, 4.0) ? control_1 : (real_lt(u, 5.0) ? control_2 : t212);
            const real t214 = real_lt(u, 2.0) ? control_47 : (real_lt(u, 3.0) ? control_0 : t213);
            const real t215 = real_lt(u, 0.0) ? control_45 : (real_lt(u, 1.0) ? control_46 : t214);
            const real t216 = real_lt(u, -2.0) ? control_43 : (real_lt(u, -1.0) ? control_44 : t215);
            const real t217 = real_lt(u, -4.0) ? control_41 : (real_lt(u, -3.0) ? control_42 : t216);
            const real t218 = real_lt(u, -6.0) ? control_39 : (real_lt(u, -5.0) ? control_40 : t217);
            const real t219 = real_lt(u, -8.0) ? control_37 : (real_lt(u, -7.0) ? control_38 : t218);
            const real t220 = real_lt(u, -10.0) ? control_35 : (real_lt(u, -9.0) ? control_36 : t219);
            const real t221 = real_lt(u, -12.0) ? control_33 : (real_lt(u, -11.0) ? control_34 : t220);
            const real t222 = real_lt(u, -14.0) ? control_31 : (real_lt(u, -13.0) ? control_32 : t221);
            const real t223 = real_lt(u, -16.0) ? control_29 : (real_lt(u, -15.0) ? control_30 : t222);
            const real t224 = real_lt(u, -18.0) ? control_27 : (real_lt(u, -17.0) ? control_28 : t223);
            const real t225 = real_lt(u, -20.0) ? control_25 : (real_lt(u, -19.0) ? control_26 : t224);
            const real t226 = real_lt(u, -22.0) ? control_23 : (real_lt(u, -21.0) ? control_24 : t225);
            const real c0 = real_lt(u, -23.0) ? control_22 : t226;
            const real t227 = 5.0 + t_;
            const real t228 = t227 * t63[j];
            const real t229 = t227 * t40[j];
            const real t230 = t227 * t227;
            const real t231 = 15.278874536821952 * (t228 * t229) + 7.639437268410976 * (t230 * t67[j]);
            const real t232 = t40[j] * t231;
            const real t233 = t230 * t228;
            const real t234 = t78[j] + t227 * t77[j];
            const real t235 = t63[j] * (15.278874536821952 * (t229 * t229) + t230 * t234);
            const real t236 = 233.44400711194623 * (t229 * t67[j]) + 7.639437268410976 * (t230 * t81[j]);
            const real t237 = 7.639437268410976 * (t232 + t235) + t227 * (15.278874536821952 * (t228 * t234) + t236);
            const real t238 = 233.44400711194623 * (t232 + t233 * t77[j]) + 30.557749073643905 * t237;
            const real t239 = 0.16666666666666666 * t107 + 0.05 * (t95 + t202) - 0.008333333333333333 * t238;
            const real t240 = c1 * (t203 - 0.125 * (t95 + t107)) + c0 * (t239 - 0.125 * (t84 + t166));
            const real t241 = c2 * t167 + t240 + c4 * (0.05 * t95 - 0.008333333333333333 * t84);
            const real t242 = real_lt(u, 22.0) ? control_24 : (real_lt(u, 23.0) ? control_25 : control_26);
            const real t243 = real_lt(u, 20.0) ? control_22 : (real_lt(u, 21.0) ? control_23 : t242);
            const real t244 = real_lt(u, 18.0) ? control_20 : (real_lt(u, 19.0) ? control_21 : t243);
            const real t245 = real_lt(u, 16.0) ? control_18 : (real_lt(u, 17.0) ? control_19 : t244);
            const real t246 = real_lt(u, 14.0) ? control_16 : (real_lt(u, 15.0) ? control_17 : t245);
            const real t247 = real_lt(u, 12.0) ? control_14 : (real_lt(u, 13.0) ? control_15 : t246);
            const real t248 = real_lt(u, 10.0) ? control_12 : (real_lt(u, 11.0) ? control_13 : t247);
            const real t249 = real_lt(u, 8.0) ? control_10 : (real_lt(u, 9.0) ? control_11 : t248);
            const real t250 = real_lt(u, 6.0) ? control_8 : (real_lt(u, 7.0) ? control_9 : t249);
            const real t251 = real_lt(u, 4.0) ? control_6 : (real_lt(u, 5.0) ? control_7 : t250);
            const real t252 = real_lt(u, 2.0) ? control_4 : (real_lt(u, 3.0) ? control_5 : t251);
            const real t253 = real_lt(u, 0.0) ? control_2 : (real_lt(u, 1.0) ? control_3 : t252);
            const real t254 = real_lt(u, -2.0) ? control_0 : (real_lt(u, -1.0) ? control_1 : t253);
            const real t255 = real_lt(u, -4.0) ? control_46 : (real_lt(u, -3.0) ? control_47 : t254);
            const real t256 = real_lt(u, -6.0) ? control_44 : (real_lt(u, -5.0) ? control_45 : t255);
            const real t257 = real_lt(u, -8.0) ? control_42 : (real_lt(u, -7.0) ? control_43 : t256);
            const real t258 = real_lt(u, -10.0) ? control_40 : (real_lt(u, -9.0) ? control_41 : t257);
            const real t259 = real_lt(u, -12.0) ? control_38 : (real_lt(u, -11.0) ? control_39 : t258);
            const real t260 = real_lt(u, -14.0) ? control_36 : (real_lt(u, -13.0) ? control_37 : t259);
            const real t261 = real_lt(u, -16.0) ? control_34 : (real_lt(u, -15.0) ? control_35 : t260);
            const real t262 = real_lt(u, -18.0) ? control_32 : (real_lt(u, -17.0) ? control_33 : t261);
            const real t263 = real_lt(u, -20.0) ? control_30 : (real_lt(u, -19.0) ? control_31 : t262);
            const real t264 = real_lt(u, -22.0) ? control_28 : (real_lt(u, -21.0) ? control_29 : t263);
            const real c5 = real_lt(u, -23.0) ? control_27 : t264;
            const real t265 = t108 + t241 - 0.008333333333333333 * (c5 * t95);
            const real t271 = t66 * t63[j];
            const real t272 = t62 * t270[j];
            const real t274 = 15.278874536821952 * (t64 * t272) + 7.639437268410976 * (t66 * t273[j]);
            const real t275 = 30.557749073643905 * (7.639437268410976 * (t271 * t272) + t62 * t274);
            const real t276 = 233.44400711194623 * (t70 * t270[j]) + t275;
            const real t277 = t87 * t63[j];
            const real t278 = t_ * t270[j];
            const real t279 = 15.278874536821952 * (t85 * t278) + 7.639437268410976 * (t87 * t273[j]);
            const real t280 = 30.557749073643905 * (7.639437268410976 * (t277 * t278) + t_ * t279);
            const real t281 = 233.44400711194623 * (t90 * t270[j]) + t280;
            const real t282 = t99 * t63[j];
            const real t283 = t96 * t270[j];
            const real t284 = 15.278874536821952 * (t97 * t283) + 7.639437268410976 * (t99 * t273[j]);
            const real t285 = 30.557749073643905 * (7.639437268410976 * (t282 * t283) + t96 * t284);
            const real t286 = 233.44400711194623 * (t102 * t270[j]) + t285;
            const real t287 = c3 * (0.05 * t276 - 0.125 * t281 - 0.008333333333333333 * t286);
            const real t288 = t158 * t63[j];
            const real t289 = t155 * t270[j];
            const real t290 = 15.278874536821952 * (t156 * t289) + 7.639437268410976 * (t158 * t273[j]);
            const real t291 = 30.557749073643905 * (7.639437268410976 * (t288 * t289) + t155 * t290);
            const real t292 = 233.44400711194623 * (t161 * t270[j]) + t291;
            const real t293 = 0.05 * t286 + 0.16666666666666666 * t281 - 0.125 * t276 - 0.008333333333333333 * t292;
            const real t294 = t194 * t63[j];
            const real t295 = t191 * t270[j];
            const real t296 = 15.278874536821952 * (t192 * t295) + 7.639437268410976 * (t194 * t273[j]);
            const real t297 = 30.557749073643905 * (7.639437268410976 * (t294 * t295) + t191 * t296);
            const real t298 = 233.44400711194623 * (t197 * t270[j]) + t297;
            const real t299 = t230 * t63[j];
            const real t300 = t227 * t270[j];
            const real t301 = 15.278874536821952 * (t228 * t300) + 7.639437268410976 * (t230 * t273[j]);
            const real t302 = 30.557749073643905 * (7.639437268410976 * (t299 * t300) + t227 * t301);
            const real t303 = 0.008333333333333333 * (233.44400711194623 * (t233 * t270[j]) + t302);
            const real t304 = 0.16666666666666666 * t286 + 0.05 * (t281 + t298) - t303 - 0.125 * (t276 + t292);
            const real t305 = 0.05 * t292 + 0.16666666666666666 * t276 - 0.008333333333333333 * t298;
            const real t306 = c0 * t304 + c1 * (t305 - 0.125 * (t281 + t286)) + c2 * t293;
            const real t307 = c4 * (0.05 * t281 - 0.008333333333333333 * t276) + t306 + t287;
            const real t308 = t307 - 0.008333333333333333 * (c5 * t281);
            Psi_x[2 * 8 + j] = -(t265 + t308); /* Psi_x(0,2) */
            Psi_x[5 * 8 + j] = t311[j] + t308 + t265 + t309[j] - t314[j] - t315[j] - t317[j]; /* Psi_x(0,5) */
            const real t320 = 30.557749073643905 * (7.639437268410976 * (t65 * t271) + t62 * t68);
            const real t321 = 233.44400711194623 * (t70 * t40[j]) + t320;
            const real t322 = 30.557749073643905 * (7.639437268410976 * (t86 * t277) + t_ * t88);
            const real t323 = 233.44400711194623 * (t90 * t40[j]) + t322;
            const real t324 = 30.557749073643905 * (7.639437268410976 * (t98 * t282) + t96 * t100);
            const real t325 = 233.44400711194623 * (t102 * t40[j]) + t324;
            const real t326 = c3 * (0.05 * t321 - 0.125 * t323 - 0.008333333333333333 * t325);
            const real t327 = 30.557749073643905 * (7.639437268410976 * (t157 * t288) + t155 * t159);
            const real t328 = 233.44400711194623 * (t161 * t40[j]) + t327;
            const real t329 = 0.05 * t325 + 0.16666666666666666 * t323 - 0.125 * t321 - 0.008333333333333333 * t328;
            const real t330 = 30.557749073643905 * (7.639437268410976 * (t193 * t294) + t191 * t195);
            const real t331 = 233.44400711194623 * (t197 * t40[j]) + t330;
            const real t332 = 30.557749073643905 * (7.639437268410976 * (t229 * t299) + t227 * t231);
            const real t333 = 0.008333333333333333 * (233.44400711194623 * (t233 * t40[j]) + t332);
            const real t334 = 0.16666666666666666 * t325 + 0.05 * (t323 + t331) - t333 - 0.125 * (t321 + t328);
            const real t335 = 0.05 * t328 + 0.16666666666666666 * t321 - 0.008333333333333333 * t331;
            const real t336 = c0 * t334 + c1 * (t335 - 0.125 * (t323 + t325)) + c2 * t329;
            const real t337 = c4 * (0.05 * t323 - 0.008333333333333333 * t321) + t336 + t326;
            const real t338 = t337 - 0.008333333333333333 * (c5 * t323);
            Psi_v[2 * 8 + j] = -(2.0 * t338); /* Psi_v(0,2) */
            Psi_v[5 * 8 + j] = 2.0 * (t339[j] + t338 - t340[j] - t341[j] - t342[j]); /* Psi_v(0,5) */
        }
    }
}

/* stiffness: 608 operations.
 * in:  x (6), sigma (1), tau (0), p (50)
 * out: K (6,6), 12 of 36 entries */
FLEXEL_CLONES
static void planar_flat_cam_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict p = in[3] + b * (50 * 8);
        real *restrict K = out[0] + b * (12 * 8);
        real t0[8], sin_q[8], cos_q[8], t1[8], cos_p[8], sin_p[8], b_[8], a_[8], t2[8], t4[8], t5[8], psi[8], t207[8],
            t214[8], t215[8], t216[8], t224[8], t230[8], t232[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[1 * 8 + j];
            t0[j] = rq_angle + alphaq0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t1[j] = rp_angle + alpha0;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real sigma_gap = sigma[0 * 8 + j];
            t230[j] = d_y * sigma_gap;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            t232[j] = d_x * sigma_gap;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_q[j] = real_sin(t0[j]);
            cos_q[j] = real_cos(t0[j]);
            cos_p[j] = real_cos(t1[j]);
            sin_p[j] = real_sin(t1[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_gap = sigma[0 * 8 + j];
            const real q_fy = sin_q[j] * sigma_gap;
            K[0 * 8 + j] = K[6 * 8 + j] = q_fy; /* K(0,5) K(5,0) */
            const real q_fx = cos_q[j] * sigma_gap;
            K[5 * 8 + j] = K[10 * 8 + j] = q_fx; /* K(4,5) K(5,4) */
            K[1 * 8 + j] = K[7 * 8 + j] = -q_fx; /* K(1,5) K(5,1) */
            b_[j] = cos_p[j] * sin_q[j] - sin_p[j] * cos_q[j];
            a_[j] = cos_p[j] * cos_q[j] + sin_p[j] * sin_q[j];
            t2[j] = 1.0 / (b_[j] * b_[j] + a_[j] * a_[j]);
            const real t3 = t2[j] * t2[j];
            t4[j] = a_[j] * t3;
            t5[j] = b_[j] * t4[j];
            t207[j] = b_[j] * t3;
            t214[j] = a_[j] * t2[j];
            t215[j] = b_[j] * t2[j];
            t216[j] = (a_[j] * t214[j] + b_[j] * t215[j]) * (a_[j] * t214[j] + b_[j] * t215[j]);
            t224[j] = a_[j] * t207[j];
            K[4 * 8 + j] = K[9 * 8 + j] = -q_fy; /* K(3,5) K(5,3) */
        }
        for (size_t j = 0; j < 8; j++) {
            psi[j] = real_atan2(b_[j], a_[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real u = 7.639437268410976 * psi[j];
            const real t6 = real_lt(u, 22.0) ? 21.0 : (real_lt(u, 23.0) ? 22.0 : 23.0);
            const real t7 = real_lt(u, 19.0) ? 18.0 : (real_lt(u, 20.0) ? 19.0 : (real_lt(u, 21.0) ? 20.0 : t6));
            const real t8 = real_lt(u, 16.0) ? 15.0 : (real_lt(u, 17.0) ? 16.0 : (real_lt(u, 18.0) ? 17.0 : t7));
            const real t9 = real_lt(u, 13.0) ? 12.0 : (real_lt(u, 14.0) ? 13.0 : (real_lt(u, 15.0) ? 14.0 : t8));
            const real t10 = real_lt(u, 10.0) ? 9.0 : (real_lt(u, 11.0) ? 10.0 : (real_lt(u, 12.0) ? 11.0 : t9));
            const real t11 = real_lt(u, 7.0) ? 6.0 : (real_lt(u, 8.0) ? 7.0 : (real_lt(u, 9.0) ? 8.0 : t10));
            const real t12 = real_lt(u, 4.0) ? 3.0 : (real_lt(u, 5.0) ? 4.0 : (real_lt(u, 6.0) ? 5.0 : t11));
            const real t13 = real_lt(u, 1.0) ? 0.0 : (real_lt(u, 2.0) ? 1.0 : (real_lt(u, 3.0) ? 2.0 : t12));
            const real t14 = real_lt(u, -2.0) ? -3.0 : (real_lt(u, -1.0) ? -2.0 : (real_lt(u, 0.0) ? -1.0 : t13));
            const real t15 = real_lt(u, -4.0) ? -5.0 : (real_lt(u, -3.0) ? -4.0 : t14);
            const real t16 = real_lt(u, -6.0) ? -7.0 : (real_lt(u, -5.0) ? -6.0 : t15);
            const real t17 = real_lt(u, -8.0) ? -9.0 : (real_lt(u, -7.0) ? -8.0 : t16);
            const real t18 = real_lt(u, -10.0) ? -11.0 : (real_lt(u, -9.0) ? -10.0 : t17);
            const real t19 = real_lt(u, -12.0) ? -13.0 : (real_lt(u, -11.0) ? -12.0 : t18);
            const real t20 = real_lt(u, -14.0) ? -15.0 : (real_lt(u, -13.0) ? -14.0 : t19);
            const real t21 = real_lt(u, -16.0) ? -17.0 : (real_lt(u, -15.0) ? -16.0 : t20);
            const real t22 = real_lt(u, -18.0) ? -19.0 : (real_lt(u, -17.0) ? -18.0 : t21);
            const real t23 = real_lt(u, -20.0) ? -21.0 : (real_lt(u, -19.0) ? -20.0 : t22);
            const real t24 = real_lt(u, -22.0) ? -23.0 : (real_lt(u, -21.0) ? -22.0 : t23);
            const real t_ = u - (real_lt(u, -23.0) ? -24.0 : t24);
            const real t25 = t_ * t_;
            const real control_24 = p[26 * 8 + j];
            const real control_25 = p[27 * 8 + j];
            const real control_23 = p[25 * 8 + j];
            const real t26 = real_lt(u, 22.0) ? control_23 : (real_lt(u, 23.0) ? control_24 : control_25);
            const real control_22 = p[24 * 8 + j];
            const real control_21 = p[23 * 8 + j];
            const real t27 = real_lt(u, 20.0) ? control_21 : (real_lt(u, 21.0) ? control_22 : t26);
            const real control_20 = p[22 * 8 + j];
            const real control_19 = p[21 * 8 + j];
            const real t28 = real_lt(u, 18.0) ? control_19 : (real_lt(u, 19.0) ? control_20 : t27);
            const real control_18 = p[20 * 8 + j];
            const real control_17 = p[19 * 8 + j];
            const real t29 = real_lt(u, 16.0) ? control_17 : (real_lt(u, 17.0) ? control_18 : t28);
            const real control_16 = p[18 * 8 + j];
            const real control_15 = p[17 * 8 + j];
            const real t30 = real_lt(u, 14.0) ? control_15 : (real_lt(u, 15.0) ? control_16 : t29);
            const real control_14 = p[16 * 8 + j];
            const real control_13 = p[15 * 8 + j];
            const real t31 = real_lt(u, 12.0) ? control_13 : (real_lt(u, 13.0) ? control_14 : t30);
            const real control_12 = p[14 * 8 + j];
            const real control_11 = p[13 * 8 + j];
            const real t32 = real_lt(u, 10.0) ? control_11 : (real_lt(u, 11.0) ? control_12 : t31);
            const real control_10 = p[12 * 8 + j];
            const real control_9 = p[11 * 8 + j];
            const real t33 = real_lt(u, 8.0) ? control_9 : (real_lt(u, 9.0) ? control_10 : t32);
            const real control_8 = p[10 * 8 + j];
            const real control_7 = p[9 * 8 + j];
            const real t34 = real_lt(u, 6.0) ? control_7 : (real_lt(u, 7.0) ? control_8 : t33);
            const real control_6 = p[8 * 8 + j];
            const real control_5 = p[7 * 8 + j];
            const real t35 = real_lt(u, 4.0) ? control_5 : (real_lt(u, 5.0) ? control_6 : t34);
            const real control_4 = p[6 * 8 + j];
            const real control_3 = p[5 * 8 + j];
            const real t36 = real_lt(u, 2.0) ? control_3 : (real_lt(u, 3.0) ? control_4 : t35);
            const real control_2 = p[4 * 8 + j];
            const real control_1 = p[3 * 8 + j];
            const real t37 = real_lt(u, 0.0) ? control_1 : (real_lt(u, 1.0) ? control_2 : t36);
            const real control_0 = p[2 * 8 + j];
            const real control_47 = p[49 * 8 + j];
            const real t38 = real_lt(u, -2.0) ? control_47 : (real_lt(u, -1.0) ? control_0 : t37);
            const real control_46 = p[48 * 8 + j];
            const real control_45 = p[47 * 8 + j];
            const real t39 = real_lt(u, -4.0) ? control_45 : (real_lt(u, -3.0) ? control_46 : t38);
            const real control_44 = p[46 * 8 + j];
            const real control_43 = p[45 * 8 + j];
            const real t40 = real_lt(u, -6.0) ? control_43 : (real_lt(u, -5.0) ? control_44 : t39);
            const real control_42 = p[44 * 8 + j];
            const real control_41 = p[43 * 8 + j];
            const real t41 = real_lt(u, -8.0) ? control_41 : (real_lt(u, -7.0) ? control_42 : t40);
            const real control_40 = p[42 * 8 + j];
            const real control_39 = p[41 * 8 + j];
            const real t42 = real_lt(u, -10.0) ? control_39 : (real_lt(u, -9.0) ? control_40 : t41);
            const real control_38 = p[40 * 8 + j];
            const real control_37 = p[39 * 8 + j];
            const real t43 = real_lt(u, -12.0) ? control_37 : (real_lt(u, -11.0) ? control_38 : t42);
            const real control_36 = p[38 * 8 + j];
            const real control_35 = p[37 * 8 + j];
            const real t44 = real_lt(u, -14.0) ? control_35 : (real_lt(u, -13.0) ? control_36 : t43);
            const real control_34 = p[36 * 8 + j];
            const real control_33 = p[35 * 8 + j];
            const real t45 = real_lt(u, -16.0) ? control_33 : (real_lt(u, -15.0) ? control_34 : t44);
            const real control_32 = p[34 * 8 + j];
            const real control_31 = p[33 * 8 + j];
            const real t46 = real_lt(u, -18.0) ? control_31 : (real_lt(u, -17.0) ? control_32 : t45);
            const real control_30 = p[32 * 8 + j];
            const real control_29 = p[31 * 8 + j];
            const real t47 = real_lt(u, -20.0) ? control_29 : (real_lt(u, -19.0) ? control_30 : t46);
            const real control_28 = p[30 * 8 + j];
            const real control_27 = p[29 * 8 + j];
            const real t48 = real_lt(u, -22.0) ? control_27 : (real_lt(u, -21.0) ? control_28 : t47);
            const real control_26 = p[28 * 8 + j];
            const real c4 = real_lt(u, -23.0) ? control_26 : t48;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t49 = c4 * sigma_gap;
            const real t50 = real_lt(u, 22.0) ? control_21 : (real_lt(u, 23.0) ? control_22 : control_23);
            const real t51 = real_lt(u, 20.0) ? control_19 : (real_lt(u, 21.0) ? control_20 : t50);
            const real t52 = real_lt(u, 18.0) ? control_17 : (real_lt(u, 19.0) ? control_18 : t51);
            const real t53 = real_lt(u, 16.0) ? control_15 : (real_lt(u, 17.0) ? control_16 : t52);
            const real t54 = real_lt(u, 14.0) ? control_13 : (real_lt(u, 15.0) ? control_14 : t53);
            const real t55 = real_lt(u, 12.0) ? control_11 : (real_lt(u, 13.0) ? control_12 : t54);
            const real t56 = real_lt(u, 10.0) ? control_9 : (real_lt(u, 11.0) ? control_10 : t55);
            const real t57 = real_lt(u, 8.0) ? control_7 : (real_lt(u, 9.0) ? control_8 : t56);
            const real t58 = real_lt(u, 6.0) ? control_5 : (real_lt(u, 7.0) ? control_6 : t57);
            const real t59 = real_lt(u, 4.0) ? control_3 : (real_lt(u, 5.0) ? control_4 : t58);
            const real t60 = real_lt(u, 2.0) ? control_1 : (real_lt(u, 3.0) ? control_2 : t59);
            const real t61 = real_lt(u, 0.0) ? control_47 : (real_lt(u, 1.0) ? control_0 : t60);
            const real t62 = real_lt(u, -2.0) ? control_45 : (real_lt(u, -1.0) ? control_46 : t61);
            const real t63 = real_lt(u, -4.0) ? control_43 : (real_lt(u, -3.0) ? control_44 : t62);
            const real t64 = real_lt(u, -6.0) ? control_41 : (real_lt(u, -5.0) ? control_42 : t63);
            const real t65 = real_lt(u, -8.0) ? control_39 : (real_lt(u, -7.0) ? control_40 : t64);
            const real t66 = real_lt(u, -10.0) ? control_37 : (real_lt(u, -9.0) ? control_38 : t65);
            const real t67 = real_lt(u, -12.0) ? control_35 : (real_lt(u, -11.0) ? control_36 : t66);
            const real t68 = real_lt(u, -14.0) ? control_33 : (real_lt(u, -13.0) ? control_34 : t67);
            const real t69 = real_lt(u, -16.0) ? control_31 : (real_lt(u, -15.0) ? control_32 : t68);
            const real t70 = real_lt(u, -18.0) ? control_29 : (real_lt(u, -17.0) ? control_30 : t69);
            const real t71 = real_lt(u, -20.0) ? control_27 : (real_lt(u, -19.0) ? control_28 : t70);
            const real t72 = real_lt(u, -22.0) ? control_25 : (real_lt(u, -21.0) ? control_26 : t71);
            const real c2 = real_lt(u, -23.0) ? control_24 : t72;
            const real t73 = c2 * sigma_gap;
            const real t74 = real_lt(u, 22.0) ? control_19 : (real_lt(u, 23.0) ? control_20 : control_21);
            const real t75 = real_lt(u, 20.0) ? control_17 : (real_lt(u, 21.0) ? control_18 : t74);
            const real t76 = real_lt(u, 18.0) ? control_15 : (real_lt(u, 19.0) ? control_16 : t75);
            const real t77 = real_lt(u, 16.0) ? control_13 : (real_lt(u, 17.0) ? control_14 : t76);
            const real t78 = real_lt(u, 14.0) ? control_11 : (real_lt(u, 15.0) ? control_12 : t77);
            const real t79 = real_lt(u, 12.0) ? control_9 : (real_lt(u, 13.0) ? control_10 : t78);
            const real t80 = real_lt(u, 10.0) ? control_7 : (real_lt(u, 11.0) ? control_8 : t79);
            const real t81 = real_lt(u, 8.0) ? control_5 : (real_lt(u, 9.0) ? control_6 : t80);
            const real t82 = real_lt(u, 6.0) ? control_3 : (real_lt(u, 7.0) ? control_4 : t81);
            const real t83 = real_lt(u, 4.0) ? control_1 : (real_lt(u, 5.0) ? control_2 : t82);
            const real t84 = real_lt(u, 2.0) ? control_47 : (real_lt(u, 3.0) ? control_0 : t83);
            const real t85 = real_lt(u, 0.0) ? control_45 : (real_lt(u, 1.0) ? control_46 : t84);
            const real t86 = real_lt(u, -2.0) ? control_43 : (real_lt(u, -1.0) ? control_44 : t85);
            const real t87 = real_lt(u, -4.0) ? control_41 : (real_lt(u, -3.0) ? control_42 : t86);
            const real t88 = real_lt(u, -6.0) ? control_39 : (real_lt(u, -5.0) ? control_40 : t87);
            const real t89 = real_lt(u, -8.0) ? control_37 : (real_lt(u, -7.0) ? control_38 : t88);
            const real t90 = real_lt(u, -10.0) ? control_35 : (real_lt(u, -9.0) ? control_36 : t89);
            const real t91 = real_lt(u, -12.0) ? control_33 : (real_lt(u, -11.0) ? control_34 : t90);
            const real t92 = real_lt(u, -14.0) ? control_31 : (real_lt(u, -13.0) ? control_32 : t91);
            const real t93 = real_lt(u, -16.0) ? control_29 : (real_lt(u, -15.0) ? control_30 : t92);
            const real t94 = real_lt(u, -18.0) ? control_27 : (real_lt(u, -17.0) ? control_28 : t93);
            const real t95 = real_lt(u, -20.0) ? control_25 : (real_lt(u, -19.0) ? control_26 : t94);
            const real t96 = real_lt(u, -22.0) ? control_23 : (real_lt(u, -21.0) ? control_24 : t95);
            const real c0 = real_lt(u, -23.0) ? control_22 : t96;
            const real t97 = c0 * sigma_gap;
            const real t98 = 0.05 * t97;
            const real t99 = real_lt(u, 22.0) ? control_24 : (real_lt(u, 23.0) ? control_25 : control_26);
            const real t100 = real_lt(u, 20.0) ? control_22 : (real_lt(u, 21.0) ? control_23 : t99);
            const real t101 = real_lt(u, 18.0) ? control_20 : (real_lt(u, 19.0) ? control_21 : t100);
            const real t102 = real_lt(u, 16.0) ? control_18 : (real_lt(u, 17.0) ? control_19 : t101);
            const real t103 = real_lt(u, 14.0) ? control_16 : (real_lt(u, 15.0) ? control_17 : t102);
            const real t104 = real_lt(u, 12.0) ? control_14 : (real_lt(u, 13.0) ? control_15 : t103);
            const real t105 = real_lt(u, 10.0) ? control_12 : (real_lt(u, 11.0) ? control_13 : t104);
            const real t106 = real_lt(u, 8.0) ? control_10 : (real_lt(u, 9.0) ? control_11 : t105);
            const real t107 = real_lt(u, 6.0) ? control_8 : (real_lt(u, 7.0) ? control_9 : t106);
            const real t108 = real_lt(u, 4.0) ? control_6 : (real_lt(u, 5.0) ? control_7 : t107);
            const real t109 = real_lt(u, 2.0) ? control_4 : (real_lt(u, 3.0) ? control_5 : t108);
            const real t110 = real_lt(u, 0.0) ? control_2 : (real_lt(u, 1.0) ? control_3 : t109);
            const real t111 = real_lt(u, -2.0) ? control_0 : (real_lt(u, -1.0) ? control_1 : t110);
            const real t112 = real_lt(u, -4.0) ? control_46 : (real_lt(u, -3.0) ? control_47 : t111);
            const real t113 = real_lt(u, -6.0) ? control_44 : (real_lt(u, -5.0) ? control_45 : t112);
            const real t114 = real_lt(u, -8.0) ? control_42 : (real_lt(u, -7.0) ? control_43 : t113);
            const real t115 = real_lt(u, -10.0) ? control_40 : (real_lt(u, -9.0) ? control_41 : t114);
            const real t116 = real_lt(u, -12.0) ? control_38 : (real_lt(u, -11.0) ? control_39 : t115);
            const real t117 = real_lt(u, -14.0) ? control_36 : (real_lt(u, -13.0) ? control_37 : t116);
            const real t118 = real_lt(u, -16.0) ? control_34 : (real_lt(u, -15.0) ? control_35 : t117);
            const real t119 = real_lt(u, -18.0) ? control_32 : (real_lt(u, -17.0) ? control_33 : t118);
            const real t120 = real_lt(u, -20.0) ? control_30 : (real_lt(u, -19.0) ? control_31 : t119);
            const real t121 = real_lt(u, -22.0) ? control_28 : (real_lt(u, -21.0) ? control_29 : t120);
            const real c5 = real_lt(u, -23.0) ? control_27 : t121;
            const real t122 = 0.16666666666666666 * t73 + t98 + 0.05 * t49 - 0.008333333333333333 * (c5 * sigma_gap);
            const real t123 = real_lt(u, 22.0) ? control_20 : (real_lt(u, 23.0) ? control_21 : control_22);
            const real t124 = real_lt(u, 20.0) ? control_18 : (real_lt(u, 21.0) ? control_19 : t123);
            const real t125 = real_lt(u, 18.0) ? control_16 : (real_lt(u, 19.0) ? control_17 : t124);
            const real t126 = real_lt(u, 16.0) ? control_14 : (real_lt(u, 17.0) ? control_15 : t125);
            const real t127 = real_lt(u, 14.0) ? control_12 : (real_lt(u, 15.0) ? control_13 : t126);
            const real t128 = real_lt(u, 12.0) ? control_10 : (real_lt(u, 13.0) ? control_11 : t127);
            const real t129 = real_lt(u, 10.0) ? control_8 : (real_lt(u, 11.0) ? control_9 : t128);
            const real t130 = real_lt(u, 8.0) ? control_6 : (real_lt(u, 9.0) ? control_7 : t129);
            const real t131 = real_lt(u, 6.0) ? control_4 : (real_lt(u, 7.0) ? control_5 : t130);
            const real t132 = real_lt(u, 4.0) ? control_2 : (real_lt(u, 5.0) ? control_3 : t131);
            const real t133 = real_lt(u, 2.0) ? control_0 : (real_lt(u, 3.0) ? control_1 : t132);
            const real t134 = real_lt(u, 0.0) ? control_46 : (real_lt(u, 1.0) ? control_47 : t133);
            const real t135 = real_lt(u, -2.0) ? control_44 : (real_lt(u, -1.0) ? control_45 : t134);
            const real t136 = real_lt(u, -4.0) ? control_42 : (real_lt(u, -3.0) ? control_43 : t135);
            const real t137 = real_lt(u, -6.0) ? control_40 : (real_lt(u, -5.0) ? control_41 : t136);
            const real t138 = real_lt(u, -8.0) ? control_38 : (real_lt(u, -7.0) ? control_39 : t137);
            const real t139 = real_lt(u, -10.0) ? control_36 : (real_lt(u, -9.0) ? control_37 : t138);
            const real t140 = real_lt(u, -12.0) ? control_34 : (real_lt(u, -11.0) ? control_35 : t139);
            const real t141 = real_lt(u, -14.0) ? control_32 : (real_lt(u, -13.0) ? control_33 : t140);
            const real t142 = real_lt(u, -16.0) ? control_30 : (real_lt(u, -15.0) ? control_31 : t141);
            const real t143 = real_lt(u, -18.0) ? control_28 : (real_lt(u, -17.0) ? control_29 : t142);
            const real t144 = real_lt(u, -20.0) ? control_26 : (real_lt(u, -19.0) ? control_27 : t143);
            const real t145 = real_lt(u, -22.0) ? control_24 : (real_lt(u, -21.0) ? control_25 : t144);
            const real c1 = real_lt(u, -23.0) ? control_23 : t145;
            const real t146 = c1 * sigma_gap;
            const real t147 = 0.125 * t146;
            const real t148 = real_lt(u, 22.0) ? control_22 : (real_lt(u, 23.0) ? control_23 : control_24);
            const real t149 = real_lt(u, 20.0) ? control_20 : (real_lt(u, 21.0) ? control_21 : t148);
            const real t150 = real_lt(u, 18.0) ? control_18 : (real_lt(u, 19.0) ? control_19 : t149);
            const real t151 = real_lt(u, 16.0) ? control_16 : (real_lt(u, 17.0) ? control_17 : t150);
            const real t152 = real_lt(u, 14.0) ? control_14 : (real_lt(u, 15.0) ? control_15 : t151);
            const real t153 = real_lt(u, 12.0) ? control_12 : (real_lt(u, 13.0) ? control_13 : t152);
            const real t154 = real_lt(u, 10.0) ? control_10 : (real_lt(u, 11.0) ? control_11 : t153);
            const real t155 = real_lt(u, 8.0) ? control_8 : (real_lt(u, 9.0) ? control_9 : t154);
            const real t156 = real_lt(u, 6.0) ? control_6 : (real_lt(u, 7.0) ? control_7 : t155);
            const real t157 = real_lt(u, 4.0) ? control_4 : (real_lt(u, 5.0) ? control_5 : t156);
            const real t158 = real_lt(u, 2.0) ? control_2 : (real_lt(u, 3.0) ? control_3 : t157);
            const real t159 = real_lt(u, 0.0) ? control_0 : (real_lt(u, 1.0) ? control_1 : t158);
            const real t160 = real_lt(u, -2.0) ? control_46 : (real_lt(u, -1.0) ? control_47 : t159);
            const real t161 = real_lt(u, -4.0) ? control_44 : (real_lt(u, -3.0) ? control_45 : t160);
            const real t162 = real_lt(u, -6.0) ? control_42 : (real_lt(u, -5.0) ? control_43 : t161);
            const real t163 = real_lt(u, -8.0) ? control_40 : (real_lt(u, -7.0) ? control_41 : t162);
            const real t164 = real_lt(u, -10.0) ? control_38 : (real_lt(u, -9.0) ? control_39 : t163);
            const real t165 = real_lt(u, -12.0) ? control_36 : (real_lt(u, -11.0) ? control_37 : t164);
            const real t166 = real_lt(u, -14.0) ? control_34 : (real_lt(u, -13.0) ? control_35 : t165);
            const real t167 = real_lt(u, -16.0) ? control_32 : (real_lt(u, -15.0) ? control_33 : t166);
            const real t168 = real_lt(u, -18.0) ? control_30 : (real_lt(u, -17.0) ? control_31 : t167);
            const real t169 = real_lt(u, -20.0) ? control_28 : (real_lt(u, -19.0) ? control_29 : t168);
            const real t170 = real_lt(u, -22.0) ? control_26 : (real_lt(u, -21.0) ? control_27 : t169);
            const real c3 = real_lt(u, -23.0) ? control_25 : t170;
            const real t171 = c3 * sigma_gap;
            const real t172 = t122 - t147 - 0.125 * t171;
            const real t173 = t_ * t25 * t172;
            const real t174 = 1.0 + t_;
            const real t175 = t174 * t174;
            const real t176 = 0.05 * t171 + 0.16666666666666666 * t146 - 0.008333333333333333 * t49;
            const real t177 = 0.125 * t97;
            const real t178 = t176 - t177 - 0.125 * t73;
            const real t179 = t174 * t178;
            const real t180 = t175 * t179;
            const real t181 = 2.0 + t_;
            const real t182 = t181 * t181;
            const real t183 = 0.05 * t73 + 0.16666666666666666 * t97 - 0.008333333333333333 * t171;
            const real t184 = t183 - t147;
            const real t185 = t181 * t184;
            const real t186 = t182 * t185;
            const real t187 = 4.0 + t_;
            const real t188 = t187 * t187;
            const real t189 = t98 - 0.008333333333333333 * t146;
            const real t190 = t187 * t189;
            const real t191 = t188 * t190;
            const real t192 = 3.0 + t_;
            const real t193 = t192 * t192;
            const real t194 = 0.05 * t146 - 0.008333333333333333 * t73 - t177;
            const real t195 = t192 * t194;
            const real t196 = t193 * t195;
            const real t197 = t187 * t191 + t192 * t196 + t181 * t186 + t174 * t180 + t_ * t173;
            const real t198 = t188 * t188 * t189 + t193 * t193 * t194 + t182 * t182 * t184;
            const real t199 = t175 * t175 * t178 + t198 + 4.0 * t197 + t25 * t25 * t172;
            const real t200 = 5.0 + t_;
            const real t201 = t200 * t200;
            const real t202 = t200 * t97;
            const real t203 = t201 * t202;
            const real t204 = t199 - 0.03333333333333333 * (t200 * t203) - 0.008333333333333333 * (t201 * t201 * t97);
            const real t205 = b_[j] * t204;
            const real t206 = t2[j] * t204;
            const real t208 = 2.0 * t5[j] * t205 + a_[j] * (t206 - 2.0 * t207[j] * t205);
            const real t209 = 7.639437268410976 * (b_[j] * t208);
            const real t210 = 2.0 * t181 * (t182 * t184 + t181 * t185) + 2.0 * t174 * (t175 * t178 + t174 * t179);
            const real t211 = 2.0 * t192 * (t193 * t194 + t192 * t195) + t210 + t173 + 2.0 * t187 * (t188 * t189
                + t187 * t190);
            const real t212 = 0.03333333333333333 * (t203 + 2.0 * t200 * (t201 * t97 + t200 * t202));
            const real t213 = 4.0 * (t180 + t211 + t186 + t191 + t196) + 16.0 * t173 - t212;
            const real t217 = 58.36100177798656 * (t213 * t216[j]);
            const real t218 = t209 + t217;
            const real t219 = t214[j] * t204;
            const real t220 = t215[j] * t204;
            const real t221 = 7.639437268410976 * (sin_p[j] * (cos_q[j] * t219 + sin_q[j] * t220));
            const real t222 = 7.639437268410976 * (cos_p[j] * (sin_q[j] * t219 - cos_q[j] * t220));
            const real t223 = a_[j] * t204;
            const real t225 = b_[j] * (t206 - 2.0 * t4[j] * t223) + 2.0 * t224[j] * t223;
            const real t226 = 7.639437268410976 * (a_[j] * t225);
            K[2 * 8 + j] = t218 + t221 - t222 - t226; /* K(2,2) */
            const real t227 = sin_p[j] * t219;
            const real t228 = sin_p[j] * t220;
            const real t229 = t222 + t226 - 7.639437268410976 * (cos_q[j] * t227 + sin_q[j] * t228);
            K[3 * 8 + j] = K[8 * 8 + j] = t229 - t209 - t217; /* K(2,5) K(5,2) */
            const real t231 = sin_q[j] * (t230[j] + 7.639437268410976 * (cos_p[j] * t219 - t228));
            const real t233 = cos_q[j] * (t232[j] - 7.639437268410976 * (t227 + cos_p[j] * t220));
            K[11 * 8 + j] = t218 - t231 - t233 - t226; /* K(5,5) */
        }
    }
}

/* outputs: 1135 operations.
 * in:  x (6), sigma (1), tau (0), p (50)
 * out: profile (49,2), mark (2,2), 2 of 4 entries, face (2,2), 2 of 4 entries, origin_p (2), axes_p (2,2), origin_q
 *   (2), axes_q (2,2) */
FLEXEL_CLONES
static void planar_flat_cam_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[3] + b * (50 * 8);
        real *restrict profile = out[0] + b * (98 * 8);
        real *restrict mark = out[1] + b * (2 * 8);
        real *restrict face = out[2] + b * (2 * 8);
        real *restrict origin_p = out[3] + b * (2 * 8);
        real *restrict axes_p = out[4] + b * (4 * 8);
        real *restrict origin_q = out[5] + b * (2 * 8);
        real *restrict axes_q = out[6] + b * (4 * 8);
        real t254[8], sin_p[8], t255[8], sin_q[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real control_2 = p[4 * 8 + j];
            const real control_46 = p[48 * 8 + j];
            const real control_0 = p[2 * 8 + j];
            const real control_1 = p[3 * 8 + j];
            const real control_47 = p[49 * 8 + j];
            const real t0 = 0.55 * control_0 + 0.21666666666666667 * (control_1 + control_47);
            profile[0 * 8 + j] = profile[96 * 8 + j] = mark[0 * 8 + j] = 0.008333333333333333 * (control_2
                + control_46) + t0; /* profile(0,0) profile(48,0) mark(1,0) */
            const real t1 = 0.4166666666666667 * (control_1 - control_47) + 0.041666666666666664 * (control_2
                - control_46);
            profile[1 * 8 + j] = profile[97 * 8 + j] = mark[1 * 8 + j] = 7.639437268410976 * t1;
                /* profile(0,1) profile(48,1) mark(1,1) */
            const real control_3 = p[5 * 8 + j];
            const real t2 = control_3 + control_47;
            const real t3 = control_0 + control_2;
            const real t4 = 0.5452946737555957 * control_1 + 0.21481305329765893 * t3;
            const real t5 = 0.4166666666666667 * (control_2 - control_0) + 0.041666666666666664 * (control_3
                - control_47);
            profile[2 * 8 + j] = 0.00826204051144842 * t2 + t4 - 0.9971466573496369 * t5; /* profile(1,0) */
            const real t6 = 0.07178940572102838 * control_1 + 0.028280674981011177 * t3;
            profile[3 * 8 + j] = 0.00108771826850043 * t2 + t6 + 7.574080823553641 * t5; /* profile(1,1) */
            const real control_4 = p[6 * 8 + j];
            const real t7 = control_0 + control_4;
            const real t8 = control_1 + control_3;
            const real t9 = 0.008049381885742236 * t7 + 0.20928392902929813 * t8 + 0.5312592044589876 * control_2;
            const real t10 = 0.041666666666666664 * (control_4 - control_0) + 0.4166666666666667 * (control_3
                - control_1);
            profile[4 * 8 + j] = t9 - 1.9772318589307385 * t10; /* profile(2,0) */
            const real t11 = 0.0021568253758543396 * t7 + 0.05607745977221283 * t8 + 0.1423504748063864 * control_2;
            profile[5 * 8 + j] = 7.379129755873375 * t10 + t11; /* profile(2,1) */
            const real control_5 = p[7 * 8 + j];
            const real t12 = control_1 + control_5;
            const real t13 = control_2 + control_4;
            const real t14 = 0.007698996104260723 * t12 + 0.20017389871077879 * t13 + 0.5081337428812077 * control_3;
            const real t15 = 0.041666666666666664 * (control_5 - control_1) + 0.4166666666666667 * (control_4
                - control_2);
            profile[6 * 8 + j] = t14 - 2.923486075213298 * t15; /* profile(3,0) */
            const real t16 = 0.0031890286030424146 * t12 + 0.08291474367910279 * t13 + 0.21047588780079937
                * control_3;
            profile[7 * 8 + j] = 7.057919732188834 * t15 + t16; /* profile(3,1) */
            const real control_6 = p[8 * 8 + j];
            const real t17 = control_2 + control_6;
            const real t18 = control_3 + control_5;
            const real t19 = 0.007216878364870322 * t17 + 0.18763883748662838 * t18 + 0.4763139720814413 * control_4;
            const real t20 = 0.041666666666666664 * (control_6 - control_2) + 0.4166666666666667 * (control_5
                - control_3);
            profile[8 * 8 + j] = t19 - 3.819718634205488 * t20; /* profile(4,0) */
            const real t21 = 0.004166666666666667 * t17 + 0.10833333333333334 * t18 + 0.275 * control_4;
            profile[9 * 8 + j] = 6.615946745061504 * t20 + t21; /* profile(4,1) */
            const real control_7 = p[9 * 8 + j];
            const real t22 = control_3 + control_7;
            const real t23 = control_4 + control_6;
            const real t24 = 0.006611277835760293 * t22 + 0.17189322372976762 * t23 + 0.43634433716017934 * control_5;
            const real t25 = 0.041666666666666664 * (control_7 - control_3) + 0.4166666666666667 * (control_6
                - control_4);
            profile[10 * 8 + j] = t24 - 4.650594748340343 * t25; /* profile(5,0) */
            const real t26 = 0.0050730119084060055 * t22 + 0.13189830961855614 * t23 + 0.33481878595479636
                * control_5;
            profile[11 * 8 + j] = 6.060773074839197 * t25 + t26; /* profile(5,1) */
            const real control_8 = p[10 * 8 + j];
            const real t27 = 0.005892556509887896 * (control_4 + control_8) + 0.1532064692570853 * (control_5
                + control_7);
            const real t28 = 0.38890872965260115 * control_6 + t27;
            const real t29 = 0.041666666666666664 * (control_8 - control_4) + 0.4166666666666667 * (control_7
                - control_5);
            const real t30 = 5.401897896942637 * t29;
            profile[12 * 8 + j] = t28 - t30; /* profile(6,0) */
            profile[13 * 8 + j] = t30 + t28; /* profile(6,1) */
            const real control_9 = p[11 * 8 + j];
            const real t31 = control_5 + control_9;
            const real t32 = control_6 + control_8;
            const real t33 = 0.0050730119084060055 * t31 + 0.13189830961855614 * t32 + 0.33481878595479636
                * control_7;
            const real t34 = 0.041666666666666664 * (control_9 - control_5) + 0.4166666666666667 * (control_8
                - control_6);
            profile[14 * 8 + j] = t33 - 6.060773074839197 * t34; /* profile(7,0) */
            const real t35 = 0.006611277835760293 * t31 + 0.17189322372976762 * t32 + 0.43634433716017934 * control_7;
            profile[15 * 8 + j] = 4.650594748340343 * t34 + t35; /* profile(7,1) */
            const real control_10 = p[12 * 8 + j];
            const real t36 = control_6 + control_10;
            const real t37 = control_7 + control_9;
            const real t38 = 0.004166666666666667 * t36 + 0.10833333333333334 * t37 + 0.275 * control_8;
            const real t39 = 0.041666666666666664 * (control_10 - control_6) + 0.4166666666666667 * (control_9
                - control_7);
            profile[16 * 8 + j] = t38 - 6.615946745061504 * t39; /* profile(8,0) */
            const real t40 = 0.007216878364870322 * t36 + 0.18763883748662838 * t37 + 0.4763139720814413 * control_8;
            profile[17 * 8 + j] = 3.819718634205488 * t39 + t40; /* profile(8,1) */
            const real t41 = control_8 + control_10;
            const real control_11 = p[13 * 8 + j];
            const real t42 = control_7 + control_11;
            const real t43 = 0.08291474367910279 * t41 + 0.0031890286030424146 * t42 + 0.21047588780079937
                * control_9;
            const real t44 = 0.4166666666666667 * (control_10 - control_8) + 0.041666666666666664 * (control_11
                - control_7);
            profile[18 * 8 + j] = t43 - 7.057919732188834 * t44; /* profile(9,0) */
            const real t45 = 0.20017389871077879 * t41 + 0.007698996104260723 * t42 + 0.5081337428812077 * control_9;
            profile[19 * 8 + j] = 2.923486075213298 * t44 + t45; /* profile(9,1) */
            const real control_12 = p[14 * 8 + j];
            const real t46 = control_8 + control_12;
            const real t47 = control_9 + control_11;
            const real t48 = 0.1423504748063864 * control_10 + 0.05607745977221283 * t47;
            const real t49 = 0.4166666666666667 * (control_11 - control_9) + 0.041666666666666664 * (control_12
                - control_8);
            profile[20 * 8 + j] = 0.0021568253758543396 * t46 + t48 - 7.379129755873375 * t49; /* profile(10,0) */
            const real t50 = 0.5312592044589876 * control_10 + 0.20928392902929813 * t47;
            profile[21 * 8 + j] = 0.008049381885742236 * t46 + t50 + 1.9772318589307385 * t49; /* profile(10,1) */
            const real control_13 = p[15 * 8 + j];
            const real t51 = control_9 + control_13;
            const real t52 = control_10 + control_12;
            const real t53 = 0.07178940572102838 * control_11 + 0.028280674981011177 * t52;
            const real t54 = 0.4166666666666667 * (control_12 - control_10) + 0.041666666666666664 * (control_13
                - control_9);
            profile[22 * 8 + j] = 0.00108771826850043 * t51 + t53 - 7.574080823553641 * t54; /* profile(11,0) */
            const real t55 = 0.5452946737555957 * control_11 + 0.21481305329765893 * t52;
            profile[23 * 8 + j] = 0.00826204051144842 * t51 + t55 + 0.9971466573496369 * t54; /* profile(11,1) */
            const real control_14 = p[16 * 8 + j];
            const real t56 = 0.041666666666666664 * (control_14 - control_10) + 0.4166666666666667 * (control_13
                - control_11);
            profile[24 * 8 + j] = -(7.639437268410976 * t56); /* profile(12,0) */
            const real t57 = 0.008333333333333333 * (control_10 + control_14) + 0.21666666666666667 * (control_11
                + control_13);
            profile[25 * 8 + j] = 0.55 * control_12 + t57; /* profile(12,1) */
            const real control_15 = p[17 * 8 + j];
            const real t58 = 0.041666666666666664 * (control_15 - control_11) + 0.4166666666666667 * (control_14
                - control_12);
            const real t59 = control_11 + control_15;
            const real t60 = control_12 + control_14;
            const real t61 = 0.00108771826850043 * t59 + 0.028280674981011177 * t60 + 0.07178940572102838
                * control_13;
            profile[26 * 8 + j] = -(7.574080823553641 * t58 + t61); /* profile(13,0) */
            const real t62 = 0.00826204051144842 * t59 + 0.21481305329765893 * t60 + 0.5452946737555957 * control_13;
            profile[27 * 8 + j] = t62 - 0.9971466573496369 * t58; /* profile(13,1) */
            const real control_16 = p[18 * 8 + j];
            const real t63 = 0.041666666666666664 * (control_16 - control_12) + 0.4166666666666667 * (control_15
                - control_13);
            const real t64 = control_12 + control_16;
            const real t65 = control_13 + control_15;
            const real t66 = 0.0021568253758543396 * t64 + 0.05607745977221283 * t65 + 0.1423504748063864
                * control_14;
            profile[28 * 8 + j] = -(7.379129755873375 * t63 + t66); /* profile(14,0) */
            const real t67 = 0.008049381885742236 * t64 + 0.20928392902929813 * t65 + 0.5312592044589876 * control_14;
            profile[29 * 8 + j] = t67 - 1.9772318589307385 * t63; /* profile(14,1) */
            const real control_17 = p[19 * 8 + j];
            const real t68 = 0.041666666666666664 * (control_17 - control_13) + 0.4166666666666667 * (control_16
                - control_14);
            const real t69 = control_13 + control_17;
            const real t70 = control_14 + control_16;
            const real t71 = 0.0031890286030424146 * t69 + 0.08291474367910279 * t70 + 0.21047588780079937
                * control_15;
            profile[30 * 8 + j] = -(7.057919732188834 * t68 + t71); /* profile(15,0) */
            const real t72 = 0.007698996104260723 * t69 + 0.20017389871077879 * t70 + 0.5081337428812077 * control_15;
            profile[31 * 8 + j] = t72 - 2.923486075213298 * t68; /* profile(15,1) */
            const real control_18 = p[20 * 8 + j];
            const real t73 = 0.041666666666666664 * (control_18 - control_14) + 0.4166666666666667 * (control_17
                - control_15);
            const real t74 = control_14 + control_18;
            const real t75 = control_15 + control_17;
            const real t76 = 0.004166666666666667 * t74 + 0.10833333333333334 * t75 + 0.275 * control_16;
            profile[32 * 8 + j] = -(6.615946745061504 * t73 + t76); /* profile(16,0) */
            const real t77 = 0.007216878364870322 * t74 + 0.18763883748662838 * t75 + 0.4763139720814413 * control_16;
            profile[33 * 8 + j] = t77 - 3.819718634205488 * t73; /* profile(16,1) */
            const real control_19 = p[21 * 8 + j];
            const real t78 = 0.041666666666666664 * (control_19 - control_15) + 0.4166666666666667 * (control_18
                - control_16);
            const real t79 = control_15 + control_19;
            const real t80 = control_16 + control_18;
            const real t81 = 0.0050730119084060055 * t79 + 0.13189830961855614 * t80 + 0.33481878595479636
                * control_17;
            profile[34 * 8 + j] = -(6.060773074839197 * t78 + t81); /* profile(17,0) */
            const real t82 = 0.006611277835760293 * t79 + 0.17189322372976762 * t80 + 0.43634433716017934
                * control_17;
            profile[35 * 8 + j] = t82 - 4.650594748340343 * t78; /* profile(17,1) */
            const real control_20 = p[22 * 8 + j];
            const real t83 = 0.041666666666666664 * (control_20 - control_16) + 0.4166666666666667 * (control_19
                - control_17);
            const real t84 = 5.401897896942637 * t83;
            const real t85 = 0.005892556509887896 * (control_16 + control_20) + 0.1532064692570853 * (control_17
                + control_19);
            const real t86 = 0.38890872965260115 * control_18 + t85;
            profile[36 * 8 + j] = -(t84 + t86); /* profile(18,0) */
            profile[37 * 8 + j] = t86 - t84; /* profile(18,1) */
            const real control_21 = p[23 * 8 + j];
            const real t87 = 0.041666666666666664 * (control_21 - control_17) + 0.4166666666666667 * (control_20
                - control_18);
            const real t88 = control_17 + control_21;
            const real t89 = control_18 + control_20;
            const real t90 = 0.006611277835760293 * t88 + 0.17189322372976762 * t89 + 0.43634433716017934
                * control_19;
            profile[38 * 8 + j] = -(4.650594748340343 * t87 + t90); /* profile(19,0) */
            const real t91 = 0.0050730119084060055 * t88 + 0.13189830961855614 * t89 + 0.33481878595479636
                * control_19;
            profile[39 * 8 + j] = t91 - 6.060773074839197 * t87; /* profile(19,1) */
            const real control_22 = p[24 * 8 + j];
            const real t92 = 0.041666666666666664 * (control_22 - control_18) + 0.4166666666666667 * (control_21
                - control_19);
            const real t93 = control_18 + control_22;
            const real t94 = control_19 + control_21;
            const real t95 = 0.007216878364870322 * t93 + 0.18763883748662838 * t94 + 0.4763139720814413 * control_20;
            profile[40 * 8 + j] = -(3.819718634205488 * t92 + t95); /* profile(20,0) */
            const real t96 = 0.004166666666666667 * t93 + 0.10833333333333334 * t94 + 0.275 * control_20;
            profile[41 * 8 + j] = t96 - 6.615946745061504 * t92; /* profile(20,1) */
            const real control_23 = p[25 * 8 + j];
            const real t97 = 0.041666666666666664 * (control_23 - control_19) + 0.4166666666666667 * (control_22
                - control_20);
            const real t98 = control_19 + control_23;
            const real t99 = control_20 + control_22;
            const real t100 = 0.007698996104260723 * t98 + 0.20017389871077879 * t99 + 0.5081337428812077
                * control_21;
            profile[42 * 8 + j] = -(2.923486075213298 * t97 + t100); /* profile(21,0) */
            const real t101 = 0.0031890286030424146 * t98 + 0.08291474367910279 * t99 + 0.21047588780079937
                * control_21;
            profile[43 * 8 + j] = t101 - 7.057919732188834 * t97; /* profile(21,1) */
            const real control_24 = p[26 * 8 + j];
            const real t102 = 0.041666666666666664 * (control_24 - control_20) + 0.4166666666666667 * (control_23
                - control_21);
            const real t103 = control_20 + control_24;
            const real t104 = control_21 + control_23;
            const real t105 = 0.008049381885742236 * t103 + 0.20928392902929813 * t104 + 0.5312592044589876
                * control_22;
            profile[44 * 8 + j] = -(1.9772318589307385 * t102 + t105); /* profile(22,0) */
            const real t106 = 0.0021568253758543396 * t103 + 0.05607745977221283 * t104;
            profile[45 * 8 + j] = 0.1423504748063864 * control_22 + t106 - 7.379129755873375 * t102;
                /* profile(22,1) */
            const real control_25 = p[27 * 8 + j];
            const real t107 = 0.041666666666666664 * (control_25 - control_21) + 0.4166666666666667 * (control_24
                - control_22);
            const real t108 = control_21 + control_25;
            const real t109 = control_22 + control_24;
            const real t110 = 0.00826204051144842 * t108 + 0.21481305329765893 * t109 + 0.5452946737555957
                * control_23;
            profile[46 * 8 + j] = -(0.9971466573496369 * t107 + t110); /* profile(23,0) */
            const real t111 = 0.00108771826850043 * t108 + 0.028280674981011177 * t109 + 0.07178940572102838
                * control_23;
            profile[47 * 8 + j] = t111 - 7.574080823553641 * t107; /* profile(23,1) */
            const real control_26 = p[28 * 8 + j];
            const real t112 = 0.008333333333333333 * (control_22 + control_26) + 0.21666666666666667 * (control_23
                + control_25);
            profile[48 * 8 + j] = -(0.55 * control_24 + t112); /* profile(24,0) */
            const real t113 = 0.041666666666666664 * (control_26 - control_22) + 0.4166666666666667 * (control_25
                - control_23);
            profile[49 * 8 + j] = -(7.639437268410976 * t113); /* profile(24,1) */
            const real control_27 = p[29 * 8 + j];
            const real t114 = 0.041666666666666664 * (control_27 - control_23) + 0.4166666666666667 * (control_26
                - control_24);
            const real t115 = control_23 + control_27;
            const real t116 = control_24 + control_26;
            const real t117 = 0.9971466573496369 * t114 - 0.00826204051144842 * t115 - 0.21481305329765893 * t116;
            profile[50 * 8 + j] = t117 - 0.5452946737555957 * control_25; /* profile(25,0) */
            const real t118 = 0.00108771826850043 * t115 + 0.028280674981011177 * t116 + 0.07178940572102838
                * control_25;
            profile[51 * 8 + j] = -(7.574080823553641 * t114 + t118); /* profile(25,1) */
            const real control_28 = p[30 * 8 + j];
            const real t119 = 0.041666666666666664 * (control_28 - control_24) + 0.4166666666666667 * (control_27
                - control_25);
            const real t120 = control_24 + control_28;
            const real t121 = control_25 + control_27;
            const real t122 = 1.9772318589307385 * t119 - 0.008049381885742236 * t120 - 0.20928392902929813 * t121;
            profile[52 * 8 + j] = t122 - 0.5312592044589876 * control_26; /* profile(26,0) */
            const real t123 = 0.0021568253758543396 * t120 + 0.05607745977221283 * t121;
            const real t124 = 0.1423504748063864 * control_26 + t123 + 7.379129755873375 * t119;
            profile[53 * 8 + j] = -t124; /* profile(26,1) */
            const real control_29 = p[31 * 8 + j];
            const real t125 = 0.041666666666666664 * (control_29 - control_25) + 0.4166666666666667 * (control_28
                - control_26);
            const real t126 = control_25 + control_29;
            const real t127 = control_26 + control_28;
            const real t128 = 2.923486075213298 * t125 - 0.007698996104260723 * t126 - 0.20017389871077879 * t127;
            profile[54 * 8 + j] = t128 - 0.5081337428812077 * control_27; /* profile(27,0) */
            const real t129 = 0.0031890286030424146 * t126 + 0.08291474367910279 * t127;
            const real t130 = 0.21047588780079937 * control_27 + t129 + 7.057919732188834 * t125;
            profile[55 * 8 + j] = -t130; /* profile(27,1) */
            const real control_30 = p[32 * 8 + j];
            const real t131 = 0.041666666666666664 * (control_30 - control_26) + 0.4166666666666667 * (control_29
                - control_27);
            const real t132 = control_26 + control_30;
            const real t133 = control_27 + control_29;
            const real t134 = 3.819718634205488 * t131 - 0.007216878364870322 * t132 - 0.18763883748662838 * t133;
            profile[56 * 8 + j] = t134 - 0.4763139720814413 * control_28; /* profile(28,0) */
            const real t135 = 0.004166666666666667 * t132 + 0.10833333333333334 * t133 + 0.275 * control_28;
            profile[57 * 8 + j] = -(6.615946745061504 * t131 + t135); /* profile(28,1) */
            const real control_31 = p[33 * 8 + j];
            const real t136 = 0.041666666666666664 * (control_31 - control_27) + 0.4166666666666667 * (control_30
                - control_28);
            const real t137 = control_27 + control_31;
            const real t138 = control_28 + control_30;
            const real t139 = 4.650594748340343 * t136 - 0.006611277835760293 * t137 - 0.17189322372976762 * t138;
            profile[58 * 8 + j] = t139 - 0.43634433716017934 * control_29; /* profile(29,0) */
            const real t140 = 0.0050730119084060055 * t137 + 0.13189830961855614 * t138;
            const real t141 = 0.33481878595479636 * control_29 + t140 + 6.060773074839197 * t136;
            profile[59 * 8 + j] = -t141; /* profile(29,1) */
            const real control_32 = p[34 * 8 + j];
            const real t142 = 0.041666666666666664 * (control_32 - control_28) + 0.4166666666666667 * (control_31
                - control_29);
            const real t143 = 5.401897896942637 * t142;
            const real t144 = 0.005892556509887896 * (control_28 + control_32);
            const real t145 = 0.1532064692570853 * (control_29 + control_31);
            const real t146 = 0.38890872965260115 * control_30;
            profile[60 * 8 + j] = t143 - t144 - t145 - t146; /* profile(30,0) */
            profile[61 * 8 + j] = -(t144 + t145 + t146 + t143); /* profile(30,1) */
            const real control_33 = p[35 * 8 + j];
            const real t147 = 0.041666666666666664 * (control_33 - control_29) + 0.4166666666666667 * (control_32
                - control_30);
            const real t148 = control_29 + control_33;
            const real t149 = control_30 + control_32;
            const real t150 = 6.060773074839197 * t147 - 0.0050730119084060055 * t148 - 0.13189830961855614 * t149;
            profile[62 * 8 + j] = t150 - 0.33481878595479636 * control_31; /* profile(31,0) */
            const real t151 = 0.006611277835760293 * t148 + 0.17189322372976762 * t149 + 0.43634433716017934
                * control_31;
            profile[63 * 8 + j] = -(4.650594748340343 * t147 + t151); /* profile(31,1) */
            const real control_34 = p[36 * 8 + j];
            const real t152 = 0.041666666666666664 * (control_34 - control_30) + 0.4166666666666667 * (control_33
                - control_31);
            const real t153 = control_30 + control_34;
            const real t154 = control_31 + control_33;
            const real t155 = 6.615946745061504 * t152 - 0.004166666666666667 * t153 - 0.10833333333333334 * t154;
            profile[64 * 8 + j] = t155 - 0.275 * control_32; /* profile(32,0) */
            const real t156 = 0.007216878364870322 * t153 + 0.18763883748662838 * t154 + 0.4763139720814413
                * control_32;
            profile[65 * 8 + j] = -(3.819718634205488 * t152 + t156); /* profile(32,1) */
            const real control_35 = p[37 * 8 + j];
            const real t157 = 0.041666666666666664 * (control_35 - control_31) + 0.4166666666666667 * (control_34
                - control_32);
            const real t158 = control_31 + control_35;
            const real t159 = control_32 + control_34;
            const real t160 = 7.057919732188834 * t157 - 0.0031890286030424146 * t158 - 0.08291474367910279 * t159;
            profile[66 * 8 + j] = t160 - 0.21047588780079937 * control_33; /* profile(33,0) */
            const real t161 = 0.007698996104260723 * t158 + 0.20017389871077879 * t159 + 0.5081337428812077
                * control_33;
            profile[67 * 8 + j] = -(2.923486075213298 * t157 + t161); /* profile(33,1) */
            const real control_36 = p[38 * 8 + j];
            const real t162 = 0.041666666666666664 * (control_36 - control_32) + 0.4166666666666667 * (control_35
                - control_33);
            const real t163 = control_32 + control_36;
            const real t164 = control_33 + control_35;
            const real t165 = 7.379129755873375 * t162 - 0.0021568253758543396 * t163 - 0.05607745977221283 * t164;
            profile[68 * 8 + j] = t165 - 0.1423504748063864 * control_34; /* profile(34,0) */
            const real t166 = 0.008049381885742236 * t163 + 0.20928392902929813 * t164 + 0.5312592044589876
                * control_34;
            profile[69 * 8 + j] = -(1.9772318589307385 * t162 + t166); /* profile(34,1) */
            const real control_37 = p[39 * 8 + j];
            const real t167 = 0.041666666666666664 * (control_37 - control_33) + 0.4166666666666667 * (control_36
                - control_34);
            const real t168 = control_33 + control_37;
            const real t169 = control_34 + control_36;
            const real t170 = 7.574080823553641 * t167 - 0.00108771826850043 * t168 - 0.028280674981011177 * t169;
            profile[70 * 8 + j] = t170 - 0.07178940572102838 * control_35; /* profile(35,0) */
            const real t171 = 0.00826204051144842 * t168 + 0.21481305329765893 * t169 + 0.5452946737555957
                * control_35;
            profile[71 * 8 + j] = -(0.9971466573496369 * t167 + t171); /* profile(35,1) */
            const real control_38 = p[40 * 8 + j];
            const real t172 = 0.041666666666666664 * (control_38 - control_34) + 0.4166666666666667 * (control_37
                - control_35);
            profile[72 * 8 + j] = 7.639437268410976 * t172; /* profile(36,0) */
            const real t173 = 0.008333333333333333 * (control_34 + control_38) + 0.21666666666666667 * (control_35
                + control_37);
            profile[73 * 8 + j] = -(0.55 * control_36 + t173); /* profile(36,1) */
            const real control_39 = p[41 * 8 + j];
            const real t174 = 0.041666666666666664 * (control_39 - control_35) + 0.4166666666666667 * (control_38
                - control_36);
            const real t175 = control_35 + control_39;
            const real t176 = control_36 + control_38;
            const real t177 = 0.00108771826850043 * t175 + 0.028280674981011177 * t176 + 0.07178940572102838
                * control_37;
            profile[74 * 8 + j] = 7.574080823553641 * t174 + t177; /* profile(37,0) */
            const real t178 = 0.9971466573496369 * t174 - 0.00826204051144842 * t175 - 0.21481305329765893 * t176;
            profile[75 * 8 + j] = t178 - 0.5452946737555957 * control_37; /* profile(37,1) */
            const real control_40 = p[42 * 8 + j];
            const real t179 = 0.041666666666666664 * (control_40 - control_36) + 0.4166666666666667 * (control_39
                - control_37);
            const real t180 = control_36 + control_40;
            const real t181 = control_37 + control_39;
            const real t182 = 0.0021568253758543396 * t180 + 0.05607745977221283 * t181;
            profile[76 * 8 + j] = 0.1423504748063864 * control_38 + t182 + 7.379129755873375 * t179;
                /* profile(38,0) */
            const real t183 = 1.9772318589307385 * t179 - 0.008049381885742236 * t180 - 0.20928392902929813 * t181;
            profile[77 * 8 + j] = t183 - 0.5312592044589876 * control_38; /* profile(38,1) */
            const real control_41 = p[43 * 8 + j];
            const real t184 = 0.041666666666666664 * (control_41 - control_37) + 0.4166666666666667 * (control_40
                - control_38);
            const real t185 = control_37 + control_41;
            const real t186 = control_38 + control_40;
            const real t187 = 0.0031890286030424146 * t185 + 0.08291474367910279 * t186;
            profile[78 * 8 + j] = 0.21047588780079937 * control_39 + t187 + 7.057919732188834 * t184;
                /* profile(39,0) */
            const real t188 = 2.923486075213298 * t184 - 0.007698996104260723 * t185 - 0.20017389871077879 * t186;
            profile[79 * 8 + j] = t188 - 0.5081337428812077 * control_39; /* profile(39,1) */
            const real control_42 = p[44 * 8 + j];
            const real t189 = 0.041666666666666664 * (control_42 - control_38) + 0.4166666666666667 * (control_41
                - control_39);
            const real t190 = control_38 + control_42;
            const real t191 = control_39 + control_41;
            const real t192 = 0.004166666666666667 * t190 + 0.10833333333333334 * t191 + 0.275 * control_40;
            profile[80 * 8 + j] = 6.615946745061504 * t189 + t192; /* profile(40,0) */
            const real t193 = 3.819718634205488 * t189 - 0.007216878364870322 * t190 - 0.18763883748662838 * t191;
            profile[81 * 8 + j] = t193 - 0.4763139720814413 * control_40; /* profile(40,1) */
            const real control_43 = p[45 * 8 + j];
            const real t194 = 0.041666666666666664 * (control_43 - control_39) + 0.4166666666666667 * (control_42
                - control_40);
            const real t195 = control_39 + control_43;
            const real t196 = control_40 + control_42;
            const real t197 = 0.0050730119084060055 * t195 + 0.13189830961855614 * t196;
            profile[82 * 8 + j] = 0.33481878595479636 * control_41 + t197 + 6.060773074839197 * t194;
                /* profile(41,0) */
            const real t198 = 4.650594748340343 * t194 - 0.006611277835760293 * t195 - 0.17189322372976762 * t196;
            profile[83 * 8 + j] = t198 - 0.43634433716017934 * control_41; /* profile(41,1) */
            const real control_44 = p[46 * 8 + j];
            const real t199 = 0.041666666666666664 * (control_44 - control_40) + 0.4166666666666667 * (control_43
                - control_41);
            const real t200 = 5.401897896942637 * t199;
            const real t201 = 0.38890872965260115 * control_42;
            const real t202 = 0.005892556509887896 * (control_40 + control_44);
            const real t203 = 0.1532064692570853 * (control_41 + control_43);
            profile[84 * 8 + j] = t202 + t203 + t201 + t200; /* profile(42,0) */
            profile[85 * 8 + j] = t200 - t202 - t203 - t201; /* profile(42,1) */
            const real control_45 = p[47 * 8 + j];
            const real t204 = 0.041666666666666664 * (control_45 - control_41) + 0.4166666666666667 * (control_44
                - control_42);
            const real t205 = control_41 + control_45;
            const real t206 = control_42 + control_44;
            const real t207 = 0.006611277835760293 * t205 + 0.17189322372976762 * t206 + 0.43634433716017934
                * control_43;
            profile[86 * 8 + j] = 4.650594748340343 * t204 + t207; /* profile(43,0) */
            const real t208 = 6.060773074839197 * t204 - 0.0050730119084060055 * t205 - 0.13189830961855614 * t206;
            profile[87 * 8 + j] = t208 - 0.33481878595479636 * control_43; /* profile(43,1) */
            const real t209 = 0.041666666666666664 * (control_46 - control_42) + 0.4166666666666667 * (control_45
                - control_43);
            const real t210 = control_42 + control_46;
            const real t211 = control_43 + control_45;
            const real t212 = 0.007216878364870322 * t210 + 0.18763883748662838 * t211 + 0.4763139720814413
                * control_44;
            profile[88 * 8 + j] = 3.819718634205488 * t209 + t212; /* profile(44,0) */
            const real t213 = 6.615946745061504 * t209 - 0.004166666666666667 * t210 - 0.10833333333333334 * t211;
            profile[89 * 8 + j] = t213 - 0.275 * control_44; /* profile(44,1) */
            const real t214 = 0.041666666666666664 * (control_47 - control_43) + 0.4166666666666667 * (control_46
                - control_44);
            const real t215 = control_43 + control_47;
            const real t216 = control_44 + control_46;
            const real t217 = 0.007698996104260723 * t215 + 0.20017389871077879 * t216 + 0.5081337428812077
                * control_45;
            profile[90 * 8 + j] = 2.923486075213298 * t214 + t217; /* profile(45,0) */
            const real t218 = 7.057919732188834 * t214 - 0.0031890286030424146 * t215 - 0.08291474367910279 * t216;
            profile[91 * 8 + j] = t218 - 0.21047588780079937 * control_45; /* profile(45,1) */
            const real t219 = 0.041666666666666664 * (control_0 - control_44) + 0.4166666666666667 * (control_47
                - control_45);
            const real t220 = control_0 + control_44;
            const real t221 = control_45 + control_47;
            const real t222 = 0.008049381885742236 * t220 + 0.20928392902929813 * t221 + 0.5312592044589876
                * control_46;
            profile[92 * 8 + j] = 1.9772318589307385 * t219 + t222; /* profile(46,0) */
            const real t223 = 7.379129755873375 * t219 - 0.0021568253758543396 * t220 - 0.05607745977221283 * t221;
            profile[93 * 8 + j] = t223 - 0.1423504748063864 * control_46; /* profile(46,1) */
            const real t224 = 0.4166666666666667 * (control_0 - control_46) + 0.041666666666666664 * (control_1
                - control_45);
            const real t225 = control_0 + control_46;
            const real t226 = control_1 + control_45;
            const real t227 = 0.21481305329765893 * t225 + 0.00826204051144842 * t226 + 0.5452946737555957
                * control_47;
            profile[94 * 8 + j] = 0.9971466573496369 * t224 + t227; /* profile(47,0) */
            const real t228 = 7.574080823553641 * t224 - 0.028280674981011177 * t225 - 0.00108771826850043 * t226;
            profile[95 * 8 + j] = t228 - 0.07178940572102838 * control_47; /* profile(47,1) */
            const real t229 = real_max(7.639437268410976 * real_abs(t10), 7.639437268410976 * real_abs(t219));
            const real t230 = real_max(7.639437268410976 * real_abs(t5), real_max(7.639437268410976 * real_abs(t224),
                t229));
            const real t231 = real_max(7.639437268410976 * real_abs(t1), real_max(7.639437268410976 * real_abs(t15),
                t230));
            const real t232 = real_max(7.639437268410976 * real_abs(t39), real_max(7.639437268410976 * real_abs(t56),
                t231));
            const real t233 = real_max(7.639437268410976 * real_abs(t54), real_max(7.639437268410976 * real_abs(t44),
                t232));
            const real t234 = real_max(7.639437268410976 * real_abs(t49), real_max(7.639437268410976 * real_abs(t58),
                t233));
            const real t235 = real_max(7.639437268410976 * real_abs(t68), real_max(7.639437268410976 * real_abs(t63),
                t234));
            const real t236 = real_max(7.639437268410976 * real_abs(t78), real_max(7.639437268410976 * real_abs(t73),
                t235));
            const real t237 = real_max(7.639437268410976 * real_abs(t87), real_max(7.639437268410976 * real_abs(t83),
                t236));
            const real t238 = real_max(7.639437268410976 * real_abs(t97), real_max(7.639437268410976 * real_abs(t92),
                t237));
            const real t239 = real_max(7.639437268410976 * real_abs(t102), real_max(7.639437268410976 * real_abs(t20),
                t238));
            const real t240 = real_max(7.639437268410976 * real_abs(t113), real_max(7.639437268410976
                * real_abs(t107), t239));
            const real t241 = real_max(7.639437268410976 * real_abs(t119), real_max(7.639437268410976
                * real_abs(t114), t240));
            const real t242 = real_max(7.639437268410976 * real_abs(t131), real_max(7.639437268410976
                * real_abs(t125), t241));
            const real t243 = real_max(7.639437268410976 * real_abs(t142), real_max(7.639437268410976
                * real_abs(t136), t242));
            const real t244 = real_max(7.639437268410976 * real_abs(t25), real_max(7.639437268410976 * real_abs(t147),
                t243));
            const real t245 = real_max(7.639437268410976 * real_abs(t157), real_max(7.639437268410976
                * real_abs(t152), t244));
            const real t246 = real_max(7.639437268410976 * real_abs(t167), real_max(7.639437268410976
                * real_abs(t162), t245));
            const real t247 = real_max(7.639437268410976 * real_abs(t174), real_max(7.639437268410976
                * real_abs(t172), t246));
            const real t248 = real_max(7.639437268410976 * real_abs(t184), real_max(7.639437268410976
                * real_abs(t179), t247));
            const real t249 = real_max(7.639437268410976 * real_abs(t194), real_max(7.639437268410976
                * real_abs(t189), t248));
            const real t250 = real_max(7.639437268410976 * real_abs(t199), real_max(7.639437268410976 * real_abs(t29),
                t249));
            const real t251 = real_max(7.639437268410976 * real_abs(t209), real_max(7.639437268410976
                * real_abs(t204), t250));
            const real t252 = real_max(7.639437268410976 * real_abs(t34), real_max(7.639437268410976 * real_abs(t214),
                t251));
            const real t253 = 1.2 * t252;
            face[1 * 8 + j] = t253; /* face(1,1) */
            face[0 * 8 + j] = -t253; /* face(0,1) */
            const real p_x = x[0 * 8 + j];
            origin_p[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            origin_p[1 * 8 + j] = p_y;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t254[j] = rp_angle + alpha0;
            const real q_x = x[3 * 8 + j];
            origin_q[0 * 8 + j] = q_x;
            const real q_y = x[4 * 8 + j];
            origin_q[1 * 8 + j] = q_y;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[1 * 8 + j];
            t255[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real cos_p = real_cos(t254[j]);
            axes_p[0 * 8 + j] = axes_p[3 * 8 + j] = cos_p; /* axes_p(0,0) axes_p(1,1) */
            sin_p[j] = real_sin(t254[j]);
            axes_p[1 * 8 + j] = sin_p[j]; /* axes_p(0,1) */
            const real cos_q = real_cos(t255[j]);
            axes_q[0 * 8 + j] = axes_q[3 * 8 + j] = cos_q; /* axes_q(0,0) axes_q(1,1) */
            sin_q[j] = real_sin(t255[j]);
            axes_q[1 * 8 + j] = sin_q[j]; /* axes_q(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            axes_p[2 * 8 + j] = -sin_p[j]; /* axes_p(1,0) */
            axes_q[2 * 8 + j] = -sin_q[j]; /* axes_q(1,0) */
        }
    }
}

const flexel_element flexel_planar_flat_cam = {
    .name = "planar_flat_cam",
    .digest = "6268d8a8673441b2",
    .n = 6,
    .m = 1,
    .k = 0,
    .np = 50,
    .position = planar_flat_cam_position,
    .acceleration = planar_flat_cam_acceleration,
    .rates = planar_flat_cam_rates,
    .kinematics = planar_flat_cam_kinematics,
    .stiffness = planar_flat_cam_stiffness,
    .outputs = planar_flat_cam_outputs,
};
