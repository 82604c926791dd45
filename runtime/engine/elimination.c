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
    int *const arrays[] = {lu->row, lu->column, lu->first, lu->diagonal, lu->at, lu->slot, lu->list};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free(arrays[i]);
    free(lu->scale);
    free(lu->pass);
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

/* The multipliers of rows for `width` neighbouring pivots, in their slots. */
INLINE const int *multipliers(const int *list, int count, int width, double *a)
{
    for (int r = 0; r < count; r++, list += 1 + width) {
        double *slots = a + list[0];
        for (int j = 0; j < width; j++) {
            const double *row = a + list[1 + j] - width;
            double sum = slots[j];
            for (int i = 0; i < j; i++)
                sum -= slots[i] * a[list[1 + i] - width + j];
            slots[j] = sum * row[j];
        }
    }
    return list;
}

/* Subtract `width` pivot rows times multipliers from `length` neighbouring slots of other rows. */
INLINE const int *subtract(const int *list, int count, int length, int width, double *a)
{
    for (int r = 0; r < count; r++, list += 2 + width) {
        double *restrict to = a + list[0];
        const double *z = a + list[1], *p = a + list[2], *q = width > 1 ? a + list[3] : p;
        const double *s = width > 2 ? a + list[4] : p, *t = width > 3 ? a + list[5] : p;
#pragma omp simd simdlen(4)
        for (int i = 0; i < length; i++) {
            double sum = to[i] - z[0] * p[i];
            if (width > 1)
                sum -= z[1] * q[i];
            if (width > 2)
                sum -= z[2] * s[i];
            if (width > 3)
                sum -= z[3] * t[i];
            to[i] = sum;
        }
    }
    return list;
}

INLINE const int *eliminate(const flexel_pass *pass, const int *list, int width, double *a)
{
    list = multipliers(list, pass->rows, width, a);
    list = subtract(list, pass->fours, 4, width, a);
    list = subtract(list, pass->twos, 2, width, a);
    return subtract(list, pass->ones, 1, width, a);
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
    const int *list = lu->list;
    load(lu, source, buffer, a);
    for (const flexel_pass *pass = lu->pass; pass < lu->pass + lu->npasses; pass++) {
        switch (pass->width) {
        case 0: break;
        case 1: list = eliminate(pass, list, 1, a); break;
        case 2: list = eliminate(pass, list, 2, a); break;
        case 3: list = eliminate(pass, list, 3, a); break;
        default: list = eliminate(pass, list, FLEXEL_GROUP, a);
        }
        for (int i = 0; i < pass->pivots; i++, list++)
            if (!invert(lu, (size_t)*list, a))
                return (size_t)*list + 1;
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
