// Food: lit flesh outside, in cuts, and in the exact pictures.

struct FoodIn {
    @location(0) rest: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) lean: vec3<f32>,
    @location(3) fat: vec3<f32>,
    // Browning, charring, wetness, cooked.
    @location(4) state: vec4<f32>,
    // Field, place along the body, belly to back, strength of seared lines.
    @location(5) place: vec4<f32>,
    // In the present shape (rest is in the shape before cooking); juice on the face.
    @location(6) position: vec4<f32>,
};

struct FoodOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) rest: vec3<f32>,
    @location(2) normal: vec3<f32>,
    @location(3) lean: vec3<f32>,
    @location(4) fat: vec3<f32>,
    @location(5) state: vec4<f32>,
    @location(6) place: vec4<f32>,
    @location(7) juice: f32,
};

@vertex
fn vs_food(in: FoodIn) -> FoodOut {
    let world = food.world_from_rest * vec4<f32>(in.position.xyz, 1.0);
    let clip = frame.clip_from_world * world;
    return FoodOut(clip, world.xyz, in.rest, in.normal, in.lean, in.fat, in.state, in.place, in.position.w);
}

// A place of the flesh, ready to be lit.
struct Look {
    // Linear reflectance.
    colour: vec3<f32>,
    slope: vec3<f32>,
    film_slope: vec3<f32>,
    ridges: f32,
    fatty: f32,
    browning: f32,
    charring: f32,
    clear: f32,
};

fn grain_of(in: FoodOut, grew: Grown, rest_normal: vec3<f32>) -> Grain {
    let cooked = in.state.w;
    let crust = clamp(1.4 * in.state.x, 0.0, 1.0);
    switch texture_kind {
        case MUSCLE: { return muscle(in.rest, cooked, crust); }
        case GROUND: { return ground(in.rest, cooked, crust); }
        case ROOT: { return root(in.rest, grew, cooked, crust); }
        case SHEATHS: { return sheaths(in.rest, grew, max(abs(rest_normal.z), laid_open), cooked, crust); }
        case SHRIMP: { return shrimp(in.rest, in.place.y, in.place.z, cooked, crust); }
        case FLAKES: { return flakes(in.rest, cooked, crust); }
        default: { return structured(in.rest, grew, rest_normal, cooked, crust); }
    }
}

// Colour of silver-skin and of creases over that of fat, L*a*b* / 100 (chosen: skin is whiter and cooler, creases are yellower).
const SILVER = vec3<f32>(0.03, -0.012, -0.050);
const CREASE = vec3<f32>(-0.055, 0.004, 0.025);
// Colour of the fat of a cooked side over that in the flesh (chosen: rendered, it is clear and golden).
const GOLDEN = vec3<f32>(-0.030, 0.034, 0.035);

// How far a crust covers the seams of fat in it (chosen).
const COVERED = 0.62;
// Share of the blackening from which fat is spared (chosen: it contains no sugars or proteins that turn to char).
const FAT_SPARED = 0.30;

// How much of the texture's light and dark is seen: on a fresh cut the juice fills it (chosen).
var<private> shade_share: f32 = 1.0;
const CUT_SHADE = 0.80;
// 1 on a cut, which shows gaps between sheaths as the faces do.
var<private> laid_open: f32 = 0.0;
// How much more evenly a side browned than a face (chosen: it never lay on metal).
const SIDE_EVEN = 0.35;
// 1 on the side of a body seen near by.
var<private> aside: f32 = 0.0;

