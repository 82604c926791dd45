/* planar_truss: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * elongation = |xq - xp| - l0
 * T = rhoA l0/6 (vp.vp + vp.vq + vq.vq), uniform bar
 * U = -rhoA l0 gravity.(xp + xq)/2
 *
 * Source: van der Werff and Jonker 1984, NATO ASI F9, p. 381
 *
 * x (4): p_x, p_y, q_x, q_y
 * e (1): elongation [m]
 * s (0): none
 * p (4):
 *   l0 (1) [m]: undeformed length
 *   rhoA (1) [kg/m]: mass per length
 *   gravity (2) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* position: 12 operations.
 * in:  x (4), p (4)
 * out: e (1), De (1,4), V (0,4) */
FLEXEL_CLONES
static void planar_truss_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y);
            const real l0 = p[0 * 8 + j];
            e[0 * 8 + j] = l - l0;
            const real t0 = 1.0 / l;
            const real t1 = d_x * t0;
            De[2 * 8 + j] = t1; /* De(0,2) */
            De[0 * 8 + j] = -t1; /* De(0,0) */
            const real t2 = d_y * t0;
            De[3 * 8 + j] = t2; /* De(0,3) */
            De[1 * 8 + j] = -t2; /* De(0,1) */
        }
    }
}

/* acceleration: 20 operations.
 * in:  x (4), v (4), p (4)
 * out: g (1), gs (0) */
FLEXEL_CLONES
static void planar_truss_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict v = in[1] + b * (4 * 8);
        real *restrict g = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y);
            const real t0 = 1.0 / l;
            const real q_vx = v[2 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t1 = q_vx - p_vx;
            const real q_vy = v[3 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t2 = q_vy - p_vy;
            const real t3 = d_x * t1 + d_y * t2;
            g[0 * 8 + j] = t0 * (t1 * t1 + t2 * t2 - t0 * t0 * t3 * t3);
        }
    }
}

/* rates: 23 operations.
 * in:  x (4), v (4), p (4)
 * out: Phi_x (1,4) */
FLEXEL_CLONES
static void planar_truss_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict v = in[1] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y);
            const real t0 = 1.0 / l;
            const real q_vx = v[2 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t1 = q_vx - p_vx;
            const real q_vy = v[3 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t2 = q_vy - p_vy;
            const real t3 = t0 * (d_x * t1 + d_y * t2) * t0 * t0;
            const real t4 = t0 * t1 - d_x * t3;
            Phi_x[2 * 8 + j] = t4; /* Phi_x(0,2) */
            Phi_x[0 * 8 + j] = -t4; /* Phi_x(0,0) */
            const real t5 = t0 * t2 - d_y * t3;
            Phi_x[3 * 8 + j] = t5; /* Phi_x(0,3) */
            Phi_x[1 * 8 + j] = -t5; /* Phi_x(0,1) */
        }
    }
}

/* kinematics: 61 operations.
 * in:  x (4), v (4), a (4), p (4)
 * out: Psi_x (1,4), Psi_v (1,4) */
