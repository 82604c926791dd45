/* planar_cable_line: kernels of an element. Written by `flexel derive`; do not edit.
 *
 * x: point at the fraction xi of the cubic curve through p and q with the slopes h dp and h dq,
 * h = 1 + D/48 + 13 D^2/5760, D = |dq - dp|^2: tan(theta/4)/(theta/4) for the angle theta between unit slopes
 * ex, ey: directions at angle + alpha0
 * w = xdot - xcdot - angledot ez x (x - xc), the velocity seen from the body
 * gap = ey.(x - xc) - offset_y - rope_radius,  tangential = ex.w
 * place: x, force: on what touches, origin: of the surface, in global axes;  axes: its directions in rows
 *
 * Source: planar counterpart of contact in space
 *
 * x (11): p_x, p_y, dp_x, dp_y, q_x, q_y, dq_x, dq_y, c_x, c_y, r_angle
 * e (1): gap [m]
 * s (1): tangential [m/s]
 * p (6):
 *   l0 (1) [m]: undeformed length
 *   xi (1) [1]: place along the element, from 0 at p to 1 at q
 *   alpha0 (1) [rad]: initial direction of the element minus the angle of node p
 *   offset (2) [m]: origin of the circle or line from c, on ex and ey
 *   rope_radius (1) [m]: outer radius of the rope */
#include "kernels.h"

/* position: 93 operations.
 * in:  x (11), p (6)
 * out: e (1), De (1,11), V (1,11) */
FLEXEL_CLONES
static void planar_cable_line_position(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict p = in[1] + b * (6 * 8);
        real *restrict e = out[0] + b * (1 * 8);
        real *restrict De = out[1] + b * (11 * 8);
        real *restrict V = out[2] + b * (11 * 8);
        real t0[8], cos_r[8], turn_x[8], turn_y[8], longer[8], n1[8], t5[8], handles_y[8], n0[8], n2[8], d_y[8],
            sin_r[8], handles_x[8], d_x[8], t12[8], t21[8];
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
            const real t1 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            longer[j] = 1.0 + square_turn * t1;
            const real xi = p[1 * 8 + j];
            const real t2 = 1.0 - xi;
            const real t3 = t2 * t2;
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * t3 * xi;
            const real t4 = xi * xi;
            t5[j] = l0 * t2 * t4;
            handles_y[j] = dp_y * n1[j] - dq_y * t5[j];
            const real t6 = 2.0 * xi;
            n0[j] = t3 * (1.0 + t6);
            const real p_y = x[1 * 8 + j];
            n2[j] = t4 * (3.0 - t6);
            const real q_y = x[5 * 8 + j];
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0[j] + q_y * n2[j] + longer[j] * handles_y[j] - c_y;
            handles_x[j] = dp_x * n1[j] - dq_x * t5[j];
            const real p_x = x[0 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0[j] + q_x * n2[j] + longer[j] * handles_x[j] - c_x;
            t12[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            t21[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t0[j]);
            sin_r[j] = real_sin(t0[j]);
            De[8 * 8 + j] = sin_r[j]; /* De(0,8) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real t7 = cos_r[j] * d_y[j];
            const real offset_y = p[4 * 8 + j];
            const real rope_radius = p[5 * 8 + j];
            const real t8 = sin_r[j] * d_x[j];
            e[0 * 8 + j] = t7 - offset_y - rope_radius - t8;
            const real t9 = n0[j] * sin_r[j];
            V[1 * 8 + j] = t9; /* V(0,1) */
            De[0 * 8 + j] = -t9; /* De(0,0) */
            De[1 * 8 + j] = V[0 * 8 + j] = n0[j] * cos_r[j]; /* De(0,1) V(0,0) */
            const real t10 = sin_r[j] * longer[j];
            const real t11 = n1[j] * t10;
            const real t13 = t12[j] * (cos_r[j] * handles_y[j] - sin_r[j] * handles_x[j]);
            const real t14 = 2.0 * turn_x[j] * t13;
            De[2 * 8 + j] = -(t11 + t14); /* De(0,2) */
            const real t15 = cos_r[j] * longer[j];
            const real t16 = n1[j] * t15;
            const real t17 = 2.0 * turn_y[j] * t13;
            De[3 * 8 + j] = t16 - t17; /* De(0,3) */
            const real t18 = n2[j] * sin_r[j];
            V[5 * 8 + j] = t18; /* V(0,5) */
            De[4 * 8 + j] = -t18; /* De(0,4) */
            De[5 * 8 + j] = V[4 * 8 + j] = n2[j] * cos_r[j]; /* De(0,5) V(0,4) */
            const real t19 = t5[j] * t10;
            De[6 * 8 + j] = t19 + t14; /* De(0,6) */
            const real t20 = t5[j] * t15;
            De[7 * 8 + j] = t17 - t20; /* De(0,7) */
            De[9 * 8 + j] = V[8 * 8 + j] = -cos_r[j]; /* De(0,9) V(0,8) */
            De[10 * 8 + j] = -(sin_r[j] * d_y[j] + cos_r[j] * d_x[j]); /* De(0,10) */
            const real t22 = t21[j] * (sin_r[j] * handles_y[j] + cos_r[j] * handles_x[j]);
            const real t23 = turn_x[j] * t22;
            V[2 * 8 + j] = t16 - t23; /* V(0,2) */
            const real t24 = turn_y[j] * t22;
            V[3 * 8 + j] = t11 - t24; /* V(0,3) */
            V[6 * 8 + j] = t23 - t20; /* V(0,6) */
            V[7 * 8 + j] = t24 - t19; /* V(0,7) */
            V[9 * 8 + j] = -sin_r[j]; /* V(0,9) */
            V[10 * 8 + j] = t7 - t8; /* V(0,10) */
        }
    }
}

/* acceleration: 146 operations.
 * in:  x (11), v (11), p (6)
 * out: g (1), gs (1) */
