//! The load that a film carries.

use oilwedge_reynolds::quantities::load::Share;
use oilwedge_reynolds::quantities::similarity;

use super::row::{Headline, Measure::Each, Measure::One};
use super::rule::ErrorRule;
use super::view::{View, degrees};

rows! {
    /// `W = sqrt(W_x^2 + W_y^2)`: the external force on the journal that the film carries; the film pushes the journal
    /// with -W
    LOAD = "load", "W", Newton, "force on the journal that the film carries":
        One(|film| Some(film.force)), ErrorRule::Load, tolerance headline(Headline::AtPosition(1));

    /// `W_x = Int (p - p_e) cos phi dA` over the developed film and the regions cut out of it; p_e the pressure at the
    /// ends; with `[contact]` and the part that contact carries
    LOAD_X = "load_x", "W_x", Newton, "part of W along x (angle 0)":
        One(|film| Some(force(film)[0])), TOWARDS_X, tolerance;

    /// `W_y = Int (p - p_e) sin phi dA`, likewise
    LOAD_Y = "load_y", "W_y", Newton, "part of W along y (angle 90 deg)":
        One(|film| Some(force(film)[1])), TOWARDS_Y, tolerance;

    /// `phi_W = atan2(W_y, W_x)` in [0, 360); none without a load
    LOAD_ANGLE = "load_angle", "phi_W", Degree, "direction of W, from x towards y":
        One(angle), ErrorRule::LoadAngle, tolerance;

    /// `p_m = W/(D B)`: load over the projected area of the bearing
    SPECIFIC_LOAD = "specific_load", "p_m", Pascal, "specific load, W / (D B)":
        One(|film| Some(film.force / projected_area(film))), ErrorRule::PerLoad, headline(Headline::Always(7));

    /// `C_w = W/(D B (p_s - p_e))`, p_s the pressure of the feeds; none without feeds, or with feeds of different
    /// pressures
    LOAD_COEFFICIENT = "load_coefficient", "C_w", One, "W / (D B (p_feed - p_ends))":
        One(load_coefficient), ErrorRule::PerLoad, tolerance only(|scope| scope.is_fed);

    /// `Int p dA` over the liner, regions cut out of it included; contact is no pressure of the oil
    PRESSURE_INTEGRAL = "pressure_integral", "Int p dA", Newton, "pressure times area, summed":
        One(|film| Some(film.measured.load.of_oil().pressure)),
        ErrorRule::Of("dual-weighted", |estimate, _| Some(estimate.pressure_integral())), tolerance;

    /// The part of `W_x` over a region that is cut out of the mesh; none where nothing is cut out
    REGION_LOAD_X = "load_x.", "W_x", Newton, "part of W_x over the region":
        Each(|film| cut_out(film, 0)), ErrorRule::Rim, only(|scope| scope.is_fed);

    /// The part of `W_y` over a region that is cut out of the mesh; none where nothing is cut out
    REGION_LOAD_Y = "load_y.", "W_y", Newton, "part of W_y over the region":
        Each(|film| cut_out(film, 1)), ErrorRule::Rim, only(|scope| scope.is_fed);
}

const TOWARDS_X: ErrorRule = ErrorRule::Component(|_| Some([1.0, 0.0]));
const TOWARDS_Y: ErrorRule = ErrorRule::Component(|_| Some([0.0, 1.0]));

/// Diameter times length [m2].
fn projected_area(film: &View) -> f64 {
    2.0 * film.problem.bearing.radius * film.problem.bearing.length
}

fn force(film: &View) -> [f64; 2] {
    film.measured.load.total.force
}

fn angle(film: &View) -> Option<f64> {
    film.is_directed.then(|| degrees(film.measured.load.angle()))
}

fn load_coefficient(film: &View) -> Option<f64> {
    similarity::load_coefficient(&film.problem.bearing, film.base.supply_pressure()?, film.force)
}

fn cut_out(film: &View, axis: usize) -> Vec<(String, f64)> {
    let part = |(name, share): &(String, Share)| (name.clone(), share.force[axis]);
    film.measured.load.cut_out.iter().map(part).collect()
}
