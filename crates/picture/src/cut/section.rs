//! A picture of a cut through a piece, painted pixel by pixel from the fields.

use saute_kitchen::Piece;
use saute_kitchen::food::change::colour::Appearance;
use saute_kitchen::food::readings::changed_at;
use saute_kitchen::food::tissue::noise::fractal;
use saute_kitchen::food::{FoodModel, FoodState, Lab};
use saute_kitchen::heat::mesh::cells::CellSlice;
use saute_kitchen::heat::{BodyMesh, Cut, SweptMesh};

use crate::colour::map::ColourMap;
use crate::skin::cells::{CellLook, longest_axis};
use crate::view::View;

/// An RGBA picture, 8 bits a channel, sRGB, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Bytes, four a pixel.
    pub rgba: Vec<u8>,
}

/// What is sampled at each crossing of the cut and each level.
#[derive(Clone, Copy, Default)]
struct Sample {
    value: f64,
    appearance: Appearance,
}

/// Paints the cut at distance `x` [m] from the centroid along the longest axis, as the piece lies, at `per_mm` pixels
/// a millimetre, with the view's colours where it has any; transparent outside the piece.
pub fn section_picture(piece: &Piece, x: f64, view: View, colours: Option<&ColourMap>, per_mm: f64) -> Picture {
    let (model, state) = (&*piece.model, &piece.state);
    let mesh = match model.mesh() {
        BodyMesh::Swept(mesh) => mesh,
        BodyMesh::Cells(cells) => {
            let look = CellLook { cells, model, state, view, map: colours };
            return cell_picture(&look, x, piece.upside_down(), per_mm);
        }
    };
    let cut = model.cut_across(x);
    let thickness = mesh.thickness();
    let (Some(first), Some(last)) = (cut.points.first(), cut.points.last()) else {
        return Picture { width: 1, height: 1, rgba: vec![0; 4] };
    };
    let samples = sample(model, mesh, state, &cut, view, colours.and_then(ColourMap::change));
    let painter = Painter { model, mesh, cut: &cut, samples, x, colours, flipped: piece.upside_down() };
    if !mesh.is_upright() {
        return painter.lengthwise(per_mm);
    }
    // The picture shows the present size; within it the shape is stretched evenly.
    let width = (((last.along - first.along) * state.stretch.lateral * 1e3 * per_mm).round() as usize).max(1);
    let height = ((model.thickness(state) * 1e3 * per_mm).round() as usize).max(1);
    let mut rgba = Vec::with_capacity(4 * width * height);
    for row in 0..height {
        let up = 1.0 - (row as f64 + 0.5) / height as f64;
        for column in 0..width {
            let across = (column as f64 + 0.5) / width as f64;
            let along = first.along + across * (last.along - first.along);
            let [r, g, b] = painter.pixel(along, up * thickness, [column, row]);
            rgba.extend([r, g, b, 255]);
        }
    }
    Picture { width, height, rgba }
}

fn sample(
    model: &FoodModel,
    mesh: &SweptMesh,
    state: &FoodState,
    cut: &Cut,
    view: View,
    change: Option<&str>,
) -> Vec<Sample> {
    let n = mesh.nodes_per_level();
    let mut samples = Vec::with_capacity(cut.points.len() * mesh.levels.len());
    for level in 0..mesh.levels.len() {
        for p in &cut.points {
            let [a, b] = p.nodes.map(|i| level * n + i as usize);
            let mix = |f: &[f64]| f[a] * (1.0 - p.share) + f[b] * p.share;
            let value = |node| view.value(model, state, node, change);
            samples.push(Sample {
                value: value(a) * (1.0 - p.share) + value(b) * p.share,
                appearance: Appearance {
                    changed: changed_at(state, mix),
                    browning: mix(&state.browning),
                    charring: mix(&state.charring),
                    tissue: mix(model.second_tissue()),
                },
            });
        }
    }
    samples
}

