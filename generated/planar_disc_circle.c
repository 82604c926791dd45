/* planar_disc_circle: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x = xp + R(angle_b) centre
 * ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * turn = angular velocity of the disc relative to the surface
 * a = x - xc - offset_x ex - offset_y ey
 * gap = |a| - radius - sphere_radius,  tangential = (ax wy - ay wx)/|a| - sphere_radius turn, counterclockwise
 * place: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows
 * axes_ball: axes of the body of what touches, in rows
 *
 * Source: planar counterpart of contact in space
 *
 * x (6): p_x, p_y, b_angle, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (7):
 *   centre (2) [m]: centre of the disc from p in the axes of its body
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   radius (1) [m]: radius at which the rope's or sphere's surface touches, about the axle ex
 *   sphere_radius (1) [m]: radius of the sphere; 0: a point */
#include "kernels.h"

/* position: 50 operations.
 * in:  x (6), p (7)
 * out: e (1), De (1,6), V (1,6) */
FLEXEL_CLONES
static void planar_disc_circle_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (7 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (6 * 8);
        real *restrict V = out[2] + b * (6 * 8);
        real cos_b[8], sin_b[8], t0[8], sin_r[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real offset_y = p[4 * 8 + j];
            const real t1 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t2 = offset_x * cos_r[j];
            const real arm_x = d_x + t1 - t2;
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real t3 = offset_y * cos_r[j];
            const real t4 = offset_x * sin_r[j];
            const real arm_y = d_y - t3 - t4;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real radius = p[5 * 8 + j];
            const real sphere_radius = p[6 * 8 + j];
            e[0 * 8 + j] = distance - radius - sphere_radius;
            const real t5 = 1.0 / distance;
            const real t6 = arm_x * t5;
            De[0 * 8 + j] = V[1 * 8 + j] = t6; /* De(0,0) V(0,1) */
            const real t7 = arm_y * t5;
            De[1 * 8 + j] = V[3 * 8 + j] = t7; /* De(0,1) V(0,3) */
            De[2 * 8 + j] = centre_arm_x * t7 - centre_arm_y * t6; /* De(0,2) */
            De[3 * 8 + j] = V[4 * 8 + j] = -t6; /* De(0,3) V(0,4) */
            De[4 * 8 + j] = V[0 * 8 + j] = -t7; /* De(0,4) V(0,0) */
            De[5 * 8 + j] = t6 * (t3 + t4) + t7 * (t1 - t2); /* De(0,5) */
            V[2 * 8 + j] = centre_arm_x * t6 - sphere_radius + centre_arm_y * t7; /* V(0,2) */
            V[5 * 8 + j] = sphere_radius - d_x * t6 - d_y * t7; /* V(0,5) */
        }
    }
}

/* acceleration: 113 operations.
 * in:  x (6), v (6), p (7)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_disc_circle_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real cos_b[8], sin_b[8], t0[8], sin_r[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = d_x + offset_y * sin_r[j] - offset_x * cos_r[j];
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real arm_y = d_y - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t1 = 1.0 / distance;
            const real r_vangle = v[5 * 8 + j];
            const real t2 = r_vangle * cos_r[j];
            const real t3 = r_vangle * t2;
            const real t4 = r_vangle * sin_r[j];
            const real t5 = r_vangle * t4;
            const real b_vangle = v[2 * 8 + j];
            const real t6 = b_vangle * sin_b[j];
            const real t7 = b_vangle * t6;
            const real t8 = b_vangle * cos_b[j];
            const real t9 = b_vangle * t8;
            const real t10 = offset_y * t3 + offset_x * t5 - centre_x * t7 - centre_y * t9;
            const real t11 = centre_x * t8 - centre_y * t6;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[4 * 8 + j];
            const real t12 = p_vy + t11 - c_vy;
            const real t13 = t12 + offset_y * t4 - offset_x * t2;
            const real t14 = centre_x * t6 + centre_y * t8;
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[3 * 8 + j];
            const real t15 = p_vx - t14 - c_vx;
            const real t16 = t15 + offset_y * t2 + offset_x * t4;
            const real t17 = centre_y * t7 + offset_x * t3 - centre_x * t9 - offset_y * t5;
            const real t18 = arm_x * t16 + arm_y * t13;
            const real t19 = t1 * t1 * t1 * t18;
            g[0 * 8 + j] = t1 * (t16 * t16 + arm_x * t17 + t13 * t13 + arm_y * t10) - t18 * t19;
            const real sliding_y = p_vy + b_vangle * centre_arm_x - c_vy - r_vangle * d_x;
            const real t20 = sliding_y * t16 - arm_x * (b_vangle * t14 + r_vangle * t15);
            const real sliding_x = p_vx + r_vangle * d_y - c_vx - b_vangle * centre_arm_y;
            const real t21 = t20 - arm_y * (r_vangle * t12 - b_vangle * t11) - sliding_x * t13;
            gs[0 * 8 + j] = t1 * t21 - (sliding_y * arm_x - sliding_x * arm_y) * t19;
        }
    }
}

/* rates: 153 operations.
 * in:  x (6), v (6), p (7)
 * out: Phi_x (2,6) */
