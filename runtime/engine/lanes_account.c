/* The energy balances of the motions in all lanes, each in an account of its own; see lanes.h, and account.c for one variant. */
#include "lanes_inside.h"

FLEXEL_CLONES
void flexel_lanes_account_stage(const flexel_lanes *l, size_t stage)
{
    const flexel_work *s = l->work;
    const flexel_choice *c = l->choice;
    const size_t first = s->m + s->k;
    vec lost = flexel_all(0), work = lost;
    for (size_t i = 0; i < s->nlaws; i++)
        lost += V(s->law_P)[i];
    for (size_t i = 0; s->damped && i < s->n; i++)
        lost += V(s->v)[i] * V(s->damping)[i];
    for (size_t i = 0; i < c->nloads; i++) {
        const int quantity = c->loaded[i];
        const int coordinate = (size_t)quantity >= first;
        const vec rate = coordinate ? V(s->v)[(size_t)quantity - first] : flexel_lanes_row_value(s, quantity, s->v);
        work += V(c->loads)[i] * rate;
    }
    for (size_t i = 0; i < FLEXEL_BLOCK; i++)
        if (l->accounts[i]) {
            l->accounts[i]->lost[stage] = lost[i];
            l->accounts[i]->work[stage] = work[i];
        }
}

FLEXEL_CLONES
void flexel_lanes_account_end(const flexel_lanes *l)
{
    const flexel_work *s = l->work;
    vec kinetic = flexel_all(0), strain = kinetic, sizes = kinetic, U;
    flexel_lanes_potential(s, l->U0, (double *)&U);
    for (size_t i = 0; i < s->n; i++)
        for (int j = s->M_start[i]; j < s->M_start[i + 1]; j++)
            kinetic += V(s->v)[i] * V(s->M)[j] * V(s->v)[s->M_column[j]];
    for (size_t i = 0; i < s->nlaws; i++) {
        strain += V(s->law_U)[i];
        sizes += flexel_size(V(s->law_U)[i]);
    }
    const vec stored = flexel_size(U) + sizes, energy = kinetic / 2 + U + strain;
    for (size_t i = 0; i < FLEXEL_BLOCK; i++)
        if (l->accounts[i]) {
            l->accounts[i]->kinetic = kinetic[i] / 2;
            l->accounts[i]->stored = stored[i];
            l->accounts[i]->energy = energy[i];
        }
}
