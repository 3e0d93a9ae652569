//! The keys of food files: what they mean and what to write.

/// A key of a food file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// Table that holds it; empty at the top.
    pub table: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Whether it must be there: always, or wherever its table is.
    pub required: bool,
    /// What it means.
    pub meaning: &'static str,
    /// A line that could stand there.
    pub example: &'static str,
}

const fn must(table: &'static str, name: &'static str, meaning: &'static str, example: &'static str) -> Key {
    Key { table, name, required: true, meaning, example }
}

const fn may(table: &'static str, name: &'static str, meaning: &'static str, example: &'static str) -> Key {
    Key { table, name, required: false, meaning, example }
}

/// The two keys that every table has.
const SOURCE: [(&str, &str, &str); 2] = [
    ("source", "where the numbers come from, or \"chosen\" and why", "source = \"chosen: …\""),
    ("confidence", "how well they are known: high, medium or low", "confidence = \"low\""),
];

/// Tables that every food has.
pub const REQUIRED_TABLES: [&str; 6] = ["lean", "fat_melting", "sorption", "crust", "surface", "colour"];

/// Tables that a food may have; `size` and `outline` belong to all forms but "mesh".
pub const OTHER_TABLES: [&str; 11] = [
    "size",
    "outline",
    "mesh",
    "spine",
    "core",
    "core.tissue",
    "sheaths",
    "sheaths.tissue",
    "adipose",
    "marbling",
    "anisotropy",
];

/// Keys of a composition.
const COMPOSITION: [(&str, &str, &str); 6] = [
    ("water", "mass fraction of water", "water = 0.75"),
    ("protein", "mass fraction of protein", "protein = 0.20"),
    ("fat", "mass fraction of fat", "fat = 0.03"),
    ("carbohydrate", "mass fraction of carbohydrate without fibre", "carbohydrate = 0.0"),
    ("fibre", "mass fraction of fibre", "fibre = 0.0"),
    ("ash", "mass fraction of minerals", "ash = 0.01"),
];

/// Tables that hold a composition.
const COMPOSED: [&str; 4] = ["lean", "adipose", "core.tissue", "sheaths.tissue"];

