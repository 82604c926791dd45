/* Position and velocities in minimal coordinates in all lanes; see lanes.h, and position.c for one variant. */
#include "dense.h"
#include "lanes_inside.h"

#include <math.h>
#include <string.h>

/* Wanted values of the rows. */
FLEXEL_INLINE void set_targets(flexel_work *s, flexel_choice *c)
{
    for (size_t i = 0; i < s->nf; i++) {
        V(c->target)[i] = i < c->nr ? flexel_all(0) : V(c->q)[i - c->nr];
        if ((size_t)c->rows[i] < s->m)
            V(s->unwrap_from)[c->rows[i]] = V(c->target)[i];
    }
}

/* The errors of the rows; the largest one, which is infinite where one is not finite. */
FLEXEL_INLINE vec residuals(const flexel_work *s, flexel_choice *c)
{
    vec error = flexel_all(0), sum = error;
    for (size_t i = 0; i < s->nf; i++) {
        const size_t row = (size_t)c->rows[i];
        const vec value = row < s->m ? V(s->e)[row] : V(s->x)[row - s->m - s->k];
        V(c->residual)[i] = value - V(c->target)[i];
        const vec z = flexel_size(V(c->residual)[i]) * c->weight[i];
        error = flexel_most(error, z);
        sum += z;
    }
    for (size_t i = 0; i < FLEXEL_BLOCK; i++)
        error[i] = isfinite(sum[i]) ? error[i] : INFINITY;
    return error;
}

/* What an error says of each lane: that its position is found, that one more correction is enough, or that it fails. */
FLEXEL_INLINE void judge(const flexel_lanes *l, const vec *error, const vec *last, mask *found, mask *accepted, mask *failed)
{
    for (size_t i = 0; i < FLEXEL_BLOCK; i++) {
        const double z = (*error)[i];
        (*found)[i] = z < l->choice->tolerance || (z < FLEXEL_STALLED && z > 0.5 * (*last)[i]) ? -1 : 0;
        (*accepted)[i] = z < V(l->accept)[0][i] ? -1 : 0;
        (*failed)[i] |= z < INFINITY ? 0 : -1;
    }
}

/* Where a correction would have to be damped. */
FLEXEL_INLINE void damped(const flexel_work *s, const flexel_choice *c, mask *where)
{
    const vec longest = flexel_all(FLEXEL_LONGEST_STEP);
    vec largest = flexel_all(0);
    for (size_t i = 0; i < s->nf; i++) {
        const vec size = flexel_size(V(c->step)[i]) * c->step_weight[i];
        largest = flexel_most(largest, size);
    }
    flexel_less(&largest, &longest, where);
    *where = ~*where;
}

/* Newton's method. Lanes whose position is found stay where J was evaluated last, and are evaluated there again, to the same
 * digits, until all are found; what their last correction leads to is kept apart. */
FLEXEL_CLONES
void flexel_lanes_locate(const flexel_lanes *l, mask *failed)
{
    flexel_work *s = l->work;
    flexel_choice *c = l->choice;
    const size_t nf = s->nf;
    vec last = flexel_all(INFINITY), *x = V(s->x), *step = V(c->step), *after = V(l->after);
    mask done = *failed, left = ~done;
    set_targets(s, c);
    for (size_t i = 0; i < nf; i++)
        after[i] = x[i];
    for (size_t iteration = 0; flexel_any(&left); iteration++) {
        mask found, accepted, bad = iteration < FLEXEL_MOST_ITERATIONS ? (mask){0} : ~(mask){0};
        flexel_lanes_position(s);
        c->positions++;
        const vec error = residuals(s, c);
        flexel_lanes_factor(&c->P, s->M, &bad);
        judge(l, &error, &last, &found, &accepted, &bad);
        *failed |= ~done & bad;
        done |= bad | found;
        left = ~done;
        if (!flexel_any(&left))
            break;
        flexel_lanes_solve(&c->P, 1, c->residual, c->step, c->work);
        damped(s, c, &bad); /* not usual */
        *failed |= left & bad;
        done |= bad;
        for (size_t i = 0; i < nf; i++) {
            after[i] = flexel_either(done, after[i], x[i] - step[i]);
            x[i] = flexel_either(done | accepted, x[i], after[i]);
        }
        done |= accepted;
        left = ~done;
        last = error;
    }
    for (size_t i = 0; i < nf; i++)
        x[i] = after[i];
}

