//! One of each act and of each setting and card, for tests that walk over all of them.

use std::collections::BTreeMap;

use saute_picture::view::View;
use saute_plan::forecast::Question;
use saute_plan::schedule::senses::Hiss;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;

use super::{Act, AppAct, Card, CookAct, HostAct, LearnAct, Setting, TimeAct, ViewAct};
use crate::act::GuidedAct;
use crate::at_home::AtHomeAct;
use crate::eye::EyeView;
use crate::hands::Role;
use crate::input::pouring::Pourable;
use crate::plan::{PlanAct, PlanFile};
use crate::settings::interface_size::InterfaceSize;
use crate::settings::quality_choice::QualityChoice;
use crate::settings::theme::Theme;
use saute_session::at_home::entered::Cooked;
use saute_session::at_home::open_log::Columns;
use saute_session::export::Export;
use saute_session::hearing::example::Example;
use saute_words::language::Language;

/// Samples with the pattern that each of them represents. What has no sample does not compile.
macro_rules! samples {
    ($kind:ty: $($pattern:pat => $sample:expr),+ $(,)?) => {{
        let _: fn(&$kind) = |sample| match sample { $($pattern => {})+ };
        let mut samples: Vec<$kind> = Vec::new();
        $(
            samples.push($sample);
            assert!(matches!(samples.last(), Some($pattern)), "{:?}", samples.last());
        )+
        samples
    }};
}

/// One of each act.
pub fn samples() -> Vec<Act> {
    let cook = cook().into_iter().map(Act::Cook).chain(time().into_iter().map(Act::Time));
    let seen = cook.chain(view().into_iter().map(Act::View));
    let learn = learn().into_iter().map(Act::Learn);
    seen.chain(learn).chain(app().into_iter().map(Act::App)).collect()
}

fn cook() -> Vec<CookAct> {
    let steak = || vec!["steak".to_owned()];
    let mut all = samples! { CookAct:
        CookAct::Hob(_) => CookAct::Hob(1),
        CookAct::HobSet(_) => CookAct::HobSet(1400.0),
        CookAct::HobHold(_) => CookAct::HobHold(180.0),
        CookAct::Cloth => CookAct::Cloth,
        CookAct::Put => CookAct::Put,
        CookAct::Lay(_) => CookAct::Lay(steak()),
        CookAct::Heap(_) => CookAct::Heap(steak()),
        CookAct::Remove(_) => CookAct::Remove(steak()),
        CookAct::Flip => CookAct::Flip,
        CookAct::Out => CookAct::Out,
        CookAct::Asked(_) => CookAct::Asked(Question::LowerHeat),
        CookAct::Halve => CookAct::Halve,
        CookAct::Toss => CookAct::Toss,
        CookAct::Pour(_) => CookAct::Pour(Pourable::Oil),
        CookAct::Portion => CookAct::Portion,
        CookAct::Lid => CookAct::Lid,
        CookAct::Baste => CookAct::Baste,
        CookAct::Wipe => CookAct::Wipe,
        CookAct::Tool => CookAct::Tool,
        CookAct::ToolBy(_) => CookAct::ToolBy(0.01),
        CookAct::RollBy(_) => CookAct::RollBy(0.1),
        CookAct::LevelTool => CookAct::LevelTool,
        CookAct::PutAway => CookAct::PutAway,
        CookAct::SetOut(_) => CookAct::SetOut(1),
        CookAct::Add(_) => CookAct::Add(1),
        CookAct::Play(_) => CookAct::Play("rare".into()),
        CookAct::ResumeRecipe => CookAct::ResumeRecipe,
        CookAct::Restart => CookAct::Restart,
    };
    all.extend([CookAct::Hob(-1), CookAct::Pour(Pourable::Butter), CookAct::Pour(Pourable::Water)]);
    all.extend([Question::AsItIs, Question::Flip, Question::TakeOut].map(CookAct::Asked));
    all
}

fn time() -> Vec<TimeAct> {
    samples! { TimeAct:
        TimeAct::Pause => TimeAct::Pause,
        TimeAct::Step => TimeAct::Step,
        TimeAct::Speed(_) => TimeAct::Speed(1),
        TimeAct::SpeedSet(_) => TimeAct::SpeedSet(20.0),
        TimeAct::SpeedEased => TimeAct::SpeedEased,
        TimeAct::GoOn(_) => TimeAct::GoOn(true),
        TimeAct::Undo => TimeAct::Undo,
        TimeAct::Redo => TimeAct::Redo,
        TimeAct::Scrub(_) => TimeAct::Scrub(0.0),
        TimeAct::TryFrom(_) => TimeAct::TryFrom(0.0),
        TimeAct::HoldTime(_) => TimeAct::HoldTime(true),
        TimeAct::Branch(_) => TimeAct::Branch(0),
    }
}

