/* The balance of forces in coordinates and multipliers together, and the energies of a state. */
#ifndef FLEXEL_BALANCE_H
#define FLEXEL_BALANCE_H

#include "table.h"

/* cdef: begin */
/* Multipliers act on the quantities `rows`, of which the first nh have given values (rigid and prescribed conditions). */
typedef struct {
    flexel_work *work;
    size_t nforce, nh;
    const int *rows;
    const double *period;                 /* of the first nh, or zero */
    double *nodal, *applied, *target;     /* loads on coordinates (n), stresses by loads (m + k), values (nh): given */
    double *mu;                           /* multipliers (nforce): given */
    double *given, *force, *r, *gap;      /* stresses but for multipliers (m + k), forces (n) and unbalance (nf), errors (nh) */
    double *size;                         /* largest entry of the rows of J (m + k); less than zero: not known */
    int sized;                            /* whether `size` is kept: it is found again after every tangent */
    double scale;                         /* size of the balancing forces */
    int implicit;                         /* whether internal states follow from a step, z = known + share dz/dt */
    int at_rest;                          /* whether only lasting ones do */
    double share, *known;
} flexel_balance;

/* Energies of a state, and its contacts: laws whose first deformation is a gap. */
typedef struct {
    size_t ncontacts;
    const int *law, *gap;
    unsigned char *touching; /* contacts that were closed when last noted */
    double kinetic, potential, strain, contact; /* potential of body forces; strain energy of contacts apart as well */
    double lost;             /* power dissipated in laws and by damping */
    double begun, deepest;   /* depths of contacts that have closed since, and of those that touched before */
} flexel_energies;

/* The balance at the time, x, v, a, z and `unwrap_from` of the workspace: forces, unbalance r = M a + h - f + De' sigma + V' tau,
 * and errors of the conditions. */
void flexel_balanced(flexel_balance *b);
/* dr/dx + rate dr/dv + acceleration dr/da, times `scaling`, into T of the workspace, at the last balance. Returns zero, or
 * one if a law has no slope there. */
int flexel_balance_tangent(flexel_balance *b, double scaling, double rate, double acceleration, double share);
/* Energies at the last balance. */
void flexel_energies_at(flexel_energies *s, const flexel_work *w);
/* Note which contacts are closed. */
void flexel_touched(flexel_energies *s, const flexel_work *w);
/* cdef: end */

/* The larger of two numbers; one that is not a number stays. */
static inline double flexel_larger(double most, double z)
{
    return z <= most || most != most ? most : z;
}

#endif
