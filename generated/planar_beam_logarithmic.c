/* planar_beam_logarithmic: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
 * phi_y = 12 EIz/(GAy l0^2): shear number
 * turn = angle_q + alphaq0 - angle_p - alpha0;  along, across: components of xq - xp on the direction halfway
 * straight = (along + l0 turn^2 (1/24 - turn^2/1920 + turn^4/322560), across): the chord without what uniform bending
 *       takes from it
 * bow = across/(phi_y l0 + |straight|): mean angle of the sections from the direction halfway; the shear angle is
 *       phi_y bow
 * elongation = straight_x + l0 (3/5 + phi_y) bow^2 - l0
 * bend1, bend2 = l0 (turn/2 + (1 + phi_y) bow), l0 (turn/2 - (1 + phi_y) bow)
 * T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
 *    the shear-corrected (phi_y) cubic shapes
 * U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)
 * f = De'sigma: force_p, moment_p = -(ex_p.f_xp, ey_p.f_xp), -f_angle_p; force_q, moment_q the same at q, without
 *   minus
 * axis: places on the cubic axis; across: ey_p, ey_q
 *
 * Source: Reissner 1972, ZAMP 23 (strains of a rod); corotational directions as Crisfield 1990
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

/* position: 110 operations.
 * in:  x (6), p (9)
 * out: e (3), De (3,6), V (0,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (9 * 8);
        real *restrict e = out[0] + b * (3 * 8);
        real *restrict De = out[1] + b * (18 * 8);
        real mean[8], cos_mean[8], d_x[8], sin_mean[8], d_y[8], t5[8], t9[8], t11[8], t13[8], t14[8], t25[8], t26[8],
            t29[8], t32[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real alpha0 = p[1 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            const real rp_angle = x[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            mean[j] = 0.5 * (alpha0 + alphaq0 + rp_angle + rq_angle);
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real turn = rq_angle + alphaq0 - alpha0 - rp_angle;
            const real t1 = turn * turn;
            const real t2 = 3.1001984126984127e-06 * t1;
            const real t3 = 0.0005208333333333333 - t2;
            const real t4 = 0.041666666666666664 - t1 * t3;
            const real l0 = p[0 * 8 + j];
            t5[j] = l0 * t4 * t1;
            const real t7 = 1.0 / l0;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t8 = 1.0 / GAy * EIz * t7 * t7;
            t9[j] = 12.0 * (l0 * t8);
            const real phi_y = 12.0 * t8;
            t11[j] = l0 * (0.6 + phi_y);
            t13[j] = 0.5 * turn;
            t14[j] = 1.0 + phi_y;
            t25[j] = l0 * turn * (t4 + t1 * (t2 - t3));
            t26[j] = 2.0 * t25[j];
            t29[j] = l0 * t14[j];
            t32[j] = 0.5 * l0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_mean[j] = real_cos(mean[j]);
            sin_mean[j] = real_sin(mean[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t0 = cos_mean[j] * d_x[j] + sin_mean[j] * d_y[j];
            const real straight_x = t0 + t5[j];
            const real straight_y = cos_mean[j] * d_y[j] - sin_mean[j] * d_x[j];
            const real t6 = real_sqrt(straight_y * straight_y + straight_x * straight_x);
            const real t10 = 1.0 / (t6 + t9[j]);
            const real bow = straight_y * t10;
            const real t12 = bow * t11[j];
            const real l0 = p[0 * 8 + j];
            e[0 * 8 + j] = straight_x + bow * t12 - l0;
            const real t15 = bow * t14[j];
            e[1 * 8 + j] = l0 * (t13[j] + t15);
            e[2 * 8 + j] = l0 * (t13[j] - t15);
            const real t16 = 1.0 / t6 * (t10 * t10 * straight_y);
            const real t17 = straight_x * t16;
            const real t18 = t10 - straight_y * t16;
            const real t19 = cos_mean[j] * t17 + sin_mean[j] * t18;
            const real t20 = cos_mean[j] - 2.0 * t12 * t19;
            De[3 * 8 + j] = t20; /* De(0,3) */
            De[0 * 8 + j] = -t20; /* De(0,0) */
            const real t21 = cos_mean[j] * t18 - sin_mean[j] * t17;
            const real t22 = sin_mean[j] + 2.0 * t12 * t21;
            De[4 * 8 + j] = t22; /* De(0,4) */
            De[1 * 8 + j] = -t22; /* De(0,1) */
            const real t23 = straight_y * t17 + t0 * t18;
            const real t24 = 0.5 * (straight_y - 2.0 * t12 * t23);
            const real t27 = t17 * t25[j];
            const real t28 = t26[j] - 4.0 * t12 * t27;
            De[2 * 8 + j] = t24 - t28; /* De(0,2) */
            De[5 * 8 + j] = t28 + t24; /* De(0,5) */
            const real t30 = t29[j] * t19;
            De[6 * 8 + j] = De[15 * 8 + j] = t30; /* De(1,0) De(2,3) */
            const real t31 = t29[j] * t21;
            De[10 * 8 + j] = De[13 * 8 + j] = t31; /* De(1,4) De(2,1) */
            De[7 * 8 + j] = De[16 * 8 + j] = -t31; /* De(1,1) De(2,4) */
            const real t33 = 2.0 * t29[j] * t27;
            const real t34 = t32[j] - t33;
            const real t35 = 0.5 * t29[j] * t23;
            De[8 * 8 + j] = -(t34 + t35); /* De(1,2) */
            De[9 * 8 + j] = De[12 * 8 + j] = -t30; /* De(1,3) De(2,0) */
            De[11 * 8 + j] = t34 - t35; /* De(1,5) */
            const real t36 = t32[j] + t33;
            De[14 * 8 + j] = t35 - t36; /* De(2,2) */
            De[17 * 8 + j] = t36 + t35; /* De(2,5) */
        }
    }
}

/* acceleration: 163 operations.
 * in:  x (6), v (6), p (9)
 * out: g (3), gs (0) */
