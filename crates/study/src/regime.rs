//! Whether a film is what it was computed as: thin, laminar, without inertia, continuous, between smooth and rigid
//! surfaces, and of an oil whose viscosity law holds.
//!
//! The laminar film ends with Taylor's vortices at `Re = rho U c/mu = 41.3 sqrt(R/c)` (Taylor, Phil. Trans. A 223
//! (1923) 289; the limit of ISO 7902-1); inertia counts where `Re c/R` is about one (Szeri, Fluid Film Lubrication
//! (1998), ch. 5); surfaces touch where the film is below three times their combined roughness (Hamrock, Schmid,
//! Jacobson (2004), ch. 3).

use oilwedge_reynolds::Bearing;
use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::density::MINERAL_OIL;
use serde::{Deserialize, Serialize};

use crate::film::Film;
use crate::measure::Measured;
use crate::oil::Oil;
use crate::thermal::flows::leaving;
use crate::warning::{self, Warning};
use oilwedge_scene::wording::micrometres;

/// Clearance over radius of a film that curvature does not touch.
pub const THIN: f64 = 1e-2;
/// Clearances below this part of the radius are narrower than surfaces and temperatures allow.
const NARROW: f64 = 1e-4;
/// Film over roughness of surfaces that do not touch.
pub const APART: f64 = 3.0;
/// Film [m] of some ten molecules.
const MOLECULES: f64 = 1e-8;
/// Pressure [Pa] at which a mineral oil (alpha 2e-8 1/Pa) is 2.7 times as viscous as at none.
const CONSTANT: f64 = 5e7;
/// Rise of temperature [K] at which a mineral oil loses a third of its viscosity in the mean.
const WARM: f64 = 25.0;
/// Heat capacity per volume [J/(m3 K)] of mineral oil.
const HEAT_CAPACITY: f64 = 1.8e6;
/// A flow below this part of what the journal drags along is rounding.
const NOTHING: f64 = 1e-9;
/// Young's modulus [Pa] and Poisson's ratio [1] of steel.
const STEEL: [f64; 2] = [2.1e11, 0.3];
/// Mean deflection of a square on a half space under an even pressure, over `(1 - nu^2) F/(E a)` with its side a
/// (Timoshenko, Goodier, Theory of Elasticity (1970), art. 139).
const OF_SQUARE: f64 = 0.95;
/// Pressure [Pa] at which hard steel yields.
const YIELDING: f64 = 2e9;

/// Numbers by which assumptions are judged.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Regime {
    /// `Re = rho U c/mu` [1].
    pub reynolds_number: f64,
    /// `41.3 sqrt(R/c)` [1]: Reynolds number at which Taylor's vortices begin.
    pub taylor_limit: f64,
    /// `Re c/R` [1]: inertia over friction.
    pub inertia: f64,
    /// Density [kg/m3] that these were computed with.
    pub density: f64,
    /// `c/R` [1].
    pub clearance_ratio: f64,
    /// `alpha p_max` [1], `alpha` the relative growth of viscosity at no pressure; `None` for a constant viscosity.
    pub pressure_exponent: Option<f64>,
    /// Least film thickness over roughness [1]; `None` where the scene gives no roughness.
    pub roughness_ratio: Option<f64>,
    /// Elastic deflection of journal and liner [m], each a half space of `bearing.elastic_modulus` that carries the
    /// load on a square under half of the greatest pressure: `2 x 0.95 (1 - nu^2)/E sqrt(W p_max/2)`.
    pub deflection: f64,
    /// How much hotter [K] friction would make the oil that leaves than that which is fed, if all heat left with it;
    /// `None` where no oil leaves or nothing turns.
    pub temperature_rise: Option<f64>,
}

