/* Angles from the start of a step; see angles.h. */
#include "angles.h"
#include "quaternion.h"
#include "rotations.h"

#include <math.h>
#include <string.h>

static const double LEAST_SLOPE = 0.1; /* b below which the variables have q itself */
static const double ROTATION = 2;      /* [rad] that count as a whole rotation: Euler parameters then change by one */
static const double LEAST = 0.2;       /* slope of q at the end of a step, relative to the largest */
static const double FEWEST = 0.2;      /* angle [rad] of a step that is always allowed */

static double start(const flexel_angles *r, size_t i)
{
    return r->start[4 * i + (size_t)r->part[i]];
}

/* q and its derivative by the angle, for those of angle zero and twice its derivative. */
static void at_angle(double a, double b, double angle, double *q, double *slope)
{
    const double c = cos(angle / 2), s = sin(angle / 2);
    *q = a * c + b * s;
    *slope = (b * c - a * s) / 2;
}

void flexel_angles_leave(const flexel_angles *r, const double *x)
{
    for (size_t i = 0; i < r->count; i++) {
        r->slope[i] = 0;
        memset(r->others + 3 * i, 0, 3 * sizeof(double));
        memset(r->before + 4 * i, 0, 4 * sizeof(double));
        for (size_t k = 0; k < 4; k++)
            r->start[4 * i + k] = x[r->at[4 * i + k]];
    }
}

/* The axis about which the frame turns with unit rates of q alone; the same side as before. */
static void look_for_axis(const flexel_angles *r, size_t i, flexel_work *s, flexel_choice *c)
{
    const size_t held = c->nr + c->np;
    const int *at = r->at + 4 * i;
    double *L = r->start + 4 * i, *axis = r->axis + 3 * i, rates[4], w[3], moved[4], v[4];
    memset(c->residual, 0, s->nf * sizeof(double));
    c->residual[held + (size_t)r->dof[i]] = 1;
    flexel_matrix_solve(&c->P, 1, c->residual, c->step, c->work);
    for (size_t k = 0; k < 4; k++) {
        L[k] = s->x[at[k]];
        rates[k] = c->step[at[k]];
        v[k] = s->v[at[k]];
    }
    FLEXEL_SPIN(w, L, rates);
    const double size = flexel_length(w), sign = flexel_product(w, axis) < 0 ? -1 : 1;
    const double share = size > 0 && isfinite(size) ? sign / size : 0;
    for (size_t k = 0; k < 3; k++)
        axis[k] = share * w[k];
    FLEXEL_TURN(moved, L, axis);
    r->slope[i] = 2 * moved[r->part[i]];
    if (!(fabs(r->slope[i]) > LEAST_SLOPE))
        r->slope[i] = 0;
    FLEXEL_SPIN(w, L, v);
    const double speed = r->slope[i] == 0 ? 0 : 2 * v[r->part[i]] / r->slope[i];
    for (size_t k = 0; k < 3; k++)
        r->others[3 * i + k] = w[k] - speed * axis[k];
}

void flexel_angles_begin(const flexel_angles *r, flexel_work *s, flexel_choice *c, double *y, double *f)
{
    for (size_t i = 0; i < r->count; i++) {
        double *value = y + r->dof[i], *rate = value + r->nq;
        look_for_axis(r, i, s, c);
        if (r->slope[i] == 0)
            continue;
        *value = 0;
        *rate *= 2 / r->slope[i];
    }
    flexel_angles_rates(r, y, f);
}

void flexel_angles_place(const flexel_angles *r, double passed, const double *variables, double *y, double *L)
{
    for (size_t i = 0; i < r->count; i++) {
        const double angle = r->slope[i] == 0 ? 0 : variables[r->dof[i]];
        double p[3], slope;
        for (size_t k = 0; k < 3; k++)
            p[k] = angle * r->axis[3 * i + k] + passed * r->others[3 * i + k];
        flexel_turn(r->start + 4 * i, p, L + 4 * i);
        if (r->slope[i] == 0)
            continue;
        at_angle(start(r, i), r->slope[i], angle, y + r->dof[i], &slope);
        y[r->nq + (size_t)r->dof[i]] = slope * variables[r->nq + (size_t)r->dof[i]];
    }
}

