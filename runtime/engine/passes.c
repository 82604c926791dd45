/* In which order pivots are eliminated: see lu.h. A group of pivots has to wait for those that change its rows or columns, so
 * it has a level above theirs. Groups of one level and width are eliminated side by side. */
#include "lu.h"

#include <limits.h>
#include <stdlib.h>

/* A group with its level and width: by what they are sorted. */
typedef struct {
    int level, width, number;
} ranked;

/* Lists that grow. */
typedef struct {
    flexel_lu *lu;
    const flexel_groups *groups;
    size_t used, room, passes_room;
} lists;

static int row_of(const flexel_lu *lu, int slot)
{
    int low = 0, high = (int)lu->n - 1;
    while (low < high) {
        const int middle = low + (high - low + 1) / 2;
        if (lu->first[middle] <= slot)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/* Levels: above those of all groups that have entries in a group's rows or columns. `of` has the group of each pivot. */
static void rank(const flexel_lu *lu, const flexel_groups *groups, const int *of, ranked *found)
{
    for (size_t g = 0; g < groups->count; g++) {
        const int end = groups->first[g + 1], level = found[g].level + 1;
        found[g].width = end - groups->first[g];
        found[g].number = (int)g;
        for (int l = groups->below[g]; l < groups->below[g + 1]; l++) {
            ranked *other = found + of[row_of(lu, groups->multiplier[l])];
            other->level = other->level < level ? level : other->level;
        }
        for (int s = lu->diagonal[end - 1] + 1; s < lu->first[end]; s++) {
            ranked *other = found + of[lu->at[s]];
            other->level = other->level < level ? level : other->level;
        }
    }
}

static int by_rank(const void *a, const void *b)
{
    const ranked *x = a, *y = b;
    return x->level != y->level ? x->level - y->level : x->width != y->width ? x->width - y->width : x->number - y->number;
}

static int reserve(lists *to, size_t more)
{
    if (to->used + more <= to->room)
        return 1;
    const size_t room = 2 * (to->used + more);
    int *larger = room < INT_MAX ? realloc(to->lu->list, room * sizeof *larger) : NULL;
    if (larger) {
        to->lu->list = larger;
        to->room = room;
    }
    return larger != NULL;
}

/* One number, then another unless it is negative, then `shift` behind the slots where the rows of `width` pivots from
 * `first` on have the column that follows them. */
static int add(lists *to, int number, int another, int first, int width, int shift)
{
    if (!reserve(to, 2 + FLEXEL_GROUP))
        return 0;
    int *list = to->lu->list;
    list[to->used++] = number;
    if (another >= 0)
        list[to->used++] = another;
    for (int j = 0; j < width; j++)
        list[to->used++] = to->lu->diagonal[first + j] + width - j + shift;
    return 1;
}

/* Stretches of `size` slots of a row with multipliers from slot `by` on: the columns of the last of `width` pivots from
 * `first` on, found again in that row. */
static int cut(lists *to, int first, int width, int by, int size, int *count)
{
    const flexel_lu *lu = to->lu;
    const int last = first + width - 1, begin = lu->diagonal[last] + 1, end = lu->first[last + 1];
    int place = by + width;
    for (int from = begin, length; from < end; from += length, place += length) {
        while (lu->at[place] != lu->at[from])
            place++;
        for (length = 1; from + length < end && lu->at[place + length] == lu->at[from + length];)
            length++;
        const int done = size == 4 ? 0 : length / (2 * size) * (2 * size); /* in larger ones */
        for (int i = done; i + size <= length; i += size, ++*count)
            if (!add(to, place + i, by, first, width, from + i - begin))
                return 0;
    }
    return 1;
}

/* Rows from which those of the first `width` pivots of a group are subtracted: its next one, or all below; slot i of their
 * multipliers, or -1 behind the last one. */
static int row(const lists *to, const ranked *group, int width, int i)
{
    const int first = to->groups->first[group->number], below = to->groups->below[group->number] + i;
    if (width < group->width)
        return i ? -1 : to->lu->diagonal[first + width] - width;
    return below < to->groups->below[group->number + 1] ? to->groups->multiplier[below] : -1;
}

/* The pass in which `width` pivots of `count` groups are subtracted, and the next ones are done. */
static int add_pass(lists *to, const ranked *group, size_t count, int width)
{
    flexel_lu *lu = to->lu;
    if (lu->npasses == to->passes_room) {
        to->passes_room = 2 * to->passes_room + 16;
        flexel_pass *larger = realloc(lu->pass, to->passes_room * sizeof *larger);
        if (!larger)
            return 0;
        lu->pass = larger;
    }
    flexel_pass *pass = lu->pass + lu->npasses++;
    *pass = (flexel_pass){.width = width};
    int *const numbers[] = {&pass->rows, &pass->fours, &pass->twos, &pass->ones};
    for (int kind = 0; kind < 4 && width; kind++)
        for (size_t g = 0; g < count; g++)
            for (int i = 0, by; (by = row(to, group + g, width, i)) >= 0; i++) {
                const int first = to->groups->first[group[g].number];
                *numbers[0] += !kind;
                if (!(kind ? cut(to, first, width, by, 8 >> kind, numbers[kind]) : add(to, by, -1, first, width, 0)))
                    return 0;
            }
    if (width == group->width)
        return 1;
    pass->pivots = (int)count;
    for (size_t g = 0; g < count; g++)
        if (!add(to, to->groups->first[group[g].number] + width, -1, 0, 0, 0))
            return 0;
    return 1;
}

int flexel_lu_passes(flexel_lu *lu, const flexel_groups *groups)
{
    ranked *order = calloc(groups->count + 1, sizeof *order);
    int *of = malloc((lu->n + 1) * sizeof *of);
    lists to = {lu, groups, 0, 0, 0};
    int good = order && of && reserve(&to, 1);
    if (good) {
        for (size_t g = 0; g < groups->count; g++)
            for (int k = groups->first[g]; k < groups->first[g + 1]; k++)
                of[k] = (int)g;
        rank(lu, groups, of, order);
        qsort(order, groups->count, sizeof *order, by_rank);
        for (size_t g = 0, end; g < groups->count && good; g = end) {
            for (end = g + 1; end < groups->count && order[end].level == order[g].level && order[end].width == order[g].width;)
                end++;
            for (int width = 0; width <= order[g].width && good; width++)
                good = add_pass(&to, order + g, end - g, width);
        }
    }
    free(order);
    free(of);
    return good;
}
