/* The control of the steps of Radau IIA; see radau.h. */
#include "radau.h"
#include "evaluate.h"

#include <math.h>
#include <string.h>

static const double SLOW = 1e-3;        /* rate of convergence from which J is evaluated again */
static const double LEAST_ERROR = 1e-2; /* of a step that the prediction of the next one uses at least */
static const double SMALL = 1e-10;
/* Distance of the solved coordinates from the integral of their rates that is allowed: a part of the tolerance, but no less. In
 * long steps the estimate of the error of y says little about the coordinates that depend on it. */
static const double PART = 0.2, SMALLEST_DISTANCE = 2e-4;

static double norm(const flexel_radau *o, const double *error)
{
    double sum = 0;
    for (size_t i = 0; i < o->ny; i++)
        sum += error[i] / o->scale[i] * (error[i] / o->scale[i]);
    return o->ny ? sqrt(sum / (double)o->ny) : 0;
}

/* Sizes of y + Z: values, and how far rates have moved, if the motion is relative to itself. */
static const double *sizes(flexel_radau *o, const double *Z)
{
    double *variables = o->space, *size = o->space + o->ny;
    for (size_t i = 0; i < o->ny; i++) {
        variables[i] = o->y[i] + Z[i];
        size[i] = fabs(variables[i]);
    }
    for (size_t i = o->nd + o->nk; o->covered->relative && i < 2 * o->nd + o->nk; i++)
        size[i] = fmin(size[i], flexel_moved(o->covered, i, variables[i]));
    flexel_turns_sizes(o->turns, variables, size);
    flexel_angles_sizes(o->angles, variables, size);
    return size;
}

/* The largest sizes so far, up to y + Z. */
static void note_sizes(flexel_radau *o, const double *Z)
{
    const double *size = sizes(o, Z);
    for (size_t i = 0; i < o->ny; i++) {
        o->largest[i] = fmax(o->largest[i], size[i]);
        flexel_covered_value(o->covered, i, o->y[i] + Z[i]);
    }
}

/* Allowed errors of some variables, for the largest sizes so far and others: shares of the absolute tolerances, and of sizes
 * up to `limit` in natural scales. Those that are small beside the others of their kind count as a part of these. */
static void allow_some(flexel_radau *o, const double *size, size_t first, size_t end, double share, double limit, double part)
{
    double most = 0;
    for (size_t i = first; i < end; i++) {
        o->scale[i] = fmin(fmax(o->largest[i], size[i]), limit * o->natural[i]);
        most = fmax(most, o->scale[i] / o->natural[i]);
    }
    for (size_t i = first; i < end; i++)
        o->scale[i] = share * o->atol[i] + o->rtol * fmax(o->scale[i], part * most * o->natural[i]) + FLEXEL_NO_ERROR;
}

/* The first step from an instant has no polynomial that says how far it leads; its rates do. */
static void look_ahead(flexel_radau *o)
{
    double *m = o->covered->sizes_new;
    const size_t nq = o->nd + o->nk;
    for (size_t i = 0; i < o->nd; i++)
        m[FLEXEL_FASTEST] = fmax(m[FLEXEL_FASTEST], fabs(o->h * o->f[nq + i]) / o->natural[nq + i]);
    m[FLEXEL_RANGE] = fmax(m[FLEXEL_RANGE], o->h * m[FLEXEL_FASTEST]);
}

void flexel_radau_allow(const flexel_work *s, const flexel_choice *c, flexel_radau *o, const double *Z)
{
    flexel_covered *m = o->covered;
    const size_t nq = o->nd + o->nk, laws = nq + o->nd;
    const double *size = sizes(o, Z);
    flexel_covered_look(s, m, c->step_weight, s->x, s->v, o->space + laws); /* where y + Z is */
    if (!(o->last_h > 0) && o->iterations == 0)
        look_ahead(o);
    const flexel_shares shares = flexel_shares_of(m, m->sizes_new, 1, o->h);
    allow_some(o, size, 0, nq, shares.coordinates, shares.most * m->atol, o->minor);
    allow_some(o, size, nq, laws, shares.rates, INFINITY, o->minor);
    for (size_t i = 0; i < s->nz; i++) {
        const double share = flexel_share_of_states(&shares, m->states_new[m->group[i]]);
        allow_some(o, size, laws + i, laws + i + 1, share, INFINITY, 0);
    }
}

/* The next position is sought from that at the start of the step. */
static void return_to_start(flexel_work *s, flexel_choice *c, const flexel_radau *o)
{
    memcpy(c->x_last, o->x, s->n * sizeof(double));
    memcpy(c->e_last, o->e, s->m * sizeof(double));
    memcpy(c->ed_last, o->ed, s->m * sizeof(double));
    c->t_last = o->t;
    c->predict = 0;
}

