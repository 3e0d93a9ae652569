//! Pans and coatings as their files describe them.

use saute_food::sourced_table;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::pan::heat_tint::HeatTint;

sourced_table! {
    /// The flat floor.
    Floor {
        /// Radius [mm].
        #[schemars(range(min = 40.0, max = 250.0), example = 100.0)]
        radius_mm: f64,
        /// Thickness, of a pan with ridges that of the plate between them [mm].
        #[schemars(range(min = 0.5, max = 20.0), example = 2.5)]
        thickness_mm: f64,
    }
}

sourced_table! {
    /// Ridges of a grill pan, on the tops of which food lies.
    RidgesData {
        /// From the middle of one to that of the next [mm].
        #[schemars(range(min = 2.0, max = 50.0), example = 12.0)]
        pitch_mm: f64,
        /// Width of their tops [mm].
        #[schemars(range(min = 0.5, max = 47.5), example = 5.0)]
        width_mm: f64,
        /// Height of their tops above the plate between them [mm].
        #[schemars(range(min = 0.5, max = 20.0), example = 5.0)]
        height_mm: f64,
    }
}

sourced_table! {
    /// The flared wall.
    Wall {
        /// Radius at the rim [mm].
        #[schemars(range(min = 40.0, max = 400.0), example = 130.0)]
        rim_radius_mm: f64,
        /// Height of the rim above the floor, of a pan with ridges above their tops [mm].
        #[schemars(range(min = 5.0, max = 300.0), example = 54.0)]
        height_mm: f64,
        /// Thickness [mm].
        #[schemars(range(min = 0.5, max = 20.0), example = 2.5)]
        thickness_mm: f64,
    }
}

sourced_table! {
    /// The metal.
    Metal {
        /// Thermal conductivity along the floor [W/(m·K)].
        #[schemars(range(min = 1.0, max = 500.0), example = 50.0)]
        conductivity_w_mk: f64,
        /// Density [kg/m³].
        #[schemars(range(min = 1000.0, max = 20_000.0), example = 7850.0)]
        density_kg_m3: f64,
        /// Specific heat [J/(kg·K)].
        #[schemars(range(min = 100.0, max = 2000.0), example = 490.0)]
        specific_heat_j_kgk: f64,
    }
}

sourced_table! {
    /// The cooking surface.
    PanSurface {
        /// Thermal emissivity [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.9)]
        emissivity: f64,
        /// Fat that a seasoned pan keeps on its floor when it is dry or wiped [g]; none by default.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 5.0), example = 0.3)]
        film_g: f64,
    }
}

sourced_table! {
    /// What it looks like.
    Look {
        /// sRGB, 0–255.
        #[schemars(extend("examples" = [[66, 65, 65]]))]
        colour_srgb: [u8; 3],
        /// 0 dielectric – 1 metal.
        #[schemars(range(min = 0.0, max = 1.0), example = 0.35)]
        metalness: f64,
        /// Roughness [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.6)]
        roughness: f64,
    }
}

/// A pan as its file describes it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute pan")]
pub struct PanDescription {
    /// Name for people.
    #[schemars(example = &"My pan")]
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

impl PanDescription {
    /// Length of the wall from the floor to the rim, along its slope [m].
    pub(crate) fn rise(&self) -> f64 {
        libm::hypot(self.wall.height_mm, self.wall.rim_radius_mm - self.floor.radius_mm) * 1e-3
    }

    /// Thickness of the metal that conducts along floor or wall [m].
    pub(crate) fn conducting(&self, is_floor: bool) -> f64 {
        1e-3 * if is_floor { self.floor.thickness_mm } else { self.wall.thickness_mm }
    }
}

/// A coating that any pan can have.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute coating")]
pub struct CoatingDescription {
    /// Name for people.
    #[schemars(example = &"my coating")]
    pub name: String,
    /// Conductance [W/(m²·K)].
    #[schemars(range(min = 10.0, max = 1e7), example = 8000.0)]
    pub conductance_w_m2k: f64,
    /// Emissivity [-].
    #[schemars(range(min = 0.0, max = 1.0), example = 0.9)]
    pub emissivity: f64,
    /// Where the numbers come from.
    #[schemars(example = &"chosen: …")]
    pub source: String,
    /// How well they are known.
    #[schemars(example = &"low")]
    pub confidence: saute_food::description::Confidence,
    /// Look.
    pub look: Look,
    /// What heat does to its colour; absent where nothing is to be seen.
    pub heat_tint: Option<HeatTint>,
}
