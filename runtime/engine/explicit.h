/* Motion in minimal coordinates: the position for given degrees of freedom, velocities, accelerations, multipliers.
 *
 * Rows of the position matrix P: rigid, prescribed, dynamic and kinematic degrees of freedom. One factorization of P serves
 * all: with unit columns G = P^-1, rolling conditions S v = 0 give the rates of the kinematic ones, H = G_d + G_k T with
 * T = -(S G_k)^-1 S G_d. Accelerations follow from (H' M H) q'' = H' (F - M g), or, for many degrees of freedom, from the
 * sparse matrix [M C'; C 0]; or from [M B'; C 0] where actuators B hold the prescribed motions. Source: Jonker and
 * Meijaard (1990); Schwab and Meijaard (2003). */
#ifndef FLEXEL_EXPLICIT_H
#define FLEXEL_EXPLICIT_H

#include "matrix.h"
#include "table.h"

#include <float.h>

enum { FLEXEL_MOST_ITERATIONS = 40 }; /* for a position */
#define FLEXEL_STALLED 1e-10          /* its error that is accepted where it is no longer halved */
#define FLEXEL_ROUNDING 2e-14         /* the same after a correction from an error below `kept` */
#define FLEXEL_OF_COORDINATES (2 * DBL_EPSILON) /* rounding error of a coordinate, relative to it */
#define FLEXEL_LONGEST_STEP 0.5       /* of Newton's method for it, in natural scales */

/* cdef: begin */
/* What an evaluation can end with. */
enum {
    FLEXEL_DONE,
    FLEXEL_UNREACHED, /* Newton's method for the position does not converge */
    FLEXEL_SINGULAR,  /* the degrees of freedom do not determine the position */
    FLEXEL_SLIDING,   /* the kinematic ones do not determine the velocities */
    FLEXEL_MASSLESS   /* a motion moves no mass */
};

/* A choice of degrees of freedom, in one workspace. */
typedef struct {
    size_t nr, np, nd, nk;      /* rigid, prescribed, dynamic, kinematic */
    int saddle;                 /* accelerations from [M C'; C 0] */
    const int *rows, *slips;    /* quantities of the rows of P, and of S */
    const int *forced;          /* of the rigid and prescribed rows: where their forces act, which may be actuators */
    const double *weight, *step_weight; /* one over natural scales: of the rows, of the free coordinates */
    flexel_matrix P, A;
    double tolerance, accept;   /* accept: error below which J is taken from before the last correction */
    double kept;                /* error below which the factors of a position close by correct it */
    /* given: prescribed motions (value, rate, second rate; np each), degrees of freedom and their rates, loads */
    double *motion, *q, *qd;
    size_t nloads;
    const int *loaded;          /* quantities */
    double *loads;
    /* found */
    double *target, *residual, *qdd, *force, *multiplier; /* multiplier: by quantity */
    size_t columns, stride;     /* of G = [d | k | given] and of X = [H | g], filled up with zeros */
    double *G, *X, *inverse, *small, *step, *work;
    double error;
    /* coordinates that are known before a position is found from the last one, and where they are */
    size_t nknown;
    const int *known;
    double *known_x;
    /* the last evaluation of the right-hand side: time, coordinates, deformations and their rates, targets */
    int predict;  /* P belongs to it */
    int reusable; /* the position sought is close to it, and P still belongs to it */
    double t_last, *x_last, *e_last, *ed_last, *target_last;
    size_t positions, factorizations;
} flexel_choice;

/* Release what factorizations have allocated. */
void flexel_choice_clear(flexel_choice *c);
/* Forget what was found on the way: what follows then depends on nothing computed before. These are pivot orders, and rates
 * of fixed coordinates that a user's state may have had. */
void flexel_reset(flexel_work *s, flexel_choice *c);
/* The position with degrees of freedom q, from s->x; whole periods are counted from s->unwrap_from. */
int flexel_locate(flexel_work *s, flexel_choice *c);
/* The position matrix at s->x is factorized. */
int flexel_factorize(flexel_work *s, flexel_choice *c);
/* Columns H and velocities for the given rates, at a position whose matrix is factorized; see position.c. */
int flexel_directions(flexel_work *s, flexel_choice *c);
/* x = B^-1 b by rows, for `count` columns: rates of the free coordinates for those of the rigid and
 * prescribed quantities, the slips and the dynamic degrees of freedom; after the directions. work has 2 nf count numbers. */
void flexel_rates_for(const flexel_work *s, const flexel_choice *c, size_t count, const double *b, double *x, double *work);
/* Velocities v for the rates qd, at a located position. */
int flexel_velocity(flexel_work *s, flexel_choice *c);
/* Rates of some quantities for unit rates of the dynamic degrees of freedom (count by nd), after the directions; not with the
 * saddle matrix. */
void flexel_unit_rates(const flexel_work *s, const flexel_choice *c, size_t count, const int *rows, double *out);
/* Forces on the coordinates, and the outputs of the laws, at x, v and z; w holds the rates that they need. */
void flexel_forces(flexel_work *s, flexel_choice *c);
/* Accelerations a and qdd; after velocities and forces. */
int flexel_accelerate(flexel_work *s, flexel_choice *c);
/* Accelerations for given qdd. */
int flexel_driven(flexel_work *s, flexel_choice *c);
/* Multipliers of the constraints, and of the dynamic degrees of freedom if they are driven; after accelerations. */
void flexel_multipliers(flexel_work *s, flexel_choice *c, int driven);
/* Forces, accelerations and multipliers at x, v, z and unwrap_from; accelerations are found, or given by qdd. */
int flexel_complete(flexel_work *s, flexel_choice *c, int driven);
/* Rates dy of y = (q, q_d', z) at time t, the position sought from s->x and s->unwrap_from; everything at that state is then in
 * the workspace. */
int flexel_evaluate(flexel_work *s, flexel_choice *c, double t, const double *y, double *dy);
/* The same, the position sought from the last one so evaluated. */
int flexel_rhs(flexel_work *s, flexel_choice *c, double t, const double *y, double *dy);
/* cdef: end */

#endif
