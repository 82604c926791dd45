/* planar_beam: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
 * d = xq - xp, l = |d|, el = d/l;  b1 = l - l0,  b5 = l0 ey_p.el,  b6 = -l0 ey_q.el
 * elongation = b1 + (2 b5^2 + b5 b6 + 2 b6^2)/(30 l0),  bend1 = b5,  bend2 = b6
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

/* position: 107 operations.
 * in:  x (6), p (9)
 * out: e (3), De (3,6), 16 of 18 entries, V (0,6) */
FLEXEL_CLONES
static void planar_beam_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (9 * 8);
        real *restrict e = out[0] + b * (3 * 8);
        real *restrict De = out[1] + b * (16 * 8);
        real l[8], t0[8], t1[8], cos_p[8], el_y[8], sin_p[8], el_x[8], t3[8], cos_q[8], sin_q[8], t8[8], t9[8],
            t15[8], t16[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            l[j] = real_sqrt(d_x * d_x + d_y * d_y);
            const real l0 = p[0 * 8 + j];
            t0[j] = 1.0 / l0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t1[j] = rp_angle + alpha0;
            const real t2 = 1.0 / l[j];
            el_y[j] = d_y * t2;
            el_x[j] = d_x * t2;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t3[j] = rq_angle + alphaq0;
            const real t6 = t2 * t2;
            const real t7 = el_x[j] * t6;
            t8[j] = d_y * t7;
            t9[j] = d_x * t7 - t2;
            const real t14 = el_y[j] * t6;
            t15[j] = d_y * t14 - t2;
            t16[j] = d_x * t14;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t1[j]);
            sin_p[j] = real_sin(t1[j]);
            cos_q[j] = real_cos(t3[j]);
            sin_q[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real b5 = l0 * (cos_p[j] * el_y[j] - sin_p[j] * el_x[j]);
            e[1 * 8 + j] = b5;
            const real t4 = l0 * (cos_q[j] * el_y[j] - sin_q[j] * el_x[j]);
            const real t5 = 0.03333333333333333 * (t0[j] * (2.0 * (b5 * b5 + t4 * t4) - b5 * t4));
            e[0 * 8 + j] = l[j] + t5 - l0;
            e[2 * 8 + j] = -t4;
            const real t10 = l0 * (cos_p[j] * t8[j] - sin_p[j] * t9[j]);
            De[6 * 8 + j] = t10; /* De(1,0) */
            const real t11 = l0 * (cos_q[j] * t8[j] - sin_q[j] * t9[j]);
            De[13 * 8 + j] = t11; /* De(2,3) */
            const real t12 = t0[j] * (4.0 * (b5 * t10 + t4 * t11) - t4 * t10 - b5 * t11);
            const real t13 = 0.03333333333333333 * t12 - el_x[j];
            De[0 * 8 + j] = t13; /* De(0,0) */
            const real t17 = l0 * (cos_p[j] * t15[j] - sin_p[j] * t16[j]);
            De[7 * 8 + j] = t17; /* De(1,1) */
            const real t18 = l0 * (cos_q[j] * t15[j] - sin_q[j] * t16[j]);
            De[14 * 8 + j] = t18; /* De(2,4) */
            const real t19 = t0[j] * (4.0 * (b5 * t17 + t4 * t18) - t4 * t17 - b5 * t18);
            const real t20 = 0.03333333333333333 * t19 - el_y[j];
            De[1 * 8 + j] = t20; /* De(0,1) */
            const real t21 = l0 * (sin_p[j] * el_y[j] + cos_p[j] * el_x[j]);
            De[2 * 8 + j] = 0.03333333333333333 * (t21 * (t4 - 4.0 * b5) * t0[j]); /* De(0,2) */
            De[3 * 8 + j] = -t13; /* De(0,3) */
            De[4 * 8 + j] = -t20; /* De(0,4) */
            const real t22 = l0 * (sin_q[j] * el_y[j] + cos_q[j] * el_x[j]);
            De[15 * 8 + j] = t22; /* De(2,5) */
            De[5 * 8 + j] = 0.03333333333333333 * (t22 * (b5 - 4.0 * t4) * t0[j]); /* De(0,5) */
            De[8 * 8 + j] = -t21; /* De(1,2) */
            De[9 * 8 + j] = -t10; /* De(1,3) */
            De[10 * 8 + j] = -t17; /* De(1,4) */
            De[11 * 8 + j] = -t11; /* De(2,0) */
            De[12 * 8 + j] = -t18; /* De(2,1) */
        }
    }
}

/* acceleration: 127 operations.
 * in:  x (6), v (6), p (9)
 * out: g (3), gs (0) */
FLEXEL_CLONES
static void planar_beam_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict g = out[0] + b * (3 * 8);
        real t7[8], t8[8], t9[8], cos_q[8], el_y[8], sin_q[8], el_x[8], t11[8], cos_p[8], sin_p[8], t15[8], t16[8],
            t17[8], t18[8];
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
            t7[j] = t0 * (t1 * t1 + t2 * t2) - t3 * t6;
            const real l0 = p[0 * 8 + j];
            t8[j] = 1.0 / l0;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t9[j] = rq_angle + alphaq0;
            el_y[j] = d_y * t0;
            el_x[j] = d_x * t0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t11[j] = rp_angle + alpha0;
            const real t14 = 2.0 * t4 * t7[j] - 4.0 * t0 * t6 * t5;
            t15[j] = 4.0 * t2 * t6 + d_y * t14;
            t16[j] = 4.0 * t1 * t6 + d_x * t14;
            t17[j] = t0 * t2 - d_y * t6;
            t18[j] = t0 * t1 - d_x * t6;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_q[j] = real_cos(t9[j]);
            sin_q[j] = real_sin(t9[j]);
            cos_p[j] = real_cos(t11[j]);
            sin_p[j] = real_sin(t11[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t10 = l0 * (cos_q[j] * el_y[j] - sin_q[j] * el_x[j]);
            const real rp_vangle = v[2 * 8 + j];
            const real t12 = rp_vangle * cos_p[j];
            const real t13 = rp_vangle * sin_p[j];
            const real t19 = 0.5 * (cos_p[j] * t15[j] - sin_p[j] * t16[j]) + 2.0 * (t13 * t17[j] + t12 * t18[j]);
            const real t20 = l0 * (rp_vangle * (el_y[j] * t12 - el_x[j] * t13) + t19);
            const real b5 = l0 * (cos_p[j] * el_y[j] - sin_p[j] * el_x[j]);
            const real rq_vangle = v[5 * 8 + j];
            const real t21 = rq_vangle * cos_q[j];
            const real t22 = rq_vangle * sin_q[j];
            const real t23 = 0.5 * (cos_q[j] * t15[j] - sin_q[j] * t16[j]) + 2.0 * (t22 * t17[j] + t21 * t18[j]);
            const real t24 = l0 * (rq_vangle * (el_y[j] * t21 - el_x[j] * t22) + t23);
            g[2 * 8 + j] = t24;
            const real t25 = cos_p[j] * t17[j] - el_y[j] * t13 - el_x[j] * t12 - sin_p[j] * t18[j];
            const real t26 = l0 * t25;
            const real t27 = cos_q[j] * t17[j] - el_y[j] * t22 - el_x[j] * t21 - sin_q[j] * t18[j];
            const real t28 = l0 * t27;
            const real t29 = b5 * t24 + 4.0 * (t26 * t26 + t28 * t28 - b5 * t20 - t10 * t24);
            const real t30 = 0.03333333333333333 * (t8[j] * (t10 * t20 + t29 - 2.0 * t26 * t28));
            g[0 * 8 + j] = t7[j] + t30;
            g[1 * 8 + j] = -t20;
        }
    }
}

