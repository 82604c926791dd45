/* Steps in a row: those where nothing unusual happens are taken in C, and kept for what they are used for.
 *
 * A step that begins or ends in a contact, may have passed a flat position, or cannot be accepted as usual, is left to Python,
 * with the trial that was made. */
#ifndef FLEXEL_IN_ROW_H
#define FLEXEL_IN_ROW_H

#include "account.h"
#include "dips.h"
#include "touching.h"

/* cdef: begin */
/* How a row of steps ends: at its end, with as many steps as there is room for, or in other degrees of freedom that may be
 * better; with a step that is too short; with a trial that is to be judged elsewhere. Or it waits for prescribed motions and
 * loads at the stages of a trial, or for a Jacobian. */
enum { FLEXEL_ROW_ENDED, FLEXEL_ROW_SHORT, FLEXEL_ROW_TRIED, FLEXEL_ROW_INPUTS, FLEXEL_ROW_JACOBIAN };

typedef struct {
    flexel_work *work;
    flexel_choice *choice;
    flexel_touching *touching;
    flexel_dips *dips;
    double end, shortest; /* time at which the last step ends at the latest, and length of a step that is too short [s] */
    double deep, largest; /* logarithms: fall of the determinant that is left to dips.py, and its largest value */
    int known;            /* whether the determinant at the start is known */
    double amplification, allowed; /* of the degrees of freedom at the start of a step, and the largest that is allowed */
    int waits;            /* whether the row waits for something */
    /* steps that are kept, up to `most`, with `width` numbers each, and their energy balances */
    size_t most, taken, width;
    double *kept;
    flexel_account *accounts;
} flexel_in_row;
/* cdef: end */

/* Whether another step may begin at a time. */
int flexel_row_goes_on(const flexel_in_row *r, double t);
/* The length of a step from a time below which it is too short. */
double flexel_row_shortest(const flexel_in_row *r, double t);
/* Whether a contact begins, ends or is passed in a step of length h, whose end is in the workspace, with coordinates x1; it
 * began at coordinates x0, deformations e0 and their rates w0. */
int flexel_row_touches(const flexel_in_row *r, const double *x0, const double *e0, const double *w0, const double *x1, double h);
/* Whether a flat position is close, as in dips.py; if not, the end of the step becomes the start of the next. */
int flexel_row_dips(flexel_in_row *r);

#endif
