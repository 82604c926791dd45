/* The tangent of the balance of forces, element by element in the lanes of their blocks; see evaluate.h. */
#include "evaluate.h"

#include <string.h>

enum { LANES = FLEXEL_BLOCK };

/* y += z x in all lanes of a row */
static inline void add_row(const double *restrict z, const double *restrict x, double *restrict y)
{
#pragma omp simd
    for (size_t l = 0; l < LANES; l++)
        y[l] += z[l] * x[l];
}

/* to[at] += factor entry, for the entries of one block; the factors of the lanes may be given by `share` too */
FLEXEL_CLONES
static void add_entries(const flexel_local *entries, size_t block, double factor, const double *share, double *to)
{
    if (block >= entries->nblocks)
        return;
    const double *rows = entries->rows + block * entries->n * LANES;
    double z[LANES];
    for (size_t l = 0; l < LANES; l++)
        z[l] = share ? factor * share[l] : factor;
    for (size_t i = 0; i < entries->n; i++)
        add_row(z, rows + i * LANES, to + (size_t)entries->at[i] * LANES);
}

/* Derivatives of laws for one pair of rows; returns whether any of them is not zero. */
static int law_lanes(const flexel_work *s, const int *pair, double by_x, double by_v, double *value, double *rate)
{
    int any = 0;
    for (size_t l = 0; l < LANES; l++) {
        const double S = s->S[pair[l]], D = s->S_rate[pair[l]];
        value[l] = by_x * S + by_v * D;
        rate[l] = by_x * D;
        any |= S != 0 || D != 0;
    }
    return any;
}

/* y += z x in all lanes of `count` rows */
FLEXEL_CLONES
static void accumulate(size_t count, const double *restrict z, const double *restrict x, double *restrict y)
{
    for (size_t j = 0; j < count; j++)
        add_row(z, x + j * LANES, y + j * LANES);
}

/* K += De' W, both (rows, columns); only one half is computed where the product is symmetric. */
FLEXEL_CLONES
static void product(size_t rows, size_t columns, int symmetric, const double *restrict De, const double *restrict W,
                    double *restrict K)
{
    for (size_t p = 0; p < columns; p++)
        for (size_t q = symmetric ? p : 0; q < columns; q++) {
            double z[LANES] = {0};
            for (size_t i = 0; i < rows; i++)
                add_row(De + (i * columns + p) * LANES, W + (i * columns + q) * LANES, z);
#pragma omp simd
            for (size_t l = 0; l < LANES; l++)
                K[(p * columns + q) * LANES + l] += z[l];
            if (!symmetric || q == p)
                continue;
#pragma omp simd
            for (size_t l = 0; l < LANES; l++)
                K[(q * columns + p) * LANES + l] += z[l];
        }
}

/* K += De' (by_x (S De + D Phi) + by_v D De) for one block; nothing is done where all derivatives are zero. */
static void add_laws(const flexel_work *s, const flexel_batch *b, size_t block, double by_x, double by_v, int phi, double *K)
{
    const size_t rows = b->rows, columns = b->columns, size = rows * columns * LANES;
    const size_t pairs = b->diagonal ? rows : rows * rows;
    double *De = K + columns * columns * LANES, *P = De + size, *W = P + size;
    const int *pair = b->pair + block * pairs * LANES;
    int any = 0, ready = 0;
    for (size_t i = 0; i < pairs; i++) {
        double value[LANES], rate[LANES];
        if (!law_lanes(s, pair + i * LANES, by_x, by_v, value, rate))
            continue;
        if (!ready) {
            memset(De, 0, 3 * size * sizeof(double));
            add_entries(&b->De, block, 1, 0, De);
            add_entries(&b->V, block, 1, 0, De);
            if (phi)
                add_entries(&b->Phi, block, 1, 0, P);
            ready = 1;
        }
        any = 1;
        const size_t row = b->diagonal ? i : i / rows, column = b->diagonal ? i : i % rows;
        accumulate(columns, value, De + column * columns * LANES, W + row * columns * LANES);
        if (phi)
            accumulate(columns, rate, P + column * columns * LANES, W + row * columns * LANES);
    }
    if (any)
        product(rows, columns, b->diagonal && !phi, De, W, K);
}

/* Lane by lane, those with an element: neighbouring lanes often have the same slots, and sums into one place wait for each
 * other. */
static void scatter(const flexel_batch *b, size_t block, const double *restrict K, double *restrict T)
{
    const int *restrict slot = b->slot + block * b->nused * LANES, *restrict used = b->used;
    const size_t left = b->size - block * LANES, lanes = left < LANES ? left : LANES;
    for (size_t l = 0; l < lanes; l++)
        for (size_t u = 0; u < b->nused; u++)
            T[slot[u * LANES + l]] += K[(size_t)used[u] * LANES + l];
}