fn look_of(in: FoodOut, rest_normal: vec3<f32>) -> Look {
    // Muscle does not depend on what grew in it, and lets it stray a little.
    var grew = Grown(0.0, 0.0, 0.0, 0.0);
    if (texture_kind != MUSCLE) { grew = grown(in.rest, 1.0); }
    if (fine && texture_kind == SHEATHS) { grew = grown(in.rest + wander(in.rest), 1.0); }
    if (fine && texture_kind == EGG) {
        grew.tone = yolk_at(in.rest, rest_normal);
        // White creeps up the yolk's rim as a veil.
        grew.second = smoothstep(0.62, 0.74, grew.tone) * mix(0.6, 1.0, smoothstep(0.70, 0.95, grew.tone));
    }
    if (texture_kind == FLAKES) { grew.fatty = max(grew.fatty, sheets(in.rest)); }
    let grain = grain_of(in, grew, rest_normal);
    var skin = vec3<f32>(0.0);
    if (texture_kind == MUSCLE && fine) {
        let fat = fat_near(in.rest, grain.stray);
        grew = fat.grew;
        skin = SILVER * fat.silver + CREASE * fat.crease;
    } else if (texture_kind == MUSCLE) { grew = grown(in.rest + grain.stray, 1.0); }
    let seared = on_lines(in.state.x, in.state.y, in.place.w, in.rest, rest_normal, 0.0006 * grain.uneven);
    let browning = seared.browning;
    // The edge between face and side browns first: there the pan's heat comes from two sides.
    let upright = abs(rest_normal.z);
    let rim = smoothstep(0.10, 0.55, upright) * (1.0 - smoothstep(0.75, 0.995, upright));
    // Ridges press evenly: what they sear is less mottled.
    let room = min(1.9 * browning, 0.62) * (1.0 - 0.65 * seared.share) * (1.0 - SIDE_EVEN * aside);
    let uneven = clamp(browning + room * (grain.uneven + 0.5 * rim), 0.0, 1.0);
    let blackened = clamp(seared.charring + min(1.5 * seared.charring, 0.7) * (grain.uneven + 0.3 * rim), 0.0, 1.0);
    // Seams of fat are still brown and shine where lean flesh is black already.
    let charring = blackened * (1.0 - FAT_SPARED * grew.fatty);
    let shade = grain.shade * shade_share * (1.0 - 0.45 * uneven) * (1.0 - charring);
    // Browned juice and rendered fat cover seams in a crust: they stay visible, as darker gold.
    let fatty = grew.fatty * (1.0 - COVERED * smoothstep(0.30, 0.85, uneven));
    skin += GOLDEN * (aside * in.state.w);
    let flesh = Flesh(in.lean + food.second.xyz * grew.second + shade, in.fat + 0.35 * shade + skin, uneven, charring, fatty);
    // A crust that browned deeply is redder before it is dark.
    let colour = linear_from_lab(flesh_colour(flesh)) * grain.crevice * (1.0 - 0.75 * grain.crack * charring);
    return Look(colour, grain.slope * (1.0 + select(0.6, -0.5, fine) * charring), grain.film_slope, grain.ridges, grew.fatty, uneven, charring, grain.clear);
}

// Height of what the food lies on.
fn support(position: vec3<f32>) -> f32 {
    let local = in_pan(position);
    let over_pan = local.z > 0.0 && dot(local.xy, local.xy) < frame.pan_shape.y * frame.pan_shape.y;
    if (over_pan) { return position.z - (local.z - frame.pan_place.w); }
    let on_board = position.x > frame.board.x && position.x < frame.board.z && position.y > frame.board.y && position.y < frame.board.w;
    return select(0.0, frame.mode.w, on_board);
}

fn world_normal(normal: vec3<f32>) -> vec3<f32> {
    return normalize((food.world_from_rest * vec4<f32>(normal, 0.0)).xyz);
}

// The part of a slope that is in the face.
fn along_face(slope: vec3<f32>, normal: vec3<f32>) -> vec3<f32> {
    return slope - normal * dot(slope, normal);
}

// How far the browning of a face creeps over its edge onto the side, at least and at most [m] (chosen: hot fat climbs and
// spatters a few millimetres up, more where it bubbled).
const CREEPS = vec2<f32>(0.0010, 0.0055);
// How far the volume of what grew reaches beyond the flesh [m].
const GRAIN_MARGIN = 0.0007;

// Browned juice and fat that ran down a side: how brown, and how far [m] (chosen).
const STREAKED = 0.42;
const STREAKS_RUN = 0.0110;

fn streaks(place: vec3<f32>, depth: vec2<f32>) -> vec2<f32> {
    let thin = textureSampleLevel(solid_noise, tile_sampler, place * vec3<f32>(125.0, 125.0, 50.0) + 0.83, 0.0).a;
    let wide = textureSampleLevel(solid_noise, tile_sampler, place * vec3<f32>(37.0, 37.0, 24.0) + 0.17, 0.0).a;
    let ran = smoothstep(0.42, 0.68, 0.55 * thin + 0.45 * wide);
    return STREAKED * (0.15 + 0.85 * ran) * exp(-depth / STREAKS_RUN);
}

// How much further browning creeps than is seen from afar, and how brown the hot air and fat left the rest of a side (chosen:
// brown for 3 to 6 mm, then tan, then grey).
const FINE_REACH = 1.35;
const TANNED = 0.23;
// How brown a side gets away from the metal (chosen: no blots as dark as the crust).
const STAINED_MOST = 0.56;

// Browning of the side of a slice near the edges of its faces.
fn crept(in: FoodOut, rest_normal: vec3<f32>) -> f32 {
    let seared = in.place.yz;
    if (!(texture_kind == MUSCLE || texture_kind == GROUND || texture_kind == FLAKES) || seared.x + seared.y <= 0.0) { return 0.0; }
    let place = in.rest + food.place.xyz;
    let far = textureSampleLevel(solid_noise, tile_sampler, place * 31.0 + 0.71, 0.0).a;
    let near = textureSampleLevel(solid_noise, tile_sampler, place * vec3<f32>(150.0, 150.0, 60.0) + 0.29, 0.0).a;
    var ragged = 0.62 * far + 0.38 * near;
    if (fine) { ragged += 0.30 * (textureSampleLevel(solid_noise, tile_sampler, place * vec3<f32>(310.0, 310.0, 170.0) + 0.47, 0.0).a - 0.5); }
    var reach = mix(CREEPS.x, CREEPS.y, smoothstep(0.30, 0.78, ragged));
    let thickness = 1.0 / food.grain_scale.z - 2.0 * GRAIN_MARGIN;
    let up = clamp(in.rest.z - food.grain_origin.z - GRAIN_MARGIN, 0.0, thickness);
    let depth = vec2<f32>(thickness - up, up);
    var stained = 0.30 * exp(-depth / (2.2 * reach));
    if (fine) {
        reach = reach * FINE_REACH;
        stained = min(0.34 * exp(-depth / (1.6 * reach)) + (streaks(place, depth) + TANNED * (0.4 + 1.2 * ragged)) * in.state.w, vec2<f32>(STAINED_MOST));
    }
    let near_face = exp(-depth * depth / (reach * reach));
    let both = seared * max(0.85 * near_face, stained);
    // Seen near by the edge itself is browned too, or it would lie on the side as a pale hoop.
    let turned = (abs(rest_normal.z) - select(0.5, 0.80, fine)) / select(0.4, 0.195, fine);
    return max(both.x, both.y) * (1.0 - smoothstep(0.0, 1.0, turned));
}

