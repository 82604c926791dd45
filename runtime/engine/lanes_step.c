/* A step of DOP853 in all lanes; see lanes.h, and runge_kutta.c for one variant. */
#include "lanes_inside.h"

#include <math.h>
#include <string.h>

/* out = start + h sum of share[j] rates[j], j < count */
FLEXEL_CLONES
static void combine(size_t n, const double *start, const vec *h, size_t count, const double *share, const double *rates,
                    double *out)
{
    for (size_t i = 0; i < n; i++) {
        vec z = flexel_all(0);
        for (size_t j = 0; j < count; j++)
            if (share[j] != 0)
                z += share[j] * V(rates)[j * n + i];
        V(out)[i] = V(start)[i] + *h * z;
    }
}

/* The state at a stage: y, coordinates and deformations into the workspace. */
static void place(flexel_work *s, flexel_dop853 *o, const vec *h, size_t count, const double *share, double *y)
{
    combine(o->ny, o->y, h, count, share, o->K, y);
    combine(s->nf, o->x, h, count, share, o->V, s->x);
    combine(s->nperiodic, o->e, h, count, share, o->turning, o->e_new);
    for (size_t i = 0; i < s->nperiodic; i++)
        V(s->near)[s->periodic[i]] = V(o->e_new)[i];
}

/* Rates of y at times t, of coordinates, and of periodic deformations. */
FLEXEL_CLONES
static void rates(const flexel_lanes *l, size_t stage, const vec *t, const double *y, mask *failed)
{
    flexel_work *s = l->work;
    flexel_choice *c = l->choice;
    flexel_dop853 *o = l->steps;
    const size_t nd = c->nd, nq = nd + c->nk;
    vec *dy = V(o->K) + stage * o->ny;
    for (size_t i = 0; i < s->nt; i++)
        V(s->law_t)[i] = *t;
    memcpy(c->q, y, nq * sizeof(vec));
    memcpy(c->qd, V(y) + nq, nd * sizeof(vec));
    memcpy(s->z, V(y) + nq + nd, s->nz * sizeof(vec));
    flexel_lanes_locate(l, failed);
    flexel_lanes_velocity(l, failed);
    flexel_lanes_forces(s, c);
    flexel_lanes_accelerate(l, failed);
    memcpy(dy, c->qd, nd * sizeof(vec));
    for (size_t i = 0; i < c->nk; i++)
        dy[nd + i] = flexel_lanes_row_value(s, c->rows[c->nr + nd + i], s->v);
    memcpy(dy + nq, c->qdd, nd * sizeof(vec));
    memcpy(dy + nq + nd, s->zd, s->nz * sizeof(vec));
    memcpy(V(o->V) + stage * s->nf, s->v, s->nf * sizeof(vec));
    memcpy(V(o->W) + stage * s->nf, s->a, s->nf * sizeof(vec));
    for (size_t i = 0; i < s->nperiodic; i++)
        V(o->turning)[stage * s->nperiodic + i] = V(s->w)[s->periodic[i]];
}

/* The error of one variable, by both embedded formulas. */
FLEXEL_INLINE void errors(const flexel_dop853 *o, const double *K, size_t n, size_t i, vec *e5, vec *e3)
{
    *e5 = *e3 = flexel_all(0);
    for (size_t j = 0; j <= FLEXEL_STAGES; j++) {
        *e5 += o->E5[j] * V(K)[j * n + i];
        *e3 += o->E3[j] * V(K)[j * n + i];
    }
}

/* Largest error of variables with rates K, each by itself. */
FLEXEL_INLINE vec largest_error(const flexel_dop853 *o, const double *K, size_t n, const double *weight, int inverse,
                                const vec *h)
{
    vec largest = flexel_all(0);
    for (size_t i = 0; i < n; i++) {
        vec e5, e3;
        errors(o, K, n, i, &e5, &e3);
        e5 *= *h, e3 *= *h;
        vec z = e5 * e5, size = z + 0.01 * e3 * e3;
        flexel_root(&size);
        for (size_t k = 0; k < FLEXEL_BLOCK; k++)
            z[k] = size[k] > 0 ? z[k] / size[k] : size[k]; /* not a number is kept */
        const vec scaled = inverse ? z / weight[i] : z * weight[i];
        largest = flexel_most(largest, scaled);
    }
    return largest;
}

