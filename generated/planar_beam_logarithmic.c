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

/* inertia: 313 operations.
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
        real t0[8], t1[8], t2[8], sin_p[8], t3[8], sin_q[8], d_x[8], d_y[8], t5[8], t6[8], t7[8], t8[8], cos_p[8],
            cos_q[8], t14[8], t15[8], t17[8], t19[8], t25[8], t28[8], t30[8], t39[8], t40[8], t43[8], t46[8], t58[8],
            t61[8], t65[8], t67[8], t68[8], t69[8], t72[8], t73[8], t78[8], t80[8], t81[8], t86[8], t88[8], t89[8],
            t90[8], t95[8], t99[8], t100[8], t101[8], t103[8];
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
            const real phi_z = p[5 * 8 + j];
            const real rhoJ = p[4 * 8 + j];
            t7[j] = 1.0 / (1.0 + phi_z) * (1.0 / (1.0 + phi_z)) * l0 * rhoJ;
            t8[j] = t6[j] * t7[j];
            t14[j] = (phi_z - 0.2) * t7[j];
            t15[j] = t5[j] * t14[j];
            t17[j] = l0 * t0[j];
            t19[j] = 0.12857142857142856 * t0[j];
            t25[j] = l0 * l0 * t0[j];
            const real t27 = phi_z * (0.16666666666666666 + 0.3333333333333333 * phi_z);
            t28[j] = 0.5 * (0.13333333333333333 + t27) * t7[j];
            const real t29 = 0.3333333333333333 * (phi_z * (phi_z - 1.0)) - 0.06666666666666667;
            t30[j] = 0.5 * t29 * t7[j];
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t39[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t40[j] = q_vx - p_vx;
            const real rp_vangle = v[2 * 8 + j];
            const real rq_vangle = v[5 * 8 + j];
            t43[j] = 0.25 * (rp_vangle + rq_vangle) * t14[j];
            t46[j] = t5[j] * (d_x[j] * t40[j] + d_y[j] * t39[j]) * t6[j];
            t58[j] = rq_vangle * t17[j];
            t61[j] = rp_vangle * t17[j];
            t65[j] = rp_vangle * t25[j];
            t67[j] = rp_vangle * rp_vangle * t25[j];
            t68[j] = 0.030952380952380953 * q_vy + 0.05238095238095238 * p_vy;
            t69[j] = t61[j] * t68[j];
            t72[j] = rq_vangle * t25[j];
            t73[j] = rp_vangle * t72[j];
            t78[j] = 0.030952380952380953 * q_vx + 0.05238095238095238 * p_vx;
            t80[j] = t61[j] * t78[j];
            t81[j] = rp_vangle * rq_vangle;
            t86[j] = 0.05238095238095238 * q_vy + 0.030952380952380953 * p_vy;
            t88[j] = 0.05238095238095238 * q_vx + 0.030952380952380953 * p_vx;
            t89[j] = rq_vangle * rq_vangle * t25[j];
            t90[j] = t58[j] * t86[j];
            t95[j] = t58[j] * t88[j];
            const real gravity_x = p[6 * 8 + j];
            const real t97 = gravity_x * t0[j];
            f[0 * 8 + j] = f[3 * 8 + j] = 0.5 * t97;
            const real gravity_y = p[7 * 8 + j];
            const real t98 = gravity_y * t0[j];
            f[1 * 8 + j] = f[4 * 8 + j] = 0.5 * t98;
            t99[j] = l0 * t98;
            t100[j] = l0 * t97;
            t101[j] = 0.5 * (p_x + q_x);
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
            const real t9 = t4 * t8[j];
            const real t10 = 0.3 * (t4 * t9);
            M[0 * 8 + j] = M[21 * 8 + j] = t1[j] + t10; /* M(0,0) M(3,3) */
            const real t11 = cos_p[j] + cos_q[j];
            const real t12 = t11 * t8[j];
            const real t13 = 0.3 * (t4 * t12);
            M[4 * 8 + j] = M[24 * 8 + j] = t13; /* M(0,4) M(4,0) */
            M[1 * 8 + j] = M[6 * 8 + j] = M[22 * 8 + j] = M[27 * 8 + j] = -t13; /* M(0,1) M(1,0) M(3,4) M(4,3) */
            const real t16 = 0.25 * t4 * t15[j];
            const real t18 = sin_p[j] * t17[j];
            M[2 * 8 + j] = M[12 * 8 + j] = t16 - 0.05238095238095238 * t18; /* M(0,2) M(2,0) */
            M[3 * 8 + j] = M[18 * 8 + j] = t19[j] - t10; /* M(0,3) M(3,0) */
            const real t20 = sin_q[j] * t17[j];
            M[5 * 8 + j] = M[30 * 8 + j] = 0.030952380952380953 * t20 + t16; /* M(0,5) M(5,0) */
            const real t21 = 0.3 * (t11 * t12);
            M[7 * 8 + j] = M[28 * 8 + j] = t1[j] + t21; /* M(1,1) M(4,4) */
            const real t22 = cos_p[j] * t17[j];
            const real t23 = 0.25 * t11 * t15[j];
            M[8 * 8 + j] = M[13 * 8 + j] = 0.05238095238095238 * t22 - t23; /* M(1,2) M(2,1) */
            M[9 * 8 + j] = M[19 * 8 + j] = 0.3 * (t11 * t9); /* M(1,3) M(3,1) */
            M[10 * 8 + j] = M[25 * 8 + j] = t19[j] - t21; /* M(1,4) M(4,1) */
            const real t24 = cos_q[j] * t17[j];
            M[11 * 8 + j] = M[31 * 8 + j] = -(0.030952380952380953 * t24 + t23); /* M(1,5) M(5,1) */
            const real t26 = 0.004761904761904762 * (t25[j] * (cos_p[j] * cos_p[j] + sin_p[j] * sin_p[j]));
            M[14 * 8 + j] = 2.0 * (t26 + t28[j]); /* M(2,2) */
            M[15 * 8 + j] = M[20 * 8 + j] = -(0.030952380952380953 * t18 + t16); /* M(2,3) M(3,2) */
            M[16 * 8 + j] = M[26 * 8 + j] = 0.030952380952380953 * t22 + t23; /* M(2,4) M(4,2) */
            const real t31 = sin_q[j] * t25[j];
            const real t32 = 0.007142857142857143 * (sin_p[j] * t31 + cos_p[j] * cos_q[j] * t25[j]);
            M[17 * 8 + j] = M[32 * 8 + j] = t30[j] - t32; /* M(2,5) M(5,2) */
            M[23 * 8 + j] = M[33 * 8 + j] = 0.05238095238095238 * t20 - t16; /* M(3,5) M(5,3) */
            M[29 * 8 + j] = M[34 * 8 + j] = t23 - 0.05238095238095238 * t24; /* M(4,5) M(5,4) */
            const real t33 = 0.004761904761904762 * (t25[j] * (cos_q[j] * cos_q[j] + sin_q[j] * sin_q[j]));
            M[35 * 8 + j] = 2.0 * (t33 + t28[j]); /* M(5,5) */
            const real rq_vangle = v[5 * 8 + j];
            const real t34 = rq_vangle * cos_q[j];
            const real t35 = t17[j] * t34;
            const real t36 = rq_vangle * t35;
            const real rp_vangle = v[2 * 8 + j];
            const real t37 = rp_vangle * cos_p[j];
            const real t38 = t37 + t34;
            const real t41 = t11 * t39[j] - t40[j] * t4;
            const real t42 = t5[j] * t41;
            const real t44 = 0.3 * (t42 * t7[j]) + t43[j];
            const real t45 = t5[j] * t44;
            const real t47 = rp_vangle * sin_p[j];
            const real t48 = rq_vangle * sin_q[j];
            const real t49 = t47 + t48;
            const real t50 = t5[j] * (t39[j] * t49 + t40[j] * t38) + t41 * t46[j];
            const real t51 = t44 * t46[j] + 0.3 * (t5[j] * t50 * t7[j]);
            const real t52 = t38 * t45 - t4 * t51;
            const real t53 = t17[j] * t37;
            const real t54 = rp_vangle * t53;
            const real t55 = 0.030952380952380953 * t36 + t52 - 0.05238095238095238 * t54;
            const real t56 = t42 * t6[j] * t44;
            const real t57 = d_x[j] * t56;
            h[0 * 8 + j] = t55 - t57;
            const real t59 = t58[j] * t48;
            const real t60 = t49 * t45 + t11 * t51;
            const real t62 = t61[j] * t47;
            const real t63 = 0.030952380952380953 * t59 + t60 - 0.05238095238095238 * t62;
            const real t64 = d_y[j] * t56;
            h[1 * 8 + j] = t63 - t64;
            const real t66 = 0.01904761904761905 * ((sin_p[j] * t37 - cos_p[j] * t47) * t65[j]);
            const real t70 = t39[j] * t45;
            const real t71 = t69[j] + t70 + 0.009523809523809525 * (cos_p[j] * t67[j]);
            const real t74 = sin_p[j] * (t71 - 0.007142857142857143 * (cos_q[j] * t73[j]));
            const real t75 = cos_q[j] * t47 + cos_p[j] * t48;
            const real t76 = t31 * t37 + sin_p[j] * t34 * t25[j];
            const real t77 = t74 + 0.007142857142857143 * (t72[j] * t75 - rq_vangle * t76);
            const real t79 = 0.25 * t14[j] * t50;
            const real t82 = 0.009523809523809525 * (sin_p[j] * t67[j]) - t80[j] - 0.007142857142857143 * (t81[j]
                * t31);
            const real t83 = t40[j] * t45;
            h[2 * 8 + j] = t66 + t77 - t17[j] * t47 * t68[j] - t53 * t78[j] - t79 - cos_p[j] * (t82 - t83);
            const real t84 = 0.05238095238095238 * t36 + t57 - 0.030952380952380953 * t54;
            h[3 * 8 + j] = t84 - t52;
            const real t85 = 0.05238095238095238 * t59 + t64 - 0.030952380952380953 * t62;
            h[4 * 8 + j] = t85 - t60;
            const real t87 = 0.007142857142857143 * (rp_vangle * (t25[j] * t75 - t76));
            const real t91 = 0.009523809523809525 * (cos_q[j] * t89[j]) + t70 - t90[j];
            const real t92 = sin_q[j] * (t91 - 0.007142857142857143 * (cos_p[j] * t73[j]));
            const real t93 = 0.01904761904761905 * (t72[j] * (sin_q[j] * t34 - cos_q[j] * t48));
            const real t94 = t92 + t93 + t35 * t88[j] + t87 + t17[j] * t48 * t86[j] - t79;
            const real t96 = 0.009523809523809525 * (sin_q[j] * t89[j]) + t95[j] - 0.007142857142857143 * (sin_p[j]
                * t81[j] * t25[j]);
            h[5 * 8 + j] = t94 - cos_q[j] * (t96 - t83);
            f[2 * 8 + j] = 0.08333333333333333 * (cos_p[j] * t99[j] - sin_p[j] * t100[j]);
            f[5 * 8 + j] = 0.08333333333333333 * (sin_q[j] * t100[j] - cos_q[j] * t99[j]);
            const real l0 = p[0 * 8 + j];
            const real t102 = t101[j] + 0.08333333333333333 * (l0 * (cos_p[j] - cos_q[j]));
            const real gravity_x = p[6 * 8 + j];
            const real t104 = t103[j] + 0.08333333333333333 * (l0 * (sin_p[j] - sin_q[j]));
            const real gravity_y = p[7 * 8 + j];
            U[0 * 8 + j] = -((gravity_x * t102 + gravity_y * t104) * t0[j]);
        }
    }
}

/* tangent: 746 operations.
 * in:  x (6), v (6), a (6), p (8)
 * out: R_x (6,6), R_v (6,6) */
FLEXEL_CLONES
static void planar_beam_logarithmic_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
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
            const real phi_z = p[5 * 8 + j];
            const real t9 = 1.0 / (1.0 + phi_z);
            const real l0 = p[0 * 8 + j];
            const real rhoJ = p[4 * 8 + j];
            t10[j] = l0 * rhoJ * t9 * t9;
            t11[j] = (phi_z - 0.2) * t10[j];
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
            const real gravity_x = p[6 * 8 + j];
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
            const real gravity_y = p[7 * 8 + j];
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

const flexel_element flexel_planar_beam_logarithmic = {
    .name = "planar_beam_logarithmic",
    .digest = "ffac77bb15f5efbb",
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
