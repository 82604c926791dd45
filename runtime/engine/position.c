/* Position and velocities in minimal coordinates; see explicit.h. */
#include "explicit.h"

#include "dense.h"
#include "evaluate.h"
#include "rows.h"

#include <math.h>
#include <string.h>

static double value_of(const flexel_work *s, int quantity)
{
    return (size_t)quantity < s->m ? s->e[quantity] : s->x[(size_t)quantity - s->m - s->k];
}

/* Wanted values of the rows; periodic ones are compared with the nearest value of theirs. */
static void set_targets(flexel_work *s, flexel_choice *c)
{
    const size_t held = c->nr + c->np;
    for (size_t i = 0; i < s->nf; i++) {
        c->target[i] = i < c->nr ? 0 : i < held ? c->motion[i - c->nr] : c->q[i - held];
        if ((size_t)c->rows[i] < s->m)
            s->unwrap_from[c->rows[i]] = c->target[i];
    }
}

static double residuals(const flexel_work *s, flexel_choice *c)
{
    double error = 0;
    for (size_t i = 0; i < s->nf; i++) {
        c->residual[i] = value_of(s, c->rows[i]) - c->target[i];
        const double z = fabs(c->residual[i]) * c->weight[i];
        error = z <= error ? error : z; /* not a number is kept */
    }
    return error;
}

/* Whether rounding explains the residuals: of the values themselves, and of the coordinates, which are as large as the model is
 * far from its origin. */
static int rounded(const flexel_work *s, flexel_choice *c)
{
    const flexel_matrix *P = &c->P;
    double *explained = c->step;
    for (size_t i = 0; i < s->nf; i++)
        explained[i] = 1 / c->weight[i];
    for (size_t k = 0; k < P->nentries; k++)
        explained[P->rows[k]] += fabs(s->M[P->source[k]] * s->x[P->columns[k]]);
    int all = 1;
    for (size_t i = 0; i < s->nf; i++)
        all &= fabs(c->residual[i]) <= FLEXEL_OF_COORDINATES * explained[i];
    return all;
}

int flexel_factorize(flexel_work *s, flexel_choice *c)
{
    c->factorizations++;
    return flexel_matrix_factor(&c->P, s->M) ? FLEXEL_SINGULAR : FLEXEL_DONE;
}

int flexel_locate(flexel_work *s, flexel_choice *c)
{
    double last = INFINITY;
    int reusable = c->reusable; /* factors of P at a position close to this one */
    set_targets(s, c);
    for (size_t iteration = 0; iteration < FLEXEL_MOST_ITERATIONS; iteration++) {
        flexel_position(s);
        c->positions++;
        const double error = c->error = residuals(s, c);
        const int good = error < c->tolerance || (last < c->kept && error < FLEXEL_ROUNDING) ||
                         (error > 0.5 * last && (error < FLEXEL_STALLED || rounded(s, c)));
        if (!isfinite(error))
            return FLEXEL_UNREACHED;
        const int failed = !good && reusable && error < c->kept ? FLEXEL_DONE : flexel_factorize(s, c);
        if (failed || good)
            return failed;
        reusable = 0;
        flexel_matrix_solve(&c->P, 1, c->residual, c->step, c->work);
        double largest = 0;
        for (size_t i = 0; i < s->nf; i++) {
            const double z = fabs(c->step[i]) * c->step_weight[i]; /* fmax would be a call */
            largest = z > largest ? z : largest;
        }
        const double share = largest < FLEXEL_LONGEST_STEP ? 1 : FLEXEL_LONGEST_STEP / largest;
        for (size_t i = 0; i < s->nf; i++)
            s->x[i] -= share * c->step[i];
        if (error < c->accept && share == 1)
            return FLEXEL_DONE; /* the last correction is far below the accuracy asked for: J is kept */
        last = share == 1 ? error : INFINITY;
    }
    return FLEXEL_UNREACHED;
}

/* y -= z x, four columns at once */
static inline void subtract(size_t count, double z, const double *restrict x, double *restrict y)
{
    size_t j = 0;
    for (; j + 4 <= count; j += 4)
#pragma omp simd
        for (size_t i = 0; i < 4; i++)
            y[j + i] -= z * x[j + i];
    for (; j < count; j++)
        y[j] -= z * x[j];
}