FLEXEL_CLONES
static void planar_beam_logarithmic_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict g = out[0] + b * (3 * 8);
        real t0[8], mean[8], cos_mean[8], t1[8], d_x[8], d_y[8], sin_mean[8], t6[8], t18[8], t22[8], t23[8], t25[8],
            t30[8], t42[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t0[j] = q_vy - p_vy;
            const real alpha0 = p[1 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            const real rp_angle = x[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            mean[j] = 0.5 * (alpha0 + alphaq0 + rp_angle + rq_angle);
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t1[j] = rp_vangle + rq_vangle;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t6[j] = q_vx - p_vx;
            const real turn = rq_angle + alphaq0 - alpha0 - rp_angle;
            const real t9 = turn * turn;
            const real t10 = 0.0005208333333333333 - 3.1001984126984127e-06 * t9;
            const real t11 = 0.041666666666666664 - t9 * t10;
            const real t12 = rq_vangle - rp_vangle;
            const real t13 = t12 * t12;
            const real t14 = turn * t12;
            const real t15 = t14 * (2.0 * t10 - 6.200396825396825e-06 * t9);
            const real t16 = t14 * t14;
            const real t17 = 2.0 * (t10 * t13 - 6.200396825396825e-06 * t16) - 6.200396825396825e-06 * (2.0 * t16 + t9
                * t13);
            const real l0 = p[0 * 8 + j];
            t18[j] = l0 * (2.0 * (t11 * t13 - 2.0 * t14 * t15) - t9 * t17);
            const real t20 = 1.0 / l0;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t21 = 1.0 / GAy * EIz * t20 * t20;
            const real phi_y = 12.0 * t21;
            t22[j] = l0 * (0.6 + phi_y);
            t23[j] = l0 * t11 * t9;
            t25[j] = 12.0 * (l0 * t21);
            t30[j] = l0 * (2.0 * t11 * t14 - t9 * t15);
            t42[j] = l0 * (1.0 + phi_y);
        }
        for (size_t j = 0; j < 8; j++) {
            cos_mean[j] = real_cos(mean[j]);
            sin_mean[j] = real_sin(mean[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t2 = cos_mean[j] * t1[j];
            const real t3 = t1[j] * t2;
            const real t4 = sin_mean[j] * t1[j];
            const real t5 = t1[j] * t4;
            const real t7 = t6[j] * t4;
            const real t8 = 2.0 * t0[j] * t2 - 0.5 * (d_x[j] * t3 + d_y[j] * t5) - t7;
            const real t19 = 0.5 * (t8 - t7) + t18[j];
            const real straight_y = cos_mean[j] * d_y[j] - sin_mean[j] * d_x[j];
            const real straight_x = cos_mean[j] * d_x[j] + sin_mean[j] * d_y[j] + t23[j];
            const real t24 = real_sqrt(straight_y * straight_y + straight_x * straight_x);
            const real t26 = 1.0 / (t24 + t25[j]);
            const real t27 = cos_mean[j] * t0[j] - 0.5 * (d_y[j] * t4 + d_x[j] * t2) - sin_mean[j] * t6[j];
            const real t28 = t26 * t26;
            const real t29 = 1.0 / t24;
            const real t31 = cos_mean[j] * t6[j] + sin_mean[j] * t0[j] + 0.5 * (d_y[j] * t2 - d_x[j] * t4);
            const real t32 = t30[j] + t31;
            const real t33 = t29 * (straight_x * t32 + straight_y * t27);
            const real t34 = t28 * t33;
            const real t35 = (t26 * t27 - straight_y * t34) * (t26 * t27 - straight_y * t34);
            const real bow = straight_y * t26;
            const real t36 = t0[j] * t4;
            const real t37 = t6[j] * t2;
            const real t38 = t37 + 0.5 * (d_y[j] * t3 - d_x[j] * t5) + t37 + t36 + t36;
            const real t39 = t32 * t32 + straight_x * t19 + t27 * t27 - 0.5 * straight_y * t38;
            const real t40 = 2.0 * t29 * t28 * (t39 - t33 * t33) - 4.0 * t26 * t34 * t33;
            const real t41 = 4.0 * t27 * t34 + straight_y * t40 + t26 * t38;
            g[0 * 8 + j] = t19 + 2.0 * t22[j] * (t35 - 0.5 * bow * t41);
            const real t43 = 0.5 * t42[j] * t41;
            g[2 * 8 + j] = t43;
            g[1 * 8 + j] = -t43;
        }
    }
}

/* rates: 241 operations.
 * in:  x (6), v (6), p (9)
 * out: Phi_x (3,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict Phi_x = out[0] + b * (18 * 8);
        real d_y[8], mean[8], cos_mean[8], d_x[8], sin_mean[8], t5[8], t8[8], t10[8], t12[8], t20[8], t22[8], t30[8],
            t54[8], t56[8], t66[8], t67[8], t70[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real rp_angle = x[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            mean[j] = 0.5 * (rp_angle + rq_angle + alpha0 + alphaq0);
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real turn = rq_angle + alphaq0 - alpha0 - rp_angle;
            const real t1 = turn * turn;
            const real t2 = 3.1001984126984127e-06 * t1;
            const real t3 = 0.0005208333333333333 - t2;
            const real t4 = 0.041666666666666664 - t1 * t3;
            const real l0 = p[0 * 8 + j];
            t5[j] = l0 * t1 * t4;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t7 = 1.0 / GAy * (1.0 / l0 * (1.0 / l0) * EIz);
            t8[j] = 12.0 * (l0 * t7);
            const real phi_y = 12.0 * t7;
            t10[j] = l0 * (0.6 + phi_y);
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t12[j] = rp_vangle + rq_vangle;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t20[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t22[j] = q_vx - p_vx;
            const real t26 = rq_vangle - rp_vangle;
            const real t27 = turn * t26;
            const real t28 = t1 * t27;
            const real t29 = 2.0 * t3 * t27 - 6.200396825396825e-06 * t28;
            t30[j] = l0 * (2.0 * t4 * t27 - t1 * t29);
            t54[j] = t20[j] - 0.5 * d_x[j] * t12[j];
            t56[j] = t22[j] + 0.5 * d_y[j] * t12[j];
            const real t63 = t26 * (2.0 * t4 - t1 * (2.0 * t3 - 6.200396825396825e-06 * t1));
            const real t64 = t2 - t3;
            const real t65 = turn * (2.0 * t64 * t27 + 1.240079365079365e-05 * t28 - t29);
            t66[j] = l0 * (t63 + 2.0 * t65);
            t67[j] = l0 * (t4 + t1 * t64) * turn;
            t70[j] = l0 * (1.0 + phi_y);
        }
        for (size_t j = 0; j < 8; j++) {
            cos_mean[j] = real_cos(mean[j]);
            sin_mean[j] = real_sin(mean[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real straight_y = d_y[j] * cos_mean[j] - d_x[j] * sin_mean[j];
            const real t0 = d_x[j] * cos_mean[j] + d_y[j] * sin_mean[j];
            const real straight_x = t0 + t5[j];
            const real t6 = real_sqrt(straight_x * straight_x + straight_y * straight_y);
            const real t9 = 1.0 / (t6 + t8[j]);
            const real bow = straight_y * t9;
            const real t11 = bow * t10[j];
            const real t13 = t12[j] * sin_mean[j];
            const real t14 = 1.0 / t6;
            const real t15 = t9 * t9;
            const real t16 = t14 * t15;
            const real t17 = straight_x * t16;
            const real t18 = t12[j] * cos_mean[j];
            const real t19 = straight_y * t16;
            const real t21 = t20[j] * cos_mean[j] - 0.5 * (d_y[j] * t13 + d_x[j] * t18);
            const real t23 = t21 - t22[j] * sin_mean[j];
            const real t24 = straight_y * t14;
            const real t25 = t24 * t15;
            const real t31 = t30[j] + 0.5 * (d_y[j] * t18 - d_x[j] * t13) + t22[j] * cos_mean[j];
            const real t32 = t20[j] * sin_mean[j] + t31;
            const real t33 = straight_y * t23 + straight_x * t32;
            const real t34 = t14 * t33;
            const real t35 = t15 * t34;
            const real t36 = t9 * t34;
            const real t37 = t15 * t33 * t14 * t14;
            const real t38 = t35 + straight_y * (t23 * t16 - 2.0 * t36 * t25 - t24 * t37);
            const real t39 = t23 * t25 + t38;
            const real t40 = 0.5 * (straight_y * (t13 * t17 + t18 * t19) - t9 * t18) + sin_mean[j] * t39;
            const real t41 = straight_x * t14;
            const real t42 = t15 * t41;
            const real t43 = t23 * t42 + straight_y * (t16 * t32 - 2.0 * t36 * t42 - t41 * t37);
            const real t44 = t40 - cos_mean[j] * t43;
            const real t45 = t9 * t23 - straight_y * t35;
            const real t46 = straight_y * t10[j] * t45;
            const real t47 = t46 * t42;
            const real t48 = t9 * t10[j] * t45 - t46 * t25;
            const real t49 = 2.0 * (t11 * t44 - cos_mean[j] * t47 - sin_mean[j] * t48);
            const real t50 = t49 - 0.5 * t13;
            Phi_x[3 * 8 + j] = t50; /* Phi_x(0,3) */
            Phi_x[0 * 8 + j] = -t50; /* Phi_x(0,0) */
            const real t51 = cos_mean[j] * t39 + sin_mean[j] * t43 + 0.5 * (t9 * t13 + straight_y * (t18 * t17 - t13
                * t19));
            const real t52 = 2.0 * (cos_mean[j] * t48 - sin_mean[j] * t47 - t11 * t51);
            const real t53 = 0.5 * t18 + t52;
            Phi_x[4 * 8 + j] = t53; /* Phi_x(0,4) */
            Phi_x[1 * 8 + j] = -t53; /* Phi_x(0,1) */
            const real t55 = cos_mean[j] * t54[j];
            const real t57 = sin_mean[j] * t56[j];
            const real t58 = sin_mean[j] * t54[j] + cos_mean[j] * t56[j];
            const real t59 = t0 * t39 - straight_y * (t17 * (t55 - t57) + t43 - t19 * t58);
            const real t60 = t59 - t9 * t58;
            const real t61 = t55 + 2.0 * (t11 * t60 - straight_y * t47 - t0 * t48) - t57;
            const real t62 = 0.5 * t61;
            const real t68 = straight_y * t17 * t66[j] + 2.0 * t67[j] * t43;
            const real t69 = t66[j] - 4.0 * t67[j] * t47 - 2.0 * t11 * t68;
            Phi_x[2 * 8 + j] = t62 - t69; /* Phi_x(0,2) */
            Phi_x[5 * 8 + j] = t69 + t62; /* Phi_x(0,5) */
            const real t71 = t70[j] * t44;
            Phi_x[9 * 8 + j] = Phi_x[12 * 8 + j] = t71; /* Phi_x(1,3) Phi_x(2,0) */
            Phi_x[6 * 8 + j] = Phi_x[15 * 8 + j] = -t71; /* Phi_x(1,0) Phi_x(2,3) */
            const real t72 = t70[j] * t51;
            Phi_x[7 * 8 + j] = Phi_x[16 * 8 + j] = t72; /* Phi_x(1,1) Phi_x(2,4) */
            const real t73 = t70[j] * t68;
            const real t74 = 0.5 * t70[j] * t60;
            const real t75 = t73 + t74;
            Phi_x[8 * 8 + j] = t75; /* Phi_x(1,2) */
            Phi_x[10 * 8 + j] = Phi_x[13 * 8 + j] = -t72; /* Phi_x(1,4) Phi_x(2,1) */
            const real t76 = t74 - t73;
            Phi_x[11 * 8 + j] = t76; /* Phi_x(1,5) */
            Phi_x[14 * 8 + j] = -t75; /* Phi_x(2,2) */
            Phi_x[17 * 8 + j] = -t76; /* Phi_x(2,5) */
        }
    }
}

