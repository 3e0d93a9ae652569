//! Registration: the rigid transform between two frames, from points touched in both or from a home pose.

use glam::{DMat3, DMat4, DQuat, DVec3};
use nalgebra::{Matrix4, SymmetricEigen, Vector4};

/// A rigid transform: a turn, then a shift [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid {
    /// The turn.
    pub rotation: DQuat,
    /// The shift [m].
    pub shift: DVec3,
}

impl Rigid {
    /// Both frames are one.
    pub const IDENTITY: Self = Self { rotation: DQuat::IDENTITY, shift: DVec3::ZERO };

    /// Takes a point from one frame to the other [m].
    pub fn point(&self, point: DVec3) -> DVec3 {
        self.rotation * point + self.shift
    }

    /// The way back.
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        Self { rotation, shift: -(rotation * self.shift) }
    }

    /// First the other one, then this one.
    pub fn after(&self, first: &Self) -> Self {
        Self { rotation: (self.rotation * first.rotation).normalize(), shift: self.point(first.shift) }
    }

    /// The transform as a matrix.
    pub fn matrix(&self) -> DMat4 {
        DMat4::from_rotation_translation(self.rotation, self.shift)
    }

    /// The transform to a frame in which a body at home has one pose from that in which it has another.
    pub fn from_home(home: &Self, same: &Self) -> Self {
        home.after(&same.inverse())
    }
}

/// A registration, and how well the points agree with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Registered {
    /// From the first frame to the second.
    pub transform: Rigid,
    /// Root mean square of the distances that are left [m].
    pub residual: f64,
}

/// Why points do not register.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RegistrationError {
    /// Too few.
    #[error("{0} points are too few: three or more are needed")]
    TooFew(usize),
    /// All of them are on a line.
    #[error("the points lie on a line, so that the turn about it stays open")]
    OnALine,
}

/// Points nearer to a line than this share of their extent do not determine the turn about it [-] (chosen: 5 mm of 10
/// cm).
const THINNEST: f64 = 0.05;
/// Most iterations of the eigenvalue solver [-] (chosen: far more than the few per eigenvalue that the QR algorithm
/// needs).
const EIGEN_ITERATIONS: usize = 1000;

/// The rigid transform that takes points to others with the least sum of squared distances (Horn 1987 `[@horn-1987]`,
/// with unit quaternions).
pub fn register(pairs: &[[DVec3; 2]]) -> Result<Registered, RegistrationError> {
    if pairs.len() < 3 {
        return Err(RegistrationError::TooFew(pairs.len()));
    }
    let count = pairs.len() as f64;
    let [from, to] = [0, 1].map(|side| pairs.iter().map(|pair| pair[side]).sum::<DVec3>() / count);
    if thinness(pairs, from) < THINNEST {
        return Err(RegistrationError::OnALine);
    }
    let product = pairs.iter().map(|[a, b]| outer(*a - from, *b - to));
    let rotation = best_turn(product.fold(DMat3::ZERO, |sum, p| sum + p));
    let transform = Rigid { rotation, shift: to - rotation * from };
    let squares: f64 = pairs.iter().map(|[a, b]| transform.point(*a).distance_squared(*b)).sum();
    Ok(Registered { transform, residual: (squares / count).sqrt() })
}

/// How far the points are spread across the line that they are nearest to, over how far along it [-].
fn thinness(pairs: &[[DVec3; 2]], middle: DVec3) -> f64 {
    let away = || pairs.iter().map(|pair| pair[0] - middle);
    let farthest = away().fold(DVec3::ZERO, |far, p| if p.length_squared() > far.length_squared() { p } else { far });
    let Some(along) = farthest.try_normalize() else { return 0.0 };
    away().map(|p| p.reject_from_normalized(along).length()).fold(0.0, f64::max) / farthest.length()
}

/// The matrix a bᵀ by columns of b.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

/// The rotation R with the largest Σ b·Ra, where the matrix is Σ a bᵀ. Its quaternion is the eigenvector of the largest
/// eigenvalue of Horn's symmetric 4 × 4 matrix; the sign of the eigenvector does not matter, as q and −q are the same
/// rotation. Returns NaN where there is no such eigenvector.
fn best_turn(s: DMat3) -> DQuat {
    let at = |row: usize, column: usize| s.col(column)[row];
    let (xx, yy, zz) = (at(0, 0), at(1, 1), at(2, 2));
    let (x, y, z) = (at(1, 2) - at(2, 1), at(2, 0) - at(0, 2), at(0, 1) - at(1, 0));
    let (xy, yz, zx) = (at(0, 1) + at(1, 0), at(1, 2) + at(2, 1), at(2, 0) + at(0, 2));
    let horn = Matrix4::from([
        [xx + yy + zz, x, y, z],
        [x, xx - yy - zz, xy, zx],
        [y, xy, yy - xx - zz, yz],
        [z, zx, yz, zz - xx - yy],
    ]);
    let Some(q) = largest_eigenvector(horn) else { return DQuat::NAN };
    // Horn's quaternion has its real part first.
    DQuat::from_xyzw(q[1], q[2], q[3], q[0]).normalize()
}

