//! A gas burner: a ring of flame that heats floor and wall, and the grate on which the pan stands.

use core::f64::consts::PI;

use saute_food::sourced_table;

use crate::pan::heater::{Given, Meets};

sourced_table! {
    /// Flame of a gas burner.
    Flame {
        /// Largest power, by the gas that it burns [W].
        #[schemars(range(min = 100.0, max = 2e4), example = 3000.0)]
        largest_w: f64,
        /// Smallest flame that burns [W].
        #[schemars(range(min = 10.0, max = 2e4), example = 600.0)]
        lowest_w: f64,
        /// Settings on the dial [W].
        #[schemars(inner(range(min = 0.0, max = 2e4)), extend("examples" = [[0.0, 600.0, 1800.0, 3000.0]]))]
        settings_w: Vec<f64>,
        /// Share of the gas's heat into the floor of a cold pan that is wide enough for the whole flame [-].
        #[schemars(range(min = 0.0, max = 0.9), example = 0.42)]
        floor_share: f64,
        /// Share of it into a cold wall, along which the hot gas rises [-].
        #[schemars(range(min = 0.0, max = 0.5), example = 0.06)]
        wall_share: f64,
        /// Radius of the ring at which the flame heats most [mm].
        #[schemars(range(min = 10.0, max = 300.0), example = 45.0)]
        radius_mm: f64,
        /// Distance from it at which the flux has fallen to 1/e [mm].
        #[schemars(range(min = 2.0, max = 300.0), example = 45.0)]
        width_mm: f64,
        /// Way along the wall on which the heat from the gas falls to 1/e [mm].
        #[schemars(range(min = 2.0, max = 1000.0), example = 40.0)]
        wall_scale_mm: f64,
        /// Temperature of the gas along the pan [°C]: a hotter pan takes less heat from it.
        #[schemars(range(min = 400.0, max = 2000.0), example = 900.0)]
        plume_c: f64,
        /// Height above the grate at which the heat has fallen to 1/e [mm].
        #[schemars(range(min = 2.0, max = 1000.0), example = 60.0)]
        reach_mm: f64,
    }
}

sourced_table! {
    /// Grate on which a pan is over a flame.
    Grate {
        /// Mass [kg].
        #[schemars(range(min = 0.01, max = 20.0), example = 0.9)]
        mass_kg: f64,
        /// Specific heat [J/(kg·K)].
        #[schemars(range(min = 100.0, max = 2000.0), example = 460.0)]
        specific_heat_j_kgk: f64,
        /// Share of the gas's heat that it takes [-].
        #[schemars(range(min = 0.0, max = 0.3), example = 0.02)]
        flame_share: f64,
        /// Conductance to the pan that stands on it [W/K].
        #[schemars(range(min = 0.0, max = 50.0), example = 1.0)]
        contact_w_k: f64,
        /// Loss to the room [W/K].
        #[schemars(range(min = 0.0, max = 50.0), example = 0.8)]
        loss_w_k: f64,
    }
}

impl Flame {
    /// Share of the flame's heat to the floor at each node, as if the floor had no end [-].
    ///
    /// Flux q(r) ∝ exp(−((r − r₀)/s)²); its integral over the plane is 2π (s²/2 exp(−(r₀/s)²) + r₀ s √π/2 (1 + erf(r₀/s))):
    /// what misses a small floor is lost.
    pub(crate) fn shares(&self, points: &[[f64; 2]], areas: &[f64], at: [f64; 2]) -> Vec<f64> {
        let (radius, width) = (1e-3 * self.radius_mm, 1e-3 * self.width_mm);
        let ratio = radius / width;
        let ring = 0.5 * width * width * libm::exp(-ratio * ratio);
        let tail = 0.5 * radius * width * libm::sqrt(PI) * (1.0 + libm::erf(ratio));
        let whole = 2.0 * PI * (ring + tail);
        let flux = |p: &[f64; 2]| {
            let off = (libm::hypot(p[0] + at[0], p[1] + at[1]) - radius) / width;
            libm::exp(-off * off)
        };
        let shares: Vec<f64> = points.iter().zip(areas).map(|(p, a)| flux(p) * a / whole).collect();
        // A flame that is thinner than the nodes still gives no more than there is.
        let sum: f64 = shares.iter().sum();
        shares.into_iter().map(|share| share / sum.max(1.0)).collect()
    }

    /// Share of the heat that reaches a pan at a height [m] above the grate [-].
    pub(crate) fn coupling(&self, lift: f64) -> f64 {
        libm::exp(-lift / (1e-3 * self.reach_mm))
    }

    /// Shares of the heat to the wall at its nodes, which are `along` it [m]; they sum to 1, or to 0 without a wall [-].
    pub(crate) fn wall_shares(&self, along: impl Iterator<Item = f64> + Clone, areas: &[f64]) -> Vec<f64> {
        let scale = 1e-3 * self.wall_scale_mm;
        let weights: Vec<f64> = along.zip(areas).map(|(s, area)| libm::exp(-s / scale) * area).collect();
        let whole: f64 = weights.iter().sum();
        weights.into_iter().map(|w| if whole > 0.0 { w / whole } else { 0.0 }).collect()
    }

    /// Power that a dial set to `w` gives [W]: no flame burns between none and the smallest.
    pub(crate) fn nearest_w(&self, w: f64) -> f64 {
        if w < 0.5 * self.lowest_w { 0.0 } else { w.clamp(self.lowest_w, self.largest_w.max(self.lowest_w)) }
    }

