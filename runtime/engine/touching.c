/* Whether a step must end earlier for a contact; see touching.h, and touching.py and passed.py, which find out where. */
#include "touching.h"

#include "evaluate.h"

#include <math.h>

/* The ends of a step of one motion. */
typedef struct {
    const flexel_work *work;
    const double *x0, *e0, *w0, *x1;
    double h;
    size_t stride, i;
} step;

static int touches(const flexel_touching *t, const step *s)
{
    for (int k = 0; k < t->nrows; k++) {
        const size_t at = (size_t)t->rows[k] * s->stride + s->i, own = (size_t)k * s->stride + s->i;
        const double value = t->value[own], rate = t->rate[own], rest = t->rest[own];
        const double before = value * s->e0[at] + rate * s->w0[at] + rest;
        if (before * (value * s->work->e[at] + rate * s->work->w[at] + rest) < 0)
            return 1;
    }
    return 0;
}

/* The tangents of a gap over time at both ends meet below zero, as in `lowest_bound` of passed.py. */
static int tangents_meet(double g0, double r0, double g1, double r1, double h, double least)
{
    const double steeper = fabs(r0 + r1) / 2, first = r0 - steeper, last = r1 + steeper;
    return first < 0 && last > 0 && (last * g0 - first * g1 + first * last * h) / (last - first) < -least;
}

/* How much a gap grows along the chord of the step if its gradient is that at the end. */
static double along_chord(const step *s, int row)
{
    const flexel_work *w = s->work;
    double z = 0;
    for (int l = w->J_start[row]; l < w->J_start[row + 1]; l++) {
        const size_t at = (size_t)w->J_column[l] * s->stride + s->i;
        z += w->J[(size_t)l * s->stride + s->i] * (s->x1[at] - s->x0[at]);
    }
    return z;
}

/* Whether the gap to a convex body may have been closed between two ends at which it is open: seen from the end, the start
 * lies behind the surface, or the tangents over time meet below zero. */
static int may_be_passed(const flexel_touching *t, const step *s, int row)
{
    const size_t at = (size_t)row * s->stride + s->i;
    const double g0 = s->e0[at], g1 = s->work->e[at];
    return tangents_meet(g0, s->w0[at], g1, s->work->w[at], s->h, t->least) || g1 - along_chord(s, row) < -t->least;
}

/* Whether a contact that is approached at the start of a step, and closed there or at the end, is left again within it: it is
 * open at the end, or the body has come to its other side.  What rests on a plane that turns does not come closer, though
 * the chord leaves the plane. */
static int is_left_at_once(const flexel_touching *t, const step *s, int row)
{
    const size_t at = (size_t)row * s->stride + s->i;
    const double r0 = s->w0[at], closer = -r0 * s->h;
    return r0 < 0 && (s->work->e[at] > 0 || (closer > t->least && along_chord(s, row) > closer / 2));
}

static int passes(const flexel_touching *t, const step *s)
{
    int any = 0;
    for (int k = 0; k < t->ngaps; k++) {
        const size_t at = (size_t)t->gaps[k] * s->stride + s->i;
        const int open = s->e0[at] > 0 && s->work->e[at] > 0;
        const int found = open ? may_be_passed(t, s, t->gaps[k]) : !t->sees_inside && is_left_at_once(t, s, t->gaps[k]);
        any |= found;
        if (t->passed)
            t->passed[k] = (unsigned char)found;
    }
    return any;
}

int flexel_touching_look(const flexel_touching *t, const flexel_work *work, const double *x0, const double *e0,
                         const double *w0, const double *x1, double h, size_t stride, size_t i)
{
    const step s = {work, x0, e0, w0, x1, h, stride, i};
    return (touches(t, &s) ? FLEXEL_TOUCHES : 0) | (passes(t, &s) ? FLEXEL_PASSES : 0);
}

/* The cubic through both ends. */
static double between(double part, double y0, double r0, double y1, double r1)
{
    const double weight = part * part * (3 - 2 * part), bend = part * (1 - part);
    return (1 - weight) * y0 + weight * y1 + bend * ((1 - part) * r0 - part * r1);
}

double flexel_path_value(flexel_work *work, const flexel_path *p, int row, double part)
{
    for (size_t i = 0; i < work->n; i++)
        work->x[i] = between(part, p->x0[i], p->v0[i], p->x1[i], p->v1[i]);
    for (size_t i = 0; i < work->m; i++)
        work->unwrap_from[i] = between(part, p->e0[i], p->w0[i], p->e1[i], p->w1[i]);
    flexel_position(work);
    return work->e[row];
}

/* A line through two points, continued to a third place. */
static double line(double x0, double y0, double x1, double y1, double x)
{
    return y0 + (y1 - y0) / (x1 - x0) * (x - x0);
}

/* Lower bound of a function with values y at four places x by its secants continued, if it is convex; none if it is not. */
static double convex_bound(const double *x, const double *y)
{
    const double first = line(x[1], y[1], x[2], y[2], x[0]), last = line(x[1], y[1], x[2], y[2], x[3]);
    if (y[0] < first || y[3] < last)
        return -INFINITY;
    const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[3] - y[2]) / (x[3] - x[2]);
    if (!(left < right))
        return fmin(first, last);
    const double at = (y[2] - y[1] + left * x[1] - right * x[2]) / (left - right);
    return fmin(fmin(first, last), y[1] + left * (fmin(fmax(at, x[1]), x[2]) - x[1]));
}

double flexel_path_lowest(flexel_work *work, const flexel_path *p, int row, double near, double *lowest)
{
    static const double GOLDEN = 0.6180339887498949, EXACT = 1e-7; /* of the whole path */
    double x[4] = {0, 1 - GOLDEN, GOLDEN, 1};
    double y[4] = {p->e0[row], 0, 0, p->e1[row]};
    y[1] = flexel_path_value(work, p, row, x[1]);
    y[2] = flexel_path_value(work, p, row, x[2]);
    while (x[3] - x[0] > EXACT && convex_bound(x, y) < near) {
        if (y[1] < y[2]) {
            x[3] = x[2], y[3] = y[2];
            x[2] = x[1], y[2] = y[1];
            x[1] = x[3] - GOLDEN * (x[3] - x[0]);
            y[1] = flexel_path_value(work, p, row, x[1]);
        } else {
            x[0] = x[1], y[0] = y[1];
            x[1] = x[2], y[1] = y[2];
            x[2] = x[0] + GOLDEN * (x[3] - x[0]);
            y[2] = flexel_path_value(work, p, row, x[2]);
        }
    }
    *lowest = fmin(y[1], y[2]);
    return y[1] < y[2] ? x[1] : x[2];
}
