/* The tables of a sparse elimination, from its pivots and their fill: see lu.h. */
#include "lu.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Where the pivots come in the elimination: its sequence, and the places of rows and columns of the matrix. */
typedef struct {
    int *sequence, *row, *column;
} places;

static void place(const flexel_pivots *p, places *at)
{
    for (size_t i = 0; i < p->n; i++) {
        at->row[p->row[at->sequence[i]]] = (int)i;
        at->column[p->column[at->sequence[i]]] = (int)i;
    }
}

/* Later pivots that a pivot changes, one after another: first the columns of its row, then the rows of its column. */
static int successor(const flexel_pivots *p, const places *at, size_t k, size_t e)
{
    const size_t u = p->upper_start[k + 1] - p->upper_start[k];
    return e < u ? at->column[p->upper[p->upper_start[k] + e]] : at->row[p->lower[p->lower_start[k] + e - u]];
}

static size_t successors(const flexel_pivots *p, size_t k)
{
    return p->upper_start[k + 1] - p->upper_start[k] + p->lower_start[k + 1] - p->lower_start[k];
}

/* Put the pivots in an order in which those that follow from one another are neighbours, so that entries that are used
 * together are neighbours too: a depth-first walk through the tree in which a pivot's parent is the first one that it
 * changes. The order found by the search is kept where the walk would come to a pivot before one that changes it. */
static void arrange(const flexel_pivots *p, places *at, int *work)
{
    const size_t n = p->n;
    int *parent = work, *child = work + n, *sibling = work + 2 * n + 1, *walk = work + 3 * n + 1;
    for (size_t i = 0; i < n; i++)
        at->sequence[i] = (int)i;
    place(p, at);
    for (size_t i = 0; i <= n; i++)
        child[i] = -1;
    for (size_t k = n; k-- > 0;) {
        parent[k] = (int)n; /* the root */
        for (size_t e = 0; e < successors(p, k); e++) {
            const int i = successor(p, at, k, e);
            parent[k] = i < parent[k] ? i : parent[k];
        }
        sibling[k] = child[parent[k]];
        child[parent[k]] = (int)k;
    }
    size_t done = 0;
    for (int i = child[n]; done < n;) { /* walk[k]: when the walk leaves pivot k */
        while (child[i] >= 0)
            i = child[i];
        walk[i] = (int)done++;
        while (sibling[i] < 0 && (size_t)parent[i] < n) {
            i = parent[i];
            walk[i] = (int)done++;
        }
        i = sibling[i];
    }
    for (size_t k = 0; k < n; k++)
        for (size_t e = 0; e < successors(p, k); e++)
            if (walk[successor(p, at, k, e)] < walk[k])
                return;
    for (size_t k = 0; k < n; k++)
        at->sequence[walk[k]] = (int)k;
    place(p, at);
}

/* Slots, row by row: multipliers from `lower` in the order of the pivots that they belong to, then the pivot and the
 * columns of `upper`, sorted by going through them column by column. */
static void lay_out(const flexel_pivots *p, const places *at, flexel_lu *lu, int *work)
{
    const size_t n = p->n;
    int *next = work, *start = work + n, *list = work + 2 * n + 1;
    memset(work, 0, (2 * n + 1) * sizeof *work);
    for (size_t e = 0; e < p->lower_start[n]; e++)
        next[at->row[p->lower[e]]]++;
    for (size_t i = 0, slot = 0; i < n; i++) {
        const size_t k = (size_t)at->sequence[i];
        lu->first[i] = (int)slot;
        lu->diagonal[i] = (int)slot + next[i];
        slot += (size_t)next[i] + 1 + p->upper_start[k + 1] - p->upper_start[k];
        next[i] = lu->first[i];
        lu->first[i + 1] = (int)slot;
        for (size_t e = p->upper_start[k]; e < p->upper_start[k + 1]; e++)
            start[at->column[p->upper[e]] + 1]++;
    }
    for (size_t i = 0; i < n; i++) {
        const size_t k = (size_t)at->sequence[i];
        start[i + 1] += start[i];
        lu->operations += (p->lower_start[k + 1] - p->lower_start[k]) * (p->upper_start[k + 1] - p->upper_start[k]);
        for (size_t e = p->lower_start[k]; e < p->lower_start[k + 1]; e++)
            lu->at[next[at->row[p->lower[e]]]++] = (int)i;
        lu->at[next[i]] = (int)i;
    }
    for (size_t i = 0; i < n; i++) {
        const size_t k = (size_t)at->sequence[i];
        for (size_t e = p->upper_start[k]; e < p->upper_start[k + 1]; e++)
            list[start[at->column[p->upper[e]]]++] = (int)i;
        next[i] = lu->diagonal[i] + 1;
    }
    for (size_t j = 0, e = 0; j < n; j++)
        for (; e < (size_t)start[j]; e++)
            lu->at[next[list[e]]++] = (int)j;
}

