//! The elements of accessors: positions and indices.

use crate::ReadError;
use crate::gltf_file::document::{Accessor, Dimensions, Document, View, at};
use crate::gltf_file::extensions::{self, QUANTIZATION};
use crate::read_error::DAMAGED;
use crate::text_lines::NOT_FINITE;

/// Numbers of a position [-].
const OF_POSITION: usize = 3;

/// The type of a number, by its code in the specification.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Component {
    I8 = 5120,
    U8 = 5121,
    I16 = 5122,
    U16 = 5123,
    U32 = 5125,
    F32 = 5126,
}

use Component::{F32, I8, I16, U8, U16, U32};

/// Types of indices, by the specification.
const OF_INDICES: [Component; 3] = [U8, U16, U32];
/// Types of positions with `KHR_mesh_quantization`.
const OF_QUANTIZED: [Component; 5] = [I8, U8, I16, U16, F32];

impl Component {
    /// Returns the type with a code, if it is one of those that are permitted.
    fn of(code: u32, permitted: &[Self]) -> Option<Self> {
        permitted.iter().copied().find(|component| *component as u32 == code)
    }

    fn size(self) -> usize {
        match self {
            I8 | U8 => 1,
            I16 | U16 => 2,
            U32 | F32 => 4,
        }
    }

    /// Returns the number in as many bytes as the type has.
    fn number(self, bytes: &[u8]) -> f64 {
        let mut four = [0; 4];
        four[..bytes.len()].copy_from_slice(bytes);
        let [first, second, ..] = four;
        match self {
            I8 => f64::from(i8::from_le_bytes([first])),
            U8 => f64::from(first),
            I16 => f64::from(i16::from_le_bytes([first, second])),
            U16 => f64::from(u16::from_le_bytes([first, second])),
            U32 => f64::from(u32::from_le_bytes(four)),
            F32 => f64::from(f32::from_le_bytes(four)),
        }
    }

    /// Returns the number that means 1 where integers are normalised (glTF 2.0, section 3.11), and the least number.
    fn normal(self) -> Option<(f64, f64)> {
        match self {
            I8 => Some((f64::from(i8::MAX), -1.0)),
            U8 => Some((f64::from(u8::MAX), 0.0)),
            I16 => Some((f64::from(i16::MAX), -1.0)),
            U16 => Some((f64::from(u16::MAX), 0.0)),
            U32 | F32 => None,
        }
    }
}

/// The accessors of a file with the buffers.
pub struct Elements<'a> {
    pub document: &'a Document,
    buffers: &'a [Vec<u8>],
    /// Types of positions.
    of_positions: &'static [Component],
}

/// An accessor whose type and extent have been checked.
pub struct Checked<'a> {
    index: usize,
    accessor: &'a Accessor,
    component: Component,
    /// Size of an element [B].
    size: usize,
    /// The elements of the view; there are none if all are zero but the sparse ones.
    dense: Option<Strided<'a>>,
}

impl<'a> Checked<'a> {
    /// Returns the number of elements.
    pub fn count(&self) -> usize {
        self.accessor.count
    }
}

impl<'a> Elements<'a> {
    /// Returns the accessors of a file.
    pub fn of(document: &'a Document, buffers: &'a [Vec<u8>]) -> Self {
        let is_quantized = document.extensions_used.iter().any(|name| name == QUANTIZATION);
        Self { document, buffers, of_positions: if is_quantized { &OF_QUANTIZED } else { &[F32] } }
    }

