//! Colours that the inside of beef has at temperatures of its core, to compare the model with.

/// Temperature [°C], L\*, a\*, b\* of the inside of beef that is heated in minutes. At 60 °C measured `[@fsar-2020-40-44]`, elsewhere
/// estimated, ± 3. The colours of `data/foods/beef-*.toml` are fitted to them.
pub const INSIDE_OF_BEEF: [[f64; 4]; 7] = [
    [50.0, 43.0, 20.0, 13.0],
    [55.0, 47.0, 17.5, 14.5],
    [60.0, 51.5, 14.8, 15.3],
    [65.0, 53.0, 12.0, 15.5],
    [70.0, 54.0, 10.0, 15.0],
    [75.0, 54.0, 8.0, 14.0],
    [80.0, 53.0, 7.0, 13.5],
];
