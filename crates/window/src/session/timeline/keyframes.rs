//! Keyframes: instants of a cook that are kept whole.

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_kitchen::bytes::Models;
use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Moment, Replay, Runner};

use super::Timeline;

/// Size of all keyframes at most [bytes].
pub const MOST_BYTES: usize = 256 << 20;

/// An instant that is kept whole; models are shared.
pub(super) struct Keyframe {
    pub(super) moment: Moment,
    bytes: Vec<u8>,
    runner: Runner,
    plays: bool,
}

impl Keyframe {
    /// Returns its kitchen, from which a recording can be played on.
    pub(super) fn replay(&self, library: &Library, models: &mut Models) -> Replay {
        let kitchen = Kitchen::from_bytes_with(&self.bytes, library, models);
        let kitchen = kitchen.expect("this program wrote the bytes with this library");
        Replay::at(kitchen, self.runner.clone(), self.plays, self.moment).sharing(models)
    }
}

/// The keyframes of one line, shared with the lines that part from it later.
#[derive(Clone, Default)]
pub(super) struct Keyframes(BTreeMap<Moment, Arc<Keyframe>>);

impl Keyframes {
    pub(super) fn has(&self, moment: Moment) -> bool {
        self.0.contains_key(&moment)
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Keeps an instant.
    pub(super) fn keep(&mut self, kitchen: &Kitchen, runner: &Runner, plays: bool, moment: Moment) {
        let keyframe = Keyframe { moment, bytes: kitchen.to_bytes(), runner: runner.clone(), plays };
        self.0.insert(moment, Arc::new(keyframe));
    }

    /// The last one that is not after a moment.
    pub(super) fn before(&self, moment: Moment) -> Option<&Arc<Keyframe>> {
        self.0.range(..=moment).next_back().map(|(_, keyframe)| keyframe)
    }

    /// Those that are not after a moment.
    pub(super) fn until(&self, moment: Moment) -> Self {
        Self(self.0.range(..=moment).map(|(at, keyframe)| (*at, Arc::clone(keyframe))).collect())
    }

    /// Adds those of a line that this one is a part of.
    pub(super) fn join(&mut self, other: Self) {
        self.0.extend(other.0);
    }

    /// The one without which the longest gap is the shortest, and that gap [frames]; of equal ones the oldest. Both ends stay.
    fn least_worth(&self) -> Option<(u64, Arc<Keyframe>)> {
        let all: Vec<&Arc<Keyframe>> = self.0.values().collect();
        let gaps = all.windows(3).map(|w| (w[2].moment.frame - w[0].moment.frame, Arc::clone(w[1])));
        gaps.min_by_key(|(gap, _)| *gap)
    }
}

/// Size of keyframes that lists share [bytes].
pub(super) fn bytes_of<'a>(lists: impl Iterator<Item = &'a mut Keyframes>) -> usize {
    let each: BTreeMap<usize, usize> =
        lists.flat_map(|list| list.0.values().map(|k| (Arc::as_ptr(k) as usize, k.bytes.len()))).collect();
    each.values().sum()
}

/// Drops keyframes where they are closest until the rest keeps to its size.
pub(super) fn thin(timeline: &mut Timeline) {
    while bytes_of(timeline.lists()) > MOST_BYTES {
        let candidates = timeline.lists().filter_map(|list| list.least_worth());
        let Some((_, least)) = candidates.min_by_key(|(gap, _)| *gap) else { return };
        timeline.lists().for_each(|list| list.0.retain(|_, kept| !Arc::ptr_eq(kept, &least)));
    }
}
