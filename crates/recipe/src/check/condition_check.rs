//! Checks a condition and converts it to SI units.

use toml::Spanned;

use crate::check::recipe_check::{Check, Checked, FoodNames};
use crate::condition::{Condition, Measured, Side};
use crate::file::recipe_file::{SideTable, WhenEntry};
use crate::file::shorthand::ShortOrTable;
use crate::recipe::Quantity;
use saute_kitchen::kelvin;

impl Check<'_> {
    /// Returns the condition of a key, `when` or `until`.
    pub(crate) fn condition(&self, key: &str, entry: &Spanned<WhenEntry>, names: &FoodNames) -> Checked<Condition> {
        let w = entry.get_ref();
        let of_food = [
            (Quantity::Core, &w.core_c),
            (Quantity::Top, &w.top_c),
            (Quantity::Bottom, &w.bottom_c),
            (Quantity::Mass, &w.mass_g),
        ];
        let given: Vec<_> = of_food.into_iter().filter_map(|(q, side)| Some((q, side.as_ref()?))).collect();
        let (measured, side) = match (&w.pan_c, &w.food, given.as_slice()) {
            (Some(side), None, []) => (Measured::Pan, side),
            (None, Some(food), [(quantity, side)]) => {
                let food = self.target(food, &format!("{key}.food"), names)?;
                (Measured::Food { food, quantity: *quantity }, *side)
            }
            _ => {
                let remedy = format!(
                    "write {key} = {{ pan_c = 180 }} or {key} = {{ food = \"steak\", core_c = 57 }} (also top_c, \
                     bottom_c, mass_g); {{ above = 57 }} and {{ below = 57 }} may stand for the number"
                );
                return self.input.error(entry.span().start, format!("{key} needs one condition"), remedy);
            }
        };
        self.on_a_side(measured, side)
    }

    fn on_a_side(&self, measured: Measured, entry: &ShortOrTable<SideTable>) -> Checked<Condition> {
        let key = measured.key();
        let (side, number) = match (entry.bare, entry.table.above, entry.table.below) {
            (true, Some(number), _) => (measured.plain_side(), number),
            (false, Some(number), None) => (Side::Above, number),
            (_, None, Some(number)) => (Side::Below, number),
            (_, above, _) => {
                let message = format!("{key} has {} above {} below", both(above).0, both(above).1);
                let remedy = format!("write {key} = {{ above = 50 }} or {key} = {{ below = 50 }}");
                return self.input.error(entry.at, message, remedy);
            }
        };
        let value = if key == "mass_g" { number * 1e-3 } else { kelvin(number) };
        Ok(Condition { measured, side, value, plain: entry.bare })
    }
}

/// Words for a table with both keys, or with neither.
fn both(above: Option<f64>) -> (&'static str, &'static str) {
    if above.is_some() { ("both", "and") } else { ("neither", "nor") }
}