FLEXEL_CLONES
static void planar_cable_line_acceleration(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict g = out[0] + b * (1 * 8);
        real *restrict gs = out[1] + b * (1 * 8);
        real t0[8], sin_r[8], d_x[8], cos_r[8], d_y[8], t20[8], t24[8], t27[8], t29[8], t32[8], sliding_y[8], t33[8],
            sliding_x[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t0[j] = r_angle + alpha0;
            const real xi = p[1 * 8 + j];
            const real t2 = xi * xi;
            const real t3 = 2.0 * xi;
            const real n2 = t2 * (3.0 - t3);
            const real q_x = x[4 * 8 + j];
            const real t4 = 1.0 - xi;
            const real t5 = t4 * t4;
            const real n0 = t5 * (1.0 + t3);
            const real p_x = x[0 * 8 + j];
            const real l0 = p[0 * 8 + j];
            const real n1 = l0 * xi * t5;
            const real dp_x = x[2 * 8 + j];
            const real t6 = l0 * t2 * t4;
            const real dq_x = x[6 * 8 + j];
            const real handles_x = dp_x * n1 - dq_x * t6;
            const real turn_x = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real turn_y = dq_y - dp_y;
            const real square_turn = turn_x * turn_x + turn_y * turn_y;
            const real t7 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            const real longer = 1.0 + square_turn * t7;
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0 + handles_x * longer + q_x * n2 - c_x;
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real handles_y = dp_y * n1 - dq_y * t6;
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0 + handles_y * longer + q_y * n2 - c_y;
            const real dp_vy = v[3 * 8 + j];
            const real dq_vy = v[7 * 8 + j];
            const real t9 = dp_vy * n1 - dq_vy * t6;
            const real dq_vx = v[6 * 8 + j];
            const real dp_vx = v[2 * 8 + j];
            const real t10 = dq_vx - dp_vx;
            const real t11 = dq_vy - dp_vy;
            const real t12 = turn_x * t10 + turn_y * t11;
            const real t13 = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            const real t14 = t12 * t13;
            const real t15 = t9 * t14;
            const real t16 = t10 * t10 + t11 * t11;
            const real t17 = t12 * t12;
            const real t18 = 0.0045138888888888885 * (4.0 * t17 + 2.0 * square_turn * t16);
            const real t19 = 0.041666666666666664 * t16 + t18;
            t20[j] = 4.0 * t15 + handles_y * t19;
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real t22 = p_vy * n0 + q_vy * n2;
            const real t23 = t9 * longer;
            const real c_vy = v[9 * 8 + j];
            t24[j] = t23 + 2.0 * handles_y * t14 + t22 - c_vy;
            const real q_vx = v[4 * 8 + j];
            const real p_vx = v[0 * 8 + j];
            const real t25 = dp_vx * n1 - dq_vx * t6;
            const real t26 = p_vx * n0 + t25 * longer + q_vx * n2;
            const real c_vx = v[8 * 8 + j];
            t27[j] = t26 + 2.0 * handles_x * t14 - c_vx;
            const real t28 = t25 * t14;
            t29[j] = 4.0 * t28 + handles_x * t19;
            const real t30 = 0.041666666666666664 + 0.009027777777777777 * square_turn;
            const real rate = t30 * t12;
            const real t31 = t30 * t16 + 0.018055555555555554 * t17;
            const real r_vangle = v[10 * 8 + j];
            t32[j] = handles_y * t31 + 2.0 * t15 + rate * t9 - r_vangle * t27[j];
            sliding_y[j] = handles_y * rate + t23 + t22 - c_vy - r_vangle * d_x[j];
            t33[j] = rate * t25 + handles_x * t31 + 2.0 * t28 + r_vangle * t24[j];
            sliding_x[j] = handles_x * rate + r_vangle * d_y[j] + t26 - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t0[j]);
            cos_r[j] = real_cos(t0[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[10 * 8 + j];
            const real t1 = r_vangle * sin_r[j];
            const real t8 = r_vangle * cos_r[j];
            const real t21 = r_vangle * (t1 * d_x[j] - t8 * d_y[j]) + cos_r[j] * t20[j];
            g[0 * 8 + j] = t21 - 2.0 * (t1 * t24[j] + t8 * t27[j]) - sin_r[j] * t29[j];
            const real t34 = t8 * sliding_y[j] + cos_r[j] * t33[j] + sin_r[j] * t32[j];
            gs[0 * 8 + j] = t34 - t1 * sliding_x[j];
        }
    }
}

/* rates: 185 operations.
 * in:  x (11), v (11), p (6)
 * out: Phi_x (2,11) */
