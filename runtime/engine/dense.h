/* Small dense systems of equations, solved in place. */
#ifndef FLEXEL_DENSE_H
#define FLEXEL_DENSE_H

#include <stddef.h>

#define FLEXEL_LEAST_PIVOT 1e-14 /* least size of a pivot relative to its row of the matrix: smaller ones are rounding errors */

/* B = A^-1 B for A (n by n) and B (n by count), by rows, with row interchanges; A is overwritten by its factors. Returns
 * zero, or 1 + the column without a pivot. */
size_t flexel_dense_solve(size_t n, size_t count, double *A, double *B);

/* b = A^-1 b for a symmetric matrix, whose lower triangle is overwritten by its Cholesky factor. Returns zero, or 1 + the
 * column at which it is not positive definite, apart from rounding errors. */
size_t flexel_definite_solve(size_t n, double *A, double *b);

#endif
