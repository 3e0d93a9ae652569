//! Basting: hot fat of the pan is spooned over the upper face of a piece.

use saute_food::{Face, Touch};

use crate::hands::command::Refused;
use crate::kitchen::Kitchen;
use crate::pan::pan_model::PanState;
use crate::piece::piece_state::Piece;
use crate::tick::lapse::Lapse;

/// Least fat in a pan from which a spoon takes any [kg] (chosen: a teaspoon in the corner of a tilted pan).
pub(crate) const LEAST_FAT: f64 = 4.0e-3;
/// Conductance of the fat to the face, on average over spoonfuls and the time between them [W/(m²·K)] (chosen: fat that runs over a face
/// gives 300, as oil round food that fries, and does so for half of the time).
const SPOONED: f64 = 150.0;
/// Upward component of a patch's normal from which the fat runs over it [-] (chosen: 60°).
const UPWARDS: f64 = 0.5;
/// Share of a basted face that fat covers [-] (chosen).
const COVERED: f64 = 0.9;

impl Kitchen {
    /// Begins to baste a piece in the pan for a time [s].
    pub(crate) fn baste(&mut self, food: &str, for_s: f64) -> Result<(), Refused> {
        let fat = self.pan.oil_mass();
        let piece = self.piece_mut(food)?;
        if !piece.in_pan() {
            return Err(Refused::NotInPan(food.into()));
        }
        if fat < LEAST_FAT {
            return Err(Refused::TooLittleFat { least_g: libm::ceil(1e3 * LEAST_FAT) as i64 });
        }
        piece.basted_s = for_s;
        Ok(())
    }

    /// Heat that spooned fat gave to a piece in this tick [J].
    pub(crate) fn spooned(&self, index: usize) -> f64 {
        let piece = &self.pieces[index];
        piece.basted.iter().map(|patch| piece.solver.contact_heat[*patch as usize]).sum()
    }

    /// Takes the heat that spooned fat gave to a piece in this tick out of the fat in the pan.
    pub(crate) fn take_from_fat(&mut self, index: usize, lapse: Lapse) {
        let heat = self.spooned(index);
        let (fat, whole) = (&self.pan.liquids.oil.mass, self.pan.oil_mass());
        if heat == 0.0 || whole <= 0.0 {
            return;
        }
        for (load, mass) in self.load.heat.iter_mut().zip(fat) {
            *load += heat / lapse.s() * mass / whole;
        }
    }
}

impl Piece {
    /// Sets the contacts of its upper face with spooned fat for a tick; without fat left the spoon is laid down.
    pub(crate) fn touch_spoon(&mut self, pan: &PanState, lapse: Lapse) {
        self.basted.clear();
        let fat = pan.oil_mass();
        if self.basted_s <= 0.0 || fat < LEAST_FAT || pan.lid.is_some() {
            self.basted_s = 0.0;
            return;
        }
        self.basted_s = (self.basted_s - lapse.s()).max(0.0);
        let heat: f64 = pan.liquids.oil.mass.iter().zip(&pan.temperature).map(|(m, t)| m * t).sum();
        let (touch, up) = (Touch::Contact { conductance: SPOONED, temperature: heat / fat }, self.up());
        for (index, patch) in self.model.patches().iter().enumerate() {
            let normal = self.shape.poses()[index].normal;
            let facing: f64 = (0..3).map(|k| normal[k] * up[k]).sum();
            if facing > UPWARDS && self.touch[index] == Touch::default() && patch.face != Face::Side {
                self.touch[index] = touch;
                self.basted.push(index as u32);
                let node = patch.node as usize;
                if self.state.healthy {
                    self.state.oiled[node] = self.state.oiled[node].max(COVERED);
                }
            }
        }
    }
}
