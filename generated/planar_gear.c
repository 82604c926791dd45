/* planar_gear: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * d = xq - xp, psi its angle counted from offset0, period 2 pi
 * mesh = (radius_p angle_p + radius_q angle_q)/(radius_p + radius_q) - psi, an angle, so that any number
 * of turns of the line of centres can be counted; (radius_p + radius_q) mesh is the displacement of the teeth
 * origin_p, axes_p, origin_q, axes_q: frames of both wheels at xp and xq, the axes in rows
 *
 * Source: rolling of the pitch circles, radius_p (angle_p - psi) + radius_q (angle_q - psi) = const; UT SPACAR, GEAR
 *
 * x (6): p_x, p_y, rp_angle, q_x, q_y, rq_angle
 * e (1): mesh [rad]
 * s (0): none
 * p (3):
 *   radius_p (1) [m]: pitch radius of the gear at p, negative for an internal gear
 *   radius_q (1) [m]: pitch radius of the gear at q, negative for an internal gear
 *   offset0 (1) [rad]: difference of the angles when the deformation is zero */
#include "kernels.h"

/* position: 34 operations.
 * in:  x (6), p (3)
 * out: e (1), De (1,6), V (0,6) */
FLEXEL_CLONES
static void planar_gear_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (3 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (6 * 8);
        real t1[8], d_y[8], cos_0[8], d_x[8], sin_0[8], t2[8], t3[8], psi[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real radius_p = p[0 * 8 + j];
            const real radius_q = p[1 * 8 + j];
            const real t0 = 1.0 / (radius_p + radius_q);
            const real rp_angle = x[2 * 8 + j];
            const real rq_angle = x[5 * 8 + j];
            t1[j] = t0 * (rp_angle * radius_p + rq_angle * radius_q);
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            De[2 * 8 + j] = radius_p * t0; /* De(0,2) */
            De[5 * 8 + j] = radius_q * t0; /* De(0,5) */
        }
        for (size_t j = 0; j < 8; j++) {
            const real offset0 = p[2 * 8 + j];
            cos_0[j] = real_cos(offset0);
            sin_0[j] = real_sin(offset0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            t2[j] = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            t3[j] = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t4 = 1.0 / (t2[j] * t2[j] + t3[j] * t3[j]);
            const real t5 = t3[j] * t4;
            const real t6 = t2[j] * t4;
            const real t7 = sin_0[j] * t5 + cos_0[j] * t6;
            De[3 * 8 + j] = t7; /* De(0,3) */
            De[0 * 8 + j] = -t7; /* De(0,0) */
            const real t8 = sin_0[j] * t6 - cos_0[j] * t5;
            De[4 * 8 + j] = t8; /* De(0,4) */
            De[1 * 8 + j] = -t8; /* De(0,1) */
        }
        for (size_t j = 0; j < 8; j++) {
            psi[j] = real_atan2(t2[j], t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            e[0 * 8 + j] = t1[j] - psi[j];
        }
    }
}

/* acceleration: 38 operations.
 * in:  x (6), v (6), p (3)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void planar_gear_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (3 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real cos_0[8], t0[8], sin_0[8], t1[8], d_y[8], d_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t0[j] = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t1[j] = q_vy - p_vy;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
        }
        for (size_t j = 0; j < 8; j++) {
            const real offset0 = p[2 * 8 + j];
            cos_0[j] = real_cos(offset0);
            sin_0[j] = real_sin(offset0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t2 = cos_0[j] * t0[j] + sin_0[j] * t1[j];
            const real t3 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t4 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t5 = 1.0 / (t3 * t3 + t4 * t4);
            const real t6 = cos_0[j] * t1[j] - sin_0[j] * t0[j];
            const real t7 = t5 * (t3 * t6 + t4 * t2) * t5;
            g[0 * 8 + j] = t2 * (t5 * t6 - 2.0 * t3 * t7) - t6 * (t5 * t2 - 2.0 * t4 * t7);
        }
    }
}

/* rates: 43 operations.
 * in:  x (6), v (6), p (3)
 * out: Phi_x (1,6), 4 of 6 entries */
FLEXEL_CLONES
static void planar_gear_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (3 * 8);
        real *restrict Phi_x = out[0] + b * (4 * 8);
        real cos_0[8], d_x[8], d_y[8], sin_0[8], t3[8], t4[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t3[j] = q_vx - p_vx;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t4[j] = q_vy - p_vy;
        }
        for (size_t j = 0; j < 8; j++) {
            const real offset0 = p[2 * 8 + j];
            cos_0[j] = real_cos(offset0);
            sin_0[j] = real_sin(offset0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t0 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t1 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t2 = 1.0 / (t1 * t1 + t0 * t0);
            const real t5 = cos_0[j] * t3[j] + sin_0[j] * t4[j];
            const real t6 = cos_0[j] * t4[j] - sin_0[j] * t3[j];
            const real t7 = t2 * t2 * (t1 * t5 - t0 * t6);
            const real t8 = t0 * t7;
            const real t9 = t2 * t6 + t8 + t8;
            const real t10 = t1 * t7;
            const real t11 = t2 * t5 - t10 - t10;
            const real t12 = cos_0[j] * t9 + sin_0[j] * t11;
            Phi_x[0 * 8 + j] = t12; /* Phi_x(0,0) */
            const real t13 = cos_0[j] * t11 - sin_0[j] * t9;
            Phi_x[3 * 8 + j] = t13; /* Phi_x(0,4) */
            Phi_x[1 * 8 + j] = -t13; /* Phi_x(0,1) */
            Phi_x[2 * 8 + j] = -t12; /* Phi_x(0,3) */
        }
    }
}

