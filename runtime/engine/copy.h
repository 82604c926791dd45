/* Numbers carried from one array to the next place of another. */
#ifndef FLEXEL_COPY_H
#define FLEXEL_COPY_H

#include <stddef.h>
#include <string.h>

/* Where the source goes on behind what was copied. */
static inline const double *flexel_take_numbers(double *to, const double *from, size_t count)
{
    memcpy(to, from, count * sizeof(double));
    return from + count;
}

/* Where the target goes on behind what was copied. */
static inline double *flexel_put_numbers(double *to, const double *from, size_t count)
{
    memcpy(to, from, count * sizeof(double));
    return to + count;
}

#endif
