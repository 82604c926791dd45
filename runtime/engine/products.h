/* Products of sparse and dense matrices. */
#ifndef FLEXEL_PRODUCTS_H
#define FLEXEL_PRODUCTS_H

#include <stddef.h>

/* cdef: begin */
/* out = A in for `count` columns, by rows: row i of A has the entries values[source[k]] in columns column[k], k from start[i]
 * to start[i + 1]. */
void flexel_product(size_t rows, const int *start, const int *column, const int *source, const double *values, size_t count,
                    const double *in, double *out);
/* cdef: end */

#endif
