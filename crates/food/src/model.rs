//! What never changes in a piece of food: rest mesh, composition, tables.

use saute_heat::{CellMeshError, Located, Locator, MeshError, Outline, Path, Station, SweptMesh};

use crate::body::Body;
use crate::body::CellReadings;
use crate::body::halving::Halving;
use crate::body::patch::{Face, Patch};
use crate::body::surface::Surface;
use crate::change::browning::Browning;
use crate::change::changes::{ChangeRates, arrhenius};
use crate::change::colour::{Appearance, Palette};
use crate::components::{Components, Masses, Properties};
use crate::description::{FoodDescription, Kinetics, Lethality, MOST_CHANGES, NoSuchChange, PerChange, WaterHolding};
use crate::paper_2013::{BOILING, MeshSize, Rules, simplified};
use crate::state::FoodState;
use crate::table::Table;
use crate::tissue::marbling_volume::MarblingVolume;
use crate::tissue::node_means::node_means;
use crate::tissue::second_tissue::TissueField;
use crate::water::fat::FatRates;
use crate::water::sorption::Isotherm;
use crate::water::vapour::saturation_density;
use crate::{Lab, ZERO_C};

/// Samples of seams and of second tissues in each of the dozen pieces of a node's volume (chosen: seams are finer than nodes,
/// and a node's fat is right within 2 %; tissues change over many nodes).
const SEAM_SAMPLES: usize = 256;
const TISSUE_SAMPLES: usize = 4;

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
    /// A form that needs a table of its own.
    #[error("the form \"{form}\" needs a table [{table}]: see the shipped foods of that form")]
    Missing {
        /// Which form.
        form: &'static str,
        /// Which table.
        table: &'static str,
    },
    /// The mesh failed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The cells inside a surface failed.
    #[error(transparent)]
    Cells(#[from] CellMeshError),
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
    /// Which mesh.
    pub mesh: MeshSize,
    /// Rules that it follows.
    pub rules: Rules,
}

