//! The motion of every mechanism.

mod forced;

use std::f64::consts::{PI, TAU};

use linkage_core::sketch::Film;

use crate::declarations::{
    calibration, crank_rocker_slider, crank_rpp, driving_torque, electronic_cam, excavator,
    five_bar_robot, flying_shear, four_bar, function_generator, jansen_leg, press_friction, range,
    scissor_lift, set_point, shear_bearings, six_bar, six_bar_reactions, slider_crank, suspension,
    toggle_clamp, transplanter, whitworth,
};

/// Under which heading a machine stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Four links.
    FourBar,
    /// A block on a guide, or a yoke.
    Slider,
    /// More links than four and one input.
    SixBar,
    /// Two inputs or three.
    SeveralInputs,
    /// At a given motion, with the forces that go with it.
    Loaded,
    /// Moved by its forces, integrated.
    Free,
}

impl Kind {
    /// In the order of the index.
    pub const ALL: [Self; 6] =
        [Self::FourBar, Self::Slider, Self::SixBar, Self::SeveralInputs, Self::Loaded, Self::Free];

    /// The heading.
    pub const fn heading(self) -> &'static str {
        match self {
            Self::FourBar => "Four-bars",
            Self::Slider => "Sliders, yokes and quick returns",
            Self::SixBar => "Six-bars and larger",
            Self::SeveralInputs => "Several inputs",
            Self::Loaded => "Forces in bearings and on the base",
            Self::Free => "Motion under forces",
        }
    }
}

/// A film and where it is from.
pub struct Piece {
    /// The example and the struct.
    pub name: &'static str,
    /// The heading that it stands under.
    pub kind: Kind,
    /// A description of the motion.
    pub text: &'static str,
    /// The motion.
    pub film: Film,
}

/// Poses of a film.
pub const POSES: u32 = 121;

/// As many angles as poses, once round and counter-clockwise.
pub fn turn() -> impl Iterator<Item = f64> + Clone {
    (0..POSES).map(|k| f64::from(k) * TAU / f64::from(POSES - 1))
}

/// Shares of the way, from 0 to 1.
fn shares() -> impl Iterator<Item = f64> + Clone {
    (0..POSES).map(|k| f64::from(k) / f64::from(POSES - 1))
}

/// Every mechanism of the examples.
pub fn pieces() -> Vec<Piece> {
    let mut pieces = vec![
        Piece {
            name: "flying_shear::FlyingShear",
            kind: Kind::FourBar,
            text: "A strip mill's flying shear: the coupler carries the upper blade.",
            film: flying_shear::FlyingShear::new().film(turn()).trace("blade"),
        },
        Piece {
            name: "six_bar::SixBar",
            kind: Kind::SixBar,
            text: "Crank, swinging rod and ram: a quick return.",
            film: six_bar::SixBar::new().film(turn()).trace("E"),
        },
        Piece {
            name: "excavator::Excavator",
            kind: Kind::SeveralInputs,
            text: "Boom, stick and bucket, each moved by a cylinder, over one digging cycle.",
            film: excavator::Excavator::new().film(digging()).trace("tooth").seconds(7.5),
        },
        Piece {
            name: "jansen_leg::JansenLeg",
            kind: Kind::SixBar,
            text: "A leg of Jansen's walkers: the foot's path is straight where it carries.",
            film: jansen_leg::JansenLeg::new().film(turn().map(|q| -q)).trace("foot"),
        },
        Piece {
            name: "four_bar::FourBar",
            kind: Kind::FourBar,
            text: "A crank-rocker.",
            film: four_bar::FourBar::new().film(turn()).trace("C"),
        },
        Piece {
            name: "slider_crank::OffsetSliderCrank",
            kind: Kind::Slider,
            text: "Crank, connecting rod and piston; the cylinder's axis passes beside the shaft.",
            film: slider_crank::OffsetSliderCrank::new().film(turn()),
        },
        Piece {
            name: "crank_rocker_slider::CrankRockerSlider",
            kind: Kind::Slider,
            text: "Crank, rocker, and a connecting rod to a block.",
            film: crank_rocker_slider::CrankRockerSlider::new().film(turn()).trace("E"),
        },
        Piece {
            name: "crank_rpp::CrankYoke",
            kind: Kind::Slider,
            text: "A Scotch yoke: the block slides in the slot of the yoke, the yoke on its rail.",
            film: crank_rpp::CrankYoke::new().film(turn()),
        },
    ];
    pieces.extend(more());
    pieces.extend(designed());
    pieces.extend(commanded());
    pieces.extend(forced::pieces());
    pieces
}