int flexel_radau_begin(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    o->last_h = o->last_error = 0;
    o->waiting = o->rejected = o->fresh = 0;
    o->tried = 0;
    return_to_start(s, c, o);
    flexel_turns_begin(o->turns, o->x, o->v, o->y);
    flexel_angles_leave(o->angles, o->x);
    memset(o->Z, 0, o->ny * sizeof(double));
    const int failed = flexel_radau_rates(s, c, o, 3, 0, o->Z, o->f);
    if (!failed) {
        flexel_angles_begin(o->angles, s, c, o->y, o->f);
        o->sign = flexel_matrix_sign(&c->P);
        flexel_account_begin(o->account, s, c);
    }
    note_sizes(o, o->Z);
    return failed;
}

/* Less than one, the more so the more iterations the last stages needed. */
static double safety(const flexel_radau *o)
{
    const double most = FLEXEL_RADAU_ITERATIONS;
    return o->control.safety * (2 * most + 1) / (2 * most + (double)o->iterations);
}

void flexel_radau_refuse(flexel_radau *o, double factor)
{
    o->h *= factor;
    o->rejected = 1;
    o->waiting = 0;
    o->refused++;
}

void flexel_radau_look_again(flexel_radau *o)
{
    flexel_turns_look(o->turns, o->y);
    flexel_angles_look(o->angles);
    o->fresh = 1;
    o->stale = 0;
    o->factorized = 0;
}

/* The length of the next trial; whether it is too short. */
static int shortened(flexel_work *s, flexel_radau *o)
{
    const double left = o->end - o->t;
    double fastest = 0;
    for (size_t i = 0; i < s->n; i++)
        fastest = fmax(fastest, fabs(o->v[i]) * o->turning[i]);
    o->h = fmin(fmin(o->h, o->longest), left);
    if (o->h * fastest > o->travel)
        o->h = o->travel / fastest;
    const double angle = 2 * o->travel; /* of which Euler parameters turn by half */
    o->h = fmin(o->h, fmin(flexel_turns_longest(o->turns, o->y, angle), flexel_angles_longest(o->angles, o->y, angle)));
    return o->h < o->shortest && o->h < left;
}

/* The polynomial of the last step, continued. */
static void guess(flexel_radau *o)
{
    double *last = o->space;
    memset(o->Z, 0, 3 * o->ny * sizeof(double));
    for (size_t i = 0; i < o->ny; i++)
        last[i] = o->powers[i] + o->powers[o->ny + i] + o->powers[2 * o->ny + i] + o->powers[3 * o->ny + i];
    for (size_t k = 0; k < 3 && o->last_h > 0; k++) {
        const double part = 1 + o->C[k] * o->h / o->last_h;
        double power = part;
        for (size_t p = 0; p < 4; p++, power *= part)
            for (size_t i = 0; i < o->ny; i++)
                o->Z[k * o->ny + i] += (power - 1) * o->powers[p * o->ny + i];
        flexel_turns_guess(o->turns, last, o->Z + k * o->ny);
        flexel_angles_guess(o->angles, o->y, o->Z + k * o->ny);
    }
}

/* The error relative to what is allowed, filtered once more after a refused step (8.20), and its estimate. */
static int judge(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    const size_t n = o->ny;
    double *change = o->F, *filtered = o->F + n;
    flexel_radau_allow(s, c, o, o->Z + 2 * n);
    for (size_t i = 0; i < n; i++) {
        change[i] = 0;
        for (size_t k = 0; k < 3; k++)
            change[i] -= o->collocation[k] * o->Z[k * n + i] / o->h;
        o->estimate[i] = o->f[i] + change[i];
    }
    flexel_radau_solve(o, o->h, o->estimate);
    double size = norm(o, o->estimate);
    if ((o->rejected || !(o->last_h > 0)) && size >= 1) {
        const int failed = flexel_radau_rates(s, c, o, 3, 0, o->estimate, filtered);
        if (failed)
            return failed;
        for (size_t i = 0; i < n; i++)
            filtered[i] += change[i];
        flexel_radau_solve(o, o->h, filtered);
        size = norm(o, filtered);
    }
    o->error = isfinite(size) ? size * o->enlarged : INFINITY;
    return FLEXEL_DONE;
}

/* A shorter step, if the error asks for it. */
static void shorten(flexel_radau *o)
{
    if (o->error >= 1)
        flexel_radau_refuse(o, flexel_shorter(&o->control, safety(o), o->error));
}

/* One trial: its error, or an infinite one; what it waits for, or the code of what failed. */
static int attempt(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    o->error = INFINITY;
    if (o->stale)
        return FLEXEL_RADAU_JACOBIAN;
    if (o->factorized != o->h) {
        o->factorized = 0;
        if (flexel_radau_factorize(o, o->h)) {
            flexel_radau_refuse(o, o->control.unusable);
            return FLEXEL_DONE;
        }
        o->factorized = o->h;
    }
    if (o->tried++)
        return_to_start(s, c, o);
    guess(o);
    int failed = flexel_radau_stages(s, c, o, o->h);
    if (failed)
        return failed;
    const int far = flexel_turns_far(o->turns, o->Z + 2 * o->ny) || flexel_angles_far(o->angles, o->Z + 2 * o->ny);
    if (!o->converged || far) {
        if (!o->fresh && !far)
            return FLEXEL_RADAU_JACOBIAN;
        flexel_radau_refuse(o, o->control.unusable);
        o->last_error = 0;
        return FLEXEL_DONE;
    }
    failed = judge(s, c, o);
    if (!failed)
        shorten(o);
    return failed;
}

