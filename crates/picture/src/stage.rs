//! Sets the scene: a kitchen becomes what the renderer draws.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{Mat4, Quat, Vec2, Vec3};
use saute_kitchen::dynamics::Tool;
use saute_kitchen::food::colour::decoded;
use saute_kitchen::food::{Face, Scale};
use saute_kitchen::heat::Layout;
use saute_kitchen::sear_lines::SearLines;
use saute_kitchen::{Kitchen, Piece, Place, RestOn, celsius};
use saute_scene::camera::Camera;
use saute_scene::input::{
    Colouring, FLOOR_FIELD_RINGS, FoodLook, FoodVertex, HobLook, LidLook, PanLook, RACK_HEIGHT, RestKind, RestLook,
    SEAR_SETS, SceneInput, SearLook, SteamSource, ToolKind, ToolLook, Vapour,
};
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::mesh::props::{BOARD_CENTRE, CLOTH_PLACE};

use crate::colour::map::{ColourMap, TemperatureMap};
use crate::cut::face::slice;
use crate::cut::path::path_cut;
use crate::pan::film::PanFilm;
use crate::pan::spatter::Spots;
use crate::pan::tint::PanTint;
use crate::skin::halves::opened;
use crate::skin::surface::Skin;
use crate::view::View;
use crate::waiting::waiting_places;

/// How the picture is wanted: unless said otherwise the whole food as the eye sees it, from the working view.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StageOptions {
    /// The eye.
    pub camera: Camera,
    /// What the colours mean.
    pub view: View,
    /// Which map shows temperatures.
    pub map: TemperatureMap,
    /// The scale of doneness; none where no scale says anything about the food.
    pub scale: Option<Arc<Scale>>,
    /// The cut: distance along the longest axis from the centroid over half the length (−1…1); none for no cut.
    pub slice: Option<f64>,
    /// The piece that is cut; all of them unless one is named.
    pub cut: Option<String>,
    /// What the look calls white.
    pub white_balance: WhiteBalance,
    /// Unlit, exactly decodable colours.
    pub flat: bool,
}

/// Angle of the eye about the vertical axis when the cut is opened [rad] (chosen: the face is seen at a slant, the pan
/// stays in view).
pub const CUT_YAW: f32 = 0.62;

/// Where a piece is and how it is turned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Origin of its body [m].
    pub position: Vec3,
    /// How it is turned.
    pub rotation: Quat,
}

impl Pose {
    /// The pose that the kitchen's bodies say.
    fn of(piece: &Piece) -> Self {
        // The bodies know no rack: it lifts what lies on it in the picture.
        let lift = if piece.place == Place::Rest(RestOn::Rack) { RACK_HEIGHT } else { 0.0 };
        let bent = 0.5 * piece.state.stretch.dome.abs() as f32;
        let raised = piece.pose.position.as_vec3() + Vec3::Z * (lift + bent);
        Self { position: raised, rotation: piece.pose.rotation.as_quat() }
    }

    /// The pose of a rigid body of the kitchen.
    pub fn of_body(pose: &saute_kitchen::dynamics::Pose) -> Self {
        Self { position: pose.position.as_vec3(), rotation: pose.rotation.as_quat() }
    }

    /// Maps the rest frame to the world.
    pub fn matrix(&self) -> Mat4 {
        Mat4::from_rotation_translation(self.rotation, self.position)
    }

    /// This pose carried along with a frame that goes from one pose to another.
    fn carried(&self, from: &Self, to: &Self) -> Self {
        let turn = to.rotation * from.rotation.inverse();
        Self {
            position: to.position + turn * (self.position - from.position),
            rotation: (turn * self.rotation).normalize(),
        }
    }
}

