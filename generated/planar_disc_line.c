/* planar_disc_line: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x = xp + R(angle_b) centre
 * ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * turn = angular velocity of the disc relative to the surface
 * gap = ey.(x - xc) - offset_y - sphere_radius,  tangential = ex.w + sphere_radius turn
 * place: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows
 * axes_ball: axes of the body of what touches, in rows
 *
 * Source: planar counterpart of contact in space
 *
 * x (6): p_x, p_y, b_angle, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (6):
 *   centre (2) [m]: centre of the disc from p in the axes of its body
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   sphere_radius (1) [m]: radius of the sphere; 0: a point */
#include "kernels.h"

/* position: 35 operations.
 * in:  x (6), p (6)
 * out: e (1), De (1,6), V (1,6) */
FLEXEL_CLONES
static void planar_disc_line_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (6 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (6 * 8);
        real *restrict V = out[2] + b * (6 * 8);
        real sin_b[8], cos_b[8], t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            sin_b[j] = real_sin(b_angle);
            cos_b[j] = real_cos(b_angle);
            cos_r[j] = real_cos(t0[j]);
            De[1 * 8 + j] = V[0 * 8 + j] = cos_r[j]; /* De(0,1) V(0,0) */
            sin_r[j] = real_sin(t0[j]);
            De[3 * 8 + j] = V[1 * 8 + j] = sin_r[j]; /* De(0,3) V(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real t1 = d_y * cos_r[j];
            const real offset_y = p[4 * 8 + j];
            const real sphere_radius = p[5 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real t2 = d_x * sin_r[j];
            e[0 * 8 + j] = t1 - offset_y - sphere_radius - t2;
            De[0 * 8 + j] = V[4 * 8 + j] = -sin_r[j]; /* De(0,0) V(0,4) */
            De[2 * 8 + j] = centre_arm_x * cos_r[j] + centre_arm_y * sin_r[j]; /* De(0,2) */
            De[4 * 8 + j] = V[3 * 8 + j] = -cos_r[j]; /* De(0,4) V(0,3) */
            De[5 * 8 + j] = -(d_y * sin_r[j] + d_x * cos_r[j]); /* De(0,5) */
            V[2 * 8 + j] = sphere_radius + centre_arm_x * sin_r[j] - centre_arm_y * cos_r[j]; /* V(0,2) */
            V[5 * 8 + j] = t1 - (sphere_radius + t2); /* V(0,5) */
        }
    }
}

/* acceleration: 73 operations.
 * in:  x (6), v (6), p (6)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_disc_line_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real t0[8], sin_r[8], cos_b[8], sin_b[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real b_vangle = v[2 * 8 + j];
            const real t1 = b_vangle * cos_b[j];
            const real t2 = b_vangle * t1;
            const real centre_x = p[0 * 8 + j];
            const real t3 = b_vangle * sin_b[j];
            const real t4 = b_vangle * t3;
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real r_vangle = v[5 * 8 + j];
            const real t5 = r_vangle * sin_r[j];
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real t6 = r_vangle * cos_r[j];
            const real t7 = sin_r[j] * (centre_x * t2 - centre_y * t4) + r_vangle * (d_x * t5 - d_y * t6);
            const real t8 = centre_x * t1 - centre_y * t3;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[4 * 8 + j];
            const real t9 = p_vy + t8 - c_vy;
            const real t10 = centre_x * t3 + centre_y * t1;
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[3 * 8 + j];
            const real t11 = p_vx - t10 - c_vx;
            g[0 * 8 + j] = t7 - 2.0 * (t9 * t5 + t11 * t6) - cos_r[j] * (centre_x * t4 + centre_y * t2);
            const real sliding_y = p_vy + b_vangle * centre_arm_x - c_vy - r_vangle * d_x;
            const real t12 = cos_r[j] * (r_vangle * t9 - b_vangle * t8) + sliding_y * t6;
            const real sliding_x = p_vx + r_vangle * d_y - c_vx - b_vangle * centre_arm_y;
            gs[0 * 8 + j] = t12 - sliding_x * t5 - sin_r[j] * (b_vangle * t10 + r_vangle * t11);
        }
    }
}

/* rates: 65 operations.
 * in:  x (6), v (6), p (6)
 * out: Phi_x (2,6) */