fn lit_food(outside: FoodOut) -> vec4<f32> {
    var in = outside;
    let rest_normal = normalize(in.normal);
    if (fine && texture_kind == MUSCLE) { aside = 1.0 - smoothstep(0.75, 0.99, abs(rest_normal.z)); }
    in.state.x = max(in.state.x, crept(in, rest_normal));
    above_support = max(in.position.z - support(in.position), 0.0);
    let look = look_of(in, rest_normal);
    let wetness = in.state.z * (1.0 - look.charring);
    let crust = clamp(1.4 * look.browning, 0.0, 1.0);
    let view = normalize(frame.eye.xyz - in.position);
    let slope = along_face(look.slope, rest_normal);
    let smooth_normal = world_normal(in.normal);
    let height = above_support;
    let visibility = (0.30 + 0.70 * smoothstep(-0.001, 0.010, height)) * (0.80 + 0.20 * smooth_normal.z) * nearby(in.clip.xy);
    let lit = shadow(in.position, smooth_normal);
    let bumpy = world_normal(rest_normal - slope * (0.85 - 0.35 * wetness));
    // Cooked flesh scatters all colours alike.
    let flesh_wrap = mix(vec3<f32>(0.26, 0.14, 0.10), vec3<f32>(0.19, 0.16, 0.13), in.state.w);
    let wrap = mix(flesh_wrap, vec3<f32>(0.42, 0.36, 0.30), look.clear) * (1.0 - 0.85 * crust);
    let roughness = mix(mix(0.60, 0.80, crust), 0.45, wetness) - 0.12 * look.fatty + 0.15 * look.charring;
    // Fat and oil that fill the pores of a crust make it deeper and warmer.
    let oiled = OILED * crust * (1.0 - look.charring);
    var beads = juice_on(in, rest_normal, smooth_normal, look.film_slope);
    // On a crust juice soaks in and joins the fat: few of its beads stand there.
    beads.cover *= 1.0 - select(0.30, 1.0, fine) * smoothstep(0.35, 0.80, select(crust, max(crust, 2.0 * in.state.x), fine));
    // Red flesh is deeper under a film: light that is thrown back into it passes it twice.
    let coated = wetness * (1.0 - in.state.w) * (1.0 - crust) * (1.0 - look.fatty) * (1.0 - look.clear);
    let wet_flesh = mix(look.colour, pow(look.colour, vec3<f32>(1.55)), coated);
    let amber = amber_over(look);
    let dry = wet_flesh * mix(vec3<f32>(1.0), sqrt(look.colour), oiled) * (1.0 - select(0.05, 0.24, fine) * oiled) * amber;
    // A bead gathers the window's light on its far side.
    let towards = dot((food.world_from_rest * vec4<f32>(beads.bend, 0.0)).xyz, frame.key.xyz);
    let colour = dry * mix(vec3<f32>(1.0), beads.tint * (1.0 - 0.55 * towards), beads.cover);
    // Light comes through translucent flesh where it is thin: at the rim, from behind.
    let rim = pow(1.0 - clamp(dot(smooth_normal, view), 0.0, 1.0), 2.0);
    let through = look.clear * (1.0 - in.state.w) * (1.0 - crust);
    // Where it is thick and faces the eye, the dark pan is seen through it.
    let body = Surface(colour * (1.0 + through * (1.1 * rim - mix(0.12, SEEN_THROUGH, smoothstep(0.6, 1.0, look.clear)))), vec3<f32>(0.03), roughness, bumpy, visibility, wrap);
    var radiance = diffuse(body, lit) + colour * (side_fill(smooth_normal) * visibility + thrown_back(in.position, smooth_normal));
    let tint = mix(vec3<f32>(1.0), vec3<f32>(1.0, 0.82, 0.58), crust);
    // The film over it shines far more.
    if (!quick) { radiance += specular(body, in.position, view, lit) * mix(0.34, 0.16, max(wetness, crust)) * (1.0 - 0.6 * look.charring) * tint; }
    let film_slope = along_face(look.film_slope, rest_normal);
    // Rendered fat is on a crust and, less, on a cooked side.
    let fatted = max(crust * smoothstep(0.20, 0.88, in.state.x) * (1.0 - 0.4 * look.browning) * (1.0 - look.charring), aside * in.state.w * (0.4 + 0.6 * look.fatty));
    if (fine) { radiance += fat_film(in, look, world_normal(rest_normal - film_slope * FILM_RELIEF), view, lit, visibility) * tint * fatted; }
    // A side turned from the window shines in the light of the room, as a cut does.
    if (fine && texture_kind == MUSCLE) {
        let greased = aside * in.state.w * (0.35 + 0.65 * look.fatty) * max(dot(smooth_normal, view), 0.0);
        radiance += MOIST_LIGHT * (greased * visibility * moist(in.rest, rest_normal, look.film_slope));
    }
    // Raw flesh is coated by an even film of its own juice; later the film follows every pore.
    let raw = wetness * (1.0 - crust) * (1.0 - in.state.w);
    radiance += sheen(in, look, rest_normal - film_slope * mix(mix(0.8, 1.2, wetness), 0.75, raw), raw, view, lit, visibility, wetness) * (0.35 + 0.65 * max(smooth_normal.z, 0.0)) * tint;
    if (fine && (texture_kind == SHEATHS || texture_kind == SHRIMP || texture_kind >= MUSHROOM)) {
        let gloss = Surface(vec3<f32>(0.0), vec3<f32>(0.032), skin_rough, world_normal(rest_normal - along_face(skin_slope, rest_normal)), visibility, vec3<f32>(0.0));
        radiance += max(specular(gloss, in.position, view, lit) - 0.7 * GLINT, vec3<f32>(0.0)) * (skin_gloss * (1.0 - look.charring));
        radiance += frame.key_light.rgb * colour * (lets_through * visibility * (1.0 - 0.75 * max(smooth_normal.z, 0.0)));
    }
    let bead_turn = fwidth(beads.bend);
    if (beads.cover > 0.0) {
        let drop = Surface(vec3<f32>(0.0), vec3<f32>(0.026), widened(0.07, bead_turn), world_normal(rest_normal + beads.bend), visibility, vec3<f32>(0.0));
        // Beads of few pixels show no window each: their glints would be grains of salt.
        let seen = 1.0 - smoothstep(0.25, 0.80, length(bead_turn));
        radiance += specular(drop, in.position, view, lit) * beads.cover * mix(0.25, 1.6, seen);
    }
    return pixel_from_radiance(radiance, in.clip.xy);
}

