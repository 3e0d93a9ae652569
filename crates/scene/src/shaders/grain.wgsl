// What the flesh of each food looks like finer than its mesh: a solid texture in the rest frame, the same outside and in
// any cut. One of them is chosen when the pipeline is made.

const MUSCLE = 0u;
const GROUND = 1u;
const ROOT = 2u;
const SHEATHS = 3u;
const SHRIMP = 4u;
const FLAKES = 5u;
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
const SLANT = vec2<f32>(0.24, -0.31);

// How far bundles stray by region [m] (chosen).
const LEANS = 0.0045;

// Pitch of the bundles across and along the fibres [m] (chosen: irregular cells of 2 to 6 mm; a knife
// that crosses them leaves short ends, not lines), and
// how far they are bent over a slice, by region and near by [m].
const BUNDLE = vec3<f32>(0.0032, 0.0032, 0.0066);
const BENDS = vec3<f32>(0.0150, 0.0034, 0.0009);
// Steepest lean of a bundle's fibres off the mean (chosen: 29°), and how high a bundle bulges [m] (chosen: to be felt, not seen
// as cobbles).
const FIBRE_LEAN = 0.55;
const BULGE = 0.00011;

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
const STRANDS = 0.210;
const JOINT_MEAN = 0.004;
// How much redder one bundle is than the next, a* / 100 (chosen).
const HUES = 0.035;

fn parted(apart: f32, torn: f32, tone: f32, strands: f32, cooked: f32) -> vec3<f32> {
    let light = apart * mix(JOINT * (1.0 - 0.5 * cooked), -TORN, torn) + BUNDLE_TONES * (tone - 0.5) + STRANDS * (1.0 + 0.3 * cooked) * strands - JOINT_MEAN;
    let hue = HUES * (fract(tone * 5.3) - 0.5);
    return vec3<f32>(light, -0.10 * light + hue, 0.05 * light + 0.6 * hue);
}

// Length of what is seen of a fibre: its width over it (chosen: ends of 1 to 4 mm, as a knife leaves them).
const ENDS = 0.30;
// How much more a bundle bulges where a knife freed it and on a cooked side, and how much light the gap beside it keeps (chosen:
// bundles are told apart by their shine and by thin shadows).
const FREED = 1.25;
const GAP_SHADOW = 0.22;

// The grain of a bundle, along its own fibres.
fn along_fibres(noise: Noise, rest: vec3<f32>, shift: vec3<f32>) -> Noise {
    let place = rest + food.place.xyz + shift + vec3<f32>(rest.z * SLANT, 0.0);
    let stretch = vec3<f32>(1.0, 1.0, ENDS);
    // Shifts leap from bundle to bundle: they do not count in the size of a pixel.
    let x = dpdx(rest) * stretch;
    let y = dpdy(rest) * stretch;
    let grain = textureSampleGrad(solid_noise, tile_sampler, place * 250.0 * stretch + 0.37, x * 250.0, y * 250.0);
    let fibre = textureSampleGrad(solid_noise, tile_sampler, (place * 610.0 * stretch).yxz + 0.11, x.yxz * 610.0, y.yxz * 610.0);
    return Noise(noise.region, noise.broad, grain, fibre);
}

// Tones of a cooked side, by region, by bundle and near by, and how much light its pores and its cracks keep back (chosen: it dried
// and shrank, so it is neither smooth nor even).
const SIDE_TONES = vec3<f32>(0.14, 0.06, 0.16);
const PORES = 0.42;
const CRACKS = 0.38;
// Colour of a cooked side over that of the flesh in it, L*a*b* / 100 (chosen: air and fat took its pink).
const SIDE_TINT = vec3<f32>(-0.020, -0.025, 0.035);
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
const CRUST_STEEP = vec3<f32>(0.45, 0.60, 0.16);
const PITTED = 0.30;
// How much more a crust's browning varies near by than that of flesh (chosen: red-brown dips between dark blisters).
const BLISTERED = 0.48;

