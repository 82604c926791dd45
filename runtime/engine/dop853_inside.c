/* States within a step of DOP853: more stages, and values between them; see runge_kutta.h. */
#include "runge_kutta.h"

#include <math.h>
#include <string.h>

static void take(double *to, const double *from, size_t n)
{
    memcpy(to, from, n * sizeof(double));
}

void flexel_dop853_take(const flexel_work *s, flexel_dop853 *o, const flexel_dop853 *from)
{
    const size_t rows = FLEXEL_STAGES + 1, count = 3 * o->rotations.count;
    take(o->y, from->y, o->ny);
    take(o->x, from->x, s->n);
    take(o->e, from->e, s->nperiodic);
    take(o->rotations.w, from->rotations.w, count);
    take(o->K, from->K, rows * o->ny);
    take(o->V, from->V, rows * s->nf);
    take(o->turning, from->turning, rows * s->nperiodic);
    take(o->rotations.W, from->rotations.W, rows * count);
    o->sign = from->sign;
}

int flexel_dop853_more(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h, size_t first, size_t end,
                       const double *rows, const double *parts)
{
    take(s->x + s->nf, o->x + s->nf, s->n - s->nf);
    c->predict = 0;
    for (size_t stage = first; stage < end; stage++) {
        const double *row = rows + (stage - first) * FLEXEL_INSIDE;
        flexel_dop853_place(s, c, o, h, stage, row, o->space);
        const int failed = flexel_dop853_rates(s, c, o, stage, t + parts[stage - first] * h, o->space);
        if (failed)
            return failed;
    }
    return FLEXEL_DONE;
}

int flexel_dop853_locate(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h, const double *row,
                         size_t count)
{
    const size_t nq = c->nd + c->nk;
    take(s->x + s->nf, o->x + s->nf, s->n - s->nf);
    flexel_dop853_place(s, c, o, h, count, row, o->space);
    s->t = t;
    take(c->motion, o->given, 3 * c->np);
    take(c->loads, o->given + 3 * c->np, c->nloads);
    take(c->q, o->space, nq);
    take(c->qd, o->space + nq, c->nd);
    c->predict = 0;
    int failed = flexel_locate(s, c);
    return failed ? failed : flexel_velocity(s, c);
}

/* The largest defect of some variables with rates K, each over what is allowed. */
static double largest_defect(const double *K, size_t n, size_t i, double h, const double *row, size_t stage, double allowed)
{
    double slope = 0;
    for (size_t j = 0; j < stage; j++)
        if (row[j] != 0)
            slope += row[j] * K[j * n + i];
    return fabs(h * (slope - K[stage * n + i])) / allowed;
}

static double larger(double found, double largest)
{
    return found <= largest ? largest : found; /* not a number is kept */
}

double flexel_dop853_defect(const flexel_work *s, const flexel_dop853 *o, double h, const double *row, size_t stage,
                            const double *allowed)
{
    const flexel_rotations *r = &o->rotations;
    const size_t count = 3 * r->count;
    double largest = 0;
    for (size_t i = 0; i < o->ny; i++)
        largest = larger(largest_defect(o->K, o->ny, i, h, row, stage, allowed[i]), largest);
    for (size_t i = 0; i < count; i++)
        largest = larger(largest_defect(r->W, count, i, h, row, stage, allowed[o->ny + i]), largest);
    for (size_t i = 0; i < r->count; i++) {
        const size_t rest = (size_t)r->at[4 * i + (size_t)r->rest[i]];
        largest = larger(largest_defect(o->V, s->nf, rest, h, row, stage, allowed[o->ny + count + i]), largest);
    }
    return largest;
}
