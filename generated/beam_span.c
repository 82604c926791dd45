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
                /* V(0,0) V(0,7) V(1,1) V(1,8) V(2,2) V(2,9) */
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
            V[1 * 8 + j] = 0.16666666666666666 * (t5 - t8 - t11); /* V(0,3) */
            const real t12 = tp_3 * t10 + tp_0 * t4;
            const real t13 = tp_2 * t7;
            const real t14 = tp_1 * t2;
            V[2 * 8 + j] = 0.16666666666666666 * (t12 - t13 - t14); /* V(0,4) */
            const real t15 = tp_1 * t7;
            const real t16 = tp_3 * t4;
            const real t17 = tp_0 * t10;
            const real t18 = tp_2 * t2;
            V[3 * 8 + j] = 0.16666666666666666 * (t15 + t16 - t17 - t18); /* V(0,5) */
            const real t19 = 0.16666666666666666 * (tp_0 * t7 + tp_1 * t10 + tp_3 * t2 + tp_2 * t4);
            V[11 * 8 + j] = V[22 * 8 + j] = t19; /* V(1,3) V(2,4) */
            V[4 * 8 + j] = -t19; /* V(0,6) */
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
            V[6 * 8 + j] = 0.16666666666666666 * (t22 + t25 - t28 - t31); /* V(0,10) */
            const real t32 = tq_1 * t30 + tq_2 * t21;
            const real t33 = tq_3 * t24;
            const real t34 = tq_0 * t27;
            V[7 * 8 + j] = 0.16666666666666666 * (t32 - t33 - t34); /* V(0,11) */
            const real t35 = tq_2 * t30;
            const real t36 = tq_0 * t24;
            const real t37 = tq_1 * t21;
            const real t38 = tq_3 * t27;
            V[8 * 8 + j] = 0.16666666666666666 * (t35 + t36 - t37 - t38); /* V(0,12) */
            const real t39 = 0.16666666666666666 * (tq_0 * t21 + tq_1 * t24 + tq_3 * t30 + tq_2 * t27);
            V[9 * 8 + j] = t39; /* V(0,13) */
            const real t40 = 0.16666666666666666 * (t18 - t16);
            const real t41 = 0.16666666666666666 * t17;
            const real t42 = 0.16666666666666666 * t15;
            V[12 * 8 + j] = t40 + t41 - t42; /* V(1,4) */
            V[13 * 8 + j] = V[24 * 8 + j] = 0.16666666666666666 * (t12 - t14 - t13); /* V(1,5) V(2,6) */
            const real t43 = 0.16666666666666666 * t5;
            const real t44 = 0.16666666666666666 * t11;
            const real t45 = 0.16666666666666666 * t8;
            V[14 * 8 + j] = t43 - t44 - t45; /* V(1,6) */
            V[16 * 8 + j] = V[27 * 8 + j] = -t39; /* V(1,10) V(2,11) */
            const real t46 = 0.16666666666666666 * (t38 - t35);
            const real t47 = 0.16666666666666666 * t37;
            const real t48 = 0.16666666666666666 * t36;
            V[17 * 8 + j] = t46 + t47 - t48; /* V(1,11) */
            V[18 * 8 + j] = V[29 * 8 + j] = 0.16666666666666666 * (t32 - t34 - t33); /* V(1,12) V(2,13) */
            const real t49 = 0.16666666666666666 * t25;
            const real t50 = 0.16666666666666666 * t22;
            const real t51 = 0.16666666666666666 * (t31 + t28);
            V[19 * 8 + j] = t49 + t50 - t51; /* V(1,13) */
            V[21 * 8 + j] = t42 - t40 - t41; /* V(2,3) */
            V[23 * 8 + j] = t44 + t45 - t43; /* V(2,5) */
            V[26 * 8 + j] = t48 - t46 - t47; /* V(2,10) */
            V[28 * 8 + j] = t51 - t50 - t49; /* V(2,12) */
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

/* rates: 172 operations.
 * in:  x (14), v (14), p (9)
 * out: Phi_x (3,14), 24 of 42 entries */