FLEXEL_CLONES
static void planar_disc_line_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict Phi_x = out[0] + b * (12 * 8);
        real t0[8], cos_r[8], sin_r[8], cos_b[8], sin_b[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[5 * 8 + j];
            const real t1 = r_vangle * cos_r[j];
            Phi_x[3 * 8 + j] = Phi_x[7 * 8 + j] = t1; /* Phi_x(0,3) Phi_x(1,1) */
            Phi_x[0 * 8 + j] = Phi_x[10 * 8 + j] = -t1; /* Phi_x(0,0) Phi_x(1,4) */
            const real t2 = r_vangle * sin_r[j];
            Phi_x[4 * 8 + j] = Phi_x[9 * 8 + j] = t2; /* Phi_x(0,4) Phi_x(1,3) */
            Phi_x[1 * 8 + j] = Phi_x[6 * 8 + j] = -t2; /* Phi_x(0,1) Phi_x(1,0) */
            const real b_vangle = v[2 * 8 + j];
            const real t3 = b_vangle * cos_b[j];
            const real centre_x = p[0 * 8 + j];
            const real t4 = b_vangle * sin_b[j];
            const real centre_y = p[1 * 8 + j];
            const real t5 = centre_x * t3 - centre_y * t4;
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real t6 = centre_x * t4 + centre_y * t3;
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            Phi_x[2 * 8 + j] = sin_r[j] * t5 + centre_arm_y * t1 - cos_r[j] * t6 - centre_arm_x * t2; /* Phi_x(0,2) */
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[3 * 8 + j];
            Phi_x[5 * 8 + j] = d_x * t2 - d_y * t1 - sin_r[j] * (p_vy + t5 - c_vy) - cos_r[j] * (p_vx - t6 - c_vx);
                /* Phi_x(0,5) */
            const real t7 = b_vangle * centre_arm_x;
            const real t8 = b_vangle * centre_arm_y;
            Phi_x[8 * 8 + j] = cos_r[j] * (r_vangle * centre_arm_x - t7) + sin_r[j] * (r_vangle * centre_arm_y - t8);
                /* Phi_x(1,2) */
            const real sliding_y = p_vy + t7 - c_vy - r_vangle * d_x;
            const real sliding_x = p_vx + r_vangle * d_y - c_vx - t8;
            Phi_x[11 * 8 + j] = sliding_y * cos_r[j] - sliding_x * sin_r[j]; /* Phi_x(1,5) */
        }
    }
}

/* kinematics: 183 operations.
 * in:  x (6), v (6), a (6), p (6)
 * out: Psi_x (2,6), Psi_v (2,6) */
