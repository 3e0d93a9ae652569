//! Probe.
#![allow(missing_docs, clippy::unwrap_used)]
use saute_kitchen::{Library, food};
use saute_plan::goal::*;
use saute_plan::schedule::*;
use std::time::Instant;

fn main() {
    let a: Vec<String> = std::env::args().collect();
    let library = Library::embedded().unwrap();
    let get = |k: &str, d: &str| a.iter().position(|x| x == k).map_or(d.to_owned(), |i| a[i + 1].clone());
    let nums = |s: String| -> Vec<f64> { s.split(',').map(|x| x.parse().unwrap()).collect() };
    let food = get("--food", "beef-lean");
    let form = library.foods[&food].form;
    let _ = food::Form::Steak;
    let goal = Goal::new(
        &get("--target", "medium").parse().unwrap(),
        library.scale(&get("--scale", "chefs")).unwrap(),
        Order::usual_crust_pct(form),
    )
    .unwrap();
    let order = Order {
        food,
        size_mm: nums(get("--size", "120,80,25")),
        initial_c: 5.0,
        count: None,
        pan: get("--pan", "carbon-steel-26"),
        hob_w: nums(get("--hob", "400,1100,2000")),
        most_flips: 30,
        goal,
    };
    let powers: Vec<f64> = nums(get("--powers", "1100,60,400"));
    let put: u32 = get("--put", "60").parse().unwrap();
    let mut p = vec![Setting { at_s: 0, hob_w: 2000.0 }, Setting { at_s: put, hob_w: powers[0] }];
    for c in powers[1..].chunks(2) {
        p.push(Setting { at_s: put + c[0] as u32, hob_w: c[1] });
    }
    let every: u32 = get("--every", "60").parse().unwrap();
    let n: u32 = get("--flips", "40").parse().unwrap();
    let schedule = Schedule {
        powers: p,
        put_s: put,
        flips_s: (1..=n).map(|k| put + k * every).collect(),
        pull_s: put + 1800,
        rest_s: 0,
    };
    for c in nums(get("--coarse", "1,1.5,2,3,4")) {
        let job = Job {
            order: order.clone(),
            schedule: schedule.clone(),
            pull: Pull::ToAim { rise: nums(get("--rise", "10"))[0], within: 0.3, most_rests: 3 },
            coarseness: c,
        };
        let t = Instant::now();
        let r = job.run(&library).unwrap();
        let w = t.elapsed().as_secs_f64();
        println!(
            "coarse {c}: {w:.2} s, work {:.2e}, {:.2e}/s; pull {} rest {} rise {:.1} score {} {:?}",
            r.work as f64,
            r.work as f64 / w,
            r.schedule.pull_s,
            r.schedule.rest_s,
            r.rise,
            r.score,
            r.outcome
        );
        if get("--cues", "no") == "yes" {
            for c in &r.cues {
                println!("   {c:?}");
            }
        }
    }
}
