//! The body of a poured food takes the shape of its film.

use std::sync::Arc;

use glam::DVec3;
use saute_food::body::pool::{DIRECTIONS, Dome, HEIGHTS, Pool, RINGS};
use saute_food::{FoodSolver, PieceSpec};
use saute_heat::Located;

use crate::TICK_S;
use crate::data::room::Room;
use crate::dynamics::Pose;
use crate::dynamics::extent::reach;
use crate::hands::command::Refused;
use crate::kitchen::{Fixed, Kitchen};
use crate::pan::near_pan::uneven_of;
use crate::pan::pan_model::PanModel;
use crate::piece::medium::Media;
use crate::piece::piece_state::Piece;
use crate::piece::running::{Lies, Running, has_set};
use crate::piece::sear_lines::SearRecord;
use crate::piece::work;

/// Step along a ray to the edge of the film, and the farthest edge [m] (chosen: finer than the pan's mesh; the largest floor).
const RAY: f64 = 1.5e-3;
const FARTHEST: f64 = 0.16;
/// Share of the edge's height at which the film ends [-] (chosen: half way between a wet node and a dry one).
const EDGE: f64 = 0.4;
/// Share of a node at a patch from which the node is under its piece [-] (chosen).
const UNDER: f64 = 0.3;
/// Least reach of a piece [m] (chosen: smaller than what is poured).
const LEAST_REACH: f64 = 0.012;

impl Kitchen {
    /// Refuses what a piece that still runs cannot bear.
    pub(crate) fn check_set(&self, food: &str) -> Result<(), Refused> {
        let runs = self.piece(food).is_some_and(Piece::runs);
        if runs { Err(Refused::StillRuns(food.into())) } else { Ok(()) }
    }

    /// Lets what was poured run, and gives it its shape.
    pub(crate) fn run_poured(&mut self, fixed: &Fixed, gravity: [f64; 3]) {
        for index in 0..self.pieces.len() {
            let Some(mut running) = self.pieces[index].running.take() else { continue };
            let piece = &self.pieces[index];
            if !piece.in_pan() || !piece.state.healthy {
                continue;
            }
            let taken = self.under_others(index, &running, fixed.pan.section.points.len());
            let seen = piece.pose.seen_from(&self.world.motion.pose);
            let lies = Lies { model: &piece.model, state: &piece.state, seen, gravity, taken: &taken };
            running.run(&lies, &fixed.pan, TICK_S);
            let sets = has_set(&piece.model, &piece.state);
            let takes_shape = running.has_moved();
            if takes_shape {
                running.moved = 0.0;
            }
            let piece = &mut self.pieces[index];
            let pose = if takes_shape { piece.repour(&running, &taken, (&fixed.pan, &fixed.room)) } else { None };
            piece.running = (!sets).then_some(running);
            if let Some(pose) = pose {
                self.lay_poured(index, &pose);
            }
            if sets || takes_shape {
                let piece = &self.pieces[index];
                let film = fixed.pan.film_at(&self.pan, [seen.position.x, seen.position.y]);
                self.world.set_friction(piece.key, piece.friction(film, &fixed.room));
            }
        }
    }

    /// Lays a piece in its new shape at a pose in the pan's frame.
    fn lay_poured(&mut self, index: usize, pose: &Pose) {
        let piece = &mut self.pieces[index];
        piece.pose = self.world.motion.pose.then(pose);
        let (key, mass, solid, placed) = (piece.key, piece.mass(), piece.model.solid(&piece.state), piece.pose);
        self.touching.retain(|touching| !touching.pair.contains(&key));
        self.world.remove(key);
        self.world.add(key, solid, mass, &placed);
    }

    /// Nodes of the pan under other pieces, where nothing runs: of what runs itself, those at which there is more of it.
    pub(crate) fn under_others(&self, index: usize, own: &Running, nodes: usize) -> Vec<bool> {
        let mut taken = vec![false; nodes];
        for (_, other) in self.pieces.iter().enumerate().filter(|(k, _)| *k != index) {
            if let Some(running) = &other.running {
                let more = |node: usize| running.white(node) > own.white(node);
                taken.iter_mut().enumerate().for_each(|(node, taken)| *taken |= more(node));
                continue;
            }
            for near in other.near_patches() {
                let located = near.located.nodes.iter().zip(near.located.weights);
                located.filter(|(_, weight)| *weight > UNDER).for_each(|(node, _)| taken[*node as usize] = true);
            }
        }
        taken
    }
}

