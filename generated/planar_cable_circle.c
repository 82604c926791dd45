/* planar_cable_circle: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x: point at the fraction xi of the cable's cubic curve;  ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * a = x - xc - offset_x ex - offset_y ey
 * gap = |a| - radius - rope_radius,  tangential = (ax wy - ay wx)/|a|, counterclockwise
 *
 * Source: planar counterpart of contact in space
 *
 * x (11): p_x, p_y, dp_x, dp_y, q_x, q_y, dq_x, dq_y, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (7):
 *   l0 (1) [m]: undeformed length
 *   xi (1) [1]: place along the element, from 0 at p to 1 at q
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   radius (1) [m]: radius at which the rope's surface touches, about the axle ex
 *   rope_radius (1) [m]: outer radius of the rope */
#include "kernels.h"

/* position: 72 operations.
 * in:  x (11), p (7)
 * out: e (1), De (1,11), V (1,11) */
FLEXEL_CLONES
static void planar_cable_circle_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict p = in[1] + b * (7 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (11 * 8);
        real *restrict V = out[2] + b * (11 * 8);
        real n2[8], n1[8], n0[8], t4[8], d_x[8], t5[8], sin_r[8], cos_r[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = xi * xi;
            const real t1 = 2.0 * xi;
            n2[j] = t0 * (3.0 - t1);
            const real q_x = x[4 * 8 + j];
            const real t2 = 1.0 - xi;
            const real t3 = t2 * t2;
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * xi * t3;
            const real dp_x = x[2 * 8 + j];
            n0[j] = t3 * (1.0 + t1);
            const real p_x = x[0 * 8 + j];
            const real c_x = x[8 * 8 + j];
            t4[j] = l0 * t0 * t2;
            const real dq_x = x[6 * 8 + j];
            d_x[j] = dp_x * n1[j] + p_x * n0[j] + q_x * n2[j] - c_x - dq_x * t4[j];
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t5[j] = r_angle + alpha0;
            const real q_y = x[5 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = dp_y * n1[j] + p_y * n0[j] + q_y * n2[j] - c_y - dq_y * t4[j];
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t5[j]);
            cos_r[j] = real_cos(t5[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real t6 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t7 = offset_x * cos_r[j];
            const real arm_x = d_x[j] + t6 - t7;
            const real t8 = offset_y * cos_r[j];
            const real t9 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t8 - t9;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real radius = p[5 * 8 + j];
            const real rope_radius = p[6 * 8 + j];
            e[0 * 8 + j] = distance - radius - rope_radius;
            const real t10 = 1.0 / distance;
            const real t11 = arm_x * t10;
            De[0 * 8 + j] = V[1 * 8 + j] = n0[j] * t11; /* De(0,0) V(0,1) */
            const real t12 = arm_y * t10;
            V[8 * 8 + j] = t12; /* V(0,8) */
            const real t13 = n0[j] * t12;
            De[1 * 8 + j] = t13; /* De(0,1) */
            De[2 * 8 + j] = V[3 * 8 + j] = n1[j] * t11; /* De(0,2) V(0,3) */
            const real t14 = n1[j] * t12;
            De[3 * 8 + j] = t14; /* De(0,3) */
            De[4 * 8 + j] = V[5 * 8 + j] = n2[j] * t11; /* De(0,4) V(0,5) */
            const real t15 = n2[j] * t12;
            De[5 * 8 + j] = t15; /* De(0,5) */
            De[6 * 8 + j] = V[7 * 8 + j] = -(t4[j] * t11); /* De(0,6) V(0,7) */
            const real t16 = t4[j] * t12;
            V[6 * 8 + j] = t16; /* V(0,6) */
            De[7 * 8 + j] = -t16; /* De(0,7) */
            De[8 * 8 + j] = V[9 * 8 + j] = -t11; /* De(0,8) V(0,9) */
            De[9 * 8 + j] = -t12; /* De(0,9) */
            De[10 * 8 + j] = t11 * (t8 + t9) + t12 * (t6 - t7); /* De(0,10) */
            V[0 * 8 + j] = -t13; /* V(0,0) */
            V[2 * 8 + j] = -t14; /* V(0,2) */
            V[4 * 8 + j] = -t15; /* V(0,4) */
            V[10 * 8 + j] = -(d_x[j] * t11 + d_y[j] * t12); /* V(0,10) */
        }
    }
}

/* acceleration: 117 operations.
 * in:  x (11), v (11), p (7)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_cable_circle_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real t0[8], sin_r[8], d_x[8], cos_r[8], d_y[8], t13[8], t19[8], sliding_y[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real xi = p[1 * 8 + j];
            const real t1 = 1.0 - xi;
            const real t2 = t1 * t1;
            const real l0 = p[0 * 8 + j];
            const real n1 = l0 * xi * t2;
            const real dp_x = x[2 * 8 + j];
            const real t3 = 2.0 * xi;
            const real n0 = t2 * (1.0 + t3);
            const real p_x = x[0 * 8 + j];
            const real t4 = xi * xi;
            const real n2 = t4 * (3.0 - t3);
            const real q_x = x[4 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real t5 = l0 * t4 * t1;
            const real dq_x = x[6 * 8 + j];
            d_x[j] = p_x * n0 + q_x * n2 + dp_x * n1 - c_x - dq_x * t5;
            const real dp_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = p_y * n0 + q_y * n2 + dp_y * n1 - c_y - dq_y * t5;
            const real dp_vy = v[3 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real c_vy = v[9 * 8 + j];
            const real t11 = p_vy * n0 + q_vy * n2 + dp_vy * n1 - c_vy;
            const real dq_vy = v[7 * 8 + j];
            const real t12 = dq_vy * t5;
            t13[j] = t11 - t12;
            const real dp_vx = v[2 * 8 + j];
            const real t15 = dp_vx * n1;
            const real p_vx = v[0 * 8 + j];
            const real t16 = p_vx * n0;
            const real q_vx = v[4 * 8 + j];
            const real t17 = q_vx * n2;
            const real c_vx = v[8 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t18 = dq_vx * t5;
            t19[j] = t16 + t17 + t15 - c_vx - t18;
            const real r_vangle = v[10 * 8 + j];
            sliding_y[j] = t11 - r_vangle * d_x[j] - t12;
            sliding_x[j] = t15 + r_vangle * d_y[j] + t16 + t17 - c_vx - t18;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = offset_y * sin_r[j] + d_x[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t6 = 1.0 / distance;
            const real r_vangle = v[10 * 8 + j];
            const real t7 = r_vangle * cos_r[j];
            const real t8 = r_vangle * t7;
            const real t9 = r_vangle * sin_r[j];
            const real t10 = r_vangle * t9;
            const real t14 = offset_y * t9 + t13[j] - offset_x * t7;
            const real t20 = offset_x * t9 + offset_y * t7 + t19[j];
            const real t21 = t20 * t20 + (offset_x * t8 - offset_y * t10) * arm_x + t14 * t14;
            const real t22 = arm_x * t20 + arm_y * t14;
            const real t23 = t6 * t6 * t6 * t22;
            g[0 * 8 + j] = t6 * ((offset_y * t8 + offset_x * t10) * arm_y + t21) - t22 * t23;
            const real t24 = sliding_y[j] * t20 - r_vangle * (arm_x * t19[j] + arm_y * t13[j]);
            gs[0 * 8 + j] = t6 * (t24 - sliding_x[j] * t14) - (arm_x * sliding_y[j] - arm_y * sliding_x[j]) * t23;
        }
    }
}

/* rates: 163 operations.
 * in:  x (11), v (11), p (7)
 * out: Phi_x (2,11) */
FLEXEL_CLONES
static void planar_cable_circle_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict Phi_x = out[0] + b * (22 * 8);
        real n0[8], t3[8], sin_r[8], n1[8], n2[8], t6[8], d_x[8], cos_r[8], d_y[8], t12[8], t13[8], t14[8], t17[8],
            t20[8], t21[8], sliding_y[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t3[j] = r_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * xi * t1;
            const real dp_x = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real t5 = xi * xi;
            n2[j] = t5 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real c_x = x[8 * 8 + j];
            t6[j] = l0 * t5 * t0;
            const real dq_x = x[6 * 8 + j];
            d_x[j] = p_x * n0[j] + q_x * n2[j] + dp_x * n1[j] - c_x - dq_x * t6[j];
            const real dp_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = p_y * n0[j] + q_y * n2[j] + dp_y * n1[j] - c_y - dq_y * t6[j];
            const real q_vx = v[4 * 8 + j];
            t12[j] = q_vx * n2[j];
            const real dp_vx = v[2 * 8 + j];
            t13[j] = dp_vx * n1[j];
            const real p_vx = v[0 * 8 + j];
            t14[j] = p_vx * n0[j];
            const real dq_vx = v[6 * 8 + j];
            t17[j] = dq_vx * t6[j];
            const real dp_vy = v[3 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            t20[j] = p_vy * n0[j] + q_vy * n2[j] + dp_vy * n1[j];
            const real dq_vy = v[7 * 8 + j];
            t21[j] = dq_vy * t6[j];
            const real c_vy = v[9 * 8 + j];
            const real r_vangle = v[10 * 8 + j];
            sliding_y[j] = t20[j] - c_vy - r_vangle * d_x[j] - t21[j];
            const real c_vx = v[8 * 8 + j];
            sliding_x[j] = t13[j] + r_vangle * d_y[j] + t14[j] + t12[j] - c_vx - t17[j];
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t3[j]);
            cos_r[j] = real_cos(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real t4 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t7 = offset_x * cos_r[j];
            const real arm_x = t4 + d_x[j] - t7;
            const real t8 = offset_y * cos_r[j];
            const real t9 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t8 - t9;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t10 = 1.0 / distance;
            const real r_vangle = v[10 * 8 + j];
            const real t11 = r_vangle * sin_r[j];
            const real t15 = r_vangle * cos_r[j];
            const real t16 = t14[j] + offset_y * t15 + t13[j] + t12[j] + offset_x * t11;
            const real c_vx = v[8 * 8 + j];
            const real t18 = t16 - c_vx - t17[j];
            const real t19 = t10 * t10 * t10;
            const real c_vy = v[9 * 8 + j];
            const real t22 = offset_y * t11 + t20[j] - c_vy - t21[j] - offset_x * t15;
            const real t23 = t19 * (arm_x * t18 + arm_y * t22);
            const real t24 = t10 * t18 - arm_x * t23;
            Phi_x[0 * 8 + j] = n0[j] * t24; /* Phi_x(0,0) */
            const real t25 = t10 * t22 - arm_y * t23;
            Phi_x[1 * 8 + j] = n0[j] * t25; /* Phi_x(0,1) */
            Phi_x[2 * 8 + j] = n1[j] * t24; /* Phi_x(0,2) */
            Phi_x[3 * 8 + j] = n1[j] * t25; /* Phi_x(0,3) */
            Phi_x[4 * 8 + j] = n2[j] * t24; /* Phi_x(0,4) */
            Phi_x[5 * 8 + j] = n2[j] * t25; /* Phi_x(0,5) */
            Phi_x[6 * 8 + j] = -(t6[j] * t24); /* Phi_x(0,6) */
            Phi_x[7 * 8 + j] = -(t6[j] * t25); /* Phi_x(0,7) */
            Phi_x[8 * 8 + j] = -t24; /* Phi_x(0,8) */
            Phi_x[9 * 8 + j] = -t25; /* Phi_x(0,9) */
            const real t26 = arm_y * t10;
            const real t27 = arm_x * t10;
            const real t28 = r_vangle * (offset_y * t26 + offset_x * t27) + offset_y * t24;
            const real t29 = r_vangle * (offset_y * t27 - offset_x * t26) - offset_y * t25;
            Phi_x[10 * 8 + j] = cos_r[j] * (t28 - offset_x * t25) - sin_r[j] * (t29 - offset_x * t24);
                /* Phi_x(0,10) */
            const real t30 = (arm_x * sliding_y[j] - arm_y * sliding_x[j]) * t19;
            const real t31 = arm_x * t30;
            const real t32 = t31 + t10 * (r_vangle * arm_x - sliding_y[j]);
            Phi_x[19 * 8 + j] = t32; /* Phi_x(1,8) */
            Phi_x[11 * 8 + j] = -(n0[j] * t32); /* Phi_x(1,0) */
            const real t33 = arm_y * t30;
            const real t34 = t33 + t10 * (sliding_x[j] + r_vangle * arm_y);
            Phi_x[20 * 8 + j] = t34; /* Phi_x(1,9) */
            Phi_x[12 * 8 + j] = -(n0[j] * t34); /* Phi_x(1,1) */
            Phi_x[13 * 8 + j] = -(n1[j] * t32); /* Phi_x(1,2) */
            Phi_x[14 * 8 + j] = -(n1[j] * t34); /* Phi_x(1,3) */
            Phi_x[15 * 8 + j] = -(n2[j] * t32); /* Phi_x(1,4) */
            Phi_x[16 * 8 + j] = -(n2[j] * t34); /* Phi_x(1,5) */
            Phi_x[17 * 8 + j] = t6[j] * t32; /* Phi_x(1,6) */
            Phi_x[18 * 8 + j] = t6[j] * t34; /* Phi_x(1,7) */
            const real t35 = t8 + t9;
            const real t36 = t4 - t7;
            const real t37 = t10 * (t35 * sliding_y[j] - t36 * sliding_x[j]) - t35 * t31;
            Phi_x[21 * 8 + j] = t37 - t36 * t33; /* Phi_x(1,10) */
        }
    }
}