FLEXEL_CLONES
static void planar_disc_line_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict Psi_x = out[0] + b * (12 * 8);
        real *restrict Psi_v = out[1] + b * (12 * 8);
        real t0[8], sin_r[8], cos_r[8], cos_b[8], sin_b[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[5 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real r_aangle = a[5 * 8 + j];
            const real t2 = r_vangle * t1 - cos_r[j] * r_aangle;
            Psi_x[0 * 8 + j] = Psi_x[10 * 8 + j] = t2; /* Psi_x(0,0) Psi_x(1,4) */
            const real t3 = r_vangle * cos_r[j];
            const real t4 = r_vangle * t3 + sin_r[j] * r_aangle;
            Psi_x[4 * 8 + j] = Psi_x[9 * 8 + j] = t4; /* Psi_x(0,4) Psi_x(1,3) */
            Psi_x[1 * 8 + j] = Psi_x[6 * 8 + j] = -t4; /* Psi_x(0,1) Psi_x(1,0) */
            const real b_aangle = a[2 * 8 + j];
            const real t5 = cos_b[j] * b_aangle;
            const real centre_x = p[0 * 8 + j];
            const real t6 = sin_b[j] * b_aangle;
            const real centre_y = p[1 * 8 + j];
            const real t7 = centre_x * t5 - centre_y * t6;
            const real b_vangle = v[2 * 8 + j];
            const real t8 = b_vangle * sin_b[j];
            const real t9 = b_vangle * cos_b[j];
            const real t10 = centre_x * t8 + centre_y * t9;
            const real t11 = centre_x * t9 - centre_y * t8;
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real t12 = sin_r[j] * t7 + 2.0 * (t10 * t1 + t11 * t3) - centre_arm_x * t4;
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real t13 = centre_x * t6 + centre_y * t5;
            const real t14 = b_vangle * t9;
            const real t15 = b_vangle * t8;
            const real t16 = cos_r[j] * (centre_x * t14 - centre_y * t15);
            const real t17 = sin_r[j] * (centre_x * t15 + centre_y * t14);
            Psi_x[2 * 8 + j] = t12 - centre_arm_y * t2 - cos_r[j] * t13 - t16 - t17; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = Psi_x[7 * 8 + j] = -t2; /* Psi_x(0,3) Psi_x(1,1) */
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[3 * 8 + j];
            const real t18 = p_vx - t10 - c_vx;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[4 * 8 + j];
            const real t19 = p_vy + t11 - c_vy;
            const real t20 = t16 + 2.0 * (t18 * t1 - t19 * t3) + t17 + d_x * t4 + d_y * t2;
            const real p_ay = a[1 * 8 + j];
            const real c_ay = a[4 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real c_ax = a[3 * 8 + j];
            Psi_x[5 * 8 + j] = t20 - sin_r[j] * (p_ay + t7 - c_ay) - cos_r[j] * (p_ax - t13 - c_ax); /* Psi_x(0,5) */
            const real t21 = centre_arm_y * b_aangle;
            const real t22 = b_vangle * t11;
            const real t23 = sin_r[j] * (r_vangle * t11 + centre_arm_y * r_aangle - t21 - t22);
            const real t24 = r_vangle * centre_arm_y;
            const real t25 = b_vangle * centre_arm_y;
            const real t26 = b_vangle * t10;
            const real t27 = centre_arm_x * b_aangle;
            const real t28 = cos_r[j] * (t26 + centre_arm_x * r_aangle - r_vangle * t10 - t27);
            const real t29 = b_vangle * centre_arm_x;
            const real t30 = r_vangle * centre_arm_x - t29;
            Psi_x[8 * 8 + j] = t3 * (t24 - t25) + t28 + t23 - t1 * t30; /* Psi_x(1,2) */
            const real t31 = p_ay + t27 - c_ay - d_x * r_aangle - t26 - r_vangle * t18;
            const real t32 = p_ax + r_vangle * t19 + d_y * r_aangle - t22 - c_ax - t21;
            const real sliding_x = p_vx + r_vangle * d_y - c_vx - t25;
            const real sliding_y = p_vy + t29 - c_vy - r_vangle * d_x;
            Psi_x[11 * 8 + j] = cos_r[j] * t31 - sin_r[j] * t32 - sliding_x * t3 - sliding_y * t1; /* Psi_x(1,5) */
            const real t33 = 2.0 * t3;
            Psi_v[3 * 8 + j] = Psi_v[7 * 8 + j] = t33; /* Psi_v(0,3) Psi_v(1,1) */
            Psi_v[0 * 8 + j] = Psi_v[10 * 8 + j] = -t33; /* Psi_v(0,0) Psi_v(1,4) */
            const real t34 = 2.0 * t1;
            Psi_v[4 * 8 + j] = Psi_v[9 * 8 + j] = t34; /* Psi_v(0,4) Psi_v(1,3) */
            Psi_v[1 * 8 + j] = Psi_v[6 * 8 + j] = -t34; /* Psi_v(0,1) Psi_v(1,0) */
            const real t35 = sin_r[j] * t11 + centre_arm_y * t3 - cos_r[j] * t10 - centre_arm_x * t1;
            Psi_v[2 * 8 + j] = 2.0 * t35; /* Psi_v(0,2) */
            const real t36 = 2.0 * (d_y * t3 + sin_r[j] * t19 + cos_r[j] * t18 - d_x * t1);
            Psi_v[5 * 8 + j] = -t36; /* Psi_v(0,5) */
            const real t37 = centre_arm_y * t1 + centre_arm_x * t3 + cos_r[j] * (t30 - t11);
            Psi_v[8 * 8 + j] = t37 - sin_r[j] * (t25 + t10 - t24); /* Psi_v(1,2) */
            const real t38 = cos_r[j] * (sliding_y + t19) - sin_r[j] * (sliding_x + t18);
            Psi_v[11 * 8 + j] = t38 - d_y * t1 - d_x * t3; /* Psi_v(1,5) */
        }
    }
}

