/* Kernels of a whole system, called one after another. */
#ifndef FLEXEL_SYSTEM_H
#define FLEXEL_SYSTEM_H

#include "kernels.h"

/* cdef: begin */
/* One call of a kernel, prepared once and run many times. */
typedef struct {
    flexel_kernel kernel;
    size_t nblocks;
    const real *const *in;
    real *const *out;
} flexel_call;

/* Run n calls, one after another. */
void flexel_run(size_t n, const flexel_call *calls);
/* cdef: end */

#endif
