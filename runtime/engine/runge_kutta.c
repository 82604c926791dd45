/* Steps of DOP853 with the coordinates as a shadow; see runge_kutta.h. */
#include "runge_kutta.h"

#include <math.h>
#include <string.h>

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

/* The state at a stage: y into `space`, coordinates and deformations into the workspace. */
static void place(flexel_work *s, flexel_dop853 *o, double h, size_t count, const double *share, double *y)
{
    combine(o->ny, o->y, h, count, share, o->K, y);
    combine(s->nf, o->x, h, count, share, o->V, s->x);
    combine(s->nperiodic, o->e, h, count, share, o->turning, o->e_new);
    for (size_t i = 0; i < s->nperiodic; i++)
        s->near[s->periodic[i]] = o->e_new[i];
}

static int rates(flexel_work *s, flexel_choice *c, flexel_dop853 *o, size_t stage, double t, const double *y)
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
    for (size_t i = 0; i < s->nperiodic; i++)
        o->turning[stage * s->nperiodic + i] = s->w[s->periodic[i]];
    return FLEXEL_DONE;
}

int flexel_dop853_begin(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t)
{
    memcpy(s->x, o->x, s->n * sizeof(double));
    for (size_t i = 0; i < s->nperiodic; i++)
        s->near[s->periodic[i]] = o->e[i];
    const int failed = rates(s, c, o, 0, t, o->y);
    if (!failed)
        o->sign = flexel_matrix_sign(&c->P);
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

/* Largest error of variables with rates K, each by itself. */
static double largest_error(const flexel_dop853 *o, const double *K, size_t n, const double *weight, int inverse, double h)
{
    double largest = 0;
    for (size_t i = 0; i < n; i++) {
        double e5, e3;
        errors(o, K, n, i, h, &e5, &e3);
        const double size = sqrt(e5 * e5 + 0.01 * e3 * e3), z = size > 0 ? e5 * e5 / size : 0;
        const double scaled = !weight ? z : inverse ? z / weight[i] : z * weight[i];
        largest = scaled <= largest ? largest : scaled;
    }
    return largest;
}

static double norm(const flexel_dop853 *o, double h)
{
    double sum5 = 0, sum3 = 0;
    for (size_t i = 0; i < o->ny; i++) {
        double e5, e3;
        errors(o, o->K, o->ny, i, 1, &e5, &e3);
        const double scale = o->atol[i] + o->rtol * fmax(fabs(o->y[i]), fabs(o->y_new[i]));
        sum5 += e5 / scale * (e5 / scale);
        sum3 += e3 / scale * (e3 / scale);
    }
    return sum5 == 0 && sum3 == 0 ? 0 : fabs(h) * sum5 / sqrt((sum5 + 0.01 * sum3) * (double)o->ny);
}

/* The errors of the step, from the rates at all stages. */
static void judge(flexel_work *s, flexel_dop853 *o, double h)
{
    o->fastest = 0;
    for (size_t i = 0; i < s->nf; i++)
        o->fastest = fmax(o->fastest, fabs(s->v[i]) * o->weight[i]);
    o->error = norm(o, h);
    o->error_x = largest_error(o, o->V, s->nf, o->weight, 0, h);
    o->error_v = largest_error(o, o->W, s->nf, o->weight, 0, h);
    o->error_turns = largest_error(o, o->turning, s->nperiodic, s->period, 1, h);
}

int flexel_dop853_step(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h)
{
    o->changed = 0;
    memcpy(s->x + s->nf, o->x + s->nf, (s->n - s->nf) * sizeof(double));
    for (size_t stage = 1; stage <= FLEXEL_STAGES; stage++) {
        const int last = stage == FLEXEL_STAGES;
        place(s, o, h, stage, last ? o->B : o->A + stage * FLEXEL_STAGES, last ? o->y_new : o->space);
        if (last)
            memcpy(o->x_new, s->x, s->n * sizeof(double));
        const int failed = rates(s, c, o, stage, last ? t + h : t + o->C[stage] * h, last ? o->y_new : o->space);
        if (failed)
            return failed;
        if (flexel_matrix_sign(&c->P) != o->sign)
            o->changed |= (size_t)1 << stage;
        if (o->determinant)
            o->determinant[stage] = flexel_matrix_logarithm(&c->P);
    }
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
    judge(s, o, h);
    return FLEXEL_DONE;
}

void flexel_dop853_accept(flexel_work *s, flexel_dop853 *o)
{
    memcpy(o->y, o->y_new, o->ny * sizeof(double));
    memcpy(o->x, o->x_new, s->n * sizeof(double));
    memcpy(o->e, o->e_new, s->nperiodic * sizeof(double));
    memcpy(o->K, o->K + FLEXEL_STAGES * o->ny, o->ny * sizeof(double));
    memcpy(o->V, o->V + FLEXEL_STAGES * s->nf, s->nf * sizeof(double));
    memcpy(o->W, o->W + FLEXEL_STAGES * s->nf, s->nf * sizeof(double));
    memcpy(o->turning, o->turning + FLEXEL_STAGES * s->nperiodic, s->nperiodic * sizeof(double));
}

/* Largest entry, in natural scales, of coordinates for a change of the degrees of freedom by plus or minus their scales. */
static double reach_of_signs(const flexel_work *s, flexel_choice *c, size_t period)
{
    const size_t held = c->nr + c->np;
    double largest = 0;
    for (size_t i = 0; i < s->nf; i++)
        c->residual[i] = i < held ? 0 : (i / period % 2 ? -1 : 1) / c->weight[i];
    flexel_matrix_solve(&c->P, 1, c->residual, c->step, c->work);
    for (size_t i = 0; i < s->nf; i++)
        largest = fmax(largest, fabs(c->step[i]) * c->step_weight[i]);
    return largest;
}

double flexel_reach(const flexel_work *s, flexel_choice *c)
{
    if (c->saddle) /* the columns are not there: an estimate */
        return fmax(reach_of_signs(s, c, 1), fmax(reach_of_signs(s, c, 2), reach_of_signs(s, c, s->nf + 1)));
    const size_t nq = c->nd + c->nk, count = c->columns, held = c->nr + c->np;
    double largest = 0;
    for (size_t i = 0; i < s->nf; i++) {
        double z = 0;
        for (size_t j = 0; j < nq; j++)
            z += fabs(c->G[i * count + j]) / c->weight[held + j];
        largest = fmax(largest, z * c->step_weight[i]);
    }
    return largest;
}
