//! One tick of heat and mass transfer: first each piece with pan, ground, air and other pieces, then the pan with hob and
//! room.

use std::sync::Arc;

use glam::DVec3;
use saute_food::water::{Runoff, latent_heat};
use saute_food::{Exchange, GRAVITY, Rules};
use saute_heat::Located;

use crate::data::room::Room;
use crate::dynamics::world::{Contact, GLASS_HALF};
use crate::dynamics::{Against, Pose};
use crate::hands::command::RestOn;
use crate::kitchen::{Fixed, Kitchen};
use crate::liquids::water_film::WATER_SPECIFIC_HEAT;
use crate::pan::hob::PanPose;
use crate::pan::hold::{HoldLoad, Holding};
use crate::pan::pan_model::{LEVEL, PanLoad, PanState};
use crate::piece::food_contact::{self, Touching};
use crate::piece::piece_state::{Piece, Place, Under};
use crate::tick::event::{Event, EventKind};
use crate::tick::lapse::Lapse;
use crate::tick::low_pass::low_pass;
use crate::{TICK_S, kelvin};

/// Change of a measure that updates the collision shape [m] (chosen: a tenth of a millimetre is not seen, and a piece that
/// shrinks in the pan can sleep between two updates). By the rules of 2013 every change does.
const NEW_SHAPE: f64 = 0.1e-3;

impl Kitchen {
    pub(crate) fn heat_tick(&mut self) {
        let fixed = Arc::clone(&self.fixed);
        self.food_tick(&fixed);
        self.step_pan(&fixed, Lapse::TICK);
        self.clock.count(Lapse::TICK);
    }

    /// Advances the pieces by a tick to which the pan is not advanced yet.
    pub(super) fn food_tick(&mut self, fixed: &Fixed) {
        self.load.clear();
        self.follow_pan(fixed);
        if !self.world.is_settled() {
            for piece in self.pieces.iter_mut().filter(|p| p.is_out()) {
                piece.contacts = self.world.contacts(piece.key);
            }
        }
        self.find_places();
        self.follow_shapes();
        if !self.world.is_settled() {
            self.find_touching();
        }
        self.exchange_between_foods(&fixed.room, Lapse::TICK);
        for index in 0..self.pieces.len() {
            self.step_piece(fixed, index, Lapse::TICK);
        }
    }

    /// Advances the pan with the load of all pieces.
    pub(crate) fn step_pan(&mut self, fixed: &Fixed, lapse: Lapse) {
        self.load.covered.iter_mut().for_each(|c| *c = c.min(1.0));
        let gravity = self.felt_gravity();
        self.run_poured(fixed, gravity);
        self.hold_pan_temperature(fixed, lapse);
        let load = PanLoad {
            hob: &fixed.hob,
            room: &fixed.room,
            hob_w: self.hob_power(),
            limited: self.hold.limit_share() < 1.0,
            time: self.clock.tick_start_s(),
            lapse_s: lapse.s(),
            food: &self.load.heat,
            covered: &self.load.covered,
            steam: &self.load.steam,
            gravity,
            rules: self.rules(),
        };
        let (pan, solver) = (&mut self.pan, &mut self.pan_solver);
        let exchange = fixed.pan.advance(pan, solver, &load, &mut self.cloth, &mut self.events, lapse.s());
        self.account.flows.hob += exchange.hob;
        self.account.flows.air += exchange.air;
        self.account.flows.other += exchange.other;
        self.vapour.cloth = exchange.cloth_vapour / lapse.s();
        self.account.flows.evaporation += exchange.vapour.enthalpy;
        self.vapour.puddle = exchange.vapour.mass / lapse.s();
        self.average_steam(fixed, lapse);
        self.lift_off_cloth(lapse);
    }

