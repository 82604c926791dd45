/* planar_belt: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * d = xq - xp, psi its angle counted from psi0 (less than half a turn away)
 * free_length = sqrt(d.d - (radius_p - radius_q)^2), of the common tangent on the left of d
 * theta = psi - atan2(radius_p - radius_q, free_length), turn of the points of contact
 * elongation = free_length + radius_p (angle_p - theta) - radius_q (angle_q - theta) - zero,
 * period 2 pi (radius_p - radius_q): a turn of the line of centres, whose angle is a principal value
 * run: from xp + radius_p left to xq + radius_q left, left the normal of the common tangent
 * origin_p, axes_p, origin_q, axes_q: frames of both wheels at xp and xq, the axes in rows
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), PLBELT; terms in theta from the geometry: without them the
 *   tension would not act along the belt
 *
 * x (6): p_x, p_y, rp_angle, q_x, q_y, rq_angle
 * e (1): elongation [m]
 * s (0): none
 * p (4):
 *   radius_p (1) [m]: radius of the pulley at p, positive if the belt leaves it on the left
 *   radius_q (1) [m]: radius of the pulley at q, positive if the belt runs on it on the left
 *   psi0 (1) [rad]: direction of the line of centres from which its turn is counted
 *   zero (1) [m]: length without strain, angles and turn taken as zero */
#include "kernels.h"

/* position: 53 operations.
 * in:  x (6), p (4)
 * out: e (1), De (1,6), V (0,6) */