FLEXEL_CLONES
static void planar_disc_circle_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict Phi_x = out[0] + b * (12 * 8);
        real cos_b[8], sin_b[8], t0[8], sin_r[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = d_x + offset_y * sin_r[j] - offset_x * cos_r[j];
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real arm_y = d_y - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t1 = 1.0 / distance;
            const real r_vangle = v[5 * 8 + j];
            const real t2 = r_vangle * cos_r[j];
            const real t3 = r_vangle * sin_r[j];
            const real p_vx = v[0 * 8 + j];
            const real b_vangle = v[2 * 8 + j];
            const real t4 = b_vangle * sin_b[j];
            const real t5 = b_vangle * cos_b[j];
            const real t6 = p_vx + offset_x * t3 + offset_y * t2 - centre_x * t4 - centre_y * t5;
            const real c_vx = v[3 * 8 + j];
            const real t7 = t6 - c_vx;
            const real t8 = t1 * t1;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[4 * 8 + j];
            const real t9 = p_vy + centre_x * t5 + offset_y * t3 - centre_y * t4 - c_vy;
            const real t10 = t9 - offset_x * t2;
            const real t11 = t1 * (arm_x * t7 + arm_y * t10) * t8;
            const real t12 = t1 * t7 - arm_x * t11;
            Phi_x[0 * 8 + j] = t12; /* Phi_x(0,0) */
            const real t13 = t1 * t10 - arm_y * t11;
            Phi_x[1 * 8 + j] = t13; /* Phi_x(0,1) */
            const real t14 = arm_y * t1;
            const real t15 = arm_x * t1;
            const real t16 = centre_x * t13 - b_vangle * (centre_y * t14 + centre_x * t15);
            const real t17 = b_vangle * (centre_x * t14 - centre_y * t15) + centre_y * t13;
            Phi_x[2 * 8 + j] = cos_b[j] * (t16 - centre_y * t12) - sin_b[j] * (centre_x * t12 + t17); /* Phi_x(0,2) */
            Phi_x[3 * 8 + j] = -t12; /* Phi_x(0,3) */
            Phi_x[4 * 8 + j] = -t13; /* Phi_x(0,4) */
            const real t18 = r_vangle * (offset_y * t14 + offset_x * t15) + offset_y * t12;
            const real t19 = r_vangle * (offset_y * t15 - offset_x * t14) - offset_y * t13;
            Phi_x[5 * 8 + j] = cos_r[j] * (t18 - offset_x * t13) - sin_r[j] * (t19 - offset_x * t12); /* Phi_x(0,5) */
            const real sliding_y = p_vy + b_vangle * centre_arm_x - c_vy - r_vangle * d_x;
            const real sliding_x = p_vx + r_vangle * d_y - c_vx - b_vangle * centre_arm_y;
            const real t20 = t1 * (sliding_y * arm_x - sliding_x * arm_y) * t8;
            const real t21 = sliding_y * t1 - arm_x * t20;
            const real t22 = t21 - r_vangle * t15;
            Phi_x[6 * 8 + j] = t22; /* Phi_x(1,0) */
            const real t23 = sliding_x * t1 + arm_y * t20;
            const real t24 = r_vangle * t14 + t23;
            Phi_x[10 * 8 + j] = t24; /* Phi_x(1,4) */
            Phi_x[7 * 8 + j] = -t24; /* Phi_x(1,1) */
            const real t25 = b_vangle * t14 - t24;
            const real t26 = b_vangle * t15 + t22;
            Phi_x[8 * 8 + j] = cos_b[j] * (centre_x * t25 - centre_y * t26) - sin_b[j] * (centre_y * t25 + centre_x
                * t26); /* Phi_x(1,2) */
            Phi_x[9 * 8 + j] = -t22; /* Phi_x(1,3) */
            Phi_x[11 * 8 + j] = cos_r[j] * (offset_x * t23 + offset_y * t21) - sin_r[j] * (offset_y * t23 - offset_x
                * t21); /* Phi_x(1,5) */
        }
    }
}