/// The films of the README, by the names of their files, so wide that their letters are of the
/// size of its text.
pub fn readme() -> Vec<(&'static str, Film)> {
    let films = pieces().into_iter().take(4);
    films
        .map(|piece| {
            let name = piece.name.split("::").next().unwrap_or_default();
            (name, piece.film.width(400.0))
        })
        .collect()
}

/// The film of the page about unknowns.
pub fn of_unknowns() -> Film {
    let heights = turn().step_by(4).map(|q| 0.33 - 0.06 * q.cos());
    suspension::ByTheWheel::new().film(heights).trace("W").trace("tyre").width(360.0)
}

fn more() -> Vec<Piece> {
    vec![
        Piece {
            name: "whitworth::Shaper",
            kind: Kind::Slider,
            text: "A shaper's quick return: the bar swings about its lower pivot.",
            film: whitworth::Shaper::new().film(turn()),
        },
        Piece {
            name: "whitworth::Whitworth",
            kind: Kind::Slider,
            text: "Whitworth's form: the bar goes round.",
            film: whitworth::Whitworth::new().film(turn()),
        },
        Piece {
            name: "five_bar_robot::Forward",
            kind: Kind::SeveralInputs,
            text: "A five-bar robot, its tool on a circle, forward: the motors' angles are given.",
            film: five_bar_robot::Forward::new().film(motors()).trace("P").seconds(5.0),
        },
        Piece {
            name: "five_bar_robot::Inverse",
            kind: Kind::SeveralInputs,
            text: "The five-bar robot, inverse: the tool's place is given.",
            film: five_bar_robot::Inverse::new().film(circle()).trace("P").seconds(5.0),
        },
        Piece {
            name: "transplanter::Transplanter",
            kind: Kind::SeveralInputs,
            text: "A double-crank five-bar with a bill that sets seedlings.",
            film: transplanter::Transplanter::new()
                .film(turn().map(|q| [-q, 0.5 - q]))
                .trace("bill"),
        },
        Piece {
            name: "driving_torque::FourBar",
            kind: Kind::Loaded,
            text: "At four turns a second: the force that shakes the base, drawn at A, and the crank's torque.",
            film: loaded(),
        },
        Piece {
            name: "driving_torque::AsInTheText",
            kind: Kind::Loaded,
            text: "The four-bar of the driving torque, its masses in the middles of the bars.",
            film: driving_torque::AsInTheText::new().film(turn()),
        },
        Piece {
            name: "press_friction::CutPress",
            kind: Kind::Loaded,
            text: "A press whose pins and guide rub.",
            film: press_friction::CutPress::new().film(turn()),
        },
        Piece {
            name: "toggle_clamp::ToggleClamp",
            kind: Kind::Loaded,
            text: "A toggle clamp, from open to where friction holds it.",
            film: toggle_clamp::ToggleClamp::new()
                .film((0..=60).map(|step| 0.6 - 0.012 * f64::from(step))),
        },
        Piece {
            name: "scissor_lift::ScissorLift",
            kind: Kind::Loaded,
            text: "A scissor lift on a screw, from 10° to 60°.",
            film: scissor_lift::ScissorLift::new()
                .film((20..=120).map(|half| 1.2 * (0.5 * f64::from(half)).to_radians().cos())),
        },
        Piece {
            name: "shear_bearings::FlyingShear",
            kind: Kind::Loaded,
            text: "What the bearings exert on the links, 10 kN on the blade.",
            film: cutting(),
        },
        Piece {
            name: "six_bar_reactions::SixBar",
            kind: Kind::Loaded,
            text: "What the bearings exert on the links at one turn a second.",
            film: turning(),
        },
        Piece {
            name: "range::FourBar",
            kind: Kind::FourBar,
            text: "A base too long for its bars: where the circles do not meet there is no pose.",
            film: range::FourBar { base: 0.39 }.film(turn()).trace("C").seconds(6.0),
        },
        Piece {
            name: "range::Shaper",
            kind: Kind::Slider,
            text: "A shaper whose bar passes beside its pivot.",
            film: range::Shaper::new().film(turn()),
        },
    ]
}

