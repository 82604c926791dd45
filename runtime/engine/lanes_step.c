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

/* Euler parameters of free rotations at a stage have length one, their rates are those of the angular velocities. */
static void place_rotations(const flexel_lanes *l, const vec *h, size_t count, const double *share, double *y)
{
    const flexel_rotations *r = &l->steps->rotations;
    vec *x = V(l->work->x), *rates = V(y) + l->choice->nd + l->choice->nk;
    combine(3 * r->count, r->w, h, count, share, r->W, r->stage);
    for (size_t i = 0; i < r->count; i++) {
        const int *at = r->at + 4 * i;
        const vec *w = V(r->stage) + 3 * i;
        vec L[4], v[4];
        vec size = x[at[0]] * x[at[0]] + x[at[1]] * x[at[1]] + x[at[2]] * x[at[2]] + x[at[3]] * x[at[3]];
        flexel_root(&size);
        for (size_t k = 0; k < 4; k++)
            x[at[k]] = L[k] = x[at[k]] / size;
        FLEXEL_TURN(v, L, w);
        for (size_t k = 0; k < 3; k++) {
            V(y)[r->dof[3 * i + k]] = L[r->part[3 * i + k]];
            rates[r->dof[3 * i + k]] = v[r->part[3 * i + k]];
        }
    }
}

/* Twice E times rates, or second rates, of the coordinates. */
static void spins(const flexel_work *s, const flexel_rotations *r, const double *rates, vec *w)
{
    for (size_t i = 0; i < r->count; i++) {
        vec L[4], v[4];
        for (size_t k = 0; k < 4; k++)
            L[k] = V(s->x)[r->at[4 * i + k]], v[k] = V(rates)[r->at[4 * i + k]];
        FLEXEL_SPIN(w + 3 * i, L, v);
    }
}