/* kinematics: 404 operations.
 * in:  x (6), v (6), a (6), p (7)
 * out: Psi_x (2,6), Psi_v (2,6) */
FLEXEL_CLONES
static void planar_disc_circle_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict Psi_x = out[0] + b * (12 * 8);
        real *restrict Psi_v = out[1] + b * (12 * 8);
        real cos_b[8], sin_b[8], t0[8], sin_r[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = d_x + offset_y * sin_r[j] - offset_x * cos_r[j];
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real arm_y = d_y - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t1 = 1.0 / distance;
            const real b_vangle = v[2 * 8 + j];
            const real t2 = b_vangle * sin_b[j];
            const real t3 = b_vangle * t2;
            const real r_vangle = v[5 * 8 + j];
            const real t4 = r_vangle * cos_r[j];
            const real t5 = r_vangle * t4;
            const real t6 = b_vangle * cos_b[j];
            const real t7 = b_vangle * t6;
            const real t8 = r_vangle * sin_r[j];
            const real t9 = r_vangle * t8;
            const real t10 = centre_y * t3 + offset_x * t5 - centre_x * t7 - offset_y * t9;
            const real r_aangle = a[5 * 8 + j];
            const real t11 = cos_r[j] * r_aangle;
            const real t12 = sin_r[j] * r_aangle;
            const real p_ax = a[0 * 8 + j];
            const real b_aangle = a[2 * 8 + j];
            const real t13 = sin_b[j] * b_aangle;
            const real t14 = cos_b[j] * b_aangle;
            const real t15 = p_ax + offset_x * t12 + offset_y * t11 - centre_x * t13 - centre_y * t14;
            const real c_ax = a[3 * 8 + j];
            const real t16 = t15 - c_ax + t10;
            const real t17 = t1 * t1;
            const real t18 = t1 * t17;
            const real t19 = centre_x * t2 + centre_y * t6;
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[3 * 8 + j];
            const real t20 = p_vx - t19 - c_vx;
            const real t21 = t20 + offset_x * t8 + offset_y * t4;
            const real t22 = centre_x * t6 - centre_y * t2;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[4 * 8 + j];
            const real t23 = p_vy + t22 - c_vy;
            const real t24 = t23 + offset_y * t8 - offset_x * t4;
            const real t25 = offset_y * t5 + offset_x * t9 - centre_x * t3 - centre_y * t7;
            const real p_ay = a[1 * 8 + j];
            const real c_ay = a[4 * 8 + j];
            const real t26 = p_ay + centre_x * t14 + offset_y * t12 - centre_y * t13 - c_ay;
            const real t27 = t26 - offset_x * t11 + t25;
            const real t28 = arm_y * t24 + arm_x * t21;
            const real t29 = t1 * t28;
            const real t30 = arm_x * t16 + arm_y * t27 + t24 * t24 + t21 * t21 - 2.0 * t29 * t29;
            const real t31 = t17 * t28;
            const real t32 = t18 * (t30 - t28 * t31);
            const real t33 = t17 * t29;
            const real t34 = t1 * t31;
            const real t35 = t33 + t34;
            const real t36 = t1 * t16 - arm_x * t32 - t21 * t35;
            Psi_x[0 * 8 + j] = t36; /* Psi_x(0,0) */
            const real t37 = t1 * t27 - arm_y * t32 - t24 * t35;
            Psi_x[1 * 8 + j] = t37; /* Psi_x(0,1) */
            const real t38 = arm_y * t1;
            const real t39 = arm_x * t1;
            const real t40 = centre_y * t38 + centre_x * t39;
            const real t41 = centre_x * t38 - centre_y * t39;
            const real t42 = b_vangle * t41;
            const real t43 = t1 * t21;
            const real t44 = t43 - 0.5 * arm_x * t35;
            const real t45 = t1 * t24;
            const real t46 = t45 - 0.5 * arm_y * t35;
            const real t47 = b_vangle * (t42 + 2.0 * (centre_x * t44 + centre_y * t46));
            const real t48 = cos_b[j] * (centre_x * t37 - b_aangle * t40 - t47 - centre_y * t36);
            const real t49 = b_vangle * t40;
            const real t50 = b_vangle * (2.0 * (centre_x * t46 - centre_y * t44) - t49);
            const real t51 = sin_b[j] * (b_aangle * t41 + t50 + centre_x * t36 + centre_y * t37);
            Psi_x[2 * 8 + j] = t48 - t51; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = -t36; /* Psi_x(0,3) */
            Psi_x[4 * 8 + j] = -t37; /* Psi_x(0,4) */
            const real t52 = offset_y * t38 + offset_x * t39;
            const real t53 = offset_y * t39 - offset_x * t38;
            const real t54 = r_vangle * t53;
            const real t55 = r_vangle * (2.0 * (offset_y * t46 + offset_x * t44) - t54);
            const real t56 = cos_r[j] * (r_aangle * t52 + t55 + offset_y * t36 - offset_x * t37);
            const real t57 = r_vangle * t52;
            const real t58 = r_vangle * (t57 + 2.0 * (offset_y * t44 - offset_x * t46));
            const real t59 = sin_r[j] * (r_aangle * t53 + t58 - offset_y * t37 - offset_x * t36);
            Psi_x[5 * 8 + j] = t56 - t59; /* Psi_x(0,5) */
            const real t60 = p_ay + centre_arm_x * b_aangle - c_ay - d_x * r_aangle - b_vangle * t19;
            const real t61 = t60 - r_vangle * t20;
            const real sliding_y = p_vy + b_vangle * centre_arm_x - c_vy - r_vangle * d_x;
            const real t62 = p_ax + d_y * r_aangle + r_vangle * t23 - b_vangle * t22 - c_ax;
            const real t63 = t62 - centre_arm_y * b_aangle;
            const real sliding_x = p_vx + r_vangle * d_y - c_vx - b_vangle * centre_arm_y;
            const real t64 = sliding_y * arm_x - sliding_x * arm_y;
            const real t65 = sliding_y * t21 + arm_x * t61 - arm_y * t63 - 2.0 * t1 * t64 * t29;
            const real t66 = t64 * t17;
            const real t67 = t18 * (t65 - sliding_x * t24 - t28 * t66);
            const real t68 = t1 * t66;
            const real t69 = t1 * t61 - arm_x * t67 - t21 * t68 - sliding_y * t33;
            const real t70 = t43 - arm_x * t33;
            const real t71 = t69 - r_aangle * t39 - r_vangle * t70;
            Psi_x[6 * 8 + j] = t71; /* Psi_x(1,0) */
            const real t72 = arm_y * t33 - t45;
            const real t73 = sliding_x * t33 - t1 * t63 - arm_y * t67 - t24 * t68;
            const real t74 = r_vangle * t72 + t73 - r_aangle * t38;
            Psi_x[7 * 8 + j] = t74; /* Psi_x(1,1) */
            const real t75 = b_aangle * t38 + t74 - b_vangle * t72;
            const real t76 = sliding_x * t1 + arm_y * t68;
            const real t77 = r_vangle * t38 + t76;
            const real t78 = b_vangle * t38 - t77;
            const real t79 = sliding_y * t1 - arm_x * t68;
            const real t80 = t79 - r_vangle * t39;
            const real t81 = b_vangle * t39 + t80;
            const real t82 = centre_y * t78 + centre_x * t81;
            const real t83 = b_aangle * t39 + t71 + b_vangle * t70;
            const real t84 = cos_b[j] * (centre_x * t75 - b_vangle * t82 - centre_y * t83);
            const real t85 = centre_x * t78 - centre_y * t81;
            const real t86 = sin_b[j] * (b_vangle * t85 + centre_y * t75 + centre_x * t83);
            Psi_x[8 * 8 + j] = t84 - t86; /* Psi_x(1,2) */
            Psi_x[9 * 8 + j] = -t71; /* Psi_x(1,3) */
            Psi_x[10 * 8 + j] = -t74; /* Psi_x(1,4) */
            const real t87 = offset_x * t79 - offset_y * t76;
            const real t88 = cos_r[j] * (r_vangle * t87 + offset_y * t69 - offset_x * t73);
            const real t89 = offset_x * t76 + offset_y * t79;
            const real t90 = sin_r[j] * (r_vangle * t89 - offset_y * t73 - offset_x * t69);
            Psi_x[11 * 8 + j] = t88 - t90; /* Psi_x(1,5) */
            const real t91 = 0.5 * arm_x * t34;
            const real t92 = t43 - t91 - t91;
            const real t93 = 2.0 * t92;
            Psi_v[0 * 8 + j] = t93; /* Psi_v(0,0) */
            const real t94 = 0.5 * arm_y * t34;
            const real t95 = t45 - t94 - t94;
            const real t96 = 2.0 * t95;
            Psi_v[1 * 8 + j] = t96; /* Psi_v(0,1) */
            const real t97 = cos_b[j] * (centre_x * t95 - t49 - centre_y * t92) - sin_b[j] * (t42 + centre_y * t95
                + centre_x * t92);
            Psi_v[2 * 8 + j] = 2.0 * t97; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = -t93; /* Psi_v(0,3) */
            Psi_v[4 * 8 + j] = -t96; /* Psi_v(0,4) */
            const real t98 = cos_r[j] * (t57 + offset_y * t92 - offset_x * t95) - sin_r[j] * (t54 - offset_y * t95
                - offset_x * t92);
            Psi_v[5 * 8 + j] = 2.0 * t98; /* Psi_v(0,5) */
            const real t99 = t80 + t72;
            Psi_v[6 * 8 + j] = t99; /* Psi_v(1,0) */
            const real t100 = t77 - t70;
            Psi_v[10 * 8 + j] = t100; /* Psi_v(1,4) */
            Psi_v[7 * 8 + j] = -t100; /* Psi_v(1,1) */
            const real t101 = t38 * t22 + cos_b[j] * t85 + centre_arm_x * t70 - t39 * t19;
            Psi_v[8 * 8 + j] = t101 - sin_b[j] * t82 - centre_arm_y * t72; /* Psi_v(1,2) */
            Psi_v[9 * 8 + j] = -t99; /* Psi_v(1,3) */
            const real t102 = cos_r[j] * t89 + sin_r[j] * t87 + d_y * t72 - t39 * t20 - t38 * t23;
            Psi_v[11 * 8 + j] = t102 - d_x * t70; /* Psi_v(1,5) */
        }
    }
}