/// Where every piece is, in their order: as the kitchen's bodies lie; what waits lies on the board, and what is in a pan on
/// the cloth lies there.
pub fn poses(kitchen: &Kitchen) -> Vec<Pose> {
    let waiting = waiting_places(kitchen);
    let (bodies, drawn) = (body_of_pan(kitchen), pan_pose(kitchen));
    let pose = |(index, piece): (usize, &Piece)| match piece.place {
        Place::Waiting => waiting.get(&index).copied().unwrap_or_default(),
        Place::Pan(_) if bodies != drawn => Pose::of(piece).carried(&bodies, &drawn),
        _ => Pose::of(piece),
    };
    kitchen.pieces().iter().enumerate().map(pose).collect()
}

/// Where things are in the picture while they are on their way; elsewhere the kitchen tells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    /// Pieces, by id.
    pub pieces: BTreeMap<String, Pose>,
    /// The pan: the centre of its underside.
    pub pan: Option<Pose>,
    /// The point of the hob's plane that the eye has followed the pan to [m]; where the pan is unless given.
    pub followed: Option<Vec3>,
}

impl Places {
    /// Where a piece is.
    pub fn piece(&self, kitchen: &Kitchen, piece: &Piece) -> Pose {
        let index = kitchen.pieces().iter().position(|p| p.id == piece.id);
        index.and_then(|i| self.all(kitchen).get(i).copied()).unwrap_or_default()
    }

    /// Where all pieces are, in their order; what lies in the pan is carried along with it.
    pub fn all(&self, kitchen: &Kitchen) -> Vec<Pose> {
        let (stands, drawn) = (pan_pose(kitchen), self.pan(kitchen));
        let pose = |(piece, pose): (&Piece, Pose)| match self.pieces.get(&piece.id) {
            Some(moving) => *moving,
            None if piece.in_pan() && stands != drawn => pose.carried(&stands, &drawn),
            None => pose,
        };
        kitchen.pieces().iter().zip(poses(kitchen)).map(pose).collect()
    }

    /// Where the pan is.
    pub fn pan(&self, kitchen: &Kitchen) -> Pose {
        self.pan.unwrap_or_else(|| pan_pose(kitchen))
    }

    /// Where the eye goes along to [m].
    pub fn followed(&self, kitchen: &Kitchen) -> Vec3 {
        self.followed.unwrap_or_else(|| self.pan(kitchen).position)
    }
}

/// How much of the pan's way the eye goes along [-] (chosen: hob and pan stay in view), and of its lift.
const EYE_FOLLOWS: f32 = 0.62;
const EYE_RISES: f32 = 0.35;

/// The eye follows the pan.
pub fn following(camera: &Camera, pan: Vec3) -> Camera {
    let share = Vec3::new(EYE_FOLLOWS, EYE_FOLLOWS, EYE_RISES);
    Camera { target: camera.target + pan.with_z(pan.z.max(0.0)) * share, ..camera.clone() }
}

/// Where the pan stands in the picture: the centre of its underside.
pub fn pan_pose(kitchen: &Kitchen) -> Pose {
    if kitchen.cloth().is_some() {
        return Pose { position: CLOTH_PLACE, rotation: Quat::IDENTITY };
    }
    body_of_pan(kitchen)
}

fn body_of_pan(kitchen: &Kitchen) -> Pose {
    let floor = Pose::of_body(&kitchen.world().motion.pose);
    let thickness = kitchen.world().pan_shape().thickness as f32;
    Pose { position: floor.position - floor.rotation * Vec3::Z * thickness, ..floor }
}

/// Keeps the skins of the pieces between frames.
#[derive(Clone, Debug, Default)]
pub struct Stage {
    skins: BTreeMap<String, Worn>,
    film: PanFilm,
    tint: PanTint,
    spots: Spots,
    /// Where the next round of refreshing begins.
    round: usize,
    /// The kitchen's tick of the last round.
    refreshed: Option<u64>,
    /// The colours of the view, and what they were made for.
    colours: Option<(Shades, ColourMap)>,
}

/// View, colour map of temperatures and id of the scale of doneness.
type Shades = (View, TemperatureMap, Option<String>);

/// A skin with the vertices it has now.
#[derive(Clone, Debug)]
struct Worn {
    model: usize,
    skin: Skin,
    vertices: Arc<Vec<FoodVertex>>,
    /// What the vertices were made for.
    fresh_for: Option<Fresh>,
}

