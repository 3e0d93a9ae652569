//! Ranges of the numbers in data files: what parses must also be possible.

use saute_food::description::{Composition, MOST_CHANGES};
use saute_food::doneness::MOST_CLASSES;
use saute_food::{FoodDescription, Form, Kinetics, Scale};
use toml::Spanned;

use crate::data::library::{DEFAULT_SCALE, LibraryError, line_of};
use crate::liquids::fond::FondData;
use crate::liquids::oil::{OilDescription, SolidsChange};
use crate::pan::heat_tint::HeatTint;
use crate::pan::pan_description::{CoatingDescription, PanDescription};

/// A number with its place in the file and the range in which it makes sense.
struct Ranged {
    table: &'static str,
    key: &'static str,
    value: f64,
    low: f64,
    high: f64,
}

const fn ranged(table: &'static str, key: &'static str, value: f64, low: f64, high: f64) -> Ranged {
    Ranged { table, key, value, low, high }
}

/// Checks a pan's numbers.
pub fn pan(pan: &PanDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    let rim_low = pan.floor.radius_mm;
    check(
        file,
        text,
        &[
            ranged("floor", "radius_mm", pan.floor.radius_mm, 40.0, 250.0),
            ranged("floor", "thickness_mm", pan.floor.thickness_mm, 0.5, 20.0),
            ranged("wall", "rim_radius_mm", pan.wall.rim_radius_mm, rim_low, 400.0),
            ranged("wall", "height_mm", pan.wall.height_mm, 5.0, 300.0),
            ranged("wall", "thickness_mm", pan.wall.thickness_mm, 0.5, 20.0),
            ranged("metal", "conductivity_w_mk", pan.metal.conductivity_w_mk, 1.0, 500.0),
            ranged("metal", "density_kg_m3", pan.metal.density_kg_m3, 1000.0, 20_000.0),
            ranged("metal", "specific_heat_j_kgk", pan.metal.specific_heat_j_kgk, 100.0, 2000.0),
            ranged("surface", "emissivity", pan.surface.emissivity, 0.0, 1.0),
            ranged("look", "metalness", pan.look.metalness, 0.0, 1.0),
            ranged("look", "roughness", pan.look.roughness, 0.0, 1.0),
        ],
    )?;
    heat_tint(pan.heat_tint.as_ref(), file, text)?;
    let Some(ridges) = &pan.ridges else { return Ok(()) };
    check(
        file,
        text,
        &[
            ranged("ridges", "pitch_mm", ridges.pitch_mm, 2.0, 50.0),
            ranged("ridges", "width_mm", ridges.width_mm, 0.5, 0.95 * ridges.pitch_mm),
            ranged("ridges", "height_mm", ridges.height_mm, 0.5, 20.0),
        ],
    )
}

/// Checks a coating's numbers.
pub fn coating(coating: &CoatingDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    check(
        file,
        text,
        &[
            ranged("", "conductance_w_m2k", coating.conductance_w_m2k, 10.0, 1e7),
            ranged("", "emissivity", coating.emissivity, 0.0, 1.0),
        ],
    )?;
    heat_tint(coating.heat_tint.as_ref(), file, text)
}

/// Checks what heat does to a colour.
fn heat_tint(tint: Option<&HeatTint>, file: &str, text: &str) -> Result<(), LibraryError> {
    let Some((key, remedy)) = tint.and_then(HeatTint::fault) else { return Ok(()) };
    let line = line_of(text, place(text, "heat_tint", key));
    Err(LibraryError { file: file.to_owned(), line, message: format!("{key} makes no heat tint: {remedy}") })
}

