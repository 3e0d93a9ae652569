//! Grids as VTU files: XML whose arrays follow as one block of bytes, each compressed by zlib.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use crate::vtk::grid::{Array, Grid, Numbers};

/// Length of the blocks that are compressed one by one [bytes] (chosen: a reader keeps one in memory at a time).
const BLOCK: usize = 1 << 18;
/// Effort of compression, 0 to 9 [-] (chosen: more takes longer and saves little on measured fields).
const EFFORT: u32 = 1;

impl Grid {
    /// Returns the grid as a VTU file. The same grid gives the same bytes.
    pub fn vtu(&self) -> Vec<u8> {
        let mut file = File::default();
        file.line("<?xml version=\"1.0\"?>");
        file.line(concat!(
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" ",
            "compressor=\"vtkZLibDataCompressor\">"
        ));
        file.notes(self);
        file.line("<UnstructuredGrid>");
        file.time(self);
        let (points, cells) = (self.points.len(), self.cells.count());
        file.line(&format!("<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"));
        file.section("PointData", &self.of_points);
        file.section("CellData", &self.of_cells);
        file.section("Points", &[Array::vectors("points_m", "m", &self.points)]);
        file.section("Cells", &self.cell_arrays());
        file.line("</Piece>\n</UnstructuredGrid>");
        file.finish()
    }

    fn cell_arrays(&self) -> Vec<Array> {
        let cells = &self.cells;
        let array = |name: &str, numbers: Numbers| Array { name: name.to_owned(), unit: "", components: 1, numbers };
        let integers = |name: &str, numbers: &[i32]| array(name, Numbers::Integers(numbers.to_vec()));
        let mut arrays = vec![
            integers("connectivity", &cells.corners),
            integers("offsets", &cells.ends),
            array("types", Numbers::Bytes(cells.kinds.clone())),
        ];
        if !cells.face_ends.is_empty() {
            arrays.extend([integers("faces", &cells.faces), integers("faceoffsets", &cells.face_ends)]);
        }
        arrays
    }
}

/// A file that is being written: its XML, and the bytes that follow it.
#[derive(Default)]
struct File {
    xml: String,
    appended: Vec<u8>,
}

impl File {
    fn line(&mut self, line: &str) {
        self.xml.push_str(line);
        self.xml.push('\n');
    }

    /// The notes as a comment: some readers refuse a file with texts among its arrays.
    fn notes(&mut self, grid: &Grid) {
        let notes: Vec<String> = grid.notes.iter().map(|(name, text)| format!("{name}: {text}")).collect();
        if !notes.is_empty() {
            self.line(&format!("<!-- {} -->", commented(&notes.join("; "))));
        }
    }

    /// The time, under the name by which readers find it.
    fn time(&mut self, grid: &Grid) {
        self.line("<FieldData>");
        self.array(&Array::reals("TimeValue", "s", vec![grid.time_s]), true);
        self.line("</FieldData>");
    }

    fn section(&mut self, name: &str, arrays: &[Array]) {
        self.line(&format!("<{name}>"));
        arrays.iter().for_each(|array| self.array(array, false));
        self.line(&format!("</{name}>"));
    }

    /// Adds an array; one of the whole grid states its length.
    fn array(&mut self, array: &Array, is_of_grid: bool) {
        let Array { name, unit, components, numbers } = array;
        let count = if is_of_grid { " NumberOfTuples=\"1\"" } else { "" };
        // One is the default, and for some readers a stated one is a column instead of a list.
        let columns = if *components == 1 { String::new() } else { format!(" NumberOfComponents=\"{components}\"") };
        let start = format!(
            "<DataArray type=\"{}\" Name=\"{}\"{columns}{count} format=\"appended\" offset=\"{}\"",
            numbers.kind(),
            escaped(name),
            self.appended.len()
        );
        let unit = match *unit {
            "" => "/>".to_owned(),
            unit => format!(
                "><InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{unit}</InformationKey></DataArray>"
            ),
        };
        self.line(&(start + &unit));
        self.appended.extend(compressed(&numbers.bytes()));
    }

    fn finish(self) -> Vec<u8> {
        let mut file = self.xml.into_bytes();
        file.extend(b"<AppendedData encoding=\"raw\">\n_");
        file.extend(self.appended);
        file.extend(b"\n</AppendedData>\n</VTKFile>\n");
        file
    }
}

/// Returns bytes in compressed blocks, after the number of blocks, their length, that of a shorter last one, and the
/// compressed length of each.
fn compressed(bytes: &[u8]) -> Vec<u8> {
    let blocks: Vec<Vec<u8>> = bytes.chunks(BLOCK).map(squeezed).collect();
    let rest = bytes.len() % BLOCK;
    let header = [blocks.len(), BLOCK, rest].into_iter().chain(blocks.iter().map(Vec::len));
    let mut all: Vec<u8> = header.flat_map(|number| (number as u64).to_le_bytes()).collect();
    all.extend(blocks.concat());
    all
}

fn squeezed(block: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(EFFORT));
    // Writing to memory does not fail.
    let _ = encoder.write_all(block);
    encoder.finish().unwrap_or_default()
}

/// Returns a text as it may be in an XML comment: without two hyphens in a row and without control characters.
fn commented(text: &str) -> String {
    let mut plain = text.replace(char::is_control, " ");
    // A run of three leaves two in a row at first.
    while plain.contains("--") {
        plain = plain.replace("--", "- -");
    }
    plain
}

/// Returns a text as the value of an XML attribute.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
