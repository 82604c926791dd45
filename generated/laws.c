/* Constitutive laws. Written by `flexel derive`; do not edit. */
#include "kernels.h"

/* linear_1
 *
 * sigma = preload + S e + D ed
 * energy = preload.e + e.S e/2
 *
 * Source: Kelvin-Voigt model
 *
 * 1 deformations, 0 slips
 * p (3):
 *   preload (1) [N or N m]: stress at zero deformation
 *   S (1) [N/m or N m]: stiffness, upper triangle, row by row
 *   D (1) [N s/m or N m s]: damping, upper triangle, row by row */

/* law: 10 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (3)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void linear_1_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real D = p[2 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S = p[1 * 8 + j];
            const real t0 = e_0 * S;
            const real preload = p[0 * 8 + j];
            const real t1 = preload + t0 + ed_0 * D;
            sigma[0 * 8 + j] = t1;
            const real t2 = 0.5 * t0;
            const real t3 = preload + t2;
            U[0 * 8 + j] = e_0 * t3;
            P[0 * 8 + j] = ed_0 * (t1 - t3 - t2);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (3)
 * out: J (1,2) */
FLEXEL_CLONES
static void linear_1_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict J = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S = p[1 * 8 + j];
            J[0 * 8 + j] = S; /* J(0,0) */
            const real D = p[2 * 8 + j];
            J[1 * 8 + j] = D; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_linear_1 = {
    .name = "linear_1",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 3,
    .law = linear_1_law,
    .tangent = linear_1_tangent,
};

/* linear_2
 *
 * sigma = preload + S e + D ed
 * energy = preload.e + e.S e/2
 *
 * Source: Kelvin-Voigt model
 *
 * 2 deformations, 0 slips
 * p (8):
 *   preload (2) [N or N m]: stress at zero deformation
 *   S (3) [N/m or N m]: stiffness, upper triangle, row by row
 *   D (3) [N s/m or N m s]: damping, upper triangle, row by row */

/* law: 39 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (8)
 * out: sigma (2), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void linear_2_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict p = in[5] + b * (8 * 8);
        real *restrict sigma = out[0] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[6 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[5 * 8 + j];
            const real preload_0 = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[2 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[3 * 8 + j];
            const real t0 = e_0 * S_11 + e_1 * S_12;
            const real t1 = preload_0 + ed_0 * D_11 + ed_1 * D_12 + t0;
            sigma[0 * 8 + j] = t1;
            const real D_22 = p[7 * 8 + j];
            const real preload_1 = p[1 * 8 + j];
            const real S_22 = p[4 * 8 + j];
            const real t2 = e_0 * S_12 + e_1 * S_22;
            const real t3 = preload_1 + ed_0 * D_12 + ed_1 * D_22 + t2;
            sigma[1 * 8 + j] = t3;
            const real t4 = preload_0 + 0.5 * t0;
            const real t5 = preload_1 + 0.5 * t2;
            U[0 * 8 + j] = e_0 * t4 + e_1 * t5;
            const real t6 = e_0 * (ed_0 * S_11 + ed_1 * S_12) + e_1 * (ed_0 * S_12 + ed_1 * S_22);
            P[0 * 8 + j] = ed_0 * (t1 - t4) + ed_1 * (t3 - t5) - 0.5 * t6;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (8)
 * out: J (2,4) */
FLEXEL_CLONES
static void linear_2_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (8 * 8);
        real *restrict J = out[0] + b * (8 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[2 * 8 + j];
            J[0 * 8 + j] = S_11; /* J(0,0) */
            const real S_12 = p[3 * 8 + j];
            J[1 * 8 + j] = J[4 * 8 + j] = S_12; /* J(0,1) J(1,0) */
            const real D_11 = p[5 * 8 + j];
            J[2 * 8 + j] = D_11; /* J(0,2) */
            const real D_12 = p[6 * 8 + j];
            J[3 * 8 + j] = J[6 * 8 + j] = D_12; /* J(0,3) J(1,2) */
            const real S_22 = p[4 * 8 + j];
            J[5 * 8 + j] = S_22; /* J(1,1) */
            const real D_22 = p[7 * 8 + j];
            J[7 * 8 + j] = D_22; /* J(1,3) */
        }
    }
}

const flexel_law flexel_law_linear_2 = {
    .name = "linear_2",
    .digest = "c9cb37880850cb4e",
    .m = 2,
    .k = 0,
    .nz = 0,
    .np = 8,
    .law = linear_2_law,
    .tangent = linear_2_tangent,
};

/* linear_3
 *
 * sigma = preload + S e + D ed
 * energy = preload.e + e.S e/2
 *
 * Source: Kelvin-Voigt model
 *
 * 3 deformations, 0 slips
 * p (15):
 *   preload (3) [N or N m]: stress at zero deformation
 *   S (6) [N/m or N m]: stiffness, upper triangle, row by row
 *   D (6) [N s/m or N m s]: damping, upper triangle, row by row */

/* law: 77 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (15)
 * out: sigma (3), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void linear_3_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[5] + b * (15 * 8);
        real *restrict sigma = out[0] + b * (3 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[11 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[10 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[9 * 8 + j];
            const real preload_0 = p[0 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[5 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[3 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[4 * 8 + j];
            const real t0 = e_0 * S_11 + e_1 * S_12 + e_2 * S_13;
            const real t1 = preload_0 + ed_0 * D_11 + ed_1 * D_12 + ed_2 * D_13 + t0;
            sigma[0 * 8 + j] = t1;
            const real D_23 = p[13 * 8 + j];
            const real D_22 = p[12 * 8 + j];
            const real preload_1 = p[1 * 8 + j];
            const real S_23 = p[7 * 8 + j];
            const real S_22 = p[6 * 8 + j];
            const real t2 = e_0 * S_12 + e_1 * S_22 + e_2 * S_23;
            const real t3 = preload_1 + ed_0 * D_12 + ed_1 * D_22 + ed_2 * D_23 + t2;
            sigma[1 * 8 + j] = t3;
            const real D_33 = p[14 * 8 + j];
            const real preload_2 = p[2 * 8 + j];
            const real S_33 = p[8 * 8 + j];
            const real t4 = e_0 * S_13 + e_1 * S_23 + e_2 * S_33;
            const real t5 = preload_2 + ed_0 * D_13 + ed_1 * D_23 + ed_2 * D_33 + t4;
            sigma[2 * 8 + j] = t5;
            const real t6 = preload_0 + 0.5 * t0;
            const real t7 = preload_1 + 0.5 * t2;
            const real t8 = preload_2 + 0.5 * t4;
            U[0 * 8 + j] = e_1 * t7 + e_2 * t8 + e_0 * t6;
            const real t9 = e_2 * (ed_0 * S_13 + ed_1 * S_23 + ed_2 * S_33) + e_0 * (ed_0 * S_11 + ed_1 * S_12 + ed_2
                * S_13);
            const real t10 = 0.5 * (e_1 * (ed_0 * S_12 + ed_1 * S_22 + ed_2 * S_23) + t9);
            P[0 * 8 + j] = ed_2 * (t5 - t8) + ed_0 * (t1 - t6) + ed_1 * (t3 - t7) - t10;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (15)
 * out: J (3,6) */
FLEXEL_CLONES
static void linear_3_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (15 * 8);
        real *restrict J = out[0] + b * (18 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[3 * 8 + j];
            J[0 * 8 + j] = S_11; /* J(0,0) */
            const real S_12 = p[4 * 8 + j];
            J[1 * 8 + j] = J[6 * 8 + j] = S_12; /* J(0,1) J(1,0) */
            const real S_13 = p[5 * 8 + j];
            J[2 * 8 + j] = J[12 * 8 + j] = S_13; /* J(0,2) J(2,0) */
            const real D_11 = p[9 * 8 + j];
            J[3 * 8 + j] = D_11; /* J(0,3) */
            const real D_12 = p[10 * 8 + j];
            J[4 * 8 + j] = J[9 * 8 + j] = D_12; /* J(0,4) J(1,3) */
            const real D_13 = p[11 * 8 + j];
            J[5 * 8 + j] = J[15 * 8 + j] = D_13; /* J(0,5) J(2,3) */
            const real S_22 = p[6 * 8 + j];
            J[7 * 8 + j] = S_22; /* J(1,1) */
            const real S_23 = p[7 * 8 + j];
            J[8 * 8 + j] = J[13 * 8 + j] = S_23; /* J(1,2) J(2,1) */
            const real D_22 = p[12 * 8 + j];
            J[10 * 8 + j] = D_22; /* J(1,4) */
            const real D_23 = p[13 * 8 + j];
            J[11 * 8 + j] = J[16 * 8 + j] = D_23; /* J(1,5) J(2,4) */
            const real S_33 = p[8 * 8 + j];
            J[14 * 8 + j] = S_33; /* J(2,2) */
            const real D_33 = p[14 * 8 + j];
            J[17 * 8 + j] = D_33; /* J(2,5) */
        }
    }
}

const flexel_law flexel_law_linear_3 = {
    .name = "linear_3",
    .digest = "c9cb37880850cb4e",
    .m = 3,
    .k = 0,
    .nz = 0,
    .np = 15,
    .law = linear_3_law,
    .tangent = linear_3_tangent,
};

/* linear_4
 *
 * sigma = preload + S e + D ed
 * energy = preload.e + e.S e/2
 *
 * Source: Kelvin-Voigt model
 *
 * 4 deformations, 0 slips
 * p (24):
 *   preload (4) [N or N m]: stress at zero deformation
 *   S (10) [N/m or N m]: stiffness, upper triangle, row by row
 *   D (10) [N s/m or N m s]: damping, upper triangle, row by row */

/* law: 127 operations.
 * in:  e (4), ed (4), s (0), z (0), t (1), p (24)
 * out: sigma (4), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void linear_4_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (4 * 8);
        const real *restrict ed = in[1] + b * (4 * 8);
        const real *restrict p = in[5] + b * (24 * 8);
        real *restrict sigma = out[0] + b * (4 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_3 = ed[3 * 8 + j];
            const real D_14 = p[17 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[16 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[15 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[14 * 8 + j];
            const real preload_0 = p[0 * 8 + j];
            const real t0 = preload_0 + ed_0 * D_11 + ed_1 * D_12 + ed_2 * D_13 + ed_3 * D_14;
            const real e_3 = e[3 * 8 + j];
            const real S_14 = p[7 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[6 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[4 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[5 * 8 + j];
            const real t1 = e_0 * S_11 + e_1 * S_12 + e_2 * S_13 + e_3 * S_14;
            const real t2 = t0 + t1;
            sigma[0 * 8 + j] = t2;
            const real D_24 = p[20 * 8 + j];
            const real D_23 = p[19 * 8 + j];
            const real D_22 = p[18 * 8 + j];
            const real preload_1 = p[1 * 8 + j];
            const real t3 = preload_1 + ed_0 * D_12 + ed_1 * D_22 + ed_2 * D_23 + ed_3 * D_24;
            const real S_24 = p[10 * 8 + j];
            const real S_23 = p[9 * 8 + j];
            const real S_22 = p[8 * 8 + j];
            const real t4 = e_0 * S_12 + e_1 * S_22 + e_2 * S_23 + e_3 * S_24;
            const real t5 = t3 + t4;
            sigma[1 * 8 + j] = t5;
            const real D_34 = p[22 * 8 + j];
            const real D_33 = p[21 * 8 + j];
            const real preload_2 = p[2 * 8 + j];
            const real t6 = preload_2 + ed_0 * D_13 + ed_1 * D_23 + ed_2 * D_33 + ed_3 * D_34;
            const real S_34 = p[12 * 8 + j];
            const real S_33 = p[11 * 8 + j];
            const real t7 = e_0 * S_13 + e_1 * S_23 + e_2 * S_33 + e_3 * S_34;
            const real t8 = t6 + t7;
            sigma[2 * 8 + j] = t8;
            const real D_44 = p[23 * 8 + j];
            const real preload_3 = p[3 * 8 + j];
            const real t9 = preload_3 + ed_0 * D_14 + ed_1 * D_24 + ed_2 * D_34 + ed_3 * D_44;
            const real S_44 = p[13 * 8 + j];
            const real t10 = e_0 * S_14 + e_1 * S_24 + e_2 * S_34 + e_3 * S_44;
            const real t11 = t9 + t10;
            sigma[3 * 8 + j] = t11;
            const real t12 = preload_2 + 0.5 * t7;
            const real t13 = preload_3 + 0.5 * t10;
            const real t14 = preload_1 + 0.5 * t4;
            const real t15 = preload_0 + 0.5 * t1;
            U[0 * 8 + j] = e_1 * t14 + e_0 * t15 + e_3 * t13 + e_2 * t12;
            const real t16 = ed_3 * (t11 - t13) + ed_2 * (t8 - t12) + ed_0 * (t2 - t15);
            const real t17 = e_1 * (ed_0 * S_12 + ed_1 * S_22 + ed_2 * S_23 + ed_3 * S_24);
            const real t18 = e_0 * (ed_0 * S_11 + ed_1 * S_12 + ed_2 * S_13 + ed_3 * S_14);
            const real t19 = e_3 * (ed_0 * S_14 + ed_1 * S_24 + ed_2 * S_34 + ed_3 * S_44);
            const real t20 = e_2 * (ed_0 * S_13 + ed_1 * S_23 + ed_2 * S_33 + ed_3 * S_34);
            P[0 * 8 + j] = ed_1 * (t5 - t14) + t16 - 0.5 * (t19 + t20 + t18 + t17);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (4), ed (4), s (0), z (0), t (1), p (24)
 * out: J (4,8) */
FLEXEL_CLONES
static void linear_4_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (24 * 8);
        real *restrict J = out[0] + b * (32 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[4 * 8 + j];
            J[0 * 8 + j] = S_11; /* J(0,0) */
            const real S_12 = p[5 * 8 + j];
            J[1 * 8 + j] = J[8 * 8 + j] = S_12; /* J(0,1) J(1,0) */
            const real S_13 = p[6 * 8 + j];
            J[2 * 8 + j] = J[16 * 8 + j] = S_13; /* J(0,2) J(2,0) */
            const real S_14 = p[7 * 8 + j];
            J[3 * 8 + j] = J[24 * 8 + j] = S_14; /* J(0,3) J(3,0) */
            const real D_11 = p[14 * 8 + j];
            J[4 * 8 + j] = D_11; /* J(0,4) */
            const real D_12 = p[15 * 8 + j];
            J[5 * 8 + j] = J[12 * 8 + j] = D_12; /* J(0,5) J(1,4) */
            const real D_13 = p[16 * 8 + j];
            J[6 * 8 + j] = J[20 * 8 + j] = D_13; /* J(0,6) J(2,4) */
            const real D_14 = p[17 * 8 + j];
            J[7 * 8 + j] = J[28 * 8 + j] = D_14; /* J(0,7) J(3,4) */
            const real S_22 = p[8 * 8 + j];
            J[9 * 8 + j] = S_22; /* J(1,1) */
            const real S_23 = p[9 * 8 + j];
            J[10 * 8 + j] = J[17 * 8 + j] = S_23; /* J(1,2) J(2,1) */
            const real S_24 = p[10 * 8 + j];
            J[11 * 8 + j] = J[25 * 8 + j] = S_24; /* J(1,3) J(3,1) */
            const real D_22 = p[18 * 8 + j];
            J[13 * 8 + j] = D_22; /* J(1,5) */
            const real D_23 = p[19 * 8 + j];
            J[14 * 8 + j] = J[21 * 8 + j] = D_23; /* J(1,6) J(2,5) */
            const real D_24 = p[20 * 8 + j];
            J[15 * 8 + j] = J[29 * 8 + j] = D_24; /* J(1,7) J(3,5) */
            const real S_33 = p[11 * 8 + j];
            J[18 * 8 + j] = S_33; /* J(2,2) */
            const real S_34 = p[12 * 8 + j];
            J[19 * 8 + j] = J[26 * 8 + j] = S_34; /* J(2,3) J(3,2) */
            const real D_33 = p[21 * 8 + j];
            J[22 * 8 + j] = D_33; /* J(2,6) */
            const real D_34 = p[22 * 8 + j];
            J[23 * 8 + j] = J[30 * 8 + j] = D_34; /* J(2,7) J(3,6) */
            const real S_44 = p[13 * 8 + j];
            J[27 * 8 + j] = S_44; /* J(3,3) */
            const real D_44 = p[23 * 8 + j];
            J[31 * 8 + j] = D_44; /* J(3,7) */
        }
    }
}

const flexel_law flexel_law_linear_4 = {
    .name = "linear_4",
    .digest = "c9cb37880850cb4e",
    .m = 4,
    .k = 0,
    .nz = 0,
    .np = 24,
    .law = linear_4_law,
    .tangent = linear_4_tangent,
};

/* linear_5
 *
 * sigma = preload + S e + D ed
 * energy = preload.e + e.S e/2
 *
 * Source: Kelvin-Voigt model
 *
 * 5 deformations, 0 slips
 * p (35):
 *   preload (5) [N or N m]: stress at zero deformation
 *   S (15) [N/m or N m]: stiffness, upper triangle, row by row
 *   D (15) [N s/m or N m s]: damping, upper triangle, row by row */

/* law: 189 operations.
 * in:  e (5), ed (5), s (0), z (0), t (1), p (35)
 * out: sigma (5), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void linear_5_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (5 * 8);
        const real *restrict ed = in[1] + b * (5 * 8);
        const real *restrict p = in[5] + b * (35 * 8);
        real *restrict sigma = out[0] + b * (5 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_4 = ed[4 * 8 + j];
            const real D_15 = p[24 * 8 + j];
            const real ed_3 = ed[3 * 8 + j];
            const real D_14 = p[23 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[22 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[21 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[20 * 8 + j];
            const real preload_0 = p[0 * 8 + j];
            const real t0 = preload_0 + ed_0 * D_11 + ed_1 * D_12 + ed_2 * D_13 + ed_3 * D_14;
            const real e_4 = e[4 * 8 + j];
            const real S_15 = p[9 * 8 + j];
            const real e_3 = e[3 * 8 + j];
            const real S_14 = p[8 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[7 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[5 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[6 * 8 + j];
            const real t1 = e_0 * S_11 + e_1 * S_12 + e_2 * S_13 + e_3 * S_14 + e_4 * S_15;
            const real t2 = ed_4 * D_15 + t0 + t1;
            sigma[0 * 8 + j] = t2;
            const real D_25 = p[28 * 8 + j];
            const real D_24 = p[27 * 8 + j];
            const real D_23 = p[26 * 8 + j];
            const real D_22 = p[25 * 8 + j];
            const real preload_1 = p[1 * 8 + j];
            const real t3 = preload_1 + ed_0 * D_12 + ed_1 * D_22 + ed_2 * D_23 + ed_3 * D_24;
            const real S_25 = p[13 * 8 + j];
            const real S_24 = p[12 * 8 + j];
            const real S_23 = p[11 * 8 + j];
            const real S_22 = p[10 * 8 + j];
            const real t4 = e_0 * S_12 + e_1 * S_22 + e_2 * S_23 + e_3 * S_24 + e_4 * S_25;
            const real t5 = ed_4 * D_25 + t3 + t4;
            sigma[1 * 8 + j] = t5;
            const real D_35 = p[31 * 8 + j];
            const real D_34 = p[30 * 8 + j];
            const real D_33 = p[29 * 8 + j];
            const real preload_2 = p[2 * 8 + j];
            const real t6 = preload_2 + ed_0 * D_13 + ed_1 * D_23 + ed_2 * D_33 + ed_3 * D_34;
            const real S_35 = p[16 * 8 + j];
            const real S_34 = p[15 * 8 + j];
            const real S_33 = p[14 * 8 + j];
            const real t7 = e_0 * S_13 + e_1 * S_23 + e_2 * S_33 + e_3 * S_34 + e_4 * S_35;
            const real t8 = ed_4 * D_35 + t6 + t7;
            sigma[2 * 8 + j] = t8;
            const real D_45 = p[33 * 8 + j];
            const real D_44 = p[32 * 8 + j];
            const real preload_3 = p[3 * 8 + j];
            const real t9 = preload_3 + ed_0 * D_14 + ed_1 * D_24 + ed_2 * D_34 + ed_3 * D_44;
            const real S_45 = p[18 * 8 + j];
            const real S_44 = p[17 * 8 + j];
            const real t10 = e_0 * S_14 + e_1 * S_24 + e_2 * S_34 + e_3 * S_44 + e_4 * S_45;
            const real t11 = ed_4 * D_45 + t9 + t10;
            sigma[3 * 8 + j] = t11;
            const real D_55 = p[34 * 8 + j];
            const real preload_4 = p[4 * 8 + j];
            const real t12 = preload_4 + ed_0 * D_15 + ed_1 * D_25 + ed_2 * D_35 + ed_3 * D_45;
            const real S_55 = p[19 * 8 + j];
            const real t13 = e_0 * S_15 + e_1 * S_25 + e_2 * S_35 + e_3 * S_45 + e_4 * S_55;
            const real t14 = ed_4 * D_55 + t12 + t13;
            sigma[4 * 8 + j] = t14;
            const real t15 = preload_3 + 0.5 * t10;
            const real t16 = preload_4 + 0.5 * t13;
            const real t17 = preload_2 + 0.5 * t7;
            const real t18 = preload_1 + 0.5 * t4;
            const real t19 = preload_0 + 0.5 * t1;
            U[0 * 8 + j] = e_1 * t18 + e_0 * t19 + e_2 * t17 + e_4 * t16 + e_3 * t15;
            const real t20 = ed_4 * (t14 - t16) + ed_3 * (t11 - t15) + ed_2 * (t8 - t17);
            const real t21 = ed_0 * S_12 + ed_1 * S_22 + ed_2 * S_23 + ed_3 * S_24 + ed_4 * S_25;
            const real t22 = ed_0 * S_11 + ed_1 * S_12 + ed_2 * S_13 + ed_3 * S_14 + ed_4 * S_15;
            const real t23 = ed_0 * S_13 + ed_1 * S_23 + ed_2 * S_33 + ed_3 * S_34 + ed_4 * S_35;
            const real t24 = ed_0 * S_15 + ed_1 * S_25 + ed_2 * S_35 + ed_3 * S_45 + ed_4 * S_55;
            const real t25 = ed_0 * S_14 + ed_1 * S_24 + ed_2 * S_34 + ed_3 * S_44 + ed_4 * S_45;
            const real t26 = e_4 * t24 + e_3 * t25 + e_2 * t23 + e_0 * t22 + e_1 * t21;
            P[0 * 8 + j] = ed_0 * (t2 - t19) + t20 + ed_1 * (t5 - t18) - 0.5 * t26;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (5), ed (5), s (0), z (0), t (1), p (35)
 * out: J (5,10) */
FLEXEL_CLONES
static void linear_5_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (35 * 8);
        real *restrict J = out[0] + b * (50 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[5 * 8 + j];
            J[0 * 8 + j] = S_11; /* J(0,0) */
            const real S_12 = p[6 * 8 + j];
            J[1 * 8 + j] = J[10 * 8 + j] = S_12; /* J(0,1) J(1,0) */
            const real S_13 = p[7 * 8 + j];
            J[2 * 8 + j] = J[20 * 8 + j] = S_13; /* J(0,2) J(2,0) */
            const real S_14 = p[8 * 8 + j];
            J[3 * 8 + j] = J[30 * 8 + j] = S_14; /* J(0,3) J(3,0) */
            const real S_15 = p[9 * 8 + j];
            J[4 * 8 + j] = J[40 * 8 + j] = S_15; /* J(0,4) J(4,0) */
            const real D_11 = p[20 * 8 + j];
            J[5 * 8 + j] = D_11; /* J(0,5) */
            const real D_12 = p[21 * 8 + j];
            J[6 * 8 + j] = J[15 * 8 + j] = D_12; /* J(0,6) J(1,5) */
            const real D_13 = p[22 * 8 + j];
            J[7 * 8 + j] = J[25 * 8 + j] = D_13; /* J(0,7) J(2,5) */
            const real D_14 = p[23 * 8 + j];
            J[8 * 8 + j] = J[35 * 8 + j] = D_14; /* J(0,8) J(3,5) */
            const real D_15 = p[24 * 8 + j];
            J[9 * 8 + j] = J[45 * 8 + j] = D_15; /* J(0,9) J(4,5) */
            const real S_22 = p[10 * 8 + j];
            J[11 * 8 + j] = S_22; /* J(1,1) */
            const real S_23 = p[11 * 8 + j];
            J[12 * 8 + j] = J[21 * 8 + j] = S_23; /* J(1,2) J(2,1) */
            const real S_24 = p[12 * 8 + j];
            J[13 * 8 + j] = J[31 * 8 + j] = S_24; /* J(1,3) J(3,1) */
            const real S_25 = p[13 * 8 + j];
            J[14 * 8 + j] = J[41 * 8 + j] = S_25; /* J(1,4) J(4,1) */
            const real D_22 = p[25 * 8 + j];
            J[16 * 8 + j] = D_22; /* J(1,6) */
            const real D_23 = p[26 * 8 + j];
            J[17 * 8 + j] = J[26 * 8 + j] = D_23; /* J(1,7) J(2,6) */
            const real D_24 = p[27 * 8 + j];
            J[18 * 8 + j] = J[36 * 8 + j] = D_24; /* J(1,8) J(3,6) */
            const real D_25 = p[28 * 8 + j];
            J[19 * 8 + j] = J[46 * 8 + j] = D_25; /* J(1,9) J(4,6) */
            const real S_33 = p[14 * 8 + j];
            J[22 * 8 + j] = S_33; /* J(2,2) */
            const real S_34 = p[15 * 8 + j];
            J[23 * 8 + j] = J[32 * 8 + j] = S_34; /* J(2,3) J(3,2) */
            const real S_35 = p[16 * 8 + j];
            J[24 * 8 + j] = J[42 * 8 + j] = S_35; /* J(2,4) J(4,2) */
            const real D_33 = p[29 * 8 + j];
            J[27 * 8 + j] = D_33; /* J(2,7) */
            const real D_34 = p[30 * 8 + j];
            J[28 * 8 + j] = J[37 * 8 + j] = D_34; /* J(2,8) J(3,7) */
            const real D_35 = p[31 * 8 + j];
            J[29 * 8 + j] = J[47 * 8 + j] = D_35; /* J(2,9) J(4,7) */
            const real S_44 = p[17 * 8 + j];
            J[33 * 8 + j] = S_44; /* J(3,3) */
            const real S_45 = p[18 * 8 + j];
            J[34 * 8 + j] = J[43 * 8 + j] = S_45; /* J(3,4) J(4,3) */
            const real D_44 = p[32 * 8 + j];
            J[38 * 8 + j] = D_44; /* J(3,8) */
            const real D_45 = p[33 * 8 + j];
            J[39 * 8 + j] = J[48 * 8 + j] = D_45; /* J(3,9) J(4,8) */
            const real S_55 = p[19 * 8 + j];
            J[44 * 8 + j] = S_55; /* J(4,4) */
            const real D_55 = p[34 * 8 + j];
            J[49 * 8 + j] = D_55; /* J(4,9) */
        }
    }
}

const flexel_law flexel_law_linear_5 = {
    .name = "linear_5",
    .digest = "c9cb37880850cb4e",
    .m = 5,
    .k = 0,
    .nz = 0,
    .np = 35,
    .law = linear_5_law,
    .tangent = linear_5_tangent,
};

/* linear_6
 *
 * sigma = preload + S e + D ed
 * energy = preload.e + e.S e/2
 *
 * Source: Kelvin-Voigt model
 *
 * 6 deformations, 0 slips
 * p (48):
 *   preload (6) [N or N m]: stress at zero deformation
 *   S (21) [N/m or N m]: stiffness, upper triangle, row by row
 *   D (21) [N s/m or N m s]: damping, upper triangle, row by row */

