//! How turbulent a film is.

use oilwedge_reynolds::error_bar::Bar;

use super::row::Measure::One;
use super::rule::ErrorRule;

rows! {
    /// Greatest `Re = rho U h/mu` of the film, at the local gap h; of scenes with `[turbulence]`
    REYNOLDS_NUMBER_MAX = "reynolds_number_max", "Re_max", One, "greatest Reynolds number of the film":
        One(|film| Some(film.measured.turbulence?.greatest)),
        ErrorRule::Of("what the gap may do between nodes; under a load that of the position", |_, at| {
            Some(Bar::of(at.view.measured.turbulence?.unsure))
        }),
        only(|scope| scope.is_turbulent);

    /// `P_s` over that of a laminar film with the same pressure: the mean of what multiplies `mu U/h`; likewise, none
    /// at rest
    TURBULENT_SHEAR = "turbulent_shear", "C_t", One, "shear of the film over that of a laminar one":
        One(|film| film.measured.turbulence?.shear),
        ErrorRule::Of("that of `friction_shear_power`, in proportion", |estimate, at| {
            Some(estimate.power([1.0, 0.0]).scaled(at.value / at.view.measured.power.shear))
        }),
        only(|scope| scope.is_turbulent);
}
