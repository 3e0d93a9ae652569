//! Places of nodes, as matrices in column-major order and single precision, as in glTF.

use crate::gltf_file::document::Node;

/// A transformation.
pub type Matrix = [[f32; 4]; 4];

/// The transformation that changes nothing.
pub const UNIT: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// Returns the transformation of a node: its matrix, or its translation after its rotation after its scale.
pub fn of(node: &Node) -> Matrix {
    if let Some(matrix) = node.matrix {
        let columns = matrix.as_chunks::<4>().0;
        return [columns[0], columns[1], columns[2], columns[3]];
    }
    let [x, y, z] = node.translation.unwrap_or_default();
    let scale = node.scale.unwrap_or([1.0; 3]);
    let [a, b, c] = rotation(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
    let column = |direction: [f32; 3], factor: f32| {
        let [u, v, w] = direction.map(|part| part * factor);
        [u, v, w, 0.0]
    };
    [column(a, scale[0]), column(b, scale[1]), column(c, scale[2]), [x, y, z, 1.0]]
}

/// Returns the columns of the rotation by a unit quaternion x, y, z, w.
fn rotation([x, y, z, w]: [f32; 4]) -> [[f32; 3]; 3] {
    let [x2, y2, z2] = [x + x, y + y, z + z];
    [
        [1.0 - y2 * y - z2 * z, x2 * y + z2 * w, x2 * z - y2 * w],
        [x2 * y - z2 * w, 1.0 - x2 * x - z2 * z, y2 * z + x2 * w],
        [x2 * z + y2 * w, y2 * z - x2 * w, 1.0 - x2 * x - y2 * y],
    ]
}

/// Returns the matrix product a b.
pub fn product(a: Matrix, b: Matrix) -> Matrix {
    b.map(|column| [0, 1, 2, 3].map(|row| (0..4).map(|k| a[k][row] * column[k]).sum()))
}

/// Returns a transformed point, computed in double precision and rotated from y up to z up.
pub fn placed(m: Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let [right, up, front] = [0, 1, 2].map(|row| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| f64::from(m[k][row]));
        a * x + b * y + c * z + d
    });
    [right, -front, up]
}

/// Returns the determinant of the linear part; it is negative for a reflection.
pub fn determinant(m: Matrix) -> f32 {
    let [a, b, c] = [m[0], m[1], m[2]];
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}
