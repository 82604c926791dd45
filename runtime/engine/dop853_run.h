/* Steps of DOP853 in a row, see in_row.h. One that is not accepted at the first or second trial is unusual. */
#ifndef FLEXEL_DOP853_RUN_H
#define FLEXEL_DOP853_RUN_H

#include "dop853_rules.h"
#include "in_row.h"
#include "runge_kutta.h"

/* cdef: begin */
/* Numbers of a step that is kept: the time at its end, amplification there, part of the tolerances that it got, error of a
 * position with which it was found, where its stages are kept or -1, and whether they are the same if they are found anew. Then
 * at its end: coordinates (n), rates (n), deformations and their rates (m each), y and its rates, allowed errors, and how far y
 * has moved (ny each), angular velocities, their rates, and allowed errors (3 count, 3 count, 4 count). */
enum { FLEXEL_KEPT_T, FLEXEL_KEPT_AMPLIFICATION, FLEXEL_KEPT_PART, FLEXEL_KEPT_ACCEPT, FLEXEL_KEPT_SLOT, FLEXEL_KEPT_SAME,
       FLEXEL_KEPT };

typedef struct {
    flexel_in_row row;
    flexel_dop853 *steps;
    flexel_rules rules;
    double accept;       /* error of a position below which J is kept, in a motion of the machine's size */
    double longest;      /* length of a step at most [s] */
    const double *times; /* at which states are stored (ntimes), and the next of them */
    size_t ntimes, next;
    int varies;          /* whether prescribed motions or loads vary with time: they are given for a trial from t up to `to` */
    /* start of a step: time, the next length; rates of coordinates (n), deformations and their rates (m each) */
    double t, h;
    double *v, *e, *w;
    double first, to;    /* length [s] of the first trial of a step, and where the last one ends */
    size_t tries, refused;
    size_t cost;         /* evaluations of the last trial */
    int code;            /* what failed in it, or zero */
    size_t slots, used, wide; /* stages are kept for up to `slots` of the steps, with `wide` numbers each */
    double *stages;
} flexel_dop853_run;

/* Size of a slot for the stages of a step. */
size_t flexel_dop853_slot(const flexel_dop853_run *r);
/* Take steps from the start, or go on with what it has waited for; how they end. */
int flexel_dop853_steps(flexel_dop853_run *r);
/* Take the start and the stages of a step that are kept in a slot into another struct. */
void flexel_dop853_recall(const flexel_dop853_run *r, size_t slot, flexel_dop853 *o);
/* cdef: end */

#endif