fn designed() -> Vec<Piece> {
    vec![
        Piece {
            name: "electronic_cam::FlyingShear",
            kind: Kind::FourBar,
            text: "The shear of the electronic cam, to and fro by 240°.",
            film: electronic_cam::FlyingShear::new()
                .film(shares().map(|s| 2.0 + 4.0 * PI / 3.0 * s))
                .trace("blade")
                .there_and_back(),
        },
        Piece {
            name: "calibration::SixBar",
            kind: Kind::SixBar,
            text: "The six-bar whose fourteen dimensions are found from measured poses.",
            film: calibration::SixBar::new().film(turn()).trace("F"),
        },
        Piece {
            name: "function_generator::FunctionGenerator",
            kind: Kind::FourBar,
            text: "A function generator: the rocker turns as its pointer does, or nearly.",
            film: function_generator::FunctionGenerator::new()
                .film(shares().map(|s| s * PI / 2.0))
                .there_and_back(),
        },
        Piece {
            name: "suspension::ByTheArm",
            kind: Kind::SixBar,
            text: "A double wishbone, its lower arm up and down.",
            film: suspension::ByTheArm::new()
                .film(shares().map(|s| 0.05 - 0.3 * (TAU * s).cos()))
                .trace("W"),
        },
        Piece {
            name: "function_generator::Transmission",
            kind: Kind::FourBar,
            text: "The transmission angle of the function generator, between coupler and rocker.",
            film: function_generator::Transmission::new().film(turn()),
        },
    ]
}

/// Pieces whose motion an equation drives.
fn commanded() -> Vec<Piece> {
    vec![
        Piece {
            name: "suspension::ByTheWheel",
            kind: Kind::SixBar,
            text: "A double wishbone by its wheel's travel: the arm's angle is searched.",
            film: suspension::ByTheWheel::new()
                .film(turn().map(|q| 0.33 - 0.06 * q.cos()))
                .trace("W")
                .trace("tyre"),
        },
        Piece {
            name: "set_point::Press",
            kind: Kind::Slider,
            text: "A press whose ram is commanded: down, a dwell, and up.",
            film: set_point::Press::new().film(shares().map(commanded_ram)),
        },
    ]
}

/// Where the press's ram is wanted, at a share of its cycle.
fn commanded_ram(share: f64) -> f64 {
    let way = match share {
        _ if share < 0.4 => 0.5 - 0.5 * (PI * share / 0.4).cos(),
        _ if share < 0.5 => 1.0,
        _ => 0.5 - 0.5 * (TAU * share).cos(),
    };
    0.325 - 0.135 * way
}

/// Lengths of the excavator's cylinders through the corners of a digging cycle, at rest in each.
pub(crate) fn digging() -> impl Iterator<Item = [f64; 3]> {
    const CORNERS: [[f64; 3]; 6] = [
        [2.35, 2.65, 1.80],
        [2.15, 2.75, 1.85],
        [2.15, 3.20, 2.10],
        [2.30, 3.45, 2.35],
        [2.75, 3.30, 2.40],
        [2.35, 2.65, 1.80],
    ];
    shares().map(|share| {
        let at = share * (CORNERS.len() - 1) as f64;
        let leg = (at as usize).min(CORNERS.len() - 2);
        let s = at - leg as f64;
        let blend = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
        let (from, to) = (CORNERS[leg], CORNERS[leg + 1]);
        std::array::from_fn(|i| from[i] + (to[i] - from[i]) * blend)
    })
}

/// A circle of the robot's tool.
fn circle() -> impl Iterator<Item = [f64; 2]> {
    turn().map(|q| [0.06 * q.cos(), 0.3 + 0.06 * q.sin()])
}

/// The motors' angles on it.
fn motors() -> Vec<[f64; 2]> {
    let inverse = five_bar_robot::Inverse::new();
    let angles = circle().map(|at| inverse.position(at).map(|p| [p.AB.angle(), p.DE.angle()]));
    angles.map(|angles| angles.expect("the circle is in reach")).collect()
}

/// The mechanism with its shaking force at constant speed.
fn loaded() -> Film {
    let solver = driving_torque::FourBar::new();
    let rate = 4.0 * TAU;
    let forces = turn().map(|q| solver.forces(q, rate, 0.0).expect("the crank turns fully"));
    let forces: Vec<_> = forces.collect();
    let film = solver.film(turn());
    let film = film.force("A", forces.iter().map(|f| [f.shaking.x, f.shaking.y]));
    film.couple("A", forces.iter().map(|f| f.theta.drive))
}

/// Reactions at rest.
fn cutting() -> Film {
    let solver = shear_bearings::FlyingShear::new();
    let film = solver.film(turn()).applied(turn().map(|q| solver.applied(q, 0.0, 1e4)));
    film.reactions(turn().map(|q| solver.statics(q, 1e4)))
}

/// Reactions in motion.
fn turning() -> Film {
    let solver = six_bar_reactions::SixBar::new();
    solver.film(turn()).reactions(turn().map(|q| solver.forces(q, TAU, 0.0)))
}