// Light that a surface which looks down gets from what is under it, over that of the window (chosen: a wooden board close by, half
// in the food's own shade; a dark pan gives next to none).
const FROM_BOARD = vec3<f32>(0.135, 0.085, 0.045);
const FROM_PAN = vec3<f32>(0.020, 0.019, 0.018);

fn thrown_back(position: vec3<f32>, normal: vec3<f32>) -> vec3<f32> {
    let on_board = step(frame.board.x, position.x) * step(position.x, frame.board.z);
    return frame.key_light.rgb * mix(FROM_PAN, FROM_BOARD, on_board) * clamp(0.25 - normal.z, 0.0, 1.0);
}

// The side that the cook sees gets the light that the room behind him gives back.
fn side_fill(normal: vec3<f32>) -> vec3<f32> {
    return frame.fill_front.rgb * max(dot(normal, FRONT), 0.0) * (1.0 - max(normal.z, 0.0)) * 1.1;
}

// Share of the light that raw translucent flesh loses to what lies under it, and how much of a cooked one a film of fat or glaze
// covers (chosen).
const SEEN_THROUGH = 0.36;
const GLAZED = 0.55;
// Shine of the fat on a crust, in its dips and on its high points (chosen).
const FAT_POOLS = 0.26;
const FAT_THIN = 0.30;

// Reflections weaker than this do not count as glints, and how much of a crust's pores oil fills (chosen).
const GLINT = 0.075;
const OILED = 0.63;
// What the fat over a crust does to light that passes it twice (chosen: amber).
const AMBER = vec3<f32>(1.16, 0.98, 0.74);
// The same on a seared muscle seen near by (chosen: mahogany rather than rust).
const MAHOGANY = vec3<f32>(1.03, 0.81, 0.56);

fn amber_over(look: Look) -> vec3<f32> {
    var over = AMBER;
    if (fine && texture_kind == MUSCLE) { over = mix(AMBER, MAHOGANY, look.browning); }
    return mix(vec3<f32>(1.0), over, clamp(1.4 * look.browning, 0.0, 1.0) * (1.0 - look.charring));
}

// Where fat was drawn together on a crust (0-1).
fn fat_here(rest: vec3<f32>) -> f32 {
    return smoothstep(0.36, 0.64, textureSampleLevel(solid_noise, tile_sampler, (rest + food.place.xyz).zxy * 17.0 + 0.31, 0.0).a);
}

