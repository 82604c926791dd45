/* Sparse linear systems of a step of Radau IIA; see radau_saddle.h. */
#include "radau_saddle.h"
#include "evaluate.h"
#include "quaternion.h"
#include "rotations.h"

#include <math.h>
#include <string.h>

static int are_finite(size_t n, const double *values)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(values[i]))
            return 0;
    return 1;
}

static void finite_or_zero(size_t n, double *values)
{
    for (size_t i = 0; i < n; i++)
        values[i] = isfinite(values[i]) ? values[i] : 0;
}

int flexel_radau_look(flexel_work *s, flexel_radau_saddle *o, const double *stress)
{
    const size_t size = o->nT * sizeof(double), nM = (size_t)s->M_start[s->n];
    memcpy(s->stress, stress, (s->m + s->k) * sizeof(double));
    finite_or_zero(s->nS, s->S);
    finite_or_zero(s->nS, s->S_rate);
    flexel_rate_derivatives(s);
    flexel_tangents(s, o->K, o->D);
    flexel_tangent(s, 0, 0, 1, 0);
    memcpy(o->M, s->T, size);
    memcpy(o->mass, s->M, nM * sizeof(double));
    memcpy(o->mass + nM, s->J, o->nJ * sizeof(double));
    memcpy(o->single_values + o->nT, s->J, o->nJ * sizeof(double));
    memcpy(o->pair_values + 3 * o->nT, s->J, o->nJ * sizeof(double));
    return flexel_matrix_factor(&o->P, o->mass);
}

int flexel_radau_saddle_factorize(flexel_radau_saddle *o, double mu, const double *pair)
{
    const size_t nT = o->nT;
    const double re = pair[0], im = pair[1], square = re * re - im * im, twice = 2 * re * im;
    double *single = o->single_values, *first = o->pair_values, *second = first + nT, *third = second + nT;
    for (size_t i = 0; i < nT; i++) {
        single[i] = mu * mu * o->M[i] + mu * o->D[i] + o->K[i];
        first[i] = square * o->M[i] + re * o->D[i] + o->K[i];
        second[i] = twice * o->M[i] + im * o->D[i];
        third[i] = -second[i];
    }
    if (!are_finite(nT, single))
        return 1;
    return flexel_matrix_factor(&o->single, single) || flexel_matrix_factor(&o->pair, first);
}

/* The right-hand side of coordinate i, for one number of each degree of freedom; g and a are columns of `stride` numbers. */
static double side(const flexel_radau_saddle *o, size_t i, size_t stride, const double *a, const double *g)
{
    double z = 0;
    for (int l = o->T_start[i]; l < o->T_start[i + 1]; l++) {
        const size_t j = (size_t)o->T_column[l] * stride;
        z += o->M[l] * a[j] + o->D[l] * g[j];
    }
    return z;
}

/* The change of a degree of freedom. */
static double change(const flexel_radau_saddle *o, size_t i, const double *dx)
{
    const double *J = o->single_values + o->nT;
    double z = 0;
    for (int l = o->J_start[o->dynamic[i]]; l < o->J_start[o->dynamic[i] + 1]; l++)
        if ((size_t)o->J_column[l] < o->nf)
            z += J[l] * dx[o->J_column[l]];
    return z;
}

/* The derivative of an Euler parameter by its angle. */
static double slope(const flexel_angles *r, size_t i)
{
    return r->seen[i] == 0 ? 1 : r->seen[i] / 2;
}

/* Rates of Euler parameters for angular velocities, in the rows of the degrees of freedom of X; columns one by one. */
static void place_rotations(const flexel_radau_saddle *o, size_t count, double *X)
{
    const flexel_turns *r = o->turns;
    for (size_t i = 0; i < r->count; i++) {
        const double *L = r->seen + 4 * i;
        const int *dof = r->dof + 3 * i;
        for (size_t k = 0; k < count; k++) {
            double v[4], w[3];
            for (size_t j = 0; j < 3; j++)
                w[j] = X[(o->held + (size_t)dof[j]) * count + k];
            if (r->space[i])
                flexel_to_frame(L, (const double[]){w[0], w[1], w[2]}, w);
            FLEXEL_TURN(v, L, w);
            for (size_t j = 0; j < 3; j++)
                X[(o->held + (size_t)dof[j]) * count + k] = v[r->part[3 * i + j]];
        }
    }
    for (size_t i = 0; i < o->angles->count; i++)
        for (size_t k = 0; k < count; k++)
            X[(o->held + (size_t)o->angles->dof[i]) * count + k] *= slope(o->angles, i);
}

