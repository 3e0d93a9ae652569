//! The instant from which a cook is tried again: shortly before the act that decided what was missed.

use saute_kitchen::Command;
use saute_plan::goal::Better;
use saute_recipe::session::Done;

use super::Session;
use super::mark::Mark;
use crate::hands::Hands;

/// Time before the act [s] (chosen: to see where one is, and to reach the button).
const BEFORE_S: f64 = 8.0;
/// How much earlier food comes out where the judgement does not state it [s] (chosen).
const EARLIER_S: f64 = 60.0;

impl<H: Hands> Session<H> {
    /// Returns the time shortly before the act that decided [s]; none where there is nothing to try again.
    pub fn deciding_s(&self, better: &Better) -> Option<f64> {
        let came_in = self.first(Mark::is_put);
        let at_s = match better {
            Better::RestLonger => None,
            Better::PullEarlier { by_s, .. } => self.came_out_s().map(|out_s| out_s - by_s.unwrap_or(EARLIER_S)),
            Better::PullLater { .. } | Better::LeaveIn { .. } => self.came_out_s(),
            Better::PalerFace { .. } | Better::FlipMoreOften { .. } => {
                self.first(Mark::is_flip).or_else(|| self.came_out_s())
            }
            Better::HotterPan { .. } | Better::LessCrowded { .. } | Better::DryFaces { .. } => came_in,
            Better::MorePower { .. } | Better::LessPower { .. } => came_in.map(|in_s| in_s + BEFORE_S),
            Better::CoolerPan { .. } => self.most_power_s(),
        };
        at_s.map(|at_s| (at_s - BEFORE_S).max(0.0))
    }

    /// When something was first done [s].
    fn first(&self, is_it: fn(&Mark) -> bool) -> Option<f64> {
        self.marks.iter().find(|mark| is_it(mark)).map(|mark| mark.time_s)
    }

    /// When the hob was last set to the most power that it had [s].
    fn most_power_s(&self) -> Option<f64> {
        let power = |mark: &Mark| match mark.done {
            // Whole watts, as they are shown: what looks the same is the same.
            Done::Command(Command::Hob(w)) => Some((w.round(), mark.time_s)),
            _ => None,
        };
        self.marks.iter().filter_map(power).max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, time_s)| time_s)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use saute_kitchen::Library;
    use std::sync::Arc;

    #[test]
    fn it_is_shortly_before_the_act() {
        let library = Arc::new(Library::embedded().unwrap());
        let mut session: Session = Session::new(library, &Default::default()).unwrap();
        let steak = session.shown_piece().unwrap().id.clone();
        let cook = |session: &mut Session, s: usize| (0..10 * s).for_each(|_| session.tick().unwrap());
        session.command(&Command::Hob(1100.0)).unwrap();
        cook(&mut session, 20);
        session.command(&Command::Put { food: steak.clone(), at: [0.0; 2], heap: false }).unwrap();
        cook(&mut session, 20);
        session.command(&Command::Hob(2000.0)).unwrap();
        cook(&mut session, 10);
        session.command(&Command::Flip { food: steak }).unwrap();
        let near = |better: &Better, s: f64| {
            let at_s = session.deciding_s(better).unwrap();
            assert!((at_s - (s - BEFORE_S)).abs() < 0.2, "{better:?}: {at_s}");
        };
        near(&Better::HotterPan { had_c: 60.0, until_c: 180.0 }, 20.0);
        near(&Better::CoolerPan { had_c: 300.0, most_c: 250.0 }, 40.0);
        near(&Better::PalerFace { faces_pct: [10.0, 90.0] }, 50.0);
        assert_eq!(session.deciding_s(&Better::PullLater { by: 3.0, by_s: None }), None, "it never came out");
        assert_eq!(session.deciding_s(&Better::RestLonger), None);
    }
}
