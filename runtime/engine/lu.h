/* The tables of a sparse elimination: written by tables.c and passes.c, read by elimination.c and substitution.c. */
#ifndef FLEXEL_LU_H
#define FLEXEL_LU_H

#include "dense.h"
#include "elimination.h"
#include "pivots.h"

#include <float.h>
#include <math.h>

#define FLEXEL_MOST_GROWTH 1e4   /* largest size of a row when it is eliminated, relative to its pivot */
#define FLEXEL_LEAST_GROWTH 1e3  /* the same where the solution must be exact: pivots that are found anew reach it */

/* Most pivots of a group. */
#define FLEXEL_GROUP 4

/* A part of the elimination whose subtractions do not depend on one another. From rows of the matrix the rows of `width`
 * pivots each are subtracted; then these `pivots` are done. What they are is listed one after another in `list`:
 *
 *   rows               the slot of the first multiplier; slots behind the diagonal of the pivots' rows, where these have the
 *                      column that follows the last of the pivots
 *   fours, twos, ones  as many neighbouring slots of a row: the first of them, the first multiplier, the slots of the pivots'
 *                      rows in the same column
 *   pivots             their numbers
 *
 * Loops that are always as long need no guess from the processor, and what does not depend on one another need not wait:
 * with both, an elimination takes a fifth to a quarter less time than row by row. */
typedef struct {
    int width, rows, fours, twos, ones, pivots;
} flexel_pass;

/* Rows and columns are counted in the order of the pivots. The factors are stored row by row, the entries of a row by
 * column: multipliers of L from first[i], the inverse of the pivot in slot diagonal[i], then U until first[i + 1].
 * Behind them is room for the size of every row of the matrix.
 *
 * Neighbouring pivots whose rows have the same columns, and whose columns the same rows, apart from their own, form
 * groups: their rows are subtracted from another row together. The multipliers of a row for the pivots of a group are
 * neighbours. */
struct flexel_lu {
    size_t n, nentries, slots, operations;
    int sign;           /* of the permutations */
    int *row, *column;  /* of each pivot in the matrix */
    int *first, *diagonal; /* (n + 1), (n) */
    int *at;            /* column of each slot */
    double *scale;      /* of the column of each slot */
    int *slot;          /* of each entry of the matrix */
    size_t npasses;
    flexel_pass *pass;
    int *list;
};

/* Groups of pivots, and the rows below each, by group: the first slot of their multipliers. */
typedef struct {
    size_t count;
    int *first;      /* (count + 1): first pivots */
    int *below;      /* (count + 1): where the list of rows below begins */
    int *multiplier; /* of each such row */
} flexel_groups;

/* Largest size of a row when it is eliminated, relative to its pivot, for solutions with an error of `noise` at most: rows
 * enlarge rounding by about their size. */
static inline double flexel_lu_growth(double noise)
{
    return fmin(fmax(noise / DBL_EPSILON, FLEXEL_LEAST_GROWTH), FLEXEL_MOST_GROWTH);
}

/* The tables for pivots that are all found; NULL if memory is exhausted. `scale` is of the columns of the matrix. */
flexel_lu *flexel_lu_tables(const flexel_pivots *pivots, size_t nentries, const int *rows, const int *columns,
                            const double *scale);
/* The passes; false if memory is exhausted. */
int flexel_lu_passes(flexel_lu *lu, const flexel_groups *groups);

#endif
