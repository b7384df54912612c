//! The squeezer as the test set has it, with its 27 equations differentiated to index 1: seven angles,
//! their rates, and at each evaluation 13 × 13 linear equations for accelerations and multipliers.
//!
//! Formulas and names are those of the test set's `andrews.f`. The loops are equations of accelerations
//! here, so that rounding and the integrator's error open them with time.

use dynamics::{Motion, Run, Stopped};
use linkage_core::SolveError;
use nalgebra::{SMatrix, SVector};

use crate::{END, TORQUE, truth};

const M: [f64; 7] = [0.043_25, 0.003_65, 0.023_73, 0.007_06, 0.070_50, 0.007_06, 0.054_98];
const I: [f64; 7] = [2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5];
const XA: f64 = -0.069_34;
const YA: f64 = -0.002_27;
const XB: f64 = -0.036_35;
const YB: f64 = 0.032_73;
const XC: f64 = 0.014;
const YC: f64 = 0.072;
const C0: f64 = 4530.0;
const L0: f64 = 0.077_85;
const D: f64 = 28e-3;
const DA: f64 = 11.5e-3;
const E: f64 = 20e-3;
const EA: f64 = 14.21e-3;
const RR: f64 = 7e-3;
const RA: f64 = 0.92e-3;
const SS: f64 = 35e-3;
const SA: f64 = 18.74e-3;
const SB: f64 = 10.43e-3;
const SC: f64 = 18e-3;
const SD: f64 = 20e-3;
const TA: f64 = 23.08e-3;
const TB: f64 = 9.16e-3;
const U: f64 = 40e-3;
const UA: f64 = 12.28e-3;
const UB: f64 = 4.49e-3;
const ZF: f64 = 20e-3;
const ZT: f64 = 40e-3;
const FA: f64 = 14.21e-3;

/// From the mass to the far pin on K4 and on K6.
const K: f64 = E - EA;
const H: f64 = ZF - FA;

pub(crate) fn run(tolerance: f64) -> Result<Run<14>, Stopped> {
    let mut start = [0.0; 14];
    start[..7].copy_from_slice(&truth::START);
    let rates = |_: f64, state: [f64; 14]| {
        let seconds = accelerations(state)?;
        let mut rates = [0.0; 14];
        rates[..7].copy_from_slice(&state[7..]);
        rates[7..].copy_from_slice(&seconds[..7]);
        Ok(rates)
    };
    Motion::new([0.0, END], start, rates).tolerance(tolerance).ended()
}

/// The test set's 27 numbers. Its multipliers are the forces on K3, K4 and K6 at P.
pub(crate) fn test_set_row(state: [f64; 14]) -> Result<[f64; 27], SolveError> {
    let mut row = [0.0; 27];
    row[..14].copy_from_slice(&state);
    row[14..].copy_from_slice(&accelerations(state)?);
    Ok(row)
}

/// The largest gap, of three loops, between the ends that make up P, in m.
pub(crate) fn open([be, th, ga, ph, de, om, ep]: [f64; 7]) -> f64 {
    let x = RR * be.cos() - D * (be + th).cos();
    let y = RR * be.sin() - D * (be + th).sin();
    let others = [
        [SS * ga.sin() + XB, -SS * ga.cos() + YB],
        [E * (ph + de).sin() + ZT * de.cos() + XA, -E * (ph + de).cos() + ZT * de.sin() + YA],
        [ZF * (om + ep).cos() + U * ep.sin() + XA, ZF * (om + ep).sin() - U * ep.cos() + YA],
    ];
    others.into_iter().map(|[u, v]| (x - u).hypot(y - v)).fold(0.0, f64::max)
}

/// Seven accelerations and six multipliers.
fn accelerations(state: [f64; 14]) -> Result<[f64; 13], SolveError> {
    let (q, v) = state.split_at(7);
    let (q, v): ([f64; 7], [f64; 7]) =
        (q.try_into().unwrap_or_default(), v.try_into().unwrap_or_default());
    let (masses, loops) = (mass_matrix(q), loops(q));
    let mut matrix = SMatrix::<f64, 13, 13>::zeros();
    matrix.fixed_view_mut::<7, 7>(0, 0).copy_from(&masses);
    matrix.fixed_view_mut::<6, 7>(7, 0).copy_from(&loops);
    matrix.fixed_view_mut::<7, 6>(0, 7).copy_from(&loops.transpose());
    let mut right = SVector::<f64, 13>::zeros();
    right.fixed_rows_mut::<7>(0).copy_from(&forces(q, v));
    right.fixed_rows_mut::<6>(7).copy_from(&-convective(q, v));
    let solved = matrix.lu().solve(&right);
    solved.map(Into::into).ok_or(SolveError::Singular { group: "index-1 form" })
}

