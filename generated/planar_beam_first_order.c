/* planar_beam_first_order: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
 * d = xq - xp, l = |d|, el = d/l;  b1 = l - l0,  b5 = l0 ey_p.el,  b6 = -l0 ey_q.el
 * elongation = b1,  bend1 = b5,  bend2 = b6
 * T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
 *    the shear-corrected (phi_z) cubic shapes
 * U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), PLBEAM, PLBEAMNL; signs of the spatial beam's b5, b6; Meijaard
 *   1996, Nonlinear Dyn. 9
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
            De[3 * 8 + j] = el_y[j]; /* De(0,4) */
            el_x[j] = d_x * t1;
            De[2 * 8 + j] = el_x[j]; /* De(0,3) */
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t2[j] = rq_angle + alphaq0;
            De[0 * 8 + j] = -el_x[j]; /* De(0,0) */
            De[1 * 8 + j] = -el_y[j]; /* De(0,1) */
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
            De[4 * 8 + j] = t7; /* De(1,0) */
            const real t11 = l0 * (cos_p[j] * t9[j] - sin_p[j] * t10[j]);
            De[5 * 8 + j] = t11; /* De(1,1) */
            De[6 * 8 + j] = -(l0 * (sin_p[j] * el_y[j] + cos_p[j] * el_x[j])); /* De(1,2) */
            De[7 * 8 + j] = -t7; /* De(1,3) */
            De[8 * 8 + j] = -t11; /* De(1,4) */
            const real t12 = l0 * (cos_q[j] * t5[j] - sin_q[j] * t6[j]);
            De[11 * 8 + j] = t12; /* De(2,3) */
            De[9 * 8 + j] = -t12; /* De(2,0) */
            const real t13 = l0 * (cos_q[j] * t9[j] - sin_q[j] * t10[j]);
            De[12 * 8 + j] = t13; /* De(2,4) */
            De[10 * 8 + j] = -t13; /* De(2,1) */
            De[13 * 8 + j] = l0 * (sin_q[j] * el_y[j] + cos_q[j] * el_x[j]); /* De(2,5) */
        }
    }
}

/* acceleration: 84 operations.
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
        real el_y[8], t8[8], cos_p[8], el_x[8], sin_p[8], t12[8], t13[8], t14[8], t15[8], t17[8], cos_q[8], sin_q[8];
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
            const real t3 = d_x * t1 + d_y * t2;
            const real t4 = t0 * t0;
            const real t5 = t0 * t3;
            const real t6 = t4 * t5;
            const real t7 = t0 * (t1 * t1 + t2 * t2) - t3 * t6;
            g[0 * 8 + j] = t7;
            el_y[j] = d_y * t0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t8[j] = rp_angle + alpha0;
            el_x[j] = d_x * t0;
            const real t11 = 2.0 * t4 * t7 - 4.0 * t0 * t6 * t5;
            t12[j] = 4.0 * t2 * t6 + d_y * t11;
            t13[j] = 4.0 * t1 * t6 + d_x * t11;
            t14[j] = t0 * t2 - d_y * t6;
            t15[j] = t0 * t1 - d_x * t6;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t17[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t8[j]);
            sin_p[j] = real_sin(t8[j]);
            cos_q[j] = real_cos(t17[j]);
            sin_q[j] = real_sin(t17[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t9 = rp_vangle * cos_p[j];
            const real t10 = rp_vangle * sin_p[j];
            const real t16 = 0.5 * (cos_p[j] * t12[j] - sin_p[j] * t13[j]) + 2.0 * (t10 * t14[j] + t9 * t15[j]);
            const real l0 = p[0 * 8 + j];
            g[1 * 8 + j] = -(l0 * (rp_vangle * (el_y[j] * t9 - el_x[j] * t10) + t16));
            const real rq_vangle = v[5 * 8 + j];
            const real t18 = rq_vangle * cos_q[j];
            const real t19 = rq_vangle * sin_q[j];
            const real t20 = 0.5 * (cos_q[j] * t12[j] - sin_q[j] * t13[j]) + 2.0 * (t19 * t14[j] + t18 * t15[j]);
            g[2 * 8 + j] = l0 * (rq_vangle * (el_y[j] * t18 - el_x[j] * t19) + t20);
        }
    }
}

/* rates: 130 operations.
 * in:  x (6), v (6), p (8)
 * out: Phi_x (3,6), 14 of 18 entries */
FLEXEL_CLONES
static void planar_beam_first_order_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict Phi_x = out[0] + b * (14 * 8);
        real el_x[8], el_y[8], t11[8], cos_p[8], t15[8], t16[8], sin_p[8], t18[8], t22[8], t26[8], t27[8], t28[8],
            t29[8], t32[8], t33[8], t35[8], cos_q[8], sin_q[8];
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
            const real t5 = d_x * t3 + d_y * t4;
            const real t6 = t0 * t3;
            const real t7 = t2 * t5 - t6;
            Phi_x[0 * 8 + j] = t7; /* Phi_x(0,0) */
            el_y[j] = d_y * t0;
            const real t8 = el_y[j] * t1;
            const real t9 = t0 * t4;
            const real t10 = t8 * t5 - t9;
            Phi_x[1 * 8 + j] = t10; /* Phi_x(0,1) */
            Phi_x[2 * 8 + j] = -t7; /* Phi_x(0,3) */
            Phi_x[3 * 8 + j] = -t10; /* Phi_x(0,4) */
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t11[j] = rp_angle + alpha0;
            const real t12 = t0 * t5;
            const real t13 = t0 * t12;
            const real t14 = 4.0 * t2 * t13 + 2.0 * t1 * t7;
            t15[j] = t4 * t2 - 0.5 * d_y * t14;
            t16[j] = d_y * t2;
            t18[j] = d_x * t2 - t0;
            const real t20 = t1 * t12;
            const real t21 = 2.0 * t20;
            t22[j] = t3 * t2 - 0.5 * (d_x * t14 - t21);
            const real t25 = 4.0 * t8 * t13 + 2.0 * t1 * t10;
            t26[j] = t4 * t8 - 0.5 * (d_y * t25 - t21);
            t27[j] = d_y * t8 - t0;
            t28[j] = d_x * t8;
            t29[j] = t3 * t8 - 0.5 * d_x * t25;
            t32[j] = t9 - d_y * t20;
            t33[j] = t6 - d_x * t20;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t35[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t11[j]);
            sin_p[j] = real_sin(t11[j]);
            cos_q[j] = real_cos(t35[j]);
            sin_q[j] = real_sin(t35[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t17 = rp_vangle * sin_p[j];
            const real t19 = rp_vangle * cos_p[j];
            const real t23 = cos_p[j] * t15[j] - t16[j] * t17 - t18[j] * t19 - sin_p[j] * t22[j];
            const real l0 = p[0 * 8 + j];
            const real t24 = l0 * t23;
            Phi_x[4 * 8 + j] = t24; /* Phi_x(1,0) */
            const real t30 = cos_p[j] * t26[j] - t27[j] * t17 - t28[j] * t19 - sin_p[j] * t29[j];
            const real t31 = l0 * t30;
            Phi_x[5 * 8 + j] = t31; /* Phi_x(1,1) */
            const real t34 = el_y[j] * t19 + cos_p[j] * t33[j] + sin_p[j] * t32[j] - el_x[j] * t17;
            Phi_x[6 * 8 + j] = -(l0 * t34); /* Phi_x(1,2) */
            Phi_x[7 * 8 + j] = -t24; /* Phi_x(1,3) */
            Phi_x[8 * 8 + j] = -t31; /* Phi_x(1,4) */
            const real rq_vangle = v[5 * 8 + j];
            const real t36 = rq_vangle * sin_q[j];
            const real t37 = rq_vangle * cos_q[j];
            const real t38 = cos_q[j] * t15[j] - t16[j] * t36 - t18[j] * t37 - sin_q[j] * t22[j];
            const real t39 = l0 * t38;
            Phi_x[11 * 8 + j] = t39; /* Phi_x(2,3) */
            Phi_x[9 * 8 + j] = -t39; /* Phi_x(2,0) */
            const real t40 = cos_q[j] * t26[j] - t27[j] * t36 - t28[j] * t37 - sin_q[j] * t29[j];
            const real t41 = l0 * t40;
            Phi_x[12 * 8 + j] = t41; /* Phi_x(2,4) */
            Phi_x[10 * 8 + j] = -t41; /* Phi_x(2,1) */
            const real t42 = el_y[j] * t37 + cos_q[j] * t33[j] + sin_q[j] * t32[j] - el_x[j] * t36;
            Phi_x[13 * 8 + j] = l0 * t42; /* Phi_x(2,5) */
        }
    }
}