fn view() -> Vec<ViewAct> {
    let mut all = samples! { ViewAct:
        ViewAct::NextPiece => ViewAct::NextPiece,
        ViewAct::Select(_) => ViewAct::Select("steak".into()),
        ViewAct::Pieces => ViewAct::Pieces,
        ViewAct::SideBySide => ViewAct::SideBySide,
        ViewAct::View(_) => ViewAct::View(View::Look),
        ViewAct::Split => ViewAct::Split,
        ViewAct::Probe => ViewAct::Probe,
        ViewAct::Placing(_) => ViewAct::Placing(true),
        ViewAct::SelectProbe(_) => ViewAct::SelectProbe(None),
        ViewAct::NameProbe(..) => ViewAct::NameProbe(0, "edge".into()),
        ViewAct::RemoveProbe(_) => ViewAct::RemoveProbe(0),
        ViewAct::Map => ViewAct::Map,
        ViewAct::Scale => ViewAct::Scale,
        ViewAct::Slice => ViewAct::Slice,
        ViewAct::SliceBy(_) => ViewAct::SliceBy(0.05),
        ViewAct::SliceAt(_) => ViewAct::SliceAt(0.0),
        ViewAct::Units => ViewAct::Units,
        ViewAct::Camera => ViewAct::Camera,
        ViewAct::Eye(_) => ViewAct::Eye(EyeView::Front),
        ViewAct::Zoom(_) => ViewAct::Zoom(0.9),
        ViewAct::Orbit(..) => ViewAct::Orbit(0.1, 0.0),
        ViewAct::Pantry => ViewAct::Pantry,
        ViewAct::Curves => ViewAct::Curves,
        ViewAct::Panels => ViewAct::Panels,
        ViewAct::Projector => ViewAct::Projector,
        ViewAct::More => ViewAct::More,
        ViewAct::Strings => ViewAct::Strings,
    };
    all.extend(View::ALL.map(ViewAct::View));
    all.extend([EyeView::Above, EyeView::Food].map(ViewAct::Eye));
    all
}

fn learn() -> Vec<LearnAct> {
    let guided = samples! { GuidedAct:
        GuidedAct::Agree => GuidedAct::Agree,
        GuidedAct::Decline => GuidedAct::Decline,
        GuidedAct::TryMachine => GuidedAct::TryMachine,
        GuidedAct::BeginTrial => GuidedAct::BeginTrial,
        GuidedAct::EndTrial => GuidedAct::EndTrial,
        GuidedAct::Answer(_) => GuidedAct::Answer(BTreeMap::new()),
        GuidedAct::KeepRows => GuidedAct::KeepRows,
        GuidedAct::SaveLog => GuidedAct::SaveLog,
        GuidedAct::Lesson(_) => GuidedAct::Lesson("resting".into()),
        GuidedAct::BeginLesson => GuidedAct::BeginLesson,
        GuidedAct::Predict(_) => GuidedAct::Predict(1.0),
        GuidedAct::GoOn => GuidedAct::GoOn,
        GuidedAct::EndLesson => GuidedAct::EndLesson,
        GuidedAct::SaveResult => GuidedAct::SaveResult,
        GuidedAct::CopyResult => GuidedAct::CopyResult,
        GuidedAct::AgainLesson => GuidedAct::AgainLesson,
        GuidedAct::Leave => GuidedAct::Leave,
        GuidedAct::CloseWindow => GuidedAct::CloseWindow,
    };
    let plan = samples! { PlanAct:
        PlanAct::Choose(_) => PlanAct::Choose(Default::default()),
        PlanAct::Find => PlanAct::Find,
        PlanAct::Stop => PlanAct::Stop,
        PlanAct::CookLive => PlanAct::CookLive,
        PlanAct::CookItself => PlanAct::CookItself,
        PlanAct::Save(_) => PlanAct::Save(PlanFile::Card),
        PlanAct::DoStep => PlanAct::DoStep,
        PlanAct::Hurry => PlanAct::Hurry,
        PlanAct::Leave => PlanAct::Leave,
    };
    let at_home = samples! { AtHomeAct:
        AtHomeAct::Rows(_) => AtHomeAct::Rows(Vec::new()),
        AtHomeAct::Columns(_) => AtHomeAct::Columns(Columns::default()),
        AtHomeAct::Cooked(_) => AtHomeAct::Cooked(Cooked::Plan),
        AtHomeAct::NoLog => AtHomeAct::NoLog,
        AtHomeAct::Fit => AtHomeAct::Fit,
        AtHomeAct::Cancel => AtHomeAct::Cancel,
        AtHomeAct::Keep => AtHomeAct::Keep,
        AtHomeAct::Use(_) => AtHomeAct::Use(false),
        AtHomeAct::Forget => AtHomeAct::Forget,
    };
    let mut all = samples! { LearnAct:
        LearnAct::Tutorial(_) => LearnAct::Tutorial(true),
        LearnAct::Guided(_) => LearnAct::Guided(GuidedAct::GoOn),
        LearnAct::Plan(_) => LearnAct::Plan(PlanAct::Find),
        LearnAct::AtHome(_) => LearnAct::AtHome(AtHomeAct::Fit),
    };
    all.extend(guided.into_iter().map(LearnAct::Guided));
    all.extend(plan.into_iter().map(LearnAct::Plan));
    all.extend(at_home.into_iter().map(LearnAct::AtHome));
    all
}

