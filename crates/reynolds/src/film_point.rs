//! The film at one point of the developed surface.

/// What the terms of the equation may ask of a point.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FilmPoint {
    /// Film thickness h [m].
    pub thickness: f64,
    /// `(dh/dx, dh/dz)` [-].
    pub slope: [f64; 2],
    /// `dh/dt` [m/s].
    pub rate: f64,
    /// Viscosity mu0 at zero gauge pressure [Pa s].
    pub viscosity: f64,
    /// Surface velocity `(U_x, U_z)` of the journal [m/s].
    pub velocity: [f64; 2],
}

/// What flows at a point where the pressure gradient is `grad p`: `J = flux - conductance grad p` [m2/s].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FilmFlow {
    /// Volume flow per width and pressure gradient, `h^3/(12 mu0)` [m4/(N s)].
    pub conductance: f64,
    /// Flow per width without pressure gradient [m2/s].
    pub flux: [f64; 2],
    /// Divergence of `flux` [m/s].
    pub divergence: f64,
    /// Volume that the film takes up per area and time [m/s].
    pub storage: f64,
}
