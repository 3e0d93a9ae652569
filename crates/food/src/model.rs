//! What never changes in a piece of food: rest mesh, composition, tables.

use saute_heat::{Located, Locator, MeshError, Outline, Rule, Section, SweptMesh, graded_levels};

use crate::browning::Browning;
use crate::changes::{ChangeRates, arrhenius};
use crate::colour::{Appearance, Palette};
use crate::components::{Components, Masses, Properties};
use crate::description::{
    FoodDescription, Form, Kinetics, Lethality, MOST_CHANGES, NoSuchChange, PerChange, WaterHolding,
};
use crate::fat::FatRates;
use crate::marbling::MarblingField;
use crate::noise::uniform;
use crate::paper_2013::{BOILING, Rules, simplified};
use crate::patch::{Face, Patch, patches};
use crate::sorption::Isotherm;
use crate::state::FoodState;
use crate::table::Table;
use crate::water::saturation_density;
use crate::{Lab, ZERO_C};

/// Why a piece could not be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildError {
    /// A size out of range.
    #[error("{which} {got} mm is out of range: use {low} to {high} mm")]
    Size {
        /// Which dimension.
        which: &'static str,
        /// What was asked for [mm].
        got: f64,
        /// Smallest allowed [mm].
        low: f64,
        /// Largest allowed [mm].
        high: f64,
    },
    /// Mass fractions that do not add up.
    #[error("the mass fractions of the {which} tissue add up to {total:.4}; they must add up to 1 (± 0.005)")]
    Composition {
        /// Which tissue.
        which: &'static str,
        /// Their sum [-].
        total: f64,
    },
    /// The mesh failed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A table names a change that the kinetics lack.
    #[error(transparent)]
    Change(#[from] NoSuchChange),
}

/// One piece to be cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceSpec {
    /// Length, width, thickness [m].
    pub size: [f64; 3],
    /// Seed of its natural variation.
    pub seed: u64,
    /// Mesh spacing over the default [-]; 1 by default, 2 has about an eighth of the nodes.
    pub coarseness: f64,
    /// Rules that it follows.
    pub rules: Rules,
}

/// In-plane spacing of the default mesh [m] (chosen: the gradient length √(αt) is 9 mm after 10 minutes).
const SPACING: f64 = 5.0e-3;
/// First layer below a big face [m] (chosen: a crust is 0.5–1.5 mm thick).
const FIRST_LAYER: f64 = 0.35e-3;
/// Growth of the layers inwards [-] and the thickest layer [m] (chosen; convergence is tested).
const LAYER_GROWTH: f64 = 1.38;
const THICKEST_LAYER: f64 = 2.2e-3;

/// A body to be filled with food: its mesh, how it meets the outside, and its outline seen from above.
#[derive(Clone, Debug)]
pub struct Body {
    /// Length, width, thickness [m].
    pub size: [f64; 3],
    /// Rest mesh.
    pub mesh: SweptMesh,
    /// Outline of the section.
    pub outline: Outline,
    /// Faces towards the outside.
    pub patches: Vec<Patch>,
    /// Whether it contracts and bends as a plate.
    pub contracts: bool,
}

