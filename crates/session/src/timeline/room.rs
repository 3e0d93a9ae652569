//! Room for keyframes: they are packed where they need much of it, and dropped where they need more.

use std::sync::Arc;

use super::Timeline;
use super::keyframes::{MOST_BYTES, Packing, bytes_of};
use super::packed::{Packed, Stored};

/// Size of all keyframes from which on they are packed [bytes] (chosen: a usual cook of one steak needs no packing).
const PACKED_FROM: usize = MOST_BYTES / 2;

impl Timeline {
    /// Drops keyframes where they are closest until the rest keeps to its size. Call it when keyframes were added.
    pub(super) fn thin(&mut self) {
        while self.weigh() > MOST_BYTES {
            let candidates = self.lists().filter_map(|list| list.least_worth());
            let Some((_, least)) = candidates.min_by_key(|(gap, _)| *gap) else { return };
            self.lists().for_each(|list| list.0.retain(|_, kept| !Arc::ptr_eq(kept, &least)));
        }
    }

    /// Packs a part of a keyframe where all of them need much room.
    pub(super) fn pack_on(&mut self) {
        if self.packing.is_none() && self.is_narrow {
            let plain = self.lists().find_map(|list| list.plain().cloned());
            self.packing = plain.map(|keyframe| Packing { keyframe, packed: Packed::default() });
        }
        let Some(packing) = &mut self.packing else { return };
        let Stored::Plain(bytes) = &packing.keyframe.stored else { return };
        if packing.packed.pack_on(bytes)
            && let Some(Packing { keyframe, packed }) = self.packing.take()
        {
            let packed = Arc::new(keyframe.stored_as(Stored::Packed(packed)));
            for kept in self.lists().flat_map(|list| list.0.values_mut()).filter(|kept| Arc::ptr_eq(kept, &keyframe)) {
                *kept = Arc::clone(&packed);
            }
            self.weigh();
        }
    }

    /// Size of all keyframes [bytes]; notes whether that is much.
    fn weigh(&mut self) -> usize {
        let size = bytes_of(self.lists());
        self.is_narrow = size > PACKED_FROM;
        size
    }
}