/// State and view that vertices show.
#[derive(Clone, Debug, PartialEq)]
struct Fresh {
    ticks: u64,
    view: View,
    map: TemperatureMap,
    scale: Option<String>,
}

/// A state this much older than shown is not yet worth new vertices, where there are many pieces [ticks] (chosen: 0.5 s).
const STALE_TICKS: u64 = 5;
/// Pieces of which every one is shown as it is in every frame (chosen).
const ALWAYS_FRESH: usize = 6;

impl Stage {
    /// Describes one frame.
    pub fn scene(&mut self, kitchen: &Kitchen, options: &StageOptions, places: &Places) -> SceneInput {
        let pan = places.pan(kitchen);
        let map = self.colours(options);
        self.refresh(kitchen, options, map.as_ref());
        let poses = places.all(kitchen);
        let looks = kitchen.pieces().iter().zip(&poses);
        let look = PanLook {
            position: pan.position,
            rotation: pan.rotation,
            film: self.film.picture(kitchen),
            tint: self.tint.picture(kitchen),
            ..pan_look(kitchen, options.view, map.as_ref())
        };
        let spatter = self.spots.look(kitchen, &look);
        SceneInput {
            camera: following(&options.camera, places.followed(kitchen)),
            hob: HobLook { power: (kitchen.drawn_w() / 2000.0).min(1.0) as f32 },
            pan: look,
            foods: looks.flat_map(|(piece, pose)| self.food(piece, pose, options, map.as_ref())).collect(),
            tool: tool(kitchen),
            strings: Vec::new(),
            rest: kitchen.pieces().iter().find_map(rest_look),
            steam: steam(kitchen, &pan, &poses),
            spatter,
            time_s: kitchen.time_s() as f32,
            colouring: map.map_or(Colouring::Look, |m| m.colouring()),
            white_balance: options.white_balance,
            flat: options.flat,
            mirror: None,
        }
    }

    /// The colours of the view: the same table as long as they are the same, so that it is not sent anew.
    fn colours(&mut self, options: &StageOptions) -> Option<ColourMap> {
        let wanted = (options.view, options.map, options.scale.as_ref().map(|s| s.id.clone()));
        if self.colours.as_ref().is_none_or(|(made_for, _)| *made_for != wanted) {
            let map = options.view.colour_map(options.map, options.scale.as_deref());
            self.colours = map.map(|map| (wanted, map));
        }
        self.colours.as_ref().map(|(_, map)| map.clone())
    }

    /// What is drawn of a piece.
    pub(crate) fn skin(&self, id: &str) -> Option<&Skin> {
        self.skins.get(id).map(|worn| &worn.skin)
    }

    /// The drawn points of a piece in its body's frame [m], as far as it has been drawn.
    pub fn points(&self, id: &str) -> &[FoodVertex] {
        self.skins.get(id).map_or(&[], |worn| worn.vertices.as_slice())
    }

    /// Brings vertices up to date: of a few pieces all, of many a part at each tick, those that have waited longest first.
    fn refresh(&mut self, kitchen: &Kitchen, options: &StageOptions, map: Option<&ColourMap>) {
        self.skins.retain(|id, _| kitchen.piece(id).is_some());
        let count = kitchen.pieces().len();
        let ticked = self.refreshed != Some(kitchen.tick());
        self.refreshed = Some(kitchen.tick());
        let mut left = if ticked { ALWAYS_FRESH.max(count.div_ceil(STALE_TICKS as usize)) } else { 0 };
        let scale = options.scale.as_ref().map(|s| s.id.clone());
        let first = if count > ALWAYS_FRESH { self.round } else { 0 };
        for piece in kitchen.pieces().iter().cycle().skip(first % count.max(1)).take(count) {
            let ticks = piece.state.ticks;
            let wanted = Fresh { ticks, view: options.view, map: options.map, scale: scale.clone() };
            let worn = self.worn(piece);
            let patient = count > ALWAYS_FRESH && worn.is_nearly(&wanted);
            if worn.fresh_for.as_ref() == Some(&wanted) || (patient && left == 0) {
                continue;
            }
            if patient {
                left -= 1;
            }
            worn.vertices = Arc::new(worn.skin.vertices(piece, options.view, map));
            worn.fresh_for = Some(wanted);
            self.round += usize::from(patient);
        }
    }