/// A piece of food, immutable after it is built.
#[derive(Clone, Debug)]
pub struct FoodModel {
    /// Rest mesh; z from 0 to the thickness, origin at the outline's centroid.
    pub mesh: SweptMesh,
    /// Finds points in the section.
    pub locator: Locator,
    /// Length, width, thickness [m].
    pub size: [f64; 3],
    /// Outline of the section.
    pub outline: Outline,
    /// Height of the slab of material that belongs to each level [m].
    pub layer_heights: Vec<f64>,
    /// Faces towards the outside: the bottom's and the top's in the order of the section's nodes, then the side's.
    pub patches: Vec<Patch>,
    /// Thermal properties of water, lean solids and fat.
    pub properties: Properties,
    /// Raw water of each node [kg].
    pub initial_water: Vec<f64>,
    /// Lean solids of each node [kg].
    pub lean_solids: Vec<f64>,
    /// Raw fat of each node [kg].
    pub initial_fat: Vec<f64>,
    /// Raw mass [kg].
    pub raw_mass: f64,
    /// Raw share of adipose tissue of each node [-].
    pub adipose: Vec<f64>,
    /// Where the fat seams run.
    pub marbling: MarblingField,
    /// Sorption isotherm.
    pub isotherm: Isotherm,
    /// Density of saturated vapour against temperature [kg/m³].
    pub vapour: Table,
    /// Rates of the first-order changes.
    pub changes: ChangeRates,
    /// Release of molten fat.
    pub fat_rates: FatRates,
    /// Rates of browning.
    pub browning: Browning,
    /// Share of the raw water that is still held against temperature [-].
    pub held: Table,
    /// Rate at which what is no longer held becomes free against temperature [1/s].
    pub release: Table,
    /// Log₁₀ reduction of pathogens against temperature [1/s].
    pub lethality: Table,
    /// Share of the raw water that each complete change squeezes out at least [-].
    pub squeeze: PerChange,
    /// What each change adds to the elastic modulus [kPa].
    pub modulus: PerChange,
    /// What each change adds to the hardness index [-].
    pub hardness: PerChange,
    /// What each change adds to the juiciness factor [-].
    pub juiciness: PerChange,
    /// Contraction across and along the fibres of each complete change [-].
    pub contraction: [PerChange; 2],
    /// Difference of contraction between belly and back of each complete change [-].
    pub curl: PerChange,
    /// Colours of flesh and fat.
    pub palette: Palette,
    /// Rules that the piece follows.
    pub rules: Rules,
    /// Whether it contracts and bends as a plate.
    pub contracts: bool,
    /// Whether the lower end of the path is no face, as the centre of a ball is not.
    pub closed_below: bool,
    /// What the food's file says.
    pub description: FoodDescription,
    /// What the kinetics file says.
    pub kinetics: Kinetics,
    core: Located,
}

impl FoodModel {
    /// Cuts and meshes a piece.
    pub fn build(
        description: &FoodDescription,
        kinetics: &Kinetics,
        components: &Components,
        piece: &PieceSpec,
    ) -> Result<Self, BuildError> {
        check_size(description, piece)?;
        let outline = outline(description, piece);
        let mesh = mesh(&outline, piece)?;
        let body = Body { size: piece.size, patches: patches(&mesh), mesh, outline, contracts: true };
        Self::fill_body(description, kinetics, components, body, piece.seed, piece.rules)
    }

    /// Fills a body with food.
    pub fn fill_body(
        description: &FoodDescription,
        kinetics: &Kinetics,
        components: &Components,
        body: Body,
        seed: u64,
        rules: Rules,
    ) -> Result<Self, BuildError> {
        check_composition("lean", description.lean.total())?;
        description.adipose.iter().try_for_each(|a| check_composition("adipose", a.total()))?;
        let simple = (rules == Rules::Paper2013).then(|| simplified(description, kinetics, components));
        let (description, kinetics) = simple.as_ref().map_or((description, kinetics), |(d, k)| (d, k));
        let Body { size, mesh, outline, patches, contracts } = body;
        let locator = Locator::new(&mesh.section);
        let holding = kinetics.water_holding.clone();
        let shrinkage = &kinetics.shrinkage;
        let mut model = Self {
            properties: Properties::new(components, &description.lean, &description.fat_melting),
            isotherm: match rules {
                Rules::Full => Isotherm::new(&description.sorption),
                Rules::Paper2013 => Isotherm::free_water(BOILING),
            },
            rules,
            vapour: Table::new(250.0, 380.0, 0.5, saturation_density),
            changes: ChangeRates::new(kinetics),
            fat_rates: FatRates::new(&kinetics.fat_release, &description.fat_melting, &mesh),
            browning: Browning::new(&kinetics.browning, &kinetics.charring),
            held: Table::new(ZERO_C, ZERO_C + 120.0, 0.5, |t| held_share(&holding, t - ZERO_C)),
            release: release(&kinetics.water_holding),
            lethality: lethality(&kinetics.lethality),
            squeeze: kinetics.in_order("water_holding", &kinetics.water_holding.change)?,
            modulus: kinetics.in_order("texture", &kinetics.texture.change_kpa)?,
            hardness: kinetics.in_order("hardness", &kinetics.hardness.change)?,
            juiciness: kinetics.in_order("juiciness", &kinetics.juiciness.change)?,
            contraction: [
                kinetics.in_order("shrinkage", &shrinkage.across)?,
                kinetics.in_order("shrinkage", &shrinkage.along)?,
            ],
            curl: kinetics.curl.as_ref().map_or(Ok([0.0; MOST_CHANGES]), |c| kinetics.in_order("curl", &c.change))?,
            palette: Palette::new(&description.colour, kinetics)?,
            core: locator.locate_or_nearest(&mesh.section, [0.0, 0.0]),
            marbling: MarblingField::new(description.marbling.as_ref(), seed),
            description: description.clone(),
            kinetics: kinetics.clone(),
            initial_water: Vec::new(),
            lean_solids: Vec::new(),
            initial_fat: Vec::new(),
            raw_mass: 0.0,
            adipose: Vec::new(),
            size,
            outline,
            contracts: contracts && rules == Rules::Full,
            closed_below: !patches.iter().any(|p| p.face == Face::Bottom && p.area > 0.0),
            layer_heights: mesh.layer_heights(),
            patches,
            mesh,
            locator,
        };
        model.fill();
        Ok(model)
    }

