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

/* kinematics: 442 operations.
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
        real el_x[8], el_y[8], t13[8], cos_p[8], t17[8], t18[8], sin_p[8], t20[8], t23[8], t28[8], t29[8], t30[8], t31[8], t34[8], t35[8], t38[8], cos_q[8], sin_q[8], t63[8], t67[8], t75[8], t80[8], t84[8], t85[8], t90[8], t93[8], t97[8], t99[8], t101[8], t102[8];
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
            el_x[j] = d_x * t0;
            const real t1 = t0 * t0;
            const real t2 = el_x[j] * t1;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t3 = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t4 = q_vy - p_vy;
            const real t5 = 2.0 * d_x * t3 + 2.0 * d_y * t4;
            const real t6 = t0 * t3;
            const real t7 = t2 * t5 - 2.0 * t6;
            Psi_v[0 * 8 + j] = t7;
            const real t8 = 0.5 * t7;
            Phi_x[0 * 8 + j] = t8;
            el_y[j] = d_y * t0;
            const real t9 = el_y[j] * t1;
            const real t10 = t0 * t4;
            const real t11 = t9 * t5 - 2.0 * t10;
            Psi_v[1 * 8 + j] = t11;
            const real t12 = 0.5 * t11;
            Phi_x[1 * 8 + j] = t12;
            Phi_x[2 * 8 + j] = -t8;
            Phi_x[3 * 8 + j] = -t12;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t13[j] = rp_angle + alpha0;
            const real t14 = t0 * t5;
            const real t15 = t0 * t2;
            const real t16 = 2.0 * t14 * t15 + t1 * t7;
            t17[j] = t4 * t2 - 0.5 * d_y * t16;
            t18[j] = d_y * t2;
            t20[j] = d_x * t2 - t0;
            const real t22 = t1 * t14;
            t23[j] = t3 * t2 - 0.5 * (d_x * t16 - t22);
            const real t26 = t0 * t9;
            const real t27 = 2.0 * t14 * t26 + t1 * t11;
            t28[j] = t4 * t9 - 0.5 * (d_y * t27 - t22);
            t29[j] = d_y * t9 - t0;
            t30[j] = d_x * t9;
            t31[j] = t3 * t9 - 0.5 * d_x * t27;
            t34[j] = t10 - 0.5 * d_y * t22;
            t35[j] = t6 - 0.5 * d_x * t22;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t38[j] = rq_angle + alphaq0;
            const real t47 = 2.0 * t3 * t3 + 2.0 * t4 * t4;
            const real t48 = t3 * t22;
            const real t49 = t2 * t47 - 0.5 * (t5 * t16 - 2.0 * t48);
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t50 = q_ax - p_ax;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t51 = q_ay - p_ay;
            const real t52 = 2.0 * d_x * t50 + 2.0 * d_y * t51;
            const real t53 = t0 * t50;
            const real t54 = t2 * t52 - 2.0 * t53;
            const real t55 = 0.5 * t49 + 0.5 * t54;
            Psi_x[0 * 8 + j] = t55;
            const real t56 = t4 * t22;
            const real t57 = t9 * t47 - 0.5 * (t5 * t27 - 2.0 * t56);
            const real t58 = t0 * t51;
            const real t59 = t9 * t52 - 2.0 * t58;
            const real t60 = 0.5 * t57 + 0.5 * t59;
            Psi_x[1 * 8 + j] = t60;
            Psi_x[2 * 8 + j] = -t55;
            Psi_x[3 * 8 + j] = -t60;
            const real t61 = t0 * t52;
            const real t62 = 2.0 * t61 * t15 + t1 * t54;
            t63[j] = t2 * t51 - 0.5 * d_y * t62;
            const real t66 = t1 * t61;
            t67[j] = t2 * t50 - 0.5 * (d_x * t62 - t66);
            const real t71 = t4 * t16;
            const real t72 = t0 * t47 - 0.5 * t5 * t22;
            const real t73 = t0 * t22;
            const real t74 = 2.0 * t72 * t15 + t1 * t49 - (t73 * t7 + t14 * (t2 * t22 + t0 * t16));
            t75[j] = 0.5 * t71 + 0.5 * (t71 + d_y * t74);
            const real t78 = t3 * t16;
            const real t79 = t1 * t72 - t14 * t73;
            t80[j] = 0.5 * t78 + 0.5 * (d_x * t74 - t79 + t78);
            const real t83 = 2.0 * t61 * t26 + t1 * t59;
            t84[j] = t9 * t51 - 0.5 * (d_y * t83 - t66);
            t85[j] = t9 * t50 - 0.5 * d_x * t83;
            const real t88 = t4 * t27;
            const real t89 = 2.0 * t72 * t26 + t1 * t57 - (t73 * t11 + t14 * (t9 * t22 + t0 * t27));
            t90[j] = 0.5 * t88 + 0.5 * (d_y * t89 - t79 + t88);
            const real t92 = t3 * t27;
            t93[j] = 0.5 * t92 + 0.5 * (t92 + d_x * t89);
            t97[j] = 0.5 * t56 + 0.5 * (t56 + d_y * t79);
            t99[j] = 0.5 * t48 + 0.5 * (t48 + d_x * t79);
            t101[j] = t58 - 0.5 * d_y * t66;
            t102[j] = t53 - 0.5 * d_x * t66;
            Psi_v[2 * 8 + j] = -t7;
            Psi_v[3 * 8 + j] = -t11;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t13[j]);
            sin_p[j] = real_sin(t13[j]);
            cos_q[j] = real_cos(t38[j]);
            sin_q[j] = real_sin(t38[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t19 = rp_vangle * sin_p[j];
            const real t21 = rp_vangle * cos_p[j];
            const real t24 = cos_p[j] * t17[j] - t18[j] * t19 - (t20[j] * t21 + sin_p[j] * t23[j]);
            const real l0 = p[0 * 8 + j];
            const real t25 = l0 * t24;
            Phi_x[4 * 8 + j] = t25;
            const real t32 = cos_p[j] * t28[j] - t29[j] * t19 - (t30[j] * t21 + sin_p[j] * t31[j]);
            const real t33 = l0 * t32;
            Phi_x[5 * 8 + j] = t33;
            const real t36 = el_y[j] * t21 + sin_p[j] * t34[j] + (cos_p[j] * t35[j] - el_x[j] * t19);
            const real t37 = l0 * t36;
            Phi_x[6 * 8 + j] = -t37;
            Phi_x[7 * 8 + j] = -t25;
            Phi_x[8 * 8 + j] = -t33;
            const real rq_vangle = v[5 * 8 + j];
            const real t39 = rq_vangle * sin_q[j];
            const real t40 = rq_vangle * cos_q[j];
            const real t41 = cos_q[j] * t17[j] - t18[j] * t39 - (t20[j] * t40 + sin_q[j] * t23[j]);
            const real t42 = l0 * t41;
            Phi_x[11 * 8 + j] = t42;
            Phi_x[9 * 8 + j] = -t42;
            const real t43 = cos_q[j] * t28[j] - t29[j] * t39 - (t30[j] * t40 + sin_q[j] * t31[j]);
            const real t44 = l0 * t43;
            Phi_x[12 * 8 + j] = t44;
            Phi_x[10 * 8 + j] = -t44;
            const real t45 = el_y[j] * t40 + sin_q[j] * t34[j] + (cos_q[j] * t35[j] - el_x[j] * t39);
            const real t46 = l0 * t45;
            Phi_x[13 * 8 + j] = t46;
            const real rp_aangle = a[2 * 8 + j];
            const real t64 = sin_p[j] * rp_aangle;
            const real t65 = cos_p[j] * rp_aangle;
            const real t68 = cos_p[j] * t63[j] - t18[j] * t64 - (t20[j] * t65 + sin_p[j] * t67[j]);
            const real t69 = t19 * t17[j];
            const real t70 = rp_vangle * t21;
            const real t76 = t21 * t23[j];
            const real t77 = rp_vangle * t19;
            const real t81 = t69 + t18[j] * t70 + (t69 + cos_p[j] * t75[j]) + (t76 - t20[j] * t77 + (t76 - sin_p[j] * t80[j]));
            const real t82 = l0 * t68 - l0 * t81;
            Psi_x[4 * 8 + j] = t82;
            const real t86 = cos_p[j] * t84[j] - t29[j] * t64 - (t30[j] * t65 + sin_p[j] * t85[j]);
            const real t87 = t19 * t28[j];
            const real t91 = t21 * t31[j];
            const real t94 = t87 + t29[j] * t70 + (t87 + cos_p[j] * t90[j]) + (t91 - t30[j] * t77 + (t91 - sin_p[j] * t93[j]));
            const real t95 = l0 * t86 - l0 * t94;
            Psi_x[5 * 8 + j] = t95;
            const real t96 = t21 * t34[j];
            const real t98 = t19 * t35[j];
            const real t100 = t96 - el_y[j] * t77 + (t96 - sin_p[j] * t97[j]) - (t98 + el_x[j] * t70 + (t98 + cos_p[j] * t99[j]));
            const real t103 = el_y[j] * t65 + sin_p[j] * t101[j] + (cos_p[j] * t102[j] - el_x[j] * t64);
            Psi_x[6 * 8 + j] = -(l0 * t100 + l0 * t103);
            Psi_x[7 * 8 + j] = -t82;
            Psi_x[8 * 8 + j] = -t95;
            const real t104 = t39 * t17[j];
            const real t105 = rq_vangle * t40;
            const real t106 = t40 * t23[j];
            const real t107 = rq_vangle * t39;
            const real t108 = t104 + t18[j] * t105 + (t104 + cos_q[j] * t75[j]) + (t106 - t20[j] * t107 + (t106 - sin_q[j] * t80[j]));
            const real rq_aangle = a[5 * 8 + j];
            const real t109 = sin_q[j] * rq_aangle;
            const real t110 = cos_q[j] * rq_aangle;
            const real t111 = cos_q[j] * t63[j] - t18[j] * t109 - (t20[j] * t110 + sin_q[j] * t67[j]);
            const real t112 = l0 * t108 - l0 * t111;
            Psi_x[9 * 8 + j] = t112;
            const real t113 = t39 * t28[j];
            const real t114 = t40 * t31[j];
            const real t115 = t113 + t29[j] * t105 + (t113 + cos_q[j] * t90[j]) + (t114 - t30[j] * t107 + (t114 - sin_q[j] * t93[j]));
            const real t116 = cos_q[j] * t84[j] - t29[j] * t109 - (t30[j] * t110 + sin_q[j] * t85[j]);
            const real t117 = l0 * t115 - l0 * t116;
            Psi_x[10 * 8 + j] = t117;
            Psi_x[11 * 8 + j] = -t112;
            Psi_x[12 * 8 + j] = -t117;
            const real t118 = t40 * t34[j];
            const real t119 = t39 * t35[j];
            const real t120 = t118 - el_y[j] * t107 + (t118 - sin_q[j] * t97[j]) - (t119 + el_x[j] * t105 + (t119 + cos_q[j] * t99[j]));
            const real t121 = el_y[j] * t110 + sin_q[j] * t101[j] + (cos_q[j] * t102[j] - el_x[j] * t109);
            Psi_x[13 * 8 + j] = l0 * t120 + l0 * t121;
            const real t122 = 2.0 * t25;
            Psi_v[4 * 8 + j] = t122;
            const real t123 = 2.0 * t33;
            Psi_v[5 * 8 + j] = t123;
            Psi_v[6 * 8 + j] = -(2.0 * t37);
            Psi_v[7 * 8 + j] = -t122;
            Psi_v[8 * 8 + j] = -t123;
            const real t124 = 2.0 * t42;
            Psi_v[11 * 8 + j] = t124;
            Psi_v[9 * 8 + j] = -t124;
            const real t125 = 2.0 * t44;
            Psi_v[12 * 8 + j] = t125;
            Psi_v[10 * 8 + j] = -t125;
            Psi_v[13 * 8 + j] = 2.0 * t46;
        }
    }
}

/* stiffness: 129 operations.
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
        real d_x[8], d_y[8], t0[8], t1[8], t2[8], t3[8], cos_p[8], t4[8], t6[8], cos_q[8], t7[8], sin_q[8], sin_p[8], t13[8], t21[8], t23[8], t24[8], t25[8], t27[8], t28[8], t33[8], t35[8], t37[8], t38[8], t40[8], t41[8], t45[8], t46[8];
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
            const real el_x = d_x[j] * t0[j];
            t1[j] = t0[j] * t0[j];
            t2[j] = el_x * t1[j];
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t3[j] = rp_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            const real sigma_bend1 = sigma[1 * 8 + j];
            t4[j] = l0 * sigma_bend1;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t6[j] = rq_angle + alphaq0;
            const real sigma_bend2 = sigma[2 * 8 + j];
            t7[j] = l0 * sigma_bend2;
            t13[j] = t0[j] * t2[j];
            const real t20 = d_x[j] * t2[j] - t0[j];
            t21[j] = t20 * t4[j];
            const real t22 = d_y[j] * t2[j];
            t23[j] = t22 * t4[j];
            t24[j] = t20 * t7[j];
            t25[j] = t22 * t7[j];
            const real el_y = d_y[j] * t0[j];
            t27[j] = el_y * t1[j];
            t28[j] = t0[j] * t27[j];
            const real t32 = d_x[j] * t27[j];
            t33[j] = t32 * t4[j];
            const real t34 = d_y[j] * t27[j] - t0[j];
            t35[j] = t34 * t4[j];
            t37[j] = t32 * t7[j];
            t38[j] = t34 * t7[j];
            t40[j] = el_y * t4[j];
            t41[j] = el_x * t4[j];
            t45[j] = el_y * t7[j];
            t46[j] = el_x * t7[j];
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t3[j]);
            cos_q[j] = real_cos(t6[j]);
            sin_q[j] = real_sin(t6[j]);
            sin_p[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t5 = cos_p[j] * t4[j];
            const real t8 = t5 - cos_q[j] * t7[j];
            const real t9 = sin_p[j] * t4[j];
            const real t10 = sin_q[j] * t7[j] - t9;
            const real t11 = d_y[j] * t8 + d_x[j] * t10;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t12 = sigma_elongation - t1[j] * t11;
            const real t14 = t2[j] * t12 - t0[j] * (2.0 * t13[j] * t11 - t1[j] * t10);
            const real t15 = t0[j] * t12;
            const real t16 = 0.5 * (d_x[j] * t14 - t15);
            const real t17 = t2[j] * t10 + t16 + t16;
            K[3 * 8 + j] = K[17 * 8 + j] = t17;
            K[0 * 8 + j] = K[20 * 8 + j] = -t17;
            const real t18 = 0.5 * d_y[j] * t14;
            const real t19 = t2[j] * t8 + t18 + t18;
            K[4 * 8 + j] = K[23 * 8 + j] = t19;
            K[1 * 8 + j] = K[6 * 8 + j] = K[21 * 8 + j] = K[26 * 8 + j] = -t19;
            K[2 * 8 + j] = K[12 * 8 + j] = -(cos_p[j] * t21[j] + sin_p[j] * t23[j]);
            const real t26 = cos_q[j] * t24[j] + sin_q[j] * t25[j];
            K[5 * 8 + j] = K[29 * 8 + j] = t26;
            const real t29 = t27[j] * t12 - t0[j] * (2.0 * t28[j] * t11 - t1[j] * t8);
            const real t30 = 0.5 * (d_y[j] * t29 - t15);
            const real t31 = t27[j] * t8 + t30 + t30;
            K[10 * 8 + j] = K[24 * 8 + j] = t31;
            K[7 * 8 + j] = K[27 * 8 + j] = -t31;
            K[8 * 8 + j] = K[13 * 8 + j] = -(cos_p[j] * t33[j] + sin_p[j] * t35[j]);
            const real t36 = 0.5 * d_x[j] * t29;
            K[9 * 8 + j] = K[18 * 8 + j] = t27[j] * t10 + t36 + t36;
            const real t39 = cos_q[j] * t37[j] + sin_q[j] * t38[j];
            K[11 * 8 + j] = K[30 * 8 + j] = t39;
            K[14 * 8 + j] = -(cos_p[j] * t40[j] - sin_p[j] * t41[j]);
            const real t42 = t1[j] * (d_y[j] * t9 + d_x[j] * t5) * t0[j];
            const real t43 = 0.5 * d_x[j] * t42;
            K[15 * 8 + j] = K[19 * 8 + j] = t43 - t0[j] * t5 + t43;
            const real t44 = 0.5 * d_y[j] * t42;
            K[16 * 8 + j] = K[25 * 8 + j] = t44 - t0[j] * t9 + t44;
            K[22 * 8 + j] = K[31 * 8 + j] = -t26;
            K[28 * 8 + j] = K[32 * 8 + j] = -t39;
            K[33 * 8 + j] = cos_q[j] * t45[j] - sin_q[j] * t46[j];
        }
    }
}

/* inertia: 389 operations.
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
        real t0[8], t1[8], t2[8], sin_p[8], t3[8], sin_q[8], t5[8], t6[8], cos_p[8], cos_q[8], t14[8], t15[8], t18[8], t28[8], t29[8], t33[8], t45[8], t46[8], t48[8], t58[8], t61[8], t70[8], t71[8], t75[8], t77[8], t78[8], t79[8], t80[8], t83[8], t86[8], t87[8], t98[8], t100[8], t102[8], t103[8], t106[8], t111[8], t112[8], t115[8], t117[8];
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
            t14[j] = (phi_z - 0.2) * t6[j];
            t15[j] = t5[j] * t14[j];
            t18[j] = 0.12857142857142856 * t0[j];
            const real t27 = phi_z * (0.16666666666666666 + 0.3333333333333333 * phi_z);
            t28[j] = 0.5 * (0.13333333333333333 + t27) * t6[j];
            t29[j] = l0 * l0;
            const real t32 = phi_z * (0.16666666666666666 * phi_z - 0.16666666666666666);
            t33[j] = 0.5 * (2.0 * t32 - 0.06666666666666667) * t6[j];
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t45[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t46[j] = q_vx - p_vx;
            const real rq_vangle = v[5 * 8 + j];
            const real rp_vangle = v[2 * 8 + j];
            t48[j] = 0.5 * rq_vangle * t14[j] + 0.5 * rp_vangle * t14[j];
            t58[j] = rq_vangle * t0[j];
            t61[j] = rp_vangle * t0[j];
            t70[j] = q_vx * l0;
            t71[j] = p_vx * l0;
            const real t74 = rp_vangle * rp_vangle;
            t75[j] = t29[j] * t74 * t0[j];
            t77[j] = rp_vangle * t29[j];
            t78[j] = rq_vangle * t77[j];
            t79[j] = 0.030952380952380953 * (rp_vangle * t70[j] * t0[j]);
            t80[j] = 0.05238095238095238 * (rp_vangle * t71[j] * t0[j]);
            t83[j] = t74 * t0[j] * t29[j];
            const real t85 = 0.030952380952380953 * (q_vy * t61[j]) + 0.05238095238095238 * (p_vy * t61[j]);
            t86[j] = l0 * t85;
            t87[j] = rp_vangle * t58[j] * t29[j];
            const real t97 = rq_vangle * rq_vangle;
            t98[j] = t29[j] * t97 * t0[j];
            t100[j] = 0.05238095238095238 * (rq_vangle * t70[j] * t0[j]);
            t102[j] = 0.030952380952380953 * (rq_vangle * t71[j] * t0[j]);
            t103[j] = t97 * t0[j] * t29[j];
            const real t105 = 0.05238095238095238 * (q_vy * t58[j]) + 0.030952380952380953 * (p_vy * t58[j]);
            t106[j] = l0 * t105;
            const real gravity_x = p[6 * 8 + j];
            const real t109 = gravity_x * t0[j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * t109;
            const real gravity_y = p[7 * 8 + j];
            const real t110 = gravity_y * t0[j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * t110;
            t111[j] = l0 * t109;
            t112[j] = l0 * t110;
            const real p_x = x[0 * 8 + j];
            const real q_x = x[3 * 8 + j];
            t115[j] = 0.5 * p_x + 0.5 * q_x;
            const real p_y = x[1 * 8 + j];
            const real q_y = x[4 * 8 + j];
            t117[j] = 0.5 * p_y + 0.5 * q_y;
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
            const real t7 = t5[j] * t4;
            const real t8 = t6[j] * t7 * t5[j];
            const real t9 = 0.3 * (t4 * t8);
            M[0 * 8 + j] = M[21 * 8 + j] = t1[j] + t9;
            const real t10 = cos_p[j] + cos_q[j];
            const real t11 = t5[j] * t10;
            const real t12 = t6[j] * t11 * t5[j];
            const real t13 = 0.3 * (t4 * t12);
            M[4 * 8 + j] = M[24 * 8 + j] = t13;
            M[1 * 8 + j] = M[6 * 8 + j] = M[22 * 8 + j] = M[27 * 8 + j] = -t13;
            const real t16 = 0.25 * t4 * t15[j];
            const real l0 = p[0 * 8 + j];
            const real t17 = sin_p[j] * t0[j] * l0;
            M[2 * 8 + j] = M[12 * 8 + j] = t16 - 0.05238095238095238 * t17;
            M[3 * 8 + j] = M[18 * 8 + j] = t18[j] - t9;
            const real t19 = sin_q[j] * t0[j];
            const real t20 = l0 * t19;
            M[5 * 8 + j] = M[30 * 8 + j] = t16 + 0.030952380952380953 * t20;
            const real t21 = 0.3 * (t10 * t12);
            M[7 * 8 + j] = M[28 * 8 + j] = t1[j] + t21;
            const real t22 = l0 * cos_p[j];
            const real t23 = t22 * t0[j];
            const real t24 = 0.25 * t10 * t15[j];
            M[8 * 8 + j] = M[13 * 8 + j] = 0.05238095238095238 * t23 - t24;
            M[9 * 8 + j] = M[19 * 8 + j] = 0.3 * (t10 * t8);
            M[10 * 8 + j] = M[25 * 8 + j] = t18[j] - t21;
            const real t25 = l0 * cos_q[j];
            const real t26 = t25 * t0[j];
            M[11 * 8 + j] = M[31 * 8 + j] = -(t24 + 0.030952380952380953 * t26);
            const real t30 = 0.004761904761904762 * (sin_p[j] * sin_p[j] * t0[j] * t29[j]);
            const real t31 = 0.004761904761904762 * (cos_p[j] * cos_p[j] * t29[j] * t0[j]);
            M[14 * 8 + j] = 2.0 * (t28[j] + t30 + t31);
            M[15 * 8 + j] = M[20 * 8 + j] = -(0.25 * t14[j] * t7 + 0.030952380952380953 * t17);
            M[16 * 8 + j] = M[26 * 8 + j] = 0.25 * t14[j] * t11 + 0.030952380952380953 * t23;
            const real t34 = t33[j] - 0.007142857142857143 * (sin_p[j] * t19 * t29[j]);
            const real t35 = 0.007142857142857143 * (cos_p[j] * cos_q[j] * t29[j] * t0[j]);
            M[17 * 8 + j] = M[32 * 8 + j] = t34 - t35;
            M[23 * 8 + j] = M[33 * 8 + j] = 0.05238095238095238 * t20 - t16;
            M[29 * 8 + j] = M[34 * 8 + j] = t24 - 0.05238095238095238 * t26;
            const real t36 = 0.004761904761904762 * (sin_q[j] * sin_q[j] * t0[j] * t29[j]);
            const real t37 = 0.004761904761904762 * (cos_q[j] * cos_q[j] * t29[j] * t0[j]);
            M[35 * 8 + j] = 2.0 * (t28[j] + t36 + t37);
            const real rq_vangle = v[5 * 8 + j];
            const real t38 = rq_vangle * cos_q[j];
            const real t39 = t0[j] * t38;
            const real t40 = rq_vangle * t39;
            const real rp_vangle = v[2 * 8 + j];
            const real t41 = rp_vangle * cos_p[j];
            const real t42 = t0[j] * t41;
            const real t43 = rp_vangle * t42;
            const real t44 = l0 * (0.030952380952380953 * t40 - 0.05238095238095238 * t43);
            const real chord = t5[j] * (0.5 * t10 * t45[j] - 0.5 * t46[j] * t4);
            const real t47 = 0.6 * (chord * t6[j]);
            const real t49 = t5[j] * (t48[j] + t47 + t47);
            const real t50 = t41 + t38;
            const real t51 = rp_vangle * sin_p[j];
            const real t52 = rq_vangle * sin_q[j];
            const real t53 = t51 + t52;
            const real t54 = t5[j] * (0.5 * t45[j] * t53 + 0.5 * t46[j] * t50);
            const real t55 = t6[j] * t54 * t5[j];
            const real t56 = 0.5 * (t49 * t50 - 1.2 * (t4 * t55));
            h[0 * 8 + j] = t44 + t56;
            const real t57 = l0 * t52;
            const real t59 = t57 * t58[j];
            const real t60 = l0 * t51;
            const real t62 = t60 * t61[j];
            const real t63 = 0.5 * (t49 * t53 + 1.2 * (t10 * t55));
            h[1 * 8 + j] = 0.030952380952380953 * t59 - 0.05238095238095238 * t62 + t63;
            const real t64 = 0.009523809523809525 * (sin_p[j] * t41 * t0[j] * t29[j]) - 0.009523809523809525 * (cos_p[j] * t51 * t29[j] * t0[j]);
            const real t65 = rp_vangle * t64;
            const real t66 = t29[j] * (cos_q[j] * t51 + cos_p[j] * t52);
            const real t67 = 0.5 * t14[j] * t54;
            const real t68 = t41 * t19 + sin_p[j] * t39;
            const real t69 = 0.007142857142857143 * (t58[j] * t66) - (t67 + 0.007142857142857143 * (rq_vangle * t68 * t29[j]));
            const real t72 = t69 - 0.030952380952380953 * (t70[j] * t42) - 0.05238095238095238 * (t71[j] * t42);
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t73 = t72 - 0.030952380952380953 * (q_vy * t60 * t0[j]) - 0.05238095238095238 * (p_vy * t60 * t0[j]);
            const real t76 = 0.004761904761904762 * (sin_p[j] * t75[j]);
            const real t81 = t76 - (0.007142857142857143 * (t78[j] * t19) + t79[j] + t80[j]);
            const real t82 = 0.5 * t46[j] * t49;
            const real t84 = 0.004761904761904762 * (cos_p[j] * t83[j]);
            const real t88 = t86[j] - 0.007142857142857143 * (cos_q[j] * t87[j]) + t84;
            const real t89 = 0.5 * t45[j] * t49;
            const real t90 = cos_p[j] * (t76 + t81 - t82) - sin_p[j] * (t84 + t88 + t89);
            h[2 * 8 + j] = t73 + t65 + t65 - t90;
            const real t91 = l0 * (0.05238095238095238 * t40 - 0.030952380952380953 * t43);
            h[3 * 8 + j] = t91 - t56;
            h[4 * 8 + j] = 0.05238095238095238 * t59 - 0.030952380952380953 * t62 - t63;
            const real t92 = 0.009523809523809525 * (sin_q[j] * t38 * t0[j] * t29[j]) - 0.009523809523809525 * (cos_q[j] * t52 * t29[j] * t0[j]);
            const real t93 = rq_vangle * t92;
            const real t94 = 0.007142857142857143 * (rp_vangle * t66 * t0[j]) - (t67 + 0.007142857142857143 * (t77[j] * t68));
            const real t95 = t94 + 0.05238095238095238 * (t70[j] * t39) + 0.030952380952380953 * (t71[j] * t39);
            const real t96 = t95 + 0.05238095238095238 * (q_vy * t57 * t0[j]) + 0.030952380952380953 * (p_vy * t57 * t0[j]);
            const real t99 = 0.004761904761904762 * (sin_q[j] * t98[j]);
            const real t101 = t100[j] - 0.007142857142857143 * (sin_p[j] * t78[j] * t0[j]);
            const real t104 = 0.004761904761904762 * (cos_q[j] * t103[j]);
            const real t107 = t104 - (0.007142857142857143 * (cos_p[j] * t87[j]) + t106[j]);
            const real t108 = cos_q[j] * (t101 + t102[j] + t99 + t99 - t82) - sin_q[j] * (t104 + t107 + t89);
            h[5 * 8 + j] = t96 + t93 + t93 - t108;
            const real t113 = 0.08333333333333333 * (sin_p[j] * t111[j]) - 0.08333333333333333 * (cos_p[j] * t112[j]);
            f[2 * 8 + j] = -t113;
            const real t114 = 0.08333333333333333 * (cos_q[j] * t112[j]) - 0.08333333333333333 * (sin_q[j] * t111[j]);
            f[5 * 8 + j] = -t114;
            const real t116 = 0.08333333333333333 * t22 + t115[j] - 0.08333333333333333 * t25;
            const real gravity_x = p[6 * 8 + j];
            const real t118 = 0.08333333333333333 * (l0 * sin_p[j]) + t117[j] - 0.08333333333333333 * (l0 * sin_q[j]);
            const real gravity_y = p[7 * 8 + j];
            U[0 * 8 + j] = -((gravity_x * t116 + gravity_y * t118) * t0[j]);
        }
    }
}

/* tangent: 878 operations.
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
        real t0[8], cos_p[8], t1[8], t2[8], t3[8], cos_q[8], t5[8], t6[8], sin_p[8], sin_q[8], t10[8], t15[8], t18[8], t19[8], t27[8], t31[8], t48[8], t50[8], t53[8], t55[8], t59[8], t60[8], t62[8], t77[8], t78[8], t80[8], t81[8], t86[8], t90[8], t91[8], t92[8], t93[8], t96[8], t99[8], t100[8], t118[8], t134[8], t137[8], t139[8], t140[8], t143[8], t156[8], t177[8], t183[8], t192[8], t194[8], t196[8], t198[8], t200[8], t201[8], t202[8], t207[8], t208[8], t212[8], t214[8], t224[8], t228[8], t233[8], t234[8], t241[8], t243[8], t245[8], t247[8];
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
            t19[j] = 0.5 * rq_aangle * t18[j] + 0.5 * rp_aangle * t18[j];
            const real rq_vangle = v[5 * 8 + j];
            const real rp_vangle = v[2 * 8 + j];
            t27[j] = 0.5 * rq_vangle * t18[j] + 0.5 * rp_vangle * t18[j];
            const real rhoA = p[3 * 8 + j];
            t31[j] = l0 * rhoA;
            t48[j] = rp_vangle * t31[j];
            t50[j] = t31[j] * rp_aangle;
            t53[j] = rq_vangle * t31[j];
            t55[j] = t31[j] * rq_aangle;
            const real gravity_y = p[7 * 8 + j];
            t59[j] = gravity_y * t31[j] * l0;
            const real gravity_x = p[6 * 8 + j];
            t60[j] = gravity_x * t31[j] * l0;
            t62[j] = l0 * l0;
            t77[j] = l0 * q_ax;
            t78[j] = q_vx * l0;
            t80[j] = l0 * p_ax;
            t81[j] = p_vx * l0;
            const real t85 = rp_vangle * rp_vangle;
            t86[j] = t62[j] * t85 * t31[j];
            t90[j] = rp_vangle * t62[j];
            t91[j] = rq_vangle * t90[j];
            t92[j] = 0.030952380952380953 * (rp_vangle * t78[j] * t31[j]);
            t93[j] = 0.05238095238095238 * (rp_vangle * t81[j] * t31[j]);
            t96[j] = t85 * t31[j] * t62[j];
            const real t98 = 0.030952380952380953 * (q_vy * t48[j]) + 0.05238095238095238 * (p_vy * t48[j]);
            t99[j] = l0 * t98;
            t100[j] = rp_vangle * t53[j] * t62[j];
            t118[j] = t62[j] * rp_aangle;
            const real t133 = rq_vangle * rq_vangle;
            t134[j] = t62[j] * t133 * t31[j];
            t137[j] = 0.05238095238095238 * (rq_vangle * t78[j] * t31[j]);
            t139[j] = 0.030952380952380953 * (rq_vangle * t81[j] * t31[j]);
            t140[j] = t133 * t31[j] * t62[j];
            const real t142 = 0.05238095238095238 * (q_vy * t53[j]) + 0.030952380952380953 * (p_vy * t53[j]);
            t143[j] = l0 * t142;
            t156[j] = t1[j] * t18[j];
            const real t176 = rp_vangle * l0 * t31[j];
            t177[j] = 0.05238095238095238 * t176;
            const real t182 = l0 * t48[j];
            t183[j] = 0.05238095238095238 * t182;
            t192[j] = t90[j] * t31[j];
            t194[j] = rq_vangle * t62[j];
            const real t195 = t78[j] * t31[j];
            t196[j] = 0.030952380952380953 * t195;
            const real t197 = t81[j] * t31[j];
            t198[j] = 0.05238095238095238 * t197;
            t200[j] = 0.25 * t10[j] * t156[j];
            t201[j] = 0.25 * t6[j] * t156[j];
            t202[j] = t62[j] * t48[j];
            const real t205 = q_vy * t31[j];
            const real t206 = p_vy * t31[j];
            t207[j] = l0 * (0.030952380952380953 * t205 + 0.05238095238095238 * t206);
            t208[j] = t62[j] * t53[j];
            t212[j] = 0.030952380952380953 * t176;
            t214[j] = 0.030952380952380953 * t182;
            const real t223 = rq_vangle * l0 * t31[j];
            t224[j] = 0.030952380952380953 * t223;
            const real t227 = l0 * t53[j];
            t228[j] = 0.030952380952380953 * t227;
            t233[j] = 0.05238095238095238 * t223;
            t234[j] = 0.05238095238095238 * t227;
            t241[j] = t31[j] * t194[j];
            t243[j] = 0.05238095238095238 * t195;
            t245[j] = 0.030952380952380953 * t197;
            t247[j] = l0 * (0.05238095238095238 * t205 + 0.030952380952380953 * t206);
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
            const real t16 = 0.5 * (t4 * t5[j] - t6[j] * t9) - 0.5 * (t10[j] * t13 + t14 * t15[j]);
            const real t17 = 0.6 * (t1[j] * t16 * t2[j]);
            const real t20 = t1[j] * (t19[j] + t17 + t17);
            const real t21 = 0.5 * (t6[j] * t11 + sin_p[j] * t5[j]) + 0.5 * (cos_p[j] * t15[j] - t10[j] * t7);
            const real t22 = t1[j] * t21;
            const real t23 = t2[j] * t22 * t1[j];
            const real t24 = t1[j] * (0.5 * sin_p[j] * t6[j] + 0.5 * cos_p[j] * t10[j]);
            const real t25 = t2[j] * t24 * t1[j];
            const real chord = t1[j] * (0.5 * t4 * t6[j] - 0.5 * t10[j] * t14);
            const real t26 = 0.6 * (chord * t2[j]);
            const real t28 = t1[j] * (t27[j] + t26 + t26);
            const real t29 = cos_p[j] * t20 - 1.2 * (t14 * t23) - (1.2 * (t13 * t25) + t7 * t28);
            const real t30 = 0.5 * t29;
            const real t32 = cos_p[j] * t31[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t33 = t31[j] * t7;
            const real l0 = p[0 * 8 + j];
            const real t34 = l0 * (rp_aangle * t32 - rp_vangle * t33);
            R_x[0 * 8 + j] = t30 - 0.05238095238095238 * t34;
            const real t35 = cos_q[j] * t31[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t36 = t31[j] * t8;
            const real t37 = l0 * (rq_aangle * t35 - rq_vangle * t36);
            const real t38 = 0.5 * (t6[j] * t12 + sin_q[j] * t5[j]) + 0.5 * (cos_q[j] * t15[j] - t10[j] * t8);
            const real t39 = t1[j] * t38;
            const real t40 = t2[j] * t39 * t1[j];
            const real t41 = t1[j] * (0.5 * sin_q[j] * t6[j] + 0.5 * cos_q[j] * t10[j]);
            const real t42 = t2[j] * t41 * t1[j];
            const real t43 = cos_q[j] * t20 - 1.2 * (t14 * t40) - (1.2 * (t13 * t42) + t8 * t28);
            const real t44 = 0.5 * t43;
            R_x[1 * 8 + j] = 0.030952380952380953 * t37 + t44;
            const real t45 = t11 * t28 - 1.2 * (t9 * t25) + (sin_p[j] * t20 + 1.2 * (t4 * t23));
            const real t46 = 0.5 * t45;
            const real t47 = l0 * t11;
            const real t49 = l0 * sin_p[j];
            const real t51 = t47 * t48[j] + t49 * t50[j];
            R_x[2 * 8 + j] = t46 - 0.05238095238095238 * t51;
            const real t52 = l0 * t12;
            const real t54 = l0 * sin_q[j];
            const real t56 = t52 * t53[j] + t54 * t55[j];
            const real t57 = t12 * t28 - 1.2 * (t9 * t42) + (sin_q[j] * t20 + 1.2 * (t4 * t40));
            const real t58 = 0.5 * t57;
            R_x[3 * 8 + j] = 0.030952380952380953 * t56 + t58;
            const real t61 = 0.08333333333333333 * (sin_p[j] * t59[j]) + 0.08333333333333333 * (cos_p[j] * t60[j]);
            const real t63 = cos_p[j] * t11 - sin_p[j] * t7;
            const real t64 = 0.009523809523809525 * (t31[j] * t63 * t62[j]) - 0.009523809523809525 * (t62[j] * t63 * t31[j]);
            const real t65 = cos_p[j] * sin_p[j];
            const real t66 = 0.009523809523809525 * (t31[j] * t65 * t62[j]) - 0.009523809523809525 * (t62[j] * t65 * t31[j]);
            const real t67 = rp_vangle * t64 + rp_aangle * t66;
            const real t68 = t62[j] * (cos_q[j] * t11 - sin_p[j] * t8);
            const real t69 = sin_p[j] * cos_q[j] * t62[j];
            const real t70 = 0.5 * t18[j] * t22;
            const real t71 = t31[j] * t12;
            const real t72 = sin_q[j] * t31[j];
            const real t73 = cos_p[j] * t71 - t7 * t72;
            const real t74 = cos_p[j] * t72;
            const real t75 = 0.007142857142857143 * (t62[j] * (rq_vangle * t73 + rq_aangle * t74));
            const real t76 = 0.007142857142857143 * (t53[j] * t68 + t55[j] * t69) - (t70 + t75);
            const real t79 = t76 - 0.030952380952380953 * (t77[j] * t32 - t78[j] * t33);
            const real t82 = t79 - 0.05238095238095238 * (t80[j] * t32 - t81[j] * t33);
            const real q_vy = v[4 * 8 + j];
            const real q_ay = a[4 * 8 + j];
            const real t83 = 0.030952380952380953 * (t31[j] * (q_vy * t47 + t49 * q_ay));
            const real p_vy = v[1 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t84 = 0.05238095238095238 * (t31[j] * (p_vy * t47 + t49 * p_ay));
            const real t87 = 0.6 * (t10[j] * t25);
            const real t88 = cos_p[j] * (0.009523809523809525 * (cos_p[j] * t86[j]) + t87);
            const real t89 = 0.004761904761904762 * (sin_p[j] * t86[j]);
            const real t94 = t89 - (0.007142857142857143 * (t91[j] * t72) + t92[j] + t93[j]);
            const real t95 = 0.5 * t10[j] * t28;
            const real t97 = 0.004761904761904762 * (cos_p[j] * t96[j]);
            const real t101 = t99[j] - 0.007142857142857143 * (cos_q[j] * t100[j]) + t97;
            const real t102 = 0.5 * t6[j] * t28;
            const real t103 = 0.6 * (t6[j] * t25);
            const real t104 = sin_p[j] * (0.009523809523809525 * (sin_p[j] * t96[j]) + t103);
            const real t105 = t88 - sin_p[j] * (t89 + t94 - t95) - (cos_p[j] * (t97 + t101 + t102) - t104);
            R_x[4 * 8 + j] = t82 - t83 - t84 + t67 + t67 - t105 + t61;
            const real t106 = t62[j] * (cos_p[j] * t12 - sin_q[j] * t7);
            const real t107 = cos_p[j] * sin_q[j] * t62[j];
            const real t108 = 0.5 * t18[j] * t39;
            const real t109 = t11 * t35 - sin_p[j] * t36;
            const real t110 = sin_p[j] * t35;
            const real t111 = 0.007142857142857143 * (t62[j] * (rq_vangle * t109 + rq_aangle * t110));
            const real t112 = 0.007142857142857143 * (t53[j] * t106 + t55[j] * t107) - (t108 + t111);
            const real t113 = 0.6 * (t10[j] * t42);
            const real t114 = cos_p[j] * (t113 - 0.007142857142857143 * (t91[j] * t35));
            const real t115 = 0.6 * (t6[j] * t42);
            const real t116 = sin_p[j] * (0.007142857142857143 * (sin_q[j] * t100[j]) - t115);
            R_x[5 * 8 + j] = t112 - (t114 - t116);
            R_x[6 * 8 + j] = -(0.030952380952380953 * t34 + t30);
            R_x[7 * 8 + j] = 0.05238095238095238 * t37 - t44;
            R_x[8 * 8 + j] = -(0.030952380952380953 * t51 + t46);
            R_x[9 * 8 + j] = 0.05238095238095238 * t56 - t58;
            const real t117 = 0.007142857142857143 * (t31[j] * (rp_vangle * t68 + rp_aangle * t69));
            const real t119 = t70 + 0.007142857142857143 * (t90[j] * t73 + t118[j] * t74);
            const real t120 = t87 - 0.007142857142857143 * (cos_p[j] * t91[j] * t31[j]);
            const real t121 = sin_q[j] * (0.007142857142857143 * (sin_p[j] * t100[j]) - t103);
            R_x[10 * 8 + j] = t117 - t119 - (cos_q[j] * t120 - t121);
            const real t122 = cos_q[j] * t12 - sin_q[j] * t8;
            const real t123 = 0.009523809523809525 * (t31[j] * t122 * t62[j]) - 0.009523809523809525 * (t62[j] * t122 * t31[j]);
            const real t124 = cos_q[j] * sin_q[j];
            const real t125 = 0.009523809523809525 * (t31[j] * t124 * t62[j]) - 0.009523809523809525 * (t62[j] * t124 * t31[j]);
            const real t126 = rq_vangle * t123 + rq_aangle * t125;
            const real t127 = 0.007142857142857143 * (t31[j] * (rp_vangle * t106 + rp_aangle * t107));
            const real t128 = t108 + 0.007142857142857143 * (t90[j] * t109 + t118[j] * t110);
            const real t129 = t127 - t128 + 0.05238095238095238 * (t77[j] * t35 - t78[j] * t36);
            const real t130 = t129 + 0.030952380952380953 * (t80[j] * t35 - t81[j] * t36);
            const real t131 = 0.05238095238095238 * (t31[j] * (q_vy * t52 + t54 * q_ay));
            const real t132 = 0.030952380952380953 * (t31[j] * (p_vy * t52 + t54 * p_ay));
            const real t135 = cos_q[j] * (0.009523809523809525 * (cos_q[j] * t134[j]) + t113);
            const real t136 = 0.004761904761904762 * (sin_q[j] * t134[j]);
            const real t138 = t137[j] - 0.007142857142857143 * (sin_p[j] * t91[j] * t31[j]);
            const real t141 = 0.004761904761904762 * (cos_q[j] * t140[j]);
            const real t144 = t141 - (0.007142857142857143 * (cos_p[j] * t100[j]) + t143[j]);
            const real t145 = sin_q[j] * (0.009523809523809525 * (sin_q[j] * t140[j]) + t115);
            const real t146 = t135 - sin_q[j] * (t138 + t139[j] + t136 + t136 - t95) - (cos_q[j] * (t141 + t144 + t102) - t145);
            const real t147 = 0.08333333333333333 * (sin_q[j] * t59[j]) + 0.08333333333333333 * (cos_q[j] * t60[j]);
            R_x[11 * 8 + j] = t130 + t131 + t132 + t126 + t126 - t146 - t147;
            const real t148 = t1[j] * t14 * t2[j] * t1[j];
            const real t149 = t1[j] * t13;
            const real t150 = t2[j] * t149 * t1[j];
            const real t151 = 0.5 * (0.6 * (t148 * t13) + 0.6 * (t14 * t150));
            R_v[0 * 8 + j] = R_v[21 * 8 + j] = t151;
            const real t152 = t1[j] * t9;
            const real t153 = t2[j] * t152 * t1[j];
            const real t154 = t1[j] * t4 * t2[j] * t1[j];
            const real t155 = 0.5 * (0.6 * (t14 * t153) - 0.6 * (t154 * t13));
            R_v[1 * 8 + j] = R_v[22 * 8 + j] = t155;
            const real t157 = 0.5 * t156[j] * t13;
            const real t158 = 0.5 * (cos_p[j] * t28 + t157 - 1.2 * (t14 * t25));
            const real t159 = t31[j] * t11;
            const real t160 = l0 * (t159 + rp_vangle * t32);
            R_v[2 * 8 + j] = t158 - 0.05238095238095238 * t160;
            R_v[3 * 8 + j] = R_v[18 * 8 + j] = -t151;
            R_v[4 * 8 + j] = R_v[19 * 8 + j] = -t155;
            const real t161 = l0 * (t71 + rq_vangle * t35);
            const real t162 = 0.5 * (cos_q[j] * t28 + t157 - 1.2 * (t14 * t42));
            R_v[5 * 8 + j] = 0.030952380952380953 * t161 + t162;
            const real t163 = 0.5 * (0.6 * (t4 * t150) - 0.6 * (t148 * t9));
            R_v[9 * 8 + j] = R_v[24 * 8 + j] = t163;
            R_v[6 * 8 + j] = R_v[27 * 8 + j] = -t163;
            const real t164 = 0.5 * (0.6 * (t154 * t9) + 0.6 * (t4 * t153));
            R_v[10 * 8 + j] = R_v[25 * 8 + j] = t164;
            R_v[7 * 8 + j] = R_v[28 * 8 + j] = -t164;
            const real t165 = 0.5 * t156[j] * t9;
            const real t166 = 0.5 * (sin_p[j] * t28 + t165 + 1.2 * (t4 * t25));
            const real t167 = l0 * t7 * t31[j];
            const real t168 = t167 + t49 * t48[j];
            R_v[8 * 8 + j] = t166 - 0.05238095238095238 * t168;
            const real t169 = l0 * t8 * t31[j];
            const real t170 = t169 + t54 * t53[j];
            const real t171 = 0.5 * (sin_q[j] * t28 + t165 + 1.2 * (t4 * t42));
            R_v[11 * 8 + j] = 0.030952380952380953 * t170 + t171;
            const real t172 = 0.25 * t18[j] * t149;
            const real t173 = l0 * t159;
            const real t174 = t6[j] * t148;
            const real t175 = 0.3 * (sin_p[j] * t174);
            const real t178 = 0.5 * (0.6 * (t10[j] * t148) - t28);
            R_v[12 * 8 + j] = t172 - 0.05238095238095238 * t173 + (t175 + cos_p[j] * (t177[j] + t178));
            const real t179 = 0.25 * t18[j] * t152;
            const real t180 = t10[j] * t154;
            const real t181 = 0.3 * (cos_p[j] * t180);
            const real t184 = 0.5 * (t28 + 0.6 * (t6[j] * t154));
            R_v[13 * 8 + j] = t179 - 0.05238095238095238 * t167 - (t181 - sin_p[j] * (t183[j] - t184));
            const real t185 = 0.009523809523809525 * (sin_p[j] * t11 * t31[j] * t62[j]);
            const real t186 = t185 - 0.009523809523809525 * (cos_p[j] * t7 * t62[j] * t31[j]);
            const real t187 = t186 + rp_vangle * t66;
            const real t188 = 0.5 * t18[j] * t24;
            const real t189 = 0.007142857142857143 * (t53[j] * t69) - (t188 + 0.007142857142857143 * (rq_vangle * t74 * t62[j]));
            const real t190 = t189 - 0.030952380952380953 * (t78[j] * t32) - 0.05238095238095238 * (t81[j] * t32);
            const real t191 = t190 - 0.030952380952380953 * (q_vy * t49 * t31[j]) - 0.05238095238095238 * (p_vy * t49 * t31[j]);
            const real t193 = 0.009523809523809525 * (sin_p[j] * t192[j]);
            const real t199 = 0.007142857142857143 * (t72 * t194[j]) + t196[j] + t198[j];
            const real t203 = cos_p[j] * t202[j];
            const real t204 = 0.009523809523809525 * t203;
            const real t209 = cos_q[j] * t208[j];
            const real t210 = t207[j] - 0.007142857142857143 * t209 + t204 + t204 + t201[j];
            const real t211 = cos_p[j] * (t193 - t199 + t193 - t200[j]) - sin_p[j] * t210;
            R_v[14 * 8 + j] = t187 + t191 + t187 - t211;
            const real t213 = t172 + 0.030952380952380953 * t173 + (t175 + cos_p[j] * (t178 - t212[j]));
            R_v[15 * 8 + j] = -t213;
            R_v[16 * 8 + j] = t181 + sin_p[j] * (t214[j] + t184) - (t179 + 0.030952380952380953 * t167);
            const real t215 = t62[j] * (cos_q[j] * t7 + cos_p[j] * t8);
            const real t216 = 0.5 * t18[j] * t41;
            const real t217 = t11 * t72 + sin_p[j] * t71;
            const real t218 = 0.007142857142857143 * (t62[j] * (t217 + rq_vangle * t110));
            const real t219 = 0.007142857142857143 * (t31[j] * t215 + t53[j] * t107) - (t216 + t218);
            const real t220 = sin_p[j] * (0.007142857142857143 * (cos_q[j] * t202[j]) - t201[j]);
            const real t221 = cos_p[j] * (t200[j] + 0.007142857142857143 * (t90[j] * t72));
            R_v[17 * 8 + j] = t219 - (t220 - t221);
            R_v[20 * 8 + j] = -(0.030952380952380953 * t160 + t158);
            R_v[23 * 8 + j] = 0.05238095238095238 * t161 - t162;
            R_v[26 * 8 + j] = -(0.030952380952380953 * t168 + t166);
            R_v[29 * 8 + j] = 0.05238095238095238 * t170 - t171;
            const real t222 = l0 * t71;
            const real t225 = 0.3 * (sin_q[j] * t174);
            R_v[30 * 8 + j] = 0.030952380952380953 * t222 + t172 - (cos_q[j] * (t224[j] - t178) - t225);
            const real t226 = 0.3 * (cos_q[j] * t180);
            R_v[31 * 8 + j] = 0.030952380952380953 * t169 + t179 - (t226 + sin_q[j] * (t228[j] + t184));
            const real t229 = 0.007142857142857143 * (t31[j] * (t215 + rp_vangle * t69));
            const real t230 = t188 + 0.007142857142857143 * (t62[j] * t217 + t90[j] * t74);
            const real t231 = sin_q[j] * (0.007142857142857143 * (cos_p[j] * t208[j]) - t201[j]);
            const real t232 = 0.007142857142857143 * (sin_p[j] * t194[j] * t31[j]) + t200[j];
            R_v[32 * 8 + j] = t229 - t230 - (t231 - cos_q[j] * t232);
            R_v[33 * 8 + j] = 0.05238095238095238 * t222 - t172 - (t225 + cos_q[j] * (t233[j] + t178));
            R_v[34 * 8 + j] = 0.05238095238095238 * t169 - t179 + (t226 + sin_q[j] * (t184 - t234[j]));
            const real t235 = 0.009523809523809525 * (sin_q[j] * t12 * t31[j] * t62[j]);
            const real t236 = t235 - 0.009523809523809525 * (cos_q[j] * t8 * t62[j] * t31[j]);
            const real t237 = t236 + rq_vangle * t125;
            const real t238 = 0.007142857142857143 * (rp_vangle * t107 * t31[j]) - (t216 + 0.007142857142857143 * (t90[j] * t110));
            const real t239 = 0.05238095238095238 * (t78[j] * t35) + t238 + 0.030952380952380953 * (t81[j] * t35);
            const real t240 = t239 + 0.05238095238095238 * (q_vy * t54 * t31[j]) + 0.030952380952380953 * (p_vy * t54 * t31[j]);
            const real t242 = 0.009523809523809525 * (sin_q[j] * t241[j]);
            const real t244 = t243[j] - 0.007142857142857143 * (sin_p[j] * t90[j] * t31[j]);
            const real t246 = 0.009523809523809525 * t209;
            const real t248 = t246 - (0.007142857142857143 * t203 + t247[j]) + t246 + t201[j];
            const real t249 = cos_q[j] * (t244 + t245[j] + t242 + t242 - t200[j]) - sin_q[j] * t248;
            R_v[35 * 8 + j] = t237 + t240 + t237 - t249;
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
