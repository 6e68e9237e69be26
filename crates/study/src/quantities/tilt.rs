//! A tilted journal: how its axis is inclined, and the moment that the film carries.

use crate::scope::Scope;

use super::row::Measure::One;
use super::rule::ErrorRule;
use super::view::View;

rows! {
    /// `g_x`: slope of the journal's axis towards x; the offset is `e + z g` at the axial position z, 0 at mid-length;
    /// of journals that may tilt
    TILT_X = "tilt_x", "g_x", Radian, "slope of the journal's axis towards x":
        One(|film| tilt(film, 0)), ErrorRule::Position, only(|scope| scope.can_tilt);

    /// `g_y`: slope of the journal's axis towards y, likewise
    TILT_Y = "tilt_y", "g_y", Radian, "slope of the journal's axis towards y":
        One(|film| tilt(film, 1)), ErrorRule::Position, only(|scope| scope.can_tilt);

    /// `m_x = Int (p - p_e) z cos phi dA` over the developed film and the regions cut out of it, z = 0 at mid-length:
    /// the parts of `W_x` times their arms along the axis, which do work on `g_x` as W_x does on `e_x`; as a vector it
    /// would point along y; with `[contact]` and the part that contact carries; of journals that may tilt
    MOMENT_X = "moment_x", "m_x", NewtonMetre, "moment that the film carries: parts of W_x times z":
        One(|film| moment(film, 0)), ErrorRule::Moment(0), tolerance only(|scope| scope.can_tilt);

    /// `m_y = Int (p - p_e) z sin phi dA`, likewise; as a vector it would point against x
    MOMENT_Y = "moment_y", "m_y", NewtonMetre, "moment that the film carries: parts of W_y times z":
        One(|film| moment(film, 1)), ErrorRule::Moment(1), tolerance only(|scope| scope.can_tilt);

    /// `z_W = (m . W)/W^2`: axial position at which the load acts, 0 at mid-length; moments across the load remain;
    /// none without a load
    LOAD_Z = "load_z", "z_W", Metre, "axial position at which the load acts":
        One(place), ErrorRule::LoadPlace, only(|scope| scope.can_tilt);

    /// `z_h`: axial position of the thinnest film, one of several that are as thin, at an end of the bearing where
    /// journal and bore are circles; of journals that may tilt and of shapes that change along the axis
    FILM_THICKNESS_MIN_Z = "film_thickness_min_z", "z_h", Metre, "where the film is thinnest, along the axis":
        One(|film| has_place(&film.base.model.scope).then_some(film.measured.thinnest.z)), ErrorRule::LeastFilmPlace(|film| ROUNDING_OF_Z * film.problem.bearing.length), only(has_place);
}

/// Part of the length that values of a smooth film leave open about its least place: the root of rounding.
const ROUNDING_OF_Z: f64 = 1e-7;

/// Whether the film may be thinnest at one place along the axis.
fn has_place(scope: &Scope) -> bool {
    scope.can_tilt || scope.has_shape_along_the_axis
}

fn tilt(film: &View, axis: usize) -> Option<f64> {
    film.problem.can_tilt().then_some(film.journal().tilt[axis])
}

fn moment(film: &View, axis: usize) -> Option<f64> {
    film.problem.can_tilt().then_some(film.measured.load.total.moment[axis])
}

fn place(film: &View) -> Option<f64> {
    let ([m_x, m_y], [x, y]) = (film.measured.load.total.moment, film.measured.load.total.force);
    (film.problem.can_tilt() && film.is_directed).then(|| (m_x * x + m_y * y) / film.force.powi(2))
}