    /// Gives every node the masses that its volume of lean and adipose tissue holds at 20 °C.
    fn fill(&mut self) {
        let seams = node_shares(&self.mesh, &self.marbling);
        let lean = &self.description.lean;
        let adipose = self.description.adipose.as_ref().unwrap_or(lean);
        for (node, &s) in seams.iter().enumerate() {
            let mix = |l: f64, a: f64| (1.0 - s) * l + s * a;
            let fractions = [
                mix(lean.water, adipose.water),
                mix(lean.lean_solids(), adipose.lean_solids()),
                mix(lean.fat, adipose.fat),
            ];
            let mass = self.mesh.graph.volume[node] / self.properties.volume(&fractions, ZERO_C + 20.0);
            self.initial_water.push(mass * fractions[0]);
            self.lean_solids.push(mass * fractions[1]);
            self.initial_fat.push(mass * fractions[2]);
        }
        self.adipose = seams;
        let all = [&self.initial_water, &self.lean_solids, &self.initial_fat];
        self.raw_mass = all.iter().map(|m| m.iter().sum::<f64>()).sum();
    }

    /// Water, lean solids and fat that a node holds now [kg].
    #[inline]
    pub fn masses(&self, state: &FoodState, node: usize) -> Masses {
        [state.water[node], self.lean_solids[node], state.fat[node]]
    }

    /// Value of a node field at the rest shape's centroid.
    pub fn at_core(&self, field: &[f64]) -> f64 {
        let height = if self.closed_below { 0.0 } else { 0.5 * self.mesh.thickness() };
        self.interpolate(field, &self.core, height)
    }

    /// Value of a node field at a point of the rest frame (origin: centroid of the bottom face), or none outside.
    pub fn at(&self, field: &[f64], p: [f64; 3]) -> Option<f64> {
        let found = self.locator.locate(&self.mesh.section, [p[0], p[1]])?;
        (0.0..=self.mesh.thickness()).contains(&p[2]).then(|| self.interpolate(field, &found, p[2]))
    }

    fn interpolate(&self, field: &[f64], found: &Located, z: f64) -> f64 {
        let (level, share) = self.mesh.bracket(z);
        let on = |l: usize| -> f64 {
            (0..3).map(|k| found.weights[k] * field[self.mesh.node(l, found.nodes[k] as usize)]).sum()
        };
        on(level) * (1.0 - share) + on(level + 1) * share
    }

    /// Colour of lean flesh and of fat in a given appearance.
    pub fn colours(&self, appearance: Appearance) -> (Lab, Lab) {
        (self.palette.lean(appearance), self.palette.fat(appearance))
    }
}