FLEXEL_CLONES
static void planar_cable_line_rates(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict p = in[2] + b * (6 * 8);
        real *restrict Phi_x = out[0] + b * (22 * 8);
        real n0[8], t3[8], cos_r[8], sin_r[8], turn_x[8], turn_y[8], t7[8], n1[8], t9[8], t10[8], t11[8],
            handles_y[8], handles_x[8], t13[8], t14[8], t15[8], longer[8], t22[8], n2[8], t32[8], t36[8], t37[8],
            rate[8], sliding_y[8], sliding_x[8];
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
            const real square_turn = turn_x[j] * turn_x[j] + turn_y[j] * turn_y[j];
            t7[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * xi * t1;
            const real dp_vy = v[3 * 8 + j];
            const real t8 = xi * xi;
            t9[j] = l0 * t8 * t0;
            const real dq_vy = v[7 * 8 + j];
            t10[j] = dp_vy * n1[j] - dq_vy * t9[j];
            const real dp_vx = v[2 * 8 + j];
            const real dq_vx = v[6 * 8 + j];
            t11[j] = dp_vx * n1[j] - dq_vx * t9[j];
            handles_y[j] = dp_y * n1[j] - dq_y * t9[j];
            handles_x[j] = dp_x * n1[j] - dq_x * t9[j];
            t13[j] = dq_vx - dp_vx;
            t14[j] = dq_vy - dp_vy;
            t15[j] = turn_x[j] * t13[j] + turn_y[j] * t14[j];
            const real t20 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            longer[j] = 1.0 + square_turn * t20;
            t22[j] = t15[j] * t7[j];
            n2[j] = t8 * (3.0 - t2);
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[9 * 8 + j];
            const real d_y = p_y * n0[j] + handles_y[j] * longer[j] + q_y * n2[j] - c_y;
            const real r_vangle = v[10 * 8 + j];
            const real t28 = r_vangle * d_y;
            const real q_vx = v[4 * 8 + j];
            const real t29 = q_vx * n2[j];
            const real p_vx = v[0 * 8 + j];
            const real t30 = p_vx * n0[j];
            const real t31 = t11[j] * longer[j];
            const real c_vx = v[8 * 8 + j];
            t32[j] = t31 + 2.0 * handles_x[j] * t22[j] + t30 + t29 + t28 - c_vx;
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real t33 = p_vy * n0[j] + q_vy * n2[j];
            const real t34 = t10[j] * longer[j];
            const real c_vy = v[9 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real d_x = p_x * n0[j] + handles_x[j] * longer[j] + q_x * n2[j] - c_x;
            const real t35 = r_vangle * d_x;
            t36[j] = t34 + 2.0 * handles_y[j] * t22[j] + t33 - c_vy - t35;
            t37[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn;
            rate[j] = t37[j] * t15[j];
            sliding_y[j] = handles_y[j] * rate[j] + t34 + t33 - c_vy - t35;
            sliding_x[j] = handles_x[j] * rate[j] + t28 + t31 + t30 + t29 - c_vx;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t3[j]);
            sin_r[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_vangle = v[10 * 8 + j];
            const real t4 = r_vangle * cos_r[j];
            Phi_x[8 * 8 + j] = t4; /* Phi_x(0,8) */
            const real t5 = n0[j] * t4;
            Phi_x[12 * 8 + j] = t5; /* Phi_x(1,1) */
            Phi_x[0 * 8 + j] = -t5; /* Phi_x(0,0) */
            const real t6 = r_vangle * sin_r[j];
            Phi_x[9 * 8 + j] = Phi_x[19 * 8 + j] = t6; /* Phi_x(0,9) Phi_x(1,8) */
            Phi_x[1 * 8 + j] = Phi_x[11 * 8 + j] = -(n0[j] * t6); /* Phi_x(0,1) Phi_x(1,0) */
            const real t12 = t10[j] * cos_r[j] - t11[j] * sin_r[j] - handles_y[j] * t6;
            const real t16 = handles_y[j] * cos_r[j] - handles_x[j] * sin_r[j];
            const real t17 = t7[j] * (t12 - handles_x[j] * t4) + 0.009027777777777777 * (t15[j] * t16);
            const real t18 = t16 * t7[j];
            const real t19 = 2.0 * (turn_x[j] * t17 + t13[j] * t18);
            const real t21 = t4 * longer[j];
            const real t23 = t21 + 2.0 * sin_r[j] * t22[j];
            Phi_x[2 * 8 + j] = -(t19 + n1[j] * t23); /* Phi_x(0,2) */
            const real t24 = t6 * longer[j];
            const real t25 = 2.0 * cos_r[j] * t22[j] - t24;
            const real t26 = 2.0 * (turn_y[j] * t17 + t14[j] * t18);
            Phi_x[3 * 8 + j] = n1[j] * t25 - t26; /* Phi_x(0,3) */
            const real t27 = n2[j] * t4;
            Phi_x[16 * 8 + j] = t27; /* Phi_x(1,5) */
            Phi_x[4 * 8 + j] = -t27; /* Phi_x(0,4) */
            Phi_x[5 * 8 + j] = Phi_x[15 * 8 + j] = -(n2[j] * t6); /* Phi_x(0,5) Phi_x(1,4) */
            Phi_x[6 * 8 + j] = t19 + t9[j] * t23; /* Phi_x(0,6) */
            Phi_x[7 * 8 + j] = t26 - t9[j] * t25; /* Phi_x(0,7) */
            Phi_x[10 * 8 + j] = -(cos_r[j] * t32[j] + sin_r[j] * t36[j]); /* Phi_x(0,10) */
            const real t38 = rate[j] * cos_r[j] - t24;
            const real t39 = handles_y[j] * sin_r[j] + handles_x[j] * cos_r[j];
            const real t40 = t37[j] * t39;
            const real t41 = t10[j] * sin_r[j] + handles_y[j] * t4 + t11[j] * cos_r[j];
            const real t42 = 0.009027777777777777 * (t15[j] * t39) + t7[j] * (t41 - handles_x[j] * t6);
            const real t43 = t13[j] * t40 + 2.0 * turn_x[j] * t42;
            Phi_x[13 * 8 + j] = n1[j] * t38 - t43; /* Phi_x(1,2) */
            const real t44 = rate[j] * sin_r[j] + t21;
            const real t45 = t14[j] * t40 + 2.0 * turn_y[j] * t42;
            Phi_x[14 * 8 + j] = n1[j] * t44 - t45; /* Phi_x(1,3) */
            Phi_x[17 * 8 + j] = t43 - t9[j] * t38; /* Phi_x(1,6) */
            Phi_x[18 * 8 + j] = t45 - t9[j] * t44; /* Phi_x(1,7) */
            Phi_x[20 * 8 + j] = -t4; /* Phi_x(1,9) */
            Phi_x[21 * 8 + j] = cos_r[j] * sliding_y[j] - sin_r[j] * sliding_x[j]; /* Phi_x(1,10) */
        }
    }
}

/* kinematics: 424 operations.
 * in:  x (11), v (11), a (11), p (6)
 * out: Psi_x (2,11), Psi_v (2,11) */
FLEXEL_CLONES
static void planar_cable_line_kinematics(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict v = in[1] + b * (11 * 8);
        const real *restrict a = in[2] + b * (11 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict Psi_x = out[0] + b * (22 * 8);
        real *restrict Psi_v = out[1] + b * (22 * 8);
        real n0[8], t3[8], cos_r[8], sin_r[8], turn_x[8], turn_y[8], square_turn[8], t9[8], n1[8], t11[8],
            handles_y[8], handles_x[8], t14[8], t15[8], t16[8], t17[8], t21[8], t22[8], t25[8], t26[8], t30[8],
            t32[8], t38[8], longer[8], t41[8], n2[8], d_x[8], d_y[8], t59[8], t66[8], t67[8], t68[8], rate[8], t83[8],
            t84[8], t85[8], t87[8], t100[8], t101[8];
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
            t9[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn[j];
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * t1 * xi;
            const real t10 = xi * xi;
            t11[j] = l0 * t0 * t10;
            handles_y[j] = dp_y * n1[j] - dq_y * t11[j];
            handles_x[j] = dp_x * n1[j] - dq_x * t11[j];
            const real dq_ax = a[6 * 8 + j];
            const real dp_ax = a[2 * 8 + j];
            t14[j] = dq_ax - dp_ax;
            const real dq_vx = v[6 * 8 + j];
            const real dp_vx = v[2 * 8 + j];
            t15[j] = dq_vx - dp_vx;
            const real dp_vy = v[3 * 8 + j];
            const real dq_vy = v[7 * 8 + j];
            t16[j] = dp_vy * n1[j] - dq_vy * t11[j];
            t17[j] = dp_vx * n1[j] - dq_vx * t11[j];
            t21[j] = dq_vy - dp_vy;
            t22[j] = turn_x[j] * t15[j] + turn_y[j] * t21[j];
            const real dp_ay = a[3 * 8 + j];
            const real dq_ay = a[7 * 8 + j];
            t25[j] = dp_ay * n1[j] - dq_ay * t11[j];
            t26[j] = dp_ax * n1[j] - dq_ax * t11[j];
            const real t29 = t15[j] * t15[j] + t21[j] * t21[j];
            t30[j] = dq_ay - dp_ay;
            const real t31 = turn_x[j] * t14[j] + turn_y[j] * t30[j];
            t32[j] = t29 + t31;
            const real t36 = t22[j] * t22[j];
            const real t37 = 0.0045138888888888885 * (4.0 * t36 + 2.0 * square_turn[j] * t29);
            t38[j] = 0.041666666666666664 * t29 + t37 + 2.0 * t9[j] * t31;
            const real t39 = 0.020833333333333332 + 0.0022569444444444442 * square_turn[j];
            longer[j] = 1.0 + square_turn[j] * t39;
            t41[j] = t22[j] * t9[j];
            n2[j] = t10 * (3.0 - t2);
            const real p_x = x[0 * 8 + j];
            const real q_x = x[4 * 8 + j];
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0[j] + q_x * n2[j] + longer[j] * handles_x[j] - c_x;
            const real r_vangle = v[10 * 8 + j];
            const real t49 = r_vangle * d_x[j];
            const real t50 = longer[j] * t16[j];
            const real p_vy = v[1 * 8 + j];
            const real q_vy = v[5 * 8 + j];
            const real t51 = p_vy * n0[j] + q_vy * n2[j];
            const real c_vy = v[9 * 8 + j];
            const real t52 = t50 + t51 + 2.0 * handles_y[j] * t41[j] - c_vy;
            const real c_ax = a[8 * 8 + j];
            const real t53 = c_ax + r_vangle * (t49 - 2.0 * t52) - handles_x[j] * t38[j];
            const real t54 = t17[j] * t41[j];
            const real q_ax = a[4 * 8 + j];
            const real t55 = n2[j] * q_ax;
            const real p_ax = a[0 * 8 + j];
            const real t56 = n0[j] * p_ax;
            const real t57 = longer[j] * t26[j];
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0[j] + q_y * n2[j] + longer[j] * handles_y[j] - c_y;
            const real r_aangle = a[10 * 8 + j];
            const real t58 = r_aangle * d_y[j];
            t59[j] = t53 - 4.0 * t54 - t55 - t56 - t57 - t58;
            const real t60 = t16[j] * t41[j];
            const real p_ay = a[1 * 8 + j];
            const real q_ay = a[5 * 8 + j];
            const real t61 = n0[j] * p_ay + n2[j] * q_ay + longer[j] * t25[j];
            const real c_ay = a[9 * 8 + j];
            const real t62 = r_aangle * d_x[j];
            const real t63 = r_vangle * d_y[j];
            const real p_vx = v[0 * 8 + j];
            const real q_vx = v[4 * 8 + j];
            const real t64 = p_vx * n0[j] + q_vx * n2[j] + longer[j] * t17[j];
            const real c_vx = v[8 * 8 + j];
            const real t65 = t64 + 2.0 * handles_x[j] * t41[j] - c_vx;
            t66[j] = 4.0 * t60 + handles_y[j] * t38[j] + t61 - c_ay - t62 - r_vangle * (t63 + 2.0 * t65);
            t67[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn[j];
            t68[j] = 0.018055555555555554 * t36 + t67[j] * t32[j];
            rate[j] = t67[j] * t22[j];
            const real t82 = 2.0 * t60 + handles_y[j] * t68[j] + rate[j] * t16[j] + t61;
            const real sliding_x = rate[j] * handles_x[j] + t64 + t63 - c_vx;
            t83[j] = t65 + sliding_x;
            t84[j] = t82 - r_vangle * t83[j] - c_ay - t62;
            const real sliding_y = rate[j] * handles_y[j] + t51 + t50 - c_vy - t49;
            t85[j] = sliding_y + t52;
            const real t86 = r_vangle * t85[j] + handles_x[j] * t68[j] + 2.0 * t54 + rate[j] * t17[j];
            t87[j] = t55 + t86 + t56 + t57 + t58 - c_ax;
            t100[j] = t52 - t49;
            t101[j] = t63 + t65;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t3[j]);
            sin_r[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real r_aangle = a[10 * 8 + j];
            const real r_vangle = v[10 * 8 + j];
            const real t4 = r_vangle * sin_r[j];
            const real t5 = cos_r[j] * r_aangle - r_vangle * t4;
            Psi_x[8 * 8 + j] = t5; /* Psi_x(0,8) */
            const real t6 = n0[j] * t5;
            Psi_x[12 * 8 + j] = t6; /* Psi_x(1,1) */
            Psi_x[0 * 8 + j] = -t6; /* Psi_x(0,0) */
            const real t7 = r_vangle * cos_r[j];
            const real t8 = r_vangle * t7 + sin_r[j] * r_aangle;
            Psi_x[9 * 8 + j] = Psi_x[19 * 8 + j] = t8; /* Psi_x(0,9) Psi_x(1,8) */
            Psi_x[1 * 8 + j] = Psi_x[11 * 8 + j] = -(n0[j] * t8); /* Psi_x(0,1) Psi_x(1,0) */
            const real t12 = cos_r[j] * handles_y[j] - sin_r[j] * handles_x[j];
            const real t13 = t9[j] * t12;
            const real t18 = cos_r[j] * t16[j] - sin_r[j] * t17[j] - t4 * handles_y[j];
            const real t19 = t18 - t7 * handles_x[j];
            const real t20 = t9[j] * t19;
            const real t23 = t22[j] * t12;
            const real t24 = 2.0 * t20 + 0.018055555555555554 * t23;
            const real t27 = cos_r[j] * t25[j] - 2.0 * (t4 * t16[j] + t7 * t17[j]) - sin_r[j] * t26[j];
            const real t28 = t27 - handles_y[j] * t8 - handles_x[j] * t5;
            const real t33 = 4.0 * t22[j] * t19 + 2.0 * t12 * t32[j] + square_turn[j] * t28;
            const real t34 = 0.020833333333333332 * t28 + 0.0045138888888888885 * t33;
            const real t35 = 2.0 * (t13 * t14[j] + t15[j] * t24 + turn_x[j] * t34);
            const real t40 = longer[j] * t5;
            const real t42 = t7 * t41[j];
            const real t43 = t40 + 4.0 * t42 + sin_r[j] * t38[j];
            Psi_x[2 * 8 + j] = -(t35 + n1[j] * t43); /* Psi_x(0,2) */
            const real t44 = t4 * t41[j];
            const real t45 = longer[j] * t8;
            const real t46 = cos_r[j] * t38[j] - 4.0 * t44 - t45;
            const real t47 = 2.0 * (t13 * t30[j] + t21[j] * t24 + turn_y[j] * t34);
            Psi_x[3 * 8 + j] = n1[j] * t46 - t47; /* Psi_x(0,3) */
            const real t48 = n2[j] * t5;
            Psi_x[16 * 8 + j] = t48; /* Psi_x(1,5) */
            Psi_x[4 * 8 + j] = -t48; /* Psi_x(0,4) */
            Psi_x[5 * 8 + j] = Psi_x[15 * 8 + j] = -(n2[j] * t8); /* Psi_x(0,5) Psi_x(1,4) */
            Psi_x[6 * 8 + j] = t35 + t11[j] * t43; /* Psi_x(0,6) */
            Psi_x[7 * 8 + j] = t47 - t11[j] * t46; /* Psi_x(0,7) */
            Psi_x[10 * 8 + j] = cos_r[j] * t59[j] - sin_r[j] * t66[j]; /* Psi_x(0,10) */
            const real t69 = cos_r[j] * t68[j] - 2.0 * t44 - rate[j] * t4 - t45;
            const real t70 = sin_r[j] * handles_y[j] + cos_r[j] * handles_x[j];
            const real t71 = sin_r[j] * t16[j] + cos_r[j] * t17[j] + t7 * handles_y[j];
            const real t72 = t71 - t4 * handles_x[j];
            const real t73 = 0.009027777777777777 * (t70 * t32[j] + 2.0 * t22[j] * t72);
            const real t74 = 2.0 * (t7 * t16[j] - t4 * t17[j]) + sin_r[j] * t25[j] + cos_r[j] * t26[j];
            const real t75 = t73 + t9[j] * (handles_y[j] * t5 + t74 - handles_x[j] * t8);
            const real t76 = t67[j] * t70;
            const real t77 = t22[j] * t70;
            const real t78 = 0.018055555555555554 * t77 + t67[j] * t72 + 2.0 * (0.009027777777777777 * t77 + t9[j]
                * t72);
            const real t79 = t76 * t14[j] + t15[j] * t78 + 2.0 * turn_x[j] * t75;
            Psi_x[13 * 8 + j] = n1[j] * t69 - t79; /* Psi_x(1,2) */
            const real t80 = t40 + sin_r[j] * t68[j] + rate[j] * t7 + 2.0 * t42;
            const real t81 = t76 * t30[j] + t21[j] * t78 + 2.0 * turn_y[j] * t75;
            Psi_x[14 * 8 + j] = n1[j] * t80 - t81; /* Psi_x(1,3) */
            Psi_x[17 * 8 + j] = t79 - t11[j] * t69; /* Psi_x(1,6) */
            Psi_x[18 * 8 + j] = t81 - t11[j] * t80; /* Psi_x(1,7) */
            Psi_x[20 * 8 + j] = -t5; /* Psi_x(1,9) */
            Psi_x[21 * 8 + j] = cos_r[j] * t84[j] - sin_r[j] * t87[j]; /* Psi_x(1,10) */
            const real t88 = 2.0 * n0[j] * t7;
            Psi_v[12 * 8 + j] = t88; /* Psi_v(1,1) */
            Psi_v[0 * 8 + j] = -t88; /* Psi_v(0,0) */
            Psi_v[1 * 8 + j] = Psi_v[11 * 8 + j] = -(2.0 * n0[j] * t4); /* Psi_v(0,1) Psi_v(1,0) */
            const real t89 = t7 * longer[j];
            const real t90 = 2.0 * sin_r[j] * t41[j];
            const real t91 = t89 + t90;
            const real t92 = 0.009027777777777777 * t23 + t20;
            const real t93 = 2.0 * (t15[j] * t13 + turn_x[j] * t92);
            Psi_v[2 * 8 + j] = -(2.0 * (n1[j] * t91 + t93)); /* Psi_v(0,2) */
            const real t94 = 2.0 * cos_r[j] * t41[j];
            const real t95 = t4 * longer[j];
            const real t96 = t94 - t95;
            const real t97 = 2.0 * (t21[j] * t13 + turn_y[j] * t92);
            Psi_v[3 * 8 + j] = 2.0 * (n1[j] * t96 - t97); /* Psi_v(0,3) */
            const real t98 = 2.0 * n2[j] * t7;
            Psi_v[16 * 8 + j] = t98; /* Psi_v(1,5) */
            Psi_v[4 * 8 + j] = -t98; /* Psi_v(0,4) */
            Psi_v[5 * 8 + j] = Psi_v[15 * 8 + j] = -(2.0 * n2[j] * t4); /* Psi_v(0,5) Psi_v(1,4) */
            Psi_v[6 * 8 + j] = 2.0 * (t11[j] * t91 + t93); /* Psi_v(0,6) */
            Psi_v[7 * 8 + j] = 2.0 * (t97 - t11[j] * t96); /* Psi_v(0,7) */
            const real t99 = 2.0 * t7;
            Psi_v[8 * 8 + j] = t99; /* Psi_v(0,8) */
            Psi_v[9 * 8 + j] = Psi_v[19 * 8 + j] = 2.0 * t4; /* Psi_v(0,9) Psi_v(1,8) */
            Psi_v[10 * 8 + j] = -(2.0 * (sin_r[j] * t100[j] + cos_r[j] * t101[j])); /* Psi_v(0,10) */
            const real t102 = rate[j] * cos_r[j] + t94 - 2.0 * t95;
            const real t103 = 2.0 * t15[j] * t76 + turn_x[j] * t78;
            Psi_v[13 * 8 + j] = n1[j] * t102 - t103; /* Psi_v(1,2) */
            const real t104 = rate[j] * sin_r[j] + t90 + 2.0 * t89;
            const real t105 = 2.0 * t21[j] * t76 + turn_y[j] * t78;
            Psi_v[14 * 8 + j] = n1[j] * t104 - t105; /* Psi_v(1,3) */
            Psi_v[17 * 8 + j] = t103 - t11[j] * t102; /* Psi_v(1,6) */
            Psi_v[18 * 8 + j] = t105 - t11[j] * t104; /* Psi_v(1,7) */
            Psi_v[20 * 8 + j] = -t99; /* Psi_v(1,9) */
            Psi_v[21 * 8 + j] = cos_r[j] * t85[j] - sin_r[j] * t83[j] - t7 * d_x[j] - t4 * d_y[j]; /* Psi_v(1,10) */
        }
    }
}

/* stiffness: 258 operations.
 * in:  x (11), sigma (1), tau (1), p (6)
 * out: K (11,11), 37 of 121 entries */
FLEXEL_CLONES
static void planar_cable_line_stiffness(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict K = out[0] + b * (37 * 8);
        real n0[8], t3[8], cos_r[8], sin_r[8], n1[8], turn_x[8], turn_y[8], t9[8], t10[8], t11[8], t15[8],
            handles_y[8], handles_x[8], t21[8], t22[8], t25[8], t32[8], t38[8], t44[8], longer[8], n2[8], t91[8],
            t95[8], t97[8], t98[8], d_x[8], d_y[8];
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
            const real l0 = p[0 * 8 + j];
            n1[j] = l0 * xi * t1;
            const real dq_x = x[6 * 8 + j];
            const real dp_x = x[2 * 8 + j];
            turn_x[j] = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            turn_y[j] = dq_y - dp_y;
            t9[j] = turn_y[j] * turn_y[j];
            const real square_turn = turn_x[j] * turn_x[j] + t9[j];
            t10[j] = 0.020833333333333332 + 0.0045138888888888885 * square_turn;
            t11[j] = turn_x[j] * t10[j];
            const real t14 = xi * xi;
            t15[j] = l0 * t14 * t0;
            handles_y[j] = dp_y * n1[j] - dq_y * t15[j];
            handles_x[j] = dp_x * n1[j] - dq_x * t15[j];
            t21[j] = 0.041666666666666664 + 0.009027777777777777 * square_turn;
            t22[j] = turn_x[j] * t21[j];
            t25[j] = n1[j] * t21[j];
            t32[j] = turn_y[j] * t10[j];
            t38[j] = turn_y[j] * t21[j];
            t44[j] = t15[j] * t21[j];
            const real t55 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            longer[j] = 1.0 + square_turn * t55;
            n2[j] = t14 * (3.0 - t2);
            const real t89 = n1[j] * longer[j];
            const real t90 = handles_x[j] * t22[j];
            t91[j] = t89 - t90;
            const real t94 = handles_y[j] * t38[j];
            t95[j] = t89 - t94;
            const real t96 = t15[j] * longer[j];
            t97[j] = t90 - t96;
            t98[j] = t94 - t96;
            const real q_x = x[4 * 8 + j];
            const real p_x = x[0 * 8 + j];
            const real c_x = x[8 * 8 + j];
            d_x[j] = p_x * n0[j] + handles_x[j] * longer[j] + q_x * n2[j] - c_x;
            const real q_y = x[5 * 8 + j];
            const real p_y = x[1 * 8 + j];
            const real c_y = x[9 * 8 + j];
            d_y[j] = p_y * n0[j] + handles_y[j] * longer[j] + q_y * n2[j] - c_y;
        }
        for (size_t j = 0; j < 8; j++) {
            cos_r[j] = real_cos(t3[j]);
            sin_r[j] = real_sin(t3[j]);
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_gap = sigma[0 * 8 + j];
            const real t4 = cos_r[j] * sigma_gap;
            const real tau_tangential = tau[0 * 8 + j];
            const real t5 = sin_r[j] * tau_tangential;
            const real t6 = t4 + t5;
            K[24 * 8 + j] = K[34 * 8 + j] = t6; /* K(8,10) K(10,8) */
            const real p_fy = n0[j] * t6;
            K[0 * 8 + j] = K[26 * 8 + j] = -p_fy; /* K(0,10) K(10,0) */
            const real t7 = sin_r[j] * sigma_gap;
            const real t8 = cos_r[j] * tau_tangential;
            const real c_fx = t7 - t8;
            K[25 * 8 + j] = K[35 * 8 + j] = c_fx; /* K(9,10) K(10,9) */
            K[1 * 8 + j] = K[27 * 8 + j] = -(n0[j] * c_fx); /* K(1,10) K(10,1) */
            const real t12 = t11[j] * t7;
            const real t13 = 2.0 * n1[j] * t12;
            const real t16 = handles_y[j] * t4 - handles_x[j] * t7;
            const real t17 = turn_x[j] * t16;
            const real t18 = 2.0 * t10[j] * t16;
            const real t19 = 0.018055555555555554 * (turn_x[j] * t17) + t18;
            const real t20 = t13 + t19;
            const real t23 = t22[j] * t8;
            const real t24 = n1[j] * t23;
            const real t26 = handles_y[j] * t5 + handles_x[j] * t8;
            const real t27 = 0.018055555555555554 * (turn_x[j] * t26);
            const real t28 = t8 * t25[j] - t27;
            const real t29 = t21[j] * t26;
            const real t30 = turn_x[j] * t28 - t29;
            K[2 * 8 + j] = t13 + t20 - t24 - t30; /* K(2,2) */
            const real t31 = 0.018055555555555554 * (turn_y[j] * t17);
            const real t33 = t32[j] * t7;
            const real t34 = t31 + 2.0 * n1[j] * t33;
            const real t35 = t11[j] * t4;
            const real t36 = 2.0 * n1[j] * t35;
            const real t37 = t34 - t36;
            const real t39 = t38[j] * t8;
            const real t40 = n1[j] * t39;
            const real t41 = 0.018055555555555554 * (turn_y[j] * t26);
            const real t42 = t5 * t25[j] - t41;
            const real t43 = turn_x[j] * t42;
            K[3 * 8 + j] = t37 - t40 - t43; /* K(2,3) */
            const real t45 = t27 - t8 * t44[j];
            const real t46 = t29 + turn_x[j] * t45;
            const real t47 = 2.0 * t15[j] * t12;
            const real t48 = t47 + t20;
            K[4 * 8 + j] = t24 - t46 - t48; /* K(2,6) */
            const real t49 = 2.0 * t15[j] * t35;
            const real t50 = t49 - t34;
            const real t51 = t41 - t5 * t44[j];
            const real t52 = turn_x[j] * t51;
            K[5 * 8 + j] = t50 + t40 - t52; /* K(2,7) */
            const real t53 = handles_y[j] * t7 + handles_x[j] * t4;
            const real t54 = 2.0 * t11[j] * t53;
            const real t56 = longer[j] * t4;
            const real t57 = t54 - n1[j] * t56;
            const real t58 = longer[j] * t5;
            const real t59 = t21[j] * (handles_y[j] * t8 - handles_x[j] * t5);
            const real t60 = turn_x[j] * t59;
            K[6 * 8 + j] = t57 - n1[j] * t58 - t60; /* K(2,10) */
            const real t61 = t22[j] * t5;
            const real t62 = n1[j] * t61;
            const real t63 = turn_y[j] * t28;
            K[7 * 8 + j] = t37 - t62 - t63; /* K(3,2) */
            const real t64 = t32[j] * t4;
            const real t65 = 2.0 * n1[j] * t64;
            const real t66 = t18 + 0.018055555555555554 * (t9[j] * t16);
            const real t67 = t65 - t66;
            const real t68 = t38[j] * t5;
            const real t69 = n1[j] * t68;
            const real t70 = turn_y[j] * t42 - t29;
            K[8 * 8 + j] = -(t69 + t70 + t65 + t67); /* K(3,3) */
            const real t71 = 2.0 * t15[j] * t33;
            const real t72 = t36 - t31 - t71;
            const real t73 = turn_y[j] * t45;
            K[9 * 8 + j] = t72 + t62 - t73; /* K(3,6) */
            const real t74 = 2.0 * t15[j] * t64;
            const real t75 = t74 + t67;
            const real t76 = t29 + turn_y[j] * t51;
            K[10 * 8 + j] = t69 + t75 - t76; /* K(3,7) */
            const real t77 = 2.0 * t32[j] * t53;
            const real t78 = longer[j] * t7;
            const real t79 = t77 - n1[j] * t78;
            const real t80 = longer[j] * t8;
            const real t81 = turn_y[j] * t59;
            K[11 * 8 + j] = t79 + n1[j] * t80 - t81; /* K(3,10) */
            const real q_fy = n2[j] * t6;
            K[12 * 8 + j] = K[30 * 8 + j] = -q_fy; /* K(4,10) K(10,4) */
            K[13 * 8 + j] = K[31 * 8 + j] = -(n2[j] * c_fx); /* K(5,10) K(10,5) */
            const real t82 = t15[j] * t23;
            K[14 * 8 + j] = t82 + t30 - t48; /* K(6,2) */
            const real t83 = t15[j] * t39;
            K[15 * 8 + j] = t72 + t43 + t83; /* K(6,3) */
            K[16 * 8 + j] = t47 + t46 + t19 + t47 - t82; /* K(6,6) */
            const real t84 = t31 + t71 - t49;
            K[17 * 8 + j] = t84 + t52 - t83; /* K(6,7) */
            const real t85 = t15[j] * t56 - t54;
            K[18 * 8 + j] = t60 + t85 + t15[j] * t58; /* K(6,10) */
            const real t86 = t15[j] * t61;
            K[19 * 8 + j] = t50 + t63 + t86; /* K(7,2) */
            const real t87 = t15[j] * t68;
            K[20 * 8 + j] = t75 + t70 + t87; /* K(7,3) */
            K[21 * 8 + j] = t84 + t73 - t86; /* K(7,6) */
            K[22 * 8 + j] = t66 + t76 - t74 - t74 - t87; /* K(7,7) */
            const real t88 = t15[j] * t78 - t77;
            K[23 * 8 + j] = t81 + t88 - t15[j] * t80; /* K(7,10) */
            const real t92 = handles_y[j] * t23;
            K[28 * 8 + j] = t57 - t5 * t91[j] - t92; /* K(10,2) */
            const real t93 = handles_x[j] * t68;
            K[29 * 8 + j] = t79 + t8 * t95[j] + t93; /* K(10,3) */
            K[32 * 8 + j] = t85 + t92 - t5 * t97[j]; /* K(10,6) */
            K[33 * 8 + j] = t88 + t8 * t98[j] - t93; /* K(10,7) */
            const real t99 = d_y[j] * t5 + sigma_gap * (cos_r[j] * d_y[j] - sin_r[j] * d_x[j]);
            K[36 * 8 + j] = -(d_x[j] * t8 + t99); /* K(10,10) */
        }
    }
}

