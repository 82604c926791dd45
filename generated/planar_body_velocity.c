/* planar_body_velocity: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * (vx, vy) = R(angle)' xdot_p, velocity of the point in the axes of the angle node
 *
 * Source: textbook mechanics
 *
 * x (3): p_x, p_y, r_angle
 * e (0): none
 * s (2): vx [m/s], vy [m/s]
 * p (0): none */
#include "kernels.h"

/* position: 3 operations.
 * in:  x (3), p (0)
 * out: e (0), De (0,3), V (2,3), 4 of 6 entries */
FLEXEL_CLONES
static void planar_body_velocity_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        real *restrict V = out[2] + b * (4 * 8);
        real t0[8];
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            V[0 * 8 + j] = V[3 * 8 + j] = real_cos(r_angle); /* V(0,0) V(1,1) */
            t0[j] = real_sin(r_angle);
            V[1 * 8 + j] = t0[j]; /* V(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            V[2 * 8 + j] = -t0[j]; /* V(1,0) */
        }
    }
}

/* acceleration: 11 operations.
 * in:  x (3), v (3), p (0)
 * out: g (0), gs (2) */
FLEXEL_CLONES
static void planar_body_velocity_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        real *restrict gs = out[1] + b * (2 * 8);
        real t0[8], t2[8];
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            t0[j] = real_cos(r_angle);
            t2[j] = real_sin(r_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[2 * 8 + j];
            const real t1 = r_vangle * t0[j];
            const real p_vy = v[1 * 8 + j];
            const real t3 = r_vangle * t2[j];
            const real p_vx = v[0 * 8 + j];
            gs[0 * 8 + j] = p_vy * t1 - p_vx * t3;
            gs[1 * 8 + j] = -(p_vx * t1 + p_vy * t3);
        }
    }
}

/* rates: 9 operations.
 * in:  x (3), v (3), p (0)
 * out: Phi_x (2,3), 2 of 6 entries */
FLEXEL_CLONES
static void planar_body_velocity_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        real *restrict Phi_x = out[0] + b * (2 * 8);
        real t0[8], t1[8];
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            t0[j] = real_cos(r_angle);
            t1[j] = real_sin(r_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_vy = v[1 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            Phi_x[0 * 8 + j] = p_vy * t0[j] - p_vx * t1[j]; /* Phi_x(0,2) */
            Phi_x[1 * 8 + j] = -(p_vx * t0[j] + p_vy * t1[j]); /* Phi_x(1,2) */
        }
    }
}

/* kinematics: 28 operations.
 * in:  x (3), v (3), a (3), p (0)
 * out: Psi_x (2,3), 2 of 6 entries, Psi_v (2,3) */
FLEXEL_CLONES
static void planar_body_velocity_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict a = in[2] + b * (3 * 8);
        real *restrict Psi_x = out[0] + b * (2 * 8);
        real *restrict Psi_v = out[1] + b * (6 * 8);
        real t0[8], t1[8];
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            t0[j] = real_cos(r_angle);
            t1[j] = real_sin(r_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_ay = a[1 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real r_vangle = v[2 * 8 + j];
            const real t2 = r_vangle * t0[j];
            Psi_v[1 * 8 + j] = t2; /* Psi_v(0,1) */
            const real p_vx = v[0 * 8 + j];
            const real t3 = r_vangle * t1[j];
            const real p_vy = v[1 * 8 + j];
            Psi_x[0 * 8 + j] = t0[j] * p_ay - t1[j] * p_ax - (p_vx * t2 + p_vy * t3); /* Psi_x(0,2) */
            Psi_x[1 * 8 + j] = -(p_vy * t2 - p_vx * t3 + (t0[j] * p_ax + t1[j] * p_ay)); /* Psi_x(1,2) */
            Psi_v[0 * 8 + j] = Psi_v[4 * 8 + j] = -t3; /* Psi_v(0,0) Psi_v(1,1) */
            Psi_v[2 * 8 + j] = p_vy * t0[j] - p_vx * t1[j]; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = -t2; /* Psi_v(1,0) */
            Psi_v[5 * 8 + j] = -(p_vx * t0[j] + p_vy * t1[j]); /* Psi_v(1,2) */
        }
    }
}

/* stiffness: 9 operations.
 * in:  x (3), sigma (0), tau (2), p (0)
 * out: K (3,3), 2 of 9 entries */
FLEXEL_CLONES
static void planar_body_velocity_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict tau = in[2] + b * (2 * 8);
        real *restrict K = out[0] + b * (2 * 8);
        real t0[8], t1[8];
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            t0[j] = real_cos(r_angle);
            t1[j] = real_sin(r_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real tau_vy = tau[1 * 8 + j];
            const real tau_vx = tau[0 * 8 + j];
            K[0 * 8 + j] = -(t0[j] * tau_vy + t1[j] * tau_vx); /* K(0,2) */
            K[1 * 8 + j] = t0[j] * tau_vx - t1[j] * tau_vy; /* K(1,2) */
        }
    }
}

const flexel_element flexel_planar_body_velocity = {
    .name = "planar_body_velocity",
    .digest = "36cfeccaceffa584",
    .n = 3,
    .m = 0,
    .k = 2,
    .np = 0,
    .position = planar_body_velocity_position,
    .acceleration = planar_body_velocity_acceleration,
    .rates = planar_body_velocity_rates,
    .kinematics = planar_body_velocity_kinematics,
    .stiffness = planar_body_velocity_stiffness,
};
