//! Sensitivities of an output by one unit load on it: the reactions of the joints are the sensitivities.
//!
//! Let a force of one act on an output point along x, or a torque of one on a link whose angle is the output,
//! while the drives hold the inputs. If the place of a joint on a link moves by δ, the output moves by the
//! force on the link at that joint times δ: virtual work, with a load of one. So one call of `statics` gives the
//! sensitivity to every length, to every place of a pin and to play in every joint, whether or not the
//! declaration names any of them as a parameter.

use linkage_core::Record;

use crate::error::DesignError;

/// The reactions to a unit load on an output.
///
/// The declaration puts a load on the output, `load up: force; force (0, up) on blade;` for `blade.y`, or
/// `load turn: torque; torque turn on DC;` for `DC.angle`, and asks for every reaction, by leaving `output` out or
/// by naming joints. Weights and springs fall out, since the reactions without the load are subtracted.
#[derive(Clone, Debug, PartialEq)]
pub struct Reactions {
    /// Name and number of each reaction: `BC.C.x`, `ram.bed.normal`, `theta.drive`.
    numbers: Vec<(String, f64)>,
    /// The load itself, which is no joint.
    load: Vec<(String, f64)>,
    /// Cosine and sine of each link's angle.
    axes: Vec<(&'static str, [f64; 2])>,
}

impl Reactions {
    /// The reactions of a pose: its position, its `statics` without the load, and with one of 1 N or 1 N·m.
    pub fn of<P: Record<Number = f64>, R: Record<Number = f64>>(
        position: P,
        unloaded: R,
        loaded: R,
    ) -> Self {
        let differences = loaded.into_array().into_iter().zip(unloaded.into_array());
        let numbers = R::LABELS
            .iter()
            .zip(differences)
            .map(|(label, (loaded, unloaded))| ((*label).to_owned(), loaded - unloaded))
            .collect();
        let named: Vec<(&'static str, f64)> =
            P::LABELS.iter().copied().zip(position.into_array()).collect();
        // A direction is two numbers under one label.
        let pairs = named.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        let axes = pairs.map(|pair| (pair[0].0, [pair[0].1, pair[1].1])).collect();
        Self { numbers, load: Vec::new(), axes }
    }

    /// Adds the load itself, as the force on a link at the point that it acts on.
    #[must_use]
    pub fn loaded(mut self, link: &str, point: &str, [x, y]: [f64; 2]) -> Self {
        let named = |component| format!("{link}.{point}.{component}");
        self.load.extend([(named("x"), x), (named("y"), y)]);
        self
    }

    fn number(&self, name: &str) -> Result<f64, DesignError> {
        let all = || self.numbers.iter().chain(&self.load);
        let found = all().find(|number| number.0 == name);
        found.map(|number| number.1).ok_or_else(|| DesignError::Unknown {
            name: name.to_owned(),
            known: all().map(|number| number.0.clone()).collect(),
        })
    }

    /// The output by a shift of a joint's place on a link, in ground axes.
    ///
    /// # Errors
    /// `Unknown` where no reaction has that name.
    pub fn shift(&self, link: &str, joint: &str) -> Result<[f64; 2], DesignError> {
        let component = |axis| self.number(&format!("{link}.{joint}.{axis}"));
        Ok([component("x")?, component("y")?])
    }

    /// The output by a shift of a joint's place on a link along the link's own x and y: by a bar's length where
    /// the joint is its inner pin, and by the coordinates of a point in the link's frame.
    ///
    /// # Errors
    /// `Unknown` where no reaction has that name, or the position has no angle of the link.
    pub fn place(&self, link: &str, joint: &str) -> Result<[f64; 2], DesignError> {
        let [x, y] = self.shift(link, joint)?;
        let angle = format!("{link}.angle");
        let axes = self.axes.iter().find(|axes| axes.0 == angle);
        let [cos, sin] = axes.map(|axes| axes.1).ok_or_else(|| DesignError::Unknown {
            name: angle,
            known: self.axes.iter().map(|axes| axes.0.to_owned()).collect(),
        })?;
        Ok([x * cos + y * sin, y * cos - x * sin])
    }

    /// The output by the place in ground axes of a pin that is fixed to the ground, by which a link stands on
    /// it: the force is that on the ground.
    ///
    /// # Errors
    /// `Unknown` where no reaction has that name.
    pub fn ground(&self, link: &str, joint: &str) -> Result<[f64; 2], DesignError> {
        Ok(self.shift(link, joint)?.map(|force| -force))
    }

    /// The output by a shift of a guide along its normal, which is that by the block's offset, too; and by a
    /// turn of the guide about the origin of the block's frame, counter-clockwise. About a point of the guide
    /// that lies behind it by the slide s, the turn has s times the shift in addition.
    ///
    /// # Errors
    /// `Unknown` where no reaction has that name.
    pub fn guide(&self, block: &str, guide: &str) -> Result<[f64; 2], DesignError> {
        let normal = self.number(&format!("{block}.{guide}.normal"))?;
        Ok([-normal, -self.number(&format!("{block}.{guide}.couple"))?])
    }

    /// The output by an input: by an error of a drive.
    ///
    /// # Errors
    /// `Unknown` where there is no such drive.
    pub fn drive(&self, input: &str) -> Result<f64, DesignError> {
        Ok(-self.number(&format!("{input}.drive"))?)
    }

    /// The output by play in each pin: the largest sensitivity, over all directions, to a shift of the pin in
    /// its hole. Each hole is named by its link; where two links share a pin, the first one has the hole, and
    /// where more do, all but the first have.
    #[must_use]
    pub fn pins(&self) -> Vec<(String, f64)> {
        let mut holes: Vec<(&str, &str, f64)> = Vec::new();
        for pair in self.numbers.windows(2) {
            let [x, y] = [&pair[0], &pair[1]].map(|number| number.0.as_str());
            if let (Some(hole), Some(other)) = (x.strip_suffix(".x"), y.strip_suffix(".y"))
                && hole == other
                && let Some((link, point)) = hole.split_once('.')
            {
                holes.push((link, point, pair[0].1.hypot(pair[1].1)));
            }
        }
        let sharing = |point: &str| holes.iter().filter(|hole| hole.1 == point).count();
        let is_first = |index: usize| !holes[..index].iter().any(|hole| hole.1 == holes[index].1);
        let has_hole = |index: &usize| is_first(*index) == (sharing(holes[*index].1) <= 2);
        let named =
            |index: usize| (format!("{}.{}", holes[index].0, holes[index].1), holes[index].2);
        (0..holes.len()).filter(has_hole).map(named).collect()
    }
}
