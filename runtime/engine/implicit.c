/* Steps of the generalized-alpha method; see implicit.h.
 *
 * Rigid and prescribed conditions hold at every step to rounding (index 3), rolling conditions on the rates; multipliers
 * are scaled by beta h^2, so that the matrix does not grow ill-conditioned with small steps. Source: Chung and Hulbert
 * (1993); Jansen, Whiting and Hulbert (2000) for internal states; Arnold and Bruls (2007); Bottasso, Bauchau and Cardona
 * (2007) for the scaling. */
#include "implicit.h"
#include "evaluate.h"

#include <math.h>
#include <string.h>

enum {
    MOST_ITERATIONS = 20,
    PATIENCE = 8,    /* iterations within which the error must drop to a tenth */
    SHORTENINGS = 6, /* of a step of Newton's method, each to 40 % */
};
/* Relative errors: accepted at once, accepted when rounding stalls progress, and accepted of a prediction. The unbalance
 * of predictions has the same sign over many steps, and is not small beside the forces of a small vibration: it would
 * drive the motion. */
static const double CONVERGED = 1e-11, STALLED = 1e-8, PREDICTED = 1e-16;
static const double ROUGH = 0.1; /* relative error of a prediction beyond which another is tried */
static const double SLOW = 0.2;  /* a contraction weaker than this renews the matrix */

static double rate_of(const flexel_step *s)
{
    return s->gamma / (s->h * s->beta);
}

static double acceleration_of(const flexel_step *s)
{
    return (1 - s->alpha_m) / (s->h * s->h * s->beta * (1 - s->alpha_f));
}

static double scaling_of(const flexel_step *s)
{
    return s->beta * s->h * s->h;
}

static void copy(double *to, const double *from, size_t n)
{
    memcpy(to, from, n * sizeof(double));
}

/* The point at the end of the step if accelerations stay as they are. */
static void predict(flexel_step *s)
{
    const flexel_work *work = s->balance->work;
    const flexel_point *p = &s->old;
    const double m = s->alpha_m, f = s->alpha_f, h = s->h;
    for (size_t i = 0; i < work->n; i++) {
        const int is_free = i < work->nf;
        const double w = (p->a[i] - m * p->w[i]) / (1 - m);
        s->now.x[i] = p->x[i];
        s->now.v[i] = p->v[i];
        if (is_free) {
            s->now.x[i] += h * p->v[i] + h * h * ((0.5 - s->beta) * p->w[i] + s->beta * w);
            s->now.v[i] += h * ((1 - s->gamma) * p->w[i] + s->gamma * w);
        }
        s->now.a[i] = f * p->a[i] + (1 - f) * p->a[i];
        s->now.w[i] = w;
    }
    copy(s->now.mu, p->mu, s->balance->nforce);
    copy(s->now.e, p->e, work->m);
}

/* Internal states that the scheme asks for at the end: z = known + share dz/dt. */
static void lag(flexel_step *s)
{
    flexel_balance *b = s->balance;
    const flexel_point *p = &s->old;
    const double share = s->h * s->lag_gamma / (1 - s->lag_m), f = s->alpha_f;
    for (size_t i = 0; i < b->work->nz; i++)
        b->known[i] = p->z[i] + s->h * (1 - s->lag_gamma) * p->zw[i] + share * (f * p->zd[i] - s->lag_m * p->zw[i]);
    b->share = share * (1 - f);
    b->implicit = 1;
}

/* The balance at `now`, moved back by a share of the step of coordinates and scaled multipliers. */
static void evaluate(flexel_step *s, double share)
{
    flexel_balance *b = s->balance;
    flexel_work *w = b->work;
    const double rate = rate_of(s), acceleration = acceleration_of(s), scaling = scaling_of(s);
    for (size_t i = 0; i < w->n; i++) {
        const double dx = share != 0 && i < w->nf ? -share * s->step[i] : 0.0;
        w->x[i] = s->now.x[i] + dx;
        w->v[i] = s->now.v[i] + rate * dx;
        w->a[i] = s->now.a[i] + acceleration * dx;
    }
    for (size_t i = 0; i < b->nforce; i++)
        b->mu[i] = s->now.mu[i] - (share != 0 ? share * s->step[w->nf + i] / scaling : 0.0);
    copy(w->unwrap_from, s->now.e, w->m);
    copy(w->z, s->old.z, w->nz);
    flexel_balanced(b);
}