/* The state at a stage: y, coordinates and deformations into the workspace. */
static void place(const flexel_lanes *l, const vec *h, size_t count, const double *share, double *y)
{
    const flexel_work *s = l->work;
    flexel_dop853 *o = l->steps;
    combine(o->ny, o->y, h, count, share, o->K, y);
    combine(s->nf, o->x, h, count, share, o->V, s->x);
    combine(s->nperiodic, o->e, h, count, share, o->turning, o->e_new);
    for (size_t i = 0; i < s->nperiodic; i++)
        V(s->unwrap_from)[s->periodic[i]] = V(o->e_new)[i];
    place_rotations(l, h, count, share, y);
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
    spins(s, &o->rotations, s->a, V(o->rotations.W) + stage * 3 * o->rotations.count);
    for (size_t i = 0; i < s->nperiodic; i++)
        V(o->turning)[stage * s->nperiodic + i] = V(s->w)[s->periodic[i]];
    flexel_lanes_account_stage(l, stage);
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

/* Error of one variable by itself, from those of both formulas. */
FLEXEL_INLINE void both(const vec *e5, const vec *e3, vec *z)
{
    const vec square = *e5 * *e5;
    vec size = square + 0.01 * *e3 * *e3;
    flexel_root(&size);
    for (size_t k = 0; k < FLEXEL_BLOCK; k++)
        (*z)[k] = size[k] > 0 ? square[k] / size[k] : size[k]; /* not a number is kept */
}

/* Largest error of variables with rates K, each by itself. */
FLEXEL_INLINE vec largest_error(const flexel_dop853 *o, const double *K, size_t n, const double *weight, int inverse,
                                const vec *h)
{
    vec largest = flexel_all(0), e5, e3, z;
    for (size_t i = 0; i < n; i++) {
        errors(o, K, n, i, &e5, &e3);
        e5 *= *h, e3 *= *h;
        both(&e5, &e3, &z);
        const vec scaled = inverse ? z / weight[i] : z * weight[i];
        largest = flexel_most(largest, scaled);
    }
    return largest;
}

/* Allowed errors of some variables. */
FLEXEL_INLINE void allow_some(flexel_dop853 *o, size_t first, size_t end, const vec *share, const vec *rtol, const vec *most)
{
    for (size_t i = first; i < end; i++) {
        const vec old = flexel_size(V(o->y)[i]), new = flexel_size(V(o->y_new)[i]), size = flexel_most(old, new);
        const vec limit = *most * o->atol[i], allowed = flexel_least(size, limit);
        V(o->scale)[i] = *share * o->atol[i] + *rtol * allowed + FLEXEL_NO_ERROR;
    }
}

/* Those of rates: relative to how far they have moved, if the motions are relative to themselves. */
FLEXEL_INLINE void allow_rates(flexel_dop853 *o, size_t first, size_t end, const vec *share, const vec *rtol)
{
    const flexel_covered *m = o->covered;
    for (size_t i = first; i < end; i++) {
        const vec y = V(o->y_new)[i], old = flexel_size(V(o->y)[i]), new = flexel_size(y), size = flexel_most(old, new);
        const vec high = flexel_most(V(m->most_y)[i], y), low = flexel_least(V(m->least_y)[i], y), moved = high - low;
        const vec allowed = m->relative ? flexel_least(size, moved) : size;
        V(o->scale)[i] = *share * o->atol[i] + *rtol * allowed + FLEXEL_NO_ERROR;
    }
}

/* Those of angular velocities, instead of rates of Euler parameters which are half as large, and those of the Euler parameters
 * that are not in y. */
FLEXEL_INLINE void allow_rotations(const flexel_lanes *l, const vec *coordinates, const vec *rates, const vec *rtol,
                                   const vec *most)
{
    flexel_dop853 *o = l->steps;
    const flexel_rotations *r = &o->rotations;
    const size_t nq = l->choice->nd + l->choice->nk;
    for (size_t i = 0; i < r->count; i++) {
        const int dof = r->dof[3 * i], rest = r->at[4 * i + (size_t)r->rest[i]];
        for (size_t k = 0; k < 3; k++) {
            const vec old = flexel_size(V(r->w)[3 * i + k]), new = flexel_size(V(r->w_new)[3 * i + k]);
            const vec size = flexel_most(old, new);
            V(r->scale)[4 * i + k] = *rates * o->atol[nq + (size_t)dof] + 0.5 * *rtol * size + FLEXEL_NO_ERROR;
            V(o->scale)[nq + (size_t)r->dof[3 * i + k]] = flexel_all(INFINITY);
        }
        const vec old = flexel_size(V(o->x)[rest]), new = flexel_size(V(l->work->x)[rest]), size = flexel_most(old, new);
        const vec limit = *most * o->atol[dof], allowed = flexel_least(size, limit);
        V(r->scale)[4 * i + 3] = *coordinates * o->atol[dof] + *rtol * allowed + FLEXEL_NO_ERROR;
    }
}

/* Errors of both formulas of some variables of y, as in runge_kutta.c. */
FLEXEL_INLINE void some_errors(const flexel_dop853 *o, size_t first, size_t count, const vec *h)
{
    vec *e5 = V(o->space), *e3 = e5 + count;
    for (size_t j = 0; j < count; j++) {
        errors(o, o->K, o->ny, first + j, e5 + j, e3 + j);
        e5[j] *= *h, e3[j] *= *h;
    }
}

/* The error of a sum of these variables, over what is allowed. */
FLEXEL_INLINE void error_of_sum(const flexel_dop853 *o, const vec *factors, const double *weight, size_t count, double scale,
                                const vec *share, const vec *rounded, vec *z)
{
    vec e5 = flexel_all(0), e3 = e5, enlarged = e5;
    for (size_t j = 0; j < count; j++) {
        e5 += factors[j] * V(o->space)[j], e3 += factors[j] * V(o->space)[count + j];
        enlarged += flexel_size(factors[j]) / weight[j];
    }
    const vec scaled = enlarged * scale, one = flexel_all(1), larger = flexel_most(scaled, one);
    both(&e5, &e3, z);
    *z = *z * scale / (*share + *rounded * larger);
}

/* The largest error of what is small beside others, over what its own range allows; see runge_kutta.c. */
FLEXEL_INLINE vec own_error(const flexel_lanes *l, const vec *part, const vec *finest, const vec *briefest, const vec *h)
{
    const flexel_work *s = l->work;
    const flexel_choice *c = l->choice;
    const flexel_dop853 *o = l->steps;
    const flexel_covered *m = o->covered;
    const vec *sizes = V(m->sizes_new), rtol = FLEXEL_OWN * *part, minor = rtol * FLEXEL_MINOR;
    const vec slightly = sizes[FLEXEL_RANGE] / FLEXEL_OWN, slowly = sizes[FLEXEL_FASTEST] / FLEXEL_OWN;
    const vec least = minor * sizes[FLEXEL_RANGE], slowest = minor * sizes[FLEXEL_FASTEST];
    const vec rounded = *finest * m->atol, of_rates = *briefest * m->atol;
    const double *of_y = c->weight + c->nr + c->np;
    vec largest = flexel_all(0), error;
    some_errors(o, 0, c->nd + c->nk, h);
    for (size_t i = 0; i < s->nf; i++) {
        if (!(o->apart[i] > 0))
            continue;
        const vec x = V(s->x)[i], high = flexel_most(V(m->high)[i], x), low = flexel_least(V(m->low)[i], x);
        const vec range = (high - low) * o->apart[i], share = rtol * range, allowed = flexel_most(share, least);
        error_of_sum(o, V(c->G) + i * c->columns, of_y, c->nd + c->nk, o->apart[i], &allowed, &rounded, &error);
        const vec larger = flexel_most(largest, error);
        largest = flexel_either(flexel_negative(range - slightly), larger, largest);
    }
    some_errors(o, c->nd + c->nk, c->nd, h);
    for (size_t i = 0; i < s->nf; i++) {
        if (!(o->apart[i] > 0))
            continue;
        const vec v = flexel_size(V(s->v)[i]), most = flexel_most(V(m->quick)[i], v), quick = most * o->apart[i];
        const vec share = rtol * quick, allowed = flexel_most(share, slowest);
        error_of_sum(o, V(c->X) + i * c->stride, of_y, c->nd, o->apart[i], &allowed, &of_rates, &error);
        const vec larger = flexel_most(largest, error);
        largest = flexel_either(flexel_negative(quick - slowly), larger, largest);
    }
    return largest;
}

/* The same of all variables, for what the motions have covered up to the ends of the steps. */
FLEXEL_INLINE void allow(const flexel_lanes *l, const vec *h, vec *error_own)
{
    const flexel_work *s = l->work;
    flexel_dop853 *o = l->steps;
    flexel_covered *m = o->covered;
    const size_t nq = l->choice->nd + l->choice->nk, laws = nq + l->choice->nd;
    const vec any = flexel_all(INFINITY);
    flexel_shares shares[FLEXEL_BLOCK];
    vec coordinates, rates, rtol, most, share, finest, briefest;
    flexel_lanes_look(l);
    for (size_t k = 0; k < FLEXEL_BLOCK; k++) {
        shares[k] = flexel_shares_of(m, m->sizes_new + k, FLEXEL_BLOCK, (*h)[k]);
        coordinates[k] = shares[k].coordinates, rates[k] = shares[k].rates, most[k] = shares[k].most;
        rtol[k] = shares[k].part * o->rtol, finest[k] = shares[k].finest, briefest[k] = shares[k].briefest;
    }
    allow_some(o, 0, nq, &coordinates, &rtol, &most);
    allow_rates(o, nq, laws, &rates, &rtol);
    for (size_t i = 0; i < s->nz; i++) {
        for (size_t k = 0; k < FLEXEL_BLOCK; k++)
            share[k] = flexel_share_of_states(&shares[k], V(m->states_new)[m->group[i]][k]);
        allow_some(o, laws + i, laws + i + 1, &share, &rtol, &any);
    }
    allow_rotations(l, &coordinates, &rates, &rtol, &most);
    *error_own = m->relative && !l->choice->saddle ? own_error(l, &rtol, &finest, &briefest, h) : flexel_all(0);
}

/* The norm of the errors of y, both embedded formulas together. */
FLEXEL_INLINE vec norm(const flexel_work *s, const flexel_dop853 *o, const vec *h)
{
    const flexel_rotations *r = &o->rotations;
    vec sum5 = flexel_all(0), sum3 = sum5, found = sum5;
    for (size_t i = 0; i < o->ny; i++) {
        vec e5, e3;
        errors(o, o->K, o->ny, i, &e5, &e3);
        const vec scale = V(o->scale)[i];
        sum5 += e5 / scale * (e5 / scale);
        sum3 += e3 / scale * (e3 / scale);
    }
    for (size_t i = 0; i < 4 * r->count; i++) {
        vec e5, e3;
        if (i % 4 < 3)
            errors(o, r->W, 3 * r->count, i / 4 * 3 + i % 4, &e5, &e3);
        else
            errors(o, o->V, s->nf, (size_t)r->at[i / 4 * 4 + (size_t)r->rest[i / 4]], &e5, &e3);
        const vec scale = V(r->scale)[i];
        sum5 += e5 / scale * (e5 / scale);
        sum3 += e3 / scale * (e3 / scale);
    }
    for (size_t k = 0; k < FLEXEL_BLOCK; k++)
        if (!(sum5[k] == 0 && sum3[k] == 0))
            found[k] = fabs((*h)[k]) * sum5[k] / sqrt((sum5[k] + 0.01 * sum3[k]) * (double)(o->ny + r->count));
    return found;
}

/* The errors of the step, from the rates at all stages, and how far the end is from its prediction. */
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
    allow(l, &trial->h, &trial->error_own);
    trial->error = norm(s, o, &trial->h);
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
    flexel_lanes_accepted_error(l);
    for (size_t stage = 1; stage <= FLEXEL_STAGES; stage++) {
        const int last = stage == FLEXEL_STAGES;
        double *y = last ? o->y_new : o->space;
        mask sign;
        const vec t = last ? trial->t + trial->h : trial->t + o->C[stage] * trial->h;
        place(l, &trial->h, stage, last ? o->B : o->A + stage * FLEXEL_STAGES, y);
        if (last) {
            memcpy(o->x_new, s->x, s->n * sizeof(vec));
            memcpy(o->rotations.w_new, o->rotations.stage, 3 * o->rotations.count * sizeof(vec));
        }
        rates(l, stage, &t, y, &trial->failed);
        flexel_lanes_sign(&l->choice->P, &sign);
        trial->changed |= sign ^ before;
    }
    judge(l, trial);
    flexel_lanes_account_end(l);
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
    flexel_lanes_cover(l, where);
    carry(o->ny, where, o->y_new, o->y);
    carry(3 * o->rotations.count, where, o->rotations.w_new, o->rotations.w);
    carry(3 * o->rotations.count, where, o->rotations.W + last * 3 * o->rotations.count, o->rotations.W);
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
