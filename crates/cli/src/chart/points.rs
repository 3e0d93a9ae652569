//! Points: small circles at values.

/// Returns the point of a curve, in the colour of its class, at a position [px].
pub fn on_curve(class: &str, [x, y]: [f64; 2]) -> String {
    format!("<circle class=\"curve {class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\"/>")
}

/// Returns a ring at a position [px].
pub fn ring([x, y]: [f64; 2]) -> String {
    format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"none\" stroke=\"#222\"/>")
}

/// Returns a filled point at a position [px].
pub fn dot(colour: &str, [x, y]: [f64; 2]) -> String {
    format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\" fill=\"{colour}\"/>")
}