/* Let `now` be the point that was evaluated last, at that share of the step. */
static void move(flexel_step *s, double share)
{
    const flexel_balance *b = s->balance;
    const flexel_work *w = b->work;
    const double factor = (1 - s->alpha_f) / (1 - s->alpha_m) * acceleration_of(s);
    for (size_t i = 0; share != 0 && i < w->nf; i++)
        s->now.w[i] -= factor * share * s->step[i];
    copy(s->now.x, w->x, w->n);
    copy(s->now.v, w->v, w->n);
    copy(s->now.a, w->a, w->n);
    copy(s->now.mu, b->mu, b->nforce);
    copy(s->now.e, w->e, w->m);
}

/* Error of the balance relative to forces of a size: unbalance, and errors of conditions in their natural scales.
 *
 * A stiffness K turns rounding of x into an unbalance of about 1e-15 K x, a lower bound; with that of each row in the
 * denominator the tolerance can still be met. */
static double size(const flexel_step *s, double scale)
{
    const flexel_balance *b = s->balance;
    const flexel_work *w = b->work;
    double error = 0;
    for (size_t i = 0; i < w->nf; i++)
        error = flexel_larger(error, fabs(b->r[i]) / (scale + 1e-3 * s->length * s->stiffness[i] + s->tiny));
    error *= s->forces;
    for (size_t i = 0; i < b->nh; i++)
        error = flexel_larger(error, fabs(b->gap[i]) / s->hold_scale[i]);
    for (size_t i = b->nh; i < b->nforce; i++)
        error = flexel_larger(error, fabs(w->w[b->rows[i]]) * s->h);
    return error;
}

/* The predicted point, or that of an unaccelerated step if its residual is smaller.
 *
 * Accelerations of stiff parts that are not at rest give poor predictions. */
static void start(flexel_step *s)
{
    const flexel_work *w = s->balance->work;
    evaluate(s, 0);
    s->evaluations++;
    move(s, 0);
    const double scale = s->balance->scale, predicted = size(s, scale);
    s->error = predicted;
    if (predicted < ROUGH)
        return;
    for (size_t i = 0; i < w->nf; i++)
        s->step[i] = s->now.x[i] - s->old.x[i] - s->h * s->old.v[i];
    memset(s->step + w->nf, 0, s->balance->nforce * sizeof(double));
    evaluate(s, 1);
    s->evaluations++;
    if (size(s, scale) < predicted) {
        move(s, 1);
        s->error = size(s, s->balance->scale);
    } else {
        evaluate(s, 0);
    }
}

/* The matrix; the first of a step gives the stiffness of its rows. */
static int renew(flexel_step *s)
{
    flexel_balance *b = s->balance;
    const flexel_work *w = b->work;
    const double scaling = scaling_of(s);
    s->factorizations++;
    if (flexel_balance_tangent(b, scaling, rate_of(s), acceleration_of(s), w->nz ? b->share : 0.0))
        return FLEXEL_NO_SLOPE;
    for (size_t i = 0; s->iteration == 0 && i < w->nf; i++) {
        double z = 0;
        for (int j = w->T_start[i]; j < w->T_start[i + 1]; j++)
            z += fabs(w->T[j]);
        s->stiffness[i] = z / scaling;
    }
    if (s->iteration == 0)
        s->stiffness_step = s->h;
    s->matrix_step = s->h;
    return FLEXEL_FOUND;
}

static void right_hand_side(flexel_step *s)
{
    const flexel_balance *b = s->balance;
    const flexel_work *w = b->work;
    const double scaling = scaling_of(s), rate = rate_of(s);
    for (size_t i = 0; i < w->nf; i++)
        s->step[i] = scaling * b->r[i];
    for (size_t i = 0; i < b->nforce; i++)
        s->step[w->nf + i] = i < b->nh ? b->gap[i] : w->w[b->rows[i]] / rate;
}

/* Go to the point after a step of Newton's method, shortened while its residual exceeds the previous one.
 *
 * Contacts that open and close, and friction that saturates, make the full step overshoot. */
