/* planar_point_circle: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x: place of p
 * ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * a = x - xc - offset_x ex - offset_y ey
 * gap = |a| - radius - sphere_radius,  tangential = (ax wy - ay wx)/|a|, counterclockwise
 * place: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows
 *
 * Source: planar counterpart of contact in space
 *
 * x (5): p_x, p_y, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (5):
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   radius (1) [m]: radius at which the rope's or sphere's surface touches, about the axle ex
 *   sphere_radius (1) [m]: radius of the sphere; 0: a point */
#include "kernels.h"

/* position: 37 operations.
 * in:  x (5), p (5)
 * out: e (1), De (1,5), V (1,5) */
FLEXEL_CLONES
static void planar_point_circle_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict p = in[1] + b * (5 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (5 * 8);
        real *restrict V = out[2] + b * (5 * 8);
        real d_x[8], t0[8], sin_r[8], cos_r[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[2 * 8 + j];
            const real offset_x = p[1 * 8 + j];
            const real arm_x = d_x[j] + offset_y * sin_r[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real radius = p[3 * 8 + j];
            const real sphere_radius = p[4 * 8 + j];
            e[0 * 8 + j] = distance - radius - sphere_radius;
            const real t1 = 1.0 / distance;
            const real t2 = arm_x * t1;
            De[0 * 8 + j] = V[1 * 8 + j] = t2; /* De(0,0) V(0,1) */
            const real t3 = arm_y * t1;
            De[1 * 8 + j] = V[2 * 8 + j] = t3; /* De(0,1) V(0,2) */
            De[2 * 8 + j] = V[3 * 8 + j] = -t2; /* De(0,2) V(0,3) */
            De[3 * 8 + j] = V[0 * 8 + j] = -t3; /* De(0,3) V(0,0) */
            De[4 * 8 + j] = cos_r[j] * (offset_y * t2 - offset_x * t3) + sin_r[j] * (offset_y * t3 + offset_x * t2);
                /* De(0,4) */
            V[4 * 8 + j] = -(d_x[j] * t2 + d_y[j] * t3); /* V(0,4) */
        }
    }
}

/* acceleration: 73 operations.
 * in:  x (5), v (5), p (5)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_point_circle_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict v = in[1] + b * (5 * 8);
        const real *restrict p = in[2] + b * (5 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real d_x[8], t0[8], sin_r[8], cos_r[8], d_y[8], t3[8], t8[8], sliding_y[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[2 * 8 + j];
            t3[j] = p_vx - c_vx;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[3 * 8 + j];
            t8[j] = p_vy - c_vy;
            const real r_vangle = v[4 * 8 + j];
            sliding_y[j] = t8[j] - r_vangle * d_x[j];
            sliding_x[j] = p_vx + r_vangle * d_y[j] - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[2 * 8 + j];
            const real offset_x = p[1 * 8 + j];
            const real arm_x = d_x[j] + offset_y * sin_r[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t1 = 1.0 / distance;
            const real r_vangle = v[4 * 8 + j];
            const real t2 = r_vangle * sin_r[j];
            const real t4 = r_vangle * cos_r[j];
            const real t5 = t3[j] + offset_y * t4 + offset_x * t2;
            const real t6 = r_vangle * t4;
            const real t7 = r_vangle * t2;
            const real t9 = t8[j] + offset_y * t2 - offset_x * t4;
            const real t10 = t9 * t9 + arm_y * (offset_y * t6 + offset_x * t7) + arm_x * (offset_x * t6 - offset_y
                * t7);
            const real t11 = arm_x * t5 + arm_y * t9;
            const real t12 = t1 * t1 * t1 * t11;
            g[0 * 8 + j] = t1 * (t5 * t5 + t10) - t11 * t12;
            const real t13 = sliding_y[j] * t5 - r_vangle * (arm_x * t3[j] + t8[j] * arm_y);
            gs[0 * 8 + j] = t1 * (t13 - sliding_x[j] * t9) - (sliding_y[j] * arm_x - sliding_x[j] * arm_y) * t12;
        }
    }
}

/* rates: 97 operations.
 * in:  x (5), v (5), p (5)
 * out: Phi_x (2,5) */
