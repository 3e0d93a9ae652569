// What the flesh of each food looks like finer than its mesh: a solid texture in the rest frame, the same outside and in
// any cut. One of them is chosen when the pipeline is made.

const MUSCLE = 0u;
const GROUND = 1u;
const ROOT = 2u;
const SHEATHS = 3u;
const SHRIMP = 4u;
const FLAKES = 5u;
const MUSHROOM = 7u;
const EGG = 8u;
const LAYERS = 9u;
const POD = 10u;
override texture_kind: u32 = 6u;

// Free values of a place (0-1, mean 0.5) on lattices of 8 mm, 2.3 mm, 0.5 mm and 0.2 mm; rgb are slopes.
struct Noise {
    region: vec4<f32>,
    broad: vec4<f32>,
    grain: vec4<f32>,
    fine: vec4<f32>,
};

// Values of a solid texture at a place.
struct Grain {
    // Added to L*a*b* / 100 before browning.
    shade: vec3<f32>,
    // Where browning is ahead or behind, about -1 to 1, mean 0.
    uneven: f32,
    // Slope of the relief, rest frame, and of the film that is over it.
    slope: vec3<f32>,
    film_slope: vec3<f32>,
    // Where a film is on ridges (0-1).
    ridges: f32,
    // Share of the light that crevices keep (0-1).
    crevice: f32,
    // Share of light that the flesh lets creep round its edges: translucent flesh.
    clear: f32,
    // Where a char shrinks until it cracks (0-1).
    crack: f32,
    // How far what grew in the flesh strays from its grid [m].
    stray: vec3<f32>,
};

fn noise_at(piece: vec3<f32>, stretch: vec3<f32>) -> Noise {
    let rest = piece + food.place.xyz;
    let region = textureSample(solid_noise, tile_sampler, rest.zxy * 15.6 + 0.61);
    let broad = textureSample(solid_noise, tile_sampler, rest * 54.0);
    let grain = textureSample(solid_noise, tile_sampler, rest * 250.0 * stretch + 0.37);
    // From afar the finest lattice is lost between the pixels.
    if (quick) { return Noise(region, broad, grain, vec4<f32>(0.5)); }
    return Noise(region, broad, grain, textureSample(solid_noise, tile_sampler, rest.yxz * 610.0 * stretch.yxz + 0.11));
}

fn relief(noise: Noise, crust: f32) -> vec3<f32> {
    return (noise.region.brg - 0.5) * 0.10 + (noise.broad.rgb - 0.5) * (0.16 + 0.45 * crust)
        + (noise.grain.rgb - 0.5) * (0.40 + 0.50 * crust) + (noise.fine.grb - 0.5) * (0.20 + 0.50 * crust);
}

// A film of juice follows every pore; the fat on a crust fills them and lies in broad pools.
fn film_relief(noise: Noise, crust: f32) -> vec3<f32> {
    let fills = 1.0 - 0.45 * crust;
    return (noise.region.gbr - 0.5) * (0.26 * crust) + (noise.broad.rgb - 0.5) * mix(0.60, 0.50, crust)
        + (noise.grain.rgb - 0.5) * (0.95 * fills) + (noise.fine.grb - 0.5) * (0.55 * fills * fills);
}

fn ridges_of(noise: Noise) -> f32 {
    return smoothstep(0.36, 0.74, 0.4 * noise.broad.a + 0.6 * noise.grain.a);
}

// A free value on a lattice of 26 mm (0-1).
fn far_noise(piece: vec3<f32>) -> f32 {
    return textureSampleLevel(solid_noise, tile_sampler, (piece + food.place.xyz).yxz * 4.7 + 0.83, 0.0).a;
}

// Uneven contact: large patches, then the scale of bubbles, then the grain.
fn patches(noise: Noise) -> f32 {
    return 1.5 * (noise.region.a - 0.5) + 1.5 * (noise.broad.a - 0.5) + 0.8 * (noise.grain.a - 0.5);
}

// How far seams of fat stray from the grid of their values, at most [m] (chosen: below its cells, so that the mean stays).
const STRAYS = 0.0030;

// Slope of the fibres off the vertical, seen near by (chosen: no muscle is cut straight along its fibres).
const SLANT = vec2<f32>(0.42, -0.46);

// How far bundles stray by region [m] (chosen).
const LEANS = 0.0045;

// Pitch of the bundles across and along the fibres [m] (chosen: irregular spindles of 2 to 4 by 14 mm; a knife
// that crosses them leaves short ends, not lines), and
// how far they are bent over a slice, by region and near by [m].
const BUNDLE = vec3<f32>(0.0026, 0.0026, 0.0140);
const BENDS = vec3<f32>(0.0190, 0.0040, 0.0007);
// Steepest lean of a bundle's fibres off the mean (chosen: 13°), and how high a bundle bulges [m] (chosen: to be felt, not seen
// as cobbles).
const FIBRE_LEAN = 0.24;
const BULGE = 0.00007;

struct Bundle {
    // Distance from the tissue round it: 0 there, about 0.5 in its middle.
    inside: f32,
    // Slope of the bulge, rest frame.
    slope: vec3<f32>,
    // How far its own fibres are shifted across [m].
    shift: vec3<f32>,
    // A free value (0-1).
    tone: f32,
};