/* Columns G = P^-1 [unit d | unit k | rates of what is given]; those of d and of what is given are completed to H, and to
 * velocities that roll, by columns of k: G_d + G_k T.
 *
 * With the saddle matrix the columns of the dynamic ones are not needed: their rates then belong to what is given. */
FLEXEL_CLONES
int flexel_directions(flexel_work *s, flexel_choice *c)
{
    const size_t nd = c->saddle ? 0 : c->nd, nk = c->nk, count = c->columns, held = c->nr + c->np, nf = s->nf;
    double *b = c->G;
    memset(b, 0, nf * count * sizeof(double));
    for (size_t i = 0; i < c->np; i++)
        b[(c->nr + i) * count + nd + nk] = c->motion[c->np + i];
    for (size_t i = 0; i < nd; i++)
        b[(held + i) * count + i] = 1;
    for (size_t i = 0; i < (c->saddle ? c->nd : 0); i++)
        b[(held + i) * count + nk] = c->qd[i];
    for (size_t i = 0; i < nk; i++)
        b[(held + c->nd + i) * count + nd + i] = 1;
    flexel_matrix_solve(&c->P, count, b, c->G, c->work);
    if (!nk)
        return FLEXEL_DONE;
    double *SG = c->small, *A = SG + nk * count;
    for (size_t i = 0; i < nk; i++) {
        flexel_row(s, c->slips[i], c->G, count, count, SG + i * count);
        for (size_t j = 0; j < nk; j++) {
            A[i * nk + j] = SG[i * count + nd + j];
            c->inverse[i * nk + j] = i == j;
        }
    }
    if (flexel_dense_solve(nk, nk, A, c->inverse))
        return FLEXEL_SLIDING;
    for (size_t k = 0; k < nk; k++) {
        double *T = A; /* row k of -(S G_k)^-1 S G, without the columns of k */
        memset(T, 0, count * sizeof(double));
        for (size_t i = 0; i < nk; i++)
            subtract(count, c->inverse[k * nk + i], SG + i * count, T);
        memset(T + nd, 0, nk * sizeof(double));
        for (size_t i = 0; i < nf; i++)
            subtract(count, -c->G[i * count + nd + k], T, c->G + i * count);
    }
    return FLEXEL_DONE;
}

int flexel_velocity(flexel_work *s, flexel_choice *c)
{
    const int failed = flexel_directions(s, c);
    const size_t nd = c->saddle ? 0 : c->nd, count = c->columns;
    if (failed)
        return failed;
    for (size_t i = 0; i < s->nf; i++) {
        double z = c->G[i * count + nd + c->nk];
        for (size_t j = 0; j < nd; j++)
            z += c->G[i * count + j] * c->qd[j];
        s->v[i] = z;
    }
    return FLEXEL_DONE;
}

void flexel_unit_rates(const flexel_work *s, const flexel_choice *c, size_t count, const int *rows, double *out)
{
    for (size_t i = 0; i < count; i++)
        flexel_row(s, rows[i], c->G, c->columns, c->nd, out + i * c->nd);
}

FLEXEL_CLONES
void flexel_rates_for(const flexel_work *s, const flexel_choice *c, size_t count, const double *b, double *x, double *work)
{
    const size_t held = c->nr + c->np, nk = c->nk, nd = c->nd, columns = c->columns, first = c->saddle ? 0 : nd;
    memcpy(x, b, held * count * sizeof(double));
    memcpy(x + held * count, b + (held + nk) * count, nd * count * sizeof(double));
    memset(x + (held + nd) * count, 0, nk * count * sizeof(double));
    flexel_matrix_solve(&c->P, count, x, x, work);
    double *missing = work, *w = work + nk * count;
    for (size_t i = 0; i < nk; i++) {
        flexel_row(s, c->slips[i], x, count, count, missing + i * count);
        for (size_t j = 0; j < count; j++)
            missing[i * count + j] -= b[(held + i) * count + j];
    }
    memset(w, 0, nk * count * sizeof(double));
    for (size_t i = 0; i < nk; i++)
        for (size_t k = 0; k < nk; k++)
            subtract(count, c->inverse[i * nk + k], missing + k * count, w + i * count);
    for (size_t i = 0; i < s->nf; i++)
        for (size_t k = 0; k < nk; k++)
            subtract(count, -c->G[i * columns + first + k], w + k * count, x + i * count);
}
