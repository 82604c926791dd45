/* skate: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * b = R(lambda) blade, n = normal, ey = (n x b)/|n x b|, ex = ey x n
 * surface = n.x - height,  forward = ex.v,  lateral = ey.v
 * ahead: b
 * origin: x, axes: columns of R(lambda) in rows: the frame that carries what a picture shows
 *
 * Source: Chaplygin 1911, sleigh; Neimark and Fufaev 1972, Dynamics of Nonholonomic Systems
 *
 * x (7): p_x, p_y, p_z, r_l0, r_l1, r_l2, r_l3
 * e (1): surface [m]
 * s (2): forward [m/s], lateral [m/s]
 * p (7):
 *   blade (3) [1]: unit vector along the blade in body axes
 *   normal (3) [1]: unit normal of the road
 *   height (1) [m]: distance of the road from the origin along its normal */
#include "kernels.h"

/* position: 77 operations.
 * in:  x (7), p (7)
 * out: e (1), De (1,7), 3 of 7 entries, V (2,7), 6 of 14 entries */
FLEXEL_CLONES
static void skate_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict p = in[1] + b * (7 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (3 * 8);
        real *restrict V = out[2] + b * (6 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real normal_y = p[4 * 8 + j];
            De[1 * 8 + j] = normal_y; /* De(0,1) */
            const real p_y = x[1 * 8 + j];
            const real normal_x = p[3 * 8 + j];
            De[0 * 8 + j] = normal_x; /* De(0,0) */
            const real p_x = x[0 * 8 + j];
            const real normal_z = p[5 * 8 + j];
            De[2 * 8 + j] = normal_z; /* De(0,2) */
            const real p_z = x[2 * 8 + j];
            const real height = p[6 * 8 + j];
            e[0 * 8 + j] = p_x * normal_x + p_z * normal_z + p_y * normal_y - height;
            const real r_l0 = x[3 * 8 + j];
            const real t0 = r_l0 * r_l0;
            const real r_l1 = x[4 * 8 + j];
            const real t1 = r_l1 * r_l1;
            const real r_l2 = x[5 * 8 + j];
            const real t2 = r_l2 * r_l2;
            const real r_l3 = x[6 * 8 + j];
            const real t3 = r_l3 * r_l3;
            const real blade_x = p[0 * 8 + j];
            const real t4 = r_l1 * r_l2;
            const real t5 = r_l0 * r_l3;
            const real blade_y = p[1 * 8 + j];
            const real t6 = r_l0 * r_l2;
            const real t7 = r_l1 * r_l3;
            const real blade_z = p[2 * 8 + j];
            const real b_x = blade_x * (t0 + t1 - t2 - t3) + 2.0 * (blade_y * (t4 - t5) + blade_z * (t6 + t7));
            const real t8 = r_l0 * r_l1;
            const real t9 = r_l2 * r_l3;
            const real b_z = blade_z * (t0 + t3 - t1 - t2) + 2.0 * (blade_x * (t7 - t6) + blade_y * (t8 + t9));
            const real side_y = normal_z * b_x - normal_x * b_z;
            const real b_y = blade_y * (t0 + t2 - t1 - t3) + 2.0 * (blade_x * (t5 + t4) + blade_z * (t9 - t8));
            const real side_z = normal_x * b_y - normal_y * b_x;
            const real side_x = normal_y * b_z - normal_z * b_y;
            const real side_length = real_sqrt(side_z * side_z + side_x * side_x + side_y * side_y);
            const real t10 = 1.0 / side_length;
            const real ey_y = side_y * t10;
            V[4 * 8 + j] = ey_y; /* V(1,1) */
            const real ey_z = side_z * t10;
            V[5 * 8 + j] = ey_z; /* V(1,2) */
            V[0 * 8 + j] = normal_z * ey_y - normal_y * ey_z; /* V(0,0) */
            const real ey_x = side_x * t10;
            V[3 * 8 + j] = ey_x; /* V(1,0) */
            V[1 * 8 + j] = normal_x * ey_z - normal_z * ey_x; /* V(0,1) */
            V[2 * 8 + j] = normal_y * ey_x - normal_x * ey_y; /* V(0,2) */
        }
    }
}

/* acceleration: 163 operations.
 * in:  x (7), v (7), p (7)
 * out: g (1), 0 of 1 entries, gs (2) */
