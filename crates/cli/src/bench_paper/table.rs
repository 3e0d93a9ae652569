//! The numbers of `saute bench paper` as text.

use std::fmt::Write;

use saute_kitchen::MeshSize;

use super::PaperBench;
use super::row::Row;
use super::scaling::{Point, Scaling};

const HEAD: &str =
    "table  carrots  shrimps    nodes  pan     cycles/s  published    ratio    goal            overlap  core\n";

/// Returns the numbers as text.
pub fn text(bench: &PaperBench) -> String {
    let mut text = String::from(
        "Cycles per second; a cycle is 1/60 s of rigid bodies, contacts, heat and changes. Medians of 7 runs, no body asleep.\n\
         Published figures come from hardware of 2009.\n",
    );
    for (mesh, title) in [
        (MeshSize::Paper2013, "Meshes and rules of 2013 (heat along segments)"),
        (MeshSize::Default, "Default meshes, full physics (published figures are of the small meshes)"),
    ] {
        let _ = write!(text, "\n{title}\n{HEAD}");
        bench.rows.iter().filter(|r| r.mesh == mesh).for_each(|r| row(&mut text, r));
    }
    original(&mut text, bench);
    scaling(&mut text, &bench.scaling);
    let _ = writeln!(text, "\n{}", if bench.goals_met { "All goals are met." } else { "Not all goals are met." });
    text
}

fn mark(met: bool) -> &'static str {
    if met { "met" } else { "NOT met" }
}

fn row(text: &mut String, row: &Row) {
    let published = row
        .published
        .map_or_else(|| "–".to_owned(), |p| format!("{}{p:.0}", if row.table == "35" { "> " } else { "" }));
    let ratio = row.ratio.map_or_else(|| "–".to_owned(), |r| format!("{r:.1} ×"));
    let goal = row.goal.map_or_else(|| "–".to_owned(), |g| format!("{g:.0}"));
    let _ = write!(
        text,
        "{:>5}  {:>7}  {:>7}  {:>7}  {:<6}  {:>8.0}  {published:>9}  {ratio:>7}  {goal:>6}  {:<7}  {:>5.2} mm  {:.2} K",
        row.table,
        row.carrots,
        row.shrimps,
        row.nodes,
        if row.shaking { "shaken" } else { "rests" },
        row.cycles_per_s,
        row.met.map_or("", mark),
        row.max_penetration_mm,
        row.core_rise_k,
    );
    let lost = if row.lost > 0 { format!("  {} fell out", row.lost) } else { String::new() };
    let _ = writeln!(text, "{lost}");
}

fn original(text: &mut String, bench: &PaperBench) {
    let engine = &bench.original_engine;
    let steps = engine.heat_step_ms.map(|(vertices, ms)| format!("{ms} ms at {vertices}"));
    let _ = writeln!(
        text,
        "\nThe engine of the original on a machine with two cores (one thread, steps of 1/60 s): rigid bodies alone {:.0} steps/s\n\
         with 20 mixed pieces, {:.0} with 35 shrimps of three hulls each; a heat step takes\n{} vertices.\n\
         Together about {:.0} cycles/s with 35 shrimps.",
        engine.rigid_20_mixed_per_s,
        engine.rigid_35_shrimps_per_s,
        steps.join(", "),
        engine.cycles_35_shrimps_per_s
    );
}

fn scaling(text: &mut String, scaling: &Scaling) {
    let _ = writeln!(
        text,
        "\nCost against number of pieces (half carrots, half shrimps, meshes of 2013, at rest): power of {:.2} if the floor\n\
         grows with them; goal at most {} – {}",
        scaling.exponent,
        scaling.goal,
        mark(scaling.met)
    );
    text.push_str("pieces   growing floor [mm]  cycles/s  fell out   26 cm pan: cycles/s  fell out\n");
    let line = |text: &mut String, (a, b): (&Point, &Point)| {
        let _ = writeln!(
            text,
            "{:>6}   {:>18.0}  {:>8.0}  {:>8}   {:>19.0}  {:>8}",
            a.pieces, a.floor_radius_mm, a.cycles_per_s, a.lost, b.cycles_per_s, b.lost
        );
    };
    scaling.growing.iter().zip(&scaling.fixed).for_each(|pair| line(text, pair));
}