    /// Averages the steam over the pan and updates the share of its floor under food.
    fn average_steam(&mut self, fixed: &Fixed, lapse: Lapse) {
        let foods: f64 = self.pieces.iter().filter(|p| p.in_pan()).map(|p| p.vapour_flow.max(0.0)).sum();
        let steam = foods + self.vapour.puddle;
        low_pass(&mut self.pan.steam, steam, PLUME_S, lapse.s());
        let floor = self.load.covered.iter().zip(&fixed.pan.section.areas).take(fixed.pan.floor_nodes);
        self.pan.covered = floor.map(|(covered, area)| covered * area).sum::<f64>() / fixed.pan.floor_area;
    }

    /// Advances the electronics that hold the pan at a temperature.
    fn hold_pan_temperature(&mut self, fixed: &Fixed, lapse: Lapse) {
        let Some(hob) = fixed.hob.electronics() else { return };
        let detected = self.cloth.is_none() && fixed.hob.detects(&self.pan.pose);
        let load = HoldLoad {
            hob,
            class: &fixed.pan.class,
            largest: self.hob_w,
            given: self.hob_drawn_w(),
            // The sensor sits in the centre of the coil; node 0 is above it.
            glass: self.pan.glass[0],
            ring: if detected { fixed.pan.heated_temperature(&self.pan) } else { None },
            boils: self.pan.liquids.boils(),
            room: fixed.room.temperature(),
        };
        let before = self.hold.holding();
        self.hold.advance(&load, lapse.s());
        if self.hold.holding() != before {
            self.tell_of_hold();
        }
    }

    /// The hob reports its state.
    fn tell_of_hold(&mut self) {
        let kind = match self.hold.holding() {
            Some(Holding::Reached) => EventKind::DialReached,
            Some(Holding::Boils) => EventKind::BoilsBelowDial,
            Some(Holding::Warms) | None => return,
        };
        let amount = self.hold.target().unwrap_or_default();
        self.events.push(Event { time_s: self.clock.tick_start_s(), kind, at: [0.0; 3], amount });
    }

    fn lift_off_cloth(&mut self, lapse: Lapse) {
        if let Some(cloth) = &mut self.cloth {
            cloth.remaining_s -= lapse.s();
            if cloth.remaining_s < 0.5 * TICK_S {
                self.cloth = None;
            }
        }
    }

    /// Gravity minus the pan's mean acceleration since the last tick, in the pan's frame [m/s²].
    fn felt_gravity(&mut self) -> [f64; 3] {
        let motion = &self.world.motion;
        if motion.is_still()
            && motion.velocity == self.pan_hold.last_velocity
            && motion.pose.rotation == Pose::default().rotation
        {
            return LEVEL;
        }
        let acceleration = (motion.velocity - self.pan_hold.last_velocity) / TICK_S;
        let felt = DVec3::new(0.0, 0.0, -GRAVITY) - acceleration;
        self.pan_hold.last_velocity = motion.velocity;
        (motion.pose.rotation.conjugate() * felt).to_array()
    }

    /// Updates the pan's place over the hob from its rigid body.
    fn follow_pan(&mut self, fixed: &Fixed) {
        let at = self.world.motion.pose.position;
        let lift = at.z - self.world.pan_shape().thickness;
        let pose = PanPose { at: [at.x, at.y], lift: if lift < STANDING { 0.0 } else { lift } };
        if pose != self.pan.pose {
            fixed.pan.place(&mut self.pan, &fixed.hob, pose);
        }
    }

    /// Updates the place of every piece from its pose.
    fn find_places(&mut self) {
        let pan = self.world.motion.pose;
        let surface = *self.world.pan_shape();
        for piece in self.pieces.iter_mut().filter(|p| p.is_out()) {
            let seen = pan.to_body(piece.pose.position);
            let place = if self.second_hand.hand.gripped() == Some(piece.key) {
                Place::Held
            } else if surface.holds(seen) {
                Place::Pan([seen.x, seen.y])
            } else if self.world.is_settled() {
                continue;
            } else {
                ground(piece)
            };
            if piece.in_pan() && !matches!(place, Place::Pan(_)) {
                piece.leave_pan();
            }
            if place != piece.place && !matches!(place, Place::Pan(_) | Place::Held) {
                piece.onto_wood(self.fixed.room.temperature());
            }
            piece.place = place;
        }
    }

