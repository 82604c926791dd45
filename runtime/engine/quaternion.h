/* Vectors of three numbers, and Euler parameters of rotations. */
#ifndef FLEXEL_QUATERNION_H
#define FLEXEL_QUATERNION_H

#include <math.h>
#include <stddef.h>

static inline double flexel_product(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void flexel_cross(const double *a, const double *b, double *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double flexel_length(const double *a)
{
    return sqrt(flexel_product(a, a));
}

/* L = L0 o Euler parameters of the rotation vector p, of length one. */
static inline void flexel_turn(const double *L0, const double *p, double *L)
{
    const double angle = flexel_length(p), share = angle > 0 ? sin(angle / 2) / angle : 0.5, c = cos(angle / 2);
    const double d[3] = {share * p[0], share * p[1], share * p[2]};
    double across[3];
    flexel_cross(L0 + 1, d, across);
    L[0] = L0[0] * c - flexel_product(L0 + 1, d);
    for (size_t k = 0; k < 3; k++)
        L[k + 1] = L0[0] * d[k] + c * L0[k + 1] + across[k];
    const double size = sqrt(L[0] * L[0] + flexel_product(L + 1, L + 1));
    for (size_t k = 0; k < 4; k++)
        L[k] /= size;
}

/* a along the axes of space, for a along those of a frame with Euler parameters L of length one. */
static inline void flexel_to_space(const double *L, const double *a, double *b)
{
    double once[3], twice[3];
    flexel_cross(L + 1, a, once);
    flexel_cross(L + 1, once, twice);
    for (size_t k = 0; k < 3; k++)
        b[k] = a[k] + 2 * (L[0] * once[k] + twice[k]);
}

/* The reverse. */
static inline void flexel_to_frame(const double *L, const double *a, double *b)
{
    const double back[4] = {L[0], -L[1], -L[2], -L[3]};
    flexel_to_space(back, a, b);
}

/* The rotation vector from L0 to L, of half a turn at most. */
static inline void flexel_turn_between(const double *L0, const double *L, double *p)
{
    double across[3], d[3];
    const double c = L0[0] * L[0] + flexel_product(L0 + 1, L + 1), sign = c < 0 ? -1 : 1;
    flexel_cross(L0 + 1, L + 1, across);
    for (size_t k = 0; k < 3; k++)
        d[k] = sign * (L0[0] * L[k + 1] - L[0] * L0[k + 1] - across[k]);
    const double size = flexel_length(d), share = size > 0 ? 2 * atan2(size, fabs(c)) / size : 2;
    for (size_t k = 0; k < 3; k++)
        p[k] = share * d[k];
}

#endif
