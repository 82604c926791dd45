/* When a step of DOP853 is accepted; see dop853.py, which has the same rules and those for what is unusual. */
#ifndef FLEXEL_DOP853_RULES_H
#define FLEXEL_DOP853_RULES_H

#include "step_control.h"

#include <math.h>

/* cdef: begin */
typedef struct {
    flexel_control control;
    double predicted, turns, farthest, floor, exact, unamplified; /* limits, see dop853.py */
    double rtol, atol; /* tolerances, in natural scales */
} flexel_rules;
/* cdef: end */

/* What is found of a step, as in runge_kutta.h, and whether the sign changes. */
typedef struct {
    double error, error_own, error_x, error_v, error_turns, defect, defect_v, fastest;
    int changed;
} flexel_step_found;

/* The largest of the errors of a step, over what is allowed; infinite if one of them is not a number. */
static inline double flexel_error_of_step(const flexel_rules *r, const flexel_step_found *o)
{
    const double turns = o->error_turns / r->turns, of_y = fmax(o->error, o->error_own);
    const double size = fmax(fmax(of_y, o->error_x / r->predicted), turns);
    return isfinite(o->error + o->error_own + o->error_x + turns) ? size : INFINITY;
}

/* Error of the rates within the tolerance. */
static inline double flexel_allowed_of_rates(const flexel_rules *r, const flexel_step_found *o)
{
    return r->atol + r->rtol * o->fastest;
}

/* Whether the solution has the predicted coordinates and rates, for amplifications at the start of the step and at its end. */
static inline int flexel_step_trusted(const flexel_rules *r, const flexel_step_found *o, double amplification, double at_end)
{
    const double expected = o->error_x + amplification * (r->atol + r->rtol);
    const double allowed = flexel_allowed_of_rates(r, o), enlarged = fmax(amplification, 1);
    return o->defect <= r->farthest * fmax(expected, r->floor) &&
           o->defect_v <= fmin(o->error_v, r->predicted * o->fastest) + enlarged * allowed &&
           (o->defect_v <= r->exact * (o->error_v + allowed) || at_end <= r->unamplified);
}

/* Whether a trial may have been refused because a stage is close to a flat position. */
static inline int flexel_step_suspicious(const flexel_rules *r, const flexel_step_found *o)
{
    return o->changed || !(o->defect_v <= r->exact * (o->error_v + flexel_allowed_of_rates(r, o)));
}

#endif
