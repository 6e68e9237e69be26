//! Where the journal is, and how it lies to the load.

use oilwedge_reynolds::quantities::similarity;

use super::row::{Measure::One, Row};
use super::rule::{ErrorRule, direction};
use super::unit::Unit::{Degree, Metre, One as Ratio};
use super::view::{View, degrees};

/// Attitude angle.
pub static ATTITUDE_ANGLE: Row = Row::new("attitude_angle", "beta", Degree, One(attitude_angle), ATTITUDE)
    .means(
        "from the load to the thinnest film",
        "`beta = (phi_min - phi_W) sgn omega` (+1 at rest) in (-180, 180]: from the load to the minimum film, positive for an ordinary bearing; none for a centred journal or without a load",
    )
    .tolerance()
    .headline();

/// Relative eccentricity.
pub static ECCENTRICITY: Row = Row::new("eccentricity", "eps", Ratio, One(eccentricity), ErrorRule::Position)
    .means(
        "offset of the journal / clearance",
        "`eps = e/c`: offset of the journal over the radial clearance",
    )
    .tolerance()
    .headline();

/// Angle of the minimum film.
pub static MIN_FILM_ANGLE: Row = Row::new(
    "min_film_angle",
    "phi_min",
    Degree,
    One(min_film_angle),
    ErrorRule::Position,
)
.means(
    "where the film is thinnest",
    "`phi_min = atan2(e_y, e_x)` in [0, 360); none for a centred journal",
)
.tolerance();

/// Least film thickness.
pub static FILM_THICKNESS_MIN: Row = Row::new(
    "film_thickness_min",
    "h_min",
    Metre,
    One(|film| Some(film.measured.least_thickness)),
    ErrorRule::Position,
)
.means(
    "thinnest film on the liner",
    "`h_min`: least film thickness on the liner; `c (1 - eps)` where the liner covers phi_min",
)
.tolerance()
.headline();

const ATTITUDE: ErrorRule = ErrorRule::Of(
    "that of the angle of the load and, under a load, that of the position",
    |estimate, _| Some(direction(estimate)),
);

fn is_eccentric(film: &View) -> bool {
    film.journal().eccentricity() > 0.0
}

fn attitude_angle(film: &View) -> Option<f64> {
    let angle = || similarity::attitude_angle(film.journal(), film.measured.load.angle()).to_degrees();
    (film.is_directed && is_eccentric(film)).then(angle)
}

fn eccentricity(film: &View) -> Option<f64> {
    Some(film.journal().eccentricity() / film.problem.bearing.clearance)
}

fn min_film_angle(film: &View) -> Option<f64> {
    is_eccentric(film).then(|| degrees(film.journal().min_film_angle()))
}
