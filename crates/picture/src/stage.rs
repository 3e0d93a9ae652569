//! The stage: turns a kitchen into the renderer's input.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{Mat4, Quat, Vec2, Vec3};
use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::dynamics::Tool;
use saute_kitchen::food::change::colour::decoded;
use saute_kitchen::food::{Face, FoodModel, Scale};
use saute_kitchen::heat::Layout;
use saute_kitchen::pan::heater::Heater;
use saute_kitchen::piece::sear_lines::SearLines;
use saute_kitchen::{Kitchen, Piece, Place, RestOn, celsius};
use saute_scene::camera::Camera;
use saute_scene::input::{
    Colouring, FLOOR_FIELD_RINGS, FoodLook, FoodVertex, HobLook, LidLook, PanLook, RestKind, RestLook, SEAR_SETS,
    SceneInput, SearLook, SliceLook, StoveKind, ToolKind, ToolLook,
};
use saute_scene::light::photo::Photo;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::mesh::props::BOARD_CENTRE;

use crate::colour::map::{ColourMap, TemperatureMap};
use crate::colour::side_by_side::side_by_side;
use crate::cut::contour::Outside;
use crate::cut::face::slice;
use crate::cut::path::path_cut;
use crate::pace::Pace;
use crate::pan::film::PanFilm;
use crate::pan::spatter::Spots;
use crate::pan::tint::PanTint;
use crate::skin::halves::opened;
use crate::skin::pool::juice_on_board;
use crate::skin::surface::Skin;
use crate::vapour::steam;
use crate::view::View;

pub use crate::pose::{Places, Pose, following, pan_pose, poses};

/// Options of a picture; by default the whole food as the eye sees it, from the working view.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StageOptions {
    /// The eye.
    pub camera: Camera,
    /// View that the colours show.
    pub view: View,
    /// Which map shows temperatures.
    pub map: TemperatureMap,
    /// The scales of doneness, with the one that is chosen.
    pub scales: ScaleChoice,
    /// The cut: distance along the longest axis from the centroid over half the length (−1…1); none for no cut.
    pub slice: Option<f64>,
    /// The piece that is cut; all of them unless one is named.
    pub cut: Option<String>,
    /// White balance of the look.
    pub white_balance: WhiteBalance,
    /// Light of the room.
    pub light: RoomLight,
    /// Exposure and aperture of the look.
    pub photo: Photo,
    /// Unlit, exactly decodable colours.
    pub flat: bool,
}

/// Angle of the eye about the vertical axis when the cut is opened [rad] (chosen: the face is seen at a slant, the pan
/// stays in view).
pub const CUT_YAW: f32 = 0.62;

/// The stage; caches the skins of the pieces between frames.
#[derive(Clone, Debug, Default)]
pub struct Stage {
    skins: BTreeMap<String, CachedSkin>,
    film: PanFilm,
    tint: PanTint,
    spots: Spots,
    /// Index at which the next round of updates begins.
    round: usize,
    /// Tick of the last round.
    refreshed: Option<u64>,
    /// The colours of the view, and what they were made for.
    colours: Option<(Shades, Vec<ColourMap>)>,
    pace: Pace,
}

/// View, colour map of temperatures and ids of the scales of doneness of the foods, each once; none for the look.
type Shades = (View, TemperatureMap, Vec<Option<String>>);

/// A skin with the vertices it has now.
#[derive(Clone, Debug)]
struct CachedSkin {
    /// Kept, so that no other model gets its address.
    model: Arc<FoodModel>,
    skin: Skin,
    vertices: Arc<Vec<FoodVertex>>,
    /// What the vertices were made for.
    made_for: Option<SkinKey>,
}

/// State and view that vertices show.
#[derive(Clone, Debug, PartialEq)]
struct SkinKey {
    ticks: u64,
    view: View,
    map: TemperatureMap,
    scale: Option<String>,
    /// The part of the common table that is the scale's.
    part: Option<[usize; 2]>,
}

/// A state this much older than shown is not yet worth new vertices, where there are many pieces [ticks] (chosen: 0.5
/// s).
const STALE_TICKS: u64 = 5;
/// Pieces of which every one is shown as it is in every frame (chosen).
pub(crate) const ALWAYS_FRESH: usize = 6;

