/* How the length of a step follows from its error, relative to what is allowed: one rule for all methods, see step_control.py. */
#ifndef FLEXEL_STEP_CONTROL_H
#define FLEXEL_STEP_CONTROL_H

#include <math.h>

/* cdef: begin */
/* The error of a step grows with its length to the power `order`. Factors of the length: a safety, the least of a refused step,
 * the most of an accepted one, the one up to which a longer step is not worth what its change costs, and that of a trial
 * whose error is not known. */
typedef struct {
    double order, safety, least, most, steady, unusable;
} flexel_control;
/* cdef: end */

/* The factor of the next trial after one that is refused. */
static inline double flexel_shorter(const flexel_control *c, double safety, double error)
{
    return fmax(c->least, safety * pow(error, -1 / c->order));
}

/* The factor of the next step. */
static inline double flexel_longer(const flexel_control *c, double error)
{
    return error > 0 ? fmin(c->most, c->safety * pow(error, -1 / c->order)) : c->most;
}

#endif
