/* The balance of forces and its tangent; see balance.h. Symbols as in the formulation. */
#include "balance.h"
#include "evaluate.h"

#include <math.h>
#include <string.h>

/* Largest entry of the row of a deformation or slip in J, found where it is first needed. */
static double row_size(const flexel_balance *b, size_t i)
{
    const flexel_work *w = b->work;
    if (b->size[i] < 0) {
        double most = 0;
        for (int j = w->J_start[i]; j < w->J_start[i + 1]; j++)
            most = flexel_larger(most, fabs(w->J[j]));
        b->size[i] = most;
    }
    return b->size[i];
}

static void stresses(flexel_balance *b)
{
    flexel_work *w = b->work;
    const size_t first = w->m + w->k;
    for (size_t i = 0; i < first; i++)
        w->stress[i] = b->given[i] = w->law_stress[i] + b->applied[i];
    for (size_t i = 0; i < b->nforce; i++)
        if ((size_t)b->rows[i] < first)
            w->stress[b->rows[i]] += b->mu[i];
}

/* Errors of the rigid and prescribed conditions. */
static void gaps(flexel_balance *b)
{
    const flexel_work *w = b->work;
    const size_t first = w->m + w->k;
    for (size_t i = 0; i < b->nh; i++) {
        const size_t row = (size_t)b->rows[i];
        double z = (row < w->m ? w->e[row] : row < first ? 0.0 : w->x[row - first]) - b->target[i];
        if (b->period[i] > 0)
            z -= b->period[i] * rint(z / b->period[i]);
        b->gap[i] = z;
    }
}

/* Forces on all coordinates, and the size of their parts on the free ones. */
static void forces(flexel_balance *b)
{
    flexel_work *w = b->work;
    const size_t first = w->m + w->k;
    double scale = 0;
    flexel_momentum(w, w->a, b->force);
    for (size_t i = 0; i < w->n; i++) {
        const double outer = -w->F[i] - b->nodal[i];
        if (i < w->nf)
            scale = flexel_larger(flexel_larger(scale, fabs(outer)), fabs(b->force[i]));
        b->force[i] += outer;
    }
    flexel_pull(w, w->stress, b->force);
    for (size_t i = 0; i < first; i++)
        if (w->stress[i] != 0) /* open contacts are many */
            scale = flexel_larger(scale, fabs(w->stress[i]) * row_size(b, i));
    memcpy(b->r, b->force, w->nf * sizeof(double));
    for (size_t i = 0; i < b->nforce; i++) {
        const size_t row = (size_t)b->rows[i];
        scale = flexel_larger(scale, fabs(b->mu[i]));
        if (row >= first && row < first + w->nf)
            b->r[row - first] += b->mu[i];
    }
    b->scale = scale;
}

void flexel_balanced(flexel_balance *b)
{
    flexel_work *w = b->work;
    flexel_position(w);
    flexel_rates(w);
    if (b->implicit && w->nz)
        flexel_implicit_states(w, b->known, b->share, b->at_rest);
    else
        flexel_laws(w);
    flexel_inertia(w);
    stresses(b);
    for (size_t i = 0; !b->sized && i < w->m + w->k; i++)
        b->size[i] = -1;
    b->sized = 1;
    forces(b);
    gaps(b);
}

static int any(size_t n, const double *values)
{
    for (size_t i = 0; i < n; i++)
        if (values[i] != 0)
            return 1;
    return 0;
}

static int all_finite(size_t n, const double *values)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(values[i]))
            return 0;
    return 1;
}

int flexel_balance_tangent(flexel_balance *b, double scaling, double rate, double acceleration, double share)
{
    flexel_work *w = b->work;
    b->sized = 0;
    flexel_law_tangents(w, share, b->at_rest);
    /* stresses that are not finite say that a trial step was too long: the iteration rejects it */
    const int failed = !(all_finite(w->nS, w->S) && all_finite(w->nS, w->S_rate)) && all_finite(w->m + w->k, w->law_stress);
    const int phi = any(w->n, w->v) && (b->nforce > b->nh || any(w->nS, w->S_rate));
    if (phi)
        flexel_rate_derivatives(w);
    flexel_tangent(w, scaling, scaling * rate, scaling * acceleration, phi);
    /* slips change with x and v: rows of rolling conditions, whose rates vanish */
    const int start = w->J_start[w->m];
    for (size_t j = b->nh; j < b->nforce; j++) {
        const size_t row = (size_t)b->rows[j];
        for (int i = w->J_start[row]; row >= w->m && row < w->m + w->k && i < w->J_start[row + 1]; i++)
            w->H[i - start] = w->J[i] + (phi && rate != 0 ? w->Phi[i] / rate : 0.0);
    }
    return failed;
}

static double total(size_t n, const double *values)
{
    double z = 0;
    for (size_t i = 0; i < n; i++)
        z += values[i];
    return z;
}

static double kinetic_energy(const flexel_work *w)
{
    double z = 0;
    for (size_t i = 0; i < w->n; i++) {
        double p = 0;
        for (int j = w->M_start[i]; j < w->M_start[i + 1]; j++)
            p += w->M[j] * w->v[w->M_column[j]];
        z += p * w->v[i];
    }
    return z / 2;
}

void flexel_energies_at(flexel_energies *s, const flexel_work *w)
{
    s->kinetic = kinetic_energy(w);
    s->potential = w->U;
    s->strain = total(w->nlaws, w->law_U);
    s->lost = total(w->nlaws, w->law_P);
    for (size_t i = 0; w->damped && i < w->n; i++)
        s->lost += w->v[i] * w->damping[i];
    s->contact = s->begun = s->deepest = 0;
    for (size_t i = 0; i < s->ncontacts; i++) {
        const double stored = w->law_U[s->law[i]], depth = fabs(w->e[s->gap[i]]);
        s->contact += stored;
        if (stored > 0 && s->touching[i])
            s->deepest = fmax(s->deepest, depth);
        else if (stored > 0)
            s->begun = fmax(s->begun, depth);
    }
}

void flexel_touched(flexel_energies *s, const flexel_work *w)
{
    for (size_t i = 0; i < s->ncontacts; i++)
        s->touching[i] = w->law_U[s->law[i]] > 0;
}
