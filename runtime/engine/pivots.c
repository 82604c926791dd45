/* Threshold Markowitz: see pivots.h. The matrix that is left is kept in rows with values and columns without, rows and
 * columns in lists by their number of entries. Only a few of the shortest are searched for the next pivot.
 * Source: Duff, Erisman and Reid (2017), Direct Methods for Sparse Matrices, chapters 7 and 10. */
#include "lines.h"
#include "pivots.h"

#include <math.h>
#include <stdint.h>

static const double THRESHOLD = 0.1; /* least size of a pivot, relative to the largest entry of its row */
static const double LOWEST = 1e-3;   /* the same where no entry is that large in all matrices */
static const double TINY = 1e-13;    /* least size of a pivot in a scaled matrix: smaller ones are rounding errors */
static const int SEARCHED = 8;       /* rows and columns with candidates that are searched for one pivot */

typedef struct {
    size_t n, samples;
    line *rows, *columns;
    lists row_lists, column_lists;
    double *largest; /* [row][sample] */
    double *factor;  /* [sample] */
    int *where;      /* place of a column in the row at hand, or -1 */
    double threshold;
} matrix;

typedef struct {
    int row, column;
    int64_t cost;   /* entries that may fill */
    double quality; /* smallest ratio to the largest entry of the row, over the samples */
} candidate;

static void measure(matrix *A, int i)
{
    const line *l = A->rows + i;
    double *largest = A->largest + (size_t)i * A->samples;
    for (size_t s = 0; s < A->samples; s++)
        largest[s] = 0;
    for (int e = 0; e < l->count; e++)
        for (size_t s = 0; s < A->samples; s++) {
            const double z = fabs(l->value[(size_t)e * A->samples + s]);
            largest[s] = z > largest[s] ? z : largest[s];
        }
}

/* Take entry e of row i as the best one, if it is sound, and fills less or is larger. */
static int consider(const matrix *A, int i, int e, candidate *best)
{
    const line *l = A->rows + i;
    const int64_t cost = (int64_t)(l->count - 1) * (A->columns[l->other[e]].count - 1);
    if (cost > best->cost)
        return 0;
    double quality = 1;
    for (size_t s = 0; s < A->samples; s++) {
        const double z = fabs(l->value[(size_t)e * A->samples + s]), largest = A->largest[(size_t)i * A->samples + s];
        if (!(z >= TINY && z >= A->threshold * largest))
            return 0;
        quality = z < quality * largest ? z / largest : quality;
    }
    if (cost < best->cost || quality > best->quality)
        *best = (candidate){i, l->other[e], cost, quality};
    return 1;
}

/* The pivot with the least fill among the shortest rows and columns; row -1 if none is sound. */
static candidate search(const matrix *A)
{
    candidate best = {-1, -1, INT64_MAX, 0};
    int searched = 0;
    for (int64_t length = 1; length <= (int64_t)A->n && searched < SEARCHED; length++) {
        if (best.cost <= (length - 1) * (length - 1))
            break;
        for (int j = A->column_lists.head[length]; j >= 0 && searched < SEARCHED; j = A->column_lists.next[j]) {
            const line *l = A->columns + j;
            int sound = 0;
            for (int e = 0; e < l->count; e++)
                sound |= consider(A, l->other[e], find(A->rows + l->other[e], j), &best);
            searched += sound;
        }
        if (best.cost <= length * (length - 1))
            break;
        for (int i = A->row_lists.head[length]; i >= 0 && searched < SEARCHED; i = A->row_lists.next[i]) {
            int sound = 0;
            for (int e = 0; e < A->rows[i].count; e++)
                sound |= consider(A, i, e, &best);
            searched += sound;
        }
    }
    return best;
}

/* Subtract the pivot row p from row i so that its entry in column q vanishes. */
static int subtract(matrix *A, int i, int p, int q)
{
    line *y = A->rows + i;
    const line *x = A->rows + p;
    const size_t samples = A->samples;
    const int eq = find(y, q), pq = find(x, q);
    for (size_t s = 0; s < samples; s++)
        A->factor[s] = y->value[(size_t)eq * samples + s] / x->value[(size_t)pq * samples + s];
    take_out(y, eq, samples);
    for (int e = 0; e < y->count; e++)
        A->where[y->other[e]] = e;
    for (int u = 0; u < x->count; u++) {
        const int j = x->other[u];
        if (j == q)
            continue;
        int e = A->where[j];
        if (e < 0) { /* fill */
            line *column = A->columns + j;
            if (!grow(y, samples) || !grow(column, 0))
                return 0;
            column->other[column->count++] = i;
            e = y->count++;
            y->other[e] = j;
            memset(y->value + (size_t)e * samples, 0, samples * sizeof(double));
        }
        for (size_t s = 0; s < samples; s++)
            y->value[(size_t)e * samples + s] -= A->factor[s] * x->value[(size_t)u * samples + s];
    }
    for (int e = 0; e < y->count; e++)
        A->where[y->other[e]] = -1;
    measure(A, i);
    unlist(&A->row_lists, i);
    enlist(&A->row_lists, i, y->count);
    return 1;
}