fn crust_relief(noise: Noise, crust: f32) -> vec3<f32> {
    if (!fine) { return vec3<f32>(0.0); }
    return crust * ((noise.region.gbr - 0.5) * CRUST_STEEP.x + (noise.broad.rgb - 0.5) * CRUST_STEEP.y + (noise.grain.rgb - 0.5) * CRUST_STEEP.z);
}

// Fibres along z in bundles of 0.8 mm, in fascicles of 3.6 mm with pale tissue between some of them.
fn muscle(rest: vec3<f32>, cooked: f32, crust: f32) -> Grain {
    var noise = noise_at(rest, vec3<f32>(1.0, 1.0, 0.17));
    var spindle = Bundle(0.5, vec3<f32>(0.0), vec3<f32>(0.0), 0.5);
    if (fine) {
        spindle = bundle_at(rest, noise.region, noise.broad);
        noise = along_fibres(noise, rest, spindle.shift);
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
    let torn = select(smoothstep(0.40, 0.62, noise.broad.a), smoothstep(0.42, 0.66, 0.5 * noise.broad.a + 0.5 * noise.region.a), fine);
    let strands = 1.1 * (noise.grain.a - 0.5) + 0.9 * (noise.fine.a - 0.5) + 0.45 * (bundle.g - 0.5);
    if (fine) { shade += laid_open * parted(apart, torn, spindle.tone, strands, cooked); }
    // A seared face is deep and even from afar, and varied near by; where it browns late, it does so in islands.
    let islands = (1.0 - smoothstep(0.70, 1.0, crust)) * (2.6 * (far_noise(rest) - 0.46) + 2.0 * (noise.region.a - 0.47));
    let blistered = 1.0 + select(0.0, BLISTERED * crust, fine);
    let uneven = islands + blistered * (0.55 * (noise.region.a - 0.5) + 0.9 * (noise.broad.a - 0.5) + 0.9 * (noise.grain.a - 0.5) + 0.5 * (noise.fine.a - 0.5) + 0.4 * tone);
    // Dips of a crust keep some light and are filled with fat; its high points, which lay on the metal, are the dark ones.
    let high = smoothstep(0.42, 0.70, 0.25 * noise.region.a + 0.40 * noise.broad.a + 0.35 * noise.grain.a);
    // Between bundles a crust is creased here and there only.
    let creased = select(0.25, 0.20 * smoothstep(0.48, 0.64, noise.region.a), fine);
    var crevice = 1.0 - crust * (creased * (1.0 - smoothstep(0.0, 0.30, fascicle.r)) + 0.30 * smoothstep(0.50, 0.30, noise.grain.a) + select(0.24, 0.34, fine) * high);
    if (fine) { crevice *= 1.0 - crust * PITTED * smoothstep(0.47, 0.31, 0.25 * noise.region.a + 0.45 * noise.broad.a + 0.30 * noise.grain.a); }
    let crack = (1.0 - smoothstep(0.015, 0.11, fascicle.r)) * smoothstep(0.42, 0.58, noise.region.a);
    if (fine) { crevice *= 1.0 - GAP_SHADOW * laid_open * apart * (0.25 + 0.75 * torn) * (0.7 + 0.6 * cooked); }
    if (fine) { shade.x += laid_open * cooked * CLOUDED * (noise.region.a + 0.5 * noise.broad.a - 0.75); }
    if (fine) { shade += aside * cooked * side_shade(noise, spindle); }
    if (fine) { crevice *= 1.0 - aside * cooked * pores(noise, apart * torn); }
    let bulge = spindle.slope * (0.35 + select(0.65, 0.15, fine) * laid_open + select(0.9, 0.6, fine) * crust + select(0.0, FREED * torn * max(laid_open, aside * cooked), fine));
    let rough = crust_relief(noise, max(crust, SIDE_ROUGH * aside * cooked));
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
    return Grain(shade, islands + patches(noise) + 0.5 * (strand.g - 0.5) - 0.5 * gap, relief(noise, 0.5 + 0.5 * crust) + round + 0.6 * crust_relief(noise, crust), film_relief(noise, crust), ridges_of(noise), crevice, 0.0, 0.0, vec3<f32>(0.0));
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
const WANDERS = vec2<f32>(0.0028, 0.0009);

fn wander(rest: vec3<f32>) -> vec3<f32> {
    let place = rest + food.place.xyz;
    let far = textureSampleLevel(solid_noise, tile_sampler, place * 11.0 + 0.23, 0.0).rg - 0.5;
    let near = textureSampleLevel(solid_noise, tile_sampler, place * 60.0 + 0.71, 0.0).rg - 0.5;
    return vec3<f32>(far * WANDERS.x + near * WANDERS.y, 0.0);
}

// Sheaths of a shaft: each with its own tone, dark gaps between, fine veins along the axis.
fn sheaths(rest: vec3<f32>, grew: Grown, upright: f32, cooked: f32, browning: f32, crust: f32) -> Grain {
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
    var uneven = patches(noise) + 1.1 * (1.0 - glow) * upright - 0.3;
    var crevice = 1.0 - gap * upright * (0.40 + 0.2 * crust);
    var step = (noise.broad.rgb - 0.5) * 0.2 * gap;
    if (fine) {
        let layer = layered(rest, grew, noise, upright, cooked, browning);
        shade += layer.shade;
        uneven = layer.uneven;
        crevice *= layer.crevice;
        step += layer.slope;
    }
    return Grain(shade, uneven, relief(noise, 0.4 * crust) * 0.6 + step, film_relief(noise, crust) * 0.5, ridges_of(noise), crevice, 0.5, 0.0, vec3<f32>(0.0));
}

// What is added to flesh when it is seen near by.
struct Near {
    shade: vec3<f32>,
    uneven: f32,
    slope: vec3<f32>,
    crevice: f32,
};

// Layers near by: radial strands in each, gaps that open here and close there, glassy and milky parts, scorched parts of rims.
fn layered(rest: vec3<f32>, grew: Grown, noise: Noise, upright: f32, cooked: f32, browning: f32) -> Near {
    let place = rest + food.place.xyz;
    let away = max(length(rest.xy), 1e-4);
    let out = vec3<f32>(rest.xy / away, 0.0);
    let turn = atan2(rest.y, rest.x);
    let side = 1.0 - upright;
    // Some gaps are wide open, some are closed.
    let opens = smoothstep(0.42, 0.60, solid(place * 23.0 + grew.tone * 3.1).a);
    let dark = (1.0 - smoothstep(0.00004, 0.00016 + 0.00034 * opens, grew.border)) * upright;
    // Cut strands stand across each layer; on the side they run up as ribs.
    let ring = vec3<f32>(turn * 1.9, away * 14.0, rest.z * 9.0);
    let strand = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(turn * 3.8197, away * 38.0, 0.3 + 0.05 * grew.tone), 0.0);
    let ribs = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(turn * 5.7296, rest.z * 9.0, ring.y * 0.02), 0.0);
    let lines = mix(strand.a, ribs.a, side) - 0.5;
    // Glassy where the cells have burst, milky elsewhere.
    let glassy = smoothstep(0.40, 0.62, 0.6 * noise.region.a + 0.4 * solid(place.zxy * 33.0 + 0.4).a);
    let own = own_tone(1.0) - 0.5;
    let light = 0.11 * lines + 0.13 * (grew.tone - 0.5) - 0.075 * (glassy - 0.5) * cooked + 0.06 * own;
    var shade = vec3<f32>(light + 0.02, 0.015 * (glassy - 0.5) - 0.05 * lines, 0.05 * (0.5 - grew.tone) + 0.03 * own);
    // Green of an onion turns to straw.
    // The skin of a layer is a thin pale line beside its gap.
    let film = smoothstep(0.00030, 0.00046, grew.border) * (1.0 - smoothstep(0.00050, 0.00085, grew.border));
    shade += vec3<f32>(0.055, 0.0, -0.03) * film * upright;
    shade -= vec3<f32>(0.20, -0.02, 0.02) * dark * opens;
    // Browning bites rims that stood proud, over parts of their round, and leaves the rest.
    let part = solid(vec3<f32>(rest.xy * 26.0, 0.0) + food.place.xyz * 9.0 + vec3<f32>(0.0, 0.0, grew.tone * 2.3)).a;
    let near_rim = 1.0 - smoothstep(0.00035, 0.0015, grew.border);
    let bitten = smoothstep(0.50, 0.66, part + 0.12 * (noise.grain.a - 0.5));
    let scorched = browning * bitten * (0.35 + 0.65 * near_rim) * upright;
    shade += scorched * vec3<f32>(-0.20, 0.055, 0.17) * smoothstep(0.30, 0.62, 0.5 * noise.grain.a + 0.3 * noise.broad.a + 0.2 * noise.fine.a);
    let uneven = patches(noise) + 1.3 * (bitten - 0.45) + 0.7 * near_rim * bitten + 0.8 * lines - 0.25;
    skin_gloss = (0.30 + 0.60 * glassy) * mix(0.85, 0.6, side) * (1.0 - dark) * (1.0 - 0.7 * scorched);
    skin_rough = 0.19;
    let bowl = out * ((grew.tone - 0.5) * 0.12) * upright;
    skin_slope = (noise.region.gbr - 0.5) * 0.30 + (noise.broad.rgb - 0.5) * 0.16 + (noise.grain.rgb - 0.5) * 0.10 + bowl;
    lets_through = 0.16 * (0.6 + 0.8 * glassy) * (1.0 - dark);
    let slope = (strand.rgb - 0.5) * 0.35 * upright + (noise.broad.gbr - 0.5) * 0.30 + bowl;
    return Near(shade, uneven, slope, 1.0 - 0.60 * dark * (0.35 + 0.65 * opens));
}

