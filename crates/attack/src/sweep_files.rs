//! Files of sweeps: specifications, and the manifest in a folder of results.

use saute_schema::InputError;
use saute_sweep::{Base, Manifest, Sweep};

use crate::text;

/// The recipe that is varied: a coin, which is soon built.
const RECIPE: &str = "[pan]\nkind = \"carbon-steel-26\"\ninitial_c = 180\n[[food]]\nid = \"coin\"\nkind = \"carrot-coin\"\nsize_mm = [26, 6]\nmesh = \"2013\"\n\
                      [[step]]\nput = \"coin\"\n[[step]]\nat_s = 9\nend = true\n";
/// Longest list of levels in an input that is joined with its recipe [-]: each one may be built.
const MOST_COMMAS: usize = 400;

/// A specification joined with a recipe; two of its rows are cooked for ten ticks. What begins as JSON is read as a manifest.
pub fn sweep(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if text.starts_with('{') {
        return manifest(text);
    }
    if text.matches(',').count() > MOST_COMMAS {
        return;
    }
    let base = Base { recipe: RECIPE.to_owned(), file: "recipe.toml".to_owned(), ..Base::default() };
    match Sweep::new(text, "sweep.toml", base) {
        Ok(sweep) => cook(&sweep),
        Err(InputError { file, line, message, remedy }) => {
            assert!(file == "sweep.toml" && line > 0 && !message.is_empty() && !remedy.is_empty(), "{file}: {message}");
        }
    }
}

fn cook(sweep: &Sweep) {
    let m = sweep.manifest();
    assert_eq!(m.conflict(&Manifest::parse(&m.text()).expect("a manifest that was written can be read")), None);
    for row in [0, m.rows - 1] {
        assert!(sweep.part_rows(row / m.rows_per_part).contains(&row));
        let ticks = std::cell::Cell::new(0);
        let goes_on = || ticks.replace(ticks.get() + 1) < 10;
        if let Some(result) = sweep.run_row_while(row, &goes_on) {
            assert_eq!(result.varied.len() + result.numbers.len() + 6, sweep.headings().len());
        }
    }
    let again = Sweep::from_bytes(&sweep.to_bytes()).expect("bytes of a sweep").expect("it was sound");
    assert_eq!(again.manifest().hash, m.hash);
}

fn manifest(text: &str) {
    if let Ok(manifest) = Manifest::parse(text) {
        let last = manifest.rows.saturating_sub(1);
        let _ = (manifest.part_rows(last / manifest.rows_per_part), manifest.design.point(last));
    }
}
