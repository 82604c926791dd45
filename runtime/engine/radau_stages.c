/* The stages of one step of Radau IIA, and the linear systems for them; see radau.h. */
#include "radau.h"
#include "table.h"

#include <math.h>
#include <string.h>

/* Column of u that is the rate of q_d number i. */
static size_t rate_column(const flexel_radau *o, size_t i)
{
    return o->nk + i;
}

/* The matrix shift 1 - J without q_d, by columns, for a real shift or a complex one. */
static void fill(const flexel_radau *o, const double *shift, size_t numbers, double *matrix)
{
    const size_t n = o->size, nd = o->nd;
    double *by_rates = o->divided;
    memset(matrix, 0, n * n * numbers * sizeof(double));
    for (size_t i = 0; i < n; i++) {
        const double *row = o->J + (nd + i) * o->ny;
        for (size_t j = 0; j < n; j++)
            matrix[(j * n + i) * numbers] = -row[nd + j];
        memset(by_rates, 0, nd * numbers * sizeof(double));
        for (size_t j = 0; j < nd; j++)
            by_rates[j * numbers] = row[j];
        flexel_turns_divide(o->turns, shift, -1, nd, numbers, by_rates);
        for (size_t j = 0; j < nd; j++)
            for (size_t part = 0; part < numbers; part++)
                matrix[(rate_column(o, j) * n + i) * numbers + part] -= by_rates[j * numbers + part];
        for (size_t part = 0; part < numbers; part++)
            matrix[(i * n + i) * numbers + part] += shift[part];
    }
}

static int are_finite(size_t n, const double *values)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(values[i]))
            return 0;
    return 1;
}

int flexel_radau_factorize(flexel_radau *o, double h)
{
    int n = (int)o->size, info = 0;
    if (!n)
        return 0;
    const double shift = o->mu / h, pair[2] = {o->pair[0] / h, o->pair[1] / h};
    if (o->saddle)
        return flexel_radau_saddle_factorize(o->saddle, shift, pair);
    fill(o, &shift, 1, o->real_factors);
    o->real_factorize(&n, &n, o->real_factors, &n, o->real_pivots, &info);
    if (info || !are_finite(o->size * o->size, o->real_factors))
        return 1;
    fill(o, pair, 2, o->complex_factors);
    o->complex_factorize(&n, &n, o->complex_factors, &n, o->complex_pivots, &info);
    return info || !are_finite(2 * o->size * o->size, o->complex_factors);
}

/* b = A^-1 b for factors by columns; row interchanges are counted from one. */
static void substitute(size_t n, const double *factors, const int *pivots, double *b)
{
    for (size_t i = 0; i < n; i++) {
        const size_t p = (size_t)pivots[i] - 1;
        const double kept = b[i];
        b[i] = b[p];
        b[p] = kept;
    }
    for (size_t j = 0; j < n; j++) {
        const double *restrict column = factors + j * n, x = b[j];
        for (size_t i = j + 1; i < n; i++)
            b[i] -= column[i] * x;
    }
    for (size_t j = n; j-- > 0;) {
        const double *restrict column = factors + j * n, x = b[j] /= column[j];
        for (size_t i = 0; i < j; i++)
            b[i] -= column[i] * x;
    }
}

/* b -= a x for complex numbers, from number `first` to number `end` */
static void subtract(size_t first, size_t end, const double *restrict a, double re, double im, double *restrict b)
{
    for (size_t i = first; i < end; i++) {
        b[2 * i] -= a[2 * i] * re - a[2 * i + 1] * im;
        b[2 * i + 1] -= a[2 * i] * im + a[2 * i + 1] * re;
    }
}

static void substitute_complex(size_t n, const double *factors, const int *pivots, double *b)
{
    for (size_t i = 0; i < n; i++) {
        const size_t p = (size_t)pivots[i] - 1;
        for (size_t part = 0; part < 2; part++) {
            const double kept = b[2 * i + part];
            b[2 * i + part] = b[2 * p + part];
            b[2 * p + part] = kept;
        }
    }
    for (size_t j = 0; j < n; j++)
        subtract(j + 1, n, factors + 2 * j * n, b[2 * j], b[2 * j + 1], b);
    for (size_t j = n; j-- > 0;) {
        const double *column = factors + 2 * j * n, re = column[2 * j], im = column[2 * j + 1];
        const double size = re * re + im * im, x = b[2 * j], y = b[2 * j + 1];
        b[2 * j] = (x * re + y * im) / size;
        b[2 * j + 1] = (y * re - x * im) / size;
        subtract(0, j, column, b[2 * j], b[2 * j + 1], b);
    }
}

