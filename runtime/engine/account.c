/* The energy balance of a motion in minimal coordinates; see account.h. */
#include "account.h"
#include "rows.h"

#include <math.h>

/* Power of what drives prescribed quantities: that of all constraint forces, since the others do no work. */
static double driving(const flexel_work *s, const flexel_choice *c)
{
    double power = 0;
    for (size_t i = 0; i < s->nf; i++) {
        double z = -c->force[i];
        for (int l = s->M_start[i]; l < s->M_free[i]; l++)
            z += s->M[l] * s->a[s->M_column[l]];
        power += s->v[i] * z;
    }
    return power;
}

void flexel_account_stage(flexel_account *o, const flexel_work *s, const flexel_choice *c, size_t stage)
{
    if (!o)
        return;
    const size_t first = s->m + s->k;
    double lost = 0, work = c->np ? driving(s, c) : 0;
    for (size_t i = 0; i < s->nlaws; i++)
        lost += s->law_P[i];
    for (size_t i = 0; s->damped && i < s->n; i++)
        lost += s->v[i] * s->damping[i];
    for (size_t i = 0; i < c->nloads; i++) {
        const int quantity = c->loaded[i];
        const int coordinate = (size_t)quantity >= first;
        work += c->loads[i] * (coordinate ? s->v[(size_t)quantity - first] : flexel_row_value(s, quantity, s->v));
    }
    o->lost[stage] = lost;
    o->work[stage] = work;
}

static void energies(flexel_account *o, const flexel_work *s)
{
    double kinetic = 0, strain = 0, sizes = 0;
    for (size_t i = 0; i < s->n; i++)
        for (int l = s->M_start[i]; l < s->M_start[i + 1]; l++)
            kinetic += s->v[i] * s->M[l] * s->v[s->M_column[l]];
    for (size_t i = 0; i < s->nlaws; i++) {
        strain += s->law_U[i];
        sizes += fabs(s->law_U[i]);
    }
    o->kinetic = kinetic / 2;
    o->stored = fabs(s->U) + sizes;
    o->energy = o->kinetic + s->U + strain;
}

void flexel_account_end(flexel_account *o, const flexel_work *s, const flexel_choice *c)
{
    if (!o)
        return;
    flexel_account_stage(o, s, c, o->end);
    energies(o, s);
}

static double sum(size_t n, const double *weights, const double *values)
{
    double z = 0;
    for (size_t i = 0; i < n; i++)
        z += weights[i] * values[i];
    return z;
}

/* Error of an integral of a power, from a fine and a rough formula as in the control of the steps of DOP853. */
static double error(const flexel_account *o, const double *powers)
{
    const double fine = sum(o->nestimates, o->estimate, powers);
    const double rough = sum(o->nestimates, o->rough, powers);
    const double size = sqrt(fine * fine + 0.01 * rough * rough);
    return size > 0 ? fine * fine / size : 0;
}

/* Add a stretch of length h, from the energy at its start to that at its end, with known integrals and their error. */
static void add(flexel_account *o, double h, double lost, double work, double doubt)
{
    const double missing = o->begun + work - lost - o->energy;
    o->missing += missing;
    o->passed += h;
    if (fabs(missing) > o->worst) {
        o->worst = fabs(missing);
        o->when = o->passed;
    }
    o->farthest = isnan(o->missing) ? INFINITY : fmax(o->farthest, fabs(o->missing)); /* an energy has no value */
    o->doubt += doubt;
    o->through += fabs(lost) + fabs(work);
    o->fastest = fmax(o->fastest, o->kinetic);
    o->largest = fmax(o->largest, o->stored);
    o->begun = o->energy;
}

void flexel_account_begin(flexel_account *o, const flexel_work *s, const flexel_choice *c)
{
    if (!o)
        return;
    flexel_account_stage(o, s, c, o->start);
    energies(o, s);
    if (o->parted)
        o->begun = o->energy; /* nothing is missing */
    o->parted = 0;
    add(o, 0, 0, 0, 0);
}

void flexel_account_accept(flexel_account *o, double h)
{
    if (!o)
        return;
    add(o, h, h * sum(o->nweights, o->weights, o->lost), h * sum(o->nweights, o->weights, o->work),
        h * (error(o, o->lost) + error(o, o->work)));
    o->lost[o->start] = o->lost[o->end];
    o->work[o->start] = o->work[o->end];
}

void flexel_account_carry(flexel_account *o, const flexel_work *s, double h, double lost, double work, double doubt)
{
    energies(o, s);
    add(o, h, lost, work, doubt);
}
