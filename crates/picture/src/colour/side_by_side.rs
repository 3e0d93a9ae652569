//! Maps of several foods in one table: each food is coloured by its own scale, and the renderer reads one table.

use std::sync::Arc;

use crate::colour::map::ColourMap;

/// Entries of a table [-].
const ENTRIES: usize = 256;

/// Returns the maps in one common table, each with an equal part of it. A single map stays as it is; of several, the
/// bounds of classes are within an entry of their part, which is 2 K for four scales of temperatures.
pub fn side_by_side(maps: Vec<ColourMap>) -> Vec<ColourMap> {
    if maps.len() < 2 {
        return maps;
    }
    let room = ENTRIES / maps.len();
    let (mut table, mut patterns) = ([[0; 3]; ENTRIES], [0; ENTRIES]);
    for (place, map) in maps.iter().enumerate() {
        for entry in 0..room {
            // To the nearest entry: the ends of the part are the ends of the map.
            let from = (2 * entry * (ENTRIES - 1) + room - 1) / (2 * (room - 1).max(1));
            table[place * room + entry] = map.table[from];
            patterns[place * room + entry] = map.patterns[from];
        }
    }
    let (table, patterns) = (Arc::new(table), Arc::new(patterns));
    let placed = |(place, map): (usize, ColourMap)| ColourMap {
        table: Arc::clone(&table),
        patterns: Arc::clone(&patterns),
        stepped: true,
        part: [place * room, room],
        ..map
    };
    maps.into_iter().enumerate().map(placed).collect()
}

#[cfg(test)]
mod tests {
    use saute_kitchen::Library;

    use super::*;
    use crate::colour::map::{TemperatureMap, doneness_map};

    #[test]
    fn every_food_keeps_the_colours_and_patterns_of_its_own_scale_in_a_common_table() {
        let library = Library::embedded().expect("embedded data");
        let scales = ["chefs", "shrimp", "vegetables"].map(|id| library.scale(id).expect("a scale"));
        let alone: Vec<ColourMap> = scales.iter().map(|s| doneness_map(s)).collect();
        let together = side_by_side(alone.clone());
        for ((scale, alone), together) in scales.iter().zip(&alone).zip(&together) {
            for place in 0..scale.class.len() {
                let middle = 0.5 * (scale.from(place) + scale.end(place).unwrap_or(100.0));
                assert_eq!(together.colour(middle), alone.colour(middle), "{} {place}", scale.id);
                assert_eq!(together.hatched(middle, 3.0, 4.0), alone.hatched(middle, 3.0, 4.0), "{} {place}", scale.id);
            }
        }
        assert!(together.windows(2).all(|w| Arc::ptr_eq(&w[0].table, &w[1].table)));
    }

    #[test]
    fn a_map_alone_stays_as_it_is() {
        let map = TemperatureMap::Uniform.map();
        assert_eq!(side_by_side(vec![map.clone()]), [map]);
    }
}
