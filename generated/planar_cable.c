/* planar_cable: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * r(s): cubic Hermite curve with slopes dp, dq = dr/ds by the undeformed arc length s at the ends
 * strain = (r'.r' - 1)/2 at 4 Gauss points of (0, l0); curvature = (r' x r'')/|r'|^3 at 3 Gauss points
 * work: EA strain and EI curvature, each times its Gauss weight (of sum l0), are the stresses of a rope
 * T = rhoA/2 int rdot.rdot ds (constant mass matrix),  U = -rhoA gravity.int r ds
 *
 * Source: Berzeri and Shabana 2000, J. Sound Vib. 235:539; Gerstmayr and Shabana 2006, Nonlinear Dyn. 45:109
 *
 * x (8): p_x, p_y, dp_x, dp_y, q_x, q_y, dq_x, dq_y
 * e (7): strain1 [1], strain2 [1], strain3 [1], strain4 [1], curvature1 [1/m], curvature2 [1/m], curvature3 [1/m]
 * s (0): none
 * p (4):
 *   l0 (1) [m]: undeformed length
 *   rhoA (1) [kg/m]: mass per length
 *   gravity (2) [m/s^2]: acceleration of gravity */
#include "kernels.h"

/* position: 302 operations.
 * in:  x (8), p (4)
 * out: e (7), De (7,8), V (0,8) */
FLEXEL_CLONES
static void planar_cable_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict p = in[1] + b * (4 * 8);
        real *restrict e = out[0] + b * (7 * 8);
        real *restrict De = out[1] + b * (56 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real dp_x = x[2 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = d_x * t0;
            const real dq_x = x[6 * 8 + j];
            const real s1_x = 0.7367349661563832 * dp_x + 0.38766637928128617 * t1 - 0.12440134543766938 * dq_x;
            const real dp_y = x[3 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t2 = d_y * t0;
            const real dq_y = x[7 * 8 + j];
            const real s1_y = 0.7367349661563832 * dp_y + 0.38766637928128617 * t2 - 0.12440134543766938 * dq_y;
            e[0 * 8 + j] = 0.5 * (s1_x * s1_x + s1_y * s1_y - 1.0);
            const real s2_x = 0.006680854290214084 * dp_x + 1.3266193350044282 * t1 - 0.33330018929464217 * dq_x;
            const real s2_y = 0.006680854290214084 * dp_y + 1.3266193350044282 * t2 - 0.33330018929464217 * dq_y;
            e[1 * 8 + j] = 0.5 * (s2_x * s2_x + s2_y * s2_y - 1.0);
            const real s3_x = 0.006680854290214084 * dq_x + 1.3266193350044282 * t1 - 0.33330018929464217 * dp_x;
            const real s3_y = 0.006680854290214084 * dq_y + 1.3266193350044282 * t2 - 0.33330018929464217 * dp_y;
            e[2 * 8 + j] = 0.5 * (s3_x * s3_x + s3_y * s3_y - 1.0);
            const real s4_x = 0.7367349661563832 * dq_x + 0.38766637928128617 * t1 - 0.12440134543766938 * dp_x;
            const real s4_y = 0.7367349661563832 * dq_y + 0.38766637928128617 * t2 - 0.12440134543766938 * dp_y;
            e[3 * 8 + j] = 0.5 * (s4_x * s4_x + s4_y * s4_y - 1.0);
            const real t3 = 0.6 * t1;
            const real t1_x = 0.5872983346207417 * dp_x + t3 - 0.1872983346207417 * dq_x;
            const real t4 = 0.6 * t2;
            const real t1_y = 0.5872983346207417 * dp_y + t4 - 0.1872983346207417 * dq_y;
            const real t5 = t1_x * t1_x + t1_y * t1_y;
            const real t6 = 1.0 / t5;
            const real t7 = 1.0 / real_sqrt(t5);
            const real t8 = t6 * t7;
            const real t9 = 4.6475800154489 * t2;
            const real b1_y = t0 * (t9 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y);
            const real t10 = 4.6475800154489 * t1;
            const real t11 = t10 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t11;
            const real t12 = t8 * (t1_x * b1_y - t1_y * b1_x);
            e[4 * 8 + j] = t12;
            const real t2_x = 1.5 * t1 - 0.25 * (dp_x + dq_x);
            const real t2_y = 1.5 * t2 - 0.25 * (dp_y + dq_y);
            const real t13 = t2_x * t2_x + t2_y * t2_y;
            const real t14 = 1.0 / t13;
            const real t15 = 1.0 / real_sqrt(t13);
            const real t16 = t14 * t15;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t17 = t16 * (t2_x * b2_y - t2_y * b2_x);
            e[5 * 8 + j] = t17;
            const real t3_x = t3 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real t3_y = t4 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t18 = t3_x * t3_x + t3_y * t3_y;
            const real t19 = 1.0 / t18;
            const real t20 = 1.0 / real_sqrt(t18);
            const real t21 = t19 * t20;
            const real b3_y = t0 * (1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t9);
            const real t22 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t10;
            const real b3_x = t0 * t22;
            const real t23 = t21 * (b3_y * t3_x - b3_x * t3_y);
            e[6 * 8 + j] = t23;
            const real t24 = 0.38766637928128617 * (t0 * s1_x);
            De[4 * 8 + j] = t24; /* De(0,4) */
            De[0 * 8 + j] = -t24; /* De(0,0) */
            const real t25 = 0.38766637928128617 * (t0 * s1_y);
            De[5 * 8 + j] = t25; /* De(0,5) */
            De[1 * 8 + j] = -t25; /* De(0,1) */
            De[2 * 8 + j] = 0.7367349661563832 * s1_x; /* De(0,2) */
            De[3 * 8 + j] = 0.7367349661563832 * s1_y; /* De(0,3) */
            De[6 * 8 + j] = -(0.12440134543766938 * s1_x); /* De(0,6) */
            De[7 * 8 + j] = -(0.12440134543766938 * s1_y); /* De(0,7) */
            const real t26 = 1.3266193350044282 * (t0 * s2_x);
            De[12 * 8 + j] = t26; /* De(1,4) */
            De[8 * 8 + j] = -t26; /* De(1,0) */
            const real t27 = 1.3266193350044282 * (t0 * s2_y);
            De[13 * 8 + j] = t27; /* De(1,5) */
            De[9 * 8 + j] = -t27; /* De(1,1) */
            De[10 * 8 + j] = 0.006680854290214084 * s2_x; /* De(1,2) */
            De[11 * 8 + j] = 0.006680854290214084 * s2_y; /* De(1,3) */
            De[14 * 8 + j] = -(0.33330018929464217 * s2_x); /* De(1,6) */
            De[15 * 8 + j] = -(0.33330018929464217 * s2_y); /* De(1,7) */
            const real t28 = 1.3266193350044282 * (t0 * s3_x);
            De[20 * 8 + j] = t28; /* De(2,4) */
            De[16 * 8 + j] = -t28; /* De(2,0) */
            const real t29 = 1.3266193350044282 * (t0 * s3_y);
            De[21 * 8 + j] = t29; /* De(2,5) */
            De[17 * 8 + j] = -t29; /* De(2,1) */
            De[18 * 8 + j] = -(0.33330018929464217 * s3_x); /* De(2,2) */
            De[19 * 8 + j] = -(0.33330018929464217 * s3_y); /* De(2,3) */
            De[22 * 8 + j] = 0.006680854290214084 * s3_x; /* De(2,6) */
            De[23 * 8 + j] = 0.006680854290214084 * s3_y; /* De(2,7) */
            const real t30 = 0.38766637928128617 * (t0 * s4_x);
            De[28 * 8 + j] = t30; /* De(3,4) */
            De[24 * 8 + j] = -t30; /* De(3,0) */
            const real t31 = 0.38766637928128617 * (t0 * s4_y);
            De[29 * 8 + j] = t31; /* De(3,5) */
            De[25 * 8 + j] = -t31; /* De(3,1) */
            De[26 * 8 + j] = -(0.12440134543766938 * s4_x); /* De(3,2) */
            De[27 * 8 + j] = -(0.12440134543766938 * s4_y); /* De(3,3) */
            De[30 * 8 + j] = 0.7367349661563832 * s4_x; /* De(3,6) */
            De[31 * 8 + j] = 0.7367349661563832 * s4_y; /* De(3,7) */
            const real t32 = t12 * (t6 + 0.5 * t7 * t7);
            const real t33 = b1_y * t8 - 2.0 * t1_x * t32;
            const real t34 = t0 * t8;
            const real t35 = t1_y * t34;
            const real t36 = t0 * (0.6 * t33 - 4.6475800154489 * t35);
            De[36 * 8 + j] = t36; /* De(4,4) */
            De[32 * 8 + j] = -t36; /* De(4,0) */
            const real t37 = t1_x * t34;
            const real t38 = b1_x * t8 + 2.0 * t1_y * t32;
            const real t39 = t0 * (4.6475800154489 * t37 - 0.6 * t38);
            De[37 * 8 + j] = t39; /* De(4,5) */
            De[33 * 8 + j] = -t39; /* De(4,1) */
            De[34 * 8 + j] = 3.32379000772445 * t35 + 0.5872983346207417 * t33; /* De(4,2) */
            De[35 * 8 + j] = -(3.32379000772445 * t37 + 0.5872983346207417 * t38); /* De(4,3) */
            De[38 * 8 + j] = 1.3237900077244502 * t35 - 0.1872983346207417 * t33; /* De(4,6) */
            De[39 * 8 + j] = 0.1872983346207417 * t38 - 1.3237900077244502 * t37; /* De(4,7) */
            const real t40 = t17 * (t14 + 0.5 * t15 * t15);
            const real t41 = b2_y * t16 - 2.0 * t2_x * t40;
            const real t42 = 1.5 * (t0 * t41);
            De[44 * 8 + j] = t42; /* De(5,4) */
            De[40 * 8 + j] = -t42; /* De(5,0) */
            const real t43 = b2_x * t16 + 2.0 * t2_y * t40;
            const real t44 = 1.5 * (t0 * t43);
            De[41 * 8 + j] = t44; /* De(5,1) */
            const real t45 = t0 * t16;
            const real t46 = t2_y * t45;
            const real t47 = 0.25 * t41;
            De[42 * 8 + j] = t46 - t47; /* De(5,2) */
            const real t48 = 0.25 * t43;
            const real t49 = t2_x * t45;
            De[43 * 8 + j] = t48 - t49; /* De(5,3) */
            De[45 * 8 + j] = -t44; /* De(5,5) */
            De[46 * 8 + j] = -(t46 + t47); /* De(5,6) */
            De[47 * 8 + j] = t49 + t48; /* De(5,7) */
            const real t50 = t0 * t21;
            const real t51 = t3_y * t50;
            const real t52 = t23 * (t19 + 0.5 * t20 * t20);
            const real t53 = b3_y * t21 - 2.0 * t3_x * t52;
            const real t54 = t0 * (4.6475800154489 * t51 + 0.6 * t53);
            De[52 * 8 + j] = t54; /* De(6,4) */
            De[48 * 8 + j] = -t54; /* De(6,0) */
            const real t55 = t3_x * t50;
            const real t56 = b3_x * t21 + 2.0 * t3_y * t52;
            const real t57 = t0 * (4.6475800154489 * t55 + 0.6 * t56);
            De[49 * 8 + j] = t57; /* De(6,1) */
            De[50 * 8 + j] = -(1.3237900077244502 * t51 + 0.1872983346207417 * t53); /* De(6,2) */
            De[51 * 8 + j] = 1.3237900077244502 * t55 + 0.1872983346207417 * t56; /* De(6,3) */
            De[53 * 8 + j] = -t57; /* De(6,5) */
            De[54 * 8 + j] = 0.5872983346207417 * t53 - 3.32379000772445 * t51; /* De(6,6) */
            De[55 * 8 + j] = 3.32379000772445 * t55 - 0.5872983346207417 * t56; /* De(6,7) */
        }
    }
}