impl Piece {
    /// Gives the body the shape of its film; returns its pose in the pan's frame, or none if it cannot be meshed and keeps its shape.
    pub(crate) fn repour(
        &mut self,
        running: &Running,
        taken: &[bool],
        (pan, room): (&PanModel, &Room),
    ) -> Option<Pose> {
        let (pool, middle) = running.pool(pan, taken, self.model.description().pour.as_ref()?.edge_mm)?;
        let spec = PieceSpec { pool: Some(pool), ..self.spec };
        if !spec.has_sound_pool() {
            return None;
        }
        let model = self.model.poured_as(&spec).ok()?;
        work::check(&model, spec.coarseness).ok()?;
        let state = model.repoured(&self.model, &self.state);
        self.uneven = Arc::new(uneven_of(&model, spec.seed, room));
        self.touch.clear();
        self.touch.resize(model.patches().len(), saute_food::Touch::default());
        (self.model, self.state, self.spec) = (Arc::new(model), state, spec);
        (self.solver, self.sear, self.media) = (FoodSolver::default(), SearRecord::default(), Media::default());
        self.shape.update(&self.model, &self.state);
        self.on_pan.near.forget();
        let below = reach(&self.model.solid(&self.state), -DVec3::Z);
        Some(Pose::at(middle[0], middle[1], below))
    }
}

impl Running {
    /// The shape of the film about its middle, and that middle in the pan's frame [m]; none if there is no film. Half way to a node
    /// that is taken by others it ends.
    fn pool(&self, pan: &PanModel, taken: &[bool], edge_mm: f64) -> Option<(Pool, [f64; 2])> {
        let bed = &pan.liquids.bed;
        let height: Vec<f64> = (0..self.thin.len()).map(|i| self.white(i) * bed.per_area[i]).collect();
        let least = EDGE * 1e-3 * edge_mm;
        let middle = self.middle(pan, &height, least)?;
        let stands = |Located { nodes, weights }: &Located| -> f64 {
            (0..3).map(|k| weights[k] * height[nodes[k] as usize]).sum()
        };
        let at = |p: [f64; 2]| stands(&pan.locator.locate_or_nearest(&pan.section, p));
        let towards = |k: usize, r: f64| {
            let angle = core::f64::consts::TAU * k as f64 / DIRECTIONS as f64;
            [middle[0] + r * libm::cos(angle), middle[1] + r * libm::sin(angle)]
        };
        let wet = |p: [f64; 2]| {
            let located = pan.locator.locate_or_nearest(&pan.section, p);
            let taken = located.nodes.iter().zip(located.weights).filter(|(node, _)| taken[**node as usize]);
            let is_free = taken.map(|(_, weight)| weight).sum::<f64>() < 0.5;
            is_free && (stands(&located) > least || self.dome.top(p).is_some())
        };
        let edge = |k: usize| {
            let steps = (FARTHEST / RAY) as usize;
            let dry = (1..steps).find(|i| !wet(towards(k, *i as f64 * RAY))).unwrap_or(steps);
            (dry as f64 * RAY).max(LEAST_REACH)
        };
        let raw: [f64; DIRECTIONS] = core::array::from_fn(edge);
        let reach: [f64; DIRECTIONS] = core::array::from_fn(|k| {
            let [before, after] = [(k + DIRECTIONS - 1) % DIRECTIONS, (k + 1) % DIRECTIONS].map(|j| raw[j]);
            0.25 * (before + 2.0 * raw[k] + after)
        });
        let place = |k: usize, ring: usize| towards(k, reach[k] * ring as f64 / (RINGS - 1) as f64);
        let ring = |k: usize, ring: usize| {
            // Up to the yolk the white is as high as round it.
            let inside = (ring..RINGS).take_while(|r| self.dome.top(place(k, *r)).is_some()).count();
            let [near, far] = [ring, ring + inside].map(|r| at(place(k, r.min(RINGS - 1))));
            let height = if inside > 0 { near.max(far) } else { near };
            height.clamp(least, *HEIGHTS.end())
        };
        let heights = core::array::from_fn(|k| core::array::from_fn(|r| ring(k, r)));
        let dome = Dome { at: [0, 1].map(|axis| self.dome.at[axis] - middle[axis]), ..self.dome };
        Some((Pool { reach, height: heights, dome }, middle))
    }

    /// Centroid of what is wet [m].
    fn middle(&self, pan: &PanModel, height: &[f64], least: f64) -> Option<[f64; 2]> {
        let wet = (0..pan.floor_nodes).filter(|i| height[*i] > least);
        let (mut moment, mut area) = ([0.0; 2], 0.0);
        for i in wet {
            let ([x, y], share) = (pan.section.points[i], pan.section.areas[i]);
            moment = [moment[0] + share * x, moment[1] + share * y];
            area += share;
        }
        (area > 0.0).then(|| moment.map(|m| m / area))
    }
}
