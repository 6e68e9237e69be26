//! The errors of a mass-conserving film, estimated by its coarse comparison on the vertices alone.

use oilwedge_bearing::{Coefficients, Dynamics};
use oilwedge_reynolds::error_bar::conserving::ConservingError;
use oilwedge_reynolds::error_bar::{Bar, FlowGoal};

use super::{CoefficientErrors, Estimate, ExtentEnd, Scaled};
use crate::film::Film;
use crate::measure::Measured;

/// A mass-conserving film beside its coarse comparison.
pub(super) struct CoarseComparison<'a> {
    pub(super) film: &'a Film,
    pub(super) error: &'a ConservingError,
    pub(super) measured: &'a Measured,
    /// How the coarse film answers to small motions, at the frequencies of the film; none where that is not asked.
    pub(super) dynamics: Option<Dynamics>,
    /// Share of the area [1] in which a cavity may hide where the mesh shows none.
    pub(super) hidden: f64,
}

/// Part of the difference of the tangents of film and coarse comparison that the film is off by at most; measured.
const OF_TANGENTS: f64 = 2.5;

impl Estimate for CoarseComparison<'_> {
    fn is_resolved(&self) -> bool {
        self.error.is_resolved
    }

    fn force(&self) -> f64 {
        self.measured.load.magnitude().max(f64::MIN_POSITIVE)
    }

    fn load(&self) -> Bar {
        self.error.load
    }

    fn across(&self) -> Option<Bar> {
        (self.error.across.total() < self.force()).then_some(self.error.across)
    }

    fn product(&self, [x, y]: [f64; 2]) -> Bar {
        self.error.force[0].scaled(x) + self.error.force[1].scaled(y)
    }

    fn moment(&self) -> Option<[Bar; 2]> {
        self.error.moment
    }

    fn pressure_integral(&self) -> Bar {
        self.error.pressure_integral
    }

    fn greatest_pressure(&self) -> f64 {
        self.error.greatest_pressure
    }

    /// Bar of the least pressure: none where there is a cavity, whose pressure is given.
    fn least_pressure(&self) -> Bar {
        match self.measured.cavity.is_some_and(|cavity| cavity.share > 0.0) {
            true => Bar::default(),
            false => Bar::of(self.error.pressure),
        }
    }

    fn flow(&self, goal: &FlowGoal, number: Scaled) -> Option<Bar> {
        let error = match goal {
            FlowGoal::Ends => self.error.side_flow,
            FlowGoal::Region(name) => {
                let mut regions = self.film.system.supply.regions().iter();
                *self.error.flows.get(regions.position(|region| region.name == *name)?)?
            }
        };
        Some(Bar::of(error / number.unit))
    }

    fn inlet_flow(&self, number: Scaled) -> f64 {
        self.error.inlet_flow / number.unit
    }

    fn cavity_flow(&self, _: f64) -> Option<Bar> {
        None
    }

    fn power(&self, parts: [f64; 2]) -> Bar {
        Bar::of(self.error.power(parts))
    }

    fn cavity_power(&self, _: f64) -> Option<Bar> {
        None
    }

    fn cavity_share(&self, _: f64) -> f64 {
        match self.measured.cavity {
            Some(cavity) if cavity.share == 0.0 => self.error.cavity_share + self.hidden,
            _ => self.error.cavity_share,
        }
    }

    fn least_fraction(&self) -> Option<f64> {
        Some(self.error.least_fraction)
    }

    fn summit(&self) -> [f64; 2] {
        self.error.places.summit
    }

    fn film_end(&self, end: ExtentEnd) -> Option<Bar> {
        let [begins, ends] = self.error.places.extent?;
        Some(match end {
            ExtentEnd::Begins => begins,
            ExtentEnd::Ends => ends,
        })
    }

    fn coefficients(&self) -> Option<CoefficientErrors> {
        self.errors_of_coefficients(|dynamics| Some(&dynamics.at.first()?.coefficients))
    }

    fn judged_coefficients(&self) -> Option<CoefficientErrors> {
        self.errors_of_coefficients(|dynamics| Some(&dynamics.judged.coefficients))
    }
}

impl CoarseComparison<'_> {
    /// Errors of coefficients that both films have.
    fn errors_of_coefficients(&self, of: impl Fn(&Dynamics) -> Option<&Coefficients>) -> Option<CoefficientErrors> {
        let film = of(self.measured.dynamics()?)?;
        let coarse = of(self.dynamics.as_ref()?)?;
        Some(CoefficientErrors::entry_by_entry(film, coarse, |difference| OF_TANGENTS * difference))
    }
}
