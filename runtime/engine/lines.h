/* Rows and columns of a sparse matrix that is being eliminated, and lists of them by their number of entries. */
#ifndef FLEXEL_LINES_H
#define FLEXEL_LINES_H

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* A row or a column of what is left: the other numbers of its entries, and a row's values [entry][sample]. */
typedef struct {
    int count, room;
    int *other;
    double *value;
} line;

/* Lines by their number of entries, doubly linked; -1 ends a list. */
typedef struct {
    int *head, *next, *previous;
} lists;

static inline void enlist(lists *l, int i, int count)
{
    l->previous[i] = -1 - count;
    l->next[i] = l->head[count];
    if (l->next[i] >= 0)
        l->previous[l->next[i]] = i;
    l->head[count] = i;
}

static inline void unlist(lists *l, int i)
{
    if (l->previous[i] >= 0)
        l->next[l->previous[i]] = l->next[i];
    else
        l->head[-1 - l->previous[i]] = l->next[i];
    if (l->next[i] >= 0)
        l->previous[l->next[i]] = l->previous[i];
}

/* Space for one more entry, of `samples` values. */
static inline int grow(line *l, size_t samples)
{
    if (l->count < l->room)
        return 1;
    const size_t room = 2 * (size_t)l->room + 4;
    int *other = realloc(l->other, room * sizeof *other);
    if (!other)
        return 0;
    l->other = other;
    if (samples) {
        double *value = realloc(l->value, room * samples * sizeof *value);
        if (!value)
            return 0;
        l->value = value;
    }
    l->room = (int)room;
    return 1;
}

static inline int find(const line *l, int other)
{
    int e = 0;
    while (l->other[e] != other)
        e++;
    return e;
}

/* Take out entry e; the last one comes in its place. */
static inline void take_out(line *l, int e, size_t samples)
{
    const int last = --l->count;
    l->other[e] = l->other[last];
    if (samples)
        memcpy(l->value + (size_t)e * samples, l->value + (size_t)last * samples, samples * sizeof(double));
}

#endif
