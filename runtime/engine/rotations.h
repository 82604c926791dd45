/* Orientations that turn freely: their angular velocities are integrated instead of the rates of their Euler parameters.
 *
 * Three of four Euler parameters L are degrees of freedom, and which three changes as the orientation turns. Their errors and
 * rates are large where the fourth is small, but all four together and the angular velocity w = 2 E L' are as smooth as the
 * motion. As E' L' = 0, w' = 2 E L''; as |L| = 1, L' = E^T w / 2. Components of w are along the axes of the frame. */
#ifndef FLEXEL_ROTATIONS_H
#define FLEXEL_ROTATIONS_H

#include <stddef.h>

/* cdef: begin */
typedef struct {
    size_t count;
    const int *at;     /* coordinates of the Euler parameters (count, 4) */
    const int *part;   /* which of the four are degrees of freedom (count, 3), and which is not (count) */
    const int *rest;
    const int *dof;    /* numbers of these among the dynamic ones (count, 3) */
    double *w, *w_new; /* angular velocities at the start and the end of the step, (count, 3) */
    double *stage;     /* at a stage (count, 3) */
    double *W;         /* their rates at the stages and the end (13, count, 3) */
    double *scale;     /* allowed errors of the angular velocities and of the other Euler parameter (count, 4) */
} flexel_rotations;
/* cdef: end */

/* Twice E times the rates of Euler parameters L, and half of E^T times angular velocities; of numbers or of vectors of them. */
#define FLEXEL_SPIN(w, L, v)                                                        \
    do {                                                                            \
        (w)[0] = 2.0 * (L[0] * v[1] - L[1] * v[0] + L[3] * v[2] - L[2] * v[3]);     \
        (w)[1] = 2.0 * (L[0] * v[2] - L[2] * v[0] + L[1] * v[3] - L[3] * v[1]);     \
        (w)[2] = 2.0 * (L[0] * v[3] - L[3] * v[0] + L[2] * v[1] - L[1] * v[2]);     \
    } while (0)
#define FLEXEL_TURN(v, L, w)                                                        \
    do {                                                                            \
        (v)[0] = -0.5 * (L[1] * w[0] + L[2] * w[1] + L[3] * w[2]);                  \
        (v)[1] = 0.5 * (L[0] * w[0] - L[3] * w[1] + L[2] * w[2]);                   \
        (v)[2] = 0.5 * (L[3] * w[0] + L[0] * w[1] - L[1] * w[2]);                   \
        (v)[3] = 0.5 * (-L[2] * w[0] + L[1] * w[1] + L[0] * w[2]);                  \
    } while (0)

#endif
