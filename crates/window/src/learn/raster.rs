//! Fills in the triangles of an interface on the processor, so that a picture needs no graphics.

use std::collections::HashMap;

use egui::epaint::{ClippedPrimitive, Mesh, Primitive, Vertex};
use egui::{Color32, ColorImage, ImageData, Pos2, Rect, TextureId, TexturesDelta};
use saute_picture::cut::section::Picture;

/// A picture in the making, with the textures of its interface.
#[derive(Default)]
pub struct Canvas {
    textures: HashMap<TextureId, ColorImage>,
    width: usize,
    height: usize,
    /// Colours in sRGB, premultiplied, 0–1.
    pixels: Vec<[f32; 4]>,
}

impl Canvas {
    /// Takes over textures that an interface made or changed.
    pub fn take_textures(&mut self, mut delta: TexturesDelta) {
        for (id, images) in delta.set.drain() {
            for image in images {
                let ImageData::Color(new) = &image.image;
                match (image.pos, self.textures.get_mut(&id)) {
                    (Some(at), Some(old)) => patch(old, new, at),
                    _ => drop(self.textures.insert(id, ColorImage::clone(new))),
                }
            }
        }
    }

    /// Paints an interface on a ground.
    pub fn paint(&mut self, size: [usize; 2], ground: Color32, primitives: &[ClippedPrimitive], pixels_per_point: f32) {
        [self.width, self.height] = size;
        self.pixels = vec![unit(ground); self.width * self.height];
        for clipped in primitives {
            let Primitive::Mesh(mesh) = &clipped.primitive else { continue };
            let clip = clipped.clip_rect * pixels_per_point;
            for corners in mesh.indices.chunks_exact(3) {
                self.triangle(mesh, [corners[0], corners[1], corners[2]], clip, pixels_per_point);
            }
        }
    }

    /// What was painted.
    pub fn picture(&self) -> Picture {
        let byte = |v: f32| (255.0 * v.clamp(0.0, 1.0)).round() as u8;
        let rgba = self.pixels.iter().flat_map(|p| [byte(p[0]), byte(p[1]), byte(p[2]), 255]).collect();
        Picture { width: self.width, height: self.height, rgba }
    }

    fn triangle(&mut self, mesh: &Mesh, corners: [u32; 3], clip: Rect, scale: f32) {
        let v: [&Vertex; 3] = corners.map(|i| &mesh.vertices[i as usize]);
        let p = v.map(|v| v.pos * scale);
        let cross = |a: Pos2, b: Pos2, c: Pos2| (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let whole = cross(p[0], p[1], p[2]);
        let Some(image) = self.textures.get(&mesh.texture_id).filter(|_| whole != 0.0) else { return };
        let bounds = Rect::from_points(&p).intersect(clip);
        let colours = v.map(|v| unit(v.color));
        let most = |v: f32, end: usize| (v.ceil().max(0.0) as usize).min(end);
        for y in (bounds.top().max(0.0) as usize)..most(bounds.bottom(), self.height) {
            for x in (bounds.left().max(0.0) as usize)..most(bounds.right(), self.width) {
                let at = Pos2::new(x as f32 + 0.5, y as f32 + 0.5);
                let w = [cross(at, p[1], p[2]), cross(p[0], at, p[2]), cross(p[0], p[1], at)].map(|w| w / whole);
                // An edge that two triangles share belongs to one of them.
                if w[0] < 0.0 || w[1] <= 0.0 || w[2] < 0.0 || !clip.contains(at) {
                    continue;
                }
                let mix = |values: [f32; 3]| w[0] * values[0] + w[1] * values[1] + w[2] * values[2];
                let seen = sampled(image, mix(v.map(|v| v.uv.x)), mix(v.map(|v| v.uv.y)));
                let pixel = &mut self.pixels[y * self.width + x];
                let source: [f32; 4] = std::array::from_fn(|k| seen[k] * mix(colours.map(|c| c[k])));
                *pixel = std::array::from_fn(|k| source[k] + pixel[k] * (1.0 - source[3]));
            }
        }
    }
}

/// A colour as shares of its channels, premultiplied.
fn unit(colour: Color32) -> [f32; 4] {
    colour.to_array().map(|v| f32::from(v) / 255.0)
}

/// Colour of a texture at a place, between its four nearest pixels.
fn sampled(image: &ColorImage, u: f32, v: f32) -> [f32; 4] {
    let [width, height] = image.size;
    let (x, y) = (u * width as f32 - 0.5, v * height as f32 - 0.5);
    let at = |x: f32, y: f32| {
        let inside = |v: f32, end: usize| (v.max(0.0) as usize).min(end - 1);
        unit(image.pixels[inside(y, height) * width + inside(x, width)])
    };
    let (left, top) = (x.floor(), y.floor());
    let (right, low) = (x - left, y - top);
    let (a, b, c, d) = (at(left, top), at(left + 1.0, top), at(left, top + 1.0), at(left + 1.0, top + 1.0));
    std::array::from_fn(|k| {
        (a[k] * (1.0 - right) + b[k] * right) * (1.0 - low) + (c[k] * (1.0 - right) + d[k] * right) * low
    })
}

/// Puts a smaller image into a larger one.
fn patch(old: &mut ColorImage, new: &ColorImage, [left, top]: [usize; 2]) {
    for row in 0..new.height() {
        for column in 0..new.width() {
            old[(left + column, top + row)] = new[(column, row)];
        }
    }
}

#[cfg(test)]
mod tests {
    use egui::epaint::WHITE_UV;

    use super::*;

    fn square(from: f32, to: f32, colour: Color32) -> ClippedPrimitive {
        let vertex = |x: f32, y: f32| Vertex { pos: Pos2::new(x, y), uv: WHITE_UV, color: colour };
        let vertices = vec![vertex(from, from), vertex(to, from), vertex(to, to), vertex(from, to)];
        let mesh = Mesh { indices: vec![0, 1, 2, 0, 2, 3], vertices, texture_id: TextureId::default() };
        ClippedPrimitive { clip_rect: Rect::EVERYTHING, primitive: Primitive::Mesh(mesh) }
    }

    #[test]
    fn a_square_covers_its_pixels_once() {
        let mut canvas = Canvas::default();
        canvas.textures.insert(TextureId::default(), ColorImage::filled([1, 1], Color32::WHITE));
        let half = Color32::from_rgba_premultiplied(128, 0, 0, 128);
        canvas.paint([8, 8], Color32::BLACK, &[square(2.0, 6.0, half)], 1.0);
        let picture = canvas.picture();
        let red = |x: usize, y: usize| picture.rgba[4 * (y * 8 + x)];
        for (x, y) in [(2, 2), (3, 3), (4, 3), (5, 5)] {
            assert_eq!(red(x, y), 128, "{x} {y}: what lets through is laid on once");
        }
        assert_eq!([red(1, 3), red(6, 3), red(3, 6)], [0; 3]);
    }
}
