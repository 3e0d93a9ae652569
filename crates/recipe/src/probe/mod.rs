//! Probes: named points in the flesh whose temperature is remembered.

mod seen_point;

use std::sync::Arc;

use glam::Vec3;
use saute_kitchen::food::FoodModel;
use saute_kitchen::{Kitchen, Piece, celsius};

pub use self::seen_point::{NodeShares, SeenPoint};

/// Probes at most (chosen: as many as there are distinct line styles).
pub const MOST_PROBES: usize = 6;
/// Time between two points of a series [s] (chosen: as the rows of the other curves).
const EVERY_S: f64 = 1.0;
/// Time closer than this to the next point counts as reached [s] (chosen: far below a tick).
const SAME_TIME: f64 = 1e-6;

/// A probe.
#[derive(Clone, Debug)]
pub struct Probe {
    /// Its number, from 1, as its marker bears it; free again once it is taken out.
    pub number: usize,
    /// Its name.
    pub name: String,
    /// The piece it sits in.
    pub piece: String,
    /// Its place in the flesh.
    pub shares: NodeShares,
    /// Time [s] and temperature [°C], a point a second since it was put there.
    pub series: Vec<[f64; 2]>,
    model: Arc<FoodModel>,
}

impl Probe {
    /// Temperature at its point [°C].
    pub fn celsius(&self, piece: &Piece) -> f64 {
        celsius(self.shares.read(|node| piece.state.temperature[node]))
    }

    /// Where it is in its piece's body frame [m].
    pub fn place(&self, piece: &Piece) -> Vec3 {
        let positions = piece.model.positions(&piece.state);
        Vec3::from_array([0, 1, 2].map(|axis| self.shares.read(|node| positions[node][axis]) as f32))
    }

    fn sits_in<'a>(&self, kitchen: &'a Kitchen) -> Option<&'a Piece> {
        kitchen.piece(&self.piece).filter(|p| Arc::ptr_eq(&p.model, &self.model))
    }

    fn remember(&mut self, kitchen: &Kitchen) {
        let (Some(piece), time_s) = (self.sits_in(kitchen), kitchen.time_s()) else { return };
        if self.series.last().is_none_or(|last| time_s - last[0] > EVERY_S - SAME_TIME) {
            self.series.push([time_s, self.celsius(piece)]);
        }
    }
}

/// The probes of a cook.
#[derive(Clone, Debug, Default)]
pub struct Probes {
    list: Vec<Probe>,
    /// The number of the one that is being edited.
    pub selected: Option<usize>,
}

/// All probes are in use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("all {MOST_PROBES} probes are in use")]
pub struct NoProbeLeft;

impl Probes {
    /// All of them, by their numbers.
    pub fn all(&self) -> &[Probe] {
        &self.list
    }

    /// Those in one piece.
    pub fn of<'a>(&'a self, piece: &'a Piece) -> impl Iterator<Item = &'a Probe> + 'a {
        self.list.iter().filter(move |p| p.piece == piece.id && Arc::ptr_eq(&p.model, &piece.model))
    }

    /// The probe with a number.
    pub fn get(&self, number: usize) -> Option<&Probe> {
        self.list.iter().find(|p| p.number == number)
    }

    fn get_mut(&mut self, number: usize) -> Option<&mut Probe> {
        self.list.iter_mut().find(|p| p.number == number)
    }

    /// Names the probe with a number.
    pub fn rename(&mut self, number: usize, name: String) {
        if let Some(probe) = self.get_mut(number) {
            probe.name = name;
        }
    }

    /// Puts a new one in, with a name made from its number; returns that number.
    pub fn place(
        &mut self,
        kitchen: &Kitchen,
        point: SeenPoint,
        name: impl FnOnce(usize) -> String,
    ) -> Result<usize, NoProbeLeft> {
        let taken = |number: &usize| self.list.iter().any(|p| p.number == *number);
        let number = (1..=MOST_PROBES).find(|n| !taken(n)).ok_or(NoProbeLeft)?;
        let SeenPoint { piece, shares, model } = point;
        let mut probe = Probe { number, name: name(number), piece, shares, series: Vec::new(), model };
        probe.remember(kitchen);
        self.list.push(probe);
        self.list.sort_by_key(|p| p.number);
        Ok(number)
    }

    /// Moves one to another point of the same piece; its series starts again, because the old one belongs to another
    /// point.
    pub fn shift(&mut self, kitchen: &Kitchen, number: usize, point: SeenPoint) {
        let Some(probe) = self.get_mut(number) else { return };
        if probe.piece == point.piece && Arc::ptr_eq(&probe.model, &point.model) && probe.shares != point.shares {
            probe.shares = point.shares;
            probe.series.clear();
            probe.remember(kitchen);
        }
    }

    /// Takes one out.
    pub fn remove(&mut self, number: usize) {
        self.list.retain(|p| p.number != number);
        self.selected = self.selected.filter(|n| *n != number);
    }

    /// Forgets those whose pieces are gone.
    pub fn forget_gone(&mut self, kitchen: &Kitchen) {
        self.list.retain(|p| p.sits_in(kitchen).is_some());
        let selected = self.selected;
        self.selected = selected.filter(|n| self.list.iter().any(|p| p.number == *n));
    }

    /// Forgets what was remembered after a time [s], and probes that were put in after it.
    pub fn cut(&mut self, time_s: f64) {
        self.list.iter_mut().for_each(|p| p.series.retain(|point| point[0] < time_s));
        self.list.retain(|p| !p.series.is_empty());
    }

    /// Remembers the temperatures after a tick.
    pub fn observe(&mut self, kitchen: &Kitchen) {
        self.list.iter_mut().for_each(|p| p.remember(kitchen));
    }
}