/* stiffness: 189 operations.
 * in:  x (6), sigma (1), tau (1), p (7)
 * out: K (6,6) */
FLEXEL_CLONES
static void planar_disc_circle_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict K = out[0] + b * (36 * 8);
        real cos_b[8], sin_b[8], t0[8], sin_r[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            sin_b[j] = real_sin(b_angle);
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[3 * 8 + j];
            const real d_x = p_x + centre_arm_x - c_x;
            const real offset_y = p[4 * 8 + j];
            const real t1 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t2 = offset_x * cos_r[j];
            const real arm_x = d_x + t1 - t2;
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[4 * 8 + j];
            const real d_y = p_y + centre_arm_y - c_y;
            const real t3 = offset_y * cos_r[j];
            const real t4 = offset_x * sin_r[j];
            const real arm_y = d_y - t3 - t4;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t5 = 1.0 / distance;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t6 = t5 * sigma_gap;
            const real t7 = t5 * t5 * t5;
            const real t8 = sigma_gap * t7;
            const real t9 = arm_x * t8;
            const real t10 = t6 - arm_x * t9;
            const real tau_tangential = tau[0 * 8 + j];
            const real t11 = tau_tangential * t7;
            const real t12 = arm_x * t11;
            const real t13 = t10 + arm_y * t12;
            K[0 * 8 + j] = K[21 * 8 + j] = t13; /* K(0,0) K(3,3) */
            const real t14 = arm_y * t11;
            const real t15 = t5 * tau_tangential;
            const real t16 = arm_y * t14 - t15;
            const real t17 = arm_y * t8;
            const real t18 = arm_x * t17;
            const real t19 = t16 - t18;
            K[1 * 8 + j] = K[22 * 8 + j] = t19; /* K(0,1) K(3,4) */
            const real t20 = centre_arm_y * t10;
            const real t21 = t20 + centre_arm_x * t18;
            const real t22 = centre_arm_x * t15;
            const real t23 = centre_arm_y * t12 - centre_arm_x * t14;
            const real t24 = t22 + arm_y * t23;
            K[2 * 8 + j] = -(t21 + t24); /* K(0,2) */
            K[3 * 8 + j] = K[18 * 8 + j] = -t13; /* K(0,3) K(3,0) */
            K[4 * 8 + j] = -t19; /* K(0,4) */
            const real t25 = t3 + t4;
            const real t26 = t1 - t2;
            const real t27 = t25 * t10 - t26 * t18;
            const real t28 = t25 * t12 + t26 * t14;
            const real t29 = t27 + arm_y * t28 - t26 * t15;
            K[5 * 8 + j] = t29; /* K(0,5) */
            const real t30 = t15 - arm_x * t12;
            const real t31 = t30 - t18;
            K[6 * 8 + j] = K[27 * 8 + j] = t31; /* K(1,0) K(4,3) */
            const real t32 = t6 - arm_y * t17;
            const real t33 = t32 - arm_x * t14;
            K[7 * 8 + j] = K[28 * 8 + j] = t33; /* K(1,1) K(4,4) */
            const real t34 = arm_y * t9;
            const real t35 = centre_arm_x * t32;
            const real t36 = centre_arm_y * t34 + t35;
            const real t37 = centre_arm_y * t15;
            const real t38 = t37 - arm_x * t23;
            K[8 * 8 + j] = t36 - t38; /* K(1,2) */
            K[9 * 8 + j] = t34 - t30; /* K(1,3) */
            K[10 * 8 + j] = K[25 * 8 + j] = -t33; /* K(1,4) K(4,1) */
            const real t39 = t26 * t32 - t25 * t34;
            const real t40 = t25 * t15;
            const real t41 = t39 + t40 - arm_x * t28;
            K[11 * 8 + j] = t41; /* K(1,5) */
            const real t42 = centre_arm_x * arm_x + centre_arm_y * arm_y;
            const real t43 = t42 * t12 - t22;
            K[12 * 8 + j] = -(t21 + t43); /* K(2,0) */
            const real t44 = t42 * t14 - t37;
            K[13 * 8 + j] = t36 - t44; /* K(2,1) */
            const real t45 = arm_y * t6;
            const real t46 = arm_x * t6;
            const real t47 = centre_arm_x * t36 + centre_arm_y * t21 + t42 * t23 - sin_b[j] * (centre_x * t45
                - centre_y * t46);
            const real t48 = arm_x * t15;
            const real t49 = arm_y * t15;
            const real t50 = centre_arm_y * t48 - centre_arm_x * t49;
            K[14 * 8 + j] = t47 - cos_b[j] * (centre_y * t45 + centre_x * t46) - t50; /* K(2,2) */
            const real t51 = t20 + centre_arm_x * t34;
            K[15 * 8 + j] = t51 + t43; /* K(2,3) */
            const real t52 = t35 + centre_arm_y * t18;
            K[16 * 8 + j] = t44 - t52; /* K(2,4) */
            const real t53 = centre_arm_x * t39 - centre_arm_y * t27;
            K[17 * 8 + j] = t53 + t26 * t37 + centre_arm_x * t40 - t42 * t28; /* K(2,5) */
            K[19 * 8 + j] = t34 - t16; /* K(3,1) */
            K[20 * 8 + j] = t51 + t24; /* K(3,2) */
            K[23 * 8 + j] = -t29; /* K(3,5) */
            K[24 * 8 + j] = -t31; /* K(4,0) */
            K[26 * 8 + j] = t38 - t52; /* K(4,2) */
            K[29 * 8 + j] = -t41; /* K(4,5) */
            const real t54 = d_x * arm_x + d_y * arm_y;
            const real t55 = t27 + t54 * t12 - t48 - d_x * t15;
            K[30 * 8 + j] = t55; /* K(5,0) */
            const real t56 = d_y * t15;
            const real t57 = t39 + t54 * t14 - t49 - t56;
            K[31 * 8 + j] = t57; /* K(5,1) */
            K[32 * 8 + j] = t53 + t50 + d_x * t37 - centre_arm_x * t56 - t54 * t23; /* K(5,2) */
            K[33 * 8 + j] = -t55; /* K(5,3) */
            K[34 * 8 + j] = -t57; /* K(5,4) */
            const real t58 = cos_r[j] * (offset_y * t45 + offset_x * t46) + t26 * (t39 - t56);
            const real t59 = t25 * t27 + t58 + t54 * t28 - sin_r[j] * (offset_y * t46 - offset_x * t45);
            K[35 * 8 + j] = t59 - d_x * t40; /* K(5,5) */
        }
    }
}

