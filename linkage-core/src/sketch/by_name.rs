//! Places of points and links in a pose, by their names.

use super::scene::{Pose, Scene};
use super::sketch_error::SketchError;
use super::traces;
use crate::{Direction, Point};

/// Where a link is: its frame in ground axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkPose {
    /// The frame's origin, in metres.
    pub origin: Point<f64>,
    /// The unit vector along its x.
    pub direction: Direction<f64>,
}

pub(super) fn point_of(scene: &Scene, pose: usize, name: &str) -> Result<Point<f64>, SketchError> {
    let point = traces::point(scene.plan, name)?;
    let pose = scene.frames().nth(pose).ok_or(SketchError::EmptyPath)?;
    let [x, y] = scene.point(pose, point).ok_or_else(|| missing(scene, pose))?;
    Ok(Point { x, y })
}

pub(super) fn link_of(scene: &Scene, pose: usize, name: &str) -> Result<LinkPose, SketchError> {
    let link = traces::link(scene.plan, name)?;
    let pose = scene.frames().nth(pose).ok_or(SketchError::EmptyPath)?;
    let frame = scene.link(pose, link).ok_or_else(|| missing(scene, pose))?;
    let ([x, y], Pose { cos, sin, .. }) = (frame.origin, frame);
    Ok(LinkPose { origin: Point { x, y }, direction: Direction { cos, sin } })
}

/// Only what failed is missing.
fn missing(scene: &Scene, pose: usize) -> SketchError {
    scene.failure(pose).map_or(SketchError::EmptyPath, |failure| failure.error.into())
}
