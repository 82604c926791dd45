/* Sparse LU factors with a given order of the pivots: see elimination.h and lu.h. */
#include "kernels.h" /* for FLEXEL_CLONES */
#include "lu_inside.h"

#include <stdlib.h>

void flexel_lu_free(flexel_lu *lu)
{
    if (!lu)
        return;
    int *const arrays[] = {lu->row, lu->column, lu->first, lu->diagonal, lu->at, lu->slot, lu->list};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free(arrays[i]);
    free(lu->scale);
    free(lu->pass);
    free(lu);
}

size_t flexel_lu_slots(const flexel_lu *lu)
{
    return lu->slots + lu->n;
}

size_t flexel_lu_operations(const flexel_lu *lu)
{
    return lu->operations;
}

/* Whether a pivot is large enough; it is replaced by its inverse. */
static inline int invert(const flexel_lu *lu, size_t k, double growth, double *a)
{
    const int d = lu->diagonal[k], u = lu->first[k + 1] - d - 1;
    const double size = fabs(a[d]) * lu->scale[d], rest = norm(a + d + 1, lu->scale + d + 1, u);
    const int sound = size > 0 && size <= DBL_MAX && size >= FLEXEL_LEAST_PIVOT * a[lu->slots + k] &&
                      size * growth >= rest;
    a[d] = 1 / a[d];
    return sound;
}

FLEXEL_CLONES
size_t flexel_lu_factor(const flexel_lu *lu, double noise, const int *source, const double *buffer, double *a)
{
    const double growth = flexel_lu_growth(noise);
    const int *list = lu->list;
    load(lu, source, buffer, a);
    for (const flexel_pass *pass = lu->pass; pass < lu->pass + lu->npasses; pass++) {
        list = eliminate(pass, list, a);
        for (int i = 0; i < pass->pivots; i++, list++)
            if (!invert(lu, (size_t)*list, growth, a))
                return (size_t)*list + 1;
    }
    return 0;
}

int flexel_lu_sign(const flexel_lu *lu, const double *a)
{
    int sign = lu->sign;
    for (size_t k = 0; k < lu->n; k++)
        sign = a[lu->diagonal[k]] < 0 ? -sign : sign;
    return sign;
}

double flexel_lu_logarithm(const flexel_lu *lu, const double *a)
{
    double mantissa = 1, exponents = 0;
    for (size_t k = 0; k < lu->n; k++) {
        int exponent;
        mantissa = frexp(mantissa * fabs(a[lu->diagonal[k]]), &exponent);
        exponents += exponent;
    }
    return -log2(mantissa) - exponents; /* of the inverses of the pivots */
}
