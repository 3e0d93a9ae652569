//! Search.
#![allow(missing_docs, clippy::unwrap_used)]
use saute_kitchen::Library;
use saute_plan::goal::*;
use saute_plan::schedule::*;
use std::sync::Arc;
use std::time::Instant;

fn main() {
    let a: Vec<String> = std::env::args().collect();
    let library = Library::embedded().unwrap();
    let get = |k: &str, d: &str| a.iter().position(|x| x == k).map_or(d.to_owned(), |i| a[i + 1].clone());
    let nums = |s: String| -> Vec<f64> { s.split(',').map(|x| x.parse().unwrap()).collect() };
    let food = get("--food", "beef-lean");
    let form = library.foods[&food].form;
    let crust = get("--crust", "").parse().unwrap_or(Order::usual_crust_pct(form));
    let goal =
        Goal::new(&get("--target", "medium").parse().unwrap(), library.scale(&get("--scale", "chefs")).unwrap(), crust)
            .unwrap();
    let order = Order {
        food,
        size_mm: nums(get("--size", "120,80,25")),
        initial_c: 5.0,
        count: get("--count", "").parse().ok(),
        pan: get("--pan", "carbon-steel-26"),
        hob_w: nums(get("--hob", "400,1100,2000")),
        most_flips: get("--flips", "12").parse().unwrap(),
        goal,
    };
    let t = Instant::now();
    let quiet = get("--quiet", "no") == "yes";
    let mut planner = Planner::new(order, Arc::new(library.clone())).unwrap();
    let mut total = 0;
    loop {
        if planner.plan().is_some() {
            break;
        }
        let jobs = planner.next_jobs();
        let next = std::sync::atomic::AtomicUsize::new(0);
        let mut results: Vec<(usize, JobResult)> = std::thread::scope(|s| {
            let w = || {
                let mut d = vec![];
                loop {
                    let i = next.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
                    if i >= jobs.len() {
                        return d;
                    }
                    d.push((i, jobs[i].run(&library).unwrap()));
                }
            };
            let h: Vec<_> = (0..2).map(|_| s.spawn(w)).collect();
            h.into_iter().flat_map(|h| h.join().unwrap()).collect()
        });
        results.sort_by_key(|(i, _)| *i);
        if !quiet {
            println!("{} {:.1} s", planner.doing(), t.elapsed().as_secs_f64());
            for (_, r) in &results {
                total += r.work;
                let p: Vec<String> = r.schedule.powers.iter().map(|p| format!("{}@{}", p.hob_w, p.at_s)).collect();
                let f = &r.schedule.flips_s;
                println!(
                    "  {:6.1} share {:4.1} beyond {:4.1} core {:5.2} rise {:4.1} crust {:3.0} ch {:2.0} fire {} hot {:.0} lost {:4.1} | put {} {} flips {} {:?} pull {} rest {} work {:.1e} tot {:.1e}",
                    r.score.0,
                    r.outcome.target_share_pct,
                    r.outcome.beyond_pct,
                    r.outcome.at_core,
                    r.rise,
                    r.outcome.least_crust_pct,
                    r.outcome.charred_pct,
                    r.outcome.fire_hazard,
                    r.outcome.hottest_c,
                    r.outcome.lost_pct,
                    r.schedule.put_s,
                    p.join(" "),
                    f.len(),
                    f.iter().take(2).collect::<Vec<_>>(),
                    r.schedule.pull_s,
                    r.schedule.rest_s,
                    r.work as f64,
                    total as f64
                );
            }
        }
        planner.take(results.into_iter().map(|(_, r)| r).collect());
    }
    let p = planner.plan().unwrap();
    println!(
        "{:.1} s; score {} share {:.1} core {:.2} crust {:.0} candidates {} short {:?}",
        t.elapsed().as_secs_f64(),
        p.score,
        p.promised.target_share_pct,
        p.promised.at_core,
        p.promised.least_crust_pct,
        p.candidates,
        p.shortfalls()
    );
    if !quiet {
        for s in &p.sensitivity {
            println!(
                "   {} core {:.1} share {:.1} crust {:.0} {}",
                s.change.words(),
                s.core_peak_c,
                s.target_share_pct,
                s.crust_pct,
                s.is_met
            );
        }
    }
}
