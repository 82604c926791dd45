/* planar_bearing: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions of the element (angle_p + alpha0); d = xq - xp
 * along = ex.d - d0_x,  across = ey.d - d0_y,  angle = angle_q - angle_p - offset0 (counts turns)
 * axes: the directions in rows;  displacement: the deformations that are lengths
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), PLBEAR
 *
 * x (6): p_x, p_y, rp_angle, q_x, q_y, rq_angle
 * e (3): along [m], across [m], angle [rad]
 * s (0): none
 * p (4):
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   d0 (2) [m]: components of xq - xp on ex, ey when the deformations are zero
 *   offset0 (1) [rad]: difference of the angles when the deformation is zero */
#include "kernels.h"

/* position: 19 operations.
 * in:  x (6), p (4)
 * out: e (3), De (3,6), 12 of 18 entries, V (0,6) */
FLEXEL_CLONES
static void planar_bearing_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict e = out[0] + b * (3 * 8);
        real *restrict De = out[1] + b * (12 * 8);
        real t0[8], cos_p[8], d_x[8], sin_p[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real rq_angle = x[5 * 8 + j];
            const real offset0 = p[3 * 8 + j];
            e[2 * 8 + j] = rq_angle - offset0 - rp_angle;
            De[10 * 8 + j] = -1.0; /* De(2,2) */
            De[11 * 8 + j] = 1.0; /* De(2,5) */
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            De[3 * 8 + j] = De[9 * 8 + j] = cos_p[j]; /* De(0,3) De(1,4) */
            sin_p[j] = real_sin(t0[j]);
            De[4 * 8 + j] = De[5 * 8 + j] = sin_p[j]; /* De(0,4) De(1,0) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t1 = cos_p[j] * d_x[j] + sin_p[j] * d_y[j];
            const real d0_x = p[1 * 8 + j];
            e[0 * 8 + j] = t1 - d0_x;
            const real t2 = cos_p[j] * d_y[j];
            const real d0_y = p[2 * 8 + j];
            const real t3 = sin_p[j] * d_x[j];
            e[1 * 8 + j] = t2 - d0_y - t3;
            De[0 * 8 + j] = De[6 * 8 + j] = -cos_p[j]; /* De(0,0) De(1,1) */
            De[1 * 8 + j] = De[8 * 8 + j] = -sin_p[j]; /* De(0,1) De(1,3) */
            De[2 * 8 + j] = t2 - t3; /* De(0,2) */
            De[7 * 8 + j] = -t1; /* De(1,2) */
        }
    }
}

/* acceleration: 27 operations.
 * in:  x (6), v (6), p (4)
 * out: g (3), 2 of 3 entries, gs (0) */
FLEXEL_CLONES
static void planar_bearing_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict g = out[0] + b * (2 * 8);
        real t0[8], cos_p[8], t2[8], sin_p[8], t4[8], d_y[8], d_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t2[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t4[j] = q_vx - p_vx;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            sin_p[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t1 = rp_vangle * cos_p[j];
            const real t3 = rp_vangle * sin_p[j];
            const real t5 = rp_vangle * t3;
            const real t6 = rp_vangle * t1;
            g[0 * 8 + j] = 2.0 * (t1 * t2[j] - t3 * t4[j]) - d_y[j] * t5 - d_x[j] * t6;
            g[1 * 8 + j] = d_x[j] * t5 - 2.0 * (t3 * t2[j] + t1 * t4[j]) - d_y[j] * t6;
        }
    }
}

/* rates: 26 operations.
 * in:  x (6), v (6), p (4)
 * out: Phi_x (3,6), 10 of 18 entries */
