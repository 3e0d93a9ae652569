//! The tables of a lab case for bodies, materials and the pan.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::case::one_or_more::OneOrMore;
use crate::case::ranges::{
    AMBIENT_C, CONDUCTIVITY_W_MK, CONTACT_W_M2K, DEFAULT_BOILING_C, DEFAULT_LATENT_J_KG, DENSITY_KG_M3, GRADING,
    H_W_M2K, INITIAL_C, LATENT_J_KG, Q_W_M2, RESOLUTION_MM, SIZE_MM, SPECIFIC_HEAT_J_KGK, THICKNESS_MM, WATER_KG_M3,
};

/// Shape of a body.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Shape {
    /// `size_mm` = [x, y, z]; the origin is a corner.
    Box,
    /// `size_mm` = [diameter, height]; the origin is the centre of the bottom.
    Cylinder,
    /// `size_mm` = [diameter]; the origin is the centre.
    Sphere,
    /// `size_mm` = [thickness]; infinite across; the origin is on the bottom.
    Slab,
}

/// A body.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyEntry {
    /// Shape.
    pub shape: Shape,
    /// Sizes, in the order that the shape lists [mm].
    #[schemars(with = "Vec<f64>", inner(range(min = SIZE_MM[0], max = SIZE_MM[1])))]
    pub size_mm: Spanned<Vec<f64>>,
    /// Largest node spacing [mm], or one for each axis in the order of `size_mm`. A single number applies to the longest
    /// axis; the spacing of a shorter axis is scaled by the square root of the ratio of sizes, to half at most. At most
    /// half the size. The mesh is finer towards the faces.
    #[schemars(with = "Option<OneOrMore<f64>>", extend("minimum" = RESOLUTION_MM[0], "maximum" = RESOLUTION_MM[1]))]
    pub resolution_mm: Option<Spanned<OneOrMore<f64>>>,
    /// Steepness β of the mesh grading [-]: 0 gives a uniform mesh; at 1 (the default, 1.5 for cooking) the spacing at a
    /// face is 0.42 of the largest, at 2 a fourteenth.
    #[schemars(with = "Option<f64>", range(min = GRADING[0], max = GRADING[1]))]
    pub grading: Option<Spanned<f64>>,
    /// Start temperature [°C].
    #[schemars(with = "f64", range(min = INITIAL_C[0], max = INITIAL_C[1]))]
    pub initial_c: Spanned<f64>,
    /// Thermal contact conductance to the body or pan below [W/(m²·K)]; perfect contact by default.
    #[schemars(with = "Option<f64>", range(min = CONTACT_W_M2K[0], max = CONTACT_W_M2K[1]))]
    pub contact_h_w_m2k: Option<Spanned<f64>>,
}

/// A plate of uniform temperature (lumped capacity) under the lowest body, heated uniformly from below; it has the
/// footprint of the body.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PanEntry {
    /// Id of a pan, for the thickness of its floor and the properties of its metal.
    #[schemars(with = "Option<String>")]
    pub kind: Option<Spanned<String>>,
    /// Thickness [mm].
    #[schemars(with = "Option<f64>", range(min = THICKNESS_MM[0], max = THICKNESS_MM[1]))]
    pub thickness_mm: Option<Spanned<f64>>,
    /// Thermal conductivity [W/(m·K)]; unused, because the plate has a uniform temperature.
    #[schemars(with = "Option<f64>", range(min = CONDUCTIVITY_W_MK[0], max = CONDUCTIVITY_W_MK[1]))]
    pub conductivity_w_mk: Option<Spanned<f64>>,
    /// Density [kg/m³].
    #[schemars(with = "Option<f64>", range(min = DENSITY_KG_M3[0], max = DENSITY_KG_M3[1]))]
    pub density_kg_m3: Option<Spanned<f64>>,
    /// Specific heat [J/(kg·K)].
    #[schemars(with = "Option<f64>", range(min = SPECIFIC_HEAT_J_KGK[0], max = SPECIFIC_HEAT_J_KGK[1]))]
    pub specific_heat_j_kgk: Option<Spanned<f64>>,
    /// Heat flux into its underside [W/m²]; none by default.
    #[schemars(with = "Option<f64>", range(min = Q_W_M2[0], max = Q_W_M2[1]))]
    pub q_w_m2: Option<Spanned<f64>>,
    /// Heat transfer coefficient of its underside [W/(m²·K)]; none by default.
    #[schemars(with = "Option<f64>", range(min = H_W_M2K[0], max = H_W_M2K[1]))]
    pub h_w_m2k: Option<Spanned<f64>>,
    /// Temperature below it [°C]; its start temperature by default.
    #[schemars(with = "Option<f64>", range(min = AMBIENT_C[0], max = AMBIENT_C[1]))]
    pub ambient_c: Option<Spanned<f64>>,
    /// Start temperature [°C].
    #[schemars(with = "f64", range(min = INITIAL_C[0], max = INITIAL_C[1]))]
    pub initial_c: Spanned<f64>,
}

/// A material: three constant properties, with or without water that boils, or a food.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialEntry {
    /// Thermal conductivity [W/(m·K)].
    #[schemars(with = "Option<f64>", range(min = CONDUCTIVITY_W_MK[0], max = CONDUCTIVITY_W_MK[1]))]
    pub conductivity_w_mk: Option<Spanned<f64>>,
    /// Density [kg/m³].
    #[schemars(with = "Option<f64>", range(min = DENSITY_KG_M3[0], max = DENSITY_KG_M3[1]))]
    pub density_kg_m3: Option<Spanned<f64>>,
    /// Specific heat [J/(kg·K)].
    #[schemars(with = "Option<f64>", range(min = SPECIFIC_HEAT_J_KGK[0], max = SPECIFIC_HEAT_J_KGK[1]))]
    pub specific_heat_j_kgk: Option<Spanned<f64>>,
    /// Id of a food. The properties are those of its raw lean tissue at the node's temperature.
    #[schemars(with = "Option<String>")]
    pub food: Option<Spanned<String>>,
    /// Water that can evaporate [kg/m³]. A node stays at `boiling_c` until its water has evaporated.
    #[schemars(with = "Option<f64>", range(min = WATER_KG_M3[0], max = WATER_KG_M3[1]))]
    pub water_kg_m3: Option<Spanned<f64>>,
    /// Boiling point [°C].
    #[schemars(with = "Option<f64>", range(min = INITIAL_C[0], max = INITIAL_C[1]), extend("default" = DEFAULT_BOILING_C))]
    pub boiling_c: Option<Spanned<f64>>,
    /// Latent heat of evaporation [J/kg].
    #[schemars(with = "Option<f64>", range(min = LATENT_J_KG[0], max = LATENT_J_KG[1]), extend("default" = DEFAULT_LATENT_J_KG))]
    pub latent_j_kg: Option<Spanned<f64>>,
    /// Thermal conductivity of the dry material [W/(m·K)]; `conductivity_w_mk` by default. The heat capacity does not change.
    #[schemars(with = "Option<f64>", range(min = CONDUCTIVITY_W_MK[0], max = CONDUCTIVITY_W_MK[1]))]
    pub crust_conductivity_w_mk: Option<Spanned<f64>>,
    /// Supply of water.
    pub juice: Option<Juice>,
}

/// Supply of water.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Juice {
    /// Evaporated water is not replaced.
    Limited,
    /// Evaporated water is replaced: a node never dries.
    Unlimited,
}
