/* Linearized equations of motion at states; see linear.h. */
#include "linear.h"

#include "copy.h"
#include "evaluate.h"
#include "rows.h"

#include <string.h>

/* Columns of the transfer functions, filled up to whole registers: p of values, r of rates. */
static size_t values_of(const flexel_choice *c)
{
    return (c->nd + c->nk + c->np + 3) / 4 * 4;
}

static size_t rates_of(const flexel_choice *c)
{
    return (c->nd + c->np + 3) / 4 * 4;
}

/* Numbers of a state, of its derivatives, and of its transfer functions. */
static size_t input_of(const flexel_work *s)
{
    return 1 + 3 * s->n + s->nz + s->m + s->m + s->k;
}

static size_t derivatives_of(const flexel_work *s, const flexel_linear *l)
{
    return 4 * (size_t)s->J_start[s->m + s->k + s->n] + (size_t)s->M_start[s->n] + 2 * s->nT + l->nlaws;
}

static size_t transfer_of(const flexel_work *s, const flexel_choice *c)
{
    return s->nf * (3 * values_of(c) + 2 * rates_of(c)) + c->nk * (values_of(c) + rates_of(c));
}

/* Derivatives at a state; J and M stay in the workspace. */
static void derive(flexel_work *s, const flexel_linear *l, const double *state, double *derivatives)
{
    const size_t nJ = (size_t)s->J_start[s->m + s->k + s->n];
    s->t = *state++;
    state = flexel_take_numbers(s->x, state, s->n);
    state = flexel_take_numbers(s->v, state, s->n);
    state = flexel_take_numbers(s->a, state, s->n);
    state = flexel_take_numbers(s->z, state, s->nz);
    state = flexel_take_numbers(s->unwrap_from, state, s->m);
    flexel_position(s);
    flexel_rates(s);
    flexel_take_numbers(s->stress, state, s->m + s->k);
    flexel_inertia(s);
    flexel_rate_derivatives(s);
    flexel_acceleration_derivatives(s);
    flexel_law_tangents(s, 0, 0);
    double *laws = derivatives + derivatives_of(s, l) - l->nlaws;
    for (size_t i = 0; i < l->nlaws; i++)
        laws[i] = s->law_tangent_out[l->laws[i]];
    memset(s->S, 0, s->S_sums.n * sizeof(double));
    memset(s->S_rate, 0, s->S_rate_sums.n * sizeof(double));
    derivatives = flexel_put_numbers(derivatives, s->J, nJ);
    derivatives = flexel_put_numbers(derivatives, s->Phi, nJ);
    derivatives = flexel_put_numbers(derivatives, s->Psi_x, nJ);
    derivatives = flexel_put_numbers(derivatives, s->Psi_v, nJ);
    derivatives = flexel_put_numbers(derivatives, s->M, (size_t)s->M_start[s->n]);
    flexel_tangents(s, derivatives, derivatives + s->nT);
}

/* z += sum of values times rows of `in`, `width` columns of `stride`; entries of fixed columns, which come last, are left out. */
static inline __attribute__((always_inline)) void add_entries(size_t nf, int first, int end, const int *restrict column,
                                                              const double *restrict values, size_t width, size_t stride,
                                                              const double *restrict in, double *restrict out)
{
    double z[8] = {0};
    for (int l = first; l < end && (size_t)column[l] < nf; l++)
        for (size_t j = 0; j < width; j++)
            z[j] += values[l] * in[(size_t)column[l] * stride + j];
    for (size_t j = 0; j < width; j++)
        out[j] += z[j];
}

/* The same for `count` columns, a multiple of four. */
static inline __attribute__((always_inline)) void add_row(size_t nf, int first, int end, const int *restrict column,
                                                          const double *restrict values, size_t count, size_t stride,
                                                          const double *restrict in, double *restrict out)
{
    size_t j = 0;
    for (; j + 8 <= count; j += 8)
        add_entries(nf, first, end, column, values, 8, stride, in + j, out + j);
    if (j < count)
        add_entries(nf, first, end, column, values, 4, stride, in + j, out + j);
}