/* Append all entries of a line but one to an array that grows. */
static int append(const line *l, int except, size_t end, int **array, size_t *room)
{
    if (end + (size_t)l->count > *room) {
        *room = 2 * (end + (size_t)l->count);
        int *more = realloc(*array, *room * sizeof *more);
        if (!more)
            return 0;
        *array = more;
    }
    for (int e = 0; e < l->count; e++)
        if (l->other[e] != except)
            (*array)[end++] = l->other[e];
    return 1;
}

static int eliminate(matrix *A, int p, int q, flexel_pivots *f)
{
    line *row = A->rows + p, *column = A->columns + q;
    const size_t k = f->found;
    const size_t u = f->upper_start[k], l = f->lower_start[k];
    if (!append(row, q, u, &f->upper, &f->upper_room) || !append(column, p, l, &f->lower, &f->lower_room))
        return 0;
    f->row[k] = p, f->column[k] = q;
    f->upper_start[k + 1] = u + (size_t)row->count - 1;
    f->lower_start[k + 1] = l + (size_t)column->count - 1;
    f->found++;
    unlist(&A->row_lists, p);
    unlist(&A->column_lists, q);
    for (int e = 0; e < row->count; e++)
        if (row->other[e] != q)
            take_out(A->columns + row->other[e], find(A->columns + row->other[e], p), 0);
    for (int e = 0; e < column->count; e++)
        if (column->other[e] != p && !subtract(A, column->other[e], p, q))
            return 0;
    for (int e = 0; e < row->count; e++)
        if (row->other[e] != q) {
            unlist(&A->column_lists, row->other[e]);
            enlist(&A->column_lists, row->other[e], A->columns[row->other[e]].count);
        }
    return 1;
}

static int fill(matrix *A, size_t nentries, const int *rows, const int *columns, const double *scaled)
{
    const size_t samples = A->samples;
    for (size_t i = 0; i < nentries; i++) {
        line *row = A->rows + rows[i], *column = A->columns + columns[i];
        if (!grow(row, samples) || !grow(column, 0))
            return 0;
        memcpy(row->value + (size_t)row->count * samples, scaled + i * samples, samples * sizeof(double));
        row->other[row->count++] = columns[i];
        column->other[column->count++] = rows[i];
    }
    for (size_t i = 0; i <= A->n; i++)
        A->row_lists.head[i] = A->column_lists.head[i] = -1;
    for (int i = (int)A->n; i-- > 0;) { /* so that the first ones come first */
        A->where[i] = -1;
        measure(A, i);
        enlist(&A->row_lists, i, A->rows[i].count);
        enlist(&A->column_lists, i, A->columns[i].count);
    }
    return 1;
}

static int all_pivots(matrix *A, flexel_pivots *f)
{
    while (f->found < A->n) {
        A->threshold = THRESHOLD;
        candidate best = search(A);
        if (best.row < 0) {
            A->threshold = LOWEST;
            best = search(A);
        }
        if (best.row < 0)
            return 1;
        if (!eliminate(A, best.row, best.column, f))
            return 0;
    }
    return 1;
}

int flexel_pivots_find(flexel_pivots *pivots, size_t n, size_t nentries, const int *rows, const int *columns,
                       size_t nsamples, const double *scaled)
{
    int *index = malloc((7 * n + 2) * sizeof *index);
    double *number = malloc((n + 1) * nsamples * sizeof *number);
    line *lines = calloc(2 * n + 1, sizeof *lines);
    *pivots = (flexel_pivots){.n = n};
    pivots->row = malloc((n + 1) * sizeof(int));
    pivots->column = malloc((n + 1) * sizeof(int));
    pivots->upper_start = calloc(n + 1, sizeof(size_t));
    pivots->lower_start = calloc(n + 1, sizeof(size_t));
    int good = index && number && lines && pivots->row && pivots->column && pivots->upper_start && pivots->lower_start;
    if (good) {
        matrix A = {n, nsamples, lines, lines + n, {index, index + 2 * n + 2, index + 3 * n + 2},
                    {index + n + 1, index + 4 * n + 2, index + 5 * n + 2}, number, number + n * nsamples,
                    index + 6 * n + 2, THRESHOLD};
        good = fill(&A, nentries, rows, columns, scaled) && all_pivots(&A, pivots);
    }
    for (size_t i = 0; lines && i < 2 * n; i++) {
        free(lines[i].other);
        free(lines[i].value);
    }
    free(lines);
    free(number);
    free(index);
    return good;
}

void flexel_pivots_free(flexel_pivots *pivots)
{
    free(pivots->row);
    free(pivots->column);
    free(pivots->upper_start);
    free(pivots->lower_start);
    free(pivots->upper);
    free(pivots->lower);
}
