/* Orientations that turn freely, in a step of Radau IIA: each by its rotation from the start of the step.
 *
 * In the places of three Euler parameters and of their rates, the variables have the rotation vector p from the start of the
 * step, where it is zero, and the angular velocity w, both along the axes of the frame. With Euler parameters L0 at the start,
 *
 *   L = L0 o (cos |p|/2, sin |p|/2 p/|p|),   p' = w + p x w / 2 + (1 - |p|/2 cot |p|/2) / |p|^2 p x (p x w),   w' = 2 E L''.
 *
 * A steady rotation is p = w t, which collocation integrates exactly in steps of any length. A change of variables from step
 * to step does not change J where the frame sees the same: p and w are those of the body, whatever L is.
 *
 * What acts on a ball that rolls is the same in space, however the ball turns. For such frames both vectors are along the axes
 * of space instead, P = R0 p and W = R w with the rotation matrices R0 at the start and R, so that
 *
 *   P' = W - P x W / 2 + (1 - |P|/2 cot |P|/2) / |P|^2 P x (P x W),   W' = R 2 E L''.
 * Source: Hairer, Lubich and Wanner (2006), Geometric Numerical Integration, IV.8. */
#ifndef FLEXEL_TURNS_H
#define FLEXEL_TURNS_H

#include "explicit.h"

/* cdef: begin */
typedef struct {
    size_t count, nq;       /* frames; degrees of freedom, behind which their rates are */
    const int *at;          /* as in rotations.h: coordinates of the Euler parameters (count, 4) */
    const int *part, *rest; /* which of the four are degrees of freedom (count, 3), and which is not (count) */
    const int *dof;         /* numbers of these among the dynamic ones (count, 3) */
    double *start, *first;  /* Euler parameters at the start of the step, and of the motion (count, 4) */
    int *space;             /* whether the variables of a frame are along the axes of space (count) */
    double *seen, *spin;    /* for which J is: Euler parameters (count, 4), angular velocities (count, 3) */
} flexel_turns;
/* cdef: end */

/* Variables at the start of a motion, or of another choice of degrees of freedom, for coordinates and their rates. */
void flexel_turns_begin(const flexel_turns *r, const double *x, const double *v, double *y);
/* y with Euler parameters and their rates for variables; all Euler parameters (count, 4). */
void flexel_turns_place(const flexel_turns *r, const double *variables, double *y, double *L);
/* Rates f of the variables, after those of y and x''. */
void flexel_turns_rates(const flexel_turns *r, const flexel_work *s, const double *variables, double *f);
/* Sizes of variables: how far a frame has turned since the start of the motion, and how fast it turns. */
void flexel_turns_sizes(const flexel_turns *r, const double *variables, double *size);
/* The last step ended at `last`, and its polynomial changes by Z behind it: Z becomes that of rotations from that end. */
void flexel_turns_guess(const flexel_turns *r, const double *last, double *Z);
/* The variables, which are those of the end of a step, become those of the start of the next, and so do their rates. */
void flexel_turns_accept(const flexel_turns *r, double *variables, double *rates);
/* J is for this start. */
void flexel_turns_look(const flexel_turns *r, const double *variables);
/* The longest step: no frame turns by more than an angle, and the Euler parameter that is not in y stays away from zero. */
double flexel_turns_longest(const flexel_turns *r, const double *variables, double angle);
/* Whether a rotation is longer than half a turn. */
int flexel_turns_far(const flexel_turns *r, const double *variables);
/* b = (shift 1 - A)^-1 b, where A = dp'/dp at the start, or its transpose for sign = -1; numbers, or pairs of real and
 * imaginary parts. Where nothing turns, b is divided by the shift. */
void flexel_turns_divide(const flexel_turns *r, const double *shift, double sign, size_t nd, size_t numbers, double *b);

#endif
