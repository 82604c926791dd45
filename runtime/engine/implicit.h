/* One step of the generalized-alpha method on coordinates and multipliers, by Newton's method. */
#ifndef FLEXEL_IMPLICIT_H
#define FLEXEL_IMPLICIT_H

#include "balance.h"
#include "elimination.h"

/* cdef: begin */
/* A point of an integration: coordinates, rates, accelerations, the method's own accelerations (n), multipliers (nforce),
 * deformations with their turns (m); internal states of laws, their rates, and the method's own rates (nz). */
typedef struct {
    double *x, *v, *a, *w, *mu, *e, *z, *zd, *zw;
} flexel_point;

/* What has to be done next: nothing, since the step has been found; a shorter step, since it has not; factors of the
 * matrix and a solution for the right-hand side in `step`; such a solution with the factors that there are; a report of
 * a law without a slope. */
enum { FLEXEL_FOUND, FLEXEL_NOT_FOUND, FLEXEL_FACTORIZE, FLEXEL_SOLVE, FLEXEL_NO_SLOPE };

/* Least and largest values of free coordinates (nf) and internal states (nz) at the accepted points of a motion; the group
 * of each internal state, and work space for the ranges of the groups; rates of these states at the start of the step before,
 * and its length (0: none); least range of a coordinate, over its natural scale. */
typedef struct {
    double *x_low, *x_high, *z_low, *z_high, *group_range, *zd_before;
    const int *group;
    size_t groups;
    double h_before, least;
} flexel_ranges;

/* Newton's method for one step of length h from `old` to `now`, whose trial point is in the workspace. */
typedef struct {
    flexel_balance *balance;
    double alpha_m, alpha_f, beta, gamma, lag_m, lag_gamma; /* coefficients of the scheme */
    int full;                /* whether every iteration has a matrix of its own */
    double forces;           /* weight of the relative unbalance of forces against errors of conditions */
    double length, tiny;     /* largest scale of the coordinates [m]; a force that counts as zero [N] */
    const double *hold_scale, *x_scale; /* natural scales of conditions (nh) and of free coordinates (nf) */
    double t, h;             /* start and length of the step */
    flexel_point old, now;
    /* matrix: order of pivots, or NULL, places of its entries among the workspace's values, factors, step for which it is
     * valid (0: none); stiffness of its rows, with mass over the squared step, and the step for which it holds; work
     * space */
    const flexel_lu *lu;
    const int *source;
    const double *values;
    double *factors, matrix_step, *stiffness, stiffness_step, *step, *space;
    /* progress: iterations; relative errors now, before and at first */
    size_t iteration;
    double error, last, first;
    size_t evaluations, iterations, factorizations;
    /* local error of the coordinates and of the internal states, over their ranges in this motion; that of the
     * coordinates as it is */
    double local_error, state_error, local_size;
    flexel_ranges ranges;
} flexel_step;

/* Take a step; the balance has the loads and conditions at its end. */
int flexel_step_begin(flexel_step *s);
/* Continue after what was asked for. */
int flexel_step_resume(flexel_step *s);
/* Let the end of the step be the start of the next one. */
void flexel_step_accept(flexel_step *s);
/* cdef: end */

/* Local errors of the step that was found; let its end widen the ranges of the motion, before it becomes `old`. */
void flexel_local_errors(flexel_step *s);
void flexel_ranges_accept(flexel_step *s);

#endif