/* kinematics: 739 operations.
 * in:  x (6), v (6), a (6), p (9)
 * out: Psi_x (3,6), Psi_v (3,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict Psi_x = out[0] + b * (18 * 8);
        real *restrict Psi_v = out[1] + b * (18 * 8);
        real mean[8], cos_mean[8], d_y[8], sin_mean[8], d_x[8], t6[8], t11[8], t15[8], t16[8], t17[8], t21[8], t27[8],
            t46[8], t55[8], t56[8], t57[8], t76[8], t123[8], t125[8], t126[8], t127[8], t129[8], t131[8], t133[8],
            t149[8], t151[8], t153[8], t158[8], t163[8], t167[8], t169[8], t195[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real alpha0 = p[1 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            const real rp_angle = x[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            mean[j] = 0.5 * (alpha0 + alphaq0 + rp_angle + rq_angle);
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real turn = rq_angle + alphaq0 - alpha0 - rp_angle;
            const real t1 = turn * turn;
            const real t2 = 3.1001984126984127e-06 * t1;
            const real t3 = 0.0005208333333333333 - t2;
            const real t4 = 0.041666666666666664 - t1 * t3;
            const real l0 = p[0 * 8 + j];
            const real t5 = l0 * t1;
            t6[j] = t4 * t5;
            const real t9 = 1.0 / l0;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t10 = 1.0 / GAy * EIz * t9 * t9;
            t11[j] = 12.0 * (l0 * t10);
            const real phi_y = 12.0 * t10;
            t15[j] = l0 * (0.6 + phi_y);
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t16[j] = q_vy - p_vy;
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t17[j] = rp_vangle + rq_vangle;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t21[j] = q_vx - p_vx;
            const real t23 = rq_vangle - rp_vangle;
            const real t24 = turn * t23;
            const real t25 = t1 * t24;
            const real t26 = 2.0 * t3 * t24 - 6.200396825396825e-06 * t25;
            t27[j] = l0 * (2.0 * t4 * t24 - t1 * t26);
            const real rp_aangle = a[2 * 8 + j];
            const real rq_aangle = a[5 * 8 + j];
            t46[j] = rp_aangle + rq_aangle;
            const real t51 = rq_aangle - rp_aangle;
            const real t52 = turn * t51;
            const real t53 = t1 * t52;
            const real t54 = 2.0 * t3 * t52 - 6.200396825396825e-06 * t53;
            t55[j] = l0 * (2.0 * t4 * t52 - t1 * t54);
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t56[j] = q_ax - p_ax;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t57[j] = q_ay - p_ay;
            const real t72 = t23 * t23;
            const real t73 = t24 * t24;
            const real t74 = t1 * t72;
            const real t75 = 2.0 * (t3 * t72 - 6.200396825396825e-06 * t73) - 6.200396825396825e-06 * (2.0 * t73
                + t74);
            t76[j] = l0 * (2.0 * (t4 * t72 - 2.0 * t24 * t26) - t1 * t75);
            t123[j] = t57[j] - 0.5 * d_x[j] * t46[j];
            const real t124 = d_y[j] * t17[j];
            t125[j] = t17[j] * (t21[j] + 0.25 * t124);
            t126[j] = t123[j] - t125[j];
            t127[j] = t56[j] + 0.5 * d_y[j] * t46[j];
            const real t128 = d_x[j] * t17[j];
            t129[j] = t17[j] * (t16[j] - 0.25 * t128);
            t131[j] = t16[j] - 0.5 * t128;
            t133[j] = t21[j] + 0.5 * t124;
            const real t147 = t2 - t3;
            const real t148 = l0 * (1.240079365079365e-05 * t53 - t54 + 2.0 * t147 * t52);
            t149[j] = turn * t148;
            const real t150 = l0 * t4;
            t151[j] = turn * (t150 + t147 * t5);
            const real t152 = 2.0 * t3 - 6.200396825396825e-06 * t1;
            t153[j] = l0 * t51 * (2.0 * t4 - t1 * t152);
            const real t154 = l0 * t24;
            const real t155 = 2.0 * t147 * t154;
            const real t156 = turn * (1.240079365079365e-05 * (t5 * t24) + t155 - l0 * t26);
            const real t157 = t23 * t152;
            t158[j] = 2.0 * (t150 * t23 + t156) - t5 * t157;
            const real t160 = l0 * (1.240079365079365e-05 * t74 + 2.0 * t147 * t72 - t75);
            const real t161 = 2.0 * turn * (4.96031746031746e-05 * (t24 * t154) + t160);
            const real t162 = l0 * (4.96031746031746e-05 * t25 - 4.0 * t26) * t23 + t161;
            t163[j] = t162 - 4.0 * t157 * t154;
            t167[j] = t153[j] + t163[j];
            t169[j] = l0 * (1.0 + phi_y);
            const real t194 = 2.0 * turn * (l0 * (1.240079365079365e-05 * t25 - t26) + t155);
            t195[j] = l0 * (2.0 * t4 * t23 - t1 * t157) + t194;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_mean[j] = real_cos(mean[j]);
            sin_mean[j] = real_sin(mean[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real straight_y = cos_mean[j] * d_y[j] - sin_mean[j] * d_x[j];
            const real t0 = cos_mean[j] * d_x[j] + sin_mean[j] * d_y[j];
            const real straight_x = t0 + t6[j];
            const real t7 = real_sqrt(straight_y * straight_y + straight_x * straight_x);
            const real t8 = 1.0 / t7;
            const real t12 = 1.0 / (t11[j] + t7);
            const real t13 = t12 * t12;
            const real t14 = t8 * t13;
            const real t18 = sin_mean[j] * t17[j];
            const real t19 = cos_mean[j] * t17[j];
            const real t20 = cos_mean[j] * t16[j] - 0.5 * (d_y[j] * t18 + d_x[j] * t19);
            const real t22 = t20 - sin_mean[j] * t21[j];
            const real t28 = cos_mean[j] * t21[j] + sin_mean[j] * t16[j] + t27[j] + 0.5 * (d_y[j] * t19 - d_x[j]
                * t18);
            const real t29 = straight_y * t22 + t28 * straight_x;
            const real t30 = t8 * t29;
            const real t31 = t13 * t30;
            const real t32 = t22 * t12 - straight_y * t31;
            const real t33 = straight_y * t32 * t15[j];
            const real t34 = t14 * t33;
            const real t35 = straight_y * t19 + t18 * straight_x;
            const real bow = straight_y * t12;
            const real t36 = t15[j] * bow;
            const real t37 = t17[j] * t18;
            const real t38 = straight_y * t14;
            const real t39 = t17[j] * t19;
            const real t40 = straight_x * t14;
            const real t41 = t28 * t14;
            const real t42 = straight_y * (0.5 * (t37 * t38 - t39 * t40) - 2.0 * t18 * t41);
            const real t43 = 2.0 * t31;
            const real t44 = t22 * t14;
            const real t45 = t43 + 2.0 * straight_y * t44;
            const real t47 = sin_mean[j] * t46[j];
            const real t48 = straight_x * t38;
            const real t49 = cos_mean[j] * t46[j];
            const real t50 = t12 - straight_y * t38;
            const real t58 = cos_mean[j] * t56[j] + sin_mean[j] * t57[j] + t55[j] + 0.5 * (d_y[j] * t49 - d_x[j]
                * t47);
            const real t59 = cos_mean[j] * t57[j] - 0.5 * (d_y[j] * t47 + d_x[j] * t49);
            const real t60 = t59 - sin_mean[j] * t56[j];
            const real t61 = straight_x * t58 + straight_y * t60;
            const real t62 = straight_y * t61 * t13;
            const real t63 = straight_y * t8;
            const real t64 = t8 * t8;
            const real t65 = t63 * t64;
            const real t66 = t8 * t61;
            const real t67 = t13 * t66;
            const real t68 = t63 * t13;
            const real t69 = t60 - 2.0 * bow * t66;
            const real t70 = t21[j] * t18;
            const real t71 = 2.0 * t16[j] * t19 - 0.5 * (d_x[j] * t39 + d_y[j] * t37) - t70;
            const real t77 = 0.5 * (t71 - t70) + t76[j];
            const real t78 = t16[j] * t18;
            const real t79 = t21[j] * t19;
            const real t80 = t79 + 0.5 * (d_y[j] * t39 - d_x[j] * t37) + t79 + t78 + t78;
            const real t81 = t22 * t22 + t28 * t28 + straight_x * t77 - 0.5 * straight_y * t80;
            const real t82 = t30 * t64;
            const real t83 = t8 * t81 - t29 * t82;
            const real t84 = t12 * t31;
            const real t85 = 2.0 * t13 * t83 - 4.0 * t30 * t84;
            const real t86 = t13 * t29;
            const real t87 = t86 * t64;
            const real t88 = t87 + 2.0 * t84;
            const real t89 = t13 * (2.0 * t81 - 4.0 * t30 * t30) - 2.0 * t29 * t88;
            const real t90 = 4.0 * t12 * t83 - 4.0 * t30 * t31;
            const real t91 = t85 - straight_y * (t68 * t90 + t80 * t14 + t65 * t89) - t80 * t68;
            const real t92 = t12 * t30;
            const real t93 = t22 - straight_y * t92;
            const real t94 = t14 * t93 - 0.5 * straight_y * (t13 * t82 + t8 * t88);
            const real t95 = 4.0 * t92 * t68;
            const real t96 = t95 + 2.0 * t86 * t65;
            const real t97 = t62 * t65 - t67 - t38 * t60 - t68 * t69 - (0.5 * t91 + 2.0 * t22 * t94 - t93 * t96);
            const real t98 = 0.5 * (t42 - t19 * t45 - (t47 * t48 - t49 * t50)) + sin_mean[j] * t97;
            const real t99 = straight_x * t8;
            const real t100 = t99 * t64;
            const real t101 = t13 * t99;
            const real t102 = t62 * t100 - t38 * t58 - t101 * t69;
            const real t103 = t98 - 0.25 * t37 * t12 - t94 * t35 - cos_mean[j] * t102;
            const real t104 = t12 * t32 * t15[j];
            const real t105 = 4.0 * t92 * t101;
            const real t106 = t105 + 2.0 * t86 * t100;
            const real t107 = straight_y * (2.0 * t14 * t77 - t100 * t89 - t101 * t90) - t80 * t101;
            const real t108 = 0.5 * t107 + 2.0 * t28 * t94 - t93 * t106;
            const real t109 = t15[j] * (t12 * t60 - straight_y * t67);
            const real t110 = 4.0 * t22 * t31 + straight_y * t85 + t80 * t12;
            const real t111 = straight_y * t109 + t15[j] * (2.0 * t22 * t32 - 0.5 * straight_y * t110);
            const real t112 = 2.0 * (t33 * t106 - t36 * t108 - t101 * t111) - 4.0 * t28 * t34;
            const real t113 = 2.0 * (t34 * t35 - t36 * t103 - t19 * t104) + cos_mean[j] * t112;
            const real t114 = t12 * t109 + t33 * t96 - t15[j] * (0.5 * t12 * t110 + 2.0 * t31 * t32);
            const real t115 = 2.0 * (t114 - t68 * t111) - 4.0 * t22 * t34;
            const real t116 = t113 - 0.5 * t47 - 0.25 * t39 - sin_mean[j] * t115;
            Psi_x[3 * 8 + j] = t116; /* Psi_x(0,3) */
            Psi_x[0 * 8 + j] = -t116; /* Psi_x(0,0) */
            const real t117 = t19 * straight_x - straight_y * t18;
            const real t118 = straight_y * (2.0 * t19 * t41 - 0.5 * (t39 * t38 + t37 * t40));
            const real t119 = 0.5 * (t118 - t18 * t45 + (t49 * t48 + t47 * t50)) + t94 * t117;
            const real t120 = 0.25 * t39 * t12 + t119 - cos_mean[j] * t97 - sin_mean[j] * t102;
            const real t121 = 0.5 * t49 + sin_mean[j] * t112 + cos_mean[j] * t115 - 2.0 * (t34 * t117 + t36 * t120
                + t18 * t104);
            const real t122 = t121 - 0.25 * t37;
            Psi_x[4 * 8 + j] = t122; /* Psi_x(0,4) */
            Psi_x[1 * 8 + j] = -t122; /* Psi_x(0,1) */
            const real t130 = sin_mean[j] * t125[j];
            const real t132 = cos_mean[j] * t131[j];
            const real t134 = sin_mean[j] * t133[j];
            const real t135 = t132 - t134;
            const real t136 = sin_mean[j] * t131[j] + cos_mean[j] * t133[j];
            const real t137 = t135 * straight_x - straight_y * t136;
            const real t138 = sin_mean[j] * t129[j];
            const real t139 = 4.0 * t131[j] * t41 - 2.0 * (t129[j] * t38 + t125[j] * t40);
            const real t140 = 2.0 * (t130 * t38 - t138 * t40) + cos_mean[j] * t139 - 4.0 * t134 * t41;
            const real t141 = t0 * t97 + straight_y * (0.5 * t140 - t102) + 2.0 * t94 * t137;
            const real t142 = t12 * (cos_mean[j] * t129[j] - t130) + t141 + cos_mean[j] * (t123[j] * t48 + t127[j]
                * t50);
            const real t143 = t142 - t136 * t45 - sin_mean[j] * (t127[j] * t48 - t123[j] * t50);
            const real t144 = cos_mean[j] * t126[j] + straight_y * t112 - 2.0 * (t36 * t143 + 2.0 * t34 * t137);
            const real t145 = t144 - sin_mean[j] * t127[j] - t138 - 4.0 * t136 * t104 - t0 * t115;
            const real t146 = 0.5 * t145;
            const real t159 = t158[j] * straight_x;
            const real t164 = 0.5 * straight_y * (4.0 * t158[j] * t41 + 2.0 * t40 * t163[j]);
            const real t165 = 2.0 * (t159 * t94 - (t151[j] * t102 - t48 * t149[j])) + t164;
            const real t166 = t48 * t153[j] + t165;
            const real t168 = 2.0 * (t149[j] + t151[j] * t112 - t36 * t166) + t167[j] - 4.0 * t159 * t34;
            Psi_x[2 * 8 + j] = t146 - t168; /* Psi_x(0,2) */
            Psi_x[5 * 8 + j] = t168 + t146; /* Psi_x(0,5) */
            const real t170 = t169[j] * t108;
            const real t171 = t169[j] * t103 + cos_mean[j] * t170;
            Psi_x[6 * 8 + j] = Psi_x[15 * 8 + j] = t171; /* Psi_x(1,0) Psi_x(2,3) */
            const real t172 = t169[j] * t120 + sin_mean[j] * t170;
            Psi_x[7 * 8 + j] = Psi_x[16 * 8 + j] = t172; /* Psi_x(1,1) Psi_x(2,4) */
            const real t173 = t169[j] * t166 + 2.0 * t151[j] * t170;
            const real t174 = 0.5 * (t169[j] * t143 + straight_y * t170);
            const real t175 = t173 - t174;
            Psi_x[8 * 8 + j] = t175; /* Psi_x(1,2) */
            Psi_x[9 * 8 + j] = Psi_x[12 * 8 + j] = -t171; /* Psi_x(1,3) Psi_x(2,0) */
            Psi_x[10 * 8 + j] = Psi_x[13 * 8 + j] = -t172; /* Psi_x(1,4) Psi_x(2,1) */
            const real t176 = t173 + t174;
            Psi_x[17 * 8 + j] = t176; /* Psi_x(2,5) */
            Psi_x[11 * 8 + j] = -t176; /* Psi_x(1,5) */
            Psi_x[14 * 8 + j] = -t175; /* Psi_x(2,2) */
            const real t177 = 0.5 * (t43 + straight_y * (2.0 * (t44 - t63 * t87) - t95));
            const real t178 = t22 * t68 + t177;
            const real t179 = 0.5 * (straight_y * (t18 * t40 + t19 * t38) - t19 * t12) + sin_mean[j] * t178;
            const real t180 = t22 * t101 + 0.5 * straight_y * (2.0 * (t41 - t99 * t87) - t105);
            const real t181 = t179 - cos_mean[j] * t180;
            const real t182 = t33 * t101;
            const real t183 = t104 - t33 * t68;
            const real t184 = 2.0 * (t36 * t181 - cos_mean[j] * t182 - sin_mean[j] * t183);
            const real t185 = 2.0 * (t184 - 0.5 * t18);
            Psi_v[3 * 8 + j] = t185; /* Psi_v(0,3) */
            Psi_v[0 * 8 + j] = -t185; /* Psi_v(0,0) */
            const real t186 = sin_mean[j] * t180 + 0.5 * (t18 * t12 + straight_y * (t19 * t40 - t18 * t38));
            const real t187 = cos_mean[j] * t178 + t186;
            const real t188 = 2.0 * (cos_mean[j] * t183 - (sin_mean[j] * t182 + t36 * t187));
            const real t189 = 2.0 * (0.5 * t19 + t188);
            Psi_v[4 * 8 + j] = t189; /* Psi_v(0,4) */
            Psi_v[1 * 8 + j] = -t189; /* Psi_v(0,1) */
            const real t190 = t0 * t178 - straight_y * (t180 + t135 * t40 - t136 * t38);
            const real t191 = t190 - t136 * t12;
            const real t192 = t132 + 2.0 * (t36 * t191 - straight_y * t182 - t0 * t183);
            const real t193 = 0.5 * (t192 - t134);
            const real t196 = straight_y * t195[j] * t40 + 2.0 * t151[j] * t180;
            const real t197 = t195[j] - 4.0 * t151[j] * t182 - 2.0 * t36 * t196;
            Psi_v[2 * 8 + j] = 2.0 * (t193 - t197); /* Psi_v(0,2) */
            Psi_v[5 * 8 + j] = 2.0 * (t197 + t193); /* Psi_v(0,5) */
            const real t198 = 2.0 * t169[j] * t181;
            Psi_v[9 * 8 + j] = Psi_v[12 * 8 + j] = t198; /* Psi_v(1,3) Psi_v(2,0) */
            Psi_v[6 * 8 + j] = Psi_v[15 * 8 + j] = -t198; /* Psi_v(1,0) Psi_v(2,3) */
            const real t199 = 2.0 * t169[j] * t187;
            Psi_v[7 * 8 + j] = Psi_v[16 * 8 + j] = t199; /* Psi_v(1,1) Psi_v(2,4) */
            const real t200 = t169[j] * t196;
            const real t201 = 0.5 * t169[j] * t191;
            const real t202 = 2.0 * (t200 + t201);
            Psi_v[8 * 8 + j] = t202; /* Psi_v(1,2) */
            Psi_v[10 * 8 + j] = Psi_v[13 * 8 + j] = -t199; /* Psi_v(1,4) Psi_v(2,1) */
            const real t203 = 2.0 * (t201 - t200);
            Psi_v[11 * 8 + j] = t203; /* Psi_v(1,5) */
            Psi_v[14 * 8 + j] = -t202; /* Psi_v(2,2) */
            Psi_v[17 * 8 + j] = -t203; /* Psi_v(2,5) */
        }
    }
}

