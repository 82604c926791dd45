/* Numbers of eight variants side by side. Every operation does in each of them what the same operation on a double does. */
#ifndef FLEXEL_VECTOR_H
#define FLEXEL_VECTOR_H

#include "kernels.h"

#include <math.h>

#define FLEXEL_INLINE static inline __attribute__((always_inline))
#pragma GCC diagnostic ignored "-Wpsabi" /* of functions that are always inline: there is no call with vectors */

typedef double flexel_vector __attribute__((vector_size(FLEXEL_BLOCK * sizeof(double)), may_alias));
/* All bits are set where something holds. */
typedef long long flexel_mask __attribute__((vector_size(FLEXEL_BLOCK * sizeof(long long)), may_alias));

/* These are macros because a parameter of this size would be passed in different ways by different compilers. */
#define flexel_all(z) ((flexel_vector){z, z, z, z, z, z, z, z})
#define flexel_size(a) ((flexel_vector)((flexel_mask)(a) & 0x7fffffffffffffff))
/* a where the mask is set, otherwise b */
#define flexel_either(where, a, b) ((flexel_vector)(((where) & (flexel_mask)(a)) | (~(where) & (flexel_mask)(b))))
/* As fmax: of two numbers of which the first one is a number. */
#define flexel_most(a, b) flexel_either((flexel_mask)((b) > (a)), b, a)

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

/* Whether a mask is set anywhere. */
FLEXEL_INLINE int flexel_any(const flexel_mask *m)
{
    long long any = 0;
    for (int i = 0; i < FLEXEL_BLOCK; i++)
        any |= (*m)[i];
    return any != 0;
}

#endif
