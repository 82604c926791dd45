/* planar_point_line: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x: place of p
 * ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * gap = ey.(x - xc) - offset_y - sphere_radius,  tangential = ex.w
 * place: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows
 *
 * Source: planar counterpart of contact in space
 *
 * x (5): p_x, p_y, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (4):
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   sphere_radius (1) [m]: radius of the sphere; 0: a point */
#include "kernels.h"

/* position: 17 operations.
 * in:  x (5), p (4)
 * out: e (1), De (1,5), V (1,5) */
FLEXEL_CLONES
static void planar_point_line_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (5 * 8);
        real *restrict V = out[2] + b * (5 * 8);
        real d_y[8], t0[8], cos_r[8], d_x[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            De[1 * 8 + j] = V[0 * 8 + j] = cos_r[j]; /* De(0,1) V(0,0) */
            sin_r[j] = real_sin(t0[j]);
            De[2 * 8 + j] = V[1 * 8 + j] = sin_r[j]; /* De(0,2) V(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t1 = d_y[j] * cos_r[j];
            const real offset_y = p[2 * 8 + j];
            const real sphere_radius = p[3 * 8 + j];
            const real t2 = d_x[j] * sin_r[j];
            e[0 * 8 + j] = t1 - offset_y - sphere_radius - t2;
            De[0 * 8 + j] = V[3 * 8 + j] = -sin_r[j]; /* De(0,0) V(0,3) */
            De[3 * 8 + j] = V[2 * 8 + j] = -cos_r[j]; /* De(0,3) V(0,2) */
            De[4 * 8 + j] = -(d_y[j] * sin_r[j] + d_x[j] * cos_r[j]); /* De(0,4) */
            V[4 * 8 + j] = t1 - t2; /* V(0,4) */
        }
    }
}

/* acceleration: 32 operations.
 * in:  x (5), v (5), p (4)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_point_line_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict v = in[1] + b * (5 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real d_x[8], t0[8], sin_r[8], d_y[8], cos_r[8], t3[8], t5[8], sliding_y[8], sliding_x[8];
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
            t3[j] = p_vy - c_vy;
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[2 * 8 + j];
            t5[j] = p_vx - c_vx;
            const real r_vangle = v[4 * 8 + j];
            sliding_y[j] = t3[j] - r_vangle * d_x[j];
            sliding_x[j] = p_vx + r_vangle * d_y[j] - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[4 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real t2 = r_vangle * cos_r[j];
            const real t4 = t3[j] * t1;
            const real t6 = t5[j] * t2;
            g[0 * 8 + j] = r_vangle * (d_x[j] * t1 - d_y[j] * t2) - t4 - t4 - t6 - t6;
            const real t7 = sliding_y[j] * t2 + r_vangle * (t3[j] * cos_r[j] - sin_r[j] * t5[j]);
            gs[0 * 8 + j] = t7 - sliding_x[j] * t1;
        }
    }
}

/* rates: 23 operations.
 * in:  x (5), v (5), p (4)
 * out: Phi_x (2,5) */
FLEXEL_CLONES
static void planar_point_line_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict v = in[1] + b * (5 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (10 * 8);
        real t0[8], cos_r[8], sin_r[8], d_x[8], t3[8], sliding_x[8], sliding_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[3 * 8 + j];
            t3[j] = p_vy - c_vy;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            const real d_y = p_y - c_y;
            const real r_vangle = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[2 * 8 + j];
            sliding_x[j] = p_vx + r_vangle * d_y - c_vx;
            sliding_y[j] = t3[j] - r_vangle * d_x[j];
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[4 * 8 + j];
            const real t1 = r_vangle * cos_r[j];
            Phi_x[2 * 8 + j] = Phi_x[6 * 8 + j] = t1; /* Phi_x(0,2) Phi_x(1,1) */
            Phi_x[0 * 8 + j] = Phi_x[8 * 8 + j] = -t1; /* Phi_x(0,0) Phi_x(1,3) */
            const real t2 = r_vangle * sin_r[j];
            Phi_x[3 * 8 + j] = Phi_x[7 * 8 + j] = t2; /* Phi_x(0,3) Phi_x(1,2) */
            Phi_x[1 * 8 + j] = Phi_x[5 * 8 + j] = -t2; /* Phi_x(0,1) Phi_x(1,0) */
            Phi_x[4 * 8 + j] = d_x[j] * t2 - t3[j] * sin_r[j] - sliding_x[j] * cos_r[j]; /* Phi_x(0,4) */
            Phi_x[9 * 8 + j] = sliding_y[j] * cos_r[j] - sliding_x[j] * sin_r[j]; /* Phi_x(1,4) */
        }
    }
}

