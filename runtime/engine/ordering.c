/* The order of pivots and the tables of a sparse elimination: see elimination.h and lu.h. */
#include "lu.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const int SWEEPS = 4; /* of the scaling: enough for sizes of rows and columns within a factor of about two */

/* The matrices for which an order is sought. */
typedef struct {
    size_t n, nentries, samples;
    const int *rows, *columns;
    const double *values;
} given;

/* Replace each scale by the power of two nearest to scale / sqrt(largest). */
static void rescale(size_t n, double *scale, const double *largest)
{
    for (size_t i = 0; i < n; i++) {
        int exponent = 0;
        if (largest[i] > 0 && largest[i] < INFINITY)
            frexp(largest[i], &exponent);
        scale[i] = ldexp(scale[i], -(exponent / 2));
    }
}

/* Scales of rows [sample][n] and columns (n), all powers of two, with which the largest entries of rows are between
 * a half and one, and those of columns about one; `largest` has space for n * (samples + 1). */
static void equilibrate(const given *m, double *row, double *column, double *largest)
{
    const size_t n = m->n, count = n * m->samples;
    double *of_columns = largest + count;
    for (size_t i = 0; i < count; i++)
        row[i] = 1;
    for (size_t j = 0; j < n; j++)
        column[j] = 1;
    for (int sweep = 0; sweep <= SWEEPS; sweep++) {
        memset(largest, 0, (count + n) * sizeof *largest);
        for (size_t s = 0; s < m->samples; s++)
            for (size_t e = 0; e < m->nentries; e++) {
                const size_t i = s * n + (size_t)m->rows[e], j = (size_t)m->columns[e];
                const double z = fabs(m->values[s * m->nentries + e]) * row[i] * column[j];
                largest[i] = z > largest[i] ? z : largest[i];
                of_columns[j] = z > of_columns[j] ? z : of_columns[j];
            }
        if (sweep < SWEEPS) {
            rescale(count, row, largest);
            rescale(n, column, of_columns);
        } else
            for (size_t i = 0; i < count; i++) {
                int exponent = 0;
                if (largest[i] > 0 && largest[i] < INFINITY)
                    frexp(largest[i], &exponent);
                row[i] = ldexp(row[i], -exponent);
            }
    }
}

/* Pivots of the scaled matrices, and the scales of the columns. */
static int order(const given *m, flexel_pivots *pivots, double *column)
{
    const size_t n = m->n, count = n * m->samples;
    double *row = malloc((2 * count + n + 1) * sizeof *row);
    double *scaled = malloc((m->nentries * m->samples + 1) * sizeof *scaled);
    int good = row && scaled;
    if (good) {
        equilibrate(m, row, column, row + count);
        for (size_t s = 0; s < m->samples; s++)
            for (size_t e = 0; e < m->nentries; e++)
                scaled[e * m->samples + s] =
                    m->values[s * m->nentries + e] * row[s * n + (size_t)m->rows[e]] * column[m->columns[e]];
        good = flexel_pivots_find(pivots, n, m->nentries, m->rows, m->columns, m->samples, scaled);
    }
    free(row);
    free(scaled);
    return good;
}

flexel_lu *flexel_lu_order(size_t n, size_t nentries, const int *rows, const int *columns, size_t nsamples,
                           const double *values, size_t *failed)
{
    const given m = {n, nentries, nsamples, rows, columns, values};
    flexel_pivots pivots = {.n = n};
    flexel_lu *lu = NULL;
    double *scale = malloc((n + 1) * sizeof *scale);
    *failed = n;
    if (scale && order(&m, &pivots, scale)) {
        *failed = pivots.found;
        if (pivots.found == n)
            lu = flexel_lu_tables(&pivots, nentries, rows, columns, scale);
    }
    flexel_pivots_free(&pivots);
    free(scale);
    return lu;
}