fn app() -> Vec<AppAct> {
    let mut all = samples! { AppAct:
        AppAct::ChooseFile => AppAct::ChooseFile,
        AppAct::Export(_) => AppAct::Export(Export::Cook),
        AppAct::CopyLink => AppAct::CopyLink,
        AppAct::StopHands => AppAct::StopHands,
        AppAct::Picture => AppAct::Picture,
        AppAct::Photo => AppAct::Photo,
        AppAct::Mirror => AppAct::Mirror,
        AppAct::MirrorWindow(_) => AppAct::MirrorWindow(false),
        AppAct::Calibrate(_) => AppAct::Calibrate(false),
        AppAct::ReadRig => AppAct::ReadRig,
        AppAct::ShareResult => AppAct::ShareResult,
        AppAct::Host(_) => AppAct::Host(HostAct::TimeLapse),
        AppAct::Set(_) => AppAct::Set(Setting::Coach(true)),
        AppAct::Hear(_) => AppAct::Hear(Example::of_hiss(Hiss::Loud)),
        AppAct::Say(_) => AppAct::Say("so it is".into()),
        AppAct::Open(_) => AppAct::Open(Card::Help),
        AppAct::Shut(_) => AppAct::Shut(Card::Help),
        AppAct::Settings => AppAct::Settings,
        AppAct::Help => AppAct::Help,
        AppAct::Messages => AppAct::Messages,
        AppAct::Close => AppAct::Close,
    };
    all.extend(host().into_iter().map(AppAct::Host));
    all.extend(settings().into_iter().map(AppAct::Set));
    all.extend(cards().into_iter().flat_map(|card| [AppAct::Open(card), AppAct::Shut(card)]));
    all.extend([Export::Recipe, Export::Readings].map(AppAct::Export));
    all
}

fn host() -> Vec<HostAct> {
    samples! { HostAct:
        HostAct::OpenFile(_) => HostAct::OpenFile("a.toml".into()),
        HostAct::ShowFile(_) => HostAct::ShowFile("a.toml".into()),
        HostAct::ResumeHands => HostAct::ResumeHands,
        HostAct::Connect { .. } => HostAct::Connect { role: Role::Pan, device: "spidar-pan".into(), pairing: 0 },
        HostAct::Disconnect(_) => HostAct::Disconnect(Role::Turner),
        HostAct::SetPhoto(_) => HostAct::SetPhoto(Default::default()),
        HostAct::TimeLapse => HostAct::TimeLapse,
    }
}

/// One of each setting.
fn settings() -> Vec<Setting> {
    samples! { Setting:
        Setting::Theme(_) => Setting::Theme(Theme::Light),
        Setting::White(_) => Setting::White(WhiteBalance::Neutral),
        Setting::Light(_) => Setting::Light(RoomLight::Evening),
        Setting::Quality(_) => Setting::Quality(QualityChoice::Automatic),
        Setting::Language(_) => Setting::Language(Language::ENGLISH.next()),
        Setting::Fahrenheit(_) => Setting::Fahrenheit(true),
        Setting::Size(_) => Setting::Size(InterfaceSize::Large),
        Setting::LessMotion(_) => Setting::LessMotion(true),
        Setting::Scale(_) => Setting::Scale("beef".into()),
        Setting::Goal(_) => Setting::Goal(55.0),
        Setting::GoalNamed(_) => Setting::GoalNamed("medium".into()),
        Setting::Coach(_) => Setting::Coach(false),
        Setting::ResultOpens(_) => Setting::ResultOpens(false),
        Setting::SkillMode(_) => Setting::SkillMode(true),
        Setting::Choice(_) => Setting::Choice(Default::default()),
        Setting::Forecasts(_) => Setting::Forecasts(false),
        Setting::Mirror(_) => Setting::Mirror(Default::default()),
        Setting::Sound(_) => Setting::Sound(false),
        Setting::Volume(_) => Setting::Volume(0.2),
    }
}

/// All cards.
fn cards() -> Vec<Card> {
    samples! { Card:
        Card::Help => Card::Help,
        Card::Settings => Card::Settings,
        Card::Messages => Card::Messages,
        Card::Mirror => Card::Mirror,
        Card::FirstSteps => Card::FirstSteps,
        Card::Learn => Card::Learn,
        Card::Files => Card::Files,
        Card::Lessons => Card::Lessons,
        Card::Goals => Card::Goals,
        Card::Result => Card::Result,
        Card::Plan => Card::Plan,
        Card::AtHome => Card::AtHome,
    }
}
