//! The fields of a cook as files that ParaView reads, written while it cooks.

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_formats::fields::{Inside, pan, surface};
use saute_formats::vtk::{Collection, Grid};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::food::FoodModel;
use saute_kitchen::{Kitchen, Piece, TICK_S};
use saute_picture::stage;
use saute_recipe::step_record::rounded;

use crate::error::CliError;
use crate::output::out_dir::OutDir;

/// File with the times of all others.
pub const SERIES: &str = "fields.pvd";

/// Grids at regular times, on their way into a folder.
#[derive(Debug)]
pub struct FieldFiles {
    every_ticks: u64,
    /// Number of instants so far.
    count: usize,
    /// The tick of the last one.
    last: Option<u64>,
    series: Collection,
    /// Cells of the pieces by their keys, with the models that they are of.
    insides: BTreeMap<u32, (Arc<FoodModel>, Inside)>,
}

impl FieldFiles {
    /// Returns files at every multiple of an interval [s], which is rounded to ticks.
    pub fn every(every_s: f64) -> Self {
        let every_ticks = (every_s / TICK_S).round().max(1.0) as u64;
        Self { every_ticks, count: 0, last: None, series: Collection::default(), insides: BTreeMap::new() }
    }

    /// Writes the fields of this instant if they are due.
    pub fn look(&mut self, kitchen: &Kitchen, out: &mut OutDir) -> Result<(), CliError> {
        let due = kitchen.tick().is_multiple_of(self.every_ticks);
        if due { self.write(kitchen, out) } else { Ok(()) }
    }

    /// Writes the fields of the last instant, and the times of all.
    pub fn end(mut self, kitchen: &Kitchen, out: &mut OutDir) -> Result<(), CliError> {
        self.write(kitchen, out)?;
        out.keep(SERIES, self.series.pvd().as_bytes())
    }

    fn write(&mut self, kitchen: &Kitchen, out: &mut OutDir) -> Result<(), CliError> {
        if self.last == Some(kitchen.tick()) {
            return Ok(());
        }
        let (poses, time_s) = (stage::poses(kitchen), rounded(kitchen.time_s()));
        let mut part = 0;
        for (piece, pose) in kitchen.pieces().iter().zip(&poses) {
            let pose = precise(pose);
            let inside = self.inside(piece).grid(piece, &pose, time_s);
            let id = &piece.id;
            self.add(&inside, (&format!("inside.{id}"), id), &mut part, out)?;
            let skin = surface::surface(piece, &pose, time_s);
            self.add(&skin, (&format!("surface.{id}"), &format!("{id}, surface")), &mut part, out)?;
        }
        let pan = Grid { time_s, ..pan::pan(kitchen, &floor(kitchen)) };
        self.add(&pan, ("pan", "pan"), &mut part, out)?;
        (self.count, self.last) = (self.count + 1, Some(kitchen.tick()));
        Ok(())
    }

    /// Writes a grid as a part of this instant; `names` are those of its file and for people.
    fn add(&mut self, grid: &Grid, names: (&str, &str), part: &mut usize, out: &mut OutDir) -> Result<(), CliError> {
        let file = format!("fields_{:04}_{}.vtu", self.count, names.0);
        self.series.push(grid.time_s, *part, names.1, &file);
        *part += 1;
        out.keep(&file, &grid.vtu())
    }

    /// The cells of a piece, which stay while its model does.
    fn inside(&mut self, piece: &Piece) -> &Inside {
        let known = |(model, _): &mut (Arc<FoodModel>, Inside)| Arc::ptr_eq(model, &piece.model);
        if !self.insides.get_mut(&piece.key).is_some_and(known) {
            self.insides.remove(&piece.key);
        }
        let of_model = || (Arc::clone(&piece.model), Inside::of(&piece.model));
        &self.insides.entry(piece.key).or_insert_with(of_model).1
    }
}

/// A pose of the picture in double precision.
fn precise(pose: &stage::Pose) -> Pose {
    Pose { position: pose.position.as_dvec3(), rotation: pose.rotation.as_dquat().normalize() }
}

/// The pose of the centre of the pan's floor, as the picture has it.
fn floor(kitchen: &Kitchen) -> Pose {
    let below = precise(&stage::pan_pose(kitchen));
    let up = below.rotation * glam::DVec3::Z * kitchen.world().pan_shape().thickness;
    Pose { position: below.position + up, ..below }
}