    fn worn(&mut self, piece: &Piece) -> &mut Worn {
        let model = Arc::as_ptr(&piece.model) as usize;
        if self.skins.get(&piece.id).is_none_or(|worn| worn.model != model) {
            let worn = Worn { model, skin: Skin::new(piece), vertices: Arc::default(), fresh_for: None };
            self.skins.insert(piece.id.clone(), worn);
        }
        self.skins.entry(piece.id.clone()).or_insert_with(|| Worn {
            model,
            skin: Skin::new(piece),
            vertices: Arc::default(),
            fresh_for: None,
        })
    }

    /// A piece as it is to be seen; two looks of one that a knife has halved.
    fn food(&self, piece: &Piece, pose: &Pose, options: &StageOptions, map: Option<&ColourMap>) -> Vec<FoodLook> {
        let Some(worn) = self.skins.get(&piece.id) else { return Vec::new() };
        let sear = [Face::Bottom, Face::Top].map(|face| sear_looks(piece, face));
        let whole = FoodLook {
            mesh: worn.skin.mesh.clone(),
            vertices: Arc::clone(&worn.vertices),
            world_from_rest: pose.matrix(),
            slice: None,
            sear,
        };
        let curved = matches!(piece.model.mesh().layout(), Layout::Along(..));
        let across = if curved { path_cut } else { slice };
        if let Some(cut) = piece.halved().and_then(|cut| across(piece, cut.at, options.view, map)) {
            return opened(piece, whole, cut).into();
        }
        let cut = options.cut.as_ref().is_none_or(|id| *id == piece.id);
        let place = options.slice.filter(|_| cut);
        vec![FoodLook { slice: place.and_then(|s| slice(piece, s * half_length(piece), options.view, map)), ..whole }]
    }
}

/// The strongest sets of lines that ridges seared into a face.
fn sear_looks(piece: &Piece, face: Face) -> [Option<SearLook>; SEAR_SETS] {
    let mut sets = piece.all_sear_lines(face).into_iter().map(sear_look);
    std::array::from_fn(|_| sets.next())
}

fn sear_look(lines: SearLines) -> SearLook {
    SearLook {
        direction: Vec2::from_array(lines.direction.map(|v| v as f32)),
        phase: lines.phase as f32,
        pitch: lines.pitch as f32,
        width: lines.width as f32,
        share: lines.share as f32,
        browning: lines.browning.map(|v| v as f32),
        charring: lines.charring.map(|v| v as f32),
    }
}

impl Worn {
    /// Whether what is shown may wait a little.
    fn is_nearly(&self, wanted: &Fresh) -> bool {
        self.fresh_for.as_ref().is_some_and(|shown| {
            let same = Fresh { ticks: wanted.ticks, ..shown.clone() } == *wanted;
            same && wanted.ticks.abs_diff(shown.ticks) < STALE_TICKS
        })
    }
}

/// The tool in the cook's hand.
fn tool(kitchen: &Kitchen) -> Option<ToolLook> {
    let hand = kitchen.hand();
    let kind = match hand.tool {
        Tool::Turner => ToolKind::Turner,
        Tool::Tongs => ToolKind::Tongs { open: hand.gripped().is_none() },
    };
    hand.is_active()
        .then(|| ToolLook { kind, world_from_tool: Pose::of_body(&hand.tool_pose(kitchen.world())).matrix() })
}

