//! Intervals that hold several dead points, against dense scans: a sample of those of `.ci/nightly`.

use std::vec;
use std::vec::Vec;

use super::*;

/// A sum of sines, in numbers of `f64`.
struct Sum {
    terms: Vec<[f64; 3]>,
    level: f64,
}

impl Sum {
    fn random(random: &mut Random) -> Self {
        let count = 1 + (random.unit() * 4.0) as i32;
        let term = |k: i32, random: &mut Random| {
            let size = random.between(-1.0, 1.0) / f64::from(k).sqrt();
            [size, f64::from(k), random.between(0.0, core::f64::consts::TAU)]
        };
        let terms = (1..=count).map(|k| term(k, random)).collect();
        Self { terms, level: random.between(-0.8, 0.8) }
    }

    /// Value, slope and curvature.
    fn at(&self, x: f64) -> [f64; 3] {
        self.terms.iter().fold([self.level, 0.0, 0.0], |[value, slope, bend], &[size, k, phase]| {
            let (sin, cos) = (k * x + phase).sin_cos();
            [value + size * sin, slope + size * k * cos, bend - size * k * k * sin]
        })
    }

    /// The largest value.
    fn size(&self) -> f64 {
        self.terms.iter().map(|term| term[0].abs()).sum::<f64>() + self.level.abs()
    }

    /// The places between which it rises or falls all the way: both ends and the dead points. A sum of
    /// four harmonics at most turns eight times in 2π; 800 samples of that tell two turns apart that
    /// are 8e-3 from each other.
    fn monotone(&self, [a, b]: [f64; 2]) -> Vec<f64> {
        let x = |step: i32| a + (b - a) * f64::from(step) / 800.0;
        let mut places = vec![a];
        for step in 0..800 {
            let (mut low, mut high) = (x(step), x(step + 1));
            let slope = self.at(low)[1];
            if slope * self.at(high)[1] < 0.0 {
                for _ in 0..60 {
                    let middle = (low + high) / 2.0;
                    if self.at(middle)[1] * slope > 0.0 { low = middle } else { high = middle }
                }
                places.push(low);
            }
        }
        places.push(b);
        places
    }
}

/// Roots of each kind in an interval that is divided in this way, rising first; none where a value at a
/// dead point or an end is too near to zero to have a sign.
fn roots(sum: &Sum, places: &[f64], least: f64) -> Option<[Vec<f64>; 2]> {
    let mut found = [Vec::new(), Vec::new()];
    for ends in places.windows(2) {
        let [from, to] = [ends[0], ends[1]].map(|x| sum.at(x)[0]);
        if from.abs().min(to.abs()) < least {
            return None;
        }
        if from * to < 0.0 {
            let (mut low, mut high) = (ends[0], ends[1]);
            for _ in 0..60 {
                let middle = (low + high) / 2.0;
                if sum.at(middle)[0] * from > 0.0 { low = middle } else { high = middle }
            }
            found[usize::from(from > 0.0)].push(low);
        }
    }
    Some(found)
}

/// The smallest change of level that brings one of the stretches of the wanted trend to zero, if there
/// is such a stretch.
fn missing(sum: &Sum, places: &[f64], trend: Trend) -> Option<f64> {
    let sign: f64 = trend.sign();
    let stretches = places.windows(2).map(|ends| [ends[0], ends[1]].map(|x| sign * sum.at(x)[0]));
    let of_trend = stretches.filter(|[from, to]| to > from);
    of_trend.map(|[from, to]| from.max(-to)).min_by(f64::total_cmp)
}

/// The answers of as many searches in either trend.
#[derive(Debug, Default)]
struct Answers {
    searches: u32,
    /// The number of searches by the number of dead points in the interval.
    dead_points: [u32; 7],
    found: u32,
    none: u32,
    none_no_other: u32,
    none_nearest: u32,
    unknown: u32,
    /// The refused searches whose interval has at most one root.
    unknown_of_one: u32,
    evaluations: u32,
    most: u32,
    most_refused: u32,
}

