/* Small dense systems of equations; see dense.h. */
#include "dense.h"

#include <math.h>

static void exchange(double *a, double *b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const double z = a[i];
        a[i] = b[i];
        b[i] = z;
    }
}

static void subtract(double *restrict y, const double *restrict x, double factor, size_t n)
{
    for (size_t i = 0; i < n; i++)
        y[i] -= factor * x[i];
}

size_t flexel_dense_solve(size_t n, size_t count, double *A, double *B)
{
    for (size_t k = 0; k < n; k++) {
        size_t p = k;
        for (size_t i = k + 1; i < n; i++)
            if (fabs(A[i * n + k]) > fabs(A[p * n + k]))
                p = i;
        if (!(fabs(A[p * n + k]) > 0))
            return k + 1;
        if (p != k) {
            exchange(A + k * n, A + p * n, n);
            exchange(B + k * count, B + p * count, count);
        }
        for (size_t i = k + 1; i < n; i++) {
            const double z = A[i * n + k] / A[k * n + k];
            subtract(A + i * n + k + 1, A + k * n + k + 1, z, n - k - 1);
            subtract(B + i * count, B + k * count, z, count);
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++)
            subtract(B + k * count, B + j * count, A[k * n + j], count);
        for (size_t j = 0; j < count; j++)
            B[k * count + j] /= A[k * n + k];
    }
    return 0;
}

size_t flexel_definite_solve(size_t n, double *A, double *b)
{
    for (size_t k = 0; k < n; k++) {
        for (size_t j = 0; j < k; j++) {
            double z = A[k * n + j];
            for (size_t i = 0; i < j; i++)
                z -= A[k * n + i] * A[j * n + i];
            A[k * n + j] = z / A[j * n + j];
        }
        const double size = A[k * n + k];
        double z = size;
        for (size_t i = 0; i < k; i++)
            z -= A[k * n + i] * A[k * n + i];
        if (!(z > FLEXEL_LEAST_PIVOT * size)) /* also if it is not a number */
            return k + 1;
        A[k * n + k] = sqrt(z);
    }
    for (size_t k = 0; k < n; k++) {
        for (size_t j = 0; j < k; j++)
            b[k] -= A[k * n + j] * b[j];
        b[k] /= A[k * n + k];
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++)
            b[k] -= A[j * n + k] * b[j];
        b[k] /= A[k * n + k];
    }
    return 0;
}