/* kinematics: 448 operations.
 * in:  x (6), v (6), a (6), p (8)
 * out: Psi_x (3,6), 14 of 18 entries, Psi_v (3,6), 14 of 18 entries */
FLEXEL_CLONES
static void planar_beam_first_order_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict Psi_x = out[0] + b * (14 * 8);
        real *restrict Psi_v = out[1] + b * (14 * 8);
        real d_x[8], d_y[8], t0[8], t1[8], t3[8], t5[8], t8[8], t11[8], t13[8], t15[8], t19[8], t25[8], t26[8],
            t28[8], t29[8], sin_p[8], cos_p[8], t33[8], t40[8], t43[8], t44[8], t46[8], t48[8], t49[8], t55[8],
            t56[8], el_y[8], t61[8], el_x[8], t64[8], t66[8], t69[8], t70[8], cos_q[8], sin_q[8], t89[8], t90[8],
            t98[8], t99[8], t100[8], t102[8], t106[8], t107[8], t108[8], t109[8];
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
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t1[j] = q_ax - p_ax;
            const real t2 = t0[j] * t1[j];
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t3[j] = q_vx - p_vx;
            const real t4 = t0[j] * t0[j];
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t5[j] = q_vy - p_vy;
            const real t6 = d_x[j] * t3[j] + d_y[j] * t5[j];
            const real t7 = t0[j] * t6;
            t8[j] = t4 * t7;
            const real t9 = t3[j] * t8[j];
            const real t10 = t0[j] * t3[j];
            t11[j] = t4 * t10;
            const real t12 = t0[j] * t4;
            t13[j] = d_x[j] * t12;
            const real t14 = t3[j] * t3[j] + t5[j] * t5[j];
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t15[j] = q_ay - p_ay;
            const real t16 = d_x[j] * t1[j] + d_y[j] * t15[j];
            const real t17 = t0[j] * t7;
            const real t18 = t4 * t6;
            t19[j] = 4.0 * t17 + 2.0 * t18;
            const real t20 = 2.0 * (t14 + t16) - t6 * t19[j];
            const real t21 = t2 - t9 - t6 * t11[j] - 0.5 * t13[j] * t20;
            Psi_x[2 * 8 + j] = t21; /* Psi_x(0,3) */
            Psi_x[0 * 8 + j] = -t21; /* Psi_x(0,0) */
            const real t22 = t0[j] * t15[j];
            const real t23 = t5[j] * t8[j];
            const real t24 = t0[j] * t5[j];
            t25[j] = t4 * t24;
            t26[j] = d_y[j] * t12;
            const real t27 = t22 - t23 - t6 * t25[j] - 0.5 * t26[j] * t20;
            Psi_x[3 * 8 + j] = t27; /* Psi_x(0,4) */
            Psi_x[1 * 8 + j] = -t27; /* Psi_x(0,1) */
            t28[j] = t4 * t2;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t29[j] = rp_angle + alpha0;
            t33[j] = 2.0 * t17 + t18;
            const real t39 = t0[j] * t16;
            t40[j] = t4 * t39;
            const real t41 = t0[j] * t14 - t6 * t8[j];
            const real t42 = t0[j] * t8[j];
            t43[j] = 2.0 * t4 * t41 - 4.0 * t7 * t42;
            t44[j] = t40[j] + 0.5 * t43[j];
            t46[j] = 4.0 * t10 * t42 + 2.0 * t4 * t9;
            t48[j] = 2.0 * t4 * t16 + 4.0 * t0[j] * t39;
            t49[j] = 2.0 * (t4 * t14 + 2.0 * t0[j] * t41) - 4.0 * (t7 * t8[j] + t6 * t42);
            t55[j] = t4 * t22;
            t56[j] = 4.0 * t24 * t42 + 2.0 * t4 * t23;
            el_y[j] = d_y[j] * t0[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t60 = t2 - d_x[j] * t40[j];
            t61[j] = t24 - d_y[j] * t8[j];
            const real t62 = 2.0 * t61[j];
            el_x[j] = d_x[j] * t0[j];
            const real rp_vangle = v[2 * 8 + j];
            const real t63 = t9 + 0.5 * (2.0 * t9 + d_x[j] * t43[j]);
            t64[j] = el_y[j] * rp_aangle + t60 + (rp_vangle * (t62 - rp_vangle * el_x[j]) - t63);
            const real t65 = t22 - d_y[j] * t40[j];
            t66[j] = t10 - d_x[j] * t8[j];
            const real t67 = 2.0 * t66[j];
            const real t68 = t23 + 0.5 * (2.0 * t23 + d_y[j] * t43[j]);
            t69[j] = t65 - el_x[j] * rp_aangle - (rp_vangle * (rp_vangle * el_y[j] + t67) + t68);
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t70[j] = rq_angle + alphaq0;
            const real rq_aangle = a[5 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t89[j] = el_y[j] * rq_aangle + t60 + (rq_vangle * (t62 - rq_vangle * el_x[j]) - t63);
            t90[j] = t65 - el_x[j] * rq_aangle - (rq_vangle * (rq_vangle * el_y[j] + t67) + t68);
            const real t91 = el_x[j] * t4;
            const real t92 = t91 * t6 - t10;
            const real t93 = 2.0 * t92;
            Psi_v[0 * 8 + j] = t93; /* Psi_v(0,0) */
            const real t94 = el_y[j] * t4;
            const real t95 = t94 * t6 - t24;
            const real t96 = 2.0 * t95;
            Psi_v[1 * 8 + j] = t96; /* Psi_v(0,1) */
            Psi_v[2 * 8 + j] = -t93; /* Psi_v(0,3) */
            Psi_v[3 * 8 + j] = -t96; /* Psi_v(0,4) */
            const real t97 = 4.0 * t91 * t17 + 2.0 * t4 * t92;
            t98[j] = t5[j] * t91 - 0.5 * d_y[j] * t97;
            t99[j] = d_y[j] * t91;
            t100[j] = d_x[j] * t91 - t0[j];
            const real t101 = 2.0 * t8[j];
            t102[j] = t3[j] * t91 - 0.5 * (d_x[j] * t97 - t101);
            const real t105 = 4.0 * t94 * t17 + 2.0 * t4 * t95;
            t106[j] = t5[j] * t94 - 0.5 * (d_y[j] * t105 - t101);
            t107[j] = d_y[j] * t94 - t0[j];
            t108[j] = d_x[j] * t94;
            t109[j] = t3[j] * t94 - 0.5 * d_x[j] * t105;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t29[j]);
            cos_p[j] = real_cos(t29[j]);
            cos_q[j] = real_cos(t70[j]);
            sin_q[j] = real_sin(t70[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t30 = sin_p[j] * d_x[j];
            const real l0 = p[0 * 8 + j];
            const real t31 = l0 * cos_p[j];
            const real t32 = l0 * t30 - d_y[j] * t31;
            const real t34 = l0 * (cos_p[j] * d_y[j] - t30);
            const real rp_vangle = v[2 * 8 + j];
            const real t35 = rp_vangle * cos_p[j];
            const real t36 = rp_vangle * sin_p[j];
            const real t37 = cos_p[j] * t5[j] - d_x[j] * t35 - d_y[j] * t36 - sin_p[j] * t3[j];
            const real t38 = 0.5 * t33[j] * t34 - l0 * t37;
            const real rp_aangle = a[2 * 8 + j];
            const real t45 = l0 * (rp_vangle * t36 - cos_p[j] * rp_aangle);
            const real t47 = t0[j] * t45 + 0.5 * t46[j] * t34 + l0 * (2.0 * t35 * t8[j] + sin_p[j] * t44[j]);
            const real t50 = t19[j] * t38 + 0.5 * (t48[j] * t32 - t34 * t49[j]) + t31 * t15[j];
            const real t51 = l0 * (sin_p[j] * t1[j] + 2.0 * (t3[j] * t35 + t5[j] * t36));
            const real t52 = l0 * (rp_vangle * t35 + sin_p[j] * rp_aangle);
            const real t53 = d_x[j] * t45 + t50 - t51 - d_y[j] * t52;
            const real t54 = 2.0 * (0.5 * t28[j] * t32 + t11[j] * t38) + t47 - t13[j] * t53;
            Psi_x[7 * 8 + j] = t54; /* Psi_x(1,3) */
            Psi_x[4 * 8 + j] = -t54; /* Psi_x(1,0) */
            const real t57 = 2.0 * (0.5 * t55[j] * t32 + t25[j] * t38) + 0.5 * t56[j] * t34;
            const real t58 = t57 - t31 * t40[j] - l0 * (0.5 * cos_p[j] * t43[j] - 2.0 * t36 * t8[j]);
            const real t59 = t58 - t0[j] * t52 - t26[j] * t53;
            Psi_x[8 * 8 + j] = t59; /* Psi_x(1,4) */
            Psi_x[5 * 8 + j] = -t59; /* Psi_x(1,1) */
            Psi_x[6 * 8 + j] = -(l0 * (cos_p[j] * t64[j] + sin_p[j] * t69[j])); /* Psi_x(1,2) */
            const real t71 = l0 * cos_q[j];
            const real t72 = sin_q[j] * d_x[j];
            const real t73 = d_y[j] * t71 - l0 * t72;
            const real rq_vangle = v[5 * 8 + j];
            const real t74 = rq_vangle * cos_q[j];
            const real t75 = rq_vangle * sin_q[j];
            const real t76 = cos_q[j] * t5[j] - d_x[j] * t74 - d_y[j] * t75 - sin_q[j] * t3[j];
            const real t77 = l0 * (cos_q[j] * d_y[j] - t72);
            const real t78 = l0 * t76 - 0.5 * t33[j] * t77;
            const real rq_aangle = a[5 * 8 + j];
            const real t79 = l0 * (cos_q[j] * rq_aangle - rq_vangle * t75);
            const real t80 = 2.0 * (0.5 * t28[j] * t73 + t11[j] * t78) + t0[j] * t79 - l0 * (2.0 * t74 * t8[j]
                + sin_q[j] * t44[j]);
            const real t81 = l0 * (rq_vangle * t74 + sin_q[j] * rq_aangle);
            const real t82 = l0 * (sin_q[j] * t1[j] + 2.0 * (t3[j] * t74 + t5[j] * t75));
            const real t83 = t19[j] * t78 + 0.5 * (t48[j] * t73 + t77 * t49[j]) + d_x[j] * t79;
            const real t84 = t82 + t83 + d_y[j] * t81 - t71 * t15[j];
            const real t85 = t80 - 0.5 * t46[j] * t77 - t13[j] * t84;
            Psi_x[11 * 8 + j] = t85; /* Psi_x(2,3) */
            Psi_x[9 * 8 + j] = -t85; /* Psi_x(2,0) */
            const real t86 = t71 * t40[j] + l0 * (0.5 * cos_q[j] * t43[j] - 2.0 * t75 * t8[j]);
            const real t87 = 2.0 * (0.5 * t55[j] * t73 + t25[j] * t78) + t86 + t0[j] * t81;
            const real t88 = t87 - 0.5 * t56[j] * t77 - t26[j] * t84;
            Psi_x[12 * 8 + j] = t88; /* Psi_x(2,4) */
            Psi_x[10 * 8 + j] = -t88; /* Psi_x(2,1) */
            Psi_x[13 * 8 + j] = l0 * (cos_q[j] * t89[j] + sin_q[j] * t90[j]); /* Psi_x(2,5) */
            const real t103 = cos_p[j] * t98[j] - t99[j] * t36 - t100[j] * t35 - sin_p[j] * t102[j];
            const real t104 = 2.0 * l0 * t103;
            Psi_v[4 * 8 + j] = t104; /* Psi_v(1,0) */
            const real t110 = cos_p[j] * t106[j] - t107[j] * t36 - t108[j] * t35 - sin_p[j] * t109[j];
            const real t111 = 2.0 * l0 * t110;
            Psi_v[5 * 8 + j] = t111; /* Psi_v(1,1) */
            const real t112 = el_y[j] * t35 + cos_p[j] * t66[j] + sin_p[j] * t61[j] - el_x[j] * t36;
            Psi_v[6 * 8 + j] = -(2.0 * l0 * t112); /* Psi_v(1,2) */
            Psi_v[7 * 8 + j] = -t104; /* Psi_v(1,3) */
            Psi_v[8 * 8 + j] = -t111; /* Psi_v(1,4) */
            const real t113 = cos_q[j] * t98[j] - t99[j] * t75 - t100[j] * t74 - sin_q[j] * t102[j];
            const real t114 = 2.0 * l0 * t113;
            Psi_v[11 * 8 + j] = t114; /* Psi_v(2,3) */
            Psi_v[9 * 8 + j] = -t114; /* Psi_v(2,0) */
            const real t115 = cos_q[j] * t106[j] - t107[j] * t75 - t108[j] * t74 - sin_q[j] * t109[j];
            const real t116 = 2.0 * l0 * t115;
            Psi_v[12 * 8 + j] = t116; /* Psi_v(2,4) */
            Psi_v[10 * 8 + j] = -t116; /* Psi_v(2,1) */
            const real t117 = el_y[j] * t74 + cos_q[j] * t66[j] + sin_q[j] * t61[j] - el_x[j] * t75;
            Psi_v[13 * 8 + j] = 2.0 * l0 * t117; /* Psi_v(2,5) */
        }
    }
}

