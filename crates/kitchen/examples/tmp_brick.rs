#![allow(missing_docs, clippy::all)]
#[path = "../../cli/src/bench_heat/exact_brick.rs"]
mod exact_brick;
use exact_brick::Brick;
use saute_kitchen::Library;
use saute_kitchen::lab::{Case, run};
use std::time::Instant;

fn main() {
    let b = Brick {
        size: [0.1, 0.07, 0.025],
        conductivity: 0.49,
        diffusivity: 0.49 / 1058.0 / 3590.0,
        h: [15.0, 500.0],
        celsius: [5.0, 25.0, 180.0],
        flip: 300.0,
    };
    let places = [[0.05, 0.035, 0.0125], [0.05, 0.035, 0.0025], [0.05, 0.035, 0.0225]];
    let times = [150.0, 300.0, 450.0, 600.0];
    let t0 = Instant::now();
    let exact = b.temperatures(&places, &times);
    eprintln!("{exact:?} {:?}", t0.elapsed());
    let lib = Library::embedded().unwrap();
    let args: Vec<String> = std::env::args().collect();
    for spec in &args[1..] {
        let p: Vec<&str> = spec.split(';').collect();
        let text = format!(
            "duration_s = 600\noutput_every_s = 150\n[body]\nshape=\"box\"\nsize_mm=[100,70,25]\nresolution_mm={}\ngrading={}\ninitial_c=5\n[material]\nconductivity_w_mk=0.49\ndensity_kg_m3=1058\nspecific_heat_j_kgk=3590\n[solver]\nstep_factor={}\n[[boundary]]\nface=\"all\"\nh_w_m2k=15\nambient_c=25\n[[boundary]]\nface=\"bottom\"\nh_w_m2k=500\nambient_c=180\n[flips]\nat_s=[300]\n[[probe]]\nname=\"a\"\nat_mm=[50,35,12.5]\n[[probe]]\nname=\"b\"\nat_mm=[50,35,2.5]\n[[probe]]\nname=\"c\"\nat_mm=[50,35,22.5]\n",
            p[0],
            p[1],
            p.get(2).unwrap_or(&"1")
        );
        let case = Case::parse(&text, "x", &lib).unwrap();
        let mut best = f64::INFINITY;
        let mut r = None;
        for _ in 0..5 {
            let s = Instant::now();
            let q = run(&case, || s.elapsed().as_secs_f64());
            best = best.min(q.wall_s);
            r = Some(q);
            if best > 0.5 {
                break;
            }
        }
        let r = r.unwrap();
        let mut m: f64 = 0.0;
        let mut e = Vec::new();
        for (pi, n) in ["a", "b", "c"].iter().enumerate() {
            for ti in 0..4 {
                let d = r.probes[*n][ti + 1][1] - exact[ti][pi];
                m = m.max(d.abs());
                e.push(format!("{d:+.3}"));
            }
        }
        println!("{spec}: nodes {} steps {} wall {best:.4} max {m:.4} {}", r.nodes, r.steps, e.join(" "));
    }
}
