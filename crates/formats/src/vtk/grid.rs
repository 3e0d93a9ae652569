//! An unstructured grid: points, cells, and arrays with units on both.

/// Kind of a cell, with its number in VTK.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum CellKind {
    /// Two points.
    Line = 3,
    /// Three points.
    Triangle = 5,
    /// Four points.
    Quad = 9,
    /// Eight points: four below, four above.
    Hexahedron = 12,
    /// Six points: a triangle, and the one across from it.
    Wedge = 13,
    /// A polyhedron, given by its faces.
    Polyhedron = 42,
}

/// Cells of a grid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cells {
    /// Kinds.
    pub kinds: Vec<u8>,
    /// Points of all cells.
    pub corners: Vec<i32>,
    /// Where the points of each cell end in `corners`.
    pub ends: Vec<i32>,
    /// Faces of all polyhedra: for each their number, and for each face the number of its points and these.
    pub faces: Vec<i32>,
    /// Where the faces of each cell end in `faces`; empty without polyhedra.
    pub face_ends: Vec<i32>,
}

impl Cells {
    /// Adds a cell of a kind that its points define.
    pub fn push(&mut self, kind: CellKind, corners: impl IntoIterator<Item = usize>) {
        self.kinds.push(kind as u8);
        self.corners.extend(corners.into_iter().map(|c| c as i32));
        self.ends.push(self.corners.len() as i32);
    }

    /// Adds a polyhedron; a grid with polyhedra has no other cells.
    pub fn push_polyhedron(&mut self, faces: &[Vec<u32>]) {
        let mut corners: Vec<usize> = faces.iter().flatten().map(|c| *c as usize).collect();
        corners.sort_unstable();
        corners.dedup();
        self.push(CellKind::Polyhedron, corners);
        self.faces.push(faces.len() as i32);
        for face in faces {
            self.faces.push(face.len() as i32);
            self.faces.extend(face.iter().map(|c| *c as i32));
        }
        self.face_ends.push(self.faces.len() as i32);
    }

    /// Returns the number of cells.
    pub fn count(&self) -> usize {
        self.kinds.len()
    }
}

/// Numbers of an array.
#[derive(Clone, Debug, PartialEq)]
pub enum Numbers {
    /// Real numbers in double precision.
    Reals(Vec<f64>),
    /// Bytes, as of a colour or a flag.
    Bytes(Vec<u8>),
    /// Whole numbers.
    Integers(Vec<i32>),
}

impl Numbers {
    /// Returns the name of the type in VTK.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Reals(_) => "Float64",
            Self::Bytes(_) => "UInt8",
            Self::Integers(_) => "Int32",
        }
    }

    /// Returns the numbers as bytes, the least significant first.
    pub fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Reals(numbers) => numbers.iter().flat_map(|v| v.to_le_bytes()).collect(),
            Self::Bytes(bytes) => bytes.clone(),
            Self::Integers(numbers) => numbers.iter().flat_map(|v| v.to_le_bytes()).collect(),
        }
    }
}

/// An array of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Name, which ends with the unit if there is one.
    pub name: String,
    /// Unit, as `°C`; empty where there is none.
    pub unit: &'static str,
    /// Numbers for each point or cell [-].
    pub components: usize,
    /// The numbers.
    pub numbers: Numbers,
}

impl Array {
    /// Returns an array of one real number for each point or cell.
    pub fn reals(name: impl Into<String>, unit: &'static str, numbers: Vec<f64>) -> Self {
        Self { name: name.into(), unit, components: 1, numbers: Numbers::Reals(numbers) }
    }

    /// Returns an array of a vector for each point or cell.
    pub fn vectors(name: impl Into<String>, unit: &'static str, vectors: &[[f64; 3]]) -> Self {
        Self { name: name.into(), unit, components: 3, numbers: Numbers::Reals(vectors.concat()) }
    }

    /// Returns an array of an 8-bit colour (sRGB) for each point or cell.
    pub fn colours(name: impl Into<String>, colours: &[[u8; 3]]) -> Self {
        Self { name: name.into(), unit: "", components: 3, numbers: Numbers::Bytes(colours.concat()) }
    }

    /// Returns an array of a flag for each point or cell, 0 or 1.
    pub fn flags(name: impl Into<String>, flags: impl Iterator<Item = bool>) -> Self {
        Self { name: name.into(), unit: "", components: 1, numbers: Numbers::Bytes(flags.map(u8::from).collect()) }
    }
}

/// An unstructured grid at one instant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grid {
    /// Points [m].
    pub points: Vec<[f64; 3]>,
    /// Cells.
    pub cells: Cells,
    /// Arrays on the points.
    pub of_points: Vec<Array>,
    /// Arrays on the cells.
    pub of_cells: Vec<Array>,
    /// Time [s].
    pub time_s: f64,
    /// Notes about all of it, as the kind of food: name and text.
    pub notes: Vec<(&'static str, String)>,
}
