//! Commands that add oil, butter or water to the pan, or move the lid.

use crate::data::room::Room;
use crate::hands::command::{Command, Refused};
use crate::kelvin;
use crate::liquids::oil_film::Dose;
use crate::liquids::water_film::{Vapour, WATER_DENSITY, WATER_SPECIFIC_HEAT};
use crate::pan::lid::Lid;
use crate::pan::pan_model::{PanModel, PanState};
use crate::tick::event::{Event, EventKind, EventLog};

/// Temperature of oil above which added water is reported as spattering [K] (110 °C, chosen: well above boiling).
const HOT_OIL: f64 = 383.15;

/// Context of a pour.
pub(crate) struct Pouring<'a> {
    /// The room.
    pub room: &'a Room,
    /// Share of each node under food [-].
    pub covered: &'a [f64],
    /// Time [s].
    pub time: f64,
    /// Event log.
    pub events: &'a mut EventLog,
}

/// Energy that crosses the kitchen's boundary by a command [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Brought {
    /// Into the pan's store, with what was poured or put on.
    pub stored: f64,
    /// To the room's air.
    pub air: f64,
    /// To the room as vapour.
    pub evaporation: f64,
    /// With the lid that was taken off.
    pub other: f64,
}

impl PanModel {
    /// Executes a command about liquids or the lid; other commands change nothing.
    pub(crate) fn pour(&self, state: &mut PanState, what: &Command, at: &mut Pouring) -> Result<Brought, Refused> {
        if let Command::Lid(on) = what {
            return Ok(self.cover(state, *on, at));
        }
        let before = self.stored(state);
        match what {
            Command::Oil { kind, mass } => {
                self.pour_oil(state, kind.as_deref().unwrap_or(&at.room.oil.default), *mass, at)?;
            }
            Command::Butter(mass) => self.lay_butter(state, self.liquids.butter_kind(), *mass, at)?,
            Command::Water(mass) => self.throw_water(state, *mass, at)?,
            _ => return Ok(Brought::default()),
        }
        self.liquids.refresh_film(&mut state.liquids, at.room);
        Ok(Brought { stored: self.stored(state) - before, ..Brought::default() })
    }

    fn pour_oil(&self, state: &mut PanState, id: &str, mass: f64, at: &Pouring) -> Result<(), Refused> {
        let Some(kind) = self.liquids.oils.iter().position(|o| o.id == id) else {
            let known = self.liquids.oils.iter().map(|o| o.id.as_str()).collect::<Vec<_>>().join(", ");
            return Err(Refused::NoSuchOil { kind: id.into(), known });
        };
        if self.liquids.oils[kind].description.emulsion.is_some() {
            return self.lay_butter(state, Some(kind), mass, at);
        }
        self.check_amount("oil", state, mass, self.liquids.oils[kind].density(at.room.temperature()))?;
        let PanState { liquids, temperature, .. } = state;
        let dose = Dose { kind, mass, temperature: at.room.temperature() };
        self.liquids.pour_oil(liquids, dose, &self.capacity, temperature);
        Ok(())
    }

    fn lay_butter(&self, state: &mut PanState, kind: Option<usize>, mass: f64, at: &Pouring) -> Result<(), Refused> {
        let model = self.liquids.butter.as_ref().filter(|b| Some(b.kind) == kind);
        let Some(model) = model else {
            return Err(Refused::NoSuchOil { kind: "butter".into(), known: at.room.oil.butter.clone() });
        };
        self.check_amount("butter", state, mass, self.liquids.oils[model.kind].density(at.room.temperature()))?;
        state.liquids.butter.lay(model, &self.liquids.bed, at.covered, mass, at.room.temperature());
        Ok(())
    }

    fn throw_water(&self, state: &mut PanState, mass: f64, at: &mut Pouring) -> Result<(), Refused> {
        self.check_amount("water", state, mass, WATER_DENSITY)?;
        let enthalpy = mass * WATER_SPECIFIC_HEAT * (at.room.temperature() - kelvin(0.0));
        let oil = &state.liquids.oil.mass;
        let hot = |i: &usize| oil[*i] > 0.0 && state.temperature[*i] > HOT_OIL;
        let hottest =
            (0..self.floor_nodes).filter(hot).max_by(|a, b| state.temperature[*a].total_cmp(&state.temperature[*b]));
        if let Some(node) = hottest {
            let place = self.liquids.bed.places[node];
            at.events.push(Event { time_s: at.time, kind: EventKind::WaterInHotOil, at: place, amount: mass });
        }
        self.liquids.pour_water(&mut state.liquids, Vapour { mass, enthalpy });
        Ok(())
    }

    fn check_amount(&self, what: &'static str, state: &PanState, mass: f64, density: f64) -> Result<(), Refused> {
        let room_left = (self.liquids.volume - state.liquids.total() / WATER_DENSITY).max(0.0);
        if mass > 0.0 && mass <= density * room_left {
            return Ok(());
        }
        Err(Refused::Amount { what, holds_g: (1e3 * density * room_left) as i64 })
    }

    /// Puts the lid on or takes it off; no effect if it is in that state already.
    fn cover(&self, state: &mut PanState, on: bool, at: &mut Pouring) -> Brought {
        match (on, state.lid) {
            (true, None) => {
                let lid = Lid::put_on(&self.description, at.room);
                state.lid = Some(lid);
                Brought { stored: lid.stored(), ..Brought::default() }
            }
            (false, Some(lid)) => {
                state.lid = None;
                let steam = lid.released();
                at.events.push(Event {
                    time_s: at.time,
                    kind: EventKind::SteamReleased,
                    at: [0.0, 0.0, 1e-3 * self.description.wall.height_mm],
                    amount: steam.mass,
                });
                let air = lid.enthalpy - steam.enthalpy;
                Brought { air, evaporation: steam.enthalpy, other: lid.stored() - lid.enthalpy, stored: 0.0 }
            }
            _ => Brought::default(),
        }
    }
}
