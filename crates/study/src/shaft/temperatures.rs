//! The temperatures of the films of a shaft, each by its own heat: found from run to run of the whole shaft.

use oilwedge_bearing::ThermalFlows;

use super::compile::{Compiled, CompiledBearing};
use crate::quantities::Quantity;
use crate::result::Status;
use crate::thermal::FilmTemperature;

/// Why there is no answer: status and reason.
pub(super) type NoShaftAnswer = (Status, String);

/// What a run has shown of a bearing: what heats and what cools its film, and its numbers.
pub(super) type BearingNumbers = (Option<ThermalFlows>, Vec<Quantity>);

/// The temperatures of the films of a shaft, by bearing; none of a film whose temperature is given.
pub(super) struct Temperatures(Vec<Option<FilmTemperature>>);

impl Temperatures {
    /// The temperatures of the bearings of a shaft before the first run.
    pub(super) fn of(compiled: &Compiled) -> Self {
        let of = |CompiledBearing { film, .. }: &CompiledBearing| {
            film.model.sockets.thermal.map(|model| FilmTemperature::of(film, model))
        };
        Self(compiled.bearings.iter().map(of).collect())
    }

    /// Whether all temperatures are given.
    pub(super) fn are_given(&self) -> bool {
        self.0.iter().all(Option::is_none)
    }

    /// The temperature of a bearing; none where it is given.
    pub(super) fn of_bearing(&self, number: usize) -> Option<&FilmTemperature> {
        self.0[number].as_ref()
    }

    /// Begins anew on other meshes.
    pub(super) fn begin_again(&mut self) {
        self.0.iter_mut().flatten().for_each(FilmTemperature::begun_again);
    }

    /// The shaft on films at these temperatures.
    pub(super) fn applied(&self, compiled: &Compiled) -> Compiled {
        compiled.with_films(|number, bearing| match &self.0[number] {
            Some(search) => bearing.film.at_temperature(search.temperature),
            None => bearing.film.clone(),
        })
    }

    /// Finds the temperatures at which no film leaves more than the part `accuracy` of its heat over, by a `run` of the
    /// shaft at one set of temperatures after the other; `is_over` tells that the time is.
    ///
    /// # Errors
    /// Status and reason where a run has no answer, or a film is too hot everywhere.
    pub(super) fn balance(
        &mut self,
        compiled: &Compiled,
        accuracy: f64,
        is_over: impl Fn() -> bool,
        mut run: impl FnMut(&Compiled) -> Result<Vec<BearingNumbers>, NoShaftAnswer>,
    ) -> Result<(), NoShaftAnswer> {
        while !self.are_given() {
            match run(&self.applied(compiled)) {
                Ok(shown) => match self.add(shown) < accuracy {
                    true => return Ok(()),
                    false => self.turn(&compiled.bearings)?,
                },
                Err(reason) if is_over() => return Err(reason),
                // Beyond these temperatures there may be no film.
                Err(reason) => {
                    let turned: Vec<bool> = self.0.iter_mut().flatten().map(FilmTemperature::retreat).collect();
                    if turned.contains(&false) {
                        return Err(reason);
                    }
                }
            }
        }
        Ok(())
    }

    /// Adds a run somewhat warmer, where those before do not show how numbers change with temperature.
    pub(super) fn show_slopes(
        &mut self,
        compiled: &Compiled,
        run: impl FnOnce(&Compiled) -> Result<Vec<BearingNumbers>, NoShaftAnswer>,
    ) {
        if self.0.iter().flatten().all(FilmTemperature::has_slopes) {
            return;
        }
        self.0.iter_mut().flatten().for_each(|search| search.step_aside(1.0));
        if let Ok(shown) = run(&self.applied(compiled)) {
            self.add(shown);
        }
        self.0.iter_mut().flatten().for_each(|search| search.step_aside(-1.0));
    }

    /// Adds what a run has shown; the greatest heat that is left over, as a part of the power [1].
    fn add(&mut self, shown: Vec<BearingNumbers>) -> f64 {
        let films = self.0.iter_mut().zip(shown);
        let left = films.map(|(search, (flows, quantities))| match search.as_mut().zip(flows) {
            Some((search, flows)) => search.add(flows, quantities),
            None => 0.0,
        });
        left.fold(0.0, f64::max)
    }

    /// Turns to the temperatures of the next run.
    fn turn(&mut self, bearings: &[CompiledBearing]) -> Result<(), NoShaftAnswer> {
        for (search, bearing) in self.0.iter_mut().zip(bearings) {
            if let Some(search) = search {
                let told = |reason| (Status::without(&reason), format!("bearing {}: {reason}", bearing.name));
                search.turn().map_err(told)?;
            }
        }
        Ok(())
    }
}