// Bundles of muscle as irregular spindles: how much nearer the nearest of scattered middles is than the next.
fn bundle_at(rest: vec3<f32>, region: vec4<f32>, broad: vec4<f32>) -> Bundle {
    let far = textureSampleLevel(solid_noise, tile_sampler, (rest + food.place.xyz).yxz * 4.7 + 0.83, 0.0).rg;
    let slanted = rest.z * SLANT + (far - 0.5) * BENDS.x + (region.rg - 0.5) * BENDS.y + (broad.rg - 0.5) * BENDS.z;
    let bent = vec3<f32>(slanted, (broad.b - 0.5) * (2.0 * BENDS.z));
    let at = (rest + food.place.xyz + bent) / BUNDLE;
    let home = floor(at);
    var first = vec4<f32>(0.0, 0.0, 0.0, 9.0);
    var second = first;
    var own = vec3<f32>(0.5);
    for (var k = 0; k < 27; k++) {
        let cell = home + vec3<f32>(f32(k % 3 - 1), f32(k / 3 % 3 - 1), f32(k / 9 - 1));
        let chance = random3(cell);
        let off = at - cell - chance;
        let away = vec4<f32>(off, dot(off, off));
        if (away.w < first.w) {
            second = first;
            first = away;
            own = fract(chance * 7.31 + 0.17);
        } else if (away.w < second.w) { second = away; }
    }
    let apart = sqrt(vec2<f32>(first.w, second.w));
    let inside = apart.y - apart.x;
    let outward = (second.xyz / max(apart.y, 1e-3) - first.xyz / max(apart.x, 1e-3)) / BUNDLE;
    let steep = BULGE * 4.0 * (1.0 - smoothstep(0.0, 0.5, inside));
    let lean = (own.xy - 0.5) * (2.0 * FIBRE_LEAN) * first.z * BUNDLE.z;
    return Bundle(inside, outward * steep, vec3<f32>(lean, 0.0), own.z);
}

// Lightness of the cut between bundles, from one to the next and from strand to strand: where tissue holds they are joined by a
// pale line, where they tore there is a shadow (chosen); what all that adds on the mean is taken off.
const JOINT = 0.050;
const TORN = 0.110;
const BUNDLE_TONES = 0.075;
const STRANDS = 0.300;
const JOINT_MEAN = 0.004;
// Thin shadows between single fibres, L* / 100, and their mean (chosen).
const LINES = vec2<f32>(0.085, 0.031);
// How much redder one bundle is than the next, a* / 100 (chosen).
const HUES = 0.035;

fn parted(apart: f32, torn: f32, tone: f32, strands: f32, cooked: f32) -> vec3<f32> {
    let light = apart * mix(JOINT * (1.0 - 0.5 * cooked), -TORN * (1.0 - 0.45 * cooked), torn) + BUNDLE_TONES * (tone - 0.5) + STRANDS * (1.0 - 0.40 * cooked) * strands - JOINT_MEAN;
    let hue = HUES * (fract(tone * 5.3) - 0.5);
    return vec3<f32>(light, -0.10 * light + hue, 0.05 * light + 0.6 * hue);
}

// Length of what is seen of a fibre: its width over it (chosen: ends of 2 to 6 mm, as a knife leaves them).
const ENDS = 0.17;
// The same on a side (chosen: it has shrunk, so its ends are short).
const SIDE_ENDS = 0.50;
// How much more a bundle bulges where a knife freed it and on a cooked side, and how much light the gap beside it keeps (chosen:
// bundles are told apart by their shine and by thin shadows).
const FREED = 0.85;
const GAP_SHADOW = 0.22;

// The grain of a bundle, along its own fibres.
fn along_fibres(noise: Noise, rest: vec3<f32>, shift: vec3<f32>) -> Noise {
    let place = rest + food.place.xyz + shift + vec3<f32>(rest.z * SLANT, 0.0);
    let stretch = vec3<f32>(1.0, 1.0, mix(ENDS, SIDE_ENDS, aside));
    // Shifts leap from bundle to bundle: they do not count in the size of a pixel.
    let finer = exp2(SHARPER * (1.0 - laid_open)) * stretch;
    let x = dpdx(rest) * finer;
    let y = dpdy(rest) * finer;
    let grain = textureSampleGrad(solid_noise, tile_sampler, place * 250.0 * stretch + 0.37, x * 250.0, y * 250.0);
    let fibre = textureSampleGrad(solid_noise, tile_sampler, (place * 610.0 * stretch).yxz + 0.11, x.yxz * 610.0, y.yxz * 610.0);
    return Noise(noise.region, noise.broad, grain, fibre);
}

// Tones of a cooked side, by region, by bundle and near by, and how much light its pores and its cracks keep back (chosen: it dried
// and shrank, so it is neither smooth nor even).
const SIDE_TONES = vec3<f32>(0.14, 0.06, 0.16);
const PORES = 0.24;
const CRACKS = 0.26;
// Colour of a cooked side over that of the flesh in it, L*a*b* / 100 (chosen: air and fat took its pink).
const SIDE_TINT = vec3<f32>(-0.020, -0.008, 0.030);
// Relief of a cooked side over that of a crust (chosen).
const SIDE_ROUGH = 0.55;

fn side_shade(noise: Noise, spindle: Bundle) -> vec3<f32> {
    let light = SIDE_TONES.x * (noise.region.a - 0.5) + SIDE_TONES.y * (spindle.tone - 0.5) + SIDE_TONES.z * (noise.grain.a - 0.5);
    return vec3<f32>(light, -0.12 * light, 0.10 * light) + SIDE_TINT;
}

fn pores(noise: Noise, cracked: f32) -> f32 {
    let pits = smoothstep(0.44, 0.30, 0.35 * noise.broad.a + 0.45 * noise.grain.a + 0.20 * noise.fine.a);
    return max(PORES * pits, CRACKS * cracked);
}

// How uneven cooked flesh is by region, L* / 100 (chosen: damp here and drier there).
const CLOUDED = 0.16;