    fn follow_shapes(&mut self) {
        for piece in self.pieces.iter_mut().filter(|p| p.is_out()) {
            piece.free_all();
            if piece.follow_shape() {
                let film = match piece.place {
                    Place::Pan(at) => self.fixed.pan.film_at(&self.pan, at),
                    _ => 0.0,
                };
                let tolerance = if piece.model.rules() == Rules::Paper2013 { 0.0 } else { NEW_SHAPE };
                self.world.set_solid(piece.key, piece.model.solid(&piece.state), tolerance);
                self.world.set_mass(piece.key, piece.state.mass_left(&piece.model));
                self.world.set_friction(piece.key, piece.friction(film, &self.fixed.room));
            }
        }
    }

    /// Exchanges heat between pieces in contact; their patches in contact are closed to the air.
    pub(crate) fn exchange_between_foods(&mut self, room: &Room, lapse: Lapse) {
        for touching in &self.touching {
            let index = |key: u32| self.pieces.iter().position(|p| p.key == key);
            let [Some(i), Some(j)] = touching.pair.map(index) else { continue };
            // Keys ascend with the pieces: the first of a pair comes first.
            let (first, rest) = self.pieces.split_at_mut(j);
            let (a, b) = (&mut first[i], &mut rest[0]);
            // A frozen piece exchanges nothing.
            if a.state.healthy && b.state.healthy {
                food_contact::exchange(&room.food_contact, a, b, &touching.links, lapse.s());
            }
            for link in &touching.links {
                a.close(link.a);
                b.close(link.b);
            }
        }
    }

    fn find_touching(&mut self) {
        let mut before = core::mem::take(&mut self.touching);
        for (i, a) in self.pieces.iter().enumerate().filter(|(_, p)| p.is_out()) {
            for contact in &a.contacts {
                let Against::Piece(other) = contact.against else { continue };
                let Some(b) = self.pieces[i..].iter().find(|b| b.key == other) else { continue };
                let known = before.iter().position(|t| t.pair == [a.key, other]).map(|k| before.swap_remove(k));
                self.touching.push(Touching::between(a, b, known));
            }
        }
    }

    /// Advances a piece with pan, ground and air.
    pub(crate) fn step_piece(&mut self, fixed: &Fixed, index: usize, lapse: Lapse) {
        let under = match self.pieces[index].place {
            Place::Waiting => return,
            Place::Pan(_) | Place::Held | Place::Rest(RestOn::Rack) => Under::Air,
            Place::Rest(_) | Place::Table => Under::Wood,
            Place::Glass => Under::Glass(self.glass_under(index)),
        };
        self.meet(fixed, index, under, lapse);
        let air = self.air_round(fixed, &self.pieces[index]);
        let force = self.world.pressing(self.pieces[index].key);
        let piece = &mut self.pieces[index];
        let mut exchange = piece.advance(air, force, lapse.s());
        if piece.in_pan() {
            piece.steam_below(&fixed.pan, &fixed.room, lapse.s(), &mut exchange);
        }
        let exchanges = piece.in_pan() && piece.state.healthy;
        let condensed = if exchanges { self.exchange_with_media(fixed, index, lapse) } else { Runoff::default() };
        let piece = &mut self.pieces[index];
        if under == Under::Wood && piece.state.healthy {
            piece.warm_wood(&fixed.room, lapse.s());
        }
        let (core, time) = (piece.core(), self.clock.end_s(lapse));
        if core > piece.core_peak.0 {
            piece.core_peak = (core, time);
        }
        self.book(fixed, index, (&exchange, &condensed), lapse);
    }

