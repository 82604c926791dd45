/* What rows of steps of all methods look at; see in_row.h. */
#include "in_row.h"

#include <math.h>

int flexel_row_goes_on(const flexel_in_row *r, double t)
{
    return t < r->end && r->taken < r->most && r->amplification <= r->allowed;
}

double flexel_row_shortest(const flexel_in_row *r, double t)
{
    const double size = fabs(t);
    return fmax(r->shortest, 10 * (nextafter(size, INFINITY) - size));
}

int flexel_row_touches(const flexel_in_row *r, const double *x0, const double *e0, const double *w0, const double *x1, double h)
{
    const flexel_touching *t = r->touching;
    return (t->nrows || t->ngaps) && flexel_touching_look(t, r->work, x0, e0, w0, x1, h, 1, 0);
}

int flexel_row_dips(flexel_in_row *r)
{
    const flexel_dips before = *r->dips;
    const int looks = flexel_dips_look(r->dips, &r->choice->P, r->known);
    const double largest = fmax(r->dips->size, r->largest);
    if (looks || largest - r->dips->size >= r->deep) {
        *r->dips = before;
        return 1;
    }
    r->largest = largest, r->known = 1;
    return 0;
}
