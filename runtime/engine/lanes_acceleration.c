/* Accelerations in minimal coordinates in all lanes; see lanes.h, and acceleration.c for one variant. */
#include "dense.h"
#include "lanes_inside.h"

#include <string.h>

/* g: accelerations of the coordinates without those of the degrees of freedom, into c->step. */
FLEXEL_INLINE void convective(flexel_work *s, flexel_choice *c)
{
    const size_t nk = c->nk, count = c->columns, nd = c->nd;
    vec *step = V(c->step), *missing = V(c->work);
    flexel_lanes_convective(s);
    for (size_t i = 0; i < s->nf; i++) {
        const size_t row = (size_t)c->rows[i];
        V(c->residual)[i] = row < s->m ? -V(s->g)[row] : flexel_all(0);
    }
    flexel_lanes_solve(&c->P, 1, c->residual, c->step, c->work);
    for (size_t i = 0; i < nk; i++) {
        flexel_lanes_row(s, c->slips[i], step, 1, missing + i);
        missing[i] += V(s->g)[c->slips[i]];
    }
    for (size_t k = 0; k < nk; k++) {
        vec w = flexel_all(0);
        for (size_t i = 0; i < nk; i++)
            w -= V(c->inverse)[k * nk + i] * missing[i];
        for (size_t i = 0; i < s->nf; i++)
            step[i] += w * V(c->G)[i * count + nd + k];
    }
}

/* R = X' M X and b = X' F for X = [H | g]. */
FLEXEL_INLINE void reduce(const flexel_work *s, const flexel_choice *c, vec *MX, vec *R, vec *b)
{
    const size_t nd = c->nd, stride = nd + 1;
    vec *X = V(c->X);
    for (size_t i = 0; i < s->nf; i++) {
        memcpy(X + i * stride, V(c->G) + i * c->columns, nd * sizeof *X);
        X[i * stride + nd] = V(c->step)[i];
    }
    for (size_t i = 0; i < s->nf; i++, X += stride) {
        for (size_t j = 0; j < stride; j++)
            b[j] += V(c->force)[i] * X[j];
        if (s->M_start[i] == s->M_free[i])
            continue;
        const int first = s->M_start[i];
        for (size_t j = 0; j < stride; j++)
            MX[j] = flexel_all(0);
        flexel_lanes_sums(MX, V(s->M) + first, s->M_column + first, s->M_free[i] - first, V(c->X), stride);
        for (size_t j = 0; j < nd; j++)
            for (size_t k = 0; k < stride; k++)
                R[j * stride + k] += X[j] * MX[k];
    }
}

/* The accelerations of the degrees of freedom, from R and b. */
FLEXEL_INLINE void solve(size_t nd, const double *R, const double *b, double *qdd, mask *failed)
{
    double A[FLEXEL_MOST_DYNAMIC * FLEXEL_MOST_DYNAMIC], own[FLEXEL_MOST_DYNAMIC];
    for (size_t lane = 0; lane < FLEXEL_BLOCK; lane++) {
        for (size_t i = 0; i < nd; i++) {
            const double *row = R + i * (nd + 1) * FLEXEL_BLOCK + lane;
            own[i] = b[i * FLEXEL_BLOCK + lane] - row[nd * FLEXEL_BLOCK];
            for (size_t j = 0; j < nd; j++)
                A[i * nd + j] = row[j * FLEXEL_BLOCK];
        }
        if (flexel_definite_solve(nd, A, own))
            (*failed)[lane] = -1;
        for (size_t i = 0; i < nd; i++)
            qdd[i * FLEXEL_BLOCK + lane] = own[i];
    }
}

FLEXEL_CLONES
void flexel_lanes_accelerate(const flexel_lanes *l, mask *failed)
{
    flexel_work *s = l->work;
    flexel_choice *c = l->choice;
    const size_t nd = c->nd, stride = nd + 1;
    vec *R = V(c->small), *MX = R + nd * stride, *b = MX + stride;
    convective(s, c);
    memset(R, 0, (nd + 2) * stride * sizeof *R);
    reduce(s, c, MX, R, b);
    solve(nd, (double *)R, (double *)b, c->qdd, failed);
    for (size_t i = 0; i < s->nf; i++) {
        vec z = V(c->step)[i];
        for (size_t j = 0; j < nd; j++)
            z += V(c->X)[i * stride + j] * V(c->qdd)[j];
        V(s->a)[i] = z;
    }
}
