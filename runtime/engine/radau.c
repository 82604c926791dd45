/* The stages of one step of Radau IIA; see radau.h. */
#include "radau.h"
#include "table.h"

#include <math.h>
#include <string.h>

void flexel_radau_solve(size_t n, const double *factors, const int *pivots, double *b)
{
    for (size_t i = 0; i < n; i++) {
        const size_t p = (size_t)pivots[i];
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

void flexel_radau_solve_complex(size_t n, const double *factors, const int *pivots, double *b)
{
    for (size_t i = 0; i < n; i++) {
        const size_t p = (size_t)pivots[i];
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

/* to = matrix from, for three rows */
static void transform(size_t n, const double *matrix, const double *from, double *to)
{
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < n; i++)
            to[k * n + i] =
                matrix[3 * k] * from[i] + matrix[3 * k + 1] * from[n + i] + matrix[3 * k + 2] * from[2 * n + i];
}

/* Rates F at the stages. */
static int rates(flexel_work *s, flexel_choice *c, flexel_radau *o, double t, double h)
{
    for (size_t k = 0; k < 3; k++) {
        const double *given = o->given + k * o->ngiven;
        memcpy(c->motion, given, 3 * c->np * sizeof(double));
        memcpy(c->loads, given + 3 * c->np, c->nloads * sizeof(double));
        for (size_t i = 0; i < o->ny; i++)
            o->space[i] = o->y[i] + o->Z[k * o->ny + i];
        o->evaluations++;
        const int failed = flexel_rhs(s, c, t + o->C[k] * h, o->space, o->F + k * o->ny);
        if (failed)
            return failed;
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
    flexel_radau_solve(n, o->real_factors, o->real_pivots, dW);
    flexel_radau_solve_complex(n, o->complex_factors, o->complex_pivots, complex_part);
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

int flexel_radau_step(flexel_work *s, flexel_choice *c, flexel_radau *o, double t, double h)
{
    double size = 0, before;
    transform(o->ny, o->inverse, o->Z, o->W);
    o->converged = 0;
    o->rate = 0;
    o->iterations = 0;
    do {
        const int failed = rates(s, c, o, t, h);
        if (failed)
            return failed;
        before = size;
        size = iterate(o, h);
        o->iterations++;
    } while (goes_on(o, size, before) && o->iterations < FLEXEL_RADAU_ITERATIONS);
    return FLEXEL_DONE;
}
