/* beam_span: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * (x, y, z) = l0 ((vp + vq)/2 + l0 (exdot_p - exdot_q)/12), rate of the integral of position over the
 * beam's cubic Hermite interpolation; ex: first columns of R(lambda_p o tp), R(lambda_q o tq)
 *
 * Source: textbook mechanics (consistent nodal forces)
 *
 * x (14): p_x, p_y, p_z, rp_l0, rp_l1, rp_l2, rp_l3, q_x, q_y, q_z, rq_l0, rq_l1, rq_l2, rq_l3
 * e (0): none
 * s (3): x [m^2/s], y [m^2/s], z [m^2/s]
 * p (9):
 *   l0 (1) [m]: undeformed length
 *   tp (4) [1]: unit quaternion from the body frame of node p to the element's triad there
 *   tq (4) [1]: unit quaternion from the body frame of node q to the element's triad there */
#include "kernels.h"

/* position: 169 operations.
 * in:  x (14), p (9)
 * out: e (0), De (0,14), V (3,14), 30 of 42 entries */
FLEXEL_CLONES
static void beam_span_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict p = in[1] + b * (9 * 8);
        real *restrict V = out[2] + b * (30 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            V[0 * 8 + j] = V[5 * 8 + j] = V[10 * 8 + j] = V[15 * 8 + j] = V[20 * 8 + j] = V[25 * 8 + j] = 0.5 * l0;
            const real rp_l0 = x[3 * 8 + j];
            const real tp_0 = p[1 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real tp_1 = p[2 * 8 + j];
            const real rp_l2 = x[5 * 8 + j];
            const real tp_2 = p[3 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real tp_3 = p[4 * 8 + j];
            const real t0 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real t1 = l0 * l0;
            const real t2 = t0 * t1;
            const real t3 = rp_l0 * tp_1 + rp_l2 * tp_3 + rp_l1 * tp_0 - rp_l3 * tp_2;
            const real t4 = t1 * t3;
            const real t5 = tp_0 * t2 + tp_1 * t4;
            const real t6 = rp_l0 * tp_3 + rp_l3 * tp_0 + rp_l1 * tp_2 - rp_l2 * tp_1;
            const real t7 = t1 * t6;
            const real t8 = tp_3 * t7;
            const real t9 = rp_l0 * tp_2 + rp_l3 * tp_1 + rp_l2 * tp_0 - rp_l1 * tp_3;
            const real t10 = t1 * t9;
            const real t11 = tp_2 * t10;
            V[1 * 8 + j] = 0.16666666666666666 * (t5 - t8 - t11);
            const real t12 = tp_3 * t10 + tp_0 * t4;
            const real t13 = tp_2 * t7;
            const real t14 = tp_1 * t2;
            V[2 * 8 + j] = 0.16666666666666666 * (t12 - t13 - t14);
            const real t15 = tp_1 * t7;
            const real t16 = tp_3 * t4;
            const real t17 = tp_0 * t10;
            const real t18 = tp_2 * t2;
            V[3 * 8 + j] = 0.16666666666666666 * (t15 + t16 - t17 - t18);
            const real t19 = 0.16666666666666666 * (tp_0 * t7 + tp_1 * t10 + tp_3 * t2 + tp_2 * t4);
            V[11 * 8 + j] = V[22 * 8 + j] = t19;
            V[4 * 8 + j] = -t19;
            const real rq_l1 = x[11 * 8 + j];
            const real tq_2 = p[7 * 8 + j];
            const real rq_l0 = x[10 * 8 + j];
            const real tq_3 = p[8 * 8 + j];
            const real rq_l3 = x[13 * 8 + j];
            const real tq_0 = p[5 * 8 + j];
            const real rq_l2 = x[12 * 8 + j];
            const real tq_1 = p[6 * 8 + j];
            const real t20 = rq_l0 * tq_3 + rq_l3 * tq_0 + rq_l1 * tq_2 - rq_l2 * tq_1;
            const real t21 = t1 * t20;
            const real t22 = tq_3 * t21;
            const real t23 = rq_l0 * tq_2 + rq_l3 * tq_1 + rq_l2 * tq_0 - rq_l1 * tq_3;
            const real t24 = t1 * t23;
            const real t25 = tq_2 * t24;
            const real t26 = rq_l0 * tq_1 + rq_l2 * tq_3 + rq_l1 * tq_0 - rq_l3 * tq_2;
            const real t27 = t1 * t26;
            const real t28 = tq_1 * t27;
            const real t29 = rq_l0 * tq_0 - rq_l1 * tq_1 - rq_l2 * tq_2 - rq_l3 * tq_3;
            const real t30 = t29 * t1;
            const real t31 = tq_0 * t30;
            V[6 * 8 + j] = 0.16666666666666666 * (t22 + t25 - t28 - t31);
            const real t32 = tq_1 * t30 + tq_2 * t21;
            const real t33 = tq_3 * t24;
            const real t34 = tq_0 * t27;
            V[7 * 8 + j] = 0.16666666666666666 * (t32 - t33 - t34);
            const real t35 = tq_2 * t30;
            const real t36 = tq_0 * t24;
            const real t37 = tq_1 * t21;
            const real t38 = tq_3 * t27;
            V[8 * 8 + j] = 0.16666666666666666 * (t35 + t36 - t37 - t38);
            const real t39 = 0.16666666666666666 * (tq_0 * t21 + tq_1 * t24 + tq_3 * t30 + tq_2 * t27);
            V[9 * 8 + j] = t39;
            const real t40 = 0.16666666666666666 * (t18 - t16);
            const real t41 = 0.16666666666666666 * t17;
            const real t42 = 0.16666666666666666 * t15;
            V[12 * 8 + j] = t40 + t41 - t42;
            V[13 * 8 + j] = V[24 * 8 + j] = 0.16666666666666666 * (t12 - t14 - t13);
            const real t43 = 0.16666666666666666 * t5;
            const real t44 = 0.16666666666666666 * t11;
            const real t45 = 0.16666666666666666 * t8;
            V[14 * 8 + j] = t43 - t44 - t45;
            V[16 * 8 + j] = V[27 * 8 + j] = -t39;
            const real t46 = 0.16666666666666666 * (t38 - t35);
            const real t47 = 0.16666666666666666 * t37;
            const real t48 = 0.16666666666666666 * t36;
            V[17 * 8 + j] = t46 + t47 - t48;
            V[18 * 8 + j] = V[29 * 8 + j] = 0.16666666666666666 * (t32 - t34 - t33);
            const real t49 = 0.16666666666666666 * t25;
            const real t50 = 0.16666666666666666 * t22;
            const real t51 = 0.16666666666666666 * (t31 + t28);
            V[19 * 8 + j] = t49 + t50 - t51;
            V[21 * 8 + j] = t42 - t40 - t41;
            V[23 * 8 + j] = t44 + t45 - t43;
            V[26 * 8 + j] = t48 - t46 - t47;
            V[28 * 8 + j] = t51 - t50 - t49;
        }
    }
}

