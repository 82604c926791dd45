/* Steps of Radau IIA in a row; see radau_run.h. */
#include "radau_run.h"
#include "copy.h"
#include "evaluate.h"
#include "runge_kutta.h"

#include <math.h>

/* Keep a step that is found: what is known before the next one begins. Where the powers of its dense output go. */
static double *keep(const flexel_radau_run *r, double amplification)
{
    const flexel_work *s = r->row.work;
    const flexel_radau *o = r->steps;
    const flexel_turns *turns = o->turns;
    const flexel_angles *angles = o->angles;
    double *at = r->row.kept + r->row.taken * r->row.width;
    at[FLEXEL_RADAU_KEPT_H] = o->h;
    at[FLEXEL_RADAU_KEPT_AMPLIFICATION] = amplification;
    at = flexel_put_numbers(at + FLEXEL_RADAU_KEPT, s->x, s->n);
    at = flexel_put_numbers(at, s->v, s->n);
    at = flexel_put_numbers(at, s->e, s->m);
    at = flexel_put_numbers(at, s->w, s->m);
    at = flexel_put_numbers(at, o->y, o->ny);
    for (size_t i = 0; i < o->ny; i++)
        *at++ = o->y[i] + o->Z[2 * o->ny + i];
    double *powers = at;
    at = flexel_put_numbers(at + 4 * o->ny, turns->start, 4 * turns->count);
    for (size_t i = 0; i < turns->count; i++)
        *at++ = turns->space[i];
    for (size_t i = 0; i < angles->count; i++)
        *at++ = angles->start[4 * i + (size_t)angles->part[i]];
    flexel_put_numbers(at, angles->slope, angles->count);
    return powers;
}

/* The next step begins at the end of the one that is found. */
static void accept(flexel_radau_run *r, double amplification)
{
    flexel_radau *o = r->steps;
    const double h = o->h;
    const int cut = h < r->wished && !o->rejected;
    double *powers = keep(r, amplification);
    flexel_radau_accept(r->row.work, r->row.choice, o);
    flexel_put_numbers(powers, o->powers, 4 * o->ny);
    r->row.kept[r->row.taken * r->row.width + FLEXEL_RADAU_KEPT_T] = o->t;
    if (cut && o->t == o->end && o->last_h == h)
        o->h = fmax(o->h, r->wished);
    r->row.accounts[r->row.taken++] = *o->account;
    r->row.amplification = amplification;
}

int flexel_radau_steps(flexel_radau_run *r)
{
    flexel_radau *o = r->steps;
    while (r->row.waits || flexel_row_goes_on(&r->row, o->t)) {
        if (!r->row.waits)
            r->wished = o->h;
        r->row.waits = 0;
        o->end = r->row.end;
        o->shortest = flexel_row_shortest(&r->row, o->t);
        o->enlarged = fmax(1, r->row.amplification / fmax(1, r->best));
        const int code = flexel_radau_step(r->row.work, r->row.choice, o);
        if (code == FLEXEL_RADAU_INPUTS || code == FLEXEL_RADAU_JACOBIAN) {
            r->row.waits = 1;
            return code == FLEXEL_RADAU_INPUTS ? FLEXEL_ROW_INPUTS : FLEXEL_ROW_JACOBIAN;
        }
        if (code || o->changed)
            return FLEXEL_ROW_TRIED;
        const double amplification = flexel_amplification(r->row.work, r->row.choice);
        if (flexel_row_touches(&r->row, o->x, o->e, o->ed, r->row.work->x, o->h) || flexel_row_dips(&r->row))
            return FLEXEL_ROW_TRIED;
        accept(r, amplification);
    }
    return FLEXEL_ROW_ENDED;
}
