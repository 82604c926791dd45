/* The quantities of a model at one state; see evaluate.h. Kernels first, then lists that carry their outputs to where they
 * belong. Symbols as in the formulation: e, De, V, g (convective), M, h, f, Phi, Psi. */
#include "evaluate.h"

#include <math.h>
#include <string.h>

enum { MOST_ARGUMENTS = 16 };

void flexel_run_blocks(const flexel_call *call, size_t first, size_t nblocks)
{
    const double *in[MOST_ARGUMENTS];
    double *out[MOST_ARGUMENTS];
    for (size_t i = 0; i < call->nin; i++)
        in[i] = call->in[i] + first * call->step[i];
    for (size_t i = 0; i < call->nout; i++)
        out[i] = call->out[i] + first * call->step[call->nin + i];
    call->kernel(nblocks, in, out);
}

void flexel_run(const flexel_stage *stage)
{
    for (const flexel_call *call = stage->calls; call < stage->calls + stage->ncalls; call++) {
        if (!call->active) {
            call->kernel(call->nblocks, call->in, call->out);
            continue;
        }
        for (size_t first = 0; first < call->nblocks;) {
            size_t end = first;
            while (end < call->nblocks && call->active[end])
                end++;
            if (end > first)
                flexel_run_blocks(call, first, end - first);
            first = end + 1;
        }
    }
}

static void take_range(const flexel_gather *gather, size_t first, size_t last, const double *from, double *to)
{
    const int *restrict index = gather->index, *restrict place = gather->place;
    for (size_t i = first; i < last; i++)
        to[place[i]] = from[index[i]];
}

void flexel_take(const flexel_gather *gather, const double *from, double *to)
{
    take_range(gather, 0, gather->n, from, to);
}

void flexel_take_blocks(const flexel_gather *list, const flexel_call *call, size_t block, size_t nblocks,
                        const double *from, double *to)
{
    const size_t first = call->first + block * FLEXEL_BLOCK * call->width;
    const size_t end = first + nblocks * FLEXEL_BLOCK * call->width;
    take_range(list, first, end < call->last ? end : call->last, from, to);
}

void flexel_take_for(const flexel_stage *stage, const flexel_gather *list, const double *from, double *to)
{
    for (const flexel_call *call = stage->calls; call < stage->calls + stage->ncalls; call++)
        if (!call->active)
            take_range(list, call->first, call->last, from, to);
        else
            for (size_t block = 0; block < call->nblocks; block++)
                if (call->active[block])
                    flexel_take_blocks(list, call, block, 1, from, to);
}

void flexel_sum(const flexel_sums *sums, const double *buffer, double *out)
{
    const int *restrict start = sums->start, *restrict source = sums->source;
    const double *weight = sums->weight;
    if (!start) { /* one source each */
        for (size_t i = 0; i < sums->n; i++)
            out[i] = buffer[source[i]];
        return;
    }
    for (size_t i = 0; i < sums->n; i++) {
        double z = 0;
        if (weight)
            for (int j = start[i]; j < start[i + 1]; j++)
                z += weight[j] * buffer[source[j]];
        else
            for (int j = start[i]; j < start[i + 1]; j++)
                z += buffer[source[j]];
        out[i] = z;
    }
}

void flexel_add(const flexel_terms *terms, const double *in, double *out)
{
    for (size_t i = 0; i < terms->n; i++)
        out[terms->target[i]] += terms->factor[i] * in[terms->source[i]];
}

/* The same for entries with the pattern of J, but for the rows that are left out. */
static void sum_rows(const flexel_work *s, const flexel_sums *sums, const double *buffer, double *out)
{
    if (!s->left_out) {
        flexel_sum(sums, buffer, out);
        return;
    }
    for (size_t i = 0; i < s->m + s->k; i++) {
        const int first = s->J_start[i];
        if (s->left_out[i])
            continue;
        const flexel_sums row = {(size_t)(s->J_start[i + 1] - first), sums->start ? sums->start + first : NULL,
                                 sums->start ? sums->source : sums->source + first, sums->weight};
        flexel_sum(&row, buffer, out + first);
    }
}

static void clear_relations(const flexel_work *s, double *values)
{
    for (size_t i = 0; i < s->nrelations; i++)
        values[s->relations[i]] = 0;
}