// How steep a crust is besides, by region and in its blisters and pits, and how much of the light its deep pits keep (chosen:
// by a low light it has hills and holes).
const CRUST_STEEP = vec3<f32>(0.70, 1.50, 1.00);
const PITTED = 0.50;
// How much more a crust's browning varies near by than that of flesh (chosen: red-brown dips between dark blisters).
const BLISTERED = 0.48;

fn crust_relief(noise: Noise, crust: f32) -> vec3<f32> {
    if (!fine) { return vec3<f32>(0.0); }
    return crust * ((noise.region.gbr - 0.5) * CRUST_STEEP.x + (noise.broad.rgb - 0.5) * CRUST_STEEP.y + (noise.grain.rgb - 0.5) * CRUST_STEEP.z);
}

// Fibres that a crust's face shows, its patterns over a metre along them, across and into it, how much they bend with the region
// [m], how far they count in its browning and how steep they are (chosen: short, cut at a slant).
const CRUST_FIBRES = vec3<f32>(85.0, 390.0, 160.0);
const CRUST_BENDS = 0.0050;
// Levels by which patterns are read more finely where every pixel is taken many times (chosen: seen at a slant they would be smears).
const SHARPER = -0.9;
const FIBRED = vec2<f32>(1.6, 2.0);
// Share of the islands that are left seen near by (chosen: large pale spots are read as rust).
const ISLANDS = 0.85;

// Slope of the fibres of a crust, and a value (mean 0).
fn crust_fibres(rest: vec3<f32>, region: vec4<f32>) -> vec4<f32> {
    let place = rest + food.place.xyz + (region.gra - 0.5) * CRUST_BENDS;
    let at = vec3<f32>(0.8 * place.x + 0.6 * place.y, 0.8 * place.y - 0.6 * place.x, place.z) * CRUST_FIBRES;
    let seen = textureSampleBias(solid_noise, tile_sampler, at + 0.19, SHARPER) - 0.5;
    return vec4<f32>(-0.6 * seen.g, 0.8 * seen.g, 0.3 * seen.b, seen.a);
}

// Fibres along z in bundles of 0.8 mm, in fascicles of 3.6 mm with pale tissue between some of them.
fn muscle(rest: vec3<f32>, cooked: f32, crust: f32) -> Grain {
    var noise = noise_at(rest, vec3<f32>(1.0, 1.0, 0.17));
    var spindle = Bundle(0.5, vec3<f32>(0.0), vec3<f32>(0.0), 0.5);
    var fibres = vec4<f32>(0.0);
    if (fine) {
        spindle = bundle_at(rest, noise.region, noise.broad);
        noise = along_fibres(noise, rest, spindle.shift);
        fibres = crust * crust_fibres(rest, noise.region);
    }
    // Bundles lean this way and that by region, 10° to 25° off their mean.
    let warped = rest.xy + food.place.xy + (noise.broad.rg - 0.5) * 0.0022 + (noise.region.rg - 0.5) * LEANS + rest.z * select(vec2<f32>(0.06, -0.04), SLANT, fine) + spindle.shift.xy;
    let bundle = textureSample(bundle_picture, tile_sampler, warped * 78.0);
    var fascicle = textureSample(bundle_picture, tile_sampler, warped.yx * 17.3 + 0.29);
    if (fine) { fascicle = vec4<f32>(2.2 * spindle.inside, spindle.tone, 0.0, 0.0); }
    let strand = 1.0 - smoothstep(0.0, 0.35, bundle.r);
    let seam = (1.0 - smoothstep(0.02, 0.16, fascicle.r)) * smoothstep(0.40, 0.75, noise.broad.a);
    let tone = 0.5 * (bundle.g - 0.5) + 0.45 * (fascicle.g - 0.5) + 0.9 * (noise.grain.a - 0.5) + 0.5 * (noise.fine.a - 0.5);
    let mottled = 0.8 * (noise.region.a - 0.5) + 0.5 * (noise.broad.a - 0.5);
    // Where flesh is darker it is also redder: less light comes back out of it.
    var light = 0.10 * tone + 0.09 * mottled * (1.0 - cooked) - (0.03 + 0.05 * laid_open) * strand;
    var shade = vec3<f32>(light, -0.10 * light * (1.0 - cooked), 0.05 * light);
    // Tissue between the bundles: pale in raw flesh, a thin shadow where cooked bundles part.
    shade += seam * mix(vec3<f32>(0.06, -0.03, 0.0), vec3<f32>(-0.03, 0.0, 0.0), cooked);
    // On a cut the bundles differ in tone, and part here and there.
    let apart = 1.0 - smoothstep(0.01, 0.11, spindle.inside);
    let torn = smoothstep(0.42, 0.66, 0.5 * noise.broad.a + 0.5 * noise.region.a);
    let strands = 1.1 * (noise.grain.a - 0.5) + 0.9 * (noise.fine.a - 0.5) + 0.45 * (bundle.g - 0.5);
    // A seared face is deep and even from afar, and varied near by; where it browns late, it does so in islands.
    let islands = select(1.0, ISLANDS, fine) * (1.0 - smoothstep(0.70, 1.0, crust)) * (2.6 * (far_noise(rest) - 0.46) + 2.0 * (noise.region.a - 0.47));
    let blistered = 1.0 + select(0.0, BLISTERED * crust, fine);
    let uneven = islands + FIBRED.x * fibres.w + blistered * (select(0.55, 0.40, fine) * (noise.region.a - 0.5) + select(0.9, 0.75, fine) * (noise.broad.a - 0.5) + 0.9 * (noise.grain.a - 0.5) + 0.5 * (noise.fine.a - 0.5) + 0.4 * tone);
    // Dips of a crust keep some light and are filled with fat; its high points, which lay on the metal, are the dark ones.
    let high = smoothstep(0.42, 0.70, 0.25 * noise.region.a + 0.40 * noise.broad.a + 0.35 * noise.grain.a);
    // Between bundles a crust is creased here and there only.
    let creased = select(0.25, 0.20 * smoothstep(0.48, 0.64, noise.region.a), fine);
    var crevice = 1.0 - crust * (creased * (1.0 - smoothstep(0.0, 0.30, fascicle.r)) + 0.30 * smoothstep(0.50, 0.30, noise.grain.a) + select(0.24, 0.34, fine) * high);
    let side = aside * cooked;
    if (fine) {
        crevice *= 1.0 - crust * PITTED * smoothstep(0.46, 0.36, 0.15 * noise.region.a + 0.35 * noise.broad.a + 0.50 * noise.grain.a + 0.35 * fibres.w);
        crevice *= 1.0 - GAP_SHADOW * laid_open * apart * (0.25 + 0.75 * torn) * (0.7 + 0.6 * cooked);
        crevice *= 1.0 - side * pores(noise, apart * torn);
        let parting = 1.0 - smoothstep(0.0, 0.055, abs(noise.grain.a - 0.5));
        shade.x += laid_open * (LINES.y - LINES.x * parting + cooked * CLOUDED * (noise.region.a + 0.5 * noise.broad.a - 0.75));
        shade += laid_open * parted(apart, torn, spindle.tone, strands, cooked) + side * side_shade(noise, spindle);
    }
    let crack = (1.0 - smoothstep(0.015, 0.11, fascicle.r)) * smoothstep(0.42, 0.58, noise.region.a);
    let bulge = spindle.slope * (0.35 + select(0.65, 0.15, fine) * laid_open + select(0.9, 0.6, fine) * crust + select(0.0, FREED * torn * max(laid_open, side), fine));
    let rough = crust_relief(noise, max(crust, SIDE_ROUGH * side)) + FIBRED.y * fibres.xyz;
    return Grain(shade, uneven, relief(noise, crust) + bulge + rough, film_relief(noise, crust) + bulge + 0.55 * rough, ridges_of(noise), crevice, 0.0, crack, (noise.region.gbr - 0.5) * STRAYS + (noise.broad.gbr - 0.5) * (0.3 * STRAYS));
}

