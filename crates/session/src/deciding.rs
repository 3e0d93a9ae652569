//! The instant from which a cook is tried again: shortly before the act that decided what was missed.

use saute_plan::goal::Better;

use super::Session;
use crate::hands::Hands;

/// Time before the act [s] (chosen: to see where one is, and to reach the button).
const BEFORE_S: f64 = 8.0;
/// How much earlier food comes out where the judgement does not tell [s] (chosen).
const EARLIER_S: f64 = 60.0;

impl<H: Hands> Session<H> {
    /// Returns the time shortly before the act that decided [s]; none where there is nothing to try again.
    pub fn deciding_s(&self, better: &Better) -> Option<f64> {
        let came_in = self.first("in");
        let at_s = match better {
            Better::RestLonger => None,
            Better::PullEarlier { by_s, .. } => self.came_out_s().map(|out_s| out_s - by_s.unwrap_or(EARLIER_S)),
            Better::PullLater { .. } | Better::LeaveIn { .. } => self.came_out_s(),
            Better::PalerFace { .. } | Better::FlipMoreOften { .. } => self.first("flip").or_else(|| self.came_out_s()),
            Better::HotterPan { .. } | Better::LessCrowded { .. } | Better::DryFaces { .. } => came_in,
            Better::MorePower { .. } | Better::LessPower { .. } => came_in.map(|in_s| in_s + BEFORE_S),
            Better::CoolerPan { .. } => self.most_power_s(),
        };
        at_s.map(|at_s| (at_s - BEFORE_S).max(0.0))
    }

    /// When something was first done, by its label [s].
    fn first(&self, label: &str) -> Option<f64> {
        self.marks.iter().find(|mark| mark.label == label).map(|mark| mark.time_s)
    }

    /// When the hob was last set to the most power that it had [s].
    fn most_power_s(&self) -> Option<f64> {
        let watts = |label: &str| label.strip_suffix(" W").and_then(|w| w.parse::<f64>().ok());
        let powers = self.marks.iter().filter_map(|mark| Some((watts(&mark.label)?, mark.time_s)));
        powers.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, time_s)| time_s)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use saute_kitchen::{Command, Library};
    use std::sync::Arc;

    #[test]
    fn it_is_shortly_before_the_act() {
        let library = Arc::new(Library::embedded().unwrap());
        let mut session: Session = Session::new(library, &Default::default()).unwrap();
        let steak = session.steak().unwrap().id.clone();
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
