/* What the compiler was allowed to use in this build; no code. */
#include "processor.h"

const flexel_features flexel_needs = {
#ifdef __POPCNT__
    .popcnt = 1,
#else
    .popcnt = 0, /* without any, the list would be empty, which is not C11 */
#endif
#ifdef __SSE4_2__
    .sse4_2 = 1,
#endif
#ifdef __AVX__
    .avx = 1,
#endif
#ifdef __AVX2__
    .avx2 = 1,
#endif
#ifdef __FMA__
    .fma = 1,
#endif
#ifdef __BMI__
    .bmi = 1,
#endif
#ifdef __BMI2__
    .bmi2 = 1,
#endif
#ifdef __AVX512F__
    .avx512f = 1,
#endif
#ifdef __AVX512DQ__
    .avx512dq = 1,
#endif
#ifdef __AVX512BW__
    .avx512bw = 1,
#endif
#ifdef __AVX512VL__
    .avx512vl = 1,
#endif
#ifdef __AVX512CD__
    .avx512cd = 1,
#endif
};