impl Stage {
    /// Sets how many ticks are between two looks at the state of foods and film: where shading them is slow, they are shown
    /// as they were at the last look. Poses, steam and drops are always the present ones.
    pub fn look_every(&mut self, ticks: u64) {
        self.pace.set(ticks);
    }

    /// Returns the renderer's input for one frame.
    pub fn scene(&mut self, kitchen: &Kitchen, options: &StageOptions, places: &Places) -> SceneInput {
        let pan = places.pan(kitchen);
        self.pace.begin(kitchen.tick());
        self.colour(kitchen, options);
        self.refresh(kitchen, options);
        // Every map is in the same table; the pan is coloured by temperatures, whose map is alone.
        let map = self.colours.as_ref().and_then(|(_, maps)| maps.first().cloned());
        let poses = places.all(kitchen);
        let looks = kitchen.pieces().iter().zip(&poses);
        let look = PanLook {
            position: pan.position,
            rotation: pan.rotation,
            film: self.film.picture(kitchen, &self.pace),
            tint: self.tint.picture(kitchen, &self.pace),
            ..pan_look(kitchen, options.view, map.as_ref())
        };
        let spatter = self.spots.look(kitchen, &look, &self.pace);
        SceneInput {
            camera: following(&options.camera, places.followed(kitchen)),
            hob: hob_look(kitchen),
            pan: look,
            foods: looks.flat_map(|(piece, pose)| self.food(piece, pose, options)).collect(),
            tool: tool(kitchen),
            strings: Vec::new(),
            rest: kitchen.pieces().iter().find_map(rest_look),
            steam: steam(kitchen, &pan, &poses),
            spatter,
            time_s: kitchen.time_s() as f32,
            colouring: map.map_or(Colouring::Look, |m| m.colouring()),
            white_balance: options.white_balance,
            light: options.light,
            photo: options.photo,
            flat: options.flat,
            mirror: None,
            tile: None,
            sample: None,
        }
    }

    /// Returns how the pieces look, each with its index; two for a piece that was halved.
    pub(crate) fn looks(
        &mut self,
        kitchen: &Kitchen,
        options: &StageOptions,
        places: &Places,
    ) -> Vec<(usize, FoodLook)> {
        self.colour(kitchen, options);
        self.refresh(kitchen, options);
        let posed = kitchen.pieces().iter().zip(places.all(kitchen)).enumerate();
        let looks = posed.flat_map(|(index, (piece, pose))| {
            self.food(piece, &pose, options).into_iter().map(move |look| (index, look))
        });
        looks.collect()
    }

    /// Keeps the colours of the view: the same table as long as they are the same, so that it is not uploaded again.
    fn colour(&mut self, kitchen: &Kitchen, options: &StageOptions) {
        let mut scales: Vec<Option<&Arc<Scale>>> = Vec::new();
        let foods = kitchen.pieces().iter().map(|piece| options.scales.of(&piece.model));
        for scale in foods.filter(|_| options.view == View::Doneness) {
            if !scales.contains(&scale) {
                scales.push(scale);
            }
        }
        if scales.is_empty() {
            scales.push(options.scales.alone());
        }
        let ids = scales.iter().map(|s| s.map(|s| s.id.clone())).collect();
        let wanted = (options.view, options.map, ids);
        if self.colours.as_ref().is_none_or(|(made_for, _)| *made_for != wanted) {
            let maps = scales.iter().filter_map(|s| options.view.colour_map(options.map, s.map(Arc::as_ref)));
            self.colours = Some((wanted, side_by_side(maps.collect())));
        }
    }

    /// The map that colours a piece, with the id of its scale.
    fn map_of(&self, piece: &Piece, options: &StageOptions) -> (Option<String>, Option<&ColourMap>) {
        let Some(((_, _, ids), maps)) = &self.colours else { return (None, None) };
        let own = options.scales.of(&piece.model).map(|s| s.id.clone());
        let place = ids.iter().position(|id| *id == own).unwrap_or(0);
        (own, maps.get(place))
    }

    /// Drawn surface of a piece.
    pub(crate) fn skin(&self, id: &str) -> Option<&Skin> {
        self.skins.get(id).map(|cached| &cached.skin)
    }

    /// The drawn points of a piece in its body's frame [m], as far as it has been drawn.
    pub fn points(&self, id: &str) -> &[FoodVertex] {
        self.skins.get(id).map_or(&[], |cached| cached.vertices.as_slice())
    }

