//! A device of tests: what it is given goes to the test, block by block, and it fails when the test requests it.

use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

use saute_sound::{Metal, Plate, Snapshot, Steam, Told};
use saute_speaker::{Device, Speaker, Trouble};

/// A block that was played.
pub type Block = Vec<[f32; 2]>;

/// Plays into a channel; it waits while the test takes nothing.
pub struct Tape {
    pub rate: u32,
    pub blocks: SyncSender<Block>,
    /// Blocks until it is unplugged.
    pub left: usize,
}

impl Device for Tape {
    fn rate(&self) -> u32 {
        self.rate
    }

    fn play(&mut self, block: &[[f32; 2]]) -> Result<(), Trouble> {
        self.left = self.left.checked_sub(1).ok_or_else(|| Trouble::Device("unplugged".into()))?;
        self.blocks.send(block.to_vec()).map_err(|_| Trouble::Device("nobody listens".into()))
    }
}

/// Both ends of a tape with the buffer of a device: a few blocks.
pub fn tape() -> (SyncSender<Block>, Receiver<Block>) {
    sync_channel(2)
}

/// A speaker on a tape of a rate, with what it plays.
pub fn speaker_at(rate: u32) -> (Speaker, Receiver<Block>) {
    let (blocks, played) = tape();
    let mut tapes = Some(Tape { rate, blocks, left: usize::MAX });
    let open = move || tapes.take().map(|tape| Box::new(tape) as _).ok_or(Trouble::NoLibrary);
    (Speaker::new(Box::new(open)).expect("a thread"), played)
}

/// A pan in which food fries.
pub fn frying() -> Told {
    let snapshot = Snapshot { floor_c: 180.0, ..Snapshot::default() }.with(Steam::Floor, 1e-4);
    let pan = Plate { metal: Metal::CarbonSteel, radius_m: 0.115, thickness_m: 2.3e-3 };
    Told { snapshot, pan, is_paused: false, volume: 1.0 }
}

/// Takes blocks until one of them sounds; returns how many were silent.
pub fn silent_blocks(played: &Receiver<Block>) -> usize {
    let is_silent = |block: &Block| block.iter().all(|frame| *frame == [0.0; 2]);
    played.iter().take_while(is_silent).count()
}
