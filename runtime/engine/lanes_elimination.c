/* Factors and solutions in all lanes with one order of the pivots; see lanes.h, and elimination.c and substitution.c for one
 * variant, whose sums are taken in the same order. */
#include "lanes_inside.h"
#include "lu.h"

#include <float.h>
#include <string.h>

/* Sum of the sizes of neighbouring entries, columns scaled. */
FLEXEL_INLINE vec norm(const vec *a, const double *scale, int count)
{
    vec even = flexel_all(0), odd = even;
    int i = 0;
    for (; i + 1 < count; i += 2) {
        even += flexel_size(a[i]) * scale[i];
        odd += flexel_size(a[i + 1]) * scale[i + 1];
    }
    return i < count ? even + odd + flexel_size(a[i]) * scale[i] : even + odd;
}

FLEXEL_INLINE void load(const flexel_lu *lu, const int *source, const vec *buffer, vec *a)
{
    const size_t slots = lu->slots, nentries = lu->nentries;
    const int *slot = lu->slot;
    for (size_t i = 0; i < slots; i++)
        a[i] = flexel_all(0);
    for (size_t e = 0; e < nentries; e++)
        a[slot[e]] = buffer[source[e]];
    for (size_t i = 0; i < lu->n; i++)
        a[slots + i] = norm(a + lu->first[i], lu->scale + lu->first[i], lu->first[i + 1] - lu->first[i]);
}

/* The multipliers of rows for `width` neighbouring pivots, in their slots. */
FLEXEL_INLINE const int *multipliers(const int *list, int count, int width, vec *a)
{
    for (int r = 0; r < count; r++, list += 1 + width) {
        vec *slots = a + list[0];
        for (int j = 0; j < width; j++) {
            const vec *row = a + list[1 + j] - width;
            vec sum = slots[j];
            for (int i = 0; i < j; i++)
                sum -= slots[i] * a[list[1 + i] - width + j];
            slots[j] = sum * row[j];
        }
    }
    return list;
}

/* Subtract `width` pivot rows times multipliers from `length` neighbouring slots of other rows. */
FLEXEL_INLINE const int *subtract(const int *list, int count, int length, int width, vec *a)
{
    for (int r = 0; r < count; r++, list += 2 + width) {
        vec *to = a + list[0];
        const vec *z = a + list[1];
        for (int i = 0; i < length; i++) {
            vec sum = to[i];
            for (int j = 0; j < width; j++)
                sum -= z[j] * a[list[2 + j] + i];
            to[i] = sum;
        }
    }
    return list;
}

FLEXEL_INLINE const int *eliminate(const flexel_pass *pass, const int *list, int width, vec *a)
{
    list = multipliers(list, pass->rows, width, a);
    list = subtract(list, pass->fours, 4, width, a);
    list = subtract(list, pass->twos, 2, width, a);
    return subtract(list, pass->ones, 1, width, a);
}

/* The inverse of a pivot; negative numbers tell that it is not sound. Zeros and what is not finite are found later: they make
 * the solution infinite, or not a number. */
FLEXEL_INLINE mask invert(const flexel_lu *lu, size_t k, vec *a)
{
    const int d = lu->diagonal[k], u = lu->first[k + 1] - d - 1;
    const vec size = flexel_size(a[d]) * lu->scale[d], rest = norm(a + d + 1, lu->scale + d + 1, u);
    a[d] = 1 / a[d];
    return (mask)(size - FLEXEL_LEAST_PIVOT * a[lu->slots + k]) | (mask)(size * FLEXEL_MOST_GROWTH - rest);
}

FLEXEL_CLONES
void flexel_lanes_factor(const flexel_matrix *A, const double *buffer, mask *unsound)
{
    const flexel_lu *lu = A->lu;
    vec *a = V(A->a);
    mask negative = {0};
    load(lu, A->source, V(buffer), a);
    const int *list = lu->list;
    for (const flexel_pass *pass = lu->pass; pass < lu->pass + lu->npasses; pass++) {
        switch (pass->width) {
        case 0: break;
        case 1: list = eliminate(pass, list, 1, a); break;
        case 2: list = eliminate(pass, list, 2, a); break;
        case 3: list = eliminate(pass, list, 3, a); break;
        default: list = eliminate(pass, list, FLEXEL_GROUP, a);
        }
        for (int i = 0; i < pass->pivots; i++, list++)
            negative |= invert(lu, (size_t)*list, a);
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

/* The sum of a[s] y[at[s]] over neighbouring slots, a multiple of four. */
FLEXEL_INLINE vec product(const vec *a, const int *at, int slots, const vec *y)
{
    vec sum[4] = {flexel_all(0), flexel_all(0), flexel_all(0), flexel_all(0)};
    for (int s = 0; s < slots; s += 4)
        for (int i = 0; i < 4; i++)
            sum[i] += a[s + i] * y[at[s + i]];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* L, then U, row by row, on one column that is zero before row `first`. */
FLEXEL_INLINE void sweep_one(const flexel_lu *lu, const vec *a, size_t first, vec *y)
{
    for (size_t i = first; i < lu->n; i++) {
        const int begin = lu->first[i], slots = lu->diagonal[i] - begin, *at = lu->at + begin;
        const int whole = slots > 0 ? (slots - 1) / 4 * 4 : 0;
        vec z = y[i];
        if (whole)
            z -= product(a + begin, at, whole, y);
        for (int s = whole; s < slots; s++)
            z -= a[begin + s] * y[at[s]];
        y[i] = z;
    }
    for (size_t i = lu->n; i-- > 0;) {
        const int begin = lu->diagonal[i] + 1, slots = lu->first[i + 1] - begin, *at = lu->at + begin;
        const int rest = slots > 0 ? (slots - 1) % 4 + 1 : 0;
        vec z = y[i];
        if (rest < slots)
            z -= product(a + begin + rest, at + rest, slots - rest, y);
        for (int s = rest; s-- > 0;)
            z -= a[begin + s] * y[at[s]];
        y[i] = z * a[begin - 1];
    }
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