    /// Brings vertices up to date: of a few pieces all, of many a part at each tick, those that have waited longest
    /// first.
    fn refresh(&mut self, kitchen: &Kitchen, options: &StageOptions) {
        self.skins.retain(|id, _| kitchen.piece(id).is_some());
        let count = kitchen.pieces().len();
        let ticked = self.refreshed != Some(kitchen.tick());
        self.refreshed = Some(kitchen.tick());
        let mut left = if ticked { ALWAYS_FRESH.max(count.div_ceil(STALE_TICKS as usize)) } else { 0 };
        let first = if count > ALWAYS_FRESH { self.round } else { 0 };
        let due = self.pace.is_due();
        for piece in kitchen.pieces().iter().cycle().skip(first % count.max(1)).take(count) {
            let ticks = piece.state.ticks;
            let (scale, map) = self.map_of(piece, options);
            let map = map.cloned();
            let part = map.as_ref().map(|m| m.part);
            let wanted = SkinKey { ticks, view: options.view, map: options.map, scale, part };
            let cached = self.cached(piece);
            let patient = count > ALWAYS_FRESH && cached.is_nearly(&wanted);
            let waits = !due && cached.differs_by_time(&wanted);
            if cached.made_for.as_ref() == Some(&wanted) || waits || (patient && left == 0) {
                continue;
            }
            if patient {
                left -= 1;
            }
            cached.vertices = Arc::new(cached.skin.vertices(piece, options.view, map.as_ref()));
            cached.made_for = Some(wanted);
            self.round += usize::from(patient);
        }
    }

    fn cached(&mut self, piece: &Piece) -> &mut CachedSkin {
        if self.skins.get(&piece.id).is_some_and(|cached| !Arc::ptr_eq(&cached.model, &piece.model)) {
            self.skins.remove(&piece.id);
        }
        self.skins.entry(piece.id.clone()).or_insert_with(|| CachedSkin {
            model: Arc::clone(&piece.model),
            skin: Skin::new(piece),
            vertices: Arc::default(),
            made_for: None,
        })
    }

    /// A piece in its rest frame with the cut through its middle, or where it was halved; none of a body that cannot be cut.
    pub(crate) fn cut_in_half(&self, piece: &Piece, options: &StageOptions) -> Option<(FoodLook, SliceLook)> {
        let mut whole = self
            .food(piece, &Pose::default(), &StageOptions { slice: Some(0.0), ..options.clone() })
            .into_iter()
            .next()?;
        let cut = whole.slice.take()?;
        whole.world_from_rest = Mat4::IDENTITY;
        Some((whole, cut))
    }

