/* Steps of DOP853 in a row: those where nothing unusual happens are taken here, and kept for what they are used for.
 *
 * A step that begins or ends in a contact, may have passed a flat position, or is not accepted at the first or second trial,
 * is left to dop853.py, with the trial that was made. */
#ifndef FLEXEL_DOP853_RUN_H
#define FLEXEL_DOP853_RUN_H

#include "dips.h"
#include "dop853_rules.h"
#include "runge_kutta.h"
#include "touching.h"

/* cdef: begin */
/* How a row of steps ends: at its end, with as many steps as there is room for, or in other degrees of freedom that may be
 * better; with a step that is too short; with a trial that is to be judged elsewhere. */
enum { FLEXEL_ROW_ENDED, FLEXEL_ROW_SHORT, FLEXEL_ROW_TRIED };

/* Numbers of a step that is kept: the time at its end, amplification there, part of the tolerances that it got, error of a
 * position with which it was found, where its stages are kept or -1, and whether they are the same if they are found anew. Then
 * at its end: coordinates (n), rates (n), deformations and their rates (m each), y and its rates, allowed errors, and how far y
 * has moved (ny each), angular velocities, their rates, and allowed errors (3 count, 3 count, 4 count). */
enum { FLEXEL_KEPT_T, FLEXEL_KEPT_AMPLIFICATION, FLEXEL_KEPT_PART, FLEXEL_KEPT_ACCEPT, FLEXEL_KEPT_SLOT, FLEXEL_KEPT_SAME,
       FLEXEL_KEPT };

typedef struct {
    flexel_work *work;
    flexel_choice *choice;
    flexel_dop853 *steps;
    flexel_touching *touching;
    flexel_dips *dips;
    flexel_rules rules;
    double accept;                  /* error of a position below which J is kept, in a motion of the machine's size */
    double end, longest, shortest;  /* time at which the last step ends at the latest, and lengths [s] */
    double deep, largest;           /* logarithms: fall of the determinant that is left to dips.py, and its largest value */
    int known;                      /* whether the determinant at the start is known */
    const double *times;            /* at which states are stored (ntimes), and the next of them */
    size_t ntimes, next;
    /* start of a step: time, the next length, its amplification and the largest that is allowed; rates of coordinates (n),
     * deformations and their rates (m each) */
    double t, h, amplification, allowed;
    double *v, *e, *w;
    double first, to; /* length [s] of the first trial of a step, and where the last one ends */
    size_t tries, taken, refused;
    size_t cost;     /* evaluations of the last trial */
    int code;        /* what failed in it, or zero */
    int first_order; /* whether the position matrix is factorized in its first order of pivots at the start of the step */
    /* steps that are kept, up to `most`, with `width` numbers each, their energy balances, and stages for up to `slots` of them,
     * with `wide` numbers each */
    size_t most, slots, used, width, wide;
    double *kept, *stages;
    flexel_account *accounts;
} flexel_dop853_run;

/* Size of a slot for the stages of a step. */
size_t flexel_dop853_slot(const flexel_dop853_run *r);
/* Take steps from the start; how they end. */
int flexel_dop853_steps(flexel_dop853_run *r);
/* Take the start and the stages of a step that are kept in a slot into another struct. */
void flexel_dop853_recall(const flexel_dop853_run *r, size_t slot, flexel_dop853 *o);
/* cdef: end */

#endif