/// Checks the numbers of a kind of oil.
pub fn oil(oil: &OilDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    let (fluid, heat) = (&oil.fluid, &oil.heat);
    check(
        file,
        text,
        &[
            ranged("fluid", "density_kg_m3", fluid.density_kg_m3, 700.0, 1100.0),
            ranged("fluid", "density_per_k", fluid.density_per_k, -1.0, 0.0),
            ranged("fluid", "specific_heat_j_kgk", fluid.specific_heat_j_kgk, 1000.0, 4000.0),
            ranged("heat", "smoke_c", heat.smoke_c, 80.0, 400.0),
            ranged("heat", "flash_c", heat.flash_c, heat.smoke_c, 500.0),
            ranged("heat", "fire_c", heat.fire_c, heat.flash_c, 600.0),
        ],
    )?;
    let (xs, ys) = (&fluid.viscosity_c, &fluid.viscosity_mpa_s);
    if xs.len() < 2 || xs.len() != ys.len() || !xs.is_sorted() || !ys.iter().all(|v| (0.01..1e6).contains(v)) {
        let line = line_of(text, place(text, "fluid", "viscosity_c"));
        let message = "viscosity_c needs two or more ascending temperatures, and as many values of viscosity_mpa_s";
        return Err(LibraryError { file: file.to_owned(), line, message: message.to_owned() });
    }
    let Some(emulsion) = &oil.emulsion else { return Ok(()) };
    check(
        file,
        text,
        &[
            ranged("emulsion", "water", emulsion.water, 0.0, 0.6),
            ranged("emulsion", "solids", emulsion.solids, 0.0, 0.3),
            ranged("emulsion", "melting_c", emulsion.melting_c, 0.0, 80.0),
            ranged("emulsion", "latent_j_kg", emulsion.latent_j_kg, 1e3, 3e5),
            ranged("emulsion", "conductance_w_m2k", emulsion.conductance_w_m2k, 1.0, 1e4),
            ranged("emulsion", "lump_mm", emulsion.lump_mm, 1.0, 100.0),
        ],
    )?;
    solids(&[("emulsion.browning", &emulsion.browning), ("emulsion.charring", &emulsion.charring)], file, text)
}

