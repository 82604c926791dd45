/* The control of the steps of Radau IIA; see radau.h. */
#include "radau.h"
#include "evaluate.h"

#include <math.h>
#include <string.h>

enum { ORDER = 4 }; /* of the estimated error */

/* Factors of the length of a step. KEPT: a factor from one up to this one is not worth other factors of the matrices. */
static const double SAFETY = 0.9, SMALLEST = 0.2, LARGEST = 8, KEPT = 1.2, HALF = 0.5;
static const double SLOW = 1e-3;        /* rate of convergence from which J is evaluated again */
static const double LEAST_ERROR = 1e-2; /* of a step that the prediction of the next one uses at least */
static const double SMALL = 1e-10;
static const double MINOR = 1e-4; /* values of a degree of freedom, or rates, relative to the largest ones, that count as zero */
/* Distance of the solved coordinates from the integral of their rates that is allowed: a part of the tolerance, but no less. In
 * long steps the estimate of the error of y says little about the coordinates that depend on it. */
static const double PART = 0.2, SHADOW = 2e-4;

static double norm(const flexel_radau *o, const double *error)
{
    double sum = 0;
    for (size_t i = 0; i < o->ny; i++)
        sum += error[i] / o->scale[i] * (error[i] / o->scale[i]);
    return o->ny ? sqrt(sum / (double)o->ny) : 0;
}

/* Allowed errors of some variables, for the largest values so far and y + Z. Those that are small beside the others of their
 * kind count as a part of these. */
static void allow_some(flexel_radau *o, const double *Z, size_t first, size_t end, double part)
{
    double most = 0;
    for (size_t i = first; i < end; i++) {
        const double here = Z ? fabs(o->y[i] + Z[i]) : 0;
        o->scale[i] = fmax(o->largest[i], here);
        most = fmax(most, o->scale[i] / o->natural[i]);
    }
    for (size_t i = first; i < end; i++)
        o->scale[i] = o->atol[i] + o->rtol * fmax(o->scale[i], part * most * o->natural[i]);
}

/* The same of all variables. */
static void allow(flexel_radau *o, const double *Z)
{
    const size_t nq = o->nd + o->nk;
    allow_some(o, Z, 0, nq, MINOR);
    allow_some(o, Z, nq, nq + o->nd, MINOR);
    allow_some(o, Z, nq + o->nd, o->ny, 0);
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
    memset(o->Z, 0, o->ny * sizeof(double));
    const int failed = flexel_radau_rates(s, c, o, 3, 0, o->Z, o->f);
    if (!failed)
        o->sign = flexel_matrix_sign(&c->P);
    for (size_t i = 0; i < o->ny; i++)
        o->largest[i] = fmax(o->largest[i], fabs(o->y[i]));
    return failed;
}

/* Less than one, the more so the more iterations the last stages needed. */
static double safety(const flexel_radau *o)
{
    const double most = FLEXEL_RADAU_ITERATIONS;
    return SAFETY * (2 * most + 1) / (2 * most + (double)o->iterations);
}

void flexel_radau_refuse(flexel_radau *o, double factor)
{
    o->h *= factor;
    o->rejected = 1;
    o->waiting = 0;
    o->refused++;
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
    return o->h < o->shortest && o->h < left;
}

/* The polynomial of the last step, continued. */
static void guess(flexel_radau *o)
{
    memset(o->Z, 0, 3 * o->ny * sizeof(double));
    for (size_t k = 0; k < 3 && o->last_h > 0; k++) {
        const double part = 1 + o->C[k] * o->h / o->last_h;
        double power = part;
        for (size_t p = 0; p < 4; p++, power *= part)
            for (size_t i = 0; i < o->ny; i++)
                o->Z[k * o->ny + i] += (power - 1) * o->powers[p * o->ny + i];
    }
}

/* The error relative to what is allowed, filtered once more after a refused step (8.20), and its estimate. */
static int judge(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    const size_t n = o->ny;
    double *change = o->F, *filtered = o->F + n;
    allow(o, o->Z + 2 * n);
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
        flexel_radau_refuse(o, fmax(SMALLEST, safety(o) * pow(o->error, -1.0 / ORDER)));
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
            flexel_radau_refuse(o, HALF);
            return FLEXEL_DONE;
        }
        o->factorized = o->h;
    }
    if (o->tried++)
        return_to_start(s, c, o);
    guess(o);
    allow(o, NULL);
    int failed = flexel_radau_stages(s, c, o, o->h);
    if (failed)
        return failed;
    if (!o->converged) {
        if (!o->fresh)
            return FLEXEL_RADAU_JACOBIAN;
        flexel_radau_refuse(o, HALF);
        o->last_error = 0;
        return FLEXEL_DONE;
    }
    failed = judge(s, c, o);
    if (!failed)
        shorten(o);
    return failed;
}

/* Rates at the end, and whether the end is where the rates in the step lead to. */
static int look_at_end(flexel_work *s, flexel_choice *c, flexel_radau *o)
{
    const size_t nf = s->nf;
    const int failed = flexel_radau_rates(s, c, o, 2, o->h, o->Z + 2 * o->ny, o->f_new);
    if (failed)
        return failed;
    memcpy(o->V + 2 * nf, s->v, nf * sizeof(double));
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
    o->error = fmax(o->error, o->off / fmax(SHADOW, PART * o->rtol));
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
    const double size = fmax(o->error, SMALL);
    double factor = pow(size, -1.0 / ORDER);
    if (o->last_error > 0)
        factor *= fmin(1, o->h / o->last_h * pow(o->last_error / size, 1.0 / ORDER));
    factor = fmin(LARGEST, fmax(SMALLEST, safety(o) * factor));
    if (o->rejected)
        factor = fmin(1, factor);
    return factor >= 1 && factor < KEPT && !o->stale ? o->h : o->h * factor;
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

void flexel_radau_accept(flexel_work *s, flexel_radau *o)
{
    const size_t n = o->ny;
    o->stale = o->iterations > 2 && o->rate > SLOW;
    const double next = next_length(o);
    interpolate(o);
    o->last_h = o->h;
    o->last_error = fmax(o->error, LEAST_ERROR);
    o->t = o->h == o->end - o->t ? o->end : o->t + o->h;
    o->h = next;
    for (size_t i = 0; i < n; i++) {
        o->y[i] += o->Z[2 * n + i];
        o->largest[i] = fmax(o->largest[i], fabs(o->y[i]));
    }
    memcpy(o->f, o->f_new, n * sizeof(double));
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
