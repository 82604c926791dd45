/* Steps of DOP853 in a row; see dop853_run.h. */
#include "dop853_run.h"

#include <string.h>

enum { GOES_ON = FLEXEL_ROW_TRIED + 1 };

static double *copy(double *to, const double *from, size_t n)
{
    memcpy(to, from, n * sizeof(double));
    return to + n;
}

size_t flexel_dop853_slot(const flexel_dop853_run *r)
{
    const size_t ny = r->steps->ny, turns = r->work->nperiodic, count = 3 * r->steps->rotations.count;
    return ny + r->work->n + turns + count + (FLEXEL_STAGES + 1) * (ny + r->work->nf + turns + count) + 1;
}

/* A struct whose start and stages are in a slot. */
static flexel_dop853 slot_of(const flexel_dop853_run *r, size_t slot)
{
    flexel_dop853 o = *r->steps;
    const size_t rows = FLEXEL_STAGES + 1, turns = r->work->nperiodic, count = 3 * o.rotations.count;
    double *at = r->stages + slot * r->wide;
    o.y = at, at += o.ny;
    o.x = at, at += r->work->n;
    o.e = at, at += turns;
    o.rotations.w = at, at += count;
    o.K = at, at += rows * o.ny;
    o.V = at, at += rows * r->work->nf;
    o.turning = at, at += rows * turns;
    o.rotations.W = at, at += rows * count;
    o.sign = *at < 0 ? -1 : 1;
    return o;
}

void flexel_dop853_recall(const flexel_dop853_run *r, size_t slot, flexel_dop853 *o)
{
    const flexel_dop853 from = slot_of(r, slot);
    flexel_dop853_take(r->work, o, &from);
}

/* Keep the stages of a step in the next slot. */
static void keep_stages(flexel_dop853_run *r)
{
    flexel_dop853 slot = slot_of(r, r->used);
    flexel_dop853_take(r->work, &slot, r->steps);
    r->stages[(r->used + 1) * r->wide - 1] = r->steps->sign;
    r->used++;
}

/* Whether the stages of a step are the same if they are found anew. */
static int same_anew(const flexel_dop853_run *r)
{
    if (r->choice->P.lu != r->choice->P.first)
        return 0;
    for (size_t i = 0; i < r->work->nf; i++)
        if (r->steps->V[i] != r->v[i])
            return 0;
    return 1;
}

/* Keep a step that is found. */
static void keep(flexel_dop853_run *r, double amplification)
{
    const flexel_work *s = r->work;
    const flexel_dop853 *o = r->steps;
    const flexel_rotations *turns = &o->rotations;
    const flexel_covered *covered = o->covered;
    const double *K = o->K + FLEXEL_STAGES * o->ny, *W = turns->W + FLEXEL_STAGES * 3 * turns->count;
    const int stored = r->next < r->ntimes && r->times[r->next] < r->to;
    double *at = r->kept + r->taken * r->width;
    at[FLEXEL_KEPT_T] = r->to;
    at[FLEXEL_KEPT_AMPLIFICATION] = amplification;
    at[FLEXEL_KEPT_PART] = flexel_part_of_step(covered, covered->sizes[FLEXEL_TAKEN]);
    at[FLEXEL_KEPT_ACCEPT] = r->choice->accept;
    at[FLEXEL_KEPT_SLOT] = stored ? (double)r->used : -1;
    at[FLEXEL_KEPT_SAME] = same_anew(r);
    at = copy(at + FLEXEL_KEPT, o->x_new, s->n);
    at = copy(at, s->v, s->n);
    at = copy(at, s->e, s->m);
    at = copy(at, s->w, s->m);
    at = copy(at, o->y_new, o->ny);
    at = copy(at, K, o->ny);
    at = copy(at, o->scale, o->ny);
    for (size_t i = 0; i < o->ny; i++)
        *at++ = fmax(covered->most_y[i], o->y_new[i]) - fmin(covered->least_y[i], o->y_new[i]);
    at = copy(at, turns->w_new, 3 * turns->count);
    at = copy(at, W, 3 * turns->count);
    copy(at, turns->scale, 4 * turns->count);
    if (stored)
        keep_stages(r);
}

