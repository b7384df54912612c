//! Equations of motion over slices: what single calls give, at every pose.

use std::f64::consts::FRAC_PI_2;

use linkage_core::{Series, Status, unwanted};
use linkage_tests::mechanisms::dynamics::{GearedArm, GearedArmInput, RockerDriven};
use linkage_tests::mechanisms::forces::{
    HeavyFourBar, Press, PressEquations, PressLoads, SprungLift,
};

/// As many poses as fill two blocks and a part of the third.
const POSES: usize = 37;

fn along(from: f64, by: f64) -> [f64; POSES] {
    core::array::from_fn(|pose| from + by * pose as f64)
}

/// A sweep may fuse where a single call does not.
#[track_caller]
fn same(found: f64, single: f64) {
    assert!((found - single).abs() <= 1e-11 * single.abs().max(1.0), "{found} {single}");
}

#[test]
fn one_input() {
    let machine = HeavyFourBar::new();
    let (q, dq, drive) = (along(0.0, 0.17), along(-9.0, 0.5), along(-0.2, 0.01));
    let (mut found, mut status) = ([0.0; POSES], [Status::Singular; POSES]);
    machine.sweep_forward_dynamics(&q, &dq, &drive, &mut found, &mut status, ()).unwrap();
    for pose in 0..POSES {
        same(found[pose], machine.forward_dynamics(q[pose], dq[pose], drive[pose]).unwrap());
    }
    assert_eq!(status, [Status::Solved; POSES]);
    // One number for all poses, and the other width.
    let narrow = HeavyFourBar::<f32>::default();
    let (q, mut found) = (q.map(|q| q as f32), [0.0_f32; POSES]);
    narrow.sweep_forward_dynamics(&q, 2.0, 0.1, &mut found, &mut [], ()).unwrap();
    for (q, found) in q.into_iter().zip(found) {
        let single = narrow.forward_dynamics(q, 2.0, 0.1).unwrap();
        assert!((found - single).abs() < 2e-4 * single.abs().max(1.0), "{found} {single}");
    }
    let refused = narrow.sweep_forward_dynamics(&q, 2.0, 0.1, &mut found[1..], &mut [], ());
    assert_eq!(refused.unwrap_err().found, POSES - 1);
}

#[test]
fn several_inputs_and_a_list_of_drives() {
    let lift = SprungLift::new();
    let (reach, drive) = (along(0.75, 0.01), along(-400.0, 25.0));
    let inputs = [Series::Each(&reach), Series::Constant(0.4)];
    let drives = [(&drive).into(), 30.0.into()];
    let [mut lifting, mut tilting] = [[0.0; POSES]; 2];
    let rates = [Series::Constant(0.3), Series::Constant(-1.0)];
    lift.sweep_forward_dynamics(inputs, rates, drives, [&mut lifting, &mut tilting], &mut [], ())
        .unwrap();
    for pose in 0..POSES {
        let single = lift.forward_dynamics([reach[pose], 0.4], [0.3, -1.0], [drive[pose], 30.0]);
        let single = single.unwrap();
        same(lifting[pose], single[0]);
        same(tilting[pose], single[1]);
    }
    // The sweep writes the acceleration of the last of three inputs only.
    let arm = GearedArm::new();
    let (motor, mut last) = (along(0.0, 0.3), [0.0; POSES]);
    let inputs = GearedArmInput {
        base: Series::Constant(0.0),
        shoulder: Series::Constant(0.5),
        motor: Series::Each(&motor),
    };
    let still = [Series::Constant(0.0); 3];
    let push = [1.0, 2.0, 3.0].map(Series::Constant);
    arm.sweep_forward_dynamics(inputs, still, push, [&mut [], &mut [], &mut last], &mut [], ())
        .unwrap();
    for pose in 0..POSES {
        let single = arm.forward_dynamics([0.0, 0.5, motor[pose]], [0.0; 3], [1.0, 2.0, 3.0]);
        same(last[pose], single.unwrap()[2]);
    }
}

#[test]
fn loads_and_the_equations_themselves() {
    let press = Press::new();
    let (q, work) = (along(0.0, 0.17), along(0.0, 20.0));
    let loads = || PressLoads { work: Series::Each(&work), friction: Series::Constant(2.5) };
    let [mut ddq, mut mass, mut force] = [[0.0; POSES]; 3];
    press.sweep_forward_dynamics(&q, 3.0, 5.0, loads(), &mut ddq, &mut [], ()).unwrap();
    let out = PressEquations { mass: [[&mut mass[..]]], ..unwanted() };
    press.sweep_equations_of_motion(&q, 3.0, loads(), out, &mut [], ()).unwrap();
    let out = PressEquations { force: [&mut force[..]], ..unwanted() };
    press.sweep_equations_of_motion(&q, 3.0, loads(), out, &mut [], ()).unwrap();
    for pose in 0..POSES {
        let loads = [work[pose], 2.5];
        same(ddq[pose], press.forward_dynamics(q[pose], 3.0, 5.0, loads).unwrap());
        let single = press.equations_of_motion(q[pose], 3.0, loads).unwrap();
        same(mass[pose], single.mass[0][0]);
        same(force[pose], single.force[0]);
        same(ddq[pose] * mass[pose], force[pose] + 5.0);
    }
}

#[test]
fn what_a_single_call_refuses_is_not_a_number() {
    let machine = RockerDriven::new();
    let mut q = along(0.4, 0.03);
    (q[5], q[20], q[30], q[36]) = (FRAC_PI_2, f64::NAN, 1.6, FRAC_PI_2);
    let (mut found, mut status) = ([0.0; POSES], [Status::Solved; POSES]);
    machine.sweep_forward_dynamics(&q, 1.0, 0.5, &mut found, &mut status, ()).unwrap();
    for pose in 0..POSES {
        let expected = machine.forward_dynamics(q[pose], 1.0, 0.5);
        assert_eq!(found[pose].is_nan(), expected.is_err(), "{pose}");
        assert_eq!(status[pose], expected.map_or_else(Status::from, |_| Status::Solved));
    }
    let kinds = [Status::Singular, Status::NotFinite, Status::OutOfReach, Status::Singular];
    assert_eq!([5, 20, 30, 36].map(|pose| status[pose]), kinds);
    let (mut found, mut status) = ([0.0; POSES], [Status::Solved; POSES]);
    let drive = along(f64::INFINITY, 0.0);
    machine.sweep_forward_dynamics(0.5, 1.0, &drive, &mut found, &mut status, ()).unwrap();
    assert_eq!(status, [Status::NotFinite; POSES]);
}
