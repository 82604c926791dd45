/* Linearized equations of motion at states: derivatives of the quantities of a model, transfer functions of a choice of
 * degrees of freedom, and what is left to be multiplied by H'. Symbols as in the formulation, "Analytic linearization". */
#ifndef FLEXEL_LINEAR_H
#define FLEXEL_LINEAR_H

#include "explicit.h"

/* cdef: begin */
enum { FLEXEL_COMPUTED = -1, FLEXEL_ZERO = -2 };

/* What the linearization needs besides a workspace and a choice: columns of T, and the places of the derivatives of laws in
 * the lanes of the tangents.
 *
 * `acting` are the quantities of laws. Their derivatives by the degrees of freedom are known where they are degrees of freedom
 * themselves, or zero: by_value and by_rate are the column of the one, of G and of H, or FLEXEL_ZERO, or FLEXEL_COMPUTED.
 * The derivative i of a law is that of a stress on acting[row[i]] by the value of acting[column[i]], or by its rate if
 * rate[i]; row[i] is negative where it is of an internal state. */
typedef struct {
    const int *T_column;
    size_t nlaws, nacting;
    const int *laws, *acting, *by_value, *by_rate, *row, *column, *rate;
} flexel_linear;

/* At each of `count` states: its derivatives, its transfer functions, and the factors of H' in [M C K].
 *
 * A state has t, x, v, a (n each), z (nz), e (m) and stresses (m + k); its derivatives are J, Phi_x, Psi_x, Psi_v, M (by their
 * patterns), r_x, r_v (by that of T) without the part of the laws' derivatives, and these. The columns of the p degrees of freedom and prescribed motions,
 * and those of the r of them that have rates, are filled up to multiples of four. The transfer functions are G (nf by p),
 * [H N] and [A_v A_q] (nf by r + p), and the derivatives of the rates of the nk kinematic degrees of freedom by the rates and
 * the values (nk by r + p). The factors (nf by r + r + p) are M H, r_v H + M A_v and r_x G + r_v N + M A_q. What the
 * derivatives of laws add to [C K] (nd by r + p) is computed from the derivatives of their quantities by the degrees of freedom:
 * in sums over coordinates the entries of soft motions would be differences of those of stiff ones.
 *
 * `space` has 3 nf (r + p) numbers, and r + 2 p for each of `acting`. Returns the number of states that are done, all of them unless *code says why not. Each
 * begins from the first order of the pivots, so that no state depends on those before it. */
size_t flexel_linearize(flexel_work *s, flexel_choice *c, const flexel_linear *l, size_t count, const double *states,
                        double *derivatives, double *transfer, double *factors, double *by_laws, double *space, int *code);
/* cdef: end */

#endif