/* law: 263 operations.
 * in:  e (6), ed (6), s (0), z (0), t (1), p (48)
 * out: sigma (6), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void linear_6_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (6 * 8);
        const real *restrict ed = in[1] + b * (6 * 8);
        const real *restrict p = in[5] + b * (48 * 8);
        real *restrict sigma = out[0] + b * (6 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_5 = ed[5 * 8 + j];
            const real D_16 = p[32 * 8 + j];
            const real ed_4 = ed[4 * 8 + j];
            const real D_15 = p[31 * 8 + j];
            const real ed_3 = ed[3 * 8 + j];
            const real D_14 = p[30 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[29 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[28 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[27 * 8 + j];
            const real preload_0 = p[0 * 8 + j];
            const real t0 = preload_0 + ed_0 * D_11 + ed_1 * D_12 + ed_2 * D_13 + ed_3 * D_14;
            const real e_5 = e[5 * 8 + j];
            const real S_16 = p[11 * 8 + j];
            const real e_4 = e[4 * 8 + j];
            const real S_15 = p[10 * 8 + j];
            const real e_3 = e[3 * 8 + j];
            const real S_14 = p[9 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[8 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[6 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[7 * 8 + j];
            const real t1 = e_0 * S_11 + e_1 * S_12 + e_2 * S_13 + e_3 * S_14 + e_4 * S_15;
            const real t2 = e_5 * S_16 + t1;
            const real t3 = ed_4 * D_15 + t0 + ed_5 * D_16 + t2;
            sigma[0 * 8 + j] = t3;
            const real D_26 = p[37 * 8 + j];
            const real D_25 = p[36 * 8 + j];
            const real D_24 = p[35 * 8 + j];
            const real D_23 = p[34 * 8 + j];
            const real D_22 = p[33 * 8 + j];
            const real preload_1 = p[1 * 8 + j];
            const real t4 = preload_1 + ed_0 * D_12 + ed_1 * D_22 + ed_2 * D_23 + ed_3 * D_24;
            const real S_26 = p[16 * 8 + j];
            const real S_25 = p[15 * 8 + j];
            const real S_24 = p[14 * 8 + j];
            const real S_23 = p[13 * 8 + j];
            const real S_22 = p[12 * 8 + j];
            const real t5 = e_0 * S_12 + e_1 * S_22 + e_2 * S_23 + e_3 * S_24 + e_4 * S_25;
            const real t6 = e_5 * S_26 + t5;
            const real t7 = ed_4 * D_25 + t4 + ed_5 * D_26 + t6;
            sigma[1 * 8 + j] = t7;
            const real D_36 = p[41 * 8 + j];
            const real D_35 = p[40 * 8 + j];
            const real D_34 = p[39 * 8 + j];
            const real D_33 = p[38 * 8 + j];
            const real preload_2 = p[2 * 8 + j];
            const real t8 = preload_2 + ed_0 * D_13 + ed_1 * D_23 + ed_2 * D_33 + ed_3 * D_34;
            const real S_36 = p[20 * 8 + j];
            const real S_35 = p[19 * 8 + j];
            const real S_34 = p[18 * 8 + j];
            const real S_33 = p[17 * 8 + j];
            const real t9 = e_0 * S_13 + e_1 * S_23 + e_2 * S_33 + e_3 * S_34 + e_4 * S_35;
            const real t10 = e_5 * S_36 + t9;
            const real t11 = ed_4 * D_35 + t8 + ed_5 * D_36 + t10;
            sigma[2 * 8 + j] = t11;
            const real D_46 = p[44 * 8 + j];
            const real D_45 = p[43 * 8 + j];
            const real D_44 = p[42 * 8 + j];
            const real preload_3 = p[3 * 8 + j];
            const real t12 = preload_3 + ed_0 * D_14 + ed_1 * D_24 + ed_2 * D_34 + ed_3 * D_44;
            const real S_46 = p[23 * 8 + j];
            const real S_45 = p[22 * 8 + j];
            const real S_44 = p[21 * 8 + j];
            const real t13 = e_0 * S_14 + e_1 * S_24 + e_2 * S_34 + e_3 * S_44 + e_4 * S_45;
            const real t14 = e_5 * S_46 + t13;
            const real t15 = ed_4 * D_45 + t12 + ed_5 * D_46 + t14;
            sigma[3 * 8 + j] = t15;
            const real D_56 = p[46 * 8 + j];
            const real D_55 = p[45 * 8 + j];
            const real preload_4 = p[4 * 8 + j];
            const real t16 = preload_4 + ed_0 * D_15 + ed_1 * D_25 + ed_2 * D_35 + ed_3 * D_45;
            const real S_56 = p[25 * 8 + j];
            const real S_55 = p[24 * 8 + j];
            const real t17 = e_0 * S_15 + e_1 * S_25 + e_2 * S_35 + e_3 * S_45 + e_4 * S_55;
            const real t18 = e_5 * S_56 + t17;
            const real t19 = ed_4 * D_55 + t16 + ed_5 * D_56 + t18;
            sigma[4 * 8 + j] = t19;
            const real D_66 = p[47 * 8 + j];
            const real preload_5 = p[5 * 8 + j];
            const real t20 = preload_5 + ed_0 * D_16 + ed_1 * D_26 + ed_2 * D_36 + ed_3 * D_46;
            const real S_66 = p[26 * 8 + j];
            const real t21 = e_0 * S_16 + e_1 * S_26 + e_2 * S_36 + e_3 * S_46 + e_4 * S_56;
            const real t22 = e_5 * S_66 + t21;
            const real t23 = ed_4 * D_56 + t20 + ed_5 * D_66 + t22;
            sigma[5 * 8 + j] = t23;
            const real t24 = preload_4 + 0.5 * t18;
            const real t25 = preload_5 + 0.5 * t22;
            const real t26 = preload_3 + 0.5 * t14;
            const real t27 = preload_2 + 0.5 * t10;
            const real t28 = preload_1 + 0.5 * t6;
            const real t29 = preload_0 + 0.5 * t2;
            const real t30 = e_1 * t28 + e_0 * t29 + e_2 * t27 + e_3 * t26 + e_5 * t25;
            U[0 * 8 + j] = e_4 * t24 + t30;
            const real t31 = ed_5 * (t23 - t25) + ed_4 * (t19 - t24) + ed_3 * (t15 - t26);
            const real t32 = ed_2 * (t11 - t27) + t31 + ed_0 * (t3 - t29) + ed_1 * (t7 - t28);
            const real t33 = ed_0 * S_12 + ed_1 * S_22 + ed_2 * S_23 + ed_3 * S_24 + ed_4 * S_25;
            const real t34 = ed_0 * S_11 + ed_1 * S_12 + ed_2 * S_13 + ed_3 * S_14 + ed_4 * S_15;
            const real t35 = ed_0 * S_13 + ed_1 * S_23 + ed_2 * S_33 + ed_3 * S_34 + ed_4 * S_35;
            const real t36 = ed_0 * S_14 + ed_1 * S_24 + ed_2 * S_34 + ed_3 * S_44 + ed_4 * S_45;
            const real t37 = ed_0 * S_16 + ed_1 * S_26 + ed_2 * S_36 + ed_3 * S_46 + ed_4 * S_56;
            const real t38 = ed_0 * S_15 + ed_1 * S_25 + ed_2 * S_35 + ed_3 * S_45 + ed_4 * S_55;
            const real t39 = e_5 * (ed_5 * S_66 + t37) + e_4 * (ed_5 * S_56 + t38) + e_3 * (ed_5 * S_46 + t36);
            const real t40 = e_2 * (ed_5 * S_36 + t35) + t39 + e_0 * (ed_5 * S_16 + t34);
            P[0 * 8 + j] = t32 - 0.5 * (e_1 * (ed_5 * S_26 + t33) + t40);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (6), ed (6), s (0), z (0), t (1), p (48)
 * out: J (6,12) */
FLEXEL_CLONES
static void linear_6_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (48 * 8);
        real *restrict J = out[0] + b * (72 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[6 * 8 + j];
            J[0 * 8 + j] = S_11; /* J(0,0) */
            const real S_12 = p[7 * 8 + j];
            J[1 * 8 + j] = J[12 * 8 + j] = S_12; /* J(0,1) J(1,0) */
            const real S_13 = p[8 * 8 + j];
            J[2 * 8 + j] = J[24 * 8 + j] = S_13; /* J(0,2) J(2,0) */
            const real S_14 = p[9 * 8 + j];
            J[3 * 8 + j] = J[36 * 8 + j] = S_14; /* J(0,3) J(3,0) */
            const real S_15 = p[10 * 8 + j];
            J[4 * 8 + j] = J[48 * 8 + j] = S_15; /* J(0,4) J(4,0) */
            const real S_16 = p[11 * 8 + j];
            J[5 * 8 + j] = J[60 * 8 + j] = S_16; /* J(0,5) J(5,0) */
            const real D_11 = p[27 * 8 + j];
            J[6 * 8 + j] = D_11; /* J(0,6) */
            const real D_12 = p[28 * 8 + j];
            J[7 * 8 + j] = J[18 * 8 + j] = D_12; /* J(0,7) J(1,6) */
            const real D_13 = p[29 * 8 + j];
            J[8 * 8 + j] = J[30 * 8 + j] = D_13; /* J(0,8) J(2,6) */
            const real D_14 = p[30 * 8 + j];
            J[9 * 8 + j] = J[42 * 8 + j] = D_14; /* J(0,9) J(3,6) */
            const real D_15 = p[31 * 8 + j];
            J[10 * 8 + j] = J[54 * 8 + j] = D_15; /* J(0,10) J(4,6) */
            const real D_16 = p[32 * 8 + j];
            J[11 * 8 + j] = J[66 * 8 + j] = D_16; /* J(0,11) J(5,6) */
            const real S_22 = p[12 * 8 + j];
            J[13 * 8 + j] = S_22; /* J(1,1) */
            const real S_23 = p[13 * 8 + j];
            J[14 * 8 + j] = J[25 * 8 + j] = S_23; /* J(1,2) J(2,1) */
            const real S_24 = p[14 * 8 + j];
            J[15 * 8 + j] = J[37 * 8 + j] = S_24; /* J(1,3) J(3,1) */
            const real S_25 = p[15 * 8 + j];
            J[16 * 8 + j] = J[49 * 8 + j] = S_25; /* J(1,4) J(4,1) */
            const real S_26 = p[16 * 8 + j];
            J[17 * 8 + j] = J[61 * 8 + j] = S_26; /* J(1,5) J(5,1) */
            const real D_22 = p[33 * 8 + j];
            J[19 * 8 + j] = D_22; /* J(1,7) */
            const real D_23 = p[34 * 8 + j];
            J[20 * 8 + j] = J[31 * 8 + j] = D_23; /* J(1,8) J(2,7) */
            const real D_24 = p[35 * 8 + j];
            J[21 * 8 + j] = J[43 * 8 + j] = D_24; /* J(1,9) J(3,7) */
            const real D_25 = p[36 * 8 + j];
            J[22 * 8 + j] = J[55 * 8 + j] = D_25; /* J(1,10) J(4,7) */
            const real D_26 = p[37 * 8 + j];
            J[23 * 8 + j] = J[67 * 8 + j] = D_26; /* J(1,11) J(5,7) */
            const real S_33 = p[17 * 8 + j];
            J[26 * 8 + j] = S_33; /* J(2,2) */
            const real S_34 = p[18 * 8 + j];
            J[27 * 8 + j] = J[38 * 8 + j] = S_34; /* J(2,3) J(3,2) */
            const real S_35 = p[19 * 8 + j];
            J[28 * 8 + j] = J[50 * 8 + j] = S_35; /* J(2,4) J(4,2) */
            const real S_36 = p[20 * 8 + j];
            J[29 * 8 + j] = J[62 * 8 + j] = S_36; /* J(2,5) J(5,2) */
            const real D_33 = p[38 * 8 + j];
            J[32 * 8 + j] = D_33; /* J(2,8) */
            const real D_34 = p[39 * 8 + j];
            J[33 * 8 + j] = J[44 * 8 + j] = D_34; /* J(2,9) J(3,8) */
            const real D_35 = p[40 * 8 + j];
            J[34 * 8 + j] = J[56 * 8 + j] = D_35; /* J(2,10) J(4,8) */
            const real D_36 = p[41 * 8 + j];
            J[35 * 8 + j] = J[68 * 8 + j] = D_36; /* J(2,11) J(5,8) */
            const real S_44 = p[21 * 8 + j];
            J[39 * 8 + j] = S_44; /* J(3,3) */
            const real S_45 = p[22 * 8 + j];
            J[40 * 8 + j] = J[51 * 8 + j] = S_45; /* J(3,4) J(4,3) */
            const real S_46 = p[23 * 8 + j];
            J[41 * 8 + j] = J[63 * 8 + j] = S_46; /* J(3,5) J(5,3) */
            const real D_44 = p[42 * 8 + j];
            J[45 * 8 + j] = D_44; /* J(3,9) */
            const real D_45 = p[43 * 8 + j];
            J[46 * 8 + j] = J[57 * 8 + j] = D_45; /* J(3,10) J(4,9) */
            const real D_46 = p[44 * 8 + j];
            J[47 * 8 + j] = J[69 * 8 + j] = D_46; /* J(3,11) J(5,9) */
            const real S_55 = p[24 * 8 + j];
            J[52 * 8 + j] = S_55; /* J(4,4) */
            const real S_56 = p[25 * 8 + j];
            J[53 * 8 + j] = J[64 * 8 + j] = S_56; /* J(4,5) J(5,4) */
            const real D_55 = p[45 * 8 + j];
            J[58 * 8 + j] = D_55; /* J(4,10) */
            const real D_56 = p[46 * 8 + j];
            J[59 * 8 + j] = J[70 * 8 + j] = D_56; /* J(4,11) J(5,10) */
            const real S_66 = p[26 * 8 + j];
            J[65 * 8 + j] = S_66; /* J(5,5) */
            const real D_66 = p[47 * 8 + j];
            J[71 * 8 + j] = D_66; /* J(5,11) */
        }
    }
}

const flexel_law flexel_law_linear_6 = {
    .name = "linear_6",
    .digest = "c9cb37880850cb4e",
    .m = 6,
    .k = 0,
    .nz = 0,
    .np = 48,
    .law = linear_6_law,
    .tangent = linear_6_tangent,
};

/* viscous_1
 *
 * tau = C s
 *
 * Source: linear viscous model
 *
 * 0 deformations, 1 slips
 * p (1):
 *   C (1) [N s/m or N m s]: viscosity, upper triangle, row by row */

/* law: 2 operations.
 * in:  e (0), ed (0), s (1), z (0), t (1), p (1)
 * out: sigma (0), tau (1), zd (0), U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void viscous_1_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict p = in[5] + b * (1 * 8);
        real *restrict tau = out[1] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_0 = s[0 * 8 + j];
            const real C = p[0 * 8 + j];
            const real t0 = s_0 * C;
            tau[0 * 8 + j] = t0;
            P[0 * 8 + j] = s_0 * t0;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (1), z (0), t (1), p (1)
 * out: J (1,1) */
FLEXEL_CLONES
static void viscous_1_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (1 * 8);
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real C = p[0 * 8 + j];
            J[0 * 8 + j] = C; /* J(0,0) */
        }
    }
}

const flexel_law flexel_law_viscous_1 = {
    .name = "viscous_1",
    .digest = "c9cb37880850cb4e",
    .m = 0,
    .k = 1,
    .nz = 0,
    .np = 1,
    .law = viscous_1_law,
    .tangent = viscous_1_tangent,
};

/* viscous_2
 *
 * tau = C s
 *
 * Source: linear viscous model
 *
 * 0 deformations, 2 slips
 * p (3):
 *   C (3) [N s/m or N m s]: viscosity, upper triangle, row by row */

/* law: 9 operations.
 * in:  e (0), ed (0), s (2), z (0), t (1), p (3)
 * out: sigma (0), tau (2), zd (0), U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void viscous_2_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (2 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict tau = out[1] + b * (2 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_0 = s[0 * 8 + j];
            const real C_11 = p[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real C_12 = p[1 * 8 + j];
            const real t0 = s_0 * C_11 + s_1 * C_12;
            tau[0 * 8 + j] = t0;
            const real C_22 = p[2 * 8 + j];
            const real t1 = s_0 * C_12 + s_1 * C_22;
            tau[1 * 8 + j] = t1;
            P[0 * 8 + j] = s_0 * t0 + s_1 * t1;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (2), z (0), t (1), p (3)
 * out: J (2,2) */
FLEXEL_CLONES
static void viscous_2_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict J = out[0] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real C_11 = p[0 * 8 + j];
            J[0 * 8 + j] = C_11; /* J(0,0) */
            const real C_12 = p[1 * 8 + j];
            J[1 * 8 + j] = J[2 * 8 + j] = C_12; /* J(0,1) J(1,0) */
            const real C_22 = p[2 * 8 + j];
            J[3 * 8 + j] = C_22; /* J(1,1) */
        }
    }
}

const flexel_law flexel_law_viscous_2 = {
    .name = "viscous_2",
    .digest = "c9cb37880850cb4e",
    .m = 0,
    .k = 2,
    .nz = 0,
    .np = 3,
    .law = viscous_2_law,
    .tangent = viscous_2_tangent,
};

/* viscous_3
 *
 * tau = C s
 *
 * Source: linear viscous model
 *
 * 0 deformations, 3 slips
 * p (6):
 *   C (6) [N s/m or N m s]: viscosity, upper triangle, row by row */

/* law: 20 operations.
 * in:  e (0), ed (0), s (3), z (0), t (1), p (6)
 * out: sigma (0), tau (3), zd (0), U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void viscous_3_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (3 * 8);
        const real *restrict p = in[5] + b * (6 * 8);
        real *restrict tau = out[1] + b * (3 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_2 = s[2 * 8 + j];
            const real C_13 = p[2 * 8 + j];
            const real s_0 = s[0 * 8 + j];
            const real C_11 = p[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real C_12 = p[1 * 8 + j];
            const real t0 = s_0 * C_11 + s_1 * C_12 + s_2 * C_13;
            tau[0 * 8 + j] = t0;
            const real C_23 = p[4 * 8 + j];
            const real C_22 = p[3 * 8 + j];
            const real t1 = s_0 * C_12 + s_1 * C_22 + s_2 * C_23;
            tau[1 * 8 + j] = t1;
            const real C_33 = p[5 * 8 + j];
            const real t2 = s_0 * C_13 + s_1 * C_23 + s_2 * C_33;
            tau[2 * 8 + j] = t2;
            P[0 * 8 + j] = s_0 * t0 + s_1 * t1 + s_2 * t2;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (3), z (0), t (1), p (6)
 * out: J (3,3) */
FLEXEL_CLONES
static void viscous_3_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (6 * 8);
        real *restrict J = out[0] + b * (9 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real C_11 = p[0 * 8 + j];
            J[0 * 8 + j] = C_11; /* J(0,0) */
            const real C_12 = p[1 * 8 + j];
            J[1 * 8 + j] = J[3 * 8 + j] = C_12; /* J(0,1) J(1,0) */
            const real C_13 = p[2 * 8 + j];
            J[2 * 8 + j] = J[6 * 8 + j] = C_13; /* J(0,2) J(2,0) */
            const real C_22 = p[3 * 8 + j];
            J[4 * 8 + j] = C_22; /* J(1,1) */
            const real C_23 = p[4 * 8 + j];
            J[5 * 8 + j] = J[7 * 8 + j] = C_23; /* J(1,2) J(2,1) */
            const real C_33 = p[5 * 8 + j];
            J[8 * 8 + j] = C_33; /* J(2,2) */
        }
    }
}

const flexel_law flexel_law_viscous_3 = {
    .name = "viscous_3",
    .digest = "c9cb37880850cb4e",
    .m = 0,
    .k = 3,
    .nz = 0,
    .np = 6,
    .law = viscous_3_law,
    .tangent = viscous_3_tangent,
};

/* beam_extension
 *
 * sigma = EA/l0 (e - initial_strain l0 + damping ed),  e: the beam's elongation
 * energy = EA/l0 e (e/2 - initial_strain l0)
 *
 * Source: theory of beams; Kelvin-Voigt damping
 *
 * 1 deformations, 0 slips
 * p (4):
 *   l0 (1) [m]: undeformed length
 *   EA (1) [N]: axial stiffness
 *   initial_strain (1) [1]: elongation per length of the unstressed beam
 *   damping (1) [s]: ratio of damping to stiffness */

/* law: 15 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (4)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void beam_extension_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real EA = p[1 * 8 + j];
            const real k = 1.0 / l0 * EA;
            const real ed_0 = ed[0 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real initial_strain = p[2 * 8 + j];
            const real t0 = l0 * initial_strain;
            const real t1 = k * (e_0 + ed_0 * damping - t0);
            sigma[0 * 8 + j] = t1;
            const real t2 = 0.5 * e_0;
            const real t3 = t2 - t0;
            U[0 * 8 + j] = e_0 * t3 * k;
            P[0 * 8 + j] = ed_0 * (t1 - k * (t2 + t3));
        }
    }
}

/* tangent: 3 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (4)
 * out: J (1,2) */
FLEXEL_CLONES
static void beam_extension_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict J = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real EA = p[1 * 8 + j];
            const real k = 1.0 / l0 * EA;
            J[0 * 8 + j] = k; /* J(0,0) */
            const real damping = p[3 * 8 + j];
            J[1 * 8 + j] = damping * k; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_beam_extension = {
    .name = "beam_extension",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 4,
    .law = beam_extension_law,
    .tangent = beam_extension_tangent,
};

/* beam_torsion
 *
 * sigma = GJ/l0^3 (e - initial_twist l0^2 + damping ed),  e: l0 times the angle of twist
 * energy = GJ/l0^3 e (e/2 - initial_twist l0^2)
 *
 * Source: theory of beams; Kelvin-Voigt damping
 *
 * 1 deformations, 0 slips
 * p (4):
 *   l0 (1) [m]: undeformed length
 *   GJ (1) [N m^2]: torsional stiffness
 *   initial_twist (1) [1/m]: twist of the unstressed beam
 *   damping (1) [s]: ratio of damping to stiffness */

/* law: 18 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (4)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void beam_torsion_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real GJ = p[1 * 8 + j];
            const real k = t0 * t0 * GJ * t0;
            const real ed_0 = ed[0 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real initial_twist = p[2 * 8 + j];
            const real t1 = l0 * l0 * initial_twist;
            const real t2 = k * (e_0 + ed_0 * damping - t1);
            sigma[0 * 8 + j] = t2;
            const real t3 = 0.5 * e_0;
            const real t4 = t3 - t1;
            U[0 * 8 + j] = e_0 * t4 * k;
            P[0 * 8 + j] = ed_0 * (t2 - k * (t3 + t4));
        }
    }
}

/* tangent: 5 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (4)
 * out: J (1,2) */
FLEXEL_CLONES
static void beam_torsion_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict J = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real GJ = p[1 * 8 + j];
            const real k = t0 * t0 * t0 * GJ;
            J[0 * 8 + j] = k; /* J(0,0) */
            const real damping = p[3 * 8 + j];
            J[1 * 8 + j] = damping * k; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_beam_torsion = {
    .name = "beam_torsion",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 4,
    .law = beam_torsion_law,
    .tangent = beam_torsion_tangent,
};

/* beam_bending
 *
 * e_0, e_1: the beam's two deformations of bending in one plane, at p and at q
 * P = 0,  k = EI/((1 + P) l0^3),  r = initial_curvature l0^2/2,  d_i = e_i - r + damping ed_i
 * sigma = k ((4 + P) d_0 + (P - 2) d_1, (P - 2) d_0 + (4 + P) d_1)
 * energy: the same form of e_i - r, less its value at e_i = 0
 *
 * Source: Przemieniecki 1968, Theory of matrix structural analysis; Kelvin-Voigt damping
 *
 * 2 deformations, 0 slips
 * p (4):
 *   l0 (1) [m]: undeformed length
 *   EI (1) [N m^2]: bending stiffness
 *   initial_curvature (1) [1/m]: curvature of the unstressed beam
 *   damping (1) [s]: ratio of damping to stiffness */

/* law: 46 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (4)
 * out: sigma (2), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void beam_bending_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict sigma = out[0] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real EI = p[1 * 8 + j];
            const real k = EI * t0 * t0 * t0;
            const real ed_0 = ed[0 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real initial_curvature = p[2 * 8 + j];
            const real t1 = l0 * initial_curvature * l0;
            const real relaxed = 0.5 * t1;
            const real t2 = e_0 + ed_0 * damping - relaxed;
            const real ed_1 = ed[1 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real t3 = e_1 + ed_1 * damping - relaxed;
            const real t4 = k * (4.0 * t2 - 2.0 * t3);
            sigma[0 * 8 + j] = t4;
            const real t5 = k * (4.0 * t3 - 2.0 * t2);
            sigma[1 * 8 + j] = t5;
            const real t6 = e_0 - t1;
            const real t7 = e_1 - t1;
            const real t8 = k * (2.0 * t6 - t7);
            const real t9 = k * (2.0 * t7 - t6);
            U[0 * 8 + j] = e_0 * t8 + e_1 * t9;
            const real t10 = k * (e_0 * (2.0 * ed_0 - ed_1) + e_1 * (2.0 * ed_1 - ed_0));
            P[0 * 8 + j] = ed_0 * (t4 - t8) + ed_1 * (t5 - t9) - t10;
        }
    }
}

/* tangent: 11 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (4)
 * out: J (2,4) */
FLEXEL_CLONES
static void beam_bending_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict J = out[0] + b * (8 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real EI = p[1 * 8 + j];
            const real k = t0 * t0 * t0 * EI;
            J[0 * 8 + j] = J[5 * 8 + j] = 4.0 * k; /* J(0,0) J(1,1) */
            J[1 * 8 + j] = J[4 * 8 + j] = -(2.0 * k); /* J(0,1) J(1,0) */
            const real damping = p[3 * 8 + j];
            const real t1 = damping * k;
            J[2 * 8 + j] = J[7 * 8 + j] = 4.0 * t1; /* J(0,2) J(1,3) */
            J[3 * 8 + j] = J[6 * 8 + j] = -(2.0 * t1); /* J(0,3) J(1,2) */
        }
    }
}

const flexel_law flexel_law_beam_bending = {
    .name = "beam_bending",
    .digest = "c9cb37880850cb4e",
    .m = 2,
    .k = 0,
    .nz = 0,
    .np = 4,
    .law = beam_bending_law,
    .tangent = beam_bending_tangent,
};

/* beam_shear_bending
 *
 * e_0, e_1: the beam's two deformations of bending in one plane, at p and at q
 * P = 12 EI/(GA l0^2),  k = EI/((1 + P) l0^3),  r = initial_curvature l0^2/2,  d_i = e_i - r + damping ed_i
 * sigma = k ((4 + P) d_0 + (P - 2) d_1, (P - 2) d_0 + (4 + P) d_1)
 * energy: the same form of e_i - r, less its value at e_i = 0
 *
 * Source: Przemieniecki 1968, Theory of matrix structural analysis; Kelvin-Voigt damping
 *
 * 2 deformations, 0 slips
 * p (5):
 *   l0 (1) [m]: undeformed length
 *   EI (1) [N m^2]: bending stiffness
 *   GA (1) [N]: shear stiffness k G A
 *   initial_curvature (1) [1/m]: curvature of the unstressed beam
 *   damping (1) [s]: ratio of damping to stiffness */

