/* Linear equations in block lower triangular form: what is here, and how it is stored.
 *
 * Rows and columns come in an order in which square diagonal blocks follow one another, block k from start[k] to
 * start[k + 1], and no entry lies to the right of them. The blocks lie one after another in `diagonal`, row by row;
 * the entries to the left of them, row r from first[r] to first[r + 1], have their columns in `column` and their
 * values in `beside`. Right-hand sides x are [rows][n], C order, and are overwritten by the solution. */
#ifndef FLEXEL_BLOCKS_H
#define FLEXEL_BLOCKS_H

#include <stddef.h>

/* cdef: begin */
typedef struct {
    size_t nblocks;
    const size_t *start, *first, *column;
} flexel_form;

/* LU factors of the diagonal blocks in their place, rows interchanged within a block so that the largest entry of a
 * column becomes its pivot; interchange j of a block is with its row pivots[start + j]. Returns zero, or the number of
 * the block, from one, in which a pivot is zero; the factors are then incomplete. */
size_t flexel_factor_blocks(const flexel_form *form, double *diagonal, size_t *pivots);

/* Solutions of A x = b, and of A' x = b. */
void flexel_solve_blocks(const flexel_form *form, const double *diagonal, const size_t *pivots, const double *beside,
                         size_t n, double *x);
void flexel_solve_blocks_transposed(const flexel_form *form, const double *diagonal, const size_t *pivots,
                                    const double *beside, size_t n, double *x);
/* cdef: end */

#endif
