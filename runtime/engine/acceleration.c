/* Forces, accelerations and multipliers in minimal coordinates; see explicit.h. */
#include "dense.h"
#include "evaluate.h"
#include "explicit.h"
#include "rows.h"

#include <math.h>
#include <string.h>

#define ROUNDING 1e-14 /* residual of a solution to the last digit, relative to the right-hand side */

void flexel_forces(flexel_work *s, flexel_choice *c)
{
    const size_t first = s->m + s->k;
    if (s->nlaws)
        flexel_rates(s);
    else /* nothing but the counting of turns asks for rates */
        for (size_t i = 0; i < s->nperiodic; i++)
            s->w[s->periodic[i]] = flexel_row_value(s, s->periodic[i], s->v);
    flexel_laws(s);
    flexel_inertia(s);
    memset(c->force, 0, s->n * sizeof(double));
    for (size_t i = 0; i < first; i++)
        s->stress[i] = s->law_stress[i];
    for (size_t i = 0; i < c->nloads; i++) {
        const size_t quantity = (size_t)c->loaded[i];
        if (quantity >= first)
            c->force[quantity - first] -= c->loads[i]; /* the sign of all turns below */
        else
            s->stress[quantity] -= c->loads[i];
    }
    if (c->nloads || s->nlaws)
        flexel_pull(s, s->stress, c->force);
    for (size_t i = 0; i < s->n; i++)
        c->force[i] = s->F[i] - c->force[i];
}

/* g: accelerations of the coordinates where the dynamic degrees of freedom have `given` ones (or none), into c->step. */
static void convective(flexel_work *s, flexel_choice *c, const double *given)
{
    const size_t held = c->nr + c->np, nk = c->nk, count = c->columns, nd = c->saddle ? 0 : c->nd;
    flexel_convective(s);
    for (size_t i = 0; i < s->nf; i++) {
        const size_t row = (size_t)c->rows[i];
        double z = row < s->m ? -s->g[row] : 0;
        if (i >= c->nr && i < held)
            z += c->motion[2 * c->np + i - c->nr];
        if (given && i >= held && i < held + c->nd)
            z += given[i - held];
        c->residual[i] = z;
    }
    flexel_matrix_solve(&c->P, 1, c->residual, c->step, c->work);
    double *missing = c->work;
    for (size_t i = 0; i < nk; i++) {
        flexel_row(s, c->slips[i], c->step, 1, 1, missing + i);
        missing[i] += s->g[c->slips[i]];
    }
    for (size_t k = 0; k < nk; k++) {
        double w = 0;
        for (size_t i = 0; i < nk; i++)
            w -= c->inverse[k * nk + i] * missing[i];
        for (size_t i = 0; i < s->nf; i++)
            c->step[i] += w * c->G[i * count + nd + k];
    }
}

/* X = [H | g], rows of `stride` numbers. */
static void fill_X(flexel_work *s, flexel_choice *c)
{
    const size_t nd = c->nd, count = c->columns;
    for (size_t i = 0; i < s->nf; i++) {
        double *X = c->X + i * c->stride;
        for (size_t j = 0; j < nd; j++)
            X[j] = c->G[i * count + j];
        X[nd] = c->step[i];
    }
}

/* y += z x; with a constant number of entries this becomes one or two instructions */
static inline __attribute__((always_inline)) void add(size_t n, double z, const double *restrict x, double *restrict y)
{
    for (size_t i = 0; i < n; i++)
        y[i] += z * x[i];
}

/* R = X' M X and b = X' F for X = [H | g], rows of `stride` numbers. */
static inline __attribute__((always_inline)) void reduce_by(const flexel_work *s, const flexel_choice *c, size_t stride,
                                                         double *MX, double *R, double *b)
{
    for (size_t i = 0; i < s->nf; i++) {
        const double *X = c->X + i * stride;
        add(stride, c->force[i], X, b);
        if (s->M_start[i] == s->M_free[i])
            continue;
        memset(MX, 0, stride * sizeof(double));
        for (int l = s->M_start[i]; l < s->M_free[i]; l++)
            add(stride, s->M[l], c->X + (size_t)s->M_column[l] * stride, MX);
        for (size_t j = 0; j < c->nd; j++)
            add(stride, X[j], MX, R + j * stride);
    }
}