/* kinematics: 93 operations.
 * in:  x (6), v (6), a (6), p (3)
 * out: Psi_x (1,6), 4 of 6 entries, Psi_v (1,6), 4 of 6 entries */
FLEXEL_CLONES
static void planar_gear_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict Psi_x = out[0] + b * (4 * 8);
        real *restrict Psi_v = out[1] + b * (4 * 8);
        real cos_0[8], t0[8], sin_0[8], t1[8], d_y[8], d_x[8], t12[8], t13[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t0[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t1[j] = q_vx - p_vx;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t12[j] = q_ay - p_ay;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t13[j] = q_ax - p_ax;
        }
        for (size_t j = 0; j < 8; j++) {
            const real offset0 = p[2 * 8 + j];
            cos_0[j] = real_cos(offset0);
            sin_0[j] = real_sin(offset0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t2 = cos_0[j] * t0[j] - sin_0[j] * t1[j];
            const real t3 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t4 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t5 = cos_0[j] * t1[j] + sin_0[j] * t0[j];
            const real t6 = 2.0 * t3 * t2 + 2.0 * t4 * t5;
            const real t7 = 1.0 / (t3 * t3 + t4 * t4);
            const real t8 = t7 * t7;
            const real t9 = t6 * t8;
            const real t10 = t3 * t5 - t4 * t2;
            const real t11 = t8 * t10;
            const real t14 = cos_0[j] * t12[j] - sin_0[j] * t13[j];
            const real t15 = cos_0[j] * t13[j] + sin_0[j] * t12[j];
            const real t16 = t8 * (t3 * t15 - 2.0 * t6 * t10 * t7 - t4 * t14);
            const real t17 = t4 * t16;
            const real t18 = t2 * t9 - 2.0 * t5 * t11 - t7 * t14 - t17 - t17;
            const real t19 = t3 * t16;
            const real t20 = t7 * t15 - (t5 * t9 + 2.0 * t2 * t11) - t19 - t19;
            const real t21 = cos_0[j] * t18 - sin_0[j] * t20;
            Psi_x[2 * 8 + j] = t21; /* Psi_x(0,3) */
            Psi_x[0 * 8 + j] = -t21; /* Psi_x(0,0) */
            const real t22 = sin_0[j] * t18 + cos_0[j] * t20;
            Psi_x[3 * 8 + j] = t22; /* Psi_x(0,4) */
            Psi_x[1 * 8 + j] = -t22; /* Psi_x(0,1) */
            const real t23 = t4 * t11;
            const real t24 = t7 * t2 + t23 + t23;
            const real t25 = t3 * t11;
            const real t26 = t7 * t5 - t25 - t25;
            const real t27 = 2.0 * (cos_0[j] * t24 + sin_0[j] * t26);
            Psi_v[0 * 8 + j] = t27; /* Psi_v(0,0) */
            const real t28 = 2.0 * (cos_0[j] * t26 - sin_0[j] * t24);
            Psi_v[3 * 8 + j] = t28; /* Psi_v(0,4) */
            Psi_v[1 * 8 + j] = -t28; /* Psi_v(0,1) */
            Psi_v[2 * 8 + j] = -t27; /* Psi_v(0,3) */
        }
    }
}

/* stiffness: 53 operations.
 * in:  x (6), sigma (1), tau (0), p (3)
 * out: K (6,6), 16 of 36 entries */
