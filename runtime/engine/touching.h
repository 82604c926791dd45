/* Whether a step must end earlier: contacts, stops and tyres begin or end to act in it, or contacts are passed. */
#ifndef FLEXEL_TOUCHING_H
#define FLEXEL_TOUCHING_H

#include "table.h"

/* cdef: begin */
enum { FLEXEL_TOUCHES = 1, FLEXEL_PASSES = 2 };

typedef struct {
    /* value e + rate e' + rest of some deformations e, whose sign may not change within a step: a contact or the force of a
     * law begins or ends there */
    const int *rows;
    int nrows;
    double *value, *rate, *rest;
    /* gaps of contacts that a step may not pass, and the depth [m] that does not matter */
    const int *gaps;
    int ngaps;
    double least;
    int sees_inside;       /* whether the method feels forces within a step, not only at its ends */
    unsigned char *passed; /* of each gap, in the last step that was looked at; or NULL */
} flexel_touching;

/* What may happen in a step of length h [s] of one motion, whose numbers are `stride` apart, from `i` on: coordinates x,
 * deformations e and their rates w at the start (0), coordinates at the end (1); the rest of the end is in `work`. */
int flexel_touching_look(const flexel_touching *t, const flexel_work *work, const double *x0, const double *e0,
                         const double *w0, const double *x1, double h, size_t stride, size_t i);
/* cdef: end */

#endif
