/* A model as the engine sees it: kernel calls, and lists that say where their inputs come from and where their outputs go.
 *
 * Quantities are numbered as in the structure: deformations (m), slips (k), coordinates (n), free coordinates (nf) first.
 * The lists are constant and shared; everything that an evaluation writes belongs to one workspace, so that each thread
 * has its own. Outputs of kernels stay in the lanes of their blocks; a list of sources gives their places there. Every
 * buffer of outputs ends with a zero, the source of what is structurally zero. */
#ifndef FLEXEL_TABLE_H
#define FLEXEL_TABLE_H

#include "kernels.h"

/* cdef: begin */
/* One kernel for all elements of a type. Its arguments advance by step[i] numbers per block, inputs first. Only the
 * blocks flagged in `active` are evaluated, where it is given. `first` to `last` are the entries of its elements in the
 * list of coordinates, `width` of them in each element; `alone`: they have no kernel of positions. */
typedef struct {
    flexel_kernel kernel;
    size_t nblocks, nin, nout;
    const double *const *in;
    double *const *out;
    const size_t *step;
    const unsigned char *active;
    size_t first, last, width;
    int alone;
} flexel_call;

/* Kernels of one kind, one after another. */
typedef struct {
    size_t ncalls;
    const flexel_call *calls;
} flexel_stage;

/* to[place[i]] = from[index[i]] */
typedef struct {
    size_t n;
    const int *index, *place;
} flexel_gather;

/* out[i] = sum of weight[j] buffer[source[j]], j from start[i] to start[i + 1]; weights are one where there are none. */
typedef struct {
    size_t n;
    const int *start, *source;
    const double *weight;
} flexel_sums;

/* Products of a number with an entry: out[target[i]] += factor[i] in[source[i]]. */
typedef struct {
    size_t n;
    const int *target, *source;
    const double *factor;
} flexel_terms;

/* Stored entries of a local matrix: their flat places at[i], i < n, and their rows in the lanes of a buffer; blocks from
 * nblocks on have none. */
typedef struct {
    size_t n, nblocks;
    const int *at;
    const double *rows;
} flexel_local;

/* The tangent of the elements of a type: rows (m + k) by columns of an element.
 *
 * sigma, tau: stresses in the lanes; K vanishes with them. pair: for each block and each pair of rows (or each row, if
 * diagonal), the places of the lanes' law derivatives; NULL where no law acts. used: flat places of the local matrix that
 * can differ from zero; slot: for each block, their places in T. share: mass-proportional damping of the lanes, or NULL.
 * active: the blocks that count, or NULL. */
typedef struct {
    size_t nblocks, size, rows, columns; /* size: elements */
    int diagonal;
    size_t nsigma, ntau;
    const double *sigma, *tau;
    flexel_local De, V, Phi, K, R_x, R_v, M;
    const int *pair;
    size_t nused;
    const int *used, *slot;
    const double *share;
    const unsigned char *active;
} flexel_batch;

/* Laws with internal states, whose tangent is condensed: m deformations, k slips, nz states. `direct` receives the derivatives
 * of sigma and tau by e, its rate and s, law by law; `at` gives the places of all entries in the lanes of the tangents,
 * block by block; `z` the indices of the states; `lasting`: whether these change with displacements only; `matrix` (nz by nz) and `sides` (nz by 2m + k, at least one column) are
 * overwritten for each law. */
typedef struct {
    size_t count, m, k, nz;
    int lasting;
    const int *at, *z;
    double *direct, *matrix, *sides;
} flexel_lag;

/* Everything of one workspace. */
typedef struct {
    size_t n, nf, m, k, nz, nlaws, nS, nt, n8; /* nt: numbers in law_t, n8: in x8 */
    /* where it is evaluated: time, coordinates, rates, accelerations, internal states; deformations near the true ones */
    double t;
    double *x, *v, *a, *z, *unwrap_from;
    /* deformations, with turns counted from `unwrap_from`; rates of deformations, and slips (m + k); convective parts (m + k) */
    double *e, *w, *g;
    /* deformations and slips whose rows of J and rates are left as they are (m + k), or NULL */
    const unsigned char *left_out;
    /* given stresses of laws (m + k), all stresses (m + k) for the stiffness and those of the elements, which include the
     * shares of relations; rates of internal states, energies of laws */
    double *law_stress, *stress, *element_stress, *zd, *law_U, *law_P;
    /* f - h (n) with mass-proportional damping; forces of that damping (n); potential of body forces */
    double *F, *damping;
    double U;
    /* kernels, the lanes of their inputs, and their outputs */
    flexel_stage position, acceleration, inertia, rates, kinematics, stiffness, tangent, law, law_tangent;
    flexel_gather coordinates, sigma, tau, law_e, law_s, law_z;
    double *x8, *v8, *a8, *sigma8, *tau8, *law_e8, *law_ed8, *law_s8, *law_z8, *law_t;
    double *position_out, *acceleration_out, *inertia_out, *rates_out, *kinematics_out, *stiffness_out, *tangent_out;
    double *law_out, *law_tangent_out;
    /* deformations and convective parts: one source each */
    const int *e_source, *g_source;
    size_t nperiodic;
    const int *periodic;
    const double *period;
    /* relations: values as drawn, what adds to their values (of e, and of x), to their rows of J, to stresses of terms */
    size_t nrelations;
    const int *relations;
    const double *drawn;
    flexel_terms relation_e, relation_x, relation_J, relation_g, relation_stress;
    /* J = [De; V; 1], (m + k + n) rows over n coordinates, by rows; the same places hold Phi_x, Psi_x and Psi_v */
    const int *J_start, *J_column;
    flexel_sums J_sums, Phi_sums, Psi_x_sums, Psi_v_sums;
    double *J, *Phi, *Psi_x, *Psi_v;
    /* mass matrix (n by n, by rows, free columns first up to M_free[row]); and the part with mass-proportional damping */
    const int *M_start, *M_column, *M_free;
    flexel_sums M_sums, D_sums, F_sums, U_sums;
    double *M, *D;
    int constant_inertia, damped;
    const double *share8; /* mass-proportional damping of the lanes of a8, or NULL */
    /* body forces of elements with a constant mass matrix, which are linear in x: potential and forces */
    double U0;
    const double *f0;
    /* laws: sums of stresses, rates of states, energies; derivatives by pair of quantities, by value and by rate */
    flexel_sums stress_sums, zd_sums, law_U_sums, law_P_sums, S_sums, S_rate_sums;
    double *S, *S_rate;
    size_t nlags;
    const flexel_lag *lags;
    double *lag_values;
    /* tangent T over the free coordinates (nT entries and one for what is dropped); elements; pairs across elements */
    size_t nT;
    const int *T_start;
    double *T;
    double *H; /* rows of the slips in a matrix of implicit steps, with the places that they have in J */
    size_t nbatches;
    const flexel_batch *batches;
    size_t nforeign;
    const int *foreign_pair, *foreign_left, *foreign_right, *foreign_slot;
    double *local; /* space for the local matrices of one block */
} flexel_work;
/* cdef: end */

#endif
