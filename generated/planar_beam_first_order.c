/* planar_beam_first_order: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
 * d = xq - xp, l = |d|, el = d/l;  b1 = l - l0,  b5 = l0 ey_p.el,  b6 = -l0 ey_q.el
 * elongation = b1,  bend1 = b5,  bend2 = b6
 * T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
 *    the shear-corrected (phi_z) cubic shapes
 * U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), PLBEAM, PLBEAMNL; signs of the spatial beam's b5, b6; Meijaard 1996, Nonlinear Dyn. 9
 *
 * x (6): p_x, p_y, rp_angle, q_x, q_y, rq_angle
 * e (3): elongation [m], bend1 [m], bend2 [m]
 * s (0): none
 * p (8):
 *   l0 (1) [m]: undeformed length
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   alphaq0 (1) [rad]: initial direction of the element minus the angle of node q
 *   rhoA (1) [kg/m]: mass per length
 *   rhoJ (1) [kg m]: mass moment of inertia of the section per length
 *   phi_z (1) [1]: shear number of the deflection in the plane, 12 E I/(k G A l0^2)
 *   gravity (2) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* position: 65 operations.
 * in:  x (6), p (8)
 * out: e (3), De (3,6), 14 of 18 entries, V (0,6) */
FLEXEL_CLONES
static void planar_beam_first_order_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (8 * 8);
        real *restrict e = out[0] + b * (3 * 8);
        real *restrict De = out[1] + b * (14 * 8);
        real t0[8], cos_p[8], el_y[8], sin_p[8], el_x[8], t2[8], cos_q[8], sin_q[8], t5[8], t6[8], t9[8], t10[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y);
            const real l0 = p[0 * 8 + j];
            e[0 * 8 + j] = l - l0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real t1 = 1.0 / l;
            el_y[j] = d_y * t1;
            De[3 * 8 + j] = el_y[j];
            el_x[j] = d_x * t1;
            De[2 * 8 + j] = el_x[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t2[j] = rq_angle + alphaq0;
            De[0 * 8 + j] = -el_x[j];
            De[1 * 8 + j] = -el_y[j];
            const real t3 = t1 * t1;
            const real t4 = el_x[j] * t3;
            t5[j] = d_y * t4;
            t6[j] = d_x * t4 - t1;
            const real t8 = el_y[j] * t3;
            t9[j] = d_y * t8 - t1;
            t10[j] = d_x * t8;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            sin_p[j] = real_sin(t0[j]);
            cos_q[j] = real_cos(t2[j]);
            sin_q[j] = real_sin(t2[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real b5 = l0 * (cos_p[j] * el_y[j] - sin_p[j] * el_x[j]);
            e[1 * 8 + j] = b5;
            e[2 * 8 + j] = -(l0 * (cos_q[j] * el_y[j] - sin_q[j] * el_x[j]));
            const real t7 = l0 * (cos_p[j] * t5[j] - sin_p[j] * t6[j]);
            De[4 * 8 + j] = t7;
            const real t11 = l0 * (cos_p[j] * t9[j] - sin_p[j] * t10[j]);
            De[5 * 8 + j] = t11;
            De[6 * 8 + j] = -(l0 * (sin_p[j] * el_y[j] + cos_p[j] * el_x[j]));
            De[7 * 8 + j] = -t7;
            De[8 * 8 + j] = -t11;
            const real t12 = l0 * (cos_q[j] * t5[j] - sin_q[j] * t6[j]);
            De[11 * 8 + j] = t12;
            De[9 * 8 + j] = -t12;
            const real t13 = l0 * (cos_q[j] * t9[j] - sin_q[j] * t10[j]);
            De[12 * 8 + j] = t13;
            De[10 * 8 + j] = -t13;
            De[13 * 8 + j] = l0 * (sin_q[j] * el_y[j] + cos_q[j] * el_x[j]);
        }
    }
}

/* velocity: 55 operations.
 * in:  x (6), v (6), p (8)
 * out: ed (3), s (0) */
FLEXEL_CLONES
static void planar_beam_first_order_velocity(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict ed = out[0] + b * (3 * 8);
        real t4[8], cos_p[8], t6[8], el_y[8], sin_p[8], el_x[8], t7[8], t9[8], cos_q[8], sin_q[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y);
            const real t0 = 1.0 / l;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t1 = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t2 = q_vy - p_vy;
            const real t3 = t0 * (2.0 * d_x * t1 + 2.0 * d_y * t2);
            ed[0 * 8 + j] = 0.5 * t3;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t4[j] = rp_angle + alpha0;
            const real t5 = t0 * t0 * t3;
            t6[j] = t0 * t2 - 0.5 * d_y * t5;
            el_y[j] = d_y * t0;
            el_x[j] = d_x * t0;
            t7[j] = t0 * t1 - 0.5 * d_x * t5;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t9[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t4[j]);
            sin_p[j] = real_sin(t4[j]);
            cos_q[j] = real_cos(t9[j]);
            sin_q[j] = real_sin(t9[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t8 = cos_p[j] * t6[j] - rp_vangle * sin_p[j] * el_y[j] - (rp_vangle * cos_p[j] * el_x[j] + sin_p[j] * t7[j]);
            const real l0 = p[0 * 8 + j];
            ed[1 * 8 + j] = l0 * t8;
            const real rq_vangle = v[5 * 8 + j];
            const real t10 = cos_q[j] * t6[j] - rq_vangle * sin_q[j] * el_y[j] - (rq_vangle * cos_q[j] * el_x[j] + sin_q[j] * t7[j]);
            ed[2 * 8 + j] = -(l0 * t10);
        }
    }
}

/* acceleration: 96 operations.
 * in:  x (6), v (6), p (8)
 * out: g (3), gs (0) */
FLEXEL_CLONES
static void planar_beam_first_order_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict g = out[0] + b * (3 * 8);
        real t8[8], sin_p[8], t10[8], el_y[8], cos_p[8], t15[8], t17[8], el_x[8], t20[8], t22[8], sin_q[8], cos_q[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y);
            const real t0 = 1.0 / l;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t1 = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t2 = q_vy - p_vy;
            const real t3 = 2.0 * d_x * t1 + 2.0 * d_y * t2;
            const real t4 = t0 * t0;
            const real t5 = t0 * t3;
            const real t6 = t4 * t5;
            const real t7 = t0 * (2.0 * t1 * t1 + 2.0 * t2 * t2) - 0.5 * t3 * t6;
            g[0 * 8 + j] = 0.5 * t7;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t8[j] = rp_angle + alpha0;
            t10[j] = t0 * t2 - 0.5 * d_y * t6;
            el_y[j] = d_y * t0;
            const real t13 = t2 * t6;
            const real t14 = t4 * t7 - t0 * t6 * t5;
            t15[j] = 0.5 * t13 + 0.5 * (t13 + d_y * t14);
            t17[j] = t0 * t1 - 0.5 * d_x * t6;
            el_x[j] = d_x * t0;
            const real t19 = t1 * t6;
            t20[j] = 0.5 * t19 + 0.5 * (t19 + d_x * t14);
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t22[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t8[j]);
            cos_p[j] = real_cos(t8[j]);
            sin_q[j] = real_sin(t22[j]);
            cos_q[j] = real_cos(t22[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t9 = rp_vangle * sin_p[j];
            const real t11 = t9 * t10[j];
            const real t12 = rp_vangle * cos_p[j];
            const real t16 = t11 + rp_vangle * t12 * el_y[j] + (t11 + cos_p[j] * t15[j]);
            const real t18 = t12 * t17[j];
            const real t21 = t18 - rp_vangle * t9 * el_x[j] + (t18 - sin_p[j] * t20[j]);
            const real l0 = p[0 * 8 + j];
            g[1 * 8 + j] = -(l0 * (t16 + t21));
            const real rq_vangle = v[5 * 8 + j];
            const real t23 = rq_vangle * sin_q[j];
            const real t24 = t23 * t10[j];
            const real t25 = rq_vangle * cos_q[j];
            const real t26 = t24 + rq_vangle * t25 * el_y[j] + (t24 + cos_q[j] * t15[j]);
            const real t27 = t25 * t17[j];
            const real t28 = t27 - rq_vangle * t23 * el_x[j] + (t27 - sin_q[j] * t20[j]);
            g[2 * 8 + j] = l0 * (t26 + t28);
        }
    }
}

