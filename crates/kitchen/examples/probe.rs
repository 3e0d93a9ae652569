use saute_kitchen::*;
fn main() {
    let lib = Library::embedded().unwrap();
    let path = std::env::args().nth(1).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let recipe = Recipe::parse(&text, &path, &lib).unwrap_or_else(|e| panic!("{e}"));
    let mut cook = Cook::new(recipe, &lib).unwrap();
    let t = std::time::Instant::now();
    let mut sub = 0;
    while cook.stopped().is_none() {
        for f in cook.advance().unwrap() { eprintln!("{:?}", f); }
        if cook.kitchen.tick() % 300 == 0 { let p=&cook.kitchen.pieces()[0]; let f=p.model.face_reading(&p.state,p.state.down); eprintln!("{:6.1} pan {:.1} core {:.1} top {:.1} bot {:.1} m {:.2} B {:.2} moist {:.2} drip {:.2} puddle {:.2}", cook.kitchen.time_s(), celsius(cook.kitchen.pan_temperature()), celsius(p.core()), celsius(p.face(false)), celsius(p.face(true)), p.mass()*1e3, f.browning, f.moisture, p.state.dripped*1e3, cook.kitchen.pan_state().puddle*1e3); }
        sub += 1;
    }
    let wall = t.elapsed().as_secs_f64();
    let s = cook.summary(wall);
    println!("{}", serde_json::to_string_pretty(&s).unwrap());
    eprintln!("ratio {} {sub}", s.simulated_s / wall);
}
