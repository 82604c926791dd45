/* planar_body: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * b = R(angle) c,  vc = xdot + angledot (-b_y, b_x), velocity of the mass centre
 * T = mass vc.vc/2 + J angledot^2/2
 * U = -mass gravity.(x + b)
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

/* inertia: 73 operations.
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
        real sin_r[8], cos_r[8], t15[8], t16[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real mass = p[0 * 8 + j];
            M[0 * 8 + j] = M[2 * 8 + j] = mass;
            const real gravity_x = p[4 * 8 + j];
            const real t13 = mass * gravity_x;
            f[0 * 8 + j] = t13;
            const real gravity_y = p[5 * 8 + j];
            const real t14 = mass * gravity_y;
            f[1 * 8 + j] = t14;
            const real c_y = p[2 * 8 + j];
            const real c_x = p[1 * 8 + j];
            t15[j] = c_y * t13 - c_x * t14;
            t16[j] = c_y * t14 + c_x * t13;
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
            M[1 * 8 + j] = M[4 * 8 + j] = -t0;
            const real b_x = c_x * cos_r[j] - c_y * sin_r[j];
            const real t1 = mass * b_x;
            M[3 * 8 + j] = M[5 * 8 + j] = t1;
            const real J_ = p[3 * 8 + j];
            M[6 * 8 + j] = J_ + b_x * t1 + b_y * t0;
            const real r_vangle = v[2 * 8 + j];
            const real t2 = r_vangle * cos_r[j];
            const real t3 = r_vangle * sin_r[j];
            const real t4 = c_x * t2 - c_y * t3;
            const real t5 = r_vangle * t4 * mass;
            h[0 * 8 + j] = -t5;
            const real t6 = c_x * t3 + c_y * t2;
            const real t7 = r_vangle * t6 * mass;
            h[1 * 8 + j] = -t7;
            const real p_vx = v[0 * 8 + j];
            const real vc_x = p_vx - r_vangle * b_y;
            const real t8 = mass * vc_x;
            const real t9 = r_vangle * t8;
            const real p_vy = v[1 * 8 + j];
            const real vc_y = p_vy + r_vangle * b_x;
            const real t10 = mass * vc_y;
            const real t11 = r_vangle * t10;
            const real t12 = cos_r[j] * (c_x * t9 + c_y * t11) + sin_r[j] * (c_x * t11 - c_y * t9);
            h[2 * 8 + j] = t12 - (t10 * t6 + b_x * t7 + (t8 * t4 - b_y * t5));
            f[2 * 8 + j] = -(cos_r[j] * t15[j] + sin_r[j] * t16[j]);
            const real p_x = x[0 * 8 + j];
            const real gravity_x = p[4 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real gravity_y = p[5 * 8 + j];
            const real t17 = mass * (gravity_x * (p_x + b_x) + gravity_y * (p_y + b_y));
            U[0 * 8 + j] = -t17;
        }
    }
}

/* tangent: 114 operations.
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
        real cos_r[8], sin_r[8], t10[8], t11[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real mass = p[0 * 8 + j];
            const real gravity_y = p[5 * 8 + j];
            const real t8 = mass * gravity_y;
            const real c_y = p[2 * 8 + j];
            const real gravity_x = p[4 * 8 + j];
            const real t9 = mass * gravity_x;
            const real c_x = p[1 * 8 + j];
            t10[j] = c_y * t8 + c_x * t9;
            t11[j] = c_y * t9 - c_x * t8;
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
            R_x[0 * 8 + j] = -t4;
            const real t5 = c_x * t1 - c_y * t0;
            const real b_y = c_x * sin_r[j] + c_y * cos_r[j];
            const real t6 = r_vangle * t5 + b_y * r_aangle;
            const real t7 = mass * t6;
            R_x[1 * 8 + j] = -t7;
            const real t12 = r_vangle * b_x;
            const real p_vy = v[1 * 8 + j];
            const real vc_y = p_vy + t12;
            const real t13 = mass * vc_y;
            const real t14 = r_vangle * t13;
            const real t15 = r_vangle * b_y;
            const real p_vx = v[0 * 8 + j];
            const real vc_x = p_vx - t15;
            const real t16 = mass * vc_x;
            const real t17 = r_vangle * t16;
            const real t18 = mass * t12;
            const real t19 = r_vangle * t18;
            const real t20 = mass * t15;
            const real t21 = r_vangle * t20;
            const real t22 = cos_r[j] * (c_x * t14 - c_y * t17) + sin_r[j] * (c_y * t19 - c_x * t21);
            const real t23 = sin_r[j] * (c_x * t17 + c_y * t14) + cos_r[j] * (c_x * t19 + c_y * t21);
            const real p_ay = a[1 * 8 + j];
            const real t24 = t13 * t5 - t2 * t20 + (mass * (p_ay + t3) * b_y + b_x * t7);
            const real p_ax = a[0 * 8 + j];
            const real t25 = mass * (p_ax - t6) * b_x - b_y * t4 - (t5 * t18 + t16 * t2);
            R_x[2 * 8 + j] = cos_r[j] * t10[j] - sin_r[j] * t11[j] + (t22 - t23 - (t24 + t25));
            const real t26 = t12 + t5;
            R_v[0 * 8 + j] = -(mass * t26);
            const real t27 = t15 + t2;
            R_v[1 * 8 + j] = -(mass * t27);
            const real t28 = t12 - t5;
            R_v[2 * 8 + j] = mass * t28;
            const real t29 = t15 - t2;
            R_v[3 * 8 + j] = mass * t29;
            const real t30 = b_x * t16;
            const real t31 = b_y * t13;
            const real t32 = mass * b_y;
            const real t33 = mass * b_x;
            const real t34 = t31 - (t31 + t30) + t30 + t32 * t26 - t33 * t27 + t33 * t29;
            R_v[4 * 8 + j] = t34 - t32 * t28;
        }
    }
}

const flexel_element flexel_planar_body = {
    .name = "planar_body",
    .n = 3,
    .m = 0,
    .k = 0,
    .np = 6,
    .inertia = planar_body_inertia,
    .tangent = planar_body_tangent,
};