/* kinematics: 483 operations.
 * in:  x (6), v (6), a (6), p (8)
 * out: Phi_x (3,6), 14 of 18 entries, Psi_x (3,6), 14 of 18 entries, Psi_v (3,6), 14 of 18 entries */
FLEXEL_CLONES
static void planar_beam_first_order_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict Phi_x = out[0] + b * (14 * 8);
        real *restrict Psi_x = out[1] + b * (14 * 8);
        real *restrict Psi_v = out[2] + b * (14 * 8);
        real d_x[8], d_y[8], t0[8], el_x[8], t3[8], t4[8], el_y[8], t13[8], cos_p[8], t16[8], t17[8], sin_p[8], t19[8], t21[8], t22[8], t26[8], t27[8], t28[8], t29[8], t32[8], t33[8], t36[8], cos_q[8], sin_q[8], t45[8], t49[8], t51[8], t52[8], t57[8], t63[8], t64[8], t69[8], t71[8], t75[8], t77[8], t79[8], t82[8], t85[8], t88[8], t90[8], t93[8], t95[8], t97[8], t99[8], t117[8], t118[8], t119[8], t120[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real l = real_sqrt(d_x[j] * d_x[j] + d_y[j] * d_y[j]);
            t0[j] = 1.0 / l;
            el_x[j] = d_x[j] * t0[j];
            const real t1 = t0[j] * t0[j];
            const real t2 = el_x[j] * t1;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t3[j] = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t4[j] = q_vy - p_vy;
            const real t5 = 2.0 * d_x[j] * t3[j] + 2.0 * d_y[j] * t4[j];
            const real t6 = t0[j] * t3[j];
            const real t7 = t2 * t5 - 2.0 * t6;
            Psi_v[0 * 8 + j] = t7;
            const real t8 = 0.5 * t7;
            Phi_x[0 * 8 + j] = t8;
            el_y[j] = d_y[j] * t0[j];
            const real t9 = el_y[j] * t1;
            const real t10 = t0[j] * t4[j];
            const real t11 = t9 * t5 - 2.0 * t10;
            Psi_v[1 * 8 + j] = t11;
            const real t12 = 0.5 * t11;
            Phi_x[1 * 8 + j] = t12;
            Phi_x[2 * 8 + j] = -t8;
            Phi_x[3 * 8 + j] = -t12;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t13[j] = rp_angle + alpha0;
            const real t14 = t0[j] * t5;
            const real t15 = 2.0 * t0[j] * t2 * t14 + t1 * t7;
            t16[j] = t4[j] * t2 - 0.5 * d_y[j] * t15;
            t17[j] = d_y[j] * t2;
            t19[j] = d_x[j] * t2 - t0[j];
            t21[j] = t1 * t14;
            t22[j] = t3[j] * t2 - 0.5 * (d_x[j] * t15 - t21[j]);
            const real t25 = 2.0 * t0[j] * t9 * t14 + t1 * t11;
            t26[j] = t4[j] * t9 - 0.5 * (d_y[j] * t25 - t21[j]);
            t27[j] = d_y[j] * t9 - t0[j];
            t28[j] = d_x[j] * t9;
            t29[j] = t3[j] * t9 - 0.5 * d_x[j] * t25;
            t32[j] = t10 - 0.5 * d_y[j] * t21[j];
            t33[j] = t6 - 0.5 * d_x[j] * t21[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t36[j] = rq_angle + alphaq0;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t45[j] = q_ax - p_ax;
            const real t46 = t0[j] * t45[j];
            const real t47 = t3[j] * t21[j];
            const real t48 = 0.5 * t47;
            t49[j] = t1 * t6;
            const real t50 = t0[j] * t1;
            t51[j] = d_x[j] * t50;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t52[j] = q_ay - p_ay;
            const real t53 = 2.0 * d_x[j] * t45[j] + 2.0 * d_y[j] * t52[j];
            const real t54 = 2.0 * t3[j] * t3[j] + 2.0 * t4[j] * t4[j];
            const real t55 = t1 * t5;
            const real t56 = t0[j] * t14;
            t57[j] = t55 + 2.0 * t56;
            const real t58 = 0.5 * t53 + 0.5 * t54 - 0.25 * t5 * t57[j];
            const real t59 = t46 - t48 - 0.5 * t5 * t49[j] - t51[j] * t58;
            Psi_x[2 * 8 + j] = t59;
            Psi_x[0 * 8 + j] = -t59;
            const real t60 = t0[j] * t52[j];
            const real t61 = t4[j] * t21[j];
            const real t62 = 0.5 * t61;
            t63[j] = t1 * t10;
            t64[j] = d_y[j] * t50;
            const real t65 = t60 - t62 - 0.5 * t5 * t63[j] - t64[j] * t58;
            Psi_x[3 * 8 + j] = t65;
            Psi_x[1 * 8 + j] = -t65;
            const real t67 = t0[j] * t54 - 0.5 * t5 * t21[j];
            const real t68 = t0[j] * t21[j];
            t69[j] = t1 * t67 - t14 * t68;
            const real t70 = t0[j] * t53;
            t71[j] = t1 * t70;
            t75[j] = t1 * t46;
            t77[j] = 2.0 * t6 * t68 + t1 * t47;
            t79[j] = 0.5 * t55 + t56;
            t82[j] = t1 * t53 + 2.0 * t0[j] * t70;
            t85[j] = 2.0 * t0[j] * t67 - t14 * t21[j] - t5 * t68 + t1 * t54;
            t88[j] = t1 * t60;
            t90[j] = 2.0 * t10 * t68 + t1 * t61;
            const real t92 = t60 - 0.5 * d_y[j] * t71[j];
            const real rp_aangle = a[2 * 8 + j];
            t93[j] = t92 - el_x[j] * rp_aangle;
            const real t94 = t46 - 0.5 * d_x[j] * t71[j];
            t95[j] = t94 + el_y[j] * rp_aangle;
            const real rp_vangle = v[2 * 8 + j];
            const real t96 = t48 + 0.5 * (t47 + d_x[j] * t69[j]);
            t97[j] = rp_vangle * (t32[j] - rp_vangle * el_x[j] + t32[j]) - t96;
            const real t98 = t62 + 0.5 * (t61 + d_y[j] * t69[j]);
            t99[j] = t98 + rp_vangle * (t33[j] + rp_vangle * el_y[j] + t33[j]);
            const real rq_aangle = a[5 * 8 + j];
            t117[j] = t92 - el_x[j] * rq_aangle;
            t118[j] = t94 + el_y[j] * rq_aangle;
            const real rq_vangle = v[5 * 8 + j];
            t119[j] = rq_vangle * (t32[j] - rq_vangle * el_x[j] + t32[j]) - t96;
            t120[j] = t98 + rq_vangle * (t33[j] + rq_vangle * el_y[j] + t33[j]);
            Psi_v[2 * 8 + j] = -t7;
            Psi_v[3 * 8 + j] = -t11;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t13[j]);
            sin_p[j] = real_sin(t13[j]);
            cos_q[j] = real_cos(t36[j]);
            sin_q[j] = real_sin(t36[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t18 = rp_vangle * sin_p[j];
            const real t20 = rp_vangle * cos_p[j];
            const real t23 = cos_p[j] * t16[j] - t17[j] * t18 - (t19[j] * t20 + sin_p[j] * t22[j]);
            const real l0 = p[0 * 8 + j];
            const real t24 = l0 * t23;
            Phi_x[4 * 8 + j] = t24;
            const real t30 = cos_p[j] * t26[j] - t27[j] * t18 - (t28[j] * t20 + sin_p[j] * t29[j]);
            const real t31 = l0 * t30;
            Phi_x[5 * 8 + j] = t31;
            const real t34 = el_y[j] * t20 + sin_p[j] * t32[j] + (cos_p[j] * t33[j] - el_x[j] * t18);
            const real t35 = l0 * t34;
            Phi_x[6 * 8 + j] = -t35;
            Phi_x[7 * 8 + j] = -t24;
            Phi_x[8 * 8 + j] = -t31;
            const real rq_vangle = v[5 * 8 + j];
            const real t37 = rq_vangle * sin_q[j];
            const real t38 = rq_vangle * cos_q[j];
            const real t39 = cos_q[j] * t16[j] - t17[j] * t37 - (t19[j] * t38 + sin_q[j] * t22[j]);
            const real t40 = l0 * t39;
            Phi_x[11 * 8 + j] = t40;
            Phi_x[9 * 8 + j] = -t40;
            const real t41 = cos_q[j] * t26[j] - t27[j] * t37 - (t28[j] * t38 + sin_q[j] * t29[j]);
            const real t42 = l0 * t41;
            Phi_x[12 * 8 + j] = t42;
            Phi_x[10 * 8 + j] = -t42;
            const real t43 = el_y[j] * t38 + sin_q[j] * t32[j] + (cos_q[j] * t33[j] - el_x[j] * t37);
            const real t44 = l0 * t43;
            Phi_x[13 * 8 + j] = t44;
            const real rp_aangle = a[2 * 8 + j];
            const real t66 = rp_vangle * t18 * l0 - cos_p[j] * rp_aangle * l0;
            const real t72 = sin_p[j] * d_x[j];
            const real t73 = l0 * cos_p[j];
            const real t74 = 0.5 * l0 * t72 - 0.5 * d_y[j] * t73;
            const real t76 = 0.5 * sin_p[j] * t71[j] * l0 + 2.0 * t74 * t75[j] + l0 * (t20 * t21[j] + 0.5 * sin_p[j] * t69[j]);
            const real t78 = l0 * (0.5 * cos_p[j] * d_y[j] - 0.5 * t72);
            const real t80 = cos_p[j] * t4[j] - d_x[j] * t20 - d_y[j] * t18 - sin_p[j] * t3[j];
            const real t81 = t79[j] * t78 - l0 * t80;
            const real t83 = t73 * t52[j] - sin_p[j] * t45[j] * l0 + t82[j] * t74 - l0 * (2.0 * t3[j] * t20 + 2.0 * t4[j] * t18);
            const real t84 = sin_p[j] * rp_aangle * l0 + rp_vangle * t20 * l0;
            const real t86 = d_x[j] * t66 + t83 - d_y[j] * t84 - t85[j] * t78 + t57[j] * t81;
            const real t87 = t0[j] * t66 + t76 + t77[j] * t78 + 2.0 * t49[j] * t81 - t51[j] * t86;
            Psi_x[7 * 8 + j] = t87;
            Psi_x[4 * 8 + j] = -t87;
            const real t89 = 2.0 * t74 * t88[j] - 0.5 * t73 * t71[j] - l0 * (0.5 * cos_p[j] * t69[j] - t18 * t21[j]);
            const real t91 = t89 - t0[j] * t84 + t90[j] * t78 + 2.0 * t63[j] * t81 - t64[j] * t86;
            Psi_x[8 * 8 + j] = t91;
            Psi_x[5 * 8 + j] = -t91;
            const real t100 = l0 * (sin_p[j] * t93[j] + cos_p[j] * t95[j]) + l0 * (cos_p[j] * t97[j] - sin_p[j] * t99[j]);
            Psi_x[6 * 8 + j] = -t100;
            const real rq_aangle = a[5 * 8 + j];
            const real t101 = cos_q[j] * rq_aangle * l0 - rq_vangle * t37 * l0;
            const real t102 = l0 * cos_q[j];
            const real t103 = sin_q[j] * d_x[j];
            const real t104 = 0.5 * d_y[j] * t102 - 0.5 * l0 * t103;
            const real t105 = 2.0 * t104 * t75[j] - 0.5 * sin_q[j] * t71[j] * l0 - l0 * (t38 * t21[j] + 0.5 * sin_q[j] * t69[j]);
            const real t106 = l0 * (0.5 * cos_q[j] * d_y[j] - 0.5 * t103);
            const real t107 = cos_q[j] * t4[j] - d_x[j] * t38 - d_y[j] * t37 - sin_q[j] * t3[j];
            const real t108 = l0 * t107 - t79[j] * t106;
            const real t109 = t0[j] * t101 + t105 - t77[j] * t106 + 2.0 * t49[j] * t108;
            const real t110 = sin_q[j] * rq_aangle * l0 + rq_vangle * t38 * l0;
            const real t111 = sin_q[j] * t45[j] * l0 - t102 * t52[j] + t82[j] * t104 + l0 * (2.0 * t3[j] * t38 + 2.0 * t4[j] * t37);
            const real t112 = d_x[j] * t101 + t111 + d_y[j] * t110 + t85[j] * t106 + t57[j] * t108;
            const real t113 = t109 - t51[j] * t112;
            Psi_x[11 * 8 + j] = t113;
            Psi_x[9 * 8 + j] = -t113;
            const real t114 = 0.5 * t102 * t71[j] + 2.0 * t104 * t88[j] + l0 * (0.5 * cos_q[j] * t69[j] - t37 * t21[j]);
            const real t115 = t0[j] * t110 + t114 - t90[j] * t106 + 2.0 * t63[j] * t108;
            const real t116 = t115 - t64[j] * t112;
            Psi_x[12 * 8 + j] = t116;
            Psi_x[10 * 8 + j] = -t116;
            Psi_x[13 * 8 + j] = l0 * (sin_q[j] * t117[j] + cos_q[j] * t118[j]) + l0 * (cos_q[j] * t119[j] - sin_q[j] * t120[j]);
            const real t121 = 2.0 * t24;
            Psi_v[4 * 8 + j] = t121;
            const real t122 = 2.0 * t31;
            Psi_v[5 * 8 + j] = t122;
            Psi_v[6 * 8 + j] = -(2.0 * t35);
            Psi_v[7 * 8 + j] = -t121;
            Psi_v[8 * 8 + j] = -t122;
            const real t123 = 2.0 * t40;
            Psi_v[11 * 8 + j] = t123;
            Psi_v[9 * 8 + j] = -t123;
            const real t124 = 2.0 * t42;
            Psi_v[12 * 8 + j] = t124;
            Psi_v[10 * 8 + j] = -t124;
            Psi_v[13 * 8 + j] = 2.0 * t44;
        }
    }
}

