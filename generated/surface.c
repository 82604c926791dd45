/* surface: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * height = quadratic.(x^2, y^2, z^2, x y, x z, y z) + linear.(x, y, z) + constant
 *
 * Source: SPACAR95 manual (Schwab and Meijaard 2000), SURFACE
 *
 * x (3): p_x, p_y, p_z
 * e (1): height [m]
 * s (0): none
 * p (10):
 *   quadratic (6) [1/m]: coefficients of x^2, y^2, z^2, x y, x z, y z
 *   linear (3) [1]: coefficients of x, y, z
 *   constant (1) [m]: constant term */
#include "kernels.h"

/* position: 33 operations.
 * in:  x (3), p (10)
 * out: e (1), De (1,3), V (0,3) */
FLEXEL_CLONES
static void surface_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (3 * 8);
        const real *restrict p = in[1] + b * (10 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_z = x[2 * 8 + j];
            const real quadratic_zz = p[2 * 8 + j];
            const real t0 = p_z * quadratic_zz;
            const real linear_z = p[8 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real quadratic_xx = p[0 * 8 + j];
            const real t1 = p_x * quadratic_xx;
            const real p_y = x[1 * 8 + j];
            const real quadratic_xy = p[3 * 8 + j];
            const real t2 = p_y * quadratic_xy;
            const real quadratic_xz = p[4 * 8 + j];
            const real t3 = p_z * quadratic_xz;
            const real linear_x = p[6 * 8 + j];
            const real quadratic_yy = p[1 * 8 + j];
            const real t4 = p_y * quadratic_yy;
            const real quadratic_yz = p[5 * 8 + j];
            const real t5 = p_z * quadratic_yz;
            const real linear_y = p[7 * 8 + j];
            const real t6 = p_x * (t2 + t3 + t1 + linear_x) + p_y * (t4 + t5 + linear_y);
            const real constant = p[9 * 8 + j];
            e[0 * 8 + j] = p_z * (linear_z + t0) + t6 + constant;
            De[0 * 8 + j] = linear_x + 2.0 * t1 + t2 + t3; /* De(0,0) */
            De[1 * 8 + j] = linear_y + 2.0 * t4 + p_x * quadratic_xy + t5; /* De(0,1) */
            De[2 * 8 + j] = linear_z + 2.0 * t0 + p_x * quadratic_xz + p_y * quadratic_yz; /* De(0,2) */
        }
    }
}

/* acceleration: 15 operations.
 * in:  x (3), v (3), p (10)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void surface_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict p = in[2] + b * (10 * 8);
        real *restrict g = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_vz = v[2 * 8 + j];
            const real quadratic_zz = p[2 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real quadratic_xx = p[0 * 8 + j];
            const real quadratic_xz = p[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real quadratic_xy = p[3 * 8 + j];
            const real t0 = p_vz * quadratic_xz + p_vy * quadratic_xy + p_vx * quadratic_xx;
            const real quadratic_yz = p[5 * 8 + j];
            const real quadratic_yy = p[1 * 8 + j];
            const real t1 = p_vx * t0 + p_vy * (p_vz * quadratic_yz + p_vy * quadratic_yy);
            g[0 * 8 + j] = 2.0 * (p_vz * quadratic_zz * p_vz + t1);
        }
    }
}

/* rates: 18 operations.
 * in:  x (3), v (3), p (10)
 * out: Phi_x (1,3) */
FLEXEL_CLONES
static void surface_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict p = in[2] + b * (10 * 8);
        real *restrict Phi_x = out[0] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_vz = v[2 * 8 + j];
            const real quadratic_xz = p[4 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real quadratic_xy = p[3 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real quadratic_xx = p[0 * 8 + j];
            Phi_x[0 * 8 + j] = p_vz * quadratic_xz + p_vy * quadratic_xy + 2.0 * p_vx * quadratic_xx; /* Phi_x(0,0) */
            const real quadratic_yy = p[1 * 8 + j];
            const real quadratic_yz = p[5 * 8 + j];
            Phi_x[1 * 8 + j] = p_vz * quadratic_yz + p_vx * quadratic_xy + 2.0 * p_vy * quadratic_yy; /* Phi_x(0,1) */
            const real quadratic_zz = p[2 * 8 + j];
            Phi_x[2 * 8 + j] = p_vx * quadratic_xz + p_vy * quadratic_yz + 2.0 * p_vz * quadratic_zz; /* Phi_x(0,2) */
        }
    }
}

