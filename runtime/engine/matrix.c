/* A sparse square matrix with its factors; see matrix.h. */
#include "matrix.h"

#include <stdlib.h>

/* Space for values and factors. */
static int reserve(flexel_matrix *A, size_t slots)
{
    if (slots > A->size) {
        double *larger = realloc(A->a, (slots + 1) * sizeof(double));
        if (!larger)
            return 1;
        A->a = larger;
        A->size = slots;
    }
    return 0;
}

/* A pivot order for the values in some buffers, which follow one another at distances of `stride`. */
static int order(flexel_matrix *A, size_t samples, const double *buffers, size_t stride)
{
    size_t failed;
    double *values = malloc((samples * A->nentries + 1) * sizeof(double));
    if (!values)
        return 1;
    for (size_t k = 0; k < samples; k++)
        for (size_t i = 0; i < A->nentries; i++)
            values[k * A->nentries + i] = buffers[k * stride + (size_t)A->source[i]];
    flexel_lu *found = flexel_lu_order(A->n, A->nentries, A->rows, A->columns, samples, values, &failed);
    free(values);
    if (!found)
        return 1;
    flexel_matrix_reset(A);
    A->lu = found;
    A->orders++;
    return reserve(A, flexel_lu_slots(found));
}

void flexel_matrix_prepare(flexel_matrix *A, size_t samples, const double *buffers, size_t stride)
{
    if (A->n && (!order(A, samples, buffers, stride) || !order(A, 1, buffers, stride)))
        A->first = A->lu;
}

void flexel_matrix_reset(flexel_matrix *A)
{
    if (A->lu != A->first)
        flexel_lu_free(A->lu);
    A->lu = A->first;
}

int flexel_matrix_factor(flexel_matrix *A, const double *buffer)
{
    if (A->lu && !flexel_lu_factor(A->lu, A->noise, A->source, buffer, A->a))
        return 0;
    return order(A, 1, buffer, 0) || flexel_lu_factor(A->lu, 1, A->source, buffer, A->a) != 0;
}

void flexel_matrix_clear(flexel_matrix *A)
{
    flexel_matrix_reset(A);
    flexel_lu_free(A->first);
    free(A->a);
    A->first = A->lu = NULL;
    A->a = NULL;
    A->size = 0;
}

void flexel_matrix_solve(const flexel_matrix *A, size_t count, const double *b, double *x, double *work)
{
    flexel_lu_solve(A->lu, A->a, count, b, x, work);
}

void flexel_matrix_solve_transposed(const flexel_matrix *A, size_t count, const double *b, double *x, double *work)
{
    flexel_lu_solve_transposed(A->lu, A->a, count, b, x, work);
}

int flexel_matrix_sign(const flexel_matrix *A)
{
    return flexel_lu_sign(A->lu, A->a);
}

double flexel_matrix_logarithm(const flexel_matrix *A)
{
    return flexel_lu_logarithm(A->lu, A->a);
}