FLEXEL_CLONES
static void planar_belt_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (6 * 8);
        real d_x[8], d_y[8], step[8], free_length[8], cos_0[8], sin_0[8], t2[8], t3[8], psi[8], t4[8], t8[8], t11[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real radius_p = p[0 * 8 + j];
            De[2 * 8 + j] = radius_p; /* De(0,2) */
            const real radius_q = p[1 * 8 + j];
            step[j] = radius_p - radius_q;
            const real t0 = step[j] * step[j];
            const real t1 = d_x[j] * d_x[j] + d_y[j] * d_y[j] - t0;
            free_length[j] = real_sqrt(t1);
            const real t7 = 1.0 / free_length[j] * (1.0 - 1.0 / (t0 + t1) * t0);
            t8[j] = d_x[j] * t7;
            t11[j] = d_y[j] * t7;
            De[5 * 8 + j] = -radius_q; /* De(0,5) */
        }
        for (size_t j = 0; j < 8; j++) {
            const real psi0 = p[2 * 8 + j];
            cos_0[j] = real_cos(psi0);
            sin_0[j] = real_sin(psi0);
            t4[j] = real_atan2(step[j], free_length[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            t2[j] = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            t3[j] = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t5 = 1.0 / (t2[j] * t2[j] + t3[j] * t3[j]) * step[j];
            const real t6 = t2[j] * t5;
            const real t9 = t3[j] * t5;
            const real t10 = t8[j] + sin_0[j] * t9 + cos_0[j] * t6;
            De[3 * 8 + j] = t10; /* De(0,3) */
            De[0 * 8 + j] = -t10; /* De(0,0) */
            const real t12 = t11[j] + sin_0[j] * t6 - cos_0[j] * t9;
            De[4 * 8 + j] = t12; /* De(0,4) */
            De[1 * 8 + j] = -t12; /* De(0,1) */
        }
        for (size_t j = 0; j < 8; j++) {
            psi[j] = real_atan2(t2[j], t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real theta = psi[j] - t4[j];
            const real rp_angle = x[2 * 8 + j];
            const real radius_p = p[0 * 8 + j];
            const real zero = p[3 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            const real radius_q = p[1 * 8 + j];
            e[0 * 8 + j] = free_length[j] + radius_p * (rp_angle - theta) - zero - radius_q * (rq_angle - theta);
        }
    }
}

/* acceleration: 69 operations.
 * in:  x (6), v (6), p (4)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void planar_belt_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real d_x[8], d_y[8], step[8], t3[8], t4[8], t7[8], cos_0[8], sin_0[8], t15[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real radius_p = p[0 * 8 + j];
            const real radius_q = p[1 * 8 + j];
            step[j] = radius_p - radius_q;
            const real t0 = step[j] * step[j];
            const real t1 = d_x[j] * d_x[j] + d_y[j] * d_y[j] - t0;
            const real free_length = real_sqrt(t1);
            const real t2 = 1.0 / free_length;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t3[j] = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t4[j] = q_vy - p_vy;
            const real t5 = d_x[j] * t3[j] + d_y[j] * t4[j];
            const real t6 = t2 * t5 * t5;
            t7[j] = t2 * (t3[j] * t3[j] + t4[j] * t4[j] - t2 * t6);
            const real t14 = 1.0 / (t0 + t1);
            t15[j] = 0.5 * step[j] * t14 * (2.0 * t7[j] - 4.0 * t14 * t6);
        }
        for (size_t j = 0; j < 8; j++) {
            const real psi0 = p[2 * 8 + j];
            cos_0[j] = real_cos(psi0);
            sin_0[j] = real_sin(psi0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t8 = cos_0[j] * t4[j] - sin_0[j] * t3[j];
            const real t9 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t10 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t11 = 1.0 / (t9 * t9 + t10 * t10);
            const real t12 = cos_0[j] * t3[j] + sin_0[j] * t4[j];
            const real t13 = t11 * t11 * (t9 * t8 + t10 * t12);
            const real t16 = t8 * (t11 * t12 - 2.0 * t10 * t13) + t15[j] - t12 * (t11 * t8 - 2.0 * t9 * t13);
            g[0 * 8 + j] = t7[j] - step[j] * t16;
        }
    }
}

/* rates: 78 operations.
 * in:  x (6), v (6), p (4)
 * out: Phi_x (1,6), 4 of 6 entries */
FLEXEL_CLONES
static void planar_belt_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (4 * 8);
        real t0[8], d_x[8], d_y[8], step[8], t8[8], t10[8], cos_0[8], sin_0[8], t20[8], t21[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t0[j] = q_vx - p_vx;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real radius_p = p[0 * 8 + j];
            const real radius_q = p[1 * 8 + j];
            step[j] = radius_p - radius_q;
            const real t1 = step[j] * step[j];
            const real t2 = d_x[j] * d_x[j] + d_y[j] * d_y[j] - t1;
            const real free_length = real_sqrt(t2);
            const real t3 = 1.0 / free_length;
            const real t4 = 1.0 / (t1 + t2);
            const real t5 = t1 * t4;
            const real t6 = 1.0 - t5;
            const real t7 = t3 * t6;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t8[j] = q_vy - p_vy;
            const real t9 = t3 * (d_x[j] * t0[j] + d_y[j] * t8[j]) * (t4 * t5 - 0.5 * t3 * t3 * t6);
            t10[j] = t0[j] * t7 + 2.0 * d_x[j] * t9;
            t20[j] = t8[j] * t7;
            t21[j] = 2.0 * d_y[j] * t9;
        }
        for (size_t j = 0; j < 8; j++) {
            const real psi0 = p[2 * 8 + j];
            cos_0[j] = real_cos(psi0);
            sin_0[j] = real_sin(psi0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t11 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t12 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t13 = 1.0 / (t11 * t11 + t12 * t12);
            const real t14 = step[j] * (cos_0[j] * t8[j] - sin_0[j] * t0[j]);
            const real t15 = step[j] * (cos_0[j] * t0[j] + sin_0[j] * t8[j]);
            const real t16 = t13 * t13 * (t11 * t15 - t12 * t14);
            const real t17 = t13 * t14 + 2.0 * t12 * t16;
            const real t18 = t13 * t15 - 2.0 * t11 * t16;
            const real t19 = t10[j] - cos_0[j] * t17 - sin_0[j] * t18;
            Phi_x[2 * 8 + j] = t19; /* Phi_x(0,3) */
            Phi_x[0 * 8 + j] = -t19; /* Phi_x(0,0) */
            const real t22 = cos_0[j] * t18 + t21[j] + t20[j] - sin_0[j] * t17;
            Phi_x[3 * 8 + j] = t22; /* Phi_x(0,4) */
            Phi_x[1 * 8 + j] = -t22; /* Phi_x(0,1) */
        }
    }
}

/* kinematics: 186 operations.
 * in:  x (6), v (6), a (6), p (4)
 * out: Psi_x (1,6), 4 of 6 entries, Psi_v (1,6), 4 of 6 entries */
FLEXEL_CLONES
static void planar_belt_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (4 * 8);
        real *restrict Psi_v = out[1] + b * (4 * 8);
        real d_x[8], d_y[8], step[8], t6[8], t7[8], t9[8], t20[8], t25[8], cos_0[8], sin_0[8], t45[8], t48[8], t52[8],
            t53[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real radius_p = p[0 * 8 + j];
            const real radius_q = p[1 * 8 + j];
            step[j] = radius_p - radius_q;
            const real t0 = step[j] * step[j];
            const real t1 = d_x[j] * d_x[j] + d_y[j] * d_y[j] - t0;
            const real free_length = real_sqrt(t1);
            const real t2 = 1.0 / free_length;
            const real t3 = 1.0 / (t0 + t1);
            const real t4 = 1.0 - t0 * t3;
            const real t5 = t2 * t4;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t6[j] = q_ax - p_ax;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t7[j] = q_vx - p_vx;
            const real t8 = t3 * t3;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t9[j] = q_vy - p_vy;
            const real t10 = d_x[j] * t7[j] + d_y[j] * t9[j];
            const real t11 = t2 * t10;
            const real t12 = t0 * t11;
            const real t13 = t8 * t12;
            const real t14 = t2 * t2;
            const real t15 = t4 * t10;
            const real t16 = t14 * t15;
            const real t17 = 2.0 * t0 * t8 * t10 - t16;
            const real t18 = t14 * t11;
            const real t19 = t13 + 0.5 * (t2 * t17 - t4 * t18);
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t20[j] = q_ay - p_ay;
            const real t21 = t7[j] * t7[j] + t9[j] * t9[j] + (d_x[j] * t6[j] + d_y[j] * t20[j]);
            const real t22 = t8 * (4.0 * t3 * t12 * t10 - t0 * (t2 * t21 - t10 * t18));
            const real t23 = 0.5 * t2 * t14 * (t4 * t21 + t10 * t17 - 2.0 * t2 * t15 * t11);
            const real t24 = t22 + t23;
            t25[j] = 2.0 * (0.5 * t5 * t6[j] + t7[j] * t19 - d_x[j] * t24);
            t45[j] = 2.0 * (0.5 * t5 * t20[j] + t9[j] * t19 - d_y[j] * t24);
            const real t47 = t13 - 0.5 * t2 * t16;
            t48[j] = t7[j] * t5 + 2.0 * d_x[j] * t47;
            t52[j] = t9[j] * t5;
            t53[j] = 2.0 * d_y[j] * t47;
        }
        for (size_t j = 0; j < 8; j++) {
            const real psi0 = p[2 * 8 + j];
            cos_0[j] = real_cos(psi0);
            sin_0[j] = real_sin(psi0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t26 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t27 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t28 = 1.0 / (t26 * t26 + t27 * t27);
            const real t29 = t28 * t28;
            const real t30 = cos_0[j] * t9[j] - sin_0[j] * t7[j];
            const real t31 = cos_0[j] * t7[j] + sin_0[j] * t9[j];
            const real t32 = t26 * t30 + t27 * t31;
            const real t33 = t29 * t32;
            const real t34 = step[j] * t30;
            const real t35 = step[j] * t31;
            const real t36 = step[j] * (cos_0[j] * t6[j] + sin_0[j] * t20[j]);
            const real t37 = t26 * t35 - t27 * t34;
            const real t38 = t30 * t35 + t26 * t36 - 4.0 * t28 * t32 * t37 - t31 * t34;
            const real t39 = step[j] * (cos_0[j] * t20[j] - sin_0[j] * t6[j]);
            const real t40 = t29 * (t38 - t27 * t39);
            const real t41 = t29 * t37;
            const real t42 = 2.0 * (t33 * t34 - t27 * t40 - t31 * t41) - t28 * t39;
            const real t43 = t28 * t36 - 2.0 * (t26 * t40 + t33 * t35 + t30 * t41);
            const real t44 = t25[j] + cos_0[j] * t42 - sin_0[j] * t43;
            Psi_x[2 * 8 + j] = t44; /* Psi_x(0,3) */
            Psi_x[0 * 8 + j] = -t44; /* Psi_x(0,0) */
            const real t46 = t45[j] + cos_0[j] * t43 + sin_0[j] * t42;
            Psi_x[3 * 8 + j] = t46; /* Psi_x(0,4) */
            Psi_x[1 * 8 + j] = -t46; /* Psi_x(0,1) */
            const real t49 = t28 * t34 + 2.0 * t27 * t41;
            const real t50 = t28 * t35 - 2.0 * t26 * t41;
            const real t51 = 2.0 * (t48[j] - cos_0[j] * t49 - sin_0[j] * t50);
            Psi_v[2 * 8 + j] = t51; /* Psi_v(0,3) */
            Psi_v[0 * 8 + j] = -t51; /* Psi_v(0,0) */
            const real t54 = 2.0 * (t52[j] + cos_0[j] * t50 + t53[j] - sin_0[j] * t49);
            Psi_v[3 * 8 + j] = t54; /* Psi_v(0,4) */
            Psi_v[1 * 8 + j] = -t54; /* Psi_v(0,1) */
        }
    }
}

