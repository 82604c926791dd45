/* planar_cable_line: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x: point at the fraction xi of the cable's cubic curve;  ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * gap = ey.(x - xc) - offset_y - rope_radius,  tangential = ex.w
 *
 * Source: planar counterpart of contact in space
 *
 * x (11): p_x, p_y, dp_x, dp_y, q_x, q_y, dq_x, dq_y, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (6):
 *   l0 (1) [m]: undeformed length
 *   xi (1) [1]: place along the element, from 0 at p to 1 at q
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   rope_radius (1) [m]: outer radius of the rope */
#include "kernels.h"

/* position: 56 operations.
 * in:  x (11), p (6)
 * out: e (1), De (1,11), V (1,11) */
FLEXEL_CLONES
static void planar_cable_line_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict p = in[1] + b * (6 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (11 * 8);
        real *restrict V = out[2] + b * (11 * 8);
        real n2[8], n1[8], n0[8], t4[8], d_y[8], t5[8], cos_r[8], d_x[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = xi * xi;
            const real t1 = 2.0 * xi;
            n2[j] = t0 * (3.0 - t1);
            const real q_y = x[5 * 8 + j];
            const real t2 = 1.0 - xi;
            const real t3 = t2 * t2;
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * xi * t3;
            const real dp_y = x[3 * 8 + j];
            n0[j] = t3 * (1.0 + t1);
            const real p_y = x[1 * 8 + j];
            const real c_y = x[9 * 8 + j];
            t4[j] = l0 * t0 * t2;
            const real dq_y = x[7 * 8 + j];
            d_y[j] = dp_y * n1[j] + p_y * n0[j] + q_y * n2[j] - c_y - dq_y * t4[j];
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t5[j] = r_angle + alpha0;
            const real q_x = x[4 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            d_x[j] = dp_x * n1[j] + p_x * n0[j] + q_x * n2[j] - c_x - dq_x * t4[j];
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t5[j]);
            sin_r[j] = real_sin(t5[j]);
            De[8 * 8 + j] = sin_r[j]; /* De(0,8) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t6 = d_y[j] * cos_r[j];
            const real offset_y = p[4 * 8 + j];
            const real rope_radius = p[5 * 8 + j];
            const real t7 = d_x[j] * sin_r[j];
            e[0 * 8 + j] = t6 - offset_y - rope_radius - t7;
            const real t8 = n0[j] * sin_r[j];
            V[1 * 8 + j] = t8; /* V(0,1) */
            De[0 * 8 + j] = -t8; /* De(0,0) */
            De[1 * 8 + j] = V[0 * 8 + j] = n0[j] * cos_r[j]; /* De(0,1) V(0,0) */
            const real t9 = n1[j] * sin_r[j];
            V[3 * 8 + j] = t9; /* V(0,3) */
            De[2 * 8 + j] = -t9; /* De(0,2) */
            De[3 * 8 + j] = V[2 * 8 + j] = n1[j] * cos_r[j]; /* De(0,3) V(0,2) */
            const real t10 = n2[j] * sin_r[j];
            V[5 * 8 + j] = t10; /* V(0,5) */
            De[4 * 8 + j] = -t10; /* De(0,4) */
            De[5 * 8 + j] = V[4 * 8 + j] = n2[j] * cos_r[j]; /* De(0,5) V(0,4) */
            const real t11 = t4[j] * sin_r[j];
            De[6 * 8 + j] = t11; /* De(0,6) */
            De[7 * 8 + j] = V[6 * 8 + j] = -(t4[j] * cos_r[j]); /* De(0,7) V(0,6) */
            De[9 * 8 + j] = V[8 * 8 + j] = -cos_r[j]; /* De(0,9) V(0,8) */
            De[10 * 8 + j] = -(d_y[j] * sin_r[j] + d_x[j] * cos_r[j]); /* De(0,10) */
            V[7 * 8 + j] = -t11; /* V(0,7) */
            V[9 * 8 + j] = -sin_r[j]; /* V(0,9) */
            V[10 * 8 + j] = t6 - t7; /* V(0,10) */
        }
    }
}