// Strands of ground meat, some 3 mm thick and pressed together, with crumbs of fat and dark gaps.
fn ground(rest: vec3<f32>, cooked: f32, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(1.0));
    let warped = rest + food.place.xyz + (noise.broad.rgb - 0.5) * 0.0030;
    let strand = textureSample(bundle_picture, tile_sampler, warped.xy * 21.0 + warped.z * vec2<f32>(17.0, -9.0));
    let crumb = textureSample(bundle_picture, tile_sampler, warped.yx * 47.0 + warped.z * vec2<f32>(31.0, 23.0) + 0.37);
    let gap = 1.0 - smoothstep(0.02, 0.22, strand.r);
    let fat = smoothstep(0.80, 0.86, crumb.g) * smoothstep(0.05, 0.30, crumb.r);
    let light = 0.09 * (strand.g - 0.5) + 0.06 * (crumb.g - 0.5) + 0.09 * (noise.grain.a - 0.5) + 0.05 * (noise.fine.a - 0.5);
    var shade = vec3<f32>(light - 0.07 * gap, -0.06 * light, 0.02 * light);
    shade += fat * mix(vec3<f32>(0.20, -0.12, 0.0), vec3<f32>(0.06, -0.01, 0.03), cooked);
    let round = (noise.broad.rgb - 0.5) * 0.55 * (0.4 + gap);
    let crevice = 1.0 - gap * (0.35 + 0.30 * crust);
    let islands = 1.5 * (1.0 - crust) * (far_noise(rest) - 0.5);
    return Grain(shade, islands + patches(noise) + 0.5 * (strand.g - 0.5) - 0.5 * gap, relief(noise, 0.5 + 0.5 * crust) + round + 0.25 * crust_relief(noise, crust), film_relief(noise, crust), ridges_of(noise), crevice, 0.0, 0.0, vec3<f32>(0.0));
}

// A root cut across its axis: rays from the core, a thin line where both meet, a rougher skin at the side.
fn root(rest: vec3<f32>, grew: Grown, cooked: f32, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(1.0));
    let across = select(rest.xy, rest.yz, food.place.w > 0.5);
    let away = max(length(across), 1e-4);
    let turn = atan2(across.y, across.x) + food.place.x * 30.0;
    // Fine rays, stronger in the cortex; the picture tiles once around.
    let ray = textureSample(bundle_picture, tile_sampler, vec2<f32>(turn * 0.4775, away * 26.0));
    let rays = (ray.g - 0.5) * smoothstep(0.001, 0.004, away);
    let line = 1.0 - smoothstep(0.00008, 0.00042, grew.border);
    let light = 0.055 * rays * (1.3 - grew.second) + 0.05 * (noise.grain.a - 0.5) + 0.03 * (noise.fine.a - 0.5) + 0.05 * (noise.region.a - 0.5);
    var shade = vec3<f32>(light, 0.25 * light, 0.35 * light);
    shade += line * vec3<f32>(-0.035, 0.02, 0.01);
    // Cells at the heart of the core are pale.
    shade += vec3<f32>(0.035, -0.03, 0.015) * smoothstep(0.0022, 0.0006, away) * grew.second;
    let uneven = patches(noise) + 0.9 * rays - 0.4 * grew.second;
    let crevice = 1.0 - crust * 0.30 * smoothstep(0.52, 0.30, noise.grain.a);
    return Grain(shade, uneven, relief(noise, 0.5 * crust) * 0.75, film_relief(noise, crust) * 0.6, ridges_of(noise), crevice, 0.35, 0.0, vec3<f32>(0.0));
}