/* kinematics: 68 operations.
 * in:  x (5), v (5), a (5), p (4)
 * out: Psi_x (2,5), Psi_v (2,5) */
FLEXEL_CLONES
static void planar_point_line_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict v = in[1] + b * (5 * 8);
        const real *restrict a = in[2] + b * (5 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (10 * 8);
        real *restrict Psi_v = out[1] + b * (10 * 8);
        real t0[8], sin_r[8], cos_r[8], d_x[8], t6[8], d_y[8], t8[8], t12[8], t13[8], t14[8], t15[8], t16[8], t19[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real r_vangle = v[4 * 8 + j];
            const real t5 = r_vangle * d_x[j];
            const real p_vy = v[1 * 8 + j];
            const real c_vy = v[3 * 8 + j];
            t6[j] = p_vy - c_vy;
            const real c_ax = a[2 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
            const real r_aangle = a[4 * 8 + j];
            const real t7 = d_y[j] * r_aangle;
            t8[j] = c_ax + r_vangle * (t5 - 2.0 * t6[j]) - p_ax - t7;
            const real p_ay = a[1 * 8 + j];
            const real c_ay = a[3 * 8 + j];
            const real t9 = p_ay - c_ay - d_x[j] * r_aangle;
            const real t10 = r_vangle * d_y[j];
            const real p_vx = v[0 * 8 + j];
            const real c_vx = v[2 * 8 + j];
            const real t11 = p_vx - c_vx;
            t12[j] = t9 - r_vangle * (t10 + 2.0 * t11);
            const real sliding_x = p_vx + t10 - c_vx;
            t13[j] = sliding_x + t11;
            t14[j] = t9 - r_vangle * t13[j];
            const real sliding_y = t6[j] - t5;
            t15[j] = t6[j] + sliding_y;
            t16[j] = p_ax + r_vangle * t15[j] + t7 - c_ax;
            t19[j] = t10 + t11;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[4 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real r_aangle = a[4 * 8 + j];
            const real t2 = r_vangle * t1 - cos_r[j] * r_aangle;
            Psi_x[0 * 8 + j] = Psi_x[8 * 8 + j] = t2; /* Psi_x(0,0) Psi_x(1,3) */
            const real t3 = r_vangle * cos_r[j];
            const real t4 = r_vangle * t3 + sin_r[j] * r_aangle;
            Psi_x[3 * 8 + j] = Psi_x[7 * 8 + j] = t4; /* Psi_x(0,3) Psi_x(1,2) */
            Psi_x[1 * 8 + j] = Psi_x[5 * 8 + j] = -t4; /* Psi_x(0,1) Psi_x(1,0) */
            Psi_x[2 * 8 + j] = Psi_x[6 * 8 + j] = -t2; /* Psi_x(0,2) Psi_x(1,1) */
            Psi_x[4 * 8 + j] = cos_r[j] * t8[j] - sin_r[j] * t12[j]; /* Psi_x(0,4) */
            Psi_x[9 * 8 + j] = cos_r[j] * t14[j] - sin_r[j] * t16[j]; /* Psi_x(1,4) */
            const real t17 = 2.0 * t3;
            Psi_v[2 * 8 + j] = Psi_v[6 * 8 + j] = t17; /* Psi_v(0,2) Psi_v(1,1) */
            Psi_v[0 * 8 + j] = Psi_v[8 * 8 + j] = -t17; /* Psi_v(0,0) Psi_v(1,3) */
            const real t18 = 2.0 * t1;
            Psi_v[3 * 8 + j] = Psi_v[7 * 8 + j] = t18; /* Psi_v(0,3) Psi_v(1,2) */
            Psi_v[1 * 8 + j] = Psi_v[5 * 8 + j] = -t18; /* Psi_v(0,1) Psi_v(1,0) */
            Psi_v[4 * 8 + j] = 2.0 * (d_x[j] * t1 - t6[j] * sin_r[j] - cos_r[j] * t19[j]); /* Psi_v(0,4) */
            Psi_v[9 * 8 + j] = cos_r[j] * t15[j] - sin_r[j] * t13[j] - d_x[j] * t3 - d_y[j] * t1; /* Psi_v(1,4) */
        }
    }
}

/* stiffness: 17 operations.
 * in:  x (5), sigma (1), tau (1), p (4)
 * out: K (5,5), 9 of 25 entries */
FLEXEL_CLONES
static void planar_point_line_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict K = out[0] + b * (9 * 8);
        real t0[8], cos_r[8], sin_r[8], d_x[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real p_x = x[0 * 8 + j];
            const real c_x = x[2 * 8 + j];
            d_x[j] = p_x - c_x;
            const real p_y = x[1 * 8 + j];
            const real c_y = x[3 * 8 + j];
            d_y[j] = p_y - c_y;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_gap = sigma[0 * 8 + j];
            const real tau_tangential = tau[0 * 8 + j];
            const real p_fy = cos_r[j] * sigma_gap + sin_r[j] * tau_tangential;
            K[2 * 8 + j] = K[6 * 8 + j] = p_fy; /* K(2,4) K(4,2) */
            K[0 * 8 + j] = K[4 * 8 + j] = -p_fy; /* K(0,4) K(4,0) */
            const real p_fx = cos_r[j] * tau_tangential - sin_r[j] * sigma_gap;
            K[1 * 8 + j] = K[5 * 8 + j] = p_fx; /* K(1,4) K(4,1) */
            K[3 * 8 + j] = K[7 * 8 + j] = -p_fx; /* K(3,4) K(4,3) */
            K[8 * 8 + j] = -(d_x[j] * p_fx + d_y[j] * p_fy); /* K(4,4) */
        }
    }
}

