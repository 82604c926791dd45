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

/* The matrix shift 1 - J without q_d, by columns, for a real shift or a complex one (re + i im). */
static void fill(const flexel_radau *o, double re, double im, int numbers, double *matrix)
{
    const size_t n = o->size, nd = o->nd;
    const double size = re * re + im * im, inverse[2] = {re / size, -im / size};
    memset(matrix, 0, n * n * (size_t)numbers * sizeof(double));
    for (size_t i = 0; i < n; i++) {
        const double *row = o->J + (nd + i) * o->ny;
        for (size_t j = 0; j < n; j++)
            matrix[(j * n + i) * (size_t)numbers] = -row[nd + j];
        for (size_t j = 0; j < nd; j++)
            for (int part = 0; part < numbers; part++)
                matrix[(rate_column(o, j) * n + i) * (size_t)numbers + (size_t)part] -= row[j] * inverse[part];
        matrix[(i * n + i) * (size_t)numbers] += re;
        if (numbers == 2)
            matrix[(i * n + i) * 2 + 1] += im;
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
    fill(o, o->mu / h, 0, 1, o->real_factors);
    o->real_factorize(&n, &n, o->real_factors, &n, o->real_pivots, &info);
    if (info || !are_finite(o->size * o->size, o->real_factors))
        return 1;
    fill(o, o->pair[0] / h, o->pair[1] / h, 2, o->complex_factors);
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
    const double inverse = h / o->mu;
    double *u = b + nd;
    for (size_t i = 0; i < o->size; i++) {
        const double *row = o->J + (nd + i) * o->ny;
        double sum = 0;
        for (size_t j = 0; j < nd; j++)
            sum += row[j] * b[j];
        u[i] += sum * inverse;
    }
    substitute(o->size, o->real_factors, o->real_pivots, u);
    for (size_t j = 0; j < nd; j++)
        b[j] = (b[j] + u[rate_column(o, j)]) * inverse;
}

/* The same for the complex eigenvalue, with pairs of numbers. */
static void solve_complex(const flexel_radau *o, double h, double *b)
{
    const size_t nd = o->nd;
    const double size = o->pair[0] * o->pair[0] + o->pair[1] * o->pair[1];
    const double re = h * o->pair[0] / size, im = -h * o->pair[1] / size;
    double *u = b + 2 * nd;
    for (size_t i = 0; i < o->size; i++) {
        const double *row = o->J + (nd + i) * o->ny;
        double sum[2] = {0, 0};
        for (size_t j = 0; j < nd; j++) {
            sum[0] += row[j] * b[2 * j];
            sum[1] += row[j] * b[2 * j + 1];
        }
        u[2 * i] += sum[0] * re - sum[1] * im;
        u[2 * i + 1] += sum[0] * im + sum[1] * re;
    }
    substitute_complex(o->size, o->complex_factors, o->complex_pivots, u);
    for (size_t j = 0; j < nd; j++) {
        const double *rate = u + 2 * rate_column(o, j), x = b[2 * j] + rate[0], y = b[2 * j + 1] + rate[1];
        b[2 * j] = x * re - y * im;
        b[2 * j + 1] = x * im + y * re;
    }
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
    for (size_t i = 0; i < o->ny; i++)
        o->space[i] = o->y[i] + Z[i];
    o->evaluations++;
    return flexel_rhs(s, c, k < 3 ? o->t + o->C[k] * h : o->t, o->space, f);
}

static int all_rates(flexel_work *s, flexel_choice *c, flexel_radau *o, double h)
{
    for (size_t k = 0; k < 3; k++) {
        const int failed = flexel_radau_rates(s, c, o, k, h, o->Z + k * o->ny, o->F + k * o->ny);
        if (failed)
            return failed;
        memcpy(o->V + k * s->nf, s->v, s->nf * sizeof(double));
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

/* Whether the iteration goes on after a change of some size, relative to what is allowed; `before` is that of the last one.
 * It converges after two iterations at the earliest: with a rate that an earlier step has shown, one is too uncertain. */
static int goes_on(flexel_radau *o, double size, double before)
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
    o->converged = o->rate * rest < o->tolerance;
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
        before = size;
        size = iterate(o, h);
        o->iterations++;
    } while (goes_on(o, size, before) && o->iterations < FLEXEL_RADAU_ITERATIONS);
    return FLEXEL_DONE;
}
