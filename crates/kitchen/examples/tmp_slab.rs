#![allow(missing_docs, clippy::all)]
use saute_kitchen::Library;
use saute_kitchen::lab::{Case, run};
fn exact(bi: f64, fo: f64) -> f64 {
    (0..40)
        .map(|n| {
            let (mut lo, mut hi) = (n as f64 * 3.141592653589793, (n as f64 + 0.5) * 3.141592653589793);
            for _ in 0..200 {
                let m = 0.5 * (lo + hi);
                if m * m.tan() < bi { lo = m } else { hi = m }
            }
            4.0 * lo.sin() / (2.0 * lo + (2.0 * lo).sin()) * (-lo * lo * fo).exp()
        })
        .sum()
}
fn main() {
    let lib = Library::embedded().unwrap();
    let unit = 1e-4 / 1.3e-7;
    for sf in [1.0, 0.5, 0.25, 0.05] {
        for fo in [0.1, 0.2, 0.5] {
            let e: Vec<f64> = [2.0, 1.0, 0.8, 0.4, 0.2, 0.1].iter().map(|r| {
            let text = format!("duration_s={}\n[body]\nshape=\"slab\"\nsize_mm=[20]\nresolution_mm={r}\ninitial_c=0\n[material]\nconductivity_w_mk = 0.48\ndensity_kg_m3 = 1000\nspecific_heat_j_kgk = 3692.307692307692\n[solver]\nstep_factor={sf}\n[[boundary]]\nface=\"all\"\nh_w_m2k=240\nambient_c=100\n[[probe]]\nname=\"c\"\nat_mm=[10]\n", fo * unit);
            let r = run(&Case::parse(&text, "x", &lib).unwrap(), || 0.0);
            r.probes["c"].last().unwrap()[1] - 100.0 * (1.0 - exact(5.0, fo))
        }).collect();
            println!("sf {sf} fo {fo}: {e:.5?}");
        }
    }
}