FLEXEL_CLONES
static void planar_point_circle_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict v = in[1] + b * (5 * 8);
        const real *restrict p = in[2] + b * (5 * 8);
        real *restrict Phi_x = out[0] + b * (10 * 8);
        real d_x[8], t0[8], sin_r[8], cos_r[8], d_y[8], t10[8], sliding_y[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[3 * 8 + j];
            t10[j] = p_vy - c_vy;
            const real r_vangle = v[4 * 8 + j];
            sliding_y[j] = t10[j] - r_vangle * d_x[j];
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[2 * 8 + j];
            sliding_x[j] = p_vx + r_vangle * d_y[j] - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[2 * 8 + j];
            const real t1 = offset_y * sin_r[j];
            const real offset_x = p[1 * 8 + j];
            const real t2 = offset_x * cos_r[j];
            const real arm_x = d_x[j] + t1 - t2;
            const real t3 = offset_y * cos_r[j];
            const real t4 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t3 - t4;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t5 = 1.0 / distance;
            const real r_vangle = v[4 * 8 + j];
            const real t6 = r_vangle * cos_r[j];
            const real t7 = r_vangle * sin_r[j];
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[2 * 8 + j];
            const real t8 = p_vx + offset_x * t7 + offset_y * t6 - c_vx;
            const real t9 = t5 * t5;
            const real t11 = t10[j] + offset_y * t7 - offset_x * t6;
            const real t12 = t5 * (arm_y * t11 + arm_x * t8) * t9;
            const real t13 = t5 * t8 - arm_x * t12;
            Phi_x[0 * 8 + j] = t13; /* Phi_x(0,0) */
            const real t14 = t5 * t11 - arm_y * t12;
            Phi_x[1 * 8 + j] = t14; /* Phi_x(0,1) */
            Phi_x[2 * 8 + j] = -t13; /* Phi_x(0,2) */
            Phi_x[3 * 8 + j] = -t14; /* Phi_x(0,3) */
            const real t15 = arm_y * t5;
            const real t16 = arm_x * t5;
            const real t17 = r_vangle * (offset_y * t15 + offset_x * t16) + offset_y * t13;
            const real t18 = r_vangle * (offset_y * t16 - offset_x * t15) - offset_y * t14;
            Phi_x[4 * 8 + j] = cos_r[j] * (t17 - offset_x * t14) - sin_r[j] * (t18 - offset_x * t13); /* Phi_x(0,4) */
            const real t19 = t5 * (sliding_y[j] * arm_x - sliding_x[j] * arm_y) * t9;
            const real t20 = arm_x * t19;
            const real t21 = t5 * (sliding_y[j] - r_vangle * arm_x) - t20;
            Phi_x[5 * 8 + j] = t21; /* Phi_x(1,0) */
            const real t22 = arm_y * t19;
            const real t23 = t5 * (sliding_x[j] + r_vangle * arm_y) + t22;
            Phi_x[8 * 8 + j] = t23; /* Phi_x(1,3) */
            Phi_x[6 * 8 + j] = -t23; /* Phi_x(1,1) */
            Phi_x[7 * 8 + j] = -t21; /* Phi_x(1,2) */
            const real t24 = t3 + t4;
            const real t25 = t1 - t2;
            const real t26 = t5 * (sliding_y[j] * t24 - sliding_x[j] * t25) - t24 * t20;
            Phi_x[9 * 8 + j] = t26 - t25 * t22; /* Phi_x(1,4) */
        }
    }
}

/* kinematics: 261 operations.
 * in:  x (5), v (5), a (5), p (5)
 * out: Psi_x (2,5), Psi_v (2,5) */