/// Checks how solids brown and char.
fn solids(changes: &[(&'static str, &SolidsChange)], file: &str, text: &str) -> Result<(), LibraryError> {
    changes.iter().try_for_each(|(table, change)| {
        let energy = ranged(table, "activation_energy_kj_mol", change.activation_energy_kj_mol, 1.0, 1000.0);
        let anchor = ranged(table, "anchor_c", change.anchor_c, 0.0, 400.0);
        check(file, text, &[energy, anchor, ranged(table, "anchor_rate_per_s", change.anchor_rate_per_s, 1e-9, 10.0)])
    })
}

/// Checks the numbers of fond.
pub fn fond(fond: &FondData, file: &str, text: &str) -> Result<(), LibraryError> {
    let dissolving = &fond.dissolving;
    check(
        file,
        text,
        &[
            ranged("juice", "solids", fond.juice.solids, 0.0, 0.5),
            ranged("juice", "sticking", fond.juice.sticking, 0.0, 1.0),
            ranged("cover", "full_kg_m2", fond.cover.full_kg_m2, 1e-5, 10.0),
            ranged("dissolving", "activation_energy_kj_mol", dissolving.activation_energy_kj_mol, 1.0, 1000.0),
            ranged("dissolving", "anchor_c", dissolving.anchor_c, 0.0, 150.0),
            ranged("dissolving", "anchor_rate_per_s", dissolving.anchor_rate_per_s, 0.0, 100.0),
            ranged("dissolving", "saturation", dissolving.saturation, 1e-3, 10.0),
        ],
    )?;
    solids(&[("browning", &fond.browning), ("charring", &fond.charring)], file, text)
}

/// Checks a food's numbers.
pub fn food(food: &FoodDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    check(
        file,
        text,
        &[
            ranged("outline", "exponent", food.outline.exponent, 2.0, 20.0),
            ranged("outline", "ripple", food.outline.ripple, 0.0, 0.1),
            ranged("outline", "wedge", food.outline.wedge, 0.0, 0.3),
            ranged("outline", "bumps", food.outline.bumps, 0.0, 0.1),
            ranged("fat_melting", "width_k", food.fat_melting.width_k, 0.5, 50.0),
            ranged("fat_melting", "latent_j_kg", food.fat_melting.latent_j_kg, 0.0, 4e5),
            ranged("sorption", "monolayer", food.sorption.monolayer, 0.01, 0.3),
            ranged("sorption", "c", food.sorption.c, 1.1, 100.0),
            ranged("sorption", "k", food.sorption.k, 0.5, 1.0),
            ranged("sorption", "fresh_activity", food.sorption.fresh_activity, 0.8, 1.0),
            ranged("crust", "conductivity_w_mk", food.crust.conductivity_w_mk, 0.01, 1.0),
            ranged("surface", "emissivity", food.surface.emissivity, 0.0, 1.0),
        ],
    )?;
    if let Some(marbling) = &food.marbling {
        let share = ranged("marbling", "adipose_share", marbling.adipose_share, 0.0, 0.6);
        let seam = ranged("marbling", "seam_mm", marbling.seam_mm, 1.0, 50.0);
        check(file, text, &[share, seam, ranged("marbling", "flattening", marbling.flattening, 1.0, 20.0)])?;
    }
    if let Some(anisotropy) = &food.anisotropy {
        check(file, text, &[ranged("anisotropy", "across", anisotropy.across, 0.05, 5.0)])?;
    }
    shape(food, file, text)?;
    tissues(food, file, text)?;
    colours(food, file, text)?;
    sizes(food, file, text)?;
    composition("lean", &food.lean, file, text)?;
    food.adipose.iter().try_for_each(|adipose| composition("adipose", adipose, file, text))
}

/// Sizes and outline belong to all forms but surfaces of the user's, which have a table of their own.
fn shape(food: &FoodDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    let error = |table: &str, message: &str| {
        let line = line_of(text, place(text, "", table));
        Err(LibraryError { file: file.to_owned(), line, message: message.to_owned() })
    };
    if food.form != Form::Mesh {
        return match (&food.mesh, food.size.is_set(), food.outline.is_set()) {
            (Some(_), ..) => {
                error("[mesh]", "[mesh] belongs to form = \"mesh\": leave it out, or write form = \"mesh\"")
            }
            (_, false, _) => error("form", "a table [size] is missing: write default_mm, min_mm and max_mm"),
            (.., false) => error("form", "a table [outline] is missing: write exponent and ripple"),
            _ => Ok(()),
        };
    }
    let Some(mesh) = &food.mesh else {
        return error("form", "form = \"mesh\" needs a table [mesh]: write file = \"my-piece.obj\"");
    };
    if food.outline.is_set() {
        return error("[outline]", "[outline] does not go with form = \"mesh\": leave it out");
    }
    if mesh.fibres.is_some_and(|f| f.iter().all(|v| *v == 0.0) || f.iter().any(|v| !v.is_finite())) {
        let line = line_of(text, place(text, "mesh", "fibres"));
        let message = "fibres has no direction: write [x, y, z], for instance [0.0, 0.0, 1.0]".to_owned();
        return Err(LibraryError { file: file.to_owned(), line, message });
    }
    mesh.scale_mm.map_or(Ok(()), |scale| check(file, text, &[ranged("mesh", "scale_mm", scale, 1e-6, 1e6)]))
}

/// L* from 0 to 100, a* and b* from −128 to 127.
fn colours(food: &FoodDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    let c = &food.colour;
    let mut all = vec![
        ("colour", "raw", c.raw),
        ("colour", "golden", c.golden),
        ("colour", "crust", c.crust),
        ("colour", "char", c.char),
        ("colour", "fat_raw", c.fat_raw),
        ("colour", "fat_cooked", c.fat_cooked),
        ("colour", "fat_brown", c.fat_brown),
    ];
    all.extend(food.core.iter().map(|core| ("core", "colour", core.colour)));
    all.extend(food.sheaths.iter().map(|sheaths| ("sheaths", "colour", sheaths.colour)));
    for (table, key, lab) in all {
        if !(0.0..=100.0).contains(&lab[0]) || lab[1..].iter().any(|v| !(-128.0..=127.0).contains(v)) {
            let line = line_of(text, place(text, table, key));
            let message = format!("{key} = {lab:?} is no colour: use L* 0 to 100, a* and b* -128 to 127");
            return Err(LibraryError { file: file.to_owned(), line, message });
        }
    }
    check(file, text, &[ranged("colour", "golden_at", c.golden_at, 0.01, 0.99)])
}

/// Tables that belong to some forms alone.
fn tissues(food: &FoodDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    let error = |table: &str, message: String| {
        Err(LibraryError { file: file.to_owned(), line: line_of(text, place(text, table, "")), message })
    };
    let is_shrimp = food.form == Form::Shrimp;
    match &food.spine {
        Some(spine) if is_shrimp => check(
            file,
            text,
            &[
                ranged("spine", "turn_deg", spine.turn_deg, 0.0, 200.0),
                ranged("spine", "turn_varies_deg", spine.turn_varies_deg, 0.0, 60.0),
                ranged("spine", "flattening", spine.flattening, 0.5, 1.5),
            ],
        )?,
        Some(_) => return error("spine", "[spine] belongs to form = \"shrimp\": leave it out".into()),
        None if is_shrimp => {
            let message = "form = \"shrimp\" needs a table [spine] with turn_deg, turn_varies_deg and flattening";
            return error("", message.into());
        }
        None => {}
    }
    if food.core.is_some() && food.sheaths.is_some() {
        return error("sheaths", "[core] and [sheaths] exclude each other: keep one of them".into());
    }
    let table = if food.core.is_some() { "core" } else { "sheaths" };
    if (food.core.is_some() || food.sheaths.is_some()) && !food.form.may_hold_tissues() {
        return error(table, format!("[{table}] cannot lie in form = \"shrimp\": leave it out"));
    }
    if let Some(core) = &food.core {
        let shape = [
            ranged("core", "radius", core.radius, 0.05, 1.5),
            ranged("core", "wave", core.wave, 0.0, 0.5),
            ranged("core", "offset", core.offset, 0.0, 1.5),
            ranged("core", "edge_mm", core.edge_mm, 0.05, 10.0),
        ];
        check(file, text, &shape)?;
        core.tissue.iter().try_for_each(|t| composition("core.tissue", t, file, text))?;
    }
    if let Some(sheaths) = &food.sheaths {
        let shape = [
            ranged("sheaths", "thickness_mm", sheaths.thickness_mm, 0.5, 20.0),
            ranged("sheaths", "variation", sheaths.variation, 0.0, 0.8),
            ranged("sheaths", "conductance_w_m2k", sheaths.conductance_w_m2k, 10.0, 1e6),
            ranged("sheaths", "greenest", sheaths.greenest, 0.0, 1.0),
        ];
        check(file, text, &shape)?;
        sheaths.tissue.iter().try_for_each(|t| composition("sheaths.tissue", t, file, text))?;
    }
    Ok(())
}

/// As many sizes as the form has dimensions, ascending from smallest to largest.
fn sizes(food: &FoodDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    if food.form == Form::Mesh && !food.size.is_set() {
        return Ok(());
    }
    let names = food.form.dimensions();
    let range = &food.size;
    let mut low = vec![2.0; names.len()];
    for (key, size) in [("min_mm", &range.min_mm), ("default_mm", &range.default_mm), ("max_mm", &range.max_mm)] {
        if size.len() != names.len() {
            let message = format!("{key} needs the {} of this form: write {key} = [{}]", names.len(), names.join(", "));
            return Err(LibraryError { file: file.to_owned(), line: line_of(text, place(text, "size", key)), message });
        }
        (0..names.len())
            .try_for_each(|axis| check(file, text, &[ranged("size", key, size[axis], low[axis], 300.0)]))?;
        low.clone_from(size);
    }
    Ok(())
}

/// Checks the numbers of a kinetics file.
pub fn kinetics(kinetics: &Kinetics, file: &str, text: &str) -> Result<(), LibraryError> {
    if kinetics.change.is_empty() || kinetics.change.len() > MOST_CHANGES {
        let message = format!("give 1 to {MOST_CHANGES} [[change]] tables");
        return Err(LibraryError { file: file.to_owned(), line: 1, message });
    }
    for change in &kinetics.change {
        check(
            file,
            text,
            &[
                ranged("[change]", "activation_energy_kj_mol", change.activation_energy_kj_mol, 1.0, 1000.0),
                ranged("[change]", "anchor_c", change.anchor_c, 0.0, 200.0),
                ranged("[change]", "anchor_rate_per_min", change.anchor_rate_per_min, 1e-6, 1e4),
            ],
        )?;
    }
    let (holding, release) = (&kinetics.water_holding, &kinetics.fat_release);
    check(
        file,
        text,
        &[
            ranged("water_holding", "drop", holding.drop, 0.0, 0.9),
            ranged("water_holding", "spread", holding.spread, 1e-3, 1e6),
            ranged("water_holding", "slope_per_k", holding.slope_per_k, 0.0, 5.0),
            ranged("water_holding", "release_per_s", holding.release_per_s, 0.0, 1.0),
            ranged("water_holding", "release_anchor_c", holding.release_anchor_c, 0.0, 150.0),
            ranged(
                "water_holding",
                "release_activation_energy_kj_mol",
                holding.release_activation_energy_kj_mol,
                0.0,
                500.0,
            ),
            ranged("shrinkage", "least_volume", kinetics.shrinkage.least_volume, 0.05, 1.0),
            ranged("water_holding", "juice_speed_um_s", holding.juice_speed_um_s, 0.0, 1e4),
            ranged("water_holding", "film_kg_m2", holding.film_kg_m2, 0.0, 2.0),
            ranged("fat_release", "fine_share", release.fine_share, 0.0, 1.0),
            ranged("fat_release", "seam_share", release.seam_share, 0.0, 1.0),
            ranged("fat_release", "depth_mm", release.depth_mm, 0.1, 1000.0),
            ranged("lethality", "d60_min", kinetics.lethality.d60_min, 1e-3, 1e4),
            ranged("lethality", "z_k", kinetics.lethality.z_k, 1.0, 30.0),
            ranged("texture", "raw_kpa", kinetics.texture.raw_kpa, 0.1, 1e5),
            ranged("texture", "relaxed_share", kinetics.texture.relaxed_share, 0.01, 1.0),
        ],
    )?;
    let curves = [
        ("fat_release", "celsius", &release.celsius, &release.rate_per_s),
        ("browning", "activity", &kinetics.browning.activity, &kinetics.browning.factor),
    ];
    for (table, key, xs, ys) in curves {
        if xs.len() < 2 || xs.len() != ys.len() || !xs.is_sorted() {
            let message =
                format!("[{table}] {key} needs two or more ascending numbers, and as many values beside them");
            return Err(LibraryError { file: file.to_owned(), line: line_of(text, place(text, table, key)), message });
        }
    }
    contraction(kinetics, file, text)
}

/// Neither direction may contract by half, and every table may name only what changes.
fn contraction(kinetics: &Kinetics, file: &str, text: &str) -> Result<(), LibraryError> {
    let place_of = |key| line_of(text, place(text, "shrinkage", key));
    for (key, table) in [("across", &kinetics.shrinkage.across), ("along", &kinetics.shrinkage.along)] {
        if !(0.0..=0.5).contains(&table.values().sum::<f64>()) {
            let message = format!("[shrinkage] {key} adds up to more than 0.5 or less than 0");
            return Err(LibraryError { file: file.to_owned(), line: place_of(key), message });
        }
    }
    let named = [
        ("shrinkage", &kinetics.shrinkage.across),
        ("shrinkage", &kinetics.shrinkage.along),
        ("water_holding", &kinetics.water_holding.change),
        ("texture", &kinetics.texture.change_kpa),
        ("hardness", &kinetics.hardness.change),
        ("juiciness", &kinetics.juiciness.change),
    ];
    let curl = kinetics.curl.iter().map(|c| ("curl", &c.change));
    for (table, values) in named.into_iter().chain(curl) {
        kinetics.in_order(table, values).map_err(|e| LibraryError {
            file: file.to_owned(),
            line: line_of(text, place(text, table, "change")),
            message: e.to_string(),
        })?;
    }
    Ok(())
}

/// Classes of [`DEFAULT_SCALE`]: the summary's `section_pct` has these keys.
const DEFAULT_CLASSES: [&str; 4] = ["raw", "rare", "medium", "well-done"];

/// Checks the scales of doneness.
pub fn doneness(scales: &[Spanned<Scale>], file: &str, text: &str) -> Result<(), LibraryError> {
    let error = |offset: usize, message: String| {
        Err(LibraryError { file: file.to_owned(), line: line_of(text, offset), message })
    };
    for (i, spanned) in scales.iter().enumerate() {
        let (scale, start) = (spanned.get_ref(), spanned.span().start);
        if let Err((key, message)) = scale_sound(scale) {
            return error(key_after(text, start, key), message);
        }
        if scales[..i].iter().any(|s| s.get_ref().id == scale.id) {
            return error(
                key_after(text, start, "id"),
                format!("there is another scale \"{}\": use another id", scale.id),
            );
        }
    }
    if scales.iter().any(|s| s.get_ref().id == DEFAULT_SCALE) {
        return Ok(());
    }
    error(
        0,
        format!(
            "there is no scale \"{DEFAULT_SCALE}\", which every summary reports: keep it and add your own beside it"
        ),
    )
}

/// Whether a scale can be used; else the key that is wrong and what to write instead.
fn scale_sound(scale: &Scale) -> Result<(), (&'static str, String)> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if scale.id.is_empty() || !scale.id.chars().all(plain) {
        return Err(("id", format!("id = \"{}\" cannot be used: write letters, digits, - and _", scale.id)));
    }
    if scale.name.trim().is_empty() {
        return Err(("name", "name is empty: write the label that people read".into()));
    }
    classes_sound(scale).map_err(|message| ("class", message))
}

/// Whether the classes of a scale can be used; else what to write instead.
fn classes_sound(scale: &Scale) -> Result<(), String> {
    let (classes, count) = (&scale.class, scale.class.len());
    let repeated = |i: usize| classes[..i].iter().any(|c| c.name == classes[i].name);
    if !(2..=MOST_CLASSES).contains(&count) {
        return Err(format!("class has {count} entries: use 2 to {MOST_CLASSES}"));
    }
    if !classes.iter().all(|c| (0.0..=120.0).contains(&c.from_c)) {
        return Err("from_c is out of range: use 0 to 120".into());
    }
    if !classes.windows(2).all(|w| w[0].from_c < w[1].from_c) {
        return Err("from_c does not ascend: list the classes from the coldest to the hottest".into());
    }
    if let Some(i) = (0..count).find(|&i| classes[i].name.trim().is_empty() || repeated(i)) {
        return Err(format!("class name \"{}\" is empty or repeated: name each class", classes[i].name));
    }
    if scale.id == DEFAULT_SCALE && !classes.iter().map(|c| c.name.as_str()).eq(DEFAULT_CLASSES) {
        let names = DEFAULT_CLASSES.join(", ");
        return Err(format!("\"{DEFAULT_SCALE}\" has the classes {names}: give other ones an id of their own"));
    }
    Ok(())
}

/// Where a key stands at the beginning of a line, looked for from an offset on; that offset if nowhere.
fn key_after(text: &str, start: usize, key: &str) -> usize {
    let mut at = start;
    for line in text[start..].split_inclusive('\n') {
        if line.trim_start().strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('=')) {
            return at;
        }
        at += line.len();
    }
    start
}

