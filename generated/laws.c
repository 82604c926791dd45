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

/* law: 7 operations.
 * in:  e (1), ed (1), s (0), p (3)
 * out: sigma (1), tau (0), U (1) */
FLEXEL_CLONES
static void linear_1_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (1 * 8);
        const real *restrict ed = in[1] + b * (1 * 8);
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict sigma = out[0] + b * (1 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            const real S = p[1 * 8 + j];
            const real t0 = e_0 * S;
            const real ed_0 = ed[0 * 8 + j];
            const real D = p[2 * 8 + j];
            const real preload = p[0 * 8 + j];
            sigma[0 * 8 + j] = preload + ed_0 * D + t0;
            U[0 * 8 + j] = e_0 * (preload + 0.5 * t0);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (1), ed (1), s (0), p (3)
 * out: J (1,2) */
FLEXEL_CLONES
static void linear_1_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict J = out[0] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S = p[1 * 8 + j];
            J[0 * 8 + j] = S;
            const real D = p[2 * 8 + j];
            J[1 * 8 + j] = D;
        }
    }
}

const flexel_law flexel_law_linear_1 = {
    .name = "linear_1",
    .digest = "de4f40f20d7d189e",
    .m = 1,
    .k = 0,
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

/* law: 23 operations.
 * in:  e (2), ed (2), s (0), p (8)
 * out: sigma (2), tau (0), U (1) */
FLEXEL_CLONES
static void linear_2_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (2 * 8);
        const real *restrict ed = in[1] + b * (2 * 8);
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict sigma = out[0] + b * (2 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[5 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[6 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[2 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[3 * 8 + j];
            const real t0 = e_0 * S_11 + e_1 * S_12;
            const real preload_0 = p[0 * 8 + j];
            sigma[0 * 8 + j] = ed_1 * D_12 + t0 + preload_0 + ed_0 * D_11;
            const real D_22 = p[7 * 8 + j];
            const real S_22 = p[4 * 8 + j];
            const real t1 = e_0 * S_12 + e_1 * S_22;
            const real preload_1 = p[1 * 8 + j];
            sigma[1 * 8 + j] = ed_1 * D_22 + t1 + preload_1 + ed_0 * D_12;
            U[0 * 8 + j] = e_0 * (preload_0 + 0.5 * t0) + e_1 * (preload_1 + 0.5 * t1);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (2), ed (2), s (0), p (8)
 * out: J (2,4) */
FLEXEL_CLONES
static void linear_2_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (8 * 8);
        real *restrict J = out[0] + b * (8 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[2 * 8 + j];
            J[0 * 8 + j] = S_11;
            const real S_12 = p[3 * 8 + j];
            J[1 * 8 + j] = J[4 * 8 + j] = S_12;
            const real D_11 = p[5 * 8 + j];
            J[2 * 8 + j] = D_11;
            const real D_12 = p[6 * 8 + j];
            J[3 * 8 + j] = J[6 * 8 + j] = D_12;
            const real S_22 = p[4 * 8 + j];
            J[5 * 8 + j] = S_22;
            const real D_22 = p[7 * 8 + j];
            J[7 * 8 + j] = D_22;
        }
    }
}

const flexel_law flexel_law_linear_2 = {
    .name = "linear_2",
    .digest = "de4f40f20d7d189e",
    .m = 2,
    .k = 0,
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

/* law: 47 operations.
 * in:  e (3), ed (3), s (0), p (15)
 * out: sigma (3), tau (0), U (1) */
FLEXEL_CLONES
static void linear_3_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (3 * 8);
        const real *restrict ed = in[1] + b * (3 * 8);
        const real *restrict p = in[3] + b * (15 * 8);
        real *restrict sigma = out[0] + b * (3 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[9 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[10 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[11 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[3 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[4 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[5 * 8 + j];
            const real t0 = e_1 * S_12 + e_2 * S_13 + e_0 * S_11;
            const real preload_0 = p[0 * 8 + j];
            sigma[0 * 8 + j] = ed_2 * D_13 + t0 + ed_1 * D_12 + preload_0 + ed_0 * D_11;
            const real D_22 = p[12 * 8 + j];
            const real D_23 = p[13 * 8 + j];
            const real S_22 = p[6 * 8 + j];
            const real S_23 = p[7 * 8 + j];
            const real t1 = e_1 * S_22 + e_2 * S_23 + e_0 * S_12;
            const real preload_1 = p[1 * 8 + j];
            sigma[1 * 8 + j] = ed_2 * D_23 + t1 + ed_1 * D_22 + preload_1 + ed_0 * D_12;
            const real D_33 = p[14 * 8 + j];
            const real S_33 = p[8 * 8 + j];
            const real t2 = e_1 * S_23 + e_2 * S_33 + e_0 * S_13;
            const real preload_2 = p[2 * 8 + j];
            sigma[2 * 8 + j] = ed_2 * D_33 + t2 + ed_1 * D_23 + preload_2 + ed_0 * D_13;
            const real t3 = e_2 * (preload_2 + 0.5 * t2) + e_0 * (preload_0 + 0.5 * t0);
            U[0 * 8 + j] = e_1 * (preload_1 + 0.5 * t1) + t3;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (3), ed (3), s (0), p (15)
 * out: J (3,6) */
FLEXEL_CLONES
static void linear_3_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (15 * 8);
        real *restrict J = out[0] + b * (18 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[3 * 8 + j];
            J[0 * 8 + j] = S_11;
            const real S_12 = p[4 * 8 + j];
            J[1 * 8 + j] = J[6 * 8 + j] = S_12;
            const real S_13 = p[5 * 8 + j];
            J[2 * 8 + j] = J[12 * 8 + j] = S_13;
            const real D_11 = p[9 * 8 + j];
            J[3 * 8 + j] = D_11;
            const real D_12 = p[10 * 8 + j];
            J[4 * 8 + j] = J[9 * 8 + j] = D_12;
            const real D_13 = p[11 * 8 + j];
            J[5 * 8 + j] = J[15 * 8 + j] = D_13;
            const real S_22 = p[6 * 8 + j];
            J[7 * 8 + j] = S_22;
            const real S_23 = p[7 * 8 + j];
            J[8 * 8 + j] = J[13 * 8 + j] = S_23;
            const real D_22 = p[12 * 8 + j];
            J[10 * 8 + j] = D_22;
            const real D_23 = p[13 * 8 + j];
            J[11 * 8 + j] = J[16 * 8 + j] = D_23;
            const real S_33 = p[8 * 8 + j];
            J[14 * 8 + j] = S_33;
            const real D_33 = p[14 * 8 + j];
            J[17 * 8 + j] = D_33;
        }
    }
}

const flexel_law flexel_law_linear_3 = {
    .name = "linear_3",
    .digest = "de4f40f20d7d189e",
    .m = 3,
    .k = 0,
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

/* law: 79 operations.
 * in:  e (4), ed (4), s (0), p (24)
 * out: sigma (4), tau (0), U (1) */
FLEXEL_CLONES
static void linear_4_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (4 * 8);
        const real *restrict ed = in[1] + b * (4 * 8);
        const real *restrict p = in[3] + b * (24 * 8);
        real *restrict sigma = out[0] + b * (4 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[14 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[15 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[16 * 8 + j];
            const real ed_3 = ed[3 * 8 + j];
            const real D_14 = p[17 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[4 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[5 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[6 * 8 + j];
            const real e_3 = e[3 * 8 + j];
            const real S_14 = p[7 * 8 + j];
            const real t0 = e_2 * S_13 + e_3 * S_14 + e_1 * S_12 + e_0 * S_11;
            const real preload_0 = p[0 * 8 + j];
            sigma[0 * 8 + j] = ed_3 * D_14 + t0 + ed_2 * D_13 + ed_1 * D_12 + preload_0 + ed_0 * D_11;
            const real D_22 = p[18 * 8 + j];
            const real D_23 = p[19 * 8 + j];
            const real D_24 = p[20 * 8 + j];
            const real S_22 = p[8 * 8 + j];
            const real S_23 = p[9 * 8 + j];
            const real S_24 = p[10 * 8 + j];
            const real t1 = e_2 * S_23 + e_3 * S_24 + e_1 * S_22 + e_0 * S_12;
            const real preload_1 = p[1 * 8 + j];
            sigma[1 * 8 + j] = ed_3 * D_24 + t1 + ed_2 * D_23 + ed_1 * D_22 + preload_1 + ed_0 * D_12;
            const real D_33 = p[21 * 8 + j];
            const real D_34 = p[22 * 8 + j];
            const real S_33 = p[11 * 8 + j];
            const real S_34 = p[12 * 8 + j];
            const real t2 = e_2 * S_33 + e_3 * S_34 + e_1 * S_23 + e_0 * S_13;
            const real preload_2 = p[2 * 8 + j];
            sigma[2 * 8 + j] = ed_3 * D_34 + t2 + ed_2 * D_33 + ed_1 * D_23 + preload_2 + ed_0 * D_13;
            const real D_44 = p[23 * 8 + j];
            const real S_44 = p[13 * 8 + j];
            const real t3 = e_2 * S_34 + e_3 * S_44 + e_1 * S_24 + e_0 * S_14;
            const real preload_3 = p[3 * 8 + j];
            sigma[3 * 8 + j] = ed_3 * D_44 + t3 + ed_2 * D_34 + ed_1 * D_24 + preload_3 + ed_0 * D_14;
            const real t4 = e_3 * (preload_3 + 0.5 * t3) + e_2 * (preload_2 + 0.5 * t2);
            U[0 * 8 + j] = e_0 * (preload_0 + 0.5 * t0) + t4 + e_1 * (preload_1 + 0.5 * t1);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (4), ed (4), s (0), p (24)
 * out: J (4,8) */
FLEXEL_CLONES
static void linear_4_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (24 * 8);
        real *restrict J = out[0] + b * (32 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[4 * 8 + j];
            J[0 * 8 + j] = S_11;
            const real S_12 = p[5 * 8 + j];
            J[1 * 8 + j] = J[8 * 8 + j] = S_12;
            const real S_13 = p[6 * 8 + j];
            J[2 * 8 + j] = J[16 * 8 + j] = S_13;
            const real S_14 = p[7 * 8 + j];
            J[3 * 8 + j] = J[24 * 8 + j] = S_14;
            const real D_11 = p[14 * 8 + j];
            J[4 * 8 + j] = D_11;
            const real D_12 = p[15 * 8 + j];
            J[5 * 8 + j] = J[12 * 8 + j] = D_12;
            const real D_13 = p[16 * 8 + j];
            J[6 * 8 + j] = J[20 * 8 + j] = D_13;
            const real D_14 = p[17 * 8 + j];
            J[7 * 8 + j] = J[28 * 8 + j] = D_14;
            const real S_22 = p[8 * 8 + j];
            J[9 * 8 + j] = S_22;
            const real S_23 = p[9 * 8 + j];
            J[10 * 8 + j] = J[17 * 8 + j] = S_23;
            const real S_24 = p[10 * 8 + j];
            J[11 * 8 + j] = J[25 * 8 + j] = S_24;
            const real D_22 = p[18 * 8 + j];
            J[13 * 8 + j] = D_22;
            const real D_23 = p[19 * 8 + j];
            J[14 * 8 + j] = J[21 * 8 + j] = D_23;
            const real D_24 = p[20 * 8 + j];
            J[15 * 8 + j] = J[29 * 8 + j] = D_24;
            const real S_33 = p[11 * 8 + j];
            J[18 * 8 + j] = S_33;
            const real S_34 = p[12 * 8 + j];
            J[19 * 8 + j] = J[26 * 8 + j] = S_34;
            const real D_33 = p[21 * 8 + j];
            J[22 * 8 + j] = D_33;
            const real D_34 = p[22 * 8 + j];
            J[23 * 8 + j] = J[30 * 8 + j] = D_34;
            const real S_44 = p[13 * 8 + j];
            J[27 * 8 + j] = S_44;
            const real D_44 = p[23 * 8 + j];
            J[31 * 8 + j] = D_44;
        }
    }
}

const flexel_law flexel_law_linear_4 = {
    .name = "linear_4",
    .digest = "de4f40f20d7d189e",
    .m = 4,
    .k = 0,
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

/* law: 119 operations.
 * in:  e (5), ed (5), s (0), p (35)
 * out: sigma (5), tau (0), U (1) */
FLEXEL_CLONES
static void linear_5_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (5 * 8);
        const real *restrict ed = in[1] + b * (5 * 8);
        const real *restrict p = in[3] + b * (35 * 8);
        real *restrict sigma = out[0] + b * (5 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[20 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[21 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[22 * 8 + j];
            const real ed_3 = ed[3 * 8 + j];
            const real D_14 = p[23 * 8 + j];
            const real ed_4 = ed[4 * 8 + j];
            const real D_15 = p[24 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[5 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[6 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[7 * 8 + j];
            const real e_3 = e[3 * 8 + j];
            const real S_14 = p[8 * 8 + j];
            const real e_4 = e[4 * 8 + j];
            const real S_15 = p[9 * 8 + j];
            const real t0 = e_3 * S_14 + e_4 * S_15 + e_2 * S_13 + e_1 * S_12 + e_0 * S_11;
            const real t1 = ed_4 * D_15 + t0 + ed_3 * D_14 + ed_2 * D_13 + ed_1 * D_12;
            const real preload_0 = p[0 * 8 + j];
            sigma[0 * 8 + j] = preload_0 + t1 + ed_0 * D_11;
            const real D_22 = p[25 * 8 + j];
            const real D_23 = p[26 * 8 + j];
            const real D_24 = p[27 * 8 + j];
            const real D_25 = p[28 * 8 + j];
            const real S_22 = p[10 * 8 + j];
            const real S_23 = p[11 * 8 + j];
            const real S_24 = p[12 * 8 + j];
            const real S_25 = p[13 * 8 + j];
            const real t2 = e_3 * S_24 + e_4 * S_25 + e_2 * S_23 + e_1 * S_22 + e_0 * S_12;
            const real t3 = ed_4 * D_25 + t2 + ed_3 * D_24 + ed_2 * D_23 + ed_1 * D_22;
            const real preload_1 = p[1 * 8 + j];
            sigma[1 * 8 + j] = preload_1 + t3 + ed_0 * D_12;
            const real D_33 = p[29 * 8 + j];
            const real D_34 = p[30 * 8 + j];
            const real D_35 = p[31 * 8 + j];
            const real S_33 = p[14 * 8 + j];
            const real S_34 = p[15 * 8 + j];
            const real S_35 = p[16 * 8 + j];
            const real t4 = e_3 * S_34 + e_4 * S_35 + e_2 * S_33 + e_1 * S_23 + e_0 * S_13;
            const real t5 = ed_4 * D_35 + t4 + ed_3 * D_34 + ed_2 * D_33 + ed_1 * D_23;
            const real preload_2 = p[2 * 8 + j];
            sigma[2 * 8 + j] = preload_2 + t5 + ed_0 * D_13;
            const real D_44 = p[32 * 8 + j];
            const real D_45 = p[33 * 8 + j];
            const real S_44 = p[17 * 8 + j];
            const real S_45 = p[18 * 8 + j];
            const real t6 = e_3 * S_44 + e_4 * S_45 + e_2 * S_34 + e_1 * S_24 + e_0 * S_14;
            const real t7 = ed_4 * D_45 + t6 + ed_3 * D_44 + ed_2 * D_34 + ed_1 * D_24;
            const real preload_3 = p[3 * 8 + j];
            sigma[3 * 8 + j] = preload_3 + t7 + ed_0 * D_14;
            const real D_55 = p[34 * 8 + j];
            const real S_55 = p[19 * 8 + j];
            const real t8 = e_3 * S_45 + e_4 * S_55 + e_2 * S_35 + e_1 * S_25 + e_0 * S_15;
            const real t9 = ed_4 * D_55 + t8 + ed_3 * D_45 + ed_2 * D_35 + ed_1 * D_25;
            const real preload_4 = p[4 * 8 + j];
            sigma[4 * 8 + j] = preload_4 + t9 + ed_0 * D_15;
            const real t10 = e_4 * (preload_4 + 0.5 * t8) + e_3 * (preload_3 + 0.5 * t6);
            const real t11 = e_2 * (preload_2 + 0.5 * t4) + t10 + e_0 * (preload_0 + 0.5 * t0);
            U[0 * 8 + j] = e_1 * (preload_1 + 0.5 * t2) + t11;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (5), ed (5), s (0), p (35)
 * out: J (5,10) */
FLEXEL_CLONES
static void linear_5_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (35 * 8);
        real *restrict J = out[0] + b * (50 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[5 * 8 + j];
            J[0 * 8 + j] = S_11;
            const real S_12 = p[6 * 8 + j];
            J[1 * 8 + j] = J[10 * 8 + j] = S_12;
            const real S_13 = p[7 * 8 + j];
            J[2 * 8 + j] = J[20 * 8 + j] = S_13;
            const real S_14 = p[8 * 8 + j];
            J[3 * 8 + j] = J[30 * 8 + j] = S_14;
            const real S_15 = p[9 * 8 + j];
            J[4 * 8 + j] = J[40 * 8 + j] = S_15;
            const real D_11 = p[20 * 8 + j];
            J[5 * 8 + j] = D_11;
            const real D_12 = p[21 * 8 + j];
            J[6 * 8 + j] = J[15 * 8 + j] = D_12;
            const real D_13 = p[22 * 8 + j];
            J[7 * 8 + j] = J[25 * 8 + j] = D_13;
            const real D_14 = p[23 * 8 + j];
            J[8 * 8 + j] = J[35 * 8 + j] = D_14;
            const real D_15 = p[24 * 8 + j];
            J[9 * 8 + j] = J[45 * 8 + j] = D_15;
            const real S_22 = p[10 * 8 + j];
            J[11 * 8 + j] = S_22;
            const real S_23 = p[11 * 8 + j];
            J[12 * 8 + j] = J[21 * 8 + j] = S_23;
            const real S_24 = p[12 * 8 + j];
            J[13 * 8 + j] = J[31 * 8 + j] = S_24;
            const real S_25 = p[13 * 8 + j];
            J[14 * 8 + j] = J[41 * 8 + j] = S_25;
            const real D_22 = p[25 * 8 + j];
            J[16 * 8 + j] = D_22;
            const real D_23 = p[26 * 8 + j];
            J[17 * 8 + j] = J[26 * 8 + j] = D_23;
            const real D_24 = p[27 * 8 + j];
            J[18 * 8 + j] = J[36 * 8 + j] = D_24;
            const real D_25 = p[28 * 8 + j];
            J[19 * 8 + j] = J[46 * 8 + j] = D_25;
            const real S_33 = p[14 * 8 + j];
            J[22 * 8 + j] = S_33;
            const real S_34 = p[15 * 8 + j];
            J[23 * 8 + j] = J[32 * 8 + j] = S_34;
            const real S_35 = p[16 * 8 + j];
            J[24 * 8 + j] = J[42 * 8 + j] = S_35;
            const real D_33 = p[29 * 8 + j];
            J[27 * 8 + j] = D_33;
            const real D_34 = p[30 * 8 + j];
            J[28 * 8 + j] = J[37 * 8 + j] = D_34;
            const real D_35 = p[31 * 8 + j];
            J[29 * 8 + j] = J[47 * 8 + j] = D_35;
            const real S_44 = p[17 * 8 + j];
            J[33 * 8 + j] = S_44;
            const real S_45 = p[18 * 8 + j];
            J[34 * 8 + j] = J[43 * 8 + j] = S_45;
            const real D_44 = p[32 * 8 + j];
            J[38 * 8 + j] = D_44;
            const real D_45 = p[33 * 8 + j];
            J[39 * 8 + j] = J[48 * 8 + j] = D_45;
            const real S_55 = p[19 * 8 + j];
            J[44 * 8 + j] = S_55;
            const real D_55 = p[34 * 8 + j];
            J[49 * 8 + j] = D_55;
        }
    }
}

const flexel_law flexel_law_linear_5 = {
    .name = "linear_5",
    .digest = "de4f40f20d7d189e",
    .m = 5,
    .k = 0,
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

/* law: 167 operations.
 * in:  e (6), ed (6), s (0), p (48)
 * out: sigma (6), tau (0), U (1) */
FLEXEL_CLONES
static void linear_6_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (6 * 8);
        const real *restrict ed = in[1] + b * (6 * 8);
        const real *restrict p = in[3] + b * (48 * 8);
        real *restrict sigma = out[0] + b * (6 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real ed_0 = ed[0 * 8 + j];
            const real D_11 = p[27 * 8 + j];
            const real ed_1 = ed[1 * 8 + j];
            const real D_12 = p[28 * 8 + j];
            const real ed_2 = ed[2 * 8 + j];
            const real D_13 = p[29 * 8 + j];
            const real ed_3 = ed[3 * 8 + j];
            const real D_14 = p[30 * 8 + j];
            const real ed_4 = ed[4 * 8 + j];
            const real D_15 = p[31 * 8 + j];
            const real ed_5 = ed[5 * 8 + j];
            const real D_16 = p[32 * 8 + j];
            const real e_0 = e[0 * 8 + j];
            const real S_11 = p[6 * 8 + j];
            const real e_1 = e[1 * 8 + j];
            const real S_12 = p[7 * 8 + j];
            const real e_2 = e[2 * 8 + j];
            const real S_13 = p[8 * 8 + j];
            const real e_3 = e[3 * 8 + j];
            const real S_14 = p[9 * 8 + j];
            const real e_4 = e[4 * 8 + j];
            const real S_15 = p[10 * 8 + j];
            const real e_5 = e[5 * 8 + j];
            const real S_16 = p[11 * 8 + j];
            const real t0 = e_4 * S_15 + e_5 * S_16 + e_3 * S_14 + e_2 * S_13 + e_1 * S_12;
            const real t1 = e_0 * S_11 + t0;
            const real t2 = ed_5 * D_16 + t1 + ed_4 * D_15 + ed_3 * D_14 + ed_2 * D_13;
            const real preload_0 = p[0 * 8 + j];
            sigma[0 * 8 + j] = ed_1 * D_12 + t2 + preload_0 + ed_0 * D_11;
            const real D_22 = p[33 * 8 + j];
            const real D_23 = p[34 * 8 + j];
            const real D_24 = p[35 * 8 + j];
            const real D_25 = p[36 * 8 + j];
            const real D_26 = p[37 * 8 + j];
            const real S_22 = p[12 * 8 + j];
            const real S_23 = p[13 * 8 + j];
            const real S_24 = p[14 * 8 + j];
            const real S_25 = p[15 * 8 + j];
            const real S_26 = p[16 * 8 + j];
            const real t3 = e_4 * S_25 + e_5 * S_26 + e_3 * S_24 + e_2 * S_23 + e_1 * S_22;
            const real t4 = e_0 * S_12 + t3;
            const real t5 = ed_5 * D_26 + t4 + ed_4 * D_25 + ed_3 * D_24 + ed_2 * D_23;
            const real preload_1 = p[1 * 8 + j];
            sigma[1 * 8 + j] = ed_1 * D_22 + t5 + preload_1 + ed_0 * D_12;
            const real D_33 = p[38 * 8 + j];
            const real D_34 = p[39 * 8 + j];
            const real D_35 = p[40 * 8 + j];
            const real D_36 = p[41 * 8 + j];
            const real S_33 = p[17 * 8 + j];
            const real S_34 = p[18 * 8 + j];
            const real S_35 = p[19 * 8 + j];
            const real S_36 = p[20 * 8 + j];
            const real t6 = e_4 * S_35 + e_5 * S_36 + e_3 * S_34 + e_2 * S_33 + e_1 * S_23;
            const real t7 = e_0 * S_13 + t6;
            const real t8 = ed_5 * D_36 + t7 + ed_4 * D_35 + ed_3 * D_34 + ed_2 * D_33;
            const real preload_2 = p[2 * 8 + j];
            sigma[2 * 8 + j] = ed_1 * D_23 + t8 + preload_2 + ed_0 * D_13;
            const real D_44 = p[42 * 8 + j];
            const real D_45 = p[43 * 8 + j];
            const real D_46 = p[44 * 8 + j];
            const real S_44 = p[21 * 8 + j];
            const real S_45 = p[22 * 8 + j];
            const real S_46 = p[23 * 8 + j];
            const real t9 = e_4 * S_45 + e_5 * S_46 + e_3 * S_44 + e_2 * S_34 + e_1 * S_24;
            const real t10 = e_0 * S_14 + t9;
            const real t11 = ed_5 * D_46 + t10 + ed_4 * D_45 + ed_3 * D_44 + ed_2 * D_34;
            const real preload_3 = p[3 * 8 + j];
            sigma[3 * 8 + j] = ed_1 * D_24 + t11 + preload_3 + ed_0 * D_14;
            const real D_55 = p[45 * 8 + j];
            const real D_56 = p[46 * 8 + j];
            const real S_55 = p[24 * 8 + j];
            const real S_56 = p[25 * 8 + j];
            const real t12 = e_4 * S_55 + e_5 * S_56 + e_3 * S_45 + e_2 * S_35 + e_1 * S_25;
            const real t13 = e_0 * S_15 + t12;
            const real t14 = ed_5 * D_56 + t13 + ed_4 * D_55 + ed_3 * D_45 + ed_2 * D_35;
            const real preload_4 = p[4 * 8 + j];
            sigma[4 * 8 + j] = ed_1 * D_25 + t14 + preload_4 + ed_0 * D_15;
            const real D_66 = p[47 * 8 + j];
            const real S_66 = p[26 * 8 + j];
            const real t15 = e_4 * S_56 + e_5 * S_66 + e_3 * S_46 + e_2 * S_36 + e_1 * S_26;
            const real t16 = e_0 * S_16 + t15;
            const real t17 = ed_5 * D_66 + t16 + ed_4 * D_56 + ed_3 * D_46 + ed_2 * D_36;
            const real preload_5 = p[5 * 8 + j];
            sigma[5 * 8 + j] = ed_1 * D_26 + t17 + preload_5 + ed_0 * D_16;
            const real t18 = e_5 * (preload_5 + 0.5 * t16) + e_4 * (preload_4 + 0.5 * t13);
            const real t19 = e_3 * (preload_3 + 0.5 * t10) + t18 + e_2 * (preload_2 + 0.5 * t7);
            U[0 * 8 + j] = e_0 * (preload_0 + 0.5 * t1) + t19 + e_1 * (preload_1 + 0.5 * t4);
        }
    }
}

/* tangent: 0 operations.
 * in:  e (6), ed (6), s (0), p (48)
 * out: J (6,12) */
FLEXEL_CLONES
static void linear_6_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (48 * 8);
        real *restrict J = out[0] + b * (72 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_11 = p[6 * 8 + j];
            J[0 * 8 + j] = S_11;
            const real S_12 = p[7 * 8 + j];
            J[1 * 8 + j] = J[12 * 8 + j] = S_12;
            const real S_13 = p[8 * 8 + j];
            J[2 * 8 + j] = J[24 * 8 + j] = S_13;
            const real S_14 = p[9 * 8 + j];
            J[3 * 8 + j] = J[36 * 8 + j] = S_14;
            const real S_15 = p[10 * 8 + j];
            J[4 * 8 + j] = J[48 * 8 + j] = S_15;
            const real S_16 = p[11 * 8 + j];
            J[5 * 8 + j] = J[60 * 8 + j] = S_16;
            const real D_11 = p[27 * 8 + j];
            J[6 * 8 + j] = D_11;
            const real D_12 = p[28 * 8 + j];
            J[7 * 8 + j] = J[18 * 8 + j] = D_12;
            const real D_13 = p[29 * 8 + j];
            J[8 * 8 + j] = J[30 * 8 + j] = D_13;
            const real D_14 = p[30 * 8 + j];
            J[9 * 8 + j] = J[42 * 8 + j] = D_14;
            const real D_15 = p[31 * 8 + j];
            J[10 * 8 + j] = J[54 * 8 + j] = D_15;
            const real D_16 = p[32 * 8 + j];
            J[11 * 8 + j] = J[66 * 8 + j] = D_16;
            const real S_22 = p[12 * 8 + j];
            J[13 * 8 + j] = S_22;
            const real S_23 = p[13 * 8 + j];
            J[14 * 8 + j] = J[25 * 8 + j] = S_23;
            const real S_24 = p[14 * 8 + j];
            J[15 * 8 + j] = J[37 * 8 + j] = S_24;
            const real S_25 = p[15 * 8 + j];
            J[16 * 8 + j] = J[49 * 8 + j] = S_25;
            const real S_26 = p[16 * 8 + j];
            J[17 * 8 + j] = J[61 * 8 + j] = S_26;
            const real D_22 = p[33 * 8 + j];
            J[19 * 8 + j] = D_22;
            const real D_23 = p[34 * 8 + j];
            J[20 * 8 + j] = J[31 * 8 + j] = D_23;
            const real D_24 = p[35 * 8 + j];
            J[21 * 8 + j] = J[43 * 8 + j] = D_24;
            const real D_25 = p[36 * 8 + j];
            J[22 * 8 + j] = J[55 * 8 + j] = D_25;
            const real D_26 = p[37 * 8 + j];
            J[23 * 8 + j] = J[67 * 8 + j] = D_26;
            const real S_33 = p[17 * 8 + j];
            J[26 * 8 + j] = S_33;
            const real S_34 = p[18 * 8 + j];
            J[27 * 8 + j] = J[38 * 8 + j] = S_34;
            const real S_35 = p[19 * 8 + j];
            J[28 * 8 + j] = J[50 * 8 + j] = S_35;
            const real S_36 = p[20 * 8 + j];
            J[29 * 8 + j] = J[62 * 8 + j] = S_36;
            const real D_33 = p[38 * 8 + j];
            J[32 * 8 + j] = D_33;
            const real D_34 = p[39 * 8 + j];
            J[33 * 8 + j] = J[44 * 8 + j] = D_34;
            const real D_35 = p[40 * 8 + j];
            J[34 * 8 + j] = J[56 * 8 + j] = D_35;
            const real D_36 = p[41 * 8 + j];
            J[35 * 8 + j] = J[68 * 8 + j] = D_36;
            const real S_44 = p[21 * 8 + j];
            J[39 * 8 + j] = S_44;
            const real S_45 = p[22 * 8 + j];
            J[40 * 8 + j] = J[51 * 8 + j] = S_45;
            const real S_46 = p[23 * 8 + j];
            J[41 * 8 + j] = J[63 * 8 + j] = S_46;
            const real D_44 = p[42 * 8 + j];
            J[45 * 8 + j] = D_44;
            const real D_45 = p[43 * 8 + j];
            J[46 * 8 + j] = J[57 * 8 + j] = D_45;
            const real D_46 = p[44 * 8 + j];
            J[47 * 8 + j] = J[69 * 8 + j] = D_46;
            const real S_55 = p[24 * 8 + j];
            J[52 * 8 + j] = S_55;
            const real S_56 = p[25 * 8 + j];
            J[53 * 8 + j] = J[64 * 8 + j] = S_56;
            const real D_55 = p[45 * 8 + j];
            J[58 * 8 + j] = D_55;
            const real D_56 = p[46 * 8 + j];
            J[59 * 8 + j] = J[70 * 8 + j] = D_56;
            const real S_66 = p[26 * 8 + j];
            J[65 * 8 + j] = S_66;
            const real D_66 = p[47 * 8 + j];
            J[71 * 8 + j] = D_66;
        }
    }
}

const flexel_law flexel_law_linear_6 = {
    .name = "linear_6",
    .digest = "de4f40f20d7d189e",
    .m = 6,
    .k = 0,
    .np = 48,
    .law = linear_6_law,
    .tangent = linear_6_tangent,
};

/* diagonal_7
 *
 * sigma_i = preload_i + S_i e_i + D_i ed_i
 * energy = sum of preload_i e_i + S_i e_i^2/2
 *
 * Source: Kelvin-Voigt model
 *
 * 7 deformations, 0 slips
 * p (21):
 *   preload (7) [N or N m]: stress at zero deformation
 *   S (7) [N/m or N m]: stiffness of each deformation
 *   D (7) [N s/m or N m s]: damping of each deformation */

/* law: 55 operations.
 * in:  e (7), ed (7), s (0), p (21)
 * out: sigma (7), tau (0), U (1) */
FLEXEL_CLONES
static void diagonal_7_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (7 * 8);
        const real *restrict ed = in[1] + b * (7 * 8);
        const real *restrict p = in[3] + b * (21 * 8);
        real *restrict sigma = out[0] + b * (7 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            const real S_0 = p[7 * 8 + j];
            const real t0 = e_0 * S_0;
            const real ed_0 = ed[0 * 8 + j];
            const real D_0 = p[14 * 8 + j];
            const real preload_0 = p[0 * 8 + j];
            sigma[0 * 8 + j] = preload_0 + ed_0 * D_0 + t0;
            const real e_1 = e[1 * 8 + j];
            const real S_1 = p[8 * 8 + j];
            const real t1 = e_1 * S_1;
            const real ed_1 = ed[1 * 8 + j];
            const real D_1 = p[15 * 8 + j];
            const real preload_1 = p[1 * 8 + j];
            sigma[1 * 8 + j] = preload_1 + ed_1 * D_1 + t1;
            const real e_2 = e[2 * 8 + j];
            const real S_2 = p[9 * 8 + j];
            const real t2 = e_2 * S_2;
            const real ed_2 = ed[2 * 8 + j];
            const real D_2 = p[16 * 8 + j];
            const real preload_2 = p[2 * 8 + j];
            sigma[2 * 8 + j] = preload_2 + ed_2 * D_2 + t2;
            const real e_3 = e[3 * 8 + j];
            const real S_3 = p[10 * 8 + j];
            const real t3 = e_3 * S_3;
            const real ed_3 = ed[3 * 8 + j];
            const real D_3 = p[17 * 8 + j];
            const real preload_3 = p[3 * 8 + j];
            sigma[3 * 8 + j] = preload_3 + ed_3 * D_3 + t3;
            const real e_4 = e[4 * 8 + j];
            const real S_4 = p[11 * 8 + j];
            const real t4 = e_4 * S_4;
            const real ed_4 = ed[4 * 8 + j];
            const real D_4 = p[18 * 8 + j];
            const real preload_4 = p[4 * 8 + j];
            sigma[4 * 8 + j] = preload_4 + ed_4 * D_4 + t4;
            const real e_5 = e[5 * 8 + j];
            const real S_5 = p[12 * 8 + j];
            const real t5 = e_5 * S_5;
            const real ed_5 = ed[5 * 8 + j];
            const real D_5 = p[19 * 8 + j];
            const real preload_5 = p[5 * 8 + j];
            sigma[5 * 8 + j] = preload_5 + ed_5 * D_5 + t5;
            const real e_6 = e[6 * 8 + j];
            const real S_6 = p[13 * 8 + j];
            const real t6 = e_6 * S_6;
            const real ed_6 = ed[6 * 8 + j];
            const real D_6 = p[20 * 8 + j];
            const real preload_6 = p[6 * 8 + j];
            sigma[6 * 8 + j] = preload_6 + ed_6 * D_6 + t6;
            const real t7 = e_0 * (preload_0 + 0.5 * t0) + e_1 * (preload_1 + 0.5 * t1);
            const real t8 = e_2 * (preload_2 + 0.5 * t2) + t7 + e_3 * (preload_3 + 0.5 * t3);
            const real t9 = e_4 * (preload_4 + 0.5 * t4) + t8 + e_5 * (preload_5 + 0.5 * t5);
            U[0 * 8 + j] = e_6 * (preload_6 + 0.5 * t6) + t9;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (7), ed (7), s (0), p (21)
 * out: J (7,14), 14 of 98 entries */
FLEXEL_CLONES
static void diagonal_7_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (21 * 8);
        real *restrict J = out[0] + b * (14 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_0 = p[7 * 8 + j];
            J[0 * 8 + j] = S_0;
            const real D_0 = p[14 * 8 + j];
            J[1 * 8 + j] = D_0;
            const real S_1 = p[8 * 8 + j];
            J[2 * 8 + j] = S_1;
            const real D_1 = p[15 * 8 + j];
            J[3 * 8 + j] = D_1;
            const real S_2 = p[9 * 8 + j];
            J[4 * 8 + j] = S_2;
            const real D_2 = p[16 * 8 + j];
            J[5 * 8 + j] = D_2;
            const real S_3 = p[10 * 8 + j];
            J[6 * 8 + j] = S_3;
            const real D_3 = p[17 * 8 + j];
            J[7 * 8 + j] = D_3;
            const real S_4 = p[11 * 8 + j];
            J[8 * 8 + j] = S_4;
            const real D_4 = p[18 * 8 + j];
            J[9 * 8 + j] = D_4;
            const real S_5 = p[12 * 8 + j];
            J[10 * 8 + j] = S_5;
            const real D_5 = p[19 * 8 + j];
            J[11 * 8 + j] = D_5;
            const real S_6 = p[13 * 8 + j];
            J[12 * 8 + j] = S_6;
            const real D_6 = p[20 * 8 + j];
            J[13 * 8 + j] = D_6;
        }
    }
}

const flexel_law flexel_law_diagonal_7 = {
    .name = "diagonal_7",
    .digest = "de4f40f20d7d189e",
    .m = 7,
    .k = 0,
    .np = 21,
    .law = diagonal_7_law,
    .tangent = diagonal_7_tangent,
};

/* diagonal_13
 *
 * sigma_i = preload_i + S_i e_i + D_i ed_i
 * energy = sum of preload_i e_i + S_i e_i^2/2
 *
 * Source: Kelvin-Voigt model
 *
 * 13 deformations, 0 slips
 * p (39):
 *   preload (13) [N or N m]: stress at zero deformation
 *   S (13) [N/m or N m]: stiffness of each deformation
 *   D (13) [N s/m or N m s]: damping of each deformation */

/* law: 103 operations.
 * in:  e (13), ed (13), s (0), p (39)
 * out: sigma (13), tau (0), U (1) */
FLEXEL_CLONES
static void diagonal_13_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict e = in[0] + b * (13 * 8);
        const real *restrict ed = in[1] + b * (13 * 8);
        const real *restrict p = in[3] + b * (39 * 8);
        real *restrict sigma = out[0] + b * (13 * 8);
        real *restrict U = out[2] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real e_0 = e[0 * 8 + j];
            const real S_0 = p[13 * 8 + j];
            const real t0 = e_0 * S_0;
            const real ed_0 = ed[0 * 8 + j];
            const real D_0 = p[26 * 8 + j];
            const real preload_0 = p[0 * 8 + j];
            sigma[0 * 8 + j] = preload_0 + ed_0 * D_0 + t0;
            const real e_1 = e[1 * 8 + j];
            const real S_1 = p[14 * 8 + j];
            const real t1 = e_1 * S_1;
            const real ed_1 = ed[1 * 8 + j];
            const real D_1 = p[27 * 8 + j];
            const real preload_1 = p[1 * 8 + j];
            sigma[1 * 8 + j] = preload_1 + ed_1 * D_1 + t1;
            const real e_2 = e[2 * 8 + j];
            const real S_2 = p[15 * 8 + j];
            const real t2 = e_2 * S_2;
            const real ed_2 = ed[2 * 8 + j];
            const real D_2 = p[28 * 8 + j];
            const real preload_2 = p[2 * 8 + j];
            sigma[2 * 8 + j] = preload_2 + ed_2 * D_2 + t2;
            const real e_3 = e[3 * 8 + j];
            const real S_3 = p[16 * 8 + j];
            const real t3 = e_3 * S_3;
            const real ed_3 = ed[3 * 8 + j];
            const real D_3 = p[29 * 8 + j];
            const real preload_3 = p[3 * 8 + j];
            sigma[3 * 8 + j] = preload_3 + ed_3 * D_3 + t3;
            const real e_4 = e[4 * 8 + j];
            const real S_4 = p[17 * 8 + j];
            const real t4 = e_4 * S_4;
            const real ed_4 = ed[4 * 8 + j];
            const real D_4 = p[30 * 8 + j];
            const real preload_4 = p[4 * 8 + j];
            sigma[4 * 8 + j] = preload_4 + ed_4 * D_4 + t4;
            const real e_5 = e[5 * 8 + j];
            const real S_5 = p[18 * 8 + j];
            const real t5 = e_5 * S_5;
            const real ed_5 = ed[5 * 8 + j];
            const real D_5 = p[31 * 8 + j];
            const real preload_5 = p[5 * 8 + j];
            sigma[5 * 8 + j] = preload_5 + ed_5 * D_5 + t5;
            const real e_6 = e[6 * 8 + j];
            const real S_6 = p[19 * 8 + j];
            const real t6 = e_6 * S_6;
            const real ed_6 = ed[6 * 8 + j];
            const real D_6 = p[32 * 8 + j];
            const real preload_6 = p[6 * 8 + j];
            sigma[6 * 8 + j] = preload_6 + ed_6 * D_6 + t6;
            const real e_7 = e[7 * 8 + j];
            const real S_7 = p[20 * 8 + j];
            const real t7 = e_7 * S_7;
            const real ed_7 = ed[7 * 8 + j];
            const real D_7 = p[33 * 8 + j];
            const real preload_7 = p[7 * 8 + j];
            sigma[7 * 8 + j] = preload_7 + ed_7 * D_7 + t7;
            const real e_8 = e[8 * 8 + j];
            const real S_8 = p[21 * 8 + j];
            const real t8 = e_8 * S_8;
            const real ed_8 = ed[8 * 8 + j];
            const real D_8 = p[34 * 8 + j];
            const real preload_8 = p[8 * 8 + j];
            sigma[8 * 8 + j] = preload_8 + ed_8 * D_8 + t8;
            const real e_9 = e[9 * 8 + j];
            const real S_9 = p[22 * 8 + j];
            const real t9 = e_9 * S_9;
            const real ed_9 = ed[9 * 8 + j];
            const real D_9 = p[35 * 8 + j];
            const real preload_9 = p[9 * 8 + j];
            sigma[9 * 8 + j] = preload_9 + ed_9 * D_9 + t9;
            const real e_10 = e[10 * 8 + j];
            const real S_10 = p[23 * 8 + j];
            const real t10 = e_10 * S_10;
            const real ed_10 = ed[10 * 8 + j];
            const real D_10 = p[36 * 8 + j];
            const real preload_10 = p[10 * 8 + j];
            sigma[10 * 8 + j] = preload_10 + ed_10 * D_10 + t10;
            const real e_11 = e[11 * 8 + j];
            const real S_11 = p[24 * 8 + j];
            const real t11 = e_11 * S_11;
            const real ed_11 = ed[11 * 8 + j];
            const real D_11 = p[37 * 8 + j];
            const real preload_11 = p[11 * 8 + j];
            sigma[11 * 8 + j] = preload_11 + ed_11 * D_11 + t11;
            const real e_12 = e[12 * 8 + j];
            const real S_12 = p[25 * 8 + j];
            const real t12 = e_12 * S_12;
            const real ed_12 = ed[12 * 8 + j];
            const real D_12 = p[38 * 8 + j];
            const real preload_12 = p[12 * 8 + j];
            sigma[12 * 8 + j] = preload_12 + ed_12 * D_12 + t12;
            const real t13 = e_0 * (preload_0 + 0.5 * t0) + e_1 * (preload_1 + 0.5 * t1);
            const real t14 = e_10 * (preload_10 + 0.5 * t10) + t13 + e_11 * (preload_11 + 0.5 * t11);
            const real t15 = e_12 * (preload_12 + 0.5 * t12) + t14 + e_2 * (preload_2 + 0.5 * t2);
            const real t16 = e_3 * (preload_3 + 0.5 * t3) + t15 + e_4 * (preload_4 + 0.5 * t4);
            const real t17 = e_5 * (preload_5 + 0.5 * t5) + t16 + e_6 * (preload_6 + 0.5 * t6);
            const real t18 = e_7 * (preload_7 + 0.5 * t7) + t17 + e_8 * (preload_8 + 0.5 * t8);
            U[0 * 8 + j] = e_9 * (preload_9 + 0.5 * t9) + t18;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (13), ed (13), s (0), p (39)
 * out: J (13,26), 26 of 338 entries */
FLEXEL_CLONES
static void diagonal_13_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (39 * 8);
        real *restrict J = out[0] + b * (26 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real S_0 = p[13 * 8 + j];
            J[0 * 8 + j] = S_0;
            const real D_0 = p[26 * 8 + j];
            J[1 * 8 + j] = D_0;
            const real S_1 = p[14 * 8 + j];
            J[2 * 8 + j] = S_1;
            const real D_1 = p[27 * 8 + j];
            J[3 * 8 + j] = D_1;
            const real S_2 = p[15 * 8 + j];
            J[4 * 8 + j] = S_2;
            const real D_2 = p[28 * 8 + j];
            J[5 * 8 + j] = D_2;
            const real S_3 = p[16 * 8 + j];
            J[6 * 8 + j] = S_3;
            const real D_3 = p[29 * 8 + j];
            J[7 * 8 + j] = D_3;
            const real S_4 = p[17 * 8 + j];
            J[8 * 8 + j] = S_4;
            const real D_4 = p[30 * 8 + j];
            J[9 * 8 + j] = D_4;
            const real S_5 = p[18 * 8 + j];
            J[10 * 8 + j] = S_5;
            const real D_5 = p[31 * 8 + j];
            J[11 * 8 + j] = D_5;
            const real S_6 = p[19 * 8 + j];
            J[12 * 8 + j] = S_6;
            const real D_6 = p[32 * 8 + j];
            J[13 * 8 + j] = D_6;
            const real S_7 = p[20 * 8 + j];
            J[14 * 8 + j] = S_7;
            const real D_7 = p[33 * 8 + j];
            J[15 * 8 + j] = D_7;
            const real S_8 = p[21 * 8 + j];
            J[16 * 8 + j] = S_8;
            const real D_8 = p[34 * 8 + j];
            J[17 * 8 + j] = D_8;
            const real S_9 = p[22 * 8 + j];
            J[18 * 8 + j] = S_9;
            const real D_9 = p[35 * 8 + j];
            J[19 * 8 + j] = D_9;
            const real S_10 = p[23 * 8 + j];
            J[20 * 8 + j] = S_10;
            const real D_10 = p[36 * 8 + j];
            J[21 * 8 + j] = D_10;
            const real S_11 = p[24 * 8 + j];
            J[22 * 8 + j] = S_11;
            const real D_11 = p[37 * 8 + j];
            J[23 * 8 + j] = D_11;
            const real S_12 = p[25 * 8 + j];
            J[24 * 8 + j] = S_12;
            const real D_12 = p[38 * 8 + j];
            J[25 * 8 + j] = D_12;
        }
    }
}

const flexel_law flexel_law_diagonal_13 = {
    .name = "diagonal_13",
    .digest = "de4f40f20d7d189e",
    .m = 13,
    .k = 0,
    .np = 39,
    .law = diagonal_13_law,
    .tangent = diagonal_13_tangent,
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

/* law: 1 operations.
 * in:  e (0), ed (0), s (1), p (1)
 * out: sigma (0), tau (1), U (1), 0 of 1 entries */
FLEXEL_CLONES
static void viscous_1_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (1 * 8);
        real *restrict tau = out[1] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_0 = s[0 * 8 + j];
            const real C = p[0 * 8 + j];
            tau[0 * 8 + j] = s_0 * C;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (1), p (1)
 * out: J (1,1) */
FLEXEL_CLONES
static void viscous_1_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (1 * 8);
        real *restrict J = out[0] + b * (1 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real C = p[0 * 8 + j];
            J[0 * 8 + j] = C;
        }
    }
}

const flexel_law flexel_law_viscous_1 = {
    .name = "viscous_1",
    .digest = "de4f40f20d7d189e",
    .m = 0,
    .k = 1,
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

/* law: 6 operations.
 * in:  e (0), ed (0), s (2), p (3)
 * out: sigma (0), tau (2), U (1), 0 of 1 entries */
FLEXEL_CLONES
static void viscous_2_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (2 * 8);
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict tau = out[1] + b * (2 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_0 = s[0 * 8 + j];
            const real C_11 = p[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real C_12 = p[1 * 8 + j];
            tau[0 * 8 + j] = s_0 * C_11 + s_1 * C_12;
            const real C_22 = p[2 * 8 + j];
            tau[1 * 8 + j] = s_0 * C_12 + s_1 * C_22;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (2), p (3)
 * out: J (2,2) */
FLEXEL_CLONES
static void viscous_2_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict J = out[0] + b * (4 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real C_11 = p[0 * 8 + j];
            J[0 * 8 + j] = C_11;
            const real C_12 = p[1 * 8 + j];
            J[1 * 8 + j] = J[2 * 8 + j] = C_12;
            const real C_22 = p[2 * 8 + j];
            J[3 * 8 + j] = C_22;
        }
    }
}

const flexel_law flexel_law_viscous_2 = {
    .name = "viscous_2",
    .digest = "de4f40f20d7d189e",
    .m = 0,
    .k = 2,
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

/* law: 15 operations.
 * in:  e (0), ed (0), s (3), p (6)
 * out: sigma (0), tau (3), U (1), 0 of 1 entries */
FLEXEL_CLONES
static void viscous_3_law(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict s = in[2] + b * (3 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict tau = out[1] + b * (3 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real s_2 = s[2 * 8 + j];
            const real C_13 = p[2 * 8 + j];
            const real s_0 = s[0 * 8 + j];
            const real C_11 = p[0 * 8 + j];
            const real s_1 = s[1 * 8 + j];
            const real C_12 = p[1 * 8 + j];
            tau[0 * 8 + j] = s_0 * C_11 + s_1 * C_12 + s_2 * C_13;
            const real C_23 = p[4 * 8 + j];
            const real C_22 = p[3 * 8 + j];
            tau[1 * 8 + j] = s_0 * C_12 + s_1 * C_22 + s_2 * C_23;
            const real C_33 = p[5 * 8 + j];
            tau[2 * 8 + j] = s_0 * C_13 + s_1 * C_23 + s_2 * C_33;
        }
    }
}

/* tangent: 0 operations.
 * in:  e (0), ed (0), s (3), p (6)
 * out: J (3,3) */
FLEXEL_CLONES
static void viscous_3_tangent(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict J = out[0] + b * (9 * 8);
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real C_11 = p[0 * 8 + j];
            J[0 * 8 + j] = C_11;
            const real C_12 = p[1 * 8 + j];
            J[1 * 8 + j] = J[3 * 8 + j] = C_12;
            const real C_13 = p[2 * 8 + j];
            J[2 * 8 + j] = J[6 * 8 + j] = C_13;
            const real C_22 = p[3 * 8 + j];
            J[4 * 8 + j] = C_22;
            const real C_23 = p[4 * 8 + j];
            J[5 * 8 + j] = J[7 * 8 + j] = C_23;
            const real C_33 = p[5 * 8 + j];
            J[8 * 8 + j] = C_33;
        }
    }
}

const flexel_law flexel_law_viscous_3 = {
    .name = "viscous_3",
    .digest = "de4f40f20d7d189e",
    .m = 0,
    .k = 3,
    .np = 6,
    .law = viscous_3_law,
    .tangent = viscous_3_tangent,
};
