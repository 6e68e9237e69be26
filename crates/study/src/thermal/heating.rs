//! The film whose heat is balanced, as a search asks it.

use oilwedge_bearing::{Heated, ThermalBalance, ThermalFlows};
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::lubricant::Lubricant;

use super::flows::thermal_flows_of;
use crate::film::Film;
use crate::thermal_model::ThermalModel;

/// A film whose temperature is found beside its position.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Heating<'a> {
    film: &'a Film,
    model: ThermalModel,
}

impl<'a> Heating<'a> {
    /// A film whose one temperature a model closes.
    pub(crate) fn with(film: &'a Film, model: ThermalModel) -> Self {
        Self { film, model }
    }

    /// None of a film whose temperature is given, or has no effect.
    pub(crate) fn of(film: &'a Film) -> Option<Self> {
        Some(Self { film, model: film.model.sockets.thermal? })
    }
}

impl Heated for Heating<'_> {
    fn balance(&self) -> ThermalBalance {
        self.model.balance
    }

    fn lubricant(&self, temperature: f64) -> Lubricant {
        self.film.lubricant_at(temperature)
    }

    fn flows(&self, film: &SolvedFilm) -> ThermalFlows {
        thermal_flows_of(&self.model, film)
    }
}
