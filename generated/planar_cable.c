/* planar_cable: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * r(s): cubic Hermite curve with slopes dp, dq = dr/ds by the undeformed arc length s at the ends
 * strain1 = L/l0 - 1, the mean of |r'| - 1 by 3 Gauss points;  strain2 = (|dq| - |dp|)/2;
 * strain3 = (|dq| + |dp|)/2 - L/l0:  |r'| - 1 = strain1 + strain2 P1 + strain3 P2, Legendre's polynomials
 * curvature = (r' x r'')/|r'|^2, the turn by undeformed arc length, at 3 Gauss points
 * work: EA l0 (1, 1/3, 1/5) times the strains, EI times curvature and Gauss weight (of sum l0)
 * T = rhoA/2 int rdot.rdot ds (constant mass matrix),  U = -rhoA gravity.int r ds
 * arc_length, tension, strain, curvature at 3 Gauss points:
 * tension = (sigma1 + 3 sigma2 P1 + 5 sigma3 P2)/l0,  strain = strain1 + strain2 P1 + strain3 P2,
 * curvature = its magnitude
 * line: places on the curve
 *
 * Source: Gerstmayr and Irschik 2008, J. Sound Vib. 318:461 (strain and curvature); Gerstmayr and Shabana 2006,
 *   Nonlinear Dyn. 45:109 (cubic cable)
 *
 * x (8): p_x, p_y, dp_x, dp_y, q_x, q_y, dq_x, dq_y
 * e (6): strain1 [1], strain2 [1], strain3 [1], curvature1 [1/m], curvature2 [1/m], curvature3 [1/m]
 * s (0): none
 * p (4):
 *   l0 (1) [m]: undeformed length
 *   rhoA (1) [kg/m]: mass per length
 *   gravity (2) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* position: 252 operations.
 * in:  x (8), p (4)
 * out: e (6), De (6,8), 44 of 48 entries, V (0,8) */
FLEXEL_CLONES
static void planar_cable_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict e = out[0] + b * (6 * 8);
        real *restrict De = out[1] + b * (44 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = d_x * t0;
            const real dp_x = x[2 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            const real s2_x = 1.5 * t1 - 0.25 * (dp_x + dq_x);
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t2 = d_y * t0;
            const real dp_y = x[3 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            const real s2_y = 1.5 * t2 - 0.25 * (dp_y + dq_y);
            const real t3 = s2_x * s2_x + s2_y * s2_y;
            const real t4 = real_sqrt(t3);
            const real t5 = 0.6 * t1;
            const real s1_x = 0.5872983346207417 * dp_x + t5 - 0.1872983346207417 * dq_x;
            const real t6 = 0.6 * t2;
            const real s1_y = 0.5872983346207417 * dp_y + t6 - 0.1872983346207417 * dq_y;
            const real t7 = s1_x * s1_x + s1_y * s1_y;
            const real t8 = real_sqrt(t7);
            const real s3_x = t5 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real s3_y = t6 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t9 = s3_x * s3_x + s3_y * s3_y;
            const real t10 = real_sqrt(t9);
            const real mean = 0.4444444444444444 * t4 + 0.2777777777777778 * (t8 + t10);
            e[0 * 8 + j] = mean - 1.0;
            const real nq = real_sqrt(dq_x * dq_x + dq_y * dq_y);
            const real np = real_sqrt(dp_x * dp_x + dp_y * dp_y);
            e[1 * 8 + j] = 0.5 * (nq - np);
            e[2 * 8 + j] = 0.5 * (np + nq) - mean;
            const real t11 = 1.0 / t7;
            const real t12 = 4.6475800154489 * t2;
            const real t13 = t12 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t13;
            const real t14 = 4.6475800154489 * t1;
            const real t15 = t14 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t15;
            const real t16 = t11 * (s1_x * b1_y - s1_y * b1_x);
            e[3 * 8 + j] = t16;
            const real t17 = 1.0 / t3;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t18 = t17 * (s2_x * b2_y - s2_y * b2_x);
            e[4 * 8 + j] = t18;
            const real t19 = 1.0 / t9;
            const real t20 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t12;
            const real b3_y = t0 * t20;
            const real t21 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t14;
            const real b3_x = t0 * t21;
            const real t22 = t19 * (b3_y * s3_x - b3_x * s3_y);
            e[5 * 8 + j] = t22;
            const real t23 = 1.0 / t4;
            const real t24 = s2_x * t23;
            const real t25 = 1.0 / t8;
            const real t26 = s1_x * t25;
            const real t27 = 1.0 / t10;
            const real t28 = s3_x * t27;
            const real t29 = 0.6666666666666666 * t24 + 0.16666666666666666 * (t26 + t28);
            const real t30 = t0 * t29;
            De[4 * 8 + j] = De[12 * 8 + j] = t30; /* De(0,4) De(2,0) */
            De[0 * 8 + j] = De[16 * 8 + j] = -t30; /* De(0,0) De(2,4) */
            const real t31 = s2_y * t23;
            const real t32 = s1_y * t25;
            const real t33 = s3_y * t27;
            const real t34 = 0.6666666666666666 * t31 + 0.16666666666666666 * (t32 + t33);
            const real t35 = t0 * t34;
            De[5 * 8 + j] = De[13 * 8 + j] = t35; /* De(0,5) De(2,1) */
            De[1 * 8 + j] = De[17 * 8 + j] = -t35; /* De(0,1) De(2,5) */
            const real t36 = 0.1111111111111111 * t24;
            const real t37 = 0.16313842628353936 * t26 - t36 - 0.05202731517242825 * t28;
            De[2 * 8 + j] = t37; /* De(0,2) */
            const real t38 = 0.1111111111111111 * t31;
            const real t39 = 0.16313842628353936 * t32 - t38 - 0.05202731517242825 * t33;
            De[3 * 8 + j] = t39; /* De(0,3) */
            const real t40 = 0.16313842628353936 * t28 - t36 - 0.05202731517242825 * t26;
            De[6 * 8 + j] = t40; /* De(0,6) */
            const real t41 = 0.16313842628353936 * t33 - t38 - 0.05202731517242825 * t32;
            De[7 * 8 + j] = t41; /* De(0,7) */
            const real t42 = 1.0 / np;
            const real t43 = 0.5 * dp_x * t42;
            De[8 * 8 + j] = -t43; /* De(1,2) */
            const real t44 = 0.5 * dp_y * t42;
            De[9 * 8 + j] = -t44; /* De(1,3) */
            const real t45 = 1.0 / nq;
            const real t46 = 0.5 * dq_x * t45;
            De[10 * 8 + j] = t46; /* De(1,6) */
            const real t47 = 0.5 * dq_y * t45;
            De[11 * 8 + j] = t47; /* De(1,7) */
            De[14 * 8 + j] = t43 - t37; /* De(2,2) */
            De[15 * 8 + j] = t44 - t39; /* De(2,3) */
            De[18 * 8 + j] = t46 - t40; /* De(2,6) */
            De[19 * 8 + j] = t47 - t41; /* De(2,7) */
            const real t48 = t11 * t16;
            const real t49 = b1_y * t11 - 2.0 * s1_x * t48;
            const real t50 = t0 * t11;
            const real t51 = s1_y * t50;
            const real t52 = t0 * (0.6 * t49 - 4.6475800154489 * t51);
            De[24 * 8 + j] = t52; /* De(3,4) */
            De[20 * 8 + j] = -t52; /* De(3,0) */
            const real t53 = s1_x * t50;
            const real t54 = 2.0 * s1_y * t48 + b1_x * t11;
            const real t55 = t0 * (4.6475800154489 * t53 - 0.6 * t54);
            De[25 * 8 + j] = t55; /* De(3,5) */
            De[21 * 8 + j] = -t55; /* De(3,1) */
            De[22 * 8 + j] = 0.5872983346207417 * t49 + 3.32379000772445 * t51; /* De(3,2) */
            De[23 * 8 + j] = -(0.5872983346207417 * t54 + 3.32379000772445 * t53); /* De(3,3) */
            De[26 * 8 + j] = 1.3237900077244502 * t51 - 0.1872983346207417 * t49; /* De(3,6) */
            De[27 * 8 + j] = 0.1872983346207417 * t54 - 1.3237900077244502 * t53; /* De(3,7) */
            const real t56 = t17 * t18;
            const real t57 = b2_y * t17 - 2.0 * s2_x * t56;
            const real t58 = 1.5 * (t0 * t57);
            De[32 * 8 + j] = t58; /* De(4,4) */
            De[28 * 8 + j] = -t58; /* De(4,0) */
            const real t59 = b2_x * t17 + 2.0 * s2_y * t56;
            const real t60 = 1.5 * (t0 * t59);
            De[29 * 8 + j] = t60; /* De(4,1) */
            const real t61 = t0 * t17;
            const real t62 = s2_y * t61;
            const real t63 = 0.25 * t57;
            De[30 * 8 + j] = t62 - t63; /* De(4,2) */
            const real t64 = 0.25 * t59;
            const real t65 = s2_x * t61;
            De[31 * 8 + j] = t64 - t65; /* De(4,3) */
            De[33 * 8 + j] = -t60; /* De(4,5) */
            De[34 * 8 + j] = -(t63 + t62); /* De(4,6) */
            De[35 * 8 + j] = t64 + t65; /* De(4,7) */
            const real t66 = t19 * t22;
            const real t67 = b3_y * t19 - 2.0 * s3_x * t66;
            const real t68 = t0 * t19;
            const real t69 = s3_y * t68;
            const real t70 = t0 * (0.6 * t67 + 4.6475800154489 * t69);
            De[40 * 8 + j] = t70; /* De(5,4) */
            De[36 * 8 + j] = -t70; /* De(5,0) */
            const real t71 = 2.0 * s3_y * t66 + b3_x * t19;
            const real t72 = s3_x * t68;
            const real t73 = t0 * (0.6 * t71 + 4.6475800154489 * t72);
            De[37 * 8 + j] = t73; /* De(5,1) */
            De[38 * 8 + j] = -(0.1872983346207417 * t67 + 1.3237900077244502 * t69); /* De(5,2) */
            De[39 * 8 + j] = 0.1872983346207417 * t71 + 1.3237900077244502 * t72; /* De(5,3) */
            De[41 * 8 + j] = -t73; /* De(5,5) */
            De[42 * 8 + j] = 0.5872983346207417 * t67 - 3.32379000772445 * t69; /* De(5,6) */
            De[43 * 8 + j] = 3.32379000772445 * t72 - 0.5872983346207417 * t71; /* De(5,7) */
        }
    }
}

/* acceleration: 289 operations.
 * in:  x (8), v (8), p (4)
 * out: g (6), gs (0) */
