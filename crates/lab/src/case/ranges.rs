//! Ranges of the numbers of a lab case. The schema and the checks both read them; each is [least, most].

/// Duration of a case [s] (chosen: a millisecond to four months).
pub const DURATION_S: [f64; 2] = [1e-3, 1e7];
/// Time of an event or an expectation [s]; the case's own duration limits it further.
pub const TIME_S: [f64; 2] = [0.0, DURATION_S[1]];
/// Least interval of outputs and flips over the duration [-] (chosen: at most 100 000 of them).
pub const LEAST_INTERVAL: f64 = 1e-5;
/// Factor on the length of a time step [-] (chosen: steps stay stable at any length, but are meaningless beyond).
pub const STEP_FACTOR: [f64; 2] = [1e-3, 100.0];

/// Size of a body along one axis [mm] (chosen: a hundredth of a millimetre to ten metres).
pub const SIZE_MM: [f64; 2] = [0.01, 10_000.0];
/// Node spacing [mm]; the check also limits it to half the size (chosen).
pub const RESOLUTION_MM: [f64; 2] = [1e-3, 0.5 * SIZE_MM[1]];
/// Steepness of the grading [-] (chosen: at 3 the spacing at a face is a hundredth of the largest).
pub const GRADING: [f64; 2] = [0.0, 3.0];
/// Coordinate of a probe [mm]; the body limits it further (chosen: beyond any stack of bodies).
pub const AT_MM: [f64; 2] = [-1e6, 1e6];
/// Thickness of a pan [mm] (chosen).
pub const THICKNESS_MM: [f64; 2] = [0.01, 1000.0];

/// Start temperature, and boiling point [°C] (chosen).
pub const INITIAL_C: [f64; 2] = [-40.0, 1000.0];
/// Temperature outside or of a fixed surface [°C] (chosen).
pub const AMBIENT_C: [f64; 2] = [-200.0, 2000.0];
/// Temperature that a point reaches: a stop, the end of a phase, a share of the volume [°C] (chosen).
pub const REACHED_C: [f64; 2] = [-200.0, 5000.0];

/// Thermal conductivity [W/(m·K)] (chosen: below the best insulator, above diamond).
pub const CONDUCTIVITY_W_MK: [f64; 2] = [1e-4, 1e4];
/// Density [kg/m³] (chosen: below air, above osmium).
pub const DENSITY_KG_M3: [f64; 2] = [1e-2, 1e5];
/// Specific heat [J/(kg·K)] (chosen).
pub const SPECIFIC_HEAT_J_KGK: [f64; 2] = [1.0, 1e5];
/// Water that can evaporate [kg/m³] (chosen).
pub const WATER_KG_M3: [f64; 2] = [1e-3, 1e4];
/// Boiling point without another value [°C].
pub const DEFAULT_BOILING_C: f64 = 100.0;
/// Latent heat [J/kg] (chosen).
pub const LATENT_J_KG: [f64; 2] = [1.0, 1e8];
/// Latent heat of water at 100 °C [J/kg]; source: steam tables.
pub const DEFAULT_LATENT_J_KG: f64 = 2.257e6;

/// Conductance of a contact between bodies [W/(m²·K)] (chosen: insulating to perfect).
pub const CONTACT_W_M2K: [f64; 2] = [1e-3, 1e7];
/// Heat transfer coefficient of a face [W/(m²·K)] (chosen: at the upper end the surface is practically fixed).
pub const H_W_M2K: [f64; 2] = [0.0, 1e7];
/// Emissivity [-]: none to that of a black body.
pub const EMISSIVITY: [f64; 2] = [0.0, 1.0];
/// Relative humidity [%].
pub const HUMIDITY_PCT: [f64; 2] = [0.0, 100.0];
/// Heat flux [W/m²] (chosen).
pub const Q_W_M2: [f64; 2] = [-1e7, 1e7];

/// Expected value, in the quantity's unit (chosen: beyond any heat of a body of ten metres).
pub const EXPECTED: [f64; 2] = [-1e15, 1e15];
/// Tolerance of an expectation, in the quantity's unit.
pub const TOLERANCE: [f64; 2] = [0.0, EXPECTED[1]];
/// Tolerance of an expectation over its value [%] (chosen).
pub const TOLERANCE_PCT: [f64; 2] = [0.0, 1e4];
