/* body_rotation: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * u = lambda o t
 * (wx, wy, wz) = 2 (conj(u) o udot), angular velocity in the axes of R(u)
 *
 * Source: Schwab and Meijaard 2006, DETC2006-99307
 *
 * x (4): r_l0, r_l1, r_l2, r_l3
 * e (0): none
 * s (3): wx [rad/s], wy [rad/s], wz [rad/s]
 * p (4):
 *   t (4) [1]: unit quaternion from the body frame to the triad */
#include "kernels.h"

/* position: 92 operations.
 * in:  x (4), p (4)
 * out: e (0), De (0,4), V (3,4) */
FLEXEL_CLONES
static void body_rotation_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict V = out[2] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l1 = x[1 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real r_l0 = x[0 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_l3 = x[3 * 8 + j];
            const real t_1 = p[1 * 8 + j];
            const real t0 = r_l1 * t_3 - r_l0 * t_2 - r_l2 * t_0 - r_l3 * t_1;
            const real t1 = t_3 * t0;
            const real t2 = r_l0 * t_0 - r_l1 * t_1 - r_l2 * t_2 - r_l3 * t_3;
            const real t3 = t_1 * t2;
            const real t4 = r_l3 * t_2 - r_l0 * t_1 - r_l1 * t_0 - r_l2 * t_3;
            const real t5 = t_0 * t4;
            const real t6 = r_l2 * t_1 - r_l0 * t_3 - r_l1 * t_2 - r_l3 * t_0;
            const real t7 = t_2 * t6;
            V[0 * 8 + j] = 2.0 * (t3 + t5 + t1 - t7); /* V(0,0) */
            const real t8 = t_3 * t6;
            const real t9 = t_2 * t0;
            const real t10 = t_0 * t2;
            const real t11 = t_1 * t4;
            V[1 * 8 + j] = 2.0 * (t10 - t11 + t9 + t8); /* V(0,1) */
            const real t12 = t_3 * t2;
            const real t13 = t_2 * t4;
            const real t14 = t_1 * t0;
            const real t15 = t_0 * t6;
            V[2 * 8 + j] = 2.0 * (t12 - t13 - t14 - t15); /* V(0,2) */
            const real t16 = t_0 * t0;
            const real t17 = t_2 * t2;
            const real t18 = t_3 * t4;
            const real t19 = t_1 * t6;
            V[3 * 8 + j] = 2.0 * (t16 - (t17 + t18) - t19); /* V(0,3) */
            V[4 * 8 + j] = 2.0 * (t17 + t16 + t19 - t18); /* V(1,0) */
            V[5 * 8 + j] = 2.0 * (t15 - (t12 + t14) - t13); /* V(1,1) */
            V[6 * 8 + j] = 2.0 * (t10 - t9 + t8 + t11); /* V(1,2) */
            V[7 * 8 + j] = 2.0 * (t3 - t1 - t7 - t5); /* V(1,3) */
            V[8 * 8 + j] = 2.0 * (t12 + t13 + t15 - t14); /* V(2,0) */
            V[9 * 8 + j] = 2.0 * (t17 - t18 - t19 - t16); /* V(2,1) */
            V[10 * 8 + j] = 2.0 * (t5 - t3 - t7 - t1); /* V(2,2) */
            V[11 * 8 + j] = 2.0 * (t10 + t11 - t8 + t9); /* V(2,3) */
        }
    }
}

/* acceleration: 58 operations.
 * in:  x (4), v (4), p (4)
 * out: g (0), gs (3) */
FLEXEL_CLONES
static void body_rotation_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict gs = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl0 = v[0 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_vl1 = v[1 * 8 + j];
            const real t_1 = p[1 * 8 + j];
            const real r_vl2 = v[2 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real t0 = r_vl0 * t_0 - r_vl1 * t_1 - r_vl2 * t_2 - r_vl3 * t_3;
            const real t1 = r_vl3 * t_2;
            const real t2 = r_vl0 * t_1;
            const real t3 = r_vl1 * t_0;
            const real t4 = r_vl2 * t_3;
            const real t5 = t1 - t2 - t3 - t4;
            const real t6 = t2 + t4 + t3 - t1;
            const real t7 = r_vl1 * t_3;
            const real t8 = r_vl0 * t_2;
            const real t9 = r_vl2 * t_0;
            const real t10 = r_vl3 * t_1;
            const real t11 = t7 - t8 - t9 - t10;
            const real t12 = r_vl1 * t_2;
            const real t13 = r_vl0 * t_3;
            const real t14 = r_vl3 * t_0;
            const real t15 = r_vl2 * t_1;
            const real t16 = t13 + t14 + t12 - t15;
            const real t17 = t15 - t13 - t12 - t14;
            const real t18 = t8 + t10 + t9 - t7;
            gs[0 * 8 + j] = 2.0 * (t0 * (t5 + t6) + t11 * t16 - t17 * t18);
            gs[1 * 8 + j] = 2.0 * (t0 * (t11 + t18) + t17 * t6 - t5 * t16);
            gs[2 * 8 + j] = 2.0 * (t0 * (t17 + t16) + t5 * t18 - t11 * t6);
        }
    }
}

