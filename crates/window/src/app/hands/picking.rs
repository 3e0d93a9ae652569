//! Picking: what is under the pointer, with tolerance for small pieces and a thin rim.

use crate::app::SauteApp;
use crate::ui::picking::{cross, distance, to_segment};
use egui::{Pos2, Rect, pos2};
use glam::{Mat4, Vec3};
use saute_kitchen::Piece;
use saute_picture::stage::Pose;
use saute_scene::mesh::pan::{HANDLE_ANGLE, HANDLE_REACH};

/// How near to handle or rim a pointer grabs the pan [points] (chosen).
const PAN_GRAB: f32 = 14.0;

/// At most this many drawn points of a piece are looked at (chosen: the outline is then true to a point or two).
const LOOKED_AT: usize = 160;

impl SauteApp {
    /// The piece nearest to a place in the window, within some points; of those under it the one nearest to the eye.
    pub(crate) fn piece_near(&self, at: Pos2, rect: Rect, within: f32) -> Option<String> {
        let kitchen = &self.session.kitchen;
        let (eye, aspect) = (self.eye(), rect.width() / rect.height());
        let clip = eye.view_projection(aspect);
        let poses = self.places().all(kitchen);
        let pieces = kitchen.pieces().iter().zip(&poses);
        let near = pieces.filter_map(|(piece, pose)| {
            let away = self.distance_to(piece, pose, &clip, at, rect)?;
            (away <= within).then(|| (away, eye.eye().distance(pose.position), piece))
        });
        near.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))).map(|(.., piece)| piece.id.clone())
    }

    /// Distance of a place in the window from a piece's outline; 0 on it [points].
    fn distance_to(&self, piece: &Piece, pose: &Pose, clip: &Mat4, at: Pos2, rect: Rect) -> Option<f32> {
        let points = self.sights.stage.points(&piece.id);
        let step = points.len().div_ceil(LOOKED_AT).max(1);
        let matrix = *clip * pose.matrix();
        let seen: Option<Vec<Pos2>> =
            points.iter().step_by(step).map(|v| seen(&matrix, v.position.into(), rect)).collect();
        let hull = hull(seen?);
        (!hull.is_empty()).then(|| distance(&hull, at))
    }

    /// Returns true if handle or rim of the pan are under a place in the window.
    pub(crate) fn pan_near(&self, at: Pos2, rect: Rect) -> bool {
        let look = &self.session.kitchen.pan_model().description;
        let (rim, height) = (look.wall.rim_radius_mm as f32 * 1e-3, look.wall.height_mm as f32 * 1e-3);
        let pan = self.places().pan(&self.session.kitchen).matrix();
        let matrix = self.eye().view_projection(rect.width() / rect.height()) * pan;
        let around = (0..=64).map(|k| {
            let (sin, cos) = (std::f32::consts::TAU * k as f32 / 64.0).sin_cos();
            Vec3::new(rim * cos, rim * sin, height)
        });
        let (sin, cos) = HANDLE_ANGLE.sin_cos();
        let handle = (0..=8).map(|k| {
            let away = rim + (HANDLE_REACH - rim) * k as f32 / 8.0;
            Vec3::new(away * cos, away * sin, height + 0.035 * k as f32 / 8.0)
        });
        let (around, handle): (Vec<_>, Vec<_>) = (around.collect(), handle.collect());
        [around, handle].iter().any(|line| {
            let points: Vec<Pos2> = line.iter().filter_map(|p| seen(&matrix, *p, rect)).collect();
            points.windows(2).any(|ends| to_segment(ends[0], ends[1], at) < PAN_GRAB)
        })
    }
}

/// Where a point appears in a window; none behind the eye.
fn seen(clip: &Mat4, point: Vec3, rect: Rect) -> Option<Pos2> {
    let p = *clip * point.extend(1.0);
    let at = |v: f32| v / p.w;
    (p.w > 0.01).then(|| {
        pos2(rect.left() + 0.5 * (at(p.x) + 1.0) * rect.width(), rect.top() + 0.5 * (1.0 - at(p.y)) * rect.height())
    })
}

/// Convex outline of points, anticlockwise (monotone chains).
fn hull(mut points: Vec<Pos2>) -> Vec<Pos2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = Pos2>| {
        let mut chain: Vec<Pos2> = Vec::new();
        for p in points {
            while chain.len() > 1 && cross(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0.0 {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut outline = chain(&mut points.iter().copied());
    outline.extend(chain(&mut points.iter().rev().copied()));
    outline
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outline_of_a_square_holds_its_inside_and_measures_its_outside() {
        let corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (5.0, 5.0), (3.0, 0.0)];
        let outline = hull(corners.map(|(x, y)| pos2(x, y)).to_vec());
        assert_eq!(outline.len(), 4);
        assert_eq!(distance(&outline, pos2(5.0, 5.0)), 0.0);
        assert_eq!(distance(&outline, pos2(5.0, -3.0)), 3.0);
        assert_eq!(distance(&outline, pos2(13.0, 14.0)), 5.0);
    }
}