/* Multipliers by column, rows in order: those of column k from start[k] to start[k + 1]. */
static void list_multipliers(flexel_lu *lu, int *start)
{
    memset(start, 0, (lu->n + 1) * sizeof *start);
    for (size_t i = 0; i < lu->n; i++)
        for (int s = lu->first[i]; s < lu->diagonal[i]; s++)
            start[lu->at[s] + 1]++;
    for (size_t i = 0; i < lu->n; i++)
        start[i + 1] += start[i];
    for (size_t i = 0; i < lu->n; i++)
        for (int s = lu->first[i]; s < lu->diagonal[i]; s++)
            lu->multiplier[start[lu->at[s]]++] = s;
    memmove(start + 1, start, lu->n * sizeof *start);
    start[0] = 0;
}

/* Whether pivot k + 1 has the columns and rows of pivot k, apart from itself. If each is in the row and the column of
 * the other, fill has given it all of them: then only their number is compared. */
static int alike(const flexel_lu *lu, const int *start, size_t k)
{
    const int d = lu->diagonal[k], next = lu->diagonal[k + 1];
    if (lu->first[k + 1] - d != lu->first[k + 2] - next + 1 || start[k + 2] - start[k + 1] + 1 != start[k + 1] - start[k])
        return 0;
    return lu->at[d + 1] == (int)k + 1 && next > lu->first[k + 1] && lu->at[next - 1] == (int)k;
}

/* Groups of pivots, and the rows below each; the lists of multipliers are shortened to those of first pivots. */
static void form_groups(flexel_lu *lu, const int *start)
{
    int kept = 0;
    for (size_t k = 0, end; k < lu->n; k = end) {
        for (end = k + 1; end < lu->n && end < k + FLEXEL_GROUP && alike(lu, start, end - 1);)
            end++;
        lu->group[lu->groups] = (int)k;
        lu->below[lu->groups++] = kept;
        for (int l = start[k] + (int)(end - k - 1); l < start[k + 1]; l++)
            lu->multiplier[kept++] = lu->multiplier[l];
    }
    lu->group[lu->groups] = (int)lu->n;
    lu->below[lu->groups] = kept;
}

/* Slots of the matrix's entries, each found in its row by halving. */
static void find_slots(flexel_lu *lu, const places *at, const int *rows, const int *columns)
{
    for (size_t e = 0; e < lu->nentries; e++) {
        const int i = at->row[rows[e]], j = at->column[columns[e]];
        int low = lu->first[i], high = lu->first[i + 1] - 1;
        while (low < high) {
            const int middle = low + (high - low) / 2;
            if (lu->at[middle] < j)
                low = middle + 1;
            else
                high = middle;
        }
        lu->slot[e] = low;
    }
}

/* The stretches with `size` slots of one row below a group, from *stretch on, which moves behind them: the columns of the
 * group's rows, from `begin` to `end` in the last of these, found again in that row from slot `to` on. */
static void cut_stretches(const flexel_lu *lu, int begin, int end, int to, int by, int size, flexel_stretch **stretch)
{
    for (int from = begin, length; from < end; from += length, to += length) {
        while (lu->at[to] != lu->at[from])
            to++;
        for (length = 1; from + length < end && lu->at[to + length] == lu->at[from + length];)
            length++;
        const int done = size == 4 ? 0 : length / (2 * size) * (2 * size); /* in larger ones */
        for (int i = done; i + size <= length; i += size)
            *(*stretch)++ = (flexel_stretch){to + i, from + i - begin, by};
    }
}

