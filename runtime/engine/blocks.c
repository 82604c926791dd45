/* Factors and solutions of linear equations in block lower triangular form; see blocks.h. */
#include "blocks.h"

#include <math.h>

static void swap(double *a, double *b, size_t n)
{
    if (a != b)
        for (size_t i = 0; i < n; i++) {
            const double z = a[i];
            a[i] = b[i];
            b[i] = z;
        }
}

/* y -= factor x */
static void subtract(double *restrict y, const double *restrict x, double factor, size_t n)
{
    if (factor != 0)
        for (size_t i = 0; i < n; i++)
            y[i] -= factor * x[i];
}

static void divide(double *x, double divisor, size_t n)
{
    for (size_t i = 0; i < n; i++)
        x[i] /= divisor;
}

size_t flexel_factor_blocks(const flexel_form *form, double *diagonal, size_t *pivots)
{
    double *A = diagonal;
    for (size_t k = 0; k < form->nblocks; k++) {
        const size_t size = form->start[k + 1] - form->start[k];
        for (size_t j = 0; j < size; j++) {
            size_t p = j;
            for (size_t i = j + 1; i < size; i++)
                if (fabs(A[i * size + j]) > fabs(A[p * size + j]))
                    p = i;
            if (A[p * size + j] == 0)
                return k + 1;
            pivots[form->start[k] + j] = p;
            swap(A + j * size, A + p * size, size);
            for (size_t i = j + 1; i < size; i++) {
                A[i * size + j] /= A[j * size + j];
                subtract(A + i * size + j + 1, A + j * size + j + 1, A[i * size + j], size - j - 1);
            }
        }
        A += size * size;
    }
    return 0;
}

void flexel_solve_blocks(const flexel_form *form, const double *diagonal, const size_t *pivots, const double *beside,
                         size_t n, double *x)
{
    const double *A = diagonal;
    for (size_t k = 0; k < form->nblocks; k++) {
        const size_t start = form->start[k], size = form->start[k + 1] - start;
        double *b = x + start * n;
        for (size_t i = 0; i < size; i++)
            for (size_t e = form->first[start + i]; e < form->first[start + i + 1]; e++)
                subtract(b + i * n, x + form->column[e] * n, beside[e], n);
        for (size_t i = 0; i < size; i++)
            swap(b + i * n, b + pivots[start + i] * n, n);
        for (size_t i = 1; i < size; i++)
            for (size_t j = 0; j < i; j++)
                subtract(b + i * n, b + j * n, A[i * size + j], n);
        for (size_t i = size; i-- > 0;) {
            for (size_t j = i + 1; j < size; j++)
                subtract(b + i * n, b + j * n, A[i * size + j], n);
            divide(b + i * n, A[i * size + i], n);
        }
        A += size * size;
    }
}

void flexel_solve_blocks_transposed(const flexel_form *form, const double *diagonal, const size_t *pivots,
                                    const double *beside, size_t n, double *x)
{
    const double *A = diagonal;
    for (size_t k = 0; k < form->nblocks; k++)
        A += (form->start[k + 1] - form->start[k]) * (form->start[k + 1] - form->start[k]);
    for (size_t k = form->nblocks; k-- > 0;) {
        const size_t start = form->start[k], size = form->start[k + 1] - start;
        double *b = x + start * n;
        A -= size * size;
        for (size_t j = 0; j < size; j++) {
            divide(b + j * n, A[j * size + j], n);
            for (size_t i = j + 1; i < size; i++)
                subtract(b + i * n, b + j * n, A[j * size + i], n);
        }
        for (size_t j = size; j-- > 0;)
            for (size_t i = 0; i < j; i++)
                subtract(b + i * n, b + j * n, A[j * size + i], n);
        for (size_t i = size; i-- > 0;)
            swap(b + i * n, b + pivots[start + i] * n, n);
        for (size_t i = 0; i < size; i++)
            for (size_t e = form->first[start + i]; e < form->first[start + i + 1]; e++)
                subtract(x + form->column[e] * n, b + i * n, beside[e], n);
    }
}