const KEYS: [Key; 49] = [
    must("", "name", "name for people", "name = \"My food\""),
    must("", "kinetics", "id of the kinetics file: what heat does to this kind of flesh", "kinetics = \"beef\""),
    must("", "form", "shape that is built", "form = \"steak\""),
    must(
        "size",
        "default_mm",
        "dimensions of the form unless a recipe tells others [mm]",
        "default_mm = [120.0, 80.0, 25.0]",
    ),
    must("size", "min_mm", "smallest dimensions [mm]", "min_mm = [30.0, 30.0, 10.0]"),
    must("size", "max_mm", "largest dimensions [mm]", "max_mm = [190.0, 190.0, 60.0]"),
    must("outline", "exponent", "roundness: 2 is an ellipse, 10 nearly a rectangle", "exponent = 2.5"),
    must("outline", "ripple", "amplitude of the natural waviness over the radius", "ripple = 0.02"),
    may("outline", "wedge", "how much the thickness may differ from end to end, over its mean", "wedge = 0.05"),
    may("outline", "bumps", "amplitude of the bumps of a cut over the mean thickness", "bumps = 0.01"),
    must(
        "mesh",
        "file",
        "closed surface, a path beside this file: .stl, .obj, .gltf or .glb",
        "file = \"my-piece.obj\"",
    ),
    may("mesh", "fibres", "direction of the fibres, along which juice moves", "fibres = [0.0, 0.0, 1.0]"),
    may("mesh", "scale_mm", "millimetres in one unit of that file", "scale_mm = 1.0"),
    must("spine", "turn_deg", "angle through which a shrimp turns from end to end [°]", "turn_deg = 125.0"),
    must("spine", "turn_varies_deg", "how much that differs between pieces [°]", "turn_varies_deg = 20.0"),
    must("spine", "flattening", "breadth over depth of the body", "flattening = 0.9"),
    must("core", "radius", "mean radius of a root's core over that of the piece", "radius = 0.5"),
    must("core", "wave", "waviness of its edge over its radius", "wave = 0.1"),
    must("core", "offset", "how far it may lie off the middle, over the half width", "offset = 0.1"),
    must("core", "edge_mm", "width of the passage between both tissues [mm]", "edge_mm = 0.5"),
    must("core", "colour", "raw colour of the core, L*, a*, b*", "colour = [64.0, 22.0, 46.0]"),
    must("sheaths", "thickness_mm", "mean thickness of a sheath [mm]", "thickness_mm = 2.2"),
    must("sheaths", "variation", "how much thicknesses differ over their mean", "variation = 0.3"),
    must(
        "sheaths",
        "conductance_w_m2k",
        "conductance of the border between two sheaths [W/(m²·K)]",
        "conductance_w_m2k = 700.0",
    ),
    must("sheaths", "greenest", "largest share of the green tissue", "greenest = 0.9"),
    must("sheaths", "colour", "raw colour of the green tissue, L*, a*, b*", "colour = [58.0, -20.0, 34.0]"),
    must("marbling", "adipose_share", "mean mass share of fat tissue", "adipose_share = 0.2"),
    must("marbling", "seam_mm", "typical distance between seams of fat [mm]", "seam_mm = 9.0"),
    must("marbling", "flattening", "how much longer than thick the seams are", "flattening = 3.0"),
    must("fat_melting", "middle_c", "half of the fat is liquid here [°C]", "middle_c = 38.0"),
    must("fat_melting", "width_k", "width of that transition [K]", "width_k = 5.0"),
    must("fat_melting", "latent_j_kg", "latent heat of melting [J/kg]", "latent_j_kg = 100.0e3"),
    must("sorption", "monolayer", "moisture of the first layer of water [kg/kg dry]", "monolayer = 0.08"),
    must("sorption", "c", "GAB constant C", "c = 12.0"),
    must("sorption", "k", "GAB constant K", "k = 0.96"),
    must("sorption", "fresh_activity", "water activity of the fresh food", "fresh_activity = 0.99"),
    must("crust", "conductivity_w_mk", "thermal conductivity of a dry crust [W/(m·K)]", "conductivity_w_mk = 0.12"),
    must("anisotropy", "across", "conductivity across the fibres over that of the composition", "across = 0.9"),
    must("surface", "emissivity", "thermal emissivity", "emissivity = 0.95"),
    must("surface", "contact_share", "share of the lower face that comes near to the pan", "contact_share = 1.0"),
    must("colour", "raw", "raw flesh, L*, a*, b*", "raw = [37.0, 24.0, 12.0]"),
    must(
        "colour",
        "change",
        "what each complete change of the kinetics adds",
        "change = { myosin = [14.0, -9.0, 3.5] }",
    ),
    must("colour", "golden", "golden stage of browning", "golden = [45.0, 13.0, 24.0]"),
    must("colour", "golden_at", "browning at which it is reached", "golden_at = 0.4"),
    must("colour", "crust", "fully browned", "crust = [31.0, 5.0, 6.0]"),
    must("colour", "char", "charred", "char = [14.0, 1.0, 1.0]"),
    must("colour", "fat_raw", "raw fat", "fat_raw = [76.0, 4.0, 11.0]"),
    must("colour", "fat_cooked", "molten, cooked fat", "fat_cooked = [62.0, 5.0, 22.0]"),
    must("colour", "fat_brown", "browned fat", "fat_brown = [48.0, 12.0, 32.0]"),
];

/// What each table is for.
const TABLES: [(&str, &str); 17] = [
    ("mesh", "the closed surface that is meshed inside"),
    ("spine", "curve of a shrimp"),
    ("lean", "what the flesh consists of, mass fractions that add up to 1"),
    ("adipose", "what fat tissue consists of, mass fractions that add up to 1"),
    ("marbling", "seams of fat tissue"),
    ("fat_melting", "melting of the fat"),
    ("sorption", "how tightly the last water is held"),
    ("crust", "the dry crust"),
    ("anisotropy", "conduction that differs with direction"),
    ("surface", "properties of the surface"),
    ("colour", "colours and their changes, L*, a*, b* under D65"),
    ("size", "sizes that a piece may have"),
    ("outline", "outline of slices seen from above, of sticks and shrimps across"),
    ("core", "core of a root"),
    ("core.tissue", "what the core consists of, mass fractions that add up to 1"),
    ("sheaths", "sheaths of a shaft"),
    ("sheaths.tissue", "what the green tissue consists of, mass fractions that add up to 1"),
];

/// The keys of a table; none where there is no such table.
pub fn keys_of(table: &str) -> Vec<Key> {
    let find = |name: &str| REQUIRED_TABLES.into_iter().chain(OTHER_TABLES).find(|t| *t == name);
    let Some(table) = (if table.is_empty() { Some("") } else { find(table) }) else { return Vec::new() };
    let mut keys: Vec<Key> = KEYS.into_iter().filter(|k| k.table == table).collect();
    if COMPOSED.contains(&table) {
        keys.extend(COMPOSITION.map(|(name, meaning, example)| must(table, name, meaning, example)));
    }
    if !table.is_empty() {
        keys.extend(SOURCE.map(|(name, meaning, example)| must(table, name, meaning, example)));
    }
    keys
}

/// What a table is for.
pub fn meaning_of(table: &str) -> &'static str {
    TABLES.iter().find(|t| t.0 == table).map_or("", |t| t.1)
}
