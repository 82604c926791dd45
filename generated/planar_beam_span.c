/* planar_beam_span: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * (x, y) = l0 ((vp + vq)/2 + l0 (exdot_p - exdot_q)/12), rate of the integral of position over the
 * beam's cubic Hermite interpolation; ex: directions of the element at p and q
 *
 * Source: textbook mechanics (consistent nodal forces)
 *
 * x (6): p_x, p_y, rp_angle, q_x, q_y, rq_angle
 * e (0): none
 * s (2): x [m^2/s], y [m^2/s]
 * p (3):
 *   l0 (1) [m]: undeformed length
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   alphaq0 (1) [rad]: initial direction of the element minus the angle of node q */
#include "kernels.h"

/* position: 18 operations.
 * in:  x (6), p (3)
 * out: e (0), De (0,6), V (2,6), 8 of 12 entries */
FLEXEL_CLONES
static void planar_beam_span_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict p = in[1] + b * (3 * 8);
        real *restrict V = out[2] + b * (8 * 8);
        real t0[8], sin_p[8], t1[8], t2[8], sin_q[8], cos_p[8], cos_q[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            V[0 * 8 + j] = V[2 * 8 + j] = V[4 * 8 + j] = V[6 * 8 + j] = 0.5 * l0; /* V(0,0) V(0,3) V(1,1) V(1,4) */
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            t1[j] = l0 * l0;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t2[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t0[j]);
            sin_q[j] = real_sin(t2[j]);
            cos_p[j] = real_cos(t0[j]);
            cos_q[j] = real_cos(t2[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            V[1 * 8 + j] = -(0.08333333333333333 * (sin_p[j] * t1[j])); /* V(0,2) */
            V[3 * 8 + j] = 0.08333333333333333 * (sin_q[j] * t1[j]); /* V(0,5) */
            V[5 * 8 + j] = 0.08333333333333333 * (cos_p[j] * t1[j]); /* V(1,2) */
            V[7 * 8 + j] = -(0.08333333333333333 * (cos_q[j] * t1[j])); /* V(1,5) */
        }
    }
}

/* acceleration: 19 operations.
 * in:  x (6), v (6), p (3)
 * out: g (0), gs (2) */
FLEXEL_CLONES
static void planar_beam_span_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (3 * 8);
        real *restrict gs = out[1] + b * (2 * 8);
        real t0[8], t1[8], cos_q[8], t2[8], t3[8], cos_p[8], t4[8], sin_q[8], sin_p[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real l0 = p[0 * 8 + j];
            t0[j] = l0 * l0;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t1[j] = rq_angle + alphaq0;
            const real rq_vangle = v[5 * 8 + j];
            t2[j] = rq_vangle * rq_vangle;
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t3[j] = rp_angle + alpha0;
            const real rp_vangle = v[2 * 8 + j];
            t4[j] = rp_vangle * rp_vangle;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_q[j] = real_cos(t1[j]);
            cos_p[j] = real_cos(t3[j]);
            sin_q[j] = real_sin(t1[j]);
            sin_p[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            gs[0 * 8 + j] = 0.08333333333333333 * (t0[j] * (cos_q[j] * t2[j] - cos_p[j] * t4[j]));
            gs[1 * 8 + j] = 0.08333333333333333 * (t0[j] * (sin_q[j] * t2[j] - sin_p[j] * t4[j]));
        }
    }
}

/* rates: 21 operations.
 * in:  x (6), v (6), p (3)
 * out: Phi_x (2,6), 4 of 12 entries */