/* stiffness: 226 operations.
 * in:  x (6), sigma (3), tau (0), p (9)
 * out: K (6,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict K = out[0] + b * (36 * 8);
        real mean[8], sin_mean[8], d_x[8], cos_mean[8], d_y[8], turn[8], t1[8], t4[8], t6[8], t9[8], t11[8], t15[8],
            t49[8], t50[8], t60[8], t61[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            mean[j] = 0.5 * (rp_angle + rq_angle + alpha0 + alphaq0);
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            turn[j] = rq_angle + alphaq0 - alpha0 - rp_angle;
            t1[j] = turn[j] * turn[j];
            const real t2 = 3.1001984126984127e-06 * t1[j];
            const real t3 = 0.0005208333333333333 - t2;
            t4[j] = 0.041666666666666664 - t1[j] * t3;
            const real l0 = p[0 * 8 + j];
            const real t5 = l0 * t1[j];
            t6[j] = t4[j] * t5;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t8 = 1.0 / GAy * (1.0 / l0 * (1.0 / l0) * EIz);
            t9[j] = 12.0 * (l0 * t8);
            const real phi_y = 12.0 * t8;
            const real sigma_elongation = sigma[0 * 8 + j];
            t11[j] = l0 * (0.6 + phi_y) * sigma_elongation;
            const real sigma_bend1 = sigma[1 * 8 + j];
            const real sigma_bend2 = sigma[2 * 8 + j];
            t15[j] = l0 * (sigma_bend1 - sigma_bend2) * (1.0 + phi_y);
            const real t48 = l0 * t4[j];
            t49[j] = t2 - t3;
            t50[j] = turn[j] * (t48 + t49[j] * t5);
            t60[j] = turn[j] * t49[j];
            t61[j] = t5 * t60[j] + turn[j] * t48;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_mean[j] = real_sin(mean[j]);
            cos_mean[j] = real_cos(mean[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t0 = d_x[j] * cos_mean[j] + d_y[j] * sin_mean[j];
            const real straight_x = t0 + t6[j];
            const real straight_y = d_y[j] * cos_mean[j] - d_x[j] * sin_mean[j];
            const real t7 = real_sqrt(straight_x * straight_x + straight_y * straight_y);
            const real t10 = 1.0 / (t7 + t9[j]);
            const real t12 = t10 * t11[j];
            const real t13 = 1.0 / t7;
            const real t14 = t10 * t10;
            const real bow = straight_y * t10;
            const real t16 = 2.0 * bow * t11[j] + t15[j];
            const real t17 = straight_y * t16;
            const real t18 = t14 * t17;
            const real t19 = t13 * t18;
            const real t20 = t14 * t16;
            const real t21 = straight_y * t13;
            const real t22 = t21 * t14;
            const real t23 = t13 * t20 + 2.0 * t22 * t12;
            const real t24 = 2.0 * t10 * t12 - t19 - straight_y * t23;
            const real t25 = sin_mean[j] * t24;
            const real t26 = straight_x * t23;
            const real t27 = straight_y * t14 * t11[j];
            const real t28 = 2.0 * (t13 * t14 * t10 * t17 + t22 * t27) + t13 * t13 * t18;
            const real t29 = straight_x * t28;
            const real t30 = straight_x * t13;
            const real t31 = cos_mean[j] * t30 - sin_mean[j] * t21;
            const real t32 = sin_mean[j] * t26 + t29 * t31 - cos_mean[j] * t19;
            const real t33 = straight_y * t28 - t20 - 2.0 * t10 * t27;
            const real t34 = sin_mean[j] * t33;
            const real t35 = sin_mean[j] * t25 + cos_mean[j] * t32 - t34 * t31;
            K[0 * 8 + j] = K[21 * 8 + j] = t35; /* K(0,0) K(3,3) */
            const real t36 = sin_mean[j] * t30 + cos_mean[j] * t21;
            const real t37 = t29 * t36 - sin_mean[j] * t19 - cos_mean[j] * t26;
            const real t38 = cos_mean[j] * (t37 - t25) - t34 * t36;
            K[1 * 8 + j] = K[6 * 8 + j] = K[22 * 8 + j] = K[27 * 8 + j] = t38; /* K(0,1) K(1,0) K(3,4) K(4,3) */
            const real t39 = t0 * t24;
            const real t40 = 0.5 * straight_x * t19;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t41 = sigma_elongation - t40 - t40;
            const real t42 = t39 - t41;
            const real t43 = straight_y * t19;
            const real t44 = t10 * t16 - t43;
            const real t45 = t0 * t33;
            const real t46 = sin_mean[j] * t42 + straight_y * t32 - cos_mean[j] * t44 - t45 * t31;
            const real t47 = 0.5 * t46;
            const real t51 = 2.0 * t50[j] * t32;
            const real t52 = t47 - t51;
            K[15 * 8 + j] = K[20 * 8 + j] = t52; /* K(2,3) K(3,2) */
            K[2 * 8 + j] = K[12 * 8 + j] = -t52; /* K(0,2) K(2,0) */
            K[3 * 8 + j] = K[18 * 8 + j] = -t35; /* K(0,3) K(3,0) */
            K[4 * 8 + j] = K[9 * 8 + j] = K[19 * 8 + j] = K[24 * 8 + j] = -t38; /* K(0,4) K(1,3) K(3,1) K(4,0) */
            const real t53 = t51 + t47;
            K[23 * 8 + j] = K[33 * 8 + j] = t53; /* K(3,5) K(5,3) */
            K[5 * 8 + j] = K[30 * 8 + j] = -t53; /* K(0,5) K(5,0) */
            const real t54 = cos_mean[j] * (cos_mean[j] * t24 + t33 * t36) + sin_mean[j] * t37;
            K[7 * 8 + j] = K[28 * 8 + j] = t54; /* K(1,1) K(4,4) */
            const real t55 = straight_y * t37 - cos_mean[j] * t42 - sin_mean[j] * t44 - t45 * t36;
            const real t56 = 0.5 * t55;
            const real t57 = 2.0 * t50[j] * t37;
            const real t58 = t56 - t57;
            K[16 * 8 + j] = K[26 * 8 + j] = t58; /* K(2,4) K(4,2) */
            K[8 * 8 + j] = K[13 * 8 + j] = -t58; /* K(1,2) K(2,1) */
            K[10 * 8 + j] = K[25 * 8 + j] = -t54; /* K(1,4) K(4,1) */
            const real t59 = t57 + t56;
            K[29 * 8 + j] = K[34 * 8 + j] = t59; /* K(4,5) K(5,4) */
            K[11 * 8 + j] = K[31 * 8 + j] = -t59; /* K(1,5) K(5,1) */
            const real l0 = p[0 * 8 + j];
            const real t62 = l0 * t41;
            const real t63 = t1[j] * t62;
            const real t64 = turn[j] * (1.240079365079365e-05 * t63 + 2.0 * t49[j] * t62);
            const real t65 = t49[j] * t63 + t4[j] * t62 + turn[j] * (t64 + 2.0 * t60[j] * t62);
            const real t66 = 2.0 * (2.0 * t61[j] * (t30 * t29 - t19) * t50[j] + t65);
            const real t67 = straight_y * t30 - t0 * t21;
            const real t68 = t0 * t26 + t29 * t67 - t43;
            const real t69 = t0 * t39 + straight_y * t68 - sin_mean[j] * (d_y[j] * t41 - d_x[j] * t44);
            const real t70 = t69 - cos_mean[j] * (d_y[j] * t44 + d_x[j] * t41) - t45 * t67;
            const real t71 = 0.5 * t70;
            const real t72 = t50[j] * t68;
            const real t73 = 2.0 * t72;
            K[14 * 8 + j] = t66 + 0.5 * (t71 - t73) - t72; /* K(2,2) */
            const real t74 = 0.5 * (t73 + t71);
            const real t75 = t66 + t72;
            K[17 * 8 + j] = K[32 * 8 + j] = t74 - t75; /* K(2,5) K(5,2) */
            K[35 * 8 + j] = t75 + t74; /* K(5,5) */
        }
    }
}

