/* planar_beam_logarithmic: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
 * turn = angle_q + alphaq0 - angle_p - alpha0;  along, across: components of xq - xp on the direction halfway
 * straight = (along + l0 turn^2 (1/24 - turn^2/1920 + turn^4/322560), across): the chord without what uniform bending
 *       takes from it
 * bow = across/(phi_z l0 + |straight|): mean angle of the sections from the direction halfway; the shear angle is
 *       phi_z bow
 * elongation = straight_x + l0 (3/5 + phi_z) bow^2 - l0
 * bend1, bend2 = l0 (turn/2 + (1 + phi_z) bow), l0 (turn/2 - (1 + phi_z) bow)
 * T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
 *    the shear-corrected (phi_z) cubic shapes
 * U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)
 *
 * Source: Reissner 1972, ZAMP 23 (strains of a rod); corotational directions as Crisfield 1990
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

/* position: 103 operations.
 * in:  x (6), p (8)
 * out: e (3), De (3,6), V (0,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (8 * 8);
        real *restrict e = out[0] + b * (3 * 8);
        real *restrict De = out[1] + b * (18 * 8);
        real mean[8], cos_mean[8], d_x[8], sin_mean[8], d_y[8], t5[8], t6[8], t9[8], t11[8], t12[8], t23[8], t24[8],
            t27[8], t30[8];
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
            const real phi_z = p[5 * 8 + j];
            t6[j] = l0 * phi_z;
            t9[j] = l0 * (phi_z + 0.6);
            t11[j] = 0.5 * turn;
            t12[j] = 1.0 + phi_z;
            t23[j] = l0 * turn * (t4 + t1 * (t2 - t3));
            t24[j] = 2.0 * t23[j];
            t27[j] = l0 * t12[j];
            t30[j] = 0.5 * l0;
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
            const real t7 = real_sqrt(straight_y * straight_y + straight_x * straight_x);
            const real t8 = 1.0 / (t6[j] + t7);
            const real bow = straight_y * t8;
            const real t10 = t9[j] * bow;
            const real l0 = p[0 * 8 + j];
            e[0 * 8 + j] = straight_x + bow * t10 - l0;
            const real t13 = t12[j] * bow;
            e[1 * 8 + j] = l0 * (t11[j] + t13);
            e[2 * 8 + j] = l0 * (t11[j] - t13);
            const real t14 = 1.0 / t7 * (t8 * t8 * straight_y);
            const real t15 = straight_x * t14;
            const real t16 = t8 - straight_y * t14;
            const real t17 = cos_mean[j] * t15 + sin_mean[j] * t16;
            const real t18 = cos_mean[j] - 2.0 * t10 * t17;
            De[3 * 8 + j] = t18; /* De(0,3) */
            De[0 * 8 + j] = -t18; /* De(0,0) */
            const real t19 = cos_mean[j] * t16 - sin_mean[j] * t15;
            const real t20 = sin_mean[j] + 2.0 * t10 * t19;
            De[4 * 8 + j] = t20; /* De(0,4) */
            De[1 * 8 + j] = -t20; /* De(0,1) */
            const real t21 = straight_y * t15 + t0 * t16;
            const real t22 = 0.5 * (straight_y - 2.0 * t10 * t21);
            const real t25 = t15 * t23[j];
            const real t26 = t24[j] - 4.0 * t10 * t25;
            De[2 * 8 + j] = t22 - t26; /* De(0,2) */
            De[5 * 8 + j] = t26 + t22; /* De(0,5) */
            const real t28 = t27[j] * t17;
            De[6 * 8 + j] = De[15 * 8 + j] = t28; /* De(1,0) De(2,3) */
            const real t29 = t27[j] * t19;
            De[10 * 8 + j] = De[13 * 8 + j] = t29; /* De(1,4) De(2,1) */
            De[7 * 8 + j] = De[16 * 8 + j] = -t29; /* De(1,1) De(2,4) */
            const real t31 = 2.0 * t27[j] * t25;
            const real t32 = t30[j] - t31;
            const real t33 = 0.5 * t27[j] * t21;
            De[8 * 8 + j] = -(t32 + t33); /* De(1,2) */
            De[9 * 8 + j] = De[12 * 8 + j] = -t28; /* De(1,3) De(2,0) */
            De[11 * 8 + j] = t32 - t33; /* De(1,5) */
            const real t34 = t30[j] + t31;
            De[14 * 8 + j] = t33 - t34; /* De(2,2) */
            De[17 * 8 + j] = t34 + t33; /* De(2,5) */
        }
    }
}

/* acceleration: 156 operations.
 * in:  x (6), v (6), p (8)
 * out: g (3), gs (0) */
FLEXEL_CLONES
static void planar_beam_logarithmic_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict g = out[0] + b * (3 * 8);
        real t0[8], mean[8], cos_mean[8], t1[8], d_x[8], d_y[8], sin_mean[8], t6[8], t18[8], t20[8], t21[8], t22[8],
            t28[8], t40[8];
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
            const real phi_z = p[5 * 8 + j];
            t20[j] = l0 * (phi_z + 0.6);
            t21[j] = l0 * phi_z;
            t22[j] = l0 * t11 * t9;
            t28[j] = l0 * (2.0 * t11 * t14 - t9 * t15);
            t40[j] = l0 * (1.0 + phi_z);
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
            const real straight_x = cos_mean[j] * d_x[j] + sin_mean[j] * d_y[j] + t22[j];
            const real t23 = real_sqrt(straight_y * straight_y + straight_x * straight_x);
            const real t24 = 1.0 / (t21[j] + t23);
            const real t25 = cos_mean[j] * t0[j] - 0.5 * (d_y[j] * t4 + d_x[j] * t2) - sin_mean[j] * t6[j];
            const real t26 = t24 * t24;
            const real t27 = 1.0 / t23;
            const real t29 = cos_mean[j] * t6[j] + sin_mean[j] * t0[j] + 0.5 * (d_y[j] * t2 - d_x[j] * t4);
            const real t30 = t28[j] + t29;
            const real t31 = t27 * (straight_x * t30 + straight_y * t25);
            const real t32 = t26 * t31;
            const real t33 = (t24 * t25 - straight_y * t32) * (t24 * t25 - straight_y * t32);
            const real bow = straight_y * t24;
            const real t34 = t0[j] * t4;
            const real t35 = t6[j] * t2;
            const real t36 = t35 + 0.5 * (d_y[j] * t3 - d_x[j] * t5) + t35 + t34 + t34;
            const real t37 = t30 * t30 + straight_x * t19 + t25 * t25 - 0.5 * straight_y * t36;
            const real t38 = 2.0 * t27 * t26 * (t37 - t31 * t31) - 4.0 * t24 * t32 * t31;
            const real t39 = 4.0 * t25 * t32 + straight_y * t38 + t24 * t36;
            g[0 * 8 + j] = t19 + 2.0 * t20[j] * (t33 - 0.5 * bow * t39);
            const real t41 = 0.5 * t40[j] * t39;
            g[2 * 8 + j] = t41;
            g[1 * 8 + j] = -t41;
        }
    }
}

