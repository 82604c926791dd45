/* planar_cable_circle: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,
 * h = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes
 * ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * a = x - xc - offset_x ex - offset_y ey
 * gap = |a| - radius - rope_radius,  tangential = (ax wy - ay wx)/|a|, counterclockwise
 * place: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows
 *
 * Source: planar counterpart of contact in space
 *
 * x (11): p_x, p_y, dp_x, dp_y, q_x, q_y, dq_x, dq_y, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (7):
 *   l0 (1) [m]: undeformed length
 *   xi (1) [1]: place along the element, from 0 at p to 1 at q
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   radius (1) [m]: radius at which the rope's or sphere's surface touches, about the axle ex
 *   rope_radius (1) [m]: outer radius of the rope */
#include "kernels.h"

/* position: 115 operations.
 * in:  x (11), p (7)
 * out: e (1), De (1,11), V (1,11) */
FLEXEL_CLONES
static void planar_cable_circle_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict p = in[1] + b * (7 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (11 * 8);
        real *restrict V = out[2] + b * (11 * 8);
        real t0[8], sin_r[8], turn_x[8], turn_y[8], longer[8], n1[8], t6[8], handles_x[8], n0[8], n2[8], d_x[8],
            cos_r[8], handles_y[8], d_y[8], t15[8], t16[8], t21[8], t22[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            turn_x[j] = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            turn_y[j] = dq_y - dp_y;
            const real square_turn = turn_x[j] * turn_x[j] + turn_y[j] * turn_y[j];
            const real t2 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            longer[j] = 1.0 + square_turn * t2;
            const real xi = p[1 * 8 + j];
            const real t3 = 1.0 - xi;
            const real t4 = t3 * t3;
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * t4 * xi;
            const real t5 = xi * xi;
            t6[j] = l0 * t3 * t5;
            handles_x[j] = dp_x * n1[j] - dq_x * t6[j];
            const real t7 = 2.0 * xi;
            n0[j] = t4 * (1.0 + t7);
            const real p_x = x[0 * 8 + j];
            n2[j] = t5 * (3.0 - t7);
            const real q_x = x[4 * 8 + j];
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0[j] + q_x * n2[j] + longer[j] * handles_x[j] - c_x;
            handles_y[j] = dp_y * n1[j] - dq_y * t6[j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0[j] + q_y * n2[j] + longer[j] * handles_y[j] - c_y;
            t15[j] = n1[j] * longer[j];
            t16[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            t21[j] = t6[j] * longer[j];
            t22[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real t1 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t8 = offset_x * cos_r[j];
            const real arm_x = t1 + d_x[j] - t8;
            const real t9 = offset_y * cos_r[j];
            const real t10 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t9 - t10;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real radius = p[5 * 8 + j];
            const real rope_radius = p[6 * 8 + j];
            e[0 * 8 + j] = distance - radius - rope_radius;
            const real t11 = 1.0 / distance;
            const real t12 = arm_x * t11;
            De[0 * 8 + j] = V[1 * 8 + j] = n0[j] * t12; /* De(0,0) V(0,1) */
            const real t13 = arm_y * t11;
            V[8 * 8 + j] = t13; /* V(0,8) */
            const real t14 = n0[j] * t13;
            De[1 * 8 + j] = t14; /* De(0,1) */
            const real t17 = t16[j] * (handles_x[j] * t12 + handles_y[j] * t13);
            const real t18 = 2.0 * turn_x[j] * t17;
            De[2 * 8 + j] = t15[j] * t12 - t18; /* De(0,2) */
            const real t19 = 2.0 * turn_y[j] * t17;
            De[3 * 8 + j] = t15[j] * t13 - t19; /* De(0,3) */
            De[4 * 8 + j] = V[5 * 8 + j] = n2[j] * t12; /* De(0,4) V(0,5) */
            const real t20 = n2[j] * t13;
            De[5 * 8 + j] = t20; /* De(0,5) */
            De[6 * 8 + j] = t18 - t21[j] * t12; /* De(0,6) */
            De[7 * 8 + j] = t19 - t21[j] * t13; /* De(0,7) */
            De[8 * 8 + j] = V[9 * 8 + j] = -t12; /* De(0,8) V(0,9) */
            De[9 * 8 + j] = -t13; /* De(0,9) */
            De[10 * 8 + j] = (t9 + t10) * t12 + (t1 - t8) * t13; /* De(0,10) */
            V[0 * 8 + j] = -t14; /* V(0,0) */
            const real t23 = t22[j] * (handles_y[j] * t12 - handles_x[j] * t13);
            const real t24 = turn_x[j] * t23;
            const real t25 = longer[j] * t13;
            V[2 * 8 + j] = -(t24 + n1[j] * t25); /* V(0,2) */
            const real t26 = longer[j] * t12;
            const real t27 = turn_y[j] * t23;
            V[3 * 8 + j] = n1[j] * t26 - t27; /* V(0,3) */
            V[4 * 8 + j] = -t20; /* V(0,4) */
            V[6 * 8 + j] = t24 + t6[j] * t25; /* V(0,6) */
            V[7 * 8 + j] = t27 - t6[j] * t26; /* V(0,7) */
            V[10 * 8 + j] = -(d_x[j] * t12 + d_y[j] * t13); /* V(0,10) */
        }
    }
}

/* acceleration: 186 operations.
 * in:  x (11), v (11), p (7)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_cable_circle_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real t0[8], sin_r[8], d_x[8], cos_r[8], d_y[8], t15[8], t24[8], t28[8], t32[8], t35[8], t36[8], t42[8],
            sliding_y[8], t43[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real xi = p[1 * 8 + j];
            const real t1 = xi * xi;
            const real t2 = 2.0 * xi;
            const real n2 = t1 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real t3 = 1.0 - xi;
            const real t4 = t3 * t3;
            const real n0 = t4 * (1.0 + t2);
            const real p_x = x[0 * 8 + j];
            const real l0 = p[0 * 8 + j];
            const real n1 = l0 * xi * t4;
            const real dp_x = x[2 * 8 + j];
            const real t5 = l0 * t1 * t3;
            const real dq_x = x[6 * 8 + j];
            const real handles_x = dp_x * n1 - dq_x * t5;
            const real turn_x = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real turn_y = dq_y - dp_y;
            const real square_turn = turn_x * turn_x + turn_y * turn_y;
            const real t6 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            const real longer = 1.0 + square_turn * t6;
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0 + handles_x * longer + q_x * n2 - c_x;
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real handles_y = dp_y * n1 - dq_y * t5;
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0 + handles_y * longer + q_y * n2 - c_y;
            const real dp_vy = v[3 * 8 + j];
            const real dq_vy = v[7 * 8 + j];
            const real t8 = dp_vy * n1 - dq_vy * t5;
            const real dq_vx = v[6 * 8 + j];
            const real dp_vx = v[2 * 8 + j];
            const real t9 = dq_vx - dp_vx;
            const real t10 = dq_vy - dp_vy;
            const real t11 = turn_x * t9 + turn_y * t10;
            const real t12 = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            const real t13 = t11 * t12;
            const real t14 = t8 * t13;
            t15[j] = 4.0 * t14;
            const real t20 = t9 * t9 + t10 * t10;
            const real t21 = t11 * t11;
            const real t22 = 0.0045138888888888885 * (4.0 * t21 + 2.0 * square_turn * t20);
            const real t23 = 0.041666666666666664 * t20 + t22;
            t24[j] = handles_y * t23;
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real t26 = p_vy * n0 + q_vy * n2;
            const real t27 = t8 * longer;
            const real c_vy = v[9 * 8 + j];
            t28[j] = t27 + 2.0 * handles_y * t13 + t26 - c_vy;
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t30 = dp_vx * n1 - dq_vx * t5;
            const real t31 = p_vx * n0 + t30 * longer + q_vx * n2;
            const real c_vx = v[8 * 8 + j];
            t32[j] = t31 + 2.0 * handles_x * t13 - c_vx;
            const real t34 = t30 * t13;
            t35[j] = 4.0 * t34;
            t36[j] = handles_x * t23;
            const real t40 = 0.041666666666666664 + 0.009027777777777777 * square_turn;
            const real rate = t40 * t11;
            const real t41 = t40 * t20 + 0.018055555555555554 * t21;
            const real r_vangle = v[10 * 8 + j];
            t42[j] = handles_y * t41 + 2.0 * t14 + rate * t8 - r_vangle * t32[j];
            sliding_y[j] = handles_y * rate + t27 + t26 - c_vy - r_vangle * d_x[j];
            t43[j] = rate * t30 + handles_x * t41 + 2.0 * t34 + r_vangle * t28[j];
            sliding_x[j] = handles_x * rate + r_vangle * d_y[j] + t31 - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = offset_y * sin_r[j] + d_x[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t7 = 1.0 / distance;
            const real r_vangle = v[10 * 8 + j];
            const real t16 = r_vangle * sin_r[j];
            const real t17 = r_vangle * t16;
            const real t18 = r_vangle * cos_r[j];
            const real t19 = r_vangle * t18;
            const real t25 = arm_y * (offset_y * t19 + t24[j] + offset_x * t17 + t15[j]);
            const real t29 = offset_y * t16 + t28[j] - offset_x * t18;
            const real t33 = offset_x * t16 + offset_y * t18 + t32[j];
            const real t37 = arm_x * (offset_x * t19 + t36[j] + t35[j] - offset_y * t17);
            const real t38 = arm_x * t33 + arm_y * t29;
            const real t39 = t7 * t7 * t7 * t38;
            g[0 * 8 + j] = t7 * (t33 * t33 + t37 + t29 * t29 + t25) - t38 * t39;
            const real t44 = arm_x * t42[j] + sliding_y[j] * t33 - arm_y * t43[j] - sliding_x[j] * t29;
            gs[0 * 8 + j] = t7 * t44 - (arm_x * sliding_y[j] - arm_y * sliding_x[j]) * t39;
        }
    }
}

/* rates: 258 operations.
 * in:  x (11), v (11), p (7)
 * out: Phi_x (2,11) */
FLEXEL_CLONES
static void planar_cable_circle_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (7 * 8);
        real *restrict Phi_x = out[0] + b * (22 * 8);
        real n0[8], t3[8], sin_r[8], n2[8], n1[8], t5[8], handles_x[8], turn_x[8], turn_y[8], longer[8], d_x[8],
            cos_r[8], handles_y[8], d_y[8], t9[8], t10[8], t11[8], t12[8], t14[8], t15[8], t16[8], t17[8], t18[8],
            t19[8], t23[8], t24[8], t25[8], t26[8], t43[8], rate[8], sliding_y[8], sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t3[j] = r_angle + alpha0;
            const real t4 = xi * xi;
            n2[j] = t4 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * xi * t1;
            const real dp_x = x[2 * 8 + j];
            t5[j] = l0 * t4 * t0;
            const real dq_x = x[6 * 8 + j];
            handles_x[j] = dp_x * n1[j] - dq_x * t5[j];
            turn_x[j] = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            turn_y[j] = dq_y - dp_y;
            const real square_turn = turn_x[j] * turn_x[j] + turn_y[j] * turn_y[j];
            const real t6 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            longer[j] = 1.0 + square_turn * t6;
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0[j] + handles_x[j] * longer[j] + q_x * n2[j] - c_x;
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            handles_y[j] = dp_y * n1[j] - dq_y * t5[j];
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0[j] + handles_y[j] * longer[j] + q_y * n2[j] - c_y;
            const real q_vx = v[4 * 8 + j];
            t9[j] = q_vx * n2[j];
            const real p_vx = v[0 * 8 + j];
            t10[j] = p_vx * n0[j];
            const real dp_vx = v[2 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            t11[j] = dp_vx * n1[j] - dq_vx * t5[j];
            t12[j] = t11[j] * longer[j];
            t14[j] = dq_vx - dp_vx;
            const real dq_vy = v[7 * 8 + j];
            const real dp_vy = v[3 * 8 + j];
            t15[j] = dq_vy - dp_vy;
            t16[j] = turn_x[j] * t14[j] + turn_y[j] * t15[j];
            t17[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            t18[j] = t16[j] * t17[j];
            t19[j] = 2.0 * handles_x[j] * t18[j];
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            t23[j] = p_vy * n0[j] + q_vy * n2[j];
            t24[j] = dp_vy * n1[j] - dq_vy * t5[j];
            t25[j] = t24[j] * longer[j];
            t26[j] = 2.0 * handles_y[j] * t18[j];
            t43[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn;
            rate[j] = t43[j] * t16[j];
            const real c_vy = v[9 * 8 + j];
            const real r_vangle = v[10 * 8 + j];
            sliding_y[j] = handles_y[j] * rate[j] + t25[j] + t23[j] - c_vy - r_vangle * d_x[j];
            const real t44 = handles_x[j] * rate[j] + r_vangle * d_y[j] + t12[j] + t10[j];
            const real c_vx = v[8 * 8 + j];
            sliding_x[j] = t9[j] + t44 - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t3[j]);
            cos_r[j] = real_cos(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = offset_y * sin_r[j] + d_x[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t7 = 1.0 / distance;
            const real r_vangle = v[10 * 8 + j];
            const real t8 = r_vangle * sin_r[j];
            const real t13 = r_vangle * cos_r[j];
            const real t20 = offset_y * t13 + t19[j] + t12[j] + t10[j] + t9[j] + offset_x * t8;
            const real c_vx = v[8 * 8 + j];
            const real t21 = t20 - c_vx;
            const real t22 = t7 * t7 * t7;
            const real c_vy = v[9 * 8 + j];
            const real t27 = offset_y * t8 + t26[j] + t25[j] + t23[j] - c_vy - offset_x * t13;
            const real t28 = t22 * (arm_x * t21 + arm_y * t27);
            const real t29 = t7 * t21 - arm_x * t28;
            Phi_x[0 * 8 + j] = n0[j] * t29; /* Phi_x(0,0) */
            const real t30 = t7 * t27 - arm_y * t28;
            Phi_x[1 * 8 + j] = n0[j] * t30; /* Phi_x(0,1) */
            const real t31 = arm_x * t7;
            const real t32 = 2.0 * t31 * t18[j] + longer[j] * t29;
            const real t33 = arm_y * t7;
            const real t34 = handles_x[j] * t29 + handles_y[j] * t30 + t24[j] * t33 + t11[j] * t31;
            const real t35 = handles_x[j] * t31 + handles_y[j] * t33;
            const real t36 = t17[j] * t34 + 0.009027777777777777 * (t16[j] * t35);
            const real t37 = t17[j] * t35;
            const real t38 = 2.0 * (turn_x[j] * t36 + t14[j] * t37);
            Phi_x[2 * 8 + j] = n1[j] * t32 - t38; /* Phi_x(0,2) */
            const real t39 = 2.0 * t33 * t18[j] + longer[j] * t30;
            const real t40 = 2.0 * (turn_y[j] * t36 + t15[j] * t37);
            Phi_x[3 * 8 + j] = n1[j] * t39 - t40; /* Phi_x(0,3) */
            Phi_x[4 * 8 + j] = n2[j] * t29; /* Phi_x(0,4) */
            Phi_x[5 * 8 + j] = n2[j] * t30; /* Phi_x(0,5) */
            Phi_x[6 * 8 + j] = t38 - t5[j] * t32; /* Phi_x(0,6) */
            Phi_x[7 * 8 + j] = t40 - t5[j] * t39; /* Phi_x(0,7) */
            Phi_x[8 * 8 + j] = -t29; /* Phi_x(0,8) */
            Phi_x[9 * 8 + j] = -t30; /* Phi_x(0,9) */
            const real t41 = r_vangle * (offset_y * t33 + offset_x * t31) + offset_y * t29;
            const real t42 = r_vangle * (offset_y * t31 - offset_x * t33) - offset_y * t30;
            Phi_x[10 * 8 + j] = cos_r[j] * (t41 - offset_x * t30) - sin_r[j] * (t42 - offset_x * t29);
                /* Phi_x(0,10) */
            const real t45 = t22 * (arm_x * sliding_y[j] - arm_y * sliding_x[j]);
            const real t46 = t7 * sliding_y[j] - arm_x * t45;
            const real t47 = t46 - r_vangle * t31;
            Phi_x[11 * 8 + j] = n0[j] * t47; /* Phi_x(1,0) */
            const real t48 = arm_y * t45 + t7 * sliding_x[j];
            const real t49 = t48 + r_vangle * t33;
            Phi_x[20 * 8 + j] = t49; /* Phi_x(1,9) */
            Phi_x[12 * 8 + j] = -(n0[j] * t49); /* Phi_x(1,1) */
            const real t50 = longer[j] * t47 - rate[j] * t33;
            const real t51 = t24[j] * t31 + handles_x[j] * t47 - t11[j] * t33 - handles_y[j] * t49;
            const real t52 = handles_y[j] * t31 - handles_x[j] * t33;
            const real t53 = t17[j] * t51 + 0.009027777777777777 * (t16[j] * t52);
            const real t54 = t43[j] * t52;
            const real t55 = 2.0 * turn_x[j] * t53 + t14[j] * t54;
            Phi_x[13 * 8 + j] = n1[j] * t50 - t55; /* Phi_x(1,2) */
            const real t56 = rate[j] * t31 - longer[j] * t49;
            const real t57 = 2.0 * turn_y[j] * t53 + t15[j] * t54;
            Phi_x[14 * 8 + j] = n1[j] * t56 - t57; /* Phi_x(1,3) */
            Phi_x[15 * 8 + j] = n2[j] * t47; /* Phi_x(1,4) */
            Phi_x[16 * 8 + j] = -(n2[j] * t49); /* Phi_x(1,5) */
            Phi_x[17 * 8 + j] = t55 - t5[j] * t50; /* Phi_x(1,6) */
            Phi_x[18 * 8 + j] = t57 - t5[j] * t56; /* Phi_x(1,7) */
            Phi_x[19 * 8 + j] = -t47; /* Phi_x(1,8) */
            Phi_x[21 * 8 + j] = cos_r[j] * (offset_x * t48 + offset_y * t46) - sin_r[j] * (offset_y * t48 - offset_x
                * t46); /* Phi_x(1,10) */
        }
    }
}

/* kinematics: 635 operations.
 * in:  x (11), v (11), a (11), p (7)
 * out: Psi_x (2,11), Psi_v (2,11) */
FLEXEL_CLONES
static void planar_cable_circle_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict a = in[2] + b * (11 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict Psi_x = out[0] + b * (22 * 8);
        real *restrict Psi_v = out[1] + b * (22 * 8);
        real n0[8], t3[8], sin_r[8], turn_x[8], turn_y[8], square_turn[8], longer[8], n1[8], t6[8], handles_x[8],
            n2[8], d_x[8], cos_r[8], handles_y[8], d_y[8], t8[8], t9[8], t11[8], t15[8], t18[8], t19[8], t20[8],
            t22[8], t25[8], t26[8], t28[8], t29[8], t32[8], t33[8], t34[8], t41[8], t43[8], t46[8], t48[8], t50[8],
            t51[8], t52[8], t54[8], t67[8], t82[8], t96[8], t97[8], rate[8], t99[8], sliding_y[8], t102[8],
            sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t3[j] = r_angle + alpha0;
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            turn_x[j] = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            turn_y[j] = dq_y - dp_y;
            square_turn[j] = turn_x[j] * turn_x[j] + turn_y[j] * turn_y[j];
            const real t4 = 0.020833333333333332 + 0.0022569444444444442 * square_turn[j];
            longer[j] = 1.0 + square_turn[j] * t4;
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * t1 * xi;
            const real t5 = xi * xi;
            t6[j] = l0 * t0 * t5;
            handles_x[j] = dp_x * n1[j] - dq_x * t6[j];
            const real p_x = x[0 * 8 + j];
            n2[j] = t5 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0[j] + q_x * n2[j] + longer[j] * handles_x[j] - c_x;
            handles_y[j] = dp_y * n1[j] - dq_y * t6[j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0[j] + q_y * n2[j] + longer[j] * handles_y[j] - c_y;
            const real dq_vx = v[6 * 8 + j];
            const real dp_vx = v[2 * 8 + j];
            t8[j] = dq_vx - dp_vx;
            const real dq_vy = v[7 * 8 + j];
            const real dp_vy = v[3 * 8 + j];
            t9[j] = dq_vy - dp_vy;
            const real t10 = t8[j] * t8[j] + t9[j] * t9[j];
            t11[j] = turn_x[j] * t8[j] + turn_y[j] * t9[j];
            const real t12 = t11[j] * t11[j];
            const real t13 = 0.0045138888888888885 * (4.0 * t12 + 2.0 * square_turn[j] * t10);
            const real t14 = 0.041666666666666664 * t10 + t13;
            t15[j] = handles_x[j] * t14;
            t18[j] = dp_vx * n1[j] - dq_vx * t6[j];
            t19[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn[j];
            t20[j] = t11[j] * t19[j];
            const real t21 = t18[j] * t20[j];
            t22[j] = 4.0 * t21;
            const real dp_ax = a[2 * 8 + j];
            const real dq_ax = a[6 * 8 + j];
            t25[j] = dp_ax * n1[j] - dq_ax * t6[j];
            t26[j] = longer[j] * t25[j];
            t28[j] = dq_ax - dp_ax;
            const real dq_ay = a[7 * 8 + j];
            const real dp_ay = a[3 * 8 + j];
            t29[j] = dq_ay - dp_ay;
            const real t30 = turn_x[j] * t28[j] + turn_y[j] * t29[j];
            const real t31 = t19[j] * t30;
            t32[j] = 2.0 * handles_x[j] * t31;
            const real p_ax = a[0 * 8 + j];
            t33[j] = n0[j] * p_ax;
            const real q_ax = a[4 * 8 + j];
            t34[j] = n2[j] * q_ax;
            const real p_vx = v[0 * 8 + j];
            const real q_vx = v[4 * 8 + j];
            const real t40 = p_vx * n0[j] + q_vx * n2[j] + longer[j] * t18[j];
            const real c_vx = v[8 * 8 + j];
            t41[j] = t40 + 2.0 * handles_x[j] * t20[j] - c_vx;
            t43[j] = dp_vy * n1[j] - dq_vy * t6[j];
            const real t44 = longer[j] * t43[j];
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real t45 = p_vy * n0[j] + q_vy * n2[j];
            const real c_vy = v[9 * 8 + j];
            t46[j] = t44 + t45 + 2.0 * handles_y[j] * t20[j] - c_vy;
            t48[j] = handles_y[j] * t14;
            const real t49 = t43[j] * t20[j];
            t50[j] = 4.0 * t49;
            t51[j] = dp_ay * n1[j] - dq_ay * t6[j];
            t52[j] = longer[j] * t51[j];
            const real p_ay = a[1 * 8 + j];
            const real q_ay = a[5 * 8 + j];
            const real t53 = n0[j] * p_ay + n2[j] * q_ay;
            t54[j] = 2.0 * handles_y[j] * t31 + t53;
            t67[j] = t14 + 2.0 * t31;
            t82[j] = t10 + t30;
            t96[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn[j];
            t97[j] = 0.018055555555555554 * t12 + t96[j] * t82[j];
            rate[j] = t96[j] * t11[j];
            const real t98 = t52[j] + t53 + rate[j] * t43[j] + 2.0 * t49 + handles_y[j] * t97[j];
            const real r_vangle = v[10 * 8 + j];
            const real c_ay = a[9 * 8 + j];
            const real r_aangle = a[10 * 8 + j];
            t99[j] = t98 - r_vangle * t41[j] - c_ay - r_aangle * d_x[j];
            sliding_y[j] = rate[j] * handles_y[j] + t45 + t44 - c_vy - r_vangle * d_x[j];
            const real t100 = t33[j] + t34[j] + t26[j] + r_aangle * d_y[j] + r_vangle * t46[j];
            const real t101 = 2.0 * t21 + t100 + rate[j] * t18[j] + handles_x[j] * t97[j];
            const real c_ax = a[8 * 8 + j];
            t102[j] = t101 - c_ax;
            sliding_x[j] = rate[j] * handles_x[j] + t40 + r_vangle * d_y[j] - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t3[j]);
            cos_r[j] = real_cos(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real offset_x = p[3 * 8 + j];
            const real arm_x = offset_y * sin_r[j] + d_x[j] - offset_x * cos_r[j];
            const real arm_y = d_y[j] - offset_y * cos_r[j] - offset_x * sin_r[j];
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t7 = 1.0 / distance;
            const real r_vangle = v[10 * 8 + j];
            const real t16 = r_vangle * cos_r[j];
            const real t17 = r_vangle * t16;
            const real t23 = r_vangle * sin_r[j];
            const real t24 = r_vangle * t23;
            const real r_aangle = a[10 * 8 + j];
            const real t27 = cos_r[j] * r_aangle;
            const real t35 = sin_r[j] * r_aangle;
            const real t36 = t34[j] + offset_x * t35 + t33[j] + t32[j] + offset_y * t27;
            const real c_ax = a[8 * 8 + j];
            const real t37 = offset_x * t17 + t22[j] + t15[j] - offset_y * t24 + (t26[j] + t36 - c_ax);
            const real t38 = t7 * t7;
            const real t39 = t7 * t38;
            const real t42 = offset_x * t23 + t41[j] + offset_y * t16;
            const real t47 = offset_y * t23 + t46[j] - offset_x * t16;
            const real c_ay = a[9 * 8 + j];
            const real t55 = offset_x * t24 + t50[j] + offset_y * t17 + t48[j] + (offset_y * t35 + t54[j] + t52[j]
                - c_ay - offset_x * t27);
            const real t56 = arm_x * t42 + arm_y * t47;
            const real t57 = t7 * t56;
            const real t58 = arm_x * t37 + arm_y * t55 + t47 * t47 + t42 * t42 - 2.0 * t57 * t57;
            const real t59 = t56 * t38;
            const real t60 = t39 * (t58 - t56 * t59);
            const real t61 = t57 * t38;
            const real t62 = t7 * t59;
            const real t63 = t61 + t62;
            const real t64 = t7 * t37 - arm_x * t60 - t42 * t63;
            Psi_x[0 * 8 + j] = n0[j] * t64; /* Psi_x(0,0) */
            const real t65 = t7 * t55 - arm_y * t60 - t47 * t63;
            Psi_x[1 * 8 + j] = n0[j] * t65; /* Psi_x(0,1) */
            const real t66 = arm_x * t7;
            const real t68 = t7 * t42;
            const real t69 = t68 - 0.5 * arm_x * t63;
            const real t70 = 4.0 * t20[j] * t69 + longer[j] * t64 + t66 * t67[j];
            const real t71 = arm_y * t7;
            const real t72 = handles_x[j] * t66 + handles_y[j] * t71;
            const real t73 = t19[j] * t72;
            const real t74 = t11[j] * t72;
            const real t75 = t71 * t43[j] + t66 * t18[j];
            const real t76 = t7 * t47;
            const real t77 = t76 - 0.5 * arm_y * t63;
            const real t78 = t75 + handles_y[j] * t77 + handles_x[j] * t69;
            const real t79 = 0.018055555555555554 * t74 + 2.0 * t19[j] * t78;
            const real t80 = t71 * t51[j] + t66 * t25[j] + handles_y[j] * t65 + 2.0 * (t18[j] * t69 + t43[j] * t77);
            const real t81 = handles_x[j] * t64 + t80;
            const real t83 = 2.0 * t72 * t82[j] + 4.0 * t11[j] * t78 + square_turn[j] * t81;
            const real t84 = 0.0045138888888888885 * t83 + 0.020833333333333332 * t81;
            const real t85 = 2.0 * (t73 * t28[j] + t8[j] * t79 + turn_x[j] * t84);
            Psi_x[2 * 8 + j] = n1[j] * t70 - t85; /* Psi_x(0,2) */
            const real t86 = 4.0 * t20[j] * t77 + longer[j] * t65 + t71 * t67[j];
            const real t87 = 2.0 * (t73 * t29[j] + t9[j] * t79 + turn_y[j] * t84);
            Psi_x[3 * 8 + j] = n1[j] * t86 - t87; /* Psi_x(0,3) */
            Psi_x[4 * 8 + j] = n2[j] * t64; /* Psi_x(0,4) */
            Psi_x[5 * 8 + j] = n2[j] * t65; /* Psi_x(0,5) */
            Psi_x[6 * 8 + j] = t85 - t6[j] * t70; /* Psi_x(0,6) */
            Psi_x[7 * 8 + j] = t87 - t6[j] * t86; /* Psi_x(0,7) */
            Psi_x[8 * 8 + j] = -t64; /* Psi_x(0,8) */
            Psi_x[9 * 8 + j] = -t65; /* Psi_x(0,9) */
            const real t88 = offset_y * t71 + offset_x * t66;
            const real t89 = offset_y * t66 - offset_x * t71;
            const real t90 = r_vangle * t89;
            const real t91 = r_vangle * (2.0 * (offset_y * t77 + offset_x * t69) - t90);
            const real t92 = cos_r[j] * (t91 + offset_y * t64 + r_aangle * t88 - offset_x * t65);
            const real t93 = r_vangle * t88;
            const real t94 = r_vangle * (t93 + 2.0 * (offset_y * t69 - offset_x * t77));
            const real t95 = sin_r[j] * (r_aangle * t89 + t94 - offset_y * t65 - offset_x * t64);
            Psi_x[10 * 8 + j] = t92 - t95; /* Psi_x(0,10) */
            const real t103 = arm_x * sliding_y[j] - arm_y * sliding_x[j];
            const real t104 = sliding_y[j] * t42 + arm_x * t99[j] - arm_y * t102[j] - 2.0 * t7 * t103 * t57;
            const real t105 = t103 * t38;
            const real t106 = t39 * (t104 - t47 * sliding_x[j] - t56 * t105);
            const real t107 = t7 * t105;
            const real t108 = t7 * t99[j] - arm_x * t106 - t42 * t107 - sliding_y[j] * t61;
            const real t109 = t68 - arm_x * t61;
            const real t110 = t108 - r_aangle * t66 - r_vangle * t109;
            Psi_x[11 * 8 + j] = n0[j] * t110; /* Psi_x(1,0) */
            const real t111 = arm_y * t61 - t76;
            const real t112 = sliding_x[j] * t61 - t7 * t102[j] - arm_y * t106 - t47 * t107;
            const real t113 = r_vangle * t111 + t112 - r_aangle * t71;
            Psi_x[12 * 8 + j] = n0[j] * t113; /* Psi_x(1,1) */
            const real t114 = t7 * sliding_y[j] - arm_x * t107;
            const real t115 = t114 - r_vangle * t66;
            const real t116 = rate[j] * t111 + longer[j] * t110 + 2.0 * t20[j] * t115 - t71 * t97[j];
            const real t117 = handles_y[j] * t66 - handles_x[j] * t71;
            const real t118 = t66 * t43[j] - t71 * t18[j];
            const real t119 = t118 + handles_y[j] * t109 + handles_x[j] * t111;
            const real t120 = t7 * sliding_x[j] + arm_y * t107;
            const real t121 = r_vangle * t71 + t120;
            const real t122 = t118 + handles_x[j] * t115 - handles_y[j] * t121;
            const real t123 = 0.009027777777777777 * (t117 * t82[j] + t11[j] * (t119 + t122));
            const real t124 = t111 + t115;
            const real t125 = t109 - t121;
            const real t126 = t66 * t51[j] + t43[j] * t125 + t18[j] * t124 + handles_x[j] * t110;
            const real t127 = t123 + t19[j] * (handles_y[j] * t113 + t126 - t71 * t25[j]);
            const real t128 = t96[j] * t117;
            const real t129 = t11[j] * t117;
            const real t130 = 0.018055555555555554 * t129 + t96[j] * t119 + 2.0 * (0.009027777777777777 * t129
                + t19[j] * t122);
            const real t131 = t128 * t28[j] + t8[j] * t130 + 2.0 * turn_x[j] * t127;
            Psi_x[13 * 8 + j] = n1[j] * t116 - t131; /* Psi_x(1,2) */
            const real t132 = rate[j] * t109 + longer[j] * t113 + t66 * t97[j] - 2.0 * t20[j] * t121;
            const real t133 = t128 * t29[j] + t9[j] * t130 + 2.0 * turn_y[j] * t127;
            Psi_x[14 * 8 + j] = n1[j] * t132 - t133; /* Psi_x(1,3) */
            Psi_x[15 * 8 + j] = n2[j] * t110; /* Psi_x(1,4) */
            Psi_x[16 * 8 + j] = n2[j] * t113; /* Psi_x(1,5) */
            Psi_x[17 * 8 + j] = t131 - t6[j] * t116; /* Psi_x(1,6) */
            Psi_x[18 * 8 + j] = t133 - t6[j] * t132; /* Psi_x(1,7) */
            Psi_x[19 * 8 + j] = -t110; /* Psi_x(1,8) */
            Psi_x[20 * 8 + j] = -t113; /* Psi_x(1,9) */
            const real t134 = offset_x * t114 - offset_y * t120;
            const real t135 = cos_r[j] * (r_vangle * t134 + offset_y * t108 - offset_x * t112);
            const real t136 = offset_x * t120 + offset_y * t114;
            const real t137 = sin_r[j] * (r_vangle * t136 - offset_y * t112 - offset_x * t108);
            Psi_x[21 * 8 + j] = t135 - t137; /* Psi_x(1,10) */
            const real t138 = 0.5 * arm_x * t62;
            const real t139 = t68 - t138 - t138;
            Psi_v[0 * 8 + j] = 2.0 * n0[j] * t139; /* Psi_v(0,0) */
            const real t140 = 0.5 * arm_y * t62;
            const real t141 = t76 - t140 - t140;
            Psi_v[1 * 8 + j] = 2.0 * n0[j] * t141; /* Psi_v(0,1) */
            const real t142 = 2.0 * t66 * t20[j];
            const real t143 = t142 + longer[j] * t139;
            const real t144 = t19[j] * (t75 + handles_y[j] * t141 + handles_x[j] * t139);
            const real t145 = 0.009027777777777777 * t74 + t144;
            const real t146 = 2.0 * (t8[j] * t73 + turn_x[j] * t145);
            Psi_v[2 * 8 + j] = 2.0 * (n1[j] * t143 - t146); /* Psi_v(0,2) */
            const real t147 = 2.0 * t71 * t20[j];
            const real t148 = t147 + longer[j] * t141;
            const real t149 = 2.0 * (t9[j] * t73 + turn_y[j] * t145);
            Psi_v[3 * 8 + j] = 2.0 * (n1[j] * t148 - t149); /* Psi_v(0,3) */
            Psi_v[4 * 8 + j] = 2.0 * n2[j] * t139; /* Psi_v(0,4) */
            Psi_v[5 * 8 + j] = 2.0 * n2[j] * t141; /* Psi_v(0,5) */
            Psi_v[6 * 8 + j] = 2.0 * (t146 - t6[j] * t143); /* Psi_v(0,6) */
            Psi_v[7 * 8 + j] = 2.0 * (t149 - t6[j] * t148); /* Psi_v(0,7) */
            Psi_v[8 * 8 + j] = -(2.0 * t139); /* Psi_v(0,8) */
            Psi_v[9 * 8 + j] = -(2.0 * t141); /* Psi_v(0,9) */
            const real t150 = cos_r[j] * (t93 + offset_y * t139 - offset_x * t141) - sin_r[j] * (t90 - offset_y * t141
                - offset_x * t139);
            Psi_v[10 * 8 + j] = 2.0 * t150; /* Psi_v(0,10) */
            Psi_v[11 * 8 + j] = n0[j] * t124; /* Psi_v(1,0) */
            Psi_v[12 * 8 + j] = n0[j] * t125; /* Psi_v(1,1) */
            const real t151 = longer[j] * t124 - t147 - rate[j] * t71;
            const real t152 = 2.0 * t8[j] * t128 + turn_x[j] * t130;
            Psi_v[13 * 8 + j] = n1[j] * t151 - t152; /* Psi_v(1,2) */
            const real t153 = t142 + rate[j] * t66 + longer[j] * t125;
            const real t154 = 2.0 * t9[j] * t128 + turn_y[j] * t130;
            Psi_v[14 * 8 + j] = n1[j] * t153 - t154; /* Psi_v(1,3) */
            Psi_v[15 * 8 + j] = n2[j] * t124; /* Psi_v(1,4) */
            Psi_v[16 * 8 + j] = n2[j] * t125; /* Psi_v(1,5) */
            Psi_v[17 * 8 + j] = t152 - t6[j] * t151; /* Psi_v(1,6) */
            Psi_v[18 * 8 + j] = t154 - t6[j] * t153; /* Psi_v(1,7) */
            Psi_v[19 * 8 + j] = -t124; /* Psi_v(1,8) */
            Psi_v[20 * 8 + j] = -t125; /* Psi_v(1,9) */
            const real t155 = d_y[j] * t111 + sin_r[j] * t134 + cos_r[j] * t136 - t66 * t41[j];
            Psi_v[21 * 8 + j] = t155 - t71 * t46[j] - d_x[j] * t109; /* Psi_v(1,10) */
        }
    }
}

/* stiffness: 812 operations.
 * in:  x (11), sigma (1), tau (1), p (7)
 * out: K (11,11) */
FLEXEL_CLONES
static void planar_cable_circle_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict K = out[0] + b * (121 * 8);
        real n0[8], n2[8], n1[8], t4[8], handles_y[8], turn_x[8], turn_y[8], d_y[8], t6[8], cos_r[8], sin_r[8],
            handles_x[8], d_x[8], t30[8], t31[8], t32[8], t33[8], t52[8], t100[8], t103[8], t105[8], t108[8], t115[8],
            t120[8], t145[8], t150[8], t171[8], t172[8], t182[8], t183[8], t222[8], t227[8], t233[8], t237[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real t3 = xi * xi;
            n2[j] = t3 * (3.0 - t2);
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * xi * t1;
            const real dp_y = x[3 * 8 + j];
            t4[j] = l0 * t3 * t0;
            const real dq_y = x[7 * 8 + j];
            handles_y[j] = dp_y * n1[j] - dq_y * t4[j];
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            turn_x[j] = dq_x - dp_x;
            turn_y[j] = dq_y - dp_y;
            const real square_turn = turn_x[j] * turn_x[j] + turn_y[j] * turn_y[j];
            const real t5 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            const real longer = 1.0 + square_turn * t5;
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0[j] + handles_y[j] * longer + q_y * n2[j] - c_y;
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t6[j] = r_angle + alpha0;
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            handles_x[j] = dp_x * n1[j] - dq_x * t4[j];
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0[j] + handles_x[j] * longer + q_x * n2[j] - c_x;
            t30[j] = n1[j] * longer;
            t31[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            t32[j] = handles_x[j] * t31[j];
            t33[j] = handles_y[j] * t31[j];
            t52[j] = t4[j] * longer;
            t100[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn;
            const real t101 = handles_x[j] * t100[j];
            const real t102 = turn_x[j] * t101;
            t103[j] = t102 - t30[j];
            const real t104 = handles_y[j] * t100[j];
            t105[j] = turn_x[j] * t104;
            t108[j] = turn_x[j] * t33[j];
            const real t114 = 2.0 * turn_x[j] * t32[j];
            t115[j] = t30[j] - t114;
            t120[j] = n1[j] * t100[j];
            t145[j] = t4[j] * t31[j];
            t150[j] = t4[j] * t100[j];
            const real t170 = turn_y[j] * t104;
            t171[j] = t30[j] - t170;
            t172[j] = turn_y[j] * t101;
            const real t181 = 2.0 * turn_y[j] * t33[j];
            t182[j] = t30[j] - t181;
            t183[j] = turn_y[j] * t32[j];
            t222[j] = t52[j] - t102;
            t227[j] = t114 - t52[j];
            t233[j] = t170 - t52[j];
            t237[j] = t181 - t52[j];
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t6[j]);
            sin_r[j] = real_sin(t6[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real t7 = offset_y * cos_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t8 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t7 - t8;
            const real t9 = offset_y * sin_r[j];
            const real t10 = offset_x * cos_r[j];
            const real arm_x = t9 + d_x[j] - t10;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t11 = 1.0 / distance;
            const real t12 = t11 * t11 * t11;
            const real tau_tangential = tau[0 * 8 + j];
            const real t13 = tau_tangential * t12;
            const real t14 = arm_x * t13;
            const real t15 = arm_y * t14;
            const real t16 = n0[j] * t15;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t17 = sigma_gap * t11;
            const real t18 = sigma_gap * t12;
            const real t19 = arm_x * t18;
            const real t20 = t17 - arm_x * t19;
            const real t21 = t16 + n0[j] * t20;
            K[0 * 8 + j] = n0[j] * t21; /* K(0,0) */
            const real t22 = arm_y * t18;
            const real t23 = arm_x * t22;
            const real t24 = n0[j] * t23;
            const real t25 = n0[j] * t24;
            const real t26 = tau_tangential * t11;
            const real t27 = arm_y * t13;
            const real t28 = t26 - arm_y * t27;
            const real t29 = n0[j] * t28;
            K[1 * 8 + j] = -(t25 + n0[j] * t29); /* K(0,1) */
            const real t34 = t32[j] * t20 - t33[j] * t23;
            const real t35 = 2.0 * turn_x[j] * t34;
            const real t36 = t30[j] * t20 - t35;
            const real t37 = n0[j] * t36;
            const real t38 = t33[j] * t28 - t32[j] * t15;
            const real t39 = 2.0 * turn_x[j] * t38;
            const real t40 = t39 + t30[j] * t15;
            K[2 * 8 + j] = t37 + n0[j] * t40; /* K(0,2) */
            const real t41 = 2.0 * turn_y[j] * t34;
            const real t42 = t41 + t30[j] * t23;
            const real t43 = n0[j] * t42;
            const real t44 = 2.0 * turn_y[j] * t38;
            const real t45 = t30[j] * t28 - t44;
            K[3 * 8 + j] = -(t43 + n0[j] * t45); /* K(0,3) */
            const real t46 = n2[j] * t20;
            const real t47 = n0[j] * t46;
            const real t48 = n2[j] * t15;
            K[4 * 8 + j] = t47 + n0[j] * t48; /* K(0,4) */
            const real t49 = n2[j] * t23;
            const real t50 = n0[j] * t49;
            const real t51 = n2[j] * t28;
            K[5 * 8 + j] = -(t50 + n0[j] * t51); /* K(0,5) */
            const real t53 = t35 - t52[j] * t20;
            const real t54 = n0[j] * t53;
            const real t55 = t39 + t52[j] * t15;
            K[6 * 8 + j] = t54 - n0[j] * t55; /* K(0,6) */
            const real t56 = t41 + t52[j] * t23;
            const real t57 = n0[j] * t56;
            const real t58 = t44 - t52[j] * t28;
            K[7 * 8 + j] = t57 - n0[j] * t58; /* K(0,7) */
            K[8 * 8 + j] = K[88 * 8 + j] = -t21; /* K(0,8) K(8,0) */
            K[9 * 8 + j] = t24 + t29; /* K(0,9) */
            const real t59 = t7 + t8;
            const real t60 = t9 - t10;
            const real t61 = t59 * t20 - t60 * t23;
            const real t62 = n0[j] * t61;
            const real t63 = t59 * t14 + t60 * t27;
            const real t64 = t60 * t26 - arm_y * t63;
            K[10 * 8 + j] = t62 - n0[j] * t64; /* K(0,10) */
            const real t65 = t26 - arm_x * t14;
            const real t66 = n0[j] * t65;
            K[11 * 8 + j] = n0[j] * t66 - t25; /* K(1,0) */
            const real t67 = t17 - arm_y * t22;
            const real t68 = arm_x * t27;
            const real t69 = n0[j] * t68;
            const real t70 = n0[j] * t67 - t69;
            K[12 * 8 + j] = n0[j] * t70; /* K(1,1) */
            const real t71 = t32[j] * t65 - t33[j] * t68;
            const real t72 = 2.0 * turn_x[j] * t71;
            const real t73 = t30[j] * t65 - t72;
            const real t74 = arm_y * t19;
            const real t75 = t33[j] * t67 - t32[j] * t74;
            const real t76 = 2.0 * turn_x[j] * t75;
            const real t77 = t76 + t30[j] * t74;
            const real t78 = n0[j] * t77;
            K[13 * 8 + j] = n0[j] * t73 - t78; /* K(1,2) */
            const real t79 = 2.0 * turn_y[j] * t75;
            const real t80 = t30[j] * t67 - t79;
            const real t81 = n0[j] * t80;
            const real t82 = 2.0 * turn_y[j] * t71;
            const real t83 = t82 + t30[j] * t68;
            K[14 * 8 + j] = t81 - n0[j] * t83; /* K(1,3) */
            const real t84 = n2[j] * t65;
            const real t85 = n2[j] * t74;
            const real t86 = n0[j] * t85;
            K[15 * 8 + j] = n0[j] * t84 - t86; /* K(1,4) */
            const real t87 = n2[j] * t67;
            const real t88 = n0[j] * t87;
            const real t89 = n2[j] * t68;
            K[16 * 8 + j] = t88 - n0[j] * t89; /* K(1,5) */
            const real t90 = t76 + t52[j] * t74;
            const real t91 = n0[j] * t90;
            const real t92 = t72 - t52[j] * t65;
            K[17 * 8 + j] = t91 + n0[j] * t92; /* K(1,6) */
            const real t93 = t79 - t52[j] * t67;
            const real t94 = n0[j] * t93;
            const real t95 = t82 + t52[j] * t68;
            K[18 * 8 + j] = t94 + n0[j] * t95; /* K(1,7) */
            const real t96 = n0[j] * t74;
            K[19 * 8 + j] = t96 - t66; /* K(1,8) */
            K[20 * 8 + j] = K[100 * 8 + j] = -t70; /* K(1,9) K(9,1) */
            const real t97 = t60 * t67 - t59 * t74;
            const real t98 = n0[j] * t97;
            const real t99 = t59 * t26 - arm_x * t63;
            K[21 * 8 + j] = t98 + n0[j] * t99; /* K(1,10) */
            const real t106 = t105[j] * t66;
            K[22 * 8 + j] = t37 - t16 * t103[j] - t106; /* K(2,0) */
            const real t107 = t105[j] * t69;
            K[23 * 8 + j] = t107 + t29 * t103[j] - t78; /* K(2,1) */
            const real t109 = arm_x * t17;
            const real t110 = 2.0 * (t108[j] * t77 - turn_x[j] * t109 * t31[j] * n1[j]);
            const real t111 = arm_y * t17;
            const real t112 = handles_y[j] * t111 + handles_x[j] * t109;
            const real t113 = 2.0 * t31[j] * t112;
            const real t116 = arm_x * t26;
            const real t117 = arm_y * t26;
            const real t118 = handles_y[j] * t116 - handles_x[j] * t117;
            const real t119 = t100[j] * t118;
            const real t121 = t117 * t120[j];
            const real t122 = t119 + turn_x[j] * t121;
            const real t123 = 0.009027777777777777 * (turn_x[j] * t118);
            const real t124 = t31[j] * t117;
            const real t125 = t123 + n1[j] * t124;
            const real t126 = 2.0 * turn_x[j] * t125;
            const real t127 = t31[j] * t109;
            const real t128 = 0.009027777777777777 * (turn_x[j] * t112);
            const real t129 = n1[j] * t127 - t128;
            const real t130 = 2.0 * turn_x[j] * t129;
            const real t131 = t122 + t126 + t115[j] * t36 + t113 + t110 - t130 - t103[j] * t40;
            const real t132 = t105[j] * t73;
            K[24 * 8 + j] = t131 - t132; /* K(2,2) */
            const real t133 = 2.0 * turn_y[j] * t125;
            const real t134 = t105[j] * t83;
            const real t135 = t116 * t120[j];
            const real t136 = turn_x[j] * t135;
            const real t137 = t31[j] * t111;
            const real t138 = n1[j] * t137;
            const real t139 = 2.0 * turn_y[j] * t129;
            const real t140 = t139 + t115[j] * t42 + 2.0 * (turn_x[j] * t138 + t108[j] * t80);
            K[25 * 8 + j] = t133 + t134 + t103[j] * t45 - t136 - t140; /* K(2,3) */
            const real t141 = 2.0 * t108[j] * t85 + t115[j] * t46;
            const real t142 = t105[j] * t84;
            K[26 * 8 + j] = t141 - t48 * t103[j] - t142; /* K(2,4) */
            const real t143 = t105[j] * t89;
            const real t144 = 2.0 * t108[j] * t87 + t115[j] * t49;
            K[27 * 8 + j] = t143 + t51 * t103[j] - t144; /* K(2,5) */
            const real t146 = t109 * t145[j];
            const real t147 = t113 - 2.0 * turn_x[j] * t146;
            const real t148 = 2.0 * t108[j] * t90;
            const real t149 = t130 + t115[j] * t53 - t147 - t148;
            const real t151 = t117 * t150[j];
            const real t152 = t119 + turn_x[j] * t151;
            const real t153 = t105[j] * t92;
            K[28 * 8 + j] = t149 + t103[j] * t55 - t152 - t126 - t153; /* K(2,6) */
            const real t154 = t116 * t150[j];
            const real t155 = turn_x[j] * t154;
            const real t156 = t111 * t145[j];
            const real t157 = 2.0 * turn_x[j] * t156;
            const real t158 = 2.0 * t108[j] * t93;
            const real t159 = t157 + t115[j] * t56 + t139 - t158;
            const real t160 = t105[j] * t95;
            K[29 * 8 + j] = t159 + t103[j] * t58 + t155 - t133 - t160; /* K(2,7) */
            const real t161 = t105[j] * t65;
            const real t162 = 2.0 * t108[j] * t74;
            const real t163 = t162 + t115[j] * t20;
            K[30 * 8 + j] = t161 + t15 * t103[j] - t163; /* K(2,8) */
            const real t164 = 2.0 * t108[j] * t67;
            const real t165 = t164 + t115[j] * t23;
            const real t166 = t105[j] * t68;
            K[31 * 8 + j] = t165 - t28 * t103[j] - t166; /* K(2,9) */
            const real t167 = 2.0 * t108[j] * t97;
            const real t168 = t115[j] * t61 - t167;
            const real t169 = t105[j] * t99;
            K[32 * 8 + j] = t168 + t64 * t103[j] - t169; /* K(2,10) */
            const real t173 = t172[j] * t16;
            K[33 * 8 + j] = t66 * t171[j] - t173 - t43; /* K(3,0) */
            const real t174 = t172[j] * t29;
            K[34 * 8 + j] = t81 + t174 - t69 * t171[j]; /* K(3,1) */
            const real t175 = turn_y[j] * t121;
            const real t176 = t31[j] * t116;
            const real t177 = 0.009027777777777777 * (turn_y[j] * t118);
            const real t178 = n1[j] * t176 - t177;
            const real t179 = 2.0 * turn_x[j] * t178;
            const real t180 = t172[j] * t40;
            K[35 * 8 + j] = t175 + t171[j] * t73 - t179 - t180 - t140; /* K(3,2) */
            const real t184 = t172[j] * t45;
            const real t185 = t113 + t184 + 2.0 * (t183[j] * t42 - turn_y[j] * t138) + t182[j] * t80;
            const real t186 = 0.009027777777777777 * (turn_y[j] * t112);
            const real t187 = t138 - t186;
            const real t188 = 2.0 * turn_y[j] * t187;
            const real t189 = turn_y[j] * t135 - t119;
            const real t190 = 2.0 * turn_y[j] * t178;
            K[36 * 8 + j] = t185 - t188 - t189 - t190 - t171[j] * t83; /* K(3,3) */
            const real t191 = t172[j] * t48;
            const real t192 = t85 * t182[j] + 2.0 * t183[j] * t46;
            K[37 * 8 + j] = t84 * t171[j] - t191 - t192; /* K(3,4) */
            const real t193 = t87 * t182[j] + 2.0 * t183[j] * t49;
            const real t194 = t172[j] * t51;
            K[38 * 8 + j] = t193 + t194 - t89 * t171[j]; /* K(3,5) */
            const real t195 = 2.0 * (turn_y[j] * t146 + turn_x[j] * t187 - t183[j] * t53);
            const real t196 = t195 + t182[j] * t90;
            const real t197 = t172[j] * t55;
            const real t198 = turn_y[j] * t151;
            K[39 * 8 + j] = t197 + t171[j] * t92 + t196 + t179 - t198; /* K(3,6) */
            const real t199 = t113 - 2.0 * turn_y[j] * t156;
            const real t200 = 2.0 * t183[j] * t56;
            const real t201 = t188 + t182[j] * t93 - t199 - t200;
            const real t202 = t172[j] * t58;
            const real t203 = t119 - turn_y[j] * t154;
            K[40 * 8 + j] = t202 + t171[j] * t95 + t201 + t190 - t203; /* K(3,7) */
            const real t204 = 2.0 * t183[j] * t20;
            const real t205 = t204 + t74 * t182[j];
            const real t206 = t172[j] * t15;
            K[41 * 8 + j] = t205 + t206 - t65 * t171[j]; /* K(3,8) */
            const real t207 = t172[j] * t28;
            const real t208 = 2.0 * t183[j] * t23;
            const real t209 = t208 + t67 * t182[j];
            K[42 * 8 + j] = t68 * t171[j] - t207 - t209; /* K(3,9) */
            const real t210 = t172[j] * t64;
            const real t211 = 2.0 * t183[j] * t61;
            const real t212 = t97 * t182[j] - t211;
            K[43 * 8 + j] = t212 + t99 * t171[j] + t210; /* K(3,10) */
            K[44 * 8 + j] = t47 + n2[j] * t16; /* K(4,0) */
            K[45 * 8 + j] = -(t86 + n2[j] * t29); /* K(4,1) */
            K[46 * 8 + j] = t141 + n2[j] * t40; /* K(4,2) */
            K[47 * 8 + j] = -(t192 + n2[j] * t45); /* K(4,3) */
            const real t213 = t46 + t48;
            K[48 * 8 + j] = n2[j] * t213; /* K(4,4) */
            const real t214 = n2[j] * t49;
            K[49 * 8 + j] = -(t214 + n2[j] * t51); /* K(4,5) */
            const real t215 = n2[j] * t53;
            K[50 * 8 + j] = t215 - n2[j] * t55; /* K(4,6) */
            const real t216 = n2[j] * t56;
            K[51 * 8 + j] = t216 - n2[j] * t58; /* K(4,7) */
            K[52 * 8 + j] = K[92 * 8 + j] = -t213; /* K(4,8) K(8,4) */
            K[53 * 8 + j] = t49 + t51; /* K(4,9) */
            const real t217 = n2[j] * t61;
            K[54 * 8 + j] = t217 - n2[j] * t64; /* K(4,10) */
            K[55 * 8 + j] = n2[j] * t66 - t50; /* K(5,0) */
            K[56 * 8 + j] = t88 - n2[j] * t69; /* K(5,1) */
            K[57 * 8 + j] = n2[j] * t73 - t144; /* K(5,2) */
            K[58 * 8 + j] = t193 - n2[j] * t83; /* K(5,3) */
            K[59 * 8 + j] = n2[j] * t84 - t214; /* K(5,4) */
            const real t218 = t87 - t89;
            K[60 * 8 + j] = n2[j] * t218; /* K(5,5) */
            const real t219 = n2[j] * t90;
            K[61 * 8 + j] = t219 + n2[j] * t92; /* K(5,6) */
            const real t220 = n2[j] * t93;
            K[62 * 8 + j] = t220 + n2[j] * t95; /* K(5,7) */
            K[63 * 8 + j] = t85 - t84; /* K(5,8) */
            K[64 * 8 + j] = K[104 * 8 + j] = -t218; /* K(5,9) K(9,5) */
            const real t221 = n2[j] * t97;
            K[65 * 8 + j] = t221 + n2[j] * t99; /* K(5,10) */
            K[66 * 8 + j] = t54 + t106 - t16 * t222[j]; /* K(6,0) */
            K[67 * 8 + j] = t91 + t29 * t222[j] - t107; /* K(6,1) */
            const real t223 = t123 + t4[j] * t124;
            const real t224 = 2.0 * turn_x[j] * t223;
            K[68 * 8 + j] = t149 + t132 - t122 - t224 - t222[j] * t40; /* K(6,2) */
            const real t225 = 2.0 * turn_y[j] * t223;
            K[69 * 8 + j] = t196 + t222[j] * t45 + t136 - t225 - t134; /* K(6,3) */
            K[70 * 8 + j] = t215 + t142 - t48 * t222[j]; /* K(6,4) */
            K[71 * 8 + j] = t219 + t51 * t222[j] - t143; /* K(6,5) */
            const real t226 = t128 - t4[j] * t127;
            const real t228 = t153 + t222[j] * t55 + t224 + t152 + t227[j] * t53 + t148;
            K[72 * 8 + j] = t147 + t228 + 2.0 * turn_x[j] * t226; /* K(6,6) */
            const real t229 = t158 + t227[j] * t56 + 2.0 * turn_y[j] * t226 - t157;
            K[73 * 8 + j] = t160 + t222[j] * t58 + t229 + t225 - t155; /* K(6,7) */
            const real t230 = t162 - t227[j] * t20;
            K[74 * 8 + j] = t230 + t15 * t222[j] - t161; /* K(6,8) */
            const real t231 = t227[j] * t23 - t164;
            K[75 * 8 + j] = t231 + t166 - t28 * t222[j]; /* K(6,9) */
            const real t232 = t167 + t227[j] * t61;
            K[76 * 8 + j] = t232 + t169 + t64 * t222[j]; /* K(6,10) */
            K[77 * 8 + j] = t57 + t66 * t233[j] + t173; /* K(7,0) */
            K[78 * 8 + j] = t94 - t174 - t69 * t233[j]; /* K(7,1) */
            const real t234 = t177 - t4[j] * t176;
            const real t235 = 2.0 * turn_x[j] * t234;
            K[79 * 8 + j] = t159 + t233[j] * t73 + t180 - t175 - t235; /* K(7,2) */
            const real t236 = 2.0 * turn_y[j] * t234;
            K[80 * 8 + j] = t201 + t189 - t236 - t184 - t233[j] * t83; /* K(7,3) */
            K[81 * 8 + j] = t216 + t84 * t233[j] + t191; /* K(7,4) */
            K[82 * 8 + j] = t220 - t194 - t89 * t233[j]; /* K(7,5) */
            K[83 * 8 + j] = t235 + t233[j] * t92 + t229 + t198 - t197; /* K(7,6) */
            const real t238 = t236 + t233[j] * t95 + t203 + t200 + t237[j] * t93 + t199;
            K[84 * 8 + j] = 2.0 * turn_y[j] * (t186 - t4[j] * t137) + t238 - t202; /* K(7,7) */
            const real t239 = t74 * t237[j] - t204;
            K[85 * 8 + j] = t239 - t206 - t65 * t233[j]; /* K(7,8) */
            const real t240 = t208 - t67 * t237[j];
            K[86 * 8 + j] = t240 + t68 * t233[j] + t207; /* K(7,9) */
            const real t241 = t211 + t97 * t237[j];
            K[87 * 8 + j] = t241 + t99 * t233[j] - t210; /* K(7,10) */
            K[89 * 8 + j] = t96 + t29; /* K(8,1) */
            K[90 * 8 + j] = -(t163 + t40); /* K(8,2) */
            K[91 * 8 + j] = t205 + t45; /* K(8,3) */
            K[93 * 8 + j] = t85 + t51; /* K(8,5) */
            K[94 * 8 + j] = t230 + t55; /* K(8,6) */
            K[95 * 8 + j] = t239 + t58; /* K(8,7) */
            K[96 * 8 + j] = t20 + t15; /* K(8,8) */
            K[97 * 8 + j] = -(t23 + t28); /* K(8,9) */
            K[98 * 8 + j] = t64 - t61; /* K(8,10) */
            K[99 * 8 + j] = t24 - t66; /* K(9,0) */
            K[101 * 8 + j] = t165 - t73; /* K(9,2) */
            K[102 * 8 + j] = t83 - t209; /* K(9,3) */
            K[103 * 8 + j] = t49 - t84; /* K(9,4) */
            K[105 * 8 + j] = t231 - t92; /* K(9,6) */
            K[106 * 8 + j] = t240 - t95; /* K(9,7) */
            K[107 * 8 + j] = t65 - t23; /* K(9,8) */
            K[108 * 8 + j] = t67 - t68; /* K(9,9) */
            K[109 * 8 + j] = -(t97 + t99); /* K(9,10) */
            K[110 * 8 + j] = t62 + d_y[j] * t16 - n0[j] * t116 - d_x[j] * t66; /* K(10,0) */
            K[111 * 8 + j] = t98 + d_x[j] * t69 - n0[j] * t117 - d_y[j] * t29; /* K(10,1) */
            const real t242 = t32[j] * t116 + t33[j] * t117;
            const real t243 = 2.0 * turn_x[j] * t242;
            K[112 * 8 + j] = t168 + d_y[j] * t40 + t243 - t30[j] * t116 - d_x[j] * t73; /* K(10,2) */
            const real t244 = 2.0 * turn_y[j] * t242;
            K[113 * 8 + j] = t212 + d_x[j] * t83 + t244 - t30[j] * t117 - d_y[j] * t45; /* K(10,3) */
            K[114 * 8 + j] = t217 + d_y[j] * t48 - n2[j] * t116 - d_x[j] * t84; /* K(10,4) */
            K[115 * 8 + j] = t221 + d_x[j] * t89 - n2[j] * t117 - d_y[j] * t51; /* K(10,5) */
            K[116 * 8 + j] = t232 + t52[j] * t116 - t243 - d_y[j] * t55 - d_x[j] * t92; /* K(10,6) */
            K[117 * 8 + j] = t241 + t52[j] * t117 - t244 - d_y[j] * t58 - d_x[j] * t95; /* K(10,7) */
            K[118 * 8 + j] = t116 + d_x[j] * t65 - d_y[j] * t15 - t61; /* K(10,8) */
            K[119 * 8 + j] = t117 + d_y[j] * t28 - d_x[j] * t68 - t97; /* K(10,9) */
            const real t245 = t59 * t61 + cos_r[j] * (offset_y * t111 + offset_x * t109);
            const real t246 = t60 * t97 + t245 - sin_r[j] * (offset_y * t109 - offset_x * t111);
            K[120 * 8 + j] = t246 - d_y[j] * t64 - d_x[j] * t99; /* K(10,10) */
        }
    }
}

/* outputs: 80 operations.
 * in:  x (11), sigma (1), tau (1), p (7)
 * out: place (2), force (2), origin (2), axes (2,2) */
FLEXEL_CLONES
static void planar_cable_circle_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (7 * 8);
        real *restrict place = out[0] + b * (2 * 8);
        real *restrict force = out[1] + b * (2 * 8);
        real *restrict origin = out[2] + b * (2 * 8);
        real *restrict axes = out[3] + b * (4 * 8);
        real n0[8], n2[8], t12[8], sin_r[8], d_x[8], cos_r[8], d_y[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real p_x = x[0 * 8 + j];
            const real t3 = p_x * n0[j];
            const real t4 = xi * xi;
            n2[j] = t4 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real t5 = q_x * n2[j];
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            const real turn_x = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real turn_y = dq_y - dp_y;
            const real square_turn = turn_x * turn_x + turn_y * turn_y;
            const real t6 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            const real longer = 1.0 + square_turn * t6;
            const real l0 = p[0 * 8 + j];
            const real n1 = l0 * t1 * xi;
            const real t7 = l0 * t0 * t4;
            const real handles_x = dp_x * n1 - dq_x * t7;
            const real t8 = longer * handles_x;
            place[0 * 8 + j] = t5 + t8 + t3;
            const real p_y = x[1 * 8 + j];
            const real t9 = p_y * n0[j];
            const real q_y = x[5 * 8 + j];
            const real t10 = q_y * n2[j];
            const real handles_y = dp_y * n1 - dq_y * t7;
            const real t11 = longer * handles_y;
            place[1 * 8 + j] = t10 + t11 + t9;
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t12[j] = r_angle + alpha0;
            const real c_x = x[8 * 8 + j];
            d_x[j] = t3 + t5 + t8 - c_x;
            const real c_y = x[9 * 8 + j];
            d_y[j] = t9 + t10 + t11 - c_y;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t12[j]);
            axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
            cos_r[j] = real_cos(t12[j]);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r[j]; /* axes(0,0) axes(1,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real offset_y = p[4 * 8 + j];
            const real t13 = offset_y * sin_r[j];
            const real offset_x = p[3 * 8 + j];
            const real t14 = offset_x * cos_r[j];
            const real arm_x = t13 + d_x[j] - t14;
            const real t15 = offset_y * cos_r[j];
            const real t16 = offset_x * sin_r[j];
            const real arm_y = d_y[j] - t15 - t16;
            const real distance = real_sqrt(arm_x * arm_x + arm_y * arm_y);
            const real t17 = 1.0 / distance;
            const real sigma_gap = sigma[0 * 8 + j];
            const real t18 = sigma_gap * t17;
            const real tau_tangential = tau[0 * 8 + j];
            const real t19 = tau_tangential * t17;
            const real t20 = arm_x * t18 - arm_y * t19;
            const real p_fx = n0[j] * t20;
            const real q_fx = n2[j] * t20;
            force[0 * 8 + j] = -(p_fx + q_fx);
            const real t21 = arm_y * t18 + arm_x * t19;
            const real p_fy = n0[j] * t21;
            const real q_fy = n2[j] * t21;
            force[1 * 8 + j] = -(p_fy + q_fy);
            const real c_x = x[8 * 8 + j];
            origin[0 * 8 + j] = c_x + t14 - t13;
            const real c_y = x[9 * 8 + j];
            origin[1 * 8 + j] = c_y + t15 + t16;
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
        }
    }
}

const flexel_element flexel_planar_cable_circle = {
    .name = "planar_cable_circle",
    .digest = "f046569926e26fd6",
    .n = 11,
    .m = 1,
    .k = 1,
    .np = 7,
    .position = planar_cable_circle_position,
    .acceleration = planar_cable_circle_acceleration,
    .rates = planar_cable_circle_rates,
    .kinematics = planar_cable_circle_kinematics,
    .stiffness = planar_cable_circle_stiffness,
    .outputs = planar_cable_circle_outputs,
};