/* inertia: 321 operations.
 * in:  x (6), v (6), p (9)
 * out: M (6,6), h (6), f (6), U (1) */
FLEXEL_CLONES
static void planar_beam_logarithmic_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict M = out[0] + b * (36 * 8);
        real *restrict h = out[1] + b * (6 * 8);
        real *restrict f = out[2] + b * (6 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real t0[8], t1[8], t2[8], sin_p[8], t3[8], sin_q[8], d_x[8], d_y[8], t5[8], t6[8], t9[8], t10[8], cos_p[8],
            cos_q[8], t16[8], t17[8], t19[8], t21[8], t27[8], t30[8], t32[8], t41[8], t42[8], t45[8], t48[8], t60[8],
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
            t6[j] = t5[j] * t5[j];
            const real t7 = 1.0 / l0;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t8 = 1.0 / GAy * EIz * t7 * t7;
            const real phi_y = 12.0 * t8;
            const real rhoJ = p[4 * 8 + j];
            t9[j] = 1.0 / (1.0 + phi_y) * (1.0 / (1.0 + phi_y)) * l0 * rhoJ;
            t10[j] = t6[j] * t9[j];
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
            t45[j] = 0.25 * (rp_vangle + rq_vangle) * t16[j];
            t48[j] = t5[j] * (d_x[j] * t42[j] + d_y[j] * t41[j]) * t6[j];
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
            const real t37 = t19[j] * t36;
            const real t38 = rq_vangle * t37;
            const real rp_vangle = v[2 * 8 + j];
            const real t39 = rp_vangle * cos_p[j];
            const real t40 = t39 + t36;
            const real t43 = t13 * t41[j] - t42[j] * t4;
            const real t44 = t5[j] * t43;
            const real t46 = 0.3 * (t44 * t9[j]) + t45[j];
            const real t47 = t5[j] * t46;
            const real t49 = rp_vangle * sin_p[j];
            const real t50 = rq_vangle * sin_q[j];
            const real t51 = t49 + t50;
            const real t52 = t5[j] * (t41[j] * t51 + t42[j] * t40) + t43 * t48[j];
            const real t53 = t46 * t48[j] + 0.3 * (t5[j] * t52 * t9[j]);
            const real t54 = t40 * t47 - t4 * t53;
            const real t55 = t19[j] * t39;
            const real t56 = rp_vangle * t55;
            const real t57 = 0.030952380952380953 * t38 + t54 - 0.05238095238095238 * t56;
            const real t58 = t44 * t6[j] * t46;
            const real t59 = d_x[j] * t58;
            h[0 * 8 + j] = t57 - t59;
            const real t61 = t60[j] * t50;
            const real t62 = t51 * t47 + t13 * t53;
            const real t64 = t63[j] * t49;
            const real t65 = 0.030952380952380953 * t61 + t62 - 0.05238095238095238 * t64;
            const real t66 = d_y[j] * t58;
            h[1 * 8 + j] = t65 - t66;
            const real t68 = 0.01904761904761905 * ((sin_p[j] * t39 - cos_p[j] * t49) * t67[j]);
            const real t72 = t41[j] * t47;
            const real t73 = t71[j] + t72 + 0.009523809523809525 * (cos_p[j] * t69[j]);
            const real t76 = sin_p[j] * (t73 - 0.007142857142857143 * (cos_q[j] * t75[j]));
            const real t77 = cos_q[j] * t49 + cos_p[j] * t50;
            const real t78 = t33 * t39 + sin_p[j] * t36 * t27[j];
            const real t79 = t76 + 0.007142857142857143 * (t74[j] * t77 - rq_vangle * t78);
            const real t81 = 0.25 * t16[j] * t52;
            const real t84 = 0.009523809523809525 * (sin_p[j] * t69[j]) - t82[j] - 0.007142857142857143 * (t83[j]
                * t33);
            const real t85 = t42[j] * t47;
            h[2 * 8 + j] = t68 + t79 - t19[j] * t49 * t70[j] - t55 * t80[j] - t81 - cos_p[j] * (t84 - t85);
            const real t86 = 0.05238095238095238 * t38 + t59 - 0.030952380952380953 * t56;
            h[3 * 8 + j] = t86 - t54;
            const real t87 = 0.05238095238095238 * t61 + t66 - 0.030952380952380953 * t64;
            h[4 * 8 + j] = t87 - t62;
            const real t89 = 0.007142857142857143 * (rp_vangle * (t27[j] * t77 - t78));
            const real t93 = 0.009523809523809525 * (cos_q[j] * t91[j]) + t72 - t92[j];
            const real t94 = sin_q[j] * (t93 - 0.007142857142857143 * (cos_p[j] * t75[j]));
            const real t95 = 0.01904761904761905 * (t74[j] * (sin_q[j] * t36 - cos_q[j] * t50));
            const real t96 = t94 + t95 + t37 * t90[j] + t89 + t19[j] * t50 * t88[j] - t81;
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

/* tangent: 752 operations.
 * in:  x (6), v (6), a (6), p (9)
 * out: R_x (6,6), R_v (6,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_tangent(size_t nblocks, const real *const *in, real *const *out)
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
            t52[8], t53[8], t54[8], t56[8], t57[8], t63[8], t68[8], t70[8], t73[8], t76[8], t82[8], t85[8], t101[8],
            t106[8], t107[8], t108[8], t109[8], t113[8], t124[8], t128[8], t130[8], t131[8], t132[8], t138[8],
            t142[8], t148[8], t150[8], t152[8], t154[8], t159[8], t161[8], t167[8], t169[8], t172[8], t178[8],
            t179[8], t232[8], t236[8], t238[8], t262[8], t264[8], t265[8], t267[8];
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
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            const real GAy = p[6 * 8 + j];
            const real l0 = p[0 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real phi_y = 12.0 * (1.0 / GAy * (1.0 / l0 * (1.0 / l0) * EIz));
            const real t9 = 1.0 / (1.0 + phi_y);
            const real rhoJ = p[4 * 8 + j];
            t10[j] = l0 * rhoJ * t9 * t9;
            t11[j] = (phi_y - 0.2) * t10[j];
            t12[j] = 0.25 * (rp_vangle + rq_vangle) * t11[j];
            t17[j] = t0[j] * t1[j];
            t18[j] = t6[j] * t17[j];
            t19[j] = t0[j] * t10[j];
            t21[j] = d_x[j] * t17[j];
            const real rp_aangle = a[2 * 8 + j];
            const real rq_aangle = a[5 * 8 + j];
            t22[j] = 0.25 * (rp_aangle + rq_aangle) * t11[j];
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
            t52[j] = t19[j] * t34[j];
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
            const real t72 = rp_vangle * t68[j];
            t73[j] = 0.05238095238095238 * t72;
            t76[j] = t55 - rq_vangle * t56[j];
            const real t81 = rq_aangle * t68[j];
            t82[j] = 0.030952380952380953 * t81;
            const real t84 = rq_vangle * t68[j];
            t85[j] = 0.030952380952380953 * t84;
            t101[j] = l0 * l0 * t67;
            const real t105 = 0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy;
            const real gravity_x = p[7 * 8 + j];
            t106[j] = 0.08333333333333333 * (gravity_x * t68[j]);
            t107[j] = t72 * t105 + t106[j];
            t108[j] = rq_vangle * t101[j];
            t109[j] = rp_vangle * t108[j];
            t113[j] = t68[j] * (0.05238095238095238 * p_ax + 0.030952380952380953 * q_ax);
            const real t122 = q_vy * t68[j];
            const real t123 = p_vy * t68[j];
            t124[j] = 0.030952380952380953 * t122 + 0.05238095238095238 * t123;
            const real t127 = p_ay * t68[j];
            t128[j] = 0.05238095238095238 * t127;
            const real t129 = q_ay * t68[j];
            t130[j] = 0.030952380952380953 * t129;
            t131[j] = rp_vangle * rq_vangle;
            t132[j] = rq_aangle * t101[j];
            const real gravity_y = p[8 * 8 + j];
            t138[j] = 0.08333333333333333 * (gravity_y * t68[j]);
            t142[j] = t131[j] * t101[j];
            t148[j] = 0.030952380952380953 * t72;
            t150[j] = 0.030952380952380953 * t69;
            t152[j] = 0.05238095238095238 * t81;
            t154[j] = 0.05238095238095238 * t84;
            t159[j] = rp_vangle * t101[j];
            t161[j] = rp_aangle * t101[j];
            t167[j] = 0.05238095238095238 * t122 + 0.030952380952380953 * t123;
            t169[j] = t68[j] * (0.030952380952380953 * p_ax + 0.05238095238095238 * q_ax);
            const real t171 = 0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy;
            t172[j] = t84 * t171;
            t178[j] = 0.030952380952380953 * t127;
            t179[j] = 0.05238095238095238 * t129;
            t232[j] = t68[j] * t105;
            const real t234 = q_vx * t68[j];
            const real t235 = p_vx * t68[j];
            t236[j] = 0.030952380952380953 * t234 + 0.05238095238095238 * t235;
            t238[j] = t68[j] * (0.030952380952380953 * q_vx + 0.05238095238095238 * p_vx);
            t262[j] = t68[j] * (0.05238095238095238 * q_vx + 0.030952380952380953 * p_vx);
            t264[j] = 0.030952380952380953 * t235;
            t265[j] = 0.05238095238095238 * t234;
            t267[j] = t68[j] * t171;
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
            const real t39 = t35 + 0.3 * (t19[j] * t37 - t34[j] * t38) - 0.5 * t14 * t36[j];
            const real t40 = 0.3 * (t19[j] * t20) + t21[j] * t39 + t14 * t18[j];
            const real t41 = t13 * t1[j];
            const real t42 = 0.3 * (t41 * t38) + 3.0 * t15;
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
            const real t61 = t0[j] * t14;
            const real t62 = 0.3 * (t19[j] * t41) + t1[j] * t61;
            const real t64 = d_x[j] * t62 - 0.3 * (t29 * t63[j]);
            const real t65 = t51 * t64;
            const real t66 = t0[j] * t35 - t34[j] * t14;
            const real t71 = t66 - t70[j];
            const real t74 = t61 - t73[j];
            R_x[2 * 8 + j] = t65 + cos_p[j] * t71 + t60 - t24 * t74; /* R_x(0,2) */
            R_x[3 * 8 + j] = R_x[18 * 8 + j] = -t45; /* R_x(0,3) R_x(3,0) */
            R_x[4 * 8 + j] = R_x[19 * 8 + j] = -t50; /* R_x(0,4) R_x(3,1) */
            const real t75 = sin_q[j] * t5[j] + cos_q[j] * t6[j];
            const real t77 = t34[j] * t75 - cos_q[j] * t53[j] - t28 * t54[j] - sin_q[j] * t76[j];
            const real t78 = t75 * t52[j] + t19[j] * t77;
            const real t79 = 0.3 * (t7 * t78);
            const real t80 = t75 * t64;
            const real t83 = t82[j] + t66;
            const real t86 = t85[j] + t61;
            R_x[5 * 8 + j] = t80 + cos_q[j] * t83 + t79 - t25 * t86; /* R_x(0,5) */
            const real t87 = d_y[j] * t42 - t26 * t43;
            const real t88 = t21[j] * t87 + t4 * t40;
            R_x[9 * 8 + j] = R_x[24 * 8 + j] = t88; /* R_x(1,3) R_x(4,0) */
            R_x[6 * 8 + j] = R_x[27 * 8 + j] = -t88; /* R_x(1,0) R_x(4,3) */
            const real t89 = t16 - t48[j] * t87 - t4 * t49;
            R_x[7 * 8 + j] = R_x[28 * 8 + j] = t89; /* R_x(1,1) R_x(4,4) */
            const real t90 = d_y[j] * t62 - 0.3 * (t26 * t63[j]);
            const real t91 = t51 * t90;
            const real t92 = 0.3 * (t4 * t59);
            R_x[8 * 8 + j] = t91 + sin_p[j] * t71 + t27 * t74 - t92; /* R_x(1,2) */
            R_x[10 * 8 + j] = R_x[25 * 8 + j] = -t89; /* R_x(1,4) R_x(4,1) */
            const real t93 = t75 * t90;
            const real t94 = 0.3 * (t4 * t78);
            R_x[11 * 8 + j] = t93 + sin_q[j] * t83 + t28 * t86 - t94; /* R_x(1,5) */
            const real t95 = 0.25 * t11[j] * t20;
            const real t96 = 0.25 * t11[j] * t37;
            const real t97 = t96 + t51 * t43;
            const real t98 = t95 + t21[j] * t97;
            R_x[12 * 8 + j] = t98; /* R_x(2,0) */
            const real t99 = 0.25 * t11[j] * t47;
            const real t100 = t99 + t48[j] * t97;
            R_x[13 * 8 + j] = t100; /* R_x(2,1) */
            const real t102 = sin_p[j] * t101[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t103 = rp_aangle * t102;
            const real t104 = t5[j] * t61;
            const real t110 = sin_q[j] * t101[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t111 = rq_aangle * t110;
            const real t112 = t104 + t107[j] + 0.01904761904761905 * t103 - 0.007142857142857143 * (cos_q[j] * t109[j]
                + t111);
            const real t114 = t101[j] * t27;
            const real t115 = cos_p[j] * t101[j];
            const real t116 = 0.01904761904761905 * (rp_vangle * (cos_p[j] * t114 - t27 * t115));
            const real t117 = 0.25 * t11[j] * t58;
            const real t118 = cos_q[j] * t27;
            const real t119 = t101[j] * t28;
            const real t120 = cos_p[j] * t119;
            const real t121 = 0.007142857142857143 * (t108[j] * t118 - rq_vangle * t120);
            const real t125 = t117 + t121 + t116 + cos_p[j] * (t112 - t113[j]) - t27 * t124[j];
            const real t126 = t6[j] * t61;
            const real t133 = rp_vangle * t110;
            const real t134 = t131[j] * t110 + t108[j] * t25 - cos_q[j] * t132[j] - rq_vangle * t133;
            const real t135 = rp_vangle * t102;
            const real t136 = 0.01904761904761905 * (rp_aangle * t115 + rp_vangle * (t135 - t101[j] * t24));
            const real t137 = 0.007142857142857143 * t134 + t136 + t130[j] + t128[j] + t126;
            const real t139 = t51 * t63[j];
            R_x[14 * 8 + j] = t125 - sin_p[j] * (t137 - t138[j]) - 0.3 * (t51 * t139); /* R_x(2,2) */
            R_x[15 * 8 + j] = -t98; /* R_x(2,3) */
            R_x[16 * 8 + j] = -t100; /* R_x(2,4) */
            const real t140 = 0.25 * t11[j] * t77;
            const real t141 = cos_p[j] * t28;
            const real t143 = t108[j] * t141 + cos_q[j] * (cos_p[j] * t142[j] - rq_aangle * t102);
            const real t144 = cos_q[j] * t114;
            const real t145 = rq_vangle * t102;
            const real t146 = t108[j] * t24 - sin_p[j] * t109[j] - cos_p[j] * t132[j] - rq_vangle * t145;
            const real t147 = 0.007142857142857143 * (t143 - rq_vangle * t144 - sin_q[j] * t146);
            R_x[17 * 8 + j] = t140 + t147 - 0.3 * (t75 * t139); /* R_x(2,5) */
            const real t149 = t148[j] + t61;
            const real t151 = t150[j] + t66;
            R_x[20 * 8 + j] = t24 * t149 - cos_p[j] * t151 - t65 - t60; /* R_x(3,2) */
            const real t153 = t152[j] - t66;
            const real t155 = t154[j] - t61;
            R_x[23 * 8 + j] = cos_q[j] * t153 - t25 * t155 - t80 - t79; /* R_x(3,5) */
            R_x[26 * 8 + j] = t92 - t27 * t149 - sin_p[j] * t151 - t91; /* R_x(4,2) */
            R_x[29 * 8 + j] = t94 + sin_q[j] * t153 + t28 * t155 - t93; /* R_x(4,5) */
            const real t156 = t96 + t75 * t43;
            const real t157 = t95 + t21[j] * t156;
            R_x[30 * 8 + j] = t157; /* R_x(5,0) */
            const real t158 = t99 + t48[j] * t156;
            R_x[31 * 8 + j] = t158; /* R_x(5,1) */
            const real t160 = t159[j] * t118 + cos_p[j] * (cos_q[j] * t142[j] - rp_aangle * t110);
            const real t162 = t25 * t159[j] - sin_q[j] * t109[j] - cos_q[j] * t161[j] - rp_vangle * t133;
            const real t163 = 0.007142857142857143 * (t160 - rp_vangle * t120 - sin_p[j] * t162);
            const real t164 = t75 * t63[j];
            R_x[32 * 8 + j] = t117 + t163 - 0.3 * (t51 * t164); /* R_x(5,2) */
            R_x[33 * 8 + j] = -t157; /* R_x(5,3) */
            R_x[34 * 8 + j] = -t158; /* R_x(5,4) */
            const real t165 = cos_q[j] * t101[j];
            const real t166 = 0.01904761904761905 * (rq_vangle * (cos_q[j] * t119 - t28 * t165));
            const real t168 = 0.007142857142857143 * (t159[j] * t141 - rp_vangle * t144);
            const real t170 = t104 + t169[j] + 0.01904761904761905 * t111 - 0.007142857142857143 * (cos_p[j] * t109[j]
                + t103);
            const real t173 = t140 + t168 + cos_q[j] * (t170 - t172[j] - t106[j]) + t28 * t167[j];
            const real t174 = sin_p[j] * t131[j] * t101[j] + t24 * t159[j] - cos_p[j] * t161[j];
            const real t175 = rq_vangle * t110;
            const real t176 = 0.01904761904761905 * (rq_aangle * t165 + rq_vangle * (t175 - t101[j] * t25));
            const real t177 = 0.007142857142857143 * (t174 - rp_vangle * t145) + t176 + t138[j];
            const real t180 = t166 + t173 - sin_q[j] * (t126 + t177 - t178[j] - t179[j]);
            R_x[35 * 8 + j] = t180 - 0.3 * (t75 * t164); /* R_x(5,5) */
            const real t181 = t7 * t19[j];
            const real t182 = t8 * t17[j];
            const real t183 = d_x[j] * t182;
            const real t184 = t7 * t34[j];
            const real t185 = t0[j] * t29;
            const real t186 = t183 + t184 - t185;
            const real t187 = t17[j] * t14;
            const real t188 = d_x[j] * t187;
            const real t189 = t184 - t185 - t183;
            const real t190 = 0.3 * (t19[j] * t189) - t188;
            const real t191 = 0.3 * (t181 * t186) + t7 * (t188 + t190);
            R_v[3 * 8 + j] = R_v[18 * 8 + j] = t191; /* R_v(0,3) R_v(3,0) */
            R_v[0 * 8 + j] = R_v[21 * 8 + j] = -t191; /* R_v(0,0) R_v(3,3) */
            const real t192 = t4 * t19[j];
            const real t193 = d_y[j] * t187;
            const real t194 = t0[j] * t26;
            const real t195 = d_y[j] * t182;
            const real t196 = t4 * t34[j];
            const real t197 = t194 + t195 + t196;
            const real t198 = t193 + 0.3 * (t19[j] * t197);
            const real t199 = 0.3 * (t192 * t186) + t7 * t198 + t4 * t188;
            R_v[1 * 8 + j] = R_v[22 * 8 + j] = t199; /* R_v(0,1) R_v(3,4) */
            const real t200 = cos_p[j] * t74;
            const real t201 = t68[j] * t27;
            const real t202 = 0.05238095238095238 * t201;
            const real t203 = t0[j] * t51;
            const real t204 = t19[j] * t203;
            const real t205 = 0.3 * (t7 * t204);
            const real t206 = 0.25 * t11[j] * t186;
            R_v[2 * 8 + j] = t200 - t202 - t205 - t206; /* R_v(0,2) */
            R_v[4 * 8 + j] = R_v[19 * 8 + j] = -t199; /* R_v(0,4) R_v(3,1) */
            const real t207 = t68[j] * t28;
            const real t208 = 0.030952380952380953 * t207;
            const real t209 = cos_q[j] * t86;
            const real t210 = t0[j] * t75;
            const real t211 = t19[j] * t210;
            const real t212 = 0.3 * (t7 * t211);
            R_v[5 * 8 + j] = t208 + t209 - t212 - t206; /* R_v(0,5) */
            const real t213 = t195 - t194 - t196;
            const real t214 = t4 * t190 - t7 * t193 - 0.3 * (t181 * t213);
            R_v[6 * 8 + j] = R_v[27 * 8 + j] = t214; /* R_v(1,0) R_v(4,3) */
            const real t215 = 0.3 * (t192 * t213) + t4 * (t193 - t198);
            R_v[7 * 8 + j] = R_v[28 * 8 + j] = t215; /* R_v(1,1) R_v(4,4) */
            const real t216 = 0.3 * (t4 * t204);
            const real t217 = sin_p[j] * t74;
            const real t218 = t68[j] * t24;
            const real t219 = 0.05238095238095238 * t218;
            const real t220 = 0.25 * t11[j] * t213;
            R_v[8 * 8 + j] = t216 + t217 - t219 - t220; /* R_v(1,2) */
            R_v[9 * 8 + j] = R_v[24 * 8 + j] = -t214; /* R_v(1,3) R_v(4,0) */
            R_v[10 * 8 + j] = R_v[25 * 8 + j] = -t215; /* R_v(1,4) R_v(4,1) */
            const real t221 = 0.3 * (t4 * t211);
            const real t222 = t68[j] * t25;
            const real t223 = 0.030952380952380953 * t222;
            const real t224 = sin_q[j] * t86;
            R_v[11 * 8 + j] = t223 + t224 + t221 - t220; /* R_v(1,5) */
            const real t225 = cos_p[j] * t56[j] + sin_p[j] * t54[j];
            const real t226 = 0.3 * (t225 * t181);
            const real t227 = 0.25 * t11[j] * t189;
            R_v[12 * 8 + j] = t226 - t202 - t200 - t227; /* R_v(2,0) */
            const real t228 = 0.25 * t11[j] * t197;
            const real t229 = 0.3 * (t225 * t192);
            R_v[13 * 8 + j] = t228 - t219 - t217 - t229; /* R_v(2,1) */
            const real t230 = 0.25 * t11[j] * t225;
            const real t231 = 0.01904761904761905 * (t101[j] * (sin_p[j] * t27 - cos_p[j] * t24));
            const real t233 = 0.01904761904761905 * (cos_p[j] * t159[j] - rp_vangle * t115);
            const real t237 = sin_p[j] * t159[j];
            const real t239 = cos_p[j] * (t236[j] + 0.01904761904761905 * (t135 - t237) - t238[j]);
            const real t240 = sin_p[j] * (t232[j] + t233 - t124[j]) + t239 + t231 + t230;
            const real t241 = 0.25 * t11[j] * t203;
            R_v[14 * 8 + j] = t240 - t241; /* R_v(2,2) */
            const real t242 = cos_p[j] * t149;
            const real t243 = 0.030952380952380953 * t201;
            R_v[15 * 8 + j] = t227 + t242 - t243 - t226; /* R_v(2,3) */
            const real t244 = sin_p[j] * t149;
            const real t245 = 0.030952380952380953 * t218;
            R_v[16 * 8 + j] = t229 + t244 - t245 - t228; /* R_v(2,4) */
            const real t246 = 0.007142857142857143 * (cos_p[j] * sin_q[j] * t108[j]);
            const real t247 = 0.007142857142857143 * (cos_p[j] * t133);
            const real t248 = t101[j] * (cos_q[j] * t24 + cos_p[j] * t25) - t110 * t27 - sin_p[j] * t119;
            const real t249 = 0.007142857142857143 * t248;
            const real t250 = 0.007142857142857143 * (cos_q[j] * t237);
            const real t251 = 0.007142857142857143 * (cos_q[j] * t145);
            const real t252 = 0.25 * t11[j] * t210;
            R_v[17 * 8 + j] = t247 + t249 + t246 + t230 - t250 - t251 - t252; /* R_v(2,5) */
            R_v[20 * 8 + j] = t205 + t206 - t243 - t242; /* R_v(3,2) */
            const real t253 = 0.05238095238095238 * t207;
            const real t254 = cos_q[j] * t155;
            R_v[23 * 8 + j] = t253 + t254 + t212 + t206; /* R_v(3,5) */
            R_v[26 * 8 + j] = t220 - t245 - t244 - t216; /* R_v(4,2) */
            const real t255 = 0.05238095238095238 * t222;
            const real t256 = sin_q[j] * t155;
            R_v[29 * 8 + j] = t255 + t256 + t220 - t221; /* R_v(4,5) */
            const real t257 = cos_q[j] * t56[j] + sin_q[j] * t54[j];
            const real t258 = 0.3 * (t257 * t181);
            R_v[30 * 8 + j] = t208 + t258 - t209 - t227; /* R_v(5,0) */
            const real t259 = 0.3 * (t257 * t192);
            R_v[31 * 8 + j] = t223 + t228 - t224 - t259; /* R_v(5,1) */
            const real t260 = 0.25 * t11[j] * t257;
            R_v[32 * 8 + j] = t251 + t249 + t250 + t260 - t246 - t247 - t241; /* R_v(5,2) */
            R_v[33 * 8 + j] = t253 + t227 - t254 - t258; /* R_v(5,3) */
            R_v[34 * 8 + j] = t255 + t259 - t256 - t228; /* R_v(5,4) */
            const real t261 = 0.01904761904761905 * (t101[j] * (sin_q[j] * t28 - cos_q[j] * t25));
            const real t263 = t262[j] + 0.01904761904761905 * (t175 - sin_q[j] * t108[j]);
            const real t266 = 0.01904761904761905 * (cos_q[j] * t108[j] - rq_vangle * t165);
            const real t268 = cos_q[j] * (t263 - t264[j] - t265[j]) + sin_q[j] * (t167[j] + t266 - t267[j]);
            R_v[35 * 8 + j] = t261 + t268 + t260 - t252; /* R_v(5,5) */
        }
    }
}