/* The next step begins at the end of the one that is found. */
static void accept(flexel_dop853_run *r, double error, double amplification)
{
    const double h = r->to - r->t, factor = flexel_longer(&r->rules.control, error);
    keep(r, amplification);
    flexel_dop853_accept(r->work, r->steps);
    r->accounts[r->taken] = *r->steps->account;
    r->h = h * (r->tries ? fmin(1, factor) : factor);
    if (r->to == r->end && !r->tries)
        r->h = fmax(r->h, r->first); /* it was cut short */
    copy(r->v, r->work->v, r->work->n);
    copy(r->e, r->work->e, r->work->m);
    copy(r->w, r->work->w, r->work->m);
    while (r->next < r->ntimes && r->times[r->next] <= r->to)
        r->next++;
    r->t = r->to;
    r->amplification = amplification;
    r->refused += r->tries;
    r->taken++;
}

/* What the last trial has found. */
static flexel_step_found found(const flexel_dop853 *o)
{
    return (flexel_step_found){o->error,  o->error_own, o->error_x, o->error_v,      o->error_turns,
                               o->defect, o->defect_v,  o->fastest, o->changed != 0};
}

/* Whether a contact begins, ends or is passed in the step. */
static int touches(const flexel_dop853_run *r)
{
    const flexel_touching *t = r->touching;
    return (t->nrows || t->ngaps) &&
           flexel_touching_look(t, r->work, r->steps->x, r->e, r->w, r->steps->x_new, r->to - r->t, 1, 0);
}

/* Whether a flat position is close, as in dips.py; if not, the end of the step becomes the start of the next. */
static int dips(flexel_dop853_run *r)
{
    const flexel_dips before = *r->dips;
    const int looks = flexel_dips_look(r->dips, &r->choice->P, r->known);
    const double largest = fmax(r->dips->size, r->largest);
    if (looks || largest - r->dips->size >= r->deep) {
        *r->dips = before;
        return 1;
    }
    r->largest = largest, r->known = 1;
    return 0;
}

/* One trial of a step. */
static int attempt(flexel_dop853_run *r)
{
    flexel_dop853 *o = r->steps;
    const double *sizes = o->covered->sizes, t = fabs(r->t), shortest = fmax(r->shortest, 10 * (nextafter(t, INFINITY) - t));
    if (r->h < shortest && r->h < r->end - r->t)
        return FLEXEL_ROW_SHORT;
    r->to = fmin(r->t + fmin(r->h, r->longest), r->end);
    r->choice->accept = flexel_accepted_error(o->covered, r->accept, sizes[FLEXEL_RANGE], sizes[FLEXEL_TAKEN]);
    o->determinant = NULL;
    const size_t before = o->evaluations;
    r->code = flexel_dop853_step(r->work, r->choice, o, r->t, r->to - r->t);
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
        if (r->first_order)
            flexel_matrix_reset(&r->choice->P);
        return GOES_ON;
    }
    const double amplification = flexel_amplification(r->work, r->choice);
    if (trial.changed || !flexel_step_trusted(&r->rules, &trial, r->amplification, amplification))
        return FLEXEL_ROW_TRIED;
    flexel_rates(r->work);
    if (touches(r) || dips(r))
        return FLEXEL_ROW_TRIED;
    accept(r, error, amplification);
    return FLEXEL_ROW_ENDED;
}

int flexel_dop853_steps(flexel_dop853_run *r)
{
    r->taken = r->refused = r->used = 0;
    while (r->t < r->end && r->taken < r->most && r->used < r->slots && r->amplification <= r->allowed) {
        int ended = GOES_ON;
        r->first = r->h, r->tries = 0;
        r->first_order = r->choice->P.lu == r->choice->P.first;
        while (ended == GOES_ON)
            ended = attempt(r);
        if (ended != FLEXEL_ROW_ENDED)
            return ended;
    }
    return FLEXEL_ROW_ENDED;
}
