/* The complete state that a workspace holds, in one block of numbers. */
#ifndef FLEXEL_STATE_H
#define FLEXEL_STATE_H

#include "explicit.h"

/* cdef: begin */
/* Stresses (m + k) and reactions (n), after `flexel_complete`: given stresses and multipliers; what holds the coordinates that
 * are constrained, and the fixed ones. */
void flexel_reactions(flexel_work *s, const flexel_choice *c, double *stresses, double *reactions);
/* x, v, a (n each), e (m), rates and accelerations of all quantities (m + k + n each), z and dz/dt (nz each); kinetic, potential
 * and strain energy, and dissipated power. Everything but the rates w must be up to date. */
void flexel_state(flexel_work *s, double *out);
/* cdef: end */

#endif