/* outputs: 61 operations.
 * in:  x (11), sigma (1), tau (1), p (6)
 * out: place (2), force (2), origin (2), axes (2,2) */
FLEXEL_CLONES
static void planar_cable_line_outputs(size_t nblocks, const real *const *in, real *const *out)
{
    for (size_t b = 0; b < nblocks; b++) {
        const real *restrict x = in[0] + b * (11 * 8);
        const real *restrict sigma = in[1] + b * (1 * 8);
        const real *restrict tau = in[2] + b * (1 * 8);
        const real *restrict p = in[3] + b * (6 * 8);
        real *restrict place = out[0] + b * (2 * 8);
        real *restrict force = out[1] + b * (2 * 8);
        real *restrict origin = out[2] + b * (2 * 8);
        real *restrict axes = out[3] + b * (4 * 8);
        real n0[8], n2[8], t6[8], sin_r[8], cos_r[8], t7[8];
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real xi = p[1 * 8 + j];
            const real t0 = 1.0 - xi;
            const real t1 = t0 * t0;
            const real t2 = 2.0 * xi;
            n0[j] = t1 * (1.0 + t2);
            const real p_x = x[0 * 8 + j];
            const real t3 = xi * xi;
            n2[j] = t3 * (3.0 - t2);
            const real q_x = x[4 * 8 + j];
            const real l0 = p[0 * 8 + j];
            const real n1 = l0 * xi * t1;
            const real dp_x = x[2 * 8 + j];
            const real t4 = l0 * t3 * t0;
            const real dq_x = x[6 * 8 + j];
            const real handles_x = dp_x * n1 - dq_x * t4;
            const real turn_x = dq_x - dp_x;
            const real dq_y = x[7 * 8 + j];
            const real dp_y = x[3 * 8 + j];
            const real turn_y = dq_y - dp_y;
            const real square_turn = turn_x * turn_x + turn_y * turn_y;
            const real t5 = 0.020833333333333332 + 0.0022569444444444442 * square_turn;
            const real longer = 1.0 + square_turn * t5;
            place[0 * 8 + j] = p_x * n0[j] + q_x * n2[j] + handles_x * longer;
            const real p_y = x[1 * 8 + j];
            const real q_y = x[5 * 8 + j];
            const real handles_y = dp_y * n1 - dq_y * t4;
            place[1 * 8 + j] = p_y * n0[j] + q_y * n2[j] + handles_y * longer;
            const real r_angle = x[10 * 8 + j];
            const real alpha0 = p[2 * 8 + j];
            t6[j] = r_angle + alpha0;
            t7[j] = n0[j] + n2[j];
        }
        for (size_t j = 0; j < 8; j++) {
            sin_r[j] = real_sin(t6[j]);
            axes[1 * 8 + j] = sin_r[j]; /* axes(0,1) */
            cos_r[j] = real_cos(t6[j]);
            axes[0 * 8 + j] = axes[3 * 8 + j] = cos_r[j]; /* axes(0,0) axes(1,1) */
        }
#pragma omp simd
        for (size_t j = 0; j < 8; j++) {
            const real sigma_gap = sigma[0 * 8 + j];
            const real tau_tangential = tau[0 * 8 + j];
            const real c_fx = sin_r[j] * sigma_gap - cos_r[j] * tau_tangential;
            force[0 * 8 + j] = c_fx * t7[j];
            const real t8 = cos_r[j] * sigma_gap + sin_r[j] * tau_tangential;
            const real p_fy = n0[j] * t8;
            const real q_fy = n2[j] * t8;
            force[1 * 8 + j] = -(p_fy + q_fy);
            const real offset_x = p[3 * 8 + j];
            const real c_x = x[8 * 8 + j];
            const real offset_y = p[4 * 8 + j];
            origin[0 * 8 + j] = c_x + offset_x * cos_r[j] - offset_y * sin_r[j];
            const real c_y = x[9 * 8 + j];
            origin[1 * 8 + j] = c_y + offset_x * sin_r[j] + offset_y * cos_r[j];
            axes[2 * 8 + j] = -sin_r[j]; /* axes(1,0) */
        }
    }
}

const flexel_element flexel_planar_cable_line = {
    .name = "planar_cable_line",
    .digest = "26dd4499ad052791",
    .n = 11,
    .m = 1,
    .k = 1,
    .np = 6,
    .position = planar_cable_line_position,
    .acceleration = planar_cable_line_acceleration,
    .rates = planar_cable_line_rates,
    .kinematics = planar_cable_line_kinematics,
    .stiffness = planar_cable_line_stiffness,
    .outputs = planar_cable_line_outputs,
};
