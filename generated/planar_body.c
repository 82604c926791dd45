/* planar_body: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * b = R(angle) c,  vc = xdot + angledot (-b_y, b_x), velocity of the mass centre
 * T = mass vc.vc/2 + J angledot^2/2
 * U = -mass gravity.(x + b)
 * centre: x + b
 * origin: x, axes: columns of R(angle) in rows: the frame that carries what a picture shows
 *
 * Source: textbook mechanics
 *
 * x (3): p_x, p_y, r_angle
 * e (0): none
 * s (0): none
 * p (6):
 *   mass (1) [kg]: mass
 *   c (2) [m]: offset of the mass centre from p in body axes
 *   J (1) [kg m^2]: moment of inertia about the mass centre
 *   gravity (2) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* inertia: 72 operations.
 * in:  x (3), v (3), p (6)
 * out: M (3,3), 7 of 9 entries, h (3), f (3), U (1) */
FLEXEL_CLONES
static void planar_body_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict M = out[0] + b * (7 * 8);
        real *restrict h = out[1] + b * (3 * 8);
        real *restrict f = out[2] + b * (3 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real sin_r[8], cos_r[8], t5[8], t16[8], t17[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real mass = p[0 * 8 + j];
            M[0 * 8 + j] = M[2 * 8 + j] = mass; /* M(0,0) M(1,1) */
            const real r_vangle = v[2 * 8 + j];
            t5[j] = r_vangle * mass;
            const real gravity_x = p[4 * 8 + j];
            const real t14 = mass * gravity_x;
            f[0 * 8 + j] = t14;
            const real gravity_y = p[5 * 8 + j];
            const real t15 = mass * gravity_y;
            f[1 * 8 + j] = t15;
            const real c_y = p[2 * 8 + j];
            const real c_x = p[1 * 8 + j];
            t16[j] = c_y * t14 - c_x * t15;
            t17[j] = c_y * t15 + c_x * t14;
        }
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            sin_r[j] = real_sin(r_angle);
            cos_r[j] = real_cos(r_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real c_x = p[1 * 8 + j];
            const real c_y = p[2 * 8 + j];
            const real b_y = c_x * sin_r[j] + c_y * cos_r[j];
            const real mass = p[0 * 8 + j];
            const real t0 = mass * b_y;
            M[1 * 8 + j] = M[4 * 8 + j] = -t0; /* M(0,2) M(2,0) */
            const real b_x = c_x * cos_r[j] - c_y * sin_r[j];
            const real t1 = mass * b_x;
            M[3 * 8 + j] = M[5 * 8 + j] = t1; /* M(1,2) M(2,1) */
            const real J_ = p[3 * 8 + j];
            M[6 * 8 + j] = J_ + b_x * t1 + b_y * t0; /* M(2,2) */
            const real r_vangle = v[2 * 8 + j];
            const real t2 = r_vangle * cos_r[j];
            const real t3 = r_vangle * sin_r[j];
            const real t4 = c_x * t2 - c_y * t3;
            const real t6 = t4 * t5[j];
            h[0 * 8 + j] = -t6;
            const real t7 = c_x * t3 + c_y * t2;
            const real t8 = t7 * t5[j];
            h[1 * 8 + j] = -t8;
            const real p_vx = v[0 * 8 + j];
            const real vc_x = p_vx - r_vangle * b_y;
            const real t9 = mass * vc_x;
            const real t10 = r_vangle * t9;
            const real p_vy = v[1 * 8 + j];
            const real vc_y = p_vy + r_vangle * b_x;
            const real t11 = mass * vc_y;
            const real t12 = r_vangle * t11;
            const real t13 = cos_r[j] * (c_x * t10 + c_y * t12) + sin_r[j] * (c_x * t12 - c_y * t10);
            h[2 * 8 + j] = t13 + b_y * t6 - t11 * t7 - b_x * t8 - t9 * t4;
            f[2 * 8 + j] = -(cos_r[j] * t16[j] + sin_r[j] * t17[j]);
            const real p_x = x[0 * 8 + j];
            const real gravity_x = p[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real gravity_y = p[5 * 8 + j];
            const real t18 = mass * (gravity_x * (p_x + b_x) + gravity_y * (p_y + b_y));
            U[0 * 8 + j] = -t18;
        }
    }
}

/* tangent: 90 operations.
 * in:  x (3), v (3), a (3), p (6)
 * out: R_x (3,3), 3 of 9 entries, R_v (3,3), 5 of 9 entries */