/* rates: 94 operations.
 * in:  x (4), v (4), p (4)
 * out: Phi_x (3,4) */
FLEXEL_CLONES
static void body_rotation_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vl2 = v[2 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_vl0 = v[0 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real t_1 = p[1 * 8 + j];
            const real r_vl1 = v[1 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real t0 = r_vl0 * t_2 + r_vl3 * t_1 + r_vl2 * t_0 - r_vl1 * t_3;
            const real t1 = 2.0 * t_3 * t0;
            const real t2 = r_vl0 * t_1 + r_vl2 * t_3 + r_vl1 * t_0 - r_vl3 * t_2;
            const real t3 = 2.0 * t_0 * t2;
            const real t4 = r_vl0 * t_3 + r_vl3 * t_0 + r_vl1 * t_2 - r_vl2 * t_1;
            const real t5 = 2.0 * t_2 * t4;
            const real t6 = r_vl0 * t_0 - r_vl1 * t_1 - r_vl2 * t_2 - r_vl3 * t_3;
            const real t7 = 2.0 * t_1 * t6;
            Phi_x[0 * 8 + j] = t1 + t3 - t5 - t7; /* Phi_x(0,0) */
            const real t8 = 2.0 * t_2 * t0;
            const real t9 = 2.0 * t_3 * t4;
            const real t10 = 2.0 * t_0 * t6;
            const real t11 = 2.0 * t_1 * t2;
            Phi_x[1 * 8 + j] = t8 + t9 - t10 - t11; /* Phi_x(0,1) */
            const real t12 = 2.0 * t_2 * t2;
            const real t13 = 2.0 * t_3 * t6;
            const real t14 = 2.0 * t_1 * t0;
            const real t15 = 2.0 * t_0 * t4;
            Phi_x[2 * 8 + j] = -(t14 + t15 + t13 + t12); /* Phi_x(0,2) */
            const real t16 = 2.0 * t_2 * t6;
            const real t17 = 2.0 * t_0 * t0;
            const real t18 = 2.0 * t_1 * t4;
            const real t19 = 2.0 * t_3 * t2;
            Phi_x[3 * 8 + j] = t16 + t17 - t18 - t19; /* Phi_x(0,3) */
            const real t20 = t17 + t18;
            const real t21 = t16 + t19;
            Phi_x[4 * 8 + j] = t20 - t21; /* Phi_x(1,0) */
            const real t22 = t13 - t12;
            Phi_x[5 * 8 + j] = t15 + t22 - t14; /* Phi_x(1,1) */
            const real t23 = t11 - t10;
            Phi_x[6 * 8 + j] = t9 + t23 - t8; /* Phi_x(1,2) */
            const real t24 = t7 + t3;
            Phi_x[7 * 8 + j] = -(t1 + t5 + t24); /* Phi_x(1,3) */
            Phi_x[8 * 8 + j] = t15 - t14 - t22; /* Phi_x(2,0) */
            Phi_x[9 * 8 + j] = -(t21 + t20); /* Phi_x(2,1) */
            Phi_x[10 * 8 + j] = t24 - t1 - t5; /* Phi_x(2,2) */
            Phi_x[11 * 8 + j] = t8 + t23 - t9; /* Phi_x(2,3) */
        }
    }
}

/* kinematics: 173 operations.
 * in:  x (4), v (4), a (4), p (4)
 * out: Psi_x (3,4), Psi_v (3,4) */