/* out (nf rows of `to`) += A in (nf rows of `from`), `count` columns, of the free rows and columns of a matrix. */
FLEXEL_CLONES
static void add_product(size_t nf, const int *start, const int *column, const double *values, size_t count, size_t from,
                        const double *in, size_t to, double *out)
{
    for (size_t i = 0; i < nf; i++)
        add_row(nf, start[i], start[i + 1], column, values, count, from, in, out + i * to);
}

/* out (nf rows of `stride`) += the rows of the velocity problem, of values with the pattern of J, times in (nf by count). */
FLEXEL_CLONES
static void add_rows(const flexel_work *s, const flexel_choice *c, const double *values, size_t count, const double *in,
                     size_t stride, double *out)
{
    const size_t held = c->nr + c->np;
    for (size_t i = 0; i < held + c->nk + c->nd; i++) {
        const int row = i < held ? c->rows[i] : i < held + c->nk ? c->slips[i - held] : c->rows[i - c->nk];
        add_row(s->nf, s->J_start[row], s->J_start[row + 1], s->J_column, values, count, count, in, out + i * stride);
    }
}

/* Ones on a diagonal that begins in some row and column of an array with `columns`. */
static void unit(size_t row, size_t count, size_t columns, size_t column, double *b)
{
    for (size_t i = 0; i < count; i++)
        b[(row + i) * columns + column + i] = 1;
}

static void negate(size_t count, double *values)
{
    for (size_t i = 0; i < count; i++)
        values[i] = -values[i];
}

typedef struct {
    double *G, *first, *second, *kinematic; /* first: [H N], second: [A_v A_q] */
} flexel_transfer;

/* First- and second-order transfer functions. */
static void transfer_functions(const flexel_work *s, const flexel_choice *c, const double *Phi, const double *Psi_x,
                               const double *Psi_v, const flexel_transfer *X, double *space)
{
    const size_t nf = s->nf, p = values_of(c), r = rates_of(c), held = c->nr + c->np, all = p + r;
    double *b = space, *work = b + nf * all;
    memset(X->G, 0, nf * p * sizeof(double));
    unit(held, c->nd + c->nk, p, 0, X->G);
    unit(c->nr, c->np, p, c->nd + c->nk, X->G);
    flexel_matrix_solve(&c->P, p, X->G, X->G, work);
    memset(b, 0, nf * all * sizeof(double)); /* minus the right-hand side of [H N] */
    add_rows(s, c, Phi, p, X->G, all, b + r);
    for (size_t i = 0; i < c->nd; i++)
        b[(held + c->nk + i) * all + i] = -1;
    for (size_t i = 0; i < c->np; i++)
        b[(c->nr + i) * all + c->nd + i] = -1;
    flexel_rates_for(s, c, all, b, X->first, work);
    negate(nf * all, X->first);
    memset(b, 0, nf * all * sizeof(double));
    add_rows(s, c, Psi_v, all, X->first, all, b);
    add_rows(s, c, Psi_x, p, X->G, all, b + r);
    flexel_rates_for(s, c, all, b, X->second, work);
    negate(nf * all, X->second);
}

/* Derivatives of the rates of the kinematic degrees of freedom by the rates and the values. */
static void rolling(const flexel_work *s, const flexel_choice *c, const double *Phi, const flexel_transfer *X)
{
    const size_t p = values_of(c), r = rates_of(c), all = p + r;
    memset(X->kinematic, 0, c->nk * all * sizeof(double));
    for (size_t i = 0; i < c->nk; i++) {
        const int row = c->rows[c->nr + c->np + c->nd + i], first = s->J_start[row], end = s->J_start[row + 1];
        add_row(s->nf, first, end, s->J_column, s->J, all, all, X->first, X->kinematic + i * all);
        add_row(s->nf, first, end, s->J_column, Phi, p, p, X->G, X->kinematic + i * all + r);
    }
}

static void multiply(const flexel_work *s, const flexel_choice *c, const flexel_linear *l, const double *r_x,
                     const double *r_v, const flexel_transfer *X, double *factors)
{
    const size_t p = values_of(c), r = rates_of(c), all = p + r, to = all + r, nf = s->nf;
    memset(factors, 0, nf * to * sizeof(double));
    add_product(nf, s->M_start, s->M_column, s->M, r, all, X->first, to, factors);
    add_product(nf, s->M_start, s->M_column, s->M, all, all, X->second, to, factors + r);
    add_product(nf, s->T_start, l->T_column, r_v, all, all, X->first, to, factors + r);
    add_product(nf, s->T_start, l->T_column, r_x, p, p, X->G, to, factors + 2 * r);
}

