//! Frames: rigid bodies, tools and gestures advance in each frame; heat and mass transfer in each tick.

use crate::dynamics::{Ended, PanTarget, RIGID_HZ, RIGID_S, Task};
use crate::kitchen::Kitchen;

/// Rigid steps in a frame [-].
const STEPS_PER_FRAME: u32 = RIGID_HZ / 60;

impl Kitchen {
    /// Advances the kitchen to its next tick.
    pub fn step(&mut self) {
        while !self.advance_frame() {}
    }

    /// Advances the kitchen by one frame of [`crate::FRAME_S`]. Bodies and tools move in each frame; heat flows and foods
    /// change in every sixth. Returns true if the frame ended a tick.
    pub fn advance_frame(&mut self) -> bool {
        self.take_up_task();
        let mut moved = false;
        for _ in 0..STEPS_PER_FRAME {
            if self.is_at_rest() {
                break;
            }
            self.rigid_step();
            moved = true;
        }
        if moved {
            self.follow_bodies();
        }
        self.end_frame()
    }

    /// As [`Self::advance_frame`], with a partner, as another simulator is: before each rigid step of 1/240 s it reads the kitchen as
    /// the last one left it, and may send commands.
    pub fn advance_frame_with(&mut self, mut partner: impl FnMut(&mut Self)) -> bool {
        self.take_up_task();
        for _ in 0..STEPS_PER_FRAME {
            partner(self);
            if !self.is_at_rest() {
                self.rigid_step();
                self.follow_bodies();
            }
        }
        self.end_frame()
    }

    /// Counts the frame, and lets heat flow if it ended a tick; returns true then.
    fn end_frame(&mut self) -> bool {
        let is_tick = self.clock.count_frame();
        if is_tick {
            self.heat_tick();
        }
        is_tick
    }

    /// Returns true if nothing moves or is about to: no rigid step is computed then.
    fn is_at_rest(&self) -> bool {
        self.world.is_settled()
            && self.pan_hold.gesture.is_none()
            && !self.second_hand.hand.is_active()
            && self.is_home()
    }

    fn is_home(&self) -> bool {
        self.world.motion.is_still() && self.world.motion.pose == self.pan_hold.pose
    }

    fn rigid_step(&mut self) {
        let target = self.pan_target();
        self.follow_lead();
        if let Some(ended) = self.second_hand.hand.step(&mut self.world) {
            self.end_task(ended);
        }
        self.second_hand.hand.place_blade(&mut self.world);
        self.world.step(&target);
    }

    /// Copies the poses of the rigid bodies to the pieces.
    fn follow_bodies(&mut self) {
        for piece in self.pieces.iter_mut().filter(|p| p.is_out()) {
            if let Some(pose) = self.world.pose(piece.key) {
                piece.pose = pose;
            }
        }
    }

    /// Target of the pan in this step: the gesture's present pose, or the pose at which the pan is held. A toss begins once the
    /// second hand has done its orders: no food flies from under a turner.
    fn pan_target(&mut self) -> PanTarget {
        let standing = PanTarget { pose: self.pan_hold.pose, ..PanTarget::default() };
        let waits = self.pan_hold.waits() && self.second_hand.has_order();
        let Some((gesture, since)) = &mut self.pan_hold.gesture else { return standing };
        if waits {
            return standing;
        }
        *since += RIGID_S;
        let (gesture, since) = (*gesture, *since);
        if since >= gesture.duration_s() {
            self.pan_hold.gesture = None;
            return standing;
        }
        gesture.target(&self.pan_hold.pose, since)
    }

    fn take_up_task(&mut self) {
        if self.second_hand.current.is_some() || self.second_hand.hand.is_active() {
            return;
        }
        if let Some(task) = self.second_hand.tasks.pop_front() {
            let legs = task.legs(&self.world);
            if !legs.is_empty() {
                let spared = matches!(task, Task::Flip { .. }).then(|| task.key());
                self.second_hand.hand.begin(task.tool(&self.world), legs, spared, &self.world);
                self.second_hand.current = Some(task);
            }
        }
    }

    fn end_task(&mut self, ended: Ended) {
        if let Some(task) = self.second_hand.current.take()
            && ended == Ended::Blocked
        {
            self.second_hand.blocked.push(task);
        }
    }
}
