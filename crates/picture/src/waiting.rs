//! Where pieces lie that wait on the board: side by side, in further layers where there are many.

use std::collections::BTreeMap;

use glam::{Quat, Vec3};
use saute_kitchen::{Kitchen, Piece, Place};
use saute_scene::mesh::props::{BOARD_CENTRE, BOARD_SIZE};

use crate::stage::Pose;

/// Room left between pieces and to the board's edge [m] (chosen).
const GAP: f32 = 0.006;
const MARGIN: f32 = 0.02;

/// Where the first piece on the board lies: near the pan, in view [m].
pub const FIRST_ON_BOARD: Vec3 = Vec3::new(BOARD_CENTRE.x - 0.07, BOARD_CENTRE.y, BOARD_CENTRE.z);

/// A column of pieces across the board.
#[derive(Default)]
struct Column {
    members: Vec<usize>,
    width: f32,
    length: f32,
}

/// Poses of the waiting pieces, by their place among all pieces: columns from the pan's side, each in its middle.
pub fn waiting_places(kitchen: &Kitchen) -> BTreeMap<usize, Pose> {
    let pieces = kitchen.pieces();
    let waiting = (0..pieces.len()).filter(|i| pieces[*i].place == Place::Waiting);
    let mut columns: Vec<Column> = Vec::new();
    for index in waiting {
        let [length, width] = extent(&pieces[index]);
        let fits = |c: &&mut Column| c.length + length + GAP <= BOARD_SIZE.y - MARGIN;
        match columns.last_mut().filter(fits) {
            Some(column) => column.take(index, width, length),
            None => {
                let mut column = Column::default();
                column.take(index, width, length);
                columns.push(column);
            }
        }
    }
    laid_out(pieces, &columns)
}

/// Length and width of a piece; its length is across the board [m].
fn extent(piece: &Piece) -> [f32; 2] {
    [piece.model.size()[0], piece.model.size()[1]].map(|v| v as f32)
}

impl Column {
    fn take(&mut self, index: usize, width: f32, length: f32) {
        self.members.push(index);
        self.width = self.width.max(width);
        self.length += length + GAP;
    }
}

fn laid_out(pieces: &[Piece], columns: &[Column]) -> BTreeMap<usize, Pose> {
    let left = BOARD_CENTRE.x - 0.5 * BOARD_SIZE.x + MARGIN;
    let right = BOARD_CENTRE.x + 0.5 * BOARD_SIZE.x;
    let (mut x, mut floor, mut layer) = (left, 0.0f32, 0.0f32);
    let mut places = BTreeMap::new();
    for column in columns {
        if x + column.width > right && x > left {
            (x, floor, layer) = (left, floor + layer + GAP, 0.0);
        }
        let mut y = BOARD_CENTRE.y + 0.5 * (column.length - GAP);
        for &index in &column.members {
            let piece = &pieces[index];
            let [length, _] = extent(piece);
            let half = piece.model.rest_height(&piece.state) as f32;
            let position = Vec3::new(x + 0.5 * column.width, y - 0.5 * length, BOARD_CENTRE.z + floor + half);
            places.insert(index, Pose { position, rotation: Quat::from_rotation_z(-std::f32::consts::FRAC_PI_2) });
            layer = layer.max(2.0 * half);
            y -= length + GAP;
        }
        x += column.width + GAP;
    }
    places
}