void flexel_angles_rates(const flexel_angles *r, const double *variables, double *f)
{
    for (size_t i = 0; i < r->count; i++) {
        const double rate = variables[r->nq + (size_t)r->dof[i]];
        double *second = f + r->nq + r->dof[i], q, slope;
        if (r->slope[i] == 0)
            continue;
        at_angle(start(r, i), r->slope[i], variables[r->dof[i]], &q, &slope);
        f[r->dof[i]] = rate;
        *second = (*second + q * rate * rate / 4) / slope;
    }
}

void flexel_angles_sizes(const flexel_angles *r, const double *variables, double *size)
{
    for (size_t i = 0; i < r->count; i++)
        if (r->slope[i] != 0)
            size[r->dof[i]] = fmin(fabs(r->passed[i] + variables[r->dof[i]]), ROTATION);
}

void flexel_angles_guess(const flexel_angles *r, const double *variables, double *Z)
{
    for (size_t i = 0; i < r->count; i++) {
        const double *before = r->before + 4 * i, a = start(r, i), b = r->slope[i], size = hypot(a, b);
        double *value = Z + r->dof[i], *rate = value + r->nq, q, slope;
        at_angle(before[0], before[1], before[2] + *value, &q, &slope);
        if (before[1] == 0 || b == 0 || !(fabs(q) < size))
            continue; /* turned as far from another start */
        const double moved = slope * (before[3] + *rate), sign = b < 0 ? -1 : 1;
        *value = 2 * (asin(sign * q / size) - atan2(sign * a, fabs(b)));
        at_angle(a, b, *value, &q, &slope);
        *rate = moved / slope - variables[r->nq + (size_t)r->dof[i]];
    }
}

void flexel_angles_accept(const flexel_angles *r, flexel_work *s, flexel_choice *c, double *variables, double *rates)
{
    for (size_t i = 0; i < r->count; i++) {
        double *value = variables + r->dof[i], *rate = value + r->nq, q, slope;
        if (r->slope[i] != 0) {
            at_angle(start(r, i), r->slope[i], *value, &q, &slope);
            memcpy(r->before + 4 * i, (const double[]){start(r, i), r->slope[i], *value, *rate}, 4 * sizeof(double));
            r->passed[i] += *value;
            *rate *= slope;
        } else {
            r->before[4 * i + 1] = 0;
        }
        *value = s->x[r->at[4 * i + (size_t)r->part[i]]];
        rates[r->dof[i]] = *rate;
        rates[r->nq + (size_t)r->dof[i]] = s->a[r->at[4 * i + (size_t)r->part[i]]];
    }
    flexel_angles_begin(r, s, c, variables, rates);
}

void flexel_angles_look(const flexel_angles *r)
{
    memcpy(r->seen, r->slope, r->count * sizeof(double));
}

double flexel_angles_longest(const flexel_angles *r, const double *variables, double angle)
{
    double longest = INFINITY;
    for (size_t i = 0; i < r->count; i++) {
        const double speed = variables[r->nq + (size_t)r->dof[i]], b = r->slope[i];
        if (b == 0 || speed == 0)
            continue;
        /* the slope is its largest value times cos(speed t / 2 + phase) */
        const double q = start(r, i), phase = atan2((b < 0) == (speed < 0) ? q : -q, fabs(b));
        longest = fmin(longest, fmin(angle, fmax(2 * (acos(LEAST) - phase), FEWEST)) / fabs(speed));
    }
    return longest;
}

int flexel_angles_far(const flexel_angles *r, const double *variables)
{
    for (size_t i = 0; i < r->count; i++) {
        double q, slope;
        at_angle(start(r, i), r->slope[i], variables[r->dof[i]], &q, &slope);
        if (r->slope[i] != 0 && !(slope * r->slope[i] > 0))
            return 1;
    }
    return 0;
}
