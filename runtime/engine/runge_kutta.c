/* Steps of DOP853 with predicted coordinates; see runge_kutta.h. */
#include "runge_kutta.h"

#include <math.h>
#include <string.h>

/* Range of the determinant in a step that is close to a flat position, a logarithm to base two. */
static const double STEEP = 0.25;

/* out = start + h sum of share[j] rates[j], j < count */
FLEXEL_CLONES
static void combine(size_t n, const double *restrict start, double h, size_t count, const double *restrict share,
                    const double *restrict rates, double *restrict out)
{
    memset(out, 0, n * sizeof(double));
    for (size_t j = 0; j < count; j++) {
        const double z = share[j], *restrict row = rates + j * n;
        if (z != 0)
#pragma omp simd
            for (size_t i = 0; i < n; i++)
                out[i] += z * row[i];
    }
    for (size_t i = 0; i < n; i++)
        out[i] = start[i] + h * out[i];
}

/* Euler parameters of free rotations at a stage have length one, their rates are those of the angular velocities. */
static void place_rotations(flexel_work *s, const flexel_choice *c, flexel_dop853 *o, double h, size_t count,
                            const double *share, double *y)
{
    const flexel_rotations *r = &o->rotations;
    double *rates = y + c->nd + c->nk;
    combine(3 * r->count, r->w, h, count, share, r->W, r->stage);
    for (size_t i = 0; i < r->count; i++) {
        const int *at = r->at + 4 * i;
        double L[4], v[4];
        const double size = sqrt(s->x[at[0]] * s->x[at[0]] + s->x[at[1]] * s->x[at[1]] + s->x[at[2]] * s->x[at[2]] +
                                 s->x[at[3]] * s->x[at[3]]);
        for (size_t k = 0; k < 4; k++)
            s->x[at[k]] = L[k] = s->x[at[k]] / size;
        FLEXEL_TURN(v, L, (r->stage + 3 * i));
        for (size_t k = 0; k < 3; k++) {
            y[r->dof[3 * i + k]] = L[r->part[3 * i + k]];
            rates[r->dof[3 * i + k]] = v[r->part[3 * i + k]];
        }
    }
}

/* Twice E times rates, or second rates, of the coordinates. */
static void spins(const flexel_work *s, const flexel_rotations *r, const double *rates, double *w)
{
    for (size_t i = 0; i < r->count; i++) {
        const int *at = r->at + 4 * i;
        const double L[4] = {s->x[at[0]], s->x[at[1]], s->x[at[2]], s->x[at[3]]};
        const double v[4] = {rates[at[0]], rates[at[1]], rates[at[2]], rates[at[3]]};
        FLEXEL_SPIN(w + 3 * i, L, v);
    }
}

/* The state at a stage: y into `space`, coordinates and deformations into the workspace. */
void flexel_dop853_place(flexel_work *s, const flexel_choice *c, flexel_dop853 *o, double h, size_t count,
                         const double *share, double *y)
{
    combine(o->ny, o->y, h, count, share, o->K, y);
    combine(s->nf, o->x, h, count, share, o->V, s->x);
    combine(s->nperiodic, o->e, h, count, share, o->turning, o->e_new);
    for (size_t i = 0; i < s->nperiodic; i++)
        s->unwrap_from[s->periodic[i]] = o->e_new[i];
    place_rotations(s, c, o, h, count, share, y);
}

int flexel_dop853_rates(flexel_work *s, flexel_choice *c, flexel_dop853 *o, size_t stage, double t, const double *y)
{
    const double *given = o->given + stage * o->ngiven;
    memcpy(c->motion, given, 3 * c->np * sizeof(double));
    memcpy(c->loads, given + 3 * c->np, c->nloads * sizeof(double));
    o->stage = stage;
    o->evaluations++;
    const int failed = flexel_evaluate(s, c, t, y, o->K + stage * o->ny);
    if (failed)
        return failed;
    memcpy(o->V + stage * s->nf, s->v, s->nf * sizeof(double));
    memcpy(o->W + stage * s->nf, s->a, s->nf * sizeof(double));
    spins(s, &o->rotations, s->a, o->rotations.W + stage * 3 * o->rotations.count);
    for (size_t i = 0; i < s->nperiodic; i++)
        o->turning[stage * s->nperiodic + i] = s->w[s->periodic[i]];
    flexel_account_stage(o->account, s, c, stage);
    return FLEXEL_DONE;
}