FLEXEL_CLONES
static void beam_span_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict p = in[2] + b * (9 * 8);
        real *restrict Phi_x = out[0] + b * (24 * 8);
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
            const real t5 = 0.16666666666666666 * (tp_0 * t2 + tp_1 * t4);
            const real t6 = rp_vl0 * tp_3 + rp_vl3 * tp_0 + rp_vl1 * tp_2 - rp_vl2 * tp_1;
            const real t7 = t1 * t6;
            const real t8 = 0.16666666666666666 * (tp_3 * t7);
            const real t9 = rp_vl0 * tp_2 + rp_vl3 * tp_1 + rp_vl2 * tp_0 - rp_vl1 * tp_3;
            const real t10 = t1 * t9;
            const real t11 = 0.16666666666666666 * (tp_2 * t10);
            Phi_x[0 * 8 + j] = t5 - t8 - t11; /* Phi_x(0,3) */
            const real t12 = 0.16666666666666666 * (tp_3 * t10 + tp_0 * t4);
            const real t13 = 0.16666666666666666 * (tp_2 * t7);
            const real t14 = 0.16666666666666666 * (tp_1 * t2);
            Phi_x[1 * 8 + j] = t12 - t13 - t14; /* Phi_x(0,4) */
            const real t15 = 0.16666666666666666 * (tp_1 * t7);
            const real t16 = 0.16666666666666666 * (tp_3 * t4);
            const real t17 = 0.16666666666666666 * (tp_0 * t10);
            const real t18 = 0.16666666666666666 * (tp_2 * t2);
            Phi_x[2 * 8 + j] = t15 + t16 - t17 - t18; /* Phi_x(0,5) */
            const real t19 = 0.16666666666666666 * (tp_3 * t2) + 0.16666666666666666 * (tp_2 * t4);
            const real t20 = t19 + 0.16666666666666666 * (tp_0 * t7 + tp_1 * t10);
            Phi_x[8 * 8 + j] = Phi_x[17 * 8 + j] = t20; /* Phi_x(1,3) Phi_x(2,4) */
            Phi_x[3 * 8 + j] = -t20; /* Phi_x(0,6) */
            const real rq_vl1 = v[11 * 8 + j];
            const real tq_2 = p[7 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real tq_3 = p[8 * 8 + j];
            const real rq_vl3 = v[13 * 8 + j];
            const real tq_0 = p[5 * 8 + j];
            const real rq_vl2 = v[12 * 8 + j];
            const real tq_1 = p[6 * 8 + j];
            const real t21 = rq_vl0 * tq_3 + rq_vl3 * tq_0 + rq_vl1 * tq_2 - rq_vl2 * tq_1;
            const real t22 = t1 * t21;
            const real t23 = 0.16666666666666666 * (tq_3 * t22);
            const real t24 = rq_vl0 * tq_2 + rq_vl3 * tq_1 + rq_vl2 * tq_0 - rq_vl1 * tq_3;
            const real t25 = t1 * t24;
            const real t26 = 0.16666666666666666 * (tq_2 * t25);
            const real t27 = t23 + t26;
            const real t28 = rq_vl0 * tq_1 + rq_vl2 * tq_3 + rq_vl1 * tq_0 - rq_vl3 * tq_2;
            const real t29 = t1 * t28;
            const real t30 = 0.16666666666666666 * (tq_1 * t29);
            const real t31 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t32 = t31 * t1;
            const real t33 = 0.16666666666666666 * (tq_0 * t32);
            Phi_x[4 * 8 + j] = t27 - t30 - t33; /* Phi_x(0,10) */
            const real t34 = 0.16666666666666666 * (tq_1 * t32 + tq_2 * t22);
            const real t35 = 0.16666666666666666 * (tq_3 * t25);
            const real t36 = 0.16666666666666666 * (tq_0 * t29);
            Phi_x[5 * 8 + j] = t34 - t35 - t36; /* Phi_x(0,11) */
            const real t37 = 0.16666666666666666 * (tq_2 * t32);
            const real t38 = 0.16666666666666666 * (tq_0 * t25);
            const real t39 = 0.16666666666666666 * (tq_1 * t22);
            const real t40 = 0.16666666666666666 * (tq_3 * t29);
            Phi_x[6 * 8 + j] = t37 + t38 - t39 - t40; /* Phi_x(0,12) */
            const real t41 = 0.16666666666666666 * (tq_3 * t32) + 0.16666666666666666 * (tq_2 * t29);
            const real t42 = t41 + 0.16666666666666666 * (tq_0 * t22 + tq_1 * t25);
            Phi_x[7 * 8 + j] = t42; /* Phi_x(0,13) */
            const real t43 = t18 - t16;
            Phi_x[9 * 8 + j] = t17 + t43 - t15; /* Phi_x(1,4) */
            Phi_x[10 * 8 + j] = Phi_x[19 * 8 + j] = t12 - t14 - t13; /* Phi_x(1,5) Phi_x(2,6) */
            Phi_x[11 * 8 + j] = t5 - t11 - t8; /* Phi_x(1,6) */
            Phi_x[12 * 8 + j] = Phi_x[21 * 8 + j] = -t42; /* Phi_x(1,10) Phi_x(2,11) */
            const real t44 = t40 - t37;
            Phi_x[13 * 8 + j] = t39 + t44 - t38; /* Phi_x(1,11) */
            Phi_x[14 * 8 + j] = Phi_x[23 * 8 + j] = t34 - t36 - t35; /* Phi_x(1,12) Phi_x(2,13) */
            const real t45 = t33 + t30;
            Phi_x[15 * 8 + j] = t27 - t45; /* Phi_x(1,13) */
            Phi_x[16 * 8 + j] = t15 - t43 - t17; /* Phi_x(2,3) */
            Phi_x[18 * 8 + j] = t8 + t11 - t5; /* Phi_x(2,5) */
            Phi_x[20 * 8 + j] = t38 - t39 - t44; /* Phi_x(2,10) */
            Phi_x[22 * 8 + j] = t45 - t23 - t26; /* Phi_x(2,12) */
        }
    }
}