// A smooth coat over flesh - skin, wax, juice that set - by which the window is seen: share, roughness and slope (rest frame).
var<private> skin_gloss: f32 = 0.0;
var<private> skin_rough: f32 = 0.2;
var<private> skin_slope: vec3<f32> = vec3<f32>(0.0);
// Share of the window's light that comes through flesh from behind.
var<private> lets_through: f32 = 0.0;
// Height of the place over what the food lies on [m]; far above where it is not told, as in a cut.
var<private> above_support: f32 = 1.0;

// A free value of a whole piece (0-1).
fn own_tone(k: f32) -> f32 {
    return fract(dot(food.place.xyz, vec3<f32>(913.7, 377.3, 571.9)) * (1.0 + k) + 0.31 * k);
}

fn solid(place: vec3<f32>) -> vec4<f32> {
    return textureSample(solid_noise, tile_sampler, place);
}

// How far the borders of sheaths stray from their rings [m] (chosen: layers that are thick here and thin there, within the steps).
const WANDERS = 0.0030;

fn wander(rest: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(about(rest, vec3<f32>(16.0)).rg, 0.0) * WANDERS;
}

// Sheaths of a shaft: each with its own tone, dark gaps between, fine veins along the axis.
fn sheaths(rest: vec3<f32>, grew: Grown, upright: f32, cooked: f32, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(1.0, 1.0, 0.25));
    let turn = atan2(rest.y, rest.x);
    let vein = textureSample(bundle_picture, tile_sampler, vec2<f32>(turn * 1.2732, 0.31 + rest.z * 4.0));
    let gap = 1.0 - smoothstep(0.00006, 0.00034, grew.border);
    let glow = smoothstep(0.0002, 0.0010, grew.border);
    let side = 1.0 - upright;
    let light = 0.07 * (grew.tone - 0.5) + 0.045 * (vein.g - 0.5) * (0.4 + side) + 0.03 * (noise.grain.a - 0.5) + 0.03 * (noise.region.a - 0.5);
    var shade = vec3<f32>(light, -0.25 * light, 0.2 * light);
    // Flesh near a gap is thin and lets light through; the gap itself is in shadow.
    shade += vec3<f32>(-0.05, -0.015, 0.045) * (1.0 - glow) * upright;
    shade += vec3<f32>(-0.11, 0.0, 0.05) * gap * upright * (0.2 + 1.0 * grew.tone);
    let uneven = patches(noise) + 1.1 * (1.0 - glow) * upright - 0.3;
    let crevice = 1.0 - gap * upright * (0.40 + 0.2 * crust);
    let step = (noise.broad.rgb - 0.5) * 0.2 * gap;
    let grain = Grain(shade, uneven, relief(noise, 0.4 * crust) * 0.6 + step, film_relief(noise, crust) * 0.5, ridges_of(noise), crevice, 0.5, 0.0, vec3<f32>(0.0));
    if (!fine) { return grain; }
    return layered(grain, rest, grew, noise, upright, cooked);
}

// Layers near by: fine veins in each, gaps that open here and close there, glassy and milky parts, browned parts of rims.
fn layered(given: Grain, rest: vec3<f32>, grew: Grown, noise: Noise, upright: f32, cooked: f32) -> Grain {
    var grain = given;
    let turn = atan2(rest.y, rest.x);
    // The thick scales of an onion cling to each other.
    let onion = smoothstep(-0.20, -0.10, food.second.x);
    let opens = smoothstep(-0.08, 0.10, about(rest + 0.1 * grew.tone, vec3<f32>(23.0)).a - 0.5 * onion);
    let dark = smoothstep(0.00016 + 0.00034 * opens, 0.00004, grew.border) * upright;
    // Veins run round in each layer; on the side they run up as ribs.
    let strand = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(turn * 1.9099, length(rest.xy) * 150.0, grew.tone), 0.0);
    let ribs = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(turn * 5.7296, rest.z * 9.0, grew.tone), 0.0);
    let lines = mix(ribs.a, strand.a, upright) - 0.5;
    // Glassy where the cells have burst, most in the middle of a layer; milky elsewhere.
    let middle = smoothstep(0.0003, 0.0018, grew.border) * upright * onion;
    let glassy = smoothstep(0.38, 0.64, noise.region.a);
    grain.shade += vec3<f32>(0.16, -0.05, 0.0) * lines + vec3<f32>(0.20, 0.0, -0.05) * (grew.tone - 0.5);
    grain.shade.x += 0.06 * (own_tone(1.0) - 0.5) - cooked * 0.12 * (glassy - 0.6 + middle - 0.4 * onion) - 0.20 * dark * opens;
    // Browning bites rims that stood proud, over parts of their round.
    let bitten = smoothstep(0.0, 0.16, about(rest + 0.07 * grew.tone, vec3<f32>(26.0)).a);
    grain.uneven = patches(noise) + bitten * (1.3 + 0.7 * smoothstep(0.0015, 0.00035, grew.border)) + 0.8 * lines - 0.85;
    grain.slope += (strand.rgb - 0.5) * 0.35 * upright + (noise.broad.gbr - 0.5) * 0.30;
    grain.crevice *= 1.0 - dark * (0.2 + 0.4 * opens);
    skin_gloss = (0.30 + 0.50 * glassy) * (1.0 - dark);
    skin_slope = (noise.region.gbr - 0.5) * 0.35;
    lets_through = 0.16 * (1.0 - dark);
    return grain;
}

