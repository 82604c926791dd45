/* planar_slope_clamp: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: directions at angle + alpha0;  across = ey.d
 *
 * Source: planar counterpart of slope_clamp
 *
 * x (3): r_angle, d_x, d_y
 * e (1): across [1]
 * s (0): none
 * p (1):
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p */
#include "kernels.h"

/* position: 11 operations.
 * in:  x (3), p (1)
 * out: e (1), De (1,3), V (0,3) */
FLEXEL_CLONES
static void planar_slope_clamp_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict p = in[1] + b * (1 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (3 * 8);
        real t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[0 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            De[2 * 8 + j] = cos_r[j]; /* De(0,2) */
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real d_y = x[2 * 8 + j];
            const real d_x = x[1 * 8 + j];
            e[0 * 8 + j] = d_y * cos_r[j] - d_x * sin_r[j];
            De[0 * 8 + j] = -(d_y * sin_r[j] + d_x * cos_r[j]); /* De(0,0) */
            De[1 * 8 + j] = -sin_r[j]; /* De(0,1) */
        }
    }
}

/* acceleration: 15 operations.
 * in:  x (3), v (3), p (1)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void planar_slope_clamp_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict p = in[2] + b * (1 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real t0[8], sin_r[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[0 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[0 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real d_x = x[1 * 8 + j];
            const real t2 = r_vangle * cos_r[j];
            const real d_y = x[2 * 8 + j];
            const real d_vy = v[2 * 8 + j];
            const real t3 = d_vy * t1;
            const real d_vx = v[1 * 8 + j];
            const real t4 = d_vx * t2;
            g[0 * 8 + j] = r_vangle * (d_x * t1 - d_y * t2) - t3 - t3 - t4 - t4;
        }
    }
}

/* rates: 14 operations.
 * in:  x (3), v (3), p (1)
 * out: Phi_x (1,3) */
FLEXEL_CLONES
static void planar_slope_clamp_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict p = in[2] + b * (1 * 8);
        real *restrict Phi_x = out[0] + b * (3 * 8);
        real t0[8], sin_r[8], cos_r[8], t2[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[0 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real d_y = x[2 * 8 + j];
            const real r_vangle = v[0 * 8 + j];
            const real d_vx = v[1 * 8 + j];
            t2[j] = d_vx + d_y * r_vangle;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[0 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real d_x = x[1 * 8 + j];
            const real d_vy = v[2 * 8 + j];
            Phi_x[0 * 8 + j] = d_x * t1 - d_vy * sin_r[j] - cos_r[j] * t2[j]; /* Phi_x(0,0) */
            Phi_x[1 * 8 + j] = -(r_vangle * cos_r[j]); /* Phi_x(0,1) */
            Phi_x[2 * 8 + j] = -t1; /* Phi_x(0,2) */
        }
    }
}

/* kinematics: 40 operations.
 * in:  x (3), v (3), a (3), p (1)
 * out: Psi_x (1,3), Psi_v (1,3) */
FLEXEL_CLONES
static void planar_slope_clamp_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict a = in[2] + b * (3 * 8);
        const real *restrict p = in[3] + b * (1 * 8);
        real *restrict Psi_x = out[0] + b * (3 * 8);
        real *restrict Psi_v = out[1] + b * (3 * 8);
        real t0[8], cos_r[8], t1[8], sin_r[8], t3[8], t6[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[0 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real d_x = x[1 * 8 + j];
            const real r_vangle = v[0 * 8 + j];
            const real d_vy = v[2 * 8 + j];
            const real d_y = x[2 * 8 + j];
            const real r_aangle = a[0 * 8 + j];
            const real d_ax = a[1 * 8 + j];
            t1[j] = r_vangle * (d_x * r_vangle - 2.0 * d_vy) - (d_ax + d_y * r_aangle);
            const real d_ay = a[2 * 8 + j];
            const real t2 = d_y * r_vangle;
            const real d_vx = v[1 * 8 + j];
            t3[j] = d_ay - d_x * r_aangle - r_vangle * (t2 + 2.0 * d_vx);
            t6[j] = d_vx + t2;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            Psi_x[0 * 8 + j] = cos_r[j] * t1[j] - sin_r[j] * t3[j]; /* Psi_x(0,0) */
            const real r_vangle = v[0 * 8 + j];
            const real t4 = r_vangle * sin_r[j];
            const real r_aangle = a[0 * 8 + j];
            Psi_x[1 * 8 + j] = r_vangle * t4 - cos_r[j] * r_aangle; /* Psi_x(0,1) */
            const real t5 = r_vangle * cos_r[j];
            Psi_x[2 * 8 + j] = -(r_vangle * t5 + sin_r[j] * r_aangle); /* Psi_x(0,2) */
            const real d_x = x[1 * 8 + j];
            const real d_vy = v[2 * 8 + j];
            Psi_v[0 * 8 + j] = 2.0 * (d_x * t4 - d_vy * sin_r[j] - cos_r[j] * t6[j]); /* Psi_v(0,0) */
            Psi_v[1 * 8 + j] = -(2.0 * t5); /* Psi_v(0,1) */
            Psi_v[2 * 8 + j] = -(2.0 * t4); /* Psi_v(0,2) */
        }
    }
}

/* stiffness: 12 operations.
 * in:  x (3), sigma (1), tau (0), p (1)
 * out: K (3,3), 5 of 9 entries */
FLEXEL_CLONES
static void planar_slope_clamp_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict p = in[3] + b * (1 * 8);
        real *restrict K = out[0] + b * (5 * 8);
        real t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[0 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real d_y = x[2 * 8 + j];
            const real d_x = x[1 * 8 + j];
            const real sigma_across = sigma[0 * 8 + j];
            K[0 * 8 + j] = -((d_y * cos_r[j] - d_x * sin_r[j]) * sigma_across); /* K(0,0) */
            K[1 * 8 + j] = K[3 * 8 + j] = -(cos_r[j] * sigma_across); /* K(0,1) K(1,0) */
            K[2 * 8 + j] = K[4 * 8 + j] = -(sin_r[j] * sigma_across); /* K(0,2) K(2,0) */
        }
    }
}

const flexel_element flexel_planar_slope_clamp = {
    .name = "planar_slope_clamp",
    .digest = "1f88e7ec809e9cf8",
    .n = 3,
    .m = 1,
    .k = 0,
    .np = 1,
    .position = planar_slope_clamp_position,
    .acceleration = planar_slope_clamp_acceleration,
    .rates = planar_slope_clamp_rates,
    .kinematics = planar_slope_clamp_kinematics,
    .stiffness = planar_slope_clamp_stiffness,
};