/// A cut through a body of cells: its triangles are painted with what their corners read, weighted.
fn cell_picture(look: &CellLook, x: f64, flipped: bool, per_mm: f64) -> Picture {
    let axis = longest_axis(look.model);
    let Ok(cut) = look.cells.slice(axis, x) else { return Picture { width: 1, height: 1, rgba: vec![0; 4] } };
    let points: Vec<(Lab, f64)> = (0..cut.points.len()).map(|i| cell_point(look, &cut, i)).collect();
    // Turning over about the long axis mirrors the cut and turns it upside down.
    let sign = if flipped { -1.0 } else { 1.0 };
    let pixels = 1e3 * per_mm * look.state.stretch.lateral;
    let across = |p: &[f64; 3]| sign * if axis == 0 { p[1] } else { -p[0] } * pixels;
    let flat: Vec<[f64; 2]> = cut.points.iter().map(|p| [across(p), -sign * p[2] * pixels]).collect();
    let low = [0, 1].map(|k| flat.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min));
    let high = [0, 1].map(|k| flat.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max));
    let [width, height] = [0, 1].map(|k| ((high[k] - low[k]).round() as usize).max(1));
    let mut picture = Picture { width, height, rgba: vec![0; 4 * width * height] };
    for t in &cut.triangles {
        let corners = t.map(|i| [0, 1].map(|k| flat[i as usize][k] - low[k]));
        let corner = t.map(|i| points[i as usize]);
        picture.paint(corners, |weights, place| match look.map {
            Some(map) => hatched(map, (0..3).map(|i| weights[i] * corner[i].1).sum(), place),
            None => Lab([0, 1, 2].map(|k| (0..3).map(|i| weights[i] * corner[i].0.0[k]).sum())).srgb8(),
        });
    }
    picture
}

/// Colour of the flesh at a point of a cut, and the value of the view's field.
fn cell_point(look: &CellLook, cut: &CellSlice, point: usize) -> (Lab, f64) {
    let (appearance, value) = look.appearance(&|f| cut.read(point, f));
    let (lean, fat) = look.model.colours(appearance);
    (lean.lerp(fat, look.model.marbling().at(cut.points[point])), value)
}

/// A map's colour at a pixel, with the pattern of its class.
fn hatched(map: &ColourMap, value: f64, [column, row]: [usize; 2]) -> [u8; 3] {
    map.hatched(value, column as f64 + 0.5, row as f64 + 0.5)
}

impl Picture {
    /// Paints a triangle: the colour of a pixel from the weights of the corners and its place.
    fn paint(&mut self, [a, b, c]: [[f64; 2]; 3], colour: impl Fn([f64; 3], [usize; 2]) -> [u8; 3]) {
        let cross =
            |o: [f64; 2], p: [f64; 2], q: [f64; 2]| (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
        let whole = cross(a, b, c);
        let range = |k: usize, most: usize| {
            let (low, high) = (a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]));
            (low.max(0.0) as usize)..(high.ceil().max(0.0) as usize).min(most)
        };
        for row in range(1, self.height) {
            for column in range(0, self.width) {
                let p = [column as f64 + 0.5, row as f64 + 0.5];
                let weights = [cross(p, b, c), cross(a, p, c), cross(a, b, p)].map(|w| w / whole);
                if weights.iter().all(|w| *w >= -1e-9) {
                    let at = 4 * (row * self.width + column);
                    let [r, g, b] = colour(weights, [column, row]);
                    self.rgba[at..at + 4].copy_from_slice(&[r, g, b, 255]);
                }
            }
        }
    }
}

struct Painter<'a> {
    model: &'a FoodModel,
    mesh: &'a SweptMesh,
    cut: &'a Cut,
    samples: Vec<Sample>,
    x: f64,
    colours: Option<&'a ColourMap>,
    flipped: bool,
}