/* outputs: 20 operations.
 * in:  x (5), sigma (1), tau (1), p (4)
 * out: place (2), force (2), origin (2), axes (2,2) */
FLEXEL_CLONES
static void planar_point_line_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (5 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict place = out[0] + b * (2 * 8);
        real *restrict force = out[1] + b * (2 * 8);
        real *restrict origin = out[2] + b * (2 * 8);
        real *restrict axes = out[3] + b * (4 * 8);
        real t0[8], cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            place[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            place[1 * 8 + j] = p_y;
            const real r_angle = x[4 * 8 + j];
            const real alpha0 = p[0 * 8 + j];
            t0[j] = r_angle + alpha0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r[j]; /* axes(0,0) axes(1,1) */
            sin_r[j] = real_sin(t0[j]);
            axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real tau_tangential = tau[0 * 8 + j];
            const real sigma_gap = sigma[0 * 8 + j];
            const real p_fx = cos_r[j] * tau_tangential - sin_r[j] * sigma_gap;
            force[0 * 8 + j] = -p_fx;
            const real p_fy = cos_r[j] * sigma_gap + sin_r[j] * tau_tangential;
            force[1 * 8 + j] = -p_fy;
            const real offset_x = p[1 * 8 + j];
            const real c_x = x[2 * 8 + j];
            const real offset_y = p[2 * 8 + j];
            origin[0 * 8 + j] = c_x + offset_x * cos_r[j] - offset_y * sin_r[j];
            const real c_y = x[3 * 8 + j];
            origin[1 * 8 + j] = c_y + offset_x * sin_r[j] + offset_y * cos_r[j];
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
        }
    }
}

const flexel_element flexel_planar_point_line = {
    .name = "planar_point_line",
    .digest = "13e92c3358685f5a",
    .n = 5,
    .m = 1,
    .k = 1,
    .np = 4,
    .position = planar_point_line_position,
    .acceleration = planar_point_line_acceleration,
    .rates = planar_point_line_rates,
    .kinematics = planar_point_line_kinematics,
    .stiffness = planar_point_line_stiffness,
    .outputs = planar_point_line_outputs,
};
