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
 *
 * An element without mass and potential has NULL for inertia and tangent; one without deformations and slips has
 * NULL for the others. Angles are principal values.
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
    flexel_kernel position, acceleration, inertia, rates, kinematics, stiffness, tangent;
} flexel_element;

typedef struct {
    const char *name, *digest;
    int m, k, nz, np;
    flexel_kernel law, tangent;
} flexel_law;

extern const flexel_element flexel_point_mass;
extern const flexel_element flexel_body;
extern const flexel_element flexel_rotary_inertia;
extern const flexel_element flexel_norm;
extern const flexel_element flexel_truss;
extern const flexel_element flexel_hinge;
extern const flexel_element flexel_bearing;
extern const flexel_element flexel_beam3;
extern const flexel_element flexel_beam;
extern const flexel_element flexel_beam_first_order;
extern const flexel_element flexel_beam_warping;
extern const flexel_element flexel_beam_logarithmic;
extern const flexel_element flexel_wheel;
extern const flexel_element flexel_surface;
extern const flexel_element flexel_toroidal_wheel;
extern const flexel_element flexel_tyre;
extern const flexel_element flexel_tyre_on_road;
extern const flexel_element flexel_axle_slip;
extern const flexel_element flexel_rotation;
extern const flexel_element flexel_body_rotation;
extern const flexel_element flexel_body_velocity;
extern const flexel_element flexel_bar_span;
extern const flexel_element flexel_beam_span;
extern const flexel_element flexel_skate;
extern const flexel_element flexel_roller_cam;
extern const flexel_element flexel_flat_cam;
extern const flexel_element flexel_planar_point_mass;
extern const flexel_element flexel_planar_body;
extern const flexel_element flexel_planar_rotary_inertia;
extern const flexel_element flexel_planar_truss;
extern const flexel_element flexel_planar_hinge;
extern const flexel_element flexel_planar_beam;
extern const flexel_element flexel_planar_beam_first_order;
extern const flexel_element flexel_planar_beam_logarithmic;
extern const flexel_element flexel_planar_beam3;
extern const flexel_element flexel_planar_bearing;
extern const flexel_element flexel_planar_belt;
extern const flexel_element flexel_planar_gear;
extern const flexel_element flexel_planar_wheel;
extern const flexel_element flexel_planar_skate;
extern const flexel_element flexel_planar_roller_cam;
extern const flexel_element flexel_planar_flat_cam;
extern const flexel_element flexel_planar_body_velocity;
extern const flexel_element flexel_planar_bar_span;
extern const flexel_element flexel_planar_beam_span;
extern const flexel_element flexel_cable;
extern const flexel_element flexel_slope_clamp;
extern const flexel_element flexel_cable_span;
extern const flexel_element flexel_cable_cylinder;
extern const flexel_element flexel_cable_plane;
extern const flexel_element flexel_cable_v_groove;
extern const flexel_element flexel_cable_round_groove;
extern const flexel_element flexel_cable_helical_groove;
extern const flexel_element flexel_point_cylinder;
extern const flexel_element flexel_point_plane;
extern const flexel_element flexel_point_v_groove;
extern const flexel_element flexel_point_round_groove;
extern const flexel_element flexel_sphere_cylinder;
extern const flexel_element flexel_sphere_plane;
extern const flexel_element flexel_sphere_v_groove;
extern const flexel_element flexel_sphere_round_groove;
extern const flexel_element flexel_planar_cable;
extern const flexel_element flexel_planar_slope_clamp;
extern const flexel_element flexel_planar_cable_span;
extern const flexel_element flexel_planar_cable_circle;
extern const flexel_element flexel_planar_cable_line;
extern const flexel_element flexel_planar_point_circle;
extern const flexel_element flexel_planar_point_line;
extern const flexel_element flexel_planar_disc_circle;
extern const flexel_element flexel_planar_disc_line;

extern const flexel_law flexel_law_linear_1;
extern const flexel_law flexel_law_linear_2;
extern const flexel_law flexel_law_linear_3;
extern const flexel_law flexel_law_linear_4;
extern const flexel_law flexel_law_linear_5;
extern const flexel_law flexel_law_linear_6;
extern const flexel_law flexel_law_diagonal_6;
extern const flexel_law flexel_law_diagonal_12;
extern const flexel_law flexel_law_viscous_1;
extern const flexel_law flexel_law_viscous_2;
extern const flexel_law flexel_law_viscous_3;
extern const flexel_law flexel_law_spring_curve;
extern const flexel_law flexel_law_damper_curve;
extern const flexel_law flexel_law_stop;
extern const flexel_law flexel_law_vertical_tyre;
extern const flexel_law flexel_law_linear_tyre;
extern const flexel_law flexel_law_calspan_tyre;
extern const flexel_law flexel_law_magic_formula;
extern const flexel_law flexel_law_hertz;
extern const flexel_law flexel_law_hertz_coulomb_1;
extern const flexel_law flexel_law_hertz_coulomb_2;
extern const flexel_law flexel_law_hertz_bristle_1;
extern const flexel_law flexel_law_hertz_bristle_2;
extern const flexel_law flexel_law_journal;
extern const flexel_law flexel_law_friction;
extern const flexel_law flexel_law_slip_friction;
extern const flexel_law flexel_law_limits;
extern const flexel_law flexel_law_loose_journal;
extern const flexel_law flexel_law_loose_ball;
extern const flexel_law flexel_law_held;
extern const flexel_law flexel_law_slip_held;
extern const flexel_law flexel_law_memory;
/* cdef: end */

#endif