/* The same; the usual strides have loops of their own. */
FLEXEL_CLONES
static void reduce(const flexel_work *s, const flexel_choice *c, double *MX, double *R, double *b)
{
    switch (c->stride) {
    case 4:
        reduce_by(s, c, 4, MX, R, b);
        break;
    case 8:
        reduce_by(s, c, 8, MX, R, b);
        break;
    case 12:
        reduce_by(s, c, 12, MX, R, b);
        break;
    default:
        reduce_by(s, c, c->stride, MX, R, b);
    }
}

/* (H' M H) q'' = H' (F - M g) */
static int reduced(flexel_work *s, flexel_choice *c)
{
    const size_t nd = c->nd, stride = c->stride;
    double *R = c->small, *MX = R + nd * stride, *b = MX + stride, *A = b + stride;
    fill_X(s, c);
    memset(R, 0, (nd + 2) * stride * sizeof(double));
    reduce(s, c, MX, R, b);
    for (size_t i = 0; i < nd; i++) {
        c->qdd[i] = b[i] - R[i * stride + nd];
        for (size_t j = 0; j < nd; j++)
            A[i * nd + j] = R[i * stride + j];
    }
    if (flexel_definite_solve(nd, A, c->qdd))
        return FLEXEL_MASSLESS;
    for (size_t i = 0; i < s->nf; i++) {
        double z = c->step[i];
        for (size_t j = 0; j < nd; j++)
            z += c->X[i * stride + j] * c->qdd[j];
        s->a[i] = z;
    }
    return FLEXEL_DONE;
}

static double largest(size_t n, const double *values)
{
    double found = 0;
    for (size_t i = 0; i < n; i++)
        found = fabs(values[i]) > found ? fabs(values[i]) : found;
    return found;
}

/* b -= [M B'; C 0] x, where B are the rows in which forces act */
static void subtract_product(const flexel_work *s, const flexel_choice *c, const double *restrict x, double *restrict b)
{
    const size_t nf = s->nf, held = c->nr + c->np, count = held + c->nk;
    for (size_t i = 0; i < nf; i++) {
        double z = b[i];
        for (int l = s->M_start[i]; l < s->M_free[i]; l++)
            z -= s->M[l] * x[s->M_column[l]];
        b[i] = z;
    }
    for (size_t i = 0; i < count; i++) {
        const int row = i < held ? c->rows[i] : c->slips[i - held], at = i < held ? c->forced[i] : row;
        const double mu = x[nf + i];
        double z = b[nf + i];
        for (int l = s->J_start[row]; l < s->J_start[row + 1] && (size_t)s->J_column[l] < nf; l++)
            z -= s->J[l] * x[s->J_column[l]];
        for (int l = s->J_start[at]; l < s->J_start[at + 1] && (size_t)s->J_column[l] < nf; l++)
            b[s->J_column[l]] -= s->J[l] * mu;
        b[nf + i] = z;
    }
}

