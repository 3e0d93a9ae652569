//! ASCII STL.

use crate::read_error::CUT_OFF;
use crate::text_lines::{Line, Word, lines};
use crate::{ReadError, Soup, enough_room};

/// Words between "facet" and "outer": "normal" and its three coordinates, which are not read.
const OF_NORMAL: usize = 4;

/// Returns the triangles of all solids of a text; its words are in any case.
pub fn read(text: &[u8]) -> Result<Soup, ReadError> {
    let mut words = Words { lines: Box::new(lines(text)), rest: Line { number: 1, text: b"" } };
    let mut soup = Soup::default();
    let mut is_open = false;
    while let Some(word) = words.next() {
        if word.text.eq_ignore_ascii_case(b"facet") {
            facet(&mut words, &mut soup)?;
            continue;
        }
        is_open = word.text.eq_ignore_ascii_case(b"solid");
        if !is_open && !word.text.eq_ignore_ascii_case(b"endsolid") {
            return Err(unexpected(&word, "\"facet\", \"endsolid\" or \"solid\""));
        }
        // The rest of the line is a name.
        words.rest.text = b"";
    }
    if is_open { Err(words.cut_off("\"endsolid\"")) } else { Ok(soup) }
}

/// Adds the triangle of a facet whose first word has been read.
fn facet(words: &mut Words, soup: &mut Soup) -> Result<(), ReadError> {
    let is_outer = |word: &Word| word.text.eq_ignore_ascii_case(b"outer");
    let mut of_normal = 0;
    loop {
        let word = words.needed("outer")?;
        of_normal += 1;
        match is_outer(&word) {
            true => break,
            false if of_normal > OF_NORMAL => return Err(unexpected(&word, "\"outer\"")),
            false => {}
        }
    }
    words.expect("loop")?;
    let first = soup.vertices.len() as u32;
    enough_room(soup.triangles.len() + 1, soup.vertices.len() + 3)?;
    for _ in 0..3 {
        words.expect("vertex")?;
        soup.vertices.push([words.coordinate()?, words.coordinate()?, words.coordinate()?]);
    }
    soup.triangles.push([first, first + 1, first + 2]);
    words.expect("endloop")?;
    words.expect("endfacet")
}

/// The words of a text, line by line.
struct Words<'a> {
    lines: Box<dyn Iterator<Item = Line<'a>> + 'a>,
    /// What is left of the line that is being read.
    rest: Line<'a>,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<Word<'a>> {
        while self.rest.text.is_empty() {
            self.rest = self.lines.next()?;
        }
        let text = self.rest.text;
        let (word, rest) = text.split_at(text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len()));
        self.rest.text = rest.trim_ascii_start();
        Some(Word { line: self.rest.number, text: word })
    }

    fn needed(&mut self, expected: &str) -> Result<Word<'a>, ReadError> {
        self.next().ok_or_else(|| self.cut_off(&format!("\"{expected}\"")))
    }

    fn expect(&mut self, expected: &str) -> Result<(), ReadError> {
        let word = self.needed(expected)?;
        let is_expected = word.text.eq_ignore_ascii_case(expected.as_bytes());
        if is_expected { Ok(()) } else { Err(unexpected(&word, &format!("\"{expected}\""))) }
    }

    /// Reads a coordinate in single precision, as in binary files.
    fn coordinate(&mut self) -> Result<f64, ReadError> {
        self.next().ok_or_else(|| self.cut_off("a coordinate"))?.number::<f32>()
    }

    fn cut_off(&self, expected: &str) -> ReadError {
        ReadError::at_line(self.rest.number, format!("the text ends before {expected}"), CUT_OFF)
    }
}

fn unexpected(word: &Word, expected: &str) -> ReadError {
    let remedy = "export it again as STL with triangles alone, or write that word there";
    word.error(format!("{} stands where {expected} is expected", word.shown()), remedy)
}