void flexel_position(flexel_work *s)
{
    flexel_take_for(&s->position, &s->coordinates, s->x, s->x8);
    for (const flexel_call *call = s->inertia.calls; call < s->inertia.calls + s->inertia.ncalls; call++)
        if (call->alone)
            flexel_take_blocks(&s->coordinates, call, 0, call->nblocks, s->x, s->x8);
    flexel_run(&s->position);
    for (size_t i = 0; i < s->m; i++)
        s->e[i] = s->position_out[s->e_source[i]];
    for (size_t i = 0; i < s->nperiodic; i++) {
        const int j = s->periodic[i];
        s->e[j] += s->period[i] * rint((s->unwrap_from[j] - s->e[j]) / s->period[i]);
    }
    sum_rows(s, &s->J_sums, s->position_out, s->J);
    if (!s->nrelations)
        return;
    for (size_t i = 0; i < s->nrelations; i++)
        s->e[s->relations[i]] = -s->drawn[i];
    flexel_add(&s->relation_e, s->e, s->e);
    flexel_add(&s->relation_x, s->x, s->e);
    flexel_add(&s->relation_J, s->J, s->J);
}

void flexel_push(const flexel_work *s, const double *in, double *out)
{
    const double *restrict J = s->J;
    for (size_t i = 0; i < s->m + s->k; i++) {
        double z = 0;
        if (s->left_out && s->left_out[i])
            continue;
        for (int j = s->J_start[i]; j < s->J_start[i + 1]; j++)
            z += J[j] * in[s->J_column[j]];
        out[i] = z;
    }
}

void flexel_rates(flexel_work *s)
{
    flexel_push(s, s->v, s->w);
}

void flexel_convective(flexel_work *s)
{
    flexel_take_for(&s->acceleration, &s->coordinates, s->v, s->v8);
    flexel_run(&s->acceleration);
    for (size_t i = 0; i < s->m + s->k; i++)
        s->g[i] = s->acceleration_out[s->g_source[i]];
    if (s->nrelations) {
        clear_relations(s, s->g);
        flexel_add(&s->relation_g, s->g, s->g);
    }
}

void flexel_inertia(flexel_work *s)
{
    if (!s->constant_inertia) {
        flexel_take_for(&s->inertia, &s->coordinates, s->v, s->v8);
        flexel_run(&s->inertia);
        flexel_sum(&s->M_sums, s->inertia_out, s->M);
        if (s->damped)
            flexel_sum(&s->D_sums, s->inertia_out, s->D);
    }
    flexel_sum(&s->F_sums, s->inertia_out, s->F);
    flexel_sum(&s->U_sums, s->inertia_out, &s->U);
    s->U += s->U0;
    for (size_t i = 0; i < s->n; i++)
        s->U -= s->f0[i] * s->x[i];
    if (!s->damped)
        return;
    for (size_t i = 0; i < s->n; i++) {
        double z = 0;
        for (int j = s->M_start[i]; j < s->M_start[i + 1]; j++)
            z += s->D[j] * s->v[s->M_column[j]];
        s->damping[i] = z;
        s->F[i] -= z;
    }
}

void flexel_pull(const flexel_work *s, const double *stress, double *out)
{
    for (size_t i = 0; i < s->m + s->k; i++) {
        const double z = stress[i];
        if (z != 0) /* open contacts are many */
            for (int j = s->J_start[i]; j < s->J_start[i + 1]; j++)
                out[s->J_column[j]] += s->J[j] * z;
    }
}

void flexel_momentum(const flexel_work *s, const double *in, double *out)
{
    for (size_t i = 0; i < s->n; i++) {
        double z = 0;
        for (int j = s->M_start[i]; j < s->M_start[i + 1]; j++)
            z += s->M[j] * in[s->M_column[j]];
        out[i] = z;
    }
}

/* Outputs with the pattern of J; coordinates contribute nothing to rows of relations. */
static void like_J(const flexel_work *s, const flexel_sums *sums, const double *buffer, double *out)
{
    sum_rows(s, sums, buffer, out);
    if (s->nrelations)
        flexel_add(&s->relation_J, out, out);
}

void flexel_rate_derivatives(flexel_work *s)
{
    flexel_take_for(&s->rates, &s->coordinates, s->v, s->v8);
    flexel_run(&s->rates);
    like_J(s, &s->Phi_sums, s->rates_out, s->Phi);
}

void flexel_acceleration_derivatives(flexel_work *s)
{
    flexel_take_for(&s->kinematics, &s->coordinates, s->v, s->v8);
    flexel_take_for(&s->kinematics, &s->coordinates, s->a, s->a8);
    flexel_run(&s->kinematics);
    like_J(s, &s->Psi_x_sums, s->kinematics_out, s->Psi_x);
    like_J(s, &s->Psi_v_sums, s->kinematics_out, s->Psi_v);
}
