/* Step control of every lane; see lanes.h. */
#include "dips.h"
#include "lanes_inside.h"

#include <math.h>

/* Times and lengths of the next trial; lanes that cannot take one stop. */
static void propose(flexel_lanes *l, flexel_trial *trial)
{
    for (size_t i = 0; i < FLEXEL_BLOCK; i++) {
        trial->t[i] = l->t[i], trial->h[i] = 0, trial->failed[i] = -1, trial->changed[i] = 0;
        if (l->doing[i] != FLEXEL_RUNNING)
            continue;
        if (!l->tries[i])
            l->first[i] = l->h[i];
        const double after = nextafter(l->t[i], INFINITY) - l->t[i], shortest = fmax(l->shortest, 10 * after);
        const int rests = !l->tries[i] && l->taken[i] >= l->most[i];
        if (rests || (l->h[i] < shortest && l->h[i] < l->end - l->t[i])) {
            l->doing[i] = FLEXEL_STOPPED;
            continue;
        }
        l->to[i] = fmin(l->t[i] + fmin(l->h[i], l->longest), l->end);
        trial->h[i] = l->to[i] - l->t[i];
        trial->failed[i] = 0;
    }
}

/* What a trial has found in one lane. */
static flexel_step_found found(const flexel_trial *trial, size_t i)
{
    return (flexel_step_found){trial->error[i],
                               trial->error_own[i],
                               trial->error_x[i],
                               trial->error_v[i],
                               trial->error_turns[i],
                               trial->defect[i],
                               trial->defect_v[i],
                               trial->fastest[i],
                               trial->changed[i] != 0};
}

/* Whether the step is where it was predicted, in degrees of freedom that are good enough. */
static int trusted(const flexel_lanes *l, const flexel_step_found *step, size_t i)
{
    return flexel_step_trusted(&l->rules, step, l->amplification[i], l->amplification_new[i]) &&
           l->amplification_new[i] <= l->allowed[i];
}

/* Whether a contact, or the force of a law, begins or ends in a step, or a contact may have been passed. */
static int touches(const flexel_lanes *l, size_t i)
{
    const flexel_dop853 *steps = l->steps;
    const double h = l->to[i] - l->t[i];
    return flexel_touching_look(&l->touching, l->work, steps->x, l->e, l->w, steps->x_new, h, FLEXEL_BLOCK, i);
}

/* Whether a step may have passed a flat position, as in dips.py: the determinant falls in it, or fell in the step before. */
static int dips(flexel_lanes *l, size_t i)
{
    l->size_new[i] = flexel_lanes_logarithm(&l->choice->P, i);
    return l->size[i] - l->size_new[i] >= FLEXEL_DIP || (!isnan(l->size[i]) && l->fall[i] >= FLEXEL_DIP);
}

/* What becomes of a trial in one lane: its step is good, or tried again with another length, or the lane stops. */
static int conclude(flexel_lanes *l, const flexel_trial *trial, size_t i)
{
    const flexel_step_found step = found(trial, i);
    const double error = flexel_error_of_step(&l->rules, &step);
    const int unusual = error < 1 ? step.changed || !trusted(l, &step, i)
                                  : isinf(error) || l->tries[i] || flexel_step_suspicious(&l->rules, &step);
    if (trial->failed[i] || unusual) {
        l->doing[i] = FLEXEL_STOPPED;
        return 0;
    }
    const double h = trial->h[i];
    if (!(error < 1)) {
        l->h[i] = h * flexel_shorter(&l->rules.control, l->rules.control.safety, error);
        l->tries[i]++;
        return 0;
    }
    const double factor = flexel_longer(&l->rules.control, error);
    l->h[i] = h * (l->tries[i] ? fmin(1, factor) : factor);
    return 1;
}

/* The step of a lane is taken: it goes on from the end. */
static void take(flexel_lanes *l, size_t i)
{
    const double h = l->to[i] - l->t[i];
    double *longest = l->steps->covered->sizes_new + FLEXEL_LONGEST * FLEXEL_BLOCK + i;
    *longest = fmax(*longest, h);
    l->doing[i] = FLEXEL_RUNNING;
    flexel_account_accept(l->accounts[i], h);
    l->t[i] = l->to[i];
    l->amplification[i] = l->amplification_new[i];
    l->fall[i] = isnan(l->size[i]) ? 0 : l->size[i] - l->size_new[i];
    l->size[i] = l->size_new[i];
    l->taken[i]++;
    l->refused[i] += l->tries[i];
    l->tries[i] = 0;
}

/* One trial in all lanes that are running; whether they all go on. */
static int advance(flexel_lanes *l)
{
    flexel_trial trial;
    mask good = {0};
    int waiting = 0;
    propose(l, &trial);
    flexel_lanes_step(l, &trial);
    flexel_lanes_rates(l->work);
    flexel_lanes_amplification(l);
    for (size_t i = 0; i < FLEXEL_BLOCK; i++) {
        if (l->doing[i] == FLEXEL_RUNNING && conclude(l, &trial, i)) {
            if (touches(l, i) || dips(l, i)) {
                l->doing[i] = FLEXEL_STOPPED;
            } else if (l->to[i] >= l->until[i]) {
                l->doing[i] = FLEXEL_PASSED;
            } else {
                good[i] = -1;
                take(l, i);
            }
        }
        waiting |= l->doing[i] == FLEXEL_PASSED || l->doing[i] == FLEXEL_STOPPED;
    }
    flexel_lanes_accept(l, &good);
    return !waiting;
}

void flexel_lanes_run(flexel_lanes *l)
{
    mask good = {0};
    int running = 0;
    for (size_t i = 0; i < FLEXEL_BLOCK; i++) {
        if (l->doing[i] == FLEXEL_PASSED) {
            good[i] = -1;
            take(l, i);
        }
        running |= l->doing[i] == FLEXEL_RUNNING;
    }
    flexel_lanes_accept(l, &good);
    while (running && advance(l)) {
    }
}