// Six segments: coral bands of fine specks over the back once cooked, grey specks, a dark vein and clear flesh before; a
// white belly.
fn shrimp(rest: vec3<f32>, along: f32, dorsal: f32, cooked: f32, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(0.8));
    // Bands bow towards the tail over the back and stray from segment to segment.
    let segments = along / 0.83 * 6.0 + 0.12 * (noise.broad.a - 0.5) + 0.3 * (noise.region.a - 0.5) - 0.16 * dorsal * dorsal;
    let within = fract(segments);
    let fan = smoothstep(0.80, 0.87, along);
    // The band is on the rear half of each segment and thins out towards the belly; seen near by it is made of specks.
    let band = smoothstep(0.15, 0.60, within) * smoothstep(0.95, 0.66, within) * (0.7 + 0.6 * noise.region.g) + 0.15 * smoothstep(0.35, 0.65, noise.broad.a);
    let back = smoothstep(-0.75, 0.65, dorsal + 0.6 * (noise.region.a - 0.5));
    let pigment = smoothstep(0.30, 0.72, 0.5 * noise.fine.a + 0.5 * noise.grain.a + 0.22 * (band - 0.5));
    let red = mix(1.3 * band * (0.12 + 0.88 * back) * (0.40 + 0.60 * pigment), 0.85, fan);
    let specks = smoothstep(0.56, 0.70, noise.fine.a + 0.35 * (noise.grain.a - 0.5));
    // Where a segment slides under the next there is a thin line, and beside it flesh is double.
    let plate = (1.0 - fan) * smoothstep(0.0, 0.3, segments) * (0.4 + 0.6 * noise.region.b);
    let joint = smoothstep(0.90, 0.97, within) * plate;
    let pearl = (noise.grain.a - 0.5) * 0.05 + (noise.fine.a - 0.5) * 0.03;
    let vein = smoothstep(0.78, 0.97, dorsal) * (1.0 - fan) * smoothstep(0.3, 0.6, noise.broad.a + 0.3);
    let done = vec3<f32>(0.085, -0.105, -0.095) * (1.0 - red) + vec3<f32>(-0.085, 0.135, 0.10) * red;
    // Raw flesh is glassy and pale grey, its bands faintly pink.
    let deep = vec3<f32>(-0.03, 0.0, -0.030);
    let raw = deep + vec3<f32>(-0.05, 0.035, 0.02) * red - vec3<f32>(0.11, -0.01, 0.0) * specks * (0.25 + 0.75 * back) - vec3<f32>(0.14, 0.0, 0.02) * vein;
    var shade = mix(raw, done, smoothstep(0.15, 0.85, cooked)) + vec3<f32>(pearl, 0.0, 0.0);
    shade.x += (0.05 * cooked - 0.09) * joint + 0.05 * plate * smoothstep(0.16, 0.0, within);
    // The tail fan keeps its shell: ribbed, darker and redder.
    let rib = abs(fract(along * 60.0 + 2.0 * noise.broad.a) - 0.5) * 2.0;
    shade += fan * mix(vec3<f32>(-0.12, 0.02, 0.03), vec3<f32>(-0.10 - 0.05 * rib, 0.07, 0.03), cooked);
    let crevice = 1.0 - 0.22 * joint;
    // Char comes in small freckles on what protrudes, not in sheets.
    let uneven = patches(noise) + 0.8 * (noise.region.g + noise.fine.a - 1.0) - 0.3 * fan;
    if (fine) {
        // Fine strands across clear flesh.
        let streak = solid(vec3<f32>(segments * 1.7, dorsal * 0.25, food.place.x * 30.0)).a - 0.5;
        shade.x += 0.10 * (1.0 - cooked) * streak;
        lets_through = 0.06;
        skin_gloss = 1.6 - 0.6 * cooked;
        skin_rough = 0.09 + 0.07 * cooked;
        skin_slope = (noise.region.gbr - 0.5) * 0.22 + (noise.broad.rgb - 0.5) * 0.3 + (noise.grain.rgb - 0.5) * (0.2 * cooked);
    }
    return Grain(shade, uneven, relief(noise, 0.5 * crust) * 0.55 + (noise.grain.rgb - 0.5) * 0.2, film_relief(noise, crust) * 0.7, ridges_of(noise), crevice, 1.0 - 0.75 * cooked, 0.0, vec3<f32>(0.0));
}

// Thickness of a flake of fish [m] (chosen: 6 to 8 mm in portions of cod and salmon).
const FLAKE = 0.0068;

// Distance to the nearest sheet between flakes [m], and the number of the flake: they slant through the thickness and are bent over the width.
fn flake_at(rest: vec3<f32>, noise: vec4<f32>) -> vec2<f32> {
    let bent = 0.62 * abs(rest.y - 0.006) + 0.0016 * sin(rest.y * 310.0);
    let along = rest.x + bent + 0.55 * rest.z + (noise.r - 0.5) * 0.0042;
    let at = along / FLAKE + food.place.x * 30.0;
    let place = fract(at);
    return vec2<f32>(FLAKE * min(place, 1.0 - place), floor(at));
}

// Share of pale tissue between flakes: broad lines and hair lines.
fn sheets(rest: vec3<f32>) -> f32 {
    let broad = textureSample(solid_noise, tile_sampler, (rest + food.place.xyz) * 54.0);
    let width = 0.00035 + 0.00075 * smoothstep(0.35, 0.75, broad.a);
    return 0.80 * (1.0 - smoothstep(0.25 * width, width, flake_at(rest, broad).x));
}

