/* Local errors of a step of the generalized-alpha method, over the ranges of coordinates and states in their motion.
 *
 * Source: Zienkiewicz and Xie (1991) for coordinates. */
#include "implicit.h"

#include <math.h>
#include <string.h>

/* How far a value has moved in the motion, the end of the step included. */
static double range_of(double low, double high, double value)
{
    return (value > high ? value : high) - (value < low ? value : low);
}

/* Size of the motion: the largest range of a free coordinate, in natural scales, at most 1, as turns have no end.
 *
 * A motion that begins has no range yet. Its step shows a frequency, f^2 = |change of acceleration| / |change of place|,
 * and a vibration with it has the amplitudes |velocity| / f and |acceleration| / f^2. */
static double moved(const flexel_step *s)
{
    const flexel_ranges *r = &s->ranges;
    const flexel_point *p = &s->old, *q = &s->now;
    double found = 0, v = 0, w = 0, dx = 0, dw = 0;
    for (size_t i = 0; i < s->balance->work->nf; i++) {
        const double unit = 1 / s->x_scale[i];
        found = flexel_larger(found, range_of(r->x_low[i], r->x_high[i], q->x[i]) * unit);
        v = flexel_larger(v, fabs(p->v[i]) * unit);
        w = flexel_larger(w, fabs(p->w[i]) * unit);
        dx = flexel_larger(dx, fabs(q->x[i] - p->x[i]) * unit);
        dw = flexel_larger(dw, fabs(q->w[i] - p->w[i]) * unit);
    }
    if (dw > 0)
        found = flexel_larger(found, flexel_larger(v * sqrt(dx / dw), w * dx / dw));
    return flexel_larger(found < 1 ? found : 1, r->least);
}

static double coordinates_error(flexel_step *s)
{
    const double factor = fabs(s->beta - 1.0 / 6) * s->h * s->h;
    double largest = 0;
    s->local_size = 0;
    for (size_t i = 0; i < s->balance->work->nf; i++) {
        const double error = factor * fabs(s->now.w[i] - s->old.w[i]);
        s->local_size = flexel_larger(s->local_size, error);
        largest = flexel_larger(largest, error / s->x_scale[i]);
    }
    return largest / moved(s);
}

/* Local error of the internal states, c h^3 z''', by divided differences of the rates at the last three points.
 *
 * A rate that jumps, as that of a bristle which begins to slide, gives a large second difference in the step after the
 * jump too. The change within a step is therefore its bound. States of the same law share a range: a contact that begins
 * has not moved yet. */
static double states_error(flexel_step *s)
{
    const flexel_ranges *r = &s->ranges;
    const size_t nz = s->balance->work->nz;
    const double delta = s->lag_m - s->alpha_f, h = s->h, before = r->h_before;
    const double c =
        fabs(1.0 / 6 - s->lag_gamma / 2 - s->lag_gamma * delta - delta * (s->lag_m - 0.5)) * h;
    memset(r->group_range, 0, r->groups * sizeof(double));
    for (size_t i = 0; i < nz; i++) {
        double *range = r->group_range + r->group[i];
        *range = flexel_larger(*range, range_of(r->z_low[i], r->z_high[i], s->now.z[i]));
    }
    double largest = 0;
    for (size_t i = 0; i < nz; i++) {
        const double change = s->now.zd[i] - s->old.zd[i], range = r->group_range[r->group[i]];
        double bend = fabs(change);
        if (before > 0) {
            const double slope = (s->old.zd[i] - r->zd_before[i]) / before;
            bend = fmin(bend, fabs(change - slope * h) * 2 * h / (h + before));
        }
        largest = flexel_larger(largest, range > 0 ? c * bend / range : 0.0);
    }
    return largest;
}

void flexel_local_errors(flexel_step *s)
{
    s->local_error = coordinates_error(s);
    s->state_error = s->balance->work->nz ? states_error(s) : 0.0;
}

/* Widen the ranges of a motion by a point. */
static void widen(double *low, double *high, const double *value, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        low[i] = value[i] < low[i] ? value[i] : low[i];
        high[i] = value[i] > high[i] ? value[i] : high[i];
    }
}

void flexel_ranges_accept(flexel_step *s)
{
    flexel_ranges *r = &s->ranges;
    const size_t nf = s->balance->work->nf, nz = s->balance->work->nz;
    widen(r->x_low, r->x_high, s->now.x, nf);
    widen(r->z_low, r->z_high, s->now.z, nz);
    memcpy(r->zd_before, s->old.zd, nz * sizeof(double));
    r->h_before = s->h;
}
