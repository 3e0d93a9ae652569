//! What a person looks at, and from where.

use saute_picture::view::View;

use super::traits::{Subject, Traits};
use crate::eye::EyeView;
use saute_session::permits::Permit;

/// What a person looks at, and from where.
#[derive(Clone, Debug, PartialEq)]
pub enum ViewAct {
    /// The panels show the next piece.
    NextPiece,
    /// The panels show this piece.
    Select(String),
    /// List of the pieces.
    Pieces,
    /// All ways side by side, or the one that goes on alone.
    SideBySide,
    /// View that the colours show.
    View(View),
    /// The look next to the view, or the view alone.
    Split,
    /// A probe where the pointer is.
    Probe,
    /// The next click on the food puts a probe in, or no longer does.
    Placing(bool),
    /// Chooses a probe by its number, or none.
    SelectProbe(Option<usize>),
    /// Names a probe.
    NameProbe(usize, String),
    /// Takes a probe out.
    RemoveProbe(usize),
    /// The other colour map.
    Map,
    /// The next scale of doneness.
    Scale,
    /// Cut on or off.
    Slice,
    /// Moves the cut.
    SliceBy(f64),
    /// Cuts at a place (−1…1).
    SliceAt(f64),
    /// °C or °F.
    Units,
    /// Next camera.
    Camera,
    /// Sends the eye to a view.
    Eye(EyeView),
    /// Nearer (below 1) or farther.
    Zoom(f32),
    /// Turns the eye [rad].
    Orbit(f32, f32),
    /// Food and pan choices.
    Pantry,
    /// Curves on or off.
    Curves,
    /// All panels on or off.
    Panels,
    /// For a class before a projector: no panels and the largest interface, or both as usual.
    Projector,
    /// All controls, or the few that a first cook needs.
    More,
    /// The strings of a device.
    Strings,
}

impl ViewAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::NextPiece => Traits { subject: Subject::Food, ..eye("key.next_piece") },
            Self::Select(_) => Traits { subject: Subject::Food, ..eye(Traits::NO_WORDS) },
            Self::Pieces => Traits { subject: Subject::Window, needs: &[Permit::ReadOuts], ..reading("key.pieces") },
            Self::SideBySide => Traits { needs: &[Permit::Rewind], ..reading("key.side_by_side") },
            Self::View(view) => shows(*view),
            Self::Split => reading("key.split"),
            Self::Probe => reading("key.probe"),
            Self::Placing(on) => Traits { reads: *on, ..reading(Traits::NO_WORDS) },
            Self::SelectProbe(_) | Self::NameProbe(..) | Self::RemoveProbe(_) => {
                Traits { subject: Subject::Views, ..eye(Traits::NO_WORDS) }
            }
            Self::Map => Traits { reads: false, ..reading("key.map") },
            Self::Scale => Traits { subject: Subject::Views, needs: &[Permit::Advice], ..eye("key.scale") },
            Self::Slice => Traits { frames_photo: true, ..reading("key.cut") },
            Self::SliceBy(by) => {
                let words = if *by > 0.0 { "key.cut_right" } else { "key.cut_left" };
                Traits { frames_photo: true, ..reading(words) }
            }
            Self::SliceAt(_) => reading(Traits::NO_WORDS),
            Self::Units => Traits { subject: Subject::Views, needs: &[Permit::Comfort], ..eye("key.units") },
            Self::Camera => Traits { frames_photo: true, ..eye("key.camera") },
            Self::Eye(EyeView::Front | EyeView::Above | EyeView::Food) => eye(Traits::NO_WORDS),
            Self::Zoom(factor) => {
                Traits { frames_photo: true, ..eye(if *factor < 1.0 { "key.nearer" } else { "key.farther" }) }
            }
            Self::Orbit(_, up) => {
                let words = [("key.look_higher", *up > 0.0), ("key.look_lower", *up < 0.0), ("key.turn_view", true)];
                let words = words.into_iter().find(|(_, holds)| *holds).map_or(Traits::NO_WORDS, |(words, _)| words);
                Traits { frames_photo: true, ..eye(words) }
            }
            Self::Pantry => Traits { subject: Subject::Window, needs: &[Permit::Foods], ..eye("key.pantry") },
            Self::Curves => Traits { subject: Subject::Window, needs: &[Permit::ReadOuts], ..reading("key.curves") },
            Self::Panels => Traits { subject: Subject::Window, ..eye("key.panels") },
            Self::Projector => Traits { subject: Subject::Window, over_cards: true, ..eye("key.projector") },
            Self::More => Traits { subject: Subject::Window, needs: &[Permit::Comfort], ..eye("key.more") },
            Self::Strings => Traits { subject: Subject::Window, needs: &[Permit::Devices], ..eye("key.strings") },
        }
    }
}

fn shows(view: View) -> Traits {
    let [_, _, words] = view.spec().texts;
    match view {
        View::Look => Traits { subject: Subject::Views, frames_photo: true, ..eye(words) },
        _ => Traits { frames_photo: true, ..reading(words) },
    }
}

/// What shows more than can be seen in a kitchen.
fn reading(words: &'static str) -> Traits {
    Traits { subject: Subject::Views, needs: &[Permit::Views], reads: true, ..eye(words) }
}

/// What a person looks at in a kitchen too.
fn eye(words: &'static str) -> Traits {
    Traits::plain(Subject::Eye, words, &[Permit::Eye])
}
