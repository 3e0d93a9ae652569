//! What the window's owner reads and sets from outside: the page, measurements and tests.

use super::SauteApp;
use super::on_host::OnHost;
use saute_controls::act::Card;
use saute_controls::session::Session;
use saute_controls::settings::Settings;
use saute_picture::frame_meter::FrameMeter;
use saute_session::work::{Agency, Helper, WorkKind};
use saute_words::language::Language;

impl SauteApp {
    /// The world behind the window.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The world behind the window, to drive it from outside.
    pub fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The settings that are remembered.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Lets an agency find helpers for heavy work from now on: each kind of work gets its own.
    pub fn employ(&mut self, agency: Box<dyn Agency>) {
        self.session.employ(agency.hire(WorkKind::Play, &self.session.library));
        self.session.employ_for_forecasts(agency.hire(WorkKind::Forecast, &self.session.library));
        self.agency = Some(agency);
    }

    /// Hires a helper for a kind of work; none where there is no agency.
    pub fn hire(&self, kind: WorkKind) -> Option<Box<dyn Helper>> {
        self.agency.as_ref().map(|agency| agency.hire(kind, &self.session.library))
    }

    /// Place of the cut (−1…1), or none.
    pub fn slice(&self) -> Option<f64> {
        self.sights.slice
    }

    /// Returns true if Tab, or Shift+Tab for `back`, leaves the picture now: no control has the focus, and forward the last one had
    /// it.
    pub fn tab_leaves(&mut self, back: bool) -> bool {
        self.inputs.tab_end.leaves(back)
    }

    /// Chooses how many pieces the pantry adds at once.
    pub fn set_count(&mut self, count: usize) {
        self.desk.memory.pantry.count = count;
    }

    /// Chooses the window's language; a page without a font for Japanese requests one from its host first.
    pub fn set_language(&mut self, language: Language) {
        if !self.waits_for_font(language) {
            self.settings.language = language;
        }
    }

    /// What the guide states in a cook that follows a plan.
    pub fn guidance(&self) -> Option<saute_session::plan::live::Guidance> {
        let live = self.leads.live.as_ref().filter(|live| live.is_of(&self.session))?;
        Some(live.guidance(&self.session))
    }

    /// What was entered about the kitchen at home, and the fit to it.
    pub fn at_home(&self) -> &saute_session::at_home::fitting::AtHome {
        &self.leads.at_home
    }

    /// Returns true if the card of the first steps is shown.
    pub fn first_steps_are_open(&self) -> bool {
        self.desk.card == Some(Card::FirstSteps)
    }

    /// Returns true if the list of keys is open.
    pub fn help_is_open(&self) -> bool {
        self.desk.card == Some(Card::Help)
    }

    /// Returns true if the card of the settings is open.
    pub fn settings_are_open(&self) -> bool {
        self.desk.card == Some(Card::Settings)
    }

    /// All notices, the last first.
    pub fn said(&self) -> Vec<String> {
        self.desk.notice.all().into_iter().map(|said| said.text).collect()
    }

    /// How fast frames and simulated time have run lately.
    pub fn meter(&self) -> &FrameMeter {
        &self.pace.meter
    }

    /// Size at which the scene was drawn last [pixels].
    pub fn scene_size(&self) -> [u32; 2] {
        self.sights.scene.drawn_size
    }

    /// Returns true if the picture stays as it is until something happens: nothing moves, and nothing is left to smooth.
    pub fn rests(&self) -> bool {
        self.sights.scene.rests
    }
}
