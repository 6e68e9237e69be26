//! The fields of a film: their symbols, units and sentences, as files and pictures name them.

/// How a field is interpolated between its values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Interpolated by the quadratic of each triangle.
    Quadratic,
    /// Linearly on the four parts of each triangle, as the scheme has it whose oil is conserved: a quadratic would
    /// overshoot where the film breaks.
    Linear,
    /// One value for each triangle.
    Constant,
}

/// One field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldRow {
    /// Name in files.
    pub name: &'static str,
    /// Name of the field for people.
    pub label: &'static str,
    /// Symbol.
    pub symbol: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is, in a sentence.
    pub what: &'static str,
    /// How it is interpolated.
    pub interpolation: Interpolation,
}

/// Pressure.
pub static PRESSURE: FieldRow = FieldRow {
    name: "pressure",
    label: "pressure",
    symbol: "p",
    unit: "Pa",
    what: "gauge pressure of the oil, nowhere below that of a cavity",
    interpolation: Interpolation::Quadratic,
};
/// Film thickness.
pub static FILM_THICKNESS: FieldRow = FieldRow {
    name: "film_thickness",
    label: "film thickness",
    symbol: "h",
    unit: "m",
    what: "gap between journal and liner",
    interpolation: Interpolation::Quadratic,
};
/// Deflection of the wall.
pub static DEFLECTION: FieldRow = FieldRow {
    name: "deflection",
    label: "deflection",
    symbol: "delta",
    unit: "m",
    what: "how far the elastic liner gives way outwards",
    interpolation: Interpolation::Quadratic,
};
/// Film fraction.
pub static FILM_FRACTION: FieldRow = FieldRow {
    name: "film_fraction",
    label: "film fraction",
    symbol: "theta",
    unit: "1",
    what: "share of the gap that oil fills; one where the film is full",
    interpolation: Interpolation::Linear,
};
/// Viscosity.
pub static VISCOSITY: FieldRow = FieldRow {
    name: "viscosity",
    label: "viscosity",
    symbol: "mu",
    unit: "Pa.s",
    what: "dynamic viscosity at the local pressure",
    interpolation: Interpolation::Quadratic,
};
/// Reynolds number.
pub static REYNOLDS_NUMBER: FieldRow = FieldRow {
    name: "reynolds_number",
    label: "Reynolds number",
    symbol: "Re",
    unit: "1",
    what: "Reynolds number rho U h/mu of a turbulent film at the local gap",
    interpolation: Interpolation::Quadratic,
};
/// Mean temperature across the film.
pub static TEMPERATURE: FieldRow = FieldRow {
    name: "temperature",
    label: "temperature",
    symbol: "T",
    unit: "degC",
    what: "mean temperature across the film",
    interpolation: Interpolation::Linear,
};
/// Temperature at the bush.
pub static BUSH_TEMPERATURE: FieldRow = FieldRow {
    name: "temperature_at_bush",
    label: "temperature at the bush",
    symbol: "T_b",
    unit: "degC",
    what: "temperature of the film at the bore",
    interpolation: Interpolation::Linear,
};
/// Temperature at the journal.
pub static JOURNAL_TEMPERATURE: FieldRow = FieldRow {
    name: "temperature_at_journal",
    label: "temperature at the journal",
    symbol: "T_j",
    unit: "degC",
    what: "temperature of the film at the journal",
    interpolation: Interpolation::Linear,
};
/// Greatest temperature across the film.
pub static GREATEST_TEMPERATURE: FieldRow = FieldRow {
    name: "temperature_greatest",
    label: "greatest temperature",
    symbol: "T_max",
    unit: "degC",
    what: "greatest temperature across the film, walls included",
    interpolation: Interpolation::Linear,
};
/// Temperatures across the film.
pub static LAYER_TEMPERATURES: FieldRow = FieldRow {
    name: "temperature_layers [degC]",
    label: "temperature across the film",
    symbol: "T_l",
    unit: "degC",
    what: "row of the temperatures at the points across the film, from the bush to the journal",
    interpolation: Interpolation::Linear,
};
/// Pressure of contact.
pub static CONTACT_PRESSURE: FieldRow = FieldRow {
    name: "contact_pressure",
    label: "pressure of contact",
    symbol: "p_a",
    unit: "Pa",
    what: "pressure between the asperities of journal and liner, beside that of the oil",
    interpolation: Interpolation::Quadratic,
};
/// Error indicator.
pub static ERROR_INDICATOR: FieldRow = FieldRow {
    name: "error_indicator",
    label: "error indicator",
    symbol: "eta",
    unit: "N",
    what: "contribution of each triangle to the error of the load",
    interpolation: Interpolation::Constant,
};
/// Angle on the liner.
pub static ANGLE: FieldRow = FieldRow {
    name: "phi [deg]",
    label: "angle",
    symbol: "phi",
    unit: "deg",
    what: "angle of the place on the liner, from x towards y",
    interpolation: Interpolation::Quadratic,
};
/// Place along the axis.
pub static AXIAL_PLACE: FieldRow = FieldRow {
    name: "z [m]",
    label: "place along the axis",
    symbol: "z",
    unit: "m",
    what: "place on the liner along the axis, zero midway between the ends",
    interpolation: Interpolation::Quadratic,
};
/// Volume flow.
pub static VOLUME_FLOW: FieldRow = FieldRow {
    name: "volume_flow [m2/s]",
    label: "volume flow",
    symbol: "q",
    unit: "m2/s",
    what: "vector of the volume flow per width, theta U h/2 - h^3/(12 mu) grad p; with [roughness] h_T for the first h, and phi_p before the second term; with [turbulence] k_x and k_z for 12",
    interpolation: Interpolation::Quadratic,
};
/// Shear stress on the journal.
pub static JOURNAL_STRESS: FieldRow = FieldRow {
    name: "shear_stress_journal [Pa]",
    label: "shear stress on the journal",
    symbol: "tau_j",
    unit: "Pa",
    what: "vector of the force per area that the oil exerts on the journal along its surface; it acts against the rotation",
    interpolation: Interpolation::Quadratic,
};
/// Shear stress on the bearing.
pub static BEARING_STRESS: FieldRow = FieldRow {
    name: "shear_stress_bearing [Pa]",
    label: "shear stress on the bearing",
    symbol: "tau_b",
    unit: "Pa",
    what: "vector of the force per area that the oil exerts on the bearing along its surface",
    interpolation: Interpolation::Quadratic,
};

/// The fields that are drawn, in the order of pictures.
pub static FIELDS: [&FieldRow; 12] = [
    &PRESSURE,
    &FILM_THICKNESS,
    &DEFLECTION,
    &FILM_FRACTION,
    &VISCOSITY,
    &REYNOLDS_NUMBER,
    &TEMPERATURE,
    &GREATEST_TEMPERATURE,
    &BUSH_TEMPERATURE,
    &JOURNAL_TEMPERATURE,
    &CONTACT_PRESSURE,
    &ERROR_INDICATOR,
];

/// The fields of `film.vtu` that are not drawn.
static UNDRAWN: [&FieldRow; 6] =
    [&ANGLE, &AXIAL_PLACE, &VOLUME_FLOW, &JOURNAL_STRESS, &BEARING_STRESS, &LAYER_TEMPERATURES];

/// All fields of `film.vtu`.
pub fn file_fields() -> impl Iterator<Item = &'static FieldRow> {
    FIELDS.into_iter().chain(UNDRAWN)
}

/// The row of a field that is drawn.
pub fn field(name: &str) -> Option<&'static FieldRow> {
    FIELDS.into_iter().find(|row| row.name == name)
}