/* acceleration: 354 operations.
 * in:  x (8), v (8), p (4)
 * out: g (7), gs (0) */
FLEXEL_CLONES
static void planar_cable_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict g = out[0] + b * (7 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real dp_vx = v[2 * 8 + j];
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t1 = t0 * (q_vx - p_vx);
            const real dq_vx = v[6 * 8 + j];
            const real t2 = 0.7367349661563832 * dp_vx + 0.38766637928128617 * t1 - 0.12440134543766938 * dq_vx;
            const real dp_vy = v[3 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t3 = t0 * (q_vy - p_vy);
            const real dq_vy = v[7 * 8 + j];
            const real t4 = 0.7367349661563832 * dp_vy + 0.38766637928128617 * t3 - 0.12440134543766938 * dq_vy;
            g[0 * 8 + j] = t2 * t2 + t4 * t4;
            const real t5 = 0.006680854290214084 * dp_vx + 1.3266193350044282 * t1 - 0.33330018929464217 * dq_vx;
            const real t6 = 0.006680854290214084 * dp_vy + 1.3266193350044282 * t3 - 0.33330018929464217 * dq_vy;
            g[1 * 8 + j] = t5 * t5 + t6 * t6;
            const real t7 = 0.006680854290214084 * dq_vx + 1.3266193350044282 * t1 - 0.33330018929464217 * dp_vx;
            const real t8 = 0.006680854290214084 * dq_vy + 1.3266193350044282 * t3 - 0.33330018929464217 * dp_vy;
            g[2 * 8 + j] = t7 * t7 + t8 * t8;
            const real t9 = 0.7367349661563832 * dq_vx + 0.38766637928128617 * t1 - 0.12440134543766938 * dp_vx;
            const real t10 = 0.7367349661563832 * dq_vy + 0.38766637928128617 * t3 - 0.12440134543766938 * dp_vy;
            g[3 * 8 + j] = t9 * t9 + t10 * t10;
            const real dp_x = x[2 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t11 = d_x * t0;
            const real t12 = 0.6 * t11;
            const real dq_x = x[6 * 8 + j];
            const real t1_x = 0.5872983346207417 * dp_x + t12 - 0.1872983346207417 * dq_x;
            const real dp_y = x[3 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t13 = d_y * t0;
            const real t14 = 0.6 * t13;
            const real dq_y = x[7 * 8 + j];
            const real t1_y = 0.5872983346207417 * dp_y + t14 - 0.1872983346207417 * dq_y;
            const real t15 = t1_x * t1_x + t1_y * t1_y;
            const real t16 = 1.0 / t15;
            const real t17 = 1.0 / real_sqrt(t15);
            const real t18 = 0.6 * t1;
            const real t19 = 0.5872983346207417 * dp_vx + t18 - 0.1872983346207417 * dq_vx;
            const real t20 = 4.6475800154489 * t3;
            const real t21 = t20 - 3.32379000772445 * dp_vy - 1.3237900077244502 * dq_vy;
            const real t22 = t0 * t21;
            const real t23 = 0.6 * t3;
            const real t24 = 0.5872983346207417 * dp_vy + t23 - 0.1872983346207417 * dq_vy;
            const real t25 = 4.6475800154489 * t1;
            const real t26 = t25 - 3.32379000772445 * dp_vx - 1.3237900077244502 * dq_vx;
            const real t27 = t0 * t26;
            const real t28 = t16 * t16;
            const real t29 = t1_x * t19 + t1_y * t24;
            const real t30 = t28 * t29;
            const real t31 = t17 * t17;
            const real t32 = t17 * t29;
            const real t33 = t31 * t32;
            const real t34 = 4.6475800154489 * t13;
            const real t35 = t34 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t35;
            const real t36 = 4.6475800154489 * t11;
            const real t37 = t36 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t37;
            const real t38 = (2.0 * t17 * t30 + t16 * t33) * (b1_y * t19 + t1_x * t22 - b1_x * t24 - t1_y * t27);
            const real t39 = t19 * t19 + t24 * t24;
            const real t40 = 2.0 * t31 * (t17 * t39 - t29 * t33) - 4.0 * t17 * t33 * t32;
            const real t41 = 0.5 * (t16 * t40 - 8.0 * t30 * t33) + t17 * (2.0 * t28 * t39 - 8.0 * t16 * t30 * t29);
            g[4 * 8 + j] = 2.0 * (t16 * t17 * (t19 * t22 - t24 * t27) - t38) - (t1_x * b1_y - t1_y * b1_x) * t41;
            const real t2_x = 1.5 * t11 - 0.25 * (dp_x + dq_x);
            const real t2_y = 1.5 * t13 - 0.25 * (dp_y + dq_y);
            const real t42 = t2_x * t2_x + t2_y * t2_y;
            const real t43 = 1.0 / t42;
            const real t44 = 1.0 / real_sqrt(t42);
            const real t45 = 1.5 * t1 - 0.25 * (dp_vx + dq_vx);
            const real t46 = t0 * (dq_vy - dp_vy);
            const real t47 = 1.5 * t3 - 0.25 * (dp_vy + dq_vy);
            const real t48 = t0 * (dq_vx - dp_vx);
            const real t49 = t43 * t43;
            const real t50 = t2_x * t45 + t2_y * t47;
            const real t51 = t49 * t50;
            const real t52 = t44 * t44;
            const real t53 = t44 * t50;
            const real t54 = t52 * t53;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t55 = (2.0 * t44 * t51 + t43 * t54) * (b2_y * t45 + t2_x * t46 - b2_x * t47 - t2_y * t48);
            const real t56 = t45 * t45 + t47 * t47;
            const real t57 = 2.0 * t52 * (t44 * t56 - t50 * t54) - 4.0 * t44 * t54 * t53;
            const real t58 = 0.5 * (t43 * t57 - 8.0 * t51 * t54) + t44 * (2.0 * t49 * t56 - 8.0 * t43 * t51 * t50);
            g[5 * 8 + j] = 2.0 * (t43 * t44 * (t45 * t46 - t47 * t48) - t55) - (t2_x * b2_y - t2_y * b2_x) * t58;
            const real t3_x = t12 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real t3_y = t14 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t59 = t3_x * t3_x + t3_y * t3_y;
            const real t60 = 1.0 / t59;
            const real t61 = 1.0 / real_sqrt(t59);
            const real t62 = 1.3237900077244502 * dp_vy + 3.32379000772445 * dq_vy - t20;
            const real t63 = t0 * t62;
            const real t64 = t18 + 0.5872983346207417 * dq_vx - 0.1872983346207417 * dp_vx;
            const real t65 = 1.3237900077244502 * dp_vx + 3.32379000772445 * dq_vx - t25;
            const real t66 = t0 * t65;
            const real t67 = t23 + 0.5872983346207417 * dq_vy - 0.1872983346207417 * dp_vy;
            const real t68 = t60 * t60;
            const real t69 = t3_x * t64 + t3_y * t67;
            const real t70 = t68 * t69;
            const real t71 = t61 * t61;
            const real t72 = t61 * t69;
            const real t73 = t71 * t72;
            const real t74 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t34;
            const real b3_y = t0 * t74;
            const real t75 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t36;
            const real b3_x = t0 * t75;
            const real t76 = (2.0 * t61 * t70 + t60 * t73) * (b3_y * t64 + t63 * t3_x - b3_x * t67 - t66 * t3_y);
            const real t77 = t64 * t64 + t67 * t67;
            const real t78 = 2.0 * t71 * (t61 * t77 - t69 * t73) - 4.0 * t61 * t73 * t72;
            const real t79 = 0.5 * (t60 * t78 - 8.0 * t70 * t73) + t61 * (2.0 * t68 * t77 - 8.0 * t60 * t70 * t69);
            g[6 * 8 + j] = 2.0 * (t60 * t61 * (t63 * t64 - t66 * t67) - t76) - (b3_y * t3_x - b3_x * t3_y) * t79;
        }
    }
}

/* rates: 504 operations.
 * in:  x (8), v (8), p (4)
 * out: Phi_x (7,8) */
FLEXEL_CLONES
static void planar_cable_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict p = in[2] + b * (4 * 8);
        real *restrict Phi_x = out[0] + b * (56 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real dp_vx = v[2 * 8 + j];
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t1 = t0 * (q_vx - p_vx);
            const real dq_vx = v[6 * 8 + j];
            const real t2 = 0.7367349661563832 * dp_vx + 0.38766637928128617 * t1 - 0.12440134543766938 * dq_vx;
            const real t3 = 0.38766637928128617 * (t0 * t2);
            Phi_x[4 * 8 + j] = t3; /* Phi_x(0,4) */
            Phi_x[0 * 8 + j] = -t3; /* Phi_x(0,0) */
            const real dp_vy = v[3 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t4 = t0 * (q_vy - p_vy);
            const real dq_vy = v[7 * 8 + j];
            const real t5 = 0.7367349661563832 * dp_vy + 0.38766637928128617 * t4 - 0.12440134543766938 * dq_vy;
            const real t6 = 0.38766637928128617 * (t0 * t5);
            Phi_x[5 * 8 + j] = t6; /* Phi_x(0,5) */
            Phi_x[1 * 8 + j] = -t6; /* Phi_x(0,1) */
            Phi_x[2 * 8 + j] = 0.7367349661563832 * t2; /* Phi_x(0,2) */
            Phi_x[3 * 8 + j] = 0.7367349661563832 * t5; /* Phi_x(0,3) */
            Phi_x[6 * 8 + j] = -(0.12440134543766938 * t2); /* Phi_x(0,6) */
            Phi_x[7 * 8 + j] = -(0.12440134543766938 * t5); /* Phi_x(0,7) */
            const real t7 = 0.006680854290214084 * dp_vx + 1.3266193350044282 * t1 - 0.33330018929464217 * dq_vx;
            const real t8 = 1.3266193350044282 * (t0 * t7);
            Phi_x[12 * 8 + j] = t8; /* Phi_x(1,4) */
            Phi_x[8 * 8 + j] = -t8; /* Phi_x(1,0) */
            const real t9 = 0.006680854290214084 * dp_vy + 1.3266193350044282 * t4 - 0.33330018929464217 * dq_vy;
            const real t10 = 1.3266193350044282 * (t0 * t9);
            Phi_x[13 * 8 + j] = t10; /* Phi_x(1,5) */
            Phi_x[9 * 8 + j] = -t10; /* Phi_x(1,1) */
            Phi_x[10 * 8 + j] = 0.006680854290214084 * t7; /* Phi_x(1,2) */
            Phi_x[11 * 8 + j] = 0.006680854290214084 * t9; /* Phi_x(1,3) */
            Phi_x[14 * 8 + j] = -(0.33330018929464217 * t7); /* Phi_x(1,6) */
            Phi_x[15 * 8 + j] = -(0.33330018929464217 * t9); /* Phi_x(1,7) */
            const real t11 = 0.006680854290214084 * dq_vx + 1.3266193350044282 * t1 - 0.33330018929464217 * dp_vx;
            const real t12 = 1.3266193350044282 * (t0 * t11);
            Phi_x[20 * 8 + j] = t12; /* Phi_x(2,4) */
            Phi_x[16 * 8 + j] = -t12; /* Phi_x(2,0) */
            const real t13 = 0.006680854290214084 * dq_vy + 1.3266193350044282 * t4 - 0.33330018929464217 * dp_vy;
            const real t14 = 1.3266193350044282 * (t0 * t13);
            Phi_x[21 * 8 + j] = t14; /* Phi_x(2,5) */
            Phi_x[17 * 8 + j] = -t14; /* Phi_x(2,1) */
            Phi_x[18 * 8 + j] = -(0.33330018929464217 * t11); /* Phi_x(2,2) */
            Phi_x[19 * 8 + j] = -(0.33330018929464217 * t13); /* Phi_x(2,3) */
            Phi_x[22 * 8 + j] = 0.006680854290214084 * t11; /* Phi_x(2,6) */
            Phi_x[23 * 8 + j] = 0.006680854290214084 * t13; /* Phi_x(2,7) */
            const real t15 = 0.7367349661563832 * dq_vx + 0.38766637928128617 * t1 - 0.12440134543766938 * dp_vx;
            const real t16 = 0.38766637928128617 * (t0 * t15);
            Phi_x[28 * 8 + j] = t16; /* Phi_x(3,4) */
            Phi_x[24 * 8 + j] = -t16; /* Phi_x(3,0) */
            const real t17 = 0.7367349661563832 * dq_vy + 0.38766637928128617 * t4 - 0.12440134543766938 * dp_vy;
            const real t18 = 0.38766637928128617 * (t0 * t17);
            Phi_x[29 * 8 + j] = t18; /* Phi_x(3,5) */
            Phi_x[25 * 8 + j] = -t18; /* Phi_x(3,1) */
            Phi_x[26 * 8 + j] = -(0.12440134543766938 * t15); /* Phi_x(3,2) */
            Phi_x[27 * 8 + j] = -(0.12440134543766938 * t17); /* Phi_x(3,3) */
            Phi_x[30 * 8 + j] = 0.7367349661563832 * t15; /* Phi_x(3,6) */
            Phi_x[31 * 8 + j] = 0.7367349661563832 * t17; /* Phi_x(3,7) */
            const real dp_y = x[3 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t19 = d_y * t0;
            const real t20 = 0.6 * t19;
            const real dq_y = x[7 * 8 + j];
            const real t1_y = 0.5872983346207417 * dp_y + t20 - 0.1872983346207417 * dq_y;
            const real dp_x = x[2 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t21 = d_x * t0;
            const real t22 = 0.6 * t21;
            const real dq_x = x[6 * 8 + j];
            const real t1_x = 0.5872983346207417 * dp_x + t22 - 0.1872983346207417 * dq_x;
            const real t23 = t1_x * t1_x + t1_y * t1_y;
            const real t24 = 1.0 / real_sqrt(t23);
            const real t25 = 1.0 / t23;
            const real t26 = t25 * t25;
            const real t27 = 0.6 * t1;
            const real t28 = 0.5872983346207417 * dp_vx + t27 - 0.1872983346207417 * dq_vx;
            const real t29 = 0.6 * t4;
            const real t30 = 0.5872983346207417 * dp_vy + t29 - 0.1872983346207417 * dq_vy;
            const real t31 = t1_x * t28 + t1_y * t30;
            const real t32 = t26 * t31;
            const real t33 = t24 * t24;
            const real t34 = t24 * t31;
            const real t35 = t33 * t34;
            const real t36 = 2.0 * t24 * t32 + t25 * t35;
            const real t37 = t25 * t24;
            const real t38 = t0 * (t1_y * t36 - t37 * t30);
            const real t39 = 4.6475800154489 * t4;
            const real t40 = t39 - 3.32379000772445 * dp_vy - 1.3237900077244502 * dq_vy;
            const real t41 = t0 * t40;
            const real t42 = 4.6475800154489 * t19;
            const real t43 = t42 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t43;
            const real t44 = 4.6475800154489 * t21;
            const real t45 = t44 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t45;
            const real t46 = t1_x * b1_y - t1_y * b1_x;
            const real t47 = t24 * t46;
            const real t48 = t25 * t46;
            const real t49 = t33 * t48;
            const real t50 = t26 * t47 + 0.5 * t24 * t49;
            const real t51 = 4.6475800154489 * t1;
            const real t52 = t51 - 3.32379000772445 * dp_vx - 1.3237900077244502 * dq_vx;
            const real t53 = t0 * t52;
            const real t54 = b1_y * t28 + t1_x * t41 - b1_x * t30 - t1_y * t53;
            const real t55 = t25 * t54 - 2.0 * (t46 * t32 + t24 * t34 * t48) - t31 * t49;
            const real t56 = t26 * (t24 * t54 - 4.0 * t25 * t31 * t47 - t46 * t35) + 0.5 * t24 * t55 * t33;
            const real t57 = t37 * t41 - 2.0 * (t28 * t50 + t1_x * t56) - b1_y * t36;
            const real t58 = t0 * (4.6475800154489 * t38 + 0.6 * t57);
            Phi_x[36 * 8 + j] = t58; /* Phi_x(4,4) */
            Phi_x[32 * 8 + j] = -t58; /* Phi_x(4,0) */
            const real t59 = t0 * (t37 * t28 - t1_x * t36);
            const real t60 = b1_x * t36 - 2.0 * (t30 * t50 + t1_y * t56) - t37 * t53;
            const real t61 = t0 * (4.6475800154489 * t59 + 0.6 * t60);
            Phi_x[37 * 8 + j] = t61; /* Phi_x(4,5) */
            Phi_x[33 * 8 + j] = -t61; /* Phi_x(4,1) */
            Phi_x[34 * 8 + j] = 0.5872983346207417 * t57 - 3.32379000772445 * t38; /* Phi_x(4,2) */
            Phi_x[35 * 8 + j] = 0.5872983346207417 * t60 - 3.32379000772445 * t59; /* Phi_x(4,3) */
            Phi_x[38 * 8 + j] = -(1.3237900077244502 * t38 + 0.1872983346207417 * t57); /* Phi_x(4,6) */
            Phi_x[39 * 8 + j] = -(1.3237900077244502 * t59 + 0.1872983346207417 * t60); /* Phi_x(4,7) */
            const real t2_x = 1.5 * t21 - 0.25 * (dp_x + dq_x);
            const real t2_y = 1.5 * t19 - 0.25 * (dp_y + dq_y);
            const real t62 = t2_x * t2_x + t2_y * t2_y;
            const real t63 = 1.0 / t62;
            const real t64 = 1.0 / real_sqrt(t62);
            const real t65 = t63 * t64;
            const real t66 = t0 * (dq_vy - dp_vy);
            const real t67 = t63 * t63;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t68 = t2_x * b2_y - t2_y * b2_x;
            const real t69 = t64 * t68;
            const real t70 = t64 * t64;
            const real t71 = t63 * t68;
            const real t72 = t70 * t71;
            const real t73 = t67 * t69 + 0.5 * t64 * t72;
            const real t74 = 1.5 * t1 - 0.25 * (dp_vx + dq_vx);
            const real t75 = 1.5 * t4 - 0.25 * (dp_vy + dq_vy);
            const real t76 = t0 * (dq_vx - dp_vx);
            const real t77 = b2_y * t74 + t2_x * t66 - b2_x * t75 - t2_y * t76;
            const real t78 = t2_x * t74 + t2_y * t75;
            const real t79 = t64 * t78;
            const real t80 = t70 * t79;
            const real t81 = t67 * t78;
            const real t82 = t63 * t77 - 2.0 * (t68 * t81 + t64 * t79 * t71) - t72 * t78;
            const real t83 = t67 * (t64 * t77 - 4.0 * t63 * t78 * t69 - t68 * t80) + 0.5 * t64 * t70 * t82;
            const real t84 = 2.0 * t64 * t81 + t63 * t80;
            const real t85 = t65 * t66 - 2.0 * (t73 * t74 + t2_x * t83) - b2_y * t84;
            const real t86 = 1.5 * (t0 * t85);
            Phi_x[44 * 8 + j] = t86; /* Phi_x(5,4) */
            Phi_x[40 * 8 + j] = -t86; /* Phi_x(5,0) */
            const real t87 = b2_x * t84 - 2.0 * (t73 * t75 + t2_y * t83) - t65 * t76;
            const real t88 = 1.5 * (t0 * t87);
            Phi_x[45 * 8 + j] = t88; /* Phi_x(5,5) */
            Phi_x[41 * 8 + j] = -t88; /* Phi_x(5,1) */
            const real t89 = t0 * (t2_y * t84 - t65 * t75);
            const real t90 = 0.25 * t85;
            Phi_x[42 * 8 + j] = -(t89 + t90); /* Phi_x(5,2) */
            const real t91 = t0 * (t65 * t74 - t2_x * t84);
            const real t92 = 0.25 * t87;
            Phi_x[43 * 8 + j] = -(t91 + t92); /* Phi_x(5,3) */
            Phi_x[46 * 8 + j] = t89 - t90; /* Phi_x(5,6) */
            Phi_x[47 * 8 + j] = t91 - t92; /* Phi_x(5,7) */
            const real t93 = 1.3237900077244502 * dp_vy + 3.32379000772445 * dq_vy - t39;
            const real t94 = t0 * t93;
            const real t3_x = t22 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real t3_y = t20 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t95 = t3_x * t3_x + t3_y * t3_y;
            const real t96 = 1.0 / t95;
            const real t97 = 1.0 / real_sqrt(t95);
            const real t98 = t96 * t97;
            const real t99 = t27 + 0.5872983346207417 * dq_vx - 0.1872983346207417 * dp_vx;
            const real t100 = t96 * t96;
            const real t101 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t42;
            const real b3_y = t0 * t101;
            const real t102 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t44;
            const real b3_x = t0 * t102;
            const real t103 = b3_y * t3_x - b3_x * t3_y;
            const real t104 = t97 * t103;
            const real t105 = t97 * t97;
            const real t106 = t96 * t103;
            const real t107 = t105 * t106;
            const real t108 = t100 * t104 + 0.5 * t97 * t107;
            const real t109 = t29 + 0.5872983346207417 * dq_vy - 0.1872983346207417 * dp_vy;
            const real t110 = 1.3237900077244502 * dp_vx + 3.32379000772445 * dq_vx - t51;
            const real t111 = t0 * t110;
            const real t112 = b3_y * t99 + t94 * t3_x - b3_x * t109 - t111 * t3_y;
            const real t113 = t3_x * t99 + t3_y * t109;
            const real t114 = t97 * t113;
            const real t115 = t105 * t114;
            const real t116 = t100 * (t97 * t112 - 4.0 * t96 * t113 * t104 - t103 * t115);
            const real t117 = t100 * t113;
            const real t118 = t96 * t112 - 2.0 * (t103 * t117 + t97 * t114 * t106) - t113 * t107;
            const real t119 = t116 + 0.5 * t97 * t118 * t105;
            const real t120 = 2.0 * t97 * t117 + t96 * t115;
            const real t121 = t94 * t98 - 2.0 * (t99 * t108 + t3_x * t119) - b3_y * t120;
            const real t122 = t0 * (t3_y * t120 - t98 * t109);
            const real t123 = t0 * (0.6 * t121 - 4.6475800154489 * t122);
            Phi_x[52 * 8 + j] = t123; /* Phi_x(6,4) */
            Phi_x[48 * 8 + j] = -t123; /* Phi_x(6,0) */
            const real t124 = b3_x * t120 - 2.0 * (t109 * t108 + t3_y * t119) - t111 * t98;
            const real t125 = t0 * (t98 * t99 - t3_x * t120);
            const real t126 = t0 * (0.6 * t124 - 4.6475800154489 * t125);
            Phi_x[53 * 8 + j] = t126; /* Phi_x(6,5) */
            Phi_x[49 * 8 + j] = -t126; /* Phi_x(6,1) */
            Phi_x[50 * 8 + j] = 1.3237900077244502 * t122 - 0.1872983346207417 * t121; /* Phi_x(6,2) */
            Phi_x[51 * 8 + j] = 1.3237900077244502 * t125 - 0.1872983346207417 * t124; /* Phi_x(6,3) */
            Phi_x[54 * 8 + j] = 3.32379000772445 * t122 + 0.5872983346207417 * t121; /* Phi_x(6,6) */
            Phi_x[55 * 8 + j] = 3.32379000772445 * t125 + 0.5872983346207417 * t124; /* Phi_x(6,7) */
        }
    }
}

/* kinematics: 1159 operations.
 * in:  x (8), v (8), a (8), p (4)
 * out: Psi_x (7,8), Psi_v (7,8) */
FLEXEL_CLONES
static void planar_cable_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict v = in[1] + b * (8 * 8);
        const real *restrict a = in[2] + b * (8 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict Psi_x = out[0] + b * (56 * 8);
        real *restrict Psi_v = out[1] + b * (56 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real dp_ax = a[2 * 8 + j];
            const real q_ax = a[4 * 8 + j];
            const real p_ax = a[0 * 8 + j];
            const real t1 = t0 * (q_ax - p_ax);
            const real dq_ax = a[6 * 8 + j];
            const real t2 = 0.7367349661563832 * dp_ax + 0.38766637928128617 * t1 - 0.12440134543766938 * dq_ax;
            const real t3 = 0.38766637928128617 * (t0 * t2);
            Psi_x[4 * 8 + j] = t3; /* Psi_x(0,4) */
            Psi_x[0 * 8 + j] = -t3; /* Psi_x(0,0) */
            const real dp_ay = a[3 * 8 + j];
            const real q_ay = a[5 * 8 + j];
            const real p_ay = a[1 * 8 + j];
            const real t4 = t0 * (q_ay - p_ay);
            const real dq_ay = a[7 * 8 + j];
            const real t5 = 0.7367349661563832 * dp_ay + 0.38766637928128617 * t4 - 0.12440134543766938 * dq_ay;
            const real t6 = 0.38766637928128617 * (t0 * t5);
            Psi_x[5 * 8 + j] = t6; /* Psi_x(0,5) */
            Psi_x[1 * 8 + j] = -t6; /* Psi_x(0,1) */
            Psi_x[2 * 8 + j] = 0.7367349661563832 * t2; /* Psi_x(0,2) */
            Psi_x[3 * 8 + j] = 0.7367349661563832 * t5; /* Psi_x(0,3) */
            Psi_x[6 * 8 + j] = -(0.12440134543766938 * t2); /* Psi_x(0,6) */
            Psi_x[7 * 8 + j] = -(0.12440134543766938 * t5); /* Psi_x(0,7) */
            const real t7 = 0.006680854290214084 * dp_ax + 1.3266193350044282 * t1 - 0.33330018929464217 * dq_ax;
            const real t8 = 1.3266193350044282 * (t0 * t7);
            Psi_x[12 * 8 + j] = t8; /* Psi_x(1,4) */
            Psi_x[8 * 8 + j] = -t8; /* Psi_x(1,0) */
            const real t9 = 0.006680854290214084 * dp_ay + 1.3266193350044282 * t4 - 0.33330018929464217 * dq_ay;
            const real t10 = 1.3266193350044282 * (t0 * t9);
            Psi_x[13 * 8 + j] = t10; /* Psi_x(1,5) */
            Psi_x[9 * 8 + j] = -t10; /* Psi_x(1,1) */
            Psi_x[10 * 8 + j] = 0.006680854290214084 * t7; /* Psi_x(1,2) */
            Psi_x[11 * 8 + j] = 0.006680854290214084 * t9; /* Psi_x(1,3) */
            Psi_x[14 * 8 + j] = -(0.33330018929464217 * t7); /* Psi_x(1,6) */
            Psi_x[15 * 8 + j] = -(0.33330018929464217 * t9); /* Psi_x(1,7) */
            const real t11 = 0.006680854290214084 * dq_ax + 1.3266193350044282 * t1 - 0.33330018929464217 * dp_ax;
            const real t12 = 1.3266193350044282 * (t0 * t11);
            Psi_x[20 * 8 + j] = t12; /* Psi_x(2,4) */
            Psi_x[16 * 8 + j] = -t12; /* Psi_x(2,0) */
            const real t13 = 0.006680854290214084 * dq_ay + 1.3266193350044282 * t4 - 0.33330018929464217 * dp_ay;
            const real t14 = 1.3266193350044282 * (t0 * t13);
            Psi_x[21 * 8 + j] = t14; /* Psi_x(2,5) */
            Psi_x[17 * 8 + j] = -t14; /* Psi_x(2,1) */
            Psi_x[18 * 8 + j] = -(0.33330018929464217 * t11); /* Psi_x(2,2) */
            Psi_x[19 * 8 + j] = -(0.33330018929464217 * t13); /* Psi_x(2,3) */
            Psi_x[22 * 8 + j] = 0.006680854290214084 * t11; /* Psi_x(2,6) */
            Psi_x[23 * 8 + j] = 0.006680854290214084 * t13; /* Psi_x(2,7) */
            const real t15 = 0.7367349661563832 * dq_ax + 0.38766637928128617 * t1 - 0.12440134543766938 * dp_ax;
            const real t16 = 0.38766637928128617 * (t0 * t15);
            Psi_x[28 * 8 + j] = t16; /* Psi_x(3,4) */
            Psi_x[24 * 8 + j] = -t16; /* Psi_x(3,0) */
            const real t17 = 0.7367349661563832 * dq_ay + 0.38766637928128617 * t4 - 0.12440134543766938 * dp_ay;
            const real t18 = 0.38766637928128617 * (t0 * t17);
            Psi_x[29 * 8 + j] = t18; /* Psi_x(3,5) */
            Psi_x[25 * 8 + j] = -t18; /* Psi_x(3,1) */
            Psi_x[26 * 8 + j] = -(0.12440134543766938 * t15); /* Psi_x(3,2) */
            Psi_x[27 * 8 + j] = -(0.12440134543766938 * t17); /* Psi_x(3,3) */
            Psi_x[30 * 8 + j] = 0.7367349661563832 * t15; /* Psi_x(3,6) */
            Psi_x[31 * 8 + j] = 0.7367349661563832 * t17; /* Psi_x(3,7) */
            const real dp_vy = v[3 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real p_vy = v[1 * 8 + j];
            const real t19 = t0 * (q_vy - p_vy);
            const real t20 = 0.6 * t19;
            const real dq_vy = v[7 * 8 + j];
            const real t21 = 0.5872983346207417 * dp_vy + t20 - 0.1872983346207417 * dq_vy;
            const real dp_x = x[2 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t22 = d_x * t0;
            const real t23 = 0.6 * t22;
            const real dq_x = x[6 * 8 + j];
            const real t1_x = 0.5872983346207417 * dp_x + t23 - 0.1872983346207417 * dq_x;
            const real dp_y = x[3 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t24 = d_y * t0;
            const real t25 = 0.6 * t24;
            const real dq_y = x[7 * 8 + j];
            const real t1_y = 0.5872983346207417 * dp_y + t25 - 0.1872983346207417 * dq_y;
            const real t26 = t1_x * t1_x + t1_y * t1_y;
            const real t27 = 1.0 / real_sqrt(t26);
            const real t28 = 1.0 / t26;
            const real t29 = t28 * t28;
            const real dp_vx = v[2 * 8 + j];
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t30 = t0 * (q_vx - p_vx);
            const real t31 = 0.6 * t30;
            const real dq_vx = v[6 * 8 + j];
            const real t32 = 0.5872983346207417 * dp_vx + t31 - 0.1872983346207417 * dq_vx;
            const real t33 = t1_x * t32 + t1_y * t21;
            const real t34 = t29 * t33;
            const real t35 = t27 * t27;
            const real t36 = t27 * t33;
            const real t37 = t35 * t36;
            const real t38 = 2.0 * t27 * t34 + t28 * t37;
            const real t39 = t32 * t32 + t21 * t21;
            const real t40 = 0.6 * t1;
            const real t41 = 0.5872983346207417 * dp_ax + t40 - 0.1872983346207417 * dq_ax;
            const real t42 = 0.6 * t4;
            const real t43 = 0.5872983346207417 * dp_ay + t42 - 0.1872983346207417 * dq_ay;
            const real t44 = t1_x * t41 + t1_y * t43;
            const real t45 = t39 + t44;
            const real t46 = t28 * t34;
            const real t47 = 2.0 * t29 * t45 - 8.0 * t33 * t46;
            const real t48 = t27 * t39 - t33 * t37 + t27 * t44;
            const real t49 = t27 * t37;
            const real t50 = 2.0 * t35 * t48 - 4.0 * t36 * t49;
            const real t51 = t27 * t47 + 0.5 * (t28 * t50 - 8.0 * t34 * t37);
            const real t52 = t28 * t27;
            const real t53 = t0 * (2.0 * t21 * t38 + t1_y * t51 - t52 * t43);
            const real t54 = 4.6475800154489 * t4;
            const real t55 = t54 - 3.32379000772445 * dp_ay - 1.3237900077244502 * dq_ay;
            const real t56 = t0 * t55;
            const real t57 = 4.6475800154489 * t24;
            const real t58 = t57 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t58;
            const real t59 = 4.6475800154489 * t22;
            const real t60 = t59 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t60;
            const real t61 = t1_x * b1_y - t1_y * b1_x;
            const real t62 = t61 * t37;
            const real t63 = t27 * t61;
            const real t64 = t33 * t63;
            const real t65 = t28 * t64;
            const real t66 = 4.6475800154489 * t19;
            const real t67 = t66 - 3.32379000772445 * dp_vy - 1.3237900077244502 * dq_vy;
            const real t68 = t0 * t67;
            const real t69 = 4.6475800154489 * t30;
            const real t70 = t69 - 3.32379000772445 * dp_vx - 1.3237900077244502 * dq_vx;
            const real t71 = t0 * t70;
            const real t72 = b1_y * t32 + t1_x * t68 - b1_x * t21 - t1_y * t71;
            const real t73 = t27 * t72;
            const real t74 = t62 + 2.0 * t65 - t73;
            const real t75 = t28 * t61;
            const real t76 = t35 * t75;
            const real t77 = t33 * t76;
            const real t78 = 2.0 * t61 * t34;
            const real t79 = t36 * t75;
            const real t80 = t27 * t79;
            const real t81 = t28 * t72;
            const real t82 = t78 + t80 + 0.5 * t77 - t81;
            const real t83 = t49 * t75 + t35 * t82;
            const real t84 = 4.0 * t46 * t63 + 0.5 * t37 * t76 + t27 * t83 + 2.0 * t29 * t74;
            const real t85 = t29 * t63 + 0.5 * t27 * t76;
            const real t86 = 2.0 * (t32 * t68 - t21 * t71) + b1_y * t41 + t1_x * t56 - b1_x * t43;
            const real t87 = 4.6475800154489 * t1;
            const real t88 = t87 - 3.32379000772445 * dp_ax - 1.3237900077244502 * dq_ax;
            const real t89 = t0 * t88;
            const real t90 = t86 - t1_y * t89;
            const real t91 = 2.0 * (t28 * (4.0 * t33 * t74 - 2.0 * t63 * t45) - t37 * t72);
            const real t92 = t29 * (8.0 * t34 * t64 + t91 + t27 * t90 - 0.5 * t61 * t50);
            const real t93 = t27 * t35;
            const real t94 = 0.5 * (4.0 * t37 * t79 - 2.0 * t76 * t45) + 2.0 * (t33 * t83 + t27 * (2.0 * t36 * t82
                - t75 * t48));
            const real t95 = 0.5 * t93 * (t28 * t90 + t94 - t61 * t47 - 4.0 * t34 * t72);
            const real t96 = t92 + t95;
            const real t97 = t52 * t56 + 2.0 * (t32 * t84 - t85 * t41 - t68 * t38 - t1_x * t96);
            const real t98 = t97 - b1_y * t51;
            const real t99 = t0 * (4.6475800154489 * t53 + 0.6 * t98);
            Psi_x[36 * 8 + j] = t99; /* Psi_x(4,4) */
            Psi_x[32 * 8 + j] = -t99; /* Psi_x(4,0) */
            const real t100 = t0 * (t52 * t41 - 2.0 * t32 * t38 - t1_x * t51);
            const real t101 = 2.0 * (t71 * t38 + t21 * t84 - t85 * t43 - t1_y * t96) + b1_x * t51;
            const real t102 = t101 - t52 * t89;
            const real t103 = t0 * (4.6475800154489 * t100 + 0.6 * t102);
            Psi_x[37 * 8 + j] = t103; /* Psi_x(4,5) */
            Psi_x[33 * 8 + j] = -t103; /* Psi_x(4,1) */
            Psi_x[34 * 8 + j] = 0.5872983346207417 * t98 - 3.32379000772445 * t53; /* Psi_x(4,2) */
            Psi_x[35 * 8 + j] = 0.5872983346207417 * t102 - 3.32379000772445 * t100; /* Psi_x(4,3) */
            Psi_x[38 * 8 + j] = -(1.3237900077244502 * t53 + 0.1872983346207417 * t98); /* Psi_x(4,6) */
            Psi_x[39 * 8 + j] = -(1.3237900077244502 * t100 + 0.1872983346207417 * t102); /* Psi_x(4,7) */
            const real t2_x = 1.5 * t22 - 0.25 * (dp_x + dq_x);
            const real t2_y = 1.5 * t24 - 0.25 * (dp_y + dq_y);
            const real t104 = t2_x * t2_x + t2_y * t2_y;
            const real t105 = 1.0 / t104;
            const real t106 = 1.0 / real_sqrt(t104);
            const real t107 = t105 * t106;
            const real t108 = t0 * (dq_ay - dp_ay);
            const real t109 = 1.5 * t30 - 0.25 * (dp_vx + dq_vx);
            const real t110 = t105 * t105;
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real t111 = t2_x * b2_y - t2_y * b2_x;
            const real t112 = t106 * t106;
            const real t113 = 1.5 * t19 - 0.25 * (dp_vy + dq_vy);
            const real t114 = t2_x * t109 + t2_y * t113;
            const real t115 = t106 * t114;
            const real t116 = t112 * t115;
            const real t117 = t111 * t116;
            const real t118 = t106 * t111;
            const real t119 = t118 * t114;
            const real t120 = t105 * t119;
            const real t121 = t0 * (dq_vy - dp_vy);
            const real t122 = t0 * (dq_vx - dp_vx);
            const real t123 = b2_y * t109 + t2_x * t121 - b2_x * t113 - t2_y * t122;
            const real t124 = t106 * t123;
            const real t125 = t117 + 2.0 * t120 - t124;
            const real t126 = t105 * t111;
            const real t127 = t106 * t116;
            const real t128 = t112 * t126;
            const real t129 = t128 * t114;
            const real t130 = t110 * t114;
            const real t131 = 2.0 * t111 * t130;
            const real t132 = t126 * t115;
            const real t133 = t106 * t132;
            const real t134 = t105 * t123;
            const real t135 = t131 + t133 + 0.5 * t129 - t134;
            const real t136 = t126 * t127 + t112 * t135;
            const real t137 = t105 * t130;
            const real t138 = 4.0 * t118 * t137 + 0.5 * t128 * t116 + t106 * t136 + 2.0 * t110 * t125;
            const real t139 = t110 * t118 + 0.5 * t106 * t128;
            const real t140 = 1.5 * t1 - 0.25 * (dp_ax + dq_ax);
            const real t141 = 2.0 * t106 * t130 + t105 * t116;
            const real t142 = 2.0 * (t109 * t121 - t113 * t122) + b2_y * t140 + t2_x * t108;
            const real t143 = 1.5 * t4 - 0.25 * (dp_ay + dq_ay);
            const real t144 = t0 * (dq_ax - dp_ax);
            const real t145 = t142 - b2_x * t143 - t2_y * t144;
            const real t146 = t109 * t109 + t113 * t113;
            const real t147 = t2_x * t140 + t2_y * t143;
            const real t148 = t146 + t147;
            const real t149 = t105 * (4.0 * t114 * t125 - 2.0 * t118 * t148) - t116 * t123;
            const real t150 = t106 * t146 - t114 * t116 + t106 * t147;
            const real t151 = 2.0 * t112 * t150 - 4.0 * t115 * t127;
            const real t152 = 8.0 * t130 * t119 + 2.0 * t149 + t106 * t145 - 0.5 * t111 * t151;
            const real t153 = t106 * t112;
            const real t154 = 2.0 * (t114 * t136 + t106 * (2.0 * t115 * t135 - t126 * t150));
            const real t155 = 0.5 * (4.0 * t116 * t132 - 2.0 * t128 * t148) + t154 + t105 * t145;
            const real t156 = 2.0 * t110 * t148 - 8.0 * t114 * t137;
            const real t157 = t110 * t152 + 0.5 * t153 * (t155 - t111 * t156 - 4.0 * t130 * t123);
            const real t158 = 2.0 * (t109 * t138 - t139 * t140 - t121 * t141 - t2_x * t157);
            const real t159 = t106 * t156 + 0.5 * (t105 * t151 - 8.0 * t130 * t116);
            const real t160 = t107 * t108 + t158 - b2_y * t159;
            const real t161 = 1.5 * (t0 * t160);
            Psi_x[44 * 8 + j] = t161; /* Psi_x(5,4) */
            Psi_x[40 * 8 + j] = -t161; /* Psi_x(5,0) */
            const real t162 = 2.0 * (t122 * t141 + t113 * t138 - t139 * t143 - t2_y * t157);
            const real t163 = t162 + b2_x * t159 - t107 * t144;
            const real t164 = 1.5 * (t0 * t163);
            Psi_x[45 * 8 + j] = t164; /* Psi_x(5,5) */
            Psi_x[41 * 8 + j] = -t164; /* Psi_x(5,1) */
            const real t165 = t0 * (2.0 * t113 * t141 + t2_y * t159 - t107 * t143);
            const real t166 = 0.25 * t160;
            Psi_x[42 * 8 + j] = -(t165 + t166); /* Psi_x(5,2) */
            const real t167 = t0 * (t107 * t140 - 2.0 * t109 * t141 - t2_x * t159);
            const real t168 = 0.25 * t163;
            Psi_x[43 * 8 + j] = -(t167 + t168); /* Psi_x(5,3) */
            Psi_x[46 * 8 + j] = t165 - t166; /* Psi_x(5,6) */
            Psi_x[47 * 8 + j] = t167 - t168; /* Psi_x(5,7) */
            const real t3_x = t23 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real t3_y = t25 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t169 = t3_x * t3_x + t3_y * t3_y;
            const real t170 = 1.0 / t169;
            const real t171 = 1.0 / real_sqrt(t169);
            const real t172 = t170 * t171;
            const real t173 = 1.3237900077244502 * dp_ay + 3.32379000772445 * dq_ay - t54;
            const real t174 = t0 * t173;
            const real t175 = t31 + 0.5872983346207417 * dq_vx - 0.1872983346207417 * dp_vx;
            const real t176 = t170 * t170;
            const real t177 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t57;
            const real b3_y = t0 * t177;
            const real t178 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t59;
            const real b3_x = t0 * t178;
            const real t179 = b3_y * t3_x - b3_x * t3_y;
            const real t180 = t171 * t171;
            const real t181 = t20 + 0.5872983346207417 * dq_vy - 0.1872983346207417 * dp_vy;
            const real t182 = t3_x * t175 + t3_y * t181;
            const real t183 = t171 * t182;
            const real t184 = t180 * t183;
            const real t185 = t179 * t184;
            const real t186 = t171 * t179;
            const real t187 = t182 * t186;
            const real t188 = t170 * t187;
            const real t189 = 1.3237900077244502 * dp_vy + 3.32379000772445 * dq_vy - t66;
            const real t190 = t0 * t189;
            const real t191 = 1.3237900077244502 * dp_vx + 3.32379000772445 * dq_vx - t69;
            const real t192 = t0 * t191;
            const real t193 = b3_y * t175 + t190 * t3_x - b3_x * t181 - t192 * t3_y;
            const real t194 = t171 * t193;
            const real t195 = t185 + 2.0 * t188 - t194;
            const real t196 = t171 * t184;
            const real t197 = t170 * t179;
            const real t198 = t180 * t197;
            const real t199 = t182 * t198;
            const real t200 = t176 * t182;
            const real t201 = 2.0 * t179 * t200;
            const real t202 = t183 * t197;
            const real t203 = t171 * t202;
            const real t204 = t170 * t193;
            const real t205 = t201 + t203 + 0.5 * t199 - t204;
            const real t206 = t196 * t197 + t180 * t205;
            const real t207 = t170 * t200;
            const real t208 = 4.0 * t207 * t186 + 0.5 * t184 * t198 + t171 * t206 + 2.0 * t176 * t195;
            const real t209 = t176 * t186 + 0.5 * t171 * t198;
            const real t210 = t40 + 0.5872983346207417 * dq_ax - 0.1872983346207417 * dp_ax;
            const real t211 = 2.0 * t171 * t200 + t170 * t184;
            const real t212 = 2.0 * (t190 * t175 - t192 * t181) + b3_y * t210 + t3_x * t174;
            const real t213 = t42 + 0.5872983346207417 * dq_ay - 0.1872983346207417 * dp_ay;
            const real t214 = 1.3237900077244502 * dp_ax + 3.32379000772445 * dq_ax - t87;
            const real t215 = t0 * t214;
            const real t216 = t212 - b3_x * t213 - t3_y * t215;
            const real t217 = t175 * t175 + t181 * t181;
            const real t218 = t3_x * t210 + t3_y * t213;
            const real t219 = t217 + t218;
            const real t220 = t170 * (4.0 * t182 * t195 - 2.0 * t186 * t219) - t184 * t193;
            const real t221 = t171 * t217 - t182 * t184 + t171 * t218;
            const real t222 = 2.0 * t180 * t221 - 4.0 * t183 * t196;
            const real t223 = 8.0 * t200 * t187 + 2.0 * t220 + t171 * t216 - 0.5 * t179 * t222;
            const real t224 = t171 * t180;
            const real t225 = 2.0 * (t182 * t206 + t171 * (2.0 * t183 * t205 - t197 * t221));
            const real t226 = 0.5 * (4.0 * t184 * t202 - 2.0 * t198 * t219) + t225 + t170 * t216;
            const real t227 = 2.0 * t176 * t219 - 8.0 * t182 * t207;
            const real t228 = t176 * t223 + 0.5 * t224 * (t226 - t179 * t227 - 4.0 * t200 * t193);
            const real t229 = 2.0 * (t175 * t208 - t209 * t210 - t190 * t211 - t3_x * t228);
            const real t230 = t171 * t227 + 0.5 * (t170 * t222 - 8.0 * t200 * t184);
            const real t231 = t172 * t174 + t229 - b3_y * t230;
            const real t232 = t0 * (2.0 * t181 * t211 + t3_y * t230 - t172 * t213);
            const real t233 = t0 * (0.6 * t231 - 4.6475800154489 * t232);
            Psi_x[52 * 8 + j] = t233; /* Psi_x(6,4) */
            Psi_x[48 * 8 + j] = -t233; /* Psi_x(6,0) */
            const real t234 = 2.0 * (t192 * t211 + t181 * t208 - t209 * t213 - t3_y * t228);
            const real t235 = t234 + b3_x * t230 - t172 * t215;
            const real t236 = t0 * (t172 * t210 - 2.0 * t175 * t211 - t3_x * t230);
            const real t237 = t0 * (0.6 * t235 - 4.6475800154489 * t236);
            Psi_x[53 * 8 + j] = t237; /* Psi_x(6,5) */
            Psi_x[49 * 8 + j] = -t237; /* Psi_x(6,1) */
            Psi_x[50 * 8 + j] = 1.3237900077244502 * t232 - 0.1872983346207417 * t231; /* Psi_x(6,2) */
            Psi_x[51 * 8 + j] = 1.3237900077244502 * t236 - 0.1872983346207417 * t235; /* Psi_x(6,3) */
            Psi_x[54 * 8 + j] = 3.32379000772445 * t232 + 0.5872983346207417 * t231; /* Psi_x(6,6) */
            Psi_x[55 * 8 + j] = 3.32379000772445 * t236 + 0.5872983346207417 * t235; /* Psi_x(6,7) */
            const real t238 = 0.7367349661563832 * dp_vx + 0.38766637928128617 * t30 - 0.12440134543766938 * dq_vx;
            const real t239 = 0.7753327585625723 * (t0 * t238);
            Psi_v[4 * 8 + j] = t239; /* Psi_v(0,4) */
            Psi_v[0 * 8 + j] = -t239; /* Psi_v(0,0) */
            const real t240 = 0.7367349661563832 * dp_vy + 0.38766637928128617 * t19 - 0.12440134543766938 * dq_vy;
            const real t241 = 0.7753327585625723 * (t0 * t240);
            Psi_v[5 * 8 + j] = t241; /* Psi_v(0,5) */
            Psi_v[1 * 8 + j] = -t241; /* Psi_v(0,1) */
            Psi_v[2 * 8 + j] = 1.4734699323127665 * t238; /* Psi_v(0,2) */
            Psi_v[3 * 8 + j] = 1.4734699323127665 * t240; /* Psi_v(0,3) */
            Psi_v[6 * 8 + j] = -(0.24880269087533877 * t238); /* Psi_v(0,6) */
            Psi_v[7 * 8 + j] = -(0.24880269087533877 * t240); /* Psi_v(0,7) */
            const real t242 = 0.006680854290214084 * dp_vx + 1.3266193350044282 * t30 - 0.33330018929464217 * dq_vx;
            const real t243 = 2.6532386700088564 * (t0 * t242);
            Psi_v[12 * 8 + j] = t243; /* Psi_v(1,4) */
            Psi_v[8 * 8 + j] = -t243; /* Psi_v(1,0) */
            const real t244 = 0.006680854290214084 * dp_vy + 1.3266193350044282 * t19 - 0.33330018929464217 * dq_vy;
            const real t245 = 2.6532386700088564 * (t0 * t244);
            Psi_v[13 * 8 + j] = t245; /* Psi_v(1,5) */
            Psi_v[9 * 8 + j] = -t245; /* Psi_v(1,1) */
            Psi_v[10 * 8 + j] = 0.013361708580428167 * t242; /* Psi_v(1,2) */
            Psi_v[11 * 8 + j] = 0.013361708580428167 * t244; /* Psi_v(1,3) */
            Psi_v[14 * 8 + j] = -(0.6666003785892843 * t242); /* Psi_v(1,6) */
            Psi_v[15 * 8 + j] = -(0.6666003785892843 * t244); /* Psi_v(1,7) */
            const real t246 = 0.006680854290214084 * dq_vx + 1.3266193350044282 * t30 - 0.33330018929464217 * dp_vx;
            const real t247 = 2.6532386700088564 * (t0 * t246);
            Psi_v[20 * 8 + j] = t247; /* Psi_v(2,4) */
            Psi_v[16 * 8 + j] = -t247; /* Psi_v(2,0) */
            const real t248 = 0.006680854290214084 * dq_vy + 1.3266193350044282 * t19 - 0.33330018929464217 * dp_vy;
            const real t249 = 2.6532386700088564 * (t0 * t248);
            Psi_v[21 * 8 + j] = t249; /* Psi_v(2,5) */
            Psi_v[17 * 8 + j] = -t249; /* Psi_v(2,1) */
            Psi_v[18 * 8 + j] = -(0.6666003785892843 * t246); /* Psi_v(2,2) */
            Psi_v[19 * 8 + j] = -(0.6666003785892843 * t248); /* Psi_v(2,3) */
            Psi_v[22 * 8 + j] = 0.013361708580428167 * t246; /* Psi_v(2,6) */
            Psi_v[23 * 8 + j] = 0.013361708580428167 * t248; /* Psi_v(2,7) */
            const real t250 = 0.7367349661563832 * dq_vx + 0.38766637928128617 * t30 - 0.12440134543766938 * dp_vx;
            const real t251 = 0.7753327585625723 * (t0 * t250);
            Psi_v[28 * 8 + j] = t251; /* Psi_v(3,4) */
            Psi_v[24 * 8 + j] = -t251; /* Psi_v(3,0) */
            const real t252 = 0.7367349661563832 * dq_vy + 0.38766637928128617 * t19 - 0.12440134543766938 * dp_vy;
            const real t253 = 0.7753327585625723 * (t0 * t252);
            Psi_v[29 * 8 + j] = t253; /* Psi_v(3,5) */
            Psi_v[25 * 8 + j] = -t253; /* Psi_v(3,1) */
            Psi_v[26 * 8 + j] = -(0.24880269087533877 * t250); /* Psi_v(3,2) */
            Psi_v[27 * 8 + j] = -(0.24880269087533877 * t252); /* Psi_v(3,3) */
            Psi_v[30 * 8 + j] = 1.4734699323127665 * t250; /* Psi_v(3,6) */
            Psi_v[31 * 8 + j] = 1.4734699323127665 * t252; /* Psi_v(3,7) */
            const real t254 = t0 * (t1_y * t38 - t52 * t21);
            const real t255 = t29 * (t73 - 4.0 * t65 - t62) + 0.5 * t93 * (t81 - 2.0 * t80 - t78 - t77);
            const real t256 = t52 * t68 - 2.0 * (t32 * t85 + t1_x * t255) - b1_y * t38;
            const real t257 = 2.0 * t0 * (4.6475800154489 * t254 + 0.6 * t256);
            Psi_v[36 * 8 + j] = t257; /* Psi_v(4,4) */
            Psi_v[32 * 8 + j] = -t257; /* Psi_v(4,0) */
            const real t258 = t0 * (t52 * t32 - t1_x * t38);
            const real t259 = b1_x * t38 - 2.0 * (t21 * t85 + t1_y * t255) - t52 * t71;
            const real t260 = 2.0 * t0 * (4.6475800154489 * t258 + 0.6 * t259);
            Psi_v[37 * 8 + j] = t260; /* Psi_v(4,5) */
            Psi_v[33 * 8 + j] = -t260; /* Psi_v(4,1) */
            Psi_v[34 * 8 + j] = 2.0 * (0.5872983346207417 * t256 - 3.32379000772445 * t254); /* Psi_v(4,2) */
            Psi_v[35 * 8 + j] = 2.0 * (0.5872983346207417 * t259 - 3.32379000772445 * t258); /* Psi_v(4,3) */
            const real t261 = 2.0 * (1.3237900077244502 * t254 + 0.1872983346207417 * t256);
            Psi_v[38 * 8 + j] = -t261; /* Psi_v(4,6) */
            const real t262 = 2.0 * (1.3237900077244502 * t258 + 0.1872983346207417 * t259);
            Psi_v[39 * 8 + j] = -t262; /* Psi_v(4,7) */
            const real t263 = t110 * (t124 - 4.0 * t120 - t117) + 0.5 * t153 * (t134 - 2.0 * t133 - t131 - t129);
            const real t264 = t107 * t121 - 2.0 * (t139 * t109 + t2_x * t263) - b2_y * t141;
            const real t265 = 3.0 * (t0 * t264);
            Psi_v[44 * 8 + j] = t265; /* Psi_v(5,4) */
            Psi_v[40 * 8 + j] = -t265; /* Psi_v(5,0) */
            const real t266 = b2_x * t141 - 2.0 * (t139 * t113 + t2_y * t263) - t107 * t122;
            const real t267 = 3.0 * (t0 * t266);
            Psi_v[45 * 8 + j] = t267; /* Psi_v(5,5) */
            Psi_v[41 * 8 + j] = -t267; /* Psi_v(5,1) */
            const real t268 = t0 * (t2_y * t141 - t107 * t113);
            const real t269 = 0.25 * t264;
            Psi_v[42 * 8 + j] = -(2.0 * (t268 + t269)); /* Psi_v(5,2) */
            const real t270 = t0 * (t107 * t109 - t2_x * t141);
            const real t271 = 0.25 * t266;
            Psi_v[43 * 8 + j] = -(2.0 * (t270 + t271)); /* Psi_v(5,3) */
            Psi_v[46 * 8 + j] = 2.0 * (t268 - t269); /* Psi_v(5,6) */
            Psi_v[47 * 8 + j] = 2.0 * (t270 - t271); /* Psi_v(5,7) */
            const real t272 = t176 * (t194 - 4.0 * t188 - t185) + 0.5 * t224 * (t204 - 2.0 * t203 - t201 - t199);
            const real t273 = t190 * t172 - 2.0 * (t175 * t209 + t3_x * t272) - b3_y * t211;
            const real t274 = t0 * (t3_y * t211 - t172 * t181);
            const real t275 = 2.0 * t0 * (0.6 * t273 - 4.6475800154489 * t274);
            Psi_v[52 * 8 + j] = t275; /* Psi_v(6,4) */
            Psi_v[48 * 8 + j] = -t275; /* Psi_v(6,0) */
            const real t276 = b3_x * t211 - 2.0 * (t181 * t209 + t3_y * t272) - t192 * t172;
            const real t277 = t0 * (t172 * t175 - t3_x * t211);
            const real t278 = 2.0 * t0 * (0.6 * t276 - 4.6475800154489 * t277);
            Psi_v[53 * 8 + j] = t278; /* Psi_v(6,5) */
            Psi_v[49 * 8 + j] = -t278; /* Psi_v(6,1) */
            Psi_v[50 * 8 + j] = 2.0 * (1.3237900077244502 * t274 - 0.1872983346207417 * t273); /* Psi_v(6,2) */
            Psi_v[51 * 8 + j] = 2.0 * (1.3237900077244502 * t277 - 0.1872983346207417 * t276); /* Psi_v(6,3) */
            Psi_v[54 * 8 + j] = 2.0 * (3.32379000772445 * t274 + 0.5872983346207417 * t273); /* Psi_v(6,6) */
            Psi_v[55 * 8 + j] = 2.0 * (3.32379000772445 * t277 + 0.5872983346207417 * t276); /* Psi_v(6,7) */
        }
    }
}

/* stiffness: 688 operations.
 * in:  x (8), sigma (7), tau (0), p (4)
 * out: K (8,8) */
FLEXEL_CLONES
static void planar_cable_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (8 * 8);
        const real *restrict sigma = in[1] + b * (7 * 8);
        const real *restrict p = in[3] + b * (4 * 8);
        real *restrict K = out[0] + b * (64 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = t0 * t0;
            const real sigma_strain1 = sigma[0 * 8 + j];
            const real sigma_strain2 = sigma[1 * 8 + j];
            const real sigma_strain4 = sigma[3 * 8 + j];
            const real sigma_strain3 = sigma[2 * 8 + j];
            const real t2 = 0.15028522162506203 * sigma_strain4 + 1.759918860007591 * sigma_strain3;
            const real t3 = 1.759918860007591 * sigma_strain2 + t2 + 0.15028522162506203 * sigma_strain1;
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real d_x = q_x - p_x;
            const real t4 = d_x * t0;
            const real t5 = 0.6 * t4;
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real t3_x = t5 + 0.5872983346207417 * dq_x - 0.1872983346207417 * dp_x;
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real d_y = q_y - p_y;
            const real t6 = d_y * t0;
            const real t7 = 0.6 * t6;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real t3_y = t7 + 0.5872983346207417 * dq_y - 0.1872983346207417 * dp_y;
            const real t8 = t3_x * t3_x + t3_y * t3_y;
            const real t9 = 1.0 / t8;
            const real t10 = t9 * t9;
            const real t11 = 1.0 / real_sqrt(t8);
            const real t12 = 4.6475800154489 * t6;
            const real t13 = 1.3237900077244502 * dp_y + 3.32379000772445 * dq_y - t12;
            const real b3_y = t0 * t13;
            const real t14 = 4.6475800154489 * t4;
            const real t15 = 1.3237900077244502 * dp_x + 3.32379000772445 * dq_x - t14;
            const real b3_x = t0 * t15;
            const real sigma_curvature3 = sigma[6 * 8 + j];
            const real t16 = sigma_curvature3 * (b3_y * t3_x - b3_x * t3_y);
            const real t17 = t11 * t16;
            const real t18 = t11 * t11;
            const real t19 = t9 * t16;
            const real t20 = t18 * t19;
            const real t21 = t10 * t17 + 0.5 * t11 * t20;
            const real t1_x = 0.5872983346207417 * dp_x + t5 - 0.1872983346207417 * dq_x;
            const real t1_y = 0.5872983346207417 * dp_y + t7 - 0.1872983346207417 * dq_y;
            const real t22 = t1_x * t1_x + t1_y * t1_y;
            const real t23 = 1.0 / t22;
            const real t24 = t23 * t23;
            const real t25 = 1.0 / real_sqrt(t22);
            const real t26 = t12 - 3.32379000772445 * dp_y - 1.3237900077244502 * dq_y;
            const real b1_y = t0 * t26;
            const real t27 = t14 - 3.32379000772445 * dp_x - 1.3237900077244502 * dq_x;
            const real b1_x = t0 * t27;
            const real sigma_curvature1 = sigma[4 * 8 + j];
            const real t28 = sigma_curvature1 * (t1_x * b1_y - t1_y * b1_x);
            const real t29 = t25 * t28;
            const real t30 = t25 * t25;
            const real t31 = t23 * t28;
            const real t32 = t30 * t31;
            const real t33 = t24 * t29 + 0.5 * t25 * t32;
            const real t2_x = 1.5 * t4 - 0.25 * (dp_x + dq_x);
            const real t2_y = 1.5 * t6 - 0.25 * (dp_y + dq_y);
            const real t34 = t2_x * t2_x + t2_y * t2_y;
            const real t35 = 1.0 / t34;
            const real t36 = t35 * t35;
            const real t37 = 1.0 / real_sqrt(t34);
            const real b2_y = t0 * (dq_y - dp_y);
            const real b2_x = t0 * (dq_x - dp_x);
            const real sigma_curvature2 = sigma[5 * 8 + j];
            const real t38 = (t2_x * b2_y - t2_y * b2_x) * sigma_curvature2;
            const real t39 = t37 * t38;
            const real t40 = t37 * t37;
            const real t41 = t35 * t38;
            const real t42 = t40 * t41;
            const real t43 = t36 * t39 + 0.5 * t37 * t42;
            const real t44 = t3 - 0.72 * (t21 + t33) - 4.5 * t43;
            const real t45 = t25 * t30;
            const real t46 = sigma_curvature1 * (t25 * t24 + 0.5 * t23 * t45);
            const real t47 = t0 * t1_y * t46;
            const real t48 = b1_y * t46;
            const real t49 = 4.6475800154489 * t47 - 0.6 * t48;
            const real t50 = t45 * (0.5 * t32 + t24 * t28) + t25 * (t30 * t28 * t24 + t25 * t31 * t45);
            const real t51 = 0.5 * t50 + 2.0 * t23 * t29 * t24;
            const real t52 = t1_x * t51;
            const real t53 = t49 + 1.2 * t52;
            const real t54 = t1_x * t53;
            const real t55 = t11 * t18;
            const real t56 = sigma_curvature3 * (t11 * t10 + 0.5 * t9 * t55);
            const real t57 = t0 * t3_y * t56;
            const real t58 = b3_y * t56;
            const real t59 = 4.6475800154489 * t57 + 0.6 * t58;
            const real t60 = t55 * (0.5 * t20 + t10 * t16) + t11 * (t18 * t16 * t10 + t11 * t19 * t55);
            const real t61 = 0.5 * t60 + 2.0 * t9 * t17 * t10;
            const real t62 = t3_x * t61;
            const real t63 = t59 - 1.2 * t62;
            const real t64 = t3_x * t63;
            const real t65 = t37 * t40;
            const real t66 = sigma_curvature2 * (t37 * t36 + 0.5 * t35 * t65);
            const real t67 = b2_y * t66;
            const real t68 = t44 + 1.2 * (t54 + t1_x * t49 - t3_x * t59 - t64) - 4.5 * (t2_x * t67);
            const real t69 = t36 * t38;
            const real t70 = t65 * (0.5 * t42 + t69) + t37 * (t37 * t41 * t65 + t40 * t69);
            const real t71 = 2.0 * t35 * t39 * t36 + 0.5 * t70;
            const real t72 = t2_x * t71;
            const real t73 = 1.5 * t67 - 3.0 * t72;
            const real t74 = t2_x * t73;
            const real t75 = t1 * (t68 - 3.0 * t74);
            K[0 * 8 + j] = K[36 * 8 + j] = t75; /* K(0,0) K(4,4) */
            const real t76 = b1_x * t46;
            const real t77 = t0 * t1_x * t46;
            const real t78 = 0.6 * t76 - 4.6475800154489 * t77;
            const real t79 = t1_y * t51;
            const real t80 = t78 + 1.2 * t79;
            const real t81 = t1_x * t80;
            const real t82 = t0 * t3_x * t56;
            const real t83 = b3_x * t56;
            const real t84 = 4.6475800154489 * t82 + 0.6 * t83;
            const real t85 = t3_y * t61;
            const real t86 = t84 + 1.2 * t85;
            const real t87 = t3_x * t86;
            const real t88 = b2_x * t66;
            const real t89 = t2_y * t71;
            const real t90 = 1.5 * t88 + 3.0 * t89;
            const real t91 = t2_x * t90;
            const real t92 = 1.2 * (t81 + t87 + t1_y * t49 - t3_y * t59) + 3.0 * t91 - 4.5 * (t2_y * t67);
            const real t93 = t1 * t92;
            K[1 * 8 + j] = K[8 * 8 + j] = K[37 * 8 + j] = K[44 * 8 + j] = t93; /* K(0,1) K(1,0) K(4,5) K(5,4) */
            const real t94 = 1.3237900077244502 * t57;
            const real t95 = 0.1872983346207417 * t58;
            const real t96 = t94 + t95;
            const real t97 = t3_x * t96;
            const real t98 = 0.5872983346207417 * t48 + 3.32379000772445 * t47;
            const real t99 = t1_x * t98;
            const real t100 = 0.008862950475745288 * sigma_strain2 + 0.285607376819766 * sigma_strain1;
            const real t101 = 0.75 * t43;
            const real t102 = t100 + t101 + 0.22475800154489003 * t21 - 0.04822621916354184 * sigma_strain4;
            const real t103 = t102 - 0.4421624754789082 * sigma_strain3 - 0.70475800154489 * t33;
            const real t104 = 0.25 * t67;
            const real t105 = t0 * t2_y;
            const real t106 = t105 * t66;
            const real t107 = t104 - t106;
            const real t108 = t2_x * t107;
            const real t109 = 0.5 * t74;
            const real t110 = t109 + 0.3745966692414834 * t64 + 1.1745966692414833 * t54;
            const real t111 = t0 * (3.0 * t108 + t110 + t103 + 1.2 * (t97 - t99));
            K[20 * 8 + j] = K[34 * 8 + j] = t111; /* K(2,4) K(4,2) */
            K[2 * 8 + j] = K[16 * 8 + j] = -t111; /* K(0,2) K(2,0) */
            const real t112 = t0 * t2_x;
            const real t113 = t112 * t66;
            const real t114 = 0.25 * t88;
            const real t115 = t113 - t114;
            const real t116 = t2_x * t115;
            const real t117 = 0.5872983346207417 * t76 + 3.32379000772445 * t77;
            const real t118 = t1_x * t117;
            const real t119 = 1.3237900077244502 * t82 + 0.1872983346207417 * t83;
            const real t120 = t3_x * t119;
            const real t121 = t1_y * t53;
            const real t122 = 0.5 * t2_y * t73;
            const real t123 = t3_y * t63;
            const real t124 = t122 + 0.3745966692414834 * t123 + 1.1745966692414833 * t121;
            const real t125 = sigma_curvature1 * t25 * t0 * t23;
            const real t126 = t37 * sigma_curvature2 * t0 * t35;
            const real t127 = 1.5 * t126;
            const real t128 = sigma_curvature3 * t11 * t0 * t9;
            const real t129 = t127 + 0.07620999227554986 * t128 + 4.723790007724451 * t125;
            const real t130 = t0 * (1.2 * (t118 - t120) + t124 + 3.0 * t116 - t129);
            K[28 * 8 + j] = K[35 * 8 + j] = t130; /* K(3,4) K(4,3) */
            K[3 * 8 + j] = K[24 * 8 + j] = -t130; /* K(0,3) K(3,0) */
            K[4 * 8 + j] = K[32 * 8 + j] = -t75; /* K(0,4) K(4,0) */
            K[5 * 8 + j] = K[12 * 8 + j] = K[33 * 8 + j] = K[40 * 8 + j] = -t93; /* K(0,5) K(1,4) K(4,1) K(5,0) */
            const real t131 = 0.1872983346207417 * t48;
            const real t132 = 1.3237900077244502 * t47;
            const real t133 = t131 - t132;
            const real t134 = t1_x * t133;
            const real t135 = 3.32379000772445 * t57 - 0.5872983346207417 * t58;
            const real t136 = t3_x * t135;
            const real t137 = 0.285607376819766 * sigma_strain4 + 0.22475800154489003 * t33;
            const real t138 = 0.008862950475745288 * sigma_strain3 + t137 + t101 - 0.70475800154489 * t21;
            const real t139 = t138 - 0.4421624754789082 * sigma_strain2 - 0.04822621916354184 * sigma_strain1;
            const real t140 = t106 + t104;
            const real t141 = t2_x * t140;
            const real t142 = t109 + 3.0 * t141 + t139 + 1.2 * (t134 + t136) - 0.3745966692414834 * t54;
            const real t143 = t0 * (t142 - 1.1745966692414833 * t64);
            K[38 * 8 + j] = K[52 * 8 + j] = t143; /* K(4,6) K(6,4) */
            K[6 * 8 + j] = K[48 * 8 + j] = -t143; /* K(0,6) K(6,0) */
            const real t144 = 1.3237900077244502 * t77;
            const real t145 = 0.1872983346207417 * t76;
            const real t146 = t144 - t145;
            const real t147 = 0.5872983346207417 * t83 - 3.32379000772445 * t82;
            const real t148 = t127 + 4.723790007724451 * t128 + 0.07620999227554986 * t125;
            const real t149 = t113 + t114;
            const real t150 = t148 + t122 + 1.2 * (t1_x * t146 + t3_x * t147) - 3.0 * (t2_x * t149);
            const real t151 = t150 - 0.3745966692414834 * t121 - 1.1745966692414833 * t123;
            const real t152 = t0 * t151;
            K[39 * 8 + j] = K[60 * 8 + j] = t152; /* K(4,7) K(7,4) */
            K[7 * 8 + j] = K[56 * 8 + j] = -t152; /* K(0,7) K(7,0) */
            const real t153 = t1_y * t80;
            const real t154 = t3_y * t86;
            const real t155 = t2_y * t90;
            const real t156 = 3.0 * t155 + 4.5 * (t2_y * t88) + t44 + 1.2 * (t153 + t154 + t1_y * t78 + t3_y * t84);
            const real t157 = t1 * t156;
            K[9 * 8 + j] = K[45 * 8 + j] = t157; /* K(1,1) K(5,5) */
            const real t158 = t2_y * t107;
            const real t159 = t3_y * t96;
            const real t160 = t1_y * t98;
            const real t161 = t129 + 1.1745966692414833 * t81 + 1.2 * (t159 - t160) + 3.0 * t158;
            const real t162 = 0.5 * t91;
            const real t163 = t0 * (t161 - 0.3745966692414834 * t87 - t162);
            K[21 * 8 + j] = K[42 * 8 + j] = t163; /* K(2,5) K(5,2) */
            K[10 * 8 + j] = K[17 * 8 + j] = -t163; /* K(1,2) K(2,1) */
            const real t164 = t1_y * t117;
            const real t165 = t3_y * t119;
            const real t166 = t2_y * t115;
            const real t167 = 1.1745966692414833 * t153 + 3.0 * t166 + t103 + 1.2 * (t164 - t165);
            const real t168 = 0.5 * t155;
            const real t169 = t0 * (t167 - 0.3745966692414834 * t154 - t168);
            K[29 * 8 + j] = K[43 * 8 + j] = t169; /* K(3,5) K(5,3) */
            K[11 * 8 + j] = K[25 * 8 + j] = -t169; /* K(1,3) K(3,1) */
            K[13 * 8 + j] = K[41 * 8 + j] = -t157; /* K(1,5) K(5,1) */
            const real t170 = t2_y * t140;
            const real t171 = t1_y * t133;
            const real t172 = t3_y * t135;
            const real t173 = 1.1745966692414833 * t87 + 1.2 * (t171 + t172) + 3.0 * t170;
            const real t174 = t0 * (t173 - t148 - 0.3745966692414834 * t81 - t162);
            K[46 * 8 + j] = K[53 * 8 + j] = t174; /* K(5,6) K(6,5) */
            K[14 * 8 + j] = K[49 * 8 + j] = -t174; /* K(1,6) K(6,1) */
            const real t175 = t1_y * t146;
            const real t176 = t3_y * t147;
            const real t177 = t2_y * t149;
            const real t178 = t139 + 1.1745966692414833 * t154 + 1.2 * (t175 + t176) - 3.0 * t177;
            const real t179 = t0 * (t178 - 0.3745966692414834 * t153 - t168);
            K[47 * 8 + j] = K[61 * 8 + j] = t179; /* K(5,7) K(7,5) */
            K[15 * 8 + j] = K[57 * 8 + j] = -t179; /* K(1,7) K(7,1) */
            const real t180 = 0.3745966692414834 * (t3_x * (0.3745966692414834 * t62 - t95 - t94) - t97);
            const real t181 = 0.015475694746702344 * sigma_strain4 + 0.11108901618384431 * sigma_strain3;
            const real t182 = 4.463381404707193e-05 * sigma_strain2 + t181 + 0.5427784103574471 * sigma_strain1;
            const real t183 = 0.125 * t43;
            const real t184 = t182 - t183 - 0.07016133230340665 * t21 - 0.6898386676965933 * t33;
            const real t185 = 0.5 * t72;
            const real t186 = 0.25 * b2_y;
            const real t187 = 1.1745966692414833 * (t99 + t1_x * (t98 - 1.1745966692414833 * t52));
            const real t188 = t184 + 0.5 * t2_x * (t185 + (t105 - t186) * t66) + t180 - t187;
            const real t189 = 0.5 * t108;
            K[18 * 8 + j] = t188 - t189; /* K(2,2) */
            const real t190 = t119 + 0.3745966692414834 * t85;
            const real t191 = 0.5 * t89;
            const real t192 = 0.25 * b2_x;
            const real t193 = t191 + (t192 - t112) * t66;
            const real t194 = t117 + 1.1745966692414833 * t79;
            const real t195 = 0.5 * t2_x * t193 + 1.1745966692414833 * (t1_x * t194 - t160);
            const real t196 = 0.5 * t158;
            K[19 * 8 + j] = K[26 * 8 + j] = 0.3745966692414834 * (t3_x * t190 - t159) + t195 - t196;
                /* K(2,3) K(3,2) */
            const real t197 = t135 + 1.1745966692414833 * t62;
            const real t198 = t3_x * t197;
            const real t199 = 0.22 * t21 + 0.22 * t33 - t183 - 0.09165082102082989 * sigma_strain4;
            const real t200 = t199 - 0.0022267299995782763 * sigma_strain3 - 0.0022267299995782763 * sigma_strain2;
            const real t201 = t200 - 0.09165082102082989 * sigma_strain1;
            const real t202 = t185 - (t105 + t186) * t66;
            const real t203 = 0.5 * t2_x * t202;
            const real t204 = t203 + 1.1745966692414833 * t97 + t201 + 0.3745966692414834 * (t99 - t198);
            const real t205 = t132 + 0.3745966692414834 * t52 - t131;
            const real t206 = t1_x * t205;
            K[22 * 8 + j] = K[50 * 8 + j] = t204 - t189 - 1.1745966692414833 * t206; /* K(2,6) K(6,2) */
            const real t207 = t191 + (t112 + t192) * t66;
            const real t208 = 0.5 * t2_x * t207;
            const real t209 = t147 + 1.1745966692414833 * t85;
            const real t210 = t3_x * t209;
            const real t211 = t208 + 0.3745966692414834 * (t160 - t210) + 1.1745966692414833 * t159;
            const real t212 = 0.7774596669241484 * t128 + 0.7774596669241484 * t125 + 0.6225403330758517 * (t128
                + t125);
            const real t213 = 0.5 * t126 + t212;
            const real t214 = t145 + 0.3745966692414834 * t79 - t144;
            const real t215 = t1_x * t214;
            K[23 * 8 + j] = K[58 * 8 + j] = t211 - t213 - t196 - 1.1745966692414833 * t215; /* K(2,7) K(7,2) */
            const real t216 = t184 + 0.5 * t2_y * t193 + 1.1745966692414833 * (t164 + t1_y * t194);
            const real t217 = 0.5 * t166;
            K[27 * 8 + j] = 0.3745966692414834 * (t165 + t3_y * t190) + t216 - t217; /* K(3,3) */
            const real t218 = t213 + 0.5 * (t2_y * t202 - t116) - 0.3745966692414834 * (t118 + t3_y * t197);
            K[30 * 8 + j] = K[51 * 8 + j] = t218 - 1.1745966692414833 * t120 - 1.1745966692414833 * (t1_y * t205);
                /* K(3,6) K(6,3) */
            const real t219 = 0.5 * t2_y * t207;
            const real t220 = t3_y * t209;
            const real t221 = t201 + t219 - 0.3745966692414834 * (t164 + t220) - t217 - 1.1745966692414833 * t165;
            const real t222 = t1_y * t214;
            K[31 * 8 + j] = K[59 * 8 + j] = t221 - 1.1745966692414833 * t222; /* K(3,7) K(7,3) */
            const real t223 = 0.5427784103574471 * sigma_strain4 + 4.463381404707193e-05 * sigma_strain3;
            const real t224 = 0.11108901618384431 * sigma_strain2 + t223 + 0.015475694746702344 * sigma_strain1;
            const real t225 = t224 - t183 - 0.6898386676965933 * t21 - 0.07016133230340665 * t33;
            const real t226 = t225 + t203 + 0.3745966692414834 * (t206 - t134) + 1.1745966692414833 * (t136 + t198);
            K[54 * 8 + j] = t226 - 0.5 * t141; /* K(6,6) */
            const real t227 = t208 + 0.3745966692414834 * (t215 - t171) + 1.1745966692414833 * (t172 + t210);
            K[55 * 8 + j] = K[62 * 8 + j] = t227 - 0.5 * t170; /* K(6,7) K(7,6) */
            const real t228 = t219 + 0.5 * t177 + t225 + 0.3745966692414834 * (t222 - t175);
            K[63 * 8 + j] = 1.1745966692414833 * (t176 + t220) + t228; /* K(7,7) */
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

const flexel_element flexel_planar_cable = {
    .name = "planar_cable",
    .digest = "4bbdd74f127b2020",
    .n = 8,
    .m = 7,
    .k = 0,
    .np = 4,
    .position = planar_cable_position,
    .acceleration = planar_cable_acceleration,
    .rates = planar_cable_rates,
    .kinematics = planar_cable_kinematics,
    .stiffness = planar_cable_stiffness,
    .inertia = planar_cable_inertia,
    .tangent = planar_cable_tangent,
};
