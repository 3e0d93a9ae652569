//! What a person saves of a cook as a file.

use std::collections::BTreeSet;

use saute_recipe::session::Deed;
use saute_recipe::session::session_file::ENDING;

use crate::session::Session;
use crate::words::language::Language;

/// A file that is made of a cook.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Export {
    /// The session: it can be gone on with.
    Cook,
    /// Temperatures and masses as a table.
    Readings,
}

impl Export {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Cook, Self::Readings];

    /// How the name of its file ends.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Cook => ENDING,
            Self::Readings => "csv",
        }
    }

    /// A name for its file.
    pub fn file_name(self, l: Language) -> String {
        format!("{}.{}", l.text("pantry.cook_file"), self.ending())
    }

    /// Its type, as browsers call it.
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Cook => "application/octet-stream",
            Self::Readings => "text/csv",
        }
    }

    /// Key of the words on its button.
    pub fn words(self) -> &'static str {
        match self {
            Self::Cook => "pantry.save_cook",
            Self::Readings => "pantry.save_readings",
        }
    }
}

impl Session {
    /// The file of the cook that is shown; a session holds what lies ahead of the shown instant, too.
    pub fn exported(&self, what: Export) -> Vec<u8> {
        match what {
            Export::Cook => self.whole_recording().to_file(),
            Export::Readings => self.readings().into_bytes(),
        }
    }

    /// A row each second; a food that was not there yet, or no longer, leaves its columns empty.
    fn readings(&self) -> String {
        let lists = self.piece_lists();
        let all: Vec<&String> = lists.iter().flat_map(|(_, ids)| ids).collect::<BTreeSet<_>>().into_iter().collect();
        let columns = all.iter().flat_map(|id| FOOD_COLUMNS.map(|column| format!("{id}.{column}")));
        let head = ["time_s", "hob_drawn_w", "pan_c"].map(str::to_owned).into_iter().chain(columns);
        let lines = self.recorder.rows.iter().map(|row| {
            let fits = |(at_s, ids): &&(f64, Vec<String>)| *at_s <= row.time_s && ids.len() == row.foods.len();
            let ids = lists.iter().rev().find(fits).map_or(&[][..], |(_, ids)| ids);
            let own = [format!("{:.1}", row.time_s), format!("{:.0}", row.hob_drawn_w), format!("{:.3}", row.pan_c)];
            let food = |id: &&String| ids.iter().position(|there| there == *id).map(|place| row.foods[place]);
            let cells = |food: Option<[f64; 4]>| food.map_or_else(Default::default, |of| of.map(|v| format!("{v:.3}")));
            own.into_iter().chain(all.iter().map(food).flat_map(cells)).collect::<Vec<_>>().join(",")
        });
        let mut text = std::iter::once(head.collect::<Vec<_>>().join(",")).chain(lines).collect::<Vec<_>>().join("\n");
        text.push('\n');
        text
    }

    /// The pieces in their order, from each time on at which they changed [s].
    fn piece_lists(&self) -> Vec<(f64, Vec<String>)> {
        let recipe = self.recording().beginning().recipe(&self.library);
        let mut ids: Vec<String> =
            recipe.map(|r| r.foods.iter().map(|food| food.id.clone()).collect()).unwrap_or_default();
        let mut lists = vec![(0.0, ids.clone())];
        for entry in self.recording().entries() {
            match &entry.deed {
                Deed::Add(order) => ids.push(order.id.clone()),
                Deed::Remove(gone) => ids.retain(|id| id != gone),
                _ => continue,
            }
            lists.push((entry.time_s(), ids.clone()));
        }
        lists
    }
}

/// Columns of each food after its id and a dot: temperatures [°C] and mass [g].
const FOOD_COLUMNS: [&str; 4] = ["core_c", "top_c", "bottom_c", "mass_g"];

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use saute_kitchen::Library;

    use super::*;

    #[test]
    fn readings_keep_each_food_in_its_own_columns() {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let mut session = Session::new(library, &Default::default()).expect("sets out");
        let tick = |session: &mut Session, s: usize| (0..10 * s).for_each(|_| session.tick().expect("ticks"));
        tick(&mut session, 2);
        let group = session.add(&Default::default(), 1).expect("adds");
        tick(&mut session, 2);
        session.remove(&["steak".to_owned()]);
        tick(&mut session, 2);
        let text = String::from_utf8(session.exported(Export::Readings)).expect("text");
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(
            rows[0][3..],
            ["steak.core_c", "steak.top_c", "steak.bottom_c", "steak.mass_g"]
                .into_iter()
                .map(str::to_owned)
                .chain(FOOD_COLUMNS.map(|c| format!("{group}.{c}")))
                .collect::<Vec<_>>()[..]
        );
        assert!(rows.iter().all(|row| row.len() == 11), "{text}");
        let (first, last) = (&rows[1], &rows[rows.len() - 1]);
        assert!(first[3] == "5.000" && first[7].is_empty(), "{text}");
        assert!(last[3].is_empty() && last[7] == "5.000", "{text}");
        assert_eq!(last[0], "6.0");
    }
}
