//! A full pan, for benchmarks and instruction counts.

/// Recipe of 35 shrimps of the default mesh that fall in five heaps.
pub const SHRIMPS: &str = r#"
title = "35 shrimps"
[pan]
initial_c = 190
[[food]]
id = "middle"
kind = "shrimp"
count = 7
seed = 1
[[food]]
id = "left"
kind = "shrimp"
count = 7
seed = 2
[[food]]
id = "right"
kind = "shrimp"
count = 7
seed = 3
[[food]]
id = "far"
kind = "shrimp"
count = 7
seed = 4
[[food]]
id = "near"
kind = "shrimp"
count = 7
seed = 5
[[step]]
hob_w = 1100
[[step]]
put = { food = "middle", at_mm = [0, 0], heap = true }
[[step]]
put = { food = "left", at_mm = [-50, 0], heap = true }
[[step]]
put = { food = "right", at_mm = [50, 0], heap = true }
[[step]]
put = { food = "far", at_mm = [0, 50], heap = true }
[[step]]
put = { food = "near", at_mm = [0, -50], heap = true }
[[step]]
after_s = 900
end = true
"#;

/// Time at which these shrimps lie [s].
pub const SHRIMPS_LIE_S: f64 = 8.0;