FLEXEL_CLONES
static void planar_beam_span_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict p = in[2] + b * (3 * 8);
        real *restrict Phi_x = out[0] + b * (4 * 8);
        real t0[8], cos_p[8], t1[8], t2[8], cos_q[8], sin_p[8], sin_q[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            t1[j] = l0 * l0;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t2[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_p[j] = real_cos(t0[j]);
            cos_q[j] = real_cos(t2[j]);
            sin_p[j] = real_sin(t0[j]);
            sin_q[j] = real_sin(t2[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_vangle = v[2 * 8 + j];
            Phi_x[0 * 8 + j] = -(0.08333333333333333 * (rp_vangle * cos_p[j] * t1[j])); /* Phi_x(0,2) */
            const real rq_vangle = v[5 * 8 + j];
            Phi_x[1 * 8 + j] = 0.08333333333333333 * (rq_vangle * cos_q[j] * t1[j]); /* Phi_x(0,5) */
            Phi_x[2 * 8 + j] = -(0.08333333333333333 * (rp_vangle * sin_p[j] * t1[j])); /* Phi_x(1,2) */
            Phi_x[3 * 8 + j] = 0.08333333333333333 * (rq_vangle * sin_q[j] * t1[j]); /* Phi_x(1,5) */
        }
    }
}

/* kinematics: 44 operations.
 * in:  x (6), v (6), a (6), p (3)
 * out: Psi_x (2,6), 4 of 12 entries, Psi_v (2,6), 4 of 12 entries */
FLEXEL_CLONES
static void planar_beam_span_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict v = in[1] + b * (6 * 8);
        const real *restrict a = in[2] + b * (6 * 8);
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict Psi_x = out[0] + b * (4 * 8);
        real *restrict Psi_v = out[1] + b * (4 * 8);
        real t0[8], sin_p[8], t1[8], t2[8], cos_p[8], t3[8], t4[8], cos_q[8], t5[8], sin_q[8], t6[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            t1[j] = l0 * l0;
            const real rp_vangle = v[2 * 8 + j];
            t2[j] = rp_vangle * rp_vangle * t1[j];
            const real rp_aangle = a[2 * 8 + j];
            t3[j] = rp_aangle * t1[j];
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t4[j] = rq_angle + alphaq0;
            const real rq_aangle = a[5 * 8 + j];
            t5[j] = rq_aangle * t1[j];
            const real rq_vangle = v[5 * 8 + j];
            t6[j] = rq_vangle * rq_vangle * t1[j];
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t0[j]);
            cos_p[j] = real_cos(t0[j]);
            cos_q[j] = real_cos(t4[j]);
            sin_q[j] = real_sin(t4[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            Psi_x[0 * 8 + j] = 0.08333333333333333 * (sin_p[j] * t2[j] - cos_p[j] * t3[j]); /* Psi_x(0,2) */
            Psi_x[1 * 8 + j] = 0.08333333333333333 * (cos_q[j] * t5[j] - sin_q[j] * t6[j]); /* Psi_x(0,5) */
            const real t7 = 0.08333333333333333 * (sin_p[j] * t3[j] + cos_p[j] * t2[j]);
            Psi_x[2 * 8 + j] = -t7; /* Psi_x(1,2) */
            Psi_x[3 * 8 + j] = 0.08333333333333333 * (sin_q[j] * t5[j] + cos_q[j] * t6[j]); /* Psi_x(1,5) */
            const real rp_vangle = v[2 * 8 + j];
            Psi_v[0 * 8 + j] = -(0.16666666666666666 * (rp_vangle * cos_p[j] * t1[j])); /* Psi_v(0,2) */
            const real rq_vangle = v[5 * 8 + j];
            Psi_v[1 * 8 + j] = 0.16666666666666666 * (rq_vangle * cos_q[j] * t1[j]); /* Psi_v(0,5) */
            Psi_v[2 * 8 + j] = -(0.16666666666666666 * (rp_vangle * sin_p[j] * t1[j])); /* Psi_v(1,2) */
            Psi_v[3 * 8 + j] = 0.16666666666666666 * (rq_vangle * sin_q[j] * t1[j]); /* Psi_v(1,5) */
        }
    }
}

/* stiffness: 18 operations.
 * in:  x (6), sigma (0), tau (2), p (3)
 * out: K (6,6), 2 of 36 entries */
FLEXEL_CLONES
static void planar_beam_span_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (6 * 8);
        const real *restrict tau = in[2] + b * (2 * 8);
        const real *restrict p = in[3] + b * (3 * 8);
        real *restrict K = out[0] + b * (2 * 8);
        real t0[8], sin_p[8], t2[8], cos_p[8], t3[8], t5[8], sin_q[8], cos_q[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real rp_angle = x[2 * 8 + j];
            const real alpha0 = p[1 * 8 + j];
            t0[j] = rp_angle + alpha0;
            const real l0 = p[0 * 8 + j];
            const real t1 = l0 * l0;
            const real tau_y = tau[1 * 8 + j];
            t2[j] = tau_y * t1;
            const real tau_x = tau[0 * 8 + j];
            t3[j] = tau_x * t1;
            const real rq_angle = x[5 * 8 + j];
            const real alphaq0 = p[2 * 8 + j];
            t5[j] = rq_angle + alphaq0;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_p[j] = real_sin(t0[j]);
            cos_p[j] = real_cos(t0[j]);
            sin_q[j] = real_sin(t5[j]);
            cos_q[j] = real_cos(t5[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t4 = 0.08333333333333333 * (sin_p[j] * t2[j] + cos_p[j] * t3[j]);
            K[0 * 8 + j] = -t4; /* K(2,2) */
            K[1 * 8 + j] = 0.08333333333333333 * (sin_q[j] * t2[j] + cos_q[j] * t3[j]); /* K(5,5) */
        }
    }
}

const flexel_element flexel_planar_beam_span = {
    .name = "planar_beam_span",
    .digest = "4ba5773cef72f8f5",
    .n = 6,
    .m = 0,
    .k = 2,
    .np = 3,
    .position = planar_beam_span_position,
    .acceleration = planar_beam_span_acceleration,
    .rates = planar_beam_span_rates,
    .kinematics = planar_beam_span_kinematics,
    .stiffness = planar_beam_span_stiffness,
};
