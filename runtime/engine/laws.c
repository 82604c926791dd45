/* Laws and their derivatives by pair of quantities; internal states that follow from an implicit step are condensed. */
#include "dense.h"
#include "evaluate.h"

#include <math.h>
#include <string.h>

enum { MOST_ITERATIONS = 12 };

static void run_laws(flexel_work *s, const flexel_stage *stage)
{
    flexel_take(&s->law_e, s->e, s->law_e8);
    flexel_take(&s->law_e, s->w, s->law_ed8);
    flexel_take(&s->law_s, s->w, s->law_s8);
    flexel_take(&s->law_z, s->z, s->law_z8);
    for (size_t i = 0; i < s->nt; i++)
        s->law_t[i] = s->t;
    flexel_run(stage);
}

void flexel_laws(flexel_work *s)
{
    if (!s->nlaws)
        return; /* the stresses stay zero */
    run_laws(s, &s->law);
    flexel_sum(&s->stress_sums, s->law_out, s->law_stress);
    flexel_sum(&s->zd_sums, s->law_out, s->zd);
    flexel_sum(&s->law_U_sums, s->law_out, s->law_U);
    flexel_sum(&s->law_P_sums, s->law_out, s->law_P);
}

/* The share with which the states of the laws of a type follow; zero if they are held. */
static double share_of(const flexel_lag *lag, double share, int at_rest)
{
    return at_rest && !lag->lasting ? 0 : share;
}

/* A = 1 - share dzd/dz of a law, from the places of its derivatives. */
static void condensing(const flexel_lag *lag, const int *at, const double *out, double share, double *A)
{
    const size_t rows = lag->m + lag->k, columns = 2 * lag->m + lag->k + lag->nz, nz = lag->nz;
    for (size_t i = 0; i < nz; i++)
        for (size_t j = 0; j < nz; j++)
            A[i * nz + j] = (i == j) - share * out[at[(rows + i) * columns + columns - nz + j]];
}

/* One step of Newton's method for the states of all laws of a type. */
static void correct_states(flexel_work *s, const flexel_lag *lag, const double *known, double share)
{
    const size_t nz = lag->nz, size = (lag->m + lag->k + nz) * (2 * lag->m + lag->k + nz);
    double *A = lag->matrix, *off = lag->sides;
    for (size_t l = 0; l < lag->count; l++) {
        const int *z = lag->z + l * nz;
        condensing(lag, lag->at + l * size, s->law_tangent_out, share, A);
        for (size_t i = 0; i < nz; i++)
            off[i] = s->z[z[i]] - known[z[i]] - share * s->zd[z[i]];
        flexel_dense_solve(nz, 1, A, off);
        for (size_t i = 0; i < nz; i++)
            s->z[z[i]] -= off[i];
    }
}

/* Whether the states of all laws are those that an implicit step asks for. */
static int states_found(const flexel_work *s, const double *known, double share, int at_rest)
{
    double off = 0, z = 0, zd = 0;
    for (size_t l = 0; l < s->nlags; l++) {
        const flexel_lag *lag = s->lags + l;
        const double own = share_of(lag, share, at_rest);
        for (size_t j = 0; j < lag->count * lag->nz; j++) {
            const int i = lag->z[j];
            off = fmax(off, fabs(s->z[i] - known[i] - own * s->zd[i]));
            z = fmax(z, fabs(s->z[i]));
            zd = fmax(zd, fabs(own * s->zd[i]));
        }
    }
    return off <= 1e-13 * (z + zd);
}

void flexel_implicit_states(flexel_work *s, const double *known, double share, int at_rest)
{
    flexel_laws(s);
    for (size_t iteration = 0; iteration < MOST_ITERATIONS && !states_found(s, known, share, at_rest); iteration++) {
        run_laws(s, &s->law_tangent);
        for (size_t i = 0; i < s->nlags; i++)
            correct_states(s, s->lags + i, known, share_of(s->lags + i, share, at_rest));
        flexel_laws(s);
    }
}

/* Derivatives of the stresses of the laws of a type by e, its rate and s, states following with that share. */
static void condense(const flexel_lag *lag, const double *out, double share)
{
    const size_t nz = lag->nz, rows = lag->m + lag->k, direct = 2 * lag->m + lag->k, columns = direct + nz;
    double *A = lag->matrix, *B = lag->sides;
    for (size_t l = 0; l < lag->count; l++) {
        const int *at = lag->at + l * (rows + nz) * columns;
        double *found = lag->direct + l * rows * direct;
        for (size_t i = 0; i < nz; i++)
            for (size_t j = 0; j < direct; j++)
                B[i * direct + j] = share * out[at[(rows + i) * columns + j]];
        if (share != 0) {
            condensing(lag, at, out, share, A);
            flexel_dense_solve(nz, direct, A, B);
        }
        for (size_t i = 0; i < rows; i++)
            for (size_t j = 0; j < direct; j++) {
                double z = out[at[i * columns + j]];
                for (size_t q = 0; q < nz; q++)
                    z += out[at[i * columns + direct + q]] * B[q * direct + j];
                found[i * direct + j] = z;
            }
    }
}

void flexel_law_tangents(flexel_work *s, double share, int at_rest)
{
    if (!s->nlaws)
        return;
    run_laws(s, &s->law_tangent);
    for (size_t i = 0; i < s->nlags; i++)
        condense(s->lags + i, s->law_tangent_out, share_of(s->lags + i, share, at_rest));
    flexel_sum(&s->S_sums, s->law_tangent_out, s->S);
    flexel_sum(&s->S_rate_sums, s->law_tangent_out, s->S_rate);
}