/* rates: 233 operations.
 * in:  x (6), v (6), p (8)
 * out: Phi_x (3,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (8 * 8);
        real *restrict Phi_x = out[0] + b * (18 * 8);
        real t0[8], d_y[8], mean[8], cos_mean[8], d_x[8], sin_mean[8], t1[8], t7[8], t11[8], t19[8], t21[8], t29[8],
            t53[8], t55[8], t65[8], t66[8], t69[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real phi_z = p[5 * 8 + j];
            const real l0 = p[0 * 8 + j];
            t0[j] = l0 * (phi_z + 0.6);
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
            t1[j] = l0 * phi_z;
            const real turn = rq_angle + alphaq0 - alpha0 - rp_angle;
            const real t3 = turn * turn;
            const real t4 = 3.1001984126984127e-06 * t3;
            const real t5 = 0.0005208333333333333 - t4;
            const real t6 = 0.041666666666666664 - t3 * t5;
            t7[j] = l0 * t3 * t6;
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t11[j] = rp_vangle + rq_vangle;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t19[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t21[j] = q_vx - p_vx;
            const real t25 = rq_vangle - rp_vangle;
            const real t26 = turn * t25;
            const real t27 = t3 * t26;
            const real t28 = 2.0 * t5 * t26 - 6.200396825396825e-06 * t27;
            t29[j] = l0 * (2.0 * t6 * t26 - t3 * t28);
            t53[j] = t19[j] - 0.5 * d_x[j] * t11[j];
            t55[j] = t21[j] + 0.5 * d_y[j] * t11[j];
            const real t62 = t25 * (2.0 * t6 - t3 * (2.0 * t5 - 6.200396825396825e-06 * t3));
            const real t63 = t4 - t5;
            const real t64 = turn * (2.0 * t63 * t26 + 1.240079365079365e-05 * t27 - t28);
            t65[j] = l0 * (t62 + 2.0 * t64);
            t66[j] = l0 * (t6 + t3 * t63) * turn;
            t69[j] = l0 * (1.0 + phi_z);
        }
        for (size_t j = 0; j < 8; j++) {
            cos_mean[j] = real_cos(mean[j]);
            sin_mean[j] = real_sin(mean[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real straight_y = d_y[j] * cos_mean[j] - d_x[j] * sin_mean[j];
            const real t2 = d_x[j] * cos_mean[j] + d_y[j] * sin_mean[j];
            const real straight_x = t2 + t7[j];
            const real t8 = real_sqrt(straight_x * straight_x + straight_y * straight_y);
            const real t9 = 1.0 / (t1[j] + t8);
            const real bow = straight_y * t9;
            const real t10 = t0[j] * bow;
            const real t12 = t11[j] * sin_mean[j];
            const real t13 = 1.0 / t8;
            const real t14 = t9 * t9;
            const real t15 = t13 * t14;
            const real t16 = straight_x * t15;
            const real t17 = t11[j] * cos_mean[j];
            const real t18 = straight_y * t15;
            const real t20 = t19[j] * cos_mean[j] - 0.5 * (d_y[j] * t12 + d_x[j] * t17);
            const real t22 = t20 - t21[j] * sin_mean[j];
            const real t23 = straight_y * t13;
            const real t24 = t23 * t14;
            const real t30 = t29[j] + 0.5 * (d_y[j] * t17 - d_x[j] * t12) + t21[j] * cos_mean[j];
            const real t31 = t19[j] * sin_mean[j] + t30;
            const real t32 = straight_y * t22 + straight_x * t31;
            const real t33 = t13 * t32;
            const real t34 = t14 * t33;
            const real t35 = t9 * t33;
            const real t36 = t14 * t32 * t13 * t13;
            const real t37 = t34 + straight_y * (t22 * t15 - 2.0 * t35 * t24 - t23 * t36);
            const real t38 = t22 * t24 + t37;
            const real t39 = 0.5 * (straight_y * (t12 * t16 + t17 * t18) - t9 * t17) + sin_mean[j] * t38;
            const real t40 = straight_x * t13;
            const real t41 = t14 * t40;
            const real t42 = t22 * t41 + straight_y * (t15 * t31 - 2.0 * t35 * t41 - t40 * t36);
            const real t43 = t39 - cos_mean[j] * t42;
            const real t44 = t0[j] * (t9 * t22 - straight_y * t34);
            const real t45 = straight_y * t44;
            const real t46 = t41 * t45;
            const real t47 = t9 * t44 - t24 * t45;
            const real t48 = 2.0 * (t10 * t43 - cos_mean[j] * t46 - sin_mean[j] * t47);
            const real t49 = t48 - 0.5 * t12;
            Phi_x[3 * 8 + j] = t49; /* Phi_x(0,3) */
            Phi_x[0 * 8 + j] = -t49; /* Phi_x(0,0) */
            const real t50 = cos_mean[j] * t38 + sin_mean[j] * t42 + 0.5 * (t9 * t12 + straight_y * (t17 * t16 - t12
                * t18));
            const real t51 = 2.0 * (cos_mean[j] * t47 - sin_mean[j] * t46 - t10 * t50);
            const real t52 = 0.5 * t17 + t51;
            Phi_x[4 * 8 + j] = t52; /* Phi_x(0,4) */
            Phi_x[1 * 8 + j] = -t52; /* Phi_x(0,1) */
            const real t54 = cos_mean[j] * t53[j];
            const real t56 = sin_mean[j] * t55[j];
            const real t57 = sin_mean[j] * t53[j] + cos_mean[j] * t55[j];
            const real t58 = t2 * t38 - straight_y * (t16 * (t54 - t56) + t42 - t18 * t57);
            const real t59 = t58 - t9 * t57;
            const real t60 = t54 + 2.0 * (t10 * t59 - straight_y * t46 - t2 * t47) - t56;
            const real t61 = 0.5 * t60;
            const real t67 = straight_y * t16 * t65[j] + 2.0 * t66[j] * t42;
            const real t68 = t65[j] - 4.0 * t66[j] * t46 - 2.0 * t10 * t67;
            Phi_x[2 * 8 + j] = t61 - t68; /* Phi_x(0,2) */
            Phi_x[5 * 8 + j] = t68 + t61; /* Phi_x(0,5) */
            const real t70 = t69[j] * t43;
            Phi_x[9 * 8 + j] = Phi_x[12 * 8 + j] = t70; /* Phi_x(1,3) Phi_x(2,0) */
            Phi_x[6 * 8 + j] = Phi_x[15 * 8 + j] = -t70; /* Phi_x(1,0) Phi_x(2,3) */
            const real t71 = t69[j] * t50;
            Phi_x[7 * 8 + j] = Phi_x[16 * 8 + j] = t71; /* Phi_x(1,1) Phi_x(2,4) */
            const real t72 = t69[j] * t67;
            const real t73 = 0.5 * t69[j] * t59;
            const real t74 = t72 + t73;
            Phi_x[8 * 8 + j] = t74; /* Phi_x(1,2) */
            Phi_x[10 * 8 + j] = Phi_x[13 * 8 + j] = -t71; /* Phi_x(1,4) Phi_x(2,1) */
            const real t75 = t73 - t72;
            Phi_x[11 * 8 + j] = t75; /* Phi_x(1,5) */
            Phi_x[14 * 8 + j] = -t74; /* Phi_x(2,2) */
            Phi_x[17 * 8 + j] = -t75; /* Phi_x(2,5) */
        }
    }
}

