//! Promise: changes are irreversible and proceed at the published rates.

use saute_food::{Face, FreeAir, MeshSize, OutlineKind, PieceSpec, Rules, ZERO_C};

use crate::run::{Run, UP, kitchen_air, lean, model, piece};

#[test]
fn nothing_uncooks_when_it_cools() {
    let mut run = Run::new(lean(), 20.0);
    run.fry(240.0, 220.0, 500.0, kitchen_air());
    let before = run.state.clone();
    run.fry(120.0, 10.0, 2000.0, kitchen_air());
    assert!(run.state.range().1 < before.range().1);
    for k in 0..4 {
        assert!(run.state.changed[k].iter().zip(&before.changed[k]).all(|(now, then)| now >= then));
    }
    assert!(run.state.browning.iter().zip(&before.browning).all(|(now, then)| now >= then));
    assert!(run.state.charring.iter().zip(&before.charring).all(|(now, then)| now >= then));
    assert!(run.state.peak.iter().zip(&before.peak).all(|(now, then)| now >= then));
}

#[test]
fn a_hotter_plate_browns_and_then_chars() {
    let browning = |plate: f64, seconds: f64| {
        let mut run = Run::new(lean(), 20.0);
        run.fry(seconds, plate, 400.0, kitchen_air());
        let face = run.model.face_reading(&run.state, UP);
        (face.browning, face.charred_pct, face.lab.0[0])
    };
    let (cool, medium, hot, burnt) =
        (browning(120.0, 180.0), browning(180.0, 180.0), browning(230.0, 180.0), browning(320.0, 300.0));
    assert!(cool.0 < 0.15 && cool.0 < medium.0 && medium.0 < hot.0, "{cool:?} {medium:?} {hot:?}");
    assert!(hot.1 < 5.0 && burnt.1 > 90.0, "{hot:?} {burnt:?}");
    assert!(hot.2 < cool.2 && burnt.2 < hot.2, "{cool:?} {hot:?} {burnt:?}");
}

/// USDA-FSIS Appendix A requires 12 min at 60 °C for 6.5 log of Salmonella; E. coli O157:H7 (D60 2.6 min) loses 4.6.
#[test]
fn lethality_adds_up_at_the_published_rate() {
    let steak = model("beef-lean", 2.5, [0.05, 0.05, 0.012]);
    let mut run = Run::new(&steak, 60.0);
    run.fry(
        720.0,
        60.0,
        5000.0,
        FreeAir {
            temperature: ZERO_C + 60.0,
            walls: ZERO_C + 60.0,
            convection: 5000.0,
            mass_transfer: 0.0,
            ..kitchen_air()
        },
    );
    let (core, surface) = steak.log_reduction(&run.state);
    assert!((core / 4.6 - 1.0).abs() < 0.05 && (surface / 4.6 - 1.0).abs() < 0.05, "{core} {surface}");
}

/// Ishiwatari et al. 2013: raw 6 kPa, myosin denatured up to 14, actin too 60.
#[test]
fn cooked_meat_is_as_stiff_as_measured() {
    let mut run = Run::new(lean(), 20.0);
    assert!((run.model.elastic_modulus_kpa(&run.state) - 6.0).abs() < 1e-9);
    let at = |name: &str| run.model.kinetics().names().into_iter().position(|n| n == name).expect("change");
    let (myosin, actin) = (at("myosin"), at("actin"));
    run.state.changed[myosin].fill(1.0);
    assert!((run.model.elastic_modulus_kpa(&run.state) - 14.0).abs() < 1e-9);
    run.state.changed[actin].fill(1.0);
    assert!((run.model.elastic_modulus_kpa(&run.state) - 60.0).abs() < 1e-9);
}

/// Adipose tissue has a tenth of the protein of lean flesh: as brown and as hot as that, it chars a tenth as fast.
#[test]
fn fat_chars_later_than_lean_flesh() {
    let charred = |solids: f64| lean().browning().advance((1.0, 0.0), ZERO_C + 250.0, 0.3, solids, 60.0).1;
    assert!(charred(1.0) > 0.2 && charred(0.1) < 0.15 * charred(1.0), "{} {}", charred(1.0), charred(0.1));
    let spec = PieceSpec {
        size: [0.10, 0.07, 0.015],
        seed: 1,
        coarseness: 1.6,
        mesh: MeshSize::Default,
        rules: Rules::Full,
        outline: OutlineKind::Natural,
        pool: None,
    };
    let capped = piece("beef-lean", &spec);
    let mut run = Run::new(&capped, 20.0);
    run.fry(240.0, 290.0, 500.0, kitchen_air());
    let mean = |fatty: std::ops::Range<f64>| {
        let faces = capped.patches().iter().filter(|patch| patch.face == Face::Bottom);
        let nodes = faces.map(|patch| patch.node as usize).filter(|node| fatty.contains(&capped.adipose()[*node]));
        let values: Vec<f64> = nodes.map(|node| run.state.charring[node]).collect();
        assert!(values.len() > 3, "{}", values.len());
        values.iter().sum::<f64>() / values.len() as f64
    };
    let (flesh, fat) = (mean(0.0..0.1), mean(0.6..1.1));
    assert!(flesh > 0.01 && fat < 0.5 * flesh, "{flesh} {fat}");
}