/* law: 60 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (5)
 * out: sigma (2), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void beam_shear_bending_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict sigma = out[0] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = t0 * t0;
            const real GA = p[2 * 8 + j];
            const real EI = p[1 * 8 + j];
            const real P_ = 12.0 * (1.0 / GA * EI * t1);
            const real k = 1.0 / (1.0 + P_) * (t0 * t1 * EI);
            const real t2 = k * (P_ - 2.0);
            const real ed_1 = ed[1 * 8 + j];
            const real damping = p[4 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real initial_curvature = p[3 * 8 + j];
            const real t3 = l0 * l0 * initial_curvature;
            const real relaxed = 0.5 * t3;
            const real t4 = e_1 + ed_1 * damping - relaxed;
            const real t5 = k * (P_ + 4.0);
            const real ed_0 = ed[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real t6 = e_0 + ed_0 * damping - relaxed;
            const real t7 = t2 * t4 + t5 * t6;
            sigma[0 * 8 + j] = t7;
            const real t8 = t2 * t6 + t5 * t4;
            sigma[1 * 8 + j] = t8;
            const real t9 = e_1 - t3;
            const real t10 = e_0 - t3;
            const real t11 = t2 * t9 + t5 * t10;
            const real t12 = t2 * t10 + t5 * t9;
            U[0 * 8 + j] = 0.5 * (e_0 * t11 + e_1 * t12);
            const real t13 = e_0 * (ed_1 * t2 + ed_0 * t5) + e_1 * (ed_0 * t2 + ed_1 * t5);
            P[0 * 8 + j] = ed_0 * (t7 - 0.5 * t11) + ed_1 * (t8 - 0.5 * t12) - 0.5 * t13;
        }
    }
}

/* tangent: 17 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (5)
 * out: J (2,4) */
FLEXEL_CLONES
static void beam_shear_bending_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict J = out[0] + b * (8 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = t0 * t0;
            const real GA = p[2 * 8 + j];
            const real EI = p[1 * 8 + j];
            const real P_ = 12.0 * (1.0 / GA * EI * t1);
            const real k = 1.0 / (1.0 + P_) * (t0 * t1 * EI);
            const real t2 = k * (P_ + 4.0);
            J[0 * 8 + j] = J[5 * 8 + j] = t2; /* J(0,0) J(1,1) */
            const real t3 = k * (P_ - 2.0);
            J[1 * 8 + j] = J[4 * 8 + j] = t3; /* J(0,1) J(1,0) */
            const real damping = p[4 * 8 + j];
            J[2 * 8 + j] = J[7 * 8 + j] = damping * t2; /* J(0,2) J(1,3) */
            J[3 * 8 + j] = J[6 * 8 + j] = damping * t3; /* J(0,3) J(1,2) */
        }
    }
}

const flexel_law flexel_law_beam_shear_bending = {
    .name = "beam_shear_bending",
    .digest = "c9cb37880850cb4e",
    .m = 2,
    .k = 0,
    .nz = 0,
    .np = 5,
    .law = beam_shear_bending_law,
    .tangent = beam_shear_bending_tangent,
};

/* beam_bimoment
 *
 * e_0, e_1: the beam's two deformations of warping, at p and at q;  d_i = e_i + damping ed_i
 * sigma_i = GJ/(30 l0^3) (4 d_i - d_j) + 2 EIw/l0^5 (2 d_i + d_j),  j: the other one
 * energy: the same form of e_i, halved
 *
 * Source: Vlasov 1961, Thin-walled elastic beams
 *
 * 2 deformations, 0 slips
 * p (4):
 *   l0 (1) [m]: undeformed length
 *   GJ (1) [N m^2]: torsional stiffness
 *   EIw (1) [N m^4]: warping stiffness
 *   damping (1) [s]: ratio of damping to stiffness */

/* law: 51 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (4)
 * out: sigma (2), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void beam_bimoment_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict sigma = out[0] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_1 = ed[1 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real t0 = e_1 + ed_1 * damping;
            const real l0 = p[0 * 8 + j];
            const real t1 = 1.0 / l0;
            const real t2 = t1 * t1;
            const real EIw = p[2 * 8 + j];
            const real t3 = t2 * t2 * EIw * t1;
            const real bimoment = 2.0 * t3;
            const real GJ = p[1 * 8 + j];
            const real t4 = GJ * t2 * t1;
            const real twisting = 0.03333333333333333 * t4;
            const real t5 = bimoment - twisting;
            const real ed_0 = ed[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real t6 = e_0 + ed_0 * damping;
            const real t7 = 4.0 * t3 + 0.13333333333333333 * t4;
            const real t8 = t0 * t5 + t6 * t7;
            sigma[0 * 8 + j] = t8;
            const real t9 = t6 * t5 + t0 * t7;
            sigma[1 * 8 + j] = t9;
            const real t10 = e_0 * t7 + e_1 * t5;
            const real t11 = e_0 * t5 + e_1 * t7;
            U[0 * 8 + j] = 0.5 * (e_0 * t10 + e_1 * t11);
            const real t12 = e_0 * (ed_0 * t7 + ed_1 * t5) + e_1 * (ed_0 * t5 + ed_1 * t7);
            P[0 * 8 + j] = ed_0 * (t8 - 0.5 * t10) + ed_1 * (t9 - 0.5 * t11) - 0.5 * t12;
        }
    }
}

/* tangent: 15 operations.
 * in:  e (2), ed (2), s (0), z (0), t (1), p (4)
 * out: J (2,4) */
FLEXEL_CLONES
static void beam_bimoment_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict J = out[0] + b * (8 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real t0 = 1.0 / l0;
            const real t1 = t0 * t0;
            const real EIw = p[2 * 8 + j];
            const real t2 = t1 * t1 * t0 * EIw;
            const real GJ = p[1 * 8 + j];
            const real t3 = t0 * t1 * GJ;
            const real t4 = 4.0 * t2 + 0.13333333333333333 * t3;
            J[0 * 8 + j] = J[5 * 8 + j] = t4; /* J(0,0) J(1,1) */
            const real bimoment = 2.0 * t2;
            const real twisting = 0.03333333333333333 * t3;
            const real t5 = bimoment - twisting;
            J[1 * 8 + j] = J[4 * 8 + j] = t5; /* J(0,1) J(1,0) */
            const real damping = p[3 * 8 + j];
            J[2 * 8 + j] = J[7 * 8 + j] = damping * t4; /* J(0,2) J(1,3) */
            J[3 * 8 + j] = J[6 * 8 + j] = damping * t5; /* J(0,3) J(1,2) */
        }
    }
}

const flexel_law flexel_law_beam_bimoment = {
    .name = "beam_bimoment",
    .digest = "c9cb37880850cb4e",
    .m = 2,
    .k = 0,
    .nz = 0,
    .np = 4,
    .law = beam_bimoment_law,
    .tangent = beam_bimoment_tangent,
};

/* planar_cable_stiffness
 *
 * sigma = EA l0 (1, 1/3, 1/5) (e + damping ed) of the strains,
 * sigma = EI l0 (5, 8, 5)/18 (e + bending_damping ed) of the curvatures at the three points
 * energy = sum of EA l0 (1, 1/3, 1/5) e^2/2 and EI l0 (5, 8, 5)/18 e^2/2
 *
 * Source: Gerstmayr and Shabana 2006, Nonlinear Dyn. 45:109; Kelvin-Voigt damping
 *
 * 6 deformations, 0 slips
 * p (5):
 *   l0 (1) [m]: undeformed length
 *   EA (1) [N]: axial stiffness
 *   EI (1) [N m^2]: bending stiffness
 *   damping (1) [s]: ratio of damping to stiffness of stretching
 *   bending_damping (1) [s]: ratio of damping to stiffness of bending */

/* law: 76 operations.
 * in:  e (6), ed (6), s (0), z (0), t (1), p (5)
 * out: sigma (6), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void planar_cable_stiffness_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (6 * 8);
        const real *restrict ed = in[1] + b * (6 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict sigma = out[0] + b * (6 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real EA = p[1 * 8 + j];
            const real axial = l0 * EA;
            const real ed_0 = ed[0 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real t0 = axial * (e_0 + ed_0 * damping);
            sigma[0 * 8 + j] = t0;
            const real ed_1 = ed[1 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real t1 = axial * (e_1 + ed_1 * damping);
            sigma[1 * 8 + j] = 0.3333333333333333 * t1;
            const real ed_2 = ed[2 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real t2 = axial * (e_2 + ed_2 * damping);
            sigma[2 * 8 + j] = 0.2 * t2;
            const real EI = p[2 * 8 + j];
            const real bending = l0 * EI;
            const real ed_3 = ed[3 * 8 + j];
            const real bending_damping = p[4 * 8 + j];
            const real e_3 = e[3 * 8 + j];
            const real t3 = bending * (e_3 + ed_3 * bending_damping);
            sigma[3 * 8 + j] = 0.2777777777777778 * t3;
            const real ed_4 = ed[4 * 8 + j];
            const real e_4 = e[4 * 8 + j];
            const real t4 = bending * (e_4 + ed_4 * bending_damping);
            sigma[4 * 8 + j] = 0.4444444444444444 * t4;
            const real ed_5 = ed[5 * 8 + j];
            const real e_5 = e[5 * 8 + j];
            const real t5 = bending * (e_5 + ed_5 * bending_damping);
            sigma[5 * 8 + j] = 0.2777777777777778 * t5;
            const real t6 = 0.1388888888888889 * (e_3 * e_3 + e_5 * e_5) + 0.2222222222222222 * (e_4 * e_4);
            const real t7 = 0.5 * e_0 * e_0 + 0.1 * (e_2 * e_2) + 0.16666666666666666 * (e_1 * e_1);
            U[0 * 8 + j] = bending * t6 + axial * t7;
            const real t8 = 0.4444444444444444 * (ed_4 * t4) + 0.2777777777777778 * (ed_3 * t3 + ed_5 * t5);
            const real t9 = 0.2 * (ed_2 * t2) + t8 + ed_0 * t0 + 0.3333333333333333 * (ed_1 * t1);
            const real t10 = e_0 * ed_0 + 0.2 * (e_2 * ed_2) + 0.3333333333333333 * (e_1 * ed_1);
            const real t11 = 0.4444444444444444 * (e_4 * ed_4) + 0.2777777777777778 * (e_3 * ed_3 + e_5 * ed_5);
            P[0 * 8 + j] = t9 - axial * t10 - bending * t11;
        }
    }
}

/* tangent: 12 operations.
 * in:  e (6), ed (6), s (0), z (0), t (1), p (5)
 * out: J (6,12), 12 of 72 entries */
FLEXEL_CLONES
static void planar_cable_stiffness_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict J = out[0] + b * (12 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real EA = p[1 * 8 + j];
            const real axial = l0 * EA;
            J[0 * 8 + j] = axial; /* J(0,0) */
            const real damping = p[3 * 8 + j];
            const real t0 = damping * axial;
            J[1 * 8 + j] = t0; /* J(0,6) */
            J[2 * 8 + j] = 0.3333333333333333 * axial; /* J(1,1) */
            J[3 * 8 + j] = 0.3333333333333333 * t0; /* J(1,7) */
            J[4 * 8 + j] = 0.2 * axial; /* J(2,2) */
            J[5 * 8 + j] = 0.2 * t0; /* J(2,8) */
            const real EI = p[2 * 8 + j];
            const real bending = l0 * EI;
            J[6 * 8 + j] = J[10 * 8 + j] = 0.2777777777777778 * bending; /* J(3,3) J(5,5) */
            const real bending_damping = p[4 * 8 + j];
            const real t1 = bending_damping * bending;
            J[7 * 8 + j] = J[11 * 8 + j] = 0.2777777777777778 * t1; /* J(3,9) J(5,11) */
            J[8 * 8 + j] = 0.4444444444444444 * bending; /* J(4,4) */
            J[9 * 8 + j] = 0.4444444444444444 * t1; /* J(4,10) */
        }
    }
}

const flexel_law flexel_law_planar_cable_stiffness = {
    .name = "planar_cable_stiffness",
    .digest = "c9cb37880850cb4e",
    .m = 6,
    .k = 0,
    .nz = 0,
    .np = 5,
    .law = planar_cable_stiffness_law,
    .tangent = planar_cable_stiffness_tangent,
};

/* cable_stiffness
 *
 * sigma = EA l0 (1, 1/3, 1/5) (e + damping ed) of the strains,
 * sigma = EI l0 (5, 8, 5)/18 (e + bending_damping ed) of the curvatures at the three points
 * energy = sum of EA l0 (1, 1/3, 1/5) e^2/2 and EI l0 (5, 8, 5)/18 e^2/2
 *
 * Source: Gerstmayr and Shabana 2006, Nonlinear Dyn. 45:109; Kelvin-Voigt damping
 *
 * 12 deformations, 0 slips
 * p (5):
 *   l0 (1) [m]: undeformed length
 *   EA (1) [N]: axial stiffness
 *   EI (1) [N m^2]: bending stiffness
 *   damping (1) [s]: ratio of damping to stiffness of stretching
 *   bending_damping (1) [s]: ratio of damping to stiffness of bending */

/* law: 136 operations.
 * in:  e (12), ed (12), s (0), z (0), t (1), p (5)
 * out: sigma (12), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void cable_stiffness_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (12 * 8);
        const real *restrict ed = in[1] + b * (12 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict sigma = out[0] + b * (12 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real EA = p[1 * 8 + j];
            const real axial = l0 * EA;
            const real ed_0 = ed[0 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real t0 = axial * (e_0 + ed_0 * damping);
            sigma[0 * 8 + j] = t0;
            const real ed_1 = ed[1 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real t1 = axial * (e_1 + ed_1 * damping);
            sigma[1 * 8 + j] = 0.3333333333333333 * t1;
            const real ed_2 = ed[2 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real t2 = axial * (e_2 + ed_2 * damping);
            sigma[2 * 8 + j] = 0.2 * t2;
            const real EI = p[2 * 8 + j];
            const real bending = l0 * EI;
            const real ed_3 = ed[3 * 8 + j];
            const real bending_damping = p[4 * 8 + j];
            const real e_3 = e[3 * 8 + j];
            const real t3 = bending * (e_3 + ed_3 * bending_damping);
            sigma[3 * 8 + j] = 0.2777777777777778 * t3;
            const real ed_4 = ed[4 * 8 + j];
            const real e_4 = e[4 * 8 + j];
            const real t4 = bending * (e_4 + ed_4 * bending_damping);
            sigma[4 * 8 + j] = 0.2777777777777778 * t4;
            const real ed_5 = ed[5 * 8 + j];
            const real e_5 = e[5 * 8 + j];
            const real t5 = bending * (e_5 + ed_5 * bending_damping);
            sigma[5 * 8 + j] = 0.2777777777777778 * t5;
            const real ed_6 = ed[6 * 8 + j];
            const real e_6 = e[6 * 8 + j];
            const real t6 = bending * (e_6 + ed_6 * bending_damping);
            sigma[6 * 8 + j] = 0.4444444444444444 * t6;
            const real ed_7 = ed[7 * 8 + j];
            const real e_7 = e[7 * 8 + j];
            const real t7 = bending * (e_7 + ed_7 * bending_damping);
            sigma[7 * 8 + j] = 0.4444444444444444 * t7;
            const real ed_8 = ed[8 * 8 + j];
            const real e_8 = e[8 * 8 + j];
            const real t8 = bending * (e_8 + ed_8 * bending_damping);
            sigma[8 * 8 + j] = 0.4444444444444444 * t8;
            const real ed_9 = ed[9 * 8 + j];
            const real e_9 = e[9 * 8 + j];
            const real t9 = bending * (e_9 + ed_9 * bending_damping);
            sigma[9 * 8 + j] = 0.2777777777777778 * t9;
            const real ed_10 = ed[10 * 8 + j];
            const real e_10 = e[10 * 8 + j];
            const real t10 = bending * (e_10 + ed_10 * bending_damping);
            sigma[10 * 8 + j] = 0.2777777777777778 * t10;
            const real ed_11 = ed[11 * 8 + j];
            const real e_11 = e[11 * 8 + j];
            const real t11 = bending * (e_11 + ed_11 * bending_damping);
            sigma[11 * 8 + j] = 0.2777777777777778 * t11;
            const real t12 = 0.5 * e_0 * e_0 + 0.1 * (e_2 * e_2) + 0.16666666666666666 * (e_1 * e_1);
            const real t13 = e_5 * e_5 + e_9 * e_9 + e_4 * e_4 + e_3 * e_3 + e_10 * e_10;
            const real t14 = 0.1388888888888889 * (e_11 * e_11 + t13) + 0.2222222222222222 * (e_6 * e_6 + e_8 * e_8
                + e_7 * e_7);
            U[0 * 8 + j] = axial * t12 + bending * t14;
            const real t15 = ed_10 * t10 + ed_11 * t11 + ed_9 * t9 + ed_5 * t5 + ed_4 * t4;
            const real t16 = 0.2777777777777778 * (ed_3 * t3 + t15) + 0.4444444444444444 * (ed_7 * t7 + ed_8 * t8
                + ed_6 * t6);
            const real t17 = 0.2 * (ed_2 * t2) + t16 + ed_0 * t0 + 0.3333333333333333 * (ed_1 * t1);
            const real t18 = e_0 * ed_0 + 0.2 * (e_2 * ed_2) + 0.3333333333333333 * (e_1 * ed_1);
            const real t19 = e_5 * ed_5 + e_9 * ed_9 + e_4 * ed_4 + e_3 * ed_3 + e_10 * ed_10;
            const real t20 = 0.4444444444444444 * (e_6 * ed_6 + e_8 * ed_8 + e_7 * ed_7);
            const real t21 = bending * (0.2777777777777778 * (e_11 * ed_11 + t19) + t20);
            P[0 * 8 + j] = t17 - axial * t18 - t21;
        }
    }
}

/* tangent: 12 operations.
 * in:  e (12), ed (12), s (0), z (0), t (1), p (5)
 * out: J (12,24), 24 of 288 entries */
FLEXEL_CLONES
static void cable_stiffness_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict J = out[0] + b * (24 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            const real EA = p[1 * 8 + j];
            const real axial = l0 * EA;
            J[0 * 8 + j] = axial; /* J(0,0) */
            const real damping = p[3 * 8 + j];
            const real t0 = damping * axial;
            J[1 * 8 + j] = t0; /* J(0,12) */
            J[2 * 8 + j] = 0.3333333333333333 * axial; /* J(1,1) */
            J[3 * 8 + j] = 0.3333333333333333 * t0; /* J(1,13) */
            J[4 * 8 + j] = 0.2 * axial; /* J(2,2) */
            J[5 * 8 + j] = 0.2 * t0; /* J(2,14) */
            const real EI = p[2 * 8 + j];
            const real bending = l0 * EI;
            J[6 * 8 + j] = J[8 * 8 + j] = J[10 * 8 + j] = J[18 * 8 + j] = J[20 * 8 + j] = J[22 * 8 + j]
                = 0.2777777777777778 * bending; /* J(3,3) J(4,4) J(5,5) J(9,9) J(10,10) J(11,11) */
            const real bending_damping = p[4 * 8 + j];
            const real t1 = bending_damping * bending;
            J[7 * 8 + j] = J[9 * 8 + j] = J[11 * 8 + j] = J[19 * 8 + j] = J[21 * 8 + j] = J[23 * 8 + j]
                = 0.2777777777777778 * t1; /* J(3,15) J(4,16) J(5,17) J(9,21) J(10,22) J(11,23) */
            J[12 * 8 + j] = J[14 * 8 + j] = J[16 * 8 + j] = 0.4444444444444444 * bending; /* J(6,6) J(7,7) J(8,8) */
            J[13 * 8 + j] = J[15 * 8 + j] = J[17 * 8 + j] = 0.4444444444444444 * t1; /* J(6,18) J(7,19) J(8,20) */
        }
    }
}

const flexel_law flexel_law_cable_stiffness = {
    .name = "cable_stiffness",
    .digest = "c9cb37880850cb4e",
    .m = 12,
    .k = 0,
    .nz = 0,
    .np = 5,
    .law = cable_stiffness_law,
    .tangent = cable_stiffness_tangent,
};

/* spring_curve
 *
 * y = x - origin, sum of c_i y^i in the piece in which x lies (x < next break), end pieces beyond
 * sigma = that sum with x = e;  energy = its integral
 *
 * Source: piecewise polynomial
 *
 * 1 deformations, 0 slips
 * p (142):
 *   breaks (15) [m or m/s]: where the next piece begins; rising, unused ones very large
 *   origins (16) [m or m/s]: from where the powers of each piece are counted
 *   coefficients (80) [N, N/m, ...]: of each piece, rising powers
 *   stored (16) [J]: energy at the origin of each piece
 *   kinks (15) [m or m/s]: breaks at which the slope jumps, where steps end; unused ones very large */

