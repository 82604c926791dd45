/* The search for an order of pivots; what is needed from it for the factors' tables. */
#ifndef FLEXEL_PIVOTS_H
#define FLEXEL_PIVOTS_H

#include <stddef.h>

/* Pivots in the order found, each with the columns of its row and the rows of its column that are not eliminated yet
 * (fill included): those of pivot k are upper[upper_start[k]] to upper[upper_start[k + 1] - 1], and so for `lower`. */
typedef struct {
    size_t n, found;
    int *row, *column;
    size_t *upper_start, *lower_start;
    int *upper, *lower;
    size_t upper_room, lower_room;
} flexel_pivots;

/* Threshold Markowitz: pivots with little fill, none small beside its row in any of the matrices. The values are
 * scaled: value i of matrix s, at scaled[i * nsamples + s], is at most about one. False if memory is exhausted; the
 * number of pivots found is in the result, less than n if the matrices are singular. */
int flexel_pivots_find(flexel_pivots *pivots, size_t n, size_t nentries, const int *rows, const int *columns,
                       size_t nsamples, const double *scaled);
void flexel_pivots_free(flexel_pivots *pivots);

#endif
