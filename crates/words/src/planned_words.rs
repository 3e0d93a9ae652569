//! The result of a cook of a plan in words: measured by what the plan promised, not by what another cook could have given.

use saute_plan::goal::mark::Mark;
use saute_plan::schedule::kept::Kept;
use saute_plan::schedule::{Deed, Plan};

use crate::judgement_words::{ResultWords, span};
use crate::language::Language;
use crate::mark_words::whole;
use crate::speech::Speech;
use crate::{cue_words, plan_words};

impl ResultWords {
    /// The words for a cook of a plan, given how well it was kept to.
    pub fn of_plan(mut self, plan: &Plan, kept: &Kept, speech: Speech) -> Self {
        let l = speech.language;
        let goal = plan_words::target(&plan.order.goal, speech);
        let key = match (self.is_met, kept) {
            (true, Kept::AsPlanned) => "planned.met",
            (true, _) => "result.met",
            (false, _) => "result.missed",
        };
        self.verdict = l.fill(key, &[("goal", &goal)]);
        let promised = whole(&Mark::of(&plan.promised, &plan.order.goal));
        self.mark = l.fill("planned.mark", &[("mark", &self.mark), ("promised", &promised)]);
        self.better[1] = better(kept, plan, l);
        self
    }
}

/// The one thing to do better: of a plan, to keep to it.
fn better(kept: &Kept, plan: &Plan, l: Language) -> String {
    let off = |key, deed: &Deed, late_s: f64| {
        l.fill(key, &[("deed", &cue_words::deed(deed, l)), ("time", &span(late_s.abs(), l))])
    };
    match kept {
        Kept::AsPlanned if plan.shortfalls().is_empty() => l.text("planned.as_planned").to_owned(),
        Kept::AsPlanned => l.text("planned.best_found").to_owned(),
        Kept::OffTime { deed, late_s: None } => l.fill("planned.left_out", &[("deed", &cue_words::deed(deed, l))]),
        Kept::OffTime { deed, late_s: Some(late_s) } if *late_s < 0.0 => off("planned.early", deed, *late_s),
        Kept::OffTime { deed, late_s: Some(late_s) } => off("planned.late", deed, *late_s),
        Kept::Otherwise => l.text("planned.otherwise").to_owned(),
    }
}
