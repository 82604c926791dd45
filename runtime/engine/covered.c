/* What a motion has covered so far; see covered.h. */
#include "covered.h"

#include <string.h>

/* fmax would be a call */
static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

void flexel_covered_look(const flexel_work *s, flexel_covered *c, const double *weight, const double *x, const double *v,
                         const double *z)
{
    double range = c->sizes[FLEXEL_RANGE], farthest = c->sizes[FLEXEL_FARTHEST], fastest = c->sizes[FLEXEL_FASTEST];
    for (size_t i = 0; i < s->nf; i++) {
        range = larger(range, (larger(c->high[i], x[i]) - smaller(c->low[i], x[i])) * weight[i]);
        farthest = larger(farthest, fabs(x[i]) * weight[i]);
        fastest = larger(fastest, fabs(v[i]) * weight[i]);
    }
    c->sizes_new[FLEXEL_RANGE] = range;
    c->sizes_new[FLEXEL_FARTHEST] = farthest;
    c->sizes_new[FLEXEL_FASTEST] = fastest;
    c->sizes_new[FLEXEL_TAKEN] = c->sizes[FLEXEL_TAKEN];
    c->sizes_new[FLEXEL_LONGEST] = c->sizes[FLEXEL_LONGEST];
    memcpy(c->states_new, c->states, c->groups * sizeof(double));
    for (size_t i = 0; i < s->nz; i++)
        c->states_new[c->group[i]] = larger(c->states_new[c->group[i]], fabs(z[i]));
}

void flexel_covered_begin(const flexel_work *s, flexel_covered *c, const double *x, const double *v)
{
    for (size_t i = 0; i < s->nf; i++) {
        c->quick[i] = larger(c->quick[i], fabs(v[i]));
        c->low[i] = smaller(c->low[i], x[i]);
        c->high[i] = larger(c->high[i], x[i]);
    }
    memcpy(c->sizes, c->sizes_new, FLEXEL_SIZES * sizeof(double));
    memcpy(c->states, c->states_new, c->groups * sizeof(double));
}

void flexel_covered_accept(const flexel_work *s, flexel_covered *c, const double *x, const double *v, double h)
{
    flexel_covered_begin(s, c, x, v);
    c->sizes[FLEXEL_TAKEN]++;
    c->sizes[FLEXEL_LONGEST] = larger(c->sizes[FLEXEL_LONGEST], h);
}

double flexel_part_of_step(const flexel_covered *c, double taken)
{
    return larger(taken > c->full ? c->full / taken : 1, c->least);
}

double flexel_accepted_error(const flexel_covered *c, double accept, double range, double taken)
{
    return flexel_part_of_step(c, taken) * (c->relative ? accept * flexel_at_most_one(range) : accept);
}