/* The allowed distance of the solved coordinates from the integral of their rates, in natural scales. */
static double allowed_distance(const flexel_radau *o)
{
    const double *found = o->covered->sizes_new, distance = fmax(SMALLEST_DISTANCE, PART * o->rtol);
    if (!o->covered->relative)
        return distance;
    return fmax(distance * flexel_at_most_one(found[FLEXEL_RANGE]), o->finest * fmax(1, found[FLEXEL_FARTHEST]));
}

/* Rates at the end, and whether the end is where the rates in the step lead to. */
static int look_at_end(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    const size_t nf = s->nf;
    const int failed = flexel_radau_rates(s, c, o, 2, o->h, o->Z + 2 * o->ny, o->f_new);
    if (failed)
        return failed;
    memcpy(o->V + 2 * nf, s->v, nf * sizeof(double));
    flexel_account_end(o->account, s, c);
    o->off = o->coarse = 0;
    for (size_t i = 0; i < nf; i++) {
        const double moved = s->x[i] - o->x[i], weight = c->step_weight[i];
        const double rates = o->b[0] * o->V[i] + o->b[1] * o->V[nf + i] + o->b[2] * o->V[2 * nf + i];
        const double off = fabs(moved - o->h * rates) * weight;
        o->coarse = fmax(o->coarse, fabs(moved - o->h / 2 * (o->v[i] + s->v[i])) * weight);
        if (!(off <= o->off)) {
            o->off = off;
            o->farthest = i;
        }
    }
    o->changed = flexel_matrix_sign(&c->P) != o->sign;
    flexel_rates(s);
    flexel_covered_look(s, o->covered, c->step_weight, s->x, s->v, o->space + 2 * o->nd + o->nk); /* where y + Z is */
    o->error = fmax(o->error, o->off / allowed_distance(o));
    shorten(o);
    return FLEXEL_DONE;
}

int flexel_radau_step(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    for (;;) {
        if (!o->waiting) {
            if (shortened(s, o))
                return FLEXEL_RADAU_SHORT;
            o->waiting = 1;
            if (o->ngiven)
                return FLEXEL_RADAU_INPUTS;
        }
        int found = attempt(s, c, o);
        if (!found && o->error < 1)
            found = look_at_end(s, c, o);
        if (found || o->error < 1)
            return found;
    }
}

/* The next length, by predictive control (8.26). */
static double next_length(flexel_radau *o)
{
    const flexel_control *c = &o->control;
    const double size = fmax(o->error, SMALL), power = -1 / c->order;
    double factor = pow(size, power);
    if (o->last_error > 0)
        factor *= fmin(1, o->h / o->last_h * pow(o->last_error / size, -power));
    factor = fmin(c->most, fmax(c->least, safety(o) * factor));
    if (o->rejected)
        factor = fmin(1, factor);
    return factor >= 1 && factor < c->steady && !o->stale ? o->h : o->h * factor;
}

/* Powers of time of the dense output: the collocation polynomial, corrected so that its rates at the start are right too. */
static void interpolate(flexel_radau *o)
{
    const size_t n = o->ny;
    for (size_t p = 0; p < 4; p++)
        for (size_t i = 0; i < n; i++) {
            double power = -o->mu * o->correction[p] * o->estimate[i];
            for (size_t k = 0; k < 3 && p < 3; k++)
                power += o->collocation[3 * p + k] * o->Z[k * n + i];
            o->powers[p * n + i] = power;
        }
}

void flexel_radau_accept(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    const size_t n = o->ny;
    flexel_account_accept(o->account, o->h);
    flexel_covered_accept(s, o->covered, s->x, s->v, o->h);
    o->stale = o->iterations > 2 && o->rate > SLOW;
    const double next = next_length(o);
    interpolate(o);
    o->last_h = o->h;
    o->last_error = fmax(o->error, LEAST_ERROR);
    o->t = o->h == o->end - o->t ? o->end : o->t + o->h;
    o->h = next;
    note_sizes(o, o->Z + 2 * n);
    for (size_t i = 0; i < n; i++)
        o->y[i] += o->Z[2 * n + i];
    memcpy(o->f, o->f_new, n * sizeof(double));
    flexel_turns_accept(o->turns, o->y, o->f);
    flexel_angles_accept(o->angles, s, c, o->y, o->f);
    memcpy(o->given + 3 * o->ngiven, o->given + 2 * o->ngiven, o->ngiven * sizeof(double));
    memcpy(o->x, s->x, s->n * sizeof(double));
    memcpy(o->v, s->v, s->n * sizeof(double));
    memcpy(o->e, s->e, s->m * sizeof(double));
    memcpy(o->ed, s->w, s->m * sizeof(double));
    if (o->changed)
        o->sign = -o->sign;
    o->fresh = o->waiting = o->rejected = 0;
    o->tried = 0;
}
