//! Targets of a machine's curve: functions, paths and poses, with a time for each or without.

use linkage_core::{Direction, SolveError};

use crate::design::Design;
use crate::follows::{Follows, Pose};
use crate::nearest::{Frame, Nearest};
use crate::placed::remainders;
use crate::rows::{Block, Cause, Dual, Machines, finite};

impl<'a, M: 'a, F, const N: usize> Design<'a, M, F, N> {
    /// An output that shall follow a function, given as pairs of an input and the wanted output.
    pub fn function<O: Follows<N>>(
        self,
        name: &str,
        pairs: impl IntoIterator<Item = (f64, f64)>,
        output: impl Fn(&M, Dual<N>) -> Result<O, SolveError> + Send + Sync + 'a,
    ) -> Self {
        self.aim(name, pairs, move |machine, (input, wanted)| {
            Ok([output(machine, input.into())?.ahead_of(wanted)])
        })
    }

    /// A point that shall pass others, each at its input.
    pub fn path<P: Into<[Dual<N>; 2]>>(
        self,
        name: &str,
        points: impl IntoIterator<Item = (f64, [f64; 2])>,
        point: impl Fn(&M, Dual<N>) -> Result<P, SolveError> + Send + Sync + 'a,
    ) -> Self {
        self.aim(name, points, move |machine, (input, [x, y])| {
            let [at_x, at_y] = point(machine, input.into())?.into();
            Ok([at_x - x, at_y - y])
        })
    }

    /// A point that shall pass others, each at its input, after the whole machine was placed, turned and sized
    /// in the best way. [`placement`](crate::placement) gives this way.
    pub fn placed_path<P: Into<[Dual<N>; 2]>>(
        self,
        name: &str,
        points: impl IntoIterator<Item = (f64, [f64; 2])>,
        point: impl Fn(&M, Dual<N>) -> Result<P, SolveError> + Send + Sync + 'a,
    ) -> Self {
        let (inputs, targets): (Vec<f64>, Vec<[f64; 2]>) = points.into_iter().unzip();
        let places = inputs.clone();
        let compute = move |machines: &Machines<M>, _: &[f64], to: &mut Vec<Dual<N>>| {
            let mut curve = Vec::with_capacity(inputs.len());
            for (place, &input) in inputs.iter().enumerate() {
                let at = point(&machines.sloped, input.into());
                curve.push(at.map_err(|error| (place, Cause::Refused(error)))?.into());
            }
            for (place, row) in remainders(&curve, &targets).into_iter().enumerate() {
                finite(&row).map_err(|cause| (place, cause))?;
                to.extend(row);
            }
            Ok(())
        };
        self.aimed(Block::of(name, 2, 4, compute, move |_, place| format!("{:?}", places[place])))
    }

    /// A curve of a point over a range of the input that shall pass others, wherever it is nearest to each.
    /// Residuals are the distances along the normals; the order of the points is not asked.
    pub fn untimed_path<P: Into<[Dual<N>; 2]>>(
        self,
        name: &str,
        between: [f64; 2],
        points: impl IntoIterator<Item = [f64; 2]>,
        point: impl Fn(&M, Dual<N>) -> Result<P, SolveError> + Send + Sync + 'a,
    ) -> Self {
        let targets: Vec<Frame> = points.into_iter().map(Frame::Point).collect();
        self.untimed(name, between, targets, move |machine, input| {
            let [x, y] = point(machine, input)?.into();
            Ok([x, y, Dual::from_re(1.0), Dual::from_re(0.0)])
        })
    }

    /// A link that shall pass poses over a range of the input, wherever it is nearest to each. The function
    /// gives the point and the direction of the link; a radian counts as much as `arm` metres.
    pub fn untimed_poses<P: Into<[Dual<N>; 2]>, U: Into<Direction<Dual<N>>>>(
        self,
        name: &str,
        between: [f64; 2],
        arm: f64,
        poses: impl IntoIterator<Item = Pose>,
        link: impl Fn(&M, Dual<N>) -> Result<(P, U), SolveError> + Send + Sync + 'a,
    ) -> Self {
        let targets = poses.into_iter().map(|pose| Frame::Pose { pose, arm }).collect();
        self.untimed(name, between, targets, move |machine, input| {
            let (point, direction) = link(machine, input)?;
            let ([x, y], direction) = (point.into(), direction.into());
            Ok([x, y, direction.cos, direction.sin])
        })
    }

    /// A link that shall pass poses, each at its input.
    pub fn poses<P: Into<[Dual<N>; 2]>, U: Into<Direction<Dual<N>>>>(
        self,
        name: &str,
        arm: f64,
        poses: impl IntoIterator<Item = (f64, Pose)>,
        link: impl Fn(&M, Dual<N>) -> Result<(P, U), SolveError> + Send + Sync + 'a,
    ) -> Self {
        self.aim(name, poses, move |machine, (input, pose)| {
            let (point, direction) = link(machine, input.into())?;
            let ([x, y], direction) = (point.into(), direction.into());
            Ok([x - pose.x, y - pose.y, direction.ahead_of(pose.angle) * arm])
        })
    }

    fn untimed(
        self,
        name: &str,
        between: [f64; 2],
        targets: Vec<Frame>,
        curve: impl Fn(&M, Dual<N>) -> Result<[Dual<N>; 4], SolveError> + Send + Sync + 'a,
    ) -> Self {
        let count = targets.len();
        let width = targets.first().map_or(2, Frame::width);
        let shown: Vec<String> = targets.iter().map(|target| format!("{target:?}")).collect();
        let nearest = Nearest { between, targets, curve };
        let compute = move |machines: &Machines<M>, _: &[f64], to: &mut Vec<Dual<N>>| {
            nearest.rows(machines, to)
        };
        self.aimed(Block::of(name, width, count, compute, move |_, place| shown[place].clone()))
    }
}