// Fish: flakes with pale sheets between them, which part as they cook; fine fibres run across each flake.
fn flakes(rest: vec3<f32>, cooked: f32, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(0.35, 1.0, 1.0));
    let flake = flake_at(rest, noise.broad);
    let away = flake.x;
    // Each flake turns its own way and is a little lighter or darker once they part.
    let own = fract(sin(flake.y * vec2<f32>(12.9898, 78.233)) * 43758.5453) - 0.5;
    let gap = (1.0 - smoothstep(0.00008, 0.00055, away)) * cooked;
    let tone = 0.9 * (noise.grain.a - 0.5) + 0.5 * (noise.fine.a - 0.5) + 0.8 * (noise.region.a - 0.5);
    let light = 0.055 * tone + (0.020 * smoothstep(0.0, 0.5 * FLAKE, away) + 0.045 * own.x) * cooked - 0.035 * gap;
    let shade = vec3<f32>(light, -0.12 * light * (1.0 - cooked), 0.10 * light);
    let facet = vec3<f32>(own.x, 0.4 * own.y, own.y) * 0.45 * cooked * (1.0 - 0.7 * crust);
    let step = (noise.broad.rgb - 0.5) * 0.5 * gap + facet;
    let crevice = 1.0 - gap * (0.09 + 0.30 * crust);
    return Grain(shade, patches(noise) + 0.5 * (noise.fine.a - 0.5) - 0.6 * gap, relief(noise, 0.7 * crust) * 0.75 + step, film_relief(noise, crust), ridges_of(noise), crevice, 0.45 * (1.0 - cooked), 0.0, vec3<f32>(0.0));
}

fn plain(noise: Noise, crust: f32) -> Grain {
    let light = 0.06 * (noise.grain.a - 0.5) + 0.05 * (noise.region.a - 0.5) + 0.03 * (noise.fine.a - 0.5);
    let crevice = 1.0 - crust * 0.30 * smoothstep(0.52, 0.30, noise.grain.a);
    return Grain(vec3<f32>(light, 0.0, 0.2 * light), patches(noise), relief(noise, crust) * 0.8, film_relief(noise, crust), ridges_of(noise), crevice, 0.2, 0.0, vec3<f32>(0.0));
}

// Place over the half extents of the piece (-1 to 1), and how far inside of them it is [m].
fn over_extent(rest: vec3<f32>) -> vec3<f32> {
    return 2.0 * (rest - food.grain_origin.xyz) * food.grain_scale.xyz - 1.0;
}

fn inset(rest: vec3<f32>) -> vec3<f32> {
    return 0.5 / food.grain_scale.xyz * (1.0 - abs(over_extent(rest)));
}

// Free values about 0.
fn about(rest: vec3<f32>, stretch: vec3<f32>) -> vec4<f32> {
    return solid((rest + food.place.xyz) * stretch + 0.21) - 0.5;
}

// Foods with a structure that is seen near by only: smooth and moist besides.
fn structured(rest: vec3<f32>, grew: Grown, normal: vec3<f32>, cooked: f32, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(1.0));
    var grain = plain(noise, crust);
    if (!fine || texture_kind < MUSHROOM) { return grain; }
    let region = noise.region - 0.5;
    grain.uneven *= 0.5;
    grain.slope = grain.slope * 0.4 + region.rgb * 0.3;
    grain.film_slope *= 0.4;
    skin_gloss = 0.8;
    skin_slope = region.rgb * 0.4;
    switch texture_kind {
        case MUSHROOM: { return mushroom(grain, rest, region, cooked); }
        case EGG: { return egg(grain, rest, region, grew, cooked); }
        case LAYERS: { return layers(grain, rest, region, cooked); }
        default: { return pod(grain, rest, region, grew.second, normal, cooked); }
    }
}

// Colours of gills and of skin over that of a mushroom's flesh, and how much lighter that is, so that the mean stays (L*a*b* / 100).
const GILLS = vec3<f32>(-0.50, 0.035, 0.0);
const CAP_SKIN = vec3<f32>(-0.25, 0.045, 0.05);
const CAP_FLESH = 0.115;

// A slice through cap and stem: thin skin round the cap, gills that fan out under an arch in it (lines chosen: those of the outline
// in the food's table), strands along the stem.
fn mushroom(given: Grain, rest: vec3<f32>, region: vec4<f32>, cooked: f32) -> Grain {
    var grain = given;
    let comb = about(rest + vec3<f32>(27.0 * rest.x * rest.y, 0.0, 0.0), vec3<f32>(150.0, 6.0, 6.0)).a;
    let strand = about(rest, vec3<f32>(230.0, 14.0, 14.0)).a;
    let at = over_extent(rest + region.rgb * 0.003);
    let x = abs(at.x);
    let skin = smoothstep(0.86, 0.91, length(at.xy)) * smoothstep(-0.30, -0.05, at.y);
    let below = 0.40 - 2.4 * (x - 0.54) * (x - 0.54) - at.y + 0.12 * comb;
    let gills = smoothstep(0.0, 0.02, below) * smoothstep(0.28, 0.34, x) * smoothstep(0.90, 0.80, x) * (1.0 - skin);
    let stem = smoothstep(0.42, 0.26, x) * smoothstep(0.45, -0.05, at.y);
    grain.shade += gills * mix(GILLS, 0.4 * GILLS, smoothstep(-0.08, 0.08, comb)) + skin * CAP_SKIN;
    // Glassy where the gas is gone.
    grain.shade.x += CAP_FLESH * (1.0 - gills) + 0.16 * stem * strand - 0.12 * cooked * region.g;
    // It browns in clouds.
    grain.uneven += 2.6 * region.a + 1.6 * (far_noise(rest) - 0.5) + 0.3 * skin;
    skin_gloss = 0.35 * cooked * (1.0 - gills);
    return grain;
}