/// A piece of food, immutable after it is built.
#[derive(Clone, Debug)]
pub struct FoodModel {
    /// Rest mesh; of a slice z goes from 0 to the thickness, origin at the outline's centroid.
    pub mesh: SweptMesh,
    /// Finds points in the section.
    pub locator: Locator,
    /// Length, width, thickness; of a curved body along its curve, across it in its plane, and its height [m].
    pub size: [f64; 3],
    /// Outline seen from above.
    pub outline: Outline,
    /// Height of the slab of material that belongs to each level [m].
    pub layer_heights: Vec<f64>,
    /// Faces towards the outside: those of both ends of the path in the order of the section's nodes, then the side's.
    pub patches: Vec<Patch>,
    /// Triangles over the nodes of the surface.
    pub surface: Surface,
    /// Outward normal of each patch of the rest shape, in the body frame [-].
    pub rest_normals: Vec<[f64; 3]>,
    /// Nodes from which juice runs off, with their area [m²].
    pub(crate) outlets: Vec<(u32, f64)>,
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
    pub marbling: MarblingVolume,
    /// Share of the second tissue of each node [-].
    pub tissue: Vec<f64>,
    /// Where the second tissue lies.
    pub tissues: TissueField,
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
    /// Where the core is in the section, and how far along the path [m].
    core: (Located, f64),
    /// The cut that parts it, if there is one.
    pub(crate) halving: Option<Halving>,
    /// What a body of cells reads instead.
    pub(crate) cell_readings: CellReadings,
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
        let body = Body::cut(description, piece)?;
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
        check_composition("second", description.second_tissue().total())?;
        let simple = (rules == Rules::Paper2013).then(|| simplified(description, kinetics, components));
        let (description, kinetics) = simple.as_ref().map_or((description, kinetics), |(d, k)| (d, k));
        let Body { size, mesh, outline, patches, contracts } = body;
        let locator = Locator::new(&mesh.section);
        let closed_below = !patches.iter().any(|p| p.face == Face::Bottom && p.area > 0.0);
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
            palette: Palette::new(&description.colour, description.second_colour(), kinetics)?,
            cell_readings: {
                let fibres = description.mesh.as_ref().and_then(|m| m.fibres);
                mesh.cells().map(|cells| CellReadings::of(cells, fibres)).unwrap_or_default()
            },
            core: (locator.locate_or_nearest(&mesh.section, [0.0, 0.0]), core_height(&mesh, closed_below)),
            marbling: MarblingVolume::new(description.marbling.as_ref(), seed, &mesh),
            tissues: TissueField::new(description, size, seed),
            tissue: Vec::new(),
            halving: None,
            outlets: Vec::new(),
            rest_normals: Vec::new(),
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
            closed_below,
            layer_heights: mesh.layer_heights(),
            surface: Surface::of(&mesh, &patches),
            patches,
            mesh,
            locator,
        };
        model.fill();
        model.part_sheaths();
        model.outlets = model.juice_outlets();
        model.rest_normals = model.rest_poses().into_iter().map(|p| p.normal).collect();
        Ok(model)
    }

    /// Gives every node the masses that its volume of lean, second and adipose tissue holds at 20 °C.
    fn fill(&mut self) {
        let marbling = Some(&self.marbling).filter(|marbling| marbling.mean_share() > 0.0);
        let seams = node_means(&self.mesh, marbling, SEAM_SAMPLES);
        let tissues = Some(&self.tissues).filter(|tissues| !tissues.is_plain());
        let second = node_means(&self.mesh, tissues, TISSUE_SAMPLES);
        let (lean, other) = (&self.description.lean, self.description.second_tissue());
        let adipose = self.description.adipose.as_ref().unwrap_or(lean);
        for (node, (&s, &t)) in seams.iter().zip(&second).enumerate() {
            let mix = |l: f64, o: f64, a: f64| (1.0 - s) * (l + t * (o - l)) + s * a;
            let fractions = [
                mix(lean.water, other.water, adipose.water),
                mix(lean.lean_solids(), other.lean_solids(), adipose.lean_solids()),
                mix(lean.fat, other.fat, adipose.fat),
            ];
            let mass = self.mesh.graph.volume[node] / self.properties.volume(&fractions, ZERO_C + 20.0);
            self.initial_water.push(mass * fractions[0]);
            self.lean_solids.push(mass * fractions[1]);
            self.initial_fat.push(mass * fractions[2]);
        }
        (self.adipose, self.tissue) = (seams, second);
        let all = [&self.initial_water, &self.lean_solids, &self.initial_fat];
        self.raw_mass = all.iter().map(|m| m.iter().sum::<f64>()).sum();
    }

    /// Lowers the conductance of the edges that cross borders of sheaths, by the conductivity of the raw flesh.
    fn part_sheaths(&mut self) {
        let shares: Vec<f64> = (0..self.mesh.graph.ends.len()).map(|edge| self.sheath_share(edge)).collect();
        self.mesh.graph.shape.iter_mut().zip(shares).for_each(|(shape, share)| *shape *= share);
    }

    /// What borders of sheaths leave of an edge's conductance [-].
    pub(crate) fn sheath_share(&self, edge: usize) -> f64 {
        let lean = &self.description.lean;
        let k = self.properties.conductivity(&[lean.water, lean.lean_solids(), lean.fat], ZERO_C + 20.0);
        self.tissues.share_across(self.mesh.graph.ends[edge].map(|node| self.mesh.position(node as usize)), k)
    }

    /// Share of the second tissue (a root's core, a shaft's green) at a point of the rest mesh's frame [-].
    pub fn tissue_at(&self, p: [f64; 3]) -> f64 {
        self.tissues.at(p)
    }

    /// Water, lean solids and fat that a node holds now [kg].
    #[inline]
    pub fn masses(&self, state: &FoodState, node: usize) -> Masses {
        [state.water[node], self.lean_solids[node], state.fat[node]]
    }

    /// Value of a node field at the core: the rest shape's centroid, or the middle of its thickest section where the
    /// body is curved.
    pub fn at_core(&self, field: &[f64]) -> f64 {
        if self.cells().is_some() {
            return self.cell_readings.core.iter().map(|&(node, w)| w * field[node as usize]).sum();
        }
        self.interpolate(field, &self.core.0, self.core.1)
    }

    /// Value of a node field above or below the core: `share` runs from −1 at the lower face to 1 at the upper one, as
    /// the rest mesh stands.
    pub fn above_core(&self, field: &[f64], share: f64) -> f64 {
        if let Some(cells) = self.cells() {
            return cells.at(field, [0.0, 0.0, 0.5 * share * self.size[2]]);
        }
        if self.is_slice() {
            return self.interpolate(field, &self.core.0, 0.5 * (1.0 + share) * self.mesh.thickness());
        }
        let found = self.locator.locate_or_nearest(&self.mesh.section, [0.0, 0.5 * share * self.size[2]]);
        self.interpolate(field, &found, self.core.1)
    }

    /// Value of a node field at a point of the rest mesh's frame (of a slice the origin is the centroid of the bottom
    /// face), or none outside.
    pub fn at(&self, field: &[f64], p: [f64; 3]) -> Option<f64> {
        if let Some(cells) = self.cells() {
            return cells.contains(p).then(|| cells.at(field, p));
        }
        let (found, height) = self.place_of(p)?;
        Some(self.interpolate(field, &found, height))
    }

    /// Height of a slice's upper face above a point of its bottom face [m], or none outside.
    pub fn height_above(&self, p: [f64; 2]) -> Option<f64> {
        let found = self.locator.locate(&self.mesh.section, p)?;
        Some(self.mesh.thickness() * self.column_of(&found))
    }

    /// Height of the column through a point of the section over the mean one [-].
    fn column_of(&self, found: &Located) -> f64 {
        (0..3).map(|k| found.weights[k] * self.mesh.path.column(found.nodes[k] as usize)).sum()
    }

    /// Where a point of the rest mesh's frame lies in the section and along the path [m].
    fn place_of(&self, p: [f64; 3]) -> Option<(Located, f64)> {
        if let Path::Stations(stations) = &self.mesh.path {
            return place_among(&self.mesh, stations, p);
        }
        let found = self.locator.locate(&self.mesh.section, [p[0], p[1]])?;
        let height = p[2] / self.column_of(&found);
        (0.0..=self.mesh.thickness()).contains(&height).then_some((found, height))
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

/// How far along the path the core lies [m]: half way, or at the centre of a ball; on stations where it is deepest.
fn core_height(mesh: &SweptMesh, closed_below: bool) -> f64 {
    match &mesh.path {
        Path::Stations(stations) => {
            let depth = |level: usize| {
                let z = mesh.levels[level];
                let rim = stations[level].section.points.iter().map(|p| p[1]).fold(0.0, f64::max);
                rim.min(z).min(mesh.thickness() - z)
            };
            let deepest = (0..mesh.levels.len()).max_by(|a, b| depth(*a).total_cmp(&depth(*b))).unwrap_or(0);
            mesh.levels[deepest]
        }
        _ if closed_below => 0.0,
        _ => 0.5 * mesh.thickness(),
    }
}

/// Where a point lies between stations: in which triangle of the section, and how far along the path [m].
fn place_among(mesh: &SweptMesh, stations: &[Station], p: [f64; 3]) -> Option<(Located, f64)> {
    for (level, pair) in stations.windows(2).enumerate() {
        let (low, high) = (pair[0].coordinates(p), pair[1].coordinates(p));
        if low[2] < -1e-12 || high[2] > 1e-12 {
            continue;
        }
        let share = if low[2] > high[2] { low[2] / (low[2] - high[2]) } else { 0.0 };
        let point = [0, 1].map(|k| low[k] + share * (high[k] - low[k]));
        let node = |i: u32| {
            let [a, b] = [0, 1].map(|k| pair[k].section.points[i as usize]);
            [0, 1].map(|k| a[k] + share * (b[k] - a[k]))
        };
        let corners = mesh.section.triangles.iter().map(|t| Located::within(*t, t.map(node), point));
        if let Some(found) = corners.flatten().next() {
            return Some((found, mesh.levels[level] + share * (mesh.levels[level + 1] - mesh.levels[level])));
        }
    }
    None
}

fn check_size(description: &FoodDescription, piece: &PieceSpec) -> Result<(), BuildError> {
    let (form, range) = (description.form, &description.size);
    let bounds = [&range.min_mm, &range.max_mm].map(|mm| form.extent(mm).unwrap_or_default());
    for (axis, (&low, &high)) in bounds[0].iter().zip(&bounds[1]).enumerate() {
        let got = piece.size[axis] * 1e3;
        if !(got >= low - 1e-9 && got <= high + 1e-9) {
            return Err(BuildError::Size { which: form.dimension_of(axis), got, low, high });
        }
    }
    Ok(())
}

fn check_composition(which: &'static str, total: f64) -> Result<(), BuildError> {
    if (total - 1.0).abs() > 0.005 { Err(BuildError::Composition { which, total }) } else { Ok(()) }
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
