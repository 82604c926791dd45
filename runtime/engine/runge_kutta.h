/* One step of the Runge-Kutta method of Dormand and Prince of order 8 (DOP853) in minimal coordinates.
 *
 * The coordinates x, and deformations with a period, are predicted by integration, x' = v: they are where the position
 * of each stage is sought. The error of the prediction, and how far the solved coordinates are from it, tell whether the step
 * can be trusted to stay on its branch. Source: Hairer, Norsett and Wanner (1993); coefficients are those of SciPy. */
#ifndef FLEXEL_RUNGE_KUTTA_H
#define FLEXEL_RUNGE_KUTTA_H

#include "account.h"
#include "covered.h"
#include "explicit.h"
#include "rotations.h"

/* cdef: begin */
enum { FLEXEL_STAGES = 12, FLEXEL_INSIDE = 23 }; /* stages of a step, and with those for the states within it */

typedef struct {
    size_t ny;
    const double *A, *B, *C, *E3, *E5; /* A (12, 12), B (12), C (12), E3 and E5 (13) */
    double rtol;
    const double *atol;   /* (ny) */
    flexel_covered *covered; /* what the tolerances are relative to */
    double *scale;        /* allowed errors (ny) */
    const double *weight; /* one over natural scales of the free coordinates (nf) */
    const double *apart;  /* the same, but zero for the Euler parameters of frames that turn freely (nf) */
    size_t ngiven;
    const double *given;  /* prescribed motions and loads at the stages and the end (13, ngiven), or at all stages */
    /* at the start and the end of the step: y, coordinates, periodic deformations */
    double *y, *x, *e, *y_new, *x_new, *e_new;
    /* rates at the stages: of y (13, ny), of x (13, nf) and x'' (13, nf), of periodic deformations (13, nperiodic); the first
     * rows belong to the start. For the states within a step there are FLEXEL_INSIDE rows. */
    double *K, *V, *W, *turning;
    double *space; /* max(2 ny, nf) */
    flexel_rotations rotations;
    int sign;      /* of the determinant of the position matrix at the start */
    double *determinant; /* logarithms of its size at the stages and the end (13), or NULL if they are not asked for */
    /* found: errors of y (SciPy's norm), of x and v (natural scales), of turns (periods), the largest of a coordinate over what
     * its own range allows; largest distance of the solved coordinates and rates from the predicted ones, and which coordinate; largest rate; the stages with the other
     * sign, as bits; the stage that failed */
    double error, error_x, error_v, error_turns, error_own, defect, defect_v, fastest;
    size_t farthest, changed, stage, evaluations;
    flexel_account *account; /* the energy balance, or NULL */
    double h;                /* of the last step */
} flexel_dop853;

/* A step of length h from time t; FLEXEL_DONE, or the code of a stage that failed. */
int flexel_dop853_step(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h);
/* The end of the last step becomes the start of the next. */
void flexel_dop853_accept(flexel_work *s, flexel_dop853 *o);
/* Rates at the start, with the position sought from x and e; the first rows of K, V, W and turning. */
int flexel_dop853_begin(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t);
/* The stages and the end of a step alone, without its errors. */
int flexel_dop853_again(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h);
/* Take the start and the stages of a step from another, of the same degrees of freedom. */
void flexel_dop853_take(const flexel_work *s, flexel_dop853 *o, const flexel_dop853 *from);
/* More stages, from `first` up to `end`: at parts of the step, where y = y + h sum of row[j] K[j]; rows (end - first,
 * FLEXEL_INSIDE) and parts (end - first). */
int flexel_dop853_more(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h, size_t first, size_t end,
                       const double *rows, const double *parts);
/* Position and velocities at a time t, where y = y + h sum of row[j] K[j], j < count; y is then in `space`. What is given at
 * that time is in the first row of `given`. */
int flexel_dop853_locate(flexel_work *s, flexel_choice *c, flexel_dop853 *o, double t, double h, const double *row,
                         size_t count);
/* The largest defect of an interpolation with the rates sum of row[j] K[j] at a stage, over what is allowed of y, of angular
 * velocities and of the Euler parameters that are not in y (ny + 4 count). */
double flexel_dop853_defect(const flexel_work *s, const flexel_dop853 *o, double h, const double *row, size_t stage,
                            const double *allowed);
/* How much coordinates change per unit of the degrees of freedom, in natural scales; after velocities. */
double flexel_amplification(const flexel_work *s, flexel_choice *c);
/* The same for what is held: how much coordinates change per unit of rigid and prescribed quantities; an estimate. */
double flexel_sensitivity(const flexel_work *s, flexel_choice *c);
/* cdef: end */

/* The state at a stage: y = y + h sum of share[j] K[j], j < count; coordinates and deformations, by the same sums of their
 * rates, go into the workspace, from where the position is sought. */
void flexel_dop853_place(flexel_work *s, const flexel_choice *c, flexel_dop853 *o, double h, size_t count,
                         const double *share, double *y);
/* The rates there, rows `stage` of K, V, W and turning; FLEXEL_DONE, or the code of what failed. */
int flexel_dop853_rates(flexel_work *s, flexel_choice *c, flexel_dop853 *o, size_t stage, double t, const double *y);

#endif