/* law: 152 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (142)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void spring_curve_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (142 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_ = e[0 * 8 + j];
            const real breaks_14 = p[14 * 8 + j];
            const real coefficients_70 = p[101 * 8 + j];
            const real coefficients_75 = p[106 * 8 + j];
            const real t0 = real_lt(e_, breaks_14) ? coefficients_70 : coefficients_75;
            const real breaks_13 = p[13 * 8 + j];
            const real coefficients_65 = p[96 * 8 + j];
            const real breaks_12 = p[12 * 8 + j];
            const real coefficients_60 = p[91 * 8 + j];
            const real t1 = real_lt(e_, breaks_12) ? coefficients_60 : (real_lt(e_, breaks_13) ? coefficients_65
                : t0);
            const real breaks_11 = p[11 * 8 + j];
            const real coefficients_55 = p[86 * 8 + j];
            const real breaks_10 = p[10 * 8 + j];
            const real coefficients_50 = p[81 * 8 + j];
            const real t2 = real_lt(e_, breaks_10) ? coefficients_50 : (real_lt(e_, breaks_11) ? coefficients_55
                : t1);
            const real breaks_9 = p[9 * 8 + j];
            const real coefficients_45 = p[76 * 8 + j];
            const real breaks_8 = p[8 * 8 + j];
            const real coefficients_40 = p[71 * 8 + j];
            const real t3 = real_lt(e_, breaks_8) ? coefficients_40 : (real_lt(e_, breaks_9) ? coefficients_45 : t2);
            const real breaks_7 = p[7 * 8 + j];
            const real coefficients_35 = p[66 * 8 + j];
            const real breaks_6 = p[6 * 8 + j];
            const real coefficients_30 = p[61 * 8 + j];
            const real t4 = real_lt(e_, breaks_6) ? coefficients_30 : (real_lt(e_, breaks_7) ? coefficients_35 : t3);
            const real breaks_5 = p[5 * 8 + j];
            const real coefficients_25 = p[56 * 8 + j];
            const real breaks_4 = p[4 * 8 + j];
            const real coefficients_20 = p[51 * 8 + j];
            const real t5 = real_lt(e_, breaks_4) ? coefficients_20 : (real_lt(e_, breaks_5) ? coefficients_25 : t4);
            const real breaks_3 = p[3 * 8 + j];
            const real coefficients_15 = p[46 * 8 + j];
            const real breaks_2 = p[2 * 8 + j];
            const real coefficients_10 = p[41 * 8 + j];
            const real t6 = real_lt(e_, breaks_2) ? coefficients_10 : (real_lt(e_, breaks_3) ? coefficients_15 : t5);
            const real breaks_1 = p[1 * 8 + j];
            const real coefficients_5 = p[36 * 8 + j];
            const real breaks_0 = p[0 * 8 + j];
            const real coefficients_0 = p[31 * 8 + j];
            const real c0 = real_lt(e_, breaks_0) ? coefficients_0 : (real_lt(e_, breaks_1) ? coefficients_5 : t6);
            const real origins_14 = p[29 * 8 + j];
            const real origins_15 = p[30 * 8 + j];
            const real origins_13 = p[28 * 8 + j];
            const real t7 = real_lt(e_, breaks_13) ? origins_13 : (real_lt(e_, breaks_14) ? origins_14 : origins_15);
            const real origins_12 = p[27 * 8 + j];
            const real origins_11 = p[26 * 8 + j];
            const real t8 = real_lt(e_, breaks_11) ? origins_11 : (real_lt(e_, breaks_12) ? origins_12 : t7);
            const real origins_10 = p[25 * 8 + j];
            const real origins_9 = p[24 * 8 + j];
            const real t9 = real_lt(e_, breaks_9) ? origins_9 : (real_lt(e_, breaks_10) ? origins_10 : t8);
            const real origins_8 = p[23 * 8 + j];
            const real origins_7 = p[22 * 8 + j];
            const real t10 = real_lt(e_, breaks_7) ? origins_7 : (real_lt(e_, breaks_8) ? origins_8 : t9);
            const real origins_6 = p[21 * 8 + j];
            const real origins_5 = p[20 * 8 + j];
            const real t11 = real_lt(e_, breaks_5) ? origins_5 : (real_lt(e_, breaks_6) ? origins_6 : t10);
            const real origins_4 = p[19 * 8 + j];
            const real origins_3 = p[18 * 8 + j];
            const real t12 = real_lt(e_, breaks_3) ? origins_3 : (real_lt(e_, breaks_4) ? origins_4 : t11);
            const real origins_2 = p[17 * 8 + j];
            const real origins_1 = p[16 * 8 + j];
            const real t13 = real_lt(e_, breaks_1) ? origins_1 : (real_lt(e_, breaks_2) ? origins_2 : t12);
            const real origins_0 = p[15 * 8 + j];
            const real y = e_ - (real_lt(e_, breaks_0) ? origins_0 : t13);
            const real coefficients_71 = p[102 * 8 + j];
            const real coefficients_76 = p[107 * 8 + j];
            const real t14 = real_lt(e_, breaks_14) ? coefficients_71 : coefficients_76;
            const real coefficients_66 = p[97 * 8 + j];
            const real coefficients_61 = p[92 * 8 + j];
            const real t15 = real_lt(e_, breaks_12) ? coefficients_61 : (real_lt(e_, breaks_13) ? coefficients_66
                : t14);
            const real coefficients_56 = p[87 * 8 + j];
            const real coefficients_51 = p[82 * 8 + j];
            const real t16 = real_lt(e_, breaks_10) ? coefficients_51 : (real_lt(e_, breaks_11) ? coefficients_56
                : t15);
            const real coefficients_46 = p[77 * 8 + j];
            const real coefficients_41 = p[72 * 8 + j];
            const real t17 = real_lt(e_, breaks_8) ? coefficients_41 : (real_lt(e_, breaks_9) ? coefficients_46
                : t16);
            const real coefficients_36 = p[67 * 8 + j];
            const real coefficients_31 = p[62 * 8 + j];
            const real t18 = real_lt(e_, breaks_6) ? coefficients_31 : (real_lt(e_, breaks_7) ? coefficients_36
                : t17);
            const real coefficients_26 = p[57 * 8 + j];
            const real coefficients_21 = p[52 * 8 + j];
            const real t19 = real_lt(e_, breaks_4) ? coefficients_21 : (real_lt(e_, breaks_5) ? coefficients_26
                : t18);
            const real coefficients_16 = p[47 * 8 + j];
            const real coefficients_11 = p[42 * 8 + j];
            const real t20 = real_lt(e_, breaks_2) ? coefficients_11 : (real_lt(e_, breaks_3) ? coefficients_16
                : t19);
            const real coefficients_6 = p[37 * 8 + j];
            const real coefficients_1 = p[32 * 8 + j];
            const real c1 = real_lt(e_, breaks_0) ? coefficients_1 : (real_lt(e_, breaks_1) ? coefficients_6 : t20);
            const real coefficients_72 = p[103 * 8 + j];
            const real coefficients_77 = p[108 * 8 + j];
            const real t21 = real_lt(e_, breaks_14) ? coefficients_72 : coefficients_77;
            const real coefficients_67 = p[98 * 8 + j];
            const real coefficients_62 = p[93 * 8 + j];
            const real t22 = real_lt(e_, breaks_12) ? coefficients_62 : (real_lt(e_, breaks_13) ? coefficients_67
                : t21);
            const real coefficients_57 = p[88 * 8 + j];
            const real coefficients_52 = p[83 * 8 + j];
            const real t23 = real_lt(e_, breaks_10) ? coefficients_52 : (real_lt(e_, breaks_11) ? coefficients_57
                : t22);
            const real coefficients_47 = p[78 * 8 + j];
            const real coefficients_42 = p[73 * 8 + j];
            const real t24 = real_lt(e_, breaks_8) ? coefficients_42 : (real_lt(e_, breaks_9) ? coefficients_47
                : t23);
            const real coefficients_37 = p[68 * 8 + j];
            const real coefficients_32 = p[63 * 8 + j];
            const real t25 = real_lt(e_, breaks_6) ? coefficients_32 : (real_lt(e_, breaks_7) ? coefficients_37
                : t24);
            const real coefficients_27 = p[58 * 8 + j];
            const real coefficients_22 = p[53 * 8 + j];
            const real t26 = real_lt(e_, breaks_4) ? coefficients_22 : (real_lt(e_, breaks_5) ? coefficients_27
                : t25);
            const real coefficients_17 = p[48 * 8 + j];
            const real coefficients_12 = p[43 * 8 + j];
            const real t27 = real_lt(e_, breaks_2) ? coefficients_12 : (real_lt(e_, breaks_3) ? coefficients_17
                : t26);
            const real coefficients_7 = p[38 * 8 + j];
            const real coefficients_2 = p[33 * 8 + j];
            const real c2 = real_lt(e_, breaks_0) ? coefficients_2 : (real_lt(e_, breaks_1) ? coefficients_7 : t27);
            const real coefficients_73 = p[104 * 8 + j];
            const real coefficients_78 = p[109 * 8 + j];
            const real t28 = real_lt(e_, breaks_14) ? coefficients_73 : coefficients_78;
            const real coefficients_68 = p[99 * 8 + j];
            const real coefficients_63 = p[94 * 8 + j];
            const real t29 = real_lt(e_, breaks_12) ? coefficients_63 : (real_lt(e_, breaks_13) ? coefficients_68
                : t28);
            const real coefficients_58 = p[89 * 8 + j];
            const real coefficients_53 = p[84 * 8 + j];
            const real t30 = real_lt(e_, breaks_10) ? coefficients_53 : (real_lt(e_, breaks_11) ? coefficients_58
                : t29);
            const real coefficients_48 = p[79 * 8 + j];
            const real coefficients_43 = p[74 * 8 + j];
            const real t31 = real_lt(e_, breaks_8) ? coefficients_43 : (real_lt(e_, breaks_9) ? coefficients_48
                : t30);
            const real coefficients_38 = p[69 * 8 + j];
            const real coefficients_33 = p[64 * 8 + j];
            const real t32 = real_lt(e_, breaks_6) ? coefficients_33 : (real_lt(e_, breaks_7) ? coefficients_38
                : t31);
            const real coefficients_28 = p[59 * 8 + j];
            const real coefficients_23 = p[54 * 8 + j];
            const real t33 = real_lt(e_, breaks_4) ? coefficients_23 : (real_lt(e_, breaks_5) ? coefficients_28
                : t32);
            const real coefficients_18 = p[49 * 8 + j];
            const real coefficients_13 = p[44 * 8 + j];
            const real t34 = real_lt(e_, breaks_2) ? coefficients_13 : (real_lt(e_, breaks_3) ? coefficients_18
                : t33);
            const real coefficients_8 = p[39 * 8 + j];
            const real coefficients_3 = p[34 * 8 + j];
            const real c3 = real_lt(e_, breaks_0) ? coefficients_3 : (real_lt(e_, breaks_1) ? coefficients_8 : t34);
            const real coefficients_74 = p[105 * 8 + j];
            const real coefficients_79 = p[110 * 8 + j];
            const real t35 = real_lt(e_, breaks_14) ? coefficients_74 : coefficients_79;
            const real coefficients_69 = p[100 * 8 + j];
            const real coefficients_64 = p[95 * 8 + j];
            const real t36 = real_lt(e_, breaks_12) ? coefficients_64 : (real_lt(e_, breaks_13) ? coefficients_69
                : t35);
            const real coefficients_59 = p[90 * 8 + j];
            const real coefficients_54 = p[85 * 8 + j];
            const real t37 = real_lt(e_, breaks_10) ? coefficients_54 : (real_lt(e_, breaks_11) ? coefficients_59
                : t36);
            const real coefficients_49 = p[80 * 8 + j];
            const real coefficients_44 = p[75 * 8 + j];
            const real t38 = real_lt(e_, breaks_8) ? coefficients_44 : (real_lt(e_, breaks_9) ? coefficients_49
                : t37);
            const real coefficients_39 = p[70 * 8 + j];
            const real coefficients_34 = p[65 * 8 + j];
            const real t39 = real_lt(e_, breaks_6) ? coefficients_34 : (real_lt(e_, breaks_7) ? coefficients_39
                : t38);
            const real coefficients_29 = p[60 * 8 + j];
            const real coefficients_24 = p[55 * 8 + j];
            const real t40 = real_lt(e_, breaks_4) ? coefficients_24 : (real_lt(e_, breaks_5) ? coefficients_29
                : t39);
            const real coefficients_19 = p[50 * 8 + j];
            const real coefficients_14 = p[45 * 8 + j];
            const real t41 = real_lt(e_, breaks_2) ? coefficients_14 : (real_lt(e_, breaks_3) ? coefficients_19
                : t40);
            const real coefficients_9 = p[40 * 8 + j];
            const real coefficients_4 = p[35 * 8 + j];
            const real c4 = real_lt(e_, breaks_0) ? coefficients_4 : (real_lt(e_, breaks_1) ? coefficients_9 : t41);
            const real t42 = y * c4;
            const real t43 = c0 + y * (c1 + y * (c2 + y * (c3 + t42)));
            sigma[0 * 8 + j] = t43;
            const real stored_14 = p[125 * 8 + j];
            const real stored_15 = p[126 * 8 + j];
            const real stored_13 = p[124 * 8 + j];
            const real t44 = real_lt(e_, breaks_13) ? stored_13 : (real_lt(e_, breaks_14) ? stored_14 : stored_15);
            const real stored_12 = p[123 * 8 + j];
            const real stored_11 = p[122 * 8 + j];
            const real t45 = real_lt(e_, breaks_11) ? stored_11 : (real_lt(e_, breaks_12) ? stored_12 : t44);
            const real stored_10 = p[121 * 8 + j];
            const real stored_9 = p[120 * 8 + j];
            const real t46 = real_lt(e_, breaks_9) ? stored_9 : (real_lt(e_, breaks_10) ? stored_10 : t45);
            const real stored_8 = p[119 * 8 + j];
            const real stored_7 = p[118 * 8 + j];
            const real t47 = real_lt(e_, breaks_7) ? stored_7 : (real_lt(e_, breaks_8) ? stored_8 : t46);
            const real stored_6 = p[117 * 8 + j];
            const real stored_5 = p[116 * 8 + j];
            const real t48 = real_lt(e_, breaks_5) ? stored_5 : (real_lt(e_, breaks_6) ? stored_6 : t47);
            const real stored_4 = p[115 * 8 + j];
            const real stored_3 = p[114 * 8 + j];
            const real t49 = real_lt(e_, breaks_3) ? stored_3 : (real_lt(e_, breaks_4) ? stored_4 : t48);
            const real stored_2 = p[113 * 8 + j];
            const real stored_1 = p[112 * 8 + j];
            const real t50 = real_lt(e_, breaks_1) ? stored_1 : (real_lt(e_, breaks_2) ? stored_2 : t49);
            const real stored_0 = p[111 * 8 + j];
            const real U0 = real_lt(e_, breaks_0) ? stored_0 : t50;
            const real t51 = 0.2 * t42;
            const real t52 = 0.25 * c3 + t51;
            const real t53 = 0.3333333333333333 * c2 + y * t52;
            const real t54 = 0.5 * c1 + y * t53;
            const real t55 = c0 + y * t54;
            U[0 * 8 + j] = U0 + y * t55;
            const real ed_ = ed[0 * 8 + j];
            P[0 * 8 + j] = ed_ * (t43 - t55) - ed_ * (t54 + y * (t53 + y * (t51 + t52))) * y;
        }
    }
}

/* tangent: 101 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (142)
 * out: J (1,2), 1 of 2 entries */
FLEXEL_CLONES
static void spring_curve_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict p = in[5] + b * (142 * 8);
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_ = e[0 * 8 + j];
            const real breaks_14 = p[14 * 8 + j];
            const real coefficients_71 = p[102 * 8 + j];
            const real coefficients_76 = p[107 * 8 + j];
            const real t0 = real_lt(e_, breaks_14) ? coefficients_71 : coefficients_76;
            const real breaks_13 = p[13 * 8 + j];
            const real coefficients_66 = p[97 * 8 + j];
            const real breaks_12 = p[12 * 8 + j];
            const real coefficients_61 = p[92 * 8 + j];
            const real t1 = real_lt(e_, breaks_12) ? coefficients_61 : (real_lt(e_, breaks_13) ? coefficients_66
                : t0);
            const real breaks_11 = p[11 * 8 + j];
            const real coefficients_56 = p[87 * 8 + j];
            const real breaks_10 = p[10 * 8 + j];
            const real coefficients_51 = p[82 * 8 + j];
            const real t2 = real_lt(e_, breaks_10) ? coefficients_51 : (real_lt(e_, breaks_11) ? coefficients_56
                : t1);
            const real breaks_9 = p[9 * 8 + j];
            const real coefficients_46 = p[77 * 8 + j];
            const real breaks_8 = p[8 * 8 + j];
            const real coefficients_41 = p[72 * 8 + j];
            const real t3 = real_lt(e_, breaks_8) ? coefficients_41 : (real_lt(e_, breaks_9) ? coefficients_46 : t2);
            const real breaks_7 = p[7 * 8 + j];
            const real coefficients_36 = p[67 * 8 + j];
            const real breaks_6 = p[6 * 8 + j];
            const real coefficients_31 = p[62 * 8 + j];
            const real t4 = real_lt(e_, breaks_6) ? coefficients_31 : (real_lt(e_, breaks_7) ? coefficients_36 : t3);
            const real breaks_5 = p[5 * 8 + j];
            const real coefficients_26 = p[57 * 8 + j];
            const real breaks_4 = p[4 * 8 + j];
            const real coefficients_21 = p[52 * 8 + j];
            const real t5 = real_lt(e_, breaks_4) ? coefficients_21 : (real_lt(e_, breaks_5) ? coefficients_26 : t4);
            const real breaks_3 = p[3 * 8 + j];
            const real coefficients_16 = p[47 * 8 + j];
            const real breaks_2 = p[2 * 8 + j];
            const real coefficients_11 = p[42 * 8 + j];
            const real t6 = real_lt(e_, breaks_2) ? coefficients_11 : (real_lt(e_, breaks_3) ? coefficients_16 : t5);
            const real breaks_1 = p[1 * 8 + j];
            const real coefficients_6 = p[37 * 8 + j];
            const real breaks_0 = p[0 * 8 + j];
            const real coefficients_1 = p[32 * 8 + j];
            const real c1 = real_lt(e_, breaks_0) ? coefficients_1 : (real_lt(e_, breaks_1) ? coefficients_6 : t6);
            const real origins_14 = p[29 * 8 + j];
            const real origins_15 = p[30 * 8 + j];
            const real origins_13 = p[28 * 8 + j];
            const real t7 = real_lt(e_, breaks_13) ? origins_13 : (real_lt(e_, breaks_14) ? origins_14 : origins_15);
            const real origins_12 = p[27 * 8 + j];
            const real origins_11 = p[26 * 8 + j];
            const real t8 = real_lt(e_, breaks_11) ? origins_11 : (real_lt(e_, breaks_12) ? origins_12 : t7);
            const real origins_10 = p[25 * 8 + j];
            const real origins_9 = p[24 * 8 + j];
            const real t9 = real_lt(e_, breaks_9) ? origins_9 : (real_lt(e_, breaks_10) ? origins_10 : t8);
            const real origins_8 = p[23 * 8 + j];
            const real origins_7 = p[22 * 8 + j];
            const real t10 = real_lt(e_, breaks_7) ? origins_7 : (real_lt(e_, breaks_8) ? origins_8 : t9);
            const real origins_6 = p[21 * 8 + j];
            const real origins_5 = p[20 * 8 + j];
            const real t11 = real_lt(e_, breaks_5) ? origins_5 : (real_lt(e_, breaks_6) ? origins_6 : t10);
            const real origins_4 = p[19 * 8 + j];
            const real origins_3 = p[18 * 8 + j];
            const real t12 = real_lt(e_, breaks_3) ? origins_3 : (real_lt(e_, breaks_4) ? origins_4 : t11);
            const real origins_2 = p[17 * 8 + j];
            const real origins_1 = p[16 * 8 + j];
            const real t13 = real_lt(e_, breaks_1) ? origins_1 : (real_lt(e_, breaks_2) ? origins_2 : t12);
            const real origins_0 = p[15 * 8 + j];
            const real y = e_ - (real_lt(e_, breaks_0) ? origins_0 : t13);
            const real coefficients_72 = p[103 * 8 + j];
            const real coefficients_77 = p[108 * 8 + j];
            const real t14 = real_lt(e_, breaks_14) ? coefficients_72 : coefficients_77;
            const real coefficients_67 = p[98 * 8 + j];
            const real coefficients_62 = p[93 * 8 + j];
            const real t15 = real_lt(e_, breaks_12) ? coefficients_62 : (real_lt(e_, breaks_13) ? coefficients_67
                : t14);
            const real coefficients_57 = p[88 * 8 + j];
            const real coefficients_52 = p[83 * 8 + j];
            const real t16 = real_lt(e_, breaks_10) ? coefficients_52 : (real_lt(e_, breaks_11) ? coefficients_57
                : t15);
            const real coefficients_47 = p[78 * 8 + j];
            const real coefficients_42 = p[73 * 8 + j];
            const real t17 = real_lt(e_, breaks_8) ? coefficients_42 : (real_lt(e_, breaks_9) ? coefficients_47
                : t16);
            const real coefficients_37 = p[68 * 8 + j];
            const real coefficients_32 = p[63 * 8 + j];
            const real t18 = real_lt(e_, breaks_6) ? coefficients_32 : (real_lt(e_, breaks_7) ? coefficients_37
                : t17);
            const real coefficients_27 = p[58 * 8 + j];
            const real coefficients_22 = p[53 * 8 + j];
            const real t19 = real_lt(e_, breaks_4) ? coefficients_22 : (real_lt(e_, breaks_5) ? coefficients_27
                : t18);
            const real coefficients_17 = p[48 * 8 + j];
            const real coefficients_12 = p[43 * 8 + j];
            const real t20 = real_lt(e_, breaks_2) ? coefficients_12 : (real_lt(e_, breaks_3) ? coefficients_17
                : t19);
            const real coefficients_7 = p[38 * 8 + j];
            const real coefficients_2 = p[33 * 8 + j];
            const real c2 = real_lt(e_, breaks_0) ? coefficients_2 : (real_lt(e_, breaks_1) ? coefficients_7 : t20);
            const real coefficients_73 = p[104 * 8 + j];
            const real coefficients_78 = p[109 * 8 + j];
            const real t21 = real_lt(e_, breaks_14) ? coefficients_73 : coefficients_78;
            const real coefficients_68 = p[99 * 8 + j];
            const real coefficients_63 = p[94 * 8 + j];
            const real t22 = real_lt(e_, breaks_12) ? coefficients_63 : (real_lt(e_, breaks_13) ? coefficients_68
                : t21);
            const real coefficients_58 = p[89 * 8 + j];
            const real coefficients_53 = p[84 * 8 + j];
            const real t23 = real_lt(e_, breaks_10) ? coefficients_53 : (real_lt(e_, breaks_11) ? coefficients_58
                : t22);
            const real coefficients_48 = p[79 * 8 + j];
            const real coefficients_43 = p[74 * 8 + j];
            const real t24 = real_lt(e_, breaks_8) ? coefficients_43 : (real_lt(e_, breaks_9) ? coefficients_48
                : t23);
            const real coefficients_38 = p[69 * 8 + j];
            const real coefficients_33 = p[64 * 8 + j];
            const real t25 = real_lt(e_, breaks_6) ? coefficients_33 : (real_lt(e_, breaks_7) ? coefficients_38
                : t24);
            const real coefficients_28 = p[59 * 8 + j];
            const real coefficients_23 = p[54 * 8 + j];
            const real t26 = real_lt(e_, breaks_4) ? coefficients_23 : (real_lt(e_, breaks_5) ? coefficients_28
                : t25);
            const real coefficients_18 = p[49 * 8 + j];
            const real coefficients_13 = p[44 * 8 + j];
            const real t27 = real_lt(e_, breaks_2) ? coefficients_13 : (real_lt(e_, breaks_3) ? coefficients_18
                : t26);
            const real coefficients_8 = p[39 * 8 + j];
            const real coefficients_3 = p[34 * 8 + j];
            const real c3 = real_lt(e_, breaks_0) ? coefficients_3 : (real_lt(e_, breaks_1) ? coefficients_8 : t27);
            const real coefficients_74 = p[105 * 8 + j];
            const real coefficients_79 = p[110 * 8 + j];
            const real t28 = real_lt(e_, breaks_14) ? coefficients_74 : coefficients_79;
            const real coefficients_69 = p[100 * 8 + j];
            const real coefficients_64 = p[95 * 8 + j];
            const real t29 = real_lt(e_, breaks_12) ? coefficients_64 : (real_lt(e_, breaks_13) ? coefficients_69
                : t28);
            const real coefficients_59 = p[90 * 8 + j];
            const real coefficients_54 = p[85 * 8 + j];
            const real t30 = real_lt(e_, breaks_10) ? coefficients_54 : (real_lt(e_, breaks_11) ? coefficients_59
                : t29);
            const real coefficients_49 = p[80 * 8 + j];
            const real coefficients_44 = p[75 * 8 + j];
            const real t31 = real_lt(e_, breaks_8) ? coefficients_44 : (real_lt(e_, breaks_9) ? coefficients_49
                : t30);
            const real coefficients_39 = p[70 * 8 + j];
            const real coefficients_34 = p[65 * 8 + j];
            const real t32 = real_lt(e_, breaks_6) ? coefficients_34 : (real_lt(e_, breaks_7) ? coefficients_39
                : t31);
            const real coefficients_29 = p[60 * 8 + j];
            const real coefficients_24 = p[55 * 8 + j];
            const real t33 = real_lt(e_, breaks_4) ? coefficients_24 : (real_lt(e_, breaks_5) ? coefficients_29
                : t32);
            const real coefficients_19 = p[50 * 8 + j];
            const real coefficients_14 = p[45 * 8 + j];
            const real t34 = real_lt(e_, breaks_2) ? coefficients_14 : (real_lt(e_, breaks_3) ? coefficients_19
                : t33);
            const real coefficients_9 = p[40 * 8 + j];
            const real coefficients_4 = p[35 * 8 + j];
            const real c4 = real_lt(e_, breaks_0) ? coefficients_4 : (real_lt(e_, breaks_1) ? coefficients_9 : t34);
            const real t35 = y * c4;
            const real t36 = c3 + t35;
            const real t37 = c2 + y * t36;
            J[0 * 8 + j] = c1 + y * (t37 + y * (t35 + t36) + t37); /* J(0,0) */
        }
    }
}

const flexel_law flexel_law_spring_curve = {
    .name = "spring_curve",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 142,
    .law = spring_curve_law,
    .tangent = spring_curve_tangent,
};

/* damper_curve
 *
 * y = x - origin, sum of c_i y^i in the piece in which x lies (x < next break), end pieces beyond
 * sigma = that sum with x = the rate of e
 *
 * Source: piecewise polynomial
 *
 * 1 deformations, 0 slips
 * p (126):
 *   breaks (15) [m or m/s]: where the next piece begins; rising, unused ones very large
 *   origins (16) [m or m/s]: from where the powers of each piece are counted
 *   coefficients (80) [N, N/m, ...]: of each piece, rising powers
 *   kinks (15) [m or m/s]: breaks at which the slope jumps, where steps end; unused ones very large */

/* law: 115 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (126)
 * out: sigma (1), tau (0), zd (0), U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void damper_curve_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (126 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_ = ed[0 * 8 + j];
            const real breaks_14 = p[14 * 8 + j];
            const real coefficients_70 = p[101 * 8 + j];
            const real coefficients_75 = p[106 * 8 + j];
            const real t0 = real_lt(ed_, breaks_14) ? coefficients_70 : coefficients_75;
            const real breaks_13 = p[13 * 8 + j];
            const real coefficients_65 = p[96 * 8 + j];
            const real breaks_12 = p[12 * 8 + j];
            const real coefficients_60 = p[91 * 8 + j];
            const real t1 = real_lt(ed_, breaks_12) ? coefficients_60 : (real_lt(ed_, breaks_13) ? coefficients_65
                : t0);
            const real breaks_11 = p[11 * 8 + j];
            const real coefficients_55 = p[86 * 8 + j];
            const real breaks_10 = p[10 * 8 + j];
            const real coefficients_50 = p[81 * 8 + j];
            const real t2 = real_lt(ed_, breaks_10) ? coefficients_50 : (real_lt(ed_, breaks_11) ? coefficients_55
                : t1);
            const real breaks_9 = p[9 * 8 + j];
            const real coefficients_45 = p[76 * 8 + j];
            const real breaks_8 = p[8 * 8 + j];
            const real coefficients_40 = p[71 * 8 + j];
            const real t3 = real_lt(ed_, breaks_8) ? coefficients_40 : (real_lt(ed_, breaks_9) ? coefficients_45
                : t2);
            const real breaks_7 = p[7 * 8 + j];
            const real coefficients_35 = p[66 * 8 + j];
            const real breaks_6 = p[6 * 8 + j];
            const real coefficients_30 = p[61 * 8 + j];
            const real t4 = real_lt(ed_, breaks_6) ? coefficients_30 : (real_lt(ed_, breaks_7) ? coefficients_35
                : t3);
            const real breaks_5 = p[5 * 8 + j];
            const real coefficients_25 = p[56 * 8 + j];
            const real breaks_4 = p[4 * 8 + j];
            const real coefficients_20 = p[51 * 8 + j];
            const real t5 = real_lt(ed_, breaks_4) ? coefficients_20 : (real_lt(ed_, breaks_5) ? coefficients_25
                : t4);
            const real breaks_3 = p[3 * 8 + j];
            const real coefficients_15 = p[46 * 8 + j];
            const real breaks_2 = p[2 * 8 + j];
            const real coefficients_10 = p[41 * 8 + j];
            const real t6 = real_lt(ed_, breaks_2) ? coefficients_10 : (real_lt(ed_, breaks_3) ? coefficients_15
                : t5);
            const real breaks_1 = p[1 * 8 + j];
            const real coefficients_5 = p[36 * 8 + j];
            const real breaks_0 = p[0 * 8 + j];
            const real coefficients_0 = p[31 * 8 + j];
            const real c0 = real_lt(ed_, breaks_0) ? coefficients_0 : (real_lt(ed_, breaks_1) ? coefficients_5 : t6);
            const real origins_14 = p[29 * 8 + j];
            const real origins_15 = p[30 * 8 + j];
            const real origins_13 = p[28 * 8 + j];
            const real t7 = real_lt(ed_, breaks_13) ? origins_13 : (real_lt(ed_, breaks_14) ? origins_14
                : origins_15);
            const real origins_12 = p[27 * 8 + j];
            const real origins_11 = p[26 * 8 + j];
            const real t8 = real_lt(ed_, breaks_11) ? origins_11 : (real_lt(ed_, breaks_12) ? origins_12 : t7);
            const real origins_10 = p[25 * 8 + j];
            const real origins_9 = p[24 * 8 + j];
            const real t9 = real_lt(ed_, breaks_9) ? origins_9 : (real_lt(ed_, breaks_10) ? origins_10 : t8);
            const real origins_8 = p[23 * 8 + j];
            const real origins_7 = p[22 * 8 + j];
            const real t10 = real_lt(ed_, breaks_7) ? origins_7 : (real_lt(ed_, breaks_8) ? origins_8 : t9);
            const real origins_6 = p[21 * 8 + j];
            const real origins_5 = p[20 * 8 + j];
            const real t11 = real_lt(ed_, breaks_5) ? origins_5 : (real_lt(ed_, breaks_6) ? origins_6 : t10);
            const real origins_4 = p[19 * 8 + j];
            const real origins_3 = p[18 * 8 + j];
            const real t12 = real_lt(ed_, breaks_3) ? origins_3 : (real_lt(ed_, breaks_4) ? origins_4 : t11);
            const real origins_2 = p[17 * 8 + j];
            const real origins_1 = p[16 * 8 + j];
            const real t13 = real_lt(ed_, breaks_1) ? origins_1 : (real_lt(ed_, breaks_2) ? origins_2 : t12);
            const real origins_0 = p[15 * 8 + j];
            const real y = ed_ - (real_lt(ed_, breaks_0) ? origins_0 : t13);
            const real coefficients_71 = p[102 * 8 + j];
            const real coefficients_76 = p[107 * 8 + j];
            const real t14 = real_lt(ed_, breaks_14) ? coefficients_71 : coefficients_76;
            const real coefficients_66 = p[97 * 8 + j];
            const real coefficients_61 = p[92 * 8 + j];
            const real t15 = real_lt(ed_, breaks_12) ? coefficients_61 : (real_lt(ed_, breaks_13) ? coefficients_66
                : t14);
            const real coefficients_56 = p[87 * 8 + j];
            const real coefficients_51 = p[82 * 8 + j];
            const real t16 = real_lt(ed_, breaks_10) ? coefficients_51 : (real_lt(ed_, breaks_11) ? coefficients_56
                : t15);
            const real coefficients_46 = p[77 * 8 + j];
            const real coefficients_41 = p[72 * 8 + j];
            const real t17 = real_lt(ed_, breaks_8) ? coefficients_41 : (real_lt(ed_, breaks_9) ? coefficients_46
                : t16);
            const real coefficients_36 = p[67 * 8 + j];
            const real coefficients_31 = p[62 * 8 + j];
            const real t18 = real_lt(ed_, breaks_6) ? coefficients_31 : (real_lt(ed_, breaks_7) ? coefficients_36
                : t17);
            const real coefficients_26 = p[57 * 8 + j];
            const real coefficients_21 = p[52 * 8 + j];
            const real t19 = real_lt(ed_, breaks_4) ? coefficients_21 : (real_lt(ed_, breaks_5) ? coefficients_26
                : t18);
            const real coefficients_16 = p[47 * 8 + j];
            const real coefficients_11 = p[42 * 8 + j];
            const real t20 = real_lt(ed_, breaks_2) ? coefficients_11 : (real_lt(ed_, breaks_3) ? coefficients_16
                : t19);
            const real coefficients_6 = p[37 * 8 + j];
            const real coefficients_1 = p[32 * 8 + j];
            const real c1 = real_lt(ed_, breaks_0) ? coefficients_1 : (real_lt(ed_, breaks_1) ? coefficients_6 : t20);
            const real coefficients_72 = p[103 * 8 + j];
            const real coefficients_77 = p[108 * 8 + j];
            const real t21 = real_lt(ed_, breaks_14) ? coefficients_72 : coefficients_77;
            const real coefficients_67 = p[98 * 8 + j];
            const real coefficients_62 = p[93 * 8 + j];
            const real t22 = real_lt(ed_, breaks_12) ? coefficients_62 : (real_lt(ed_, breaks_13) ? coefficients_67
                : t21);
            const real coefficients_57 = p[88 * 8 + j];
            const real coefficients_52 = p[83 * 8 + j];
            const real t23 = real_lt(ed_, breaks_10) ? coefficients_52 : (real_lt(ed_, breaks_11) ? coefficients_57
                : t22);
            const real coefficients_47 = p[78 * 8 + j];
            const real coefficients_42 = p[73 * 8 + j];
            const real t24 = real_lt(ed_, breaks_8) ? coefficients_42 : (real_lt(ed_, breaks_9) ? coefficients_47
                : t23);
            const real coefficients_37 = p[68 * 8 + j];
            const real coefficients_32 = p[63 * 8 + j];
            const real t25 = real_lt(ed_, breaks_6) ? coefficients_32 : (real_lt(ed_, breaks_7) ? coefficients_37
                : t24);
            const real coefficients_27 = p[58 * 8 + j];
            const real coefficients_22 = p[53 * 8 + j];
            const real t26 = real_lt(ed_, breaks_4) ? coefficients_22 : (real_lt(ed_, breaks_5) ? coefficients_27
                : t25);
            const real coefficients_17 = p[48 * 8 + j];
            const real coefficients_12 = p[43 * 8 + j];
            const real t27 = real_lt(ed_, breaks_2) ? coefficients_12 : (real_lt(ed_, breaks_3) ? coefficients_17
                : t26);
            const real coefficients_7 = p[38 * 8 + j];
            const real coefficients_2 = p[33 * 8 + j];
            const real c2 = real_lt(ed_, breaks_0) ? coefficients_2 : (real_lt(ed_, breaks_1) ? coefficients_7 : t27);
            const real coefficients_73 = p[104 * 8 + j];
            const real coefficients_78 = p[109 * 8 + j];
            const real t28 = real_lt(ed_, breaks_14) ? coefficients_73 : coefficients_78;
            const real coefficients_68 = p[99 * 8 + j];
            const real coefficients_63 = p[94 * 8 + j];
            const real t29 = real_lt(ed_, breaks_12) ? coefficients_63 : (real_lt(ed_, breaks_13) ? coefficients_68
                : t28);
            const real coefficients_58 = p[89 * 8 + j];
            const real coefficients_53 = p[84 * 8 + j];
            const real t30 = real_lt(ed_, breaks_10) ? coefficients_53 : (real_lt(ed_, breaks_11) ? coefficients_58
                : t29);
            const real coefficients_48 = p[79 * 8 + j];
            const real coefficients_43 = p[74 * 8 + j];
            const real t31 = real_lt(ed_, breaks_8) ? coefficients_43 : (real_lt(ed_, breaks_9) ? coefficients_48
                : t30);
            const real coefficients_38 = p[69 * 8 + j];
            const real coefficients_33 = p[64 * 8 + j];
            const real t32 = real_lt(ed_, breaks_6) ? coefficients_33 : (real_lt(ed_, breaks_7) ? coefficients_38
                : t31);
            const real coefficients_28 = p[59 * 8 + j];
            const real coefficients_23 = p[54 * 8 + j];
            const real t33 = real_lt(ed_, breaks_4) ? coefficients_23 : (real_lt(ed_, breaks_5) ? coefficients_28
                : t32);
            const real coefficients_18 = p[49 * 8 + j];
            const real coefficients_13 = p[44 * 8 + j];
            const real t34 = real_lt(ed_, breaks_2) ? coefficients_13 : (real_lt(ed_, breaks_3) ? coefficients_18
                : t33);
            const real coefficients_8 = p[39 * 8 + j];
            const real coefficients_3 = p[34 * 8 + j];
            const real c3 = real_lt(ed_, breaks_0) ? coefficients_3 : (real_lt(ed_, breaks_1) ? coefficients_8 : t34);
            const real coefficients_74 = p[105 * 8 + j];
            const real coefficients_79 = p[110 * 8 + j];
            const real t35 = real_lt(ed_, breaks_14) ? coefficients_74 : coefficients_79;
            const real coefficients_69 = p[100 * 8 + j];
            const real coefficients_64 = p[95 * 8 + j];
            const real t36 = real_lt(ed_, breaks_12) ? coefficients_64 : (real_lt(ed_, breaks_13) ? coefficients_69
                : t35);
            const real coefficients_59 = p[90 * 8 + j];
            const real coefficients_54 = p[85 * 8 + j];
            const real t37 = real_lt(ed_, breaks_10) ? coefficients_54 : (real_lt(ed_, breaks_11) ? coefficients_59
                : t36);
            const real coefficients_49 = p[80 * 8 + j];
            const real coefficients_44 = p[75 * 8 + j];
            const real t38 = real_lt(ed_, breaks_8) ? coefficients_44 : (real_lt(ed_, breaks_9) ? coefficients_49
                : t37);
            const real coefficients_39 = p[70 * 8 + j];
            const real coefficients_34 = p[65 * 8 + j];
            const real t39 = real_lt(ed_, breaks_6) ? coefficients_34 : (real_lt(ed_, breaks_7) ? coefficients_39
                : t38);
            const real coefficients_29 = p[60 * 8 + j];
            const real coefficients_24 = p[55 * 8 + j];
            const real t40 = real_lt(ed_, breaks_4) ? coefficients_24 : (real_lt(ed_, breaks_5) ? coefficients_29
                : t39);
            const real coefficients_19 = p[50 * 8 + j];
            const real coefficients_14 = p[45 * 8 + j];
            const real t41 = real_lt(ed_, breaks_2) ? coefficients_14 : (real_lt(ed_, breaks_3) ? coefficients_19
                : t40);
            const real coefficients_9 = p[40 * 8 + j];
            const real coefficients_4 = p[35 * 8 + j];
            const real c4 = real_lt(ed_, breaks_0) ? coefficients_4 : (real_lt(ed_, breaks_1) ? coefficients_9 : t41);
            const real t42 = c0 + y * (c1 + y * (c2 + y * (c3 + y * c4)));
            sigma[0 * 8 + j] = t42;
            P[0 * 8 + j] = ed_ * t42;
        }
    }
}

/* tangent: 101 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (126)
 * out: J (1,2), 1 of 2 entries */
