// What is behind the sharp part of a picture that is finished but for this, blurred as a lens would.

// Nearest. WebGL2 reads a depth texture as zeros unless a sampler without filtering is bound to it.
@group(0) @binding(1) var exact: sampler;
@group(0) @binding(2) var sharp: texture_2d<f32>;
@group(0) @binding(3) var drawn_depth: texture_2d<f32>;

const TAPS = 32;
// Turn from one reading to the next on the spiral: the golden angle [rad].
const GOLDEN = 2.39996323;

fn confusion_at(at: vec2<f32>) -> f32 {
    return confusion(distance_of(textureSampleLevel(drawn_depth, exact, at / lens.part.xy, 0.0).r));
}

@fragment
fn fs_backdrop(in: Covered) -> @location(0) vec4<f32> {
    let own = textureLoad(sharp, vec2<i32>(in.clip.xy), 0);
    let width = confusion_at(in.clip.xy);
    if (width < 0.5) { return own; }
    // Light adds up; a square is near enough to the encoding.
    var sum = vec4<f32>(own.rgb * own.rgb, 1.0);
    for (var k = 1; k <= TAPS; k++) {
        let reach = 0.5 * width * sqrt(f32(k) / f32(TAPS));
        let angle = f32(k) * GOLDEN;
        let at = clamp(in.clip.xy + vec2<f32>(cos(angle), sin(angle)) * reach, vec2<f32>(0.5), lens.part.xy - 0.5);
        // What is sharp stays where it is; only a circle that is wide enough reaches here.
        let weight = clamp(0.5 * confusion_at(at) - reach + 1.0, 0.0, 1.0) * smoothstep(0.4, 1.2, confusion_at(at));
        let light = textureLoad(sharp, vec2<i32>(at), 0).rgb;
        sum += vec4<f32>(light * light, 1.0) * weight;
    }
    let soft = sqrt(sum.rgb / sum.a);
    return vec4<f32>(mix(own.rgb, soft, smoothstep(0.5, 1.6, width)), own.a);
}
