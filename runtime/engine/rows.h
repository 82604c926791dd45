/* Rows of J times vectors and columns. */
#ifndef FLEXEL_ROWS_H
#define FLEXEL_ROWS_H

#include "table.h"

#include <string.h>

/* out[j] = sum over a row of J, free columns only, of J[.] in[.][j], j < count, for rows of `stride` numbers; the fixed columns
 * come last. */
static inline void flexel_row(const flexel_work *s, int row, const double *restrict in, size_t stride, size_t count,
                              double *restrict out)
{
    memset(out, 0, count * sizeof(double));
    for (int l = s->J_start[row]; l < s->J_start[row + 1] && (size_t)s->J_column[l] < s->nf; l++) {
        const double z = s->J[l], *restrict x = in + (size_t)s->J_column[l] * stride;
        size_t j = 0;
        for (; j + 4 <= count; j += 4)
#pragma omp simd
            for (size_t i = 0; i < 4; i++)
                out[j + i] += z * x[j + i];
        for (; j < count; j++)
            out[j] += z * x[j];
    }
}

/* A row of J times a vector over all coordinates. */
static inline double flexel_row_value(const flexel_work *s, int row, const double *in)
{
    double z = 0;
    for (int l = s->J_start[row]; l < s->J_start[row + 1]; l++)
        z += s->J[l] * in[s->J_column[l]];
    return z;
}

#endif
