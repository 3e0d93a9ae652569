//! Promise: a wet face takes heat from any pan within the measured range, oiled or not, and never less from a hotter one;
//! liquids heat food as measured.

use saute_kitchen::liquids::bath::BathModel;
use saute_kitchen::piece::contact::{FaceContact, PatchGap};
use saute_kitchen::{Library, kelvin};

/// Radius and weight per area of the foods by kind, and whether they are oiled.
struct Face {
    kind: String,
    contact: FaceContact,
    share: f64,
}

/// Faces of every shipped food at its default size, dry and in the film of the default oil, fresh and settled.
fn faces(library: &Library) -> Vec<Face> {
    let mut faces = Vec::new();
    for (kind, food) in &library.foods {
        let size = &food.size.default_mm;
        let (across, thick) = (1e-3 * size[0].min(size[size.len() - 2]), 1e-3 * size[size.len() - 1]);
        for film in [0.0, library.room.default_film()] {
            for since in [5.0, 30.0, 300.0] {
                let pressure = 1050.0 * 9.81 * thick;
                let escape = (0.5 * across).min(1e-3 * library.room.contact.vent_spacing_mm);
                let contact = FaceContact { since, pressure, escape, film, coating: None };
                faces.push(Face { kind: kind.clone(), contact, share: food.surface.contact_share });
            }
        }
    }
    faces
}

fn conductance(library: &Library, face: &Face, pan_c: f64, wetness: f64) -> f64 {
    let gap = &library.room.contact;
    let patch = PatchGap { thickness: face.contact.mean_gap(gap), pan: kelvin(pan_c), wetness };
    face.share * face.contact.conductance(gap, &patch)
}

/// Dry pans and vapour films below pressed wet faces conduct 200–1200 W/(m²·K) at 180–320 °C.
#[test]
fn a_wet_face_conducts_200_to_1200_oiled_or_not() {
    let library = Library::embedded().expect("embedded data");
    for face in faces(&library) {
        for pan in [180.0, 215.0, 250.0, 285.0, 320.0] {
            let h = conductance(&library, &face, pan, 1.0);
            assert!((200.0..=1200.0).contains(&h), "{} on {pan} °C, {:?}: {h}", face.kind, face.contact);
        }
    }
}

/// No measurement reports a flux that falls with the pan's temperature under a food that lies with its weight.
#[test]
fn the_flux_into_a_face_never_falls_with_the_temperature_of_the_pan() {
    let library = Library::embedded().expect("embedded data");
    for face in faces(&library) {
        for wetness in [1.0, 0.5, 0.0] {
            let flux = |pan: f64| conductance(&library, &face, pan, wetness) * (pan - 100.0);
            let fluxes: Vec<f64> = (0..=40).map(|i| flux(140.0 + 5.0 * f64::from(i))).collect();
            assert!(fluxes.windows(2).all(|w| w[1] >= w[0]), "{} {wetness}: {fluxes:?}", face.kind);
        }
    }
}

/// Oil that does not boil: 188–226 W/(m²·K) at pork of 90–110 °C; with boiling food 300–1100. Natural convection of water at
/// pieces of 16–30 mm: 600–1500, more the hotter the water; boiling 1500–3000.
#[test]
fn liquids_heat_food_within_the_measured_ranges() {
    let library = Library::embedded().expect("embedded data");
    let bath = BathModel::new(&library.room.bath);
    assert!((188.0..=226.0).contains(&bath.oil(0.0)), "{}", bath.oil(0.0));
    for flux in [2e-3, 5e-3, 10e-3, 30e-3] {
        assert!((300.0..=1100.0).contains(&bath.oil(flux)), "{flux} {}", bath.oil(flux));
    }
    for half in [0.008, 0.015] {
        let at = |water: f64, face: f64| bath.water(kelvin(water), kelvin(face), half);
        assert!((1100.0..=1500.0).contains(&at(95.0, 20.0)), "{half}: {}", at(95.0, 20.0));
        assert!((600.0..=1500.0).contains(&at(60.0, 50.0)), "{half}: {}", at(60.0, 50.0));
        assert!(at(60.0, 50.0) < at(95.0, 20.0), "{half}: {}", at(60.0, 50.0));
        assert!((1500.0..=3000.0).contains(&at(100.0, 40.0)), "{half}: {}", at(100.0, 40.0));
    }
}