/* kinematics: 373 operations.
 * in:  x (11), v (11), a (11), p (7)
 * out: Psi_x (2,11), Psi_v (2,11) */
FLEXEL_CLONES
static void planar_cable_circle_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict a = in[2] + b * (11 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict Psi_x = out[0] + b * (22 * 8);
        real *restrict Psi_v = out[1] + b * (22 * 8);
        real n0[8], t3[8], sin_r[8], n2[8], n1[8], t5[8], d_x[8], cos_r[8], d_y[8], t12[8], t13[8], t14[8], t17[8],
            t25[8], t29[8], t31[8], t32[8], t58[8], sliding_y[8], t60[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t3[j] = r_angle + alpha0;
            const real t4 = xi * xi;
            n2[j] = t4 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * t1 * xi;
            const real dp_x = x[2 * 8 + j];
            const real c_x = x[8 * 8 + j];
            t5[j] = l0 * t0 * t4;
            const real dq_x = x[6 * 8 + j];
            d_x[j] = p_x * n0[j] + dp_x * n1[j] + q_x * n2[j] - c_x - dq_x * t5[j];
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = p_y * n0[j] + dp_y * n1[j] + q_y * n2[j] - c_y - dq_y * t5[j];
            const real p_ax = a[0 * 8 + j];
            t12[j] = n0[j] * p_ax;
            const real dp_ax = a[2 * 8 + j];
            t13[j] = dp_ax * n1[j];
            const real q_ax = a[4 * 8 + j];
            t14[j] = n2[j] * q_ax;
            const real dq_ax = a[6 * 8 + j];
            t17[j] = dq_ax * t5[j];
            const real q_vx = v[4 * 8 + j];
            const real t21 = q_vx * n2[j];
            const real p_vx = v[0 * 8 + j];
            const real t22 = p_vx * n0[j];
            const real dp_vx = v[2 * 8 + j];
            const real t23 = dp_vx * n1[j];
            const real c_vx = v[8 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t24 = dq_vx * t5[j];
            t25[j] = t22 + t23 + t21 - c_vx - t24;
            const real q_vy = v[5 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real dp_vy = v[3 * 8 + j];
            const real c_vy = v[9 * 8 + j];
            const real t27 = p_vy * n0[j] + dp_vy * n1[j] + q_vy * n2[j] - c_vy;
            const real dq_vy = v[7 * 8 + j];
            const real t28 = dq_vy * t5[j];
            t29[j] = t27 - t28;
            const real q_ay = a[5 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real dp_ay = a[3 * 8 + j];
            t31[j] = n0[j] * p_ay + dp_ay * n1[j] + n2[j] * q_ay;
            const real dq_ay = a[7 * 8 + j];
            t32[j] = dq_ay * t5[j];
            const real c_ay = a[9 * 8 + j];
            const real r_aangle = a[10 * 8 + j];
            const real r_vangle = v[10 * 8 + j];
            t58[j] = t31[j] - c_ay - r_aangle * d_x[j] - t32[j] - r_vangle * t25[j];
            sliding_y[j] = t27 - r_vangle * d_x[j] - t28;
            const real t59 = t12[j] + t14[j] + t13[j] + r_vangle * t29[j] + r_aangle * d_y[j];
            const real c_ax = a[8 * 8 + j];
            t60[j] = t59 - c_ax - t17[j];
            sliding_x[j] = t22 + t21 + t23 + r_vangle * d_y[j] - c_vx - t24;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t3[j]);
            cos_r[j] = real_cos(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = offset_y * sin_r[j] + d_x[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t6 = 1.0 / distance;
            const real r_vangle = v[10 * 8 + j];
            const real t7 = r_vangle * cos_r[j];
            const real t8 = r_vangle * t7;
            const real t9 = r_vangle * sin_r[j];
            const real t10 = r_vangle * t9;
            const real r_aangle = a[10 * 8 + j];
            const real t11 = cos_r[j] * r_aangle;
            const real t15 = sin_r[j] * r_aangle;
            const real t16 = t14[j] + offset_x * t15 + t13[j] + t12[j] + offset_y * t11;
            const real c_ax = a[8 * 8 + j];
            const real t18 = offset_x * t8 - offset_y * t10 + (t16 - c_ax - t17[j]);
            const real t19 = t6 * t6;
            const real t20 = t6 * t19;
            const real t26 = offset_x * t9 + t25[j] + offset_y * t7;
            const real t30 = offset_y * t9 + t29[j] - offset_x * t7;
            const real c_ay = a[9 * 8 + j];
            const real t33 = offset_y * t8 + offset_x * t10 + (offset_y * t15 + t31[j] - c_ay - t32[j] - offset_x
                * t11);
            const real t34 = arm_x * t26 + arm_y * t30;
            const real t35 = t6 * t34;
            const real t36 = arm_x * t18 + arm_y * t33 + t30 * t30 + t26 * t26 - 2.0 * t35 * t35;
            const real t37 = t34 * t19;
            const real t38 = t20 * (t36 - t34 * t37);
            const real t39 = t35 * t19;
            const real t40 = t6 * t37;
            const real t41 = t39 + t40;
            const real t42 = t6 * t18 - arm_x * t38 - t26 * t41;
            Psi_x[0 * 8 + j] = n0[j] * t42; /* Psi_x(0,0) */
            const real t43 = t6 * t33 - arm_y * t38 - t30 * t41;
            Psi_x[1 * 8 + j] = n0[j] * t43; /* Psi_x(0,1) */
            Psi_x[2 * 8 + j] = n1[j] * t42; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = n1[j] * t43; /* Psi_x(0,3) */
            Psi_x[4 * 8 + j] = n2[j] * t42; /* Psi_x(0,4) */
            Psi_x[5 * 8 + j] = n2[j] * t43; /* Psi_x(0,5) */
            Psi_x[6 * 8 + j] = -(t5[j] * t42); /* Psi_x(0,6) */
            Psi_x[7 * 8 + j] = -(t5[j] * t43); /* Psi_x(0,7) */
            Psi_x[8 * 8 + j] = -t42; /* Psi_x(0,8) */
            Psi_x[9 * 8 + j] = -t43; /* Psi_x(0,9) */
            const real t44 = arm_y * t6;
            const real t45 = arm_x * t6;
            const real t46 = offset_y * t44 + offset_x * t45;
            const real t47 = t6 * t30;
            const real t48 = t47 - 0.5 * arm_y * t41;
            const real t49 = t6 * t26;
            const real t50 = t49 - 0.5 * arm_x * t41;
            const real t51 = offset_y * t45 - offset_x * t44;
            const real t52 = r_vangle * t51;
            const real t53 = r_vangle * (2.0 * (offset_y * t48 + offset_x * t50) - t52);
            const real t54 = cos_r[j] * (t53 + offset_y * t42 + r_aangle * t46 - offset_x * t43);
            const real t55 = r_vangle * t46;
            const real t56 = r_vangle * (t55 + 2.0 * (offset_y * t50 - offset_x * t48));
            const real t57 = sin_r[j] * (r_aangle * t51 + t56 - offset_y * t43 - offset_x * t42);
            Psi_x[10 * 8 + j] = t54 - t57; /* Psi_x(0,10) */
            const real t61 = arm_x * sliding_y[j] - arm_y * sliding_x[j];
            const real t62 = sliding_y[j] * t26 + arm_x * t58[j] - arm_y * t60[j] - 2.0 * t6 * t61 * t35;
            const real t63 = t61 * t19;
            const real t64 = t20 * (t62 - sliding_x[j] * t30 - t34 * t63);
            const real t65 = t6 * t63;
            const real t66 = t6 * t58[j] - arm_x * t64 - t26 * t65 - sliding_y[j] * t39;
            const real t67 = t49 - arm_x * t39;
            const real t68 = t66 - r_aangle * t45 - r_vangle * t67;
            Psi_x[11 * 8 + j] = n0[j] * t68; /* Psi_x(1,0) */
            const real t69 = sliding_x[j] * t39 - t6 * t60[j] - arm_y * t64 - t30 * t65;
            const real t70 = arm_y * t39 - t47;
            const real t71 = t69 + r_vangle * t70 - r_aangle * t44;
            Psi_x[12 * 8 + j] = n0[j] * t71; /* Psi_x(1,1) */
            Psi_x[13 * 8 + j] = n1[j] * t68; /* Psi_x(1,2) */
            Psi_x[14 * 8 + j] = n1[j] * t71; /* Psi_x(1,3) */
            Psi_x[15 * 8 + j] = n2[j] * t68; /* Psi_x(1,4) */
            Psi_x[16 * 8 + j] = n2[j] * t71; /* Psi_x(1,5) */
            Psi_x[17 * 8 + j] = -(t5[j] * t68); /* Psi_x(1,6) */
            Psi_x[18 * 8 + j] = -(t5[j] * t71); /* Psi_x(1,7) */
            Psi_x[19 * 8 + j] = -t68; /* Psi_x(1,8) */
            Psi_x[20 * 8 + j] = -t71; /* Psi_x(1,9) */
            const real t72 = t6 * sliding_y[j] - arm_x * t65;
            const real t73 = t6 * sliding_x[j] + arm_y * t65;
            const real t74 = offset_x * t72 - offset_y * t73;
            const real t75 = cos_r[j] * (r_vangle * t74 + offset_y * t66 - offset_x * t69);
            const real t76 = offset_x * t73 + offset_y * t72;
            const real t77 = sin_r[j] * (r_vangle * t76 - offset_y * t69 - offset_x * t66);
            Psi_x[21 * 8 + j] = t75 - t77; /* Psi_x(1,10) */
            const real t78 = 0.5 * arm_x * t40;
            const real t79 = t49 - t78 - t78;
            Psi_v[0 * 8 + j] = 2.0 * n0[j] * t79; /* Psi_v(0,0) */
            const real t80 = 0.5 * arm_y * t40;
            const real t81 = t47 - t80 - t80;
            Psi_v[1 * 8 + j] = 2.0 * n0[j] * t81; /* Psi_v(0,1) */
            Psi_v[2 * 8 + j] = 2.0 * n1[j] * t79; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = 2.0 * n1[j] * t81; /* Psi_v(0,3) */
            Psi_v[4 * 8 + j] = 2.0 * n2[j] * t79; /* Psi_v(0,4) */
            Psi_v[5 * 8 + j] = 2.0 * n2[j] * t81; /* Psi_v(0,5) */
            Psi_v[6 * 8 + j] = -(2.0 * t5[j] * t79); /* Psi_v(0,6) */
            Psi_v[7 * 8 + j] = -(2.0 * t5[j] * t81); /* Psi_v(0,7) */
            Psi_v[8 * 8 + j] = -(2.0 * t79); /* Psi_v(0,8) */
            Psi_v[9 * 8 + j] = -(2.0 * t81); /* Psi_v(0,9) */
            const real t82 = cos_r[j] * (t55 + offset_y * t79 - offset_x * t81) - sin_r[j] * (t52 - offset_y * t81
                - offset_x * t79);
            Psi_v[10 * 8 + j] = 2.0 * t82; /* Psi_v(0,10) */
            const real t83 = t72 + t70 - r_vangle * t45;
            Psi_v[11 * 8 + j] = n0[j] * t83; /* Psi_v(1,0) */
            const real t84 = t73 + r_vangle * t44 - t67;
            Psi_v[20 * 8 + j] = t84; /* Psi_v(1,9) */
            Psi_v[12 * 8 + j] = -(n0[j] * t84); /* Psi_v(1,1) */
            Psi_v[13 * 8 + j] = n1[j] * t83; /* Psi_v(1,2) */
            Psi_v[14 * 8 + j] = -(n1[j] * t84); /* Psi_v(1,3) */
            Psi_v[15 * 8 + j] = n2[j] * t83; /* Psi_v(1,4) */
            Psi_v[16 * 8 + j] = -(n2[j] * t84); /* Psi_v(1,5) */
            Psi_v[17 * 8 + j] = -(t5[j] * t83); /* Psi_v(1,6) */
            Psi_v[18 * 8 + j] = t5[j] * t84; /* Psi_v(1,7) */
            Psi_v[19 * 8 + j] = -t83; /* Psi_v(1,8) */
            const real t85 = sin_r[j] * t74 + d_y[j] * t70 + cos_r[j] * t76 - t25[j] * t45;
            Psi_v[21 * 8 + j] = t85 - t29[j] * t44 - d_x[j] * t67; /* Psi_v(1,10) */
        }
    }
}

/* stiffness: 391 operations.
 * in:  x (11), sigma (1), tau (1), p (7)
 * out: K (11,11) */
FLEXEL_CLONES
static void planar_cable_circle_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict K = out[0] + b * (121 * 8);
        real n0[8], t3[8], sin_r[8], n2[8], n1[8], t6[8], d_x[8], cos_r[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t3[j] = r_angle + alpha0;
            const real p_x = x[0 * 8 + j];
            const real t5 = xi * xi;
            n2[j] = t5 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * t1 * xi;
            const real dp_x = x[2 * 8 + j];
            const real c_x = x[8 * 8 + j];
            t6[j] = l0 * t0 * t5;
            const real dq_x = x[6 * 8 + j];
            d_x[j] = q_x * n2[j] + dp_x * n1[j] + p_x * n0[j] - c_x - dq_x * t6[j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = q_y * n2[j] + dp_y * n1[j] + p_y * n0[j] - c_y - dq_y * t6[j];
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t3[j]);
            cos_r[j] = real_cos(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real t4 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t7 = offset_x * cos_r[j];
            const real arm_x = t4 + d_x[j] - t7;
            const real t8 = offset_y * cos_r[j];
            const real t9 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t8 - t9;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t10 = 1.0 / distance;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t11 = sigma_gap * t10;
            const real t12 = t10 * t10 * t10;
            const real t13 = sigma_gap * t12;
            const real t14 = arm_x * t13;
            const real t15 = t11 - arm_x * t14;
            const real tau_tangential = tau[0 * 8 + j];
            const real t16 = tau_tangential * t12;
            const real t17 = arm_x * t16;
            const real t18 = arm_y * t17;
            const real t19 = n0[j] * t18;
            const real t20 = n0[j] * t15 + t19;
            K[0 * 8 + j] = n0[j] * t20; /* K(0,0) */
            const real t21 = arm_y * t13;
            const real t22 = arm_x * t21;
            const real t23 = n0[j] * t22;
            const real t24 = n0[j] * t23;
            const real t25 = tau_tangential * t10;
            const real t26 = arm_y * t16;
            const real t27 = t25 - arm_y * t26;
            const real t28 = n0[j] * t27;
            K[1 * 8 + j] = -(t24 + n0[j] * t28); /* K(0,1) */
            const real t29 = n1[j] * t15;
            const real t30 = n0[j] * t29;
            K[2 * 8 + j] = t30 + n1[j] * t19; /* K(0,2) */
            const real t31 = n1[j] * t22;
            const real t32 = n0[j] * t31;
            K[3 * 8 + j] = -(t32 + n1[j] * t28); /* K(0,3) */
            const real t33 = n2[j] * t15;
            const real t34 = n0[j] * t33;
            K[4 * 8 + j] = t34 + n2[j] * t19; /* K(0,4) */
            const real t35 = n2[j] * t22;
            const real t36 = n0[j] * t35;
            K[5 * 8 + j] = -(t36 + n2[j] * t28); /* K(0,5) */
            const real t37 = t6[j] * t15;
            const real t38 = n0[j] * t37;
            K[6 * 8 + j] = -(t38 + t6[j] * t19); /* K(0,6) */
            const real t39 = t6[j] * t22;
            const real t40 = n0[j] * t39;
            K[7 * 8 + j] = t40 + t6[j] * t28; /* K(0,7) */
            K[8 * 8 + j] = K[88 * 8 + j] = -t20; /* K(0,8) K(8,0) */
            K[9 * 8 + j] = t23 + t28; /* K(0,9) */
            const real t41 = t8 + t9;
            const real t42 = t4 - t7;
            const real t43 = t41 * t15 - t42 * t22;
            const real t44 = n0[j] * t43;
            const real t45 = t41 * t17 + t42 * t26;
            const real t46 = t42 * t25 - arm_y * t45;
            K[10 * 8 + j] = t44 - n0[j] * t46; /* K(0,10) */
            const real t47 = t25 - arm_x * t17;
            const real t48 = n0[j] * t47;
            K[11 * 8 + j] = n0[j] * t48 - t24; /* K(1,0) */
            const real t49 = t11 - arm_y * t21;
            const real t50 = arm_x * t26;
            const real t51 = n0[j] * t50;
            const real t52 = n0[j] * t49 - t51;
            K[12 * 8 + j] = n0[j] * t52; /* K(1,1) */
            const real t53 = arm_y * t14;
            const real t54 = n1[j] * t53;
            const real t55 = n0[j] * t54;
            K[13 * 8 + j] = n1[j] * t48 - t55; /* K(1,2) */
            const real t56 = n1[j] * t49;
            const real t57 = n0[j] * t56;
            K[14 * 8 + j] = t57 - n1[j] * t51; /* K(1,3) */
            const real t58 = n2[j] * t53;
            const real t59 = n0[j] * t58;
            K[15 * 8 + j] = n2[j] * t48 - t59; /* K(1,4) */
            const real t60 = n2[j] * t49;
            const real t61 = n0[j] * t60;
            K[16 * 8 + j] = t61 - n2[j] * t51; /* K(1,5) */
            const real t62 = t6[j] * t53;
            const real t63 = n0[j] * t62;
            K[17 * 8 + j] = t63 - t6[j] * t48; /* K(1,6) */
            const real t64 = t6[j] * t49;
            const real t65 = n0[j] * t64;
            K[18 * 8 + j] = t6[j] * t51 - t65; /* K(1,7) */
            const real t66 = n0[j] * t53;
            K[19 * 8 + j] = t66 - t48; /* K(1,8) */
            K[20 * 8 + j] = K[100 * 8 + j] = -t52; /* K(1,9) K(9,1) */
            const real t67 = t42 * t49 - t41 * t53;
            const real t68 = n0[j] * t67;
            const real t69 = t41 * t25 - arm_x * t45;
            K[21 * 8 + j] = t68 + n0[j] * t69; /* K(1,10) */
            const real t70 = n1[j] * t18;
            K[22 * 8 + j] = t30 + n0[j] * t70; /* K(2,0) */
            const real t71 = n1[j] * t27;
            K[23 * 8 + j] = -(t55 + n0[j] * t71); /* K(2,1) */
            const real t72 = t29 + t70;
            K[24 * 8 + j] = n1[j] * t72; /* K(2,2) */
            const real t73 = n1[j] * t31;
            K[25 * 8 + j] = -(t73 + n1[j] * t71); /* K(2,3) */
            const real t74 = n1[j] * t33;
            K[26 * 8 + j] = t74 + n2[j] * t70; /* K(2,4) */
            const real t75 = n1[j] * t35;
            K[27 * 8 + j] = -(t75 + n2[j] * t71); /* K(2,5) */
            const real t76 = n1[j] * t37;
            K[28 * 8 + j] = -(t76 + t6[j] * t70); /* K(2,6) */
            const real t77 = n1[j] * t39;
            K[29 * 8 + j] = t77 + t6[j] * t71; /* K(2,7) */
            K[30 * 8 + j] = K[90 * 8 + j] = -t72; /* K(2,8) K(8,2) */
            K[31 * 8 + j] = t31 + t71; /* K(2,9) */
            const real t78 = n1[j] * t43;
            K[32 * 8 + j] = t78 - n1[j] * t46; /* K(2,10) */
            const real t79 = n1[j] * t47;
            K[33 * 8 + j] = n0[j] * t79 - t32; /* K(3,0) */
            const real t80 = n1[j] * t50;
            K[34 * 8 + j] = t57 - n0[j] * t80; /* K(3,1) */
            K[35 * 8 + j] = n1[j] * t79 - t73; /* K(3,2) */
            const real t81 = t56 - t80;
            K[36 * 8 + j] = n1[j] * t81; /* K(3,3) */
            const real t82 = n1[j] * t58;
            K[37 * 8 + j] = n2[j] * t79 - t82; /* K(3,4) */
            const real t83 = n1[j] * t60;
            K[38 * 8 + j] = t83 - n2[j] * t80; /* K(3,5) */
            const real t84 = n1[j] * t62;
            K[39 * 8 + j] = t84 - t6[j] * t79; /* K(3,6) */
            const real t85 = n1[j] * t64;
            K[40 * 8 + j] = t6[j] * t80 - t85; /* K(3,7) */
            K[41 * 8 + j] = t54 - t79; /* K(3,8) */
            K[42 * 8 + j] = K[102 * 8 + j] = -t81; /* K(3,9) K(9,3) */
            const real t86 = n1[j] * t67;
            K[43 * 8 + j] = t86 + n1[j] * t69; /* K(3,10) */
            const real t87 = n2[j] * t18;
            K[44 * 8 + j] = t34 + n0[j] * t87; /* K(4,0) */
            const real t88 = n2[j] * t27;
            K[45 * 8 + j] = -(t59 + n0[j] * t88); /* K(4,1) */
            K[46 * 8 + j] = t74 + n1[j] * t87; /* K(4,2) */
            K[47 * 8 + j] = -(t82 + n1[j] * t88); /* K(4,3) */
            const real t89 = t33 + t87;
            K[48 * 8 + j] = n2[j] * t89; /* K(4,4) */
            const real t90 = n2[j] * t35;
            K[49 * 8 + j] = -(t90 + n2[j] * t88); /* K(4,5) */
            const real t91 = n2[j] * t37;
            K[50 * 8 + j] = -(t91 + t6[j] * t87); /* K(4,6) */
            const real t92 = n2[j] * t39;
            K[51 * 8 + j] = t92 + t6[j] * t88; /* K(4,7) */
            K[52 * 8 + j] = K[92 * 8 + j] = -t89; /* K(4,8) K(8,4) */
            K[53 * 8 + j] = t35 + t88; /* K(4,9) */
            const real t93 = n2[j] * t43;
            K[54 * 8 + j] = t93 - n2[j] * t46; /* K(4,10) */
            const real t94 = n2[j] * t47;
            K[55 * 8 + j] = n0[j] * t94 - t36; /* K(5,0) */
            const real t95 = n2[j] * t50;
            K[56 * 8 + j] = t61 - n0[j] * t95; /* K(5,1) */
            K[57 * 8 + j] = n1[j] * t94 - t75; /* K(5,2) */
            K[58 * 8 + j] = t83 - n1[j] * t95; /* K(5,3) */
            K[59 * 8 + j] = n2[j] * t94 - t90; /* K(5,4) */
            const real t96 = t60 - t95;
            K[60 * 8 + j] = n2[j] * t96; /* K(5,5) */
            const real t97 = n2[j] * t62;
            K[61 * 8 + j] = t97 - t6[j] * t94; /* K(5,6) */
            const real t98 = n2[j] * t64;
            K[62 * 8 + j] = t6[j] * t95 - t98; /* K(5,7) */
            K[63 * 8 + j] = t58 - t94; /* K(5,8) */
            K[64 * 8 + j] = K[104 * 8 + j] = -t96; /* K(5,9) K(9,5) */
            const real t99 = n2[j] * t67;
            K[65 * 8 + j] = t99 + n2[j] * t69; /* K(5,10) */
            const real t100 = t6[j] * t18;
            K[66 * 8 + j] = -(t38 + n0[j] * t100); /* K(6,0) */
            const real t101 = t6[j] * t27;
            K[67 * 8 + j] = t63 + n0[j] * t101; /* K(6,1) */
            K[68 * 8 + j] = -(t76 + n1[j] * t100); /* K(6,2) */
            K[69 * 8 + j] = t84 + n1[j] * t101; /* K(6,3) */
            K[70 * 8 + j] = -(t91 + n2[j] * t100); /* K(6,4) */
            K[71 * 8 + j] = t97 + n2[j] * t101; /* K(6,5) */
            const real t102 = t37 + t100;
            K[74 * 8 + j] = K[94 * 8 + j] = t102; /* K(6,8) K(8,6) */
            K[72 * 8 + j] = t6[j] * t102; /* K(6,6) */
            const real t103 = t6[j] * t39;
            K[73 * 8 + j] = -(t103 + t6[j] * t101); /* K(6,7) */
            K[75 * 8 + j] = -(t39 + t101); /* K(6,9) */
            const real t104 = t6[j] * t43;
            K[76 * 8 + j] = t6[j] * t46 - t104; /* K(6,10) */
            const real t105 = t6[j] * t47;
            K[77 * 8 + j] = t40 - n0[j] * t105; /* K(7,0) */
            const real t106 = t6[j] * t50;
            K[78 * 8 + j] = n0[j] * t106 - t65; /* K(7,1) */
            K[79 * 8 + j] = t77 - n1[j] * t105; /* K(7,2) */
            K[80 * 8 + j] = n1[j] * t106 - t85; /* K(7,3) */
            K[81 * 8 + j] = t92 - n2[j] * t105; /* K(7,4) */
            K[82 * 8 + j] = n2[j] * t106 - t98; /* K(7,5) */
            K[83 * 8 + j] = t6[j] * t105 - t103; /* K(7,6) */
            const real t107 = t64 - t106;
            K[86 * 8 + j] = K[106 * 8 + j] = t107; /* K(7,9) K(9,7) */
            K[84 * 8 + j] = t6[j] * t107; /* K(7,7) */
            K[85 * 8 + j] = t105 - t62; /* K(7,8) */
            const real t108 = t6[j] * t67;
            K[87 * 8 + j] = -(t108 + t6[j] * t69); /* K(7,10) */
            K[89 * 8 + j] = t66 + t28; /* K(8,1) */
            K[91 * 8 + j] = t54 + t71; /* K(8,3) */
            K[93 * 8 + j] = t58 + t88; /* K(8,5) */
            K[95 * 8 + j] = -(t62 + t101); /* K(8,7) */
            K[96 * 8 + j] = t15 + t18; /* K(8,8) */
            K[97 * 8 + j] = -(t22 + t27); /* K(8,9) */
            K[98 * 8 + j] = t46 - t43; /* K(8,10) */
            K[99 * 8 + j] = t23 - t48; /* K(9,0) */
            K[101 * 8 + j] = t31 - t79; /* K(9,2) */
            K[103 * 8 + j] = t35 - t94; /* K(9,4) */
            K[105 * 8 + j] = t105 - t39; /* K(9,6) */
            K[107 * 8 + j] = t47 - t22; /* K(9,8) */
            K[108 * 8 + j] = t49 - t50; /* K(9,9) */
            K[109 * 8 + j] = -(t67 + t69); /* K(9,10) */
            const real t109 = arm_x * t25 + d_x[j] * t47 - d_y[j] * t18;
            K[110 * 8 + j] = t44 - n0[j] * t109; /* K(10,0) */
            const real t110 = arm_y * t25 + d_y[j] * t27 - d_x[j] * t50;
            K[111 * 8 + j] = t68 - n0[j] * t110; /* K(10,1) */
            K[112 * 8 + j] = t78 - n1[j] * t109; /* K(10,2) */
            K[113 * 8 + j] = t86 - n1[j] * t110; /* K(10,3) */
            K[114 * 8 + j] = t93 - n2[j] * t109; /* K(10,4) */
            K[115 * 8 + j] = t99 - n2[j] * t110; /* K(10,5) */
            K[116 * 8 + j] = t6[j] * t109 - t104; /* K(10,6) */
            K[117 * 8 + j] = t6[j] * t110 - t108; /* K(10,7) */
            K[118 * 8 + j] = t109 - t43; /* K(10,8) */
            K[119 * 8 + j] = t110 - t67; /* K(10,9) */
            const real t111 = arm_y * t11;
            const real t112 = arm_x * t11;
            const real t113 = cos_r[j] * (offset_y * t111 + offset_x * t112) + t42 * t67;
            const real t114 = t41 * t43 + t113 - sin_r[j] * (offset_y * t112 - offset_x * t111);
            K[120 * 8 + j] = t114 - d_y[j] * t46 - d_x[j] * t69; /* K(10,10) */
        }
    }
}

const flexel_element flexel_planar_cable_circle = {
    .name = "planar_cable_circle",
    .digest = "a5a5cf784f2df773",
    .n = 11,
    .m = 1,
    .k = 1,
    .np = 7,
    .position = planar_cable_circle_position,
    .acceleration = planar_cable_circle_acceleration,
    .rates = planar_cable_circle_rates,
    .kinematics = planar_cable_circle_kinematics,
    .stiffness = planar_cable_circle_stiffness,
};
