/* The stages of one step of Radau IIA of order 5 in minimal coordinates, by a simplified Newton method.
 *
 * Stage values are y + Z. In the variables W = T^-1 Z, which decouple the three stages, each iteration solves one real system
 * and one complex one with the factors of (mu/h) 1 - J. Source: Hairer and Wanner (1996), IV.8. */
#ifndef FLEXEL_RADAU_H
#define FLEXEL_RADAU_H

#include "explicit.h"

/* cdef: begin */
enum { FLEXEL_RADAU_ITERATIONS = 7 };

typedef struct {
    size_t ny;
    const double *T, *inverse;       /* T and T^-1 (3, 3) */
    const double *C;                 /* times of the stages (3) */
    double mu, pair[2];              /* eigenvalues mu of the inverse of the matrix of the method */
    const double *scale;             /* allowed error of y (ny) */
    double tolerance;                /* of the iteration, relative to that */
    size_t ngiven;
    const double *given;             /* prescribed motions and loads at the stages (3, ngiven) */
    /* factors by columns and pivots, as LAPACK gives them, of the real matrix and the complex one */
    const double *real_factors, *complex_factors;
    const int *real_pivots, *complex_pivots;
    double *y;                       /* at the start */
    double *Z, *W, *F;               /* (3, ny); Z: first a guess, then what was found */
    double *space;                   /* (3 ny) */
    /* found: whether it has converged, its rate, how many iterations and evaluations */
    int converged;
    double rate;
    size_t iterations, evaluations;
} flexel_radau;

/* Find the stages of a step of length h from time t; FLEXEL_DONE, or the code of a stage that failed. */
int flexel_radau_step(flexel_work *s, flexel_choice *c, flexel_radau *o, double t, double h);
/* b = A^-1 b for the factors of a real matrix, by columns, and of a complex one. */
void flexel_radau_solve(size_t n, const double *factors, const int *pivots, double *b);
void flexel_radau_solve_complex(size_t n, const double *factors, const int *pivots, double *b);
/* cdef: end */

#endif
