//! Sub-mesh structure of a food as the renderer reads it: seams of fat, second tissues, borders.

use crate::skin::poured::yolk_seen;
use glam::Vec3;
use saute_kitchen::food::FoodModel;
use saute_kitchen::food::description::Flesh;
use saute_kitchen::food::tissue::noise::uniform;
use saute_scene::input::{BORDER_RANGE, BrowningPalette, FleshTexture, GrainVolume, WITHIN_RANGE};

/// Cells across a body whose tissues are along its axis (chosen: 0.2 mm cells in a leek ring).
const TISSUE_CELLS: u32 = 112;
/// Cells across and through the height of what was poured (chosen: 2 mm, which the reading smooths, and half a millimetre).
const POURED_CELLS: [u32; 2] = [72, 36];

/// Kind of texture of a food's flesh.
pub(crate) fn flesh_texture(model: &FoodModel) -> FleshTexture {
    match model.description().flesh() {
        Flesh::Muscle => FleshTexture::Muscle,
        Flesh::Ground => FleshTexture::Ground,
        Flesh::Root => FleshTexture::Root,
        Flesh::Sheaths => FleshTexture::Sheaths,
        Flesh::Segments => FleshTexture::Shrimp,
        Flesh::Flakes => FleshTexture::Flakes,
        Flesh::Plain => FleshTexture::Plain,
        Flesh::Mushroom => FleshTexture::Mushroom,
        Flesh::Egg => FleshTexture::Egg,
        Flesh::Layers => FleshTexture::Layers,
        Flesh::Pod => FleshTexture::Pod,
    }
}

/// Palette of browning.
pub(crate) fn browning_palette(model: &FoodModel) -> BrowningPalette {
    let colours = model.palette().colours();
    let single = |lab: [f64; 3]| lab.map(|v| v as f32);
    BrowningPalette {
        golden: single(colours.golden),
        golden_at: colours.golden_at as f32,
        crust: single(colours.crust),
        char: single(colours.char),
        fat_brown: single(colours.fat_brown),
        second: single(model.palette().second_tissue()),
    }
}

/// Fat, second tissue and borders in the flesh: of marbled flesh the very cells that its nodes' fat is averaged from.
pub(crate) fn grain_volume(model: &FoodModel) -> GrainVolume {
    let marbling = model.marbling();
    let ([mut low, mut extent], mut size) = ([marbling.low, marbling.extent], marbling.size);
    let grown = model.description().form.grown_along();
    if !marbling.holds_fat() && !model.tissue_field().is_plain() {
        size = [if model.pool().is_some() { POURED_CELLS[0] } else { TISSUE_CELLS }; 3];
        size[grown] = if model.pool().is_some() { POURED_CELLS[1] } else { 1 };
        // What grew along its length is in the middle of its frame.
        if grown == 0 {
            (low, extent) = (model.size().map(|v| -0.5 * v), model.size());
        }
    }
    // The mesh of a slice has its bottom at 0, the rest frame its middle.
    let lifted = model.rest_position(0)[2] - model.mesh().position(0)[2];
    let origin = Vec3::new(low[0] as f32, low[1] as f32, (low[2] + lifted) as f32);
    let mut cells = Vec::with_capacity(size.iter().product::<u32>() as usize);
    for index in 0..size.iter().product::<u32>() {
        let at = [index % size[0], index / size[0] % size[1], index / size[0] / size[1]];
        let p = std::array::from_fn(|k| low[k] + (f64::from(at[k]) + 0.5) / f64::from(size[k]) * extent[k]);
        cells.push(cell(model, p));
    }
    GrainVolume { size, origin, extent: Vec3::from_array(extent.map(|v| v as f32)), cells }
}

/// The four bytes of one point.
fn cell(model: &FoodModel, p: [f64; 3]) -> [u8; 4] {
    let byte = |share: f64| (255.0 * share.clamp(0.0, 1.0)).round() as u8;
    let within = model.marbling().within(p) / f64::from(WITHIN_RANGE);
    let sheath = model.tissue_field().sheath(p) as u64;
    [
        byte(0.5 + 0.5 * within),
        byte(yolk_seen(model, p).unwrap_or_else(|| model.tissue_field().at(p))),
        byte(model.tissue_field().border(p) / f64::from(BORDER_RANGE)),
        byte(uniform(0x51ea7, sheath)),
    ]
}