FLEXEL_CLONES
static void planar_gear_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict K = out[0] + b * (16 * 8);
        real sin_0[8], d_y[8], cos_0[8], d_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
        }
        for (size_t j = 0; j < 8; j++) {
            const real offset0 = p[2 * 8 + j];
            sin_0[j] = real_sin(offset0);
            cos_0[j] = real_cos(offset0);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t0 = d_y[j] * cos_0[j] - d_x[j] * sin_0[j];
            const real t1 = d_x[j] * cos_0[j] + d_y[j] * sin_0[j];
            const real t2 = 1.0 / (t0 * t0 + t1 * t1);
            const real t3 = t2 * t2 * t1;
            const real sigma_mesh = sigma[0 * 8 + j];
            const real t4 = sigma_mesh * t3;
            const real t5 = t0 * t4;
            const real t6 = 2.0 * t1 * t4 - sigma_mesh * t2;
            const real t7 = cos_0[j] * t6;
            const real t8 = 2.0 * sin_0[j] * t5 - t7;
            const real t9 = sin_0[j] * t6;
            const real t10 = t0 * t3 * sigma_mesh;
            const real t11 = t9 + 2.0 * cos_0[j] * t10;
            const real t12 = sin_0[j] * t8 - cos_0[j] * t11;
            K[0 * 8 + j] = K[10 * 8 + j] = t12; /* K(0,0) K(3,3) */
            const real t13 = t9 + 2.0 * cos_0[j] * t5;
            const real t14 = 2.0 * sin_0[j] * t10 - t7;
            const real t15 = sin_0[j] * t13 + cos_0[j] * t14;
            K[3 * 8 + j] = K[12 * 8 + j] = t15; /* K(0,4) K(4,0) */
            K[1 * 8 + j] = K[4 * 8 + j] = K[11 * 8 + j] = K[14 * 8 + j] = -t15; /* K(0,1) K(1,0) K(3,4) K(4,3) */
            K[2 * 8 + j] = K[8 * 8 + j] = -t12; /* K(0,3) K(3,0) */
            const real t16 = cos_0[j] * t13 - sin_0[j] * t14;
            K[5 * 8 + j] = K[15 * 8 + j] = t16; /* K(1,1) K(4,4) */
            K[6 * 8 + j] = K[9 * 8 + j] = cos_0[j] * t8 + sin_0[j] * t11; /* K(1,3) K(3,1) */
            K[7 * 8 + j] = K[13 * 8 + j] = -t16; /* K(1,4) K(4,1) */
        }
    }
}

/* outputs: 6 operations.
 * in:  x (6), sigma (1), tau (0), p (3)
 * out: origin_p (2), axes_p (2,2), origin_q (2), axes_q (2,2) */
FLEXEL_CLONES
static void planar_gear_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        real *restrict origin_p = out[0] + b * (2 * 8);
        real *restrict axes_p = out[1] + b * (4 * 8);
        real *restrict origin_q = out[2] + b * (2 * 8);
        real *restrict axes_q = out[3] + b * (4 * 8);
        real t0[8], t1[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            origin_p[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            origin_p[1 * 8 + j] = p_y;
            const real q_x = x[3 * 8 + j];
            origin_q[0 * 8 + j] = q_x;
            const real q_y = x[4 * 8 + j];
            origin_q[1 * 8 + j] = q_y;
        }
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            axes_p[0 * 8 + j] = axes_p[3 * 8 + j] = real_cos(rp_angle); /* axes_p(0,0) axes_p(1,1) */
            t0[j] = real_sin(rp_angle);
            axes_p[1 * 8 + j] = t0[j]; /* axes_p(0,1) */
            const real rq_angle = x[5 * 8 + j];
            axes_q[0 * 8 + j] = axes_q[3 * 8 + j] = real_cos(rq_angle); /* axes_q(0,0) axes_q(1,1) */
            t1[j] = real_sin(rq_angle);
            axes_q[1 * 8 + j] = t1[j]; /* axes_q(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            axes_p[2 * 8 + j] = -t0[j]; /* axes_p(1,0) */
            axes_q[2 * 8 + j] = -t1[j]; /* axes_q(1,0) */
        }
    }
}

const flexel_element flexel_planar_gear = {
    .name = "planar_gear",
    .digest = "9fe4207fe265122d",
    .n = 6,
    .m = 1,
    .k = 0,
    .np = 3,
    .position = planar_gear_position,
    .acceleration = planar_gear_acceleration,
    .rates = planar_gear_rates,
    .kinematics = planar_gear_kinematics,
    .stiffness = planar_gear_stiffness,
    .outputs = planar_gear_outputs,
};
