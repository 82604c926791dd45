/* Factors and solutions in all lanes with one order of the pivots; see lanes.h, and elimination.c and substitution.c for one
 * variant, whose sums are taken in the same order. */
#include "lanes_inside.h"

#define NUMBER vec
#define SIZE(a) flexel_size(a)
#define ZERO flexel_all(0)
#define SIDE_BY_SIDE
#include "lu_inside.h"

/* The inverse of a pivot; negative numbers tell that it is not sound. Zeros and what is not finite are found later: they make
 * the solution infinite, or not a number. */
FLEXEL_INLINE mask invert(const flexel_lu *lu, size_t k, double growth, vec *a)
{
    const int d = lu->diagonal[k], u = lu->first[k + 1] - d - 1;
    const vec size = flexel_size(a[d]) * lu->scale[d], rest = norm(a + d + 1, lu->scale + d + 1, u);
    a[d] = 1 / a[d];
    return (mask)(size - FLEXEL_LEAST_PIVOT * a[lu->slots + k]) | (mask)(size * growth - rest);
}

FLEXEL_CLONES
void flexel_lanes_factor(const flexel_matrix *A, const double *buffer, mask *unsound)
{
    const flexel_lu *lu = A->lu;
    vec *a = V(A->a);
    const double growth = flexel_lu_growth(A->noise);
    mask negative = {0};
    load(lu, A->source, V(buffer), a);
    const int *list = lu->list;
    for (const flexel_pass *pass = lu->pass; pass < lu->pass + lu->npasses; pass++) {
        list = eliminate(pass, list, a);
        for (int i = 0; i < pass->pivots; i++, list++)
            negative |= invert(lu, (size_t)*list, growth, a);
    }
    *unsound |= flexel_negative(negative);
}

FLEXEL_CLONES
void flexel_lanes_sign(const flexel_matrix *A, mask *negative)
{
    mask signs = {0};
    for (size_t k = 0; k < A->lu->n; k++)
        signs ^= (mask)(V(A->a)[A->lu->diagonal[k]]);
    *negative = A->lu->sign < 0 ? ~flexel_negative(signs) : flexel_negative(signs);
}

double flexel_lanes_logarithm(const flexel_matrix *A, size_t lane)
{
    double mantissa = 1, exponents = 0;
    for (size_t k = 0; k < A->lu->n; k++) {
        int exponent;
        mantissa = frexp(mantissa * fabs(V(A->a)[A->lu->diagonal[k]][lane]), &exponent);
        exponents += exponent;
    }
    return -log2(mantissa) - exponents; /* of the inverses of the pivots */
}

/* The same on `width` of `count` columns. */
FLEXEL_INLINE void sweep(const flexel_lu *lu, const vec *a, size_t first, vec *y, size_t count, int width)
{
    const size_t n = lu->n;
    const int *begin = lu->first, *diagonal = lu->diagonal, *at = lu->at;
    for (size_t i = first; i < n; i++) {
        const int s = begin[i];
        flexel_lanes_sums_by(y + i * count, a + s, at + s, diagonal[i] - s, y, count, width, 1);
    }
    for (size_t i = n; i-- > 0;) {
        const int s = diagonal[i] + 1;
        flexel_lanes_sums_by(y + i * count, a + s, at + s, begin[i + 1] - s, y, count, width, 1);
        for (int c = 0; c < width; c++)
            y[i * count + (size_t)c] *= a[s - 1];
    }
}

/* The rows of b in the order of the pivots; the first one that is not zero. */
FLEXEL_INLINE size_t gather(const flexel_lu *lu, size_t count, const vec *b, vec *y)
{
    const size_t n = lu->n;
    const int *row = lu->row;
    size_t first = n;
    for (size_t k = n; k-- > 0;) {
        mask some = {0};
        for (size_t c = 0; c < count; c++) {
            y[k * count + c] = b[(size_t)row[k] * count + c];
            some |= (mask)y[k * count + c] << 1; /* all bits but the sign */
        }
        if (flexel_any(&some))
            first = k;
    }
    return first;
}

FLEXEL_INLINE void scatter(const flexel_lu *lu, size_t count, const vec *y, vec *x)
{
    const size_t n = lu->n;
    const int *column = lu->column;
    for (size_t k = 0; k < n; k++)
        for (size_t c = 0; c < count; c++)
            x[(size_t)column[k] * count + c] = y[k * count + c];
}

FLEXEL_CLONES
void flexel_lanes_solve(const flexel_matrix *A, size_t count, const double *b, double *x, double *work)
{
    const flexel_lu *lu = A->lu;
    const vec *a = V(A->a);
    vec *y = V(work);
    const size_t first = gather(lu, count, V(b), y);
    size_t c = 0;
    if (count == 1)
        sweep_one(lu, a, first, y), c = 1;
    for (; c + 4 <= count; c += 4)
        sweep(lu, a, first, y + c, count, 4);
    for (; c < count; c++)
        sweep(lu, a, first, y + c, count, 1);
    scatter(lu, count, y, V(x));
}
