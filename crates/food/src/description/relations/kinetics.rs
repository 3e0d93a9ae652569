//! Relations in kinetics files.

use crate::description::Kinetics;

use saute_schema::{DataFile, Format, LibraryError};

/// Largest contraction of a length that complete changes may add up to [-] (chosen: tissue does not shrink by half).
const MOST_CONTRACTION: f64 = 0.5;

/// Least elastic modulus of flesh [kPa] (chosen: softer than any food that keeps its shape).
const LEAST_MODULUS_KPA: f64 = 0.01;

impl Format for Kinetics {
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError> {
        curves(self, file)?;
        contraction(self, file)?;
        modulus(self, file)?;
        names(self, file)
    }
}

/// Curves have two or more ascending points with a value each.
fn curves(kinetics: &Kinetics, file: &DataFile) -> Result<(), LibraryError> {
    let (release, browning) = (&kinetics.fat_release, &kinetics.browning);
    let curves = [
        ("fat_release", "celsius", &release.celsius, &release.rate_per_s),
        ("browning", "activity", &browning.activity, &browning.factor),
    ];
    for (table, key, xs, ys) in curves {
        if xs.len() < 2 || xs.len() != ys.len() || !xs.is_sorted_by(|a, b| a < b) {
            let message =
                format!("[{table}] {key} needs two or more ascending numbers, and as many values beside them");
            return Err(file.error(&format!("{table}.{key}"), message));
        }
    }
    Ok(())
}

/// Neither direction contracts by more than half.
fn contraction(kinetics: &Kinetics, file: &DataFile) -> Result<(), LibraryError> {
    for (key, table) in [("across", &kinetics.shrinkage.across), ("along", &kinetics.shrinkage.along)] {
        if !(0.0..=MOST_CONTRACTION).contains(&table.values().sum::<f64>()) {
            let message = format!("[shrinkage] {key} adds up to more than {MOST_CONTRACTION} or less than 0");
            return Err(file.error(&format!("shrinkage.{key}"), message));
        }
    }
    Ok(())
}

/// The elastic modulus stays positive however the changes combine.
fn modulus(kinetics: &Kinetics, file: &DataFile) -> Result<(), LibraryError> {
    let texture = &kinetics.texture;
    let softest = texture.raw_kpa + texture.change_kpa.values().filter(|v| **v < 0.0).sum::<f64>();
    if softest >= LEAST_MODULUS_KPA {
        return Ok(());
    }
    let message =
        format!("[texture] change_kpa makes the modulus smaller than {LEAST_MODULUS_KPA} kPa: use smaller decreases");
    Err(file.error("texture.change_kpa", message))
}

/// Every table names only changes of the file.
fn names(kinetics: &Kinetics, file: &DataFile) -> Result<(), LibraryError> {
    let named = [
        ("shrinkage", "across", &kinetics.shrinkage.across),
        ("shrinkage", "along", &kinetics.shrinkage.along),
        ("water_holding", "change", &kinetics.water_holding.change),
        ("texture", "change_kpa", &kinetics.texture.change_kpa),
        ("hardness", "change", &kinetics.hardness.change),
        ("juiciness", "change", &kinetics.juiciness.change),
    ];
    let curl = kinetics.curl.iter().map(|c| ("curl", "change", &c.change));
    for (table, key, values) in named.into_iter().chain(curl) {
        kinetics.in_order(table, values).map_err(|e| file.error(&format!("{table}.{key}"), e.to_string()))?;
    }
    Ok(())
}
