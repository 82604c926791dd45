/* The quantities of a model in all lanes; see lanes.h, and evaluate.c for one variant. */
#include "evaluate.h"
#include "lanes_inside.h"

#include <string.h>

FLEXEL_INLINE void clear(size_t n, double *values)
{
    memset(values, 0, n * sizeof(vec));
}

FLEXEL_INLINE void take(const flexel_gather *gather, const double *from, double *to)
{
    for (size_t i = 0; i < gather->n; i++)
        V(to)[gather->place[i]] = V(from)[gather->index[i]];
}

FLEXEL_INLINE void pick(size_t n, const int *source, const double *from, double *to)
{
    for (size_t i = 0; i < n; i++)
        V(to)[i] = V(from)[source[i]];
}

FLEXEL_INLINE void sum(const flexel_sums *sums, const double *buffer, double *out)
{
    if (!sums->start) { /* one source each */
        pick(sums->n, sums->source, buffer, out);
        return;
    }
    for (size_t i = 0; i < sums->n; i++) {
        vec z = flexel_all(0);
        for (int j = sums->start[i]; j < sums->start[i + 1]; j++) {
            vec part = V(buffer)[sums->source[j]];
            if (sums->weight)
                part *= sums->weight[j];
            z += part;
        }
        V(out)[i] = z;
    }
}

FLEXEL_INLINE void add(const flexel_terms *terms, const double *in, double *out)
{
    for (size_t i = 0; i < terms->n; i++)
        V(out)[terms->target[i]] += terms->factor[i] * V(in)[terms->source[i]];
}

FLEXEL_CLONES
void flexel_lanes_position(flexel_work *s)
{
    take(&s->coordinates, s->x, s->x8);
    flexel_run(&s->position);
    pick(s->m, s->e_source, s->position_out, s->e);
    for (size_t i = 0; i < s->nperiodic; i++) {
        const int j = s->periodic[i];
        vec turns = (V(s->unwrap_from)[j] - V(s->e)[j]) / s->period[i];
        flexel_round(&turns);
        V(s->e)[j] += s->period[i] * turns;
    }
    sum(&s->J_sums, s->position_out, s->J);
    for (size_t i = 0; i < s->nrelations; i++)
        V(s->e)[s->relations[i]] = flexel_all(-s->drawn[i]);
    add(&s->relation_e, s->e, s->e);
    add(&s->relation_x, s->x, s->e);
    add(&s->relation_J, s->J, s->J);
}

FLEXEL_CLONES
void flexel_lanes_rates(flexel_work *s)
{
    for (size_t i = 0; i < s->m + s->k; i++)
        V(s->w)[i] = flexel_lanes_row_value(s, (int)i, s->v);
}

/* The rates of the coordinates are in the lanes of the elements since the forces. */
FLEXEL_CLONES
void flexel_lanes_convective(flexel_work *s)
{
    flexel_run(&s->acceleration);
    pick(s->m + s->k, s->g_source, s->acceleration_out, s->g);
    for (size_t i = 0; i < s->nrelations; i++)
        V(s->g)[s->relations[i]] = flexel_all(0);
    add(&s->relation_g, s->g, s->g);
}

FLEXEL_INLINE void laws(flexel_work *s)
{
    if (!s->nlaws)
        return; /* the stresses stay zero */
    take(&s->law_e, s->e, s->law_e8);
    take(&s->law_e, s->w, s->law_ed8);
    take(&s->law_s, s->w, s->law_s8);
    take(&s->law_z, s->z, s->law_z8);
    flexel_run(&s->law);
    sum(&s->stress_sums, s->law_out, s->law_stress);
    sum(&s->zd_sums, s->law_out, s->zd);
    sum(&s->law_U_sums, s->law_out, s->law_U);
    sum(&s->law_P_sums, s->law_out, s->law_P);
}

FLEXEL_INLINE void inertia(flexel_work *s)
{
    if (!s->constant_inertia) {
        flexel_run(&s->inertia);
        sum(&s->M_sums, s->inertia_out, s->M);
        if (s->damped)
            sum(&s->D_sums, s->inertia_out, s->D);
    }
    sum(&s->F_sums, s->inertia_out, s->F);
    for (size_t i = 0; i < (s->damped ? s->n : 0); i++) {
        vec z = flexel_all(0);
        for (int j = s->M_start[i]; j < s->M_start[i + 1]; j++)
            z += V(s->D)[j] * V(s->v)[s->M_column[j]];
        V(s->damping)[i] = z;
        V(s->F)[i] -= z;
    }
}

FLEXEL_CLONES
void flexel_lanes_potential(const flexel_work *s, const double *U0, double *U)
{
    sum(&s->U_sums, s->inertia_out, U);
    *V(U) += *V(U0);
    for (size_t i = 0; i < s->n; i++)
        *V(U) -= V(s->f0)[i] * V(s->x)[i];
}

/* The coordinates' shares of given stresses, into the forces. */
FLEXEL_INLINE void pull(const flexel_work *s, double *out)
{
    for (size_t i = 0; i < s->m + s->k; i++) {
        const vec z = V(s->stress)[i];
        const mask some = (mask)z << 1; /* all bits but the sign */
        if (flexel_any(&some))
            for (int j = s->J_start[i]; j < s->J_start[i + 1]; j++)
                V(out)[s->J_column[j]] += V(s->J)[j] * z;
    }
}

FLEXEL_CLONES
void flexel_lanes_forces(flexel_work *s, flexel_choice *c)
{
    const size_t first = s->m + s->k;
    take(&s->coordinates, s->v, s->v8);
    if (s->nlaws)
        flexel_lanes_rates(s);
    else
        for (size_t i = 0; i < s->nperiodic; i++)
            V(s->w)[s->periodic[i]] = flexel_lanes_row_value(s, s->periodic[i], s->v);
    laws(s);
    inertia(s);
    clear(s->n, c->force);
    memcpy(s->stress, s->law_stress, first * sizeof(vec));
    for (size_t i = 0; i < c->nloads; i++) {
        const size_t quantity = (size_t)c->loaded[i];
        vec *to = quantity < first ? V(s->stress) + quantity : V(c->force) + (quantity - first);
        *to -= V(c->loads)[i]; /* the sign of all turns below */
    }
    if (c->nloads || s->nlaws)
        pull(s, c->force);
    for (size_t i = 0; i < s->n; i++)
        V(c->force)[i] = V(s->F)[i] - V(c->force)[i];
}
