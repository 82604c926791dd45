/* The tables of a sparse elimination: written by ordering.c, read by elimination.c. */
#ifndef FLEXEL_LU_H
#define FLEXEL_LU_H

#include "elimination.h"
#include "pivots.h"

/* One, two or four neighbouring slots of a row, from which multiples of as many slots of each pivot row of a group are
 * subtracted; the multipliers are in the slots from `by` on. */
typedef struct {
    int to, from, by;
} flexel_stretch;

/* Most pivots of a group. */
#define FLEXEL_GROUP 4

#define FLEXEL_LEAST_PIVOT 1e-14 /* least size of a pivot relative to its row of the matrix, columns scaled */
#define FLEXEL_MOST_GROWTH 1e4   /* largest size of a row when it is eliminated, relative to its pivot */

/* Rows and columns are counted in the order of the pivots. The factors are stored row by row, the entries of a row by
 * column: multipliers of L from first[i], the inverse of the pivot in slot diagonal[i], then U until first[i + 1].
 * Behind them is room for the size of every row of the matrix.
 *
 * Neighbouring pivots whose rows have the same columns, and whose columns the same rows, apart from their own, form
 * groups: their rows are subtracted from another row together. The multipliers of a row for the pivots of a group are
 * neighbours. What is subtracted from all rows below a group is listed by its length: loops that are always as long need no
 * guess from the processor, and wrong guesses took half of the time. */
struct flexel_lu {
    size_t n, nentries, slots, operations;
    int sign;                /* of the permutations */
    int *row, *column;       /* of each pivot in the matrix */
    int *first, *diagonal;   /* (n + 1), (n) */
    int *at;                 /* column of each slot */
    double *scale;           /* of the column of each slot */
    int *slot;               /* of each entry of the matrix */
    size_t groups;
    int *group;              /* (groups + 1): their first pivots */
    int *below;              /* (groups + 1): rows below a group's, by group */
    int *multiplier;         /* the first slot of each for the group */
    int *run;                /* (3 groups + 1): the stretches of four, of two and of one slot of these rows, by group */
    flexel_stretch *stretch; /* `from` is counted from the first column behind the group's */
};

/* The tables for pivots that are all found; NULL if memory is exhausted. `scale` is of the columns of the matrix. */
flexel_lu *flexel_lu_tables(const flexel_pivots *pivots, size_t nentries, const int *rows, const int *columns,
                            const double *scale);

#endif
