//! The numbers of a cook as plain text.

use std::collections::BTreeMap;
use std::fmt::Write;

use saute_kitchen::tick::energy::Energy;
use saute_recipe::group_summary::GroupSummary;
use saute_recipe::summary::{ClassShares, FoodSummary, LogReduction, OilAtStart, Shape, Surface};
use saute_recipe::{StoppedBy, Summary};

use crate::wording::{self, duration};

/// Width of a doneness bar [characters].
const BAR: usize = 30;

/// Returns all numbers of a cook on one screen, with doneness on the scale with an id where that fits.
pub fn text(summary: &Summary, scale: &str) -> String {
    let mut blocks = vec![head(summary)];
    blocks.extend(summary.foods.iter().filter(|f| f.group.is_none()).map(|f| food(f, scale)));
    blocks.extend((!summary.groups.is_empty()).then(|| groups(summary)));
    blocks.push(pan(summary));
    blocks.push(steps(summary));
    blocks.join("\n")
}

fn head(s: &Summary) -> String {
    let how = match s.stopped_by {
        StoppedBy::End => "ended by its last step",
        StoppedBy::MaxS => "stopped by max_s",
        StoppedBy::Hand => "ended by hand",
    };
    let speed = s.simulated_s / s.wall_s.max(1e-9);
    format!(
        "{}\n{how} after {}; simulated in {:.1} s, {speed:.0} times real time\n",
        s.title,
        duration(s.simulated_s),
        s.wall_s
    )
}

fn food(f: &FoodSummary, scale: &str) -> String {
    let mut lines = format!("{} ({}, {} nodes)\n", f.id, f.kind, f.nodes);
    row(
        &mut lines,
        "core",
        &format!(
            "{:.1} °C at its highest, after {}; {:.1} °C at the end",
            f.core_c.peak,
            duration(f.core_c.peak_at_s),
            f.core_c.end
        ),
    );
    doneness(&mut lines, f, scale);
    row(&mut lines, "mass", &mass(f));
    row(&mut lines, "top", &surface(&f.surfaces.top));
    row(&mut lines, "bottom", &surface(&f.surfaces.bottom));
    let changes: Vec<String> = f.denatured.iter().map(|(name, share)| format!("{name} {share:.2}")).collect();
    row(&mut lines, "changed", &changes.join(", "));
    row(&mut lines, "shape", &shape(&f.shape));
    let bite = format!("hardness {:.1} × raw, juiciness {:.0} %", f.hardness_index, f.juiciness_pct);
    row(&mut lines, "bite", &bite);
    row(&mut lines, "stiffness", &format!("elastic modulus {:.0} kPa", f.elastic_modulus_kpa));
    row(&mut lines, "safety", &safety(&f.log_reduction));
    lines
}

fn mass(f: &FoodSummary) -> String {
    let lost = 100.0 * (1.0 - f.mass_g.end / f.mass_g.start);
    format!(
        "{:.1} g → {:.1} g, −{lost:.1} %: {:.1} g evaporated, {:.1} g dripped, {:.1} g fat rendered",
        f.mass_g.start, f.mass_g.end, f.water_g.evaporated, f.water_g.dripped, f.fat_rendered_g
    )
}

fn shape(s: &Shape) -> String {
    let curl = if s.curl_deg > 0.0 { format!(", curled by {:.0}°", s.curl_deg) } else { String::new() };
    let waves = if s.waves_mm > 0.0 { format!(", waves of {:.1} mm", s.waves_mm) } else { String::new() };
    format!(
        "{:.1} % of its volume, {:.1} % across, {:.1} mm thick, domed {:.1} mm{waves}{curl}",
        s.volume_pct, s.across_pct, s.thickness_mm, s.dome_mm
    )
}

/// Returns a line for each group: means, with the smallest and the largest value.
fn groups(summary: &Summary) -> String {
    let mut lines = "groups, means (smallest–largest)\n".to_owned();
    for g in &summary.groups {
        let spread = |mean: f64, [low, high]: [f64; 2]| format!("{mean:.0} ({low:.0}–{high:.0})");
        let (mean, s) = (&g.mean, &g.spread);
        let line = format!(
            "{} × {}: core {} °C at its highest, {} °C at the end; {:.1} g → {:.1} g, −{} %; browned {} %; {}",
            g.count,
            mean.kind,
            spread(mean.core_c.peak, s.core_peak_c),
            spread(mean.core_c.end, s.core_end_c),
            mean.mass_g.start,
            mean.mass_g.end,
            spread(mean.lost_pct, s.lost_pct),
            spread(mean.browned_pct(), s.browned_pct),
            places(summary, g)
        );
        row(&mut lines, &mean.id, &line);
    }
    lines
}