/* outputs: 44 operations.
 * in:  x (6), sigma (1), tau (1), p (7)
 * out: place (2), force (2), origin (2), axes (2,2), axes_ball (2,2) */
FLEXEL_CLONES
static void planar_disc_circle_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict place = out[0] + b * (2 * 8);
        real *restrict force = out[1] + b * (2 * 8);
        real *restrict origin = out[2] + b * (2 * 8);
        real *restrict axes = out[3] + b * (4 * 8);
        real *restrict axes_ball = out[4] + b * (4 * 8);
        real cos_b[8], sin_b[8], t2[8], sin_r[8], cos_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[5 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t2[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real b_angle = x[2 * 8 + j];
            cos_b[j] = real_cos(b_angle);
            axes_ball[0 * 8 + j] = axes_ball[3 * 8 + j] = cos_b[j]; /* axes_ball(0,0) axes_ball(1,1) */
            sin_b[j] = real_sin(b_angle);
            axes_ball[1 * 8 + j] = sin_b[j]; /* axes_ball(0,1) */
            sin_r[j] = real_sin(t2[j]);
            axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
            cos_r[j] = real_cos(t2[j]);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r[j]; /* axes(0,0) axes(1,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real centre_x = p[0 * 8 + j];
            const real centre_y = p[1 * 8 + j];
            const real centre_arm_x = centre_x * cos_b[j] - centre_y * sin_b[j];
            const real p_x = x[0 * 8 + j];
            const real t0 = p_x + centre_arm_x;
            place[0 * 8 + j] = t0;
            const real centre_arm_y = centre_x * sin_b[j] + centre_y * cos_b[j];
            const real p_y = x[1 * 8 + j];
            const real t1 = p_y + centre_arm_y;
            place[1 * 8 + j] = t1;
            const real c_x = x[3 * 8 + j];
            const real d_x = t0 - c_x;
            const real offset_y = p[4 * 8 + j];
            const real t3 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t4 = offset_x * cos_r[j];
            const real arm_x = d_x + t3 - t4;
            const real c_y = x[4 * 8 + j];
            const real d_y = t1 - c_y;
            const real t5 = offset_y * cos_r[j];
            const real t6 = offset_x * sin_r[j];
            const real arm_y = d_y - t5 - t6;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t7 = 1.0 / distance;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t8 = t7 * sigma_gap;
            const real tau_tangential = tau[0 * 8 + j];
            const real t9 = t7 * tau_tangential;
            const real p_fx = arm_x * t8 - arm_y * t9;
            force[0 * 8 + j] = -p_fx;
            const real p_fy = arm_y * t8 + arm_x * t9;
            force[1 * 8 + j] = -p_fy;
            origin[0 * 8 + j] = c_x + t4 - t3;
            origin[1 * 8 + j] = c_y + t6 + t5;
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
            axes_ball[2 * 8 + j] = -sin_b[j]; /* axes_ball(1,0) */
        }
    }
}

const flexel_element flexel_planar_disc_circle = {
    .name = "planar_disc_circle",
    .digest = "0ba88eba3b1818c7",
    .n = 6,
    .m = 1,
    .k = 1,
    .np = 7,
    .position = planar_disc_circle_position,
    .acceleration = planar_disc_circle_acceleration,
    .rates = planar_disc_circle_rates,
    .kinematics = planar_disc_circle_kinematics,
    .stiffness = planar_disc_circle_stiffness,
    .outputs = planar_disc_circle_outputs,
};
