/* Steps of Radau IIA of order 5 in minimal coordinates, by a simplified Newton method, with the control of their length.
 *
 * Stage values are y + Z. In the variables W = T^-1 Z, which decouple the three stages, each iteration solves one real system
 * and one complex one with the matrix (mu/h) 1 - J. As q_d' is part of y, the values q_d are eliminated first: what is
 * factorized has the size of the rest u = (q_k, q_d', z) of y = (q_d, u). Source: Hairer and Wanner (1996), IV.8.
 *
 * For orientations y has rotations from the start of the step and angular velocities instead of three Euler parameters and
 * their rates, see turns.h, and an angle instead of a single one, see angles.h; so have Z, f, J and all that is found from
 * these. */
#ifndef FLEXEL_RADAU_H
#define FLEXEL_RADAU_H

#include "account.h"
#include "angles.h"
#include "step_control.h"
#include "covered.h"
#include "radau_saddle.h"

/* cdef: begin */
enum { FLEXEL_RADAU_ITERATIONS = 7 };

/* What a step may wait for, besides the codes of an evaluation that failed. */
enum {
    FLEXEL_RADAU_INPUTS = 16, /* prescribed motions and loads at the stages of a step of length h */
    FLEXEL_RADAU_JACOBIAN,    /* J at the start: then it is fresh, not stale, and `factorized` zero */
    FLEXEL_RADAU_SHORT        /* an end: the next step would be too short */
};

/* LAPACK's dgetrf and zgetrf. */
typedef void (*flexel_getrf)(int *rows, int *columns, double *matrix, int *stride, int *pivots, int *info);

typedef struct {
    size_t ny, nd, nk, size; /* size: of u */
    /* the method: T and T^-1 (3, 3), times of the stages and weights of their rates (3), powers 1 to 3 of time in the
     * polynomial through the stages (3, 3), powers 1 to 4 of the correction (4), eigenvalues mu of the inverse matrix */
    const double *T, *inverse, *C, *b, *collocation, *correction;
    double mu, pair[2];
    flexel_getrf real_factorize, complex_factorize;
    flexel_control control;
    /* tolerances of the estimate of the error, and of the iteration relative to that; how much errors count more;
     * limits of the length, and of the change of an orientation, by the weights of coordinates (n) */
    double rtol, tolerance, enlarged, end, longest, shortest, travel;
    double minor; /* values of a degree of freedom, or rates, relative to the largest ones, that count as zero */
    const double *atol, *natural, *turning; /* natural: scales of y (ny) */
    flexel_covered *covered; /* what the tolerances are relative to */
    double finest; /* rounding errors of coordinates that the estimate of the error allows for, relative to them */
    size_t ngiven;
    double *given;     /* prescribed motions and loads at the stages and at the start (4, ngiven) */
    double *J;         /* (ny, ny), by rows */
    double *real_factors, *complex_factors; /* by columns */
    int *real_pivots, *complex_pivots;
    flexel_radau_saddle *saddle; /* sparse factors instead, or NULL */
    const flexel_turns *turns;
    const flexel_angles *angles;
    double *known; /* where Euler parameters of both may be at a stage (4 for each) */
    /* the start of the step: time, values, rates, coordinates and their rates, deformations and their rates */
    double t, *y, *f, *x, *v, *e, *ed;
    double *largest;   /* sizes so far (ny) */
    int sign;          /* of the determinant of the position matrix */
    /* kept from step to step: the length of the next one; the length that the factors are for; of the last step the powers
     * (4, ny) of its dense output, its length and its error, zero if they are of no use */
    double h, factorized, *powers, last_h, last_error;
    int stale, fresh;  /* J is to be evaluated again; it belongs to the start */
    int waiting, rejected;
    size_t tried;      /* trials from this start */
    /* found: changes up to the stages (3, ny), rates of the coordinates there (3, nf), estimate of the error, rates at the
     * end; scale: allowed error (ny); placed: y with Euler parameters (ny); space: 3 ny, divided: 2 nd */
    double *Z, *W, *F, *V, *estimate, *f_new, *scale, *placed, *space, *divided;
    int converged;
    double rate, error;
    /* of the end: distance of the solved coordinates from the integral of their rates, and that of the trapezoidal rule, in
     * natural scales; which coordinate is farthest; whether the sign of the determinant has changed */
    double off, coarse;
    size_t farthest;
    int changed;
    size_t iterations, evaluations, refused;
    flexel_account *account; /* the energy balance, or NULL */
} flexel_radau;

/* The rates at the start, from y (with Euler parameters), x, v, e and ed; what earlier steps have left is of no use. */
int flexel_radau_begin(flexel_work *s, flexel_choice *c, flexel_radau *o);
/* One step of length h or less whose error is allowed, with its end in the workspace: FLEXEL_DONE, what it waits for (then call
 * it again), or the code of an evaluation that failed. It counts only once it is accepted. */
int flexel_radau_step(flexel_work *s, flexel_choice *c, flexel_radau *o);
/* Try a shorter step: h times a factor. */
void flexel_radau_refuse(flexel_radau *o, double factor);
/* J is now for the start of the step. */
void flexel_radau_look_again(flexel_radau *o);
/* Continue from the end of the step: y, powers of its dense output, and h of the next one. */
void flexel_radau_accept(flexel_work *s, flexel_choice *c, flexel_radau *o);

/* The parts of a step, see radau_stages.c. The stages are found from a guess Z, FLEXEL_DONE with `converged`, or the code of one
 * that failed. */
int flexel_radau_stages(flexel_work *s, flexel_choice *c, flexel_radau *o, double h);
/* Allowed errors, for what the motion has covered so far and the end of a trial step, y + Z, with its coordinates and rates in
 * the workspace. */
void flexel_radau_allow(const flexel_work *s, const flexel_choice *c, flexel_radau *o, const double *Z);
/* Rates of y + Z at stage k, or of y + Z at the start for k = 3. */
int flexel_radau_rates(flexel_work *s, flexel_choice *c, flexel_radau *o, size_t k, double h, const double *Z, double *f);
/* Factors for steps of length h; 0, or 1 if a matrix is singular. */
int flexel_radau_factorize(flexel_radau *o, double h);
/* b = ((mu/h) 1 - J)^-1 b for the real mu. */
void flexel_radau_solve(const flexel_radau *o, double h, double *b);
/* cdef: end */

#endif
