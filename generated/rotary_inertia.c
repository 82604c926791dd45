/* rotary_inertia: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * w = 2 (conj(lambda) o lambdadot), angular velocity in body axes
 * T = w.J w/2
 *
 * Source: Schwab and Meijaard 2006, DETC2006-99307
 *
 * x (4): r_l0, r_l1, r_l2, r_l3
 * e (0): none
 * s (0): none
 * p (6):
 *   J (6) [kg m^2]: inertia tensor in body axes (tensor components) */
#include "kernels.h"

/* inertia: 281 operations.
 * in:  x (4), v (4), p (6)
 * out: M (4,4), h (4), f (4), 0 of 4 entries, U (1), 0 of 1 entries */
FLEXEL_CLONES
static void rotary_inertia_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict v = in[1] + b * (4 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict M = out[0] + b * (16 * 8);
        real *restrict h = out[1] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l3 = x[3 * 8 + j];
            const real J_zz = p[2 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real J_yz = p[5 * 8 + j];
            const real t0 = 4.0 * r_l2 * J_yz;
            const real r_l1 = x[1 * 8 + j];
            const real J_xz = p[4 * 8 + j];
            const real t1 = 4.0 * r_l1 * J_xz;
            const real t2 = 4.0 * r_l3 * J_zz + t0 + t1;
            const real t3 = 4.0 * r_l3 * J_yz;
            const real J_yy = p[1 * 8 + j];
            const real J_xy = p[3 * 8 + j];
            const real t4 = 4.0 * r_l1 * J_xy;
            const real t5 = t3 + 4.0 * r_l2 * J_yy + t4;
            const real t6 = 4.0 * r_l3 * J_xz;
            const real t7 = 4.0 * r_l2 * J_xy;
            const real J_xx = p[0 * 8 + j];
            const real t8 = t6 + t7 + 4.0 * r_l1 * J_xx;
            M[0 * 8 + j] = r_l3 * t2 + r_l2 * t5 + r_l1 * t8; /* M(0,0) */
            const real r_l0 = x[0 * 8 + j];
            M[1 * 8 + j] = M[4 * 8 + j] = r_l3 * t5 - r_l2 * t2 - r_l0 * t8; /* M(0,1) M(1,0) */
            M[2 * 8 + j] = M[8 * 8 + j] = r_l1 * t2 - r_l0 * t5 - r_l3 * t8; /* M(0,2) M(2,0) */
            M[3 * 8 + j] = M[12 * 8 + j] = r_l2 * t8 - (r_l0 * t2 + r_l1 * t5); /* M(0,3) M(3,0) */
            const real t9 = 4.0 * r_l0 * J_xz;
            const real t10 = 4.0 * r_l2 * J_zz - t3 + t9;
            const real t11 = 4.0 * r_l0 * J_xy;
            const real t12 = t0 - 4.0 * r_l3 * J_yy + t11;
            const real t13 = 4.0 * r_l2 * J_xz;
            const real t14 = 4.0 * r_l3 * J_xy;
            const real t15 = t13 - t14 + 4.0 * r_l0 * J_xx;
            M[5 * 8 + j] = r_l2 * t10 - r_l3 * t12 + r_l0 * t15; /* M(1,1) */
            M[6 * 8 + j] = M[9 * 8 + j] = r_l0 * t12 - r_l1 * t10 + r_l3 * t15; /* M(1,2) M(2,1) */
            M[7 * 8 + j] = M[13 * 8 + j] = r_l0 * t10 + r_l1 * t12 - r_l2 * t15; /* M(1,3) M(3,1) */
            const real t16 = 4.0 * r_l1 * J_yz;
            const real t17 = 4.0 * r_l0 * J_yy - t16 + t14;
            const real t18 = 4.0 * r_l0 * J_yz;
            const real t19 = t18 - 4.0 * r_l1 * J_zz + t6;
            const real t20 = t11 - t1 + 4.0 * r_l3 * J_xx;
            M[10 * 8 + j] = r_l0 * t17 - r_l1 * t19 + r_l3 * t20; /* M(2,2) */
            M[11 * 8 + j] = M[14 * 8 + j] = r_l0 * t19 + r_l1 * t17 - r_l2 * t20; /* M(2,3) M(3,2) */
            const real t21 = r_l0 * (t16 + 4.0 * r_l0 * J_zz - t13) + r_l1 * (t18 + 4.0 * r_l1 * J_yy - t7);
            M[15 * 8 + j] = t21 - r_l2 * (t4 + t9 - 4.0 * r_l2 * J_xx); /* M(3,3) */
            const real r_vl1 = v[1 * 8 + j];
            const real r_vl2 = v[2 * 8 + j];
            const real r_vl0 = v[0 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real t22 = r_l0 * r_vl1 + r_l3 * r_vl2 - r_l1 * r_vl0 - r_l2 * r_vl3;
            const real t23 = 2.0 * J_xz * t22;
            const real t24 = r_l0 * r_vl2 + r_l1 * r_vl3 - r_l2 * r_vl0 - r_l3 * r_vl1;
            const real t25 = 2.0 * J_yz * t24;
            const real t26 = r_l0 * r_vl3 + r_l2 * r_vl1 - r_l1 * r_vl2 - r_l3 * r_vl0;
            const real t27 = 2.0 * J_zz * t26;
            const real t28 = t23 + t25 + t27 + t27 + t25 + t23;
            const real t29 = r_vl3 * t28;
            const real t30 = 2.0 * J_xy * t22;
            const real t31 = 2.0 * J_yy * t24;
            const real t32 = 2.0 * J_yz * t26;
            const real t33 = t30 + t31 + t32 + t32 + t31 + t30;
            const real t34 = r_vl2 * t33;
            const real t35 = 2.0 * J_xx * t22;
            const real t36 = 2.0 * J_xz * t26;
            const real t37 = 2.0 * J_xy * t24;
            const real t38 = t35 + t37 + t36 + (t37 + t36) + t35;
            const real t39 = r_vl1 * t38;
            const real t40 = r_vl0 * r_vl1;
            const real t41 = r_vl2 * r_vl3;
            const real t42 = t40 + t41 - t40 - t41;
            const real t43 = 2.0 * J_xz * t42;
            const real t44 = r_vl0 * r_vl2;
            const real t45 = r_vl1 * r_vl3;
            const real t46 = t44 + t45 - t44 - t45;
            const real t47 = 2.0 * J_yz * t46;
            const real t48 = r_vl0 * r_vl3;
            const real t49 = r_vl1 * r_vl2;
            const real t50 = t48 + t49 - t49 - t48;
            const real t51 = 2.0 * J_zz * t50;
            const real t52 = t43 + t47 + t51 + t51 + t47 + t43;
            const real t53 = 2.0 * J_xy * t42;
            const real t54 = 2.0 * J_yy * t46;
            const real t55 = 2.0 * J_yz * t50;
            const real t56 = t53 + t54 + t55 + t55 + t54 + t53;
            const real t57 = 2.0 * J_xx * t42;
            const real t58 = 2.0 * J_xz * t50;
            const real t59 = 2.0 * J_xy * t46;
            const real t60 = t57 + t59 + t58 + (t59 + t58) + t57;
            const real t61 = t29 + r_l3 * t52 + (t34 + r_l2 * t56) + (t39 + r_l1 * t60);
            h[0 * 8 + j] = -(t29 + t34 + t39 + t61);
            const real t62 = r_vl2 * t28;
            const real t63 = r_vl3 * t33;
            const real t64 = r_vl0 * t38;
            const real t65 = t62 + r_l2 * t52 - (t63 + r_l3 * t56) + (t64 + r_l0 * t60);
            h[1 * 8 + j] = t65 - (t63 - t62 - t64);
            const real t66 = r_vl0 * t33;
            const real t67 = r_vl1 * t28;
            const real t68 = r_vl3 * t38;
            const real t69 = t66 + r_l0 * t56 - (t67 + r_l1 * t52) + (t68 + r_l3 * t60);
            h[2 * 8 + j] = t69 - (t67 - t66 - t68);
            const real t70 = r_vl0 * t28;
            const real t71 = r_vl1 * t33;
            const real t72 = r_vl2 * t38;
            const real t73 = t70 + r_l0 * t52 + (t71 + r_l1 * t56) - (t72 + r_l2 * t60);
            h[3 * 8 + j] = t73 - (t72 - (t70 + t71));
        }
    }
}

