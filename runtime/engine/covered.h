/* What a motion has covered so far: the scale of its tolerances.
 *
 * A motion that is small beside the machine gets smaller absolute tolerances, down to the rounding errors of its coordinates;
 * none gets larger ones than a motion of the machine's size. */
#ifndef FLEXEL_COVERED_H
#define FLEXEL_COVERED_H

#include "evaluate.h"

#include <math.h>

/* cdef: begin */
/* Sizes of a motion: the largest range of a free coordinate, the largest of them, and the largest rate, in natural scales; the
 * number of steps taken, and the longest of them. */
enum { FLEXEL_RANGE, FLEXEL_FARTHEST, FLEXEL_FASTEST, FLEXEL_TAKEN, FLEXEL_LONGEST, FLEXEL_SIZES };

/* Relative tolerances that rounding errors may have of the largest range or rate without a warning. */
enum { FLEXEL_PROMISED = 10 };

typedef struct {
    int relative; /* whether the tolerances are relative to the motion, or those that the user has given */
    double rtol;       /* relative tolerance */
    double atol;       /* absolute tolerance of a motion of the machine's size, in natural scales */
    double resolution; /* rounding errors of coordinates, relative to them, over this tolerance */
    double full, least; /* number of steps that get the full tolerances, and the least part of them that a later step gets */
    double *low, *high, *quick; /* least and largest values and largest rates of free coordinates at the accepted points (nf) */
    double *sizes, *sizes_new; /* (FLEXEL_SIZES), up to the start and to the end of a step */
    size_t ny;
    double *least_y, *most_y; /* of y, in the present degrees of freedom (ny) */
    size_t groups;
    const int *group; /* of each internal state of a law (nz) */
    double *states, *states_new; /* largest value in each group (groups) */
} flexel_covered;

/* The shares of the absolute tolerances that coordinates and rates get; that of a group of internal states is its size times
 * `states`, at least `least`; the largest value of a coordinate that counts, over its absolute tolerance; the part of the
 * relative tolerance that the step gets; the shares that are rounding errors of coordinates and rates. */
typedef struct {
    double coordinates, rates, states, least, most, part, finest, briefest;
} flexel_shares;

/* The point (x, v, z) is taken into the motion, from `sizes` and `states` to `sizes_new` and `states_new`. */
void flexel_covered_look(const flexel_work *s, flexel_covered *c, const double *weight, const double *x, const double *v,
                         const double *z);
/* The point becomes the start of the next step. */
void flexel_covered_begin(const flexel_work *s, flexel_covered *c, const double *x, const double *v);
/* The same at the end of a step of length h. */
void flexel_covered_accept(const flexel_work *s, flexel_covered *c, const double *x, const double *v, double h);
/* The part of the tolerances that a step gets after so many others.
 *
 * Errors of steps add up. Where that of the n-th step is proportional to 1/n, their sum grows only with the logarithm of n,
 * and the steps do not depend on the end of the motion. */
double flexel_part_of_step(const flexel_covered *c, double taken);
/* The error of a position below which J is kept, for a motion with this range and the next step after so many others. */
double flexel_accepted_error(const flexel_covered *c, double accept, double range, double taken);
/* cdef: end */

#define FLEXEL_NO_ERROR 1e-300 /* allowed of a variable that is zero */
#define FLEXEL_OWN 4      /* relative tolerances that a coordinate may err by in a step, of its own range */
#define FLEXEL_MINOR 1e-4 /* its own range counts as at least so much of the largest one */

static inline double flexel_at_most_one(double part)
{
    return part < 1 ? part : 1;
}

/* How far an entry of y has moved, with this value. */
static inline double flexel_moved(const flexel_covered *c, size_t i, double y)
{
    return (y > c->most_y[i] ? y : c->most_y[i]) - (y < c->least_y[i] ? y : c->least_y[i]);
}

/* An entry of y has come to this value. */
static inline void flexel_covered_value(flexel_covered *c, size_t i, double y)
{
    c->least_y[i] = y < c->least_y[i] ? y : c->least_y[i];
    c->most_y[i] = y > c->most_y[i] ? y : c->most_y[i];
}

/* The share for rounding errors: more than one only where these are beyond what the relative tolerance promises of the largest,
 * as `motion.warnings` says then. */
static inline double flexel_of_rounding(const flexel_covered *c, double share, double largest)
{
    return share * c->atol > FLEXEL_PROMISED * c->rtol * largest ? share : flexel_at_most_one(share);
}

/* The shares for sizes of a motion, each with a stride between them, and a step of length h.
 *
 * What depends on the coordinates is no more exact than these, relative to their range. A rate that changes its coordinate by
 * less than a rounding error within the step, or the longest one so far, is of no interest, nor is an internal state that is
 * one. */
static inline flexel_shares flexel_shares_of(const flexel_covered *c, const double *sizes, size_t stride, double h)
{
    const double range = sizes[FLEXEL_RANGE * stride], farthest = sizes[FLEXEL_FARTHEST * stride];
    const double fastest = sizes[FLEXEL_FASTEST * stride], part = flexel_part_of_step(c, sizes[FLEXEL_TAKEN * stride]);
    h = h > sizes[FLEXEL_LONGEST * stride] ? h : sizes[FLEXEL_LONGEST * stride];
    if (!c->relative)
        return (flexel_shares){part, part, 0, part, INFINITY, part, part, part};
    const double finest = c->resolution * (farthest > 1 ? farthest : 1), least = finest / h;
    const double known = part * range > finest ? part * range : finest, blur = range > 0 ? known / range : part;
    const double coordinates = part * flexel_at_most_one(range);
    const double rates = flexel_at_most_one(flexel_at_most_one(fastest) * blur);
    const double so_fast = flexel_of_rounding(c, least, fastest), so_far = flexel_of_rounding(c, finest, range);
    return (flexel_shares){coordinates > so_far ? coordinates : so_far,
                           rates > so_fast ? rates : so_fast,
                           blur,
                           c->resolution,
                           range / c->atol,
                           part,
                           finest,
                           least};
}

/* The share of a group of internal states. */
static inline double flexel_share_of_states(const flexel_shares *shares, double largest)
{
    const double share = flexel_at_most_one(largest) * shares->states;
    return flexel_at_most_one(share > shares->least ? share : shares->least);
}

#endif