FLEXEL_CLONES
static void skate_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict gs = out[1] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[3 * 8 + j];
            const real t0 = r_l0 * r_l0;
            const real r_l1 = x[4 * 8 + j];
            const real t1 = r_l1 * r_l1;
            const real r_l2 = x[5 * 8 + j];
            const real t2 = r_l2 * r_l2;
            const real r_l3 = x[6 * 8 + j];
            const real t3 = r_l3 * r_l3;
            const real blade_x = p[0 * 8 + j];
            const real t4 = r_l1 * r_l2;
            const real t5 = r_l0 * r_l3;
            const real blade_y = p[1 * 8 + j];
            const real t6 = r_l0 * r_l2;
            const real t7 = r_l1 * r_l3;
            const real blade_z = p[2 * 8 + j];
            const real b_x = blade_x * (t0 + t1 - t2 - t3) + 2.0 * (blade_y * (t4 - t5) + blade_z * (t6 + t7));
            const real normal_z = p[5 * 8 + j];
            const real t8 = r_l0 * r_l1;
            const real t9 = r_l2 * r_l3;
            const real b_z = blade_z * (t0 + t3 - t1 - t2) + 2.0 * (blade_x * (t7 - t6) + blade_y * (t8 + t9));
            const real normal_x = p[3 * 8 + j];
            const real side_y = normal_z * b_x - normal_x * b_z;
            const real b_y = blade_y * (t0 + t2 - t1 - t3) + 2.0 * (blade_x * (t5 + t4) + blade_z * (t9 - t8));
            const real normal_y = p[4 * 8 + j];
            const real side_z = normal_x * b_y - normal_y * b_x;
            const real side_x = normal_y * b_z - normal_z * b_y;
            const real side_length = real_sqrt(side_z * side_z + side_x * side_x + side_y * side_y);
            const real t10 = 1.0 / side_length;
            const real r_vl0 = v[3 * 8 + j];
            const real t11 = 2.0 * r_l0 * r_vl0;
            const real r_vl2 = v[5 * 8 + j];
            const real t12 = 2.0 * r_l2 * r_vl2;
            const real r_vl1 = v[4 * 8 + j];
            const real t13 = 2.0 * r_l1 * r_vl1;
            const real r_vl3 = v[6 * 8 + j];
            const real t14 = 2.0 * r_l3 * r_vl3;
            const real t15 = r_l3 * r_vl0 + r_l0 * r_vl3;
            const real t16 = r_l2 * r_vl1 + r_l1 * r_vl2;
            const real t17 = r_l3 * r_vl2 + r_l2 * r_vl3;
            const real t18 = r_l1 * r_vl0 + r_l0 * r_vl1;
            const real t19 = blade_y * (t11 + t12 - t13 - t14) + 2.0 * (blade_x * (t15 + t16) + blade_z * (t17
                - t18));
            const real t20 = r_l2 * r_vl0 + r_l0 * r_vl2;
            const real t21 = r_l3 * r_vl1 + r_l1 * r_vl3;
            const real t22 = blade_x * (t11 + t13 - t12 - t14) + 2.0 * (blade_y * (t16 - t15) + blade_z * (t20
                + t21));
            const real t23 = normal_x * t19 - normal_y * t22;
            const real t24 = blade_z * (t11 + t14 - t13 - t12) + 2.0 * (blade_x * (t21 - t20) + blade_y * (t18
                + t17));
            const real t25 = normal_z * t22 - normal_x * t24;
            const real t26 = normal_y * t24 - normal_z * t19;
            const real t27 = t10 * (side_z * t23 + side_x * t26 + side_y * t25) * t10 * t10;
            const real t28 = t10 * t23 - side_z * t27;
            const real t29 = t10 * t26 - side_x * t27;
            const real p_vy = v[1 * 8 + j];
            const real t30 = t10 * t25 - side_y * t27;
            const real p_vz = v[2 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t31 = p_vz * (normal_y * t29 - normal_x * t30) + p_vx * (normal_z * t30 - normal_y * t28);
            gs[0 * 8 + j] = p_vy * (normal_x * t28 - normal_z * t29) + t31;
            gs[1 * 8 + j] = p_vz * t28 + p_vx * t29 + p_vy * t30;
        }
    }
}

/* rates: 200 operations.
 * in:  x (7), v (7), p (7)
 * out: Phi_x (3,7), 8 of 21 entries */