/* stiffness: 77 operations.
 * in:  x (6), sigma (1), tau (0), p (4)
 * out: K (6,6), 16 of 36 entries */
FLEXEL_CLONES
static void planar_belt_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict K = out[0] + b * (16 * 8);
        real d_x[8], d_y[8], t6[8], t8[8], sin_0[8], cos_0[8], t19[8], t24[8], t26[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real t0 = d_x[j] * d_x[j];
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real radius_p = p[0 * 8 + j];
            const real radius_q = p[1 * 8 + j];
            const real step = radius_p - radius_q;
            const real t1 = step * step;
            const real t2 = t0 + d_y[j] * d_y[j] - t1;
            const real free_length = real_sqrt(t2);
            const real t3 = 1.0 / free_length;
            const real t4 = 1.0 / (t1 + t2);
            const real t5 = step * t4;
            const real sigma_elongation = sigma[0 * 8 + j];
            t6[j] = step * sigma_elongation;
            const real t7 = sigma_elongation - t5 * t6[j];
            t8[j] = t3 * t7;
            const real t18 = t3 * (0.5 * t3 * t3 * t7 - t4 * t6[j] * t5);
            t19[j] = t0 * t18;
            const real t23 = d_y[j] * t18;
            t24[j] = d_x[j] * t23;
            t26[j] = d_y[j] * t23;
        }
        for (size_t j = 0; j < 8; j++) {
            const real psi0 = p[2 * 8 + j];
            sin_0[j] = real_sin(psi0);
            cos_0[j] = real_cos(psi0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t9 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t10 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t11 = 1.0 / (t9 * t9 + t10 * t10);
            const real t12 = t11 * t11;
            const real t13 = t9 * t12;
            const real t14 = t10 * t12;
            const real t15 = t10 * t6[j];
            const real t16 = t9 * t6[j];
            const real t17 = sin_0[j] * t15 + cos_0[j] * t16;
            const real t20 = t8[j] + 2.0 * ((sin_0[j] * t13 - cos_0[j] * t14) * t17 - t19[j]);
            K[0 * 8 + j] = K[10 * 8 + j] = t20; /* K(0,0) K(3,3) */
            const real t21 = t11 * t6[j] * (cos_0[j] * cos_0[j] + sin_0[j] * sin_0[j]);
            const real t22 = cos_0[j] * t13 + sin_0[j] * t14;
            const real t25 = t21 - 2.0 * (t22 * t17 + t24[j]);
            K[1 * 8 + j] = K[4 * 8 + j] = K[11 * 8 + j] = K[14 * 8 + j] = t25; /* K(0,1) K(1,0) K(3,4) K(4,3) */
            K[2 * 8 + j] = K[8 * 8 + j] = -t20; /* K(0,3) K(3,0) */
            K[3 * 8 + j] = K[6 * 8 + j] = K[9 * 8 + j] = K[12 * 8 + j] = -t25; /* K(0,4) K(1,3) K(3,1) K(4,0) */
            const real t27 = t8[j] - 2.0 * (t22 * (sin_0[j] * t16 - cos_0[j] * t15) + t26[j]);
            K[5 * 8 + j] = K[15 * 8 + j] = t27; /* K(1,1) K(4,4) */
            K[7 * 8 + j] = K[13 * 8 + j] = -t27; /* K(1,4) K(4,1) */
        }
    }
}

