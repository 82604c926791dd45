/* Rotations from the start of a step; see turns.h. */
#include "turns.h"
#include "quaternion.h"
#include "rotations.h"

#include <math.h>
#include <string.h>

static const double SERIES = 0.1; /* angle [rad] below which a series has fewer rounding errors; its next term is 2e-16 */
static const double LEAST = 0.2;  /* of the Euler parameter that is not in y, at the end of a step ... */
static const double FEWEST = 0.2; /* ... but steps may turn by this angle [rad] */

/* Three numbers of frame i in y, or in the rates behind the degrees of freedom. */
static void gather(const flexel_turns *r, size_t i, const double *y, double *a)
{
    for (size_t k = 0; k < 3; k++)
        a[k] = y[r->dof[3 * i + k]];
}

static void scatter(const flexel_turns *r, size_t i, const double *a, double *y)
{
    for (size_t k = 0; k < 3; k++)
        y[r->dof[3 * i + k]] = a[k];
}

/* The same along the axes of the frame, whose Euler parameters are L for what is along the axes of space. */
static void gather_in_frame(const flexel_turns *r, size_t i, const double *L, const double *y, double *a)
{
    double own[3];
    gather(r, i, y, own);
    if (r->space[i])
        flexel_to_frame(L, own, a);
    else
        memcpy(a, own, sizeof own);
}

static void scatter_from_frame(const flexel_turns *r, size_t i, const double *L, const double *a, double *y)
{
    double own[3];
    if (r->space[i]) {
        flexel_to_space(L, a, own);
        scatter(r, i, own, y);
    } else
        scatter(r, i, a, y);
}

/* The Euler parameters of frame i. */
static void orientation(const flexel_turns *r, size_t i, const double *variables, double *L)
{
    const double *start = r->start + 4 * i;
    double p[3];
    gather_in_frame(r, i, start, variables, p);
    flexel_turn(start, p, L);
}

void flexel_turns_begin(const flexel_turns *r, const double *x, const double *v, double *y)
{
    for (size_t i = 0; i < r->count; i++) {
        double *L = r->start + 4 * i, *L1 = r->first + 4 * i, rates[4], w[3];
        for (size_t k = 0; k < 4; k++) {
            L[k] = x[r->at[4 * i + k]];
            rates[k] = v[r->at[4 * i + k]];
        }
        FLEXEL_SPIN(w, L, rates);
        scatter(r, i, (const double[]){0, 0, 0}, y);
        scatter_from_frame(r, i, L, w, y + r->nq);
        if (L1[0] == 0 && flexel_length(L1 + 1) == 0)
            memcpy(L1, L, 4 * sizeof(double));
    }
}

void flexel_turns_place(const flexel_turns *r, const double *variables, double *y, double *L)
{
    for (size_t i = 0; i < r->count; i++, L += 4) {
        double w[3], rates[4];
        orientation(r, i, variables, L);
        gather_in_frame(r, i, L, variables + r->nq, w);
        FLEXEL_TURN(rates, L, w);
        for (size_t k = 0; k < 3; k++) {
            y[r->dof[3 * i + k]] = L[r->part[3 * i + k]];
            y[r->nq + (size_t)r->dof[3 * i + k]] = rates[r->part[3 * i + k]];
        }
    }
}

/* Rates of a rotation vector; along the axes of the frame with sign = 1, of space with -1. */
static void rates_of_vector(double sign, const double *p, const double *w, double *rates)
{
    const double square = flexel_product(p, p), half = sqrt(square) / 2;
    const double third = half < SERIES / 2 ? (1 + square * (1 + square * (1 + square / 40) / 42) / 60) / 12
                                           : (1 - half / tan(half)) / square;
    double once[3], twice[3];
    flexel_cross(p, w, once);
    flexel_cross(p, once, twice);
    for (size_t k = 0; k < 3; k++)
        rates[k] = w[k] + sign * once[k] / 2 + third * twice[k];
}

void flexel_turns_rates(const flexel_turns *r, const flexel_work *s, const double *variables, double *f)
{
    for (size_t i = 0; i < r->count; i++) {
        const int *at = r->at + 4 * i;
        const double L[4] = {s->x[at[0]], s->x[at[1]], s->x[at[2]], s->x[at[3]]};
        const double second[4] = {s->a[at[0]], s->a[at[1]], s->a[at[2]], s->a[at[3]]};
        double p[3], w[3], rates[3];
        gather(r, i, variables, p);
        gather(r, i, variables + r->nq, w);
        rates_of_vector(r->space[i] ? -1 : 1, p, w, rates);
        scatter(r, i, rates, f);
        FLEXEL_SPIN(rates, L, second);
        scatter_from_frame(r, i, L, rates, f + r->nq);
    }
}

void flexel_turns_sizes(const flexel_turns *r, const double *variables, double *size)
{
    for (size_t i = 0; i < r->count; i++) {
        double p[3], w[3], L[4];
        gather(r, i, variables + r->nq, w);
        orientation(r, i, variables, L);
        flexel_turn_between(r->first + 4 * i, L, p);
        const double turned = 2 * sin(flexel_length(p) / 2), speed = flexel_length(w);
        scatter(r, i, (const double[]){turned, turned, turned}, size);
        scatter(r, i, (const double[]){speed, speed, speed}, size + r->nq);
    }
}