/* stiffness: 41 operations.
 * in:  x (6), sigma (1), tau (1), p (6)
 * out: K (6,6), 12 of 36 entries */
FLEXEL_CLONES
static void planar_disc_line_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict K = out[0] + b * (12 * 8);
        real t0[8], cos_r[8], sin_r[8], cos_b[8], sin_b[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_gap = sigma[0 * 8 + j];
            const real t1 = cos_r[j] * sigma_gap;
            const real tau_tangential = tau[0 * 8 + j];
            const real t2 = sin_r[j] * tau_tangential;
            const real p_fy = t1 + t2;
            K[4 * 8 + j] = K[9 * 8 + j] = p_fy; /* K(3,5) K(5,3) */
            K[0 * 8 + j] = K[6 * 8 + j] = -p_fy; /* K(0,5) K(5,0) */
            const real t3 = cos_r[j] * tau_tangential;
            const real t4 = sin_r[j] * sigma_gap;
            const real p_fx = t3 - t4;
            K[1 * 8 + j] = K[7 * 8 + j] = p_fx; /* K(1,5) K(5,1) */
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real t5 = sin_b[j] * (centre_x * t1 + centre_y * t4) + cos_b[j] * (centre_y * t1 - centre_x * t4);
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real t6 = t5 + centre_arm_y * t2 + centre_arm_x * t3;
            K[3 * 8 + j] = K[8 * 8 + j] = t6; /* K(2,5) K(5,2) */
            K[2 * 8 + j] = -t6; /* K(2,2) */
            K[5 * 8 + j] = K[10 * 8 + j] = -p_fx; /* K(4,5) K(5,4) */
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            K[11 * 8 + j] = -(d_x * p_fx + d_y * p_fy); /* K(5,5) */
        }
    }
}

/* outputs: 31 operations.
 * in:  x (6), sigma (1), tau (1), p (6)
 * out: place (2), force (2), origin (2), axes (2,2), axes_ball (2,2) */
FLEXEL_CLONES
static void planar_disc_line_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict place = out[0] + b * (2 * 8);
        real *restrict force = out[1] + b * (2 * 8);
        real *restrict origin = out[2] + b * (2 * 8);
        real *restrict axes = out[3] + b * (4 * 8);
        real *restrict axes_ball = out[4] + b * (4 * 8);
        real cos_b[8], sin_b[8], t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            axes_ball[0 * 8 + j] = axes_ball[3 * 8 + j] = cos_b[j]; /* axes_ball(0,0) axes_ball(1,1) */
            sin_b[j] = real_sin(b_angle);
            axes_ball[1 * 8 + j] = sin_b[j]; /* axes_ball(0,1) */
            cos_r[j] = real_cos(t0[j]);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r[j]; /* axes(0,0) axes(1,1) */
            sin_r[j] = real_sin(t0[j]);
            axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            place[0 * 8 + j] = p_x + centre_arm_x;
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            place[1 * 8 + j] = p_y + centre_arm_y;
            const real tau_tangential = tau[0 * 8 + j];
            const real sigma_gap = sigma[0 * 8 + j];
            const real p_fx = cos_r[j] * tau_tangential - sin_r[j] * sigma_gap;
            force[0 * 8 + j] = -p_fx;
            const real p_fy = cos_r[j] * sigma_gap + sin_r[j] * tau_tangential;
            force[1 * 8 + j] = -p_fy;
            const real offset_x = p[3 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real offset_y = p[4 * 8 + j];
            origin[0 * 8 + j] = c_x + offset_x * cos_r[j] - offset_y * sin_r[j];
            const real c_y = x[4 * 8 + j];
            origin[1 * 8 + j] = c_y + offset_x * sin_r[j] + offset_y * cos_r[j];
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
            axes_ball[2 * 8 + j] = -sin_b[j]; /* axes_ball(1,0) */
        }
    }
}

const flexel_element flexel_planar_disc_line = {
    .name = "planar_disc_line",
    .digest = "dcef7379ea005818",
    .n = 6,
    .m = 1,
    .k = 1,
    .np = 6,
    .position = planar_disc_line_position,
    .acceleration = planar_disc_line_acceleration,
    .rates = planar_disc_line_rates,
    .kinematics = planar_disc_line_kinematics,
    .stiffness = planar_disc_line_stiffness,
    .outputs = planar_disc_line_outputs,
};