/* kinematics: 731 operations.
 * in:  x (6), v (6), a (6), p (8)
 * out: Psi_x (3,6), Psi_v (3,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict Psi_x = out[0] + b * (18 * 8);
        real *restrict Psi_v = out[1] + b * (18 * 8);
        real mean[8], cos_mean[8], d_y[8], sin_mean[8], d_x[8], t6[8], t9[8], t13[8], t14[8], t15[8], t19[8], t25[8],
            t45[8], t54[8], t55[8], t56[8], t75[8], t122[8], t124[8], t125[8], t126[8], t128[8], t130[8], t132[8],
            t148[8], t150[8], t152[8], t157[8], t162[8], t166[8], t168[8], t194[8];
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
            const real phi_z = p[5 * 8 + j];
            t9[j] = l0 * phi_z;
            t13[j] = l0 * (phi_z + 0.6);
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t14[j] = q_vy - p_vy;
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t15[j] = rp_vangle + rq_vangle;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t19[j] = q_vx - p_vx;
            const real t21 = rq_vangle - rp_vangle;
            const real t22 = turn * t21;
            const real t23 = t1 * t22;
            const real t24 = 2.0 * t3 * t22 - 6.200396825396825e-06 * t23;
            t25[j] = l0 * (2.0 * t4 * t22 - t1 * t24);
            const real rp_aangle = a[2 * 8 + j];
            const real rq_aangle = a[5 * 8 + j];
            t45[j] = rp_aangle + rq_aangle;
            const real t50 = rq_aangle - rp_aangle;
            const real t51 = turn * t50;
            const real t52 = t1 * t51;
            const real t53 = 2.0 * t3 * t51 - 6.200396825396825e-06 * t52;
            t54[j] = l0 * (2.0 * t4 * t51 - t1 * t53);
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t55[j] = q_ax - p_ax;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t56[j] = q_ay - p_ay;
            const real t71 = t21 * t21;
            const real t72 = t22 * t22;
            const real t73 = t1 * t71;
            const real t74 = 2.0 * (t3 * t71 - 6.200396825396825e-06 * t72) - 6.200396825396825e-06 * (2.0 * t72
                + t73);
            t75[j] = l0 * (2.0 * (t4 * t71 - 2.0 * t22 * t24) - t1 * t74);
            t122[j] = t56[j] - 0.5 * d_x[j] * t45[j];
            const real t123 = d_y[j] * t15[j];
            t124[j] = t15[j] * (t19[j] + 0.25 * t123);
            t125[j] = t122[j] - t124[j];
            t126[j] = t55[j] + 0.5 * d_y[j] * t45[j];
            const real t127 = d_x[j] * t15[j];
            t128[j] = t15[j] * (t14[j] - 0.25 * t127);
            t130[j] = t14[j] - 0.5 * t127;
            t132[j] = t19[j] + 0.5 * t123;
            const real t146 = t2 - t3;
            const real t147 = l0 * (1.240079365079365e-05 * t52 - t53 + 2.0 * t146 * t51);
            t148[j] = turn * t147;
            const real t149 = l0 * t4;
            t150[j] = turn * (t149 + t146 * t5);
            const real t151 = 2.0 * t3 - 6.200396825396825e-06 * t1;
            t152[j] = l0 * t50 * (2.0 * t4 - t1 * t151);
            const real t153 = l0 * t22;
            const real t154 = 2.0 * t146 * t153;
            const real t155 = turn * (1.240079365079365e-05 * (t5 * t22) + t154 - l0 * t24);
            const real t156 = t21 * t151;
            t157[j] = 2.0 * (t149 * t21 + t155) - t5 * t156;
            const real t159 = l0 * (1.240079365079365e-05 * t73 + 2.0 * t146 * t71 - t74);
            const real t160 = 2.0 * turn * (4.96031746031746e-05 * (t22 * t153) + t159);
            const real t161 = l0 * (4.96031746031746e-05 * t23 - 4.0 * t24) * t21 + t160;
            t162[j] = t161 - 4.0 * t156 * t153;
            t166[j] = t152[j] + t162[j];
            t168[j] = l0 * (1.0 + phi_z);
            const real t193 = 2.0 * turn * (l0 * (1.240079365079365e-05 * t23 - t24) + t154);
            t194[j] = l0 * (2.0 * t4 * t21 - t1 * t156) + t193;
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
            const real t10 = 1.0 / (t9[j] + t7);
            const real t11 = t10 * t10;
            const real t12 = t8 * t11;
            const real t16 = sin_mean[j] * t15[j];
            const real t17 = cos_mean[j] * t15[j];
            const real t18 = cos_mean[j] * t14[j] - 0.5 * (d_y[j] * t16 + d_x[j] * t17);
            const real t20 = t18 - sin_mean[j] * t19[j];
            const real t26 = cos_mean[j] * t19[j] + sin_mean[j] * t14[j] + t25[j] + 0.5 * (d_y[j] * t17 - d_x[j]
                * t16);
            const real t27 = straight_y * t20 + t26 * straight_x;
            const real t28 = t8 * t27;
            const real t29 = t11 * t28;
            const real t30 = t20 * t10 - straight_y * t29;
            const real t31 = t13[j] * t30;
            const real t32 = straight_y * t31;
            const real t33 = t12 * t32;
            const real t34 = straight_y * t17 + t16 * straight_x;
            const real bow = straight_y * t10;
            const real t35 = t13[j] * bow;
            const real t36 = t15[j] * t16;
            const real t37 = straight_y * t12;
            const real t38 = t15[j] * t17;
            const real t39 = straight_x * t12;
            const real t40 = t26 * t12;
            const real t41 = straight_y * (0.5 * (t36 * t37 - t38 * t39) - 2.0 * t16 * t40);
            const real t42 = 2.0 * t29;
            const real t43 = t20 * t12;
            const real t44 = t42 + 2.0 * straight_y * t43;
            const real t46 = sin_mean[j] * t45[j];
            const real t47 = straight_x * t37;
            const real t48 = cos_mean[j] * t45[j];
            const real t49 = t10 - straight_y * t37;
            const real t57 = cos_mean[j] * t55[j] + sin_mean[j] * t56[j] + t54[j] + 0.5 * (d_y[j] * t48 - d_x[j]
                * t46);
            const real t58 = cos_mean[j] * t56[j] - 0.5 * (d_y[j] * t46 + d_x[j] * t48);
            const real t59 = t58 - sin_mean[j] * t55[j];
            const real t60 = straight_x * t57 + straight_y * t59;
            const real t61 = straight_y * t60 * t11;
            const real t62 = straight_y * t8;
            const real t63 = t8 * t8;
            const real t64 = t62 * t63;
            const real t65 = t8 * t60;
            const real t66 = t11 * t65;
            const real t67 = t62 * t11;
            const real t68 = t59 - 2.0 * bow * t65;
            const real t69 = t19[j] * t16;
            const real t70 = 2.0 * t14[j] * t17 - 0.5 * (d_x[j] * t38 + d_y[j] * t36) - t69;
            const real t76 = 0.5 * (t70 - t69) + t75[j];
            const real t77 = t14[j] * t16;
            const real t78 = t19[j] * t17;
            const real t79 = t78 + 0.5 * (d_y[j] * t38 - d_x[j] * t36) + t78 + t77 + t77;
            const real t80 = t20 * t20 + t26 * t26 + straight_x * t76 - 0.5 * straight_y * t79;
            const real t81 = t28 * t63;
            const real t82 = t8 * t80 - t27 * t81;
            const real t83 = t10 * t29;
            const real t84 = 2.0 * t11 * t82 - 4.0 * t28 * t83;
            const real t85 = t11 * t27;
            const real t86 = t85 * t63;
            const real t87 = t86 + 2.0 * t83;
            const real t88 = t11 * (2.0 * t80 - 4.0 * t28 * t28) - 2.0 * t27 * t87;
            const real t89 = 4.0 * t10 * t82 - 4.0 * t28 * t29;
            const real t90 = t84 - straight_y * (t67 * t89 + t79 * t12 + t64 * t88) - t79 * t67;
            const real t91 = t10 * t28;
            const real t92 = t20 - straight_y * t91;
            const real t93 = t12 * t92 - 0.5 * straight_y * (t11 * t81 + t8 * t87);
            const real t94 = 4.0 * t91 * t67;
            const real t95 = t94 + 2.0 * t85 * t64;
            const real t96 = t61 * t64 - t66 - t37 * t59 - t67 * t68 - (0.5 * t90 + 2.0 * t20 * t93 - t92 * t95);
            const real t97 = 0.5 * (t41 - t17 * t44 - (t46 * t47 - t48 * t49)) + sin_mean[j] * t96;
            const real t98 = straight_x * t8;
            const real t99 = t98 * t63;
            const real t100 = t11 * t98;
            const real t101 = t61 * t99 - t37 * t57 - t100 * t68;
            const real t102 = t97 - 0.25 * t36 * t10 - t93 * t34 - cos_mean[j] * t101;
            const real t103 = t10 * t31;
            const real t104 = 4.0 * t91 * t100;
            const real t105 = t104 + 2.0 * t85 * t99;
            const real t106 = straight_y * (2.0 * t12 * t76 - t99 * t88 - t100 * t89) - t79 * t100;
            const real t107 = 0.5 * t106 + 2.0 * t26 * t93 - t92 * t105;
            const real t108 = t13[j] * (t10 * t59 - straight_y * t66);
            const real t109 = 4.0 * t20 * t29 + straight_y * t84 + t79 * t10;
            const real t110 = straight_y * t108 + t13[j] * (2.0 * t20 * t30 - 0.5 * straight_y * t109);
            const real t111 = 2.0 * (t32 * t105 - t35 * t107 - t100 * t110) - 4.0 * t26 * t33;
            const real t112 = 2.0 * (t33 * t34 - t35 * t102 - t17 * t103) + cos_mean[j] * t111;
            const real t113 = t10 * t108 + t32 * t95 - t13[j] * (0.5 * t10 * t109 + 2.0 * t29 * t30);
            const real t114 = 2.0 * (t113 - t67 * t110) - 4.0 * t20 * t33;
            const real t115 = t112 - 0.5 * t46 - 0.25 * t38 - sin_mean[j] * t114;
            Psi_x[3 * 8 + j] = t115; /* Psi_x(0,3) */
            Psi_x[0 * 8 + j] = -t115; /* Psi_x(0,0) */
            const real t116 = t17 * straight_x - straight_y * t16;
            const real t117 = straight_y * (2.0 * t17 * t40 - 0.5 * (t38 * t37 + t36 * t39));
            const real t118 = 0.5 * (t117 - t16 * t44 + (t48 * t47 + t46 * t49)) + t93 * t116;
            const real t119 = 0.25 * t38 * t10 + t118 - cos_mean[j] * t96 - sin_mean[j] * t101;
            const real t120 = 0.5 * t48 + sin_mean[j] * t111 + cos_mean[j] * t114 - 2.0 * (t33 * t116 + t35 * t119
                + t16 * t103);
            const real t121 = t120 - 0.25 * t36;
            Psi_x[4 * 8 + j] = t121; /* Psi_x(0,4) */
            Psi_x[1 * 8 + j] = -t121; /* Psi_x(0,1) */
            const real t129 = sin_mean[j] * t124[j];
            const real t131 = cos_mean[j] * t130[j];
            const real t133 = sin_mean[j] * t132[j];
            const real t134 = t131 - t133;
            const real t135 = sin_mean[j] * t130[j] + cos_mean[j] * t132[j];
            const real t136 = t134 * straight_x - straight_y * t135;
            const real t137 = sin_mean[j] * t128[j];
            const real t138 = 4.0 * t130[j] * t40 - 2.0 * (t128[j] * t37 + t124[j] * t39);
            const real t139 = 2.0 * (t129 * t37 - t137 * t39) + cos_mean[j] * t138 - 4.0 * t133 * t40;
            const real t140 = t0 * t96 + straight_y * (0.5 * t139 - t101) + 2.0 * t93 * t136;
            const real t141 = t10 * (cos_mean[j] * t128[j] - t129) + t140 + cos_mean[j] * (t122[j] * t47 + t126[j]
                * t49);
            const real t142 = t141 - t135 * t44 - sin_mean[j] * (t126[j] * t47 - t122[j] * t49);
            const real t143 = cos_mean[j] * t125[j] + straight_y * t111 - 2.0 * (t35 * t142 + 2.0 * t33 * t136);
            const real t144 = t143 - sin_mean[j] * t126[j] - t137 - 4.0 * t135 * t103 - t0 * t114;
            const real t145 = 0.5 * t144;
            const real t158 = t157[j] * straight_x;
            const real t163 = 0.5 * straight_y * (4.0 * t157[j] * t40 + 2.0 * t39 * t162[j]);
            const real t164 = 2.0 * (t158 * t93 - (t150[j] * t101 - t47 * t148[j])) + t163;
            const real t165 = t47 * t152[j] + t164;
            const real t167 = 2.0 * (t148[j] + t150[j] * t111 - t35 * t165) + t166[j] - 4.0 * t158 * t33;
            Psi_x[2 * 8 + j] = t145 - t167; /* Psi_x(0,2) */
            Psi_x[5 * 8 + j] = t167 + t145; /* Psi_x(0,5) */
            const real t169 = t168[j] * t107;
            const real t170 = t168[j] * t102 + cos_mean[j] * t169;
            Psi_x[6 * 8 + j] = Psi_x[15 * 8 + j] = t170; /* Psi_x(1,0) Psi_x(2,3) */
            const real t171 = t168[j] * t119 + sin_mean[j] * t169;
            Psi_x[7 * 8 + j] = Psi_x[16 * 8 + j] = t171; /* Psi_x(1,1) Psi_x(2,4) */
            const real t172 = t168[j] * t165 + 2.0 * t150[j] * t169;
            const real t173 = 0.5 * (t168[j] * t142 + straight_y * t169);
            const real t174 = t172 - t173;
            Psi_x[8 * 8 + j] = t174; /* Psi_x(1,2) */
            Psi_x[9 * 8 + j] = Psi_x[12 * 8 + j] = -t170; /* Psi_x(1,3) Psi_x(2,0) */
            Psi_x[10 * 8 + j] = Psi_x[13 * 8 + j] = -t171; /* Psi_x(1,4) Psi_x(2,1) */
            const real t175 = t172 + t173;
            Psi_x[17 * 8 + j] = t175; /* Psi_x(2,5) */
            Psi_x[11 * 8 + j] = -t175; /* Psi_x(1,5) */
            Psi_x[14 * 8 + j] = -t174; /* Psi_x(2,2) */
            const real t176 = 0.5 * (t42 + straight_y * (2.0 * (t43 - t62 * t86) - t94));
            const real t177 = t20 * t67 + t176;
            const real t178 = 0.5 * (straight_y * (t16 * t39 + t17 * t37) - t17 * t10) + sin_mean[j] * t177;
            const real t179 = t20 * t100 + 0.5 * straight_y * (2.0 * (t40 - t98 * t86) - t104);
            const real t180 = t178 - cos_mean[j] * t179;
            const real t181 = t32 * t100;
            const real t182 = t103 - t32 * t67;
            const real t183 = 2.0 * (t35 * t180 - cos_mean[j] * t181 - sin_mean[j] * t182);
            const real t184 = 2.0 * (t183 - 0.5 * t16);
            Psi_v[3 * 8 + j] = t184; /* Psi_v(0,3) */
            Psi_v[0 * 8 + j] = -t184; /* Psi_v(0,0) */
            const real t185 = sin_mean[j] * t179 + 0.5 * (t16 * t10 + straight_y * (t17 * t39 - t16 * t37));
            const real t186 = cos_mean[j] * t177 + t185;
            const real t187 = 2.0 * (cos_mean[j] * t182 - (sin_mean[j] * t181 + t35 * t186));
            const real t188 = 2.0 * (0.5 * t17 + t187);
            Psi_v[4 * 8 + j] = t188; /* Psi_v(0,4) */
            Psi_v[1 * 8 + j] = -t188; /* Psi_v(0,1) */
            const real t189 = t0 * t177 - straight_y * (t179 + t134 * t39 - t135 * t37);
            const real t190 = t189 - t135 * t10;
            const real t191 = t131 + 2.0 * (t35 * t190 - straight_y * t181 - t0 * t182);
            const real t192 = 0.5 * (t191 - t133);
            const real t195 = straight_y * t194[j] * t39 + 2.0 * t150[j] * t179;
            const real t196 = t194[j] - 4.0 * t150[j] * t181 - 2.0 * t35 * t195;
            Psi_v[2 * 8 + j] = 2.0 * (t192 - t196); /* Psi_v(0,2) */
            Psi_v[5 * 8 + j] = 2.0 * (t196 + t192); /* Psi_v(0,5) */
            const real t197 = 2.0 * t168[j] * t180;
            Psi_v[9 * 8 + j] = Psi_v[12 * 8 + j] = t197; /* Psi_v(1,3) Psi_v(2,0) */
            Psi_v[6 * 8 + j] = Psi_v[15 * 8 + j] = -t197; /* Psi_v(1,0) Psi_v(2,3) */
            const real t198 = 2.0 * t168[j] * t186;
            Psi_v[7 * 8 + j] = Psi_v[16 * 8 + j] = t198; /* Psi_v(1,1) Psi_v(2,4) */
            const real t199 = t168[j] * t195;
            const real t200 = 0.5 * t168[j] * t190;
            const real t201 = 2.0 * (t199 + t200);
            Psi_v[8 * 8 + j] = t201; /* Psi_v(1,2) */
            Psi_v[10 * 8 + j] = Psi_v[13 * 8 + j] = -t198; /* Psi_v(1,4) Psi_v(2,1) */
            const real t202 = 2.0 * (t200 - t199);
            Psi_v[11 * 8 + j] = t202; /* Psi_v(1,5) */
            Psi_v[14 * 8 + j] = -t201; /* Psi_v(2,2) */
            Psi_v[17 * 8 + j] = -t202; /* Psi_v(2,5) */
        }
    }
}