/* stiffness: 84 operations.
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
        real d_x[8], d_y[8], t0[8], t1[8], t2[8], cos_p[8], t3[8], t5[8], cos_q[8], t6[8], sin_q[8], sin_p[8], t15[8],
            t16[8], t21[8], el_y[8], el_x[8];
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
            el_y[j] = d_y[j] * t0[j];
            el_x[j] = d_x[j] * t0[j];
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
            const real t12 = t1[j] * (d_y[j] * t8 + d_x[j] * t11);
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t13 = sigma_elongation - t12;
            const real t14 = t0[j] * t13;
            const real t17 = t13 - 2.0 * t12;
            const real t18 = t11 + d_x[j] * t17;
            const real t19 = t14 - t16[j] * (t11 + t18);
            K[0 * 8 + j] = K[20 * 8 + j] = t19; /* K(0,0) K(3,3) */
            const real t20 = t15[j] * t8;
            const real t22 = d_x[j] * t20 + t21[j] * t18;
            K[4 * 8 + j] = K[9 * 8 + j] = K[18 * 8 + j] = K[23 * 8 + j] = t22; /* K(0,4) K(1,3) K(3,1) K(4,0) */
            K[1 * 8 + j] = K[6 * 8 + j] = K[21 * 8 + j] = K[26 * 8 + j] = -t22; /* K(0,1) K(1,0) K(3,4) K(4,3) */
            const real t23 = d_y[j] * t10 + d_x[j] * t4;
            const real t24 = t16[j] * t23 - t0[j] * t4;
            K[15 * 8 + j] = K[19 * 8 + j] = t24; /* K(2,3) K(3,2) */
            K[2 * 8 + j] = K[12 * 8 + j] = -t24; /* K(0,2) K(2,0) */
            K[3 * 8 + j] = K[17 * 8 + j] = -t19; /* K(0,3) K(3,0) */
            const real t25 = d_y[j] * t9 + d_x[j] * t7;
            const real t26 = t0[j] * t7 - t16[j] * t25;
            K[22 * 8 + j] = K[31 * 8 + j] = t26; /* K(3,5) K(5,3) */
            K[5 * 8 + j] = K[29 * 8 + j] = -t26; /* K(0,5) K(5,0) */
            const real t27 = t14 - d_y[j] * t20 - t21[j] * (t8 + d_y[j] * t17);
            K[7 * 8 + j] = K[27 * 8 + j] = t27; /* K(1,1) K(4,4) */
            const real t28 = t21[j] * t23 - t0[j] * t10;
            K[16 * 8 + j] = K[25 * 8 + j] = t28; /* K(2,4) K(4,2) */
            K[8 * 8 + j] = K[13 * 8 + j] = -t28; /* K(1,2) K(2,1) */
            K[10 * 8 + j] = K[24 * 8 + j] = -t27; /* K(1,4) K(4,1) */
            const real t29 = t0[j] * t9 - t21[j] * t25;
            K[28 * 8 + j] = K[32 * 8 + j] = t29; /* K(4,5) K(5,4) */
            K[11 * 8 + j] = K[30 * 8 + j] = -t29; /* K(1,5) K(5,1) */
            K[14 * 8 + j] = -((cos_p[j] * el_y[j] - sin_p[j] * el_x[j]) * t3[j]); /* K(2,2) */
            K[33 * 8 + j] = (cos_q[j] * el_y[j] - sin_q[j] * el_x[j]) * t6[j]; /* K(5,5) */
        }
    }
}

