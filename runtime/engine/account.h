/* The energy balance of a motion in minimal coordinates, as its steps are taken.
 *
 * What laws and damping take out, and what loads and prescribed motions supply, is integrated by the formula of the method
 * itself from the powers at its stages, which are evaluated anyway: the integral is as exact as the motion. */
#ifndef FLEXEL_ACCOUNT_H
#define FLEXEL_ACCOUNT_H

#include "explicit.h"

/* cdef: begin */
typedef struct {
    /* the method: weights of the stages in an integral over the step, and in the estimates of its error;
     * which of the stages are at the start and at the end */
    size_t nweights, nestimates, start, end;
    const double *weights, *estimate, *rough;
    double lost[13], work[13];             /* powers at the stages [W] */
    double begun, energy, kinetic, stored; /* at the start of the step; at its end, and two parts of it without sign [J] */
    int parted; /* whether the energy may differ where the next sequence of steps begins from that where the last has ended */
    /* found: energy that is missing at the end of the last step; the largest that was; the error of the integrals; largest
     * kinetic energy and other energies; what was taken out and supplied, without signs [J]; time that has passed, and had
     * passed at the end of the step in which most is missing, and what is missing in that step [J] */
    double missing, farthest, doubt, fastest, largest, through, passed, when, worst;
} flexel_account;

/* The powers of a stage, after its accelerations. All functions do nothing without an account. */
void flexel_account_stage(flexel_account *o, const flexel_work *s, const flexel_choice *c, size_t stage);
/* The same at the start of a step, and the energy there. */
void flexel_account_begin(flexel_account *o, const flexel_work *s, const flexel_choice *c);
/* The same at its end. */
void flexel_account_end(flexel_account *o, const flexel_work *s, const flexel_choice *c);
/* Add a step of length h that is accepted: its end is the start of the next one. */
void flexel_account_accept(flexel_account *o, double h);
/* Add a stretch of length h whose integrals are known, with their error; mass matrix and energies at its end are in the
 * workspace. */
void flexel_account_carry(flexel_account *o, const flexel_work *s, double h, double lost, double work, double doubt);
/* cdef: end */

#endif