/* Changes z of the degrees of freedom, `numbers` of each, for those of the coordinates, which are columns of n numbers. */
static void changes(const flexel_radau_saddle *o, size_t numbers, size_t n, const double *dx, double *z)
{
    const flexel_turns *r = o->turns;
    for (size_t i = 0; i < o->nd; i++)
        for (size_t part = 0; part < numbers; part++)
            z[i * numbers + part] = change(o, i, dx + part * n);
    for (size_t i = 0; i < r->count; i++)
        for (size_t part = 0; part < numbers; part++) {
            const double *L = r->seen + 4 * i;
            double dL[4], p[3];
            for (size_t k = 0; k < 4; k++)
                dL[k] = dx[part * n + (size_t)r->at[4 * i + k]];
            FLEXEL_SPIN(p, L, dL);
            if (r->space[i])
                flexel_to_space(L, (const double[]){p[0], p[1], p[2]}, p);
            for (size_t k = 0; k < 3; k++)
                z[(size_t)r->dof[3 * i + k] * numbers + part] = p[k];
        }
    for (size_t i = 0; i < o->angles->count; i++)
        for (size_t part = 0; part < numbers; part++)
            z[(size_t)o->angles->dof[i] * numbers + part] /= slope(o->angles, i);
}

/* Changes w x z / 2 of angular velocities for changes z, added to b; along the axes of space they are the opposite. */
static void add_turning(const flexel_radau_saddle *o, size_t numbers, const double *z, double *b)
{
    const flexel_turns *r = o->turns;
    for (size_t i = 0; i < r->count; i++)
        for (size_t part = 0; part < numbers; part++)
            for (size_t k = 0; k < 3; k++) {
                const int *dof = r->dof + 3 * i, next = dof[(k + 1) % 3], last = dof[(k + 2) % 3];
                const double *w = r->spin + 3 * i, half = r->space[i] ? -0.5 : 0.5;
                b[(o->nd + (size_t)dof[k]) * numbers + part] += half * (w[(k + 1) % 3] * z[(size_t)last * numbers + part] -
                                                                        w[(k + 2) % 3] * z[(size_t)next * numbers + part]);
            }
}

/* Columns G r, and mu G r + G s, each of `numbers` numbers; b has the pairs or numbers of r and s. */
static void columns(const flexel_radau_saddle *o, size_t numbers, double re, double im, const double *b)
{
    const size_t count = 2 * numbers, nd = o->nd;
    double *X = o->columns;
    memset(X, 0, o->nf * count * sizeof(double));
    for (size_t i = 0; i < nd; i++)
        for (size_t k = 0; k < numbers; k++) {
            X[(o->held + i) * count + k] = b[i * numbers + k];
            X[(o->held + i) * count + numbers + k] = b[(nd + i) * numbers + k];
        }
    place_rotations(o, count, X);
    flexel_matrix_solve(&o->P, count, X, X, o->work);
    for (size_t i = 0; i < o->nf; i++) {
        double *g = X + i * count, *a = g + numbers;
        a[0] += re * g[0] - (numbers == 2 ? im * g[1] : 0);
        if (numbers == 2)
            a[1] += re * g[1] + im * g[0];
    }
}

void flexel_radau_saddle_solve(const flexel_radau_saddle *o, double mu, double *b)
{
    const size_t n = o->nf + o->held;
    double *dx = o->sides;
    columns(o, 1, mu, 0, b);
    memset(dx, 0, n * sizeof(double));
    for (size_t i = 0; i < o->nf; i++)
        dx[i] = side(o, i, 2, o->columns + 1, o->columns);
    flexel_matrix_solve(&o->single, 1, dx, dx, o->work);
    double *z = o->columns;
    changes(o, 1, n, dx, z);
    for (size_t i = 0; i < o->nd; i++) {
        b[o->nd + i] = mu * z[i] - b[i];
        b[i] = z[i];
    }
    add_turning(o, 1, z, b);
}

void flexel_radau_saddle_solve_pair(const flexel_radau_saddle *o, const double *mu, double *b)
{
    const size_t n = o->nf + o->held, nd = o->nd;
    double *dx = o->sides;
    columns(o, 2, mu[0], mu[1], b);
    memset(dx, 0, 2 * n * sizeof(double));
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < o->nf; i++)
            dx[k * n + i] = side(o, i, 4, o->columns + 2 + k, o->columns + k);
    flexel_matrix_solve(&o->pair, 1, dx, dx, o->work);
    double *z = o->columns;
    changes(o, 2, n, dx, z);
    for (size_t i = 0; i < nd; i++) {
        const double re = z[2 * i], im = z[2 * i + 1];
        b[2 * (nd + i)] = mu[0] * re - mu[1] * im - b[2 * i];
        b[2 * (nd + i) + 1] = mu[0] * im + mu[1] * re - b[2 * i + 1];
        b[2 * i] = re;
        b[2 * i + 1] = im;
    }
    add_turning(o, 2, z, b);
}

void flexel_radau_saddle_clear(flexel_radau_saddle *o)
{
    flexel_matrix_clear(&o->P);
    flexel_matrix_clear(&o->single);
    flexel_matrix_clear(&o->pair);
}