FLEXEL_CLONES
static void skate_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict Phi_x = out[0] + b * (8 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l2 = x[5 * 8 + j];
            const real blade_z = p[2 * 8 + j];
            const real r_l0 = x[3 * 8 + j];
            const real blade_x = p[0 * 8 + j];
            const real r_l3 = x[6 * 8 + j];
            const real blade_y = p[1 * 8 + j];
            const real t0 = 2.0 * r_l0 * blade_x - 2.0 * r_l3 * blade_y + 2.0 * r_l2 * blade_z;
            const real p_vx = v[0 * 8 + j];
            const real normal_z = p[5 * 8 + j];
            const real p_vz = v[2 * 8 + j];
            const real normal_x = p[3 * 8 + j];
            const real t1 = p_vx * normal_z - p_vz * normal_x;
            const real t2 = r_l2 * r_l3;
            const real r_l1 = x[4 * 8 + j];
            const real t3 = r_l0 * r_l1;
            const real t4 = r_l0 * r_l3;
            const real t5 = r_l1 * r_l2;
            const real t6 = r_l0 * r_l0;
            const real t7 = r_l2 * r_l2;
            const real t8 = r_l1 * r_l1;
            const real t9 = r_l3 * r_l3;
            const real t10 = 2.0 * blade_x * (t4 + t5) + blade_y * (t6 + t7 - t8 - t9);
            const real b_y = 2.0 * blade_z * (t2 - t3) + t10;
            const real t11 = r_l0 * r_l2;
            const real t12 = r_l1 * r_l3;
            const real t13 = blade_x * (t6 + t8 - t7 - t9) + 2.0 * blade_y * (t5 - t4);
            const real b_x = 2.0 * blade_z * (t11 + t12) + t13;
            const real normal_y = p[4 * 8 + j];
            const real side_z = normal_x * b_y - normal_y * b_x;
            const real b_z = 2.0 * blade_x * (t12 - t11) + 2.0 * blade_y * (t3 + t2) + blade_z * (t6 + t9 - t8 - t7);
            const real side_x = normal_y * b_z - normal_z * b_y;
            const real side_y = normal_z * b_x - normal_x * b_z;
            const real side_length = real_sqrt(side_x * side_x + side_y * side_y + side_z * side_z);
            const real t14 = 1.0 / side_length;
            const real t15 = normal_z * t14;
            const real p_vy = v[1 * 8 + j];
            const real t16 = p_vy * normal_x - p_vx * normal_y;
            const real t17 = normal_y * t14;
            const real t18 = t14 * t14 * t14;
            const real t19 = side_z * t18;
            const real t20 = side_y * t18;
            const real t21 = normal_y * t19 - normal_z * t20;
            const real t22 = p_vz * normal_y - p_vy * normal_z;
            const real t23 = side_y * t1 + side_x * t22 + side_z * t16;
            const real t24 = t1 * t15 - t16 * t17 + t21 * t23;
            const real t25 = 2.0 * r_l3 * blade_x + 2.0 * r_l0 * blade_y - 2.0 * r_l1 * blade_z;
            const real t26 = normal_x * t14;
            const real t27 = side_x * t18;
            const real t28 = normal_z * t27 - normal_x * t19;
            const real t29 = t16 * t26 - t22 * t15 + t28 * t23;
            const real t30 = 2.0 * r_l1 * blade_y - 2.0 * r_l2 * blade_x + 2.0 * r_l0 * blade_z;
            const real t31 = normal_x * t20 - normal_y * t27;
            const real t32 = t22 * t17 - t1 * t26 + t31 * t23;
            Phi_x[0 * 8 + j] = t0 * t24 + t25 * t29 + t30 * t32; /* Phi_x(1,3) */
            const real t33 = 2.0 * r_l1 * blade_x + 2.0 * r_l2 * blade_y + 2.0 * r_l3 * blade_z;
            Phi_x[1 * 8 + j] = t33 * t24 - t30 * t29 + t25 * t32; /* Phi_x(1,4) */
            Phi_x[2 * 8 + j] = t30 * t24 + t33 * t29 - t0 * t32; /* Phi_x(1,5) */
            Phi_x[3 * 8 + j] = t0 * t29 - t25 * t24 + t33 * t32; /* Phi_x(1,6) */
            const real t34 = p_vy * side_y + p_vx * side_x + p_vz * side_z;
            const real t35 = p_vy * t15 - p_vz * t17 + t21 * t34;
            const real t36 = p_vz * t26 - p_vx * t15 + t28 * t34;
            const real t37 = p_vx * t17 - p_vy * t26 + t31 * t34;
            Phi_x[4 * 8 + j] = t0 * t35 + t25 * t36 + t30 * t37; /* Phi_x(2,3) */
            Phi_x[5 * 8 + j] = t33 * t35 - t30 * t36 + t25 * t37; /* Phi_x(2,4) */
            Phi_x[6 * 8 + j] = t30 * t35 + t33 * t36 - t0 * t37; /* Phi_x(2,5) */
            Phi_x[7 * 8 + j] = t0 * t36 - t25 * t35 + t33 * t37; /* Phi_x(2,6) */
        }
    }
}

/* kinematics: 666 operations.
 * in:  x (7), v (7), a (7), p (7)
 * out: Psi_x (3,7), 8 of 21 entries, Psi_v (3,7), 14 of 21 entries */
