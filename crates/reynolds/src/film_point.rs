//! The film at one point of the developed surface.

use crate::EddyFactors;

/// What the terms of the equation may ask of a point.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FilmPoint {
    /// Film thickness h [m].
    pub thickness: f64,
    /// `(dh/dx, dh/dz)` [-].
    pub slope: [f64; 2],
    /// `dh/dt` [m/s].
    pub rate: f64,
    /// Viscosity mu0 at zero gauge pressure, by which pressure drives oil [Pa s].
    pub viscosity: f64,
    /// Viscosity at zero gauge pressure that the shear of the whole gap meets [Pa s]; another one than `viscosity`
    /// where the temperature varies across the film.
    pub shear_viscosity: f64,
    /// Mean velocity of the oil that the journal drags along, over that of its surface [1]: a half where the viscosity
    /// does not vary across the film.
    pub drag: f64,
    /// Surface velocity `(U_x, U_z)` of the journal [m/s].
    pub velocity: [f64; 2],
    /// What eddies make of the flow where the temperature varies across a turbulent film; else none.
    pub eddies: Option<EddyFactors>,
}

/// What flows at a point where the pressure gradient is `grad p`: `J_d = flux_d - conductance_d dp/dx_d` [m2/s].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FilmFlow {
    /// Volume flow per width and pressure gradient along x and along z, `h^3/(12 mu0)` [m4/(N s)] in a laminar film.
    pub conductance: [f64; 2],
    /// Flow per width without pressure gradient [m2/s].
    pub flux: [f64; 2],
    /// Divergence of `flux` [m/s].
    pub divergence: f64,
    /// Volume that the film takes up per area and time [m/s].
    pub storage: f64,
}

impl FilmFlow {
    /// Conductance along x, and the parts of it that count along x and along z where those of its own axis are `along`.
    pub(crate) fn parts(&self, along: [f64; 2]) -> (f64, [f64; 2]) {
        let [k_x, k_z] = self.conductance;
        (k_x, [along[0], k_z / k_x * along[1]])
    }
}

/// Thickness [m] at which a surface of the `velocity` U [m/s] drags a full film along as the flux F [m2/s]:
/// `2 F.U/U^2`; zero at rest.
pub(crate) fn dragged_thickness(velocity: [f64; 2], flux: [f64; 2]) -> f64 {
    let square = velocity[0] * velocity[0] + velocity[1] * velocity[1];
    match square > 0.0 {
        true => 2.0 * (flux[0] * velocity[0] + flux[1] * velocity[1]) / square,
        false => 0.0,
    }
}