/* acceleration: 76 operations.
 * in:  x (11), v (11), p (6)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_cable_line_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real t0[8], sin_r[8], d_x[8], cos_r[8], d_y[8], t10[8], t16[8], sliding_y[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real xi = p[1 * 8 + j];
            const real t2 = 1.0 - xi;
            const real t3 = t2 * t2;
            const real t4 = 2.0 * xi;
            const real n0 = t3 * (1.0 + t4);
            const real p_x = x[0 * 8 + j];
            const real t5 = xi * xi;
            const real n2 = t5 * (3.0 - t4);
            const real q_x = x[4 * 8 + j];
            const real l0 = p[0 * 8 + j];
            const real n1 = l0 * t3 * xi;
            const real dp_x = x[2 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real t6 = l0 * t2 * t5;
            const real dq_x = x[6 * 8 + j];
            d_x[j] = q_x * n2 + dp_x * n1 + p_x * n0 - c_x - dq_x * t6;
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = q_y * n2 + dp_y * n1 + p_y * n0 - c_y - dq_y * t6;
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real dp_vy = v[3 * 8 + j];
            const real c_vy = v[9 * 8 + j];
            const real t8 = q_vy * n2 + dp_vy * n1 + p_vy * n0 - c_vy;
            const real dq_vy = v[7 * 8 + j];
            const real t9 = dq_vy * t6;
            t10[j] = t8 - t9;
            const real p_vx = v[0 * 8 + j];
            const real t12 = p_vx * n0;
            const real q_vx = v[4 * 8 + j];
            const real t13 = q_vx * n2;
            const real dp_vx = v[2 * 8 + j];
            const real t14 = dp_vx * n1;
            const real c_vx = v[8 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t15 = dq_vx * t6;
            t16[j] = t13 + t14 + t12 - c_vx - t15;
            const real r_vangle = v[10 * 8 + j];
            sliding_y[j] = t8 - r_vangle * d_x[j] - t9;
            sliding_x[j] = t12 + t13 + t14 + r_vangle * d_y[j] - c_vx - t15;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[10 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real t7 = r_vangle * cos_r[j];
            const real t11 = t1 * t10[j];
            const real t17 = t7 * t16[j];
            g[0 * 8 + j] = r_vangle * (t1 * d_x[j] - t7 * d_y[j]) - t11 - t11 - t17 - t17;
            const real t18 = r_vangle * (cos_r[j] * t10[j] - sin_r[j] * t16[j]) + t7 * sliding_y[j];
            gs[0 * 8 + j] = t18 - t1 * sliding_x[j];
        }
    }
}

/* rates: 83 operations.
 * in:  x (11), v (11), p (6)
 * out: Phi_x (2,11) */
FLEXEL_CLONES
static void planar_cable_line_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict Phi_x = out[0] + b * (22 * 8);
        real n0[8], t3[8], cos_r[8], sin_r[8], n1[8], n2[8], t10[8], d_x[8], t14[8], t20[8], sliding_y[8],
            sliding_x[8];
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
            n1[j] = l0 * t1 * xi;
            const real t8 = xi * xi;
            n2[j] = t8 * (3.0 - t2);
            t10[j] = l0 * t0 * t8;
            const real p_x = x[0 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            d_x[j] = q_x * n2[j] + dp_x * n1[j] + p_x * n0[j] - c_x - dq_x * t10[j];
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real dp_vy = v[3 * 8 + j];
            const real c_vy = v[9 * 8 + j];
            const real t12 = q_vy * n2[j] + dp_vy * n1[j] + p_vy * n0[j] - c_vy;
            const real dq_vy = v[7 * 8 + j];
            const real t13 = dq_vy * t10[j];
            t14[j] = t12 - t13;
            const real p_vx = v[0 * 8 + j];
            const real t15 = p_vx * n0[j];
            const real dp_vx = v[2 * 8 + j];
            const real t16 = dp_vx * n1[j];
            const real q_vx = v[4 * 8 + j];
            const real t17 = q_vx * n2[j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            const real d_y = q_y * n2[j] + dp_y * n1[j] + p_y * n0[j] - c_y - dq_y * t10[j];
            const real r_vangle = v[10 * 8 + j];
            const real t18 = r_vangle * d_y;
            const real c_vx = v[8 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t19 = dq_vx * t10[j];
            t20[j] = t17 + t18 + t16 + t15 - c_vx - t19;
            sliding_y[j] = t12 - r_vangle * d_x[j] - t13;
            sliding_x[j] = t15 + t17 + t16 + t18 - c_vx - t19;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t3[j]);
            sin_r[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[10 * 8 + j];
            const real t4 = r_vangle * cos_r[j];
            Phi_x[8 * 8 + j] = t4; /* Phi_x(0,8) */
            const real t5 = n0[j] * t4;
            Phi_x[12 * 8 + j] = t5; /* Phi_x(1,1) */
            Phi_x[0 * 8 + j] = -t5; /* Phi_x(0,0) */
            const real t6 = r_vangle * sin_r[j];
            Phi_x[9 * 8 + j] = Phi_x[19 * 8 + j] = t6; /* Phi_x(0,9) Phi_x(1,8) */
            Phi_x[1 * 8 + j] = Phi_x[11 * 8 + j] = -(n0[j] * t6); /* Phi_x(0,1) Phi_x(1,0) */
            const real t7 = t4 * n1[j];
            Phi_x[14 * 8 + j] = t7; /* Phi_x(1,3) */
            Phi_x[2 * 8 + j] = -t7; /* Phi_x(0,2) */
            Phi_x[3 * 8 + j] = Phi_x[13 * 8 + j] = -(t6 * n1[j]); /* Phi_x(0,3) Phi_x(1,2) */
            const real t9 = n2[j] * t4;
            Phi_x[16 * 8 + j] = t9; /* Phi_x(1,5) */
            Phi_x[4 * 8 + j] = -t9; /* Phi_x(0,4) */
            Phi_x[5 * 8 + j] = Phi_x[15 * 8 + j] = -(n2[j] * t6); /* Phi_x(0,5) Phi_x(1,4) */
            const real t11 = t4 * t10[j];
            Phi_x[6 * 8 + j] = t11; /* Phi_x(0,6) */
            Phi_x[7 * 8 + j] = Phi_x[17 * 8 + j] = t6 * t10[j]; /* Phi_x(0,7) Phi_x(1,6) */
            Phi_x[10 * 8 + j] = t6 * d_x[j] - sin_r[j] * t14[j] - cos_r[j] * t20[j]; /* Phi_x(0,10) */
            Phi_x[18 * 8 + j] = -t11; /* Phi_x(1,7) */
            Phi_x[20 * 8 + j] = -t4; /* Phi_x(1,9) */
            Phi_x[21 * 8 + j] = cos_r[j] * sliding_y[j] - sin_r[j] * sliding_x[j]; /* Phi_x(1,10) */
        }
    }
}

