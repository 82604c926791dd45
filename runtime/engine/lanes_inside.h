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

/* The potential of body forces, after the forces. */
void flexel_lanes_potential(const flexel_work *s, const double *U0, double *U);

/* Of account.h: powers at a stage, after its accelerations, and the energies at the end of a step. */
void flexel_lanes_account_stage(const flexel_lanes *l, size_t stage);
void flexel_lanes_account_end(const flexel_lanes *l);

/* Of elimination.h; the lanes where a pivot is not sound are added to a mask. */
void flexel_lanes_factor(const flexel_matrix *A, const double *buffer, mask *unsound);
void flexel_lanes_solve(const flexel_matrix *A, size_t count, const double *b, double *x, double *work);
/* The lanes where the determinant is negative. */
void flexel_lanes_sign(const flexel_matrix *A, mask *negative);
/* The logarithm of the size of the determinant of one lane, to base two. */
double flexel_lanes_logarithm(const flexel_matrix *A, size_t lane);

/* Of explicit.h: the rates at the times and y of all lanes; those that fail are added to a mask. */
void flexel_lanes_locate(const flexel_lanes *l, mask *failed);
void flexel_lanes_velocity(const flexel_lanes *l, mask *failed);
void flexel_lanes_accelerate(const flexel_lanes *l, mask *failed);
void flexel_lanes_amplification(const flexel_lanes *l);

/* Of runge_kutta.h: a step of the lanes, with lengths h from the times t (zero in idle ones). What it found: errors of y, x,
 * v and turns, distances from the prediction, the largest rate, where the sign of the determinant changes, and what failed. */
typedef struct {
    vec t, h, error, error_x, error_v, error_turns, error_own, defect, defect_v, fastest;
    mask changed, failed;
} flexel_trial;
void flexel_lanes_step(const flexel_lanes *l, flexel_trial *trial);
/* The end of the step becomes the start of the next in some lanes. */
void flexel_lanes_accept(const flexel_lanes *l, const mask *where);

/* Of covered.h: the end of the step is taken into the motions, and accepted in some lanes; the error of a position below which J
 * is kept. */
void flexel_lanes_look(const flexel_lanes *l);
void flexel_lanes_cover(const flexel_lanes *l, const mask *where);
void flexel_lanes_accepted_error(const flexel_lanes *l);

/* z += (or, for `minus`, -=) the sum of a[l] times row at[l] of x, l < n, for `width` of `count` columns. The sums stay in
 * registers; the width is known to the compiler and is at most four. */
FLEXEL_INLINE void flexel_lanes_sums_by(vec *z, const vec *a, const int *at, int n, const vec *x, size_t count, int width,
                                        int minus)
{
    vec sum[4] = {z[0], z[width > 1 ? 1 : 0], z[width > 2 ? 2 : 0], z[width > 3 ? 3 : 0]};
    for (int l = 0; l < n; l++) {
        const vec *row = x + (size_t)at[l] * count, factor = minus ? -a[l] : a[l];
        sum[0] += factor * row[0];
        if (width > 1)
            sum[1] += factor * row[1];
        if (width > 2)
            sum[2] += factor * row[2];
        if (width > 3)
            sum[3] += factor * row[3];
    }
    z[0] = sum[0];
    if (width > 1)
        z[1] = sum[1];
    if (width > 2)
        z[2] = sum[2];
    if (width > 3)
        z[3] = sum[3];
}

/* The same for all columns. */
FLEXEL_INLINE void flexel_lanes_sums(vec *z, const vec *a, const int *at, int n, const vec *x, size_t count)
{
    size_t c = 0;
    for (; c + 4 <= count; c += 4)
        flexel_lanes_sums_by(z + c, a, at, n, x + c, count, 4, 0);
    for (; c < count; c++)
        flexel_lanes_sums_by(z + c, a, at, n, x + c, count, 1, 0);
}

/* A row of J times columns over the free coordinates. */
FLEXEL_INLINE void flexel_lanes_row(const flexel_work *s, int row, const vec *in, size_t count, vec *out)
{
    const int first = s->J_start[row];
    int end = first;
    while (end < s->J_start[row + 1] && (size_t)s->J_column[end] < s->nf)
        end++;
    for (size_t j = 0; j < count; j++)
        out[j] = flexel_all(0);
    flexel_lanes_sums(out, V(s->J) + first, s->J_column + first, end - first, in, count);
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