/* stiffness: 90 operations.
 * in:  x (6), sigma (3), tau (0), p (8)
 * out: K (6,6), 34 of 36 entries */
FLEXEL_CLONES
static void planar_beam_first_order_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict K = out[0] + b * (34 * 8);
        real d_x[8], d_y[8], t0[8], t1[8], t2[8], cos_p[8], t3[8], t5[8], cos_q[8], t6[8], sin_q[8], sin_p[8], t15[8], t16[8], t21[8], t30[8], t31[8], t32[8], t33[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real l = real_sqrt(d_x[j] * d_x[j] + d_y[j] * d_y[j]);
            t0[j] = 1.0 / l;
            t1[j] = t0[j] * t0[j];
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t2[j] = rp_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            const real sigma_bend1 = sigma[1 * 8 + j];
            t3[j] = l0 * sigma_bend1;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t5[j] = rq_angle + alphaq0;
            const real sigma_bend2 = sigma[2 * 8 + j];
            t6[j] = l0 * sigma_bend2;
            t15[j] = t0[j] * t1[j];
            t16[j] = d_x[j] * t15[j];
            t21[j] = d_y[j] * t15[j];
            const real el_y = d_y[j] * t0[j];
            t30[j] = el_y * t3[j];
            const real el_x = d_x[j] * t0[j];
            t31[j] = el_x * t3[j];
            t32[j] = el_y * t6[j];
            t33[j] = el_x * t6[j];
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t2[j]);
            cos_q[j] = real_cos(t5[j]);
            sin_q[j] = real_sin(t5[j]);
            sin_p[j] = real_sin(t2[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t4 = cos_p[j] * t3[j];
            const real t7 = cos_q[j] * t6[j];
            const real t8 = t4 - t7;
            const real t9 = sin_q[j] * t6[j];
            const real t10 = sin_p[j] * t3[j];
            const real t11 = t9 - t10;
            const real t12 = d_y[j] * t8 + d_x[j] * t11;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t13 = sigma_elongation - t1[j] * t12;
            const real t14 = t0[j] * t13;
            const real t17 = t13 - 2.0 * t0[j] * t12 * t0[j];
            const real t18 = t11 + d_x[j] * t17;
            const real t19 = t14 - t15[j] * t11 * d_x[j] - t16[j] * t18;
            K[0 * 8 + j] = K[20 * 8 + j] = t19;
            const real t20 = t15[j] * t8;
            const real t22 = d_x[j] * t20 + t21[j] * t18;
            K[4 * 8 + j] = K[9 * 8 + j] = K[18 * 8 + j] = K[23 * 8 + j] = t22;
            K[1 * 8 + j] = K[6 * 8 + j] = K[21 * 8 + j] = K[26 * 8 + j] = -t22;
            const real t23 = d_y[j] * t10 + d_x[j] * t4;
            const real t24 = t16[j] * t23 - t0[j] * t4;
            K[15 * 8 + j] = K[19 * 8 + j] = t24;
            K[2 * 8 + j] = K[12 * 8 + j] = -t24;
            K[3 * 8 + j] = K[17 * 8 + j] = -t19;
            const real t25 = d_y[j] * t9 + d_x[j] * t7;
            const real t26 = t0[j] * t7 - t16[j] * t25;
            K[22 * 8 + j] = K[31 * 8 + j] = t26;
            K[5 * 8 + j] = K[29 * 8 + j] = -t26;
            const real t27 = t14 - d_y[j] * t20 - t21[j] * (t8 + d_y[j] * t17);
            K[7 * 8 + j] = K[27 * 8 + j] = t27;
            const real t28 = t21[j] * t23 - t0[j] * t10;
            K[16 * 8 + j] = K[25 * 8 + j] = t28;
            K[8 * 8 + j] = K[13 * 8 + j] = -t28;
            K[10 * 8 + j] = K[24 * 8 + j] = -t27;
            const real t29 = t0[j] * t9 - t21[j] * t25;
            K[28 * 8 + j] = K[32 * 8 + j] = t29;
            K[11 * 8 + j] = K[30 * 8 + j] = -t29;
            K[14 * 8 + j] = -(cos_p[j] * t30[j] - sin_p[j] * t31[j]);
            K[33 * 8 + j] = cos_q[j] * t32[j] - sin_q[j] * t33[j];
        }
    }
}