FLEXEL_CLONES
static void planar_truss_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict v = in[1] + b * (4 * 8);
        const real *restrict a = in[2] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (4 * 8);
        real *restrict Psi_v = out[1] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real q_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(d_x * d_x + d_y * d_y);
            const real t0 = 1.0 / l;
            const real q_ax = a[2 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t1 = q_ax - p_ax;
            const real t2 = t0 * t0;
            const real t3 = t0 * t2;
            const real q_vx = v[2 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t4 = q_vx - p_vx;
            const real q_vy = v[3 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t5 = q_vy - p_vy;
            const real q_ay = a[3 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t6 = q_ay - p_ay;
            const real t7 = d_x * t4 + d_y * t5;
            const real t8 = t0 * t7;
            const real t9 = 2.0 * (t4 * t4 + t5 * t5 + (d_x * t1 + d_y * t6)) - t7 * (2.0 * t2 * t7 + 4.0 * t0 * t8);
            const real t10 = t7 * t3;
            const real t11 = t10 + t2 * t8;
            const real t12 = t0 * t1 - 0.5 * d_x * t3 * t9 - t4 * t11;
            Psi_x[2 * 8 + j] = t12; /* Psi_x(0,2) */
            Psi_x[0 * 8 + j] = -t12; /* Psi_x(0,0) */
            const real t13 = t0 * t6 - 0.5 * d_y * t3 * t9 - t5 * t11;
            Psi_x[3 * 8 + j] = t13; /* Psi_x(0,3) */
            Psi_x[1 * 8 + j] = -t13; /* Psi_x(0,1) */
            const real t14 = 2.0 * (t0 * t4 - d_x * t10);
            Psi_v[2 * 8 + j] = t14; /* Psi_v(0,2) */
            Psi_v[0 * 8 + j] = -t14; /* Psi_v(0,0) */
            const real t15 = 2.0 * (t0 * t5 - d_y * t10);
            Psi_v[3 * 8 + j] = t15; /* Psi_v(0,3) */
            Psi_v[1 * 8 + j] = -t15; /* Psi_v(0,1) */
        }
    }
}

/* stiffness: 19 operations.
 * in:  x (4), sigma (1), tau (0), p (4)
 * out: K (4,4) */
FLEXEL_CLONES
static void planar_truss_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        real *restrict K = out[0] + b * (16 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[2 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t0 = d_x * d_x;
            const real q_y = x[3 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real l = real_sqrt(t0 + d_y * d_y);
            const real t1 = 1.0 / l;
            const real sigma_elongation = sigma[0 * 8 + j];
            const real t2 = sigma_elongation * t1;
            const real t3 = t1 * t2 * t1;
            const real t4 = t2 - t0 * t3;
            K[0 * 8 + j] = K[10 * 8 + j] = t4; /* K(0,0) K(2,2) */
            const real t5 = d_y * t3;
            const real t6 = d_x * t5;
            K[3 * 8 + j] = K[6 * 8 + j] = K[9 * 8 + j] = K[12 * 8 + j] = t6; /* K(0,3) K(1,2) K(2,1) K(3,0) */
            K[1 * 8 + j] = K[4 * 8 + j] = K[11 * 8 + j] = K[14 * 8 + j] = -t6; /* K(0,1) K(1,0) K(2,3) K(3,2) */
            K[2 * 8 + j] = K[8 * 8 + j] = -t4; /* K(0,2) K(2,0) */
            const real t7 = t2 - d_y * t5;
            K[5 * 8 + j] = K[15 * 8 + j] = t7; /* K(1,1) K(3,3) */
            K[7 * 8 + j] = K[13 * 8 + j] = -t7; /* K(1,3) K(3,1) */
        }
    }
}

/* inertia: 15 operations.
 * in:  x (4), v (4), p (4)
 * out: M (4,4), 8 of 16 entries, h (4), 0 of 4 entries, f (4), U (1) */
FLEXEL_CLONES
static void planar_truss_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict M = out[0] + b * (8 * 8);
        real *restrict f = out[2] + b * (4 * 8);
        real *restrict U = out[3] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real rhoA = p[1 * 8 + j];
            const real t0 = l0 * rhoA;
            M[0 * 8 + j] = M[2 * 8 + j] = M[5 * 8 + j] = M[7 * 8 + j] = 0.3333333333333333 * t0;
                /* M(0,0) M(1,1) M(2,2) M(3,3) */
            M[1 * 8 + j] = M[3 * 8 + j] = M[4 * 8 + j] = M[6 * 8 + j] = 0.16666666666666666 * t0;
                /* M(0,2) M(1,3) M(2,0) M(3,1) */
            const real gravity_x = p[2 * 8 + j];
            f[0 * 8 + j] = f[2 * 8 + j] = 0.5 * gravity_x * t0;
            const real gravity_y = p[3 * 8 + j];
            f[1 * 8 + j] = f[3 * 8 + j] = 0.5 * gravity_y * t0;
            const real p_x = x[0 * 8 + j];
            const real q_x = x[2 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[3 * 8 + j];
            const real t1 = 0.5 * t0 * (gravity_x * (p_x + q_x) + gravity_y * (p_y + q_y));
            U[0 * 8 + j] = -t1;
        }
    }
}

/* tangent: 0 operations.
 * in:  x (4), v (4), a (4), p (4)
 * out: R_x (4,4), 0 of 16 entries, R_v (4,4), 0 of 16 entries */
FLEXEL_CLONES
static void planar_truss_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_element flexel_planar_truss = {
    .name = "planar_truss",
    .digest = "fc0670bb60ae7523",
    .n = 4,
    .m = 1,
    .k = 0,
    .np = 4,
    .position = planar_truss_position,
    .acceleration = planar_truss_acceleration,
    .rates = planar_truss_rates,
    .kinematics = planar_truss_kinematics,
    .stiffness = planar_truss_stiffness,
    .inertia = planar_truss_inertia,
    .tangent = planar_truss_tangent,
};
