//! Axis-aligned bounding boxes.

use glam::DVec3;

/// Returns the smallest and the largest coordinates of some points [m]; infinite and reversed without any point.
pub(crate) fn bounds(points: impl IntoIterator<Item = DVec3>) -> [DVec3; 2] {
    let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    points.into_iter().fold(none, |[low, high], p| [low.min(p), high.max(p)])
}