/// Returns the eigenvector of the largest eigenvalue of a symmetric matrix; none where the matrix is not finite or the
/// solver does not converge.
fn largest_eigenvector(symmetric: Matrix4<f64>) -> Option<Vector4<f64>> {
    if !symmetric.iter().all(|element| element.is_finite()) {
        return None;
    }
    let eigen = SymmetricEigen::try_new(symmetric, f64::EPSILON, EIGEN_ITERATIONS)?;
    // nalgebra does not sort the eigenvalues.
    Some(eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn truth() -> Rigid {
        let axis = DVec3::new(0.2, -0.4, 0.9).normalize();
        Rigid { rotation: DQuat::from_axis_angle(axis, 0.7), shift: DVec3::new(0.03, 0.21, -0.11) }
    }

    /// Points on a pan's rim (radius 0.14 m, 5 cm above the foot), and its middle.
    fn rim() -> Vec<DVec3> {
        let rim = (0..5).map(|k| f64::from(k) * std::f64::consts::TAU / 5.0);
        rim.map(|a| DVec3::new(0.14 * a.cos(), 0.14 * a.sin(), 0.05)).chain([DVec3::new(0.0, 0.0, 0.004)]).collect()
    }

    /// Normal noise from a seed (a sum of twelve even numbers).
    fn noise(seed: &mut u64) -> f64 {
        let mut even = || {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..12).map(|_| even()).sum::<f64>() - 6.0
    }

    #[test]
    fn points_without_noise_give_the_transform_back() {
        let pairs: Vec<_> = rim()[..3].iter().map(|p| [*p, truth().point(*p)]).collect();
        let found = register(&pairs).expect("registers");
        assert!(found.residual < 1e-12);
        assert!(found.transform.shift.distance(truth().shift) < 1e-12);
        assert!(found.transform.rotation.angle_between(truth().rotation) < 1e-7);
    }

    #[test]
    fn half_a_millimetre_of_noise_leaves_the_pan_half_a_millimetre_off_and_never_two() {
        let (mut seed, mut worst, mut squares, mut residual) = (7, 0.0f64, 0.0, 0.0);
        for _ in 0..1000 {
            let touched = |p: DVec3| {
                let off = DVec3::new(noise(&mut seed), noise(&mut seed), noise(&mut seed)) * 0.5e-3;
                [p, truth().point(p) + off]
            };
            let pairs: Vec<_> = rim().into_iter().map(touched).collect();
            let found = register(&pairs).expect("registers");
            let off = rim().into_iter().map(|p| found.transform.point(p).distance(truth().point(p)));
            let off: Vec<f64> = off.collect();
            worst = off.iter().copied().fold(worst, f64::max);
            squares += off.iter().map(|d| d * d).sum::<f64>() / 6000.0;
            residual += found.residual / 1000.0;
        }
        let off = squares.sqrt();
        eprintln!("off by {:.3} mm (RMS), {:.2} mm at most; residual {:.3} mm", 1e3 * off, 1e3 * worst, 1e3 * residual);
        // Of 18 numbers with 0.5 mm of noise 6 go into the transform and 12 into the residual, over 6 points.
        assert!((off / 0.5e-3 - 1.0).abs() < 0.05, "{off}");
        assert!((residual / (0.5e-3 * 2.0f64.sqrt()) - 1.0).abs() < 0.05, "{residual}");
        assert!(worst < 2.0e-3, "{worst}");
    }

    #[test]
    fn a_home_pose_registers_as_well_as_points_do() {
        let in_kitchen = Rigid { rotation: DQuat::from_rotation_z(0.2), shift: DVec3::new(0.0, 0.01, 0.0) };
        let in_rig = truth().after(&in_kitchen);
        let found = Rigid::from_home(&in_rig, &in_kitchen);
        assert!(found.shift.distance(truth().shift) < 1e-12);
        assert!(found.rotation.angle_between(truth().rotation) < 1e-7);
    }

    #[test]
    fn too_few_points_and_points_on_a_line_are_refused() {
        let pair = |x: f64| [DVec3::X * x, DVec3::Y * x];
        assert_eq!(register(&[pair(0.0), pair(0.1)]), Err(RegistrationError::TooFew(2)));
        assert_eq!(register(&[pair(0.0), pair(0.1), pair(0.2)]), Err(RegistrationError::OnALine));
        assert_eq!(register(&[pair(0.1); 4]), Err(RegistrationError::OnALine));
    }
}
