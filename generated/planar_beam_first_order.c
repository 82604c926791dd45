/* planar_beam_first_order: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
 * d = xq - xp, l = |d|, el = d/l;  b1 = l - l0,  b5 = l0 ey_p.el,  b6 = -l0 ey_q.el
 * elongation = b1,  bend1 = b5,  bend2 = b6
 * phi_y = 12 EIz/(GAy l0^2): shear number
 * T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
 *    the shear-corrected (phi_y) cubic shapes
 * U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)
 * f = De'sigma: force_p, moment_p = -(ex_p.f_xp, ey_p.f_xp), -f_angle_p; force_q, moment_q the same at q, without
 *   minus
 * axis: places on the cubic axis; across: ey_p, ey_q
 * shear_angle = |phi_y/(1 + phi_y) (bend1 - bend2)|/(2 l0)
 * ranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; shear_angle, sin(shear_angle)^2
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), PLBEAM, PLBEAMNL; signs of the spatial beam's b5, b6; Meijaard
 *   1996, Nonlinear Dyn. 9
 *
 * x (6): p_x, p_y, rp_angle, q_x, q_y, rq_angle
 * e (3): elongation [m], bend1 [m], bend2 [m]
 * s (0): none
 * p (9):
 *   l0 (1) [m]: undeformed length
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   alphaq0 (1) [rad]: initial direction of the element minus the angle of node q
 *   rhoA (1) [kg/m]: mass per length
 *   rhoJ (1) [kg m]: mass moment of inertia of the section per length
 *   EIz (1) [N m^2]: bending stiffness about z, of the deflection in y
 *   GAy (1) [N]: shear stiffness k G A of the deflection in y; very large without shear
 *   gravity (2) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* position: 65 operations.
 * in:  x (6), p (9)
 * out: e (3), De (3,6), 14 of 18 entries, V (0,6) */
FLEXEL_CLONES
static void planar_beam_first_order_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (9 * 8);
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
 * in:  x (6), v (6), p (9)
 * out: g (3), gs (0) */
FLEXEL_CLONES
static void planar_beam_first_order_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
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
 * in:  x (6), v (6), p (9)
 * out: Phi_x (3,6), 14 of 18 entries */
FLEXEL_CLONES
static void planar_beam_first_order_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
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
 * in:  x (6), v (6), a (6), p (9)
 * out: Psi_x (3,6), 14 of 18 entries, Psi_v (3,6), 14 of 18 entries */
FLEXEL_CLONES
static void planar_beam_first_order_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
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
 * in:  x (6), sigma (3), tau (0), p (9)
 * out: K (6,6), 34 of 36 entries */
FLEXEL_CLONES
static void planar_beam_first_order_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
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

/* inertia: 321 operations.
 * in:  x (6), v (6), p (9)
 * out: M (6,6), h (6), f (6), U (1) */