fn search<T: Real>(searches: u32, least: f64) -> Answers {
    let (mut random, mut answers) = (Random(17), Answers::default());
    while answers.searches < searches {
        let sum = Sum::random(&mut random);
        let from = random.between(-3.0, 3.0);
        // The ends as the width has them.
        let between = [from, from + random.between(0.3, 6.3)].map(|x| number::<T>(x).value());
        let places = sum.monotone(between);
        let least = least * sum.size();
        let Some(roots) = roots(&sum, &places, least).filter(|_| places.len() <= 8) else {
            continue;
        };
        for (of, trend) in [Trend::Rising, Trend::Falling].into_iter().enumerate() {
            answers.searches += 1;
            answers.dead_points[places.len() - 2] += 1;
            let mut calls = 0;
            let found = Search::new(between.map(number::<T>), trend).find(|x| {
                calls += 1;
                let [value, slope, _] = sum.at(x.value());
                [value, slope].map(number)
            });
            assert!(calls <= 2 * Search::<T>::MOST, "{calls}");
            match found {
                Ok(root) => {
                    answers.found += 1;
                    answers.evaluations += calls;
                    answers.most = answers.most.max(calls);
                    assert_eq!(root.evaluations, calls);
                    let at = root.at.value();
                    // Zero to the rounding of the sum and of the place, on a stretch of the trend.
                    let [value, slope, bend] = sum.at(at);
                    let place = T::EPSILON * between[0].abs().max(between[1].abs());
                    let rounding = 8.0 * T::EPSILON * sum.size() + 2.0 * place * slope.abs();
                    assert!(value.abs() <= rounding, "{between:?} {trend:?} {at} {value:e}");
                    // If two roots have a dead point between them at which f is `least` or more, each root is
                    // this far from the dead point or more.
                    let aside = (least / bend.abs()).sqrt();
                    let is_it = |&root: &f64| (root - at).abs() < aside;
                    assert!(roots[of].iter().any(is_it), "{between:?} {trend:?} {at} {roots:?}");
                }
                Err(FindError::SeveralDeadPoints) => {
                    answers.unknown += 1;
                    answers.unknown_of_one += u32::from(roots[of].len() <= 1);
                    answers.most_refused = answers.most_refused.max(calls);
                    assert!(places.len() > 3, "{between:?} {trend:?} {places:?}");
                }
                Err(FindError::NoSolution { at, by, other }) => {
                    answers.none += 1;
                    answers.most_refused = answers.most_refused.max(calls);
                    assert!(roots[of].is_empty(), "{between:?} {trend:?} {roots:?} {places:?}");
                    let rounding = 8.0 * T::EPSILON * sum.size();
                    // A dead point is known to √ε, and its value to rounding.
                    assert!((by - sum.at(at)[0].abs()).abs() <= rounding, "{at} {by}");
                    if let Some(missing) = missing(&sum, &places, trend).filter(|_| other.is_none())
                    {
                        // With several dead points, one that is far from zero need not be met.
                        let is_nearest = by - missing <= rounding;
                        answers.none_nearest += u32::from(is_nearest);
                        assert!(missing - by <= rounding, "{between:?} {by} {missing}");
                        assert!(is_nearest || places.len() > 3, "{between:?} {by} {missing}");
                    }
                    if other.is_none() {
                        answers.none_no_other += 1;
                    }
                    match (other, &roots[1 - of][..]) {
                        (None, []) => {}
                        (Some(other), [root]) => {
                            assert_eq!(other.trend, trend.flipped());
                            assert!((other.at - root).abs() <= 1e3 * T::EPSILON.sqrt());
                        }
                        other => panic!("{other:?}"),
                    }
                }
                other => panic!("{other:?}"),
            }
        }
    }
    answers
}

#[test]
fn one_root_among_several_dead_points_is_found_or_said_to_be_unknown() {
    let searches = cases(4000, 20_000) as u32;
    let wide = search::<f64>(searches, 1e-9);
    let narrow = search::<f32>(searches, 1e-4);
    std::println!("{wide:?}\n{narrow:?}");
    for answers in [wide, narrow] {
        // There are many of each number of dead points, and few intervals of which nothing is known.
        assert!(answers.dead_points.iter().all(|&count| count > searches / 40), "{answers:?}");
        assert!(answers.unknown <= searches / 1000, "{answers:?}");
        let least = searches / 20 * 9;
        assert!(answers.found > least && answers.none > least, "{answers:?}");
    }
}