static int zero(size_t n, const double *values)
{
    for (size_t i = 0; i < n; i++)
        if (values[i] != 0)
            return 0;
    return 1;
}

/* Whether nothing acts in a block: no inertia, no stress, no derivative of a law, as in open contacts. */
static int idle(const flexel_work *s, const flexel_batch *b, size_t block)
{
    if (block < b->M.nblocks || block < b->R_x.nblocks || block < b->R_v.nblocks)
        return 0;
    if (!zero(b->nsigma * LANES, b->sigma + block * b->nsigma * LANES))
        return 0;
    if (!zero(b->ntau * LANES, b->tau + block * b->ntau * LANES))
        return 0;
    const size_t pairs = (b->diagonal ? b->rows : b->rows * b->rows) * LANES;
    for (size_t i = 0; b->pair && i < pairs; i++) {
        const int pair = b->pair[block * pairs + i];
        if (s->S[pair] != 0 || s->S_rate[pair] != 0)
            return 0;
    }
    return 1;
}

static void add_batch(const flexel_work *s, const flexel_batch *b, double by_x, double by_v, double by_a, int phi)
{
    double *K = s->local;
    for (size_t block = 0; block < b->nblocks; block++) {
        if ((b->active && !b->active[block]) || idle(s, b, block))
            continue;
        memset(K, 0, b->columns * b->columns * LANES * sizeof(double));
        if (by_x != 0) {
            add_entries(&b->K, block, by_x, 0, K);
            add_entries(&b->R_x, block, by_x, 0, K);
        }
        if (by_v != 0) {
            add_entries(&b->R_v, block, by_v, 0, K);
            if (b->share)
                add_entries(&b->M, block, by_v, b->share + block * LANES, K);
        }
        if (by_a != 0)
            add_entries(&b->M, block, by_a, 0, K);
        if (b->pair)
            add_laws(s, b, block, by_x, by_v, phi, K);
        scatter(b, block, K, s->T);
    }
}

/* Pairs of quantities of different elements, and of relations: products of entries of J. */
static void add_foreign(flexel_work *s, double by_x, double by_v, int phi)
{
    for (size_t i = 0; i < s->nforeign; i++) {
        const int pair = s->foreign_pair[i], right = s->foreign_right[i];
        if (s->S[pair] == 0 && s->S_rate[pair] == 0)
            continue;
        double z = (by_x * s->S[pair] + by_v * s->S_rate[pair]) * s->J[right];
        if (phi)
            z += by_x * s->S_rate[pair] * s->Phi[right];
        s->T[s->foreign_slot[i]] += s->J[s->foreign_left[i]] * z;
    }
}

/* The kernels of the derivatives by x, and of those by x and v. */
static void run(flexel_work *s, int by_x, int by_v)
{
    if (by_x) {
        memcpy(s->element_stress, s->stress, (s->m + s->k) * sizeof(double));
        flexel_add(&s->relation_stress, s->stress, s->element_stress);
        flexel_take(&s->sigma, s->element_stress, s->sigma8);
        flexel_take(&s->tau, s->element_stress, s->tau8);
        flexel_run(&s->stiffness);
    }
    if (s->tangent.ncalls && (by_x || by_v)) {
        flexel_take_for(&s->tangent, &s->coordinates, s->v, s->v8);
        flexel_take_for(&s->tangent, &s->coordinates, s->a, s->a8);
        if (s->share8) /* the tangent of M (a + share v) */
            for (size_t i = 0; i < s->n8; i++)
                s->a8[i] += s->share8[i] * s->v8[i];
        flexel_run(&s->tangent);
    }
}

static void sum(flexel_work *s, double by_x, double by_v, double by_a, int phi)
{
    memset(s->T, 0, (s->nT + 1) * sizeof(double));
    for (size_t i = 0; i < s->nbatches; i++)
        add_batch(s, s->batches + i, by_x, by_v, by_a, phi);
    add_foreign(s, by_x, by_v, phi);
}

void flexel_tangent(flexel_work *s, double by_x, double by_v, double by_a, int phi)
{
    run(s, by_x != 0, by_v != 0);
    sum(s, by_x, by_v, by_a, phi);
}

void flexel_tangents(flexel_work *s, double *r_x, double *r_v)
{
    run(s, 1, 1);
    sum(s, 1, 0, 0, 1);
    memcpy(r_x, s->T, s->nT * sizeof(double));
    sum(s, 0, 1, 0, 1);
    memcpy(r_v, s->T, s->nT * sizeof(double));
}