/* Inverses (S G_k)^-1 of the lanes, with their own row interchanges. */
FLEXEL_INLINE void invert(size_t n, const double *A, double *inverse, mask *failed)
{
    double own[FLEXEL_MOST_KINEMATIC * FLEXEL_MOST_KINEMATIC], found[FLEXEL_MOST_KINEMATIC * FLEXEL_MOST_KINEMATIC];
    for (size_t lane = 0; lane < FLEXEL_BLOCK; lane++) {
        for (size_t i = 0; i < n * n; i++) {
            own[i] = A[i * FLEXEL_BLOCK + lane];
            found[i] = i % (n + 1) == 0;
        }
        if (flexel_dense_solve(n, n, own, found))
            (*failed)[lane] = -1;
        for (size_t i = 0; i < n * n; i++)
            inverse[i * FLEXEL_BLOCK + lane] = found[i];
    }
}

FLEXEL_CLONES
static void directions(const flexel_lanes *l, mask *failed)
{
    flexel_work *s = l->work;
    flexel_choice *c = l->choice;
    const size_t nd = c->nd, nk = c->nk, count = c->columns, nf = s->nf;
    vec *G = V(c->G);
    memset(G, 0, nf * count * sizeof *G);
    for (size_t i = 0; i < nd + nk; i++)
        G[(c->nr + i) * count + i] = flexel_all(1);
    flexel_lanes_solve(&c->P, count, c->G, c->G, c->work);
    if (!nk)
        return;
    vec *SG = V(c->small), *A = SG + nk * count, *T = A + nk * nk;
    for (size_t i = 0; i < nk; i++) {
        flexel_lanes_row(s, c->slips[i], G, count, SG + i * count);
        memcpy(A + i * nk, SG + i * count + nd, nk * sizeof *A);
    }
    invert(nk, (double *)A, c->inverse, failed);
    for (size_t k = 0; k < nk; k++) { /* row k of -(S G_k)^-1 S G, without the columns of k */
        memset(T, 0, count * sizeof *T);
        for (size_t i = 0; i < nk; i++)
            for (size_t j = 0; j < count; j++)
                T[j] -= V(c->inverse)[k * nk + i] * SG[i * count + j];
        memset(T + nd, 0, nk * sizeof *T);
        for (size_t i = 0; i < nf; i++) {
            const vec z = -G[i * count + nd + k];
            for (size_t j = 0; j < count; j++)
                G[i * count + j] -= z * T[j];
        }
    }
}

FLEXEL_CLONES
void flexel_lanes_velocity(const flexel_lanes *l, mask *failed)
{
    flexel_work *s = l->work;
    const flexel_choice *c = l->choice;
    const size_t nd = c->nd, count = c->columns;
    directions(l, failed);
    for (size_t i = 0; i < s->nf; i++) {
        vec z = flexel_all(0);
        for (size_t j = 0; j < nd; j++)
            z += V(c->G)[i * count + j] * V(c->qd)[j];
        V(s->v)[i] = z;
    }
}

FLEXEL_CLONES
void flexel_lanes_amplification(const flexel_lanes *l)
{
    const flexel_work *s = l->work;
    const flexel_choice *c = l->choice;
    const size_t nq = c->nd + c->nk, count = c->columns;
    vec largest = flexel_all(0);
    for (size_t i = 0; i < s->nf; i++) {
        vec z = flexel_all(0);
        for (size_t j = 0; j < nq; j++)
            z += flexel_size(V(c->G)[i * count + j]) / c->weight[c->nr + j];
        z *= c->step_weight[i];
        largest = flexel_most(largest, z);
    }
    V(l->amplification_new)[0] = largest;
}