FLEXEL_CLONES
static void body_rotation_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (4 * 8);
        const real *restrict a = in[2] + b * (4 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (12 * 8);
        real *restrict Psi_v = out[1] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t_1 = p[1 * 8 + j];
            const real r_al3 = a[3 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real r_al0 = a[0 * 8 + j];
            const real t_0 = p[0 * 8 + j];
            const real r_al2 = a[2 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real r_al1 = a[1 * 8 + j];
            const real t0 = t_2 * r_al0 + t_0 * r_al2 + t_1 * r_al3 - t_3 * r_al1;
            const real t1 = 2.0 * t_3 * t0;
            const real t2 = t_3 * r_al0 + t_2 * r_al1 + t_0 * r_al3 - t_1 * r_al2;
            const real t3 = 2.0 * t_2 * t2;
            const real t4 = t_0 * r_al0 - t_1 * r_al1 - t_2 * r_al2 - t_3 * r_al3;
            const real t5 = 2.0 * t_1 * t4;
            const real t6 = t_1 * r_al0 + t_0 * r_al1 + t_3 * r_al2 - t_2 * r_al3;
            const real t7 = 2.0 * t_0 * t6;
            Psi_x[0 * 8 + j] = t1 - t3 - t5 + t7; /* Psi_x(0,0) */
            const real t8 = 2.0 * t_2 * t0;
            const real t9 = 2.0 * t_3 * t2;
            const real t10 = 2.0 * t_0 * t4;
            const real t11 = 2.0 * t_1 * t6;
            Psi_x[1 * 8 + j] = t8 + t9 - t10 - t11; /* Psi_x(0,1) */
            const real t12 = 2.0 * t_1 * t0;
            const real t13 = 2.0 * t_0 * t2;
            const real t14 = 2.0 * t_3 * t4;
            const real t15 = 2.0 * t_2 * t6;
            Psi_x[2 * 8 + j] = -(t12 + t13 + t14 + t15); /* Psi_x(0,2) */
            const real t16 = 2.0 * t_0 * t0;
            const real t17 = 2.0 * t_1 * t2;
            const real t18 = 2.0 * t_2 * t4;
            const real t19 = 2.0 * t_3 * t6;
            Psi_x[3 * 8 + j] = t16 - t17 + t18 - t19; /* Psi_x(0,3) */
            const real t20 = t18 + t19;
            Psi_x[4 * 8 + j] = t17 - t20 + t16; /* Psi_x(1,0) */
            const real t21 = t14 - t15;
            Psi_x[5 * 8 + j] = t13 + t21 - t12; /* Psi_x(1,1) */
            const real t22 = t11 - t10;
            Psi_x[6 * 8 + j] = t9 + t22 - t8; /* Psi_x(1,2) */
            const real t23 = t5 + t7;
            Psi_x[7 * 8 + j] = -(t3 + t23 + t1); /* Psi_x(1,3) */
            Psi_x[8 * 8 + j] = t13 - (t12 + t21); /* Psi_x(2,0) */
            Psi_x[9 * 8 + j] = -(t16 + t20 + t17); /* Psi_x(2,1) */
            Psi_x[10 * 8 + j] = t23 - t1 - t3; /* Psi_x(2,2) */
            Psi_x[11 * 8 + j] = t8 + t22 - t9; /* Psi_x(2,3) */
            const real r_vl3 = v[3 * 8 + j];
            const real t24 = r_vl3 * t_1;
            const real r_vl0 = v[0 * 8 + j];
            const real t25 = r_vl0 * t_2;
            const real r_vl2 = v[2 * 8 + j];
            const real t26 = r_vl2 * t_0;
            const real r_vl1 = v[1 * 8 + j];
            const real t27 = r_vl1 * t_3;
            const real t28 = 2.0 * (t25 + t26 + t24 - t27) + 2.0 * (t27 - t25 - t26 - t24);
            const real t29 = t_3 * t28;
            const real t30 = r_vl3 * t_0;
            const real t31 = r_vl0 * t_3;
            const real t32 = r_vl1 * t_2;
            const real t33 = r_vl2 * t_1;
            const real t34 = 2.0 * (t31 + t32 + t30 - t33) + 2.0 * (t33 - t31 - t32 - t30);
            const real t35 = t_2 * t34;
            const real t36 = r_vl2 * t_3;
            const real t37 = r_vl0 * t_1;
            const real t38 = r_vl1 * t_0;
            const real t39 = r_vl3 * t_2;
            const real t40 = 2.0 * (t37 + t38 + t36 - t39) + 2.0 * (t39 - t37 - t38 - t36);
            const real t41 = t_0 * t40;
            Psi_v[0 * 8 + j] = t29 - t35 + t41; /* Psi_v(0,0) */
            const real t42 = t_3 * t34;
            const real t43 = t_2 * t28;
            const real t44 = t_1 * t40;
            Psi_v[1 * 8 + j] = t42 + t43 - t44; /* Psi_v(0,1) */
            const real t45 = t_0 * t34;
            const real t46 = t_1 * t28;
            const real t47 = t_2 * t40;
            Psi_v[2 * 8 + j] = -(t45 + t46 + t47); /* Psi_v(0,2) */
            const real t48 = t_0 * t28;
            const real t49 = t_1 * t34;
            const real t50 = t_3 * t40;
            Psi_v[3 * 8 + j] = t48 - t49 - t50; /* Psi_v(0,3) */
            Psi_v[4 * 8 + j] = t48 - t50 + t49; /* Psi_v(1,0) */
            Psi_v[5 * 8 + j] = t45 - (t46 + t47); /* Psi_v(1,1) */
            Psi_v[6 * 8 + j] = t44 - t43 + t42; /* Psi_v(1,2) */
            Psi_v[7 * 8 + j] = -(t29 + t41 + t35); /* Psi_v(1,3) */
            Psi_v[8 * 8 + j] = t45 + t47 - t46; /* Psi_v(2,0) */
            Psi_v[9 * 8 + j] = -(t49 + t50 + t48); /* Psi_v(2,1) */
            Psi_v[10 * 8 + j] = t41 - t35 - t29; /* Psi_v(2,2) */
            Psi_v[11 * 8 + j] = t44 - t42 + t43; /* Psi_v(2,3) */
        }
    }
}

