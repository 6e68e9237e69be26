//! Places in the film: of the greatest pressure, of the thinnest film, and where the loaded film begins and ruptures.

use oilwedge_reynolds::Theory;
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_scene::CavitationModel;

use super::position::is_eccentric;
use super::row::Measure::One;
use super::rule::{ErrorRule, Subject};
use super::view::{View, degrees};
use crate::estimate::{Estimate, ExtentEnd};

rows! {
    /// `phi_p` in [0, 360): angle of the greatest pressure; none where that is a given pressure, as of a feed
    PRESSURE_MAX_ANGLE = "pressure_max_angle", "phi_p", Degree, "where the pressure is greatest":
        One(|film| Some(degrees(summit(film)?[0] / film.problem.bearing.radius))),
        ErrorRule::Of("difference of the two films, and of their slopes over the curvature of the pressure",
            |estimate, at| Some(Bar::of(estimate.summit()[0]).scaled(per_metre(at))));

    /// `z_p`: axial place of the greatest pressure, 0 midway between the ends; none where that is a given pressure, as
    /// of a feed, and in the theory of long bearings
    PRESSURE_MAX_Z = "pressure_max_z", "z_p", Metre, "where the pressure is greatest, along the axis":
        One(|film| (film.problem.theory != Theory::Long).then_some(summit(film)?[1])),
        ErrorRule::Of("difference of the two films, and of their slopes over the curvature of the pressure",
            |estimate, at| Some(Bar::of(axial(estimate, at))));

    /// `phi_h` in [0, 360): angle of the thinnest film on the liner, `phi_min` where the liner covers it, else that of
    /// an edge; of a tilted journal that at the end where the film is thinnest, between other surfaces one of the
    /// places that are as thin; none for a centred parallel journal between circles
    FILM_THICKNESS_MIN_ANGLE = "film_thickness_min_angle", "phi_h", Degree, "where the film on the liner is thinnest":
        One(|film| is_thinnest_somewhere(film).then(|| degrees(film.measured.thinnest.angle))),
        ErrorRule::LeastFilmPlace(|_| ROUNDING_OF_ANGLE);

    /// `phi_1` in [0, 360): upstream end of the loaded film on the mid-plane z = 0: from the greatest pressure against
    /// the rotation the first place in the cavity, at the film start or at the edge of an arc; of models with a cavity,
    /// none where the film is full all around
    FILM_START_ANGLE = "film_start_angle", "phi_1", Degree, "where the loaded film begins, at z = 0":
        One(|film| end(film, ExtentEnd::Begins)),
        ErrorRule::Of(OF_END, |estimate, at| of_end(estimate, at, ExtentEnd::Begins)),
        only(|scope| scope.cavitation != CavitationModel::None);

    /// `phi_2` in [0, 360): downstream end of the loaded film on the mid-plane z = 0, where it ruptures: from the
    /// greatest pressure with the rotation the first place in the cavity, at the film start or at the edge of an arc;
    /// of models with a cavity, none where the film is full all around
    FILM_END_ANGLE = "film_end_angle", "phi_2", Degree, "where the loaded film ruptures, at z = 0":
        One(|film| end(film, ExtentEnd::Ends)),
        ErrorRule::Of(OF_END, |estimate, at| of_end(estimate, at, ExtentEnd::Ends)),
        only(|scope| scope.cavitation != CavitationModel::None);
}

/// Angle [deg] that values of a smooth film leave open about its least place: the root of rounding.
const ROUNDING_OF_ANGLE: f64 = 2e-6;
const OF_END: &str = "difference of the two films, and half of the triangle in which the edge of the cavity lies; exact at a given line where the film converges";

/// Whether the film is not the same everywhere.
fn is_thinnest_somewhere(film: &View) -> bool {
    is_eccentric(film) || !film.journal().is_parallel() || !film.base.model.scope.is_circular
}

fn summit(film: &View) -> Option<[f64; 2]> {
    let summit = film.measured.extremes.summit;
    (!summit.is_given).then_some(summit.position)
}

/// Half width of the bar of the axial place [m]: as far as the mirror image where the pressure there may be greater.
fn axial(estimate: &dyn Estimate, at: &Subject) -> f64 {
    let summit = at.view.measured.extremes.summit;
    let is_open = summit.below_here <= estimate.greatest_pressure();
    let apart = if is_open { 2.0 * summit.position[1].abs() } else { 0.0 };
    estimate.summit()[1].max(apart)
}

fn end(film: &View, end: ExtentEnd) -> Option<f64> {
    let end = end.of(film.measured.extent.as_ref()?);
    Some(degrees(end.x / film.problem.bearing.radius))
}

fn of_end(estimate: &dyn Estimate, at: &Subject, end: ExtentEnd) -> Option<Bar> {
    Some(estimate.film_end(end)?.scaled(per_metre(at)))
}

/// Degrees for each metre around the bearing.
fn per_metre(at: &Subject) -> f64 {
    (1.0 / at.view.problem.bearing.radius).to_degrees()
}
