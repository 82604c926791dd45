#ifndef FLEXEL_PROCESSOR_H
#define FLEXEL_PROCESSOR_H

/* Which instructions the compiler could use in all files but processor.c and the interface to Python; constants, since
 * code compiled like those files may not run here. */
typedef struct {
    int popcnt, sse4_2, avx, avx2, fma, bmi, bmi2, avx512f, avx512dq, avx512bw, avx512vl, avx512cd;
} flexel_features;
extern const flexel_features flexel_needs;

/* cdef: begin */
/* The name of an instruction set that the extension needs and this processor lacks, or NULL. */
const char *flexel_lacking_feature(void);
/* cdef: end */

#endif