fn check_size(description: &FoodDescription, piece: &PieceSpec) -> Result<(), BuildError> {
    let range = &description.size;
    let bounds = [&range.min_mm, &range.max_mm].map(|mm| description.form.extent(mm).unwrap_or_default());
    let names = if description.form == Form::Disc {
        ["diameter", "diameter", "thickness"]
    } else {
        ["length", "width", "thickness"]
    };
    for (axis, which) in names.into_iter().enumerate() {
        let got = piece.size[axis] * 1e3;
        let (low, high) = (bounds[0][axis], bounds[1][axis]);
        if !(got >= low - 1e-9 && got <= high + 1e-9) {
            return Err(BuildError::Size { which, got, low, high });
        }
    }
    Ok(())
}

fn check_composition(which: &'static str, total: f64) -> Result<(), BuildError> {
    if (total - 1.0).abs() > 0.005 { Err(BuildError::Composition { which, total }) } else { Ok(()) }
}

/// The outline with its seeded natural waviness in harmonics 2 to 5.
fn outline(description: &FoodDescription, piece: &PieceSpec) -> Outline {
    let harmonics: Vec<_> = (2..=5u32)
        .map(|m| {
            let amplitude =
                description.outline.ripple * (0.4 + 0.6 * uniform(piece.seed, u64::from(m))) / f64::from(m - 1);
            (m, amplitude, core::f64::consts::TAU * uniform(piece.seed, 100 + u64::from(m)))
        })
        .collect();
    Outline::superellipse(piece.size[0], piece.size[1], description.outline.exponent, &harmonics)
}

fn mesh(outline: &Outline, piece: &PieceSpec) -> Result<SweptMesh, MeshError> {
    let smallest = piece.size[0].min(piece.size[1]);
    let spacing = (SPACING * piece.coarseness).min(smallest / 8.0);
    let section = Section::mesh(outline, spacing, 0.38 * spacing)?;
    let levels =
        graded_levels(piece.size[2], FIRST_LAYER * piece.coarseness, LAYER_GROWTH, THICKEST_LAYER * piece.coarseness);
    let rule = if piece.rules == Rules::Paper2013 { Rule::Segments } else { Rule::ShapeFunctions };
    Ok(SweptMesh::with_rule(section, levels, rule))
}

/// Rate 10^((T − 60)/z) / D₆₀, tabulated from 40 to 100 °C and held beyond (below nothing dies, above all is dead).
fn lethality(data: &Lethality) -> Table {
    let per_second = 1.0 / (60.0 * data.d60_min);
    let z = data.z_k;
    Table::new(ZERO_C + 40.0, ZERO_C + 100.0, 0.25, |t| per_second * libm::pow(10.0, (t - ZERO_C - 60.0) / z))
}

/// Rate of release, tabulated from 0 to 110 °C and held beyond.
fn release(holding: &WaterHolding) -> Table {
    let rate = arrhenius(holding.release_activation_energy_kj_mol, holding.release_anchor_c, holding.release_per_s);
    Table::new(ZERO_C, ZERO_C + 110.0, 0.5, rate)
}

fn held_share(holding: &WaterHolding, celsius: f64) -> f64 {
    1.0 - holding.drop / (1.0 + holding.spread * libm::exp(-holding.slope_per_k * (celsius - holding.middle_c)))
}

/// Mean of the marbling field over each node's volume, from 3 × 3 × 3 samples of its box [-].
fn node_shares(mesh: &SweptMesh, marbling: &MarblingField) -> Vec<f64> {
    if marbling.mean_share() <= 0.0 {
        return vec![0.0; mesh.node_count()];
    }
    let heights = mesh.layer_heights();
    let mut shares = Vec::with_capacity(mesh.node_count());
    for (level, height) in heights.iter().enumerate() {
        for (i, &[x, y]) in mesh.section.points.iter().enumerate() {
            let half = 0.5 * libm::sqrt(mesh.section.areas[i]);
            let mut sum = 0.0;
            for k in 0..27 {
                let offset = |v: i32| f64::from(v - 1) * 2.0 / 3.0;
                let p = [
                    x + half * offset(k % 3),
                    y + half * offset(k / 3 % 3),
                    mesh.levels[level] + 0.5 * height * offset(k / 9),
                ];
                sum += marbling.at(p);
            }
            shares.push(sum / 27.0);
        }
    }
    shares
}