/* inertia: 291 operations.
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
        real t0[8], t1[8], t2[8], sin_p[8], t3[8], sin_q[8], t5[8], t6[8], t7[8], cos_p[8], cos_q[8], t13[8], t14[8],
            t16[8], t18[8], t24[8], t27[8], t29[8], t38[8], t39[8], t40[8], t51[8], t54[8], t56[8], t58[8], t59[8],
            t60[8], t63[8], t64[8], t69[8], t71[8], t72[8], t75[8], t77[8], t78[8], t79[8], t84[8], t88[8], t89[8],
            t90[8], t92[8];
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
            t6[j] = 1.0 / (1.0 + phi_z) * (1.0 / (1.0 + phi_z)) * l0 * rhoJ;
            t7[j] = t5[j] * t6[j] * t5[j];
            t13[j] = (phi_z - 0.2) * t6[j];
            t14[j] = t5[j] * t13[j];
            t16[j] = l0 * t0[j];
            t18[j] = 0.12857142857142856 * t0[j];
            t24[j] = l0 * l0 * t0[j];
            const real t26 = phi_z * (0.16666666666666666 + 0.3333333333333333 * phi_z);
            t27[j] = 0.5 * (0.13333333333333333 + t26) * t6[j];
            const real t28 = 0.3333333333333333 * (phi_z * (phi_z - 1.0)) - 0.06666666666666667;
            t29[j] = 0.5 * t28 * t6[j];
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t38[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t39[j] = q_vx - p_vx;
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t40[j] = 0.25 * (rp_vangle + rq_vangle) * t13[j];
            t51[j] = rq_vangle * t16[j];
            t54[j] = rp_vangle * t16[j];
            t56[j] = rp_vangle * t24[j];
            t58[j] = rp_vangle * rp_vangle * t24[j];
            t59[j] = 0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy;
            t60[j] = t54[j] * t59[j];
            t63[j] = rq_vangle * t24[j];
            t64[j] = rp_vangle * t63[j];
            t69[j] = 0.030952380952380953 * q_vx + 0.05238095238095238 * p_vx;
            t71[j] = t54[j] * t69[j];
            t72[j] = rp_vangle * rq_vangle;
            t75[j] = 0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy;
            t77[j] = 0.05238095238095238 * q_vx + 0.030952380952380953 * p_vx;
            t78[j] = rq_vangle * rq_vangle * t24[j];
            t79[j] = t51[j] * t75[j];
            t84[j] = t51[j] * t77[j];
            const real gravity_x = p[6 * 8 + j];
            const real t86 = gravity_x * t0[j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * t86;
            const real gravity_y = p[7 * 8 + j];
            const real t87 = gravity_y * t0[j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * t87;
            t88[j] = l0 * t87;
            t89[j] = l0 * t86;
            const real p_x = x[0 * 8 + j];
            const real q_x = x[3 * 8 + j];
            t90[j] = 0.5 * (p_x + q_x);
            const real p_y = x[1 * 8 + j];
            const real q_y = x[4 * 8 + j];
            t92[j] = 0.5 * (p_y + q_y);
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
            M[0 * 8 + j] = M[21 * 8 + j] = t1[j] + t9; /* M(0,0) M(3,3) */
            const real t10 = cos_p[j] + cos_q[j];
            const real t11 = t10 * t7[j];
            const real t12 = 0.3 * (t4 * t11);
            M[4 * 8 + j] = M[24 * 8 + j] = t12; /* M(0,4) M(4,0) */
            M[1 * 8 + j] = M[6 * 8 + j] = M[22 * 8 + j] = M[27 * 8 + j] = -t12; /* M(0,1) M(1,0) M(3,4) M(4,3) */
            const real t15 = 0.25 * t4 * t14[j];
            const real t17 = sin_p[j] * t16[j];
            M[2 * 8 + j] = M[12 * 8 + j] = t15 - 0.05238095238095238 * t17; /* M(0,2) M(2,0) */
            M[3 * 8 + j] = M[18 * 8 + j] = t18[j] - t9; /* M(0,3) M(3,0) */
            const real t19 = sin_q[j] * t16[j];
            M[5 * 8 + j] = M[30 * 8 + j] = 0.030952380952380953 * t19 + t15; /* M(0,5) M(5,0) */
            const real t20 = 0.3 * (t10 * t11);
            M[7 * 8 + j] = M[28 * 8 + j] = t1[j] + t20; /* M(1,1) M(4,4) */
            const real t21 = cos_p[j] * t16[j];
            const real t22 = 0.25 * t10 * t14[j];
            M[8 * 8 + j] = M[13 * 8 + j] = 0.05238095238095238 * t21 - t22; /* M(1,2) M(2,1) */
            M[9 * 8 + j] = M[19 * 8 + j] = 0.3 * (t10 * t8); /* M(1,3) M(3,1) */
            M[10 * 8 + j] = M[25 * 8 + j] = t18[j] - t20; /* M(1,4) M(4,1) */
            const real t23 = cos_q[j] * t16[j];
            M[11 * 8 + j] = M[31 * 8 + j] = -(0.030952380952380953 * t23 + t22); /* M(1,5) M(5,1) */
            const real t25 = 0.004761904761904762 * (t24[j] * (cos_p[j] * cos_p[j] + sin_p[j] * sin_p[j]));
            M[14 * 8 + j] = 2.0 * (t25 + t27[j]); /* M(2,2) */
            M[15 * 8 + j] = M[20 * 8 + j] = -(0.030952380952380953 * t17 + t15); /* M(2,3) M(3,2) */
            M[16 * 8 + j] = M[26 * 8 + j] = 0.030952380952380953 * t21 + t22; /* M(2,4) M(4,2) */
            const real t30 = sin_q[j] * t24[j];
            const real t31 = 0.007142857142857143 * (sin_p[j] * t30 + cos_p[j] * cos_q[j] * t24[j]);
            M[17 * 8 + j] = M[32 * 8 + j] = t29[j] - t31; /* M(2,5) M(5,2) */
            M[23 * 8 + j] = M[33 * 8 + j] = 0.05238095238095238 * t19 - t15; /* M(3,5) M(5,3) */
            M[29 * 8 + j] = M[34 * 8 + j] = t22 - 0.05238095238095238 * t23; /* M(4,5) M(5,4) */
            const real t32 = 0.004761904761904762 * (t24[j] * (cos_q[j] * cos_q[j] + sin_q[j] * sin_q[j]));
            M[35 * 8 + j] = 2.0 * (t32 + t27[j]); /* M(5,5) */
            const real rq_vangle = v[5 * 8 + j];
            const real t33 = rq_vangle * cos_q[j];
            const real t34 = t33 * t16[j];
            const real t35 = rq_vangle * t34;
            const real rp_vangle = v[2 * 8 + j];
            const real t36 = rp_vangle * cos_p[j];
            const real t37 = t36 + t33;
            const real t41 = 0.3 * (t5[j] * (t10 * t38[j] - t39[j] * t4) * t6[j]) + t40[j];
            const real t42 = t5[j] * t41;
            const real t43 = rp_vangle * sin_p[j];
            const real t44 = rq_vangle * sin_q[j];
            const real t45 = t43 + t44;
            const real t46 = t5[j] * (t38[j] * t45 + t39[j] * t37);
            const real t47 = t5[j] * t46 * t6[j];
            const real t48 = t37 * t42 - 0.3 * (t4 * t47);
            const real t49 = t36 * t16[j];
            const real t50 = rp_vangle * t49;
            h[0 * 8 + j] = 0.030952380952380953 * t35 + t48 - 0.05238095238095238 * t50;
            const real t52 = t44 * t51[j];
            const real t53 = t45 * t42 + 0.3 * (t10 * t47);
            const real t55 = t43 * t54[j];
            h[1 * 8 + j] = 0.030952380952380953 * t52 + t53 - 0.05238095238095238 * t55;
            const real t57 = 0.01904761904761905 * ((sin_p[j] * t36 - cos_p[j] * t43) * t56[j]);
            const real t61 = t38[j] * t42;
            const real t62 = t60[j] + t61 + 0.009523809523809525 * (cos_p[j] * t58[j]);
            const real t65 = sin_p[j] * (t62 - 0.007142857142857143 * (cos_q[j] * t64[j]));
            const real t66 = cos_q[j] * t43 + cos_p[j] * t44;
            const real t67 = t36 * t30 + sin_p[j] * t24[j] * t33;
            const real t68 = t65 + 0.007142857142857143 * (t63[j] * t66 - rq_vangle * t67);
            const real t70 = 0.25 * t46 * t13[j];
            const real t73 = 0.009523809523809525 * (sin_p[j] * t58[j]) - t71[j] - 0.007142857142857143 * (t72[j]
                * t30);
            const real t74 = t39[j] * t42;
            h[2 * 8 + j] = t57 + t68 - t43 * t16[j] * t59[j] - t49 * t69[j] - t70 - cos_p[j] * (t73 - t74);
            h[3 * 8 + j] = 0.05238095238095238 * t35 - 0.030952380952380953 * t50 - t48;
            h[4 * 8 + j] = 0.05238095238095238 * t52 - 0.030952380952380953 * t55 - t53;
            const real t76 = 0.007142857142857143 * (rp_vangle * (t24[j] * t66 - t67));
            const real t80 = 0.009523809523809525 * (cos_q[j] * t78[j]) + t61 - t79[j];
            const real t81 = sin_q[j] * (t80 - 0.007142857142857143 * (cos_p[j] * t64[j]));
            const real t82 = 0.01904761904761905 * (t63[j] * (sin_q[j] * t33 - cos_q[j] * t44));
            const real t83 = t81 + t82 + t34 * t77[j] + t76 + t44 * t16[j] * t75[j] - t70;
            const real t85 = 0.009523809523809525 * (sin_q[j] * t78[j]) + t84[j] - 0.007142857142857143 * (sin_p[j]
                * t72[j] * t24[j]);
            h[5 * 8 + j] = t83 - cos_q[j] * (t85 - t74);
            f[2 * 8 + j] = 0.08333333333333333 * (cos_p[j] * t88[j] - sin_p[j] * t89[j]);
            f[5 * 8 + j] = 0.08333333333333333 * (sin_q[j] * t89[j] - cos_q[j] * t88[j]);
            const real l0 = p[0 * 8 + j];
            const real t91 = t90[j] + 0.08333333333333333 * (l0 * (cos_p[j] - cos_q[j]));
            const real gravity_x = p[6 * 8 + j];
            const real t93 = t92[j] + 0.08333333333333333 * (l0 * (sin_p[j] - sin_q[j]));
            const real gravity_y = p[7 * 8 + j];
            U[0 * 8 + j] = -((gravity_x * t91 + gravity_y * t93) * t0[j]);
        }
    }
}