void flexel_turns_guess(const flexel_turns *r, const double *last, double *Z)
{
    const double none[4] = {1, 0, 0, 0};
    for (size_t i = 0; i < r->count; i++) {
        const double sign = r->space[i] ? -1 : 1; /* R R1^T in space is that of the reverse rotations in a frame */
        double p[3], q[3], end[4], later[4];
        gather(r, i, last, p);
        gather(r, i, Z, q);
        for (size_t k = 0; k < 3; k++) {
            p[k] *= sign;
            q[k] = p[k] + sign * q[k];
        }
        flexel_turn(none, p, end);
        flexel_turn(none, q, later);
        flexel_turn_between(end, later, p);
        scatter(r, i, (const double[]){sign * p[0], sign * p[1], sign * p[2]}, Z);
    }
}

void flexel_turns_accept(const flexel_turns *r, double *variables, double *rates)
{
    for (size_t i = 0; i < r->count; i++) {
        double p[3], L[4];
        orientation(r, i, variables, L);
        memcpy(r->start + 4 * i, L, sizeof L);
        scatter(r, i, (const double[]){0, 0, 0}, variables);
        gather(r, i, variables + r->nq, p);
        scatter(r, i, p, rates);
    }
}

void flexel_turns_look(const flexel_turns *r, const double *variables)
{
    memcpy(r->seen, r->start, 4 * r->count * sizeof(double));
    for (size_t i = 0; i < r->count; i++)
        gather(r, i, variables + r->nq, r->spin + 3 * i);
}

double flexel_turns_longest(const flexel_turns *r, const double *variables, double angle)
{
    double longest = INFINITY;
    for (size_t i = 0; i < r->count; i++) {
        const double *L = r->start + 4 * i;
        double w[3], rates[4];
        gather_in_frame(r, i, L, variables + r->nq, w);
        const double speed = flexel_length(w);
        if (!(speed > 0))
            continue;
        FLEXEL_TURN(rates, L, w);
        /* along a steady rotation the other parameter is size cos(speed t / 2 + phase) */
        const double sign = L[r->rest[i]] < 0 ? -1 : 1, value = sign * L[r->rest[i]];
        const double slope = sign * rates[r->rest[i]] * 2 / speed, size = hypot(value, slope);
        const double left = value > LEAST ? 2 * (acos(LEAST / size) - atan2(-slope, value)) : angle;
        longest = fmin(longest, fmin(angle, fmax(left, FEWEST)) / speed);
    }
    return longest;
}

int flexel_turns_far(const flexel_turns *r, const double *variables)
{
    const double half = acos(-1);
    for (size_t i = 0; i < r->count; i++) {
        double p[3];
        gather(r, i, variables, p);
        if (!(flexel_length(p) < half))
            return 1;
    }
    return 0;
}

/* c + (a x d - s d) / (s^2 + a . a) with d = a x c: this is s (s 1 + a x)^-1 c, for the parts c (2, 3) of complex numbers */
static void correct(const double *s, const double *a, double c[2][3])
{
    const double re = s[0] * s[0] - s[1] * s[1] + flexel_product(a, a), im = 2 * s[0] * s[1], size = re * re + im * im;
    double d[2][3], twice[2][3];
    for (size_t part = 0; part < 2; part++) {
        flexel_cross(a, c[part], d[part]);
        flexel_cross(a, d[part], twice[part]);
    }
    for (size_t k = 0; k < 3; k++) {
        const double x = twice[0][k] - s[0] * d[0][k] + s[1] * d[1][k], y = twice[1][k] - s[0] * d[1][k] - s[1] * d[0][k];
        c[0][k] += (x * re + y * im) / size;
        c[1][k] += (y * re - x * im) / size;
    }
}

void flexel_turns_divide(const flexel_turns *r, const double *shift, double sign, size_t nd, size_t numbers, double *b)
{
    const double s[2] = {shift[0], numbers == 2 ? shift[1] : 0}, size = s[0] * s[0] + s[1] * s[1];
    const double inverse[2] = {s[0] / size, -s[1] / size};
    for (size_t j = 0; j < nd * numbers; j += numbers) {
        const double x = b[j], y = numbers == 2 ? b[j + 1] : 0;
        b[j] = x * inverse[0] - y * inverse[1];
        if (numbers == 2)
            b[j + 1] = x * inverse[1] + y * inverse[0];
    }
    for (size_t i = 0; i < r->count; i++) {
        const double *w = r->spin + 3 * i, factor = r->space[i] ? -sign / 2 : sign / 2;
        const double half[3] = {factor * w[0], factor * w[1], factor * w[2]};
        double parts[2][3] = {{0, 0, 0}, {0, 0, 0}};
        for (size_t k = 0; k < 3; k++)
            for (size_t part = 0; part < numbers; part++)
                parts[part][k] = b[(size_t)r->dof[3 * i + k] * numbers + part];
        correct(s, half, parts);
        for (size_t k = 0; k < 3; k++)
            for (size_t part = 0; part < numbers; part++)
                b[(size_t)r->dof[3 * i + k] * numbers + part] = parts[part][k];
    }
}