/* kinematics: 168 operations.
 * in:  x (11), v (11), a (11), p (6)
 * out: Psi_x (2,11), Psi_v (2,11) */
FLEXEL_CLONES
static void planar_cable_line_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict a = in[2] + b * (11 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict Psi_x = out[0] + b * (22 * 8);
        real *restrict Psi_v = out[1] + b * (22 * 8);
        real n0[8], t3[8], cos_r[8], sin_r[8], n1[8], n2[8], t12[8], d_x[8], t18[8], d_y[8], t24[8], t34[8], t35[8],
            t36[8], t37[8], t38[8], t44[8];
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
            n1[j] = l0 * t1 * xi;
            const real t10 = xi * xi;
            n2[j] = t10 * (3.0 - t2);
            t12[j] = l0 * t0 * t10;
            const real dq_ax = a[6 * 8 + j];
            const real t14 = dq_ax * t12[j];
            const real p_x = x[0 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            d_x[j] = q_x * n2[j] + dp_x * n1[j] + p_x * n0[j] - c_x - dq_x * t12[j];
            const real r_vangle = v[10 * 8 + j];
            const real t15 = r_vangle * d_x[j];
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real dp_vy = v[3 * 8 + j];
            const real c_vy = v[9 * 8 + j];
            const real t16 = q_vy * n2[j] + dp_vy * n1[j] + p_vy * n0[j] - c_vy;
            const real dq_vy = v[7 * 8 + j];
            const real t17 = dq_vy * t12[j];
            t18[j] = t16 - t17;
            const real c_ax = a[8 * 8 + j];
            const real q_ax = a[4 * 8 + j];
            const real t19 = n2[j] * q_ax;
            const real dp_ax = a[2 * 8 + j];
            const real t20 = dp_ax * n1[j];
            const real p_ax = a[0 * 8 + j];
            const real t21 = n0[j] * p_ax;
            const real t22 = c_ax + r_vangle * (t15 - 2.0 * t18[j]) + t14 - t19 - t20 - t21;
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = q_y * n2[j] + dp_y * n1[j] + p_y * n0[j] - c_y - dq_y * t12[j];
            const real r_aangle = a[10 * 8 + j];
            const real t23 = r_aangle * d_y[j];
            t24[j] = t22 - t23;
            const real p_ay = a[1 * 8 + j];
            const real q_ay = a[5 * 8 + j];
            const real dp_ay = a[3 * 8 + j];
            const real t25 = n2[j] * q_ay + dp_ay * n1[j] + n0[j] * p_ay;
            const real c_ay = a[9 * 8 + j];
            const real dq_ay = a[7 * 8 + j];
            const real t26 = dq_ay * t12[j];
            const real t27 = r_aangle * d_x[j];
            const real t28 = r_vangle * d_y[j];
            const real p_vx = v[0 * 8 + j];
            const real t29 = p_vx * n0[j];
            const real q_vx = v[4 * 8 + j];
            const real t30 = q_vx * n2[j];
            const real dp_vx = v[2 * 8 + j];
            const real t31 = dp_vx * n1[j];
            const real c_vx = v[8 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t32 = dq_vx * t12[j];
            const real t33 = t30 + t31 + t29 - c_vx - t32;
            t34[j] = t25 - c_ay - t26 - t27 - r_vangle * (t28 + 2.0 * t33);
            const real sliding_x = t29 + t30 + t31 + t28 - c_vx - t32;
            t35[j] = sliding_x + t33;
            t36[j] = t25 - r_vangle * t35[j] - c_ay - t27 - t26;
            const real sliding_y = t16 - t15 - t17;
            t37[j] = sliding_y + t18[j];
            t38[j] = t19 + r_vangle * t37[j] + t21 + t20 + t23 - c_ax - t14;
            t44[j] = t28 + t33;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t3[j]);
            sin_r[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_aangle = a[10 * 8 + j];
            const real r_vangle = v[10 * 8 + j];
            const real t4 = r_vangle * sin_r[j];
            const real t5 = cos_r[j] * r_aangle - r_vangle * t4;
            Psi_x[8 * 8 + j] = t5; /* Psi_x(0,8) */
            const real t6 = n0[j] * t5;
            Psi_x[12 * 8 + j] = t6; /* Psi_x(1,1) */
            Psi_x[0 * 8 + j] = -t6; /* Psi_x(0,0) */
            const real t7 = r_vangle * cos_r[j];
            const real t8 = r_vangle * t7 + sin_r[j] * r_aangle;
            Psi_x[9 * 8 + j] = Psi_x[19 * 8 + j] = t8; /* Psi_x(0,9) Psi_x(1,8) */
            Psi_x[1 * 8 + j] = Psi_x[11 * 8 + j] = -(n0[j] * t8); /* Psi_x(0,1) Psi_x(1,0) */
            const real t9 = n1[j] * t5;
            Psi_x[14 * 8 + j] = t9; /* Psi_x(1,3) */
            Psi_x[2 * 8 + j] = -t9; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = Psi_x[13 * 8 + j] = -(n1[j] * t8); /* Psi_x(0,3) Psi_x(1,2) */
            const real t11 = n2[j] * t5;
            Psi_x[16 * 8 + j] = t11; /* Psi_x(1,5) */
            Psi_x[4 * 8 + j] = -t11; /* Psi_x(0,4) */
            Psi_x[5 * 8 + j] = Psi_x[15 * 8 + j] = -(n2[j] * t8); /* Psi_x(0,5) Psi_x(1,4) */
            const real t13 = t12[j] * t5;
            Psi_x[6 * 8 + j] = t13; /* Psi_x(0,6) */
            Psi_x[7 * 8 + j] = Psi_x[17 * 8 + j] = t12[j] * t8; /* Psi_x(0,7) Psi_x(1,6) */
            Psi_x[10 * 8 + j] = cos_r[j] * t24[j] - sin_r[j] * t34[j]; /* Psi_x(0,10) */
            Psi_x[18 * 8 + j] = -t13; /* Psi_x(1,7) */
            Psi_x[20 * 8 + j] = -t5; /* Psi_x(1,9) */
            Psi_x[21 * 8 + j] = cos_r[j] * t36[j] - sin_r[j] * t38[j]; /* Psi_x(1,10) */
            const real t39 = 2.0 * n0[j] * t7;
            Psi_v[12 * 8 + j] = t39; /* Psi_v(1,1) */
            Psi_v[0 * 8 + j] = -t39; /* Psi_v(0,0) */
            Psi_v[1 * 8 + j] = Psi_v[11 * 8 + j] = -(2.0 * n0[j] * t4); /* Psi_v(0,1) Psi_v(1,0) */
            const real t40 = 2.0 * t7 * n1[j];
            Psi_v[14 * 8 + j] = t40; /* Psi_v(1,3) */
            Psi_v[2 * 8 + j] = -t40; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = Psi_v[13 * 8 + j] = -(2.0 * t4 * n1[j]); /* Psi_v(0,3) Psi_v(1,2) */
            const real t41 = 2.0 * n2[j] * t7;
            Psi_v[16 * 8 + j] = t41; /* Psi_v(1,5) */
            Psi_v[4 * 8 + j] = -t41; /* Psi_v(0,4) */
            Psi_v[5 * 8 + j] = Psi_v[15 * 8 + j] = -(2.0 * n2[j] * t4); /* Psi_v(0,5) Psi_v(1,4) */
            const real t42 = 2.0 * t7 * t12[j];
            Psi_v[6 * 8 + j] = t42; /* Psi_v(0,6) */
            Psi_v[7 * 8 + j] = Psi_v[17 * 8 + j] = 2.0 * t4 * t12[j]; /* Psi_v(0,7) Psi_v(1,6) */
            const real t43 = 2.0 * t7;
            Psi_v[8 * 8 + j] = t43; /* Psi_v(0,8) */
            Psi_v[9 * 8 + j] = Psi_v[19 * 8 + j] = 2.0 * t4; /* Psi_v(0,9) Psi_v(1,8) */
            Psi_v[10 * 8 + j] = 2.0 * (t4 * d_x[j] - sin_r[j] * t18[j] - cos_r[j] * t44[j]); /* Psi_v(0,10) */
            Psi_v[18 * 8 + j] = -t42; /* Psi_v(1,7) */
            Psi_v[20 * 8 + j] = -t43; /* Psi_v(1,9) */
            Psi_v[21 * 8 + j] = cos_r[j] * t37[j] - sin_r[j] * t35[j] - t7 * d_x[j] - t4 * d_y[j]; /* Psi_v(1,10) */
        }
    }
}

