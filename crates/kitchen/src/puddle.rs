//! Juice in the pan that boils off, and the cloth under it.

use saute_food::water::latent_heat;

use crate::kitchen::Kitchen;
use crate::{TICK_S, kelvin};

impl Kitchen {
    /// Gives heat to the juice in the pan; what exceeds 100 °C boils off [J].
    pub(crate) fn boil_puddle(&mut self, heat: f64) {
        self.puddle_vapour = 0.0;
        if self.pan.puddle <= 0.0 {
            return;
        }
        self.pan.puddle_enthalpy += heat;
        self.flows.other += heat;
        let boiling = kelvin(100.0);
        let liquid = PUDDLE_SPECIFIC_HEAT * 100.0;
        let excess = self.pan.puddle_enthalpy - self.pan.puddle * liquid;
        if excess > 0.0 {
            let mass = (excess / latent_heat(boiling)).min(self.pan.puddle);
            let enthalpy =
                if mass < self.pan.puddle { mass * (liquid + latent_heat(boiling)) } else { self.pan.puddle_enthalpy };
            self.pan.puddle -= mass;
            self.pan.puddle_enthalpy -= enthalpy;
            self.flows.other -= enthalpy;
            self.flows.evaporation += enthalpy;
            self.puddle_vapour = mass / TICK_S;
        }
    }

    pub(crate) fn lift_off_cloth(&mut self) {
        if let Some(cloth) = &mut self.cloth {
            cloth.remaining_s -= TICK_S;
            if cloth.remaining_s < 0.5 * TICK_S {
                self.cloth = None;
            }
        }
    }
}

/// Specific heat with which the puddle's temperature is reckoned [J/(kg·K)] (water, standard tables).
pub(crate) const PUDDLE_SPECIFIC_HEAT: f64 = 4190.0;