/// The sine rises through zero once between −0.5 and 4.8, with a dead point on either side of the middle.
#[test]
fn a_root_between_two_dead_points_is_found() {
    fn at<T: Real>(between: [f64; 2], trend: Trend) -> Result<f64, FindError> {
        let search = Search::new(between.map(number::<T>), trend);
        search.find(|x| [x.sin_cos().0, x.sin_cos().1]).map(|root| root.at.value())
    }
    for between in [[-0.5, 4.8], [-1.4, 4.6], [-3.0, 3.0], [-4.5, 1.5]] {
        let wide = at::<f64>(between, Trend::Rising).expect("it rises");
        let narrow = at::<f32>(between, Trend::Rising).expect("it rises");
        assert!(wide.abs() <= 5.0 * f64::EPSILON, "{between:?} {wide}");
        assert!(narrow.abs() <= 5.0 * f64::from(f32::EPSILON), "{between:?} {narrow}");
        // The other way about: half a turn on it falls.
        let between = between.map(|end| end + core::f64::consts::PI);
        let wide = at::<f64>(between, Trend::Falling).expect("it falls");
        let narrow = at::<f32>(between, Trend::Falling).expect("it falls");
        assert!((wide - core::f64::consts::PI).abs() <= 2.0 * f64::EPSILON, "{between:?} {wide}");
        assert_eq!(narrow as f32, core::f32::consts::PI, "{between:?}");
    }
}

/// An end at which f is zero against the trend is no root, and one at a dead point is.
#[test]
fn an_end_that_f_passes_the_other_way_is_no_root() {
    let sine = |x: f64| [x.sin(), x.cos()];
    let slack = Search::new([0.0, 1.0], Trend::Falling).slack(1e-15);
    let other = Some(Crossing { trend: Trend::Rising, at: 0.0 });
    assert_eq!(slack.find(sine), Err(FindError::NoSolution { at: 0.0, by: 0.0, other }));
    // Beyond it lies the root that is wanted.
    let both = Search { between: [0.0, 5.5], ..slack };
    let found = both.find(sine).expect("it falls at π").at;
    assert!((found - core::f64::consts::PI).abs() <= 4.0 * f64::EPSILON, "{found}");
    let cosine = |x: f64| [1.0 + 4e-16 - x.cos(), x.sin()];
    for between in [[0.0, 1.0], [-1.0, 0.0]] {
        for trend in [Trend::Rising, Trend::Falling] {
            let found = Search { between, trend, ..slack }.find(cosine).map(|root| root.at);
            let has_root = (between[0] == 0.0) == (trend == Trend::Rising);
            assert_eq!(found.is_ok(), has_root, "{between:?} {trend:?} {found:?}");
        }
    }
}

/// A wave that turns too often for the samples, and what is not smooth.
#[test]
fn what_cannot_be_told_is_said_to_be_unknown() {
    let wave = |x: f64| {
        let (sin, cos) = (300.0 * x).sin_cos();
        [1.05 + sin, 300.0 * cos]
    };
    let lie = |x: f64| [1.0 + x, f64::NAN];
    let found = [
        Search::new([0.0, 1.0], Trend::Rising).find(wave),
        Search::new([0.0, 1.0], Trend::Falling).find(wave),
        Search::new([0.0, 1.0], Trend::Rising).find(lie),
    ];
    for found in found {
        assert_eq!(found, Err(FindError::SeveralDeadPoints));
    }
    let text = std::format!("{}", FindError::SeveralDeadPoints);
    assert_eq!(text, "several dead points between the ends; narrow the interval");
    let wave = Search::new([0.0, 1.0], Trend::Falling);
    let text = std::format!("{}", wave.find(|x: f64| [x * x - 0.25, 2.0 * x]).unwrap_err());
    assert_eq!(text, "no falling root; it rises through zero at 0.500");
}