FLEXEL_CLONES
static void skate_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict v = in[1] + b * (7 * 8);
        const real *restrict a = in[2] + b * (7 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict Psi_x = out[0] + b * (8 * 8);
        real *restrict Psi_v = out[1] + b * (14 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[3 * 8 + j];
            const real t0 = r_l0 * r_l0;
            const real r_l3 = x[6 * 8 + j];
            const real t1 = r_l3 * r_l3;
            const real r_l1 = x[4 * 8 + j];
            const real t2 = r_l1 * r_l1;
            const real r_l2 = x[5 * 8 + j];
            const real t3 = r_l2 * r_l2;
            const real blade_z = p[2 * 8 + j];
            const real t4 = r_l1 * r_l3;
            const real t5 = r_l0 * r_l2;
            const real blade_x = p[0 * 8 + j];
            const real t6 = r_l0 * r_l1;
            const real t7 = r_l2 * r_l3;
            const real blade_y = p[1 * 8 + j];
            const real b_z = blade_z * (t0 + t1 - t2 - t3) + 2.0 * (blade_x * (t4 - t5) + blade_y * (t6 + t7));
            const real normal_y = p[4 * 8 + j];
            const real t8 = r_l0 * r_l3;
            const real t9 = r_l1 * r_l2;
            const real b_y = blade_y * (t0 + t3 - t2 - t1) + 2.0 * (blade_x * (t8 + t9) + blade_z * (t7 - t6));
            const real normal_z = p[5 * 8 + j];
            const real side_x = normal_y * b_z - normal_z * b_y;
            const real normal_x = p[3 * 8 + j];
            const real b_x = blade_x * (t0 + t2 - t3 - t1) + 2.0 * (blade_y * (t9 - t8) + blade_z * (t5 + t4));
            const real side_z = normal_x * b_y - normal_y * b_x;
            const real side_y = normal_z * b_x - normal_x * b_z;
            const real side_length = real_sqrt(side_z * side_z + side_y * side_y + side_x * side_x);
            const real t10 = 1.0 / side_length;
            const real p_vz = v[2 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t11 = p_vz * normal_y - p_vy * normal_z;
            const real t12 = t10 * t10;
            const real p_vx = v[0 * 8 + j];
            const real t13 = p_vx * normal_z - p_vz * normal_x;
            const real t14 = p_vy * normal_x - p_vx * normal_y;
            const real t15 = side_z * t14 + side_x * t11 + side_y * t13;
            const real t16 = t12 * t15;
            const real t17 = t10 * t16;
            const real t18 = t10 * t11 - side_x * t17;
            const real t19 = t10 * t13 - side_y * t17;
            const real t20 = normal_y * t18 - normal_x * t19;
            const real t21 = 2.0 * blade_y * t20;
            const real t22 = t10 * t14 - side_z * t17;
            const real t23 = normal_x * t22 - normal_z * t18;
            const real t24 = 2.0 * blade_z * t23;
            const real t25 = t21 - t24;
            const real r_vl1 = v[4 * 8 + j];
            const real t26 = normal_z * t19 - normal_y * t22;
            const real t27 = 2.0 * blade_z * t26;
            const real t28 = 2.0 * blade_x * t20;
            const real t29 = t27 - t28;
            const real r_vl2 = v[5 * 8 + j];
            const real t30 = 2.0 * blade_x * t23;
            const real t31 = 2.0 * blade_y * t26;
            const real t32 = t30 - t31;
            const real r_vl3 = v[6 * 8 + j];
            const real p_az = a[2 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t33 = normal_y * p_az - normal_z * p_ay;
            const real t34 = t10 * t12;
            const real r_vl0 = v[3 * 8 + j];
            const real t35 = 2.0 * r_l0 * r_vl0;
            const real t36 = 2.0 * r_l1 * r_vl1;
            const real t37 = 2.0 * r_l2 * r_vl2;
            const real t38 = 2.0 * r_l3 * r_vl3;
            const real t39 = r_l2 * r_vl1 + r_l1 * r_vl2;
            const real t40 = r_l3 * r_vl0 + r_l0 * r_vl3;
            const real t41 = r_l2 * r_vl0 + r_l0 * r_vl2;
            const real t42 = r_l3 * r_vl1 + r_l1 * r_vl3;
            const real t43 = blade_x * (t35 + t36 - t37 - t38) + 2.0 * (blade_y * (t39 - t40) + blade_z * (t41
                + t42));
            const real t44 = r_l1 * r_vl0 + r_l0 * r_vl1;
            const real t45 = r_l3 * r_vl2 + r_l2 * r_vl3;
            const real t46 = blade_z * (t35 + t38 - t36 - t37) + 2.0 * (blade_x * (t42 - t41) + blade_y * (t44
                + t45));
            const real t47 = normal_z * t43 - normal_x * t46;
            const real t48 = blade_y * (t35 + t37 - t36 - t38) + 2.0 * (blade_x * (t40 + t39) + blade_z * (t45
                - t44));
            const real t49 = normal_x * t48 - normal_y * t43;
            const real t50 = normal_y * t46 - normal_z * t48;
            const real p_ax = a[0 * 8 + j];
            const real t51 = normal_x * p_ay - normal_y * p_ax;
            const real t52 = normal_z * p_ax - normal_x * p_az;
            const real t53 = side_y * t52 + side_x * t33 + side_z * t51 + t50 * t11 + t49 * t14;
            const real t54 = side_z * t49 + side_y * t47 + side_x * t50;
            const real t55 = t10 * t54;
            const real t56 = t10 * t55;
            const real t57 = t34 * (t47 * t13 + t53 - 2.0 * t56 * t15 - t54 * t16);
            const real t58 = t12 * t55;
            const real t59 = t10 * t33 - side_x * t57 - t11 * t58 - t50 * t17;
            const real t60 = t10 * t52 - side_y * t57 - t13 * t58 - t47 * t17;
            const real t61 = normal_y * t59 - normal_x * t60;
            const real t62 = 2.0 * blade_y * t61;
            const real t63 = t10 * t51 - side_z * t57 - t14 * t58 - t49 * t17;
            const real t64 = normal_x * t63 - normal_z * t59;
            const real t65 = 2.0 * blade_z * t64;
            const real t66 = t62 - t65;
            const real t67 = normal_z * t60 - normal_y * t63;
            const real t68 = 2.0 * blade_z * t67;
            const real t69 = 2.0 * blade_x * t61;
            const real t70 = t68 - t69;
            const real t71 = blade_z * t20;
            const real t72 = blade_y * t23;
            const real t73 = t71 + t72;
            const real t74 = blade_x * t26;
            const real t75 = blade_z * t61;
            const real t76 = blade_y * t64;
            const real t77 = t75 + t76;
            const real t78 = blade_x * t67;
            const real t79 = 2.0 * blade_x * t64;
            const real t80 = 2.0 * blade_y * t67;
            const real t81 = t79 - t80;
            const real t82 = 2.0 * (r_vl0 * (t73 + t74) + r_l0 * (t77 + t78)) + r_l3 * t81;
            const real t83 = r_l2 * t70 + t82 + r_l1 * t66 + r_vl3 * t32 + r_vl2 * t29;
            Psi_x[0 * 8 + j] = r_vl1 * t25 + t83; /* Psi_x(1,3) */
            const real t84 = t28 + t27;
            const real t85 = t30 + t31;
            const real t86 = t69 + t68;
            const real t87 = t79 + t80;
            const real t88 = 2.0 * (r_vl1 * (t74 - t73) + r_l1 * (t78 - t77)) + r_l2 * t87;
            const real t89 = r_l3 * t86 + t88 + r_l0 * t66 + r_vl2 * t85 + r_vl3 * t84;
            Psi_x[1 * 8 + j] = r_vl0 * t25 + t89; /* Psi_x(1,4) */
            const real t90 = t21 + t24;
            const real t91 = t62 + t65;
            const real t92 = r_l1 * t87 + r_l0 * t70 + r_l3 * t91 + r_vl1 * t85 + r_vl3 * t90;
            const real t93 = t75 - t76;
            const real t94 = t71 - t72;
            Psi_x[2 * 8 + j] = r_vl0 * t29 + t92 - 2.0 * (r_l2 * (t93 + t78) + r_vl2 * (t94 + t74)); /* Psi_x(1,5) */
            const real t95 = 2.0 * (r_vl3 * (t94 - t74) + r_l3 * (t93 - t78)) + r_l0 * t81;
            const real t96 = r_l1 * t86 + t95 + r_l2 * t91 + r_vl0 * t32 + r_vl1 * t84;
            Psi_x[3 * 8 + j] = r_vl2 * t90 + t96; /* Psi_x(1,6) */
            const real t97 = p_vz * side_z + p_vx * side_x + p_vy * side_y;
            const real t98 = t12 * t97;
            const real t99 = t10 * t98;
            const real t100 = p_vx * t10 - side_x * t99;
            const real t101 = p_vy * t10 - side_y * t99;
            const real t102 = normal_y * t100 - normal_x * t101;
            const real t103 = 2.0 * blade_y * t102;
            const real t104 = p_vz * t10 - side_z * t99;
            const real t105 = normal_x * t104 - normal_z * t100;
            const real t106 = 2.0 * blade_z * t105;
            const real t107 = t103 - t106;
            const real t108 = normal_z * t101 - normal_y * t104;
            const real t109 = 2.0 * blade_z * t108;
            const real t110 = 2.0 * blade_x * t102;
            const real t111 = t109 - t110;
            const real t112 = 2.0 * blade_x * t105;
            const real t113 = 2.0 * blade_y * t108;
            const real t114 = t112 - t113;
            const real t115 = p_ay * side_y + p_ax * side_x + p_az * side_z + p_vx * t50;
            const real t116 = p_vz * t49 + t115 + p_vy * t47 - 2.0 * t56 * t97 - t54 * t98;
            const real t117 = t34 * t116;
            const real t118 = p_ax * t10 - side_x * t117 - p_vx * t58 - t50 * t99;
            const real t119 = p_ay * t10 - side_y * t117 - p_vy * t58 - t47 * t99;
            const real t120 = normal_y * t118 - normal_x * t119;
            const real t121 = 2.0 * blade_y * t120;
            const real t122 = p_az * t10 - side_z * t117 - p_vz * t58 - t49 * t99;
            const real t123 = normal_x * t122 - normal_z * t118;
            const real t124 = 2.0 * blade_z * t123;
            const real t125 = t121 - t124;
            const real t126 = normal_z * t119 - normal_y * t122;
            const real t127 = 2.0 * blade_z * t126;
            const real t128 = 2.0 * blade_x * t120;
            const real t129 = t127 - t128;
            const real t130 = blade_z * t102;
            const real t131 = blade_y * t105;
            const real t132 = t130 + t131;
            const real t133 = blade_x * t108;
            const real t134 = blade_z * t120;
            const real t135 = blade_y * t123;
            const real t136 = t134 + t135;
            const real t137 = blade_x * t126;
            const real t138 = 2.0 * blade_x * t123;
            const real t139 = 2.0 * blade_y * t126;
            const real t140 = t138 - t139;
            const real t141 = 2.0 * (r_vl0 * (t132 + t133) + r_l0 * (t136 + t137)) + r_l3 * t140;
            const real t142 = r_l2 * t129 + t141 + r_l1 * t125 + r_vl3 * t114 + r_vl2 * t111;
            Psi_x[4 * 8 + j] = r_vl1 * t107 + t142; /* Psi_x(2,3) */
            const real t143 = t110 + t109;
            const real t144 = t112 + t113;
            const real t145 = t128 + t127;
            const real t146 = t138 + t139;
            const real t147 = 2.0 * (r_vl1 * (t133 - t132) + r_l1 * (t137 - t136)) + r_l2 * t146;
            const real t148 = r_l3 * t145 + t147 + r_l0 * t125 + r_vl2 * t144 + r_vl3 * t143;
            Psi_x[5 * 8 + j] = r_vl0 * t107 + t148; /* Psi_x(2,4) */
            const real t149 = t103 + t106;
            const real t150 = t121 + t124;
            const real t151 = r_l1 * t146 + r_l0 * t129 + r_l3 * t150 + r_vl1 * t144 + r_vl3 * t149;
            const real t152 = t134 - t135;
            const real t153 = t130 - t131;
            Psi_x[6 * 8 + j] = r_vl0 * t111 + t151 - 2.0 * (r_l2 * (t152 + t137) + r_vl2 * (t153 + t133));
                /* Psi_x(2,5) */
            const real t154 = 2.0 * (r_vl3 * (t153 - t133) + r_l3 * (t152 - t137)) + r_l0 * t140;
            const real t155 = r_l1 * t145 + t154 + r_l2 * t150 + r_vl0 * t114 + r_vl1 * t143;
            Psi_x[7 * 8 + j] = r_vl2 * t149 + t155; /* Psi_x(2,6) */
            const real t156 = t10 * t47 - side_y * t58;
            Psi_v[8 * 8 + j] = t156; /* Psi_v(2,1) */
            const real t157 = t10 * t49 - side_z * t58;
            Psi_v[9 * 8 + j] = t157; /* Psi_v(2,2) */
            Psi_v[0 * 8 + j] = normal_z * t156 - normal_y * t157; /* Psi_v(1,0) */
            const real t158 = t10 * t50 - side_x * t58;
            Psi_v[7 * 8 + j] = t158; /* Psi_v(2,0) */
            Psi_v[1 * 8 + j] = normal_x * t157 - normal_z * t158; /* Psi_v(1,1) */
            Psi_v[2 * 8 + j] = normal_y * t158 - normal_x * t156; /* Psi_v(1,2) */
            const real t159 = r_l3 * blade_x + r_l0 * blade_y - r_l1 * blade_z;
            const real t160 = normal_x * t10;
            const real t161 = side_x * t34;
            const real t162 = side_z * t34;
            const real t163 = normal_z * t161 - normal_x * t162;
            const real t164 = normal_z * t10;
            const real t165 = t14 * t160 + t163 * t15 - t11 * t164;
            const real t166 = r_l1 * blade_y + r_l0 * blade_z - r_l2 * blade_x;
            const real t167 = normal_y * t10;
            const real t168 = side_y * t34;
            const real t169 = normal_x * t168 - normal_y * t161;
            const real t170 = t11 * t167 + t169 * t15 - t13 * t160;
            const real t171 = r_l0 * blade_x + r_l2 * blade_z - r_l3 * blade_y;
            const real t172 = normal_y * t162 - normal_z * t168;
            const real t173 = t13 * t164 + t172 * t15 - t14 * t167;
            Psi_v[3 * 8 + j] = 2.0 * (t166 * t170 + t171 * t173 + t159 * t165); /* Psi_v(1,3) */
            const real t174 = r_l1 * blade_x + r_l2 * blade_y + r_l3 * blade_z;
            Psi_v[4 * 8 + j] = 2.0 * (t174 * t173 + t159 * t170 - t166 * t165); /* Psi_v(1,4) */
            Psi_v[5 * 8 + j] = 2.0 * (t166 * t173 + t174 * t165 - t171 * t170); /* Psi_v(1,5) */
            Psi_v[6 * 8 + j] = 2.0 * (t171 * t165 + t174 * t170 - t159 * t173); /* Psi_v(1,6) */
            const real t175 = p_vz * t160 + t163 * t97 - p_vx * t164;
            const real t176 = p_vx * t167 + t169 * t97 - p_vy * t160;
            const real t177 = p_vy * t164 + t172 * t97 - p_vz * t167;
            Psi_v[10 * 8 + j] = 2.0 * (t166 * t176 + t171 * t177 + t159 * t175); /* Psi_v(2,3) */
            Psi_v[11 * 8 + j] = 2.0 * (t174 * t177 + t159 * t176 - t166 * t175); /* Psi_v(2,4) */
            Psi_v[12 * 8 + j] = 2.0 * (t166 * t177 + t174 * t175 - t171 * t176); /* Psi_v(2,5) */
            Psi_v[13 * 8 + j] = 2.0 * (t171 * t175 + t174 * t176 - t159 * t177); /* Psi_v(2,6) */
        }
    }
}

/* stiffness: 254 operations.
 * in:  x (7), sigma (1), tau (2), p (7)
 * out: K (7,7), 12 of 49 entries */
FLEXEL_CLONES
static void skate_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict tau = in[2] + b * (2 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict K = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[3 * 8 + j];
            const real blade_z = p[2 * 8 + j];
            const real r_l1 = x[4 * 8 + j];
            const real blade_y = p[1 * 8 + j];
            const real r_l2 = x[5 * 8 + j];
            const real blade_x = p[0 * 8 + j];
            const real t0 = 2.0 * r_l1 * blade_y - 2.0 * r_l2 * blade_x + 2.0 * r_l0 * blade_z;
            const real r_l3 = x[6 * 8 + j];
            const real t1 = r_l2 * r_l3;
            const real t2 = r_l0 * r_l1;
            const real t3 = r_l0 * r_l3;
            const real t4 = r_l1 * r_l2;
            const real t5 = r_l0 * r_l0;
            const real t6 = r_l2 * r_l2;
            const real t7 = r_l1 * r_l1;
            const real t8 = r_l3 * r_l3;
            const real t9 = 2.0 * blade_x * (t3 + t4) + blade_y * (t5 + t6 - t7 - t8);
            const real b_y = 2.0 * blade_z * (t1 - t2) + t9;
            const real normal_x = p[3 * 8 + j];
            const real t10 = r_l0 * r_l2;
            const real t11 = r_l1 * r_l3;
            const real t12 = blade_x * (t5 + t7 - t6 - t8) + 2.0 * blade_y * (t4 - t3);
            const real b_x = 2.0 * blade_z * (t10 + t11) + t12;
            const real normal_y = p[4 * 8 + j];
            const real side_z = normal_x * b_y - normal_y * b_x;
            const real b_z = 2.0 * blade_x * (t11 - t10) + 2.0 * blade_y * (t2 + t1) + blade_z * (t5 + t8 - t7 - t6);
            const real normal_z = p[5 * 8 + j];
            const real side_x = normal_y * b_z - normal_z * b_y;
            const real side_y = normal_z * b_x - normal_x * b_z;
            const real side_length = real_sqrt(side_x * side_x + side_y * side_y + side_z * side_z);
            const real t13 = 1.0 / side_length;
            const real t14 = normal_y * t13;
            const real tau_lateral = tau[1 * 8 + j];
            const real t15 = tau_lateral * t14;
            const real t16 = normal_x * t13;
            const real tau_forward = tau[0 * 8 + j];
            const real t17 = normal_z * tau_forward;
            const real t18 = t15 - t16 * t17;
            const real t19 = 2.0 * r_l0 * blade_x - 2.0 * r_l3 * blade_y + 2.0 * r_l2 * blade_z;
            const real t20 = normal_y * tau_forward;
            const real t21 = t14 * t20;
            const real t22 = normal_z * t13;
            const real t23 = t22 * t17;
            const real t24 = t21 + t23;
            const real t25 = 2.0 * r_l3 * blade_x + 2.0 * r_l0 * blade_y - 2.0 * r_l1 * blade_z;
            const real t26 = tau_lateral * t22;
            const real t27 = t26 + t16 * t20;
            const real t28 = side_y * t17 + side_x * tau_lateral - side_z * t20;
            const real t29 = t13 * t13 * t13;
            const real t30 = side_y * t29;
            const real t31 = side_x * t29;
            const real t32 = normal_x * t30 - normal_y * t31;
            const real t33 = side_z * t29;
            const real t34 = normal_y * t33 - normal_z * t30;
            const real t35 = normal_z * t31 - normal_x * t33;
            const real t36 = t0 * t32 + t19 * t34 + t25 * t35;
            K[0 * 8 + j] = t0 * t18 + t19 * t24 - t25 * t27 + t28 * t36; /* K(0,3) */
            const real t37 = 2.0 * r_l1 * blade_x + 2.0 * r_l2 * blade_y + 2.0 * r_l3 * blade_z;
            const real t38 = t25 * t32 + t37 * t34 - t0 * t35;
            K[1 * 8 + j] = t25 * t18 + t37 * t24 + t0 * t27 + t28 * t38; /* K(0,4) */
            const real t39 = t0 * t34 - t19 * t32 + t37 * t35;
            K[2 * 8 + j] = t0 * t24 - t19 * t18 - t37 * t27 + t28 * t39; /* K(0,5) */
            const real t40 = t37 * t32 - t25 * t34 + t19 * t35;
            K[3 * 8 + j] = t37 * t18 - t25 * t24 - t19 * t27 + t28 * t40; /* K(0,6) */
            const real t41 = normal_x * tau_forward;
            const real t42 = t26 - t14 * t41;
            const real t43 = tau_lateral * t16;
            const real t44 = t14 * t17 + t43;
            const real t45 = t16 * t41;
            const real t46 = t23 + t45;
            const real t47 = side_y * tau_lateral - side_x * t17 + side_z * t41;
            K[4 * 8 + j] = t19 * t42 - t0 * t44 + t25 * t46 + t47 * t36; /* K(1,3) */
            K[5 * 8 + j] = t37 * t42 - t25 * t44 - t0 * t46 + t47 * t38; /* K(1,4) */
            K[6 * 8 + j] = t19 * t44 + t0 * t42 + t37 * t46 + t47 * t39; /* K(1,5) */
            K[7 * 8 + j] = t19 * t46 - (t37 * t44 + t25 * t42) + t47 * t40; /* K(1,6) */
            const real t48 = t21 + t45;
            const real t49 = t15 + t22 * t41;
            const real t50 = t43 - t22 * t20;
            const real t51 = side_x * t20 - side_y * t41 + side_z * tau_lateral;
            K[8 * 8 + j] = t0 * t48 - t19 * t49 + t25 * t50 + t51 * t36; /* K(2,3) */
            K[9 * 8 + j] = t25 * t48 - t37 * t49 - t0 * t50 + t51 * t38; /* K(2,4) */
            K[10 * 8 + j] = t37 * t50 - (t19 * t48 + t0 * t49) + t51 * t39; /* K(2,5) */
            K[11 * 8 + j] = t37 * t48 + t25 * t49 + t19 * t50 + t51 * t40; /* K(2,6) */
        }
    }
}

