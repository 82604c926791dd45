/* What is evaluated for a whole system in one call from outside. */
#include "system.h"

void flexel_run(size_t n, const flexel_call *calls)
{
    for (size_t i = 0; i < n; i++)
        calls[i].kernel(calls[i].nblocks, calls[i].in, calls[i].out);
}