int flexel_dop853_begin(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t)
{
    memcpy(s->x, o->x, s->n * sizeof(double));
    for (size_t i = 0; i < s->nperiodic; i++)
        s->unwrap_from[s->periodic[i]] = o->e[i];
    const int failed = flexel_dop853_rates(s, c, o, 0, t, o->y);
    if (!failed) {
        o->sign = flexel_matrix_sign(&c->P);
        spins(s, &o->rotations, s->v, o->rotations.w);
        flexel_account_begin(o->account, s, c);
    }
    if (!failed && o->determinant)
        o->determinant[0] = flexel_matrix_logarithm(&c->P);
    return failed;
}

/* The error of one variable, by both embedded formulas, divided by its scale. */
static void errors(const flexel_dop853 *o, const double *K, size_t n, size_t i, double h, double *e5, double *e3)
{
    *e5 = *e3 = 0;
    for (size_t j = 0; j <= FLEXEL_STAGES; j++)
        *e5 += o->E5[j] * K[j * n + i], *e3 += o->E3[j] * K[j * n + i];
    *e5 *= h, *e3 *= h;
}

/* Error of one variable by itself, from those of both formulas. */
static double both(double e5, double e3)
{
    const double size = sqrt(e5 * e5 + 0.01 * e3 * e3);
    return size > 0 ? e5 * e5 / size : 0;
}

/* Largest error of variables with rates K, each by itself. */
static double largest_error(const flexel_dop853 *o, const double *K, size_t n, const double *weight, int inverse, double h)
{
    double largest = 0;
    for (size_t i = 0; i < n; i++) {
        double e5, e3;
        errors(o, K, n, i, h, &e5, &e3);
        const double z = both(e5, e3), scaled = !weight ? z : inverse ? z / weight[i] : z * weight[i];
        largest = scaled <= largest ? largest : scaled;
    }
    return largest;
}

/* Allowed errors of some variables: shares of the absolute tolerances, and of values up to `most` times these. */
static void allow_some(flexel_dop853 *o, size_t first, size_t end, double share, double rtol, double most)
{
    for (size_t i = first; i < end; i++) {
        const double size = fmax(fabs(o->y[i]), fabs(o->y_new[i]));
        o->scale[i] = share * o->atol[i] + rtol * fmin(size, most * o->atol[i]) + FLEXEL_NO_ERROR;
    }
}

/* Those of rates: relative to how far they have moved, if the motion is relative to itself. A mass that vibrates on a vehicle
 * is as exact as on the ground. */
static void allow_rates(flexel_dop853 *o, size_t first, size_t end, double share, double rtol)
{
    for (size_t i = first; i < end; i++) {
        const double size = fmax(fabs(o->y[i]), fabs(o->y_new[i])), moved = flexel_moved(o->covered, i, o->y_new[i]);
        o->scale[i] = share * o->atol[i] + rtol * (o->covered->relative ? fmin(size, moved) : size) + FLEXEL_NO_ERROR;
    }
}

/* Those of angular velocities, instead of rates of Euler parameters which are half as large, and those of the Euler parameters
 * that are not in y. */
static void allow_rotations(const flexel_work *s, const flexel_choice *c, flexel_dop853 *o, const flexel_shares *shares)
{
    const flexel_rotations *r = &o->rotations;
    const size_t nq = c->nd + c->nk;
    const double rtol = shares->part * o->rtol;
    for (size_t i = 0; i < r->count; i++) {
        const int dof = r->dof[3 * i], rest = r->at[4 * i + (size_t)r->rest[i]];
        for (size_t k = 0; k < 3; k++) {
            const double size = fmax(fabs(r->w[3 * i + k]), fabs(r->w_new[3 * i + k]));
            r->scale[4 * i + k] = shares->rates * o->atol[nq + (size_t)dof] + 0.5 * rtol * size + FLEXEL_NO_ERROR;
            o->scale[nq + (size_t)r->dof[3 * i + k]] = INFINITY;
        }
        const double size = fmax(fabs(o->x[rest]), fabs(s->x[rest]));
        r->scale[4 * i + 3] =
            shares->coordinates * o->atol[dof] + rtol * fmin(size, shares->most * o->atol[dof]) + FLEXEL_NO_ERROR;
    }
}

