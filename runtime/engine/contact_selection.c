/* Gaps of the contacts that are left out; see contact_selection.h. */
#include "contact_selection.h"
#include "evaluate.h"

#include <math.h>

enum { LANES = FLEXEL_BLOCK };

static double smallest_in(const flexel_contacts *c, size_t block)
{
    const size_t left = c->count - block * LANES, lanes = left < LANES ? left : LANES;
    const double *gaps = c->gaps + block * c->ngaps * LANES;
    double least[LANES], smallest = INFINITY;
    for (size_t l = 0; l < LANES; l++)
        least[l] = INFINITY;
    for (size_t i = 0; i < c->ngaps; i++)
        for (size_t l = 0; l < LANES; l++)
            least[l] = gaps[i * LANES + l] < least[l] ? gaps[i * LANES + l] : least[l];
    for (size_t l = 0; l < lanes; l++)
        smallest = fmin(smallest, least[l] / c->length[block * LANES + l]);
    return smallest;
}

double flexel_far_gap(const flexel_work *s, size_t ntypes, const flexel_contacts *types)
{
    double smallest = INFINITY;
    for (const flexel_contacts *c = types; c < types + ntypes; c++)
        for (size_t block = 0; block < c->position->nblocks; block++)
            if (!c->selected[block]) {
                flexel_take_blocks(&s->coordinates, c->position, block, 1, s->x, s->x8);
                flexel_run_blocks(c->position, block, 1);
                smallest = fmin(smallest, smallest_in(c, block));
            }
    return smallest;
}
