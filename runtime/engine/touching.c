/* Whether a step must end earlier for a contact; see touching.h, and touching.py and passed.py, which find out where. */
#include "touching.h"

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
 * open at the end, or the body has come to its other side. */
static int is_left_at_once(const step *s, int row)
{
    const size_t at = (size_t)row * s->stride + s->i;
    const double r0 = s->w0[at];
    return r0 < 0 && (s->work->e[at] > 0 || along_chord(s, row) > -r0 * s->h / 2);
}

static int passes(const flexel_touching *t, const step *s)
{
    int any = 0;
    for (int k = 0; k < t->ngaps; k++) {
        const size_t at = (size_t)t->gaps[k] * s->stride + s->i;
        const int open = s->e0[at] > 0 && s->work->e[at] > 0;
        const int found = open ? may_be_passed(t, s, t->gaps[k]) : !t->sees_inside && is_left_at_once(s, t->gaps[k]);
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