void flexel_radau_solve(const flexel_radau *o, double h, double *b)
{
    const size_t nd = o->nd;
    const double shift = o->mu / h;
    double *u = b + nd, *divided = o->divided;
    if (o->saddle) {
        flexel_radau_saddle_solve(o->saddle, shift, b);
        return;
    }
    memcpy(divided, b, nd * sizeof(double));
    flexel_turns_divide(o->turns, &shift, 1, nd, 1, divided);
    for (size_t i = 0; i < o->size; i++) {
        const double *row = o->J + (nd + i) * o->ny;
        double sum = 0;
        for (size_t j = 0; j < nd; j++)
            sum += row[j] * divided[j];
        u[i] += sum;
    }
    substitute(o->size, o->real_factors, o->real_pivots, u);
    for (size_t j = 0; j < nd; j++)
        b[j] += u[rate_column(o, j)];
    flexel_turns_divide(o->turns, &shift, 1, nd, 1, b);
}

/* The same for the complex eigenvalue, with pairs of numbers. */
static void solve_complex(const flexel_radau *o, double h, double *b)
{
    const size_t nd = o->nd;
    const double pair[2] = {o->pair[0] / h, o->pair[1] / h};
    double *u = b + 2 * nd, *divided = o->divided;
    if (o->saddle) {
        flexel_radau_saddle_solve_pair(o->saddle, pair, b);
        return;
    }
    memcpy(divided, b, 2 * nd * sizeof(double));
    flexel_turns_divide(o->turns, pair, 1, nd, 2, divided);
    for (size_t i = 0; i < o->size; i++) {
        const double *row = o->J + (nd + i) * o->ny;
        double sum[2] = {0, 0};
        for (size_t j = 0; j < nd; j++) {
            sum[0] += row[j] * divided[2 * j];
            sum[1] += row[j] * divided[2 * j + 1];
        }
        u[2 * i] += sum[0];
        u[2 * i + 1] += sum[1];
    }
    substitute_complex(o->size, o->complex_factors, o->complex_pivots, u);
    for (size_t j = 0; j < nd; j++) {
        const double *rate = u + 2 * rate_column(o, j);
        b[2 * j] += rate[0];
        b[2 * j + 1] += rate[1];
    }
    flexel_turns_divide(o->turns, pair, 1, nd, 2, b);
}

/* to = matrix from, for three rows */
static void transform(size_t n, const double *matrix, const double *from, double *to)
{
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < n; i++)
            to[k * n + i] =
                matrix[3 * k] * from[i] + matrix[3 * k + 1] * from[n + i] + matrix[3 * k + 2] * from[2 * n + i];
}

int flexel_radau_rates(flexel_work *s, flexel_choice *c, flexel_radau *o, size_t k, double h, const double *Z, double *f)
{
    const double *given = o->given + k * o->ngiven;
    memcpy(c->motion, given, 3 * c->np * sizeof(double));
    memcpy(c->loads, given + 3 * c->np, c->nloads * sizeof(double));
    double *variables = o->space;
    const double passed = k < 3 ? o->C[k] * h : 0;
    for (size_t i = 0; i < o->ny; i++)
        o->placed[i] = variables[i] = o->y[i] + Z[i];
    flexel_turns_place(o->turns, variables, o->placed, o->known);
    flexel_angles_place(o->angles, passed, variables, o->placed, o->known + 4 * o->turns->count);
    o->evaluations++;
    const int failed = flexel_rhs(s, c, o->t + passed, o->placed, f);
    if (!failed) {
        flexel_turns_rates(o->turns, s, variables, f);
        flexel_angles_rates(o->angles, variables, f);
    }
    return failed;
}