/* inertia: 344 operations.
 * in:  x (6), v (6), p (8)
 * out: M (6,6), h (6), f (6), U (1) */
FLEXEL_CLONES
static void planar_beam_first_order_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict M = out[0] + b * (36 * 8);
        real *restrict h = out[1] + b * (6 * 8);
        real *restrict f = out[2] + b * (6 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real t0[8], t1[8], t2[8], sin_p[8], t3[8], sin_q[8], t5[8], t6[8], t7[8], cos_p[8], cos_q[8], t13[8], t14[8], t16[8], t18[8], t25[8], t26[8], t30[8], t40[8], t41[8], t43[8], t52[8], t54[8], t59[8], t66[8], t68[8], t69[8], t70[8], t74[8], t75[8], t76[8], t85[8], t87[8], t89[8], t91[8], t92[8], t97[8], t98[8], t101[8], t103[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real rhoA = p[3 * 8 + j];
            t0[j] = l0 * rhoA;
            t1[j] = 0.37142857142857144 * t0[j];
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t2[j] = rp_angle + alpha0;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t3[j] = rq_angle + alphaq0;
            t5[j] = 1.0 / l0;
            const real phi_z = p[5 * 8 + j];
            const real rhoJ = p[4 * 8 + j];
            t6[j] = 1.0 / (1.0 + phi_z) * (1.0 / (1.0 + phi_z)) * rhoJ * l0;
            t7[j] = t5[j] * t6[j] * t5[j];
            t13[j] = (phi_z - 0.2) * t6[j];
            t14[j] = t5[j] * t13[j];
            t16[j] = l0 * t0[j];
            t18[j] = 0.12857142857142856 * t0[j];
            const real t24 = phi_z * (0.16666666666666666 + 0.3333333333333333 * phi_z);
            t25[j] = 0.5 * (0.13333333333333333 + t24) * t6[j];
            t26[j] = l0 * l0 * t0[j];
            const real t29 = phi_z * (0.16666666666666666 * phi_z - 0.16666666666666666);
            t30[j] = 0.5 * (2.0 * t29 - 0.06666666666666667) * t6[j];
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t40[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t41[j] = q_vx - p_vx;
            const real rq_vangle = v[5 * 8 + j];
            const real rp_vangle = v[2 * 8 + j];
            t43[j] = 0.25 * rq_vangle * t13[j] + 0.25 * rp_vangle * t13[j];
            t52[j] = rq_vangle * t16[j];
            t54[j] = rp_vangle * t16[j];
            t59[j] = rq_vangle * t26[j];
            t66[j] = rp_vangle * rp_vangle * t26[j];
            t68[j] = rp_vangle * rq_vangle;
            t69[j] = 0.030952380952380953 * (rp_vangle * q_vx * t16[j]);
            t70[j] = 0.05238095238095238 * (p_vx * rp_vangle * t16[j]);
            t74[j] = 0.030952380952380953 * (q_vy * t54[j]);
            t75[j] = rp_vangle * t59[j];
            t76[j] = 0.05238095238095238 * (p_vy * t54[j]);
            t85[j] = rq_vangle * rq_vangle * t26[j];
            t87[j] = 0.05238095238095238 * (q_vx * rq_vangle * t16[j]);
            t89[j] = 0.030952380952380953 * (p_vx * rq_vangle * t16[j]);
            t91[j] = 0.05238095238095238 * (q_vy * t52[j]);
            t92[j] = 0.030952380952380953 * (p_vy * t52[j]);
            const real gravity_x = p[6 * 8 + j];
            const real t95 = gravity_x * t0[j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * t95;
            const real gravity_y = p[7 * 8 + j];
            const real t96 = gravity_y * t0[j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * t96;
            t97[j] = l0 * t95;
            t98[j] = l0 * t96;
            const real p_x = x[0 * 8 + j];
            const real q_x = x[3 * 8 + j];
            t101[j] = 0.5 * (p_x + q_x);
            const real p_y = x[1 * 8 + j];
            const real q_y = x[4 * 8 + j];
            t103[j] = 0.5 * (p_y + q_y);
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t2[j]);
            sin_q[j] = real_sin(t3[j]);
            cos_p[j] = real_cos(t2[j]);
            cos_q[j] = real_cos(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t4 = sin_p[j] + sin_q[j];
            const real t8 = t4 * t7[j];
            const real t9 = 0.3 * (t4 * t8);
            M[0 * 8 + j] = M[21 * 8 + j] = t1[j] + t9;
            const real t10 = cos_p[j] + cos_q[j];
            const real t11 = t10 * t7[j];
            const real t12 = 0.3 * (t4 * t11);
            M[4 * 8 + j] = M[24 * 8 + j] = t12;
            M[1 * 8 + j] = M[6 * 8 + j] = M[22 * 8 + j] = M[27 * 8 + j] = -t12;
            const real t15 = 0.25 * t4 * t14[j];
            const real t17 = sin_p[j] * t16[j];
            M[2 * 8 + j] = M[12 * 8 + j] = t15 - 0.05238095238095238 * t17;
            M[3 * 8 + j] = M[18 * 8 + j] = t18[j] - t9;
            const real t19 = sin_q[j] * t16[j];
            M[5 * 8 + j] = M[30 * 8 + j] = 0.030952380952380953 * t19 + t15;
            const real t20 = 0.3 * (t10 * t11);
            M[7 * 8 + j] = M[28 * 8 + j] = t1[j] + t20;
            const real t21 = cos_p[j] * t16[j];
            const real t22 = 0.25 * t10 * t14[j];
            M[8 * 8 + j] = M[13 * 8 + j] = 0.05238095238095238 * t21 - t22;
            M[9 * 8 + j] = M[19 * 8 + j] = 0.3 * (t10 * t8);
            M[10 * 8 + j] = M[25 * 8 + j] = t18[j] - t20;
            const real t23 = cos_q[j] * t16[j];
            M[11 * 8 + j] = M[31 * 8 + j] = -(0.030952380952380953 * t23 + t22);
            const real t27 = t25[j] + 0.004761904761904762 * (sin_p[j] * sin_p[j] * t26[j]);
            const real t28 = t27 + 0.004761904761904762 * (cos_p[j] * cos_p[j] * t26[j]);
            M[14 * 8 + j] = 2.0 * t28;
            M[15 * 8 + j] = M[20 * 8 + j] = -(0.030952380952380953 * t17 + t15);
            M[16 * 8 + j] = M[26 * 8 + j] = 0.030952380952380953 * t21 + t22;
            const real t31 = sin_q[j] * t26[j];
            M[17 * 8 + j] = M[32 * 8 + j] = t30[j] - 0.007142857142857143 * (sin_p[j] * t31) - 0.007142857142857143 * (cos_p[j] * cos_q[j] * t26[j]);
            M[23 * 8 + j] = M[33 * 8 + j] = 0.05238095238095238 * t19 - t15;
            M[29 * 8 + j] = M[34 * 8 + j] = t22 - 0.05238095238095238 * t23;
            const real t32 = t25[j] + 0.004761904761904762 * (sin_q[j] * sin_q[j] * t26[j]);
            const real t33 = t32 + 0.004761904761904762 * (cos_q[j] * cos_q[j] * t26[j]);
            M[35 * 8 + j] = 2.0 * t33;
            const real rq_vangle = v[5 * 8 + j];
            const real t34 = rq_vangle * cos_q[j];
            const real t35 = t34 * t16[j];
            const real t36 = rq_vangle * t35;
            const real rp_vangle = v[2 * 8 + j];
            const real t37 = rp_vangle * cos_p[j];
            const real t38 = t37 * t16[j];
            const real t39 = rp_vangle * t38;
            const real t42 = 0.15 * (t5[j] * (t10 * t40[j] - t41[j] * t4) * t6[j]);
            const real t44 = t5[j] * (t43[j] + t42 + t42);
            const real t45 = t37 + t34;
            const real t46 = rp_vangle * sin_p[j];
            const real t47 = rq_vangle * sin_q[j];
            const real t48 = t46 + t47;
            const real t49 = t5[j] * (t40[j] * t48 + t41[j] * t45);
            const real t50 = t6[j] * t49 * t5[j];
            const real t51 = t44 * t45 - 0.3 * (t4 * t50);
            h[0 * 8 + j] = 0.030952380952380953 * t36 - 0.05238095238095238 * t39 + t51;
            const real t53 = t47 * t52[j];
            const real t55 = t46 * t54[j];
            const real t56 = t44 * t48 + 0.3 * (t10 * t50);
            h[1 * 8 + j] = 0.030952380952380953 * t53 - 0.05238095238095238 * t55 + t56;
            const real t57 = 0.009523809523809525 * (sin_p[j] * t37 * t26[j]) - 0.009523809523809525 * (cos_p[j] * t46 * t26[j]);
            const real t58 = rp_vangle * t57;
            const real t60 = cos_q[j] * t46 + cos_p[j] * t47;
            const real t61 = 0.25 * t13[j] * t49;
            const real t62 = t37 * t31 + t34 * t26[j] * sin_p[j];
            const real t63 = 0.007142857142857143 * (t59[j] * t60) - (t61 + 0.007142857142857143 * (rq_vangle * t62));
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t64 = t63 - 0.030952380952380953 * (q_vx * t38) - 0.05238095238095238 * (p_vx * t38);
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t65 = t64 - 0.030952380952380953 * (q_vy * t46 * t16[j]) - 0.05238095238095238 * (p_vy * t46 * t16[j]);
            const real t67 = 0.004761904761904762 * (sin_p[j] * t66[j]);
            const real t71 = t67 - (0.007142857142857143 * (t68[j] * t31) + t69[j] + t70[j]);
            const real t72 = t41[j] * t44;
            const real t73 = 0.004761904761904762 * (cos_p[j] * t66[j]);
            const real t77 = t74[j] - 0.007142857142857143 * (cos_q[j] * t75[j]) + t76[j];
            const real t78 = t40[j] * t44;
            const real t79 = cos_p[j] * (t67 + t71 - t72) - sin_p[j] * (t77 + t73 + t73 + t78);
            h[2 * 8 + j] = t65 + t58 + t58 - t79;
            h[3 * 8 + j] = 0.05238095238095238 * t36 - 0.030952380952380953 * t39 - t51;
            h[4 * 8 + j] = 0.05238095238095238 * t53 - 0.030952380952380953 * t55 - t56;
            const real t80 = 0.009523809523809525 * (sin_q[j] * t34 * t26[j]) - 0.009523809523809525 * (cos_q[j] * t47 * t26[j]);
            const real t81 = rq_vangle * t80;
            const real t82 = 0.007142857142857143 * (rp_vangle * t60 * t26[j]) - (t61 + 0.007142857142857143 * (rp_vangle * t62));
            const real t83 = t82 + 0.05238095238095238 * (q_vx * t35) + 0.030952380952380953 * (p_vx * t35);
            const real t84 = t83 + 0.05238095238095238 * (q_vy * t47 * t16[j]) + 0.030952380952380953 * (p_vy * t47 * t16[j]);
            const real t86 = 0.004761904761904762 * (sin_q[j] * t85[j]);
            const real t88 = t87[j] - 0.007142857142857143 * (sin_p[j] * t68[j] * t26[j]);
            const real t90 = 0.004761904761904762 * (cos_q[j] * t85[j]);
            const real t93 = 0.007142857142857143 * (cos_p[j] * t75[j]) + t91[j] + t92[j];
            const real t94 = cos_q[j] * (t88 + t89[j] + t86 + t86 - t72) - sin_q[j] * (t90 - t93 + t90 + t78);
            h[5 * 8 + j] = t84 + t81 + t81 - t94;
            const real t99 = 0.08333333333333333 * (sin_p[j] * t97[j]) - 0.08333333333333333 * (cos_p[j] * t98[j]);
            f[2 * 8 + j] = -t99;
            const real t100 = 0.08333333333333333 * (cos_q[j] * t98[j]) - 0.08333333333333333 * (sin_q[j] * t97[j]);
            f[5 * 8 + j] = -t100;
            const real l0 = p[0 * 8 + j];
            const real t102 = t101[j] + 0.08333333333333333 * (l0 * (cos_p[j] - cos_q[j]));
            const real gravity_x = p[6 * 8 + j];
            const real t104 = t103[j] + 0.08333333333333333 * (l0 * (sin_p[j] - sin_q[j]));
            const real gravity_y = p[7 * 8 + j];
            U[0 * 8 + j] = -((gravity_x * t102 + gravity_y * t104) * t0[j]);
        }
    }
}

/* tangent: 667 operations.
 * in:  x (6), v (6), a (6), p (8)
 * out: R_x (6,6), 12 of 36 entries, R_v (6,6) */
FLEXEL_CLONES
static void planar_beam_first_order_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict R_x = out[0] + b * (12 * 8);
        real *restrict R_v = out[1] + b * (36 * 8);
        real t0[8], cos_p[8], t1[8], t2[8], t3[8], cos_q[8], t5[8], t6[8], sin_p[8], sin_q[8], t10[8], t15[8], t18[8], t19[8], t27[8], t31[8], t45[8], t46[8], t48[8], t49[8], t52[8], t53[8], t55[8], t56[8], t58[8], t70[8], t75[8], t76[8], t77[8], t82[8], t83[8], t84[8], t111[8], t115[8], t117[8], t120[8], t121[8], t125[8], t130[8], t132[8], t140[8], t157[8], t159[8], t162[8], t168[8], t171[8], t174[8], t188[8], t195[8], t197[8], t200[8], t202[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            t1[j] = 1.0 / l0;
            const real phi_z = p[5 * 8 + j];
            const real rhoJ = p[4 * 8 + j];
            t2[j] = 1.0 / (1.0 + phi_z) * (1.0 / (1.0 + phi_z)) * rhoJ * l0;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t3[j] = rq_angle + alphaq0;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t5[j] = q_ay - p_ay;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t6[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t10[j] = q_vx - p_vx;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t15[j] = q_ax - p_ax;
            t18[j] = (phi_z - 0.2) * t2[j];
            const real rq_aangle = a[5 * 8 + j];
            const real rp_aangle = a[2 * 8 + j];
            t19[j] = 0.25 * rq_aangle * t18[j] + 0.25 * rp_aangle * t18[j];
            const real rq_vangle = v[5 * 8 + j];
            const real rp_vangle = v[2 * 8 + j];
            t27[j] = 0.25 * rq_vangle * t18[j] + 0.25 * rp_vangle * t18[j];
            const real rhoA = p[3 * 8 + j];
            const real t30 = l0 * rhoA;
            t31[j] = l0 * t30;
            t45[j] = rp_vangle * t31[j];
            t46[j] = rp_aangle * t31[j];
            t48[j] = rq_vangle * t31[j];
            t49[j] = rq_aangle * t31[j];
            const real gravity_y = p[7 * 8 + j];
            t52[j] = gravity_y * t30 * l0;
            const real gravity_x = p[6 * 8 + j];
            t53[j] = gravity_x * t30 * l0;
            t55[j] = l0 * l0 * t30;
            t56[j] = rq_vangle * t55[j];
            t58[j] = rq_aangle * t55[j];
            t70[j] = rp_vangle * rp_vangle * t55[j];
            t75[j] = rp_vangle * rq_vangle;
            t76[j] = 0.030952380952380953 * (rp_vangle * q_vx * t31[j]);
            t77[j] = 0.05238095238095238 * (p_vx * rp_vangle * t31[j]);
            t82[j] = 0.030952380952380953 * (q_vy * t45[j]);
            t83[j] = rp_vangle * t56[j];
            t84[j] = 0.05238095238095238 * (p_vy * t45[j]);
            t111[j] = rq_vangle * rq_vangle * t55[j];
            t115[j] = 0.05238095238095238 * (q_vx * rq_vangle * t31[j]);
            t117[j] = 0.030952380952380953 * (p_vx * rq_vangle * t31[j]);
            t120[j] = 0.05238095238095238 * (q_vy * t48[j]);
            t121[j] = 0.030952380952380953 * (p_vy * t48[j]);
            t125[j] = t1[j] * t2[j] * t1[j];
            t130[j] = t1[j] * t18[j];
            t132[j] = 0.05238095238095238 * t45[j];
            t140[j] = 0.030952380952380953 * t48[j];
            const real t155 = q_vy * t31[j];
            const real t156 = p_vy * t31[j];
            t157[j] = 0.030952380952380953 * t155 + 0.05238095238095238 * t156;
            t159[j] = rp_vangle * t55[j];
            const real t160 = q_vx * t31[j];
            const real t161 = p_vx * t31[j];
            t162[j] = 0.030952380952380953 * t160 + 0.05238095238095238 * t161;
            t168[j] = t31[j] * (0.05238095238095238 * p_vx + 0.030952380952380953 * q_vx);
            t171[j] = t31[j] * (0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy);
            t174[j] = 0.030952380952380953 * t45[j];
            t188[j] = 0.05238095238095238 * t48[j];
            t195[j] = 0.05238095238095238 * t155 + 0.030952380952380953 * t156;
            t197[j] = 0.05238095238095238 * t160 + 0.030952380952380953 * t161;
            t200[j] = t31[j] * (0.030952380952380953 * p_vx + 0.05238095238095238 * q_vx);
            t202[j] = t31[j] * (0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy);
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            cos_q[j] = real_cos(t3[j]);
            sin_p[j] = real_sin(t0[j]);
            sin_q[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t4 = cos_p[j] + cos_q[j];
            const real rp_vangle = v[2 * 8 + j];
            const real t7 = rp_vangle * sin_p[j];
            const real rq_vangle = v[5 * 8 + j];
            const real t8 = rq_vangle * sin_q[j];
            const real t9 = t7 + t8;
            const real t11 = rp_vangle * cos_p[j];
            const real t12 = rq_vangle * cos_q[j];
            const real t13 = t11 + t12;
            const real t14 = sin_p[j] + sin_q[j];
            const real t16 = t1[j] * (t4 * t5[j] - t6[j] * t9 - (t10[j] * t13 + t14 * t15[j]));
            const real t17 = 0.15 * (t2[j] * t16);
            const real t20 = t1[j] * (t19[j] + t17 + t17);
            const real t21 = t6[j] * t11 + sin_p[j] * t5[j] + (cos_p[j] * t15[j] - t10[j] * t7);
            const real t22 = t1[j] * t21;
            const real t23 = t2[j] * t22 * t1[j];
            const real t24 = sin_p[j] * t6[j] + cos_p[j] * t10[j];
            const real t25 = t1[j] * t24 * t2[j] * t1[j];
            const real t26 = 0.15 * (t1[j] * (t4 * t6[j] - t10[j] * t14) * t2[j]);
            const real t28 = t1[j] * (t27[j] + t26 + t26);
            const real t29 = cos_p[j] * t20 - 0.3 * (t14 * t23) - (0.3 * (t13 * t25) + t7 * t28);
            const real t32 = cos_p[j] * t31[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t33 = t7 * t31[j];
            const real t34 = rp_aangle * t32 - rp_vangle * t33;
            R_x[0 * 8 + j] = t29 - 0.05238095238095238 * t34;
            const real t35 = cos_q[j] * t31[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t36 = t8 * t31[j];
            const real t37 = rq_aangle * t35 - rq_vangle * t36;
            const real t38 = t6[j] * t12 + sin_q[j] * t5[j] + (cos_q[j] * t15[j] - t10[j] * t8);
            const real t39 = t1[j] * t38;
            const real t40 = t2[j] * t39 * t1[j];
            const real t41 = sin_q[j] * t6[j] + cos_q[j] * t10[j];
            const real t42 = t1[j] * t41 * t2[j] * t1[j];
            const real t43 = cos_q[j] * t20 - 0.3 * (t14 * t40) - (0.3 * (t13 * t42) + t8 * t28);
            R_x[1 * 8 + j] = 0.030952380952380953 * t37 + t43;
            const real t44 = t11 * t28 - 0.3 * (t9 * t25) + (sin_p[j] * t20 + 0.3 * (t4 * t23));
            const real t47 = t11 * t45[j] + sin_p[j] * t46[j];
            R_x[2 * 8 + j] = t44 - 0.05238095238095238 * t47;
            const real t50 = t12 * t48[j] + sin_q[j] * t49[j];
            const real t51 = t12 * t28 - 0.3 * (t9 * t42) + (sin_q[j] * t20 + 0.3 * (t4 * t40));
            R_x[3 * 8 + j] = 0.030952380952380953 * t50 + t51;
            const real t54 = 0.08333333333333333 * (sin_p[j] * t52[j]) + 0.08333333333333333 * (cos_p[j] * t53[j]);
            const real t57 = cos_q[j] * t11 - sin_p[j] * t8;
            const real t59 = sin_p[j] * cos_q[j];
            const real t60 = 0.25 * t18[j] * t22;
            const real t61 = t12 * t55[j];
            const real t62 = sin_q[j] * t55[j];
            const real t63 = cos_p[j] * t61 - t7 * t62;
            const real t64 = cos_p[j] * t62;
            const real t65 = 0.007142857142857143 * (rq_vangle * t63) + 0.007142857142857143 * (rq_aangle * t64);
            const real t66 = 0.007142857142857143 * (t56[j] * t57 + t58[j] * t59) - (t60 + t65);
            const real q_ax = a[3 * 8 + j];
            const real q_vx = v[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t67 = t66 - 0.030952380952380953 * (q_ax * t32 - q_vx * t33) - 0.05238095238095238 * (p_ax * t32 - p_vx * t33);
            const real q_vy = v[4 * 8 + j];
            const real q_ay = a[4 * 8 + j];
            const real t68 = 0.030952380952380953 * (t31[j] * (q_vy * t11 + sin_p[j] * q_ay));
            const real p_vy = v[1 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t69 = 0.05238095238095238 * (t31[j] * (p_vy * t11 + sin_p[j] * p_ay));
            const real t71 = cos_p[j] * t70[j];
            const real t72 = 0.3 * (t10[j] * t25);
            const real t73 = sin_p[j] * t70[j];
            const real t74 = 0.004761904761904762 * t73;
            const real t78 = t74 - (0.007142857142857143 * (t75[j] * t62) + t76[j] + t77[j]);
            const real t79 = t10[j] * t28;
            const real t80 = cos_p[j] * (0.009523809523809525 * t71 + t72) - sin_p[j] * (t74 + t78 - t79);
            const real t81 = 0.004761904761904762 * t71;
            const real t85 = t82[j] - 0.007142857142857143 * (cos_q[j] * t83[j]) + t84[j];
            const real t86 = t6[j] * t28;
            const real t87 = 0.3 * (t6[j] * t25);
            const real t88 = cos_p[j] * (t85 + t81 + t81 + t86) - sin_p[j] * (0.009523809523809525 * t73 + t87);
            R_x[4 * 8 + j] = t67 - t68 - t69 - (t80 - t88) + t54;
            const real t89 = cos_p[j] * t12 - sin_q[j] * t7;
            const real t90 = cos_p[j] * sin_q[j];
            const real t91 = 0.25 * t18[j] * t39;
            const real t92 = cos_q[j] * t55[j];
            const real t93 = t11 * t92 - t8 * t55[j] * sin_p[j];
            const real t94 = sin_p[j] * t92;
            const real t95 = 0.007142857142857143 * (rq_vangle * t93) + 0.007142857142857143 * (rq_aangle * t94);
            const real t96 = 0.007142857142857143 * (t56[j] * t89 + t58[j] * t90) - (t91 + t95);
            const real t97 = 0.3 * (t10[j] * t42);
            const real t98 = 0.3 * (t6[j] * t42);
            const real t99 = sin_p[j] * (0.007142857142857143 * (sin_q[j] * t83[j]) - t98);
            const real t100 = cos_p[j] * (t97 - 0.007142857142857143 * (t75[j] * t92)) - t99;
            R_x[5 * 8 + j] = t96 - t100;
            R_x[6 * 8 + j] = -(0.030952380952380953 * t34 + t29);
            R_x[7 * 8 + j] = 0.05238095238095238 * t37 - t43;
            R_x[8 * 8 + j] = -(0.030952380952380953 * t47 + t44);
            R_x[9 * 8 + j] = 0.05238095238095238 * t50 - t51;
            const real t101 = 0.007142857142857143 * (t55[j] * (rp_vangle * t57 + rp_aangle * t59));
            const real t102 = 0.007142857142857143 * (rp_vangle * t63) + 0.007142857142857143 * (rp_aangle * t64);
            const real t103 = t72 - 0.007142857142857143 * (cos_p[j] * t75[j] * t55[j]);
            const real t104 = sin_q[j] * (0.007142857142857143 * (sin_p[j] * t83[j]) - t87);
            R_x[10 * 8 + j] = t101 - (t60 + t102) - (cos_q[j] * t103 - t104);
            const real t105 = 0.007142857142857143 * (t55[j] * (rp_vangle * t89 + rp_aangle * t90));
            const real t106 = 0.007142857142857143 * (rp_vangle * t93) + 0.007142857142857143 * (rp_aangle * t94);
            const real t107 = t105 - (t91 + t106) + 0.05238095238095238 * (q_ax * t35 - q_vx * t36);
            const real t108 = 0.05238095238095238 * (t31[j] * (q_vy * t12 + sin_q[j] * q_ay));
            const real t109 = t107 + 0.030952380952380953 * (p_ax * t35 - p_vx * t36) + t108;
            const real t110 = 0.030952380952380953 * (t31[j] * (p_vy * t12 + sin_q[j] * p_ay));
            const real t112 = cos_q[j] * t111[j];
            const real t113 = sin_q[j] * t111[j];
            const real t114 = 0.004761904761904762 * t113;
            const real t116 = t115[j] - 0.007142857142857143 * (sin_p[j] * t75[j] * t55[j]);
            const real t118 = cos_q[j] * (0.009523809523809525 * t112 + t97) - sin_q[j] * (t116 + t117[j] + t114 + t114 - t79);
            const real t119 = 0.004761904761904762 * t112;
            const real t122 = 0.007142857142857143 * (cos_p[j] * t83[j]) + t120[j] + t121[j];
            const real t123 = cos_q[j] * (t119 - t122 + t119 + t86) - sin_q[j] * (0.009523809523809525 * t113 + t98);
            const real t124 = 0.08333333333333333 * (sin_q[j] * t52[j]) + 0.08333333333333333 * (cos_q[j] * t53[j]);
            R_x[11 * 8 + j] = t109 + t110 - (t118 - t123) - t124;
            const real t126 = t14 * t125[j];
            const real t127 = 0.6 * (t13 * t126);
            R_v[0 * 8 + j] = R_v[21 * 8 + j] = t127;
            const real t128 = t4 * t125[j];
            const real t129 = 0.3 * (t9 * t126) - 0.3 * (t13 * t128);
            R_v[1 * 8 + j] = R_v[6 * 8 + j] = R_v[22 * 8 + j] = R_v[27 * 8 + j] = t129;
            const real t131 = 0.25 * t13 * t130[j];
            const real t133 = t28 - t132[j];
            const real t134 = cos_p[j] * t133;
            const real t135 = t11 * t31[j];
            const real t136 = 0.05238095238095238 * t135;
            const real t137 = 0.3 * (t126 * t24);
            R_v[2 * 8 + j] = t134 - t136 + t131 - t137;
            R_v[3 * 8 + j] = R_v[18 * 8 + j] = -t127;
            R_v[4 * 8 + j] = R_v[9 * 8 + j] = R_v[19 * 8 + j] = R_v[24 * 8 + j] = -t129;
            const real t138 = t12 * t31[j];
            const real t139 = 0.030952380952380953 * t138;
            const real t141 = t140[j] + t28;
            const real t142 = cos_q[j] * t141;
            const real t143 = 0.3 * (t126 * t41);
            R_v[5 * 8 + j] = t139 + t142 + t131 - t143;
            const real t144 = 0.6 * (t9 * t128);
            R_v[10 * 8 + j] = R_v[25 * 8 + j] = t144;
            R_v[7 * 8 + j] = R_v[28 * 8 + j] = -t144;
            const real t145 = 0.3 * (t128 * t24);
            const real t146 = 0.25 * t9 * t130[j];
            const real t147 = sin_p[j] * t133;
            const real t148 = 0.05238095238095238 * t33;
            R_v[8 * 8 + j] = t147 - t148 + t146 + t145;
            const real t149 = 0.3 * (t128 * t41);
            const real t150 = 0.030952380952380953 * t36;
            const real t151 = sin_q[j] * t141;
            R_v[11 * 8 + j] = t150 + t151 + t146 + t149;
            R_v[12 * 8 + j] = t137 - (t136 + t134) + t131;
            R_v[13 * 8 + j] = t146 - (t148 + t147 + t145);
            const real t152 = 0.009523809523809525 * (sin_p[j] * t11 * t55[j]) - 0.009523809523809525 * (cos_p[j] * t7 * t55[j]);
            const real t153 = cos_q[j] * t56[j];
            const real t154 = 0.007142857142857143 * t153;
            const real t158 = t157[j] + 0.01904761904761905 * (cos_p[j] * t55[j] * rp_vangle);
            const real t163 = rq_vangle * t62;
            const real t164 = 0.007142857142857143 * t163;
            const real t165 = 0.01904761904761905 * (sin_p[j] * t159[j]) - t162[j] - t164;
            const real t166 = sin_p[j] * t55[j];
            const real t167 = rp_vangle * t166;
            const real t169 = 2.0 * t152 + sin_p[j] * (t154 - t158) - cos_p[j] * t165 + cos_p[j] * (0.01904761904761905 * t167 - t164 - t168[j]);
            const real t170 = cos_p[j] * t159[j];
            const real t172 = t169 + sin_p[j] * (0.01904761904761905 * t170 + t171[j] - t154);
            const real t173 = 0.25 * t130[j] * t24;
            R_v[14 * 8 + j] = t172 + t173 - t173;
            const real t175 = t174[j] + t28;
            const real t176 = cos_p[j] * t175;
            const real t177 = 0.030952380952380953 * t135;
            R_v[15 * 8 + j] = t176 - t177 - t137 - t131;
            const real t178 = sin_p[j] * t175;
            const real t179 = 0.030952380952380953 * t33;
            R_v[16 * 8 + j] = t178 - t179 + t145 - t146;
            const real t180 = 0.007142857142857143 * (t55[j] * (cos_q[j] * t7 + cos_p[j] * t8));
            const real t181 = t180 - 0.007142857142857143 * (t11 * t62 + sin_p[j] * t61);
            const real t182 = 0.007142857142857143 * (cos_p[j] * t56[j] * sin_q[j]);
            const real t183 = 0.007142857142857143 * (rp_vangle * t62 * cos_p[j]);
            const real t184 = 0.007142857142857143 * (rq_vangle * t166 * cos_q[j]);
            const real t185 = 0.007142857142857143 * (cos_q[j] * t159[j] * sin_p[j]);
            const real t186 = 0.25 * t130[j] * t41;
            R_v[17 * 8 + j] = t181 + t182 + t183 - t184 - t185 + t173 - t186;
            R_v[20 * 8 + j] = t137 - (t177 + t176 + t131);
            const real t187 = 0.05238095238095238 * t138;
            const real t189 = t188[j] - t28;
            const real t190 = cos_q[j] * t189;
            R_v[23 * 8 + j] = t187 + t190 - t131 + t143;
            R_v[26 * 8 + j] = -(t179 + t178 + t146 + t145);
            const real t191 = 0.05238095238095238 * t36;
            const real t192 = sin_q[j] * t189;
            R_v[29 * 8 + j] = t191 + t192 - t146 - t149;
            R_v[30 * 8 + j] = t139 - t142 + t143 + t131;
            R_v[31 * 8 + j] = t150 - t151 - t149 + t146;
            R_v[32 * 8 + j] = t181 + t185 + t184 - t183 - t182 + t186 - t173;
            R_v[33 * 8 + j] = t187 - t190 - t143 - t131;
            R_v[34 * 8 + j] = t191 - t192 + t149 - t146;
            const real t193 = 0.009523809523809525 * (sin_q[j] * t12 * t55[j]) - 0.009523809523809525 * (cos_q[j] * t8 * t55[j]);
            const real t194 = 0.007142857142857143 * t170;
            const real t196 = sin_q[j] * (t195[j] - 0.01904761904761905 * (rq_vangle * t92) + t194);
            const real t198 = 0.007142857142857143 * t167;
            const real t199 = 0.01904761904761905 * (sin_q[j] * t56[j]) + t197[j] - t198;
            const real t201 = 2.0 * t193 + t196 - cos_q[j] * t199 + cos_q[j] * (0.01904761904761905 * t163 - t198 + t200[j]);
            const real t203 = t201 + sin_q[j] * (0.01904761904761905 * t153 - t202[j] - t194);
            R_v[35 * 8 + j] = t203 + t186 - t186;
        }
    }
}

const flexel_element flexel_planar_beam_first_order = {
    .name = "planar_beam_first_order",
    .n = 6,
    .m = 3,
    .k = 0,
    .np = 8,
    .position = planar_beam_first_order_position,
    .velocity = planar_beam_first_order_velocity,
    .acceleration = planar_beam_first_order_acceleration,
    .kinematics = planar_beam_first_order_kinematics,
    .stiffness = planar_beam_first_order_stiffness,
    .inertia = planar_beam_first_order_inertia,
    .tangent = planar_beam_first_order_tangent,
};