FLEXEL_CLONES
static void planar_body_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict a = in[2] + b * (3 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict R_x = out[0] + b * (3 * 8);
        real *restrict R_v = out[1] + b * (5 * 8);
        real cos_r[8], sin_r[8], t15[8], t17[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real mass = p[0 * 8 + j];
            const real gravity_x = p[4 * 8 + j];
            t15[j] = mass * gravity_x;
            const real gravity_y = p[5 * 8 + j];
            t17[j] = mass * gravity_y;
        }
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            cos_r[j] = real_cos(r_angle);
            sin_r[j] = real_sin(r_angle);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real c_x = p[1 * 8 + j];
            const real c_y = p[2 * 8 + j];
            const real b_x = c_x * cos_r[j] - c_y * sin_r[j];
            const real r_aangle = a[2 * 8 + j];
            const real r_vangle = v[2 * 8 + j];
            const real t0 = r_vangle * sin_r[j];
            const real t1 = r_vangle * cos_r[j];
            const real t2 = c_x * t0 + c_y * t1;
            const real t3 = b_x * r_aangle - r_vangle * t2;
            const real mass = p[0 * 8 + j];
            const real t4 = mass * t3;
            R_x[0 * 8 + j] = -t4; /* R_x(0,2) */
            const real t5 = c_x * t1 - c_y * t0;
            const real b_y = c_x * sin_r[j] + c_y * cos_r[j];
            const real t6 = r_vangle * t5 + b_y * r_aangle;
            const real t7 = mass * t6;
            R_x[1 * 8 + j] = -t7; /* R_x(1,2) */
            const real t8 = r_vangle * b_x;
            const real t9 = mass * t8;
            const real p_vy = v[1 * 8 + j];
            const real vc_y = p_vy + t8;
            const real t10 = mass * vc_y;
            const real t11 = r_vangle * b_y;
            const real p_vx = v[0 * 8 + j];
            const real vc_x = p_vx - t11;
            const real t12 = mass * vc_x;
            const real t13 = mass * t11;
            const real t14 = r_vangle * t10;
            const real t16 = r_vangle * t9;
            const real t18 = r_vangle * t12;
            const real t19 = r_vangle * t13;
            const real t20 = cos_r[j] * (c_x * (t14 + t15[j] - t16) + c_y * (t17[j] - t18 - t19));
            const real t21 = sin_r[j] * (c_x * (t17[j] - t19 - t18) + c_y * (t16 - t15[j] - t14));
            const real t22 = t20 + t21 + t2 * (t12 + t13) + b_y * t4 + t5 * (t9 - t10);
            const real p_ay = a[1 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            R_x[2 * 8 + j] = t22 - mass * (b_y * (p_ay + t3) + b_x * (p_ax - t6)) - b_x * t7; /* R_x(2,2) */
            const real t23 = t8 + t5;
            R_v[0 * 8 + j] = -(mass * t23); /* R_v(0,2) */
            const real t24 = t11 + t2;
            R_v[1 * 8 + j] = -(mass * t24); /* R_v(1,2) */
            const real t25 = t8 - t5;
            R_v[2 * 8 + j] = mass * t25; /* R_v(2,0) */
            const real t26 = t11 - t2;
            R_v[3 * 8 + j] = mass * t26; /* R_v(2,1) */
            R_v[4 * 8 + j] = mass * (b_y * (t23 - t25) + b_x * (t26 - t24)); /* R_v(2,2) */
        }
    }
}

/* outputs: 11 operations.
 * in:  x (3), sigma (0), tau (0), p (6)
 * out: centre (2), origin (2), axes (2,2) */
FLEXEL_CLONES
static void planar_body_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict centre = out[0] + b * (2 * 8);
        real *restrict origin = out[1] + b * (2 * 8);
        real *restrict axes = out[2] + b * (4 * 8);
        real cos_r[8], sin_r[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_x = x[0 * 8 + j];
            origin[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            origin[1 * 8 + j] = p_y;
        }
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[2 * 8 + j];
            cos_r[j] = real_cos(r_angle);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r[j]; /* axes(0,0) axes(1,1) */
            sin_r[j] = real_sin(r_angle);
            axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real c_x = p[1 * 8 + j];
            const real c_y = p[2 * 8 + j];
            const real b_x = c_x * cos_r[j] - c_y * sin_r[j];
            const real p_x = x[0 * 8 + j];
            centre[0 * 8 + j] = p_x + b_x;
            const real b_y = c_x * sin_r[j] + c_y * cos_r[j];
            const real p_y = x[1 * 8 + j];
            centre[1 * 8 + j] = p_y + b_y;
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
        }
    }
}

const flexel_element flexel_planar_body = {
    .name = "planar_body",
    .digest = "4ae58659751f332a",
    .n = 3,
    .m = 0,
    .k = 0,
    .np = 6,
    .inertia = planar_body_inertia,
    .tangent = planar_body_tangent,
    .outputs = planar_body_outputs,
};
