/* The quantities of a model at one state, from its kernels. */
#ifndef FLEXEL_EVALUATE_H
#define FLEXEL_EVALUATE_H

#include "table.h"

/* cdef: begin */
/* Deformations e and J at x; whole periods are added so that e is nearest to `unwrap_from`. */
void flexel_position(flexel_work *s);
/* Rates w of deformations and slips at v, from J. */
void flexel_rates(flexel_work *s);
/* Convective accelerations g of deformations and slips at v; x as at the last position. */
void flexel_convective(flexel_work *s);
/* Mass matrix M, forces F = f - h and potential U at v; x as at the last position. */
void flexel_inertia(flexel_work *s);
/* out = J in, for deformations and slips. */
void flexel_push(const flexel_work *s, const double *in, double *out);
/* out += J' stress, over all coordinates, for stresses of deformations and slips. */
void flexel_pull(const flexel_work *s, const double *stress, double *out);
/* out = M in, over all coordinates. */
void flexel_momentum(const flexel_work *s, const double *in, double *out);
/* Derivatives by x of the rates of deformations and slips. */
void flexel_rate_derivatives(flexel_work *s);
/* Derivatives by x and v of the accelerations of deformations and slips, at accelerations a. */
void flexel_acceleration_derivatives(flexel_work *s);
/* Stresses of laws, rates of internal states and energies, at e, w, z and t. */
void flexel_laws(flexel_work *s);
/* Internal states of an implicit step, z = known + share dz/dt, and the outputs of the laws there: Newton's method from z.
 * At rest only those that last follow; the others are held. */
void flexel_implicit_states(flexel_work *s, const double *known, double share, int at_rest);
/* Derivatives of stresses by pair. Internal states follow as in such a step; a share of zero holds them. */
void flexel_law_tangents(flexel_work *s, double share, int at_rest);
/* T = by_x dr/dx + by_v dr/dv + by_a M over the free coordinates, r = M a + h - f + De' sigma + V' tau at `stress`.
 *
 * Law tangents, and rate derivatives where dampers or tyres act, must be up to date; `phi` says whether they count. */
void flexel_tangent(flexel_work *s, double by_x, double by_v, double by_a, int phi);
/* The derivatives by x and by v, of nT entries each. */
void flexel_tangents(flexel_work *s, double *r_x, double *r_v);
/* Run the kernels of a stage. */
void flexel_run(const flexel_stage *stage);
/* cdef: end */

/* The blocks from `first` on alone, whether they are active or not. */
void flexel_run_blocks(const flexel_call *call, size_t first, size_t nblocks);
void flexel_sum(const flexel_sums *sums, const double *buffer, double *out);
void flexel_add(const flexel_terms *terms, const double *in, double *out);
void flexel_take(const flexel_gather *gather, const double *from, double *to);
/* The coordinates that a stage needs, and those of some blocks of a call. */
void flexel_take_for(const flexel_stage *stage, const flexel_gather *list, const double *from, double *to);
void flexel_take_blocks(const flexel_gather *list, const flexel_call *call, size_t block, size_t nblocks,
                        const double *from, double *to);

#endif
