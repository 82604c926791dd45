/* A sparse square matrix of fixed pattern with its factors. Its first pivot order is found from sample values; where that
 * is not sound for the present ones, another is found from these, and kept until `flexel_matrix_reset`. A computation that
 * starts with a reset depends on nothing computed before. */
#ifndef FLEXEL_MATRIX_H
#define FLEXEL_MATRIX_H

#include "elimination.h"

/* cdef: begin */
/* Entries i < nentries lie at (rows[i], columns[i]), and have the values buffer[source[i]]. The rest is zero at first, and
 * belongs to the functions below. */
typedef struct {
    size_t n, nentries;
    const int *rows, *columns, *source;
    flexel_lu *first, *lu;
    double *a;
    size_t size, orders;
    double noise; /* relative error of solutions that rounding may cause before pivots are ordered anew */
} flexel_matrix;

/* Find the first pivot order, sound for all samples, or for the first one alone; none is kept if there is none. The buffers
 * of the samples follow one another at distances of `stride`. */
void flexel_matrix_prepare(flexel_matrix *A, size_t samples, const double *buffers, size_t stride);
/* Return to the first pivot order. */
void flexel_matrix_reset(flexel_matrix *A);
/* Factors of the matrix; 0, or 1 if it is singular (or memory is exhausted). */
int flexel_matrix_factor(flexel_matrix *A, const double *buffer);
/* Release what the functions have allocated. */
void flexel_matrix_clear(flexel_matrix *A);
/* x = A^-1 b, and x = A'^-1 b, for `count` columns, by rows; work has n count numbers. */
void flexel_matrix_solve(const flexel_matrix *A, size_t count, const double *b, double *x, double *work);
void flexel_matrix_solve_transposed(const flexel_matrix *A, size_t count, const double *b, double *x, double *work);
/* Sign of the determinant. */
int flexel_matrix_sign(const flexel_matrix *A);
/* Its size as a logarithm to base 2. */
double flexel_matrix_logarithm(const flexel_matrix *A);
/* cdef: end */

#endif
