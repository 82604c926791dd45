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
            J[0 * 8 + j] = S;
            const real D = p[2 * 8 + j];
            J[1 * 8 + j] = D;
        }
    }
}

const flexel_law flexel_law_linear_1 = {
    .name = "linear_1",
    .digest = "cc2db1142740f860",
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
    .digest = "cc2db1142740f860",
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
            const real t9 = e_2 * (ed_0 * S_13 + ed_1 * S_23 + ed_2 * S_33) + e_0 * (ed_0 * S_11 + ed_1 * S_12 + ed_2 * S_13);
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
    .digest = "cc2db1142740f860",
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
    .digest = "cc2db1142740f860",
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
    .digest = "cc2db1142740f860",
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
    .digest = "cc2db1142740f860",
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
            J[0 * 8 + j] = C;
        }
    }
}

const flexel_law flexel_law_viscous_1 = {
    .name = "viscous_1",
    .digest = "cc2db1142740f860",
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
    .digest = "cc2db1142740f860",
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
    .digest = "cc2db1142740f860",
    .m = 0,
    .k = 3,
    .nz = 0,
    .np = 6,
    .law = viscous_3_law,
    .tangent = viscous_3_tangent,
};