FLEXEL_CLONES
static void damper_curve_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (126 * 8);
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_ = ed[0 * 8 + j];
            const real breaks_14 = p[14 * 8 + j];
            const real coefficients_71 = p[102 * 8 + j];
            const real coefficients_76 = p[107 * 8 + j];
            const real t0 = real_lt(ed_, breaks_14) ? coefficients_71 : coefficients_76;
            const real breaks_13 = p[13 * 8 + j];
            const real coefficients_66 = p[97 * 8 + j];
            const real breaks_12 = p[12 * 8 + j];
            const real coefficients_61 = p[92 * 8 + j];
            const real t1 = real_lt(ed_, breaks_12) ? coefficients_61 : (real_lt(ed_, breaks_13) ? coefficients_66
                : t0);
            const real breaks_11 = p[11 * 8 + j];
            const real coefficients_56 = p[87 * 8 + j];
            const real breaks_10 = p[10 * 8 + j];
            const real coefficients_51 = p[82 * 8 + j];
            const real t2 = real_lt(ed_, breaks_10) ? coefficients_51 : (real_lt(ed_, breaks_11) ? coefficients_56
                : t1);
            const real breaks_9 = p[9 * 8 + j];
            const real coefficients_46 = p[77 * 8 + j];
            const real breaks_8 = p[8 * 8 + j];
            const real coefficients_41 = p[72 * 8 + j];
            const real t3 = real_lt(ed_, breaks_8) ? coefficients_41 : (real_lt(ed_, breaks_9) ? coefficients_46
                : t2);
            const real breaks_7 = p[7 * 8 + j];
            const real coefficients_36 = p[67 * 8 + j];
            const real breaks_6 = p[6 * 8 + j];
            const real coefficients_31 = p[62 * 8 + j];
            const real t4 = real_lt(ed_, breaks_6) ? coefficients_31 : (real_lt(ed_, breaks_7) ? coefficients_36
                : t3);
            const real breaks_5 = p[5 * 8 + j];
            const real coefficients_26 = p[57 * 8 + j];
            const real breaks_4 = p[4 * 8 + j];
            const real coefficients_21 = p[52 * 8 + j];
            const real t5 = real_lt(ed_, breaks_4) ? coefficients_21 : (real_lt(ed_, breaks_5) ? coefficients_26
                : t4);
            const real breaks_3 = p[3 * 8 + j];
            const real coefficients_16 = p[47 * 8 + j];
            const real breaks_2 = p[2 * 8 + j];
            const real coefficients_11 = p[42 * 8 + j];
            const real t6 = real_lt(ed_, breaks_2) ? coefficients_11 : (real_lt(ed_, breaks_3) ? coefficients_16
                : t5);
            const real breaks_1 = p[1 * 8 + j];
            const real coefficients_6 = p[37 * 8 + j];
            const real breaks_0 = p[0 * 8 + j];
            const real coefficients_1 = p[32 * 8 + j];
            const real c1 = real_lt(ed_, breaks_0) ? coefficients_1 : (real_lt(ed_, breaks_1) ? coefficients_6 : t6);
            const real origins_14 = p[29 * 8 + j];
            const real origins_15 = p[30 * 8 + j];
            const real origins_13 = p[28 * 8 + j];
            const real t7 = real_lt(ed_, breaks_13) ? origins_13 : (real_lt(ed_, breaks_14) ? origins_14
                : origins_15);
            const real origins_12 = p[27 * 8 + j];
            const real origins_11 = p[26 * 8 + j];
            const real t8 = real_lt(ed_, breaks_11) ? origins_11 : (real_lt(ed_, breaks_12) ? origins_12 : t7);
            const real origins_10 = p[25 * 8 + j];
            const real origins_9 = p[24 * 8 + j];
            const real t9 = real_lt(ed_, breaks_9) ? origins_9 : (real_lt(ed_, breaks_10) ? origins_10 : t8);
            const real origins_8 = p[23 * 8 + j];
            const real origins_7 = p[22 * 8 + j];
            const real t10 = real_lt(ed_, breaks_7) ? origins_7 : (real_lt(ed_, breaks_8) ? origins_8 : t9);
            const real origins_6 = p[21 * 8 + j];
            const real origins_5 = p[20 * 8 + j];
            const real t11 = real_lt(ed_, breaks_5) ? origins_5 : (real_lt(ed_, breaks_6) ? origins_6 : t10);
            const real origins_4 = p[19 * 8 + j];
            const real origins_3 = p[18 * 8 + j];
            const real t12 = real_lt(ed_, breaks_3) ? origins_3 : (real_lt(ed_, breaks_4) ? origins_4 : t11);
            const real origins_2 = p[17 * 8 + j];
            const real origins_1 = p[16 * 8 + j];
            const real t13 = real_lt(ed_, breaks_1) ? origins_1 : (real_lt(ed_, breaks_2) ? origins_2 : t12);
            const real origins_0 = p[15 * 8 + j];
            const real y = ed_ - (real_lt(ed_, breaks_0) ? origins_0 : t13);
            const real coefficients_72 = p[103 * 8 + j];
            const real coefficients_77 = p[108 * 8 + j];
            const real t14 = real_lt(ed_, breaks_14) ? coefficients_72 : coefficients_77;
            const real coefficients_67 = p[98 * 8 + j];
            const real coefficients_62 = p[93 * 8 + j];
            const real t15 = real_lt(ed_, breaks_12) ? coefficients_62 : (real_lt(ed_, breaks_13) ? coefficients_67
                : t14);
            const real coefficients_57 = p[88 * 8 + j];
            const real coefficients_52 = p[83 * 8 + j];
            const real t16 = real_lt(ed_, breaks_10) ? coefficients_52 : (real_lt(ed_, breaks_11) ? coefficients_57
                : t15);
            const real coefficients_47 = p[78 * 8 + j];
            const real coefficients_42 = p[73 * 8 + j];
            const real t17 = real_lt(ed_, breaks_8) ? coefficients_42 : (real_lt(ed_, breaks_9) ? coefficients_47
                : t16);
            const real coefficients_37 = p[68 * 8 + j];
            const real coefficients_32 = p[63 * 8 + j];
            const real t18 = real_lt(ed_, breaks_6) ? coefficients_32 : (real_lt(ed_, breaks_7) ? coefficients_37
                : t17);
            const real coefficients_27 = p[58 * 8 + j];
            const real coefficients_22 = p[53 * 8 + j];
            const real t19 = real_lt(ed_, breaks_4) ? coefficients_22 : (real_lt(ed_, breaks_5) ? coefficients_27
                : t18);
            const real coefficients_17 = p[48 * 8 + j];
            const real coefficients_12 = p[43 * 8 + j];
            const real t20 = real_lt(ed_, breaks_2) ? coefficients_12 : (real_lt(ed_, breaks_3) ? coefficients_17
                : t19);
            const real coefficients_7 = p[38 * 8 + j];
            const real coefficients_2 = p[33 * 8 + j];
            const real c2 = real_lt(ed_, breaks_0) ? coefficients_2 : (real_lt(ed_, breaks_1) ? coefficients_7 : t20);
            const real coefficients_73 = p[104 * 8 + j];
            const real coefficients_78 = p[109 * 8 + j];
            const real t21 = real_lt(ed_, breaks_14) ? coefficients_73 : coefficients_78;
            const real coefficients_68 = p[99 * 8 + j];
            const real coefficients_63 = p[94 * 8 + j];
            const real t22 = real_lt(ed_, breaks_12) ? coefficients_63 : (real_lt(ed_, breaks_13) ? coefficients_68
                : t21);
            const real coefficients_58 = p[89 * 8 + j];
            const real coefficients_53 = p[84 * 8 + j];
            const real t23 = real_lt(ed_, breaks_10) ? coefficients_53 : (real_lt(ed_, breaks_11) ? coefficients_58
                : t22);
            const real coefficients_48 = p[79 * 8 + j];
            const real coefficients_43 = p[74 * 8 + j];
            const real t24 = real_lt(ed_, breaks_8) ? coefficients_43 : (real_lt(ed_, breaks_9) ? coefficients_48
                : t23);
            const real coefficients_38 = p[69 * 8 + j];
            const real coefficients_33 = p[64 * 8 + j];
            const real t25 = real_lt(ed_, breaks_6) ? coefficients_33 : (real_lt(ed_, breaks_7) ? coefficients_38
                : t24);
            const real coefficients_28 = p[59 * 8 + j];
            const real coefficients_23 = p[54 * 8 + j];
            const real t26 = real_lt(ed_, breaks_4) ? coefficients_23 : (real_lt(ed_, breaks_5) ? coefficients_28
                : t25);
            const real coefficients_18 = p[49 * 8 + j];
            const real coefficients_13 = p[44 * 8 + j];
            const real t27 = real_lt(ed_, breaks_2) ? coefficients_13 : (real_lt(ed_, breaks_3) ? coefficients_18
                : t26);
            const real coefficients_8 = p[39 * 8 + j];
            const real coefficients_3 = p[34 * 8 + j];
            const real c3 = real_lt(ed_, breaks_0) ? coefficients_3 : (real_lt(ed_, breaks_1) ? coefficients_8 : t27);
            const real coefficients_74 = p[105 * 8 + j];
            const real coefficients_79 = p[110 * 8 + j];
            const real t28 = real_lt(ed_, breaks_14) ? coefficients_74 : coefficients_79;
            const real coefficients_69 = p[100 * 8 + j];
            const real coefficients_64 = p[95 * 8 + j];
            const real t29 = real_lt(ed_, breaks_12) ? coefficients_64 : (real_lt(ed_, breaks_13) ? coefficients_69
                : t28);
            const real coefficients_59 = p[90 * 8 + j];
            const real coefficients_54 = p[85 * 8 + j];
            const real t30 = real_lt(ed_, breaks_10) ? coefficients_54 : (real_lt(ed_, breaks_11) ? coefficients_59
                : t29);
            const real coefficients_49 = p[80 * 8 + j];
            const real coefficients_44 = p[75 * 8 + j];
            const real t31 = real_lt(ed_, breaks_8) ? coefficients_44 : (real_lt(ed_, breaks_9) ? coefficients_49
                : t30);
            const real coefficients_39 = p[70 * 8 + j];
            const real coefficients_34 = p[65 * 8 + j];
            const real t32 = real_lt(ed_, breaks_6) ? coefficients_34 : (real_lt(ed_, breaks_7) ? coefficients_39
                : t31);
            const real coefficients_29 = p[60 * 8 + j];
            const real coefficients_24 = p[55 * 8 + j];
            const real t33 = real_lt(ed_, breaks_4) ? coefficients_24 : (real_lt(ed_, breaks_5) ? coefficients_29
                : t32);
            const real coefficients_19 = p[50 * 8 + j];
            const real coefficients_14 = p[45 * 8 + j];
            const real t34 = real_lt(ed_, breaks_2) ? coefficients_14 : (real_lt(ed_, breaks_3) ? coefficients_19
                : t33);
            const real coefficients_9 = p[40 * 8 + j];
            const real coefficients_4 = p[35 * 8 + j];
            const real c4 = real_lt(ed_, breaks_0) ? coefficients_4 : (real_lt(ed_, breaks_1) ? coefficients_9 : t34);
            const real t35 = y * c4;
            const real t36 = c3 + t35;
            const real t37 = c2 + y * t36;
            J[0 * 8 + j] = c1 + y * (t37 + y * (t35 + t36) + t37); /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_damper_curve = {
    .name = "damper_curve",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 126,
    .law = damper_curve_law,
    .tangent = damper_curve_tangent,
};

/* stop
 *
 * depth = max(0, e - gap);  sigma = stiffness depth max(0, 1 + damping edot), never pulling
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440, exponent one
 *
 * 1 deformations, 0 slips
 * p (3):
 *   gap (1) [m or rad]: deformation at which it is touched
 *   stiffness (1) [N/m or N m/rad]: stiffness once touched
 *   damping (1) [s/m or s/rad]: loss relative to the elastic force, for unit rate */

/* law: 14 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (3)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void stop_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_ = ed[0 * 8 + j];
            const real damping = p[2 * 8 + j];
            const real e_ = e[0 * 8 + j];
            const real gap = p[0 * 8 + j];
            const real t0 = e_ - gap;
            const real t1 = real_max(0.0, t0);
            const real stiffness = p[1 * 8 + j];
            const real t2 = stiffness * t1;
            const real t3 = real_max(0.0, 1.0 + ed_ * damping) * t2;
            sigma[0 * 8 + j] = t3;
            U[0 * 8 + j] = 0.5 * t1 * t2;
            P[0 * 8 + j] = ed_ * (t3 - (real_le(t0, 0.0) ? 0.0 : 1.0) * t2);
        }
    }
}

/* tangent: 14 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (3)
 * out: J (1,2) */
FLEXEL_CLONES
static void stop_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict J = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_ = e[0 * 8 + j];
            const real gap = p[0 * 8 + j];
            const real t0 = e_ - gap;
            const real ed_ = ed[0 * 8 + j];
            const real damping = p[2 * 8 + j];
            const real t1 = 1.0 + ed_ * damping;
            const real stiffness = p[1 * 8 + j];
            J[0 * 8 + j] = stiffness * real_max(0.0, t1) * (real_le(t0, 0.0) ? 0.0 : 1.0); /* J(0,0) */
            const real t2 = stiffness * real_max(0.0, t0) * (real_le(t1, 0.0) ? 0.0 : 1.0);
            J[1 * 8 + j] = damping * t2; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_stop = {
    .name = "stop",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 3,
    .law = stop_law,
    .tangent = stop_tangent,
};

/* vertical_tyre
 *
 * sigma = Fz
 * Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0
 *
 * Source: point-contact tyre with lift-off
 *
 * 1 deformations, 0 slips
 * p (2):
 *   stiffness (1) [N/m]: vertical stiffness
 *   damping (1) [N s/m]: vertical damping while the tyre is pressed */

/* law: 13 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (2)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void vertical_tyre_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (2 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = deflection * stiffness;
            const real Fz = real_lt(0.0, deflection) ? real_max(0.0, deflection_rate * damping + t0) : 0.0;
            sigma[0 * 8 + j] = Fz;
            U[0 * 8 + j] = real_lt(0.0, deflection) ? 0.5 * deflection * t0 : 0.0;
            P[0 * 8 + j] = deflection_rate * Fz - (real_lt(0.0, deflection) ? deflection_rate * t0 : 0.0);
        }
    }
}

/* tangent: 9 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (2)
 * out: J (1,2) */
FLEXEL_CLONES
static void vertical_tyre_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (2 * 8);
        real *restrict J = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = real_le(deflection_rate * damping + deflection * stiffness, 0.0) ? 0.0 : 1.0;
            const real t1 = real_lt(0.0, deflection) ? t0 : 0.0;
            J[0 * 8 + j] = stiffness * t1; /* J(0,0) */
            J[1 * 8 + j] = damping * t1; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_vertical_tyre = {
    .name = "vertical_tyre",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 2,
    .law = vertical_tyre_law,
    .tangent = vertical_tyre_tangent,
};

/* linear_tyre
 *
 * Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0
 * slip angle alpha = atan(sideways/max(|forward|, standstill)), of the wheel's centre
 * tau(lateral) = -fade Fy, tau(spin) = -fade Mz;  fade = 3 u^2 - 2 u^3, u = min(1, |forward|/standstill)
 * Fy = -cornering alpha - camber_stiffness camber while pressed, whatever the load;  Mz = -trail Fy
 *
 * Source: Frik, Leister, Schwartz 1993, Vehicle System Dynamics 22 suppl., linear tyre
 *
 * 2 deformations, 4 slips
 * p (6):
 *   stiffness (1) [N/m]: vertical stiffness
 *   damping (1) [N s/m]: vertical damping while the tyre is pressed
 *   cornering (1) [N/rad]: cornering stiffness
 *   camber_stiffness (1) [N/rad]: camber stiffness
 *   trail (1) [m]: pneumatic trail
 *   standstill (1) [m/s]: forward speed below which side forces fade out */

/* law: 37 operations.
 * in:  e (2), ed (2), s (4), z (0), t (1), p (6)
 * out: sigma (2), 1 of 2 entries, tau (4), 2 of 4 entries, zd (0), U (1), P (1) */