fn mass_matrix([_, th, _, ph, _, om, _]: [f64; 7]) -> SMatrix<f64, 7, 7> {
    let mut m = SMatrix::zeros();
    m[(1, 1)] = M[1] * DA * DA + I[1];
    m[(0, 1)] = m[(1, 1)] - M[1] * DA * RR * th.cos();
    m[(1, 0)] = m[(0, 1)];
    let turning = M[1] * (RR * RR - 2.0 * DA * RR * th.cos() + DA * DA);
    m[(0, 0)] = M[0] * RA * RA + turning + I[0] + I[1];
    m[(2, 2)] = M[2] * (SA * SA + SB * SB) + I[2];
    m[(3, 3)] = M[3] * K * K + I[3];
    m[(3, 4)] = m[(3, 3)] + M[3] * ZT * K * ph.sin();
    m[(4, 3)] = m[(3, 4)];
    let turning = M[3] * (ZT * ZT + 2.0 * ZT * K * ph.sin() + K * K);
    m[(4, 4)] = turning + M[4] * (TA * TA + TB * TB) + I[3] + I[4];
    m[(5, 5)] = M[5] * H * H + I[5];
    m[(5, 6)] = m[(5, 5)] - M[5] * U * H * om.sin();
    m[(6, 5)] = m[(5, 6)];
    let turning = M[5] * (H * H - 2.0 * U * H * om.sin() + U * U);
    m[(6, 6)] = turning + M[6] * (UA * UA + UB * UB) + I[5] + I[6];
    m
}

fn forces([_, th, ga, ph, _, om, _]: [f64; 7], v: [f64; 7]) -> SVector<f64, 7> {
    let [be, thp, _, php, de, omp, ep] = v;
    let (sin, cos) = ga.sin_cos();
    let [x, y] = [SD * cos + SC * sin + XB - XC, SD * sin - SC * cos + YB - YC];
    let length = x.hypot(y);
    let force = -C0 * (length - L0) / length;
    let [fx, fy] = [force * x, force * y];
    [
        TORQUE - M[1] * DA * RR * thp * (thp + 2.0 * be) * th.sin(),
        M[1] * DA * RR * be * be * th.sin(),
        fx * (SC * cos - SD * sin) + fy * (SD * cos + SC * sin),
        M[3] * ZT * K * de * de * ph.cos(),
        -M[3] * ZT * K * php * (php + 2.0 * de) * ph.cos(),
        -M[5] * U * H * ep * ep * om.cos(),
        M[5] * U * H * omp * (omp + 2.0 * ep) * om.cos(),
    ]
    .into()
}

/// Derivatives of the loops by the angles.
fn loops([be, th, ga, ph, de, om, ep]: [f64; 7]) -> SMatrix<f64, 6, 7> {
    let (bt, pd, oe) = (be + th, ph + de, om + ep);
    let [x, y] = [-RR * be.sin() + D * bt.sin(), RR * be.cos() - D * bt.cos()];
    let mut g = SMatrix::zeros();
    for row in [0, 2, 4] {
        g[(row, 0)] = x;
        g[(row, 1)] = D * bt.sin();
        g[(row + 1, 0)] = y;
        g[(row + 1, 1)] = -D * bt.cos();
    }
    g[(0, 2)] = -SS * ga.cos();
    g[(1, 2)] = -SS * ga.sin();
    g[(2, 3)] = -E * pd.cos();
    g[(2, 4)] = -E * pd.cos() + ZT * de.sin();
    g[(3, 3)] = -E * pd.sin();
    g[(3, 4)] = -E * pd.sin() - ZT * de.cos();
    g[(4, 5)] = ZF * oe.sin();
    g[(4, 6)] = ZF * oe.sin() - U * ep.cos();
    g[(5, 5)] = -ZF * oe.cos();
    g[(5, 6)] = -ZF * oe.cos() - U * ep.sin();
    g
}

/// Accelerations of the loops at no accelerations.
fn convective([be, th, ga, ph, de, om, ep]: [f64; 7], v: [f64; 7]) -> SVector<f64, 6> {
    let [bp, thp, gp, php, dp, omp, epp] = v;
    let (bt, pd, oe) = (be + th, ph + de, om + ep);
    let [b, p, o] = [bp + thp, php + dp, omp + epp].map(|rate| rate * rate);
    let x = -RR * be.cos() * bp * bp + D * bt.cos() * b;
    let y = -RR * be.sin() * bp * bp + D * bt.sin() * b;
    [
        x + SS * ga.sin() * gp * gp,
        y - SS * ga.cos() * gp * gp,
        x + E * pd.sin() * p + ZT * de.cos() * dp * dp,
        y - E * pd.cos() * p + ZT * de.sin() * dp * dp,
        x + ZF * oe.cos() * o + U * ep.sin() * epp * epp,
        y + ZF * oe.sin() * o - U * ep.cos() * epp * epp,
    ]
    .into()
}
