//! The pages on which machines are dragged.

use linkage_core::sketch::{Page, Paged, SketchError};

use crate::declarations::{
    andrews_squeezer, calibration, cart, computed_torque, counterweight, crane,
    crank_rocker_slider, crank_rpp, dead_point, driving_torque, electronic_cam, excavator,
    five_bar_robot, flying_shear, four_bar, function_generator, jansen_leg, parallelograms,
    press_friction, range, run_up, scissor_lift, set_point, shear_bearings, six_bar,
    six_bar_reactions, slider_crank, stick_slip, suspension, toggle_clamp, transplanter, vibration,
    whitworth,
};
use crate::motions::digging;

/// The page of every machine, by the example and the struct.
///
/// # Errors
/// The first page that fails.
pub fn pages() -> Result<Vec<(&'static str, String)>, SketchError> {
    let pages = [four_bars(), sliders(), larger(), of_several_inputs(), under_forces()];
    pages.into_iter().flatten().map(|(name, page)| Ok((name, page?))).collect()
}

type Named = (&'static str, Result<String, SketchError>);

/// The machine on a page of its own, as far as nothing is said about it.
fn plain<S: Paged>(name: &'static str, page: Page<S>) -> Named {
    (name, page.to_html())
}

fn four_bars() -> Vec<Named> {
    vec![
        (
            "flying_shear::FlyingShear",
            flying_shear::FlyingShear::new().page().rate("theta", 12.0).to_html(),
        ),
        plain("four_bar::FourBar", four_bar::FourBar::new().page()),
        (
            "range::FourBar",
            range::FourBar { base: 0.39 }.page().range("base", 0.25..=0.45).to_html(),
        ),
        plain("electronic_cam::FlyingShear", electronic_cam::FlyingShear::new().page()),
        plain(
            "function_generator::FunctionGenerator",
            function_generator::FunctionGenerator::new().page(),
        ),
        plain("function_generator::Transmission", function_generator::Transmission::new().page()),
        plain("dead_point::ByLeft", dead_point::ByLeft::new().page()),
        plain("dead_point::ByRight", dead_point::ByRight::new().page()),
        plain("run_up::FourBar", run_up::FourBar::new().page()),
        plain("counterweight::FourBar", counterweight::FourBar::new().page()),
    ]
}

fn sliders() -> Vec<Named> {
    vec![
        plain("slider_crank::OffsetSliderCrank", slider_crank::OffsetSliderCrank::new().page()),
        plain(
            "crank_rocker_slider::CrankRockerSlider",
            crank_rocker_slider::CrankRockerSlider::new().page(),
        ),
        plain("crank_rpp::CrankYoke", crank_rpp::CrankYoke::new().page()),
        plain("whitworth::Shaper", whitworth::Shaper::new().page()),
        plain("whitworth::Whitworth", whitworth::Whitworth::new().page()),
        plain("range::Shaper", range::Shaper::new().page()),
        ("set_point::Press", set_point::Press::new().page().range("x", 0.18..=0.33).to_html()),
    ]
}

fn larger() -> Vec<Named> {
    vec![
        plain("six_bar::SixBar", six_bar::SixBar::new().page()),
        (
            "jansen_leg::JansenLeg",
            jansen_leg::JansenLeg::new().page().rate("theta", -6.0).to_html(),
        ),
        plain("calibration::SixBar", calibration::SixBar::new().page()),
        (
            "suspension::ByTheArm",
            suspension::ByTheArm::new().page().range("theta", -0.3..=0.4).to_html(),
        ),
        (
            "suspension::ByTheWheel",
            suspension::ByTheWheel::new().page().range("z", 0.2..=0.45).to_html(),
        ),
        plain("cart::Steering", cart::Steering::new().page()),
    ]
}

fn of_several_inputs() -> Vec<Named> {
    vec![
        ("excavator::Excavator", excavator::Excavator::new().page().path(digging()).to_html()),
        plain("five_bar_robot::Forward", five_bar_robot::Forward::new().page()),
        (
            "five_bar_robot::Inverse",
            five_bar_robot::Inverse::new()
                .page()
                .range("x", -0.2..=0.2)
                .range("y", 0.1..=0.45)
                .to_html(),
        ),
        plain("transplanter::Transplanter", transplanter::Transplanter::new().page()),
        plain("computed_torque::Robot", computed_torque::Robot::new().page()),
        (
            "computed_torque::Arms",
            computed_torque::Arms::new()
                .page()
                .range("x", -0.2..=0.2)
                .range("y", 0.1..=0.45)
                .to_html(),
        ),
        ("crane::Crane", crane::Crane::new().page().range("x", 0.0..=4.0).to_html()),
    ]
}

fn under_forces() -> Vec<Named> {
    vec![
        plain("driving_torque::FourBar", driving_torque::FourBar::new().page()),
        plain("driving_torque::AsInTheText", driving_torque::AsInTheText::new().page()),
        (
            "press_friction::CutPress",
            press_friction::CutPress::new()
                .page()
                .curves(["theta.drive", "ram", "losses"])
                .load("cut", 2e4)
                .to_html(),
        ),
        (
            "toggle_clamp::ToggleClamp",
            toggle_clamp::ToggleClamp::new()
                .page()
                .range("handle", -0.3..=0.9)
                .curves(["handle.drive", "jaw"])
                .load("clamping", 2e3)
                .to_html(),
        ),
        (
            "scissor_lift::ScissorLift",
            scissor_lift::ScissorLift::new()
                .page()
                .range("span", 0.6..=1.18)
                .curves(["span.drive", "raising", "lowering"])
                .load("weight", 8e3)
                .to_html(),
        ),
        (
            "shear_bearings::FlyingShear",
            shear_bearings::FlyingShear::new().page().load("cut", 1e4).to_html(),
        ),
        plain("six_bar_reactions::SixBar", six_bar_reactions::SixBar::new().page()),
        plain("andrews_squeezer::Squeezer", andrews_squeezer::Squeezer::new().page()),
        plain("parallelograms::TwoParallelograms", parallelograms::TwoParallelograms::new().page()),
        (
            "stick_slip::DryBlock",
            stick_slip::DryBlock::new().page().range("x", -0.1..=0.1).to_html(),
        ),
        (
            "stick_slip::CreepingBlock",
            stick_slip::CreepingBlock::new().page().range("x", -0.1..=0.1).to_html(),
        ),
        (
            "vibration::Oscillator",
            vibration::Oscillator::new().page().range("x", -0.3..=0.3).to_html(),
        ),
        (
            "vibration::TwoMasses",
            vibration::TwoMasses::new()
                .page()
                .range("x", -0.3..=0.3)
                .range("y", -0.3..=0.3)
                .to_html(),
        ),
    ]
}
