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

/* A step whose coordinates and deformations are interpolated by the cubic through its ends (0 and 1), with rates per step. */
typedef struct {
    const double *x0, *v0, *e0, *w0, *x1, *v1, *e1, *w1;
} flexel_path;

/* A deformation at a part of a path, from 0 to 1; the workspace is changed. */
double flexel_path_value(flexel_work *work, const flexel_path *p, int row, double part);

/* The part of a path at which a deformation is smallest, and that value. It is convex along the path, or nearly so: the search
 * ends early where it cannot be less than `near`. */
double flexel_path_lowest(flexel_work *work, const flexel_path *p, int row, double near, double *lowest);
/* cdef: end */

#endif
