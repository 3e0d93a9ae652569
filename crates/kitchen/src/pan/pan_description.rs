//! Pans and coatings as their files describe them.

use saute_food::sourced_table;
use serde::Deserialize;

use crate::pan::heat_tint::HeatTint;

sourced_table! {
    /// The flat floor.
    Floor {
        /// Radius [mm].
        radius_mm: f64,
        /// Thickness, of a pan with ridges that of the plate between them [mm].
        thickness_mm: f64,
    }
}

sourced_table! {
    /// Ridges of a grill pan, on the tops of which food lies.
    RidgesData {
        /// From the middle of one to that of the next [mm].
        pitch_mm: f64,
        /// Width of their tops [mm].
        width_mm: f64,
        /// Height of their tops above the plate between them [mm].
        height_mm: f64,
    }
}

sourced_table! {
    /// The flared wall.
    Wall {
        /// Radius at the rim [mm].
        rim_radius_mm: f64,
        /// Height of the rim above the floor, of a pan with ridges above their tops [mm].
        height_mm: f64,
        /// Thickness [mm].
        thickness_mm: f64,
    }
}

sourced_table! {
    /// The metal.
    Metal {
        /// Thermal conductivity along the floor [W/(m·K)].
        conductivity_w_mk: f64,
        /// Density [kg/m³].
        density_kg_m3: f64,
        /// Specific heat [J/(kg·K)].
        specific_heat_j_kgk: f64,
    }
}

sourced_table! {
    /// The cooking surface.
    PanSurface {
        /// Thermal emissivity [-].
        emissivity: f64,
    }
}

sourced_table! {
    /// What it looks like.
    Look {
        /// sRGB, 0–255.
        colour_srgb: [u8; 3],
        /// 0 dielectric – 1 metal.
        metalness: f64,
        /// Roughness [-].
        roughness: f64,
    }
}

/// A pan as its file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PanDescription {
    /// Name for people.
    pub name: String,
    /// Floor.
    pub floor: Floor,
    /// Ridges; absent where the floor is plain.
    pub ridges: Option<RidgesData>,
    /// Wall.
    pub wall: Wall,
    /// Metal.
    pub metal: Metal,
    /// Surface.
    pub surface: PanSurface,
    /// Look.
    pub look: Look,
    /// What heat does to its colour; absent where nothing is to be seen.
    pub heat_tint: Option<HeatTint>,
    /// Conductance of a coating [W/(m²·K)]; absent on bare metal.
    #[serde(skip)]
    pub coating_w_m2k: Option<f64>,
}

/// A coating that any pan can have.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoatingDescription {
    /// Name for people.
    pub name: String,
    /// Conductance [W/(m²·K)].
    pub conductance_w_m2k: f64,
    /// Emissivity [-].
    pub emissivity: f64,
    /// Where the numbers come from.
    pub source: String,
    /// How well they are known.
    pub confidence: saute_food::description::Confidence,
    /// Look.
    pub look: Look,
    /// What heat does to its colour; absent where nothing is to be seen.
    pub heat_tint: Option<HeatTint>,
}
