/* Factors and solutions of sparse matrices, written once for one matrix and for the lanes of eight; see lu.h. A number is a
 * double, unless the file that includes this says what it is, its absolute value and zero. SIDE_BY_SIDE stands before
 * loops over neighbouring numbers, of which several doubles are taken together. */
#include "lu.h"

#ifndef NUMBER
#include <math.h>
#define NUMBER double
#define SIZE(a) fabs(a)
#define ZERO 0.0
#define SIDE_BY_SIDE _Pragma("omp simd simdlen(4)")
#endif

#define INLINE static inline __attribute__((always_inline)) /* so that widths are known to the compiler */

/* Sum of the sizes of neighbouring entries, columns scaled; not a number if one of them is not. */
INLINE NUMBER norm(const NUMBER *restrict a, const double *restrict scale, int count)
{
    NUMBER even = ZERO, odd = even; /* two sums: an addition need not wait for the one before */
    int i = 0;
    for (; i + 1 < count; i += 2) {
        even += SIZE(a[i]) * scale[i];
        odd += SIZE(a[i + 1]) * scale[i + 1];
    }
    return i < count ? even + odd + SIZE(a[i]) * scale[i] : even + odd;
}

/* The matrix into its slots, zeros into those of the fill, and the size of every row behind them. */
INLINE void load(const flexel_lu *lu, const int *restrict source, const NUMBER *restrict buffer, NUMBER *restrict a)
{
    const size_t slots = lu->slots, nentries = lu->nentries;
    const int *restrict slot = lu->slot;
    for (size_t i = 0; i < slots; i++)
        a[i] = ZERO;
    for (size_t e = 0; e < nentries; e++)
        a[slot[e]] = buffer[source[e]];
    for (size_t i = 0; i < lu->n; i++)
        a[slots + i] = norm(a + lu->first[i], lu->scale + lu->first[i], lu->first[i + 1] - lu->first[i]);
}

/* The multipliers of rows for `width` neighbouring pivots, in their slots. */
INLINE const int *multipliers(const int *list, int count, int width, NUMBER *a)
{
    for (int r = 0; r < count; r++, list += 1 + width) {
        NUMBER *slots = a + list[0];
        for (int j = 0; j < width; j++) {
            const NUMBER *row = a + list[1 + j] - width;
            NUMBER sum = slots[j];
            for (int i = 0; i < j; i++)
                sum -= slots[i] * a[list[1 + i] - width + j];
            slots[j] = sum * row[j];
        }
    }
    return list;
}

/* Subtract `width` pivot rows times multipliers from `length` neighbouring slots of other rows. */
INLINE const int *subtract_pivots(const int *list, int count, int length, int width, NUMBER *a)
{
    for (int r = 0; r < count; r++, list += 2 + width) {
        NUMBER *restrict to = a + list[0];
        const NUMBER *z = a + list[1], *p = a + list[2], *q = width > 1 ? a + list[3] : p;
        const NUMBER *s = width > 2 ? a + list[4] : p, *t = width > 3 ? a + list[5] : p;
        SIDE_BY_SIDE
        for (int i = 0; i < length; i++) {
            NUMBER sum = to[i] - z[0] * p[i];
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

INLINE const int *eliminate_by(const flexel_pass *pass, const int *list, int width, NUMBER *a)
{
    list = multipliers(list, pass->rows, width, a);
    list = subtract_pivots(list, pass->fours, 4, width, a);
    list = subtract_pivots(list, pass->twos, 2, width, a);
    return subtract_pivots(list, pass->ones, 1, width, a);
}

/* What a pass subtracts; the numbers of its pivots follow in the list. */
INLINE const int *eliminate(const flexel_pass *pass, const int *list, NUMBER *a)
{
    switch (pass->width) {
    case 0: return list;
    case 1: return eliminate_by(pass, list, 1, a);
    case 2: return eliminate_by(pass, list, 2, a);
    case 3: return eliminate_by(pass, list, 3, a);
    default: return eliminate_by(pass, list, FLEXEL_GROUP, a);
    }
}

/* The sum of a[s] y[at[s]] over neighbouring slots, a multiple of four. */
INLINE NUMBER product(const NUMBER *restrict a, const int *restrict at, int slots, const NUMBER *restrict y)
{
    NUMBER sum[4] = {ZERO, ZERO, ZERO, ZERO}; /* an addition need not wait for the one before */
    for (int s = 0; s < slots; s += 4)
        for (int i = 0; i < 4; i++)
            sum[i] += a[s + i] * y[at[s + i]];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* L, then U, row by row, on one column that is zero before row `first`. The row that was computed last, which is that of the
 * last slot in L and of the first one in U, is taken last: the rest is done while it is computed. */
INLINE void sweep_one(const flexel_lu *lu, const NUMBER *restrict a, size_t first, NUMBER *restrict y)
{
    for (size_t i = first; i < lu->n; i++) {
        const int begin = lu->first[i], slots = lu->diagonal[i] - begin, *at = lu->at + begin;
        const int whole = slots > 0 ? (slots - 1) / 4 * 4 : 0;
        NUMBER z = y[i];
        if (whole)
            z -= product(a + begin, at, whole, y);
        for (int s = whole; s < slots; s++)
            z -= a[begin + s] * y[at[s]];
        y[i] = z;
    }
    for (size_t i = lu->n; i-- > 0;) {
        const int begin = lu->diagonal[i] + 1, slots = lu->first[i + 1] - begin, *at = lu->at + begin;
        const int rest = slots > 0 ? (slots - 1) % 4 + 1 : 0;
        NUMBER z = y[i];
        if (rest < slots)
            z -= product(a + begin + rest, at + rest, slots - rest, y);
        for (int s = rest; s-- > 0;)
            z -= a[begin + s] * y[at[s]];
        y[i] = z * a[begin - 1];
    }
}