/* stiffness: 60 operations.
 * in:  x (11), sigma (1), tau (1), p (6)
 * out: K (11,11), 21 of 121 entries */
FLEXEL_CLONES
static void planar_cable_line_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict K = out[0] + b * (21 * 8);
        real n0[8], t3[8], cos_r[8], sin_r[8], n1[8], n2[8], t9[8], d_y[8], d_x[8];
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
            n1[j] = l0 * t1 * xi;
            const real t8 = xi * xi;
            n2[j] = t8 * (3.0 - t2);
            t9[j] = l0 * t0 * t8;
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            d_y[j] = q_y * n2[j] + dp_y * n1[j] + p_y * n0[j] - c_y - dq_y * t9[j];
            const real p_x = x[0 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            d_x[j] = q_x * n2[j] + dp_x * n1[j] + p_x * n0[j] - c_x - dq_x * t9[j];
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t3[j]);
            sin_r[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_gap = sigma[0 * 8 + j];
            const real tau_tangential = tau[0 * 8 + j];
            const real t4 = sin_r[j] * tau_tangential;
            const real t5 = cos_r[j] * sigma_gap + t4;
            K[8 * 8 + j] = K[18 * 8 + j] = t5; /* K(8,10) K(10,8) */
            K[0 * 8 + j] = K[10 * 8 + j] = -(n0[j] * t5); /* K(0,10) K(10,0) */
            const real t6 = cos_r[j] * tau_tangential;
            const real t7 = sin_r[j] * sigma_gap - t6;
            K[9 * 8 + j] = K[19 * 8 + j] = t7; /* K(9,10) K(10,9) */
            K[1 * 8 + j] = K[11 * 8 + j] = -(n0[j] * t7); /* K(1,10) K(10,1) */
            K[2 * 8 + j] = K[12 * 8 + j] = -(n1[j] * t5); /* K(2,10) K(10,2) */
            K[3 * 8 + j] = K[13 * 8 + j] = -(n1[j] * t7); /* K(3,10) K(10,3) */
            K[4 * 8 + j] = K[14 * 8 + j] = -(n2[j] * t5); /* K(4,10) K(10,4) */
            K[5 * 8 + j] = K[15 * 8 + j] = -(n2[j] * t7); /* K(5,10) K(10,5) */
            K[6 * 8 + j] = K[16 * 8 + j] = t9[j] * t5; /* K(6,10) K(10,6) */
            K[7 * 8 + j] = K[17 * 8 + j] = t9[j] * t7; /* K(7,10) K(10,7) */
            const real t10 = sigma_gap * (cos_r[j] * d_y[j] - sin_r[j] * d_x[j]) + d_x[j] * t6;
            K[20 * 8 + j] = -(d_y[j] * t4 + t10); /* K(10,10) */
        }
    }
}

const flexel_element flexel_planar_cable_line = {
    .name = "planar_cable_line",
    .digest = "34481bf531d08858",
    .n = 11,
    .m = 1,
    .k = 1,
    .np = 6,
    .position = planar_cable_line_position,
    .acceleration = planar_cable_line_acceleration,
    .rates = planar_cable_line_rates,
    .kinematics = planar_cable_line_kinematics,
    .stiffness = planar_cable_line_stiffness,
};