/// Rack or foil where a piece rests on or under one.
fn rest_look(piece: &Piece) -> Option<RestLook> {
    let kind = match piece.place {
        Place::Rest(RestOn::Rack) => RestKind::Rack,
        Place::Rest(RestOn::Foil) => RestKind::Foil,
        _ => return None,
    };
    let [length, width, thickness] = piece.model.size().map(|v| v as f32);
    let turn = Vec2::from_angle(piece.pose.rotation.as_quat().to_euler(glam::EulerRot::ZYX).0);
    let half = 0.5 * (turn.abs() * length + turn.perp().abs() * width);
    let centre = piece.pose.position.as_vec3().with_z(BOARD_CENTRE.z);
    Some(RestLook { kind, centre, half, height: thickness })
}

/// The scale, where it says anything about what is cooked: about the first piece.
pub fn fitting(kitchen: &Kitchen, scale: &Arc<Scale>) -> Option<Arc<Scale>> {
    fitting_piece(kitchen.pieces().first(), scale)
}

/// The scale, where it says anything about a piece.
pub fn fitting_piece(piece: Option<&Piece>, scale: &Arc<Scale>) -> Option<Arc<Scale>> {
    piece.is_none_or(|p| scale.fits(p.model.kinetics())).then(|| Arc::clone(scale))
}

/// How much nearer the eye goes to a small piece [-]: it fills as much of the picture as a steak of 120 mm, and never
/// nearer than is sharp (chosen).
pub fn nearness(piece: &Piece) -> f32 {
    ((half_length(piece) / 0.06) as f32).clamp(0.5, 1.0)
}

/// Half the longest extent of a piece [m].
pub fn half_length(piece: &Piece) -> f64 {
    0.5 * piece.model.size()[0].max(piece.model.size()[1])
}

fn pan_look(kitchen: &Kitchen, view: View, map: Option<&ColourMap>) -> PanLook {
    let description = &kitchen.pan_model().description;
    let look = &description.look;
    let linear = |v: f32| decoded(f64::from(v) / 255.0) as f32;
    let oil_colour = kitchen.pan_model().liquids.colour(&kitchen.pan_state().liquids);
    PanLook {
        floor_radius: description.floor.radius_mm as f32 * 1e-3,
        rim_radius: description.wall.rim_radius_mm as f32 * 1e-3,
        rim_height: description.wall.height_mm as f32 * 1e-3,
        thickness: kitchen.world().pan_shape().thickness as f32,
        colour: Vec3::from_array(look.colour_srgb.map(|v| linear(f32::from(v)))),
        metalness: look.metalness as f32,
        roughness: look.roughness as f32,
        film: Arc::default(),
        tint: Arc::default(),
        oil_colour: oil_colour.map_or(Vec3::ONE, |srgb| Vec3::from_array(srgb.map(|v| linear(v as f32)))),
        ridges: kitchen.pan_model().ridges.map(|r| [r.pitch, r.width, r.height].map(|v| v as f32)),
        lid: kitchen.pan_state().lid.as_ref().map(|lid| LidLook { fog: fog(lid) }),
        position: Vec3::ZERO,
        rotation: Quat::IDENTITY,
        on_cloth: kitchen.cloth().is_some(),
        floor_field: floor_field(kitchen, map.filter(|_| view == View::Temperature)),
    }
}

/// How far a lid's glass is fogged: with the vapour under it, until it is as hot as that [-] (chosen).
fn fog(lid: &saute_kitchen::lid::Lid) -> f32 {
    let damp = (lid.vapour_density() / 0.10).clamp(0.0, 1.0);
    let cold = ((celsius(lid.air_temperature()) - celsius(lid.temperature)) / 12.0).clamp(0.25, 1.0);
    (damp * cold) as f32
}

