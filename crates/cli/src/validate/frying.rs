//! Charts of docs/frying.md: contact, heat taken, weight loss and colour of the model next to measurements.

use saute_kitchen::food::Lab;
use saute_kitchen::food::change::inside_of_beef::INSIDE_OF_BEEF;
use saute_kitchen::{Kitchen, Library, Piece, celsius};
use saute_lab::Case;
use saute_recipe::{Cook, Recipe, Summary};

use super::{CaseRun, timed};
use crate::chart::curve_chart::{Curve, CurveChart};
use crate::error::CliError;
use crate::workers::map_all;

/// Foods whose heat is shown.
const FOODS: [&str; 5] = ["beef-lean", "beef-patty", "shrimp", "carrot-coin", "leek-ring"];
/// Temperatures of the pan at the put [°C].
const PANS_C: [f64; 9] = [140.0, 160.0, 180.0, 200.0, 220.0, 240.0, 260.0, 280.0, 300.0];
/// Core temperatures to which steaks are cooked [°C].
const CORES_C: [f64; 9] = [48.0, 51.0, 54.0, 57.0, 60.0, 63.0, 66.0, 69.0, 72.0];
/// Core temperatures [°C] of the cases whose bands of weight loss are shown.
const LOSSES_C: [u32; 4] = [54, 60, 66, 71];
/// Returns the charts by name.
pub fn charts(library: &Library, runs: &[CaseRun]) -> Result<Vec<(String, String)>, CliError> {
    let named = |name: &str, svg: String| (format!("frying-{name}"), svg);
    Ok(vec![
        named("contact", contact(library)?),
        named("heat", heat(library)?),
        named("loss", loss(library, runs)?),
        named("colour", colour(library)?),
    ])
}

fn solid(name: String, colour: usize, series: Vec<[f64; 2]>) -> Curve {
    Curve { name, series, dashed: false, colour }
}

/// Contact conductance under beef over time, for several pans.
fn contact(library: &Library) -> Result<String, CliError> {
    let mut curves = Vec::new();
    for (colour, pan) in [180, 220, 260, 320].into_iter().enumerate() {
        let text = format!(
            "name = \"contact\"\nsource = \"this chart\"\nduration_s = 180\n[body]\nshape = \"slab\"\nsize_mm = [12]\n\
             initial_c = 5\n[material]\nfood = \"beef-lean\"\n[solver]\nphysics = \"cooking\"\n[[boundary]]\nface = \"all\"\n\
             contact = \"pan\"\nambient_c = {pan}\n"
        );
        let report = timed(&Case::parse(&text, "contact.toml", library)?);
        curves.push(solid(format!("pan at {pan} °C"), colour, report.contact_w_m2k));
    }
    let ranges = vec![[15.0, 250.0, 650.0], [130.0, 300.0, 500.0]];
    let title = "Contact of oiled beef with a pan over time";
    Ok(CurveChart { title, axes: ["time [s]", "W/(m²·K)"], from: 0.0, curves, rings: Vec::new(), ranges }.svg())
}

/// Heat that foods take in their first 90 s, against the pan's temperature at the put.
fn heat(library: &Library) -> Result<String, CliError> {
    let pairs: Vec<(usize, f64)> = (0..FOODS.len()).flat_map(|food| PANS_C.map(|pan| (food, pan))).collect();
    let taken = map_all(&pairs, |_, (food, pan)| heat_per_area(library, FOODS[*food], *pan));
    let taken = taken.into_iter().collect::<Result<Vec<f64>, _>>()?;
    let course = |food: usize| PANS_C.into_iter().zip(&taken[food * PANS_C.len()..]).map(|(pan, heat)| [pan, *heat]);
    let curves = FOODS.iter().enumerate().map(|(i, name)| solid((*name).to_owned(), i, course(i).collect())).collect();
    let (title, axes) = ("Heat taken in the first 90 s", ["pan when the food is put in [°C]", "kJ/m² of footprint"]);
    Ok(CurveChart { title, axes, from: 140.0, curves, rings: Vec::new(), ranges: Vec::new() }.svg())
}

/// Returns the heat over the area of the footprint [kJ/m²].
fn heat_per_area(library: &Library, kind: &str, pan_c: f64) -> Result<f64, CliError> {
    let text = format!(
        "[pan]\nkind = \"cast-iron-26\"\ninitial_c = {pan_c}\n[[food]]\nid = \"food\"\nkind = \"{kind}\"\n[[step]]\nhob_w = 1000\n\
         [[step]]\nput = \"food\"\n[[step]]\nafter_s = 90\nend = true\n"
    );
    let mut footprint = 0.0;
    let summary = cooked(library, &text, |kitchen| {
        let [length, width, _] = kitchen.pieces()[0].model.size();
        footprint = length * width;
    })?;
    Ok(1e-3 * summary.foods[0].heat_j / footprint)
}

