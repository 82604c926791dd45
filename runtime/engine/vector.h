/* Numbers of eight variants side by side. Every operation does in each of them what the same operation on a double does. */
#ifndef FLEXEL_VECTOR_H
#define FLEXEL_VECTOR_H

#include "kernels.h"

#include <math.h>

#define FLEXEL_INLINE static inline __attribute__((always_inline))
#pragma GCC diagnostic ignored "-Wpsabi" /* of functions that are always inline: there is no call with vectors */

typedef double flexel_vector __attribute__((vector_size(FLEXEL_BLOCK * sizeof(double))));
/* All bits are set where something holds. */
typedef long long flexel_mask __attribute__((vector_size(FLEXEL_BLOCK * sizeof(long long))));

/* These are macros because a parameter of this size would be passed in different ways by different compilers. */
#define flexel_all(z) ((flexel_vector){z, z, z, z, z, z, z, z})
#define flexel_size(a) ((flexel_vector)((flexel_mask)(a) & 0x7fffffffffffffff))
/* Where a number is negative: by its sign bit, as compilers compare long vectors number by number. */
#define flexel_negative(a) ((flexel_mask)(a) >> 63)
/* a where the mask is set, otherwise b */
#define flexel_either(where, a, b) ((flexel_vector)(((where) & (flexel_mask)(a)) | (~(where) & (flexel_mask)(b))))
/* The larger and the smaller of two numbers; anything if one of them is not a number. */
#define flexel_most(a, b) flexel_either(flexel_negative((a) - (b)), b, a)
#define flexel_least(a, b) flexel_either(flexel_negative((a) - (b)), a, b)

FLEXEL_INLINE void flexel_root(flexel_vector *a)
{
    for (int i = 0; i < FLEXEL_BLOCK; i++)
        (*a)[i] = sqrt((*a)[i]);
}

FLEXEL_INLINE void flexel_round(flexel_vector *a)
{
    for (int i = 0; i < FLEXEL_BLOCK; i++)
        (*a)[i] = rint((*a)[i]);
}

/* Whether a bit is set anywhere. */
FLEXEL_INLINE int flexel_any(const flexel_mask *m)
{
    long long any = 0;
    for (int i = 0; i < FLEXEL_BLOCK; i++)
        any |= (*m)[i];
    return any != 0;
}

/* Where a is less than b; false if one of them is not a number. */
FLEXEL_INLINE void flexel_less(const flexel_vector *a, const flexel_vector *b, flexel_mask *less)
{
    for (int i = 0; i < FLEXEL_BLOCK; i++)
        (*less)[i] = (*a)[i] < (*b)[i] ? -1 : 0;
}

#endif