/* Errors of both formulas of some variables of y: e5 and then e3 in `space`. */
static void some_errors(const flexel_dop853 *o, size_t first, size_t count, double h)
{
    for (size_t j = 0; j < count; j++)
        errors(o, o->K, o->ny, first + j, h, o->space + j, o->space + count + j);
}

/* The error of a sum of these variables, over what is allowed: `share`, or `rounded` where each may err by its scale. */
static double error_of_sum(const flexel_dop853 *o, const double *factors, const double *weight, size_t count, double scale,
                           double share, double rounded)
{
    double e5 = 0, e3 = 0, enlarged = 0;
    for (size_t j = 0; j < count; j++) {
        e5 += factors[j] * o->space[j], e3 += factors[j] * o->space[count + j];
        enlarged += fabs(factors[j]) / weight[j];
    }
    return both(e5, e3) * scale / (share + rounded * fmax(enlarged * scale, 1));
}

/* The largest error, over what its own range allows, of a coordinate or rate that is small beside others: it is as exact as
 * these, relative to itself. With sparse factors nothing says how they follow from y. */
static double own_error(const flexel_work *s, const flexel_choice *c, flexel_dop853 *o, const flexel_shares *shares, double h)
{
    const flexel_covered *m = o->covered;
    const double rtol = FLEXEL_OWN * (shares->part * o->rtol), minor = rtol * FLEXEL_MINOR, *sizes = m->sizes_new;
    const double slightly = sizes[FLEXEL_RANGE] / FLEXEL_OWN, slowly = sizes[FLEXEL_FASTEST] / FLEXEL_OWN;
    const double least = minor * sizes[FLEXEL_RANGE], slowest = minor * sizes[FLEXEL_FASTEST], *of_y = c->weight + c->nr + c->np;
    const double rounded = shares->finest * m->atol, of_rates = shares->briefest * m->atol;
    double largest = 0;
    some_errors(o, 0, c->nd + c->nk, h);
    for (size_t i = 0; i < s->nf; i++) {
        const double range = (fmax(m->high[i], s->x[i]) - fmin(m->low[i], s->x[i])) * o->apart[i];
        if (o->apart[i] > 0 && range < slightly)
            largest = fmax(largest, error_of_sum(o, c->G + i * c->columns, of_y, c->nd + c->nk, o->apart[i],
                                                 fmax(rtol * range, least), rounded));
    }
    some_errors(o, c->nd + c->nk, c->nd, h);
    for (size_t i = 0; i < s->nf; i++) {
        const double quick = fmax(m->quick[i], fabs(s->v[i])) * o->apart[i];
        if (o->apart[i] > 0 && quick < slowly)
            largest = fmax(largest, error_of_sum(o, c->X + i * c->stride, of_y, c->nd, o->apart[i],
                                                 fmax(rtol * quick, slowest), of_rates));
    }
    return largest;
}

/* Whether the determinant, where it is asked for, changes so much in the step that G says nothing about errors in it. */
static int close_to_flat(const flexel_dop853 *o)
{
    if (!o->determinant)
        return 0;
    double least = INFINITY, most = -INFINITY;
    for (size_t i = 0; i <= FLEXEL_STAGES; i++) {
        least = fmin(least, o->determinant[i]);
        most = fmax(most, o->determinant[i]);
    }
    return !(most - least < STEEP);
}

