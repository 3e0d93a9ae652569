//! Keyframes: instants of a cook that are kept whole.

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_kitchen::bytes::Models;
use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Moment, Recipe, Replay, Runner};
use web_time::Duration;

use super::packed::{Packed, Stored};
use crate::playback::Stop;

/// Size of all keyframes at most [bytes] (chosen: a page has little memory, which never shrinks).
pub const MOST_BYTES: usize = if cfg!(target_arch = "wasm32") { 8 << 20 } else { 256 << 20 };

/// Computing time between two keyframes (chosen: to reach any instant from a keyframe takes a part of a second).
pub(super) const COMPUTED_PER_KEYFRAME: Duration = Duration::from_millis(250);

/// An instant that is kept whole; models are shared.
pub(super) struct Keyframe {
    pub(super) moment: Moment,
    pub(super) stored: Stored,
    runner: Runner,
    plays: bool,
}

impl Keyframe {
    pub(super) fn stored_as(&self, stored: Stored) -> Self {
        Self { moment: self.moment, stored, runner: self.runner.clone(), plays: self.plays }
    }

    /// Returns its kitchen, from which a recording can be played on.
    pub(super) fn replay(&self, library: &Library, models: &mut Models) -> Replay {
        let kitchen = Kitchen::from_bytes_with(&self.stored.bytes(), library, models);
        let kitchen = kitchen.expect("this program wrote the bytes with this library");
        Replay::at(kitchen, self.runner.clone(), self.plays, self.moment).sharing(models)
    }
}

/// The keyframes of one line, shared with the lines that part from it later.
#[derive(Clone, Default)]
pub(super) struct Keyframes(pub(super) BTreeMap<Moment, Arc<Keyframe>>);

impl Keyframes {
    pub(super) fn has(&self, moment: Moment) -> bool {
        self.0.contains_key(&moment)
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Keeps an instant.
    pub(super) fn keep(&mut self, kitchen: &Kitchen, runner: &Runner, plays: bool, moment: Moment) {
        let stored = Stored::Plain(kitchen.to_bytes());
        let keyframe = Keyframe { moment, stored, runner: runner.clone(), plays };
        self.0.insert(moment, Arc::new(keyframe));
    }

    /// Keeps an instant that was played elsewhere.
    pub(super) fn keep_stop(&mut self, stop: &Stop, recipe: &Arc<Recipe>) {
        let (moment, kitchen, runner, plays) = stop.instant(recipe);
        self.0
            .entry(moment)
            .or_insert_with(|| Arc::new(Keyframe { moment, stored: Stored::Plain(kitchen.to_vec()), runner, plays }));
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

    /// The gap between two of them in the middle of all gaps [frames].
    pub(super) fn usual_gap(&self) -> u64 {
        let frames: Vec<u64> = self.0.keys().map(|moment| moment.frame).collect();
        let mut gaps: Vec<u64> = frames.windows(2).map(|pair| pair[1] - pair[0]).collect();
        gaps.sort_unstable();
        gaps.get(gaps.len() / 2).copied().unwrap_or(0)
    }

    /// The first one that is not packed.
    pub(super) fn plain(&self) -> Option<&Arc<Keyframe>> {
        self.0.values().find(|keyframe| matches!(keyframe.stored, Stored::Plain(_)))
    }

    /// The one without which the longest gap is the shortest, and that gap [frames]; of equal ones the oldest. Both ends stay.
    pub(super) fn least_worth(&self) -> Option<(u64, Arc<Keyframe>)> {
        let all: Vec<&Arc<Keyframe>> = self.0.values().collect();
        let gaps = all.windows(3).map(|w| (w[2].moment.frame - w[0].moment.frame, Arc::clone(w[1])));
        gaps.min_by_key(|(gap, _)| *gap)
    }
}

/// Size of keyframes that lists share [bytes].
pub(super) fn bytes_of<'a>(lists: impl Iterator<Item = &'a mut Keyframes>) -> usize {
    let each: BTreeMap<usize, usize> =
        lists.flat_map(|list| list.0.values().map(|k| (Arc::as_ptr(k) as usize, k.stored.size()))).collect();
    each.values().sum()
}

/// A keyframe that is being packed.
pub(super) struct Packing {
    pub(super) keyframe: Arc<Keyframe>,
    pub(super) packed: Packed,
}