impl Painter<'_> {
    /// The middle plane of a body that is no slice, stretched out straight: its path runs across the picture.
    fn lengthwise(&self, per_mm: f64) -> Picture {
        let (first, last) = (self.cut.points[0].along, self.cut.points[self.cut.points.len() - 1].along);
        let breadths: Vec<f64> =
            (0..self.mesh.levels.len()).map(|level| self.model.cut_breadth(self.cut, level)).collect();
        let length = self.mesh.thickness();
        let width = ((length * 1e3 * per_mm).round() as usize).max(1);
        let height = (((last - first) * 1e3 * per_mm).round() as usize).max(1);
        let mut rgba = Vec::with_capacity(4 * width * height);
        for row in 0..height {
            let across = last - (last - first) * (row as f64 + 0.5) / height as f64;
            for column in 0..width {
                let z = length * (column as f64 + 0.5) / width as f64;
                let (level, up) = self.mesh.bracket(z);
                let along = across / (breadths[level] * (1.0 - up) + breadths[level + 1] * up);
                let inside = (first..=last).contains(&along);
                let [r, g, b] = if inside { self.pixel(along, z, [column, row]) } else { [0; 3] };
                rgba.extend([r, g, b, if inside { 255 } else { 0 }]);
            }
        }
        Picture { width, height, rgba }
    }

    fn pixel(&self, along: f64, up: f64, place: [usize; 2]) -> [u8; 3] {
        // Flipping turns a slice about its long axis, so the cut is mirrored as well.
        let flipped = self.flipped && self.mesh.is_upright();
        let z = if flipped { self.mesh.thickness() - up } else { up };
        let along = if flipped { self.mirrored(along) } else { along };
        let s = self.interpolate(along, z);
        match self.colours {
            Some(map) => hatched(map, s.value, place),
            None => self.flesh(s.appearance, along, z).srgb8(),
        }
    }

    fn mirrored(&self, along: f64) -> f64 {
        let (first, last) = (self.cut.points[0].along, self.cut.points[self.cut.points.len() - 1].along);
        first + last - along
    }

    fn interpolate(&self, along: f64, z: f64) -> Sample {
        let points = &self.cut.points;
        let (level, up) = self.mesh.bracket(z);
        let right = points.partition_point(|p| p.along < along).clamp(1, points.len() - 1);
        let run = points[right].along - points[right - 1].along;
        let across = if run > 0.0 { ((along - points[right - 1].along) / run).clamp(0.0, 1.0) } else { 0.0 };
        let n = points.len();
        let corner = |l: usize, i: usize| {
            (
                &self.samples[l * n + i],
                (if l == level { 1.0 - up } else { up }) * if i == right { across } else { 1.0 - across },
            )
        };
        let mut sum = Sample::default();
        for (s, w) in
            [corner(level, right - 1), corner(level, right), corner(level + 1, right - 1), corner(level + 1, right)]
        {
            sum.value += w * s.value;
            sum.appearance.changed.iter_mut().zip(s.appearance.changed).for_each(|(c, x)| *c += w * x);
            sum.appearance.browning += w * s.appearance.browning;
            sum.appearance.charring += w * s.appearance.charring;
            sum.appearance.tissue += w * s.appearance.tissue;
        }
        sum
    }

    /// Flesh with its seams and a fine grain of fibre bundles, which run through the thickness.
    fn flesh(&self, appearance: Appearance, along: f64, z: f64) -> Lab {
        let p = if self.model.size()[0] >= self.model.size()[1] { [self.x, along, z] } else { [-along, self.x, z] };
        // Of a slice the second tissue is known more finely than at its nodes.
        let tissue = if self.mesh.is_upright() { self.model.tissue_at(p) } else { appearance.tissue };
        let (lean, fat) = self.model.colours(Appearance { tissue, ..appearance });
        let mixed = lean.lerp(fat, self.model.marbling().at(p));
        let grain = fractal(11, [p[0] / 1.1e-3, p[1] / 1.1e-3, p[2] / 9.0e-3]);
        Lab([mixed.0[0] + 2.2 * grain, mixed.0[1] + 0.8 * grain, mixed.0[2]])
    }
}