static int all_rates(flexel_work *s, flexel_choice *c, flexel_radau *o, double h)
{
    for (size_t k = 0; k < 3; k++) {
        const int failed = flexel_radau_rates(s, c, o, k, h, o->Z + k * o->ny, o->F + k * o->ny);
        if (failed)
            return failed;
        memcpy(o->V + k * s->nf, s->v, s->nf * sizeof(double));
        flexel_account_stage(o->account, s, c, k);
    }
    return FLEXEL_DONE;
}

/* One iteration from the rates F: W and Z are moved. The size of the change, relative to what is allowed. */
static double iterate(flexel_radau *o, double h)
{
    const size_t n = o->ny;
    const double mu = o->mu / h, re = o->pair[0] / h, im = o->pair[1] / h;
    double *dW = o->space, *complex_part = dW + n, sum = 0;
    for (size_t i = 0; i < n; i++) {
        double f[3];
        for (size_t k = 0; k < 3; k++)
            f[k] = o->inverse[3 * k] * o->F[i] + o->inverse[3 * k + 1] * o->F[n + i] +
                   o->inverse[3 * k + 2] * o->F[2 * n + i];
        const double first = o->W[n + i], second = o->W[2 * n + i];
        dW[i] = f[0] - mu * o->W[i];
        complex_part[2 * i] = f[1] - (re * first - im * second);
        complex_part[2 * i + 1] = f[2] - (re * second + im * first);
    }
    flexel_radau_solve(o, h, dW);
    solve_complex(o, h, complex_part);
    for (size_t i = 0; i < n; i++) {
        const double step[3] = {dW[i], complex_part[2 * i], complex_part[2 * i + 1]};
        for (size_t k = 0; k < 3; k++) {
            o->W[k * n + i] += step[k];
            sum += step[k] / o->scale[i] * (step[k] / o->scale[i]);
        }
    }
    transform(n, o->T, o->W, o->Z);
    return sqrt(sum / (3 * (double)n));
}

/* Change, relative to what is allowed, at which an iteration may end by rounding errors: it changes no digit that counts. */
static const double NOISE = 0.03;
/* Rounding error of a position, in natural scales; and the most that it may be, as a change relative to what is allowed. */
static const double ROUNDING = 2e-15, MOST = 0.3;

/* Rounding errors of positions and the change of rates by them, divided by the step, relative to what is allowed. */
static double noise(const flexel_radau *o, double h)
{
    const size_t first = o->nd + o->nk;
    double sum = 0;
    for (size_t i = 0; i < first + o->nd; i++) {
        const double part = ROUNDING * o->natural[i] / ((i < first ? 1 : h) * o->scale[i]);
        sum += part * part;
    }
    return fmin(MOST, sqrt(sum / (double)o->ny));
}

/* Whether the iteration goes on after a change of some size, relative to what is allowed; `before` is that of the last one.
 * It converges after two iterations at the earliest: with a rate that an earlier step has shown, one is too uncertain. */
static int goes_on(flexel_radau *o, double h, double size, double before)
{
    if (!isfinite(size))
        return 0;
    if (size == 0 || (o->iterations > 1 && size >= before)) {
        o->converged = size <= NOISE;
        return 0;
    }
    if (o->iterations == 1)
        return 1;
    o->rate = size / before;
    const double rest = size / (1 - o->rate), more = (double)(FLEXEL_RADAU_ITERATIONS - o->iterations);
    o->converged = o->rate * rest < o->tolerance || size < noise(o, h);
    return !o->converged && pow(o->rate, more) * rest <= o->tolerance;
}

int flexel_radau_stages(flexel_work *s, flexel_choice *c, flexel_radau *o, double h)
{
    double size = 0, before;
    transform(o->ny, o->inverse, o->Z, o->W);
    o->converged = 0;
    o->rate = 0;
    o->iterations = 0;
    do {
        const int failed = all_rates(s, c, o, h);
        if (failed)
            return failed;
        if (o->iterations == 0)
            flexel_radau_allow(s, c, o, o->Z + 2 * o->ny);
        before = size;
        size = iterate(o, h);
        o->iterations++;
    } while (goes_on(o, h, size, before) && o->iterations < FLEXEL_RADAU_ITERATIONS);
    return FLEXEL_DONE;
}