/* tangent: 536 operations.
 * in:  x (4), v (4), a (4), p (6)
 * out: R_x (4,4), R_v (4,4) */
FLEXEL_CLONES
static void rotary_inertia_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (4 * 8);
        const real *restrict v = in[1] + b * (4 * 8);
        const real *restrict a = in[2] + b * (4 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict R_x = out[0] + b * (16 * 8);
        real *restrict R_v = out[1] + b * (16 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_l3 = x[3 * 8 + j];
            const real J_zz = p[2 * 8 + j];
            const real r_l2 = x[2 * 8 + j];
            const real J_yz = p[5 * 8 + j];
            const real t0 = 4.0 * r_l2 * J_yz;
            const real r_l1 = x[1 * 8 + j];
            const real J_xz = p[4 * 8 + j];
            const real t1 = 4.0 * r_l1 * J_xz;
            const real t2 = 4.0 * r_l3 * J_zz + t0 + t1;
            const real r_al3 = a[3 * 8 + j];
            const real t3 = 4.0 * r_l3 * J_yz;
            const real J_yy = p[1 * 8 + j];
            const real J_xy = p[3 * 8 + j];
            const real t4 = 4.0 * r_l1 * J_xy;
            const real t5 = t3 + 4.0 * r_l2 * J_yy + t4;
            const real r_al2 = a[2 * 8 + j];
            const real t6 = 4.0 * r_l3 * J_xz;
            const real t7 = 4.0 * r_l2 * J_xy;
            const real J_xx = p[0 * 8 + j];
            const real t8 = t6 + t7 + 4.0 * r_l1 * J_xx;
            const real r_al1 = a[1 * 8 + j];
            const real r_vl3 = v[3 * 8 + j];
            const real r_vl2 = v[2 * 8 + j];
            const real t9 = 8.0 * r_vl2 * J_yz;
            const real r_vl1 = v[1 * 8 + j];
            const real t10 = 8.0 * r_vl1 * J_xz;
            const real t11 = 8.0 * r_vl3 * J_zz + t9 + t10;
            const real t12 = 8.0 * r_vl3 * J_yz;
            const real t13 = 8.0 * r_vl1 * J_xy;
            const real t14 = t12 + 8.0 * r_vl2 * J_yy + t13;
            const real t15 = r_al3 * t2 + r_al2 * t5 + r_al1 * t8 + r_vl3 * t11 + r_vl2 * t14;
            const real t16 = 8.0 * r_vl3 * J_xz;
            const real t17 = 8.0 * r_vl2 * J_xy;
            const real t18 = t16 + t17 + 8.0 * r_vl1 * J_xx;
            R_x[0 * 8 + j] = -(t15 + r_vl1 * t18); /* R_x(0,0) */
            const real r_vl0 = v[0 * 8 + j];
            const real r_al0 = a[0 * 8 + j];
            const real r_l0 = x[0 * 8 + j];
            const real t19 = r_l0 * r_al3 + r_l2 * r_al1 - r_l1 * r_al2 - r_l3 * r_al0;
            const real t20 = 2.0 * J_xz * t19;
            const real t21 = r_l0 * r_al2 + r_l1 * r_al3 - r_l2 * r_al0 - r_l3 * r_al1;
            const real t22 = 2.0 * J_xy * t21;
            const real t23 = r_l0 * r_al1 + r_l3 * r_al2 - r_l1 * r_al0 - r_l2 * r_al3;
            const real t24 = 2.0 * J_xx * t23;
            const real t25 = t24 + t20 + t24 + t22 + t22 + t20;
            const real t26 = r_al2 * t2 + r_al0 * t8 + r_vl2 * t11 + r_vl0 * t18 - t25;
            R_x[1 * 8 + j] = t26 - r_al3 * t5 - r_vl3 * t14; /* R_x(0,1) */
            const real t27 = 2.0 * J_yy * t21;
            const real t28 = 2.0 * J_xy * t23;
            const real t29 = 2.0 * J_yz * t19;
            const real t30 = t28 + t27 + t29 + t29 + t28 + t27;
            const real t31 = r_al0 * t5 + r_al3 * t8 + r_vl0 * t14 + r_vl3 * t18 - t30;
            R_x[2 * 8 + j] = t31 - r_al1 * t2 - r_vl1 * t11; /* R_x(0,2) */
            const real t32 = 2.0 * J_yz * t21;
            const real t33 = 2.0 * J_xz * t23;
            const real t34 = 2.0 * J_zz * t19;
            const real t35 = t33 + t32 + t34 + t34 + t33 + t32;
            const real t36 = r_al0 * t2 + r_al1 * t5 + r_vl0 * t11 + r_vl1 * t14 - t35;
            R_x[3 * 8 + j] = t36 - r_al2 * t8 - r_vl2 * t18; /* R_x(0,3) */
            const real t37 = 8.0 * r_vl2 * J_xz;
            const real t38 = 8.0 * r_vl3 * J_xy;
            const real t39 = t37 + 8.0 * r_vl0 * J_xx - t38;
            const real t40 = 8.0 * r_vl0 * J_xy;
            const real t41 = t9 + t40 - 8.0 * r_vl3 * J_yy;
            const real t42 = 8.0 * r_vl0 * J_xz;
            const real t43 = 8.0 * r_vl2 * J_zz + t42 - t12;
            const real t44 = 4.0 * r_l2 * J_xz;
            const real t45 = 4.0 * r_l3 * J_xy;
            const real t46 = t44 + 4.0 * r_l0 * J_xx - t45;
            const real t47 = 4.0 * r_l0 * J_xy;
            const real t48 = t0 + t47 - 4.0 * r_l3 * J_yy;
            const real t49 = 4.0 * r_l0 * J_xz;
            const real t50 = 4.0 * r_l2 * J_zz + t49 - t3;
            const real t51 = t25 + r_al3 * t50 + r_al2 * t48 + r_al1 * t46 + r_vl3 * t43;
            R_x[4 * 8 + j] = r_vl2 * t41 + t51 + r_vl1 * t39; /* R_x(1,0) */
            const real t52 = r_al3 * t48 + r_vl3 * t41 - r_al2 * t50 - r_al0 * t46 - r_vl2 * t43;
            R_x[5 * 8 + j] = t52 - r_vl0 * t39; /* R_x(1,1) */
            const real t53 = t35 + r_al1 * t50 + r_vl1 * t43 - r_al0 * t48 - r_al3 * t46;
            R_x[6 * 8 + j] = t53 - r_vl0 * t41 - r_vl3 * t39; /* R_x(1,2) */
            const real t54 = r_al2 * t46 + r_vl2 * t39 - t30 - r_al0 * t50 - r_al1 * t48;
            R_x[7 * 8 + j] = t54 - r_vl0 * t43 - r_vl1 * t41; /* R_x(1,3) */
            const real t55 = t40 + 8.0 * r_vl3 * J_xx - t10;
            const real t56 = 8.0 * r_vl1 * J_yz;
            const real t57 = t38 + 8.0 * r_vl0 * J_yy - t56;
            const real t58 = 8.0 * r_vl0 * J_yz;
            const real t59 = t16 + t58 - 8.0 * r_vl1 * J_zz;
            const real t60 = t47 + 4.0 * r_l3 * J_xx - t1;
            const real t61 = 4.0 * r_l1 * J_yz;
            const real t62 = t45 + 4.0 * r_l0 * J_yy - t61;
            const real t63 = 4.0 * r_l0 * J_yz;
            const real t64 = t6 + t63 - 4.0 * r_l1 * J_zz;
            const real t65 = t30 + r_al3 * t64 + r_al2 * t62 + r_al1 * t60 + r_vl3 * t59;
            R_x[8 * 8 + j] = r_vl2 * t57 + t65 + r_vl1 * t55; /* R_x(2,0) */
            const real t66 = r_al3 * t62 + r_vl3 * t57 - t35 - r_al2 * t64 - r_al0 * t60;
            R_x[9 * 8 + j] = t66 - r_vl2 * t59 - r_vl0 * t55; /* R_x(2,1) */
            const real t67 = r_al1 * t64 + r_vl1 * t59 - r_al0 * t62 - r_al3 * t60 - r_vl0 * t57;
            R_x[10 * 8 + j] = t67 - r_vl3 * t55; /* R_x(2,2) */
            const real t68 = t25 + r_al2 * t60 + r_vl2 * t55 - r_al0 * t64 - r_al1 * t62;
            R_x[11 * 8 + j] = t68 - r_vl0 * t59 - r_vl1 * t57; /* R_x(2,3) */
            const real t69 = t13 + t42 - 8.0 * r_vl2 * J_xx;
            const real t70 = t58 + 8.0 * r_vl1 * J_yy - t17;
            const real t71 = t56 + 8.0 * r_vl0 * J_zz - t37;
            const real t72 = t4 + t49 - 4.0 * r_l2 * J_xx;
            const real t73 = t63 + 4.0 * r_l1 * J_yy - t7;
            const real t74 = t61 + 4.0 * r_l0 * J_zz - t44;
            const real t75 = r_al3 * t74 + t35 + r_al2 * t73 + r_al1 * t72 + r_vl3 * t71;
            R_x[12 * 8 + j] = r_vl2 * t70 + t75 + r_vl1 * t69; /* R_x(3,0) */
            const real t76 = r_al3 * t73 + t30 + r_vl3 * t70 - r_al2 * t74 - r_al0 * t72;
            R_x[13 * 8 + j] = t76 - r_vl2 * t71 - r_vl0 * t69; /* R_x(3,1) */
            const real t77 = r_al1 * t74 + r_vl1 * t71 - t25 - r_al0 * t73 - r_al3 * t72;
            R_x[14 * 8 + j] = t77 - r_vl0 * t70 - r_vl3 * t69; /* R_x(3,2) */
            const real t78 = r_al2 * t72 + r_vl2 * t69 - r_al0 * t74 - r_al1 * t73 - r_vl0 * t71;
            R_x[15 * 8 + j] = t78 - r_vl1 * t70; /* R_x(3,3) */
            R_v[0 * 8 + j] = r_l3 * t11 + r_l2 * t14 + r_l1 * t18; /* R_v(0,0) */
            const real t79 = r_l0 * r_vl3 + r_l2 * r_vl1 - r_l1 * r_vl2 - r_l3 * r_vl0;
            const real t80 = 2.0 * J_xz * t79;
            const real t81 = r_l0 * r_vl2 + r_l1 * r_vl3 - r_l2 * r_vl0 - r_l3 * r_vl1;
            const real t82 = 2.0 * J_xy * t81;
            const real t83 = r_l0 * r_vl1 + r_l3 * r_vl2 - r_l1 * r_vl0 - r_l2 * r_vl3;
            const real t84 = 2.0 * J_xx * t83;
            const real t85 = 2.0 * (t84 + t80 + t84 + t82 + t82 + t80);
            R_v[1 * 8 + j] = r_l3 * t14 - t85 - r_l2 * t11 - r_l0 * t18; /* R_v(0,1) */
            const real t86 = 2.0 * J_yy * t81;
            const real t87 = 2.0 * J_xy * t83;
            const real t88 = 2.0 * J_yz * t79;
            const real t89 = 2.0 * (t87 + t86 + t88 + t88 + t87 + t86);
            R_v[2 * 8 + j] = r_l1 * t11 - t89 - r_l0 * t14 - r_l3 * t18; /* R_v(0,2) */
            const real t90 = 2.0 * J_yz * t81;
            const real t91 = 2.0 * J_xz * t83;
            const real t92 = 2.0 * J_zz * t79;
            const real t93 = 2.0 * (t91 + t90 + t92 + t92 + t91 + t90);
            R_v[3 * 8 + j] = r_l2 * t18 - t93 - r_l0 * t11 - r_l1 * t14; /* R_v(0,3) */
            R_v[4 * 8 + j] = t85 - r_l3 * t43 - r_l2 * t41 - r_l1 * t39; /* R_v(1,0) */
            R_v[5 * 8 + j] = r_l2 * t43 + r_l0 * t39 - r_l3 * t41; /* R_v(1,1) */
            R_v[6 * 8 + j] = t93 + r_l0 * t41 + r_l3 * t39 - r_l1 * t43; /* R_v(1,2) */
            R_v[7 * 8 + j] = r_l0 * t43 + r_l1 * t41 - t89 - r_l2 * t39; /* R_v(1,3) */
            R_v[8 * 8 + j] = t89 - r_l3 * t59 - r_l2 * t57 - r_l1 * t55; /* R_v(2,0) */
            R_v[9 * 8 + j] = r_l2 * t59 + r_l0 * t55 - t93 - r_l3 * t57; /* R_v(2,1) */
            R_v[10 * 8 + j] = r_l0 * t57 + r_l3 * t55 - r_l1 * t59; /* R_v(2,2) */
            R_v[11 * 8 + j] = t85 + r_l0 * t59 + r_l1 * t57 - r_l2 * t55; /* R_v(2,3) */
            R_v[12 * 8 + j] = t93 - r_l3 * t71 - r_l2 * t70 - r_l1 * t69; /* R_v(3,0) */
            R_v[13 * 8 + j] = r_l2 * t71 + t89 + r_l0 * t69 - r_l3 * t70; /* R_v(3,1) */
            R_v[14 * 8 + j] = r_l0 * t70 + r_l3 * t69 - t85 - r_l1 * t71; /* R_v(3,2) */
            R_v[15 * 8 + j] = r_l0 * t71 + r_l1 * t70 - r_l2 * t69; /* R_v(3,3) */
        }
    }
}

const flexel_element flexel_rotary_inertia = {
    .name = "rotary_inertia",
    .digest = "6ef75d325a937985",
    .n = 4,
    .m = 0,
    .k = 0,
    .np = 6,
    .inertia = rotary_inertia_inertia,
    .tangent = rotary_inertia_tangent,
};