/* stiffness: 219 operations.
 * in:  x (6), sigma (3), tau (0), p (8)
 * out: K (6,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict K = out[0] + b * (36 * 8);
        real mean[8], sin_mean[8], t0[8], d_x[8], cos_mean[8], d_y[8], turn[8], t2[8], t5[8], t7[8], t10[8], t14[8],
            t48[8], t49[8], t59[8], t60[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            mean[j] = 0.5 * (rp_angle + rq_angle + alpha0 + alphaq0);
            const real l0 = p[0 * 8 + j];
            const real phi_z = p[5 * 8 + j];
            t0[j] = l0 * phi_z;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            turn[j] = rq_angle + alphaq0 - alpha0 - rp_angle;
            t2[j] = turn[j] * turn[j];
            const real t3 = 3.1001984126984127e-06 * t2[j];
            const real t4 = 0.0005208333333333333 - t3;
            t5[j] = 0.041666666666666664 - t2[j] * t4;
            const real t6 = l0 * t2[j];
            t7[j] = t5[j] * t6;
            const real sigma_elongation = sigma[0 * 8 + j];
            t10[j] = l0 * (phi_z + 0.6) * sigma_elongation;
            const real sigma_bend1 = sigma[1 * 8 + j];
            const real sigma_bend2 = sigma[2 * 8 + j];
            t14[j] = l0 * (sigma_bend1 - sigma_bend2) * (1.0 + phi_z);
            const real t47 = l0 * t5[j];
            t48[j] = t3 - t4;
            t49[j] = turn[j] * (t47 + t48[j] * t6);
            t59[j] = turn[j] * t48[j];
            t60[j] = t6 * t59[j] + turn[j] * t47;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_mean[j] = real_sin(mean[j]);
            cos_mean[j] = real_cos(mean[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t1 = d_x[j] * cos_mean[j] + d_y[j] * sin_mean[j];
            const real straight_x = t1 + t7[j];
            const real straight_y = d_y[j] * cos_mean[j] - d_x[j] * sin_mean[j];
            const real t8 = real_sqrt(straight_x * straight_x + straight_y * straight_y);
            const real t9 = 1.0 / (t0[j] + t8);
            const real t11 = t9 * t10[j];
            const real t12 = 1.0 / t8;
            const real t13 = t9 * t9;
            const real bow = straight_y * t9;
            const real t15 = 2.0 * bow * t10[j] + t14[j];
            const real t16 = straight_y * t15;
            const real t17 = t13 * t16;
            const real t18 = t12 * t17;
            const real t19 = t13 * t15;
            const real t20 = straight_y * t12;
            const real t21 = t20 * t13;
            const real t22 = t12 * t19 + 2.0 * t21 * t11;
            const real t23 = 2.0 * t9 * t11 - t18 - straight_y * t22;
            const real t24 = sin_mean[j] * t23;
            const real t25 = straight_x * t22;
            const real t26 = straight_y * t13 * t10[j];
            const real t27 = 2.0 * (t12 * t13 * t9 * t16 + t21 * t26) + t12 * t12 * t17;
            const real t28 = straight_x * t27;
            const real t29 = straight_x * t12;
            const real t30 = cos_mean[j] * t29 - sin_mean[j] * t20;
            const real t31 = sin_mean[j] * t25 + t28 * t30 - cos_mean[j] * t18;
            const real t32 = straight_y * t27 - t19 - 2.0 * t9 * t26;
            const real t33 = sin_mean[j] * t32;
            const real t34 = sin_mean[j] * t24 + cos_mean[j] * t31 - t33 * t30;
            K[0 * 8 + j] = K[21 * 8 + j] = t34; /* K(0,0) K(3,3) */
            const real t35 = sin_mean[j] * t29 + cos_mean[j] * t20;
            const real t36 = t28 * t35 - sin_mean[j] * t18 - cos_mean[j] * t25;
            const real t37 = cos_mean[j] * (t36 - t24) - t33 * t35;
            K[1 * 8 + j] = K[6 * 8 + j] = K[22 * 8 + j] = K[27 * 8 + j] = t37; /* K(0,1) K(1,0) K(3,4) K(4,3) */
            const real t38 = t1 * t23;
            const real t39 = 0.5 * straight_x * t18;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t40 = sigma_elongation - t39 - t39;
            const real t41 = t38 - t40;
            const real t42 = straight_y * t18;
            const real t43 = t9 * t15 - t42;
            const real t44 = t1 * t32;
            const real t45 = sin_mean[j] * t41 + straight_y * t31 - cos_mean[j] * t43 - t44 * t30;
            const real t46 = 0.5 * t45;
            const real t50 = 2.0 * t49[j] * t31;
            const real t51 = t46 - t50;
            K[15 * 8 + j] = K[20 * 8 + j] = t51; /* K(2,3) K(3,2) */
            K[2 * 8 + j] = K[12 * 8 + j] = -t51; /* K(0,2) K(2,0) */
            K[3 * 8 + j] = K[18 * 8 + j] = -t34; /* K(0,3) K(3,0) */
            K[4 * 8 + j] = K[9 * 8 + j] = K[19 * 8 + j] = K[24 * 8 + j] = -t37; /* K(0,4) K(1,3) K(3,1) K(4,0) */
            const real t52 = t50 + t46;
            K[23 * 8 + j] = K[33 * 8 + j] = t52; /* K(3,5) K(5,3) */
            K[5 * 8 + j] = K[30 * 8 + j] = -t52; /* K(0,5) K(5,0) */
            const real t53 = cos_mean[j] * (cos_mean[j] * t23 + t32 * t35) + sin_mean[j] * t36;
            K[7 * 8 + j] = K[28 * 8 + j] = t53; /* K(1,1) K(4,4) */
            const real t54 = straight_y * t36 - cos_mean[j] * t41 - sin_mean[j] * t43 - t44 * t35;
            const real t55 = 0.5 * t54;
            const real t56 = 2.0 * t49[j] * t36;
            const real t57 = t55 - t56;
            K[16 * 8 + j] = K[26 * 8 + j] = t57; /* K(2,4) K(4,2) */
            K[8 * 8 + j] = K[13 * 8 + j] = -t57; /* K(1,2) K(2,1) */
            K[10 * 8 + j] = K[25 * 8 + j] = -t53; /* K(1,4) K(4,1) */
            const real t58 = t56 + t55;
            K[29 * 8 + j] = K[34 * 8 + j] = t58; /* K(4,5) K(5,4) */
            K[11 * 8 + j] = K[31 * 8 + j] = -t58; /* K(1,5) K(5,1) */
            const real l0 = p[0 * 8 + j];
            const real t61 = l0 * t40;
            const real t62 = t2[j] * t61;
            const real t63 = turn[j] * (1.240079365079365e-05 * t62 + 2.0 * t48[j] * t61);
            const real t64 = t48[j] * t62 + t5[j] * t61 + turn[j] * (t63 + 2.0 * t59[j] * t61);
            const real t65 = 2.0 * (2.0 * t60[j] * (t29 * t28 - t18) * t49[j] + t64);
            const real t66 = straight_y * t29 - t1 * t20;
            const real t67 = t1 * t25 + t28 * t66 - t42;
            const real t68 = t1 * t38 + straight_y * t67 - sin_mean[j] * (d_y[j] * t40 - d_x[j] * t43);
            const real t69 = t68 - cos_mean[j] * (d_y[j] * t43 + d_x[j] * t40) - t44 * t66;
            const real t70 = 0.5 * t69;
            const real t71 = t49[j] * t67;
            const real t72 = 2.0 * t71;
            K[14 * 8 + j] = t65 + 0.5 * (t70 - t72) - t71; /* K(2,2) */
            const real t73 = 0.5 * (t72 + t70);
            const real t74 = t65 + t71;
            K[17 * 8 + j] = K[32 * 8 + j] = t73 - t74; /* K(2,5) K(5,2) */
            K[35 * 8 + j] = t74 + t73; /* K(5,5) */
        }
    }
}