// The film of fat on a crust: how much of the crust's relief it follows, how rough it is, and how much of the light it throws
// back where it is thin and where it is thick (chosen: a wide soft shine that the relief breaks, no sparks).
const FILM_RELIEF = 0.65;
const FILM_ROUGH = 0.36;
const FILM_SHINE = vec2<f32>(0.15, 0.50);
// The lamp and the window where the relief turns to them: how bright and how sharp (chosen: soft).
const TURNED_LIGHT = vec2<f32>(0.50, 0.13);
const LAMP_SHARPNESS = 18.0;
// Colour of light that fat throws back from a crust (chosen: it passes browned fat, and a crust is never ashen).
const FILM_TINT = vec3<f32>(1.0, 0.82, 0.60);

fn fat_film(in: FoodOut, look: Look, normal: vec3<f32>, view: vec3<f32>, lit: f32, visibility: f32) -> vec3<f32> {
    let here = fat_here(in.rest);
    let coat = Surface(vec3<f32>(0.0), vec3<f32>(0.040), widened(FILM_ROUGH, fwidth(normal)), normal, visibility, vec3<f32>(0.0));
    let mirrored = max(specular(coat, in.position, view, lit) - 0.2 * GLINT, vec3<f32>(0.0)) * mix(FILM_SHINE.x, FILM_SHINE.y, here);
    let turned = vec2<f32>(dot(normal, normalize(view + frame.other.xyz)), dot(normal, normalize(view + frame.key.xyz)));
    let shine = TURNED_LIGHT * pow(max(turned, vec2<f32>(0.0)), vec2<f32>(LAMP_SHARPNESS));
    return FILM_TINT * (mirrored + (frame.other_light.rgb * shine.x + frame.key_light.rgb * (shine.y * lit)) * (visibility * look.ridges * max(here, 0.4 + aside)));
}

// Water on raw flesh, oil on a crust: a thin film that breaks the window into small glints.
fn sheen(in: FoodOut, look: Look, bent: vec3<f32>, raw: f32, view: vec3<f32>, lit: f32, visibility: f32, wetness: f32) -> vec3<f32> {
    let crust = clamp(1.4 * look.browning, 0.0, 1.0);
    // Fat on a crust is thick in its dips and thin on its high points.
    var oily = mix(FAT_POOLS, FAT_THIN, look.ridges) * crust * (1.0 - look.charring);
    // Seen near by most of it is in the film of fat.
    if (fine) { oily *= 0.25; }
    // Shrimps and vegetables that fried in fat are glazed by it.
    let glaze = GLAZED * in.state.w * smoothstep(0.10, 0.24, look.clear) * (1.0 - look.charring) * (0.45 + 0.55 * look.ridges);
    let film = max(wetness * mix(0.06 + 0.94 * look.ridges, 0.75 + 0.25 * look.ridges, raw), max(oily, glaze));
    // Where the relief is finer than a pixel its glints spread over the pixel.
    let turn = fwidth(bent);
    let roughness = min(sqrt(pow(mix(mix(0.26, 0.15, max(wetness, glaze)), 0.25, crust), 2.0) + 0.16 * dot(turn, turn)), 0.6);
    let coat = Surface(vec3<f32>(0.0), vec3<f32>(0.026), roughness, world_normal(bent), visibility, vec3<f32>(0.0));
    // Only the bright parts of the room show as glints; the rest would lie on the flesh like milk.
    let milk = GLINT * mix(mix(1.0, select(1.0, 0.4, fine), crust), 1.9, raw);
    return max(specular(coat, in.position, view, lit) - milk, vec3<f32>(0.0)) * (mix(0.70, 0.75, raw) * film);
}

// Depth of the dark crust and of the brown below it, under a face that is wholly browned [m] (a well-seared steak: one to one
// and a half millimetres, and another three that fade).
const CRUST_DEPTH = 0.0014;
const BROWN_DEPTH = 0.0044;
// How much the light in wet flesh is coloured by going to and fro under its film (chosen: red meat is deeper wet).
const DEEPENED = 1.62;
// How much more so where it is red (beef from 60 down to 50 °C; chosen: at a table that is read as less done).
const DEEPER = 0.32;
// Colour of flesh that has had neither heat nor air over that of raw flesh in the air (chosen: purplish and dark).
const UNBLOOMED = vec3<f32>(0.70, 0.66, 0.92);
// Colour of the light of the cut (chosen: beside warm wood white light makes grey flesh mauve).
const WARM = vec3<f32>(1.12, 1.04, 0.84);
// a* / 100 of flesh that has lost its red, and of red flesh (beef at 78 and at 63 °C).
const GREY = 0.065;
const RED = 0.128;

// Browning at a depth below a face of which the browning is known.
fn below_face(browned: f32, depth: f32, waver: f32) -> f32 {
    let d = depth + waver;
    let dark = 1.0 - smoothstep(0.7 * CRUST_DEPTH, 1.3 * CRUST_DEPTH, d);
    let brown = 1.0 - smoothstep(CRUST_DEPTH, BROWN_DEPTH, d);
    return min(2.0 * browned, 1.0) * max(dark, 0.68 * brown);
}

