//! Reads VTU files as their format is written down, apart from the code that writes them.

use std::io::Read;

use flate2::read::ZlibDecoder;

/// A file with its XML and the bytes that follow.
pub struct Vtu {
    xml: String,
    appended: Vec<u8>,
}

impl Vtu {
    pub fn read(file: &[u8]) -> Self {
        let mark = b"<AppendedData encoding=\"raw\">\n_";
        let at = file.windows(mark.len()).position(|w| w == mark).unwrap();
        let xml = String::from_utf8(file[..at].to_vec()).unwrap();
        assert!(file.ends_with(b"\n</AppendedData>\n</VTKFile>\n"));
        Self { xml, appended: file[at + mark.len()..].to_vec() }
    }

    /// The attributes of an array, up to the end of its tag.
    fn tag(&self, name: &str) -> &str {
        let at = self.xml.find(&format!("Name=\"{name}\"")).unwrap_or_else(|| panic!("no {name}"));
        let from = self.xml[..at].rfind('<').unwrap();
        &self.xml[from..from + self.xml[from..].find('\n').unwrap()]
    }

    fn attribute<'a>(tag: &'a str, name: &str) -> &'a str {
        let from = tag.find(&format!("{name}=\"")).unwrap() + name.len() + 2;
        &tag[from..from + tag[from..].find('"').unwrap()]
    }

    /// The part of the file that contains an array: `PointData`, `CellData`, `Points` or `Cells`.
    pub fn section(&self, name: &str) -> &str {
        let at = self.xml.find(&format!("Name=\"{name}\"")).unwrap();
        let from = ["<PointData>", "<CellData>", "<Points>", "<Cells>"].map(|s| self.xml[..at].rfind(s).unwrap_or(0));
        let start = *from.iter().max().unwrap();
        self.xml[start + 1..].split('>').next().unwrap()
    }

    pub fn unit(&self, name: &str) -> &str {
        self.tag(name).split("location=\"vtkDataArray\">").nth(1).map_or("", |rest| rest.split('<').next().unwrap())
    }

    pub fn counts(&self) -> [usize; 2] {
        let from = self.xml.find("<Piece ").unwrap();
        let tag = &self.xml[from..from + self.xml[from..].find('>').unwrap()];
        ["NumberOfPoints", "NumberOfCells"].map(|name| Self::attribute(tag, name).parse().unwrap())
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        let offset: usize = Self::attribute(self.tag(name), "offset").parse().unwrap();
        let number = |k: usize| {
            let from = offset + 8 * k;
            u64::from_le_bytes(self.appended[from..from + 8].try_into().unwrap()) as usize
        };
        let (blocks, length, rest) = (number(0), number(1), number(2));
        let mut from = offset + 8 * (3 + blocks);
        let mut all = Vec::new();
        for block in 0..blocks {
            let until = from + number(3 + block);
            let before = all.len();
            ZlibDecoder::new(&self.appended[from..until]).read_to_end(&mut all).unwrap();
            let expected = if block + 1 == blocks && rest > 0 { rest } else { length };
            assert_eq!(all.len() - before, expected);
            from = until;
        }
        all
    }

    pub fn reals(&self, name: &str) -> Vec<f64> {
        assert_eq!(Self::attribute(self.tag(name), "type"), "Float64");
        let (numbers, rest) = (self.bytes(name), 0);
        assert_eq!(numbers.len() % 8, rest);
        numbers.chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
    }

    pub fn integers(&self, name: &str) -> Vec<i32> {
        assert_eq!(Self::attribute(self.tag(name), "type"), "Int32");
        self.bytes(name).chunks(4).map(|b| i32::from_le_bytes(b.try_into().unwrap())).collect()
    }

    pub fn flags(&self, name: &str) -> Vec<u8> {
        assert_eq!(Self::attribute(self.tag(name), "type"), "UInt8");
        self.bytes(name)
    }

    pub fn points(&self) -> Vec<[f64; 3]> {
        self.reals("points_m").chunks(3).map(|p| p.try_into().unwrap()).collect()
    }
}