/// Mean temperature of the floor in rings, as map coordinates; −1 where the view does not colour the pan.
fn floor_field(kitchen: &Kitchen, map: Option<&ColourMap>) -> [f32; FLOOR_FIELD_RINGS] {
    let Some(map) = map else { return [-1.0; FLOOR_FIELD_RINGS] };
    let (pan, state) = (kitchen.pan_model(), kitchen.pan_state());
    let floor = pan.description.floor.radius_mm * 1e-3;
    let mut sums = [(0.0, 0.0); FLOOR_FIELD_RINGS];
    for (p, t) in pan.section.points[..pan.floor_nodes].iter().zip(&state.temperature) {
        let place = p[0].hypot(p[1]) / floor * (FLOOR_FIELD_RINGS - 1) as f64;
        for (ring, sum) in sums.iter_mut().enumerate() {
            // A tent one node ring (8 mm) wide keeps every drawn ring fed.
            let weight = (1.0 - (place - ring as f64).abs() / 1.6).max(0.0);
            *sum = (sum.0 + weight * t, sum.1 + weight);
        }
    }
    let mean = celsius(kitchen.pan_temperature());
    sums.map(|(t, w)| map.coordinate(if w > 0.0 { celsius(t / w) } else { mean }))
}

/// Vapour leaves round the lower rim of a frying piece and from its upper face; of many pieces each has fewer sources.
fn steam(kitchen: &Kitchen, pan: &Pose, poses: &[Pose]) -> Vec<SteamSource> {
    let mut sources = Vec::new();
    let fries = |p: &Piece| p.place != Place::Waiting && p.vapour_flow > 0.0;
    let frying = kitchen.pieces().iter().zip(poses).filter(|(p, _)| fries(p));
    // Pieces that give off next to nothing need no places of their own.
    let most = kitchen.pieces().iter().map(|p| p.vapour_flow).fold(0.0, f64::max);
    let around = match kitchen.pieces().iter().filter(|p| fries(p) && p.vapour_flow > 0.1 * most).count() {
        0..=ALWAYS_FRESH => 6u8,
        7..=20 => 1,
        _ => 0,
    };
    for (piece, pose) in frying {
        let around = if piece.vapour_flow > 0.1 * most { around } else { 0 };
        let [a, b] = [0.45 * piece.model.size()[0] as f32, 0.45 * piece.model.size()[1] as f32];
        let share = 1e3 * piece.vapour_flow as f32 / f32::from(around + 1);
        for k in 0..around {
            let angle = f32::from(k) * std::f32::consts::TAU / 6.0 + 0.4;
            let position = pose.position + Vec3::new(a * angle.cos(), b * angle.sin(), 0.0);
            sources.push(SteamSource { kind: Vapour::Steam, position, radius: 0.015f32.min(0.5 * b), flow_g_s: share });
        }
        let top = pose.position + Vec3::Z * 0.5 * piece.model.thickness(&piece.state) as f32;
        sources.push(SteamSource { kind: Vapour::Steam, position: top, radius: 0.5 * b, flow_g_s: share });
    }
    let (puddle, cloth) = kitchen.other_vapour();
    if puddle + cloth > 1e-6 {
        let flow_g_s = 1e3 * (puddle + 0.3 * cloth) as f32;
        sources.push(SteamSource {
            kind: Vapour::Steam,
            position: pan.position + Vec3::Z * 0.01,
            radius: 0.09,
            flow_g_s,
        });
    }
    sources.extend(smoke(kitchen, pan));
    sources
}

/// Smoke and flames rise from the whole film of oil.
fn smoke(kitchen: &Kitchen, pan: &Pose) -> Vec<SteamSource> {
    let state = kitchen.pan_state();
    let rate = 1e-3 * state.smoke_mg_s() as f32;
    let radius = 0.4e-3 * kitchen.pan_model().description.floor.radius_mm as f32;
    let kind = if state.liquids.smoke.burning { Vapour::Flame } else { Vapour::Smoke };
    let place = |k: u8| {
        let around = Vec2::from_angle(f32::from(k) * std::f32::consts::TAU / 3.0 + 0.7) * radius * 1.3;
        let position = pan.position + pan.rotation * around.extend(0.012);
        // How high flames stand does not follow from the smoke.
        let flow_g_s = if kind == Vapour::Flame { 1.0 } else { rate / 3.0 };
        SteamSource { kind, position, radius, flow_g_s }
    };
    let rising = rate > 1e-5 || kind == Vapour::Flame;
    (0..if rising { 3 } else { 0 }).map(place).collect()
}