// Juice on the cut in the cook's own light: up to which height it gathers [m], how sharp and how bright its soft shine and its
// glints are, and how much a face that lost its juice still has of them (chosen: meat is damp, bread is not).
const GATHERS = 0.0042;
const MOIST_SHARPNESS = vec2<f32>(45.0, 320.0);
const MOIST = vec2<f32>(0.060, 0.36);
const MOIST_LIGHT = vec3<f32>(1.0, 0.91, 0.77);
const DAMP = 0.42;
// How much more fat shines than flesh, which share of its juice flesh holds as long as it has had no heat, and which share of
// its light wet flesh keeps besides its glints (chosen: the mean of the cut stays).
const GREASY = 0.9;
const HELD = 0.85;
const SOAKED = vec3<f32>(0.988, 0.920, 0.850);
// How steep the juice's ripples are: those over the fibres, which draw it with them, and broad ones (chosen).
const RIPPLE = vec2<f32>(0.85, 0.90);
// How far the face must turn up to glint (chosen: his light is above him).
const GLINTS_UP = 0.20;

// A soft shine where the juice lies, and in it small glints where the fibres turn it to him.
fn moist(rest: vec3<f32>, normal: vec3<f32>, film_slope: vec3<f32>) -> f32 {
    let place = rest + food.place.xyz;
    // Juice is here and is wiped off there.
    let broad = textureSampleLevel(solid_noise, tile_sampler, place.yzx * 19.0 + 0.57, 0.0);
    let patchy = smoothstep(0.36, 0.64, broad.a);
    let bent = film_slope * RIPPLE.x + (broad.brg - 0.5) * RIPPLE.y;
    let glints = normalize(normal + vec3<f32>(0.0, 0.0, GLINTS_UP));
    let turned = max(dot(glints, normalize(normal - along_face(bent, normal))), 0.0);
    let shine = MOIST * pow(vec2<f32>(turned), MOIST_SHARPNESS);
    // Seen coarsely both would be blots: there a faint shine stands for them.
    return patchy * select(0.5 * shine.x, shine.x + shine.y, fine);
}

// Pools of juice on a cut: their patterns over a metre along the cut and upwards, how bright they are in their soft rims
// and in their middles, and how much their edge follows the bundles (chosen: 2 to 8 mm long, lying along the stroke).
const POOLS = vec3<f32>(22.0, 22.0, 43.0);
const POOL_LIGHT = vec2<f32>(0.16, 0.32);
const POOL_EDGE = 0.60;

fn pools(rest: vec3<f32>, normal: vec3<f32>, film_slope: vec3<f32>) -> f32 {
    let place = rest + food.place.xyz;
    let wide = textureSampleLevel(solid_noise, tile_sampler, place.zyx * 13.0 + 0.23, 0.0).a;
    let long = textureSampleLevel(solid_noise, tile_sampler, place * POOLS + 0.77, 0.0);
    let small = textureSampleLevel(solid_noise, tile_sampler, (place * POOLS * 2.7).yxz + 0.07, 0.0);
    // The film is bright where it faces a light above, and breaks at each bundle.
    let tilt = along_face(film_slope, normal);
    let lies = 0.68 * long.a + 0.32 * small.a - POOL_EDGE * (0.35 * length(tilt) + tilt.z);
    let shines = vec2<f32>(smoothstep(0.40, 0.68, lies), smoothstep(0.54, 0.76, lies));
    return dot(POOL_LIGHT, shines * shines) * smoothstep(0.40, 0.60, wide) * (0.55 + 0.9 * small.g);
}

// How steep the marks of the knife are (chosen: felt in the shine, hardly seen), and their patterns over a metre along the
// stroke and across it.
const DRAG = 0.34;
const STROKES = vec2<f32>(5.0, 310.0);

// Faint marks that the knife drew, a little askew, where it did not cut clean.
fn knife(rest: vec3<f32>) -> vec3<f32> {
    let place = rest + food.place.xyz;
    let across = place.z + 0.05 * (place.x + place.y);
    let drawn = textureSample(solid_noise, tile_sampler, vec3<f32>(place.xy * STROKES.x, across * STROKES.y) + 0.43);
    let unclean = smoothstep(0.45, 0.70, textureSampleLevel(solid_noise, tile_sampler, place.zxy * 23.0 + 0.19, 0.0).a);
    return vec3<f32>(0.0, 0.0, (drawn.b - 0.5) * DRAG * unclean);
}

// Beads of juice on a cut: distance of the smaller ones [m], their largest radius over it, and how many there are above the
// lower edge, where most stand, on a wet face (chosen).
const CUT_BEADS = 0.0023;
const CUT_BEAD_RADIUS = 0.42;
const CUT_SWEATS = 0.03;
const CUT_DRIPS = 0.90;
// Between which heights beads of juice hang above the foot of a cut, over its lower crust [m].
const FOOT = vec2<f32>(0.0040, 0.0090);