FLEXEL_CLONES
static void planar_beam_first_order_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict M = out[0] + b * (36 * 8);
        real *restrict h = out[1] + b * (6 * 8);
        real *restrict f = out[2] + b * (6 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real t0[8], t1[8], t2[8], sin_p[8], t3[8], sin_q[8], d_x[8], d_y[8], t5[8], t9[8], t10[8], cos_p[8], cos_q[8],
            t16[8], t17[8], t19[8], t21[8], t27[8], t30[8], t32[8], t41[8], t42[8], t44[8], t47[8], t48[8], t60[8],
            t63[8], t67[8], t69[8], t70[8], t71[8], t74[8], t75[8], t80[8], t82[8], t83[8], t88[8], t90[8], t91[8],
            t92[8], t97[8], t101[8], t102[8], t103[8], t105[8];
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
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real l = real_sqrt(d_x[j] * d_x[j] + d_y[j] * d_y[j]);
            t5[j] = 1.0 / l;
            const real t6 = t5[j] * t5[j];
            const real t7 = 1.0 / l0;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t8 = 1.0 / GAy * EIz * t7 * t7;
            const real phi_y = 12.0 * t8;
            const real rhoJ = p[4 * 8 + j];
            t9[j] = 1.0 / (1.0 + phi_y) * (1.0 / (1.0 + phi_y)) * l0 * rhoJ;
            t10[j] = t6 * t9[j];
            t16[j] = (phi_y - 0.2) * t9[j];
            t17[j] = t5[j] * t16[j];
            t19[j] = l0 * t0[j];
            t21[j] = 0.12857142857142856 * t0[j];
            t27[j] = l0 * l0 * t0[j];
            const real t29 = 0.13333333333333333 + 12.0 * (t8 * (0.16666666666666666 + 4.0 * t8));
            t30[j] = 0.5 * t29 * t9[j];
            const real t31 = 24.0 * (t8 * (2.0 * t8 - 0.16666666666666666)) - 0.06666666666666667;
            t32[j] = 0.5 * t31 * t9[j];
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t41[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t42[j] = q_vx - p_vx;
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t44[j] = 0.25 * (rp_vangle + rq_vangle) * t16[j];
            t47[j] = t5[j] * t6;
            t48[j] = t47[j] * (d_x[j] * t42[j] + d_y[j] * t41[j]);
            t60[j] = rq_vangle * t19[j];
            t63[j] = rp_vangle * t19[j];
            t67[j] = rp_vangle * t27[j];
            t69[j] = rp_vangle * rp_vangle * t27[j];
            t70[j] = 0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy;
            t71[j] = t63[j] * t70[j];
            t74[j] = rq_vangle * t27[j];
            t75[j] = rp_vangle * t74[j];
            t80[j] = 0.030952380952380953 * q_vx + 0.05238095238095238 * p_vx;
            t82[j] = t63[j] * t80[j];
            t83[j] = rp_vangle * rq_vangle;
            t88[j] = 0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy;
            t90[j] = 0.05238095238095238 * q_vx + 0.030952380952380953 * p_vx;
            t91[j] = rq_vangle * rq_vangle * t27[j];
            t92[j] = t60[j] * t88[j];
            t97[j] = t60[j] * t90[j];
            const real gravity_x = p[7 * 8 + j];
            const real t99 = gravity_x * t0[j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * t99;
            const real gravity_y = p[8 * 8 + j];
            const real t100 = gravity_y * t0[j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * t100;
            t101[j] = l0 * t100;
            t102[j] = l0 * t99;
            t103[j] = 0.5 * (p_x + q_x);
            t105[j] = 0.5 * (p_y + q_y);
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
            const real t11 = t4 * t10[j];
            const real t12 = 0.3 * (t4 * t11);
            M[0 * 8 + j] = M[21 * 8 + j] = t1[j] + t12; /* M(0,0) M(3,3) */
            const real t13 = cos_p[j] + cos_q[j];
            const real t14 = t13 * t10[j];
            const real t15 = 0.3 * (t4 * t14);
            M[4 * 8 + j] = M[24 * 8 + j] = t15; /* M(0,4) M(4,0) */
            M[1 * 8 + j] = M[6 * 8 + j] = M[22 * 8 + j] = M[27 * 8 + j] = -t15; /* M(0,1) M(1,0) M(3,4) M(4,3) */
            const real t18 = 0.25 * t4 * t17[j];
            const real t20 = sin_p[j] * t19[j];
            M[2 * 8 + j] = M[12 * 8 + j] = t18 - 0.05238095238095238 * t20; /* M(0,2) M(2,0) */
            M[3 * 8 + j] = M[18 * 8 + j] = t21[j] - t12; /* M(0,3) M(3,0) */
            const real t22 = sin_q[j] * t19[j];
            M[5 * 8 + j] = M[30 * 8 + j] = 0.030952380952380953 * t22 + t18; /* M(0,5) M(5,0) */
            const real t23 = 0.3 * (t13 * t14);
            M[7 * 8 + j] = M[28 * 8 + j] = t1[j] + t23; /* M(1,1) M(4,4) */
            const real t24 = cos_p[j] * t19[j];
            const real t25 = 0.25 * t13 * t17[j];
            M[8 * 8 + j] = M[13 * 8 + j] = 0.05238095238095238 * t24 - t25; /* M(1,2) M(2,1) */
            M[9 * 8 + j] = M[19 * 8 + j] = 0.3 * (t13 * t11); /* M(1,3) M(3,1) */
            M[10 * 8 + j] = M[25 * 8 + j] = t21[j] - t23; /* M(1,4) M(4,1) */
            const real t26 = cos_q[j] * t19[j];
            M[11 * 8 + j] = M[31 * 8 + j] = -(0.030952380952380953 * t26 + t25); /* M(1,5) M(5,1) */
            const real t28 = 0.004761904761904762 * (t27[j] * (cos_p[j] * cos_p[j] + sin_p[j] * sin_p[j]));
            M[14 * 8 + j] = 2.0 * (t28 + t30[j]); /* M(2,2) */
            M[15 * 8 + j] = M[20 * 8 + j] = -(0.030952380952380953 * t20 + t18); /* M(2,3) M(3,2) */
            M[16 * 8 + j] = M[26 * 8 + j] = 0.030952380952380953 * t24 + t25; /* M(2,4) M(4,2) */
            const real t33 = sin_q[j] * t27[j];
            const real t34 = 0.007142857142857143 * (sin_p[j] * t33 + cos_p[j] * cos_q[j] * t27[j]);
            M[17 * 8 + j] = M[32 * 8 + j] = t32[j] - t34; /* M(2,5) M(5,2) */
            M[23 * 8 + j] = M[33 * 8 + j] = 0.05238095238095238 * t22 - t18; /* M(3,5) M(5,3) */
            M[29 * 8 + j] = M[34 * 8 + j] = t25 - 0.05238095238095238 * t26; /* M(4,5) M(5,4) */
            const real t35 = 0.004761904761904762 * (t27[j] * (cos_q[j] * cos_q[j] + sin_q[j] * sin_q[j]));
            M[35 * 8 + j] = 2.0 * (t35 + t30[j]); /* M(5,5) */
            const real rq_vangle = v[5 * 8 + j];
            const real t36 = rq_vangle * cos_q[j];
            const real t37 = t36 * t19[j];
            const real t38 = rq_vangle * t37;
            const real rp_vangle = v[2 * 8 + j];
            const real t39 = rp_vangle * cos_p[j];
            const real t40 = t39 + t36;
            const real t43 = t13 * t41[j] - t42[j] * t4;
            const real t45 = 0.3 * (t5[j] * t43 * t9[j]) + t44[j];
            const real t46 = t5[j] * t45;
            const real t49 = rp_vangle * sin_p[j];
            const real t50 = rq_vangle * sin_q[j];
            const real t51 = t49 + t50;
            const real t52 = t5[j] * (t41[j] * t51 + t42[j] * t40) + t43 * t48[j];
            const real t53 = t48[j] * t45 + 0.3 * (t5[j] * t52 * t9[j]);
            const real t54 = t40 * t46 - t4 * t53;
            const real t55 = t39 * t19[j];
            const real t56 = rp_vangle * t55;
            const real t57 = 0.030952380952380953 * t38 + t54 - 0.05238095238095238 * t56;
            const real t58 = t43 * t45 * t47[j];
            const real t59 = d_x[j] * t58;
            h[0 * 8 + j] = t57 - t59;
            const real t61 = t50 * t60[j];
            const real t62 = t51 * t46 + t13 * t53;
            const real t64 = t49 * t63[j];
            const real t65 = 0.030952380952380953 * t61 + t62 - 0.05238095238095238 * t64;
            const real t66 = d_y[j] * t58;
            h[1 * 8 + j] = t65 - t66;
            const real t68 = 0.01904761904761905 * ((sin_p[j] * t39 - cos_p[j] * t49) * t67[j]);
            const real t72 = t41[j] * t46;
            const real t73 = t71[j] + t72 + 0.009523809523809525 * (cos_p[j] * t69[j]);
            const real t76 = sin_p[j] * (t73 - 0.007142857142857143 * (cos_q[j] * t75[j]));
            const real t77 = cos_q[j] * t49 + cos_p[j] * t50;
            const real t78 = t39 * t33 + sin_p[j] * t27[j] * t36;
            const real t79 = t76 + 0.007142857142857143 * (t74[j] * t77 - rq_vangle * t78);
            const real t81 = 0.25 * t52 * t16[j];
            const real t84 = 0.009523809523809525 * (sin_p[j] * t69[j]) - t82[j] - 0.007142857142857143 * (t83[j]
                * t33);
            const real t85 = t42[j] * t46;
            h[2 * 8 + j] = t68 + t79 - t49 * t19[j] * t70[j] - t55 * t80[j] - t81 - cos_p[j] * (t84 - t85);
            const real t86 = 0.05238095238095238 * t38 + t59 - 0.030952380952380953 * t56;
            h[3 * 8 + j] = t86 - t54;
            const real t87 = 0.05238095238095238 * t61 + t66 - 0.030952380952380953 * t64;
            h[4 * 8 + j] = t87 - t62;
            const real t89 = 0.007142857142857143 * (rp_vangle * (t27[j] * t77 - t78));
            const real t93 = 0.009523809523809525 * (cos_q[j] * t91[j]) + t72 - t92[j];
            const real t94 = sin_q[j] * (t93 - 0.007142857142857143 * (cos_p[j] * t75[j]));
            const real t95 = 0.01904761904761905 * (t74[j] * (sin_q[j] * t36 - cos_q[j] * t50));
            const real t96 = t94 + t95 + t37 * t90[j] + t89 + t50 * t19[j] * t88[j] - t81;
            const real t98 = 0.009523809523809525 * (sin_q[j] * t91[j]) + t97[j] - 0.007142857142857143 * (sin_p[j]
                * t83[j] * t27[j]);
            h[5 * 8 + j] = t96 - cos_q[j] * (t98 - t85);
            f[2 * 8 + j] = 0.08333333333333333 * (cos_p[j] * t101[j] - sin_p[j] * t102[j]);
            f[5 * 8 + j] = 0.08333333333333333 * (sin_q[j] * t102[j] - cos_q[j] * t101[j]);
            const real l0 = p[0 * 8 + j];
            const real t104 = t103[j] + 0.08333333333333333 * (l0 * (cos_p[j] - cos_q[j]));
            const real gravity_x = p[7 * 8 + j];
            const real t106 = t105[j] + 0.08333333333333333 * (l0 * (sin_p[j] - sin_q[j]));
            const real gravity_y = p[8 * 8 + j];
            U[0 * 8 + j] = -((gravity_x * t104 + gravity_y * t106) * t0[j]);
        }
    }
}

/* tangent: 751 operations.
 * in:  x (6), v (6), a (6), p (9)
 * out: R_x (6,6), R_v (6,6) */
FLEXEL_CLONES
static void planar_beam_first_order_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict R_x = out[0] + b * (36 * 8);
        real *restrict R_v = out[1] + b * (36 * 8);
        real d_x[8], d_y[8], t0[8], t1[8], t2[8], cos_p[8], t3[8], cos_q[8], t5[8], t6[8], sin_p[8], sin_q[8], t10[8],
            t11[8], t12[8], t17[8], t18[8], t19[8], t21[8], t22[8], t23[8], t30[8], t34[8], t36[8], t46[8], t48[8],
            t52[8], t53[8], t54[8], t56[8], t57[8], t63[8], t68[8], t70[8], t74[8], t77[8], t83[8], t86[8], t102[8],
            t107[8], t108[8], t109[8], t110[8], t114[8], t125[8], t129[8], t131[8], t132[8], t133[8], t139[8],
            t143[8], t149[8], t151[8], t153[8], t155[8], t160[8], t162[8], t168[8], t170[8], t173[8], t179[8],
            t180[8], t232[8], t236[8], t238[8], t262[8], t264[8], t265[8], t267[8];
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
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t3[j] = rq_angle + alphaq0;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t5[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t6[j] = q_vx - p_vx;
            const real GAy = p[6 * 8 + j];
            const real l0 = p[0 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real phi_y = 12.0 * (1.0 / GAy * (1.0 / l0 * (1.0 / l0) * EIz));
            const real t9 = 1.0 / (1.0 + phi_y);
            const real rhoJ = p[4 * 8 + j];
            t10[j] = l0 * rhoJ * t9 * t9;
            t11[j] = (phi_y - 0.2) * t10[j];
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t12[j] = 0.25 * t11[j] * (rp_vangle + rq_vangle);
            t17[j] = t0[j] * t1[j];
            t18[j] = t6[j] * t17[j];
            t19[j] = t0[j] * t10[j];
            t21[j] = d_x[j] * t17[j];
            const real rp_aangle = a[2 * 8 + j];
            const real rq_aangle = a[5 * 8 + j];
            t22[j] = 0.25 * t11[j] * (rp_aangle + rq_aangle);
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t23[j] = q_ay - p_ay;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t30[j] = q_ax - p_ax;
            const real t32 = d_x[j] * t6[j] + d_y[j] * t5[j];
            const real t33 = t0[j] * t32;
            t34[j] = t1[j] * t33;
            t36[j] = 4.0 * t0[j] * t33 + 2.0 * t1[j] * t32;
            t46[j] = t5[j] * t17[j];
            t48[j] = d_y[j] * t17[j];
            t52[j] = t34[j] * t19[j];
            t53[j] = t0[j] * t30[j];
            t54[j] = t0[j] * t5[j];
            const real t55 = t0[j] * t23[j];
            t56[j] = t0[j] * t6[j];
            t57[j] = t55 - rp_vangle * t56[j];
            t63[j] = t0[j] * t19[j];
            const real rhoA = p[3 * 8 + j];
            const real t67 = l0 * rhoA;
            t68[j] = l0 * t67;
            const real t69 = rp_aangle * t68[j];
            t70[j] = 0.05238095238095238 * t69;
            const real t73 = rp_vangle * t68[j];
            t74[j] = 0.05238095238095238 * t73;
            t77[j] = t55 - rq_vangle * t56[j];
            const real t82 = rq_aangle * t68[j];
            t83[j] = 0.030952380952380953 * t82;
            const real t85 = rq_vangle * t68[j];
            t86[j] = 0.030952380952380953 * t85;
            t102[j] = l0 * l0 * t67;
            const real t106 = 0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy;
            const real gravity_x = p[7 * 8 + j];
            t107[j] = 0.08333333333333333 * (gravity_x * t68[j]);
            t108[j] = t73 * t106 + t107[j];
            t109[j] = rq_vangle * t102[j];
            t110[j] = rp_vangle * t109[j];
            t114[j] = t68[j] * (0.05238095238095238 * p_ax + 0.030952380952380953 * q_ax);
            const real t123 = q_vy * t68[j];
            const real t124 = p_vy * t68[j];
            t125[j] = 0.030952380952380953 * t123 + 0.05238095238095238 * t124;
            const real t128 = p_ay * t68[j];
            t129[j] = 0.05238095238095238 * t128;
            const real t130 = q_ay * t68[j];
            t131[j] = 0.030952380952380953 * t130;
            t132[j] = rp_vangle * rq_vangle;
            t133[j] = rq_aangle * t102[j];
            const real gravity_y = p[8 * 8 + j];
            t139[j] = 0.08333333333333333 * (gravity_y * t68[j]);
            t143[j] = t132[j] * t102[j];
            t149[j] = 0.030952380952380953 * t73;
            t151[j] = 0.030952380952380953 * t69;
            t153[j] = 0.05238095238095238 * t82;
            t155[j] = 0.05238095238095238 * t85;
            t160[j] = rp_vangle * t102[j];
            t162[j] = rp_aangle * t102[j];
            t168[j] = 0.05238095238095238 * t123 + 0.030952380952380953 * t124;
            t170[j] = t68[j] * (0.030952380952380953 * p_ax + 0.05238095238095238 * q_ax);
            const real t172 = 0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy;
            t173[j] = t85 * t172;
            t179[j] = 0.030952380952380953 * t128;
            t180[j] = 0.05238095238095238 * t130;
            t232[j] = t68[j] * t106;
            const real t234 = q_vx * t68[j];
            const real t235 = p_vx * t68[j];
            t236[j] = 0.030952380952380953 * t234 + 0.05238095238095238 * t235;
            t238[j] = t68[j] * (0.030952380952380953 * q_vx + 0.05238095238095238 * p_vx);
            t262[j] = t68[j] * (0.05238095238095238 * q_vx + 0.030952380952380953 * p_vx);
            t264[j] = 0.030952380952380953 * t235;
            t265[j] = 0.05238095238095238 * t234;
            t267[j] = t68[j] * t172;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t2[j]);
            cos_q[j] = real_cos(t3[j]);
            sin_p[j] = real_sin(t2[j]);
            sin_q[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t4 = cos_p[j] + cos_q[j];
            const real t7 = sin_p[j] + sin_q[j];
            const real t8 = t4 * t5[j] - t6[j] * t7;
            const real t13 = t0[j] * t8;
            const real t14 = t12[j] + 0.3 * (t13 * t10[j]);
            const real t15 = t8 * t14 * t1[j];
            const real t16 = t0[j] * t15;
            const real t20 = t8 * t18[j];
            const real rp_vangle = v[2 * 8 + j];
            const real t24 = rp_vangle * sin_p[j];
            const real rq_vangle = v[5 * 8 + j];
            const real t25 = rq_vangle * sin_q[j];
            const real t26 = t24 + t25;
            const real t27 = rp_vangle * cos_p[j];
            const real t28 = rq_vangle * cos_q[j];
            const real t29 = t27 + t28;
            const real t31 = t4 * t23[j] - t5[j] * t26 - t6[j] * t29 - t7 * t30[j];
            const real t35 = t22[j] + 0.3 * (t10[j] * (t0[j] * t31 - t8 * t34[j]));
            const real t37 = t31 - 0.5 * t8 * t36[j];
            const real t38 = t8 * t10[j];
            const real t39 = t35 + 0.3 * (t19[j] * t37 - t34[j] * t38) - 0.5 * t36[j] * t14;
            const real t40 = 0.3 * (t19[j] * t20) + t21[j] * t39 + t14 * t18[j];
            const real t41 = t13 * t1[j];
            const real t42 = 0.3 * (t38 * t41) + 3.0 * t15;
            const real t43 = t14 + 0.3 * (t0[j] * t38);
            const real t44 = d_x[j] * t42 - t29 * t43;
            const real t45 = t16 + t7 * t40 - t21[j] * t44;
            R_x[0 * 8 + j] = R_x[21 * 8 + j] = t45; /* R_x(0,0) R_x(3,3) */
            const real t47 = t8 * t46[j];
            const real t49 = 0.3 * (t19[j] * t47) + t48[j] * t39 + t14 * t46[j];
            const real t50 = t7 * t49 - t48[j] * t44;
            R_x[1 * 8 + j] = R_x[22 * 8 + j] = t50; /* R_x(0,1) R_x(3,4) */
            const real t51 = sin_p[j] * t5[j] + cos_p[j] * t6[j];
            const real t58 = t34[j] * t51 - cos_p[j] * t53[j] - t27 * t54[j] - sin_p[j] * t57[j];
            const real t59 = t51 * t52[j] + t19[j] * t58;
            const real t60 = 0.3 * (t7 * t59);
            const real t61 = t17[j] * t14;
            const real t62 = 0.3 * (t19[j] * t41) + t61;
            const real t64 = d_x[j] * t62 - 0.3 * (t29 * t63[j]);
            const real t65 = t51 * t64;
            const real t66 = t0[j] * t35 - t34[j] * t14;
            const real t71 = t66 - t70[j];
            const real t72 = t0[j] * t14;
            const real t75 = t72 - t74[j];
            R_x[2 * 8 + j] = t65 + cos_p[j] * t71 + t60 - t24 * t75; /* R_x(0,2) */
            R_x[3 * 8 + j] = R_x[18 * 8 + j] = -t45; /* R_x(0,3) R_x(3,0) */
            R_x[4 * 8 + j] = R_x[19 * 8 + j] = -t50; /* R_x(0,4) R_x(3,1) */
            const real t76 = sin_q[j] * t5[j] + cos_q[j] * t6[j];
            const real t78 = t34[j] * t76 - cos_q[j] * t53[j] - t28 * t54[j] - sin_q[j] * t77[j];
            const real t79 = t76 * t52[j] + t19[j] * t78;
            const real t80 = 0.3 * (t7 * t79);
            const real t81 = t76 * t64;
            const real t84 = t83[j] + t66;
            const real t87 = t86[j] + t72;
            R_x[5 * 8 + j] = t81 + cos_q[j] * t84 + t80 - t25 * t87; /* R_x(0,5) */
            const real t88 = d_y[j] * t42 - t26 * t43;
            const real t89 = t21[j] * t88 + t4 * t40;
            R_x[9 * 8 + j] = R_x[24 * 8 + j] = t89; /* R_x(1,3) R_x(4,0) */
            R_x[6 * 8 + j] = R_x[27 * 8 + j] = -t89; /* R_x(1,0) R_x(4,3) */
            const real t90 = t16 - t48[j] * t88 - t4 * t49;
            R_x[7 * 8 + j] = R_x[28 * 8 + j] = t90; /* R_x(1,1) R_x(4,4) */
            const real t91 = d_y[j] * t62 - 0.3 * (t26 * t63[j]);
            const real t92 = t51 * t91;
            const real t93 = 0.3 * (t4 * t59);
            R_x[8 * 8 + j] = t92 + sin_p[j] * t71 + t27 * t75 - t93; /* R_x(1,2) */
            R_x[10 * 8 + j] = R_x[25 * 8 + j] = -t90; /* R_x(1,4) R_x(4,1) */
            const real t94 = t76 * t91;
            const real t95 = 0.3 * (t4 * t79);
            R_x[11 * 8 + j] = t94 + sin_q[j] * t84 + t28 * t87 - t95; /* R_x(1,5) */
            const real t96 = 0.25 * t11[j] * t20;
            const real t97 = 0.25 * t11[j] * t37;
            const real t98 = t97 + t51 * t43;
            const real t99 = t96 + t21[j] * t98;
            R_x[12 * 8 + j] = t99; /* R_x(2,0) */
            const real t100 = 0.25 * t11[j] * t47;
            const real t101 = t100 + t48[j] * t98;
            R_x[13 * 8 + j] = t101; /* R_x(2,1) */
            const real t103 = sin_p[j] * t102[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t104 = rp_aangle * t103;
            const real t105 = t5[j] * t72;
            const real t111 = sin_q[j] * t102[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t112 = rq_aangle * t111;
            const real t113 = t105 + t108[j] + 0.01904761904761905 * t104 - 0.007142857142857143 * (cos_q[j] * t110[j]
                + t112);
            const real t115 = t27 * t102[j];
            const real t116 = cos_p[j] * t102[j];
            const real t117 = 0.01904761904761905 * (rp_vangle * (cos_p[j] * t115 - t27 * t116));
            const real t118 = 0.25 * t11[j] * t58;
            const real t119 = cos_q[j] * t27;
            const real t120 = t28 * t102[j];
            const real t121 = cos_p[j] * t120;
            const real t122 = 0.007142857142857143 * (t109[j] * t119 - rq_vangle * t121);
            const real t126 = t118 + t122 + t117 + cos_p[j] * (t113 - t114[j]) - t27 * t125[j];
            const real t127 = t6[j] * t72;
            const real t134 = rp_vangle * t111;
            const real t135 = t132[j] * t111 + t25 * t109[j] - cos_q[j] * t133[j] - rq_vangle * t134;
            const real t136 = rp_vangle * t103;
            const real t137 = 0.01904761904761905 * (rp_aangle * t116 + rp_vangle * (t136 - t24 * t102[j]));
            const real t138 = 0.007142857142857143 * t135 + t137 + t131[j] + t129[j] + t127;
            const real t140 = t51 * t63[j];
            R_x[14 * 8 + j] = t126 - sin_p[j] * (t138 - t139[j]) - 0.3 * (t51 * t140); /* R_x(2,2) */
            R_x[15 * 8 + j] = -t99; /* R_x(2,3) */
            R_x[16 * 8 + j] = -t101; /* R_x(2,4) */
            const real t141 = 0.25 * t11[j] * t78;
            const real t142 = cos_p[j] * t28;
            const real t144 = t109[j] * t142 + cos_q[j] * (cos_p[j] * t143[j] - rq_aangle * t103);
            const real t145 = cos_q[j] * t115;
            const real t146 = rq_vangle * t103;
            const real t147 = t24 * t109[j] - sin_p[j] * t110[j] - cos_p[j] * t133[j] - rq_vangle * t146;
            const real t148 = 0.007142857142857143 * (t144 - rq_vangle * t145 - sin_q[j] * t147);
            R_x[17 * 8 + j] = t141 + t148 - 0.3 * (t76 * t140); /* R_x(2,5) */
            const real t150 = t149[j] + t72;
            const real t152 = t151[j] + t66;
            R_x[20 * 8 + j] = t24 * t150 - cos_p[j] * t152 - t65 - t60; /* R_x(3,2) */
            const real t154 = t153[j] - t66;
            const real t156 = t155[j] - t72;
            R_x[23 * 8 + j] = cos_q[j] * t154 - t25 * t156 - t81 - t80; /* R_x(3,5) */
            R_x[26 * 8 + j] = t93 - t27 * t150 - sin_p[j] * t152 - t92; /* R_x(4,2) */
            R_x[29 * 8 + j] = t95 + sin_q[j] * t154 + t28 * t156 - t94; /* R_x(4,5) */
            const real t157 = t97 + t76 * t43;
            const real t158 = t96 + t21[j] * t157;
            R_x[30 * 8 + j] = t158; /* R_x(5,0) */
            const real t159 = t100 + t48[j] * t157;
            R_x[31 * 8 + j] = t159; /* R_x(5,1) */
            const real t161 = t160[j] * t119 + cos_p[j] * (cos_q[j] * t143[j] - rp_aangle * t111);
            const real t163 = t25 * t160[j] - sin_q[j] * t110[j] - cos_q[j] * t162[j] - rp_vangle * t134;
            const real t164 = 0.007142857142857143 * (t161 - rp_vangle * t121 - sin_p[j] * t163);
            const real t165 = t76 * t63[j];
            R_x[32 * 8 + j] = t118 + t164 - 0.3 * (t51 * t165); /* R_x(5,2) */
            R_x[33 * 8 + j] = -t158; /* R_x(5,3) */
            R_x[34 * 8 + j] = -t159; /* R_x(5,4) */
            const real t166 = cos_q[j] * t102[j];
            const real t167 = 0.01904761904761905 * (rq_vangle * (cos_q[j] * t120 - t28 * t166));
            const real t169 = 0.007142857142857143 * (t160[j] * t142 - rp_vangle * t145);
            const real t171 = t105 + t170[j] + 0.01904761904761905 * t112 - 0.007142857142857143 * (cos_p[j] * t110[j]
                + t104);
            const real t174 = t141 + t169 + cos_q[j] * (t171 - t173[j] - t107[j]) + t28 * t168[j];
            const real t175 = sin_p[j] * t132[j] * t102[j] + t24 * t160[j] - cos_p[j] * t162[j];
            const real t176 = rq_vangle * t111;
            const real t177 = 0.01904761904761905 * (rq_aangle * t166 + rq_vangle * (t176 - t25 * t102[j]));
            const real t178 = 0.007142857142857143 * (t175 - rp_vangle * t146) + t177 + t139[j];
            const real t181 = t167 + t174 - sin_q[j] * (t127 + t178 - t179[j] - t180[j]);
            R_x[35 * 8 + j] = t181 - 0.3 * (t76 * t165); /* R_x(5,5) */
            const real t182 = t7 * t19[j];
            const real t183 = t8 * t17[j];
            const real t184 = d_x[j] * t183;
            const real t185 = t7 * t34[j];
            const real t186 = t0[j] * t29;
            const real t187 = t184 + t185 - t186;
            const real t188 = d_x[j] * t61;
            const real t189 = t185 - t186 - t184;
            const real t190 = 0.3 * (t19[j] * t189) - t188;
            const real t191 = 0.3 * (t182 * t187) + t7 * (t188 + t190);
            R_v[3 * 8 + j] = R_v[18 * 8 + j] = t191; /* R_v(0,3) R_v(3,0) */
            R_v[0 * 8 + j] = R_v[21 * 8 + j] = -t191; /* R_v(0,0) R_v(3,3) */
            const real t192 = t4 * t19[j];
            const real t193 = d_y[j] * t61;
            const real t194 = t0[j] * t26;
            const real t195 = d_y[j] * t183;
            const real t196 = t4 * t34[j];
            const real t197 = t194 + t195 + t196;
            const real t198 = t193 + 0.3 * (t19[j] * t197);
            const real t199 = 0.3 * (t192 * t187) + t7 * t198 + t4 * t188;
            R_v[1 * 8 + j] = R_v[22 * 8 + j] = t199; /* R_v(0,1) R_v(3,4) */
            const real t200 = cos_p[j] * t75;
            const real t201 = t27 * t68[j];
            const real t202 = 0.05238095238095238 * t201;
            const real t203 = t0[j] * t51;
            const real t204 = t19[j] * t203;
            const real t205 = 0.3 * (t7 * t204);
            const real t206 = 0.25 * t11[j] * t187;
            R_v[2 * 8 + j] = t200 - t202 - t205 - t206; /* R_v(0,2) */
            R_v[4 * 8 + j] = R_v[19 * 8 + j] = -t199; /* R_v(0,4) R_v(3,1) */
            const real t207 = t28 * t68[j];
            const real t208 = 0.030952380952380953 * t207;
            const real t209 = cos_q[j] * t87;
            const real t210 = t0[j] * t76;
            const real t211 = t19[j] * t210;
            const real t212 = 0.3 * (t7 * t211);
            R_v[5 * 8 + j] = t208 + t209 - t212 - t206; /* R_v(0,5) */
            const real t213 = t195 - t194 - t196;
            const real t214 = t4 * t190 - t7 * t193 - 0.3 * (t182 * t213);
            R_v[6 * 8 + j] = R_v[27 * 8 + j] = t214; /* R_v(1,0) R_v(4,3) */
            const real t215 = 0.3 * (t192 * t213) + t4 * (t193 - t198);
            R_v[7 * 8 + j] = R_v[28 * 8 + j] = t215; /* R_v(1,1) R_v(4,4) */
            const real t216 = 0.3 * (t4 * t204);
            const real t217 = sin_p[j] * t75;
            const real t218 = t24 * t68[j];
            const real t219 = 0.05238095238095238 * t218;
            const real t220 = 0.25 * t11[j] * t213;
            R_v[8 * 8 + j] = t216 + t217 - t219 - t220; /* R_v(1,2) */
            R_v[9 * 8 + j] = R_v[24 * 8 + j] = -t214; /* R_v(1,3) R_v(4,0) */
            R_v[10 * 8 + j] = R_v[25 * 8 + j] = -t215; /* R_v(1,4) R_v(4,1) */
            const real t221 = 0.3 * (t4 * t211);
            const real t222 = t25 * t68[j];
            const real t223 = 0.030952380952380953 * t222;
            const real t224 = sin_q[j] * t87;
            R_v[11 * 8 + j] = t223 + t224 + t221 - t220; /* R_v(1,5) */
            const real t225 = cos_p[j] * t56[j] + sin_p[j] * t54[j];
            const real t226 = 0.3 * (t225 * t182);
            const real t227 = 0.25 * t11[j] * t189;
            R_v[12 * 8 + j] = t226 - t202 - t200 - t227; /* R_v(2,0) */
            const real t228 = 0.25 * t11[j] * t197;
            const real t229 = 0.3 * (t225 * t192);
            R_v[13 * 8 + j] = t228 - t219 - t217 - t229; /* R_v(2,1) */
            const real t230 = 0.25 * t11[j] * t225;
            const real t231 = 0.01904761904761905 * (t102[j] * (sin_p[j] * t27 - cos_p[j] * t24));
            const real t233 = 0.01904761904761905 * (cos_p[j] * t160[j] - rp_vangle * t116);
            const real t237 = sin_p[j] * t160[j];
            const real t239 = cos_p[j] * (t236[j] + 0.01904761904761905 * (t136 - t237) - t238[j]);
            const real t240 = sin_p[j] * (t232[j] + t233 - t125[j]) + t239 + t231 + t230;
            const real t241 = 0.25 * t11[j] * t203;
            R_v[14 * 8 + j] = t240 - t241; /* R_v(2,2) */
            const real t242 = cos_p[j] * t150;
            const real t243 = 0.030952380952380953 * t201;
            R_v[15 * 8 + j] = t227 + t242 - t243 - t226; /* R_v(2,3) */
            const real t244 = sin_p[j] * t150;
            const real t245 = 0.030952380952380953 * t218;
            R_v[16 * 8 + j] = t229 + t244 - t245 - t228; /* R_v(2,4) */
            const real t246 = 0.007142857142857143 * (cos_p[j] * t134);
            const real t247 = 0.007142857142857143 * (cos_p[j] * sin_q[j] * t109[j]);
            const real t248 = t102[j] * (cos_q[j] * t24 + cos_p[j] * t25) - t27 * t111 - sin_p[j] * t120;
            const real t249 = 0.007142857142857143 * t248;
            const real t250 = 0.007142857142857143 * (cos_q[j] * t146);
            const real t251 = 0.007142857142857143 * (cos_q[j] * t237);
            const real t252 = 0.25 * t11[j] * t210;
            R_v[17 * 8 + j] = t247 + t249 + t246 + t230 - t250 - t251 - t252; /* R_v(2,5) */
            R_v[20 * 8 + j] = t205 + t206 - t243 - t242; /* R_v(3,2) */
            const real t253 = 0.05238095238095238 * t207;
            const real t254 = cos_q[j] * t156;
            R_v[23 * 8 + j] = t253 + t254 + t212 + t206; /* R_v(3,5) */
            R_v[26 * 8 + j] = t220 - t245 - t244 - t216; /* R_v(4,2) */
            const real t255 = 0.05238095238095238 * t222;
            const real t256 = sin_q[j] * t156;
            R_v[29 * 8 + j] = t255 + t256 + t220 - t221; /* R_v(4,5) */
            const real t257 = cos_q[j] * t56[j] + sin_q[j] * t54[j];
            const real t258 = 0.3 * (t257 * t182);
            R_v[30 * 8 + j] = t208 + t258 - t209 - t227; /* R_v(5,0) */
            const real t259 = 0.3 * (t257 * t192);
            R_v[31 * 8 + j] = t223 + t228 - t224 - t259; /* R_v(5,1) */
            const real t260 = 0.25 * t11[j] * t257;
            R_v[32 * 8 + j] = t249 + t251 + t250 + t260 - t246 - t247 - t241; /* R_v(5,2) */
            R_v[33 * 8 + j] = t253 + t227 - t254 - t258; /* R_v(5,3) */
            R_v[34 * 8 + j] = t255 + t259 - t256 - t228; /* R_v(5,4) */
            const real t261 = 0.01904761904761905 * (t102[j] * (sin_q[j] * t28 - cos_q[j] * t25));
            const real t263 = t262[j] + 0.01904761904761905 * (t176 - sin_q[j] * t109[j]);
            const real t266 = 0.01904761904761905 * (cos_q[j] * t109[j] - rq_vangle * t166);
            const real t268 = cos_q[j] * (t263 - t264[j] - t265[j]) + sin_q[j] * (t168[j] + t266 - t267[j]);
            R_v[35 * 8 + j] = t261 + t268 + t260 - t252; /* R_v(5,5) */
        }
    }
}

/* outputs: 334 operations.
 * in:  x (6), sigma (3), tau (0), p (9)
 * out: force_p (2), moment_p (1), force_q (2), moment_q (1), shear_angle (1), bend_range (2), shear_range (2), axis
 *   (17,2), across (2,2) */
FLEXEL_CLONES
static void planar_beam_first_order_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict force_p = out[0] + b * (2 * 8);
        real *restrict moment_p = out[1] + b * (1 * 8);
        real *restrict force_q = out[2] + b * (2 * 8);
        real *restrict moment_q = out[3] + b * (1 * 8);
        real *restrict shear_angle = out[4] + b * (1 * 8);
        real *restrict bend_range = out[5] + b * (2 * 8);
        real *restrict shear_range = out[6] + b * (2 * 8);
        real *restrict axis = out[7] + b * (34 * 8);
        real *restrict across = out[8] + b * (4 * 8);
        real t0[8], cos_p[8], d_x[8], d_y[8], t1[8], t2[8], sin_q[8], t3[8], sin_p[8], t4[8], t6[8], cos_q[8],
            el_y[8], el_x[8], t9[8], t10[8], t12[8], t16[8], t18[8], t19[8], t20[8], t21[8], t22[8], t23[8], t24[8],
            t25[8], t26[8], t27[8], t29[8], t31[8], t32[8], t33[8], t35[8], t37[8], t38[8], t39[8], t41[8], t43[8],
            t44[8], t45[8], t47[8], t49[8], t50[8], t51[8], t53[8], t55[8], t56[8], t57[8], t59[8], t61[8], t62[8],
            t63[8], t65[8], t67[8], t68[8], t69[8], t71[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real q_x = x[3 * 8 + j];
            axis[32 * 8 + j] = q_x; /* axis(16,0) */
            const real p_x = x[0 * 8 + j];
            axis[0 * 8 + j] = p_x; /* axis(0,0) */
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            axis[33 * 8 + j] = q_y; /* axis(16,1) */
            const real p_y = x[1 * 8 + j];
            axis[1 * 8 + j] = p_y; /* axis(0,1) */
            d_y[j] = q_y - p_y;
            const real l = real_sqrt(d_x[j] * d_x[j] + d_y[j] * d_y[j]);
            t1[j] = 1.0 / l;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t2[j] = rq_angle + alphaq0;
            const real l0 = p[0 * 8 + j];
            const real sigma_bend2 = sigma[2 * 8 + j];
            t3[j] = l0 * sigma_bend2;
            const real sigma_bend1 = sigma[1 * 8 + j];
            t4[j] = l0 * sigma_bend1;
            t6[j] = t1[j] * t1[j];
            el_y[j] = d_y[j] * t1[j];
            el_x[j] = d_x[j] * t1[j];
            const real GAy = p[6 * 8 + j];
            const real t11 = 1.0 / l0 * (1.0 / l0);
            const real EIz = p[5 * 8 + j];
            const real phi_y = 12.0 * (1.0 / GAy * (EIz * t11));
            t12[j] = real_abs(phi_y);
            const real t15 = 1.0 / (1.0 + phi_y);
            t16[j] = real_sqrt(t11 * t15 * t15);
            t27[j] = 0.98876953125 * p_x + 0.01123046875 * q_x;
            t29[j] = 0.98876953125 * p_y + 0.01123046875 * q_y;
            t31[j] = 0.95703125 * p_x + 0.04296875 * q_x;
            t32[j] = 0.95703125 * p_y + 0.04296875 * q_y;
            t33[j] = 0.90771484375 * p_x + 0.09228515625 * q_x;
            t35[j] = 0.90771484375 * p_y + 0.09228515625 * q_y;
            t37[j] = 0.84375 * p_x + 0.15625 * q_x;
            t38[j] = 0.84375 * p_y + 0.15625 * q_y;
            t39[j] = 0.76806640625 * p_x + 0.23193359375 * q_x;
            t41[j] = 0.76806640625 * p_y + 0.23193359375 * q_y;
            t43[j] = 0.68359375 * p_x + 0.31640625 * q_x;
            t44[j] = 0.68359375 * p_y + 0.31640625 * q_y;
            t45[j] = 0.59326171875 * p_x + 0.40673828125 * q_x;
            t47[j] = 0.59326171875 * p_y + 0.40673828125 * q_y;
            t49[j] = 0.5 * (p_x + q_x);
            t50[j] = 0.5 * (p_y + q_y);
            t51[j] = 0.40673828125 * p_x + 0.59326171875 * q_x;
            t53[j] = 0.40673828125 * p_y + 0.59326171875 * q_y;
            t55[j] = 0.31640625 * p_x + 0.68359375 * q_x;
            t56[j] = 0.31640625 * p_y + 0.68359375 * q_y;
            t57[j] = 0.23193359375 * p_x + 0.76806640625 * q_x;
            t59[j] = 0.23193359375 * p_y + 0.76806640625 * q_y;
            t61[j] = 0.15625 * p_x + 0.84375 * q_x;
            t62[j] = 0.15625 * p_y + 0.84375 * q_y;
            t63[j] = 0.09228515625 * p_x + 0.90771484375 * q_x;
            t65[j] = 0.09228515625 * p_y + 0.90771484375 * q_y;
            t67[j] = 0.04296875 * p_x + 0.95703125 * q_x;
            t68[j] = 0.04296875 * p_y + 0.95703125 * q_y;
            t69[j] = 0.01123046875 * p_x + 0.98876953125 * q_x;
            t71[j] = 0.01123046875 * p_y + 0.98876953125 * q_y;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            across[1 * 8 + j] = cos_p[j]; /* across(0,1) */
            sin_q[j] = real_sin(t2[j]);
            sin_p[j] = real_sin(t0[j]);
            cos_q[j] = real_cos(t2[j]);
            across[3 * 8 + j] = cos_q[j]; /* across(1,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t5 = sin_q[j] * t3[j] - sin_p[j] * t4[j];
            const real t7 = cos_p[j] * t4[j] - cos_q[j] * t3[j];
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t8 = t1[j] * (sigma_elongation - t6[j] * (d_y[j] * t7 + d_x[j] * t5));
            const real q_fx = t1[j] * t5 + d_x[j] * t8;
            const real q_fy = t1[j] * t7 + d_y[j] * t8;
            force_p[0 * 8 + j] = cos_p[j] * q_fx + sin_p[j] * q_fy;
            force_p[1 * 8 + j] = cos_p[j] * q_fy - sin_p[j] * q_fx;
            t9[j] = sin_p[j] * el_y[j] + cos_p[j] * el_x[j];
            moment_p[0 * 8 + j] = t9[j] * t4[j];
            force_q[0 * 8 + j] = cos_q[j] * q_fx + sin_q[j] * q_fy;
            force_q[1 * 8 + j] = cos_q[j] * q_fy - sin_q[j] * q_fx;
            t10[j] = sin_q[j] * el_y[j] + cos_q[j] * el_x[j];
            const real rq_fangle = t10[j] * t3[j];
            moment_q[0 * 8 + j] = rq_fangle;
            const real t13 = cos_p[j] * el_y[j] - sin_p[j] * el_x[j];
            const real t14 = cos_q[j] * el_y[j] - sin_q[j] * el_x[j];
            const real l0 = p[0 * 8 + j];
            const real t17 = real_abs(l0 * (t13 + t14)) * t16[j] * t12[j];
            t18[j] = 0.5 * t17;
            shear_angle[0 * 8 + j] = t18[j];
            t19[j] = real_abs(t13);
            t21[j] = real_abs(t14);
            shear_range[0 * 8 + j] = 28.64788975654116 * t17;
            const real t28 = l0 * (0.054931640625 * cos_p[j] - 0.003662109375 * cos_q[j]);
            axis[2 * 8 + j] = t27[j] + t28; /* axis(1,0) */
            const real t30 = l0 * (0.054931640625 * sin_p[j] - 0.003662109375 * sin_q[j]);
            axis[3 * 8 + j] = t29[j] + t30; /* axis(1,1) */
            axis[4 * 8 + j] = t31[j] + l0 * (0.095703125 * cos_p[j] - 0.013671875 * cos_q[j]); /* axis(2,0) */
            axis[5 * 8 + j] = t32[j] + l0 * (0.095703125 * sin_p[j] - 0.013671875 * sin_q[j]); /* axis(2,1) */
            const real t34 = l0 * (0.123779296875 * cos_p[j] - 0.028564453125 * cos_q[j]);
            axis[6 * 8 + j] = t33[j] + t34; /* axis(3,0) */
            const real t36 = l0 * (0.123779296875 * sin_p[j] - 0.028564453125 * sin_q[j]);
            axis[7 * 8 + j] = t35[j] + t36; /* axis(3,1) */
            axis[8 * 8 + j] = t37[j] + l0 * (0.140625 * cos_p[j] - 0.046875 * cos_q[j]); /* axis(4,0) */
            axis[9 * 8 + j] = t38[j] + l0 * (0.140625 * sin_p[j] - 0.046875 * sin_q[j]); /* axis(4,1) */
            const real t40 = l0 * (0.147705078125 * cos_p[j] - 0.067138671875 * cos_q[j]);
            axis[10 * 8 + j] = t39[j] + t40; /* axis(5,0) */
            const real t42 = l0 * (0.147705078125 * sin_p[j] - 0.067138671875 * sin_q[j]);
            axis[11 * 8 + j] = t41[j] + t42; /* axis(5,1) */
            axis[12 * 8 + j] = t43[j] + l0 * (0.146484375 * cos_p[j] - 0.087890625 * cos_q[j]); /* axis(6,0) */
            axis[13 * 8 + j] = t44[j] + l0 * (0.146484375 * sin_p[j] - 0.087890625 * sin_q[j]); /* axis(6,1) */
            const real t46 = l0 * (0.138427734375 * cos_p[j] - 0.107666015625 * cos_q[j]);
            axis[14 * 8 + j] = t45[j] + t46; /* axis(7,0) */
            const real t48 = l0 * (0.138427734375 * sin_p[j] - 0.107666015625 * sin_q[j]);
            axis[15 * 8 + j] = t47[j] + t48; /* axis(7,1) */
            axis[16 * 8 + j] = t49[j] + 0.125 * l0 * (cos_p[j] - cos_q[j]); /* axis(8,0) */
            axis[17 * 8 + j] = t50[j] + 0.125 * l0 * (sin_p[j] - sin_q[j]); /* axis(8,1) */
            const real t52 = l0 * (0.107666015625 * cos_p[j] - 0.138427734375 * cos_q[j]);
            axis[18 * 8 + j] = t51[j] + t52; /* axis(9,0) */
            const real t54 = l0 * (0.107666015625 * sin_p[j] - 0.138427734375 * sin_q[j]);
            axis[19 * 8 + j] = t53[j] + t54; /* axis(9,1) */
            axis[20 * 8 + j] = t55[j] + l0 * (0.087890625 * cos_p[j] - 0.146484375 * cos_q[j]); /* axis(10,0) */
            axis[21 * 8 + j] = t56[j] + l0 * (0.087890625 * sin_p[j] - 0.146484375 * sin_q[j]); /* axis(10,1) */
            const real t58 = l0 * (0.067138671875 * cos_p[j] - 0.147705078125 * cos_q[j]);
            axis[22 * 8 + j] = t57[j] + t58; /* axis(11,0) */
            const real t60 = l0 * (0.067138671875 * sin_p[j] - 0.147705078125 * sin_q[j]);
            axis[23 * 8 + j] = t59[j] + t60; /* axis(11,1) */
            axis[24 * 8 + j] = t61[j] + l0 * (0.046875 * cos_p[j] - 0.140625 * cos_q[j]); /* axis(12,0) */
            axis[25 * 8 + j] = t62[j] + l0 * (0.046875 * sin_p[j] - 0.140625 * sin_q[j]); /* axis(12,1) */
            const real t64 = l0 * (0.028564453125 * cos_p[j] - 0.123779296875 * cos_q[j]);
            axis[26 * 8 + j] = t63[j] + t64; /* axis(13,0) */
            const real t66 = l0 * (0.028564453125 * sin_p[j] - 0.123779296875 * sin_q[j]);
            axis[27 * 8 + j] = t65[j] + t66; /* axis(13,1) */
            axis[28 * 8 + j] = t67[j] + l0 * (0.013671875 * cos_p[j] - 0.095703125 * cos_q[j]); /* axis(14,0) */
            axis[29 * 8 + j] = t68[j] + l0 * (0.013671875 * sin_p[j] - 0.095703125 * sin_q[j]); /* axis(14,1) */
            const real t70 = l0 * (0.003662109375 * cos_p[j] - 0.054931640625 * cos_q[j]);
            axis[30 * 8 + j] = t69[j] + t70; /* axis(15,0) */
            const real t72 = l0 * (0.003662109375 * sin_p[j] - 0.054931640625 * sin_q[j]);
            axis[31 * 8 + j] = t71[j] + t72; /* axis(15,1) */
            across[0 * 8 + j] = -sin_p[j]; /* across(0,0) */
            across[2 * 8 + j] = -sin_q[j]; /* across(1,0) */
        }
        for (size_t j = 0; j < 8; j++) {
            t20[j] = real_atan2(t19[j], t9[j]);
            t22[j] = real_atan2(t21[j], t10[j]);
            t26[j] = real_sin(t18[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            t23[j] = t20[j] + t22[j];
            bend_range[0 * 8 + j] = 57.29577951308232 * t23[j];
            t25[j] = 1.0 / real_max(t23[j], 1e-09);
            shear_range[1 * 8 + j] = 100.0 * (t26[j] * t26[j]);
        }
        for (size_t j = 0; j < 8; j++) {
            t24[j] = real_sin(t23[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            bend_range[1 * 8 + j] = 100.0 * ((t23[j] - t24[j]) * t25[j]);
        }
    }
}

const flexel_element flexel_planar_beam_first_order = {
    .name = "planar_beam_first_order",
    .digest = "c910143fcaf9ef0d",
    .n = 6,
    .m = 3,
    .k = 0,
    .np = 9,
    .position = planar_beam_first_order_position,
    .acceleration = planar_beam_first_order_acceleration,
    .rates = planar_beam_first_order_rates,
    .kinematics = planar_beam_first_order_kinematics,
    .stiffness = planar_beam_first_order_stiffness,
    .inertia = planar_beam_first_order_inertia,
    .tangent = planar_beam_first_order_tangent,
    .outputs = planar_beam_first_order_outputs,
};