/// Weight loss of a steak that is turned each minute, against its highest core temperature.
fn loss(library: &Library, runs: &[CaseRun]) -> Result<String, CliError> {
    let ends = map_all(&CORES_C, |_, core| losses(library, *core)).into_iter().collect::<Result<Vec<_>, _>>()?;
    let curves = vec![
        solid("when it leaves the pan".into(), 0, ends.iter().map(|e| e[0]).collect()),
        solid("after 5 minutes on the board".into(), 1, ends.iter().map(|e| e[1]).collect()),
    ];
    let (title, axes) =
        ("Weight loss of a steak of 25 mm", ["highest core temperature so far [°C]", "% of the raw mass"]);
    let ranges = LOSSES_C.iter().filter_map(|core| band(runs, *core)).collect();
    Ok(CurveChart { title, axes, from: 45.0, curves, rings: Vec::new(), ranges }.svg())
}

/// Returns the band of the case of a core temperature: core [°C], lowest and highest loss [%].
fn band(runs: &[CaseRun], core_c: u32) -> Option<[f64; 3]> {
    let run = runs.iter().find(|run| run.id == format!("weight-loss-{core_c}-c"))?;
    let loss = run.verdicts.iter().find(|v| v.unit == "%")?;
    Some([f64::from(core_c), loss.expected - loss.tolerance, loss.expected + loss.tolerance])
}

/// Returns core [°C] and loss [%] at the end of the frying and of the rest.
fn losses(library: &Library, core_c: f64) -> Result<[[f64; 2]; 2], CliError> {
    let text = format!(
        "[pan]\nkind = \"cast-iron-26\"\ninitial_c = 180\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [80, 60, 25]\n\
         initial_c = 5\n[[step]]\nhob_w = {{ hold_c = 180, w = 2000 }}\n[[step]]\nput = \"steak\"\n[[step]]\n\
         repeat = {{ flip = \"steak\", every_s = 60, until = {{ food = \"steak\", core_c = {core_c} }} }}\n[[step]]\n\
         rest = \"steak\"\n[[step]]\nhob_w = 0\n[[step]]\nafter_s = 300\nend = true\n"
    );
    let (mut fried, mut raw) = ([0.0; 2], None);
    let summary = cooked(library, &text, |kitchen| {
        let piece = &kitchen.pieces()[0];
        if piece.in_pan() {
            let share_left = piece.mass() / *raw.get_or_insert(piece.mass());
            fried = [celsius(piece.core_peak.0), 100.0 * (1.0 - share_left)];
        }
    })?;
    Ok([fried, [summary.foods[0].core_c.peak, summary.foods[0].lost_pct]])
}

/// Colour of the middle of a steak while it becomes well done, against its temperature.
fn colour(library: &Library) -> Result<String, CliError> {
    let text = "[pan]\nkind = \"cast-iron-26\"\ninitial_c = 180\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
        size_mm = [80, 60, 25]\ninitial_c = 5\n[[step]]\nhob_w = { hold_c = 180, w = 2000 }\n[[step]]\nput = \"steak\"\n[[step]]\n\
        repeat = { flip = \"steak\", every_s = 60, until = { food = \"steak\", core_c = 82 } }\n[[step]]\nend = true\n";
    let mut read: Vec<(f64, Lab)> = Vec::new();
    cooked(library, text, |kitchen| {
        let piece = &kitchen.pieces()[0];
        let core = celsius(piece.core());
        if read.last().map_or(core > 40.0, |(last, _)| core > last + 0.5) {
            read.push((core, middle_colour(piece)));
        }
    })?;
    let course = |axis: usize| read.iter().map(|(core, lab)| [*core, lab.0[axis]]).collect();
    let curves =
        ["L*", "a*", "b*"].into_iter().enumerate().map(|(i, name)| solid(name.to_owned(), i, course(i))).collect();
    let rings = INSIDE_OF_BEEF.iter().flat_map(|[core, l, a, b]| [[*core, *l], [*core, *a], [*core, *b]]).collect();
    let (title, axes) = ("Colour of the middle of a steak, turned each minute", ["core [°C]", "CIE L*, a*, b*"]);
    Ok(CurveChart { title, axes, from: 40.0, curves, rings, ranges: Vec::new() }.svg())
}

/// Returns the colour of the node nearest to the middle of a piece.
fn middle_colour(piece: &Piece) -> Lab {
    let mesh = piece.model.mesh();
    let middle = [0.0, 0.0, 0.5 * piece.model.size()[2]];
    let away = |node: &usize| -> f64 { mesh.position(*node).iter().zip(middle).map(|(x, m)| (x - m) * (x - m)).sum() };
    let nearest = (0..mesh.node_count()).min_by(|a, b| away(a).total_cmp(&away(b)));
    piece.model.node_colour(&piece.state, nearest.unwrap_or(0))
}

/// Cooks a recipe, shows the kitchen after each step of the clock, and returns the summary.
fn cooked(library: &Library, text: &str, mut look: impl FnMut(&Kitchen)) -> Result<Summary, CliError> {
    let recipe = Recipe::parse(text, "frying.toml", library)?;
    let setup = |source| CliError::Setup { file: "frying.toml".to_owned(), source };
    let mut cook = Cook::new(recipe, library).map_err(setup)?;
    while cook.stopped().is_none() {
        cook.advance()?;
        look(&cook.kitchen);
    }
    Ok(cook.summary(0.0))
}
