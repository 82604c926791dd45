/* The contract between the kernels and whoever calls them. Written by `flexel derive`; do not edit.
 *
 * Knows nothing of Python. An element is a table of kernels; a kernel computes a set of output arrays from a set
 * of input arrays, for many elements of the same kind at once.
 *
 *   kernel(nblocks, in, out)
 *
 * Elements come in blocks of FLEXEL_BLOCK = 8. An array argument with r rows has the shape
 * [nblocks][r][8], C order, contiguous; no alignment is asked for. in[i] and out[i] point to the arrays
 * in the order of the table below. Inputs and outputs must not overlap. Of an output array only the structural
 * nonzeros are stored, as rows, in row-major order of the full array; their flat indices are in table.py, and
 * beside each entry of a matrix a comment has its row and column, counted from zero: De(5,3). An array without
 * rows is never touched and may be NULL. Incomplete blocks are filled up by the caller with any valid element (a
 * copy of the last one, say).
 *
 * x coordinates (n), v = dx/dt rates (n), a = dv/dt accelerations (n), p parameters (np), e deformations (m) with
 * rates De v, s slips (k), linear in v; sigma, tau generalized stresses dual to e and s (m, k). SI units, radians;
 * the unit of every coordinate, parameter and deformation is in the head comment of the element's file.
 *
 * Elements
 *
 *   kernel        in                out (full shapes)
 *   position      x p               e (m), De (m,n) = de/dx, V (k,n) = ds/dv
 *   acceleration  x v p             g (m) = D2e(v,v), gs (k) = (ds/dx) v
 *   inertia       x v p             M (n,n), h (n), f (n), U (1): kinetic energy v'M v/2,
 *                                   h = (dM/dt) v - d(v'M v)/dx/2, potential U of the body forces, f = -dU/dx
 *   rates         x v p             Phi_x (m+k,n) = dPhi/dx of Phi = [De v; s]
 *   kinematics    x v a p           Psi_x (m+k,n), Psi_v (m+k,n): derivatives by x and v of
 *                                   Psi = dPhi/dt = [D2e(v,v) + De a; (ds/dx) v + V a]
 *   stiffness     x sigma tau p     K (n,n) = d(De'sigma + V'tau)/dx at fixed sigma and tau
 *   tangent       x v a p           R_x (n,n), R_v (n,n): derivatives of M a + h - f
 *   outputs       x [e] sigma tau p what the element reports beside e, by name: section forces, places that a picture
 *                                   draws, ...; the arrays are in the head comment, with e if it is read
 *
 * An element without mass and potential has NULL for inertia and tangent; one without deformations and slips has
 * NULL for the others, and one that reports nothing has NULL for outputs. Angles are principal values.
 *
 * Laws
 *
 *   law           e ed s z t p      sigma (m), tau (k), zd (nz) rates of the internal states z (nz), U (1) stored
 *                                   energy, P (1) dissipated power sigma.ed + tau.s - dU/dt; t (1) is the time
 *   tangent       e ed s z t p      J (m+k+nz, 2m+k+nz) = d(sigma,tau,zd)/d(e,ed,s,z)
 *
 * Everything is written for a type `real`, double by default. Compiled with -Dreal="double complex" the same
 * kernels take complex arguments (for complex-step differentiation); functions that are not analytic (atan2, abs,
 * min, max, comparisons) are then continued analytically from the real axis. */
#ifndef FLEXEL_KERNELS_H
#define FLEXEL_KERNELS_H

#include <math.h>
#include <stddef.h>

#ifndef real
#define real double
#define real_sqrt sqrt
#define real_sin sin
#define real_cos cos
#define real_tan tan
#define real_asin asin
#define real_acos acos
#define real_atan atan
#define real_atan2 atan2
#define real_exp exp
#define real_log log
#define real_pow pow
#define real_sinh sinh
#define real_cosh cosh
#define real_tanh tanh
#define real_abs fabs
#define real_part(z) (z)
#else
#include <complex.h>
#define FLEXEL_COMPLEX
#define real_sqrt csqrt
#define real_sin csin
#define real_cos ccos
#define real_tan ctan
#define real_asin casin
#define real_acos cacos
#define real_atan catan
#define real_exp cexp
#define real_log clog
#define real_pow cpow
#define real_sinh csinh
#define real_cosh ccosh
#define real_tanh ctanh
#define real_part(z) creal(z)
static inline real real_abs(real z)
{
    return creal(z) < 0.0 ? -z : z;
}
/* The angle of the real parts, and what the imaginary parts turn it by. */
static inline real real_atan2(real y, real x)
{
    const double angle = atan2(creal(y), creal(x)), c = cos(angle), s = sin(angle);
    return angle + catan((c * y - s * x) / (c * x + s * y));
}
#endif

#define real_lt(a, b) (real_part(a) < real_part(b))
#define real_le(a, b) (real_part(a) <= real_part(b))
#define real_eq(a, b) (real_part(a) == real_part(b))
static inline real real_min(real a, real b)
{
    return real_le(a, b) ? a : b;
}
static inline real real_max(real a, real b)
{
    return real_le(b, a) ? a : b;
}

/* One body for every vector width, chosen when the program is loaded; define FLEXEL_NO_CLONES to do without. */
#if !defined(FLEXEL_CLONES)
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(FLEXEL_COMPLEX) && !defined(FLEXEL_NO_CLONES)
#define FLEXEL_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FLEXEL_CLONES
#endif
#endif

#define FLEXEL_BLOCK 8

/* cdef: begin */
typedef void (*flexel_kernel)(size_t nblocks, const real *const *in, real *const *out);

/* n coordinates, m deformations, k slips, np parameters. The digest is that of the file it was compiled from;
 * table.py has the same, so that a table and an extension of different derivations are distinguished. */
typedef struct {
    const char *name, *digest;
    int n, m, k, np;
    flexel_kernel position, acceleration, inertia, rates, kinematics, stiffness, tangent, outputs;
} flexel_element;

typedef struct {
    const char *name, *digest;
    int m, k, nz, np;
    flexel_kernel law, tangent;
} flexel_law;
/* cdef: end */

#endif
