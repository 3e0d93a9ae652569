//! Puts pieces into the pan, and states what came of it.

use crate::app::SauteApp;
use saute_kitchen::{Command, Place};

impl SauteApp {
    /// Lays pieces onto the floor of the pan, as many as fit, and states how many that are.
    pub(crate) fn lay_in(&mut self, ids: &[String]) {
        let wanted = self.outside(ids);
        match wanted.len() {
            0 => self.say_what_is_in(ids),
            all => {
                let played = self.session.runner.is_some();
                match self.session.lay(&wanted) {
                    Ok(0) if all == 1 => self.put_at_middle(wanted[0].clone()),
                    Ok(fit) if fit < all => {
                        let l = self.settings.language;
                        self.desk.notice.say(l.fill("notice.some_fit", &[("fit", &fit), ("all", &all)]));
                    }
                    Ok(_) if played => self.say("notice.taken_over"),
                    Ok(_) => {}
                    Err(refused) => self.say_not_done(&refused),
                }
            }
        }
    }

    /// Drops pieces into the pan onto each other.
    pub(crate) fn heap_in(&mut self, ids: &[String]) {
        let wanted = self.outside(ids);
        if let Err(refused) = self.session.heap(&wanted) {
            self.say_not_done(&refused);
        }
    }

    /// The piece that a hand means: the selected one, else the one in the pan nearest to its middle, else the first.
    pub(crate) fn handled_id(&self) -> String {
        let away = |at: [f64; 2]| at[0].hypot(at[1]);
        let pieces = self.session.kitchen.pieces().iter();
        let in_pan = pieces.filter_map(|p| match p.place {
            Place::Pan(at) => Some((away(at), p)),
            _ => None,
        });
        let nearest = in_pan.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, p)| p);
        self.session.selected().or(nearest).map_or_else(|| self.session.shown_id(), |p| p.id.clone())
    }

    fn outside(&self, ids: &[String]) -> Vec<String> {
        let outside = |id: &&String| self.session.kitchen.piece(id).is_some_and(|p| !p.in_pan());
        ids.iter().filter(outside).cloned().collect()
    }

    /// The kitchen states why a piece cannot be put in.
    fn put_at_middle(&mut self, food: String) {
        self.command(&Command::Put { food, at: [0.0, 0.0], heap: false });
    }

    fn say_what_is_in(&mut self, ids: &[String]) {
        match ids.first() {
            Some(id) => self.put_at_middle(id.clone()),
            None => self.say("inside.no_food"),
        }
    }
}
