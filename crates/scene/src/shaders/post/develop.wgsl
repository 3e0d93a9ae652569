// Radiances become a picture: focus, bloom, vignette, curve, dither.

// Exposure on top of that of the other pictures (chosen: the curve's shoulder starts lower than theirs).
const OPENED = 1.28;
// Middle grey, its value in the picture, and the rise there for each stop (chosen: a tenth steeper than sRGB alone).
const GREY = 0.18;
const GREY_SHOWN = 0.461;
const CONTRAST = 0.172;
// Stops from middle grey up to white and down to black, and how sudden shoulder and toe are (chosen: glints of the window
// are white, nothing else is; the toe is soft, so that a dark pan keeps its drawing).
const WHITE_AT = 3.3;
const BLACK_AT = 9.0;
const SHOULDER_POWER = 3.0;
const TOE_POWER = 1.5;
// How far colours are drawn together before the curve and parted after it (chosen: bright colours pale, flesh keeps its own).
const INSET = 0.16;
const OUTSET = 0.15;
// Share of the hue that is given back (chosen: wood and crust stay orange-brown).
const HUE_KEPT = 0.75;

// One half of the curve: straight at first, then bending so that it reaches `top` at `last`.
fn bend(rise: f32, last: f32, top: f32, power: f32) -> f32 {
    let limit = last / pow(pow(last / top, power) - 1.0, 1.0 / power);
    return rise / pow(1.0 + pow(rise / limit, power), 1.0 / power);
}

fn curve(x: f32) -> f32 {
    let stops = log2(max(x, 1e-6) / GREY);
    if (stops > 0.0) {
        let rise = CONTRAST * min(stops, WHITE_AT);
        return GREY_SHOWN + bend(rise, CONTRAST * WHITE_AT, 1.0 - GREY_SHOWN, SHOULDER_POWER);
    }
    let fall = CONTRAST * min(-stops, BLACK_AT);
    return GREY_SHOWN - bend(fall, CONTRAST * BLACK_AT, GREY_SHOWN, TOE_POWER);
}

fn luminance(c: vec3<f32>) -> f32 {
    return dot(c, vec3<f32>(0.2126, 0.7152, 0.0722));
}

// A curve per channel in the manner of AgX (Sobotka 2022 `[@sobotka-2022]`): between an inset and an outset of the primaries,
// so that what is too bright for its colour turns white instead of neon. Luminance is the same before and after both.
fn shown(radiance: vec3<f32>) -> vec3<f32> {
    let drawn = mix(radiance, vec3<f32>(luminance(radiance)), INSET);
    let bent = linear_from_srgb(vec3<f32>(curve(drawn.r), curve(drawn.g), curve(drawn.b)));
    let parted = (bent - OUTSET * luminance(bent)) / (1.0 - OUTSET);
    // A curve per channel turns orange to yellow; below white the hue is given back.
    let bright = luminance(radiance);
    let kept = radiance * (luminance(bent) / max(bright, 1e-6));
    let share = HUE_KEPT * (1.0 - smoothstep(0.5, 1.2, max(kept.r, max(kept.g, kept.b))));
    return clamp(mix(parted, kept, share), vec3<f32>(0.0), vec3<f32>(1.0));
}

@fragment
fn fs_develop(in: Covered) -> @location(0) vec4<f32> {
    let at = vec2<i32>(in.clip.xy);
    let halved = in.clip.xy * 0.5;
    var radiance = radiance_from_target(textureLoad(first, at, 0).rgb);
    let far = textureSampleLevel(third, linear_sampler, halved / vec2<f32>(textureDimensions(third)), 0.0);
    let blur = smoothstep(0.5, 1.6, confusion(distance_at(at))) * far.a;
    radiance = mix(radiance, far.rgb / max(far.a, 1e-4), blur);
    radiance += lens.whole.z * textureSampleLevel(second, linear_sampler, halved / vec2<f32>(textureDimensions(second)), 0.0).rgb;
    let place = (in.clip.xy + lens.part.zw) / lens.whole.xy - 0.5;
    radiance *= 1.0 - lens.whole.w * 2.0 * dot(place, place);
    let light = target_from_radiance(shown(radiance * OPENED));
    // White has no steps to hide: what is within half a step of it is white.
    let dithered = light + (noise_at(in.clip.xy) - 0.5) / 255.0;
    return vec4<f32>(select(dithered, vec3<f32>(1.0), light > vec3<f32>(0.998)), 1.0);
}