FLEXEL_CLONES
static void linear_tyre_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict s = in[2] + b * (4 * 8);
        const real *restrict p = in[5] + b * (6 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict tau = out[1] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real fade[8], t1[8], tan_alpha[8], t2[8], t5[8], t6[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = deflection * stiffness;
            const real Fz = real_lt(0.0, deflection) ? real_max(0.0, deflection_rate * damping + t0) : 0.0;
            sigma[0 * 8 + j] = Fz;
            const real forward = s[0 * 8 + j];
            const real speed = real_abs(forward);
            const real standstill = p[5 * 8 + j];
            const real u = real_min(1.0, 1.0 / standstill * speed);
            fade[j] = u * u * (3.0 - 2.0 * u);
            const real camber = e[1 * 8 + j];
            const real camber_stiffness = p[3 * 8 + j];
            t1[j] = camber * camber_stiffness;
            const real sideways = s[1 * 8 + j];
            tan_alpha[j] = 1.0 / real_max(standstill, speed) * sideways;
            U[0 * 8 + j] = real_lt(0.0, deflection) ? 0.5 * deflection * t0 : 0.0;
            t5[j] = deflection_rate * Fz;
            t6[j] = real_lt(0.0, deflection) ? deflection_rate * t0 : 0.0;
        }
        for (size_t j = 0; j < 8; j++) {
            t2[j] = real_atan(tan_alpha[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real cornering = p[2 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real Fy = real_lt(0.0, deflection) ? -(t1[j] + cornering * t2[j]) : 0.0;
            const real t3 = fade[j] * Fy;
            tau[0 * 8 + j] = -t3;
            const real trail = p[4 * 8 + j];
            const real t4 = trail * t3;
            tau[1 * 8 + j] = t4;
            const real spin = s[3 * 8 + j];
            const real lateral = s[2 * 8 + j];
            P[0 * 8 + j] = t5[j] + spin * t4 - lateral * t3 - t6[j];
        }
    }
}

/* tangent: 65 operations.
 * in:  e (2), ed (2), s (4), z (0), t (1), p (6)
 * out: J (6,8), 8 of 48 entries */
FLEXEL_CLONES
static void linear_tyre_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict s = in[2] + b * (4 * 8);
        const real *restrict p = in[5] + b * (6 * 8);
        real *restrict J = out[0] + b * (8 * 8);
        real t8[8], tan_alpha[8], t10[8], t12[8], t17[8], t20[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = real_le(deflection_rate * damping + deflection * stiffness, 0.0) ? 0.0 : 1.0;
            const real t1 = real_lt(0.0, deflection) ? 1.0 : 0.0;
            const real t2 = t0 * t1;
            J[0 * 8 + j] = stiffness * t2; /* J(0,0) */
            J[1 * 8 + j] = damping * t2; /* J(0,2) */
            const real forward = s[0 * 8 + j];
            const real speed = real_abs(forward);
            const real standstill = p[5 * 8 + j];
            const real t3 = 1.0 / standstill;
            const real t4 = speed * t3;
            const real u = real_min(1.0, t4);
            const real t5 = u * u;
            const real t6 = 3.0 - 2.0 * u;
            const real fade = t5 * t6;
            const real t7 = fade * t1;
            const real camber_stiffness = p[3 * 8 + j];
            J[2 * 8 + j] = camber_stiffness * t7; /* J(4,1) */
            const real camber = e[1 * 8 + j];
            t8[j] = camber * camber_stiffness;
            const real t9 = 1.0 / real_max(standstill, speed);
            const real sideways = s[1 * 8 + j];
            tan_alpha[j] = sideways * t9;
            const real t11 = real_lt(forward, 0.0) ? -1.0 : 1.0;
            t12[j] = t3 * t11 * (real_le(1.0, t4) ? 0.0 : 1.0) * (u * t6 - t5);
            const real cornering = p[2 * 8 + j];
            const real t14 = 1.0 / (1.0 + tan_alpha[j] * tan_alpha[j]) * cornering;
            const real t15 = t11 * t14 * sideways * (real_le(speed, standstill) ? 0.0 : 1.0);
            const real t16 = t9 * t15 * t9;
            t17[j] = t7 * t16;
            const real t18 = t9 * t14;
            J[4 * 8 + j] = t7 * t18; /* J(4,5) */
            const real trail = p[4 * 8 + j];
            const real t19 = trail * t7;
            J[5 * 8 + j] = -(camber_stiffness * t19); /* J(5,1) */
            t20[j] = t19 * t16;
            J[7 * 8 + j] = -(t18 * t19); /* J(5,5) */
        }
        for (size_t j = 0; j < 8; j++) {
            t10[j] = real_atan(tan_alpha[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real cornering = p[2 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real Fy = real_lt(0.0, deflection) ? -(t8[j] + cornering * t10[j]) : 0.0;
            const real t13 = Fy * t12[j];
            J[3 * 8 + j] = -(2.0 * t13 + t17[j]); /* J(4,4) */
            const real trail = p[4 * 8 + j];
            J[6 * 8 + j] = 2.0 * trail * t13 + t20[j]; /* J(5,4) */
        }
    }
}

const flexel_law flexel_law_linear_tyre = {
    .name = "linear_tyre",
    .digest = "c9cb37880850cb4e",
    .m = 2,
    .k = 4,
    .nz = 0,
    .np = 6,
    .law = linear_tyre_law,
    .tangent = linear_tyre_tangent,
};

/* calspan_tyre
 *
 * Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0
 * slip angle alpha = atan(sideways/max(|forward|, standstill)), of the wheel's centre
 * tau(lateral) = -fade Fy, tau(spin) = -fade Mz;  fade = 3 u^2 - 2 u^3, u = min(1, |forward|/standstill)
 * F = min(Fz, A2): beyond the load A2 the data end, friction and stiffnesses keep their values there
 * mu = SN (B1 F + B3 + B4 F^2),  C_alpha = A0 + A1 F (1 - F/A2),  C_gamma = A3 F (1 - F/A4)
 * slip = -(C_alpha alpha + C_gamma camber)/(mu Fz), at most 3
 * Fy = mu Fz (slip - slip |slip|/3 + slip^3/27),  Mz = (AF1 Fz + AF2 |Fy|) Fy,  Fx = 0
 *
 * Source: CALSPAN tyre as in Frik, Leister, Schwartz 1993, Vehicle System Dynamics 22 suppl.
 *
 * 2 deformations, 4 slips
 * p (14):
 *   stiffness (1) [N/m]: vertical stiffness
 *   damping (1) [N s/m]: vertical damping while the tyre is pressed
 *   A (5) [N/rad, 1/rad, N, 1/rad, N]: A0 ... A4: cornering and camber stiffness over the load
 *   B (3) [1/N, 1, 1/N^2]: B1, B3, B4: friction over the load
 *   SN (1) [1]: skid number of the road relative to that of the test
 *   AF (2) [m/N]: AF1, AF2: aligning moment
 *   standstill (1) [m/s]: forward speed below which side forces fade out */

/* law: 75 operations.
 * in:  e (2), ed (2), s (4), z (0), t (1), p (14)
 * out: sigma (2), 1 of 2 entries, tau (4), 2 of 4 entries, zd (0), U (1), P (1) */
FLEXEL_CLONES
static void calspan_tyre_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict s = in[2] + b * (4 * 8);
        const real *restrict p = in[5] + b * (14 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict tau = out[1] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real Fz[8], fade[8], mu[8], tan_alpha[8], t1[8], C_alpha[8], t2[8], t3[8], t6[8], t8[8], t9[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = deflection * stiffness;
            Fz[j] = real_lt(0.0, deflection) ? real_max(0.0, deflection_rate * damping + t0) : 0.0;
            sigma[0 * 8 + j] = Fz[j];
            const real forward = s[0 * 8 + j];
            const real speed = real_abs(forward);
            const real standstill = p[13 * 8 + j];
            const real u = real_min(1.0, 1.0 / standstill * speed);
            fade[j] = u * u * (3.0 - 2.0 * u);
            const real A_2 = p[4 * 8 + j];
            const real within = real_min(A_2, Fz[j]);
            const real B_4 = p[9 * 8 + j];
            const real B_1 = p[7 * 8 + j];
            const real B_3 = p[8 * 8 + j];
            const real SN = p[10 * 8 + j];
            mu[j] = SN * (B_3 + within * (B_1 + B_4 * within));
            const real sideways = s[1 * 8 + j];
            tan_alpha[j] = 1.0 / real_max(standstill, speed) * sideways;
            const real A_1 = p[3 * 8 + j];
            const real A_0 = p[2 * 8 + j];
            C_alpha[j] = A_0 + A_1 * within * (1.0 - 1.0 / A_2 * within);
            const real A_4 = p[6 * 8 + j];
            const real A_3 = p[5 * 8 + j];
            const real C_gamma = A_3 * within * (1.0 - 1.0 / A_4 * within);
            const real camber = e[1 * 8 + j];
            t2[j] = camber * C_gamma;
            t3[j] = 1.0 / real_max(Fz[j], 0.001) * (1.0 / mu[j]);
            const real AF_1 = p[11 * 8 + j];
            t6[j] = AF_1 * Fz[j];
            U[0 * 8 + j] = real_lt(0.0, deflection) ? 0.5 * deflection * t0 : 0.0;
            t8[j] = deflection_rate * Fz[j];
            t9[j] = real_lt(0.0, deflection) ? deflection_rate * t0 : 0.0;
        }
        for (size_t j = 0; j < 8; j++) {
            t1[j] = real_atan(tan_alpha[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real slip = real_max(-3.0, real_min(3.0, -((t1[j] * C_alpha[j] + t2[j]) * t3[j])));
            const real t4 = 1.0 + 0.037037037037037035 * (slip * slip) - 0.3333333333333333 * real_abs(slip);
            const real Fy = slip * t4 * Fz[j] * mu[j];
            const real t5 = fade[j] * Fy;
            tau[0 * 8 + j] = -t5;
            const real AF_2 = p[12 * 8 + j];
            const real Mz = Fy * (t6[j] + AF_2 * real_abs(Fy));
            const real t7 = fade[j] * Mz;
            tau[1 * 8 + j] = -t7;
            const real lateral = s[2 * 8 + j];
            const real spin = s[3 * 8 + j];
            P[0 * 8 + j] = t8[j] - lateral * t5 - spin * t7 - t9[j];
        }
    }
}

/* tangent: 179 operations.
 * in:  e (2), ed (2), s (4), z (0), t (1), p (14)
 * out: J (6,8), 12 of 48 entries */
FLEXEL_CLONES
static void calspan_tyre_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict s = in[2] + b * (4 * 8);
        const real *restrict p = in[5] + b * (14 * 8);
        real *restrict J = out[0] + b * (12 * 8);
        real t1[8], fade[8], t8[8], t9[8], t10[8], t11[8], t12[8], tan_alpha[8], t13[8], C_alpha[8], C_gamma[8],
            t18[8], t28[8], t32[8], t34[8], t35[8], t36[8], t37[8], t43[8], t44[8], t45[8], t46[8], t50[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = deflection_rate * damping + deflection * stiffness;
            t1[j] = (real_le(t0, 0.0) ? 0.0 : 1.0) * (real_lt(0.0, deflection) ? 1.0 : 0.0);
            J[0 * 8 + j] = stiffness * t1[j]; /* J(0,0) */
            J[1 * 8 + j] = damping * t1[j]; /* J(0,2) */
            const real forward = s[0 * 8 + j];
            const real speed = real_abs(forward);
            const real standstill = p[13 * 8 + j];
            const real t2 = 1.0 / standstill;
            const real t3 = speed * t2;
            const real u = real_min(1.0, t3);
            const real t4 = u * u;
            const real t5 = 3.0 - 2.0 * u;
            fade[j] = t4 * t5;
            const real Fz = real_lt(0.0, deflection) ? real_max(0.0, t0) : 0.0;
            const real A_2 = p[4 * 8 + j];
            const real within = real_min(A_2, Fz);
            const real B_4 = p[9 * 8 + j];
            const real t6 = B_4 * within;
            const real B_1 = p[7 * 8 + j];
            const real B_3 = p[8 * 8 + j];
            const real SN = p[10 * 8 + j];
            const real mu = SN * (B_3 + within * (B_1 + t6));
            const real t7 = SN * (B_1 + 2.0 * t6);
            t8[j] = (real_le(A_2, Fz) ? 0.0 : 1.0) * t1[j];
            t9[j] = mu * t1[j] + Fz * t7 * t8[j];
            t10[j] = 1.0 / real_max(Fz, 0.001);
            t11[j] = 1.0 / mu;
            t12[j] = 1.0 / real_max(standstill, speed);
            const real sideways = s[1 * 8 + j];
            tan_alpha[j] = sideways * t12[j];
            const real t14 = 1.0 / A_2 * within;
            const real t15 = 1.0 - t14;
            const real A_1 = p[3 * 8 + j];
            const real A_0 = p[2 * 8 + j];
            C_alpha[j] = A_0 + A_1 * t15 * within;
            const real A_4 = p[6 * 8 + j];
            const real t16 = 1.0 / A_4 * within;
            const real t17 = 1.0 - t16;
            const real A_3 = p[5 * 8 + j];
            C_gamma[j] = A_3 * t17 * within;
            const real camber = e[1 * 8 + j];
            t18[j] = camber * C_gamma[j];
            t28[j] = Fz * mu;
            t32[j] = real_le(0.001, Fz) ? 1.0 : 0.0;
            t34[j] = t11[j] * t7 * t11[j];
            t35[j] = t15 - t14;
            t36[j] = camber * A_3 * (t17 - t16);
            t37[j] = t10[j] * t11[j];
            t43[j] = real_lt(forward, 0.0) ? -1.0 : 1.0;
            t44[j] = t2 * t43[j] * (real_le(1.0, t3) ? 0.0 : 1.0) * (u * t5 - t4);
            t45[j] = 1.0 / (1.0 + tan_alpha[j] * tan_alpha[j]) * C_alpha[j];
            t46[j] = real_le(speed, standstill) ? 0.0 : 1.0;
            const real AF_1 = p[11 * 8 + j];
            t50[j] = AF_1 * Fz;
        }
        for (size_t j = 0; j < 8; j++) {
            t13[j] = real_atan(tan_alpha[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t19 = t13[j] * C_alpha[j] + t18[j];
            const real t20 = t11[j] * t19;
            const real t21 = -(t10[j] * t20);
            const real t22 = real_min(3.0, t21);
            const real slip = real_max(-3.0, t22);
            const real t23 = slip * slip;
            const real t24 = real_abs(slip);
            const real t25 = 1.0 + 0.037037037037037035 * t23 - 0.3333333333333333 * t24;
            const real t26 = slip * t25;
            const real t27 = t9[j] * t26;
            const real t29 = 0.3333333333333333 * (t24 + slip * (real_lt(slip, 0.0) ? -1.0 : 1.0));
            const real t30 = t28[j] * (1.0 + 0.1111111111111111 * t23 - t29);
            const real t31 = fade[j] * t30;
            const real t33 = (real_le(3.0, t21) ? 0.0 : 1.0) * (real_le(t22, -3.0) ? 0.0 : 1.0);
            const real A_1 = p[3 * 8 + j];
            const real t38 = t37[j] * t33;
            const real t39 = t19 * t34[j] * t10[j] * t33 - (A_1 * t13[j] * t35[j] + t36[j]) * t38;
            const real t40 = t10[j] * t33 * t10[j] * t32[j] * t1[j] * t20 + t8[j] * t39;
            const real t41 = fade[j] * t27 + t31 * t40;
            const real stiffness = p[0 * 8 + j];
            J[2 * 8 + j] = -(stiffness * t41); /* J(4,0) */
            const real t42 = C_gamma[j] * t38;
            J[3 * 8 + j] = t42 * t31; /* J(4,1) */
            const real damping = p[1 * 8 + j];
            J[4 * 8 + j] = -(damping * t41); /* J(4,2) */
            const real Fy = t28[j] * t26;
            const real t47 = t12[j] * t38;
            const real sideways = s[1 * 8 + j];
            const real t48 = t12[j] * t47 * t46[j] * sideways * t43[j] * t45[j];
            J[5 * 8 + j] = -(2.0 * t44[j] * Fy + t48 * t31); /* J(4,4) */
            const real t49 = t45[j] * t47;
            J[6 * 8 + j] = t49 * t31; /* J(4,5) */
            const real AF_2 = p[12 * 8 + j];
            const real t51 = t50[j] + AF_2 * real_abs(Fy);
            const real t52 = fade[j] * Fy;
            const real t53 = fade[j] * t51 + AF_2 * (real_lt(Fy, 0.0) ? -1.0 : 1.0) * t52;
            const real t54 = t30 * t53;
            const real AF_1 = p[11 * 8 + j];
            const real t55 = t54 * t40 + AF_1 * t52 * t1[j] + t53 * t27;
            J[7 * 8 + j] = -(stiffness * t55); /* J(5,0) */
            J[8 * 8 + j] = t42 * t54; /* J(5,1) */
            J[9 * 8 + j] = -(damping * t55); /* J(5,2) */
            const real Mz = Fy * t51;
            J[10 * 8 + j] = -(2.0 * t44[j] * Mz + t48 * t54); /* J(5,4) */
            J[11 * 8 + j] = t49 * t54; /* J(5,5) */
        }
    }
}

const flexel_law flexel_law_calspan_tyre = {
    .name = "calspan_tyre",
    .digest = "c9cb37880850cb4e",
    .m = 2,
    .k = 4,
    .nz = 0,
    .np = 14,
    .law = calspan_tyre_law,
    .tangent = calspan_tyre_tangent,
};

/* magic_formula
 *
 * Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0
 * lx kappadot = Re rolling - forward - |forward| kappa
 * ly (tan alpha)dot = lateral - |forward| tan alpha,  lateral of the contact point
 * mu = mu0 + mu1 min(1, Fz/Fz0 - 1),  Kx = kx Fz,  Ky = c1 Fz0 sin(2 atan(Fz/(c2 Fz0))),  Kg = kg Fz
 * x = Kx kappa/(mu Fz),  y = (Ky tan alpha + Kg camber)/(mu Fz),  slip = |(x, y)|,  b = slip/C
 * (Fx, Fy) = mu Fz sin(C atan(b - E (b - atan b))) (x, -y)/slip, combined slip by similarity
 * Mz = -t0 Fz/Fz0 cos(atan(B tan alpha)) Fy;  tau(longitudinal, lateral, spin) = -(Fx, Fy, Mz)
 *
 * Source: Pacejka, Tyre and Vehicle Dynamics, similarity method and single contact point transient model
 *
 * 2 deformations, 5 slips, z: kappa [1], tan_alpha [1]
 * p (16):
 *   stiffness (1) [N/m]: vertical stiffness
 *   damping (1) [N s/m]: vertical damping while the tyre is pressed
 *   load0 (1) [N]: nominal load Fz0
 *   rolling_radius (1) [m]: effective radius of free rolling
 *   friction (2) [1]: mu at the nominal load, and its change for one more nominal load
 *   slip_stiffness (1) [1]: longitudinal stiffness Kx relative to the load
 *   cornering (2) [1]: largest cornering stiffness over load0, and the load of it over load0
 *   camber_stiffness (1) [1/rad]: camber stiffness relative to the load
 *   shape (2) [1]: C and E of the sine of the Magic Formula
 *   trail (2) [m, 1]: pneumatic trail at the nominal load, and how it falls with the slip (B)
 *   relaxation (2) [m]: relaxation lengths, longitudinal and lateral */

/* law: 86 operations.
 * in:  e (2), ed (2), s (5), z (2), t (1), p (16)
 * out: sigma (2), 1 of 2 entries, tau (5), 3 of 5 entries, zd (2), U (1), P (1) */
FLEXEL_CLONES
static void magic_formula_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict s = in[2] + b * (5 * 8);
        const real *restrict z = in[3] + b * (2 * 8);
        const real *restrict p = in[5] + b * (16 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict tau = out[1] + b * (3 * 8);
        real *restrict zd = out[2] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real Fz[8], mu[8], t3[8], slip_x[8], t4[8], t5[8], t6[8], t7[8], t8[8], t9[8], slip_y[8], t10[8], t11[8],
            b_[8], t12[8], t13[8], t14[8], t15[8], t16[8], t19[8], t21[8], t22[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = deflection * stiffness;
            Fz[j] = real_lt(0.0, deflection) ? real_max(0.0, deflection_rate * damping + t0) : 0.0;
            sigma[0 * 8 + j] = Fz[j];
            const real load0 = p[2 * 8 + j];
            const real t1 = 1.0 / load0;
            const real t2 = Fz[j] * t1;
            const real excess = real_min(1.0, t2 - 1.0);
            const real friction_1 = p[5 * 8 + j];
            const real friction_0 = p[4 * 8 + j];
            mu[j] = friction_0 + friction_1 * excess;
            const real limit = mu[j] * real_max(Fz[j], 0.001);
            t3[j] = 1.0 / limit;
            const real slip_stiffness = p[6 * 8 + j];
            const real kappa = z[0 * 8 + j];
            slip_x[j] = slip_stiffness * t3[j] * kappa * Fz[j];
            t4[j] = slip_x[j] * slip_x[j];
            const real cornering_1 = p[8 * 8 + j];
            t5[j] = 1.0 / cornering_1 * t2;
            const real camber = e[1 * 8 + j];
            const real camber_stiffness = p[9 * 8 + j];
            t9[j] = camber * camber_stiffness * Fz[j];
            const real shape_0 = p[10 * 8 + j];
            t11[j] = 1.0 / shape_0;
            const real trail_0 = p[12 * 8 + j];
            const real tan_alpha = z[1 * 8 + j];
            const real trail_1 = p[13 * 8 + j];
            const real t18 = real_sqrt(1.0 + tan_alpha * tan_alpha * trail_1 * trail_1);
            t19[j] = trail_0 * t1 * (1.0 / t18) * Fz[j];
            const real relaxation_0 = p[14 * 8 + j];
            const real rolling = s[1 * 8 + j];
            const real rolling_radius = p[3 * 8 + j];
            const real forward = s[0 * 8 + j];
            const real speed = real_abs(forward);
            zd[0 * 8 + j] = 1.0 / relaxation_0 * (rolling * rolling_radius - forward - kappa * speed);
            const real relaxation_1 = p[15 * 8 + j];
            const real lateral = s[3 * 8 + j];
            zd[1 * 8 + j] = 1.0 / relaxation_1 * (lateral - tan_alpha * speed);
            U[0 * 8 + j] = real_lt(0.0, deflection) ? 0.5 * deflection * t0 : 0.0;
            t21[j] = deflection_rate * Fz[j];
            t22[j] = real_lt(0.0, deflection) ? deflection_rate * t0 : 0.0;
        }
        for (size_t j = 0; j < 8; j++) {
            t6[j] = real_atan(t5[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            t7[j] = 2.0 * t6[j];
        }
        for (size_t j = 0; j < 8; j++) {
            t8[j] = real_sin(t7[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real load0 = p[2 * 8 + j];
            const real cornering_0 = p[7 * 8 + j];
            const real Ky = load0 * t8[j] * cornering_0;
            const real tan_alpha = z[1 * 8 + j];
            slip_y[j] = t3[j] * (tan_alpha * Ky + t9[j]);
            const real slip = real_sqrt(1e-16 + slip_y[j] * slip_y[j] + t4[j]);
            t10[j] = 1.0 / slip;
            b_[j] = t11[j] * slip;
        }
        for (size_t j = 0; j < 8; j++) {
            t12[j] = real_atan(b_[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real shape_1 = p[11 * 8 + j];
            t13[j] = b_[j] - shape_1 * (b_[j] - t12[j]);
        }
        for (size_t j = 0; j < 8; j++) {
            t14[j] = real_atan(t13[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real shape_0 = p[10 * 8 + j];
            t15[j] = shape_0 * t14[j];
        }
        for (size_t j = 0; j < 8; j++) {
            t16[j] = real_sin(t15[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real share = t10[j] * t16[j] * Fz[j] * mu[j];
            const real Fx = slip_x[j] * share;
            tau[0 * 8 + j] = -Fx;
            const real t17 = slip_y[j] * share;
            tau[1 * 8 + j] = t17;
            const real t20 = t17 * t19[j];
            tau[2 * 8 + j] = -t20;
            const real lateral = s[3 * 8 + j];
            const real longitudinal = s[2 * 8 + j];
            const real spin = s[4 * 8 + j];
            P[0 * 8 + j] = t21[j] + lateral * t17 - longitudinal * Fx - spin * t20 - t22[j];
        }
    }
}

/* tangent: 205 operations.
 * in:  e (2), ed (2), s (5), z (2), t (1), p (16)
 * out: J (9,11), 23 of 99 entries */
FLEXEL_CLONES
static void magic_formula_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict s = in[2] + b * (5 * 8);
        const real *restrict z = in[3] + b * (2 * 8);
        const real *restrict p = in[5] + b * (16 * 8);
        real *restrict J = out[0] + b * (23 * 8);
        real t1[8], t2[8], Fz[8], t6[8], slip_x[8], t8[8], t10[8], t11[8], t12[8], t13[8], t14[8], t15[8], t16[8],
            slip_y[8], b_[8], t18[8], t19[8], t20[8], t21[8], t22[8], t23[8], t24[8], t25[8], t28[8], t29[8], t30[8],
            t31[8], t33[8], t34[8], t35[8], t37[8], t38[8], t40[8], t42[8], t43[8], t45[8], t48[8], t50[8], t52[8],
            t57[8], t59[8], t61[8], t63[8], t65[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real deflection_rate = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real deflection = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real t0 = deflection_rate * damping + deflection * stiffness;
            t1[j] = (real_le(t0, 0.0) ? 0.0 : 1.0) * (real_lt(0.0, deflection) ? 1.0 : 0.0);
            J[0 * 8 + j] = stiffness * t1[j]; /* J(0,0) */
            J[1 * 8 + j] = damping * t1[j]; /* J(0,2) */
            const real shape_0 = p[10 * 8 + j];
            t2[j] = 1.0 / shape_0;
            Fz[j] = real_lt(0.0, deflection) ? real_max(0.0, t0) : 0.0;
            const real load0 = p[2 * 8 + j];
            const real t3 = 1.0 / load0;
            const real t4 = Fz[j] * t3 - 1.0;
            const real excess = real_min(1.0, t4);
            const real friction_1 = p[5 * 8 + j];
            const real friction_0 = p[4 * 8 + j];
            const real mu = friction_0 + friction_1 * excess;
            const real t5 = real_max(Fz[j], 0.001);
            const real limit = mu * t5;
            t6[j] = 1.0 / limit;
            const real kappa = z[0 * 8 + j];
            const real t7 = kappa * Fz[j];
            const real slip_stiffness = p[6 * 8 + j];
            slip_x[j] = slip_stiffness * t7 * t6[j];
            t8[j] = 1e-16 + slip_x[j] * slip_x[j];
            const real cornering_1 = p[8 * 8 + j];
            const real t9 = 1.0 / cornering_1 * t3;
            t10[j] = Fz[j] * t9;
            const real cornering_0 = p[7 * 8 + j];
            t14[j] = load0 * cornering_0;
            const real camber = e[1 * 8 + j];
            const real camber_stiffness = p[9 * 8 + j];
            t15[j] = camber * camber_stiffness;
            t16[j] = Fz[j] * t15[j];
            t23[j] = Fz[j] * mu;
            const real t27 = friction_1 * (real_le(1.0, t4) ? 0.0 : 1.0) * t3;
            t28[j] = t6[j] * t6[j] * (mu * (real_le(0.001, Fz[j]) ? 1.0 : 0.0) + t5 * t27);
            t29[j] = kappa * t6[j] - t7 * t28[j];
            t30[j] = t1[j] * t29[j];
            t31[j] = mu + Fz[j] * t27;
            t37[j] = slip_stiffness * slip_x[j];
            t43[j] = 1.0 / (1.0 + t10[j] * t10[j]) * t9;
            t48[j] = camber_stiffness * Fz[j] * t6[j];
            t50[j] = Fz[j] * t6[j];
            const real tan_alpha = z[1 * 8 + j];
            const real trail_1 = p[13 * 8 + j];
            const real t55 = trail_1 * trail_1;
            const real t56 = 1.0 / real_sqrt(1.0 + tan_alpha * tan_alpha * t55);
            const real trail_0 = p[12 * 8 + j];
            t57[j] = trail_0 * t3;
            const real t58 = t56 * t57[j];
            t59[j] = Fz[j] * t58;
            t63[j] = t1[j] * t58;
            t65[j] = t56 * t56 * t55 * tan_alpha * t56;
            const real relaxation_0 = p[14 * 8 + j];
            const real t66 = 1.0 / relaxation_0;
            const real forward = s[0 * 8 + j];
            const real t67 = real_lt(forward, 0.0) ? -1.0 : 1.0;
            J[17 * 8 + j] = -(t66 * (1.0 + kappa * t67)); /* J(7,4) */
            const real rolling_radius = p[3 * 8 + j];
            J[18 * 8 + j] = rolling_radius * t66; /* J(7,5) */
            const real speed = real_abs(forward);
            J[19 * 8 + j] = -(speed * t66); /* J(7,9) */
            const real relaxation_1 = p[15 * 8 + j];
            const real t68 = 1.0 / relaxation_1;
            J[21 * 8 + j] = t68; /* J(8,7) */
            J[20 * 8 + j] = -(tan_alpha * t68 * t67); /* J(8,4) */
            J[22 * 8 + j] = -(speed * t68); /* J(8,10) */
        }
        for (size_t j = 0; j < 8; j++) {
            t11[j] = real_atan(t10[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            t12[j] = 2.0 * t11[j];
        }
        for (size_t j = 0; j < 8; j++) {
            t13[j] = real_sin(t12[j]);
            t42[j] = real_cos(t12[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real Ky = t13[j] * t14[j];
            const real tan_alpha = z[1 * 8 + j];
            const real t17 = tan_alpha * Ky + t16[j];
            slip_y[j] = t6[j] * t17;
            const real slip = real_sqrt(t8[j] + slip_y[j] * slip_y[j]);
            b_[j] = t2[j] * slip;
            t24[j] = 1.0 / slip;
            t25[j] = t23[j] * t24[j];
            const real shape_1 = p[11 * 8 + j];
            t33[j] = 1.0 - shape_1 * (1.0 - 1.0 / (1.0 + b_[j] * b_[j]));
            t38[j] = t24[j] * t37[j];
            t40[j] = slip_y[j] * t24[j];
            const real t44 = t6[j] * (t15[j] + 2.0 * t42[j] * t43[j] * tan_alpha * t14[j]);
            t45[j] = t1[j] * (t44 - t17 * t28[j]);
            t52[j] = Ky * t6[j];
            t61[j] = t59[j] * slip_y[j];
        }
        for (size_t j = 0; j < 8; j++) {
            t18[j] = real_atan(b_[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real shape_1 = p[11 * 8 + j];
            t19[j] = b_[j] - shape_1 * (b_[j] - t18[j]);
            t34[j] = 1.0 / (1.0 + t19[j] * t19[j]);
        }
        for (size_t j = 0; j < 8; j++) {
            t20[j] = real_atan(t19[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real shape_0 = p[10 * 8 + j];
            t21[j] = shape_0 * t20[j];
        }
        for (size_t j = 0; j < 8; j++) {
            t22[j] = real_sin(t21[j]);
            t35[j] = real_cos(t21[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real share = t22[j] * t25[j];
            const real slip_stiffness = p[6 * 8 + j];
            const real t26 = slip_stiffness * share;
            const real t32 = t24[j] * t22[j];
            const real shape_0 = p[10 * 8 + j];
            const real t36 = t25[j] * (t2[j] * t35[j] * shape_0 * t34[j] * t33[j] - t32);
            const real t39 = t36 * t38[j];
            const real t41 = t36 * t40[j];
            const real t46 = t1[j] * (t31[j] * t32 + t29[j] * t39) + t41 * t45[j];
            const real t47 = t26 * t30[j] + slip_x[j] * t46;
            const real stiffness = p[0 * 8 + j];
            J[2 * 8 + j] = -(stiffness * t47); /* J(4,0) */
            const real t49 = t48[j] * t41;
            J[3 * 8 + j] = -(slip_x[j] * t49); /* J(4,1) */
            const real damping = p[1 * 8 + j];
            J[4 * 8 + j] = -(damping * t47); /* J(4,2) */
            const real t51 = t50[j] * t39;
            J[5 * 8 + j] = -(t50[j] * t26 + slip_x[j] * t51); /* J(4,9) */
            const real t53 = t52[j] * t41;
            J[6 * 8 + j] = -(slip_x[j] * t53); /* J(4,10) */
            const real t54 = share * t45[j] + slip_y[j] * t46;
            J[7 * 8 + j] = stiffness * t54; /* J(5,0) */
            J[8 * 8 + j] = t48[j] * share + slip_y[j] * t49; /* J(5,1) */
            J[9 * 8 + j] = damping * t54; /* J(5,2) */
            J[10 * 8 + j] = slip_y[j] * t51; /* J(5,9) */
            J[11 * 8 + j] = t52[j] * share + slip_y[j] * t53; /* J(5,10) */
            const real t60 = t59[j] * share;
            const real t62 = slip_y[j] * share;
            const real t64 = t61[j] * t46 + t62 * t63[j] + t60 * t45[j];
            J[12 * 8 + j] = -(stiffness * t64); /* J(6,0) */
            J[13 * 8 + j] = -(t48[j] * t60 + t61[j] * t49); /* J(6,1) */
            J[14 * 8 + j] = -(damping * t64); /* J(6,2) */
            J[15 * 8 + j] = -(t61[j] * t51); /* J(6,9) */
            J[16 * 8 + j] = t62 * t65[j] * Fz[j] * t57[j] - t52[j] * t60 - t61[j] * t53; /* J(6,10) */
        }
    }
}

const flexel_law flexel_law_magic_formula = {
    .name = "magic_formula",
    .digest = "c9cb37880850cb4e",
    .m = 2,
    .k = 5,
    .nz = 2,
    .np = 16,
    .law = magic_formula_law,
    .tangent = magic_formula_tangent,
};

/* hertz
 *
 * d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N
 * energy = stiffness d^(exponent + 1)/(exponent + 1)
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369
 *
 * 1 deformations, 0 slips
 * p (3):
 *   stiffness (1) [N/m^exponent]: normal force per penetration^exponent
 *   exponent (1) [1]: exponent of the penetration, 3/2 for Hertz, at least 1
 *   dissipation (1) [s/m]: relative growth of the normal force per speed of approach */

/* law: 30 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (3)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void hertz_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real depth[8], t0[8], t1[8], t2[8], t3[8], t4[8], t5[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            const real exponent = p[1 * 8 + j];
            t2[j] = 1.0 / (1.0 + exponent);
            t3[j] = real_lt(e_0, 0.0) ? -ed_0 : 0.0;
            t4[j] = exponent - 1.0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t5[j] = real_pow(depth[j], t4[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real N = real_max(0.0, elastic * t1[j]);
            sigma[0 * 8 + j] = -N;
            U[0 * 8 + j] = -(e_0 * elastic * t2[j]);
            const real ed_0 = ed[0 * 8 + j];
            const real exponent = p[1 * 8 + j];
            const real t6 = real_lt(e_0, 0.0) ? exponent * t5[j] * t3[j] * stiffness : 0.0;
            P[0 * 8 + j] = t2[j] * (ed_0 * elastic + e_0 * t6) - ed_0 * N;
        }
    }
}

/* tangent: 22 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (3)
 * out: J (1,2) */
FLEXEL_CLONES
static void hertz_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict J = out[0] + b * (2 * 8);
        real t0[8], depth[8], t1[8], t2[8], t3[8], t4[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            t0[j] = real_lt(e_0, 0.0) ? 1.0 : 0.0;
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real exponent = p[1 * 8 + j];
            t1[j] = exponent - 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t3[j] = 1.0 - ed_0 * dissipation;
        }
        for (size_t j = 0; j < 8; j++) {
            t2[j] = real_pow(depth[j], t1[j]);
            const real exponent = p[1 * 8 + j];
            t4[j] = real_pow(depth[j], exponent);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t4[j] : 0.0;
            const real t5 = real_le(elastic * t3[j], 0.0) ? 0.0 : 1.0;
            J[0 * 8 + j] = exponent * t2[j] * (t3[j] * t5 * t0[j] * stiffness) * t0[j]; /* J(0,0) */
            const real dissipation = p[2 * 8 + j];
            J[1 * 8 + j] = elastic * t5 * dissipation; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_hertz = {
    .name = "hertz",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 3,
    .law = hertz_law,
    .tangent = hertz_tangent,
};

/* hertz_coulomb_1
 *
 * d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N
 * energy = stiffness d^(exponent + 1)/(exponent + 1)
 * tau = friction N s/sqrt(s.s + slip_speed^2)
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369;
 *   Coulomb's friction, regularized
 *
 * 1 deformations, 1 slips
 * p (5):
 *   stiffness (1) [N/m^exponent]: normal force per penetration^exponent
 *   exponent (1) [1]: exponent of the penetration, 3/2 for Hertz, at least 1
 *   dissipation (1) [s/m]: relative growth of the normal force per speed of approach
 *   friction (1) [1]: coefficient of friction
 *   slip_speed (1) [m/s]: speed of sliding at which 71 % of the friction acts */

/* law: 40 operations.
 * in:  e (1), ed (1), s (1), z (0), t (1), p (5)
 * out: sigma (1), tau (1), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void hertz_coulomb_1_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict tau = out[1] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real depth[8], t0[8], t1[8], t2[8], t4[8], t5[8], t6[8], t7[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            const real s_0 = s[0 * 8 + j];
            const real slip_speed = p[4 * 8 + j];
            t2[j] = 1.0 / real_sqrt(s_0 * s_0 + slip_speed * slip_speed);
            const real exponent = p[1 * 8 + j];
            t4[j] = 1.0 / (1.0 + exponent);
            t5[j] = real_lt(e_0, 0.0) ? -ed_0 : 0.0;
            t6[j] = exponent - 1.0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t7[j] = real_pow(depth[j], t6[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real N = real_max(0.0, elastic * t1[j]);
            sigma[0 * 8 + j] = -N;
            const real friction = p[3 * 8 + j];
            const real factor = N * t2[j] * friction;
            const real s_0 = s[0 * 8 + j];
            const real t3 = s_0 * factor;
            tau[0 * 8 + j] = t3;
            U[0 * 8 + j] = -(e_0 * elastic * t4[j]);
            const real ed_0 = ed[0 * 8 + j];
            const real exponent = p[1 * 8 + j];
            const real t8 = real_lt(e_0, 0.0) ? exponent * t7[j] * t5[j] * stiffness : 0.0;
            P[0 * 8 + j] = s_0 * t3 - ed_0 * N + t4[j] * (ed_0 * elastic + e_0 * t8);
        }
    }
}

/* tangent: 43 operations.
 * in:  e (1), ed (1), s (1), z (0), t (1), p (5)
 * out: J (2,3), 5 of 6 entries */
FLEXEL_CLONES
static void hertz_coulomb_1_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict J = out[0] + b * (5 * 8);
        real depth[8], t0[8], t1[8], t4[8], t5[8], t6[8], t9[8], t10[8], t12[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            t4[j] = real_lt(e_0, 0.0) ? 1.0 : 0.0;
            const real exponent = p[1 * 8 + j];
            t5[j] = exponent - 1.0;
            const real s_0 = s[0 * 8 + j];
            const real friction = p[3 * 8 + j];
            t9[j] = s_0 * friction;
            const real slip_speed = p[4 * 8 + j];
            t10[j] = 1.0 / real_sqrt(s_0 * s_0 + slip_speed * slip_speed);
            t12[j] = s_0 * t10[j] * (t10[j] * t10[j]);
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t6[j] = real_pow(depth[j], t5[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real t2 = elastic * t1[j];
            const real t3 = real_le(t2, 0.0) ? 0.0 : 1.0;
            const real exponent = p[1 * 8 + j];
            const real t7 = exponent * t6[j] * t4[j] * stiffness * t4[j] * t1[j];
            J[0 * 8 + j] = t3 * t7; /* J(0,0) */
            const real dissipation = p[2 * 8 + j];
            const real t8 = dissipation * elastic;
            J[1 * 8 + j] = t3 * t8; /* J(0,1) */
            const real t11 = t10[j] * t3 * t9[j];
            J[2 * 8 + j] = -(t7 * t11); /* J(1,0) */
            J[3 * 8 + j] = -(t8 * t11); /* J(1,1) */
            const real N = real_max(0.0, t2);
            const real friction = p[3 * 8 + j];
            const real factor = N * t10[j] * friction;
            J[4 * 8 + j] = factor - N * t12[j] * t9[j]; /* J(1,2) */
        }
    }
}

const flexel_law flexel_law_hertz_coulomb_1 = {
    .name = "hertz_coulomb_1",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 1,
    .nz = 0,
    .np = 5,
    .law = hertz_coulomb_1_law,
    .tangent = hertz_coulomb_1_tangent,
};

/* hertz_coulomb_2
 *
 * d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N
 * energy = stiffness d^(exponent + 1)/(exponent + 1)
 * tau = friction N s/sqrt(s.s + slip_speed^2)
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369;
 *   Coulomb's friction, regularized
 *
 * 1 deformations, 2 slips
 * p (5):
 *   stiffness (1) [N/m^exponent]: normal force per penetration^exponent
 *   exponent (1) [1]: exponent of the penetration, 3/2 for Hertz, at least 1
 *   dissipation (1) [s/m]: relative growth of the normal force per speed of approach
 *   friction (1) [1]: coefficient of friction
 *   slip_speed (1) [m/s]: speed of sliding at which 71 % of the friction acts */

/* law: 45 operations.
 * in:  e (1), ed (1), s (2), z (0), t (1), p (5)
 * out: sigma (1), tau (2), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void hertz_coulomb_2_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (2 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict tau = out[1] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real depth[8], t0[8], t1[8], t3[8], t6[8], t7[8], t8[8], t9[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            const real slip_speed = p[4 * 8 + j];
            const real s_0 = s[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real t2 = real_sqrt(s_0 * s_0 + s_1 * s_1 + slip_speed * slip_speed);
            t3[j] = 1.0 / t2;
            const real exponent = p[1 * 8 + j];
            t6[j] = 1.0 / (1.0 + exponent);
            t7[j] = real_lt(e_0, 0.0) ? -ed_0 : 0.0;
            t8[j] = exponent - 1.0;
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t9[j] = real_pow(depth[j], t8[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real N = real_max(0.0, elastic * t1[j]);
            sigma[0 * 8 + j] = -N;
            const real friction = p[3 * 8 + j];
            const real factor = N * t3[j] * friction;
            const real s_0 = s[0 * 8 + j];
            const real t4 = s_0 * factor;
            tau[0 * 8 + j] = t4;
            const real s_1 = s[1 * 8 + j];
            const real t5 = s_1 * factor;
            tau[1 * 8 + j] = t5;
            U[0 * 8 + j] = -(e_0 * elastic * t6[j]);
            const real ed_0 = ed[0 * 8 + j];
            const real exponent = p[1 * 8 + j];
            const real t10 = real_lt(e_0, 0.0) ? exponent * t9[j] * t7[j] * stiffness : 0.0;
            P[0 * 8 + j] = s_0 * t4 + s_1 * t5 - ed_0 * N + t6[j] * (ed_0 * elastic + e_0 * t10);
        }
    }
}

/* tangent: 58 operations.
 * in:  e (1), ed (1), s (2), z (0), t (1), p (5)
 * out: J (3,4), 10 of 12 entries */
FLEXEL_CLONES
static void hertz_coulomb_2_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (2 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict J = out[0] + b * (10 * 8);
        real depth[8], t0[8], t1[8], t4[8], t5[8], t6[8], t9[8], t11[8], t15[8], t19[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            t4[j] = real_lt(e_0, 0.0) ? 1.0 : 0.0;
            const real exponent = p[1 * 8 + j];
            t5[j] = exponent - 1.0;
            const real s_0 = s[0 * 8 + j];
            const real friction = p[3 * 8 + j];
            t9[j] = s_0 * friction;
            const real slip_speed = p[4 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real t10 = real_sqrt(s_0 * s_0 + s_1 * s_1 + slip_speed * slip_speed);
            t11[j] = 1.0 / t10;
            t15[j] = t11[j] * t11[j] * t11[j];
            t19[j] = s_1 * friction;
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t6[j] = real_pow(depth[j], t5[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real t2 = elastic * t1[j];
            const real t3 = real_le(t2, 0.0) ? 0.0 : 1.0;
            const real exponent = p[1 * 8 + j];
            const real t7 = exponent * t6[j] * t4[j] * stiffness * t4[j] * t1[j];
            J[0 * 8 + j] = t3 * t7; /* J(0,0) */
            const real dissipation = p[2 * 8 + j];
            const real t8 = dissipation * elastic;
            J[1 * 8 + j] = t3 * t8; /* J(0,1) */
            const real t12 = t11[j] * t3;
            const real t13 = t7 * t12;
            J[2 * 8 + j] = -(t9[j] * t13); /* J(1,0) */
            const real t14 = t8 * t12;
            J[3 * 8 + j] = -(t9[j] * t14); /* J(1,1) */
            const real N = real_max(0.0, t2);
            const real friction = p[3 * 8 + j];
            const real factor = N * t11[j] * friction;
            const real t16 = N * t15[j];
            const real s_0 = s[0 * 8 + j];
            const real t17 = s_0 * t16;
            J[4 * 8 + j] = factor - t9[j] * t17; /* J(1,2) */
            const real s_1 = s[1 * 8 + j];
            const real t18 = s_1 * t16;
            J[5 * 8 + j] = -(t9[j] * t18); /* J(1,3) */
            J[6 * 8 + j] = -(t19[j] * t13); /* J(2,0) */
            J[7 * 8 + j] = -(t19[j] * t14); /* J(2,1) */
            J[8 * 8 + j] = -(t19[j] * t17); /* J(2,2) */
            J[9 * 8 + j] = factor - t19[j] * t18; /* J(2,3) */
        }
    }
}

const flexel_law flexel_law_hertz_coulomb_2 = {
    .name = "hertz_coulomb_2",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 2,
    .nz = 0,
    .np = 5,
    .law = hertz_coulomb_2_law,
    .tangent = hertz_coulomb_2_tangent,
};

/* hertz_bristle_1
 *
 * d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N
 * energy = stiffness d^(exponent + 1)/(exponent + 1) + stiffness d^exponent bristle_stiffness z.z/2
 * dz/dt = s - bristle_stiffness |s| z/friction in contact, -release z when open
 * tau = N (bristle_stiffness z + bristle_damping dz/dt)
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369; Dahl
 *   1968; Canudas de Wit et al. 1995, IEEE Trans. Autom. Control 40:419
 *
 * 1 deformations, 1 slips, z: z_0 [m]
 * p (7):
 *   stiffness (1) [N/m^exponent]: normal force per penetration^exponent
 *   exponent (1) [1]: exponent of the penetration, 3/2 for Hertz, at least 1
 *   dissipation (1) [s/m]: relative growth of the normal force per speed of approach
 *   friction (1) [1]: coefficient of friction
 *   bristle_stiffness (1) [1/m]: friction per normal force and deflection of the bristles
 *   bristle_damping (1) [s/m]: friction per normal force and rate of deflection
 *   release (1) [1/s]: rate at which bristles straighten while the gap is open */

/* law: 60 operations.
 * in:  e (1), ed (1), s (1), z (1), t (1), p (7)
 * out: sigma (1), tau (1), zd (1), U (1), P (1) */
FLEXEL_CLONES
static void hertz_bristle_1_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict z = in[3] + b * (1 * 8);
        const real *restrict p = in[5] + b * (7 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict tau = out[1] + b * (1 * 8);
        real *restrict zd = out[2] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real depth[8], t0[8], t1[8], zd_0[8], t2[8], t4[8], t5[8], t6[8], t7[8], t8[8], t9[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            const real z_0 = z[0 * 8 + j];
            const real bristle_stiffness = p[4 * 8 + j];
            const real friction = p[3 * 8 + j];
            const real s_0 = s[0 * 8 + j];
            const real square = s_0 * s_0;
            const real safe = real_lt(0.0, square) ? square : 1.0;
            const real speed = real_lt(0.0, square) ? real_sqrt(safe) : 0.0;
            const real sliding = 1.0 / friction * (bristle_stiffness * speed);
            const real release = p[6 * 8 + j];
            zd_0[j] = real_lt(e_0, 0.0) ? s_0 - z_0 * sliding : -(z_0 * release);
            zd[0 * 8 + j] = zd_0[j];
            const real bristle_damping = p[5 * 8 + j];
            t2[j] = z_0 * bristle_stiffness + bristle_damping * zd_0[j];
            t4[j] = z_0 * z_0;
            const real exponent = p[1 * 8 + j];
            t5[j] = 1.0 / (1.0 + exponent);
            t6[j] = 0.5 * bristle_stiffness * t4[j] - e_0 * t5[j];
            t7[j] = exponent - 1.0;
            const real stiffness = p[0 * 8 + j];
            t9[j] = stiffness * (real_lt(e_0, 0.0) ? -ed_0 : 0.0) * exponent;
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t8[j] = real_pow(depth[j], t7[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real N = real_max(0.0, elastic * t1[j]);
            sigma[0 * 8 + j] = -N;
            const real t3 = N * t2[j];
            tau[0 * 8 + j] = t3;
            U[0 * 8 + j] = elastic * t6[j];
            const real s_0 = s[0 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real t10 = real_lt(e_0, 0.0) ? t8[j] * t9[j] : 0.0;
            const real t11 = s_0 * t3 + t5[j] * (ed_0 * elastic + e_0 * t10) - ed_0 * N;
            const real z_0 = z[0 * 8 + j];
            const real bristle_stiffness = p[4 * 8 + j];
            const real t12 = bristle_stiffness * (t4[j] * t10 + 2.0 * z_0 * elastic * zd_0[j]);
            P[0 * 8 + j] = t11 - 0.5 * t12;
        }
    }
}

/* tangent: 61 operations.
 * in:  e (1), ed (1), s (1), z (1), t (1), p (7)
 * out: J (3,4), 8 of 12 entries */
FLEXEL_CLONES
static void hertz_bristle_1_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict z = in[3] + b * (1 * 8);
        const real *restrict p = in[5] + b * (7 * 8);
        real *restrict J = out[0] + b * (8 * 8);
        real t0[8], depth[8], t1[8], t2[8], t3[8], t5[8], t12[8], t15[8], t17[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t0[j] = 1.0 - ed_0 * dissipation;
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real exponent = p[1 * 8 + j];
            t1[j] = exponent - 1.0;
            t3[j] = real_lt(e_0, 0.0) ? -1.0 : 0.0;
            const real s_0 = s[0 * 8 + j];
            const real square = s_0 * s_0;
            const real safe = real_lt(0.0, square) ? square : 1.0;
            const real t10 = real_sqrt(safe);
            const real speed = real_lt(0.0, square) ? t10 : 0.0;
            const real friction = p[3 * 8 + j];
            const real bristle_stiffness = p[4 * 8 + j];
            const real t11 = 1.0 / friction * bristle_stiffness;
            const real sliding = speed * t11;
            const real z_0 = z[0 * 8 + j];
            const real release = p[6 * 8 + j];
            const real zd_0 = real_lt(e_0, 0.0) ? s_0 - z_0 * sliding : -(z_0 * release);
            const real bristle_damping = p[5 * 8 + j];
            t12[j] = bristle_damping * zd_0 + z_0 * bristle_stiffness;
            const real t13 = 0.5 * 1.0 / t10 * (real_lt(0.0, square) ? 2.0 * s_0 : 0.0);
            const real t14 = real_lt(e_0, 0.0) ? 1.0 - t11 * (real_lt(0.0, square) ? t13 : 0.0) * z_0 : 0.0;
            J[6 * 8 + j] = t14; /* J(2,2) */
            t15[j] = bristle_damping * t14;
            const real t16 = real_lt(e_0, 0.0) ? -sliding : -release;
            J[7 * 8 + j] = t16; /* J(2,3) */
            t17[j] = bristle_stiffness + bristle_damping * t16;
        }
        for (size_t j = 0; j < 8; j++) {
            t2[j] = real_pow(depth[j], t1[j]);
            const real exponent = p[1 * 8 + j];
            t5[j] = real_pow(depth[j], exponent);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real t4 = real_lt(e_0, 0.0) ? exponent * t2[j] * t3[j] * stiffness : 0.0;
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t5[j] : 0.0;
            const real t6 = elastic * t0[j];
            const real t7 = real_le(t6, 0.0) ? 0.0 : 1.0;
            const real t8 = t0[j] * t4 * t7;
            J[0 * 8 + j] = -t8; /* J(0,0) */
            const real dissipation = p[2 * 8 + j];
            const real t9 = dissipation * elastic * t7;
            J[1 * 8 + j] = t9; /* J(0,1) */
            J[2 * 8 + j] = t12[j] * t8; /* J(1,0) */
            J[3 * 8 + j] = -(t12[j] * t9); /* J(1,1) */
            const real N = real_max(0.0, t6);
            J[4 * 8 + j] = N * t15[j]; /* J(1,2) */
            J[5 * 8 + j] = N * t17[j]; /* J(1,3) */
        }
    }
}

const flexel_law flexel_law_hertz_bristle_1 = {
    .name = "hertz_bristle_1",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 1,
    .nz = 1,
    .np = 7,
    .law = hertz_bristle_1_law,
    .tangent = hertz_bristle_1_tangent,
};

/* hertz_bristle_2
 *
 * d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N
 * energy = stiffness d^(exponent + 1)/(exponent + 1) + stiffness d^exponent bristle_stiffness z.z/2
 * dz/dt = s - bristle_stiffness |s| z/friction in contact, -release z when open
 * tau = N (bristle_stiffness z + bristle_damping dz/dt)
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369; Dahl
 *   1968; Canudas de Wit et al. 1995, IEEE Trans. Autom. Control 40:419
 *
 * 1 deformations, 2 slips, z: z_0 [m], z_1 [m]
 * p (7):
 *   stiffness (1) [N/m^exponent]: normal force per penetration^exponent
 *   exponent (1) [1]: exponent of the penetration, 3/2 for Hertz, at least 1
 *   dissipation (1) [s/m]: relative growth of the normal force per speed of approach
 *   friction (1) [1]: coefficient of friction
 *   bristle_stiffness (1) [1/m]: friction per normal force and deflection of the bristles
 *   bristle_damping (1) [s/m]: friction per normal force and rate of deflection
 *   release (1) [1/s]: rate at which bristles straighten while the gap is open */

/* law: 77 operations.
 * in:  e (1), ed (1), s (2), z (2), t (1), p (7)
 * out: sigma (1), tau (2), zd (2), U (1), P (1) */
FLEXEL_CLONES
static void hertz_bristle_2_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (2 * 8);
        const real *restrict z = in[3] + b * (2 * 8);
        const real *restrict p = in[5] + b * (7 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict tau = out[1] + b * (2 * 8);
        real *restrict zd = out[2] + b * (2 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
        real depth[8], t0[8], t1[8], t2[8], t4[8], t6[8], t7[8], t8[8], t9[8], t10[8], t11[8], t14[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            const real z_0 = z[0 * 8 + j];
            const real bristle_stiffness = p[4 * 8 + j];
            const real friction = p[3 * 8 + j];
            const real s_0 = s[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real square = s_0 * s_0 + s_1 * s_1;
            const real safe = real_lt(0.0, square) ? square : 1.0;
            const real speed = real_lt(0.0, square) ? real_sqrt(safe) : 0.0;
            const real sliding = 1.0 / friction * (bristle_stiffness * speed);
            const real release = p[6 * 8 + j];
            const real zd_0 = real_lt(e_0, 0.0) ? s_0 - z_0 * sliding : -(z_0 * release);
            zd[0 * 8 + j] = zd_0;
            const real bristle_damping = p[5 * 8 + j];
            t2[j] = z_0 * bristle_stiffness + bristle_damping * zd_0;
            const real z_1 = z[1 * 8 + j];
            const real zd_1 = real_lt(e_0, 0.0) ? s_1 - z_1 * sliding : -(z_1 * release);
            zd[1 * 8 + j] = zd_1;
            t4[j] = z_1 * bristle_stiffness + bristle_damping * zd_1;
            t6[j] = z_0 * z_0 + z_1 * z_1;
            const real exponent = p[1 * 8 + j];
            t7[j] = 1.0 / (1.0 + exponent);
            t8[j] = 0.5 * bristle_stiffness * t6[j] - e_0 * t7[j];
            t9[j] = exponent - 1.0;
            const real stiffness = p[0 * 8 + j];
            t11[j] = stiffness * (real_lt(e_0, 0.0) ? -ed_0 : 0.0) * exponent;
            t14[j] = z_0 * zd_0 + z_1 * zd_1;
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t10[j] = real_pow(depth[j], t9[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real N = real_max(0.0, elastic * t1[j]);
            sigma[0 * 8 + j] = -N;
            const real t3 = N * t2[j];
            tau[0 * 8 + j] = t3;
            const real t5 = N * t4[j];
            tau[1 * 8 + j] = t5;
            U[0 * 8 + j] = elastic * t8[j];
            const real ed_0 = ed[0 * 8 + j];
            const real t12 = real_lt(e_0, 0.0) ? t10[j] * t11[j] : 0.0;
            const real s_0 = s[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real t13 = s_0 * t3 + s_1 * t5 + t7[j] * (ed_0 * elastic + e_0 * t12);
            const real bristle_stiffness = p[4 * 8 + j];
            const real t15 = bristle_stiffness * (t6[j] * t12 + 2.0 * elastic * t14[j]);
            P[0 * 8 + j] = t13 - ed_0 * N - 0.5 * t15;
        }
    }
}

/* tangent: 94 operations.
 * in:  e (1), ed (1), s (2), z (2), t (1), p (7)
 * out: J (5,6), 18 of 30 entries */
FLEXEL_CLONES
static void hertz_bristle_2_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict s = in[2] + b * (2 * 8);
        const real *restrict z = in[3] + b * (2 * 8);
        const real *restrict p = in[5] + b * (7 * 8);
        real *restrict J = out[0] + b * (18 * 8);
        real depth[8], t0[8], t1[8], t4[8], t5[8], t6[8], t11[8], t16[8], t17[8], t19[8], t20[8], t21[8], t22[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            depth[j] = real_lt(e_0, 0.0) ? -e_0 : 1.0;
            const real ed_0 = ed[0 * 8 + j];
            const real dissipation = p[2 * 8 + j];
            t1[j] = 1.0 - ed_0 * dissipation;
            t4[j] = real_lt(e_0, 0.0) ? 1.0 : 0.0;
            const real exponent = p[1 * 8 + j];
            t5[j] = exponent - 1.0;
            const real s_0 = s[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real square = s_0 * s_0 + s_1 * s_1;
            const real safe = real_lt(0.0, square) ? square : 1.0;
            const real t9 = real_sqrt(safe);
            const real speed = real_lt(0.0, square) ? t9 : 0.0;
            const real friction = p[3 * 8 + j];
            const real bristle_stiffness = p[4 * 8 + j];
            const real t10 = 1.0 / friction * bristle_stiffness;
            const real sliding = speed * t10;
            const real z_0 = z[0 * 8 + j];
            const real release = p[6 * 8 + j];
            const real zd_0 = real_lt(e_0, 0.0) ? s_0 - z_0 * sliding : -(z_0 * release);
            const real bristle_damping = p[5 * 8 + j];
            t11[j] = bristle_damping * zd_0 + z_0 * bristle_stiffness;
            const real t14 = real_lt(0.0, square) ? 1.0 : 0.0;
            const real t15 = 1.0 / t9 * t14 * t14 * t10;
            t16[j] = s_0 * t15;
            t17[j] = z_0 * t4[j];
            t19[j] = s_1 * t15;
            t20[j] = release * (real_lt(e_0, 0.0) ? 0.0 : 1.0) + sliding * t4[j];
            const real z_1 = z[1 * 8 + j];
            const real zd_1 = real_lt(e_0, 0.0) ? s_1 - z_1 * sliding : -(z_1 * release);
            t21[j] = bristle_damping * zd_1 + z_1 * bristle_stiffness;
            t22[j] = z_1 * t4[j];
            J[12 * 8 + j] = t4[j] - t17[j] * t16[j]; /* J(3,2) */
            J[13 * 8 + j] = -(t17[j] * t19[j]); /* J(3,3) */
            J[14 * 8 + j] = J[17 * 8 + j] = -t20[j]; /* J(3,4) J(4,5) */
            J[15 * 8 + j] = -(t22[j] * t16[j]); /* J(4,2) */
            J[16 * 8 + j] = t4[j] - t22[j] * t19[j]; /* J(4,3) */
        }
        for (size_t j = 0; j < 8; j++) {
            const real exponent = p[1 * 8 + j];
            t0[j] = real_pow(depth[j], exponent);
            t6[j] = real_pow(depth[j], t5[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real elastic = real_lt(e_0, 0.0) ? stiffness * t0[j] : 0.0;
            const real t2 = elastic * t1[j];
            const real t3 = real_le(t2, 0.0) ? 0.0 : 1.0;
            const real exponent = p[1 * 8 + j];
            const real t7 = exponent * t6[j] * t4[j] * stiffness * t4[j] * t1[j] * t3;
            J[0 * 8 + j] = t7; /* J(0,0) */
            const real dissipation = p[2 * 8 + j];
            const real t8 = dissipation * elastic * t3;
            J[1 * 8 + j] = t8; /* J(0,1) */
            J[2 * 8 + j] = -(t11[j] * t7); /* J(1,0) */
            J[3 * 8 + j] = -(t11[j] * t8); /* J(1,1) */
            const real N = real_max(0.0, t2);
            const real bristle_damping = p[5 * 8 + j];
            const real t12 = bristle_damping * N;
            const real t13 = t4[j] * t12;
            const real t18 = t12 * t17[j];
            J[4 * 8 + j] = t13 - t16[j] * t18; /* J(1,2) */
            J[5 * 8 + j] = -(t19[j] * t18); /* J(1,3) */
            const real bristle_stiffness = p[4 * 8 + j];
            J[6 * 8 + j] = J[11 * 8 + j] = bristle_stiffness * N - t12 * t20[j]; /* J(1,4) J(2,5) */
            J[7 * 8 + j] = -(t21[j] * t7); /* J(2,0) */
            J[8 * 8 + j] = -(t21[j] * t8); /* J(2,1) */
            const real t23 = t12 * t22[j];
            J[9 * 8 + j] = -(t16[j] * t23); /* J(2,2) */
            J[10 * 8 + j] = t13 - t19[j] * t23; /* J(2,3) */
        }
    }
}

const flexel_law flexel_law_hertz_bristle_2 = {
    .name = "hertz_bristle_2",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 2,
    .nz = 2,
    .np = 7,
    .law = hertz_bristle_2_law,
    .tangent = hertz_bristle_2_tangent,
};

/* journal
 *
 * N_i = stiffness e_i + damping ed_i in two directions (i = 0, 1), N = |(N_0, N_1)|
 * torque = friction_radius N w/sqrt(w^2 + slip_speed^2) on the angle e_2, w = ed_2
 *
 * Source: Coulomb's friction on a journal, regularized
 *
 * 3 deformations, 0 slips
 * p (4):
 *   stiffness (1) [N/m]: radial stiffness
 *   damping (1) [N s/m]: radial damping
 *   friction_radius (1) [m]: coefficient of friction times the radius of the journal
 *   slip_speed (1) [rad/s]: speed of turning at which 71 % of the friction acts */

/* law: 36 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (4)
 * out: sigma (3), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void journal_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict sigma = out[0] + b * (3 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real damping = p[1 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real stiffness = p[0 * 8 + j];
            const real N1 = ed_0 * damping + e_0 * stiffness;
            sigma[0 * 8 + j] = N1;
            const real ed_1 = ed[1 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real N2 = ed_1 * damping + e_1 * stiffness;
            sigma[1 * 8 + j] = N2;
            const real square = N1 * N1 + N2 * N2;
            const real safe = real_lt(0.0, square) ? square : 1.0;
            const real N = real_lt(0.0, square) ? real_sqrt(safe) : 0.0;
            const real ed_2 = ed[2 * 8 + j];
            const real slip_speed = p[3 * 8 + j];
            const real friction_radius = p[2 * 8 + j];
            const real t0 = 1.0 / real_sqrt(ed_2 * ed_2 + slip_speed * slip_speed) * friction_radius;
            const real t1 = ed_2 * t0 * N;
            sigma[2 * 8 + j] = t1;
            U[0 * 8 + j] = 0.5 * stiffness * (e_0 * e_0 + e_1 * e_1);
            P[0 * 8 + j] = ed_0 * N1 + ed_2 * t1 + ed_1 * N2 - stiffness * (e_0 * ed_0 + e_1 * ed_1);
        }
    }
}

/* tangent: 39 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (4)
 * out: J (3,6), 9 of 18 entries */
FLEXEL_CLONES
static void journal_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict J = out[0] + b * (9 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real stiffness = p[0 * 8 + j];
            J[0 * 8 + j] = J[2 * 8 + j] = stiffness; /* J(0,0) J(1,1) */
            const real damping = p[1 * 8 + j];
            J[1 * 8 + j] = J[3 * 8 + j] = damping; /* J(0,3) J(1,4) */
            const real ed_0 = ed[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real N1 = ed_0 * damping + e_0 * stiffness;
            const real ed_1 = ed[1 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real N2 = ed_1 * damping + e_1 * stiffness;
            const real square = N1 * N1 + N2 * N2;
            const real t0 = real_lt(0.0, square) ? 1.0 : 0.0;
            const real safe = real_lt(0.0, square) ? square : 1.0;
            const real t1 = real_sqrt(safe);
            const real ed_2 = ed[2 * 8 + j];
            const real t2 = 1.0 / t1 * (ed_2 * t0) * t0;
            const real slip_speed = p[3 * 8 + j];
            const real t3 = 1.0 / real_sqrt(ed_2 * ed_2 + slip_speed * slip_speed);
            const real friction_radius = p[2 * 8 + j];
            const real t4 = friction_radius * t3;
            const real t5 = N1 * t4 * t2;
            J[4 * 8 + j] = stiffness * t5; /* J(2,0) */
            const real t6 = N2 * t4 * t2;
            J[5 * 8 + j] = stiffness * t6; /* J(2,1) */
            J[6 * 8 + j] = damping * t5; /* J(2,3) */
            J[7 * 8 + j] = damping * t6; /* J(2,4) */
            const real N = real_lt(0.0, square) ? t1 : 0.0;
            J[8 * 8 + j] = N * (t4 - ed_2 * friction_radius * ed_2 * t3 * t3 * t3); /* J(2,5) */
        }
    }
}

const flexel_law flexel_law_journal = {
    .name = "journal",
    .digest = "c9cb37880850cb4e",
    .m = 3,
    .k = 0,
    .nz = 0,
    .np = 4,
    .law = journal_law,
    .tangent = journal_tangent,
};

/* friction
 *
 * sigma = limit w/sqrt(w^2 + speed^2), w = edot
 *
 * Source: Coulomb's friction, regularized
 *
 * 1 deformations, 0 slips
 * p (2):
 *   limit (1) [N or N m]: friction of fast motion
 *   speed (1) [m/s or rad/s]: speed at which 71 % of the friction acts */

/* law: 8 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (2)
 * out: sigma (1), tau (0), zd (0), U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void friction_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (2 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_ = ed[0 * 8 + j];
            const real speed = p[1 * 8 + j];
            const real limit = p[0 * 8 + j];
            const real t0 = 1.0 / real_sqrt(ed_ * ed_ + speed * speed) * ed_ * limit;
            sigma[0 * 8 + j] = t0;
            P[0 * 8 + j] = ed_ * t0;
        }
    }
}

/* tangent: 10 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (2)
 * out: J (1,2), 1 of 2 entries */
FLEXEL_CLONES
static void friction_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (2 * 8);
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_ = ed[0 * 8 + j];
            const real t0 = ed_ * ed_;
            const real speed = p[1 * 8 + j];
            const real t1 = 1.0 / real_sqrt(t0 + speed * speed);
            const real limit = p[0 * 8 + j];
            J[0 * 8 + j] = t1 * (1.0 - t0 * t1 * t1) * limit; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_friction = {
    .name = "friction",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 2,
    .law = friction_law,
    .tangent = friction_tangent,
};

/* slip_friction
 *
 * tau = limit w/sqrt(w^2 + speed^2), w the slip
 *
 * Source: Coulomb's friction, regularized
 *
 * 0 deformations, 1 slips
 * p (2):
 *   limit (1) [N or N m]: friction of fast motion
 *   speed (1) [m/s or rad/s]: speed at which 71 % of the friction acts */

/* law: 8 operations.
 * in:  e (0), ed (0), s (1), z (0), t (1), p (2)
 * out: sigma (0), tau (1), zd (0), U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void slip_friction_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict p = in[5] + b * (2 * 8);
        real *restrict tau = out[1] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_ = s[0 * 8 + j];
            const real speed = p[1 * 8 + j];
            const real limit = p[0 * 8 + j];
            const real t0 = 1.0 / real_sqrt(s_ * s_ + speed * speed) * s_ * limit;
            tau[0 * 8 + j] = t0;
            P[0 * 8 + j] = s_ * t0;
        }
    }
}

/* tangent: 10 operations.
 * in:  e (0), ed (0), s (1), z (0), t (1), p (2)
 * out: J (1,1) */
FLEXEL_CLONES
static void slip_friction_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict p = in[5] + b * (2 * 8);
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_ = s[0 * 8 + j];
            const real t0 = s_ * s_;
            const real speed = p[1 * 8 + j];
            const real t1 = 1.0 / real_sqrt(t0 + speed * speed);
            const real limit = p[0 * 8 + j];
            J[0 * 8 + j] = t1 * (1.0 - t0 * t1 * t1) * limit; /* J(0,0) */
        }
    }
}

const flexel_law flexel_law_slip_friction = {
    .name = "slip_friction",
    .digest = "c9cb37880850cb4e",
    .m = 0,
    .k = 1,
    .nz = 0,
    .np = 2,
    .law = slip_friction_law,
    .tangent = slip_friction_tangent,
};

/* limits
 *
 * above = max(0, e - high), below = max(0, low - e)
 * sigma = stiffness (above max(0, 1 + damping edot) - below max(0, 1 - damping edot))
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440, exponent one
 *
 * 1 deformations, 0 slips
 * p (4):
 *   low (1) [m or rad]: deformation at which the lower stop is touched
 *   high (1) [m or rad]: deformation at which the upper stop is touched
 *   stiffness (1) [N/m or N m/rad]: stiffness once touched
 *   damping (1) [s/m or s/rad]: loss relative to the elastic force, for unit rate */

/* law: 28 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (4)
 * out: sigma (1), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void limits_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_ = e[0 * 8 + j];
            const real high = p[1 * 8 + j];
            const real t0 = e_ - high;
            const real t1 = real_max(0.0, t0);
            const real ed_ = ed[0 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real t2 = ed_ * damping;
            const real low = p[0 * 8 + j];
            const real t3 = low - e_;
            const real t4 = real_max(0.0, t3);
            const real t5 = t1 * real_max(0.0, 1.0 + t2) - t4 * real_max(0.0, 1.0 - t2);
            const real stiffness = p[2 * 8 + j];
            const real t6 = stiffness * t5;
            sigma[0 * 8 + j] = t6;
            U[0 * 8 + j] = 0.5 * stiffness * (t4 * t4 + t1 * t1);
            const real t7 = t1 * (real_le(t0, 0.0) ? 0.0 : 1.0) - t4 * (real_le(t3, 0.0) ? 0.0 : 1.0);
            P[0 * 8 + j] = ed_ * (t6 - stiffness * t7);
        }
    }
}

/* tangent: 26 operations.
 * in:  e (1), ed (1), s (0), z (0), t (1), p (4)
 * out: J (1,2) */
FLEXEL_CLONES
static void limits_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[5] + b * (4 * 8);
        real *restrict J = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_ = ed[0 * 8 + j];
            const real damping = p[3 * 8 + j];
            const real t0 = ed_ * damping;
            const real t1 = 1.0 - t0;
            const real low = p[0 * 8 + j];
            const real e_ = e[0 * 8 + j];
            const real t2 = low - e_;
            const real t3 = 1.0 + t0;
            const real high = p[1 * 8 + j];
            const real t4 = e_ - high;
            const real t5 = real_max(0.0, t1) * (real_le(t2, 0.0) ? 0.0 : 1.0) + real_max(0.0, t3) * (real_le(t4, 0.0)
                ? 0.0 : 1.0);
            const real stiffness = p[2 * 8 + j];
            J[0 * 8 + j] = stiffness * t5; /* J(0,0) */
            const real t6 = real_max(0.0, t2) * (real_le(t1, 0.0) ? 0.0 : 1.0) + real_max(0.0, t4) * (real_le(t3, 0.0)
                ? 0.0 : 1.0);
            J[1 * 8 + j] = stiffness * t6 * damping; /* J(0,1) */
        }
    }
}

const flexel_law flexel_law_limits = {
    .name = "limits",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 0,
    .np = 4,
    .law = limits_law,
    .tangent = limits_tangent,
};

/* loose_journal
 *
 * r = |(e_0, e_1)|, depth = max(0, r - gap), N = stiffness depth max(0, 1 + damping dr/dt)
 * sigma_i = N e_i/r (i = 0, 1);  torque = friction_radius N w/sqrt(w^2 + slip_speed^2) on e_2, w = ed_2
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440, exponent one; Coulomb's friction, regularized
 *
 * 3 deformations, 0 slips
 * p (5):
 *   gap (1) [m]: radial play as drawn
 *   stiffness (1) [N/m or N m/rad]: stiffness once touched
 *   damping (1) [s/m or s/rad]: loss relative to the elastic force, for unit rate
 *   friction_radius (1) [m]: coefficient of friction times the radius of the journal
 *   slip_speed (1) [rad/s]: speed of turning at which 71 % of the friction acts */

/* law: 45 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (5)
 * out: sigma (3), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void loose_journal_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict sigma = out[0] + b * (3 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real gap = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real square = e_0 * e_0 + e_1 * e_1;
            const real safe = real_lt(gap * gap, square) ? square : 1.0;
            const real r = real_sqrt(safe);
            const real t0 = 1.0 / r;
            const real ed_0 = ed[0 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real t1 = e_0 * ed_0 + e_1 * ed_1;
            const real rate = t0 * t1;
            const real damping = p[2 * 8 + j];
            const real depth = real_lt(gap * gap, square) ? r - gap : 0.0;
            const real stiffness = p[1 * 8 + j];
            const real t2 = stiffness * depth;
            const real N = real_max(0.0, 1.0 + damping * rate) * t2;
            const real t3 = e_0 * t0 * N;
            sigma[0 * 8 + j] = t3;
            const real t4 = e_1 * t0 * N;
            sigma[1 * 8 + j] = t4;
            const real ed_2 = ed[2 * 8 + j];
            const real slip_speed = p[4 * 8 + j];
            const real friction_radius = p[3 * 8 + j];
            const real t5 = 1.0 / real_sqrt(ed_2 * ed_2 + slip_speed * slip_speed) * friction_radius;
            const real t6 = ed_2 * t5 * N;
            sigma[2 * 8 + j] = t6;
            U[0 * 8 + j] = 0.5 * depth * t2;
            const real t7 = real_lt(gap * gap, square) ? 0.5 * t0 * (real_lt(gap * gap, square) ? 2.0 * t1 : 0.0)
                : 0.0;
            P[0 * 8 + j] = ed_2 * t6 + ed_0 * t3 + ed_1 * t4 - t2 * t7;
        }
    }
}

/* tangent: 87 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (5)
 * out: J (3,6), 13 of 18 entries */
FLEXEL_CLONES
static void loose_journal_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[5] + b * (5 * 8);
        real *restrict J = out[0] + b * (13 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real gap = p[0 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real square = e_0 * e_0 + e_1 * e_1;
            const real safe = real_lt(gap * gap, square) ? square : 1.0;
            const real r = real_sqrt(safe);
            const real t0 = 1.0 / r;
            const real ed_0 = ed[0 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real t1 = e_0 * ed_0 + e_1 * ed_1;
            const real rate = t0 * t1;
            const real damping = p[2 * 8 + j];
            const real t2 = 1.0 + damping * rate;
            const real t3 = real_max(0.0, t2);
            const real depth = real_lt(gap * gap, square) ? r - gap : 0.0;
            const real stiffness = p[1 * 8 + j];
            const real t4 = stiffness * depth;
            const real N = t3 * t4;
            const real t5 = t0 * N;
            const real t6 = e_0 * t0;
            const real t7 = real_lt(gap * gap, square) ? 1.0 : 0.0;
            const real t8 = t0 * t7;
            const real t9 = e_0 * t8;
            const real t10 = stiffness * t3 * t7;
            const real t11 = damping * t4 * (real_le(t2, 0.0) ? 0.0 : 1.0);
            const real t12 = t0 * t11;
            const real t13 = t0 * t0;
            const real t14 = t13 * t9;
            const real t15 = t1 * t11;
            const real t16 = t9 * t10 + ed_0 * t12 - t14 * t15;
            const real t17 = e_0 * N;
            J[0 * 8 + j] = t5 + t6 * t16 - t17 * t14; /* J(0,0) */
            const real t18 = e_1 * t8;
            const real t19 = t13 * t18;
            const real t20 = t18 * t10 + ed_1 * t12 - t19 * t15;
            J[1 * 8 + j] = t6 * t20 - t17 * t19; /* J(0,1) */
            const real t21 = e_0 * t12;
            J[2 * 8 + j] = t6 * t21; /* J(0,3) */
            const real t22 = e_1 * t12;
            J[3 * 8 + j] = t6 * t22; /* J(0,4) */
            const real t23 = e_1 * t0;
            const real t24 = e_1 * N;
            J[4 * 8 + j] = t23 * t16 - t24 * t14; /* J(1,0) */
            J[5 * 8 + j] = t5 + t23 * t20 - t24 * t19; /* J(1,1) */
            J[6 * 8 + j] = t23 * t21; /* J(1,3) */
            J[7 * 8 + j] = t23 * t22; /* J(1,4) */
            const real ed_2 = ed[2 * 8 + j];
            const real slip_speed = p[4 * 8 + j];
            const real t25 = 1.0 / real_sqrt(ed_2 * ed_2 + slip_speed * slip_speed);
            const real friction_radius = p[3 * 8 + j];
            const real t26 = friction_radius * t25;
            const real t27 = ed_2 * t26;
            J[8 * 8 + j] = t27 * t16; /* J(2,0) */
            J[9 * 8 + j] = t27 * t20; /* J(2,1) */
            J[10 * 8 + j] = t27 * t21; /* J(2,3) */
            J[11 * 8 + j] = t27 * t22; /* J(2,4) */
            J[12 * 8 + j] = N * (t26 - ed_2 * friction_radius * ed_2 * t25 * t25 * t25); /* J(2,5) */
        }
    }
}

const flexel_law flexel_law_loose_journal = {
    .name = "loose_journal",
    .digest = "c9cb37880850cb4e",
    .m = 3,
    .k = 0,
    .nz = 0,
    .np = 5,
    .law = loose_journal_law,
    .tangent = loose_journal_tangent,
};

/* loose_ball
 *
 * r = |(e_0, e_1, e_2)|, depth = max(0, r - gap), N = stiffness depth max(0, 1 + damping dr/dt)
 * sigma_i = N e_i/r
 *
 * Source: Hunt and Crossley 1975, J. Appl. Mech. 42:440, exponent one
 *
 * 3 deformations, 0 slips
 * p (3):
 *   gap (1) [m]: radial play as drawn
 *   stiffness (1) [N/m or N m/rad]: stiffness once touched
 *   damping (1) [s/m or s/rad]: loss relative to the elastic force, for unit rate */

/* law: 43 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (3)
 * out: sigma (3), tau (0), zd (0), U (1), P (1) */
FLEXEL_CLONES
static void loose_ball_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict sigma = out[0] + b * (3 * 8);
        real *restrict U = out[3] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real gap = p[0 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real square = e_0 * e_0 + e_2 * e_2 + e_1 * e_1;
            const real safe = real_lt(gap * gap, square) ? square : 1.0;
            const real r = real_sqrt(safe);
            const real t0 = 1.0 / r;
            const real ed_1 = ed[1 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real t1 = e_0 * ed_0 + e_2 * ed_2 + e_1 * ed_1;
            const real rate = t0 * t1;
            const real damping = p[2 * 8 + j];
            const real depth = real_lt(gap * gap, square) ? r - gap : 0.0;
            const real stiffness = p[1 * 8 + j];
            const real t2 = stiffness * depth;
            const real N = real_max(0.0, 1.0 + damping * rate) * t2;
            const real t3 = e_0 * t0 * N;
            sigma[0 * 8 + j] = t3;
            const real t4 = e_1 * t0 * N;
            sigma[1 * 8 + j] = t4;
            const real t5 = e_2 * t0 * N;
            sigma[2 * 8 + j] = t5;
            U[0 * 8 + j] = 0.5 * depth * t2;
            const real t6 = real_lt(gap * gap, square) ? 0.5 * t0 * (real_lt(gap * gap, square) ? 2.0 * t1 : 0.0)
                : 0.0;
            P[0 * 8 + j] = ed_2 * t5 + ed_0 * t3 + ed_1 * t4 - t2 * t6;
        }
    }
}

/* tangent: 100 operations.
 * in:  e (3), ed (3), s (0), z (0), t (1), p (3)
 * out: J (3,6) */
FLEXEL_CLONES
static void loose_ball_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[5] + b * (3 * 8);
        real *restrict J = out[0] + b * (18 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real gap = p[0 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real square = e_0 * e_0 + e_2 * e_2 + e_1 * e_1;
            const real safe = real_lt(gap * gap, square) ? square : 1.0;
            const real r = real_sqrt(safe);
            const real t0 = 1.0 / r;
            const real ed_1 = ed[1 * 8 + j];
            const real ed_0 = ed[0 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real t1 = e_0 * ed_0 + e_2 * ed_2 + e_1 * ed_1;
            const real rate = t0 * t1;
            const real damping = p[2 * 8 + j];
            const real t2 = 1.0 + damping * rate;
            const real t3 = real_max(0.0, t2);
            const real depth = real_lt(gap * gap, square) ? r - gap : 0.0;
            const real stiffness = p[1 * 8 + j];
            const real N = stiffness * depth * t3;
            const real t4 = t0 * N;
            const real t5 = e_0 * t0;
            const real t6 = damping * depth * (real_le(t2, 0.0) ? 0.0 : 1.0);
            const real t7 = stiffness * t0 * t6;
            const real t8 = real_lt(gap * gap, square) ? 1.0 : 0.0;
            const real t9 = t0 * t8;
            const real t10 = t0 * t0 * t9;
            const real t11 = stiffness * (t3 * t9 * t8 - t1 * t10 * t6);
            const real t12 = ed_0 * t7 + e_0 * t11;
            const real t13 = e_0 * N * t10;
            J[0 * 8 + j] = t4 + t5 * t12 - e_0 * t13; /* J(0,0) */
            const real t14 = ed_1 * t7 + e_1 * t11;
            J[1 * 8 + j] = t5 * t14 - e_1 * t13; /* J(0,1) */
            const real t15 = ed_2 * t7 + e_2 * t11;
            J[2 * 8 + j] = t5 * t15 - e_2 * t13; /* J(0,2) */
            const real t16 = e_0 * t7;
            J[3 * 8 + j] = t5 * t16; /* J(0,3) */
            const real t17 = e_1 * t7;
            J[4 * 8 + j] = t5 * t17; /* J(0,4) */
            const real t18 = e_2 * t7;
            J[5 * 8 + j] = t5 * t18; /* J(0,5) */
            const real t19 = e_1 * t0;
            const real t20 = e_1 * N * t10;
            J[6 * 8 + j] = t19 * t12 - e_0 * t20; /* J(1,0) */
            J[7 * 8 + j] = t4 + t19 * t14 - e_1 * t20; /* J(1,1) */
            J[8 * 8 + j] = t19 * t15 - e_2 * t20; /* J(1,2) */
            J[9 * 8 + j] = t19 * t16; /* J(1,3) */
            J[10 * 8 + j] = t19 * t17; /* J(1,4) */
            J[11 * 8 + j] = t19 * t18; /* J(1,5) */
            const real t21 = e_2 * t0;
            const real t22 = e_2 * N * t10;
            J[12 * 8 + j] = t21 * t12 - e_0 * t22; /* J(2,0) */
            J[13 * 8 + j] = t21 * t14 - e_1 * t22; /* J(2,1) */
            J[14 * 8 + j] = t4 + t21 * t15 - e_2 * t22; /* J(2,2) */
            J[15 * 8 + j] = t21 * t16; /* J(2,3) */
            J[16 * 8 + j] = t21 * t17; /* J(2,4) */
            J[17 * 8 + j] = t21 * t18; /* J(2,5) */
        }
    }
}

const flexel_law flexel_law_loose_ball = {
    .name = "loose_ball",
    .digest = "c9cb37880850cb4e",
    .m = 3,
    .k = 0,
    .nz = 0,
    .np = 3,
    .law = loose_ball_law,
    .tangent = loose_ball_tangent,
};

/* held
 *
 * sigma = -u, du/dt = 0
 *
 * Source: zero-order hold
 *
 * 1 deformations, 0 slips, z: u [N or N m]
 * p (0): none */

/* law: 3 operations.
 * in:  e (1), ed (1), s (0), z (1), t (1), p (0)
 * out: sigma (1), tau (0), zd (1), 0 of 1 entries, U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void held_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict z = in[3] + b * (1 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real u = z[0 * 8 + j];
            sigma[0 * 8 + j] = -u;
            const real ed_ = ed[0 * 8 + j];
            P[0 * 8 + j] = -(ed_ * u);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (1), ed (1), s (0), z (1), t (1), p (0)
 * out: J (2,3), 1 of 6 entries */
FLEXEL_CLONES
static void held_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            J[0 * 8 + j] = -1.0; /* J(0,2) */
        }
    }
    (void)in;
}

const flexel_law flexel_law_held = {
    .name = "held",
    .digest = "c9cb37880850cb4e",
    .m = 1,
    .k = 0,
    .nz = 1,
    .np = 0,
    .law = held_law,
    .tangent = held_tangent,
};

/* slip_held
 *
 * tau = -u, du/dt = 0
 *
 * Source: zero-order hold
 *
 * 0 deformations, 1 slips, z: u [N or N m]
 * p (0): none */

/* law: 3 operations.
 * in:  e (0), ed (0), s (1), z (1), t (1), p (0)
 * out: sigma (0), tau (1), zd (1), 0 of 1 entries, U (1), 0 of 1 entries, P (1) */
FLEXEL_CLONES
static void slip_held_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict z = in[3] + b * (1 * 8);
        real *restrict tau = out[1] + b * (1 * 8);
        real *restrict P = out[4] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real u = z[0 * 8 + j];
            tau[0 * 8 + j] = -u;
            const real s_ = s[0 * 8 + j];
            P[0 * 8 + j] = -(s_ * u);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (1), z (1), t (1), p (0)
 * out: J (2,2), 1 of 4 entries */
FLEXEL_CLONES
static void slip_held_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            J[0 * 8 + j] = -1.0; /* J(0,1) */
        }
    }
    (void)in;
}

const flexel_law flexel_law_slip_held = {
    .name = "slip_held",
    .digest = "c9cb37880850cb4e",
    .m = 0,
    .k = 1,
    .nz = 1,
    .np = 0,
    .law = slip_held_law,
    .tangent = slip_held_tangent,
};

/* memory
 *
 * dz/dt = 0, without a force
 *
 * Source: state of a sampled controller
 *
 * 0 deformations, 0 slips, z: z [1]
 * p (0): none */

/* law: 0 operations.
 * in:  e (0), ed (0), s (0), z (1), t (1), p (0)
 * out: sigma (0), tau (0), zd (1), 0 of 1 entries, U (1), 0 of 1 entries, P (1), 0 of 1 entries */
FLEXEL_CLONES
static void memory_law(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (0), z (1), t (1), p (0)
 * out: J (1,1), 0 of 1 entries */
FLEXEL_CLONES
static void memory_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    (void)nblocks, (void)in, (void)out; /* every entry is zero */
}

const flexel_law flexel_law_memory = {
    .name = "memory",
    .digest = "c9cb37880850cb4e",
    .m = 0,
    .k = 0,
    .nz = 1,
    .np = 0,
    .law = memory_law,
    .tangent = memory_tangent,
};
