/* What the motions in all lanes have covered so far; see covered.h. */
#include "lanes_inside.h"

#include <math.h>
#include <string.h>

FLEXEL_CLONES
void flexel_lanes_look(const flexel_lanes *l)
{
    const flexel_work *s = l->work;
    flexel_covered *c = l->steps->covered;
    const double *weight = l->steps->weight, *y = l->steps->y_new;
    vec range = V(c->sizes)[FLEXEL_RANGE], farthest = V(c->sizes)[FLEXEL_FARTHEST], fastest = V(c->sizes)[FLEXEL_FASTEST];
    for (size_t i = 0; i < s->nf; i++) {
        const vec x = V(s->x)[i], high = flexel_most(V(c->high)[i], x), low = flexel_least(V(c->low)[i], x);
        const vec moved = (high - low) * weight[i], far = flexel_size(x) * weight[i];
        const vec fast = flexel_size(V(s->v)[i]) * weight[i];
        range = flexel_most(range, moved);
        farthest = flexel_most(farthest, far);
        fastest = flexel_most(fastest, fast);
    }
    V(c->sizes_new)[FLEXEL_RANGE] = range;
    V(c->sizes_new)[FLEXEL_FARTHEST] = farthest;
    V(c->sizes_new)[FLEXEL_FASTEST] = fastest;
    V(c->sizes_new)[FLEXEL_TAKEN] = V(c->sizes)[FLEXEL_TAKEN];
    V(c->sizes_new)[FLEXEL_LONGEST] = V(c->sizes)[FLEXEL_LONGEST];
    memcpy(c->states_new, c->states, c->groups * sizeof(vec));
    for (size_t i = 0; i < s->nz; i++) {
        vec *largest = V(c->states_new) + c->group[i];
        const vec here = flexel_size(V(y)[l->steps->ny - s->nz + i]);
        *largest = flexel_most(*largest, here);
    }
}

FLEXEL_CLONES
void flexel_lanes_cover(const flexel_lanes *l, const mask *where)
{
    const flexel_work *s = l->work;
    flexel_covered *c = l->steps->covered;
    for (size_t i = 0; i < s->nf; i++) {
        const vec x = V(l->steps->x_new)[i], low = flexel_least(V(c->low)[i], x), high = flexel_most(V(c->high)[i], x);
        const vec v = flexel_size(V(s->v)[i]), quick = flexel_most(V(c->quick)[i], v);
        V(c->quick)[i] = flexel_either(*where, quick, V(c->quick)[i]);
        V(c->low)[i] = flexel_either(*where, low, V(c->low)[i]);
        V(c->high)[i] = flexel_either(*where, high, V(c->high)[i]);
    }
    for (size_t i = 0; i < c->ny; i++) {
        const vec y = V(l->steps->y_new)[i], low = flexel_least(V(c->least_y)[i], y), high = flexel_most(V(c->most_y)[i], y);
        V(c->least_y)[i] = flexel_either(*where, low, V(c->least_y)[i]);
        V(c->most_y)[i] = flexel_either(*where, high, V(c->most_y)[i]);
    }
    for (size_t i = 0; i < FLEXEL_SIZES; i++)
        V(c->sizes)[i] = flexel_either(*where, V(c->sizes_new)[i], V(c->sizes)[i]);
    const vec taken = V(c->sizes)[FLEXEL_TAKEN] + 1;
    V(c->sizes)[FLEXEL_TAKEN] = flexel_either(*where, taken, V(c->sizes)[FLEXEL_TAKEN]);
    for (size_t i = 0; i < c->groups; i++)
        V(c->states)[i] = flexel_either(*where, V(c->states_new)[i], V(c->states)[i]);
}

void flexel_lanes_accepted_error(const flexel_lanes *l)
{
    const flexel_covered *c = l->steps->covered;
    const vec *sizes = V(c->sizes);
    for (size_t k = 0; k < FLEXEL_BLOCK; k++)
        V(l->accept)[0][k] = flexel_accepted_error(c, l->choice->accept, sizes[FLEXEL_RANGE][k], sizes[FLEXEL_TAKEN][k]);
}