/* tangent: 539 operations.
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
        real t0[8], cos_p[8], t1[8], t2[8], t3[8], t4[8], cos_q[8], t6[8], t7[8], sin_p[8], sin_q[8], t11[8], t16[8],
            t18[8], t19[8], t24[8], t27[8], t32[8], t46[8], t48[8], t51[8], t52[8], t53[8], t54[8], t55[8], t60[8],
            t63[8], t70[8], t72[8], t73[8], t94[8], t95[8], t98[8], t109[8], t111[8], t117[8], t131[8], t132[8],
            t135[8], t137[8], t140[8], t142[8], t145[8], t161[8], t166[8], t167[8], t169[8], t172[8], t173[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            t1[j] = 1.0 / l0;
            const real phi_z = p[5 * 8 + j];
            const real rhoJ = p[4 * 8 + j];
            t2[j] = 1.0 / (1.0 + phi_z) * (1.0 / (1.0 + phi_z)) * l0 * rhoJ;
            t3[j] = t1[j] * t2[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t4[j] = rq_angle + alphaq0;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t6[j] = q_ay - p_ay;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t7[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t11[j] = q_vx - p_vx;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t16[j] = q_ax - p_ax;
            t18[j] = (phi_z - 0.2) * t2[j];
            const real rp_aangle = a[2 * 8 + j];
            const real rq_aangle = a[5 * 8 + j];
            t19[j] = 0.25 * t18[j] * (rp_aangle + rq_aangle);
            t24[j] = t1[j] * t3[j];
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t27[j] = 0.25 * (rp_vangle + rq_vangle) * t18[j];
            const real rhoA = p[3 * 8 + j];
            const real t31 = l0 * rhoA;
            t32[j] = l0 * t31;
            t46[j] = rp_vangle * t32[j];
            t48[j] = rq_vangle * t32[j];
            const real gravity_y = p[7 * 8 + j];
            t51[j] = 0.08333333333333333 * (gravity_y * t32[j]);
            t52[j] = t32[j] * (0.030952380952380953 * q_vx + 0.05238095238095238 * p_vx);
            t53[j] = t51[j] - rp_vangle * t52[j];
            t54[j] = rp_vangle * rq_vangle;
            t55[j] = l0 * l0 * t31;
            t60[j] = rq_vangle * t55[j];
            t63[j] = rq_aangle * t55[j];
            const real t69 = 0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy;
            t70[j] = t46[j] * t69;
            const real gravity_x = p[6 * 8 + j];
            t72[j] = 0.08333333333333333 * (gravity_x * t32[j]);
            t73[j] = rp_vangle * t60[j];
            t94[j] = t32[j] * (0.05238095238095238 * q_vx + 0.030952380952380953 * p_vx);
            t95[j] = rq_vangle * t94[j];
            const real t97 = 0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy;
            t98[j] = t48[j] * t97;
            t109[j] = t1[j] * t18[j];
            t111[j] = 0.05238095238095238 * t46[j];
            t117[j] = 0.030952380952380953 * t48[j];
            t131[j] = t32[j] * t69;
            t132[j] = rp_vangle * t55[j];
            const real t134 = q_vy * t32[j];
            t135[j] = 0.030952380952380953 * t134;
            const real t136 = p_vy * t32[j];
            t137[j] = 0.05238095238095238 * t136;
            const real t139 = p_vx * t32[j];
            t140[j] = 0.05238095238095238 * t139;
            const real t141 = q_vx * t32[j];
            t142[j] = 0.030952380952380953 * t141;
            t145[j] = 0.030952380952380953 * t46[j];
            t161[j] = 0.05238095238095238 * t48[j];
            t166[j] = 0.030952380952380953 * t136;
            t167[j] = 0.05238095238095238 * t134;
            t169[j] = t32[j] * t97;
            t172[j] = 0.030952380952380953 * t139;
            t173[j] = 0.05238095238095238 * t141;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            cos_q[j] = real_cos(t4[j]);
            sin_p[j] = real_sin(t0[j]);
            sin_q[j] = real_sin(t4[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t5 = cos_p[j] + cos_q[j];
            const real rp_vangle = v[2 * 8 + j];
            const real t8 = rp_vangle * sin_p[j];
            const real rq_vangle = v[5 * 8 + j];
            const real t9 = rq_vangle * sin_q[j];
            const real t10 = t8 + t9;
            const real t12 = rp_vangle * cos_p[j];
            const real t13 = rq_vangle * cos_q[j];
            const real t14 = t12 + t13;
            const real t15 = sin_p[j] + sin_q[j];
            const real t17 = t3[j] * (t5 * t6[j] - t7[j] * t10 - t11[j] * t14 - t15 * t16[j]);
            const real t20 = t1[j] * (0.3 * t17 + t19[j]);
            const real t21 = t7[j] * t12 + sin_p[j] * t6[j] + cos_p[j] * t16[j] - t11[j] * t8;
            const real t22 = t1[j] * t21;
            const real t23 = t3[j] * t22;
            const real t25 = sin_p[j] * t7[j] + cos_p[j] * t11[j];
            const real t26 = t24[j] * t25;
            const real t28 = 0.3 * (t1[j] * (t5 * t7[j] - t11[j] * t15) * t2[j]) + t27[j];
            const real t29 = t1[j] * t28;
            const real t30 = cos_p[j] * t20 - 0.3 * (t15 * t23 + t14 * t26) - t8 * t29;
            const real t33 = cos_p[j] * t32[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t34 = t8 * t32[j];
            const real t35 = rp_aangle * t33 - rp_vangle * t34;
            R_x[0 * 8 + j] = t30 - 0.05238095238095238 * t35; /* R_x(0,2) */
            const real t36 = cos_q[j] * t32[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t37 = t9 * t32[j];
            const real t38 = rq_aangle * t36 - rq_vangle * t37;
            const real t39 = t7[j] * t13 + sin_q[j] * t6[j] + cos_q[j] * t16[j] - t11[j] * t9;
            const real t40 = t1[j] * t39;
            const real t41 = t3[j] * t40;
            const real t42 = sin_q[j] * t7[j] + cos_q[j] * t11[j];
            const real t43 = t24[j] * t42;
            const real t44 = cos_q[j] * t20 - 0.3 * (t15 * t41 + t14 * t43) - t9 * t29;
            R_x[1 * 8 + j] = 0.030952380952380953 * t38 + t44; /* R_x(0,5) */
            const real t45 = sin_p[j] * t20 + 0.3 * (t5 * t23 - t10 * t26) + t12 * t29;
            const real t47 = t12 * t46[j] + sin_p[j] * rp_aangle * t32[j];
            R_x[2 * 8 + j] = t45 - 0.05238095238095238 * t47; /* R_x(1,2) */
            const real t49 = t13 * t48[j] + sin_q[j] * rq_aangle * t32[j];
            const real t50 = sin_q[j] * t20 + 0.3 * (t5 * t41 - t10 * t43) + t13 * t29;
            R_x[3 * 8 + j] = 0.030952380952380953 * t49 + t50; /* R_x(1,5) */
            const real t56 = sin_q[j] * t55[j];
            const real t57 = t11[j] * t29;
            const real t58 = 0.3 * (t7[j] * t26);
            const real t59 = t53[j] - 0.007142857142857143 * (t54[j] * t56) - t57 - t58;
            const real t61 = sin_p[j] * t9;
            const real t62 = cos_q[j] * t12 - t61;
            const real t64 = sin_p[j] * cos_q[j];
            const real t65 = t13 * t55[j];
            const real t66 = cos_p[j] * t65 - t8 * t56;
            const real t67 = cos_p[j] * t56;
            const real t68 = t60[j] * t62 + t63[j] * t64 - rq_vangle * t66 - rq_aangle * t67;
            const real t71 = t7[j] * t29;
            const real t74 = t70[j] + t71 + t72[j] - 0.007142857142857143 * (cos_q[j] * t73[j]);
            const real t75 = 0.3 * (t11[j] * t26);
            const real t76 = 0.007142857142857143 * t68 + cos_p[j] * (t74 - t75) + sin_p[j] * t59;
            const real q_vy = v[4 * 8 + j];
            const real q_ay = a[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t77 = 0.030952380952380953 * (q_vy * t12 + sin_p[j] * q_ay) + 0.05238095238095238 * (p_vy * t12
                + sin_p[j] * p_ay);
            const real t78 = 0.25 * t18[j] * t22;
            const real q_ax = a[3 * 8 + j];
            const real q_vx = v[3 * 8 + j];
            const real t79 = t76 - t32[j] * t77 - t78 - 0.030952380952380953 * (q_ax * t33 - q_vx * t34);
            const real p_ax = a[0 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            R_x[4 * 8 + j] = t79 - 0.05238095238095238 * (p_ax * t33 - p_vx * t34); /* R_x(2,2) */
            const real t80 = cos_p[j] * t13 - sin_q[j] * t8;
            const real t81 = cos_p[j] * sin_q[j];
            const real t82 = cos_q[j] * t55[j];
            const real t83 = t12 * t82 - t55[j] * t61;
            const real t84 = sin_p[j] * t82;
            const real t85 = t60[j] * t80 + t63[j] * t81 - rq_vangle * t83 - rq_aangle * t84;
            const real t86 = 0.3 * (t7[j] * t43);
            const real t87 = sin_p[j] * (0.007142857142857143 * (sin_q[j] * t73[j]) - t86);
            const real t88 = 0.25 * t18[j] * t40;
            const real t89 = 0.3 * (t11[j] * t43);
            R_x[5 * 8 + j] = 0.007142857142857143 * t85 + t87 - t88 - cos_p[j] * (t89 - 0.007142857142857143 * (t54[j]
                * t82)); /* R_x(2,5) */
            R_x[6 * 8 + j] = -(0.030952380952380953 * t35 + t30); /* R_x(3,2) */
            R_x[7 * 8 + j] = 0.05238095238095238 * t38 - t44; /* R_x(3,5) */
            R_x[8 * 8 + j] = -(0.030952380952380953 * t47 + t45); /* R_x(4,2) */
            R_x[9 * 8 + j] = 0.05238095238095238 * t49 - t50; /* R_x(4,5) */
            const real t90 = t55[j] * (rp_vangle * t62 + rp_aangle * t64) - rp_vangle * t66;
            const real t91 = sin_q[j] * (0.007142857142857143 * (sin_p[j] * t73[j]) - t58);
            const real t92 = 0.007142857142857143 * (t90 - rp_aangle * t67) + t91 - t78;
            const real t93 = t75 - 0.007142857142857143 * (cos_p[j] * t54[j] * t55[j]);
            R_x[10 * 8 + j] = t92 - cos_q[j] * t93; /* R_x(5,2) */
            const real t96 = t95[j] - 0.007142857142857143 * (sin_p[j] * t54[j] * t55[j]);
            const real t99 = t71 - t98[j] - 0.007142857142857143 * (cos_p[j] * t73[j]);
            const real t100 = t55[j] * (rp_vangle * t80 + rp_aangle * t81) - rp_vangle * t83;
            const real t101 = 0.05238095238095238 * (q_vy * t13 + sin_q[j] * q_ay) + 0.030952380952380953 * (p_vy
                * t13 + sin_q[j] * p_ay);
            const real t102 = 0.05238095238095238 * (q_ax * t36 - q_vx * t37) + 0.030952380952380953 * (p_ax * t36
                - p_vx * t37);
            const real t103 = t32[j] * t101 + t102 + 0.007142857142857143 * (t100 - rp_aangle * t84);
            const real t104 = cos_q[j] * (t99 - t89 - t72[j]) + t103 + sin_q[j] * (t96 - t57 - t86 - t51[j]);
            R_x[11 * 8 + j] = t104 - t88; /* R_x(5,5) */
            const real t105 = t15 * t24[j];
            const real t106 = 0.6 * (t14 * t105);
            R_v[0 * 8 + j] = R_v[21 * 8 + j] = t106; /* R_v(0,0) R_v(3,3) */
            const real t107 = t5 * t24[j];
            const real t108 = 0.3 * (t10 * t105 - t14 * t107);
            R_v[1 * 8 + j] = R_v[6 * 8 + j] = R_v[22 * 8 + j] = R_v[27 * 8 + j] = t108;
                /* R_v(0,1) R_v(1,0) R_v(3,4) R_v(4,3) */
            const real t110 = 0.25 * t14 * t109[j];
            const real t112 = t29 - t111[j];
            const real t113 = cos_p[j] * t112;
            const real t114 = t12 * t32[j];
            const real t115 = 0.05238095238095238 * t114;
            const real t116 = 0.3 * (t105 * t25);
            R_v[2 * 8 + j] = t110 + t113 - t115 - t116; /* R_v(0,2) */
            R_v[3 * 8 + j] = R_v[18 * 8 + j] = -t106; /* R_v(0,3) R_v(3,0) */
            R_v[4 * 8 + j] = R_v[9 * 8 + j] = R_v[19 * 8 + j] = R_v[24 * 8 + j] = -t108;
                /* R_v(0,4) R_v(1,3) R_v(3,1) R_v(4,0) */
            const real t118 = t117[j] + t29;
            const real t119 = cos_q[j] * t118;
            const real t120 = t13 * t32[j];
            const real t121 = 0.030952380952380953 * t120 + t110;
            const real t122 = 0.3 * (t105 * t42);
            R_v[5 * 8 + j] = t119 + t121 - t122; /* R_v(0,5) */
            const real t123 = 0.6 * (t10 * t107);
            R_v[10 * 8 + j] = R_v[25 * 8 + j] = t123; /* R_v(1,4) R_v(4,1) */
            R_v[7 * 8 + j] = R_v[28 * 8 + j] = -t123; /* R_v(1,1) R_v(4,4) */
            const real t124 = 0.3 * (t107 * t25);
            const real t125 = 0.25 * t10 * t109[j];
            const real t126 = sin_p[j] * t112;
            const real t127 = 0.05238095238095238 * t34;
            R_v[8 * 8 + j] = t125 + t126 + t124 - t127; /* R_v(1,2) */
            const real t128 = 0.3 * (t107 * t42);
            const real t129 = 0.030952380952380953 * t37;
            const real t130 = sin_q[j] * t118;
            R_v[11 * 8 + j] = t129 + t130 + t125 + t128; /* R_v(1,5) */
            R_v[12 * 8 + j] = t110 + t116 - t115 - t113; /* R_v(2,0) */
            R_v[13 * 8 + j] = t125 - t127 - t126 - t124; /* R_v(2,1) */
            const real t133 = 0.01904761904761905 * (cos_p[j] * t132[j] - t12 * t55[j]);
            const real t138 = 0.01904761904761905 * (t55[j] * (sin_p[j] * t12 - cos_p[j] * t8));
            const real t143 = sin_p[j] * t55[j];
            const real t144 = 0.01904761904761905 * (rp_vangle * t143 - sin_p[j] * t132[j]);
            R_v[14 * 8 + j] = t138 + cos_p[j] * (t142[j] + t144 + t140[j] - t52[j]) + sin_p[j] * (t131[j] + t133
                - t135[j] - t137[j]); /* R_v(2,2) */
            const real t146 = t145[j] + t29;
            const real t147 = cos_p[j] * t146;
            const real t148 = 0.030952380952380953 * t114;
            R_v[15 * 8 + j] = t147 - t148 - t116 - t110; /* R_v(2,3) */
            const real t149 = sin_p[j] * t146 + t124;
            const real t150 = 0.030952380952380953 * t34;
            R_v[16 * 8 + j] = t149 - t150 - t125; /* R_v(2,4) */
            const real t151 = t12 * t56;
            const real t152 = t55[j] * (cos_q[j] * t8 + cos_p[j] * t9) - t151 - sin_p[j] * t65;
            const real t153 = 0.007142857142857143 * t152;
            const real t154 = 0.007142857142857143 * (t60[j] * t81);
            const real t155 = 0.007142857142857143 * t151;
            const real t156 = 0.25 * t109[j] * t25;
            const real t157 = 0.007142857142857143 * (t13 * t143);
            const real t158 = 0.007142857142857143 * (t132[j] * t64);
            const real t159 = 0.25 * t109[j] * t42;
            R_v[17 * 8 + j] = t155 + t156 + t154 + t153 - t157 - t158 - t159; /* R_v(2,5) */
            R_v[20 * 8 + j] = t116 - t110 - t148 - t147; /* R_v(3,2) */
            const real t160 = 0.05238095238095238 * t120;
            const real t162 = t161[j] - t29;
            const real t163 = cos_q[j] * t162;
            R_v[23 * 8 + j] = t160 + t163 + t122 - t110; /* R_v(3,5) */
            R_v[26 * 8 + j] = -(t150 + t149 + t125); /* R_v(4,2) */
            const real t164 = 0.05238095238095238 * t37;
            const real t165 = sin_q[j] * t162;
            R_v[29 * 8 + j] = t164 + t165 - t125 - t128; /* R_v(4,5) */
            R_v[30 * 8 + j] = t122 + t121 - t119; /* R_v(5,0) */
            R_v[31 * 8 + j] = t129 + t125 - t130 - t128; /* R_v(5,1) */
            R_v[32 * 8 + j] = t157 + t159 + t153 + t158 - t155 - t154 - t156; /* R_v(5,2) */
            R_v[33 * 8 + j] = t160 - t163 - t122 - t110; /* R_v(5,3) */
            R_v[34 * 8 + j] = t164 + t128 - t165 - t125; /* R_v(5,4) */
            const real t168 = 0.01904761904761905 * (cos_q[j] * t60[j] - rq_vangle * t82);
            const real t170 = 0.01904761904761905 * (t55[j] * (sin_q[j] * t13 - cos_q[j] * t9));
            const real t171 = 0.01904761904761905 * (rq_vangle * t56 - sin_q[j] * t60[j]);
            R_v[35 * 8 + j] = t170 + cos_q[j] * (t94[j] + t171 - t172[j] - t173[j]) + sin_q[j] * (t167[j] + t168
                + t166[j] - t169[j]); /* R_v(5,5) */
        }
    }
}

const flexel_element flexel_planar_beam_first_order = {
    .name = "planar_beam_first_order",
    .digest = "fe1610ecc31c49af",
    .n = 6,
    .m = 3,
    .k = 0,
    .np = 8,
    .position = planar_beam_first_order_position,
    .acceleration = planar_beam_first_order_acceleration,
    .rates = planar_beam_first_order_rates,
    .kinematics = planar_beam_first_order_kinematics,
    .stiffness = planar_beam_first_order_stiffness,
    .inertia = planar_beam_first_order_inertia,
    .tangent = planar_beam_first_order_tangent,
};