FLEXEL_CLONES
static void planar_point_circle_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict v = in[1] + b * (5 * 8);
        const real *restrict a = in[2] + b * (5 * 8);
        const real *restrict p = in[3] + b * (5 * 8);
        real *restrict Psi_x = out[0] + b * (10 * 8);
        real *restrict Psi_v = out[1] + b * (10 * 8);
        real d_x[8], t0[8], sin_r[8], cos_r[8], d_y[8], t11[8], t13[8], t15[8], t41[8], sliding_y[8], t42[8],
            sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[3 * 8 + j];
            t11[j] = p_vy - c_vy;
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[2 * 8 + j];
            t13[j] = p_vx - c_vx;
            const real p_ay = a[1 * 8 + j];
            const real c_ay = a[3 * 8 + j];
            t15[j] = p_ay - c_ay;
            const real r_aangle = a[4 * 8 + j];
            const real r_vangle = v[4 * 8 + j];
            t41[j] = t15[j] - d_x[j] * r_aangle - r_vangle * t13[j];
            sliding_y[j] = t11[j] - r_vangle * d_x[j];
            const real p_ax = a[0 * 8 + j];
            const real c_ax = a[2 * 8 + j];
            t42[j] = p_ax + d_y[j] * r_aangle + r_vangle * t11[j] - c_ax;
            sliding_x[j] = p_vx + r_vangle * d_y[j] - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[2 * 8 + j];
            const real offset_x = p[1 * 8 + j];
            const real arm_x = d_x[j] + offset_y * sin_r[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t1 = 1.0 / distance;
            const real r_vangle = v[4 * 8 + j];
            const real t2 = r_vangle * cos_r[j];
            const real t3 = r_vangle * t2;
            const real t4 = r_vangle * sin_r[j];
            const real t5 = r_vangle * t4;
            const real r_aangle = a[4 * 8 + j];
            const real t6 = cos_r[j] * r_aangle;
            const real t7 = sin_r[j] * r_aangle;
            const real p_ax = a[0 * 8 + j];
            const real c_ax = a[2 * 8 + j];
            const real t8 = offset_x * t3 - offset_y * t5 + (p_ax + offset_x * t7 + offset_y * t6 - c_ax);
            const real t9 = t1 * t1;
            const real t10 = t1 * t9;
            const real t12 = t11[j] + offset_y * t4 - offset_x * t2;
            const real t14 = t13[j] + offset_x * t4 + offset_y * t2;
            const real t16 = offset_y * t3 + offset_x * t5 + (t15[j] + offset_y * t7 - offset_x * t6);
            const real t17 = arm_y * t12 + arm_x * t14;
            const real t18 = t1 * t17;
            const real t19 = arm_x * t8 + arm_y * t16 + t14 * t14 + t12 * t12 - 2.0 * t18 * t18;
            const real t20 = t9 * t17;
            const real t21 = t10 * (t19 - t17 * t20);
            const real t22 = t9 * t18;
            const real t23 = t1 * t20;
            const real t24 = t22 + t23;
            const real t25 = t1 * t8 - arm_x * t21 - t14 * t24;
            Psi_x[0 * 8 + j] = t25; /* Psi_x(0,0) */
            const real t26 = t1 * t16 - arm_y * t21 - t12 * t24;
            Psi_x[1 * 8 + j] = t26; /* Psi_x(0,1) */
            Psi_x[2 * 8 + j] = -t25; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = -t26; /* Psi_x(0,3) */
            const real t27 = arm_y * t1;
            const real t28 = arm_x * t1;
            const real t29 = offset_y * t27 + offset_x * t28;
            const real t30 = t1 * t12;
            const real t31 = t30 - 0.5 * arm_y * t24;
            const real t32 = t1 * t14;
            const real t33 = t32 - 0.5 * arm_x * t24;
            const real t34 = offset_y * t28 - offset_x * t27;
            const real t35 = r_vangle * t34;
            const real t36 = r_vangle * (2.0 * (offset_y * t31 + offset_x * t33) - t35);
            const real t37 = cos_r[j] * (r_aangle * t29 + t36 + offset_y * t25 - offset_x * t26);
            const real t38 = r_vangle * t29;
            const real t39 = r_vangle * (t38 + 2.0 * (offset_y * t33 - offset_x * t31));
            const real t40 = sin_r[j] * (r_aangle * t34 + t39 - offset_y * t26 - offset_x * t25);
            Psi_x[4 * 8 + j] = t37 - t40; /* Psi_x(0,4) */
            const real t43 = sliding_y[j] * arm_x - sliding_x[j] * arm_y;
            const real t44 = sliding_y[j] * t14 + arm_x * t41[j] - arm_y * t42[j] - 2.0 * t1 * t43 * t18;
            const real t45 = t43 * t9;
            const real t46 = t10 * (t44 - sliding_x[j] * t12 - t17 * t45);
            const real t47 = t1 * t45;
            const real t48 = t1 * t41[j] - arm_x * t46 - t14 * t47 - sliding_y[j] * t22;
            const real t49 = t32 - arm_x * t22;
            const real t50 = t48 - r_aangle * t28 - r_vangle * t49;
            Psi_x[5 * 8 + j] = t50; /* Psi_x(1,0) */
            const real t51 = arm_y * t22 - t30;
            const real t52 = sliding_x[j] * t22 - t1 * t42[j] - arm_y * t46 - t12 * t47;
            const real t53 = r_vangle * t51 + t52 - r_aangle * t27;
            Psi_x[6 * 8 + j] = t53; /* Psi_x(1,1) */
            Psi_x[7 * 8 + j] = -t50; /* Psi_x(1,2) */
            Psi_x[8 * 8 + j] = -t53; /* Psi_x(1,3) */
            const real t54 = sliding_y[j] * t1 - arm_x * t47;
            const real t55 = sliding_x[j] * t1 + arm_y * t47;
            const real t56 = offset_x * t54 - offset_y * t55;
            const real t57 = cos_r[j] * (r_vangle * t56 + offset_y * t48 - offset_x * t52);
            const real t58 = offset_x * t55 + offset_y * t54;
            const real t59 = sin_r[j] * (r_vangle * t58 - offset_y * t52 - offset_x * t48);
            Psi_x[9 * 8 + j] = t57 - t59; /* Psi_x(1,4) */
            const real t60 = 0.5 * arm_x * t23;
            const real t61 = t32 - t60 - t60;
            const real t62 = 2.0 * t61;
            Psi_v[0 * 8 + j] = t62; /* Psi_v(0,0) */
            const real t63 = 0.5 * arm_y * t23;
            const real t64 = t30 - t63 - t63;
            const real t65 = 2.0 * t64;
            Psi_v[1 * 8 + j] = t65; /* Psi_v(0,1) */
            Psi_v[2 * 8 + j] = -t62; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = -t65; /* Psi_v(0,3) */
            const real t66 = cos_r[j] * (t38 + offset_y * t61 - offset_x * t64) - sin_r[j] * (t35 - offset_y * t64
                - offset_x * t61);
            Psi_v[4 * 8 + j] = 2.0 * t66; /* Psi_v(0,4) */
            const real t67 = t54 + t51 - r_vangle * t28;
            Psi_v[5 * 8 + j] = t67; /* Psi_v(1,0) */
            const real t68 = t49 - r_vangle * t27 - t55;
            Psi_v[6 * 8 + j] = t68; /* Psi_v(1,1) */
            Psi_v[7 * 8 + j] = -t67; /* Psi_v(1,2) */
            Psi_v[8 * 8 + j] = -t68; /* Psi_v(1,3) */
            const real t69 = cos_r[j] * t58 + sin_r[j] * t56 + d_y[j] * t51 - t28 * t13[j];
            Psi_v[9 * 8 + j] = t69 - t11[j] * t27 - d_x[j] * t49; /* Psi_v(1,4) */
        }
    }
}