/* velocity: 175 operations.
 * in:  x (14), v (14), p (9)
 * out: ed (0), s (3) */
FLEXEL_CLONES
static void beam_span_velocity(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (14 * 8);
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict s = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real p_vx = v[0 * 8 + j];
            const real q_vx = v[7 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real tp_3 = p[4 * 8 + j];
            const real rp_vl0 = v[3 * 8 + j];
            const real tp_1 = p[2 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real tp_0 = p[1 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real tp_2 = p[3 * 8 + j];
            const real t0 = rp_vl0 * tp_1 + rp_vl1 * tp_0 + rp_vl2 * tp_3 - rp_vl3 * tp_2;
            const real rp_l2 = x[5 * 8 + j];
            const real rp_l0 = x[3 * 8 + j];
            const real rp_l1 = x[4 * 8 + j];
            const real rp_l3 = x[6 * 8 + j];
            const real t1 = rp_l0 * tp_1 + rp_l1 * tp_0 + rp_l2 * tp_3 - rp_l3 * tp_2;
            const real t2 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t3 = rp_l0 * tp_0 - rp_l1 * tp_1 - rp_l2 * tp_2 - rp_l3 * tp_3;
            const real rq_vl3 = v[13 * 8 + j];
            const real tq_0 = p[5 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real tq_3 = p[8 * 8 + j];
            const real rq_vl1 = v[11 * 8 + j];
            const real tq_2 = p[7 * 8 + j];
            const real rq_vl2 = v[12 * 8 + j];
            const real tq_1 = p[6 * 8 + j];
            const real t4 = rq_vl0 * tq_3 + rq_vl1 * tq_2 + rq_vl3 * tq_0 - rq_vl2 * tq_1;
            const real rq_l3 = x[13 * 8 + j];
            const real rq_l0 = x[10 * 8 + j];
            const real rq_l1 = x[11 * 8 + j];
            const real rq_l2 = x[12 * 8 + j];
            const real t5 = rq_l0 * tq_3 + rq_l1 * tq_2 + rq_l3 * tq_0 - rq_l2 * tq_1;
            const real t6 = rq_vl0 * tq_2 + rq_vl2 * tq_0 + rq_vl3 * tq_1 - rq_vl1 * tq_3;
            const real t7 = rq_l0 * tq_2 + rq_l2 * tq_0 + rq_l3 * tq_1 - rq_l1 * tq_3;
            const real t8 = rp_vl0 * tp_2 + rp_vl2 * tp_0 + rp_vl3 * tp_1 - rp_vl1 * tp_3;
            const real t9 = rp_l0 * tp_2 + rp_l2 * tp_0 + rp_l3 * tp_1 - rp_l1 * tp_3;
            const real t10 = rp_vl0 * tp_3 + rp_vl1 * tp_2 + rp_vl3 * tp_0 - rp_vl2 * tp_1;
            const real t11 = rp_l0 * tp_3 + rp_l1 * tp_2 + rp_l3 * tp_0 - rp_l2 * tp_1;
            const real t12 = t4 * t5 + t6 * t7 + t2 * t3 + t0 * t1 - t8 * t9 - t10 * t11;
            const real t13 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t14 = rq_l0 * tq_0 - rq_l1 * tq_1 - rq_l2 * tq_2 - rq_l3 * tq_3;
            const real t15 = rq_vl0 * tq_1 + rq_vl1 * tq_0 + rq_vl2 * tq_3 - rq_vl3 * tq_2;
            const real t16 = rq_l0 * tq_1 + rq_l1 * tq_0 + rq_l2 * tq_3 - rq_l3 * tq_2;
            const real l0 = p[0 * 8 + j];
            const real t17 = 0.16666666666666666 * (l0 * (t12 - t13 * t14 - t15 * t16));
            s[0 * 8 + j] = l0 * (0.5 * (p_vx + q_vx) + t17);
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[8 * 8 + j];
            const real t18 = t10 * t3 + t8 * t1 + t2 * t11 + t0 * t9 - t13 * t5 - t15 * t7;
            const real t19 = 0.5 * (p_vy + q_vy) + 0.16666666666666666 * (l0 * (t18 - t4 * t14 - t6 * t16));
            s[1 * 8 + j] = l0 * t19;
            const real p_vz = v[2 * 8 + j];
            const real q_vz = v[9 * 8 + j];
            const real t20 = t6 * t14 + t13 * t7 + t10 * t1 + t0 * t11 - t8 * t3 - t2 * t9;
            const real t21 = 0.5 * (p_vz + q_vz) + 0.16666666666666666 * (l0 * (t20 - t4 * t16 - t15 * t5));
            s[2 * 8 + j] = l0 * t21;
        }
    }
}

/* acceleration: 96 operations.
 * in:  x (14), v (14), p (9)
 * out: g (0), gs (3) */
FLEXEL_CLONES
static void beam_span_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict gs = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = l0 * l0;
            const real rq_vl2 = v[12 * 8 + j];
            const real tq_0 = p[5 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real tq_2 = p[7 * 8 + j];
            const real rq_vl3 = v[13 * 8 + j];
            const real tq_1 = p[6 * 8 + j];
            const real rq_vl1 = v[11 * 8 + j];
            const real tq_3 = p[8 * 8 + j];
            const real t1 = rq_vl0 * tq_2 + rq_vl3 * tq_1 + rq_vl2 * tq_0 - rq_vl1 * tq_3;
            const real t2 = rq_vl0 * tq_3 + rq_vl3 * tq_0 + rq_vl1 * tq_2 - rq_vl2 * tq_1;
            const real rp_vl0 = v[3 * 8 + j];
            const real tp_0 = p[1 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real tp_1 = p[2 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real tp_2 = p[3 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real tp_3 = p[4 * 8 + j];
            const real t3 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t4 = rp_vl0 * tp_1 + rp_vl2 * tp_3 + rp_vl1 * tp_0 - rp_vl3 * tp_2;
            const real t5 = rp_vl0 * tp_2 + rp_vl3 * tp_1 + rp_vl2 * tp_0 - rp_vl1 * tp_3;
            const real t6 = rp_vl0 * tp_3 + rp_vl3 * tp_0 + rp_vl1 * tp_2 - rp_vl2 * tp_1;
            const real t7 = t3 * t3 + t4 * t4 + t2 * t2 + t1 * t1 - t5 * t5 - t6 * t6;
            const real t8 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t9 = rq_vl0 * tq_1 + rq_vl2 * tq_3 + rq_vl1 * tq_0 - rq_vl3 * tq_2;
            gs[0 * 8 + j] = 0.16666666666666666 * (t0 * (t7 - t8 * t8 - t9 * t9));
            const real t10 = t4 * t5;
            const real t11 = t3 * t6;
            const real t12 = t8 * t2;
            const real t13 = t9 * t1;
            gs[1 * 8 + j] = 0.16666666666666666 * (t0 * (t11 + t10 + t11 + t10 - t12 - t13 - t12 - t13));
            gs[2 * 8 + j] = 0.3333333333333333 * (t0 * (t4 * t6 - t9 * t2 + t8 * t1 - t3 * t5));
        }
    }
}

/* kinematics: 398 operations.
 * in:  x (14), v (14), a (14), p (9)
 * out: Phi_x (3,14), 24 of 42 entries, Psi_x (3,14), 24 of 42 entries, Psi_v (3,14), 24 of 42 entries */
FLEXEL_CLONES
static void beam_span_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict a = in[2] + b * (14 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict Phi_x = out[0] + b * (24 * 8);
        real *restrict Psi_x = out[1] + b * (24 * 8);
        real *restrict Psi_v = out[2] + b * (24 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vl0 = v[3 * 8 + j];
            const real tp_0 = p[1 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real tp_1 = p[2 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real tp_2 = p[3 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real tp_3 = p[4 * 8 + j];
            const real t0 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real l0 = p[0 * 8 + j];
            const real t1 = l0 * l0;
            const real t2 = t0 * t1;
            const real t3 = rp_vl0 * tp_1 + rp_vl2 * tp_3 + rp_vl1 * tp_0 - rp_vl3 * tp_2;
            const real t4 = t1 * t3;
            const real t5 = tp_0 * t2 + tp_1 * t4;
            const real t6 = 0.16666666666666666 * t5;
            const real t7 = rp_vl0 * tp_3 + rp_vl3 * tp_0 + rp_vl1 * tp_2 - rp_vl2 * tp_1;
            const real t8 = t1 * t7;
            const real t9 = tp_3 * t8;
            const real t10 = 0.16666666666666666 * t9;
            const real t11 = rp_vl0 * tp_2 + rp_vl3 * tp_1 + rp_vl2 * tp_0 - rp_vl1 * tp_3;
            const real t12 = t1 * t11;
            const real t13 = tp_2 * t12;
            const real t14 = 0.16666666666666666 * t13;
            Phi_x[0 * 8 + j] = t6 - t10 - t14;
            const real t15 = tp_3 * t12;
            const real t16 = tp_0 * t4;
            const real t17 = 0.16666666666666666 * (t15 + t16);
            const real t18 = tp_2 * t8;
            const real t19 = 0.16666666666666666 * t18;
            const real t20 = tp_1 * t2;
            const real t21 = 0.16666666666666666 * t20;
            Phi_x[1 * 8 + j] = t17 - t19 - t21;
            const real t22 = tp_1 * t8;
            const real t23 = 0.16666666666666666 * t22;
            const real t24 = tp_3 * t4;
            const real t25 = 0.16666666666666666 * t24;
            const real t26 = tp_0 * t12;
            const real t27 = 0.16666666666666666 * t26;
            const real t28 = tp_2 * t2;
            const real t29 = 0.16666666666666666 * t28;
            Phi_x[2 * 8 + j] = t23 + t25 - t27 - t29;
            const real t30 = tp_3 * t2;
            const real t31 = tp_2 * t4;
            const real t32 = tp_0 * t8;
            const real t33 = tp_1 * t12;
            const real t34 = 0.16666666666666666 * t30 + 0.16666666666666666 * t31 + 0.16666666666666666 * (t32 + t33);
            Phi_x[8 * 8 + j] = Phi_x[17 * 8 + j] = t34;
            Phi_x[3 * 8 + j] = -t34;
            const real rq_vl1 = v[11 * 8 + j];
            const real tq_2 = p[7 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real tq_3 = p[8 * 8 + j];
            const real rq_vl3 = v[13 * 8 + j];
            const real tq_0 = p[5 * 8 + j];
            const real rq_vl2 = v[12 * 8 + j];
            const real tq_1 = p[6 * 8 + j];
            const real t35 = rq_vl0 * tq_3 + rq_vl3 * tq_0 + rq_vl1 * tq_2 - rq_vl2 * tq_1;
            const real t36 = t1 * t35;
            const real t37 = tq_3 * t36;
            const real t38 = 0.16666666666666666 * t37;
            const real t39 = rq_vl0 * tq_2 + rq_vl3 * tq_1 + rq_vl2 * tq_0 - rq_vl1 * tq_3;
            const real t40 = t1 * t39;
            const real t41 = tq_2 * t40;
            const real t42 = 0.16666666666666666 * t41;
            const real t43 = t38 + t42;
            const real t44 = rq_vl0 * tq_1 + rq_vl2 * tq_3 + rq_vl1 * tq_0 - rq_vl3 * tq_2;
            const real t45 = t1 * t44;
            const real t46 = tq_1 * t45;
            const real t47 = 0.16666666666666666 * t46;
            const real t48 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t49 = t48 * t1;
            const real t50 = tq_0 * t49;
            const real t51 = 0.16666666666666666 * t50;
            Phi_x[4 * 8 + j] = t43 - t47 - t51;
            const real t52 = tq_1 * t49;
            const real t53 = tq_2 * t36;
            const real t54 = 0.16666666666666666 * (t52 + t53);
            const real t55 = tq_3 * t40;
            const real t56 = 0.16666666666666666 * t55;
            const real t57 = tq_0 * t45;
            const real t58 = 0.16666666666666666 * t57;
            Phi_x[5 * 8 + j] = t54 - t56 - t58;
            const real t59 = tq_2 * t49;
            const real t60 = 0.16666666666666666 * t59;
            const real t61 = tq_0 * t40;
            const real t62 = 0.16666666666666666 * t61;
            const real t63 = tq_1 * t36;
            const real t64 = 0.16666666666666666 * t63;
            const real t65 = tq_3 * t45;
            const real t66 = 0.16666666666666666 * t65;
            Phi_x[6 * 8 + j] = t60 + t62 - t64 - t66;
            const real t67 = tq_3 * t49;
            const real t68 = tq_2 * t45;
            const real t69 = tq_0 * t36;
            const real t70 = tq_1 * t40;
            const real t71 = 0.16666666666666666 * t67 + 0.16666666666666666 * t68 + 0.16666666666666666 * (t69 + t70);
            Phi_x[7 * 8 + j] = t71;
            const real t72 = t29 - t25;
            Phi_x[9 * 8 + j] = t27 + t72 - t23;
            Phi_x[10 * 8 + j] = Phi_x[19 * 8 + j] = t17 - t21 - t19;
            Phi_x[11 * 8 + j] = t6 - t14 - t10;
            Phi_x[12 * 8 + j] = Phi_x[21 * 8 + j] = -t71;
            const real t73 = t66 - t60;
            Phi_x[13 * 8 + j] = t64 + t73 - t62;
            Phi_x[14 * 8 + j] = Phi_x[23 * 8 + j] = t54 - t58 - t56;
            const real t74 = t51 + t47;
            Phi_x[15 * 8 + j] = t43 - t74;
            Phi_x[16 * 8 + j] = t23 - t72 - t27;
            Phi_x[18 * 8 + j] = t10 + t14 - t6;
            Phi_x[20 * 8 + j] = t62 - t64 - t73;
            Phi_x[22 * 8 + j] = t74 - t38 - t42;
            const real rp_al0 = a[3 * 8 + j];
            const real rp_al1 = a[4 * 8 + j];
            const real rp_al2 = a[5 * 8 + j];
            const real rp_al3 = a[6 * 8 + j];
            const real t75 = tp_0 * rp_al0 - tp_1 * rp_al1 - tp_2 * rp_al2 - tp_3 * rp_al3;
            const real t76 = t1 * t75;
            const real t77 = tp_1 * rp_al0 + tp_3 * rp_al2 + tp_0 * rp_al1 - tp_2 * rp_al3;
            const real t78 = t1 * t77;
            const real t79 = 0.16666666666666666 * (tp_0 * t76 + tp_1 * t78);
            const real t80 = tp_3 * rp_al0 + tp_0 * rp_al3 + tp_2 * rp_al1 - tp_1 * rp_al2;
            const real t81 = t1 * t80;
            const real t82 = 0.16666666666666666 * (tp_3 * t81);
            const real t83 = tp_2 * rp_al0 + tp_1 * rp_al3 + tp_0 * rp_al2 - tp_3 * rp_al1;
            const real t84 = t1 * t83;
            const real t85 = 0.16666666666666666 * (tp_2 * t84);
            Psi_x[0 * 8 + j] = t79 - t82 - t85;
            const real t86 = 0.16666666666666666 * (tp_3 * t84 + tp_0 * t78);
            const real t87 = 0.16666666666666666 * (tp_2 * t81);
            const real t88 = 0.16666666666666666 * (tp_1 * t76);
            Psi_x[1 * 8 + j] = t86 - t87 - t88;
            const real t89 = 0.16666666666666666 * (tp_1 * t81);
            const real t90 = 0.16666666666666666 * (tp_3 * t78);
            const real t91 = 0.16666666666666666 * (tp_0 * t84);
            const real t92 = 0.16666666666666666 * (tp_2 * t76);
            Psi_x[2 * 8 + j] = t89 + t90 - t91 - t92;
            const real t93 = 0.16666666666666666 * (tp_3 * t76) + 0.16666666666666666 * (tp_2 * t78);
            const real t94 = t93 + 0.16666666666666666 * (tp_0 * t81 + tp_1 * t84);
            Psi_x[8 * 8 + j] = Psi_x[17 * 8 + j] = t94;
            Psi_x[3 * 8 + j] = -t94;
            const real rq_al1 = a[11 * 8 + j];
            const real rq_al0 = a[10 * 8 + j];
            const real rq_al3 = a[13 * 8 + j];
            const real rq_al2 = a[12 * 8 + j];
            const real t95 = tq_3 * rq_al0 + tq_0 * rq_al3 + tq_2 * rq_al1 - tq_1 * rq_al2;
            const real t96 = t1 * t95;
            const real t97 = 0.16666666666666666 * (tq_3 * t96);
            const real t98 = tq_2 * rq_al0 + tq_1 * rq_al3 + tq_0 * rq_al2 - tq_3 * rq_al1;
            const real t99 = t1 * t98;
            const real t100 = 0.16666666666666666 * (tq_2 * t99);
            const real t101 = t97 + t100;
            const real t102 = tq_1 * rq_al0 + tq_3 * rq_al2 + tq_0 * rq_al1 - tq_2 * rq_al3;
            const real t103 = t1 * t102;
            const real t104 = 0.16666666666666666 * (tq_1 * t103);
            const real t105 = tq_0 * rq_al0 - tq_1 * rq_al1 - tq_2 * rq_al2 - tq_3 * rq_al3;
            const real t106 = t1 * t105;
            const real t107 = 0.16666666666666666 * (tq_0 * t106);
            Psi_x[4 * 8 + j] = t101 - t104 - t107;
            const real t108 = 0.16666666666666666 * (tq_1 * t106 + tq_2 * t96);
            const real t109 = 0.16666666666666666 * (tq_3 * t99);
            const real t110 = 0.16666666666666666 * (tq_0 * t103);
            Psi_x[5 * 8 + j] = t108 - t109 - t110;
            const real t111 = 0.16666666666666666 * (tq_2 * t106);
            const real t112 = 0.16666666666666666 * (tq_0 * t99);
            const real t113 = 0.16666666666666666 * (tq_1 * t96);
            const real t114 = 0.16666666666666666 * (tq_3 * t103);
            Psi_x[6 * 8 + j] = t111 + t112 - t113 - t114;
            const real t115 = 0.16666666666666666 * (tq_3 * t106) + 0.16666666666666666 * (tq_2 * t103);
            const real t116 = t115 + 0.16666666666666666 * (tq_0 * t96 + tq_1 * t99);
            Psi_x[7 * 8 + j] = t116;
            const real t117 = t92 - t90;
            Psi_x[9 * 8 + j] = t91 + t117 - t89;
            Psi_x[10 * 8 + j] = Psi_x[19 * 8 + j] = t86 - t88 - t87;
            Psi_x[11 * 8 + j] = t79 - t85 - t82;
            Psi_x[12 * 8 + j] = Psi_x[21 * 8 + j] = -t116;
            const real t118 = t114 - t111;
            Psi_x[13 * 8 + j] = t113 + t118 - t112;
            Psi_x[14 * 8 + j] = Psi_x[23 * 8 + j] = t108 - t110 - t109;
            const real t119 = t107 + t104;
            Psi_x[15 * 8 + j] = t101 - t119;
            Psi_x[16 * 8 + j] = t89 - t117 - t91;
            Psi_x[18 * 8 + j] = t82 + t85 - t79;
            Psi_x[20 * 8 + j] = t112 - t113 - t118;
            Psi_x[22 * 8 + j] = t119 - t97 - t100;
            const real t120 = 0.3333333333333333 * t5;
            const real t121 = 0.3333333333333333 * t9;
            const real t122 = 0.3333333333333333 * t13;
            Psi_v[0 * 8 + j] = t120 - t121 - t122;
            Psi_v[1 * 8 + j] = Psi_v[10 * 8 + j] = Psi_v[19 * 8 + j] = 0.3333333333333333 * (t16 - t20 + t15 - t18);
            const real t123 = 0.3333333333333333 * t22;
            const real t124 = 0.3333333333333333 * (t28 - t24);
            const real t125 = 0.3333333333333333 * t26;
            Psi_v[2 * 8 + j] = Psi_v[16 * 8 + j] = t123 - t124 - t125;
            const real t126 = 0.3333333333333333 * t32 + 0.3333333333333333 * t33 + 0.3333333333333333 * (t30 + t31);
            Psi_v[8 * 8 + j] = Psi_v[17 * 8 + j] = t126;
            Psi_v[3 * 8 + j] = -t126;
            const real t127 = 0.3333333333333333 * t37;
            const real t128 = 0.3333333333333333 * t41;
            const real t129 = 0.3333333333333333 * (t50 + t46);
            Psi_v[4 * 8 + j] = Psi_v[15 * 8 + j] = t127 + t128 - t129;
            Psi_v[5 * 8 + j] = Psi_v[14 * 8 + j] = Psi_v[23 * 8 + j] = 0.3333333333333333 * (t52 - t57 + t53 - t55);
            const real t130 = 0.3333333333333333 * t61;
            const real t131 = 0.3333333333333333 * (t65 - t59);
            const real t132 = 0.3333333333333333 * t63;
            Psi_v[6 * 8 + j] = Psi_v[20 * 8 + j] = t130 - t131 - t132;
            const real t133 = 0.3333333333333333 * t69 + 0.3333333333333333 * t70 + 0.3333333333333333 * (t67 + t68);
            Psi_v[7 * 8 + j] = t133;
            Psi_v[9 * 8 + j] = t125 + t124 - t123;
            Psi_v[11 * 8 + j] = t120 - t122 - t121;
            Psi_v[12 * 8 + j] = Psi_v[21 * 8 + j] = -t133;
            Psi_v[13 * 8 + j] = t132 + t131 - t130;
            Psi_v[18 * 8 + j] = t121 + t122 - t120;
            Psi_v[22 * 8 + j] = t129 - t127 - t128;
        }
    }
}

/* stiffness: 326 operations.
 * in:  x (14), sigma (0), tau (3), p (9)
 * out: K (14,14), 32 of 196 entries */
FLEXEL_CLONES
static void beam_span_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict tau = in[2] + b * (3 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict K = out[0] + b * (32 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = l0 * l0;
            const real tau_y = tau[1 * 8 + j];
            const real t1 = tau_y * t0;
            const real tp_3 = p[4 * 8 + j];
            const real t2 = 0.16666666666666666 * (tp_3 * t1);
            const real tau_z = tau[2 * 8 + j];
            const real t3 = tau_z * t0;
            const real tp_2 = p[3 * 8 + j];
            const real t4 = 0.16666666666666666 * (tp_2 * t3);
            const real t5 = t2 - t4;
            const real tau_x = tau[0 * 8 + j];
            const real t6 = tau_x * t0;
            const real tp_0 = p[1 * 8 + j];
            const real t7 = 0.16666666666666666 * (tp_0 * t6);
            const real t8 = t5 + t7;
            const real t9 = 0.16666666666666666 * (tp_3 * t3);
            const real t10 = 0.16666666666666666 * (tp_2 * t1);
            const real t11 = t9 + t10;
            const real tp_1 = p[2 * 8 + j];
            const real t12 = 0.16666666666666666 * (tp_1 * t6);
            const real t13 = t11 + t12;
            const real t14 = 0.16666666666666666 * (tp_1 * t3);
            const real t15 = 0.16666666666666666 * (tp_0 * t1);
            const real t16 = t14 + t15;
            const real t17 = 0.16666666666666666 * (tp_3 * t6);
            const real t18 = t16 - t17;
            const real t19 = 0.16666666666666666 * (tp_1 * t1);
            const real t20 = 0.16666666666666666 * (tp_0 * t3);
            const real t21 = t19 - t20;
            const real t22 = 0.16666666666666666 * (tp_2 * t6);
            const real t23 = t21 - t22;
            K[0 * 8 + j] = tp_3 * t18 + tp_2 * t23 + tp_1 * t13 + tp_0 * t8;
            K[1 * 8 + j] = tp_2 * t18 + tp_0 * t13 - tp_3 * t23 - tp_1 * t8;
            K[2 * 8 + j] = tp_0 * t23 + tp_3 * t13 - tp_1 * t18 - tp_2 * t8;
            K[3 * 8 + j] = tp_0 * t18 + tp_1 * t23 - tp_2 * t13 - tp_3 * t8;
            const real t24 = t11 - t12;
            const real t25 = t16 + t17;
            const real t26 = t7 - t5;
            const real t27 = t21 + t22;
            K[4 * 8 + j] = tp_2 * t25 + tp_1 * t26 + tp_0 * t24 - tp_3 * t27;
            K[5 * 8 + j] = tp_0 * t26 - tp_2 * t27 - tp_3 * t25 - tp_1 * t24;
            K[6 * 8 + j] = tp_1 * t27 + tp_0 * t25 + tp_3 * t26 - tp_2 * t24;
            K[7 * 8 + j] = tp_1 * t25 - tp_0 * t27 - tp_2 * t26 - tp_3 * t24;
            const real t28 = t15 - t14;
            const real t29 = t17 + t28;
            const real t30 = t9 - t10;
            const real t31 = t12 + t30;
            const real t32 = t4 + t2;
            const real t33 = t32 - t7;
            const real t34 = t20 + t19;
            const real t35 = t22 + t34;
            K[8 * 8 + j] = tp_3 * t31 + tp_2 * t33 + tp_1 * t29 - tp_0 * t35;
            K[9 * 8 + j] = tp_2 * t31 + tp_0 * t29 + tp_1 * t35 - tp_3 * t33;
            K[10 * 8 + j] = tp_0 * t33 + tp_3 * t29 + tp_2 * t35 - tp_1 * t31;
            K[11 * 8 + j] = tp_0 * t31 + tp_1 * t33 + tp_3 * t35 - tp_2 * t29;
            const real t36 = t28 - t17;
            const real t37 = t30 - t12;
            const real t38 = t34 - t22;
            const real t39 = t7 + t32;
            K[12 * 8 + j] = tp_2 * t37 + tp_1 * t38 + tp_0 * t36 - tp_3 * t39;
            K[13 * 8 + j] = tp_0 * t38 - tp_2 * t39 - tp_3 * t37 - tp_1 * t36;
            K[14 * 8 + j] = tp_1 * t39 + tp_0 * t37 + tp_3 * t38 - tp_2 * t36;
            K[15 * 8 + j] = tp_1 * t37 - tp_0 * t39 - tp_2 * t38 - tp_3 * t36;
            const real tq_2 = p[7 * 8 + j];
            const real t40 = 0.16666666666666666 * (tq_2 * t3);
            const real tq_3 = p[8 * 8 + j];
            const real t41 = 0.16666666666666666 * (tq_3 * t1);
            const real t42 = t40 - t41;
            const real tq_0 = p[5 * 8 + j];
            const real t43 = 0.16666666666666666 * (tq_0 * t6);
            const real t44 = t42 - t43;
            const real t45 = 0.16666666666666666 * (tq_3 * t6);
            const real tq_1 = p[6 * 8 + j];
            const real t46 = 0.16666666666666666 * (tq_1 * t3);
            const real t47 = 0.16666666666666666 * (tq_0 * t1);
            const real t48 = t46 + t47;
            const real t49 = t45 - t48;
            const real t50 = 0.16666666666666666 * (tq_0 * t3);
            const real t51 = 0.16666666666666666 * (tq_1 * t1);
            const real t52 = t50 - t51;
            const real t53 = 0.16666666666666666 * (tq_2 * t6);
            const real t54 = t52 + t53;
            const real t55 = 0.16666666666666666 * (tq_3 * t3);
            const real t56 = 0.16666666666666666 * (tq_2 * t1);
            const real t57 = t55 + t56;
            const real t58 = 0.16666666666666666 * (tq_1 * t6);
            const real t59 = t57 + t58;
            K[16 * 8 + j] = tq_3 * t49 + tq_2 * t54 + tq_0 * t44 - tq_1 * t59;
            K[17 * 8 + j] = tq_2 * t49 - tq_3 * t54 - tq_0 * t59 - tq_1 * t44;
            K[18 * 8 + j] = tq_0 * t54 - tq_1 * t49 - tq_3 * t59 - tq_2 * t44;
            K[19 * 8 + j] = tq_0 * t49 + tq_1 * t54 + tq_2 * t59 - tq_3 * t44;
            const real t60 = t53 - t52;
            const real t61 = t58 - t57;
            const real t62 = t48 + t45;
            const real t63 = t42 + t43;
            K[20 * 8 + j] = tq_3 * t60 + tq_0 * t61 - tq_2 * t62 - tq_1 * t63;
            K[21 * 8 + j] = tq_2 * t60 + tq_3 * t62 - tq_0 * t63 - tq_1 * t61;
            K[22 * 8 + j] = -(tq_1 * t60 + tq_0 * t62 + tq_3 * t63 + tq_2 * t61);
            K[23 * 8 + j] = tq_0 * t60 + tq_2 * t63 - tq_1 * t62 - tq_3 * t61;
            const real t64 = t40 + t41;
            const real t65 = t43 - t64;
            const real t66 = t50 + t51;
            const real t67 = t53 + t66;
            const real t68 = t55 - t56;
            const real t69 = t58 + t68;
            const real t70 = t47 - t46;
            const real t71 = t45 + t70;
            K[24 * 8 + j] = tq_2 * t65 + tq_0 * t67 - tq_3 * t69 - tq_1 * t71;
            K[25 * 8 + j] = -(tq_2 * t69 + tq_3 * t65 + tq_0 * t71 + tq_1 * t67);
            K[26 * 8 + j] = tq_1 * t69 + tq_0 * t65 - tq_3 * t71 - tq_2 * t67;
            K[27 * 8 + j] = tq_1 * t65 + tq_2 * t71 - tq_0 * t69 - tq_3 * t67;
            const real t72 = t45 - t70;
            const real t73 = t43 + t64;
            const real t74 = t58 - t68;
            const real t75 = t66 - t53;
            K[28 * 8 + j] = tq_3 * t73 + tq_2 * t74 + tq_0 * t72 - tq_1 * t75;
            K[29 * 8 + j] = tq_2 * t73 - tq_3 * t74 - tq_0 * t75 - tq_1 * t72;
            K[30 * 8 + j] = tq_0 * t74 - tq_1 * t73 - tq_3 * t75 - tq_2 * t72;
            K[31 * 8 + j] = tq_0 * t73 + tq_1 * t74 + tq_2 * t75 - tq_3 * t72;
        }
    }
}

const flexel_element flexel_beam_span = {
    .name = "beam_span",
    .digest = "10150c5a84d3bc2e",
    .n = 14,
    .m = 0,
    .k = 3,
    .np = 9,
    .position = beam_span_position,
    .velocity = beam_span_velocity,
    .acceleration = beam_span_acceleration,
    .kinematics = beam_span_kinematics,
    .stiffness = beam_span_stiffness,
};