/* A row of one number one in a known column, or of zeros; returns whether it has to be computed. */
static int known_row(int place, size_t count, double *row)
{
    memset(row, 0, count * sizeof(double));
    if (place >= 0)
        row[place] = 1;
    return place == FLEXEL_COMPUTED;
}

/* Derivatives of the quantities of laws, of their values by the degrees of freedom (p columns), and of their rates by the rates
 * and the degrees of freedom (r + p). */
static void quantities(const flexel_work *s, const flexel_choice *c, const flexel_linear *l, const double *Phi,
                       const flexel_transfer *X, double *values, double *rates)
{
    const size_t p = values_of(c), r = rates_of(c), all = p + r;
    for (size_t i = 0; i < l->nacting; i++, values += p, rates += all) {
        const int first = s->J_start[l->acting[i]], end = s->J_start[l->acting[i] + 1];
        if (known_row(l->by_value[i], p, values))
            add_row(s->nf, first, end, s->J_column, s->J, p, p, X->G, values);
        if (known_row(l->by_rate[i], all, rates)) {
            add_row(s->nf, first, end, s->J_column, s->J, all, all, X->first, rates);
            add_row(s->nf, first, end, s->J_column, Phi, p, p, X->G, rates + r);
        }
    }
}

/* y += z x */
static void add_multiple(size_t count, double z, const double *restrict x, double *restrict y)
{
    for (size_t i = 0; i < count; i++)
        y[i] += z * x[i];
}

/* [C K] (nd by r + p) from the derivatives of the laws. */
static void laws(const flexel_choice *c, const flexel_linear *l, const double *slopes, const double *values,
                 const double *rates, double *out)
{
    const size_t p = values_of(c), r = rates_of(c), all = p + r;
    memset(out, 0, c->nd * all * sizeof(double));
    for (size_t k = 0; k < l->nlaws; k++) {
        if (l->row[k] < 0 || slopes[k] == 0)
            continue;
        const double *along = rates + (size_t)l->row[k] * all;
        for (size_t i = 0; i < c->nd; i++) {
            const double z = along[i] * slopes[k];
            if (z != 0 && l->rate[k])
                add_multiple(all, z, rates + (size_t)l->column[k] * all, out + i * all);
            else if (z != 0)
                add_multiple(p, z, values + (size_t)l->column[k] * p, out + i * all + r);
        }
    }
}

size_t flexel_linearize(flexel_work *s, flexel_choice *c, const flexel_linear *l, size_t count, const double *states,
                        double *derivatives, double *transfer, double *factors, double *by_laws, double *space, int *code)
{
    const size_t p = values_of(c), all = p + rates_of(c), nJ = (size_t)s->J_start[s->m + s->k + s->n], nf = s->nf;
    double *values = space + 3 * nf * all, *rates = values + l->nacting * p;
    *code = FLEXEL_DONE;
    for (size_t i = 0; i < count; i++) {
        const double *Phi = derivatives + nJ, *r_x = derivatives + 4 * nJ + (size_t)s->M_start[s->n];
        double *first = transfer + nf * p, *second = first + nf * all;
        const flexel_transfer X = {transfer, first, second, second + nf * all};
        derive(s, l, states, derivatives);
        flexel_reset(s, c);
        *code = flexel_factorize(s, c);
        if (!*code)
            *code = flexel_directions(s, c);
        if (*code)
            return i;
        transfer_functions(s, c, Phi, Phi + nJ, Phi + 2 * nJ, &X, space);
        rolling(s, c, Phi, &X);
        multiply(s, c, l, r_x, r_x + s->nT, &X, factors);
        quantities(s, c, l, Phi, &X, values, rates);
        laws(c, l, r_x + 2 * s->nT, values, rates, by_laws);
        states += input_of(s);
        derivatives += derivatives_of(s, l);
        transfer += transfer_of(s, c);
        factors += nf * (all + rates_of(c));
        by_laws += c->nd * all;
    }
    return count;
}