FLEXEL_CLONES
static void planar_bearing_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (10 * 8);
        real t0[8], sin_p[8], cos_p[8], t3[8], d_y[8], d_x[8], t4[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t3[j] = q_vy - p_vy;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t4[j] = q_vx - p_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t0[j]);
            cos_p[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t1 = rp_vangle * sin_p[j];
            Phi_x[0 * 8 + j] = Phi_x[6 * 8 + j] = t1; /* Phi_x(0,0) Phi_x(1,1) */
            const real t2 = rp_vangle * cos_p[j];
            Phi_x[4 * 8 + j] = Phi_x[5 * 8 + j] = t2; /* Phi_x(0,4) Phi_x(1,0) */
            Phi_x[1 * 8 + j] = Phi_x[8 * 8 + j] = -t2; /* Phi_x(0,1) Phi_x(1,3) */
            Phi_x[2 * 8 + j] = cos_p[j] * t3[j] - d_y[j] * t1 - (d_x[j] * t2 + sin_p[j] * t4[j]); /* Phi_x(0,2) */
            Phi_x[3 * 8 + j] = Phi_x[9 * 8 + j] = -t1; /* Phi_x(0,3) Phi_x(1,4) */
            const real t5 = cos_p[j] * t4[j] - d_x[j] * t1 + (d_y[j] * t2 + sin_p[j] * t3[j]);
            Phi_x[7 * 8 + j] = -t5; /* Phi_x(1,2) */
        }
    }
}

/* kinematics: 64 operations.
 * in:  x (6), v (6), a (6), p (4)
 * out: Psi_x (3,6), 10 of 18 entries, Psi_v (3,6), 10 of 18 entries */