/* outputs: 347 operations.
 * in:  x (6), sigma (3), tau (0), p (9)
 * out: force_p (2), moment_p (1), force_q (2), moment_q (1), axis (17,2), across (2,2) */
FLEXEL_CLONES
static void planar_beam_logarithmic_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict force_p = out[0] + b * (2 * 8);
        real *restrict moment_p = out[1] + b * (1 * 8);
        real *restrict force_q = out[2] + b * (2 * 8);
        real *restrict moment_q = out[3] + b * (1 * 8);
        real *restrict axis = out[4] + b * (34 * 8);
        real *restrict across = out[5] + b * (4 * 8);
        real t0[8], cos_p[8], mean[8], cos_mean[8], d_x[8], sin_mean[8], d_y[8], t1[8], turn[8], t6[8], t10[8],
            t12[8], t15[8], sin_p[8], t23[8], t24[8], cos_q[8], sin_q[8], t26[8], t28[8], t30[8], t31[8], t32[8],
            t34[8], t36[8], t37[8], t38[8], t40[8], t42[8], t43[8], t44[8], t46[8], t48[8], t49[8], t50[8], t52[8],
            t54[8], t55[8], t56[8], t58[8], t60[8], t61[8], t62[8], t64[8], t66[8], t67[8], t68[8], t70[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real alphaq0 = p[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            mean[j] = 0.5 * (alpha0 + alphaq0 + rp_angle + rq_angle);
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
            t1[j] = rq_angle + alphaq0;
            turn[j] = t1[j] - alpha0 - rp_angle;
            const real t2 = turn[j] * turn[j];
            const real t3 = 3.1001984126984127e-06 * t2;
            const real t4 = 0.0005208333333333333 - t3;
            const real t5 = 0.041666666666666664 - t2 * t4;
            const real l0 = p[0 * 8 + j];
            t6[j] = l0 * t5 * t2;
            const real t8 = 1.0 / l0;
            const real GAy = p[6 * 8 + j];
            const real EIz = p[5 * 8 + j];
            const real t9 = 1.0 / GAy * EIz * t8 * t8;
            t10[j] = 12.0 * (l0 * t9);
            const real phi_y = 12.0 * t9;
            const real sigma_elongation = sigma[0 * 8 + j];
            t12[j] = sigma_elongation * (0.6 + phi_y) * l0;
            const real sigma_bend1 = sigma[1 * 8 + j];
            const real t13 = l0 * sigma_bend1;
            const real sigma_bend2 = sigma[2 * 8 + j];
            const real t14 = l0 * sigma_bend2;
            t15[j] = (1.0 + phi_y) * (t13 - t14);
            t23[j] = 0.5 * (t14 + t13);
            t24[j] = t5 + t2 * (t3 - t4);
            t26[j] = 0.98876953125 * p_x + 0.01123046875 * q_x;
            t28[j] = 0.98876953125 * p_y + 0.01123046875 * q_y;
            t30[j] = 0.95703125 * p_x + 0.04296875 * q_x;
            t31[j] = 0.95703125 * p_y + 0.04296875 * q_y;
            t32[j] = 0.90771484375 * p_x + 0.09228515625 * q_x;
            t34[j] = 0.90771484375 * p_y + 0.09228515625 * q_y;
            t36[j] = 0.84375 * p_x + 0.15625 * q_x;
            t37[j] = 0.84375 * p_y + 0.15625 * q_y;
            t38[j] = 0.76806640625 * p_x + 0.23193359375 * q_x;
            t40[j] = 0.76806640625 * p_y + 0.23193359375 * q_y;
            t42[j] = 0.68359375 * p_x + 0.31640625 * q_x;
            t43[j] = 0.68359375 * p_y + 0.31640625 * q_y;
            t44[j] = 0.59326171875 * p_x + 0.40673828125 * q_x;
            t46[j] = 0.59326171875 * p_y + 0.40673828125 * q_y;
            t48[j] = 0.5 * (p_x + q_x);
            t49[j] = 0.5 * (p_y + q_y);
            t50[j] = 0.40673828125 * p_x + 0.59326171875 * q_x;
            t52[j] = 0.40673828125 * p_y + 0.59326171875 * q_y;
            t54[j] = 0.31640625 * p_x + 0.68359375 * q_x;
            t55[j] = 0.31640625 * p_y + 0.68359375 * q_y;
            t56[j] = 0.23193359375 * p_x + 0.76806640625 * q_x;
            t58[j] = 0.23193359375 * p_y + 0.76806640625 * q_y;
            t60[j] = 0.15625 * p_x + 0.84375 * q_x;
            t61[j] = 0.15625 * p_y + 0.84375 * q_y;
            t62[j] = 0.09228515625 * p_x + 0.90771484375 * q_x;
            t64[j] = 0.09228515625 * p_y + 0.90771484375 * q_y;
            t66[j] = 0.04296875 * p_x + 0.95703125 * q_x;
            t67[j] = 0.04296875 * p_y + 0.95703125 * q_y;
            t68[j] = 0.01123046875 * p_x + 0.98876953125 * q_x;
            t70[j] = 0.01123046875 * p_y + 0.98876953125 * q_y;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            across[1 * 8 + j] = cos_p[j]; /* across(0,1) */
            cos_mean[j] = real_cos(mean[j]);
            sin_mean[j] = real_sin(mean[j]);
            sin_p[j] = real_sin(t0[j]);
            cos_q[j] = real_cos(t1[j]);
            across[3 * 8 + j] = cos_q[j]; /* across(1,1) */
            sin_q[j] = real_sin(t1[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real straight_x = cos_mean[j] * d_x[j] + sin_mean[j] * d_y[j] + t6[j];
            const real straight_y = cos_mean[j] * d_y[j] - sin_mean[j] * d_x[j];
            const real t7 = real_sqrt(straight_y * straight_y + straight_x * straight_x);
            const real t11 = 1.0 / (t7 + t10[j]);
            const real bow = straight_y * t11;
            const real t16 = 2.0 * bow * t12[j] + t15[j];
            const real t17 = 1.0 / t7 * (straight_y * t16 * t11 * t11);
            const real t18 = 0.5 * straight_x * t17;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t19 = sigma_elongation - t18 - t18;
            const real t20 = t11 * t16 - straight_y * t17;
            const real q_fx = cos_mean[j] * t19 - sin_mean[j] * t20;
            const real q_fy = cos_mean[j] * t20 + sin_mean[j] * t19;
            force_p[0 * 8 + j] = cos_p[j] * q_fx + sin_p[j] * q_fy;
            force_p[1 * 8 + j] = cos_p[j] * q_fy - sin_p[j] * q_fx;
            const real t21 = cos_mean[j] * (d_y[j] * t19 - d_x[j] * t20) - sin_mean[j] * (d_y[j] * t20 + d_x[j]
                * t19);
            const real t22 = 0.5 * t21;
            const real l0 = p[0 * 8 + j];
            const real t25 = t23[j] + 2.0 * l0 * t19 * t24[j] * turn[j];
            const real rp_fangle = t22 - t25;
            moment_p[0 * 8 + j] = -rp_fangle;
            force_q[0 * 8 + j] = cos_q[j] * q_fx + sin_q[j] * q_fy;
            force_q[1 * 8 + j] = cos_q[j] * q_fy - sin_q[j] * q_fx;
            const real rq_fangle = t25 + t22;
            moment_q[0 * 8 + j] = rq_fangle;
            const real t27 = l0 * (0.054931640625 * cos_p[j] - 0.003662109375 * cos_q[j]);
            axis[2 * 8 + j] = t26[j] + t27; /* axis(1,0) */
            const real t29 = l0 * (0.054931640625 * sin_p[j] - 0.003662109375 * sin_q[j]);
            axis[3 * 8 + j] = t28[j] + t29; /* axis(1,1) */
            axis[4 * 8 + j] = t30[j] + l0 * (0.095703125 * cos_p[j] - 0.013671875 * cos_q[j]); /* axis(2,0) */
            axis[5 * 8 + j] = t31[j] + l0 * (0.095703125 * sin_p[j] - 0.013671875 * sin_q[j]); /* axis(2,1) */
            const real t33 = l0 * (0.123779296875 * cos_p[j] - 0.028564453125 * cos_q[j]);
            axis[6 * 8 + j] = t32[j] + t33; /* axis(3,0) */
            const real t35 = l0 * (0.123779296875 * sin_p[j] - 0.028564453125 * sin_q[j]);
            axis[7 * 8 + j] = t34[j] + t35; /* axis(3,1) */
            axis[8 * 8 + j] = t36[j] + l0 * (0.140625 * cos_p[j] - 0.046875 * cos_q[j]); /* axis(4,0) */
            axis[9 * 8 + j] = t37[j] + l0 * (0.140625 * sin_p[j] - 0.046875 * sin_q[j]); /* axis(4,1) */
            const real t39 = l0 * (0.147705078125 * cos_p[j] - 0.067138671875 * cos_q[j]);
            axis[10 * 8 + j] = t38[j] + t39; /* axis(5,0) */
            const real t41 = l0 * (0.147705078125 * sin_p[j] - 0.067138671875 * sin_q[j]);
            axis[11 * 8 + j] = t40[j] + t41; /* axis(5,1) */
            axis[12 * 8 + j] = t42[j] + l0 * (0.146484375 * cos_p[j] - 0.087890625 * cos_q[j]); /* axis(6,0) */
            axis[13 * 8 + j] = t43[j] + l0 * (0.146484375 * sin_p[j] - 0.087890625 * sin_q[j]); /* axis(6,1) */
            const real t45 = l0 * (0.138427734375 * cos_p[j] - 0.107666015625 * cos_q[j]);
            axis[14 * 8 + j] = t44[j] + t45; /* axis(7,0) */
            const real t47 = l0 * (0.138427734375 * sin_p[j] - 0.107666015625 * sin_q[j]);
            axis[15 * 8 + j] = t46[j] + t47; /* axis(7,1) */
            axis[16 * 8 + j] = t48[j] + 0.125 * l0 * (cos_p[j] - cos_q[j]); /* axis(8,0) */
            axis[17 * 8 + j] = t49[j] + 0.125 * l0 * (sin_p[j] - sin_q[j]); /* axis(8,1) */
            const real t51 = l0 * (0.107666015625 * cos_p[j] - 0.138427734375 * cos_q[j]);
            axis[18 * 8 + j] = t50[j] + t51; /* axis(9,0) */
            const real t53 = l0 * (0.107666015625 * sin_p[j] - 0.138427734375 * sin_q[j]);
            axis[19 * 8 + j] = t52[j] + t53; /* axis(9,1) */
            axis[20 * 8 + j] = t54[j] + l0 * (0.087890625 * cos_p[j] - 0.146484375 * cos_q[j]); /* axis(10,0) */
            axis[21 * 8 + j] = t55[j] + l0 * (0.087890625 * sin_p[j] - 0.146484375 * sin_q[j]); /* axis(10,1) */
            const real t57 = l0 * (0.067138671875 * cos_p[j] - 0.147705078125 * cos_q[j]);
            axis[22 * 8 + j] = t56[j] + t57; /* axis(11,0) */
            const real t59 = l0 * (0.067138671875 * sin_p[j] - 0.147705078125 * sin_q[j]);
            axis[23 * 8 + j] = t58[j] + t59; /* axis(11,1) */
            axis[24 * 8 + j] = t60[j] + l0 * (0.046875 * cos_p[j] - 0.140625 * cos_q[j]); /* axis(12,0) */
            axis[25 * 8 + j] = t61[j] + l0 * (0.046875 * sin_p[j] - 0.140625 * sin_q[j]); /* axis(12,1) */
            const real t63 = l0 * (0.028564453125 * cos_p[j] - 0.123779296875 * cos_q[j]);
            axis[26 * 8 + j] = t62[j] + t63; /* axis(13,0) */
            const real t65 = l0 * (0.028564453125 * sin_p[j] - 0.123779296875 * sin_q[j]);
            axis[27 * 8 + j] = t64[j] + t65; /* axis(13,1) */
            axis[28 * 8 + j] = t66[j] + l0 * (0.013671875 * cos_p[j] - 0.095703125 * cos_q[j]); /* axis(14,0) */
            axis[29 * 8 + j] = t67[j] + l0 * (0.013671875 * sin_p[j] - 0.095703125 * sin_q[j]); /* axis(14,1) */
            const real t69 = l0 * (0.003662109375 * cos_p[j] - 0.054931640625 * cos_q[j]);
            axis[30 * 8 + j] = t68[j] + t69; /* axis(15,0) */
            const real t71 = l0 * (0.003662109375 * sin_p[j] - 0.054931640625 * sin_q[j]);
            axis[31 * 8 + j] = t70[j] + t71; /* axis(15,1) */
            across[0 * 8 + j] = -sin_p[j]; /* across(0,0) */
            across[2 * 8 + j] = -sin_q[j]; /* across(1,0) */
        }
    }
}

const flexel_element flexel_planar_beam_logarithmic = {
    .name = "planar_beam_logarithmic",
    .digest = "049e53572cf8de73",
    .n = 6,
    .m = 3,
    .k = 0,
    .np = 9,
    .position = planar_beam_logarithmic_position,
    .acceleration = planar_beam_logarithmic_acceleration,
    .rates = planar_beam_logarithmic_rates,
    .kinematics = planar_beam_logarithmic_kinematics,
    .stiffness = planar_beam_logarithmic_stiffness,
    .inertia = planar_beam_logarithmic_inertia,
    .tangent = planar_beam_logarithmic_tangent,
    .outputs = planar_beam_logarithmic_outputs,
};