/* outputs: 32 operations.
 * in:  x (6), sigma (1), tau (0), p (4)
 * out: run (2,2), origin_p (2), axes_p (2,2), origin_q (2), axes_q (2,2) */
FLEXEL_CLONES
static void planar_belt_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict run = out[0] + b * (4 * 8);
        real *restrict origin_p = out[1] + b * (2 * 8);
        real *restrict axes_p = out[2] + b * (4 * 8);
        real *restrict origin_q = out[3] + b * (2 * 8);
        real *restrict axes_q = out[4] + b * (4 * 8);
        real t4[8], t5[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            origin_p[0 * 8 + j] = p_x;
            const real q_x = x[3 * 8 + j];
            origin_q[0 * 8 + j] = q_x;
            const real d_x = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            origin_q[1 * 8 + j] = q_y;
            const real p_y = x[1 * 8 + j];
            origin_p[1 * 8 + j] = p_y;
            const real d_y = q_y - p_y;
            const real t0 = d_x * d_x + d_y * d_y;
            const real t1 = 1.0 / t0;
            const real radius_p = p[0 * 8 + j];
            const real radius_q = p[1 * 8 + j];
            const real step = radius_p - radius_q;
            const real free_length = real_sqrt(t0 - step * step);
            const real t2 = t1 * (d_x * step - d_y * free_length);
            run[0 * 8 + j] = p_x + radius_p * t2; /* run(0,0) */
            const real t3 = t1 * (d_x * free_length + d_y * step);
            run[1 * 8 + j] = p_y + radius_p * t3; /* run(0,1) */
            run[2 * 8 + j] = q_x + radius_q * t2; /* run(1,0) */
            run[3 * 8 + j] = q_y + radius_q * t3; /* run(1,1) */
        }
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            axes_p[0 * 8 + j] = axes_p[3 * 8 + j] = real_cos(rp_angle); /* axes_p(0,0) axes_p(1,1) */
            t4[j] = real_sin(rp_angle);
            axes_p[1 * 8 + j] = t4[j]; /* axes_p(0,1) */
            const real rq_angle = x[5 * 8 + j];
            axes_q[0 * 8 + j] = axes_q[3 * 8 + j] = real_cos(rq_angle); /* axes_q(0,0) axes_q(1,1) */
            t5[j] = real_sin(rq_angle);
            axes_q[1 * 8 + j] = t5[j]; /* axes_q(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            axes_p[2 * 8 + j] = -t4[j]; /* axes_p(1,0) */
            axes_q[2 * 8 + j] = -t5[j]; /* axes_q(1,0) */
        }
    }
}

const flexel_element flexel_planar_belt = {
    .name = "planar_belt",
    .digest = "a35518cb77059eed",
    .n = 6,
    .m = 1,
    .k = 0,
    .np = 4,
    .position = planar_belt_position,
    .acceleration = planar_belt_acceleration,
    .rates = planar_belt_rates,
    .kinematics = planar_belt_kinematics,
    .stiffness = planar_belt_stiffness,
    .outputs = planar_belt_outputs,
};