FLEXEL_CLONES
static void planar_bearing_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (10 * 8);
        real *restrict Psi_v = out[1] + b * (10 * 8);
        real t0[8], cos_p[8], sin_p[8], t5[8], t6[8], t7[8], d_x[8], d_y[8], t9[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real q_ay = a[4 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            t5[j] = q_ay - p_ay;
            const real q_vy = v[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            t6[j] = q_vy - p_vy;
            const real q_vx = v[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            t7[j] = q_vx - p_vx;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
            const real q_ax = a[3 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            t9[j] = q_ax - p_ax;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            sin_p[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            const real t1 = rp_vangle * cos_p[j];
            const real rp_aangle = a[2 * 8 + j];
            const real t2 = rp_vangle * t1 + sin_p[j] * rp_aangle;
            Psi_x[0 * 8 + j] = Psi_x[6 * 8 + j] = t2; /* Psi_x(0,0) Psi_x(1,1) */
            const real t3 = rp_vangle * sin_p[j];
            const real t4 = cos_p[j] * rp_aangle - rp_vangle * t3;
            Psi_x[4 * 8 + j] = Psi_x[5 * 8 + j] = t4; /* Psi_x(0,4) Psi_x(1,0) */
            Psi_x[1 * 8 + j] = Psi_x[8 * 8 + j] = -t4; /* Psi_x(0,1) Psi_x(1,3) */
            const real t8 = cos_p[j] * t5[j] - 2.0 * (t3 * t6[j] + t1 * t7[j]) - d_x[j] * t4;
            Psi_x[2 * 8 + j] = t8 - d_y[j] * t2 - sin_p[j] * t9[j]; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = Psi_x[9 * 8 + j] = -t2; /* Psi_x(0,3) Psi_x(1,4) */
            const real t10 = d_x[j] * t2 - 2.0 * (t1 * t6[j] - t3 * t7[j]) - d_y[j] * t4;
            Psi_x[7 * 8 + j] = t10 - cos_p[j] * t9[j] - sin_p[j] * t5[j]; /* Psi_x(1,2) */
            const real t11 = 2.0 * t3;
            Psi_v[0 * 8 + j] = Psi_v[6 * 8 + j] = t11; /* Psi_v(0,0) Psi_v(1,1) */
            const real t12 = 2.0 * t1;
            Psi_v[4 * 8 + j] = Psi_v[5 * 8 + j] = t12; /* Psi_v(0,4) Psi_v(1,0) */
            Psi_v[1 * 8 + j] = Psi_v[8 * 8 + j] = -t12; /* Psi_v(0,1) Psi_v(1,3) */
            const real t13 = cos_p[j] * t6[j] - d_y[j] * t3 - d_x[j] * t1 - sin_p[j] * t7[j];
            Psi_v[2 * 8 + j] = 2.0 * t13; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = Psi_v[9 * 8 + j] = -t11; /* Psi_v(0,3) Psi_v(1,4) */
            const real t14 = cos_p[j] * t7[j] + sin_p[j] * t6[j] + d_y[j] * t1 - d_x[j] * t3;
            Psi_v[7 * 8 + j] = -(2.0 * t14); /* Psi_v(1,2) */
        }
    }
}

/* stiffness: 23 operations.
 * in:  x (6), sigma (3), tau (0), p (4)
 * out: K (6,6), 9 of 36 entries */
FLEXEL_CLONES
static void planar_bearing_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict K = out[0] + b * (9 * 8);
        real t0[8], cos_p[8], sin_p[8], t1[8], t2[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real sigma_along = sigma[0 * 8 + j];
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real sigma_across = sigma[1 * 8 + j];
            t1[j] = d_y * sigma_along - d_x * sigma_across;
            t2[j] = d_y * sigma_across + d_x * sigma_along;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            sin_p[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_across = sigma[1 * 8 + j];
            const real sigma_along = sigma[0 * 8 + j];
            const real q_fy = cos_p[j] * sigma_across + sin_p[j] * sigma_along;
            K[0 * 8 + j] = K[2 * 8 + j] = q_fy; /* K(0,2) K(2,0) */
            const real q_fx = cos_p[j] * sigma_along - sin_p[j] * sigma_across;
            K[6 * 8 + j] = K[8 * 8 + j] = q_fx; /* K(2,4) K(4,2) */
            K[1 * 8 + j] = K[3 * 8 + j] = -q_fx; /* K(1,2) K(2,1) */
            K[4 * 8 + j] = -(sin_p[j] * t1[j] + cos_p[j] * t2[j]); /* K(2,2) */
            K[5 * 8 + j] = K[7 * 8 + j] = -q_fy; /* K(2,3) K(3,2) */
        }
    }
}

/* outputs: 14 operations.
 * in:  x (6), sigma (3), tau (0), p (4)
 * out: axes (2,2), displacement (2) */
FLEXEL_CLONES
static void planar_bearing_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict axes = out[0] + b * (4 * 8);
        real *restrict displacement = out[1] + b * (2 * 8);
        real t0[8], cos_p[8], sin_p[8], d_x[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real q_x = x[3 * 8 + j];
            const real p_x = x[0 * 8 + j];
            d_x[j] = q_x - p_x;
            const real q_y = x[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            d_y[j] = q_y - p_y;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_p[j]; /* axes(0,0) axes(1,1) */
            sin_p[j] = real_sin(t0[j]);
            axes[1 * 8 + j] = sin_p[j]; /* axes(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            axes[2 * 8 + j] = -sin_p[j]; /* axes(1,0) */
            const real d0_x = p[1 * 8 + j];
            displacement[0 * 8 + j] = cos_p[j] * d_x[j] + sin_p[j] * d_y[j] - d0_x;
            const real d0_y = p[2 * 8 + j];
            displacement[1 * 8 + j] = cos_p[j] * d_y[j] - d0_y - sin_p[j] * d_x[j];
        }
    }
}

const flexel_element flexel_planar_bearing = {
    .name = "planar_bearing",
    .digest = "698413354c2bda26",
    .n = 6,
    .m = 3,
    .k = 0,
    .np = 4,
    .position = planar_bearing_position,
    .acceleration = planar_bearing_acceleration,
    .rates = planar_bearing_rates,
    .kinematics = planar_bearing_kinematics,
    .stiffness = planar_bearing_stiffness,
    .outputs = planar_bearing_outputs,
};