/* kinematics: 39 operations.
 * in:  x (3), v (3), a (3), p (10)
 * out: Psi_x (1,3), Psi_v (1,3) */
FLEXEL_CLONES
static void surface_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (3 * 8);
        const real *restrict a = in[2] + b * (3 * 8);
        const real *restrict p = in[3] + b * (10 * 8);
        real *restrict Psi_x = out[0] + b * (3 * 8);
        real *restrict Psi_v = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real quadratic_xx = p[0 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real quadratic_xy = p[3 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real quadratic_xz = p[4 * 8 + j];
            const real p_az = a[2 * 8 + j];
            Psi_x[0 * 8 + j] = quadratic_xy * p_ay + quadratic_xz * p_az + 2.0 * quadratic_xx * p_ax; /* Psi_x(0,0) */
            const real quadratic_yy = p[1 * 8 + j];
            const real quadratic_yz = p[5 * 8 + j];
            Psi_x[1 * 8 + j] = quadratic_xy * p_ax + quadratic_yz * p_az + 2.0 * quadratic_yy * p_ay; /* Psi_x(0,1) */
            const real quadratic_zz = p[2 * 8 + j];
            Psi_x[2 * 8 + j] = quadratic_xz * p_ax + quadratic_yz * p_ay + 2.0 * quadratic_zz * p_az; /* Psi_x(0,2) */
            const real p_vz = v[2 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t0 = p_vz * quadratic_xz + p_vy * quadratic_xy + 2.0 * p_vx * quadratic_xx;
            Psi_v[0 * 8 + j] = 2.0 * t0; /* Psi_v(0,0) */
            const real t1 = p_vz * quadratic_yz + p_vx * quadratic_xy + 2.0 * p_vy * quadratic_yy;
            Psi_v[1 * 8 + j] = 2.0 * t1; /* Psi_v(0,1) */
            const real t2 = p_vx * quadratic_xz + p_vy * quadratic_yz + 2.0 * p_vz * quadratic_zz;
            Psi_v[2 * 8 + j] = 2.0 * t2; /* Psi_v(0,2) */
        }
    }
}

/* stiffness: 9 operations.
 * in:  x (3), sigma (1), tau (0), p (10)
 * out: K (3,3) */
FLEXEL_CLONES
static void surface_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict p = in[3] + b * (10 * 8);
        real *restrict K = out[0] + b * (9 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real quadratic_xx = p[0 * 8 + j];
            const real sigma_height = sigma[0 * 8 + j];
            K[0 * 8 + j] = 2.0 * quadratic_xx * sigma_height; /* K(0,0) */
            const real quadratic_xy = p[3 * 8 + j];
            K[1 * 8 + j] = K[3 * 8 + j] = quadratic_xy * sigma_height; /* K(0,1) K(1,0) */
            const real quadratic_xz = p[4 * 8 + j];
            K[2 * 8 + j] = K[6 * 8 + j] = quadratic_xz * sigma_height; /* K(0,2) K(2,0) */
            const real quadratic_yy = p[1 * 8 + j];
            K[4 * 8 + j] = 2.0 * quadratic_yy * sigma_height; /* K(1,1) */
            const real quadratic_yz = p[5 * 8 + j];
            K[5 * 8 + j] = K[7 * 8 + j] = quadratic_yz * sigma_height; /* K(1,2) K(2,1) */
            const real quadratic_zz = p[2 * 8 + j];
            K[8 * 8 + j] = 2.0 * quadratic_zz * sigma_height; /* K(2,2) */
        }
    }
}

const flexel_element flexel_surface = {
    .name = "surface",
    .digest = "82396fec8a27a987",
    .n = 3,
    .m = 1,
    .k = 0,
    .np = 10,
    .position = surface_position,
    .acceleration = surface_acceleration,
    .rates = surface_rates,
    .kinematics = surface_kinematics,
    .stiffness = surface_stiffness,
};