/// Functions of any signs at their ends, with slopes that lie: a root takes twice the bound at most, and what
/// is refused the bound.
#[test]
fn the_bound_holds_where_the_ends_enclose_no_root() {
    fn most<T: Real>(seed: u64) -> [u32; 2] {
        let (mut random, mut most) = (Random(seed), [0, 0]);
        for _ in 0..cases(4000, 20_000) {
            let sum = Sum::random(&mut random);
            let from = random.between(-3.0, 3.0);
            let between = [from, from + random.between(0.3, 6.3)].map(number::<T>);
            let lies = random.of(&[0.0, 0.1, 0.5, 1.0]);
            let steep = random.of(&[1.0, 0.3, 9.0]);
            let mut calls = 0;
            let found = Search::new(between, Trend::Rising).find(|x| {
                calls += 1;
                let [value, slope, _] = sum.at(x.value());
                let value = value.abs().powf(steep).copysign(value);
                let lie = random.of(&[-1.0, 0.0, 1e-9, 1e9, f64::NAN]);
                let slope =
                    if random.unit() < lies { lie * random.between(0.1, 9.0) } else { slope };
                [value, slope].map(number)
            });
            let refused = usize::from(found.is_err());
            most[refused] = most[refused].max(calls);
        }
        most
    }
    let (wide, narrow) = (most::<f64>(3), most::<f32>(4));
    std::println!("{wide:?} {narrow:?} evaluations of a root and of none");
    assert!(wide[0] <= 2 * Search::<f64>::MOST && wide[1] <= Search::<f64>::MOST, "{wide:?}");
    assert!(narrow[0] <= 2 * Search::<f32>::MOST && narrow[1] <= Search::<f32>::MOST, "{narrow:?}");
}

/// Dead points that halving alone finds, at both ends, wherever they are: the slope tells its sign alone, and
/// the values keep theirs.
#[test]
fn dead_points_that_take_long_at_both_ends_keep_the_bound() {
    fn most_calls<T: Real>() -> u32 {
        let mut random = Random(29);
        let mut most = 0;
        for _ in 0..2000 {
            let [lower, upper] = [random.between(-1.5, 0.0), random.between(0.0, 1.5)];
            let turn = random.between(-1.5, 1.5);
            let mut calls = 0;
            let found = Search::new([-1.5, 1.5].map(number::<T>), Trend::Rising).find(|x| {
                calls += 1;
                let x = x.value();
                let rises = lower < x && x < upper;
                [if x < turn { 1.0 } else { -1.0 }, if rises { 1.0 } else { -1.0 } * f64::INFINITY]
                    .map(number)
            });
            assert!(found.is_err(), "{found:?}");
            most = most.max(calls);
        }
        most
    }
    let [wide, narrow] = [most_calls::<f64>(), most_calls::<f32>()];
    // The bound is met, and not passed.
    assert_eq!([wide, narrow], [Search::<f64>::MOST, Search::<f32>::MOST]);
}

/// A dip between two crests that touches zero, and of several crests below zero the highest.
#[test]
fn a_dip_that_touches_is_a_root_and_the_nearest_crest_is_named() {
    let touching = |x: f64| [1.0 - x.cos(), x.sin()];
    let turn = core::f64::consts::TAU;
    for between in [[2.0, 11.0], [3.5, 10.0], [1.0, 9.0]] {
        let found = Search::new(between, Trend::Rising).find(touching).expect("it touches").at;
        // Zero to rounding as far as √ε from there.
        assert!((found - turn).abs() < 1e-7, "{between:?} {found}");
    }
    // Crests −3.66 at 1.77 and −2.41 at 8.06, and −2.80 at the end.
    let crests = |x: f64| [0.2 * x + x.sin() - 5.0, 0.2 + x.cos()];
    let crest = turn + (-0.2_f64).acos();
    match Search::new([0.0, 12.3], Trend::Rising).find(crests) {
        Err(FindError::NoSolution { at, by, other: None }) => {
            assert!(
                (at - crest).abs() < 1e-7 && (by + crests(crest)[0]).abs() < 1e-14,
                "{at} {by}"
            );
        }
        other => panic!("{other:?}"),
    }
}