    /// Takes the heat that media gave to a piece out of them: that of water from the pool; steam that gave heat condenses.
    /// Returns that water.
    fn exchange_with_media(&mut self, fixed: &Fixed, index: usize, lapse: Lapse) -> Runoff {
        let piece = &mut self.pieces[index];
        let heat = piece.take_media_heat(lapse.s());
        piece.heat_taken += heat.water + heat.steam + piece.solver.contact_heat.iter().sum::<f64>();
        if heat.water != 0.0 {
            self.account.flows.other -= fixed.pan.liquids.draw_from_pool(&mut self.pan.liquids, heat.water);
        }
        // A piece that is hotter than the steam round it warms it, and nothing condenses.
        self.account.flows.evaporation -= heat.steam.min(0.0);
        let mass = heat.steam.max(0.0) / latent_heat(kelvin(100.0));
        let piece = &mut self.pieces[index];
        piece.vapour_flow = (piece.vapour_flow - mass / lapse.s()).max(0.0);
        Runoff { mass, enthalpy: mass * WATER_SPECIFIC_HEAT * 100.0 }
    }

    /// Updates the contacts of a piece with pan and ground for this tick.
    fn meet(&mut self, fixed: &Fixed, index: usize, under: Under, lapse: Lapse) {
        let (force, pan_pose, surface) = (self.pan_force(index), self.world.motion.pose, *self.world.pan_shape());
        let time = self.clock.end_s(lapse);
        let piece = &mut self.pieces[index];
        if piece.in_pan() {
            let seen = piece.pose.seen_from(&pan_pose);
            piece.meet_pan(&fixed.pan, &surface, &seen, force, time, lapse.s());
            piece.touch_pan((&fixed.pan, &self.pan), (&surface, &seen), &fixed.room, lapse.s());
            piece.touch_spoon(&self.pan, lapse);
        }
        piece.touch_ground(under, &fixed.room);
    }

    /// Adds the exchange of a piece to the pan and to the energy account: heat from the pan's nodes, juice and fat.
    fn book(&mut self, fixed: &Fixed, index: usize, (exchange, condensed): (&Exchange, &Runoff), lapse: Lapse) {
        let piece = &self.pieces[index];
        let taken: f64 = piece.solver.contact_heat.iter().sum();
        if !piece.in_pan() {
            self.account.flows.air += exchange.air;
            self.account.flows.evaporation += exchange.evaporation;
            self.account.flows.other += exchange.drip.enthalpy + exchange.rendered.enthalpy - taken;
            return;
        }
        let vapour = without(exchange, condensed);
        let (air, evaporation) = fixed.pan.take_up(&mut self.pan, &fixed.room, || piece.face(false), &vapour);
        self.account.flows.air += air;
        self.account.flows.evaporation += evaporation;
        // Steam that boils off at the lower face rises through the oil there.
        let below = (taken - self.spooned(index)).max(0.0);
        let boiled = exchange.evaporated.min(below / latent_heat(kelvin(100.0))).max(0.0);
        self.load_pan(fixed, index, (boiled, lapse), [&exchange.drip, condensed]);
        self.take_from_fat(index, lapse);
        self.pieces[index].average_steam(boiled, lapse.s());
        let latent = self.pieces[index].model.description().fat_melting.latent_j_kg;
        self.account.flows.other += fixed.pan.render(&mut self.pan, &exchange.rendered, latent);
    }

