/* What the files of the lanes have in common; see lanes.h. */
#ifndef FLEXEL_LANES_INSIDE_H
#define FLEXEL_LANES_INSIDE_H

#include "lanes.h"
#include "vector.h"

typedef flexel_vector vec;
typedef flexel_mask mask;
#define V(array) ((vec *)(array))

/* Of evaluate.h, for all lanes; coordinates are gathered by `flexel_lanes_take`. */
void flexel_lanes_position(flexel_work *s);
void flexel_lanes_rates(flexel_work *s);
void flexel_lanes_convective(flexel_work *s);
/* Forces on the coordinates, as flexel_forces. */
void flexel_lanes_forces(flexel_work *s, flexel_choice *c);

/* Of elimination.h; the lanes where a pivot is not sound are added to a mask. */
void flexel_lanes_factor(const flexel_matrix *A, const double *buffer, mask *unsound);
void flexel_lanes_solve(const flexel_matrix *A, size_t count, const double *b, double *x, double *work);
/* The lanes where the determinant is negative. */
void flexel_lanes_sign(const flexel_matrix *A, mask *negative);

/* Of explicit.h: the rates at the times and y of all lanes; those that fail are added to a mask. */
void flexel_lanes_locate(const flexel_lanes *l, mask *failed);
void flexel_lanes_velocity(const flexel_lanes *l, mask *failed);
void flexel_lanes_accelerate(const flexel_lanes *l, mask *failed);
void flexel_lanes_reach(const flexel_lanes *l);

/* Of runge_kutta.h: a step of the lanes, with lengths h from the times t (zero in idle ones). What it found: errors of y, x,
 * v and turns, distances from the shadow, the largest rate, where the sign of the determinant changes, and what failed. */
typedef struct {
    vec t, h, error, error_x, error_v, error_turns, defect, defect_v, fastest;
    mask changed, failed;
} flexel_trial;
void flexel_lanes_step(const flexel_lanes *l, flexel_trial *trial);
/* The end of the step becomes the start of the next in some lanes. */
void flexel_lanes_accept(const flexel_lanes *l, const mask *where);

/* A row of J times columns over the free coordinates. */
FLEXEL_INLINE void flexel_lanes_row(const flexel_work *s, int row, const vec *in, size_t count, vec *out)
{
    for (size_t j = 0; j < count; j++)
        out[j] = flexel_all(0);
    for (int l = s->J_start[row]; l < s->J_start[row + 1] && (size_t)s->J_column[l] < s->nf; l++)
        for (size_t j = 0; j < count; j++)
            out[j] += V(s->J)[l] * in[(size_t)s->J_column[l] * count + j];
}

/* A row of J times a vector over all coordinates. */
FLEXEL_INLINE vec flexel_lanes_row_value(const flexel_work *s, int row, const double *in)
{
    vec z = flexel_all(0);
    for (int l = s->J_start[row]; l < s->J_start[row + 1]; l++)
        z += V(s->J)[l] * V(in)[s->J_column[l]];
    return z;
}

#endif
