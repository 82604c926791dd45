/* Products of sparse and dense matrices; see products.h. */
#include "products.h"

#include <string.h>

void flexel_product(size_t rows, const int *start, const int *column, const int *source, const double *values, size_t count,
                    const double *in, double *out)
{
    memset(out, 0, rows * count * sizeof(double));
    for (size_t i = 0; i < rows; i++) {
        double *restrict y = out + i * count;
        for (int k = start[i]; k < start[i + 1]; k++) {
            const double z = values[source[k]], *restrict x = in + (size_t)column[k] * count;
            for (size_t j = 0; j < count; j++)
                y[j] += z * x[j];
        }
    }
}
