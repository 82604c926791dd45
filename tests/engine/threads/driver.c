/* One model in several threads, without Python: reads the file that tests/image.py writes, and moves the model by steps of
 * the explicit method, and one of Radau IIA, in all threads at once, each with structures of its own. All must find the same
 * digits, which are printed. To be compiled with a sanitizer. */
#include "evaluate.h"
#include "explicit.h"
#include "radau.h"
#include "runge_kutta.h"
#include "state.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SYMBOL = 56, PARTS = 4, STEPS = 20, ROUNDS = 3 };

static const double STEP = 1e-3, SHORT = 1e-5;

typedef struct {
    flexel_work *work;
    flexel_choice *choice;
    flexel_dop853 *run;
    flexel_radau *implicit;
    const double *samples;
    size_t stride, length;
    double *state; /* found at the end; followed by the derivatives of the forces */
    pthread_barrier_t *begin;
    int failed;
} task;

static void *claimed(size_t size)
{
    void *found = malloc(size ? size : 1);
    if (!found) {
        fprintf(stderr, "driver: no memory\n");
        exit(2);
    }
    return found;
}

static void get(void *to, size_t size, FILE *in)
{
    if (fread(to, 1, size, in) != size) {
        fprintf(stderr, "driver: the file is too short\n");
        exit(2);
    }
}

static uint64_t number(FILE *in)
{
    uint64_t found;
    get(&found, sizeof found, in);
    return found;
}

/* A pointer is moved to the copy of what it pointed to. */
static void point(char **memory, FILE *in)
{
    const uint64_t from = number(in), offset = number(in), to = number(in), at = number(in);
    char *target = memory[to] + at;
    memcpy(memory[from] + offset, &target, sizeof target);
}

/* A pointer to a kernel is that of the table of this program. */
static void link_kernel(char **memory, const uint64_t *place, const char *symbol)
{
    const char *table = dlsym(RTLD_DEFAULT, symbol);
    if (!table) {
        fprintf(stderr, "driver: no kernels '%s'\n", symbol);
        exit(2);
    }
    memcpy(memory[place[0]] + place[1], table + place[2], sizeof(flexel_kernel));
}

/* One step of Radau IIA from where the other method has come to. Its matrices are factorized for this length already. */
static int implicit_step(task *own, double t)
{
    flexel_work *s = own->work;
    flexel_choice *c = own->choice;
    flexel_radau *r = own->implicit;
    memcpy(r->y, own->run->y, r->ny * sizeof(double));
    memcpy(r->x, s->x, s->n * sizeof(double));
    memcpy(r->v, s->v, s->n * sizeof(double));
    memcpy(r->e, s->e, s->m * sizeof(double));
    memset(r->ed, 0, s->m * sizeof(double));
    r->t = t;
    r->h = SHORT;
    int failed = flexel_radau_begin(s, c, r);
    failed = failed ? failed : flexel_radau_step(s, c, r);
    if (!failed)
        flexel_radau_accept(s, c, r);
    return failed;
}

/* The same motion several times from the same start; then the state and the derivatives of the forces. */
static int moved(task *own)
{
    flexel_work *s = own->work;
    flexel_choice *c = own->choice;
    flexel_dop853 *o = own->run;
    int failed = 0;
    double t = 0;
    flexel_reset(s, c);
    failed = flexel_dop853_begin(s, c, o, t);
    for (int i = 0; i < STEPS && !failed; i++, t += STEP) {
        failed = flexel_dop853_step(s, c, o, t, STEP);
        if (!failed)
            flexel_dop853_accept(s, o);
    }
    failed = failed ? failed : implicit_step(own, t);
    if (failed)
        return failed;
    flexel_complete(s, c, 0);
    flexel_rates(s);
    flexel_convective(s);
    flexel_state(s, own->state);
    memcpy(s->stress, s->element_stress, (s->m + s->k) * sizeof(double));
    flexel_rate_derivatives(s);
    flexel_law_tangents(s, 0, 0);
    flexel_tangents(s, own->state + own->length - 2 * s->nT, own->state + own->length - s->nT);
    return 0;
}

