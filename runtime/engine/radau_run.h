/* Steps of Radau IIA in a row, see in_row.h. One in which the sign of the determinant changes, or that cannot be evaluated, is
 * unusual. */
#ifndef FLEXEL_RADAU_RUN_H
#define FLEXEL_RADAU_RUN_H

#include "in_row.h"
#include "radau.h"

/* cdef: begin */
/* Numbers of a step that is kept: time at its end, length, and amplification at its end. Then coordinates and their rates (n
 * each), deformations and theirs (m each) at its end; y at its start and at its end, and powers of its dense output (ny, ny,
 * 4 ny); of orientations at its start Euler parameters and axes (4 and 1 for each), and of angles the Euler parameter and its
 * slope (1 and 1 for each). */
enum { FLEXEL_RADAU_KEPT_T, FLEXEL_RADAU_KEPT_H, FLEXEL_RADAU_KEPT_AMPLIFICATION, FLEXEL_RADAU_KEPT };

typedef struct {
    flexel_in_row row;
    flexel_radau *steps;
    double best;   /* amplification of the best degrees of freedom */
    double wished; /* length [s] of the first trial of a step */
} flexel_radau_run;

/* Take steps from the start, or go on with what the row has waited for; how they end. */
int flexel_radau_steps(flexel_radau_run *r);
/* cdef: end */

#endif
