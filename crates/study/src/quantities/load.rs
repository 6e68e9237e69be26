//! The load that a film carries.

use oilwedge_reynolds::quantities::load::Share;
use oilwedge_reynolds::quantities::similarity;
use oilwedge_scene::Scene;

use super::row::{Measure::Each, Measure::One, Row};
use super::rule::ErrorRule;
use super::unit::Unit::{Degree, Newton, One as Ratio};
use super::view::{View, degrees};

/// Magnitude of the load.
pub static LOAD: Row = Row::new("load", "W", Newton, One(|film| Some(film.force)), ErrorRule::Load)
    .means(
        "force that the film carries",
        "`W = sqrt(W_x^2 + W_y^2)`: the external force on the journal that the film carries; the film pushes the journal with -W",
    )
    .tolerance()
    .headline();

/// Load along x.
pub static LOAD_X: Row = Row::new("load_x", "W_x", Newton, One(|film| Some(force(film)[0])), TOWARDS_X)
    .means(
        "its part along x (angle 0)",
        "`W_x = Int (p - p_e) cos phi dA` over the developed film and the regions cut out of it; p_e the pressure at the ends",
    )
    .tolerance();

/// Load along y.
pub static LOAD_Y: Row = Row::new("load_y", "W_y", Newton, One(|film| Some(force(film)[1])), TOWARDS_Y)
    .means(
        "its part along y (angle 90 deg)",
        "`W_y = Int (p - p_e) sin phi dA`, likewise",
    )
    .tolerance();

/// Angle of the load.
pub static LOAD_ANGLE: Row = Row::new("load_angle", "phi_W", Degree, One(angle), ErrorRule::LoadAngle)
    .means(
        "its direction, from x towards y",
        "`phi_W = atan2(W_y, W_x)` in [0, 360); none without a load",
    )
    .tolerance();

/// Load coefficient.
pub static LOAD_COEFFICIENT: Row =
    Row::new("load_coefficient", "C_w", Ratio, One(load_coefficient), ErrorRule::PerLoad)
        .means(
            "W / (D B (p_feed - p_ends))",
            "`C_w = W/(D B (p_s - p_e))`, p_s the pressure of the feeds; none without feeds, or with feeds of different pressures",
        )
        .tolerance()
        .only(is_fed);

/// Integral of the pressure.
pub static PRESSURE_INTEGRAL: Row = Row::new(
    "pressure_integral",
    "Int p dA",
    Newton,
    One(|film| Some(film.measured.load.total.pressure)),
    ErrorRule::Of("dual-weighted", |estimate, _| Some(estimate.pressure_integral())),
)
.means(
    "pressure times area, summed",
    "`Int p dA` over the liner, regions cut out of it included",
)
.tolerance();

/// Load along x over regions cut out.
pub static REGION_LOAD_X: Row = Row::new(
    "load_x.",
    "W_x",
    Newton,
    Each(|film| cut_out(film, 0)),
    ErrorRule::Exact,
)
.means(
    "part of W_x over that region",
    "the part of `W_x` over a region that is cut out of the mesh; none where nothing is cut out",
)
.only(is_fed);

/// Load along y over regions cut out.
pub static REGION_LOAD_Y: Row = Row::new(
    "load_y.",
    "W_y",
    Newton,
    Each(|film| cut_out(film, 1)),
    ErrorRule::Exact,
)
.means(
    "part of W_y over that region",
    "the part of `W_y` over a region that is cut out of the mesh; none where nothing is cut out",
)
.only(is_fed);

const TOWARDS_X: ErrorRule = ErrorRule::Component(|_| Some([1.0, 0.0]));
const TOWARDS_Y: ErrorRule = ErrorRule::Component(|_| Some([0.0, 1.0]));

fn force(film: &View) -> [f64; 2] {
    film.measured.load.total.force
}

fn angle(film: &View) -> Option<f64> {
    film.is_directed.then(|| degrees(film.measured.load.angle()))
}

fn load_coefficient(film: &View) -> Option<f64> {
    similarity::load_coefficient(&film.problem.bearing, film.study.supply_pressure?, film.force)
}

fn cut_out(film: &View, axis: usize) -> Vec<(String, f64)> {
    let part = |(name, share): &(String, Share)| (name.clone(), share.force[axis]);
    film.measured.load.cut_out.iter().map(part).collect()
}

/// True if a feed of the scene has a pressure.
pub(super) fn is_fed(scene: &Scene) -> bool {
    scene.feeds.iter().any(|feed| feed.pressure.is_some())
}
