/* The complete state that a workspace holds; see state.h. */
#include "state.h"

#include "copy.h"
#include "evaluate.h"

#include <math.h>
#include <string.h>

void flexel_reactions(flexel_work *s, const flexel_choice *c, double *stresses, double *reactions)
{
    const size_t first = s->m + s->k;
    flexel_momentum(s, s->a, reactions);
    flexel_pull(s, c->multiplier, reactions);
    for (size_t i = 0; i < s->nf; i++)
        reactions[i] = -c->multiplier[first + i];
    for (size_t i = s->nf; i < s->n; i++)
        reactions[i] -= c->force[i];
    for (size_t i = 0; i < first; i++)
        stresses[i] = s->stress[i] + c->multiplier[i];
}

static double sum(size_t count, const double *values)
{
    double z = 0;
    for (size_t i = 0; i < count; i++)
        z += values[i];
    return z;
}

void flexel_state(flexel_work *s, double *out)
{
    const size_t n = s->n, first = s->m + s->k;
    flexel_rates(s);
    out = flexel_put_numbers(out, s->x, n);
    out = flexel_put_numbers(out, s->v, n);
    out = flexel_put_numbers(out, s->a, n);
    out = flexel_put_numbers(out, s->e, s->m);
    out = flexel_put_numbers(out, s->w, first);
    out = flexel_put_numbers(out, s->v, n);
    memset(out, 0, first * sizeof(double)); /* of rows that are left out */
    flexel_push(s, s->a, out);
    for (size_t i = 0; i < first; i++)
        out[i] += s->g[i];
    out = flexel_put_numbers(out + first, s->a, n);
    out = flexel_put_numbers(out, s->z, s->nz);
    out = flexel_put_numbers(out, s->zd, s->nz);
    double kinetic = 0;
    for (size_t i = 0; i < n; i++)
        for (int l = s->M_start[i]; l < s->M_start[i + 1]; l++)
            kinetic += s->v[i] * s->M[l] * s->v[s->M_column[l]];
    out[0] = kinetic / 2;
    out[1] = s->U;
    out[2] = sum(s->nlaws, s->law_U);
    out[3] = sum(s->nlaws, s->law_P);
}

static double largest(size_t count, const double *values, double z)
{
    for (size_t i = 0; i < count; i++)
        z = fmax(z, fabs(values[i]));
    return z;
}

size_t flexel_complete_states(flexel_work *s, flexel_choice *c, size_t count, double *states, double *qdd, double *forces,
                              double *space, int *code)
{
    const size_t n = s->n;
    *code = 0;
    for (size_t i = 0; i < count; i++) {
        double *a = states + 1 + 2 * n, *e = a + n + s->nz, *stresses = e + s->m;
        flexel_reset(s, c);
        s->t = states[0];
        flexel_take_numbers(s->v, flexel_take_numbers(s->x, states + 1, n), n);
        flexel_take_numbers(s->unwrap_from, flexel_take_numbers(s->z, a + n, s->nz), s->m);
        *code = flexel_complete(s, c, 0);
        if (*code)
            return i;
        flexel_reactions(s, c, stresses, space);
        flexel_put_numbers(a, s->a, n);
        flexel_put_numbers(e, s->e, s->m);
        memset(space, 0, n * sizeof(double));
        flexel_pull(s, stresses, space);
        forces[i] = largest(s->nf, space, largest(s->nf, s->F, 0));
        flexel_put_numbers(qdd + i * c->nd, c->qdd, c->nd);
        states = stresses + s->m + s->k;
    }
    return count;
}