/* inertia: 291 operations.
 * in:  x (6), v (6), p (8)
 * out: M (6,6), h (6), f (6), U (1) */
FLEXEL_CLONES
static void planar_beam_logarithmic_inertia(size_t nblocks, const real *const *in, real *const *out)
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
            const real t34 = t16[j] * t33;
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
            const real t49 = t16[j] * t36;
            const real t50 = rp_vangle * t49;
            h[0 * 8 + j] = 0.030952380952380953 * t35 + t48 - 0.05238095238095238 * t50;
            const real t52 = t51[j] * t44;
            const real t53 = t45 * t42 + 0.3 * (t10 * t47);
            const real t55 = t54[j] * t43;
            h[1 * 8 + j] = 0.030952380952380953 * t52 + t53 - 0.05238095238095238 * t55;
            const real t57 = 0.01904761904761905 * ((sin_p[j] * t36 - cos_p[j] * t43) * t56[j]);
            const real t61 = t38[j] * t42;
            const real t62 = t60[j] + t61 + 0.009523809523809525 * (cos_p[j] * t58[j]);
            const real t65 = sin_p[j] * (t62 - 0.007142857142857143 * (cos_q[j] * t64[j]));
            const real t66 = cos_q[j] * t43 + cos_p[j] * t44;
            const real t67 = t30 * t36 + sin_p[j] * t33 * t24[j];
            const real t68 = t65 + 0.007142857142857143 * (t63[j] * t66 - rq_vangle * t67);
            const real t70 = 0.25 * t46 * t13[j];
            const real t73 = 0.009523809523809525 * (sin_p[j] * t58[j]) - t71[j] - 0.007142857142857143 * (t72[j]
                * t30);
            const real t74 = t39[j] * t42;
            h[2 * 8 + j] = t57 + t68 - t16[j] * t43 * t59[j] - t49 * t69[j] - t70 - cos_p[j] * (t73 - t74);
            h[3 * 8 + j] = 0.05238095238095238 * t35 - 0.030952380952380953 * t50 - t48;
            h[4 * 8 + j] = 0.05238095238095238 * t52 - 0.030952380952380953 * t55 - t53;
            const real t76 = 0.007142857142857143 * (rp_vangle * (t24[j] * t66 - t67));
            const real t80 = 0.009523809523809525 * (cos_q[j] * t78[j]) + t61 - t79[j];
            const real t81 = sin_q[j] * (t80 - 0.007142857142857143 * (cos_p[j] * t64[j]));
            const real t82 = 0.01904761904761905 * (t63[j] * (sin_q[j] * t33 - cos_q[j] * t44));
            const real t83 = t81 + t82 + t34 * t77[j] + t76 + t16[j] * t44 * t75[j] - t70;
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
static void planar_beam_logarithmic_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict R_x = out[0] + b * (12 * 8);
        real *restrict R_v = out[1] + b * (36 * 8);
        real t0[8], cos_p[8], t1[8], t2[8], t3[8], t4[8], cos_q[8], t6[8], t7[8], sin_p[8], sin_q[8], t11[8], t16[8],
            t18[8], t19[8], t24[8], t27[8], t32[8], t46[8], t49[8], t51[8], t52[8], t53[8], t54[8], t55[8], t60[8],
            t62[8], t69[8], t71[8], t72[8], t94[8], t95[8], t98[8], t109[8], t111[8], t117[8], t131[8], t132[8],
            t135[8], t137[8], t140[8], t142[8], t144[8], t160[8], t165[8], t166[8], t168[8], t171[8], t172[8];
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
            const real rp_aangle = a[2 * 8 + j];
            const real rq_aangle = a[5 * 8 + j];
            t18[j] = (phi_z - 0.2) * t2[j];
            t19[j] = 0.25 * (rp_aangle + rq_aangle) * t18[j];
            t24[j] = t1[j] * t3[j];
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t27[j] = 0.25 * (rp_vangle + rq_vangle) * t18[j];
            const real rhoA = p[3 * 8 + j];
            const real t31 = l0 * rhoA;
            t32[j] = l0 * t31;
            t46[j] = rp_vangle * t32[j];
            t49[j] = rq_vangle * t32[j];
            const real gravity_y = p[7 * 8 + j];
            t51[j] = 0.08333333333333333 * (gravity_y * t32[j]);
            t52[j] = t32[j] * (0.030952380952380953 * q_vx + 0.05238095238095238 * p_vx);
            t53[j] = t51[j] - rp_vangle * t52[j];
            t54[j] = rp_vangle * rq_vangle;
            t55[j] = l0 * l0 * t31;
            t60[j] = rq_vangle * t55[j];
            t62[j] = rq_aangle * t55[j];
            const real t68 = 0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy;
            t69[j] = t46[j] * t68;
            const real gravity_x = p[6 * 8 + j];
            t71[j] = 0.08333333333333333 * (gravity_x * t32[j]);
            t72[j] = rp_vangle * t60[j];
            t94[j] = t32[j] * (0.05238095238095238 * q_vx + 0.030952380952380953 * p_vx);
            t95[j] = rq_vangle * t94[j];
            const real t97 = 0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy;
            t98[j] = t49[j] * t97;
            t109[j] = t1[j] * t18[j];
            t111[j] = 0.05238095238095238 * t46[j];
            t117[j] = 0.030952380952380953 * t49[j];
            t131[j] = t32[j] * t68;
            t132[j] = rp_vangle * t55[j];
            const real t134 = q_vy * t32[j];
            t135[j] = 0.030952380952380953 * t134;
            const real t136 = p_vy * t32[j];
            t137[j] = 0.05238095238095238 * t136;
            const real t139 = p_vx * t32[j];
            t140[j] = 0.05238095238095238 * t139;
            const real t141 = q_vx * t32[j];
            t142[j] = 0.030952380952380953 * t141;
            t144[j] = 0.030952380952380953 * t46[j];
            t160[j] = 0.05238095238095238 * t49[j];
            t165[j] = 0.030952380952380953 * t136;
            t166[j] = 0.05238095238095238 * t134;
            t168[j] = t32[j] * t97;
            t171[j] = 0.030952380952380953 * t139;
            t172[j] = 0.05238095238095238 * t141;
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
            const real t34 = t32[j] * t8;
            const real t35 = rp_aangle * t33 - rp_vangle * t34;
            R_x[0 * 8 + j] = t30 - 0.05238095238095238 * t35; /* R_x(0,2) */
            const real t36 = cos_q[j] * t32[j];
            const real rq_aangle = a[5 * 8 + j];
            const real t37 = t32[j] * t9;
            const real t38 = rq_aangle * t36 - rq_vangle * t37;
            const real t39 = t7[j] * t13 + sin_q[j] * t6[j] + cos_q[j] * t16[j] - t11[j] * t9;
            const real t40 = t1[j] * t39;
            const real t41 = t3[j] * t40;
            const real t42 = sin_q[j] * t7[j] + cos_q[j] * t11[j];
            const real t43 = t24[j] * t42;
            const real t44 = cos_q[j] * t20 - 0.3 * (t15 * t41 + t14 * t43) - t9 * t29;
            R_x[1 * 8 + j] = 0.030952380952380953 * t38 + t44; /* R_x(0,5) */
            const real t45 = sin_p[j] * t20 + 0.3 * (t5 * t23 - t10 * t26) + t12 * t29;
            const real t47 = sin_p[j] * t32[j] * rp_aangle + t46[j] * t12;
            R_x[2 * 8 + j] = t45 - 0.05238095238095238 * t47; /* R_x(1,2) */
            const real t48 = sin_q[j] * t20 + 0.3 * (t5 * t41 - t10 * t43) + t13 * t29;
            const real t50 = sin_q[j] * t32[j] * rq_aangle + t49[j] * t13;
            R_x[3 * 8 + j] = t48 + 0.030952380952380953 * t50; /* R_x(1,5) */
            const real t56 = sin_q[j] * t55[j];
            const real t57 = t11[j] * t29;
            const real t58 = 0.3 * (t7[j] * t26);
            const real t59 = t53[j] - 0.007142857142857143 * (t54[j] * t56) - t57 - t58;
            const real t61 = cos_q[j] * t12 - sin_p[j] * t9;
            const real t63 = sin_p[j] * cos_q[j];
            const real t64 = t55[j] * t13;
            const real t65 = cos_p[j] * t64 - t56 * t8;
            const real t66 = cos_p[j] * t56;
            const real t67 = t60[j] * t61 + t62[j] * t63 - rq_vangle * t65 - rq_aangle * t66;
            const real t70 = t7[j] * t29;
            const real t73 = t69[j] + t70 + t71[j] - 0.007142857142857143 * (cos_q[j] * t72[j]);
            const real t74 = 0.3 * (t11[j] * t26);
            const real t75 = 0.007142857142857143 * t67 + cos_p[j] * (t73 - t74) + sin_p[j] * t59;
            const real q_vy = v[4 * 8 + j];
            const real q_ay = a[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t76 = 0.030952380952380953 * (q_vy * t12 + sin_p[j] * q_ay) + 0.05238095238095238 * (p_vy * t12
                + sin_p[j] * p_ay);
            const real t77 = 0.25 * t18[j] * t22;
            const real q_ax = a[3 * 8 + j];
            const real q_vx = v[3 * 8 + j];
            const real t78 = t75 - t32[j] * t76 - t77 - 0.030952380952380953 * (q_ax * t33 - q_vx * t34);
            const real p_ax = a[0 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            R_x[4 * 8 + j] = t78 - 0.05238095238095238 * (p_ax * t33 - p_vx * t34); /* R_x(2,2) */
            const real t79 = cos_p[j] * t13 - sin_q[j] * t8;
            const real t80 = cos_p[j] * sin_q[j];
            const real t81 = cos_q[j] * t55[j];
            const real t82 = sin_p[j] * t55[j];
            const real t83 = t12 * t81 - t9 * t82;
            const real t84 = sin_p[j] * t81;
            const real t85 = t60[j] * t79 + t62[j] * t80 - rq_vangle * t83 - rq_aangle * t84;
            const real t86 = 0.3 * (t7[j] * t43);
            const real t87 = sin_p[j] * (0.007142857142857143 * (sin_q[j] * t72[j]) - t86);
            const real t88 = 0.25 * t18[j] * t40;
            const real t89 = 0.3 * (t11[j] * t43);
            R_x[5 * 8 + j] = 0.007142857142857143 * t85 + t87 - t88 - cos_p[j] * (t89 - 0.007142857142857143 * (t54[j]
                * t81)); /* R_x(2,5) */
            R_x[6 * 8 + j] = -(0.030952380952380953 * t35 + t30); /* R_x(3,2) */
            R_x[7 * 8 + j] = 0.05238095238095238 * t38 - t44; /* R_x(3,5) */
            R_x[8 * 8 + j] = -(t45 + 0.030952380952380953 * t47); /* R_x(4,2) */
            R_x[9 * 8 + j] = 0.05238095238095238 * t50 - t48; /* R_x(4,5) */
            const real t90 = t55[j] * (rp_vangle * t61 + rp_aangle * t63) - rp_vangle * t65;
            const real t91 = sin_q[j] * (0.007142857142857143 * (sin_p[j] * t72[j]) - t58);
            const real t92 = 0.007142857142857143 * (t90 - rp_aangle * t66) + t91 - t77;
            const real t93 = t74 - 0.007142857142857143 * (cos_p[j] * t54[j] * t55[j]);
            R_x[10 * 8 + j] = t92 - cos_q[j] * t93; /* R_x(5,2) */
            const real t96 = t95[j] - 0.007142857142857143 * (sin_p[j] * t54[j] * t55[j]);
            const real t99 = t70 - t98[j] - 0.007142857142857143 * (cos_p[j] * t72[j]);
            const real t100 = t55[j] * (rp_vangle * t79 + rp_aangle * t80) - rp_vangle * t83;
            const real t101 = 0.05238095238095238 * (q_vy * t13 + sin_q[j] * q_ay) + 0.030952380952380953 * (p_vy
                * t13 + sin_q[j] * p_ay);
            const real t102 = 0.05238095238095238 * (q_ax * t36 - q_vx * t37) + 0.030952380952380953 * (p_ax * t36
                - p_vx * t37);
            const real t103 = t32[j] * t101 + t102 + 0.007142857142857143 * (t100 - rp_aangle * t84);
            const real t104 = cos_q[j] * (t99 - t89 - t71[j]) + t103 + sin_q[j] * (t96 - t57 - t86 - t51[j]);
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
            const real t114 = t32[j] * t12;
            const real t115 = 0.05238095238095238 * t114;
            const real t116 = 0.3 * (t105 * t25);
            R_v[2 * 8 + j] = t110 + t113 - t115 - t116; /* R_v(0,2) */
            R_v[3 * 8 + j] = R_v[18 * 8 + j] = -t106; /* R_v(0,3) R_v(3,0) */
            R_v[4 * 8 + j] = R_v[9 * 8 + j] = R_v[19 * 8 + j] = R_v[24 * 8 + j] = -t108;
                /* R_v(0,4) R_v(1,3) R_v(3,1) R_v(4,0) */
            const real t118 = t117[j] + t29;
            const real t119 = cos_q[j] * t118;
            const real t120 = t32[j] * t13;
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
            const real t133 = 0.01904761904761905 * (cos_p[j] * t132[j] - t55[j] * t12);
            const real t138 = 0.01904761904761905 * (t55[j] * (sin_p[j] * t12 - cos_p[j] * t8));
            const real t143 = 0.01904761904761905 * (rp_vangle * t82 - sin_p[j] * t132[j]);
            R_v[14 * 8 + j] = t138 + cos_p[j] * (t142[j] + t143 + t140[j] - t52[j]) + sin_p[j] * (t131[j] + t133
                - t135[j] - t137[j]); /* R_v(2,2) */
            const real t145 = t144[j] + t29;
            const real t146 = cos_p[j] * t145;
            const real t147 = 0.030952380952380953 * t114;
            R_v[15 * 8 + j] = t146 - t147 - t116 - t110; /* R_v(2,3) */
            const real t148 = sin_p[j] * t145 + t124;
            const real t149 = 0.030952380952380953 * t34;
            R_v[16 * 8 + j] = t148 - t149 - t125; /* R_v(2,4) */
            const real t150 = t56 * t12;
            const real t151 = 0.007142857142857143 * t150;
            const real t152 = t55[j] * (cos_q[j] * t8 + cos_p[j] * t9) - t150 - sin_p[j] * t64;
            const real t153 = 0.007142857142857143 * t152;
            const real t154 = 0.007142857142857143 * (t60[j] * t80);
            const real t155 = 0.25 * t109[j] * t25;
            const real t156 = 0.007142857142857143 * (t132[j] * t63);
            const real t157 = 0.007142857142857143 * (t13 * t82);
            const real t158 = 0.25 * t109[j] * t42;
            R_v[17 * 8 + j] = t154 + t155 + t153 + t151 - t156 - t157 - t158; /* R_v(2,5) */
            R_v[20 * 8 + j] = t116 - t110 - t147 - t146; /* R_v(3,2) */
            const real t159 = 0.05238095238095238 * t120;
            const real t161 = t160[j] - t29;
            const real t162 = cos_q[j] * t161;
            R_v[23 * 8 + j] = t159 + t162 + t122 - t110; /* R_v(3,5) */
            R_v[26 * 8 + j] = -(t149 + t148 + t125); /* R_v(4,2) */
            const real t163 = 0.05238095238095238 * t37;
            const real t164 = sin_q[j] * t161;
            R_v[29 * 8 + j] = t163 + t164 - t125 - t128; /* R_v(4,5) */
            R_v[30 * 8 + j] = t122 + t121 - t119; /* R_v(5,0) */
            R_v[31 * 8 + j] = t129 + t125 - t130 - t128; /* R_v(5,1) */
            R_v[32 * 8 + j] = t156 + t158 + t153 + t157 - t154 - t151 - t155; /* R_v(5,2) */
            R_v[33 * 8 + j] = t159 - t162 - t122 - t110; /* R_v(5,3) */
            R_v[34 * 8 + j] = t163 + t128 - t164 - t125; /* R_v(5,4) */
            const real t167 = 0.01904761904761905 * (cos_q[j] * t60[j] - rq_vangle * t81);
            const real t169 = 0.01904761904761905 * (t55[j] * (sin_q[j] * t13 - cos_q[j] * t9));
            const real t170 = 0.01904761904761905 * (rq_vangle * t56 - sin_q[j] * t60[j]);
            R_v[35 * 8 + j] = t169 + cos_q[j] * (t94[j] + t170 - t171[j] - t172[j]) + sin_q[j] * (t166[j] + t167
                + t165[j] - t168[j]); /* R_v(5,5) */
        }
    }
}

const flexel_element flexel_planar_beam_logarithmic = {
    .name = "planar_beam_logarithmic",
    .digest = "dcba791a77a38467",
    .n = 6,
    .m = 3,
    .k = 0,
    .np = 8,
    .position = planar_beam_logarithmic_position,
    .acceleration = planar_beam_logarithmic_acceleration,
    .rates = planar_beam_logarithmic_rates,
    .kinematics = planar_beam_logarithmic_kinematics,
    .stiffness = planar_beam_logarithmic_stiffness,
    .inertia = planar_beam_logarithmic_inertia,
    .tangent = planar_beam_logarithmic_tangent,
};