/// The warning that the clearance is far from a thousandth of the radius, as it is in bearings.
pub fn unusual_clearance(bearing: &Bearing) -> Option<Warning> {
    let ratio = bearing.clearance / bearing.radius;
    let written = format!("the clearance, {}, is {} of the radius", micrometres(bearing.clearance), rounded(ratio));
    if ratio > THIN {
        return Some(warning::CURVED.says(format!("thin film: {written}, so its curvature counts, which Reynolds' equation drops; is the unit of bearing.clearance right?")));
    }
    (ratio < NARROW).then(|| warning::NARROW.says(format!("usual clearance: {written}, and journals run with about a thousandth; is the unit of bearing.clearance right?")))
}

impl Regime {
    /// The numbers of a solved film; the density is that of `oil`.
    pub fn of(oil: &Oil, film: &Film, measured: &Measured) -> Self {
        let problem = &film.problem;
        let bearing = &problem.bearing;
        let speed = problem.journal.speed.abs() * bearing.radius;
        let density = oil.film_density().unwrap_or(MINERAL_OIL);
        let reynolds_number = density * speed * bearing.clearance / problem.lubricant.viscosity;
        let clearance_ratio = bearing.clearance / bearing.radius;
        Self {
            reynolds_number,
            taylor_limit: 41.3 / clearance_ratio.sqrt(),
            inertia: reynolds_number * clearance_ratio,
            density,
            clearance_ratio,
            pressure_exponent: growth(&problem.lubricant.pressure_law).map(|alpha| alpha * measured.extremes.greatest),
            roughness_ratio: (film.model.roughness).map(|roughness| measured.thinnest.thickness / roughness),
            deflection: deflection(film, measured),
            temperature_rise: temperature_rise(film, measured),
        }
    }

    /// Assumptions that this film breaks, in sentences that name them.
    pub fn warnings(&self, film: &Film, measured: &Measured) -> Vec<Warning> {
        let pressure = measured.extremes.greatest;
        let flow = format!("Reynolds number {} at {:.0} kg/m3", rounded(self.reynolds_number), self.density);
        let broken = [
            (self.reynolds_number > self.taylor_limit && film.problem.is_laminar()).then(|| {
                warning::TURBULENT.says(format!("laminar film: {flow} lies above {}, where Taylor's vortices begin; friction and flow will be others; give [turbulence]", rounded(self.taylor_limit)))
            }),
            (self.inertia > 1.0 && self.reynolds_number <= self.taylor_limit).then(|| {
                warning::INERTIA.says(format!("film without inertia: {flow}, times c/R, is {}, but should be well below 1", rounded(self.inertia)))
            }),
            unusual_clearance(&film.problem.bearing),
            (measured.thinnest.thickness < MOLECULES).then(|| {
                warning::MOLECULAR.says(format!("continuous film: it is {} m thin, some molecules; no oil is a fluid there", rounded(measured.thinnest.thickness)))
            }),
            self.roughness_ratio.filter(|ratio| film.problem.contact.is_none() && *ratio < APART).map(|ratio| {
                warning::TOUCHING.says(format!("smooth surfaces: the least film is {} times bearing.roughness, below {APART} times; the surfaces touch there; give [contact]", rounded(ratio)))
            }),
            (measured.deflection.is_none() && self.deflection > measured.thinnest.thickness && pressure <= YIELDING).then(|| {
                let micrometres = |length: f64| rounded(1e6 * length);
                warning::ELASTIC.says(format!("rigid surfaces: the pressure, up to {} bar, would deflect journal and liner by some {} um, but the least film has {} um; the film adapts, and its pressure will be lower; give [liner] for the wall of the bearing, or bearing.elastic_modulus if it is not of steel", readable(1e-5 * pressure), micrometres(self.deflection), micrometres(measured.thinnest.thickness)))
            }),
            (pressure > YIELDING).then(|| {
                warning::YIELDING.says(format!("rigid surfaces: the pressure reaches {} bar, at which any steel yields ({} bar); no bearing carries this load, check it and its unit", rounded(1e-5 * pressure), rounded(1e-5 * YIELDING)))
            }),
        ];
        let rise = self.temperature_rise.filter(|rise| !film.model.sockets.finds_temperature() && *rise > WARM);
        let heated = rise.map(|rise| {
            warning::WARMED.says(format!("a film as warm as its oil is fed: friction would heat the oil that flows through by some {} K, and the viscosity is that of another temperature; check that oil.viscosity (or oil.temperature) is that of the film, or give [heat] with a grade or another law of temperature", rounded(rise)))
        });
        broken.into_iter().chain([heated]).flatten().map(broken_assumption).collect()
    }
}

