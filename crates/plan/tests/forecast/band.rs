//! Promise: as many forecasts as the band states lie within it.

use saute_kitchen::Library;

use crate::comparison::Case;

#[test]
#[ignore = "campaign"]
fn campaign() {
    let library = Library::embedded().unwrap();
    let cases: u64 = std::env::var("FORECAST_CASES").map_or(30, |n| n.parse().unwrap());
    let first: u64 = std::env::var("FORECAST_FIRST").map_or(1, |n| n.parse().unwrap());
    for number in first..first + cases {
        let case = Case::numbered(number);
        println!("{case:?}");
        for miss in case.misses(&library) {
            println!(
                "MISS {number} {:10} {:?} {:7.2} {:7.2} {:7.2} peak {:7.2}",
                format!("{:?}", miss.question), case.kind, miss.cores[0], miss.cores[1], miss.cores[2], miss.peak
            );
        }
    }
}

#[test]
#[ignore = "speed"]
fn speed() {
    use saute_kitchen::reduced::Reductions;
    use saute_plan::forecast::{Ahead, Ask, Exact, Question};
    let library = Library::embedded().unwrap();
    let kitchen = Case { size_mm: [120.0, 80.0, 25.0], kind: "beef-lean", ..Case::numbered(3) }.kitchen(&library);
    let mut reductions = Reductions::default();
    let t = std::time::Instant::now();
    let reduced = kitchen.reduced(&mut reductions).unwrap();
    println!("first reduction {:?}", t.elapsed());
    let t = std::time::Instant::now();
    let _ = kitchen.reduced(&mut reductions).unwrap();
    println!("reduction {:?}", t.elapsed());
    let t = std::time::Instant::now();
    let copy = reduced.clone();
    println!("clone of reduced {:?} nodes {}", t.elapsed(), copy.kitchen().pieces()[0].model.mesh().node_count());
    for question in Question::ALL {
        let ask = Ask { food: "steak".into(), question, scale: Some(library.scales[0].clone()) };
        let mut ahead = Ahead::from(&kitchen, reduced.clone(), &ask).unwrap();
        let t = std::time::Instant::now();
        let mut steps = 0;
        while !ahead.is_done() {
            steps += ahead.advance(1000);
        }
        println!("{question:?}: {:?} for {steps} steps", t.elapsed());
    }
    let ask = Ask { food: "steak".into(), question: Question::AsItIs, scale: None };
    let t = std::time::Instant::now();
    let mut exact = Exact::begin(&kitchen, &ask, 60.0).unwrap().unwrap();
    exact.advance(u64::MAX);
    println!("exact 60 s {:?} nodes {}", t.elapsed(), kitchen.pieces()[0].model.mesh().node_count());
}
