/* Orientations of which one Euler parameter is a degree of freedom, in a step of Radau IIA: each by an angle.
 *
 * Elongations and other deformations determine the rest of such an orientation, as that of a rotor in springs. In the place of
 * the parameter q the variables have the angle s, and in that of its rate s'. With unit rates of q alone, the frame turns about
 * the axis a of its own at the start of the step, with Euler parameters L0 there, and
 *
 *   q = L0_k cos s/2 + b sin s/2,  b = (L0 o a)_k,   q' = q_s s',   s'' = (q'' + q s'^2 / 4) / q_s.
 *
 * A steady rotation about a fixed axis has s = w t, which collocation integrates exactly. Where q is close to an extreme of
 * its own, b is too small, and the variables have q itself. */
#ifndef FLEXEL_ANGLES_H
#define FLEXEL_ANGLES_H

#include "explicit.h"

/* cdef: begin */
typedef struct {
    size_t count, nq;   /* frames; degrees of freedom, behind which their rates are */
    const int *at;      /* coordinates of the Euler parameters (count, 4) */
    const int *part;    /* which of the four is a degree of freedom (count) */
    const int *dof;     /* its number among the dynamic ones (count) */
    double *start;      /* Euler parameters at the start of the step (count, 4) */
    double *axis;       /* axis there, in the frame (count, 3); it turns to the opposite one in no step */
    double *others;     /* angular velocity there less that of the angle (count, 3) */
    double *slope;      /* b (count); zero if the variables have q itself */
    double *seen;       /* that for which J is (count) */
    /* of the last step: the Euler parameter and b at its start, angle and rate at its end (count, 4); zeros if it is of no use */
    double *before;
    double *passed;     /* angle from the start of the motion to that of the step (count) */
} flexel_angles;
/* cdef: end */

/* Variables are q and q' themselves. */
void flexel_angles_leave(const flexel_angles *r, const double *x);
/* They are angles from here on, as far as possible; the complete state is in the workspace. */
void flexel_angles_begin(const flexel_angles *r, flexel_work *s, flexel_choice *c, double *y, double *f);
/* y for variables at a time behind the start of the step; where the Euler parameters may be (count, 4). */
void flexel_angles_place(const flexel_angles *r, double passed, const double *variables, double *y, double *L);
/* Rates f of the variables, after those of y. */
void flexel_angles_rates(const flexel_angles *r, const double *variables, double *f);
/* Sizes of variables: how far a frame has turned since the start of the motion, and how fast it turns. */
void flexel_angles_sizes(const flexel_angles *r, const double *variables, double *size);
/* The polynomial of the last step changes by Z behind its end: Z becomes that of the variables of this one. */
void flexel_angles_guess(const flexel_angles *r, const double *variables, double *Z);
/* The variables, those of the end of a step whose state is in the workspace, become those of the start of the next. */
void flexel_angles_accept(const flexel_angles *r, flexel_work *s, flexel_choice *c, double *variables, double *rates);
/* J is for this start. */
void flexel_angles_look(const flexel_angles *r);
/* The longest step: no frame turns by more than an angle, and q stays away from its extreme. */
double flexel_angles_longest(const flexel_angles *r, const double *variables, double angle);
/* Whether q has passed its extreme. */
int flexel_angles_far(const flexel_angles *r, const double *variables);

#endif