// A piece of a scale: fine veins along it, a papery skin that came off in part, glassy flesh, edges that brown.
fn layers(given: Grain, rest: vec3<f32>, region: vec4<f32>, cooked: f32) -> Grain {
    var grain = given;
    let own = own_tone(1.0) - 0.5;
    let bent = rest + vec3<f32>(0.0, rest.x * (0.5 * own + 4.0 * rest.x), 0.0);
    let veins = about(bent, vec3<f32>(9.0, 150.0, 24.0));
    let hairs = about(bent, vec3<f32>(16.0, 400.0, 40.0)).a;
    let inside = inset(rest);
    let edge = smoothstep(0.0032, 0.0006, min(inside.x, inside.y) + 0.006 * region.b);
    let far = far_noise(rest) - 0.5;
    let glassy = clamp(3.0 * (region.a + far), -0.5, 0.5);
    let torn = far + 0.9 * own + 0.4 * region.b + 12.0 * rest.x * sign(own);
    let paper = smoothstep(0.0, 0.03, torn);
    // The skin ends in a curled edge.
    let curl = paper * smoothstep(0.07, 0.03, torn);
    let light = 0.12 * smoothstep(0.0, 0.18, veins.a) + 0.10 * hairs + 0.16 * own - 0.16 * glassy * cooked + 0.07 * paper + 0.10 * curl - 0.08;
    grain.shade = vec3<f32>(light, 0.0, -0.4 * light);
    grain.uneven += edge * (0.9 + 2.0 * region.g) + 0.5 * glassy - 0.5;
    grain.slope.y += 0.5 * veins.g;
    skin_slope.y += 0.25 * veins.g;
    grain.clear = 0.6;
    skin_gloss += 0.5 * glassy - 0.4 * paper;
    lets_through = 0.18;
    return grain;
}

// How thick a pod's skin is seen on a cut [m] (chosen: the green runs a little way into the wall).
const POD_SKIN = 0.0007;

// A strip of a pod's wall: waxy skin on one of its two faces, which blisters and browns on its blisters; the other face and what the
// knife laid bare is wet, ribbed flesh.
fn pod(given: Grain, rest: vec3<f32>, region: vec4<f32>, second: f32, normal: vec3<f32>, cooked: f32) -> Grain {
    var grain = given;
    let bare = smoothstep(0.15, 0.70, second);
    // The place in the texture tells which face it is: as many strips lie on their skin as on their flesh.
    let outer = select(-1.0, 1.0, fract(food.place.x * 97.0) < 0.5);
    let under = (1.0 - outer * over_extent(rest).z) * 0.5 / food.grain_scale.z + 0.0006 * region.a;
    let inner = max(smoothstep(POD_SKIN, 2.2 * POD_SKIN, under), smoothstep(0.55, 0.85, abs(normal.x)) * smoothstep(0.0002, 0.0007, under));
    let skin = 1.0 - inner;
    let folds = about(rest, vec3<f32>(26.0, 120.0, 60.0)).rgb;
    let ribs = about(rest, vec3<f32>(30.0, 190.0, 40.0)) * inner;
    let bubble = about(rest, vec3<f32>(75.0));
    let blister = smoothstep(0.04, 0.20, bubble.a + region.b) * cooked * skin;
    grain.shade = mix(vec3<f32>(-0.08, -0.02, 0.05), vec3<f32>(0.02, 0.0, 0.04), inner) + (inner - bare) * food.second.xyz;
    grain.shade.x += 0.24 * ribs.a + 0.08 * region.a;
    grain.uneven += skin * (smoothstep(0.0, 0.10, 0.6 * bubble.a + 0.4 * region.g) - 0.3) + 0.3 * ribs.a;
    let rough = bubble.rgb * blister + folds * 0.3 * skin + vec3<f32>(0.0, 0.8 * ribs.g, 0.0);
    grain.slope += rough;
    skin_slope = region.rgb * 0.2 + 0.5 * rough;
    skin_rough = mix(0.24, 0.12, skin);
    return grain;
}

// How far round about a place the yolk is looked for [m]: its volume is coarse and would flute its edge (chosen: a cell).
const YOLK_ROUND = 0.0026;

// How near the yolk is (0-1); seen from above it is read where it is widest.
fn yolk_at(rest: vec3<f32>, normal: vec3<f32>) -> f32 {
    var at = 0.5 * over_extent(rest) + 0.5;
    if (laid_open < 0.5 && normal.z > 0.0) { at.z = 0.45; }
    var sum = 0.0;
    for (var k = 0; k < 9; k++) {
        let off = vec3<f32>(f32(k % 3 - 1), f32(k / 3 - 1), 0.0) * YOLK_ROUND;
        sum += textureSampleLevel(grain_volume, clamp_sampler, at + off * food.grain_scale.xyz, 0.0).g / 9.0;
    }
    return sum;
}

// Set white, thick and thin, that browns where it is thin; a smooth yolk.
fn egg(given: Grain, rest: vec3<f32>, region: vec4<f32>, grew: Grown, cooked: f32) -> Grain {
    var grain = given;
    let white = 1.0 - grew.second;
    // Less than five millimetres is thin.
    let thin = smoothstep(0.0050, 0.0018, above_support + 0.004 * region.a);
    let large = about(rest, vec3<f32>(27.0));
    let small = about(rest, vec3<f32>(130.0));
    let cloudy = region.a + large.a;
    grain.shade = white * (vec3<f32>(0.14, 0.0, -0.08) * cloudy - vec3<f32>(0.05, 0.01, -0.02) * thin);
    // The mesh is coarse where white that sets meets the yolk.
    grain.shade.x += 0.6 * cooked * (1.0 - cooked) * white * smoothstep(0.1, 0.5, grew.tone);
    grain.uneven = white * (0.5 * grain.uneven + 0.8 * cloudy + thin * (0.1 + small.a)) - 0.4 * grew.second;
    skin_slope = white * (small.rgb * (0.1 + 0.3 * thin) + (region.rgb + large.rgb) * 0.5);
    grain.slope = skin_slope;
    skin_gloss = 1.3;
    skin_rough = 0.18 - 0.06 * grew.second;
    return grain;
}