fn foot(height: f32) -> f32 {
    return 1.0 - smoothstep(FOOT.x, FOOT.y, height);
}

// Cover in x, slope along the face and upwards in yz.
fn cut_beads(rest: vec3<f32>, normal: vec3<f32>, amount: f32) -> vec3<f32> {
    let along = select(rest.y, rest.x, abs(normal.y) > abs(normal.x));
    let small = beads_of(vec2<f32>(along, rest.z), CUT_BEADS, CUT_BEAD_RADIUS, amount, 2.1);
    let large = beads_of(vec2<f32>(along, rest.z), 1.9 * CUT_BEADS, CUT_BEAD_RADIUS, 0.7 * amount - 0.12, 0.7);
    return select(large, small, small.x > large.x);
}

// How much the relief of a cut counts in the cook's own light (chosen: it comes from the side).
const CUT_RELIEF = 0.50;

// Light of a cut under its beads of juice: deeper and redder, with the window in each.
fn beaded(in: FoodOut, rest_normal: vec3<f32>, under: vec3<f32>, amount: f32, view: vec3<f32>, lit: f32) -> vec3<f32> {
    let bead = cut_beads(in.rest, rest_normal, amount);
    let side = abs(rest_normal.y) > abs(rest_normal.x);
    let bend = select(vec3<f32>(0.0, bead.y, bead.z), vec3<f32>(bead.y, 0.0, bead.z), side);
    let normal = world_normal(rest_normal + bend * 0.9);
    let drop = Surface(vec3<f32>(0.0), vec3<f32>(0.026), 0.10, normal, 0.9, vec3<f32>(0.0));
    // A bead gathers the light on its lower side and has his lamp above.
    let tint = mix(vec3<f32>(0.76, 0.46, 0.38), vec3<f32>(0.84, 0.68, 0.54), in.state.w) * (1.08 - 0.38 * bead.z);
    let glint = 0.45 * pow(max(dot(normalize(rest_normal + bend * 0.9), normalize(rest_normal + vec3<f32>(0.0, 0.0, 0.6))), 0.0), 90.0);
    return mix(under, under * tint + specular(drop, in.position, view, lit) + MOIST_LIGHT * glint, bead.x);
}

// How far the edge of a crust is bent over a cut, and how much the depth of a crust varies from place to place [m] (chosen: no lid).
const TURNED = 0.0011;
const FRAYS = 0.0018;

// How far a cut is turned to the upper and to the lower face, at depths below them.
fn turned_over(depth: vec2<f32>) -> vec2<f32> {
    return 1.0 - smoothstep(vec2<f32>(-0.0003), vec2<f32>(TURNED), depth);
}

