/* Contacts far from their surfaces, which the iterations of a step leave out. */
#ifndef FLEXEL_CONTACT_SELECTION_H
#define FLEXEL_CONTACT_SELECTION_H

#include "table.h"

/* cdef: begin */
/* The contacts of one type: their kernel of positions, which of its blocks are selected, and in its lanes their gaps (ngaps of
 * each of `count` contacts) and the lengths of their cables. */
typedef struct {
    const flexel_call *position;
    const unsigned char *selected;
    size_t count, ngaps;
    const double *gaps, *length;
} flexel_contacts;

/* Smallest gap of the contacts in blocks that are not selected, in lengths of their cables, at the coordinates of the last
 * evaluation; infinite if there are none. */
double flexel_far_gap(const flexel_work *s, size_t ntypes, const flexel_contacts *types);
/* cdef: end */

#endif