/* outputs: 49 operations.
 * in:  x (7), sigma (1), tau (2), p (7)
 * out: ahead (3), origin (3), axes (3,3) */
FLEXEL_CLONES
static void skate_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (7 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict ahead = out[0] + b * (3 * 8);
        real *restrict origin = out[1] + b * (3 * 8);
        real *restrict axes = out[2] + b * (9 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l0 = x[3 * 8 + j];
            const real t0 = r_l0 * r_l0;
            const real r_l1 = x[4 * 8 + j];
            const real t1 = r_l1 * r_l1;
            const real r_l2 = x[5 * 8 + j];
            const real t2 = r_l2 * r_l2;
            const real r_l3 = x[6 * 8 + j];
            const real t3 = r_l3 * r_l3;
            const real t4 = t0 + t1 - t2 - t3;
            axes[0 * 8 + j] = t4; /* axes(0,0) */
            const real blade_x = p[0 * 8 + j];
            const real t5 = r_l1 * r_l2;
            const real t6 = r_l0 * r_l3;
            const real t7 = t5 - t6;
            const real blade_y = p[1 * 8 + j];
            const real t8 = r_l0 * r_l2;
            const real t9 = r_l1 * r_l3;
            const real t10 = t8 + t9;
            const real blade_z = p[2 * 8 + j];
            const real b_x = blade_x * t4 + 2.0 * (blade_y * t7 + blade_z * t10);
            ahead[0 * 8 + j] = b_x;
            const real t11 = t0 + t2 - t1 - t3;
            axes[4 * 8 + j] = t11; /* axes(1,1) */
            const real t12 = t6 + t5;
            const real t13 = r_l2 * r_l3;
            const real t14 = r_l0 * r_l1;
            const real t15 = t13 - t14;
            const real b_y = blade_y * t11 + 2.0 * (blade_x * t12 + blade_z * t15);
            ahead[1 * 8 + j] = b_y;
            const real t16 = t0 + t3 - t1 - t2;
            axes[8 * 8 + j] = t16; /* axes(2,2) */
            const real t17 = t9 - t8;
            const real t18 = t14 + t13;
            const real b_z = blade_z * t16 + 2.0 * (blade_x * t17 + blade_y * t18);
            ahead[2 * 8 + j] = b_z;
            const real p_x = x[0 * 8 + j];
            origin[0 * 8 + j] = p_x;
            const real p_y = x[1 * 8 + j];
            origin[1 * 8 + j] = p_y;
            const real p_z = x[2 * 8 + j];
            origin[2 * 8 + j] = p_z;
            axes[1 * 8 + j] = 2.0 * t12; /* axes(0,1) */
            axes[2 * 8 + j] = 2.0 * t17; /* axes(0,2) */
            axes[3 * 8 + j] = 2.0 * t7; /* axes(1,0) */
            axes[5 * 8 + j] = 2.0 * t18; /* axes(1,2) */
            axes[6 * 8 + j] = 2.0 * t10; /* axes(2,0) */
            axes[7 * 8 + j] = 2.0 * t15; /* axes(2,1) */
        }
    }
}

const flexel_element flexel_skate = {
    .name = "skate",
    .digest = "824aba72e9635077",
    .n = 7,
    .m = 1,
    .k = 2,
    .np = 7,
    .position = skate_position,
    .acceleration = skate_acceleration,
    .rates = skate_rates,
    .kinematics = skate_kinematics,
    .stiffness = skate_stiffness,
    .outputs = skate_outputs,
};
