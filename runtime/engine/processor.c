/* Whether this processor has what the extension was compiled for. Compiled for every processor. */
#include "processor.h"

#include <stddef.h>

#if defined(__GNUC__) && defined(__x86_64__)
#define LACKS(needed, name) \
    if (flexel_needs.needed && !__builtin_cpu_supports(name)) \
    return name

const char *flexel_lacking_feature(void)
{
    LACKS(popcnt, "popcnt");
    LACKS(sse4_2, "sse4.2");
    LACKS(avx, "avx");
    LACKS(avx2, "avx2");
    LACKS(fma, "fma");
    LACKS(bmi, "bmi");
    LACKS(bmi2, "bmi2");
    LACKS(avx512f, "avx512f");
    LACKS(avx512dq, "avx512dq");
    LACKS(avx512bw, "avx512bw");
    LACKS(avx512vl, "avx512vl");
    LACKS(avx512cd, "avx512cd");
    return NULL;
}
#else
const char *flexel_lacking_feature(void)
{
    return NULL;
}
#endif
