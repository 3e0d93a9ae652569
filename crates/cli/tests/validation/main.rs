//! Promise: every validation case passes. Each is a separate test: its values are within their tolerances, or miss as its file states.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// Makes a test of each case, and the list of all.
macro_rules! cases {
    ($($test:ident = $id:literal,)*) => {
        $(
            #[test]
            fn $test() {
                holds($id);
            }
        )*

        const CASES: &[&str] = &[$($id),*];
    };
}

/// Runs a case; its values are within tolerance, or miss where the file records it. Information passes no judgement.
fn holds(id: &str) {
    let output = Command::new(env!("CARGO_BIN_EXE_saute")).args(["validate", "--json", "--case", id]).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}{}", String::from_utf8_lossy(&output.stdout));
    let verdicts: Value = serde_json::from_slice(&output.stdout).unwrap();
    let values = verdicts["cases"].as_array().unwrap();
    assert!(!values.is_empty());
    for value in values {
        let informs = value["evidence"] == "information";
        let misses_as_known = value["known_miss"].is_string() && value["pass"] == false;
        let holds = value["known_miss"].is_null() && value["pass"] == true;
        assert!(if informs { value["pass"].is_null() } else { holds || misses_as_known }, "{value}");
        assert!(!value["source"].as_str().unwrap().is_empty(), "{value}");
    }
}

#[test]
fn every_shipped_case_is_a_test() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let shipped: BTreeSet<String> = files
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    assert_eq!(CASES.iter().map(|id| (*id).to_owned()).collect::<BTreeSet<_>>(), shipped);
}

