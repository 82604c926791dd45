/* The linear systems of a step of Radau IIA with sparse factors, for models with many degrees of freedom.
 *
 * With x = G q to first order, (mu/h) 1 - J is the matrix [mu^2 M + mu D + K, C'; C, 0] of coordinates and multipliers, where
 * mu/h is written as mu, D and K are derivatives of the balance of forces by v and x, and C are the rows of the rigid and the
 * prescribed quantities. For right-hand sides r of q' and s of q'': dv = mu dx - G r and da = mu dv - G s, so that
 *
 *   (mu^2 M + mu D + K) dx + C' l = M (mu G r + G s) + D G r,   C dx = 0.
 *
 * That G changes along the motion is left out: the iteration is Newton's to first order in the angle of a step. Right-hand
 * sides and solutions for orientations are those of turns.h and angles.h. Not with
 * kinematic degrees of freedom, nor with internal states. The complex system has twice as many real unknowns. */
#ifndef FLEXEL_RADAU_SADDLE_H
#define FLEXEL_RADAU_SADDLE_H

#include "angles.h"
#include "turns.h"

/* cdef: begin */
typedef struct {
    size_t nf, nd, held, nT, nJ; /* held: rows of C */
    const int *T_start, *T_column, *J_start, *J_column;
    const int *dynamic;          /* rows of J of the degrees of freedom (nd) */
    const flexel_turns *turns;
    const flexel_angles *angles;
    /* of the last state that was looked at: K, D, M by the pattern of the tangent, and M and J as in the workspace */
    double *K, *D, *M, *mass;
    /* values of the matrices: real ones, or real and imaginary parts and the latter with the other sign, before those of J */
    double *single_values, *pair_values;
    flexel_matrix P, single, pair; /* the position matrix, and those of the real and the complex number */
    double *columns, *sides, *work;
} flexel_radau_saddle;

/* Take the matrices at the complete state of the workspace, with all stresses; slopes of laws that are not finite count as zero.
 * 0, or 1 if the position matrix is singular. */
int flexel_radau_look(flexel_work *s, flexel_radau_saddle *o, const double *stress);
/* Factors for mu and for the complex number pair; 0, or 1 if a matrix is singular. */
int flexel_radau_saddle_factorize(flexel_radau_saddle *o, double mu, const double *pair);
/* b = (mu 1 - J)^-1 b, for real numbers, or for pairs of numbers. */
void flexel_radau_saddle_solve(const flexel_radau_saddle *o, double mu, double *b);
void flexel_radau_saddle_solve_pair(const flexel_radau_saddle *o, const double *mu, double *b);
void flexel_radau_saddle_clear(flexel_radau_saddle *o);
/* cdef: end */

#endif
