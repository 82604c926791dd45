/* planar_skate: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * ex, ey: direction of the blade (angle + alpha0) and its normal;  forward = ex.v,  lateral = ey.v
 * ahead: ex
 * origin: x, axes: ex, ey in rows: the frame that carries what a picture shows
 *
 * Source: Chaplygin 1911, sleigh; Neimark and Fufaev 1972, Dynamics of Nonholonomic Systems
 *
 * x (3): p_x, p_y, r_angle
 * e (0): none
 * s (2): forward [m/s], lateral [m/s]
 * p (1):
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p */
#include "kernels.h"

/* position: 4 operations.
 * in:  x (3), p (1)
 * out: e (0), De (0,3), V (2,3), 4 of 6 entries */
FLEXEL_CLONES
static void planar_skate_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict p = in[1] + b * (1 * 8);
        real *restrict V = out[2] + b * (4 * 8);
        real t0[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real cos_r = real_cos(t0[j]);
            V[0 * 8 + j] = V[3 * 8 + j] = cos_r; /* V(0,0) V(1,1) */
            sin_r[j] = real_sin(t0[j]);
            V[1 * 8 + j] = sin_r[j]; /* V(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            V[2 * 8 + j] = -sin_r[j]; /* V(1,0) */
        }
    }
}

/* acceleration: 12 operations.
 * in:  x (3), v (3), p (1)
 * out: g (0), gs (2) */
FLEXEL_CLONES
static void planar_skate_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict p = in[2] + b * (1 * 8);
        real *restrict gs = out[1] + b * (2 * 8);
        real t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[2 * 8 + j];
            const real t1 = r_vangle * cos_r[j];
            const real p_vy = v[1 * 8 + j];
            const real t2 = r_vangle * sin_r[j];
            const real p_vx = v[0 * 8 + j];
            gs[0 * 8 + j] = p_vy * t1 - p_vx * t2;
            gs[1 * 8 + j] = -(p_vy * t2 + p_vx * t1);
        }
    }
}

/* rates: 10 operations.
 * in:  x (3), v (3), p (1)
 * out: Phi_x (2,3), 2 of 6 entries */
FLEXEL_CLONES
static void planar_skate_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict p = in[2] + b * (1 * 8);
        real *restrict Phi_x = out[0] + b * (2 * 8);
        real t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_vy = v[1 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            Phi_x[0 * 8 + j] = p_vy * cos_r[j] - p_vx * sin_r[j]; /* Phi_x(0,2) */
            Phi_x[1 * 8 + j] = -(p_vx * cos_r[j] + p_vy * sin_r[j]); /* Phi_x(1,2) */
        }
    }
}

/* kinematics: 29 operations.
 * in:  x (3), v (3), a (3), p (1)
 * out: Psi_x (2,3), 2 of 6 entries, Psi_v (2,3) */
FLEXEL_CLONES
static void planar_skate_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict a = in[2] + b * (3 * 8);
        const real *restrict p = in[3] + b * (1 * 8);
        real *restrict Psi_x = out[0] + b * (2 * 8);
        real *restrict Psi_v = out[1] + b * (6 * 8);
        real t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_ay = a[1 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real r_vangle = v[2 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real p_vy = v[1 * 8 + j];
            const real t2 = r_vangle * cos_r[j];
            Psi_v[1 * 8 + j] = t2; /* Psi_v(0,1) */
            const real p_vx = v[0 * 8 + j];
            Psi_x[0 * 8 + j] = cos_r[j] * p_ay - sin_r[j] * p_ax - (p_vy * t1 + p_vx * t2); /* Psi_x(0,2) */
            const real t3 = p_vy * t2 - p_vx * t1 + (cos_r[j] * p_ax + sin_r[j] * p_ay);
            Psi_x[1 * 8 + j] = -t3; /* Psi_x(1,2) */
            Psi_v[0 * 8 + j] = Psi_v[4 * 8 + j] = -t1; /* Psi_v(0,0) Psi_v(1,1) */
            Psi_v[2 * 8 + j] = p_vy * cos_r[j] - p_vx * sin_r[j]; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = -t2; /* Psi_v(1,0) */
            Psi_v[5 * 8 + j] = -(p_vx * cos_r[j] + p_vy * sin_r[j]); /* Psi_v(1,2) */
        }
    }
}

/* stiffness: 10 operations.
 * in:  x (3), sigma (0), tau (2), p (1)
 * out: K (3,3), 2 of 9 entries */
FLEXEL_CLONES
static void planar_skate_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict tau = in[2] + b * (2 * 8);
        const real *restrict p = in[3] + b * (1 * 8);
        real *restrict K = out[0] + b * (2 * 8);
        real t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real tau_lateral = tau[1 * 8 + j];
            const real tau_forward = tau[0 * 8 + j];
            const real p_fy = cos_r[j] * tau_lateral + sin_r[j] * tau_forward;
            K[0 * 8 + j] = -p_fy; /* K(0,2) */
            const real p_fx = cos_r[j] * tau_forward - sin_r[j] * tau_lateral;
            K[1 * 8 + j] = p_fx; /* K(1,2) */
        }
    }
}

/* outputs: 4 operations.
 * in:  x (3), sigma (0), tau (2), p (1)
 * out: ahead (2), origin (2), axes (2,2) */
FLEXEL_CLONES
static void planar_skate_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict p = in[3] + b * (1 * 8);
        real *restrict ahead = out[0] + b * (2 * 8);
        real *restrict origin = out[1] + b * (2 * 8);
        real *restrict axes = out[2] + b * (4 * 8);
        real t0[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_x = x[0 * 8 + j];
            origin[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            origin[1 * 8 + j] = p_y;
        }
        for (size_t j = 0; j < 8; j++) {
            const real cos_r = real_cos(t0[j]);
            ahead[0 * 8 + j] = axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r; /* axes(0,0) axes(1,1) */
            sin_r[j] = real_sin(t0[j]);
            ahead[1 * 8 + j] = axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
        }
    }
}

const flexel_element flexel_planar_skate = {
    .name = "planar_skate",
    .digest = "3a6b635849de7b0a",
    .n = 3,
    .m = 0,
    .k = 2,
    .np = 1,
    .position = planar_skate_position,
    .acceleration = planar_skate_acceleration,
    .rates = planar_skate_rates,
    .kinematics = planar_skate_kinematics,
    .stiffness = planar_skate_stiffness,
    .outputs = planar_skate_outputs,
};