cases! {
    a_litre_on_gas = "a-litre-on-gas",
    a_litre_on_induction = "a-litre-on-induction",
    bacon_5_min = "bacon-5-min",
    bacon_crisp = "bacon-crisp",
    bacon_in_a_hot_skillet = "bacon-in-a-hot-skillet",
    bars_of_a_grill_pan = "bars-of-a-grill-pan",
    both_faces_brown_at_1500_w = "both-faces-brown-at-1500-w",
    brick_20_cells = "brick-20-cells",
    brick_40_cells = "brick-40-cells",
    burger_flipped_every_10_s = "burger-flipped-every-10-s",
    burger_flipped_every_30_s = "burger-flipped-every-30-s",
    burger_flipped_never = "burger-flipped-never",
    burger_flipped_once = "burger-flipped-once",
    carrot_coins_brown_at_190_c = "carrot-coins-brown-at-190-c",
    carrot_sticks_brown_at_190_c = "carrot-sticks-brown-at-190-c",
    carry_over_dry = "carry-over-dry",
    carry_over_wet = "carry-over-wet",
    chicken_fillet_in_an_oven = "chicken-fillet-in-an-oven",
    chicken_sides_at_a_core_of_70_c = "chicken-sides-at-a-core-of-70-c",
    chicken_white_but_not_safe = "chicken-white-but-not-safe",
    contact_at_180_c = "contact-at-180-c",
    contact_at_320_c = "contact-at-320-c",
    contact_conductance = "contact-conductance",
    contact_flux_rises_with_the_pan = "contact-flux-rises-with-the-pan",
    contact_iron_and_meat = "contact-iron-and-meat",
    contact_of_a_fat_patty = "contact-of-a-fat-patty",
    contact_resistance = "contact-resistance",
    contact_resistance_of_a_plate = "contact-resistance-of-a-plate",
    convection_cylinder_bi_1 = "convection-cylinder-bi-1",
    convection_slab_bi_1 = "convection-slab-bi-1",
    convection_slab_bi_5 = "convection-slab-bi-5",
    convection_sphere_bi_1 = "convection-sphere-bi-1",
    eggs_covered_set_above = "eggs-covered-set-above",
    eggs_hotter_is_faster = "eggs-hotter-is-faster",
    flipped_between_equal_faces = "flipped-between-equal-faces",
    flipped_brick = "flipped-brick",
    forgotten_steak_chars = "forgotten-steak-chars",
    frequent_flips = "frequent-flips",
    fried_egg_loses_water = "fried-egg-loses-water",
    frozen_patty = "frozen-patty",
    hamburger_10_mm = "hamburger-10-mm",
    hamburger_20_mm = "hamburger-20-mm",
    hamburger_30_mm = "hamburger-30-mm",
    hotter_is_never_paler = "hotter-is-never-paler",
    hotter_is_never_slower = "hotter-is-never-slower",
    hotter_is_never_slower_gas = "hotter-is-never-slower-gas",
    hotter_is_never_slower_iron_plate = "hotter-is-never-slower-iron-plate",
    hotter_is_never_slower_light_pans = "hotter-is-never-slower-light-pans",
    hotter_is_never_slower_radiant = "hotter-is-never-slower-radiant",
    hotter_pan_browns_more = "hotter-pan-browns-more",
    leek_rings_brown_at_190_c = "leek-rings-brown-at-190-c",
    lid_cooks_faster = "lid-cooks-faster",
    mushroom_under_a_lid = "mushroom-under-a-lid",
    mushroom_weeps_before_it_browns = "mushroom-weeps-before-it-browns",
    new_foods_covered_are_moister = "new-foods-covered-are-moister",
    new_foods_hotter_is_faster_and_browner = "new-foods-hotter-is-faster-and-browner",
    new_foods_thicker_is_slower = "new-foods-thicker-is-slower",
    oil_never_lengthens_a_cook = "oil-never-lengthens-a-cook",
    one_sided = "one-sided",
    onion_slices_brown_at_180_c = "onion-slices-brown-at-180-c",
    pan_alone_aluminium = "pan-alone-aluminium",
    pan_alone_cast_iron = "pan-alone-cast-iron",
    pan_alone_steel = "pan-alone-steel",
    pan_and_cold_food = "pan-and-cold-food",
    pan_drop = "pan-drop",
    pan_times_3_min = "pan-times-3-min",
    pan_times_4_5_min = "pan-times-4-5-min",
    pan_times_7_5_min = "pan-times-7-5-min",
    patty_15_mm_turned_each_minute = "patty-15-mm-turned-each-minute",
    patty_between_plates_at_177_c = "patty-between-plates-at-177-c",
    patty_between_plates_at_204_c = "patty-between-plates-at-204-c",
    pepper_green_lost_in_water = "pepper-green-lost-in-water",
    pork_loin_boiled = "pork-loin-boiled",
    pork_slices_one_turn = "pork-slices-one-turn",
    pork_slices_unturned = "pork-slices-unturned",
    potato_in_boiling_water = "potato-in-boiling-water",
    potato_in_boiling_water_shorter = "potato-in-boiling-water-shorter",
    pressed_patty = "pressed-patty",
    radiative_cooling = "radiative-cooling",
    rings_thicker_is_slower = "rings-thicker-is-slower",
    salmon_in_a_bag_57_c = "salmon-in-a-bag-57-c",
    salmon_in_a_bag_63_c = "salmon-in-a-bag-63-c",
    salmon_steamed = "salmon-steamed",
    seared_colour = "seared-colour",
    seen_colours = "seen-colours",
    seen_darkening = "seen-darkening",
    seen_never_uncooks = "seen-never-uncooks",
    seen_raw_colours = "seen-raw-colours",
    shrimp_cylinder = "shrimp-cylinder",
    shrimp_cylinder_cooked_to_63_c = "shrimp-cylinder-cooked-to-63-c",
    shrimp_cylinder_cooked_to_70_c = "shrimp-cylinder-cooked-to-70-c",
    shrimp_cylinder_cooked_to_80_c = "shrimp-cylinder-cooked-to-80-c",
    shrimp_in_boiling_water = "shrimp-in-boiling-water",
    shrinkage = "shrinkage",
    skillet_table_13_mm = "skillet-table-13-mm",
    skillet_table_19_mm = "skillet-table-19-mm",
    skillet_table_25_mm = "skillet-table-25-mm",
    sous_vide_10_mm = "sous-vide-10-mm",
    sous_vide_20_mm = "sous-vide-20-mm",
    sous_vide_25_mm = "sous-vide-25-mm",
    sous_vide_30_mm = "sous-vide-30-mm",
    sous_vide_40_mm = "sous-vide-40-mm",
    sous_vide_50_mm = "sous-vide-50-mm",
    sous_vide_65_mm = "sous-vide-65-mm",
    steak_leaves_a_puddle = "steak-leaves-a-puddle",
    stefan_160 = "stefan-160",
    stefan_200 = "stefan-200",
    stefan_240 = "stefan-240",
    step_coin = "step-coin",
    step_cube = "step-cube",
    step_cylinder = "step-cylinder",
    step_slab = "step-slab",
    step_sphere = "step-sphere",
    thin_foods_covered_are_moister = "thin-foods-covered-are-moister",
    thin_foods_hotter_is_faster_and_browner = "thin-foods-hotter-is-faster-and-browner",
    thin_foods_thicker_is_slower = "thin-foods-thicker-is-slower",
    turned_face_stays_warm = "turned-face-stays-warm",
    virtual_cook = "virtual-cook",
    water_bath_50_c = "water-bath-50-c",
    water_bath_60_c = "water-bath-60-c",
    water_bath_60_c_one_hour = "water-bath-60-c-one-hour",
    water_bath_70_c = "water-bath-70-c",
    water_bath_70_c_one_hour = "water-bath-70-c-one-hour",
    water_bath_80_c = "water-bath-80-c",
    weight_loss_54_c = "weight-loss-54-c",
    weight_loss_60_c = "weight-loss-60-c",
    weight_loss_66_c = "weight-loss-66-c",
    weight_loss_71_c = "weight-loss-71-c",
    weight_loss_of_a_patty = "weight-loss-of-a-patty",
    weight_loss_rare_and_well_done = "weight-loss-rare-and-well-done",
    weight_loss_slope = "weight-loss-slope",
    wet_surface = "wet-surface",
}
