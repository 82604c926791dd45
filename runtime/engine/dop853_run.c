/* Steps of DOP853 in a row; see dop853_run.h. */
#include "dop853_run.h"
#include "copy.h"

enum { GOES_ON = FLEXEL_ROW_JACOBIAN + 1 };

size_t flexel_dop853_slot(const flexel_dop853_run *r)
{
    const size_t ny = r->steps->ny, turns = r->row.work->nperiodic, count = 3 * r->steps->rotations.count;
    return ny + r->row.work->n + turns + count + (FLEXEL_STAGES + 1) * (ny + r->row.work->nf + turns + count) + 1;
}

/* A struct whose start and stages are in a slot. */
static flexel_dop853 slot_of(const flexel_dop853_run *r, size_t slot)
{
    flexel_dop853 o = *r->steps;
    const size_t rows = FLEXEL_STAGES + 1, turns = r->row.work->nperiodic, count = 3 * o.rotations.count;
    double *at = r->stages + slot * r->wide;
    o.y = at, at += o.ny;
    o.x = at, at += r->row.work->n;
    o.e = at, at += turns;
    o.rotations.w = at, at += count;
    o.K = at, at += rows * o.ny;
    o.V = at, at += rows * r->row.work->nf;
    o.turning = at, at += rows * turns;
    o.rotations.W = at, at += rows * count;
    o.sign = *at < 0 ? -1 : 1;
    return o;
}

void flexel_dop853_recall(const flexel_dop853_run *r, size_t slot, flexel_dop853 *o)
{
    const flexel_dop853 from = slot_of(r, slot);
    flexel_dop853_take(r->row.work, o, &from);
}

/* Keep the stages of a step in the next slot. */
static void keep_stages(flexel_dop853_run *r)
{
    flexel_dop853 slot = slot_of(r, r->used);
    flexel_dop853_take(r->row.work, &slot, r->steps);
    r->stages[(r->used + 1) * r->wide - 1] = r->steps->sign;
    r->used++;
}

/* Whether the stages of a step are the same if they are found anew. */
static int same_anew(const flexel_dop853_run *r)
{
    if (r->row.choice->P.lu != r->row.choice->P.first)
        return 0;
    for (size_t i = 0; i < r->row.work->nf; i++)
        if (r->steps->V[i] != r->v[i])
            return 0;
    return 1;
}

/* Keep a step that is found. */
static void keep(flexel_dop853_run *r, double amplification)
{
    const flexel_work *s = r->row.work;
    const flexel_dop853 *o = r->steps;
    const flexel_rotations *turns = &o->rotations;
    const flexel_covered *covered = o->covered;
    const double *K = o->K + FLEXEL_STAGES * o->ny, *W = turns->W + FLEXEL_STAGES * 3 * turns->count;
    const int stored = r->next < r->ntimes && r->times[r->next] < r->to;
    double *at = r->row.kept + r->row.taken * r->row.width;
    at[FLEXEL_KEPT_T] = r->to;
    at[FLEXEL_KEPT_AMPLIFICATION] = amplification;
    at[FLEXEL_KEPT_PART] = flexel_part_of_step(covered, covered->sizes[FLEXEL_TAKEN]);
    at[FLEXEL_KEPT_ACCEPT] = r->row.choice->accept;
    at[FLEXEL_KEPT_SLOT] = stored ? (double)r->used : -1;
    at[FLEXEL_KEPT_SAME] = same_anew(r);
    at = flexel_put_numbers(at + FLEXEL_KEPT, o->x_new, s->n);
    at = flexel_put_numbers(at, s->v, s->n);
    at = flexel_put_numbers(at, s->e, s->m);
    at = flexel_put_numbers(at, s->w, s->m);
    at = flexel_put_numbers(at, o->y_new, o->ny);
    at = flexel_put_numbers(at, K, o->ny);
    at = flexel_put_numbers(at, o->scale, o->ny);
    for (size_t i = 0; i < o->ny; i++)
        *at++ = flexel_moved(covered, i, o->y_new[i]);
    at = flexel_put_numbers(at, turns->w_new, 3 * turns->count);
    at = flexel_put_numbers(at, W, 3 * turns->count);
    flexel_put_numbers(at, turns->scale, 4 * turns->count);
    if (stored)
        keep_stages(r);
}