/* stiffness: 118 operations.
 * in:  x (5), sigma (1), tau (1), p (5)
 * out: K (5,5) */
FLEXEL_CLONES
static void planar_point_circle_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (5 * 8);
        real *restrict K = out[0] + b * (25 * 8);
        real d_x[8], t0[8], sin_r[8], cos_r[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[2 * 8 + j];
            const real t1 = offset_y * sin_r[j];
            const real offset_x = p[1 * 8 + j];
            const real t2 = offset_x * cos_r[j];
            const real arm_x = d_x[j] + t1 - t2;
            const real t3 = offset_y * cos_r[j];
            const real t4 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t3 - t4;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t5 = 1.0 / distance;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t6 = t5 * sigma_gap;
            const real t7 = t5 * t5 * t5;
            const real tau_tangential = tau[0 * 8 + j];
            const real t8 = tau_tangential * t7;
            const real t9 = arm_x * t8;
            const real t10 = sigma_gap * t7;
            const real t11 = arm_x * t10;
            const real t12 = t6 + arm_y * t9 - arm_x * t11;
            K[0 * 8 + j] = K[12 * 8 + j] = t12; /* K(0,0) K(2,2) */
            const real t13 = arm_y * t10;
            const real t14 = arm_x * t13;
            const real t15 = t5 * tau_tangential;
            const real t16 = arm_y * t8;
            const real t17 = t14 + t15 - arm_y * t16;
            K[3 * 8 + j] = K[11 * 8 + j] = t17; /* K(0,3) K(2,1) */
            K[1 * 8 + j] = K[13 * 8 + j] = -t17; /* K(0,1) K(2,3) */
            K[2 * 8 + j] = K[10 * 8 + j] = -t12; /* K(0,2) K(2,0) */
            const real t18 = t3 + t4;
            const real t19 = t1 - t2;
            const real t20 = t18 * t9 + t19 * t16;
            const real t21 = offset_y * t6;
            const real t22 = t4 * t6 + cos_r[j] * t21;
            const real t23 = t19 * t13 + t18 * t11;
            const real t24 = t22 - arm_x * t23;
            const real t25 = arm_y * t20 + t24 - t19 * t15;
            K[4 * 8 + j] = t25; /* K(0,4) */
            const real t26 = t14 + arm_x * t9 - t15;
            K[7 * 8 + j] = K[15 * 8 + j] = t26; /* K(1,2) K(3,0) */
            K[5 * 8 + j] = K[17 * 8 + j] = -t26; /* K(1,0) K(3,2) */
            const real t27 = t6 - arm_y * t13 - arm_x * t16;
            K[6 * 8 + j] = K[18 * 8 + j] = t27; /* K(1,1) K(3,3) */
            K[8 * 8 + j] = K[16 * 8 + j] = -t27; /* K(1,3) K(3,1) */
            const real t28 = t19 * t6 - arm_y * t23;
            const real t29 = t18 * t15 + t28 - arm_x * t20;
            K[9 * 8 + j] = t29; /* K(1,4) */
            K[14 * 8 + j] = -t25; /* K(2,4) */
            K[19 * 8 + j] = -t29; /* K(3,4) */
            const real t30 = d_x[j] * arm_x + d_y[j] * arm_y;
            const real t31 = d_x[j] * t15;
            const real t32 = t30 * t9 + t24 - arm_x * t15 - t31;
            K[20 * 8 + j] = t32; /* K(4,0) */
            const real t33 = d_y[j] * t15;
            const real t34 = t30 * t16 + t28 - arm_y * t15 - t33;
            K[21 * 8 + j] = t34; /* K(4,1) */
            K[22 * 8 + j] = -t32; /* K(4,2) */
            K[23 * 8 + j] = -t34; /* K(4,3) */
            const real t35 = arm_y * t6;
            const real t36 = arm_x * t6;
            const real t37 = t18 * (t22 - t31) + t19 * (sin_r[j] * t21 - t2 * t6 - t33);
            const real t38 = cos_r[j] * (offset_y * t35 + offset_x * t36) + t37 + t30 * t20;
            K[24 * 8 + j] = t38 - sin_r[j] * (offset_y * t36 - offset_x * t35) - (arm_x * t18 + arm_y * t19) * t23;
                /* K(4,4) */
        }
    }
}