// Six segments: coral bands of fine specks over the back once cooked, grey specks, a dark vein and clear flesh before; a
// white belly.
fn shrimp(rest: vec3<f32>, along: f32, dorsal: f32, cooked: f32, browning: f32, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(0.8, 0.8, 0.8));
    let waver = 0.34 * (noise.broad.a - 0.5) + 0.14 * (noise.grain.a - 0.5);
    var segments = along / 0.83 * 6.0 + waver;
    // Bands bow towards the tail over the back and stray from segment to segment.
    if (fine) { segments += 0.30 * (far_noise(rest) - 0.5) + 0.5 * (noise.region.a - 0.5) - 0.16 * dorsal * dorsal; }
    let within = fract(segments);
    let fan = smoothstep(0.80, 0.87, along);
    // The band is on the rear half of each segment and thins out towards the belly; seen near by it is made of specks.
    var band = smoothstep(0.05, 0.62, within) * (1.0 - smoothstep(0.80, 1.0, within));
    if (fine) { band = 0.85 * smoothstep(0.02, 0.50, within) * (1.0 - smoothstep(0.68, 1.0, within)) * (0.7 + 0.6 * noise.region.g) + 0.18 * smoothstep(0.35, 0.65, noise.broad.a); }
    let back = smoothstep(-0.75, 0.65, dorsal + 0.6 * (noise.region.a - 0.5));
    let pigment = smoothstep(0.30, 0.72, 0.5 * noise.fine.a + 0.5 * noise.grain.a + 0.22 * (band - 0.5));
    var red = mix(band * (0.20 + 0.80 * back) * (0.55 + 0.45 * pigment), 0.85, fan);
    if (fine) { red = mix(1.15 * band * (0.14 + 0.86 * back) * (0.50 + 0.50 * pigment), 0.85, fan); }
    let specks = smoothstep(0.56, 0.70, noise.fine.a + 0.35 * (noise.grain.a - 0.5));
    var joint = (smoothstep(0.92, 0.99, within) + 1.0 - smoothstep(0.0, 0.05, within)) * (1.0 - fan) * step(0.05, segments);
    if (fine) { joint = (smoothstep(0.72, 1.0, within) + 1.0 - smoothstep(0.0, 0.22, within)) * 0.55 * (1.0 - fan) * smoothstep(0.0, 0.3, segments) * (0.3 + 0.7 * noise.region.a); }
    let pearl = (noise.grain.a - 0.5) * 0.05 + (noise.fine.a - 0.5) * 0.03;
    let vein = smoothstep(0.90, 0.985, dorsal) * (1.0 - fan) * smoothstep(0.3, 0.6, noise.broad.a + 0.3);
    let done = vec3<f32>(0.085, -0.105, -0.095) * (1.0 - red) + vec3<f32>(-0.085, 0.135, 0.10) * red;
    // Raw flesh is glassy and pale grey, its bands faintly pink.
    let deep = vec3<f32>(-0.03, 0.0, -0.035);
    let raw = deep + vec3<f32>(-0.05, 0.035, 0.02) * red - vec3<f32>(0.11, -0.01, 0.0) * specks * (0.25 + 0.75 * back) - vec3<f32>(0.14, 0.0, 0.02) * vein;
    var shade = mix(raw, done, smoothstep(0.15, 0.85, cooked)) + vec3<f32>(pearl, 0.0, 0.0);
    shade += vec3<f32>(-0.05, 0.01, 0.02) * joint;
    // The tail fan keeps its shell: ribbed, darker and redder.
    let rib = abs(fract(along * 60.0 + 2.0 * noise.broad.a) - 0.5) * 2.0;
    shade += fan * mix(vec3<f32>(-0.12, 0.02, 0.03), vec3<f32>(-0.10 - 0.05 * rib, 0.07, 0.03), cooked);
    let fibre = (noise.grain.rgb - 0.5) * 0.20;
    let crevice = 1.0 - 0.22 * joint;
    // Char comes in small freckles on what protrudes, not in sheets.
    var uneven = patches(noise) + 0.8 * (noise.fine.a - 0.5) - 0.3 * fan;
    if (fine) {
        let touched = smoothstep(0.50, 0.64, 0.55 * far_noise(rest) + 0.45 * noise.region.a + 0.25 * (noise.grain.a - 0.5));
        shade += touched * browning * (1.0 - fan) * vec3<f32>(-0.13, 0.035, 0.115) * smoothstep(0.28, 0.62, 0.6 * noise.grain.a + 0.4 * noise.broad.a);
        uneven += 1.2 * (touched - 0.4);
        // Milky streaks and a lighter, warmer belly in clear flesh.
        let streak = solid((rest + food.place.xyz) * vec3<f32>(70.0, 160.0, 70.0) + 0.27).a - 0.5;
        shade += (1.0 - cooked) * (vec3<f32>(0.13, 0.004, 0.01) * streak + vec3<f32>(0.05, 0.012, 0.010) * (1.0 - back) - vec3<f32>(0.015, -0.008, -0.010));
        lets_through = mix(0.08, 0.05, cooked) * (1.0 - fan);
        skin_gloss = mix(1.25, 0.95, cooked) * (1.0 - 0.4 * fan);
        skin_rough = mix(0.11, 0.18, cooked);
        skin_slope = (noise.region.gbr - 0.5) * 0.22 + (noise.broad.rgb - 0.5) * mix(0.20, 0.34, cooked) + (noise.grain.rgb - 0.5) * mix(0.05, 0.22, cooked);
    }
    return Grain(shade, uneven, relief(noise, 0.5 * crust) * 0.55 + fibre, film_relief(noise, crust) * 0.7, ridges_of(noise), crevice, 0.75 * (1.0 - cooked) + 0.25, 0.0, vec3<f32>(0.0));
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

fn plain(rest: vec3<f32>, crust: f32) -> Grain {
    let noise = noise_at(rest, vec3<f32>(1.0));
    let light = 0.06 * (noise.grain.a - 0.5) + 0.05 * (noise.region.a - 0.5) + 0.03 * (noise.fine.a - 0.5);
    let crevice = 1.0 - crust * 0.30 * smoothstep(0.52, 0.30, noise.grain.a);
    return Grain(vec3<f32>(light, 0.0, 0.2 * light), patches(noise), relief(noise, crust) * 0.8, film_relief(noise, crust), ridges_of(noise), crevice, 0.2, 0.0, vec3<f32>(0.0));
}