    /// Checks an accessor of positions.
    pub fn positions(&self, index: usize) -> Result<Checked<'a>, ReadError> {
        self.checked(index, Dimensions::Vec3, self.of_positions)
    }

    /// Checks an accessor of indices.
    pub fn indices(&self, index: usize) -> Result<Checked<'a>, ReadError> {
        self.checked(index, Dimensions::Scalar, &OF_INDICES)
    }

    /// Checks that an accessor has one of the types that its use permits, and is within its buffer.
    fn checked(&self, index: usize, dimensions: Dimensions, types: &[Component]) -> Result<Checked<'a>, ReadError> {
        let accessor = at(&self.document.accessors, index, "accessor")?;
        let component = Component::of(accessor.component_type, types).filter(|_| accessor.dimensions == dimensions);
        let Some(component) = component else {
            let message = format!("accessor {index} has a type that glTF does not permit there");
            return Err(ReadError::new(message, DAMAGED));
        };
        let numbers = if dimensions == Dimensions::Scalar { 1 } else { OF_POSITION };
        let size = numbers * component.size();
        let dense = match accessor.buffer_view {
            Some(view) => Some(self.strided(index, view, accessor.byte_offset, size, accessor.count)?),
            None if accessor.sparse.is_some() => None,
            None => {
                return Err(extensions::without_data(&self.document.extensions_used, &format!("accessor {index}")));
            }
        };
        Ok(Checked { index, accessor, component, size, dense })
    }

    /// Returns elements of a view, which must not overlap, and must be within it and within its buffer.
    fn strided(
        &self,
        index: usize,
        view: usize,
        offset: usize,
        size: usize,
        count: usize,
    ) -> Result<Strided<'a>, ReadError> {
        let view = at(&self.document.buffer_views, view, "buffer view")?;
        let buffer = at(self.buffers, view.buffer, "buffer")?;
        let stride = view.byte_stride.unwrap_or(size);
        let bytes = part(buffer, view).and_then(|bytes| bytes.get(offset..));
        let needed = stride.checked_mul(count.saturating_sub(1)).and_then(|last| last.checked_add(size));
        match (bytes, needed) {
            (Some(bytes), Some(needed)) if stride >= size && (count == 0 || needed <= bytes.len()) => {
                Ok(Strided { bytes, stride, size, count })
            }
            _ => {
                let message = format!("accessor {index} reaches beyond its buffer, or its elements overlap");
                Err(ReadError::new(message, DAMAGED))
            }
        }
    }

    /// Reads positions.
    pub fn read_positions(&self, checked: &Checked) -> Result<Vec<[f64; 3]>, ReadError> {
        let component = checked.component;
        let normal = component.normal().filter(|_| checked.accessor.normalized);
        let number = |bytes: &[u8]| match (component.number(bytes), normal) {
            (number, Some((one, least))) => (number / one).max(least),
            (number, None) => number,
        };
        let position = |bytes: &[u8]| {
            let size = component.size();
            [0, 1, 2].map(|k| number(&bytes[k * size..(k + 1) * size]))
        };
        let positions = self.read(checked, [0.0; 3], position)?;
        match positions.iter().position(|p| !p.iter().all(|v| v.is_finite())) {
            None => Ok(positions),
            Some(wrong) => {
                let message = format!("accessor {} has a position that is not finite, element {wrong}", checked.index);
                Err(ReadError::new(message, NOT_FINITE))
            }
        }
    }

    /// Reads indices.
    pub fn read_indices(&self, checked: &Checked) -> Result<Vec<u32>, ReadError> {
        self.read(checked, 0, |bytes| checked.component.number(bytes) as u32)
    }

    /// Reads the elements of a view, and puts the sparse ones in their place.
    fn read<T: Clone>(&self, checked: &Checked, zero: T, element: impl Fn(&[u8]) -> T) -> Result<Vec<T>, ReadError> {
        let mut elements = match &checked.dense {
            Some(dense) => dense.iter().map(&element).collect(),
            None => vec![zero; checked.count()],
        };
        let Some(sparse) = &checked.accessor.sparse else { return Ok(elements) };
        let (index, places, values) = (checked.index, &sparse.indices, &sparse.values);
        let wrong = || ReadError::new(format!("accessor {index} has sparse elements without a place in it"), DAMAGED);
        // As many as the accessor has: one may not be given again and again.
        let kind = Component::of(places.component_type, &OF_INDICES).filter(|_| sparse.count <= checked.count());
        let kind = kind.ok_or_else(wrong)?;
        let places = self.strided(index, places.buffer_view, places.byte_offset, kind.size(), sparse.count)?;
        let values = self.strided(index, values.buffer_view, values.byte_offset, checked.size, sparse.count)?;
        for (place, value) in places.iter().zip(values.iter()) {
            *elements.get_mut(kind.number(place) as usize).ok_or_else(wrong)? = element(value);
        }
        Ok(elements)
    }
}

/// Returns the bytes of a view of a buffer.
fn part<'a>(buffer: &'a [u8], view: &View) -> Option<&'a [u8]> {
    buffer.get(view.byte_offset..view.byte_offset.checked_add(view.byte_length)?)
}

/// Elements at equal distances in a part of a buffer.
struct Strided<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    count: usize,
}

impl<'a> Strided<'a> {
    fn iter(&self) -> impl Iterator<Item = &'a [u8]> {
        let (bytes, stride, size) = (self.bytes, self.stride, self.size);
        (0..self.count).map(move |k| &bytes[k * stride..k * stride + size])
    }
}