/* outputs: 33 operations.
 * in:  x (5), sigma (1), tau (1), p (5)
 * out: place (2), force (2), origin (2), axes (2,2) */
FLEXEL_CLONES
static void planar_point_circle_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (5 * 8);
        real *restrict place = out[0] + b * (2 * 8);
        real *restrict force = out[1] + b * (2 * 8);
        real *restrict origin = out[2] + b * (2 * 8);
        real *restrict axes = out[3] + b * (4 * 8);
        real d_x[8], t0[8], sin_r[8], cos_r[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            place[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            place[1 * 8 + j] = p_y;
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
            cos_r[j] = real_cos(t0[j]);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r[j]; /* axes(0,0) axes(1,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[2 * 8 + j];
            const real t1 = offset_y * sin_r[j];
            const real offset_x = p[1 * 8 + j];
            const real t2 = offset_x * cos_r[j];
            const real arm_x = d_x[j] + t1 - t2;
            const real t3 = offset_y * cos_r[j];
            const real t4 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t3 - t4;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t5 = 1.0 / distance;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t6 = t5 * sigma_gap;
            const real tau_tangential = tau[0 * 8 + j];
            const real t7 = t5 * tau_tangential;
            const real p_fx = arm_x * t6 - arm_y * t7;
            force[0 * 8 + j] = -p_fx;
            const real p_fy = arm_y * t6 + arm_x * t7;
            force[1 * 8 + j] = -p_fy;
            const real c_x = x[2 * 8 + j];
            origin[0 * 8 + j] = c_x + t2 - t1;
            const real c_y = x[3 * 8 + j];
            origin[1 * 8 + j] = c_y + t4 + t3;
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
        }
    }
}

const flexel_element flexel_planar_point_circle = {
    .name = "planar_point_circle",
    .digest = "c54e052906f0b4d4",
    .n = 5,
    .m = 1,
    .k = 1,
    .np = 5,
    .position = planar_point_circle_position,
    .acceleration = planar_point_circle_acceleration,
    .rates = planar_point_circle_rates,
    .kinematics = planar_point_circle_kinematics,
    .stiffness = planar_point_circle_stiffness,
    .outputs = planar_point_circle_outputs,
};