/* The same of all variables, for what the motion has covered up to the end of the step. */
static void allow(const flexel_work *s, const flexel_choice *c, flexel_dop853 *o, double h)
{
    flexel_covered *m = o->covered;
    const size_t nq = c->nd + c->nk, laws = nq + c->nd;
    flexel_covered_look(s, m, o->weight, s->x, s->v, o->y_new + laws);
    const flexel_shares shares = flexel_shares_of(m, m->sizes_new, 1, h);
    const double rtol = shares.part * o->rtol;
    allow_some(o, 0, nq, shares.coordinates, rtol, shares.most);
    allow_rates(o, nq, laws, shares.rates, rtol);
    for (size_t i = 0; i < s->nz; i++) {
        const double share = flexel_share_of_states(&shares, m->states_new[m->group[i]]);
        allow_some(o, laws + i, laws + i + 1, share, rtol, INFINITY);
    }
    allow_rotations(s, c, o, &shares);
    o->error_own = m->relative && !c->saddle && !close_to_flat(o) ? own_error(s, c, o, &shares, h) : 0;
}

static double norm(const flexel_work *s, const flexel_dop853 *o, double h)
{
    const flexel_rotations *r = &o->rotations;
    double sum5 = 0, sum3 = 0;
    for (size_t i = 0; i < o->ny; i++) {
        double e5, e3;
        errors(o, o->K, o->ny, i, 1, &e5, &e3);
        const double scale = o->scale[i];
        sum5 += e5 / scale * (e5 / scale);
        sum3 += e3 / scale * (e3 / scale);
    }
    for (size_t i = 0; i < 4 * r->count; i++) {
        double e5, e3;
        if (i % 4 < 3)
            errors(o, r->W, 3 * r->count, i / 4 * 3 + i % 4, 1, &e5, &e3);
        else
            errors(o, o->V, s->nf, (size_t)r->at[i / 4 * 4 + (size_t)r->rest[i / 4]], 1, &e5, &e3);
        const double scale = r->scale[i];
        sum5 += e5 / scale * (e5 / scale);
        sum3 += e3 / scale * (e3 / scale);
    }
    return sum5 == 0 && sum3 == 0 ? 0 : fabs(h) * sum5 / sqrt((sum5 + 0.01 * sum3) * (double)(o->ny + r->count));
}

/* The errors of the step, from the rates at all stages. */
static void judge(const flexel_work *s, const flexel_choice *c, flexel_dop853 *o, double h)
{
    o->fastest = 0;
    for (size_t i = 0; i < s->nf; i++)
        o->fastest = fmax(o->fastest, fabs(s->v[i]) * o->weight[i]);
    allow(s, c, o, h);
    o->error = norm(s, o, h);
    o->error_x = largest_error(o, o->V, s->nf, o->weight, 0, h);
    o->error_v = largest_error(o, o->W, s->nf, o->weight, 0, h);
    o->error_turns = largest_error(o, o->turning, s->nperiodic, s->period, 1, h);
}

int flexel_dop853_again(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h)
{
    o->changed = 0;
    c->predict = 0; /* P will not belong to the last right-hand side */
    flexel_matrix_reset(&c->P); /* a step depends on its start alone, not on the order of pivots that others have left */
    memcpy(s->x + s->nf, o->x + s->nf, (s->n - s->nf) * sizeof(double));
    for (size_t stage = 1; stage <= FLEXEL_STAGES; stage++) {
        const int last = stage == FLEXEL_STAGES;
        flexel_dop853_place(s, c, o, h, stage, last ? o->B : o->A + stage * FLEXEL_STAGES, last ? o->y_new : o->space);
        if (last) {
            memcpy(o->x_new, s->x, s->n * sizeof(double));
            memcpy(o->rotations.w_new, o->rotations.stage, 3 * o->rotations.count * sizeof(double));
        }
        const int failed = flexel_dop853_rates(s, c, o, stage, last ? t + h : t + o->C[stage] * h, last ? o->y_new : o->space);
        if (failed)
            return failed;
        if (flexel_matrix_sign(&c->P) != o->sign)
            o->changed |= (size_t)1 << stage;
        if (o->determinant)
            o->determinant[stage] = flexel_matrix_logarithm(&c->P);
    }
    return FLEXEL_DONE;
}

