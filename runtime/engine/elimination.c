/* Sparse LU factors with a given order of the pivots: see elimination.h and lu.h. */
#include "kernels.h" /* for FLEXEL_CLONES */
#include "lu.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define INLINE static inline __attribute__((always_inline)) /* so that widths are known to the compiler */

void flexel_lu_free(flexel_lu *lu)
{
    if (!lu)
        return;
    int *const arrays[] = {lu->row, lu->column, lu->first, lu->diagonal, lu->at, lu->slot, lu->group,
                           lu->below, lu->multiplier, lu->run};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free(arrays[i]);
    free(lu->scale);
    free(lu->stretch);
    free(lu);
}

size_t flexel_lu_slots(const flexel_lu *lu)
{
    return lu->slots + lu->n;
}

size_t flexel_lu_operations(const flexel_lu *lu)
{
    return lu->operations;
}

/* Sum of the sizes of neighbouring entries, columns scaled; not a number if one of them is not. */
static inline double norm(const double *restrict a, const double *restrict scale, int count)
{
    double even = 0, odd = 0; /* two sums: an addition need not wait for the one before */
    int i = 0;
    for (; i + 1 < count; i += 2) {
        even += fabs(a[i]) * scale[i];
        odd += fabs(a[i + 1]) * scale[i + 1];
    }
    return i < count ? even + odd + fabs(a[i]) * scale[i] : even + odd;
}

/* The matrix into its slots, zeros into those of the fill, and the size of every row behind them. */
static inline void load(const flexel_lu *lu, const int *restrict source, const double *restrict buffer,
                        double *restrict a)
{
    memset(a, 0, lu->slots * sizeof *a);
    for (size_t e = 0; e < lu->nentries; e++)
        a[lu->slot[e]] = buffer[source[e]];
    for (size_t i = 0; i < lu->n; i++)
        a[lu->slots + i] = norm(a + lu->first[i], lu->scale + lu->first[i], lu->first[i + 1] - lu->first[i]);
}

/* The multipliers of a row for `width` neighbouring pivots, in their slots and in z; rows[j] is pivot row j from the
 * column behind these pivots on. */
INLINE void multipliers(double *slots, const double *const *rows, int width, double *z)
{
    for (int j = 0; j < width; j++) {
        double sum = slots[j];
        for (int i = 0; i < j; i++)
            sum -= z[i] * rows[i][j - width];
        z[j] = slots[j] = sum * rows[j][j - width];
    }
}

/* Subtract `width` pivot rows times z from neighbouring slots of another row; they start at `from` in the rows. */
INLINE void subtract_rows(double *restrict to, const double *const *rows, int from, int length, int width, const double *z)
{
    const double *p = rows[0] + from, *q = width > 1 ? rows[1] + from : p, *r = width > 2 ? rows[2] + from : p;
    const double *s = width > 3 ? rows[3] + from : p;
#pragma omp simd simdlen(4)
    for (int i = 0; i < length; i++) {
        double sum = to[i] - z[0] * p[i];
        if (width > 1)
            sum -= z[1] * q[i];
        if (width > 2)
            sum -= z[2] * r[i];
        if (width > 3)
            sum -= z[3] * s[i];
        to[i] = sum;
    }
}

/* The rows of `width` pivots from the column behind them on. */
INLINE void behind(const flexel_lu *lu, int first, int width, const double *a, const double **rows)
{
    for (int j = 0; j < width; j++)
        rows[j] = a + lu->diagonal[first + j] + width - j;
}

/* Subtract the first `width` rows of a group from its next row. */
INLINE void eliminate_inside(const flexel_lu *lu, int first, int width, double *a)
{
    const int d = lu->diagonal[first + width];
    const double *rows[FLEXEL_GROUP];
    double z[FLEXEL_GROUP];
    behind(lu, first, width, a, rows);
    multipliers(a + d - width, rows, width, z);
    subtract_rows(a + d, rows, 0, lu->first[first + width + 1] - d, width, z);
}

/* Subtract the rows of a group, `width` of them, from all rows below. */
INLINE void eliminate_below(const flexel_lu *lu, size_t g, int width, double *a)
{
    const int *run = lu->run + 3 * g;
    const double *rows[FLEXEL_GROUP];
    double z[FLEXEL_GROUP];
    behind(lu, lu->group[g], width, a, rows);
    for (int l = lu->below[g]; l < lu->below[g + 1]; l++)
        multipliers(a + lu->multiplier[l], rows, width, z);
    for (const flexel_stretch *r = lu->stretch + run[0]; r < lu->stretch + run[1]; r++)
        subtract_rows(a + r->to, rows, r->from, 4, width, a + r->by);
    for (const flexel_stretch *r = lu->stretch + run[1]; r < lu->stretch + run[2]; r++)
        subtract_rows(a + r->to, rows, r->from, 2, width, a + r->by);
    for (const flexel_stretch *r = lu->stretch + run[2]; r < lu->stretch + run[3]; r++)
        subtract_rows(a + r->to, rows, r->from, 1, width, a + r->by);
}

/* Whether a pivot is large enough; it is replaced by its inverse. */
static inline int invert(const flexel_lu *lu, size_t k, double *a)
{
    const int d = lu->diagonal[k], u = lu->first[k + 1] - d - 1;
    const double size = fabs(a[d]) * lu->scale[d], rest = norm(a + d + 1, lu->scale + d + 1, u);
    const int sound = size > 0 && size <= DBL_MAX && size >= FLEXEL_LEAST_PIVOT * a[lu->slots + k] &&
                      size * FLEXEL_MOST_GROWTH >= rest;
    a[d] = 1 / a[d];
    return sound;
}

FLEXEL_CLONES
size_t flexel_lu_factor(const flexel_lu *lu, const int *source, const double *buffer, double *a)
{
    load(lu, source, buffer, a);
    for (size_t g = 0; g < lu->groups; g++) {
        const int first = lu->group[g], width = lu->group[g + 1] - first;
        for (int j = 0; j < width; j++) {
            switch (j) {
            case 0: break;
            case 1: eliminate_inside(lu, first, 1, a); break;
            case 2: eliminate_inside(lu, first, 2, a); break;
            default: eliminate_inside(lu, first, FLEXEL_GROUP - 1, a);
            }
            if (!invert(lu, (size_t)(first + j), a))
                return (size_t)(first + j) + 1;
        }
        switch (width) {
        case 1: eliminate_below(lu, g, 1, a); break;
        case 2: eliminate_below(lu, g, 2, a); break;
        case 3: eliminate_below(lu, g, 3, a); break;
        default: eliminate_below(lu, g, FLEXEL_GROUP, a);
        }
    }
    return 0;
}

int flexel_lu_sign(const flexel_lu *lu, const double *a)
{
    int sign = lu->sign;
    for (size_t k = 0; k < lu->n; k++)
        sign = a[lu->diagonal[k]] < 0 ? -sign : sign;
    return sign;
}

double flexel_lu_logarithm(const flexel_lu *lu, const double *a)
{
    double mantissa = 1, exponents = 0;
    for (size_t k = 0; k < lu->n; k++) {
        int exponent;
        mantissa = frexp(mantissa * fabs(a[lu->diagonal[k]]), &exponent);
        exponents += exponent;
    }
    return -log2(mantissa) - exponents; /* of the inverses of the pivots */
}