/* [M B'; C 0] [a; mu] = [F; prescribed - convective] */
static int saddle(flexel_work *s, flexel_choice *c)
{
    const size_t nf = s->nf, held = c->nr + c->np, count = held + c->nk, first = held + c->nd;
    double *b = c->G, *x = c->step;
    flexel_convective(s);
    if (flexel_matrix_factor(&c->A, s->M))
        return FLEXEL_MASSLESS;
    memcpy(b, c->force, nf * sizeof(double));
    for (size_t i = 0; i < count; i++) {
        const size_t row = (size_t)(i < held ? c->rows[i] : c->slips[i - held]);
        b[nf + i] = row < s->m + s->k ? -s->g[row] : 0;
        if (i >= c->nr && i < held)
            b[nf + i] += c->motion[2 * c->np + i - c->nr];
    }
    flexel_matrix_solve(&c->A, 1, b, x, c->work);
    /* The order of the pivots is chosen for sparsity, which may cost some digits. */
    const double size = largest(nf + count, b);
    subtract_product(s, c, x, b);
    if (largest(nf + count, b) > ROUNDING * size) {
        flexel_matrix_solve(&c->A, 1, b, b, c->work);
        for (size_t i = 0; i < nf + count; i++)
            x[i] += b[i];
    }
    memcpy(s->a, x, nf * sizeof(double));
    for (size_t i = held; i < first; i++) {
        const int row = c->rows[i];
        c->qdd[i - held] = ((size_t)row < s->m ? s->g[row] : 0) + flexel_row_value(s, row, s->a);
    }
    for (size_t i = c->nr; i < first; i++)
        c->multiplier[c->rows[i]] = 0; /* unless actuators are among them */
    for (size_t i = 0; i < count; i++)
        c->multiplier[i < held ? c->forced[i] : c->slips[i - held]] = x[nf + i];
    return FLEXEL_DONE;
}

int flexel_accelerate(flexel_work *s, flexel_choice *c)
{
    if (c->saddle)
        return saddle(s, c);
    convective(s, c, NULL);
    return reduced(s, c);
}

int flexel_driven(flexel_work *s, flexel_choice *c)
{
    convective(s, c, c->qdd);
    memcpy(s->a, c->step, s->nf * sizeof(double));
    return FLEXEL_DONE;
}

void flexel_multipliers(flexel_work *s, flexel_choice *c, int driven)
{
    const size_t nf = s->nf, held = c->nr + c->np;
    if (c->saddle && !driven)
        return; /* found with the accelerations */
    double *r = c->residual, *y = c->step;
    flexel_momentum(s, s->a, c->X);
    for (size_t i = 0; i < nf; i++)
        r[i] = c->force[i] - c->X[i];
    if (c->nk) { /* P' y = r, then S' mu = what the rows of the kinematic ones have taken: A' mu = y_k */
        flexel_matrix_solve_transposed(&c->P, 1, r, y, c->work);
        for (size_t i = 0; i < c->nk; i++) {
            double mu = 0;
            for (size_t j = 0; j < c->nk; j++)
                mu += c->inverse[j * c->nk + i] * y[held + c->nd + j];
            const int slip = c->slips[i];
            c->multiplier[slip] = mu;
            for (int l = s->J_start[slip]; l < s->J_start[slip + 1]; l++)
                if ((size_t)s->J_column[l] < nf)
                    r[s->J_column[l]] -= s->J[l] * mu;
        }
    }
    flexel_matrix_solve_transposed(&c->P, 1, r, y, c->work);
    for (size_t i = 0; i < held + c->nd; i++)
        c->multiplier[c->rows[i]] = i < held || driven ? y[i] : 0;
}

int flexel_complete(flexel_work *s, flexel_choice *c, int driven)
{
    int failed = FLEXEL_DONE;
    c->predict = 0;
    flexel_position(s);
    if (driven || !c->saddle) {
        failed = flexel_factorize(s, c);
        if (!failed)
            failed = flexel_directions(s, c);
        if (failed)
            return failed;
    }
    flexel_forces(s, c);
    failed = driven ? flexel_driven(s, c) : flexel_accelerate(s, c);
    if (!failed)
        flexel_multipliers(s, c, driven);
    return failed;
}

void flexel_choice_clear(flexel_choice *c)
{
    flexel_matrix_clear(&c->P);
    flexel_matrix_clear(&c->A);
}

void flexel_reset(flexel_work *s, flexel_choice *c)
{
    flexel_matrix_reset(&c->P);
    flexel_matrix_reset(&c->A);
    c->predict = 0;
    for (size_t i = s->nf; i < s->n; i++)
        s->v[i] = s->a[i] = 0;
}