/* kinematics: 324 operations.
 * in:  x (14), v (14), a (14), p (9)
 * out: Psi_x (3,14), 24 of 42 entries, Psi_v (3,14), 24 of 42 entries */
FLEXEL_CLONES
static void beam_span_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict v = in[1] + b * (14 * 8);
        const real *restrict a = in[2] + b * (14 * 8);
        const real *restrict p = in[3] + b * (9 * 8);
        real *restrict Psi_x = out[0] + b * (24 * 8);
        real *restrict Psi_v = out[1] + b * (24 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = l0 * l0;
            const real tp_0 = p[1 * 8 + j];
            const real rp_al0 = a[3 * 8 + j];
            const real tp_1 = p[2 * 8 + j];
            const real rp_al1 = a[4 * 8 + j];
            const real tp_2 = p[3 * 8 + j];
            const real rp_al2 = a[5 * 8 + j];
            const real tp_3 = p[4 * 8 + j];
            const real rp_al3 = a[6 * 8 + j];
            const real t1 = tp_0 * rp_al0 - tp_1 * rp_al1 - tp_2 * rp_al2 - tp_3 * rp_al3;
            const real t2 = t0 * t1;
            const real t3 = tp_1 * rp_al0 + tp_3 * rp_al2 + tp_0 * rp_al1 - tp_2 * rp_al3;
            const real t4 = t0 * t3;
            const real t5 = 0.16666666666666666 * (tp_0 * t2 + tp_1 * t4);
            const real t6 = tp_3 * rp_al0 + tp_0 * rp_al3 + tp_2 * rp_al1 - tp_1 * rp_al2;
            const real t7 = t0 * t6;
            const real t8 = 0.16666666666666666 * (tp_3 * t7);
            const real t9 = tp_2 * rp_al0 + tp_1 * rp_al3 + tp_0 * rp_al2 - tp_3 * rp_al1;
            const real t10 = t0 * t9;
            const real t11 = 0.16666666666666666 * (tp_2 * t10);
            Psi_x[0 * 8 + j] = t5 - t8 - t11; /* Psi_x(0,3) */
            const real t12 = 0.16666666666666666 * (tp_3 * t10 + tp_0 * t4);
            const real t13 = 0.16666666666666666 * (tp_2 * t7);
            const real t14 = 0.16666666666666666 * (tp_1 * t2);
            Psi_x[1 * 8 + j] = t12 - t13 - t14; /* Psi_x(0,4) */
            const real t15 = 0.16666666666666666 * (tp_1 * t7);
            const real t16 = 0.16666666666666666 * (tp_3 * t4);
            const real t17 = 0.16666666666666666 * (tp_0 * t10);
            const real t18 = 0.16666666666666666 * (tp_2 * t2);
            Psi_x[2 * 8 + j] = t15 + t16 - t17 - t18; /* Psi_x(0,5) */
            const real t19 = 0.16666666666666666 * (tp_3 * t2) + 0.16666666666666666 * (tp_2 * t4);
            const real t20 = t19 + 0.16666666666666666 * (tp_0 * t7 + tp_1 * t10);
            Psi_x[8 * 8 + j] = Psi_x[17 * 8 + j] = t20; /* Psi_x(1,3) Psi_x(2,4) */
            Psi_x[3 * 8 + j] = -t20; /* Psi_x(0,6) */
            const real tq_2 = p[7 * 8 + j];
            const real rq_al1 = a[11 * 8 + j];
            const real tq_3 = p[8 * 8 + j];
            const real rq_al0 = a[10 * 8 + j];
            const real tq_0 = p[5 * 8 + j];
            const real rq_al3 = a[13 * 8 + j];
            const real tq_1 = p[6 * 8 + j];
            const real rq_al2 = a[12 * 8 + j];
            const real t21 = tq_3 * rq_al0 + tq_0 * rq_al3 + tq_2 * rq_al1 - tq_1 * rq_al2;
            const real t22 = t0 * t21;
            const real t23 = 0.16666666666666666 * (tq_3 * t22);
            const real t24 = tq_2 * rq_al0 + tq_1 * rq_al3 + tq_0 * rq_al2 - tq_3 * rq_al1;
            const real t25 = t0 * t24;
            const real t26 = 0.16666666666666666 * (tq_2 * t25);
            const real t27 = t23 + t26;
            const real t28 = tq_1 * rq_al0 + tq_3 * rq_al2 + tq_0 * rq_al1 - tq_2 * rq_al3;
            const real t29 = t0 * t28;
            const real t30 = 0.16666666666666666 * (tq_1 * t29);
            const real t31 = tq_0 * rq_al0 - tq_1 * rq_al1 - tq_2 * rq_al2 - tq_3 * rq_al3;
            const real t32 = t0 * t31;
            const real t33 = 0.16666666666666666 * (tq_0 * t32);
            Psi_x[4 * 8 + j] = t27 - t30 - t33; /* Psi_x(0,10) */
            const real t34 = 0.16666666666666666 * (tq_1 * t32 + tq_2 * t22);
            const real t35 = 0.16666666666666666 * (tq_3 * t25);
            const real t36 = 0.16666666666666666 * (tq_0 * t29);
            Psi_x[5 * 8 + j] = t34 - t35 - t36; /* Psi_x(0,11) */
            const real t37 = 0.16666666666666666 * (tq_2 * t32);
            const real t38 = 0.16666666666666666 * (tq_0 * t25);
            const real t39 = 0.16666666666666666 * (tq_1 * t22);
            const real t40 = 0.16666666666666666 * (tq_3 * t29);
            Psi_x[6 * 8 + j] = t37 + t38 - t39 - t40; /* Psi_x(0,12) */
            const real t41 = 0.16666666666666666 * (tq_3 * t32) + 0.16666666666666666 * (tq_2 * t29);
            const real t42 = t41 + 0.16666666666666666 * (tq_0 * t22 + tq_1 * t25);
            Psi_x[7 * 8 + j] = t42; /* Psi_x(0,13) */
            const real t43 = t18 - t16;
            Psi_x[9 * 8 + j] = t17 + t43 - t15; /* Psi_x(1,4) */
            Psi_x[10 * 8 + j] = Psi_x[19 * 8 + j] = t12 - t14 - t13; /* Psi_x(1,5) Psi_x(2,6) */
            Psi_x[11 * 8 + j] = t5 - t11 - t8; /* Psi_x(1,6) */
            Psi_x[12 * 8 + j] = Psi_x[21 * 8 + j] = -t42; /* Psi_x(1,10) Psi_x(2,11) */
            const real t44 = t40 - t37;
            Psi_x[13 * 8 + j] = t39 + t44 - t38; /* Psi_x(1,11) */
            Psi_x[14 * 8 + j] = Psi_x[23 * 8 + j] = t34 - t36 - t35; /* Psi_x(1,12) Psi_x(2,13) */
            const real t45 = t33 + t30;
            Psi_x[15 * 8 + j] = t27 - t45; /* Psi_x(1,13) */
            Psi_x[16 * 8 + j] = t15 - t43 - t17; /* Psi_x(2,3) */
            Psi_x[18 * 8 + j] = t8 + t11 - t5; /* Psi_x(2,5) */
            Psi_x[20 * 8 + j] = t38 - t39 - t44; /* Psi_x(2,10) */
            Psi_x[22 * 8 + j] = t45 - t23 - t26; /* Psi_x(2,12) */
            const real rp_vl0 = v[3 * 8 + j];
            const real rp_vl1 = v[4 * 8 + j];
            const real rp_vl2 = v[5 * 8 + j];
            const real rp_vl3 = v[6 * 8 + j];
            const real t46 = rp_vl0 * tp_0 - rp_vl1 * tp_1 - rp_vl2 * tp_2 - rp_vl3 * tp_3;
            const real t47 = t46 * t0;
            const real t48 = rp_vl0 * tp_1 + rp_vl2 * tp_3 + rp_vl1 * tp_0 - rp_vl3 * tp_2;
            const real t49 = t0 * t48;
            const real t50 = 0.3333333333333333 * (tp_0 * t47 + tp_1 * t49);
            const real t51 = rp_vl0 * tp_3 + rp_vl3 * tp_0 + rp_vl1 * tp_2 - rp_vl2 * tp_1;
            const real t52 = t0 * t51;
            const real t53 = 0.3333333333333333 * (tp_3 * t52);
            const real t54 = rp_vl0 * tp_2 + rp_vl3 * tp_1 + rp_vl2 * tp_0 - rp_vl1 * tp_3;
            const real t55 = t0 * t54;
            const real t56 = 0.3333333333333333 * (tp_2 * t55);
            Psi_v[0 * 8 + j] = t50 - t53 - t56; /* Psi_v(0,3) */
            Psi_v[1 * 8 + j] = Psi_v[10 * 8 + j] = Psi_v[19 * 8 + j] = 0.3333333333333333 * (tp_0 * t49 - tp_1 * t47
                + tp_3 * t55 - tp_2 * t52); /* Psi_v(0,4) Psi_v(1,5) Psi_v(2,6) */
            const real t57 = 0.3333333333333333 * (tp_1 * t52);
            const real t58 = 0.3333333333333333 * (tp_2 * t47 - tp_3 * t49);
            const real t59 = 0.3333333333333333 * (tp_0 * t55);
            Psi_v[2 * 8 + j] = Psi_v[16 * 8 + j] = t57 - t58 - t59; /* Psi_v(0,5) Psi_v(2,3) */
            const real t60 = 0.3333333333333333 * (tp_0 * t52) + 0.3333333333333333 * (tp_1 * t55);
            const real t61 = t60 + 0.3333333333333333 * (tp_3 * t47 + tp_2 * t49);
            Psi_v[8 * 8 + j] = Psi_v[17 * 8 + j] = t61; /* Psi_v(1,3) Psi_v(2,4) */
            Psi_v[3 * 8 + j] = -t61; /* Psi_v(0,6) */
            const real rq_vl1 = v[11 * 8 + j];
            const real rq_vl0 = v[10 * 8 + j];
            const real rq_vl3 = v[13 * 8 + j];
            const real rq_vl2 = v[12 * 8 + j];
            const real t62 = rq_vl0 * tq_3 + rq_vl3 * tq_0 + rq_vl1 * tq_2 - rq_vl2 * tq_1;
            const real t63 = t0 * t62;
            const real t64 = 0.3333333333333333 * (tq_3 * t63);
            const real t65 = rq_vl0 * tq_2 + rq_vl3 * tq_1 + rq_vl2 * tq_0 - rq_vl1 * tq_3;
            const real t66 = t0 * t65;
            const real t67 = 0.3333333333333333 * (tq_2 * t66);
            const real t68 = rq_vl0 * tq_0 - rq_vl1 * tq_1 - rq_vl2 * tq_2 - rq_vl3 * tq_3;
            const real t69 = t68 * t0;
            const real t70 = rq_vl0 * tq_1 + rq_vl2 * tq_3 + rq_vl1 * tq_0 - rq_vl3 * tq_2;
            const real t71 = t0 * t70;
            const real t72 = 0.3333333333333333 * (tq_0 * t69 + tq_1 * t71);
            Psi_v[4 * 8 + j] = Psi_v[15 * 8 + j] = t64 + t67 - t72; /* Psi_v(0,10) Psi_v(1,13) */
            Psi_v[5 * 8 + j] = Psi_v[14 * 8 + j] = Psi_v[23 * 8 + j] = 0.3333333333333333 * (tq_1 * t69 - tq_0 * t71
                + tq_2 * t63 - tq_3 * t66); /* Psi_v(0,11) Psi_v(1,12) Psi_v(2,13) */
            const real t73 = 0.3333333333333333 * (tq_0 * t66);
            const real t74 = 0.3333333333333333 * (tq_3 * t71 - tq_2 * t69);
            const real t75 = 0.3333333333333333 * (tq_1 * t63);
            Psi_v[6 * 8 + j] = Psi_v[20 * 8 + j] = t73 - t74 - t75; /* Psi_v(0,12) Psi_v(2,10) */
            const real t76 = 0.3333333333333333 * (tq_0 * t63) + 0.3333333333333333 * (tq_1 * t66);
            const real t77 = t76 + 0.3333333333333333 * (tq_3 * t69 + tq_2 * t71);
            Psi_v[7 * 8 + j] = t77; /* Psi_v(0,13) */
            Psi_v[9 * 8 + j] = t59 + t58 - t57; /* Psi_v(1,4) */
            Psi_v[11 * 8 + j] = t50 - t56 - t53; /* Psi_v(1,6) */
            Psi_v[12 * 8 + j] = Psi_v[21 * 8 + j] = -t77; /* Psi_v(1,10) Psi_v(2,11) */
            Psi_v[13 * 8 + j] = t75 + t74 - t73; /* Psi_v(1,11) */
            Psi_v[18 * 8 + j] = t53 + t56 - t50; /* Psi_v(2,5) */
            Psi_v[22 * 8 + j] = t72 - t64 - t67; /* Psi_v(2,12) */
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
            K[0 * 8 + j] = tp_3 * t18 + tp_2 * t23 + tp_1 * t13 + tp_0 * t8; /* K(3,3) */
            K[1 * 8 + j] = tp_2 * t18 + tp_0 * t13 - tp_3 * t23 - tp_1 * t8; /* K(3,4) */
            K[2 * 8 + j] = tp_0 * t23 + tp_3 * t13 - tp_1 * t18 - tp_2 * t8; /* K(3,5) */
            K[3 * 8 + j] = tp_0 * t18 + tp_1 * t23 - tp_2 * t13 - tp_3 * t8; /* K(3,6) */
            const real t24 = t11 - t12;
            const real t25 = t16 + t17;
            const real t26 = t7 - t5;
            const real t27 = t21 + t22;
            K[4 * 8 + j] = tp_2 * t25 + tp_1 * t26 + tp_0 * t24 - tp_3 * t27; /* K(4,3) */
            K[5 * 8 + j] = tp_0 * t26 - tp_2 * t27 - tp_3 * t25 - tp_1 * t24; /* K(4,4) */
            K[6 * 8 + j] = tp_1 * t27 + tp_0 * t25 + tp_3 * t26 - tp_2 * t24; /* K(4,5) */
            K[7 * 8 + j] = tp_1 * t25 - tp_0 * t27 - tp_2 * t26 - tp_3 * t24; /* K(4,6) */
            const real t28 = t15 - t14;
            const real t29 = t17 + t28;
            const real t30 = t9 - t10;
            const real t31 = t12 + t30;
            const real t32 = t4 + t2;
            const real t33 = t32 - t7;
            const real t34 = t20 + t19;
            const real t35 = t22 + t34;
            K[8 * 8 + j] = tp_3 * t31 + tp_2 * t33 + tp_1 * t29 - tp_0 * t35; /* K(5,3) */
            K[9 * 8 + j] = tp_2 * t31 + tp_0 * t29 + tp_1 * t35 - tp_3 * t33; /* K(5,4) */
            K[10 * 8 + j] = tp_0 * t33 + tp_3 * t29 + tp_2 * t35 - tp_1 * t31; /* K(5,5) */
            K[11 * 8 + j] = tp_0 * t31 + tp_1 * t33 + tp_3 * t35 - tp_2 * t29; /* K(5,6) */
            const real t36 = t28 - t17;
            const real t37 = t30 - t12;
            const real t38 = t34 - t22;
            const real t39 = t7 + t32;
            K[12 * 8 + j] = tp_2 * t37 + tp_1 * t38 + tp_0 * t36 - tp_3 * t39; /* K(6,3) */
            K[13 * 8 + j] = tp_0 * t38 - tp_2 * t39 - tp_3 * t37 - tp_1 * t36; /* K(6,4) */
            K[14 * 8 + j] = tp_1 * t39 + tp_0 * t37 + tp_3 * t38 - tp_2 * t36; /* K(6,5) */
            K[15 * 8 + j] = tp_1 * t37 - tp_0 * t39 - tp_2 * t38 - tp_3 * t36; /* K(6,6) */
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
            K[16 * 8 + j] = tq_3 * t49 + tq_2 * t54 + tq_0 * t44 - tq_1 * t59; /* K(10,10) */
            K[17 * 8 + j] = tq_2 * t49 - tq_3 * t54 - tq_0 * t59 - tq_1 * t44; /* K(10,11) */
            K[18 * 8 + j] = tq_0 * t54 - tq_1 * t49 - tq_3 * t59 - tq_2 * t44; /* K(10,12) */
            K[19 * 8 + j] = tq_0 * t49 + tq_1 * t54 + tq_2 * t59 - tq_3 * t44; /* K(10,13) */
            const real t60 = t53 - t52;
            const real t61 = t58 - t57;
            const real t62 = t48 + t45;
            const real t63 = t42 + t43;
            K[20 * 8 + j] = tq_3 * t60 + tq_0 * t61 - tq_2 * t62 - tq_1 * t63; /* K(11,10) */
            K[21 * 8 + j] = tq_2 * t60 + tq_3 * t62 - tq_0 * t63 - tq_1 * t61; /* K(11,11) */
            K[22 * 8 + j] = -(tq_1 * t60 + tq_0 * t62 + tq_3 * t63 + tq_2 * t61); /* K(11,12) */
            K[23 * 8 + j] = tq_0 * t60 + tq_2 * t63 - tq_1 * t62 - tq_3 * t61; /* K(11,13) */
            const real t64 = t40 + t41;
            const real t65 = t43 - t64;
            const real t66 = t50 + t51;
            const real t67 = t53 + t66;
            const real t68 = t55 - t56;
            const real t69 = t58 + t68;
            const real t70 = t47 - t46;
            const real t71 = t45 + t70;
            K[24 * 8 + j] = tq_2 * t65 + tq_0 * t67 - tq_3 * t69 - tq_1 * t71; /* K(12,10) */
            K[25 * 8 + j] = -(tq_2 * t69 + tq_3 * t65 + tq_0 * t71 + tq_1 * t67); /* K(12,11) */
            K[26 * 8 + j] = tq_1 * t69 + tq_0 * t65 - tq_3 * t71 - tq_2 * t67; /* K(12,12) */
            K[27 * 8 + j] = tq_1 * t65 + tq_2 * t71 - tq_0 * t69 - tq_3 * t67; /* K(12,13) */
            const real t72 = t45 - t70;
            const real t73 = t43 + t64;
            const real t74 = t58 - t68;
            const real t75 = t66 - t53;
            K[28 * 8 + j] = tq_3 * t73 + tq_2 * t74 + tq_0 * t72 - tq_1 * t75; /* K(13,10) */
            K[29 * 8 + j] = tq_2 * t73 - tq_3 * t74 - tq_0 * t75 - tq_1 * t72; /* K(13,11) */
            K[30 * 8 + j] = tq_0 * t74 - tq_1 * t73 - tq_3 * t75 - tq_2 * t72; /* K(13,12) */
            K[31 * 8 + j] = tq_0 * t73 + tq_1 * t74 + tq_2 * t75 - tq_3 * t72; /* K(13,13) */
        }
    }
}

const flexel_element flexel_beam_span = {
    .name = "beam_span",
    .digest = "c733ae483e0ba226",
    .n = 14,
    .m = 0,
    .k = 3,
    .np = 9,
    .position = beam_span_position,
    .acceleration = beam_span_acceleration,
    .rates = beam_span_rates,
    .kinematics = beam_span_kinematics,
    .stiffness = beam_span_stiffness,
};