// A fresh cut: crust, band, gradient and centre, moist, in a soft light from the cook's side besides that of the room, so
// that it can be read where the window does not reach.
fn lit_cut(cut: FoodOut) -> vec4<f32> {
    var in = cut;
    let rest_normal = normalize(in.normal);
    var waver = 0.0010 * (textureSample(solid_noise, tile_sampler, (in.rest + food.place.xyz) * 190.0).a - 0.5);
    if (fine) { waver = 1.5 * waver + FRAYS * (textureSampleLevel(solid_noise, tile_sampler, (in.rest + food.place.xyz) * 57.0, 0.0).a - 0.5); }
    // An upright slice has the browning of its faces, above and below, and the depths under them; other bodies have neither.
    let upright = in.juice + in.place.w > 0.0;
    var turned = vec2<f32>(0.0);
    if (upright && (texture_kind == MUSCLE || texture_kind == GROUND || texture_kind == FLAKES)) {
        let crust = max(below_face(in.place.y, in.juice, waver), below_face(in.place.z, in.place.w, waver));
        in.state.x = max(in.state.x, crust);
        if (fine) { turned = turned_over(vec2<f32>(in.juice, in.place.w) + waver); }
    }
    in.place.w = 0.0;
    shade_share = CUT_SHADE;
    laid_open = 1.0;
    let look = look_of(in, rest_normal);
    let view = normalize(frame.eye.xyz - in.position);
    let near_meat = fine && (texture_kind == MUSCLE || texture_kind == GROUND);
    var marks = vec3<f32>(0.0);
    if (near_meat) { marks = knife(in.rest) + vec3<f32>(0.0, 0.0, turned.y - turned.x); }
    let slope = along_face(look.slope + marks, rest_normal);
    let bent = world_normal(rest_normal - slope * 0.85);
    let lit = mix(0.45, 1.0, shadow(in.position, bent));
    let wet = in.state.z * (1.0 - clamp(2.0 * look.browning, 0.0, 1.0));
    let cooks = normalize(view + vec3<f32>(-0.35, 0.1, 0.8));
    var own = 0.42 + 0.30 * clamp(dot(bent, cooks), 0.0, 1.0);
    if (near_meat) { own += CUT_RELIEF * clamp(dot(bent - world_normal(rest_normal), cooks), -0.25, 0.25); }
    // Juice runs down and gathers where the cut meets the board.
    let height = max(in.position.z - support(in.position), 0.0);
    let gathered = wet * (1.0 - smoothstep(0.0004, GATHERS, height + 2.0 * waver));
    // Fat is not deeper wet, nor is flesh that has lost its red: little light is lost in them.
    let unheated = (1.0 - in.state.w) * (1.0 - in.state.w);
    let deep = wet * (1.0 - look.fatty) * smoothstep(GREY, RED, in.lean.y);
    let amber = amber_over(look);
    let colour = pow(look.colour, vec3<f32>(mix(1.0, DEEPENED + DEEPER * smoothstep(0.14, 0.20, in.lean.y), deep))) * mix(1.0, 1.45, deep) * amber * mix(vec3<f32>(1.0), UNBLOOMED, deep * unheated);
    let body = Surface(colour, vec3<f32>(0.03), 0.5, bent, 0.8, vec3<f32>(0.42, 0.24, 0.18) * (1.0 - look.browning));
    // The light of its own is a little warmer than white as shot; another balance tints the cut as it tints
    // the outside.
    var radiance = colour * own * WARM / frame.as_shot.rgb + diffuse(body, lit) * 0.22;
    let film_slope = along_face(look.film_slope + marks, rest_normal);
    let film = Surface(vec3<f32>(0.0), vec3<f32>(0.028), 0.20, world_normal(rest_normal - film_slope * 0.9), 0.9, vec3<f32>(0.0));
    radiance += max(specular(film, in.position, view, lit) - GLINT, vec3<f32>(0.0)) * max(0.9 * wet, 0.7 * turned.x);
    radiance *= 1.0 - 0.30 * gathered;
    var damp = wet;
    if (near_meat) {
        damp = max(wet, DAMP * (1.0 - clamp(2.0 * look.browning, 0.0, 1.0))) * (1.0 + GREASY * look.fatty);
        radiance *= mix(vec3<f32>(1.0), SOAKED, wet);
    }
    radiance += MOIST_LIGHT * (moist(in.rest, rest_normal, look.film_slope + marks) * damp * (1.0 + 0.3 * gathered) * (1.0 - HELD * unheated));
    if (near_meat) { radiance += MOIST_LIGHT * (pools(in.rest, rest_normal, look.film_slope + marks) * damp * (0.72 + 0.10 * wet - 0.32 * deep) * (1.0 - HELD * unheated)); }
    if (near_meat) { radiance = beaded(in, rest_normal, radiance, max(CUT_DRIPS * foot(height + 3.0 * waver), CUT_SWEATS) * damp * (1.0 - HELD * unheated), view, lit); }
    return noted(pixel_from_radiance(radiance, in.clip.xy), vec4<f32>(max(in.state.x, OPAQUE), in.state.yzw));
}

fn food_pixel(in: FoodOut) -> vec4<f32> {
    if (frame.mode.y > 0.5) {
        return vec4<f32>(lightly_lit(hatched_colour(in.place.x, in.clip.xy + frame.origin.xy), world_normal(in.normal), 1.0), 1.0);
    }
    return lit_food(in);
}

// Browning whose little scattering a cut and a cooked side have (chosen: more would smear their fibres).
const OPAQUE = 0.5;

// Notes in the opacity how much light scatters under the surface, for a later pass; a crust lets none through.
fn noted(pixel: vec4<f32>, state: vec4<f32>) -> vec4<f32> {
    if (!hdr) { return pixel; }
    return vec4<f32>(pixel.rgb, 1.0 - 0.5 * (1.0 - clamp(1.4 * state.x + state.y, 0.0, 1.0)) * mix(1.0, 0.6, state.w));
}

@fragment
fn fs_food(in: FoodOut) -> @location(0) vec4<f32> {
    let pixel = food_pixel(in);
    return noted(pixel, vec4<f32>(max(in.state.x, OPAQUE * aside * in.state.w), in.state.yzw));
}

@fragment
fn fs_cut_face(in: FoodOut) -> @location(0) vec4<f32> {
    if (frame.mode.y > 0.5) { return food_pixel(in); }
    return lit_cut(in);
}

// The part behind the cut stays visible as a veil, denser along its outline, so that the food reads as whole.
@fragment
fn fs_ghost(in: FoodOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let rim = 1.0 - abs(dot(world_normal(in.normal), view));
    let alpha = 0.05 + 0.30 * rim * rim * rim;
    return vec4<f32>(vec3<f32>(0.86, 0.84, 0.82) * alpha, alpha);
}

fn flat_pixel(in: FoodOut) -> vec4<f32> {
    if (frame.mode.y > 0.5) { return vec4<f32>(table_colour(in.place.x), 1.0); }
    let grew = grown(in.rest, 0.0);
    let flesh = Flesh(in.lean + food.second.xyz * grew.second, in.fat, in.state.x, in.state.y, grew.fatty);
    return vec4<f32>(srgb_from_linear(linear_from_lab(flesh_colour(flesh))), 1.0);
}

@fragment
fn fs_flat_food(in: FoodOut) -> @location(0) vec4<f32> {
    return flat_pixel(in);
}