FLEXEL_CLONES
static void planar_cable_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict g = out[0] + b * (6 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = d_x * t0;
            const real dp_x = x[2 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            const real s2_x = 1.5 * t1 - 0.25 * (dp_x + dq_x);
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t2 = d_y * t0;
            const real dp_y = x[3 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            const real s2_y = 1.5 * t2 - 0.25 * (dp_y + dq_y);
            const real t3 = s2_x * s2_x + s2_y * s2_y;
            const real t4 = 1.0 / real_sqrt(t3);
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t5 = t0 * (q_vx - p_vx);
            const real dp_vx = v[2 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t6 = 1.5 * t5 - 0.25 * (dp_vx + dq_vx);
            const real q_vy = v[5 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t7 = t0 * (q_vy - p_vy);
            const real dp_vy = v[3 * 8 + j];
            const real dq_vy = v[7 * 8 + j];
            const real t8 = 1.5 * t7 - 0.25 * (dp_vy + dq_vy);
            const real t9 = t6 * t6 + t8 * t8;
            const real t10 = s2_x * t6 + s2_y * t8;
            const real t11 = 0.6 * t1;
            const real s1_x = 0.5872983346207417 * dp_x + t11 - 0.1872983346207417 * dq_x;
            const real t12 = 0.6 * t2;
            const real s1_y = 0.5872983346207417 * dp_y + t12 - 0.1872983346207417 * dq_y;
            const real t13 = s1_x * s1_x + s1_y * s1_y;
            const real t14 = 1.0 / real_sqrt(t13);
            const real t15 = 0.6 * t5;
            const real t16 = 0.5872983346207417 * dp_vx + t15 - 0.1872983346207417 * dq_vx;
            const real t17 = 0.6 * t7;
            const real t18 = 0.5872983346207417 * dp_vy + t17 - 0.1872983346207417 * dq_vy;
            const real t19 = t16 * t16 + t18 * t18;
            const real t20 = s1_x * t16 + s1_y * t18;
            const real s3_x = t11 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real s3_y = t12 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t21 = s3_x * s3_x + s3_y * s3_y;
            const real t22 = 1.0 / real_sqrt(t21);
            const real t23 = t15 + 0.5872983346207417 * dq_vx - 0.1872983346207417 * dp_vx;
            const real t24 = t17 + 0.5872983346207417 * dq_vy - 0.1872983346207417 * dp_vy;
            const real t25 = t23 * t23 + t24 * t24;
            const real t26 = s3_x * t23 + s3_y * t24;
            const real t27 = t14 * (t19 - t20 * t20 * t14 * t14) + t22 * (t25 - t26 * t26 * t22 * t22);
            const real t28 = 0.4444444444444444 * (t4 * (t9 - t4 * t10 * t4 * t10)) + 0.2777777777777778 * t27;
            g[0 * 8 + j] = t28;
            const real nq = real_sqrt(dq_x * dq_x + dq_y * dq_y);
            const real t29 = 1.0 / nq;
            const real t30 = dq_x * dq_vx + dq_y * dq_vy;
            const real t31 = t29 * (dq_vx * dq_vx + dq_vy * dq_vy - t29 * t30 * t29 * t30);
            const real np = real_sqrt(dp_x * dp_x + dp_y * dp_y);
            const real t32 = 1.0 / np;
            const real t33 = dp_x * dp_vx + dp_y * dp_vy;
            const real t34 = t32 * (dp_vx * dp_vx + dp_vy * dp_vy - t32 * t33 * t32 * t33);
            g[1 * 8 + j] = 0.5 * (t31 - t34);
            g[2 * 8 + j] = 0.5 * (t34 + t31) - t28;
            const real t35 = 1.0 / t13;
            const real t36 = 4.6475800154489 * t7;
            const real t37 = t36 - 3.32379000772445 * dp_vy - 1.3237900077244502 * dq_vy;
            const real t38 = t0 * t37;
            const real t39 = 4.6475800154489 * t5;
            const real t40 = t39 - 3.32379000772445 * dp_vx - 1.3237900077244502 * dq_vx;
            const real t41 = t0 * t40;
            const real t42 = t35 * t35;
            const real t43 = t42 * t20;
            const real t44 = 4.6475800154489 * t2;
            const real t45 = t44 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t45;
            const real t46 = 4.6475800154489 * t1;
            const real t47 = t46 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t47;
            const real t48 = t43 * (b1_y * t16 + s1_x * t38 - b1_x * t18 - s1_y * t41);
            const real t49 = (s1_x * b1_y - s1_y * b1_x) * (2.0 * t42 * t19 - 8.0 * t35 * t20 * t43);
            g[3 * 8 + j] = 2.0 * t35 * (t16 * t38 - t18 * t41) - 4.0 * t48 - t49;
            const real t50 = 1.0 / t3;
            const real t51 = t0 * (dq_vy - dp_vy);
            const real t52 = t0 * (dq_vx - dp_vx);
            const real t53 = t50 * t50;
            const real t54 = t53 * t10;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t55 = 4.0 * t54 * (b2_y * t6 + s2_x * t51 - b2_x * t8 - s2_y * t52);
            const real t56 = (s2_x * b2_y - s2_y * b2_x) * (2.0 * t53 * t9 - 8.0 * t50 * t10 * t54);
            g[4 * 8 + j] = 2.0 * t50 * (t6 * t51 - t8 * t52) - t55 - t56;
            const real t57 = 1.0 / t21;
            const real t58 = 1.3237900077244502 * dp_vy + 3.32379000772445 * dq_vy - t36;
            const real t59 = t0 * t58;
            const real t60 = 1.3237900077244502 * dp_vx + 3.32379000772445 * dq_vx - t39;
            const real t61 = t0 * t60;
            const real t62 = t57 * t57;
            const real t63 = t62 * t26;
            const real t64 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t44;
            const real b3_y = t0 * t64;
            const real t65 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t46;
            const real b3_x = t0 * t65;
            const real t66 = t63 * (b3_y * t23 + t59 * s3_x - b3_x * t24 - t61 * s3_y);
            const real t67 = (b3_y * s3_x - b3_x * s3_y) * (2.0 * t62 * t25 - 8.0 * t57 * t26 * t63);
            g[5 * 8 + j] = 2.0 * t57 * (t59 * t23 - t61 * t24) - 4.0 * t66 - t67;
        }
    }
}

/* rates: 455 operations.
 * in:  x (8), v (8), p (4)
 * out: Phi_x (6,8), 44 of 48 entries */
FLEXEL_CLONES
static void planar_cable_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (44 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t1 = d_x * t0;
            const real dp_x = x[2 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            const real s2_x = 1.5 * t1 - 0.25 * (dp_x + dq_x);
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t2 = d_y * t0;
            const real dp_y = x[3 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            const real s2_y = 1.5 * t2 - 0.25 * (dp_y + dq_y);
            const real t3 = s2_x * s2_x + s2_y * s2_y;
            const real t4 = 1.0 / real_sqrt(t3);
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t5 = t0 * (q_vx - p_vx);
            const real dp_vx = v[2 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t6 = 1.5 * t5 - 0.25 * (dp_vx + dq_vx);
            const real q_vy = v[5 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t7 = t0 * (q_vy - p_vy);
            const real dp_vy = v[3 * 8 + j];
            const real dq_vy = v[7 * 8 + j];
            const real t8 = 1.5 * t7 - 0.25 * (dp_vy + dq_vy);
            const real t9 = s2_x * t6 + s2_y * t8;
            const real t10 = t4 * t9 * t4 * t4;
            const real t11 = t4 * t6 - s2_x * t10;
            const real t12 = 0.6 * t1;
            const real s3_x = t12 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real t13 = 0.6 * t2;
            const real s3_y = t13 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t14 = s3_x * s3_x + s3_y * s3_y;
            const real t15 = 1.0 / real_sqrt(t14);
            const real t16 = 0.6 * t5;
            const real t17 = t16 + 0.5872983346207417 * dq_vx - 0.1872983346207417 * dp_vx;
            const real t18 = 0.6 * t7;
            const real t19 = t18 + 0.5872983346207417 * dq_vy - 0.1872983346207417 * dp_vy;
            const real t20 = s3_x * t17 + s3_y * t19;
            const real t21 = t15 * t20 * t15 * t15;
            const real t22 = t15 * t17 - s3_x * t21;
            const real s1_x = 0.5872983346207417 * dp_x + t12 - 0.1872983346207417 * dq_x;
            const real s1_y = 0.5872983346207417 * dp_y + t13 - 0.1872983346207417 * dq_y;
            const real t23 = s1_x * s1_x + s1_y * s1_y;
            const real t24 = 1.0 / real_sqrt(t23);
            const real t25 = 0.5872983346207417 * dp_vx + t16 - 0.1872983346207417 * dq_vx;
            const real t26 = 0.5872983346207417 * dp_vy + t18 - 0.1872983346207417 * dq_vy;
            const real t27 = s1_x * t25 + s1_y * t26;
            const real t28 = t24 * t27 * t24 * t24;
            const real t29 = t24 * t25 - s1_x * t28;
            const real t30 = 0.6666666666666666 * t11 + 0.16666666666666666 * (t22 + t29);
            const real t31 = t0 * t30;
            Phi_x[4 * 8 + j] = Phi_x[12 * 8 + j] = t31; /* Phi_x(0,4) Phi_x(2,0) */
            Phi_x[0 * 8 + j] = Phi_x[16 * 8 + j] = -t31; /* Phi_x(0,0) Phi_x(2,4) */
            const real t32 = t4 * t8 - s2_y * t10;
            const real t33 = t15 * t19 - s3_y * t21;
            const real t34 = t24 * t26 - s1_y * t28;
            const real t35 = 0.6666666666666666 * t32 + 0.16666666666666666 * (t33 + t34);
            const real t36 = t0 * t35;
            Phi_x[5 * 8 + j] = Phi_x[13 * 8 + j] = t36; /* Phi_x(0,5) Phi_x(2,1) */
            Phi_x[1 * 8 + j] = Phi_x[17 * 8 + j] = -t36; /* Phi_x(0,1) Phi_x(2,5) */
            const real t37 = 0.16313842628353936 * t29;
            const real t38 = 0.05202731517242825 * t22;
            const real t39 = 0.1111111111111111 * t11;
            Phi_x[2 * 8 + j] = t37 - t38 - t39; /* Phi_x(0,2) */
            const real t40 = 0.16313842628353936 * t34;
            const real t41 = 0.05202731517242825 * t33;
            const real t42 = 0.1111111111111111 * t32;
            Phi_x[3 * 8 + j] = t40 - t41 - t42; /* Phi_x(0,3) */
            const real t43 = 0.16313842628353936 * t22;
            const real t44 = 0.05202731517242825 * t29;
            Phi_x[6 * 8 + j] = t43 - t39 - t44; /* Phi_x(0,6) */
            const real t45 = 0.16313842628353936 * t33;
            const real t46 = 0.05202731517242825 * t34;
            Phi_x[7 * 8 + j] = t45 - t42 - t46; /* Phi_x(0,7) */
            const real np = real_sqrt(dp_x * dp_x + dp_y * dp_y);
            const real t47 = 1.0 / np;
            const real t48 = t47 * (dp_x * dp_vx + dp_y * dp_vy) * t47 * t47;
            const real t49 = dp_x * t48;
            const real t50 = 0.5 * dp_vx * t47;
            Phi_x[8 * 8 + j] = 0.5 * t49 - t50; /* Phi_x(1,2) */
            const real t51 = dp_y * t48;
            const real t52 = 0.5 * dp_vy * t47;
            Phi_x[9 * 8 + j] = 0.5 * t51 - t52; /* Phi_x(1,3) */
            const real nq = real_sqrt(dq_x * dq_x + dq_y * dq_y);
            const real t53 = 1.0 / nq;
            const real t54 = 0.5 * dq_vx * t53;
            const real t55 = t53 * (dq_x * dq_vx + dq_y * dq_vy) * t53 * t53;
            const real t56 = 0.25 * dq_x * t55;
            Phi_x[10 * 8 + j] = t54 - t56 - t56; /* Phi_x(1,6) */
            const real t57 = 0.5 * dq_vy * t53;
            const real t58 = 0.25 * dq_y * t55;
            Phi_x[11 * 8 + j] = t57 - t58 - t58; /* Phi_x(1,7) */
            const real t59 = 0.25 * t49;
            Phi_x[14 * 8 + j] = t50 + t39 + t38 - t37 - t59 - t59; /* Phi_x(2,2) */
            const real t60 = 0.25 * t51;
            Phi_x[15 * 8 + j] = t52 + t42 + t41 - t40 - t60 - t60; /* Phi_x(2,3) */
            Phi_x[18 * 8 + j] = t54 + t44 + t39 - t43 - t56 - t56; /* Phi_x(2,6) */
            Phi_x[19 * 8 + j] = t57 + t46 + t42 - t45 - t58 - t58; /* Phi_x(2,7) */
            const real t61 = 1.0 / t23;
            const real t62 = t61 * t61;
            const real t63 = t62 * t27;
            const real t64 = t0 * (2.0 * s1_y * t63 - t61 * t26);
            const real t65 = 4.6475800154489 * t7;
            const real t66 = t65 - 3.32379000772445 * dp_vy - 1.3237900077244502 * dq_vy;
            const real t67 = t0 * t66;
            const real t68 = 4.6475800154489 * t2;
            const real t69 = t68 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t69;
            const real t70 = 4.6475800154489 * t1;
            const real t71 = t70 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t71;
            const real t72 = s1_x * b1_y - s1_y * b1_x;
            const real t73 = t72 * t62;
            const real t74 = b1_y * t25 + s1_x * t67 - 4.0 * t61 * t72 * t27 - b1_x * t26;
            const real t75 = 4.6475800154489 * t5;
            const real t76 = t75 - 3.32379000772445 * dp_vx - 1.3237900077244502 * dq_vx;
            const real t77 = t0 * t76;
            const real t78 = t62 * (t74 - s1_y * t77);
            const real t79 = t61 * t67 - 2.0 * (s1_x * t78 + b1_y * t63 + t25 * t73);
            const real t80 = t0 * (4.6475800154489 * t64 + 0.6 * t79);
            Phi_x[24 * 8 + j] = t80; /* Phi_x(3,4) */
            Phi_x[20 * 8 + j] = -t80; /* Phi_x(3,0) */
            const real t81 = t0 * (t61 * t25 - 2.0 * s1_x * t63);
            const real t82 = 2.0 * (b1_x * t63 - s1_y * t78 - t26 * t73) - t61 * t77;
            const real t83 = t0 * (4.6475800154489 * t81 + 0.6 * t82);
            Phi_x[25 * 8 + j] = t83; /* Phi_x(3,5) */
            Phi_x[21 * 8 + j] = -t83; /* Phi_x(3,1) */
            Phi_x[22 * 8 + j] = 0.5872983346207417 * t79 - 3.32379000772445 * t64; /* Phi_x(3,2) */
            Phi_x[23 * 8 + j] = 0.5872983346207417 * t82 - 3.32379000772445 * t81; /* Phi_x(3,3) */
            Phi_x[26 * 8 + j] = -(1.3237900077244502 * t64 + 0.1872983346207417 * t79); /* Phi_x(3,6) */
            Phi_x[27 * 8 + j] = -(1.3237900077244502 * t81 + 0.1872983346207417 * t82); /* Phi_x(3,7) */
            const real t84 = 1.0 / t3;
            const real t85 = t0 * (dq_vy - dp_vy);
            const real t86 = t84 * t84;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t87 = s2_x * b2_y - s2_y * b2_x;
            const real t88 = b2_y * t6 + s2_x * t85 - 4.0 * t84 * t87 * t9 - b2_x * t8;
            const real t89 = t0 * (dq_vx - dp_vx);
            const real t90 = t86 * (t88 - s2_y * t89);
            const real t91 = t87 * t86;
            const real t92 = t86 * t9;
            const real t93 = t84 * t85 - 2.0 * (t91 * t6 + b2_y * t92 + s2_x * t90);
            const real t94 = 1.5 * (t0 * t93);
            Phi_x[32 * 8 + j] = t94; /* Phi_x(4,4) */
            Phi_x[28 * 8 + j] = -t94; /* Phi_x(4,0) */
            const real t95 = 2.0 * (b2_x * t92 - s2_y * t90 - t91 * t8) - t84 * t89;
            const real t96 = 1.5 * (t0 * t95);
            Phi_x[33 * 8 + j] = t96; /* Phi_x(4,5) */
            Phi_x[29 * 8 + j] = -t96; /* Phi_x(4,1) */
            const real t97 = t0 * (2.0 * s2_y * t92 - t84 * t8);
            const real t98 = 0.25 * t93;
            Phi_x[30 * 8 + j] = -(t97 + t98); /* Phi_x(4,2) */
            const real t99 = t0 * (t84 * t6 - 2.0 * s2_x * t92);
            const real t100 = 0.25 * t95;
            Phi_x[31 * 8 + j] = -(t99 + t100); /* Phi_x(4,3) */
            Phi_x[34 * 8 + j] = t97 - t98; /* Phi_x(4,6) */
            Phi_x[35 * 8 + j] = t99 - t100; /* Phi_x(4,7) */
            const real t101 = 1.3237900077244502 * dp_vy + 3.32379000772445 * dq_vy - t65;
            const real t102 = t0 * t101;
            const real t103 = 1.0 / t14;
            const real t104 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t68;
            const real b3_y = t0 * t104;
            const real t105 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t70;
            const real b3_x = t0 * t105;
            const real t106 = b3_y * s3_x - b3_x * s3_y;
            const real t107 = t103 * t103;
            const real t108 = t106 * t107;
            const real t109 = b3_y * t17 + t102 * s3_x - 4.0 * t103 * t106 * t20 - b3_x * t19;
            const real t110 = 1.3237900077244502 * dp_vx + 3.32379000772445 * dq_vx - t75;
            const real t111 = t0 * t110;
            const real t112 = t107 * (t109 - t111 * s3_y);
            const real t113 = t107 * t20;
            const real t114 = t102 * t103 - 2.0 * (s3_x * t112 + b3_y * t113 + t17 * t108);
            const real t115 = t0 * (2.0 * s3_y * t113 - t103 * t19);
            const real t116 = t0 * (0.6 * t114 - 4.6475800154489 * t115);
            Phi_x[40 * 8 + j] = t116; /* Phi_x(5,4) */
            Phi_x[36 * 8 + j] = -t116; /* Phi_x(5,0) */
            const real t117 = 2.0 * (b3_x * t113 - s3_y * t112 - t19 * t108) - t111 * t103;
            const real t118 = t0 * (t103 * t17 - 2.0 * s3_x * t113);
            const real t119 = t0 * (0.6 * t117 - 4.6475800154489 * t118);
            Phi_x[41 * 8 + j] = t119; /* Phi_x(5,5) */
            Phi_x[37 * 8 + j] = -t119; /* Phi_x(5,1) */
            Phi_x[38 * 8 + j] = 1.3237900077244502 * t115 - 0.1872983346207417 * t114; /* Phi_x(5,2) */
            Phi_x[39 * 8 + j] = 1.3237900077244502 * t118 - 0.1872983346207417 * t117; /* Phi_x(5,3) */
            Phi_x[42 * 8 + j] = 3.32379000772445 * t115 + 0.5872983346207417 * t114; /* Phi_x(5,6) */
            Phi_x[43 * 8 + j] = 3.32379000772445 * t118 + 0.5872983346207417 * t117; /* Phi_x(5,7) */
        }
    }
}

/* kinematics: 1030 operations.
 * in:  x (8), v (8), a (8), p (4)
 * out: Psi_x (6,8), 44 of 48 entries, Psi_v (6,8), 44 of 48 entries */
FLEXEL_CLONES
static void planar_cable_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict a = in[2] + b * (8 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (44 * 8);
        real *restrict Psi_v = out[1] + b * (44 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t1 = d_x * t0;
            const real dp_x = x[2 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            const real s2_x = 1.5 * t1 - 0.25 * (dp_x + dq_x);
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t2 = d_y * t0;
            const real dp_y = x[3 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            const real s2_y = 1.5 * t2 - 0.25 * (dp_y + dq_y);
            const real t3 = s2_x * s2_x + s2_y * s2_y;
            const real t4 = 1.0 / real_sqrt(t3);
            const real q_ax = a[4 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t5 = t0 * (q_ax - p_ax);
            const real dp_ax = a[2 * 8 + j];
            const real dq_ax = a[6 * 8 + j];
            const real t6 = 1.5 * t5 - 0.25 * (dp_ax + dq_ax);
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t7 = t0 * (q_vx - p_vx);
            const real dp_vx = v[2 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            const real t8 = 1.5 * t7 - 0.25 * (dp_vx + dq_vx);
            const real t9 = t4 * t4;
            const real q_vy = v[5 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t10 = t0 * (q_vy - p_vy);
            const real dp_vy = v[3 * 8 + j];
            const real dq_vy = v[7 * 8 + j];
            const real t11 = 1.5 * t10 - 0.25 * (dp_vy + dq_vy);
            const real t12 = s2_x * t8 + s2_y * t11;
            const real t13 = t9 * t12;
            const real t14 = t4 * t13;
            const real t15 = t4 * t12;
            const real t16 = t14 + t9 * t15;
            const real q_ay = a[5 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t17 = t0 * (q_ay - p_ay);
            const real dp_ay = a[3 * 8 + j];
            const real dq_ay = a[7 * 8 + j];
            const real t18 = 1.5 * t17 - 0.25 * (dp_ay + dq_ay);
            const real t19 = t8 * t8 + t11 * t11 + s2_x * t6 + s2_y * t18;
            const real t20 = 0.4444444444444444 * (t19 - t12 * t13) - 0.8888888888888888 * (t15 * t15);
            const real t21 = t4 * t9 * t20;
            const real t22 = 0.4444444444444444 * (t4 * t6 - t8 * t16) - s2_x * t21;
            const real t23 = 0.6 * t1;
            const real s3_x = t23 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real t24 = 0.6 * t2;
            const real s3_y = t24 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t25 = s3_x * s3_x + s3_y * s3_y;
            const real t26 = 1.0 / real_sqrt(t25);
            const real t27 = 0.6 * t5;
            const real t28 = t27 + 0.5872983346207417 * dq_ax - 0.1872983346207417 * dp_ax;
            const real t29 = 0.6 * t7;
            const real t30 = t29 + 0.5872983346207417 * dq_vx - 0.1872983346207417 * dp_vx;
            const real t31 = 0.6 * t10;
            const real t32 = t31 + 0.5872983346207417 * dq_vy - 0.1872983346207417 * dp_vy;
            const real t33 = s3_x * t30 + s3_y * t32;
            const real t34 = t26 * t26;
            const real t35 = t33 * t34;
            const real t36 = t26 * t35;
            const real t37 = t26 * t33;
            const real t38 = t36 + t34 * t37;
            const real t39 = 0.6 * t17;
            const real t40 = t39 + 0.5872983346207417 * dq_ay - 0.1872983346207417 * dp_ay;
            const real t41 = t30 * t30 + t32 * t32 + s3_x * t28 + s3_y * t40;
            const real t42 = 0.2777777777777778 * (t41 - t33 * t35) - 0.5555555555555556 * (t37 * t37);
            const real t43 = t26 * t34 * t42;
            const real t44 = 0.2777777777777778 * (t26 * t28 - t30 * t38) - s3_x * t43;
            const real s1_x = 0.5872983346207417 * dp_x + t23 - 0.1872983346207417 * dq_x;
            const real s1_y = 0.5872983346207417 * dp_y + t24 - 0.1872983346207417 * dq_y;
            const real t45 = s1_x * s1_x + s1_y * s1_y;
            const real t46 = 1.0 / real_sqrt(t45);
            const real t47 = 0.5872983346207417 * dp_ax + t27 - 0.1872983346207417 * dq_ax;
            const real t48 = 0.5872983346207417 * dp_vx + t29 - 0.1872983346207417 * dq_vx;
            const real t49 = 0.5872983346207417 * dp_vy + t31 - 0.1872983346207417 * dq_vy;
            const real t50 = s1_x * t48 + s1_y * t49;
            const real t51 = t46 * t46;
            const real t52 = t50 * t51;
            const real t53 = t46 * t52;
            const real t54 = t46 * t50;
            const real t55 = t53 + t51 * t54;
            const real t56 = 0.5872983346207417 * dp_ay + t39 - 0.1872983346207417 * dq_ay;
            const real t57 = t48 * t48 + t49 * t49 + s1_x * t47 + s1_y * t56;
            const real t58 = 0.2777777777777778 * (t57 - t50 * t52) - 0.5555555555555556 * (t54 * t54);
            const real t59 = t46 * t51 * t58;
            const real t60 = 0.2777777777777778 * (t46 * t47 - t48 * t55) - s1_x * t59;
            const real t61 = t0 * (1.5 * t22 + 0.6 * (t44 + t60));
            Psi_x[4 * 8 + j] = Psi_x[12 * 8 + j] = t61; /* Psi_x(0,4) Psi_x(2,0) */
            Psi_x[0 * 8 + j] = Psi_x[16 * 8 + j] = -t61; /* Psi_x(0,0) Psi_x(2,4) */
            const real t62 = 0.4444444444444444 * (t4 * t18 - t11 * t16) - s2_y * t21;
            const real t63 = 0.2777777777777778 * (t26 * t40 - t32 * t38) - s3_y * t43;
            const real t64 = 0.2777777777777778 * (t46 * t56 - t49 * t55) - s1_y * t59;
            const real t65 = t0 * (1.5 * t62 + 0.6 * (t63 + t64));
            Psi_x[5 * 8 + j] = Psi_x[13 * 8 + j] = t65; /* Psi_x(0,5) Psi_x(2,1) */
            Psi_x[1 * 8 + j] = Psi_x[17 * 8 + j] = -t65; /* Psi_x(0,1) Psi_x(2,5) */
            const real t66 = 0.5872983346207417 * t60;
            const real t67 = 0.1872983346207417 * t44;
            const real t68 = 0.25 * t22;
            Psi_x[2 * 8 + j] = t66 - t67 - t68; /* Psi_x(0,2) */
            const real t69 = 0.5872983346207417 * t64;
            const real t70 = 0.1872983346207417 * t63;
            const real t71 = 0.25 * t62;
            Psi_x[3 * 8 + j] = t69 - t70 - t71; /* Psi_x(0,3) */
            const real t72 = 0.5872983346207417 * t44;
            const real t73 = 0.1872983346207417 * t60;
            Psi_x[6 * 8 + j] = t72 - t68 - t73; /* Psi_x(0,6) */
            const real t74 = 0.5872983346207417 * t63;
            const real t75 = 0.1872983346207417 * t64;
            Psi_x[7 * 8 + j] = t74 - t71 - t75; /* Psi_x(0,7) */
            const real np = real_sqrt(dp_x * dp_x + dp_y * dp_y);
            const real t76 = 1.0 / np;
            const real t77 = t76 * t76;
            const real t78 = dp_x * dp_vx + dp_y * dp_vy;
            const real t79 = t77 * t78;
            const real t80 = t76 * t79;
            const real t81 = t76 * t78;
            const real t82 = t80 + t77 * t81;
            const real t83 = 0.5 * (dp_vx * t82 - dp_ax * t76);
            const real t84 = dp_vx * dp_vx + dp_vy * dp_vy + dp_x * dp_ax + dp_y * dp_ay;
            const real t85 = t76 * t77 * (t81 * t81 + 0.5 * (t78 * t79 - t84));
            const real t86 = dp_x * t85;
            const real t87 = 0.5 * t86;
            Psi_x[8 * 8 + j] = t83 - t87 - t87; /* Psi_x(1,2) */
            const real t88 = 0.5 * (dp_vy * t82 - dp_ay * t76);
            const real t89 = dp_y * t85;
            const real t90 = 0.5 * t89;
            Psi_x[9 * 8 + j] = t88 - t90 - t90; /* Psi_x(1,3) */
            const real nq = real_sqrt(dq_x * dq_x + dq_y * dq_y);
            const real t91 = 1.0 / nq;
            const real t92 = t91 * t91;
            const real t93 = dq_x * dq_vx + dq_y * dq_vy;
            const real t94 = t92 * t93;
            const real t95 = t91 * t94;
            const real t96 = t91 * t93;
            const real t97 = t95 + t92 * t96;
            const real t98 = 0.5 * (dq_ax * t91 - dq_vx * t97);
            const real t99 = dq_vx * dq_vx + dq_vy * dq_vy + dq_x * dq_ax + dq_y * dq_ay;
            const real t100 = t91 * t92 * (0.5 * (t99 - t93 * t94) - t96 * t96);
            const real t101 = 0.5 * dq_x * t100;
            Psi_x[10 * 8 + j] = t98 - t101 - t101; /* Psi_x(1,6) */
            const real t102 = 0.5 * (dq_ay * t91 - dq_vy * t97);
            const real t103 = 0.5 * dq_y * t100;
            Psi_x[11 * 8 + j] = t102 - t103 - t103; /* Psi_x(1,7) */
            Psi_x[14 * 8 + j] = t67 + t86 + t68 - t83 - t66; /* Psi_x(2,2) */
            Psi_x[15 * 8 + j] = t70 + t89 + t71 - t88 - t69; /* Psi_x(2,3) */
            Psi_x[18 * 8 + j] = t68 + t73 + t98 - t72 - t101 - t101; /* Psi_x(2,6) */
            Psi_x[19 * 8 + j] = t71 + t75 + t102 - t74 - t103 - t103; /* Psi_x(2,7) */
            const real t104 = 1.0 / t45;
            const real t105 = t104 * t104;
            const real t106 = t105 * t50;
            const real t107 = t104 * t106;
            const real t108 = 2.0 * t105 * t57 - 8.0 * t50 * t107;
            const real t109 = t0 * (4.0 * t49 * t106 + s1_y * t108 - t104 * t56);
            const real t110 = 4.6475800154489 * t17;
            const real t111 = t110 - 3.32379000772445 * dp_ay - 1.3237900077244502 * dq_ay;
            const real t112 = t0 * t111;
            const real t113 = 4.6475800154489 * t2;
            const real t114 = t113 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t114;
            const real t115 = 4.6475800154489 * t1;
            const real t116 = t115 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t116;
            const real t117 = s1_x * b1_y - s1_y * b1_x;
            const real t118 = 4.6475800154489 * t10;
            const real t119 = t118 - 3.32379000772445 * dp_vy - 1.3237900077244502 * dq_vy;
            const real t120 = t0 * t119;
            const real t121 = 4.6475800154489 * t7;
            const real t122 = t121 - 3.32379000772445 * dp_vx - 1.3237900077244502 * dq_vx;
            const real t123 = t0 * t122;
            const real t124 = t117 * t50;
            const real t125 = 2.0 * t104 * t124;
            const real t126 = b1_y * t48 + s1_x * t120 - b1_x * t49 - s1_y * t123 - t125;
            const real t127 = 4.0 * t117 * t107 - 2.0 * t105 * t126;
            const real t128 = t117 * t105;
            const real t129 = t48 * t120 + 4.0 * t106 * t124 - t49 * t123 - t104 * (4.0 * t50 * t126 + 2.0 * t117
                * t57);
            const real t130 = 4.6475800154489 * t5;
            const real t131 = t130 - 3.32379000772445 * dp_ax - 1.3237900077244502 * dq_ax;
            const real t132 = t0 * t131;
            const real t133 = b1_y * t47 + s1_x * t112 + 2.0 * t129 - b1_x * t56 - s1_y * t132;
            const real t134 = t105 * t133;
            const real t135 = t48 * t127 - t128 * t47 - 2.0 * t120 * t106 - s1_x * t134;
            const real t136 = t104 * t112 + 2.0 * t135 - b1_y * t108;
            const real t137 = t0 * (4.6475800154489 * t109 + 0.6 * t136);
            Psi_x[24 * 8 + j] = t137; /* Psi_x(3,4) */
            Psi_x[20 * 8 + j] = -t137; /* Psi_x(3,0) */
            const real t138 = t0 * (t104 * t47 - 4.0 * t48 * t106 - s1_x * t108);
            const real t139 = 2.0 * t123 * t106 + t49 * t127 - t128 * t56 - s1_y * t134;
            const real t140 = 2.0 * t139 + b1_x * t108 - t104 * t132;
            const real t141 = t0 * (4.6475800154489 * t138 + 0.6 * t140);
            Psi_x[25 * 8 + j] = t141; /* Psi_x(3,5) */
            Psi_x[21 * 8 + j] = -t141; /* Psi_x(3,1) */
            Psi_x[22 * 8 + j] = 0.5872983346207417 * t136 - 3.32379000772445 * t109; /* Psi_x(3,2) */
            Psi_x[23 * 8 + j] = 0.5872983346207417 * t140 - 3.32379000772445 * t138; /* Psi_x(3,3) */
            Psi_x[26 * 8 + j] = -(1.3237900077244502 * t109 + 0.1872983346207417 * t136); /* Psi_x(3,6) */
            Psi_x[27 * 8 + j] = -(1.3237900077244502 * t138 + 0.1872983346207417 * t140); /* Psi_x(3,7) */
            const real t142 = 1.0 / t3;
            const real t143 = t0 * (dq_ay - dp_ay);
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t144 = s2_x * b2_y - s2_y * b2_x;
            const real t145 = t142 * t142;
            const real t146 = t145 * t12;
            const real t147 = t142 * t146;
            const real t148 = t0 * (dq_vy - dp_vy);
            const real t149 = t0 * (dq_vx - dp_vx);
            const real t150 = t144 * t12;
            const real t151 = 2.0 * t142 * t150;
            const real t152 = b2_y * t8 + s2_x * t148 - b2_x * t11 - s2_y * t149 - t151;
            const real t153 = 4.0 * t144 * t147 - 2.0 * t145 * t152;
            const real t154 = t144 * t145;
            const real t155 = t8 * t148 + 4.0 * t146 * t150 - t11 * t149 - t142 * (4.0 * t12 * t152 + 2.0 * t144
                * t19);
            const real t156 = t0 * (dq_ax - dp_ax);
            const real t157 = b2_y * t6 + s2_x * t143 + 2.0 * t155 - b2_x * t18 - s2_y * t156;
            const real t158 = t145 * t157;
            const real t159 = 2.0 * (t8 * t153 - t154 * t6 - 2.0 * t148 * t146 - s2_x * t158);
            const real t160 = 2.0 * t145 * t19 - 8.0 * t12 * t147;
            const real t161 = t142 * t143 + t159 - b2_y * t160;
            const real t162 = 1.5 * (t0 * t161);
            Psi_x[32 * 8 + j] = t162; /* Psi_x(4,4) */
            Psi_x[28 * 8 + j] = -t162; /* Psi_x(4,0) */
            const real t163 = 2.0 * t149 * t146 + t11 * t153 - t154 * t18 - s2_y * t158;
            const real t164 = 2.0 * t163 + b2_x * t160 - t142 * t156;
            const real t165 = 1.5 * (t0 * t164);
            Psi_x[33 * 8 + j] = t165; /* Psi_x(4,5) */
            Psi_x[29 * 8 + j] = -t165; /* Psi_x(4,1) */
            const real t166 = t0 * (4.0 * t11 * t146 + s2_y * t160 - t142 * t18);
            const real t167 = 0.25 * t161;
            Psi_x[30 * 8 + j] = -(t166 + t167); /* Psi_x(4,2) */
            const real t168 = t0 * (t142 * t6 - 4.0 * t8 * t146 - s2_x * t160);
            const real t169 = 0.25 * t164;
            Psi_x[31 * 8 + j] = -(t168 + t169); /* Psi_x(4,3) */
            Psi_x[34 * 8 + j] = t166 - t167; /* Psi_x(4,6) */
            Psi_x[35 * 8 + j] = t168 - t169; /* Psi_x(4,7) */
            const real t170 = 1.0 / t25;
            const real t171 = 1.3237900077244502 * dp_ay + 3.32379000772445 * dq_ay - t110;
            const real t172 = t0 * t171;
            const real t173 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t113;
            const real b3_y = t0 * t173;
            const real t174 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t115;
            const real b3_x = t0 * t174;
            const real t175 = b3_y * s3_x - b3_x * s3_y;
            const real t176 = t170 * t170;
            const real t177 = t176 * t33;
            const real t178 = t170 * t177;
            const real t179 = 1.3237900077244502 * dp_vy + 3.32379000772445 * dq_vy - t118;
            const real t180 = t0 * t179;
            const real t181 = 1.3237900077244502 * dp_vx + 3.32379000772445 * dq_vx - t121;
            const real t182 = t0 * t181;
            const real t183 = t175 * t33;
            const real t184 = 2.0 * t170 * t183;
            const real t185 = b3_y * t30 + t180 * s3_x - b3_x * t32 - t182 * s3_y - t184;
            const real t186 = 4.0 * t175 * t178 - 2.0 * t176 * t185;
            const real t187 = t175 * t176;
            const real t188 = t180 * t30 + 4.0 * t177 * t183 - t182 * t32 - t170 * (4.0 * t33 * t185 + 2.0 * t175
                * t41);
            const real t189 = 1.3237900077244502 * dp_ax + 3.32379000772445 * dq_ax - t130;
            const real t190 = t0 * t189;
            const real t191 = b3_y * t28 + s3_x * t172 + 2.0 * t188 - b3_x * t40 - s3_y * t190;
            const real t192 = t176 * t191;
            const real t193 = t30 * t186 - t187 * t28 - 2.0 * t180 * t177 - s3_x * t192;
            const real t194 = 2.0 * t176 * t41 - 8.0 * t33 * t178;
            const real t195 = t170 * t172 + 2.0 * t193 - b3_y * t194;
            const real t196 = t0 * (4.0 * t32 * t177 + s3_y * t194 - t170 * t40);
            const real t197 = t0 * (0.6 * t195 - 4.6475800154489 * t196);
            Psi_x[40 * 8 + j] = t197; /* Psi_x(5,4) */
            Psi_x[36 * 8 + j] = -t197; /* Psi_x(5,0) */
            const real t198 = 2.0 * t182 * t177 + t32 * t186 - t187 * t40 - s3_y * t192;
            const real t199 = 2.0 * t198 + b3_x * t194 - t170 * t190;
            const real t200 = t0 * (t170 * t28 - 4.0 * t30 * t177 - s3_x * t194);
            const real t201 = t0 * (0.6 * t199 - 4.6475800154489 * t200);
            Psi_x[41 * 8 + j] = t201; /* Psi_x(5,5) */
            Psi_x[37 * 8 + j] = -t201; /* Psi_x(5,1) */
            Psi_x[38 * 8 + j] = 1.3237900077244502 * t196 - 0.1872983346207417 * t195; /* Psi_x(5,2) */
            Psi_x[39 * 8 + j] = 1.3237900077244502 * t200 - 0.1872983346207417 * t199; /* Psi_x(5,3) */
            Psi_x[42 * 8 + j] = 3.32379000772445 * t196 + 0.5872983346207417 * t195; /* Psi_x(5,6) */
            Psi_x[43 * 8 + j] = 3.32379000772445 * t200 + 0.5872983346207417 * t199; /* Psi_x(5,7) */
            const real t202 = t4 * t8 - s2_x * t14;
            const real t203 = t26 * t30 - s3_x * t36;
            const real t204 = t46 * t48 - s1_x * t53;
            const real t205 = 0.6666666666666666 * t202 + 0.16666666666666666 * (t203 + t204);
            const real t206 = 2.0 * t0 * t205;
            Psi_v[4 * 8 + j] = Psi_v[12 * 8 + j] = t206; /* Psi_v(0,4) Psi_v(2,0) */
            Psi_v[0 * 8 + j] = Psi_v[16 * 8 + j] = -t206; /* Psi_v(0,0) Psi_v(2,4) */
            const real t207 = t4 * t11 - s2_y * t14;
            const real t208 = t26 * t32 - s3_y * t36;
            const real t209 = t46 * t49 - s1_y * t53;
            const real t210 = 0.6666666666666666 * t207 + 0.16666666666666666 * (t208 + t209);
            const real t211 = 2.0 * t0 * t210;
            Psi_v[5 * 8 + j] = Psi_v[13 * 8 + j] = t211; /* Psi_v(0,5) Psi_v(2,1) */
            Psi_v[1 * 8 + j] = Psi_v[17 * 8 + j] = -t211; /* Psi_v(0,1) Psi_v(2,5) */
            const real t212 = 0.16313842628353936 * t204;
            const real t213 = 0.05202731517242825 * t203;
            const real t214 = 0.1111111111111111 * t202;
            Psi_v[2 * 8 + j] = 2.0 * (t212 - t213 - t214); /* Psi_v(0,2) */
            const real t215 = 0.16313842628353936 * t209;
            const real t216 = 0.05202731517242825 * t208;
            const real t217 = 0.1111111111111111 * t207;
            Psi_v[3 * 8 + j] = 2.0 * (t215 - t216 - t217); /* Psi_v(0,3) */
            const real t218 = 0.16313842628353936 * t203;
            const real t219 = 0.05202731517242825 * t204;
            Psi_v[6 * 8 + j] = 2.0 * (t218 - t214 - t219); /* Psi_v(0,6) */
            const real t220 = 0.16313842628353936 * t208;
            const real t221 = 0.05202731517242825 * t209;
            Psi_v[7 * 8 + j] = 2.0 * (t220 - t217 - t221); /* Psi_v(0,7) */
            const real t222 = dp_x * t80;
            const real t223 = 0.5 * dp_vx * t76;
            Psi_v[8 * 8 + j] = 2.0 * (0.5 * t222 - t223); /* Psi_v(1,2) */
            const real t224 = dp_y * t80;
            const real t225 = 0.5 * dp_vy * t76;
            Psi_v[9 * 8 + j] = 2.0 * (0.5 * t224 - t225); /* Psi_v(1,3) */
            const real t226 = 0.5 * dq_vx * t91;
            const real t227 = 0.25 * dq_x * t95;
            Psi_v[10 * 8 + j] = 2.0 * (t226 - t227 - t227); /* Psi_v(1,6) */
            const real t228 = 0.5 * dq_vy * t91;
            const real t229 = 0.25 * dq_y * t95;
            Psi_v[11 * 8 + j] = 2.0 * (t228 - t229 - t229); /* Psi_v(1,7) */
            const real t230 = 0.25 * t222;
            Psi_v[14 * 8 + j] = 2.0 * (t223 + t214 + t213 - t212 - t230 - t230); /* Psi_v(2,2) */
            const real t231 = 0.25 * t224;
            Psi_v[15 * 8 + j] = 2.0 * (t225 + t217 + t216 - t215 - t231 - t231); /* Psi_v(2,3) */
            Psi_v[18 * 8 + j] = 2.0 * (t226 + t219 + t214 - t218 - t227 - t227); /* Psi_v(2,6) */
            Psi_v[19 * 8 + j] = 2.0 * (t228 + t221 + t217 - t220 - t229 - t229); /* Psi_v(2,7) */
            const real t232 = t0 * (2.0 * s1_y * t106 - t104 * t49);
            const real t233 = t105 * (t126 - t125);
            const real t234 = t104 * t120 - 2.0 * (t48 * t128 + b1_y * t106 + s1_x * t233);
            const real t235 = 2.0 * t0 * (4.6475800154489 * t232 + 0.6 * t234);
            Psi_v[24 * 8 + j] = t235; /* Psi_v(3,4) */
            Psi_v[20 * 8 + j] = -t235; /* Psi_v(3,0) */
            const real t236 = t0 * (t104 * t48 - 2.0 * s1_x * t106);
            const real t237 = 2.0 * (b1_x * t106 - s1_y * t233 - t49 * t128) - t104 * t123;
            const real t238 = 2.0 * t0 * (4.6475800154489 * t236 + 0.6 * t237);
            Psi_v[25 * 8 + j] = t238; /* Psi_v(3,5) */
            Psi_v[21 * 8 + j] = -t238; /* Psi_v(3,1) */
            Psi_v[22 * 8 + j] = 2.0 * (0.5872983346207417 * t234 - 3.32379000772445 * t232); /* Psi_v(3,2) */
            Psi_v[23 * 8 + j] = 2.0 * (0.5872983346207417 * t237 - 3.32379000772445 * t236); /* Psi_v(3,3) */
            const real t239 = 2.0 * (1.3237900077244502 * t232 + 0.1872983346207417 * t234);
            Psi_v[26 * 8 + j] = -t239; /* Psi_v(3,6) */
            const real t240 = 2.0 * (1.3237900077244502 * t236 + 0.1872983346207417 * t237);
            Psi_v[27 * 8 + j] = -t240; /* Psi_v(3,7) */
            const real t241 = t145 * (t152 - t151);
            const real t242 = t142 * t148 - 2.0 * (t154 * t8 + b2_y * t146 + s2_x * t241);
            const real t243 = 3.0 * (t0 * t242);
            Psi_v[32 * 8 + j] = t243; /* Psi_v(4,4) */
            Psi_v[28 * 8 + j] = -t243; /* Psi_v(4,0) */
            const real t244 = 2.0 * (b2_x * t146 - s2_y * t241 - t154 * t11) - t142 * t149;
            const real t245 = 3.0 * (t0 * t244);
            Psi_v[33 * 8 + j] = t245; /* Psi_v(4,5) */
            Psi_v[29 * 8 + j] = -t245; /* Psi_v(4,1) */
            const real t246 = t0 * (2.0 * s2_y * t146 - t142 * t11);
            const real t247 = 0.25 * t242;
            Psi_v[30 * 8 + j] = -(2.0 * (t246 + t247)); /* Psi_v(4,2) */
            const real t248 = t0 * (t142 * t8 - 2.0 * s2_x * t146);
            const real t249 = 0.25 * t244;
            Psi_v[31 * 8 + j] = -(2.0 * (t248 + t249)); /* Psi_v(4,3) */
            Psi_v[34 * 8 + j] = 2.0 * (t246 - t247); /* Psi_v(4,6) */
            Psi_v[35 * 8 + j] = 2.0 * (t248 - t249); /* Psi_v(4,7) */
            const real t250 = t176 * (t185 - t184);
            const real t251 = t180 * t170 - 2.0 * (t30 * t187 + b3_y * t177 + s3_x * t250);
            const real t252 = t0 * (2.0 * s3_y * t177 - t170 * t32);
            const real t253 = 2.0 * t0 * (0.6 * t251 - 4.6475800154489 * t252);
            Psi_v[40 * 8 + j] = t253; /* Psi_v(5,4) */
            Psi_v[36 * 8 + j] = -t253; /* Psi_v(5,0) */
            const real t254 = 2.0 * (b3_x * t177 - s3_y * t250 - t32 * t187) - t182 * t170;
            const real t255 = t0 * (t170 * t30 - 2.0 * s3_x * t177);
            const real t256 = 2.0 * t0 * (0.6 * t254 - 4.6475800154489 * t255);
            Psi_v[41 * 8 + j] = t256; /* Psi_v(5,5) */
            Psi_v[37 * 8 + j] = -t256; /* Psi_v(5,1) */
            Psi_v[38 * 8 + j] = 2.0 * (1.3237900077244502 * t252 - 0.1872983346207417 * t251); /* Psi_v(5,2) */
            Psi_v[39 * 8 + j] = 2.0 * (1.3237900077244502 * t255 - 0.1872983346207417 * t254); /* Psi_v(5,3) */
            Psi_v[42 * 8 + j] = 2.0 * (3.32379000772445 * t252 + 0.5872983346207417 * t251); /* Psi_v(5,6) */
            Psi_v[43 * 8 + j] = 2.0 * (3.32379000772445 * t255 + 0.5872983346207417 * t254); /* Psi_v(5,7) */
        }
    }
}

/* stiffness: 650 operations.
 * in:  x (8), sigma (6), tau (0), p (4)
 * out: K (8,8) */
FLEXEL_CLONES
static void planar_cable_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict sigma = in[1] + b * (6 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict K = out[0] + b * (64 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = t0 * t0;
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t2 = d_x * t0;
            const real t3 = 0.6 * t2;
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real s3_x = t3 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t4 = d_y * t0;
            const real t5 = 0.6 * t4;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real s3_y = t5 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t6 = s3_x * s3_x + s3_y * s3_y;
            const real t7 = 1.0 / t6;
            const real t8 = t7 * t7;
            const real t9 = 4.6475800154489 * t4;
            const real b3_y = t0 * (1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t9);
            const real t10 = 4.6475800154489 * t2;
            const real t11 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t10;
            const real b3_x = t0 * t11;
            const real sigma_curvature3 = sigma[5 * 8 + j];
            const real t12 = sigma_curvature3 * (b3_y * s3_x - b3_x * s3_y);
            const real t13 = 1.0 / real_sqrt(t6);
            const real sigma_strain1 = sigma[0 * 8 + j];
            const real sigma_strain3 = sigma[2 * 8 + j];
            const real t14 = sigma_strain1 - sigma_strain3;
            const real t15 = 2.0 * t7 * t12 * t8 - 0.06944444444444445 * (t13 * t13 * t13 * t14);
            const real t16 = s3_x * t15;
            const real t17 = sigma_curvature3 * t8;
            const real t18 = b3_y * t17;
            const real t19 = t0 * s3_y * t17;
            const real t20 = 0.6 * t18 + 4.6475800154489 * t19;
            const real t21 = 1.2 * t16 - t20;
            const real t22 = s3_x * t21;
            const real s1_x = 0.5872983346207417 * dp_x + t3 - 0.1872983346207417 * dq_x;
            const real s1_y = 0.5872983346207417 * dp_y + t5 - 0.1872983346207417 * dq_y;
            const real t23 = s1_x * s1_x + s1_y * s1_y;
            const real t24 = 1.0 / t23;
            const real t25 = t24 * t24;
            const real sigma_curvature1 = sigma[3 * 8 + j];
            const real t26 = sigma_curvature1 * t25;
            const real t27 = s1_y * t26;
            const real t28 = t0 * t27;
            const real b1_y = t0 * (t9 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y);
            const real t29 = t10 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t29;
            const real t30 = sigma_curvature1 * (s1_x * b1_y - s1_y * b1_x);
            const real t31 = 1.0 / real_sqrt(t23);
            const real t32 = 2.0 * t24 * t30 * t25 - 0.06944444444444445 * (t31 * t31 * t31 * t14);
            const real t33 = 2.0 * s1_x * t32 - b1_y * t26;
            const real t34 = 4.6475800154489 * t28 + 0.6 * t33;
            const real t35 = t0 * s1_y;
            const real t36 = 0.6 * b1_y - 4.6475800154489 * t35;
            const real t37 = s1_x * t26;
            const real t38 = t36 * t37;
            const real s2_x = 1.5 * t2 - 0.25 * (dp_x + dq_x);
            const real s2_y = 1.5 * t4 - 0.25 * (dp_y + dq_y);
            const real t39 = s2_x * s2_x + s2_y * s2_y;
            const real t40 = 1.0 / t39;
            const real t41 = t40 * t40;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real sigma_curvature2 = sigma[4 * 8 + j];
            const real t42 = (s2_x * b2_y - s2_y * b2_x) * sigma_curvature2;
            const real t43 = 1.0 / real_sqrt(t39);
            const real t44 = 2.0 * t40 * t41 * t42 - 0.1111111111111111 * (t43 * t43 * t43 * t14);
            const real t45 = s2_x * t44;
            const real t46 = sigma_curvature2 * t41;
            const real t47 = b2_y * t46;
            const real t48 = 3.0 * t45 - 1.5 * t47;
            const real t49 = s2_x * t48;
            const real t50 = 0.2222222222222222 * (t43 * t14) - t41 * t42;
            const real t51 = 0.1388888888888889 * (t13 * t14) - t8 * t12;
            const real t52 = 0.1388888888888889 * (t31 * t14) - t25 * t30;
            const real t53 = 4.5 * t50 + 0.72 * (t51 + t52);
            const real t54 = 3.0 * t49 + t53 + 1.2 * (t22 + s1_x * t34 - t38 - s3_x * t20);
            const real t55 = t1 * (t54 - 4.5 * (s2_x * t47));
            K[0 * 8 + j] = K[36 * 8 + j] = t55; /* K(0,0) K(4,4) */
            const real t56 = b2_x * t46;
            const real t57 = s2_y * t44;
            const real t58 = 1.5 * t56 + 3.0 * t57;
            const real t59 = s2_x * t58;
            const real t60 = b3_x * t17;
            const real t61 = t0 * s3_x * t17;
            const real t62 = 0.6 * t60 + 4.6475800154489 * t61;
            const real t63 = s3_y * t15;
            const real t64 = t62 + 1.2 * t63;
            const real t65 = s3_x * t64;
            const real t66 = t0 * s1_x;
            const real t67 = 4.6475800154489 * t66 - 0.6 * b1_x;
            const real t68 = t67 * t37;
            const real t69 = 3.0 * t59 + 1.2 * (t65 + s1_y * t34 - t68 - s3_y * t20) - 4.5 * (s2_y * t47);
            const real t70 = t1 * t69;
            K[1 * 8 + j] = K[8 * 8 + j] = K[37 * 8 + j] = K[44 * 8 + j] = t70; /* K(0,1) K(1,0) K(4,5) K(5,4) */
            const real t71 = 0.1872983346207417 * t18 + 1.3237900077244502 * t19;
            const real t72 = s3_x * t71;
            const real t73 = 0.5872983346207417 * t33 - 3.32379000772445 * t28;
            const real t74 = s1_x * t73;
            const real t75 = 0.75 * t50;
            const real t76 = 0.70475800154489 * t52 - t75 - 0.22475800154489003 * t51;
            const real t77 = 0.25 * t47;
            const real t78 = t0 * s2_y;
            const real t79 = t78 * t46;
            const real t80 = t77 - t79;
            const real t81 = s2_x * t80;
            const real t82 = t76 + 3.0 * t81 + 1.2 * (t72 + t74) - 1.1745966692414833 * t38;
            const real t83 = 0.5 * t49;
            const real t84 = t0 * (t82 - t83 - 0.3745966692414834 * t22);
            K[20 * 8 + j] = K[34 * 8 + j] = t84; /* K(2,4) K(4,2) */
            K[2 * 8 + j] = K[16 * 8 + j] = -t84; /* K(0,2) K(2,0) */
            const real t85 = t0 * s2_x;
            const real t86 = t85 * t46;
            const real t87 = 0.25 * t56;
            const real t88 = t86 - t87;
            const real t89 = s2_x * t88;
            const real t90 = t0 * t37;
            const real t91 = b1_x * t26 + 2.0 * s1_y * t32;
            const real t92 = 3.32379000772445 * t90 + 0.5872983346207417 * t91;
            const real t93 = s1_x * t92;
            const real t94 = 0.1872983346207417 * t60 + 1.3237900077244502 * t61;
            const real t95 = s3_x * t94;
            const real t96 = t0 * sigma_curvature1 * t24;
            const real t97 = t0 * sigma_curvature2 * t40;
            const real t98 = 1.5 * t97;
            const real t99 = t0 * sigma_curvature3 * t7;
            const real t100 = t98 + 0.07620999227554986 * t99 + 4.723790007724451 * t96;
            const real t101 = t36 * t27;
            const real t102 = 3.0 * t89 + 1.2 * (t93 - t95) - t100 - 1.1745966692414833 * t101;
            const real t103 = 0.5 * s2_y * t48;
            const real t104 = s3_y * t21;
            const real t105 = t0 * (t102 - t103 - 0.3745966692414834 * t104);
            K[28 * 8 + j] = K[35 * 8 + j] = t105; /* K(3,4) K(4,3) */
            K[3 * 8 + j] = K[24 * 8 + j] = -t105; /* K(0,3) K(3,0) */
            K[4 * 8 + j] = K[32 * 8 + j] = -t55; /* K(0,4) K(4,0) */
            K[5 * 8 + j] = K[12 * 8 + j] = K[33 * 8 + j] = K[40 * 8 + j] = -t70; /* K(0,5) K(1,4) K(4,1) K(5,0) */
            const real t106 = 3.32379000772445 * t19 - 0.5872983346207417 * t18;
            const real t107 = s3_x * t106;
            const real t108 = 1.3237900077244502 * t28 + 0.1872983346207417 * t33;
            const real t109 = s1_x * t108;
            const real t110 = 0.70475800154489 * t51 - t75 - 0.22475800154489003 * t52;
            const real t111 = t77 + t79;
            const real t112 = s2_x * t111;
            const real t113 = 3.0 * t112 + 1.1745966692414833 * t22 + 0.3745966692414834 * t38;
            const real t114 = t0 * (t110 + t113 + 1.2 * (t107 - t109) - t83);
            K[38 * 8 + j] = K[52 * 8 + j] = t114; /* K(4,6) K(6,4) */
            K[6 * 8 + j] = K[48 * 8 + j] = -t114; /* K(0,6) K(6,0) */
            const real t115 = 0.5872983346207417 * t60 - 3.32379000772445 * t61;
            const real t116 = 1.3237900077244502 * t90 - 0.1872983346207417 * t91;
            const real t117 = t98 + 4.723790007724451 * t99 + 0.07620999227554986 * t96;
            const real t118 = 0.3745966692414834 * t101 + 1.1745966692414833 * t104 + t117;
            const real t119 = t87 + t86;
            const real t120 = 1.2 * (s3_x * t115 + s1_x * t116) + t118 - 3.0 * (s2_x * t119);
            const real t121 = t0 * (t120 - t103);
            K[39 * 8 + j] = K[60 * 8 + j] = t121; /* K(4,7) K(7,4) */
            K[7 * 8 + j] = K[56 * 8 + j] = -t121; /* K(0,7) K(7,0) */
            const real t122 = s3_y * t64;
            const real t123 = t122 + s1_y * (0.6 * t91 - 4.6475800154489 * t90) + s3_y * t62;
            const real t124 = t67 * t27;
            const real t125 = s2_y * t58;
            const real t126 = 4.5 * (s2_y * t56) + 3.0 * t125 + t53 + 1.2 * (t123 - t124);
            const real t127 = t1 * t126;
            K[9 * 8 + j] = K[45 * 8 + j] = t127; /* K(1,1) K(5,5) */
            const real t128 = s3_y * t71;
            const real t129 = s1_y * t73;
            const real t130 = s2_y * t80;
            const real t131 = 3.0 * t130 + t100 + 1.2 * (t128 + t129) - 1.1745966692414833 * t68;
            const real t132 = 0.5 * t59;
            const real t133 = t0 * (t131 - t132 - 0.3745966692414834 * t65);
            K[21 * 8 + j] = K[42 * 8 + j] = t133; /* K(2,5) K(5,2) */
            K[10 * 8 + j] = K[17 * 8 + j] = -t133; /* K(1,2) K(2,1) */
            const real t134 = s1_y * t92;
            const real t135 = s3_y * t94;
            const real t136 = s2_y * t88;
            const real t137 = t76 + 3.0 * t136 + 1.2 * (t134 - t135) - 1.1745966692414833 * t124;
            const real t138 = 0.5 * t125;
            const real t139 = t0 * (t137 - t138 - 0.3745966692414834 * t122);
            K[29 * 8 + j] = K[43 * 8 + j] = t139; /* K(3,5) K(5,3) */
            K[11 * 8 + j] = K[25 * 8 + j] = -t139; /* K(1,3) K(3,1) */
            K[13 * 8 + j] = K[41 * 8 + j] = -t127; /* K(1,5) K(5,1) */
            const real t140 = s3_y * t106;
            const real t141 = s1_y * t108;
            const real t142 = s2_y * t111;
            const real t143 = 3.0 * t142 + 1.1745966692414833 * t65 + 1.2 * (t140 - t141);
            const real t144 = t0 * (0.3745966692414834 * t68 + t143 - t117 - t132);
            K[46 * 8 + j] = K[53 * 8 + j] = t144; /* K(5,6) K(6,5) */
            K[14 * 8 + j] = K[49 * 8 + j] = -t144; /* K(1,6) K(6,1) */
            const real t145 = s3_y * t115;
            const real t146 = s1_y * t116;
            const real t147 = 0.3745966692414834 * t124 + 1.1745966692414833 * t122 + t110;
            const real t148 = s2_y * t119;
            const real t149 = t0 * (1.2 * (t145 + t146) + t147 - 3.0 * t148 - t138);
            K[47 * 8 + j] = K[61 * 8 + j] = t149; /* K(5,7) K(7,5) */
            K[15 * 8 + j] = K[57 * 8 + j] = -t149; /* K(1,7) K(7,1) */
            const real t150 = (3.32379000772445 * t35 + 0.5872983346207417 * b1_y) * t37;
            const real t151 = 0.03508066615170333 * t51;
            const real t152 = 0.0625 * t50;
            const real t153 = dp_x * dp_x;
            const real np = real_sqrt(t153 + dp_y * dp_y);
            const real t154 = 1.0 / np;
            const real t155 = 0.5 * sigma_strain3;
            const real sigma_strain2 = sigma[1 * 8 + j];
            const real t156 = 0.5 * sigma_strain2;
            const real t157 = t155 - t156;
            const real t158 = 0.5 * t154 * t157;
            const real t159 = t158 + t151 + t158 + t152;
            const real t160 = 0.6898386676965933 * t52;
            const real t161 = 0.25 * b2_y;
            const real t162 = 0.5 * t45;
            const real t163 = t160 + 0.5 * s2_x * ((t78 - t161) * t46 + t162) + t159 + t152;
            const real t164 = 0.3745966692414834 * (t72 + s3_x * (t71 - 0.3745966692414834 * t16));
            const real t165 = t154 * t154 * t154 * t157;
            const real t166 = t151 + t163 + 1.1745966692414833 * (t74 - t150) - t164 - t153 * t165;
            const real t167 = 0.5 * t81;
            K[18 * 8 + j] = t166 - t167; /* K(2,2) */
            const real t168 = t94 + 0.3745966692414834 * t63;
            const real t169 = 0.25 * b2_x;
            const real t170 = 0.5 * t57;
            const real t171 = (t169 - t85) * t46 + t170;
            const real t172 = 0.5872983346207417 * b1_x + 3.32379000772445 * t66;
            const real t173 = 0.5 * s2_x * t171 + 1.1745966692414833 * (t172 * t37 + t129);
            const real t174 = dp_y * t165;
            const real t175 = 0.3745966692414834 * (s3_x * t168 - t128) + t173 - dp_x * t174;
            const real t176 = 0.5 * t130;
            K[19 * 8 + j] = K[26 * 8 + j] = t175 - t176; /* K(2,3) K(3,2) */
            const real t177 = 0.125 * t50 - 0.22 * t51 - 0.22 * t52;
            const real t178 = t106 + 1.1745966692414833 * t16;
            const real t179 = s3_x * t178;
            const real t180 = t177 + 1.1745966692414833 * t72 - 0.3745966692414834 * (t74 + t179);
            const real t181 = 1.3237900077244502 * t35 - 0.1872983346207417 * b1_y;
            const real t182 = t181 * t37;
            const real t183 = (t78 + t161) * t46 - t162;
            const real t184 = 0.5 * s2_x * t183;
            K[22 * 8 + j] = K[50 * 8 + j] = t180 - 1.1745966692414833 * t182 - t167 - t184; /* K(2,6) K(6,2) */
            const real t185 = (t85 + t169) * t46 + t170;
            const real t186 = 0.5 * s2_x * t185;
            const real t187 = t115 + 1.1745966692414833 * t63;
            const real t188 = s3_x * t187;
            const real t189 = t186 + 1.1745966692414833 * t128 - 0.3745966692414834 * (t129 + t188);
            const real t190 = 0.7774596669241484 * t99 + 0.7774596669241484 * t96 + 0.6225403330758517 * (t99 + t96);
            const real t191 = 0.5 * t97 + t190;
            const real t192 = 0.1872983346207417 * b1_x - 1.3237900077244502 * t66;
            const real t193 = t192 * t37;
            K[23 * 8 + j] = K[58 * 8 + j] = t189 - t191 - 1.1745966692414833 * t193 - t176; /* K(2,7) K(7,2) */
            const real t194 = t160 + 0.5 * s2_y * t171 + t159 + t152 + t151 + 1.1745966692414833 * (t172 * t27
                + t134);
            const real t195 = 0.3745966692414834 * (t135 + s3_y * t168) + t194 - dp_y * t174;
            const real t196 = 0.5 * t136;
            K[27 * 8 + j] = t195 - t196; /* K(3,3) */
            const real t197 = t191 - 0.5 * (t89 + s2_y * t183) - 0.3745966692414834 * (t93 + s3_y * t178);
            K[30 * 8 + j] = K[51 * 8 + j] = t197 - 1.1745966692414833 * (t181 * t27) - 1.1745966692414833 * t95;
                /* K(3,6) K(6,3) */
            const real t198 = 0.5 * s2_y * t185;
            const real t199 = s3_y * t187;
            const real t200 = t192 * t27;
            const real t201 = t177 + t198 - 0.3745966692414834 * (t134 + t199) - 1.1745966692414833 * t200;
            K[31 * 8 + j] = K[59 * 8 + j] = t201 - t196 - 1.1745966692414833 * t135; /* K(3,7) K(7,3) */
            const real t202 = 0.34491933384829665 * t51;
            const real t203 = 0.07016133230340665 * t52;
            const real t204 = dq_x * dq_x;
            const real nq = real_sqrt(t204 + dq_y * dq_y);
            const real t205 = 1.0 / nq;
            const real t206 = t156 + t155;
            const real t207 = 0.5 * t205 * t206;
            const real t208 = t207 + t202 + t207 + t152;
            const real t209 = t203 + t208 + t152 + t202 + 0.3745966692414834 * (t182 + t109);
            const real t210 = t205 * t205 * t205 * t206;
            const real t211 = 1.1745966692414833 * (t107 + t179) + t209 - t204 * t210 - 0.5 * t112;
            K[54 * 8 + j] = t211 - t184; /* K(6,6) */
            const real t212 = t186 + 0.3745966692414834 * (t193 + t141) + 1.1745966692414833 * (t140 + t188);
            const real t213 = dq_y * t210;
            K[55 * 8 + j] = K[62 * 8 + j] = t212 - dq_x * t213 - 0.5 * t142; /* K(6,7) K(7,6) */
            const real t214 = t198 + 0.5 * t148 + t203 + t208 + t152 + t202 + 0.3745966692414834 * (t200 - t146);
            K[63 * 8 + j] = 1.1745966692414833 * (t145 + t199) + t214 - dq_y * t213; /* K(7,7) */
        }
    }
}

/* inertia: 40 operations.
 * in:  x (8), v (8), p (4)
 * out: M (8,8), 32 of 64 entries, h (8), 0 of 8 entries, f (8), U (1) */
FLEXEL_CLONES
static void planar_cable_inertia(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict M = out[0] + b * (32 * 8);
        real *restrict f = out[2] + b * (8 * 8);
        real *restrict U = out[3] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real rhoA = p[1 * 8 + j];
            const real t0 = l0 * rhoA;
            M[0 * 8 + j] = M[4 * 8 + j] = M[18 * 8 + j] = M[22 * 8 + j] = 0.37142857142857144 * t0;
                /* M(0,0) M(1,1) M(4,4) M(5,5) */
            const real t1 = l0 * t0;
            const real t2 = 0.05238095238095238 * t1;
            M[1 * 8 + j] = M[5 * 8 + j] = M[8 * 8 + j] = M[12 * 8 + j] = t2; /* M(0,2) M(1,3) M(2,0) M(3,1) */
            M[2 * 8 + j] = M[6 * 8 + j] = M[16 * 8 + j] = M[20 * 8 + j] = 0.12857142857142856 * t0;
                /* M(0,4) M(1,5) M(4,0) M(5,1) */
            const real t3 = 0.030952380952380953 * t1;
            M[10 * 8 + j] = M[14 * 8 + j] = M[17 * 8 + j] = M[21 * 8 + j] = t3; /* M(2,4) M(3,5) M(4,2) M(5,3) */
            M[3 * 8 + j] = M[7 * 8 + j] = M[24 * 8 + j] = M[28 * 8 + j] = -t3; /* M(0,6) M(1,7) M(6,0) M(7,1) */
            const real t4 = l0 * l0 * t0;
            M[9 * 8 + j] = M[13 * 8 + j] = M[27 * 8 + j] = M[31 * 8 + j] = 0.009523809523809525 * t4;
                /* M(2,2) M(3,3) M(6,6) M(7,7) */
            M[11 * 8 + j] = M[15 * 8 + j] = M[25 * 8 + j] = M[29 * 8 + j] = -(0.007142857142857143 * t4);
                /* M(2,6) M(3,7) M(6,2) M(7,3) */
            M[19 * 8 + j] = M[23 * 8 + j] = M[26 * 8 + j] = M[30 * 8 + j] = -t2; /* M(4,6) M(5,7) M(6,4) M(7,5) */
            const real gravity_x = p[2 * 8 + j];
            const real t5 = gravity_x * t0;
            f[0 * 8 + j] = f[4 * 8 + j] = 0.5 * t5;
            const real gravity_y = p[3 * 8 + j];
            const real t6 = gravity_y * t0;
            f[1 * 8 + j] = f[5 * 8 + j] = 0.5 * t6;
            const real t7 = 0.08333333333333333 * (l0 * t5);
            f[2 * 8 + j] = t7;
            const real t8 = 0.08333333333333333 * (l0 * t6);
            f[3 * 8 + j] = t8;
            f[6 * 8 + j] = -t7;
            f[7 * 8 + j] = -t8;
            const real p_x = x[0 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real t9 = 0.5 * (p_x + q_x) - 0.08333333333333333 * (l0 * (dq_x - dp_x));
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real t10 = 0.5 * (p_y + q_y) - 0.08333333333333333 * (l0 * (dq_y - dp_y));
            U[0 * 8 + j] = -(t0 * (gravity_x * t9 + gravity_y * t10));
        }
    }
}

/* tangent: 0 operations.
 * in:  x (8), v (8), a (8), p (4)
 * out: R_x (8,8), 0 of 64 entries, R_v (8,8), 0 of 64 entries */
FLEXEL_CLONES
static void planar_cable_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* outputs: 132 operations.
 * in:  x (8), e (6), sigma (6), tau (0), p (4)
 * out: arc_length (3), tension (3), strain (3), curvature (3), line (9,2) */
FLEXEL_CLONES
static void planar_cable_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict e = in[1] + b * (6 * 8);
        const real *restrict sigma = in[2] + b * (6 * 8);
        const real *restrict p = in[4] + b * (4 * 8);
        real *restrict arc_length = out[0] + b * (3 * 8);
        real *restrict tension = out[1] + b * (3 * 8);
        real *restrict strain = out[2] + b * (3 * 8);
        real *restrict curvature = out[3] + b * (3 * 8);
        real *restrict line = out[4] + b * (18 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            arc_length[0 * 8 + j] = 0.11270166537925831 * l0;
            arc_length[1 * 8 + j] = 0.5 * l0;
            arc_length[2 * 8 + j] = 0.8872983346207417 * l0;
            const real t0 = 1.0 / l0;
            const real sigma_strain3 = sigma[2 * 8 + j];
            const real sigma_strain1 = sigma[0 * 8 + j];
            const real t1 = sigma_strain1 + 2.0 * sigma_strain3;
            const real sigma_strain2 = sigma[1 * 8 + j];
            const real t2 = 2.32379000772445 * sigma_strain2;
            tension[0 * 8 + j] = t0 * (t1 - t2);
            tension[1 * 8 + j] = t0 * (sigma_strain1 - 2.5 * sigma_strain3);
            tension[2 * 8 + j] = t0 * (t2 + t1);
            const real e_strain3 = e[2 * 8 + j];
            const real e_strain1 = e[0 * 8 + j];
            const real t3 = e_strain1 + 0.4 * e_strain3;
            const real e_strain2 = e[1 * 8 + j];
            const real t4 = 0.7745966692414834 * e_strain2;
            strain[0 * 8 + j] = t3 - t4;
            strain[1 * 8 + j] = e_strain1 - 0.5 * e_strain3;
            strain[2 * 8 + j] = t4 + t3;
            const real e_curvature1 = e[3 * 8 + j];
            curvature[0 * 8 + j] = real_abs(e_curvature1);
            const real e_curvature2 = e[4 * 8 + j];
            curvature[1 * 8 + j] = real_abs(e_curvature2);
            const real e_curvature3 = e[5 * 8 + j];
            curvature[2 * 8 + j] = real_abs(e_curvature3);
            const real p_x = x[0 * 8 + j];
            line[0 * 8 + j] = p_x; /* line(0,0) */
            const real p_y = x[1 * 8 + j];
            line[1 * 8 + j] = p_y; /* line(0,1) */
            const real q_x = x[4 * 8 + j];
            line[16 * 8 + j] = q_x; /* line(8,0) */
            const real dp_x = x[2 * 8 + j];
            const real dq_x = x[6 * 8 + j];
            line[2 * 8 + j] = 0.95703125 * p_x + 0.04296875 * q_x + l0 * (0.095703125 * dp_x - 0.013671875 * dq_x);
                /* line(1,0) */
            const real q_y = x[5 * 8 + j];
            line[17 * 8 + j] = q_y; /* line(8,1) */
            const real dp_y = x[3 * 8 + j];
            const real dq_y = x[7 * 8 + j];
            line[3 * 8 + j] = 0.95703125 * p_y + 0.04296875 * q_y + l0 * (0.095703125 * dp_y - 0.013671875 * dq_y);
                /* line(1,1) */
            line[4 * 8 + j] = 0.84375 * p_x + 0.15625 * q_x + l0 * (0.140625 * dp_x - 0.046875 * dq_x);
                /* line(2,0) */
            line[5 * 8 + j] = 0.84375 * p_y + 0.15625 * q_y + l0 * (0.140625 * dp_y - 0.046875 * dq_y);
                /* line(2,1) */
            line[6 * 8 + j] = 0.68359375 * p_x + 0.31640625 * q_x + l0 * (0.146484375 * dp_x - 0.087890625 * dq_x);
                /* line(3,0) */
            line[7 * 8 + j] = 0.68359375 * p_y + 0.31640625 * q_y + l0 * (0.146484375 * dp_y - 0.087890625 * dq_y);
                /* line(3,1) */
            line[8 * 8 + j] = 0.5 * (p_x + q_x) - 0.125 * l0 * (dq_x - dp_x); /* line(4,0) */
            line[9 * 8 + j] = 0.5 * (p_y + q_y) - 0.125 * l0 * (dq_y - dp_y); /* line(4,1) */
            line[10 * 8 + j] = 0.31640625 * p_x + 0.68359375 * q_x + l0 * (0.087890625 * dp_x - 0.146484375 * dq_x);
                /* line(5,0) */
            line[11 * 8 + j] = 0.31640625 * p_y + 0.68359375 * q_y + l0 * (0.087890625 * dp_y - 0.146484375 * dq_y);
                /* line(5,1) */
            line[12 * 8 + j] = 0.15625 * p_x + 0.84375 * q_x + l0 * (0.046875 * dp_x - 0.140625 * dq_x);
                /* line(6,0) */
            line[13 * 8 + j] = 0.15625 * p_y + 0.84375 * q_y + l0 * (0.046875 * dp_y - 0.140625 * dq_y);
                /* line(6,1) */
            line[14 * 8 + j] = 0.04296875 * p_x + 0.95703125 * q_x + l0 * (0.013671875 * dp_x - 0.095703125 * dq_x);
                /* line(7,0) */
            line[15 * 8 + j] = 0.04296875 * p_y + 0.95703125 * q_y + l0 * (0.013671875 * dp_y - 0.095703125 * dq_y);
                /* line(7,1) */
        }
    }
}

const flexel_element flexel_planar_cable = {
    .name = "planar_cable",
    .digest = "d1e9c0d74293400c",
    .n = 8,
    .m = 6,
    .k = 0,
    .np = 4,
    .position = planar_cable_position,
    .acceleration = planar_cable_acceleration,
    .rates = planar_cable_rates,
    .kinematics = planar_cable_kinematics,
    .stiffness = planar_cable_stiffness,
    .inertia = planar_cable_inertia,
    .tangent = planar_cable_tangent,
    .outputs = planar_cable_outputs,
};