/* The norm of the errors of y, both embedded formulas together. */
FLEXEL_INLINE vec norm(const flexel_dop853 *o, const vec *h)
{
    vec sum5 = flexel_all(0), sum3 = sum5, found = sum5;
    for (size_t i = 0; i < o->ny; i++) {
        vec e5, e3;
        errors(o, o->K, o->ny, i, &e5, &e3);
        const vec old = flexel_size(V(o->y)[i]), new = flexel_size(V(o->y_new)[i]), size = flexel_most(old, new);
        const vec scale = o->atol[i] + o->rtol * size;
        sum5 += e5 / scale * (e5 / scale);
        sum3 += e3 / scale * (e3 / scale);
    }
    for (size_t k = 0; k < FLEXEL_BLOCK; k++)
        if (!(sum5[k] == 0 && sum3[k] == 0))
            found[k] = fabs((*h)[k]) * sum5[k] / sqrt((sum5[k] + 0.01 * sum3[k]) * (double)o->ny);
    return found;
}

/* The errors of the step, from the rates at all stages, and how far the end is from its shadow. */
FLEXEL_CLONES
static void judge(const flexel_lanes *l, flexel_trial *trial)
{
    flexel_work *s = l->work;
    flexel_dop853 *o = l->steps;
    vec defect = flexel_all(0), defect_v = defect, fastest = defect, sum = defect;
    combine(s->nf, o->V, &trial->h, FLEXEL_STAGES, o->B, o->W, o->space);
    for (size_t i = 0; i < s->nf; i++) {
        const vec z = flexel_size(V(s->x)[i] - V(o->x_new)[i]) * o->weight[i];
        const vec zd = flexel_size(V(s->v)[i] - V(o->space)[i]) * o->weight[i];
        defect = flexel_most(defect, z);
        defect_v = flexel_most(defect_v, zd);
        sum += z + zd;
        const vec speed = flexel_size(V(s->v)[i]) * o->weight[i];
        fastest = flexel_most(fastest, speed);
    }
    memcpy(o->x_new, s->x, s->n * sizeof(vec));
    for (size_t i = 0; i < s->nperiodic; i++)
        V(o->e_new)[i] = V(s->e)[s->periodic[i]];
    for (size_t k = 0; k < FLEXEL_BLOCK; k++)
        trial->failed[k] |= isfinite(sum[k]) ? 0 : -1;
    trial->defect = defect, trial->defect_v = defect_v, trial->fastest = fastest;
    trial->error = norm(o, &trial->h);
    trial->error_x = largest_error(o, o->V, s->nf, o->weight, 0, &trial->h);
    trial->error_v = largest_error(o, o->W, s->nf, o->weight, 0, &trial->h);
    trial->error_turns = largest_error(o, o->turning, s->nperiodic, s->period, 1, &trial->h);
}

FLEXEL_CLONES
void flexel_lanes_step(const flexel_lanes *l, flexel_trial *trial)
{
    flexel_work *s = l->work;
    flexel_dop853 *o = l->steps;
    const mask before = flexel_negative(V(l->sign)[0]);
    memcpy(V(s->x) + s->nf, V(o->x) + s->nf, (s->n - s->nf) * sizeof(vec));
    for (size_t stage = 1; stage <= FLEXEL_STAGES; stage++) {
        const int last = stage == FLEXEL_STAGES;
        double *y = last ? o->y_new : o->space;
        mask sign;
        const vec t = last ? trial->t + trial->h : trial->t + o->C[stage] * trial->h;
        place(s, o, &trial->h, stage, last ? o->B : o->A + stage * FLEXEL_STAGES, y);
        if (last)
            memcpy(o->x_new, s->x, s->n * sizeof(vec));
        rates(l, stage, &t, y, &trial->failed);
        flexel_lanes_sign(&l->choice->P, &sign);
        trial->changed |= sign ^ before;
    }
    judge(l, trial);
}

FLEXEL_INLINE void carry(size_t n, const mask *where, const double *from, double *to)
{
    for (size_t i = 0; i < n; i++)
        V(to)[i] = flexel_either(*where, V(from)[i], V(to)[i]);
}

FLEXEL_CLONES
void flexel_lanes_accept(const flexel_lanes *l, const mask *where)
{
    const flexel_work *s = l->work;
    flexel_dop853 *o = l->steps;
    const size_t last = FLEXEL_STAGES * FLEXEL_BLOCK;
    carry(o->ny, where, o->y_new, o->y);
    carry(s->n, where, o->x_new, o->x);
    carry(s->nperiodic, where, o->e_new, o->e);
    carry(o->ny, where, o->K + last * o->ny, o->K);
    carry(s->nf, where, o->V + last * s->nf, o->V);
    carry(s->nf, where, o->W + last * s->nf, o->W);
    carry(s->nperiodic, where, o->turning + last * s->nperiodic, o->turning);
    carry(s->n, where, s->v, l->v);
    carry(s->m, where, s->e, l->e);
    carry(s->m, where, s->w, l->w);
}
