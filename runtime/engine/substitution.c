/* Solutions with sparse LU factors: see elimination.h and lu.h. */
#include "kernels.h" /* for FLEXEL_CLONES */
#include "lu_inside.h"

#include <string.h>

/* y (n by count) from the rows of b in the order given; the first row that is not zero. */
INLINE size_t gather(size_t n, const int *order, size_t count, const double *b, double *restrict y)
{
    size_t first = 0;
    for (size_t k = 0; k < n; k++)
        for (size_t c = 0; c < count; c++)
            y[k * count + c] = b[(size_t)order[k] * count + c];
    for (; first < n; first++)
        for (size_t c = 0; c < count; c++)
            if (y[first * count + c] != 0)
                return first;
    return n;
}

INLINE void scatter(size_t n, const int *order, size_t count, const double *restrict y, double *x)
{
    for (size_t k = 0; k < n; k++)
        for (size_t c = 0; c < count; c++)
            x[(size_t)order[k] * count + c] = y[k * count + c];
}

/* z -= the sum of a[s] times row at[s] of y, over neighbouring slots, for `width` of `count` columns. */
INLINE void subtract(double *restrict z, const double *restrict a, const int *restrict at, int slots,
                            const double *y, size_t count, size_t width)
{
    for (int s = 0; s < slots; s++)
        for (size_t c = 0; c < width; c++)
            z[c] -= a[s] * y[(size_t)at[s] * count + c];
}

/* L, then U, row by row, on `width` of `count` columns that are zero before row `first`. */
INLINE void sweep(const flexel_lu *lu, const double *restrict a, size_t first, double *y, size_t count,
                         size_t width)
{
    for (size_t i = first; i < lu->n; i++) {
        const int s = lu->first[i];
        double z[8];
        memcpy(z, y + i * count, width * sizeof *z);
        subtract(z, a + s, lu->at + s, lu->diagonal[i] - s, y, count, width);
        memcpy(y + i * count, z, width * sizeof *z);
    }
    for (size_t i = lu->n; i-- > 0;) {
        const int s = lu->diagonal[i] + 1;
        double z[8];
        memcpy(z, y + i * count, width * sizeof *z);
        subtract(z, a + s, lu->at + s, lu->first[i + 1] - s, y, count, width);
        for (size_t c = 0; c < width; c++)
            y[i * count + c] = z[c] * a[s - 1];
    }
}

/* Subtract a[s] z from row at[s] of y, for neighbouring slots. */
INLINE void spread(const double *restrict z, const double *restrict a, const int *restrict at, int slots,
                          double *y, size_t count, size_t width)
{
    for (int s = 0; s < slots; s++)
        for (size_t c = 0; c < width; c++)
            y[(size_t)at[s] * count + c] -= a[s] * z[c];
}

/* The same with the transposed factors: U', then L', column by column. */
INLINE void sweep_transposed(const flexel_lu *lu, const double *restrict a, size_t first, double *y,
                                    size_t count, size_t width)
{
    for (size_t i = first; i < lu->n; i++) {
        const int s = lu->diagonal[i] + 1;
        double z[8];
        for (size_t c = 0; c < width; c++)
            z[c] = y[i * count + c] *= a[s - 1];
        spread(z, a + s, lu->at + s, lu->first[i + 1] - s, y, count, width);
    }
    for (size_t i = lu->n; i-- > 0;) {
        const int s = lu->first[i];
        double z[8];
        memcpy(z, y + i * count, width * sizeof *z);
        spread(z, a + s, lu->at + s, lu->diagonal[i] - s, y, count, width);
    }
}

INLINE void solve(const flexel_lu *lu, const double *a, size_t count, const double *b, double *x, double *work)
{
    const size_t first = gather(lu->n, lu->row, count, b, work);
    size_t c = 0;
    if (count == 1)
        sweep_one(lu, a, first, work), c = 1;
    for (; c + 8 <= count; c += 8)
        sweep(lu, a, first, work + c, count, 8);
    for (; c + 4 <= count; c += 4)
        sweep(lu, a, first, work + c, count, 4);
    for (; c < count; c++)
        sweep(lu, a, first, work + c, count, 1);
    scatter(lu->n, lu->column, count, work, x);
}

FLEXEL_CLONES
void flexel_lu_solve(const flexel_lu *lu, const double *a, size_t count, const double *b, double *x, double *work)
{
    switch (count) { /* the usual numbers of columns have loops of their own */
    case 1: solve(lu, a, 1, b, x, work); break;
    case 4: solve(lu, a, 4, b, x, work); break;
    case 8: solve(lu, a, 8, b, x, work); break;
    case 12: solve(lu, a, 12, b, x, work); break;
    default: solve(lu, a, count, b, x, work);
    }
}

FLEXEL_CLONES
void flexel_lu_solve_transposed(const flexel_lu *lu, const double *a, size_t count, const double *b, double *x,
                                double *work)
{
    const size_t first = gather(lu->n, lu->column, count, b, work);
    size_t c = 0;
    for (; c + 4 <= count; c += 4)
        sweep_transposed(lu, a, first, work + c, count, 4);
    for (; c < count; c++)
        sweep_transposed(lu, a, first, work + c, count, 1);
    scatter(lu->n, lu->row, count, work, x);
}
