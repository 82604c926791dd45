/* Whether a step must end earlier for a contact; see touching.h, and touching.py and passed.py, which find out where. */
#include "touching.h"

#include <math.h>

static int touches(const flexel_touching *t, const double *e0, const double *w0, const double *e1, const double *w1,
                   size_t stride, size_t i)
{
    for (int k = 0; k < t->nrows; k++) {
        const size_t at = (size_t)t->rows[k] * stride + i, own = (size_t)k * stride + i;
        const double value = t->value[own], rate = t->rate[own], rest = t->rest[own];
        if ((value * e0[at] + rate * w0[at] + rest) * (value * e1[at] + rate * w1[at] + rest) < 0)
            return 1;
    }
    return 0;
}

/* The tangents of a gap at both ends meet below zero, as in `lowest_bound` of passed.py. */
static int meets(const flexel_touching *t, double g0, double r0, double g1, double r1, double h)
{
    const double steeper = fabs(r0 + r1) / 2, first = r0 - steeper, last = r1 + steeper;
    return g0 > 0 && first < 0 && last > 0 && (last * g0 - first * g1 + first * last * h) / (last - first) < -t->least;
}

static int passes(const flexel_touching *t, const double *e0, const double *w0, const double *e1, const double *w1,
                  double h, size_t stride, size_t i)
{
    for (int k = 0; k < t->ngaps; k++) {
        const size_t at = (size_t)t->gaps[k] * stride + i;
        const int begun = !t->sees_inside && e0[at] <= 0 && w0[at] < 0;
        if (e1[at] > 0 && (begun || meets(t, e0[at], w0[at], e1[at], w1[at], h)))
            return 1;
    }
    return 0;
}

int flexel_touching_look(const flexel_touching *t, const double *e0, const double *w0, const double *e1, const double *w1,
                         double h, size_t stride, size_t i)
{
    return (touches(t, e0, w0, e1, w1, stride, i) ? FLEXEL_TOUCHES : 0) |
           (passes(t, e0, w0, e1, w1, h, stride, i) ? FLEXEL_PASSES : 0);
}
