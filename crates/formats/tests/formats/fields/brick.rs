//! Kitchens with a steak or a brick of cells in them.

use std::sync::Arc;

use saute_kitchen::food::description::{Confidence, SurfaceFile};
use saute_kitchen::food::{Form, Rules};
use saute_kitchen::heat::{Soup, Surface};
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, kelvin};

const SIZE: [f64; 3] = [0.06, 0.04, 0.02];

fn surface() -> Surface {
    let corner = |k: usize| [0, 1, 2].map(|a| if k >> a & 1 == 1 { SIZE[a] } else { 0.0 });
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
    Surface::close(&Soup { vertices: (0..8).map(corner).collect(), triangles, ..Soup::default() }, 1.0).unwrap()
}

/// A library with a food that is a brick of beef of cells.
fn library() -> Library {
    let mut library = Library::embedded().unwrap();
    let mut brick = library.foods["beef-lean"].clone();
    brick.form = Form::Mesh;
    brick.body = Some(Arc::new(surface()));
    let (file, source, confidence) = (String::new(), String::new(), Confidence::Low);
    brick.mesh = Some(SurfaceFile { file, scale_mm: None, fibres: Some([0.0, 0.0, 1.0]), source, confidence });
    for size in [&mut brick.size.default_mm, &mut brick.size.min_mm, &mut brick.size.max_mm] {
        *size = vec![60.0];
    }
    library.foods.insert("brick".to_owned(), brick);
    library
}

/// A kitchen in which a food of a kind has fried for some seconds.
pub fn frying(kind: &str, size: [f64; 3], ticks: usize) -> Kitchen {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(200.0)).unwrap();
    let order = PieceOrder {
        id: "food".to_owned(),
        kind: kind.to_owned(),
        size,
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 3.0,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Natural,
    };
    kitchen.add(&library, &order).unwrap();
    kitchen.apply(&Command::Put { food: "food".to_owned(), at: [0.0; 2], heap: false }).unwrap();
    (0..ticks).for_each(|_| kitchen.step());
    kitchen
}
