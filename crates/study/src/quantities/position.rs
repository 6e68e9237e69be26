//! Position of the journal, and its relation to the load.

use oilwedge_reynolds::quantities::similarity;

use super::row::{Headline, Measure::One};
use super::rule::{ErrorRule, direction};
use super::view::{View, degrees};

rows! {
    /// `beta = (phi_min - phi_W) sgn omega` (+1 at rest) in (-180, 180]: from the load to the line of centres, which
    /// between circles points to the thinnest film; positive for an ordinary bearing; none for a centred journal or
    /// without a load
    ATTITUDE_ANGLE = "attitude_angle", "beta", Degree, "from the load to the journal's offset":
        One(attitude_angle), ATTITUDE, tolerance headline(Headline::Always(3));

    /// `eps = e/c`: offset of the journal over the radial clearance; of a tilted one at mid-length
    ECCENTRICITY = "eccentricity", "eps", One, "offset of the journal / clearance":
        One(eccentricity), ErrorRule::Position, tolerance headline(Headline::Always(2));

    /// `phi_min = atan2(e_y, e_x)` in [0, 360): direction of the journal's offset, where the film between circles is
    /// thinnest; between other surfaces that is `film_thickness_min_angle`; of a tilted journal at mid-length; none for
    /// a centred one
    MIN_FILM_ANGLE = "min_film_angle", "phi_min", Degree, "direction of the journal's offset":
        One(min_film_angle), ErrorRule::Position, tolerance headline(Headline::Always(4));

    /// `h_min`: least film thickness on the liner; `c (1 - eps)` where the liner covers phi_min, of a tilted journal at
    /// the end where it is least
    FILM_THICKNESS_MIN = "film_thickness_min", "h_min", Metre, "thinnest film on the liner":
        One(|film| Some(film.measured.thinnest.thickness)), ErrorRule::Position, tolerance headline(Headline::Always(5));
}

const ATTITUDE: ErrorRule =
    ErrorRule::Of("that of the angle of the load and, under a load, that of the position", |estimate, _| {
        Some(direction(estimate))
    });

/// True where the journal is not centred.
pub(super) fn is_eccentric(film: &View) -> bool {
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