    /// Largest conductance from gas and grate to a place of the pan [W/(m²·K)]; limits the stable step.
    pub(crate) fn steepest_w_m2k(&self, grate: &Grate) -> f64 {
        let ring = PI * 1e-6 * (self.radius_mm * self.radius_mm).max(self.width_mm * self.width_mm);
        let gas = self.largest_w * (self.floor_share + self.wall_share) / (self.plume_c - 100.0);
        (3.0 * gas + grate.contact_w_k) / ring
    }

    /// Gives the heat of a step to the floor, to the wall by its shares, and to the grate at `grate_k` [K]; adds what the
    /// metal takes to `heat` [J].
    ///
    /// q̇ = P · share · (T_gas − T)/(T_gas − T_room): a hot pan takes less, and above the gas's temperature it gives.
    pub(crate) fn burn(
        &self,
        grate: &Grate,
        grate_k: &mut f64,
        wall: &[f64],
        meets: &Meets,
        heat: &mut [f64],
    ) -> Given {
        let Meets { metal, shares, lift, power, room, dt, .. } = *meets;
        let gas = crate::kelvin(self.plume_c);
        let floor = shares.len();
        let taken = |t: f64| (gas - t) / (gas - room);
        let to_wall = self.wall_share * self.coupling(lift);
        let of_node = |i: usize| match i.checked_sub(floor) {
            None => self.floor_share * shares[i],
            Some(of_wall) => to_wall * wall.get(of_wall).copied().unwrap_or(0.0),
        };
        let mut to_pan = 0.0;
        for (i, (q, t)) in heat.iter_mut().zip(metal).enumerate() {
            let given = power * of_node(i) * taken(*t) * dt;
            *q += given;
            to_pan += given;
        }
        to_pan += grate.step(grate_k, meets, heat);
        Given { drawn: power * dt, to_pan }
    }
}

impl Grate {
    /// Warms the grate in a flame and lets it give heat to the pan on it; returns that heat [J].
    fn step(&self, grate_k: &mut f64, meets: &Meets, heat: &mut [f64]) -> f64 {
        let Meets { metal, areas, shares, lift, power, room, dt } = *meets;
        let floor: f64 = areas[..shares.len()].iter().sum();
        let stands = if lift > 0.0 { 0.0 } else { self.contact_w_k };
        let mean = metal.iter().zip(areas).take(shares.len()).map(|(t, a)| t * a).sum::<f64>() / floor;
        let stored = self.mass_kg * self.specific_heat_j_kgk / dt;
        let taken = stored * *grate_k + power * self.flame_share + stands * mean + self.loss_w_k * room;
        *grate_k = taken / (stored + stands + self.loss_w_k);
        for ((q, t), area) in heat.iter_mut().zip(metal).zip(areas).take(shares.len()) {
            *q += stands * area / floor * (*grate_k - t) * dt;
        }
        stands * (*grate_k - mean) * dt
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gas() -> (Flame, Grate) {
        let hob = crate::Library::embedded().expect("embedded data").hobs["gas"].clone();
        (hob.flame.expect("a flame"), hob.grate.expect("a grate"))
    }

    #[test]
    fn the_flux_sums_to_one_over_a_wide_floor_and_to_less_over_a_small_one() {
        let (flame, _) = gas();
        let rings = |radius: f64| -> f64 {
            let edge = |i: usize| radius * i as f64 / 400.0;
            let middle = |i: usize| [0.5 * (edge(i) + edge(i + 1)), 0.0];
            let area = |i: usize| PI * (edge(i + 1) * edge(i + 1) - edge(i) * edge(i));
            let points: Vec<[f64; 2]> = (0..400).map(middle).collect();
            let areas: Vec<f64> = (0..400).map(area).collect();
            flame.shares(&points, &areas, [0.0; 2]).iter().sum()
        };
        assert!((rings(0.5) - 1.0).abs() < 1e-3, "{}", rings(0.5));
        let [small, wide] = [rings(0.06), rings(0.11)];
        assert!(small < 0.75 && wide > 0.9 && wide > small, "{small} {wide}");
    }

    #[test]
    fn no_flame_is_smaller_than_the_smallest() {
        let (flame, _) = gas();
        let low = flame.lowest_w;
        assert_eq!(
            [0.0, 0.4 * low, 0.6 * low, low, 9e9].map(|w| flame.nearest_w(w)),
            [0.0, 0.0, low, low, flame.largest_w]
        );
    }

    #[test]
    fn a_pan_as_hot_as_the_gas_takes_no_heat_from_it() {
        let (flame, mut grate) = gas();
        grate.contact_w_k = 0.0;
        let at = |t: f64| {
            let (metal, areas) = ([crate::kelvin(t); 2], [0.03, 0.02]);
            let mut heat = [0.0; 2];
            let meets =
                Meets { metal: &metal, areas: &areas, shares: &[1.0], lift: 0.0, power: 1000.0, room: 293.15, dt: 1.0 };
            flame.burn(&grate, &mut 293.15, &[1.0], &meets, &mut heat).to_pan
        };
        assert!((at(20.0) - 1000.0 * (flame.floor_share + flame.wall_share)).abs() < 1e-9);
        assert!(at(flame.plume_c).abs() < 1e-9 && at(200.0) < 0.85 * at(20.0));
    }
}