/// Returns the number of pieces of a group at each place: `9 pan, 2 board`.
fn places(summary: &Summary, group: &GroupSummary) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for food in &summary.foods[group.members.clone()] {
        *counts.entry(food.place).or_default() += 1;
    }
    let counts: Vec<String> = counts.iter().map(|(place, count)| format!("{count} {place}")).collect();
    counts.join(", ")
}

/// Returns the log reductions; values above 12 are not distinguished.
fn safety(l: &LogReduction) -> String {
    let shown = |log: f64| if log > 12.0 { "over 12".to_owned() } else { format!("{log:.1}") };
    let kill = format!("{} log reduction: core {}, least heated surface {}", l.germ, shown(l.core), shown(l.surface));
    match l.asked {
        Some(asked) if l.core.min(l.surface) >= asked => format!("{kill}; pasteurised ({asked} asked)"),
        Some(asked) => format!("{kill}; not pasteurised ({asked} asked)"),
        None => kill,
    }
}

fn row(lines: &mut String, name: &str, value: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(lines, "  {name:<14}{value}");
}

/// Adds the doneness in the food's words, with the label of the scale; nothing if no scale covers the food.
fn doneness(lines: &mut String, f: &FoodSummary, scale: &str) {
    let Some((_, reading)) = f.doneness.in_words_of(scale) else { return };
    row(lines, "doneness", &format!("core {}; scale: {}", reading.class, reading.label));
    row(lines, "cross-section", &shares(&reading.section_pct));
    row(lines, "volume", &shares(&reading.volume_pct));
}

/// Returns shares as a bar and as numbers.
fn shares(shares: &ClassShares) -> String {
    let (mut bar, mut sum, mut drawn, mut numbers) = (String::new(), 0.0, 0, Vec::new());
    for ((name, share), sign) in shares.0.iter().zip(signs(shares.0.len())) {
        sum += share;
        let until = ((sum / 100.0 * BAR as f64).round() as usize).min(BAR);
        bar.extend(std::iter::repeat_n(*sign, until.saturating_sub(drawn)));
        drawn = until.max(drawn);
        numbers.push(format!("{sign} {name} {share:.0} %"));
    }
    format!("{bar}  {}", numbers.join("  "))
}

/// Returns a character for each class, of increasing density.
fn signs(classes: usize) -> &'static [char] {
    if classes > 4 { &['·', '░', '▒', '▓', '█'] } else { &['·', '░', '▒', '█'] }
}

fn surface(s: &Surface) -> String {
    let [l, a, b] = s.lab;
    let shares = format!("browned {:.0} %, charred {:.0} %", s.browned_pct, s.charred_pct);
    format!("{:5.1} °C, {shares}, L*a*b* {l:.0} {a:.0} {b:.0}", s.temperature_c)
}

fn pan(s: &Summary) -> String {
    let p = &s.pan_c;
    let mut lines = "pan\n".to_owned();
    let at_put = match (p.at_first_put, p.lowest_after_first_put) {
        (Some(put), Some(low)) => {
            format!("{put:.1} °C at the first put, then down to {low:.1} °C; ")
        }
        _ => String::new(),
    };
    row(&mut lines, "temperature", &format!("{at_put}highest {:.1} °C, {:.1} °C at the end", p.peak, p.end));
    row(&mut lines, "oil", &oil(&s.oil_at_start));
    row(&mut lines, "energy", &energy(&s.energy_j));
    row(&mut lines, "imbalance", &format!("{:.1e} % of the hob's energy", imbalance_pct(&s.energy_j)));
    lines
}

/// The oil with which the cook began.
fn oil(o: &OilAtStart) -> String {
    if o.stated {
        return format!("{:.1} g at the start", o.g);
    }
    format!("{:.1} g of canola at the start, as the recipe states none; [pan] oil_g = 0 fries dry", o.g)
}

fn energy(e: &Energy) -> String {
    let kj = |j: f64| format!("{:.1}", j / 1e3);
    let [hob, pan, food, air, vapour, other] =
        [e.hob, e.pan_stored, e.food_stored, e.air, e.evaporation, e.other].map(kj);
    format!("hob {hob} kJ = pan {pan} + food {food} + air {air} + evaporation {vapour} + other {other}")
}

/// Returns the imbalance of the energy in percent of the hob's energy [%].
fn imbalance_pct(e: &Energy) -> f64 {
    if e.hob > 0.0 { 100.0 * e.imbalance.abs() / e.hob } else { 0.0 }
}

fn steps(s: &Summary) -> String {
    let mut lines = "steps (min:s)\n".to_owned();
    for step in &s.steps {
        let _ = writeln!(lines, "  {:>8}    {}", wording::clock(step.time_s), wording::step(step));
    }
    lines
}
