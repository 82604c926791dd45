/* Rows of J times vectors and columns. */
#ifndef FLEXEL_ROWS_H
#define FLEXEL_ROWS_H

#include "table.h"

#include <string.h>

/* out[j] = sum over a row of J, free columns only, of J[.] in[.][j], j < count, for rows of `stride` numbers. */
static inline void flexel_row(const flexel_work *s, int row, const double *in, size_t stride, size_t count, double *out)
{
    memset(out, 0, count * sizeof(double));
    for (int l = s->J_start[row]; l < s->J_start[row + 1]; l++) {
        const size_t column = (size_t)s->J_column[l];
        if (column < s->nf)
            for (size_t j = 0; j < count; j++)
                out[j] += s->J[l] * in[column * stride + j];
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