/* The stretches of all rows below each group, the largest first. */
static int list_stretches(flexel_lu *lu)
{
    size_t count = 0, room = 0;
    for (size_t g = 0; g < lu->groups; g++) {
        const int last = lu->group[g + 1] - 1, behind = last - lu->group[g];
        const int begin = lu->diagonal[last] + 1, end = lu->first[last + 1];
        const size_t most = (size_t)(end - begin) * (size_t)(lu->below[g + 1] - lu->below[g]);
        if (count + most > room) {
            room = 2 * (count + most);
            flexel_stretch *more = room < INT_MAX ? realloc(lu->stretch, room * sizeof *more) : NULL;
            if (!more)
                return 0;
            lu->stretch = more;
        }
        flexel_stretch *stretch = lu->stretch + count;
        for (int size = 4, i = 0; size; size /= 2, i++) {
            lu->run[3 * g + (size_t)i] = (int)(stretch - lu->stretch);
            for (int l = lu->below[g]; l < lu->below[g + 1]; l++)
                cut_stretches(lu, begin, end, lu->multiplier[l] + behind + 1, lu->multiplier[l], size, &stretch);
        }
        count = (size_t)(stretch - lu->stretch);
    }
    lu->run[3 * lu->groups] = (int)count;
    flexel_stretch *exact = realloc(lu->stretch, (count + 1) * sizeof *exact);
    lu->stretch = exact ? exact : lu->stretch;
    return 1;
}

/* Sign of a permutation, by following its cycles. */
static int sign(size_t n, const int *permutation, int *work)
{
    int found = 1;
    memcpy(work, permutation, n * sizeof *work);
    for (size_t i = 0; i < n; i++)
        while (work[i] != (int)i) {
            const int j = work[i];
            work[i] = work[j];
            work[j] = j;
            found = -found;
        }
    return found;
}

static flexel_lu *allocate(size_t n, size_t nentries, size_t nlower, size_t slots)
{
    flexel_lu *lu = calloc(1, sizeof *lu);
    if (!lu)
        return NULL;
    lu->n = n;
    lu->nentries = nentries;
    lu->slots = slots;
    int **const arrays[] = {&lu->row, &lu->column, &lu->first, &lu->diagonal, &lu->at, &lu->slot,
                            &lu->group, &lu->below, &lu->multiplier, &lu->run};
    const size_t sizes[] = {n, n, n + 1, n, slots, nentries, n + 1, n + 1, nlower, 3 * n + 1};
    int good = 1;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        good &= (*arrays[i] = malloc((sizes[i] + 1) * sizeof(int))) != NULL;
    lu->scale = malloc((slots + 1) * sizeof *lu->scale);
    if (good && lu->scale)
        return lu;
    flexel_lu_free(lu);
    return NULL;
}

flexel_lu *flexel_lu_tables(const flexel_pivots *p, size_t nentries, const int *rows, const int *columns,
                            const double *scale)
{
    const size_t n = p->n, slots = n + p->lower_start[n] + p->upper_start[n];
    if (slots + n > INT_MAX)
        return NULL;
    int *work = malloc((7 * n + 2 + p->upper_start[n]) * sizeof *work);
    flexel_lu *lu = allocate(n, nentries, p->lower_start[n], slots);
    int good = work && lu;
    if (good) {
        places at = {work, work + n, work + 2 * n};
        int *rest = work + 3 * n;
        arrange(p, &at, rest);
        lay_out(p, &at, lu, rest);
        for (size_t i = 0; i < n; i++) {
            lu->row[i] = p->row[at.sequence[i]];
            lu->column[i] = p->column[at.sequence[i]];
        }
        for (size_t s = 0; s < slots; s++)
            lu->scale[s] = scale[lu->column[lu->at[s]]];
        list_multipliers(lu, rest);
        form_groups(lu, rest);
        find_slots(lu, &at, rows, columns);
        lu->sign = sign(n, lu->row, rest) * sign(n, lu->column, rest);
        good = list_stretches(lu);
    }
    free(work);
    if (good)
        return lu;
    flexel_lu_free(lu);
    return NULL;
}
