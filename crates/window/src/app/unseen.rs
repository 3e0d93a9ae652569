//! Time is stopped while nobody sees the window: a steak does not burn in a tab that is hidden.

use super::SauteApp;
use saute_session::permits::Permit;

impl SauteApp {
    /// Notes that the window is seen, or no longer: unseen, time stops. Seen again, it stays stopped until the cook goes on, and a notice
    /// states that; where a study or a lesson locks the pause it goes on at once.
    pub fn be_seen(&mut self, seen: bool) {
        if !seen {
            let runs = !self.session.paused;
            self.pace.stopped_unseen |= runs;
            self.session.set_paused(true);
        } else if std::mem::take(&mut self.pace.stopped_unseen) {
            let is_locked = !self.permits().allow(&[Permit::Pause]);
            self.session.set_paused(!is_locked);
            // What passed meanwhile is no slowness of the machine.
            self.pace.last_time = None;
            self.say(if is_locked { "notice.was_hidden" } else { "notice.hidden" });
        }
    }
}