int flexel_dop853_step(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h)
{
    const int failed = flexel_dop853_again(s, c, o, t, h);
    if (failed)
        return failed;
    combine(s->nf, o->V, h, FLEXEL_STAGES, o->B, o->W, o->space);
    o->defect = o->defect_v = 0;
    for (size_t i = 0; i < s->nf; i++) {
        const double z = fabs(s->x[i] - o->x_new[i]) * o->weight[i], zd = fabs(s->v[i] - o->space[i]) * o->weight[i];
        if (!(z <= o->defect)) {
            o->defect = z;
            o->farthest = i;
        }
        o->defect_v = zd <= o->defect_v ? o->defect_v : zd;
    }
    memcpy(o->x_new, s->x, s->n * sizeof(double));
    for (size_t i = 0; i < s->nperiodic; i++)
        o->e_new[i] = s->e[s->periodic[i]];
    judge(s, c, o, h);
    o->h = h;
    flexel_account_end(o->account, s, c);
    return FLEXEL_DONE;
}

void flexel_dop853_accept(flexel_work *s, flexel_dop853 *o)
{
    flexel_account_accept(o->account, o->h);
    flexel_covered_accept(s, o->covered, o->x_new, o->V + FLEXEL_STAGES * s->nf, o->h);
    for (size_t i = 0; i < o->ny; i++)
        flexel_covered_value(o->covered, i, o->y_new[i]);
    memcpy(o->y, o->y_new, o->ny * sizeof(double));
    memcpy(o->x, o->x_new, s->n * sizeof(double));
    memcpy(o->e, o->e_new, s->nperiodic * sizeof(double));
    memcpy(o->K, o->K + FLEXEL_STAGES * o->ny, o->ny * sizeof(double));
    memcpy(o->rotations.w, o->rotations.w_new, 3 * o->rotations.count * sizeof(double));
    memcpy(o->rotations.W, o->rotations.W + FLEXEL_STAGES * 3 * o->rotations.count, 3 * o->rotations.count * sizeof(double));
    memcpy(o->V, o->V + FLEXEL_STAGES * s->nf, s->nf * sizeof(double));
    memcpy(o->W, o->W + FLEXEL_STAGES * s->nf, s->nf * sizeof(double));
    memcpy(o->turning, o->turning + FLEXEL_STAGES * s->nperiodic, s->nperiodic * sizeof(double));
}

/* Largest entry, in natural scales, of coordinates for a change of some rows of P by plus or minus their scales. */
static double amplification_of_signs(const flexel_work *s, flexel_choice *c, size_t first, size_t end, size_t period)
{
    double largest = 0;
    for (size_t i = 0; i < s->nf; i++)
        c->residual[i] = i < first || i >= end ? 0 : (i / period % 2 ? -1 : 1) / c->weight[i];
    flexel_matrix_solve(&c->P, 1, c->residual, c->step, c->work);
    for (size_t i = 0; i < s->nf; i++)
        largest = fmax(largest, fabs(c->step[i]) * c->step_weight[i]);
    return largest;
}

/* An estimate of the same for the worst signs. */
static double amplification_of_rows(const flexel_work *s, flexel_choice *c, size_t first, size_t end)
{
    const double rough = fmax(amplification_of_signs(s, c, first, end, 1), amplification_of_signs(s, c, first, end, 2));
    return fmax(rough, amplification_of_signs(s, c, first, end, s->nf + 1));
}

double flexel_sensitivity(const flexel_work *s, flexel_choice *c)
{
    return amplification_of_rows(s, c, 0, c->nr + c->np);
}

double flexel_amplification(const flexel_work *s, flexel_choice *c)
{
    const size_t nq = c->nd + c->nk, count = c->columns, held = c->nr + c->np;
    if (c->saddle) /* the columns are not there */
        return amplification_of_rows(s, c, held, s->nf);
    double largest = 0;
    for (size_t i = 0; i < s->nf; i++) {
        double z = 0;
        for (size_t j = 0; j < nq; j++)
            z += fabs(c->G[i * count + j]) / c->weight[held + j];
        largest = fmax(largest, z * c->step_weight[i]);
    }
    return largest;
}
