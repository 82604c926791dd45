/* Where the determinant of the position matrix falls from step to step: a flat position may be close. */
#ifndef FLEXEL_DIPS_H
#define FLEXEL_DIPS_H

#include "matrix.h"

/* cdef: begin */
/* Fall of the logarithm of the determinant to base two in a step, from which on the step is looked at. */
enum { FLEXEL_DIP = 1 };

/* At the end of the last step that was looked at: sign of the determinant, logarithm of its size to base two, and how much that
 * has fallen in the step. */
typedef struct {
    int sign;
    double size, fall;
} flexel_dips;

/* Take the matrix at the end of a step. 1 if the determinant has another sign than at the start, or has halved in this step or
 * in the one before; otherwise 0, and where the start is not `known` as the end of the last step. */
int flexel_dips_look(flexel_dips *o, const flexel_matrix *P, int known);
/* cdef: end */

#endif
