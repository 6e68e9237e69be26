//! The rigid rotor on the film: when it whirls.

use oilwedge_bearing::dynamics::whirling;
use oilwedge_bearing::{Coefficients, Stability, Threshold, stability};
use oilwedge_reynolds::error_bar::Bar;

use super::coefficients::is_asked;
use super::row::{Measure::One, Table};
use super::rule::{ErrorRule, Subject};
use super::view::View;
use crate::estimate::Estimate;

rows! {
    /// `M_crit = k/omega_w^2`: the greatest mass for each bearing of a rigid rotor that is stable, its journals
    /// parallel to themselves; with `jfo` by K and C at the frequency of its own whirl; none where the rotor is stable,
    /// or unstable, with any mass
    CRITICAL_MASS = "critical_mass", "M_crit", Kilogram, "greatest mass of a stable rigid rotor, for this bearing":
        One(|film| Some(threshold(judged(film)?)?.mass)),
        ErrorRule::Of(RULE, |estimate, at| bar(estimate, |of| Some(threshold(of)?.mass), at)), in_table(Table::Dynamics) only(is_asked);

    /// `nu_w = omega_w/|omega|`: frequency of the whirl of that rotor over the speed; none where there is no such whirl
    WHIRL_RATIO = "whirl_ratio", "nu_w", One, "frequency of whirl at that mass over the speed":
        One(|film| ratio(judged(film)?, film)),
        ErrorRule::Of(RULE, |estimate, at| bar(estimate, |of| ratio(of, at.view), at)), in_table(Table::Dynamics) only(is_asked);

    /// `delta = -2 pi Re s/|Im s|` of the least damped whirl, root s of a rigid rotor of the mass `dynamics.mass`;
    /// negative: the whirl grows; with `jfo` by the same K and C as M_crit; none where all motions creep
    LOGARITHMIC_DECREMENT = "logarithmic_decrement", "delta", One, "logarithmic decrement of the rotor of the given mass":
        One(|film| decrement(judged(film)?, film)),
        ErrorRule::Of(RULE, |estimate, at| bar(estimate, |of| decrement(of, at.view), at)),
        in_table(Table::Dynamics) only(|scope| scope.dynamics.as_ref().is_some_and(|asked| asked.mass.is_some()));
}

const RULE: &str = "those of K and C, each part of which moves it: the root of the sum of squares";

fn judged<'a>(film: &'a View) -> Option<&'a Coefficients> {
    let dynamics = film.measured.dynamics()?;
    (dynamics.stability != Stability::Undetermined).then_some(&dynamics.judged.coefficients)
}

fn threshold(of: &Coefficients) -> Option<Threshold> {
    match stability(of) {
        Stability::Below(threshold) => Some(threshold),
        Stability::Always | Stability::Never | Stability::Undetermined => None,
    }
}

fn ratio(of: &Coefficients, film: &View) -> Option<f64> {
    let speed = film.journal().speed.abs();
    Some(threshold(of)?.frequency / speed).filter(|ratio| ratio.is_finite())
}

fn decrement(of: &Coefficients, film: &View) -> Option<f64> {
    let mass = film.base.model.sockets.dynamics.as_ref()?.mass?;
    Some(whirling(of, mass)?.decrement)
}

/// What the errors of all coefficients make of a number; none where one of them takes it away.
fn bar(estimate: &dyn Estimate, number: impl Fn(&Coefficients) -> Option<f64>, at: &Subject) -> Option<Bar> {
    let errors = estimate.judged_coefficients()?;
    let own = judged(at.view)?;
    let change = |part: &Coefficients| {
        let [less, more] = [-1.0, 1.0].map(|sign| number(&own.plus(&part.scaled(sign))));
        Some((less? - at.value).hypot(more? - at.value) * std::f64::consts::FRAC_1_SQRT_2)
    };
    Some(Bar::of(errors.bar(change)?))
}
