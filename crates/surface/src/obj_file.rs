//! Wavefront OBJ files.

use crate::read_error::DAMAGED;
use crate::text_lines::{Line, Word, lines, unmarked};
use crate::{ReadError, Soup, enough_room};

/// Words before a vertex, a texture coordinate and a normal, in the order in which a corner names them.
const KINDS: [&[u8]; 3] = [b"v", b"vt", b"vn"];
/// The kinds for messages.
const NAMES: [&str; 3] = ["vertex", "texture coordinate", "normal"];
/// Words before lists of corners: faces, lines and points. Lines and points are not read, only checked.
const LISTS: [&[u8]; 3] = [b"f", b"l", b"p"];

/// Returns the triangles of all objects of a file; faces with more than three corners are triangulated.
///
/// # Errors
/// [`ReadError`] with the line, if the file is not valid.
pub fn read(bytes: &[u8]) -> Result<Soup, ReadError> {
    let mut lines = lines(unmarked(bytes)?);
    let (mut file, mut words) = (File::default(), Vec::new());
    while let Some(line) = lines.next() {
        statement(line, &mut lines, &mut words);
        file.take(&words)?;
    }
    file.soup()
}

/// Collects the words of a statement, which goes on in the next line after a backslash.
///
/// Only one with numbers does: in Shift-JIS, the second byte of some letters of a name is a backslash.
fn statement<'a>(mut line: Line<'a>, more: &mut impl Iterator<Item = Line<'a>>, words: &mut Vec<Word<'a>>) {
    words.clear();
    loop {
        let comment = line.text.iter().position(|byte| *byte == b'#').unwrap_or(line.text.len());
        line.text = line.text[..comment].trim_ascii_end();
        let continued = line.text.strip_suffix(b"\\");
        let is_first = words.is_empty();
        words.extend(Line { text: continued.unwrap_or(line.text), ..line }.words());
        let has_numbers = words.first().is_some_and(|word| KINDS.contains(&word.text) || LISTS.contains(&word.text));
        match (continued, has_numbers || !is_first) {
            (Some(_), true) => match more.next() {
                Some(next) => line = next,
                None => return,
            },
            _ => return,
        }
    }
}

/// What was read so far.
#[derive(Default)]
struct File {
    positions: Vec<[f64; 3]>,
    /// Vertices, texture coordinates and normals.
    counts: [usize; 3],
    /// Triangles as indices of positions, with the object of each.
    triangles: Vec<([u32; 3], u32)>,
    /// Objects and groups.
    objects: u32,
    /// The largest index of each kind, and the line that names it.
    highest: [(i64, usize); 3],
}

impl File {
    /// Takes a statement; materials, names, curves and smoothing do not affect the shape.
    fn take(&mut self, words: &[Word]) -> Result<(), ReadError> {
        let Some((first, rest)) = words.split_first() else { return Ok(()) };
        match first.text {
            b"v" => self.vertex(first, rest)?,
            b"vt" => self.counts[1] += 1,
            b"vn" => self.counts[2] += 1,
            b"f" => self.face(rest)?,
            b"l" | b"p" => rest.iter().try_for_each(|corner| self.corner(corner).map(drop))?,
            b"o" | b"g" => self.objects += 1,
            _ => {}
        }
        Ok(())
    }

    /// Adds a vertex: three coordinates, then nothing, a weight that divides them, or a colour.
    fn vertex(&mut self, first: &Word, rest: &[Word]) -> Result<(), ReadError> {
        let [x, y, z, more @ ..] = rest else {
            let message = format!("a vertex has {} of its 3 coordinates", rest.len());
            return Err(first.error(message, "write all three after \"v\", or export it again"));
        };
        let mut position = [x.number::<f64>()?, y.number::<f64>()?, z.number::<f64>()?];
        if let [weight] = more {
            let divisor = weight.number::<f64>()?;
            position = position.map(|v| v / divisor);
            if !position.iter().all(|v| v.is_finite()) {
                let message = format!("{} is no weight of a vertex", weight.shown());
                return Err(weight.error(message, "write 1, or leave it out"));
            }
        }
        enough_room(self.triangles.len(), self.positions.len() + 1)?;
        self.positions.push(position);
        self.counts[0] += 1;
        Ok(())
    }

    /// Adds the triangles of a face, a fan around its first corner; one with two corners is a line.
    fn face(&mut self, corners: &[Word]) -> Result<(), ReadError> {
        enough_room(self.triangles.len() + corners.len().saturating_sub(2), self.positions.len())?;
        let corners = corners.iter().map(|corner| self.corner(corner)).collect::<Result<Vec<u32>, _>>()?;
        let fan = corners.windows(2).skip(1).map(|pair| ([corners[0], pair[0], pair[1]], self.objects));
        self.triangles.extend(fan);
        Ok(())
    }

    /// Returns the index of a corner's position from 0. A corner is written as `5`, `5/1`, `5//-2` or `5/1/-2`.
    fn corner(&mut self, corner: &Word) -> Result<u32, ReadError> {
        let mut position = None;
        for (kind, text) in corner.text.split(|byte| *byte == b'/').take(KINDS.len()).enumerate() {
            if text.is_empty() && kind > 0 {
                continue;
            }
            let Some(index) = std::str::from_utf8(text).ok().and_then(|text| text.parse::<i64>().ok()) else {
                let message = format!("{} is no corner of a face", corner.shown());
                return Err(corner.error(message, "write the number of a vertex, as 5 or 5/1/2, or export it again"));
            };
            let index = self.refer(index, kind, corner.line)?;
            position = position.or(u32::try_from(index - 1).ok());
        }
        position.ok_or_else(|| absent(0, 0, self.counts[0], corner.line))
    }

    /// Returns an index that counts from 1; a negative one counts back from what was read so far.
    fn refer(&mut self, index: i64, kind: usize, line: usize) -> Result<i64, ReadError> {
        let count = self.counts[kind] as i64;
        let from_first = if index < 0 { index.saturating_add(count + 1) } else { index };
        if from_first < 1 || from_first > i64::from(u32::MAX) {
            return Err(absent(index, kind, self.counts[kind], line));
        }
        self.highest[kind] = self.highest[kind].max((from_first, line));
        Ok(from_first)
    }

    /// Returns the triangles, with the positions of each object in the order of their use.
    fn soup(self) -> Result<Soup, ReadError> {
        for (kind, (index, line)) in self.highest.into_iter().enumerate() {
            if index > self.counts[kind] as i64 {
                return Err(absent(index, kind, self.counts[kind], line));
            }
        }
        let mut soup = Soup::default();
        let mut places = vec![(u32::MAX, 0); self.positions.len()];
        for (corners, object) in self.triangles {
            let triangle = corners.map(|corner| {
                let place = &mut places[corner as usize];
                if place.0 != object {
                    *place = (object, soup.vertices.len() as u32);
                    soup.vertices.push(self.positions[corner as usize]);
                }
                place.1
            });
            soup.triangles.push(triangle);
        }
        Ok(soup)
    }
}

fn absent(index: i64, kind: usize, count: usize, line: usize) -> ReadError {
    ReadError::at_line(line, format!("refers to {} {index}, but contains {count}", NAMES[kind]), DAMAGED)
}