    /// Returns the renderer's input for a piece; two for a piece that was halved.
    fn food(&self, piece: &Piece, pose: &Pose, options: &StageOptions) -> Vec<FoodLook> {
        let Some(cached) = self.skins.get(&piece.id) else { return Vec::new() };
        let map = self.map_of(piece, options).1;
        let sear = [Face::Bottom, Face::Top].map(|face| sear_looks(piece, face));
        let whole = FoodLook {
            mesh: cached.skin.mesh.clone(),
            vertices: Arc::clone(&cached.vertices),
            world_from_rest: pose.matrix(),
            slice: None,
            sear,
            steam_g_s: if piece.in_pan() { 1e3 * piece.vapour_flow as f32 } else { 0.0 },
            juice_g: juice_on_board(piece),
        };
        let outside = Outside { triangles: &whole.mesh.triangles, vertices: &whole.vertices };
        let across = |at: f64| match piece.model.mesh().layout() {
            Layout::Along(..) => path_cut(piece, at, options.view, map),
            _ => slice(piece, outside, at, options.view, map),
        };
        if let Some(cut) = piece.halved().and_then(|cut| across(cut.at)) {
            return opened(piece, whole, cut).into();
        }
        let cut = options.cut.as_ref().is_none_or(|id| *id == piece.id);
        let place = options.slice.filter(|_| cut).map(|s| s * half_length(piece));
        let slice = place.and_then(|at| slice(piece, outside, at, options.view, map));
        vec![FoodLook { slice, ..whole }]
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

impl CachedSkin {
    /// Returns true if the update of the vertices may wait.
    fn is_nearly(&self, wanted: &SkinKey) -> bool {
        let fresh = |shown: &SkinKey| wanted.ticks.abs_diff(shown.ticks) < STALE_TICKS;
        self.differs_by_time(wanted) && self.made_for.as_ref().is_some_and(fresh)
    }

    /// Returns true if the vertices show what is required, at whatever time.
    fn differs_by_time(&self, wanted: &SkinKey) -> bool {
        let same = |shown: &SkinKey| SkinKey { ticks: wanted.ticks, ..shown.clone() } == *wanted;
        self.made_for.as_ref().is_some_and(same)
    }
}

/// Power at which the ring glows brightest [W], and steps to it (chosen: the glow of two neighbours can hardly be
/// distinguished; the picture round the pan is drawn again at each, and a hob at its limit changes its power all the time).
const FULL_POWER_W: f64 = 2000.0;
const POWER_STEPS: f64 = 64.0;

/// Temperatures between which an element is seen to glow more and more [K] (the Draper point, and a ribbon at full power).
const GLOW_K: [f64; 2] = [798.0, 1130.0];

/// The stove, and how strongly it shows that it heats.
fn hob_look(kitchen: &Kitchen) -> HobLook {
    let (hob, drawn) = (kitchen.hob(), kitchen.hob_drawn_w());
    let glow = || ((kitchen.pan_state().heater - GLOW_K[0]) / (GLOW_K[1] - GLOW_K[0])).max(0.0);
    let (kind, power) = match hob.heater() {
        Some(Heater::Flame(flame)) => (StoveKind::Gas, seen_power(drawn, flame.largest_w)),
        Some(Heater::Element(_)) => (StoveKind::Radiant, seen_power(glow() * glow(), 1.0)),
        Some(Heater::Plate(plate)) => {
            (StoveKind::Plate, seen_power(drawn, plate.settings_w.iter().copied().fold(1.0, f64::max)))
        }
        Some(Heater::Coil(_)) | None => (StoveKind::Induction, seen_power(drawn, FULL_POWER_W)),
    };
    HobLook { kind, power }
}

/// Power of the hob as it is seen (0–1).
fn seen_power(drawn_w: f64, full_w: f64) -> f32 {
    ((drawn_w / full_w).min(1.0) * POWER_STEPS).round() as f32 / POWER_STEPS as f32
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

/// Factor by which the eye is nearer to a small piece [-]: it fills as much of the picture as a steak of 120 mm, and
/// never nearer than is sharp (chosen).
pub fn nearness(piece: &Piece) -> f32 {
    ((half_length(piece) / 0.06) as f32).clamp(0.5, 1.0)
}

/// Half the longest extent of a piece [m].
pub fn half_length(piece: &Piece) -> f64 {
    0.5 * piece.model.size()[0].max(piece.model.size()[1])
}

/// Steps of the oil's turbidity [-] (chosen: finer ones are not seen, and each redraws the pan).
const TURBIDITY_STEPS: f32 = 32.0;

fn pan_look(kitchen: &Kitchen, view: View, map: Option<&ColourMap>) -> PanLook {
    let description = &kitchen.pan_model().description;
    let look = &description.look;
    let linear = |v: f32| decoded(f64::from(v) / 255.0) as f32;
    // Shares that change by rounding alone must not let everything be drawn again.
    let oil_colour = kitchen.pan_model().liquids.colour(&kitchen.pan_state().liquids);
    let butter = kitchen.pan_model().liquids.butter_share(&kitchen.pan_state().liquids) as f32;
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
        oil_colour: oil_colour.map_or(Vec3::ONE, |srgb| Vec3::from_array(srgb.map(|v| linear(v.round() as f32)))),
        oil_turbidity: (TURBIDITY_STEPS * butter).round() / TURBIDITY_STEPS,
        ridges: kitchen.pan_model().ridges.map(|r| [r.pitch, r.width, r.height].map(|v| v as f32)),
        lid: kitchen.pan_state().lid.as_ref().map(|lid| LidLook { fog: fog(lid) }),
        position: Vec3::ZERO,
        rotation: Quat::IDENTITY,
        on_cloth: kitchen.cloth().is_some(),
        floor_field: floor_field(kitchen, map.filter(|_| view == View::Temperature)),
    }
}

/// Fogging of the lid's glass [-] (chosen): rises with the vapour under it until the glass is as hot as the vapour.
fn fog(lid: &saute_kitchen::pan::lid::Lid) -> f32 {
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
