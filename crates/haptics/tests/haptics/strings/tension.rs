//! Promise: tensions respect their limits and are optimal to 1e-6 of an independent solver.

use saute_haptics::strings::Lines;
use saute_haptics::strings::workspace::{largest, report, smallest_singular_value};
use saute_haptics::{STRINGS, TensionRule, TensionSolver, Wrench};

use crate::random::{Random, device, somewhere};

/// Objective function of the tension distribution.
fn cost(lines: &Lines, wanted: &Wrench, rule: &TensionRule, t: &[f64; STRINGS]) -> f64 {
    let off = lines.wrench(t) - *wanted;
    let slack: f64 = t.iter().map(|t| (t - rule.min).powi(2)).sum();
    off.force.length_squared() + off.torque.length_squared() / rule.lever.powi(2) + rule.regularisation * slack
}

fn slope(lines: &Lines, wanted: &Wrench, rule: &TensionRule, t: &[f64; STRINGS], i: usize) -> f64 {
    let off = lines.wrench(t) - *wanted;
    let torque = lines.lever[i].dot(off.torque) / rule.lever.powi(2);
    2.0 * (lines.direction[i].dot(off.force) + torque + rule.regularisation * (t[i] - rule.min))
}

/// Accelerated projected gradient with many iterations: slow, simple, and independent of the solver under test.
fn by_gradient(lines: &Lines, wanted: &Wrench, rule: &TensionRule) -> [f64; STRINGS] {
    // The largest eigenvalue of the Hessian is at most its trace: 8 unit directions and their levers.
    let trace: f64 = (0..STRINGS).map(|i| 1.0 + lines.lever[i].length_squared() / rule.lever.powi(2)).sum();
    let step = 0.5 / (trace + rule.regularisation);
    let (mut t, mut ahead, mut momentum) = ([rule.min; STRINGS], [rule.min; STRINGS], 1.0f64);
    for _ in 0..200_000 {
        let next: [f64; STRINGS] = std::array::from_fn(|i| {
            (ahead[i] - step * slope(lines, wanted, rule, &ahead, i)).clamp(rule.min, rule.max)
        });
        let grown = 0.5 * (1.0 + (1.0 + 4.0 * momentum * momentum).sqrt());
        let uphill: f64 = (0..STRINGS).map(|i| (ahead[i] - next[i]) * (next[i] - t[i])).sum();
        let share = if uphill > 0.0 { 0.0 } else { (momentum - 1.0) / grown };
        ahead = std::array::from_fn(|i| next[i] + share * (next[i] - t[i]));
        momentum = if uphill > 0.0 { 1.0 } else { grown };
        t = next;
    }
    t
}

#[test]
fn tensions_are_optimal_to_1e_6_against_a_long_projected_gradient() {
    for name in ["spidar-pan-crossed", "spidar-frame"] {
        let geometry = device(name);
        let rule = TensionRule { regularisation: 1e-3, ..geometry.tension_rule() };
        let mut solver = TensionSolver::new(rule);
        let mut random = Random(11);
        for k in 0..12 {
            let lines = geometry.rig().lines(&somewhere(&geometry, &mut random));
            let size = if k % 3 == 0 { 30.0 } else { 5.0 };
            let wanted =
                geometry.preload() + Wrench { force: random.vector() * size, torque: random.vector() * 0.03 * size };
            let found = solver.solve(&lines, &wanted).tension;
            assert!(found.iter().all(|t| (rule.min..=rule.max).contains(t)), "{found:?}");
            let other = by_gradient(&lines, &wanted, &rule);
            let (ours, theirs) = (cost(&lines, &wanted, &rule, &found), cost(&lines, &wanted, &rule, &other));
            assert!(ours <= theirs + 1e-6 * theirs.max(1e-3), "{name} {k}: {ours} against {theirs}");
            assert!((ours - theirs).abs() <= 1e-6 * theirs.max(1.0), "{name} {k}: {ours} against {theirs}");
        }
    }
}

#[test]
fn the_optimality_conditions_hold_for_every_bound_and_free_tension() {
    // The Karush–Kuhn–Tucker conditions hold to 1e-6 with the shipped regularisation, from any start.
    let geometry = device("spidar-pan-crossed");
    let rule = geometry.tension_rule();
    let mut solver = TensionSolver::new(rule);
    let mut random = Random(5);
    for _ in 0..5000 {
        let lines = geometry.rig().lines(&somewhere(&geometry, &mut random));
        let wanted = Wrench { force: random.vector() * 40.0, torque: random.vector() * 2.0 };
        let solved = solver.solve(&lines, &wanted);
        assert!(solved.rounds < 40, "{} rounds", solved.rounds);
        assert_eq!(solved.achieved, lines.wrench(&solved.tension));
        for (i, t) in solved.tension.iter().enumerate() {
            let slope = slope(&lines, &wanted, &rule, &solved.tension, i);
            assert!((rule.min..=rule.max).contains(t));
            assert!(*t > rule.min || slope >= -1e-6, "{slope} at the minimum tension");
            assert!(*t < rule.max || slope <= 1e-6, "{slope} at the maximum");
            assert!(*t == rule.min || *t == rule.max || slope.abs() <= 1e-6, "{slope} at {t}");
        }
    }
}

#[test]
fn motors_below_pull_down_and_sideways_but_push_up_no_more_than_their_preload() {
    let report = report(&device("spidar-pan-crossed"));
    let (up, down) = (report.home.plus[2], report.home.minus[2]);
    assert!(up < 4.0 && up > 0.5, "up {up} N");
    assert!(down > 15.0, "down {down} N");
    assert!(report.singular_poses == 0 && report.least_singular_value > 0.05, "{report:?}");
}

#[test]
fn the_frame_renders_wrenches_in_all_directions() {
    let report = report(&device("spidar-frame"));
    let reach = report.home.plus.iter().chain(&report.home.minus);
    assert!(reach.clone().take(3).all(|f| *f > 4.0), "{report:?}");
    assert!(reach.clone().all(|f| *f > 0.1), "{report:?}");
}

#[test]
fn strings_that_meet_in_one_point_are_singular() {
    let mut geometry = device("spidar-frame");
    geometry.strings.attachment_mm = vec![[0.0; 3]; STRINGS];
    let lines = geometry.rig().lines(&geometry.home());
    assert!(smallest_singular_value(&lines, 0.06) < 1e-6);
    let twist = Wrench { torque: glam::DVec3::Z, ..Wrench::ZERO };
    assert!(largest(&geometry, &lines, &twist, 1.0) < 0.01);
}