static void search(flexel_step *s)
{
    const double scale = s->balance->scale;
    double share = 1, best = 0, least = INFINITY;
    for (size_t i = 0; i < SHORTENINGS; i++) {
        evaluate(s, share);
        s->evaluations++;
        const double found = size(s, scale);
        if (i == 0 || found < least) {
            best = share;
            least = found;
        }
        if (found < (1 - 0.1 * share) * s->error || size(s, s->balance->scale) < STALLED || i + 1 == SHORTENINGS)
            break;
        share *= 0.4;
    }
    if (best != share)
        evaluate(s, best);
    move(s, best);
}

/* The end of a step that was found, with its local error. */
static void finish(flexel_step *s)
{
    const flexel_work *w = s->balance->work;
    const flexel_point *p = &s->old;
    for (size_t i = 0; i < w->nz; i++) {
        s->now.z[i] = w->z[i];
        s->now.zd[i] = w->zd[i];
        s->now.zw[i] = ((1 - s->alpha_f) * w->zd[i] + s->alpha_f * p->zd[i] - s->lag_m * p->zw[i]) / (1 - s->lag_m);
    }
    flexel_local_errors(s);
}

/* Iterations until the step is found or given up, or something has to be done that is not done here. */
static int iterate(flexel_step *s)
{
    for (;; s->iteration++) {
        if (s->error < (s->iteration ? CONVERGED : PREDICTED) || (s->error < STALLED && s->error > 0.5 * s->last)) {
            finish(s);
            return FLEXEL_FOUND;
        }
        if (!isfinite(s->error) || s->iteration == MOST_ITERATIONS ||
            (s->iteration >= PATIENCE && s->error > 0.1 * s->first))
            return FLEXEL_NOT_FOUND;
        const int fresh = s->matrix_step == 0 || s->full || s->error > SLOW * s->last;
        if (fresh) {
            const int failure = renew(s);
            if (failure)
                return failure;
        }
        right_hand_side(s);
        s->iterations++;
        if (!s->lu)
            return fresh ? FLEXEL_FACTORIZE : FLEXEL_SOLVE;
        if (fresh && flexel_lu_factor(s->lu, 1, s->source, s->values, s->factors))
            return FLEXEL_FACTORIZE;
        flexel_lu_solve(s->lu, s->factors, 1, s->step, s->step, s->space);
        search(s);
        s->last = s->error;
        s->error = size(s, s->balance->scale);
    }
}

/* Stiffness of the rows for a longer step, in which mass counts less. Too large a stiffness would let a step be accepted
 * whose forces do not balance; where stiffness is due to springs, it is found again with the matrix. */
static void soften(flexel_step *s)
{
    const double ratio = s->stiffness_step / s->h;
    if (ratio >= 1 || s->stiffness_step == 0)
        return;
    for (size_t i = 0; i < s->balance->work->nf; i++)
        s->stiffness[i] *= ratio * ratio;
    s->stiffness_step = s->h;
}

int flexel_step_begin(flexel_step *s)
{
    soften(s);
    s->balance->work->t = s->t + s->h;
    if (fabs(s->matrix_step - s->h) > 1e-9 * s->h)
        s->matrix_step = 0;
    predict(s);
    lag(s);
    start(s);
    s->iteration = 0;
    s->first = s->error;
    s->last = INFINITY;
    return iterate(s);
}

int flexel_step_resume(flexel_step *s)
{
    search(s);
    s->last = s->error;
    s->error = size(s, s->balance->scale);
    s->iteration++;
    return iterate(s);
}

void flexel_step_accept(flexel_step *s)
{
    const flexel_work *w = s->balance->work;
    flexel_point *to = &s->old;
    const flexel_point *from = &s->now;
    flexel_ranges_accept(s);
    copy(to->x, from->x, w->n);
    copy(to->v, from->v, w->n);
    copy(to->a, from->a, w->n);
    copy(to->w, from->w, w->n);
    copy(to->mu, from->mu, s->balance->nforce);
    copy(to->e, from->e, w->m);
    copy(to->z, from->z, w->nz);
    copy(to->zd, from->zd, w->nz);
    copy(to->zw, from->zw, w->nz);
}
