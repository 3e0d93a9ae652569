//! Execution of commands.

use std::sync::Arc;

use glam::DVec3;
use saute_food::Rules;

use crate::dynamics::extent::{radius, reach};
use crate::dynamics::gesture::tilt;
use crate::dynamics::world::{BOARD_AT, BOARD_HALF};
use crate::dynamics::{Gesture, Pose, Task};
use crate::hands::command::{Command, Refused, RestOn};
use crate::hands::pour::Pouring;
use crate::hands::ranges::usable;
use crate::kelvin;
use crate::kitchen::Kitchen;
use crate::pan::cloth::Cloth;
use crate::pan::hold::Hold;
use crate::piece::piece_state::{Piece, Place};
use crate::piece::running::Running;

/// Largest displacement and lift of the pan [m] (chosen: within reach).
const FARTHEST_PAN: f64 = 0.5;
/// Height above the floor from which a piece is laid [m] (chosen: it lands in a tenth of a tick).
const LAY: f64 = 0.2e-3;
/// Height above other pieces from which a piece is dropped [m] (chosen: clear of their uneven tops).
const HEAP: f64 = 4.0e-3;

/// Distances of food on the board from the edge and from other food [m] (chosen: room for fingers).
const MARGIN: f64 = 0.015;
const BESIDE: f64 = 0.005;