fn composition(table: &'static str, tissue: &Composition, file: &str, text: &str) -> Result<(), LibraryError> {
    check(
        file,
        text,
        &[
            ranged(table, "water", tissue.water, 0.01, 0.99),
            ranged(table, "protein", tissue.protein, 0.001, 0.99),
            ranged(table, "fat", tissue.fat, 0.0, 0.99),
            ranged(table, "carbohydrate", tissue.carbohydrate, 0.0, 0.99),
            ranged(table, "fibre", tissue.fibre, 0.0, 0.99),
            ranged(table, "ash", tissue.ash, 0.0, 0.2),
        ],
    )?;
    let total = tissue.total();
    if (total - 1.0).abs() <= 0.005 {
        return Ok(());
    }
    let message = format!("the mass fractions of [{table}] add up to {total:.4}; they must add up to 1 (± 0.005)");
    Err(LibraryError { file: file.to_owned(), line: line_of(text, place(text, table, "water")), message })
}

fn check(file: &str, text: &str, numbers: &[Ranged]) -> Result<(), LibraryError> {
    let Some(wrong) = numbers.iter().find(|n| !(n.low..=n.high).contains(&n.value)) else { return Ok(()) };
    let Ranged { table, key, value, low, high } = wrong;
    let line = line_of(text, place(text, table, key));
    Err(LibraryError {
        file: file.to_owned(),
        line,
        message: format!("{key} = {value} is out of range: use {low} to {high}"),
    })
}

/// Where a key of a table stands in a file, or its start.
pub(crate) fn place(text: &str, table: &str, key: &str) -> usize {
    let start = if table.is_empty() { 0 } else { text.find(&format!("[{table}]")).unwrap_or(0) };
    let found = text[start..].match_indices(key).find(|(at, _)| text[..start + at].ends_with('\n') || start + at == 0);
    start + found.map_or(0, |(at, _)| at)
}