/* The next step begins at the end of the one that is found. */
static void accept(flexel_dop853_run *r, double error, double amplification)
{
    const double h = r->to - r->t, factor = flexel_longer(&r->rules.control, error);
    keep(r, amplification);
    flexel_dop853_accept(r->row.work, r->steps);
    r->row.accounts[r->row.taken] = *r->steps->account;
    r->h = h * (r->tries ? fmin(1, factor) : factor);
    if (r->to == r->row.end && !r->tries)
        r->h = fmax(r->h, r->first); /* it was cut short */
    flexel_put_numbers(r->v, r->row.work->v, r->row.work->n);
    flexel_put_numbers(r->e, r->row.work->e, r->row.work->m);
    flexel_put_numbers(r->w, r->row.work->w, r->row.work->m);
    while (r->next < r->ntimes && r->times[r->next] <= r->to)
        r->next++;
    r->t = r->to;
    r->row.amplification = amplification;
    r->refused += r->tries;
    r->row.taken++;
}

/* What the last trial has found. */
static flexel_step_found found(const flexel_dop853 *o)
{
    return (flexel_step_found){o->error,  o->error_own, o->error_x, o->error_v,      o->error_turns,
                               o->defect, o->defect_v,  o->fastest, o->changed != 0};
}

/* One trial of a step. */
static int attempt(flexel_dop853_run *r)
{
    flexel_dop853 *o = r->steps;
    const double *sizes = o->covered->sizes;
    if (r->h < flexel_row_shortest(&r->row, r->t) && r->h < r->row.end - r->t)
        return FLEXEL_ROW_SHORT;
    r->to = fmin(r->t + fmin(r->h, r->longest), r->row.end);
    if (r->varies && !r->row.waits) {
        r->row.waits = 1;
        return FLEXEL_ROW_INPUTS;
    }
    r->row.waits = 0;
    r->row.choice->accept = flexel_accepted_error(o->covered, r->accept, sizes[FLEXEL_RANGE], sizes[FLEXEL_TAKEN]);
    o->determinant = NULL;
    const size_t before = o->evaluations;
    r->code = flexel_dop853_step(r->row.work, r->row.choice, o, r->t, r->to - r->t);
    r->cost = o->evaluations - before;
    if (r->code != FLEXEL_DONE)
        return FLEXEL_ROW_TRIED;
    const flexel_step_found trial = found(o);
    const double error = flexel_error_of_step(&r->rules, &trial);
    if (!(error < 1)) {
        if (r->tries || isinf(error) || flexel_step_suspicious(&r->rules, &trial))
            return FLEXEL_ROW_TRIED;
        r->h = (r->to - r->t) * flexel_shorter(&r->rules.control, r->rules.control.safety, error);
        r->tries = 1;
        return GOES_ON;
    }
    const double amplification = flexel_amplification(r->row.work, r->row.choice);
    if (trial.changed || !flexel_step_trusted(&r->rules, &trial, r->row.amplification, amplification))
        return FLEXEL_ROW_TRIED;
    flexel_rates(r->row.work);
    if (flexel_row_touches(&r->row, o->x, r->e, r->w, o->x_new, r->to - r->t) || flexel_row_dips(&r->row))
        return FLEXEL_ROW_TRIED;
    accept(r, error, amplification);
    return FLEXEL_ROW_ENDED;
}

int flexel_dop853_steps(flexel_dop853_run *r)
{
    while (r->row.waits || (r->used < r->slots && flexel_row_goes_on(&r->row, r->t))) {
        int ended = GOES_ON;
        if (!r->row.waits)
            r->first = r->h, r->tries = 0;
        while (ended == GOES_ON)
            ended = attempt(r);
        if (ended != FLEXEL_ROW_ENDED)
            return ended;
    }
    return FLEXEL_ROW_ENDED;
}