impl Kitchen {
    /// Carries out a command. On an error the kitchen is unchanged.
    ///
    /// ```
    /// use saute_kitchen::{Command, Kitchen, Library, Refused, kelvin};
    ///
    /// let mut kitchen = Kitchen::new(&Library::embedded()?, "carbon-steel-26", kelvin(20.0))?;
    /// kitchen.apply(&Command::Lid(true))?;
    /// let refused = kitchen.apply(&Command::Oil { kind: None, mass: 0.010 });
    /// assert_eq!(refused, Err(Refused::LidIsOn));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn apply(&mut self, command: &Command) -> Result<(), Refused> {
        self.carry_out(command)?;
        if let Some(carried_out) = &mut self.carried_out {
            carried_out.push(command.clone());
        }
        Ok(())
    }

    /// Refuses what a lid prevents while it is on.
    pub(crate) fn check_lid(&self, command: &Command) -> Result<(), Refused> {
        let prevented = self.pan.lid.is_some() && command.needs_open_pan();
        if prevented { Err(Refused::LidIsOn) } else { Ok(()) }
    }

    fn carry_out(&mut self, command: &Command) -> Result<(), Refused> {
        self.check_lid(command)?;
        command.check_ranges()?;
        match command {
            Command::Hob(power) => self.set_hob(*power, None),
            Command::HobHold { temperature, power } => self.set_hob(*power, Some(*temperature)),
            Command::Put { food, at, heap } => self.put(food, *at, *heap),
            Command::Flip { food } => self.order(food, |key| Task::Flip { key }),
            Command::Rest { food, on } => self.rest(food, *on),
            Command::Halve { food, at } => self.halve(food, *at),
            Command::MovePan { at, lift } => self.move_pan(*at, *lift),
            Command::Cool { for_s } => {
                self.cool_at_once();
                let fresh = Cloth::fresh(&self.fixed.room.cloth, self.fixed.room.temperature(), *for_s);
                self.cloth.get_or_insert(fresh).remaining_s = *for_s;
                Ok(())
            }
            Command::Toss { .. } if !self.pieces.iter().any(Piece::in_pan) => Err(Refused::EmptyPan),
            Command::Toss { height } => self.toss(*height),
            Command::Shake { amplitude, hz, for_s } => {
                self.begin(Gesture::Shake { amplitude: *amplitude, hz: *hz, for_s: *for_s })
            }
            Command::Tilt { angle, towards } => {
                let [x, y, lift] = self.stands_at();
                let floor = *self.world.pan_shape();
                self.pan_hold.pose = floor.standing([x, y], lift, tilt(*angle, *towards));
                Ok(())
            }
            Command::Press { food, newtons, for_s } => {
                self.order(food, |key| Task::Press { key, newtons: *newtons, for_s: *for_s })
            }
            Command::Baste { food, for_s } => self.baste(food, *for_s),
            Command::Move { food, to } => self.order(food, |key| Task::Move { key, to: *to }),
            Command::Lead { tool, to, grip } => self.lead(*tool, to, grip.as_deref()),
            Command::LetGo => {
                self.let_go();
                Ok(())
            }
            Command::HoldPan { pose } => self.hold_pan(pose),
            Command::Oil { .. } | Command::Butter(_) | Command::Water(_) | Command::Lid(_) => self.pour(command),
            Command::Wipe => self.wipe(),
        }
    }

    /// Cools the pan at once under the rules of 2013.
    fn cool_at_once(&mut self) {
        if self.rules() == Rules::Paper2013 {
            let fixed = Arc::clone(&self.fixed);
            let before = fixed.pan.stored(&self.pan);
            let cool = kelvin(fixed.room.rules_2013.cloth_c);
            self.pan.temperature.iter_mut().for_each(|t| *t = t.min(cool));
            self.account.flows.other += before - fixed.pan.stored(&self.pan);
        }
    }

    /// Executes a command about liquids or the lid and adds it to the energy account.
    fn pour(&mut self, command: &Command) -> Result<(), Refused> {
        let fixed = Arc::clone(&self.fixed);
        let time = self.time_s();
        let mut at = Pouring { room: &fixed.room, covered: &self.load.covered, time, events: &mut self.events };
        let brought = fixed.pan.pour(&mut self.pan, command, &mut at)?;
        self.account.add_to_pan(brought.stored);
        self.account.flows.air += brought.air;
        self.account.flows.evaporation += brought.evaporation;
        self.account.flows.other += brought.other;
        Ok(())
    }

    /// Wipes the pan, if nothing is in it.
    fn wipe(&mut self) -> Result<(), Refused> {
        if let Some(piece) = self.pieces.iter().find(|piece| piece.in_pan()) {
            return Err(Refused::FoodToWipe(piece.id.clone()));
        }
        let fixed = Arc::clone(&self.fixed);
        let brought = fixed.pan.wipe(&mut self.pan, &fixed.room);
        self.account.add_to_pan(brought.stored);
        Ok(())
    }

    fn set_hob(&mut self, power: f64, hold: Option<f64>) -> Result<(), Refused> {
        let hob = &self.fixed.hob;
        let largest = hob.largest_w();
        if !(0.0..=largest).contains(&power) {
            return Err(Refused::Power { largest_w: largest as i64 });
        }
        if let Some(temperature) = hold {
            let Hold { lowest_c, highest_c, .. } = hob.hold().ok_or(Refused::NoSensor)?;
            if !(kelvin(*lowest_c)..=kelvin(*highest_c)).contains(&temperature) {
                return Err(Refused::HoldTemperature { lowest_c: *lowest_c as i64, highest_c: *highest_c as i64 });
            }
        }
        self.hob_w = hob.nearest_w(power);
        self.hold.set(hold);
        Ok(())
    }

    fn move_pan(&mut self, at: [f64; 2], lift: f64) -> Result<(), Refused> {
        let reach = 0.0..=FARTHEST_PAN;
        if !reach.contains(&lift) || !reach.contains(&libm::hypot(at[0], at[1])) {
            return Err(Refused::PanPlace { farthest_mm: libm::round(FARTHEST_PAN * 1e3) as i64 });
        }
        self.pan_hold.pose = self.world.pan_shape().standing(at, lift, self.pan_hold.pose.rotation);
        Ok(())
    }

    fn hold_pan(&mut self, pose: &Pose) -> Result<(), Refused> {
        let pose = usable(pose)?;
        self.pan_hold.gesture = None;
        self.pan_hold.pose = self.world.pan_shape().within_reach(&pose, FARTHEST_PAN);
        Ok(())
    }

    /// Position at which the pan is held and height of its lowest edge above the glass [m].
    fn stands_at(&self) -> [f64; 3] {
        let (shape, held) = (self.world.pan_shape(), &self.pan_hold.pose);
        [held.position.x, held.position.y, held.position.z - shape.thickness - shape.raise(held.rotation)]
    }

    /// Tosses what is in the pan, unless something in it still runs.
    fn toss(&mut self, height: f64) -> Result<(), Refused> {
        if let Some(piece) = self.pieces.iter().find(|piece| piece.runs()) {
            return Err(Refused::StillRuns(piece.id.clone()));
        }
        self.begin(Gesture::Toss { height })
    }

    fn begin(&mut self, gesture: Gesture) -> Result<(), Refused> {
        self.pan_hold.gesture = Some((gesture, 0.0));
        Ok(())
    }

    /// Queues a task of the second hand for a piece in the pan.
    fn order(&mut self, food: &str, task: impl Fn(u32) -> Task) -> Result<(), Refused> {
        let piece = self.piece_mut(food)?;
        if !piece.in_pan() {
            return Err(Refused::NotInPan(food.into()));
        }
        let task = task(piece.key);
        self.check_set(food)?;
        self.hand_over(task);
        Ok(())
    }

    /// Queues a task of the second hand; a tool that a person moves is laid down first.
    fn hand_over(&mut self, task: Task) {
        self.let_go();
        self.second_hand.tasks.push_back(task);
    }

    fn rest(&mut self, food: &str, on: RestOn) -> Result<(), Refused> {
        let index = self.index(food)?;
        let piece = &self.pieces[index];
        if piece.place == Place::Waiting {
            return Err(Refused::NotInPan(food.into()));
        }
        self.check_set(food)?;
        let to = self.free_board(piece);
        let key = piece.key;
        self.pieces[index].resting_on = on;
        if matches!(self.pieces[index].place, Place::Rest(_)) {
            self.pieces[index].place = Place::Rest(on);
            return Ok(());
        }
        self.hand_over(Task::TakeOut { key, to });
        Ok(())
    }

    /// Returns the first place on the board with room, from the left and front; else the place with the most room [m].
    fn free_board(&self, piece: &Piece) -> [f64; 2] {
        let taken: Vec<([f64; 2], f64)> = self.on_board();
        let own = self.world.solid(piece.key).map_or(0.0, radius);
        let (nx, ny) = (17, 13);
        let along =
            |i: usize, n: usize, half: f64| (half - own - MARGIN).max(0.0) * (2.0 * i as f64 / (n - 1) as f64 - 1.0);
        let places = (0..nx).flat_map(|i| (0..ny).map(move |j| (i, j)));
        let places =
            places.map(|(i, j)| [BOARD_AT.x + along(i, nx, BOARD_HALF.x), BOARD_AT.y + along(j, ny, BOARD_HALF.y)]);
        let room = |p: &[f64; 2]| {
            let gaps = taken.iter().map(|(q, r)| libm::hypot(p[0] - q[0], p[1] - q[1]) - r - own);
            gaps.fold(f64::INFINITY, f64::min) - BESIDE
        };
        let mut best = ([BOARD_AT.x, BOARD_AT.y], room(&[BOARD_AT.x, BOARD_AT.y]));
        for place in places {
            let free = room(&place);
            // The first place with room is kept; until then the best one so far.
            if best.1 < 0.0 && free > best.1 {
                best = (place, free);
            }
        }
        best.0
    }

    fn on_board(&self) -> Vec<([f64; 2], f64)> {
        let size = |key: u32| self.world.solid(key).map_or(0.0, radius);
        let lying = self.pieces.iter().filter(|p| matches!(p.place, Place::Rest(_)));
        let lying = lying.map(|p| ([p.pose.position.x, p.pose.position.y], size(p.key)));
        let coming = self.second_hand.tasks.iter().chain(&self.second_hand.current).filter_map(|task| match *task {
            Task::TakeOut { key, to } => Some((to, size(key))),
            _ => None,
        });
        lying.chain(coming).collect()
    }

    fn put(&mut self, food: &str, at: [f64; 2], heap: bool) -> Result<(), Refused> {
        let index = self.index(food)?;
        let piece = &self.pieces[index];
        if piece.in_pan() {
            return Err(Refused::AlreadyInPan(food.into()));
        }
        if !heap {
            self.check_room(piece, at)?;
        }
        if piece.place != Place::Waiting {
            let key = piece.key;
            self.hand_over(Task::PutBack { key, to: at });
            return Ok(());
        }
        let at = if heap { at } else { self.pour_out(index, at) };
        let piece = &self.pieces[index];
        let solid = piece.model.solid(&piece.state);
        let below = reach(&solid, -DVec3::Z);
        let height = if heap { self.heap_height(at, radius(&solid)) + HEAP } else { LAY };
        let pan = self.world.motion.pose;
        let lying = Pose::at(at[0], at[1], height + below).turned(DVec3::Z, piece.model.turned());
        let pose = pan.then(&lying);
        let (key, mass) = (piece.key, piece.mass());
        let friction = piece.friction(self.fixed.pan.film_at(&self.pan, at), &self.fixed.room);
        self.world.add(key, solid, mass, &pose);
        self.world.set_friction(key, friction);
        let piece = &mut self.pieces[index];
        (piece.pose, piece.place, piece.on_pan.since) = (pose, Place::Pan(at), 0.0);
        piece.lie();
        Ok(())
    }

    /// A poured food lands at a place and begins to run; other food stays as it is. Returns where its middle is.
    fn pour_out(&mut self, index: usize, at: [f64; 2]) -> [f64; 2] {
        let fixed = Arc::clone(&self.fixed);
        let Some(running) = Running::landed(&self.pieces[index].model, at, &fixed.pan) else { return at };
        let taken = self.under_others(index, &running, fixed.pan.section.points.len());
        let piece = &mut self.pieces[index];
        let Some(pose) = piece.repour(&running, &taken, (&fixed.pan, &fixed.room)) else { return at };
        piece.running = Some(running);
        [pose.position.x, pose.position.y]
    }

    /// Checks that a piece fits onto the floor without overlap.
    fn check_room(&self, piece: &Piece, at: [f64; 2]) -> Result<(), Refused> {
        let floor = self.world.pan_shape().floor;
        let footprint = piece.footprint();
        let reach = footprint.reach_from(at);
        if reach > floor {
            let mm = |v: f64| libm::ceil(v * 1e3) as i64;
            return Err(Refused::DoesNotFit { food: piece.id.clone(), reach_mm: mm(reach), floor_mm: mm(floor) });
        }
        for other in self.pieces.iter().filter(|p| p.key != piece.key) {
            if let Place::Pan(there) = other.place
                && footprint.overlaps(at, &other.footprint(), there)
            {
                return Err(Refused::Occupied { food: piece.id.clone(), other: other.id.clone() });
            }
        }
        Ok(())
    }

    /// Height of the highest piece or surface within a distance of a place in the pan, above the floor [m].
    fn heap_height(&self, at: [f64; 2], within: f64) -> f64 {
        let pan = self.world.motion.pose;
        let surface = self.world.pan_shape();
        let floor = surface.surface_height(libm::hypot(at[0], at[1]) + within);
        let tops = self.pieces.iter().filter(|p| p.in_pan()).filter_map(|p| {
            let (seen, solid) = (p.pose.seen_from(&pan), self.world.solid(p.key)?);
            let apart = libm::hypot(seen.position.x - at[0], seen.position.y - at[1]);
            (apart < within + radius(solid))
                .then(|| seen.position.z + reach(solid, seen.rotation.conjugate() * DVec3::Z))
        });
        tops.fold(floor, f64::max)
    }
}
