/* The right-hand side of the equations of motion in minimal coordinates; see explicit.h. */
#include "evaluate.h"
#include "explicit.h"
#include "rows.h"

#include <math.h>
#include <string.h>

static const double LONGEST_PREDICTION = 0.5; /* in natural scales */

int flexel_evaluate(flexel_work *s, flexel_choice *c, double t, const double *y, double *dy)
{
    const size_t nd = c->nd, nq = nd + c->nk, held = c->nr + c->np;
    s->t = t;
    memcpy(c->q, y, nq * sizeof(double));
    memcpy(c->qd, y + nq, nd * sizeof(double));
    memcpy(s->z, y + nq + nd, s->nz * sizeof(double));
    int failed = flexel_locate(s, c);
    if (!failed)
        failed = flexel_velocity(s, c);
    if (failed)
        return failed;
    flexel_forces(s, c);
    failed = flexel_accelerate(s, c);
    memcpy(dy, c->qd, nd * sizeof(double));
    for (size_t i = 0; i < c->nk; i++)
        dy[nd + i] = flexel_row_value(s, c->rows[held + nd + i], s->v);
    memcpy(dy + nq, c->qdd, nd * sizeof(double));
    memcpy(dy + nq + nd, s->zd, s->nz * sizeof(double));
    return failed;
}

/* The last position, moved by the changes of the targets to first order where they are small. */
static void predict(flexel_work *s, flexel_choice *c, const double *q)
{
    const size_t held = c->nr + c->np;
    memcpy(s->x, c->x_last, s->n * sizeof(double));
    c->reusable = 0;
    if (!c->predict)
        return;
    for (size_t i = 0; i < s->nf; i++) {
        const double target = i < c->nr ? 0 : i < held ? c->motion[i - c->nr] : q[i - held];
        c->residual[i] = target - c->target_last[i];
    }
    flexel_matrix_solve(&c->P, 1, c->residual, c->step, c->work);
    double largest = 0;
    for (size_t i = 0; i < s->nf; i++) {
        const double z = fabs(c->step[i]) * c->step_weight[i]; /* fmax would be a call */
        largest = z > largest ? z : largest;
    }
    c->reusable = largest < LONGEST_PREDICTION;
    if (c->reusable)
        for (size_t i = 0; i < s->nf; i++)
            s->x[i] += c->step[i];
}

int flexel_rhs(flexel_work *s, flexel_choice *c, double t, const double *y, double *dy)
{
    predict(s, c, y);
    for (size_t i = 0; i < c->nknown; i++)
        s->x[c->known[i]] = c->known_x[i];
    for (size_t i = 0; i < s->m; i++)
        s->unwrap_from[i] = c->e_last[i] + (t - c->t_last) * c->ed_last[i];
    c->predict = 0;
    const int failed = flexel_evaluate(s, c, t, y, dy);
    c->reusable = 0;
    if (failed)
        return failed;
    c->predict = 1;
    c->t_last = t;
    memcpy(c->x_last, s->x, s->n * sizeof(double));
    memcpy(c->e_last, s->e, s->m * sizeof(double));
    memcpy(c->ed_last, s->w, s->m * sizeof(double));
    memcpy(c->target_last, c->target, s->nf * sizeof(double));
    return FLEXEL_DONE;
}