/* stiffness: 86 operations.
 * in:  x (4), sigma (0), tau (3), p (4)
 * out: K (4,4) */
FLEXEL_CLONES
static void body_rotation_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict tau = in[2] + b * (3 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict K = out[0] + b * (16 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t_1 = p[1 * 8 + j];
            const real tau_wx = tau[0 * 8 + j];
            const real t_3 = p[3 * 8 + j];
            const real tau_wz = tau[2 * 8 + j];
            const real t_2 = p[2 * 8 + j];
            const real tau_wy = tau[1 * 8 + j];
            const real t0 = t_3 * tau_wz + t_2 * tau_wy + t_1 * tau_wx;
            const real t_0 = p[0 * 8 + j];
            const real t1 = 2.0 * t_0 * t0;
            const real t2 = t_0 * tau_wz + t_1 * tau_wy - t_2 * tau_wx;
            const real t3 = 2.0 * t_3 * t2;
            const real t4 = t_0 * tau_wy + t_3 * tau_wx - t_1 * tau_wz;
            const real t5 = 2.0 * t_2 * t4;
            const real t6 = t_2 * tau_wz + t_0 * tau_wx - t_3 * tau_wy;
            const real t7 = 2.0 * t_1 * t6;
            K[0 * 8 + j] = K[5 * 8 + j] = t1 - (t3 + t5) - t7; /* K(0,0) K(1,1) */
            const real t8 = 2.0 * t_3 * t4;
            const real t9 = 2.0 * t_2 * t2;
            const real t10 = t8 - t9;
            const real t11 = 2.0 * t_0 * t6;
            const real t12 = 2.0 * t_1 * t0;
            K[1 * 8 + j] = t10 - t11 - t12; /* K(0,1) */
            const real t13 = 2.0 * t_1 * t2;
            const real t14 = 2.0 * t_0 * t4;
            const real t15 = t13 - t14;
            const real t16 = 2.0 * t_3 * t6;
            const real t17 = 2.0 * t_2 * t0;
            K[2 * 8 + j] = t15 - t16 - t17; /* K(0,2) */
            const real t18 = 2.0 * t_2 * t6;
            const real t19 = 2.0 * t_0 * t2;
            const real t20 = 2.0 * t_1 * t4;
            const real t21 = t19 + t20;
            const real t22 = 2.0 * t_3 * t0;
            K[3 * 8 + j] = t18 - t21 - t22; /* K(0,3) */
            const real t23 = t11 + t12;
            K[4 * 8 + j] = t23 - t10; /* K(1,0) */
            K[6 * 8 + j] = t21 + t22 - t18; /* K(1,2) */
            K[7 * 8 + j] = t15 - t17 - t16; /* K(1,3) */
            K[8 * 8 + j] = K[13 * 8 + j] = t16 + t17 + t14 - t13; /* K(2,0) K(3,1) */
            const real t24 = t18 - t22;
            K[9 * 8 + j] = t24 - t19 - t20; /* K(2,1) */
            const real t25 = t1 - t7;
            K[10 * 8 + j] = t25 - t3 - t5; /* K(2,2) */
            K[11 * 8 + j] = t9 + t23 - t8; /* K(2,3) */
            K[12 * 8 + j] = t21 - t24; /* K(3,0) */
            K[14 * 8 + j] = t8 - t23 - t9; /* K(3,2) */
            K[15 * 8 + j] = t25 - t5 - t3; /* K(3,3) */
        }
    }
}

const flexel_element flexel_body_rotation = {
    .name = "body_rotation",
    .digest = "7b449a58d5624bcd",
    .n = 4,
    .m = 0,
    .k = 3,
    .np = 4,
    .position = body_rotation_position,
    .acceleration = body_rotation_acceleration,
    .rates = body_rotation_rates,
    .kinematics = body_rotation_kinematics,
    .stiffness = body_rotation_stiffness,
};