/* rates: 214 operations.
 * in:  x (6), v (6), p (9)
 * out: Phi_x (3,6), 16 of 18 entries */
FLEXEL_CLONES
static void planar_beam_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict Phi_x = out[0] + b * (16 * 8);
        real d_x[8], d_y[8], t0[8], t1[8], t2[8], t3[8], t4[8], cos_p[8], el_y[8], sin_p[8], el_x[8], t6[8], cos_q[8],
            sin_q[8], t7[8], t11[8], t12[8], t14[8], t15[8], t23[8], t24[8], t26[8], t37[8], t38[8], t47[8], t51[8],
            t53[8], t54[8], t57[8], t58[8];
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
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t1[j] = q_vx - p_vx;
            t2[j] = t0[j] * t1[j];
            const real l0 = p[0 * 8 + j];
            t3[j] = 1.0 / l0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t4[j] = rp_angle + alpha0;
            el_y[j] = d_y[j] * t0[j];
            el_x[j] = d_x[j] * t0[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t6[j] = rq_angle + alphaq0;
            t7[j] = l0 * l0;
            const real t10 = t0[j] * t0[j];
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t11[j] = q_vy - p_vy;
            t12[j] = d_x[j] * t1[j] + d_y[j] * t11[j];
            const real t13 = t0[j] * t12[j];
            t14[j] = t10 * t13;
            t15[j] = t10 * t2[j];
            t23[j] = t0[j] * t11[j];
            t24[j] = t23[j] - d_y[j] * t14[j];
            t26[j] = t2[j] - d_x[j] * t14[j];
            const real t36 = t0[j] * t10;
            t37[j] = d_x[j] * t36;
            t38[j] = 4.0 * t0[j] * t13 + 2.0 * t10 * t12[j];
            t47[j] = t10 * t23[j];
            t51[j] = d_y[j] * t36;
            const real rp_vangle = v[2 * 8 + j];
            t53[j] = t24[j] - rp_vangle * el_x[j];
            t54[j] = t26[j] + rp_vangle * el_y[j];
            const real rq_vangle = v[5 * 8 + j];
            t57[j] = t24[j] - rq_vangle * el_x[j];
            t58[j] = t26[j] + rq_vangle * el_y[j];
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t4[j]);
            sin_p[j] = real_sin(t4[j]);
            cos_q[j] = real_cos(t6[j]);
            sin_q[j] = real_sin(t6[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real b5 = l0 * (cos_p[j] * el_y[j] - sin_p[j] * el_x[j]);
            const real t5 = l0 * b5;
            const real t8 = (cos_q[j] * el_y[j] - sin_q[j] * el_x[j]) * t7[j];
            const real t9 = t3[j] * (4.0 * t5 - t8);
            const real t16 = sin_p[j] * d_x[j] - cos_p[j] * d_y[j];
            const real rp_vangle = v[2 * 8 + j];
            const real t17 = rp_vangle * cos_p[j];
            const real t18 = sin_p[j] * t14[j] + t15[j] * t16 - t0[j] * t17;
            const real t19 = t3[j] * (4.0 * t8 - t5);
            const real t20 = sin_q[j] * d_x[j] - cos_q[j] * d_y[j];
            const real rq_vangle = v[5 * 8 + j];
            const real t21 = rq_vangle * cos_q[j];
            const real t22 = sin_q[j] * t14[j] + t15[j] * t20 - t0[j] * t21;
            const real t25 = rp_vangle * sin_p[j];
            const real t27 = cos_p[j] * t24[j] - el_y[j] * t25 - el_x[j] * t17 - sin_p[j] * t26[j];
            const real t28 = t7[j] * t27;
            const real t29 = rq_vangle * sin_q[j];
            const real t30 = cos_q[j] * t24[j] - el_y[j] * t29 - el_x[j] * t21 - sin_q[j] * t26[j];
            const real t31 = t7[j] * t30;
            const real t32 = t3[j] * (4.0 * t28 - t31);
            const real t33 = t3[j] * (4.0 * t31 - t28);
            const real t34 = sin_p[j] * t32 + sin_q[j] * t33;
            const real t35 = 0.03333333333333333 * (t9 * t18 + t19 * t22 - t0[j] * t34);
            const real t39 = cos_p[j] * t11[j] + 0.5 * t38[j] * t16 - d_x[j] * t17 - d_y[j] * t25;
            const real t40 = t39 - sin_p[j] * t1[j];
            const real t41 = cos_q[j] * t11[j] + 0.5 * t38[j] * t20 - d_x[j] * t21 - d_y[j] * t29;
            const real t42 = t41 - sin_q[j] * t1[j];
            const real t43 = cos_p[j] * t32 + cos_q[j] * t33;
            const real t44 = 0.03333333333333333 * (t9 * t40 + t19 * t42 + d_y[j] * t43 - d_x[j] * t34);
            const real t45 = t12[j] + t44;
            const real t46 = t2[j] + t35 - t37[j] * t45;
            Phi_x[3 * 8 + j] = t46; /* Phi_x(0,3) */
            Phi_x[0 * 8 + j] = -t46; /* Phi_x(0,0) */
            const real t48 = t47[j] * t16 - t0[j] * t25 - cos_p[j] * t14[j];
            const real t49 = t47[j] * t20 - t0[j] * t29 - cos_q[j] * t14[j];
            const real t50 = 0.03333333333333333 * (t9 * t48 + t19 * t49 + t0[j] * t43);
            const real t52 = t23[j] + t50 - t51[j] * t45;
            Phi_x[4 * 8 + j] = t52; /* Phi_x(0,4) */
            Phi_x[1 * 8 + j] = -t52; /* Phi_x(0,1) */
            const real t55 = sin_p[j] * t53[j] + cos_p[j] * t54[j];
            const real t56 = (sin_p[j] * el_y[j] + cos_p[j] * el_x[j]) * t32 + t9 * t55;
            Phi_x[2 * 8 + j] = -(0.03333333333333333 * t56); /* Phi_x(0,2) */
            const real t59 = sin_q[j] * t57[j] + cos_q[j] * t58[j];
            const real t60 = (sin_q[j] * el_y[j] + cos_q[j] * el_x[j]) * t33 + t19 * t59;
            Phi_x[5 * 8 + j] = -(0.03333333333333333 * t60); /* Phi_x(0,5) */
            const real t61 = l0 * t40;
            const real t62 = l0 * t18 - t37[j] * t61;
            Phi_x[9 * 8 + j] = t62; /* Phi_x(1,3) */
            Phi_x[6 * 8 + j] = -t62; /* Phi_x(1,0) */
            const real t63 = l0 * t48 - t51[j] * t61;
            Phi_x[10 * 8 + j] = t63; /* Phi_x(1,4) */
            Phi_x[7 * 8 + j] = -t63; /* Phi_x(1,1) */
            Phi_x[8 * 8 + j] = -(l0 * t55); /* Phi_x(1,2) */
            const real t64 = l0 * t42;
            const real t65 = t37[j] * t64 - l0 * t22;
            Phi_x[13 * 8 + j] = t65; /* Phi_x(2,3) */
            Phi_x[11 * 8 + j] = -t65; /* Phi_x(2,0) */
            const real t66 = t51[j] * t64 - l0 * t49;
            Phi_x[14 * 8 + j] = t66; /* Phi_x(2,4) */
            Phi_x[12 * 8 + j] = -t66; /* Phi_x(2,1) */
            Phi_x[15 * 8 + j] = l0 * t59; /* Phi_x(2,5) */
        }
    }
}