/// Relative growth [1/Pa] of viscosity at no pressure; `None` where it does not depend on pressure.
fn growth(law: &PressureLaw) -> Option<f64> {
    (!matches!(law, PressureLaw::Constant)).then(|| law.viscosity_slope(0.0))
}

/// How a warning about an assumption that does not hold begins.
const BROKEN: &str = "an assumption does not hold: ";

/// A warning about an assumption that does not hold.
pub(crate) fn broken_assumption(assumption: Warning) -> Warning {
    (assumption.kind).says(format!("{BROKEN}{assumption}"))
}

/// How many of these warnings are about assumptions that do not hold.
pub fn broken_assumptions(warnings: &[Warning]) -> usize {
    warnings.iter().filter(|warning| warning.starts_with(BROKEN)).count()
}

/// The warning that the pressure of a film lies beyond the `limit` [Pa] to which a law of viscosity holds, if so.
pub(crate) fn beyond_pressure(measured: &Measured, limit: f64, law: &str, way_out: &str) -> Vec<Warning> {
    let (pressure, bar) = (measured.extremes.greatest, |pascal: f64| readable(1e-5 * pascal));
    let warning = || {
        broken_assumption(warning::VISCOSITY_LAW.says(format!(
            "{law}: the pressure reaches {} bar, beyond the {} bar to which it holds for mineral oils; {way_out}",
            bar(pressure),
            bar(limit)
        )))
    };
    Vec::from_iter((pressure > limit).then(warning))
}

/// The warning that a pressure is so high that a viscosity without a law of pressure does not hold.
pub(crate) fn constant_viscosity(film: &Film, measured: &Measured) -> Vec<Warning> {
    let law = "a viscosity that does not depend on pressure";
    match film.problem.lubricant.pressure_law {
        PressureLaw::Constant => beyond_pressure(measured, CONSTANT, law, "give a law of pressure under [oil]"),
        _ => Vec::new(),
    }
}

/// How far journal and liner yield elastically under the load [m].
fn deflection(film: &Film, measured: &Measured) -> f64 {
    let [steel, poisson] = STEEL;
    let modulus = film.model.elastic_modulus.unwrap_or(steel);
    let mean_pressure = 0.5 * measured.extremes.greatest.max(0.0);
    2.0 * OF_SQUARE * (1.0 - poisson * poisson) / modulus * (measured.load.magnitude() * mean_pressure).sqrt()
}

/// Friction and power of a moving centre over the heat that the oil which leaves takes up for each kelvin.
fn temperature_rise(film: &Film, measured: &Measured) -> Option<f64> {
    let capacity = film.model.sockets.thermal.map_or(HEAT_CAPACITY, |model| model.balance.heat_capacity);
    let Film { problem, system, .. } = film;
    let (bearing, journal) = (&problem.bearing, &problem.journal);
    let flow = leaving(problem, system, &measured.flows);
    let dragged = 0.5 * (journal.speed * bearing.radius).abs() * bearing.clearance * bearing.length;
    let rise = (measured.power.friction() + measured.motion_power(journal)) / (capacity * flow);
    (dragged > 0.0 && flow > NOTHING * dragged && rise >= 0.0).then_some(rise)
}

/// Two significant digits.
pub(crate) fn rounded(value: f64) -> String {
    readable(format!("{value:.1e}").parse().unwrap_or(value))
}
