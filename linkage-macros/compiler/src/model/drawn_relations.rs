//! Slides, drives and directions of links, read from what is drawn of them.

use super::as_drawn::{DrawnSlide, FrameShift, whole_turns};
use super::mechanism::{AngleSum, Carrier, Drive, LinkId, Mechanism, PointId, Scalar};

impl Mechanism {
    /// The slide of the drawing that is the joint by which a link slides in its group.
    pub(crate) fn slide_as_drawn(&self, by: LinkId) -> Option<&DrawnSlide> {
        self.as_drawn.slides.iter().find(|slide| slide.by == by)
    }

    /// The link that is known to slide by the joint of this one.
    pub(crate) fn sliding(&self, by: LinkId) -> LinkId {
        self.slide_as_drawn(by).map_or(by, |slide| slide.link)
    }

    /// The link that is known to be driven by the drive of this one.
    pub(crate) fn driven_as_drawn(&self, by: LinkId) -> LinkId {
        let drives = &self.as_drawn.drives;
        drives.iter().find(|drive| drive.by == by).map_or(by, |drive| drive.link)
    }

    /// The angle of a link's frame against that of its group, where they differ.
    pub(crate) fn turn_of(&self, link: LinkId) -> Option<&Scalar> {
        self.frame_shift(Carrier::Link(link))?.angle.as_ref()
    }

    /// The written frame of a body, where its group gave it another one.
    pub(in crate::model) fn frame_shift(&self, body: Carrier) -> Option<&FrameShift> {
        let Carrier::Link(link) = body else { return None };
        self.as_drawn.frames.iter().find(|shift| shift.link == link)
    }

    /// An angle against the written frame of a body as one against that of its group.
    pub(in crate::model) fn turned(&self, body: Carrier, angle: AngleSum) -> AngleSum {
        match self.frame_shift(body).and_then(|shift| shift.angle.clone()) {
            Some(turn) => AngleSum { rest: angle.rest.plus(turn), ..angle },
            None => angle,
        }
    }

    /// Coordinates in the written frame of a body as those in that of its group.
    pub(in crate::model) fn placed(&self, body: Carrier, local: [Scalar; 2]) -> [Scalar; 2] {
        match self.frame_shift(body) {
            Some(shift) => shift.place(local),
            None => local,
        }
    }

    /// The turns that bring a sum of links' angles to within half a turn in the drawing, where the drive of one of them
    /// says that it has turned farther than it is drawn; none elsewhere.
    pub(crate) fn turns_of_drives(&self, links: &[(LinkId, i64)]) -> i64 {
        let drawn = |link: LinkId| self.as_drawn.angles.iter().find(|(known, _)| *known == link);
        let drawn = links.iter().filter_map(|&(link, times)| Some((drawn(link)?.1, times)));
        let drawn: Vec<_> = drawn.collect();
        if drawn.iter().all(|(angle, _)| whole_turns(*angle) == 0.0) {
            return 0;
        }
        whole_turns(drawn.iter().map(|(angle, times)| angle * *times as f64).sum()) as i64
    }

    /// True if the unknown of a search turns a link.
    pub(crate) fn is_searched_for(&self, link: LinkId) -> bool {
        self.as_drawn.searched.contains(&link)
    }

    /// The joints by which a link slides as it is drawn, by their guides.
    pub(crate) fn slides_of(&self, link: LinkId) -> impl Iterator<Item = &DrawnSlide> {
        self.as_drawn.slides.iter().filter(move |slide| slide.link == link)
    }

    /// The link by whose joint a link has its slide.
    pub(crate) fn slides_by(&self, link: LinkId) -> LinkId {
        self.slides_of(link).find(|slide| slide.is_first).map_or(link, |slide| slide.by)
    }

    /// The link whose driver drives this one, where its group has the drive the other way round.
    pub(crate) fn driven_by_another(&self, link: LinkId) -> Option<LinkId> {
        self.as_drawn.drives.iter().find(|drive| drive.link == link).map(|drive| drive.by)
    }

    /// True if a point is a joint of a drawing.
    pub(crate) fn is_drawn_joint(&self, point: PointId) -> bool {
        self.as_drawn.joints.contains(&point)
    }

    /// True if something is put on a joint of a drawing.
    pub(crate) fn is_loaded_joint(&self, point: PointId) -> bool {
        self.is_drawn_joint(point) && self.dynamics.loads_point(point)
    }

    /// True if a link is driven along a guide.
    pub(crate) fn is_driven_along(&self, link: LinkId) -> bool {
        let drive = self.group_with(link).and_then(|group| group.outer[0].drive.as_ref());
        matches!(drive, Some(Drive::Slide(_)))
    }
}