    /// Adds what a piece took and gave in this tick to the pan below it: heat, cover, steam [kg], fond, juice and condensed
    /// steam.
    fn load_pan(&mut self, fixed: &Fixed, index: usize, (boiled, lapse): (f64, Lapse), dripping: [&Runoff; 2]) {
        let piece = &self.pieces[index];
        let whole: f64 = piece.near_patches().iter().map(|n| piece.patch_area(n.patch as usize)).sum();
        for near in piece.near_patches() {
            let (patch, at) = (near.patch as usize, &near.located);
            let (area, wet) = (piece.patch_area(patch), piece.wetness(piece.node_of(near.patch)));
            self.load.take(at, piece.solver.contact_heat[patch], lapse.s());
            self.load.cover(at, area, &fixed.pan.section.areas);
            for (node, weight) in at.nodes.into_iter().zip(at.weights) {
                let steam = weight * area / whole * boiled;
                self.load.steam[node as usize] += steam;
                if wet > 0.0 {
                    let model = &fixed.pan.liquids;
                    self.pan.liquids.fond.stick(&model.bed, node as usize, wet * steam * model.fond.left_by_steam);
                }
            }
            drip(fixed, &mut self.pan, at, |weight| weight * area / whole, dripping);
        }
        for oiled in &piece.media.in_oil {
            self.load.take(&oiled.located, piece.solver.contact_heat[oiled.patch as usize], lapse.s());
        }
        if let (true, Place::Pan(below)) = (piece.near_patches().is_empty(), piece.place) {
            let at = fixed.pan.locator.locate_or_nearest(&fixed.pan.section, below);
            drip(fixed, &mut self.pan, &at, |weight| weight, dripping);
        }
    }

    /// Temperature of the hob's glass under a piece [K].
    fn glass_under(&self, index: usize) -> f64 {
        let p = self.pieces[index].pose.position;
        let points = &self.fixed.pan.section.points[..self.pan.glass.len()];
        if libm::hypot(p.x, p.y) > self.world.pan_shape().floor {
            return self.fixed.room.temperature();
        }
        let distance = |i: &usize| libm::hypot(points[*i][0] - p.x, points[*i][1] - p.y);
        let nearest = (0..points.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map_or_else(|| self.fixed.room.temperature(), |i| self.pan.glass[i])
    }

    /// Normal force of a piece on floor and wall of the pan [N].
    fn pan_force(&self, index: usize) -> f64 {
        let piece = &self.pieces[index];
        if self.world.is_settled() {
            return piece.pan_force();
        }
        let on_pan = |c: &Contact| matches!(c.against, Against::Floor | Against::Wall);
        piece.contacts.iter().filter(|c| on_pan(c)).map(|c| c.force).sum()
    }
}

/// Time constant of the steam in the air over the pan [s] (chosen: the air in the pan is exchanged within a second or two).
const PLUME_S: f64 = 2.0;
/// Lift below which the pan stands on the glass [m] (chosen: above the rounding of the pan's motion).
const STANDING: f64 = 1e-6;

/// Returns an exchange without the vapour that condensed on the piece again.
fn without(exchange: &Exchange, condensed: &Runoff) -> Exchange {
    let enthalpy = condensed.enthalpy + condensed.mass * latent_heat(kelvin(100.0));
    Exchange {
        evaporated: exchange.evaporated - condensed.mass,
        evaporation: exchange.evaporation - enthalpy,
        ..*exchange
    }
}

/// Lets juice and water of a piece drip onto the pan at `at`: of all that runs off, each node there gets a share by its
/// weight. Only juice carries solids.
fn drip(fixed: &Fixed, pan: &mut PanState, at: &Located, share: impl Fn(f64) -> f64, [juice, water]: [&Runoff; 2]) {
    if juice.mass <= 0.0 && water.mass <= 0.0 {
        return;
    }
    for (node, weight) in at.nodes.into_iter().zip(at.weights) {
        let [mass, enthalpy] = [juice.mass + water.mass, juice.enthalpy + water.enthalpy].map(|v| share(weight) * v);
        let solids = share(weight) * juice.mass * fixed.pan.liquids.fond.juice_solids;
        pan.liquids.drip(node as usize, mass, enthalpy, solids);
    }
}

/// Returns the place of a piece that is not over the pan.
fn ground(piece: &Piece) -> Place {
    let on = |against: Against| piece.contacts.iter().any(|c| c.against == against);
    let p = piece.pose.position;
    if on(Against::Board) {
        Place::Rest(piece.resting_on)
    } else if !on(Against::Ground) {
        piece.place
    } else if p.x.abs() < GLASS_HALF && p.y.abs() < GLASS_HALF {
        Place::Glass
    } else {
        Place::Table
    }
}