static void *run(void *argument)
{
    task *own = argument;
    flexel_dop853 *o = own->run;
    const size_t ny = o->ny * sizeof(double), n = own->work->n * sizeof(double), ne = own->work->nperiodic * sizeof(double);
    double *y = claimed(ny), *x = claimed(n), *e = claimed(ne);
    memcpy(y, o->y, ny), memcpy(x, o->x, n), memcpy(e, o->e, ne);
    pthread_barrier_wait(own->begin);
    for (int i = 0; i < ROUNDS && !own->failed; i++) {
        flexel_matrix_prepare(&own->choice->P, 2, own->samples, own->stride);
        flexel_matrix_prepare(&own->choice->A, 2, own->samples, own->stride);
        memcpy(o->y, y, ny), memcpy(o->x, x, n), memcpy(o->e, e, ne);
        own->failed = moved(own);
        flexel_choice_clear(own->choice);
    }
    free(y), free(x), free(e);
    return NULL;
}

int main(int argc, char **argv)
{
    FILE *in = argc > 1 ? fopen(argv[1], "rb") : NULL;
    if (!in) {
        fprintf(stderr, "driver: give the file\n");
        return 2;
    }
    const uint64_t nregions = number(in), npointers = number(in), nkernels = number(in), nthreads = number(in);
    const uint64_t samples = number(in), stride = number(in), length = number(in);
    uint64_t *sizes = claimed(nregions * sizeof(uint64_t));
    char **memory = claimed(nregions * sizeof(char *));
    get(sizes, nregions * sizeof(uint64_t), in);
    for (size_t i = 0; i < nregions; i++)
        memory[i] = claimed(sizes[i]);
    /* the contents come last in the file, and the pointers must come after them */
    const long lists = ftell(in);
    fseek(in, (long)(npointers * 4 * 8 + nkernels * (3 * 8 + SYMBOL) + nthreads * PARTS * 8), SEEK_CUR);
    for (size_t i = 0; i < nregions; i++)
        get(memory[i], sizes[i], in);
    fseek(in, lists, SEEK_SET);
    for (size_t i = 0; i < npointers; i++)
        point(memory, in);
    for (size_t i = 0; i < nkernels; i++) {
        uint64_t place[3];
        char symbol[SYMBOL];
        get(place, sizeof place, in);
        get(symbol, sizeof symbol, in);
        link_kernel(memory, place, symbol);
    }
    task *tasks = claimed(nthreads * sizeof(task));
    pthread_t *threads = claimed(nthreads * sizeof(pthread_t));
    pthread_barrier_t begin;
    pthread_barrier_init(&begin, NULL, (unsigned)nthreads);
    for (size_t i = 0; i < nthreads; i++) {
        task *own = tasks + i;
        own->work = (void *)memory[number(in)];
        own->choice = (void *)memory[number(in)];
        own->run = (void *)memory[number(in)];
        own->implicit = (void *)memory[number(in)];
        own->samples = (const void *)memory[samples];
        own->stride = stride;
        own->length = length + 2 * own->work->nT;
        own->state = claimed(own->length * sizeof(double));
        own->begin = &begin;
        own->failed = 0;
    }
    fclose(in);
    for (size_t i = 0; i < nthreads; i++)
        pthread_create(threads + i, NULL, run, tasks + i);
    int bad = 0;
    for (size_t i = 0; i < nthreads; i++) {
        pthread_join(threads[i], NULL);
        if (tasks[i].failed || memcmp(tasks[i].state, tasks[0].state, tasks[0].length * sizeof(double))) {
            fprintf(stderr, "driver: thread %zu: code %d, or other digits\n", i, tasks[i].failed);
            bad = 1;
        }
    }
    for (size_t i = 0; i < tasks[0].length; i++)
        printf("%.17g\n", tasks[0].state[i]);
    pthread_barrier_destroy(&begin);
    for (size_t i = 0; i < nthreads; i++)
        free(tasks[i].state);
    for (size_t i = 0; i < nregions; i++)
        free(memory[i]);
    free(memory), free(sizes), free(tasks), free(threads);
    return bad;
}
