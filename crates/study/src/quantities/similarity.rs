//! Numbers without dimension by which bearings are compared.

use oilwedge_reynolds::quantities::similarity;

use super::row::Measure::One;
use super::rule::ErrorRule;
use super::view::View;

rows! {
    /// `So = W (c/R)^2/(D B mu0 omega)`, mu0 the viscosity at no pressure; that of Raimondi and Boyd is
    /// `S = 1/(2 pi So)`; none at rest
    SOMMERFELD_NUMBER = "sommerfeld_number", "So", One, "W (c/R)^2 / (D B mu0 omega)":
        One(sommerfeld_number), ErrorRule::PerLoad, tolerance;
}

fn sommerfeld_number(film: &View) -> Option<f64> {
    let viscosity = film.problem.lubricant.viscosity;
    similarity::sommerfeld_number(&film.problem.bearing, viscosity, film.journal(), film.force)
}