/* kinematics: 643 operations.
 * in:  x (6), v (6), a (6), p (9)
 * out: Psi_x (3,6), 16 of 18 entries, Psi_v (3,6), 16 of 18 entries */
FLEXEL_CLONES
static void planar_beam_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict Psi_x = out[0] + b * (16 * 8);
        real *restrict Psi_v = out[1] + b * (16 * 8);
        real d_x[8], d_y[8], t0[8], t2[8], t3[8], t4[8], t6[8], t7[8], t8[8], sin_p[8], t9[8], cos_p[8], t10[8],
            t11[8], el_y[8], el_x[8], t14[8], t15[8], t18[8], cos_q[8], sin_q[8], t29[8], t30[8], t38[8], t41[8],
            t42[8], t43[8], t50[8], t55[8], t66[8], t70[8], t71[8], t74[8], t76[8], t77[8], t79[8], t93[8], t95[8],
            t96[8], t97[8], t106[8], t110[8], t112[8], t114[8], t115[8], t116[8], t117[8], t120[8], t122[8], t125[8],
            t126[8], t129[8], t131[8];
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
            const real t1 = t0[j] * t0[j];
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t2[j] = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t3[j] = q_vy - p_vy;
            t4[j] = d_x[j] * t2[j] + d_y[j] * t3[j];
            const real t5 = t0[j] * t4[j];
            t6[j] = t1 * t5;
            const real l0 = p[0 * 8 + j];
            t7[j] = 1.0 / l0;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t8[j] = rp_angle + alpha0;
            t9[j] = l0 * l0;
            t10[j] = t0[j] * t3[j];
            t11[j] = t10[j] - d_y[j] * t6[j];
            el_y[j] = d_y[j] * t0[j];
            el_x[j] = d_x[j] * t0[j];
            t14[j] = t0[j] * t2[j];
            t15[j] = t14[j] - d_x[j] * t6[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t18[j] = rq_angle + alphaq0;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t29[j] = q_ax - p_ax;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t30[j] = q_ay - p_ay;
            const real t31 = d_x[j] * t29[j] + d_y[j] * t30[j];
            const real t32 = t0[j] * t31;
            const real t33 = t1 * t32;
            const real t34 = t2[j] * t2[j] + t3[j] * t3[j];
            const real t35 = t0[j] * t34 - t4[j] * t6[j];
            const real t36 = t0[j] * t6[j];
            const real t37 = 2.0 * t1 * t35 - 4.0 * t5 * t36;
            t38[j] = t33 + 0.5 * t37;
            t41[j] = t2[j] * t6[j];
            t42[j] = t0[j] * t29[j];
            t43[j] = 0.5 * (4.0 * t14[j] * t36 + 2.0 * t1 * t41[j]) - t1 * t42[j];
            t50[j] = t1 * t14[j];
            const real t53 = t0[j] * t5;
            const real t54 = t1 * t4[j];
            t55[j] = 2.0 * t53 + t54;
            t66[j] = 0.5 * t4[j];
            t70[j] = t3[j] * t6[j];
            t71[j] = t70[j] + 0.5 * (2.0 * t70[j] + d_y[j] * t37);
            t74[j] = t41[j] + 0.5 * (2.0 * t41[j] + d_x[j] * t37);
            t76[j] = t0[j] * t30[j];
            t77[j] = t76[j] - d_y[j] * t33;
            t79[j] = t42[j] - d_x[j] * t33;
            const real t92 = t0[j] * t1;
            t93[j] = d_x[j] * t92;
            t95[j] = 4.0 * t53 + 2.0 * t54;
            t96[j] = t34 + t31;
            t97[j] = 2.0 * (t1 * t34 + 2.0 * t0[j] * t35 + t1 * t31) + 4.0 * (t0[j] * t32 - (t5 * t6[j] + t4[j]
                * t36));
            t106[j] = 0.5 * (4.0 * t10[j] * t36 + 2.0 * t1 * t70[j]) - t1 * t76[j];
            t110[j] = t1 * t10[j];
            t112[j] = d_y[j] * t92;
            t114[j] = l0 * el_x[j];
            t115[j] = l0 * el_y[j];
            const real rp_vangle = v[2 * 8 + j];
            t116[j] = t11[j] - rp_vangle * el_x[j];
            t117[j] = t15[j] + rp_vangle * el_y[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t119 = el_y[j] * rp_aangle + t79[j] + rp_vangle * (t11[j] + t116[j]);
            t120[j] = t119 - t74[j];
            const real t121 = t77[j] - el_x[j] * rp_aangle - rp_vangle * (t15[j] + t117[j]);
            t122[j] = t121 - t71[j];
            const real rq_vangle = v[5 * 8 + j];
            t125[j] = t11[j] - rq_vangle * el_x[j];
            t126[j] = t15[j] + rq_vangle * el_y[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t128 = el_y[j] * rq_aangle + t79[j] + rq_vangle * (t11[j] + t125[j]);
            t129[j] = t128 - t74[j];
            const real t130 = t77[j] - el_x[j] * rq_aangle - rq_vangle * (t15[j] + t126[j]);
            t131[j] = t130 - t71[j];
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t8[j]);
            cos_p[j] = real_cos(t8[j]);
            cos_q[j] = real_cos(t18[j]);
            sin_q[j] = real_sin(t18[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t12 = rp_vangle * sin_p[j];
            const real t13 = rp_vangle * cos_p[j];
            const real t16 = cos_p[j] * t11[j] - el_y[j] * t12 - el_x[j] * t13 - sin_p[j] * t15[j];
            const real t17 = t9[j] * t16;
            const real rq_vangle = v[5 * 8 + j];
            const real t19 = rq_vangle * sin_q[j];
            const real t20 = rq_vangle * cos_q[j];
            const real t21 = cos_q[j] * t11[j] - el_y[j] * t19 - el_x[j] * t20 - sin_q[j] * t15[j];
            const real t22 = t9[j] * t21;
            const real t23 = 8.0 * t17 - 2.0 * t22;
            const real t24 = 8.0 * t22 - 2.0 * t17;
            const real t25 = t7[j] * (sin_p[j] * t23 + sin_q[j] * t24);
            const real l0 = p[0 * 8 + j];
            const real b5 = l0 * (cos_p[j] * el_y[j] - sin_p[j] * el_x[j]);
            const real t26 = l0 * b5;
            const real t27 = (cos_q[j] * el_y[j] - sin_q[j] * el_x[j]) * t9[j];
            const real t28 = t7[j] * (4.0 * t26 - t27);
            const real t39 = rp_vangle * t12;
            const real t40 = sin_p[j] * d_x[j] - cos_p[j] * d_y[j];
            const real t44 = t0[j] * t39 + 2.0 * t13 * t6[j] + sin_p[j] * t38[j] - t40 * t43[j];
            const real t45 = t7[j] * (4.0 * t27 - t26);
            const real t46 = sin_q[j] * d_x[j] - cos_q[j] * d_y[j];
            const real t47 = rq_vangle * t19;
            const real t48 = t46 * t43[j] - sin_q[j] * t38[j] - 2.0 * t20 * t6[j] - t0[j] * t47;
            const real t49 = 0.03333333333333333 * (t6[j] * t25 + t28 * t44 - t45 * t48);
            const real t51 = t7[j] * (cos_p[j] * t23 + cos_q[j] * t24);
            const real t52 = cos_q[j] * t3[j];
            const real t56 = sin_q[j] * t2[j];
            const real t57 = d_x[j] * t20;
            const real t58 = d_y[j] * t19;
            const real t59 = t52 + 0.5 * t46 * t55[j] - t56 - t57 - t58;
            const real t60 = cos_p[j] * t3[j];
            const real t61 = sin_p[j] * t2[j];
            const real t62 = d_x[j] * t13;
            const real t63 = d_y[j] * t12;
            const real t64 = t60 + 0.5 * t40 * t55[j] - t61 - t62 - t63;
            const real t65 = 0.016666666666666666 * (d_x[j] * t25 - d_y[j] * t51) - 0.03333333333333333 * (t45 * t59
                + t28 * t64);
            const real t67 = t65 - t66[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t68 = cos_q[j] * rq_aangle;
            const real rp_aangle = a[2 * 8 + j];
            const real t69 = cos_p[j] * rp_aangle;
            const real t72 = rq_vangle * t20;
            const real t73 = el_y[j] * t72 + 2.0 * (t19 * t11[j] + t20 * t15[j]) + cos_q[j] * t71[j];
            const real t75 = l0 * (t73 - el_x[j] * t47 - sin_q[j] * t74[j]);
            const real t78 = sin_p[j] * rp_aangle;
            const real t80 = cos_p[j] * t77[j] - el_y[j] * t78 - el_x[j] * t69 - sin_p[j] * t79[j];
            const real t81 = l0 * t80;
            const real t82 = rp_vangle * t13;
            const real t83 = el_y[j] * t82 + 2.0 * (t12 * t11[j] + t13 * t15[j]) + cos_p[j] * t71[j];
            const real t84 = l0 * (t83 - el_x[j] * t39 - sin_p[j] * t74[j]);
            const real t85 = sin_q[j] * rq_aangle;
            const real t86 = cos_q[j] * t77[j] - el_y[j] * t85 - el_x[j] * t68 - sin_q[j] * t79[j];
            const real t87 = l0 * t86;
            const real t88 = t7[j] * (t75 + 4.0 * (t81 - t84) - t87);
            const real t89 = t7[j] * (t84 + 4.0 * (t87 - t75) - t81);
            const real t90 = t7[j] * (t13 * t23 + t20 * t24) + t69 * t28 + t68 * t45 + l0 * (sin_p[j] * t88 + sin_q[j]
                * t89);
            const real t91 = t42[j] + 2.0 * t50[j] * t67 + t49 - t41[j] - 0.03333333333333333 * (t0[j] * t90);
            const real t94 = l0 * (cos_p[j] * t88 + cos_q[j] * t89) - (t7[j] * (t12 * t23 + t19 * t24) + t78 * t28
                + t85 * t45);
            const real t98 = cos_p[j] * t30[j] + d_x[j] * t39 + 0.5 * t40 * t97[j] - sin_p[j] * t29[j];
            const real t99 = t98 - d_y[j] * t82 - 2.0 * (t2[j] * t13 + t3[j] * t12);
            const real t100 = sin_q[j] * t29[j] + d_y[j] * t72 + 2.0 * (t2[j] * t20 + t3[j] * t19);
            const real t101 = t100 - 0.5 * t46 * t97[j] - d_x[j] * t47 - cos_q[j] * t30[j];
            const real t102 = 0.03333333333333333 * (t3[j] * t51 + t28 * t99 - t45 * t101 - t2[j] * t25);
            const real t103 = t96[j] + t102 + t95[j] * t67 + 0.03333333333333333 * (d_y[j] * t94);
            const real t104 = t103 - 0.03333333333333333 * (d_x[j] * t90);
            const real t105 = t91 - t93[j] * t104;
            Psi_x[3 * 8 + j] = t105; /* Psi_x(0,3) */
            Psi_x[0 * 8 + j] = -t105; /* Psi_x(0,0) */
            const real t107 = 2.0 * t12 * t6[j] - cos_p[j] * t38[j] - t40 * t106[j] - t0[j] * t82;
            const real t108 = t0[j] * t72 + cos_q[j] * t38[j] + t46 * t106[j] - 2.0 * t19 * t6[j];
            const real t109 = 0.03333333333333333 * (t28 * t107 - t45 * t108 - t6[j] * t51);
            const real t111 = t76[j] + 0.03333333333333333 * (t0[j] * t94) + 2.0 * t110[j] * t67;
            const real t113 = t109 + t111 - t70[j] - t112[j] * t104;
            Psi_x[4 * 8 + j] = t113; /* Psi_x(0,4) */
            Psi_x[1 * 8 + j] = -t113; /* Psi_x(0,1) */
            const real t118 = sin_p[j] * t116[j] + cos_p[j] * t117[j];
            const real t123 = cos_p[j] * t120[j] + sin_p[j] * t122[j];
            const real t124 = t7[j] * t118 * t23 + t28 * t123 + (cos_p[j] * t114[j] + sin_p[j] * t115[j]) * t88;
            Psi_x[2 * 8 + j] = -(0.03333333333333333 * t124); /* Psi_x(0,2) */
            const real t127 = sin_q[j] * t125[j] + cos_q[j] * t126[j];
            const real t132 = cos_q[j] * t129[j] + sin_q[j] * t131[j];
            const real t133 = t7[j] * t127 * t24 + t45 * t132 + (cos_q[j] * t114[j] + sin_q[j] * t115[j]) * t89;
            Psi_x[5 * 8 + j] = -(0.03333333333333333 * t133); /* Psi_x(0,5) */
            const real t134 = l0 * t69;
            const real t135 = l0 * t64;
            const real t136 = l0 * t78;
            const real t137 = l0 * t99 - d_x[j] * t134 - d_y[j] * t136 - t95[j] * t135;
            const real t138 = l0 * t44 - t0[j] * t134 - 2.0 * t50[j] * t135 - t93[j] * t137;
            Psi_x[9 * 8 + j] = t138; /* Psi_x(1,3) */
            Psi_x[6 * 8 + j] = -t138; /* Psi_x(1,0) */
            const real t139 = l0 * t107 - t0[j] * t136 - 2.0 * t110[j] * t135 - t112[j] * t137;
            Psi_x[10 * 8 + j] = t139; /* Psi_x(1,4) */
            Psi_x[7 * 8 + j] = -t139; /* Psi_x(1,1) */
            Psi_x[8 * 8 + j] = -(l0 * t123); /* Psi_x(1,2) */
            const real t140 = l0 * t59;
            const real t141 = l0 * t68;
            const real t142 = l0 * t85;
            const real t143 = d_y[j] * t142 + l0 * t101 + d_x[j] * t141 + t95[j] * t140;
            const real t144 = t0[j] * t141 + l0 * t48 + 2.0 * t50[j] * t140 - t93[j] * t143;
            Psi_x[13 * 8 + j] = t144; /* Psi_x(2,3) */
            Psi_x[11 * 8 + j] = -t144; /* Psi_x(2,0) */
            const real t145 = t0[j] * t142 + l0 * t108 + 2.0 * t110[j] * t140 - t112[j] * t143;
            Psi_x[14 * 8 + j] = t145; /* Psi_x(2,4) */
            Psi_x[12 * 8 + j] = -t145; /* Psi_x(2,1) */
            Psi_x[15 * 8 + j] = l0 * t132; /* Psi_x(2,5) */
            const real t146 = sin_p[j] * t6[j] + t50[j] * t40 - t0[j] * t13;
            const real t147 = sin_q[j] * t6[j] + t50[j] * t46 - t0[j] * t20;
            const real t148 = t7[j] * (4.0 * t17 - t22);
            const real t149 = t7[j] * (4.0 * t22 - t17);
            const real t150 = sin_p[j] * t148 + sin_q[j] * t149;
            const real t151 = 0.03333333333333333 * (t28 * t146 + t45 * t147 - t0[j] * t150);
            const real t152 = t60 + 0.5 * t95[j] * t40 - t62 - t63 - t61;
            const real t153 = t52 + 0.5 * t95[j] * t46 - t57 - t58 - t56;
            const real t154 = cos_p[j] * t148 + cos_q[j] * t149;
            const real t155 = 0.03333333333333333 * (t28 * t152 + t45 * t153 + d_y[j] * t154 - d_x[j] * t150);
            const real t156 = t4[j] + t155;
            const real t157 = 2.0 * (t14[j] + t151 - t93[j] * t156);
            Psi_v[3 * 8 + j] = t157; /* Psi_v(0,3) */
            Psi_v[0 * 8 + j] = -t157; /* Psi_v(0,0) */
            const real t158 = t110[j] * t40 - t0[j] * t12 - cos_p[j] * t6[j];
            const real t159 = t110[j] * t46 - t0[j] * t19 - cos_q[j] * t6[j];
            const real t160 = 0.03333333333333333 * (t28 * t158 + t45 * t159 + t0[j] * t154);
            const real t161 = 2.0 * (t10[j] + t160 - t112[j] * t156);
            Psi_v[4 * 8 + j] = t161; /* Psi_v(0,4) */
            Psi_v[1 * 8 + j] = -t161; /* Psi_v(0,1) */
            const real t162 = (sin_p[j] * el_y[j] + cos_p[j] * el_x[j]) * t148 + t28 * t118;
            Psi_v[2 * 8 + j] = -(0.06666666666666667 * t162); /* Psi_v(0,2) */
            const real t163 = (sin_q[j] * el_y[j] + cos_q[j] * el_x[j]) * t149 + t45 * t127;
            Psi_v[5 * 8 + j] = -(0.06666666666666667 * t163); /* Psi_v(0,5) */
            const real t164 = l0 * t152;
            const real t165 = 2.0 * (l0 * t146 - t93[j] * t164);
            Psi_v[9 * 8 + j] = t165; /* Psi_v(1,3) */
            Psi_v[6 * 8 + j] = -t165; /* Psi_v(1,0) */
            const real t166 = 2.0 * (l0 * t158 - t112[j] * t164);
            Psi_v[10 * 8 + j] = t166; /* Psi_v(1,4) */
            Psi_v[7 * 8 + j] = -t166; /* Psi_v(1,1) */
            Psi_v[8 * 8 + j] = -(2.0 * l0 * t118); /* Psi_v(1,2) */
            const real t167 = l0 * t153;
            const real t168 = 2.0 * (t93[j] * t167 - l0 * t147);
            Psi_v[13 * 8 + j] = t168; /* Psi_v(2,3) */
            Psi_v[11 * 8 + j] = -t168; /* Psi_v(2,0) */
            const real t169 = 2.0 * (t112[j] * t167 - l0 * t159);
            Psi_v[14 * 8 + j] = t169; /* Psi_v(2,4) */
            Psi_v[12 * 8 + j] = -t169; /* Psi_v(2,1) */
            Psi_v[15 * 8 + j] = 2.0 * l0 * t127; /* Psi_v(2,5) */
        }
    }
}

/* stiffness: 190 operations.
 * in:  x (6), sigma (3), tau (0), p (9)
 * out: K (6,6) */
FLEXEL_CLONES
static void planar_beam_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict K = out[0] + b * (36 * 8);
        real d_x[8], d_y[8], t0[8], t1[8], t2[8], t3[8], t4[8], sin_q[8], cos_q[8], t7[8], t8[8], t10[8], sin_p[8],
            t13[8], cos_p[8], el_y[8], el_x[8];
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
            t2[j] = t0[j] * t1[j];
            t3[j] = d_x[j] * t2[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t4[j] = rq_angle + alphaq0;
            const real l0 = p[0 * 8 + j];
            const real sigma_elongation = sigma[0 * 8 + j];
            t7[j] = 1.0 / l0 * sigma_elongation;
            t8[j] = l0 * l0 * t7[j];
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t10[j] = rp_angle + alpha0;
            t13[j] = d_y[j] * t2[j];
            el_y[j] = d_y[j] * t0[j];
            el_x[j] = d_x[j] * t0[j];
        }
        for (size_t j = 0; j < 8; j++) {
            sin_q[j] = real_sin(t4[j]);
            cos_q[j] = real_cos(t4[j]);
            sin_p[j] = real_sin(t10[j]);
            cos_p[j] = real_cos(t10[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t5 = sin_q[j] * d_x[j] - cos_q[j] * d_y[j];
            const real t6 = t3[j] * t5 - sin_q[j] * t0[j];
            const real t9 = sin_q[j] * t8[j];
            const real t11 = sin_p[j] * t8[j];
            const real t12 = 0.13333333333333333 * t9 - 0.03333333333333333 * t11;
            const real t14 = cos_q[j] * t8[j];
            const real t15 = cos_p[j] * t8[j];
            const real t16 = 0.13333333333333333 * t14 - 0.03333333333333333 * t15;
            const real t17 = t3[j] * t12 - t13[j] * t16;
            const real t18 = d_x[j] * t17 - t0[j] * t12;
            const real t19 = sin_p[j] * d_x[j] - cos_p[j] * d_y[j];
            const real t20 = t3[j] * t19 - sin_p[j] * t0[j];
            const real t21 = 0.13333333333333333 * t11 - 0.03333333333333333 * t9;
            const real t22 = 0.13333333333333333 * t15 - 0.03333333333333333 * t14;
            const real t23 = t3[j] * t21 - t13[j] * t22;
            const real t24 = d_x[j] * t23 - t0[j] * t21;
            const real t25 = cos_q[j] * el_y[j] - sin_q[j] * el_x[j];
            const real l0 = p[0 * 8 + j];
            const real t26 = l0 * t25 * t7[j];
            const real sigma_bend2 = sigma[2 * 8 + j];
            const real t27 = cos_p[j] * el_y[j] - sin_p[j] * el_x[j];
            const real b5 = l0 * t27;
            const real t28 = b5 * t7[j];
            const real t29 = 0.13333333333333333 * t26 - sigma_bend2 - 0.03333333333333333 * t28;
            const real t30 = l0 * t29;
            const real t31 = sin_q[j] * t30;
            const real sigma_bend1 = sigma[1 * 8 + j];
            const real t32 = sigma_bend1 + 0.13333333333333333 * t28 - 0.03333333333333333 * t26;
            const real t33 = l0 * t32;
            const real t34 = sin_p[j] * t33;
            const real t35 = t31 + t34;
            const real t36 = cos_q[j] * t30;
            const real t37 = cos_p[j] * t33;
            const real t38 = t36 + t37;
            const real t39 = t1[j] * (d_y[j] * t38 - d_x[j] * t35);
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t40 = sigma_elongation - t39;
            const real t41 = t40 - 2.0 * t39;
            const real t42 = t2[j] * t35 - t3[j] * t41;
            const real t43 = t0[j] * t40;
            const real t44 = t43 + t3[j] * t35 + d_x[j] * t42 + t20 * t24 + t6 * t18;
            K[0 * 8 + j] = K[21 * 8 + j] = t44; /* K(0,0) K(3,3) */
            const real t45 = t0[j] * t16 + d_y[j] * t17;
            const real t46 = t0[j] * t22 + d_y[j] * t23;
            const real t47 = d_y[j] * t42 + t20 * t46 + t6 * t45 - t3[j] * t38;
            K[1 * 8 + j] = K[6 * 8 + j] = K[22 * 8 + j] = K[27 * 8 + j] = t47; /* K(0,1) K(1,0) K(3,4) K(4,3) */
            const real t48 = t3[j] * t37 + t13[j] * t34;
            const real t49 = sin_p[j] * el_y[j] + cos_p[j] * el_x[j];
            const real t50 = d_x[j] * t48 - t0[j] * t37 - t49 * t24;
            K[15 * 8 + j] = K[20 * 8 + j] = t50; /* K(2,3) K(3,2) */
            K[2 * 8 + j] = K[12 * 8 + j] = -t50; /* K(0,2) K(2,0) */
            K[3 * 8 + j] = K[18 * 8 + j] = -t44; /* K(0,3) K(3,0) */
            K[4 * 8 + j] = K[9 * 8 + j] = K[19 * 8 + j] = K[24 * 8 + j] = -t47; /* K(0,4) K(1,3) K(3,1) K(4,0) */
            const real t51 = t3[j] * t36 + t13[j] * t31;
            const real t52 = sin_q[j] * el_y[j] + cos_q[j] * el_x[j];
            const real t53 = d_x[j] * t51 - t0[j] * t36 - t52 * t18;
            K[23 * 8 + j] = K[33 * 8 + j] = t53; /* K(3,5) K(5,3) */
            K[5 * 8 + j] = K[30 * 8 + j] = -t53; /* K(0,5) K(5,0) */
            const real t54 = t43 + (cos_p[j] * t0[j] + t13[j] * t19) * t46 + (cos_q[j] * t0[j] + t13[j] * t5) * t45;
            const real t55 = t54 - t13[j] * t38 - d_y[j] * (t2[j] * t38 + t13[j] * t41);
            K[7 * 8 + j] = K[28 * 8 + j] = t55; /* K(1,1) K(4,4) */
            const real t56 = d_y[j] * t48 - t0[j] * t34 - t49 * t46;
            K[16 * 8 + j] = K[26 * 8 + j] = t56; /* K(2,4) K(4,2) */
            K[8 * 8 + j] = K[13 * 8 + j] = -t56; /* K(1,2) K(2,1) */
            K[10 * 8 + j] = K[25 * 8 + j] = -t55; /* K(1,4) K(4,1) */
            const real t57 = d_y[j] * t51 - t0[j] * t31 - t52 * t45;
            K[29 * 8 + j] = K[34 * 8 + j] = t57; /* K(4,5) K(5,4) */
            K[11 * 8 + j] = K[31 * 8 + j] = -t57; /* K(1,5) K(5,1) */
            K[14 * 8 + j] = 0.13333333333333333 * (t49 * t49 * t8[j]) - t27 * t33; /* K(2,2) */
            const real t58 = t52 * t8[j];
            K[17 * 8 + j] = K[32 * 8 + j] = -(0.03333333333333333 * (t49 * t58)); /* K(2,5) K(5,2) */
            K[35 * 8 + j] = 0.13333333333333333 * (t52 * t58) - t25 * t30; /* K(5,5) */
        }
    }
}

/* inertia: 321 operations.
 * in:  x (6), v (6), p (9)
 * out: M (6,6), h (6), f (6), U (1) */
FLEXEL_CLONES
static void planar_beam_inertia(size_t nblocks, const real *const *in, real *const *out)
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
static void planar_beam_tangent(size_t nblocks, const real *const *in, real *const *out)
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

/* outputs: 348 operations.
 * in:  x (6), sigma (3), tau (0), p (9)
 * out: force_p (2), moment_p (1), force_q (2), moment_q (1), shear_angle (1), bend_range (2), shear_range (2), axis
 *   (17,2), across (2,2) */
FLEXEL_CLONES
static void planar_beam_outputs(size_t nblocks, const real *const *in, real *const *out)
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
        real t0[8], cos_p[8], d_x[8], d_y[8], t1[8], t2[8], t3[8], cos_q[8], el_y[8], sin_q[8], el_x[8], t6[8],
            sin_p[8], t17[8], t18[8], t20[8], t22[8], t24[8], t25[8], t26[8], t27[8], t28[8], t29[8], t30[8], t31[8],
            t32[8], t33[8], t35[8], t37[8], t38[8], t39[8], t41[8], t43[8], t44[8], t45[8], t47[8], t49[8], t50[8],
            t51[8], t53[8], t55[8], t56[8], t57[8], t59[8], t61[8], t62[8], t63[8], t65[8], t67[8], t68[8], t69[8],
            t71[8], t73[8], t74[8], t75[8], t77[8];
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
            t2[j] = t1[j] * t1[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t3[j] = rq_angle + alphaq0;
            el_y[j] = d_y[j] * t1[j];
            el_x[j] = d_x[j] * t1[j];
            const real l0 = p[0 * 8 + j];
            const real t5 = 1.0 / l0;
            const real sigma_elongation = sigma[0 * 8 + j];
            t6[j] = t5 * sigma_elongation;
            const real GAy = p[6 * 8 + j];
            const real t19 = t5 * t5;
            const real EIz = p[5 * 8 + j];
            const real phi_y = 12.0 * (1.0 / GAy * (EIz * t19));
            t20[j] = real_abs(phi_y);
            const real t21 = 1.0 / (1.0 + phi_y);
            t22[j] = real_sqrt(t19 * t21 * t21);
            t33[j] = 0.98876953125 * p_x + 0.01123046875 * q_x;
            t35[j] = 0.98876953125 * p_y + 0.01123046875 * q_y;
            t37[j] = 0.95703125 * p_x + 0.04296875 * q_x;
            t38[j] = 0.95703125 * p_y + 0.04296875 * q_y;
            t39[j] = 0.90771484375 * p_x + 0.09228515625 * q_x;
            t41[j] = 0.90771484375 * p_y + 0.09228515625 * q_y;
            t43[j] = 0.84375 * p_x + 0.15625 * q_x;
            t44[j] = 0.84375 * p_y + 0.15625 * q_y;
            t45[j] = 0.76806640625 * p_x + 0.23193359375 * q_x;
            t47[j] = 0.76806640625 * p_y + 0.23193359375 * q_y;
            t49[j] = 0.68359375 * p_x + 0.31640625 * q_x;
            t50[j] = 0.68359375 * p_y + 0.31640625 * q_y;
            t51[j] = 0.59326171875 * p_x + 0.40673828125 * q_x;
            t53[j] = 0.59326171875 * p_y + 0.40673828125 * q_y;
            t55[j] = 0.5 * (p_x + q_x);
            t56[j] = 0.5 * (p_y + q_y);
            t57[j] = 0.40673828125 * p_x + 0.59326171875 * q_x;
            t59[j] = 0.40673828125 * p_y + 0.59326171875 * q_y;
            t61[j] = 0.31640625 * p_x + 0.68359375 * q_x;
            t62[j] = 0.31640625 * p_y + 0.68359375 * q_y;
            t63[j] = 0.23193359375 * p_x + 0.76806640625 * q_x;
            t65[j] = 0.23193359375 * p_y + 0.76806640625 * q_y;
            t67[j] = 0.15625 * p_x + 0.84375 * q_x;
            t68[j] = 0.15625 * p_y + 0.84375 * q_y;
            t69[j] = 0.09228515625 * p_x + 0.90771484375 * q_x;
            t71[j] = 0.09228515625 * p_y + 0.90771484375 * q_y;
            t73[j] = 0.04296875 * p_x + 0.95703125 * q_x;
            t74[j] = 0.04296875 * p_y + 0.95703125 * q_y;
            t75[j] = 0.01123046875 * p_x + 0.98876953125 * q_x;
            t77[j] = 0.01123046875 * p_y + 0.98876953125 * q_y;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            across[1 * 8 + j] = cos_p[j]; /* across(0,1) */
            cos_q[j] = real_cos(t3[j]);
            across[3 * 8 + j] = cos_q[j]; /* across(1,1) */
            sin_q[j] = real_sin(t3[j]);
            sin_p[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t4 = cos_q[j] * el_y[j] - sin_q[j] * el_x[j];
            const real l0 = p[0 * 8 + j];
            const real t7 = l0 * t4 * t6[j];
            const real sigma_bend2 = sigma[2 * 8 + j];
            const real t8 = cos_p[j] * el_y[j] - sin_p[j] * el_x[j];
            const real b5 = l0 * t8;
            const real t9 = b5 * t6[j];
            const real t10 = 0.13333333333333333 * t7 - sigma_bend2 - 0.03333333333333333 * t9;
            const real t11 = l0 * t10;
            const real sigma_bend1 = sigma[1 * 8 + j];
            const real t12 = sigma_bend1 + 0.13333333333333333 * t9 - 0.03333333333333333 * t7;
            const real t13 = l0 * t12;
            const real t14 = cos_q[j] * t11 + cos_p[j] * t13;
            const real t15 = sin_q[j] * t11 + sin_p[j] * t13;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t16 = t1[j] * (sigma_elongation - t2[j] * (d_y[j] * t14 - d_x[j] * t15));
            const real q_fx = d_x[j] * t16 - t1[j] * t15;
            const real q_fy = d_y[j] * t16 + t1[j] * t14;
            force_p[0 * 8 + j] = cos_p[j] * q_fx + sin_p[j] * q_fy;
            force_p[1 * 8 + j] = cos_p[j] * q_fy - sin_p[j] * q_fx;
            t17[j] = sin_p[j] * el_y[j] + cos_p[j] * el_x[j];
            moment_p[0 * 8 + j] = t17[j] * t13;
            force_q[0 * 8 + j] = cos_q[j] * q_fx + sin_q[j] * q_fy;
            force_q[1 * 8 + j] = cos_q[j] * q_fy - sin_q[j] * q_fx;
            t18[j] = sin_q[j] * el_y[j] + cos_q[j] * el_x[j];
            moment_q[0 * 8 + j] = -(t18[j] * t11);
            const real t23 = real_abs(l0 * (t8 + t4)) * t22[j] * t20[j];
            t24[j] = 0.5 * t23;
            shear_angle[0 * 8 + j] = t24[j];
            t25[j] = real_abs(t8);
            t27[j] = real_abs(t4);
            shear_range[0 * 8 + j] = 28.64788975654116 * t23;
            const real t34 = l0 * (0.054931640625 * cos_p[j] - 0.003662109375 * cos_q[j]);
            axis[2 * 8 + j] = t33[j] + t34; /* axis(1,0) */
            const real t36 = l0 * (0.054931640625 * sin_p[j] - 0.003662109375 * sin_q[j]);
            axis[3 * 8 + j] = t35[j] + t36; /* axis(1,1) */
            axis[4 * 8 + j] = t37[j] + l0 * (0.095703125 * cos_p[j] - 0.013671875 * cos_q[j]); /* axis(2,0) */
            axis[5 * 8 + j] = t38[j] + l0 * (0.095703125 * sin_p[j] - 0.013671875 * sin_q[j]); /* axis(2,1) */
            const real t40 = l0 * (0.123779296875 * cos_p[j] - 0.028564453125 * cos_q[j]);
            axis[6 * 8 + j] = t39[j] + t40; /* axis(3,0) */
            const real t42 = l0 * (0.123779296875 * sin_p[j] - 0.028564453125 * sin_q[j]);
            axis[7 * 8 + j] = t41[j] + t42; /* axis(3,1) */
            axis[8 * 8 + j] = t43[j] + l0 * (0.140625 * cos_p[j] - 0.046875 * cos_q[j]); /* axis(4,0) */
            axis[9 * 8 + j] = t44[j] + l0 * (0.140625 * sin_p[j] - 0.046875 * sin_q[j]); /* axis(4,1) */
            const real t46 = l0 * (0.147705078125 * cos_p[j] - 0.067138671875 * cos_q[j]);
            axis[10 * 8 + j] = t45[j] + t46; /* axis(5,0) */
            const real t48 = l0 * (0.147705078125 * sin_p[j] - 0.067138671875 * sin_q[j]);
            axis[11 * 8 + j] = t47[j] + t48; /* axis(5,1) */
            axis[12 * 8 + j] = t49[j] + l0 * (0.146484375 * cos_p[j] - 0.087890625 * cos_q[j]); /* axis(6,0) */
            axis[13 * 8 + j] = t50[j] + l0 * (0.146484375 * sin_p[j] - 0.087890625 * sin_q[j]); /* axis(6,1) */
            const real t52 = l0 * (0.138427734375 * cos_p[j] - 0.107666015625 * cos_q[j]);
            axis[14 * 8 + j] = t51[j] + t52; /* axis(7,0) */
            const real t54 = l0 * (0.138427734375 * sin_p[j] - 0.107666015625 * sin_q[j]);
            axis[15 * 8 + j] = t53[j] + t54; /* axis(7,1) */
            axis[16 * 8 + j] = t55[j] + 0.125 * l0 * (cos_p[j] - cos_q[j]); /* axis(8,0) */
            axis[17 * 8 + j] = t56[j] + 0.125 * l0 * (sin_p[j] - sin_q[j]); /* axis(8,1) */
            const real t58 = l0 * (0.107666015625 * cos_p[j] - 0.138427734375 * cos_q[j]);
            axis[18 * 8 + j] = t57[j] + t58; /* axis(9,0) */
            const real t60 = l0 * (0.107666015625 * sin_p[j] - 0.138427734375 * sin_q[j]);
            axis[19 * 8 + j] = t59[j] + t60; /* axis(9,1) */
            axis[20 * 8 + j] = t61[j] + l0 * (0.087890625 * cos_p[j] - 0.146484375 * cos_q[j]); /* axis(10,0) */
            axis[21 * 8 + j] = t62[j] + l0 * (0.087890625 * sin_p[j] - 0.146484375 * sin_q[j]); /* axis(10,1) */
            const real t64 = l0 * (0.067138671875 * cos_p[j] - 0.147705078125 * cos_q[j]);
            axis[22 * 8 + j] = t63[j] + t64; /* axis(11,0) */
            const real t66 = l0 * (0.067138671875 * sin_p[j] - 0.147705078125 * sin_q[j]);
            axis[23 * 8 + j] = t65[j] + t66; /* axis(11,1) */
            axis[24 * 8 + j] = t67[j] + l0 * (0.046875 * cos_p[j] - 0.140625 * cos_q[j]); /* axis(12,0) */
            axis[25 * 8 + j] = t68[j] + l0 * (0.046875 * sin_p[j] - 0.140625 * sin_q[j]); /* axis(12,1) */
            const real t70 = l0 * (0.028564453125 * cos_p[j] - 0.123779296875 * cos_q[j]);
            axis[26 * 8 + j] = t69[j] + t70; /* axis(13,0) */
            const real t72 = l0 * (0.028564453125 * sin_p[j] - 0.123779296875 * sin_q[j]);
            axis[27 * 8 + j] = t71[j] + t72; /* axis(13,1) */
            axis[28 * 8 + j] = t73[j] + l0 * (0.013671875 * cos_p[j] - 0.095703125 * cos_q[j]); /* axis(14,0) */
            axis[29 * 8 + j] = t74[j] + l0 * (0.013671875 * sin_p[j] - 0.095703125 * sin_q[j]); /* axis(14,1) */
            const real t76 = l0 * (0.003662109375 * cos_p[j] - 0.054931640625 * cos_q[j]);
            axis[30 * 8 + j] = t75[j] + t76; /* axis(15,0) */
            const real t78 = l0 * (0.003662109375 * sin_p[j] - 0.054931640625 * sin_q[j]);
            axis[31 * 8 + j] = t77[j] + t78; /* axis(15,1) */
            across[0 * 8 + j] = -sin_p[j]; /* across(0,0) */
            across[2 * 8 + j] = -sin_q[j]; /* across(1,0) */
        }
        for (size_t j = 0; j < 8; j++) {
            t26[j] = real_atan2(t25[j], t17[j]);
            t28[j] = real_atan2(t27[j], t18[j]);
            t32[j] = real_sin(t24[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            t29[j] = t26[j] + t28[j];
            bend_range[0 * 8 + j] = 57.29577951308232 * t29[j];
            t31[j] = 1.0 / real_max(t29[j], 1e-09);
            shear_range[1 * 8 + j] = 100.0 * (t32[j] * t32[j]);
        }
        for (size_t j = 0; j < 8; j++) {
            t30[j] = real_sin(t29[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            bend_range[1 * 8 + j] = 100.0 * ((t29[j] - t30[j]) * t31[j]);
        }
    }
}

const flexel_element flexel_planar_beam = {
    .name = "planar_beam",
    .digest = "7b74389e30f35162",
    .n = 6,
    .m = 3,
    .k = 0,
    .np = 9,
    .position = planar_beam_position,
    .acceleration = planar_beam_acceleration,
    .rates = planar_beam_rates,
    .kinematics = planar_beam_kinematics,
    .stiffness = planar_beam_stiffness,
    .inertia = planar_beam_inertia,
    .tangent = planar_beam_tangent,
    .outputs = planar_beam_outputs,
};
