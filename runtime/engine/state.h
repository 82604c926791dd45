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
/* Accelerations, deformations and stresses in the rows of `count` states, laid out as in linear.h, from their t, x, v and z; the
 * second rates of their degrees of freedom (nd each), and the largest force on a free coordinate that is balanced in each.
 *
 * `space` has n numbers. Returns the number of states that are done, all of them unless *code says why not. */
size_t flexel_complete_states(flexel_work *s, flexel_choice *c, size_t count, double *states, double *qdd, double *forces,
                              double *space, int *code);
/* cdef: end */

#endif
