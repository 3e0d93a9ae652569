//! What each panel reads of the app.

use saute_plan::schedule::voice::Keeping;

use super::SauteApp;
use super::desk::Desk;
use super::findings::Findings;
use super::hands::Inputs;
use super::leads::Leads;
use super::sights::Sights;
use crate::host::CurrentHost;
use crate::panels::Parts;
use crate::panels::at_home::at_home_state::AtHomeState;
use crate::panels::cards::mirror::MirrorState;
use crate::panels::cards::settings::SettingsState;
use crate::panels::cook::cook_state::CookState;
use crate::panels::inside::InsideState;
use crate::panels::memory::PanelMemory;
use crate::panels::top::TopState;
use crate::panels::ways::way_words;
use saute_controls::context::PanelContext;
use saute_controls::now::now_state::NowState;
use saute_controls::plan::plan_state::PlanState;
use saute_controls::ways_state::WaysState;

impl SauteApp {
    /// What each panel reads in a frame, and what panels keep.
    pub(crate) fn parts<'a>(&'a mut self, found: &'a Findings) -> (Parts<'a>, &'a mut PanelMemory) {
        let Self { session, settings, sights, inputs, leads, desk, pace, graphics, host, .. } = self;
        let Desk { card, notice, memory } = desk;
        let context = PanelContext { session, settings, guided: leads.guided.as_ref() };
        let parts = Parts {
            context,
            host,
            scene: &sights.scene,
            card: *card,
            unfinished_s: found.unfinished_s,
            said: notice,
            notice: notice.current(),
            waiting: pace.waiting.iter().map(|waiting| waiting.words(settings.language)).collect(),
            result: found.result.as_ref(),
            top: TopState { context, card: *card, is_cut: sights.slice.is_some() },
            now: now(context, leads, found, card.is_some()),
            cook: cook(context, host, inputs, found),
            inside: inside(context, sights, found),
            ways: ways(context, sights, found),
            settings: SettingsState { context, quality: found.quality, japanese_font: graphics.japanese_font },
            mirror: MirrorState { context, mirror: &sights.mirror },
            plan: PlanState { context, planning: &leads.planning },
            at_home: AtHomeState { context, at_home: &leads.at_home },
        };
        (parts, memory)
    }
}

fn now<'a>(context: PanelContext<'a>, leads: &'a Leads, found: &'a Findings, card_is_open: bool) -> NowState<'a> {
    NowState {
        context,
        advice: &found.advice,
        rise: found.rise,
        alarm: found.alarm,
        live: leads.live.as_ref().filter(|live| live.is_of(context.session)),
        guide_leads: found.keeping == Some(Keeping::Kept),
        tutorial: leads.learn.tutorial.as_ref(),
        card_is_open,
    }
}

fn cook<'a>(context: PanelContext<'a>, host: &'a CurrentHost, inputs: &Inputs, found: &'a Findings) -> CookState<'a> {
    CookState {
        context,
        host,
        tool: inputs.tool_hand.tool,
        turner_in_hand: inputs.tool_hand.turner.is_some(),
        portion: inputs.portion,
        advised_w: found.advice.iter().find_map(|one| one.hob_w()),
        coaching: found.coaching.as_ref(),
        side_by_side: found.side_by_side,
    }
}

fn inside<'a>(context: PanelContext<'a>, sights: &Sights, found: &'a Findings) -> InsideState<'a> {
    InsideState {
        context,
        cut_at: sights.slice.unwrap_or(0.0),
        placing: sights.scene.placing,
        heard: found.heard,
        coaching: found.coaching.as_ref(),
        guide_leads: found.keeping == Some(Keeping::Kept),
    }
}

fn ways<'a>(context: PanelContext<'a>, sights: &Sights, found: &Findings) -> WaysState<'a> {
    let (session, l) = (context.session, context.settings.language);
    let (ways, names) = match found.side_by_side {
        true => (session.ways(), session.way_names()),
        false => Default::default(),
    };
    let names = names.into_iter().map(|(id, name)| (id, way_words(&name, l))).collect();
    WaysState { context, ways, names, cut_at: sights.slice.unwrap_or(0.0) }
}
