//! Small symmetric linear systems and eigenvalues, on the stack.

/// Solves `a x = b` by Cholesky decomposition for the leading `n` × `n` block of a symmetric `a`; `b` becomes x.
///
/// Returns false if the block is not positive definite.
pub fn solve_symmetric<const N: usize>(a: &mut [[f64; N]; N], b: &mut [f64; N], n: usize) -> bool {
    for i in 0..n {
        for j in 0..=i {
            let sum = a[i][j] - (0..j).map(|k| a[i][k] * a[j][k]).sum::<f64>();
            if i != j {
                a[i][j] = sum / a[j][j];
            } else if sum > 0.0 {
                a[i][i] = libm::sqrt(sum);
            } else {
                return false;
            }
        }
    }
    for i in 0..n {
        b[i] = (b[i] - (0..i).map(|k| a[i][k] * b[k]).sum::<f64>()) / a[i][i];
    }
    for i in (0..n).rev() {
        b[i] = (b[i] - (i + 1..n).map(|k| a[k][i] * b[k]).sum::<f64>()) / a[i][i];
    }
    true
}

/// Number of Jacobi sweeps (chosen: 6 × 6 matrices converge in five or six).
const SWEEPS: usize = 12;

/// Returns the eigenvalues of a symmetric matrix, unordered (cyclic Jacobi method).
pub fn eigenvalues<const N: usize>(mut a: [[f64; N]; N]) -> [f64; N] {
    for _ in 0..SWEEPS {
        for p in 0..N {
            for q in p + 1..N {
                rotate(&mut a, p, q);
            }
        }
    }
    std::array::from_fn(|i| a[i][i])
}

/// Applies the Jacobi rotation that zeroes an off-diagonal entry.
fn rotate<const N: usize>(a: &mut [[f64; N]; N], p: usize, q: usize) {
    if a[p][q] == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let t = theta.signum() / (theta.abs() + libm::sqrt(theta * theta + 1.0));
    let c = 1.0 / libm::sqrt(t * t + 1.0);
    let s = t * c;
    for row in a.iter_mut() {
        (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
    }
    let (upper, lower) = (a[p], a[q]);
    a[p] = std::array::from_fn(|k| c * upper[k] - s * lower[k]);
    a[q] = std::array::from_fn(|k| s * upper[k] + c * lower[k]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symmetric_system_is_solved_and_an_indefinite_one_refused() {
        let mut b = [1.0, 2.0, 99.0];
        assert!(solve_symmetric(&mut [[4.0, 1.0, 9.0], [1.0, 3.0, 9.0], [9.0; 3]], &mut b, 2));
        assert!((4.0 * b[0] + b[1] - 1.0).abs() < 1e-14 && (b[0] + 3.0 * b[1] - 2.0).abs() < 1e-14);
        assert!(!solve_symmetric(&mut [[1.0, 2.0], [2.0, 1.0]], &mut [0.0; 2], 2));
    }

    #[test]
    fn eigenvalues_of_a_known_matrix() {
        let mut found = eigenvalues([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 5.0]]);
        found.sort_by(f64::total_cmp);
        assert!(found.iter().zip([1.0, 3.0, 5.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }
}
