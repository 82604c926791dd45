/* Linear equations with a sparse matrix whose entries are always in the same places: sparse LU factors with an order
 * of the pivots that is chosen once, from the values of a few such matrices, and then used for all others.
 *
 * What `flexel_lu_order` returns is constant and may be shared by threads; the factors of a matrix are in storage of
 * the caller. */
#ifndef FLEXEL_ELIMINATION_H
#define FLEXEL_ELIMINATION_H

#include <stddef.h>

/* cdef: begin */
/* Order of the pivots, and the places of the factors' entries. */
typedef struct flexel_lu flexel_lu;

/* Order of pivots with little fill that is numerically sound for each of `nsamples` matrices. Entry i < nentries lies
 * in row rows[i] and column columns[i], no two in the same place; values[s * nentries + i] is its value in matrix s.
 * NULL if there is no sound pivot, *failed is then the number of pivots found before, or if memory is exhausted,
 * *failed is then n. A pivot is sound if it is at least 1e-13 in matrices whose rows and columns are scaled so that
 * their largest entries are about one, and if it is not small beside its row. */
flexel_lu *flexel_lu_order(size_t n, size_t nentries, const int *rows, const int *columns, size_t nsamples,
                           const double *values, size_t *failed);
void flexel_lu_free(flexel_lu *lu);

/* Numbers needed to store the factors. */
size_t flexel_lu_slots(const flexel_lu *lu);

/* Multiplications with subtraction in one factorization: for a choice between methods. */
size_t flexel_lu_operations(const flexel_lu *lu);

/* Factors, into a (slots), of the matrix whose entry i is buffer[source[i]]. Zero, or one more than the number of
 * a pivot that is zero, not finite, below 1e-14 of its row, or so small beside what is left of its row when it is
 * eliminated, 1e-4 to 1e-3, that rounding errors of solutions may exceed `noise`: the factors are then incomplete, and the
 * pivots must be ordered again, from these values.
 *
 * The size of a row is the sum of those of its entries. Columns are compared by the scales found with the order, rows
 * as they are: matrices whose rows are multiplied by any numbers are treated alike, and those whose columns are
 * multiplied, if they all are so when the order is chosen. */
size_t flexel_lu_factor(const flexel_lu *lu, double noise, const int *source, const double *buffer, double *a);

/* Solutions x of A x = b, and of A' x = b, for `count` columns: b and x are [n][count], C order, and may be the same;
 * work has n * count numbers. Leading rows of zeros, in the order of the pivots, cost nothing. */
void flexel_lu_solve(const flexel_lu *lu, const double *a, size_t count, const double *b, double *x, double *work);
void flexel_lu_solve_transposed(const flexel_lu *lu, const double *a, size_t count, const double *b, double *x,
                                double *work);

/* Sign of the determinant. */
int flexel_lu_sign(const flexel_lu *lu, const double *a);
/* Its size as a logarithm to base 2. */
double flexel_lu_logarithm(const flexel_lu *lu, const double *a);
/* cdef: end */

#endif
