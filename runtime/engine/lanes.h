/* Motions of eight variants side by side, one in each lane: every number of the engine stands eight times.
 *
 * The lanes do what the other functions of the engine do with one variant, the same operations in the same order, so that
 * the digits are the same. All lanes take their stages together, each with its own time and step. What is not usual, such as
 * a pivot that is not sound or a position that takes damped steps, stops a lane before its step; the caller then goes on
 * with that variant alone. */
#ifndef FLEXEL_LANES_H
#define FLEXEL_LANES_H

#include "dop853_rules.h"
#include "runge_kutta.h"
#include "touching.h"

/* cdef: begin */
/* What a lane is doing: nothing, taking steps, waiting for what its step is to be used for, or stopped before its step. */
enum { FLEXEL_IDLE, FLEXEL_RUNNING, FLEXEL_PASSED, FLEXEL_STOPPED };
enum { FLEXEL_MOST_DYNAMIC = 16, FLEXEL_MOST_KINEMATIC = 16 }; /* degrees of freedom */

/* Arrays of the workspace, of the choice and of the steps have eight numbers in each place; these are not the saddle matrix,
 * prescribed motions, the elements' tangents, rates of derivatives, and energies. Blocks of kernels are single elements. */
typedef struct {
    flexel_work *work;
    flexel_choice *choice;
    flexel_dop853 *steps;
    double *after; /* coordinates after the last correction (nf) */
    double *accept; /* error of a position below which J is taken from before the last correction */
    /* start of the step: rates of coordinates (n), deformations and their rates (m each) */
    double *v, *e, *w;
    double end, longest, shortest; /* times [s] */
    flexel_rules rules;
    /* of each lane: what it does, steps taken and refused, refused since the start of the step, and after how many steps
     * it stops */
    int *doing, *taken, *refused, *tries, *most;
    /* time, the next step, the first one tried from here, and the end of the last trial; time of which a step is passed on */
    double *t, *h, *first, *to, *until;
    double *amplification, *amplification_new, *allowed; /* at the start of the step and at its end, and the largest value */
    double *sign; /* of the determinant of the position matrix at the start of the step */
    /* logarithms of its size there, which is not a number if it is not known, and at the end; its fall in the step before */
    double *size, *size_new, *fall;
    double *U0; /* potential of body forces that are linear in the coordinates, where these are zero; of each lane */
    flexel_account *accounts[8]; /* energy balances of the motions, or NULL */
    flexel_touching touching; /* coefficients of each lane */
} flexel_lanes;

/* Take steps until a lane passes the time of its own, at the latest at the end, or stops. The step that passes it is still
 * there, from x to x_new, and is accepted at the next call if the lane is then as it was left. */
void flexel_lanes_run(flexel_lanes *l);
/* cdef: end */

#endif
